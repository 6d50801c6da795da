#include <algorithm>
#include <map>

#include "exact/exact.hpp"
#include "language/detail/construct.hpp"
#include "language/detail/interactive.hpp"
#include "language/detail/judge.hpp"
#include "language/detail/powers.hpp"
#include "language/detail/proof.hpp"
#include "word/word.hpp"

// What is known of an expression of languages: its words if they are finitely many, its automaton if its parts
// are regular, or a system that constructions make for it.
//
// `finite_value` follows the expression: finite sets, finite languages of systems, and operations on these; of
// an intersection or difference a finite part is enough, whose words are decided one by one. `regular_value` is
// the same for automata. `table_value` puts constructions together; a system with one table keeps it as long as
// the operation allows, and tables stay deterministic if that is asked for. The three call each other: a part
// of one kind may be worked out as another.

namespace algae {

namespace {

using Kind = LanguageTree::Kind;

constexpr std::size_t most_words = 100'000;
/// The words of an automaton that has finitely many, if they are not too many.
std::optional<std::vector<Word>> listed(const RegularLanguage& language, const Budget& budget) {
    const std::optional<Integer> count = number_of_words(language);
    if (!count || *count > Integer(most_words)) return std::nullopt;
    return words_up_to(language, language.automaton().states(), budget);
}

std::vector<Word> sorted(std::vector<Word> words) {
    return words_language(std::move(words))->words;
}

class Finite {
public:
    Finite(const Alphabet& alphabet, const Budget& budget) : alphabet_(alphabet), budget_(budget) {}

    std::optional<FiniteValue> value(const Language& language) {
        const std::size_t before = known_.size();
        std::optional<std::vector<Word>> words = words_of(*language);
        if (!words) {
            known_.resize(before);
            return std::nullopt;
        }
        if (language->kind != Kind::words || !language->name.empty()) {
            const bool shown = words->size() <= steps::Value::most_shown;
            known_.push_back(proof_by(
                steps::Value{language, shown ? *words : std::vector<Word>{}, words->size()}));
        }
        return FiniteValue{std::move(*words), known_};
    }

    /// What intersection or difference leave of a finite part.
    std::optional<std::vector<Word>> left_of_finite(const LanguageTree& tree) {
        if (auto words = part(tree, 0))
            return filtered(*words, tree.parts[1], tree.kind == Kind::intersected);
        if (tree.kind == Kind::difference) return std::nullopt;
        if (auto words = part(tree, 1)) return filtered(*words, tree.parts[0], true);
        return std::nullopt;
    }

private:
    std::optional<std::vector<Word>> words_of(const LanguageTree& tree) {
        budget_.check();
        switch (tree.kind) {
            case Kind::words:
                return tree.words;
            case Kind::generated:
                return generated(*tree.system);
            case Kind::powers:
                return std::nullopt;
            case Kind::intersected:
            case Kind::difference:
                if (auto words = left_of_finite(tree)) return words;
                return as_a_whole(tree);
            case Kind::united:
                return both(tree, [](const auto& left, const auto& right) {
                    std::vector<Word> words = left;
                    words.insert(words.end(), right.begin(), right.end());
                    return words;
                });
            case Kind::concatenated:
                if (auto words = without_parts(tree)) return words;
                return both(tree, [](const auto& left, const auto& right) {
                    std::vector<Word> words;
                    for (const Word& u : left)
                        for (const Word& v : right) {
                            words.push_back(u);
                            words.back().insert(words.back().end(), v.begin(), v.end());
                        }
                    return words;
                });
            case Kind::image:
                return mapped(tree, [&](const Word& word) { return tree.morphism.image_of(word); });
            case Kind::reversed:
                return mapped(tree, [](const Word& word) {
                    return std::optional(Word(word.rbegin(), word.rend()));
                });
            default:
                return as_a_whole(tree);
        }
    }

    /// Of a concatenation of which a part is infinite: it is finite if the other is empty.
    std::optional<std::vector<Word>> without_parts(const LanguageTree& tree) {
        for (const Language& part : tree.parts)
            if (const auto words = finite_part(part); words && words->empty()) return words;
        return std::nullopt;
    }

    /// The words of a part without its argument.
    std::optional<std::vector<Word>> finite_part(const Language& part) {
        auto known = finite_value(part, alphabet_, budget_);
        return known ? std::optional(std::move(known->words)) : std::nullopt;
    }

    std::optional<std::vector<Word>> part(const LanguageTree& tree, std::size_t i) {
        if (auto known = value(tree.parts[i])) return std::move(known->words);
        return std::nullopt;
    }

    template <class Combine>
    std::optional<std::vector<Word>> both(const LanguageTree& tree, Combine combine) {
        const auto left = part(tree, 0);
        if (!left) return std::nullopt;
        const auto right = part(tree, 1);
        if (!right) return std::nullopt;
        if (tree.kind == Kind::concatenated && !left->empty() &&
            right->size() > most_words / left->size())
            return std::nullopt;
        return sorted(combine(*left, *right));
    }

    template <class Map>
    std::optional<std::vector<Word>> mapped(const LanguageTree& tree, Map map) {
        auto words = part(tree, 0);
        if (!words) return std::nullopt;
        std::vector<Word> results;
        for (const Word& word : *words)
            if (std::optional<Word> result = map(word)) results.push_back(std::move(*result));
        return sorted(std::move(results));
    }

