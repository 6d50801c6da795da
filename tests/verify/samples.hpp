#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "verify/verify.hpp"

namespace samples {

using Json = nlohmann::ordered_json;

/// Systems over a and b.
inline Json systems() {
    return Json::parse(R"({
      "F": {"axiom": "a", "tables": [{"a": ["a b"], "b": ["a"]}]},
      "H": {"axiom": "a", "tables": [{"a": ["a b"], "b": ["a"]}]},
      "G": {"axiom": "a", "tables": [{"a": ["a", "a a"]}]},
      "E": {"axiom": "b", "tables": [{"b": ["a b", "a"]}], "terminals": "a"},
      "T": {"axiom": "a", "tables": [{"a": ["a a"]}, {"a": ["b"]}]},
      "C": {"axiom": "a b", "rules": [{"left": "", "letter": "a", "right": "b", "successor": ""}]},
      "P": {"axiom": "a b", "tables": [{"b": ["a b"]}]},
      "Q": {"axiom": "a a b", "tables": [{"b": ["a b"]}]},
      "S": {"axiom": "a", "tables": [{"a": ["b"], "b": ["a"]}]},
      "X": {"axiom": "a b", "tables": [{"a": ["a b b"], "b": ["a a b b a"]}]},
      "Y": {"axiom": "a b", "tables": [{"a": ["a b b a a b b"], "b": ["a"]}]},
      "U": {"axiom": "a b", "tables": [{"a": ["a b"], "b": ["a b"]}]},
      "V": {"axiom": "a b", "tables": [{"a": ["a b a"], "b": ["b"]}]},
      "W": {"axiom": "a", "tables": [{"a": ["a a"]}]},
      "K": {"axiom": "b", "tables": [{"b": ["a b a"]}]}
    })");
}

/// One statement with its proof.
struct Sample {
    const char* statement;
    const char* verdict;
    const char* proof;
};

