#include <doctest/doctest.h>

#include <string>

#include "model/model.hpp"
#include "notation/notation.hpp"
#include "notation/said.hpp"

using namespace algae;

TEST_CASE("statements that are none") {
    CHECK(findings("angel 60\naxiom F") ==
          "x.lsys:1:1: error: expected a setting or a rule with '->', found 'angel'; did you mean "
          "'angle'?\n"
          "  angel 60\n"
          "  ^");
    // A keyword ends where its letters end, in any alphabet.
    CHECK(findings("idé A-1\naxiom F") ==
          "x.lsys:1:1: error: expected a setting or a rule with '->', found 'idé'\n"
          "  idé A-1\n"
          "  ^");
    CHECK(findings("id\u00a0A-1\naxiom F").empty());
    // The last byte of a letter may be the number of a blank.
    const Model named = read_lsystem("title voilà \nsource à#b \u00a0# c\naxiom F", "x.lsys");
    CHECK(named.title == "voilà");
    CHECK(named.source == "à#b");
    CHECK(findings("axiom F\nF = FF") ==
          "x.lsys:2:1: error: expected a setting or a rule with '->', found 'F'; did you mean "
          "'->' instead of '='?\n"
          "  F = FF\n"
          "  ^");
    CHECK(
        findings("axiom F F -> F") ==
        "x.lsys:1:1: error: expected a line break or ';' between the setting 'axiom' and the rule\n"
        "  axiom F F -> F\n"
        "  ^");
}

TEST_CASE("settings given twice, not at all or without a value") {
    CHECK(findings("axiom F\naxiom G\nangle 3\nangle 4") ==
          "x.lsys:2:1: error: 'axiom' is given twice, first in line 1\n"
          "  axiom G\n"
          "  ^\n"
          "x.lsys:4:1: error: 'angle' is given twice, first in line 3\n"
          "  angle 4\n"
          "  ^");
    CHECK(findings("F -> F\n") ==
          "x.lsys:2:1: error: expected an axiom before the end of the file, found none");
    CHECK(
        findings("axiom") ==
        "x.lsys:1:6: error: expected a word after 'axiom' (the empty word is ε), found the end of "
        "the line\n"
        "  axiom\n"
        "       ^");
    CHECK(findings("axiom F;angle ; step") ==
          "x.lsys:1:15: error: expected a value after 'angle', found ';'\n"
          "  axiom F;angle ; step\n"
          "                ^\n"
          "x.lsys:1:21: error: expected a value after 'step', found the end of the line\n"
          "  axiom F;angle ; step\n"
          "                      ^");
    CHECK(findings("").starts_with("x.lsys:1:1: error: expected an axiom before the end"));
}

TEST_CASE("names that stand for nothing, with a suggestion") {
    CHECK(findings("axiom F(y)\nlet radius = 2\nA(x) : z > 3 -> B(radios, x)") ==
          "x.lsys:1:9: error: expected a number or a constant, found 'y'\n"
          "  axiom F(y)\n"
          "          ^\n"
          "x.lsys:3:8: error: expected a parameter or a constant, found 'z'\n"
          "  A(x) : z > 3 -> B(radios, x)\n"
          "         ^\n"
          "x.lsys:3:19: error: expected a parameter or a constant, found 'radios'; did you mean "
          "'radius'?\n"
          "  A(x) : z > 3 -> B(radios, x)\n"
          "                    ^");
    // A faulty constant is reported once, not at each of its uses.
    CHECK(findings("axiom F(r)\nlet r = \nangle 2*r\nF -(r)-> F") ==
          "x.lsys:2:8: error: expected a number or a name, found the end of the line\n"
          "  let r =\n"
          "         ^");
}

