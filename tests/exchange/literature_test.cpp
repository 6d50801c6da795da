#include <doctest/doctest.h>

#include <cmath>
#include <complex>
#include <fstream>
#include <functional>
#include <map>
#include <numbers>
#include <optional>
#include <sstream>

#include "exchange/compared.hpp"
#include "exchange/detail/formats.hpp"
#include "exchange/exchange.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "places.hpp"
#include "turtle/turtle.hpp"

// Systems of the literature in the files of each program. The data say a system once; a writer for each program, which shares nothing with
// the printers of the library, says it as people write it there. The strokes of what is read must be those of a slow turtle that starts and
// turns as the program does, and so must those of what is printed in any other format and read again, up to where the figure stands.

using namespace algae;
using namespace algae::exchange_tests;

namespace {

struct Known {
    std::string name, axiom;
    std::vector<std::pair<char, std::string>> rules;
    std::string angle;
    std::vector<std::size_t> segments;
    std::optional<std::pair<std::size_t, std::complex<double>>> end;

    double turn() const { return std::stod(angle); }
    bool has(char c) const {
        bool found = axiom.find(c) != std::string::npos;
        for (const auto& [letter, image] : rules)
            found = found || image.find(c) != std::string::npos;
        return found;
    }
    /// The word of a generation, letter by letter.
    std::string word(std::size_t n) const {
        std::string now = axiom;
        for (; n > 0; --n) {
            std::string next;
            for (const char c : now) {
                const auto rule = std::ranges::find(rules, c, &std::pair<char, std::string>::first);
                next += rule == rules.end() ? std::string(1, c) : rule->second;
            }
            now = next;
        }
        return now;
    }
};

std::vector<Known> known_systems() {
    std::ifstream in(source_folder() + "/tests/exchange/literature.txt");
    REQUIRE(in.good());
    std::vector<Known> found;
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string key;
        if (!(words >> key) || key == "#") continue;
        if (key == "system") {
            found.emplace_back();
            found.back().name = line.substr(key.size() + 1);
            continue;
        }
        Known& system = found.back();
        if (key == "axiom") {
            words >> system.axiom;
        } else if (key == "rule") {
            std::pair<char, std::string> rule;
            words >> rule.first >> rule.second;
            system.rules.push_back(rule);
        } else if (key == "angle") {
            words >> system.angle;
        } else if (key == "segments") {
            for (std::size_t count = 0; words >> count;) system.segments.push_back(count);
        } else if (key == "end") {
            std::size_t n = 0;
            double x = 0, y = 0;
            words >> n >> x >> y;
            system.end = {n, {x, y}};
        } else {
            FAIL("a line of another kind: " << line);
        }
    }
    return found;
}

using Complex = std::complex<double>;
using Strokes = std::vector<std::pair<Complex, Complex>>;

/// What a turtle of steps of length 1 leaves, with where it stops behind all strokes.
Strokes walked(const std::string& word, double turn, double heading, bool clockwise) {
    struct State {
        Complex at;
        double heading;
    };
    State turtle{0, heading};
    std::vector<State> kept;
    Strokes strokes;
    const double left = clockwise ? -turn : turn;
    for (const char c : word) {
        const Complex step = std::polar(1.0, turtle.heading * std::numbers::pi / 180);
        if (c == 'F') strokes.emplace_back(turtle.at, turtle.at + step);
        if (c == 'F' || c == 'f') turtle.at += step;
        if (c == '+') turtle.heading += left;
        if (c == '-') turtle.heading -= left;
        if (c == '|') turtle.heading += 180;
        if (c == '[') kept.push_back(turtle);
        if (c == ']') {
            turtle = kept.back();
            kept.pop_back();
        }
    }
    strokes.emplace_back(turtle.at, turtle.at);
    return strokes;
}

/// The strokes of a generation of a system.
Strokes drawn(const Model& system, std::size_t n) {
    Strokes strokes;
    for (const Rod& rod : scene_of(system, n).scene.rods)
        strokes.emplace_back(Complex(rod.from.x, rod.from.y), Complex(rod.to.x, rod.to.y));
    return strokes;
}

bool close(Complex a, Complex b) { return std::abs(a - b) <= 1e-7 * (1 + std::abs(a)); }

