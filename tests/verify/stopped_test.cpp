#include <doctest/doctest.h>

#include <atomic>
#include <chrono>

#include "exact/exact.hpp"
#include "verify/samples.hpp"

using namespace samples;
using Outcome = algae::verify::Finding::Outcome;

namespace {

std::vector<algae::verify::Finding> check_within(const Sample& sample,
                                                 const algae::Budget& budget) {
    return algae::verify::check_certificate(
        *algae::verify::read_certificate(certificate(sample).dump(1), "sample.json"), budget);
}

/// The sound proofs whose check looks at the budget.
std::vector<Sample> that_can_be_stopped() {
    std::vector<Sample> found;
    for (const Sample& sample : sound()) {
        std::atomic<int> checks = 0;
        const std::function<void()> count = [&] { ++checks; };
        algae::Budget budget;
        budget.at_check = &count;
        check_within(sample, budget);
        if (checks > 0) found.push_back(sample);
    }
    return found;
}

bool has(const std::vector<Sample>& samples, const std::string& statement,
         const std::string& proof) {
    for (const Sample& sample : samples)
        if (std::string(sample.statement).starts_with(statement) &&
            std::string(sample.proof).find(proof) != std::string::npos)
            return true;
    return false;
}

}  // namespace

TEST_CASE("Ctrl-C while an inclusion or a size is checked judges nothing") {
    const std::vector<Sample> samples = that_can_be_stopped();
    CHECK(has(samples, R"({"included")", "relations"));
    CHECK(has(samples, R"({"is": "empty")", "relations"));
    const std::atomic<bool> stop = true;
    algae::Budget budget;
    budget.stop = &stop;
    for (const Sample& sample : samples) {
        INFO(sample.statement << " " << sample.verdict << " " << sample.proof);
        CHECK_THROWS_WITH_AS(check_within(sample, budget), "interrupted", algae::Interrupted);
    }
}

TEST_CASE("a check for which the time is over is not done, and says so") {
    algae::Budget budget;
    budget.deadline = std::chrono::steady_clock::now();
    for (const Sample& sample : that_can_be_stopped()) {
        INFO(sample.statement << " " << sample.verdict << " " << sample.proof);
        const auto found = check_within(sample, budget);
        REQUIRE(found.size() == 1);
        CHECK(found[0].outcome == Outcome::not_checked);
        CHECK(found[0].reason == "the time allowed is over");
    }
}
