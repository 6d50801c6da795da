#include <doctest/doctest.h>

#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "house/files.hpp"

using namespace algae::house;

namespace {

struct Layers {
    std::vector<std::string> order;                      // from the ground up
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
    std::string room;  // of the file that includes
    std::string what;  // as written, without quotes
    bool own = false;  // "..." rather than <...>
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
    {R"((flint/|gmp|arb|acb|arf|mag|fmp[zqr]).*)", R"(src/exact/.*|src/command/memory\.cpp)"},
    {R"(cairo.*|pango.*|graphviz/.*)", R"(src/render/.*)"},
    {R"(boost/(spirit|fusion|phoenix)/?.*)", R"(src/notation/(.*\.cpp|detail/grammar\.hpp))"},
    {R"(CLI/.*)", R"(src/command/.*\.cpp)"},
    {R"(httplib\.h)", R"(src/studio/server\.cpp)"},
    {R"(fmt/.*)", R"(src/.*\.cpp|src/command/.*)"},  // other projects' compilers never see fmt
};

}  // namespace

TEST_CASE("rooms stand above those they include") {
    const Layers all = layers();
    std::set<std::string> lower;
    for (const std::string& room : all.order) {
        const auto found = all.below.find(room);
        if (found != all.below.end())
            for (const std::string& other : found->second)
                CHECK_MESSAGE(lower.contains(other),
                              room << " may include " << other << ", which is not below it");
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
        if (!include.own || include.file == "src/algae.hpp") continue;
        INFO(place(include));
        const std::string other = include.what.substr(0, include.what.find('/'));
        CHECK(fs::is_regular_file(root() / "src" / include.what));
        const auto below = all.below.find(include.room);
        CHECK(
            (other == include.room || (below != all.below.end() && below->second.contains(other))));
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
        if (include.what != "notation/detail/grammar.hpp") continue;
        INFO(place(include));
        CHECK(include.file.extension() == ".cpp");
    }
}

TEST_CASE("only faces cross rooms") {
    for (const Include& include : includes("src")) {
        if (!include.own) continue;
        INFO(place(include));
        const std::string other = include.what.substr(0, include.what.find('/'));
        if (other != include.room) CHECK(include.what == other + '/' + other + ".hpp");
    }
}

TEST_CASE("a test sees the faces and what is private to its own room") {
    for (const Include& include : includes("tests")) {
        if (!include.own || include.what.find("/detail/") == std::string::npos) continue;
        if (include.room == "laws") continue;  // they hold for every model, private ones too
        if (include.room == "verbs" && include.what.starts_with("command/")) continue;  // runs it
        INFO(place(include));
        CHECK(include.what.substr(0, include.what.find('/')) == include.room);
    }
}

TEST_CASE("a room is its face, its sources, and detail/ for the headers that they share") {
    for (const fs::path& file : files("src", {".hpp", ".cpp"})) {
        INFO(file.string());
        const std::vector<std::string> parts(file.begin(), file.end());
        if (parts.size() == 2) {
            CHECK(file == "src/algae.hpp");  // includes the faces that most programs need
        } else if (parts.size() == 3) {
            CHECK((file.extension() == ".cpp" || parts[2] == parts[1] + ".hpp"));
        } else {
            CHECK(parts.size() == 4);
            CHECK(parts[2] == "detail");
            CHECK(file.extension() == ".hpp");
        }
    }
}

TEST_CASE("a private header has several users") {
    std::map<std::string, std::set<std::string>> users;
    for (const char* folder : {"src", "tests"})
        for (const Include& include : includes(folder))
            if (include.own && include.what.find("/detail/") != std::string::npos)
                users[include.what].insert(include.file.string());
    for (const fs::path& file : files("src", {".hpp"})) {
        const std::string header = file.string().substr(4);
        if (header.find("/detail/") == std::string::npos) continue;
        INFO(header);
        const std::string room = header.substr(0, header.find('/'));
        const bool is_for_template = users[header].contains("src/" + room + "/" + room + ".hpp");
        CHECK((users[header].size() >= 2 || is_for_template));
    }
}

TEST_CASE("files are subjects and folders can be looked over") {
    std::map<fs::path, std::size_t> in_folder;
    std::size_t count = 0, length = 0;
    for (const fs::path& file : files("src", {".hpp", ".cpp"})) {
        ++count;
        ++in_folder[file.parent_path()];
        length += lines(file).size();
    }
    CHECK(length >= 150 * count);  // on average
    for (const auto& [folder, number] : in_folder) {
        INFO(folder.string());
        CHECK(number <= 40);
    }
    CHECK(layers().order.size() <=
          23);  // 18 at the redesign, combinatorics, automatic, studio, python, watch
}

TEST_CASE("string streams throw where memory ends") {
    // Without this they swallow std::bad_alloc, and a text that is cut by getline seems to end.
    const std::regex stream(R"(std::[io]?stringstream (\w+)\b)");
    std::size_t looked_at = 0;
    for (const fs::path& file : files("src", {".hpp", ".cpp"})) {
        if (file.string().starts_with("src/python/")) continue;
        const std::vector<std::string> all = lines(file);
        for (std::size_t i = 0; i + 1 < all.size(); ++i) {
            std::smatch found;
            if (!std::regex_search(all[i], found, stream)) continue;
            INFO(file.string() << ": " << all[i]);
            CHECK(all[i + 1].find(found[1].str() + ".exceptions(std::ios::badbit);") !=
                  std::string::npos);
            ++looked_at;
        }
    }
    CHECK(looked_at > 5);
}

TEST_CASE("the slow second routes never call what derives") {
    const std::regex call(
        R"(\b(fold|tower|derive|derive_text|derived_text|letters_at|next_tree|derived_tree|Development)\b *[({<])");
    std::size_t looked_at = 0;
    for (const fs::path& file : files("tests/oracle", {".hpp", ".cpp"}))
        for (const std::string& line : lines(file)) {
            INFO(file.string() << ": " << line);
            CHECK(!std::regex_search(line, call));
            ++looked_at;
        }
    CHECK(looked_at > 1000);
}