/// Whether the strokes are the same ones; the end of the turtle behind the second is left out.
bool same(const Strokes& a, const Strokes& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (!close(a[i].first, b[i].first) || !close(a[i].second, b[i].second)) return false;
    return true;
}

/// Whether a turn, a move and, if it may, a change of the size make one of the other, stroke by stroke.
bool congruent(const Strokes& a, const Strokes& b, bool any_size) {
    if (a.size() != b.size()) return false;
    if (a.empty()) return true;
    const Complex factor = (b[0].second - b[0].first) / (a[0].second - a[0].first);
    if (!any_size && std::fabs(std::abs(factor) - 1) > 1e-7) return false;
    Strokes moved;
    for (const auto& [from, to] : a)
        moved.emplace_back(b[0].first + factor * (from - a[0].first),
                           b[0].first + factor * (to - a[0].first));
    return same(moved, b);
}

std::string replaced(std::string word, char from, char to) {
    std::ranges::replace(word, from, to);
    return word;
}
/// Each letter as the format writes it, with this between them.
std::string mapped(const std::string& word, const std::map<char, std::string>& names,
                   const std::string& between = "") {
    std::string out;
    for (const char c : word) {
        const auto found = names.find(c);
        if (!out.empty()) out += between;
        out += found == names.end() ? std::string(1, c) : found->second;
    }
    return out;
}

/// A program's files: which systems they can say, how one says it, and how its turtle starts and turns.
struct Original {
    const char *name, *format;
    double heading;
    bool clockwise;
    std::function<bool(const Known&)> says;
    std::function<std::string(const Known&)> file;
};

bool is_whole(const std::string& angle) { return angle.find('.') == std::string::npos; }

