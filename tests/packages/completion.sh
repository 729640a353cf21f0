#!/usr/bin/env bash
# completion.sh MEET MEETC: what bash completes for lines of both programs.
set -euo pipefail
source "$(dirname "$0")/../../gen/cmake/completion.bash"
PATH=$(realpath "$(dirname "$1")"):$(realpath "$(dirname "$2")"):$PATH
failed=0
# expect "WORDS" LINE...: the completions of the last word of the line, sorted.
expect() {
  local want=$1 have
  shift
  COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)) COMPREPLY=()
  _meetc_complete
  have=$(printf '%s\n' "${COMPREPLY[@]}" | LC_ALL=C sort | paste -sd ' ')
  if [ "$have" != "$want" ]; then
    echo "'$*' is completed to '$have', not to '$want'"
    failed=1
  fi
}
cd "$(mktemp -d)"
touch arm.ply 'a tool.ply'
expect "collide" meet c
expect "inspect" meet ins
expect "generate" meetc gen
expect "--self" meet collide --se
expect "--pairs --poses --precision --predicate" meet collide --p
expect "auto cpu cuda" meet collide --device ""
expect "fp64 fp64x2" meet collide --precision fp6
expect "arm.ply" meet collide ar
expect "a tool.ply arm.ply" meet collide arm.ply a
expect "arm.ply" meet collide --pairs arm
expect "--version" meet --v
expect "" meet nothing --x
expect "" meetc gen --x
exit $failed
