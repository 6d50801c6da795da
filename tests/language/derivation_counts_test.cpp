#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <map>
#include <set>

#include "exact/exact.hpp"
#include "language/language.hpp"
#include "oracle/random_tables.hpp"

using namespace algae;

namespace {

using Counts = std::map<std::string, Integer>;

/// By word: in how many ways the different rules of a table make it of this one.
Counts ways(const oracle::WrittenTables& system, std::size_t table, const std::string& word) {
    Counts found{{"", 1}};
    for (const char letter : word) {
        const auto successors = system.successors(table, letter);
        Counts longer;
        for (const auto& [begun, count] : found)
            for (const std::string& successor :
                 std::set<std::string>(successors.begin(), successors.end()))
                longer[begun + successor] += count;
        found = std::move(longer);
    }
    return found;
}

/// How many derivations of n steps each word has, all of them tried; nothing if the words are too many.
std::optional<Counts> derived(const oracle::WrittenTables& system, unsigned n) {
    Counts now{{system.axiom, 1}};
    for (unsigned t = 0; t < n; ++t) {
        Counts next;
        for (const auto& [word, count] : now)
            for (std::size_t table = 0; table < system.tables.size(); ++table) {
                if (word.size() > 10) return std::nullopt;
                for (const auto& [to, times] : ways(system, table, word)) next[to] += count * times;
            }
        now = std::move(next);
        if (now.size() > 3000) return std::nullopt;
    }
    return now;
}

Word letters_of(const std::string& text) {
    Word word;
    for (const char letter : text) word.push_back(static_cast<Symbol>(letter - 'a'));
    return word;
}

/// Each letter becomes later ones, the last one more of it: no word comes again.
void go_on(oracle::WrittenTables& system) {
    const auto later = [](std::vector<std::string>& words, const std::string& letters) {
        if (words.empty()) words.push_back("c");
        for (std::string& word : words)
            for (char& letter : word)
                letter = letters[static_cast<std::size_t>(letter - 'a') % letters.size()];
    };
    for (auto& table : system.tables) {
        later(table['a'], "bc");
        later(table['b'], "c");
        table['c'] = {"cc"};
    }
}

/// Whether a word of a propagating system has infinitely many derivations: words that are not longer, and
/// the steps between them, are finitely many, so that is a cycle on a way from the axiom to the word.
bool has_infinitely_many(const oracle::WrittenTables& system, const std::string& word) {
    std::map<std::string, std::set<std::string>> after;
    std::vector<std::string> open{system.axiom};
    after[system.axiom];
    while (!open.empty()) {
        const std::string from = open.back();
        open.pop_back();
        for (std::size_t table = 0; table < system.tables.size(); ++table)
            for (const auto& [to, count] : ways(system, table, from)) {
                if (to.size() > word.size()) continue;
                after[from].insert(to);
                if (after.try_emplace(to).second) open.push_back(to);
            }
    }
    const auto reaches = [&](const std::string& from,
                             const std::string& to) {  // in one step or more
        std::set<std::string> seen;
        std::vector<std::string> waiting{from};
        while (!waiting.empty()) {
            const std::string here = waiting.back();
            waiting.pop_back();
            for (const std::string& next : after[here]) {
                if (next == to) return true;
                if (seen.insert(next).second) waiting.push_back(next);
            }
        }
        return false;
    };
    for (const auto& [middle, next] : after)
        if (reaches(middle, middle) && (middle == word || reaches(middle, word))) return true;
    return false;
}

}  // namespace

