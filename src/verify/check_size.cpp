#include <algorithm>

#include "base/error.hpp"
#include "verify/contains.hpp"
#include "verify/derivatives.hpp"
#include "verify/proofs.hpp"
#include "verify/values.hpp"
#include "verify/within_regular.hpp"

namespace algae::verify {

namespace {

struct RoundRule {
    Symbol letter = 0;
    Word successor;
};

/// The letters from which some derivation goes on for ever without becoming empty.
std::set<Symbol> lasting(const System::Successors& table) {
    std::set<Symbol> letters;
    for (Symbol a = 0; a < table.size(); ++a) letters.insert(a);
    for (std::size_t before = 0; before != letters.size();) {
        before = letters.size();
        const std::set<Symbol> known = letters;
        for (const Symbol a : known)
            if (std::none_of(table[a].begin(), table[a].end(), [&](const Word& word) {
                    return std::any_of(word.begin(), word.end(),
                                       [&](Symbol b) { return known.contains(b); });
                }))
                letters.erase(a);
    }
    return letters;
}

/// Each rule of the round has the letter of the next one, the last has that of the first; the first has
/// another letter besides that lasts. So there are words with any number of lasting letters.
void check_round(const Checking& with, const Language& language, const Field& proof) {
    proof.only({"by", "rules", "other"});
    if (language->kind != Tree::Kind::generated)
        proof.refuse("the language is not given by a system");
    const System& system = *language->system;
    if (system.context || system.tables.size() != 1 || !has_only_terminals(system))
        proof.refuse("the system is not 0L");
    const auto& table = system.tables.front();
    std::vector<RoundRule> rules;
    for (const Field& field : proof.at("rules").list()) {
        field.only({"letter", "successor"});
        const RoundRule rule{with.reader.letter(field.at("letter")),
                             with.reader.word(field.at("successor"))};
        const auto& all = table[rule.letter];
        if (std::find(all.begin(), all.end(), rule.successor) == all.end())
            field.refuse("the system has no such rule");
        rules.push_back(rule);
    }
    if (rules.empty()) proof.at("rules").refuse("a round has a rule");
    const auto letters = accessible_letters(system, system.axiom);
    if (std::find(letters.begin(), letters.end(), rules[0].letter) == letters.end())
        proof.at("rules").refuse("the letter of the first rule occurs in no derived word");
    for (std::size_t i = 0; i < rules.size(); ++i) {
        const Symbol next = rules[(i + 1) % rules.size()].letter;
        if (std::count(rules[i].successor.begin(), rules[i].successor.end(), next) == 0)
            proof.at("rules").list()[i].refuse(
                "the letter of the next rule is not in its successor");
    }
    const Symbol other = with.reader.letter(proof.at("other"));
    const Symbol next = rules[1 % rules.size()].letter;
    const Word& first = rules[0].successor;
    if (std::count(first.begin(), first.end(), other) < (other == next ? 2 : 1))
        proof.at("other").refuse("the first rule has no such letter besides that of the next rule");
    if (!lasting(table).contains(other))
        proof.at("other").refuse("the letter is gone after some steps, whatever it becomes");
}

void check_pumping(const Checking& with, const Language& language, const Field& proof) {
    proof.only({"by", "prefix", "middle", "suffix"});
    if (!is_regular(language)) proof.refuse("a system occurs in the expression");
    const Word prefix = with.reader.word(proof.at("prefix"));
    const Word middle = with.reader.word(proof.at("middle"));
    const Word suffix = with.reader.word(proof.at("suffix"));
    if (middle.empty()) proof.at("middle").refuse("nothing is repeated");
    Derivatives derivatives(with.alphabet(), with.budget);
    const auto before = derivatives.derivative(derivatives.term(language), prefix);
    if (!derivatives.equal(before, derivatives.derivative(before, middle)))
        proof.at("middle").refuse("what may follow is not the same before and after it");
    if (!derivatives.nullable(derivatives.derivative(before, suffix)))
        proof.at("suffix").refuse("the word is not in the language");
}

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
        } catch (const BoundReached&) {
            throw;
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
    if (by == "endless round") return check_round(with, language, proof);
    if (by == "pumping") return check_pumping(with, language, proof);
    wrong_kind(proof, by);
}

}  // namespace algae::verify
