#include <doctest/doctest.h>

#include "cli/run.hpp"

TEST_CASE("figures draws systems and relatives of a folder, and says what folder it expected") {
    const Scratch scratch;
    const std::string out = scratch.file("out");
    const std::string folder = scratch.path().string();
    const Run empty = run("figures " + folder + " --out " + out);
    CHECK(empty.status == 2);
    CHECK(empty.err == "algae: " + folder + ": holds no .lsys files and none of relatives\n");
    const Run missing = run("figures " + folder + "/none --out " + out);
    CHECK(missing.status == 2);
    CHECK(missing.err == "algae: " + folder +
                             "/none: expected a folder of .lsys files and of files of relatives\n");
    CHECK(scratch.size() == 0);

    scratch.file("own.lsys", "axiom F; F -> F+F; generation 2\n");
    scratch.file("triangle.ifs",
                 "map 0.5 0 0 0.5 0 0\nmap 0.5 0 0 0.5 0.5 0\nmap 0.5 0 0 0.5 0 0.5\n");
    const Run both = run("figures " + folder + " --formats svg --out " + out);
    CHECK_MESSAGE(both.status == 0, both.err);
    CHECK(both.out == "2 systems, 2 pictures in " + out + "\n");
    CHECK(text_of(out + "/triangle.svg").find("<svg") != std::string::npos);
}
