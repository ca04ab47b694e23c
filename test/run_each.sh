#!/usr/bin/env bash
# run_each.sh BIN LOGS [EMULATOR]: runs the test programs in the folder BIN whose names it reads,
# two at a time, and writes what each prints to LOGS. Exit not 0 where one fails.
set -euo pipefail
export BIN=$1 LOGS=$2 EMULATOR=${3:-}
rm -rf "$LOGS"
mkdir -p "$LOGS"
xargs -P 2 -I {} bash -c '
  start=$SECONDS log=$LOGS/{}
  $EMULATOR "$BIN/{}" --gtest_brief=1 >"$log" 2>&1 || { echo "{} fails:"; cat "$log"; exit 1; }
  echo "$(tail -n 1 "$log") {} $((SECONDS - start)) s"'
