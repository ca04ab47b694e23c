#!/usr/bin/env bash
# packages.sh BUILD: makes the Debian packages of a build, installs them, runs the application
# and a program built with the library, removes them, and looks for what stays. Exit 77 where
# that cannot be tried: not root, or no dpkg.
set -euo pipefail
build=$(cd "$1" && pwd)
source=$(cd "$(dirname "$0")/.." && pwd)
if [ "$(id -u)" -ne 0 ] || ! command -v dpkg-shlibdeps >/dev/null; then
  echo "Skipped: needs root and dpkg-shlibdeps (Debian's dpkg-dev) to install packages."
  exit 77
fi
work=$(mktemp -d)
names=()
cleanup() {
  [ ${#names[@]} -eq 0 ] || dpkg --purge "${names[@]}" >/dev/null 2>&1 || true
  rm -rf "$work"
}
trap cleanup EXIT

(cd "$work" && cpack --config "$build/CPackConfig.cmake" -B "$work" >"$work/log") ||
  { cat "$work/log"; exit 1; }
packages=("$work"/*.deb)
[ ${#packages[@]} -eq 3 ]
for package in "${packages[@]}"; do
  name=$(dpkg-deb -f "$package" Package)
  names+=("$name")
  echo "$name depends on: $(dpkg-deb -f "$package" Depends)"
done

dpkg -i "${packages[@]}" >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
cd /
/usr/bin/pcl_segment_planes sim:table_single --resolution qqvga --output "$work/out" >/dev/null
[ -s "$work/out/result.json" ]
pkg-config --exists pcl_rgbd_planes
cmp "$source/LICENSE" /usr/share/doc/pcl_rgbd_planes/LICENSE
grep -o '](doc/[^)#]*' "$source/README.md" | cut -c 3- |
  (cd /usr/share/doc/pcl_rgbd_planes && xargs ls >/dev/null)
for block in cmake:CMakeLists.txt cpp:planes.cpp; do # of README.md, the first of each
  sed -n "/^\`\`\`${block%%:*}$/,/^\`\`\`$/{/^\`\`\`/!p;/^\`\`\`$/q}" "$source/README.md" \
    >"$work/${block#*:}"
done
cmake -S "$work" -B "$work/consumer" >"$work/log" 2>&1 && cmake --build "$work/consumer" \
  >>"$work/log" 2>&1 || { cat "$work/log"; exit 1; }

mapfile -t files < <(for name in "${names[@]}"; do dpkg -L "$name"; done |
  while read -r file; do [ -d "$file" ] || echo "$file"; done)
dpkg --purge "${names[@]}" >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
for file in "${files[@]}"; do
  [ ! -e "$file" ] || { echo "$file stays after the packages were removed"; exit 1; }
done
echo "${#packages[@]} packages with ${#files[@]} files installed, ran and went."
