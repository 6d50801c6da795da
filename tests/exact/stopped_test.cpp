#include "exact/exact.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <fstream>
#include <type_traits>
#include <vector>

using namespace algae;

TEST_CASE("a stop is no error and an error is no stop") {
    CHECK(!std::is_base_of_v<Error, Stopped>);
    CHECK(!std::is_base_of_v<Stopped, Error>);
    CHECK(!std::is_base_of_v<std::runtime_error, Stopped>);
    CHECK(std::is_base_of_v<Stopped, BoundReached>);
    CHECK(std::is_base_of_v<Stopped, Interrupted>);
    CHECK(std::is_nothrow_copy_constructible_v<BoundReached>);
}

TEST_CASE("a bound that is reached says which, and how far the work came") {
    const BoundReached plain(Bound::letters, "too many letters");
    CHECK(plain.bound() == Bound::letters);
    CHECK(std::string(plain.what()) == "too many letters");
    CHECK(std::string(plain.came()).empty());
    const BoundReached far(Bound::memory, "too many words", "generations 0 to 7 are the same");
    CHECK(std::string(far.what()) == "too many words; undecided: generations 0 to 7 are the same");
    CHECK(std::string(far.came()) == "generations 0 to 7 are the same");
}

TEST_CASE("a budget names its bounds as those call them who set them") {
    constexpr BoundNames names{"the page", "the pool", nullptr};
    Budget budget;
    CHECK(budget.by(Bound::memory).empty());
    budget.memory = 1 << 20;
    budget.names = &names;
    CHECK(budget.by(Bound::letters) == " by the page");
    CHECK(budget.by(Bound::time).empty());
    CHECK(budget.by(Bound::method).empty());
    CHECK_THROWS_WITH_AS(budget.check_memory((1 << 20) + 1, "a table"),
                         "a table would take more than the 1 MiB allowed by the pool",
                         BoundReached);
    budget.deadline = std::chrono::steady_clock::now() - std::chrono::seconds(1);
    CHECK_THROWS_WITH_AS(budget.check(), "the time allowed is over", BoundReached);
}

TEST_CASE("what is called at each check may stop the work") {
    int checks = 0;
    const std::function<void()> third = [&] {
        if (++checks == 3) throw Interrupted();
    };
    Budget budget;
    budget.at_check = &third;
    budget.check();
    budget.check();
    CHECK_THROWS_AS(budget.check(), Interrupted);
}

TEST_CASE("all parts are done, where threads can be made and where none can") {
    // WebAssembly has none: tools/engine --tests runs this too.
    std::atomic<int> done = 0;
    each_part(1000, 4, {}, [&]() -> PartWorker { return [&](std::size_t) { ++done; }; });
    CHECK(done == 1000);
}

TEST_CASE("a stop of one part, or of making a worker, stops all parts whatever the threads") {
    for (const unsigned threads : {1u, 4u}) {
        CAPTURE(threads);
        std::atomic<int> done = 0;
        const PartWorker work = [&](std::size_t part) {
            if (part == 40) throw BoundReached(Bound::letters, "too many");
            ++done;
        };
        CHECK_THROWS_WITH_AS(each_part(1'000'000, threads, {}, [&] { return work; }), "too many",
                             BoundReached);
        CHECK(done < 1'000'000);
        const auto no_worker = []() -> PartWorker { throw Interrupted(); };
        CHECK_THROWS_AS(each_part(1000, threads, {}, no_worker), Interrupted);
    }
}

TEST_CASE("threads that have ended keep nothing of the numbers they worked with") {
    const auto resident = [] {  // MiB
        std::size_t whole = 0, pages = 0;
        std::ifstream("/proc/self/statm") >> whole >> pages;
        return pages >> 8;
    };
    const auto work = [] {
        return [](std::size_t) { const std::vector<Integer> large(100, power(Integer(3), 500)); };
    };
    const auto rounds = [&](int count) {
        for (int i = 0; i < count; ++i)
            each_part(64, 4, {}, [&]() -> PartWorker { return work(); });
    };
    rounds(100);
    const std::size_t before = resident();
    rounds(4000);
    const std::size_t after = resident();
    CAPTURE(before);
    CAPTURE(after);
    CHECK(after < before + 400);  // sanitizers keep 256 MiB of what is given back
}
