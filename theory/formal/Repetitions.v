(* EDT0L is not closed under inverse homomorphisms, finite substitutions, substitutions and gsm mappings: each makes of the
   words a^(2^n) all words over a and b whose length is a power of 2, and these are not an EDT0L language.

   Let w be a word in which no factor of length m occurs twice, side by side or farther apart.  Where it is derived
   deterministically, a letter that will become a word of length m at least, a large letter, stands once in each word of the
   derivation, so there are few of them.  The other letters, the small ones, make more and more of w, and each step adds little. What
   matters of a moment is which letters there are and how long a word each will become, cut at m: few states.  So soon a state
   comes again.  Letters at the earlier moment that go on as at the later one make a word that is shorter than w, but
   not much.  Such words w exist for m = 2 n + 3 and length 2^n, as most words are so. *)
From Algae Require Import Words Runs OneTable Gaps GapsExtended.

(* ---- sums of lengths ---- *)
Section Sums.
  Context {V : Set}.
  Fixpoint sum (f : V -> nat) (u : list V) : nat := match u with [] => 0 | x :: u => f x + sum f u end.
  Lemma sum_append f u v : sum f (u ++ v) = sum f u + sum f v.
  Proof. induction u; cbn; lia. Qed.
  Lemma sum_equal f g u : (forall x, In x u -> f x = g x) -> sum f u = sum g u.
  Proof. intro H. induction u as [|x u IH]; cbn; auto. rewrite (H x), IH; cbn; auto. intros; apply H; now right. Qed.
  Lemma sum_of_two f g h u : (forall x, In x u -> f x = g x + h x) -> sum f u = sum g u + sum h u.
  Proof. intro H. induction u as [|x u IH]; cbn; auto. rewrite (H x), IH; cbn; auto; [lia|]. intros; apply H; now right. Qed.
  Lemma sum_below f g u : (forall x, In x u -> f x <= g x) -> sum f u <= sum g u.
  Proof. intro H. induction u as [|x u IH]; cbn; auto. pose proof (H x (or_introl eq_refl)). enough (sum f u <= sum g u) by lia. apply IH. intros; apply H; now right. Qed.
  Lemma sum_member f u x : In x u -> f x <= sum f u.
  Proof. induction u as [|y u IH]; [easy|]. cbn. intros [->|I]; [lia|]. specialize (IH I). lia. Qed.
  Lemma sum_bounded f u n : (forall x, In x u -> f x <= n) -> sum f u <= length u * n.
  Proof. intro H. induction u as [|x u IH]; cbn; auto. pose proof (H x (or_introl eq_refl)). enough (sum f u <= length u * n) by lia. apply IH. intros; apply H; now right. Qed.
  Lemma sum_where (p : V -> bool) f u : sum (fun x => if p x then f x else 0) u = sum f (filter p u).
  Proof. induction u as [|x u IH]; cbn; auto. destruct (p x); cbn; lia. Qed.
  Lemma sum_same f u v : NoDup u -> NoDup v -> (forall x, In x u <-> In x v) -> sum f u = sum f v.
  Proof.
    revert v. induction u as [|x u IH]; intros v N M S.
    - destruct v as [|y v]; auto. destruct (proj2 (S y) (or_introl eq_refl)).
    - inversion N as [|? ? N1 N2]; subst. destruct (in_split x v (proj1 (S x) (or_introl eq_refl))) as (v1 & v2 & ->).
      rewrite sum_append. cbn. rewrite (IH (v1 ++ v2)); [rewrite sum_append; lia|auto|now apply NoDup_remove_1 in M|].
      intro y. apply NoDup_remove_2 in M. split.
      + intro I. assert (K : In y (v1 ++ x :: v2)) by (apply S; now right). apply in_app_or in K as [K|[<-|K]]; [apply in_or_app; auto|easy|apply in_or_app; auto].
      + intro I. assert (K : In y (x :: u)) by (apply S; apply in_app_or in I; apply in_or_app; cbn; tauto). destruct K as [<-|K]; [easy|auto].
  Qed.
  Lemma flat_map_sum {A : Set} (h : V -> list A) u : length (flat_map h u) = sum (fun x => length (h x)) u.
  Proof. induction u as [|x u IH]; cbn; auto. now rewrite app_length, IH. Qed.
  Lemma sum_flat_map (h : V -> list V) f u : sum f (flat_map h u) = sum (fun x => sum f (h x)) u.
  Proof. induction u as [|x u IH]; cbn; auto. now rewrite sum_append, IH. Qed.
