// Gives what once broke something, and the texts of the repository, to all targets of the fuzzer (tools/fuzz).

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <random>
#include <set>
#include <sstream>

#include "fuzz/targets.hpp"
#include "places.hpp"

using namespace algae;
namespace fs = std::filesystem;

namespace {

/// Far more than any input takes; a hang is longer.
constexpr std::chrono::seconds longest{10};

void survives(const fuzz::Target& target, const std::string& bytes) {
    const auto begin = std::chrono::steady_clock::now();
    CHECK_NOTHROW(fuzz::run(target, bytes));
    CHECK(std::chrono::steady_clock::now() - begin < longest);
}

/// An input that nobody wrote: seeds that are cut, joined and changed, with words of the dictionary put in. The same from a generator in
/// the same state.
std::string changed(const fuzz::Target& target, const fuzz::Texts& seeds, const fuzz::Texts& words,
                    std::mt19937_64& random) {
    const auto below = [&](std::size_t count) {
        return static_cast<std::size_t>(random() % count);
    };
    std::string text = seeds[below(seeds.size())];
    for (std::size_t times = 1 + below(4); times > 0; --times) {
        const std::size_t at = below(text.size() + 1), length = below(text.size() - at + 1);
        switch (below(7)) {
            case 0:
                text.erase(at, std::min<std::size_t>(length, 16));
                break;
            case 1:
                text.insert(at, 1, static_cast<char>(random()));
                break;
            case 2:
                if (at < text.size()) text[at] = static_cast<char>(random());
                break;
            case 3:
                text.insert(at, text.substr(at, length));
                break;
            case 4: {
                const std::string& other = seeds[below(seeds.size())];
                text = text.substr(0, at) + other.substr(below(other.size() + 1));
                break;
            }
            case 5:
                if (at < text.size()) text[at] = static_cast<char>(text[at] ^ 1 << below(8));
                break;
            default:
                if (!words.empty()) text.insert(at, words[below(words.size())]);
        }
    }
    text.resize(std::min(text.size(), target.longest));
    return text;
}

/// A number in the environment.
double number_of(const char* variable, double otherwise) {
    const char* const text = std::getenv(variable);
    return text ? std::atof(text) : otherwise;
}

/// Keeps the input that is given now in a file that is there after a crash: FUZZ_LAST, if the environment names one.
class LastInput {
public:
    LastInput() {
        const char* const path = std::getenv("FUZZ_LAST");
        if (!path) return;
        file_ = open(path, O_RDWR | O_CREAT | O_TRUNC, 0666);
        REQUIRE(file_ >= 0);
        REQUIRE(ftruncate(file_, most) == 0);
        void* const memory = mmap(nullptr, most, PROT_READ | PROT_WRITE, MAP_SHARED, file_, 0);
        REQUIRE(memory != MAP_FAILED);
        bytes_ = static_cast<char*>(memory);
    }
    ~LastInput() {
        if (!bytes_) return;
        munmap(bytes_, most);
        close(file_);
        unlink(std::getenv("FUZZ_LAST"));
    }
    LastInput(const LastInput&) = delete;
    LastInput& operator=(const LastInput&) = delete;

    /// The name of the target, the length of the input and a line break stand before it.
    void keep(const std::string& target, const std::string& text) {
        if (!bytes_) return;
        const std::string head = target + ' ' + std::to_string(text.size()) + '\n';
        std::copy(head.begin(), head.end(), bytes_);
        std::copy_n(text.begin(), std::min(text.size(), most - head.size()), bytes_ + head.size());
    }

private:
    static constexpr std::size_t most = 1 << 16;
    int file_ = -1;
    char* bytes_ = nullptr;
};

}  // namespace

