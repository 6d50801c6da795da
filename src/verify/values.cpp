#include "verify/values.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "verify/contains.hpp"
#include "verify/derivatives.hpp"

namespace algae::verify {

namespace {

using Set = std::set<Word>;

/// A set that may take a part of the budget's memory.
class Bounded {
public:
    explicit Bounded(const Budget& budget) : budget_(budget) {}

    bool insert(Word word) {
        if (++inserted_ % 1024 == 0 || word.size() > 1024) budget_.check();
        const std::uint64_t size = 80 + word.size() * sizeof(Symbol);
        if (!words.insert(std::move(word)).second) return false;
        bytes_ += size;
        if (bytes_ > budget_.memory / 16)
            throw BoundReached(Bound::memory, "the words take more than a sixteenth of the " +
                                                  std::to_string(budget_.memory >> 20) +
                                                  " MiB allowed" + budget_.by(Bound::memory));
        return true;
    }

    Set words;

private:
    const Budget& budget_;
    std::uint64_t bytes_ = 0, inserted_ = 0;
};

Set successors(const System::Successors& table, const Word& word, const Budget& budget) {
    Set built{Word{}};
    for (const Symbol a : word) {
        Bounded longer(budget);
        for (const Word& start : built)
            for (const Word& image : table[a]) {
                Word next = start;
                next.insert(next.end(), image.begin(), image.end());
                longer.insert(std::move(next));
            }
        built = std::move(longer.words);
    }
    return built;
}

Set derived(const System& system, const Budget& budget) {
    Bounded known(budget);
    known.insert(system.axiom);
    std::vector<Word> open{system.axiom};
    while (!open.empty()) {
        const Word word = std::move(open.back());
        open.pop_back();
        Set next;
        if (system.context) next.insert(next_word(system, word));
        for (const auto& table : system.tables) next.merge(successors(table, word, budget));
        for (const Word& each : next)
            if (known.insert(each)) open.push_back(each);
    }
    return std::move(known.words);
}

bool is_terminal(const System& system, const Word& word) {
    return std::all_of(word.begin(), word.end(), [&](Symbol a) { return system.terminal[a]; });
}

/// All words u whose images are this word.
void add_preimages(const std::map<Symbol, Word>& morphism, const Word& word, Bounded& all,
                   const Budget& budget) {
    std::vector<Set> ending(word.size() + 1);  // the words whose images are the first letters
    ending[0].insert(Word{});
    std::uint64_t bytes = 0;
    for (std::size_t done = 0; done < word.size(); ++done)
        for (const Word& start : ending[done])
            for (const auto& [a, image] : morphism) {
                if (image.empty() || image.size() > word.size() - done ||
                    !std::equal(image.begin(), image.end(),
                                word.begin() + static_cast<std::ptrdiff_t>(done)))
                    continue;
                Word longer = start;
                longer.push_back(a);
                bytes += 80 + longer.size() * sizeof(Symbol);
                budget.check_memory(bytes, "the words with these images");
                ending[done + image.size()].insert(std::move(longer));
            }
    for (const Word& each : ending[word.size()]) all.insert(each);
}

class Values {
public:
    Values(const Alphabet& alphabet, const Budget& budget) : alphabet_(alphabet), budget_(budget) {}

    std::optional<Set> of(const Language& language) {
        const Tree& tree = *language;
        switch (tree.kind) {
            case Tree::Kind::words:
            case Tree::Kind::generated: {
                const auto words = finite_values_of_leaf(tree, budget_);
                return Set(words.begin(), words.end());
            }
            case Tree::Kind::united:
                return united(of(tree.parts[0]), of(tree.parts[1]));
            case Tree::Kind::concatenation:
                return concatenated(of(tree.parts[0]), of(tree.parts[1]));
            case Tree::Kind::intersection:
                for (const std::size_t i :
                     {is_regular(tree.parts[0]) ? 0u : 1u, is_regular(tree.parts[0]) ? 1u : 0u})
                    if (auto part = tried(tree.parts[i]))
                        return filtered(*part, tree.parts[1 - i], true);
                return regular(language);
            case Tree::Kind::difference:
                if (auto left = tried(tree.parts[0])) return filtered(*left, tree.parts[1], false);
                return regular(language);
            case Tree::Kind::star:
            case Tree::Kind::plus: {
                auto part = of(tree.parts[0]);
                if (!part) return std::nullopt;
                if (tree.kind == Tree::Kind::star) part->insert(Word{});
                if (std::all_of(part->begin(), part->end(),
                                [](const Word& w) { return w.empty(); }))
                    return part;
                return std::nullopt;
            }
            case Tree::Kind::reversal: {
                const auto part = of(tree.parts[0]);
                if (!part) return std::nullopt;
                Set all;
                for (const Word& word : *part) all.emplace(word.rbegin(), word.rend());
                return all;
            }
            case Tree::Kind::image:
                if (const auto part = tried(tree.parts[0])) return images(*part, tree.morphism);
                return regular(language);
            case Tree::Kind::inverse_image:
                if (const auto part = tried(tree.parts[0])) return preimages(*part, tree.morphism);
                return regular(language);
            case Tree::Kind::complement:
                break;
        }
        return regular(language);
    }

private:
    std::optional<Set> tried(const Language& language) {
        try {
            return of(language);
        } catch (const BoundReached& bound) {
            if (bound.bound() == Bound::time) throw;
            return std::nullopt;  // or not known: whoever asks goes another way
        }
    }

