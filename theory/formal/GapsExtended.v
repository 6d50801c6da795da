(* E0L, ET0L and EDT0L are not closed under intersection and complement.  A word over a and b stands for the numbers of
   letters a before each b.  In one language there are the pairs n, 2^n, one after the other; in the other one 1 stands first,
   then come such pairs, then any number.  The words in both have 1, 2, 4, 16, 65536 ..., each number 2 to the power of
   the one before.  By Gaps.v these lengths lie too far apart. *)
From Algae Require Import Words Runs Extended Substitution AbstractFamily OneTable Gaps.

Local Notation a := false.
Local Notation b := true.
Definition blocks (ns : list nat) : list bool := flat_map (fun n => repeat a n ++ [b]) ns.
Definition pairs (ns : list nat) : list nat := flat_map (fun n => [n; 2 ^ n]) ns.
Lemma blocks_append ns ms : blocks (ns ++ ms) = blocks ns ++ blocks ms.
Proof. apply flat_map_app. Qed.
Lemma blocks_equal ns ms : blocks ns = blocks ms -> ns = ms.
Proof.
  assert (Q : forall n m u v, (repeat a n ++ [b]) ++ u = (repeat a m ++ [b]) ++ v -> n = m /\ u = v).
  { induction n as [|n IH]; intros [|m] u v; cbn; intros [=]; auto. destruct (IH m u v H0); auto. }
  revert ms. induction ns as [|n ns IH]; intros [|m ms]; auto.
  - cbn. destruct m; discriminate.
  - cbn. destruct n; discriminate.
  - intros (-> & H)%Q. f_equal. auto.
Qed.

(* ---- the operands ---- *)
Definition opened : language bool := eq (blocks [1]).
Definition any : language bool := fun w => exists n, w = blocks [n].
Definition power : language bool := fun w => exists n, w = blocks [n; 2 ^ n].
Definition left_operand : language bool := concatenation opened (concatenation (star power) any).
Definition right_operand : language bool := star power.
Lemma star_power w : star power w <-> exists ns, w = blocks (pairs ns).
Proof.
  split.
  - intros (us & -> & H). induction us as [|u us IH]; [now exists []|]. destruct IH as (ns & Q); [intros; apply H; now right|].
    destruct (H u) as (n & ->); [now left|]. exists (n :: ns). change (pairs (n :: ns)) with ([n; 2 ^ n] ++ pairs ns).
    rewrite blocks_append, <- Q. reflexivity.
  - intros (ns & ->). exists (map (fun n => blocks [n; 2 ^ n]) ns). split.
    + induction ns as [|n ns IH]; auto. change (pairs (n :: ns)) with ([n; 2 ^ n] ++ pairs ns). rewrite blocks_append, IH. reflexivity.
    + intros u (n & <- & _)%in_map_iff. now exists n.
Qed.
Lemma left_words w : left_operand w <-> exists ns n, w = blocks (1 :: pairs ns ++ [n]).
Proof.
  assert (Q : forall ns n, blocks (1 :: pairs ns ++ [n]) = blocks [1] ++ blocks (pairs ns) ++ blocks [n]) by (intros; now rewrite <- !blocks_append).
  split.
  - intros (u & z & -> & <- & u' & z' & -> & (ns & ->)%star_power & n & ->). exists ns, n. now rewrite Q.
  - intros (ns & n & ->). rewrite Q. exists (blocks [1]), (blocks (pairs ns) ++ blocks [n]). split; auto. split; [reflexivity|].
    exists (blocks (pairs ns)), (blocks [n]). split; auto. split; [apply star_power; eauto|now exists n].
Qed.

Inductive piece := starting | growing | doubling | single_a | single_b | opening.
#[export] Instance piece_alphabet : Alphabet piece.
Proof. refine {| letters := [starting; growing; doubling; single_a; single_b; opening] |}; [decide equality|intros []; cbn; tauto]. Defined.
Definition grow : table piece := fun x =>
  match x with
  | starting => [[growing; doubling; single_b]] | growing => [[single_a; growing]] | doubling => [[doubling; doubling]] | _ => [[x]]
  end.
