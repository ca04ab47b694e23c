#!/usr/bin/env bash
# Segments a frame into planes and shows where the pictures are:
#   scripts/demo.sh                       a simulated table
#   scripts/demo.sh my.pcd                an organized point cloud
#   scripts/demo.sh INPUT [options]       whatever pcl_segment_planes takes
# Installs what is missing and builds first.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd -P)
output=$root/demo_output
refuse() { echo "demo.sh: $1" >&2; exit 1; }
for argument; do
  case $argument in
    -h | --help)
      sed -n '2,6s/^# //p' "$0"
      exit ;;
    --version)
      sed -n 's/^project(\(pcl_rgbd_planes\) VERSION \([^ ]*\).*/\1 \2/p' "$root/CMakeLists.txt"
      exit ;;
    --ou*) refuse "$argument: results go to $output; leave it out, or run build/bin/pcl_segment_planes" ;;
  esac
  file=${argument#--*=}
  file=${file#live:}
  [ -e "$file" ] || continue
  case $(realpath -- "$file")/ in
    "$output"/* | "$root/build/demo_output"/*)
      refuse "$argument: is in a folder that this script replaces; move it elsewhere" ;;
  esac
done
if [ $# -eq 0 ]; then
  set -- sim:table_single
fi

echo "== Installing what is missing"
bash "$root/scripts/install_dependencies.sh"

echo "== Building (the first time takes a few minutes)"
# CMake refuses to change the generator of a build folder.
generator=$(sed -n 's/^CMAKE_GENERATOR:INTERNAL=//p' "$root/build/CMakeCache.txt" 2>/dev/null || true)
cmake -S "$root" --preset release ${generator:+-G "$generator"} >"$root/build.log" 2>&1 ||
  { cat "$root/build.log" >&2; exit 1; }
cmake --build "$root/build" --parallel "$(nproc)" --target pcl_segment_planes
rm -f "$root/build.log"

echo "== Segmenting $1"
rm -rf "$root/build/demo_output"
"$root/build/bin/pcl_segment_planes" "$@" --output "$root/build/demo_output"
rm -rf "$output"
mv "$root/build/demo_output" "$output"

echo "== Pictures"
ls "$output"/*.png
