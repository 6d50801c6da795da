// The main program of tests whose room holds mutants; tools/mutants builds and runs it.
//
//     PROGRAM cover FILE           runs all tests; for each a line: CPU seconds, name, the mutants that were reached;
//                                the first line, without a name, has those that are reached before
//     PROGRAM kill TEST:SECONDS...  runs these tests, counted from 0, until one fails, which is named, or takes more of the processor
//
// The mutant of ALGAE_MUTANT is switched on before constants are initialised, so there is a process for each.

#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <sys/time.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace mutants {

constexpr std::size_t most = 100'000;
bool reached[most];
std::size_t chosen = most;

[[gnu::constructor(101)]] void choose() {
    if (const char* const number = std::getenv("ALGAE_MUTANT"))
        chosen = static_cast<std::size_t>(std::atoll(number));
}

bool is_on(unsigned number) {
    reached[number] = true;
    return number == chosen;
}

namespace {

std::ofstream coverage;

/// Writes what each test reached.
struct Cover : doctest::IReporter {
    std::string name;
    std::clock_t begin = 0;

    explicit Cover(const doctest::ContextOptions&) {}
    void write(double seconds) {
        if (!coverage.is_open()) return;
        coverage << seconds << '\t' << name << '\t';
        for (std::size_t i = 0; i < most; ++i)
            if (reached[i]) coverage << i << ' ';
        coverage << '\n';
        std::fill(std::begin(reached), std::end(reached), false);
    }
    void report_query(const doctest::QueryData&) override {}
    void test_run_start() override { write(0); }
    void test_run_end(const doctest::TestRunStats&) override {}
    void test_case_start(const doctest::TestCaseData& test) override {
        name = test.m_name;
        begin = std::clock();
    }
    void test_case_reenter(const doctest::TestCaseData&) override {}
    void test_case_end(const doctest::CurrentTestCaseStats&) override {
        write(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    }
    void test_case_exception(const doctest::TestCaseException&) override {}
    void subcase_start(const doctest::SubcaseSignature&) override {}
    void subcase_end() override {}
    void log_assert(const doctest::AssertData&) override {}
    void log_message(const doctest::MessageData&) override {}
    void test_case_skipped(const doctest::TestCaseData&) override {}
};

REGISTER_LISTENER("cover", 1, Cover);

}  // namespace

}  // namespace mutants

/// With ALGAE_QUICK the tests of the suite "long" are left out.
void leave_out_long_ones(doctest::Context& tests) {
    if (std::getenv("ALGAE_QUICK")) tests.setOption("test-suite-exclude", "long");
}

int main(int count, char** words) {
    const std::vector<std::string> given(words, words + count);
    if (given.size() == 3 && given[1] == "cover") {
        mutants::coverage.open(given[2]);
        doctest::Context all;
        leave_out_long_ones(all);
        return all.run();
    }
    for (std::size_t i = 2; i < given.size(); ++i) {
        doctest::Context test;
        const std::size_t colon = given[i].find(':');
        const int number = std::stoi(given[i].substr(0, colon)) + 1;
        const double most = std::stod(given[i].substr(colon + 1));
        itimerval limit{};  // SIGPROF ends the process
        limit.it_value.tv_sec = static_cast<time_t>(most);
        limit.it_value.tv_usec =
            static_cast<suseconds_t>((most - static_cast<double>(limit.it_value.tv_sec)) * 1e6);
        setitimer(ITIMER_PROF, &limit, nullptr);
        leave_out_long_ones(test);
        test.setOption("first", number);
        test.setOption("last", number);
        test.setOption("abort-after", 1);
        if (test.run() != 0) {
            std::cout << "\nnoticed by " << number - 1 << std::endl;
            return 1;
        }
    }
    return 0;
}
