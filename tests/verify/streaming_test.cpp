// Certificates are read statement by statement: in memory that does not grow with their number, past one that is too large,
// and in whatever pieces the text comes.

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "exact/exact.hpp"
#include "verify/samples.hpp"

using namespace samples;
using namespace algae;
using Outcome = verify::Finding::Outcome;

namespace {

/// So many statements, of which the one at `long_one` has a proof with a list of that many words.
std::string many(std::size_t statements, std::optional<std::size_t> long_one = {},
                 std::size_t words = 0) {
    const Json one = certificate(sound()[0]);
    std::string text = one.dump();
    const std::string statement = one["statements"][0].dump();
    text.resize(text.rfind(statement));
    for (std::size_t i = 0; i < statements; ++i) {
        Json written = one["statements"][0];
        if (i == long_one) {
            written["proof"] = Json{{"by", "values"}, {"words", Json::array()}};
            for (std::size_t j = 0; j < words; ++j) written["proof"]["words"].push_back("a b");
        }
        text += (i > 0 ? ",\n" : "\n") + (i == long_one ? written.dump() : statement);
    }
    return text + "]}";
}

Budget with_memory(std::uint64_t bytes) {
    Budget budget;
    budget.memory = bytes;
    return budget;
}

Json random_json(int depth) {
    const int kind = *rc::gen::inRange(0, depth > 0 ? 7 : 5);
    const auto count = [] { return *rc::gen::inRange(0, 4); };
    switch (kind) {
        case 0:
            return nullptr;
        case 1:
            return *rc::gen::arbitrary<bool>();
        case 2:
            return *rc::gen::arbitrary<std::uint64_t>();
        case 3:
            return -1.5;
        case 4: {
            const auto words = *rc::gen::container<std::string>(
                rc::gen::elementOf(std::string("ab \"\\{}[],:\n\t")));
            return words;
        }
        case 5: {
            Json list = Json::array();
            for (int left = count(); left > 0; --left) list.push_back(random_json(depth - 1));
            return list;
        }
        default: {
            Json object = Json::object();
            for (int left = count(); left > 0; --left)
                object["k" + std::to_string(left)] = random_json(depth - 1);
            return object;
        }
    }
}

/// Whether the value is that of the oracle, a reader of whole texts.
bool agree(const verify::JsonValue& read, const Json& wanted) {
    using Kind = verify::JsonValue::Kind;
    if (wanted.is_null()) return read.kind == Kind::null;
    if (wanted.is_boolean()) return read.kind == Kind::truth && read.truth == wanted.get<bool>();
    if (wanted.is_number_unsigned())
        return read.kind == Kind::number && read.number == wanted.get<std::uint64_t>();
    if (wanted.is_number()) return read.kind == Kind::real;
    if (wanted.is_string())
        return read.kind == Kind::text && read.text == wanted.get<std::string>();
    if (read.kind != (wanted.is_array() ? Kind::list : Kind::object) ||
        read.items.size() != wanted.size())
        return false;
    std::size_t at = 0;
    for (const auto& [name, value] : wanted.items()) {
        if (wanted.is_object() && read.keys[at] != name) return false;
        if (!agree(read.items[at++], value)) return false;
    }
    return true;
}

}  // namespace

