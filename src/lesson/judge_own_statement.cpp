#include "lesson/judge_own_statement.hpp"

#include <set>

#include "claim/sentences.hpp"
#include "notation/claim_families.hpp"
#include "notation/claim_rewriting.hpp"
#include "system/classes.hpp"
#include "turtle/similarity.hpp"

namespace algae {

namespace {

Judgement found(bool holds, std::string sentence) {
    Judgement judgement;
    judgement.truth = holds ? Truth::proved : Truth::refuted;
    judgement.argument.push_back(std::move(sentence));
    return judgement;
}

Judgement judge_form(const OwnStatement& asked, const LSystem& answer) {
    const auto form = system_form(asked.form);
    const std::string reason = form ? misfit(answer, *form) : misfit(answer, asked.form);
    const std::string is = class_of(answer).name();
    return found(reason.empty(),
                 reason.empty() ? "Your system is " + with_article(is) + " system."
                                : "Your system is no " + asked.form + " system: " + reason + ".");
}

/// The symbols that stand in the axiom or a rule.
std::size_t letters(const LSystem& system) {
    std::set<Symbol> all(system.axiom.letters.begin(), system.axiom.letters.end());
    for (const Production& rule : system.rules) {
        all.insert(rule.predecessor.symbol);
        all.insert(rule.successor.letters.begin(), rule.successor.letters.end());
    }
    return all.size();
}

std::size_t count_of(OwnStatement::Counted counted, const LSystem& system) {
    switch (counted) {
        case OwnStatement::Counted::rules:
            return system.rules.size();
        case OwnStatement::Counted::letters:
            return letters(system);
        case OwnStatement::Counted::axiom_symbols:
            return system.axiom.letters.size();
    }
    return 0;
}

Judgement judge_count(const OwnStatement& asked, const LSystem& answer) {
    const std::size_t count = count_of(asked.counted, answer);
    const bool of_axiom = asked.counted == OwnStatement::Counted::axiom_symbols;
    const std::string singular = of_axiom                                          ? "symbol"
                                 : asked.counted == OwnStatement::Counted::letters ? "letter"
                                                                                   : "rule";
    return found(asked.at_most ? count <= asked.count : count == asked.count,
                 (of_axiom ? "The axiom of your system has " : "Your system has ") +
                     counted(count, singular) + ".");
}

struct NamedFigure {
    std::string name;
    Outline outline;
};

NamedFigure named_figure(const OwnStatement::Figure& figure, const LSystem& answer,
                         const SystemSource& open, const Budget& budget) {
    const std::uint64_t n = figure.generation;
    const std::string generation = "generation " + std::to_string(n) + " of ";
    if (figure.system == "answer") return {generation + "your system", outline(answer, n, budget)};
    return {generation + figure.system, outline(open(figure.system), n, budget)};
}

std::string all_of(std::size_t count, const std::string& noun) {
    return count == 1 ? "the only " + noun : "each of " + counted(count, noun);
}

/// "Each of 3 strokes and the only filled polygon", without what there is none of.
std::string all_parts(const Outline& outline) {
    std::string text = all_of(outline.strokes.size(), "stroke");
    if (!outline.polygons.empty())
        text = (outline.strokes.empty() ? "" : text + " and ") +
               all_of(outline.polygons.size(), "filled polygon");
    text.front() = text.front() == 'e' ? 'E' : 'T';
    return text;
}

Judgement judge_figures(const OwnStatement& asked, const LSystem& answer, const SystemSource& open,
                        const Budget& budget) {
    using Relation = OwnStatement::Relation;
    const Relation relation = asked.relation;
    const NamedFigure left = named_figure(asked.left, answer, open, budget);
    const NamedFigure right = named_figure(asked.right, answer, open, budget);
    const Similarity compared = similarity(left.outline, left.name, right.outline, right.name);
    if (!compared.similar) return found(false, compared.difference);
    if (relation != Relation::similar && !compared.same_size)
        return found(false, "The figures have the same form, but not the same size.");
    if (relation == Relation::same && !compared.same_place)
        return found(false,
                     "The figures have the same form and size, but do not lie in the same place.");
    const bool exact = compared.exact && relation != Relation::same;
    return found(true, all_parts(left.outline) + " comes to lie on one of the other figure" +
                           (exact ? ", exactly." : ", as far as rounded numbers show."));
}

}  // namespace

Judgement judge_own_statement(const OwnStatement& asked, const LSystem& answer,
                              const SystemSource& open, const Budget& budget) {
    switch (asked.kind) {
        case OwnStatement::Kind::form:
            return judge_form(asked, answer);
        case OwnStatement::Kind::count:
            return judge_count(asked, answer);
        case OwnStatement::Kind::figures:
            break;
    }
    return judge_figures(asked, answer, open, budget);
}

}  // namespace algae
