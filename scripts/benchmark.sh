#!/usr/bin/env bash
# benchmark.sh [--quick] [DOC]: runs the benchmarks and the evaluations on simulated frames, and
# renews the tables of DOC/benchmarks.md and the plots in DOC/images; DOC is doc by default. Takes
# minutes on an idle machine. --quick takes one and is only good to try the script: DOC must be
# given. BUILD is the folder with the programs, build by default.
set -euo pipefail
refuse() { echo "$1" >&2; exit 1; }
quick=
doc=
for argument; do
  case $argument in
    -h | --help)
      sed -n '2,5s/^# //p' "$0"
      exit ;;
    --quick) quick=yes ;;
    -*) refuse "$argument: is no option; see --help" ;;
    *)
      [ -z "$doc" ] || refuse "$argument: only one DOC may be given; see --help"
      doc=$argument ;;
  esac
done
[ -z "$quick" ] || [ -n "$doc" ] ||
  refuse "--quick: its figures are no good for doc; give a DOC, a copy of it"
cd "$(dirname "$0")/.."
doc=${doc:-doc}
build=${BUILD:-build}
seeds=10
options=(--benchmark_repetitions=5 --benchmark_enable_random_interleaving=true)
if [ -n "$quick" ]; then
  seeds=1
  options=(--benchmark_repetitions=2 --benchmark_min_time=0.01 --benchmark_filter=-lccp)
fi
for tool in gnuplot python3; do
  command -v "$tool" >/dev/null || refuse "$tool is missing: run scripts/install_dependencies.sh"
done
[ -f "$doc/benchmarks.md" ] || refuse "$doc: has no benchmarks.md"
for program in pcl_rgbd_planes_benchmark pcl_evaluate_normals pcl_evaluate_planes; do
  [ -x "$build/bin/$program" ] ||
    refuse "$build/bin/$program is missing: cmake --preset release && cmake --build build"
done

frames=()
for scene in table_single table_cluttered room corridor; do
  for seed in $(seq "$seeds"); do
    frames+=("sim:$scene:$seed")
  done
done
results=$build/benchmark_results
mkdir -p "$results" "$doc/images"
trap 'echo "interrupted; tables and plots stay as they were" >&2; exit 1' INT TERM
# Programs run silently; the last line of one that fails says why.
run() {
  local messages
  messages=$("$@" 2>&1 >/dev/null) || refuse "${messages##*$'\n'}"
}
echo "Benchmarks"
run "$build/bin/pcl_rgbd_planes_benchmark" "${options[@]}" --benchmark_report_aggregates_only=true \
  --benchmark_out="$results/speed.json"
echo "Normals of ${#frames[@]} frames"
run "$build/bin/pcl_evaluate_normals" "${frames[@]}" --json "$results/normals.json"
echo "Planes of ${#frames[@]} frames"
run "$build/bin/pcl_evaluate_planes" "${frames[@]}" --json "$results/planes.json"
trap - INT # the report tells it itself
python3 scripts/benchmark_report.py "$results" "$doc"