std::string cpfg_file(const Known& system) {
    std::string text = "/* " + system.name +
                       " */\nLsystem: 1\nderivation length: 2\nAxiom: " + system.axiom + "\n";
    for (const auto& [letter, image] : system.rules)
        text += std::string(1, letter) + " --> " + image + "\n";
    return text + "homomorphism\n+ --> +(" + system.angle + ")\n- --> -(" + system.angle +
           ")\nendlsystem\n";
}
std::string lpfg_file(const Known& system) {
    const std::map<char, std::string> names{{'F', "F(1)"},
                                            {'f', "f(1)"},
                                            {'+', "Left(" + system.angle + ")"},
                                            {'-', "Right(" + system.angle + ")"},
                                            {'|', "TurnAround()"},
                                            {'[', "SB()"},
                                            {']', "EB()"},
                                            {'L', "Lobe()"},
                                            {'R', "Rim()"},
                                            {'X', "Apex()"},
                                            {'Y', "Bud()"}};
    std::string text = "#include <lpfgall.h>\n// " + system.name + "\nderivation length: 2;\n";
    for (const char* name : {"Lobe", "Rim", "Apex", "Bud"})
        text += std::string("module ") + name + "();\n";
    text += "Axiom: " + mapped(system.axiom, names, " ") + ";\nproduction:\n";
    for (const auto& [letter, image] : system.rules)
        text +=
            (letter == 'F' || letter == 'f' ? std::string(1, letter) + "(x)" : names.at(letter)) +
            " :\n{\n  produce " + mapped(image, names, " ") + ";\n}\n";
    return text;
}
std::string lpy_file(const Known& system) {
    const std::map<char, std::string> names{{'+', "Left(turn)"}, {'-', "-(turn)"}, {'X', "Apex"}};
    std::string text = "# " + system.name + "\nturn = " + system.angle +
                       "\nmodule Apex\nAxiom: " + mapped(system.axiom, names) +
                       "\nderivation length: 2\nproduction:\n";
    for (const auto& [letter, image] : system.rules)
        text += mapped(std::string(1, letter), names) + " --> " + mapped(image, names) + "\n";
    return text + "endlsystem\n###### INITIALISATION ######\nnonsense = {\n";
}
std::string fractint_file(const Known& system) {
    const int parts = static_cast<int>(std::lround(360 / system.turn()));
    std::string text = "Figure { ; " + system.name + "\n  Angle " + std::to_string(parts) +
                       "\n  Axiom " + replaced(system.axiom, 'f', 'g') + "\n";
    for (const auto& [letter, image] : system.rules)
        text += std::string("  ") + (letter == 'f' ? 'G' : letter) + "=" +
                replaced(image, 'f', 'g') + "\n";
    return text + "}\n";
}
std::string inkscape_file(const Known& system) {
    const auto word = [](std::string text) { return replaced(replaced(text, 'f', 'G'), 'L', 'M'); };
    std::string rules;
    for (const auto& [letter, image] : system.rules)
        rules += (rules.empty() ? "" : ";") + word(std::string(1, letter)) + "=" + word(image);
    return "axiom = " + word(system.axiom) + "\nrules = " + rules +
           "\norder = 2\nlangle = " + system.angle + "\nrangle = " + system.angle + "\n";
}
std::string tikz_file(const Known& system) {
    std::string text = "\\pgfdeclarelindenmayersystem{" + system.name + "}{\n";
    text.erase(std::remove(text.begin(), text.end(), ','), text.end());
    const std::string name = text.substr(text.find('{') + 1, text.find('}') - text.find('{') - 1);
    for (const auto& [letter, image] : system.rules)
        text += "  \\rule{" + std::string(1, letter) + " -> " + image + "}\n";
    return text + "}\n\\begin{tikzpicture}\n\\draw [l-system={" + name + ", axiom={" +
           system.axiom + "}, order=2, step=1pt, angle=" + system.angle +
           "}] lindenmayer system;\n";
}
const std::map<char, std::string> jflap_names{{'F', "g"}, {'|', "%"}, {'X', "X"}};
std::string jflap_parameters(const Known& system) {
    return "<parameter><name>angle</name><value>" + system.angle +
           "</value></parameter>\n<parameter><name>distance</name><value>1</value></parameter>\n";
}
std::string jflap_file(const Known& system) {
    std::string text =
        "<?xml version=\"1.0\"?><!--Created with JFLAP "
        "6.4.--><structure>\n<type>lsystem</type>\n<axiom>" +
        mapped(system.axiom, jflap_names, " ") + "</axiom>\n";
    for (const auto& [letter, image] : system.rules)
        text += "<production><left>" + mapped(std::string(1, letter), jflap_names) +
                "</left>\n<right>" + mapped(image, jflap_names, " ") + "</right></production>\n";
    return text + jflap_parameters(system) + "</structure>\n";
}
std::string jflap8_file(const Known& system) {
    std::string text =
        "<structure type=\"lsystem\">\n<structure type=\"parameter_map\">\n" +
        jflap_parameters(system) + "</structure>\n<structure type=\"axiom\"><axiom>" +
        mapped(system.axiom, jflap_names) + "</axiom></structure>\n<structure type=\"grammar\">\n";
    for (const auto& [letter, image] : system.rules)
        text += "<production><rhs>" + mapped(image, jflap_names) + "</rhs><lhs>" +
                mapped(std::string(1, letter), jflap_names) + "</lhs></production>\n";
    return text + "</structure></structure>\n";
}
std::string netlogo_file(const Known& system) {
    std::string text = "to setup-figure ; " + system.name + "\n  clear-all\n  set chain \"" +
                       system.axiom + "\"\n  set d 1\n  set delta " + system.angle +
                       "\n  set k-shorten 1\n";
    for (const auto& [letter, image] : system.rules)
        text += std::string("  add-rule \"") + letter + "\" \"" + image + "\" \"" + letter + "\"\n";
    return text + "end\n";
}
std::string maple_file(const Known& system) {
    std::string rules;
    for (const auto& [letter, image] : system.rules)
        rules += std::string(rules.empty() ? "" : ",") + "\"" + letter + "\",\"" + image + "\"";
    return "# " + system.name + "\nrestart:\nAXIOMA := \"" + system.axiom +
           "\":\nLsystem(AXIOMA, [" + rules + "], " + system.angle + ", 2);\n";
}
std::string brno_file(const Known& system) {
    std::string modules = "F = P(1)", rules;
    for (const char letter : std::string("LRXY"))
        if (system.has(letter)) modules += std::string(", ") + letter;
    for (const auto& [letter, image] : system.rules)
        rules += std::string(rules.empty() ? "" : ", ") + letter + " -> " + image;
    return "modules: " + modules + ";   // " + system.name + "\naxiom:   " + system.axiom +
           ";\nangles:  L = 1, U = " + system.angle + ", H = 1;\nrules:   " + rules + ";\nEND\n";
}

