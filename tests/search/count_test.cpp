#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <atomic>
#include <string>

#include "search/search.hpp"

using namespace algae;

namespace {

Tuple systems(bool deterministic, bool propagating,
              std::optional<std::uint64_t> letters = std::nullopt) {
    return {{Domain{.kind = Domain::Kind::system,
                    .deterministic = deterministic,
                    .propagating = propagating,
                    .letters = letters}}};
}

std::vector<std::uint64_t> counts(const Tuple& tuple, std::uint64_t first, std::uint64_t last) {
    std::vector<std::uint64_t> found;
    for (std::uint64_t size = first; size <= last; ++size)
        found.push_back(instance_count(tuple, size));
    return found;
}

std::vector<std::string> texts(const Tuple& tuple, std::uint64_t size, InstanceRange range = {}) {
    std::vector<std::string> found;
    visit(
        tuple, size,
        [&](const Instance& instance) {
            found.push_back(instance.text());
            return true;
        },
        {}, range);
    return found;
}

using Counts = std::vector<std::uint64_t>;

}  // namespace

TEST_CASE("how many 0L systems there are") {
    CHECK(counts(systems(false, false), 2, 9) == Counts{1, 2, 6, 20, 81, 348, 1593, 7849});
    CHECK(counts(systems(false, false, 3), 10, 11) == Counts{36360, 175317});
    CHECK(counts(systems(false, true), 2, 9) == Counts{0, 1, 2, 5, 21, 87, 374, 1703});
    CHECK(counts(systems(false, true, 3), 10, 11) == Counts{8216, 41002});
}

TEST_CASE("how many 0L systems have two letters, and three") {
    Counts two, three;
    for (std::uint64_t size = 4; size <= 11; ++size) {
        Counts by_letters(4);
        visit(systems(false, false, 3), size, [&](const Instance& instance) {
            ++by_letters[instance.letters()];
            return true;
        });
        two.push_back(by_letters[2]);
        if (size >= 6) three.push_back(by_letters[3]);
    }
    CHECK(two == Counts{2, 14, 67, 262, 913, 2951, 9039, 26607});
    CHECK(three == Counts{5, 73, 648, 4531, 27289, 148668});
}

TEST_CASE("how many finite languages there are") {
    Tuple languages{{Domain{}}};
    languages.letters = 3;
    CHECK(counts(languages, 2, 9) == Counts{1, 3, 8, 25, 83, 273, 917, 3079});
}

TEST_CASE("how many D0L systems there are, by counting and by visiting") {
    const Counts d0l{1,     2,      5,      17,      64,       256,       1109,      5206,
                     26133, 138858, 777449, 4573666, 28181517, 181269850, 1213667179};
    const Counts pd0l{0,    1,     2,      5,       20,      82,       334,      1463,
                      7014, 35909, 192906, 1084701, 6391470, 39401503, 253194702};
    for (std::uint64_t size = 0; size <= 16; ++size) {
        CAPTURE(size);
        CHECK(DeterministicSystems(size).count() == (size < 2 ? 0 : d0l[size - 2]));
        CHECK(DeterministicSystems(size, true).count() == (size < 2 ? 0 : pd0l[size - 2]));
    }
    CHECK(counts(systems(true, false), 2, 11) == Counts(d0l.begin(), d0l.begin() + 10));
    CHECK(counts(systems(true, true), 2, 12) == Counts(pd0l.begin(), pd0l.begin() + 11));
    // With another bound there is no table.
    Tuple all = systems(true, false), propagating = systems(true, true);
    all.values[0].max_size = propagating.values[0].max_size = 100;
    CHECK(counts(all, 2, 10) == Counts(d0l.begin(), d0l.begin() + 9));
    CHECK(counts(propagating, 2, 11) == Counts(pd0l.begin(), pd0l.begin() + 10));
}

