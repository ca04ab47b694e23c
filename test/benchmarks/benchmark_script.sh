#!/usr/bin/env bash
# benchmark_script.sh BUILD: scripts/benchmark.sh fills the tables of a copy of doc/benchmarks.md
# and draws its plots; a page without one of its tables is refused, and stays as it is.
set -euo pipefail
export BUILD=$1
source=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "$1" >&2; exit 1; }

# The page with empty tables.
sed '/^<!-- table:/,/^<!-- end -->/{/^<!--/!d}' "$source/doc/benchmarks.md" >"$work/benchmarks.md"
cp "$work/benchmarks.md" "$work/empty.md"
"$source/scripts/benchmark.sh" --quick "$work"
for cell in '`normals/tangent/vga`' '`opencv_fals`' '`pcl_omps`' '| 160 x 120 |' '`two_run_pca`'; do
  grep -qF "$cell" "$work/benchmarks.md" || fail "no $cell in the tables"
done
grep -qF nan "$work/benchmarks.md" && fail "a figure of the tables is missing"
diff <(sed '/^<!-- table:/,/^<!-- end -->/{/^<!--/!d}' "$work/benchmarks.md") "$work/empty.md" ||
  fail "more than the tables has changed"
grep -o 'images/benchmark_[a-z_]*.png' "$work/empty.md" | while read -r plot; do
  tail -c 12 "$work/$plot" | grep -qa IEND || fail "$plot is no whole picture"
done

sed '/table: planes/d' "$work/empty.md" >"$work/benchmarks.md"
cp "$work/benchmarks.md" "$work/without.md"
message=$(python3 "$source/scripts/benchmark_report.py" "$BUILD/benchmark_results" "$work" 2>&1) &&
  fail "a page without a table was accepted"
[[ $message == *"table: planes"* ]] || fail "the message does not name the table: $message"
cmp "$work/benchmarks.md" "$work/without.md"
