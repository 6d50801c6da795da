(* L-systems without nonterminals are not closed under star and plus.  B has the words b a^(2^n).  If a system generates
   the star or the plus of B, each of the words b a^(2^N) b a with N large is derived from itself only, as in
   theory/closure/star-not-0l.claim.  But there is one axiom. *)
From Algae Require Import Words Obstruction NonClosure Complement.

Definition power_of_two (n : nat) : Prop := exists k, n = 2 ^ k.
Lemma no_progression x y z : power_of_two x -> power_of_two y -> power_of_two z -> x + z = 2 * y -> x = y.
Proof.
  assert (Q : forall x y z, power_of_two x -> power_of_two y -> power_of_two z -> x + z = 2 * y -> y < z -> False).
  { clear. intros x y z (i & ->) (j & ->) (k & ->) H L. apply Nat.pow_lt_mono_r_iff in L; [|lia].
    assert (2 ^ (S j) <= 2 ^ k) by (apply Nat.pow_le_mono_r; lia). cbn [Nat.pow] in *. pose proof (Nat.pow_nonzero 2 i). lia. }
  intros Hx Hy Hz H. destruct (lt_eq_lt_dec y z) as [[L|L]|L]; [now destruct (Q x y z)|lia|].
  destruct (Q z y x); auto; lia.
Qed.

Notation row n := (repeat a n).
Definition block (n : nat) : list bool := b :: row n.
Definition B : language bool := fun w => exists n, w = block (2 ^ n).
(* empty, or with b in front *)
Definition b_ahead (w : list bool) : Prop := match w with a :: _ => False | _ => True end.
Lemma plus_b_ahead w : plus B w -> exists w', w = b :: w'.
Proof.
  intros (us & N & -> & F). destruct us as [|u us]; [easy|]. destruct (F u ltac:(now left)) as (n & ->). cbn. eauto.
Qed.
Lemma equal_rows i j r r' : b_ahead r -> b_ahead r' -> row i ++ r = row j ++ r' -> i = j.
Proof.
  revert j. induction i as [|i IH]; intros [|j] H H'; cbn; auto; [intros ->; easy|intros <-; easy|intros [=]; f_equal; eauto].