TEST_CASE("counted systems are visited in the same order as all others") {
    for (const bool propagating : {false, true})
        for (std::uint64_t size = 0; size <= 9; ++size)
            for (const std::uint64_t letters : {std::uint64_t{2}, size}) {
                Tuple others = systems(true, propagating, letters);
                others.values[0].max_size = 100;
                const auto expected = texts(others, size);
                CHECK(texts(systems(true, propagating, letters), size) == expected);
                CHECK(DeterministicSystems(size, propagating, letters).count() == expected.size());
            }
}

TEST_CASE("a system by its number") {
    std::size_t cases = 0;
    CHECK(rc::check([&] {
        const auto size = *rc::gen::inRange<std::uint64_t>(2, 10);
        const bool propagating = *rc::gen::arbitrary<bool>();
        const DeterministicSystems all(size, propagating);
        const auto expected = texts(systems(true, propagating), size);
        RC_ASSERT(all.count() == expected.size());
        if (expected.empty()) return;
        const auto index = *rc::gen::inRange<std::size_t>(0, expected.size());
        RC_ASSERT(all.at(index).text() == expected[index]);
        ++cases;
    }));
    CHECK(cases > 50);
    const DeterministicSystems large(30);
    const Integer last = large.count() - 1;
    CHECK(large.at(last).text() == "abcdefghijklmno" + [] {
        std::string empty;
        for (int i = 0; i < 15; ++i) empty += "#ε";
        return empty;
    }());
    CHECK_THROWS_AS(large.at(last + 1), Error);
    CHECK_THROWS_AS(large.at(-1), Error);
    const D0L middle = large.at(last - 12345).d0l(0);
    CHECK(middle.letters.size() == middle.alphabet->size());
}

TEST_CASE("parts of the instances put together are all of them") {
    std::size_t cases = 0;
    const Tuple pair{{Domain{}, Domain{.kind = Domain::Kind::system}}};
    CHECK(rc::check([&] {
        const bool is_counted = *rc::gen::arbitrary<bool>();
        const Tuple tuple = is_counted ? systems(true, false) : pair;
        const auto size = *rc::gen::inRange<std::uint64_t>(2, 9);
        const auto expected = texts(tuple, size);
        std::vector<std::string> found;
        const auto step = *rc::gen::inRange<std::uint64_t>(1, expected.size() + 2);
        for (std::uint64_t first = 0; first < expected.size(); first += step) {
            const auto part = texts(tuple, size, {first, first + step});
            RC_ASSERT(part.size() <= step);
            found.insert(found.end(), part.begin(), part.end());
        }
        RC_ASSERT(found == expected);
        RC_ASSERT(texts(tuple, size, {expected.size(), expected.size() + 5}).empty());
        RC_ASSERT(texts(tuple, size, {3, 3}).empty());
        ++cases;
    }));
    CHECK(cases > 50);
}

TEST_CASE("a visitor stops the visit, and so does a budget") {
    for (const bool deterministic : {false, true}) {
        std::size_t seen = 0;
        const auto stop = [&](const Instance&) { return ++seen < 10; };
        CHECK(!visit(systems(deterministic, false), 9, stop));
        CHECK(seen == 10);
        CHECK(!visit_all(systems(deterministic, false),
                         [&](const Instance&) { return ++seen < 100; }));
        CHECK(seen == 100);
        CHECK(visit(systems(deterministic, false), 9, stop, {}, {5, 5}));
        std::atomic<bool> asked{true};
        Budget budget;
        budget.stop = &asked;
        CHECK_THROWS_AS(instance_count(systems(deterministic, false), 11, budget), Interrupted);
    }
}

TEST_CASE("words that nothing but their letters tells apart are not renamed in all ways") {
    const Tuple letters{{Domain{.max_word_length = 1}}}, pairs{{Domain{.max_word_length = 2}}};
    CHECK(instance_count(letters, 8) == 1);
    CHECK(instance_count(letters, 50) == 1);  // 25! renamings
    CHECK(instance_count(pairs, 6) == 15);
}

