#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "exchange/detail/cpfg.hpp"
#include "exchange/detail/scanner.hpp"
#include "exchange/exchange.hpp"
#include "model/model.hpp"

// How a model of cpfg is shown: view files (`*.v`), animation files (`*.a`), and the command line that says which of them belong together.
//
//     angle increment: 22.5            first frame: 0
//     initial line width: 2 pixels     last frame: 12
//     viewpoint: 0 0 1                 step: 1
//
// Both are lines `keyword: values`, behind the same preprocessor as systems; of two lines with one keyword the last holds. What changes where
// lines are drawn is said in the notation or refused. What changes only how they look is said where the notation can, and left out otherwise:
// colours are numbers of a map there, and surfaces and lights are files and numbers of the program's own.
//
// The program's page is the plane of x and y, with y up, seen from z. In the notation z is up. So a viewpoint is said exactly where the
// turtle of the system stands upright along z, as it does where `@v` is used; otherwise figures lie in the page, and only viewpoints above the
// line from below the page to its front keep y upward.

namespace algae {

namespace {

constexpr CpfgDialect cpfg_dialect{};

/// The lines of a file by their keywords.
class Lines {
public:
    Lines(std::string_view text, const std::string& name) : text_(text), source_(text_, name) {
        const Placed whole = preprocessed(source_, cpfg_dialect);
        Placed line;
        const auto add = [&] {
            const Placed said = line.trimmed();
            line = {};
            if (said.text.empty()) return;
            const std::size_t colon = said.text.find(':');
            if (colon == std::string::npos)
                fail(said.place(0),
                     "expected `keyword: values`, such as angle increment: 22.5, "
                     "found '" +
                         said.text.substr(0, 40) + "'");
            const std::string before = said.text.substr(0, colon);
            std::string keyword;
            for (const std::string_view word : blank_separated(before))
                keyword += (keyword.empty() ? "" : " ") + std::string(word);
            check_spelling(keyword, said.place(0));
            values_[keyword].push_back(said.part(colon + 1, said.text.size()).trimmed());
        };
        for (std::size_t i = 0; i < whole.text.size(); ++i)
            if (whole.text[i] == '\n')
                add();
            else
                line.add(whole.text[i], whole.at[i]);
        add();
    }

    [[noreturn]] void fail(std::size_t place, const std::string& message) const {
        cpfg_fail(source_, place, message);
    }

    /// What stands behind a keyword in the last line that has it; nullptr if there is none.
    const Placed* value(const char* keyword) const {
        const auto found = values_.find(keyword);
        return found == values_.end() ? nullptr : &found->second.back();
    }
    /// The same in all lines.
    const std::vector<Placed>& values(const char* keyword) const {
        static const std::vector<Placed> none;
        const auto found = values_.find(keyword);
        return found == values_.end() ? none : found->second;
    }

    /// Words of a value, each with its place.
    std::vector<Placed> words(const Placed& value, const char* separators) const {
        std::vector<Placed> found;
        bool inside = false;
        for (std::size_t i = 0; i < value.text.size(); ++i) {
            const char c = value.text[i];
            const bool is_part = std::string_view(separators).find(c) == std::string_view::npos;
            if (is_part && !inside) found.emplace_back();
            if (is_part) found.back().add(c, value.place(i));
            inside = is_part;
        }
        return found;
    }

    Quantity number(const Placed& text) const {
        try {
            Placed digits = text;
            const std::string said = cpfg_expression(source_, cpfg_dialect, digits, {}, {});
            return evaluate(algae::read_expression(said),
                            [](const std::string&) -> const Quantity* { return nullptr; });
        } catch (const Diagnostics&) {
            fail(text.place(0), "expected a number, found '" + text.text + "'");
        }
    }
    /// The first number behind a keyword; nothing if the keyword does not occur.
    std::optional<Quantity> number(const char* keyword) const {
        const Placed* const found = value(keyword);
        if (!found) return std::nullopt;
        const std::vector<Placed> all = words(*found, " \t,");
        if (all.empty())
            fail(found->place(0), std::string("expected a number behind '") + keyword + ":'");
        return number(all.front());
    }

