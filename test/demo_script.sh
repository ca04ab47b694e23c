#!/usr/bin/env bash
# demo_script.sh: scripts/demo.sh puts pictures into demo_output, here with programs that only write
# down their arguments. It refuses to replace its input before anything is done.
set -euo pipefail
source=$(cd "$(dirname "$0")/.." && pwd)
work=$(cd "$(mktemp -d)" && pwd -P)
trap 'rm -rf "$work"' EXIT
fail() { echo "$1" >&2; exit 1; }

mkdir -p "$work/scripts" "$work/bin" "$work/build/bin"
cp "$source/scripts/demo.sh" "$work/scripts"
echo 'echo installed' >"$work/scripts/install_dependencies.sh"
echo '#!/bin/sh' >"$work/bin/cmake"
cat >"$work/build/bin/pcl_segment_planes" <<'END'
#!/bin/bash
output=${*: -1}
mkdir "$output"
echo "$*" >"$output/arguments.png"
END
chmod +x "$work/bin/cmake" "$work/build/bin/pcl_segment_planes"
export PATH=$work/bin:$PATH
cd "$work"
touch frame.pcd

# demo ARGUMENTS...: pcl_segment_planes gets them.
demo() {
  scripts/demo.sh "$@" >messages || fail "refused: $*"
  grep -qx installed messages || fail "nothing was installed"
  [[ $(cat demo_output/arguments.png) == "$* --output "* ]] || fail "not passed on: $*"
}
demo frame.pcd --objects
demo frame.pcd --json=result.json
scripts/demo.sh >/dev/null
grep -q '^sim:table_single ' demo_output/arguments.png || fail "no frame of its own"

# refuse REASON ARGUMENTS...
refuse() {
  local code=0 messages
  messages=$(scripts/demo.sh "${@:2}" 2>&1) || code=$?
  [ "$code" -eq 1 ] || fail "exit $code: ${*:2}"
  [[ $messages == "demo.sh: "*"$1"* && $messages != *$'\n'* ]] || fail "not one line with '$1': $messages"
  [ -f demo_output/frame.pcd ] || fail "the input is gone: ${*:2}"
}
cp frame.pcd demo_output
ln -s demo_output results
replaced="is in a folder that this script replaces"
refuse "demo_output: $replaced" demo_output
refuse "$replaced" demo_output/frame.pcd
refuse "$replaced" results/../demo_output/frame.pcd --objects
refuse "$replaced" frame.pcd --corrected "$work/results/frame.pcd"
refuse "$replaced" frame.pcd --corrected=demo_output/frame.pcd
refuse "--output: results go to $work/demo_output" frame.pcd --output elsewhere
refuse "--output=elsewhere: results go to" frame.pcd --output=elsewhere
