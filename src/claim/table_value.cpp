#include "claim/table_value.hpp"

#include <algorithm>
#include <vector>

#include "claim/known_value.hpp"
#include "claim/sentences.hpp"
#include "language/construct_draft.hpp"
#include "language/construct_e0l.hpp"
#include "language/construct_gsm.hpp"
#include "language/construct_image.hpp"
#include "language/construct_inverse_image.hpp"
#include "language/construct_reversal.hpp"
#include "language/construct_tables.hpp"

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
            if (!tree.system->tables || (deterministic_ && !is_deterministic(*tree.system->tables)))
                return regular(language);
            return tree.system->tables;
        }
        if (tree.kind == Kind::words) return finite(tree.words);
        if (auto made = tree.kind == Kind::intersected || tree.kind == Kind::difference
                            ? filtered(tree)
                            : operated(tree)) {
            used_.push_back(name_of(tree.kind));
            return made;
        }
        return regular(language);
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

    /// The operation on the systems of the parts.
    std::optional<ET0L> operated(const LanguageTree& tree) {
        std::vector<ET0L> parts;
        for (const Language& part : tree.parts) {
            auto system = of(part);
            if (!system) return std::nullopt;
            parts.push_back(std::move(*system));
        }
        return constructed(tree, parts);
    }

    /// A system for one part, intersected with the other if that is regular, or with the complement of it.
    std::optional<ET0L> filtered(const LanguageTree& tree) {
        for (const std::size_t i : {0u, 1u}) {
            if (tree.kind == Kind::difference && i == 1) break;
            auto filter = regular_value(tree.parts[1 - i], alphabet_, budget_);
            if (!filter) continue;
            if (tree.kind == Kind::difference)
                filter = complement(*filter, letters_of(tree.parts[0]), budget_);
            const auto system = of(tree.parts[i]);
            if (!system) continue;
            return one_table(*system) ? e0l_intersection(*system, *filter, budget_)
                                      : table_intersection(*system, *filter, budget_);
        }
        return std::nullopt;
    }

    /// A system for all words over some letters, intersected with the language.
    std::optional<ET0L> regular(const Language& language) {
        const auto known = regular_value(language, alphabet_, budget_);
        if (!known) return std::nullopt;
        const std::vector<Symbol> letters = letters_of(language);
        Draft draft(alphabet_, deterministic_ ? letters.size() + 1 : 1);
        const Symbol start = draft.fresh("S");
        std::size_t table = 0;
        for (const Symbol a : letters) {
            draft.add_rule(table, start, {draft.terminal(alphabet_.name(a)), start});
            if (deterministic_) ++table;
        }
        draft.add_rule(table, start, {});
        draft.keep_terminals();
        const ET0L all = draft.system({start}, {});
        return one_table(all) ? e0l_intersection(all, *known, budget_)
                              : table_intersection(all, *known, budget_);
    }

    bool one_table(const ET0L& system) const {
        return !deterministic_ && system.tables.size() == 1;
    }

    /// The image; words with a letter that has none are left out first.
    ET0L mapped(const LanguageTree& tree, const ET0L& part, bool one) const {
        std::map<Symbol, Word> images = tree.morphism;
        for (const Symbol a : letters_of(tree.parts[0])) images.try_emplace(a);
        if (images.size() == tree.morphism.size())
            return one ? e0l_image(part, substitution(images), budget_)
                       : table_image(part, substitution(images));
        const RegularLanguage with_images = all_words(domain_of(tree.morphism));
        const ET0L kept = one ? e0l_intersection(part, with_images, budget_)
                              : table_intersection(part, with_images, budget_);
        return one_table(kept) ? e0l_image(kept, substitution(images), budget_)
                               : table_image(kept, substitution(images));
    }

    std::optional<ET0L> constructed(const LanguageTree& tree,
                                    const std::vector<ET0L>& parts) const {
        const bool one = std::all_of(parts.begin(), parts.end(),
                                     [&](const ET0L& part) { return one_table(part); });
        switch (tree.kind) {
            case Kind::united:
                return one ? e0l_union(parts[0], parts[1]) : table_union(parts[0], parts[1]);
            case Kind::concatenated:
                return one ? e0l_concatenation(parts[0], parts[1])
                           : table_concatenation(parts[0], parts[1]);
            case Kind::plus:
                return one ? e0l_plus(parts[0]) : table_plus(parts[0]);
            case Kind::star:
                return one ? e0l_star(parts[0]) : table_star(parts[0]);
            case Kind::reversed:
                return reversed(parts[0]);
            case Kind::image:
                return mapped(tree, parts[0], one);
            case Kind::inverse_image:
                return table_inverse_image(parts[0], tree.morphism, budget_);
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

std::optional<TableValue> table_value(const Language& language, const Alphabet& alphabet,
                                      const Budget& budget, bool deterministic) {
    Construction construction(alphabet, deterministic, budget);
    std::optional<ET0L> system = construction.of(language);
    if (!system) return std::nullopt;
    std::string steps;
    for (const std::string& step : construction.used()) steps += (steps.empty() ? "" : ", ") + step;
    std::string argument = "A system for " + to_string(language, alphabet);
    if (!steps.empty())
        argument += " is constructed (" + steps + ")";
    else
        argument += " is at hand";
    argument += ": " + with_article(family_name(*system)) + " system with " +
                counted(accessible_letters(*system).size(), "letter") + " and " +
                counted(system->tables.size(), "table") + ".";
    return TableValue{std::move(*system), std::move(argument)};
}

}  // namespace algae