Definition written (x : piece) : list (list bool) :=
  match x with starting => [] | growing | single_b => [[b]] | doubling | single_a => [[a]] | opening => [blocks [1]] end.
Definition becomes (i : nat) (x : piece) : list (list bool) :=
  match x with
  | starting => match i with 0 => [] | S i => [blocks [i; 2 ^ i]] end
  | growing => [blocks [i]] | doubling => [repeat a (2 ^ i)] | single_a => [[a]] | single_b => [[b]] | opening => [blocks [1]]
  end.
Lemma pieces_become i x w : run written (repeat grow i) x w <-> In w (becomes i x).
Proof.
  revert x w. induction i as [|i IH]; intros x w; [destruct x; reflexivity|]. cbn [repeat run].
  assert (E : (exists u, In u (grow x) /\ parallel (run written (repeat grow i)) u w) <-> In w (flat_map (results (becomes i)) (grow x))).
  { rewrite in_flat_map. split; intros (u & I & P); exists u; split; auto.
    - apply (results_in (becomes i)). revert P. apply parallel_weaken. intros y v _ H. now apply IH.
    - apply results_in in P. revert P. apply parallel_weaken. intros y v _ H. now apply IH. }
  rewrite E. clear. unfold results. destruct x; cbn -[Nat.pow]; rewrite ?app_nil_r; try reflexivity.
  now replace (2 ^ S i) with (2 ^ i + 2 ^ i) by (cbn; lia); rewrite repeat_app.
Qed.
Section Operands.
  Variables many one : bool.
  Hypothesis sorts : one = true -> many = true.
  Notation f := (LSystem (E_kind many one)).
  Lemma started x : is f (fun w => exists i, In w (becomes i x)).
  Proof.
    under runs_are; [exact sorts|]. exists piece, _, [x], [grow], written. split; [now exists grow|]. split.
    - intros _ y. split; [destruct y; try apply at_most_single; easy|]. intros t [<-|[]]. destruct y; apply at_most_single.
    - intro w. rewrite one_table_runs. split.
      + intros (i & I). exists x, i. split; [now left|]. now apply pieces_become.
      + intros (y & i & [<-|[]] & H). exists i. now apply pieces_become.
  Qed.
  Lemma power_is : is f power.
  Proof.
    apply (is_same f (fun w => exists i, In w (becomes i starting))); [|apply started]. intro w. split.
    - intros ([|i] & I); [easy|]. destruct I as [<-|[]]. now exists i.
    - intros (n & ->). exists (S n). now left.
  Qed.
  Lemma any_is : is f any.
  Proof.
    apply (is_same f (fun w => exists i, In w (becomes i growing))); [|apply started]. intro w. split.
    - intros (i & [<-|[]]). now exists i.
    - intros (n & ->). exists n. now left.
  Qed.
  Lemma opened_is : is f opened.
  Proof.
    apply (is_same f (fun w => exists i, In w (becomes i opening))); [|apply started]. intro w. split.
    - intros (i & [<-|[]]). reflexivity.
    - intros <-. exists 0. now left.
  Qed.
  Lemma right_is : is f right_operand.
  Proof. under (extended_star many one sorts). apply power_is. Qed.
  Lemma left_is : is f left_operand.
  Proof.
    under (extended_concatenation many one sorts); [apply opened_is|]. under (extended_concatenation many one sorts); [apply right_is|apply any_is].
  Qed.
End Operands.

(* ---- what is in both ---- *)
Fixpoint deep (i : nat) : nat := match i with 0 => 1 | S i => 2 ^ 2 ^ deep i end.
Fixpoint chain (i k : nat) : list nat := match k with 0 => [] | S k => deep i :: 2 ^ deep i :: chain (S i) k end.
Lemma chain_decoded ps n i qs : deep i :: pairs ps ++ [n] = pairs qs -> pairs qs = chain i (S (length ps)).
Proof.
  revert i qs. induction ps as [|p ps IH]; intros i [|q qs] Q; try discriminate; change (pairs (q :: qs)) with (q :: 2 ^ q :: pairs qs) in *.
  - injection Q as <- _ E. destruct (pairs qs); [reflexivity|discriminate].
  - change (pairs (p :: ps)) with (p :: 2 ^ p :: pairs ps) in Q. injection Q as <- -> E.
    change (2 ^ 2 ^ deep i) with (deep (S i)) in E. rewrite (IH (S i) qs E). reflexivity.
