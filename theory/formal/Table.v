(* The table: what is proved of each operation and family, and by which theorem.  [None] says that nothing is. *)
From Coq Require Import String.
From Algae Require Import Words Reversal Obstruction NonClosure Complement Regular AbstractFamily ContextFree Runs Extended Substitution OneTable GapsExtended Repetitions Star Pumping
  Interactions InteractionsMarked InteractionsComplement.
Open Scope string_scope.

Definition yes (name : string) := Some (true, name).
Definition no (name : string) := Some (false, name).

Definition regular_cell (o : operation) : option (bool * string) :=
  match o with
  | Union => yes "AbstractFamily.v:regular_union"
  | Concatenation => yes "AbstractFamily.v:regular_concatenation"
  | Star => yes "AbstractFamily.v:regular_star"
  | Plus => yes "AbstractFamily.v:regular_plus"
  | Intersection => yes "Regular.v:regular_intersection"
  | IntersectionWithRegular => yes "Regular.v:regular_intersection_with_regular"
  | Complement => yes "Regular.v:regular_complement"
  | Homomorphism => yes "AbstractFamily.v:regular_homomorphism"
  | NonErasingHomomorphism => yes "AbstractFamily.v:regular_non_erasing_homomorphism"
  | InverseHomomorphism => yes "AbstractFamily.v:regular_inverse_homomorphism"
  | Reversal => yes "Regular.v:regular_reversal"
  | FiniteSubstitution => yes "AbstractFamily.v:regular_finite_substitution"
  | Substitution => yes "Regular.v:regular_substitution"
  | GsmMapping => yes "AbstractFamily.v:regular_gsm_mapping"
  end.
Definition context_free_cell (o : operation) : option (bool * string) :=
  match o with
  | Union => yes "ContextFree.v:context_free_union"
  | Concatenation => yes "ContextFree.v:context_free_concatenation"
  | Star => yes "ContextFree.v:context_free_star"
  | Plus => yes "ContextFree.v:context_free_plus"
  | Intersection => no "Pumping.v:context_free_not_closed_under_intersection"
  | IntersectionWithRegular => yes "ContextFree.v:context_free_intersection_with_regular"
  | Complement => no "Pumping.v:context_free_not_closed_under_complement"
  | Homomorphism => yes "ContextFree.v:context_free_homomorphism"
  | NonErasingHomomorphism => yes "ContextFree.v:context_free_non_erasing_homomorphism"
  | InverseHomomorphism => yes "ContextFree.v:context_free_inverse_homomorphism"
  | Reversal => yes "ContextFree.v:context_free_reversal"
  | FiniteSubstitution => yes "ContextFree.v:context_free_finite_substitution"
  | Substitution => yes "ContextFree.v:context_free_substitution"
  | GsmMapping => yes "ContextFree.v:context_free_gsm_mapping"
  end.
(* without nonterminals *)
Definition pure_cell (o : operation) : option (bool * string) :=
  match o with
  | Union => no "NonClosure.v:not_closed_under_union"
  | Concatenation => no "NonClosure.v:not_closed_under_concatenation"
  | Star => no "Star.v:not_closed_under_star"
  | Plus => no "Star.v:not_closed_under_plus"
  | Intersection => no "NonClosure.v:not_closed_under_intersection"
  | IntersectionWithRegular => no "NonClosure.v:not_closed_under_intersection_with_regular"
  | Complement => no "Complement.v:not_closed_under_complement"
  | Homomorphism => no "NonClosure.v:not_closed_under_homomorphism"
  | NonErasingHomomorphism => no "NonClosure.v:not_closed_under_non_erasing_homomorphism"
  | InverseHomomorphism => no "NonClosure.v:not_closed_under_inverse_homomorphism"
  | Reversal => yes "Reversal.v:lsystem_reversal"
  | FiniteSubstitution => no "NonClosure.v:not_closed_under_finite_substitution"
  | Substitution => no "NonClosure.v:not_closed_under_substitution"
  | GsmMapping => no "NonClosure.v:not_closed_under_gsm_mapping"
  end.
