#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "automatic/automatic.hpp"
#include "combinatorics/combinatorics.hpp"
#include "language/detail/judge.hpp"
#include "language/detail/proof.hpp"
#include "watch/watch.hpp"
#include "word/word.hpp"

// Statements about words that hold for all n: `word(F, n + 2) == word(F, n + 1) word(F, n)`, `h(word(G, n)) == word(H, n)`,
// `word(G, n + 1) begins with word(G, n)`.
//
// Closed statements are worked out: the words are derived and compared.
//
// For all n. Each side is a product of factors f(w_n), where w_n is generation a n + b of a D0L system with rules g, or a fixed
// word, and f are its images and perhaps its reversal. Theorem: let k be a morphism such that on both sides
// k(f(x)) = f(g^a(x)) for every letter x that occurs in the words w_n (for a fixed word g is the identity; written
// backwards if f reverses). Then k takes both sides for n to both sides for n + 1, so if they are equal for n = 0, or one
// begins or ends with the other, so it is for all n. This is the induction of textbooks: with one system and no images k is g
// itself. Where f maps letters to letters k is given by these equations; the others are then tested.
//
// A counterexample is looked for first, among generations that are not too long.
//
// Codes and palindromes are about words too, and so are first-order statements about the infinite word of a system.
//
// A language is a code if no word is a product of its words in two ways (Berstel, Perrin and Reutenauer 2009). For a
// regular language this is a search in its automaton taken twice: both copies read the same word, each may cut it and
// begin again wherever it accepts, and two factorisations differ if at some place one is cut and the other is not. The
// search goes by length, so it finds a shortest word with two factorisations. For finite languages this is the test of
// Sardinas and Patterson (1953), with states of an automaton in the place of remainders.
//
// A prefix code is a code of which no word begins with another one. If no word does and the empty word is none of
// them, the language is a code, so only the two words are looked for. The empty word is in no code.

namespace algae {

namespace {

constexpr std::uint64_t latest_generation = 100'000;

Word reversed(Word word) {
    std::reverse(word.begin(), word.end());
    return word;
}

/// A factor with its generation as a n + b.
struct LinearFactor {
    const WordFactor* written = nullptr;
    D0L system;  // of a generation
    std::uint64_t slope = 0, start = 0;

    /// Its images of a word of the system, or of the fixed word.
    Word image(Word word, const Budget& budget) const {
        for (const Morphism& morphism : written->images) {
            Word next;
            for (const Symbol a : word) {
                if (!morphism.maps(a))
                    throw Error(
                        "a morphism has no image for a letter of the word that it is applied to");
                const Word& image = morphism[a];
                next.insert(next.end(), image.begin(), image.end());
                if (next.size() > budget.letters)
                    throw BoundReached(Bound::letters, "a word has more letters than allowed");
            }
            word = std::move(next);
        }
        return written->reversed ? reversed(std::move(word)) : word;
    }
};

std::uint64_t natural(const Rational& number, const Expression& part) {
    if (!number.is_integer() || number < 0)
        throw Error(to_string(part.place) +
                    ": expected a generation from 0 on for all numbers, such as "
                    "n or 2*n+1, found " +
                    to_text(part));
    if (number > Rational(latest_generation))
        throw BoundReached(Bound::method, "words are worked out up to generation " +
                                              std::to_string(latest_generation));
    return number.numerator().to_uint64();
}

/// The factors of a side in one number `name`, of which `from` is the least value.
std::vector<LinearFactor> factors_of(const std::vector<WordFactor>& side, const std::string& name,
                                     const Rational& from) {
    std::vector<LinearFactor> all;
    for (const WordFactor& factor : side) {
        LinearFactor made{&factor, {}, 0, 0};
        if (factor.system) {
            made.system = as_d0l(*factor.system);
            const auto found = slope_and_start(factor.generation, name);
            if (!found)
                throw Error(to_string(factor.generation.place) +
                            ": expected a generation like n, n + 1 or 2*n, found " +
                            to_text(factor.generation));
            made.slope = natural(found->first, factor.generation);
            made.start = natural(found->second + found->first * from, factor.generation);
        }
        all.push_back(std::move(made));
    }
    return all;
}

/// The word of a side for a value of the number that is so much above the least.
Word word_of(const std::vector<LinearFactor>& side, std::uint64_t n, const Budget& budget) {
    Word all;
    for (const LinearFactor& factor : side) {
        Word word = factor.written->word;
        if (factor.written->system)
            word = derive(factor.system, factor.start + n * factor.slope, budget);
        word = factor.image(std::move(word), budget);
        all.insert(all.end(), word.begin(), word.end());
        if (all.size() > budget.letters)
            throw BoundReached(Bound::letters, "a word has more letters than allowed");
    }
    return all;
}

bool is_so(ComparesWords::Kind kind, const Word& left, const Word& right) {
    using enum ComparesWords::Kind;
    switch (kind) {
        case equal:
            return left == right;
        case unequal:
            return left != right;
        case begins:
            return left.size() >= right.size() &&
                   std::equal(right.begin(), right.end(), left.begin());
        case ends:
            return left.size() >= right.size() &&
                   std::equal(right.rbegin(), right.rend(), left.rbegin());
    }
    return false;
}

/// The equations k(f(x)) = f(g^a(x)), and a morphism k that fulfils them.
class CommonStep {
public:
    explicit CommonStep(const Budget& budget) : budget_(budget) {}

