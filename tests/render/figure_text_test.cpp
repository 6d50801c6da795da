#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <nlohmann/json.hpp>

#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <sstream>
#include <string_view>

#include "exact/exact.hpp"
#include "model/model.hpp"
#include "oracle/turtle.hpp"
#include "oracle/written_system.hpp"
#include "render/detail/figure_text.hpp"
#include "render/figures.hpp"
#include "render/render.hpp"

using namespace algae;
using namespace algae::test;

namespace {

std::string written(const Figure& figure, FigureFormat format, bool plotter = false,
                    FigureTextDrawn* drawn = nullptr, const std::string& caption = "") {
    std::ostringstream out;
    FigureTextOptions options;
    options.plotter = plotter;
    const FigureSource source{{&figure, "generation 3 of koch", caption}};
    const FigureTextDrawn found = draw_as_text({&source, 1}, out, format, options, Budget{});
    if (drawn) *drawn = found;
    return out.str();
}

std::string written_svg(const Figure& figure, FigureTextDrawn& drawn) {
    return written(figure, FigureFormat::svg, false, &drawn);
}

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

using Bar = std::pair<std::pair<int, int>, std::pair<int, int>>;

/// Segments of a lattice, drawn one after the other; a segment goes on from the last one if it can.
DrawnFigure lattice_figure(const std::vector<Bar>& segments) {
    return DrawnFigure([segments](Canvas& canvas, double) {
        std::pair<int, int> pen{1 << 20, 0};
        for (const auto& [from, to] : segments) {
            const auto point = [](std::pair<int, int> p) {
                return Point{static_cast<double>(p.first), static_cast<double>(p.second)};
            };
            if (pen != from) canvas.move_to(point(from));
            canvas.line_to(point(to));
            pen = to;
        }
    });
}

std::vector<Bar> any_segments(int size, int most) {
    std::vector<Bar> found;
    const int count = *rc::gen::inRange(1, most);
    for (int i = 0; i < count; ++i) {
        const auto coordinate = [&] { return *rc::gen::inRange(0, size); };
        const Bar one{{coordinate(), coordinate()}, {coordinate(), coordinate()}};
        if (one.first != one.second) found.push_back(one);
    }
    return found;
}

Bar undirected(Bar one) {
    if (one.second < one.first) std::swap(one.first, one.second);
    return one;
}

/// The least number of trails through all of these segments: of each component half of its odd ends, or 1.
std::size_t least_trails(const std::set<Bar>& segments) {
    std::map<std::pair<int, int>, std::pair<int, int>> leader;
    const auto root = [&](std::pair<int, int> p) {
        while (leader[p] != p) p = leader[p];
        return p;
    };
    std::map<std::pair<int, int>, int> degree;
    for (const auto& [from, to] : segments)
        for (const auto& end : {from, to}) {
            leader.try_emplace(end, end);
            ++degree[end];
        }
    for (const auto& [from, to] : segments) leader[root(from)] = root(to);
    std::map<std::pair<int, int>, std::size_t> odd;
    for (const auto& [end, count] : degree) odd[root(end)] += count % 2 == 1 ? 1 : 0;
    std::size_t sum = 0;
    for (const auto& [component, ends] : odd) sum += std::max<std::size_t>(1, ends / 2);
    return sum;
}

/// The value of a sum that exact_part writes, read by a reader that shares nothing with it.
double value_of(const std::string& text) {
    double sum = 0;
    for (std::size_t at = 0; at < text.size();) {
        double sign = 1;
        if (text[at] == '+' || text[at] == '-') sign = text[at++] == '-' ? -1 : 1;
        std::size_t end = at;
        for (int depth = 0; end < text.size(); ++end) {
            if (text[end] == '(') ++depth;
            if (text[end] == ')') --depth;
            if (depth == 0 && (text[end] == '+' || text[end] == '-')) break;
        }
        std::string term = text.substr(at, end - at);
        double factor = 1;
        if (const auto root = term.find("sqrt("); root != std::string::npos) {
            const auto close = term.find(')', root);
            factor *= std::sqrt(std::stod(term.substr(root + 5)));
            term = term.substr(0, root) + "1" + term.substr(close + 1);
        } else if (const auto cosine = term.find("cos("); cosine != std::string::npos) {
            const auto close = term.find(')', cosine);
            const std::string inside = term.substr(cosine + 4, close - cosine - 4);
            const double times = inside.starts_with("pi") ? 1 : std::stod(inside);
            factor *=
                std::cos(times * std::numbers::pi / std::stod(inside.substr(inside.find('/') + 1)));
            term = term.substr(0, cosine) + "1" + term.substr(close + 1);
        }
        std::istringstream in(term);
        double number = 0;
        in >> number;
        factor *= number;
        for (char sign_of_term; in >> sign_of_term >> number;)
            factor = sign_of_term == '*' ? factor * number : factor / number;
        sum += sign * factor;
        at = end;
    }
    return sum;
}

/// The lines that SVG paths say, in the points of the page. A figure of many strokes is in units of its own.
std::vector<std::vector<Point>> svg_lines(const std::string& svg) {
    std::vector<std::vector<Point>> lines;
    double unit = 1;
    if (const std::size_t scale = svg.find("transform=\"scale("); scale != std::string::npos)
        unit = std::stod(svg.substr(scale + 17));
    for (std::size_t at = svg.find(" d=\""); at != std::string::npos;
         at = svg.find(" d=\"", at + 1)) {
        const std::string_view path =
            std::string_view(svg).substr(at + 4, svg.find('"', at + 4) - at - 4);
        Point here;
        char command = ' ';
        std::size_t i = 0;
        const auto number = [&] {
            while (i < path.size() && path[i] == ' ') ++i;
            std::size_t end = i + 1;
            while (end < path.size() && (std::isdigit(path[end]) || path[end] == '.')) ++end;
            double value = 0;
            std::from_chars(path.data() + i, path.data() + end, value);
            i = end;
            return value;
        };
        while (i < path.size()) {
            if (std::isalpha(path[i])) command = path[i++];
            if (command == 'z') continue;
            if (command != 'v') here.x += number();
            if (command != 'h') here.y += number();
            if (command == 'm') lines.emplace_back();
            lines.back().push_back({unit * here.x, unit * here.y});
            if (command == 'm') command = 'l';
        }
    }
    return lines;
}

}  // namespace

