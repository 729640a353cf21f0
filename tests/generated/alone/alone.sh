#!/usr/bin/env bash
# alone.sh COMPILER SOURCE [OPTION ...]: a program that includes NAMESPACE/alone/NAME.hpp answers as one that includes
# NAMESPACE/header_only.hpp, and both need no library. It prints what compiling each takes of the processor's time.
set -euo pipefail
compiler=$1 source=$2
shift 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
TIMEFORMAT=%U
build() {
  { time "$compiler" -std=c++20 "${@:2}" -I"$source/runtime/kernel" -I"$source/generated/default" \
    -x c++ "$source/tests/generated/alone/answers.cpp" -o "$work/$1"; } 2>"$work/$1.log" || { cat "$work/$1.log" && exit 1; }
  "$work/$1" >"$work/$1.txt"
}
build alone -DALONE "${@:--O2}"
build whole "${@:--O2}"
cmp "$work/alone.txt" "$work/whole.txt"
tail -n 1 "$work/alone.txt"
if grep -q '^0 of' "$work/alone.txt"; then
  echo "no pair is unsure in fp32: nothing was compared behind it"
  exit 1
fi
awk -v a="$(tail -n 1 "$work/alone.log")" -v w="$(tail -n 1 "$work/whole.log")" \
  'BEGIN { printf "compiled in %.2f of the time of header_only.hpp (%.1f s of %.1f s)\n", a / w, a, w }'
