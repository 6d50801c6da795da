#include "language/language.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <map>
#include <set>

#include "exact/exact.hpp"
#include "oracle/random_systems.hpp"

using namespace algae;

namespace {

using Rules = std::map<char, std::string>;

std::string image(const Rules& rules, const std::string& word) {
    std::string out;
    for (const char a : word) {
        const auto rule = rules.find(a);
        out += rule == rules.end() ? std::string(1, a) : rule->second;
    }
    return out;
}

D0L system_of(const std::string& axiom, const Rules& rules) {
    return d0l(axiom, {rules.begin(), rules.end()});
}

using oracle::text_of;

/// Checks the proof from its words alone: an overflow is text with the sign of the side before it.
bool holds(const std::string& axiom, const Rules& left, const Rules& right,
           const Alphabet& alphabet, const Balance& proof) {
    std::set<std::string> states;
    for (const Overflow& overflow : proof.states) {
        if (overflow.word.size() > proof.bound) return false;
        const bool ahead = overflow.ahead == Overflow::Ahead::left;
        states.insert((overflow.word.empty() ? "="
                       : ahead               ? "+"
                                             : "-") +
                      text_of(alphabet, overflow.word));
    }
    std::set<char> letters(axiom.begin(), axiom.end());
    for (std::size_t before = 0; before != letters.size();) {
        before = letters.size();
        for (const char a : std::set<char>(letters))
            for (const char b : image(left, std::string(1, a))) letters.insert(b);
    }
    using Maps = std::map<std::pair<char, std::string>, std::string>;
    Maps maps;
    for (const char a : letters)
        for (const std::string& state : states) {
            const std::string more = image(left, std::string(1, a)),
                              other = image(right, std::string(1, a));
            const std::string one = (state[0] == '+' ? state.substr(1) : "") + more;
            const std::string two = (state[0] == '-' ? state.substr(1) : "") + other;
            std::string next = "refused";
            if (one.starts_with(two))
                next = (one == two ? "=" : "+") + one.substr(two.size());
            else if (two.starts_with(one))
                next = "-" + two.substr(one.size());
            maps[{a, state}] = states.contains(next) ? next : "refused";
        }
    const auto led = [&](const Maps& by, const std::string& word, std::string state) {
        for (const char a : word)
            if (state != "refused") state = by.at({a, state});
        return state;
    };
    std::vector<Maps> all;
    for (std::uint64_t k = 0; k <= proof.steps; ++k) {
        all.push_back(maps);
        if (k < proof.steps && led(maps, axiom, "=") != "=") return false;
        Maps next;
        for (const auto& [from, to] : maps)
            next[from] = led(maps, image(left, std::string(1, from.first)), from.second);
        maps = std::move(next);
    }
    return proof.earlier < proof.steps && all[proof.steps] == all[proof.earlier];
}

/// Decides, and checks the answer against the first words written out and the proof by the other route.
SequenceEquality decided(const std::string& axiom, const Rules& left, const std::string& other,
                         const Rules& right) {
    const D0L one = system_of(axiom, left), two = system_of(other, right);
    const SequenceEquality found = equal_sequences(one, two);
    REQUIRE(found.equal == found.balance.has_value());
    REQUIRE(found.equal != found.difference.has_value());
    const SequencePair pair = over_common_alphabet(one, two);
    if (found.equal) CHECK(holds(axiom, left, right, *pair.alphabet, *found.balance));
    std::string a = axiom, b = other;
    for (std::uint64_t n = 0; n < 12 && a.size() + b.size() < 20'000; ++n) {
        CHECK((a == b) == (found.equal || n < found.difference->generation));
        if (a != b) {
            CHECK(found.difference->generation == n);
            const auto at = static_cast<std::size_t>(
                std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first - a.begin());
            CHECK(found.difference->position == Integer(at));
            const std::size_t from = found.difference->from.to_uint64();
            CHECK(from <= at);
            CHECK(from + 8 >= at);
            CHECK(text_of(*pair.alphabet, found.difference->left) == a.substr(from, 20));
            CHECK(text_of(*pair.alphabet, found.difference->right) == b.substr(from, 20));
            CHECK(found.difference->left_length == Integer(a.size()));
            CHECK(found.difference->right_length == Integer(b.size()));
            break;
        }
        a = image(left, a);
        b = image(right, b);
    }
    return found;
}

std::vector<std::string> words_over_ab(std::size_t longest) {
    std::vector<std::string> all{""};
    for (std::size_t i = 0; i < all.size(); ++i)
        if (all[i].size() < longest)
            for (const char a : {'a', 'b'}) all.push_back(all[i] + a);
    return all;
}

}  // namespace