Qed.
Lemma b_behind_row i r p y : row i ++ r = p ++ b :: y -> exists p', p = row i ++ p' /\ r = p' ++ b :: y.
Proof.
  revert p. induction i as [|i IH]; cbn; intros p Q; [eauto|]. destruct p as [|x p]; [discriminate|].
  injection Q as <- Q. destruct (IH _ Q) as (p' & -> & ->). eauto.
Qed.
(* every row of letters a is a power of two *)
Lemma rows_are_powers w p n q : plus B w -> w = p ++ b :: row n ++ q -> b_ahead q -> power_of_two n.
Proof.
  intros (us & _ & -> & F). revert p. induction us as [|u us IH]; cbn; intros p Q H; [now destruct p|].
  destruct (F u ltac:(now left)) as (k & ->).
  assert (R : b_ahead (concat us)).
  { destruct us as [|u' us]; [easy|]. destruct (F u' ltac:(right; now left)) as (k' & ->). easy. }
  destruct p as [|x p]; cbn in Q; injection Q.
  - intro Q'. exists k. symmetry. now apply (equal_rows _ _ (concat us) q).
  - intros Q' _. apply b_behind_row in Q' as (p' & -> & Q'). apply (IH (fun u' I => F u' (or_intror I)) p' Q' H).
Qed.
Lemma block_in n : plus B (block (2 ^ n)).
Proof. exists [block (2 ^ n)]. split; [easy|]. split; [cbn; now rewrite app_nil_r|]. intros u [<-|[]]. now exists n. Qed.
Lemma two_blocks_in n k : plus B (block (2 ^ n) ++ block (2 ^ k)).
Proof.
  exists [block (2 ^ n); block (2 ^ k)]. split; [easy|]. split; [cbn; now rewrite app_nil_r|].
  intros u [<-|[<-|[]]]; [now exists n|now exists k].
Qed.

(* ---- words without b, and the last and the first b of the others ---- *)
Lemma row_or_b u : u = row (length u) \/ In b u.
Proof. induction u as [|[|] u [IH|IH]]; cbn; auto. left. now f_equal. Qed.
Lemma first_b u : In b u -> exists i r, u = row i ++ b :: r.
Proof.
  induction u as [|[|] u IH]; [easy| |]; [now exists 0, u|]. intros [|I]; [discriminate|]. destruct (IH I) as (i & r & ->). now exists (S i), r.
Qed.
Lemma last_b u : In b u -> exists p e, u = p ++ b :: row e.
Proof.
  induction u as [|x u IH]; [easy|]. intro I. destruct (row_or_b u) as [Q|J].
  - destruct I as [->|I]; [exists [], (length u); cbn; now f_equal|]. rewrite Q in I. now apply repeat_spec in I.
  - destruct (IH J) as (p & e & ->). now exists (x :: p), e.
Qed.
Lemma row_append i j : row i ++ row j = row (i + j).
Proof. symmetry. apply repeat_app. Qed.

(* ---- a table that keeps the language ---- *)
Section Table.
  Variable X : language bool.
  Hypothesis has : forall w, plus B w -> X w.
  Hypothesis only : forall w, X w -> w = [] \/ plus B w.
  Variable t : table bool.
  Hypothesis total : forall x, t x <> [].
  Hypothesis keeps : forall w v, X w -> step t w v -> X v.

  Lemma kept w v : plus B w -> step t w v -> v = [] \/ plus B v.
  Proof. intros H S. apply only. apply (keeps w); auto. Qed.
  Lemma not_a_ahead w v : plus B w -> step t w v -> b_ahead v.
  Proof. intros H S. destruct (kept w v H S) as [->|K]; [easy|]. destruct (plus_b_ahead _ K) as (v' & ->). easy. Qed.
  Lemma some x : exists u, In u (t x).
  Proof. specialize (total x). destruct (t x) as [|u us]; [easy|]. exists u. now left. Qed.
  Lemma short v u : In v (t b) -> In u (t a) -> step t (block (2 ^ 0)) (v ++ u).
  Proof. intros I J. cbn. constructor; auto. now apply parallel_letter. Qed.
  Lemma long v u1 u2 u3 u4 : In v (t b) -> In u1 (t a) -> In u2 (t a) -> In u3 (t a) -> In u4 (t a) -> step t (block (2 ^ 2)) (v ++ u1 ++ u2 ++ u3 ++ u4).
  Proof. intros. cbn. repeat (constructor; auto). now apply parallel_letter. Qed.
  Lemma b_gives v : In v (t b) -> b_ahead v.
  Proof. intro I. destruct (some a) as (u & J). pose proof (not_a_ahead _ _ (block_in 0) (short v u I J)) as H. now destruct v as [|[] v]. Qed.
  Lemma b_gives_b v s : In v (t b) -> In (row (S s)) (t a) -> exists v', v = b :: v'.
  Proof.
    intros I J. pose proof (not_a_ahead _ _ (block_in 0) (short v _ I J)) as H. destruct v as [|[] v]; [easy|eauto|easy].
  Qed.
  Lemma row_image p e v w n q : plus B w -> step t w (v ++ q) -> v = p ++ b :: row e -> forall q', q = row n ++ q' -> b_ahead q' -> power_of_two (e + n).
  Proof.
    intros H S -> q' -> Hq. destruct (kept _ _ H S) as [Q|K]; [now destruct p|].
    apply (rows_are_powers _ p (e + n) q' K); auto. rewrite <- row_append, <- !app_assoc. reflexivity.
  Qed.
  Lemma one_length s r : In (row (S s)) (t a) -> In (row r) (t a) -> r = S s.
  Proof.
    intros I J. destruct (some b) as (v & Iv). destruct (b_gives_b v s Iv I) as (v' & Q).
    destruct (last_b v) as (p & e & Qv); [rewrite Q; now left|].
    assert (F : forall i j k l, In (row i) (t a) -> In (row j) (t a) -> In (row k) (t a) -> In (row l) (t a) -> power_of_two (e + (i + (j + (k + l))))).
    { intros i j k l Hi Hj Hk Hl. apply (row_image p e v _ _ _ (block_in 2) (long v _ _ _ _ Iv Hi Hj Hk Hl) Qv []); [|easy].
      now rewrite !row_append, app_nil_r. }
    assert (E : e + (r + (r + (r + r))) = e + (S s + (r + (r + r)))); [|lia].
    apply (no_progression _ _ (e + (S s + (S s + (r + r))))); auto. lia.
  Qed.
  Lemma no_b s u : In (row (S s)) (t a) -> In u (t a) -> ~ In b u.
  Proof.
    intros I J M. destruct (some b) as (v & Iv). destruct (b_gives_b v s Iv I) as (v' & Q).
    destruct (last_b v) as (p & e & Qv); [rewrite Q; now left|]. destruct (first_b u M) as (h & r & ->).
    set (g := S s) in *. set (u := row h ++ b :: r) in *.
    assert (F0 : power_of_two (e + h)).
    { apply (row_image p e v _ _ _ (block_in 2) (long v u (row g) (row g) (row g) Iv J I I I) Qv (b :: r ++ row g ++ row g ++ row g)); [|easy].
      unfold u. now rewrite <- app_assoc. }
    assert (F1 : power_of_two (e + (g + h))).
    { apply (row_image p e v _ _ _ (block_in 2) (long v (row g) u (row g) (row g) Iv I J I I) Qv (b :: r ++ row g ++ row g)); [|easy].
      unfold u. now rewrite <- row_append, <- !app_assoc. }
    assert (F2 : power_of_two (e + (g + (g + h)))).
    { apply (row_image p e v _ _ _ (block_in 2) (long v (row g) (row g) u (row g) Iv I I J I) Qv (b :: r ++ row g)); [|easy].
      unfold u. now rewrite <- !row_append, <- !app_assoc. }
    pose proof (no_progression _ _ _ F0 F1 F2 ltac:(lia)). unfold g in *. lia.
  Qed.

  Variable m : nat.
  Hypothesis bounded : forall x u, In u (t x) -> length u <= m.
  Notation count := (count_occ bool_dec).
  Lemma count_all w : count w a + count w b = length w.
  Proof. induction w as [|[] w IH]; cbn; lia. Qed.
  (* if no successor of a is a row, each part of an image has a b *)
  Lemma few_a : (forall u, In u (t a) -> u = [] \/ In b u) -> forall w z, step t w z -> count z a <= m * count z b.
  Proof.
    intros H w z S. induction S as [|x u w z I S IH]; [cbn; lia|]. rewrite !count_occ_app.
    assert (Q : u = [] \/ 1 <= count u b).
    { destruct x.
      - pose proof (b_gives u I) as K. destruct u as [|[] u]; [now left|right; cbn; lia|easy].
      - destruct (H u I) as [|K]; auto. right. apply (count_occ_In bool_dec) in K. lia. }
    destruct Q as [->|Q]; [cbn; lia|]. pose proof (count_all u). pose proof (bounded x u I). nia.
  Qed.

  Definition long_word (n : nat) : list bool := block (2 ^ n) ++ block (2 ^ 0).
  Lemma two_power_large n : n < 2 ^ n.
  Proof. apply Nat.pow_gt_lin_r. lia. Qed.
  Theorem from_itself_only n w : 2 * m + 2 <= n -> X w -> step t w (long_word n) -> w = long_word n.
  Proof.
    intros L Xw St. pose proof (two_power_large n) as Large.
    assert (Ca : count (long_word n) a = 2 ^ n + 1).
    { unfold long_word, block. cbn [app]. rewrite (count_occ_cons_neq bool_dec) by easy. rewrite count_occ_app, count_occ_repeat_eq by easy. reflexivity. }
    assert (Cb : count (long_word n) b = 2).
    { unfold long_word, block. cbn [app]. rewrite count_occ_cons_eq by easy. rewrite count_occ_app, count_occ_repeat_neq by easy. reflexivity. }
    destruct (only w Xw) as [->|H]; [now apply parallel_empty in St|].
    destruct (existsb (fun u => match u with [] => false | _ => forallb negb u end) (t a)) eqn:R.
    2: { exfalso. enough (K : 2 ^ n + 1 <= m * 2) by lia. rewrite <- Ca, <- Cb. apply (few_a) with (w := w); auto.
         intros u I. destruct (row_or_b u) as [Q|]; auto. left. destruct u as [|x u]; auto. exfalso.
         assert (K : existsb (fun u => match u with [] => false | _ => forallb negb u end) (t a) = true).
         { apply existsb_exists. exists (x :: u). split; auto. rewrite Q. apply forallb_forall. intros y J. now apply repeat_spec in J as ->. }
         congruence. }
    apply existsb_exists in R as (u0 & I0 & R). destruct (row_or_b u0) as [Q0|J0].
    2: { exfalso. destruct u0 as [|x u0]; [easy|]. rewrite forallb_forall in R. now apply R in J0. }
    destruct u0 as [|x u0]; [easy|]. cbn [length] in Q0. set (s := length u0) in *. rewrite Q0 in I0. clear Q0 R.
    assert (Ga : forall u, In u (t a) -> u = row (S s)).
    { intros u I. destruct (row_or_b u) as [Q|J]; [|now apply (no_b s u I0) in J]. rewrite Q in I |- *. now rewrite (one_length s _ I0 I). }
    (* every successor of b begins and ends with b *)
    assert (Gb : forall v, In v (t b) -> (exists v', v = b :: v') /\ exists p, v = p ++ [b]).
    { intros v I. destruct (b_gives_b v s I I0) as (v' & Q). split; [eauto|]. destruct (last_b v) as (p & e & Qv); [rewrite Q; now left|].
      assert (F0 : power_of_two (e + S s)) by (apply (row_image p e v _ _ _ (block_in 0) (short v _ I I0) Qv []); [now rewrite app_nil_r|easy]).
      assert (F1 : power_of_two (e + (S s + S s))).
      { apply (row_image p e v (block (2 ^ 1)) _ (row (S s) ++ row (S s)) (block_in 1)) with (q' := []); auto; [|now rewrite row_append, app_nil_r|easy].
        change (step t [b; a; a] (v ++ row (S s) ++ row (S s))). apply (parallel_cons _ b v); auto. apply (parallel_cons _ a (row (S s))); auto. now apply parallel_letter. }
      destruct F0 as (i & Fi), F1 as (j & Fj). exists p. rewrite Qv. f_equal. f_equal.
      assert (i < j) by (apply (Nat.pow_lt_mono_r_iff 2); lia). assert (2 ^ S i <= 2 ^ j) by (apply Nat.pow_le_mono_r; lia). cbn [Nat.pow] in *.
      replace e with 0 by lia. reflexivity. }
    assert (Row : forall i z, step t (row i) z -> z = row (i * S s)).
    { induction i as [|i IH]; intros z Z; [now apply parallel_empty in Z|]. apply parallel_first in Z as (u & z' & -> & I & Z).
      rewrite (Ga u I), (IH z' Z). cbn [Nat.mul]. apply row_append. }
    assert (Few : forall w z, step t w z -> count w b <= count z b).
    { intros w0 z Z. induction Z as [|y u w0 z I Z IH]; auto. rewrite count_occ_app. destruct y; cbn; [|lia].
      destruct (Gb u I) as ((v' & ->) & _). cbn. lia. }
    (* w begins with b; so it is b a^i, or has another b *)
    destruct H as (us & N & -> & F). destruct us as [|u1 us]; [easy|]. destruct (F u1 ltac:(now left)) as (k1 & ->).
    assert (Blocks : forall k z, step t (block k) z -> exists v, In v (t b) /\ z = v ++ row (k * S s)).
    { intros k z Z. apply parallel_first in Z as (v & z' & -> & I & Z). exists v. split; auto. now rewrite (Row _ _ Z). }
    cbn [concat] in St. apply parallel_split in St as (z1 & z2 & Qz & S1 & S2). apply Blocks in S1 as (v1 & I1 & ->).
    destruct us as [|u2 us].
    - exfalso. apply parallel_empty in S2 as ->. destruct (Gb v1 I1) as (_ & p1 & Qp). rewrite app_nil_r in Qz.
      assert (K : 2 ^ k1 * S s = 1).
      { unfold long_word, block in Qz. rewrite Qp, <- app_assoc in Qz. cbn [app Nat.pow repeat] in Qz.
        apply (f_equal (@rev bool)) in Qz. rewrite app_comm_cons, !rev_app_distr in Qz. cbn in Qz.
        assert (Rr : forall i, rev (row i) = row i) by (clear; induction i as [|i IH]; cbn; auto; rewrite IH; symmetry; apply repeat_cons).
        rewrite !Rr in Qz. destruct (2 ^ k1 * S s) as [|[|i]]; cbn in Qz; [discriminate|reflexivity|]. discriminate. }
      apply (f_equal (@length bool)) in Qz. rewrite app_length, repeat_length, K in Qz. pose proof (bounded _ _ I1).
      unfold long_word, block in Qz. rewrite app_length in Qz. cbn [length] in Qz. rewrite !repeat_length in Qz. cbn [Nat.pow] in Qz. lia.
    - destruct (F u2 ltac:(right; now left)) as (k2 & ->). cbn [concat] in S2. apply parallel_split in S2 as (z2' & z3 & -> & S2 & S3).
      apply Blocks in S2 as (v2 & I2 & ->). destruct (Gb v1 I1) as ((v1' & Q1) & p1 & Q1'), (Gb v2 I2) as ((v2' & Q2) & p2 & Q2').
      assert (C3 : count (concat us) b = 0 /\ count v1' b = 0 /\ count v2' b = 0).
      { pose proof (Few _ _ S3) as C. pose proof Cb as C'. rewrite Qz, !count_occ_app, Q1, Q2 in C'. cbn [count_occ] in C'.
        destruct (bool_dec b b); [|easy]. lia. }
      destruct C3 as (C3 & C1 & C2).
      assert (Us : us = []).
      { destruct us as [|u3 us]; auto. destruct (F u3 ltac:(do 2 right; now left)) as (k3 & ->). cbn in C3. discriminate. }
      subst us. apply parallel_empty in S3 as ->.
      assert (One : forall v v' p, v = b :: v' -> v = p ++ [b] -> count v' b = 0 -> v = [b]).
      { clear. intros v v' p -> Q C. destruct p as [|x p]; cbn in Q; [exact Q|]. injection Q as _ ->. rewrite count_occ_app in C. cbn in C. lia. }
      rewrite (One v1 v1' p1 Q1 Q1' C1), (One v2 v2' p2 Q2 Q2' C2) in Qz. cbn [app concat] in Qz. rewrite !app_nil_r in Qz.
      unfold long_word, block in Qz. cbn [app] in Qz. injection Qz as Qz.
      assert (K1 : 2 ^ n = 2 ^ k1 * S s) by now apply equal_rows in Qz.
      rewrite <- K1 in Qz. apply app_inv_head in Qz. injection Qz as Qz.
      assert (K2 : 1 = 2 ^ k2 * S s) by (apply (f_equal (@length bool)) in Qz; cbn [length] in Qz; now rewrite repeat_length in Qz).
      assert (s = 0) as E by (pose proof (Nat.pow_nonzero 2 k2); nia).
      unfold long_word. cbn [concat]. rewrite app_nil_r. rewrite E, Nat.mul_1_r in K1, K2. rewrite <- K1, <- K2. reflexivity.
  Qed.
End Table.

Lemma lengths_bounded (l : list (list bool)) : exists m, forall u, In u l -> length u <= m.
Proof.
  induction l as [|v l (m & IH)]; [now exists 0|]. exists (length v + m). intros u [<-|I]; [lia|]. specialize (IH u I). lia.
Qed.
Theorem star_or_plus k (X : language bool) : pure k -> (forall w, plus B w -> X w) -> (forall w, X w -> w = [] \/ plus B w) -> ~ is (LSystem k) X.
Proof.
  intros p has only. apply two_sources; auto. intros ts total keeps.
  destruct (lengths_bounded (flat_map (fun t => t a ++ t b) ts)) as (m & H).
  assert (bounded : forall t, In t ts -> forall x u, In u (t x) -> length u <= m).
  { intros t I x u J. apply H, in_flat_map. exists t. split; auto. apply in_or_app. destruct x; auto. }
  exists (long_word (2 * m + 2)), (long_word (2 * m + 3)). split; [|split; [|split]].
  - intro Q. apply (f_equal (@length bool)) in Q. unfold long_word, block in Q. rewrite !app_length in Q. cbn [length] in Q.
    rewrite !repeat_length in Q. assert (2 ^ (2 * m + 2) = 2 ^ (2 * m + 3)) as E by lia. apply Nat.pow_inj_r in E; lia.
  - apply has, two_blocks_in.
  - apply has, two_blocks_in.
  - intros t w I Xw. split; intro S;
      [apply (from_itself_only X has only t (fun x => total t x I) (fun w v => keeps t w v I) m (bounded t I) (2 * m + 2) w)|
       apply (from_itself_only X has only t (fun x => total t x I) (fun w v => keeps t w v I) m (bounded t I) (2 * m + 3) w)]; auto; lia.
Qed.

(* B is generated by a -> aa from ba *)
Definition grow (x : bool) : list bool := if x then [b] else [a; a].
Lemma grow_row n : flat_map grow (row n) = row (n + n).
Proof. induction n as [|n IH]; cbn; auto. rewrite IH, Nat.add_succ_r. reflexivity. Qed.
Lemma B_generated k : pure k -> is (LSystem k) B.
Proof.
  intro p. apply (iterates k grow [b; a]); auto; [easy|intros []; easy|now exists 0| |].
  - intros w (n & ->). exists (S n). cbn [block flat_map grow app]. rewrite grow_row. unfold block. f_equal. f_equal. cbn. lia.
  - intros w (n & ->). induction n as [|n IH]; [constructor|].
    apply (derives_step _ _ (block (2 ^ n)) _ (fun x => [grow x])); [exact IH|now left|]. apply fixed_step.
    cbn [block flat_map grow app]. rewrite grow_row. unfold block. f_equal. f_equal. cbn. lia.
Qed.
Theorem not_closed_under_star k : pure k -> ~ closed Star (LSystem k).
Proof.
  intros p C. specialize (C bool _ _ (B_generated k p)). revert C. apply star_or_plus; auto.
  - intros w (us & _ & H). now exists us.
  - intros w (us & -> & F). destruct us as [|u us]; [now left|]. right. now exists (u :: us).
Qed.
Theorem not_closed_under_plus k : pure k -> ~ closed Plus (LSystem k).
Proof. intros p C. specialize (C bool _ _ (B_generated k p)). revert C. apply star_or_plus; auto. Qed.
