#!/usr/bin/env bash
# sanitize.sh BUILD [all]: builds the preset sanitize and runs the tests of the library and of
# the applications' readers with the address and undefined behaviour sanitizers; with "all" those
# of the applications as well, and those that take more than a minute. Writes the coverage of the
# library's code to BUILD/coverage.txt. Exit 1 where a sanitizer or a test complains, or less than
# 90 % of the lines are covered; 77 where there is no Clang or no gcovr.
set -euo pipefail
source=$(cd "$(dirname "$0")/.." && pwd)
build=$1
for tool in clang++-14 llvm-cov-14 gcovr; do
  command -v $tool >/dev/null && continue
  echo "Skipped: needs $tool; scripts/install_dependencies.sh installs it."
  exit 77
done
cmake -S "$source" -B "$build" --preset sanitize >/dev/null
mapfile -t tests < <(cd "$source/test" && ls features/test_*.cpp filters/test_*.cpp \
  segmentation/test_*.cpp apps/test_{depth_image,frame_source,organized_pcd,point_labels}.cpp |
  grep -vE 'test_(normal_estimation_base|plane_covariances|tangent_normal_accuracy|two_run_normal)\.cpp' |
  sed 's|.*/||; s|\.cpp$||')
if [ "${2:-}" = all ]; then
  cmake --build "$build" | tail -n 1
  mapfile -t tests < <(cd "$build/bin" && ls -d test_*)
else
  # The build for common point types has no target for the tests of others.
  cmake --build "$build" --target help | sed 's/:.*//' | sort >"$build/targets"
  mapfile -t tests < <(printf '%s\n' "${tests[@]}" | sort | comm -12 - "$build/targets")
  cmake --build "$build" --target "${tests[@]}" | tail -n 1
fi
build=$(cd "$build" && pwd)

find "$build" -name '*.gcda' -delete
printf 'leak:libomp.so\nleak:OpenNI2/Drivers\n' >"$build/leaks_of_others"
export LSAN_OPTIONS=suppressions=$build/leaks_of_others:print_suppressions=0
export ASAN_OPTIONS=allocator_may_return_null=1 UBSAN_OPTIONS=print_stacktrace=1
# Where nothing may be written, the counters of coverage and Clang's OpenMP complain as well;
# allocations are counted in malloc, which is the sanitizer's here.
export GTEST_FILTER='-*NoBytesMayBeWritten*:SegmentObstacles.BadInputLeavesNothing:*Allocations*'
export PCL_RGBD_PLANES_SOAK_FRAMES=${PCL_RGBD_PLANES_SOAK_FRAMES:-200}
# Threads that wait must not take the time of those that work.
export OMP_WAIT_POLICY=passive
printf '%s\n' "${tests[@]}" | bash "$source/test/run_each.sh" "$build/bin" "$build/logs"

cd "$build"
gcovr --root "$source" --gcov-executable 'llvm-cov-14 gcov' --filter "$source/features/" \
  --filter "$source/filters/" --filter "$source/segmentation/" --fail-under-line 90 features filters segmentation \
  >coverage.txt || { cat coverage.txt; exit 1; }
tail -n 3 coverage.txt
