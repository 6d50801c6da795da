#include "lesson/own_statement.hpp"

#include <charconv>
#include <set>

#include "base/error.hpp"
#include "claim/sentences.hpp"
#include "notation/claim_families.hpp"
#include "notation/claim_rewriting.hpp"
#include "notation/claim_scanner.hpp"
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

[[noreturn]] void refuse(const Demand& demand, const std::string& expected) {
    throw Error(to_string(demand.place) + ": expected " + expected + " in '" + demand.text + "'");
}

std::uint64_t read_number(ClaimScanner& scanner, const Demand& demand) {
    const std::string_view rest = scanner.rest();
    std::uint64_t number = 0;
    const auto [stop, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
    if (error != std::errc()) refuse(demand, "a number");
    scanner.here = stop;
    return number;
}

Judgement judge_form(ClaimScanner& scanner, const Demand& demand, const LSystem& answer) {
    const std::string name(scanner.take_piece());
    std::string reason;
    if (const auto form = system_form(name)) {
        reason = misfit(answer, *form);
    } else if (is_rewriting_family(name)) {
        reason = misfit(answer, name);
    } else {
        refuse(demand, "the name of a form of systems");
    }
    const std::string is = class_of(answer).name();
    return found(reason.empty(), reason.empty()
                                     ? "Your system is " + with_article(is) + " system."
                                     : "Your system is no " + name + " system: " + reason + ".");
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

Judgement judge_count(ClaimScanner& scanner, const Demand& demand, const LSystem& answer) {
    const bool at_most = scanner.take_word("at") && scanner.take_word("most");
    const std::uint64_t asked = read_number(scanner, demand);
    const std::string noun(scanner.take_piece());
    std::size_t count = 0;
    std::string singular;
    if (noun.starts_with("rule")) {
        count = answer.rules.size();
        singular = "rule";
    } else if (noun.starts_with("letter")) {
        count = letters(answer);
        singular = "letter";
    } else if (noun == "axiom") {
        count = answer.axiom.letters.size();
        singular = "symbol";
    } else {
        refuse(demand, "rules, letters or axiom symbols");
    }
    return found(at_most ? count <= asked : count == asked,
                 (noun == "axiom" ? "The axiom of your system has " : "Your system has ") +
                     counted(count, singular) + ".");
}

struct NamedFigure {
    std::string name;
    Outline outline;
};

NamedFigure read_figure(ClaimScanner& scanner, const Demand& demand, const LSystem& answer,
                        const SystemSource& open, const Budget& budget) {
    if (!scanner.take_word("figure") || !scanner.take("("))
        refuse(demand, "figure(SYSTEM, GENERATION)");
    const std::string_view rest = scanner.rest();
    const std::string name(rest.substr(0, rest.find_first_of(", )")));
    scanner.here += name.size();
    if (!scanner.take(",")) refuse(demand, "a generation");
    const std::uint64_t n = read_number(scanner, demand);
    if (!scanner.take(")")) refuse(demand, "')'");
    const std::string generation = "generation " + std::to_string(n) + " of ";
    if (name == "answer") return {generation + "your system", outline(answer, n, budget)};
    return {generation + name, outline(open(name), n, budget)};
}

enum class Relation { similar, congruent, same };

Relation read_relation(ClaimScanner& scanner, const Demand& demand) {
    if (scanner.take("==")) return Relation::same;
    if (scanner.take_word("is")) {
        const bool congruent = scanner.take_word("congruent");
        if ((congruent || scanner.take_word("similar")) && scanner.take_word("to"))
            return congruent ? Relation::congruent : Relation::similar;
    }
    refuse(demand, "'is similar to', 'is congruent to' or '=='");
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

Judgement judge_figures(ClaimScanner& scanner, const Demand& demand, const LSystem& answer,
                        const SystemSource& open, const Budget& budget) {
    const NamedFigure left = read_figure(scanner, demand, answer, open, budget);
    const Relation relation = read_relation(scanner, demand);
    const NamedFigure right = read_figure(scanner, demand, answer, open, budget);
    const Similarity compared = similarity(left.outline, left.name, right.outline, right.name);
    if (!compared.similar) return found(false, compared.difference);
    if (relation != Relation::similar && !compared.same_size)
        return found(false, "The figures have the same form, but not the same size.");
    if (relation == Relation::same && !compared.same_place)
        return found(false,
                     "The figures have the same form and size, but do not lie in the same place.");
    const bool exact = compared.exact && relation != Relation::same;
    return found(true, all_parts(left.outline) +
                           " comes to lie on one of the other figure" +
                           (exact ? ", exactly." : ", as far as rounded numbers show."));
}

}  // namespace

Judgement judge_own_statement(const Demand& demand, const LSystem& answer, const SystemSource& open,
                              const Budget& budget) {
    ClaimScanner scanner(demand.text);
    if (scanner.name() == "figure") return judge_figures(scanner, demand, answer, open, budget);
    scanner.take_word("answer");
    if (scanner.take_word("has")) return judge_count(scanner, demand, answer);
    if (!scanner.take_word("is")) refuse(demand, "'is' or 'has'");
    return judge_form(scanner, demand, answer);
}

}  // namespace algae
