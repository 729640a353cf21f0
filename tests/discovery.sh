#!/usr/bin/env bash
# discovery.sh CTEST BUILD NAME=PROGRAM...: each case of each PROGRAM is exactly one CTest test "NAME/CASE", and there
# are no others. Programs that are not built are skipped. First, the script must itself notice a case that discovery drops.
set -euo pipefail
ctest=$1 build=$2
shift 2

# differences LISTED REGISTERED: the names that are in only one of them.
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
  # Version 2 exits with the number of cases; version 3 has another option.
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