Qed.
Lemma chain_pairs i k : exists qs, chain i k = pairs qs.
Proof. revert i. induction k as [|k IH]; intro i; [now exists []|]. destruct (IH (S i)) as (qs & Q). exists (deep i :: qs). cbn [chain]. now rewrite Q. Qed.
Lemma chain_shifted i k : exists ps n, chain i (S k) = deep i :: pairs ps ++ [n].
Proof.
  revert i. induction k as [|k IH]; intro i; [now exists [], (2 ^ deep i)|]. destruct (IH (S i)) as (ps & n & Q).
  exists (2 ^ deep i :: ps), n. change (chain i (S (S k))) with (deep i :: 2 ^ deep i :: chain (S i) (S k)). rewrite Q. reflexivity.
Qed.
Definition both (w : list bool) : Prop := exists k, w = blocks (chain 0 (S k)).
Lemma both_right : same (intersection left_operand right_operand) both.
Proof.
  intro w. unfold intersection, right_operand. rewrite left_words, star_power. split.
  - intros ((ps & n & ->) & qs & Q). apply blocks_equal in Q. exists (length ps). rewrite Q. f_equal. apply (chain_decoded ps n). now rewrite <- Q.
  - intros (k & ->). split.
    + destruct (chain_shifted 0 k) as (ps & n & ->). now exists ps, n.
    + destruct (chain_pairs 0 (S k)) as (qs & ->). now exists qs.
Qed.

(* ---- the lengths ---- *)
Fixpoint size (k : nat) : nat := match k with 0 => 0 | S k => size k + (deep k + 1) + (2 ^ deep k + 1) end.
Lemma chain_end i k : chain i (S k) = chain i k ++ [deep (i + k); 2 ^ deep (i + k)].
Proof.
  revert i. induction k as [|k IH]; intro i; [now rewrite Nat.add_0_r|].
  change (chain i (S (S k))) with (deep i :: 2 ^ deep i :: chain (S i) (S k)). rewrite IH. cbn [chain app].
  now replace (S i + k) with (i + S k) by lia.
Qed.
Lemma chain_size k : length (blocks (chain 0 k)) = size k.
Proof.
  induction k as [|k IH]; auto. rewrite chain_end, blocks_append, app_length, IH. cbn [size blocks flat_map]. rewrite !app_length, !repeat_length.
  rewrite Nat.add_0_l. cbn [length]. lia.
