// `--latex`, `algae latex` and algae.sty. A document with every command of the package is compiled where LaTeX is installed.

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "command/run.hpp"

using nlohmann::json;

namespace {

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

constexpr const char* every_command = R"(\documentclass{article}
\usepackage{algae}
\begin{document}
% \algaefigure{no-such-figure} in a comment
\verb|\algaefigure{none}|
\begin{lsystem}{mine}
axiom F
F -> F+F--F+F
angle 60
\end{lsystem}
\begin{lsystem*}{hidden}
a -> ab; b -> a
\end{lsystem*}
\begin{figure}\algaefigure[n=3]{koch} \algaefigure[n={0..2}, panels, captions, width=6cm]{mine}\end{figure}
\algaetree[n=4]{anabaena} \algaetree[graph]{fibonacci} \algaetree[word=aaa]{all-powers}
\algaegrowth{fibonacci}, \algaegrowth[matrix]{hidden}, \algaegrowth[recurrence]{koch},
\algaegrowth[function]{koch}, \algaegrowth[rate]{fibonacci}, \algaegrowth[lengths]{koch}.
\algaegrowth[all]{fibonacci}
Word \algaeword[n=5]{fibonacci}.
\algaederivation[n=4]{hidden} \algaederivation[word=abaab]{fibonacci}
\[\algaerules{koch}\]
\algaedimension[value]{koch} \algaedimension[n=4]{koch}
\algaeis{0L}{{a, aa}}
\algaecheck{union.claim}
\algaeclosure{0L}{union}
\input{part}
\end{document}
)";

}  // namespace

TEST_CASE("--latex of verbs") {
    CHECK(
        holds(run("growth fibonacci --latex").out, "\\left(\\frac{1 + \\sqrt{5}}{2}\\right)^{n}"));
    CHECK(run("derive 'a -> ab, b -> a' -n 2 --latex").out ==
          "\\begin{align*}\n  &a \\\\\n  &\\Longrightarrow a\\allowbreak b \\\\\n"
          "  &\\Longrightarrow a\\allowbreak b\\allowbreak a\n\\end{align*}\n");
    CHECK(holds(run("derive rudin-shapiro -n 2 --latex").out,
                "0\\allowbreak 0\\allowbreak 0\\allowbreak 1"));
    CHECK(holds(run("member fibonacci abaab --latex").out, "\\Longrightarrow"));
    CHECK(holds(run("is 0L '{a, aa}' --latex").out, "\\to"));
    const Run different = run("equal koch 'axiom F; F -> FF' --latex");
    CHECK(different.status == 1);
    CHECK(holds(different.out, "$"));
    CHECK(run("equal fibonacci 'axiom a; a -> ab; b -> a' --as growth --latex").status ==
          run("equal fibonacci 'axiom a; a -> ab; b -> a' --as growth").status);
    const Run infinite = run("finite fibonacci --latex");
    CHECK(infinite.status == 1);
    CHECK(holds(infinite.out, "$"));
    CHECK(run("finite 'a -> b, b -> a' --latex").status == 0);
    CHECK(holds(run("finite koch --latex --json").err, "--latex"));
    CHECK(holds(run("check --say 'for all 0L languages A: A^R is 0L' --latex").out,
                "\\begin{proof}"));
    CHECK(holds(run("closure union --latex").err, "expected a family"));
    CHECK(holds(run("show koch --latex").out, "F &\\to& F{+}F{-}{-}F{+}F"));
    CHECK(holds(run("dimension koch -n 4 --latex").out, "$\\frac{\\log 4}{\\log 3}$"));
    CHECK(holds(run("derive koch -n 2 --latex --json").err, "--latex"));
    CHECK(holds(run("growth koch -n 2 --latex").err, "--latex does not go with -n"));
    CHECK(holds(run("derive honda-a -n 2 --latex").err, "--latex: "));
}

TEST_CASE("algae latex replaces a file of results and no other") {
    const Scratch scratch;
    const std::string part = scratch.file("part.tex", "\\algaegrowth{koch}\n");
    const std::string text = "\\input{part}\\algaegrowth{fibonacci}\n";
    const std::string paper = scratch.file("paper.tex", text);
    const std::string link = scratch.file("link.algae");
    std::filesystem::create_symlink(paper, link);
    for (const std::string& read : {paper, part, link}) {
        INFO(read);
        const std::string before = text_of(read);
        const Run refused = run("latex '" + paper + "' -o '" + read + "'");
        CHECK(refused.status == 2);
        CHECK(refused.err ==
              "algae: cannot write " + read + ": it was read as input; expected another name\n");
        CHECK(text_of(read) == before);
    }
    // A document whose name ends as that of its results would be replaced by them.
    const std::string own = scratch.file("own.algae", text);
    CHECK(run("latex '" + own + "'").status == 2);
    CHECK(text_of(own) == text);
    const std::string other = scratch.file("notes.txt", "mine");
    const Run refused = run("latex '" + paper + "' -o '" + other + "'");
    CHECK(refused.status == 2);
    CHECK(refused.err == "algae: cannot write " + other +
                             ": it is not a file of results, which begins with \"% Results of "
                             "algae for\"; expected another name\n");
    CHECK(text_of(other) == "mine");
    // Results are replaced, also where the document inputs them, and an empty file is.
    const std::string results = scratch.file("paper.algae");
    scratch.file("paper.tex", "\\input{paper.algae}" + text);
    const std::string empty = scratch.file("empty", "");
    CHECK(run("latex '" + paper + "' -o '" + empty + "'").status == 0);
    CHECK(text_of(empty).starts_with("% Results of algae for paper.tex"));
    CHECK(run("latex '" + paper + "'").out == results + ": 2 made, 0 kept\n");
    CHECK(run("latex '" + paper + "'").out == results + ": 0 made, 2 kept\n");
}

