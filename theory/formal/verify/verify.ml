(* verify FILE...: checks the statements of certificates of `algae check --certificate` by the checker that is proved in
   Checker.v.  verify --lines FILE: each line is a certificate, and a line of the output says what becomes of it.  This file
   reads JSON and says which statement is meant; whether it is true is decided by `check_numbers`.
   What Checker.v has no form for is not covered. *)

open Checker

exception Not_covered of string

(* ---- JSON ---- *)
type json = Null | Bool of bool | Number of string | String of string | List of json list | Object of (string * json) list

let parse text =
  let place = ref 0 in
  let fail what = failwith (Printf.sprintf "byte %d: expected %s" !place what) in
  let peek () = if !place < String.length text then text.[!place] else '\000' in
  let rec skip () = match peek () with ' ' | '\n' | '\t' | '\r' -> incr place; skip () | _ -> () in
  let take c = if peek () = c then incr place else fail (String.make 1 c) in
  let utf8 out code = Buffer.add_utf_8_uchar out (Uchar.of_int code) in
  let text_of () =
    take '"';
    let out = Buffer.create 16 in
    let rec loop () = match peek () with
      | '"' -> incr place
      | '\000' when !place >= String.length text -> fail "the end of a text"
      | '\\' ->
        incr place;
        (match peek () with
         | 'n' -> Buffer.add_char out '\n' | 't' -> Buffer.add_char out '\t' | 'r' -> Buffer.add_char out '\r'
         | 'b' -> Buffer.add_char out '\b' | 'f' -> Buffer.add_char out '\012'
         | 'u' ->
           if !place + 4 >= String.length text then fail "four digits";
           utf8 out (int_of_string ("0x" ^ String.sub text (!place + 1) 4)); place := !place + 4
         | c -> Buffer.add_char out c);
        incr place; loop ()
      | c -> Buffer.add_char out c; incr place; loop () in
    loop (); Buffer.contents out in
  let rec value () =
    skip ();
    match peek () with
    | '{' -> incr place; skip ();
      if peek () = '}' then (incr place; Object []) else
        let rec fields done_ =
          skip (); let key = text_of () in skip (); take ':'; let v = value () in skip ();
          if peek () = ',' then (incr place; fields ((key, v) :: done_)) else (take '}'; Object (List.rev ((key, v) :: done_))) in
        fields []
    | '[' -> incr place; skip ();
      if peek () = ']' then (incr place; List []) else
        let rec items done_ =
          let v = value () in skip ();
          if peek () = ',' then (incr place; items (v :: done_)) else (take ']'; List (List.rev (v :: done_))) in
        items []
    | '"' -> String (text_of ())
    | '0' .. '9' | '-' ->
      let from = !place in
      while (match peek () with '0' .. '9' | '-' | '+' | '.' | 'e' | 'E' -> true | _ -> false) do incr place done;
      Number (String.sub text from (!place - from))
    | _ ->
      let word w v = if !place + String.length w <= String.length text && String.sub text !place (String.length w) = w
        then (place := !place + String.length w; Some v) else None in
      (match word "true" (Bool true), word "false" (Bool false), word "null" Null with
       | Some v, _, _ | _, Some v, _ | _, _, Some v -> v
       | _ -> fail "a value") in
  let v = value () in
  skip (); if !place < String.length text then fail "the end"; v

let find key = function Object fields -> List.assoc_opt key fields | _ -> None
let get key v = match find key v with Some x -> x | None -> raise (Not_covered ("without " ^ key))
let text = function String s -> s | _ -> raise (Not_covered "no text")
let items = function List l -> l | _ -> raise (Not_covered "no list")
let fields = function Object l -> l | _ -> raise (Not_covered "no object")

(* ---- statements ---- *)
let kinds = [ "0L", (false, false, false); "P0L", (false, false, true); "D0L", (false, true, false); "PD0L", (false, true, true);
              "T0L", (true, false, false); "PT0L", (true, false, true); "DT0L", (true, true, false); "PDT0L", (true, true, true) ]

