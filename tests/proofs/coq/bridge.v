(* From Gappa's last lemma to a script's claim as claim.awk states it; what the claim says owes nothing to this file.
   Gappa proves that its suppositions and the claim's negation contradict each other, with numbers of its own kind;
   a rule that the script gives is an equation that Gappa does not prove. Limits: the claim's bounds are numbers, and
   the definitions are as the emitter orders them: terms are compared as they stand, but for how numbers are written. *)
Require Import Reals Lra Lia.
Require Import Gappa.Gappa_library roundings.
From Flocq Require Import Core.
Open Scope R_scope.

(* y = x (1 + r) with a small r, and so the relative error (y - x) / x is small where x is not 0. *)
Lemma relative_error (x y r least most : R) :
  y = x * (1 + r) -> - most <= r <= most -> 0 < least -> least <= Rabs x -> Rabs ((y - x) / x) <= most.
Proof.
  intros -> small positive away.
  replace ((x * (1 + r) - x) / x) with r; [now apply Rabs_le |].
  field. intros ->. rewrite Rabs_R0 in away. lra.
Qed.

(* Numbers are m * 2^e, as Gappa's are; `numbers` writes all of the goal in one way: as integers, or with the
   greatest e. *)
Fixpoint halved (steps : nat) (m e : Z) : Z * Z :=
  match steps with
  | O => (m, e)
  | S n => if (Z.even m && (e <? 0)%Z)%bool then halved n (Z.div2 m) (e + 1) else (m, e)
  end.
Definition normal (m e : Z) : R := IZR m * bpow radix2 e.

(* A comparison of numbers, by their values; any number may be rounded. *)
Ltac value :=
  repeat match goal with |- context [round ?b ?f ?r ?x] => generalize (round b f r x); intro end;
  cbv -[IZR Rmult Rinv Ropp Rplus Rminus Rle Rlt Rabs not]; lra.
Ltac number x m e :=
  lazymatch eval cbv in (halved 200 m e) with
  | (m, Zneg ?f) => change x with (normal m (Zneg f)) (* the next two cases alone would do, but slowly *)
  | (m, Z0) => replace x with (IZR m) by exact (eq_sym (Rmult_1_r (IZR m)))
  | (?n, Zneg ?f) => replace x with (normal n (Zneg f)) by value
  | (?n, ?f) => let k := eval cbv in (n * 2 ^ f)%Z in replace x with (IZR k) by value
  end.
Ltac numbers :=
  unfold Gappa_pred_bnd.Float1; change Gappa_round_def.rndNE with ZnearestE;
  repeat match goal with
  | |- context [float2R ?c] => lazymatch eval cbv in c with Float2 ?m ?e => number (float2R c) m e end
  | |- context [IZR ?m * bpow radix2 ?e] => number (IZR m * bpow radix2 e) m e
  end.

(* A step of Gappa's that rests on rounding down. The exponents are in what Gappa found. *)
Ltac down :=
  lazymatch goal with
  | h : BND ?x _ |- BND (round radix2 (FLT_exp ?least (Z.pos ?p)) Zfloor ?x - ?x) ?i =>
    let e := eval cbv in (Gappa_definitions.Fexp (lower i)) in
    let k := eval cbv in (e + Z.pos p)%Z in
    let found := fresh in
    assert (found := down_absolute least k p x); destruct h, found; [easy | apply Rabs_le; split | split]
  | h : ABS ?x _ |- REL (round radix2 (FLT_exp ?least (Z.pos ?p)) Zfloor ?x) ?x _ =>
    let r := fresh in
    let is := fresh in
    destruct (down_relative least p x) as (r & [] & is);
    [destruct h as (_ & []) | exists r; split; [split | exact is]]
  end;
  repeat match goal with h : _ <= _ |- _ => revert h end;
  value.

(* Gappa's last lemma l without the rule, which must be an identity. *)
Ltac without_rule l :=
  lazymatch type of l with
  | ?x = ?y -> _ => let rule := fresh in assert (rule : x = y) by (numbers; unfold normal; field); exact (l rule)
  | _ => exact l
  end.

(* `bad` and h contradict each other. Compared as they stand: Coq would search for long whether others are equal. *)
Ltac contradict bad h :=
  lazymatch type of bad with ?a < ?b =>
    lazymatch type of h with ?c <= ?d => constr_eq a d; constr_eq b c; exact (Rlt_not_le _ _ bad h) end
  end.

Ltac contradict_relative bad :=
  lazymatch type of bad with ?most < Rabs ((?y - ?x) / ?x) =>
    lazymatch goal with away : _ <= Rabs x |- not (REL y x _) =>
      let r := fresh in
      let is := fresh in
      let low := fresh in
      let high := fresh in
      intros (r & [low high] & is); apply (Rlt_not_le _ _ bad);
      apply (relative_error x y r _ _ is) with (3 := away); [split |]; revert low high; value
    end
  end.

(* A part of what Gappa supposes: the claim's hypotheses, and `bad`, that a bound of the claim is exceeded. *)
Ltac supposed bad :=
  let low := fresh in
  let high := fresh in
  lazymatch goal with
  | |- _ /\ _ => split; supposed bad
  | |- _ \/ _ => first [left; supposed bad | right; supposed bad]
  | |- BND _ _ => split; supposed bad
  | |- _ <= _ => numbers; first [match goal with h : ?x |- ?x => exact h end | apply Rabs_pos]
  | |- not (BND _ _) =>
    intros [low high]; revert low high; numbers; intros low high;
    first [contradict bad high | contradict bad low]
  | |- not (REL _ _ _) => change Gappa_round_def.rndNE with ZnearestE; contradict_relative bad
  | |- not (_ <= _) => numbers; intro low; contradict bad low
  | |- _ => red; supposed bad
  end.

(* The claim, its variables introduced, by l, what Gappa proves of them. *)
Ltac by_gappa l :=
  cbv zeta; numbers; intros;
  repeat match goal with h : _ /\ _ |- _ => destruct h end;
  repeat match goal with |- _ /\ _ => split end;
  let bad := fresh in
  apply Rnot_lt_le; intro bad; apply l; supposed bad.