const std::vector<Original>& originals() {
    const auto all = [](const Known&) { return true; };
    const auto no_back = [](const Known& system) { return !system.has('|'); };
    static const std::vector<Original> found{
        {"cpfg", "cpfg", 90, false, all, cpfg_file},
        {"lpfg", "lpfg", 90, false, all, lpfg_file},
        {"L-Py", "lpy", 90, false, all, lpy_file},
        {"Fractint", "l", 0, false,
         [](const Known& system) {
             const double parts = 360 / system.turn();
             return std::fabs(parts - std::round(parts)) < 1e-9;
         },
         fractint_file},
        {"Inkscape", "inkscape", 90, true, all, inkscape_file},
        {"TikZ", "tikz", 0, false, no_back, tikz_file},
        {"JFLAP 7", "jff", 90, true, all, jflap_file},
        {"JFLAP 8", "jff", 90, true, all, jflap8_file},
        {"NetLogo", "netlogo", 90, false, no_back, netlogo_file},
        {"Maple", "maple", 0, false, all, maple_file},
        {"Brno", "brno", 0, false,
         [](const Known& system) { return is_whole(system.angle) && !system.has('f'); }, brno_file},
    };
    return found;
}

const SystemFormat& format(const std::string& name) {
    return *std::ranges::find(system_formats(), name, &SystemFormat::name);
}

}  // namespace

TEST_CASE("what is read from JFLAP and from cpfg is written as JFLAP, TikZ and others have it") {
    // F stands in no word of JFLAP's; a homomorphism that says the angle is the angle.
    const Known koch = known_systems().front();
    const Model of_jflap = read_jflap(jflap_file(koch), "koch.jff"),
                of_cpfg = read_cpfg(cpfg_file(koch), "koch.cpfg");
    CHECK(print_jflap(of_jflap).find("<axiom>g</axiom>") != std::string::npos);
    CHECK(print_tikz(of_cpfg).find("angle=60") != std::string::npos);
    // Not where turns differ, or where some have no number.
    for (const char* rules : {"+ --> +(60)\n- --> -(30)\n", "+ --> +(60)\n"}) {
        const Model other = read_cpfg(
            std::string("Lsystem: 1\nderivation length: 1\nAxiom: F+F-F\nF --> F\nhomomorphism\n") +
                rules + "endlsystem\n",
            "x");
        CHECK(congruent(drawn(other, 1), drawn(read_jflap(print_jflap(other), "y"), 1), false));
    }
}

TEST_CASE("the data about systems of the literature agree with a slow turtle") {
    std::size_t counts = 0, ends = 0;
    for (const Known& system : known_systems()) {
        CAPTURE(system.name);
        for (std::size_t n = 0; n < system.segments.size(); ++n, ++counts)
            CHECK(walked(system.word(n), system.turn(), 0, false).size() - 1 == system.segments[n]);
        if (!system.end) continue;
        ++ends;
        CHECK(
            std::abs(walked(system.word(system.end->first), system.turn(), 0, false).back().first -
                     system.end->second) < 1e-9);
    }
    CHECK(counts >= 110);
    CHECK(ends >= 28);
}

TEST_CASE("systems of the literature in the files of each program draw what its turtle draws") {
    std::map<std::string, std::size_t> systems, figures;
    for (const Original& original : originals())
        for (const Known& system : known_systems()) {
            if (!original.says(system)) continue;
            const std::string file = original.file(system);
            CAPTURE(original.name);
            CAPTURE(file);
            ++systems[original.name];
            const Model model =
                format(original.format).read(file, std::string("figure.") + original.format);
            for (std::size_t n = 0; n < system.segments.size(); ++n) {
                CAPTURE(n);
                Strokes expected =
                    walked(system.word(n), system.turn(), original.heading, original.clockwise);
                const Complex end = expected.back().first;
                expected.pop_back();
                REQUIRE(expected.size() == system.segments[n]);
                CHECK(same(drawn(model, n), expected));
                const auto facts = open_figure(model, n, {}, {}, nullptr)->facts();
                CHECK(close(Complex(facts.end.at(0).value(), facts.end.at(1).value()), end));
                ++figures[original.name];
            }
        }
    std::size_t all = 0;
    for (const Original& original : originals()) {
        CAPTURE(original.name);
        CHECK(systems[original.name] >= 20);
        all += figures[original.name];
    }
    MESSAGE(all << " figures of " << originals().size() << " programs compared, stroke by stroke");
    CHECK(all >= 1100);
}

