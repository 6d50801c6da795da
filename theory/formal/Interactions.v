(* Systems with interactions: closure is refuted for eleven operations by one lemma on languages over one letter.  Far
   from the ends of a long word all letters have the same successors.  Let the lengths in a language lie in pairs x, x + 1
   that are farther and farther apart.  If these successors had two lengths, or a length above 1, there would be words
   whose lengths are too close.  So a step adds a bounded number of letters and does not reach the next pair. *)
From Algae Require Import Words Regular AbstractFamily NonClosure.

Notation row n := (repeat tt n).
Lemma is_row (w : list unit) : w = row (length w).
Proof. induction w as [|[] w IH]; cbn; congruence. Qed.
Lemma firstn_row i n : firstn i (row n) = row (min i n).
Proof. revert n. induction i as [|i IH]; intros [|n]; cbn; auto. now rewrite IH. Qed.

Section OneLetter.
  Variable G : interactive unit.
  Hypothesis total : forall p x q, successors G p x q <> [].
  Notation l := (left_width G).
  Notation r := (right_width G).
  Definition inside : list (list unit) := successors G (row l) tt (row r).

  Lemma some_step p v : exists w, context_step G p v w.
  Proof.
    revert p. induction v as [|x v IH]; intro p; [eexists; constructor|]. destruct (IH (x :: p)) as (w & H).
    destruct (successors G (firstn l p) x (firstn r v)) as [|u us] eqn:Q; [now apply total in Q|].
    exists (u ++ w). constructor; auto. rewrite Q. now left.
  Qed.
  Lemma bounded_step p v : exists m, forall w, context_step G p v w -> length w <= m.
  Proof.
    revert p. induction v as [|x v IH]; intro p; [exists 0; intros w H; inversion H; auto|]. destruct (IH (x :: p)) as (m & H).
    assert (Q : forall us : list (list unit), exists k, forall u, In u us -> length u <= k).
    { induction us as [|u us (k & K)]; [now exists 0|]. exists (length u + k). intros u' [<-|I]; [lia|]. specialize (K u' I). lia. }
    destruct (Q (successors G (firstn l p) x (firstn r v))) as (k & K). exists (k + m). intros w S. inversion S as [|p0 x0 v0 u z I J]; subst.
    rewrite app_length. specialize (K _ I). specialize (H _ J). lia.
  Qed.
  (* what is on the left matters as far as the left width *)
  Lemma left_context p p' v w : firstn l p = firstn l p' -> context_step G p v w -> context_step G p' v w.
  Proof.
    intros Q H. revert p' Q. induction H as [|p x v u w I H IH]; intros p' Q; constructor; [now rewrite <- Q|].
    apply IH. destruct l as [|k]; auto. cbn. f_equal. apply (f_equal (firstn k)) in Q. rewrite !firstn_firstn in Q.
    now replace (min k (S k)) with k in Q by lia.
  Qed.

  (* the first c letters of what remains of a word, where r more letters follow them *)
  Fixpoint heads (c i : nat) (w : list unit) : Prop :=
    match c with
    | 0 => w = []
    | S c => exists u w', w = u ++ w' /\ In u (successors G (row (min l i)) tt (row r)) /\ heads c (S i) w'
    end.
  Lemma step_heads c i w : context_step G (row i) (row (c + r)) w <->
    exists w1 w2, w = w1 ++ w2 /\ heads c i w1 /\ context_step G (row (i + c)) (row r) w2.
  Proof.
    revert i w. induction c as [|c IH]; intros i w; cbn.
    - rewrite Nat.add_0_r. split; [intro H; exists [], w; auto|now intros (w1 & w2 & -> & -> & H)].
    - rewrite <- plus_n_Sm. split.
      + intro H. inversion H as [|p0 x0 v0 u z I J]; subst. change (tt :: row i) with (row (S i)) in J. apply IH in J as (w1 & w2 & -> & H1 & H2).
        exists (u ++ w1), w2. rewrite app_assoc. split; auto. split; auto. exists u, w1. repeat split; auto.
        rewrite !firstn_row in I. now replace (min r (c + r)) with r in I by lia.
      + intros (w1 & w2 & -> & (u & w' & -> & I & H1) & H2). rewrite <- app_assoc. constructor.
        * rewrite !firstn_row. now replace (min r (c + r)) with r by lia.
        * apply (IH (S i)). eauto.
  Qed.
  Lemma heads_split c c' i w : heads (c + c') i w <-> exists w1 w2, w = w1 ++ w2 /\ heads c i w1 /\ heads c' (i + c) w2.
  Proof.
    revert i w. induction c as [|c IH]; intros i w; cbn.
    - rewrite Nat.add_0_r. split; [intro H; exists [], w; auto|now intros (w1 & w2 & -> & -> & H)].
    - rewrite <- plus_n_Sm. split.
      + intros (u & w' & -> & I & (w1 & w2 & -> & H1 & H2)%IH). exists (u ++ w1), w2. rewrite app_assoc. split; auto. split; auto. eauto 6.
      + intros (w1 & w2 & -> & (u & w' & -> & I & H1) & H2). exists u, (w' ++ w2). rewrite app_assoc. repeat split; auto. apply IH. eauto.
  Qed.
  Lemma heads_inside c i w : l <= i -> heads c i w <-> parallel (fun _ u => In u inside) (row c) w.
  Proof.
    revert i w. induction c as [|c IH]; intros i w L; cbn.
    - now rewrite parallel_empty.
    - rewrite parallel_first. replace (min l i) with l by lia. assert (E : forall w', heads c (S i) w' <-> parallel (fun _ u => In u inside) (row c) w') by (intro; apply IH; lia).
      setoid_rewrite E. reflexivity.
  Qed.
  Definition front (w : list unit) : Prop := heads l 0 w.
  Definition rear (w : list unit) : Prop := context_step G (row l) (row r) w.
  Lemma long_step k w : context_step G [] (row (l + k + r)) w <->
    exists w1 w2 w3, w = w1 ++ w2 ++ w3 /\ front w1 /\ parallel (fun _ u => In u inside) (row k) w2 /\ rear w3.
  Proof.
    assert (Rear : forall w, context_step G (row (l + k)) (row r) w <-> rear w).
    { intro z. unfold rear. split; apply left_context; rewrite !firstn_row; f_equal; lia. }
    rewrite (step_heads (l + k) 0). cbn [Nat.add]. setoid_rewrite Rear. setoid_rewrite heads_split. cbn [Nat.add]. split.
    - intros (w1 & w3 & -> & (w2 & w4 & -> & H1 & H2) & H3). exists w2, w4, w3. rewrite <- app_assoc. repeat split; auto. revert H2. now apply heads_inside.
    - intros (w1 & w2 & w3 & -> & H1 & H2 & H3). exists (w1 ++ w2), w3. rewrite <- app_assoc. repeat split; auto. exists w1, w2. repeat split; auto. revert H2. now apply heads_inside.
  Qed.
  Lemma some_ends : exists w1 w3, front w1 /\ rear w3.
  Proof.
    destruct (some_step [] (row (l + 0 + r))) as (w & H). apply long_step in H as (w1 & w2 & w3 & _ & H1 & _ & H3). eauto.
  Qed.
  Lemma bounded_ends : exists m, forall w1 w3, front w1 -> rear w3 -> length w1 + length w3 <= m.
  Proof.
    destruct (bounded_step [] (row (l + 0 + r))) as (m & H). exists m. intros w1 w3 H1 H3.
    rewrite <- app_length. apply H, long_step. exists w1, [], w3. repeat split; auto. constructor.
  Qed.
  Lemma bounded_short n : exists m, forall k w, k <= n -> context_step G [] (row k) w -> length w <= m.
  Proof.
    induction n as [|n (m & IH)].
    - destruct (bounded_step [] []) as (m & H). exists m. intros k w L H'. replace k with 0 in H' by lia. auto.
    - destruct (bounded_step [] (row (S n))) as (m' & H). exists (m + m'). intros k w L H'. destruct (Nat.eq_dec k (S n)) as [->|N].
      + specialize (H w H'). lia.
      + specialize (IH k w ltac:(lia) H'). lia.
  Qed.
  Lemma inside_choice (u u' : list unit) i j : In u inside -> In u' inside ->
    parallel (fun _ u => In u inside) (row (i + j)) (row (i * length u + j * length u')).
  Proof.
    intros I I'. rewrite !repeat_app. apply parallel_append.
    - clear I' j. induction i as [|i IH]; [constructor|]. cbn [Nat.mul]. rewrite repeat_app, <- is_row. now constructor.
    - clear I i. induction j as [|j IH]; [constructor|]. cbn [Nat.mul]. rewrite repeat_app, <- is_row. now constructor.
  Qed.
  Lemma inside_length s k w : (forall u, In u inside -> length u = s) -> parallel (fun _ u => In u inside) (row k) w -> length w = k * s.
  Proof.
    intro H. revert w. induction k as [|k IH]; cbn; intros w P; [now apply parallel_empty in P as ->|].
    apply parallel_first in P as (u & w' & -> & I & P). rewrite app_length, (H u I), (IH _ P). reflexivity.
  Qed.
End OneLetter.

Theorem sparse_pairs_not_interacting (K : nat -> Prop) :
  (forall n, exists x, n <= x /\ K x /\ K (S x)) ->
  (forall d, exists n, forall x e, n <= x -> K x -> K (x + e) -> 2 <= e <= d -> False) ->
  ~ is IL (fun w : list unit => K (length w)).
Proof.
  intros pairs sparse (G & _ & total & S). set (c := left_width G + right_width G).
  assert (keeps : forall x w, K x -> context_step G [] (row x) w -> K (length w)).
  { intros x w Kx H. apply S. apply (context_next _ (row x)); auto. apply S. now rewrite repeat_length. }
  destruct (some_ends G total) as (w1 & w3 & F1 & R3).
  assert (makes : forall x i j u u', K x -> x = c + (i + j) -> In u (inside G) -> In u' (inside G) ->
    K (length w1 + length w3 + (i * length u + j * length u'))).
  { intros x i j u u' Kx -> I I'. specialize (keeps _ (w1 ++ row (i * length u + j * length u') ++ w3) Kx).
    rewrite !app_length, repeat_length in keeps. rewrite <- Nat.add_assoc, (Nat.add_comm (length w3)). apply keeps.
    replace (c + (i + j)) with (left_width G + (i + j) + right_width G) by (unfold c; lia). apply long_step; auto.
    exists w1, (row (i * length u + j * length u')), w3. repeat split; auto. now apply inside_choice. }
  assert (one_length : forall u u', In u (inside G) -> In u' (inside G) -> ~ length u < length u').
  { intros u u' I I' L. set (d := length u' - length u) in *. destruct (sparse (2 * d)) as (n & H). destruct (pairs (c + 2 + n)) as (x & Lx & Kx & _).
    pose proof (makes x 2 (x - c - 2) u u' Kx ltac:(lia) I I') as K1. pose proof (makes x 0 (x - c) u u' Kx ltac:(lia) I I') as K2.
    apply (H (length w1 + length w3 + (2 * length u + (x - c - 2) * length u')) (2 * d)); [nia|exact K1| |lia].
    replace (length w1 + length w3 + (2 * length u + (x - c - 2) * length u') + 2 * d) with (length w1 + length w3 + (0 * length u + (x - c) * length u')); auto.
    unfold d. nia. }
  destruct (inside G) as [|u0 us] eqn:Q; [now apply total in Q|]. rewrite <- Q in *. assert (I0 : In u0 (inside G)) by (rewrite Q; now left).
  set (s := length u0) in *.
  assert (lengths : forall u, In u (inside G) -> length u = s).
  { intros u I. pose proof (one_length u u0 I I0). pose proof (one_length u0 u I0 I). lia. }
  assert (small : s <= 1).
  { destruct (le_lt_dec s 1) as [|L]; auto. exfalso. destruct (sparse s) as (n & H). destruct (pairs (c + n)) as (x & Lx & K1 & K2).
    pose proof (makes x 0 (x - c) u0 u0 K1 ltac:(lia) I0 I0) as M1. pose proof (makes (Datatypes.S x) 0 (Datatypes.S x - c) u0 u0 K2 ltac:(lia) I0 I0) as M2.
    assert (Es : length u0 = s) by reflexivity. rewrite Es in M1, M2. clearbody s. assert (Ln : n <= (x - c) * s) by (assert (n <= x - c) by lia; nia).
    apply (H (length w1 + length w3 + (0 + (x - c) * s)) s); [lia|exact M1| |lia]. replace (Datatypes.S x - c) with (Datatypes.S (x - c)) in M2 by lia. cbn [Nat.mul] in *.
    replace (length w1 + length w3 + (0 + (x - c) * s) + s) with (length w1 + length w3 + (0 + (s + (x - c) * s))) by lia. exact M2. }
  destruct (bounded_ends G) as (m & ends). destruct (bounded_short G c) as (m' & short).
  destruct (sparse (m + 1)) as (n1 & H1). destruct (sparse 2) as (n2 & H2).
  destruct (pairs (n1 + n2 + m' + length (first_word G))) as (x & Lx & K1 & K2).
  assert (Below : forall w, context_generates G w -> length w <= Datatypes.S x).
  { intros w H. induction H as [|v w H IH St]; [lia|]. assert (Kv : K (length v)) by (now apply S).
    rewrite (is_row v) in St. pose proof (keeps _ _ Kv St) as Kw. destruct (le_lt_dec (length v) c) as [L|L]; [specialize (short _ _ L St); lia|].
    replace (length v) with (left_width G + (length v - c) + right_width G) in St by (unfold c in *; lia).
    apply long_step in St as (v1 & v2 & v3 & -> & F & P & R); auto. apply (inside_length G s) in P; auto. specialize (ends v1 v3 F R).
    assert (Lw : length (v1 ++ v2 ++ v3) <= length v + m) by (rewrite !app_length, P; nia).
    destruct (le_lt_dec (length (v1 ++ v2 ++ v3)) (Datatypes.S x)) as [|Lt]; auto. exfalso.
    apply (H1 x (length (v1 ++ v2 ++ v3) - x)); [lia|exact K1| |lia]. now replace (x + (length (v1 ++ v2 ++ v3) - x)) with (length (v1 ++ v2 ++ v3)) by lia. }
  destruct (pairs (Datatypes.S (Datatypes.S x))) as (y & Ly & Ky & _).
  assert (Ky' : K (length (row y))) by now rewrite repeat_length. apply S, Below in Ky'. rewrite repeat_length in Ky'. lia.
Qed.

(* ---- the lengths 2^n + e and 2^n + e + 1 ---- *)
Definition near (e n0 x : nat) : Prop := exists n, n0 <= n /\ (x = 2 ^ n + e \/ x = 2 ^ n + e + 1).
Lemma power_larger n : n < 2 ^ n.
Proof. apply Nat.pow_gt_lin_r. lia. Qed.
Lemma power_step i j : i < j -> 2 ^ i + 2 ^ i <= 2 ^ j.
Proof. intro L. assert (2 ^ S i <= 2 ^ j) by (apply Nat.pow_le_mono_r; lia). cbn [Nat.pow] in *. lia. Qed.
Theorem near_not_interacting e n0 : ~ is IL (fun w : list unit => near e n0 (length w)).
Proof.
  apply sparse_pairs_not_interacting.
  - intro n. exists (2 ^ (n + n0) + e). pose proof (power_larger (n + n0)). split; [lia|]. split; exists (n + n0); split; lia.
  - intro d. exists (2 ^ d + e + 2). intros x f L (i & _ & Hi) (j & _ & Hj) Hf.
    assert (d <= i) by (destruct (le_lt_dec d i); auto; pose proof (power_step i d l); lia).
    pose proof (power_larger d). assert (2 ^ d <= 2 ^ i) by (apply Nat.pow_le_mono_r; lia).
    destruct (lt_eq_lt_dec i j) as [[C|C]|C]; [pose proof (power_step i j C)|subst|pose proof (power_step j i C)]; lia.
Qed.

(* ---- some languages with interactions ---- *)
Theorem interacting_0L {A : Set} (X : language A) : is OL X -> is IL X.
Proof.
  intros (G & (ax & _ & single & g) & S). destruct (tables G) as [|t [|]] eqn:Q; try (specialize (single eq_refl); discriminate).
  exists (Interactive (axiom G) 0 0 (fun _ x _ => t x)). split; [exact ax|]. split; [cbn; intros _ x _; now apply (g t x); left|].
  assert (E : forall p v w, context_step (Interactive (axiom G) 0 0 (fun _ x _ => t x)) p v w <-> step t v w).
  { intros p v w. split.
    - induction 1 as [|p x v u w I H IH]; constructor; auto.
    - intro H. revert p. induction H as [|x u v w I H IH]; intro p; constructor; auto. }
  intro w. rewrite (S w). unfold generates. rewrite Q. split.
  - induction 1 as [|v w t' H IH [<-|[]] St]; [apply (context_axiom (Interactive (axiom G) 0 0 (fun _ x _ => t x)))|]. apply (context_next _ v); auto. now apply E.
  - induction 1 as [|v w H IH St%E]; [constructor|]. apply (derives_step _ _ v w t); auto. now left.
Qed.
Definition zero : kind := Kind false false false false.
Lemma doubling_row n : flat_map (fun _ : unit => [tt; tt]) (row n) = row (n + n).
Proof. induction n as [|n IH]; cbn; auto. rewrite IH, Nat.add_succ_r. reflexivity. Qed.
Definition powers : language unit := fun w => exists n, w = row (2 ^ n).
Lemma powers_interacting : is IL powers.
Proof.
  apply interacting_0L, (iterates zero (fun _ => [tt; tt]) [tt]); auto; try easy; [now exists 0| |].
  - intros w (n & ->). exists (S n). rewrite doubling_row. f_equal. cbn. lia.
  - intros w (n & ->). induction n as [|n IH]; [constructor|]. apply (derives_step _ _ (row (2 ^ n)) _ (fun _ => [[tt; tt]])); [exact IH|now left|].
    apply (fixed_step (fun _ => [tt; tt])). rewrite doubling_row. f_equal. cbn. lia.
Qed.
(* the first letter stays, all others double *)
Definition powers_and_one : language unit := fun w => exists n, w = row (2 ^ n + 1).
Definition first_stays : interactive unit := Interactive [tt; tt] 1 0 (fun p _ _ => match p with [] => [[tt]] | _ => [[tt; tt]] end).
Lemma first_stays_step m w : context_step first_stays [] (row (S m)) w <-> w = row (m + m + 1).
Proof.
  assert (D : forall p m w, context_step first_stays (tt :: p) (row m) w <-> w = row (m + m)).
  { intros p k. revert p. induction k as [|k IH]; intros p z; cbn [repeat]; split.
    - now inversion 1.
    - intros ->. constructor.
    - intro H. inversion H as [|p0 x0 v0 u y I J]; subst. apply IH in J as ->. destruct I as [<-|[]]. cbn. now rewrite Nat.add_succ_r.
    - intros ->. replace (row (S k + S k)) with ([tt; tt] ++ row (k + k)) by (cbn; now rewrite Nat.add_succ_r).
      constructor; [now left|now apply IH]. }
  cbn [repeat]. split.
  - intro H. inversion H as [|p0 x0 v0 u y I J]; subst. apply D in J as ->. destruct I as [<-|[]]. now rewrite Nat.add_1_r.
  - intros ->. rewrite Nat.add_1_r. apply (context_cons first_stays [] tt (row m) [tt]); [now left|now apply D].
Qed.
Lemma powers_and_one_interacting : is IL powers_and_one.
Proof.
  exists first_stays. split; [easy|]. split; [intros [|] ? ?; easy|]. intro w. split.
  - intros (n & ->). induction n as [|n IH]; [constructor|]. apply (context_next _ _ _ IH). rewrite (Nat.add_1_r (2 ^ n)).
    apply first_stays_step. f_equal. cbn. lia.
  - induction 1 as [|v w H (n & ->) St]; [now exists 0|]. exists (S n). rewrite (Nat.add_1_r (2 ^ n)) in St.
    apply first_stays_step in St as ->. f_equal. cbn. lia.
Qed.
Definition one_or_two : language unit := fun w => w = [tt] \/ w = [tt; tt].
Lemma one_or_two_interacting : is IL one_or_two.
Proof.
  exists (Interactive [tt] 1 1 (fun p _ q => match p, q with [], [] => [[tt; tt]] | _, _ => [[tt]] end)).
  split; [easy|]. split; [intros [|] ? [|]; easy|]. intro w. split.
  - intros [->| ->]; [apply (context_axiom (Interactive _ _ _ _))|]. apply (context_next _ [tt]); [apply (context_axiom (Interactive _ _ _ _))|].
    apply (context_cons _ [] tt [] [tt; tt]); [now left|constructor].
  - induction 1 as [|v w H IH St]; [now left|]. right. destruct IH as [->| ->].
    + inversion St as [|p0 x0 v0 u y I J]; subst. inversion J; subst. destruct I as [<-|[]]. reflexivity.
    + inversion St as [|p0 x0 v0 u y I J]; subst. inversion J as [|p1 x1 v1 u' y' I' J']; subst. inversion J'; subst.
      destruct I as [<-|[]], I' as [<-|[]]. reflexivity.
Qed.

(* ---- union, concatenation and what has it as a special case ---- *)
Theorem interacting_not_closed_under_union : ~ closed Union IL.
Proof.
  intro C. apply (near_not_interacting 0 0). specialize (C unit _ _ _ powers_interacting powers_and_one_interacting). revert C. apply is_same.
  intro w. unfold union, powers, powers_and_one, near. split.
  - intros [(n & ->)|(n & ->)]; exists n; rewrite repeat_length; lia.
  - intros (n & _ & [Q|Q]); [left|right]; exists n; rewrite (is_row w), Q; f_equal; lia.
Qed.
Lemma sums : same (concatenation powers one_or_two) (fun w => near 1 0 (length w)).
Proof.
  intro w. unfold concatenation, powers, one_or_two, near. split.
  - intros (u & v & -> & (n & ->) & [->| ->]); exists n; rewrite app_length, repeat_length; cbn; lia.
  - intros (n & _ & [Q|Q]); [exists (row (2 ^ n)), [tt]|exists (row (2 ^ n)), [tt; tt]]; (split; [|split; [eauto|auto]]);
      rewrite (is_row w), Q; [rewrite repeat_app|rewrite <- Nat.add_assoc, repeat_app]; reflexivity.
Qed.
Theorem interacting_not_closed_under_concatenation : ~ closed Concatenation IL.
Proof.
  intro C. apply (near_not_interacting 1 0), (is_same _ _ _ sums). exact (C unit _ _ _ powers_interacting one_or_two_interacting).
Qed.
Theorem interacting_not_closed_under_substitution : ~ closed Substitution IL.
Proof.
  intro C. apply (near_not_interacting 1 0), (is_same _ _ _ sums).
  specialize (C bool _ unit _ (fun x => if x then one_or_two else powers) _ (interacting_0L _ (single_word zero [false; true] eq_refl ltac:(easy)))).
  specialize (C ltac:(intros []; [apply one_or_two_interacting|apply powers_interacting])). revert C. apply is_same.
  intro w. unfold substitution, concatenation. split.
  - intros (u & <- & H). apply parallel_first in H as (w1 & w2 & -> & H1 & H2). apply of_letter in H2. eauto.
  - intros (u & v & -> & H1 & H2). exists [false; true]. split; auto. constructor; auto. now apply parallel_letter.
Qed.
(* b a^(2^n), and with b -> cc also cc a^(2^n) *)
Definition marked (u : list (option bool)) : language (option bool) := fun w => exists n, w = u ++ repeat None (2 ^ n).
Definition marked_double (x : option bool) : list (option bool) := match x with None => [None; None] | Some _ => [x] end.
Lemma marked_double_row n : flat_map marked_double (repeat None n) = repeat None (n + n).
Proof. induction n as [|n IH]; cbn; auto. rewrite IH, Nat.add_succ_r. reflexivity. Qed.
Lemma marked_interacting : is IL (marked [Some false]).
Proof.
  apply interacting_0L, (iterates zero marked_double [Some false; None]); auto; try easy; [intros [|]; easy|now exists 0| |].
  - intros w (n & ->). exists (S n). cbn. rewrite marked_double_row. do 2 f_equal. lia.
  - intros w (n & ->). induction n as [|n IH]; [constructor|]. apply (derives_step _ _ ([Some false] ++ repeat None (2 ^ n)) _ (fun x => [marked_double x])); [exact IH|now left|].
    apply fixed_step. cbn. rewrite marked_double_row. do 2 f_equal. lia.
Qed.
Theorem interacting_not_closed_under_finite_substitution : ~ closed FiniteSubstitution IL.
Proof.
  intro C. apply (near_not_interacting 1 0). set (s := fun x : option bool => match x with None => [[tt]] | Some _ => [[tt]; [tt; tt]] end).
  specialize (C (option bool) _ unit _ s _ marked_interacting). revert C. apply is_same.
  assert (Q : forall n w, parallel (fun x u => In u (s x)) (repeat None n) w <-> w = row n).
  { induction n as [|n IH]; intro w; cbn [repeat]; [now rewrite parallel_empty|]. rewrite parallel_first. split.
    - intros (u & w' & -> & [<-|[]] & ->%IH). reflexivity.
    - intros ->. exists [tt], (row n). split; auto. split; [now left|now apply IH]. }
  intro w. unfold finite_substitution, substitution, near. split.
  - intros (u & (n & ->) & H). apply parallel_first in H as (u1 & w' & -> & I & H). apply Q in H as ->. exists n. rewrite app_length, repeat_length.
    destruct I as [<-|[<-|[]]]; cbn; lia.
  - intros (n & _ & H). exists ([Some false] ++ repeat None (2 ^ n)). split; [now exists n|]. apply parallel_first.
    destruct H as [H|H]; [exists [tt], (row (2 ^ n))|exists [tt; tt], (row (2 ^ n))]; (split; [|split; [cbn; auto|now apply Q]]);
      rewrite (is_row w), H; [rewrite Nat.add_1_r|replace (2 ^ n + 1 + 1) with (S (S (2 ^ n))) by lia]; reflexivity.
Qed.
Lemma two_marks_interacting : is IL (fun w => marked [Some false] w \/ exists n, 1 <= n /\ w = [Some true; Some true] ++ repeat None (2 ^ n)).
Proof.
  apply interacting_0L. set (t := fun x : option bool => match x with None => [[None; None]] | Some true => [[x]] | Some false => [[x]; [Some true; Some true]] end).
  exists (System [Some false; None] [t]). split.
  - split; [easy|]. split; [easy|]. split; [easy|]. intros t' x [<-|[]]. split; [now destruct x as [[]|]|easy].
  - assert (R : forall n w, step t (repeat None n) w <-> w = repeat None (n + n)).
    { induction n as [|n IH]; intro w; cbn [repeat]; [apply parallel_empty|]. unfold step in *. rewrite parallel_first. split.
      - intros (u & w' & -> & [<-|[]] & ->%IH). cbn. now rewrite Nat.add_succ_r.
      - intros ->. exists [None; None], (repeat None (n + n)). split; [cbn; now rewrite Nat.add_succ_r|]. split; [now left|now apply IH]. }
    intro w. split.
    + assert (M : forall n, generates (System [Some false; None] [t]) ([Some false] ++ repeat None (2 ^ n))).
      { induction n as [|n IH]; [constructor|]. apply (derives_step _ _ _ _ t IH); [now left|]. constructor; [now left|]. apply R. f_equal. cbn. lia. }
      intros [(n & ->)|(n & L & ->)]; [apply M|]. destruct n as [|n]; [lia|]. apply (derives_step _ _ _ _ t (M n)); [now left|].
      constructor; [right; now left|]. apply R. f_equal. cbn. lia.
    + unfold generates. cbn. induction 1 as [|v w t' H IH [<-|[]] S]; [left; now exists 0|].
      destruct IH as [(n & ->)|(n & L & ->)]; apply parallel_first in S as (u & w' & -> & I & S).
      * apply R in S as ->. replace (2 ^ n + 2 ^ n) with (2 ^ Datatypes.S n) by (cbn; lia).
        destruct I as [<-|[<-|[]]]; [left; now exists (Datatypes.S n)|right; exists (Datatypes.S n); split; [lia|reflexivity]].
      * apply parallel_first in S as (u' & w'' & -> & I' & S). apply R in S as ->. destruct I as [<-|[]], I' as [<-|[]].
        right. exists (Datatypes.S n). split; [lia|]. replace (2 ^ n + 2 ^ n) with (2 ^ Datatypes.S n) by (cbn; lia). reflexivity.
Qed.
Theorem interacting_not_closed_under_non_erasing_homomorphism : ~ closed NonErasingHomomorphism IL.
Proof.
  intro C. apply (near_not_interacting 1 0). specialize (C (option bool) _ unit _ (fun _ => [tt]) _ ltac:(easy) two_marks_interacting). revert C. apply is_same.
  assert (Q : forall w : list (option bool), flat_map (fun _ => [tt]) w = row (length w)) by (induction w; cbn; congruence).
  intro w. unfold image, near. setoid_rewrite Q. split.
  - intros (u & [(n & ->)|(n & _ & ->)] & ->); exists n; rewrite !repeat_length, app_length, repeat_length; cbn; lia.
  - intros (n & _ & H). destruct n as [|n].
    + cbn in H. destruct H as [H|H]; [exists [Some false; None]; split; [left; now exists 0|]|exists [Some false; None; None]; split; [left; now exists 1|]];
        rewrite (is_row w), H; reflexivity.
    + destruct H as [H|H]; [exists ([Some false] ++ repeat None (2 ^ S n)); split; [left; now exists (S n)|]|
        exists ([Some true; Some true] ++ repeat None (2 ^ S n)); split; [right; exists (S n); split; [lia|auto]|]];
        rewrite (is_row w), H, app_length, repeat_length; f_equal; cbn [length]; lia.
Qed.
Theorem interacting_not_closed_under_homomorphism : ~ closed Homomorphism IL.
Proof. intro C. now apply interacting_not_closed_under_non_erasing_homomorphism, non_erasing_homomorphism_by_homomorphism. Qed.
