#!/usr/bin/env bash
# Installs what the project needs to build and test, on Debian 12, 13 and their relatives.
set -euo pipefail

packages=(
  build-essential cmake ninja-build pkg-config git file
  libpcl-dev libeigen3-dev libflann-dev libboost-program-options-dev
  libopenmpi-dev # VTK's CMake files look for it
  libx11-dev xvfb xauth # the viewer's window, and a display for its tests and screenshots
  libembree-dev libhwy-dev nlohmann-json3-dev libpng-dev
  libgtest-dev libbenchmark-dev
  lld # links the tests in a third of the time
  clang-14 libclang-rt-14-dev libomp-14-dev zlib1g-dev # test/fuzz, test/sanitize.sh
  gcovr llvm-14 valgrind
  g++-aarch64-linux-gnu # test/arm64_kernels.sh
  clang-format-14 python3 doxygen gnuplot-nox
)

missing=()
for package in "${packages[@]}"; do
  dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' ||
    missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then
  echo "All packages are there."
  exit 0
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "Missing packages: ${missing[*]}. Run this script as root, or install sudo." >&2
    exit 1
  fi
  as_root=(sudo)
fi
if ! command -v apt-get >/dev/null; then
  echo "No apt-get here. Install what these Debian packages hold: ${missing[*]}" >&2
  exit 1
fi

echo "Installing ${missing[*]} ..."
export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" apt-get update -qq
available=()
for package in "${missing[@]}"; do
  if [[ $package =~ -14|aarch64 ]] && ! apt-cache show "$package" >/dev/null 2>&1; then
    echo "This release has no $package: what needs it is skipped."
  else
    available+=("$package")
  fi
done
[ ${#available[@]} -eq 0 ] ||
  "${as_root[@]}" apt-get install -y -qq --no-install-recommends "${available[@]}" >/dev/null
