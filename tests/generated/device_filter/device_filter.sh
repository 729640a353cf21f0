#!/usr/bin/env bash
# device_filter.sh NVCC SOURCE: docs/examples/device/filter.cu compiles, and its filter needs fewer registers than hit(), and no
# stack, as docs/gpu.md says. Where there is a device the program runs.
set -euo pipefail
nvcc=$1 source=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$nvcc" -std=c++20 -arch=sm_80 --fmad=false -Xptxas -v -I"$source/runtime/kernel" -I"$source/generated/default" \
  "$source/docs/examples/device/filter.cu" -o "$work/filter" 2>"$work/log" || { cat "$work/log" && exit 1; }
awk '/Compiling entry function/ { name = $0; sub(/.*function .(_Z[0-9]+)?/, "", name); sub(/5lists.*/, "", name) }
     /Used [0-9]+ registers/ {
       match($0, /Used [0-9]+/)
       used[name] = substr($0, RSTART + 5, RLENGTH - 5) + 0
       if (match($0, /[0-9]+ bytes cumulative stack/))
         stack[name] = substr($0, RSTART, RLENGTH) + 0
     }
     END {
       for (name in used)
         if (name ~ /^(filter_pairs|decide_queued)$/)
           printf "%s: %d registers, %d bytes of stack\n", name, used[name], stack[name]
       exit !(used["filter_pairs"] > 0 && used["filter_pairs"] < used["decide_queued"] && stack["filter_pairs"] == 0)
     }' "$work/log"
status=0
"$work/filter" >"$work/said" || status=$?
cat "$work/said"
[ "$status" = 0 ] && grep -q '^1 pairs touch; ' "$work/said" || { [ "$status" = 3 ] && grep -q '^device: ' "$work/said"; }
