#!/usr/bin/env bash
# slowest_test.sh: slowest.sh names what took longest, of this run alone, and shows each command once.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
printf '%s\n' '# ninja log v5' $'0\t9000\t1000000000000000000\told.o\tab' $'10\t2510\t2000000000000000000\tnew.o\tcd' \
  $'20\t520\t2000000000000000001\tb.o\tef' >"$folder/.ninja_log"
cat >"$folder/log" <<'TEXT'
  1/3 Test  #12: gen.lang/a case: of two ........   Passed    0.02 sec
  2/3 Test   #4: proofs.coq .....................***Failed    7.10 sec
  3/3 Test   #5: a long name that leaves no dots     Passed    1.00 sec
TEXT
expected="The slowest units of $folder, seconds:
     2.5 new.o
     0.5 b.o
The slowest tests, seconds:
     7.1 proofs.coq
     1.0 a long name that leaves no dots
     0.0 gen.lang/a case: of two"
found=$("$(dirname "$0")/slowest.sh" "$folder" 1500000000 "$folder/log")
diff <(echo "$expected") <(echo "$found")

# More lines than a pipe holds are no failure.
awk -v lines="$folder/log" 'BEGIN { for (i = 1; i <= 20000; ++i) {
  printf "10\t510\t2000000000000000000\ta_unit_with_a_long_name/%d.cpp.o\thash\n", i
  printf "  %d/20000 Test #%d: a.test.with.a.long.name.%d ....   Passed    0.50 sec\n", i, i, i >>lines
} }' >>"$folder/.ninja_log"
found=$("$(dirname "$0")/slowest.sh" "$folder" 1500000000 "$folder/log")
[ "$(wc -l <<<"$found")" -eq 22 ]
