#!/usr/bin/env bash
# attempts.sh RUNS MEET OTHER: the hard families of pairs, decided by two programs in turns. MEET is the program, and OTHER one
# that was built otherwise. Prints, for each family, the least nanoseconds of a pair of OTHER as multiples of MEET's, for
# certified and for exact, on the best instruction set.
set -euo pipefail
runs=$1 meet=$2 other=$3
for ((i = 0; i < runs; ++i)); do
  for program in "$meet" "$other"; do
    "$program" bench cpu --only families --repetitions 5 --json |
      grep -o '"instruction_set":"[a-z0-9]*","family":"[^"]*","hits":[0-9]*,"certified_ns":[0-9.e+-]*,"exact_ns":[0-9.e+-]*' |
      sed "s/\"instruction_set\":\"\([^\"]*\)\",\"family\":\"\([^\"]*\)\",\"hits\":\([0-9]*\),\"certified_ns\":\([^,]*\),\"exact_ns\":\(.*\)/$([ "$program" = "$meet" ] && echo 0 || echo 1)|\1|\2|\3|\4|\5/"
  done
done | awk -F'|' '
  { last = $2
    id = $1 "|" $2 "|" $3
    if (!(id in c) || $5 < c[id]) c[id] = $5
    if (!(id in e) || $6 < e[id]) e[id] = $6
    if (!(($2, $3) in hits)) { hits[$2, $3] = $4; order[++n] = $3; set[n] = $2 }
    if (hits[$2, $3] != $4) { print $3 ": the programs differ" > "/dev/stderr"; failed = 1; exit 1 } }
  END {
    if (failed || n == 0) exit 1
    printf "%-40s %10s %10s\n", "triangles, " last, "certified", "exact"
    for (i = 1; i <= n; ++i)
      if (set[i] == last) {
        a = "0|" last "|" order[i]; b = "1|" last "|" order[i]
        printf "%-40s %10.2f %10.2f\n", order[i], c[b] / c[a], e[b] / e[a]
      }
  }'