let statement_of certificate entry =
  let names = List.map text (items (get "alphabet" certificate)) in
  let size = List.length names in
  let numbers = List.mapi (fun i name -> (name, i)) names in
  let letter name = match List.assoc_opt name numbers with
    | Some i -> (match number size i with Some x -> x | None -> failwith "a letter beyond the alphabet")
    | None -> raise (Not_covered ("letter " ^ name)) in
  let word v = match text v with "" -> [] | s -> List.map letter (String.split_on_char ' ' s) in
  let rule_system s =
    match find "rules" s with
    | None -> raise (Not_covered "a system with modules")
    | Some rules ->
      if find "ignored" s <> None then raise (Not_covered "a system with ignored letters");
      let rule r = (((word (get "left" r), letter (text (get "letter" r))), word (get "right" r)), word (get "successor" r)) in
      (word (get "axiom" s), List.map rule (items rules)) in
  let rules_of s =
    if find "tables" s = None then raise (Not_covered "a system with context");
    let table t = List.concat_map (fun (x, us) -> List.map (fun u -> (letter x, word u)) (items us)) (fields t) in
    (word (get "axiom" s), List.map table (items (get "tables" s)),
     match find "terminals" s with Some l -> word l | None -> List.map letter names) in
  let named name = get name (get "systems" certificate) in
  let system name = rules_of (named name) in
  let morphism h = List.map (fun (x, u) -> (letter x, word u)) (fields h) in
  let rec language v = match fields v with
    | [ "words", l ] -> Words (List.map word (items l))
    | [ "union", List [ e; f ] ] -> United (language e, language f)
    | [ "intersection", List [ e; f ] ] -> Intersected (language e, language f)
    | [ "difference", List [ e; f ] ] -> Difference (language e, language f)
    | [ "concatenation", List [ e; f ] ] -> Product (language e, language f)
    | [ "star", e ] -> Starred (language e)
    | [ "plus", e ] -> let e = language e in Product (e, Starred e)
    | [ "reversal", e ] -> Reversed (language e)
    | [ "complement", e; "letters", l ] | [ "letters", l; "complement", e ] -> Complemented (word l, language e)
    | [ "image", e; "morphism", h ] | [ "morphism", h; "image", e ] -> Imaged (morphism h, language e)
    | [ "inverse image", e; "morphism", h ] | [ "morphism", h; "inverse image", e ] -> Inverse (morphism h, language e)
    | [ "generated", name ] -> let axiom, tables, terminals = system (text name) in Generated (tables, axiom, terminals)
    | (("powers" | "numbers"), _) :: _ -> raise (Not_covered "a language of powers")
    | _ -> raise (Not_covered "a language of another form") in
  let derivation proof = List.map word (items (get "words" proof)) in
  let proof () = match find "proof" entry with Some p -> p | None -> Null in
  let witnesses () = match find "word" (proof ()) with Some w -> [ word w ] | None -> [] in
  let integer = function Number n | String n -> (try int_of_string n with Failure _ -> raise (Not_covered "a large number")) | _ -> raise (Not_covered "no number") in
  let kind_of family = match List.assoc_opt family kinds with
    | Some (tabled, deterministic, propagating) -> { tabled; deterministic; propagating; extended = false }
    | None -> raise (Not_covered family) in
  let rec meant is v = match fields v with
    | [ "not", v ] -> meant (not is) v
    | _ when find "for all" v <> None && find "holds" v <> None && find "with" v = None ->
      let operation, family = closure v in if is then Closed (operation, family) else Not_closed (operation, family)
    | _ when find "is" v <> None && find "language" v <> None -> belongs is (text (get "is" v)) (get "language" v)
    | [ "equal", List [ e; f ] ] -> if is then Equal (language e, language f) else Not_equal (language e, language f, witnesses ())
    | [ "included", List [ e; f ] ] -> if is then Included (language e, language f) else Not_included (language e, language f, witnesses ())
    | _ when find "size" v <> None && find "language" v <> None && is -> Number_of (language (get "language" v), integer (get "size" v))
    | _ when find "member" v <> None ->
      let w = word (get "member" v) and l = get "language" v in
      (match find "generated" l, is, find "derivation" (proof ()) with
       | Some name, true, Some steps ->
         let axiom, tables, terminals = system (text name) in
         (match derivation steps with
          | first :: steps when first = axiom -> Generates (tables, axiom, terminals, w, steps)
          | _ -> failwith "the derivation does not begin with the axiom")
       | _ -> if is then Member (w, language l) else Not_member (w, language l))
    | _ when find "derives" v <> None && find "system" v <> None && find "probability" v = None -> derives is v
    | _ -> raise (Not_covered "the form of the statement")
  (* The statement is in a family, finite or empty, or it is not. *)
  and belongs is family l = match family, is with
    | "finite", true -> Finite (language l)
    | "empty", true -> Empty (language l)
    | "empty", false -> Not_empty (language l, witnesses ())
    | "IL", true ->
      (match find "generated" l with
       | Some name -> let axiom, rules = rule_system (named (text name)) in Is_interacting (axiom, rules)
       | None -> raise (Not_covered "IL"))
    | _, false -> Is_not (kind_of family, language l)
    | _, true ->
      let k = kind_of family in
      (match find "by" (proof ()), find "generated" l with
       | Some (String "form"), Some name when find "terminals" (named (text name)) = None ->
         let axiom, tables, _ = system (text name) in Has_form (k, tables, axiom)
       | Some (String "system"), _ ->
         let axiom, tables, _ = rules_of (get "system" (proof ())) in Is (k, language l, tables, axiom)
       | _ -> raise (Not_covered "a family, by another proof"))
  and derives is v =
    let s = named (text (get "system" v)) and w = word (get "derives" v) in
    let from = match find "from" v with Some u -> word u | None -> word (get "axiom" s) in
    if not is then begin
      let _, tables, _ = rules_of s in
      match find "steps" v with
      | Some n -> Not_derives (tables, from, integer n, w)
      | None -> Not_member (w, Generated (tables, from, List.map letter names))
    end else
      match derivation (proof ()) with
      | first :: steps when first = from ->
        let n = match find "steps" v with Some n -> integer n | None -> List.length steps in
        if find "rules" s <> None then let _, rules = rule_system s in Context_derives (rules, from, n, w, steps)
        else let _, tables, _ = rules_of s in Derives (tables, from, n, w, steps)
      | _ -> failwith "the derivation begins with another word"
  (* "for all languages of a family, what an operation makes of them is in the family": a cell of the table *)
  and closure v =
    let suffix = " languages" in
    let family_of s =
      let n = String.length s - String.length suffix in
      if n < 0 || String.sub s n (String.length suffix) <> suffix then raise (Not_covered "a statement on all numbers, words, systems or languages");
      match String.sub s 0 n with
      | "REG" -> REG | "CF" -> CF | "IL" -> IL
      | "E0L" -> LSystem { tabled = false; deterministic = false; propagating = false; extended = true }
      | "ET0L" -> LSystem { tabled = true; deterministic = false; propagating = false; extended = true }
      | "EDT0L" -> LSystem { tabled = true; deterministic = true; propagating = false; extended = true }
      | name -> LSystem (kind_of name) in
    let variables = List.map (fun x -> (text (get "name" x), text (get "of" x))) (items (get "for all" v)) in
    let holds = get "holds" v in
    let is_name x = function Object [ "name", String y ] -> x = y | _ -> false in
    match variables, find "is" holds, Option.map fields (find "language" holds) with
    | (x, f) :: others, Some (String result), Some made when family_of (result ^ suffix) = family_of f ->
      let family = family_of f in
      let operation = match others, made with
        | [ (y, g) ], [ "union", List [ p; q ] ] when is_name x p && is_name y q && family_of g = family -> Union
        | [ (y, g) ], [ "concatenation", List [ p; q ] ] when is_name x p && is_name y q && family_of g = family -> Concatenation
        | [ (y, g) ], [ "intersection", List [ p; q ] ] when is_name x p && is_name y q && family_of g = family -> Intersection
        | [ (y, "REG languages") ], [ "intersection", List [ p; q ] ] when is_name x p && is_name y q -> IntersectionWithRegular
        | [], [ "star", p ] when is_name x p -> Star
        | [], [ "plus", p ] when is_name x p -> Plus
        | [], [ "reversal", p ] when is_name x p -> Reversal
        | [ (h, "morphisms") ], [ "image", p; "morphism", String g ] when is_name x p && g = h -> Homomorphism
        | [ (h, "non-erasing morphisms") ], [ "image", p; "morphism", String g ] when is_name x p && g = h -> NonErasingHomomorphism
        | [ (h, "finite substitutions") ], [ "image", p; "morphism", String g ] when is_name x p && g = h -> FiniteSubstitution
        | [ (h, "morphisms") ], [ "inverse image", p; "morphism", String g ] when is_name x p && g = h -> InverseHomomorphism
        | _ -> raise (Not_covered "a statement on all numbers, words, systems or languages") in
      (operation, family)
    | _ -> raise (Not_covered "a statement on all numbers, words, systems or languages") in
  let is = match get "verdict" entry with
    | String "proved" -> true | String "refuted" -> false
    | _ -> raise (Not_covered "not decided") in
  let statement = get "statement" entry in
  let opposite = match meant (not is) statement with s -> Some s | exception (Not_covered _ | Failure _) -> None in
  (size, meant is statement, opposite)

