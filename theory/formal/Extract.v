(* The checker as OCaml, for verify/verify.ml.  Natural numbers become machine integers: they are lengths, letters and the
   depth of a search, none of which is large. *)
From Coq Require Import Extraction ExtrOcamlBasic ExtrOcamlNatInt ExtrOcamlNativeString.
From Algae Require Import Checker.
Extraction "checker.ml" check_numbers number.