    void add(const std::vector<LinearFactor>& side) {
        for (const LinearFactor& factor : side) {
            if (factor.written->system)
                add_generation(factor);
            else
                for (const Symbol x : factor.written->word) add_letter(factor, x, {x});
        }
    }

    /// The images of letters, if one letter's equation gives each and all are fulfilled.
    std::optional<Morphism> solved() const {
        Morphism step;
        for (const auto& [from, to] : equations_)
            if (from.size() == 1 && !step.maps(from[0])) step.add(from[0], to);
        for (const auto& [from, to] : equations_) {
            Word image;
            for (const Symbol a : from) {
                if (!step.maps(a)) return std::nullopt;
                const Word& part = step[a];
                image.insert(image.end(), part.begin(), part.end());
            }
            if (image != to) return std::nullopt;
        }
        return step;
    }

private:
    void add_generation(const LinearFactor& factor) {
        // The rules of a steps; the letters of the generations from `start` on, each step adding those of the images.
        const D0L& system = factor.system;
        std::map<Symbol, Word> images;
        std::vector<Symbol> open;
        Word first = derive(system, factor.start, budget_);
        const auto meet = [&](const Word& word) {
            for (const Symbol x : word)
                if (images.try_emplace(x).second) open.push_back(x);
        };
        meet(first);
        while (!open.empty()) {
            const Symbol x = open.back();
            open.pop_back();
            D0L of = system;
            of.axiom = {x};
            Word image = derive(of, factor.slope, budget_);
            meet(image);
            images[x] = std::move(image);
        }
        for (const auto& [x, image] : images) add_letter(factor, x, image);
    }

    void add_letter(const LinearFactor& factor, Symbol x, const Word& image) {
        budget_.check();
        equations_.emplace_back(factor.image({x}, budget_), factor.image(image, budget_));
    }

