#pragma once
// Questions about random small systems of 24 families, what algae decides of them, and what `oracle::SmallLanguage` knows. The kind of a
// question, the systems and whatever else is in it are drawn before anything is worked out, so nothing is asked because its answer is
// known. The same numbers give the same cases on every machine.

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "language/language.hpp"
#include "notation/notation.hpp"
#include "oracle/finite_systems.hpp"
#include "oracle/small_language.hpp"
#include "verify/verify.hpp"

namespace algae::attack {

using oracle::followed_by;
using oracle::Relation;
using oracle::Relations;
using oracle::SmallExpression;
using oracle::SmallLanguage;
using oracle::SmallSystem;
using oracle::transposed;
using Known = std::optional<bool>;
using Words = std::set<std::string>;

constexpr std::size_t longest_listed = 4;

inline const std::vector<std::string> families{"0L",   "P0L",   "D0L",   "PD0L",   "T0L",  "PT0L",
                                               "DT0L", "PDT0L", "E0L",   "EP0L",   "ED0L", "EPD0L",
                                               "ET0L", "EPT0L", "EDT0L", "EPDT0L", "1L",   "P1L",
                                               "D1L",  "PD1L",  "IL",    "PIL",    "DIL",  "PDIL"};

class Chance {
public:
    explicit Chance(std::uint64_t seed) : generator_(seed) {}
    int number(int least, int most) {
        const auto count = static_cast<std::uint64_t>(most - least + 1);
        return least + static_cast<int>((generator_() >> 11) % count);
    }
    bool is_even() { return number(0, 1) == 0; }
    template <class Items>
    const auto& one_of(const Items& items) {
        return *std::next(items.begin(), number(0, static_cast<int>(items.size()) - 1));
    }
    std::string word(const std::string& letters, int least, int most) {
        std::string made;
        for (int left = number(least, most); left > 0; --left) made += one_of(letters);
        return made;
    }

private:
    std::mt19937_64 generator_;
};

inline std::string letters_of(const SmallSystem& system) { return system.is('E') ? "abS" : "ab"; }

inline std::vector<std::string> any_successors(const SmallSystem& system, Chance& chance) {
    Words words;
    for (int count = system.is('D') ? 1 : chance.number(1, 2); count > 0; --count)
        words.insert(chance.word(letters_of(system), system.is('P') ? 1 : 0, 2));
    return {words.begin(), words.end()};
}

inline SmallSystem any_system(const std::string& family, Chance& chance) {
    SmallSystem made;
    made.family = family;
    made.axiom = chance.word(letters_of(made), 1, 3);
    for (int table = made.is('T') ? 2 : 1; table > 0; --table) {
        auto& rules = made.tables.emplace_back();
        for (const char letter : letters_of(made)) rules[letter] = any_successors(made, chance);
    }
    if (!made.has_context()) return made;
    const bool two_sided = made.is('I'), only_left = chance.is_even();
    const int most = two_sided ? 2 : 1;
    for (int left = chance.number(1, 3); left > 0; --left) {
        SmallSystem::InContext rule;
        do {
            rule.left = two_sided || only_left ? chance.word("ab", 0, most) : "";
            rule.right = two_sided || !only_left ? chance.word("ab", 0, most) : "";
        } while (rule.left.empty() && rule.right.empty());
        rule.letter = chance.is_even() ? 'a' : 'b';
        rule.successors = any_successors(made, chance);
        const bool is_new = std::none_of(
            made.in_context.begin(), made.in_context.end(), [&](const SmallSystem::InContext& one) {
                return one.left == rule.left && one.letter == rule.letter &&
                       one.right == rule.right;
            });
        if (is_new) made.in_context.push_back(std::move(rule));
    }
    return made;
}

/// Any other one, or this one with another rule, with one more successor, or with a word that it derives in one step as its axiom.
inline SmallSystem another_system(const SmallSystem& system, Chance& chance) {
    SmallSystem made = system;
    const int kind = chance.number(0, 3);
    auto& rules = made.tables.at(
        static_cast<std::size_t>(chance.number(0, static_cast<int>(made.tables.size()) - 1)));
    const char letter = chance.one_of(letters_of(made));
    if (kind == 0) return any_system(chance.one_of(families), chance);
    if (kind == 1) {
        rules[letter] = any_successors(made, chance);
    } else if (kind == 2 && !made.is('D')) {
        Words words(rules[letter].begin(), rules[letter].end());
        words.insert(chance.word(letters_of(made), made.is('P') ? 1 : 0, 2));
        rules[letter].assign(words.begin(), words.end());
    } else {
        std::string next;
        for (std::size_t i = 0; i < made.axiom.size(); ++i)
            next += made.successors(0, system.axiom, i).front();
        if (!next.empty()) made.axiom = next;
    }
    return made;
}

/// With at most seven letters, as its automaton then has at most eight states.
inline SmallExpression any_expression(Chance& chance) {
    const std::function<std::string(int)> part = [&](int depth) -> std::string {
        const int kind = depth == 0 ? 0 : chance.number(0, 5);
        if (kind <= 1) return chance.is_even() ? "a" : "b";
        if (kind == 2) return "(" + part(depth - 1) + "|" + part(depth - 1) + ")";
        if (kind == 3) return "(" + part(depth - 1) + ")" + (chance.is_even() ? "*" : "+");
        return part(depth - 1) + part(depth - 1);
    };
    for (;;) {
        const std::string text = part(4);
        if (std::count_if(text.begin(), text.end(), [](char c) { return c == 'a' || c == 'b'; }) <=
            7)
            return oracle::small_expression(text);
    }
}

inline std::string shown(const std::string& word) { return word.empty() ? "ε" : word; }

/// All words over a and b of at most so many letters.
inline std::vector<std::string> all_words(std::size_t longest) {
    std::vector<std::string> all{""};
    for (std::size_t i = 0; i < all.size(); ++i)
        for (const char letter : {'a', 'b'})
            if (all[i].size() < longest) all.push_back(all[i] + letter);
    return all;
}

// --- What is known ---

/// Of a property of relations: whether all words of the language have it.
inline Known for_all(const Relations& relations, const std::function<bool(const Relation&)>& has) {
    if (!std::all_of(relations.some.begin(), relations.some.end(), has)) return false;
    if (std::all_of(relations.all.begin(), relations.all.end(), has)) return true;
    return std::nullopt;
}

inline Known opposite(Known known) { return known ? Known(!*known) : known; }

/// What letters do to the states of one or two automata.
inline std::map<char, Relation> steps(const SmallExpression& first, const SmallExpression& second) {
    std::map<char, Relation> made;
    for (const char letter : {'a', 'b'})
        made[letter] = {first.steps.at(letter), second.steps.at(letter)};
    return made;
}

/// Whether each word that one has is missing in the other: that it is not a part.
inline bool has_more(const SmallLanguage& here, const SmallLanguage& there) {
    return std::any_of(here.words().begin(), here.words().end(),
                       [&](const std::string& word) { return there.has(word) == false; });
}

/// Whether the rules of the one are among those of the other, which has the axiom of the first one, so all that it derives.
inline bool is_part(const SmallLanguage& inner, const SmallLanguage& outer) {
    const SmallSystem &one = inner.system(), &other = outer.system();
    if (one.in_context != other.in_context) return false;
    if (one.is('E') != other.is('E')) return false;
    for (const auto& table : one.tables)
        if (std::none_of(other.tables.begin(), other.tables.end(), [&](const auto& there) {
                return std::all_of(table.begin(), table.end(), [&](const auto& rule) {
                    const auto& words = there.at(rule.first);
                    return std::all_of(
                        rule.second.begin(), rule.second.end(), [&](const std::string& word) {
                            return std::find(words.begin(), words.end(), word) != words.end();
                        });
                });
            }))
            return false;
    return one.axiom == other.axiom || (!one.is('E') && outer.has(one.axiom) == true);
}

inline Known is_included(const SmallLanguage& inner, const SmallLanguage& outer) {
    if (has_more(inner, outer)) return false;
    if (inner.finite() == false && outer.finite() == true) return false;
    if (is_part(inner, outer)) return true;
    if (const auto words = inner.all_words())
        if (std::all_of(words->begin(), words->end(),
                        [&](const std::string& word) { return outer.has(word) == true; }))
            return true;
    return std::nullopt;
}

/// Two D0L sequences over two letters are the same if their first four words are (Karhumäki 1981).
inline Known are_equal(const SmallLanguage& left, const SmallLanguage& right) {
    const Known one = is_included(left, right), other = is_included(right, left);
    if (one == false || other == false) return false;
    if (one == true && other == true) return true;
    const auto is_d0l = [](const SmallSystem& system) {
        return system.family == "D0L" || system.family == "PD0L";
    };
    if (is_d0l(left.system()) && is_d0l(right.system()) && left.sequence(4) == right.sequence(4))
        return true;
    return std::nullopt;
}

/// Whether a D0L system has this finite language: a successor of a letter is a factor of one of its words, so all are tried.
inline bool is_d0l(const Words& language, bool propagating) {
    Words factors;
    for (const std::string& word : language)
        for (std::size_t i = 0; i <= word.size(); ++i)
            for (std::size_t n = propagating ? 1 : 0; i + n <= word.size(); ++n)
                factors.insert(word.substr(i, n));
    if (factors.empty()) return false;  // the empty word alone is no axiom
    const auto generates = [&](std::string word, const std::string& a, const std::string& b) {
        Words made;
        while (language.contains(word) && made.insert(word).second) {
            std::string next;
            for (const char letter : word) next += letter == 'a' ? a : b;
            word = std::move(next);
        }
        return made.contains(word) && made == language;
    };
    for (const std::string& axiom : language) {
        if (axiom.empty()) continue;
        for (const std::string& a : factors)
            for (const std::string& b : factors)
                if (generates(axiom, a, b)) return true;
    }
    return false;
}

/// Whether the rules of the system have the form that the name of a family says.
inline bool has_form(const SmallSystem& system, const std::string& family) {
    const auto is = [&](char letter) { return family.find(letter) != std::string::npos; };
    const auto one_each = [&] {
        for (const auto& table : system.tables)
            for (const auto& [letter, words] : table)
                if (words.size() > 1) return false;
        return std::all_of(system.in_context.begin(), system.in_context.end(),
                           [](const auto& rule) { return rule.successors.size() == 1; });
    };
    if (system.is('E') && !is('E')) return false;
    if (system.is('T') && !is('T')) return false;
    if (is('P') && system.erases()) return false;
    if (is('D') && !one_each()) return false;
    if (!system.has_context()) return true;
    if (is('0')) return false;
    if (is('I')) return true;
    const auto looks = [&](const auto& side) {
        return std::any_of(system.in_context.begin(), system.in_context.end(), side);
    };
    if (looks([](const auto& rule) { return rule.left.size() > 1 || rule.right.size() > 1; }))
        return false;
    return !looks([](const auto& rule) { return !rule.left.empty(); }) ||
           !looks([](const auto& rule) { return !rule.right.empty(); });
}

/// Whether one of all systems without terminals and context has this language of words of at most two letters.
inline bool is_written_down(const Words& language, bool propagating, bool deterministic,
                            bool tables) {
    static const auto all = [] {
        std::map<std::array<bool, 3>, std::set<std::uint64_t>> found;
        for (const bool p : {false, true})
            for (const bool d : {false, true}) {
                const oracle::FiniteSystems systems(2, 2, p, d);
                found[{p, d, false}] = systems.without_tables();
                found[{p, d, true}] = systems.with_tables();
            }
        return found;
    }();
    const std::vector<std::string> words = oracle::FiniteSystems::words(2, 2);
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < words.size(); ++i)
        if (language.contains(words[i])) bits |= std::uint64_t{1} << i;
    return all.at({propagating, deterministic, tables}).contains(bits);
}

