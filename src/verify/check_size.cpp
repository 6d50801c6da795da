#include <algorithm>

#include "base/error.hpp"
#include "verify/contains.hpp"
#include "verify/derivatives.hpp"
#include "verify/proofs.hpp"
#include "verify/values.hpp"
#include "verify/within_regular.hpp"

namespace algae::verify {

namespace {

void check_values(const Checking& with, const Statement& statement, bool holds,
                  const Field& proof) {
    proof.only({"by"});
    const auto words = finite_values(statement.languages[0], with.alphabet(), with.budget);
    bool found = false;
    switch (statement.kind) {
        case Statement::Kind::finite:
            found = words.has_value();
            break;
        case Statement::Kind::empty:
            found = words && words->empty();
            break;
        default:
            found = words && *statement.size == words->size();
            break;
    }
    if (found == holds) return;
    proof.refuse(words ? "the language has " + std::to_string(words->size()) + " words"
                       : "the language is infinite");
}

}  // namespace

void check_size(const Checking& with, const Statement& statement, bool holds, const Field& proof,
                const std::string& by) {
    const Language& language = statement.languages[0];
    const bool of_empty = statement.kind == Statement::Kind::empty;
    if (by == "values") return check_values(with, statement, holds, proof);
    if (of_empty && holds && by == "relations") {
        proof.only({"by"});
        try {
            if (within_regular(language, words_of({}), with.alphabet(), with.budget)) return;
        } catch (const Error& error) {
            proof.refuse(error.what());
        }
        proof.refuse("the language has a word");
    }
    if (of_empty && !holds && by == "word") {
        proof.only({"by", "word"});
        const Word word = with.reader.word(proof.at("word"));
        if (contains(language, word, with.alphabet(), with.budget)) return;
        proof.at("word").refuse("the word is not in the language");
    }
    if (of_empty || holds) wrong_kind(proof, by);
    if (statement.kind == Statement::Kind::finite) return check_infinite(with, language, proof, by);
    if (by != "infinite") wrong_kind(proof, by);
    proof.only({"by", "proof"});
    const Field infinite = proof.at("proof");
    check_infinite(with, language, infinite, infinite.at("by").text());
}

}  // namespace algae::verify
