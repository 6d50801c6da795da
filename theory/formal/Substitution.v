(* Substitution of languages of runs with tables: into runs with tables, where letters may choose (ET0L), and into
   regular languages, where they need not (EDT0L too).  One word after the other is derived; letters for later words
   wait, and the words that are ready stay. *)
From Algae Require Import Words Regular AbstractFamily Runs Extended.

Record some_runs (B : Set) := Some_runs {
  its_letters : Set; its_letters_alphabet : Alphabet its_letters;
  its_starts : list its_letters; its_tables : list (table its_letters); its_fin : its_letters -> list (list B) }.
#[export] Existing Instance its_letters_alphabet.
Arguments its_letters {B}. Arguments its_letters_alphabet {B}. Arguments its_starts {B}. Arguments its_tables {B}. Arguments its_fin {B}.
Definition words_of {B : Set} (I : some_runs B) : language B :=
  fun w => exists x ts, In x (its_starts I) /\ incl ts (its_tables I) /\ run (its_fin I) ts x w.
Definition deterministic_runs {B : Set} (I : some_runs B) : Prop :=
  forall x, at_most_one (its_fin I x) /\ forall t, In t (its_tables I) -> at_most_one (t x).
Lemma choose_runs {A B : Set} {a : Alphabet A} many one (s : A -> language B) : (forall x, runs many one (s x)) ->
  exists I : A -> some_runs B, forall x, (many = false -> exists t, its_tables (I x) = [t]) /\ (one = true -> deterministic_runs (I x)) /\ same (s x) (words_of (I x)).
Proof.
  intro H. apply (choose (fun x (I : some_runs B) => (many = false -> exists t, its_tables I = [t]) /\ (one = true -> deterministic_runs I) /\ same (s x) (words_of I))).
  - intro x. destruct (H x) as (V & v & starts & ts & fin & m & o & S). now exists (Some_runs B V v starts ts fin).
  - constructor. exact (Some_runs B unit _ [] [] (fun _ => [])).
Qed.

