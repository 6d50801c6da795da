(* What the theorems of this folder speak of: words, languages, families, operations, and what it means that a
   family is closed under an operation.  Who believes Coq and these definitions has to read nothing else. *)
From Coq Require Export List Bool Arith Lia.
Export ListNotations.

(* An alphabet is a finite set whose letters can be told apart.  It may be empty. *)
Class Alphabet (A : Set) := {
  letter_eq : forall x y : A, {x = y} + {x <> y};
  letters : list A;
  all_letters : forall x : A, In x letters }.

Definition language (A : Set) := list A -> Prop.
Definition same {A : Set} (X Y : language A) := forall w, X w <-> Y w.

(* Every letter x of a word is replaced by a word u with R x u, all at once. *)
Inductive parallel {V W : Set} (R : V -> list W -> Prop) : list V -> list W -> Prop :=
| parallel_nil : parallel R [] []
| parallel_cons x u v w : R x u -> parallel R v w -> parallel R (x :: v) (u ++ w).

(* A table gives every letter its successors.  A system derives its words from the axiom, by one table a step. *)
Definition table (V : Set) := V -> list (list V).
Definition step {V : Set} (t : table V) := parallel (fun x u => In u (t x)).
Record system (V : Set) := System { axiom : list V; tables : list (table V) }.
Arguments System {V}. Arguments axiom {V}. Arguments tables {V}.

Inductive derives {V : Set} (ts : list (table V)) (u : list V) : list V -> Prop :=
| derives_itself : derives ts u u
| derives_step v w t : derives ts u v -> In t ts -> step t v w -> derives ts u w.
Definition generates {V : Set} (G : system V) := derives (tables G) (axiom G).

(* The letters in the names of families.  T: any number of tables, else one.  D: one successor for each letter.
   P: no successor is empty.  E: there may be letters that are not terminals. *)
Record kind := Kind { tabled : bool; deterministic : bool; propagating : bool; extended : bool }.
Definition of_kind {V : Set} (k : kind) (G : system V) : Prop :=
  axiom G <> [] /\ tables G <> [] /\ (tabled k = false -> length (tables G) = 1) /\
  forall t x, In t (tables G) -> t x <> [] /\
    (deterministic k = true -> forall u v, In u (t x) -> In v (t x) -> u = v) /\ (propagating k = true -> ~ In [] (t x)).
Definition lsystem {A : Set} (k : kind) (X : language A) : Prop :=
  if extended k then exists (N : Set) (_ : Alphabet N) (G : system (N + A)), of_kind k G /\ same X (fun w => generates G (map inr w))
  else exists G : system A, of_kind k G /\ same X (generates G).

(* A system with interactions: the successors of a letter depend on the nearest letters on its left, at most
   [left_width], the nearest first, and on its right, at most [right_width].  Only near the ends are there fewer. *)
Record interactive (A : Set) := Interactive {
  first_word : list A; left_width : nat; right_width : nat; successors : list A -> A -> list A -> list (list A) }.
Arguments Interactive {A}. Arguments first_word {A}. Arguments left_width {A}. Arguments right_width {A}. Arguments successors {A}.
Inductive context_step {A : Set} (G : interactive A) : list A -> list A -> list A -> Prop :=
| context_nil p : context_step G p [] []
| context_cons p x v u w : In u (successors G (firstn (left_width G) p) x (firstn (right_width G) v)) ->
    context_step G (x :: p) v w -> context_step G p (x :: v) (u ++ w).
Inductive context_generates {A : Set} (G : interactive A) : list A -> Prop :=
| context_axiom : context_generates G (first_word G)
| context_next v w : context_generates G v -> context_step G [] v w -> context_generates G w.
Definition interacting {A : Set} (X : language A) : Prop := exists G : interactive A,
  first_word G <> [] /\ (forall p x q, successors G p x q <> []) /\ same X (context_generates G).

(* Regular languages: deterministic automata.  Context-free languages: grammars. *)
Record automaton (A Q : Set) := Automaton { initial : Q; next : Q -> A -> Q; final : Q -> bool }.
Arguments Automaton {A Q}. Arguments initial {A Q}. Arguments next {A Q}. Arguments final {A Q}.
Definition accepts {A Q : Set} (M : automaton A Q) : language A := fun w => final M (fold_left (next M) w (initial M)) = true.
Definition regular {A : Set} (X : language A) : Prop :=
  exists (Q : Set) (_ : Alphabet Q) (M : automaton A Q), same X (accepts M).

Record grammar (A N : Set) := Grammar { start : N; rules : N -> list (list (N + A)) }.
Arguments Grammar {A N}. Arguments start {A N}. Arguments rules {A N}.
Inductive rewrites {A N : Set} (G : grammar A N) (z : list (N + A)) : list (N + A) -> Prop :=
| rewrites_itself : rewrites G z z
| rewrites_step u X v r : rewrites G z (u ++ inl X :: v) -> In r (rules G X) -> rewrites G z (u ++ r ++ v).
Definition context_free {A : Set} (X : language A) : Prop :=
  exists (N : Set) (_ : Alphabet N) (G : grammar A N), same X (fun w => rewrites G [inl (start G)] (map inr w)).

