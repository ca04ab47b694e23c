#!/usr/bin/env bash
# Segments a frame into planes and shows where the pictures are:
#   scripts/demo.sh                       a simulated table
#   scripts/demo.sh my.pcd                an organized point cloud
#   scripts/demo.sh INPUT [options]       whatever pcl_segment_planes takes
# Installs what is missing and builds first.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
if [ $# -eq 0 ]; then
  set -- sim:table_single
fi

echo "== Installing what is missing"
bash "$root/scripts/install_dependencies.sh"

echo "== Building (the first time takes a few minutes)"
cmake -S "$root" --preset release >"$root/build.log" 2>&1 ||
  { cat "$root/build.log" >&2; exit 1; }
cmake --build "$root/build" --target pcl_segment_planes
rm -f "$root/build.log"

output=$root/demo_output
echo "== Segmenting $1"
rm -rf "$output"
"$root/build/bin/pcl_segment_planes" "$@" --output "$output"

echo "== Pictures"
ls "$output"/*.png
