#!/usr/bin/env bash
# older.sh OLDER NEWER MESH [REPETITIONS]: a mesh with itself on one thread, by plain fp32 of an older `meet` and by
# certified of a newer one, in turns. Prints the lower quartiles of the time of collide, and their ratio.
set -euo pipefail
older=$1 newer=$2 mesh=$3 repetitions=${4:-21}
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
# The seconds and the pairs of one run.
collide() {
  local answer found
  answer=$("$1" collide "$mesh" "$mesh" --device cpu --threads 1 --precision "$2" --json)
  found=$(sed -n 's/.*"pairs":\([0-9]*\),.*"collide":\([0-9.e-]*\).*/\2 \1/p' <<<"$answer")
  [ -n "$found" ] || { echo "$1: no pairs and times in its answer" >&2; return 1; }
  echo "$found"
}
for ((i = 0; i < repetitions; ++i)); do
  collide "$older" fp32 >>"$room/older"
  collide "$newer" certified >>"$room/newer"
done
quartile() { sort -g "$1" | sed -n "$((repetitions / 4 + 1))p"; }
quartile "$room/older" >"$room/table"
quartile "$room/newer" >>"$room/table"
awk -v n="$repetitions" '
  { seconds[NR] = $1; pairs[NR] = $2 }
  END {
    printf "older, plain fp32: %.1f ms, %d pairs\n", 1000 * seconds[1], pairs[1]
    printf "newer, certified: %.1f ms, %d pairs\n", 1000 * seconds[2], pairs[2]
    printf "newer / older: %.2f, lower quartiles of %d runs in turns on one thread\n", seconds[2] / seconds[1], n
  }' "$room/table"