    static std::optional<Set> united(std::optional<Set> left, std::optional<Set> right) {
        if (left && right) left->merge(*right);
        return right ? left : std::nullopt;
    }

    std::optional<Set> concatenated(const std::optional<Set>& left,
                                    const std::optional<Set>& right) const {
        if ((left && left->empty()) || (right && right->empty())) return Set{};
        if (!left || !right) return std::nullopt;
        Bounded all(budget_);
        for (const Word& one : *left)
            for (const Word& other : *right) {
                Word both = one;
                both.insert(both.end(), other.begin(), other.end());
                all.insert(std::move(both));
            }
        return std::move(all.words);
    }

    Set filtered(const Set& words, const Language& by, bool kept) const {
        Set all;
        for (const Word& word : words)
            if (contains(by, word, alphabet_, budget_) == kept) all.insert(word);
        return all;
    }

    Set images(const Set& words, const std::map<Symbol, Word>& morphism) const {
        Bounded all(budget_);
        for (const Word& word : words)
            if (const auto image = image_of(word, morphism, budget_)) all.insert(*image);
        return std::move(all.words);
    }

    std::optional<Set> preimages(const Set& words, const std::map<Symbol, Word>& morphism) const {
        Bounded all(budget_);
        for (const Word& word : words) add_preimages(morphism, word, all, budget_);
        const bool erases = std::any_of(morphism.begin(), morphism.end(),
                                        [](const auto& each) { return each.second.empty(); });
        if (erases && !all.words.empty()) return std::nullopt;
        return std::move(all.words);
    }

    /// By the automaton of derivatives: a word as long as it has states could be pumped.
    std::optional<Set> regular(const Language& language) const {
        Derivatives derivatives(alphabet_, budget_);
        const auto automaton = derivatives.automaton(derivatives.term(language));
        const std::size_t states = automaton.next.size();
        std::vector<char> useful = automaton.accepting;
        for (bool changed = true; changed;) {
            changed = false;
            for (std::size_t i = 0; i < states; ++i)
                for (const std::size_t to : automaton.next[i])
                    if (!useful[i] && useful[to]) {
                        useful[i] = 1;
                        changed = true;
                    }
        }
        Bounded all(budget_);
        std::set<std::pair<Word, std::size_t>> open{{Word{}, 0}};
        for (std::size_t length = 0; length <= states && !open.empty(); ++length) {
            std::set<std::pair<Word, std::size_t>> longer;
            Bounded beginnings(budget_);
            for (const auto& [word, state] : open) {
                if (!useful[state]) continue;
                if (length == states) return std::nullopt;
                if (automaton.accepting[state]) all.insert(word);
                for (Symbol a = 0; a < alphabet_.size(); ++a) {
                    const std::size_t to = automaton.next[state][a];
                    if (!useful[to]) continue;
                    Word next = word;
                    next.push_back(a);
                    beginnings.insert(next);
                    longer.emplace(std::move(next), to);
                }
            }
            open = std::move(longer);
        }
        return std::move(all.words);
    }

    const Alphabet& alphabet_;
    const Budget& budget_;
};

}  // namespace

std::optional<std::set<Word>> finite_values(const Language& language, const Alphabet& alphabet,
                                            const Budget& budget) {
    return Values(alphabet, budget).of(language);
}

std::vector<Word> finite_values_of_leaf(const Tree& leaf, const Budget& budget) {
    if (leaf.kind == Tree::Kind::words) return leaf.words;
    if (is_endless(*leaf.system))
        throw BoundReached(Bound::method, "the words of the system have no end");
    std::vector<Word> words;
    for (const Word& word : derived(*leaf.system, budget))
        if (is_terminal(*leaf.system, word)) words.push_back(word);
    return words;
}

}  // namespace algae::verify
