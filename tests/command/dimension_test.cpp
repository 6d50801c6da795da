#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "command/run.hpp"

using nlohmann::json;

TEST_CASE("dimension measures a figure by boxes and gives the keys that programs rely on") {
    const Run shown = run("dimension koch -n 7 --json");
    CHECK(shown.status == 0);
    const json found = json::parse(shown.out);
    CHECK(found["generation"] == 7);
    const json& box = found["box"];
    CHECK(box["low"] < 1.2619);
    CHECK(box["high"] > 1.2618);
    CHECK(box["value"] > 1.2);
    CHECK(box["offsets"] == 16);
    CHECK(box["because"].is_string());
    REQUIRE(box["scales"].size() > 5);
    CHECK(box["scales"][1]["cell"].get<double>() * 2 == box["scales"][0]["cell"].get<double>());
    for (const char* key : {"cell", "cells", "least", "most", "slope", "used"})
        CHECK(box["scales"][0].contains(key));
}

TEST_CASE("dimension says what the rules give, and measures the limit") {
    const Run page = run("dimension koch-a --grids 4");
    CHECK(page.status == 0);
    CHECK(page.out.starts_with(
        "Koch curve a, the limit of all generations\n\n"
        "exact: log 6 / log sqrt 10 = 1.556302500767287265017533595959\n"
        "  all parts become similar, smaller by the factor sqrt 10 in each generation\n"
        "  parts coincide; different ones, told apart by 1 kind of surroundings, multiply by 6\n"
        "with multiplicity, too large: log 8 / log sqrt 10 = 1.806179973983887171282433368347\n"));
    const json found = json::parse(run("dimension dragon --grids 4 --json").out);
    CHECK(found["exact"]["status"] == "exact");
    CHECK(found["exact"]["formula"] == "log 2 / log sqrt 2 = 2");
    CHECK(found["exact"]["value"] == 2);
    CHECK(found["exact"]["boundary"]["decimal"] == "1.523627086202492106277683935954");
    CHECK(found["exact"]["conditions"].size() == 2);
    CHECK(found["box"]["high"] == 2);
    CHECK(found["box"]["low"] > 1.9);
    CHECK_FALSE(found.contains("generation"));
    const json plant = json::parse(run("dimension plant-d --grids 4 --json").out);
    CHECK(plant["exact"]["status"] == "upper bound");
    CHECK(plant["exact"]["formula"] == "log 3 / log 2");
}

TEST_CASE(
    "the error of a measurement stands beside it, and an interval without the exact value is "
    "told") {
    const Run shown = run("dimension koch --grids 4");
    CHECK(shown.out.find("\n  error against the exact value: ") != std::string::npos);
    CHECK(shown.out.find("does not hold it") == std::string::npos);
    const json found = json::parse(run("dimension koch --grids 4 --json").out);
    CHECK(found["box"]["holds_exact"] == true);
    CHECK(std::abs(found["box"]["error"].get<double>()) < 0.01);
}

TEST_CASE("a measurement in less time takes fewer cells, and is kept when the time is over") {
    const Scratch scratch;
    const std::string plant =
        "'" + scratch.file("f.lsys", "axiom X\nX -> F-[[X]+X]+F[+FX]-X\nF -> FF\nangle 90\n") + "'";
    const json found = json::parse(run("dimension " + plant + " --timeout 40 --json").out);
    CHECK(found["box"]["value"] > 1);
}

TEST_CASE("a search that takes long does not take the bound and the measurement with it") {
    const Scratch scratch;
    const std::string plant =
        "'" + scratch.file("c.lsys", "axiom F\nF -> FF-[-F+F+F]+[+F-F-F]\nangle 60\n") + "'";
    const Run over = run("dimension " + plant + " --grids 1 --timeout 8");
    CHECK(over.status == 3);
    CHECK(over.out.find("upper bound: 2, as for every set in the plane; the formula gives log 8 / "
                        "log 2 = 3\n") != std::string::npos);
    CHECK(over.out.find("the search for parts that coincide goes on\n") != std::string::npos);
    CHECK(over.out.find("exact: unfinished, at most 2; the formula gives log 8 / log 2 = 3\n") !=
          std::string::npos);
    CHECK(over.out.find("measured by boxes: 1.") != std::string::npos);
    const Run none = run("dimension " + plant + " --timeout 1 --json");
    CHECK(none.status == 3);
    const json found = json::parse(none.out);
    CHECK(found["exact"]["status"] == "unfinished");
    CHECK(found["exact"]["at_most"]["formula"] == "log 8 / log 2 = 3");
    CHECK(found["exact"]["at_most"]["value"] == 2);
    CHECK(found["exact"]["value"].is_null());
}

