#!/usr/bin/env bash
# older.sh OLDER NEWER MESH [REPETITIONS]: a mesh with itself on one thread, by plain fp32 of an older `meet` and by
# certified of a newer one, in turns. Prints the lower quartiles of the time of collide, and their ratio.
set -euo pipefail
older=$1 newer=$2 mesh=$3 repetitions=${4:-21}
collide() { "$1" collide "$mesh" "$mesh" --device cpu --threads 1 --precision "$2" --json | sed -n 's/.*"collide":\([0-9.e-]*\).*/\1/p'; }
pairs() { "$1" collide "$mesh" "$mesh" --device cpu --threads 1 --precision "$2" --json | sed -n 's/.*"pairs":\([0-9]*\),.*/\1/p'; }
quartile() { sort -g | sed -n "$((repetitions / 4 + 1))p"; }
for ((i = 0; i < repetitions; ++i)); do
  echo "$(collide "$older" fp32) $(collide "$newer" certified)"
done >"${TMPDIR:-/tmp}/older.$$"
trap 'rm -f "${TMPDIR:-/tmp}/older.$$"' EXIT
before=$(cut -d' ' -f1 "${TMPDIR:-/tmp}/older.$$" | quartile) after=$(cut -d' ' -f2 "${TMPDIR:-/tmp}/older.$$" | quartile)
awk -v x="$before" -v y="$after" -v p="$(pairs "$older" fp32)" -v q="$(pairs "$newer" certified)" -v n="$repetitions" 'BEGIN {
  printf "older, plain fp32: %.1f ms, %d pairs\nnewer, certified: %.1f ms, %d pairs\n", 1000 * x, p, 1000 * y, q
  printf "newer / older: %.2f, lower quartiles of %d runs in turns on one thread\n", y / x, n }'
