#!/usr/bin/env bash
# choices.sh FOLDER REPETITIONS MEET OTHER ...: the gain of a choice of the walk. MEET is the program, and each OTHER is one
# that was built with another choice. Segments at random collide with the first mesh of `meet demo` and with 20,000 balls, and
# the demo's meshes with each other, certified and on one thread, by all programs in turns. Prints the least seconds of collide
# of each OTHER, as multiples of MEET's. Scenes go to FOLDER; all programs must find the same pairs.
set -euo pipefail
folder=$1 repetitions=$2
shift 2
programs=("$@")
[ "${#programs[@]}" -gt 1 ] || { echo "usage: choices.sh FOLDER REPETITIONS MEET OTHER ..." >&2; exit 2; }
mkdir -p "$folder"
[ -s "$folder/animal.ply" ] || "${programs[0]}" demo -o "$folder" >/dev/null

# A ball of radius 0.01 about the first end of each segment.
balls() { awk -F, 'NR == 1 { print "x,y,z,r"; next } { print $1 "," $2 "," $3 ",0.01" }'; }

# segments COUNT LENGTH: rows of segments whose midpoints lie in [-1.5, 1.5]^3, of any direction. Numbers of a generator of
# Lehmer, which every awk has exactly.
segments() {
  awk -v n="$1" -v length_of="$2" '
    function next_number() { state = (state * 48271) % 2147483647; return state / 2147483647 }
    BEGIN {
      state = 1
      print "x0,y0,z0,x1,y1,z1"
      for (i = 0; i < n; ++i) {
        do {
          for (k = 0; k < 3; ++k) d[k] = 2 * next_number() - 1
          l = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2])
        } while (l > 1 || l < 0.01)
        for (k = 0; k < 3; ++k) {
          middle = 3 * next_number() - 1.5
          a[k] = middle - d[k] / l * length_of / 2
          b[k] = middle + d[k] / l * length_of / 2
        }
        printf "%.6f,%.6f,%.6f,%.6f,%.6f,%.6f\n", a[0], a[1], a[2], b[0], b[1], b[2]
      }
    }'
}

segments 20000 0.01 | balls >"$folder/balls.csv"
printf '%-34s' 'A x B'
for ((k = 1; k < ${#programs[@]}; ++k)); do printf ' %10s' "$(basename "${programs[k]}")"; done
echo

# row TEXT SET SET: one line of the table.
row() {
  local i k
  for ((i = 0; i < repetitions; ++i)); do
    for ((k = 0; k < ${#programs[@]}; ++k)); do
      "${programs[k]}" collide "$2" "$3" --device cpu --threads 1 --json |
        sed -n "s/.*\"pairs\":\([0-9]*\),.*\"collide\":\([0-9.e-]*\).*/$k \2 \1/p"
    done
  done | awk -v text="$1" '
    { if (!($1 in least) || $2 < least[$1]) least[$1] = $2; if (NR == 1) pairs = $3; if ($3 != pairs) wrong = 1 }
    END {
      if (wrong || !(0 in least) || least[0] == 0) { print text ": the programs differ" > "/dev/stderr"; exit 1 }
      printf "%-34s", text
      for (k = 1; k in least; ++k) printf " %10.2f", least[k] / least[0]
      print ""
    }'
}

row "animal x figure" "$folder/animal.ply" "$folder/figure.ply"
for length in 3 1 0.5 0.2 0.02; do
  for count in 2000 20000; do
    segments "$count" "$length" >"$folder/segments_${count}_$length.csv"
    row "$count of length $length x animal" "$folder/segments_${count}_$length.csv" "$folder/animal.ply"
  done
  row "balls x 2000 of length $length" "$folder/balls.csv" "$folder/segments_2000_$length.csv"
done
