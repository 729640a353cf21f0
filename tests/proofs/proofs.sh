#!/usr/bin/env bash
# proofs.sh [--long] CHECK GAPPA COQC FOLDER...: runs Gappa on every proofs/*.gappa under each FOLDER of generated files,
# on all cores.
#   prove      every script is proved
#   theorems   of rounding, each proof uses only what also holds in finer formats (gen/target/gappa/gappa.cpp)
#   quarter    with a quarter of its bound, no script is proved
#   roundings  every rounding counts: without one, the bound that Gappa finds is smaller; with one more, it is larger than
#              the script's
#   coq        Coq accepts each proof, and refuses false claims (coq/coq.sh)
# Some scripts are not about signs: half_parts, and ball_filter, two_points and two_balls_*, whose errors are variables. For
# these `quarter` divides each part of the margin by 4 (a term that has room, by more), and `roundings` enlarges each error
# by as much as it takes, widens the other ranges, and breaks the rule.
# Most signs have two scripts: their products and sums are fused, or not. Without --long, `roundings` and `coq` take the
# first of the two, and of all proofs only the shortest of a sign and those of no sign are forged for Coq.
set -euo pipefail
long=
if [ "$1" = --long ]; then
  long=1
  shift
fi
check=$1 gappa=$2 coqc_found=$3
shift 3
[ -x "$gappa" ] || {
  echo "SKIPPED: gappa was not found (Debian: apt install gappa); no error bound was proved"
  exit 77
}
limit=120 # seconds of a processor for a proof
export check gappa limit
# within SECONDS COMMAND...: for at most so many seconds of a processor, however busy the machine is.
within() (
  ulimit -t "$1"
  shift
  exec "$@"
)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
if [ "$check" = coq ]; then
  . "$(dirname "$0")/coq/coq.sh"
  coq_start "$coqc_found" "$folder" || {
    [ $? = 77 ] || exit 1
    echo "SKIPPED: coqc, Flocq or Gappa's library was not found (Debian: apt install coq libcoq-flocq libcoq-gappa)"
    exit 77
  }
fi

# The least c that Gappa finds for the script on stdin: "|v - e| in [0, 33b-25 {9.83477e-07, 2^(-19.9556)}]".
best() {
  sed 's/|v - e| <= .* }$/|v - e| in ? }/' | within "$limit" "$gappa" -Echange-threshold=0 -Eno-auto-dichotomy 2>&1 |
    sed -nE 's/.*\|[ve] - e\| in \[0, 0\]/0/p; s/.*\|v - e\| in .*\{([0-9.e+-]*),.*/\1/p'
}

# is A OPERATOR B: compares numbers; false if one is missing.
is() { awk -v a="$1" -v b="$3" 'BEGIN {exit !(a != "" && b != "" && (a + 0) '"$2"' (b + 0))}'; }

# refused FILE WHY: the script on stdin differs from FILE, and Gappa does not prove it.
refused() {
  local changed said
  changed=$(cat)
  [ "$changed" != "$(grep -v '^#' "$1")" ] || {
    echo "FAILED: $1: nothing to change: $2" >&2
    return 1
  }
  said=$(within "$limit" "$gappa" <<<"$changed" 2>&1) && {
    echo "FAILED: $1 is proved too: $2" >&2
    return 1
  }
  [[ $said == *"some properties were not satisfied"* ]] || {
    echo "FAILED: $1: $2: $said" >&2
    return 1
  }
}

# quarters FILE: the changes (for sed) that make its claim false: each takes a quarter of a bound or of its premise.
quarters() {
  local part m e
  case $(basename "$1" .gappa) in
  ball_filter)
    for part in square additive linear absolute; do
      echo "s/^($part = [0-9]+)b/\1b-2 * 1b/"
    done
    ;;
  two_points)
    printf '%s\n' 's/^margin = 5b-23;/margin = 5b-25;/' 's/^term = 1b-126;/term = 1b-150;/'
    ;;
  two_balls_most) printf '%s\n' 's/^factor = 1b-19;/factor = 1b-21;/' 's/^term = 1b-60;/term = 1b-150;/' ;;
  two_balls_least) printf '%s\n' 's/^factor = 1b-19;/factor = 1b-21;/' 's/^term = 1b-60;/term = 1b-63;/' ;;
  two_balls_apart) echo 's/^less = 2097151b-42;/less = 2097151b-44;/' ;;
  two_balls_touch) printf '%s\n' 's/^room = 1b-21;/room = 1b-23;/' 's/v in \[1b-61,/v in [1b-75,/' ;;
  half_parts) # the relative errors, and the precisions that they come from
    printf '%s\n' 's/<= 1b-11 /<= 1b-13 /' 's/<= 1b-10 /<= 1b-12 /' 's/<11, -24, ne>/<9, -24, ne>/' \
      's/<11, -24, dn>/<9, -24, dn>/'
    ;;
  *) # of a sign: in Gappa 33b-25 is 33 * 2^-25
    sed -nE 's/.*\|v - e\| <= ([0-9]+)b-([0-9]+) .*/\1 \2/p' "$1" | while read -r m e; do
      echo "s/(v - e.) <= ${m}b-$e /\1 <= ${m}b-$((e + 2)) /"
    done
    ;;
  esac
}

