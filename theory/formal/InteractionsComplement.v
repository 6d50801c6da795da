(* Systems with interactions are not closed under complement.  The lengths that are not 2^n or 2^n + 1 are those of a
   system: a step doubles the length and adds -2, -1, 0 or 1, which the first letter chooses.  The other lengths are in
   no language of the family. *)
From Algae Require Import Words NonClosure Interactions.

Local Notation pair := (near 0 0).
Lemma pair_dec x : {pair x} + {~ pair x}.
Proof.
  destruct (existsb (fun n => (x =? 2 ^ n) || (x =? 2 ^ n + 1)) (seq 0 (S x))) eqn:Q; [left|right].
  - apply existsb_exists in Q as (n & _ & [H%Nat.eqb_eq|H%Nat.eqb_eq]%orb_true_iff); exists n; lia.
  - intros (n & _ & H). enough (K : existsb (fun n => (x =? 2 ^ n) || (x =? 2 ^ n + 1)) (seq 0 (S x)) = true) by congruence.
    apply existsb_exists. exists n. split; [apply in_seq; pose proof (power_larger n); lia|]. apply orb_true_iff.
    destruct H as [H|H]; [left|right]; apply Nat.eqb_eq; lia.
Qed.

(* a word of six letters becomes one of these words; in others each letter doubles but for the first *)
Definition chooser : interactive unit := Interactive (row 6) 6 6 (fun p _ q =>
  if length p + length q =? 5 then match p with [] => map (fun n => row n) [0; 7; 10; 11; 12; 13] | _ => [[]] end
  else match p with [] => map (fun n => row n) [0; 1; 2; 3] | _ => [row 2] end).
Lemma chooser_windows i k : length (firstn 6 (row i)) + length (firstn 6 (row k)) = min 6 i + min 6 k.
Proof. now rewrite !firstn_row, !repeat_length. Qed.
Lemma chooser_tail i k w : 7 <= S i + k -> context_step chooser (row (S i)) (row k) w <-> w = row (2 * k).
Proof.
  revert i w. induction k as [|k IH]; intros i w L.
  - split; [now inversion 1|intros ->; constructor].
  - assert (E : successors chooser (firstn 6 (row (S i))) tt (firstn 6 (row k)) = [row 2]).
    { cbn [successors chooser]. rewrite chooser_windows. destruct (Nat.eqb_spec (min 6 (S i) + min 6 k) 5); [lia|reflexivity]. }
    replace (row (2 * S k)) with (row 2 ++ row (2 * k)) by (rewrite <- repeat_app; f_equal; lia). split.
    + intro H. inversion H as [|p0 x0 v0 u z I J]; subst. change (tt :: row (S i)) with (row (S (S i))) in J. apply IH in J as ->; [|lia].
      change (In u (successors chooser (firstn 6 (row (S i))) tt (firstn 6 (row k)))) in I. rewrite E in I. now destruct I as [<-|[]].
    + intros ->. change (row (S k)) with (tt :: row k). constructor; [change (In (row 2) (successors chooser (firstn 6 (row (S i))) tt (firstn 6 (row k)))); rewrite E; now left|].
      change (tt :: row (S i)) with (row (S (S i))). apply IH; [lia|reflexivity].
Qed.
Lemma chooser_step m w : 7 <= m -> context_step chooser [] (row m) w <-> exists j, j <= 3 /\ w = row (2 * m - 2 + j).
Proof.
  intro L. destruct m as [|m]; [lia|]. assert (E : successors chooser (firstn 6 []) tt (firstn 6 (row m)) = map (fun n => row n) [0; 1; 2; 3]).
  { cbn [successors chooser]. pose proof (chooser_windows 0 m) as Q. cbn [repeat] in Q. rewrite Q. destruct (Nat.eqb_spec (min 6 0 + min 6 m) 5); [lia|reflexivity]. }
  assert (F : forall u, In u (map (fun n => row n) [0; 1; 2; 3]) <-> exists j, j <= 3 /\ u = row j).
  { intro u. rewrite in_map_iff. split.
    - intros (j & <- & I). exists j. split; auto. destruct I as [<-|[<-|[<-|[<-|[]]]]]; lia.
    - intros (j & Lj & ->). exists j. split; auto. destruct j as [|[|[|[|j]]]]; cbn; auto. lia. }
  cbn [repeat]. split.
  - intro H. inversion H as [|p0 x0 v0 u z I J]; subst. apply (chooser_tail 0) in J as ->; [|lia].
    change (In u (successors chooser (firstn 6 []) tt (firstn 6 (row m)))) in I. rewrite E in I. apply F in I as (j & Lj & ->).
    exists j. split; auto. rewrite <- repeat_app. f_equal. lia.
  - intros (j & Lj & ->). replace (row (2 * S m - 2 + j)) with (row j ++ row (2 * m)) by (rewrite <- repeat_app; f_equal; lia).
    constructor; [|now apply (chooser_tail 0)]. change (In (row j) (successors chooser (firstn 6 []) tt (firstn 6 (row m)))). rewrite E. apply F. eauto.
