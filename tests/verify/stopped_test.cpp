#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <functional>

#include "exact/exact.hpp"
#include "verify/samples.hpp"

using namespace samples;
using Outcome = algae::verify::Finding::Outcome;

namespace {

/// What is found of the sample; `at_statement` is called when the statement was read and before it is checked.
std::vector<algae::verify::Finding> check_within(const Sample& sample, const algae::Budget& budget,
                                                 const std::function<void()>& at_statement) {
    const std::string text = certificate(sample).dump(1);
    std::vector<algae::verify::Finding> all;
    algae::verify::check_certificate(
        algae::verify::source_of(text), "sample.json", budget,
        {.on_statement = [&](const algae::verify::Field&) { at_statement(); },
         .on_finding = [&](const algae::verify::Finding& found) { all.push_back(found); }});
    return all;
}

/// The sound proofs whose check looks at the budget.
std::vector<Sample> that_can_be_stopped() {
    std::vector<Sample> found;
    for (const Sample& sample : sound()) {
        // How often the budget was looked at so far, with and without the check.
        std::atomic<int> checks = 0;
        int before = 0, after = 0;
        const std::function<void()> count = [&] { ++checks; };
        algae::Budget budget;
        budget.at_check = &count;
        const std::string text = certificate(sample).dump(1);
        algae::verify::check_certificate(
            algae::verify::source_of(text), "sample.json", budget,
            {.on_statement = [&](const algae::verify::Field&) { before = checks; },
             .on_finding = [&](const algae::verify::Finding&) { after = checks; }});
        if (after > before) found.push_back(sample);
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
    std::atomic<bool> stop = false;
    algae::Budget budget;
    budget.stop = &stop;
    for (const Sample& sample : samples) {
        stop = false;
        INFO(sample.statement << " " << sample.verdict << " " << sample.proof);
        CHECK_THROWS_WITH_AS(check_within(sample, budget, [&] { stop = true; }), "interrupted",
                             algae::Interrupted);
    }
}

TEST_CASE("a check for which the time is over is not done, and says so") {
    algae::Budget budget;
    budget.deadline = std::chrono::steady_clock::now();
    for (const Sample& sample : that_can_be_stopped()) {
        INFO(sample.statement << " " << sample.verdict << " " << sample.proof);
        const auto found = check_within(sample, budget, [] {});
        REQUIRE(found.size() == 1);
        CHECK(found[0].outcome == Outcome::not_checked);
        CHECK(found[0].reason == "the time allowed is over");
    }
}