TEST_CASE("the formats of figures as text, by their names") {
    CHECK(figure_format("a.b/KOCH.TEX") == FigureFormat::tex);
    CHECK(figure_format("koch.typ") == FigureFormat::typ);
    CHECK(figure_format("koch.csv") == FigureFormat::csv);
    CHECK(figure_format("koch.geojson") == FigureFormat::geojson);
    CHECK(figure_format("koch.dxf") == FigureFormat::dxf);
    CHECK(figure_format("koch.html") == FigureFormat::html);
    CHECK(!figure_format("koch.svg"));
    CHECK(!figure_format("koch"));
    CHECK(figure_format_name(FigureFormat::svg) == std::string("svg"));
    CHECK(figure_format_name(FigureFormat::dxf) == std::string("dxf"));
}

TEST_CASE("exact coordinates have the value of the number") {
    std::size_t compared = 0;
    CHECK(rc::check([&] {
        const long order =
            *rc::gen::element(1L, 3L, 4L, 5L, 8L, 10L, 12L, 16L, 20L, 24L, 28L, 36L, 40L);
        const CyclotomicRing ring(order);
        CyclotomicInteger number = ring.zero();
        for (Integer& part : number.coefficients) part = *rc::gen::inRange(-9, 10);
        const int above = *rc::gen::inRange(1, 9), below = *rc::gen::inRange(1, 9);
        const int first = *rc::gen::inRange(-9, 9), second = *rc::gen::inRange(1, 9);
        const Rational factor(above, below), offset(first, second);
        const auto value = ring.to_complex(number);
        const double times = 1.0 * above / below, more = 1.0 * first / second;
        const std::string real = exact_part(ring, number, false, factor, offset);
        const std::string imaginary = exact_part(ring, number, true, factor, offset);
        RC_ASSERT(std::fabs(value_of(real) - (times * value.real() + more)) < 1e-9);
        RC_ASSERT(std::fabs(value_of(imaginary) - (times * value.imag() + more)) < 1e-9);
        ++compared;
    }));
    CHECK(compared >= 90);
    const CyclotomicRing ring(12);
    CHECK(exact_part(ring, ring.zeta(1), false, 3, 0) == "3*sqrt(3)/2");
    CHECK(exact_part(ring, ring.zeta(1), true, 3, Rational(-1, 2)) == "1");
    CHECK(exact_part(ring, ring.zero(), true, 3, 0) == "0");
    CHECK(exact_part(CyclotomicRing(20), CyclotomicRing(20).zeta(1), false, 1, 0) == "cos(pi/10)");
}

