#!/usr/bin/env bash
# check_diff.sh SOURCE: the diff in README.md must turn before.cpp of the tutorial into after.cpp.
set -euo pipefail
programs=$1/doc/tutorials/sources/moving_from_pcl
awk '$0 == "```diff" { inside = 1; next } /^```/ { inside = 0 } inside' "$1/README.md" |
  patch --quiet --fuzz=0 --output=- "$programs/before.cpp" | diff - "$programs/after.cpp"
