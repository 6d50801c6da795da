// What `words` says of random morphisms and of their words, compared with windows of 40 letters.
//
// ALGAE_MORPHISMS=10000 takes so many systems, ALGAE_SEED=1 other ones, and ALGAE_TABLE=FILE writes what was compared: tools/random-words does so.

#include <doctest/doctest.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "automatic/automatic.hpp"
#include "oracle/finite_words.hpp"
#include "oracle/infinite_words.hpp"
#include "report/report.hpp"
#include "system/system.hpp"

using namespace algae;

namespace {

constexpr std::size_t longest = 40;

struct System {
    oracle::Rules rules;
    std::string axiom;

    std::string text() const {
        std::string all = "axiom " + axiom;
        for (const auto& [letter, image] : rules)
            all += std::string("; ") + letter + " -> " + (image.empty() ? "ε" : image);
        return all;
    }
};

/// Up to four letters; a third of the systems erases some, two thirds prolong their first letter, some have words that do not return.
System any_system(std::mt19937& generator) {
    const auto below = [&](std::size_t bound) { return generator() % bound; };
    const std::size_t letters = 2 + below(3);
    const bool erases = below(3) == 0;
    System found;
    for (std::size_t a = 0; a < letters; ++a) {
        std::string image(erases && below(3) == 0 ? 0 : 1 + below(4), 'a');
        for (char& letter : image) letter = static_cast<char>('a' + below(letters));
        found.rules[static_cast<char>('a' + a)] = image;
    }
    if (below(3) > 0) found.rules['a'] = "a" + (found.rules['a'].empty() ? "b" : found.rules['a']);
    found.axiom = "a";
    if (below(6) == 0)
        for (char& letter : found.axiom = std::string(1 + below(3), 'a'))
            letter = static_cast<char>('a' + below(letters));
    return found;
}

D0L system_of(const System& one) {
    std::vector<std::pair<char, std::string>> rules(one.rules.begin(), one.rules.end());
    return d0l(one.axiom, rules);
}

/// What was compared of one quantity.
struct Count {
    std::size_t systems = 0, values = 0, open = 0;  // open: systems of which algae does not say it
};

class WordComparison {
public:
    void compare(const System& one) {
        system_ = &one;
        const D0L system = system_of(one);
        const auto windows = oracle::factors_of(one.rules, one.axiom, longest + 2);
        const FactorValues report = factor_values(system, {}, longest, Budget());
        const std::vector<std::set<std::string>> factors(windows.begin(), windows.end() - 2);
        values("factor complexity", report.factors,
               [&](std::size_t n) { return factors[n].size(); });
        values("palindromic complexity", report.palindromes,
               [&](std::size_t n) { return oracle::palindromes_in(factors[n]); });
        values("Abelian complexity", report.abelian,
               [&](std::size_t n) { return oracle::abelian_of(factors[n]); });
        compare_imbalance(report, factors);
        compare_reversal(report, factors);
        compare_morphism(report, system, windows);
        compare_frequencies(report);
        compare_for_all(report, factors);
        compare_word(one, factors);
        if (!report.infinite_word) return;
        ++infinite;
        compare_bispecial(report, windows);
        if (report.for_all) compare_families(report, windows);
        compare_recurrence(report, factors);
        compare_proved(system, factors);
    }

    std::string table() const {
        std::ostringstream text;
        text << "| quantity | systems | values compared | not answered |\n|---|---|---|---|\n";
        for (const auto& [name, count] : counts)
            text << "| " << name << " | " << count.systems << " | " << count.values << " | "
                 << count.open << " |\n";
        return text.str();
    }

    std::map<std::string, Count> counts;
    std::size_t infinite = 0, erasing = 0, primitive = 0;

private:
    template <class Found, class Known>
    void equal(const std::string& name, const Found& found, const Known& known,
               const std::string& what) {
        ++counts[name].values;
        REQUIRE_MESSAGE(found == known, system_->text(), ": ", name, " ", what);
    }

    template <class Known>
    void values(const std::string& name, const std::vector<std::uint64_t>& found, Known known) {
        ++counts[name].systems;
        REQUIRE(found.size() == longest + 1);
        for (std::size_t n = 0; n <= longest; ++n)
            equal(name, found[n], known(n), "at " + std::to_string(n));
    }

    static std::string spelled(const FactorValues& report, const Word& word) {
        return word.empty() ? "" : spell(report.alphabet, word);
    }