TEST_CASE("a plotter draws each segment once, in as few paths as there can be") {
    std::size_t compared = 0, single = 0;
    CHECK(rc::check([&] {
        const std::vector<Bar> segments = any_segments(*rc::gen::inRange(2, 6), 40);
        if (segments.empty()) return;
        const DrawnFigure figure = lattice_figure(segments);
        FigureTextDrawn drawn;
        const auto document =
            nlohmann::json::parse(written(figure, FigureFormat::geojson, true, &drawn));
        std::multiset<Bar> found;
        for (const auto& feature : document["features"]) {
            const auto& points = feature["geometry"]["coordinates"];
            for (std::size_t i = 1; i < points.size(); ++i) {
                const auto at = [&](std::size_t k) {
                    return std::pair(points[k][0].get<int>(), points[k][1].get<int>());
                };
                found.insert(undirected({at(i - 1), at(i)}));
            }
        }
        std::set<Bar> wanted;
        for (const Bar& one : segments) wanted.insert(undirected(one));
        RC_ASSERT(found == std::multiset<Bar>(wanted.begin(), wanted.end()));
        RC_ASSERT(drawn.strokes == wanted.size());
        RC_ASSERT(drawn.strokes + drawn.repeated == segments.size());
        RC_ASSERT(drawn.paths == least_trails(wanted));
        single += drawn.paths == 1 ? 1 : 0;
        ++compared;
    }));
    CHECK(compared >= 50);
    CHECK(single >= 3);
}

TEST_CASE("points of svg do not drift, and are right to a hundredth of a point") {
    std::size_t compared = 0;
    CHECK(rc::check([&] {
        const std::vector<Bar> segments = any_segments(200, 60);
        if (segments.empty()) return;
        const DrawnFigure figure = lattice_figure(segments);
        const Box& box = figure.box();
        if (box.breadth() == 0 || box.height() == 0) return;
        const auto lines = svg_lines(written(figure, FigureFormat::svg));
        const double scale = 580 / std::max(box.breadth(), box.height());
        std::size_t i = 0;
        for (const auto& line : lines)
            for (std::size_t k = 1; k < line.size(); ++k, ++i) {
                RC_ASSERT(i < segments.size());
                const auto near = [&](Point there, std::pair<int, int> point) {
                    return std::fabs(there.x - (10 + scale * (point.first - box.low.x))) < 0.006 &&
                           std::fabs(there.y - (10 + scale * (box.high.y - point.second))) < 0.006;
                };
                RC_ASSERT(near(line[k - 1], segments[i].first));
                RC_ASSERT(near(line[k], segments[i].second));
            }
        RC_ASSERT(i == segments.size());
        ++compared;
    }));
    CHECK(compared >= 50);
}