TEST_CASE(
    "bounds of sets in the plane are at most 2 in JSON, and small images say which size would do") {
    const Scratch scratch;
    const std::string bush = "'" +
                             scratch.file("b.lsys",
                                          "axiom F\nF -> F[+F]F[-F][F]F[++F][--F][+++F]"
                                          "[---F]\nangle 20\n") +
                             "'";
    const json found = json::parse(run("dimension " + bush + " --grids 1 --json").out)["exact"];
    CHECK(found["status"] == "upper bound");
    CHECK(found["formula"] == "log 10 / log 3");
    CHECK(found["value"] == 2);
    CHECK(found["decimal"] == "2.000000000000000000000000000000");
    CHECK(found["similarity"]["value"] > 2.09);
    const std::string island =
        "'" + scratch.file("i.lsys", "axiom F\nF -> FF-F+F-F-FF\nangle 90\n") + "'";
    const Run over = run("dimension " + island + " --timeout 1 --json");
    if (over.status == 3) CHECK(json::parse(over.out)["exact"]["at_most"]["value"] == 2);
    const std::string picture = scratch.file("small.png");
    CHECK(run("draw koch -n 3 --width 64 -o '" + picture + "'").status == 0);
    const Run small = run("dimension '" + picture + "'");
    CHECK(small.status == 3);
    CHECK(
        small.out.find("the picture is too small: expected ink that is 96 pixels across, found ") !=
        std::string::npos);
}

TEST_CASE(
    "dimension --within gives bounds that are proved, and ends with 3 where they stay apart") {
    const Run near = run("dimension koch --within 0.01 --grids 1");
    CHECK(near.status == 0);
    CHECK(near.out.find("proved: between 1.261859507142 and 1.261859507143\n"
                        "  from below by the exact value\n") != std::string::npos);
    const Scratch scratch;
    const std::string fine =
        "'" + scratch.file("fine.lsys", "axiom F\nF -> F[+F]F\nangle sqrt(2)\n") + "'";
    const Run apart = run("dimension " + fine + " --within 0.01 -n 6 --json");
    CHECK(apart.status == 3);
    const json bounds = json::parse(apart.out)["bounds"];
    CHECK(bounds["low"] == "0");
    CHECK(bounds["high"] == "1.584962501");
    CHECK(bounds["high_by"] == "the similarity dimension");
    CHECK(bounds["reached"] == false);
    CHECK(run("dimension koch --within 0").err ==
          "algae: --within: expected a number above 0, found 0\n");
    CHECK(run("dimension fern --within 0.1").err ==
          "algae: --within is for systems, and fern is not one\n");
    CHECK(run("dimension koch --within 0.1 --measure mass").err ==
          "algae: --within is for --measure boxes\n");
    CHECK(run("dimension --table --within 0.1").err ==
          "algae: --within is for one system, not for --table\n");
}

TEST_CASE("dimension says when a generation is too low, and leaves it undecided") {
    const Run low = run("dimension koch -n 2");
    CHECK(low.status == 3);
    CHECK(low.out.find("the generation is too low: 0 scales lie between") != std::string::npos);
}

TEST_CASE(
    "a system of many modules that draw nothing is measured in a generation that can be kept") {
    const Run found =
        run("dimension 'axiom F(1)A(1); A(x) -> G(x); G(x) -> A(x); F(x) -> F(x/3)f(x/3)F(x/3); "
            "f(x) -> f(x/3)f(x/3)f(x/3)' --max-memory 1G --json");
    CHECK(found.status == 0);
    CHECK(json::parse(found.out)["generation"] == 14);
}

TEST_CASE("dimension reads points and images, and plots") {
    const Scratch scratch;
    std::string square = "x, y\n";
    for (int i = 0; i < 200; ++i)
        for (int k = 0; k < 200; ++k) square += std::to_string(i) + ", " + std::to_string(k) + "\n";
    const std::string points = scratch.file("square.txt", square), plot = scratch.file("plot.svg"),
                      picture = scratch.file("koch.png");
    const json found =
        json::parse(run("dimension '" + points + "' --points --plot '" + plot + "' --json").out);
    CHECK(found["box"]["high"] == 2);
    CHECK(text_of(plot).find("<svg") != std::string::npos);
    CHECK(run("draw koch -n 5 -o '" + picture + "'").status == 0);
    const json image = json::parse(run("dimension '" + picture + "' --json").out);
    CHECK(image["box"]["low"] < 1.27);
    CHECK(image["box"]["high"] > 1.25);
}