(* with nonterminals: E0L, ET0L, EDT0L *)
Definition extended_cell (many one : bool) (o : operation) : option (bool * string) :=
  match o with
  | Union => yes "OneTable.v:extended_union"
  | Concatenation => yes "OneTable.v:extended_concatenation"
  | Star => yes "OneTable.v:extended_star"
  | Plus => yes "OneTable.v:extended_plus"
  | Intersection => no "GapsExtended.v:extended_not_closed_under_intersection"
  | IntersectionWithRegular => yes "OneTable.v:extended_intersection_with_regular"
  | Complement => no "GapsExtended.v:extended_not_closed_under_complement"
  | Homomorphism => yes "OneTable.v:extended_homomorphism"
  | NonErasingHomomorphism => yes "OneTable.v:extended_non_erasing_homomorphism"
  | InverseHomomorphism => match many, one with
    | true, false => yes "OneTable.v:et0l_inverse_homomorphism" | true, true => no "Repetitions.v:edt0l_not_closed_under_inverse_homomorphism" | _, _ => None end
  | Reversal => yes "Reversal.v:lsystem_reversal"
  | FiniteSubstitution => if one then no "Repetitions.v:edt0l_not_closed_under_finite_substitution" else yes "OneTable.v:extended_finite_substitution"
  | Substitution => match many, one with
    | true, false => yes "OneTable.v:et0l_substitution" | true, true => no "Repetitions.v:edt0l_not_closed_under_substitution" | _, _ => None end
  | GsmMapping => if one then no "Repetitions.v:edt0l_not_closed_under_gsm_mapping" else yes "OneTable.v:extended_gsm_mapping"
  end.
Definition interacting_cell (o : operation) : option (bool * string) :=
  match o with
  | Union => no "Interactions.v:interacting_not_closed_under_union"
  | Concatenation => no "Interactions.v:interacting_not_closed_under_concatenation"
  | Star => None
  | Plus => None
  | Intersection => no "InteractionsMarked.v:interacting_not_closed_under_intersection"
  | IntersectionWithRegular => no "InteractionsMarked.v:interacting_not_closed_under_intersection_with_regular"
  | Complement => no "InteractionsComplement.v:interacting_not_closed_under_complement"
  | Homomorphism => no "Interactions.v:interacting_not_closed_under_homomorphism"
  | NonErasingHomomorphism => no "Interactions.v:interacting_not_closed_under_non_erasing_homomorphism"
  | InverseHomomorphism => no "InteractionsMarked.v:interacting_not_closed_under_inverse_homomorphism"
  | Reversal => yes "Reversal.v:interacting_reversal"
  | FiniteSubstitution => no "Interactions.v:interacting_not_closed_under_finite_substitution"
  | Substitution => no "Interactions.v:interacting_not_closed_under_substitution"
  | GsmMapping => no "InteractionsMarked.v:interacting_not_closed_under_gsm_mapping"
  end.

Definition cell (o : operation) (f : family) : option (bool * string) :=
  match f with
  | REG => regular_cell o
  | CF => context_free_cell o
  | IL => interacting_cell o
  | LSystem k =>
    if extended k then
      if propagating k || (deterministic k && negb (tabled k)) then None else extended_cell (tabled k) (deterministic k) o
    else pure_cell o
  end.

Definition holds (o : operation) (f : family) (sign : bool) : Prop := if sign then closed o f else ~ closed o f.
Local Ltac by_theorem T := intros [= <- <-]; cbn [holds]; now apply T.

Lemma regular_right o sign name : regular_cell o = Some (sign, name) -> holds o REG sign.
Proof.
  destruct o; [by_theorem regular_union|by_theorem regular_concatenation|by_theorem regular_star|by_theorem regular_plus|
    by_theorem regular_intersection|by_theorem regular_intersection_with_regular|by_theorem regular_complement|
    by_theorem regular_homomorphism|by_theorem regular_non_erasing_homomorphism|by_theorem regular_inverse_homomorphism|
    by_theorem regular_reversal|by_theorem regular_finite_substitution|by_theorem regular_substitution|by_theorem regular_gsm_mapping].
Qed.
Lemma context_free_right o sign name : context_free_cell o = Some (sign, name) -> holds o CF sign.
Proof.
  destruct o; [by_theorem context_free_union|by_theorem context_free_concatenation|by_theorem context_free_star|by_theorem context_free_plus|
    by_theorem context_free_not_closed_under_intersection|by_theorem context_free_intersection_with_regular|by_theorem context_free_not_closed_under_complement|
    by_theorem context_free_homomorphism|by_theorem context_free_non_erasing_homomorphism|by_theorem context_free_inverse_homomorphism|
    by_theorem context_free_reversal|by_theorem context_free_finite_substitution|by_theorem context_free_substitution|by_theorem context_free_gsm_mapping].