    void compare_imbalance(const FactorValues& report,
                           const std::vector<std::set<std::string>>& factors) {
        ++counts["imbalance"].systems;
        std::map<char, std::size_t> apart;
        for (std::size_t n = 0; n <= longest; ++n) {
            std::size_t most = 0;
            for (const auto& [letter, difference] : oracle::apart_of(factors[n])) {
                most = std::max(most, difference);
                apart[letter] = std::max(apart[letter], difference);
            }
            equal("imbalance", report.imbalance[n], most, "at " + std::to_string(n));
        }
        for (Symbol letter = 0; letter < report.alphabet.size(); ++letter)
            equal("imbalance", report.apart[letter], apart[report.alphabet.name(letter).front()],
                  "of " + report.alphabet.name(letter));
    }

    void compare_reversal(const FactorValues& report,
                          const std::vector<std::set<std::string>>& factors) {
        ++counts["closed under reversal"].systems;
        std::size_t n = 0;
        while (n <= longest && oracle::are_reversed(factors[n])) ++n;
        equal("closed under reversal", report.not_reversed.has_value(), n <= longest, "");
        if (!report.not_reversed) return;
        const std::string word = spelled(report, *report.not_reversed);
        equal("closed under reversal", word.size(), n, word);
        equal("closed under reversal", factors[n].contains(word), true, word);
        equal("closed under reversal", factors[n].contains(std::string(word.rbegin(), word.rend())),
              false, word);
    }

    void compare_morphism(const FactorValues& report, const D0L& system,
                          const std::vector<std::set<std::string>>& windows) {
        const auto power = oracle::primitive_power(system_->rules, system_->axiom);
        ++counts["primitive"].systems;
        equal("primitive", report.primitivity.exponent.has_value(), power.has_value(), "");
        if (power) equal("primitive", *report.primitivity.exponent, *power, "power");
        primitive += power.has_value();
        erasing += std::ranges::any_of(
            system.letters, [&](Symbol letter) { return system.successor(letter).empty(); });
        compare_letters(report);
        if (!report.circular) {
            ++counts["circular"].open;
            return;
        }
        // Where the answer is no, factors are cut in two ways however long they are; where it is yes, mostly short ones show it.
        const bool is_one_way = oracle::is_cut_in_one_way(system_->rules, windows, longest);
        if (!*report.circular) {
            ++counts["circular"].systems;
            equal("circular", is_one_way, false, "");
        } else if (is_one_way) {
            ++counts["circular"].systems;
            ++counts["circular"].values;
        } else {
            ++counts["circular"].open;
        }
    }

    /// Of each letter the lengths of its words for so long that one that grows has more than any other could have.
    void compare_letters(const FactorValues& report) {
        ++counts["letters"].systems;
        const std::size_t d = system_->rules.size();
        for (const auto& [kind, all] :
             {std::pair("growing", &report.growing), std::pair("bounded", &report.bounded),
              std::pair("mortal", &report.mortal)})
            for (const Symbol letter : *all) {
                const std::string name = report.morphism_alphabet.name(letter);
                std::map<char, std::uint64_t> count{{name.front(), 1}};
                std::uint64_t length = 1, most = 0;
                // What does not grow goes round, and has its greatest length in the first half of the steps.
                constexpr std::uint64_t many = 1'000'000;
                for (std::size_t step = 0; step < 40 * d && length > 0 && length < many; ++step) {
                    std::map<char, std::uint64_t> next;
                    length = 0;
                    for (const auto& [a, times] : count)
                        for (const char b : system_->rules.at(a)) {
                            next[b] += times;
                            length += times;
                        }
                    if (step <= 20 * d) most = std::max(most, length);
                    count = next;
                }
                const std::string known = length == 0                       ? "mortal"
                                          : length >= many || length > most ? "growing"
                                                                            : "bounded";
                equal("letters", std::string(kind), known, name);
            }
    }

    void compare_frequencies(const FactorValues& report) {
        const auto known = oracle::shares_of(system_->rules, system_->axiom);
        Count& count = counts["frequencies"];
        bool answers = false;
        for (Symbol letter = 0; letter < report.alphabet.size(); ++letter) {
            const char name = report.alphabet.name(letter).front();
            if (!report.frequencies[letter]) continue;
            answers = true;
            ++count.values;
            REQUIRE_MESSAGE(known, system_->text(), ": frequencies that have no limit");
            const auto share = known->find(name);
            const double found = std::stod(report.frequencies[letter]->decimal(12));
            REQUIRE_MESSAGE(std::abs(found - (share == known->end() ? 0 : share->second)) < 1e-6,
                            system_->text(), ": frequency of ", name, ", ", found);
        }
        ++(answers || !known ? count.systems : count.open);
    }