TEST_CASE("all pairs of small binary systems with four equal words are decided, and equal") {
    // Axioms of 1 to 5 letters, images of up to 4, both letters accessible: 184 pairs, which are 92 up to
    // the exchange of a and b.
    std::size_t pairs = 0, bound = 0, states = 0;
    const auto images = words_over_ab(4);
    std::set<std::string> classes;
    const auto exchanged = [](std::string word) {
        for (char& a : word) a = a == 'a' ? 'b' : 'a';
        return word;
    };
    const auto key = [](const std::string& axiom, const Rules& one, const Rules& two) {
        return axiom + '|' + std::min(one, two).at('a') + '|' + std::min(one, two).at('b') + '|' +
               std::max(one, two).at('a') + '|' + std::max(one, two).at('b');
    };
    for (const std::string& axiom : words_over_ab(5)) {
        std::map<std::vector<std::string>, std::vector<Rules>> by_words;
        for (const std::string& a : images)
            for (const std::string& b : images) {
                const Rules rules{{'a', a}, {'b', b}};
                std::vector<std::string> words{axiom};
                for (int n = 0; n < 3; ++n) words.push_back(image(rules, words.back()));
                std::set<char> letters;
                for (const std::string& word : words) letters.insert(word.begin(), word.end());
                if (letters.size() == 2) by_words[words].push_back(rules);
            }
        for (const auto& [words, systems] : by_words)
            for (std::size_t i = 0; i < systems.size(); ++i)
                for (std::size_t j = i + 1; j < systems.size(); ++j) {
                    ++pairs;
                    const SequenceEquality found = decided(axiom, systems[i], axiom, systems[j]);
                    CHECK(found.equal);
                    if (!found.equal) continue;
                    bound = std::max(bound, found.balance->bound);
                    states = std::max(states, found.balance->states.size());
                    const auto other = [&](const Rules& rules) {
                        return Rules{{'a', exchanged(rules.at('b'))},
                                     {'b', exchanged(rules.at('a'))}};
                    };
                    classes.insert(
                        std::min(key(axiom, systems[i], systems[j]),
                                 key(exchanged(axiom), other(systems[i]), other(systems[j]))));
                }
    }
    CHECK(pairs == 184);
    CHECK(classes.size() == 92);
    CHECK(bound == 8);
    MESSAGE("at most ", states, " states");
}

TEST_CASE("three equal words of two letters do not suffice") {
    const SequenceEquality found =
        decided("ab", {{'a', "abb"}, {'b', "aabba"}}, "ab", {{'a', "abbaabb"}, {'b', "a"}});
    CHECK_FALSE(found.equal);
    CHECK(found.difference->generation == 3);
}

TEST_CASE("erasing systems with the greatest overflow of the small ones") {
    const SequenceEquality found =
        decided("ab", {{'a', ""}, {'b', "aabb"}}, "ab", {{'a', "aabb"}, {'b', ""}});
    CHECK(found.equal);
    CHECK(found.balance->bound == 8);
}

TEST_CASE("any systems that cut the same words in other places") {
    std::size_t equal = 0, different = 0;
    const bool agrees = rc::check("equal sequences", [&] {
        const std::string axiom = *rc::gen::element<std::string>("ab", "abc", "acb", "abca");
        const std::string letters = axiom.substr(0, axiom.find('a', 1));
        Rules left, right;
        std::string all;
        for (const char a : letters) all += left[a] = *oracle::any_word("abc", 4);
        std::size_t at = 0;
        for (const char a : letters) {
            const std::size_t end =
                a == letters.back() ? all.size() : *rc::gen::inRange(at, all.size() + 1);
            right[a] = all.substr(at, end - at);
            at = end;
        }
        ++(decided(axiom, left, axiom, right).equal ? equal : different);
    });
    CHECK(agrees);
    CHECK(equal > 0);
    CHECK(different > 0);
}

TEST_CASE("any two systems") {
    CHECK(rc::check("equal sequences", [] {
        const auto left = *oracle::any_d0l(), right = *oracle::any_d0l();
        const auto rules = [](const oracle::WrittenSystem& system) {
            Rules all;
            for (const auto& [a, successors] : system.successors) all[a] = successors.front();
            return all;
        };
        decided(left.axiom, rules(left), *rc::gen::element(left.axiom, right.axiom), rules(right));
        RC_ASSERT(
            decided(left.axiom, rules(left), left.axiom, rules(left)).balance->states.size() == 1);
    }));
}

TEST_CASE("all pairs over three letters with axiom abc and at most five letters in all images") {
    std::map<std::vector<std::string>, std::vector<Rules>> by_words;
    std::vector<std::string> images{""};
    for (std::size_t i = 0; i < images.size(); ++i)
        if (images[i].size() < 5)
            for (const char a : {'a', 'b', 'c'}) images.push_back(images[i] + a);
    for (const std::string& a : images)
        for (const std::string& b : images) {
            if (a.size() + b.size() > 5) continue;
            for (const std::string& c : images) {
                if (a.size() + b.size() + c.size() > 5) break;
                const Rules rules{{'a', a}, {'b', b}, {'c', c}};
                std::vector<std::string> words{"abc"};
                for (int n = 0; n < 4; ++n) words.push_back(image(rules, words.back()));
                by_words[words].push_back(rules);
            }
        }
    std::size_t pairs = 0, different = 0;
    for (const auto& [words, systems] : by_words)
        for (std::size_t i = 0; i < systems.size(); ++i)
            for (std::size_t j = i + 1; j < systems.size() && j < i + 4; ++j) {
                const SequencePair pair = over_common_alphabet(system_of("abc", systems[i]),
                                                               system_of("abc", systems[j]));
                const SequenceEquality found = equal_sequences(pair.left, pair.right);
                ++pairs;
                if (!found.equal) ++different;
                if (found.equal)
                    CHECK(holds("abc", systems[i], systems[j], *pair.alphabet, *found.balance));
            }
    CHECK(pairs > 100);
    CHECK(different == 0);
}

