// Figures as text by the command: TikZ, Typst, tables, GeoJSON, DXF, pages, SVG with names, and what a plotter is told.

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "command/run.hpp"

using nlohmann::json;

namespace {

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::size_t occurrences(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++count;
    return count;
}

}  // namespace

TEST_CASE("draw writes TikZ with a style for each letter") {
    const Run tex = run("draw gosper -n 1 --format tex -o -");
    CHECK(tex.status == 0);
    CHECK(holds(tex.out, "letter F_l/.style={}"));
    CHECK(holds(tex.out, "letter F_r/.style={}"));
    CHECK(holds(tex.out, "\\draw[colour 1, letter F_l]"));
    const Run panels = run("draw koch -n 0..2 --panels --captions --format tex -o -");
    CHECK(occurrences(panels.out, "\\begin{scope}") == 3);
    CHECK(holds(panels.out, "{Koch curve, n = 2, 60$^\\circ$}"));
    CHECK(
        holds(run("draw koch -n 0..2 --format tex -o -").err, "several generations need --panels"));
    CHECK(holds(run("draw koch -n 2 -o x.tikz").err, "a figure as text in .tex, .typ, .csv"));
    CHECK(holds(run("draw koch -n 2 -o -").err, "tex, typ, csv, geojson, dxf, html"));
}

TEST_CASE("tables have exact coordinates where the figure is exact") {
    const Run csv = run("draw koch -n 1 --format csv -o -");
    CHECK(csv.out ==
          "path,kind,letter,position,colour,width,x1,y1,x2,y2,length,exact_x1,exact_y1,exact_x2,"
          "exact_y2\r\n"
          "1,stroke,F,0,#000000,1,0,0,1,0,1,0,0,1,0\r\n"
          "1,stroke,F,2,#000000,1,1,0,1.5,0.8660254037844387,1,1,0,3/2,sqrt(3)/2\r\n"
          "1,stroke,F,5,#000000,1,1.5,0.8660254037844387,2,0,1,3/2,sqrt(3)/2,2,0\r\n"
          "1,stroke,F,7,#000000,1,2,0,3,0,1,2,0,3,0\r\n");
    CHECK(holds(run("draw 'F -> F[+F]F; angle 20' -n 1 --format csv -o -").out, "cos(pi/9)"));
    const json parametric =
        json::parse(run("draw 'axiom F(1); F(x) -> F(x*0.3)+F(x)' -n 2 --format geojson -o -").out);
    CHECK(!parametric["features"][0]["properties"].contains("exact"));
    CHECK(parametric["features"][0]["properties"]["letter"] == "F");
    const json dragon = json::parse(run("draw dragon -n 4 --format geojson -o -").out);
    CHECK(dragon["features"].size() >= 1);
    const Scratch scratch;
    const json facts =
        json::parse(run("draw koch -n 3 -o " + scratch.file("k.csv") + " --json").out);
    CHECK(facts["strokes"] == 64);
    CHECK(facts["exact"] == true);
    CHECK(facts["format"] == "csv");
}

TEST_CASE("a figure in space is written in the order of its depth, without letters") {
    const Run space = run("draw honda-a -n 3 --format csv -o -");
    CHECK(space.status == 0);
    CHECK(space.out.starts_with("path,kind,letter,position,"));
    CHECK(holds(space.out, ",side,,,#"));
}

TEST_CASE("several generations stand in one table") {
    const Run csv = run("draw koch -n 0..1 --format csv -o -");
    CHECK(csv.out.starts_with("figure,path,"));
    CHECK(occurrences(csv.out, "generation 1 of koch,") == 4);
    CHECK(holds(run("draw koch -n 0..1 --format dxf -o -").out, "FIGURE_2_COLOUR_000000"));
}

TEST_CASE("svg has a title, and a group and classes to address its parts by") {
    const Run svg = run("draw gosper -n 1 --format svg --author 'A. B.' --captions -o -");
    CHECK(holds(svg.out, "<title>"));
    CHECK(holds(svg.out, "By A. B.."));
    CHECK(holds(svg.out, "<g id=\"figure-1\" class=\"figure\">"));
    CHECK(holds(svg.out, "class=\"stroke colour-1 letter-F_l\""));
    CHECK(holds(svg.out, "<text class=\"caption\""));
    // A Hilbert curve takes few bytes a stroke.
    const Run hilbert = run("draw hilbert-002 -n 7 --format svg -o -");
    CHECK(hilbert.out.size() < 16383 * 12);
}

TEST_CASE("a plotter is told how many paths there are") {
    const Scratch scratch;
    const std::string out = " --plotter -o " + scratch.file("x.svg");
    // The square is drawn twice.
    const Run square = run("draw 'axiom F+F+F+F+F+F+F+F' -n 0" + out + " --json");
    CHECK(holds(square.err, "4 segments in 1 path, one stroke: an Euler path; 4 were repeated"));
    CHECK(json::parse(square.out)["paths"] == 1);
    const Run tree = run("draw plant-f -n 3" + out);
    CHECK(holds(tree.err, "the pen is up for"));
    CHECK(holds(run("draw koch -n 2 --plotter -o " + scratch.file("x.png")).err,
                "--plotter: expected svg, tex, typ, csv, geojson, dxf or html, found png"));
}

