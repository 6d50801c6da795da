#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "exchange/any_brno.hpp"
#include "exchange/compared.hpp"
#include "exchange/detail/formats.hpp"
#include "exchange/exchange.hpp"
#include "model/model.hpp"
#include "nature/nature.hpp"
#include "notation/notation.hpp"

using namespace algae;
using namespace algae::exchange_tests;

namespace {

std::string of_gallery(const std::string& name) { return std::string(find_generator(name)->text); }
std::string there(const std::string& text, const std::string& kind) {
    return converted(text, "x." + kind + "-table", kind + "-table", kind, {});
}
std::string back(const std::string& text, const std::string& kind) {
    return converted(text, "x." + kind, kind, kind + "-table", {});
}
std::string brief(const std::string& text, const std::string& kind) {
    const std::string all = refusal([&] { there(text, kind); });
    return all.substr(0, all.find('\n'));
}

const std::string fern =
    "map 0 0 0 0.16 0 0 0.01\nmap 0.85 0.04 -0.04 0.85 0 1.6 0.85\n"
    "map 0.2 -0.26 0.23 0.22 0 1.6 0.07\nmap -0.15 0.28 0.26 0.24 0 0.44 0.07\n";

}  // namespace

TEST_CASE("the fern's table, in the forms in which it is printed, gives the fern's maps") {
    const char* const tables[] = {
        "w\ta\tb\tc\td\te\tf\tp\n1\t0\t0\t0\t0.16\t0\t0\t0.01\n2\t0.85\t0.04\t-0.04\t0.85\t0\t1."
        "6\t0.85\n"
        "3\t0.2\t-0.26\t0.23\t0.22\t0\t1.6\t0.07\n4\t-0.15\t0.28\t0.26\t0.24\t0\t0.44\t0.07\n",
        "0 0 0 0.16 0 0 0.01\n.85 .04 -0.04 .85 0 1.6 .85 # the leaf\n\n0.2 -0.26 0.23 0.22 0 1.6 "
        "0.07\n"
        "-0.15 0.28 0.26 0.24 0 0.44 0.07",
        "w1 0 0 0 0.16 0 0 0.01\nw2 0.85 0.04 -0.04 0.85 0 1.6 0.85\n"
        "w3 0.2 -0.26 0.23 0.22 0 1.6 0.07\nw4 -0.15 0.28 0.26 0.24 0 0.44 0.07",
        "| p | a | b | c | d | e | f |\n|---|:-:|---|---|---|---|---|\n| 0.01 | 0 | 0 | 0 | 0.16 | "
        "0 | 0 |\n"
        "| 0.85 | 0.85 | 0.04 | -0.04 | 0.85 | 0 | 1.6 |\n| 0.07 | 0.2 | -0.26 | 0.23 | 0.22 | 0 | "
        "1.6 |\n"
        "| 0.07 | -0.15 | 0.28 | 0.26 | 0.24 | 0 | 0.44 |\n",
        "\\hline\n$w$ & $a$ & $b$ & $c$ & $d$ & $e$ & $f$ & $p$ \\\\ \\hline\n1 & 0 & 0 & 0 & 0.16 "
        "& 0 & 0 & 0.01\\\\\n"
        "2 & 0.85 & 0.04 & $-0.04$ & 0.85 & 0 & 1.6 & 0.85\\\\\n3 & 0.2 & -0.26 & 0.23 & 0.22 & 0 "
        "& 1.6 & 0.07\\\\\n"
        "4 & -0.15 & 0.28 & 0.26 & 0.24 & 0 & 0.44 & 0.07\\\\\\hline\n",
        "\\begin{table}[h]\n\\centering\n\\begin{tabular}{@{}c|rrrr|rr|r@{}}\n\\toprule\n"
        "W & A & B & C & D & E & F & P\\\\\n\\midrule\n1 & 0 & 0 & 0 & 0.16 & 0 & 0 & 0.01\\\\\n"
        "2 & 0.85 & 0.04 & -0.04 & 0.85 & 0 & 1.6 & 0.85\\\\\n3 & 0.2 & -0.26 & 0.23 & 0.22 & 0 "
        "& 1.6 & 0.07\\\\\n4 & -0.15 & 0.28 & 0.26 & 0.24 & 0 & 0.44 & 0.07\\\\\n"
        "\\bottomrule\n\\end{tabular}\n\\end{table}\n"};
    for (const char* table : tables) CHECK(there(table, "ifs") == fern);
    CHECK(
        back(of_gallery("fern.ifs"), "ifs") ==
        "# Barnsley's fern\n# 003 section 8, F-326\n"
        "w      a      b      c     d  e     f     p\n1      0      0      0  0.16  0     0  0.01\n"
        "2   0.85   0.04  -0.04  0.85  0   1.6  0.85\n3    0.2  -0.26   0.23  0.22  0   1.6  0.07\n"
        "4  -0.15   0.28   0.26  0.24  0  0.44  0.07\n");
    CHECK(there(back(of_gallery("fern.ifs"), "ifs"), "ifs") == fern);
    CHECK(there(back(of_gallery("sierpinski.ifs"), "ifs"), "ifs") ==
          "map 1/2 0 0 1/2 0 0\nmap 1/2 0 0 1/2 1/2 0\nmap 1/2 0 0 1/2 1/4 sqrt(3)/4\n");
    CHECK(there("a b c d e f\n1/2 0 0 cos(60) 0 0", "ifs") == "map 1/2 0 0 cos(60) 0 0\n");
}

