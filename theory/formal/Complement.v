(* L-systems without nonterminals are not closed under complement: the words over one letter but for a^4 are in none of
   the families (theory/closure/complement-not-0l.claim). *)
From Algae Require Import Words Obstruction NonClosure.

(* A system has one axiom.  So it does not generate X if two words of X can only be derived from themselves. *)
Lemma two_sources {A : Set} k (X : language A) : pure k ->
  (forall ts : list (table A), (forall t x, In t ts -> t x <> []) -> (forall t w v, In t ts -> X w -> step t w v -> X v) ->
    exists u v, u <> v /\ X u /\ X v /\ forall t w, In t ts -> X w -> (step t w u -> w = u) /\ (step t w v -> w = v)) ->
  ~ is (LSystem k) X.
Proof.
  intros p H. cbn. unfold lsystem. rewrite p. intros (G & (_ & _ & _ & g) & S).
  destruct (H (tables G)) as (u & v & N & Xu & Xv & F).
  - intros t x I. now apply (g t x I).
  - intros t w v I Xw St. apply S. apply S in Xw. exact (derives_step _ _ w v t Xw I St).
  - assert (Q : forall y, X y -> (forall t w, In t (tables G) -> X w -> step t w y -> w = y) -> axiom G = y).
    { intros y Xy Fy. apply S in Xy. unfold generates in Xy. induction Xy as [|w y t Xw IH I St]; auto.
      assert (w = y) as -> by (apply (Fy t w I); [now apply S|exact St]). auto. }
    apply N. rewrite <- (Q u), <- (Q v); auto; intros t w I Xw; now apply (F t w I).
Qed.

Lemma unary_equal (u v : list unit) : length u = length v -> u = v.
Proof. revert v. induction u as [|[] u IH]; intros [|[] v]; cbn; try lia; auto. intro H. f_equal. apply IH. lia. Qed.

Section OneLetter.
  Variable t : table unit.
  Lemma shorter_erases u v : step t u v -> length v < length u -> In [] (t tt).
  Proof.
    induction 1 as [|[] h u v I _ IH]; cbn; [lia|]. rewrite app_length. intro H. destruct h as [|y h]; auto. cbn in H. apply IH. lia.
  Qed.
  Lemma short_result u v : step t u v -> 0 < length v <= 2 -> In [tt] (t tt) \/ In [tt; tt] (t tt).
  Proof.
    induction 1 as [|[] h u v I _ IH]; cbn; [lia|]. rewrite app_length. destruct h as [|[] [|[] [|y h]]]; cbn; auto. lia.
  Qed.
  Hypothesis keeps_out : forall u v : list unit, length u <> 4 -> step t u v -> length v <> 4.
  Lemma not_both : In [] (t tt) -> In [tt] (t tt) -> False.
  Proof.
    intros I0 I1. apply (keeps_out [tt; tt; tt; tt; tt] ([] ++ [tt] ++ [tt] ++ [tt] ++ [tt] ++ [])); [easy| |easy].
    repeat (constructor; auto).
  Qed.
  Lemma not_double : ~ In [tt; tt] (t tt).
  Proof. intro I. apply (keeps_out [tt; tt] ([tt; tt] ++ [tt; tt] ++ [])); [easy| |easy]. repeat (constructor; auto). Qed.
  Lemma from_itself u v : step t u v -> 0 < length v <= 2 -> u = v.
  Proof.
    intros S H. destruct (short_result u v S H) as [I|I]; [|now apply not_double in I]. apply unary_equal.
    destruct (lt_eq_lt_dec (length u) (length v)) as [[Q|Q]|Q]; auto.
    - destruct u as [|[] [|]], v as [|[] [|[] [|]]]; cbn in *; try lia.
      + inversion S.
      + inversion S.
      + apply of_letter in S. now apply not_double in S.
    - now destruct (not_both (shorter_erases u v S Q)).
  Qed.
End OneLetter.

Theorem all_but_one k : pure k -> ~ is (LSystem k) (fun w : list unit => length w <> 4).
Proof.
  intro p. apply two_sources; auto. intros ts _ C. exists [tt], [tt; tt]. split; [easy|]. split; [easy|]. split; [easy|].
  intros t w I Xw. split; intro S; apply (from_itself t (fun u v => C t u v I) _ _ S); cbn; lia.
Qed.

Theorem not_closed_under_complement k : pure k -> ~ closed Complement (LSystem k).
Proof.
  intros p C. apply (all_but_one k p). specialize (C unit _ _ (single_word k [tt; tt; tt; tt] p ltac:(easy))).
  revert C. apply is_same. intro w. unfold complement. split; intros H Q; apply H; [now apply unary_equal|now subst].
Qed.
