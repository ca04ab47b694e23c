#!/usr/bin/env bash
# test.sh [--thorough]: installs what is missing, checks the format, builds with warnings as errors,
# runs the tests; with --thorough also those with sanitizers, fuzzers and Valgrind, and in a project
# that adds this one as a subdirectory: they take longer than all others.
# Recordings are taken from the folder PCL_RGBD_PLANES_DATA, or ../shared/data where it exists.
set -euo pipefail
case $* in
  "") tests=(--label-exclude thorough) ;;
  --thorough) tests=() ;;
  *) echo "usage: $0 [--thorough]" >&2; exit 2 ;;
esac
cd "$(dirname "$0")/.."

echo "== Installing what is missing"
bash scripts/install_dependencies.sh

echo "== Checking the format"
if command -v clang-format-14 >/dev/null; then
  git ls-files -z '*.h' '*.hpp' '*.cpp' | xargs -0 clang-format-14 --dry-run -Werror
else
  echo "Skipped: there is no clang-format-14."
fi

echo "== Building"
data=${PCL_RGBD_PLANES_DATA:-}
if [ -z "$data" ] && [ -d ../shared/data ]; then
  data=$(cd ../shared/data && pwd)
fi
echo "Recordings: ${data:-none, the tests that need them are skipped}"
cmake --preset ci -DPCL_RGBD_PLANES_DATA="$data"
cmake --build build-ci

echo "== Testing"
ctest --test-dir build-ci --output-on-failure --parallel 2 "${tests[@]}"
if [ "$*" = --thorough ] && [ -e build-ci/sanitize/coverage.txt ]; then
  echo "== Coverage of the library's code by the tests"
  cat build-ci/sanitize/coverage.txt
fi