    std::uint64_t frame(const Placed& text) const {
        const Quantity value = number(text);
        constexpr int most = 1'000'000'000;
        if (!value.exact || !value.exact->is_integer() || sign(*value.exact) < 0 ||
            *value.exact > Rational(most))
            fail(text.place(0),
                 "expected a frame, a whole number from 0 on, found '" + text.text + "'");
        return floor(*value.exact).to_uint64();
    }

private:
    /// Keywords that say nothing here are passed over, but not one that is nearly a keyword with a meaning.
    void check_spelling(const std::string& keyword, std::size_t place) const {
        static const std::vector<std::string> meant{"angle increment",
                                                    "angle factor",
                                                    "initial line width",
                                                    "viewpoint",
                                                    "line width increment",
                                                    "interpretation past %",
                                                    "projection",
                                                    "tropism",
                                                    "torque",
                                                    "initial elasticity",
                                                    "first frame",
                                                    "last frame",
                                                    "step",
                                                    "frame intervals"};
        static const std::vector<std::string> others{"initial color",
                                                     "color increment",
                                                     "initial scale",
                                                     "scale multiplier",
                                                     "scale factor",
                                                     "box",
                                                     "line style",
                                                     "contour",
                                                     "surface",
                                                     "function",
                                                     "twist",
                                                     "view reference point",
                                                     "tropism direction",
                                                     "elasticity increment"};
        if (std::ranges::count(meant, keyword) > 0 || std::ranges::count(others, keyword) > 0)
            return;
        if (const std::string hint = did_you_mean(keyword, meant); !hint.empty())
            fail(place, "expected a keyword of the program, found " + quoted(keyword) + hint);
    }

