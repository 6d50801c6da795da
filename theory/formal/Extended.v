(* E0L, ET0L and EDT0L languages, in the form of Runs.v: finite substitutions and intersection with regular languages. *)
From Algae Require Import Words Runs.

Lemma incl_map_back {X Y : Type} (f : X -> Y) l l' : incl l' (map f l) -> exists l0, l' = map f l0 /\ incl l0 l.
Proof.
  induction l' as [|y l' IH]; intro I; [now exists []|]. destruct IH as (l0 & -> & J); [intros z K; apply I; now right|].
  destruct (proj1 (in_map_iff _ _ _) (I y ltac:(now left))) as (x & <- & K). exists (x :: l0). split; auto. intros z [<-|]; auto.
Qed.

(* ---- finite substitutions ---- *)
Section Results.
  Context {A B : Set}.
  Variable s : A -> list (list B).
  Fixpoint results (u : list A) : list (list B) :=
    match u with [] => [[]] | x :: u => flat_map (fun v => map (app v) (results u)) (s x) end.
  Lemma results_in u w : In w (results u) <-> parallel (fun x v => In v (s x)) u w.
  Proof.
    revert w. induction u as [|x u IH]; cbn; intro w.
    - rewrite parallel_empty. intuition.
    - rewrite parallel_first, in_flat_map. split.
      + intros (v & I & (w' & <- & J)%in_map_iff). exists v, w'. split; auto. split; auto. now apply IH.
      + intros (v & w' & -> & I & J). exists v. split; auto. apply in_map. now apply IH.
  Qed.
End Results.
Theorem runs_finite_substitution {A B : Set} many one (s : A -> list (list B)) (X : language A) :
  (one = true -> forall x, at_most_one (s x)) -> runs many one X -> runs many one (finite_substitution s X).
Proof.
  intros Os (V & v & starts & ts & fin & m & o & S). exists V, v, starts, ts, (fun x => flat_map (results s) (fin x)).
  split; [auto|split].
  - intros O x. destruct (o O x) as (o1 & o2). split; auto. intros w w' (u & I & J)%in_flat_map (u' & I' & J')%in_flat_map.
    rewrite (o1 u' u I' I) in J'. apply results_in in J, J'. revert J J'. apply parallel_once. intros y p q _. now apply Os.
  - assert (Q : forall ts' x w, run (fun x => flat_map (results s) (fin x)) ts' x w <-> exists u, run fin ts' x u /\ parallel (fun x v => In v (s x)) u w).
    { induction ts' as [|t ts' IH]; intros x w; cbn.
      - rewrite in_flat_map. now setoid_rewrite results_in.
      - assert (E : forall u, parallel (run (fun x => flat_map (results s) (fin x)) ts') u w <->
            exists u', parallel (run fin ts') u u' /\ parallel (fun x v => In v (s x)) u' w).
        { intro u. rewrite <- parallel_compose. now apply parallel_equal. }
        setoid_rewrite E. split; [intros (u & I & u' & H & K)|intros (u' & (u & I & H) & K)]; eauto 6. }
    intro w. unfold finite_substitution, substitution. setoid_rewrite Q. split.
    + intros (u & (x & ts' & H1 & H2 & H3)%S & K). eauto 8.
    + intros (x & ts' & H1 & H2 & u & H3 & K). exists u. split; auto. apply S. eauto 8.
Qed.

(* ---- intersection with regular languages, where letters may choose: a letter between two states ---- *)
Section Threads.
  Context {A V Q : Set} {q : Alphabet Q}.
  Variable M : automaton A Q.
  Fixpoint thread (p p' : Q) (u : list V) : list (list (Q * V * Q)) :=
    match u with
    | [] => if letter_eq p p' then [[]] else []
    | x :: u => flat_map (fun o => map (cons (p, x, o)) (thread o p' u)) letters
    end.
  Definition between (R : V -> list A -> Prop) (z : Q * V * Q) (w : list A) : Prop :=
    match z with (p, x, p') => R x w /\ fold_left (next M) w p = p' end.
  Lemma thread_right R p p' u w : (exists u', In u' (thread p p' u) /\ parallel (between R) u' w) <-> parallel R u w /\ fold_left (next M) w p = p'.
  Proof.
    split.
    - intros (u' & I & H). revert p u' w I H. induction u as [|x u IH]; cbn; intros p u' w I H.
      + destruct (letter_eq p p') as [->|]; [|easy]. destruct I as [<-|[]]. now apply parallel_empty in H as ->.
      + apply in_flat_map in I as (o & _ & I). apply in_map_iff in I as (u1 & <- & I).
        apply parallel_first in H as (w1 & w2 & -> & (K1 & <-) & H). destruct (IH _ _ _ I H) as (H1 & <-).
        rewrite fold_left_app. split; [now constructor|easy].
    - intros (H & <-). revert p. induction H as [|x w1 u w2 K H IH]; cbn; intro p.
      + exists []. destruct (letter_eq p p); [|easy]. split; [now left|constructor].
      + destruct (IH (fold_left (next M) w1 p)) as (u' & I & H'). exists ((p, x, fold_left (next M) w1 p) :: u'). rewrite fold_left_app.
        split; [|constructor; [split|]; auto]. apply in_flat_map. exists (fold_left (next M) w1 p). split; [apply all_letters|now apply in_map].
  Qed.
End Threads.
Theorem runs_intersection_with_regular {A : Set} {a : Alphabet A} many (X R : language A) :
  runs many false X -> regular R -> runs many false (intersection X R).
Proof.
  intros (V & v & starts & ts & fin & m & _ & S) (Q & q & M & SR).
  set (threaded := fun (t : table V) (z : Q * V * Q) => match z with (p, x, p') => flat_map (thread p p') (t x) end).
  set (fin' := fun z : Q * V * Q => match z with (p, x, p') => filter (fun w => if letter_eq (fold_left (next M) w p) p' then true else false) (fin x) end).
  exists (Q * V * Q)%type, _, (flat_map (fun x => flat_map (fun p => if final M p then [(initial M, x, p)] else []) letters) starts), (map threaded ts), fin'.
  split; [|split; [easy|]].
  - intro F. destruct (m F) as (t & ->). now exists (threaded t).
  - assert (Q' : forall ts' z w, run fin' (map threaded ts') z w <-> between M (run fin ts') z w).
    { induction ts' as [|t ts' IH]; intros ((p, x), p') w; cbn.
      - rewrite filter_In. destruct letter_eq; intuition congruence.
      - split.
        + intros (u' & (u & I & J)%in_flat_map & H). enough (K : parallel (run fin ts') u w /\ fold_left (next M) w p = p') by (destruct K; eauto).
          apply thread_right. exists u'. split; auto. revert H. apply parallel_weaken. intros z u0 _. apply IH.
        + intros ((u & I & H) & K). destruct (proj2 (thread_right M (run fin ts') p p' u w) (conj H K)) as (u' & J & L).
          exists u'. split; [apply in_flat_map; eauto|]. revert L. apply parallel_weaken. intros z u0 _. apply IH. }
    intro w. unfold intersection. rewrite (SR w). unfold accepts. split.
    + intros ((x & ts' & I & J & H)%S & K). exists (initial M, x, fold_left (next M) w (initial M)), (map threaded ts').
      split; [|split; [now apply incl_map|now apply Q']]. apply in_flat_map. exists x. split; auto. apply in_flat_map.
      exists (fold_left (next M) w (initial M)). split; [apply all_letters|]. rewrite K. now left.
    + intros (z & ts' & I & J & H). apply incl_map_back in J as (ts0 & -> & J). apply in_flat_map in I as (x & I & K).
      apply in_flat_map in K as (p & _ & K). destruct (final M p) eqn:F; [|easy]. destruct K as [<-|[]].
      apply Q' in H as (H & <-). split; auto. apply S. eauto 8.
Qed.

(* ---- and where they may not: a letter carries a guess of what the words of all letters do to the automaton.  A table
   knows the guess that is right after it, and so the one before it. ---- *)
Section Deterministic.
  Context {A V Q : Set} {a : Alphabet A} {v : Alphabet V} {q : Alphabet Q}.
  Variable M : automaton A Q.
  Variables (starts : list V) (ts : list (table V)) (fin : V -> list (list A)).
  Hypothesis one : forall x, at_most_one (fin x) /\ forall t, In t ts -> at_most_one (t x).
  Definition guess : Set := function V (function Q Q).
  Definition effect (g : guess) (x : V) (p : Q) : Q := apply p (apply (as_letter (fun p => p)) g x) p.
  Definition as_guess (f : V -> Q -> Q) : guess := as_letter (fun x => as_letter (f x)).
  Lemma effect_as_guess f x p : effect (as_guess f) x p = f x p.
  Proof. unfold effect, as_guess. now rewrite !apply_as_letter. Qed.
  Definition after_fin : guess := as_guess (fun x p => match fin x with w :: _ => fold_left (next M) w p | [] => p end).
  Definition before (t : table V) (g : guess) : guess :=
    as_guess (fun x p => match t x with u :: _ => fold_left (fun p y => effect g y p) u p | [] => p end).
  Definition guessing (t : table V) (g' : guess) : table (V * guess) :=
    fun z => if letter_eq (snd z) (before t g') then map (map (fun y => (y, g'))) (t (fst z)) else [].
  Definition guessing_fin (z : V * guess) : list (list A) := if letter_eq (snd z) after_fin then fin (fst z) else [].
  Definition guessing_tables : list (table (V * guess)) := flat_map (fun t => map (guessing t) letters) ts.

  Lemma the_one {X : Set} (l : list X) u (d : X) : at_most_one l -> In u l -> exists l', l = u :: l'.
  Proof. destruct l as [|x l]; [easy|]. intros H I. exists l. f_equal. apply H; auto. now left. Qed.
  Lemma guesses_right ts' : incl ts' guessing_tables -> exists ts0, incl ts0 ts /\ forall x g w, run guessing_fin ts' (x, g) w ->
    run fin ts0 x w /\ forall p, effect g x p = fold_left (next M) w p.
  Proof.
    induction ts' as [|t' ts' IH]; intro I.
    - exists []. split; [easy|]. intros x g w. cbn. unfold guessing_fin. cbn. destruct letter_eq as [->|]; [|easy]. intro J. split; auto.
      intro p. unfold after_fin. rewrite effect_as_guess. destruct (the_one (fin x) w [] (proj1 (one x)) J) as (l & ->). reflexivity.
    - destruct IH as (ts0 & J & H); [intros t K; apply I; now right|]. assert (K : In t' guessing_tables) by (apply I; now left).
      apply in_flat_map in K as (t & It & (g' & <- & _)%in_map_iff). exists (t :: ts0). split; [intros t' [<-|]; auto|].
      intros x g w (u' & K & L). unfold guessing in K. cbn in K. destruct letter_eq as [->|]; [|easy].
      apply in_map_iff in K as (u & <- & K). apply -> (@parallel_map_left) in L.
      assert (P : parallel (run fin ts0) u w /\ forall p, fold_left (fun p y => effect g' y p) u p = fold_left (next M) w p).
      { clear K. induction L as [|y w1 u w2 K L (IH1 & IH2)]; [auto|]. destruct (H _ _ _ K) as (K1 & K2). split; [auto|].
        intro p. cbn. now rewrite fold_left_app, K2, IH2. }
      destruct P as (P1 & P2). split; [exists u; auto|]. intro p. unfold before. rewrite effect_as_guess.
      destruct (the_one (t x) u [] (proj2 (one x) t It) K) as (l & ->). apply P2.
  Qed.
  Lemma guesses_exist ts0 : incl ts0 ts -> exists ts' g, incl ts' guessing_tables /\ forall x w, run fin ts0 x w -> run guessing_fin ts' (x, g) w.
  Proof.
    induction ts0 as [|t ts0 IH]; intro I.
    - exists [], after_fin. split; [easy|]. intros x w. cbn. unfold guessing_fin. cbn. now destruct letter_eq.
    - destruct IH as (ts' & g' & J & H); [intros t' K; apply I; now right|]. exists (guessing t g' :: ts'), (before t g'). split.
      + intros t' [<-|K]; auto. apply in_flat_map. exists t. split; [apply I; now left|]. apply in_map, all_letters.
      + intros x w (u & K & L). exists (map (fun y => (y, g')) u). unfold guessing. cbn. destruct letter_eq; [|easy]. split; [now apply in_map|].
        apply parallel_map_left. revert L. apply parallel_weaken. auto.
  Qed.
End Deterministic.
Theorem deterministic_runs_intersection_with_regular {A : Set} {a : Alphabet A} (X R : language A) :
  runs true true X -> regular R -> runs true true (intersection X R).
Proof.
  intros (V & v & starts & ts & fin & _ & o & S) (Q & q & M & SR). specialize (o eq_refl).
  exists (V * guess (V := V) (Q := Q))%type, _, (flat_map (fun x => flat_map (fun g => if final M (effect g x (initial M)) then [(x, g)] else []) letters) starts),
    (guessing_tables ts), (guessing_fin M fin).
  split; [easy|split].
  - intros _ (x, g). split.
    + unfold guessing_fin. cbn. destruct letter_eq; [apply (o x)|easy].
    + intros t' (t & I & (g' & <- & _)%in_map_iff)%in_flat_map. unfold guessing. cbn. destruct letter_eq; [|easy].
      apply at_most_map. now apply (o x).
  - intro w. unfold intersection. rewrite (SR w). unfold accepts. split.
    + intros ((x & ts0 & I & J & H)%S & K). destruct (guesses_exist M ts fin ts0 J) as (ts' & g & J' & G). specialize (G x w H).
      exists (x, g), ts'. split; auto. apply in_flat_map. exists x. split; auto. apply in_flat_map. exists g. split; [apply all_letters|].
      destruct (guesses_right M ts fin o ts' J') as (ts1 & _ & F). destruct (F _ _ _ G) as (_ & ->). rewrite K. now left.
    + intros ((x, g) & ts' & I & J & H). destruct (guesses_right M ts fin o ts' J) as (ts0 & J0 & F). destruct (F _ _ _ H) as (H0 & E).
      apply in_flat_map in I as (x' & I & K). apply in_flat_map in K as (g' & _ & K). destruct (final M _) eqn:Fin; [|easy].
      destruct K as [[= -> ->]|[]]. rewrite E in Fin. split; auto. apply S. eauto 8.
Qed.
