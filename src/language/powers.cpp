#include "language/detail/powers.hpp"

#include <algorithm>
#include <set>

#include "language/detail/construct.hpp"
#include "language/detail/judge.hpp"

// Languages of powers: {a^n b^(2n+1) : n >= 0}, {a^(2^n) : n >= 0}, {a^n b^m : n, m >= 1}.
//
// A word is in the language if some values of the numbers make it. The lengths grow with each number, so only those
// values are tried whose words are no longer.
//
// For all other questions there are three views of the language. Where the exponents are linear and no number stands
// in two of them, it is regular: u^(2n+3) is u^3 (u^2)*. In general it is an EDT0L language, which decides what is
// decided of these (finite_value, meetings with regular languages): counters are letters, a letter for the function
// n^k b^n becomes b times those of (n+1)^k = sum C(k,j) n^j. And with one number it is a sequence of words, of which
// `follows` proves by induction that it is the sequence of a D0L system g: the axiom is word number 0, and g takes word
// number n to word number n + 1, for all n at once. For that the images g(u1)^e1(n) g(u2)^e2(n) ... and the next word
// u1^e1(n+1) ... are brought to one normal form; exponents are compared as polynomials in n and powers b^n, which are
// linearly independent functions. The normal form is not complete: (ab)^n (a b)^m is told from nothing else, but words
// like a^n (ab)^n are only rewritten as far as letters move.
//
// That a language of powers is not regular or context-free is shown by one of three arguments (BeyondFamily). Lengths
// of a context-free language are ultimately periodic (Parikh 1966). A morphism that keeps one letter each of k blocks
// makes a language c1^e1(n) ... ck^ek(n) of it; with linear exponents that is not regular for k = 2, as no two
// c1^e1(n) have the same continuations, and not context-free for k = 3 (Ginsburg 1966: by the pumping lemma). If a
// letter stands in each word exactly once, words x m y and x' m y' with different x have different continuations.

