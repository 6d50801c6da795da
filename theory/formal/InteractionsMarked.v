(* Systems with interactions: gsm mappings, inverse homomorphisms and intersections.  A letter in front of a word tells
   the system whether the word will still be used.  So the words without such a letter are a^(2^n) and a^(2^n + 1), which
   are in no language of the family by themselves. *)
From Algae Require Import Words Regular AbstractFamily NonClosure Interactions.

Theorem interacting_not_closed_under_gsm_mapping : ~ closed GsmMapping IL.
Proof. intro C. now apply interacting_not_closed_under_homomorphism, homomorphism_by_gsm. Qed.

Local Notation letter := (option bool).
Local Notation a := (@None bool).
Local Notation c := (Some false).
Local Notation d := (Some true).
(* c stays, or ends: then nothing or an a stands for it.  A word that begins with a gets a d, which stays. *)
Definition marks : interactive letter := Interactive [c; a] 1 0 (fun p x _ =>
  match x with None => match p with [] => [[d; a; a]] | _ => [[a; a]] end | Some false => [[c]; []; [a]] | Some true => [[d]] end).
Definition marked_words : language letter := context_generates marks.
Lemma marked_words_interacting : is IL marked_words.
Proof. exists marks. split; [easy|]. split; [now intros [|] [[]|]|easy]. Qed.

Lemma row_doubles y p n w : context_step marks (y :: p) (repeat a n) w <-> w = repeat a (n + n).
Proof.
  revert y p w. induction n as [|n IH]; intros y p w; cbn [repeat]; split.
  - now inversion 1.
  - intros ->. constructor.
  - intro H. inversion H as [|p0 x0 v0 u z I J]; subst. apply IH in J as ->. destruct I as [<-|[]]. cbn. now rewrite Nat.add_succ_r.
  - intros ->. replace (repeat a (S n + S n)) with ([a; a] ++ repeat a (n + n)) by (cbn; now rewrite Nat.add_succ_r).
    constructor; [now left|now apply IH].
Qed.
Lemma marked_step n w : context_step marks [] (c :: repeat a (2 ^ n)) w <->
  exists u, In u [[c]; []; [a]] /\ w = u ++ repeat a (2 ^ S n).
Proof.
  replace (2 ^ S n) with (2 ^ n + 2 ^ n) by (cbn; lia). split.
  - intro H. inversion H as [|p0 x0 v0 u z I J]; subst. apply row_doubles in J as ->. exists u. auto.
  - intros (u & I & ->). constructor; [exact I|now apply row_doubles].
