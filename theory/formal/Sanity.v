(* That the definitions of Spec.v mean something: small systems and words that are and are not in their languages, and
   languages that are and are not in families.  Letters are a and b. *)
From Algae Require Import Words.

Notation a := false.
Notation b := true.

(* ---- steps and derivations ---- *)
Definition doubling : table bool := fun x => [[x; x]].
Definition powers_of_two : system bool := System [a] [doubling].
Lemma doubling_lengthens v w : step doubling v w -> length w = length v + length v.
Proof. induction 1 as [|x u v w [<-|[]] _ IH]; cbn; lia. Qed.
Lemma four_letters_derived : generates powers_of_two [a; a; a; a].
Proof.
  apply (derives_step _ _ [a; a] _ doubling); [|now left|repeat (apply (parallel_cons _ a [a; a]); [now left|]); constructor].
  apply (derives_step _ _ [a] _ doubling); [constructor|now left|apply parallel_letter; now left].
Qed.
Lemma three_letters_not_derived : ~ generates powers_of_two [a; a; a].
Proof.
  intro H. inversion H as [|v w t K I S]. destruct I as [<-|[]]. apply doubling_lengthens in S. cbn in S. lia.
Qed.
Lemma no_letter_not_derived w : generates powers_of_two w -> w <> [].
Proof.
  unfold generates. cbn. induction 1 as [|v w t H IH [<-|[]] S]; [easy|]. apply doubling_lengthens in S. destruct v; [easy|].
  destruct w; [cbn in S; lia|easy].
Qed.
(* all letters change at once *)
Lemma one_letter_does_not_wait : ~ step (fun x => [[negb x]]) [a; a] [a; b].
Proof. intros (u & w & Q & [<-|[]] & (u' & w' & -> & [<-|[]] & _)%parallel_first)%parallel_first. discriminate. Qed.
Lemma both_letters_change : step (fun x => [[negb x]]) [a; a] [b; b].
Proof. repeat (apply (parallel_cons _ a [b]); [now left|]). constructor. Qed.
(* letters choose each for itself, but not between tables *)
Lemma letters_choose : step (fun _ => [[a]; [b]]) [a; a] [a; b].
Proof. apply (parallel_cons _ a [a]); [now left|]. apply (parallel_cons _ a [b]); [right; now left|constructor]. Qed.
Lemma one_table_a_step t : In t [fun _ => [[a]]; fun _ => [[b]]] -> ~ step t [a; a] [a; b].
Proof. intros [<-|[<-|[]]] (u & w & Q & [<-|[]] & (u' & w' & -> & [<-|[]] & _)%parallel_first)%parallel_first; discriminate. Qed.

(* ---- kinds ---- *)
Definition simple : kind := Kind false true true false.
Lemma powers_of_two_simple : of_kind simple powers_of_two.
Proof.
  repeat split; try easy; destruct H as [<-|[]]; cbn; try easy.
  - intros _ u v [<-|[]] [<-|[]]. reflexivity.
  - intros _ [|[]]. discriminate.
Qed.
Lemma two_successors_not_deterministic : ~ of_kind (Kind false true false false) (System [a] [fun _ => [[a]; [b]]]).
Proof.
  intros (_ & _ & _ & g). destruct (g _ a (or_introl eq_refl)) as (_ & d & _).
  specialize (d eq_refl [a] [b] ltac:(now left) ltac:(right; now left)). discriminate.
Qed.
Lemma erasing_not_propagating : ~ of_kind (Kind false false true false) (System [a] [fun _ => [[]]]).
Proof. intros (_ & _ & _ & g). destruct (g _ a (or_introl eq_refl)) as (_ & _ & p). apply (p eq_refl). now left. Qed.
Lemma two_tables_need_T : ~ of_kind (Kind false false false false) (System [a] [doubling; doubling]).
Proof. intros (_ & _ & n & _). specialize (n eq_refl). discriminate. Qed.
Lemma axiom_not_empty : ~ of_kind (Kind true false false false) (System [] [doubling]).
Proof. now intros (n & _). Qed.

(* ---- families ---- *)
Lemma no_words_not_0L : ~ is OL (fun _ : list bool => False).
Proof. intros (G & _ & S). apply (S (axiom G)). constructor. Qed.
Lemma no_words_E0L : is E0L (fun _ : list bool => False).
Proof.
  exists unit, _, (System [inl tt] [fun x => [[x]]]). split.
  - repeat split; try easy; destruct H as [<-|[]]; cbn; easy.
  - intro w. split; [easy|]. intro H. assert (Q : forall z, generates (System [inl tt] [fun x : unit + bool => [[x]]]) z -> z = [inl tt]).
    { unfold generates. cbn. induction 1 as [|v z t K IH [<-|[]] S]; auto. subst v. apply of_letter in S. now destruct S as [<-|[]]. }
    apply Q in H. now destruct w.
