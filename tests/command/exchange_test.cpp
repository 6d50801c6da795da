#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "command/run.hpp"
#include "places.hpp"

using nlohmann::json;

namespace {

const std::string examples = source_folder() + "/examples/";

std::size_t letters(const std::string& line) { return line.size() - 1; }  // without the line break

}  // namespace

TEST_CASE("files of other programs are read wherever a system is") {
    CHECK(letters(run("derive '" + examples + "bush.brno' -n 5").out) == 8010);
    CHECK(letters(run("derive '" + examples + "koch-island.netlogo' -n 3").out) == 3803);
    const Scratch scratch;
    const std::string picture = scratch.file("bush.png");
    const json drawn = json::parse(
        run("draw '" + examples + "bush.brno' -n 5 --json --width 100 -o '" + picture + "'").out);
    CHECK(drawn["segments"] == 420);
    CHECK(text_of(picture).starts_with("\x89PNG"));
    const json island =
        json::parse(run("draw '" + examples + "koch-island.netlogo' -n 3 --json -o '" +
                        scratch.file("island.svg") + "'")
                        .out);
    CHECK(island["segments"] == 2048);
}

TEST_CASE("files of other programs are converted, both ways") {
    const Run bush = run("convert '" + examples + "bush.brno' --to lsys");
    CHECK(bush.status == 0);
    CHECK(bush.out.starts_with("axiom A\nA -> [&FLK!A]/////"));
    const Scratch scratch;
    const std::string again = scratch.file("again.lsys", bush.out);
    const Run back = run("convert '" + again + "' --to brno");
    CHECK(back.out.starts_with("modules:\n    A, F = C(5,5), K = S(6), L, Q, S, f = P(8);\n"));
    CHECK(run("convert - --from brno --to lsys",
              "printf '%s' \"$(cat '" + examples + "bush.brno')\" |")
              .out == bush.out);
    const Run island = run("convert koch-island-002 --to netlogo");
    CHECK(island.out ==
          "; Quadratic Koch island\nadd-rule \"F\" \"F-F+F+FF-F-F+F\" \"F\"\nset chain "
          "\"F-F-F-F\"\nset d 16\n"
          "set delta 90\nset x0 -8\nset y0 8\nset delta-0 90\nset k-shorten 0.25\n");
    // By way of the notation.
    CHECK(run("convert '" + examples + "koch-island.netlogo' --to netlogo").out ==
          island.out.substr(island.out.find('\n') + 1));
    const Run refused = run("convert '" + examples + "koch-island.netlogo' --to brno");
    CHECK(refused.status == 2);
    CHECK(refused.err.find("koch-island.netlogo: brno cannot say that steps shrink") !=
          std::string::npos);
    const std::string faulty = scratch.file("faulty.netlogo", "set chain F\nset d 0\n");
    const Run faults = run("derive '" + faulty + "' -n 1");
    CHECK(faults.status == 2);
    CHECK(faults.err.find("faulty.netlogo:1:11: error: expected a word") != std::string::npos);
    CHECK(faults.err.find("faulty.netlogo:2:7: error: expected a number other than 0") !=
          std::string::npos);
}

TEST_CASE("a model of cpfg is its system with the view and the animation beside it") {
    const Scratch scratch;
    const std::string system = scratch.file(
        "plant.l", "Lsystem: 1\nderivation length: 3\nAxiom: F\nF --> F[+F]F\nendlsystem\n");
    const std::string view = scratch.file("plant.v", "angle increment: 30\n"),
                      frames = scratch.file("plant.a", "first frame: 1\nlast frame: 2\n"),
                      other = scratch.file("other.v", "angle increment: 20\n"),
                      said = scratch.file("specifications", "cpfg plant.l other.v plant.a\n");
    const auto holds = [](const std::string& file, const std::string& line) {
        return run("convert '" + file + "' --to lsys").out.find(line) != std::string::npos;
    };
    CHECK(holds(system, "angle 30\n"));
    CHECK(holds(system, "generation 3\n"));
    CHECK(holds(view, "angle 30\n"));
    CHECK(holds(frames, "generation 1..2\n"));
    CHECK(holds(frames, "angle 30\n"));
    CHECK(holds(said, "angle 20\n"));
    CHECK(holds(said, "generation 1..2\n"));
    CHECK(run("show '" + other + "'").err.find("expected it beside this file: other.l") !=
          std::string::npos);
    const json drawn =
        json::parse(run("draw '" + system + "' --json -o '" + scratch.file("p.svg") + "'").out);
    CHECK(drawn["segments"] == 27);
}

TEST_CASE("one of several systems of cpfg has the view beside its file") {
    const Scratch scratch;
    const std::string two =
        scratch.file("two.l",
                     "Lsystem: 1\nderivation length: 1\nAxiom: F\nF --> F+F\nendlsystem\n"
                     "Lsystem: 2\nderivation length: 1\nAxiom: F\nF --> F-F-F\nendlsystem\n");
    scratch.file("two.v", "angle increment: 30\n");
    const std::string said = run("convert '" + two + ":2' --to lsys").out;
    CHECK(said.find("F -> F-F-F\n") != std::string::npos);
    CHECK(said.find("angle 30\n") != std::string::npos);
    CHECK(run("convert '" + two + ":3' --to lsys").err.find("there is no system '3'") !=
          std::string::npos);
    // A file of Fractint has no view.
    scratch.file("three.v", "angle increment: 30\n");
    const std::string three = scratch.file("three.l", "Koch {\nAngle 6\nAxiom F\nF=F+F\n}\n");
    CHECK(run("convert '" + three + ":Koch' --to lsys").out.find("angle 60\n") !=
          std::string::npos);
}

TEST_CASE("a file of cpfg includes files of its folder and below, and no others") {
    const Scratch outer;
    std::filesystem::create_directories(outer.path() / "inside" / "deep");
    outer.file("secret.l", "B --> C\n");
    outer.file("inside/rules.l", "A --> AB\n#include \"deep/more.l\"\n");
    outer.file("inside/deep/more.l", "B --> A\n");
    const std::string head = "Lsystem: 1\nderivation length: 3\nAxiom: A\n", end = "endlsystem\n";
    const std::string good = outer.file("inside/good.l", head + "#include \"rules.l\"\n" + end);
    CHECK(run("derive '" + good + "' -n 3").out == "ABAAB\n");
    // Also where a claim names the system, and where the text alone is converted.
    outer.file("inside/x.claim", "claim x\nlet G = D0L good.l\nshow AB in L(G)\n");
    CHECK(run("check '" + outer.file("inside/x.claim") + "'").status == 0);
    CHECK(run("convert '" + good + "' --to sage").status == 0);
    std::filesystem::create_symlink(outer.file("secret.l"), outer.file("inside/link.l"));
    for (const std::string name :
         {"../secret.l", "link.l", "deep/../../secret.l", "none.l", "-", "deep"}) {
        const std::string bad =
            outer.file("inside/bad.l", head + "#include \"" + name + "\"\n" + end);
        const Run refused = run("derive '" + bad + "' -n 1 --json");
        INFO(refused.err);
        CHECK(refused.status == 2);
        const json error = json::parse(refused.out)["error"];
        CHECK(error["line"] == 4);
        CHECK(error["column"] == 1);
        CHECK(error["expected"] ==
              "a file of this name in the folder of the one that includes it or below");
    }
}