    std::string text_;
    Source source_;
    std::map<std::string, std::vector<Placed>> values_;
};

bool is_zero(const Quantity& value) { return value.value == 0; }

/// Names of letters that some word of the system holds without parameters.
bool has_bare(const Model& system, std::string_view wanted) {
    const auto holds = [&](const ModuleWord& word) {
        for (std::size_t i = 0; i < word.letters.size(); ++i)
            if (system.alphabet.name(word.letters[i]) == wanted && !word.arguments.contains(i))
                return true;
        return false;
    };
    if (holds(system.axiom)) return true;
    for (const auto* rules : {&system.rules, &system.interpretation})
        for (const Production& rule : *rules)
            if (holds(rule.successor)) return true;
    return false;
}

/// Degrees to a thousandth.
Quantity degrees(double radians) {
    constexpr double half_turn = 180, parts = 1000;
    return quantity(Rational(static_cast<long>(std::lround(radians * half_turn / M_PI * parts)),
                             static_cast<long>(parts)));
}

void set_camera(const Lines& lines, Model& system) {
    const Placed* const point = lines.value("viewpoint");
    const bool upright = system.alphabet.find(cpfg_upward).has_value();
    if (!upright && !system.drawing.camera) return;  // lies in the plane
    double x = 0, y = 0, z = 1;
    if (point) {
        const std::vector<Placed> all = lines.words(*point, " \t,");
        if (all.size() != 3) lines.fail(point->place(0), "expected a viewpoint of three numbers");
        x = lines.number(all[0]).value;
        y = lines.number(all[1]).value;
        z = lines.number(all[2]).value;
    }
    const double length = std::sqrt(x * x + y * y + z * z);
    if (length <= 0) lines.fail(point->place(0), "expected a viewpoint other than 0 0 0");
    CameraSetting camera;
    if (upright)
        camera.from = {degrees(std::atan2(-z, x)), degrees(std::asin(y / length))};
    else if (x == 0 && y <= 0 && z > 0)
        camera.from = {quantity(-90), degrees(std::asin(z / length))};
    else
        return;  // the page lies
    const Placed* const projection = lines.value("projection");
    camera.perspective = projection && projection->text.starts_with("perspective");
    system.drawing.camera = camera;
}

/// What one letter and a colon say in a line `tropism: T: x y z A: a I: i E: e S: s`.
std::map<char, std::vector<Placed>> pull_of(const Lines& lines, const Placed& said) {
    std::map<char, std::vector<Placed>> found;
    std::vector<Placed>* values = nullptr;
    for (const Placed& word : lines.words(said, " \t,")) {
        if (word.text.size() == 2 && word.text[1] == ':') {
            if (std::string_view("TAIES").find(word.text[0]) == std::string_view::npos)
                lines.fail(word.place(0),
                           "expected T:, A:, I:, E: or S:, found " + quoted(word.text));
            values = &found[word.text[0]];
            values->clear();
        } else if (values) {
            values->push_back(word);
        } else {
            lines.fail(word.place(0), "expected T:, A:, I:, E: or S:, found " + quoted(word.text));
        }
    }
    const std::size_t all = 3;
    for (const auto& [letter, numbers] : found)
        if (numbers.size() != (letter == 'T' ? all : 1))
            lines.fail(said.place(0),
                       std::string("expected ") + (letter == 'T' ? "three numbers" : "a number") +
                           " behind " + letter + ":, found " + std::to_string(numbers.size()));
    return found;
}

/// Steps bend before they are made there, by the elasticity times the sine of the angle between the heading and T.
void set_tropism(const Lines& lines, Model& system) {
    using Pull = std::map<char, std::vector<Placed>>;
    const auto number = [&](const Pull& pull, char letter, int otherwise) {
        const auto found = pull.find(letter);
        return found == pull.end() ? quantity(otherwise) : lines.number(found->second.front());
    };
    // Those that bend, from the beginning or by a symbol, which knows them by number.
    struct Line {
        const Placed* said;
        bool is_torque;
    };
    std::vector<Line> all;
    for (const Placed& said : lines.values("tropism")) all.push_back({&said, false});
    for (const Placed& said : lines.values("torque")) all.push_back({&said, true});
    std::ranges::sort(all, {}, [](const Line& line) { return line.said->place(0); });
    std::vector<std::pair<const Placed*, Pull>> pulls;
    std::vector<Symbol> elastic;
    for (std::size_t k = 0; k < all.size(); ++k) {
        const auto& [said, is_torque] = all[k];
        Pull pull = pull_of(lines, *said);
        const auto changes = system.alphabet.find(cpfg_elastic + std::to_string(k + 1));
        if (is_zero(number(pull, 'E', 0)) && !changes) continue;
        if (is_torque)
            lines.fail((pull.contains('E') ? pull.at('E').front() : *said).place(0),
                       "a torque has no meaning in the notation");
        if (changes) elastic = {*changes};
        pulls.emplace_back(said, std::move(pull));
    }
    system.drawing.elastic = elastic;
    if (pulls.empty()) return;
    if (pulls.size() > 1)
        lines.fail(
            pulls[1].first->place(0),
            "a second tropism has no meaning in the notation: expected one with an elasticity "
            "other than 0");
    const auto& [said, pull] = pulls.front();
    if (!is_zero(number(pull, 'A', 0)))
        lines.fail(
            pull.at('A').front().place(0),
            "a tropism towards an angle from T has no meaning in the notation: expected A: 0");
    if (number(pull, 'I', 1).value != 1)
        lines.fail(pull.at('I').front().place(0),
                   "an intensity has no meaning in the notation: expected I: 1");
    if (!pull.contains('T')) lines.fail(said->place(0), "expected T: x y z, the direction");
    std::vector<Quantity> to;
    for (const Placed& part : pull.at('T')) to.push_back(lines.number(part));
    if (is_zero(to[0]) && is_zero(to[1]) && is_zero(to[2]))
        lines.fail(pull.at('T').front().place(0), "expected a direction other than 0 0 0");
    const auto said_of = [](const Quantity& value) {
        return "(" + to_text(value.expression) + ")";
    };
    const auto computed = [](const std::string& formula) {
        return evaluate(read_expression(formula),
                        [](const std::string&) -> const Quantity* { return nullptr; });
    };
    std::string squares;
    for (const Quantity& part : to) squares += (squares.empty() ? "" : "+") + said_of(part) + "^2";
    // An intensity leaves a direction shorter than 1 as it is.
    const bool is_whole = pull.contains('I') && computed(squares).value < 1;
    const std::string length = is_whole ? "" : "/sqrt(" + squares + ")";
    const bool changes = !elastic.empty();
    if (changes)
        for (Quantity& part : to) part = computed(said_of(part) + length);
    system.drawing.susceptibility =
        changes ? number(pull, 'E', 0) : computed(said_of(number(pull, 'E', 0)) + length);
    const bool upright = system.alphabet.find(cpfg_upward).has_value();
    system.drawing.tropism = upright ? Triple{to[0], computed("-" + said_of(to[2])), to[1]}
                                     : Triple{to[0], to[1], to[2]};
    system.drawing.bends_before = true;
}

}  // namespace

Model with_cpfg_view(const Model& system, std::string_view text, const std::string& name) {
    const Lines lines(text, name);
    Model shown = system;
    if (const auto parts = lines.number("angle factor")) {
        if (is_zero(*parts) || !parts->exact)
            lines.fail(lines.value("angle factor")->place(0), "expected a number other than 0");
        shown.drawing.angle = quantity(Rational(360) / *parts->exact);
    }
    if (const auto angle = lines.number("angle increment")) shown.drawing.angle = angle;
    if (const auto width = lines.number("initial line width")) {
        if (width->value <= 0)
            lines.fail(lines.value("initial line width")->place(0), "expected a width above 0");
        shown.drawing.width = width;
    }
    for (const char* what : {"line width increment"})
        if (const auto more = lines.number(what);
            more && !is_zero(*more) && (has_bare(system, "!") || has_bare(system, "X_35")))
            lines.fail(
                lines.value(what)->place(0),
                "widths that grow by a number have no meaning in the notation: say the width "
                "behind each ! and #");
    if (const Placed* past = lines.value("interpretation past %");
        past && past->text == "on" && has_bare(system, "%"))
        lines.fail(past->place(0),
                   "what stands past % is never drawn in the notation: expected 'off'");
    set_tropism(lines, shown);
    if (const auto old = lines.number("initial elasticity"); old && !is_zero(*old))
        lines.fail(lines.value("initial elasticity")->place(0),
                   "the older tropism turns by an arc sine there, in the notation by a product");
    set_camera(lines, shown);
    return shown;
}

std::pair<std::uint64_t, std::uint64_t> cpfg_frames(std::string_view text,
                                                    const std::string& name) {
    const Lines lines(text, name);
    if (const Placed* intervals = lines.value("frame intervals")) {
        std::set<std::uint64_t> frames;
        constexpr std::size_t most = 1'000'000;
        for (const Placed& one : lines.words(*intervals, ",")) {
            std::vector<Placed> parts = lines.words(one, " \t");
            std::uint64_t step = 1;
            if (parts.size() == 3 && parts[1].text == "step") step = lines.frame(parts[2]);
            if (step == 0 || (parts.size() != 1 && parts.size() != 3))
                lines.fail(one.place(0), "expected a frame or an interval, 3-5 or 10-16 step 2");
            const std::vector<Placed> ends = lines.words(parts[0], "-");
            const std::uint64_t first = lines.frame(ends.front()), last = lines.frame(ends.back());
            for (std::uint64_t n = first; n <= last && frames.size() < most; n += step)
                frames.insert(n);
        }
        if (frames.empty()) lines.fail(intervals->place(0), "expected frames, found none");
        if (*frames.rbegin() - *frames.begin() + 1 != frames.size())
            lines.fail(intervals->place(0),
                       "frames that are no range have no meaning in the notation: expected an "
                       "interval such as 0-12");
        return {*frames.begin(), *frames.rbegin()};
    }
    const Placed *first = lines.value("first frame"), *last = lines.value("last frame"),
                 *step = lines.value("step");
    if (!last) throw Error(name + ": expected a line 'last frame: N', found none");
    if (step && lines.frame(*step) != 1)
        lines.fail(step->place(0),
                   "frames that are no range have no meaning in the notation: expected 'step: 1'");
    const std::pair<std::uint64_t, std::uint64_t> found{first ? lines.frame(*first) : 0,
                                                        lines.frame(*last)};
    if (found.first > found.second)
        lines.fail(last->place(0), "expected a last frame behind the first");
    return found;
}

CpfgFiles cpfg_files(std::string_view text, const std::string& name) {
    CpfgFiles found;
    for (std::size_t begin = 0; begin < text.size() && found.system.empty();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string line(text.substr(begin, end - begin));
        begin = end + 1;
        const auto words = blank_separated(line);
        if (std::ranges::none_of(words, [](std::string_view word) {
                return word == "cpfg" || word.ends_with("/cpfg");
            }))
            continue;
        for (const std::string_view word : words) {
            if (word.find('/') != std::string_view::npos) continue;
            if (word.ends_with(".l")) found.system = word;
            if (word.ends_with(".v")) found.view = word;
            if (word.ends_with(".a")) found.animation = word;
        }
    }
    if (found.system.empty())
        throw Error(name +
                    ": expected a command line such as `cpfg plant.l plant.v`, found none that "
                    "names a system");
    return found;
}

}  // namespace algae
