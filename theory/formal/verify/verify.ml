(* verify FILE...: checks the statements of certificates of `algae check --certificate` by the checker that is proved in
   Checker.v.  verify --lines FILE: each line is a certificate, and a line of the output says what becomes of it.  This file reads JSON and says which statement is meant; whether it is true is decided by `check_numbers`.
   What is neither on finite languages nor a derivation is not covered. *)

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
  let rec language v = match fields v with
    | [ "words", l ] -> Words (List.map word (items l))
    | [ "union", List [ e; f ] ] -> United (language e, language f)
    | [ "intersection", List [ e; f ] ] -> Intersected (language e, language f)
    | [ "difference", List [ e; f ] ] -> Difference (language e, language f)
    | [ "concatenation", List [ e; f ] ] -> Product (language e, language f)
    | [ "reversal", e ] -> Reversed (language e)
    | [ "image", e; "morphism", h ] | [ "morphism", h; "image", e ] ->
      Imaged (List.map (fun (x, u) -> (letter x, word u)) (fields h), language e)
    | _ -> raise (Not_covered "a language that is not given as finite") in
  let rules_of s =
    if find "terminals" s = None && find "tables" s = None then raise (Not_covered "a system with context");
    let table t = List.concat_map (fun (x, us) -> List.map (fun u -> (letter x, word u)) (items us)) (fields t) in
    (word (get "axiom" s), List.map table (items (get "tables" s)),
     match find "terminals" s with Some l -> word l | None -> List.map letter names) in
  let system name = rules_of (get name (get "systems" certificate)) in
  let derivation proof = List.map word (items (get "words" proof)) in
  let rec meant is v = match fields v with
    | [ "not", v ] -> meant (not is) v
    | _ when find "is" v <> None && find "language" v <> None && not is ->
      (match List.assoc_opt (text (get "is" v)) kinds with
       | Some (tabled, deterministic, propagating) ->
         Is_not ({ tabled; deterministic; propagating; extended = false }, language (get "language" v))
       | None -> raise (Not_covered (text (get "is" v))))
    | _ when find "is" v <> None && find "language" v <> None ->
      let k = match List.assoc_opt (text (get "is" v)) kinds with
        | Some (tabled, deterministic, propagating) -> { tabled; deterministic; propagating; extended = false }
        | None -> raise (Not_covered (text (get "is" v))) in
      let l = get "language" v and proof = get "proof" entry in
      (match find "by" proof, find "generated" l with
       | Some (String "form"), Some name when find "terminals" (get (text name) (get "systems" certificate)) = None ->
         let axiom, tables, _ = system (text name) in Has_form (k, tables, axiom)
       | Some (String "system"), _ ->
         let axiom, tables, _ = rules_of (get "system" proof) in Is (k, language l, tables, axiom)
       | _ -> raise (Not_covered "a family, by another proof"))
    | [ "equal", List [ e; f ] ] -> if is then Equal (language e, language f) else Not_equal (language e, language f)
    | [ "included", List [ e; f ] ] -> if is then Included (language e, language f) else Not_included (language e, language f)
    | _ when find "member" v <> None ->
      let w = word (get "member" v) and l = get "language" v in
      (match find "generated" l, is with
       | Some name, true ->
         let axiom, tables, terminals = system (text name) in
         (match derivation (get "derivation" (get "proof" entry)) with
          | first :: steps when first = axiom -> Generates (tables, axiom, terminals, w, steps)
          | _ -> failwith "the derivation does not begin with the axiom")
       | _ -> if is then Member (w, language l) else Not_member (w, language l))
    | _ when find "derives" v <> None && find "system" v <> None && is ->
      let axiom, tables, _ = system (text (get "system" v)) in
      let from = match find "from" v with Some u -> word u | None -> axiom in
      (match derivation (get "proof" entry) with
       | first :: steps when first = from ->
         let n = match find "steps" v with Some (Number n) | Some (String n) -> int_of_string n | _ -> List.length steps in
         Derives (tables, from, n, word (get "derives" v), steps)
       | _ -> failwith "the derivation begins with another word")
    | _ -> raise (Not_covered "the form of the statement") in
  let is = match get "verdict" entry with
    | String "proved" -> true | String "refuted" -> false
    | _ -> raise (Not_covered "not decided") in
  (size, meant is (get "statement" entry))

(* ---- files ---- *)
exception Too_long
let fuel = 200
let seconds = 10

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

let check_part certificate entry =
  match statement_of certificate entry with
  | exception Not_covered reason -> Left reason
  | exception Failure why -> Wrong why
  | size, statement ->
    ignore (Unix.alarm seconds);
    let outcome = match check_numbers size fuel statement with
      | true -> Checked
      | false -> (match statement with
        | Is_not _ -> Left "the search finds no proof"
        | Has_form _ -> Left "a form that only letters which never occur disturb"
        | _ -> Wrong "not so")
      | exception (Too_long | Stack_overflow | Out_of_memory) -> Left "too long" in
    ignore (Unix.alarm 0);
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
  let channel = open_in_bin file in
  (try while true do print_endline (line_outcome (input_line channel)) done with End_of_file -> ());
  close_in channel; 0

let () =
  Sys.set_signal Sys.sigalrm (Sys.Signal_handle (fun _ -> raise Too_long));
  exit (match List.tl (Array.to_list Sys.argv) with
    | [ "--lines"; file ] -> check_lines file
    | [] -> prerr_endline "verify FILE...: which certificates?"; 2
    | files -> check_files files)