TEST_CASE("letters are the same if their names are, in whatever order systems have them") {
    const D0L left = d0l("ab", {{'a', "ab"}, {'b', "a"}}),
              right = d0l("ab", {{'b', "a"}, {'a', "ab"}, {'x', "xx"}});
    CHECK(equal_sequences(left, right).equal);
    const D0L turned = make_d0l(std::make_shared<const Alphabet>([] {
                                    Alphabet letters;
                                    letters.symbol("b");
                                    letters.symbol("a");
                                    return letters;
                                }()),
                                {1, 0}, {{1}, {1, 0}});
    CHECK(equal_sequences(left, turned).equal);
    // A letter that the other does not have stays there.
    CHECK(equal_sequences(d0l("c", {}), d0l("c", {{'c', "c"}})).equal);
    CHECK(equal_sequences(d0l("c", {}), d0l("c", {{'c', "d"}})).difference->generation == 1);
}

TEST_CASE("systems whose rules factor through fewer letters") {
    // a and b become powers of one word, so both go through one letter.
    CHECK(decided("abc", {{'a', "abc"}, {'b', "abcabc"}, {'c', ""}}, "abc",
                  {{'a', "abcabc"}, {'b', ""}, {'c', "abc"}})
              .equal);
    CHECK(decided("aabb", {{'a', "ab"}, {'b', "ab"}}, "aabb", {{'a', "abab"}, {'b', ""}}).equal);
    CHECK_FALSE(
        decided("aabb", {{'a', "aabb"}, {'b', ""}}, "aabb", {{'a', "aabb"}, {'b', "aabb"}}).equal);
    CHECK(decided("ab", {{'a', ""}, {'b', ""}}, "ab", {{'a', ""}, {'b', ""}}).equal);
    CHECK(decided("", {}, "", {{'a', "b"}}).equal);
}

TEST_CASE("sequences that come again, and one that differs late") {
    CHECK(decided("ab", {{'a', "b"}, {'b', "a"}}, "ab", {{'a', "ba"}, {'b', ""}}).equal == false);
    const SequenceEquality found = decided("abcd", {{'a', "b"}, {'b', "c"}, {'c', "d"}, {'d', ""}},
                                           "abcd", {{'a', "b"}, {'b', "c"}, {'c', "d"}, {'d', ""}});
    CHECK(found.equal);
    std::vector<std::pair<char, std::string>> left, right;
    for (char a = '!'; a < '!' + 40; ++a) {
        left.emplace_back(a, std::string(1, static_cast<char>(a + 1)));
        right.push_back(left.back());
    }
    right.back().second += right.back().second;
    CHECK(equal_sequences(d0l("!", left), d0l("!", right)).difference->generation == 40);
}

TEST_CASE("words too long to write are compared all the same") {
    // Generation n has 2^n letters; a chain of 200 letters ends differently.
    std::vector<Word> one, two;
    Alphabet letters;
    for (Symbol a = 0; a < 200; ++a) {
        letters.symbol("x_" + std::to_string(a));
        one.push_back(a == 199 ? Word{a} : Word{a, a + 1});
    }
    two = one;
    two[198] = {198, 199, 199};
    const auto alphabet = std::make_shared<const Alphabet>(std::move(letters));
    const D0L left = make_d0l(alphabet, {0}, one), right = make_d0l(alphabet, {0}, two);
    const SequenceEquality found = equal_sequences(left, right);
    REQUIRE(!found.equal);
    CHECK(found.difference->generation == 199);
    CHECK(found.difference->right_length - found.difference->left_length == 1);
    CHECK(found.difference->position == found.difference->left_length);
}

TEST_CASE("a bound that is reached is no answer, and says what was tried") {
    Budget budget;
    budget.memory = 600;
    const D0L left = d0l("ab", {{'a', ""}, {'b', "aabb"}}),
              right = d0l("ab", {{'a', "aabb"}, {'b', ""}});
    try {
        equal_sequences(left, right, budget);
        FAIL("no bound");
    } catch (const BoundReached& bound) {
        const std::string what = bound.what();
        CHECK(what.find("; undecided: generations 0 to ") != std::string::npos);
        CHECK(what.find("are the same, with ") != std::string::npos);
    }
}
