(* Context-free languages: derivation trees, substitution, intersection with regular languages, reversal.  The other
   operations follow from AbstractFamily.v. *)
From Algae Require Import Words Regular AbstractFamily.

Section Trees.
  Context {A N : Set}.
  Variable G : grammar A N.
  (* a tree of depth at most n with z at its root and the word w at its leaves *)
  Fixpoint yields (n : nat) (z : N + A) (w : list A) : Prop :=
    match z with
    | inr x => w = [x]
    | inl X => match n with 0 => False | S n => exists r, In r (rules G X) /\ parallel (yields n) r w end
    end.
  Definition tree (z : N + A) (w : list A) : Prop := exists n, yields n z w.

  Lemma deeper n m z w : n <= m -> yields n z w -> yields m z w.
  Proof.
    revert m z w. induction n as [|n IH]; intros [|m] [X|x] w L H; cbn in *; auto; try easy; try lia.
    destruct H as (r & I & H). exists r. split; auto. eapply parallel_weaken; [|exact H]. intros z u _. apply IH. lia.
  Qed.
  Lemma one_depth r w : parallel tree r w -> exists n, parallel (yields n) r w.
  Proof.
    induction 1 as [|z u r w (n & H) K (m & IH)]; [exists 0; auto|]. exists (max n m). constructor.
    - revert H. apply deeper. lia.
    - eapply parallel_weaken; [|exact IH]. intros z' u' _. apply deeper. lia.
  Qed.
  Lemma tree_letter x w : tree (inr x) w <-> w = [x].
  Proof. split; [now intros ([|n] & H)|intros ->; now exists 0]. Qed.
  Lemma tree_node X w : tree (inl X) w <-> exists r, In r (rules G X) /\ parallel tree r w.
  Proof.
    split.
    - intros ([|n] & H); [easy|]. destruct H as (r & I & H). exists r. split; auto. eapply parallel_weaken; [|exact H].
      intros z u _ K. now exists n.
    - intros (r & I & H). destruct (one_depth r w H) as (n & K). exists (S n). now exists r.
  Qed.
  Lemma tree_word w : parallel tree (map inr w) w.
  Proof. apply parallel_map_left. induction w as [|x w IH]; auto. change (x :: w) with ([x] ++ w) at 2. constructor; auto. now apply tree_letter. Qed.

  Lemma rewrites_within z z' u v : rewrites G z z' -> rewrites G (u ++ z ++ v) (u ++ z' ++ v).
  Proof.
    induction 1 as [|u' X v' r H IH I]; [constructor|]. replace (u ++ (u' ++ r ++ v') ++ v) with ((u ++ u') ++ r ++ (v' ++ v)) by now rewrite !app_assoc.
    apply (rewrites_step G _ _ X); auto. replace ((u ++ u') ++ inl X :: v' ++ v) with (u ++ (u' ++ inl X :: v') ++ v); auto.
    now rewrite <- !app_assoc.
  Qed.
  Lemma rewrites_more z z' z'' : rewrites G z z' -> rewrites G z' z'' -> rewrites G z z''.
  Proof. intros H K. induction K; auto. now apply (rewrites_step G _ _ X). Qed.
  Lemma rewrites_parallel r w : parallel (fun z w => rewrites G [z] (map inr w)) r w -> rewrites G r (map inr w).
  Proof.
    induction 1 as [|z u r w H K IH]; [constructor|]. rewrite map_app. apply (rewrites_more _ (map inr u ++ r)).
    - exact (rewrites_within [z] (map inr u) [] r H).
    - pose proof (rewrites_within r (map inr w) (map inr u) [] IH) as Q. now rewrite !app_nil_r in Q.
  Qed.
  Theorem rewrites_trees X w : rewrites G [inl X] (map inr w) <-> tree (inl X) w.
  Proof.
    split.
    - intro H. enough (Q : forall z z', rewrites G z z' -> forall w, parallel tree z' w -> parallel tree z w) by (apply of_letter, (Q _ _ H), tree_word).
      clear. induction 1 as [|u X v r H IH I]; auto. intros w K. apply IH.
      apply parallel_split in K as (w1 & w2 & -> & K1 & K2). apply parallel_split in K2 as (w3 & w4 & -> & K3 & K4).
      apply parallel_append; auto. constructor; auto. apply tree_node. eauto.
    - intros (n & H). revert X w H. induction n as [|n IH]; intros X w H; [easy|]. destruct H as (r & I & H).
      apply (rewrites_more _ r).
      + pose proof (rewrites_step G [inl X] [] X [] r) as Q. cbn in Q. rewrite app_nil_r in Q. apply Q; [constructor|exact I].
      + apply rewrites_parallel. eapply parallel_weaken; [|exact H]. intros [Y|x] u _ K; [now apply IH|].
        assert (u = [x]) as -> by (destruct n; exact K). constructor.
  Qed.
End Trees.

Lemma context_free_trees {A : Set} (X : language A) :
  context_free X <-> exists (N : Set) (_ : Alphabet N) (G : grammar A N), same X (tree G (inl (start G))).
Proof.
  split; intros (N & n & G & S); exists N, n, G; intro w; rewrite (S w); [|symmetry]; apply rewrites_trees.
Qed.

(* ---- reversal ---- *)
Theorem context_free_reversal : closed Reversal CF.
Proof.
  intros A a. cbn. intros X (N & n & G & S)%context_free_trees. apply context_free_trees.
  set (G' := Grammar (start G) (fun X => map (@rev _) (rules G X))). exists N, n, G'.
  assert (F : forall m z w, yields G m z w -> yields G' m z (rev w)).
  { induction m as [|m IH]; intros [Y|x] w; cbn; try easy; try (intros ->; reflexivity).
    intros (r & I & H). exists (rev r). split; [now apply in_map|]. eapply parallel_weaken; [|exact (parallel_reversed H)].
    cbn. intros z u _ K. rewrite <- (rev_involutive u). now apply IH. }
  assert (B : forall m z w, yields G' m z w -> yields G m z (rev w)).
  { induction m as [|m IH]; intros [Y|x] w; cbn; try easy; try (intros ->; reflexivity).
    intros (r' & I & H). apply in_map_iff in I as (r & <- & I). exists r. split; auto.
    rewrite <- (rev_involutive r). eapply parallel_weaken; [|exact (parallel_reversed H)].
    cbn. intros z u _ K. rewrite <- (rev_involutive u). now apply IH. }
  intro w. unfold reversal. rewrite (S (rev w)). split; intros (m & H); exists m.
  - apply F in H. now rewrite rev_involutive in H.
  - now apply B in H.
Qed.

(* ---- regular languages ---- *)
Theorem regular_context_free (A : Set) (a : Alphabet A) (X : language A) : regular X -> is CF X.
Proof.
  intros (Q & q & M & S). apply context_free_trees.
  set (G := Grammar (initial M) (fun p => (if final M p then [[]] else []) ++ map (fun x => [inr x; inl (next M p x)]) letters) : grammar A Q).
  exists Q, q, G. intro w. rewrite (S w). unfold accepts. cbn. generalize (initial M). intro p. split.
  - revert p. induction w as [|x w IH]; cbn; intros p H; apply tree_node.
    + exists []. split; [|constructor]. cbn. rewrite H. now left.
    + exists [inr x; inl (next M p x)]. split; [apply in_or_app; right; apply in_map_iff; exists x; split; [reflexivity|apply all_letters]|].
      change (x :: w) with ([x] ++ w). constructor; [now apply (tree_letter G)|]. apply parallel_letter. now apply IH.
  - intros (n & H). revert p w H. induction n as [|n IH]; intros p w H; [easy|]. destruct H as (r & I & H). cbn in I.
    apply in_app_or in I as [I|(x & <- & _)%in_map_iff].
    + destruct (final M p) eqn:F; [|easy]. destruct I as [<-|[]]. now apply parallel_empty in H as ->.
    + apply parallel_first in H as (u & w' & -> & K & H). apply of_letter in H. assert (u = [x]) as -> by (destruct n; exact K).
      cbn. now apply IH.
Qed.

(* ---- substitution ---- *)
Record some_grammar (B : Set) := Some_grammar { its_symbols : Set; its_symbols_alphabet : Alphabet its_symbols; its_rules : grammar B its_symbols }.
#[export] Existing Instance its_symbols_alphabet.
Arguments its_symbols {B}. Arguments its_symbols_alphabet {B}. Arguments its_rules {B}.
Theorem context_free_substitution : closed Substitution CF.
Proof.
  intros A a. cbn. intros B b s X (N & n & G & SX)%context_free_trees H.
  assert (C : exists I : A -> some_grammar B, forall x, same (s x) (tree (its_rules (I x)) (inl (start (its_rules (I x)))))).
  { apply (choose (fun x (I : some_grammar B) => same (s x) (tree (its_rules I) (inl (start (its_rules I)))))).
    2: constructor; exact (Some_grammar B unit _ (Grammar tt (fun _ => []))).
    intro x. destruct (proj1 (context_free_trees _) (H x)) as (P & p & F & S). now exists (Some_grammar B P p F). }
  destruct C as (I & SI). clear H. apply context_free_trees.
  set (N' := (N + {x : A & its_symbols (I x)})%type).
  set (outer := fun z : N + A => match z with
    | inl Y => inl (inl Y) | inr x => inl (inr (existT (fun x => its_symbols (I x)) x (start (its_rules (I x))))) end : N' + B).
  set (inner := fun x (z : its_symbols (I x) + B) => match z with
    | inl Y => inl (inr (existT (fun x => its_symbols (I x)) x Y)) | inr y => inr y end : N' + B).
  set (G' := Grammar (inl (start G)) (fun Z : N' => match Z with
    | inl Y => map (map outer) (rules G Y)
    | inr (existT _ x Y) => map (map (inner x)) (rules (its_rules (I x)) Y) end)).
  exists N', _, G'.
  assert (In1 : forall m x z w, yields G' m (inner x z) w <-> yields (its_rules (I x)) m z w).
  { induction m as [|m IH]; intros x [Y|y] w; cbn; try easy. split.
    - intros (r' & J & H). apply in_map_iff in J as (r & <- & J). exists r. split; auto. apply -> (@parallel_map_left) in H.
      eapply parallel_weaken; [|exact H]. intros z u _. apply IH.
    - intros (r & J & H). exists (map (inner x) r). split; [now apply in_map|]. apply parallel_map_left.
      eapply parallel_weaken; [|exact H]. intros z u _. apply IH. }
  assert (In2 : forall x w, s x w <-> tree G' (outer (inr x)) w).
  { intros x w. rewrite (SI x w). unfold tree. split; intros (m & H); exists m.
    - now apply (In1 m x (inl _)) in H.
    - now apply (In1 m x (inl _)). }
  assert (F : forall m z w, yields G' m (outer z) w -> exists u, tree G z u /\ parallel s u w).
  { induction m as [|m IH]; intros [Y|x] w H.
    - easy.
    - exists [x]. split; [now apply tree_letter|]. apply parallel_letter. apply In2. now exists 0.
    - destruct H as (r' & J & H). apply in_map_iff in J as (r & <- & J). apply -> (@parallel_map_left) in H.
      assert (K : parallel (fun z w => exists u, tree G z u /\ parallel s u w) r w) by (eapply parallel_weaken; [|exact H]; cbn; eauto).
      apply parallel_compose in K as (u & K1 & K2). exists u. split; auto. apply tree_node. eauto.
    - exists [x]. split; [now apply tree_letter|]. apply parallel_letter. apply In2. now exists (S m). }
  assert (B' : forall m z u w, yields G m z u -> parallel s u w -> tree G' (outer z) w).
  { induction m as [|m IH]; intros [Y|x] u w H K; cbn in H; try easy.
    - subst u. apply of_letter in K. now apply In2.
    - destruct H as (r & J & H). apply tree_node. exists (map outer r). split; [cbn; now apply in_map|]. apply parallel_map_left.
      assert (Q : parallel (fun z w => exists u, yields G m z u /\ parallel s u w) r w) by (apply parallel_compose; eauto).
      eapply parallel_weaken; [|exact Q]. cbn. intros z v _ (u' & H1 & H2). eauto.
    - subst u. apply of_letter in K. now apply In2. }
  intro w. unfold substitution. split.
  - intros (u & Xu & H). apply SX in Xu as (m & K). now apply (B' m (inl (start G)) u).
  - intros (m & H). apply (F m (inl (start G))) in H as (u & K & H). exists u. split; auto. now apply SX.
Qed.

(* ---- intersection with regular languages: a symbol from one state to another ---- *)
Theorem context_free_intersection_with_regular : closed IntersectionWithRegular CF.
Proof.
  intros A a. cbn. intros X R (N & n & G & SX)%context_free_trees (Q & q & M & SR). apply context_free_trees.
  set (Z := option (Q * N * Q)).
  set (thread := fix thread (p p' : Q) (r : list (N + A)) : list (list (Z + A)) :=
    match r with
    | [] => if letter_eq p p' then [[]] else []
    | inr x :: r => map (cons (inr x)) (thread (next M p x) p' r)
    | inl Y :: r => flat_map (fun o => map (cons (inl (Some (p, Y, o)))) (thread o p' r)) letters
    end).
  set (G' := Grammar None (fun z : Z => match z with
    | None => flat_map (fun p => if final M p then [[inl (Some (initial M, start G, p))]] else []) letters
    | Some (p, Y, p') => flat_map (thread p p') (rules G Y) end)).
  exists Z, _, G'.
  assert (F : forall m p Y p' w, yields G' m (inl (Some (p, Y, p'))) w -> tree G (inl Y) w /\ fold_left (next M) w p = p').
  { induction m as [|m IH]; intros p Y p' w H; [easy|]. destruct H as (r' & I & H). cbn in I. apply in_flat_map in I as (r & J & I).
    rewrite tree_node. enough (K : parallel (tree G) r w /\ fold_left (next M) w p = p') by (destruct K; eauto).
    clear J. revert p r' w I H. induction r as [|[Y'|x] r IHr]; cbn; intros p r' w I H.
    - destruct (letter_eq p p') as [->|]; [|easy]. destruct I as [<-|[]]. now apply parallel_empty in H as ->.
    - apply in_flat_map in I as (o & _ & I). apply in_map_iff in I as (r1 & <- & I). apply parallel_first in H as (u & w' & -> & K & H).
      destruct (IH _ _ _ _ K) as (K1 & <-). destruct (IHr _ _ _ I H) as (H1 & <-). rewrite fold_left_app. split; [now constructor|easy].
    - apply in_map_iff in I as (r1 & <- & I). apply parallel_first in H as (u & w' & -> & K & H).
      assert (u = [x]) as -> by (destruct m; exact K). destruct (IHr _ _ _ I H) as (H1 & <-). split; [|easy].
      constructor; auto. now apply tree_letter. }
  assert (B : forall m p Y w, yields G m (inl Y) w -> tree G' (inl (Some (p, Y, fold_left (next M) w p))) w).
  { induction m as [|m IH]; intros p Y w H; [easy|]. destruct H as (r & J & H). apply tree_node. cbn.
    enough (K : exists r', In r' (thread p (fold_left (next M) w p) r) /\ parallel (tree G') r' w)
      by (destruct K as (r' & K1 & K2); exists r'; split; auto; apply in_flat_map; eauto).
    clear J. revert p. induction H as [|[Y'|x] u r w K H IHr]; cbn; intro p.
    - exists []. destruct (letter_eq p p); [|easy]. split; [now left|constructor].
    - destruct (IHr (fold_left (next M) u p)) as (r' & I & H'). exists (inl (Some (p, Y', fold_left (next M) u p)) :: r').
      rewrite fold_left_app. split; [|constructor; auto]. apply in_flat_map. exists (fold_left (next M) u p). split; [apply all_letters|now apply in_map].
    - assert (u = [x]) as -> by (destruct m; exact K). destruct (IHr (next M p x)) as (r' & I & H'). exists (inr x :: r').
      cbn. split; [now apply in_map|]. change (x :: w) with ([x] ++ w). constructor; auto. now apply tree_letter. }
  intro w. change (X w /\ R w <-> tree G' (inl None) w). rewrite (SX w), (SR w), (tree_node G' None w). unfold accepts. cbn. split.
  - intros ((m & H) & K). exists [inl (Some (initial M, start G, fold_left (next M) w (initial M)))]. split.
    + apply in_flat_map. exists (fold_left (next M) w (initial M)). split; [apply all_letters|]. rewrite K. now left.
    + apply parallel_letter. now apply (B m).
  - intros (r & I & H). apply in_flat_map in I as (p & _ & I). destruct (final M p) eqn:Fp; [|easy]. destruct I as [<-|[]].
    apply of_letter in H as (m & H). apply F in H as (H & <-). auto.
Qed.

Lemma context_free_into_regular : closed_under_regular_operations CF.
Proof. apply regular_operations_by_substitution; [apply context_free_substitution|exact regular_context_free]. Qed.
Theorem context_free_union : closed Union CF.
Proof. apply union_by_substitution, context_free_into_regular. Qed.
Theorem context_free_concatenation : closed Concatenation CF.
Proof. apply concatenation_by_substitution, context_free_into_regular. Qed.
Theorem context_free_star : closed Star CF.
Proof. apply star_by_substitution, context_free_into_regular. Qed.
Theorem context_free_plus : closed Plus CF.
Proof. apply plus_by_substitution, context_free_into_regular. Qed.
Theorem context_free_finite_substitution : closed FiniteSubstitution CF.
Proof. apply finite_substitution_by_substitution; [apply context_free_substitution|exact regular_context_free]. Qed.
Theorem context_free_homomorphism : closed Homomorphism CF.
Proof. apply homomorphism_by_substitution, context_free_finite_substitution. Qed.
Theorem context_free_non_erasing_homomorphism : closed NonErasingHomomorphism CF.
Proof. apply non_erasing_homomorphism_by_homomorphism, context_free_homomorphism. Qed.
Theorem context_free_gsm_mapping : closed GsmMapping CF.
Proof. apply gsm_by_substitution; [apply context_free_finite_substitution|apply context_free_intersection_with_regular]. Qed.
Theorem context_free_inverse_homomorphism : closed InverseHomomorphism CF.
Proof.
  apply inverse_homomorphism_by_substitution; [apply context_free_substitution|apply context_free_intersection_with_regular|exact regular_context_free].
Qed.