TEST_CASE("a certificate needs the memory of its largest statement, not of all") {
    const std::string text = many(40'000);
    const Budget budget = with_memory(1 << 20);  // a fifth of the text
    REQUIRE(text.size() > 4 * budget.memory);
    std::size_t checked = 0;
    verify::check_certificate(verify::source_of(text), "x", budget,
                              {.on_finding = [&](const verify::Finding& found) {
                                  checked += found.outcome == Outcome::checked;
                              }});
    CHECK(checked == 40'000);
}

TEST_CASE("a statement that is too large is not checked, and those after it are") {
    for (const std::size_t words : {10'000U, 200'000U}) {
        const auto found =
            verify::check_certificate(many(5, 2, words), "x.json", with_memory(1 << 20));
        REQUIRE(found.size() == 5);
        for (std::size_t i = 0; i < 5; ++i)
            CHECK(found[i].outcome == (i == 2 ? Outcome::not_checked : Outcome::checked));
        CHECK(found[2].path == "statements[2]");
        CHECK(found[2].line == 4);
        CHECK(found[2].reason == "it takes more memory than is allowed to read it");
        CHECK(found[4].line == 6);
    }
}

TEST_CASE("a single name that is too long, and a header that is, reach the bound") {
    const std::string long_name(10'000'000, 'a');
    CHECK_THROWS_AS(
        verify::check_certificate(R"({"format": ")" + long_name, "x", with_memory(1 << 20)),
        BoundReached);
    std::string letters = R"({"alphabet": [)";
    for (int i = 0; i < 100'000; ++i) letters += "\"a\",";
    CHECK_THROWS_WITH_AS(verify::check_certificate(letters, "x", with_memory(1 << 20)),
                         "x:1: what is read needs more than the memory allowed", BoundReached);
}

TEST_CASE("the statements come last") {
    const auto error = [](const std::string& text) -> std::string {
        try {
            verify::check_certificate(text, "x.json");
        } catch (const Error& refused) {
            return refused.what();
        }
        return "accepted";
    };
    std::string text = many(1);
    text.pop_back();
    CHECK(error(text + ",\n\"source\": \"\"}") ==
          "x.json:3: the field 'source' comes after 'statements', which must be the last");
    CHECK(
        error(
            R"({"format": "algae certificate 1", "claim": "x", "statements": [], "alphabet": []})") ==
        "x.json:1: the field 'alphabet' is missing");
    Json other = certificate(sound()[0]);
    other["statements"] = 7;
    CHECK(error(other.dump()) == "x.json:1: statements: expected a list, found a number");
    other["statements"] = Json::array({7});
    CHECK(error(other.dump()) == "x.json:1: statements[0]: expected an object, found a number");
    other.erase("statements");
    CHECK(error(other.dump()) == "x.json:1: the field 'statements' is missing");
}

TEST_CASE("what is found is told before the rest is read") {
    std::string text = many(3);
    text.resize(text.size() - 2);
    std::size_t told = 0;
    CHECK_THROWS_AS(
        verify::check_certificate(verify::source_of(text), "x", {},
                                  {.on_finding = [&](const verify::Finding&) { ++told; }}),
        Error);
    CHECK(told == 3);
}

TEST_CASE("a text read in pieces has the values of one that is read whole") {
    std::size_t compared = 0;
    CHECK(rc::check([&] {
        const Json wanted = *rc::gen::resize(50, rc::gen::exec([] { return random_json(4); }));
        const std::string text = wanted.dump(*rc::gen::inRange(-1, 3));
        const std::size_t most = *rc::gen::inRange<std::size_t>(1, 9);
        std::size_t at = 0;
        const verify::TextSource pieces = [&](char* to, std::size_t room) {
            const std::size_t count = text.copy(to, std::min(room, most), at);
            at += count;
            return count;
        };
        const verify::JsonValue read = verify::parse_json(pieces, "x");
        RC_ASSERT(agree(read, wanted));
        RC_ASSERT(same_value(read, verify::parse_json(verify::source_of(text), "x")));
        ++compared;
    }));
    CHECK(compared >= 100);
}

TEST_CASE("each value knows its line") {
    CHECK(rc::check([] {
        const auto breaks = *rc::gen::container<std::vector<int>>(20, rc::gen::inRange(0, 3));
        std::string text = "[";
        std::vector<std::size_t> lines;
        std::size_t line = 1;
        for (std::size_t i = 0; i < breaks.size(); ++i) {
            if (i > 0) text += ",";
            text += std::string(static_cast<std::size_t>(breaks[i]), '\n');
            line += static_cast<std::size_t>(breaks[i]);
            lines.push_back(line);
            text += i % 3 == 0 ? "17" : i % 3 == 1 ? "\"a\"" : "{\n}";
            if (i % 3 == 2) ++line;
            if (breaks[i] == 2) {
                text += '\n';
                ++line;
            }
        }
        const verify::JsonValue read = verify::parse_json(verify::source_of(text + "]"), "x");
        RC_ASSERT(read.items.size() == lines.size());
        for (std::size_t i = 0; i < lines.size(); ++i) RC_ASSERT(read.items[i].line == lines[i]);
    }));
}

namespace {

using verify::JsonValue;

/// What a text that is read with so much memory, a quarter of which may be values, is refused for.
std::string refused(const std::string& text, std::uint64_t memory) {
    try {
        verify::parse_json(verify::source_of(text), "x", with_memory(memory));
    } catch (const std::exception& error) {
        return error.what();
    }
    return "";
}

constexpr std::uint64_t of_value = sizeof(JsonValue);
constexpr std::uint64_t of_list = sizeof(JsonValue) + sizeof(std::set<std::string>);
std::uint64_t of_key(std::size_t size) { return 2 * (sizeof(std::string) + size); }

std::string zeros(std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += i > 0 ? ",0" : "0";
    return text;
}

struct Handed {
    std::vector<JsonValue> elements;
    std::string error;
};

/// The elements of "list" that are handed over, as they are counted in so much memory.
Handed handed(const std::string& text, std::uint64_t memory) {
    Handed all;
    try {
        verify::parse_json(
            verify::source_of(text), "x", with_memory(memory),
            {"list", [](JsonValue) {}, [&](const JsonValue& one) { all.elements.push_back(one); }});
    } catch (const std::exception& error) {
        all.error = error.what();
    }
    return all;
}

}  // namespace

TEST_CASE("lists and objects are nested up to a thousand levels") {
    const auto nested = [](std::size_t levels) {
        return std::string(levels, '[') + std::string(levels, ']');
    };
    CHECK(refused(nested(1000), 1 << 28) == "");
    CHECK(refused(nested(1001), 1 << 28) == "x:1: nested deeper than 1000 levels");
}

TEST_CASE("what values take is counted to the byte") {
    const std::string too_much = "x:1: what is read needs more than the memory allowed";
    const std::size_t count = 3000;
    const std::uint64_t list = of_list + count * of_value;
    CHECK(refused("[" + zeros(count) + "]", 4 * list) == "");
    CHECK(refused("[" + zeros(count) + "]", 4 * list - 4) == too_much);
    std::string object = "{";
    std::uint64_t spent = of_list;
    for (std::size_t i = 0; i < 1000; ++i) {
        const std::string key = "key" + std::to_string(i);
        object += (i > 0 ? ",\"" : "\"") + key + "\":0";
        spent += of_key(key.size()) + of_value;
    }
    CHECK(refused(object + "}", 4 * spent) == "");
    CHECK(refused(object + "}", 4 * spent - 4) == too_much);
}

TEST_CASE("a value may take as many pieces of 64 KiB as fit in a quarter of the memory") {
    const std::uint64_t memory = 4 * 3 * 65'536;
    const std::string long_text = '"' + std::string(150'000, 'a') + '"';
    CHECK(refused(long_text, memory) ==
          "");  // three pieces, the first of them counted with none before
    CHECK(refused("[0," + std::string(60'000, ' ') + long_text + "]", memory) ==
          "");  // three behind the first
    CHECK(refused('"' + std::string(300'000, 'a') + '"', memory) ==
          "x:1: a single value is longer than can be read within the memory allowed");
    std::size_t asked = 0;
    const std::string small = "[1]";
    verify::parse_json(
        [&, rest = verify::source_of(small)](char* to, std::size_t most) {
            asked = most;
            return rest(to, most);
        },
        "x");
    CHECK(asked == 65'536);
}

TEST_CASE("of an element that is too large only the end is looked for") {
    // Up to the elements: as many bytes as are counted, and one value more.
    const std::size_t count = 1000;
    const std::string head = R"({"pad":[)" + zeros(count) + "],\n\"list\":[";
    const std::uint64_t before =
        of_list + of_key(3) + of_list + count * of_value + of_key(4) + of_list;
    const auto is_too_large = [](const JsonValue& one) {
        return one.kind == JsonValue::Kind::too_large;
    };
    SUBCASE("that begins too large") {
        const Handed all =
            handed(head + "\n{\"k\":1,\"k\":2},7,\n\n[[[]]],8]}", 4 * (before + of_value));
        CHECK(all.error == "");
        REQUIRE(all.elements.size() == 4);
        CHECK(is_too_large(all.elements[0]));
        CHECK(all.elements[0].line == 3);
        CHECK(all.elements[1].number == 7);
        CHECK(is_too_large(all.elements[2]));
        CHECK(all.elements[2].line == 5);
        CHECK(all.elements[3].number == 8);
    }
    SUBCASE("that becomes too large within") {
        const Handed all = handed(
            head + "\n[\n0,0,\n{\"k\":[1,{\"k\":[]}],\"k\":2},\n[0,[true,null,\"a\"]]],\n9]}",
            4 * (before + of_list + 2 * of_value));
        CHECK(all.error == "");
        REQUIRE(all.elements.size() == 2);
        CHECK(is_too_large(all.elements[0]));
        CHECK(all.elements[0].line == 3);
        CHECK(all.elements[1].number == 9);
        CHECK(all.elements[1].line == 7);
    }
    SUBCASE("that becomes too large two levels within") {
        const Handed all =
            handed(head + "\n[\n[\n0,0,0,0]],\n9]}", 4 * (before + 2 * of_list + 2 * of_value));
        CHECK(all.error == "");
        REQUIRE(all.elements.size() == 2);
        CHECK(is_too_large(all.elements[0]));
        CHECK(all.elements[0].line == 3);
        CHECK(all.elements[1].line == 6);
    }
    SUBCASE("that is a text") {
        const Handed all =
            handed(head + "\n\"" + std::string(1000, 'a') + "\",\n9]}", 4 * (before + of_value));
        CHECK(all.error == "");
        REQUIRE(all.elements.size() == 2);
        CHECK(is_too_large(all.elements[0]));
        CHECK(all.elements[0].line == 3);
        CHECK(all.elements[1].number == 9);
    }
    SUBCASE("that is nested too deeply") {
        const std::string deep = std::string(997, '[') + std::string(997, ']');
        const std::uint64_t memory = 4 * (before + of_list + of_value);
        CHECK(handed(head + deep + "]}", memory).error == "");
        CHECK(handed(head + "[[" + deep + "]]]}", memory).error ==
              "x:2: nested deeper than 1000 levels");
    }
}

TEST_CASE("what is no JSON is said without the place that the parser counts") {
    CHECK(refused("x", 1 << 20).starts_with("x:1: this is not JSON: syntax error"));
}

TEST_CASE("lists that differ are different values") {
    const auto read = [](const char* text) {
        return verify::parse_json(verify::source_of(text), "x");
    };
    CHECK(same_value(read("[1,2]"), read("[1, 2]")));
    CHECK_FALSE(same_value(read("[1]"), read("[2]")));
    CHECK_FALSE(same_value(read("[1]"), read("[1,1]")));
    CHECK_FALSE(same_value(read("{\"a\":1}"), read("{\"b\":1}")));
    CHECK_FALSE(same_value(read("{\"a\":1}"), read("{\"a\":2}")));
    CHECK_FALSE(same_value(read("1"), read("2")));
}