TEST_CASE("units of svg are fine where strokes are short, and exact in single precision") {
    CHECK(svg_units(600, 1) == 100);
    CHECK(svg_units(600, 0.15) == 1000);
    CHECK(svg_units(600, 0.001) == 10'000);
    CHECK(svg_units(600, 0) == 10'000);
    CHECK(svg_units(14'400, 0) == 1000);
}

TEST_CASE(
    "curves on a lattice are in svg within a unit of their places, and no stroke is left out") {
    std::mt19937 chance(21);
    const auto any = [&](std::size_t bound) { return static_cast<std::size_t>(chance() % bound); };
    std::size_t compared = 0, with_blocks = 0, broken = 0;
    for (int attempt = 0; attempt < 400 && compared < 24; ++attempt) {
        // Systems whose strokes become at least three times as many in a step.
        constexpr std::string_view letters = "FFGX+-+-|f";
        const auto word = [&](std::size_t length) {
            std::string found;
            while (found.size() < length) found += letters[any(letters.size())];
            return found;
        };
        std::string successor = "F" + word(any(3)) + "F" + word(any(3));
        if (any(2) == 0) successor += "[" + word(3) + "]";
        successor += "F";
        const oracle::WrittenSystem written{"F" + word(2),
                                            {{'F', {successor}}, {'X', {"X" + word(2)}}}};
        oracle::TurtleSettings settings;
        constexpr std::array angles{90L, 60L, 45L, 36L, 120L, 25L};
        settings.angle = {angles[any(angles.size())], 1};
        settings.heading = {static_cast<long>(45 * any(4)), 1};
        settings.x = {static_cast<long>(any(9)), 3};
        const Model system{oracle::lsystem_of(written), oracle::settings_of(settings), {}, {}};
        std::unique_ptr<Figure> figure;
        for (unsigned n = 1; !figure || *figure->strokes() < 100'000; ++n)
            figure = algae::figure(system, n, Budget{});
        const Box& box = figure->box();
        if (*figure->strokes() > 400'000 || box.breadth() * box.height() == 0) continue;
        CAPTURE(successor);
        CAPTURE(settings.angle.numerator);

        struct Strokes : Canvas {  // keeps no blocks
            void move_to(Point point) override { lines.push_back({point}); }
            void line_to(Point point) override { lines.back().push_back(point); }
            void polygon(std::span<const Point>) override {}
            std::vector<std::vector<Point>> lines;
        } slow;
        figure->draw(slow, 0, Budget{});
        struct Blocks : BlockCanvas {
            void move_to(Point) override {}
            void line_to(Point) override {}
            void polygon(std::span<const Point>) override {}
            void block(const StrokeBlock& block, Point) override {
                ++(block.strokes.empty() ? promises : blocks);
            }
            std::size_t blocks = 0, promises = 0;  // an empty one says that the style is kept
        } fast;
        figure->draw(fast, 0, Budget{});
        with_blocks += fast.blocks > 0 ? 1 : 0;
        CHECK(fast.promises == (fast.blocks > 0 ? 0 : 1));

        FigureTextDrawn drawn;
        const auto lines = svg_lines(written_svg(*figure, drawn));
        CHECK(drawn.strokes == *figure->strokes());
        REQUIRE(lines.size() == slow.lines.size());
        const double scale = 580 / std::max(box.breadth(), box.height());
        const double unit =
            1.001 / svg_units(std::max(drawn.width, drawn.height), scale * figure->facts().step);
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            REQUIRE(lines[i].size() == slow.lines[i].size());
            for (std::size_t k = 0; k < lines[i].size(); ++k) {
                const Point there = lines[i][k], point = slow.lines[i][k];
                const bool near =
                    std::fabs(there.x - (10 + scale * (point.x - box.low.x))) <= unit &&
                    std::fabs(there.y - (10 + scale * (box.high.y - point.y))) <= unit;
                wrong += near ? 0 : 1;
            }
        }
        CHECK(wrong == 0);
        broken += lines.size() > 1 ? 1 : 0;
        ++compared;
    }
    CHECK(compared == 24);
    CHECK(with_blocks >= 10);
    CHECK(with_blocks < compared);  // an angle whose ring is too large
    CHECK(broken >= 5);
}

TEST_CASE("each colour of a figure in svg has an id") {
    const DrawnFigure figure([](Canvas& canvas, double) {
        canvas.move_to({0, 0});
        for (const std::uint32_t colour : {0U, 1U, 0U}) {
            canvas.colour(colour);
            canvas.line_to({1.0 + colour, 1});
            canvas.line_to({2.0 + colour, 0});
        }
    });
    DrawnFigure coloured = figure;
    coloured.own.colours = {"red", "blue"};
    const std::string svg = written(coloured, FigureFormat::svg);
    std::size_t at = 0;
    for (const char* id : {"<g id=\"figure-1\"", "<g id=\"figure-1-colour-1\">",
                           "<g id=\"figure-1-colour-2\">", "<g id=\"figure-1-colour-1-2\">"}) {
        at = svg.find(id, at);
        CHECK_MESSAGE(at != std::string::npos, id);
    }
    const auto count = [&](const std::string& part) {
        std::size_t found = 0;
        for (std::size_t i = svg.find(part); i != std::string::npos; i = svg.find(part, i + 1))
            ++found;
        return found;
    };
    CHECK(count("<g ") == 4);
    CHECK(count("</g>") == 4);
}

TEST_CASE("colours, widths and captions in figures as text") {
    DrawnFigure figure([](Canvas& canvas, double) {
        canvas.move_to({0, 0});
        canvas.line_to({1, 0});
        canvas.colour(1);
        canvas.width(2);
        canvas.line_to({1, 1});
        const Point corners[] = {{0, 0}, {1, 0}, {0, 1}};
        canvas.polygon(corners);
    });
    figure.own.colours = {"black", "red"};
    const std::string tex = written(figure, FigureFormat::tex, false, nullptr, "50% of F_l");
    CHECK(holds(tex, "\\definecolor{algae2}{RGB}{255,0,0}"));
    CHECK(holds(tex, "\\draw[colour 1, width 1]\n  (0,0) -- (1,0);"));
    CHECK(holds(tex, "\\draw[colour 2, width 2]\n  (1,0) -- (1,1);"));
    CHECK(holds(tex, "\\fill[colour 2]\n  (0,0) -- (1,0) -- (0,1) -- cycle;"));
    CHECK(holds(tex, "{50\\% of F\\_l}"));
    const std::string typst = written(figure, FigureFormat::typ, false, nullptr, "a \"b\"");
    CHECK(holds(typst, "#let colour-2 = rgb(\"#ff0000\")"));
    CHECK(holds(typst, "\"a \\\"b\\\"\""));
    const std::string svg = written(figure, FigureFormat::svg, false, nullptr, "a < b");
    CHECK(holds(svg, "<path class=\"stroke colour-2 width-2\""));
    CHECK(holds(svg, ">a &lt; b</text>"));
    CHECK(holds(svg, "<title>generation 3 of koch</title>"));
    const std::string csv = written(figure, FigureFormat::csv);
    CHECK(csv ==
          "path,kind,letter,position,colour,width,x1,y1,x2,y2,length\r\n"
          "1,stroke,,,#000000,1,0,0,1,0,1\r\n2,stroke,,,#ff0000,2,1,0,1,1,1\r\n"
          "3,side,,,#ff0000,2,0,0,1,0,1\r\n3,side,,,#ff0000,2,1,0,0,1,1.4142135623730951\r\n"
          "3,side,,,#ff0000,2,0,1,0,0,1\r\n");
    const auto json = nlohmann::json::parse(written(figure, FigureFormat::geojson));
    CHECK(json["features"][2]["geometry"]["type"] == "Polygon");
    CHECK(json["features"][2]["geometry"]["coordinates"][0].size() == 4);
    const std::string page = written(figure, FigureFormat::html, false, nullptr, "");
    CHECK(page.starts_with("<!DOCTYPE html>"));
    CHECK(!holds(page, "http"));
}

TEST_CASE("dxf is pairs of codes and values, with a layer for each colour") {
    DrawnFigure figure([](Canvas& canvas, double) {
        canvas.move_to({0, 0});
        canvas.line_to({1, 0});
        canvas.colour(1);
        canvas.line_to({1, 1});
        canvas.line_to({0, 1});
    });
    figure.own.colours = {"black", "red"};
    std::istringstream in(written(figure, FigureFormat::dxf));
    std::vector<std::pair<int, std::string>> pairs;
    for (std::string code, value; std::getline(in, code) && std::getline(in, value);)
        pairs.emplace_back(std::stoi(code), value);
    REQUIRE(pairs.back() == std::pair<int, std::string>(0, "EOF"));
    std::map<std::string, int> kinds;
    std::set<std::pair<std::string, std::string>> layers;
    int depth = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (pairs[i].first != 0) continue;
        ++kinds[pairs[i].second];
        depth += pairs[i].second == "SECTION" ? 1 : pairs[i].second == "ENDSEC" ? -1 : 0;
        CHECK((depth == 0 || depth == 1));
        if (pairs[i].second == "LAYER") layers.emplace(pairs[i + 1].second, pairs[i + 3].second);
    }
    CHECK(kinds["LINE"] == 1);
    CHECK(kinds["POLYLINE"] == 1);
    CHECK(kinds["VERTEX"] == 3);
    CHECK(layers == std::set<std::pair<std::string, std::string>>{{"COLOUR_000000", "7"},
                                                                  {"COLOUR_FF0000", "1"}});
}

TEST_CASE("names of letters in documents") {
    CHECK(letter_latex("F_l") == "F_{l}");
    CHECK(letter_latex("F_12") == "F_{12}");
    CHECK(letter_latex("wall") == "\\mathit{wall}");
    CHECK(letter_latex("[") == "{[}");
    CHECK(letter_latex("ε") == "\\varepsilon");
    CHECK(plain_name("F_l") == "F_l");
    CHECK(plain_name("+") == "u2B");
    CHECK(fixed_text(-1e-9, 6) == "0");
    CHECK(fixed_text(100, 2) == "100");
    CHECK(escaped_latex("a_b\\c 60°") == "a\\_b\\textbackslash{}c 60$^\\circ$");
    // A quotation mark of every font encoding.
    CHECK(escaped_latex("say \"a\"") == "say \\char34{}a\\char34{}");
}

TEST_CASE("currentColor is the colour of the text around an svg, and black elsewhere") {
    FigureTextOptions options;
    options.picture.colours = {"currentColor", "red"};
    options.picture.scale_bar = true;
    const DrawnFigure figure = koch(2);
    const FigureSource source{{&figure, "koch", "a caption"}};
    std::ostringstream svg, tex;
    draw_as_text({&source, 1}, svg, FigureFormat::svg, options, Budget{});
    draw_as_text({&source, 1}, tex, FigureFormat::tex, options, Budget{});
    CHECK(svg.str().find(".stroke.colour-1 { stroke: currentColor }") != std::string::npos);
    CHECK(svg.str().find("px; fill: currentColor }") != std::string::npos);
    CHECK(svg.str().find("#000") == std::string::npos);
    CHECK(tex.str().find("current") == std::string::npos);
    CHECK(colour_named("CURRENTcolor") == Colour{});
}
