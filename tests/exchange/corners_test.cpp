#include <doctest/doctest.h>

#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "exchange/compared.hpp"
#include "exchange/detail/formats.hpp"
#include "exchange/exchange.hpp"
#include "exchange/slow_cpfg.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "places.hpp"
#include "turtle/turtle.hpp"

// What the original programs make of small files: the cases stand in files beside this one. Where algae says something else, the case is
// named here with the reason; a deviation that is gone, or a new one, is a failure.

using namespace algae;
using namespace algae::exchange_tests;

namespace {

struct Case {
    std::string name, text;
    std::vector<std::string> results;  // lines behind "-> "
};

std::vector<std::string> lines_of(const std::string& file) {
    std::ifstream in(source_folder() + "/tests/exchange/" + file);
    REQUIRE(in.good());
    std::vector<std::string> found;
    for (std::string line; std::getline(in, line);) found.push_back(line);
    return found;
}

std::vector<Case> cases_of(const std::string& file) {
    std::vector<Case> found;
    for (const std::string& line : lines_of(file)) {
        if (line.starts_with("== "))
            found.push_back({line.substr(3), "", {}});
        else if (line.starts_with("-> "))
            found.back().results.push_back(line.substr(3));
        else if (!found.empty())
            found.back().text += line + "\n";
    }
    return found;
}

std::string cpfg_result(const std::string& text) {
    try {
        const Model system = read_cpfg(text, "x.l");
        const std::uint64_t n = system.drawing.generations ? system.drawing.generations->second : 0;
        return SlowSystem::text(own_word(system, n));
    } catch (const Error&) {
        return "rejected";
    }
}

}  // namespace

TEST_CASE("corner cases of cpfg give the words that the program prints, but for named deviations") {
    // By name: what algae gives instead, and why.
    const std::map<std::string, std::pair<std::string, std::string>> deviations{
        {"float32: 0.1==0.1", {"Y", "parameters are exact"}},
        {"1/0", {"rejected", "a division by 0 has no value"}},
        {"cut %", {"A[BC%DE[F]G]H", "% cuts the figure, words keep what is cut"}},
        {"cut % in successor, 2 steps", {"A[B%D]H", "% cuts the figure, words keep what is cut"}},
    };
    std::size_t compared = 0, deviating = 0;
    for (const Case& one : cases_of("cpfg_corners.txt")) {
        CAPTURE(one.name);
        CAPTURE(one.text);
        REQUIRE(one.results.size() == 1);
        const auto deviation = deviations.find(one.name);
        const std::string result = cpfg_result(one.text);
        if (deviation == deviations.end()) {
            CHECK(result == one.results[0]);
        } else {
            CHECK(result == deviation->second.first);
            CHECK(result != one.results[0]);
            ++deviating;
        }
        ++compared;
    }
    CHECK(compared == 59);
    CHECK(deviating == deviations.size());
}

TEST_CASE(
    "corner cases of Fractint draw the lines and boxes of the program, but for named deviations") {
    // The box of the program counts what its scaling pass visits.
    const std::map<std::string, std::string> other_boxes{
        {"DigitRule", "the program's scaling pass takes the digits of a command for symbols"},
        {"OneLine", "the box here has no places that the turtle only moves to"},
    };
    std::size_t compared = 0, boxes = 0;
    for (const Case& one : cases_of("fractint_corners.txt")) {
        CAPTURE(one.name);
        CAPTURE(one.text);
        ++compared;
        if (one.results[0] == "rejected") {
            CHECK(!refusal([&] { read_fractint(one.text, "x.l"); }).empty());
            continue;
        }
        const Model system = read_fractint(one.text, "x.l");
        REQUIRE(one.results.size() == 3);
        for (std::uint64_t n = 0; n < 3; ++n) {
            CAPTURE(n);
            std::istringstream said(one.results[n]);
            std::size_t segments = 0;
            char colon = 0;
            double box[4];
            said >> segments >> colon >> box[0] >> box[1] >> box[2] >> box[3];
            const auto drawn = open_figure(system, n, {}, {}, nullptr);
            const Facts& facts = drawn->facts();
            CHECK(facts.segments == segments);
            if (segments == 0 || other_boxes.contains(one.name)) continue;
            ++boxes;
            CHECK(std::fabs(facts.low.at(0).value() - box[0]) < 1e-8);
            CHECK(std::fabs(facts.low.at(1).value() - box[1]) < 1e-8);
            CHECK(std::fabs(facts.high.at(0).value() - box[2]) < 1e-8);
            CHECK(std::fabs(facts.high.at(1).value() - box[3]) < 1e-8);
        }
    }
    CHECK(compared == 22);
    CHECK(boxes >= 30);
}

