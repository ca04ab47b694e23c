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
result=0
for fuzzer in classes depth_png inputs pcd; do
  mkdir -p "$build/fuzz/$fuzzer" "$TMPDIR"
  "$build/bin/fuzz_$fuzzer" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=4000 \
    -print_final_stats=1 -artifact_prefix="$build/fuzz/$fuzzer-" "$build/fuzz/$fuzzer" \
    "$source/test/fuzz/corpus/$fuzzer" >"$build/fuzz/$fuzzer.log" 2>&1 ||
    { result=1; tail -n 40 "$build/fuzz/$fuzzer.log"; }
  sed -n "s/stat::number_of_executed_units:/$fuzzer: inputs tried:/p" "$build/fuzz/$fuzzer.log"
done
exit $result
