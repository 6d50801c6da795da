(* What follows of few closure properties: machines are finite substitutions and an intersection with a regular
   language; and a family that has the regular languages and is closed under substitution and intersection with regular
   languages is closed under the other operations that an abstract family of languages is closed under. *)
From Algae Require Import Words Regular.

Lemma image_substitution {A B : Set} (h : A -> list B) X : same (finite_substitution (fun a => [h a]) X) (image h X).
Proof.
  intro w. unfold finite_substitution, substitution, image. split; intros (u & Xu & H); exists u; split; auto.
  - apply (parallel_function h). eapply parallel_weaken; [|exact H]. cbn. intuition congruence.
  - apply <- (parallel_function h) in H. eapply parallel_weaken; [|exact H]. cbn. auto.
Qed.
Lemma homomorphism_by_substitution f : closed FiniteSubstitution f -> closed Homomorphism f.
Proof. intros C A a. cbn. intros B b h X H. apply (is_same f _ _ (image_substitution h X)). exact (C A a B b _ X H). Qed.
Lemma non_erasing_homomorphism_by_homomorphism f : closed Homomorphism f -> closed NonErasingHomomorphism f.
Proof. intros C A a. cbn. intros B b h X _ H. exact (C A a B b h X H). Qed.

Section Machines.
  Variable f : family.
  Hypothesis finite_substitutions : closed FiniteSubstitution f.
  Hypothesis with_regular : closed IntersectionWithRegular f.

  (* a letter becomes any move that reads it, the moves have to fit, and each becomes what it writes *)
  Theorem gsm_by_substitution : closed GsmMapping f.
  Proof.
    intros A a. cbn. intros B Q b q M X H.
    set (guess := fun x : A => flat_map (fun s => map (fun s' => [(s, x, s')]) letters) letters : list (list (Q * A * Q))).
    set (follow := fun (s : option Q) (m : Q * A * Q) => match m with (s1, x, s2) =>
      match s with Some s => if letter_eq s s1 then Some s2 else None | None => None end end).
    set (fits := Automaton (Some (first M)) follow (fun s => match s with Some s => accepting M s | None => false end)).
    set (written := fun m : Q * A * Q => match m with (s1, x, s2) =>
      map fst (filter (fun z => if letter_eq (snd z) s2 then true else false) (moves M s1 x)) end).
    apply (is_same f (finite_substitution written (intersection (finite_substitution guess X) (accepts fits)))).
    2: { under finite_substitutions. under with_regular; [under finite_substitutions; exact H|].
         exists (option Q), _, fits. now intro. }
    assert (N : forall w, fold_left follow w None = None) by (induction w as [|((s1, x), s2) w IH]; auto).
    assert (W : forall s1 x s2 u, In u (written (s1, x, s2)) <-> In (u, s2) (moves M s1 x)).
    { intros s1 x s2 u. unfold written. rewrite in_map_iff. split.
      - intros ((u', s) & <- & (I & J)%filter_In). cbn in *. now destruct letter_eq as [->|].
      - intro I. exists (u, s2). split; auto. apply filter_In. cbn. now destruct letter_eq. }
    assert (G : forall x m, In m (guess x) <-> exists s1 s2, m = [(s1, x, s2)]).
    { intros x m. unfold guess. rewrite in_flat_map. split.
      - intros (s1 & _ & (s2 & <- & _)%in_map_iff). eauto.
      - intros (s1 & s2 & ->). exists s1. split; [apply all_letters|]. apply in_map_iff. exists s2. split; auto. apply all_letters. }
    assert (T : forall s v w, translates M s v w <-> exists ms, parallel (fun x m => In m (guess x)) v ms /\
      (match fold_left follow ms (Some s) with Some s => accepting M s | None => false end) = true /\
      parallel (fun m u => In u (written m)) ms w).
    { intros s v w. split.
      - induction 1 as [s Acc|s x p u v w I K (ms & H1 & H2 & H3)]; [exists []; auto|].
        exists ([(s, x, p)] ++ ms). split; [|split].
        + constructor; auto. apply G. eauto.
        + cbn. now destruct letter_eq.
        + constructor; auto. now apply W.
      - intros (ms & H1 & H2 & H3). revert s w H2 H3. induction H1 as [|x m v ms I K IH]; intros s w H2 H3.
        + apply parallel_empty in H3 as ->. now constructor.
        + apply G in I as (s1 & s2 & ->). cbn in H2, H3. destruct (letter_eq s s1) as [<-|]; [|now rewrite N in H2].
          apply parallel_first in H3 as (u & w' & -> & I & H3). apply W in I. apply (translates_cons M s x s2); auto. }
    intro w. unfold translation, finite_substitution, substitution, intersection, accepts. cbn. split.
    - intros (ms & ((v & Xv & H1) & H2) & H3). exists v. split; auto. apply T. eauto.
    - intros (v & Xv & Tv). apply T in Tv as (ms & H1 & H2 & H3). exists ms. eauto.
  Qed.
End Machines.

(* Union, concatenation, star and plus are substitutions of languages of the family into regular languages. *)
Definition closed_under_regular_operations (f : family) : Prop := forall (A B : Set) (_ : Alphabet A) (_ : Alphabet B)
  (s : A -> language B) (R : language A), regular R -> (forall x, is f (s x)) -> is f (substitution s R).
Definition has_regular_languages (f : family) : Prop := forall (A : Set) (_ : Alphabet A) (X : language A), regular X -> is f X.
Lemma regular_operations_by_substitution f : closed Substitution f -> has_regular_languages f -> closed_under_regular_operations f.
Proof. intros C H A B a b s R HR Hs. under C; [now under H|exact Hs]. Qed.

Section RegularOperations.
  Variable f : family.
  Hypothesis substitutions : closed_under_regular_operations f.

  Section Choice.
    Context {A : Set} {a : Alphabet A}.
    Lemma choice_of (X Y : language A) (R : language bool) : is f X -> is f Y -> regular R ->
      is f (substitution (fun q : bool => if q then Y else X) R).
    Proof. intros HX HY HR. under substitutions; [exact HR|now intros []]. Qed.
  End Choice.

  Theorem union_by_substitution : closed Union f.
  Proof.
    intros A a. cbn. intros X Y HX HY.
    apply (is_same f (substitution (fun q : bool => if q then Y else X) (fun w => exists q, w = [q] /\ true = true))).
    2: apply (choice_of X Y); auto; apply (regular_letter (fun _ => true)).
    intro w. unfold substitution, union. split.
    - intros (u & (q & -> & _) & H). apply of_letter in H. destruct q; auto.
    - intros [H|H]; [exists [false]|exists [true]]; (split; [eauto|now apply parallel_letter]).
  Qed.
  Definition two (q : option bool) (x : bool) : option bool := match q, x with Some false, false => Some true | _, _ => None end.
  Theorem concatenation_by_substitution : closed Concatenation f.
  Proof.
    intros A a. cbn. intros X Y HX HY. apply (is_same f (substitution (fun q : bool => if q then Y else X) (eq [false; true]))).
    - intro w. unfold substitution, concatenation. split.
      + intros (u & <- & H). apply parallel_first in H as (w1 & w2 & -> & H1 & H2). apply of_letter in H2. eauto.
      + intros (u & v & -> & H1 & H2). exists [false; true]. split; auto. constructor; auto. now apply parallel_letter.
    - apply choice_of; auto. set (M := Automaton 0 (fun n (x : bool) => n) (fun _ => true)).
      set (step := fun (q : bool * bool) (x : bool) => match q, x with (false, false), false => (false, true) | (false, true), true => (true, false) | _, _ => (true, true) end).
      exists (bool * bool)%type, _, (Automaton (false, false) step (fun q => fst q && negb (snd q))).
      assert (S : forall w, fold_left step w (true, true) = (true, true)) by (induction w; auto).
      intro w. unfold accepts. cbn. split; [intros <-; auto|].
      destruct w as [|[] [|[] [|x w]]]; cbn; auto; rewrite ?S; cbn; easy.
  Qed.
  Lemma repeated {A : Set} (X : language A) (us : list (list A)) : (forall u, In u us -> X u) ->
    parallel (fun _ : unit => X) (repeat tt (length us)) (concat us).
  Proof. induction us as [|u us IH]; cbn; intro H; auto. Qed.
  Lemma repeated_back {A : Set} (X : language A) (n : list unit) w : parallel (fun _ : unit => X) n w ->
    exists us, length us = length n /\ w = concat us /\ forall u, In u us -> X u.
  Proof.
    induction 1 as [|x u n w H K (us & Q & -> & F)]; [now exists []|]. exists (u :: us). cbn. split; [auto|]. split; auto.
    intros v [<-|I]; auto.
  Qed.
  Theorem star_by_substitution : closed Star f.
  Proof.
    intros A a. cbn. intros X HX. apply (is_same f (substitution (fun _ : unit => X) (fun w => forallb (fun _ => true) w = true))).
    2: { under substitutions; [apply regular_words_of|easy]. }
    intro w. unfold substitution, star. split.
    - intros (u & _ & (us & _ & H)%repeated_back). eauto.
    - intros (us & -> & F). exists (repeat tt (length us)). split; [|now apply repeated]. now apply forallb_forall.
  Qed.
  Theorem plus_by_substitution : closed Plus f.
  Proof.
    intros A a. cbn. intros X HX. apply (is_same f (substitution (fun _ : unit => X) (complement (eq [])))).
    2: { under substitutions; [under regular_complement; apply regular_empty_word|easy]. }
    intro w. unfold substitution, plus, complement. split.
    - intros (u & N & (us & Q & H)%repeated_back). exists us. split; auto. intros ->. now destruct u.
    - intros (us & N & -> & F). exists (repeat tt (length us)). split; [|now apply repeated]. now destruct us.
  Qed.
End RegularOperations.

Lemma regular_into_regular : closed_under_regular_operations REG.
Proof. now apply regular_operations_by_substitution; [apply regular_substitution|]. Qed.

(* ---- the regular languages themselves; with them finite languages are regular ---- *)
Lemma regular_union : closed Union REG.
Proof. apply union_by_substitution, regular_into_regular. Qed.
Lemma regular_concatenation : closed Concatenation REG.
Proof. apply concatenation_by_substitution, regular_into_regular. Qed.
Lemma regular_star : closed Star REG.
Proof. apply star_by_substitution, regular_into_regular. Qed.
Lemma regular_plus : closed Plus REG.
Proof. apply plus_by_substitution, regular_into_regular. Qed.
Lemma regular_word {A : Set} {a : Alphabet A} (w : list A) : regular (eq w).
Proof.
  induction w as [|x w IH]; [apply regular_empty_word|].
  apply (is_same REG (concatenation (fun u => exists y, u = [y] /\ (if letter_eq x y then true else false) = true) (eq w))).
  2: under regular_concatenation; [apply regular_letter|exact IH].
  intro v. unfold concatenation. split.
  - intros (u & v' & -> & (y & -> & Q) & <-). now destruct (letter_eq x y) as [->|].
  - intros <-. exists [x], w. split; auto. split; auto. exists x. split; auto. now destruct letter_eq.
Qed.
Lemma regular_finite {A : Set} {a : Alphabet A} (K : list (list A)) : regular (fun w => In w K).
Proof.
  induction K as [|w K IH]; [apply regular_nothing|]. apply (is_same REG (union (eq w) (fun v => In v K))); [easy|].
  under regular_union; [apply regular_word|exact IH].
Qed.

Section Full.
  Variable f : family.
  Hypothesis substitutions : closed Substitution f.
  Hypothesis with_regular : closed IntersectionWithRegular f.
  Hypothesis has_regular : has_regular_languages f.

  Theorem finite_substitution_by_substitution : closed FiniteSubstitution f.
  Proof.
    intros A a. cbn. intros B b s X HX. under substitutions; [exact HX|]. intro x. under has_regular. apply regular_finite.
  Qed.

  (* Letters of A are put anywhere into the words of X.  Of these the words are kept where every letter x of A stands
     before its image; then the images are erased. *)
  Theorem inverse_homomorphism_by_substitution : closed InverseHomomorphism f.
  Proof.
    intros A a. cbn. intros B b h X HX.
    set (only_a := fun z : A + B => match z with inl _ => true | inr _ => false end).
    set (loose := fun w : list (A + B) => forallb only_a w = true).
    set (block := fun x : A => inl x :: map inr (h x) : list (A + B)).
    set (blocks := star (fun w => In w (map block letters))).
    set (keep := fun z : A + B => match z with inl x => [x] | inr _ => [] end).
    set (images := fun z : A + B => match z with inl _ => [] | inr y => [y] end).
    assert (Rl : regular loose) by apply regular_words_of.
    set (spread := fun y : B => concatenation loose (eq [inr y])).
    apply (is_same f (image keep (intersection (concatenation (substitution spread X) loose) blocks))).
    2: { under homomorphism_by_substitution; [now apply finite_substitution_by_substitution|]. under with_regular.
         - under concatenation_by_substitution; [now apply regular_operations_by_substitution| |now under has_regular]. under substitutions; [exact HX|]. intro y. under has_regular.
           under regular_concatenation; [exact Rl|apply regular_word].
         - under regular_star. apply regular_finite. }
    assert (L0 : forall w, loose w -> flat_map images w = []).
    { unfold loose. induction w as [|[x|y] w IH]; cbn; auto. easy. }
    assert (Sh : forall w, concatenation (substitution spread X) loose w <-> X (flat_map images w)).
    { intro w. split.
      - intros (w1 & w2 & -> & (u & Xu & H) & L2). rewrite flat_map_app, (L0 w2 L2), app_nil_r.
        replace (flat_map images w1) with u; auto. clear Xu. induction H as [|y v u w1 (v1 & v2 & -> & Lv & <-) H IH]; auto.
        rewrite !flat_map_app, (L0 v1 Lv), <- IH. reflexivity.
      - intro H. assert (Q : exists w1 w2, w = w1 ++ w2 /\ parallel spread (flat_map images w) w1 /\ loose w2).
        { clear H. induction w as [|[x|y] w (w1 & w2 & -> & H1 & H2)].
          - exists [], []. repeat split. constructor.
          - cbn. rewrite flat_map_app, (L0 w2 H2), app_nil_r in *. destruct (flat_map images w1) as [|y u].
            + apply parallel_empty in H1 as ->. exists [], (inl x :: w2). repeat split; auto.
            + apply parallel_first in H1 as (v & w1' & -> & (v1 & v2 & -> & Lv & <-) & H1).
              exists (((inl x :: v1) ++ [inr y]) ++ w1'), w2. split; [cbn; now rewrite <- !app_assoc|]. split; auto.
              constructor; auto. exists (inl x :: v1), [inr y]. repeat split. exact Lv.
          - cbn. exists ([inr y] ++ w1), w2. split; auto. split; auto. constructor; auto. exists [], [inr y]. repeat split. }
        destruct Q as (w1 & w2 & Q & H1 & H2). exists w1, w2. split; auto. split; auto. exists (flat_map images w). auto. }
    assert (Bl : forall u, flat_map keep (flat_map block u) = u /\ flat_map images (flat_map block u) = flat_map h u).
    { assert (K1 : forall v : list B, flat_map keep (map inr v) = []) by (induction v; auto).
      assert (K2 : forall v : list B, flat_map images (map inr v) = v) by (induction v; cbn; congruence).
      induction u as [|x u (IH1 & IH2)]; [auto|]. cbn. rewrite !flat_map_app, K1, K2, IH1, IH2. auto. }
    assert (Bs : forall w, blocks w -> exists u, w = flat_map block u).
    { intros w (us & -> & F). induction us as [|u us IH]; [now exists []|]. destruct IH as (v & Q); [intros; apply F; now right|].
      destruct (proj1 (in_map_iff _ _ _) (F u ltac:(now left))) as (x & <- & _). exists (x :: v). cbn. now rewrite Q. }
    intro w. unfold image, intersection, inverse_image. setoid_rewrite Sh. split.
    - intros (v & (H & (u & ->)%Bs) & ->). destruct (Bl u) as (-> & Q). now rewrite <- Q.
    - intro H. exists (flat_map block w). destruct (Bl w) as (Q1 & Q2). rewrite Q1, Q2. split; auto. split; auto.
      exists (map block w). split; [apply flat_map_concat_map|]. intros v (x & <- & _)%in_map_iff. apply in_map, all_letters.
  Qed.
End Full.

Theorem regular_finite_substitution : closed FiniteSubstitution REG.
Proof. apply finite_substitution_by_substitution; [apply regular_substitution|easy]. Qed.
Theorem regular_homomorphism : closed Homomorphism REG.
Proof. apply homomorphism_by_substitution, regular_finite_substitution. Qed.
Theorem regular_non_erasing_homomorphism : closed NonErasingHomomorphism REG.
Proof. apply non_erasing_homomorphism_by_homomorphism, regular_homomorphism. Qed.
Theorem regular_gsm_mapping : closed GsmMapping REG.
Proof. apply gsm_by_substitution; [apply regular_finite_substitution|apply regular_intersection_with_regular]. Qed.
Theorem regular_inverse_homomorphism : closed InverseHomomorphism REG.
Proof. apply inverse_homomorphism_by_substitution; [apply regular_substitution|apply regular_intersection_with_regular|easy]. Qed.
(* a homomorphism is a machine with one state *)
Lemma homomorphism_by_gsm f : closed GsmMapping f -> closed Homomorphism f.
Proof.
  intros C A a. cbn. intros B b h X HX.
  apply (is_same f (translation (Machine tt (fun _ x => [(h x, tt)]) (fun _ => true)) X)); [|under C; exact HX].
  assert (Q : forall q u w, translates (Machine tt (fun _ x => [(h x, tt)]) (fun _ => true)) q u w <-> w = flat_map h u).
  { intros [] u w. split; [|intros ->].
    - induction 1 as [|q x q' u v w I H IH]; cbn in *; [easy|]. destruct I as [[= <- _]|[]]. now subst.
    - induction u as [|x u IH]; [now constructor|]. apply (translates_cons _ tt x tt); auto. now left. }
  intro w. unfold translation, image. now setoid_rewrite Q.
Qed.
