#!/usr/bin/env bash
# sanitize.sh BUILD [all]: builds the preset sanitize and runs its tests with the address and
# undefined behaviour sanitizers; those that take more than a minute so only with "all". Writes
# the coverage of the library's code to BUILD/coverage.txt. Exit 1 where a sanitizer or a test
# complains, or less than 90 % of the lines are covered; 77 where there is no Clang or no gcovr.
set -euo pipefail
source=$(cd "$(dirname "$0")/.." && pwd)
build=$1
slow=' test_normal_evaluation test_plane_covariances test_normal_estimation_base '
[ "${2:-}" != all ] || slow=
for tool in clang++-14 llvm-cov-14 gcovr; do
  command -v $tool >/dev/null && continue
  echo "Skipped: needs $tool; scripts/install_dependencies.sh installs it."
  exit 77
done
cmake -S "$source" -B "$build" --preset sanitize >/dev/null
cmake --build "$build" | tail -n 1
build=$(cd "$build" && pwd)

find "$build" -name '*.gcda' -delete
rm -rf "$build/logs"
mkdir "$build/logs"
echo 'leak:libomp.so' >"$build/leaks_of_others"
export LSAN_OPTIONS=suppressions=$build/leaks_of_others:print_suppressions=0
export ASAN_OPTIONS=allocator_may_return_null=1 UBSAN_OPTIONS=print_stacktrace=1
# Where nothing may be written, the counters of coverage complain as well; allocations are counted
# in malloc, which is the sanitizer's here.
export GTEST_FILTER=-*NoBytesMayBeWritten*:*Allocations*
export PCL_RGBD_PLANES_SOAK_FRAMES=${PCL_RGBD_PLANES_SOAK_FRAMES:-200}
# Threads that wait must not take the time of those that work.
export OMP_WAIT_POLICY=passive LOGS=$build/logs
for test in "$build"/bin/test_*; do
  name=${test##*/}
  case $slow in
    *" $name "*) echo "left out: $name" >&2 ;;
    *) echo "$test" ;;
  esac
done | xargs -P 2 -I {} bash -c '
  start=$SECONDS log=$LOGS/$(basename {})
  {} --gtest_brief=1 >"$log" 2>&1 || { echo "{} fails:"; cat "$log"; exit 1; }
  echo "$(tail -n 1 "$log") $(basename {}) $((SECONDS - start)) s"'

cd "$build"
gcovr --root "$source" --gcov-executable 'llvm-cov-14 gcov' --filter "$source/features/" \
  --filter "$source/filters/" --filter "$source/segmentation/" --fail-under-line 90 features filters segmentation \
  >coverage.txt || { cat coverage.txt; exit 1; }
tail -n 3 coverage.txt
