#!/usr/bin/env bash
# show.sh MEETC [--check]: refreshes every excerpt that the README and the pages of docs/ show, or names the old ones.
#
# A fenced block is an excerpt if it directly follows one of the first two lines, or begins with the third:
#
#   <!-- docs/examples/tiny.toml -->         the text of that file
#   <!-- meetc show SCENE KERNEL -->         what this command prints, run from the top of the source tree
#   $ meetc show SCENE KERNEL | sed -n 1p    the same, with the command visible to the reader
#
# Commands begin with meetc or grep and read all of their input. With --check nothing is written, and the exit code is 1
# if a block differs from what it should show.
set -euo pipefail
meetc_program=$(realpath "$1") mode=${2:-}
cd "$(dirname "$0")/.."
meetc() { "$meetc_program" "$@"; }

old=0 count=0
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for page in README.md docs/*.md; do
  cp "$page" "$work/page"
  while IFS= read -r mark; do
    count=$((count + 1))
    source=${mark#<!-- } source=${source% -->} source=${source#\$ }
    if [[ $source =~ ^(meetc|grep)\  ]]; then
      eval "$source" >"$work/text" </dev/null || { echo "$page: this command fails: $source" >&2; exit 1; }
    else
      cat "$source" >"$work/text"
    fi
    [ -s "$work/text" ] || { echo "$page: this shows nothing: $source" >&2; exit 1; }
    MARK=$mark awk -v file="$work/text" '
      function text(  line) { while ((getline line < file) > 0) print line; drop = done = 1 }
      drop && /^```/ { drop = 0 }
      drop { next }
      { print }
      !done && wait && /^```/ { text() }
      { wait = $0 == ENVIRON["MARK"] && /^<!--/ }
      !done && $0 == ENVIRON["MARK"] && /^[$]/ { text() }' "$work/page" >"$work/new"
    if ! cmp -s "$work/page" "$work/new"; then
      echo "$page: not what this gives: $source"
      diff "$work/page" "$work/new" | sed -n 1,20p || true
      old=1
      mv "$work/new" "$work/page"
    fi
  done < <(awk '
    /^```/ { fence = !fence; if (fence && mark != "") print mark; first = fence && mark == ""; mark = ""; next }
    { mark = "" }
    first && /^[$] (meetc|grep) / { print }
    { first = 0 }
    !fence && /^<!-- ((meetc|grep) .*|docs\/[^ ]*) -->$/ { mark = $0 }' "$page")
  [ "$mode" = --check ] || cmp -s "$page" "$work/page" || cp "$work/page" "$page"
done
echo "$count excerpts"
[ "$mode" != --check ] || exit $old
