#!/usr/bin/env bash
# every_function.sh ENTRIES [--pointers] [--also NAMES] HEADER ...: fails unless ENTRIES, a source with a table of `{"NAME",
# call}`, names each function that the headers declare and no other, so that none is forgotten. --pointers: the members that
# point to functions instead. --also: names that declared.awk does not read there, with commas.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
entries=$1
shift
also="" pointers=0
while [[ ${1:-} == --* ]]; do
  case $1 in
  --also)
    also=$2
    shift
    ;;
  --pointers) pointers=1 ;;
  *)
    echo "every_function.sh: unknown: $1" >&2
    exit 2
    ;;
  esac
  shift
done
declared() {
  {
    for header in "$@"; do awk -v pointers="$pointers" -f "$here/declared.awk" "$header"; done
    tr ',' '\n' <<<"$also"
  } | sed '/^$/d' | LC_ALL=C sort -u
}
listed() { sed -n 's/^ *{"\([A-Za-z_0-9:]*\)", [a-z_]*},$/\1/p' "$entries" | LC_ALL=C sort -u; }
count=$(declared "$@" | wc -l)
((count > 0)) || {
  echo "no function was read"
  exit 1
}
if ! difference=$(diff <(declared "$@") <(listed)); then
  echo "'<' is declared and called by no test under other control words; '>' is called and not declared:"
  grep '^[<>]' <<<"$difference"
  exit 1
fi
echo "all of $count functions are called"
