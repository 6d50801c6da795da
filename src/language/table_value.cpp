#include "language/table_value.hpp"

#include <algorithm>
#include <vector>

#include "language/construct_draft.hpp"
#include "language/construct_e0l.hpp"
#include "language/construct_image.hpp"
#include "language/construct_reversal.hpp"
#include "language/construct_tables.hpp"
#include "language/known_value.hpp"

namespace algae {

namespace {

using Kind = LanguageTree::Kind;

std::string name_of(Kind kind) {
    switch (kind) {
        case Kind::united:
            return "union";
        case Kind::concatenated:
            return "concatenation";
        case Kind::plus:
            return "plus";
        case Kind::star:
            return "star";
        case Kind::reversed:
            return "reversal";
        case Kind::image:
            return "homomorphism";
        case Kind::intersected:
            return "intersection with a regular language";
        default:
            return "inverse homomorphism";
    }
}

/// The constructions by which a system is put together. With one table they keep it where they can.
class Construction {
public:
    Construction(const Alphabet& alphabet, bool deterministic, const Budget& budget)
        : alphabet_(alphabet), deterministic_(deterministic), budget_(budget) {}

    std::optional<ET0L> of(const Language& language) {
        budget_.check();
        const LanguageTree& tree = *language;
        if (tree.kind == Kind::generated) {
            if (!tree.system->tables || (deterministic_ && !is_deterministic(*tree.system->tables))) return std::nullopt;
            return tree.system->tables;
        }
        if (const auto words = finite_value(language, alphabet_, budget_)) return finite(words->words);
        std::vector<ET0L> parts;
        for (const Language& part : tree.parts) {
            auto system = of(part);
            if (!system) return std::nullopt;
            parts.push_back(std::move(*system));
        }
        auto made = constructed(tree, parts);
        if (made) used_.push_back(name_of(tree.kind));
        return made;
    }

    const std::vector<std::string>& used() const { return used_; }

private:
    /// A new letter becomes the words of a finite language: in one table, or in one each.
    ET0L finite(const std::vector<Word>& words) const {
        Draft draft(alphabet_, deterministic_ ? std::max<std::size_t>(words.size(), 1) : 1);
        const Symbol start = draft.fresh("S");
        std::size_t table = 0;
        for (const Word& word : words) {
            Word successor;
            for (const Symbol a : word) successor.push_back(draft.terminal(alphabet_.name(a)));
            draft.add_rule(deterministic_ ? table++ : 0, start, successor);
        }
        draft.keep_terminals();
        return draft.system({start}, {});
    }

    std::optional<ET0L> constructed(const LanguageTree& tree, const std::vector<ET0L>& parts) const {
        const bool one = !deterministic_ && std::all_of(parts.begin(), parts.end(), [](const ET0L& part) { return part.tables.size() == 1; });
        switch (tree.kind) {
            case Kind::united:
                return one ? e0l_union(parts[0], parts[1]) : table_union(parts[0], parts[1]);
            case Kind::concatenated:
                return one ? e0l_concatenation(parts[0], parts[1]) : table_concatenation(parts[0], parts[1]);
            case Kind::plus:
                return one ? e0l_plus(parts[0]) : table_plus(parts[0]);
            case Kind::star:
                return one ? e0l_star(parts[0]) : table_star(parts[0]);
            case Kind::reversed:
                return reversed(parts[0]);
            case Kind::image:
                return one ? e0l_image(parts[0], substitution(tree.morphism), budget_) : table_image(parts[0], substitution(tree.morphism));
            default:
                return std::nullopt;
        }
    }

    const Alphabet& alphabet_;
    bool deterministic_;
    const Budget& budget_;
    std::vector<std::string> used_;
};

}  // namespace

std::optional<TableValue> table_value(const Language& language, const Alphabet& alphabet, const Budget& budget, bool deterministic) {
    Construction construction(alphabet, deterministic, budget);
    std::optional<ET0L> system = construction.of(language);
    if (!system) return std::nullopt;
    std::string steps;
    for (const std::string& step : construction.used()) steps += (steps.empty() ? "" : ", ") + step;
    std::string argument = "A system for " + to_string(language, alphabet);
    if (!steps.empty()) argument += " is constructed (" + steps + ")";
    else argument += " is at hand";
    const std::size_t tables = system->tables.size();
    argument += ": " + family_name(*system) + " with " + std::to_string(accessible_letters(*system).size()) + " letters and " + std::to_string(tables) + (tables == 1 ? " table." : " tables.");
    return TableValue{std::move(*system), std::move(argument)};
}

}  // namespace algae
