#include <doctest/doctest.h>

#include "command/run.hpp"

TEST_CASE("figures draws systems and generators of a folder, and says what folder it expected") {
    const Scratch scratch;
    const std::string out = scratch.file("out");
    const std::string folder = scratch.path().string();
    const Run empty = run("figures " + folder + " --out " + out);
    CHECK(empty.status == 2);
    CHECK(empty.err == "algae: " + folder + ": holds no .lsys files and none of generators\n");
    const Run missing = run("figures " + folder + "/none --out " + out);
    CHECK(missing.status == 2);
    CHECK(missing.err ==
          "algae: " + folder +
              "/none: expected a folder of .lsys files and of files of generators\n");
    CHECK(scratch.size() == 0);

    scratch.file("own.lsys", "axiom F; F -> F+F; generation 2\n");
    scratch.file("triangle.ifs",
                 "map 0.5 0 0 0.5 0 0\nmap 0.5 0 0 0.5 0.5 0\nmap 0.5 0 0 0.5 0 0.5\n");
    const Run both = run("figures " + folder + " --formats svg --out " + out);
    CHECK_MESSAGE(both.status == 0, both.err);
    CHECK(both.out == "2 systems, 2 pictures in " + out + "\n");
    CHECK(text_of(out + "/triangle.svg").find("<svg") != std::string::npos);
}

TEST_CASE("figures --page writes a page that links all pictures and shows the files") {
    const Scratch scratch;
    std::filesystem::create_directories(scratch.path() / "in/plants & co");
    scratch.file("in/koch.lsys", "title Koch\nsource a < b\naxiom F; F -> F+F; generation 2\n");
    scratch.file("in/plants & co/a#b.lsys", "axiom F; F -> F[+F]F; generation 0..1\n");
    scratch.file("in/bad.lsys", "axiom [; generation 1\n");
    const Run found =
        run("figures in --formats svg --page --out out", "cd '" + scratch.path().string() + "' &&");
    CHECK(found.status == 2);  // the page has the others all the same
    const std::string page = text_of(scratch.file("out/index.html"));
    CHECK(page.starts_with("<!DOCTYPE html>"));
    CHECK(page.find("<img src=\"previews/koch.png\"") != std::string::npos);
    CHECK(page.find(
              "<strong>Koch</strong><span>koch.lsys · a &lt; b · <a href=\"koch.svg\">svg</a>") !=
          std::string::npos);
    CHECK(page.find("<a href=\"plants &amp; co/a%23b.svg\">") == std::string::npos);
    CHECK(page.find("<a href=\"plants%20&amp;%20co/a%23b.svg\">") != std::string::npos);
    CHECK(page.find("F -&gt; F[+F]F") != std::string::npos);
    CHECK(page.find("<p class=\"problem\">in/bad.lsys:1:7: error") != std::string::npos);
    CHECK(page.find("<h2 id=\"group-1\">in</h2>") != std::string::npos);
    CHECK(page.find("<h2 id=\"group-2\">plants &amp; co</h2>") != std::string::npos);
    CHECK(page.find("group-3") == std::string::npos);
    for (const char* file : {"out/previews/koch.png", "out/previews/plants & co/a#b.png"})
        CHECK(std::filesystem::exists(scratch.file(file)));
}

TEST_CASE(
    "figures tells files apart that differ in their ends only, draws those of other programs, "
    "and counts what is drawn") {
    const Scratch scratch;
    std::filesystem::create_directories(scratch.path() / "in");
    scratch.file("in/plain.lsys", "axiom F; F -> F+F; generation 2\n");
    scratch.file("in/plain.ca", "rule 90\ncells 11\ngeneration 4\n");
    scratch.file("in/koch.maple", "Lsystem(\"F\", [\"F\", \"F+F--F+F\"], 60, 2);\n");
    scratch.file("in/empty.lsys", "axiom a; a -> ab; generation 3\n");
    const Run found =
        run("figures in --formats svg --out out", "cd '" + scratch.path().string() + "' &&");
    CHECK(found.out == "4 systems, 3 pictures in out, 1 with problems\n");
    for (const char* file : {"out/plain.lsys.svg", "out/plain.ca.svg", "out/koch.svg"})
        CHECK(std::filesystem::exists(scratch.file(file)));
}

TEST_CASE("figures --page writes its page where the time was over before the first picture") {
    const Scratch scratch;
    std::filesystem::create_directories(scratch.path() / "in");
    scratch.file("in/koch.lsys", "axiom F; F -> F+F; generation 2\n");
    const Run found = run("figures in --formats svg --page --out out --timeout 0.000000001",
                          "cd '" + scratch.path().string() + "' &&");
    CHECK(found.status == 3);
    CHECK(found.err.find("the time allowed by --timeout is over") != std::string::npos);
    CHECK(text_of(scratch.file("out/index.html")).starts_with("<!DOCTYPE html>"));
}

TEST_CASE("a file says that its picture is a tree, a table or a plot, in standard input too") {
    const Scratch scratch;
    const std::string file = scratch.file("a.svg");
    for (const char* kind : {"tree", "table", "plot", "figure"})
        CHECK(run("draw - -o " + file,
                  std::string("printf 'axiom F; F -> F+F; generation 1; picture ") + kind + "' |")
                  .status == 0);
    CHECK(run("draw - -n 0..2 -o " + file, "printf 'axiom F; F -> F+F; picture tree' |")
              .err.find("a tree shows one generation") != std::string::npos);
}
