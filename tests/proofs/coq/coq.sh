# coq.sh, for proofs.sh: Coq checks what Gappa proves, so that Gappa need not be right.
#
# For each script a file for Coq is written: the script's claim in plain real numbers (claim.awk), Gappa's proof
# (-Bcoq), and the theorem that the claim follows (bridge.v). Coq must accept it, and the theorem may use only
# the axioms of Coq's real numbers: a gap in Gappa's proof would be listed as another axiom. In the proofs of
# signs, Gappa's two theorems of rounding are replaced by those of all finer formats (roundings.v): each rounding has its
# own format.
#
# False claims must be refused: for a claim with a quarter of a bound Gappa writes no proof, Coq does not accept the
# script's proof for it, and Coq refuses a forgery, which is the script's proof with the quarter in place of the bound. The
# forgeries are those of the scripts in $forge, a line each.

coq_limit=300 # seconds of a processor for each file
coq_axioms=" ClassicalDedekindReals.sig_not_dec ClassicalDedekindReals.sig_forall_dec \
FunctionalExtensionality.functional_extensionality_dep Classical_Prop.classic "

# coq_start COQC FOLDER: compiles the theorems into FOLDER. 77: something is not installed.
coq_start() {
  [ -x "$1" ] || return 77
  echo "Require Flocq.Core.Core Gappa.Gappa_library." >"$2/installed.v"
  (cd "$2" && "$1" installed.v) >/dev/null 2>&1 || return 77
  cp "$(dirname "${BASH_SOURCE[0]}")"/{claim.awk,roundings.v,bridge.v,dekker.v} "$2"
  (cd "$2" && "$1" -Q . "" roundings.v && "$1" -Q . "" bridge.v) || return 1 # Coq leaves files where it runs
  coq_dekker "$1" "$2" || return 1
  coqc=$1 coq_folder=$2
  export coqc coq_folder coq_limit coq_axioms
  export -f one_coq coq_file coq_run coq_module coq_least
}

# coq_dekker COQC FOLDER: Coq accepts the proof of two_product_by_parts, without an axiom of its own, and refuses it with
# another splitter and with a wider range.
coq_dekker() {
  local said axiom change
  said=$(cd "$2" && within "$coq_limit" "$1" -Q . "" dekker.v 2>&1) || {
    echo "FAILED: dekker.v: $said" >&2
    return 1
  }
  for axiom in $(grep -oE '^[A-Z][A-Za-z_]*[.][A-Za-z_.]+' <<<"$said"); do
    [[ $coq_axioms == *" $axiom "* ]] || {
      echo "FAILED: dekker.v assumes $axiom" >&2
      return 1
    }
  done
  for change in 's/134217729/67108865/g' 's/radix2 [(]-969[)]/radix2 (-970)/'; do
    sed "$change" "$2/dekker.v" >"$2/other.v"
    if (cd "$2" && within "$coq_limit" "$1" -Q . "" other.v) >/dev/null 2>&1; then
      echo "FAILED: Coq accepts dekker.v with $change" >&2
      return 1
    fi
  done
}

# The least exponent of the format of a sign's script on stdin; empty for other scripts.
coq_least() { sed -nE 's/^@rnd = float<24, (-[0-9]+), ne>;$/\1/p'; }

# Gappa's proof of the script on stdin as a module.
coq_module() {
  local text least proof name n=0 formats=()
  text=$(cat)
  least=$(coq_least <<<"$text")
  proof=$(within "$limit" "$gappa" -Bcoq <<<"$text" 2>/dev/null) || return 1
  if [ -n "$least" ]; then
    formats=(-e "/^Section /a Variable least : nat -> Z. Hypothesis finer : (forall i, least i <= $least)%Z."
      -e "s/refine \(float_absolute_wide_ne _ _ /refine (finer_absolute _ ($least) _ (finer _) /"
      -e "s/refine \(float_round_ne _ _ /refine (finer_round _ ($least) _ (finer _) /")
    for name in $(sed -nE 's/^([a-z0-9]+) = rnd\(.*/\1/p' <<<"$text"); do
      formats+=(-e "s/^(Notation _$name := .*rounding_float rndNE \(24\)%positive) \($least\)%Z/\1 (least $((n++))%nat)/")
    done
  fi
  echo "Module gappa."
  sed -E -e 's/^Require Import/Import/' \
    -e 's/refine \(UNKNOWN_float_(absolute_wide|relative)_dn\) ; finalize/down/' "${formats[@]}" <<<"$proof"
  echo "End gappa."
}