Qed.
Lemma chooser_first w : context_step chooser [] (row 6) w <-> In w (map (fun n => row n) [0; 7; 10; 11; 12; 13]).
Proof.
  assert (R : forall i k w, S i + k = 6 -> context_step chooser (row (S i)) (row k) w <-> w = []).
  { intros i k. revert i. induction k as [|k IH]; intros i z L.
    - split; [now inversion 1|intros ->; constructor].
    - assert (E : successors chooser (firstn 6 (row (S i))) tt (firstn 6 (row k)) = [[]]).
      { cbn [successors chooser]. rewrite chooser_windows. destruct (Nat.eqb_spec (min 6 (S i) + min 6 k) 5); [reflexivity|lia]. }
      split.
      + intro H. inversion H as [|p0 x0 v0 u y I J]; subst. change (tt :: row (S i)) with (row (S (S i))) in J. apply IH in J as ->; [|lia].
        change (In u (successors chooser (firstn 6 (row (S i))) tt (firstn 6 (row k)))) in I. rewrite E in I. now destruct I as [<-|[]].
      + intros ->. change (context_step chooser (row (S i)) (tt :: row k) ([] ++ [])). constructor; [change (In [] (successors chooser (firstn 6 (row (S i))) tt (firstn 6 (row k)))); rewrite E; now left|].
        change (tt :: row (S i)) with (row (S (S i))). apply IH; [lia|reflexivity]. }
  split.
  - intro H. inversion H as [|p0 x0 v0 u z I J]; subst. apply (R 0 5) in J as ->; [|reflexivity]. rewrite app_nil_r. exact I.
  - intro I. rewrite <- (app_nil_r w). change (row 6) with (tt :: row 5). constructor; [exact I|now apply (R 0 5)].
Qed.

(* twice a length less two, plus at most three, is in a pair only if the length is *)
Lemma not_in_pair m j : 7 <= m -> j <= 3 -> ~ pair m -> ~ pair (2 * m - 2 + j).
Proof.
  intros L Lj N ([|n] & _ & H); [cbn in H; lia|]. apply N. exists n. split; [lia|]. cbn [Nat.pow] in H. lia.
Qed.
Lemma half_of_other y : 14 <= y -> ~ pair y -> exists m j, 7 <= m /\ m < y /\ j <= 3 /\ ~ pair m /\ y = 2 * m - 2 + j.
Proof.
  intros L N. destruct (Nat.Even_or_Odd y) as [(z & Q)|(z & Q)].
  - destruct (pair_dec z) as [(n & _ & H)|H]; [|exists z, 2; repeat split; auto; lia].
    assert (Z : z = 2 ^ n + 1).
    { destruct H as [H|H]; [|lia]. destruct N. exists (S n). cbn [Nat.pow]. lia. }
    exists (S z), 0. repeat split; try lia. intros (k & _ & K). destruct (lt_eq_lt_dec n k) as [[C|C]|C]; [pose proof (power_step n k C)|subst|pose proof (power_step k n C)]; lia.
  - destruct (pair_dec z) as [(n & _ & H)|H]; [|exists z, 3; repeat split; auto; lia].
    assert (Z : z = 2 ^ n + 1).
    { destruct H as [H|H]; [|lia]. destruct N. exists (S n). cbn [Nat.pow]. lia. }
    exists (S z), 1. repeat split; try lia. intros (k & _ & K). destruct (lt_eq_lt_dec n k) as [[C|C]|C]; [pose proof (power_step n k C)|subst|pose proof (power_step k n C)]; lia.
Qed.
Ltac in_pair n := exfalso; match goal with H : ~ pair _ |- _ => apply H; exists n; cbn; lia end.
Ltac no_pair := let n := fresh in let H := fresh in intros (n & _ & H); destruct n as [|[|[|[|n]]]]; cbn in H; try lia; pose proof (Nat.pow_nonzero 2 n); lia.
Lemma others_interacting : is IL (fun w : list unit => ~ pair (length w)).
Proof.
  exists chooser. split; [easy|]. split.
  - intros p x q. cbn [successors chooser]. destruct (_ =? _), p; easy.
  - intro w. split.
    + intro N. rewrite (is_row w). revert N. generalize (length w). intro y. induction y as [y IH] using lt_wf_ind. intro N.
      destruct (le_lt_dec 14 y) as [L|L].
      * destruct (half_of_other y L N) as (m & j & L7 & Lt & Lj & M & ->). apply (context_next _ (row m)); [now apply IH|]. apply chooser_step; eauto.
      * assert (C : y = 6 \/ In y [0; 7; 10; 11; 12; 13]).
        { destruct y as [|[|[|[|[|[|[|[|[|[|[|[|[|[|y]]]]]]]]]]]]]]; cbn; try lia; [in_pair 0|in_pair 1|in_pair 1|in_pair 2|in_pair 2|in_pair 3|in_pair 3]. }
        destruct C as [->|C]; [apply (context_axiom chooser)|]. apply (context_next _ (row 6)); [apply (context_axiom chooser)|].
        apply chooser_first. now apply (in_map (fun n => row n)).
    + intro H. assert (F : length w = 6 \/ length w = 0 \/ 7 <= length w /\ ~ pair (length w)).
      { induction H as [|v w H IH St]; [now left|]. rewrite (is_row v) in St. destruct IH as [Q|[Q|(L & N)]].
        - rewrite Q in St. apply chooser_first in St. right. apply in_map_iff in St as (n & <- & I). rewrite repeat_length.
          destruct I as [<-|[<-|[<-|[<-|[<-|[<-|[]]]]]]]; [now left|right..]; (split; [lia|no_pair]).
        - rewrite Q in St. inversion St; subst. auto.
        - apply chooser_step in St as (j & Lj & ->); auto. rewrite repeat_length. right; right. split; [lia|now apply not_in_pair]. }
      destruct F as [->|[->|(_ & N)]]; auto; no_pair.
Qed.
Theorem interacting_not_closed_under_complement : ~ closed Complement IL.
Proof.
  intro C. apply (near_not_interacting 0 0). specialize (C unit _ _ others_interacting). revert C. apply is_same.
  intro w. unfold complement. destruct (pair_dec (length w)); tauto.
Qed.
