// --let on every verb that takes a system, by the table of verbs: a new verb is asked too.

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>

#include "command/detail/files.hpp"
#include "command/detail/verb.hpp"
#include "verbs/in_process.hpp"

namespace {

using namespace algae;
using in_process::Ran;
using in_process::run;

const std::string system_with_constant =
    "let k = 60; axiom F; F -> F+F--F+F; angle k; generation 2";

/// What a verb needs beside its systems.
const std::map<std::string, std::vector<std::string>>& beside() {
    static const std::map<std::string, std::vector<std::string>> all{
        {"show", {}},
        {"fmt", {}},
        {"derive", {"-n", "1"}},
        {"letter", {"-n", "1", "--at", "0"}},
        {"growth", {"-n", "2"}},
        {"words", {"--to", "3"}},
        {"member", {"F+F--F+F"}},
        {"finite", {}},
        {"equal", {}},
        {"draw", {"-n", "1", "-o", "OUT"}},
        {"dimension", {"-n", "6"}},
        {"tree", {"-n", "1", "-o", "OUT"}},
        {"convert", {"--to", "l"}}};
    return all;
}

/// A folder for the files of one test.
class Folder {
public:
    Folder() {
        std::string pattern =
            (std::filesystem::temp_directory_path() / "algae-let-XXXXXX").string();
        REQUIRE(mkdtemp(pattern.data()));
        path_ = pattern;
    }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

bool takes_systems(const command::Option& argument) { return argument.type == command::file_type; }

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("--let sets constants on every verb that takes a system") {
    const Folder scratch;
    command::Verbs verbs;
    command::add_verbs(verbs);
    std::size_t tried = 0;
    for (const command::Verb& verb : verbs.all) {
        if (verb.names_generators()) continue;  // their FILE is no system
        const auto systems = std::ranges::count_if(verb.arguments, takes_systems);
        if (systems == 0) continue;
        CAPTURE(verb.name);
        REQUIRE(beside().contains(verb.name));  // what else must this verb be given?
        std::vector<std::string> words{verb.name};
        words.insert(words.end(), static_cast<std::size_t>(systems), system_with_constant);
        for (const std::string& word : beside().at(verb.name))
            words.push_back(word == "OUT" ? (scratch.path() / (verb.name + ".svg")).string()
                                          : word);
        const auto with = [&](const std::string& let) {
            std::vector<std::string> all = words;
            all.insert(all.end(), {"--let", let});
            return run(all, scratch.path());
        };
        const Ran known = with("k=90");
        CHECK_MESSAGE(known.status != command::bad_input, known.err);  // any answer will do
        const Ran unknown = with("q=90");
        CHECK(unknown.status == command::bad_input);
        CHECK_MESSAGE(holds(unknown.err, "has no constant 'q'; it has k"), unknown.err);
        ++tried;
    }
    CHECK(tried == beside().size());
}

TEST_CASE("the dimension of a figure is that of the constant of --let") {
    const Folder scratch;
    const auto exact = [&](const std::string& let) {
        return run({"dimension", "let k = 60; axiom F; F -> F+F--F+F; angle k", "-n", "6", "--let",
                    let},
                   scratch.path())
            .out;
    };
    CHECK(holds(exact("k=60"), "log 4 / log 3"));
    CHECK(!holds(exact("k=80"), "log 4 / log 3"));
}

TEST_CASE("--let beside what is no system is refused") {
    const Folder scratch;
    const auto said = [&](const std::vector<std::string>& words) {
        const Ran all = run(words, scratch.path());
        CHECK(all.status == command::bad_input);
        return all.err;
    };
    CHECK(
        holds(said({"words", "abaab", "--let", "k=1"}), "--let is for the constants of a system"));
    CHECK(holds(said({"dimension", "fern.ifs", "--let", "k=1"}), "--let is for systems"));
    CHECK(holds(said({"dimension", "--table", "--let", "k=1"}), "--let is for one system"));
    CHECK(holds(said({"draw", "fern.ifs", "--let", "k=1", "-o", "x.svg"}),
                "--let is for systems, and fern.ifs is not one of them"));
}