    std::optional<std::vector<Word>> filtered(const std::vector<Word>& words, const Language& by,
                                              bool keep) {
        std::vector<Word> kept;
        steps::Sifted sifted;
        for (const Word& word : words) {
            Answer found = judge_membership(by, word, alphabet_, budget_);
            if (found.truth == Truth::undecided) return std::nullopt;
            if ((found.truth == Truth::proved) == keep) kept.push_back(word);
            if (sifted.members.size() < steps::Sifted::most_shown)
                sifted.members.push_back(std::move(found.proof));
        }
        if (by->kind != Kind::words) known_.push_back(proof_by(std::move(sifted)));
        return kept;
    }

    std::optional<std::vector<Word>> generated(const SourceSystem& system) {
        if (!system.tables) return all_words_of(*system.interactive, budget_);
        if (!finiteness(*system.tables, budget_).finite) return std::nullopt;
        return listed(finite_words(*system.tables, budget_), budget_);
    }

    /// Of an expression of regular parts, or one for which a system is constructed.
    std::optional<std::vector<Word>> as_a_whole(const LanguageTree& tree) {
        const Language language = std::make_shared<const LanguageTree>(tree);
        if (const auto known = regular_value(language, alphabet_, budget_))
            return listed(*known, budget_);
        const auto tables = table_value(language, alphabet_, budget_);
        if (!tables || !finiteness(tables->system, budget_).finite) return std::nullopt;
        return listed(finite_words(tables->system, budget_), budget_);
    }

    const Alphabet& alphabet_;
    const Budget& budget_;
    std::vector<Part> known_;
};

}  // namespace

std::optional<FiniteValue> finite_value(const Language& language, const Alphabet& alphabet,
                                        const Budget& budget) {
    return Finite(alphabet, budget).value(language);
}

bool has_system(const Language& language) {
    return language->kind == Kind::generated ||
           std::any_of(language->parts.begin(), language->parts.end(), has_system);
}

std::optional<RegularLanguage> regular_value(const Language& language, const Alphabet& alphabet,
                                             const Budget& budget) {
    const LanguageTree& tree = *language;
    if (tree.kind == Kind::words) return finite_set(tree.words);
    if (tree.kind == Kind::generated) {
        if (tree.system->tables) {
            if (!finiteness(*tree.system->tables, budget).finite) return std::nullopt;
            return finite_words(*tree.system->tables, budget);
        }
        const auto words = finite_value(language, alphabet, budget);
        return words ? std::optional(finite_set(words->words)) : std::nullopt;
    }
    if (tree.kind == Kind::powers) {
        const Language regular = regular_form(*tree.powers);
        return regular ? regular_value(regular, alphabet, budget) : std::nullopt;
    }
    std::vector<RegularLanguage> parts;
    for (const Language& part : tree.parts) {
        auto known = regular_value(part, alphabet, budget);
        if (!known) {
            if (tree.kind != Kind::intersected && tree.kind != Kind::difference)
                return std::nullopt;
            const auto words = Finite(alphabet, budget).left_of_finite(tree);
            return words ? std::optional(finite_set(*words)) : std::nullopt;
        }
        parts.push_back(std::move(*known));
    }
    return operated(tree, parts, budget);
}

RegularLanguage operated(const LanguageTree& tree, const std::vector<RegularLanguage>& parts,
                         const Budget& budget) {
    switch (tree.kind) {
        case Kind::united:
            return united(parts[0], parts[1], budget);
        case Kind::intersected:
            return intersected(parts[0], parts[1], budget);
        case Kind::difference:
            return difference(parts[0], parts[1], budget);
        case Kind::concatenated:
            return concatenated(parts[0], parts[1], budget);
        case Kind::star:
            return star(parts[0], budget);
        case Kind::plus:
            return plus(parts[0], budget);
        case Kind::complement:
            return complement(parts[0], tree.letters, budget);
        case Kind::reversed:
            return reversed(parts[0], budget);
        case Kind::image:
            return image(intersected(parts[0], all_words(tree.morphism.domain()), budget),
                         tree.morphism.images(), budget);
        default:
            return inverse_image(parts[0], tree.morphism.images(), tree.morphism.domain());
    }
}

namespace {

std::string name_of(Kind kind) {
    static const std::map<Kind, std::string> names{
        {Kind::united, "union"},
        {Kind::concatenated, "concatenation"},
        {Kind::plus, "plus"},
        {Kind::star, "star"},
        {Kind::reversed, "reversal"},
        {Kind::image, "homomorphism"},
        {Kind::intersected, "intersection with a regular language"}};
    const auto found = names.find(kind);
    return found == names.end() ? "inverse homomorphism" : found->second;
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
        if (tree.kind == Kind::powers) {
            used_.push_back("powers");
            return system_of(*tree.powers, alphabet_, budget_);
        }
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
        Morphism images = tree.morphism;
        bool has_all = true;
        for (const Symbol a : letters_of(tree.parts[0])) has_all = !images.add(a, {}) && has_all;
        if (has_all)
            return one ? e0l_image(part, substitution(images), budget_)
                       : table_image(part, substitution(images));
        const RegularLanguage with_images = all_words(tree.morphism.domain());
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
    return TableValue{std::move(*system), language, construction.used()};
}

}  // namespace algae