# one_filter FILE: the same for the scripts that are not about signs.
one_filter() {
  local text change said changes=()
  text=$(grep -v '^#' "$1")
  case $check:$(basename "$1" .gappa) in
  roundings:ball_filter)
    for change in 'e[xy][0-3]' 'i[xy][0-3]' 't[xy][0-3]' 'p[0-3]' 'p[xy]' 'z[xy]'; do
      changes+=("s/\\|($change)\\| <= 1b/|\\1| <= 2b/; s/\\|($change)\\| <= 17b/|\\1| <= 34b/")
    done
    # The second part contains what the first one loses, so it counts for little.
    changes+=('s/\|(s[xy][0-3])\| <= 1b/|\1| <= 64b/'
      's/(w[xy]) in \[0, 8\]/\1 in [-8, 8]/' 's/(d[xy][0-3]) in \[-1, 1\]/\1 in [-2, 2]/' 's/  F <= 0/  F <= 1/')
    # Gappa accepts a rule that is not an identity, but says so.
    said=$(sed 's/(W0 + W1/(2 * W0 + W1/' <<<"$text" | within "$limit" "$gappa" 2>&1) || true
    [[ $said == *"not trivially equal"* ]] || bad "$1: Gappa does not check the rule"
    echo identity
    ;;
  roundings:two_points) # the factor is the next number above eight roundings, so one error must become 4 times as large
    for change in a1 a2 c1 c2 g h; do
      changes+=("s/\|$change\| <= 1b-24/|$change| <= 1b-22/")
    done
    for change in b1 b2; do
      changes+=("s/\|$change\| <= 134217729b-51/|$change| <= 134217729b-49/")
    done
    for change in y1 y2 z; do
      changes+=("s/\|$change\| <= 1b-150/|$change| <= 1b-125/")
    done
    changes+=('s/n - f <= 0/n - f <= 1/')
    said=$(sed 's/\* E1 - f/* E2 - f/' <<<"$text" | within "$limit" "$gappa" 2>&1) || true
    [[ $said == *"not trivially equal"* ]] || bad "$1: Gappa does not check the rule"
    echo identity
    ;;
  roundings:two_balls_*) # the margin leaves room for each alone
    for change in $(grep -oE '\|[a-z0-9]+\| <=' <<<"$text" | tr -d '|<= '); do
      case $1:$change in
      */two_balls_most.gappa:e[234] | */two_balls_least.gappa:e[234]) least=1b-1 ;; # of a ball's error, not of its size
      *:y) least=1b-59 ;;
      *) least=1b-18 ;;
      esac
      changes+=("s/\|$change\| <= [0-9]+b-[0-9]+/|$change| <= $least/")
    done
    for change in 'p in \[0, 1\]/p in [0, 64]' 't in \[0, 8b-24\]/t in [0, 64b-24]' 't0 in \[0, 1b-148\]/t0 in [0, 1b-59]' \
      ' s in \[0,/ s in [-1b129,' 'x in \[0,/x in [-1b131,' ' q in \[0, 11b-24\]/ q in [0, 64b-24]' \
      's0 in \[0, 1b-147\]/s0 in [0, 1b-59]' 'P in \[1b-60,/P in [1b-80,' 'L in \[0,/L in [-1b130,' ' d in \[0, 1\]/ d in [0, 2]'; do
      if grep -qE -- "${change%%/*}" <<<"$text"; then
        changes+=("s/$change/")
      fi
    done
    said=$(sed -E 's/-> ([MPL]) \*/-> 2 * \1 */' <<<"$text" | within "$limit" "$gappa" 2>&1) || true
    [[ $said == *"not trivially equal"* ]] || bad "$1: Gappa does not check the rule"
    echo identity
    ;;
  roundings:half_parts) # products of more bits, or of fewer left
    changes=('s/<11, -24, ne>/<13, -24, ne>/' 's/<24, -149, ne>/<21, -149, ne>/')
    ;;
  theorems:*) # the errors of ball_filter are variables, and half_parts is of fp16 itself
    echo "none to look at"
    return
    ;;
  esac
  for change in "${changes[@]}"; do
    sed -E "$change" <<<"$text" | refused "$1" "$change" || exit 255
    echo refused
  done
}

