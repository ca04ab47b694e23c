#!/usr/bin/env bash
# benchmark_script.sh BUILD: scripts/benchmark.sh fills the tables of a copy of doc/benchmarks.md
# and draws its plots. What goes wrong is told in one line, and then page and plots stay as they are.
set -euo pipefail
export BUILD=$1
source=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
doc=$work/doc
trap 'rm -rf "$work"' EXIT
fail() { echo "$1" >&2; exit 1; }
mkdir "$doc"

# The page with empty tables.
sed '/^<!-- table:/,/^<!-- end -->/{/^<!--/!d}' "$source/doc/benchmarks.md" >"$doc/benchmarks.md"
cp "$doc/benchmarks.md" "$work/empty.md"
"$source/scripts/benchmark.sh" "$doc" --quick | tee "$work/progress"
grep -qx "Normals of 4 frames" "$work/progress" || fail "not quick"
# Methods as of OpenCV are there where it was when the programs were built.
mapfile -t methods < <(grep -ho '"method": *"[^"]*"' "$BUILD"/benchmark_results/*.json |
  sed 's/.*"\(.*\)"/`\1`/' | sort -u)
for cell in "${methods[@]}" '`normals/tangent/vga`' '`pcl_omps`' '| 160 x 120 |' '`two_run_pca`'; do
  grep -qF "$cell" "$doc/benchmarks.md" || fail "no $cell in the tables"
done
grep -qF nan "$doc/benchmarks.md" && fail "a figure of the tables is missing"
diff <(sed '/^<!-- table:/,/^<!-- end -->/{/^<!--/!d}' "$doc/benchmarks.md") "$work/empty.md" ||
  fail "more than the tables has changed"
grep -o 'images/benchmark_[a-z_]*.png' "$work/empty.md" | while read -r plot; do
  tail -c 12 "$doc/$plot" | grep -qa IEND || fail "$plot is no whole picture"
done

files() { (cd "$1" && find . -type f -exec cksum {} + | sort); }
# check_failure REASON EXIT_CODE MESSAGES DOC: one line that holds the reason, nothing has changed.
check_failure() {
  [ "$2" -eq 1 ] || fail "exit $2, not 1: $3"
  [[ $3 == *"$1"* && $3 != *$'\n'* ]] || fail "not one line with '$1': $3"
  [ "$(files "$4")" = "$before" ] || fail "after '$3', other files: $(files "$4")"
}
# refuse REASON COMMAND...
refuse() {
  local code=0 messages
  messages=$("${@:2}" 2>&1 >/dev/null) || code=$?
  check_failure "$1" "$code" "$messages" "$doc"
}
report=(python3 "$source/scripts/benchmark_report.py")
results=$work/build/benchmark_results
mkdir "$work/build"
cp -r "$BUILD/benchmark_results" "$results"
ln -s "$(cd "$BUILD" && pwd)/bin" "$work/build/bin"

sed -i '/table: planes/d' "$doc/benchmarks.md"
before=$(files "$doc")
refuse "table: planes" "${report[@]}" "$results" "$doc"
cp "$work/empty.md" "$doc/benchmarks.md"
before=$(files "$doc")
head -c 1000 "$results/normals.json" >"$work/half"
mv "$work/half" "$results/normals.json"
refuse "normals.json: damaged" "${report[@]}" "$results" "$doc"
rm "$results/normals.json"
refuse "normals.json" "${report[@]}" "$results" "$doc"

export BUILD=$work/build
rm "$results/speed.json"
mkdir "$results/speed.json"
refuse "speed.json: is there and no regular file" "$source/scripts/benchmark.sh" --quick "$doc"
rmdir "$results/speed.json"
refuse "nowhere: has no benchmarks.md" "$source/scripts/benchmark.sh" "$work/nowhere"
refuse "only one DOC" "$source/scripts/benchmark.sh" "$doc" --quick "$work/nowhere"
refuse "--fast: is no option" "$source/scripts/benchmark.sh" "$doc" --fast
refuse "--quick: its figures are no good for doc" "$source/scripts/benchmark.sh" --quick
[[ $("$source/scripts/benchmark.sh" --help) == "benchmark.sh [--quick] [DOC]: "* ]] || fail "no help"

# Ctrl-C goes to all processes of the script.
set -m
"$source/scripts/benchmark.sh" --quick "$doc" >/dev/null 2>"$work/messages" &
until ls "$results"/.speed.json.* >/dev/null 2>&1; do kill -0 $!; done
kill -INT -- -$!
code=0
wait $! || code=$?
set +m
check_failure "interrupted; tables and plots stay as they were" "$code" "$(cat "$work/messages")" "$doc"
[ -z "$(find "$results" -name "*speed*")" ] || fail "half a result is left"

# A disk that has room for the page, not for the plots.
export results=$1/benchmark_results source doc
if unshare -rm mount -t tmpfs none /mnt 2>/dev/null; then
  mkdir "$doc/disk"
  unshare -rm bash -c '
    mount -t tmpfs -o size=100k none "$doc/disk"
    cp "$doc/benchmarks.md" "$doc/disk"
    mkdir "$doc/disk/images"
    code=0
    python3 "$source/scripts/benchmark_report.py" "$results" "$doc/disk" || code=$?
    cd "$doc/disk"
    find . -type f -exec cksum {} +
    exit $code' >"$work/left" 2>"$work/messages" && fail "a full disk was not seen"
  grep -q "benchmark_.*png: gnuplot cannot write it" "$work/messages" || fail "$(cat "$work/messages")"
  diff "$work/left" <(cd "$doc" && cksum ./benchmarks.md) || fail "not as before on a full disk"
fi
