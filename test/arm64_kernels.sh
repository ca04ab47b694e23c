#!/usr/bin/env bash
# arm64_kernels.sh: compiles the files that are compiled once for each set of vector instructions
# for 64-bit ARM, of which the tests on other processors do not see anything. test/arm64.sh runs
# them. Exit 1 where one does not compile; 77 where there is no cross compiler.
set -euo pipefail
cd "$(dirname "$0")/.."
if ! command -v aarch64-linux-gnu-g++ >/dev/null; then
  echo "Skipped: needs aarch64-linux-gnu-g++; scripts/install_dependencies.sh installs it."
  exit 77
fi
# Headers that are the same for all processors, without those beside them that are not.
headers=$(mktemp -d)
trap 'rm -rf "$headers"' EXIT
ln -s "$(pkg-config --variable=includedir libhwy)/hwy" "$headers/hwy"
mapfile -t files < <(grep -l foreach_target.h */src/*.cpp)
read -ra options <<<"$(pkg-config --cflags-only-I pcl_common | sed 's/-I/-isystem /g')"
printf '%s\n' "${files[@]}" | xargs -P 2 -n 1 aarch64-linux-gnu-g++ -std=c++17 -O1 -S -o /dev/null \
  -I{features,filters,segmentation}/{include,src} \
  -isystem "$headers" "${options[@]}"
echo "${#files[@]} files compile for 64-bit ARM."
