(* The table: what is proved of each operation and family, and by which theorem.  [None] says that nothing is. *)
From Coq Require Import String.
From Algae Require Import Words Reversal Obstruction NonClosure Complement.
Open Scope string_scope.

Definition cell (o : operation) (f : family) : option (bool * string) :=
  let yes name := Some (true, name) in
  let no name := Some (false, name) in
  match f with
  | LSystem k =>
    match o with
    | Reversal => yes "Reversal.v:lsystem_reversal"
    | _ => if extended k then None else
      match o with
      | Union => no "NonClosure.v:not_closed_under_union"
      | Concatenation => no "NonClosure.v:not_closed_under_concatenation"
      | Star => if propagating k then no "NonClosure.v:propagating_not_closed_under_star" else None
      | Intersection => no "NonClosure.v:not_closed_under_intersection"
      | IntersectionWithRegular => no "NonClosure.v:not_closed_under_intersection_with_regular"
      | Complement => no "Complement.v:not_closed_under_complement"
      | Homomorphism => no "NonClosure.v:not_closed_under_homomorphism"
      | NonErasingHomomorphism => no "NonClosure.v:not_closed_under_non_erasing_homomorphism"
      | InverseHomomorphism => no "NonClosure.v:not_closed_under_inverse_homomorphism"
      | FiniteSubstitution => no "NonClosure.v:not_closed_under_finite_substitution"
      | Substitution => no "NonClosure.v:not_closed_under_substitution"
      | GsmMapping => no "NonClosure.v:not_closed_under_gsm_mapping"
      | _ => None
      end
    end
  | IL => match o with Reversal => yes "Reversal.v:interacting_reversal" | _ => None end
  | _ => None
  end.

Definition right (o : operation) (f : family) (sign : bool) : Prop := if sign then closed o f else ~ closed o f.
Ltac settle := intros [= <- <-]; cbn [right].
Theorem table_is_right o f sign name : cell o f = Some (sign, name) -> right o f sign.
Proof.
  destruct f as [| |k|].
  - easy.
  - easy.
  - assert (p : extended k = false -> pure k) by easy. revert p. cbn.
    destruct o; intro p; try (settle; apply lsystem_reversal); destruct (extended k); try easy; specialize (p eq_refl).
    + settle. now apply not_closed_under_union.
    + settle. now apply not_closed_under_concatenation.
    + destruct (propagating k) eqn:Pk; [|easy]. settle. now apply propagating_not_closed_under_star.
    + settle. now apply not_closed_under_intersection.
    + settle. now apply not_closed_under_intersection_with_regular.
    + settle. now apply not_closed_under_complement.
    + settle. now apply not_closed_under_homomorphism.
    + settle. now apply not_closed_under_non_erasing_homomorphism.
    + settle. now apply not_closed_under_inverse_homomorphism.
    + settle. now apply not_closed_under_finite_substitution.
    + settle. now apply not_closed_under_substitution.
    + settle. now apply not_closed_under_gsm_mapping.
  - destruct o; try easy. settle. apply interacting_reversal.
Qed.