(* ---- files ---- *)
exception Too_long
let fuel = 200
let bound = 12
let seconds = ref 1.

let clock s = ignore (Unix.setitimer Unix.ITIMER_VIRTUAL { it_interval = 0.; it_value = s })    (* of the processor *)

type outcome = Checked | Left of string | Wrong of string    (* left: not covered *)

(* Of a statement with parts that all hold each part is checked, by its own proof. *)
let rec parts entry =
  match find "all of" (get "statement" entry), get "verdict" entry, find "proof" entry with
  | Some (List statements), String "proved", Some proof when find "by" proof = Some (String "parts") ->
    let shown = items (get "parts" proof) in
    List.concat (List.mapi (fun i statement ->
      let is_it p = match find "part" p with Some (Number n) | Some (String n) -> int_of_string n = i | _ -> false in
      match List.filter is_it shown with
      | [ p ] when find "holds" p = Some (Bool true) ->
        parts (Object [ "statement", statement; "verdict", String "proved"; "proof", get "proof" p; "text", get "text" entry ])
      | _ -> raise (Not_covered "a part without its proof")) statements)
  | _ -> [ entry ]

(* False is what is not a derivation, and that of which the checker proves the opposite. *)
let check_part certificate entry =
  match statement_of certificate entry with
  | exception Not_covered reason -> Left reason
  | exception Failure why -> Wrong why
  | size, statement, opposite ->
    let checked s = check_numbers size fuel bound s in
    clock !seconds;
    let outcome_of () =
      if checked statement then Checked
      else match statement with
        | Derives _ | Generates _ | Context_derives _ -> Wrong "not so"
        | Is_not _ -> Left "the search finds no proof"
        | Has_form _ -> Left "a form that only letters which never occur disturb"
        | _ -> (match opposite with
          | Some s when checked s -> Wrong "not so"
          | _ -> Left "not found out") in
    let outcome = match outcome_of () with
      | outcome -> outcome
      | exception (Too_long | Stack_overflow | Out_of_memory) -> Left "too long" in
    clock 0.;
    outcome