TEST_CASE("dimension refuses what it cannot measure") {
    const auto message = [](const std::string& arguments, const std::string& before = "") {
        const Run refused = run("dimension " + arguments, before);
        CHECK(refused.status == 2);
        return refused.err;
    };
    CHECK(message("koch --invert") ==
          "algae: --invert is for images, and koch is not one of them\n");
    CHECK(message("koch --plot a.xyz").find("a.xyz") != std::string::npos);
    CHECK(message("koch --grids 0") == "algae: --grids: expected 1 to 1000, found 0\n");
    CHECK(message("-", "printf '1 2\\n3 x\\n' |") ==
          "standard input:2:3: error: expected a number, found 'x'\n  3 x\n    ^\n");
    CHECK(message("-", "printf '1 2\\n1 2\\n' |") ==
          "algae: all points are the same: expected something to measure\n");
    CHECK(message("- -n 3", "printf 'axiom f; f -> ff' |") ==
          "algae: standard input, n = 3: nothing is drawn, expected something to measure\n");
    const Run long_work = run("dimension koch -n 60");
    CHECK(long_work.status == 3);
    CHECK(long_work.err.find("use a lower -n") != std::string::npos);
}

TEST_CASE("dimension --measure gives the other measures and their keys") {
    for (const char* measure :
         {"divider", "mass", "correlation", "information", "multifractal", "lacunarity"}) {
        CAPTURE(measure);
        const std::string arguments = std::string("dimension koch -n 7 --measure ") + measure;
        const Run shown = run(arguments + " --json");
        CHECK(shown.status == 0);
        const json found = json::parse(shown.out);
        CHECK(found["measure"] == measure);
        CHECK(found["input"].is_string());
        CHECK(found["because"].is_string());
        CHECK(found["estimate"]["low"] <= std::log(4) / std::log(3));
        CHECK(found["estimate"]["high"] >= std::log(4) / std::log(3));
        CHECK(std::abs(found["estimate"]["value"].get<double>() - std::log(4) / std::log(3)) < 0.1);
        REQUIRE(found["scales"].size() >= 4);
        for (const char* key : {"size", "value", "slope", "used"})
            CHECK(found["scales"][0].contains(key));
        CHECK(found.contains("spectrum") == (found["measure"] == "multifractal"));
        CHECK(run(arguments).out.find("expected between") != std::string::npos);
    }
    const json spectrum =
        json::parse(run("dimension koch -n 7 --measure multifractal --json").out)["spectrum"];
    REQUIRE(spectrum.size() == 11);
    CHECK(spectrum[0]["q"] == -5);
    CHECK(spectrum[5]["value"] ==
          json::parse(
              run("dimension koch -n 7 --measure multifractal --json").out)["estimate"]["value"]);
}

TEST_CASE("dimension --measure takes points and images, and refuses what it cannot") {
    const Scratch scratch;
    std::string line;
    for (int i = 0; i < 3000; ++i) line += std::to_string(i) + " " + std::to_string(2 * i) + "\n";
    const std::string points = scratch.file("line.csv", line), picture = scratch.file("koch.png"),
                      space = scratch.file("space.csv", "1 2 3\n4 5 6\n");
    CHECK(run("draw koch -n 5 -o '" + picture + "'").status == 0);
    for (const char* measure : {"divider", "mass", "correlation", "information", "multifractal"}) {
        CAPTURE(measure);
        const json found =
            json::parse(run("dimension '" + points + "' --json --measure " + measure).out);
        CHECK(std::abs(found["estimate"]["value"].get<double>() - 1) < 0.05);
    }
    for (const char* measure : {"mass", "correlation", "information", "lacunarity"}) {
        CAPTURE(measure);
        CHECK(run("dimension '" + picture + "' --measure " + measure).status != 2);
    }
    const auto message = [](const std::string& arguments) {
        const Run refused = run("dimension " + arguments);
        CHECK(refused.status == 2);
        return refused.err;
    };
    CHECK(message("koch --measure weight") ==
          "algae: --measure: expected boxes, divider, mass, correlation, information, multifractal "
          "or lacunarity, found weight\n");
    CHECK(message("koch --measure lacunarity --plot a.svg") ==
          "algae: --plot is for --measure boxes, divider, mass and correlation\n");
    CHECK(message("'" + picture + "' --measure divider").find("found pixels") != std::string::npos);
    CHECK(message("'" + space + "' --measure lacunarity").find("3 columns") != std::string::npos);
    CHECK(run("dimension koch -n 2 --measure mass").status == 3);
}

