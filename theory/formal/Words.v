(* Lemmas about words that are rewritten in parallel, about derivations and about alphabets. *)
From Algae Require Export Spec.
Set Implicit Arguments.

(* ---- rewriting in parallel ---- *)
#[export] Hint Constructors parallel derives : core.
Section Parallel.
  Context {V W : Set}.
  Implicit Type R : V -> list W -> Prop.

  Lemma parallel_letter R x u : parallel R [x] u <-> R x u.
  Proof.
    split; intro H.
    - inversion H as [|? v ? w ? H']; subst. inversion H'; subst. now rewrite app_nil_r.
    - rewrite <- (app_nil_r u). auto.
  Qed.
  Lemma of_letter R x u : parallel R [x] u -> R x u.
  Proof. apply parallel_letter. Qed.
  Lemma parallel_empty R w : parallel R [] w <-> w = [].
  Proof. split; [now inversion 1|intros ->; auto]. Qed.
  Lemma parallel_first R x v w : parallel R (x :: v) w <-> exists u w', w = u ++ w' /\ R x u /\ parallel R v w'.
  Proof. split; [inversion 1; subst; eauto|intros (? & ? & -> & ? & ?); auto]. Qed.
  Lemma parallel_append R v1 w1 v2 w2 : parallel R v1 w1 -> parallel R v2 w2 -> parallel R (v1 ++ v2) (w1 ++ w2).
  Proof. induction 1; cbn; auto. rewrite <- app_assoc. auto. Qed.
  Lemma parallel_split R v1 v2 w : parallel R (v1 ++ v2) w ->
    exists w1 w2, w = w1 ++ w2 /\ parallel R v1 w1 /\ parallel R v2 w2.
  Proof.
    revert w. induction v1 as [|x v1 IH]; cbn; intros w H; [now exists [], w; auto|].
    apply parallel_first in H as (u & w' & -> & H & (w1 & w2 & -> & H1 & H2)%IH).
    exists (u ++ w1), w2. rewrite app_assoc. auto.
  Qed.
  Lemma parallel_weaken R (R' : V -> list W -> Prop) v w :
    (forall x u, In x v -> R x u -> R' x u) -> parallel R v w -> parallel R' v w.
  Proof. intros H K. induction K; constructor; [apply H; cbn; auto|apply IHK; intros; apply H; cbn; auto]. Qed.
  Lemma parallel_equal R (R' : V -> list W -> Prop) v w :
    (forall x u, R x u <-> R' x u) -> parallel R v w <-> parallel R' v w.
  Proof. intro H. split; apply parallel_weaken; intros; now apply H. Qed.
  Lemma parallel_reversed R v w : parallel R v w -> parallel (fun x u => R x (rev u)) (rev v) (rev w).
  Proof.
    induction 1 as [|x u v w H _ IH]; cbn; auto. rewrite rev_app_distr. apply parallel_append; auto.
    apply parallel_letter. now rewrite rev_involutive.
  Qed.
  Lemma parallel_exists R v : (forall x, In x v -> exists u, R x u) -> exists w, parallel R v w.
  Proof.
    induction v as [|x v IH]; intro H; [eauto|]. destruct (H x) as (u & Hu); [now left|].
    destruct IH as (w & Hw); [intros; apply H; now right|]. eauto.
  Qed.
  Lemma parallel_member R v w x : parallel R v w -> In x v -> exists u, R x u /\ incl u w.
  Proof.
    induction 1 as [|y u v w H K IH]; [easy|]. intros [->|I].
    - exists u. split; auto. now apply incl_appl, incl_refl.
    - destruct (IH I) as (u' & ? & ?). exists u'. split; auto. now apply incl_appr.
  Qed.
  Lemma parallel_from R v w y : parallel R v w -> In y w -> exists x u, In x v /\ R x u /\ In y u.
  Proof.
    induction 1 as [|x u v w H K IH]; [easy|]. intros [I|I]%in_app_or; [exists x, u; cbn; auto|].
    destruct (IH I) as (x' & u' & ? & ? & ?). exists x', u'. cbn. auto.
  Qed.
  Lemma parallel_function (h : V -> list W) v w : parallel (fun x u => u = h x) v w <-> w = flat_map h v.
  Proof.
    split; [induction 1; subst; auto|intros ->]. induction v; cbn; auto.
  Qed.
  Lemma parallel_once R v w w' : (forall x u u', In x v -> R x u -> R x u' -> u = u') -> parallel R v w -> parallel R v w' -> w = w'.
  Proof.
    intros H K. revert w'. induction K as [|x u v w Hx K IH]; intros w' K'; [now apply parallel_empty in K'|].
    apply parallel_first in K' as (u' & w'' & -> & Hx' & K'). f_equal; [apply (H x); auto; now left|].
    apply IH; auto. intros; eapply H; eauto. now right.
  Qed.
End Parallel.

Lemma parallel_map_left {U V W : Set} (f : U -> V) (R : V -> list W -> Prop) v w :
  parallel R (map f v) w <-> parallel (fun x u => R (f x) u) v w.
Proof.
  revert w. induction v as [|x v IH]; cbn; intro w; [now rewrite !parallel_empty|].
  rewrite !parallel_first. now setoid_rewrite IH.
Qed.
Lemma parallel_compose {U V W : Set} (R : U -> list V -> Prop) (Q : V -> list W -> Prop) u w :
  parallel (fun x z => exists v, R x v /\ parallel Q v z) u w <-> exists v, parallel R u v /\ parallel Q v w.
Proof.
  split.
  - induction 1 as [|x z u w (v & H & K) _ (v' & H' & K')]; [exists []; auto|].
    exists (v ++ v'). auto using parallel_append.
  - intros (v & H & K). revert w K. induction H as [|x v u v' Hx H IH]; intros w K.
    + apply parallel_empty in K as ->. auto.
    + apply parallel_split in K as (w1 & w2 & -> & K1 & K2). constructor; eauto.
Qed.
Lemma parallel_map_right {V W X : Set} (f : W -> X) (R : V -> list W -> Prop) v z :
  parallel (fun x u => exists u', R x u' /\ u = map f u') v z <-> exists w, parallel R v w /\ z = map f w.
Proof.
  assert (Q : forall w z, parallel (fun y u => u = [f y]) w z <-> z = map f w).
  { intros w z'. rewrite parallel_function. now replace (flat_map (fun y => [f y]) w) with (map f w) by (induction w; cbn; congruence). }
  rewrite (parallel_equal _ (fun x u => exists u', R x u' /\ parallel (fun y u => u = [f y]) u' u)).
  - rewrite parallel_compose. now setoid_rewrite Q.
  - intros x u. now setoid_rewrite Q.
Qed.

Lemma parallel_onto {V W X : Set} (f : W -> X) (R : V -> list W -> Prop) (Q : V -> list X -> Prop) v w :
  (forall x u, In x v -> R x u -> Q x (map f u)) -> parallel R v w -> parallel Q v (map f w).
Proof.
  intros H K. induction K as [|x u v w I K IH]; cbn; auto. rewrite map_app. constructor; [apply H; auto; now left|].
  apply IH. intros; apply H; auto. now right.
Qed.

(* a word that is a product has a cut for each factor *)
Lemma parallel_concat {V W : Set} (R : V -> list W -> Prop) vs w : parallel R (concat vs) w <->
  exists ws, w = concat ws /\ Forall2 (parallel R) vs ws.
Proof.
  revert w. induction vs as [|v vs IH]; cbn; intro w.
  - rewrite parallel_empty. split; [intros ->; now exists []|intros (ws & -> & H); now inversion H].
  - split.
    + intros (w1 & w2 & -> & H & (ws & -> & K)%IH)%parallel_split. exists (w1 :: ws). auto.
    + intros (ws & -> & H). inversion H as [|? w1 ? ws' H1 H2]; subst. apply parallel_append; auto. apply IH. eauto.
Qed.

(* ---- derivations ---- *)
Section Derivations.
  Context {V : Set}.
  Implicit Type ts : list (table V).
  Lemma derives_from ts u v w : derives ts u v -> derives ts v w -> derives ts u w.
  Proof. intros H K. induction K; eauto. Qed.
  Lemma derives_first ts t u v w : In t ts -> step t u v -> derives ts v w -> derives ts u w.
  Proof. intros. apply (@derives_from ts u v w); auto. apply (@derives_step _ ts u u v t); auto. Qed.
  Lemma derives_more ts ts' u v : incl ts ts' -> derives ts u v -> derives ts' u v.
  Proof. intros I H. induction H; eauto. Qed.
End Derivations.

(* ---- alphabets ---- *)
Section Alphabets.
  Context {A B : Set} {a : Alphabet A} {b : Alphabet B}.
  #[export] Instance sum_alphabet : Alphabet (A + B).
  Proof.
    refine {| letters := map inl letters ++ map inr letters |}.
    - decide equality; apply letter_eq.
    - intros [x|x]; apply in_or_app; [left|right]; apply in_map, all_letters.
  Defined.
  #[export] Instance option_alphabet : Alphabet (option A).
  Proof.
    refine {| letters := None :: map Some letters |}.
    - decide equality; apply letter_eq.
    - intros [x|]; [right; apply in_map, all_letters|now left].
  Defined.
  #[export] Instance pair_alphabet : Alphabet (A * B).
  Proof.
    refine {| letters := flat_map (fun x => map (pair x) letters) letters |}.
    - decide equality; apply letter_eq.
    - intros (x, y). apply in_flat_map. exists x. split; [apply all_letters|apply in_map, all_letters].
  Defined.
End Alphabets.
#[export] Instance unit_alphabet : Alphabet unit.
Proof. refine {| letters := [tt] |}; [decide equality|intros []; now left]. Defined.
#[export] Instance bool_alphabet : Alphabet bool.
Proof. refine {| letters := [false; true] |}; [apply bool_dec|intros []; cbn; auto]. Defined.
#[export] Instance no_letters : Alphabet Empty_set.
Proof. refine {| letters := [] |}; intros []. Defined.
Definition word_eq {A : Set} {a : Alphabet A} : forall u v : list A, {u = v} + {u <> v} := list_eq_dec letter_eq.

(* One letter for each member of a family of alphabets. *)
#[export] Instance tagged_alphabet {A : Set} {a : Alphabet A} (V : A -> Set) {v : forall x, Alphabet (V x)} : Alphabet {x : A & V x}.
Proof.
  refine {| letters := flat_map (fun x => map (existT V x) letters) letters |}.
  - intros (x, p) (y, q). destruct (letter_eq x y) as [<-|N].
    + destruct (letter_eq p q) as [<-|N]; [now left|right]. intro H. apply N. revert H. apply Eqdep_dec.inj_pair2_eq_dec, letter_eq.
    + right. intro H. apply N. now apply (f_equal (@projT1 _ _)) in H.
  - intros (x, p). apply in_flat_map. exists x. split; [apply all_letters|apply in_map, all_letters].
Defined.

(* Over an alphabet, finitely many choices are one. *)
Lemma choose {A : Set} {a : Alphabet A} (X : Type) (R : A -> X -> Prop) :
  (forall x, exists y, R x y) -> inhabited X -> exists f, forall x, R x (f x).
Proof.
  intros H (d). assert (Q : forall l, exists f, forall x : A, In x l -> R x (f x)).
  { induction l as [|x l (f & IH)]; [now exists (fun _ => d)|]. destruct (H x) as (y & Hy).
    exists (fun z => if letter_eq z x then y else f z). intros z I. destruct (letter_eq z x) as [->|N]; auto.
    destruct I; [congruence|auto]. }
  destruct (Q letters) as (f & F). exists f. intro x. apply F, all_letters.
Qed.

Unset Implicit Arguments.
(* ---- functions from an alphabet to an alphabet form an alphabet, as lists of values ---- *)
Section Functions.
  Context {A B : Set} {a : Alphabet A} {b : Alphabet B}.
  Fixpoint values (l : list A) : Set := match l with [] => unit | _ :: l => (B * values l)%type end.
  Fixpoint values_alphabet l : Alphabet (values l) :=
    match l with [] => unit_alphabet | _ :: l => @pair_alphabet B (values l) b (values_alphabet l) end.
  Fixpoint tabulate (f : A -> B) l : values l := match l with [] => tt | x :: l => (f x, tabulate f l) end.
  Fixpoint look (d : B) l : values l -> A -> B := match l with
    | [] => fun _ _ => d
    | y :: l => fun v x => if letter_eq x y then fst v else look d l (snd v) x end.
  Lemma look_tabulate d f l x : In x l -> look d l (tabulate f l) x = f x.
  Proof. induction l as [|y l IH]; [easy|]. cbn. destruct (letter_eq x y) as [->|N]; auto. intros [->|I]; [easy|auto]. Qed.
  Lemma tabulate_equal f g l : (forall x, f x = g x) -> tabulate f l = tabulate g l.
  Proof. intro H. induction l; cbn; congruence. Qed.
End Functions.
Definition function (A B : Set) {a : Alphabet A} : Set := @values A B letters.
#[export] Instance function_alphabet {A B : Set} {a : Alphabet A} {b : Alphabet B} : Alphabet (function A B) := values_alphabet letters.
Definition as_letter {A B : Set} {a : Alphabet A} (f : A -> B) : function A B := tabulate f letters.
Definition apply {A B : Set} {a : Alphabet A} (d : B) (f : function A B) (x : A) : B := look d letters f x.
Lemma apply_as_letter {A B : Set} {a : Alphabet A} (d : B) (f : A -> B) x : apply d (as_letter f) x = f x.
Proof. apply look_tabulate, all_letters. Qed.

(* ---- words of a system with another set of letters ---- *)
Lemma map_inr_equal {A N : Set} (u v : list A) : map (@inr N A) u = map inr v -> u = v.
Proof. revert v; induction u; intros [|]; cbn; intros [=]; f_equal; auto. Qed.
Lemma flat_map_single {A B : Set} (f : A -> B) w : flat_map (fun a => [f a]) w = map f w.
Proof. induction w; cbn; congruence. Qed.
Lemma is_same {A : Set} f (X Y : language A) : same X Y -> is f X -> is f Y.
Proof.
  intro S. destruct f as [| |k|]; cbn.
  - intros (Q & q & M & H). exists Q, q, M. intro w. now rewrite <- (S w), (H w).
  - intros (Q & q & M & H). exists Q, q, M. intro w. now rewrite <- (S w), (H w).
  - unfold lsystem. destruct (extended k).
    + intros (N & n & G & g & H). exists N, n, G. split; auto. intro w. now rewrite <- (S w), (H w).
    + intros (G & g & H). exists G. split; auto. intro w. now rewrite <- (S w), (H w).
  - intros (G & g & t & H). exists G. split; [|split]; auto. intro w. now rewrite <- (S w), (H w).
Qed.
(* to use that a family is closed, where alphabets are found by Coq *)
Ltac under H := apply H; try exact _.
