(* two_product_by_parts of runtime/kernel/meetc/number/double_double.hpp is exact.

   Flocq proves Dekker's product for every precision. This is its theorem for binary64 with rounding to nearest even,
   written line by line as the C++ function, where no operation overflows: for |a|, |b| <= 2^995 and |a b| <= 2^1021. *)
Require Import ZArith Reals Psatz.
From Flocq Require Import Core Pff2Flocq.
Open Scope R_scope.

Notation binary64 := (generic_format radix2 (FLT_exp (-1074) 53)).
Notation rnd := (round radix2 (FLT_exp (-1074) 53) ZnearestE).

Theorem two_product_by_parts_is_exact (a b : R) :
  binary64 a -> binary64 b -> a * b = 0 \/ bpow radix2 (-969) <= Rabs (a * b) ->
  let splitter := 134217729 in (* 2^27 + 1 *)
  let p := rnd (a * b) in
  let x := rnd (a * splitter) in let y := rnd (b * splitter) in
  let qa := rnd (a - x) in let qb := rnd (b - y) in
  let ah := rnd (qa + x) in let al := rnd (a - ah) in
  let bh := rnd (qb + y) in let bl := rnd (b - bh) in
  let rest := rnd (- p + rnd (ah * bh)) in
  a * b = p + rnd (rnd (rnd (rest + rnd (ah * bl)) + rnd (al * bh)) + rnd (al * bl)).
Proof.
intros Fa Fb range; cbv zeta.
assert (H := Dekker radix2 (-1074) 53 (fun x => negb (Z.even x)) ltac:(lia) ltac:(lia) a b Fa Fb (or_introl eq_refl)).
destruct H as [H _].
change (Z.div2 53) with 26%Z in H.
replace (bpow radix2 (53 - 26) + 1) with 134217729 in H by (simpl; lra).
apply H.
exact range.
Qed.
Print Assumptions two_product_by_parts_is_exact.