TEST_CASE("dimension measures figures of dots, and the spectrum of chances beside the exact one") {
    // Both ended with "expected strokes with a length to measure".
    const json dots = json::parse(run("dimension sierpinski --measure correlation --json").out);
    CHECK(std::abs(dots["estimate"]["value"].get<double>() - std::log(3) / std::log(2)) < 0.06);
    const Scratch scratch;
    const std::string maps = scratch.file("uneven.ifs",
                                          "map 1/2 0 0 1/2 0 0 0.7\nmap 1/2 0 0 1/2 1/2 0 0.2\n"
                                          "map 1/2 0 0 1/2 1/4 1/2 0.1\npoints 30000\n");
    const json found =
        json::parse(run("dimension '" + maps + "' --measure multifractal --json").out);
    std::size_t compared = 0;
    for (const json& row : found["spectrum"]) {
        const double q = row["q"], exact = row["exact"];
        const double known =
            q == 1 ? -(0.7 * std::log2(0.7) + 0.2 * std::log2(0.2) + 0.1 * std::log2(0.1))
                   : std::log2(std::pow(0.7, q) + std::pow(0.2, q) + std::pow(0.1, q)) / (1 - q);
        CHECK(exact == doctest::Approx(known).epsilon(1e-9));
        if (q < 1) continue;  // of few points, the rare ones are not all there
        CHECK(std::abs(row["value"].get<double>() - exact) < 0.12);
        ++compared;
    }
    CHECK(compared == 5);
    const Run information = run("dimension '" + maps + "' --measure information");
    CHECK(information.out.find("exact: 1.156780, sum p log p / sum p log r") != std::string::npos);
}

TEST_CASE("dimension says the noise of points") {
    const Scratch scratch;
    std::mt19937_64 random(2);
    std::normal_distribution<double> move(0, 0.005);
    std::string text;
    double x = 0, y = 0;
    for (int k = 0; k < 40'000; ++k) {
        const auto corner = random() % 3;
        x = (x + (corner == 1 ? 1 : corner == 2 ? 0.5 : 0)) / 2;
        y = (y + (corner == 2 ? 0.866 : 0)) / 2;
        text += std::to_string(x + move(random)) + " " + std::to_string(y + move(random)) + "\n";
    }
    const std::string points = scratch.file("gasket.xy", text);
    const json boxes = json::parse(run("dimension '" + points + "' --json").out)["box"];
    CHECK(boxes["noise"] == doctest::Approx(0.005).epsilon(0.15));
    CHECK(boxes["value"].is_null());
    CHECK(boxes["because"].get<std::string>().find("too much noise: ") == 0);
    const json pairs =
        json::parse(run("dimension '" + points + "' --measure correlation --json").out);
    CHECK(std::abs(pairs["estimate"]["value"].get<double>() - std::log(3) / std::log(2)) < 0.05);
    CHECK(pairs["noise"] == doctest::Approx(0.005).epsilon(0.15));
}

TEST_CASE("dimension --rauzy says what is decided of the fractal of a substitution") {
    const Run page = run("dimension tribonacci --rauzy");
    CHECK(page.status == 0);
    CHECK(page.out.find("proved: the parts tile") != std::string::npos);
    CHECK(page.out.find("= 1.093364164282\n") != std::string::npos);
    CHECK(page.out.find("the fractal and each of its parts are connected") != std::string::npos);
    const Run data = run("dimension tribonacci --rauzy --json");
    const json found = json::parse(data.out);
    CHECK(found["tiles"] == true);
    CHECK(found["letters"].size() == 3);
    CHECK(found["meeting"] == "the largest real root of x^4 - 2x - 1");
    CHECK(found["boundary"]["decimal"].get<std::string>().starts_with("1.0933641642"));
    CHECK(found["neighbours"].size() > 10);
    CHECK(run("dimension koch --rauzy").err.find("found the determinant") != std::string::npos);
    CHECK(run("dimension fern --rauzy").err ==
          "algae: --rauzy is for systems, and fern is not one\n");
    CHECK(run("dimension tribonacci --rauzy --tiling periodic").err ==
          "algae: --tiling says what --plot FILE draws, and no --plot is given\n");
    CHECK(run("dimension tribonacci --tiling periodic").err == "algae: --tiling is for --rauzy\n");
    CHECK(run("dimension tetranacci --rauzy --plot r.png").err ==
          "algae: expected three letters, whose fractal lies in the plane, found 4\n");
    const Scratch folder;
    for (const std::string tiling : {"", "periodic", "self-replicating"}) {
        const std::string file = folder.file("rauzy" + tiling + ".svg");
        const Run drawn = run("dimension tribonacci --rauzy --plot '" + file + "'" +
                              (tiling.empty() ? "" : " --tiling " + tiling));
        CHECK(drawn.status == 0);
        CHECK(drawn.err.empty());
        CHECK(text_of(file).find("<path") != std::string::npos);
    }
    CHECK(run("dimension tribonacci --rauzy --within 0.1").err ==
          "algae: --rauzy goes without --within\n");
}