TEST_CASE("faults of a table of maps are named with their places") {
    const std::pair<const char*, const char*> cases[] = {
        {"", "1:1: error: expected a row of numbers for each map, found the end of the file"},
        {"w a b c d e f p\n",
         "2:1: error: expected a row of numbers for each map, found the end of the file"},
        {"w a b c d e p\n1 0 0 0 0 0 1", "1:1: error: the table has no column f"},
        {"w a b c d e f a\n", "1:15: error: the column a is there twice"},
        {"0 0 0 0.16 0",
         "1:1: error: expected the numbers a b c d e f and perhaps p, with or without a name "
         "before them, found 5 cells"},
        {"w a b c d e f p\n1 0 0 0 0.16 0 0\n",
         "2:1: error: the row has no p: expected 8 cells, found 7"},
        {"0 0 0 0.5 0 0\n0 0 0 0.5 0 1 2\n",
         "2:15: error: expected the end of the row behind 6 cells, found '2'"},
        {"w1 0 0 0 0.5 0 0\nw1 0 0 0 0.5 0 1",
         "2:1: error: the map 'w1' is there twice, first in line 1"},
        {"0 0 0 0,16 0 0",
         "1:7: error: expected a number for d, found '0,16'; decimals have a point"},
        {"0 0 0 x 0 0", "1:7: error: expected a number for d, found 'x'"},
        {"0 0 0 1/0 0 0", "1:7: error: expected a number for d, found '1/0'"},
        {"0 0 0 0.5 0 0 0.5\n0 0 0 0.5 0 1 0.4",
         "2:15: error: the probabilities add up to 0.9, expected 1"},
        {"0 0 0 0.5 0 0 1.5\n0 0 0 0.5 0 1 -0.5",
         "2:15: error: expected a probability above 0, found '-0.5'"},
        {"w a b c d e f q\n1 0 0 0 0.5 0 0 1",
         "1:15: error: unknown column 'q', expected a, b, c, d, e, f or p"},
        {"w a b c d e f prob\n1 0 0 0 0.5 0 0 1",
         "1:15: error: unknown column 'prob', expected a, b, c, d, e, f or p"},
        {"w A B C D E F a\n", "1:15: error: the column a is there twice"},
        {"0 0 0 −0.5 0 0",
         "1:7: error: expected a number for d, found '−0.5' (U+2212); did you mean '-'?"}};
    for (const auto& [text, expected] : cases) {
        INFO(text);
        CHECK(brief(text, "ifs") == "x.ifs-table:" + std::string(expected));
    }
    CHECK(brief("2 0 0 0.5 0 0", "ifs").find("x.ifs-table") ==
          0);  // it does not bring points together
    CHECK(refusal([] { back("map 1/2 0 0 (1<2)/2 0 0\n", "ifs"); }) ==
          "x.ifs: the number (1 < 2)/2 cannot stand between the blanks of a table");
    CHECK(refusal([] {
              back("state a\nmap 1/2 0 0 1/2 0 0 -> b\nstate b\nmap 1/2 0 0 1/2 0 0 -> a\n", "ifs");
          }) == "x.ifs: has several states, and a table says maps of one");
}

