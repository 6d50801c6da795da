// A short run of tools/attack.

#include "language/attack.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

using namespace algae;

TEST_CASE("decisions about random systems agree with what is worked out by other means") {
    constexpr std::uint64_t together = 20, every = 20;
    attack::Counts counts;
    CHECK(rc::check([&] {
        const auto first =
            *rc::gen::resize(100, rc::gen::inRange<std::uint64_t>(0, 1'000'000'000'000));
        for (std::uint64_t i = 0; i < together; ++i) {
            attack::run_case(first + i, every, counts);
            for (const std::string& defect : counts.defects) RC_FAIL(defect);
        }
    }));
    std::string shares;
    for (const auto& [kind, count] : counts.by_kind)
        shares +=
            ' ' + kind + ' ' + std::to_string(count.comparable) + '/' + std::to_string(count.asked);
    MESSAGE(counts.all.comparable << " of " << counts.all.asked << " comparable, " << counts.checked
                                  << " of " << counts.verified
                                  << " certificates checked:" << shares);
    CHECK(counts.all.agreeing == counts.all.comparable);
    CHECK(counts.all.comparable * 100 >= counts.all.asked * 88);
    CHECK(counts.by_family.size() == attack::families.size());
    CHECK(counts.checked * 100 >= counts.verified * 80);
}