TEST_CASE("a budget stops the visit while letters that look alike are renamed") {
    // There are few instances, but where both languages have the same k letters k! renamings are tried.
    std::atomic<bool> asked{true};
    Budget budget;
    budget.stop = &asked;
    const Tuple both{{Domain{.max_word_length = 1}, Domain{.max_word_length = 1}}};
    CHECK(instance_count(both, 8) == 15);
    CHECK_THROWS_AS(instance_count(both, 60, budget), Interrupted);
}

TEST_CASE("bounds that leave finitely many instances end the visit") {
    const auto count = [](const Tuple& tuple) {
        std::uint64_t found = 0, greatest = 0;
        CHECK(visit_all(tuple, [&](const Instance& instance) {
            ++found;
            greatest = instance.size();
            return true;
        }));
        CHECK(greatest <= greatest_size(tuple).value());
        return found;
    };
    const Domain words{.kind = Domain::Kind::word, .max_word_length = 3};
    CHECK(count({{words}}) == 1 + 1 + 2 + 5);  // Bell numbers
    CHECK(count({.values = {words}, .over = 2}) == 1 + 2 + 4 + 8);
    const Domain languages{.max_word_length = 2};
    CHECK(!is_finite({{languages}}));
    CHECK(count({.values = {languages}, .over = 2}) == 128);
    CHECK(count({.values = {languages}, .letters = 1}) == 8);
    const Domain numbers{.kind = Domain::Kind::number, .max_number = 4};
    CHECK(count({{numbers, numbers}}) == 25);
    const Domain letter{.kind = Domain::Kind::letter};
    CHECK(count({{letter, letter, letter}}) == 5);
    CHECK(count({.values = {letter, letter, letter}, .disjoint = true}) == 1);
    CHECK(count({{letter, Domain{.kind = Domain::Kind::morphism, .letter_to_letter = true}}}) == 2);
    CHECK(count({{Domain{.kind = Domain::Kind::system, .deterministic = true, .max_size = 6}}}) ==
          1 + 2 + 5 + 17 + 64);
    CHECK(count({{words, Domain{.kind = Domain::Kind::inverse_morphism,
                                .max_word_length = 1,
                                .letters = 2}}}) == 2 + 5 + 5 + 9 + 5 + 3 * 9 + 14);
    const Domain unary{.kind = Domain::Kind::system, .max_word_length = 1, .letters = 1};
    CHECK(count({{unary}}) == 3);
    CHECK(
        count({{Domain{
            .kind = Domain::Kind::system, .tables = true, .max_word_length = 1, .letters = 1}}}) ==
        7);
    CHECK(!is_finite({{Domain{.kind = Domain::Kind::number}}}));
    CHECK(!is_finite({{Domain{.kind = Domain::Kind::system, .max_word_length = 3}}}));
    CHECK(!is_finite(
        {{words, Domain{.kind = Domain::Kind::inverse_morphism, .max_word_length = 1}}}));
    CHECK(is_finite({{words, Domain{.kind = Domain::Kind::morphism, .max_word_length = 1}}}));
    CHECK(!is_finite({{words, Domain{.kind = Domain::Kind::substitution, .max_word_length = 1}}}));
}

TEST_CASE("what an instance is asked for must be there") {
    visit(systems(false, false), 4, [](const Instance& instance) {
        CHECK_THROWS_AS(instance.language(0), Error);
        CHECK_THROWS_AS(instance.number(1), Error);
        CHECK(instance.ol(0).letters.size() == instance.letters());
        return true;
    });
    const auto with_tables = Tuple{{Domain{.kind = Domain::Kind::system, .tables = true}}};
    visit(with_tables, 4, [](const Instance& instance) {
        if (instance.et0l(0).tables.size() == 2) CHECK_THROWS_AS(instance.ol(0), Error);
        return true;
    });
}