TEST_CASE("derivations are counted as when all are tried") {
    std::size_t words = 0, several = 0, none = 0, with_tables = 0;
    CHECK(rc::check("counts", [&] {
        const auto written = *oracle::any_tables(3, true, {"", "ab", "bc"});
        const ET0L system = oracle::et0l_of(written);
        const unsigned n = *rc::gen::inRange(0u, 5u);
        const auto tried = derived(written, n);
        if (!tried) return;
        std::set<std::string> asked;
        for (const auto& [word, count] : *tried)
            if (word.size() <= 6 && asked.size() < 25) asked.insert(word);
        for (const char* other : {"", "a", "ab", "bca", "cc"}) asked.insert(other);
        for (const std::string& word : asked) {
            const auto found = tried->find(word);
            const Integer expected =
                found != tried->end() && written.is_terminal_word(word) ? found->second : 0;
            RC_LOG() << word << " in " << n << " steps\n";
            RC_ASSERT(number_of_derivations(system, letters_of(word), n) == expected);
            ++words;
            several += expected > 1;
            none += expected == 0;
            with_tables += written.tables.size() > 1 && expected > 1;
        }
    }));
    CHECK(words > 100);
    CHECK(several > 5);
    CHECK(none > 5);
    CHECK(with_tables > 2);
}

TEST_CASE("all derivations are different, derive the word, and are as many as counted") {
    std::size_t listed = 0;
    CHECK(rc::check("all", [&] {
        const auto written = *oracle::any_tables(2, true, {"", "ab"});
        const ET0L system = oracle::et0l_of(written);
        const unsigned n = *rc::gen::inRange(0u, 5u);
        const auto tried = derived(written, n);
        if (!tried) return;
        std::vector<std::string> members, often;
        for (const auto& [word, count] : *tried)
            if (word.size() <= 6) (count > 1 ? often : members).push_back(word);
        if (!often.empty()) members = often;
        if (members.empty()) return;
        const Word word = letters_of(*rc::gen::elementOf(members));
        const Integer count = number_of_derivations(system, word, n);
        const std::size_t most = *rc::gen::inRange<std::size_t>(0, 300);
        const std::vector<Derivation> all = derivations(system, word, n, most);
        RC_ASSERT(Integer(all.size()) == std::min(count, Integer(most)));
        std::set<std::tuple<std::vector<Word>, std::vector<std::vector<std::uint32_t>>,
                            std::vector<std::uint32_t>>>
            different;
        for (const Derivation& one : all) {
            RC_ASSERT(is_derivation(system, one));
            RC_ASSERT(one.words.size() == n + 1);
            RC_ASSERT(one.words.back() == word);
            RC_ASSERT(different.emplace(one.words, one.choices, one.tables).second);
        }
        listed += all.size() > 1;
    }));
    CHECK(listed > 2);
}

TEST_CASE("whether there are infinitely many derivations, and how many in all") {
    std::size_t infinite = 0, finite = 0, several = 0;
    CHECK(rc::check("in all", [&] {
        auto written = *oracle::any_tables(2, false, {""});
        if (*rc::gen::arbitrary<bool>()) go_on(written);
        const ET0L system = oracle::et0l_of(written);
        const auto tried = derived(written, *rc::gen::inRange(1u, 4u));
        if (!tried) return;
        std::vector<std::string> members{"ab", "ccc", "cccc"};
        for (const auto& [word, count] : *tried)
            if (word.size() <= 5) members.push_back(word);
        const std::string text = *rc::gen::elementOf(members);
        RC_LOG() << text << '\n';
        const Word word = letters_of(text);
        const DerivationCounts found = derivation_counts(system, word, 4);
        RC_ASSERT(!found.total == has_infinitely_many(written, text));
        if (!found.total) {
            ++infinite;
            RC_ASSERT(found.by_steps.size() == 4);
        } else {
            Integer sum = 0;
            for (const auto& [steps, count] : found.by_steps) sum += count;
            RC_ASSERT(sum == *found.total);
            ++finite;
            several += sum > 1;
        }
        // Nothing is left out before the last number of steps, nor soon after it.
        std::map<std::uint64_t, Integer> counts;
        for (const auto& [steps, count] : found.by_steps) counts[steps] = count;
        const std::uint64_t last = counts.empty() ? 0 : counts.rbegin()->first;
        for (std::uint64_t n = 0; n <= std::min<std::uint64_t>(last + (found.total ? 4 : 0), 12);
             ++n)
            RC_ASSERT(number_of_derivations(system, word, n) ==
                      (counts.contains(n) ? counts[n] : Integer(0)));
    }));
    CHECK(infinite > 2);
    CHECK(finite > 2);
    CHECK(several > 0);
}