namespace algae {

namespace {

using Term = Powers::Term;

bool is_constant(const Powers::Block& block) {
    return std::all_of(block.exponent.begin(), block.exponent.end(),
                       [](const Term& term) { return !term.number; });
}

Integer value(const Term& term, const std::vector<std::uint64_t>& values) {
    if (!term.number) return term.coefficient;
    const std::uint64_t n = values[*term.number];
    return term.coefficient * power(Integer(n), term.power) * power(term.base, n);
}

Integer exponent_value(const Powers::Block& block, const std::vector<std::uint64_t>& values) {
    Integer sum = 0;
    for (const Term& term : block.exponent) sum += value(term, values);
    return sum;
}

Integer length_of(const Powers& powers, const std::vector<std::uint64_t>& values) {
    Integer sum = 0;
    for (const Powers::Block& block : powers.blocks)
        sum += exponent_value(block, values) * Integer(block.word.size());
    return sum;
}

std::vector<std::uint64_t> least_values(const Powers& powers) {
    std::vector<std::uint64_t> values;
    for (const Powers::Number& number : powers.numbers) values.push_back(number.least);
    return values;
}

/// A number that a rule or an axiom is written out so often.
std::size_t written_out(const Integer& count) {
    constexpr std::uint64_t most = 10'000;
    if (count > Integer(most))
        throw BoundReached(Bound::method, "exponents are worked with up to coefficients of " +
                                              std::to_string(most));
    return static_cast<std::size_t>(count.to_uint64());
}

void append(Word& to, const Word& word, std::size_t times = 1) {
    for (; times > 0; --times) to.insert(to.end(), word.begin(), word.end());
}

std::string term_text(const Term& term, const std::vector<Powers::Number>& numbers) {
    const bool is_one = term.coefficient == 1;
    if (!term.number) return to_string(term.coefficient);
    const std::string& name = numbers[*term.number].name;
    std::string text = is_one ? "" : to_string(term.coefficient);
    if (term.power > 0)
        text += name + (term.power > 1 ? "^" + std::to_string(term.power) : std::string());
    if (term.base != 1) text += (text.empty() ? "" : "*") + to_string(term.base) + "^" + name;
    return text;
}

std::string exponent_text(const std::vector<Term>& exponent,
                          const std::vector<Powers::Number>& numbers) {
    const std::string text =
        joined(exponent, "+", [&](const Term& term) { return term_text(term, numbers); });
    const bool is_name = std::any_of(numbers.begin(), numbers.end(),
                                     [&](const auto& number) { return number.name == text; });
    return is_name ? text : "(" + text + ")";
}

const Word& block_word(const Powers::Block& block) { return block.word; }
const Word& block_word(const std::pair<Word, Count>& block) { return block.first; }

/// Words with their exponents, one behind the other; `is_fixed`: the exponent is 1.
template <class Blocks, class Fixed, class Exponent>
std::string blocks_text(const Blocks& blocks, const Alphabet& alphabet, Fixed is_fixed,
                        Exponent exponent) {
    return joined(blocks, " ", [&](const auto& block) {
        const Word& word = block_word(block);
        const std::string text = spell(alphabet, word);
        if (is_fixed(block)) return text;
        return (word.size() == 1 ? text : "(" + text + ")") + "^" + exponent(block);
    });
}

const std::vector<Term> once{{}};

}  // namespace

std::string to_string(const Powers& powers, const Alphabet& alphabet) {
    std::string text = blocks_text(
        powers.blocks, alphabet, [](const auto& block) { return block.exponent == once; },
        [&](const auto& block) { return exponent_text(block.exponent, powers.numbers); });
    const auto& numbers = powers.numbers;
    const bool same = std::all_of(numbers.begin(), numbers.end(), [&](const auto& number) {
        return number.least == numbers.front().least;
    });
    const auto least = [](const Powers::Number& number) {
        return " >= " + std::to_string(number.least);
    };
    const std::string conditions =
        same ? joined(numbers, ", ", [](const auto& number) { return number.name; }) +
                   least(numbers.front())
             : joined(numbers, ", ",
                      [&](const auto& number) { return number.name + least(number); });
    return "{" + text + " : " + conditions + "}";
}

Language powers_language(Powers powers) {
    std::vector<char> used(powers.numbers.size(), 0);
    for (const Powers::Block& block : powers.blocks)
        for (const Term& term : block.exponent) {
            if (!term.number) continue;
            used[*term.number] = 1;
            if (powers.numbers.size() > 1 && (term.power != 1 || term.base != 1))
                throw Error("with two numbers exponents are sums of multiples of them");
        }
    for (std::size_t i = 0; i < used.size(); ++i)
        if (!used[i])
            throw Error("the number " + powers.numbers[i].name + " stands in no exponent");
    LanguageTree tree;
    tree.kind = LanguageTree::Kind::powers;
    tree.powers = std::make_shared<const Powers>(std::move(powers));
    return std::make_shared<const LanguageTree>(std::move(tree));
}

Word word_of(const Powers& powers, const std::vector<std::uint64_t>& values, const Budget& budget) {
    const Integer length = length_of(powers, values);
    if (length > Integer(budget.letters))
        throw BoundReached(Bound::letters, "the word has more than the " +
                                               std::to_string(budget.letters) + " letters allowed" +
                                               budget.by(Bound::letters));
    Word word;
    word.reserve(static_cast<std::size_t>(length.to_uint64()));
    for (const Powers::Block& block : powers.blocks)
        append(word, block.word,
               static_cast<std::size_t>(exponent_value(block, values).to_uint64()));
    return word;
}

std::optional<std::vector<std::uint64_t>> values_of(const Powers& powers, const Word& word,
                                                    const Budget& budget) {
    const Integer length(word.size());
    std::vector<std::uint64_t> values = least_values(powers);
    for (;; ++values.front()) {
        budget.check();
        const Integer least = length_of(powers, values);
        if (least > length) return std::nullopt;
        if (values.size() == 1) {
            if (least == length && word_of(powers, values, budget) == word) return values;
            continue;
        }
        // The length is linear in the other number.
        std::vector<std::uint64_t> others = values;
        ++others.back();
        const Integer step = length_of(powers, others) - least;
        const Integer more = floor_divide(length - least, step);
        others.back() = values.back() + more.to_uint64();
        if (least + step * more == length && word_of(powers, others, budget) == word) return others;
    }
}

bool is_linear(const Powers& powers) {
    for (const Powers::Block& block : powers.blocks)
        for (const Term& term : block.exponent)
            if (term.number && (term.power != 1 || term.base != 1)) return false;
    return true;
}

Language regular_form(const Powers& powers) {
    if (!is_linear(powers)) return nullptr;
    std::vector<std::size_t> uses(powers.numbers.size(), 0);
    for (const Powers::Block& block : powers.blocks)
        for (const Term& term : block.exponent)
            if (term.number && ++uses[*term.number] > 1) return nullptr;
    Language whole;
    const auto add = [&](Language part) {
        whole = whole ? combined(LanguageTree::Kind::concatenated, {whole, std::move(part)})
                      : std::move(part);
    };
    const std::vector<std::uint64_t> least = least_values(powers);
    for (const Powers::Block& block : powers.blocks) {
        Word first;
        append(first, block.word, written_out(exponent_value(block, least)));
        add(words_language({first}));
        for (const Term& term : block.exponent) {
            if (!term.number) continue;
            Word round;
            append(round, block.word, written_out(term.coefficient));
            add(combined(LanguageTree::Kind::star, {words_language({round})}));
        }
    }
    return whole;
}

namespace {

Integer binomial(std::uint64_t n, std::uint64_t k) {
    Integer found = 1;
    for (std::uint64_t i = 0; i < k; ++i)
        found = exact_divide(found * Integer(n - i), Integer(i + 1));
    return found;
}

void add_count(Count& to, const std::pair<Integer, std::uint64_t>& of, const Integer& coefficient) {
    const auto place = to.try_emplace(of, 0).first;
    place->second += coefficient;
    if (place->second.is_zero()) to.erase(place);
}

/// The function at n + by.
Count at_later(const Count& count, std::uint64_t by) {
    Count found;
    for (const auto& [of, coefficient] : count) {
        const auto& [base, degree] = of;
        for (std::uint64_t j = 0; j <= degree; ++j)
            add_count(found, {base, j},
                      coefficient * power(base, by) * binomial(degree, j) *
                          power(Integer(by), degree - j));
    }
    return found;
}

Count count_of(const Powers::Block& block, std::size_t number) {
    Count found;
    for (const Term& term : block.exponent)
        if (!term.number)
            add_count(found, {Integer(1), 0}, term.coefficient);
        else if (*term.number == number)
            add_count(found, {term.base, term.power}, term.coefficient);
    return found;
}

}  // namespace

ET0L system_of(const Powers& powers, const Alphabet& alphabet, const Budget& budget) {
    const std::size_t numbers = powers.numbers.size(), end = numbers;
    Draft draft(alphabet, numbers + 1);
    Word axiom;
    for (const Powers::Block& block : powers.blocks) {
        Word terminals;
        for (const Symbol a : block.word) terminals.push_back(draft.terminal(alphabet.name(a)));
        // Letters that stand for n^k b^n copies of the word, by number, b and k.
        std::map<std::pair<std::size_t, std::pair<Integer, std::uint64_t>>, Symbol> letters;
        const auto letter = [&](std::size_t number, const std::pair<Integer, std::uint64_t>& of) {
            const auto [place, is_new] = letters.try_emplace({number, of}, 0);
            if (is_new) place->second = draft.fresh("X");
            return place->second;
        };
        Integer fixed = 0;
        for (std::size_t number = 0; number < numbers; ++number)
            for (const auto& [of, coefficient] :
                 at_later(count_of(block, number), powers.numbers[number].least)) {
                if (of.first == 1 && of.second == 0) continue;
                append(axiom, {letter(number, of)}, written_out(coefficient));
            }
        for (const Term& term : block.exponent) {
            if (!term.number) {
                fixed += term.coefficient;
                continue;
            }
            const Count from = at_later({{{term.base, term.power}, term.coefficient}},
                                        powers.numbers[*term.number].least);
            const auto found = from.find({Integer(1), 0});
            if (found != from.end()) fixed += found->second;
        }
        if (fixed > 0) append(axiom, {letter(0, {Integer(1), 0})}, written_out(fixed));
        // Every letter that its steps lead to has rules too.
        std::set<std::pair<std::size_t, std::pair<Integer, std::uint64_t>>> done;
        while (done.size() < letters.size()) {
            const auto known = letters;
            for (const auto& [which, symbol] : known) {
                if (!done.insert(which).second) continue;
                const auto& [number, of] = which;
                for (std::size_t table = 0; table < numbers; ++table) {
                    if (table != number) {
                        draft.add_rule(table, symbol, {symbol});
                        continue;
                    }
                    Word successor;
                    for (const auto& [next, times] : at_later({{of, Integer(1)}}, 1))
                        append(successor, {letter(number, next)}, written_out(times));
                    draft.add_rule(table, symbol, std::move(successor));
                }
                draft.add_rule(end, symbol, of.second == 0 ? terminals : Word{});
                draft.check(budget);
            }
        }
    }
    draft.keep_terminals();
    return draft.system(axiom, {});
}

std::optional<WordSequence> sequence_of(const Language& language) {
    WordSequence sequence;
    if (language->kind == LanguageTree::Kind::powers) {
        const Powers& powers = *language->powers;
        if (powers.numbers.size() != 1) return std::nullopt;
        for (const Powers::Block& block : powers.blocks)
            sequence.emplace_back(block.word,
                                  at_later(count_of(block, 0), powers.numbers.front().least));
        return sequence;
    }
    if (language->kind != LanguageTree::Kind::generated || language->system->grammar.empty())
        return std::nullopt;
    const ET0L& system = *language->system->tables;
    const Symbol start = system.axiom.front();
    std::optional<Word> round, last;
    for (const Word& successor : system.tables.front()[start]) {
        const auto starts = std::count(successor.begin(), successor.end(), start);
        const bool others = std::any_of(successor.begin(), successor.end(), [&](Symbol a) {
            return a != start && !system.terminal[a];
        });
        if (others || starts > 1) return std::nullopt;
        if (starts == 1 && successor.size() == 1) continue;
        std::optional<Word>& found = starts == 1 ? round : last;
        if (found && *found != successor) return std::nullopt;
        found = successor;
    }
    if (!round || !last) return std::nullopt;
    const auto middle = std::find(round->begin(), round->end(), start);
    const Count each{{{Integer(1), 1}, Integer(1)}}, fixed{{{Integer(1), 0}, Integer(1)}};
    for (const auto& [word, count] :
         {std::pair(Word(round->begin(), middle), each), std::pair(*last, fixed),
          std::pair(Word(middle + 1, round->end()), each)})
        if (!word.empty()) sequence.emplace_back(word, count);
    return sequence;
}

std::string to_string(const WordSequence& sequence, const Alphabet& alphabet) {
    const std::vector<Powers::Number> numbers{{"n", 0}};
    const auto terms = [](const Count& count) {
        std::vector<Term> all;
        for (auto one = count.rbegin(); one != count.rend(); ++one) {
            const auto& [base, degree] = one->first;
            const bool fixed = base == 1 && degree == 0;
            all.push_back(
                {one->second, fixed ? std::nullopt : std::optional<std::size_t>(0), degree, base});
        }
        return all;
    };
    if (sequence.empty()) return "ε";
    return blocks_text(
        sequence, alphabet, [&](const auto& block) { return terms(block.second) == once; },
        [&](const auto& block) { return exponent_text(terms(block.second), numbers); });
}

namespace {

const std::pair<Integer, std::uint64_t> constant{1, 0};

/// A letter, or a word that is repeated as often as a function without constant part says.
struct Piece {
    Word word;
    Count count;  // empty: a letter
    bool operator==(const Piece&) const = default;
};

/// The shortest word of which this one is a power, and which power.
std::pair<Word, std::size_t> root(const Word& word) {
    for (std::size_t size = 1;; ++size) {
        if (word.size() % size != 0) continue;
        bool repeats = true;
        for (std::size_t i = size; i < word.size() && repeats; ++i)
            repeats = word[i] == word[i - size];
        if (repeats)
            return {Word(word.begin(), word.begin() + static_cast<std::ptrdiff_t>(size)),
                    word.size() / size};
    }
}

class Normal {
public:
    explicit Normal(const WordSequence& sequence) {
        for (const auto& [word, count] : sequence) {
            if (word.empty()) continue;
            auto [primitive, times] = root(word);
            Count scaled;
            Integer fixed = 0;
            for (const auto& [of, coefficient] : count)
                if (of == constant)
                    fixed = coefficient * Integer(times);
                else
                    scaled.emplace(of, coefficient * Integer(times));
            Word letters;
            append(letters, primitive, written_out(fixed));
            for (const Symbol a : letters) add_letter(a, pieces_.size());
            if (!scaled.empty()) add_power(std::move(primitive), std::move(scaled));
        }
    }

