#include <algorithm>

#include "base/error.hpp"
#include "verify/contains.hpp"
#include "verify/proofs.hpp"

namespace algae::verify {

void check_steps(const Checking& with, const System& system, const Word& from, const Word& to,
                 const Field& field) {
    const auto words = field.at("words").list();
    if (words.empty()) field.at("words").refuse("a derivation has a word");
    std::vector<Field> tables;
    if (field.has("tables")) {
        if (system.context) field.at("tables").refuse("the system has no tables");
        tables = field.at("tables").list();
        if (tables.size() + 1 != words.size())
            field.at("tables").refuse("there is not one table for each step");
    } else if (system.tables.size() > 1 && words.size() > 1) {
        field.refuse(
            "the system has several tables, and the derivation does not say which are used");
    }
    Word word = with.reader.word(words[0]);
    if (word != from) words[0].refuse("the derivation does not begin with the word it should");
    for (std::size_t i = 1; i < words.size(); ++i) {
        with.budget.check();
        const Word next = with.reader.word(words[i]);
        if (system.context) {
            if (next_word(system, word) != next)
                words[i].refuse("the word before gives another word");
        } else {
            const std::uint64_t table = tables.empty() ? 0 : tables[i - 1].number();
            if (table >= system.tables.size()) tables[i - 1].refuse("there is no such table");
            if (!may_give(system.tables[static_cast<std::size_t>(table)], word, next))
                words[i].refuse("the word before does not give it");
        }
        word = next;
    }
    if (word != to) words.back().refuse("the derivation does not end with the word it should");
}

void check_derivation(const Checking& with, const Statement& statement, bool holds,
                      const Field& proof, const std::string& by) {
    const System& system = *statement.systems[0].system;
    const Word from = statement.from.value_or(system.axiom);
    if (holds && by == "derivation") {
        proof.only({"by", "words", "tables"});
        check_steps(with, system, from, statement.word, proof);
        if (statement.steps && *statement.steps + 1 != proof.at("words").list().size())
            proof.at("words").refuse("the derivation has another number of steps");
        return;
    }
    if (holds || by != "exhausted") wrong_kind(proof, by);
    proof.only({"by"});
    if (derives(system, from, statement.word, statement.steps, with.budget))
        proof.refuse("the word is derived");
}

void check_membership(const Checking& with, const Statement& statement, bool holds,
                      const Field& proof, const std::string& by) {
    if (by != "membership") wrong_kind(proof, by);
    proof.only({"by", "derivation", "preimage"});
    const Language& language = statement.languages[0];
    if (proof.has("preimage")) {
        const Field preimage = proof.at("preimage");
        const Word word = with.reader.word(preimage);
        if (!holds || proof.has("derivation") || language->kind != Tree::Kind::image)
            preimage.refuse("this does not show it");
        if (image_of(word, language->morphism, with.budget) != statement.word)
            preimage.refuse("the word is not its image");
        if (!contains(language->parts[0], word, with.alphabet(), with.budget))
            preimage.refuse("it is not in the language whose image this is");
        return;
    }
    if (proof.has("derivation")) {
        const Field derivation = proof.at("derivation");
        derivation.only({"words", "tables"});
        Language source = language;  // of a reversal, the derivation is that of the reversed word
        Word word = statement.word;
        for (; source->kind == Tree::Kind::reversal; source = source->parts[0])
            std::reverse(word.begin(), word.end());
        if (source->kind != Tree::Kind::generated)
            derivation.refuse("the language is not given by a system");
        if (!holds)
            derivation.refuse("a derivation does not show that a word is not in a language");
        const System& system = *source->system;
        check_steps(with, system, system.axiom, word, derivation);
        if (!std::all_of(word.begin(), word.end(), [&](Symbol a) { return system.terminal[a]; }))
            derivation.refuse("a letter of the word is no terminal");
        return;
    }
    if (contains(language, statement.word, with.alphabet(), with.budget) != holds)
        proof.refuse(holds ? "the word is not in the language" : "the word is in the language");
}

}  // namespace algae::verify
