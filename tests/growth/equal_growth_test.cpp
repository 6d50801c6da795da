#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "growth/counted.hpp"
#include "growth/growth.hpp"

using namespace algae;

TEST_CASE("growth equivalence agrees with many more lengths than the bound asks for") {
    CHECK(rc::check([] {
        const D0L left = any_small_system(), right = any_small_system();
        const GrowthComparison found = equal_growth(left, right);
        const auto a = counted_lengths(left, 100), b = counted_lengths(right, 100);
        RC_ASSERT(found.bound == left.letters.size() + right.letters.size());
        RC_ASSERT(found.equal == (a == b));
        RC_ASSERT(found.equal == !found.difference);
        if (found.equal) return;
        std::size_t n = 0;
        while (a[n] == b[n]) ++n;
        RC_ASSERT(found.difference->generation == n);
        RC_ASSERT(found.difference->left == a[n]);
        RC_ASSERT(found.difference->right == b[n]);
    }));
}

TEST_CASE("turning all words round does not change how they grow") {
    CHECK(rc::check([] {
        const D0L system = any_small_system();
        std::vector<Word> images = system.rules.images();
        for (Word& image : images) std::reverse(image.begin(), image.end());
        RC_ASSERT(
            equal_growth(system, make_d0l(system.alphabet, system.axiom, std::move(images))).equal);
    }));
}

TEST_CASE("a filament of anabaena grows like the fibonacci word") {
    const D0L fibonacci = d0l("a", {{'a', "ab"}, {'b', "a"}});
    const D0L anabaena = d0l("A", {{'A', "aB"}, {'a', "bA"}, {'B', "A"}, {'b', "a"}});
    const GrowthComparison found = equal_growth(fibonacci, anabaena);
    CHECK(found.equal);
    CHECK(found.bound == 6);
}

TEST_CASE("systems that differ only at the last length the bound asks for") {
    // A chain of n letters that dies against one that dies a step later.
    const D0L three = d0l("a", {{'a', "b"}, {'b', "c"}, {'c', ""}});
    const D0L four = d0l("a", {{'a', "b"}, {'b', "c"}, {'c', "d"}, {'d', ""}});
    CHECK(equal_growth(three, four).difference->generation == 3);
    CHECK(equal_growth(three, three).equal);
    CHECK(equal_growth(d0l("", {{'a', "a"}}), d0l("", {{'a', "a"}})).bound == 0);
}
