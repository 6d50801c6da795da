#include <algorithm>
#include <numeric>
#include <set>

#include "exact/exact.hpp"
#include "verify/detail/checking.hpp"
#include "verify/detail/languages.hpp"
#include "watch/watch.hpp"

// Languages of the checker, by the definition of each operation: membership, all words of a finite language, and derivatives of
// regular expressions (Brzozowski 1964).
//
// Membership in L(G) without context goes by tables of which letters derive which factors of the word; with context it
// derives all words up to the length wanted. Everything is exponential in the worst case and bounded by the budget: a bound is a stop
// and judges nothing.

namespace algae::verify {

Derivatives::Derivatives(const Alphabet& alphabet, const Budget& budget)
    : alphabet_(alphabet), budget_(budget) {
    none_ = made({});
    empty_word_ = made({Kind::empty_word, 0, {}});
}

Derivatives::Term Derivatives::made(Node node) {
    const auto found = numbers_.find(node);
    if (found != numbers_.end()) return found->second;
    constexpr std::uint64_t bytes_of_a_term = 400;
    budget_.check();
    budget_.check_memory(nodes_.size() * bytes_of_a_term, "the derivatives");
    nodes_.push_back(node);
    numbers_.emplace(std::move(node), nodes_.size() - 1);
    return nodes_.size() - 1;
}

Derivatives::Term Derivatives::product(Term left, Term right) {
    if (left == none_ || right == none_) return none_;
    if (left == empty_word_) return right;
    if (right == empty_word_) return left;
    return made({Kind::product, 0, {left, right}});
}

Derivatives::Term Derivatives::star(Term part) {
    if (part == none_ || part == empty_word_) return empty_word_;
    if (nodes_[part].kind == Kind::star) return part;
    return made({Kind::star, 0, {part}});
}

Derivatives::Term Derivatives::complement(Term part) {
    if (nodes_[part].kind == Kind::complement) return nodes_[part].parts.front();
    return made({Kind::complement, 0, {part}});
}

Derivatives::Term Derivatives::any(std::vector<Term> parts) {
    return combined(Kind::any, parts, none_, complement(none_));
}

Derivatives::Term Derivatives::all(std::vector<Term> parts) {
    return combined(Kind::all, parts, complement(none_), none_);
}

Derivatives::Term Derivatives::combined(Kind kind, const std::vector<Term>& parts, Term neutral,
                                        Term absorbing) {
    std::set<Term> distinct;
    for (const Term part : parts) {
        if (nodes_[part].kind == kind)
            distinct.insert(nodes_[part].parts.begin(), nodes_[part].parts.end());
        else if (part != neutral)
            distinct.insert(part);
    }
    if (distinct.contains(absorbing)) return absorbing;
    if (distinct.empty()) return neutral;
    if (distinct.size() == 1) return *distinct.begin();
    return made({kind, 0, {distinct.begin(), distinct.end()}});
}

Derivatives::Term Derivatives::word(const Word& word, Term rest) {
    for (auto a = word.rbegin(); a != word.rend(); ++a) rest = product(letter(*a), rest);
    return rest;
}

Derivatives::Term Derivatives::convert(const Tree& tree, bool reversed) {
    const auto part = [&](std::size_t i) { return convert(*tree.parts.at(i), reversed); };
    switch (tree.kind) {
        case Tree::Kind::words:
        case Tree::Kind::generated: {
            std::vector<Term> words;
            for (Word each : finite_values_of_leaf(tree, budget_)) {
                if (reversed) std::reverse(each.begin(), each.end());
                words.push_back(word(each, empty_word_));
            }
            return any(std::move(words));
        }
        case Tree::Kind::united:
            return any({part(0), part(1)});
        case Tree::Kind::intersection:
            return all({part(0), part(1)});
        case Tree::Kind::difference: {
            const Term left = part(0);
            return all({left, complement(part(1))});
        }
        case Tree::Kind::concatenation: {
            const Term left = part(reversed ? 1 : 0);
            return product(left, part(reversed ? 0 : 1));
        }
        case Tree::Kind::star:
            return star(part(0));
        case Tree::Kind::plus: {
            const Term once = part(0);
            return product(once, star(once));
        }
        case Tree::Kind::reversal:
            return convert(*tree.parts.at(0), !reversed);
        case Tree::Kind::complement: {
            std::vector<Term> letters;
            for (const Symbol a : tree.letters) letters.push_back(letter(a));
            const Term words = star(any(std::move(letters)));
            return all({words, complement(part(0))});
        }
        case Tree::Kind::image:
        case Tree::Kind::inverse_image:
            return convert_morphism(tree, reversed);
        case Tree::Kind::powers:
            if (const Language regular = regular_form(*tree.powers))
                return convert(*regular, reversed);
            throw BoundReached(Bound::method, "powers that are not seen to be regular");
        case Tree::Kind::variable:
            break;
    }
    throw Error("a bound name has no words");
}

Derivatives::Term Derivatives::convert_morphism(const Tree& tree, bool reversed) {
    Morphism images = tree.morphism;
    if (reversed)
        for (auto& [a, image] : images) std::reverse(image.begin(), image.end());
    const Term part = convert(*tree.parts.at(0), reversed);
    const auto known = std::find(morphisms_.begin(), morphisms_.end(), images);
    const auto number = static_cast<std::size_t>(known - morphisms_.begin());
    if (known == morphisms_.end()) morphisms_.push_back(std::move(images));
    const Kind kind = tree.kind == Tree::Kind::image ? Kind::image : Kind::inverse_image;
    return made({kind, number, {part}});
}

std::vector<Derivatives::Term> Derivatives::after_erased(Term part, std::size_t morphism) {
    const Morphism images = morphisms_[morphism];
    std::vector<Term> reached{part};
    std::set<Term> known{part};
    for (std::size_t i = 0; i < reached.size(); ++i)
        for (const auto& [a, image] : images) {
            if (!image.empty()) continue;
            const Term next = derivative(reached[i], a);
            if (known.insert(next).second) reached.push_back(next);
        }
    return reached;
}

bool Derivatives::nullable(Term term) {
    if (const auto known = nullable_.find(term); known != nullable_.end()) return known->second;
    return nullable_[term] = find_nullable(term);
}

bool Derivatives::find_nullable(Term term) {
    const Node node = nodes_[term];
    const auto is_nullable = [&](Term part) { return nullable(part); };
    switch (node.kind) {
        case Kind::none:
        case Kind::letter:
            return false;
        case Kind::empty_word:
        case Kind::star:
            return true;
        case Kind::product:
        case Kind::all:
            return std::all_of(node.parts.begin(), node.parts.end(), is_nullable);
        case Kind::any:
            return std::any_of(node.parts.begin(), node.parts.end(), is_nullable);
        case Kind::complement:
            return !nullable(node.parts[0]);
        case Kind::inverse_image:
            return nullable(node.parts[0]);
        case Kind::image:
            break;
    }
    const auto erased = after_erased(node.parts[0], node.number);
    return std::any_of(erased.begin(), erased.end(), is_nullable);
}

Derivatives::Term Derivatives::derivative(Term term, Symbol letter) {
    const auto key = std::make_pair(term, letter);
    if (const auto known = derivatives_.find(key); known != derivatives_.end())
        return known->second;
    const Term found = find_derivative(term, letter);
    derivatives_[key] = found;
    return found;
}

Derivatives::Term Derivatives::find_derivative(Term term, Symbol letter) {
    const Node node = nodes_[term];
    std::vector<Term> parts;
    switch (node.kind) {
        case Kind::none:
        case Kind::empty_word:
            return none_;
        case Kind::letter:
            return node.number == letter ? empty_word_ : none_;
        case Kind::product: {
            const Term first = product(derivative(node.parts[0], letter), node.parts[1]);
            return nullable(node.parts[0]) ? any({first, derivative(node.parts[1], letter)})
                                           : first;
        }
        case Kind::star:
            return product(derivative(node.parts[0], letter), term);
        case Kind::any:
        case Kind::all:
            for (const Term part : node.parts) parts.push_back(derivative(part, letter));
            return node.kind == Kind::any ? any(std::move(parts)) : all(std::move(parts));
        case Kind::complement:
            return complement(derivative(node.parts[0], letter));
        case Kind::inverse_image: {
            const auto image = morphisms_[node.number].find(letter);
            if (image == morphisms_[node.number].end()) return none_;
            const Word through = image->second;
            return made({node.kind, node.number, {derivative(node.parts[0], through)}});
        }
        case Kind::image:
            break;
    }
    const Morphism images = morphisms_[node.number];
    for (const Term part : after_erased(node.parts[0], node.number))
        for (const auto& [a, image] : images) {
            if (image.empty() || image.front() != letter) continue;
            const Term rest = made({node.kind, node.number, {derivative(part, a)}});
            parts.push_back(word({image.begin() + 1, image.end()}, rest));
        }
    return any(std::move(parts));
}

Derivatives::Term Derivatives::derivative(Term term, const Word& word) {
    for (const Symbol a : word) term = derivative(term, a);
    return term;
}

bool Derivatives::included(Term left, Term right) {
    std::set<std::pair<Term, Term>> known{{left, right}};
    std::vector<std::pair<Term, Term>> open{{left, right}};
    WorkCount done("pairs of terms");
    for (std::size_t i = 0; i < open.size(); ++i) {
        done.at(i);
        const auto [one, other] = open[i];
        if (one == none_ || one == other) continue;
        if (nullable(one) && !nullable(other)) return false;
        budget_.check();
        budget_.check_memory(open.size() * 100, "the pairs of derivatives");
        for (Symbol a = 0; a < alphabet_.size(); ++a) {
            const auto next = std::make_pair(derivative(one, a), derivative(other, a));
            if (known.insert(next).second) open.push_back(next);
        }
    }
    return true;
}

bool Derivatives::equal(Term left, Term right) {
    return included(left, right) && included(right, left);
}

Derivatives::Automaton Derivatives::automaton(Term term) {
    Automaton found;
    std::map<Term, std::size_t> numbers{{term, 0}};
    std::vector<Term> states{term};
    WorkCount done("states");
    for (std::size_t i = 0; i < states.size(); ++i) {
        budget_.check();
        done.at(i);
        budget_.check_memory(states.size() * (100 + 8 * alphabet_.size()), "the automaton");
        found.accepting.push_back(nullable(states[i]));
        auto& next = found.next.emplace_back();
        for (Symbol a = 0; a < alphabet_.size(); ++a) {
            const Term to = derivative(states[i], a);
            const auto [place, is_new] = numbers.emplace(to, states.size());
            if (is_new) states.push_back(to);
            next.push_back(place->second);
        }
    }
    return found;
}

namespace {

constexpr std::size_t longest = 4000;  // letters of a word that is taken apart in all ways
constexpr std::uint64_t longest_sequence =
    50'000'000;  // letters of the words of a sequence together

void must_be_short(const Word& word) {
    if (word.size() > longest)
        throw BoundReached(Bound::method,
                           "a word of " + std::to_string(word.size()) +
                               " letters is not taken apart in all ways, only up to " +
                               std::to_string(longest));
}

using Images = std::map<Symbol, Word>;

bool erases(const Images& images) {
    return std::any_of(images.begin(), images.end(),
                       [](const auto& each) { return each.second.empty(); });
}

/// For each letter, between which positions of the word its image stands.
Relations places(const std::vector<Symbol>& letters, const Images& images, const Word& word) {
    must_be_short(word);
    Relations start;
    for (const Symbol a : letters) {
        BooleanMatrix relation(word.size() + 1);
        if (const auto image = images.find(a); image != images.end())
            for (std::size_t i = 0; i <= word.size(); ++i)
                if (stands_at(image->second, word, i)) relation.set(i, i + image->second.size());
        start.emplace(a, std::move(relation));
    }
    return start;
}

/// Whether a system with context derives a word that `wanted` is true of. Where no rule has the empty successor, words longer
/// than `most` letters are not followed.
template <class Wanted>
bool some_word(const System& system, const Word& from, std::size_t most, const Budget& budget,
               Wanted wanted) {
    const std::size_t longest_wanted = never_shrinks(system) ? most : SIZE_MAX;
    if (from.size() > longest_wanted) return false;
    std::set<Word> known{from};
    std::vector<const Word*> open{&*known.begin()};
    std::uint64_t letters = 0;
    WorkCount done("words");
    for (std::size_t i = 0; i < open.size(); ++i) {
        budget.check();
        done.at(i);
        if (wanted(*open[i])) return true;
        letters += open[i]->size() + 16;
        if (letters > longest_sequence)
            throw BoundReached(Bound::method, "the words derived are too long or too many");
        for (const Word& next : next_words(system, *open[i], longest_wanted, budget))
            if (const auto [place, is_new] = known.insert(next); is_new) open.push_back(&*place);
    }
    return false;
}

/// Whether a system with context derives one word from the other in so many steps.
bool derives_in(const System& system, const Word& from, const Word& to, const Integer& steps,
                const Budget& budget) {
    const std::size_t most = never_shrinks(system) ? to.size() : SIZE_MAX;
    std::map<std::set<Word>, std::size_t> known;
    std::vector<const std::set<Word>*> levels;
    std::set<Word> level;
    if (from.size() <= most) level.insert(from);
    std::uint64_t letters = 0;
    for (;;) {
        budget.check();
        const auto [place, is_new] = known.emplace(level, levels.size());
        if (!is_new) {  // from the level before on they come round again
            const std::size_t first = place->second, period = levels.size() - first;
            return levels[first + static_cast<std::size_t>(
                                      remainder(steps - first, Integer(period)).to_uint64())]
                ->contains(to);
        }
        if (steps == levels.size()) return level.contains(to);
        levels.push_back(&place->first);
        std::set<Word> next;
        for (const Word& word : place->first) {
            next.merge(next_words(system, word, most, budget));
            letters += word.size() + 16;
            if (letters > longest_sequence)
                throw BoundReached(Bound::method, "the words derived are too long or too many");
        }
        level = std::move(next);
    }
}

class Membership {
public:
    Membership(const Alphabet& alphabet, const Budget& budget)
        : alphabet_(alphabet), budget_(budget) {}