TEST_CASE("numbers of derivations of any size, and of systems without choices") {
    const ET0L doubling = as_et0l(ol("a", {{'a', "a"}, {'a', "aa"}}));
    // Of a in n steps one; of aa, the step in which the letter doubles.
    CHECK(number_of_derivations(doubling, {0}, 1000) == 1);
    CHECK(number_of_derivations(doubling, {0, 0}, 1000) == 1000);
    CHECK(number_of_derivations(doubling, Word(20, 0), 40) > power(Integer(10), 20));
    const DerivationCounts many = derivation_counts(doubling, {0, 0}, 3);
    CHECK_FALSE(many.total);
    CHECK(many.by_steps == std::vector<DerivationCounts::Steps>{{1, 1}, {2, 2}, {3, 3}});
    // A long word of a system without choices.
    const OL words = ol("b", {{'a', "ab"}, {'b', "a"}});
    const D0L same = d0l("b", {{'a', "ab"}, {'b', "a"}});
    const Word late = derive(same, 25);
    CHECK(*derivation_counts(as_et0l(words), late).total == 1);
    CHECK(number_of_derivations(as_et0l(words), late, 25) == 1);
    CHECK(number_of_derivations(as_et0l(words), late, 24) == 0);
    // One that comes again and again.
    const ET0L turns = as_et0l(ol("ca", {{'a', "b"}, {'b', "a"}, {'c', ""}}));
    const DerivationCounts again = derivation_counts(turns, {2}, 3);
    CHECK_FALSE(again.total);
    CHECK(again.by_steps == std::vector<DerivationCounts::Steps>{{1, 1}, {3, 1}, {5, 1}});
    CHECK(number_of_derivations(turns, {2}, 1'000'000'000'001) == 1);
    CHECK(number_of_derivations(turns, {2}, 1'000'000'000'002) == 0);
    CHECK(*derivation_counts(turns, {0, 1}).total == 1);
    CHECK(derivations(turns, {2}, 3, 10).size() == 1);
    // What is erased counts too: nothing is left of aa by the same rule or by both.
    const ET0L erasing = as_et0l(ol("aa", {{'a', ""}, {'a', "b"}, {'b', ""}}));
    CHECK(number_of_derivations(erasing, {}, 2) == 4);
    // Equal rules are one.
    CHECK(number_of_derivations(et0l("a", {{{'a', "b"}, {'a', "b"}}}), {1}, 1) == 1);
    CHECK(derivations(et0l("a", {{{'a', "b"}, {'a', "b"}}}), {1}, 1, 9).size() == 1);
}

TEST_CASE("counting derivations stops at its bounds") {
    const ET0L doubling = as_et0l(ol("a", {{'a', "a"}, {'a', "aa"}}));
    Budget small;
    small.memory = 1000;
    CHECK_THROWS_AS(number_of_derivations(doubling, Word(30, 0), 3, small), BoundReached);
    CHECK_THROWS_AS(derivation_counts(doubling, Word(30, 0), 3, small), BoundReached);
    CHECK_THROWS_AS(derivations(doubling, Word(4, 0), 1000, 3, small), BoundReached);
    Budget late;
    late.deadline = std::chrono::steady_clock::now() - std::chrono::seconds(1);
    CHECK_THROWS_AS(number_of_derivations(doubling, Word(30, 0), 3, late), BoundReached);
    CHECK_THROWS_AS(derivation_counts(doubling, Word(30, 0), 3, late), BoundReached);
}