TEST_CASE("systems of the literature go from each format through each other and stay congruent") {
    // By source and target: how many came back, and how many the target says that it cannot say.
    std::map<std::string, std::map<std::string, std::pair<std::size_t, std::size_t>>> table;
    for (const Original& original : originals())
        for (const Known& system : known_systems()) {
            if (!original.says(system)) continue;
            const std::string file = original.file(system);
            const Model model =
                format(original.format).read(file, std::string("figure.") + original.format);
            const std::size_t n = system.segments.size() - 1;
            const Strokes before = drawn(model, n);
            for (const SystemFormat& target : system_formats()) {
                CAPTURE(original.name);
                CAPTURE(target.name);
                CAPTURE(file);
                auto& [kept, refused] = table[original.name][target.name];
                std::string printed;
                try {
                    printed = target.print(model);
                } catch (const Error& error) {
                    // A reason, which names the format and what it cannot say.
                    const std::string name = target.name == "l" ? "fractint" : target.name;
                    CAPTURE(error.what());
                    CHECK(std::string(error.what()).find(name + " cannot say") !=
                          std::string::npos);
                    ++refused;
                    continue;
                }
                CAPTURE(printed);
                const Model back = target.read(printed, "back." + target.name);
                // Words alone are what Sage and Walnut say.
                if (target.name == "sage" || target.name == "walnut")
                    CHECK(letters(derived_modules(back, n, {}).kinds,
                                  derived_modules(back, n, {}).word)
                              .size() == system.word(n).size());
                else
                    CHECK(congruent(before, drawn(back, n),
                                    target.name == "l" || target.name == "inkscape"));
                ++kept;
            }
        }
    std::string text;
    std::size_t kept = 0, refused = 0;
    for (const auto& [source, targets] : table) {
        text += "\n" + source + ":";
        for (const auto& [target, counts] : targets) {
            text += " " + target + " " + std::to_string(counts.first) + "/" +
                    std::to_string(counts.first + counts.second);
            kept += counts.first;
            refused += counts.second;
        }
    }
    MESSAGE(kept << " of " << kept + refused << " come back:" << text);
    // Each format comes back to itself, and is written for nearly all systems of some other; Walnut says few words of figures.
    CHECK(kept >= 3000);
    for (const Original& original : originals()) {
        CAPTURE(original.name);
        const auto& [same_format, not_said] = table.at(original.name).at(original.format);
        CHECK(same_format >= 20);
        CHECK(not_said == 0);
    }
    for (const SystemFormat& target : system_formats()) {
        CAPTURE(target.name);
        std::size_t most = 0;
        for (const auto& [source, targets] : table)
            most = std::max(most, targets.at(target.name).first);
        CHECK(most >= (target.name == "walnut" ? 12 : 28));
    }
}

