#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <sstream>

#include "command/run.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "studio/served.hpp"
#include "studio/studio.hpp"

using namespace algae;
using nlohmann::json;

namespace {

struct Strokes {
    json head;
    std::vector<float> numbers;
    std::vector<std::uint32_t> symbols;
};

Strokes strokes_of(const std::string& bytes) {
    Strokes found;
    const std::size_t end = bytes.find('\n');
    found.head = json::parse(bytes.substr(0, end));
    const std::size_t count = found.head["strokes"];
    REQUIRE(bytes.size() == end + 1 + 20 * count);
    found.numbers.resize(4 * count);
    found.symbols.resize(count);
    std::memcpy(found.numbers.data(), bytes.data() + end + 1, 16 * count);
    std::memcpy(found.symbols.data(), bytes.data() + end + 1 + 16 * count, 4 * count);
    return found;
}

/// The corners of a plane turtle that knows F, + and -, walked symbol by symbol.
std::vector<std::pair<double, double>> walked(const std::string& word, double degrees) {
    constexpr double whole_turn = 6.283185307179586;
    double x = 0, y = 0, heading = 0;
    std::vector<std::pair<double, double>> corners{{0, 0}};
    for (const char c : word) {
        if (c == '+') heading += degrees;
        if (c == '-') heading -= degrees;
        if (c != 'F') continue;
        x += std::cos(heading / 360 * whole_turn);
        y += std::sin(heading / 360 * whole_turn);
        corners.emplace_back(x, y);
    }
    return corners;
}

std::string rewritten(std::string word, const std::string& successor, int steps) {
    for (int i = 0; i < steps; ++i) {
        std::string next;
        for (const char c : word) next += c == 'F' ? successor : std::string(1, c);
        word = next;
    }
    return word;
}

}  // namespace

TEST_CASE("a figure's strokes are those of a turtle that walks the word") {
    std::size_t cases = 0, strokes = 0;
    const std::vector<std::pair<std::string, double>> systems{
        {"F+F--F+F", 60}, {"F-F+F+F-F", 90}, {"F+F-F", 35.5}, {"FF+F", 17}};
    for (const auto& [successor, angle] : systems)
        for (int n = 0; n <= 4; ++n) {
            const Model system =
                read_lsystem("axiom F\nF -> " + successor + "\nangle " + std::to_string(angle), "");
            const std::string word = rewritten("F", successor, n);
            const auto corners = walked(word, angle);
            FigureQuestion question;
            question.generation = static_cast<std::uint64_t>(n);
            question.pixels = 1e9;
            const Strokes found = strokes_of(figure_view(system, question, {}));
            REQUIRE(found.symbols.size() == corners.size() - 1);
            const double middle_x = found.head["middle"][0], middle_y = found.head["middle"][1];
            std::size_t at = 0;
            for (std::size_t i = 0; i < found.symbols.size(); ++i) {
                CHECK(std::fabs(found.numbers[4 * i + 2] + middle_x - corners[i + 1].first) < 1e-3);
                CHECK(std::fabs(found.numbers[4 * i + 3] + middle_y - corners[i + 1].second) <
                      1e-3);
                while (word[at] != 'F') ++at;
                CHECK(found.symbols[i] == at);
                ++at;
                ++strokes;
            }
            ++cases;
        }
    CHECK(cases == 20);
    CHECK(strokes > 1000);
}

TEST_CASE("a part of a figure has the strokes that meet it") {
    const Model system = read_lsystem("axiom F\nF -> F+F--F+F\nangle 60", "");
    FigureQuestion whole;
    whole.generation = 6;
    whole.pixels = 1e9;
    const Strokes all = strokes_of(figure_view(system, whole, {}));
    CHECK(all.symbols.size() == 4096);
    FigureQuestion part = whole;
    part.part = FigureQuestion::Part{0, 0, 81, 60};
    const Strokes some = strokes_of(figure_view(system, part, {}));
    // The part is the first ninth of the curve, and what of the others is near.
    CHECK(some.symbols.size() >= 256);
    CHECK(some.symbols.size() < 600);
    // Fewer strokes than there are: detail gets coarser until they fit.
    FigureQuestion few = whole;
    few.most_strokes = 300;
    const Strokes coarse = strokes_of(figure_view(system, few, {}));
    CHECK(coarse.symbols.size() <= 300);
    CHECK(coarse.symbols.size() > 20);
    CHECK(coarse.head["coarser"] > 1);
}

