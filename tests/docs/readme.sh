#!/usr/bin/env bash
# readme.sh MEETC MEET SOURCE: the README's commands run, its measured figures are those of docs/measured/gpu.md, its example is
# small, and every link of the README and docs/, and every file of this tree that they name, exists.
set -euo pipefail
meetc=$1 meet=$2
cd "$3"
source_folder=$PWD

# ---- the commands of each fenced block that follows <!-- run -->, in an empty folder beside docs/ ----
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/bin" "$work/room"
ln -s "$meetc" "$work/bin/meetc"
ln -s "$meet" "$work/bin/meet"
ln -s "$source_folder/docs" "$source_folder/algebra_spec" "$work/room"
awk '$0 == "<!-- run -->" { on = 1; next } on && /^```/ { if (seen) on = seen = 0; else seen = 1; next } on && seen' \
  README.md >"$work/commands"
[ "$(wc -l <"$work/commands")" -ge 6 ]
while IFS= read -r command; do
  (cd "$work/room" && PATH="$work/bin:$PATH" bash -euc "$command" >"$work/said" 2>&1 </dev/null) || {
    echo "README.md: this command fails: $command"
    cat "$work/said"
    exit 1
  }
done <"$work/commands"
[ -s "$work/room/touching.csv" ] && [ -s "$work/room/touching.png" ]

# ---- the measured figures ----
# cell METHOD COLUMN: a cell of the table of Bunny x Armadillo in docs/measured/gpu.md.
cell() {
  awk -F ' *\\| *' -v method="$1" -v column="$2" \
    '/^### /{on = /^### Bunny x Armadillo:/} on && $2 == method {print $column}' docs/measured/gpu.md
}
# shown METHOD: the row of the README that must show its count and its time, the latter to two or three digits.
shown() {
  local count time
  count=$(cell "$1" 3) time=$(printf '%.3g' "$(cell "$1" 4)")
  [ -n "$count" ] || { echo "docs/measured/gpu.md has no row '$1'"; exit 1; }
  case $time in 0.???) time=$(printf '%.2f' "$time") ;; esac
  grep -q "| $count | $time ms |\$" README.md || { echo "README.md does not show '$count | $time ms' of '$1'"; exit 1; }
}
shown 'query, certified, hierarchy'
shown 'Möller, epsilon 0, fp32'
shown 'Möller, his epsilon, fp32'

# ---- the example, the links, and the files that are named ----
[ "$(wc -l <docs/examples/tiny.toml)" -le 10 ]
bad=0
for page in README.md docs/*.md docs/measured/*.md; do
  while IFS= read -r link; do
    [ -e "$(dirname "$page")/${link%%#*}" ] || { echo "$page: broken link: $link"; bad=1; }
  done < <(grep -oE '\]\([^)# ]+[^) ]*\)' "$page" | sed -E 's/^\]\((.*)\)$/\1/' | grep -vE '^https?:' || true)
done
while IFS= read -r named; do
  file=${named%% *}
  case $file in
  *NAME*) continue ;; # of any name
  gen/* | runtime/* | tests/* | docs/* | algebra_spec/* | generated/*) ;;
  meetc/*.hpp) file=runtime/kernel/$file ;;
  meet/*.hpp) file=runtime/${file#meet/} ;;
  core/* | bench/* | io/*) file=runtime/$file ;;
  *) continue ;;
  esac
  [ -e "$file" ] || { echo "README.md or docs/: no such file: $named"; bad=1; }
done < <(grep -ohE '`[^`]+`' README.md docs/*.md docs/measured/*.md | tr -d '`' | sort -u)
exit $bad