# coq_file MODULE SCRIPT OTHER...: the whole file. The claim of the first script is a theorem; those of the others must not
# follow.
coq_file() {
  local module=$1 script=$2 least numbers proof n=0 text binders
  shift
  least=$(coq_least <<<"$script")
  numbers=$(sed -nE 's/^Variable _(.*) : R\.$/\1/p' <<<"$module" | tr '\n' ' ')
  echo "Require Import Reals. From Flocq Require Import Core. Open Scope R_scope. Module script."
  for text in "$@"; do
    awk -v name="claim$((n++))" -f "$coq_folder/claim.awk" <<<"$text" || return 1
  done
  echo "End script. Require Import roundings bridge."
  echo "$module"
  # Gappa's assumptions about the numbers are contradictory.
  echo "Lemma last ${least:+(least : nat -> Z) (finer : (forall i, least i <= $least)%Z)} ($numbers: R) :"
  echo "  gappa.s1 ${least:+least} $numbers -> False."
  echo "Proof. without_rule (gappa.l1 ${least:+least finer} $numbers). Qed."
  proof="by_gappa (last ${least:+least finer} $numbers)."
  n=0
  for text in "$@"; do
    binders=$(awk -v name=c -f "$coq_folder/claim.awk" <<<"$text" | sed -nE 's/^  forall (.*) : R,$/\1/p')
    echo "Theorem proved$n : script.claim$n. Proof. unfold script.claim$n. intros ${least:+least finer} $binders."
    [ $n = 0 ] && echo "$proof Qed." || echo "Fail $proof Abort."
    n=$((n + 1))
  done
  echo "Print Assumptions proved0."
}

# coq_run FOLDER: compiles the file on stdin and prints Coq's output.
coq_run() {
  cat >"$1/proof.v"
  (cd "$1" && within "$coq_limit" "$coqc" -Q "$coq_folder" "" proof.v 2>&1)
}

# one_coq FILE: prints a line for each check that passed.
one_coq() {
  local text module forged said status axiom change folder number mantissa exponent changes=() others=()
  text=$(grep -v '^#' "$1")
  folder=$(mktemp -d -p "$coq_folder")
  module=$(coq_module <<<"$text") || bad "$1: Gappa writes no proof for Coq"
  mapfile -t changes < <(quarters "$1")
  for change in "${changes[@]}"; do
    others+=("$(sed -E "$change" <<<"$text")")
    [ "${others[-1]}" != "$text" ] || bad "$1: nothing to change: $change"
    ! coq_module <<<"${others[-1]}" >/dev/null || bad "$1: Gappa writes a proof with $change"
  done
  said=$(coq_file "$module" "$text" "${others[@]}" | coq_run "$folder") || bad "$1: Coq refuses it: $said"
  [[ $said == Axioms:* ]] || bad "$1: Coq says no axioms but $said"
  for axiom in $(tail -n +2 <<<"$said" | grep -oE '^[^ :]+'); do
    [[ $coq_axioms == *" $axiom "* ]] || bad "$1: its proof assumes $axiom"
    echo "assumed: $axiom"
  done
  echo accepted
  for change in "${changes[@]}"; do echo "another claim refused"; done

  [[ $'\n'$forge$'\n' == *$'\n'"$1"$'\n'* ]] || return 0
  # The forgery: the first false claim, with its number in place of the true one in Gappa's proof.
  number=$(diff <(grep -oE '[0-9]+b-[0-9]+' <<<"$text") <(grep -oE '[0-9]+b-[0-9]+' <<<"${others[0]}") |
    sed -n 's/^< //p;T;q') || true
  mantissa=${number%b-*} exponent=${number#*b-}
  while [ $((mantissa % 2)) = 0 ]; do mantissa=$((mantissa / 2)) exponent=$((exponent - 1)); done
  forged=$(sed -E "s/(:= Float2 \($mantissa\)) \(-$exponent\)/\1 (-$((exponent + 2)))/" <<<"$module")
  [ "$forged" != "$module" ] || bad "$1: no $number in Gappa's proof to forge"
  status=0
  said=$(coq_file "$forged" "${others[0]}" | coq_run "$folder") || status=$?
  [ $status = 1 ] && [[ $said == *"Error:"*"has type"* ]] || bad "$1: Coq takes a forgery: $status $said"
  echo "forgery refused"
}
