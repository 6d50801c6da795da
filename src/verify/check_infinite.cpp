#include <algorithm>

#include "base/error.hpp"
#include "verify/contains.hpp"
#include "verify/derivatives.hpp"
#include "verify/endless_tables.hpp"
#include "verify/proofs.hpp"
#include "verify/within_regular.hpp"

namespace algae::verify {

namespace {

struct RoundRule {
    Symbol letter = 0;
    Word successor;
};

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
    if (!lasting_letters(table).contains(other))
        proof.at("other").refuse("the letter is gone after some steps, whatever it becomes");
}

void check_pumping(const Checking& with, const Language& language, const Field& proof) {
    proof.only({"by", "prefix", "middle", "suffix"});
    check_regular(with, language, proof);
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

/// Throws Flaw if no word is known to be in the language.
void check_has_word(const Checking& with, const Language& language, const Field& proof) {
    try {
        if (!within_regular(language, words_of({}), with.alphabet(), with.budget)) return;
    } catch (const Error& error) {
        throw BoundReached(Bound::method,
                           std::string("whether the other part has a word: ") + error.what());
    }
    proof.refuse("the other part has no word");
}

void check_part(const Checking& with, const Language& language, const Field& proof) {
    proof.only({"by", "index", "proof"});
    const std::uint64_t index = proof.at("index").number();
    switch (language->kind) {
        case Tree::Kind::united:
        case Tree::Kind::concatenation:
        case Tree::Kind::star:
        case Tree::Kind::plus:
        case Tree::Kind::reversal:
            break;
        default:
            proof.refuse("an infinite part does not make this infinite");
    }
    if (index >= language->parts.size()) proof.at("index").refuse("there is no such part");
    if (language->kind == Tree::Kind::concatenation)
        check_has_word(with, language->parts[1 - static_cast<std::size_t>(index)], proof);
    const Field part = proof.at("proof");
    check_infinite(with, language->parts[static_cast<std::size_t>(index)], part,
                   part.at("by").text());
}

}  // namespace

void check_infinite(const Checking& with, const Language& language, const Field& proof,
                    const std::string& by) {
    if (by == "endless round") return check_round(with, language, proof);
    if (by == "endless tables") return check_endless_tables(with, language, proof);
    if (by == "pumping") return check_pumping(with, language, proof);
    if (by == "part") return check_part(with, language, proof);
    wrong_kind(proof, by);
}

}  // namespace algae::verify
