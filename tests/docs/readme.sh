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

# ---- the pairs that plain float misses ----
for precision in certified fp32; do
  count=$("$meet" collide "$work/room/demo/animal.ply" "$work/room/demo/animal.ply" --precision $precision --json |
    sed -E 's/.*"pairs":([0-9]+).*/\1/' | rev | sed -E 's/([0-9]{3})/\1,/g; s/,$//' | rev)
  grep -Eq "^\| \`$precision\`.* \| $count \| " README.md || { echo "README.md does not show $count pairs of $precision"; exit 1; }
done

# ---- the measured figures ----
# cells FILE HEADING NAME COLUMN ...: cells of the row with this name in a table of docs/measured.
cells() {
  local file=docs/measured/$1 heading=$2 name=$3
  shift 3
  awk -F ' *\\| *' -v heading="$heading" -v name="$name" -v columns="$*" '
    /^### /{on = index($0, "### " heading) == 1}
    on && $2 == name {n = split(columns, c, " "); for (i = 1; i <= n; ++i) printf "%s ", $c[i]; found = 1}
    END {exit !found}' "$file" || { echo "$file has no row '$name' below '$heading'" >&2; exit 1; }
}
# shows ROW: the README must have this row.
shows() { grep -qF "$1" README.md || { echo "README.md does not show '$1'"; exit 1; }; }
read -r pairs build query given <<<"$(cells gpu.md 'A hierarchy of the usual kind' 'Bunny x Armadillo' 5 7 8 11)"
shows "of which $pairs pairs touch"
shows "| meetc | proved | $given |"
shows "| of plain float | $(awk "BEGIN {print $build + $query}") |"
read -r found both <<<"$(cells cpu.md 'bunny x armadillo' certified 7 6)"
shows "| meetc | $found pairs, proved | 1 |"
for method in 'Embree, rtcCollide, low quality' 'trueform, AABB tree' 'CGAL, AABB tree, EPICK' 'FCL, OBBRSS'; do
  read -r found time <<<"$(cells cpu.md 'bunny x armadillo' "$method" 7 6)"
  ratio=$(awk "BEGIN {printf \"%.2g\", $time / $both}")
  grep -qE "^\| $method \| $found pairs[^|]* \| $ratio \|$" README.md || { echo "README.md: $method: $found, $ratio"; exit 1; }
done
read -r wrong missed <<<"$(cells cpu.md 'bunny x armadillo' 'trueform, AABB tree' 8 9)"
shows "pairs, $wrong of them wrong and $missed missed |"

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
