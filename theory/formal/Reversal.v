(* L-systems of every kind, and systems with interactions, are closed under reversal: the axiom and all
   successors are reversed, and contexts change sides. *)
From Algae Require Import Words.

Section Systems.
  Context {V : Set}.
  Definition reversed_table (t : table V) : table V := fun x => map (@rev V) (t x).
  Definition reversed (G : system V) : system V := System (rev (axiom G)) (map reversed_table (tables G)).

  Lemma reversed_step t v w : step t v w -> step (reversed_table t) (rev v) (rev w).
  Proof.
    intro H. eapply parallel_weaken; [|exact (parallel_reversed H)]. cbn. intros x u _ I.
    apply in_map_iff. exists (rev u). now rewrite rev_involutive.
  Qed.
  Lemma reversed_step_back t v w : step (reversed_table t) v w -> step t (rev v) (rev w).
  Proof.
    intro H. eapply parallel_weaken; [|exact (parallel_reversed H)]. cbn. intros x u _ I.
    apply in_map_iff in I as (u' & Q & I). apply (f_equal (@rev V)) in Q. rewrite !rev_involutive in Q. now subst.
  Qed.
  Lemma reversed_generates G w : generates (reversed G) w <-> generates G (rev w).
  Proof.
    unfold generates. cbn. split; intro H.
    - induction H as [|v w t' H IH (t & <- & I)%in_map_iff S]; [rewrite rev_involutive; auto|].
      apply (derives_step _ _ (rev v) (rev w) t); auto. now apply reversed_step_back.
    - rewrite <- (rev_involutive w). induction H as [|v v' t H IH I S]; auto.
      apply (derives_step _ _ (rev v) (rev v') (reversed_table t)); auto using in_map, reversed_step.
  Qed.
  Lemma reversed_kind k G : of_kind k G -> of_kind k (reversed G).
  Proof.
    intros (a & n & one & g). split; [|split; [|split]].
    - cbn. intro Q. apply a. now rewrite <- (rev_involutive (axiom G)), Q.
    - cbn. now destruct (tables G).
    - cbn. now rewrite map_length.
    - cbn. intros t' x (t & <- & I)%in_map_iff. unfold reversed_table. destruct (g t x I) as (s & d & p). split; [|split].
      + now destruct (t x).
      + intros Dk u v (u' & <- & Iu)%in_map_iff (v' & <- & Iv)%in_map_iff. f_equal. auto.
      + intros Pk (u & Q & Iu)%in_map_iff. apply p; auto. now rewrite <- (rev_involutive u), Q in Iu.
  Qed.
End Systems.

Theorem lsystem_reversal k : closed Reversal (LSystem k).
Proof.
  intros A a. cbn. intros X H. unfold lsystem in *. destruct (extended k).
  - destruct H as (N & n & G & g & S). exists N, n, (reversed G). split; [now apply reversed_kind|].
    intro w. unfold reversal. now rewrite (S (rev w)), reversed_generates, map_rev.
  - destruct H as (G & g & S). exists (reversed G). split; [now apply reversed_kind|].
    intro w. unfold reversal. now rewrite (S (rev w)), reversed_generates.
Qed.

Section Interactions.
  Context {A : Set}.
  Definition reversed_contexts (G : interactive A) : interactive A :=
    Interactive (rev (first_word G)) (right_width G) (left_width G) (fun p x q => map (@rev A) (successors G q x p)).

  (* a step in the part v of a word, with p before it, reversed, and q behind it *)
  Inductive inner_step (G : interactive A) : list A -> list A -> list A -> list A -> Prop :=
  | inner_nil p q : inner_step G p [] q []
  | inner_cons p x v q u w : In u (successors G (firstn (left_width G) p) x (firstn (right_width G) (v ++ q))) ->
      inner_step G (x :: p) v q w -> inner_step G p (x :: v) q (u ++ w).
  Lemma inner_step_whole G p v w : inner_step G p v [] w <-> context_step G p v w.
  Proof.
    split.
    - revert p w. induction v as [|x v IH]; intros p w H; inversion H; subst; [constructor|].
      rewrite app_nil_r in *. constructor; auto.
    - induction 1; constructor; auto. now rewrite app_nil_r.
  Qed.
  Lemma inner_step_append G p v v' q w w' : inner_step G p v (v' ++ q) w -> inner_step G (rev v ++ p) v' q w' ->
    inner_step G p (v ++ v') q (w ++ w').
  Proof.
    revert p w. induction v as [|x v IH]; intros p w H K; inversion H; subst; auto.
    cbn. rewrite <- app_assoc. constructor; [now rewrite <- app_assoc|]. apply IH; auto. cbn in K. now rewrite <- app_assoc in K.
  Qed.
  Lemma inner_step_reversed G p v q w : inner_step G p v q w -> inner_step (reversed_contexts G) q (rev v) p (rev w).
  Proof.
    induction 1 as [|p x v q u w I H IH]; cbn; [constructor|]. rewrite rev_app_distr. apply inner_step_append; [exact IH|].
    rewrite rev_involutive, <- (app_nil_r (rev u)). constructor; [|constructor]. cbn. now apply in_map.
  Qed.
  Lemma inner_step_reversed_back G p v q w : inner_step (reversed_contexts G) p v q w -> inner_step G q (rev v) p (rev w).
  Proof.
    induction 1 as [|p x v q u w I H IH]; cbn; [constructor|]. rewrite rev_app_distr. apply inner_step_append; [exact IH|].
    rewrite rev_involutive, <- (app_nil_r (rev u)). constructor; [|constructor]. cbn in *.
    apply in_map_iff in I as (u' & <- & I). now rewrite rev_involutive.
  Qed.
  Lemma reversed_contexts_generate G w : context_generates (reversed_contexts G) w <-> context_generates G (rev w).
  Proof.
    split; intro H.
    - induction H as [|v w H IH S%inner_step_whole%inner_step_reversed_back]; cbn; [rewrite rev_involutive; constructor|].
      apply (context_next _ _ _ IH). now apply inner_step_whole.
    - rewrite <- (rev_involutive w). induction H as [|v v' H IH S%inner_step_whole%inner_step_reversed]; [apply (context_axiom (reversed_contexts G))|].
      apply (context_next _ _ _ IH). now apply inner_step_whole.
  Qed.
End Interactions.

Theorem interacting_reversal : closed Reversal IL.
Proof.
  intros A a. cbn. intros X (G & f & t & S). exists (reversed_contexts G). split; [|split].
  - cbn. intro Q. apply f. now rewrite <- (rev_involutive (first_word G)), Q.
  - cbn. intros p x q Q. apply (t q x p). now destruct (successors G q x p).
  - intro w. unfold reversal. now rewrite (S (rev w)), reversed_contexts_generate.
Qed.
