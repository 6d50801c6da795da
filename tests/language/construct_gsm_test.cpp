#include <doctest/doctest.h>

#include "exact/exact.hpp"
#include "language/construct_any.hpp"
#include "language/detail/construct.hpp"
#include "language/regular_any.hpp"

using namespace algae;
using namespace algae::construct_tests;

namespace {

constexpr std::size_t longest = 4;

std::set<Word> intersection(std::set<Word> words, const RegularLanguage& language) {
    std::erase_if(words, [&](const Word& word) { return !language.contains(word); });
    return words;
}

/// Two states, up to five moves, one for each state and letter if deterministic.
Gsm any_machine(bool deterministic, bool erasing) {
    Gsm machine{0, {static_cast<char>(any_number(0, 1)), 1}, {}};
    for (std::size_t state = 0; state < 2; ++state)
        for (const Symbol a : {0u, 1u})
            for (int count = deterministic ? 1 : any_number(0, 2); count > 0; --count)
                machine.moves.push_back({state, a, static_cast<std::size_t>(any_number(0, 1)),
                                         any_word_over(2, erasing ? 0 : 1, 2)});
    return machine;
}

/// What the machine writes on all words of the set.
std::set<Word> written(const Gsm& machine, const std::set<Word>& words) {
    std::set<Word> found;
    for (const Word& word : words) {
        std::set<std::pair<std::size_t, Word>> places{{machine.initial, {}}};
        for (const Symbol a : word) {
            std::set<std::pair<std::size_t, Word>> next;
            for (const auto& [state, output] : places)
                for (const Gsm::Move& move : machine.moves)
                    if (move.from == state && move.letter == a) {
                        Word longer = output;
                        longer.insert(longer.end(), move.output.begin(), move.output.end());
                        next.emplace(move.to, longer);
                    }
            places = std::move(next);
        }
        for (const auto& [state, output] : places)
            if (machine.accepting[state]) found.insert(output);
    }
    return found;
}

std::set<Word> short_ones(std::set<Word> words) {
    std::erase_if(words, [](const Word& word) { return word.size() > longest; });
    return words;
}

}  // namespace

TEST_CASE("intersections with regular languages are what they are on sets of words") {
    for (const int tables : {1, 2})
        CHECK(rc::check("E0L and ET0L", [tables] {
            const ET0L system = any_system({tables, true, false, 2});
            const RegularLanguage language = regular_tests::any_listed(2).language;
            RC_LOG() << text_of(system);
            const auto words = intersection(words_of(system, longest), language);
            const ET0L result = e0l_intersection(system, language);
            require_form(result, system.tables.size());
            RC_ASSERT(words_of(result, longest) == words);
        }));
    CHECK(rc::check("EDT0L", [] {
        const ET0L system = any_system({2, true, true, 2});
        const RegularLanguage language = regular_tests::any_listed(1).language;
        RC_LOG() << text_of(system);
        const ET0L result = table_intersection(system, language);
        RC_ASSERT(is_deterministic(result));
        RC_ASSERT(words_of(result, longest) == intersection(words_of(system, longest), language));
    }));
}

TEST_CASE("machines write what they write on sets of words") {
    for (const bool deterministic : {false, true})
        CHECK(rc::check("gsm", [deterministic] {
            const ET0L system = any_system({1, true, deterministic, 2});
            const Gsm machine = any_machine(deterministic, false);
            RC_LOG() << text_of(system);
            const auto words = short_ones(written(machine, words_of(system, longest)));
            const ET0L one = e0l_gsm_image(system, machine),
                       more = table_gsm_image(system, machine);
            require_form(one, 1);
            if (deterministic) RC_ASSERT(is_deterministic(more));
            RC_ASSERT(words_of(one, longest) == words);
            RC_ASSERT(words_of(more, longest) == words);
        }));
}

TEST_CASE(
    "machines that erase: all that they write on short words, and three constructions agree") {
    CHECK(rc::check("erasing gsm", [] {
        const ET0L system = any_system({1, true, true, 2});
        const Gsm machine = any_machine(true, true);
        RC_LOG() << text_of(system);
        const auto words = words_of(e0l_gsm_image(system, machine), longest);
        RC_ASSERT(words_of(table_gsm_image(system, machine), longest) == words);
        for (const Word& word : short_ones(written(machine, words_of(system, 5))))
            RC_ASSERT(words.contains(word));
    }));
}

TEST_CASE("the squares among the powers of two") {
    const ET0L powers = et0l("a", {{{'a', "aa"}}});
    const RegularLanguage thirds = plus(finite_set({Word(3, 0)}));
    const RegularLanguage one_more =
        concatenated(thirds, finite_set({{0}}));  // 4, 7, 10, 13, 16, ...
    for (const ET0L& found :
         {e0l_intersection(powers, one_more), table_intersection(powers, one_more)})
        CHECK(oracle::short_words(found, 20) == std::set<Word>{Word(4, 0), Word(16, 0)});
    CHECK(oracle::short_words(e0l_intersection(powers, thirds), 20) == std::set<Word>{});
}

TEST_CASE("letters that a system does not have are in no word of it") {
    const ET0L powers = et0l("a", {{{'a', "aa"}}});
    const RegularLanguage language = finite_set({{0, 0}, {0, 7}});
    for (const ET0L& found :
         {e0l_intersection(powers, language), table_intersection(powers, language)})
        CHECK(oracle::short_words(found, 3) == std::set<Word>{{0, 0}});
}
