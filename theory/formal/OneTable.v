(* E0L languages: runs of one table are those of a system, although words of [fin] may be empty; and substitution
   into regular languages, where letters wait for the right moment. *)
From Algae Require Import Words Regular AbstractFamily Runs Extended Substitution.

Lemma one_table {V : Set} (t : table V) ts : incl ts [t] <-> ts = repeat t (length ts).
Proof.
  split.
  - induction ts as [|t' ts IH]; cbn; intro I; auto. f_equal; [|apply IH; intros x J; apply I; now right].
    destruct (I t' ltac:(now left)) as [->|[]]. reflexivity.
  - intros -> t' I. apply repeat_spec in I as ->. now left.
Qed.
Lemma one_table_runs {V A : Set} (t : table V) (fin : V -> list (list A)) (starts : list V) w :
  (exists x ts, In x starts /\ incl ts [t] /\ run fin ts x w) <-> exists x n, In x starts /\ run fin (repeat t n) x w.
Proof.
  split.
  - intros (x & ts & I & J%one_table & H). rewrite J in H. eauto.
  - intros (x & n & I & H). exists x, (repeat t n). repeat split; auto. intros t' J. apply repeat_spec in J as ->. now left.
Qed.
Lemma parallel_vanishes {V A : Set} (R : V -> list A -> Prop) u : parallel R u [] <-> forall x, In x u -> R x [].
Proof.
  induction u as [|x u IH]; [rewrite parallel_empty; cbn; intuition|]. rewrite parallel_first. split.
  - intros (p & w & (-> & ->)%eq_sym%app_eq_nil & H & K) y [<-|I]; auto. now apply IH.
  - intro H. exists [], []. split; auto. split; [apply H; now left|]. apply IH. intros y I. apply H. now right.
Qed.

(* ---- letters that will vanish are left out: a letter carries the set of all letters that will ---- *)
Section Doomed.
  Context {A V : Set} {a : Alphabet A} {v : Alphabet V}.
  Variables (t : table V) (fin : V -> list (list A)).
  Notation go n := (run fin (repeat t n)).
  Definition doomed_set := function V bool.
  Definition in_set (d : doomed_set) (x : V) : bool := apply false d x.
  Definition doomed_last : doomed_set := as_letter (fun x => existsb (fun w => match w with [] => true | _ => false end) (fin x)).
  Definition doomed_before (d : doomed_set) : doomed_set := as_letter (fun x => existsb (fun u => forallb (in_set d) u) (t x)).
  Definition doomed (n : nat) : doomed_set := Nat.iter n doomed_before doomed_last.
  Lemma doomed_right n x : in_set (doomed n) x = true <-> go n x [].
  Proof.
    revert x. induction n as [|n IH]; intro x; unfold in_set; cbn.
    - unfold doomed_last. rewrite apply_as_letter, existsb_exists. split; [intros ([|] & I & ?); easy|]. intro I. now exists [].
    - unfold doomed_before at 1. rewrite apply_as_letter, existsb_exists. split; intros (u & I & H); exists u; split; auto.
      + apply parallel_vanishes. intros y J. apply IH. rewrite forallb_forall in H. now apply H.
      + apply forallb_forall. intros y J. apply IH. rewrite parallel_vanishes in H. now apply H.
  Qed.

  Fixpoint kept (d : V -> bool) (u : list V) : list (list V) :=
    match u with [] => [[]] | y :: u => map (cons y) (kept d u) ++ if d y then kept d u else [] end.
  Lemma kept_right (d : V -> bool) (R : V -> list A -> Prop) u w : (forall x, d x = true <-> R x []) ->
    (exists u', In u' (kept d u) /\ parallel (fun x w => w <> [] /\ R x w) u' w) <-> parallel R u w.
  Proof.
    intro D. revert w. induction u as [|x u IH]; intro w; cbn.
    - split; [intros (u' & [<-|[]] & H); now apply parallel_empty in H as ->|intros ->%parallel_empty; exists []; auto].
    - rewrite parallel_first. split.
      + intros (u' & [(u1 & <- & I)%in_map_iff|I]%in_app_or & H).
        * apply parallel_first in H as (w1 & w2 & -> & (_ & K) & H). exists w1, w2. split; auto. split; auto. apply IH. eauto.
        * destruct (d x) eqn:Dx; [|easy]. exists [], w. split; auto. split; [now apply D|]. apply IH. eauto.
      + intros (w1 & w2 & -> & K & (u' & I & H)%IH). destruct w1 as [|c w1].
        * exists u'. split; auto. apply in_or_app. right. apply D in K. now rewrite K.
        * exists (x :: u'). split; [apply in_or_app; left; now apply in_map|]. now constructor.
  Qed.
  Definition not_empty {X : Set} (l : list (list X)) : list (list X) := filter (fun u => match u with [] => false | _ => true end) l.
  Lemma not_empty_in {X : Set} (l : list (list X)) u : In u (not_empty l) <-> In u l /\ u <> [].
  Proof. unfold not_empty. rewrite filter_In. destruct u; intuition congruence. Qed.

  Definition clean : table (V * doomed_set) := fun z =>
    flat_map (fun d => if letter_eq (doomed_before d) (snd z) then
      flat_map (fun u => map (map (fun y => (y, d))) (not_empty (kept (in_set d) u))) (t (fst z)) else []) letters.
  Definition clean_fin (z : V * doomed_set) : list (list A) := if letter_eq (snd z) doomed_last then not_empty (fin (fst z)) else [].
  Lemma clean_not_empty z : ~ In [] (clean z) /\ ~ In [] (clean_fin z).
  Proof.
    split.
    - intros (d & _ & H)%in_flat_map. destruct letter_eq; [|easy]. apply in_flat_map in H as (u & _ & H).
      apply in_map_iff in H as (u' & Q & H). apply not_empty_in in H as (_ & N). now destruct u'.
    - unfold clean_fin. destruct letter_eq; [|easy]. now intros (_ & H)%not_empty_in.
  Qed.
  Lemma clean_right n x d w : run clean_fin (repeat clean n) (x, d) w <-> d = doomed n /\ w <> [] /\ go n x w.
  Proof.
    revert x d w. induction n as [|n IH]; intros x d w; cbn.
    - unfold clean_fin. cbn. destruct letter_eq as [->|N].
      + rewrite not_empty_in. unfold doomed. cbn. intuition.
      + split; [easy|]. now intros (-> & _).
    - split.
      + intros (u' & I & H). unfold clean in I. apply in_flat_map in I as (d' & _ & I). cbn in I. destruct letter_eq as [<-|]; [|easy].
        apply in_flat_map in I as (u & I & J). apply in_map_iff in J as (u1 & <- & J). apply not_empty_in in J as (J & N).
        apply -> (@parallel_map_left) in H.
        assert (Q : d' = doomed n) by (destruct u1 as [|y u1]; [easy|]; apply parallel_first in H as (w1 & w2 & _ & H & _); now apply IH in H).
        subst d'. split; [reflexivity|]. assert (H' : parallel (fun x w => w <> [] /\ go n x w) u1 w) by (revert H; apply parallel_weaken; intros y p _ K; apply IH in K; intuition).
        split; [|exists u; split; auto; apply (kept_right (in_set (doomed n))); [apply doomed_right|eauto]].
        destruct u1 as [|y u1]; [easy|]. apply parallel_first in H' as (w1 & w2 & -> & (M & _) & _). now destruct w1.
      + intros (-> & N & u & I & H). apply (kept_right (in_set (doomed n))) in H as (u1 & J & H); [|apply doomed_right].
        exists (map (fun y => (y, doomed n)) u1). split.
        * unfold clean. apply in_flat_map. exists (doomed n). split; [apply all_letters|]. cbn. destruct letter_eq; [|easy].
          apply in_flat_map. exists u. split; auto. apply in_map, not_empty_in. split; auto. intros ->. now apply parallel_empty in H.
        * apply parallel_map_left. revert H. apply parallel_weaken. intros y p _ (K1 & K2). now apply IH.
  Qed.
End Doomed.

(* ---- runs of one table without empty words, and the empty word where a chain of sets says so ---- *)
Section Together.
  Context {A V C : Set} {a : Alphabet A} {v : Alphabet V} {c : Alphabet C}.
  Variables (starts : list V) (t : table V) (fin : V -> list (list A)) (c0 : C) (next_link : C -> C) (vanishes : C -> bool).
  Hypothesis full : forall x, ~ In [] (t x) /\ ~ In [] (fin x).
  Notation letter := (((V + C) + bool) + A)%type.     (* true begins, false fails *)
  Definition copied (u : list V) : list letter := map (fun x => inl (inl (inl x))) u.
  Definition ended (w : list A) : list letter := map inr w.
  Definition lost : letter := inl (inr false).
  Definition link (d : C) : letter := inl (inl (inr d)).
  Definition both : table letter := fun z =>
    match z with
    | inl (inl (inl x)) => [lost] :: map copied (t x) ++ map ended (fin x)
    | inl (inl (inr d)) => [link (next_link d)] :: if vanishes d then [[]] else []
    | inl (inr true) => [link c0] :: map (fun x => copied [x]) starts
    | _ => [[lost]]
    end.
  Definition together : system letter := System [inl (inr true)] [both].
  Definition mixed (z : list letter) : Prop := exists e, In (inr e) z /\ exists x, In (inl (inl (inl x))) z.

  Lemma after_copied u z : step both (copied u) z -> In lost z \/ mixed z \/ (exists u', step t u u' /\ z = copied u') \/
    (exists w, parallel (fun x w => In w (fin x)) u w /\ z = ended w).
  Proof.
    intro H. apply -> (@parallel_map_left) in H. induction H as [|x p u z I H IH]; [right; right; left; exists []; split; [constructor|reflexivity]|].
    assert (P : In lost p \/ (exists u', In u' (t x) /\ p = copied u') \/ (exists w, In w (fin x) /\ p = ended w)).
    { destruct I as [<-|[(u' & <- & J)%in_map_iff|(w & <- & J)%in_map_iff]%in_app_or]; [left; now left| |]; eauto. }
    assert (M : forall z1 z2, mixed z1 \/ mixed z2 -> mixed (z1 ++ z2)).
    { intros z1 z2 [(e & M1 & y & M2)|(e & M1 & y & M2)]; exists e; (split; [apply in_or_app; auto|]); exists y; apply in_or_app; auto. }
    destruct IH as [L|[Mz|[(u' & S & ->)|(w & F & ->)]]].
    - left. apply in_or_app. auto.
    - right; left. auto.
    - destruct P as [L|[(ux & J & ->)|(wx & J & ->)]]; [left; apply in_or_app; auto| |].
      + right; right; left. exists (ux ++ u'). split; [now constructor|]. unfold copied. now rewrite map_app.
      + destruct u' as [|y u'].
        * destruct u as [|x' u]; [right; right; right; exists wx; split; [now apply parallel_letter|now rewrite app_nil_r]|].
          apply parallel_vanishes with (x := x') in S; [|now left]. now apply full in S.
        * destruct wx as [|e wx]; [now apply full in J|]. right; left. exists e. split; [now left|]. exists y. apply in_or_app. right. now left.
    - destruct P as [L|[(ux & J & ->)|(wx & J & ->)]]; [left; apply in_or_app; auto| |].
      + destruct w as [|e w].
        * destruct u as [|x' u]; [right; right; left; exists ux; split; [now apply parallel_letter|now rewrite app_nil_r]|].
          apply parallel_vanishes with (x := x') in F; [|now left]. now apply full in F.
        * destruct ux as [|y ux]; [now apply full in J|]. right; left. exists e. split; [apply in_or_app; right; now left|]. exists y. now left.
      + right; right; right. exists (wx ++ w). split; [now constructor|]. unfold ended. now rewrite map_app.
  Qed.
  Lemma always_lost z z' y : In y z -> both y = [[lost]] -> step both z z' -> In lost z'.
  Proof. intros I Q S. destruct (parallel_member _ S I) as (u & J & L). apply L. rewrite Q in J. destruct J as [<-|[]]. now left. Qed.

  Lemma together_words w : generates together (map inr w) <->
    (w = [] /\ exists n, vanishes (Nat.iter n next_link c0) = true) \/ exists x ts, In x starts /\ incl ts [t] /\ run fin ts x w.
  Proof.
    assert (R : forall x ts w, run fin ts x w <-> exists u, leads ts [x] u /\ parallel (fun x v => In v (fin x)) u w).
    { intros x ts w'. rewrite <- run_leads. symmetry. apply parallel_letter. }
    set (reached := fun z => z = [inl (inr true)] \/ (exists n, z = [link (Nat.iter n next_link c0)]) \/
      (z = [] /\ exists n, vanishes (Nat.iter n next_link c0) = true) \/ In lost z \/ mixed z \/
      (exists x ts u, In x starts /\ incl ts [t] /\ leads ts [x] u /\ z = copied u) \/
      (exists x ts w, In x starts /\ incl ts [t] /\ run fin ts x w /\ z = ended w)).
    split.
    - assert (Q : forall z, generates together z -> reached z).
      { unfold generates. induction 1 as [|z z' T H IH I S]; [now left|]. destruct I as [<-|[]].
        destruct IH as [->|[(n & ->)|[(-> & n & E)|[L|[(e & M1 & x & M2)|[(x & ts & u & Ix & J & K & ->)|(x & ts & w' & Ix & J & K & ->)]]]]]].
        - apply of_letter in S. destruct S as [<-|(x & <- & Ix)%in_map_iff].
          + right; left. now exists 0.
          + do 5 right; left. exists x, [], [x]. repeat split; auto. easy.
        - apply of_letter in S. cbn in S. destruct S as [<-|S]; [right; left; now exists (S n)|].
          destruct (vanishes _) eqn:E; [|easy]. destruct S as [<-|[]]. do 2 right; left. eauto.
        - apply parallel_empty in S as ->. do 2 right; left. eauto.
        - do 3 right; left. now apply (always_lost z z' lost).
        - do 3 right; left. now apply (always_lost z z' (inr e)).
        - apply after_copied in S as [L|[M|[(u' & S & ->)|(w' & F & ->)]]]; [do 3 right; left; auto|do 4 right; left; auto|do 5 right; left|do 6 right].
          + exists x, (ts ++ [t]), u'. repeat split; auto; [apply incl_app; [exact J|apply incl_refl]|eapply leads_more; eauto].
          + exists x, ts, w'. repeat split; auto. apply R. eauto.
        - destruct w' as [|e w']; [apply parallel_empty in S as ->; do 6 right; exists x, ts, []; auto|].
          do 3 right; left. apply (always_lost _ z' (inr e)) in S; auto. now left. }
      intro H. apply Q in H as [H|[(n & H)|[(H & n & E)|[H|[(e & M1 & x & M2)|[(x & ts & u & Ix & J & K & H)|(x & ts & w' & Ix & J & K & H)]]]]]].
      + now destruct w.
      + now destruct w.
      + left. split; [now destruct w|eauto].
      + now apply in_map_iff in H as (? & ? & _).
      + now apply in_map_iff in M2 as (? & ? & _).
      + destruct w as [|e w], u as [|y u]; try easy. right. exists x, ts. repeat split; auto. apply R. exists []. auto.
      + apply map_inr_equal in H as ->. right. eauto.
    - unfold generates. intros [(-> & n & E)|(x & ts & Ix & J & (u & K & F)%R)].
      + assert (H : derives [both] [inl (inr true)] [link (Nat.iter n next_link c0)]).
        { clear E. induction n as [|n IH]; eapply derives_step; [constructor|now left|apply parallel_letter; now left|exact IH|now left|apply parallel_letter; now left]. }
        apply (derives_step _ _ _ _ both H); [now left|]. apply parallel_letter. cbn. rewrite E. right. now left.
      + apply (derives_step _ _ (copied u) _ both).
        * apply (@derives_first _ _ both _ (copied [x])); [now left|apply parallel_letter; right; now apply (in_map (fun x => copied [x]))|].
          clear F. generalize dependent ([x] : list V). intro y0. revert y0. induction ts as [|t' ts IH]; cbn; intros y K; [subst; constructor|].
          destruct (J t' ltac:(now left)) as [<-|[]]. destruct K as (u' & S & K). apply (@derives_first _ _ both _ (copied u')); [now left| |].
          -- apply parallel_map_left. apply (parallel_onto (fun x => inl (inl (inl x)) : letter) (R := fun x u => In u (t x))); [|exact S].
             intros z q _ M. right. apply in_or_app. left. now apply (in_map copied).
          -- apply IH; auto. intros t' M. apply J. now right.
        * now left.
        * apply parallel_map_left. apply (parallel_onto (@inr ((V + C) + bool) A) (R := fun x u => In u (fin x))); [|exact F].
          intros z q _ M. right. apply in_or_app. right. now apply (in_map ended).
  Qed.
End Together.

Theorem system_of_one_table_runs {A : Set} {a : Alphabet A} (X : language A) : runs false false X -> is E0L X.
Proof.
  intros (V & v & starts & ts & fin & m & _ & S). destruct (m eq_refl) as (t & ->). clear m.
  set (starts' := flat_map (fun x => map (pair x) letters) starts : list (V * doomed_set)).
  set (vanishes := fun d : doomed_set => existsb (in_set d) starts).
  exists ((V * doomed_set) + doomed_set + bool)%type, _, (together starts' (clean t) (clean_fin fin) (doomed_last fin) (doomed_before t) vanishes).
  split.
  - split; [easy|]. split; [easy|]. split; [easy|]. intros T z [<-|[]]. split; [|easy]. now destruct z as [[[x|d]|[]]|c].
  - intro w. rewrite (S w), one_table_runs.
    pose proof (together_words starts' (clean t) (clean_fin fin) (doomed_last fin) (doomed_before t) vanishes (clean_not_empty t fin) w) as Q.
    rewrite one_table_runs in Q. setoid_rewrite Q. clear Q. destruct w as [|e w].
    + split.
      * intros (x & n & I & H). left. split; auto. exists n. apply existsb_exists. exists x. split; auto. now apply (doomed_right t fin n).
      * intros [(_ & n & H)|((x, d) & n & _ & H)]; [|now apply clean_right in H].
        apply existsb_exists in H as (x & I & H). exists x, n. split; auto. now apply (doomed_right t fin n) in H.
    + split.
      * intros (x & n & I & H). right. exists (x, doomed t fin n), n. split; [|now apply clean_right].
        apply in_flat_map. exists x. split; auto. apply in_map, all_letters.
      * intros [(? & _)|((x, d) & n & I & H)]; [easy|]. apply clean_right in H as (_ & _ & H). exists x, n. split; auto.
        apply in_flat_map in I as (x' & I & J). apply in_map_iff in J as (d' & [= -> ->] & _). exact I.
Qed.

(* ---- substitution into regular languages ---- *)
Theorem one_table_runs_into_regular {A B : Set} {a : Alphabet A} {b : Alphabet B} (s : A -> language B) (R : language A) :
  regular R -> (forall x, runs false false (s x)) -> runs false false (substitution s R).
Proof.
  intros (Q & q & M & SR) H. destruct (choose_runs false false s H) as (I & SI). clear H.
  set (own := fun x => hd (fun _ => []) (its_tables (I x))).
  assert (SI' : forall x w, s x w <-> exists y n, In y (its_starts (I x)) /\ run (its_fin (I x)) (repeat (own x) n) y w).
  { intros x w. destruct (SI x) as (m & _ & S). rewrite (S w). unfold words_of, own. destruct (m eq_refl) as (t & ->). apply one_table_runs. }
  (* states, letters that wait for the start of their word, and letters of these words *)
  set (letter := (Q + A + {x : A & its_letters (I x)})%type).
  set (inj := fun x (y : its_letters (I x)) => inr (existT (fun x => its_letters (I x)) x y) : letter).
  set (t := fun z : letter => match z with
    | inl (inl p) => [z] :: map (fun x => [inl (inr x); inl (inl (next M p x))]) letters
    | inl (inr x) => [z] :: map (fun y => [inj x y]) (its_starts (I x))
    | inr (existT _ x y) => map (map (inj x)) (own x y) end).
  set (fin := fun z : letter => match z with
    | inl (inl p) => if final M p then [[]] else []
    | inl (inr x) => []
    | inr (existT _ x y) => its_fin (I x) y end).
  exists letter, _, [inl (inl (initial M))], [t], fin. split; [eauto|split; [easy|]].
  assert (Own : forall n x y w, run fin (repeat t n) (inj x y) w <-> run (its_fin (I x)) (repeat (own x) n) y w).
  { induction n as [|n IH]; intros x y w; [reflexivity|]. split.
    - intros (u & K & L). cbn in K. apply in_map_iff in K as (u' & <- & K). exists u'. split; auto. apply -> (@parallel_map_left) in L.
      revert L. apply parallel_weaken. intros z p _. apply IH.
    - intros (u & K & L). exists (map (inj x) u). split; [cbn; now apply in_map|]. apply parallel_map_left.
      revert L. apply parallel_weaken. intros z p _. apply IH. }
  assert (W1 : forall n x w, run fin (repeat t n) (inl (inr x)) w -> s x w).
  { induction n as [|n IH]; intros x w H; [easy|]. destruct H as (u & [<-|(y & <- & K)%in_map_iff] & L); apply of_letter in L; [eauto|].
    apply SI'. exists y, n. split; auto. now apply Own. }
  assert (W2 : forall x w, s x w -> exists m, forall n, m <= n -> run fin (repeat t n) (inl (inr x)) w).
  { intros x w (y & m & K & H)%SI'. exists (S m). intros n L. induction L as [|n L IH].
    - exists [inj x y]. split; [right; now apply (in_map (fun y => [inj x y]))|]. apply parallel_letter. now apply Own.
    - exists [inl (inr x)]. split; [now left|now apply parallel_letter]. }
  assert (F : forall n p w, run fin (repeat t n) (inl (inl p)) w -> exists u, final M (fold_left (next M) u p) = true /\ parallel s u w).
  { induction n as [|n IH]; intros p w H.
    - cbn in H. destruct (final M p) eqn:E; [|easy]. destruct H as [<-|[]]. now exists [].
    - destruct H as (u & [<-|(x & <- & _)%in_map_iff] & L); [apply of_letter in L; auto|].
      apply parallel_first in L as (w1 & w2 & -> & L1 & L2). apply of_letter in L2. destruct (IH _ _ L2) as (u & E & P). exists (x :: u). split; eauto. }
  assert (B' : forall u w, parallel s u w -> forall p, final M (fold_left (next M) u p) = true -> exists m, forall n, m <= n -> run fin (repeat t n) (inl (inl p)) w).
  { intros u w P. induction P as [|x w1 u w K P IH]; intros p E.
    - exists 0. intros n _. induction n as [|n IH]; [cbn in *; rewrite E; now left|]. exists [inl (inl p)]. split; [now left|now apply parallel_letter].
    - destruct (IH _ E) as (m2 & H2). destruct (W2 x w1 K) as (m1 & H1). exists (S (m1 + m2)). intros [|n] L; [lia|].
      exists [inl (inr x); inl (inl (next M p x))]. split; [right; apply in_map_iff; exists x; split; auto; apply all_letters|].
      constructor; [apply H1; lia|]. apply parallel_letter. apply H2. lia. }
  intro w. rewrite one_table_runs. unfold substitution. split.
  - intros (u & Ru & P). apply SR in Ru. destruct (B' u w P _ Ru) as (m & H). exists (inl (inl (initial M))), m. split; [now left|auto].
  - intros (z & n & [<-|[]] & H). apply F in H as (u & E & P). exists u. split; auto. now apply SR.
Qed.

(* ---- the families ---- *)
Lemma runs_are many one {A : Set} {a : Alphabet A} (X : language A) : (one = true -> many = true) ->
  is (LSystem (E_kind many one)) X <-> runs many one X.
Proof.
  intro H. split; [apply runs_of_system|]. destruct many; [apply system_of_runs|]. destruct one; [now specialize (H eq_refl)|].
  apply system_of_one_table_runs.
Qed.

Section Families.
  Variables many one : bool.
  Hypothesis sorts : one = true -> many = true.
  Let f := LSystem (E_kind many one).
  Theorem extended_into_regular : closed_under_regular_operations f.
  Proof.
    intros A B a b s R HR Hs. apply runs_are; auto. assert (H : forall x, runs many one (s x)) by (intro x; now apply runs_are).
    destruct many; [now apply runs_into_regular|]. destruct one; [now specialize (sorts eq_refl)|]. now apply one_table_runs_into_regular.
  Qed.
  Theorem extended_union : closed Union f.
  Proof. apply union_by_substitution, extended_into_regular. Qed.
  Theorem extended_concatenation : closed Concatenation f.
  Proof. apply concatenation_by_substitution, extended_into_regular. Qed.
  Theorem extended_star : closed Star f.
  Proof. apply star_by_substitution, extended_into_regular. Qed.
  Theorem extended_plus : closed Plus f.
  Proof. apply plus_by_substitution, extended_into_regular. Qed.
  Theorem extended_intersection_with_regular : closed IntersectionWithRegular f.
  Proof.
    intros A a. cbn. intros X R HX HR. apply runs_are; auto. apply runs_are in HX; auto. destruct one.
    - specialize (sorts eq_refl). clear f. subst many. now apply deterministic_runs_intersection_with_regular.
    - now apply runs_intersection_with_regular.
  Qed.
  Theorem extended_homomorphism : closed Homomorphism f.
  Proof.
    intros A a. cbn. intros B b h X HX. apply (is_same f _ _ (image_substitution h X)). apply runs_are; auto. apply runs_are in HX; auto.
    apply runs_finite_substitution; auto. intros _ x. apply at_most_single.
  Qed.
  Theorem extended_non_erasing_homomorphism : closed NonErasingHomomorphism f.
  Proof. apply non_erasing_homomorphism_by_homomorphism, extended_homomorphism. Qed.
  Theorem extended_finite_substitution : one = false -> closed FiniteSubstitution f.
  Proof.
    intros N A a. cbn. intros B b s X HX. apply runs_are; auto. apply runs_are in HX; auto.
    apply runs_finite_substitution; auto. congruence.
  Qed.
  Theorem extended_gsm_mapping : one = false -> closed GsmMapping f.
  Proof. intro N. apply gsm_by_substitution; [now apply extended_finite_substitution|apply extended_intersection_with_regular]. Qed.
End Families.

Theorem et0l_substitution : closed Substitution ET0L.
Proof.
  intros A a. cbn. intros B b s X HX Hs. apply (runs_are true false); auto. apply runs_substitution; [now apply (runs_of_system true false)|].
  intro x. apply (runs_of_system true false), Hs.
Qed.
Theorem regular_et0l : has_regular_languages ET0L.
Proof.
  intros A a X HX. apply (runs_are true false); auto.
  assert (H : runs true false (substitution (fun x => eq [x]) X)).
  { apply runs_into_regular; auto. intro x. exists unit, _, [tt], [], (fun _ => [[x]]). split; [easy|split; [easy|]].
    intro w. split; [intros <-; exists tt, []; split; [now left|split; [easy|now left]]|].
    intros (y & [|t ts] & _ & J & K); [now destruct K as [<-|[]]|]. now destruct (J t ltac:(now left)). }
  apply (runs_are true false) in H; auto. apply (runs_are true false); auto. revert H. apply is_same. intro w. unfold substitution.
  assert (P : forall u, parallel (fun x => eq [x]) u w <-> w = u).
  { intro u. rewrite (parallel_equal _ (fun x v => v = [x])) by (intros; split; auto). rewrite parallel_function, flat_map_single, map_id. reflexivity. }
  setoid_rewrite P. split; [now intros (u & Xu & ->)|eauto].
Qed.
Theorem et0l_inverse_homomorphism : closed InverseHomomorphism ET0L.
Proof.
  apply inverse_homomorphism_by_substitution; [apply et0l_substitution|apply (extended_intersection_with_regular true false); auto|exact regular_et0l].
Qed.
