#include <doctest/doctest.h>

#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "house/files.hpp"

using namespace algae::house;

namespace {

struct Layers {
    std::vector<std::string> order;                     // from the ground up
    std::map<std::string, std::set<std::string>> below;  // what each room may include
};

Layers layers() {
    Layers all;
    for (const std::string& line : lines("src/layers.txt")) {
        std::istringstream words(line);
        std::string room;
        if (!(words >> room) || room[0] == '#') continue;
        all.order.push_back(room);
        for (std::string other; words >> other;) all.below[room].insert(other);
    }
    return all;
}

struct Include {
    fs::path file;
    std::size_t line;
    std::string room;   // of the file that includes
    std::string what;   // as written, without quotes
    bool own = false;   // "..." rather than <...>
};

std::vector<Include> includes(const std::string& folder) {
    static const std::regex pattern(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"].*)");
    std::vector<Include> all;
    for (const fs::path& file : files(folder, {".hpp", ".cpp"})) {
        const std::string room = *std::next(file.begin());
        std::size_t number = 0;
        for (const std::string& line : lines(file)) {
            ++number;
            std::smatch part;
            if (std::regex_match(line, part, pattern))
                all.push_back({file, number, room, part[2], part[1] == "\""});
        }
    }
    return all;
}

std::string place(const Include& include) {
    return include.file.string() + ":" + std::to_string(include.line) + " includes " + include.what;
}

/// The outside libraries that enter by one door: how their headers begin, and who may include them.
struct Door {
    const char* headers;
    const char* files;
};
const Door doors[] = {
    {R"((flint/|gmp|arb|acb|arf|mag|fmp[zqr]).*)", R"(src/exact/.*)"},
    {R"(cairo.*|pango.*|graphviz/.*)", R"(src/render/.*)"},
    {R"(boost/(spirit|fusion|phoenix)/?.*)", R"(src/notation/(.*\.cpp|grammar\.hpp))"},
    {R"(CLI/.*)", R"(src/cli/.*)"},
    {R"(fmt/.*)", R"(src/.*\.cpp|src/cli/.*)"},  // other projects' compilers never see fmt
};

}  // namespace

TEST_CASE("rooms stand above those they include") {
    const Layers all = layers();
    std::set<std::string> lower;
    for (const std::string& room : all.order) {
        const auto found = all.below.find(room);
        if (found != all.below.end())
            for (const std::string& other : found->second)
                CHECK_MESSAGE(lower.contains(other), room << " may include " << other << ", which is not below it");
        CHECK_MESSAGE(lower.insert(room).second, room << " stands in src/layers.txt twice");
    }
    for (const auto& entry : fs::directory_iterator(root() / "src"))
        if (entry.is_directory()) {
            const std::string room = entry.path().filename();
            CHECK_MESSAGE(lower.contains(room), "src/" << room << " is missing in src/layers.txt");
        }
}

TEST_CASE("a room includes only the rooms named for it") {
    const Layers all = layers();
    for (const Include& include : includes("src")) {
        if (!include.own) continue;
        INFO(place(include));
        const std::string other = include.what.substr(0, include.what.find('/'));
        CHECK(fs::is_regular_file(root() / "src" / include.what));
        const auto below = all.below.find(include.room);
        CHECK((other == include.room || (below != all.below.end() && below->second.contains(other))));
    }
}

TEST_CASE("outside libraries enter by one door") {
    for (const Include& include : includes("src")) {
        if (include.own) continue;
        INFO(place(include));
        for (const Door& door : doors)
            if (std::regex_match(include.what, std::regex(door.headers)))
                CHECK(std::regex_match(include.file.string(), std::regex(door.files)));
    }
}

TEST_CASE("what the grammars share is for their sources only") {
    for (const Include& include : includes("src")) {
        if (include.what != "notation/grammar.hpp") continue;
        INFO(place(include));
        CHECK(include.file.extension() == ".cpp");
    }
}

TEST_CASE("the slow second routes never include fold") {
    for (const Include& include : includes("tests")) {
        if (include.room != "oracle") continue;
        INFO(place(include));
        CHECK(!include.what.starts_with("fold/"));
    }
}