TEST_CASE("numbers out of range and expressions without a value") {
    CHECK(
        findings("axiom a\nangle 1/0\nwidth -1\nstep 10^400\nshrink sqrt(-1)\nspin 2*\nscale 1 2\n"
                 "narrow log(0)") ==
        "x.lsys:2:9: error: division by 0 in '1/0'\n"
        "  angle 1/0\n"
        "          ^\n"
        "x.lsys:3:7: error: expected a width above 0, found '-1'\n"
        "  width -1\n"
        "        ^\n"
        "x.lsys:4:6: error: the value of '10^400' is too large\n"
        "  step 10^400\n"
        "       ^\n"
        "x.lsys:5:8: error: the square root of a negative number in 'sqrt(-1)'\n"
        "  shrink sqrt(-1)\n"
        "         ^\n"
        "x.lsys:6:8: error: expected a number or a name, found the end of the line\n"
        "  spin 2*\n"
        "         ^\n"
        "x.lsys:7:9: error: expected an operator, found '2'\n"
        "  scale 1 2\n"
        "          ^\n"
        "x.lsys:8:8: error: the logarithm of a number that is not positive in 'log(0)'\n"
        "  narrow log(0)\n"
        "         ^");
    CHECK(findings("axiom a\ngeneration 3..2") ==
          "x.lsys:2:15: error: expected a generation from 3 on, found 2\n"
          "  generation 3..2\n"
          "                ^");
    CHECK(findings("axiom a\ngeneration 9223372036854775808") ==
          "x.lsys:2:12: error: expected a generation below 2^63, found '9223372036854775808'\n"
          "  generation 9223372036854775808\n"
          "             ^");
    CHECK(findings("axiom a\ngeneration 9223372036854775807") == "");
    CHECK(findings("axiom a\ngeneration -1")
              .starts_with("x.lsys:2:12: error: expected a generation, found '-'"));
    CHECK(findings("axiom a\nlet x = 2^2^2^2^2^2\n")
              .starts_with("x.lsys:2:11: error: the value of '2^2^2^2^2' is too large"));
}

TEST_CASE("other settings") {
    CHECK(findings("axiom a\nstart 1 2\nturn left\ncolour red? blue\n"
                   "expect size 3: 4\nexpect lenght 3: 4\nexpect length: 4\nexpect length 3 4\n"
                   "expect length 3:") ==
          "x.lsys:2:10: error: expected a heading, found the end of the line\n"
          "  start 1 2\n"
          "           ^\n"
          "x.lsys:3:6: error: expected 'clockwise' or 'counter-clockwise', found 'left'\n"
          "  turn left\n"
          "       ^\n"
          "x.lsys:4:8: error: expected a colour's name or #rrggbb, found 'red?'\n"
          "  colour red? blue\n"
          "         ^\n"
          "x.lsys:5:8: error: expected one of length, lengths, mean, word, segments, distinct, "
          "vertices, "
          "end, box, found 'size'\n"
          "  expect size 3: 4\n"
          "         ^\n"
          "x.lsys:6:8: error: expected one of length, lengths, mean, word, segments, distinct, "
          "vertices, "
          "end, box, found 'lenght'; did you mean 'length'?\n"
          "  expect lenght 3: 4\n"
          "         ^\n"
          "x.lsys:7:14: error: expected a generation, found ':'\n"
          "  expect length: 4\n"
          "               ^\n"
          "x.lsys:8:17: error: expected ':', found '4'\n"
          "  expect length 3 4\n"
          "                  ^\n"
          "x.lsys:9:17: error: expected a value, found the end of the line\n"
          "  expect length 3:\n"
          "                  ^");
    CHECK(findings("axiom a\nstart 1 2 3 4") ==
          "x.lsys:2:13: error: expected the end of the line after x, y and heading, found '4'\n"
          "  start 1 2 3 4\n"
          "              ^");
    CHECK(findings("axiom a\nalphabet title a=b\nlet = 3\nlet x 3\nlet y = 2\nlet y = 3\n"
                   "interpret F\nignore F(2)") ==
          "x.lsys:2:10: error: expected another name, 'title' has a meaning in the notation\n"
          "  alphabet title a=b\n"
          "           ^\n"
          "x.lsys:3:5: error: expected a constant's name, found '='\n"
          "  let = 3\n"
          "      ^\n"
          "x.lsys:4:7: error: expected '=', found '3'\n"
          "  let x 3\n"
          "        ^\n"
          "x.lsys:6:5: error: the constant 'y' is given twice\n"
          "  let y = 3\n"
          "      ^\n"
          "x.lsys:7:12: error: expected a rule with '->', found the end of the line\n"
          "  interpret F\n"
          "             ^\n"
          "x.lsys:8:9: error: expected symbols without parameters, found '('\n"
          "  ignore F(2)\n"
          "          ^");
}