    bool in(const Language& language, const Word& word) {
        const auto key = std::make_pair(language.get(), word);
        if (const auto known = known_.find(key); known != known_.end()) return known->second;
        budget_.check();
        bytes_ += 150 + word.size() * sizeof(Symbol);
        budget_.check_memory(bytes_, "what is known of factors of the word");
        kept_.push_back(language);
        const bool found = find(*language, word);
        known_[key] = found;
        return found;
    }

private:
    bool find(const Tree& tree, const Word& word) {
        switch (tree.kind) {
            case Tree::Kind::words:
                return std::binary_search(tree.words.begin(), tree.words.end(), word,
                                          shortlex_less);
            case Tree::Kind::generated:
                return generated(*tree.system, word);
            case Tree::Kind::united:
                return in(tree.parts[0], word) || in(tree.parts[1], word);
            case Tree::Kind::intersection:
                return in(tree.parts[0], word) && in(tree.parts[1], word);
            case Tree::Kind::difference:
                return in(tree.parts[0], word) && !in(tree.parts[1], word);
            case Tree::Kind::concatenation:
                return concatenated(tree, word);
            case Tree::Kind::star:
                return word.empty() || repeated(tree.parts[0], word);
            case Tree::Kind::plus:
                return word.empty() ? in(tree.parts[0], word) : repeated(tree.parts[0], word);
            case Tree::Kind::reversal:
                return in(tree.parts[0], Word(word.rbegin(), word.rend()));
            case Tree::Kind::complement:
                return std::all_of(word.begin(), word.end(),
                                   [&](Symbol a) {
                                       return std::binary_search(tree.letters.begin(),
                                                                 tree.letters.end(), a);
                                   }) &&
                       !in(tree.parts[0], word);
            case Tree::Kind::inverse_image: {
                const auto image = image_of(word, tree.morphism, budget_);
                return image && in(tree.parts[0], *image);
            }
            case Tree::Kind::image:
                return image(tree, word);
            case Tree::Kind::powers:
                return has_word(*tree.powers, word, budget_);
            case Tree::Kind::variable:
                break;
        }
        throw Error("a bound name has no words");
    }