namespace {

/// A morphism of the literature over the digits, and how its fixed point begins.
struct KnownMorphism {
    const char *name, *axiom;
    std::vector<std::pair<char, const char*>> images;
    const char* prefix;
};

const std::vector<KnownMorphism>& morphisms() {
    static const std::vector<KnownMorphism> found{
        {"Thue 1906, Morse 1921", "0", {{'0', "01"}, {'1', "10"}}, "0110100110010110"},
        {"Fibonacci", "0", {{'0', "01"}, {'1', "0"}}, "0100101001001010010100100101001001"},
        {"Tribonacci, Rauzy 1982",
         "0",
         {{'0', "01"}, {'1', "02"}, {'2', "0"}},
         "010201001020101020100102"},
        {"4-bonacci",
         "0",
         {{'0', "01"}, {'1', "02"}, {'2', "03"}, {'3', "0"}},
         "01020103010201001020103"},
        {"period doubling", "0", {{'0', "01"}, {'1', "00"}}, "0100010101000100"},
        {"Pell", "0", {{'0', "001"}, {'1', "0"}}, "00100100010010001"},
        {"Cantor", "0", {{'0', "010"}, {'1', "111"}}, "010111010111111111010111010"},
        {"ternary Thue-Morse, squarefree",
         "2",
         {{'2', "210"}, {'1', "20"}, {'0', "1"}},
         "210201210120210201202101"},
        {"Rudin and Shapiro, states",
         "0",
         {{'0', "01"}, {'1', "02"}, {'2', "31"}, {'3', "32"}},
         "0102013101023202"},
        {"paperfolding, states",
         "0",
         {{'0', "01"}, {'1', "21"}, {'2', "03"}, {'3', "23"}},
         "0121032101230321"},
        {"Chacon 1969", "0", {{'0', "0010"}, {'1', "1"}}, "0010001010010"},
        {"Toeplitz, of Jacobs and Keane 1969", "0", {{'0', "01"}, {'1', "00"}}, "01000101"},
        {"silver mean", "0", {{'0', "010"}, {'1', "0"}}, "01000100100100010"},
        {"bronze mean", "0", {{'0', "0001"}, {'1', "0"}}, "00010001000100001000"},
        {"Mephisto waltz", "0", {{'0', "001"}, {'1', "110"}}, "001001110001001110110110001"},
        {"Dejean 1972, images of 0",
         "0",
         {{'0', "0120212012102120210"}, {'1', "1201020120210201021"}, {'2', "2012101201021012102"}},
         "0120212012102120210120102012021"},
        {"Leech 1957",
         "0",
         {{'0', "0121021201210"}, {'1', "1202102012021"}, {'2', "2010210120102"}},
         "01210212012101202102012021"},
        {"Arshon 1937, even",
         "0",
         {{'0', "0123"}, {'1', "1230"}, {'2', "2301"}, {'3', "3012"}},
         "0123123023013012"},
        {"Tribonacci reversed", "0", {{'0', "01"}, {'1', "20"}, {'2', "0"}}, "0120001010120"},
        {"characteristic word of squares",
         "0",
         {{'0', "012"}, {'1', "122"}, {'2', "2"}},
         "01212221222221"},
        {"characteristic word of powers of 2",
         "0",
         {{'0', "01"}, {'1', "12"}, {'2', "22"}},
         "01121222122222221222222222222222"},
        {"Hofstadter's married functions",
         "0",
         {{'0', "01"}, {'1', "2"}, {'2', "02"}},
         "0120201020120"},
    };
    return found;
}

std::string morphic_word(const KnownMorphism& morphism, std::size_t n) {
    std::string now = morphism.axiom;
    for (; n > 0; --n) {
        std::string next;
        for (const char c : now)
            for (const auto& [letter, image] : morphism.images)
                if (letter == c) next += image;
        now = next;
    }
    return now;
}

std::string word_without_blanks(const Model& system, std::size_t n) {
    std::string word = word_of(system, n);
    std::erase(word, ' ');
    return word;
}

}  // namespace

TEST_CASE("morphisms of the literature as Sage and Walnut write them have their words") {
    std::size_t compared = 0, kept = 0;
    for (const KnownMorphism& morphism : morphisms()) {
        CAPTURE(morphism.name);
        std::string sage, walnut, call;
        for (const auto& [letter, image] : morphism.images) {
            sage += (sage.empty() ? "" : ",") + std::string(1, letter) + "->" + image;
            call += (call.empty() ? "" : " ") + std::string(1, letter) + "->" + image;
            walnut += std::string(1, letter) + " -> " + image + "\n";
        }
        const std::pair<const char*, std::string> files[] = {
            {"sage", "m = WordMorphism('" + sage + "')\nm.fixed_point('" + morphism.axiom + "')\n"},
            {"walnut", walnut},
            {"walnut", "morphism h \"" + call + "\";\n"}};
        for (const auto& one : files) {
            const std::string name = one.first, file = one.second;
            CAPTURE(file);
            const Model model = format(name).read(file, "word." + name);
            for (std::size_t n = 0; n < 4; ++n, ++compared)
                CHECK(word_without_blanks(model, n) == morphic_word(morphism, n));
            const std::string prefix = morphism.prefix;
            std::size_t n = 0;
            while (morphic_word(morphism, n).size() < prefix.size()) ++n;
            CHECK(word_without_blanks(model, n).substr(0, prefix.size()) == prefix);
            for (const char* other : {"sage", "walnut"}) {
                const std::string printed = format(other).print(model);
                CAPTURE(printed);
                const Model back = format(other).read(printed, std::string("back.") + other);
                CHECK(word_without_blanks(back, 3) == morphic_word(morphism, 3));
                ++kept;
            }
        }
    }
    CHECK(morphisms().size() >= 20);
    CHECK(compared == morphisms().size() * 12);
    CHECK(kept == morphisms().size() * 6);
}