    void compare_for_all(const FactorValues& report,
                         const std::vector<std::set<std::string>>& factors) {
        Count& count = counts["factor complexity for all n"];
        if (!report.for_all) {
            ++count.open;
            return;
        }
        ++count.systems;
        for (std::size_t n = 0; n <= longest; ++n)
            equal("factor complexity for all n", report.for_all->value(Integer(n)),
                  Integer(factors[n].size()), "at " + std::to_string(n));
    }

    /// What is said of all factors holds of those in windows; what is denied mostly shows in them.
    void compare_families(const FactorValues& report,
                          const std::vector<std::set<std::string>>& windows) {
        const oracle::Families known = oracle::families_of(windows, longest);
        const auto one = [&](const std::string& name, bool found, bool seen) {
            if (found) {
                ++counts[name].systems;
                equal(name, seen, true, "");
            } else {
                ++(seen ? counts[name].open : counts[name].systems);
                ++counts[name].values;
            }
        };
        one("dendric", report.for_all->dendric, known.dendric);
        one("episturmian", report.for_all->episturmian, known.episturmian);
        one("of Arnoux and Rauzy", report.for_all->arnoux_rauzy, known.arnoux_rauzy);
    }

    void compare_bispecial(const FactorValues& report,
                           const std::vector<std::set<std::string>>& windows) {
        ++counts["bispecial factors"].systems;
        const auto known = oracle::bispecial_of(windows, longest);
        equal("bispecial factors", report.bispecial.size(), known.size(), "in all");
        for (const auto& [word, multiplicity] : report.bispecial) {
            const auto at = known.find(spelled(report, word));
            equal("bispecial factors", at != known.end() && at->second == multiplicity, true,
                  spelled(report, word));
        }
    }

    void compare_recurrence(const FactorValues& report,
                            const std::vector<std::set<std::string>>& factors) {
        const auto& found = report.recurrence.values;
        std::size_t compared = 0, missing = 0;
        for (std::size_t n = 0; n <= longest; ++n) {
            const auto known = oracle::recurrence_of(factors, n);
            if (n >= found.size()) {
                missing += known.has_value();
                continue;
            }
            ++compared;
            if (known)
                equal("recurrence function", found[n], *known, "at " + std::to_string(n));
            else
                equal("recurrence function", found[n] > longest, true, "at " + std::to_string(n));
        }
        ++(compared > 0 && missing == 0 ? counts["recurrence function"].systems
                                        : counts["recurrence function"].open);
        Count& count = counts["return words"];
        // A word of 40 letters to the next b is in no window with that b.
        if (found.size() < 2 || found[1] >= longest) {
            ++count.open;
            return;
        }
        ++count.systems;
        for (const auto& [letter, words] : report.recurrence.return_words) {
            std::set<std::string> all;
            std::size_t length = 0;
            for (const auto& word : words) {
                std::string text;
                for (const std::string& one : word) text += one;
                equal("return words", text.size() >= length, true, "in order");
                length = text.size();
                equal("return words", all.insert(text).second, true, "once");
            }
            equal("return words", all, oracle::returns_of(factors, letter.front()), "to " + letter);
        }
        equal("return words", report.recurrence.return_words.size(), factors[1].size(), "letters");
    }

    /// What automata and derived words decide within a little time.
    void compare_proved(const D0L& system, const std::vector<std::set<std::string>>& factors) {
        const auto budget = [](int milliseconds) {
            Budget found;
            found.memory = std::uint64_t{16} << 20;
            found.deadline =
                std::chrono::steady_clock::now() + std::chrono::milliseconds(milliseconds);
            return found;
        };
        const auto decided = [&](const std::string& name, auto decide) {
            try {
                decide();
                ++counts[name].systems;
                return true;
            } catch (const BoundReached&) {
            } catch (const Error&) {
            }
            return false;
        };
        const auto word = [&] {
            return automatic_word(system,
                                  [&](Symbol letter) { return system.alphabet->name(letter); });
        };
        if (!decided("closed under reversal for all n", [&] {
                const bool is_closed = has_property(word(), "closed under reversal", budget(60));
                const bool is_so_far = std::ranges::all_of(factors, oracle::are_reversed);
                equal("closed under reversal for all n", !is_closed || is_so_far, true, "");
            }))
            ++counts["closed under reversal for all n"].open;
        const std::string exponent = "critical exponent";
        if (!decided(exponent,
                     [&] { compare_exponent(critical_exponent(system, budget(300)), factors); }) &&
            !decided(exponent,
                     [&] { compare_exponent(critical_exponent(word(), budget(60)), factors); }))
            ++counts[exponent].open;
    }