TEST_CASE("a derivation's ancestors give the words back") {
    std::size_t looked_at = 0;
    for (const char* text :
         {"axiom b\na -> ab\nb -> a", "axiom X\nX -> F[+X]X\nF -> FF\nangle 20",
          "axiom A(1)\nA(x) : x < 4 -> A(x+1)B(x)\nB(x) -> C", "axiom ab\na -> ε\nb -> ab"}) {
        const Model system = read_lsystem(text, "");
        const json found = json::parse(derivation_view(system, 5, std::nullopt, 100'000, {}));
        CHECK(found["full"] == false);
        REQUIRE(found["words"].size() == 6);
        for (std::size_t n = 1; n < 6; ++n) {
            const json& word = found["words"][n];
            REQUIRE(word["parents"].size() == word["symbols"].size());
            std::size_t last = 0;
            for (const json& parent : word["parents"]) {
                CHECK(parent >= last);
                last = parent;
                CHECK(last < found["words"][n - 1]["symbols"].size());
                ++looked_at;
            }
        }
    }
    CHECK(looked_at > 100);
    const Model doubling = read_lsystem("axiom a\na -> aa", "");
    const json stopped = json::parse(derivation_view(doubling, 40, std::nullopt, 1000, {}));
    CHECK(stopped["full"] == true);
    CHECK(stopped["words"].size() < 12);
    CHECK(stopped["rounded"].is_null());
    // Parameters are exact as far as that goes, as in `derive`.
    const Model tenths = read_lsystem("axiom A(0)\nA(x) -> A(x+0.1)", "");
    const json exact = json::parse(derivation_view(tenths, 3, std::nullopt, 1000, {}));
    CHECK(exact["words"][3]["symbols"][0] == "A(0.3)");
    CHECK(exact["rounded"].is_null());
    const Model squares = read_lsystem("axiom A(1.0001)\nA(x) -> A(x*x)", "");
    const json rounded = json::parse(derivation_view(squares, 14, std::nullopt, 1000, {}));
    CHECK(rounded["words"].size() == 15);
    CHECK(rounded["rounded"] == ":2:11: the value of 'x*x' has more than 10,000 digits");
}

TEST_CASE("a figure says why its parameters were rounded") {
    FigureQuestion question;
    question.generation = 14;
    const Model squares = read_lsystem("axiom A(1.0001)\nA(x) -> F(1)A(x*x)", "");
    CHECK(strokes_of(figure_view(squares, question, {})).head["rounded"] ==
          ":2:15: the value of 'x*x' has more than 10,000 digits");
    const Model ones = read_lsystem("axiom A(1)\nA(x) -> F(1)A(x*x)", "");
    CHECK(strokes_of(figure_view(ones, question, {})).head["rounded"].is_null());
}

TEST_CASE("one question is answered without a server") {
    const Scratch scratch;
    const std::string koch = "axiom F\nF -> F+F--F+F\nangle 60\n";
    const auto ask = [&](const std::string& text) {
        return run("studio --ask < '" + scratch.file("question.json", text) + "'");
    };
    const Run growth = ask(json{{"question", "growth"}, {"text", koch}}.dump());
    CHECK(growth.status == 0);
    CHECK(growth.out == run("growth --json '" + scratch.file("typed.lsys", koch) + "'").out);
    const Run wrong = ask(json{{"question", "describe"}, {"text", "axiom F\nangel 60\n"}}.dump());
    CHECK(wrong.status == 2);
    CHECK(json::parse(wrong.out)["error"]["line"] == 2);
    const Run garbled = ask("{");
    CHECK(garbled.status == 2);
    CHECK(garbled.out.find("the question is not JSON") != std::string::npos);
    const Run long_one = ask(std::string((std::size_t{1} << 20) + 1, ' '));
    CHECK(long_one.status == 2);
    CHECK(long_one.err.find("the question has more than 1 MiB") != std::string::npos);
}

TEST_CASE("the page's questions are answered as the verbs answer them") {
    const served::Studio studio;
    const Scratch scratch;
    const std::string koch = "axiom F\nF -> F+F--F+F\nangle 60\n";
    const std::string file = scratch.file("typed.lsys", koch);
    const auto ask = [&](const char* question, const std::string& text,
                         json more = json::object()) {
        more["question"] = question;
        more["text"] = text;
        return studio.ask(more);
    };
    CHECK(ask("growth", koch).text == run("growth --json '" + file + "'").out);
    CHECK(ask("growth", koch, {{"let", json::object()}}).head["status"] == 0);
    CHECK(ask("finite", koch).head["status"] == 1);
    CHECK(ask("letters", koch).text == run("tree --graph --format dot -o - '" + file + "'").out);
    CHECK(ask("picture", koch, {{"n", 3}, {"format", "csv"}}).text ==
          run("draw -n 3 --format csv -o - '" + file + "'").out);
    CHECK(ask("picture", koch, {{"n", 3}, {"format", "png"}}).text ==
          run("draw -n 3 --format png -o - '" + file + "'").out);
    CHECK(ask("member", "axiom b\na -> ab\nb -> a\n", {{"word", "abaab"}}).json()["member"] ==
          true);
    CHECK(ask("member", "axiom -\n- -> --\n", {{"word", "----"}}).json()["member"] == true);
    CHECK(ask("show", koch).json()["class"] == "PD0L");
    CHECK(ask("describe", "let r = 0.5\naxiom A(r)\n").json()["constants"][0]["value"] == 0.5);
    const auto wrong = ask("describe", "axiom F\nangel 60\n");
    CHECK(wrong.head["status"] == 2);
    CHECK(wrong.json()["error"]["line"] == 2);
    const auto claim = ask("check", "claim  One\nshow a in {a}\nshow b in {a}\n").json();
    CHECK(claim["claims"][0]["statements"][0]["verdict"] == "proved");
    CHECK(claim["claims"][0]["statements"][1]["verdict"] == "refuted");
    const auto certificate = ask("certificate", "claim  One\nshow {a, aa} is not 0L\n");
    const std::string kept = scratch.file("c.json", certificate.text);
    CHECK(run("verify '" + kept + "'").status == 0);
    const auto found =
        ask("editor", "axiom F\nangel 60\n", {{"kind", "lsys"}, {"method", "diagnostics"}});
    CHECK(found.text.find("did you mean 'angle'") != std::string::npos);
    CHECK(ask("editor", "ang",
              {{"kind", "lsys"}, {"method", "completion"}, {"line", 0}, {"character", 3}})
              .text.find("\"angle\"") != std::string::npos);
    const auto marked =
        studio.ask({{"question", "mark"}, {"lesson", 1}, {"exercise", 1}, {"text", "aba\n"}});
    CHECK((marked.head["status"] == 0 || marked.head["status"] == 1));
    CHECK(marked.json()["verdict"].is_string());
    CHECK(studio.ask({{"question", "lesson"}, {"lesson", 3}}).json()["exercises"].size() > 1);
    CHECK(studio.ask({{"question", "open"}, {"from", "gallery"}, {"file", "koch"}})
              .json()["text"]
              .get<std::string>()
              .find("axiom") != std::string::npos);
    const auto space = ask("figure", "axiom F&F\n", {{"n", 0}});
    CHECK(json::parse(space.text.substr(0, space.text.find('\n')))["kind"] == "space");
    const auto walk = ask("walk", koch, {{"n", 1}}).json();
    CHECK(walk["steps"].size() == 8);
    CHECK(walk["steps"][0]["lines"][0]["drawn"] == true);
    const auto long_walk = ask("walk", koch, {{"n", 12}});
    CHECK(long_walk.head["status"] == 3);
}

TEST_CASE("exercises of one's own are shown and marked as the verb marks them") {
    const served::Studio studio;
    const Scratch scratch;
    const std::string text =
        "exercise Doubling\nsource A course\ntask Write a system that doubles.\nanswer system\n"
        "show answer has 1 rule\nhint One letter is enough.\nshow growth(answer) = 2^n\n"
        "hint Each letter has two successors.\n";
    const std::string file = scratch.file("mine.exercise", text);
    const auto ask = [&](const char* what, const std::string& exercise, const std::string& answer) {
        return studio.ask({{"question", what},
                           {"exercise_text", exercise},
                           {"file", "mine.exercise"},
                           {"text", answer}});
    };
    const auto shown = ask("exercise", text, "");
    CHECK(shown.text == run("lesson --json '" + file + "'").out);
    CHECK(shown.json()["exercise"] == "mine");
    CHECK(shown.json()["ending"] == "lsys");
    const auto broken = ask("exercise", "exercise One\ntsk Write a.\n", "");
    CHECK(broken.head["status"] == 2);
    CHECK(broken.json()["error"]["line"] == 2);
    std::size_t compared = 0;
    for (const auto& [answer, status] :
         {std::pair{"axiom a\na -> aa\n", 0}, std::pair{"axiom a\na -> aaa\n", 1},
          std::pair{"axiom a\na -> ab\nb -> b\n", 1}}) {
        INFO(answer);
        const auto marked = ask("mark", text, answer);
        CHECK(marked.head["status"] == status);
        CHECK(
            marked.text ==
            run("lesson --json '" + file + "' '" + scratch.file("answer.lsys", answer) + "'").out);
        ++compared;
    }
    CHECK(compared == 3);
    const auto unreadable = ask("mark", text, "axiom\n");
    CHECK(unreadable.head["status"] == 2);
    CHECK(unreadable.text.find("the answer") != std::string::npos);
    // The exercise of a page opens no file beside the studio's folder.
    const std::string prying =
        "exercise Prying\ntask Write a.\nanswer word\nlet G = D0L ../secret.lsys\nshow answer <= "
        "L(G)\n";
    CHECK(ask("mark", prying, "a\n").head["status"] == 2);
}
