#!/usr/bin/env bash
# run.sh SECONDS [BUILD]: builds the fuzzers and lets each of them look for crashes, hangs and
# broken promises for so long. Inputs that break something stay in BUILD/fuzz; exit 1 then, and
# 77 where there is no Clang. Starts from the small files in test/fuzz/corpus.
set -euo pipefail
seconds=$1
source=$(cd "$(dirname "$0")/../.." && pwd)
build=${2:-$source/build-sanitize}
if ! command -v clang++-14 >/dev/null; then
  echo "Skipped: the fuzzers need clang++-14; scripts/install_dependencies.sh installs it."
  exit 77
fi
cmake -S "$source" -B "$build" --preset sanitize >/dev/null
cmake --build "$build" --target fuzzers

export TMPDIR=$build/fuzz/scratch ASAN_OPTIONS=allocator_may_return_null=1
trap 'rm -rf "$TMPDIR"' EXIT
mkdir -p "$TMPDIR"
echo 'leak:OpenNI2/Drivers' >"$build/fuzz/leaks_of_others"
export LSAN_OPTIONS=suppressions=$build/fuzz/leaks_of_others:print_suppressions=0
export source build seconds
fuzz() {
  local log=$build/fuzz/$1.log result=0
  mkdir -p "$build/fuzz/$1"
  "$build/bin/fuzz_$1" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=4000 \
    -print_final_stats=1 -artifact_prefix="$build/fuzz/$1-" "$build/fuzz/$1" \
    "$source/test/fuzz/corpus/$1" >"$log" 2>&1 || { result=1; tail -n 40 "$log"; }
  sed -n "s/stat::number_of_executed_units:/$1: inputs tried:/p" "$log"
  return $result
}
export -f fuzz
printf '%s\n' classes depth_png inputs pcd truth | xargs -P 2 -I {} bash -c 'fuzz {}'
