#!/usr/bin/env bash
# fma_calls.sh OBJDUMP LIBRARY: in code for a processor without a fused multiply-add, only plain rungs call fma(), and
# nothing certified or exact does. Plain rungs do call it, so the search is known to find calls.
set -euo pipefail
objdump=$1 library=$2
callers=$("$objdump" -drC --no-show-raw-insn "$library" | awk '
  /^[0-9a-f]+ <.*>:$/ { name = $0; sub(/^[0-9a-f]+ </, "", name); sub(/>:$/, "", name) }
  /R_(X86_64|386|AARCH64)_[A-Z0-9_]+[ \t]+fmaf?([-+@]|$)/ { print name }' | sort -u)
[ -n "$callers" ] || {
  echo "FAILED: no call of fma() was found, not even in a plain rung"
  exit 1
}
# Plain rungs, what they store, and what compares them.
others=$(grep -vE 'plain|store_(each<meetc::store_)?[ab]<[^<>]*, float>|look_at_library_fma|library_fma_rounds_once' \
  <<<"$callers") || true
[ -z "$others" ] || {
  echo "FAILED: these call fma():"
  echo "$others"
  exit 1
}
echo "$(wc -l <<<"$callers") functions call fma(), all of plain rungs"