TEST_CASE("environments") {
    CHECK(findings("axiom A?E(0)\nenvironment ?E y\nenvironment ?F_1 clip 0 0 (1 + 1) 3\n"
                   "environment ?G light 1/2; environment ?C collision 0.5") == "");
    CHECK(
        findings(
            "axiom A?E(0)\nenvironment E y\nenvironment ?E\nenvironment ?E hight\n"
            "environment ?E y 3\nenvironment ?E clip 1 2 3\nenvironment ?E clip 1 2 3 4 5 6 7\n"
            "environment ?E clip 0 0 1 -1\nenvironment ?E light\nenvironment ?E light 0\n"
            "environment ?E light 1 2\nenvironment ?EE y\nenvironment ?E y\n"
            "environment ?E x") ==
        "x.lsys:2:13: error: expected a communication module, such as ?E, found 'E'\n"
        "  environment E y\n"
        "              ^\n"
        "x.lsys:3:15: error: expected a kind of environment, such as 'position', found the end of "
        "the line\n"
        "  environment ?E\n"
        "                ^\n"
        "x.lsys:4:16: error: expected one of x, y, z, position, heading, clip, collision, light, "
        "external, found 'hight'; did you mean 'light'?\n"
        "  environment ?E hight\n"
        "                 ^\n"
        "x.lsys:5:18: error: expected the end of the line, found '3'\n"
        "  environment ?E y 3\n"
        "                   ^\n"
        "x.lsys:6:26: error: expected two corners, X Y X Y or X Y Z X Y Z, found the end of the "
        "line\n"
        "  environment ?E clip 1 2 3\n"
        "                           ^\n"
        "x.lsys:7:33: error: expected the end of the line after two corners, X Y X Y or X Y Z X "
        "Y Z, found '7'\n"
        "  environment ?E clip 1 2 3 4 5 6 7\n"
        "                                  ^\n"
        "x.lsys:8:27: error: expected a number from 0 on, as the second corner is above the "
        "first, found '-1'\n"
        "  environment ?E clip 0 0 1 -1\n"
        "                            ^\n"
        "x.lsys:9:21: error: expected a radius, found the end of the line\n"
        "  environment ?E light\n"
        "                      ^\n"
        "x.lsys:10:22: error: expected a radius above 0, found '0'\n"
        "  environment ?E light 0\n"
        "                       ^\n"
        "x.lsys:11:24: error: expected the end of the line after a radius, found '2'\n"
        "  environment ?E light 1 2\n"
        "                         ^\n"
        "x.lsys:12:13: error: expected a communication module, such as ?E, found '?EE'\n"
        "  environment ?EE y\n"
        "              ^\n"
        "x.lsys:14:13: error: the environment of '?E' is given twice\n"
        "  environment ?E x\n"
        "              ^");
}