Qed.
Lemma empty_word_0L_only_with_another : ~ is OL (eq (@nil bool)).
Proof. intros (G & (n & _) & S). apply n. symmetry. apply S. constructor. Qed.
Lemma empty_word_or_a_0L : is OL (fun w => w = [] \/ w = [a]).
Proof.
  exists (System [a] [fun _ => [[]]]). split.
  - repeat split; try easy; destruct H as [<-|[]]; cbn; easy.
  - intro w. split.
    + intros [->| ->]; [|constructor]. apply (derives_step _ _ [a] _ (fun _ => [[]])); [constructor|now left|apply parallel_letter; now left].
    + unfold generates. cbn. induction 1 as [|v w t K IH [<-|[]] S]; auto. left. clear K IH. induction S as [|x u v w [<-|[]] _ IH]; auto.
Qed.
Lemma even_length_regular : regular (fun w : list bool => Nat.even (length w) = true).
Proof.
  exists bool, _, (Automaton true (fun q _ => negb q) (fun q => q)). intro w. unfold accepts. cbn. enough (Q : forall w q,
    fold_left (fun q (_ : bool) => negb q) w q = Bool.eqb (Nat.even (length w)) q).
  { rewrite Q. now destruct (Nat.even (length w)). }
  clear w. induction w as [|x w IH]; intro q; [now destruct q|]. cbn [fold_left length]. rewrite IH, Nat.even_succ, <- Nat.negb_even.
  now destruct (Nat.even (length w)), q.
Qed.
(* S -> aSb | empty *)
Definition nested : grammar bool unit := Grammar tt (fun _ => [[]; [inr a; inl tt; inr b]]).
Lemma aabb_nested : rewrites nested [inl tt] (map inr [a; a; b; b]).
Proof.
  apply (rewrites_step nested _ [inr a; inr a] tt [inr b; inr b] []); [|now left].
  apply (rewrites_step nested _ [inr a] tt [inr b] [inr a; inl tt; inr b]); [|right; now left].
  apply (rewrites_step nested _ [] tt [] [inr a; inl tt; inr b]); [constructor|right; now left].
Qed.
Lemma nested_even z : rewrites nested [inl tt] z -> Nat.even (length (filter (fun x => match x with inr _ => true | _ => false end) z)) = true.
Proof.
  induction 1 as [|u X v r H IH I]; [reflexivity|]. rewrite !filter_app, !app_length in *. cbn [filter] in IH.
  destruct I as [<-|[<-|[]]]; cbn [filter length]; [exact IH|].
  rewrite Nat.add_succ_l, Nat.add_succ_l, Nat.add_succ_r, Nat.add_succ_r. exact IH.
Qed.
Lemma aab_not_nested : ~ rewrites nested [inl tt] (map inr [a; a; b]).
Proof. intro H. now apply nested_even in H. Qed.
(* the first letter, which has no left neighbour, grows; the others stay *)
Definition first_grows : interactive bool := Interactive [a] 1 0 (fun p x q => match p with [] => [[x; b]] | _ => [[x]] end).
Lemma abb_by_contexts : context_generates first_grows [a; b; b].
Proof.
  apply (context_next _ [a; b]).
  - apply (context_next _ [a]); [constructor|]. apply (context_cons _ [] a [] [a; b]); [now left|constructor].
  - apply (context_cons _ [] a [b] [a; b]); [now left|]. apply (context_cons _ [a] b [] [b]); [now left|constructor].
Qed.

(* ---- operations ---- *)
Lemma star_has_empty_word (X : language bool) : star X [].
Proof. now exists []. Qed.
Lemma plus_of_a_has_no_empty_word : ~ plus (eq [a]) [].
Proof. intros (us & N & Q & F). destruct us as [|u us]; [easy|]. rewrite <- (F u ltac:(now left)) in Q. discriminate. Qed.
Lemma finite_substitution_chooses : finite_substitution (fun _ => [[a]; [b; b]]) (eq [a; a]) [a; b; b].
Proof. exists [a; a]. split; auto. apply (parallel_cons _ a [a]); [now left|]. apply parallel_letter. right. now left. Qed.
Lemma homomorphism_does_not_choose : ~ image (fun x : bool => [x; x]) (eq [a; a]) [a; a].
Proof. intros (u & <- & Q). discriminate. Qed.
(* a machine that writes every other letter *)
Lemma every_other_letter : translation (Machine false (fun q x => [(if q then [x] else [], negb q)]) (fun _ => true)) (eq [a; b; a; b]) [b; b].
Proof.
  exists [a; b; a; b]. split; auto. apply (translates_cons _ false a true []); [now left|]. apply (translates_cons _ true b false [b]); [now left|].
  apply (translates_cons _ false a true []); [now left|]. apply (translates_cons _ true b false [b]); [now left|]. now constructor.
Qed.
