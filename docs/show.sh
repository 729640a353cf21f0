#!/usr/bin/env bash
# show.sh MEETC [--check]: refreshes every excerpt that the README and the pages of docs/ show, or says which is old.
#
# A fenced block that follows one of these comment lines at once is an excerpt:
#
#   <!-- docs/examples/tiny.toml -->             the text of that file
#   <!-- meetc show SCENE KERNEL | head -3 -->   what this command prints, run from the top of the source tree
#
# With --check nothing is written; the exit code is 1 where a block differs from what it should show.
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
    if [[ $mark == meetc\ * ]]; then
      eval "$mark" >"$work/text" || { echo "$page: this command fails: $mark" >&2; exit 1; }
    else
      cat "$mark" >"$work/text"
    fi
    [ -s "$work/text" ] || { echo "$page: this shows nothing: $mark" >&2; exit 1; }
    MARK="<!-- $mark -->" awk -v file="$work/text" '
      $0 == ENVIRON["MARK"] && !done { print; wait = 1; next }
      wait && /^```/ { print; wait = 0; inside = 1
        while ((getline line < file) > 0) print line
        next }
      inside && /^```/ { inside = 0; done = 1 }
      !inside { wait = 0; print }' "$work/page" >"$work/new"
    if ! cmp -s "$work/page" "$work/new"; then
      echo "$page: not what this gives: $mark"
      diff "$work/page" "$work/new" | head -20 || true
      old=1
      mv "$work/new" "$work/page"
    fi
  done < <(awk '/^```/ && mark != "" { print mark } { mark = "" }
    /^<!-- (meetc .*|docs\/[^ ]*) -->$/ { mark = substr($0, 6, length($0) - 9) }' "$page")
  [ "$mode" = --check ] || cmp -s "$page" "$work/page" || cp "$work/page" "$page"
done
echo "$count excerpts"
[ "$mode" != --check ] || exit $old
