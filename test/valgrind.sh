#!/usr/bin/env bash
# valgrind.sh BIN: runs the applications in the folder BIN under Valgrind's Memcheck, on simulated
# and on stored frames and on a damaged one. Exit 1 after the first use of memory that is not
# theirs, or not initialised, and after memory that is lost; 77 where there is no Valgrind.
set -euo pipefail
bin=$(cd "$1" && pwd)
if ! command -v valgrind >/dev/null; then
  echo "Skipped: needs valgrind; scripts/install_dependencies.sh installs it."
  exit 77
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
runs=0
preload=
if ! grep -qw rdtscp /proc/cpuinfo; then
  # Valgrind tells programs that there is rdtscp on processors without, and stops at it. Highway
  # measures its clock with that while it is loaded; nothing here needs the measurement.
  echo 'namespace hwy { namespace platform { unsigned long TimerResolution() { return 1; } } }' >clock.cpp
  "${CXX:-c++}" -shared -fPIC clock.cpp -o clock.so
  preload=$work/clock.so
fi

# check EXIT_CODE APPLICATION ARGUMENTS...
check() {
  local code=0
  LD_PRELOAD=$preload valgrind --quiet --error-exitcode=99 --leak-check=full --errors-for-leak-kinds=definite \
    "$bin/$2" "${@:3}" >log 2>&1 || code=$?
  [ "$code" -eq "$1" ] || { echo "$* exits with $code:"; cat log; exit 1; }
  runs=$((runs + 1))
}

check 0 pcl_simulate_rgbd floor_obstacles --resolution qqvga --output frames
frame=frames/floor_obstacles_1_kinect_qqvga.pcd
head -c 10000 "$frame" >half.pcd
check 0 pcl_segment_planes "$frame" --objects --obstacles --output out --json out.json
check 0 pcl_segment_planes sim:table_single --resolution qqvga --objects --obstacles
check 1 pcl_segment_planes half.pcd --output out2
check 0 pcl_evaluate_planes sim:table_single --resolution qqvga --json planes.json
check 0 pcl_evaluate_detection sim:table_single --resolution qqvga --json detection.json
check 0 pcl_measure_depth_noise "$frame" --json noise.json
check 0 pcl_evaluate_normals "$frame" --json normals.json --resolution vga
echo "$runs runs of the applications without an error of memory."
