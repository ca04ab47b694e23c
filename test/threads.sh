#!/usr/bin/env bash
# threads.sh [BUILD]: builds the preset threads and runs the tests of what has threads, which is
# the normals and the grabber of the applications, with the thread sanitizer. Exit 1 after a
# race; 77 where there is no Clang.
set -euo pipefail
source=$(cd "$(dirname "$0")/.." && pwd)
build=${1:-$source/build-threads}
archer=/usr/lib/llvm-14/lib/libarcher.so # tells the sanitizer what OpenMP waits for
if ! command -v clang++-14 >/dev/null || ! [ -e $archer ]; then
  echo "Skipped: needs clang++-14 and libomp-14-dev; scripts/install_dependencies.sh installs them."
  exit 77
fi
tests=(test_normal_estimation_base test_tangent_normal_interface test_two_run_normal_interface
  test_frame_grabber)
cmake -S "$source" -B "$build" --preset threads >/dev/null
build=$(cd "$build" && pwd)
echo 'mutex:libOpenNI2.so' >"$build/races_of_others"
export OMP_TOOL_LIBRARIES=$archer OMP_WAIT_POLICY=passive OMP_NUM_THREADS=4
export TSAN_OPTIONS="ignore_noninstrumented_modules=1 halt_on_error=1 suppressions=$build/races_of_others"
cmake --build "$build" --target "${tests[@]}" | tail -n 1 # which also lists their tests
for test in "${tests[@]}"; do
  "$build/bin/$test" --gtest_brief=1 >"$build/$test.log" 2>&1 ||
    { echo "$test fails:"; cat "$build/$test.log"; exit 1; }
  echo "$test: $(tail -n 1 "$build/$test.log")"
done
