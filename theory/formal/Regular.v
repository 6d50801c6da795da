(* Regular languages: nondeterministic automata with silent moves, the operations of Boolean algebra, reversal,
   substitution, and small languages. *)
From Algae Require Import Words.

(* ---- nondeterministic automata ---- *)
Lemma filter_shorter {X : Set} (f g : X -> bool) z l : (forall y, f y = true -> g y = true) -> In z l -> g z = true -> f z = false ->
  length (filter f l) < length (filter g l).
Proof.
  intros H. assert (Q : forall l, length (filter f l) <= length (filter g l)).
  { induction l0 as [|y l0 IH]; cbn; auto. destruct (f y) eqn:F; [rewrite (H y F); cbn; lia|destruct (g y); cbn; lia]. }
  induction l as [|y l IH]; cbn; [easy|]. intros [->|I] G F.
  - rewrite G, F. cbn. specialize (Q l). lia.
  - specialize (IH I G F). destruct (f y) eqn:Fy; [rewrite (H y Fy); cbn; lia|destruct (g y); cbn; lia].
Qed.

Section Nondeterministic.
  Context {A X : Set} {alphabet : Alphabet A} {states : Alphabet X}.
  Variables (silent : X -> list X) (read : X -> A -> list X).
  Inductive path : X -> list A -> X -> Prop :=
  | path_nil x : path x [] x
  | path_silent x y w z : In y (silent x) -> path y w z -> path x w z
  | path_read x a y w z : In y (read x a) -> path y w z -> path x (a :: w) z.

  Lemma path_append x u y v z : path x u y -> path y v z -> path x (u ++ v) z.
  Proof. induction 1; cbn; intros; auto; [eapply path_silent|eapply path_read]; eauto. Qed.
  Lemma path_split x u v z : path x (u ++ v) z -> exists y, path x u y /\ path y v z.
  Proof.
    intro H. remember (u ++ v) as w eqn:Q. revert u Q. induction H as [x|x y w z I H IH|x a y w z I H IH]; intros u Q.
    - apply eq_sym, app_eq_nil in Q as (-> & ->). exists x. split; constructor.
    - destruct (IH u Q) as (y' & H1 & H2). exists y'. split; auto. eapply path_silent; eauto.
    - destruct u as [|b u]; cbn in Q.
      + subst v. exists x. split; [constructor|]. eapply path_read; eauto.
      + injection Q as <- Q. destruct (IH u Q) as (y' & H1 & H2). exists y'. split; auto. eapply path_read; eauto.
  Qed.
  Lemma path_letter x a z : path x [a] z <-> exists y y', path x [] y /\ In y' (read y a) /\ path y' [] z.
  Proof.
    split.
    - intro H. remember [a] as w eqn:Q. induction H as [x|x y w z I H IH|x b y w z I H IH]; [easy| |].
      + destruct (IH Q) as (y1 & y2 & H1 & H2). exists y1, y2. split; auto. eapply path_silent; eauto.
      + injection Q as -> ->. exists x, y. split; [constructor|auto].
    - intros (y & y' & H & I & K). change [a] with ([] ++ [a]). eapply path_append; eauto. eapply path_read; eauto.
  Qed.

  (* what can be reached silently *)
  Lemma silently x : exists l, forall y, In y l <-> path x [] y.
  Proof.
    assert (Q : forall n l, In x l -> (forall y, In y l -> path x [] y) ->
      length (filter (fun y => if in_dec letter_eq y l then false else true) letters) < n -> exists l, forall y, In y l <-> path x [] y).
    { induction n as [|n IH]; intros l I R H; [lia|].
      destruct (find (fun y => if in_dec letter_eq y l then false else true) (flat_map silent l)) as [z|] eqn:F.
      - apply find_some in F as (J & F). apply (IH (z :: l)); [now right| |].
        + intros y [<-|K]; auto. apply in_flat_map in J as (y & K & J). rewrite <- (app_nil_r []). apply (path_append x [] y [] z); auto.
          eapply path_silent; eauto. constructor.
        + enough (length (filter (fun y => if in_dec letter_eq y (z :: l) then false else true) letters) <
                  length (filter (fun y => if in_dec letter_eq y l then false else true) letters)) by lia.
          apply (filter_shorter _ _ z); auto using all_letters.
          * intros y. destruct (in_dec letter_eq y (z :: l)) as [|N]; [easy|]. destruct (in_dec letter_eq y l) as [K|]; [now destruct N; right|easy].
          * destruct (in_dec letter_eq z (z :: l)) as [|N]; [easy|]. now destruct N; left.
      - exists l. intro y. split; auto. intro K. assert (G : forall x', In x' l -> path x' [] y -> In y l).
        { clear K. intros x' I' K. remember [] as w eqn:Q. induction K as [x'|x' y' w z J K IHK|]; [easy| |easy].
          apply IHK; auto. assert (In y' (flat_map silent l)) as M by (apply in_flat_map; eauto).
          pose proof (find_none _ _ F y' M) as N. cbn in N. now destruct (in_dec letter_eq y' l). }
        eauto. }
    apply (Q (S (length (filter (fun y => if in_dec letter_eq y [x] then false else true) letters))) [x]); [now left| |lia].
    intros y [<-|[]]. constructor.
  Qed.

  Theorem nondeterministic_regular (begins ends : X -> bool) :
    regular (fun w => exists x z, begins x = true /\ path x w z /\ ends z = true).
  Proof.
    destruct (choose _ silently (inhabits [])) as (reach & R).
    set (after := fun (q : function X bool) (a : A) => as_letter (fun z =>
      existsb (fun y => apply false q y && existsb (fun y' => if in_dec letter_eq z (reach y') then true else false) (read y a)) letters)).
    set (first := as_letter (fun z => existsb (fun x => begins x && if in_dec letter_eq z (reach x) then true else false) letters)).
    exists (function X bool), _, (Automaton first after (fun q => existsb (fun z => apply false q z && ends z) letters)).
    assert (Q : forall w z, apply false (fold_left after w first) z = true <-> exists x, begins x = true /\ path x w z).
    { induction w as [|a w IH] using rev_ind; intro z.
      - cbn. unfold first. rewrite apply_as_letter, existsb_exists. split.
        + intros (x & _ & (B & H)%andb_true_iff). destruct in_dec as [I|]; [|easy]. apply R in I. eauto.
        + intros (x & B & H). exists x. split; [apply all_letters|]. rewrite B. apply R in H. now destruct in_dec.
      - rewrite fold_left_app. cbn. unfold after at 1. rewrite apply_as_letter, existsb_exists. split.
        + intros (y & _ & (H & K)%andb_true_iff). apply IH in H as (x & B & H). exists x. split; auto.
          apply existsb_exists in K as (y' & I & K). destruct in_dec as [J|]; [|easy]. apply R in J.
          apply (path_append _ _ y); auto. apply path_letter. exists y, y'. split; [constructor|auto].
        + intros (x & B & (y0 & H & (y & y' & K & I & J)%path_letter)%path_split). exists y. split; [apply all_letters|].
          apply andb_true_iff. split.
          * apply IH. exists x. split; auto. rewrite <- (app_nil_r w). eapply path_append; eauto.
          * apply existsb_exists. exists y'. split; auto. apply R in J. now destruct in_dec. }
    intro w. unfold accepts. cbn. rewrite existsb_exists. split.
    - intros (x & z & B & H & E). exists z. split; [apply all_letters|]. apply andb_true_iff. split; auto. apply Q. eauto.
    - intros (z & _ & (H & E)%andb_true_iff). apply Q in H as (x & B & H). eauto.
  Qed.
End Nondeterministic.

(* ---- operations ---- *)
Theorem regular_complement : closed Complement REG.
Proof.
  intros A a. cbn. intros X (Q & q & M & S). exists Q, q, (Automaton (initial M) (next M) (fun x => negb (final M x))).
  intro w. unfold complement. rewrite (S w). unfold accepts. cbn. destruct (final M _); cbn; intuition congruence.
Qed.
Theorem regular_intersection_with_regular : closed IntersectionWithRegular REG.
Proof.
  intros A a. cbn. intros X Y (Q & q & M & S) (Q' & q' & M' & S'). exists (Q * Q')%type, _.
  exists (Automaton (initial M, initial M') (fun p x => (next M (fst p) x, next M' (snd p) x)) (fun p => final M (fst p) && final M' (snd p))).
  intro w. unfold intersection, accepts. rewrite (S w), (S' w). unfold accepts. cbn.
  assert (F : forall p p', fold_left (fun p x => (next M (fst p) x, next M' (snd p) x)) w (p, p') = (fold_left (next M) w p, fold_left (next M') w p'))
    by (induction w as [|x w IH]; cbn; auto).
  now rewrite F, andb_true_iff.
Qed.
Theorem regular_intersection : closed Intersection REG.
Proof. intros A a. cbn. intros X Y HX HY. now apply (regular_intersection_with_regular A a). Qed.

Theorem regular_reversal : closed Reversal REG.
Proof.
  intros A a. cbn. intros X (Q & q & M & S).
  set (read := fun y x => filter (fun z => if letter_eq (next M z x) y then true else false) letters).
  apply (is_same REG (fun w => exists x z, final M x = true /\ path (fun _ => []) read x w z /\ (if letter_eq z (initial M) then true else false) = true)).
  2: apply nondeterministic_regular.
  assert (F : forall w x z, path (fun _ => []) read x w z <-> fold_left (next M) (rev w) z = x).
  { intros w x z. split.
    - induction 1 as [x|x y w z I|x a' y w z I H IH]; [easy|easy|]. cbn. rewrite fold_left_app, IH. cbn.
      apply filter_In in I as (_ & I). now destruct letter_eq.
    - revert x. induction w as [|x' w IH]; cbn; intros x H; [subst; constructor|]. rewrite fold_left_app in H. cbn in H.
      apply (path_read _ _ _ x' (fold_left (next M) (rev w) z)); auto. apply filter_In. split; [apply all_letters|].
      rewrite H. now destruct letter_eq. }
  intro w. unfold reversal. rewrite (S (rev w)). unfold accepts. setoid_rewrite F. split.
  - intros (x & z & H & <- & K). now destruct (letter_eq z (initial M)) as [->|].
  - intro H. exists (fold_left (next M) (rev w) (initial M)), (initial M). now destruct letter_eq.
Qed.

Record some_automaton (B : Set) := Some_automaton { its_states : Set; its_alphabet : Alphabet its_states; it : automaton B its_states }.
#[export] Existing Instance its_alphabet.
Arguments its_states {B}. Arguments its_alphabet {B}. Arguments it {B}.
Theorem regular_substitution : closed Substitution REG.
Proof.
  intros A a. cbn. intros B b s X (Q & q & M & SX) H.
  assert (C : exists I : A -> some_automaton B, forall x, same (s x) (accepts (it (I x)))).
  { apply (choose (fun x (I : some_automaton B) => same (s x) (accepts (it I)))); [|constructor; exact (Some_automaton B unit _ (Automaton tt (fun _ _ => tt) (fun _ => true)))].
    intro x. destruct (H x) as (P & p & N & S). now exists (Some_automaton B P p N). }
  destruct C as (I & SI). clear H.
  (* within the outer automaton at q, or reading the word for a letter on the way from q *)
  set (state := (Q * option {x : A & its_states (I x)})%type).
  set (silent := fun st : state => match st with
    | (q, None) => map (fun x => (q, Some (existT (fun x => its_states (I x)) x (initial (it (I x)))))) letters
    | (q, Some (existT _ x p)) => if final (it (I x)) p then [(next M q x, None)] else [] end).
  set (read := fun (st : state) (y : B) => match st with
    | (q, None) => [] : list state
    | (q, Some (existT _ x p)) => [(q, Some (existT (fun x => its_states (I x)) x (next (it (I x)) p y)))] end).
  apply (is_same REG (fun w => exists st st', (if letter_eq st (initial M, None) then true else false) = true /\ path silent read st w st' /\
    (match st' with (q, None) => final M q | _ => false end) = true)).
  2: apply nondeterministic_regular.
  assert (F : forall st w q', path silent read st w (q', None) -> match st with
    | (q, None) => exists u, fold_left (next M) u q = q' /\ parallel s u w
    | (q, Some (existT _ x p)) => exists u w1 w2, w = w1 ++ w2 /\ final (it (I x)) (fold_left (next (it (I x))) w1 p) = true /\
        fold_left (next M) u (next M q x) = q' /\ parallel s u w2 end).
  { intros st w q' H. remember (q', None) as st' eqn:Z. induction H as [st|st st1 w st' J K IH|st y st1 w st' J K IH].
    - subst. exists []. auto.
    - specialize (IH Z). destruct st as (q1, [[x p]|]); cbn in J.
      + destruct (final (it (I x)) p) eqn:Fp; [|easy]. destruct J as [<-|[]]. destruct IH as (u & Fu & Pu). exists u, [], w. auto.
      + apply in_map_iff in J as (x & <- & _). destruct IH as (u & w1 & w2 & -> & F1 & Fu & Pu). exists (x :: u). split; auto.
        constructor; auto. now apply SI.
    - specialize (IH Z). destruct st as (q1, [[x p]|]); cbn in J; [|easy]. destruct J as [<-|[]].
      destruct IH as (u & w1 & w2 & -> & F1 & Fu & Pu). exists u, (y :: w1), w2. auto. }
  assert (G : forall x w q p, path silent read (q, Some (existT _ x p)) w (q, Some (existT _ x (fold_left (next (it (I x))) w p)))).
  { intros x w q0. induction w as [|y w IH]; cbn; intro p; [constructor|].
    apply (path_read _ _ _ y (q0, Some (existT _ x (next (it (I x)) p y)))); [now left|apply IH]. }
  intro w. split.
  - intros (st & st' & H1 & H2 & H3). destruct letter_eq as [->|]; [|easy]. destruct st' as (q', [|]); [easy|].
    apply F in H2 as (u & <- & Pu). exists u. split; auto. now apply SX.
  - intros (u & Xu & Pu). exists (initial M, None), (fold_left (next M) u (initial M), None). split; [now destruct letter_eq|].
    split; [|now apply SX in Xu]. clear Xu. generalize (initial M). induction Pu as [|x w1 u w2 K Pu IH]; intro q0; [constructor|].
    apply (path_silent _ _ _ (q0, Some (existT _ x (initial (it (I x)))))); [apply in_map_iff; exists x; split; [reflexivity|apply all_letters]|].
    eapply path_append; [apply G|]. apply (path_silent _ _ _ (next M q0 x, None)); [|exact (IH (next M q0 x))].
    cbn. apply SI in K. unfold accepts in K. rewrite K. now left.
Qed.

(* ---- small languages ---- *)
Lemma regular_words_of {A : Set} {a : Alphabet A} (good : A -> bool) : regular (fun w => forallb good w = true).
Proof.
  exists bool, _, (Automaton true (fun q x => q && good x) (fun q => q)). intro w. unfold accepts. cbn.
  assert (Q : forall q, fold_left (fun q x => q && good x) w q = q && forallb good w).
  { induction w as [|x w IH]; cbn; intro q; [now rewrite andb_true_r|]. now rewrite IH, andb_assoc. }
  now rewrite Q.
Qed.
Lemma regular_nothing {A : Set} : regular (fun _ : list A => False).
Proof. exists unit, _, (Automaton tt (fun _ _ => tt) (fun _ => false)). intro w. unfold accepts. cbn. easy. Qed.
Lemma regular_letter {A : Set} {a : Alphabet A} (good : A -> bool) : regular (fun w => exists x, w = [x] /\ good x = true).
Proof.
  exists (option bool), _, (Automaton (Some false) (fun q x => match q with Some false => if good x then Some true else None | _ => None end)
    (fun q => match q with Some true => true | _ => false end)).
  intro w. unfold accepts. cbn.
  assert (Q : forall w, fold_left (fun q x => match q with Some false => if good x then Some true else None | _ => None end) w None = None)
    by (induction w0; auto).
  split.
  - intros (x & -> & H). cbn. now rewrite H.
  - destruct w as [|x w]; cbn; [easy|]. destruct (good x) eqn:G; [|now rewrite Q]. destruct w as [|y w]; cbn; [eauto|now rewrite Q].
Qed.
Lemma regular_empty_word {A : Set} {a : Alphabet A} : regular (eq (@nil A)).
Proof.
  apply (is_same REG (fun w => forallb (fun _ : A => false) w = true)); [|apply regular_words_of].
  intros [|x w]; cbn; split; easy.
Qed.