End Sums.

(* ---- words without repetitions ---- *)
Definition without_repetition {A : Set} (m : nat) (w : list A) : Prop := forall x v y z, w = x ++ v ++ y ++ v ++ z -> length v <> m.
Lemma large_once {A V : Set} m (h : V -> list A) u : without_repetition m (flat_map h u) -> NoDup (filter (fun x => m <=? length (h x)) u).
Proof.
  enough (Q : forall p, without_repetition m (p ++ flat_map h u) -> NoDup (filter (fun x => m <=? length (h x)) u)) by exact (Q []).
  induction u as [|x u IH]; cbn; intros p H; [constructor|].
  assert (N : NoDup (filter (fun x => m <=? length (h x)) u)) by (apply (IH (p ++ h x)); now rewrite <- app_assoc).
  destruct (m <=? length (h x)) eqn:L; auto. constructor; auto. intros (I & _)%filter_In. apply in_split in I as (u1 & u2 & ->).
  apply Nat.leb_le in L. apply (H p (firstn m (h x)) (skipn m (h x) ++ flat_map h u1) (skipn m (h x) ++ flat_map h u2)).
  - rewrite flat_map_app. cbn. rewrite <- (firstn_skipn m (h x)) at 1 2. now rewrite <- !app_assoc.
  - now rewrite firstn_length, Nat.min_l.
Qed.
(* words that have a repetition can be told from a word that is shorter by m and from two places *)
Fixpoint words (n : nat) : list (list bool) := match n with 0 => [[]] | S n => map (cons true) (words n) ++ map (cons false) (words n) end.
Lemma words_in n w : In w (words n) <-> length w = n.
Proof.
  revert w. induction n as [|n IH]; intros w; cbn.
  - destruct w; cbn; intuition discriminate.
  - rewrite in_app_iff, !in_map_iff. split.
    + intros [(v & <- & I)|(v & <- & I)]; cbn; f_equal; now apply IH.
    + destruct w as [|x w]; cbn; [easy|]. intros [= H]. destruct x; [left|right]; exists w; split; auto; now apply IH.
Qed.
Lemma words_number n : length (words n) = 2 ^ n.
Proof. induction n as [|n IH]; auto. cbn [words]. rewrite app_length, !map_length, IH. cbn. lia. Qed.
Lemma words_many n (l : list (list bool)) : (forall w, length w = n -> In w l) -> 2 ^ n <= length l.
Proof.
  revert l. induction n as [|n IH]; intros l H.
  - destruct l; cbn; [destruct (H [] eq_refl)|lia].
  - set (behind := fun x : bool => flat_map (fun w => match w with y :: v => if eqb x y then [v] else [] | [] => [] end) l).
    assert (B : forall x, 2 ^ n <= length (behind x)).
    { intro x. apply IH. intros w L. apply in_flat_map. exists (x :: w). split; [apply H; cbn; now f_equal|]. rewrite eqb_reflx. now left. }
    assert (S : length (behind true) + length (behind false) <= length l).
    { unfold behind. clear. induction l as [|[|[] w] l IH]; cbn in *; lia. }
    pose proof (B true). pose proof (B false). cbn. lia.
Qed.
Definition repetitive (n m : nat) : list (list bool) := flat_map (fun i => flat_map (fun k =>
  map (fun s => firstn k s ++ firstn m (skipn i s) ++ skipn k s) (words (n - m))) (seq 0 (S n))) (seq 0 (S n)).
