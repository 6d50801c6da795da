(* Lengths in an ET0L language.  If it has a word of length r at least, it has one that is derived by (r + 2)^d tables at
   most, where d depends on the system only: what matters of the tables that are still to come is how long a word, cut at r,
   each letter can become, and tables between two moments at which this is the same can be left out.  So lengths do
   not leave gaps that grow faster than a power of a constant with a polynomial as exponent.  The intersection of two languages that are
   both E0L and EDT0L leaves such gaps. *)
From Algae Require Import Words Runs Substitution AbstractFamily OneTable.

Section Scores.
  Context {A V : Set} {alphabet : Alphabet V}.
  Variables (fin : V -> list (list A)) (r : nat).
  Fixpoint best {X : Type} (f : X -> nat) (l : list X) : nat := match l with [] => 0 | u :: l => max (f u) (best f l) end.
  Lemma best_above {X : Type} (f : X -> nat) l u : In u l -> f u <= best f l.
  Proof. induction l as [|u' l IH]; [easy|]. cbn. intros [->|I]; [lia|]. specialize (IH I). lia. Qed.
  Lemma best_is {X : Type} (f : X -> nat) l m : best f l = S m -> exists u, In u l /\ f u = S m.
  Proof.
    induction l as [|u l IH]; cbn; [easy|]. intro Q. destruct (Nat.max_dec (f u) (best f l)) as [E|E].
    - exists u. split; [now left|lia].
    - destruct IH as (u' & I & E'); [lia|]. exists u'. auto.
  Qed.
  Lemma best_equal {X : Type} (f g : X -> nat) l : (forall u, f u = g u) -> best f l = best g l.
  Proof. intro E. induction l as [|u l IH]; cbn; auto. Qed.
  Lemma best_below {X : Type} (f : X -> nat) l n : (forall u, f u <= n) -> best f l <= n.
  Proof. intro E. induction l as [|u l IH]; cbn; [lia|]. specialize (E u). lia. Qed.

  (* 0: no word at all; S m: the longest word has length m, or r = m at least *)
  Fixpoint total (f : V -> nat) (u : list V) : nat :=
    match u with
    | [] => 1
    | x :: u => match f x, total f u with S m, S k => S (min r (m + k)) | _, _ => 0 end
    end.
  Fixpoint score (ts : list (table V)) (x : V) : nat :=
    match ts with
    | [] => best (fun w => S (min r (length w))) (fin x)
    | t :: ts => best (total (score ts)) (t x)
    end.
  Lemma total_equal f g u : (forall x, f x = g x) -> total f u = total g u.
  Proof. intro E. induction u as [|x u IH]; cbn; auto. now rewrite E, IH. Qed.
  Lemma total_below f u : (forall x, f x <= S r) -> total f u <= S r.
  Proof. intro E. destruct u as [|x u]; cbn; [lia|]. destruct (f x); [lia|]. destruct (total f u); lia. Qed.
  Lemma score_below ts x : score ts x <= S r.
  Proof.
    revert x. induction ts as [|t ts IH]; intro x; cbn; apply best_below; intro u; [lia|]. now apply total_below.
  Qed.
  Lemma total_word (R : V -> list A -> Prop) f u m : (forall x m, f x = S m -> exists w, R x w /\ m <= length w) ->
    total f u = S m -> exists w, parallel R u w /\ m <= length w.
  Proof.
    intro H. revert m. induction u as [|x u IH]; cbn; intros m Q; [exists []; split; [constructor|cbn; lia]|].
    destruct (f x) as [|k] eqn:E; [easy|]. destruct (total f u) as [|k'] eqn:E'; [easy|].
    destruct (H x k E) as (w & P & L), (IH k' eq_refl) as (w' & P' & L'). exists (w ++ w'). split; [now constructor|].
    rewrite app_length. lia.
  Qed.
  Lemma word_total (R : V -> list A -> Prop) f u w : (forall x w, R x w -> S (min r (length w)) <= f x) ->
    parallel R u w -> S (min r (length w)) <= total f u.
  Proof.
    intros H P. induction P as [|x w u w' I P IH]; cbn; [lia|]. specialize (H _ _ I). destruct (f x) as [|m]; [lia|].
    destruct (total f u) as [|k]; [lia|]. rewrite app_length. lia.
  Qed.
  Lemma score_word ts x m : score ts x = S m -> exists w, run fin ts x w /\ m <= length w.
  Proof.
    revert x m. induction ts as [|t ts IH]; cbn; intros x m Q; apply best_is in Q as (u & I & Q).
    - exists u. split; auto. lia.
    - destruct (total_word (run fin ts) _ u m IH Q) as (w & P & L). eauto.
  Qed.
  Lemma word_score ts x w : run fin ts x w -> S (min r (length w)) <= score ts x.
  Proof.
    revert x w. induction ts as [|t ts IH]; cbn; intros x w.
    - apply (best_above (fun w => S (min r (length w)))).
    - intros (u & I & P). apply (word_total _ (score ts)) in P; auto. pose proof (best_above (total (score ts)) (t x) u I). lia.
  Qed.

  Definition state (ts : list (table V)) : list nat := map (score ts) letters.
  Lemma same_scores ts ts' : state ts = state ts' -> forall x, score ts x = score ts' x.
  Proof. intros Q x. apply (ext_in_map Q), all_letters. Qed.
  Lemma same_after t ts ts' : state ts = state ts' -> state (t :: ts) = state (t :: ts').
  Proof. intro Q. apply map_ext. intro x. cbn. apply best_equal. intro u. apply total_equal. now apply same_scores. Qed.
  Fixpoint states (ts : list (table V)) : list (list nat) := state ts :: match ts with [] => [] | _ :: ts => states ts end.
  Lemma suffix s ts : NoDup (states ts) -> In s (states ts) -> exists ts', incl ts' ts /\ state ts' = s /\ NoDup (states ts').
  Proof.
    induction ts as [|t ts IH]; intros N I; destruct I as [<-|I].
    - exists []. auto using incl_refl.
    - destruct I.
    - exists (t :: ts). auto using incl_refl.
    - inversion N; subst. destruct IH as (ts' & J & Q & N'); auto. exists ts'. auto using incl_tl.
  Qed.
  Lemma shorter ts : exists ts', incl ts' ts /\ state ts' = state ts /\ NoDup (states ts').
  Proof.
    induction ts as [|t ts (ts' & I & Q & N)]; [exists []; repeat split; auto using incl_refl; constructor; auto; constructor|].
    destruct (in_dec (list_eq_dec Nat.eq_dec) (state (t :: ts')) (states ts')) as [J|J].
    - destruct (suffix _ _ N J) as (ts2 & I2 & Q2 & N2). exists ts2. split; [intros z Z; right; auto|]. split; auto.
      rewrite Q2. now apply same_after.
    - exists (t :: ts'). split; [intros z [<-|Z]; [now left|right; auto]|]. split; [now apply same_after|]. now constructor.
  Qed.

  Fixpoint vectors (d n : nat) : list (list nat) :=
    match d with 0 => [[]] | S d => flat_map (fun l => map (fun i => i :: l) (seq 0 n)) (vectors d n) end.
  Lemma vectors_number d n : length (vectors d n) = n ^ d.
  Proof.
    induction d as [|d IH]; cbn; auto. rewrite Nat.mul_comm, <- IH. clear IH. induction (vectors d n) as [|l ls IH]; cbn; auto.
    rewrite app_length, map_length, seq_length. now rewrite IH.
  Qed.
  Lemma vectors_have n l : (forall i, In i l -> i < n) -> In l (vectors (length l) n).
  Proof.
    induction l as [|i l IH]; cbn; intro H; auto. apply in_flat_map. exists l. split; [apply IH; auto|].
    apply (in_map (fun i => i :: l)), in_seq. specialize (H i (or_introl eq_refl)). lia.
  Qed.
  Notation d := (length (letters : list V)).
  Lemma few_states ts : NoDup (states ts) -> length ts <= (r + 2) ^ d.
  Proof.
    intro N. rewrite <- vectors_number. enough (L : length (states ts) <= length (vectors d (r + 2))).
    { assert (E : length (states ts) = S (length ts)) by (clear; induction ts; cbn in *; auto). lia. }
    apply (NoDup_incl_length N). clear N. intros s I. assert (Q : exists ts', s = state ts').
    { induction ts as [|t ts IH]; destruct I as [<-|I]; eauto. destruct I. }
    destruct Q as (ts' & ->). unfold state. rewrite <- (map_length (score ts')) at 1. apply vectors_have.
    intros i (x & <- & _)%in_map_iff. pose proof (score_below ts' x). lia.
  Qed.
End Scores.

Lemma longest {X : Type} (l : list (list X)) : exists m, forall u, In u l -> length u <= m.
Proof. exists (best (@length X) l). intro u. apply best_above. Qed.
Theorem gaps {A : Set} many one (X : language A) : runs many one X ->
  exists c d, forall r w, X w -> r <= length w -> exists w', X w' /\ r <= length w' <= c * c ^ ((r + 2) ^ d).
Proof.
  intros (V & v & starts & ts & fin & _ & _ & S0).
  destruct (longest (flat_map fin letters)) as (F & HF), (longest (flat_map (fun t => flat_map t letters) ts)) as (C & HC).
  set (c := S (F + C)). exists c, (length (letters : list V)).
  assert (B : forall ts' x w, incl ts' ts -> run fin ts' x w -> length w <= c * c ^ length ts').
  { induction ts' as [|t ts' IH]; cbn [run length]; intros x w I H.
    - cbn. enough (length w <= F) by lia. apply HF, in_flat_map. exists x. split; [apply all_letters|auto].
    - destruct H as (u & J & P). assert (L : length u <= c).
      { enough (length u <= C) by lia. apply HC, in_flat_map. exists t. split; [apply I; now left|]. apply in_flat_map. exists x. split; [apply all_letters|auto]. }
      assert (Q : length w <= length u * (c * c ^ length ts')).
      { clear J L. induction P as [|x' w' u w'' J P IHP]; [cbn; lia|]. rewrite app_length. cbn [length].
        assert (length w' <= c * c ^ length ts') by (apply (IH x'); auto; intros z Z; apply I; now right). lia. }
      rewrite Nat.pow_succ_r'. apply (Nat.le_trans _ _ _ Q). rewrite (Nat.mul_comm c (c * _)), (Nat.mul_comm (length u)). now apply Nat.mul_le_mono_l. }
  intros r w (x & ts0 & Ix & I0 & H)%S0 L. destruct (shorter fin r ts0) as (ts1 & I1 & Q & N).
  pose proof (word_score fin r ts0 x w H) as K. rewrite <- (same_scores fin r _ _ Q), (Nat.min_l _ _ L) in K.
  pose proof (score_below fin r ts1 x). destruct (score_word fin r ts1 x r) as (w' & H' & L'); [lia|].
  assert (J : incl ts1 ts) by (intros z Z; auto). exists w'. split; [apply S0; eauto|]. split; auto.
  apply (Nat.le_trans _ _ _ (B ts1 x w' J H')), Nat.mul_le_mono_l, Nat.pow_le_mono_r; [easy|]. now apply (few_states fin r).
Qed.
