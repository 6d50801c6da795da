#include "claim/known_value.hpp"

#include <algorithm>

#include "claim/judge_membership.hpp"
#include "claim/table_value.hpp"
#include "exact/integer.hpp"
#include "fold/interaction.hpp"
#include "language/regular_images.hpp"
#include "language/regular_words.hpp"
#include "language/tables_finiteness.hpp"
#include "language/tables_words.hpp"
#include "word/spelling.hpp"

namespace algae {

namespace {

using Kind = LanguageTree::Kind;

constexpr std::size_t most_words = 100'000;
constexpr std::size_t most_shown = 40;

std::string words_text(const std::vector<Word>& words, const Alphabet& alphabet) {
    if (words.size() > most_shown) return "a set of " + std::to_string(words.size()) + " words";
    return to_string(words_language(words), alphabet);
}

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
        const std::size_t before = argument_.size();
        std::optional<std::vector<Word>> words = words_of(*language);
        if (!words) {
            argument_.resize(before);
            return std::nullopt;
        }
        if (language->kind != Kind::words || !language->name.empty()) say(language, *words);
        return FiniteValue{std::move(*words), argument_};
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
                return mapped(tree,
                              [&](const Word& word) { return image_of(word, tree.morphism); });
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

    void say(const Language& language, const std::vector<Word>& words) {
        const LanguageTree unnamed = [&] {
            LanguageTree tree = *language;
            tree.name.clear();
            return tree;
        }();
        const std::string inner =
            to_string(std::make_shared<const LanguageTree>(unnamed), alphabet_);
        std::string line = language->name.empty() ? "" : language->name + " = ";
        const std::string value = words_text(words, alphabet_);
        line += inner == value ? inner : inner + " = " + value;
        line += '.';
        if (std::find(argument_.begin(), argument_.end(), line) == argument_.end())
            argument_.push_back(std::move(line));
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
        std::vector<std::string> lines;
        for (const Word& word : words) {
            const Judgement found = judge_membership(by, word, alphabet_, budget_);
            if (found.truth == Truth::undecided) return std::nullopt;
            if ((found.truth == Truth::proved) == keep) kept.push_back(word);
            if (lines.size() < most_shown)
                lines.insert(lines.end(), found.argument.begin(), found.argument.end());
        }
        if (by->kind != Kind::words) argument_.insert(argument_.end(), lines.begin(), lines.end());
        return kept;
    }

    std::optional<std::vector<Word>> generated(const SourceSystem& system) {
        if (!system.tables) return repeating(*system.interactive);
        if (!finiteness(*system.tables, budget_).finite) return std::nullopt;
        return listed(finite_words(*system.tables, budget_), budget_);
    }

    /// The words of a system with context whose words repeat soon.
    std::optional<std::vector<Word>> repeating(const IL& system) {
        std::vector<Word> words{system.axiom};
        std::size_t letters = words.back().size();
        while (words.size() < 1000 && letters < 1'000'000) {
            budget_.check();
            Word next = next_word(system, words.back());
            letters += next.size();
            if (std::find(words.begin(), words.end(), next) != words.end())
                return sorted(std::move(words));
            words.push_back(std::move(next));
        }
        return std::nullopt;
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
    std::vector<std::string> argument_;
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

std::optional<Word> image_of(const Word& word, const std::map<Symbol, Word>& morphism) {
    Word result;
    for (const Symbol a : word) {
        const auto found = morphism.find(a);
        if (found == morphism.end()) return std::nullopt;
        result.insert(result.end(), found->second.begin(), found->second.end());
    }
    return result;
}

std::vector<Symbol> domain_of(const std::map<Symbol, Word>& morphism) {
    std::vector<Symbol> domain;
    for (const auto& [a, image] : morphism) domain.push_back(a);
    return domain;
}

std::vector<Word> images_by_symbol(const std::map<Symbol, Word>& morphism) {
    std::vector<Word> images(morphism.empty() ? 0 : morphism.rbegin()->first + 1);
    for (const auto& [a, image] : morphism) images[a] = image;
    return images;
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
            return image(intersected(parts[0], all_words(domain_of(tree.morphism)), budget),
                         images_by_symbol(tree.morphism), budget);
        default:
            return inverse_image(parts[0], images_by_symbol(tree.morphism),
                                 domain_of(tree.morphism));
    }
}

}  // namespace algae