Qed.
Lemma pure_right k o sign name : pure k -> pure_cell o = Some (sign, name) -> holds o (LSystem k) sign.
Proof.
  intro p. destruct o; cbn [pure_cell]; [by_theorem not_closed_under_union|by_theorem not_closed_under_concatenation|by_theorem not_closed_under_star|by_theorem not_closed_under_plus|
    by_theorem not_closed_under_intersection|by_theorem not_closed_under_intersection_with_regular|by_theorem not_closed_under_complement|
    by_theorem not_closed_under_homomorphism|by_theorem not_closed_under_non_erasing_homomorphism|by_theorem not_closed_under_inverse_homomorphism|
    by_theorem lsystem_reversal|by_theorem not_closed_under_finite_substitution|by_theorem not_closed_under_substitution|by_theorem not_closed_under_gsm_mapping].
Qed.
Lemma extended_right many one o sign name : (one = true -> many = true) ->
  extended_cell many one o = Some (sign, name) -> holds o (LSystem (E_kind many one)) sign.
Proof.
  intro H. destruct o; cbn [extended_cell]; [by_theorem extended_union|by_theorem extended_concatenation|by_theorem extended_star|by_theorem extended_plus|
    by_theorem extended_not_closed_under_intersection|by_theorem extended_intersection_with_regular|
    by_theorem extended_not_closed_under_complement|by_theorem extended_homomorphism|by_theorem extended_non_erasing_homomorphism| |
    by_theorem lsystem_reversal| | |].
  - destruct many, one; try easy; [by_theorem edt0l_not_closed_under_inverse_homomorphism|by_theorem et0l_inverse_homomorphism].
  - destruct one; [rewrite (H eq_refl); by_theorem edt0l_not_closed_under_finite_substitution|by_theorem extended_finite_substitution].
  - destruct many, one; try easy; [by_theorem edt0l_not_closed_under_substitution|by_theorem et0l_substitution].
  - destruct one; [rewrite (H eq_refl); by_theorem edt0l_not_closed_under_gsm_mapping|by_theorem extended_gsm_mapping].
Qed.
Lemma interacting_right o sign name : interacting_cell o = Some (sign, name) -> holds o IL sign.
Proof.
  destruct o; [by_theorem interacting_not_closed_under_union|by_theorem interacting_not_closed_under_concatenation|easy|easy|
    by_theorem interacting_not_closed_under_intersection|by_theorem interacting_not_closed_under_intersection_with_regular|
    by_theorem interacting_not_closed_under_complement|by_theorem interacting_not_closed_under_homomorphism|
    by_theorem interacting_not_closed_under_non_erasing_homomorphism|by_theorem interacting_not_closed_under_inverse_homomorphism|
    by_theorem interacting_reversal|by_theorem interacting_not_closed_under_finite_substitution|
    by_theorem interacting_not_closed_under_substitution|by_theorem interacting_not_closed_under_gsm_mapping].
Qed.

Theorem table_is_right o f sign name : cell o f = Some (sign, name) -> holds o f sign.
Proof.
  destruct f as [| |[many one p e]|]; cbn [cell]; [apply regular_right|apply context_free_right| |apply interacting_right].
  cbn [extended propagating deterministic tabled]. destruct e.
  - destruct p; [easy|]. destruct many, one; try easy; now apply extended_right.
  - now apply pure_right.
Qed.

(* ---- as text: a line for each cell ---- *)
Definition operation_name (o : operation) : string :=
  match o with
  | Union => "union" | Concatenation => "concatenation" | Star => "star" | Plus => "plus" | Intersection => "intersection"
  | IntersectionWithRegular => "intersection with regular" | Complement => "complement" | Homomorphism => "homomorphism"
  | NonErasingHomomorphism => "non-erasing homomorphism" | InverseHomomorphism => "inverse homomorphism" | Reversal => "reversal"
  | FiniteSubstitution => "finite substitution" | Substitution => "substitution" | GsmMapping => "gsm mapping"
  end.
Definition family_name (f : family) : string :=
  match f with
  | REG => "REG" | CF => "CF" | IL => "IL"
  | LSystem (Kind t d p e) => (if e then "E" else "") ++ (if p then "P" else "") ++ (if d then "D" else "") ++ (if t then "T" else "") ++ "0L"
  end.
Definition line (o : operation) (f : family) : string :=
  operation_name o ++ "; " ++ family_name f ++ "; " ++
  match cell o f with Some (true, name) => "closed; " ++ name | Some (false, name) => "not closed; " ++ name | None => "open; -" end.
Definition lines : list string := flat_map (fun o => map (line o) families) operations.
Definition proved : nat := List.length (filter (fun z => match cell (fst z) (snd z) with Some _ => true | None => false end) (list_prod operations families)).