TEST_CASE("changed texts of the repository break nothing") {
    // FUZZ_SECONDS: so long for each target, with other inputs each time; FUZZ_COUNT: so many inputs instead; FUZZ_PART=0 and 1: every
    // second target, for two processes; FUZZ_TARGET: only this one; FUZZ_START: where the random numbers begin.
    const double seconds = number_of("FUZZ_SECONDS", 0), asked = number_of("FUZZ_COUNT", 0);
    const auto few = static_cast<std::size_t>(asked > 0 ? asked : 60);
    const auto part = static_cast<std::size_t>(number_of("FUZZ_PART", 2));
    const auto start = static_cast<std::uint64_t>(
        number_of("FUZZ_START", seconds > 0 || asked > 0 ? std::random_device()() : 1));
    const char* const only = std::getenv("FUZZ_TARGET");
    std::size_t all = 0, number = 0;
    LastInput last;
    for (const fuzz::Target& target : fuzz::targets()) {
        if (part < 2 && number++ % 2 != part) continue;
        if (only && target.name != only) continue;
        CAPTURE(target.name);
        CAPTURE(start);
        const auto seeds = fuzz::seeds(target), words = fuzz::dictionary(target);
        REQUIRE(seeds.size() > 0);
        std::mt19937_64 random(start);
        const std::clock_t begin = std::clock();  // of the processor, as others may use it too
        const auto time = [&] {
            return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
        };
        std::size_t count = 0;
        for (; seconds > 0 ? time() < seconds : count < few; ++count) {
            const std::string text = changed(target, seeds, words, random);
            last.keep(target.name, text);
            try {
                fuzz::run(target, text);
            } catch (const std::exception& error) {
                CAPTURE(text);
                FAIL_CHECK(std::string(error.what()));
                break;
            }
        }
        all += count;
        if (seconds > 0 || asked > 0)
            std::printf("%-16s %10zu %8.0f/s\n", target.name.c_str(), count,
                        static_cast<double>(count) / time());
        std::fflush(stdout);
    }
    if (seconds > 0 || asked > 0) std::printf("%zu executions\n", all);
    CHECK(all >= few * (only ? 1 : fuzz::targets().size() / 3));
}

TEST_CASE("what once broke something breaks nothing") {
    const fs::path kept = fs::path(source_folder()) / "tests/fuzz/kept";
    if (!fs::exists(kept)) return;
    for (const auto& entry : fs::recursive_directory_iterator(kept)) {
        if (!entry.is_regular_file()) continue;
        CAPTURE(entry.path().string());
        const auto* target = fuzz::target(entry.path().parent_path().filename().string());
        REQUIRE(target != nullptr);
        std::ifstream file(entry.path(), std::ios::binary);
        std::ostringstream bytes;
        bytes << file.rdbuf();
        survives(*target, bytes.str());
    }
}

TEST_CASE("texts of the repository break nothing, nor do they without their second half") {
    constexpr std::size_t most = 40;  // of a target: all of them take a minute
    for (const fuzz::Target& target : fuzz::targets()) {
        CAPTURE(target.name);
        const auto seeds = fuzz::seeds(target);
        CHECK(seeds.size() > 0);
        for (std::size_t i = 0; i < std::min(most, seeds.size()); ++i) {
            const std::string& seed = seeds[i * seeds.size() / std::min(most, seeds.size())];
            CAPTURE(seed);
            survives(target, seed);
            survives(target, seed.substr(0, seed.size() / 2));
        }
    }
}

TEST_CASE("each target has a name of its own, and seeds and words to write inputs with") {
    std::set<std::string> names;
    for (const fuzz::Target& target : fuzz::targets()) {
        CAPTURE(target.name);
        CHECK(names.insert(target.name).second);
        CHECK(fuzz::target(target.name) == &target);
    }
    CHECK(fuzz::target("no such target") == nullptr);
    const auto words = fuzz::dictionary(*fuzz::target("lsystem"));
    CHECK(std::ranges::find(words, "axiom") != words.end());
}

TEST_CASE("what is no error of algae comes out of a target") {
    const auto throwing = [](auto error) {
        return fuzz::Target{"x", "", [error](std::string_view) { throw error; }, {}};
    };
    CHECK_NOTHROW(fuzz::run(throwing(Error("no")), ""));
    CHECK_NOTHROW(fuzz::run(throwing(BoundReached(Bound::time, "no")), ""));
    CHECK_THROWS_AS(fuzz::run(throwing(fuzz::Broken("no")), ""), fuzz::Broken);
    CHECK_THROWS_AS(fuzz::run(throwing(std::out_of_range("no")), ""), std::out_of_range);
    CHECK_THROWS_AS(fuzz::run(throwing(Diagnostics({{{"x", 1, 1}, "", "", 0}})), ""), fuzz::Broken);
}
