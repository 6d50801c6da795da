(* A checker of statements, with the proof that what it accepts is true.  It is extracted to OCaml for verify.ml, which
   reads certificates.  Covered are statements on the words of a language that is made by operations from finite languages and
   from languages of systems, that a finite language is in no family without nonterminals of some kind, derivations, and
   the cells of the table of closure. *)
From Algae Require Import Words Obstruction Extended Table.

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

  (* ---- answers: true, false or not known ---- *)
  Definition says (P : Prop) (o : option bool) : Prop := match o with Some true => P | Some false => ~ P | None => True end.
  Definition either (o p : option bool) : option bool := match o, p with Some true, _ | _, Some true => Some true | Some false, Some false => Some false | _, _ => None end.
  Definition neither (o : option bool) : option bool := option_map negb o.
  Fixpoint some_of {X : Type} (f : X -> option bool) (l : list X) : option bool :=
    match l with [] => Some false | x :: l => match f x with Some true => Some true | o => either o (some_of f l) end end.
  (* the second question is asked only if the first is not answered by no *)
  Definition also (o : option bool) (p : unit -> option bool) : option bool :=
    match o with Some false => Some false | _ => neither (either (neither o) (neither (p tt))) end.
  Lemma says_true P o : says P o -> o = Some true -> P.
  Proof. now intros H ->. Qed.
  Lemma says_false P o : says P o -> o = Some false -> ~ P.
  Proof. now intros H ->. Qed.
  Lemma says_same P Q o : (P <-> Q) -> says P o -> says Q o.
  Proof. destruct o as [[]|]; cbn; tauto. Qed.
  Lemma says_bool P (x : bool) : (x = true <-> P) -> says P (Some x).
  Proof. destruct x; cbn; intuition congruence. Qed.
  Lemma says_either P Q o p : says P o -> says Q p -> says (P \/ Q) (either o p).
  Proof. destruct o as [[]|], p as [[]|]; cbn; tauto. Qed.
  Lemma says_neither P o : says P o -> says (~ P) (neither o).
  Proof. destruct o as [[]|]; cbn; tauto. Qed.
  Lemma says_also P Q o p : says P o -> says Q (p tt) -> says (P /\ Q) (also o p).
  Proof. destruct o as [[]|]; cbn; try tauto; destruct (p tt) as [[]|]; cbn; tauto. Qed.
  Lemma says_some {X : Type} (P : X -> Prop) f l : (forall x, In x l -> says (P x) (f x)) -> says (exists x, In x l /\ P x) (some_of f l).
  Proof.
    induction l as [|x l IH]; cbn; intro H; [now intros (x & [] & _)|]. assert (K : says (P x) (f x)) by (apply H; now left).
    assert (R : says (exists x, In x l /\ P x) (some_of f l)) by (apply IH; intros; apply H; now right).
    assert (Q : says (exists y, (x = y \/ In y l) /\ P y) (either (f x) (some_of f l))).
    { apply (says_same (P x \/ exists y, In y l /\ P y)); [|now apply says_either]. split.
      - intros [Px|(y & I & Py)]; [exists x|exists y]; auto.
      - intros (y & [<-|I] & Py); [now left|right; eauto]. }
    destruct (f x) as [[]|]; auto.
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

  (* ---- the words of a system: its tables are lists of rules ---- *)
  Variables fuel bound : nat.      (* of steps and of words that are looked at; of the length of words in a finite language *)
  Notation rules := (list (A * word)).
  Lemma not_erasing rs u v : erases rs = false -> step (table_of rs) u v -> length u <= length v.
  Proof.
    intros E S. induction S as [|x s u v I S IH]; cbn; [lia|]. rewrite app_length. enough (s <> []) by (destruct s; cbn; [easy|lia]).
    intros ->. apply table_of_in in I as [I|(Q & _)]; [|easy]. enough (erases rs = true) by congruence. apply existsb_exists. now exists (x, []).
  Qed.
  (* the words of at most b letters that a step leads to, and the greatest length of one *)
  Fixpoint short_results (b : nat) (t : table A) (u : word) : list word :=
    match u with
    | [] => [[]]
    | x :: u => flat_map (fun s => if length s <=? b then map (app s) (short_results (b - length s) t u) else []) (t x)
    end.
  Lemma short_results_in b t u v : In v (short_results b t u) <-> step t u v /\ length v <= b.
  Proof.
    unfold step. revert b v. induction u as [|x u IH]; cbn; intros b v.
    - rewrite parallel_empty. split; [intros [<-|[]]; split; [auto|cbn; lia]|intros (-> & _); now left].
    - rewrite parallel_first, in_flat_map. split.
      + intros (s & I & J). destruct (Nat.leb_spec (length s) b); [|easy]. apply in_map_iff in J as (v' & <- & (K & L)%IH).
        rewrite app_length. split; [eauto 6|lia].
      + intros ((s & v' & -> & I & K) & L). rewrite app_length in L. exists s. split; auto. destruct (Nat.leb_spec (length s) b); [|lia].
        apply in_map, IH. split; auto. lia.
  Qed.
  Fixpoint greatest (l : list word) : nat := match l with [] => 0 | s :: l => max (length s) (greatest l) end.
  Definition longest_result (t : table A) (u : word) : nat := fold_right (fun x n => greatest (t x) + n) 0 u.
  Lemma longest_result_right t u v : step t u v -> length v <= longest_result t u.
  Proof.
    induction 1 as [|x s u v I S IH]; cbn; [lia|]. rewrite app_length. enough (length s <= greatest (t x)) by (unfold longest_result in IH; lia).
    clear - I. induction (t x) as [|s' l IH]; [easy|]. cbn. destruct I as [->|I]; [lia|]. specialize (IH I). lia.
  Qed.
  Definition short_after (b : nat) (ts : list rules) (u : word) : list word := flat_map (fun rs => short_results b (table_of rs) u) ts.
  Lemma short_after_in b ts u v : In v (short_after b ts u) <-> (exists t, In t (map table_of ts) /\ step t u v) /\ length v <= b.
  Proof.
    unfold short_after. rewrite in_flat_map. split.
    - intros (rs & I & (S & L)%short_results_in). split; auto. exists (table_of rs). split; auto. now apply in_map.
    - intros ((t & (rs & <- & I)%in_map_iff & S) & L). exists rs. split; auto. now apply short_results_in.
  Qed.
  Fixpoint explored (b : nat) (ts : list rules) (n : nat) (found fresh : list word) : list word :=
    match n with
    | 0 => found
    | S n =>
      match filter (fun v => negb (member v found)) (nodup word_eq (flat_map (short_after b ts) fresh)) with
      | [] => found
      | vs => if fuel <? length found then found else explored b ts n (vs ++ found) vs
      end
    end.
  Lemma explored_right b ts n found fresh u : (forall w, In w found -> derives (map table_of ts) u w) ->
    (forall w, In w fresh -> derives (map table_of ts) u w) -> forall w, In w (explored b ts n found fresh) -> derives (map table_of ts) u w.
  Proof.
    revert found fresh. induction n as [|n IH]; cbn [explored]; intros found fresh F G; auto.
    assert (H : forall w, In w (filter (fun v => negb (member v found)) (nodup word_eq (flat_map (short_after b ts) fresh))) -> derives (map table_of ts) u w).
    { intros w ((v & I & ((t & It & S) & _)%short_after_in)%nodup_In%in_flat_map & _)%filter_In. exact (derives_step _ _ v w t (G v I) It S). }
    destruct (filter _ _) as [|v vs]; auto. destruct (fuel <? length found); auto. apply IH; auto. intros w [I|I]%in_app_or; auto.
  Qed.
  (* every step from a word of U leads to a word of U, or, if no letter is erased, to one of more than b letters *)
  Definition complete (b : nat) (ts : list rules) (U : list word) : bool :=
    forallb (fun u => subset (short_after b ts u) U) U &&
    (forallb (fun rs => negb (erases rs)) ts || forallb (fun u => forallb (fun rs => longest_result (table_of rs) u <=? b) ts) U).
  Lemma complete_right b ts U u : complete b ts U = true -> In u U -> forall w, derives (map table_of ts) u w -> length w <= b -> In w U.
  Proof.
    unfold complete. rewrite andb_true_iff, orb_true_iff, !forallb_forall. intros (C & [E|L]) I w D.
    - induction D as [|v w t D IH It S]; auto. intro Lw. apply in_map_iff in It as It'. destruct It' as (rs & <- & Ir).
      specialize (E rs Ir). apply negb_true_iff in E. pose proof (not_erasing _ _ _ E S). assert (J : In v U) by (apply IH; lia).
      specialize (C v J). rewrite subset_right in C. apply C, short_after_in. split; eauto.
    - intros _. induction D as [|v w t D IH It S]; auto. apply in_map_iff in It as It'. destruct It' as (rs & <- & Ir).
      specialize (L v IH). rewrite forallb_forall in L. specialize (L rs Ir). apply Nat.leb_le in L. pose proof (longest_result_right _ _ _ S).
      specialize (C v IH). rewrite subset_right in C. apply C, short_after_in. split; [eauto|lia].
  Qed.
  Definition within (ls : list A) (w : word) : bool := forallb (fun x => if in_dec letter_eq x ls then true else false) w.
  Lemma within_right ls w : within ls w = true <-> incl w ls.
  Proof. unfold within. rewrite forallb_forall. split; intros H x I; specialize (H x I); now destruct in_dec. Qed.
  Definition generated_has (ts : list rules) (u : word) (ls : list A) (w : word) : option bool :=
    if within ls w then
      let b := length w + (if forallb (fun rs => negb (erases rs)) ts then 0 else 6) in
      let U := explored b ts fuel [u] [u] in
      if member w U then Some true else if complete b ts U then Some false else None
    else Some false.
  Lemma generated_has_right ts u ls w : says (derives (map table_of ts) u w /\ incl w ls) (generated_has ts u ls w).
  Proof.
    unfold generated_has. destruct (within ls w) eqn:W; [|intros (_ & H%within_right); congruence]. apply within_right in W. cbv zeta.
    set (b := length w + _). set (U := explored b ts fuel [u] [u]). destruct (member w U) eqn:M.
    - split; auto. apply member_in in M. revert M. unfold U. now apply explored_right; intros v [<-|[]]; constructor.
    - destruct (complete b ts U) eqn:C; [|exact I]. intros (D & _). apply member_out in M. apply M.
      assert (F : forall n found fresh, In u found -> In u (explored b ts n found fresh)).
      { induction n as [|n IH]; cbn [explored]; intros found fresh J; auto. destruct (filter _ _) as [|v vs]; auto. destruct (fuel <? _); auto.
        apply IH, in_or_app. now right. }
      apply (complete_right b ts U u C); auto; [apply F; now left|]. unfold b. lia.
  Qed.
  Definition generated_value (ts : list rules) (u : word) (ls : list A) : option (list word) :=
    let U := explored bound ts fuel [u] [u] in
    if forallb (fun v => member v U) [u] && forallb (fun v => forallb (fun rs => longest_result (table_of rs) v <=? bound) ts) U && complete bound ts U
    then Some (filter (within ls) U) else None.
  Lemma generated_value_right ts u ls K : generated_value ts u ls = Some K -> forall w, In w K <-> derives (map table_of ts) u w /\ incl w ls.
  Proof.
    unfold generated_value. set (U := explored bound ts fuel [u] [u]). destruct (_ && _) eqn:C; [|easy]. intros [= <-] w.
    rewrite !andb_true_iff in C. destruct C as ((Iu & L) & C). cbn in Iu. rewrite andb_true_r, member_in in Iu.
    rewrite filter_In, within_right. enough (In w U <-> derives (map table_of ts) u w) by tauto. split.
    - unfold U. now apply explored_right; intros v [<-|[]]; constructor.
    - intro D. enough (In w U /\ (w = u \/ length w <= bound)) by tauto. unfold complete in C. rewrite andb_true_iff in C. destruct C as (C & _).
      rewrite forallb_forall in C, L. induction D as [|v w t D IH It S]; auto. destruct IH as (Iv & _). apply in_map_iff in It as It'. destruct It' as (rs & <- & Ir).
      specialize (L v Iv). rewrite forallb_forall in L. specialize (L rs Ir). apply Nat.leb_le in L. pose proof (longest_result_right _ _ _ S).
      specialize (C v Iv). rewrite subset_right in C. split; [|right; lia]. apply C, short_after_in. split; [eauto|lia].
  Qed.

  (* ---- homomorphisms on some letters ---- *)
  Definition rule_of (h : rules) (x : A) : option (A * word) := find (fun r => if letter_eq (fst r) x then true else false) h.
  (* the image of a word all of whose letters have one *)
  Fixpoint image_of (h : rules) (u : word) : option word :=
    match u with
    | [] => Some []
    | x :: u => match rule_of h x, image_of h u with Some r, Some v => Some (snd r ++ v) | _, _ => None end
    end.
  Fixpoint preimages (h : rules) (n : nat) (v : word) : list word :=
    match n, v with
    | _, [] => [[]]
    | 0, _ => []
    | S n, _ => flat_map (fun x => match rule_of h x with
        | Some r => match behind (snd r) v with Some v' => map (cons x) (preimages h n v') | None => [] end
        | None => [] end) letters
    end.
  Lemma behind_append u v : behind u (u ++ v) = Some v.
  Proof. induction u as [|x u IH]; cbn; [now destruct v|]. now destruct (letter_eq x x). Qed.
  Lemma preimages_in h n v w : erases h = false -> length v <= n -> In w (preimages h n v) <-> image_of h w = Some v.
  Proof.
    intro E. assert (N : forall x r, rule_of h x = Some r -> snd r <> []).
    { intros x r (I & _)%find_some Q. enough (erases h = true) by congruence. apply existsb_exists. exists r. split; auto. now rewrite Q. }
    revert v w. induction n as [|n IH]; intros v w L; (destruct v as [|y v]; [split; [intros [<-|[]]; reflexivity|];
      destruct w as [|x w]; cbn; auto; destruct (rule_of h x) as [r|] eqn:R; [|easy]; destruct (image_of h w); [|easy];
      intros [= (Q & _)%app_eq_nil]; now apply N in R|]); [cbn in L; lia|].
    cbn [preimages]. rewrite in_flat_map. split.
    - intros (x & _ & I). destruct (rule_of h x) as [r|] eqn:R; [|easy]. destruct (behind (snd r) (y :: v)) as [v'|] eqn:B; [|easy].
      apply behind_right in B. apply in_map_iff in I as (w' & <- & I). apply IH in I; [cbn; now rewrite R, I, B|].
      pose proof (N x r R). apply (f_equal (@length A)) in B. rewrite app_length in B. cbn in B, L. destruct (snd r); [easy|]. cbn in B. lia.
    - destruct w as [|x w]; [easy|]. cbn. destruct (rule_of h x) as [r|] eqn:R; [|easy]. destruct (image_of h w) as [v'|] eqn:Q; [|easy]. intros [= B].
      exists x. split; [apply all_letters|]. rewrite R, <- B, behind_append. apply in_map. apply IH; auto.
      pose proof (N x r R). apply (f_equal (@length A)) in B. rewrite app_length in B. cbn in B, L. destruct (snd r); [easy|]. cbn in B. lia.
  Qed.

  (* ---- languages ---- *)
  Inductive expression :=
  | Words (ws : list word) | United (e f : expression) | Intersected (e f : expression) | Difference (e f : expression)
  | Product (e f : expression) | Starred (e : expression) | Complemented (ls : list A) (e : expression) | Reversed (e : expression)
  | Imaged (h : rules) (e : expression) | Inverse (h : rules) (e : expression) | Generated (ts : list rules) (u : word) (terminals : list A).
  Fixpoint denotes (e : expression) : language A :=
    match e with
    | Words ws => fun w => In w ws
    | United e f => union (denotes e) (denotes f)
    | Intersected e f => intersection (denotes e) (denotes f)
    | Difference e f => intersection (denotes e) (complement (denotes f))
    | Product e f => concatenation (denotes e) (denotes f)
    | Starred e => star (denotes e)
    | Complemented ls e => fun w => incl w ls /\ ~ denotes e w
    | Reversed e => reversal (denotes e)
    | Imaged h e => fun w => exists u, denotes e u /\ image_of h u = Some w
    | Inverse h e => fun w => exists v, image_of h w = Some v /\ denotes e v
    | Generated ts u ls => fun w => derives (map table_of ts) u w /\ incl w ls
    end.
  Fixpoint all_such {X : Type} (f : X -> option bool) (l : list X) : option (list X) :=
    match l with
    | [] => Some []
    | x :: l => match f x, all_such f l with Some b, Some k => Some (if b then x :: k else k) | _, _ => None end
    end.
  Lemma all_such_right {X : Type} (P : X -> Prop) f l k : (forall x, says (P x) (f x)) -> all_such f l = Some k -> forall x, In x k <-> In x l /\ P x.
  Proof.
    intro H. revert k. induction l as [|y l IH]; cbn; intros k Q x; [injection Q as <-; cbn; tauto|]. specialize (H y).
    destruct (f y) as [c|]; [|easy]. destruct (all_such f l) as [k'|]; [|now destruct c]. specialize (IH k' eq_refl x).
    destruct c; cbn in *; inversion Q; subst k; cbn; rewrite IH; intuition congruence.
  Qed.
  Definition cuts (w : word) : list (word * word) := map (fun i => (firstn i w, skipn i w)) (seq 0 (S (length w))).
  Lemma cuts_in w u v : In (u, v) (cuts w) <-> w = u ++ v.
  Proof.
    unfold cuts. rewrite in_map_iff. split.
    - intros (i & [= <- <-] & _). symmetry. apply firstn_skipn.
    - intros ->. exists (length u). rewrite firstn_app, firstn_all, Nat.sub_diag, app_nil_r, skipn_app, skipn_all, Nat.sub_diag. split; auto.
      apply in_seq. rewrite app_length. lia.
  Qed.
  Fixpoint star_has (has : word -> option bool) (n : nat) (w : word) : option bool :=
    match w, n with
    | [], _ => Some true
    | _, 0 => None
    | _, S n => some_of (fun c => match fst c with [] => Some false | u => also (has u) (fun _ => star_has has n (snd c)) end) (cuts w)
    end.
  Lemma star_has_right (X : language A) has n w : (forall u, says (X u) (has u)) -> says (star X w) (star_has has n w).
  Proof.
    intro H. revert w. induction n as [|n IH]; intros [|x w]; try exact I; try (exists []; easy). cbn [star_has].
    eapply says_same; [|apply says_some with (P := fun c => fst c <> [] /\ X (fst c) /\ star X (snd c))].
    - split.
      + intros ((u, v) & Q%cuts_in & _ & Xu & us & E & F). cbn in *. subst v. exists (u :: us). split; auto. intros z [<-|J]; auto.
      + intros (us & Q & F). assert (G : forall us, x :: w = concat us -> (forall u, In u us -> X u) ->
          exists c, In c (cuts (x :: w)) /\ fst c <> [] /\ X (fst c) /\ star X (snd c)).
        { clear. induction us as [|[|y u] us IH]; intros Q F; [easy|apply IH; auto; intros z J; apply F; now right|].
          exists (y :: u, concat us). split; [now apply cuts_in|]. split; [easy|]. split; [apply F; now left|]. exists us. split; auto.
          intros z J. apply F. now right. }
        now apply (G us).
    - intros ([|y u], v) _; cbn [fst snd]; [intros (N & _); now apply N|]. eapply says_same; [|apply says_also; [apply H|apply IH]]. intuition easy.
  Qed.
  Definition some_list {X Y : Type} (f : X -> Y) (o : option X) : option Y := match o with Some x => Some (f x) | None => None end.

  (* [value]: all words; [has]: whether a word is in the language; [None] if it is not found out *)
  Fixpoint value (e : expression) {struct e} : option (list word) :=
    match e with
    | Words ws => Some ws
    | United e f => match value e, value f with Some E, Some F => Some (E ++ F) | _, _ => None end
    | Intersected e f =>
      match value e with
      | Some E => all_such (has f) E
      | None => match value f with Some F => all_such (has e) F | None => None end
      end
    | Difference e f => match value e with Some E => all_such (fun w => neither (has f w)) E | None => None end
    | Product e f => match value e, value f with Some E, Some F => Some (flat_map (fun u => map (app u) F) E) | _, _ => None end
    | Starred e => match value e with Some E => if forallb (fun w => match w with [] => true | _ => false end) E then Some [[]] else None | None => None end
    | Complemented ls e => None
    | Reversed e => some_list (map (@rev A)) (value e)
    | Imaged h e => some_list (flat_map (fun u => match image_of h u with Some v => [v] | None => [] end)) (value e)
    | Inverse h e => if erases h then None else some_list (flat_map (fun v => preimages h (length v) v)) (value e)
    | Generated ts u ls => generated_value ts u ls
    end
  with has (e : expression) (w : word) {struct e} : option bool :=
    match e with
    | Words ws => Some (member w ws)
    | United e f => either (has e w) (has f w)
    | Intersected e f => also (has e w) (fun _ => has f w)
    | Difference e f => also (has e w) (fun _ => neither (has f w))
    | Product e f => some_of (fun c => also (has e (fst c)) (fun _ => has f (snd c))) (cuts w)
    | Starred e => star_has (has e) (length w) w
    | Complemented ls e => also (Some (within ls w)) (fun _ => neither (has e w))
    | Reversed e => has e (rev w)
    | Imaged h e =>
      if erases h then some_list (fun E => existsb (fun u => match image_of h u with Some v => if word_eq v w then true else false | None => false end) E) (value e)
      else some_of (has e) (preimages h (length w) w)
    | Inverse h e => match image_of h w with Some v => has e v | None => Some false end
    | Generated ts u ls => generated_has ts u ls w
    end.
  Lemma language_right e : (forall K, value e = Some K -> forall w, In w K <-> denotes e w) /\ (forall w, says (denotes e w) (has e w)).
  Proof.
    induction e as [ws|e (Ve & He) f (Vf & Hf)|e (Ve & He) f (Vf & Hf)|e (Ve & He) f (Vf & Hf)|e (Ve & He) f (Vf & Hf)|e (Ve & He)|ls e (Ve & He)|e (Ve & He)|
      h e (Ve & He)|h e (Ve & He)|ts u ls]; split; cbn [value has denotes].
    - now intros K [= <-] w.
    - intro w. apply says_bool, member_in.
    - intros K Q w. destruct (value e) as [E|]; [|easy]. destruct (value f) as [F|]; [|easy]. injection Q as <-.
      rewrite in_app_iff, (Ve E), (Vf F); easy.
    - intro w. apply says_either; auto.
    - intros K Q w. unfold intersection. destruct (value e) as [E|].
      + rewrite (all_such_right _ _ _ _ Hf Q), (Ve E); easy.
      + destruct (value f) as [F|]; [|easy]. rewrite (all_such_right _ _ _ _ He Q), (Vf F); easy.
    - intro w. apply says_also; auto.
    - intros K Q w. unfold intersection, complement. destruct (value e) as [E|]; [|easy].
      rewrite (all_such_right (fun w => ~ denotes f w) _ _ _ (fun w => says_neither _ _ (Hf w)) Q), (Ve E); easy.
    - intro w. apply says_also; [auto|now apply says_neither].
    - intros K Q w. unfold concatenation. destruct (value e) as [E|]; [|easy]. destruct (value f) as [F|]; [|easy]. injection Q as <-.
      rewrite in_flat_map. split.
      + intros (u & Iu & (v & <- & Iv)%in_map_iff). exists u, v. split; auto. split; [now apply (Ve E)|now apply (Vf F)].
      + intros (u & v & -> & Hu & Hv). exists u. split; [now apply (Ve E)|]. apply in_map. now apply (Vf F).
    - intro w. eapply says_same; [|apply says_some with (P := fun c => denotes e (fst c) /\ denotes f (snd c)); intros c _; apply says_also; auto].
      unfold concatenation. split; [intros ((u & v) & I%cuts_in & H1 & H2); exists u, v; auto|intros (u & v & I & H1 & H2); exists (u, v); split; [now apply cuts_in|auto]].
    - intros K Q w. destruct (value e) as [E|]; [|easy]. destruct (forallb _ E) eqn:F; [|easy]. injection Q as <-. rewrite forallb_forall in F. split.
      + intros [<-|[]]. exists []. easy.
      + intros (us & -> & G). left. induction us as [|u us IH]; auto. cbn. rewrite <- IH by (intros; apply G; now right).
        assert (J : In u E) by (apply (Ve E); auto; apply G; now left). specialize (F u J). now destruct u.
    - intro w. apply star_has_right, He.
    - easy.
    - intro w. apply says_also; [apply says_bool, within_right|now apply says_neither].
    - intros K Q w. destruct (value e) as [E|]; [|easy]. injection Q as <-. unfold reversal. rewrite in_map_iff, <- (Ve E) by easy.
      split; [intros (u & <- & I); now rewrite rev_involutive|]. intro I. exists (rev w). now rewrite rev_involutive.
    - intro w. apply He.
    - intros K Q w. destruct (value e) as [E|]; [|easy]. injection Q as <-. rewrite in_flat_map. split.
      + intros (u & I & J). exists u. destruct (image_of h u); [|easy]. destruct J as [<-|[]]. split; auto. now apply (Ve E).
      + intros (u & Hu & Q). exists u. split; [now apply (Ve E)|]. rewrite Q. now left.
    - intro w. destruct (erases h) eqn:Er.
      + destruct (value e) as [E|]; [|exact I]. apply says_bool. rewrite existsb_exists. split.
        * intros (u & I & J). exists u. destruct (image_of h u) as [v|]; [|easy]. destruct (word_eq v w) as [->|]; [|easy]. split; auto. now apply (Ve E).
        * intros (u & Hu & Q). exists u. rewrite Q. split; [now apply (Ve E)|]. now destruct (word_eq w w).
      + eapply says_same; [|apply says_some with (P := denotes e); auto]. split; intros (u & H1 & H2); exists u; (split; [|auto]); auto; now apply (preimages_in h (length w) w u Er).
    - intros K Q w. destruct (erases h) eqn:Er; [easy|]. destruct (value e) as [E|]; [|easy]. injection Q as <-. rewrite in_flat_map. split.
      + intros (v & I & J). exists v. split; [now apply (preimages_in h (length v) v w Er)|now apply (Ve E)].
      + intros (v & I & J). exists v. split; [now apply (Ve E)|now apply (preimages_in h (length v) v w Er)].
    - intro w. destruct (image_of h w) as [v|]; [|now intros (v & ? & _)]. apply (says_same (denotes e v)); auto.
      split; [intro H; now exists v|now intros (v' & [= <-] & H)].
    - intros K Q w. now apply generated_value_right.
    - intro w. apply generated_has_right.
  Qed.
  Lemma value_right e K : value e = Some K -> forall w, In w K <-> denotes e w.
  Proof. apply language_right. Qed.
  Lemma has_right e w : says (denotes e w) (has e w).
  Proof. apply language_right. Qed.

  (* ---- words that are not derived in n steps ---- *)
  Definition none_erases (ts : list rules) : bool := forallb (fun rs => negb (erases rs)) ts.
  Definition next_words (ts : list rules) (b : nat) (u : word) : list word :=
    if none_erases ts then short_after b ts u else after (map table_of ts) u.
  Fixpoint exactly (ts : list rules) (b n : nat) (U : list word) : list word :=
    match n with 0 => U | S n => exactly ts b n (nodup word_eq (flat_map (next_words ts b) U)) end.
  Lemma derives_in_grows ts n u w : none_erases ts = true -> derives_in (map table_of ts) n u w -> length u <= length w.
  Proof.
    unfold none_erases. rewrite forallb_forall. intro E. revert u. induction n as [|n IH]; cbn; intro u; [now intros ->|].
    intros (t & v & (rs & <- & I)%in_map_iff & S & D). specialize (E rs I). apply negb_true_iff in E. pose proof (not_erasing _ _ _ E S). specialize (IH v D). lia.
  Qed.
  Lemma exactly_right ts n U u w : In u U -> derives_in (map table_of ts) n u w -> In w (exactly ts (length w) n U).
  Proof.
    revert U u. induction n as [|n IH]; cbn; intros U u I; [now intros <-|]. intros (t & v & It & S & D). apply (IH _ v); auto.
    apply nodup_In, in_flat_map. exists u. split; auto. unfold next_words. destruct (none_erases ts) eqn:E.
    - apply short_after_in. split; [eauto|]. now apply (derives_in_grows ts n).
    - apply after_in. eauto.
  Qed.

  (* ---- systems with contexts: the rules of the longest contexts that match are used, and a letter without one stays ---- *)
  Notation context_rule := (word * A * word * word)%type.      (* left context, letter, right context, successor *)
  Fixpoint begins (u v : word) : bool :=
    match u, v with
    | [], _ => true
    | x :: u, y :: v => if letter_eq x y then begins u v else false
    | _, [] => false
    end.
  Definition matches (p : word) (x : A) (q : word) (r : context_rule) : bool :=
    match r with (l, y, s, _) => (if letter_eq y x then true else false) && begins (rev l) p && begins s q end.
  Definition context_length (r : context_rule) : nat := match r with (l, _, s, _) => length l + length s end.
  Fixpoint best_rule (rs : list context_rule) : option context_rule :=        (* of equals the first *)
    match rs with
    | [] => None
    | r :: rs => match best_rule rs with
      | Some s => if context_length r <? context_length s then Some s else Some r
      | None => Some r end
    end.
  Definition alike (r s : context_rule) : bool :=
    match r, s with (l, _, q, _), (l', _, q', _) => (if word_eq l l' then true else false) && (if word_eq q q' then true else false) end.
  Definition with_contexts (u : word) (rs : list context_rule) : interactive A := Interactive u
    (fold_right (fun r n => max (length (fst (fst (fst r)))) n) 0 rs) (fold_right (fun r n => max (length (snd (fst r))) n) 0 rs)
    (fun p x q => let ms := filter (matches p x q) rs in
      match best_rule ms with
      | Some r => match map snd (filter (alike r) ms) with [] => [[x]] | us => us end
      | None => [[x]] end).
  Fixpoint is_context_step (G : interactive A) (p u v : word) : bool :=
    match u with
    | [] => match v with [] => true | _ => false end
    | x :: u => existsb (fun s => match behind s v with Some v => is_context_step G (x :: p) u v | None => false end)
        (successors G (firstn (left_width G) p) x (firstn (right_width G) u))
    end.
  Lemma is_context_step_right G p u v : is_context_step G p u v = true -> context_step G p u v.
  Proof.
    revert p v. induction u as [|x u IH]; intros p v; cbn; [destruct v; [constructor|easy]|]. intros (s & I & H)%existsb_exists.
    destruct (behind s v) as [v'|] eqn:Q; [|easy]. apply behind_right in Q as ->. constructor; auto.
  Qed.
  Fixpoint context_derives_in (G : interactive A) (n : nat) (u w : word) : Prop :=
    match n with 0 => u = w | S n => exists v, context_step G [] u v /\ context_derives_in G n v w end.
  Fixpoint is_context_derivation (G : interactive A) (n : nat) (u : word) (vs : list word) (w : word) : bool :=
    match n, vs with
    | 0, [] => if word_eq u w then true else false
    | S n, v :: vs => is_context_step G [] u v && is_context_derivation G n v vs w
    | _, _ => false
    end.
  Lemma is_context_derivation_right G n u vs w : is_context_derivation G n u vs w = true -> context_derives_in G n u w.
  Proof.
    revert u vs. induction n as [|n IH]; intros u [|v vs]; cbn; try easy; [now destruct word_eq|].
    intros (H & K)%andb_true_iff. exists v. split; [now apply is_context_step_right|eauto].
  Qed.
  Lemma with_contexts_right u rs : u <> [] -> interacting (context_generates (with_contexts u rs)).
  Proof. intro N. exists (with_contexts u rs). split; [easy|]. split; [|easy]. intros p x q. cbn. destruct (best_rule _); [|easy]. now destruct (map snd _). Qed.

  (* ---- statements ---- *)
  Inductive statement :=
  | Is_not (k : kind) (e : expression)                 (* no system of this kind generates the language *)
  | Has_form (k : kind) (ts : list rules) (u : word)                       (* L(G) is of the kind *)
  | Is (k : kind) (e : expression) (ts : list rules) (u : word)             (* this system generates it *)
  | Is_interacting (u : word) (rs : list context_rule)                      (* L(G) is IL *)
  | Equal (e f : expression) | Not_equal (e f : expression) (witnesses : list word)
  | Included (e f : expression) | Not_included (e f : expression) (witnesses : list word)
  | Member (w : word) (e : expression) | Not_member (w : word) (e : expression)
  | Number_of (e : expression) (n : nat) | Finite (e : expression) | Empty (e : expression) | Not_empty (e : expression) (witnesses : list word)
  | Derives (ts : list rules) (u : word) (n : nat) (w : word) (steps : list word) | Not_derives (ts : list rules) (u : word) (n : nat) (w : word)
  | Generates (ts : list rules) (u : word) (terminals : list A) (w : word) (steps : list word)
  | Context_derives (rs : list context_rule) (u : word) (n : nat) (w : word) (steps : list word)
  | Closed (o : operation) (f : family) | Not_closed (o : operation) (f : family).
  Definition meaning (s : statement) : Prop :=
    match s with
    | Is_not k e => ~ lsystem k (denotes e)
    | Has_form k ts u => lsystem k (derives (map table_of ts) u)
    | Is k e _ _ => lsystem k (denotes e)
    | Is_interacting u rs => interacting (context_generates (with_contexts u rs))
    | Equal e f => same (denotes e) (denotes f)
    | Not_equal e f _ => ~ same (denotes e) (denotes f)
    | Included e f => forall w, denotes e w -> denotes f w
    | Not_included e f _ => ~ forall w, denotes e w -> denotes f w
    | Member w e => denotes e w
    | Not_member w e => ~ denotes e w
    | Number_of e n => exists K, NoDup K /\ length K = n /\ same (denotes e) (fun w => In w K)
    | Finite e => exists K, same (denotes e) (fun w => In w K)
    | Empty e => forall w, ~ denotes e w
    | Not_empty e _ => exists w, denotes e w
    | Derives ts u n w _ => derives_in (map table_of ts) n u w
    | Not_derives ts u n w => ~ derives_in (map table_of ts) n u w
    | Generates ts u terminals w _ => derives (map table_of ts) u w /\ incl w terminals
    | Context_derives rs u n w _ => context_derives_in (with_contexts u rs) n u w
    | Closed o f => closed o f
    | Not_closed o f => ~ closed o f
    end.
  Definition knows (P : list word -> bool) (e : expression) : bool := match value e with Some K => P K | None => false end.
  Definition is_true (o : option bool) : bool := match o with Some true => true | _ => false end.
  Definition is_false (o : option bool) : bool := match o with Some false => true | _ => false end.
  Definition words_of (e : expression) : list word := match value e with Some K => K | None => [] end.
  Definition not_within (e f : expression) (ws : list word) : bool :=
    existsb (fun w => is_true (has e w) && is_false (has f w)) (ws ++ words_of e).
  Definition check (s : statement) : bool :=
    match s with
    | Is_not k e => knows (fun K => let K := nodup word_eq K in negb (extended k) &&
        (if tabled k then excluded (deterministic k) (propagating k) K fuel else excluded_one (deterministic k) (propagating k) K fuel)) e
    | Has_form k ts u => has_form k ts u
    | Is k e ts u => has_form k ts u && knows (fun K => generates_values (map table_of ts) u (nodup word_eq K)) e
    | Is_interacting u rs => match u with [] => false | _ => true end
    | Equal e f => knows (fun E => knows (fun F => subset E F && subset F E) f) e
    | Not_equal e f ws => not_within e f ws || not_within f e ws
    | Included e f => knows (forallb (fun w => is_true (has f w))) e
    | Not_included e f ws => not_within e f ws
    | Member w e => is_true (has e w)
    | Not_member w e => is_false (has e w)
    | Number_of e n => knows (fun K => length (nodup word_eq K) =? n) e
    | Finite e => knows (fun _ => true) e
    | Empty e => knows (fun K => match K with [] => true | _ => false end) e
    | Not_empty e ws => existsb (fun w => is_true (has e w)) (ws ++ words_of e)
    | Derives ts u n w steps => is_derivation (map table_of ts) n u steps w
    | Not_derives ts u n w => negb (member w (exactly ts (length w) n [u]))
    | Generates ts u terminals w steps => is_derivation (map table_of ts) (length steps) u steps w && within terminals w
    | Context_derives rs u n w steps => is_context_derivation (with_contexts u rs) n u steps w
    | Closed o f => match cell o f with Some (true, _) => true | _ => false end
    | Not_closed o f => match cell o f with Some (false, _) => true | _ => false end
    end.
  Lemma knows_right P e : knows P e = true -> exists K, (forall w, In w K <-> denotes e w) /\ P K = true.
  Proof. unfold knows. destruct (value e) as [K|] eqn:Q; [|easy]. intro H. exists K. split; auto. now apply value_right. Qed.
  Lemma is_true_right e w : is_true (has e w) = true -> denotes e w.
  Proof. pose proof (has_right e w) as H. now destruct (has e w) as [[]|]. Qed.
  Lemma is_false_right e w : is_false (has e w) = true -> ~ denotes e w.
  Proof. pose proof (has_right e w) as H. now destruct (has e w) as [[]|]. Qed.
  Lemma not_within_right e f ws : not_within e f ws = true -> exists w, denotes e w /\ ~ denotes f w.
  Proof.
    unfold not_within. rewrite existsb_exists. intros (w & _ & (H & K)%andb_true_iff). exists w. split; [now apply is_true_right|now apply is_false_right].
  Qed.
  Lemma lsystem_same k (X Y : language A) : same X Y -> lsystem k X -> lsystem k Y.
  Proof. apply (is_same (LSystem k)). Qed.
  Theorem check_right s : check s = true -> meaning s.
  Proof.
    destruct s as [k e|k ts u|k e ts u|u rs|e f|e f ws|e f|e f ws|w e|w e|e n|e|e|e ws|ts u n w steps|ts u n w|ts u terminals w steps|rs u n w steps|o f|o f];
      cbn [check meaning]; intro H.
    - apply knows_right in H as (K & S & H). apply andb_true_iff in H as (E%negb_true_iff & H). intro B.
      apply (lsystem_same k _ (fun w => In w (nodup word_eq K))) in B; [|intro w; now rewrite nodup_In, S].
      revert B. destruct (tabled k) eqn:T; [now apply (excluded_right (deterministic k) (propagating k) _ fuel)|
        now apply (excluded_one_right (deterministic k) (propagating k) _ fuel)].
    - now apply has_form_right.
    - apply andb_true_iff in H as (F & (K & S & H)%knows_right). apply generates_values_right in H. apply has_form_right in F.
      apply (lsystem_same k _ (denotes e)) in F; [exact F|]. intro w. now rewrite (H w), nodup_In, S.
    - apply with_contexts_right. now destruct u.
    - apply knows_right in H as (E & SE & (F & SF & (H1 & H2)%andb_true_iff)%knows_right). rewrite subset_right in H1, H2.
      intro w. rewrite <- SE, <- SF. split; auto.
    - intro S. apply orb_true_iff in H as [(w & H1 & H2)%not_within_right|(w & H1 & H2)%not_within_right]; apply H2; now apply S.
    - apply knows_right in H as (E & SE & H). rewrite forallb_forall in H. intros w I%SE. now apply is_true_right, H.
    - intro S. apply not_within_right in H as (w & H1 & H2). auto.
    - now apply is_true_right.
    - now apply is_false_right.
    - apply knows_right in H as (K & S & Q%Nat.eqb_eq). exists (nodup word_eq K). split; [apply NoDup_nodup|]. split; auto. intro w. now rewrite nodup_In, S.
    - apply knows_right in H as (K & S & _). exists K. intro w. now rewrite S.
    - apply knows_right in H as (K & S & Q). intros w I%S. now destruct K.
    - apply existsb_exists in H as (w & _ & H). exists w. now apply is_true_right.
    - eapply is_derivation_right; eauto.
    - apply negb_true_iff, member_out in H. intro D. apply H. apply (exactly_right ts n [u] u w); [now left|exact D].
    - apply andb_true_iff in H as (H & F%within_right). split; auto. eapply derives_in_derives, is_derivation_right; eauto.
    - eapply is_context_derivation_right; eauto.
    - destruct (cell o f) as [([|] & name)|] eqn:C; try easy. exact (table_is_right o f true name C).
    - destruct (cell o f) as [([|] & name)|] eqn:C; try easy. exact (table_is_right o f false name C).
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
Definition check_numbers (size : nat) : nat -> nat -> statement (below size) -> bool := @check (below size) (below_alphabet size).
Theorem check_numbers_right size fuel bound s : check_numbers size fuel bound s = true -> meaning s.
Proof. apply check_right. Qed.
