#include "language/detail/regular.hpp"

#include <doctest/doctest.h>

#include "exact/exact.hpp"
#include "language/regular_any.hpp"

using namespace algae;
using namespace algae::regular_tests;

namespace {

/// In shortlex order.
std::vector<Word> in_order(const std::set<Word>& words) {
    std::vector<Word> sorted(words.begin(), words.end());
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Word& u, const Word& v) { return u.size() < v.size(); });
    return sorted;
}

Word replaced(const Word& word, const std::vector<Word>& images) {
    Word found;
    for (const Symbol a : word) found.insert(found.end(), images.at(a).begin(), images.at(a).end());
    return found;
}

std::vector<Word> any_images(int least) {
    std::vector<Word> images;
    for (int i = 0; i < 2; ++i) {
        const int size = *rc::gen::inRange(least, 3);
        images.push_back(*rc::gen::container<Word>(static_cast<std::size_t>(size),
                                                   rc::gen::element(Symbol{0}, Symbol{1})));
    }
    return images;
}

}  // namespace

TEST_CASE("words, their number and the first one are those that listing gives") {
    const bool holds = rc::check("words", [] {
        const Listed any = any_listed(2);
        const auto sorted = in_order(any.words);
        RC_ASSERT(words_up_to(any.language, longest) == sorted);
        for (std::size_t length = 0; length <= longest; ++length)
            RC_ASSERT(number_of_words(any.language, length) ==
                      Integer(std::count_if(sorted.begin(), sorted.end(), [&](const Word& word) {
                          return word.size() == length;
                      })));
        if (!sorted.empty()) RC_ASSERT(shortest_word(any.language) == sorted.front());
        RC_ASSERT(is_empty(any.language) == !shortest_word(any.language).has_value());
        const auto number = number_of_words(any.language);
        RC_ASSERT(is_finite(any.language) == number.has_value());
        // No word of a finite language is as long as the automaton has states.
        const auto all =
            words_up_to(any.language, std::min<std::size_t>(any.language.automaton().states(), 14));
        if (number && any.language.automaton().states() <= 14)
            RC_ASSERT(*number == Integer(all.size()));
    });
    CHECK(holds);
}

TEST_CASE("a witness against inclusion or equality is the first word there is") {
    const bool holds = rc::check("witnesses", [] {
        const Listed left = any_listed(2), right = any_listed(2);
        std::set<Word> outside = left.words;
        std::erase_if(outside, [&](const Word& word) { return right.words.contains(word); });
        const auto found = first_outside(left.language, right.language);
        if (!outside.empty()) RC_ASSERT(found == in_order(outside).front());
        if (found) RC_ASSERT(left.language.contains(*found) && !right.language.contains(*found));
        RC_ASSERT(found.has_value() != (united(left.language, right.language) == right.language));
        const auto different = first_difference(left.language, right.language);
        RC_ASSERT(different.has_value() == (left.language != right.language));
        if (different)
            RC_ASSERT(left.language.contains(*different) != right.language.contains(*different));
    });
    CHECK(holds);
}

TEST_CASE("the inverse image is asked word by word, the image made word by word") {
    const bool holds = rc::check("images", [] {
        const Listed any = any_listed(2);
        const std::vector<Word> h = any_images(0);
        std::set<Word> before = all_short_words();
        std::erase_if(before,
                      [&](const Word& word) { return !any.language.contains(replaced(word, h)); });
        RC_ASSERT(contained(inverse_image(any.language, h, {0, 1})) == before);
        std::set<Word> after;
        const std::vector<Word> longer = any_images(1);
        for (const Word& word : any.words)
            if (const Word made = replaced(word, longer); made.size() <= longest)
                after.insert(made);
        RC_ASSERT(contained(image(any.language, longer)) == after);
        const std::vector<RegularLanguage> sets{finite_set({longer[0]}), finite_set({longer[1]})};
        RC_ASSERT(image(any.language, sets) == image(any.language, longer));
        RC_ASSERT(image(inverse_image(any.language, h, {0, 1}), h) ==
                  intersected(any.language, image(all_words({0, 1}), h)));
    });
    CHECK(holds);
}

TEST_CASE("a substitution replaces every letter on its own") {
    const RegularLanguage words =
        image(finite_set({{0, 0}}), std::vector<RegularLanguage>{finite_set({{1}, {1, 1}})});
    CHECK(words == finite_set({{1, 1}, {1, 1, 1}, {1, 1, 1, 1}}));
    CHECK(image(finite_set({{0, 1}}), std::vector<RegularLanguage>{
                                          all_words({0}), RegularLanguage()}) == RegularLanguage());
    CHECK(image(all_words({0}), std::vector<Word>{{}}) == finite_set({{}}));
}

TEST_CASE("a letter without an image is an error") {
    CHECK_THROWS_WITH_AS(image(finite_set({{1}}), std::vector<Word>{{0}}),
                         "letter number 1 has no image", Error);
    CHECK_THROWS_WITH_AS(inverse_image(finite_set({{1}}), {{0}}, {0, 1}),
                         "letter number 1 has no image", Error);
    CHECK(image(finite_set({{0}}), std::vector<Word>{{0}}) == finite_set({{0}}));
}
