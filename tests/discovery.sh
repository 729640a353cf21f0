#!/usr/bin/env bash
# discovery.sh CTEST BUILD NAME=PROGRAM...: each case of each PROGRAM is a test "NAME/CASE" of CTest, once, and no other
# is. Programs that are not built are passed over. Before that, a name that discovery drops must be noticed here.
set -euo pipefail
ctest=$1 build=$2
shift 2

# differences LISTED REGISTERED: what is in one alone.
differences() { diff <(sort <<<"$1") <(sort <<<"$2"); }

if differences $'a: one\na: two; three' $'a: one\na: two' >/dev/null; then
  echo "a lost case would not be noticed"
  exit 1
fi

registered=$("$ctest" --test-dir "$build" -N | sed -nE 's/^ *Test +#[0-9]+: (.*)$/\1/p')
failed=0 total=0
for each in "$@"; do
  name=${each%%=*} program=${each#*=}
  [ -x "$program" ] || continue
  # Version 2 ends with the number of cases for its code; version 3 has another option.
  if [[ $("$program" --help) == *--list-test-names-only* ]]; then
    listed=$("$program" --list-test-names-only || true)
  else
    listed=$("$program" --list-tests --verbosity quiet)
  fi
  listed=$(sed "s|^|$name/|" <<<"$listed")
  differences "$listed" "$(grep -F "$name/" <<<"$registered" | awk -v p="$name/" 'index($0, p) == 1')" || {
    echo "FAILED: the cases of $program are not those that CTest knows"
    failed=1
  }
  total=$((total + $(wc -l <<<"$listed")))
done
[ "$total" -gt 0 ] || {
  echo "FAILED: no program of cases is built"
  exit 1
}
echo "$total cases"
exit $failed
