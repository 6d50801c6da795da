(* A checker of statements, with the proof that what it accepts is true.  It is extracted to OCaml for verify.ml, which
   reads certificates.  Covered are statements on finite languages, that a finite language is in no family without
   nonterminals of some kind, and derivations. *)
From Algae Require Import Words Obstruction Extended.

(* ---- one table: what is known of it is known at every step ---- *)
Section OneTable.
  Context {A : Set} {alphabet : Alphabet A}.
  Variables functional nonerasing : bool.
  Variable K : list (list A).
  Notation rule := (A * list A)%type.
  Fixpoint reachable (n : nat) (rs : list rule) (U : list (list A)) : list (list A) :=
    match n with 0 => U | S n => reachable n rs (nodup word_eq (U ++ flat_map (Obstruction.results rs) U)) end.
  Fixpoint refuted_from (w : list A) (n : nat) (rs : list rule) : bool :=
    match n with
    | 0 => false
    | S n =>
      if contradictory functional nonerasing K rs then true else
      match unknown K rs with
      | Some x => forallb (fun u => refuted_from w n ((x, u) :: rs)) (images K)
      | None =>
        let U := reachable (length K) rs [w] in
        existsb (fun v => negb (member v U)) K && forallb (fun c => refuted_from w n (snd c ++ rs)) (crossings K U)
      end
    end.
  Definition excluded_one (n : nat) : bool := forallb (fun w => match w with [] => true | _ => refuted_from w n [] end) K.

  Lemma reachable_start n rs U w : In w U -> In w (reachable n rs U).
  Proof. revert U. induction n as [|n IH]; cbn; intros U I; auto. apply IH, nodup_In, in_or_app. auto. Qed.
  Lemma refuted_from_right (t : table A) w n rs : (forall v, In v K <-> derives [t] w v) ->
    keeps functional nonerasing K (fun x u => In u (t x)) -> (forall r, In r rs -> In (snd r) (t (fst r))) -> refuted_from w n rs = true -> False.
  Proof.
    intros S M. revert rs. induction n as [|n IH]; cbn; [easy|]. intros rs F. destruct (contradictory _ _ K rs) eqn:C.
    - intros _. exact (contradiction functional nonerasing K (fun x u => In u (t x)) rs M F C).
    - unfold unknown. destruct find as [x|] eqn:Q.
      + intro H. apply find_some in Q as (I & _). destruct (total _ _ _ _ M x) as (u & Hu). rewrite forallb_forall in H.
        apply (IH ((x, u) :: rs)); [|apply H; exact (image_known functional nonerasing K (fun x u => In u (t x)) x u M I Hu)]. intros r [<-|J]; auto.
      + intros (O & H)%andb_true_iff. apply existsb_exists in O as (v & Iv & N%negb_true_iff%member_out). rewrite forallb_forall in H.
        destruct (first_crossing [t] w v (reachable (length K) rs [w])) as (t' & u & u' & [<-|[]] & D & P & Iu & Nu); auto;
          [now apply S|apply reachable_start; now left|].
        destruct (ways_have _ _ _ P) as (rs' & Ir & F'). apply (IH (rs' ++ rs)).
        * intros r [J|J]%in_app_or; auto.
        * apply (H (u', rs')). apply in_flat_map. exists u. split; auto. apply in_flat_map. exists u'. split; [apply S; eauto using derives_step, in_eq|].
          apply member_out in Nu as ->. now apply in_map.
  Qed.
  Theorem excluded_one_right n k : extended k = false -> tabled k = false -> (functional = true -> deterministic k = true) ->
    (nonerasing = true -> propagating k = true) -> excluded_one n = true -> ~ lsystem k (fun w => In w K).
  Proof.
    unfold excluded_one, lsystem. rewrite forallb_forall. intros -> T d p H (G & (ne & _ & single & g) & S). specialize (single T).
    destruct (tables G) as [|t [|]] eqn:Q; try discriminate. unfold generates in S. rewrite Q in S.
    assert (I : In (axiom G) K) by (apply S; constructor). specialize (H _ I).
    destruct (axiom G) as [|x w] eqn:E; [easy|]. rewrite <- E in *.
    apply (refuted_from_right t (axiom G) n [] S) in H; auto; [|easy]. split.
    - intro x'. destruct (g t x' (or_introl eq_refl)) as (s & _). destruct (t x') as [|u us]; [easy|]. exists u. now left.
    - intros v w' Iv Hw. apply S. apply (derives_step _ _ v w' t); [now apply S|now left|exact Hw].
    - intros f x' u v. apply (g t x' (or_introl eq_refl)). auto.
    - intros e x'. apply (g t x' (or_introl eq_refl)). auto.
  Qed.