Lemma repetitive_in n m (x v y z : list bool) : length v = m -> length (x ++ v ++ y ++ v ++ z) = n -> In (x ++ v ++ y ++ v ++ z) (repetitive n m).
Proof.
  rewrite !app_length. intros L N.
  apply in_flat_map. exists (length x). split; [apply in_seq; lia|]. apply in_flat_map. exists (length (x ++ v ++ y)).
  split; [apply in_seq; rewrite !app_length; lia|]. apply in_map_iff. exists (x ++ v ++ y ++ z). split.
  - assert (F : forall p q : list bool, firstn (length p) (p ++ q) = p) by (intros p q; rewrite firstn_app, firstn_all, Nat.sub_diag; apply app_nil_r).
    assert (K : forall p q : list bool, skipn (length p) (p ++ q) = q) by (intros p q; now rewrite skipn_app, skipn_all, Nat.sub_diag).
    rewrite K, <- L, F. replace (x ++ v ++ y ++ z) with ((x ++ v ++ y) ++ z) by now rewrite <- !app_assoc. rewrite F, K. now rewrite <- !app_assoc.
  - apply words_in. rewrite !app_length. lia.
Qed.
Lemma repetitive_number n m : m <= n -> length (repetitive n m) = S n * S n * 2 ^ (n - m).
Proof.
  intro L. unfold repetitive. assert (Q : forall (X : Type) (g : nat -> list X) j l, (forall i, length (g i) = j) -> length (flat_map g l) = length l * j).
  { intros X g j l H. induction l as [|i l IH]; cbn; auto. now rewrite app_length, H, IH. }
  rewrite (Q _ _ (S n * 2 ^ (n - m))); [rewrite seq_length; lia|]. intro i. rewrite (Q _ _ (2 ^ (n - m))); [now rewrite seq_length|].
  intro k. now rewrite map_length, words_number.
