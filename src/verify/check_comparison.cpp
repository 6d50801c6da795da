#include <algorithm>

#include "base/error.hpp"
#include "verify/contains.hpp"
#include "verify/derivatives.hpp"
#include "verify/proofs.hpp"
#include "verify/values.hpp"
#include "verify/within_regular.hpp"

namespace algae::verify {

namespace {

using Kind = Statement::Kind;

void check_values(const Checking& with, const Statement& statement, bool holds,
                  const Field& proof) {
    const auto left = finite_values(statement.languages[0], with.alphabet(), with.budget);
    if (statement.kind == Kind::included && holds) {
        if (!left) proof.refuse("the left language is infinite");
        for (const Word& word : *left)
            if (!contains(statement.languages[1], word, with.alphabet(), with.budget))
                proof.refuse("a word is in the left language only");
        return;
    }
    const auto right = finite_values(statement.languages[1], with.alphabet(), with.budget);
    if (!left || !right) proof.refuse("one of the languages is infinite");
    const bool found = statement.kind == Kind::equal ? *left == *right
                                                     : std::includes(right->begin(), right->end(),
                                                                     left->begin(), left->end());
    if (found != holds)
        proof.refuse(found ? "every word is in both languages" : "a word is in one language only");
}

void check_derivatives(const Checking& with, const Statement& statement, const Field& proof) {
    Derivatives derivatives(with.alphabet(), with.budget);
    const auto left = derivatives.term(statement.languages[0]);
    const auto right = derivatives.term(statement.languages[1]);
    if (!derivatives.included(left, right)) proof.refuse("a word is in the left language only");
    if (statement.kind == Kind::equal && !derivatives.included(right, left))
        proof.refuse("a word is in the right language only");
}

void check_word(const Checking& with, const Statement& statement, const Field& proof) {
    const Field field = proof.at("word");
    const Word word = with.reader.word(field);
    const auto in = [&](const Language& language) {
        return contains(language, word, with.alphabet(), with.budget);
    };
    const bool left = in(statement.languages[0]), right = in(statement.languages[1]);
    if (left == right)
        field.refuse(left ? "the word is in both languages" : "the word is in neither language");
    if (statement.kind == Kind::included && right)
        field.refuse("the word is in the right language only");
}

/// The sequences of the two systems are equal, so their languages are.
void check_same_sequences(const Checking& with, const Statement& statement, const Field& proof) {
    Statement sequences;
    sequences.kind = Kind::equal_sequences;
    for (const Language& language : statement.languages) {
        if (language->kind != Tree::Kind::generated)
            proof.refuse("a language is not given by a system");
        sequences.systems.push_back({language->name, language->system});
    }
    check_proof(with, sequences, true, proof.at("proof"));
}

void check_both(const Checking& with, const Statement& statement, const Field& proof) {
    const auto [one, other] = proof.at("proofs").pair();
    Statement included;
    included.kind = Kind::included;
    included.languages = statement.languages;
    check_proof(with, included, true, one);
    std::swap(included.languages[0], included.languages[1]);
    check_proof(with, included, true, other);
}

void check_relations(const Checking& with, const Statement& statement, const Field& proof) {
    bool within = false;
    try {
        within = within_regular(statement.languages[0], statement.languages[1], with.alphabet(),
                                with.budget);
    } catch (const Error& error) {
        proof.refuse(error.what());
    }
    if (!within) proof.refuse("a word of the left language is not in the right one");
}

}  // namespace

void check_comparison(const Checking& with, const Statement& statement, bool holds,
                      const Field& proof, const std::string& by) {
    const bool of_equality = statement.kind == Kind::equal;
    if (by == "values") {
        proof.only({"by"});
        check_values(with, statement, holds, proof);
    } else if (!holds) {
        if (by != "word") wrong_kind(proof, by);
        proof.only({"by", "word"});
        check_word(with, statement, proof);
    } else if (by == "derivatives") {
        proof.only({"by"});
        check_derivatives(with, statement, proof);
    } else if (by == "identical") {
        proof.only({"by"});
        if (!same(statement.languages[0], statement.languages[1]))
            proof.refuse("the expressions are not the same");
    } else if (by == "sequences") {
        proof.only({"by", "proof"});
        check_same_sequences(with, statement, proof);
    } else if (by == "sections" && of_equality) {
        for (const Language& language : statement.languages)
            if (language->kind != Tree::Kind::generated || !is_d0l(*language->system))
                proof.refuse("a language is not given by a D0L system");
        check_sections(with, *statement.languages[0]->system, *statement.languages[1]->system,
                       proof);
    } else if (by == "induction" && !of_equality) {
        check_induction(with, statement.languages[0], statement.languages[1], proof);
    } else if (by == "relations" && !of_equality) {
        proof.only({"by"});
        check_relations(with, statement, proof);
    } else if (by == "both" && of_equality) {
        proof.only({"by", "proofs"});
        check_both(with, statement, proof);
    } else {
        wrong_kind(proof, by);
    }
}

}  // namespace algae::verify
