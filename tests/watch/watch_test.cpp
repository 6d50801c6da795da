#include "watch/watch.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <string>
#include <thread>

using namespace algae;

TEST_CASE(
    "a watch says where the work of its thread is, from the outermost count to the innermost") {
    const WorkWatch watch;
    CHECK(watch.where().empty());
    WorkCount cells("cell", 40);
    cells.at(7, "0L, union");
    CHECK(watch.where() == "cell 7 of 40 (0L, union)");
    {
        WorkCount generations("generation", 12);
        ++generations;
        ++generations;
        CHECK(watch.where() == "cell 7 of 40 (0L, union), generation 2 of 12");
        WorkCount modules("modules");
        modules.at(1'234'567);
        CHECK(watch.where() == "cell 7 of 40 (0L, union), generation 2 of 12, modules 1,234,567");
        const WorkCount letters("letters");
        const WorkCount not_shown("steps");
        CHECK(watch.where() ==
              "cell 7 of 40 (0L, union), generation 2 of 12, modules 1,234,567, letters 0");
    }
    cells.at(8);
    CHECK(watch.where() == "cell 8 of 40 (0L, union)");
}

TEST_CASE("numbers are written in groups of three digits") {
    const WorkWatch watch;
    WorkCount points("points", 100'000);
    for (const auto& [number, text] :
         {std::pair{0, "points 0 of 100,000"}, std::pair{999, "points 999 of 100,000"},
          std::pair{1000, "points 1,000 of 100,000"},
          std::pair{99'999, "points 99,999 of 100,000"}}) {
        points.at(static_cast<std::uint64_t>(number));
        CHECK(watch.where() == text);
    }
}

TEST_CASE("a watch sees nothing of other threads and of other watches") {
    const WorkWatch watch;
    const WorkCount outer("cell", 2);
    std::string of_thread = "?", of_inner;
    std::thread([&] {
        const WorkCount unwatched("step");
        const WorkWatch own;
        of_thread = own.where();
        const WorkCount seen("step");
        of_inner = own.where();
    }).join();
    CHECK(of_thread.empty());
    CHECK(of_inner == "step 0");
    CHECK(watch.where() == "cell 0 of 2");
    {
        const WorkWatch inner;
        const WorkCount steps("step");
        CHECK(inner.where() == "step 0");
        CHECK(watch.where() == "cell 0 of 2");
    }
    const WorkCount later("step");
    CHECK(watch.where() == "cell 0 of 2, step 0");
}

TEST_CASE("a watch may be asked at any time, by any thread") {
    std::atomic<bool> over = false;
    std::size_t found = 0;
    const WorkWatch watch;
    std::thread asking([&] {
        while (!over) found += watch.where().empty() ? 0 : 1;
    });
    std::size_t counted = 0;
    while (counted < 2'000) {
        WorkCount cells("cell", 2'000);
        cells.at(counted, std::string(1 + counted % 90, 'x'));
        const WorkCount words("words");
        if (++counted == 2'000)
            while (watch.where().empty()) continue;
        std::this_thread::yield();
    }
    over = true;
    asking.join();
    CHECK(counted == 2'000);
    MESSAGE("asked with an answer: " << found);
}