TEST_CASE("algae latex writes results, keeps them and says what is wrong where") {
    const Scratch scratch;
    const std::string paper = scratch.file("paper.tex", every_command);
    scratch.file("part.tex", "\\algaeword[n=2]{koch}\n");
    scratch.file("union.claim", "claim T\nshow {a} is 0L\n");
    const Run first = run("latex '" + paper + "' --json");
    INFO(first.err);
    REQUIRE(first.status == 0);
    const json made = json::parse(first.out);
    CHECK(made["made"] == made["results"]);
    CHECK(made["results"].get<int>() >= 20);
    CHECK(made["failed"] == 0);
    const std::string results = text_of(scratch.file("paper.algae"));
    CHECK(holds(results, "\\algaeresult{figure[n=3]{koch}}{%"));
    CHECK(holds(results, "\\algaeresult{is[]{0L}{{a, aa}}}{%"));
    CHECK(!holds(results, "no-such-figure"));
    CHECK(holds(text_of(scratch.file("algae.sty")), "\\ProvidesPackage{algae}"));
    CHECK(run("latex --style").out == text_of(scratch.file("algae.sty")));
    // Nothing has changed, so nothing is made.
    const json again = json::parse(run("latex '" + paper + "' --json").out);
    CHECK(again["made"] == 0);
    CHECK(again["kept"] == made["results"]);
    CHECK(text_of(scratch.file("paper.algae")) == results);
    scratch.file("union.claim", "claim T\nshow {b} is 0L\n");
    CHECK(json::parse(run("latex '" + paper + "' --json").out)["made"] == 1);

    if (std::system(
            "command -v pdflatex >/dev/null && kpsewhich forest.sty elocalloc.sty >/dev/null") !=
        0) {
        MESSAGE(
            "LaTeX with forest is not here: a document that uses algae.sty was NOT compiled; "
            "tools/latex installs it");
        return;
    }
    const std::string compile = "cd '" + scratch.path().string() +
                                "' && pdflatex -interaction=nonstopmode -halt-on-error paper.tex "
                                ">compiled 2>&1";
    CHECK(std::system(compile.c_str()) == 0);
    const std::string log = text_of(scratch.file("paper.log"));
    CHECK(!holds(log, "No result for"));
    CHECK(!holds(log, "Missing character"));
    // Without the results it compiles too, and says what to do.
    std::filesystem::remove(scratch.file("paper.algae"));
    CHECK(std::system(compile.c_str()) == 0);
    CHECK(holds(text_of(scratch.file("paper.log")), "run `algae latex paper.tex'"));
}

TEST_CASE("what is wrong in a document is said with its place") {
    const Scratch scratch;
    const auto said = [&](const std::string& text) {
        const Run refused = run("latex '" + scratch.file("x.tex", text) + "'");
        CHECK(refused.status == 2);
        return refused.err;
    };
    CHECK(holds(said("one\n \\algaefigure[n=3]{koh}\n"),
                "x.tex:2:2: error: \\algaefigure: no file \"koh\""));
    CHECK(holds(said("\\algaefigure[size=3]{koch}"), "the option 'size': expected one of"));
    CHECK(holds(said("\\algaefigure[width=3]{koch}"),
                "width: expected a length such as 8cm or 200pt, found \"3\""));
    CHECK(holds(said("\\algaegrowth{honda-a}"), "\\algaegrowth: "));
    CHECK(holds(said("\\algaefigure{-o}"), "expected no argument that begins with '-'"));
    CHECK(holds(said("\\algaefigure[n=3]koch"), "expected '{' behind the command"));
    CHECK(holds(said("\\begin{lsystem}{a}\naxiom a\n"), "expected \\end{lsystem}, found none"));
    CHECK(
        holds(said("\\begin{lsystem}{a}a -> (\\end{lsystem}"), "\\algaerules: expected a symbol"));
    CHECK(holds(said("\\begin{lsystem}{a}a->b\\end{lsystem}\\begin{lsystem}{a}a->b\\end{lsystem}"),
                "a second system 'a' in the document"));
    CHECK(holds(said("\\algaefigure[n=3]{koch"), "found the end of the document"));
    CHECK(holds(run("latex").err, "expected a document, or --style"));
    // What is right is written all the same.
    CHECK(run("latex '" + scratch.file("y.tex", "\\algaeword[n=1]{koch}\\algaeword[n=1]{no}") + "'")
              .status == 2);
    CHECK(holds(text_of(scratch.file("y.algae")), "word[n=1]{koch}"));
}
