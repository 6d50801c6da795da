#include "verify/contains.hpp"
#include "verify/derivatives.hpp"
#include "verify/proofs.hpp"

namespace algae::verify {

namespace {

Language with_morphism(Tree::Kind kind, std::map<Symbol, Word> morphism, Language part) {
    Tree tree;
    tree.kind = kind;
    tree.morphism = std::move(morphism);
    tree.parts = {std::move(part)};
    return std::make_shared<const Tree>(std::move(tree));
}

/// The words that come in one step from shorter words of the language, by successors that are not empty:
/// of words over new letters, one for each rule, that spell a word of the language.
Language longer_words(const System& system, const Language& language) {
    std::map<Symbol, Word> predecessors, successors;
    std::vector<Word> rules, longer;
    const auto& table = system.tables.front();
    auto rule = static_cast<Symbol>(table.size());
    for (Symbol a = 0; a < table.size(); ++a)
        for (const Word& word : table[a]) {
            if (word.empty()) continue;
            predecessors[rule] = {a};
            successors[rule] = word;
            rules.push_back({rule});
            if (word.size() > 1) longer.push_back({rule});
            ++rule;
        }
    const Language any = combination(Tree::Kind::star, {words_of(std::move(rules))});
    const Language one_longer = combination(
        Tree::Kind::concatenation,
        {any, combination(Tree::Kind::concatenation, {words_of(std::move(longer)), any})});
    const Language uses = combination(
        Tree::Kind::intersection,
        {with_morphism(Tree::Kind::inverse_image, std::move(predecessors), language), one_longer});
    return with_morphism(Tree::Kind::image, std::move(successors), uses);
}

}  // namespace

void check_induction(const Checking& with, const Language& left, const Language& right,
                     const Field& proof) {
    proof.only({"by", "base"});
    if (right->kind != Tree::Kind::generated || right->system->context ||
        right->system->tables.size() != 1 || !has_only_terminals(*right->system))
        proof.refuse("the right language is not given by an 0L system");
    const auto base = proof.at("base").list();
    std::vector<Word> words;
    for (const Field& each : base) {
        words.push_back(with.reader.word(each));
        if (!contains(right, words.back(), with.alphabet(), with.budget))
            each.refuse("the word is not in the right language");
    }
    Derivatives derivatives(with.alphabet(), with.budget);
    const Language steps = longer_words(*right->system, left);
    const auto all =
        derivatives.term(combination(Tree::Kind::united, {steps, words_of(std::move(words))}));
    if (!derivatives.included(derivatives.term(left), all))
        proof.refuse("a word that is not in the base does not come from a shorter word");
}

}  // namespace algae::verify