/// One or more for each rule of the table of proofs; all are sound.
inline const std::vector<Sample>& sound() {
    static const std::vector<Sample> all = {
        {R"({"member": "a a", "language": {"generated": "G"}})", "proved",
         R"({"by": "membership", "derivation": {"words": ["a", "a a"]}})"},
        {R"({"member": "a b", "language": {"generated": "G"}})", "refuted",
         R"({"by": "membership"})"},
        {R"({"member": "b b", "language": {"generated": "T"}})", "proved",
         R"({"by": "membership", "derivation": {"words": ["a", "a a", "b b"], "tables": [0, 1]}})"},
        {R"({"member": "b b b", "language": {"generated": "T"}})", "refuted",
         R"({"by": "membership"})"},
        {R"({"member": "a a", "language": {"generated": "E"}})", "proved",
         R"({"by": "membership"})"},
        {R"({"not": {"member": "a b", "language": {"generated": "E"}}})", "proved",
         R"({"by": "membership"})"},
        {R"({"member": "b", "language": {"generated": "C"}})", "proved", R"({"by": "membership"})"},
        {R"({"member": "b b", "language": {"image": {"generated": "G"}, "morphism": {"a": "b"}}})",
         "proved", R"({"by": "membership", "preimage": "a a"})"},
        {R"({"member": "b b", "language": {"concatenation": [{"reversal": {"generated": "F"}}, {"star": {"words": ["a"]}}]}})",
         "refuted", R"({"by": "membership"})"},
        {R"({"is": "REG", "language": {"generated": "P"}})", "proved",
         R"({"by": "progressions", "first": 0, "period": 1})"},
        {R"({"is": "REG", "language": {"generated": "K"}})", "refuted",
         R"({"by": "unequal powers", "first": 0, "step": 1, "parts": [["a", "b", "a"]]})"},
        {R"({"equal": [{"generated": "P"}, {"concatenation": [{"plus": {"words": ["a"]}}, {"words": ["b"]}]}]})",
         "proved", R"({"by": "progressions", "first": 0, "period": 1})"},
        {R"({"is": "0L", "language": {"words": ["", "a", "a a"]}})", "proved",
         R"({"by": "system", "system": {"axiom": "a a", "tables": [{"a": ["", "a"]}]}})"},
        {R"({"is": "PD0L", "language": {"generated": "F"}})", "proved", R"({"by": "form"})"},
        {R"({"is": "IL", "language": {"generated": "C"}})", "proved", R"({"by": "form"})"},
        {R"({"is": "0L", "language": {"plus": {"words": ["a"]}}})", "proved",
         R"({"by": "equal", "system": {"axiom": "a", "tables": [{"a": ["a", "a a"]}]}, "proof": {"by": "both", "proofs": [{"by": "relations"}, {"by": "induction", "base": ["a"]}]}})"},
        {R"({"is": "E0L", "language": {"words": ["a", "b"]}})", "proved", R"({"by": "finite"})"},
        {R"({"is": "REG", "language": {"star": {"words": ["a b"]}}})", "proved",
         R"({"by": "regular"})"},
        {R"({"is": "0L", "language": {"reversal": {"generated": "G"}}})", "proved",
         R"({"by": "reversal", "proof": {"by": "form"}})"},
        {R"({"is": "E0L", "language": {"plus": {"generated": "G"}}})", "proved",
         R"({"by": "closed"})"},
        {R"({"is": "ET0L", "language": {"inverse image": {"generated": "T"}, "morphism": {"a": "a a"}}})",
         "proved", R"({"by": "closed"})"},
        {R"({"is": "EDT0L", "language": {"concatenation": [{"generated": "W"}, {"star": {"words": ["b"]}}]}})",
         "proved", R"({"by": "closed"})"},
        {R"({"included": [{"plus": {"concatenation": [{"generated": "E"}, {"words": ["b"]}]}}, {"plus": {"concatenation": [{"plus": {"words": ["a"]}}, {"words": ["b"]}]}}]})",
         "proved", R"({"by": "relations"})"},
        {R"({"is": "empty", "language": {"intersection": [{"concatenation": [{"generated": "P"}, {"words": ["a"]}]}, {"star": {"words": ["b"]}}]}})",
         "proved", R"({"by": "relations"})"},
        {R"({"equal": [{"intersection": [{"generated": "F"}, {"star": {"words": ["a b"]}}]}, {"words": ["a b"]}]})",
         "proved", R"({"by": "values"})"},
        {R"({"is": "CF", "language": {"generated": "W"}})", "refuted", R"({"by": "sparse"})"},
        {R"({"is": "0L", "language": {"words": ["a", "a a"]}})", "refuted",
         R"({"by": "cases", "obstruction": {"root": {"excluded": [
           {"letter": "a", "image": "", "word": "a"}, {"letter": "a", "image": "a a", "word": "a a"}],
           "end": "sources", "sources": [["a"], ["a a"]]}}})"},
        {R"({"is": "PT0L", "language": {"star": {"words": ["a"]}}})", "refuted",
         R"({"by": "empty word"})"},
        {R"({"member": "a a b b", "language": {"powers": [{"word": "a", "exponent": [{"coefficient": 1, "number": "n", "power": 1}]}, {"word": "b", "exponent": [{"coefficient": 2, "number": "n", "base": 2}]}], "numbers": [{"name": "n", "least": 0}]}})",
         "refuted", R"({"by": "membership"})"},
        {R"({"included": [{"powers": [{"word": "a b", "exponent": [{"coefficient": 1, "number": "n", "power": 1}, {"coefficient": 1, "number": "m", "power": 1}]}, {"word": "a", "exponent": [{"coefficient": 2, "number": "m", "power": 1}]}], "numbers": [{"name": "n", "least": 0}, {"name": "m", "least": 1}]}, {"concatenation": [{"plus": {"words": ["a b"]}}, {"plus": {"words": ["a a"]}}]}]})",
         "proved", R"({"by": "relations"})"},
        {R"({"equal": [{"generated": "W"}, {"powers": [{"word": "a", "exponent": [{"coefficient": 1, "number": "n", "base": 2}]}], "numbers": [{"name": "n", "least": 0}]}]})",
         "proved", R"({"by": "powers"})"},
        {R"({"is": "finite", "language": {"powers": [{"word": "a", "exponent": [{"coefficient": 1, "number": "n", "power": 2}]}], "numbers": [{"name": "n", "least": 0}]}})",
         "refuted", R"({"by": "powers"})"},
        {R"({"is": "REG", "language": {"powers": [{"word": "a", "exponent": [{"coefficient": 1, "number": "n", "power": 1}]}, {"word": "b", "exponent": [{"coefficient": 1, "number": "n", "power": 1}]}], "numbers": [{"name": "n", "least": 0}]}})",
         "refuted", R"({"by": "powers"})"},
        {R"({"is": "CF", "language": {"union": [{"generated": "G"}, {"powers": [{"word": "a", "exponent": [{"coefficient": 1, "number": "n", "power": 1}]}, {"word": "b", "exponent": [{"coefficient": 1, "number": "n", "power": 1}]}], "numbers": [{"name": "n", "least": 0}]}]}})",
         "proved", R"({"by": "context-free"})"},
        {R"({"is": "code", "language": {"words": ["a", "a b", "b b"]}})", "proved",
         R"({"by": "code"})"},
        {R"({"is": "prefix code", "language": {"concatenation": [{"star": {"words": ["a"]}}, {"words": ["b"]}]}})",
         "proved", R"({"by": "code"})"},
        {R"({"is": "code", "language": {"words": ["a", "a b", "b a"]}})", "refuted",
         R"({"by": "factorisations", "word": "a b a", "ends": [[1, 3], [2, 3]]})"},
        {R"({"is": "prefix code", "language": {"words": ["a", "a b"]}})", "refuted",
         R"({"by": "beginning", "word": "a b", "beginning": "a"})"},
        {R"({"palindrome": "a b a"})", "proved", R"({"by": "letters"})"},
        {R"({"is": "finite", "language": {"generated": "S"}})", "proved", R"({"by": "values"})"},
        {R"({"is": "finite", "language": {"complement": {"words": ["a"]}, "letters": "a"}})",
         "refuted", R"({"by": "values"})"},
        {R"({"is": "empty", "language": {"intersection": [{"words": ["a"]}, {"generated": "P"}]}})",
         "proved", R"({"by": "values"})"},
        {R"({"is": "empty", "language": {"intersection": [{"generated": "P"}, {"star": {"words": ["b"]}}]}})",
         "proved", R"({"by": "relations"})"},
        {R"({"is": "empty", "language": {"generated": "E"}})", "refuted",
         R"({"by": "word", "word": "a a a"})"},
        {R"({"size": 2, "language": {"generated": "S"}})", "proved", R"({"by": "values"})"},
        {R"({"size": "3", "language": {"generated": "S"}})", "refuted", R"({"by": "values"})"},
        {R"({"size": 2, "language": {"generated": "P"}})", "refuted",
         R"({"by": "infinite", "proof": {"by": "endless round", "rules": [{"letter": "b", "successor": "a b"}], "other": "a"}})"},
        {R"({"is": "finite", "language": {"generated": "F"}})", "refuted",
         R"({"by": "endless round", "rules": [{"letter": "a", "successor": "a b"}], "other": "b"})"},
        {R"({"is": "finite", "language": {"generated": "T"}})", "refuted",
         R"({"by": "endless tables", "again": "a", "other": "a", "before": [],
             "round": [{"table": 0, "letter": "a", "successor": "a a", "place": 0}],
             "beside": [{"table": 0, "letter": "a", "successor": "a a", "place": 1}],
             "kept": [{"table": 0, "letter": "a", "successor": "a a", "place": 0}], "after": []})"},
        {R"({"is": "finite", "language": {"concatenation": [{"words": ["a"]}, {"star": {"words": ["a b"]}}]}})",
         "refuted",
         R"({"by": "part", "index": 1, "proof": {"by": "pumping", "prefix": "", "middle": "a b", "suffix": "a b"}})"},
        {R"({"equal": [{"words": ["a", "b"]}, {"generated": "S"}]})", "proved",
         R"({"by": "values"})"},
        {R"({"equal": [{"star": {"words": ["a", "b"]}}, {"complement": {"words": []}, "letters": "a b"}]})",
         "proved", R"({"by": "derivatives"})"},
        {R"({"included": [{"image": {"star": {"words": ["a b"]}}, "morphism": {"a": "b", "b": ""}}, {"star": {"words": ["b"]}}]})",
         "proved", R"({"by": "derivatives"})"},
        {R"({"equal": [{"generated": "F"}, {"generated": "H"}]})", "proved",
         R"({"by": "identical"})"},
        {R"({"equal": [{"generated": "F"}, {"generated": "H"}]})", "proved",
         R"({"by": "sequences", "proof": {"by": "balance", "bound": 0, "states": [{"ahead": "left", "word": ""}]}})"},
        {R"({"equal": [{"generated": "P"}, {"union": [{"words": ["a"]}, {"generated": "Q"}]}]})",
         "refuted", R"({"by": "word", "word": "a b"})"},
        {R"({"included": [{"generated": "E"}, {"plus": {"words": ["a"]}}]})", "proved",
         R"({"by": "relations"})"},
        {R"({"included": [{"generated": "G"}, {"generated": "W"}]})", "refuted",
         R"({"by": "word", "word": "a a a"})"},
        {R"({"derives": "a b a", "system": "F"})", "proved",
         R"({"by": "derivation", "words": ["a", "a b", "a b a"]})"},
        {R"({"derives": "b b", "system": "T", "from": "a a", "steps": 1})", "proved",
         R"({"by": "derivation", "words": ["a a", "b b"], "tables": [1]})"},
        {R"({"derives": "b", "system": "S", "steps": 1000000})", "refuted",
         R"({"by": "exhausted"})"},
        {R"({"derives": "b a", "system": "G"})", "refuted", R"({"by": "exhausted"})"},
        {R"({"derives": "a b", "system": "C", "steps": 2})", "refuted", R"({"by": "exhausted"})"},
        {R"({"equal sequences": ["U", "V"]})", "proved",
         R"({"by": "balance", "bound": 1, "states": [{"ahead": "left", "word": ""}, {"ahead": "right", "word": "a"}], "accepts": {"steps": 2, "earlier": 1}})"},
        {R"({"equal sequences": ["S", "S"]})", "proved", R"({"by": "lengths"})"},
        {R"({"equal sequences": ["X", "Y"]})", "refuted",
         R"({"by": "generation", "generation": 3, "position": "36"})"},
        {R"({"equal sequences": ["F", "W"]})", "refuted",
         R"({"by": "generation", "generation": 1, "position": 1})"},
        {R"({"equal growth": ["F", "H"]})", "proved", R"({"by": "terms"})"},
        {R"({"equal growth": ["F", "W"]})", "refuted", R"({"by": "generation", "generation": 2})"},
        {R"j({"for all": [{"name": "n", "of": "numbers"}], "holds": {"numbers": ["length(P,n)", "=", "n+2"]}})j",
         "proved", R"j({"by": "recurrences", "orders": {"n": 5}})j"},
        {R"j({"for all": [{"name": "n", "of": "numbers"}], "holds": {"numbers": ["length(W,n)", "=", "2^(n-1)*2"]}})j",
         "proved", R"j({"by": "recurrences", "orders": {"n": 2}})j"},
        {R"j({"for all": [{"name": "n", "of": "numbers"}], "holds": {"numbers": ["length(F,n)", "=", "n+1"]}})j",
         "refuted",
         R"j({"by": "instance", "values": {"n": 3}, "members": [], "with": [], "proof": {"by": "values"}})j"},
        {R"j({"for all": [{"name": "n", "of": "numbers"}], "with": [{"numbers": ["4", "<=", "n"]}], "holds": {"numbers": ["n^2", "<=", "length(W,n)"]}})j",
         "proved",
         R"j({"by": "positive", "larger": "right", "from": 0, "roots": ["1", "1", "1"], "recurrence": ["2"]})j"},
        {R"j({"for all": [{"name": "n", "of": "numbers"}], "holds": {"words": [[{"system": "F", "generation": "n+2"}], "==", [{"system": "F", "generation": "n+1"}, {"system": "F", "generation": "n"}]]}})j",
         "proved", R"j({"by": "morphism", "morphism": {"a": "a b", "b": "a"}})j"},
        {R"({"growth": "P", "class": "polynomial", "degree": 1})", "proved",
         R"({"by": "components"})"},
        {R"({"growth": "W", "class": "exponential"})", "proved", R"({"by": "components"})"},
        {R"({"growth": "S", "class": "polynomial"})", "refuted", R"({"by": "components"})"},
        {R"({"equal": [{"generated": "P"}, {"generated": "P"}]})", "proved",
         R"({"by": "sections", "words": [[0, 0]], "sections": [{"left": 1, "step": 1, "right": 1, "stride": 1,
             "proof": {"by": "balance", "bound": 0, "states": [{"ahead": "left", "word": ""}]}}]})"},
    };
    return all;
}

/// A certificate with one statement.
inline Json certificate(const Json& statement, const Json& verdict, const Json& proof) {
    return {{"format", "algae certificate 1"},
            {"claim", "a sample"},
            {"alphabet", {"a", "b"}},
            {"systems", systems()},
            {"statements", Json::array({{{"text", "as it is"},
                                         {"statement", statement},
                                         {"verdict", verdict},
                                         {"proof", proof}}})}};
}

inline Json certificate(const Sample& sample) {
    return certificate(Json::parse(sample.statement), sample.verdict, Json::parse(sample.proof));
}

/// A budget that small certificates stay far below.
inline algae::Budget small_budget() {
    algae::Budget budget;
    budget.memory = 4 << 20;
    budget.letters = 100'000;
    budget.deadline = std::chrono::steady_clock::now() + std::chrono::seconds(2);
    return budget;
}

inline std::vector<algae::verify::Finding> check(const Json& certificate,
                                                 const algae::Budget& budget = small_budget()) {
    return algae::verify::check_certificate(certificate.dump(1), "x.json", budget);
}

}  // namespace samples