    bool generated(const System& system, const Word& word) const {
        return is_terminal(system, word) &&
               derives(system, system.axiom, word, std::nullopt, budget_);
    }

    bool concatenated(const Tree& tree, const Word& word) {
        must_be_short(word);
        for (auto middle = word.begin();; ++middle) {
            if (in(tree.parts[0], Word(word.begin(), middle)) &&
                in(tree.parts[1], Word(middle, word.end())))
                return true;
            if (middle == word.end()) return false;
        }
    }

    /// Whether a word that is not empty is made of words of the language, none of them empty.
    bool repeated(const Language& part, const Word& word) {
        must_be_short(word);
        std::vector<char> reached(word.size() + 1);
        reached[0] = 1;
        for (std::size_t end = 1; end <= word.size(); ++end)
            for (std::size_t start = 0; start < end && !reached[end]; ++start)
                if (reached[start] &&
                    in(part, Word(word.begin() + static_cast<std::ptrdiff_t>(start),
                                  word.begin() + static_cast<std::ptrdiff_t>(end))))
                    reached[end] = 1;
        return reached[word.size()];
    }

    /// The image of an operation is the operation on images where that is so; otherwise all words with
    /// this image are tried.
    bool image(const Tree& tree, const Word& word) {
        const Tree& part = *tree.parts[0];
        switch (part.kind) {
            case Tree::Kind::words:
                return std::any_of(part.words.begin(), part.words.end(), [&](const Word& each) {
                    return image_of(each, tree.morphism, budget_) == word;
                });
            case Tree::Kind::generated:
                return image_of_generated(*part.system, tree.morphism, word);
            case Tree::Kind::powers:
                if (const auto powers = image_of_powers(*part.powers, tree.morphism, budget_))
                    return has_word(*powers, word, budget_);
                break;
            case Tree::Kind::united:
            case Tree::Kind::concatenation:
            case Tree::Kind::star:
            case Tree::Kind::plus: {
                auto& images = images_of_[&tree];
                if (!images) {
                    std::vector<Language> parts;
                    for (const Language& each : part.parts)
                        parts.push_back(combination(Tree::Kind::image, {each}, tree.morphism));
                    images = combination(part.kind, std::move(parts));
                }
                return in(images, word);
            }
            case Tree::Kind::image: {
                auto& through = images_of_[&tree];
                if (!through) {
                    Images both;
                    for (const auto& [a, image] : part.morphism)
                        if (const auto further = image_of(image, tree.morphism, budget_))
                            both[a] = *further;
                    through = combination(Tree::Kind::image, part.parts, std::move(both));
                }
                return in(through, word);
            }
            default:
                break;
        }
        if (is_regular(tree.parts[0])) {
            Derivatives derivatives(alphabet_, budget_);
            const auto term = derivatives.term(std::make_shared<const Tree>(tree));
            return derivatives.nullable(derivatives.derivative(term, word));
        }
        if (erases(tree.morphism))
            throw BoundReached(Bound::method,
                               "whether a word is the image of a word of this language cannot be "
                               "checked: a letter is erased");
        Word before;
        std::uint64_t tries = 0;
        return some_preimage(tree, word, 0, before, tries);
    }