TEST_CASE("the program of a page draws every stroke, and goes back to earlier ones") {
    if (std::system("command -v node >/dev/null") != 0) {
        MESSAGE("there is no node here: the program of the page was NOT run");
        return;
    }
    const Scratch scratch;
    CHECK(run("draw koch -n 0..3 -o " + scratch.file("k.html")).status == 0);
    // A document of its own, which counts what is drawn.
    const std::string program = scratch.file("run.js", R"(
const fs = require("fs"), page = fs.readFileSync(process.argv[2], "utf8");
const elements = {}; let lines = 0;
const pen = new Proxy({}, {get: (t, k) => k in t ? t[k] : () => { if (k === "lineTo") ++lines; },
                           set: (t, k, v) => (t[k] = v, true)});
const element = id => elements[id] = elements[id] ||
    {value: 0, clientWidth: 600, clientHeight: 400, dataset: {}, getContext: () => pen};
global.document = {getElementById: element, title: ""};
global.window = {devicePixelRatio: 1};
global.location = {hash: ""};
global.cancelAnimationFrame = () => {};
eval(page.match(/<script>([^]*)<\/script>/)[1]);
console.log(document.title, elements.count.textContent, lines);
elements.generation.value = 1;
elements.generation.oninput();
elements.strokes.value = 2;
lines = 0;
elements.strokes.oninput();
console.log(elements.name.textContent, elements.count.textContent, lines);
)");
    const std::string out = scratch.file("out");
    REQUIRE(std::system(
                ("node '" + program + "' " + scratch.file("k.html") + " >'" + out + "'").c_str()) ==
            0);
    CHECK(text_of(out) ==
          "generation 3 of koch 64 of 64, F 64\ngeneration 1 of koch 2 of 4, F 2\n");
}

TEST_CASE("generators are written as text too") {
    const Run walk = run("draw weierstrass --format csv -o -");
    CHECK(walk.status == 0);
    CHECK(holds(walk.out, "path,kind,letter,"));
}

TEST_CASE("trees for LaTeX") {
    const Run tree = run("tree anabaena -n 2 --format tex -o -");
    CHECK(holds(tree.out, "\\begin{forest}"));
    CHECK(holds(tree.out, "[{$"));
    const Run two = run("tree 'axiom ab; a -> ab; b -> a' -n 2 --format tex -o -");
    CHECK(holds(two.out, "[, phantom"));
    CHECK(holds(run("tree signal -n 3 --format tex -o -").out, "\\draw[context]"));
    CHECK(holds(run("tree fibonacci --graph --format tex -o -").out, "\\begin{tikzpicture}"));
    CHECK(holds(run("tree anabaena -n 2 --width 100 --format tex -o -").err,
                "--width: a figure for LaTeX has the size that its text needs"));
}

TEST_CASE("the page of a figure needs nothing but itself") {
    const Run page = run("draw koch -n 0..3 --format html -o -");
    CHECK(page.status == 0);
    CHECK(page.out.starts_with("<!DOCTYPE html>"));
    CHECK(!holds(page.out, "http"));
    CHECK(occurrences(page.out, "{name: ") == 4);
}

TEST_CASE("svg of a curve takes few bytes a stroke, and offers --raster beyond 2 MB") {
    const Scratch scratch;
    const std::string path = scratch.file("k.svg");
    CHECK(!holds(run("draw koch -n 9 -o " + path).err, "--raster"));
    CHECK(text_of(path).size() < 262'144 * 12);
    CHECK(holds(run("draw koch -n 10 -o " + path).err,
                "every stroke is in it; --raster puts an image in their place"));
    CHECK(text_of(path).size() > 2'000'000);
    const Run image = run("draw koch -n 10 --raster -o " + path);
    CHECK(image.status == 0);
    CHECK(!holds(image.err, "every stroke"));
    CHECK(holds(text_of(path), "data:image/png;base64"));
    CHECK(text_of(path).size() < 2'000'000);
    CHECK(holds(run("draw koch -n 3 --raster -o " + scratch.file("k.png")).err,
                "--raster: puts an image into svg, pdf, ps or eps"));
}

TEST_CASE("svg of too many strokes is refused at once, with the way out") {
    const Scratch scratch;
    const std::string path = scratch.file("d.svg");
    const Run dragon = run("draw dragon -n 60 -o " + path);
    CHECK(dragon.status == 2);
    CHECK(
        dragon.err ==
        "algae: generation 60 of dragon has 1152921504606846976 strokes, about 5 EB: expected "
        "at most 20000000 in svg; --raster puts an image in their place, a smaller -n has fewer\n");
    CHECK(scratch.size() == 0);
    CHECK(holds(run("draw dragon -n 24..25 --panels -o " + path).err,
                "the 2 figures have 50331648 strokes"));
}

TEST_CASE("leaves of a figure are polygons in svg, not an image") {
    const Run leaf = run("draw 'axiom F; F -> F[+{.F.-F.}]F' -n 1 --format svg -o -");
    CHECK(holds(leaf.out, "<path class=\"area"));
    CHECK(!holds(leaf.out, "<image"));
}

TEST_CASE("pdf says its title and author") {
    const Scratch scratch;
    const std::string path = scratch.file("k.pdf");
    CHECK(run("draw koch -n 2 --author 'A. B.' -o " + path).status == 0);
    CHECK(holds(text_of(path), "/Title (Koch curve)"));
    CHECK(holds(text_of(path), "/Author (A. B.)"));
    CHECK(run("draw koch -n 2 -o " + path).status == 0);
    CHECK(!holds(text_of(path), "/Author"));
}