    void compare_exponent(const CriticalExponent& found,
                          const std::vector<std::set<std::string>>& factors) {
        const auto [length, period] = oracle::greatest_exponent(factors);
        const std::string name = "critical exponent";
        if (found.infinite) {
            equal(name, length >= 2 * period, true, "infinite");
            return;
        }
        const double least = static_cast<double>(length) / static_cast<double>(period),
                     value = std::stod(found.value->decimal(12));
        equal(name, value > least - 1e-9, true, found.value->exact());
        if (!found.attained) return;
        REQUIRE(found.factor);
        const auto [n, p] = *found.factor;
        equal(name, std::abs(Rational(n, p).to_double() - value) < 1e-9, true, "attained");
        if (n <= Integer(longest))
            equal(name, Rational(n, p) == Rational(length, period), true, "");
    }

    void compare_word(const System& one, const std::vector<std::set<std::string>>& factors) {
        std::size_t n = std::min<std::size_t>(13, factors.size() - 1);
        while (factors[n].empty()) --n;
        const std::string text = *factors[n].begin();
        std::vector<std::string> names;
        Word word;
        for (const auto& [letter, image] : one.rules) names.emplace_back(1, letter);
        for (const char letter : text) word.push_back(static_cast<Symbol>(letter - 'a'));
        const WordReport report = word_report(word, names, Budget());
        const auto of = [&](const Word& part) {
            std::string found;
            for (const Symbol letter : part) found += static_cast<char>('a' + letter);
            return found;
        };
        const std::string name = "one word";
        ++counts[name].systems;
        equal(name, report.periods, oracle::periods_of(text), text);
        equal(name, report.borders, oracle::borders_of(text), text);
        equal(name, of(report.root), oracle::root_of(text), text);
        if (!text.empty())
            equal(name, of(report.conjugate), *oracle::conjugates_of(text).begin(), text);
        const auto lyndon = oracle::lyndon_words_of(text);
        equal(name, report.lyndon.size(), text.empty() ? 0 : lyndon.size(), text);
        equal(name, report.palindromes.count, oracle::palindromes_of(text).size(), text);
        equal(name, report.palindromes.fewest.size(), oracle::palindromic_length_of(text), text);
        equal(name, report.repetitions.runs.size(), oracle::runs_of(text).size(), text);
        equal(name, report.repetitions.distinct_squares, oracle::squares_of(text).size(), text);
        const auto counted = oracle::factor_counts_of(text);
        equal(name, report.factors, std::vector<std::uint64_t>(counted.begin(), counted.end()),
              text);
        std::vector<std::pair<std::size_t, std::size_t>> abelian;
        for (const AbelianPeriod& period : *report.abelian)
            abelian.emplace_back(period.head, period.period);
        equal(name, abelian, oracle::abelian_periods_of(text), text);
    }

    const System* system_ = nullptr;
};

}  // namespace

TEST_CASE("words: every quantity of random morphisms is that of all windows") {
    const char* given = std::getenv("ALGAE_MORPHISMS");
    const std::size_t wanted = given ? std::strtoull(given, nullptr, 10) : 150;
    const char* seed = std::getenv("ALGAE_SEED");
    std::mt19937 generator(
        seed ? static_cast<std::mt19937::result_type>(std::strtoul(seed, nullptr, 10)) : 2022);
    WordComparison comparison;
    for (std::size_t i = 0; i < wanted; ++i) comparison.compare(any_system(generator));
    std::ostringstream text;
    text << wanted << " systems: " << comparison.primitive << " primitive, " << comparison.erasing
         << " erasing, " << comparison.infinite << " with an infinite word\n\n"
         << comparison.table();
    MESSAGE(text.str());
    if (const char* file = std::getenv("ALGAE_TABLE")) std::ofstream(file) << text.str();
    CHECK(comparison.erasing * 10 >= wanted);
    CHECK(comparison.primitive * 10 >= wanted);
    CHECK(comparison.infinite * 3 >= wanted);
    CHECK(comparison.counts.size() == 19);
    for (const auto& one : comparison.counts) {
        INFO(one.first);
        CHECK(one.second.systems * 20 >= wanted);
        CHECK(one.second.values >= one.second.systems);
    }
}