let check_entry certificate entry =
  match parts entry with
  | exception Not_covered reason -> [ Left reason ]
  | parts -> List.map (check_part certificate) parts

let certificate_of text =
  let certificate = parse text in
  (certificate, items (get "statements" certificate))

let read file =
  let channel = open_in_bin file in
  Fun.protect ~finally:(fun () -> close_in channel) (fun () -> really_input_string channel (in_channel_length channel))

let check_files files =
  let checked = ref 0 and failed = ref 0 and not_covered = ref 0 and reasons = Hashtbl.create 16 in
  let count file entry = function
    | Checked -> incr checked
    | Left reason -> incr not_covered; Hashtbl.replace reasons reason (1 + Option.value ~default:0 (Hashtbl.find_opt reasons reason))
    | Wrong why ->
      incr failed;
      Printf.printf "FAILED   %s: %s: %s\n" file (match find "text" entry with Some (String s) -> s | _ -> "?") why in
  List.iter (fun file -> match certificate_of (read file) with
    | certificate, entries -> List.iter (fun entry -> List.iter (count file entry) (check_entry certificate entry)) entries
    | exception (Failure why | Not_covered why | Invalid_argument why) -> incr failed; Printf.printf "FAILED   %s: %s\n" file why) files;
  List.iter (fun (reason, n) -> Printf.printf "%6d not covered: %s\n" n reason)
    (List.sort compare (List.of_seq (Hashtbl.to_seq reasons)));
  Printf.printf "%d checked, %d not covered, %d failed\n" !checked !not_covered !failed;
  if !failed > 0 then 1 else 0

let line_outcome text =
  match certificate_of text with
  | exception (Failure why | Not_covered why | Invalid_argument why) -> "unreadable: " ^ why
  | certificate, entries ->
    let outcomes = List.concat_map (check_entry certificate) entries in
    let wrong = List.find_map (function Wrong why -> Some ("failed: " ^ why) | _ -> None) outcomes in
    let left = List.find_map (function Left why -> Some ("not covered: " ^ why) | _ -> None) outcomes in
    match wrong, left with
    | Some text, _ | None, Some text -> text
    | None, None -> if outcomes = [] then "not covered: no statement" else "checked"

let check_lines file =
  seconds := 0.5;
  let channel = open_in_bin file in
  (try while true do print_endline (line_outcome (input_line channel)) done with End_of_file -> ());
  close_in channel; 0

let () =
  Sys.set_signal Sys.sigvtalrm (Sys.Signal_handle (fun _ -> raise Too_long));
  exit (match List.tl (Array.to_list Sys.argv) with
    | [ "--lines"; file ] -> check_lines file
    | [] -> prerr_endline "verify FILE...: which certificates?"; 2
    | files -> check_files files)