inline Known is_of_family(const SmallLanguage& language, const std::string& family) {
    const auto words = language.all_words();
    if (family == "regular" || family == "context-free")
        return language.finite() == true ? Known(true) : std::nullopt;
    const auto is = [&](char letter) { return family.find(letter) != std::string::npos; };
    if (has_form(language.system(), family)) return true;
    if (words && words->empty()) return is('E');
    if (is('P') && language.has("") == true) return false;  // the axiom is not empty
    if (!words) return std::nullopt;
    if (is('E')) {  // the word of S, or by a table each of the words of S
        const bool is_any = is('T') || !is('D') || words->size() == 1;
        if (is_any && !(is('P') && words->contains(""))) return true;
        return std::nullopt;
    }
    if (!is('0')) return std::nullopt;
    if (std::all_of(words->begin(), words->end(),
                    [](const auto& word) { return word.size() <= 2; }))
        return is_written_down(*words, is('P'), is('D'), is('T'));
    if (is('D') && !is('T') && words->size() <= 8) return is_d0l(*words, is('P'));
    return std::nullopt;
}

// --- Questions ---

struct Question {
    std::string kind;
    std::string statement;  // or the language of which words are listed
    bool counts = false, lists = false;
    std::function<Known()> known;
};

inline const std::vector<std::string> kinds{
    "word",           "empty",          "finite",    "equal",  "included", "family",
    "within regular", "equals regular", "operation", "factor", "list",     "counts"};