End OneTable.

Section Statements.
  Context {A : Set} {alphabet : Alphabet A}.
  Notation word := (list A).

  (* ---- finite languages ---- *)
  Inductive expression :=
  | Words (ws : list word) | United (e f : expression) | Intersected (e f : expression) | Difference (e f : expression)
  | Product (e f : expression) | Reversed (e : expression) | Imaged (h : list (A * word)) (e : expression).
  (* the image of a word all of whose letters have one *)
  Fixpoint image_of (h : list (A * word)) (u : word) : option word :=
    match u with
    | [] => Some []
    | x :: u => match find (fun r => if letter_eq (fst r) x then true else false) h, image_of h u with
                | Some r, Some v => Some (snd r ++ v)
                | _, _ => None end
    end.
  Fixpoint denotes (e : expression) : language A :=
    match e with
    | Words ws => fun w => In w ws
    | United e f => union (denotes e) (denotes f)
    | Intersected e f => intersection (denotes e) (denotes f)
    | Difference e f => intersection (denotes e) (complement (denotes f))
    | Product e f => concatenation (denotes e) (denotes f)
    | Reversed e => reversal (denotes e)
    | Imaged h e => fun w => exists u, denotes e u /\ image_of h u = Some w
    end.
  Fixpoint value (e : expression) : list word :=
    match e with
    | Words ws => ws
    | United e f => value e ++ value f
    | Intersected e f => let F := value f in filter (fun w => member w F) (value e)
    | Difference e f => let F := value f in filter (fun w => negb (member w F)) (value e)
    | Product e f => let F := value f in flat_map (fun u => map (app u) F) (value e)
    | Reversed e => map (@rev A) (value e)
    | Imaged h e => flat_map (fun u => match image_of h u with Some v => [v] | None => [] end) (value e)
    end.
  Lemma value_right e w : In w (value e) <-> denotes e w.
  Proof.
    revert w. induction e as [ws|e IHe f IHf|e IHe f IHf|e IHe f IHf|e IHe f IHf|e IHe|h e IHe]; intro w; cbn.
    - reflexivity.
    - unfold union. now rewrite in_app_iff, IHe, IHf.
    - unfold intersection. now rewrite filter_In, member_in, IHe, IHf.
    - unfold intersection, complement. now rewrite filter_In, negb_true_iff, member_out, IHe, IHf.
    - unfold concatenation. rewrite in_flat_map. split.
      + intros (u & Iu & (v & <- & Iv)%in_map_iff). exists u, v. split; auto. split; [now apply IHe|now apply IHf].
      + intros (u & v & -> & Hu & Hv). exists u. split; [now apply IHe|]. apply in_map. now apply IHf.
    - unfold reversal. rewrite in_map_iff, <- IHe. split; [intros (u & <- & I); now rewrite rev_involutive|].
      intro I. exists (rev w). now rewrite rev_involutive.
    - rewrite in_flat_map. split.
      + intros (u & I & J). exists u. destruct (image_of h u); [|easy]. destruct J as [<-|[]]. split; auto. now apply IHe.
      + intros (u & Hu & Q). exists u. split; [now apply IHe|]. rewrite Q. now left.
  Qed.
  Definition subset (K L : list word) : bool := forallb (fun w => member w L) K.
  Lemma subset_right K L : subset K L = true <-> forall w, In w K -> In w L.
  Proof. unfold subset. rewrite forallb_forall. split; intros H w I; apply member_in || apply H in I; auto; now apply member_in. Qed.

  (* ---- derivations: a table as lists of rules, where a letter without a rule stays ---- *)
  Definition table_of (rules : list (A * word)) : table A := fun x =>
    match map snd (filter (fun r => if letter_eq (fst r) x then true else false) rules) with [] => [[x]] | us => us end.
  Fixpoint behind (u v : word) : option word :=    (* what stands behind u in v *)
    match u, v with
    | [], _ => Some v
    | x :: u, y :: v => if letter_eq x y then behind u v else None
    | _, [] => None
    end.
  Lemma behind_right u v w : behind u v = Some w -> v = u ++ w.
  Proof.
    revert v. induction u as [|x u IH]; intros v; cbn; [now intros [=]|]. destruct v as [|y v]; [easy|].
    destruct (letter_eq x y) as [->|]; [|easy]. intros ->%IH. reflexivity.
  Qed.
  Fixpoint is_step (t : table A) (u v : word) : bool :=
    match u with
    | [] => match v with [] => true | _ => false end
    | x :: u => existsb (fun s => match behind s v with Some v => is_step t u v | None => false end) (t x)
    end.
  Lemma is_step_right t u v : is_step t u v = true -> step t u v.
  Proof.
    revert v. induction u as [|x u IH]; intros v; cbn; [destruct v; [constructor|easy]|]. intros (s & I & H)%existsb_exists.
    destruct (behind s v) as [v'|] eqn:Q; [|easy]. apply behind_right in Q as ->. constructor; auto. now apply IH.
  Qed.
  Fixpoint derives_in (ts : list (table A)) (n : nat) (u w : word) : Prop :=
    match n with 0 => u = w | S n => exists t v, In t ts /\ step t u v /\ derives_in ts n v w end.
  Fixpoint is_derivation (ts : list (table A)) (n : nat) (u : word) (vs : list word) (w : word) : bool :=
    match n, vs with
    | 0, [] => if word_eq u w then true else false
    | S n, v :: vs => existsb (fun t => is_step t u v) ts && is_derivation ts n v vs w
    | _, _ => false
    end.
  Lemma is_derivation_right ts n u vs w : is_derivation ts n u vs w = true -> derives_in ts n u w.
  Proof.
    revert u vs. induction n as [|n IH]; intros u [|v vs]; cbn; try easy; [now destruct word_eq|].
    intros ((t & I & H)%existsb_exists & K)%andb_true_iff. exists t, v. repeat split; auto; [now apply is_step_right|eauto].
  Qed.
  Lemma derives_in_derives ts n u w : derives_in ts n u w -> derives ts u w.
  Proof. revert u. induction n as [|n IH]; cbn; intro u; [now intros ->|]. intros (t & v & I & S & H). exact (derives_first I S (IH v H)). Qed.

  (* ---- systems without nonterminals: their form, and their languages where these are finite ---- *)
  Definition has_form (k : kind) (ts : list (list (A * word))) (u : word) : bool :=
    negb (extended k) && (match u with [] => false | _ => true end) && (match ts with [] => false | _ => true end) &&
    (tabled k || (length ts =? 1)) && forallb (fun rs => (negb (deterministic k) || negb (clash rs)) && (negb (propagating k) || negb (erases rs))) ts.
  Lemma table_of_in rs x v : In v (table_of rs x) -> In (x, v) rs \/ v = [x] /\ forall w, ~ In (x, w) rs.
  Proof.
    assert (Q : forall v, In v (map snd (filter (fun r => if letter_eq (fst r) x then true else false) rs)) <-> In (x, v) rs).
    { intro w. rewrite in_map_iff. split.
      - intros ((y, w') & <- & (I & J)%filter_In). cbn in *. now destruct (letter_eq y x) as [->|].
      - intro I. exists (x, w). split; auto. apply filter_In. cbn. now destruct letter_eq. }
    unfold table_of. destruct (map snd _) as [|w ws] eqn:M.
    - intros [<-|[]]. right. split; auto. intros w I. now apply Q in I.
    - intro I. left. now apply Q.
  Qed.
  Lemma has_form_right k ts u : has_form k ts u = true -> lsystem k (derives (map table_of ts) u).
  Proof.
    unfold has_form. rewrite !andb_true_iff. intros ((((E%negb_true_iff & U) & Ne) & One) & F). unfold lsystem. rewrite E.
    exists (System u (map table_of ts)). split; [|easy]. split; [now destruct u|]. split; [now destruct ts|]. split.
    - intro T. rewrite T in One. cbn in *. rewrite map_length. now apply Nat.eqb_eq.
    - cbn. intros t x (rs & <- & I)%in_map_iff. rewrite forallb_forall in F. specialize (F rs I). apply andb_true_iff in F as (Fd & Fp).
      split; [unfold table_of; now destruct (map snd _)|]. split.
      + intros D v w Iv Iw. rewrite D in Fd. cbn in Fd. apply negb_true_iff in Fd.
        apply table_of_in in Iv as [Iv|(-> & Nv)], Iw as [Iw|(-> & Nw)]; auto; [|now apply Nw in Iv|now apply Nv in Iw].
        destruct (word_eq v w) as [|N]; auto. exfalso. enough (clash rs = true) by congruence. apply existsb_exists. exists (x, v). split; auto.
        apply existsb_exists. exists (x, w). split; auto. cbn [fst snd]. destruct (letter_eq x x) as [|M]; [|now destruct M]. destruct (word_eq v w); [now destruct N|reflexivity].
      + intros P I0. rewrite P in Fp. cbn in Fp. apply negb_true_iff in Fp. apply table_of_in in I0 as [I0|(? & _)]; [|easy].
        enough (erases rs = true) by congruence. apply existsb_exists. now exists (x, []).
  Qed.
  Definition after (ts : list (table A)) (w : word) : list word := flat_map (fun t => Extended.results t w) ts.
  Fixpoint derived (ts : list (table A)) (n : nat) (U : list word) : list word :=
    match n with 0 => U | S n => derived ts n (nodup word_eq (U ++ flat_map (after ts) U)) end.
  Lemma after_in ts w v : In v (after ts w) <-> exists t, In t ts /\ step t w v.
  Proof. unfold after. rewrite in_flat_map. split; intros (t & I & H); exists t; split; auto; now apply Extended.results_in. Qed.
  Lemma derived_right ts n U u : (forall w, In w U -> derives ts u w) -> forall w, In w (derived ts n U) -> derives ts u w.
  Proof.
    revert U. induction n as [|n IH]; cbn; intros U H; auto. apply IH. intros w [I|(v & I & (t & It & S)%after_in)%in_flat_map]%nodup_In%in_app_or; auto.
    exact (derives_step _ _ v w t (H v I) It S).
  Qed.
  Definition generates_values (ts : list (table A)) (u : word) (K : list word) : bool :=
    member u K && forallb (fun w => subset (after ts w) K) K && subset K (derived ts (length K) [u]).
  Lemma generates_values_right ts u K : generates_values ts u K = true -> same (derives ts u) (fun w => In w K).
  Proof.
    unfold generates_values. rewrite !andb_true_iff, forallb_forall, !subset_right, member_in. intros ((Iu & F) & D) w. split.
    - induction 1 as [|v w t H IH I S]; auto. specialize (F v IH). rewrite subset_right in F. apply F, after_in. eauto.
    - intro I. apply (derived_right ts (length K) [u] u); auto. intros v [<-|[]]. constructor.
  Qed.

  (* ---- statements ---- *)
  Inductive statement :=
  | Is_not (k : kind) (e : expression)                 (* no system of this kind generates the language *)
  | Has_form (k : kind) (ts : list (list (A * word))) (u : word)                       (* L(G) is of the kind *)
  | Is (k : kind) (e : expression) (ts : list (list (A * word))) (u : word)             (* this system generates it *)
  | Equal (e f : expression) | Not_equal (e f : expression)
  | Included (e f : expression) | Not_included (e f : expression)
  | Member (w : word) (e : expression) | Not_member (w : word) (e : expression)
  | Derives (ts : list (list (A * word))) (u : word) (n : nat) (w : word) (steps : list word)
  | Generates (ts : list (list (A * word))) (u : word) (terminals : list A) (w : word) (steps : list word).
  Definition meaning (s : statement) : Prop :=
    match s with
    | Is_not k e => ~ lsystem k (denotes e)
    | Has_form k ts u => lsystem k (derives (map table_of ts) u)
    | Is k e _ _ => lsystem k (denotes e)
    | Equal e f => same (denotes e) (denotes f)
    | Not_equal e f => ~ same (denotes e) (denotes f)
    | Included e f => forall w, denotes e w -> denotes f w
    | Not_included e f => ~ forall w, denotes e w -> denotes f w
    | Member w e => denotes e w
    | Not_member w e => ~ denotes e w
    | Derives ts u n w _ => derives_in (map table_of ts) n u w
    | Generates ts u terminals w _ => derives (map table_of ts) u w /\ incl w terminals
    end.
  Definition check (fuel : nat) (s : statement) : bool :=
    match s with
    | Is_not k e => let K := nodup word_eq (value e) in negb (extended k) &&
        (if tabled k then excluded (deterministic k) (propagating k) K fuel else excluded_one (deterministic k) (propagating k) K fuel)
    | Has_form k ts u => has_form k ts u
    | Is k e ts u => has_form k ts u && generates_values (map table_of ts) u (nodup word_eq (value e))
    | Equal e f => subset (value e) (value f) && subset (value f) (value e)
    | Not_equal e f => negb (subset (value e) (value f) && subset (value f) (value e))
    | Included e f => subset (value e) (value f)
    | Not_included e f => negb (subset (value e) (value f))
    | Member w e => member w (value e)
    | Not_member w e => negb (member w (value e))
    | Derives ts u n w steps => is_derivation (map table_of ts) n u steps w
    | Generates ts u terminals w steps => is_derivation (map table_of ts) (length steps) u steps w &&
        forallb (fun x => if in_dec letter_eq x terminals then true else false) w
    end.
  Lemma equal_values e f : subset (value e) (value f) && subset (value f) (value e) = true <-> same (denotes e) (denotes f).
  Proof.
    rewrite andb_true_iff, !subset_right. setoid_rewrite value_right. split; [intros (H & H') w; split; auto|].
    intro S. split; intros w; apply S.
  Qed.
  Theorem check_right fuel s : check fuel s = true -> meaning s.
  Proof.
    destruct s as [k e|k ts u|k e ts u|e f|e f|e f|e f|w e|w e|ts u n w steps|ts u terminals w steps]; cbn [check meaning]; intro H.
    - apply andb_true_iff in H as (E%negb_true_iff & H). assert (Q : same (fun w => In w (nodup word_eq (value e))) (denotes e)).
      { intro w. rewrite nodup_In. apply value_right. }
      intro B. apply (is_same (LSystem k) (denotes e) (fun w => In w (nodup word_eq (value e)))) in B; [|intro w; symmetry; apply Q].
      revert B. cbn [is]. destruct (tabled k) eqn:T; [now apply (excluded_right (deterministic k) (propagating k) _ fuel)|
        now apply (excluded_one_right (deterministic k) (propagating k) _ fuel)].
    - now apply has_form_right.
    - apply andb_true_iff in H as (F & H). apply generates_values_right in H. apply has_form_right in F.
      apply (is_same (LSystem k) _ (denotes e)) in F; [exact F|]. intro w. now rewrite (H w), nodup_In, value_right.
    - now apply equal_values.
    - apply negb_true_iff in H. intros S%equal_values. congruence.
    - intros w. rewrite <- !value_right. now apply subset_right.
    - apply negb_true_iff in H. intro I. enough (subset (value e) (value f) = true) by congruence. apply subset_right. intros w. rewrite !value_right. apply I.
    - now apply value_right, member_in.
    - apply negb_true_iff, member_out in H. now rewrite <- value_right.
    - eapply is_derivation_right; eauto.
    - apply andb_true_iff in H as (H & F). split; [eapply derives_in_derives, is_derivation_right; eauto|].
      rewrite forallb_forall in F. intros x I. specialize (F x I). now destruct in_dec.
  Qed.
End Statements.
Arguments expression A : clear implicits.
Arguments statement A : clear implicits.

(* ---- letters are numbers below the size of an alphabet ---- *)
Definition below (n : nat) : Set := {i : nat | (i <? n) = true}.
Definition below_eq {n : nat} (x y : below n) : {x = y} + {x <> y}.
Proof.
  destruct x as (i & I), y as (j & J). destruct (Nat.eq_dec i j) as [<-|N].
  - left. now rewrite (Eqdep_dec.UIP_dec bool_dec I J).
  - right. intro Q. apply N. now apply (f_equal (@proj1_sig _ _)) in Q.
Defined.
Definition number {n : nat} (i : nat) : option (below n) :=
  match bool_dec (i <? n) true with left H => Some (exist _ i H) | right _ => None end.
Fixpoint numbers {n : nat} (i : nat) : list (below n) :=
  match i with 0 => [] | S i => match number i with Some x => x :: numbers i | None => numbers i end end.
#[export] Instance below_alphabet (n : nat) : Alphabet (below n).
Proof.
  refine {| letter_eq := below_eq; letters := numbers n |}. intros (i & I). assert (L : i < n) by now apply Nat.ltb_lt.
  assert (Q : forall m, i < m -> In (exist _ i I : below n) (numbers m)).
  { induction m as [|m IH]; [lia|]. intro Lm. cbn. destruct (Nat.eq_dec i m) as [<-|N].
    - unfold number. destruct bool_dec as [J|J]; [|congruence]. left. now rewrite (Eqdep_dec.UIP_dec bool_dec I J).
    - destruct (number m); [right|]; apply IH; lia. }
  now apply Q.
Defined.
Definition check_numbers (size : nat) : nat -> statement (below size) -> bool := @check (below size) (below_alphabet size).
Theorem check_numbers_right size fuel s : check_numbers size fuel s = true -> meaning s.
Proof. apply check_right. Qed.
