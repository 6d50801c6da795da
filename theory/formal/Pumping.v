(* The pumping lemma of context-free languages.  The words a^n b^n c^n are not context-free, so these languages are not
   closed under intersection and complement. *)
From Algae Require Import Words Regular AbstractFamily ContextFree.

Section Pumping.
  Context {A N : Set} {n : Alphabet N}.
  Variable G : grammar A N.
  (* a part of a tree, from X down to Y, with l and r at the leaves on its left and right *)
  Definition down (X Y : N) (l r : list A) : Prop := forall w, tree G (inl Y) w -> tree G (inl X) (l ++ w ++ r).
  Lemma down_more X Y Z l r l' r' : down X Y l r -> down Y Z l' r' -> down X Z (l ++ l') (r' ++ r).
  Proof. intros H K w T. specialize (H _ (K w T)). now rewrite <- !app_assoc in *. Qed.
  Fixpoint times (i : nat) (v : list A) : list A := match i with 0 => [] | S i => v ++ times i v end.
  Lemma times_more i v : times (S i) v = times i v ++ v.
  Proof. induction i as [|i IH]; cbn in *; [now rewrite app_nil_r|]. now rewrite <- app_assoc, <- IH. Qed.
  Lemma down_times X v y i : down X X v y -> down X X (times i v) (times i y).
  Proof.
    intro H. induction i as [|i IH]; [intros w T; cbn; now rewrite app_nil_r|].
    rewrite (times_more i v). apply (down_more X X X); auto.
  Qed.

  Lemma long_child d r w k : parallel (yields G d) r w -> length r * k < length w ->
    exists r1 z r2 w1 w2 w3, r = r1 ++ z :: r2 /\ w = w1 ++ w2 ++ w3 /\ parallel (yields G d) r1 w1 /\ yields G d z w2 /\
      parallel (yields G d) r2 w3 /\ k < length w2.
  Proof.
    induction 1 as [|z u r w H K IH]; cbn; [lia|]. rewrite app_length. intro L. destruct (le_lt_dec (length u) k) as [Le|Lt].
    - destruct IH as (r1 & z' & r2 & w1 & w2 & w3 & -> & -> & H1 & H2 & H3 & H4); [lia|].
      exists (z :: r1), z', r2, (u ++ w1), w2, w3. rewrite <- app_assoc. repeat split; auto.
    - exists [], z, r, [], u, w. repeat split; auto.
  Qed.
  Lemma rules_bounded : exists m, 1 <= m /\ forall X r, In r (rules G X) -> length r <= m.
  Proof.
    assert (Q : forall l : list (list (N + A)), exists m, forall r, In r l -> length r <= m).
    { induction l as [|r l (m & IH)]; [now exists 0|]. exists (length r + m). intros r' [<-|I]; [lia|]. specialize (IH r' I). lia. }
    destruct (Q (flat_map (rules G) letters)) as (m & H). exists (S m). split; [lia|]. intros X r I. specialize (H r). rewrite in_flat_map in H.
    enough (length r <= m) by lia. apply H. exists X. split; auto. apply all_letters.
  Qed.

  Variable m : nat.
  Hypothesis one : 1 <= m.
  Hypothesis bounded : forall X r, In r (rules G X) -> length r <= m.
  Notation root := (start G).
  (* on the way from the root down to X; what was passed, and the words that hang beside *)
  Lemma pump d X w l r passed W : yields G d (inl X) w -> W = l ++ w ++ r -> down root X l r -> NoDup passed ->
    (forall Z, In Z passed -> exists l1 v y r1, down root Z l1 r1 /\ down Z X v y /\ v ++ y <> [] /\ l = l1 ++ v /\ r = y ++ r1) ->
    m ^ (length (@letters N _) - length passed) < length w ->
    exists u v x y z, W = u ++ v ++ x ++ y ++ z /\ v ++ y <> [] /\ forall i, tree G (inl root) (u ++ times i v ++ x ++ times i y ++ z).
  Proof.
    revert X w l r passed. induction d as [|d IH]; intros X w l r passed T -> R ND Pass L; [easy|].
    destruct (in_dec letter_eq X passed) as [I|NI].
    - destruct (Pass X I) as (l1 & v & y & r1 & R1 & Dn & Ne & -> & ->). exists l1, v, w, y, r1. split; [now rewrite <- !app_assoc|]. split; auto.
      intro i. replace (l1 ++ times i v ++ w ++ times i y ++ r1) with (l1 ++ (times i v ++ w ++ times i y) ++ r1) by now rewrite <- !app_assoc.
      apply R1, (down_times X v y i Dn). now exists (S d).
    - assert (ND' : NoDup (X :: passed)) by now constructor.
      assert (K : length passed < length (@letters N _)) by (apply (NoDup_incl_length ND'); intros Z _; apply all_letters).
      assert (E : length (@letters N _) - length passed = S (length (@letters N _) - length (X :: passed))) by (cbn; lia).
      assert (B : 1 <= m ^ (length (@letters N _) - length (X :: passed))) by (pose proof (Nat.pow_nonzero m (length (@letters N _) - length (X :: passed))); lia).
      rewrite E in L. cbn [Nat.pow] in L. set (k := m ^ (length (@letters N _) - length (X :: passed))) in *.
      destruct T as (rhs & I & T). destruct (long_child d rhs w k T) as (r1 & z & r2 & w1 & w2 & w3 & -> & -> & T1 & T2 & T3 & L2).
      { pose proof (bounded X rhs I). nia. }
      destruct z as [Y|x]; [|assert (w2 = [x]) as -> by (destruct d; exact T2); cbn in L2; lia].
      assert (Dn : down X Y w1 w3).
      { intros w' T'. apply tree_node. exists (r1 ++ inl Y :: r2). split; auto. apply parallel_append; [|constructor; auto];
          eapply parallel_weaken; try eassumption; intros z u _ T0; now exists d. }
      destruct (list_eq_dec Nat.eq_dec [length w1; length w3] [0; 0]) as [Q|Q].
      + (* nothing hangs beside *)
        assert (w1 = [] /\ w3 = []) as (-> & ->) by (destruct w1, w3; try discriminate; auto).
        apply (IH Y w2 l r passed); auto; [cbn; now rewrite app_nil_r| | |].
        * intros w' T'. apply R. specialize (Dn w' T'). cbn in Dn. now rewrite app_nil_r in Dn.
        * intros Z J. destruct (Pass Z J) as (l1 & v & y & r1' & R1 & D1 & Ne & -> & ->). exists l1, v, y, r1'. repeat split; auto.
          intros w' T'. apply D1. specialize (Dn w' T'). cbn in Dn. now rewrite app_nil_r in Dn.
        * rewrite E. cbn [Nat.pow]. cbn in L. rewrite app_nil_r in L. exact L.
      + assert (Ne : w1 ++ w3 <> []) by (intros (-> & ->)%app_eq_nil; now apply Q).
        apply (IH Y w2 (l ++ w1) (w3 ++ r) (X :: passed)); auto; [now rewrite <- !app_assoc|now apply (down_more root X Y)|].
        intros Z [<-|J]; [exists l, w1, w3, r; auto|]. destruct (Pass Z J) as (l1 & v & y & r1' & R1 & D1 & Ne1 & -> & ->).
        exists l1, (v ++ w1), (w3 ++ y), r1'. repeat split; auto; [now apply (down_more Z X Y)| |now rewrite <- app_assoc|now rewrite <- app_assoc].
        intros ((-> & ->)%app_eq_nil & (-> & ->)%app_eq_nil)%app_eq_nil. now apply Ne.
  Qed.
End Pumping.

Theorem pumping_lemma {A : Set} (X : language A) : context_free X -> exists p, forall w, X w -> p < length w ->
  exists u v x y z, w = u ++ v ++ x ++ y ++ z /\ v ++ y <> [] /\ forall i, X (u ++ times i v ++ x ++ times i y ++ z).
Proof.
  intros (N & n & G & S)%context_free_trees. destruct (rules_bounded G) as (m & one & bounded).
  exists (m ^ length (@letters N _)). intros w (d & T)%S L.
  destruct (pump G m one bounded d (start G) w [] [] [] w T) as (u & v & x & y & z & Q & Ne & H); auto.
  - now rewrite app_nil_r.
  - intros w' T'. cbn. now rewrite app_nil_r.
  - constructor.
  - easy.
  - cbn [length]. now rewrite Nat.sub_0_r.
  - exists u, v, x, y, z. split; auto. split; auto. intro i. apply S, H.
Qed.

(* ---- a^n b^n c^n ---- *)
Local Notation letter := (option bool).
Definition a : letter := Some false.
Definition b : letter := Some true.
Definition c : letter := None.
Definition abc (i j k : nat) : list letter := repeat a i ++ repeat b j ++ repeat c k.
Definition rank (x : letter) : nat := match x with Some false => 0 | Some true => 1 | None => 2 end.
Fixpoint ordered (w : list letter) : Prop := match w with [] => True | x :: w => (forall y, In y w -> rank x <= rank y) /\ ordered w end.
Lemma ordered_parts u v x y : ordered (u ++ v) -> In x u -> In y v -> rank x <= rank y.
Proof.
  induction u as [|z u IH]; [easy|]. cbn. intros (H & O) [->|I] J; [|auto]. apply H, in_or_app. auto.
Qed.
Lemma ordered_row x i w : ordered w -> (forall y, In y w -> rank x <= rank y) -> ordered (repeat x i ++ w).
Proof.
  intros O H. induction i as [|i IH]; cbn; auto. split; auto. intros y [I|I]%in_app_or; auto. apply repeat_spec in I as ->. lia.
Qed.
Lemma abc_ordered i j k : ordered (abc i j k).
Proof.
  assert (C : ordered (repeat c k)) by (rewrite <- (app_nil_r (repeat c k)); apply ordered_row; easy).
  apply ordered_row; [apply ordered_row; auto|]; intros y I; cbn; try lia. apply repeat_spec in I as ->. cbn. lia.
Qed.
Local Notation count := (count_occ (@letter_eq letter _)).
Lemma count_row x y n : count (repeat x n) y = if letter_eq x y then n else 0.
Proof. induction n as [|n IH]; cbn [repeat count_occ]; [now destruct letter_eq|]. rewrite IH. now destruct letter_eq. Qed.
Lemma count_abc i j k : count (abc i j k) a = i /\ count (abc i j k) b = j /\ count (abc i j k) c = k.
Proof. unfold abc. rewrite !count_occ_app, !count_row. cbn. lia. Qed.
Lemma same_letter u v z x y : ordered (u ++ v ++ v ++ z) -> In x v -> In y v -> x = y.
Proof.
  intros O I J. assert (Q : forall x y, In x v -> In y v -> rank x <= rank y).
  { intros x' y' I' J'. rewrite (app_assoc u v) in O. apply (ordered_parts _ _ x' y' O); apply in_or_app; auto. }
  pose proof (Q x y I J). pose proof (Q y x J I). destruct x as [[]|], y as [[]|]; cbn in *; auto; lia.
Qed.
Theorem abc_not_context_free : ~ is CF (fun w => exists n, w = abc n n n).
Proof.
  intros (p & H)%pumping_lemma. destruct (H (abc (S p) (S p) (S p))) as (u & v & x & y & z & Q & Ne & T); [eauto| |].
  { unfold abc. rewrite !app_length, !repeat_length. lia. }
  destruct (T 2) as (n & E). cbn [times] in E. rewrite !app_nil_r, <- !app_assoc in E.
  pose proof (abc_ordered n n n) as O. rewrite <- E in O.
  assert (V : forall s t, In s v -> In t v -> s = t) by (intros s t; apply (same_letter u v (x ++ y ++ y ++ z)); exact O).
  assert (Y : forall s t, In s y -> In t y -> s = t).
  { intros s t. apply (same_letter (u ++ v ++ v ++ x) y z). now rewrite <- !app_assoc. }
  (* all three letters are in v or y *)
  assert (C : forall s, count v s + count y s = n - S p).
  { intro s. assert (C1 : count (abc (S p) (S p) (S p)) s = S p) by (destruct s as [[]|]; apply count_abc).
    assert (C2 : count (abc n n n) s = n) by (destruct s as [[]|]; apply count_abc). rewrite Q in C1. rewrite <- E in C2. repeat rewrite count_occ_app in C1. repeat rewrite count_occ_app in C2. lia. }
  assert (Some_in : n - S p <> 0).
  { intro Z. destruct (v ++ y) as [|s w] eqn:Qs; [easy|]. specialize (C s). rewrite Z, <- count_occ_app, Qs in C.
    rewrite count_occ_cons_eq in C by easy. lia. }
  assert (In_one : forall s, In s v \/ In s y).
  { intro s. specialize (C s). destruct (Nat.eq_dec (count v s) 0); [right|left]; apply (count_occ_In letter_eq); lia. }
  destruct (In_one a) as [Ia|Ia], (In_one b) as [Ib|Ib], (In_one c) as [Ic|Ic];
    try (discriminate (V _ _ Ia Ib)); try (discriminate (V _ _ Ia Ic)); try (discriminate (V _ _ Ib Ic));
    try (discriminate (Y _ _ Ia Ib)); try (discriminate (Y _ _ Ia Ic)); discriminate (Y _ _ Ib Ic).
Qed.

(* ---- it is the intersection of two context-free languages, in which membership is decided by counting ---- *)
Definition nested : grammar bool unit := Grammar tt (fun _ => [[]; [inr false; inl tt; inr true]]).
Lemma nested_words : is CF (fun w => exists n, w = repeat false n ++ repeat true n).
Proof.
  apply context_free_trees. exists unit, _, nested. intro w. split.
  - intros (n & ->). induction n as [|n IH]; apply tree_node.
    + exists []. split; [now left|constructor].
    + exists [inr false; inl tt; inr true]. split; [right; now left|].
      replace (repeat false (S n) ++ repeat true (S n)) with ([false] ++ (repeat false n ++ repeat true n) ++ [true])
        by (rewrite <- app_assoc, <- (repeat_cons n true); reflexivity).
      constructor; [now apply (tree_letter nested)|]. constructor; [exact IH|]. apply parallel_letter. now apply (tree_letter nested).
  - intros (d & H). revert w H. induction d as [|d IH]; intros w H; [easy|]. destruct H as (r & [<-|[<-|[]]] & H).
    + apply parallel_empty in H as ->. now exists 0.
    + apply parallel_first in H as (u1 & w1 & -> & H1 & H). apply parallel_first in H as (u2 & w2 & -> & H2 & H). apply of_letter in H.
      assert (u1 = [false] /\ w2 = [true]) as (-> & ->) by (destruct d; split; assumption).
      destruct (IH _ H2) as (n & ->). exists (S n). cbn. now rewrite <- app_assoc, <- repeat_cons.
Qed.
Lemma any_row (x : letter) : regular (fun w => exists n, w = repeat x n).
Proof.
  apply (is_same REG (fun w => forallb (fun y => if letter_eq x y then true else false) w = true)); [|apply regular_words_of].
  intro w. rewrite forallb_forall. split.
  - intro H. exists (length w). induction w as [|y w IH]; cbn; auto. f_equal; [|apply IH; intros; apply H; now right].
    specialize (H y ltac:(now left)). now destruct (letter_eq x y).
  - intros (n & ->) y I. apply repeat_spec in I as ->. now destruct letter_eq.
Qed.
Definition ab_equal : language letter := fun w => exists i k, w = abc i i k.
Definition bc_equal : language letter := fun w => exists i j, w = abc i j j.
Lemma map_row {X Y : Set} (h : X -> list Y) x y n : h x = [y] -> flat_map h (repeat x n) = repeat y n.
Proof. intro Q. induction n as [|n IH]; cbn; auto. now rewrite Q, IH. Qed.
Lemma ab_equal_context_free : is CF ab_equal.
Proof.
  set (h := fun x : bool => if x then [b] else [a]).
  apply (is_same CF (concatenation (image h (fun w => exists n, w = repeat false n ++ repeat true n)) (fun w => exists n, w = repeat c n))).
  2: { under context_free_concatenation; [under context_free_homomorphism; apply nested_words|].
       under regular_context_free. apply any_row. }
  intro w. unfold concatenation, image, ab_equal, abc. split.
  - intros (u & v & -> & (z & (n & ->) & ->) & (k & ->)). exists n, k. now rewrite flat_map_app, (map_row h false a), (map_row h true b), <- app_assoc.
  - intros (n & k & ->). exists (repeat a n ++ repeat b n), (repeat c k). split; [now rewrite app_assoc|]. split; [|eauto].
    exists (repeat false n ++ repeat true n). split; [eauto|]. now rewrite flat_map_app, (map_row h false a), (map_row h true b).
Qed.
Lemma bc_equal_context_free : is CF bc_equal.
Proof.
  set (h := fun x : bool => if x then [c] else [b]).
  apply (is_same CF (concatenation (fun w => exists n, w = repeat a n) (image h (fun w => exists n, w = repeat false n ++ repeat true n)))).
  2: { under context_free_concatenation; [under regular_context_free; apply any_row|].
       under context_free_homomorphism. apply nested_words. }
  intro w. unfold concatenation, image, bc_equal, abc. split.
  - intros (u & v & -> & (k & ->) & z & (n & ->) & ->). exists k, n. now rewrite flat_map_app, (map_row h false b), (map_row h true c).
  - intros (k & n & ->). exists (repeat a k), (repeat b n ++ repeat c n). split; [reflexivity|]. split; [eauto|].
    exists (repeat false n ++ repeat true n). split; [eauto|]. now rewrite flat_map_app, (map_row h false b), (map_row h true c).
Qed.
Lemma both_equal : same (intersection ab_equal bc_equal) (fun w => exists n, w = abc n n n).
Proof.
  intro w. unfold intersection, ab_equal, bc_equal. split.
  - intros ((i & k & ->) & (i' & j & Q)). exists i. destruct (count_abc i i k) as (_ & B & C), (count_abc i' j j) as (_ & B' & C').
    rewrite Q in B, C. congruence.
  - intros (n & ->). split; now exists n, n.
Qed.
Theorem context_free_not_closed_under_intersection : ~ closed Intersection CF.
Proof.
  intro C. apply abc_not_context_free, (is_same _ _ _ both_equal). exact (C letter _ _ _ ab_equal_context_free bc_equal_context_free).
Qed.
Lemma stable (X : language letter) (f g h : list letter -> nat) : (forall w, X w <-> w = abc (f w) (g w) (h w)) -> forall w, ~ ~ X w -> X w.
Proof. intros E w H. apply E. destruct (word_eq w (abc (f w) (g w) (h w))) as [Q|N]; auto. destruct H. intro Xw. now apply N, E. Qed.
Theorem context_free_not_closed_under_complement : ~ closed Complement CF.
Proof.
  intro C. apply abc_not_context_free.
  apply (is_same _ (complement (union (complement ab_equal) (complement bc_equal)))).
  2: { under C. under context_free_union; under C; [exact ab_equal_context_free|exact bc_equal_context_free]. }
  intro w. rewrite <- (both_equal w). unfold complement, union, intersection. split.
  - intro H. split.
    + apply (stable ab_equal (fun w => count w a) (fun w => count w a) (fun w => count w c)); [|auto].
      intro v. split; [|unfold ab_equal; eauto]. intros (i & k & ->). now destruct (count_abc i i k) as (-> & _ & ->).
    + apply (stable bc_equal (fun w => count w a) (fun w => count w b) (fun w => count w b)); [|auto].
      intro v. split; [|unfold bc_equal; eauto]. intros (i & j & ->). now destruct (count_abc i j j) as (-> & -> & _).
  - intros (H & K) [N|N]; auto.
Qed.