Qed.
Lemma word_without_repetition n : 4 <= n -> exists w : list bool, length w = 2 ^ n /\ without_repetition (2 * n + 3) w.
Proof.
  intro L. set (N := 2 ^ n). set (m := 2 * n + 3).
  assert (M : m <= N).
  { unfold m, N. clear - L. induction L as [|n L IH]; [cbn; lia|]. rewrite Nat.pow_succ_r'. lia. }
  destruct (find (fun w => if in_dec word_eq w (repetitive N m) then false else true) (words N)) as [w|] eqn:F.
  - apply find_some in F as (I & F). apply words_in in I. exists w. split; auto. intros x v y z Q Lv.
    destruct in_dec as [J|J]; [easy|]. apply J. rewrite Q in *. now apply repetitive_in.
  - exfalso. assert (C : 2 ^ N <= length (repetitive N m)).
    { apply words_many. intros w I%words_in. pose proof (find_none _ _ F w I) as G. cbv beta in G. now destruct in_dec. }
    rewrite repetitive_number in C by exact M. replace N with (m + (N - m)) in C at 1 by lia. rewrite Nat.pow_add_r in C.
    apply Nat.mul_le_mono_pos_r in C; [|apply Nat.neq_0_lt_0; now apply Nat.pow_nonzero].
    assert (E : 2 ^ m = 8 * (N * N)) .
    { unfold m, N. replace (2 * n + 3) with (3 + (n + n)) by lia. rewrite !Nat.pow_add_r. reflexivity. }
    assert (P : 1 <= N) by (unfold m in M; lia). nia.
Qed.

(* ---- derivations of such words ---- *)
Lemma leads_append {V : Set} (ts ts' : list (table V)) u v w : leads ts u v -> leads ts' v w -> leads (ts ++ ts') u w.
Proof. revert u. induction ts as [|t ts IH]; cbn; intro u; [now intros ->|]. intros (u' & S & H) K. eauto. Qed.
Section Walk.
  Context {A V : Set} {alphabet : Alphabet V}.
  Variables (fin : V -> list (list A)) (all : list (table V)).
  Hypothesis one : forall x, at_most_one (fin x) /\ forall t, In t all -> at_most_one (t x).
  Definition the {X : Type} (l : list (list X)) : list X := match l with u :: _ => u | [] => [] end.
  Lemma the_only {X : Set} (l : list (list X)) u : at_most_one l -> In u l -> the l = u.
  Proof. destruct l as [|v l]; [easy|]. intros H I. apply H; auto. now left. Qed.
  (* what a letter becomes *)
  Fixpoint yield (ts : list (table V)) (x : V) : list A :=
    match ts with [] => the (fin x) | t :: ts => flat_map (yield ts) (the (t x)) end.
  Notation becomes ts := (parallel (run fin ts)).
  Lemma becomes_yield ts u w : incl ts all -> becomes ts u w -> w = flat_map (yield ts) u.
  Proof.
    intro I. rewrite <- parallel_function. apply parallel_weaken. intros x w' _. revert x w'. induction ts as [|t ts IH]; cbn; intros x w'.
    - intro J. symmetry. now apply the_only; [apply (one x)|].
    - intros (v & J & P). rewrite (the_only (t x) v); [|apply (one x), I; now left|exact J]. apply parallel_function. revert P. apply parallel_weaken.
      intros y z _. apply IH. intros t' K. apply I. now right.
  Qed.
  Lemma becomes_all ts u w x : becomes ts u w -> In x u -> exists v, run fin ts x v.
  Proof. intros P I. destruct (parallel_member _ P I) as (v & H & _). eauto. Qed.

  Variables (m c : nat).
  Hypothesis fin_short : forall x w, In w (fin x) -> length w < m.
  Hypothesis steps_short : forall t x, In t all -> length (the (t x)) <= c.
  Definition size (ts : list (table V)) (x : V) : nat := length (yield ts x).
  Definition small ts x : nat := if size ts x <? m then size ts x else 0.
  Definition large ts x : bool := m <=? size ts x.
  Notation made ts := (sum (small ts)).                 (* how much of the word small letters make *)
  Lemma size_of_two ts x : size ts x = small ts x + if large ts x then size ts x else 0.
  Proof. unfold small, large. destruct (Nat.ltb_spec (size ts x) m), (Nat.leb_spec m (size ts x)); lia. Qed.
  Lemma length_of_two ts u : length (flat_map (yield ts) u) = made ts u + sum (size ts) (filter (large ts) u).
  Proof. rewrite flat_map_sum, <- sum_where. apply sum_of_two. intros x _. apply size_of_two. Qed.
  Lemma made_below ts u : made ts u <= length (flat_map (yield ts) u).
  Proof. rewrite length_of_two. lia. Qed.
  Lemma made_by_small ts u : length (flat_map (yield ts) u) < m -> made ts u = length (flat_map (yield ts) u).
  Proof.
    intro L. rewrite flat_map_sum in *. apply sum_equal. intros x I. apply (sum_member (fun x => length (yield ts x))) in I.
    change (length (yield ts x)) with (size ts x) in *. unfold small. destruct (Nat.ltb_spec (size ts x) m); lia.
  Qed.
  Notation d := (length (letters : list V)).
  Notation g := (d * (c * m)).
  Lemma made_grows t ts u : In t all -> NoDup (filter (large (t :: ts)) u) ->
    made (t :: ts) u <= made ts (flat_map (fun x => the (t x)) u) <= made (t :: ts) u + g.
  Proof.
    intros I N. rewrite sum_flat_map. assert (P : forall x, let made_of := made ts (the (t x)) in
      small (t :: ts) x <= made_of <= small (t :: ts) x + if large (t :: ts) x then c * m else 0).
    { intro x. cbv zeta. pose proof (made_by_small ts (the (t x))) as B. set (n := length (flat_map (yield ts) (the (t x)))) in *.
      change (small (t :: ts) x) with (if n <? m then n else 0). change (large (t :: ts) x) with (m <=? n).
      destruct (Nat.ltb_spec n m), (Nat.leb_spec m n); try lia.
      - split; [lia|]. apply (Nat.le_trans _ (length (the (t x)) * m)); [|now apply Nat.mul_le_mono_r, steps_short].
        apply sum_bounded. intros y _. unfold small. destruct (Nat.ltb_spec (size ts y) m); lia. }
    split; [apply sum_below; intros x _; apply P|]. apply (Nat.le_trans _ (sum (fun x => small (t :: ts) x + if large (t :: ts) x then c * m else 0) u)).
    - apply sum_below. intros x _. apply P.
    - rewrite (sum_of_two _ (small (t :: ts)) (fun x => if large (t :: ts) x then c * m else 0)) by reflexivity.
      apply Nat.add_le_mono_l. rewrite (sum_where (large (t :: ts)) (fun _ => c * m)).
      apply (Nat.le_trans _ (length (filter (large (t :: ts)) u) * (c * m))); [now apply sum_bounded|].
      apply Nat.mul_le_mono_r, NoDup_incl_length; auto. intros x _. apply all_letters.
  Qed.

  (* ---- the state of a moment: which letters there are, and how long a word each will become, cut at m ---- *)
  Definition moment ts u : list nat := map (fun x => if in_dec letter_eq x u then S (min m (size ts x)) else 0) letters.
  Lemma moment_in ts u : In (moment ts u) (vectors d (m + 2)).
  Proof.
    unfold moment. rewrite <- (map_length (fun x => if in_dec letter_eq x u then S (min m (size ts x)) else 0)) at 1. apply vectors_have.
    intros i (x & <- & _)%in_map_iff. destruct in_dec; lia.
  Qed.
  Lemma same_moment ts u ts' u' x : moment ts u = moment ts' u' ->
    (In x u <-> In x u') /\ (In x u -> min m (size ts x) = min m (size ts' x)).
  Proof.
    intro Q. pose proof (ext_in_map Q x (all_letters x)) as E. cbn in E. destruct (in_dec letter_eq x u), (in_dec letter_eq x u'); intuition congruence.
  Qed.
  (* from the earlier moment it can go on as from the later one *)
  Lemma skip w ts u ts' u' : incl ts all -> incl ts' all -> without_repetition m w -> becomes ts u w -> becomes ts' u' w ->
    moment ts u = moment ts' u' -> exists w', becomes ts u' w' /\ length w' + made ts u = length w + made ts' u'.
  Proof.
    intros I I' N P P' Q. assert (E : exists w', becomes ts u' w').
    { apply parallel_exists. intros x J. apply (becomes_all ts u w); auto. now apply (same_moment ts u ts' u'). }
    destruct E as (w' & E). exists w'. split; auto. pose proof (becomes_yield _ _ _ I P) as Pw. pose proof (becomes_yield _ _ _ I' P') as Pw'.
    rewrite (becomes_yield _ _ _ I E), Pw at 1. rewrite !length_of_two. assert (M : made ts u' = made ts' u').
    { apply sum_equal. intros x J. destruct (same_moment ts u ts' u' x Q) as (S1 & S2). specialize (S2 (proj2 S1 J)). unfold small.
      destruct (Nat.ltb_spec (size ts x) m), (Nat.ltb_spec (size ts' x) m); lia. }
    assert (B : forall x, In x u' -> large ts x = large ts' x).
    { intros x J. destruct (same_moment ts u ts' u' x Q) as (S1 & S2). specialize (S2 (proj2 S1 J)). unfold large.
      destruct (Nat.leb_spec m (size ts x)), (Nat.leb_spec m (size ts' x)); lia. }
    rewrite (sum_same (size ts) (filter (large ts) u') (filter (large ts) u)); [lia| | |].
    - rewrite (filter_ext_in _ _ _ B). apply large_once. now rewrite <- Pw'.
    - apply large_once. now rewrite <- Pw.
    - intro x. rewrite !filter_In. now rewrite (proj1 (same_moment ts u ts' u' x Q)).
  Qed.

  Variable reached : list V -> Prop.
  Hypothesis reached_next : forall t u v, reached u -> In t all -> step t u v -> reached v.
  Notation bound := (m + (m + 2) ^ d * g).
  Lemma walk w ts u seen : without_repetition m w -> incl ts all -> reached u -> becomes ts u w ->
    NoDup seen -> (forall s, In s seen -> exists ts' u', s = moment ts' u' /\ incl ts' all /\ reached u' /\ becomes ts' u' w /\ made ts' u' < made ts u) ->
    made ts u <= m + length seen * g ->
    length w <= bound \/ exists ts' u' w', incl ts' all /\ reached u' /\ becomes ts' u' w' /\ length w' < length w <= length w' + bound.
  Proof.
    intro W. revert u seen. induction ts as [|t ts IH]; intros u seen I R P N H M.
    1: left. 2: destruct (in_dec (list_eq_dec Nat.eq_dec) (moment (t :: ts) u) seen) as [J|J].
    1, 2: assert (F : length seen <= (m + 2) ^ d) by (rewrite <- vectors_number; apply (NoDup_incl_length N); intros s Js;
      destruct (H s Js) as (ts' & u' & -> & _); apply moment_in); assert (G : length seen * g <= (m + 2) ^ d * g) by now apply Nat.mul_le_mono_r.
    - rewrite (becomes_yield [] u w I P), flat_map_sum. replace (sum _ u) with (made [] u); [lia|].
      apply sum_equal. intros x J. unfold small. destruct (becomes_all [] u w x P J) as (v & Iv). cbn in Iv.
      replace (size [] x) with (length v) by (unfold size; cbn; now rewrite (the_only (fin x) v (proj1 (one x)) Iv)). apply fin_short in Iv as L.
      apply Nat.ltb_lt in L. rewrite L. cbn. now rewrite (the_only (fin x) v (proj1 (one x)) Iv).
    - right. destruct (H _ J) as (ts' & u' & Q & I' & R' & P' & L). destruct (skip w (t :: ts) u ts' u') as (w' & E & Lw); auto.
      exists (t :: ts), u', w'. repeat split; auto; lia.
    - assert (It : In t all) by (apply I; now left). assert (K : NoDup (filter (large (t :: ts)) u)).
      { apply large_once. now rewrite <- (becomes_yield _ _ _ I P). }
      pose proof (made_grows t ts u It K) as (G1 & G2). set (v := flat_map (fun x => the (t x)) u) in *.
      assert (S : step t u v /\ becomes ts v w).
      { apply (parallel_compose (fun x u => In u (t x)) (run fin ts)) in P as (v' & S & P). enough (v' = v) as -> by auto.
        apply parallel_function. revert S. apply parallel_weaken. intros x z _ Iz. symmetry. apply the_only; auto. now apply (one x). }
      destruct S as (S & P'). assert (I' : incl ts all) by (intros t' Jt; apply I; now right).
      destruct (Nat.eq_dec (made ts v) (made (t :: ts) u)) as [E|E].
      + apply (IH v seen); eauto; [|lia]. now rewrite E.
      + apply (IH v (moment (t :: ts) u :: seen)); eauto.
        * now constructor.
        * intros s [<-|Js]; [exists (t :: ts), u; repeat split; auto; lia|]. destruct (H s Js) as (ts' & u' & Q1 & Q2 & Q3 & Q4 & Q5).
          exists ts', u'. repeat split; auto; lia.
        * cbn. lia.
  Qed.
End Walk.
Theorem shorter_word {A : Set} (X : language A) : runs true true X -> exists c d, forall m w, c <= m -> X w -> without_repetition m w ->
  let bound := m + (m + 2) ^ d * (d * (c * m)) in length w <= bound \/ exists w', X w' /\ length w' < length w <= length w' + bound.
Proof.
  intros (V & v & starts & ts & fin & _ & o & same). specialize (o eq_refl).
  destruct (longest (flat_map fin letters)) as (F & HF), (longest (flat_map (fun t => flat_map t letters) ts)) as (C & HC).
  exists (S (F + C)), (length (letters : list V)). intros m w L Xw W bound. apply same in Xw as (x & ts0 & Ix & I0 & H).
  set (reached := fun u => exists y before, In y starts /\ incl before ts /\ leads before [y] u).
  destruct (walk fin ts o m (S (F + C))) with (reached := reached) (w := w) (ts := ts0) (u := [x]) (seen := @nil (list nat)) as [E|E]; auto.
  - intros y z I. assert (length z <= F) by (apply HF, in_flat_map; eauto using all_letters). lia.
  - intros t y I. enough (length (the (t y)) <= C) by lia. destruct (t y) as [|z zs] eqn:Q; [cbn; lia|]. apply HC, in_flat_map.
    exists t. split; auto. apply in_flat_map. exists y. split; [apply all_letters|]. rewrite Q. now left.
  - intros t u z (y & before & Iy & Ib & K) I Su. exists y, (before ++ [t]). split; auto. split; [|eapply leads_more; eauto].
    apply incl_app; auto. now intros t' [<-|[]].
  - exists x, []. repeat split; auto. easy.
  - now apply parallel_letter.
  - constructor.
  - easy.
  - cbn. unfold small. destruct (Nat.ltb_spec (size fin ts0 x) m); lia.
  - right. destruct E as (ts' & u & w' & I & (y & before & Iy & Ib & K) & P & Lw). exists w'. split; auto. apply same.
    exists y, (before ++ ts'). split; auto. split; [now apply incl_app|]. apply of_letter, run_leads. apply run_leads in P as (z & K' & Fz).
    exists z. split; auto. eapply leads_append; eauto.
Qed.

(* ---- the words whose length is a power of 2 ---- *)
Definition power_length : language bool := fun w => exists n, length w = 2 ^ n.
Lemma polynomial_below c d : exists n, 4 <= n /\ let m := 2 * n + 3 in c <= m /\ m + (m + 2) ^ d * (d * (c * m)) < 2 ^ (n - 1).
Proof.
  set (q := c + 2 * d + 10). exists (2 ^ q). assert (Q : forall i, 4 <= i -> i * i <= 2 ^ i).
  { intros i L. induction L as [|i L IH]; [cbn; lia|]. rewrite Nat.pow_succ_r'. nia. }
  pose proof (Q q ltac:(lia)) as Lq. set (n := 2 ^ q) in *. assert (q <= n) by nia. split; [lia|]. cbv zeta. split; [lia|].
  assert (E : 2 * n + 3 + 2 <= 2 ^ (q + 3)) by (rewrite Nat.pow_add_r; fold n; cbn [Nat.pow]; lia).
  apply (Nat.le_lt_trans _ ((2 ^ (q + 3)) ^ d * (2 ^ d * (2 ^ c * 2 ^ (q + 3))) + 2 ^ (q + 3))).
  - rewrite Nat.add_comm. apply Nat.add_le_mono; [|lia]. pose proof (power_above d). pose proof (power_above c).
    repeat apply Nat.mul_le_mono; try lia. now apply Nat.pow_le_mono_l.
  - rewrite <- Nat.pow_mul_r, <- !Nat.pow_add_r. set (e := (q + 3) * d + (d + (c + (q + 3)))).
    assert (2 ^ (q + 3) <= 2 ^ e) by (apply Nat.pow_le_mono_r; unfold e; lia). apply (Nat.le_lt_trans _ (2 ^ S e)); [rewrite Nat.pow_succ_r'; lia|].
    apply Nat.pow_lt_mono_r; [lia|]. apply (Nat.lt_le_trans _ (q * q - 1)); [|lia]. unfold e, q in *. nia.
Qed.
Theorem power_length_not_edt0l : ~ is EDT0L power_length.
Proof.
  intro H. apply (runs_of_system true true), shorter_word in H as (c & d & H). destruct (polynomial_below c d) as (n & L & Lc & B).
  destruct (word_without_repetition n L) as (w & Lw & W). destruct n as [|n]; [lia|]. rewrite Nat.sub_1_r in B. cbn [Nat.pred] in B.
  destruct (H _ w Lc) as [E|(w' & (j & Lj) & E1 & E2)]; auto.
  - now exists (S n).
  - rewrite Lw, Nat.pow_succ_r' in E. lia.
  - rewrite Lw, Nat.pow_succ_r' in E2. rewrite Lw, Lj in E1. apply Nat.pow_lt_mono_r_iff in E1; [|lia].
    assert (P : 2 ^ j <= 2 ^ n) by (apply Nat.pow_le_mono_r; lia). rewrite Lj in E2. lia.
Qed.

(* ---- the cells ---- *)
Local Notation a := false.
Definition powers_of_a : language bool := fun w => exists i, w = repeat a (2 ^ i).
Lemma powers_of_a_is : is EDT0L powers_of_a.
Proof.
  apply (is_same EDT0L (fun w => exists i, In w (becomes i doubling))); [|now apply (started true true)].
  intro w. split; intros (i & H); exists i; cbn in *; intuition.
Qed.
Definition any_letter (x : bool) : list (list bool) := [[false]; [true]].
Lemma any_letters (u w : list bool) : parallel (fun x v => In v (any_letter x)) u w <-> length u = length w.
Proof.
  split; [induction 1 as [|x v u w I H IH]; cbn in *; [easy|]; rewrite app_length; intuition; subst; cbn; lia|].
  revert w. induction u as [|x u IH]; intros [|y w]; cbn; intros [=]; [constructor|].
  apply (parallel_cons _ x [y] u w); [destruct y; cbn; auto|auto].
Qed.
Lemma repeat_length_equal (w : list bool) n : repeat a (length w) = repeat a n <-> length w = n.
Proof. split; [|now intros ->]. intro Q. apply (f_equal (@length bool)) in Q. now rewrite !repeat_length in Q. Qed.
Lemma powers_substituted (s : bool -> language bool) : (forall x v, s x v <-> In v (any_letter x)) -> same (substitution s powers_of_a) power_length.
Proof.
  intros E w. unfold substitution. setoid_rewrite (parallel_equal _ _ _ _ E). setoid_rewrite any_letters. split.
  - intros (u & (n & ->) & Q). exists n. now rewrite <- Q, repeat_length.
  - intros (n & Q). exists (repeat a (2 ^ n)). split; [now exists n|]. now rewrite repeat_length.
Qed.
Theorem edt0l_not_closed_under_finite_substitution : ~ closed FiniteSubstitution EDT0L.
Proof.
  intro C. apply power_length_not_edt0l. apply (is_same _ _ _ (powers_substituted (fun x v => In v (any_letter x)) ltac:(easy))).
  exact (C bool _ bool _ any_letter _ powers_of_a_is).
Qed.
Theorem edt0l_not_closed_under_substitution : ~ closed Substitution EDT0L.
Proof.
  intro C. apply power_length_not_edt0l. set (s := fun _ : bool => union (fun w => exists i, In w (becomes i single_a)) (fun w => exists i, In w (becomes i single_b))).
  apply (is_same EDT0L (substitution s powers_of_a)).
  - apply powers_substituted. intros x v. unfold s, union. cbn. split; [intros [(_ & H)|(_ & H)]; tauto|intros [H|[H|[]]]; [left|right]; exists 0; auto].
  - apply C; try exact _; [apply powers_of_a_is|]. intro x. under (extended_union true true ltac:(easy)); now apply (started true true).
Qed.
Theorem edt0l_not_closed_under_inverse_homomorphism : ~ closed InverseHomomorphism EDT0L.
Proof.
  intro C. apply power_length_not_edt0l. apply (is_same EDT0L (inverse_image (fun _ : bool => [a]) powers_of_a)).
  - intro w. unfold inverse_image, powers_of_a, power_length. replace (flat_map (fun _ => [a]) w) with (repeat a (length w)) by (induction w; cbn; congruence).
    now setoid_rewrite repeat_length_equal.
  - exact (C bool _ bool _ (fun _ => [a]) _ powers_of_a_is).
Qed.
Theorem edt0l_not_closed_under_gsm_mapping : ~ closed GsmMapping EDT0L.
Proof.
  intro C. apply power_length_not_edt0l. set (M := Machine tt (fun _ _ => [([false], tt); ([true], tt)]) (fun _ => true) : machine bool bool unit).
  apply (is_same EDT0L (translation M powers_of_a)); [|exact (C bool _ bool unit _ _ M _ powers_of_a_is)].
  assert (Q : forall q u w, translates M q u w <-> length u = length w).
  { intros [] u w. rewrite <- any_letters. split.
    - induction 1 as [|q x q' v u w I H IH]; constructor; auto. cbn in *. intuition congruence.
    - induction 1 as [|x v u w I H IH]; [now constructor|]. apply (translates_cons M tt x tt); auto. cbn in *. intuition congruence. }
  intro w. unfold translation. setoid_rewrite Q. split.
  - intros (u & (n & ->) & E). exists n. now rewrite <- E, repeat_length.
  - intros (n & E). exists (repeat a (2 ^ n)). split; [now exists n|]. now rewrite repeat_length.
Qed.