TEST_CASE("dimension says what the limit is as a tile, and draws it among its neighbours") {
    const Run page = run("dimension gosper --grids 1");
    CHECK(page.status == 0);
    CHECK(page.out.find(
              "tile: its parts overlap in sets of the area 0\n"
              "  area: sqrt(3)/2 of the square of the distance from its beginning to its end\n"
              "  neighbours: 6 in the tiling that it makes\n"
              "  connected: yes: the parts of each part that meet hang together (Hata)\n"
              "  like a disc: yes: its boundary is a ring of arcs, a simple closed curve (Jordan, "
              "Schoenflies)\n") != std::string::npos);
    const json tile = json::parse(run("dimension dragon --grids 1 --json").out)["tile"];
    CHECK(tile["is_tile"]["answer"] == true);
    CHECK(tile["area"]["exact"] == "1/2");
    CHECK(tile["area"]["cells"] == "1/2");
    CHECK(tile["least_neighbours"] == 11);
    CHECK(tile["most_neighbours"] == 11);
    CHECK(tile["neighbours"].size() == 11);
    CHECK(tile["neighbours"][0]["moved_by"].size() == 2);
    CHECK(tile["basis"].size() == 2);
    CHECK(tile["disk_like"]["answer"] == false);
    CHECK(tile["interior_infinitely_many"]["answer"] == true);
    CHECK(json::parse(run("dimension koch --grids 1 --json").out)["tile"].is_null());
    const json rauzy = json::parse(run("dimension tribonacci --rauzy --json").out)["tile"];
    CHECK(rauzy["most_neighbours"] == 6);
    CHECK(rauzy["disk_like"]["answer"] == true);
    const Scratch folder;
    const std::string file = folder.file("tile.svg");
    const Run drawn = run("dimension gosper --grids 1 --tile --plot '" + file + "'");
    CHECK(drawn.status == 0);
    const std::string picture = text_of(file);
    std::size_t paths = 0;
    for (std::size_t at = picture.find("<path"); at != std::string::npos;
         at = picture.find("<path", at + 1))
        ++paths;
    CHECK(paths >= 7);  // the tile and six neighbours
    const std::string maps = folder.file("square.ifs",
                                         "map 1/2 0 0 1/2 0 0\nmap 1/2 0 0 1/2 1/2 0\n"
                                         "map 1/2 0 0 1/2 0 1/2\nmap 1/2 0 0 1/2 1/2 1/2\n");
    const json square = json::parse(run("dimension '" + maps + "' --json").out)["tile"];
    CHECK(square["area"]["exact"] == "1");
    CHECK(square["most_neighbours"] == 8);
    CHECK(square["periodic"] == true);
    CHECK(
        square["disk_like"]["because"] ==
        "it has eight neighbours, and its parts hang together by its four sides (Bandt and Wang)");
}

TEST_CASE("dimension --tile says what it needs") {
    CHECK(run("dimension dragon --tile").err ==
          "algae: --tile says what --plot FILE draws, and no --plot is given\n");
    CHECK(run("dimension dragon --tile --plot t.svg --measure mass").err ==
          "algae: --tile is for --measure boxes, and not for --table\n");
    CHECK(run("dimension tribonacci --rauzy --tile --plot t.svg").err ==
          "algae: --rauzy goes without --tile\n");
    CHECK(run("dimension koch --grids 1 --tile --plot t.svg").err ==
          "algae: koch: --tile draws a tile, and this is not seen to be one\n");
}

TEST_CASE("a dimension that is so with probability 1 bounds no figure") {
    const Scratch scratch;
    const std::string file =
        "'" +
        scratch.file("random.lsys", "axiom F\nF -(1/2)-> F+F--F+F\nF -(1/2)-> FFF\nangle 60\n") +
        "'";
    const Run found = run("dimension " + file + " -n 4");
    CHECK(found.out.find("exact, with probability 1: log (7/2) / log 3 = 1.14031399") !=
          std::string::npos);
    const Run within = run("dimension " + file + " --within 0.1");
    CHECK(within.status == 2);
    CHECK(within.err.find("chance has a part in what") != std::string::npos);
    CHECK(run("dimension " + file + " -n 4 --latex").out.find("With probability $1$") !=
          std::string::npos);
}