# one FILE: prints a line for each check that passed. 255 stops xargs.
one() {
  local text line n least bound changed changes
  text=$(grep -v '^#' "$1")
  bad() {
    echo "FAILED: $1" >&2
    exit 255
  }
  if [[ $check != @(prove|quarter|coq) ]] && [[ $text != *"|v - e|"* ]]; then
    one_filter "$1"
    return
  fi
  case $check in
  prove)
    line=$(within "$limit" "$gappa" <<<"$text" 2>&1) || bad "$1 is not proved"
    [ -z "$line" ] || bad "$1: $line"
    echo proved
    ;;
  theorems)
    local used
    used=$(within "$limit" "$gappa" -Bcoq <<<"$text" 2>/dev/null | grep -oE '\b(float|fixed|fix|flt|rel|enforce)_[a-z_]+' | sort -u) ||
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
    mapfile -t changes < <(quarters "$1")
    [ ${#changes[@]} -gt 0 ] || bad "$1: no bound to change"
    for line in "${changes[@]}"; do
      sed -E "$line" <<<"$text" | refused "$1" "$line" || exit 255
      echo refused
    done
    ;;
  coq) one_coq "$1" ;;
  roundings)
    least=$(best <<<"$text")
    bound=$(sed -nE 's/.*\|v - e\| <= ([0-9]+)b-([0-9]+) \}$/\1 \2/p' <<<"$text" | awk '{printf "%.9g", $1 / 2 ^ $2}')
    is "$least" "<=" "$bound" || bad "$1: Gappa finds the bound '$least' and not '$bound'"
    while read -r n line; do
      # One rounding is removed.
      changed=$(sed "${n}s/= rnd(\(.*\));/= \1;/" <<<"$text" | best)
      is "$changed" "<" "$least" || bad "$1: '$line' counts for nothing ('$changed' without it, '$least' with it)"
      echo less
      # One rounding is added: a product that was fused is rounded separately.
      [[ $line == *" * "*" "[+-]" "* ]] || continue
      changed=$(sed -E "${n}s/rnd\((.* \* .*) ([+-] [a-z0-9 *]+)\);/rnd(rnd(\1) \2);/" <<<"$text" | best)
      is "$changed" ">" "$bound" || bad "$1: '$line' unfused is within the bound too ('$changed' of '$bound')"
      echo more
    done < <(grep -n '= rnd(' <<<"$text" | sed 's/:/ /')
    ;;
  *) bad "no check '$check'" ;;
  esac
}
export -f within one one_filter quarters refused best is

# The same script may be in several folders; except for `prove`, it is checked once.
mapfile -t scripts < <(
  find "$@" -path '*/proofs/*.gappa' | while read -r f; do
    echo "$({ [ "$check" != prove ] || echo "$f"; grep -v '^#' "$f"; } | sha1sum | cut -d' ' -f1) $f"
  done | sort -u -k1,1 | cut -d' ' -f2- | xargs -r -d '\n' ls -S # the longest first, for the cores to end together
)
for each in "$@"; do
  [ -n "$(find "$each" -path '*/proofs/*.gappa' -print -quit)" ] || {
    echo "FAILED: no scripts under $each" >&2
    exit 1
  }
done
if [ -z "$long" ] && [[ $check == @(roundings|coq) ]]; then
  kept=()
  for each in "${scripts[@]}"; do
    [[ $each == *_unfused.gappa && -e ${each/_unfused/} ]] || kept+=("$each")
  done
  scripts=("${kept[@]}")
fi
# The proofs that are forged for Coq: all, or the shortest proof of a sign and those that are not about signs.
forge=$(printf '%s\n' "${scripts[@]}")
[ -n "$long" ] || forge=$(
  grep -L 'v - e' "${scripts[@]}" || true
  for each in "${scripts[@]}"; do
    ! grep -q 'v - e' "$each" || echo "$each"
  done | tail -n 1
)
export forge
log=$folder/log
status=0
printf '%s\0' "${scripts[@]}" | xargs -0 -P "$(nproc)" -n 1 bash -c 'set -euo pipefail; one "$1"' one >"$log" || status=1
[ "$check" != coq ] || grep -q "forgery refused" "$log" || {
  echo "FAILED: no forgery was tried"
  status=1
}
sort "$log" | uniq -c
echo "$check: $(wc -l <"$log") lines of ${#scripts[@]} scripts"
exit $status