    bool some_preimage(const Tree& tree, const Word& word, std::size_t done, Word& before,
                       std::uint64_t& tries) {
        must_be_short(word);
        if (++tries > 1'000'000)
            throw BoundReached(Bound::method, "too many words have this image");
        if (done == word.size()) return in(tree.parts[0], before);
        for (const auto& [a, image] : tree.morphism) {
            if (!stands_at(image, word, done)) continue;
            before.push_back(a);
            const bool found = some_preimage(tree, word, done + image.size(), before, tries);
            before.pop_back();
            if (found) return true;
        }
        return false;
    }

    bool image_of_generated(const System& system, const Images& morphism, const Word& word) const {
        if (system.context) return with_context(system, morphism, word);
        Images images;
        for (const auto& [a, image] : morphism)
            if (system.terminal[a]) images[a] = image;
        const auto start = places(accessible_letters(system, system.axiom), images, word);
        return some_relations(
            system, start, word.size() + 1,
            [&](const Relations& relations) {
                return relation_of(system.axiom, relations, word.size() + 1).at(0, word.size());
            },
            budget_);
    }

    bool with_context(const System& system, const Images& morphism, const Word& word) const {
        return some_word(
            system, system.axiom, erases(morphism) ? SIZE_MAX : word.size(), budget_,
            [&](const Word& each) { return image_of(each, morphism, budget_) == word; });
    }