TEST_CASE("the tables of rules 54, 110 and 126, as they are printed") {
    CHECK(there("$0\\underline{0}0 \\rightarrow 0$\t$1\\underline{0}0 \\rightarrow 1$\n"
                "$0\\underline{0}1 \\rightarrow 1$\t$1\\underline{0}1 \\rightarrow 1$\n"
                "$0\\underline{1}0 \\rightarrow 1$\t$1\\underline{1}0 \\rightarrow 0$\n"
                "$0\\underline{1}1 \\rightarrow 0$\t$1\\underline{1}1 \\rightarrow 0$\n\n---\n",
                "ca") == "rule 54\n");
    CHECK(there("000->0, 111->0, 001->1, 010->1, 100->1, 011 → 1; 101 ↦ 1 110\n->1 # all else",
                "ca") == "rule 126\n");
    CHECK(there("111 110 101 100 011 010 001 000\n 0   1   1   0   1   1   1   0", "ca") ==
          "rule 110\n");
    CHECK(there("| 111 | 110 | 101 | 100 |\n|---|---|---|---|\n| 0 | 1 | 1 | 0 |\n\n011 010 001 "
                "000\n1 1 1 0",
                "ca") == "rule 110\n");
    CHECK(back(of_gallery("rule-54.ca"), "ca") ==
          "# Rule 54\n# 003 section 3, F-314\n000 -> 0\n001 -> 1\n010 -> 1\n011 -> 0\n100 -> "
          "1\n101 -> 1\n"
          "110 -> 0\n111 -> 0\n");
    CHECK(refusal([] { back(of_gallery("glider.ca"), "ca"); }) ==
          "x.ca: lies in the plane, and a table is one of cells on a line");
}

TEST_CASE("faults of a table of cells are named with their places") {
    const std::pair<const char*, const char*> cases[] = {
        {"", "1:1: error: expected entries such as 001 -> 1, found the end of the file"},
        {"000 -> 0\n001 -> 1\n",
         "3:1: error: the entry of 010 is missing: a table of 2 states has one for each 3 of them"},
        {"000 001 010 011 100 101 110\n0 1 0 1 0 1 0",
         "2:14: error: the entry of 111 is missing: a table of 2 states has one for each 3 of "
         "them"},
        {"000 -> 2",
         "1:9: error: the entry of 001 is missing: a table of 3 states has one for each 3 of them"},
        {"000 -> 0\n001 -> 1\n000 -> 0",
         "3:1: error: the entry of 000 is there twice, first in line 1"},
        {"00 -> 0",
         "1:1: error: expected the states of a cell and of as many cells on each side, such as "
         "001, found '00'"},
        {"000 -> 0 01 -> 1", "1:10: error: expected 3 states as in the first entry, found '01'"},
        {"000 -> 01", "1:8: error: expected the next state, a single one, behind '000 ->'"},
        {"000 ->", "1:7: error: expected the next state, a single one, behind '000 ->'"},
        {"000 001 -> 1", "1:5: error: expected '->' behind '000'"},
        {"-> 1", "1:1: error: expected a local configuration, found '->'"},
        {"000 A -> 1", "1:5: error: expected states 0 to 9 and a to z, or an arrow, found 'A'"},
        {"000 001", "1:8: error: expected a line with the next states of the line above"},
        {"000 001\n0", "1:5: error: the configuration 001 has no next state below"},
        {"000\n0 1", "2:3: error: expected the end of the line: no configuration stands above"},
        {"000 001\n0 10", "2:3: error: expected the next state, a single one, of 001, found '10'"}};
    for (const auto& [text, expected] : cases) {
        INFO(text);
        CHECK(brief(text, "ca") == "x.ca-table:" + std::string(expected));
    }
}

TEST_CASE("what cannot be converted is told what it can become, and what is no format") {
    const auto refused = [](const std::string& from, const std::string& to) {
        return refusal([&] { converted("", "x", from, to, {}); });
    };
    CHECK(refused("dla", "lsys") == "x: cannot convert dla to lsys; dla converts to nothing");
    CHECK(refused("ifs-table", "ca") ==
          "x: cannot convert ifs-table to ca; ifs-table converts to ifs");
    CHECK(refused("ca", "brno") ==
          "x: cannot convert ca to brno; ca converts to lsys and ca-table");
    CHECK(
        refused("lsys", "dla") ==
        "x: cannot convert lsys to dla; lsys converts to ifs, brno, maple, netlogo, l, cpfg, lpfg, "
        "lpy, inkscape, tikz, jff, walnut "
        "and sage");
    CHECK(
        refused("brno", "ifs") ==
        "x: cannot convert brno to ifs; brno converts to lsys, maple, netlogo, l, cpfg, lpfg, lpy, "
        "inkscape, tikz, jff, walnut "
        "and sage");
    CHECK(refused("lsys", "pdf") ==
          "x: 'pdf' is no format; expected one of ifs, brno, maple, netlogo, l, cpfg, lpfg, lpy, "
          "inkscape, tikz, jff, walnut, sage, "
          "lsys");
    CHECK(refused("dla", "pdf") == "x: 'pdf' is no format; expected dla");
    for (const auto& [from, to] :
         {std::pair("pdf", "dla"), std::pair("pdf", "lsys"), std::pair("pdf", "pdf")})
        CHECK(
            refused(from, to).starts_with("x: 'pdf' is no format; expected one of boxes, brno, "));
}