TEST_CASE("stamps, plots and seeds that are none") {
    CHECK(findings("axiom S\nstamp S\nstamp ST circle\nstamp T sqare\nseed 3..1") ==
          "x.lsys:2:8: error: expected a symbol and a shape: square, circle or triangle, found the "
          "end "
          "of the line\n"
          "  stamp S\n"
          "         ^\n"
          "x.lsys:3:7: error: expected one symbol and a shape, found 2 symbols\n"
          "  stamp ST circle\n"
          "        ^\n"
          "x.lsys:4:9: error: expected square, circle or triangle, found 'sqare'; did you mean "
          "'square'?\n"
          "  stamp T sqare\n"
          "          ^\n"
          "x.lsys:5:9: error: expected a seed from 3 on, found 1\n"
          "  seed 3..1\n"
          "          ^");
    CHECK(findings("axiom S\nstamp S circle\nstamp S square\nplot F\nplot G") ==
          "x.lsys:3:7: error: the symbol 'S' has a stamp already\n"
          "  stamp S square\n"
          "        ^\n"
          "x.lsys:5:1: error: 'plot' is given twice, first in line 4\n"
          "  plot G\n"
          "  ^");
}

TEST_CASE("solids and surfaces that are none") {
    CHECK(
        findings("axiom S\nsolid S\nsolid ST box\nsolid T cube\nsolid T cone width\n"
                 "solid U box width _width\nsurface K\nsurface K leave\nsurface K leaf (0,0,0)\n"
                 "surface K polygon (0,0,0) (1,0,0)\nsurface K polygon (0,0,0) (1,0)\n"
                 "surface K patch (0,0,0)\nsurface K polygon 1") ==
        "x.lsys:2:8: error: expected a symbol and box, cylinder, cone, sphere, rotation or "
        "translation, found the end of the line\n"
        "  solid S\n"
        "         ^\n"
        "x.lsys:3:7: error: expected one symbol, found 2 symbols\n"
        "  solid ST box\n"
        "        ^\n"
        "x.lsys:4:9: error: expected box, cylinder, cone, sphere, rotation or translation, found "
        "'cube'\n"
        "  solid T cube\n"
        "          ^\n"
        "x.lsys:5:14: error: expected radius, height or colour, found 'width'\n"
        "  solid T cone width\n"
        "               ^\n"
        "x.lsys:6:19: error: the measure '_width' is given twice\n"
        "  solid U box width _width\n"
        "                    ^\n"
        "x.lsys:7:10: error: expected a symbol and leaf, petal, disc, polygon or patch, found the "
        "end of the line\n"
        "  surface K\n"
        "           ^\n"
        "x.lsys:8:11: error: expected leaf, petal, disc, polygon or patch, found 'leave'\n"
        "  surface K leave\n"
        "            ^\n"
        "x.lsys:9:16: error: expected the end of the line, found '('\n"
        "  surface K leaf (0,0,0)\n"
        "                 ^\n"
        "x.lsys:10:11: error: expected at least three points for a polygon, found 2\n"
        "  surface K polygon (0,0,0) (1,0,0)\n"
        "            ^\n"
        "x.lsys:11:27: error: expected a point (x,y,z), found 2 numbers\n"
        "  surface K polygon (0,0,0) (1,0)\n"
        "                            ^\n"
        "x.lsys:12:11: error: expected 16 points for a patch, row by row, found 1\n"
        "  surface K patch (0,0,0)\n"
        "            ^\n"
        "x.lsys:13:19: error: expected a point (x,y,z), found '1'\n"
        "  surface K polygon 1\n"
        "                    ^");
    CHECK(findings("axiom S\nstamp S circle\nsolid S box\nsurface K leaf\nsolid K box") ==
          "x.lsys:3:7: error: the symbol 'S' has a stamp already\n"
          "  solid S box\n"
          "        ^\n"
          "x.lsys:4:9: error: the symbol 'K' has a solid already\n"
          "  surface K leaf\n"
          "          ^");
}

