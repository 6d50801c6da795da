#include <algorithm>
#include <numeric>
#include <set>

#include "exact/exact.hpp"
#include "verify/detail/checking.hpp"
#include "verify/detail/languages.hpp"

// Languages of powers, {a^n b^(2n+1) : n >= 0}; context-free grammars; codes and palindromes.
//
// A word is compared with those for all values of the numbers that make words of its length. Between which states of an automaton the
// words lead is worked out value by value: a word u repeated e times leads between the same states as one repeated e + p
// times, where p is the period of the powers of its relation, so only e modulo p counts once e is large. For n^k b^n modulo p
// the values repeat when n and all b^n modulo p come again.
//
// That two sequences of words are the same for every n is seen by rewriting both until nothing changes: a constant part
// of an exponent becomes letters in front, a letter behind a power whose word begins with it moves in front, which
// turns the word round, neighbours with the same word become one power.

namespace algae::verify {

namespace {

using PowerTerm = Powers::Term;
using Values = std::vector<std::uint64_t>;

bool is_constant(const PowerTerm& term) { return term.power == 0 && term.base == 1; }

bool is_linear_term(const PowerTerm& term) {
    return is_constant(term) || (term.power == 1 && term.base == 1);
}

bool stands_once(const Powers::Block& block) {
    return block.exponent.size() == 1 && is_constant(block.exponent.front()) &&
           block.exponent.front().coefficient == 1;
}

}  // namespace

bool varies(const Powers::Block& block) {
    return !std::all_of(block.exponent.begin(), block.exponent.end(), is_constant);
}

bool is_linear(const Powers& powers) {
    for (const Powers::Block& block : powers.blocks)
        if (!std::all_of(block.exponent.begin(), block.exponent.end(), is_linear_term))
            return false;
    return true;
}

namespace {

Integer exponent(const Powers::Block& block, const Values& values) {
    Integer sum = 0;
    for (const PowerTerm& term : block.exponent)
        sum += is_constant(term)
                   ? term.coefficient
                   : term.coefficient * power(Integer(values[term.number]), term.power) *
                         power(term.base, values[term.number]);
    return sum;
}

std::string term_text(const PowerTerm& term, const std::vector<std::string>& names) {
    if (is_constant(term)) return to_string(term.coefficient);
    std::string text = term.coefficient == 1 ? "" : to_string(term.coefficient) + "*";
    const std::string& name = names[term.number];
    if (term.power > 0) text += name;
    if (term.power > 1) text += "^" + std::to_string(term.power);
    if (term.base != 1) text += (term.power > 0 ? "*" : "") + to_string(term.base) + "^" + name;
    return text;
}

/// A number of repetitions that is written out.
std::size_t written_out(const Integer& count) {
    if (count > Integer(10'000))
        throw BoundReached(Bound::method, "a power with more than 10000 repetitions");
    return static_cast<std::size_t>(count.to_uint64());
}

void append(Word& to, const Word& word, std::size_t times) {
    for (; times > 0; --times) to.insert(to.end(), word.begin(), word.end());
}

}  // namespace

Language Reader::powers(const Field& field) const {
    field.only({"powers", "numbers"});
    auto read = std::make_shared<Powers>();
    for (const Field& each : field.at("numbers").list()) {
        each.only({"name", "least"});
        const std::string& name = name_in(each.at("name"));
        if (std::count(read->names.begin(), read->names.end(), name) > 0)
            each.at("name").fail("the number '" + name + "' stands here twice");
        read->names.push_back(name);
        read->least.push_back(each.at("least").number());
        if (read->least.back() > 1'000'000) each.at("least").fail("the least value is too large");
    }
    if (read->names.empty() || read->names.size() > 2)
        field.at("numbers").fail("expected one or two numbers");
    std::set<std::size_t> used;
    for (const Field& each : field.at("powers").list()) {
        each.only({"word", "exponent"});
        Powers::Block block{word(each.at("word")), {}};
        if (block.word.empty()) each.at("word").fail("the empty word has no powers here");
        for (const Field& one : each.at("exponent").list()) {
            one.only({"coefficient", "number", "power", "base"});
            PowerTerm term;
            term.coefficient = one.at("coefficient").integer();
            if (term.coefficient < 1) one.at("coefficient").fail("expected a number from 1 on");
            if (one.has("number")) {
                const std::string& name = one.at("number").text();
                const auto found = std::find(read->names.begin(), read->names.end(), name);
                if (found == read->names.end())
                    one.at("number").fail("no number is called '" + name + "'");
                term.number = static_cast<std::size_t>(found - read->names.begin());
                if (one.has("power")) term.power = one.at("power").number();
                if (one.has("base")) term.base = one.at("base").integer();
                if (term.base < 1) one.at("base").fail("expected a number from 1 on");
                if (is_constant(term)) one.fail("the number has no power here and is in none");
                if (term.power > 1000) one.at("power").fail("the power is too large");
                if (read->names.size() > 1 && !is_linear_term(term))
                    one.fail("with two numbers exponents are sums of multiples of them");
                used.insert(term.number);
            } else {
                one.only({"coefficient"});
            }
            block.exponent.push_back(std::move(term));
        }
        if (block.exponent.empty()) each.at("exponent").fail("expected a term");
        read->blocks.push_back(std::move(block));
    }
    if (used.size() < read->names.size())
        field.at("numbers").fail("a number stands in no exponent");
    Tree tree;
    tree.kind = Tree::Kind::powers;
    tree.powers = std::move(read);
    return std::make_shared<const Tree>(std::move(tree));
}

std::string powers_text(const Powers& powers,
                        const std::function<std::string(const Word&)>& word_text) {
    std::string text, conditions;
    for (const Powers::Block& block : powers.blocks) {
        std::string sum;
        for (const PowerTerm& term : block.exponent)
            sum += (sum.empty() ? "" : "+") + term_text(term, powers.names);
        text += (text.empty() ? "" : " ") + ("(" + word_text(block.word)) + ")^(" + sum + ")";
    }
    for (std::size_t i = 0; i < powers.names.size(); ++i)
        conditions +=
            (i > 0 ? ", " : "") + powers.names[i] + " >= " + std::to_string(powers.least[i]);
    return "{" + text + " : " + conditions + "}";
}

bool has_word(const Powers& powers, const Word& word, const Budget& budget) {
    const auto length = [&](const Values& values) {
        Integer sum = 0;
        for (const Powers::Block& block : powers.blocks)
            sum += exponent(block, values) * Integer(block.word.size());
        return sum;
    };
    const auto is_word = [&](const Values& values) {
        Word made;
        for (const Powers::Block& block : powers.blocks)
            append(made, block.word, static_cast<std::size_t>(exponent(block, values).to_uint64()));
        return made == word;
    };
    const Integer wanted(word.size());
    for (Values values = powers.least; length(values) <= wanted; ++values[0]) {
        budget.check();
        if (values.size() == 1) {
            if (length(values) == wanted && is_word(values)) return true;
            continue;
        }
        for (Values both = values; length(both) <= wanted; ++both[1])
            if (length(both) == wanted && is_word(both)) return true;
    }
    return false;
}

Language regular_form(const Powers& powers) {
    if (!is_linear(powers)) return nullptr;
    std::vector<int> uses(powers.names.size(), 0);
    for (const Powers::Block& block : powers.blocks)
        for (const PowerTerm& term : block.exponent)
            if (!is_constant(term)) ++uses[term.number];
    if (std::any_of(uses.begin(), uses.end(), [](int times) { return times > 1; })) return nullptr;
    Language whole = words_of({Word{}});
    const auto add = [&](Language part) {
        whole = combination(Tree::Kind::concatenation, {whole, std::move(part)});
    };
    for (const Powers::Block& block : powers.blocks) {
        Word first;
        append(first, block.word, written_out(exponent(block, powers.least)));
        add(words_of({first}));
        for (const PowerTerm& term : block.exponent) {
            if (is_constant(term)) continue;
            Word round;
            append(round, block.word, written_out(term.coefficient));
            add(combination(Tree::Kind::star, {words_of({round})}));
        }
    }
    return whole;
}

std::optional<Powers> image_of_powers(const Powers& powers, const std::map<Symbol, Word>& morphism,
                                      const Budget& budget) {
    Powers mapped = powers;
    mapped.blocks.clear();
    for (Powers::Block block : powers.blocks) {
        const auto image = image_of(block.word, morphism, budget);
        if (!image) throw BoundReached(Bound::method, "a letter of a power has no image");
        block.word = *image;
        if (!block.word.empty()) mapped.blocks.push_back(std::move(block));
    }
    std::set<std::size_t> used;
    for (const Powers::Block& block : mapped.blocks)
        for (const PowerTerm& term : block.exponent)
            if (!is_constant(term)) used.insert(term.number);
    if (used.size() < powers.names.size()) return std::nullopt;
    return mapped;
}

namespace {

/// The powers of a relation, and from which one on they repeat with which period.
struct Repetition {
    std::vector<BooleanMatrix> powers;
    std::uint64_t from = 0, period = 1;

    const BooleanMatrix& power(const Integer& times) const {
        const bool beyond = times >= Integer(from + period);
        const Integer left =
            beyond ? Integer(from) + remainder(times - Integer(from), Integer(period)) : times;
        return powers[static_cast<std::size_t>(left.to_uint64())];
    }
};

constexpr std::uint64_t most_rounds = 1'000'000;

std::uint64_t common_multiple(std::uint64_t one, std::uint64_t other) {
    const std::uint64_t rest = other / std::gcd(one, other);
    if (one > most_rounds / rest)
        throw BoundReached(Bound::method, "powers repeat on the automaton only after a million");
    return one * rest;
}

Repetition repetition(const BooleanMatrix& once, const Budget& budget) {
    Repetition found;
    BooleanMatrix power = BooleanMatrix::identity(once.size());
    for (;;) {
        const auto seen = std::find(found.powers.begin(), found.powers.end(), power);
        if (seen != found.powers.end()) {
            found.from = static_cast<std::uint64_t>(seen - found.powers.begin());
            found.period = found.powers.size() - found.from;
            return found;
        }
        budget.check_memory(static_cast<std::uint64_t>(found.powers.size() + 1) * once.size() *
                                (once.size() / 8 + 8),
                            "the powers of a relation between derivatives");
        found.powers.push_back(power);
        power = power.then(once);
    }
}

}  // namespace

BooleanMatrix paths_of(const Powers& powers, const std::vector<BooleanMatrix>& letters,
                       std::size_t states, const Budget& budget) {
    std::vector<Repetition> repetitions;
    std::uint64_t from = 0, period = 1;
    for (const Powers::Block& block : powers.blocks) {
        BooleanMatrix once = BooleanMatrix::identity(states);
        for (const Symbol a : block.word) once = once.then(letters[a]);
        repetitions.push_back(repetition(once, budget));
        from = std::max(from, repetitions.back().from);
        period = common_multiple(period, repetitions.back().period);
    }
    BooleanMatrix all(states);
    const auto add = [&](const std::vector<Integer>& exponents) {
        budget.check();
        BooleanMatrix one = BooleanMatrix::identity(states);
        for (std::size_t i = 0; i < repetitions.size(); ++i)
            one = one.then(repetitions[i].power(exponents[i]));
        all |= one;
    };
    const auto exponents_of = [&](const Values& values) {
        std::vector<Integer> exponents;
        for (const Powers::Block& block : powers.blocks)
            exponents.push_back(exponent(block, values));
        return exponents;
    };
    if (powers.names.size() == 2) {
        for (std::uint64_t n = 0; n < from + period; ++n)
            for (std::uint64_t m = 0; m < from + period; ++m)
                add(exponents_of({powers.least[0] + n, powers.least[1] + m}));
        return all;
    }
    // Word by word, until every exponent that varies is so large that only its remainder counts.
    std::uint64_t n = powers.least[0];
    for (;; ++n) {
        const auto exponents = exponents_of({n});
        add(exponents);
        bool large = true;
        for (std::size_t i = 0; i < exponents.size(); ++i)
            large = large && (!varies(powers.blocks[i]) || exponents[i] >= Integer(from));
        if (large) break;
    }
    // Then by remainders, until n and all powers b^n come again.
    const Integer modulus(period);
    std::map<Integer, Integer> powers_of;  // b^n by b
    for (const Powers::Block& block : powers.blocks)
        for (const PowerTerm& term : block.exponent) powers_of[term.base] = 0;
    for (auto& [base, value] : powers_of) value = remainder(power(base, n), modulus);
    std::set<std::pair<std::uint64_t, std::map<Integer, Integer>>> seen;
    for (; seen.emplace(n % period, powers_of).second; ++n) {
        if (seen.size() > most_rounds)
            throw BoundReached(Bound::method, "exponents repeat only after a million words");
        std::vector<Integer> exponents;
        for (const Powers::Block& block : powers.blocks) {
            Integer sum = 0;
            for (const PowerTerm& term : block.exponent)
                sum += is_constant(term)
                           ? term.coefficient
                           : term.coefficient * power(Integer(n % period), term.power) *
                                 powers_of.at(term.base);
            // The remainder, beyond where only that counts.
            if (varies(block)) sum = Integer(from * period) + remainder(sum, modulus);
            exponents.push_back(std::move(sum));
        }
        add(exponents);
        for (auto& [base, value] : powers_of) value = remainder(value * base, modulus);
    }
    return all;
}

// --- Sequences ---

namespace {

/// By base and power of n: the coefficients.
using Function = std::map<std::pair<Integer, std::uint64_t>, Integer>;
const std::pair<Integer, std::uint64_t> constant_part{1, 0};

struct Piece {
    Word word;
    Function times;
    bool operator==(const Piece&) const = default;
};
using Pieces = std::vector<Piece>;

void add(Function& to, const Function& more) {
    for (const auto& [of, coefficient] : more)
        if ((to[of] += coefficient).is_zero()) to.erase(of);
}

/// The function at n + 1.
Function at_next(const Function& function) {
    Function next;
    for (const auto& [of, coefficient] : function) {
        // (n + 1)^k by Pascal's triangle.
        std::vector<Integer> row{1};
        for (std::uint64_t k = 0; k < of.second; ++k) {
            row.push_back(0);
            for (std::size_t i = row.size() - 1; i > 0; --i) row[i] += row[i - 1];
        }
        for (std::size_t j = 0; j < row.size(); ++j)
            add(next, {{{of.first, j}, coefficient * of.first * row[j]}});
    }
    return next;
}

Function constantly(const Integer& value) {
    return value.is_zero() ? Function{} : Function{{constant_part, value}};
}

/// Rewritten until nothing changes.
Pieces rewritten(Pieces pieces, const Budget& budget) {
    for (bool changed = true; changed;) {
        budget.check();
        changed = false;
        for (std::size_t i = 0; i < pieces.size() && !changed; ++i) {
            Piece& piece = pieces[i];
            const auto place = pieces.begin() + static_cast<std::ptrdiff_t>(i);
            const bool is_letter = piece.word.size() == 1 && piece.times == constantly(1);
            changed = true;
            if (piece.word.empty() || piece.times.empty()) {
                pieces.erase(place);
            } else if (const auto fixed = piece.times.find(constant_part);
                       fixed != piece.times.end() && !is_letter) {
                Word written;
                append(written, piece.word, written_out(fixed->second));
                piece.times.erase(fixed);
                Pieces letters;
                for (const Symbol a : written) letters.push_back({{a}, constantly(1)});
                pieces.insert(place, letters.begin(), letters.end());
            } else if (is_letter) {
                changed = i > 0 && pieces[i - 1].times.count(constant_part) == 0 &&
                          pieces[i - 1].word.front() == piece.word.front();
                if (changed) {
                    Word& word = pieces[i - 1].word;
                    std::rotate(word.begin(), word.begin() + 1, word.end());
                    std::swap(pieces[i - 1], piece);
                }
            } else {
                std::size_t size = 1;  // of the shortest word of which this is a power
                const auto is_period = [&] {
                    if (piece.word.size() % size != 0) return false;
                    for (std::size_t k = size; k < piece.word.size(); ++k)
                        if (piece.word[k] != piece.word[k - size]) return false;
                    return true;
                };
                while (!is_period()) ++size;
                if (size < piece.word.size()) {
                    for (auto& [of, coefficient] : piece.times)
                        coefficient *= Integer(piece.word.size() / size);
                    piece.word.resize(size);
                } else if (i > 0 && pieces[i - 1].times.count(constant_part) == 0 &&
                           pieces[i - 1].word == piece.word) {
                    add(pieces[i - 1].times, piece.times);
                    pieces.erase(place);
                } else {
                    changed = false;
                }
            }
        }
    }
    return pieces;
}

/// The words of a language of powers with one number from its least value on, or of a grammar S -> x S y | z.
std::optional<Pieces> sequence_of(const Language& language) {
    Pieces pieces;
    if (language->kind == Tree::Kind::powers) {
        const Powers& powers = *language->powers;
        if (powers.names.size() != 1) return std::nullopt;
        for (const Powers::Block& block : powers.blocks) {
            Piece piece{block.word, {}};
            for (const PowerTerm& term : block.exponent)
                add(piece.times, {{{term.base, term.power}, term.coefficient}});
            for (std::uint64_t n = 0; n < powers.least[0]; ++n) piece.times = at_next(piece.times);
            pieces.push_back(std::move(piece));
        }
        return pieces;
    }
    if (language->kind != Tree::Kind::generated) return std::nullopt;
    const System& system = *language->system;
    if (system.context || system.tables.size() != 1 || system.axiom.size() != 1 ||
        system.terminal[system.axiom[0]])
        return std::nullopt;
    const Symbol start = system.axiom[0];
    const auto& successors = system.tables[0][start];
    std::vector<Word> rounds, ends;
    bool stays = false;
    for (const Word& word : successors) {
        if (word == Word{start}) {
            stays = true;
            continue;
        }
        const auto starts = std::count(word.begin(), word.end(), start);
        for (const Symbol a : word)
            if (a != start &&
                (!system.terminal[a] || system.tables[0][a] != std::vector<Word>{Word{a}}))
                return std::nullopt;
        if (starts > 1) return std::nullopt;
        (starts == 1 ? rounds : ends).push_back(word);
    }
    if (!stays || rounds.size() != 1 || ends.size() != 1) return std::nullopt;
    const Word& round = rounds[0];
    const auto middle = std::find(round.begin(), round.end(), start);
    const Function each{{{Integer(1), 1}, Integer(1)}};
    return Pieces{{Word(round.begin(), middle), each},
                  {ends[0], constantly(1)},
                  {Word(middle + 1, round.end()), each}};
}

}  // namespace

void check_same_powers(const Obligation& task) {
    const auto left = sequence_of(task.language()), right = sequence_of(task.language(1));
    if (!left && !right) task.refuse("neither side is a sequence of powers of one number");
    if (left && right) {
        if (rewritten(*left, task.budget) != rewritten(*right, task.budget))
            task.refuse("the words for n are not seen to be the same");
        return;
    }
    const Pieces& pieces = left ? *left : *right;
    const Language& other = task.language(left ? 1 : 0);
    if (other->kind != Tree::Kind::generated || !is_d0l(*other->system))
        task.refuse("the other side is not given by a D0L system");
    const System& system = *other->system;
    Pieces first, images, next;
    for (const Piece& piece : pieces) {
        Integer begun = 0;
        for (const auto& [of, coefficient] : piece.times)
            if (of.second == 0) begun += coefficient;
        first.push_back({piece.word, constantly(begun)});
        Word image;
        for (const Symbol a : piece.word) append(image, system.tables[0][a].front(), 1);
        images.push_back({image, piece.times});
        next.push_back({piece.word, at_next(piece.times)});
    }
    if (rewritten(first, task.budget) != rewritten({{system.axiom, constantly(1)}}, task.budget))
        task.refuse("the axiom is not the first word");
    if (rewritten(images, task.budget) != rewritten(next, task.budget))
        task.refuse("the rules are not seen to make the next word of each");
}

// --- Families ---

void check_endless_powers(const Obligation& task) {
    if (task.language()->kind != Tree::Kind::powers)
        task.refuse("the language is not one of powers");
}

void check_powers_beyond(const Obligation& task) {
    const std::string& family = task.statement.family;
    const Tree& language = *task.language();
    if ((family != "REG" && family != "CF") || language.kind != Tree::Kind::powers)
        task.refuse("this shows nothing of " + family);
    const Powers& powers = *language.powers;
    if (powers.names.size() != 1) task.refuse("the powers have two numbers");
    if (!is_linear(powers)) return;  // its lengths have no arithmetic progression
    // A letter of its own for each power that varies.
    std::size_t with_own_letter = 0;
    std::map<Symbol, std::set<std::size_t>> stands_in;
    for (std::size_t i = 0; i < powers.blocks.size(); ++i)
        for (const Symbol a : powers.blocks[i].word) stands_in[a].insert(i);
    for (const Powers::Block& block : powers.blocks)
        if (varies(block) && std::any_of(block.word.begin(), block.word.end(),
                                         [&](Symbol a) { return stands_in.at(a).size() == 1; }))
            ++with_own_letter;
    if (with_own_letter >= (family == "REG" ? 2u : 3u)) return;
    if (family == "CF") task.refuse("fewer than three powers that vary have a letter of their own");
    for (std::size_t i = 0; i < powers.blocks.size(); ++i) {
        const Powers::Block& block = powers.blocks[i];
        const auto place = powers.blocks.begin() + static_cast<std::ptrdiff_t>(i);
        if (!stands_once(block) || std::none_of(powers.blocks.begin(), place, varies) ||
            std::none_of(place, powers.blocks.end(), varies))
            continue;
        for (const Symbol a : block.word)
            if (stands_in.at(a).size() == 1 &&
                std::count(block.word.begin(), block.word.end(), a) == 1)
                return;
    }
    task.refuse("no letter stands in each word once between powers that vary");
}

namespace {

bool powers_are_nested(const Powers& powers) {
    if (!is_linear(powers)) return false;
    std::vector<std::vector<std::size_t>> places(powers.names.size());
    for (std::size_t i = 0; i < powers.blocks.size(); ++i)
        for (std::size_t number = 0; number < places.size(); ++number)
            if (std::any_of(powers.blocks[i].exponent.begin(), powers.blocks[i].exponent.end(),
                            [&](const PowerTerm& term) {
                                return !is_constant(term) && term.number == number;
                            }))
                places[number].push_back(i);
    for (const auto& of : places)
        if (of.size() > 2) return false;
    for (const auto& one_number : places)
        for (const auto& other : places)
            if (one_number.front() < other.front() && other.front() < one_number.back() &&
                one_number.back() < other.back())
                return false;
    return true;
}

/// Whether the language is seen to be context-free.
bool is_context_free(const Obligation& task, const Language& language) {
    using enum Tree::Kind;
    const auto part = [&](std::size_t i) { return is_context_free(task, language->parts[i]); };
    const auto regular = [&](const Language& each) {
        try {
            check_regular(task, each);
            return true;
        } catch (const Flaw&) {
            return false;
        }
    };
    switch (language->kind) {
        case words:
            return true;
        case generated:
            return rewrites_singly(*language->system) || regular(language);
        case powers:
            return powers_are_nested(*language->powers) || regular(language);
        case united:
        case concatenation:
            return part(0) && part(1);
        case star:
        case plus:
        case reversal:
        case image:
        case inverse_image:
            return part(0);
        case intersection:
            return (part(0) && regular(language->parts[1])) ||
                   (part(1) && regular(language->parts[0]));
        case difference:
            return part(0) && regular(language->parts[1]);
        default:
            return regular(language);
    }
}

}  // namespace

void check_context_free(const Obligation& task) {
    if (task.statement.family != "CF") task.wrong_kind();
    if (!is_context_free(task, task.language()))
        task.refuse("a part of the expression is not seen to be context-free");
}

// --- Codes and palindromes ---

namespace {

/// The test of Sardinas and Patterson.
bool is_finite_code(const std::set<Word>& words, const Budget& budget) {
    const auto remainder_of = [](const Word& whole, const Word& beginning) {
        return Word(whole.begin() + static_cast<std::ptrdiff_t>(beginning.size()), whole.end());
    };
    const auto begins = [](const Word& whole, const Word& beginning) {
        return beginning.size() <= whole.size() &&
               std::equal(beginning.begin(), beginning.end(), whole.begin());
    };
    std::set<Word> known;
    std::vector<Word> open;
    const auto add = [&](Word word) {
        if (known.insert(word).second) open.push_back(std::move(word));
    };
    for (const Word& one : words)
        for (const Word& other : words)
            if (one != other && begins(one, other)) add(remainder_of(one, other));
    while (!open.empty()) {
        budget.check();
        const Word rest = std::move(open.back());
        open.pop_back();
        if (words.count(rest) > 0) return false;
        for (const Word& word : words) {
            if (begins(word, rest)) add(remainder_of(word, rest));
            if (begins(rest, word)) add(remainder_of(rest, word));
        }
    }
    return words.count(Word{}) == 0;
}

/// Both factorisations as ways through the automaton: pairs of states, with `true` once they were cut apart.
bool is_regular_code(const Derivatives::Automaton& automaton, const Budget& budget) {
    using State = std::tuple<std::size_t, std::size_t, bool>;
    if (automaton.accepting[0]) return false;
    std::set<State> known{{0, 0, false}};
    std::vector<State> open{{0, 0, false}};
    while (!open.empty()) {
        budget.check();
        const auto [left, right, apart] = open.back();
        open.pop_back();
        for (std::size_t a = 0; a < automaton.next[left].size(); ++a) {
            const std::size_t one = automaton.next[left][a], other = automaton.next[right][a];
            const bool ends = automaton.accepting[one], other_ends = automaton.accepting[other];
            if (apart && ends && other_ends) return false;
            std::vector<State> next{{one, other, apart}};
            if (ends) next.emplace_back(0, other, true);
            if (other_ends) next.emplace_back(one, 0, true);
            for (const State& state : next)
                if (known.insert(state).second) open.push_back(state);
        }
    }
    return true;
}

std::vector<char> useful_states(const Derivatives::Automaton& automaton) {
    std::vector<char> useful = automaton.accepting;
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t i = 0; i < useful.size(); ++i)
            for (const std::size_t to : automaton.next[i])
                if (!useful[i] && useful[to]) {
                    useful[i] = 1;
                    changed = true;
                }
    }
    return useful;
}

}  // namespace

void check_code(const Obligation& task) {
    check_regular(task, task.language());
    const bool prefix = task.statement.kind == Statement::Kind::prefix_code;
    if (!prefix)
        if (const auto words = task.values(task.language())) {
            if (!is_finite_code(*words, task.budget))
                task.refuse("a word is a product of words of the language in two ways");
            return;
        }
    Derivatives derivatives(task.alphabet(), task.budget);
    const auto automaton = derivatives.automaton(derivatives.term(task.language()));
    if (!prefix) {
        if (!is_regular_code(automaton, task.budget))
            task.refuse("a word is a product of words of the language in two ways");
        return;
    }
    if (automaton.accepting[0]) task.refuse("the empty word is in the language");
    const std::vector<char> useful = useful_states(automaton);
    for (std::size_t state = 0; state < useful.size(); ++state)
        for (const std::size_t to : automaton.next[state])
            if (automaton.accepting[state] && useful[to])
                task.refuse("a word of the language begins with another");
}

void check_factorisations(const Obligation& task) {
    const Word word = task.word("word");
    const auto [left, right] = task.proof.at("ends").pair();
    const auto read = [&](const Field& field) {
        std::vector<std::uint64_t> ends;
        std::uint64_t from = 0;
        for (const Field& each : field.list()) {
            const std::uint64_t to = each.number();
            if (to < from || to > word.size()) each.refuse("a factor ends before it begins");
            const auto begin = word.begin();
            if (!task.contains(task.language(), Word(begin + static_cast<std::ptrdiff_t>(from),
                                                     begin + static_cast<std::ptrdiff_t>(to))))
                each.refuse("the factor is not in the language");
            ends.push_back(to);
            from = to;
        }
        if (from != word.size()) field.refuse("the last factor does not end with the word");
        return ends;
    };
    if (read(left) == read(right)) task.refuse("the two factorisations are the same");
}

void check_beginning(const Obligation& task) {
    const Word word = task.word("word"), beginning = task.word("beginning");
    if (beginning.size() >= word.size() ||
        !std::equal(beginning.begin(), beginning.end(), word.begin()))
        task.proof.at("beginning").refuse("the word does not begin so");
    for (const auto& [each, field] : {std::pair(word, "word"), std::pair(beginning, "beginning")})
        if (!task.contains(task.language(), each))
            task.proof.at(field).refuse("the word is not in the language");
}

void check_palindrome(const Obligation& task) {
    const Word& word = task.statement.word;
    if (std::equal(word.begin(), word.end(), word.rbegin()) != task.holds)
        task.refuse(task.holds ? "the word is another one backwards"
                               : "the word is the same backwards");
}

}  // namespace algae::verify
