(* Roundings that Gappa's library for Coq has no theorems of: to every format that is finer than the one that Gappa
   proves with, and down. coq.sh puts them where Gappa's proofs name others. *)
Require Import Reals Lra Lia Bool.
Require Import Gappa.Gappa_library.
From Gappa Require Import Gappa_dyadic Gappa_float Gappa_round.
From Flocq Require Import Core Relative.
Open Scope R_scope.

Lemma power (e : Z) : float2R (Float2 1 e) = bpow radix2 e.
Proof. unfold float2R, F2R. simpl. ring. Qed.
Lemma minus_power (e : Z) : float2R (Float2 (-1) e) = - bpow radix2 e.
Proof. unfold float2R, F2R. simpl. ring. Qed.

(* Nearest even, with precision p and a least exponent of at most d. Where numbers are normal with d the rounding is the
   same; where they are smaller the error is at most half a unit of d. *)
Section finer.
Variables (p : positive) (d least : Z).
Hypothesis finer : (least <= d)%Z.
Notation coarse := (round radix2 (FLT_exp d (Z.pos p)) rndNE).
Notation fine := (round radix2 (FLT_exp least (Z.pos p)) rndNE).

Lemma fine_of_normal (x : R) : bpow radix2 (d + Z.pos p - 1) <= Rabs x -> fine x = coarse x.
Proof.
  intros normal.
  rewrite (round_FLT_FLX radix2 d) by exact normal.
  apply round_FLT_FLX. apply Rle_trans with (2 := normal). apply bpow_le. lia.
Qed.

Lemma fine_of_small (x : R) :
  Rabs x <= bpow radix2 (d + Z.pos p - 1) -> - bpow radix2 (d - 1) <= fine x - x <= bpow radix2 (d - 1).
Proof.
  intros small.
  assert (prec : Prec_gt_0 (Z.pos p)) by reflexivity.
  set (edge := bpow radix2 (d + Z.pos p - 1)) in *.
  assert (positive : Rabs edge = edge) by (apply Rabs_pos_eq, bpow_ge_0).
  assert (unit : ulp radix2 (FLT_exp least (Z.pos p)) x <= bpow radix2 d).
  { apply Rle_trans with (ulp radix2 (FLT_exp least (Z.pos p)) edge).
    - apply ulp_le; auto with typeclass_instances. now rewrite positive.
    - apply Rle_trans with (Rabs edge * bpow radix2 (1 - Z.pos p)).
      + apply ulp_FLT_le. rewrite positive. apply bpow_le. lia.
      + rewrite positive. unfold edge. rewrite <- bpow_plus. apply bpow_le. lia. }
  pose proof (error_le_half_ulp radix2 (FLT_exp least (Z.pos p)) (fun n => negb (Z.even n)) x) as error.
  assert (half : bpow radix2 d = 2 * bpow radix2 (d - 1)).
  { replace d with (1 + (d - 1))%Z at 1 by ring. now rewrite bpow_plus. }
  apply Rabs_le_inv in error. lra.
Qed.

Definition holds_unit (zi : FF) := Fle2 (lower zi) (Float2 (-1) (d - 1)) && Fle2 (Float2 1 (d - 1)) (upper zi).

Lemma finer_absolute (x : R) (xi zi : FF) :
  ABS x xi -> float_absolute_wide_ne_helper p d xi zi && holds_unit zi = true -> BND (fine x - x) zi.
Proof.
  intros within checked.
  apply andb_prop in checked. destruct checked as (coarsely & unit).
  destruct (Rle_or_lt (bpow radix2 (d + Z.pos p - 1)) (Rabs x)) as [normal | small].
  - rewrite fine_of_normal by exact normal. now apply float_absolute_wide_ne with (1 := within).
  - apply andb_prop in unit. destruct unit as (low & high).
    apply Fle2_correct in low. apply Fle2_correct in high.
    rewrite minus_power in low. rewrite power in high.
    destruct (fine_of_small x (Rlt_le _ _ small)).
    split; lra.
Qed.

(* An end of an interval that all these formats round alike. *)
Definition alike (f : float2) :=
  Feq2 f (Float2 0 0) || Fle2 (Float2 1 (d + Z.pos p - 1)) f || Fle2 f (Float2 (-1) (d + Z.pos p - 1)).

Lemma fine_of_alike (f : float2) : alike f = true -> fine f = coarse f.
Proof.
  unfold alike. intros is.
  apply orb_prop in is. destruct is as [is | is]; [apply orb_prop in is; destruct is as [is | is] |].
  - apply Feq2_correct in is. rewrite is.
    replace (float2R (Float2 0 0)) with 0 by (unfold float2R, F2R; simpl; ring).
    rewrite !round_0; auto with typeclass_instances.
  - apply Fle2_correct in is. apply fine_of_normal.
    apply Rle_trans with (2 := Rle_abs _). now rewrite power in is.
  - apply Fle2_correct in is. apply fine_of_normal.
    rewrite <- Rabs_Ropp. apply Rle_trans with (2 := Rle_abs _). rewrite minus_power in is. lra.
Qed.

Lemma finer_round (x : R) (xi zi : FF) :
  BND x xi ->
  round_helper (Gappa_round.round (rndG_g roundNE_cs) (FLT_exp d (Z.pos p))) xi zi &&
    (alike (lower xi) && alike (upper xi)) = true ->
  BND (fine x) zi.
Proof.
  intros within checked.
  apply andb_prop in checked. destruct checked as (coarsely & ends).
  apply andb_prop in ends. destruct ends as (low & high).
  assert (Valid_exp (FLT_exp least (Z.pos p))) by (apply FLT_exp_valid; reflexivity).
  assert (ordered : lower xi <= upper xi) by (destruct within; lra).
  destruct (float_round_ne p d (lower xi) xi zi) as (first & _); [split; lra | exact coarsely |].
  destruct (float_round_ne p d (upper xi) xi zi) as (_ & last); [split; lra | exact coarsely |].
  change (rndG_f roundNE_cs) with rndNE in *.
  rewrite <- (fine_of_alike _ low) in first. rewrite <- (fine_of_alike _ high) in last.
  destruct within. split.
  - apply Rle_trans with (1 := first). apply round_le; auto with typeclass_instances.
  - apply Rle_trans with (2 := last). apply round_le; auto with typeclass_instances.
Qed.
End finer.

(* Down. *)
Lemma down_absolute (least k : Z) (p : positive) (x : R) :
  (least + Z.pos p <= k)%Z -> Rabs x <= bpow radix2 k ->
  - bpow radix2 (k - Z.pos p) <= round radix2 (FLT_exp least (Z.pos p)) Zfloor x - x <= 0.
Proof.
  intros range bounded.
  assert (prec : Prec_gt_0 (Z.pos p)) by reflexivity.
  assert (0 <= bpow radix2 (k - Z.pos p)) by apply bpow_ge_0.
  destruct (round_DN_pt radix2 (FLT_exp least (Z.pos p)) x) as (_ & below & _).
  destruct (Req_dec x 0) as [-> | nonzero].
  { rewrite round_0; auto with typeclass_instances; lra. }
  destruct bounded as [inside | edge].
  - pose proof (error_le_ulp radix2 (FLT_exp least (Z.pos p)) Zfloor x) as error.
    rewrite ulp_neq_0 in error by exact nonzero.
    assert (bpow radix2 (cexp radix2 (FLT_exp least (Z.pos p)) x) <= bpow radix2 (k - Z.pos p)).
    { apply bpow_le. unfold cexp, FLT_exp. pose proof (mag_le_bpow radix2 x k nonzero inside). lia. }
    apply Rabs_le_inv in error. lra.
  - assert (format : generic_format radix2 (FLT_exp least (Z.pos p)) (bpow radix2 k))
      by (apply generic_format_FLT_bpow; [exact prec | lia]).
    rewrite round_generic; auto with typeclass_instances; [lra |].
    unfold Rabs in edge. destruct (Rcase_abs x).
    + replace x with (- bpow radix2 k) by lra. now apply generic_format_opp.
    + now replace x with (bpow radix2 k).
Qed.

Lemma down_relative (least : Z) (p : positive) (x : R) :
  bpow radix2 (least + Z.pos p - 1) <= Rabs x ->
  exists r, - bpow radix2 (1 - Z.pos p) <= r <= bpow radix2 (1 - Z.pos p) /\
    round radix2 (FLT_exp least (Z.pos p)) Zfloor x = x * (1 + r).
Proof.
  intros normal.
  destruct (relative_error_FLT_ex radix2 least (Z.pos p) eq_refl Zfloor x normal) as (r & small & is).
  exists r. split; [| exact is].
  replace (1 - Z.pos p)%Z with (- Z.pos p + 1)%Z by ring.
  apply Rabs_le_inv. now apply Rlt_le.
Qed.