TEST_CASE("what no functions stand for is named with its file") {
    const auto refused = [](const std::string& text) {
        return refusal([&] { converted(text, "x.lsys", "lsys", "ifs", {}); });
    };
    CHECK(refused("axiom F; F -> F+F; angle 41.37") ==
          "x.lsys: the angle 41.37 is no rational part of a turn with a denominator up to 360");
    CHECK(refused("axiom F; F -> F+F; angle 60; start 0 0 sqrt(2)") ==
          "x.lsys: the start's heading, together with the angle, is no rational part of a turn "
          "with a denominator up to 360");
    CHECK(refused("axiom F; F -> F; F -> FF") == "x.lsys: not a D0L system: F has 2 rules");
    CHECK(refused("axiom f; f -> fff") == "x.lsys: nothing is drawn in late generations");
}

TEST_CASE("in its own format a text becomes the canonical one") {
    CHECK(converted("angle 60 # degrees\naxiom F", "x", "lsys", "lsys", {}) ==
          "axiom F\nangle 60 # degrees\n");
    CHECK(converted("rule   110", "x", "ca", "ca", {}) == "rule 110\n");
    const std::string table = back("rule 110\n", "ca");
    CHECK(converted("111 110 101 100 011 010 001 000\n0 1 1 0 1 1 1 0", "x", "ca-table", "ca-table",
                    {}) == table);
    CHECK(converted(table, "x", "ca-table", "ca-table", {}) == table);
    CHECK(converted("1/2 0 0 1/2 0 0", "x", "ifs-table", "ifs-table", {}) ==
          back("map 1/2 0 0 1/2 0 0\n", "ifs"));
}

TEST_CASE("errors about a configuration of a million cells are short") {
    const std::string cells(1'000'001, '0'), more(1'000'003, '0');
    for (const std::string& text :
         {cells + " -> 0", cells + " -> 00", cells + " -> 0 " + cells + " -> 0",
          cells + " -> 0 " + more + " -> 0", cells, cells + " 0\n0", cells + "\n00",
          more + "0 -> 0"})
        CHECK(refusal([&] { there(text, "ca"); }).size() < 500);
}

TEST_CASE("any rule of cells on a line goes through its table, its entries in any order") {
    CHECK(rc::check([] {
        const int states = 2 + below(3), radius = states == 2 ? 1 + below(3) : 1;
        std::size_t entries = 1;
        for (int i = 0; i < 2 * radius + 1; ++i) entries *= static_cast<std::size_t>(states);
        std::string text =
            "states " + std::to_string(states) + "\nradius " + std::to_string(radius) + "\ntable";
        for (std::size_t n = 0; n < entries; ++n) {
            text += ' ';
            std::string cells(static_cast<std::size_t>(2 * radius + 1), '0');
            std::size_t rest = n;
            for (std::size_t i = cells.size(); i-- > 0; rest /= static_cast<std::size_t>(states))
                cells[i] = static_cast<char>('0' + rest % static_cast<std::size_t>(states));
            text += cells + "->" + std::to_string(below(states));
        }
        const std::string table = back(text + "\n", "ca"), read = there(table, "ca");
        RC_ASSERT(back(read, "ca") == table);
        const auto rule = [](const std::string& said) {
            const auto generator = read_generator(said, "x.ca");
            return dynamic_cast<const CellularAutomaton&>(*generator).rule;
        };
        RC_ASSERT(rule(read) == rule(text));
        std::vector<std::string> lines;
        for (std::size_t at = 0; at < table.size(); at = table.find('\n', at) + 1)
            lines.push_back(table.substr(at, table.find('\n', at) - at));
        for (std::size_t i = lines.size(); i > 1; --i)
            std::swap(lines[i - 1], lines[static_cast<std::size_t>(below(static_cast<int>(i)))]);
        std::string mixed;
        for (const std::string& line : lines)
            mixed += line + one_of({"\n", "\t", " | ", " \\\\\n"});
        RC_ASSERT(there(mixed, "ca") == read);
    }));
}

