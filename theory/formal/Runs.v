(* A form of E0L, ET0L and EDT0L languages in which closure is easy to prove.

   A run of the tables t1 ... tn makes a letter x a word by these tables, one after the other, and then replaces every
   letter y by a word of a finite set [fin y].  So letters do not have to agree by themselves on the moment at which
   they become terminals, tables may have no successor for a letter, and there may be several letters to start from. *)
From Algae Require Import Words.

Section Run.
  Context {A V : Set}.
  Variable fin : V -> list (list A).
  Fixpoint run (ts : list (table V)) (x : V) (w : list A) : Prop :=
    match ts with
    | [] => In w (fin x)
    | t :: ts => exists u, In u (t x) /\ parallel (run ts) u w
    end.
  Fixpoint leads (ts : list (table V)) (u v : list V) : Prop :=
    match ts with [] => u = v | t :: ts => exists u', step t u u' /\ leads ts u' v end.

  Lemma run_leads ts u w : parallel (run ts) u w <-> exists v, leads ts u v /\ parallel (fun x v => In v (fin x)) v w.
  Proof.
    revert u w. induction ts as [|t ts IH]; intros u w; cbn.
    - split; [eauto|now intros (v & -> & H)].
    - rewrite (parallel_compose (fun x u => In u (t x)) (run ts) u w). split.
      + intros (u' & H & (v & K & F)%IH). eauto.
      + intros (v & (u' & H & K) & F). exists u'. split; auto. apply IH. eauto.
  Qed.
End Run.
Lemma leads_more {V : Set} (ts : list (table V)) t u v w : leads ts u v -> step t v w -> leads (ts ++ [t]) u w.
Proof. revert u. induction ts as [|t' ts IH]; cbn; intros u; [intros -> H; eauto|]. intros (u' & H & K) S. eauto. Qed.
Lemma derives_leads {V : Set} (ts : list (table V)) u v : derives ts u v <-> exists ts', incl ts' ts /\ leads ts' u v.
Proof.
  split.
  - induction 1 as [|v w t H (ts' & I & K) J S]; [now exists []|]. exists (ts' ++ [t]). split; [|eapply leads_more; eauto].
    apply incl_app; auto. now intros t' [<-|[]].
  - intros (ts' & I & H). revert u I H. induction ts' as [|t ts' IH]; cbn; intros u I H; [subst; constructor|].
    destruct H as (u' & S & H). apply (@derives_first _ ts t u u' v); auto; [apply I; now left|].
    apply IH; auto. intros t' J. apply I. now right.
Qed.

Definition at_most_one {X : Set} (l : list X) : Prop := forall u v, In u l -> In v l -> u = v.
(* [many]: any number of tables; [one]: at most one successor *)
Definition runs {A : Set} (many one : bool) (X : language A) : Prop :=
  exists (V : Set) (_ : Alphabet V) (starts : list V) (ts : list (table V)) (fin : V -> list (list A)),
    (many = false -> exists t, ts = [t]) /\
    (one = true -> forall x, at_most_one (fin x) /\ forall t, In t ts -> at_most_one (t x)) /\
    same X (fun w => exists x ts', In x starts /\ incl ts' ts /\ run fin ts' x w).
Definition E_kind (many one : bool) := Kind many one false true.

Lemma at_most_map {X Y : Set} (f : X -> Y) l : at_most_one l -> at_most_one (map f l).
Proof. intros H u v (u' & <- & I)%in_map_iff (v' & <- & J)%in_map_iff. f_equal. auto. Qed.
Lemma at_most_single {X : Set} (x : X) : at_most_one [x].
Proof. intros u v [<-|[]] [<-|[]]. reflexivity. Qed.

(* ---- systems have this form ---- *)
Section FromSystem.
  Context {A N : Set}.
  Variable G : system (N + A).
  Definition lifted (t : table (N + A)) : table (option (N + A)) :=
    fun x => match x with None => [map Some (axiom G)] | Some y => map (map Some) (t y) end.
  Definition terminals (x : option (N + A)) : list (list A) := match x with Some (inr c) => [[c]] | _ => [] end.
  Lemma lifted_run ts u w : parallel (run terminals (map lifted ts)) (map Some u) w <-> leads ts u (map inr w).
  Proof.
    rewrite run_leads. assert (F : forall v, parallel (fun x v => In v (terminals x)) v w <-> v = map Some (map inr w)).
    { intro v. split.
      - induction 1 as [|[[n|c]|] z v w I H IH]; cbn in *; try easy. destruct I as [<-|[]]. now subst.
      - intros ->. induction w as [|c w IH]; cbn; auto. change (c :: w) with ([c] ++ w). constructor; cbn; auto. }
    setoid_rewrite F.
    assert (L : forall v, leads (map lifted ts) (map Some u) (map Some v) <-> leads ts u v).
    { revert u. induction ts as [|t ts IH]; cbn; intros u v.
      - split; [|now intros ->]. revert v. induction u; intros [|]; cbn; intros [=]; f_equal; auto.
      - assert (S : forall z, step (lifted t) (map Some u) z <-> exists u', step t u u' /\ z = map Some u').
        { intro z. unfold step. rewrite parallel_map_left, <- (parallel_map_right Some). apply parallel_equal. intros x z'. cbn.
          rewrite in_map_iff. split; intros (u' & H1 & H2); exists u'; auto. }
        split.
        + intros (z & (u' & H & ->)%S & K). exists u'. split; auto. now apply IH.
        + intros (u' & H & K). exists (map Some u'). split; [apply S; eauto|now apply IH]. }
    split; [intros (v & H & ->); now apply L|]. intro H. exists (map Some (map inr w)). split; auto. now apply L.
  Qed.
End FromSystem.
Lemma runs_of_system {A : Set} {a : Alphabet A} many one (X : language A) : is (LSystem (E_kind many one)) X -> runs many one X.
Proof.
  intros (N & n & G & (_ & ne & single & g) & S). exists (option (N + A)), _, [None], (map (lifted G) (tables G)), terminals.
  split; [|split].
  - intro M. specialize (single M). destruct (tables G) as [|t [|]]; try easy. now exists (lifted G t).
  - intros O x. split; [destruct x as [[|]|]; try easy; apply at_most_single|]. intros t' (t & <- & I)%in_map_iff.
    destruct x as [y|]; [|apply at_most_single]. apply at_most_map. destruct (g t y I) as (_ & d & _). exact (d O).
  - intro w. rewrite (S w). unfold generates. rewrite derives_leads. split.
    + intros (ts & I & H). destruct (tables G) as [|t0 ts0] eqn:Q; [easy|]. exists None, (map (lifted G) (t0 :: ts)). split; [now left|].
      split; [apply incl_map; intros t [<-|J]; [now left|auto]|]. exists (map Some (axiom G)). split; [now left|]. now apply lifted_run.
    + intros (x & ts' & [<-|[]] & I & H).
      assert (Q : exists ts, ts' = map (lifted G) ts /\ incl ts (tables G)).
      { clear H. induction ts' as [|t' ts' IH]; [now exists []|]. destruct IH as (ts & -> & J); [intros t J; apply I; now right|].
        destruct (proj1 (in_map_iff _ _ _) (I t' ltac:(now left))) as (t & <- & K). exists (t :: ts). split; auto.
        intros t' [<-|]; auto. }
      destruct Q as ([|t ts] & -> & J); [easy|]. destruct H as (u & [<-|[]] & H). apply lifted_run in H. exists ts. split; auto.
      intros t' K. apply J. now right.
Qed.

(* ---- with tables, this form is a system ---- *)
Section ToSystem.
  Context {A V : Set} {a : Alphabet A} {v : Alphabet V}.
  Variables (starts : list V) (ts : list (table V)) (fin : V -> list (list A)).
  Notation letter := ((V + bool) + A)%type.        (* true begins, false fails *)
  Definition copy (u : list V) : list letter := map (fun x => inl (inl x)) u.
  Definition done (w : list A) : list letter := map inr w.
  Definition fails : letter := inl (inr false).
  Definition or_fail (l : list (list letter)) : list (list letter) := match l with [] => [[fails]] | _ => l end.
  Definition go (t : table V) : table letter :=
    fun x => match x with inl (inl x) => or_fail (map copy (t x)) | inl (inr true) => [[x]] | _ => [[fails]] end.
  Definition stop : table letter :=
    fun x => match x with inl (inl x) => or_fail (map done (fin x)) | _ => [[fails]] end.
  Definition begin (s : V) : table letter := fun x => match x with inl (inr true) => [[inl (inl s)]] | _ => [[fails]] end.
  Definition synchronised : system letter := System [inl (inr true)] (stop :: map go ts ++ map begin starts).

  Lemma or_fail_in l u : In u (or_fail l) -> In u l \/ u = [fails].
  Proof. destruct l; cbn; [intros [<-|[]]; auto|auto]. Qed.
  Lemma in_or_fail l u : In u l -> In u (or_fail l).
  Proof. now destruct l. Qed.
  Lemma after_copy (f : V -> list (list letter)) (T : table letter) u z : (forall x, T (inl (inl x)) = or_fail (f x)) ->
    step T (copy u) z -> In fails z \/ parallel (fun x u => In u (f x)) u z.
  Proof.
    intros E H. apply -> (@parallel_map_left) in H. induction H as [|x p u z I H IH]; auto. rewrite (E x) in I.
    destruct (or_fail_in _ _ I) as [J| ->]; [|left; now left]. destruct IH as [K|K]; [left; apply in_or_app; auto|right; auto].
  Qed.
  Lemma still_fails T z z' : (In T (tables synchronised)) -> In fails z -> step T z z' -> In fails z'.
  Proof.
    intros I F H. destruct (parallel_member _ H F) as (u & J & L). apply L. destruct I as [<-|[(t & <- & _)%in_map_iff|(s & <- & _)%in_map_iff]%in_app_or];
      destruct J as [<-|[]]; now left.
  Qed.
  Lemma synchronised_words w : generates synchronised (map inr w) <-> exists x ts', In x starts /\ incl ts' ts /\ run fin ts' x w.
  Proof.
    set (reached := fun z => z = [inl (inr true)] \/ In fails z \/
      (exists x ts' u, In x starts /\ incl ts' ts /\ leads ts' [x] u /\ z = copy u) \/
      (exists x ts' w, In x starts /\ incl ts' ts /\ run fin ts' x w /\ z = done w)).
    assert (R : forall x ts' w, run fin ts' x w <-> exists u, leads ts' [x] u /\ parallel (fun x v => In v (fin x)) u w).
    { intros x ts' w'. rewrite <- run_leads. symmetry. apply parallel_letter. }
    split.
    - assert (Q : forall z, generates synchronised z -> reached z).
      { unfold generates. induction 1 as [|z z' T H IH I S]; [now left|]. destruct IH as [->|[F|[(x & ts' & u & Ix & J & K & ->)|(x & ts' & w' & Ix & J & K & ->)]]].
        - apply of_letter in S. destruct I as [<-|[(t & <- & It)%in_map_iff|(s & <- & Is)%in_map_iff]%in_app_or]; destruct S as [<-|[]].
          + right; left; now left.
          + now left.
          + right; right; left. exists s, [], [s]. repeat split; auto. easy.
        - right; left. eapply still_fails; eauto.
        - destruct I as [<-|[(t & <- & It)%in_map_iff|(s & <- & Is)%in_map_iff]%in_app_or].
          + apply (after_copy (fun x => map done (fin x))) in S as [S|S]; [right; left; auto| |easy].
            right; right; right. assert (P : exists w', parallel (fun x v => In v (fin x)) u w' /\ z' = done w').
            { apply parallel_map_right. eapply parallel_weaken; [|exact S]. cbn. intros y p _ (q & <- & M)%in_map_iff. eauto. }
            destruct P as (w' & P & ->). exists x, ts', w'. repeat split; auto. apply R. eauto.
          + apply (after_copy (fun x => map copy (t x))) in S as [S|S]; [right; left; auto| |easy].
            right; right; left. assert (P : exists u', step t u u' /\ z' = copy u').
            { apply parallel_map_right. eapply parallel_weaken; [|exact S]. cbn. intros y p _ (q & <- & M)%in_map_iff. eauto. }
            destruct P as (u' & P & ->). exists x, (ts' ++ [t]), u'. repeat split; auto; [|eapply leads_more; eauto].
            apply incl_app; auto. now intros t' [<-|[]].
          + destruct u as [|y u]; [apply parallel_empty in S as ->; right; right; left; exists x, ts', []; auto|].
            right; left. apply parallel_first in S as (p & z & -> & [<-|[]] & _). now left.
        - destruct w' as [|c w']; [apply parallel_empty in S as ->; right; right; right; exists x, ts', []; auto|].
          right; left. apply parallel_first in S as (p & z & -> & M & _).
          destruct I as [<-|[(t & <- & It)%in_map_iff|(s & <- & Is)%in_map_iff]%in_app_or]; destruct M as [<-|[]]; now left. }
      intros H. apply Q in H as [H|[H|[(x & ts' & u & Ix & J & K & H)|(x & ts' & w' & Ix & J & K & H)]]].
      + destruct w as [|c w]; easy.
      + now apply in_map_iff in H as (c & ? & _).
      + destruct w as [|c w], u as [|y u]; try easy. exists x, ts'. repeat split; auto. apply R. exists []. auto.
      + apply map_inr_equal in H as ->. eauto.
    - intros (x & ts' & Ix & J & H). apply R in H as (u & K & F). unfold generates.
      apply (derives_step _ _ (copy u) _ stop); [|now left|].
      + apply (@derives_first _ _ (begin x) _ (copy [x])); [right; apply in_or_app; right; now apply in_map|apply parallel_letter; now left|].
        clear F. generalize dependent ([x] : list V). intro y0. revert y0. induction ts' as [|t ts' IH]; cbn; intros y K; [subst; constructor|].
        destruct K as (u' & S & K). apply (@derives_first _ _ (go t) _ (copy u')).
        * right. apply in_or_app. left. apply in_map, J. now left.
        * apply parallel_map_left.
          apply (parallel_onto (fun x => inl (inl x) : letter) (R := fun x u => In u (t x))); [|exact S]. intros z q _ M. now apply in_or_fail, in_map.
        * apply IH; auto. intros t' M. apply J. now right.
      + apply parallel_map_left.
        apply (parallel_onto (@inr (V + bool) A) (R := fun x u => In u (fin x))); [|exact F]. intros z q _ M. now apply in_or_fail, in_map.
  Qed.
End ToSystem.
Theorem system_of_runs {A : Set} {a : Alphabet A} one (X : language A) : runs true one X -> is (LSystem (E_kind true one)) X.
Proof.
  intros (V & v & starts & ts & fin & _ & g & S). exists (V + bool)%type, _, (synchronised starts ts fin). split.
  - split; [easy|]. split; [easy|]. split; [easy|]. intros t x I. split; [|split; [|easy]].
    + destruct I as [<-|[(t' & <- & _)%in_map_iff|(s & <- & _)%in_map_iff]%in_app_or]; destruct x as [[x|[]]|c]; cbn; try easy.
      * now destruct (fin x).
      * now destruct (t' x).
    + intro O. specialize (g O). assert (Of : forall l, at_most_one l -> at_most_one (@or_fail A V l)) by (intros [|? ?]; [intros _; apply at_most_single|easy]).
      change (at_most_one (t x)).
      destruct I as [<-|[(t' & <- & J)%in_map_iff|(s & <- & _)%in_map_iff]%in_app_or]; destruct x as [[x|[]]|c]; cbn; try apply at_most_single;
        apply Of, at_most_map; now apply (g x).
  - intro w. rewrite (S w). symmetry. apply synchronised_words.
Qed.
