// The words of the systems in figures/ and systems/ against words that were worked out without algae.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "model/model.hpp"
#include "notation/notation.hpp"
#include "places.hpp"
#include "system/system.hpp"

using namespace algae;

namespace {

struct Line {
    std::string name, kind;
    std::uint64_t generation = 0;
    std::string value;
};

std::vector<Line> lines() {
    std::ifstream in(source_folder() + "/tests/notation/words.txt");
    std::vector<Line> all;
    for (std::string text; std::getline(in, text);) {
        if (text.starts_with('#')) continue;
        Line line;
        std::istringstream parts(text);
        char colon = 0;
        parts >> line.name >> line.kind >> line.generation >> colon;
        std::getline(parts >> std::ws, line.value);
        all.push_back(line);
    }
    return all;
}

/// The length of a word in symbols and the FNV-1a hash of its text without blanks.
std::string hash(const Model& system, std::uint64_t n) {
    const View<D0L> rules = as_d0l(system);
    REQUIRE_MESSAGE(bool(rules), system.name);
    std::uint64_t value = 0xcbf29ce484222325;
    for (const char c : derived_text(*rules, n))
        if (c != ' ') value = (value ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    std::ostringstream text;
    text << std::hex;
    text.width(16);
    text.fill('0');
    text << value;
    return std::to_string(derive(*rules, n).size()) + " " + text.str();
}

}  // namespace

TEST_CASE("generations 0 to 4 of the systems are those worked out by hand and by another program") {
    std::map<std::string, Model> systems;
    for (const GalleryEntry& entry : gallery())
        systems.emplace(std::string(entry.name),
                        read_lsystem(entry.text, std::string(entry.name) + ".lsys"));
    std::map<std::string, std::set<std::uint64_t>> held;
    for (const Line& line : lines()) {
        CAPTURE(line.name);
        CAPTURE(line.generation);
        REQUIRE(systems.contains(line.name));
        Model& system = systems.at(line.name);
        held[line.name].insert(line.generation);
        if (line.kind == "hash") {
            CHECK(hash(system, line.generation) == line.value);
            continue;
        }
        system.expectations = {{line.kind, line.generation, line.value, {}}};
        for (const Mismatch& unmet : unmet_expectations(system)) FAIL_CHECK(unmet.message);
    }
    CHECK(held.size() >= 120);
    for (const auto& [name, generations] : held)
        CHECK_MESSAGE(generations.size() >= 3, name, " has not generations 0, 1 and 2");
}