Qed.
Lemma power_above n : n < 2 ^ n.
Proof. apply Nat.pow_gt_lin_r. lia. Qed.
Lemma deep_above k : k < deep k.
Proof. induction k as [|k IH]; [cbn; lia|]. cbn [deep]. pose proof (power_above (deep k)). pose proof (power_above (2 ^ deep k)). lia. Qed.
Lemma size_below k : size (S k) <= 4 * 2 ^ deep k.
Proof.
  induction k as [|k IH]; [cbn; lia|]. change (size (S (S k))) with (size (S k) + (deep (S k) + 1) + (2 ^ deep (S k) + 1)).
  change (deep (S k)) with (2 ^ 2 ^ deep k). set (n := 2 ^ deep k) in *.
  pose proof (power_above n) as P. set (p := 2 ^ n) in *. destruct p as [|p']; [lia|]. rewrite Nat.pow_succ_r'.
  pose proof (power_above p'). lia.
Qed.
Lemma size_grows j k : j <= k -> size j <= size k.
Proof. induction 1; auto. cbn [size]. lia. Qed.
Lemma far_apart c d : exists k, c * c ^ ((4 * 2 ^ deep k + 3) ^ d) < 2 ^ deep (S k).
Proof.
  set (j := c + 4 * d + 1). exists (S j). pose proof (deep_above j) as D. change (deep (S (S j))) with (2 ^ 2 ^ deep (S j)).
  change (deep (S j)) with (2 ^ 2 ^ deep j). set (p := 2 ^ deep j). assert (Lp : j < p) by (pose proof (power_above (deep j)); lia).
  set (q := 2 ^ p). assert (Lq : p < q) by apply power_above.
  assert (W : q * q <= 2 ^ q).
  { unfold q at 1 2. rewrite <- Nat.pow_add_r. apply Nat.pow_le_mono_r; [easy|]. unfold q. destruct p as [|p']; [lia|].
    rewrite Nat.pow_succ_r'. pose proof (power_above p'). lia. }
  assert (E1 : 4 * 2 ^ q + 3 <= 2 ^ (q + 3)) by (rewrite Nat.pow_add_r; pose proof (power_above q); cbn [Nat.pow]; lia).
  assert (E2 : (4 * 2 ^ q + 3) ^ d <= 2 ^ ((q + 3) * d)) by (rewrite Nat.pow_mul_r; now apply Nat.pow_le_mono_l).
  set (e := (4 * 2 ^ q + 3) ^ d) in *. change (c * c ^ e) with (c ^ S e).
  apply (Nat.le_lt_trans _ ((2 ^ c) ^ S e)); [apply Nat.pow_le_mono_l; pose proof (power_above c); lia|]. rewrite <- Nat.pow_mul_r.
  apply Nat.pow_lt_mono_r; [lia|].
  apply (Nat.lt_le_trans _ (2 ^ (c + (q + 3) * d + 1))).
  - rewrite !Nat.pow_add_r. pose proof (power_above c). assert (2 ^ ((q + 3) * d) <> 0) by now apply Nat.pow_nonzero. cbn [Nat.pow]. nia.
  - apply Nat.pow_le_mono_r; [easy|]. apply (Nat.le_trans _ (q * q)); [|exact W]. unfold j in *. nia.
Qed.
(* double negations: complements say no more *)
Lemma both_not_et0l many one (X : language bool) : (forall w, both w -> X w) -> (forall w, X w -> ~ ~ both w) -> ~ runs many one X.
Proof.
  intros F T H. apply gaps in H as (c & d & H). destruct (far_apart c d) as (k & L). pose proof (size_below k) as U.
  destruct (H (S (size (S k))) (blocks (chain 0 (S (S k))))) as (w & Xw & L1 & L2).
  - apply F. now exists (S k).
  - rewrite chain_size. cbn [size]. lia.
  - apply (T w Xw). intros (j & ->). rewrite chain_size in *. assert (J : S (S k) <= S j).
    { destruct (Nat.le_gt_cases (S j) (S k)) as [J|J]; [|lia]. apply size_grows in J. lia. }
    apply size_grows in J. assert (M : 2 ^ deep (S k) <= size (S (S k))) by (cbn [size]; lia).
    assert (P : c * c ^ ((S (size (S k)) + 2) ^ d) <= c * c ^ ((4 * 2 ^ deep k + 3) ^ d)).
    { apply Nat.mul_le_mono_l. destruct c as [|c]; [|apply Nat.pow_le_mono_r; [easy|apply Nat.pow_le_mono_l; lia]].
      cbn [Nat.mul] in L2. lia. }
    lia.
Qed.

Section Closure.
  Variables many one : bool.
  Hypothesis sorts : one = true -> many = true.
  Notation f := (LSystem (E_kind many one)).
  Theorem extended_not_closed_under_intersection : ~ closed Intersection f.
  Proof.
    intro C. apply (both_not_et0l many one (intersection left_operand right_operand)); [intros w; apply both_right|intros w H N; now apply N, both_right|].
    under runs_are; [exact sorts|]. under C; [now apply left_is|now apply right_is].
  Qed.
  Theorem extended_not_closed_under_complement : ~ closed Complement f.
  Proof.
    intro C. apply (both_not_et0l many one (complement (union (complement left_operand) (complement right_operand)))).
    - intros w (L & R)%both_right [N|N]; auto.
    - intros w H N. apply H. left. intro L. apply H. right. intro R. apply N, both_right. now split.
    - under runs_are; [exact sorts|]. under C. under (extended_union many one sorts); under C; [now apply left_is|now apply right_is].
  Qed.
End Closure.
