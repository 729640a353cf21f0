#!/usr/bin/env bash
# proofs.sh CHECK GAPPA GENERATED: runs Gappa on every GENERATED/*/*/proofs/*.gappa, on all cores.
#   prove      every script is proved
#   theorems   of rounding, each proof uses only what also holds in finer formats (gen/emit/gappa.cpp)
#   quarter    with a quarter of its bound, no script is proved
#   roundings  every rounding counts: without it the bound that Gappa finds is less, with one more it is more than the
#              script's
set -euo pipefail
[ -x "$2" ] || {
  echo "SKIPPED: gappa was not found (Debian: apt install gappa); no error bound was proved"
  exit 77
}
check=$1 gappa=$2 generated=$3
limit=120 # seconds a proof
export check gappa limit

# The least c that Gappa finds for the script on stdin: "|v - e| in [0, 33b-25 {9.83477e-07, 2^(-19.9556)}]".
best() {
  sed 's/|v - e| <= .* }$/|v - e| in ? }/' | timeout "$limit" "$gappa" -Echange-threshold=0 -Eno-auto-dichotomy 2>&1 |
    sed -nE 's/.*\|[ve] - e\| in \[0, 0\]/0/p; s/.*\|v - e\| in .*\{([0-9.e+-]*),.*/\1/p'
}

# is A OPERATOR B: compares numbers; false where one is missing.
is() { awk -v a="$1" -v b="$3" 'BEGIN {exit !(a != "" && b != "" && (a + 0) '"$2"' (b + 0))}'; }

# one FILE: prints a line for each check that went well. 255 stops xargs.
one() {
  local text line n said least bound changed
  text=$(grep -v '^#' "$1")
  bad() {
    echo "FAILED: $1" >&2
    exit 255
  }
  case $check in
  prove)
    timeout "$limit" "$gappa" <<<"$text" >/dev/null || bad "$1 is not proved"
    echo proved
    ;;
  theorems)
    local used
    used=$(timeout "$limit" "$gappa" -Bcoq <<<"$text" 2>/dev/null | grep -oE '\b(float|fixed|fix|flt|rel|enforce)_[a-z_]+' | sort -u) ||
      bad "$1: no proof to look at"
    for line in $used; do
      case $line in
      float_absolute_ne | float_absolute_wide_ne | float_round_ne) ;;
      *) bad "$1: its proof uses $line, which may not hold in a finer format" ;;
      esac
    done
    echo "$used"
    ;;
  quarter)
    # In Gappa 33b-25 is 33 * 2^-25.
    [[ $text =~ ^(.*\|v\ -\ e\|\ \<=\ [0-9]+b-)([0-9]+)(.*)$ ]] || bad "$1: no bound to change"
    changed=${BASH_REMATCH[1]}$((BASH_REMATCH[2] + 2))${BASH_REMATCH[3]}
    said=$(timeout "$limit" "$gappa" <<<"$changed" 2>&1) && bad "$1 is proved with a quarter of its bound too"
    [[ $said == *"some properties were not satisfied"* ]] || bad "$1: $said"
    echo refused
    ;;
  roundings)
    least=$(best <<<"$text")
    bound=$(sed -nE 's/.*\|v - e\| <= ([0-9]+)b-([0-9]+) \}$/\1 \2/p' <<<"$text" | awk '{printf "%.9g", $1 / 2 ^ $2}')
    is "$least" "<=" "$bound" || bad "$1: Gappa finds the bound '$least' and not '$bound'"
    while read -r n line; do
      # One rounding less.
      changed=$(sed "${n}s/= rnd(\(.*\));/= \1;/" <<<"$text" | best)
      is "$changed" "<" "$least" || bad "$1: '$line' counts for nothing ('$changed' without it, '$least' with it)"
      echo less
      # One more: a product that was fused is rounded by itself.
      [[ $line == *" * "*" "[+-]" "* ]] || continue
      changed=$(sed -E "${n}s/rnd\((.* \* .*) ([+-] [a-z0-9 *]+)\);/rnd(rnd(\1) \2);/" <<<"$text" | best)
      is "$changed" ">" "$bound" || bad "$1: '$line' unfused is within the bound too ('$changed' of '$bound')"
      echo more
    done < <(grep -n '= rnd(' <<<"$text" | sed 's/:/ /')
    ;;
  *) bad "no check '$check'" ;;
  esac
}
export -f one best is

# The same script may lie in several folders; once is enough but for `prove`.
mapfile -t scripts < <(
  for f in "$generated"/*/*/proofs/*.gappa; do
    [ -e "$f" ] || continue
    echo "$([ "$check" = prove ] && echo "$f" || grep -v '^#' "$f" | sha1sum | cut -d' ' -f1) $f"
  done | sort -u -k1,1 | cut -d' ' -f2-
)
[ ${#scripts[@]} -gt 0 ] || {
  echo "FAILED: no scripts under $generated" >&2
  exit 1
}
log=$(mktemp)
trap 'rm -f "$log"' EXIT
status=0
printf '%s\0' "${scripts[@]}" | xargs -0 -P "$(nproc)" -n 1 bash -c 'set -euo pipefail; one "$1"' one >"$log" || status=1
sort "$log" | uniq -c
echo "$check: $(wc -l <"$log") lines of ${#scripts[@]} scripts"
exit $status