(* The families of the table. *)
Inductive family := REG | CF | LSystem (k : kind) | IL.
Definition D0L := LSystem (Kind false true false false).  Definition PD0L := LSystem (Kind false true true false).
Definition OL := LSystem (Kind false false false false).  Definition P0L := LSystem (Kind false false true false).
Definition DT0L := LSystem (Kind true true false false).  Definition PDT0L := LSystem (Kind true true true false).
Definition T0L := LSystem (Kind true false false false).  Definition PT0L := LSystem (Kind true false true false).
Definition E0L := LSystem (Kind false false false true).  Definition ET0L := LSystem (Kind true false false true).
Definition EDT0L := LSystem (Kind true true false true).
Definition families := [REG; CF; D0L; PD0L; OL; P0L; DT0L; PDT0L; T0L; PT0L; E0L; ET0L; EDT0L; IL].
Definition is {A : Set} (f : family) (X : language A) : Prop :=
  match f with REG => regular X | CF => context_free X | LSystem k => lsystem k X | IL => interacting X end.

(* Operations.  A homomorphism replaces every letter by a word, a finite substitution by a word of a finite set,
   a substitution by a word of a language. *)
Definition union {A : Set} (X Y : language A) : language A := fun w => X w \/ Y w.
Definition intersection {A : Set} (X Y : language A) : language A := fun w => X w /\ Y w.
Definition complement {A : Set} (X : language A) : language A := fun w => ~ X w.
Definition concatenation {A : Set} (X Y : language A) : language A := fun w => exists u v, w = u ++ v /\ X u /\ Y v.
Definition star {A : Set} (X : language A) : language A := fun w => exists us, w = concat us /\ forall u, In u us -> X u.
Definition plus {A : Set} (X : language A) : language A :=
  fun w => exists us, us <> [] /\ w = concat us /\ forall u, In u us -> X u.
Definition reversal {A : Set} (X : language A) : language A := fun w => X (rev w).
Definition substitution {A B : Set} (s : A -> language B) (X : language A) : language B := fun w => exists u, X u /\ parallel s u w.
Definition finite_substitution {A B : Set} (s : A -> list (list B)) := substitution (fun a u => In u (s a)).
Definition image {A B : Set} (h : A -> list B) (X : language A) : language B := fun w => exists u, X u /\ w = flat_map h u.
Definition inverse_image {A B : Set} (h : A -> list B) (X : language B) : language A := fun w => X (flat_map h w).

(* A generalised sequential machine reads a word letter by letter, writes a word for each letter, and may choose. *)
Record machine (A B Q : Set) := Machine { first : Q; moves : Q -> A -> list (list B * Q); accepting : Q -> bool }.
Arguments Machine {A B Q}. Arguments first {A B Q}. Arguments moves {A B Q}. Arguments accepting {A B Q}.
Inductive translates {A B Q : Set} (M : machine A B Q) : Q -> list A -> list B -> Prop :=
| translates_nil q : accepting M q = true -> translates M q [] []
| translates_cons q a p u v w : In (u, p) (moves M q a) -> translates M p v w -> translates M q (a :: v) (u ++ w).
Definition translation {A B Q : Set} (M : machine A B Q) (X : language A) : language B :=
  fun w => exists v, X v /\ translates M (first M) v w.

Inductive operation := Union | Concatenation | Star | Plus | Intersection | IntersectionWithRegular | Complement
  | Homomorphism | NonErasingHomomorphism | InverseHomomorphism | Reversal | FiniteSubstitution | Substitution | GsmMapping.
Definition operations := [Union; Concatenation; Star; Plus; Intersection; IntersectionWithRegular; Complement; Homomorphism;
  NonErasingHomomorphism; InverseHomomorphism; Reversal; FiniteSubstitution; Substitution; GsmMapping].

(* A family is closed under an operation if, over all alphabets, the result is in the family where the operands are. *)
Definition closed (o : operation) (f : family) : Prop := forall (A : Set) (_ : Alphabet A),
  let unary (op : language A -> language A) := forall X, is f X -> is f (op X) in
  let binary (op : language A -> language A -> language A) := forall X Y, is f X -> is f Y -> is f (op X Y) in
  match o with
  | Union => binary union
  | Concatenation => binary concatenation
  | Star => unary star
  | Plus => unary plus
  | Intersection => binary intersection
  | IntersectionWithRegular => forall X (R : language A), is f X -> regular R -> is f (intersection X R)
  | Complement => unary complement
  | Reversal => unary reversal
  | Homomorphism => forall (B : Set) (_ : Alphabet B) (h : A -> list B) X, is f X -> is f (image h X)
  | NonErasingHomomorphism => forall (B : Set) (_ : Alphabet B) (h : A -> list B) X, (forall a, h a <> []) -> is f X -> is f (image h X)
  | InverseHomomorphism => forall (B : Set) (_ : Alphabet B) (h : A -> list B) X, is f X -> is f (inverse_image h X)
  | FiniteSubstitution => forall (B : Set) (_ : Alphabet B) (s : A -> list (list B)) X, is f X -> is f (finite_substitution s X)
  | Substitution => forall (B : Set) (_ : Alphabet B) (s : A -> language B) X, is f X -> (forall a, is f (s a)) -> is f (substitution s X)
  | GsmMapping => forall (B Q : Set) (_ : Alphabet B) (_ : Alphabet Q) (M : machine A B Q) X, is f X -> is f (translation M X)
  end.
