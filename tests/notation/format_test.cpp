#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <string>

#include "exact/exact.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "notation/random_text.hpp"

using namespace algae;

TEST_CASE("comments stay with their statements") {
    CHECK(format_lsystem("# Koch's snowflake\n\n#   by hand\n"
                         "angle 60 # degrees\n"
                         "# three sides\n"
                         "axiom F--F--F   #closed\n"
                         "F->F+F--F+F; G->G # one, two\n"
                         "# about the name\n"
                         "title Koch # snowflake\n"
                         "turn counter-clockwise # as always\n"
                         "id a # first\nid b # second\n"
                         "# the end\n",
                         "x.lsys") ==
          "# Koch's snowflake\n#   by hand\n"
          "# about the name\ntitle Koch # snowflake\n"
          "# first\n# second\nid a b\n"
          "# three sides\naxiom F--F--F #closed\n"
          "F -> F+F--F+F\nG -> G # one, two\n"
          "angle 60 # degrees\n"
          "# as always\n# the end\n");
    CHECK(format_lsystem("axiom a # b", "x.lsys") == "axiom a # b\n");
    CHECK(format_lsystem("axiom a", "x.lsys") == "axiom a\n");
}

TEST_CASE("formatting loses no comment, changes no system, and twice is once") {
    CHECK(rc::check([] {
        std::string text = random_text::system(), commented;
        int comments = 0;
        for (const char byte : text) {
            if (byte == '\n' && random_text::chance(30))
                commented += " # comment " + std::to_string(comments++);
            commented += byte;
            if (byte == '\n' && random_text::chance(30))
                commented += "  # comment " + std::to_string(comments++) + "\n";
        }
        try {
            const std::string formatted = format_lsystem(commented, "x.lsys");
            RC_ASSERT(read_lsystem(formatted, "x.lsys") == read_lsystem(text, "x.lsys"));
            RC_ASSERT(format_lsystem(formatted, "x.lsys") == formatted);
            for (int i = 0; i < comments; ++i)
                RC_ASSERT(formatted.find("# comment " + std::to_string(i) + "\n") !=
                          std::string::npos);
        } catch (const Diagnostics&) {
            // probabilities that do not add up, by chance
        }
    }));
}

TEST_CASE("suggestions") {
    CHECK(edit_distance("angel", "angle") == 1);
    CHECK(edit_distance("", "abc") == 3);
    CHECK(edit_distance("kitten", "sitting") == 3);
    CHECK(edit_distance("abc", "") == 3);
    CHECK(edit_distance("ab", "ba") == 1);
    CHECK(edit_distance("xabcd", "xbacd") == 1);
    CHECK(edit_distance("abcdef", "badcfe") == 3);
    CHECK(did_you_mean("colouring", {"angle", "colour"}) == "");
    CHECK(did_you_mean("colou", {"angle", "colours", "colour"}) == "; did you mean 'colour'?");
    CHECK(did_you_mean("colur", {"angle", "colour"}) == "; did you mean 'colour'?");
    CHECK(did_you_mean("wood", {"angle", "colour"}) == "");
    CHECK(did_you_mean("x", {"y"}) == "");
}
