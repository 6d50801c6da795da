// How long verbs may take where --timeout does not say it, by the table of verbs: a new verb is asked too.

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <set>
#include <string>
#include <utility>

#include "command/detail/verb.hpp"
#include "verbs/in_process.hpp"

namespace {

using namespace algae;

/// Verbs that print what they have and search for nothing.
const std::set<std::string> unbounded{"gallery", "manual", "completion"};

/// Restores that work without --timeout has no end.
struct Restored {
    ~Restored() { command::end_questions(false); }
};

}  // namespace

TEST_CASE("every verb ends by itself after a finite time, or its work is long by intent") {
    command::Verbs verbs;
    command::add_verbs(verbs);
    std::size_t questions = 0, others = 0;
    for (const command::Verb& verb : verbs.all) {
        INFO(verb.name);
        const auto option = std::ranges::find(verb.options, "--timeout", &command::Option::name);
        if (option == verb.options.end()) {
            CHECK((unbounded.contains(verb.name) || verb.hidden));
            continue;
        }
        const bool is_long = command::is_long_by_intent(verb.name);
        ++(is_long ? others : questions);
        CHECK(option->help.find(is_long ? "(default none: never)" : "(default 300)") !=
              std::string::npos);
    }
    CHECK(questions >= 15);
    CHECK(others == 16);  // all that are long by intent are verbs
    for (const char* name : {"check", "is", "member", "equal", "finite", "letter", "show", "list",
                             "closure", "words", "growth", "dimension", "verify", "tree", "infer"})
        CHECK_FALSE(command::is_long_by_intent(name));
}

TEST_CASE("a question that is run has an end, other work has none") {
    const Restored restored;
    bool has_deadline = false;
    const std::function<void()> look = [&] {
        has_deadline = command::Bounds().budget().deadline.has_value();
    };
    command::Verbs verbs;
    for (const auto& [name, ends] : {std::pair("show", true), std::pair("draw", false)}) {
        command::Verb& verb = verbs.all.emplace_back();
        verb.name = name;
        verb.run = [&look] {
            look();
            return 0;
        };
        std::string program = "algae", word = name;
        char* words[] = {program.data(), word.data(), nullptr};
        CHECK(verbs.run(2, words) == 0);
        CHECK(has_deadline == ends);
    }
}

TEST_CASE("the time of a question has an end that none lifts") {
    const Restored restored;
    command::Bounds bounds;
    command::end_questions(false);
    CHECK_FALSE(bounds.budget().deadline);
    command::end_questions(true);
    const auto usual = bounds.budget();
    REQUIRE(usual.deadline);
    const auto left = *usual.deadline - std::chrono::steady_clock::now();
    CHECK(left > std::chrono::seconds(290));
    CHECK(left <= std::chrono::seconds(300));
    CHECK(std::string(usual.names->time).find("default 300 seconds") != std::string::npos);
    for (const char* endless : {"0", "none"}) {
        bounds.timeout = command::seconds("--timeout", endless);
        CHECK_FALSE(bounds.budget().deadline);
    }
    bounds.timeout = command::seconds("--timeout", "2.5");
    CHECK(bounds.budget().deadline);
    CHECK(std::string(bounds.budget().names->time) == "--timeout");
    for (const char* wrong : {"", "-1", "nan", "inf", "never", "1s"}) {
        INFO(wrong);
        CHECK_THROWS_WITH_AS(
            command::seconds("--timeout", wrong),
            (std::string("--timeout: expected a positive number of seconds, or none for no end, "
                         "found \"") +
             wrong + '"')
                .c_str(),
            Error);
    }
    // Work in a process that goes on: its deadline is that of the last budget.
    command::end_questions(false);
    CHECK_FALSE(command::Bounds().budget().deadline);
}