    const Alphabet& alphabet_;
    const Budget& budget_;
    std::map<std::pair<const Tree*, Word>, bool> known_;
    std::map<const Tree*, Language> images_of_;
    std::vector<Language>
        kept_;  // so that no expression made on the way has the address of another
    std::uint64_t bytes_ = 0;
};

}  // namespace

bool is_terminal(const System& system, const Word& word) {
    return std::all_of(word.begin(), word.end(), [&](Symbol a) { return system.terminal[a]; });
}

bool contains(const Language& language, const Word& word, const Alphabet& alphabet,
              const Budget& budget) {
    return Membership(alphabet, budget).in(language, word);
}

std::optional<Word> image_of(const Word& word, const std::map<Symbol, Word>& morphism,
                             const Budget& budget) {
    Word whole;
    for (const Symbol a : word) {
        const auto image = morphism.find(a);
        if (image == morphism.end()) return std::nullopt;
        budget.check_memory((whole.size() + image->second.size()) * 4 * sizeof(Symbol),
                            "the image of a word");
        whole.insert(whole.end(), image->second.begin(), image->second.end());
    }
    return whole;
}

bool derives(const System& system, const Word& from, const Word& to,
             const std::optional<Integer>& steps, const Budget& budget) {
    if (system.context)
        return steps ? derives_in(system, from, to, *steps, budget)
                     : some_word(system, from, to.size(), budget,
                                 [&](const Word& word) { return word == to; });
    if (!steps && from == to) return true;
    Images itself;
    for (const Symbol a : to) itself[a] = {a};
    const auto start = places(accessible_letters(system, from), itself, to);
    const auto stop = [&](const Relations& relations) {
        return relation_of(from, relations, to.size() + 1).at(0, to.size());
    };
    if (steps) return some_relations_after(system, start, to.size() + 1, *steps, stop, budget);
    return some_relations(system, start, to.size() + 1, stop, budget);
}

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
        if (system.context) next = next_words(system, word, SIZE_MAX, budget);
        for (const auto& table : system.tables) next.merge(successors(table, word, budget));
        for (const Word& each : next)
            if (known.insert(each)) open.push_back(each);
    }
    return std::move(known.words);
}