Qed.
Lemma marked_form w : marked_words w -> (exists n, w = c :: repeat a (2 ^ n)) \/ (exists m, w = repeat a m /\ near 0 1 m) \/ exists w', w = d :: w'.
Proof.
  induction 1 as [|v w H IH S]; [left; now exists 0|]. destruct IH as [(n & ->)|[(m & -> & N)|(w' & ->)]].
  - apply marked_step in S as (u & [<-|[<-|[<-|[]]]] & ->).
    + left. now exists (Datatypes.S n).
    + right; left. exists (2 ^ Datatypes.S n). split; auto. exists (Datatypes.S n). lia.
    + right; left. exists (Datatypes.S (2 ^ Datatypes.S n)). split; auto. exists (Datatypes.S n). lia.
  - right; right. destruct N as (k & _ & N). pose proof (power_larger k). destruct m as [|m]; [lia|]. inversion S as [|p0 x0 v0 u z I J]; subst.
    destruct I as [<-|[]]. now exists (a :: a :: z).
  - right; right. inversion S as [|p0 x0 v0 u z I J]; subst. destruct I as [<-|[]]. now exists z.
Qed.
Lemma marked_rows m : marked_words (repeat a m) <-> near 0 1 m.
Proof.
  split.
  - intros [(n & Q)|[(m' & Q & N)|(w' & Q)]]%marked_form; [now destruct m| |now destruct m].
    apply (f_equal (@length letter)) in Q. rewrite !repeat_length in Q. now subst.
  - assert (M : forall n, marked_words (c :: repeat a (2 ^ n))).
    { induction n as [|n IH]; [constructor|]. apply (context_next _ _ _ IH), marked_step. exists [c]. split; [now left|reflexivity]. }
    intros ([|n] & L & Q); [lia|]. apply (context_next _ _ _ (M n)), marked_step.
    destruct Q as [-> | ->]; [exists []|exists [a]]; (split; [cbn; auto|]); [now rewrite Nat.add_0_r|].
    rewrite Nat.add_0_r, Nat.add_1_r. reflexivity.
Qed.

Theorem interacting_not_closed_under_inverse_homomorphism : ~ closed InverseHomomorphism IL.
Proof.
  intro C. apply (near_not_interacting 0 1). specialize (C unit _ letter _ (fun _ => [a]) _ marked_words_interacting). revert C. apply is_same.
  intro w. unfold inverse_image. rewrite <- marked_rows. replace (flat_map (fun _ : unit => [a]) w) with (repeat a (length w)); [easy|].
  induction w; cbn; congruence.
Qed.

(* ---- a language whose words have one letter only is one over that letter ---- *)
Section OneLetterOfMany.
  Variable G : interactive letter.
  Hypothesis total : forall p x q, successors G p x q <> [].
  Definition up (w : list unit) : list letter := repeat a (length w).
  Definition only_a (w : list letter) : bool := forallb (fun x => match x with None => true | _ => false end) w.
  Definition fewer : interactive unit := Interactive (repeat tt (length (first_word G))) (left_width G) (right_width G) (fun p _ q =>
    match filter only_a (successors G (up p) a (up q)) with [] => [[]] | us => map (fun u => repeat tt (length u)) us end).
  Lemma up_repeat n : up (repeat tt n) = repeat a n.
  Proof. unfold up. now rewrite repeat_length. Qed.
  Lemma up_append u v : up (u ++ v) = up u ++ up v.
  Proof. unfold up. now rewrite app_length, repeat_app. Qed.
  Lemma up_firstn i w : up (firstn i w) = firstn i (up w).
  Proof.
    rewrite (is_row w), firstn_row, !up_repeat. generalize (length w). intro n. revert i. induction n as [|n IH]; intros [|i]; cbn; auto. now rewrite IH.
  Qed.
  Lemma only_a_row w : only_a w = true -> w = up (repeat tt (length w)).
  Proof. rewrite up_repeat. induction w as [|[x|] w IH]; cbn; intro H; [easy|easy|]. now rewrite <- IH. Qed.
  Lemma only_a_append u v : only_a (u ++ v) = true <-> only_a u = true /\ only_a v = true.
  Proof. unfold only_a. rewrite forallb_app. apply andb_true_iff. Qed.

  Lemma some_big_step p v : exists w, context_step G p v w.
  Proof.
    revert p. induction v as [|x v IH]; intro p; [eexists; constructor|]. destruct (IH (x :: p)) as (w & H).
    destruct (successors G (firstn (left_width G) p) x (firstn (right_width G) v)) as [|u us] eqn:Q; [now apply total in Q|].
    exists (u ++ w). constructor; auto. rewrite Q. now left.
  Qed.
  Lemma down_step p v w : context_step G (up p) (up v) (up w) -> context_step fewer p v w.
  Proof.
    revert p w. induction v as [|[] v IH]; intros p w H.
    - inversion H as [Hp Hv Hw|]. destruct w; [constructor|discriminate].
    - change (up (tt :: v)) with (a :: up v) in H. inversion H as [|p0 x0 v0 u z I J Ep Ev Ew]; subst.
      assert (O : only_a (u ++ z) = true) by (rewrite Ew; unfold up; clear; induction (length w); auto).
      apply only_a_append in O as (Ou & Oz). rewrite (only_a_row u Ou), (only_a_row z Oz), <- up_append in Ew.
      assert (w = repeat tt (length u) ++ repeat tt (length z)) as ->.
      { unfold up in Ew. apply (f_equal (@length letter)) in Ew. rewrite !repeat_length in Ew. rewrite (is_row w), <- Ew, <- is_row. reflexivity. }
      constructor.
      + cbn [successors fewer left_width right_width]. rewrite !up_firstn. destruct (filter only_a _) as [|u1 us] eqn:Q.
        * assert (K : In u (filter only_a (successors G (firstn (left_width G) (up p)) a (firstn (right_width G) (up v))))) by (apply filter_In; auto).
          rewrite Q in K. destruct K.
        * rewrite <- Q. apply (in_map (fun u => repeat tt (length u))), filter_In. auto.
      + apply IH. rewrite <- (only_a_row z Oz). exact J.
  Qed.
  Lemma up_step p v w : (forall z, context_step G (up p) (up v) z -> only_a z = true) -> context_step fewer p v w -> context_step G (up p) (up v) (up w).
  Proof.
    intros O H. induction H as [p|p [] v u w I H IH]; [constructor|]. change (up (tt :: v)) with (a :: up v) in *. rewrite up_append.
    assert (Ou : forall u, In u (successors G (firstn (left_width G) (up p)) a (firstn (right_width G) (up v))) -> only_a u = true).
    { intros u1 I1. destruct (some_big_step (a :: up p) (up v)) as (z & Z). specialize (O (u1 ++ z) (context_cons _ _ _ _ _ _ I1 Z)).
      now apply only_a_append in O. }
    destruct (successors G (firstn (left_width G) (up p)) a (firstn (right_width G) (up v))) as [|u0 us] eqn:Q; [now apply total in Q|].
    constructor.
    - cbn [successors fewer left_width right_width] in I. rewrite !up_firstn, Q in I. destruct (filter only_a (u0 :: us)) as [|u1 us1] eqn:F.
      + assert (K : In u0 (filter only_a (u0 :: us))) by (apply filter_In; split; [now left|apply Ou; now left]). rewrite F in K. destruct K.
      + rewrite <- F in I. apply in_map_iff in I as (u2 & <- & K). apply filter_In in K as (K & L). rewrite <- (only_a_row u2 L), Q. exact K.
    - apply IH. intros z Z. assert (K : only_a (u0 ++ z) = true) by (apply O; constructor; [rewrite Q; now left|exact Z]). now apply only_a_append in K.
  Qed.
End OneLetterOfMany.
Lemma one_letter_of_many (K : nat -> Prop) : is IL (fun w : list letter => exists m, w = repeat a m /\ K m) -> is IL (fun w : list unit => K (length w)).
Proof.
  intros (G & ax & total & S).
  assert (R : forall w, context_generates G w -> exists m, w = repeat a m /\ K m) by (intro w; apply S).
  assert (O : forall n, only_a (repeat a n) = true) by (induction n; auto).
  exists (fewer G). split; [|split].
  - cbn. now destruct (first_word G).
  - intros p x q. cbn. destruct (filter only_a _) as [|u us]; easy.
  - assert (E : forall w, context_generates (fewer G) w <-> context_generates G (up w)).
    { intro w. split.
      - induction 1 as [|v w H IH St].
        + destruct (R _ (context_axiom G)) as (m & Q & _). change (context_generates G (up (repeat tt (length (first_word G))))).
          assert (E0 : up (repeat tt (length (first_word G))) = first_word G) by now rewrite up_repeat, Q, repeat_length. rewrite E0. constructor.
        + apply (context_next _ _ _ IH). apply (up_step G total []); auto. intros z Z. destruct (R z) as (m & -> & _); auto. now apply (context_next _ (up v)).
      - intro H. enough (Q : forall z, context_generates G z -> context_generates (fewer G) (repeat tt (length z))).
        { apply Q in H. unfold up in H. rewrite repeat_length, <- is_row in H. exact H. }
        clear w H. induction 1 as [|v w H IH St]; [constructor|]. apply (context_next _ _ _ IH). apply (down_step G []).
        destruct (R v H) as (m & -> & _). destruct (R w) as (m' & -> & _); [now apply (context_next _ (repeat a m))|].
        rewrite (only_a_row (repeat a m) (O m)), (only_a_row (repeat a m') (O m')) in St. exact St. }
    intro w. rewrite E, <- (S (up w)). split.
    + intro Kw. exists (length w). split; auto.
    + intros (m & Q & Km). apply (f_equal (@length letter)) in Q. unfold up in Q. rewrite !repeat_length in Q. now subst.
Qed.

Lemma rows_regular : regular (fun w : list letter => only_a w = true).
Proof. apply regular_words_of. Qed.
Lemma rows_of_marked : same (fun w => exists m, w = repeat a m /\ near 0 1 m) (intersection marked_words (fun w => only_a w = true)).
Proof.
  intro w. unfold intersection. split.
  - intros (m & -> & N). split; [now apply marked_rows|]. clear N. induction m; auto.
  - intros (M & O). apply only_a_row in O. rewrite up_repeat in O. exists (length w). split; auto. apply marked_rows. now rewrite <- O.
Qed.
Theorem interacting_not_closed_under_intersection_with_regular : ~ closed IntersectionWithRegular IL.
Proof.
  intro C. apply (near_not_interacting 0 1), one_letter_of_many. apply (is_same IL (intersection marked_words (fun w => only_a w = true))).
  - intro w. symmetry. apply rows_of_marked.
  - under C; [apply marked_words_interacting|apply rows_regular].
Qed.
Lemma rows_interacting : is IL (fun w : list letter => only_a w = true /\ w <> []).
Proof.
  apply interacting_0L. set (t := fun x : letter => [[x]; [x; x]]). exists (System [a] [t]). split.
  - repeat split; try easy; now destruct H as [<-|[]].
  - assert (F : forall n w, In w [repeat a n; a :: repeat a n] -> step t (repeat a n) w \/ n = 0).
    { induction n as [|n IH]; intros w I; [auto|]. left. destruct n as [|n].
      - cbn in *. unfold step. apply parallel_letter. destruct I as [<-|[<-|[]]]; cbn; auto.
      - cbn [repeat] in *. destruct I as [<-|[<-|[]]].
        + apply (parallel_cons _ a [a]); [now left|]. destruct (IH (a :: repeat a n)) as [H|]; [now left|exact H|easy].
        + apply (parallel_cons _ a [a]); [now left|]. destruct (IH (a :: a :: repeat a n)) as [H|]; [right; now left|exact H|easy]. }
    intro w. split.
    + intros (O & N). apply only_a_row in O. rewrite up_repeat in O. rewrite O. destruct (length w) as [|n] eqn:Q; [now destruct w|]. clear O N Q.
      induction n as [|n IH]; [constructor|]. apply (derives_step _ _ _ _ t IH); [now left|]. destruct (F (S n) (repeat a (S (S n)))) as [H|H]; [right; now left|exact H|easy].
    + unfold generates. cbn. induction 1 as [|v w t' H (O & N) [<-|[]] St]; [easy|]. clear H. induction St as [|x u v w I St IH]; [easy|].
      destruct x as [|]; [discriminate|]. split; [|destruct I as [<-|[<-|[]]]; easy]. apply only_a_append. split; [destruct I as [<-|[<-|[]]]; easy|].
      destruct v as [|y v]; [now inversion St|]. now apply IH.
Qed.
Theorem interacting_not_closed_under_intersection : ~ closed Intersection IL.
Proof.
  intro C. apply (near_not_interacting 0 1), one_letter_of_many.
  specialize (C letter _ _ _ marked_words_interacting rows_interacting). revert C. apply is_same. intro w. rewrite (rows_of_marked w). unfold intersection. split; [tauto|].
  intros (M & O). repeat split; auto. intros ->. apply (marked_rows 0) in M as (n & _ & N). pose proof (power_larger n). lia.
Qed.
