#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "command/run.hpp"

namespace {

nlohmann::json json_of(const std::string& arguments) {
    return nlohmann::json::parse(run("words " + arguments + " --json").out);
}

}  // namespace

TEST_CASE("words says of one word what the definitions say") {
    // By hand: a b a a b.
    const auto found = json_of("abaab");
    CHECK(found["periods"] == std::vector<int>{3, 5});
    CHECK(found["borders"] == std::vector<int>{2});
    CHECK(found["primitive_root"] == "abaab");
    CHECK(found["primitive"] == true);
    CHECK(found["exponent"] == "5/3");
    CHECK(found["least_conjugate"] == "aabab");
    CHECK(found["conjugates"] == 5);
    CHECK(found["lyndon_factorisation"] == std::vector<std::string>{"ab", "aab"});
    CHECK(found["palindromes"] == 5);
    CHECK(found["longest_palindromes"] == std::vector<std::string>{"baab"});
    CHECK(found["defect"] == 0);
    CHECK(found["palindromic_length"] == 2);
    CHECK(found["runs"] == 1);
    CHECK(found["distinct_squares"] == 1);
    CHECK(found["distinct_factors"] == 12);
    const std::string page = run("words abaab").out;
    CHECK(page.find("order of letters        a < b\n") != std::string::npos);
    CHECK(page.find("defect                  0: the word is rich\n") != std::string::npos);
    CHECK(page.find("Abelian periods         2 after 1 letter, 3, 4, 5\n") != std::string::npos);
}

TEST_CASE("words: the order of letters, words that are names, words in files") {
    CHECK(json_of("level")["lyndon_factorisation"] == std::vector<std::string>{"l", "ev", "el"});
    CHECK(json_of("level --order 'l v e'")["lyndon_factorisation"] ==
          std::vector<std::string>{"leve", "l"});
    CHECK(json_of("--word koch")["length"] == 4);  // a name of the gallery
    const Scratch files;
    CHECK(json_of("--letters " + files.file("w.txt", "ab\na ab\n"))["exponent"] == "5/3");
    CHECK(json_of("ε")["length"] == 0);
    CHECK(json_of("ε")["exponent"].is_null());
}

TEST_CASE("words of a system: complexities up to a length") {
    const auto found = json_of("fibonacci --to 6");
    CHECK(found["factor_complexity"]["values"] == std::vector<int>{1, 2, 3, 4, 5, 6, 7});
    CHECK(found["factor_complexity"]["proved_for_all"] == true);
    CHECK(found["palindromic_complexity"]["values"] == std::vector<int>{1, 2, 1, 2, 1, 2, 1});
    CHECK(found["abelian_complexity"]["values"] == std::vector<int>{1, 2, 2, 2, 2, 2, 2});
    CHECK(found["imbalance_values"] == std::vector<int>{0, 1, 1, 1, 1, 1, 1});
    CHECK(found["closed_under_reversal"] == true);
    CHECK(found["critical_exponent"]["exact"] == "(5+sqrt(5))/2");
    CHECK(found["critical_exponent"]["attained"] == false);
    CHECK(found["return_words"]["b"] == std::vector<std::string>{"ba", "baa"});
    CHECK(found["recurrence_function"]["values"] == std::vector<int>{0, 3, 6, 10, 11, 17, 18});
    CHECK(found["bispecial"].size() == 4);
    CHECK(found["frequencies"]["a"]["exact"] == "(-1+sqrt(5))/2");
    CHECK(found["imbalance"]["a"] == 1);
    CHECK(found["primitive"] == true);
    CHECK(found["circular"] == true);
    CHECK(run("words fibonacci --to 6").out.find("closed under reversal   yes: proved\n") !=
          std::string::npos);
}