    const Budget& budget_;
    std::vector<std::pair<Word, Word>> equations_;
};

}  // namespace

std::string to_string(ComparesWords::Kind kind) {
    static constexpr std::array texts = {"==", "!=", "begins with", "ends with"};
    return texts.at(static_cast<std::size_t>(kind));
}

Answer judge_words(const ComparesWords& said, const Alphabet& alphabet, const Budget& budget) {
    if (!said.numbers.empty()) return undecided("it speaks of numbers that are not bound");
    const Word left = word_of(factors_of(said.left, "", 0), 0, budget),
               right = word_of(factors_of(said.right, "", 0), 0, budget);
    const auto text = [&](const Word& word) {
        constexpr std::size_t most = 60;
        return word.size() <= most ? spell(alphabet, word) : counted(word.size(), "letter");
    };
    return decided(is_so(said.kind, left, right), steps::ComparedWords{text(left), text(right)});
}

std::optional<Answer> judge_all_words(const Quantified& said, const Claim& claim,
                                      const Budget& budget) {
    const Statement& body = said.body.front();
    const auto* compared = std::get_if<ComparesWords>(&body.says);
    if (!compared || said.bindings.size() != 1) return std::nullopt;
    const QuantifiedName& name = said.bindings.front();
    if (name.domain.kind != Domain::Kind::number || name.domain.max_number || name.domain.max_size)
        return std::nullopt;
    for (const BoundName& number : compared->numbers)
        if (number.number < said.first) return std::nullopt;
    const auto from = least_value(said);
    if (!from) return std::nullopt;
    const auto left = factors_of(compared->left, name.name, Rational(*from)),
               right = factors_of(compared->right, name.name, Rational(*from));
    // What would refute `for all`, or prove `for some`.
    const bool witness_is = said.universal ? body.negated : !body.negated;
    constexpr std::uint64_t most_tried = 200;
    Budget small = budget;
    small.letters = std::min<std::uint64_t>(budget.letters, 200'000);
    std::uint64_t tried = 0;
    try {
        for (; tried < most_tried; ++tried) {
            budget.check();
            const bool holds =
                is_so(compared->kind, word_of(left, tried, small), word_of(right, tried, small));
            if (holds == witness_is)
                return by_values(said, {{name.name, Integer(*from + tried)}}, claim, budget);
        }
    } catch (const BoundReached& reached) {
        if (reached.bound() == Bound::time) throw;
    }
    const bool has_method =
        said.universal && !body.negated && compared->kind != ComparesWords::Kind::unequal;
    if (has_method && tried > 0) {
        CommonStep step(budget);
        step.add(left);
        step.add(right);
        if (auto found = step.solved()) return proved(steps::ByMorphism{std::move(*found), *from});
    }
    return undecided("Nothing else is found for the first " + counted(tried, "number") +
                     (has_method ? "; no morphism takes both sides to the next ones." : "."));
}

// Codes and palindromes.
//
// A language is a code if no word is a product of its words in two ways (Berstel, Perrin and Reutenauer 2009). For a
// regular language this is a search in its automaton taken twice: both copies read the same word, each may cut it and
// begin again wherever it accepts, and two factorisations differ if at some place one is cut and the other is not. The
// search goes by length, so it finds a shortest word with two factorisations. For finite languages this is the test of
// Sardinas and Patterson (1953), with states of an automaton in the place of remainders.
//
// A prefix code is a code of which no word begins with another one. If no word does and the empty word is none of
// them, the language is a code, so only the two words are looked for. The empty word is in no code.

namespace {

/// The copies of the automaton after some letters, and whether they have been cut at different places.
struct Cuts {
    std::size_t left = 0, right = 0;
    bool differ = false;
    bool operator==(const Cuts&) const = default;
    bool operator<(const Cuts& other) const {
        return std::tie(left, right, differ) < std::tie(other.left, other.right, other.differ);
    }
};

/// How a state of the search was come by.
struct Step {
    Cuts before;
    Symbol letter = 0;
    bool cut_left = false, cut_right = false;
};

class Ambiguity {
public:
    Ambiguity(const Language& language, const Dfa& automaton, const Budget& budget)
        : language_(language), automaton_(automaton), budget_(budget) {}

    std::optional<steps::TwoFactorisations> found() {
        const std::vector<std::size_t> distance = distances(automaton_);
        std::vector<Cuts> open{begin()};
        for (std::size_t i = 0; i < open.size(); ++i) {
            if (i % 1024 == 0) {
                budget_.check();
                budget_.check_memory(open.size() * 150, "the pairs of factorisations");
            }
            const Cuts from = open[i];
            for (Symbol a = 0; a < automaton_.letters; ++a) {
                const std::size_t left = automaton_.step(from.left, a),
                                  right = automaton_.step(from.right, a);
                for (const bool cut_left : {false, true})
                    for (const bool cut_right : {false, true}) {
                        if ((cut_left && !automaton_.accepting[left]) ||
                            (cut_right && !automaton_.accepting[right]))
                            continue;
                        const Cuts to{cut_left ? automaton_.initial : left,
                                      cut_right ? automaton_.initial : right,
                                      from.differ || cut_left != cut_right};
                        if (!cut_left && distance[left] == automaton_.states()) continue;
                        if (!cut_right && distance[right] == automaton_.states()) continue;
                        // What stands behind a first cut that is the same could be read by itself.
                        if ((cut_left && cut_right && !to.differ) || to == begin()) continue;
                        if (cut_left && cut_right) return factorisations(from, a);
                        if (before_.try_emplace(to, Step{from, a, cut_left, cut_right}).second)
                            open.push_back(to);
                    }
            }
        }
        return std::nullopt;
    }

private:
    Cuts begin() const { return {automaton_.initial, automaton_.initial, false}; }

    steps::TwoFactorisations factorisations(Cuts at, Symbol last) const {
        std::vector<Step> steps{{at, last, true, true}};
        for (; !(at == begin()); at = steps.back().before) steps.push_back(before_.at(at));
        steps::TwoFactorisations found{language_, {}, {}, {}};
        for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
            found.word.push_back(step->letter);
            if (step->cut_left) found.left.push_back(found.word.size());
            if (step->cut_right) found.right.push_back(found.word.size());
        }
        return found;
    }

    const Language& language_;
    const Dfa& automaton_;
    const Budget& budget_;
    std::map<Cuts, Step> before_;
};

}  // namespace

Answer judge_code(const Language& language, bool prefix, const Alphabet& alphabet,
                  const Budget& budget) {
    const auto regular = regular_value(language, alphabet, budget);
    if (!regular)
        return undecided("whether " + to_string(language, alphabet) +
                         " is a code is decided where it is regular, and no regular expression for "
                         "it is at hand");
    const Dfa& automaton = regular->automaton();
    if (automaton.accepting[automaton.initial])
        return refuted(steps::TwoFactorisations{language, {}, {}, {0}});
    const auto count = number_of_words(*regular);
    const std::size_t words =
        count && *count <= Integer(1'000'000) ? static_cast<std::size_t>(count->to_uint64()) : 0;
    if (!prefix) {
        if (auto found = Ambiguity(language, automaton, budget).found())
            return refuted(std::move(*found));
        return proved(steps::Code{language, false, words});
    }
    std::vector<Word> letters;
    for (Symbol a = 0; a < automaton.letters; ++a) letters.push_back({a});
    const RegularLanguage longer =
        concatenated(*regular, plus(finite_set(letters), budget), budget);
    if (const auto word = shortest_word(intersected(*regular, longer, budget))) {
        Word beginning;
        while (!regular->contains(beginning)) beginning.push_back((*word)[beginning.size()]);
        return refuted(steps::Beginning{language, *word, std::move(beginning)});
    }
    return proved(steps::Code{language, true, words});
}

Answer judge_palindrome(const Word& word) {
    for (std::size_t i = 0; i < word.size() / 2; ++i)
        if (word[i] != word[word.size() - 1 - i]) return refuted(steps::Palindrome{word, i});
    return proved(steps::Palindrome{word, {}});
}

namespace {

AutomaticWord infinite_word(const SourceSystem& system,
                            const std::map<std::string, std::string>& coding,
                            const Alphabet& alphabet) {
    return automatic_word(as_d0l(system), [&](Symbol letter) {
        const auto coded = coding.find(alphabet.name(letter));
        return coded == coding.end() ? alphabet.name(letter) : coded->second;
    });
}

AutomaticRelation addition(const AutomaticWord& word, const Budget& budget) {
    static const FirstOrderStatement sum = read_first_order("x + y = z", "", "", {});
    return decide_first_order(sum, word, budget).relation;
}

}  // namespace

Answer judge_infinite_word(const HoldsInWord& said, const Alphabet& alphabet,
                           const Budget& budget) {
    const AutomaticWord word = infinite_word(*said.system, said.coding, alphabet);
    WorkCount largest("states of the largest automaton so far:");
    const FirstOrderAnswer found = decide_first_order(
        *said.says, word, budget, [&](std::size_t states) { largest.at(states); });
    steps::ByAutomata proof{said.system->name,      found.holds, found.witness, found.largest,
                            word.numeration.base(), {}};
    if (adds(*said.says)) proof.addition = addition(word, budget);
    return found.holds ? proved(std::move(proof)) : refuted(std::move(proof));
}

namespace {

/// Whether a statement is about the number of factors of n letters alone.
bool is_on_factors(const CountingStatement& says) {
    static const auto first_place =
        to_json(read_first_order("not for some j with j < i: equal(i, j, n)", "", "", {}));
    return says.parts.size() == 1 && to_json(says.parts[0].places) == first_place;
}

/// A proof that the word of a primitive morphism has so many factors of n letters for all n >= from, where their number is linear from
/// some n on; addition need not be regular. Nothing if it is not so or not known.
std::optional<steps::ByBispecialFactors> by_bispecial_factors(const CountsInWord& said,
                                                              const Budget& budget) {
    const CountingStatement& says = *said.says;
    if (!said.coding.empty() || !is_on_factors(says)) return std::nullopt;
    try {
        const D0L system = as_d0l(*said.system);
        if (!primitivity(growth_matrix(system)).exponent) return std::nullopt;
        const ComplexityForAll all =
            complexity_for_all(system.rules, Numeration(system).letters().front(), budget);
        const auto linear = all.linear();
        if (!linear) return std::nullopt;
        const Integer end = std::max(says.from, linear->from) + 1;
        if (end > 1'000'000) return std::nullopt;  // numbers are tried one by one
        for (Integer n = says.from; n <= end; n += 1)
            if (!(says.parts[0].times * all.value(n) + says.slope * n + says.constant).is_zero())
                return std::nullopt;
        return steps::ByBispecialFactors{said.system->name, all.letters,      all.single,
                                         linear->slope,     linear->constant, linear->from};
    } catch (const Error&) {
        return std::nullopt;  // it has no infinite word of its own
    } catch (const BoundReached& bound) {
        if (bound.bound() == Bound::time) throw;
        return std::nullopt;
    }
}

}  // namespace

Answer judge_counts(const CountsInWord& said, const Alphabet& alphabet, const Budget& budget) {
    if (auto proof = by_bispecial_factors(said, budget)) return proved(std::move(*proof));
    const AutomaticWord word = infinite_word(*said.system, said.coding, alphabet);
    const CountingAnswer found = decide_counting(*said.says, word, budget);
    steps::ByAutomata proof{said.system->name,      !found.fails, {},        0,
                            word.numeration.base(), {},           found.size};
    if (found.fails) proof.witness = {{"n", *found.fails}};
    for (const auto& [times, places] : said.says->parts)
        if (adds(places) && proof.addition.edges.empty()) proof.addition = addition(word, budget);
    return found.fails ? refuted(std::move(proof)) : proved(std::move(proof));
}

// Critical exponents and circular systems.
//
// The critical exponent is found as a number of the field of the rate of growth (`critical_exponent`). It is compared with the number of the
// claim as a root of its minimal polynomial: the characteristic polynomial of the multiplication by a number of a field is a power of it.
//
// A system is circular where its morphism is injective and no word that grows has all its powers among the factors (Klouda and Starosta, 2019).
// Then some delay is enough, which is looked for in windows: twice as long ones each time, then between.

namespace {

/// The real roots of a polynomial without multiple ones, in increasing order.
std::vector<Ball> real_roots(const Polynomial& polynomial, long bits) {
    std::vector<Ball> found;
    for (Root& one : roots(polynomial, bits))
        if (one.is_real) found.push_back(std::move(one.real));
    std::sort(found.begin(), found.end(),
              [](const Ball& x, const Ball& y) { return compare(x, y) == Order::less; });
    return found;
}

std::strong_ordering compared(const ClaimedNumber& left, const ClaimedNumber& right) {
    if (left.polynomial == right.polynomial) return left.root <=> right.root;
    for (long bits = 64;; bits *= 2) {
        const Order order = compare(real_roots(left.polynomial, bits).at(left.root),
                                    real_roots(right.polynomial, bits).at(right.root));
        if (order == Order::less) return std::strong_ordering::less;
        if (order == Order::greater) return std::strong_ordering::greater;
    }
}

/// The number as a root of its minimal polynomial; it is in the field of the rate.
ClaimedNumber as_root(const Frequency& number, const Rate& rate) {
    if (!number.number())
        throw BoundReached(Bound::method,
                           "the critical exponent is in a field of a degree above 8");
    const auto& [above, below] = *number.number();
    const NumberField field(rate.minimal_polynomial());
    const auto degree = static_cast<std::size_t>(rate.degree());
    IntegerMatrix times(degree, degree);
    for (std::size_t column = 0; column < degree; ++column) {
        const Polynomial product = field.multiply(above, Polynomial::monomial(1, column));
        for (std::size_t row = 0; row < degree; ++row)
            times(row, column) = product.coefficient(row);
    }
    const Polynomial characteristic = characteristic_polynomial(times);
    std::vector<Integer> scaled;  // of the quotient
    for (std::size_t k = 0; k < characteristic.coefficients().size(); ++k)
        scaled.push_back(characteristic.coefficient(k) * power(below.coefficient(0), k));
    ClaimedNumber found{factorise(Polynomial(std::move(scaled))).powers.front().factor, 0,
                        number.exact()};
    if (found.polynomial.leading_coefficient() < 0) found.polynomial = -found.polynomial;
    for (long bits = 64;; bits *= 2) {
        const std::vector<Ball> all = real_roots(found.polynomial, bits);
        std::size_t near = 0;
        for (std::size_t i = 0; i < all.size(); ++i)
            if (all[i].overlaps(number.enclosure(bits))) {
                found.root = i;
                ++near;
            }
        if (near == 1) return found;
    }
}

/// The least power of the morphism that takes a word to a power, above 1, of a conjugate of it; nothing if none up to the number of letters is one.
std::optional<std::uint64_t> power_that_repeats(const D0L& system, const Word& word,
                                                const Budget& budget) {
    Word image = word;
    for (std::uint64_t power = 1; power <= system.letters.size(); ++power) {
        budget.check();
        image = system.rules(image);
        if (image.size() > budget.letters) return std::nullopt;
        const Word root = primitive_root(image);
        if (image.size() > word.size() && root.size() == word.size() &&
            least_conjugate(root) == least_conjugate(word))
            return power;
    }
    return std::nullopt;
}

/// Whether a word that grows has all its powers among the factors; and one, if it is seen by a power of the morphism.
std::pair<bool, std::optional<steps::RepeatsForEver>> growing_repetition(const std::string& name,
                                                                         const D0L& system,
                                                                         const Budget& budget) {
    bool grows = false;
    for (const InfiniteRepetition& one : infinite_repetitions(system, budget)) {
        if (!one.grows) continue;
        grows = true;
        if (const auto power = power_that_repeats(system, one.word, budget))
            return {true, steps::RepeatsForEver{name, one.word, *power}};
    }
    return {grows, std::nullopt};
}

}  // namespace

Answer judge_critical_exponent(const HasCriticalExponent& said, const Alphabet& alphabet,
                               const Budget& budget) {
    const D0L system = as_d0l(*said.system);
    std::optional<CriticalExponent> found;
    if (said.coding.empty()) try {
            found = critical_exponent(system, budget);
        } catch (const Error&) {  // the first letter does not come back
        } catch (const BoundReached& bound) {
            if (bound.bound() == Bound::time) throw;
        }
    if (!found)
        found = critical_exponent(infinite_word(*said.system, said.coding, alphabet), budget);
    if (found->infinite) {
        const bool holds = is_so(said.comparison, std::strong_ordering::greater);
        D0L own = system;  // whose words begin the infinite word
        own.axiom = {Numeration(system).letters().front()};
        std::optional<steps::RepeatsForEver> proof;
        if (is_propagating(system))
            proof = growing_repetition(said.system->name, own, budget).second;
        return decided(holds, proof ? *proof : steps::RepeatsForEver{said.system->name, {}, 1});
    }
    Rate rate;
    for (const Component& part : components(growth_matrix(system), budget).list)
        if (part.rate) rate = std::max(rate, *part.rate);
    ClaimedNumber exponent = as_root(*found->value, rate);
    const bool holds = is_so(said.comparison, compared(exponent, said.number));
    return decided(holds,
                   steps::ByRepetitions{said.system->name, std::move(exponent), found->factor});
}

namespace {

/// Whether all factors of some length have a place where every word whose image they stand in is cut.
bool is_synchronised(const D0L& system, std::size_t length, const Budget& budget) {
    std::map<Word, std::vector<bool>> cuts;  // the places that all have in common
    std::size_t size = 0;
    for (const Word& word : factors(system, length, budget).words) {
        Word image;
        std::vector<bool> is_cut{true};
        for (const Symbol letter : word) {
            const Word& part = system.successor(letter);
            image.insert(image.end(), part.begin(), part.end());
            is_cut.resize(image.size() + 1);
            is_cut.back() = true;
        }
        for (std::size_t begin = 0; begin + length <= image.size(); ++begin) {
            budget.check();
            const auto from = static_cast<std::ptrdiff_t>(begin),
                       to = static_cast<std::ptrdiff_t>(begin + length);
            std::vector<bool> here(is_cut.begin() + from, is_cut.begin() + to + 1);
            const auto [known, is_new] =
                cuts.try_emplace(Word(image.begin() + from, image.begin() + to), here);
            if (is_new) {
                budget.check_memory(size += length * (sizeof(Symbol) + 1) + 100, "the windows");
                continue;
            }
            for (std::size_t i = 0; i <= length; ++i)
                known->second[i] = known->second[i] && here[i];
        }
    }
    return std::all_of(cuts.begin(), cuts.end(), [](const auto& one) {
        return std::find(one.second.begin(), one.second.end(), true) != one.second.end();
    });
}

}  // namespace

Answer judge_circular(const IsCircular& said, const Budget& budget) {
    const D0L system = as_d0l(*said.system);
    if (!is_propagating(system))
        return undecided("Circular systems have morphisms that erase no letter, and that of " +
                         said.system->name + " erases one.");
    const bool is_injective = made_injective({system.axiom, system.rules}, budget).steps == 0;
    if (is_injective) {
        auto [grows, proof] = growing_repetition(said.system->name, system, budget);
        if (proof) return refuted(std::move(*proof));
        if (grows) return refuted(steps::RepeatsForEver{said.system->name, {}, 1});
    }
    constexpr std::size_t most_not_injective = 64;
    std::size_t below = 0, length = 1;  // no factors of `below` letters are synchronised
    WorkCount lengths("windows of length");
    while (!is_synchronised(system, length, budget)) {
        if (!is_injective && length >= most_not_injective)
            return undecided("The morphism of " + said.system->name +
                             " is not injective, and some factors of " + std::to_string(length) +
                             " letters have no place where all words are cut.");
        below = length;
        length *= 2;
        lengths.at(length);
    }
    while (length - below > 1) {
        const std::size_t middle = below + (length - below) / 2;
        (is_synchronised(system, middle, budget) ? length : below) = middle;
    }
    return proved(steps::Synchronised{said.system->name, length - 1});
}

}  // namespace algae