Section Inner.
  Context {A B O : Set} {a : Alphabet A}.
  Variable I : A -> some_runs B.
  Notation letter := (O + ({x : A & its_letters (I x)} + B))%type.
  Definition inner (x : A) (y : its_letters (I x)) : letter := inr (inl (existT _ x y)).
  Definition ready (c : B) : letter := inr (inr c).
  (* tables that act on outer letters only, on the letters of one inner system, and the one that ends inner words *)
  Definition outer (o : O -> list (list letter)) : table letter := fun z => match z with inl y => o y | _ => [[z]] end.
  Definition inside (x : A) (t : table (its_letters (I x))) : table letter := fun z =>
    match z with
    | inr (inl (existT _ x' y)) => match letter_eq x' x with
        | left e => map (map (inner x)) (t (eq_rect x' (fun x => its_letters (I x)) y x e))
        | right _ => [[z]] end
    | _ => [[z]] end.
  Definition finish : table letter := fun z =>
    match z with inr (inl (existT _ x y)) => map (map ready) (its_fin (I x) y) | _ => [[z]] end.
  Variable outs : list (O -> list (list letter)).
  Variable fin_out : O -> list (list B).
  Definition inner_tables : list (table letter) := flat_map (fun x => map (inside x) (its_tables (I x))) letters.
  Definition all_tables : list (table letter) := map outer outs ++ finish :: inner_tables.
  Definition fin_all (z : letter) : list (list B) := match z with inl y => fin_out y | inr (inl _) => [] | inr (inr c) => [[c]] end.
  Notation go := (run fin_all).

  Lemma inside_same x t y : inside x t (inner x y) = map (map (inner x)) (t y).
  Proof. cbn. destruct (letter_eq x x) as [e|]; [|easy]. now rewrite (Eqdep_dec.UIP_dec letter_eq e eq_refl). Qed.
  Lemma table_cases t : In t all_tables -> (exists o, In o outs /\ t = outer o) \/ t = finish \/ exists x t', In t' (its_tables (I x)) /\ t = inside x t'.
  Proof.
    intros [(o & <- & J)%in_map_iff|[<-|(x & _ & (t' & <- & J)%in_map_iff)%in_flat_map]]%in_app_or; [left|right; left|right; right]; eauto.
  Qed.
  Lemma stay (R : letter -> list B -> Prop) z w : (exists u, In u [[z]] /\ parallel R u w) <-> R z w.
  Proof. split; [intros (u & [<-|[]] & H); now apply of_letter|]. intro H. exists [z]. split; [now left|now apply parallel_letter]. Qed.

  Lemma stayed (R : letter -> list B -> Prop) z w : (exists u, In u [[z]] /\ parallel R u w) -> R z w.
  Proof. apply stay. Qed.

  Lemma ready_stays ts c w : incl ts all_tables -> go ts (ready c) w <-> w = [c].
  Proof.
    induction ts as [|t ts IH]; intro J; cbn [run].
    - cbn. intuition congruence.
    - assert (Q : t (ready c) = [[ready c]]) by (destruct (table_cases t (J t ltac:(now left))) as [(o & _ & ->)|[->|(x & t' & _ & ->)]]; reflexivity).
      rewrite Q, stay. apply IH. intros t' K. apply J. now right.
  Qed.
  Lemma ready_word ts u w : incl ts all_tables -> parallel (go ts) (map ready u) w <-> w = u.
  Proof.
    intro J. rewrite parallel_map_left. rewrite (parallel_equal _ (fun c w => w = [c]) u w (fun c w => ready_stays ts c w J)).
    rewrite (parallel_function (fun c => [c])). now rewrite flat_map_single, map_id.
  Qed.
  Lemma inner_words ts x : incl ts all_tables -> exists ts0, incl ts0 (its_tables (I x)) /\ forall y w, go ts (inner x y) w -> run (its_fin (I x)) ts0 y w.
  Proof.
    induction ts as [|t ts IH]; intro J; [now exists []|]. destruct IH as (ts0 & J0 & H); [intros t' K; apply J; now right|].
    destruct (table_cases t (J t ltac:(now left))) as [(o & _ & ->)|[->|(x' & t' & It & ->)]].
    - exists ts0. split; auto. intros y w K. apply H. exact (stayed _ _ _ K).
    - exists []. split; [easy|]. intros y w (u & K & L). cbn in K. apply in_map_iff in K as (v & <- & K).
      apply ready_word in L as ->; [exact K|]. intros t' M. apply J. now right.
    - destruct (letter_eq x x') as [<-|N].
      + exists (t' :: ts0). split; [intros t [<-|M]; auto|]. intros y w (u & K & L). rewrite inside_same in K.
        apply in_map_iff in K as (v & <- & K). exists v. split; auto. apply -> (@parallel_map_left) in L. revert L. apply parallel_weaken. auto.
      + exists ts0. split; auto. intros y w (u & K & L). apply H. cbn in K. destruct letter_eq; [easy|]. destruct K as [<-|[]]. now apply of_letter in L.
  Qed.
  (* a word of an inner system can be made while outer letters wait *)
  Lemma make_word x w : words_of (I x) w -> exists y ts, In y (its_starts (I x)) /\ incl ts all_tables /\
    (forall ts', incl ts' all_tables -> go (ts ++ ts') (inner x y) w) /\ (forall ts' o w', go ts' (inl o) w' -> go (ts ++ ts') (inl o) w').
  Proof.
    intros (y & ts & Iy & J & H). exists y, (map (inside x) ts ++ [finish]). split; auto. split; [|split].
    - intros t [(t' & <- & K)%in_map_iff|[<-|[]]]%in_app_or; apply in_or_app; right; [right|now left].
      apply in_flat_map. exists x. split; [apply all_letters|]. apply in_map. auto.
    - intros ts' J'. clear Iy J. revert y w H. induction ts as [|t ts IH]; intros y w H.
      + exists (map ready w). split; [now apply in_map|]. now apply ready_word.
      + destruct H as (u & K & L). exists (map (inner x) u). rewrite inside_same. split; [now apply in_map|].
        apply parallel_map_left. revert L. apply parallel_weaken. auto.
    - intros ts' o w' H'. clear H J. induction ts as [|t ts IH]; cbn; apply stay; auto.
  Qed.
  Lemma one_at_most : (forall x, deterministic_runs (I x)) -> (forall o y, In o outs -> at_most_one (o y)) -> (forall y, at_most_one (fin_out y)) ->
    forall z, at_most_one (fin_all z) /\ forall t, In t all_tables -> at_most_one (t z).
  Proof.
    intros D Do Df z. split; [destruct z as [y|[y|c]]; cbn; [apply Df|easy|apply at_most_single]|].
    intros t J. destruct (table_cases t J) as [(o & Io & ->)|[->|(x & t' & It & ->)]]; destruct z as [y|[(x' & y)|c]]; cbn; try apply at_most_single.
    - now apply Do.
    - apply at_most_map. apply D.
    - destruct letter_eq as [->|]; [|apply at_most_single]. apply at_most_map. cbn. now apply D.
  Qed.
End Inner.
Arguments stayed {A B O I}. 

(* ---- into regular languages ---- *)
Theorem runs_into_regular {A B : Set} {a : Alphabet A} {b : Alphabet B} one (s : A -> language B) (R : language A) :
  regular R -> (forall x, runs true one (s x)) -> runs true one (substitution s R).
Proof.
  intros (Q & q & M & SR) H. destruct (choose_runs true one s H) as (I & SI). clear H.
  assert (SI' : forall x w, s x w <-> words_of (I x) w) by (intros x; apply SI).
  set (letter := (Q + ({x : A & its_letters (I x)} + B))%type).
  set (launch := fun (p : Q) x (y : its_letters (I x)) (p' : Q) => if letter_eq p p' then [[inner I x y; inl (next M p x)]] else [[inl p']] : list (list letter)).
  set (outs := flat_map (fun p => flat_map (fun x => map (launch p x) (its_starts (I x))) letters) letters).
  assert (Outs : forall o, In o outs <-> exists p x y, In y (its_starts (I x)) /\ o = launch p x y).
  { intro o. unfold outs. rewrite in_flat_map. split.
    - intros (p & _ & (x & _ & (y & <- & K)%in_map_iff)%in_flat_map). eauto 6.
    - intros (p & x & y & K & ->). exists p. split; [apply all_letters|]. apply in_flat_map. exists x. split; [apply all_letters|now apply in_map]. }
  set (fin_out := fun p => if final M p then [[]] else [] : list (list B)).
  exists letter, _, [inl (initial M)], (all_tables I outs), (fin_all I fin_out). split; [easy|split].
  - intro O. apply one_at_most.
    + intro x. now apply SI.
    + intros o p (p' & x & y & _ & ->)%Outs. unfold launch. destruct letter_eq; apply at_most_single.
    + intro p. unfold fin_out. destruct (final M p); [apply at_most_single|easy].
  - assert (F : forall ts p w, incl ts (all_tables I outs) -> run (fin_all I fin_out) ts (inl p) w -> exists u, final M (fold_left (next M) u p) = true /\ parallel s u w).
    { induction ts as [|t ts IH]; intros p w J H.
      - cbn in H. unfold fin_out in H. destruct (final M p) eqn:E; [|easy]. destruct H as [<-|[]]. now exists [].
      - assert (J' : incl ts (all_tables I outs)) by (intros t' K; apply J; now right).
        destruct (table_cases I outs t (J t ltac:(now left))) as [(o & Io & ->)|[->|(x & t' & It & ->)]].
        + apply Outs in Io as (p' & x & y & Iy & ->). destruct H as (u & K & L). cbn in K. unfold launch in K. destruct (letter_eq p' p) as [->|].
          * destruct K as [<-|[]]. apply parallel_first in L as (w1 & w2 & -> & L1 & L2). apply of_letter in L2.
            destruct (IH _ _ J' L2) as (u & E & P). exists (x :: u). split; auto. constructor; auto. apply SI'.
            destruct (inner_words I outs fin_out ts x J') as (ts0 & J0 & W). exists y, ts0. auto.
          * destruct K as [<-|[]]. apply of_letter in L. auto.
        + apply (IH p w J'). exact (stayed _ _ _ H).
        + apply (IH p w J'). exact (stayed _ _ _ H). }
    intro w. unfold substitution. split.
    + intros (u & Ru & P). apply SR in Ru. unfold accepts in Ru. exists (inl (initial M)).
      enough (G : exists ts, incl ts (all_tables I outs) /\ run (fin_all I fin_out) ts (inl (initial M)) w) by (destruct G as (ts & G); exists ts; split; [now left|exact G]).
      revert Ru. generalize (initial M). induction P as [|x w1 u w K P IH]; intros p E.
      * exists []. split; [easy|]. cbn in *. unfold fin_out. rewrite E. now left.
      * destruct (IH _ E) as (ts & J & G). apply SI' in K. destruct (make_word I outs fin_out x w1 K) as (y & ts1 & Iy & J1 & W & Wait).
        exists (outer I (launch p x y) :: ts1 ++ ts). split.
        -- intros t [<-|L]; [apply in_or_app; left; apply in_map, Outs; eauto|]. apply in_app_or in L as [L|L]; auto.
        -- exists [inner I x y; inl (next M p x)]. split; [cbn; unfold launch; destruct letter_eq; [now left|easy]|].
           constructor; auto. apply parallel_letter. auto.
    + intros (z & ts & [<-|[]] & J & H). apply F in H as (u & E & P); auto. exists u. split; auto. now apply SR.
Qed.

(* ---- into languages of runs ---- *)
Theorem runs_substitution {A B : Set} {a : Alphabet A} {b : Alphabet B} (s : A -> language B) (X : language A) :
  runs true false X -> (forall x, runs true false (s x)) -> runs true false (substitution s X).
Proof.
  intros (V & v & starts & ts & fin & _ & _ & SX) H. destruct (choose_runs true false s H) as (I & SI). clear H.
  assert (SI' : forall x w, s x w <-> words_of (I x) w) by (intros x; apply SI).
  (* outer letters: those of X, and letters that wait for the start of an inner word *)
  set (O := (V + A)%type). set (letter := (O + ({x : A & its_letters (I x)} + B))%type).
  set (first := fun (t : table V) (y : O) => match y with inl x => map (map (fun x => inl (inl x))) (t x) | inr _ => [[inl y]] end : list (list letter)).
  set (turn := fun y : O => match y with inl x => map (map (fun x => inl (inr x))) (fin x) | inr _ => [[inl y]] end : list (list letter)).
  set (launch := fun y : O => match y with inl _ => [[inl y]] | inr x => [inl y] :: map (fun y => [inner I x y]) (its_starts (I x)) end : list (list letter)).
  set (outs := turn :: launch :: map first ts). set (fin_out := fun _ : O => [] : list (list B)).
  set (tables := all_tables I outs). set (go := run (fin_all I fin_out)).
  exists letter, _, (map (fun x => inl (inl x)) starts), tables, (fin_all I fin_out). split; [easy|split; [easy|]].
  assert (Cases : forall t, In t tables -> t = outer I turn \/ t = outer I launch \/ (exists t', In t' ts /\ t = outer I (first t')) \/
      (forall y : O, t (inl y) = [[inl y]])).
  { intros t J. destruct (table_cases I outs t J) as [(o & [<-|[<-|(t' & <- & K)%in_map_iff]] & ->)|[->|(x & t' & It & ->)]]; [auto|auto|eauto 6|auto|auto]. }
  assert (Waits : forall ts' x w, incl ts' tables -> go ts' (inl (inr x)) w -> s x w).
  { induction ts' as [|t ts' IH]; intros x w J H; [easy|]. assert (J' : incl ts' tables) by (intros t' K; apply J; now right).
    destruct (Cases t (J t ltac:(now left))) as [->|[->|[(t' & _ & ->)|E]]].
    - apply (IH x w J'). exact (stayed _ _ _ H).
    - destruct H as (u & [<-|(y & <- & K)%in_map_iff] & L); apply of_letter in L; [auto|].
      apply SI'. destruct (inner_words I outs fin_out ts' x J') as (ts0 & J0 & W). exists y, ts0. auto.
    - apply (IH x w J'). exact (stayed _ _ _ H).
    - apply (IH x w J'). unfold go in H. cbn [run] in H. rewrite E in H. exact (stayed _ _ _ H). }
  assert (F : forall ts', incl ts' tables -> exists ts0, incl ts0 ts /\ forall x w, go ts' (inl (inl x)) w -> exists u, run fin ts0 x u /\ parallel s u w).
  { induction ts' as [|t ts' IH]; intro J; [now exists []|]. assert (J' : incl ts' tables) by (intros t' K; apply J; now right).
    destruct (IH J') as (ts0 & J0 & G). destruct (Cases t (J t ltac:(now left))) as [->|[->|[(t' & It & ->)|E]]].
    - exists []. split; [easy|]. intros x w (z & K & L). cbn in K. apply in_map_iff in K as (u & <- & K). exists u. split; auto.
      apply -> (@parallel_map_left) in L. revert L. apply parallel_weaken. intros y p _. now apply Waits.
    - exists ts0. split; auto. intros x w H. apply G. exact (stayed _ (inl (inl x)) _ H).
    - exists (t' :: ts0). split; [intros t [<-|K]; auto|]. intros x w (z & K & L). cbn in K. apply in_map_iff in K as (u & <- & K).
      apply -> (@parallel_map_left) in L. assert (P : parallel (fun x w => exists u, run fin ts0 x u /\ parallel s u w) u w)
        by (revert L; apply parallel_weaken; auto).
      apply parallel_compose in P as (u' & P1 & P2). exists u'. split; auto. now exists u.
    - exists ts0. split; auto. intros x w H. apply G. unfold go in H. cbn [run] in H. rewrite E in H. exact (stayed _ _ _ H). }
  assert (B1 : forall u w, parallel s u w -> exists ts', incl ts' tables /\ parallel (go ts') (map (fun x => inl (inr x)) u) w).
  { intros u w P. induction P as [|x w1 u w K P (ts2 & J2 & L)]; [exists []; split; [easy|constructor]|].
    apply SI' in K. destruct (make_word I outs fin_out x w1 K) as (y & ts1 & Iy & J1 & W & Wait).
    exists (outer I launch :: ts1 ++ ts2). split.
    - intros t [<-|M]; [apply in_or_app; left; apply in_map; right; now left|]. apply in_app_or in M as [M|M]; auto.
    - cbn [map]. constructor.
      + exists [inner I x y]. split; [right; now apply (in_map (fun y => [inner I x y]))|]. apply parallel_letter. now apply W.
      + apply parallel_map_left. apply -> (@parallel_map_left) in L. revert L. apply parallel_weaken. intros x' w' _ G.
        exists [inl (inr x')]. split; [now left|]. apply parallel_letter. now apply Wait. }
  assert (B2 : forall ts' ts0 x u w, parallel (go ts') (map (fun x => inl (inr x)) u) w -> run fin ts0 x u ->
      go (map (fun t => outer I (first t)) ts0 ++ outer I turn :: ts') (inl (inl x)) w).
  { intros ts' ts0. induction ts0 as [|t ts0 IH]; intros x u w L H.
    - exists (map (fun x => inl (inr x)) u). split; auto. cbn. now apply in_map.
    - destruct H as (u' & K & H). exists (map (fun x => inl (inl x)) u'). split; [cbn; now apply in_map|]. apply parallel_map_left.
      apply -> (@parallel_map_left) in L. assert (P : exists u, parallel (run fin ts0) u' u /\ parallel (fun x => go ts' (inl (inr x))) u w) by eauto.
      apply parallel_compose in P. revert P. apply parallel_weaken. intros y p _ (u0 & P1 & P2). apply (IH y u0); auto. now apply parallel_map_left. }
  intro w. unfold substitution. split.
  - intros (u & (x & ts0 & Ix & J & H)%SX & P). destruct (B1 u w P) as (ts' & J' & L). exists (inl (inl x)), (map (fun t => outer I (first t)) ts0 ++ outer I turn :: ts').
    split; [now apply (in_map (fun x => inl (inl x)))|]. split; [|now apply (B2 ts' ts0 x u)].
    intros t [(t' & <- & K)%in_map_iff|[<-|K]]%in_app_or; auto; apply in_or_app; left; apply in_map; [right; right; apply in_map; auto|now left].
  - intros (z & ts' & (x & <- & Ix)%in_map_iff & J & H). destruct (F ts' J) as (ts0 & J0 & G). destruct (G _ _ H) as (u & H0 & P).
    exists u. split; auto. apply SX. eauto 8.
Qed.