TEST_CASE("any maps go through their table") {
    CHECK(rc::check([] {
        const int maps = 1 + below(5);
        const bool chances = below(2) == 0;
        std::string text;
        for (int i = 0; i < maps; ++i) {
            text += "map";
            for (int k = 0; k < 6; ++k)
                text +=
                    " " + one_of({"0", "1/3", "-0.25", "0.5", "sqrt(2)/4", "-1/4*sin(60)", "1e-3"});
            text += (chances ? " 1/" + std::to_string(maps) : "") + "\n";
        }
        std::string table;
        try {
            table = back(text, "ifs");
        } catch (const Error& error) {
            RC_DISCARD(error.what());
        }
        const std::string read = there(table, "ifs");
        RC_ASSERT(back(read, "ifs") == table);
        const auto first = read_generator(text, "x.ifs"), second = read_generator(read, "x.ifs");
        const auto& a = dynamic_cast<const IteratedFunctions&>(*first).maps;
        const auto& b = dynamic_cast<const IteratedFunctions&>(*second).maps;
        RC_ASSERT(a.size() == b.size());
        for (std::size_t i = 0; i < a.size(); ++i) {
            for (std::size_t k = 0; k < 6; ++k)
                RC_ASSERT(a[i].numbers[k].value == b[i].numbers[k].value);
            RC_ASSERT(a[i].probability == b[i].probability);
        }
    }));
}

TEST_CASE("no table, however broken, ends in anything but a file or an error") {
    const auto survive = [](const std::string& text) {
        for (const std::string kind : {"ca", "ifs"}) {
            try {
                const std::string read = there(text, kind);
                RC_ASSERT(there(back(read, kind), kind) == read);
            } catch (const Error& error) {
                RC_ASSERT(std::string(error.what()).starts_with("x." + kind + "-table"));
            }
        }
    };
    CHECK(rc::check([&] { survive(*rc::gen::arbitrary<std::string>()); }));
    CHECK(rc::check([&] {
        std::string text = one_of({"111 110 101 100 011 010 001 000\n0 1 1 0 1 1 1 0\n",
                                   "000->0 001->1 010->1 011->1 100->1 101->1 110->1 111->0",
                                   "w a b c d e f p\n1 0 0 0 0.5 0 0 0.5\n2 0 0.5 0 0 1 1 0.5\n"});
        for (int i = 1 + below(3); i > 0; --i) {
            const auto at = static_cast<std::size_t>(below(static_cast<int>(text.size())));
            const std::string piece = one_of({"", "0", "1", "->", "-", "|", "\n", " ", "2", "z",
                                              "\\", "(", "\xc3", "é", "#", ","});
            text.replace(at, static_cast<std::size_t>(below(3)), piece);
        }
        survive(text);
    }));
    std::string long_line;
    for (int i = 0; i < 200'000; ++i) long_line += "z";
    survive(long_line + "0 -> z");
    for (const char* part : {"(", "0 ", "000->0 ", "-", "z", "|", "\\underline{", "1+", "2^"}) {
        std::string text;
        for (int i = 0; i < 100'000; ++i) text += part;
        survive(text);
    }
}

TEST_CASE("b-files of the OEIS have a line for each term") {
    const BFile file = read_b_file("# A000045\n1 1\n2 1 # twice\n\n3 2\r\n", "b.txt");
    CHECK(file.first == 1);
    CHECK(file.terms == std::vector<Integer>{1, 1, 2});
    CHECK(print_b_file(file) == "1 1\n2 1\n3 2\n");
    const auto said = [](const std::string& text) -> std::string {
        try {
            read_b_file(text, "b.txt");
        } catch (const Error& error) {
            return error.what();
        }
        return {};
    };
    CHECK(said("0 1\n2 1\n")
              .starts_with("b.txt:2:1: error: expected the term of n = 1, found n = 2"));
    CHECK(said("0\n").starts_with("b.txt:1:1: error: expected a line `n a(n)`, found 1 piece"));
    CHECK(
        said("0 1 2\n").starts_with("b.txt:1:5: error: expected a line `n a(n)`, found 3 pieces"));
    CHECK(said("0 1.5\n").starts_with(
        "b.txt:1:3: error: expected a(n), a whole number, found '1.5'"));
    CHECK(said("# nothing\n").starts_with("b.txt:1:1: error: expected lines `n a(n)`, found none"));
    CHECK(rc::check("what is printed is read back", [] {
        BFile written{Integer(*rc::gen::inRange(-5, 5)), {}};
        for (int i = *rc::gen::inRange(1, 20); i > 0; --i)
            written.terms.emplace_back(*rc::gen::inRange(-1000000, 1000000));
        const BFile again = read_b_file(print_b_file(written), "b.txt");
        RC_ASSERT(again.first == written.first);
        RC_ASSERT(again.terms == written.terms);
    }));
}