    const std::vector<Piece>& pieces() const { return pieces_; }

private:
    /// Puts the letter behind the first `at` pieces, or before those powers that begin with it.
    void add_letter(Symbol letter, std::size_t at) {
        for (; at > 0; --at) {
            Piece& before = pieces_[at - 1];
            if (before.count.empty() || before.word.front() != letter) break;
            std::rotate(before.word.begin(), before.word.begin() + 1, before.word.end());
        }
        pieces_.insert(pieces_.begin() + static_cast<std::ptrdiff_t>(at), Piece{{letter}, {}});
        join_neighbours();
    }
    void add_power(Word word, Count count) {
        pieces_.push_back({std::move(word), std::move(count)});
        join_neighbours();
    }
    void join_neighbours() {
        for (std::size_t i = 0; i + 1 < pieces_.size();) {
            Piece &left = pieces_[i], &right = pieces_[i + 1];
            if (left.count.empty() || right.count.empty() || left.word != right.word) {
                ++i;
                continue;
            }
            for (const auto& [of, coefficient] : right.count)
                add_count(left.count, of, coefficient);
            pieces_.erase(pieces_.begin() + static_cast<std::ptrdiff_t>(i) + 1);
        }
    }

    std::vector<Piece> pieces_;
};

}  // namespace

bool is_same(const WordSequence& left, const WordSequence& right) {
    return Normal(left).pieces() == Normal(right).pieces();
}

bool follows(const D0L& system, const WordSequence& sequence) {
    const std::uint64_t letters = system.rules.size();
    WordSequence first, images, next;
    for (const auto& [word, count] : sequence) {
        Integer begun = 0;  // at n = 0
        for (const auto& [of, coefficient] : count)
            if (of.second == 0) begun += coefficient;
        first.emplace_back(word, Count{{constant, begun}});
        Word image;
        for (const Symbol a : word) {
            if (a >= letters) return false;
            append(image, system.rules[a]);
        }
        images.emplace_back(std::move(image), count);
        next.emplace_back(word, at_later(count, 1));
    }
    return is_same(first, {{system.axiom, Count{{constant, Integer(1)}}}}) && is_same(images, next);
}

std::optional<BeyondFamily> beyond_family(const Powers& powers, const std::string& family) {
    if (powers.numbers.size() != 1) return std::nullopt;
    if (!is_linear(powers)) return BeyondFamily{BeyondFamily::Why::lengths, {}};
    const auto& blocks = powers.blocks;
    const auto stands_in = [&](Symbol letter, const Powers::Block& block) {
        return std::count(block.word.begin(), block.word.end(), letter);
    };
    std::vector<Symbol> alone;  // one letter for each block that has one of its own
    for (const Powers::Block& block : blocks) {
        if (is_constant(block)) continue;
        for (const Symbol letter : block.word)
            if (std::none_of(blocks.begin(), blocks.end(), [&](const Powers::Block& other) {
                    return &other != &block && stands_in(letter, other) > 0;
                })) {
                alone.push_back(letter);
                break;
            }
    }
    const std::size_t wanted = family == "REG" ? 2 : 3;
    if (alone.size() >= wanted) {
        alone.resize(wanted);
        return BeyondFamily{BeyondFamily::Why::blocks, alone};
    }
    if (family != "REG") return std::nullopt;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        if (blocks[i].exponent != once) continue;
        const auto varies = [](const Powers::Block& block) { return !is_constant(block); };
        const auto place = blocks.begin() + static_cast<std::ptrdiff_t>(i);
        if (std::none_of(blocks.begin(), place, varies) ||
            std::none_of(place, blocks.end(), varies))
            continue;
        for (const Symbol letter : blocks[i].word) {
            std::ptrdiff_t times = 0;
            for (const Powers::Block& block : blocks)
                times += block.exponent == once ? stands_in(letter, block)
                                                : 2 * stands_in(letter, block);
            if (times == 1) return BeyondFamily{BeyondFamily::Why::marker, {letter}};
        }
    }
    return std::nullopt;
}

bool is_nested(const Powers& powers) {
    if (!is_linear(powers)) return false;
    std::vector<std::set<std::size_t>> places(powers.numbers.size());
    for (std::size_t i = 0; i < powers.blocks.size(); ++i)
        for (const Term& term : powers.blocks[i].exponent)
            if (term.number) places[*term.number].insert(i);
    for (const auto& of : places)
        if (of.size() > 2) return false;
    if (places.size() < 2) return true;
    const std::size_t n = *places[0].begin(), n_end = *places[0].rbegin(), m = *places[1].begin(),
                      m_end = *places[1].rbegin();
    return !(n < m && m < n_end && n_end < m_end) && !(m < n && n < m_end && m_end < n_end);
}

}  // namespace algae