namespace {

struct JflapSystem {
    std::string name;
    std::vector<std::string> formats;
    std::vector<std::string> axiom;
    std::vector<std::pair<std::vector<std::string>, std::vector<std::string>>> rules;
    std::vector<std::pair<std::string, std::string>> parameters;
    std::vector<std::size_t> lengths;
};

std::vector<std::string> words_of(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> found;
    for (std::string word; in >> word;) found.push_back(word);
    return found;
}

std::vector<JflapSystem> jflap_systems() {
    std::vector<JflapSystem> found;
    for (const std::string& line : lines_of("jflap_systems.txt")) {
        std::vector<std::string> words = words_of(line);
        if (words.empty() || words[0] == "#") continue;
        const std::string key = words[0];
        words.erase(words.begin());
        if (key == "system") {
            found.emplace_back();
            found.back().name = words.at(0);
        } else if (key == "formats") {
            found.back().formats = words;
        } else if (key == "axiom") {
            found.back().axiom = words;
        } else if (key == "rule") {
            const auto arrow = std::ranges::find(words, "->");
            found.back().rules.emplace_back(std::vector(words.begin(), arrow),
                                            std::vector(arrow + 1, words.end()));
        } else if (key == "parameter") {
            found.back().parameters.emplace_back(words.at(0), words.at(1));
        } else if (key == "lengths") {
            for (const std::string& word : words) found.back().lengths.push_back(std::stoul(word));
        }
    }
    return found;
}

std::string escaped(const std::string& token) {
    return token == "<" ? "&lt;" : token == ">" ? "&gt;" : token == "&" ? "&amp;" : token;
}
std::string written(const std::vector<std::string>& tokens, const char* between) {
    return joined(tokens, between, [](const std::string& token) { return escaped(token); });
}

/// The file, as the program of this format writes it.
std::string jflap_file(const JflapSystem& system, bool eighth) {
    std::string text =
        eighth ? "<structure type=\"lsystem\">\n" : "<structure><type>lsystem</type>\n";
    const auto parameters = [&] {
        for (const auto& [name, value] : system.parameters)
            text +=
                "<parameter><name>" + name + "</name><value>" + value + "</value></parameter>\n";
    };
    if (!eighth) {
        text += "<axiom>" + written(system.axiom, " ") + "</axiom>\n";
        for (const auto& [left, right] : system.rules)
            text += "<production><left>" + written(left, " ") + "</left><right>" +
                    written(right, " ") + "</right></production>\n";
        parameters();
        return text + "</structure>\n";
    }
    std::set<std::string> symbols(system.axiom.begin(), system.axiom.end());
    for (const auto& [left, right] : system.rules) symbols.insert(right.begin(), right.end());
    text += "<structure type=\"parameter_map\">\n";
    parameters();
    text += "</structure>\n<structure type=\"axiom\"><axiom>" + written(system.axiom, "") +
            "</axiom></structure>\n<structure type=\"grammar\"><structure type=\"terminals\">";
    for (const std::string& symbol : symbols) text += "<symbol>" + escaped(symbol) + "</symbol>";
    text += "</structure>\n";
    for (const auto& [left, right] : system.rules)
        text += "<production><rhs>" + written(right, "") + "</rhs><lhs>" +
                written(left, left.size() > 1 ? " " : "") + "</lhs></production>\n";
    return text + "</structure></structure>\n";
}

}  // namespace

TEST_CASE("systems of JFLAP have the lengths of the program's expansions, in both formats") {
    std::size_t compared = 0;
    for (const JflapSystem& system : jflap_systems())
        for (const std::string& format : system.formats) {
            CAPTURE(system.name);
            CAPTURE(format);
            const std::string file = jflap_file(system, format == "eighth");
            CAPTURE(file);
            const Model model = read_jflap(file, "x.jff");
            for (std::uint64_t n = 0; n < system.lengths.size(); ++n) {
                CAPTURE(n);
                CHECK(words_of(word_of(model, n)).size() == system.lengths[n]);
            }
            ++compared;
        }
    CHECK(compared == 29);
}

TEST_CASE(
    "assignments of JFLAP change the steps and turns behind them up to the end of the branch") {
    const auto end = [](const std::string& inside, std::uint64_t n) {
        const Model system =
            read_jflap("<structure><type>lsystem</type>" + inside + "</structure>", "x.jff");
        const auto drawn = open_figure(system, n, {}, {}, nullptr);
        return std::pair{drawn->facts().end.at(0).value(), drawn->facts().end.at(1).value()};
    };
    // A turn of 90 and a step of 2; in the branch they are others.
    const auto branch =
        end("<axiom>angle=90 distance=2 [ angle=30 distance=7 + g ] + g</axiom>", 0);
    CHECK(near(branch.first, 2));
    CHECK(near(branch.second, 0));
    // Fibonacci's squares: every step is three times a number of the sequence.
    const auto spiral = end(
        "<axiom>g + S</axiom><production><left>S</left><right>c=a+b a=b b=c distance=a*3 g + "
        "S</right></production><parameter><name>a</name><value>0</value></parameter><parameter>"
        "<name>b</name><value>1</value></parameter><parameter><name>angle</name><value>90</value>"
        "</parameter><parameter><name>distance</name><value>3</value></parameter>",
        3);
    // Up 3, right 3, down 3, left 6.
    CHECK(near(spiral.first, -3));
    CHECK(near(spiral.second, 0));
    const std::string refused = refusal([] {
        read_jflap(
            "<structure><type>lsystem</type><axiom>S g</axiom><production><left>S</left><right>"
            "distance=distance+1 S</right></production></structure>",
            "x.jff");
    });
    CHECK(refused.find("x.jff:1:41: error: 'g' depends on the variable distance, which 'S' before "
                       "it goes on changing") == 0);
}
