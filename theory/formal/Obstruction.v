(* A procedure that tries to show of a finite language K that no L-system without nonterminals generates it, and the
   proof that it is right when it says so.

   Suppose that a system generates K.  Each of its tables leads from words of K to words of K only, so the successors of
   a letter in K are factors of words of K.  Some step leads from a set U of words that has the axiom to a word of K
   outside of U, if there is one.  The procedure takes every way in which that step may act on the letters, then all
   successors of other letters, until known rules lead out of K. *)
From Algae Require Import Words.

Section Obstruction.
  Context {A : Set} {alphabet : Alphabet A}.
  Notation rule := (A * list A)%type.
  Variables functional nonerasing : bool.
  Variable K : list (list A).

  Definition in_K (w : list A) : bool := if in_dec word_eq w K then true else false.
  Definition member (w : list A) (U : list (list A)) : bool := if in_dec word_eq w U then true else false.
  Lemma member_in w U : member w U = true <-> In w U.
  Proof. unfold member. destruct in_dec; intuition congruence. Qed.
  Lemma member_out w U : member w U = false <-> ~ In w U.
  Proof. unfold member. destruct in_dec; intuition congruence. Qed.

  Fixpoint cuts (v : list A) : list (list A * list A) :=
    ([], v) :: match v with [] => [] | x :: v' => map (fun c => (x :: fst c, snd c)) (cuts v') end.
  Lemma cuts_have p s : In (p, s) (cuts (p ++ s)).
  Proof. induction p as [|x p IH]; [destruct s; now left|]. right. apply in_map_iff. now exists (p, s). Qed.
  Definition factors (w : list A) : list (list A) := flat_map (fun c => map fst (cuts (snd c))) (cuts w).
  Lemma factors_have p u s : In u (factors (p ++ u ++ s)).
  Proof.
    apply in_flat_map. exists (p, u ++ s). split; [apply cuts_have|]. apply in_map_iff. exists (u, s). split; auto. apply cuts_have.
  Qed.

  (* all ways in which u may derive v, as lists of rules *)
  Fixpoint ways (u v : list A) : list (list rule) :=
    match u with
    | [] => match v with [] => [[]] | _ => [] end
    | x :: u => flat_map (fun c => map (cons (x, fst c)) (ways u (snd c))) (cuts v)
    end.
  Lemma ways_have (R : A -> list A -> Prop) u v : parallel R u v -> exists rs, In rs (ways u v) /\ forall r, In r rs -> R (fst r) (snd r).
  Proof.
    induction 1 as [|x p u v H _ (rs & I & F)]; cbn; [exists []; cbn; intuition|].
    exists ((x, p) :: rs). split; [|intros r [<-|J]; auto]. apply in_flat_map. exists (p, v). split; [apply cuts_have|now apply in_map].
  Qed.

  (* the words that known rules make of w *)
  Fixpoint results (rs : list rule) (w : list A) : list (list A) :=
    match w with
    | [] => [[]]
    | x :: w => flat_map (fun r => if letter_eq (fst r) x then map (app (snd r)) (results rs w) else []) rs
    end.
  Lemma results_derived (R : A -> list A -> Prop) rs w v : (forall r, In r rs -> R (fst r) (snd r)) -> In v (results rs w) -> parallel R w v.
  Proof.
    intro F. revert v. induction w as [|x w IH]; cbn; intro v; [intros [<-|[]]; auto|].
    intros (r & I & H)%in_flat_map. destruct (letter_eq (fst r) x) as [<-|]; [|easy].
    apply in_map_iff in H as (v' & <- & H). auto.
  Qed.

  Definition clash (rs : list rule) : bool :=
    existsb (fun r => existsb (fun s => (if letter_eq (fst r) (fst s) then true else false) &&
      (if word_eq (snd r) (snd s) then false else true)) rs) rs.
  Definition erases (rs : list rule) : bool := existsb (fun r => match snd r with [] => true | _ => false end) rs.
  Definition contradictory (rs : list rule) : bool :=
    functional && clash rs || nonerasing && erases rs || existsb (fun w => existsb (fun v => negb (member v K)) (results rs w)) K.
  Definition knows (rs : list rule) (x : A) : bool := existsb (fun r => if letter_eq (fst r) x then true else false) rs.
  Definition unknown (rs : list rule) : option A := find (fun x => negb (knows rs x)) (concat K).
  Definition images : list (list A) := nodup word_eq (flat_map factors K).

  Fixpoint refuted (n : nat) (rs : list rule) : bool :=
    match n with
    | 0 => false
    | S n => if contradictory rs then true else
             match unknown rs with None => false | Some x => forallb (fun u => refuted n ((x, u) :: rs)) images end
    end.

  (* what a table of a system that generates K is like *)
  Record keeps (R : A -> list A -> Prop) : Prop := {
    total : forall x, exists u, R x u;
    stays : forall w v, In w K -> parallel R w v -> In v K;
    is_functional : functional = true -> forall x u v, R x u -> R x v -> u = v;
    is_nonerasing : nonerasing = true -> forall x, ~ R x [] }.

  Lemma contradiction (R : A -> list A -> Prop) rs : keeps R -> (forall r, In r rs -> R (fst r) (snd r)) -> contradictory rs = true -> False.
  Proof.
    intros M F. unfold contradictory. rewrite !orb_true_iff, !andb_true_iff. intros [[(f & C)|(e & C)]|C].
    - apply existsb_exists in C as (r & I & C). apply existsb_exists in C as (s & J & C).
      apply andb_true_iff in C as (C1 & C2). destruct (letter_eq (fst r) (fst s)) as [Q|]; [|easy].
      destruct (word_eq (snd r) (snd s)) as [|N]; [easy|]. apply N, (is_functional R M f (fst r)); auto. rewrite Q. auto.
    - apply existsb_exists in C as ((x & [|]) & I & C); [|easy]. apply (is_nonerasing R M e x), (F _ I).
    - apply existsb_exists in C as (w & I & C). apply existsb_exists in C as (v & J & C).
      apply negb_true_iff, member_out in C. apply C, (stays R M w); auto. eapply results_derived; eauto.
  Qed.
  Lemma image_known (R : A -> list A -> Prop) x u : keeps R -> In x (concat K) -> R x u -> In u images.
  Proof.
    intros M (w & I & (p & s & ->)%in_split)%in_concat H. destruct (parallel_exists R p) as (p' & Hp); [intros; apply (total R M)|].
    destruct (parallel_exists R s) as (s' & Hs); [intros; apply (total R M)|].
    apply nodup_In, in_flat_map. exists (p' ++ u ++ s'). split; [|apply factors_have].
    apply (stays R M _ _ I). auto using parallel_append.
  Qed.
  Lemma refuted_right (R : A -> list A -> Prop) n rs : keeps R -> (forall r, In r rs -> R (fst r) (snd r)) -> refuted n rs = true -> False.
  Proof.
    intro M. revert rs. induction n as [|n IH]; cbn; [easy|]. intros rs F. destruct (contradictory rs) eqn:C.
    - intros _. exact (contradiction R rs M F C).
    - unfold unknown. destruct find as [x|] eqn:Q; [|easy]. intro H. apply find_some in Q as (I & _).
      destruct (total R M x) as (u & Hu). rewrite forallb_forall in H.
      apply (IH ((x, u) :: rs)); [|apply H; eauto using image_known]. intros r [<-|J]; auto.
  Qed.

  (* the steps from U to words of K outside, and those of them that are not refuted *)
  Definition crossings (U : list (list A)) : list (list A * list rule) :=
    flat_map (fun u => flat_map (fun v => if member v U then [] else map (pair v) (ways u v)) K) U.
  Definition open_crossings n U := filter (fun c => negb (refuted n (snd c))) (crossings U).
  Fixpoint unreachable (n m : nat) (U : list (list A)) : bool :=
    match m with
    | 0 => false
    | S m => match open_crossings n U with
             | [] => existsb (fun v => negb (member v U)) K
             | c :: _ => unreachable n m (fst c :: U)
             end
    end.
  Definition excluded (n : nat) : bool :=
    forallb (fun w => match w with [] => true | _ => unreachable n (S (length K)) [w] end) K.

  Lemma first_crossing (ts : list (table A)) w v U : derives ts w v -> In w U -> ~ In v U ->
    exists t u u', In t ts /\ derives ts w u /\ step t u u' /\ In u U /\ ~ In u' U.
  Proof.
    intros H I. induction H as [|u v t H IH J S]; [easy|]. intro N. destruct (in_dec word_eq u U) as [Iu|Nu]; [|auto].
    exists t, u, v. auto 6.
  Qed.
  Lemma unreachable_right (ts : list (table A)) w n m U :
    (forall v, In v K <-> derives ts w v) -> (forall t, In t ts -> keeps (fun x u => In u (t x))) ->
    In w U -> unreachable n m U = true -> False.
  Proof.
    intros S M. revert U. induction m as [|m IH]; cbn; [easy|]. intros U I. destruct (open_crossings n U) as [|c cs] eqn:Q.
    - intros (v & J & N%negb_true_iff%member_out)%existsb_exists.
      destruct (first_crossing ts w v U) as (t & u & u' & It & H & P & Iu & Nu); auto; [now apply S|].
      destruct (ways_have _ _ _ P) as (rs & Ir & F).
      assert (B : In (u', rs) (crossings U)).
      { apply in_flat_map. exists u. split; auto. apply in_flat_map. exists u'. split; [apply S; eauto|].
        apply member_out in Nu as ->. now apply in_map. }
      destruct (refuted n rs) eqn:C; [exact (refuted_right _ n rs (M t It) F C)|].
      assert (In (u', rs) (open_crossings n U)) by (apply filter_In; cbn; now rewrite C). now rewrite Q in *.
    - intro H. apply (IH (fst c :: U)); auto. now right.
  Qed.

  Theorem excluded_right n k : extended k = false -> (functional = true -> deterministic k = true) ->
    (nonerasing = true -> propagating k = true) -> excluded n = true -> ~ lsystem k (fun w => In w K).
  Proof.
    unfold excluded, lsystem. rewrite forallb_forall. intros -> d p H (G & (a & _ & _ & g) & S).
    assert (I : In (axiom G) K) by (apply S; constructor). specialize (H _ I).
    destruct (axiom G) as [|x w] eqn:Q; [easy|]. rewrite <- Q in *.
    apply (unreachable_right (tables G) (axiom G) n _ [axiom G] S) in H; auto; [|now left].
    intros t It. split.
    - intro x'. destruct (g t x' It) as (s & _). destruct (t x') as [|u us]; [easy|]. exists u. now left.
    - intros v w' Iv Hw. apply S. apply (derives_step _ _ v w' t); auto. now apply S.
    - intros f x' u v. apply (g t x' It). auto.
    - intros e x'. apply (g t x' It). auto.
  Qed.
End Obstruction.

(* With nothing assumed of the tables, no family without nonterminals has the language. *)
Definition pure (k : kind) := extended k = false.
Lemma in_no_pure_family {A : Set} {a : Alphabet A} K n k : pure k -> excluded false false K n = true -> ~ is (LSystem k) (fun w => In w K).
Proof. intros p H. now apply (excluded_right false false K n). Qed.

Notation a := false.
Notation b := true.
Theorem a_or_aa k : pure k -> ~ is (LSystem k) (fun w => In w [[tt]; [tt; tt]]).
Proof. intro p. apply (in_no_pure_family _ 20); [exact p|vm_compute; reflexivity]. Qed.
Theorem aa_or_abb k : pure k -> ~ is (LSystem k) (fun w => In w [[a; a]; [a; b; b]]).
Proof. intro p. apply (in_no_pure_family _ 20); [exact p|vm_compute; reflexivity]. Qed.
Theorem ab_or_ba_or_aaa k : pure k -> ~ is (LSystem k) (fun w => In w [[a; b]; [b; a]; [a; a; a]]).
Proof. intro p. apply (in_no_pure_family _ 20); [exact p|vm_compute; reflexivity]. Qed.
Theorem ab_or_aabb k : pure k -> ~ is (LSystem k) (fun w => In w [[a; b]; [a; a; b; b]]).
Proof. intro p. apply (in_no_pure_family _ 20); [exact p|vm_compute; reflexivity]. Qed.
