#!/usr/bin/env bash
# arm64.sh [BUILD]: builds the library for 64-bit ARM with Debian's cross compiler, and runs its
# tests in emulation. Takes half an hour, and 5 GB in BUILD. Exit 1 where a test fails; 77 where it
# cannot be tried: needs the packages g++-aarch64-linux-gnu, mmdebstrap and qemu-user-static.
set -euo pipefail
source=$(cd "$(dirname "$0")/.." && pwd)
build=${1:-$source/build-arm64}
for tool in aarch64-linux-gnu-g++ mmdebstrap qemu-aarch64-static; do
  command -v $tool >/dev/null && continue
  echo "Skipped: needs $tool."
  exit 77
done
mkdir -p "$build"
build=$(cd "$build" && pwd)
root=$build/root
suite=$(. /etc/os-release && echo "$VERSION_CODENAME")

if ! [ -e "$root" ]; then
  packages=(libc6-dev libpcl-dev libopenmpi-dev libx11-dev libembree-dev libhwy-dev nlohmann-json3-dev
    libpng-dev libgtest-dev)
  mmdebstrap --quiet --variant=extract --arch=arm64 --include="${packages[*]}" "$suite" "$root.new"
  mv "$root.new" "$root"
fi

libraries=$root/usr/lib/aarch64-linux-gnu
export PKG_CONFIG_SYSROOT_DIR=$root PKG_CONFIG_LIBDIR=$libraries/pkgconfig:$root/usr/share/pkgconfig
export QEMU_LD_PREFIX=$root
cmake -S "$source" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=aarch64 -DCMAKE_SYSROOT="$root" \
  -DCMAKE_C_COMPILER=aarch64-linux-gnu-gcc -DCMAKE_CXX_COMPILER=aarch64-linux-gnu-g++ \
  -DCMAKE_LIBRARY_ARCHITECTURE=aarch64-linux-gnu -DCMAKE_FIND_ROOT_PATH="$root" \
  -DCMAKE_FIND_ROOT_PATH_MODE_PROGRAM=NEVER -DCMAKE_FIND_ROOT_PATH_MODE_LIBRARY=ONLY \
  -DCMAKE_FIND_ROOT_PATH_MODE_INCLUDE=ONLY -DCMAKE_FIND_ROOT_PATH_MODE_PACKAGE=ONLY \
  -DCMAKE_CROSSCOMPILING_EMULATOR=qemu-aarch64-static -DPCL_RGBD_PLANES_BUILD_BENCHMARKS=OFF \
  >"$build/configure.log" 2>&1 || { cat "$build/configure.log"; exit 1; }
# Applications cannot start others in emulation: their tests are left out.
mapfile -t tests < <(cd "$source/test" && ls {features,filters,segmentation}/test_*.cpp |
  sed 's|.*/||; s|\.cpp$||')
cmake --build "$build" --target "${tests[@]}" >"$build/build.log" 2>&1 ||
  { cat "$build/build.log"; exit 1; }

export OMP_WAIT_POLICY=passive PCL_RGBD_PLANES_SOAK_FRAMES=20
printf '%s\n' "${tests[@]}" |
  bash "$source/test/run_each.sh" "$build/bin" "$build/logs" qemu-aarch64-static