TEST_CASE("words of a system whose only letter stays as it is do not go on for ever") {
    const auto found = json_of("'axiom bb; b -> b' --to 3 --timeout 20");
    CHECK(found["factor_complexity"]["values"] == std::vector<int>{1, 1, 1, 0});
    CHECK(found["factor_complexity"]["proved_for_all"] == false);
    CHECK(found["primitive"] == true);
}

TEST_CASE("words: what is asked wrongly is told") {
    const auto told = [](const std::string& arguments) {
        const Run answer = run("words " + arguments);
        CHECK(answer.status == 2);
        CHECK(answer.out.empty());
        return answer.err;
    };
    CHECK(told("") == "algae: expected a word, a system, --word WORD or --letters FILE\n");
    CHECK(
        told("ab --word ab") ==
        "algae: expected one of a word, a system, --word WORD and --letters FILE, found several\n");
    CHECK(told("ab --to 4") ==
          "algae: --to is for the factors of a system, and one word has finitely many\n");
    CHECK(told("ab --order a") ==
          "algae: --order: expected all letters of the word, found none of the name 'b'\n");
    CHECK(told("ab --order 'a b a'") ==
          "algae: --order: expected each letter once, found 'a' again\n");
    CHECK(told("koch --order F") == "algae: --order is for one word, and koch is a system\n");
    CHECK(told("'A(1)'") == "algae: a word of letters is expected, without parameters\n");
    const Scratch files;
    const std::string choices = files.file("o.lsys", "axiom a\na -> ab | b\nb -> a\n");
    CHECK(told(choices).ends_with("found one with choices; --word " + choices + " is the word\n"));
    CHECK(told("--letters " + files.file("x.txt", "ab\xff"))
              .ends_with("x.txt: expected text in UTF-8, found another byte at 2\n"));
    const Run small = run("words --letters " + files.file("l.txt", std::string(300'000, 'a')) +
                          " --max-memory 10M");
    CHECK(small.status == 3);
}

TEST_CASE("words of a system with a coding are those after it") {
    // The Rudin-Shapiro word has 2, 4, 8, 16, 24, 36, 46 factors of 1 to 7 letters, and 8(n - 1) from n = 8 on
    // (Allouche and Shallit, Enseignement mathematique 39, 1993).
    const auto report = nlohmann::json::parse(run("words rudin-shapiro --to 10 --json").out);
    CHECK(report["coded"] == true);
    CHECK(report["factor_complexity"]["values"] ==
          nlohmann::json::parse("[1, 2, 4, 8, 16, 24, 36, 46, 56, 64, 72]"));
    CHECK(run("words rudin-shapiro")
              .out.find("the infinite word of the system, after the coding\n") !=
          std::string::npos);
}

TEST_CASE("words decides first-order statements") {
    const Run overlap = run(
        "words thue-morse --say 'for some i, n with n >= 1: for all k <= n: T[i+k] = T[i+n+k]'");
    CHECK(overlap.status == 1);
    CHECK(overlap.out.find("verdict                 refuted\n") != std::string::npos);
    const Run cube =
        run("words 'a -> ab, b -> a' --json --say 'for some i, n with n >= 1: for all k < 2n: "
            "T[i+k] = T[i+n+k]'");
    CHECK(cube.status == 0);
    const auto json = nlohmann::json::parse(cube.out);
    CHECK(json["verdict"] == "proved");
    CHECK(json["witness"] == nlohmann::json::parse(R"({"i": 5, "n": 3})"));
    const auto orders = nlohmann::json::parse(
        run("words paperfolding --json --say 'n >= 1 and for some i: equal(i, i+n, n)'").out);
    CHECK(orders["verdict"].is_null());
    // Allouche and Bousquet-Melou 1995.
    CHECK(orders["members"] == nlohmann::json::parse("[[1], [3], [5]]"));
    CHECK(orders["automaton"]["base"] == 2);
    const Run wrong = run("words thue-morse --say 'T[i] < 1'");
    CHECK(wrong.status == 2);
    CHECK(wrong.err ==
          "statement:1:6: error: expected '=' or '!=' between letters, found '<'\n  T[i] < 1\n     "
          "  ^\n");
    CHECK(run("words abaab --say '0 = 0'").err ==
          "algae: --say is for the infinite word of a system, and one finite word is given\n");
}

TEST_CASE("words proves complexities for all lengths") {
    const Run fibonacci = run("words fibonacci --to 3");
    CHECK(fibonacci.out.find(
              "factor complexity       1, 2, 3, 4\n  for all n             n + 1: proved\n"
              "palindromic complexity  1, 2, 1, 2\n"
              "  for all n             1, 2 for n = 0, 1, ... modulo 2: proved\n") !=
          std::string::npos);
    const auto shapiro = json_of("rudin-shapiro --to 2");
    CHECK(shapiro["factor_complexity"]["formula"] == "8n - 8");
    CHECK(shapiro["factor_complexity"]["from"] == 8);
    CHECK(shapiro["factor_complexity"]["proved_for_all"] == true);
    const auto thue = json_of("thue-morse --to 2");
    CHECK(thue["factor_complexity"]["proved_for_all"] == true);
    CHECK(thue["factor_complexity"]["differences"] == nlohmann::json::parse("[1, 2, 4]"));
    CHECK(json_of("'a -> abbb, b -> a' --to 2")["not_proved"].get<std::string>().find(
              "addition is not known") == 0);
    const auto powers = json_of("'a -> abac, b -> bb, c -> cbc' --to 2");
    CHECK(powers["critical_exponent"] == "infinite");
    CHECK(powers["not_proved"].get<std::string>().find("addition is not known") == 0);
    const auto late = json_of("'a -> abc, b -> ca, c -> b' --to 2")["not_proved"];
    CHECK(late.get<std::string>().find("critical exponent by return words: ") == 0);
    CHECK(late.get<std::string>().find("; the automata are large, --prove goes on with them: ") !=
          std::string::npos);
    CHECK(run("words 'a -> abbb, b -> a' --to 2 --prove").status == 2);
}

TEST_CASE(
    "words proves the factor complexity where no polynomial gives it, by chains of bispecial "
    "factors") {
    const auto found = json_of("thue-morse --to 6");
    const auto& chains = found["second_differences"]["chains"];
    CHECK(chains.size() == 4);
    CHECK(chains[0]["value"] == 2);
    CHECK(chains[0]["recurrence"] == std::vector<int>{4});
    CHECK(found["second_differences"]["letters"] == 2);
    CHECK(found["factor_complexity"]["proved_for_all"] == true);
}

TEST_CASE("words: critical exponents where automata are large or addition is not regular") {
    const auto exponent = [](const std::string& system) {
        return json_of(system + " --to 2")["critical_exponent"];
    };
    CHECK(exponent("'axiom a; a -> aabaa; b -> baab'")["exact"] == "3+sqrt(3)");
    const auto attained = exponent("'axiom a; a -> abba; b -> bab'");
    CHECK(attained["exact"] == "4");
    CHECK(attained["length"] == 20);
    CHECK(attained["period"] == 5);
}

TEST_CASE("words as LaTeX") {
    const auto has = [](const Run& made, const std::string& text) {
        CAPTURE(made.out);
        CHECK(made.status == 0);
        CHECK(made.out.find(text) != std::string::npos);
    };
    const Run word = run("words abaab --latex");
    has(word, "\\begin{tabular}{ll}\n  word & $a\\allowbreak b");
    has(word, "  exponent & $\\frac{5}{3}$ \\\\\n");
    has(run("words aab --latex"), "  borders & --- \\\\\n");
    const Run fibonacci = run("words fibonacci --to 2 --latex");
    has(fibonacci, "  2 & 3 & 1 & 2 & 1 \\\\\n\\end{array}");
    has(fibonacci, "\\[ p(n) = n + 1 \\quad (n \\ge 0) \\]");
    has(fibonacci,
        "The critical exponent is $\\frac{5 + \\sqrt{5}}{2} = 3.618034\\dots$, which no factor "
        "reaches.\n");
    has(run("words flipped-tribonacci --to 2 --latex"),
        "Here $r$ is $\\max\\{r \\in \\mathbb{R} : r^{3} - r^{2} - r - 1 = 0\\} = 1.839287\\dots$");
    const Run said = run("words fibonacci --say 'for some i: T[i] = a' --latex");
    CHECK(said.status == 2);
    CHECK(said.err.find("--latex is for values, and --say") != std::string::npos);
    CHECK(run("words abaab --latex --json").status == 2);
}

TEST_CASE("words keeps what it found at the end of the time") {
    const Run late = run("words tribonacci --to 100000 --timeout 8 --json");
    CHECK(late.status == 3);
    const auto found = nlohmann::json::parse(late.out);
    CHECK(found["to"] < 100'000);
    CHECK(found["factor_complexity"]["values"][8] == 17);
}

TEST_CASE("words gives automata and counts to other programs, and says what these are for") {
    const std::string squares = "words thue-morse --say 'n >= 1 and for some i: equal(i, i+n, n)'";
    CHECK(run(squares + " --as walnut").out.starts_with("msd_2\n\n0 0\n"));
    CHECK(run(squares + " --as gv").out.starts_with("digraph {"));
    CHECK(run(squares + " --as sage").out.starts_with("Automaton([(0, 0, 0), "));
    CHECK(run(squares).out.find("as digits               0*1(") != std::string::npos);
    const std::string count = "words thue-morse --say 'T[i] = 1 and i < n' --count n";
    CHECK(run(count).out.find("number for each n       0, 0, 1, 2, 2, 3, 3, 3, 4, 5, 5, 5, ...") !=
          std::string::npos);
    CHECK(run(count + " --as sage").out.starts_with("begin = vector(ZZ, ["));
    const auto json = nlohmann::json::parse(run(count + " --json").out);
    CHECK(json["count"]["of"] == "n");
    CHECK(json["count"]["values"][11] == 5);
    const Scratch files;
    const std::string folder = files.file("walnut");
    const Run written = run("words narayana --walnut " + folder);
    CHECK(written.status == 0);
    CHECK(written.out == folder + "/Custom Bases/msd_dtnarayana.txt\n" + folder +
                             "/Custom Bases/msd_dtnarayana_addition.txt\n" + folder +
                             "/Word Automata Library/Narayana.txt\n");
    // The word comes back as a system where Walnut has its number system.
    REQUIRE(run("words thue-morse --walnut " + folder).status == 0);
    CHECK(json_of("'" + folder +
                  "/Word Automata Library/Thuemorse.txt' --to 5")["factor_complexity"]["values"] ==
          std::vector<int>{1, 2, 4, 6, 10, 12});
    const auto refused = [](const std::string& arguments, const std::string& message) {
        const Run found = run("words " + arguments);
        INFO(found.err);
        CHECK(found.status == 2);
        CHECK(found.err.find(message) != std::string::npos);
    };
    refused("fibonacci --as walnut", "--as is for the numbers that make a statement true");
    refused("fibonacci --count n", "--count is for the numbers that make a statement true");
    refused("fibonacci --say 'i < n' --count k",
            "--count: expected a number that no quantifier binds, one of i, n, found 'k'");
    refused("fibonacci --say 'n < 3' --count n", "of which one is counted, found 1");
    refused("fibonacci --say 'i > n' --count n", "infinitely many");
    refused("fibonacci --say 'for some n: n = n' --as gv", "has no automaton");
    refused("fibonacci --say 'n < 3' --as gv --json", "give one of them");
    refused("fibonacci --say 'n < 3' --walnut " + folder, "prints the automaton of a statement");
    refused("abaab --as gv", "and one finite word is given");
    refused("fibonacci --say 'n < 3' --as hoa", "--as");
}