/// A language that an operation makes: what words it has, and whether all of them have a property of relations.
struct Made {
    std::string name, text;
    std::function<Known(const std::string&)> has;
    std::function<Known(const std::map<char, Relation>&,
                        const std::function<bool(const Relation&)>&)>
        all;
};

inline Made any_operation(const SmallLanguage& left, const SmallLanguage& right, Chance& chance) {
    const auto either = [](Known one, Known other) -> Known {
        if (one == true || other == true) return true;
        if (one == false && other == false) return false;
        return std::nullopt;
    };
    const auto both = [either](Known one, Known other) {
        return opposite(either(opposite(one), opposite(other)));
    };
    switch (chance.number(0, 5)) {
        case 0:
            return {
                "union", "L(G) | L(H)",
                [&, either](const auto& word) { return either(left.has(word), right.has(word)); },
                [&, both](const auto& letters, const auto& has) {
                    return both(for_all(left.relations(letters), has),
                                for_all(right.relations(letters), has));
                }};
        case 1: {
            const SmallExpression with = any_expression(chance);
            return {"meet with regular", "L(G) & /" + with.text + "/",
                    [&, both, with](const auto& word) {
                        return both(left.has(word), with.accepts(word));
                    },
                    [&, with](auto letters, const auto& has) {
                        for (auto& [letter, relation] : letters)
                            relation[1] = with.steps.at(letter);
                        return for_all(left.relations(letters), [&](const Relation& relation) {
                            return !with.accepts(relation[1]) || has(relation);
                        });
                    }};
        }
        case 2:
            return {
                "reversal", "L(G)^R",
                [&](const auto& word) { return left.has(std::string(word.rbegin(), word.rend())); },
                [&](auto letters, const auto& has) {
                    for (auto& [letter, relation] : letters) relation = transposed(relation);
                    return for_all(left.relations(letters), [&](const Relation& relation) {
                        return has(transposed(relation));
                    });
                }};
        case 3: {
            const std::map<char, std::string> images{{'a', chance.word("ab", 0, 2)},
                                                     {'b', chance.word("ab", 0, 2)}};
            // A word is an image if, by the automaton that reads its letters one after the other, some word leads to its end.
            const auto all = [&, images](const auto& letters, const auto& has) {
                std::map<char, Relation> of_images;
                for (const auto& [letter, image] : images) {
                    Relation relation = oracle::identity();
                    for (const char each : image)
                        relation = followed_by(relation, letters.at(each));
                    of_images[letter] = relation;
                }
                return for_all(left.relations(of_images), has);
            };
            return {
                "morphism",
                "{ a -> " + shown(images.at('a')) + "; b -> " + shown(images.at('b')) + " }(L(G))",
                [all](const std::string& word) {
                    std::map<char, Relation> letters{{'a', {0, 0}}, {'b', {0, 0}}};
                    for (std::size_t i = 0; i < word.size(); ++i)
                        letters[word[i]][0] |= std::uint64_t{1} << (9 * i + 1);
                    const std::size_t end = word.size();
                    return opposite(all(letters, [end](const Relation& relation) {
                        return (relation[0] >> end & 1) == 0;
                    }));
                },
                all};
        }
        case 4:
            return {"concatenation", "L(G) L(H)",
                    [&, either, both](const auto& word) {
                        Known known = false;
                        for (std::size_t cut = 0; cut <= word.size(); ++cut)
                            known = either(known, both(left.has(word.substr(0, cut)),
                                                       right.has(word.substr(cut))));
                        return known;
                    },
                    [&](const auto& letters, const auto& has) {
                        const Relations one = left.relations(letters),
                                        other = right.relations(letters);
                        const auto products = [](const auto& first, const auto& second) {
                            std::set<Relation> made;
                            for (const Relation& x : first)
                                for (const Relation& y : second) made.insert(followed_by(x, y));
                            return made;
                        };
                        if (one.all.size() * other.all.size() > 20'000) return Known();
                        return for_all(
                            {products(one.some, other.some), products(one.all, other.all)}, has);
                    }};
        default:
            return {"complement", "~L(G)",
                    [&](const auto& word) { return opposite(left.has(word)); },
                    [&](const auto& letters, const auto& has) -> Known {
                        for (const std::string& word : all_words(5)) {
                            Relation relation = oracle::identity();
                            for (const char letter : word)
                                relation = followed_by(relation, letters.at(letter));
                            if (left.has(word) == false && !has(relation)) return false;
                        }
                        return std::nullopt;
                    }};
    }
}

/// A question of this kind. The languages outlive it.
inline Question any_question(const std::string& kind, const SmallLanguage& left,
                             const SmallLanguage& right, Chance& chance) {
    Question made;
    made.kind = kind;
    const SmallExpression one = any_expression(chance), other = any_expression(chance);
    const std::string word = chance.word("ab", 0, 5);
    const auto accepts = [one](const Relation& relation) { return one.accepts(relation[0]); };
    const auto refuses = [one](const Relation& relation) { return !one.accepts(relation[0]); };
    const auto nothing = [](const Relation&) { return false; };
    if (kind == "word") {
        made.statement = shown(word) + " in L(G)";
        made.known = [&left, word] { return left.has(word); };
    } else if (kind == "empty") {
        const bool meets = chance.is_even();
        made.statement = std::string("L(G)") + (meets ? " & /" + one.text + "/" : "") + " is empty";
        made.known = [=, &left]() -> Known {
            if (meets) return for_all(left.relations(steps(one, one)), refuses);
            return for_all(left.relations(steps(one, one)), nothing);
        };
    } else if (kind == "finite") {
        made.statement = "L(G) is finite";
        made.known = [&left] { return left.finite(); };
    } else if (kind == "equal") {
        made.statement = "L(G) == L(H)";
        made.known = [&] { return are_equal(left, right); };
    } else if (kind == "included") {
        made.statement = "L(G) <= L(H)";
        made.known = [&] { return is_included(left, right); };
    } else if (kind == "family") {
        const int number = chance.number(0, static_cast<int>(families.size()) + 1);
        const std::string family = number == 24   ? "regular"
                                   : number == 25 ? "context-free"
                                                  : families[static_cast<std::size_t>(number)];
        made.statement = "L(G) is " + family;
        made.known = [&left, family] { return is_of_family(left, family); };
    } else if (kind == "within regular") {
        made.statement = "L(G) <= /" + one.text + "/";
        made.known = [=, &left] { return for_all(left.relations(steps(one, one)), accepts); };
    } else if (kind == "equals regular") {
        made.statement = "L(G) == /" + one.text + "/";
        made.known = [=, &left]() -> Known {
            const Known within = for_all(left.relations(steps(one, one)), accepts);
            if (within == false) return false;
            for (const std::string& each : all_words(6))
                if (one.accepts(each) && left.has(each) == false) return false;
            const bool repeats = one.text.find_first_of("*+") != std::string::npos;
            if (repeats && left.finite() == true) return false;
            if (within != true || repeats) return std::nullopt;
            for (const std::string& each : all_words(7))  // of so many letters at most
                if (one.accepts(each) && left.has(each) != true) return std::nullopt;
            return true;
        };
    } else if (kind == "operation") {
        const Made by = any_operation(left, right, chance);
        made.kind = by.name;
        const int asks = chance.number(0, 2);
        if (asks == 0) {
            made.statement = shown(word) + " in " + by.text;
            made.known = [=] { return by.has(word); };
        } else {
            made.statement =
                by.text + (asks == 1 ? " <= /" + one.text + "/" : std::string(" is empty"));
            made.known = [=]() -> Known {
                return by.all(steps(one, one), [&](const Relation& relation) {
                    return asks == 1 && accepts(relation);
                });
            };
        }
    } else if (kind == "factor") {
        const std::string part = chance.word("ab", 1, 2);
        made.statement = part + " in factors(G)";
        made.known = [&left, part] {
            const SmallExpression with = oracle::small_expression("(a|b)*" + part + "(a|b)*");
            return opposite(
                for_all(left.relations(steps(with, with)),
                        [&](const Relation& relation) { return !with.accepts(relation[0]); }));
        };
    } else {
        made.statement = "L(G)";
        (kind == "list" ? made.lists : made.counts) = true;
    }
    return made;
}

// --- What is compared ---

struct Count {
    std::uint64_t asked = 0, decided = 0, known = 0, comparable = 0, agreeing = 0;
    void add(const Count& other) {
        asked += other.asked;
        decided += other.decided;
        known += other.known;
        comparable += other.comparable;
        agreeing += other.agreeing;
    }
};

struct Counts {
    Count all;
    std::map<std::string, Count> by_family, by_kind;
    std::map<std::pair<std::string, std::string>, Count> by_both;
    std::uint64_t verified = 0, checked = 0;  // certificates
    std::uint64_t out_of_time = 0;
    std::vector<std::string> defects;  // answers that are not true, and proofs that verify rejects
    std::vector<std::string> undecided;  // though the answer is known
};

/// What is known of words of at most `longest_listed` letters; nothing if it is not known of all of them.
inline std::optional<Words> short_words(const SmallLanguage& language) {
    Words found;
    for (const std::string& word : all_words(longest_listed)) {
        const Known known = language.has(word);
        if (!known) return std::nullopt;
        if (*known) found.insert(word);
    }
    return found;
}

/// A bound of the processor's time that no other program's work changes.
class ProcessorTime {
public:
    explicit ProcessorTime(double seconds)
        : end_(std::clock() + static_cast<std::clock_t>(seconds * CLOCKS_PER_SEC)) {}
    ProcessorTime(const ProcessorTime&) = delete;
    ProcessorTime& operator=(const ProcessorTime&) = delete;
    Budget budget() const {
        Budget budget;
        budget.at_check = &at_check_;
        return budget;
    }
    bool is_over() const { return is_over_; }

private:
    void check() {
        if (!is_over_ && checks_++ % 16 == 0) is_over_ = std::clock() > end_;
        if (is_over_) throw BoundReached(Bound::time, "the time allowed is over");
    }
    std::clock_t end_;
    std::atomic<std::uint64_t> checks_ = 0;
    std::atomic<bool> is_over_ = false;
    std::function<void()> at_check_ = [this] { check(); };
};

/// One case, with at most `seconds` for each answer. The certificate is verified where the number is a multiple of `every`.
inline void run_case(std::uint64_t seed, std::uint64_t every, Counts& counts) {
    constexpr double seconds = 0.2;
    Chance chance(seed);
    const std::string family = chance.one_of(families), kind = chance.one_of(kinds);
    const SmallSystem first = any_system(family, chance);
    const SmallSystem second = another_system(first, chance);
    const SmallLanguage left(first), right(second);
    const Question asked = any_question(kind, left, right, chance);
    const std::string text = "claim T\nlet G = " + first.text() + "\nlet H = " + second.text() +
                             "\nlet W = /(a|b)*/\nshow " +
                             (asked.known ? asked.statement : "a in L(G)") + "\n";
    const ProcessorTime time(seconds), time_to_verify(5 * seconds);
    const auto report = [&](const std::string& what) {
        return "case " + std::to_string(seed) + " (" + asked.kind + "): " + what + "\n" + text;
    };
    Count one;
    one.asked = 1;
    const Claim claim = read_claim(text, "x", {});
    bool agrees = false;
    if (asked.known) {
        const CheckedClaim found = check(claim, time.budget());
        const Answer& answer = found.statements.at(0).answer;
        const Known known = asked.known();
        one.decided = answer.truth != Truth::undecided;
        one.known = known.has_value();
        agrees = known && answer.truth == (*known ? Truth::proved : Truth::refuted);
        if (one.decided && seed % every == 0) {
            ++counts.verified;
            try {
                const verify::Finding finding =
                    verify::check_certificate(certificate(found).dump(), "x",
                                              time_to_verify.budget())
                        .front();
                counts.checked += finding.outcome == verify::Finding::Outcome::checked;
                if (finding.outcome == verify::Finding::Outcome::wrong)
                    counts.defects.push_back(report("verify: " + finding.reason));
            } catch (const BoundReached&) {  // the time is over, so it is not checked
            }
        }
        if (known && !one.decided)
            counts.undecided.push_back(report(*known ? "is true" : "is false"));
        if (known && one.decided && !agrees)
            counts.defects.push_back(report(*known ? "is true" : "is false"));
    } else {
        const Language language = std::get<HasWord>(claim.statements.at(0).statement.says).language;
        const std::optional<Words> known = short_words(left);
        one.known = known.has_value();
        std::vector<std::size_t> counted(longest_listed + 1);
        if (known)
            for (const std::string& word : *known) ++counted[word.size()];
        try {
            if (asked.lists) {
                const WordList found =
                    list_words(language, *claim.alphabet, {longest_listed, 1'000}, time.budget());
                one.decided = found.whole || found.decided > longest_listed;
                Words listed;
                for (const Word& word : found.words)
                    listed.insert(word.empty() ? "" : spell(*claim.alphabet, word));
                agrees = known && listed == *known;
            } else {
                const WordCounts found =
                    count_words(language, *claim.alphabet, longest_listed, time.budget());
                one.decided = found.whole || found.counts.size() > longest_listed;
                agrees = known.has_value();
                for (std::size_t n = 0; n <= longest_listed; ++n)
                    agrees = agrees && (n < found.counts.size() ? found.counts[n] : Integer(0)) ==
                                           Integer(counted[n]);
            }
        } catch (const BoundReached&) {  // the time is over before the first length
        }
        if (known && !one.decided) counts.undecided.push_back(report("not all lengths"));
        if (known && one.decided && !agrees) counts.defects.push_back(report("other words"));
    }
    counts.out_of_time += time.is_over();
    one.comparable = one.decided && one.known;
    one.agreeing = one.comparable && agrees;
    counts.all.add(one);
    counts.by_family[family].add(one);
    counts.by_kind[asked.kind].add(one);
    counts.by_both[{family, asked.kind}].add(one);
}

}  // namespace algae::attack