/// The words of a system whose letters are rewritten one at a time: for each letter the least set that contains what its rules
/// make of the sets. Letters that derive no word, or stand only beside such, do not count. If the sets are finite, each word
/// has a tree in which no letter stands below itself, so they are complete after as many rounds as there are letters.
Set words_of_grammar(const System& system, const Budget& budget) {
    const auto& table = system.tables.front();
    std::set<Symbol> ending;  // that derive words
    const auto ends = [&](const Word& word) {
        return std::all_of(word.begin(), word.end(), [&](Symbol a) { return ending.count(a) > 0; });
    };
    const auto letters = accessible_letters(system, system.axiom);
    for (std::size_t before = 1, now = 0; before != now; now = ending.size()) {
        before = ending.size();
        for (const Symbol a : letters)
            if (system.terminal[a] || std::any_of(table[a].begin(), table[a].end(), ends))
                ending.insert(a);
    }
    if (!ends(system.axiom)) return {};
    std::set<Symbol> used(system.axiom.begin(), system.axiom.end());
    std::vector<Symbol> open(used.begin(), used.end());
    while (!open.empty()) {
        const Symbol a = open.back();
        open.pop_back();
        for (const Word& image : table[a])
            if (ends(image))
                for (const Symbol b : image)
                    if (used.insert(b).second) open.push_back(b);
    }
    std::map<Symbol, Set> words;
    for (const Symbol a : used)
        if (system.terminal[a]) words[a].insert(Word{a});
    const auto product = [&](const Word& image) {
        Set built{Word{}};
        for (const Symbol a : image) {
            Bounded longer(budget);
            for (const Word& start : built)
                for (const Word& end : words[a]) {
                    Word next = start;
                    next.insert(next.end(), end.begin(), end.end());
                    longer.insert(std::move(next));
                }
            built = std::move(longer.words);
        }
        return built;
    };
    bool grows = true;
    for (std::size_t round = 0; grows; ++round) {
        if (round > used.size() + 1)
            throw BoundReached(Bound::method, "the words of the system have no end");
        grows = false;
        for (const Symbol a : used)
            for (const Word& image : table[a])
                if (ends(image) && image != Word{a})
                    for (const Word& word : product(image))
                        grows = words[a].insert(word).second || grows;
    }
    return product(system.axiom);
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
                if (image.empty() || !stands_at(image, word, done)) continue;
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
                if (!part || !std::all_of(part->begin(), part->end(),
                                          [](const Word& each) { return each.empty(); }))
                    return std::nullopt;
                if (tree.kind == Tree::Kind::star) part->insert(Word{});
                return part;
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
                return regular(language);
            case Tree::Kind::powers:
                return std::nullopt;
            case Tree::Kind::variable:
                break;
        }
        throw Error("a bound name has no words");
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
        if (erases(morphism) && !all.words.empty()) return std::nullopt;
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
    if (rewrites_singly(*leaf.system)) {
        const Set words = words_of_grammar(*leaf.system, budget);
        return {words.begin(), words.end()};
    }
    std::vector<Word> words;
    for (const Word& word : derived(*leaf.system, budget))
        if (is_terminal(*leaf.system, word)) words.push_back(word);
    return words;
}

}  // namespace algae::verify