TEST_CASE("views and tropisms that are none") {
    CHECK(findings("axiom S\nelasticity S F_a\n") ==
          "x.lsys:2:12: error: expected letters that tell the turtle nothing else, found 'F_a'\n"
          "  elasticity S F_a\n"
          "             ^");
    CHECK(
        findings("axiom S\ntropism 0 0 0\nsusceptibility 1 2\ncamera 1\nlight 3 91\nfog 2") ==
        "x.lsys:2:9: error: expected a direction, found the zero vector\n"
        "  tropism 0 0 0\n"
        "          ^\n"
        "x.lsys:3:18: error: expected the end of the line after a number, found '2'\n"
        "  susceptibility 1 2\n"
        "                   ^\n"
        "x.lsys:4:9: error: expected an azimuth and an elevation in degrees, found the end of the "
        "line\n"
        "  camera 1\n"
        "          ^\n"
        "x.lsys:5:9: error: expected an elevation from -90 to 90 degrees, found '91'\n"
        "  light 3 91\n"
        "          ^\n"
        "x.lsys:6:5: error: expected a share from 0 to 1, found '2'\n"
        "  fog 2\n"
        "      ^");
    CHECK(findings("axiom S\ntropism 0 0\ncamera 1 2 isometric") ==
          "x.lsys:2:12: error: expected three coordinates, found the end of the line\n"
          "  tropism 0 0\n"
          "             ^\n"
          "x.lsys:3:12: error: expected perspective, found 'isometric'\n"
          "  camera 1 2 isometric\n"
          "             ^");
    CHECK(findings("axiom S\ncamera 1 2 perspective 180") ==
          "x.lsys:2:24: error: expected degrees from 1 to 120, found '180'\n"
          "  camera 1 2 perspective 180\n"
          "                         ^");
}

TEST_CASE("a value does not begin like a comment, which it would be behind a blank") {
    for (const std::string keyword : {"title", "source", "id", "angle"})
        CHECK(findings("axiom F\n" + keyword + "#5")
                  .starts_with("x.lsys:2:" + std::to_string(keyword.size() + 1) +
                               ": error: expected a value after '" + keyword +
                               "', found '#'; a comment needs a blank before\n"));
    CHECK(findings("axiom F\ncolour#ff0000").empty());
    CHECK(findings("axiom F\nexpect segments 1:#4") ==
          "x.lsys:2:19: error: expected a value, found '#'; a comment needs a blank before\n"
          "  expect segments 1:#4\n"
          "                    ^");
    CHECK(findings("axiom F\nexpect segments 1: # 4") ==
          "x.lsys:2:19: error: expected a value, found the end of the line\n"
          "  expect segments 1: # 4\n"
          "                    ^");
}

TEST_CASE("panels and pictures that are none") {
    CHECK(findings("axiom S\ncolumns 0\ncommon-scale perhaps\npicture tee\nstart up") ==
          "x.lsys:2:9: error: expected how many panels stand in a row, from 1 on, found '0'\n"
          "  columns 0\n"
          "          ^\n"
          "x.lsys:3:14: error: expected yes or no, found 'perhaps'\n"
          "  common-scale perhaps\n"
          "               ^\n"
          "x.lsys:4:9: error: expected figure, table, tree or plot, found 'tee'; did you mean "
          "'tree'?\n"
          "  picture tee\n"
          "          ^\n"
          "x.lsys:5:7: error: expected a number or a constant, found 'up'\n"
          "  start up\n"
          "        ^");
}

TEST_CASE("labels without a point or a text") {
    const auto wanted = [](const std::string& label, const std::string& place) {
        return "x.lsys:2:" + place +
               ": error: expected a point and a text, such as 'label 0 1 B' or 'label (0,0,2) "
               "top', found the end of the line\n  " +
               label;
    };
    CHECK(findings("axiom F\nlabel 0 1").starts_with(wanted("label 0 1", "10")));
    CHECK(findings("axiom F\nlabel (0,0,2)").starts_with(wanted("label (0,0,2)", "14")));
    CHECK(findings("axiom F\nlabel (0,2) B") ==
          "x.lsys:2:7: error: expected a point (x,y,z), found 2 numbers\n"
          "  label (0,2) B\n"
          "        ^");
    CHECK(findings("axiom F\nlabel zero 1 B").find("found 'zero'") != std::string::npos);
}
