#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <string>

#include "exact/exact.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "notation/random_text.hpp"

using namespace algae;

namespace {

std::string repeated(const std::string& part, int times) {
    std::string out;
    for (int i = 0; i < times; ++i) out += part;
    return out;
}

/// The first message about a text, or "".
std::string message(const std::string& text) {
    try {
        read_lsystem(text, "x.lsys");
        return {};
    } catch (const Diagnostics& error) {
        return error.findings().front().message;
    }
}

/// Reads and formats whatever it is; anything but a value or an error of the library is a failure.
void survive(const std::string& text) {
    try {
        format_lsystem(text, "x.lsys");
    } catch (const Diagnostics& error) {
        for (const Diagnostic& finding : error.findings()) RC_ASSERT(!finding.text().empty());
    }
    Alphabet alphabet;
    try {
        read_word(text, alphabet);
    } catch (const Diagnostics&) {
    }
    try {
        read_expression(text);
    } catch (const Diagnostics&) {
    }
}

}  // namespace

TEST_CASE("nesting as deep as anybody wants ends in an error, not in the stack") {
    constexpr int many = 200000;
    CHECK(message("axiom a(" + repeated("(", many)) == "more than 200 brackets inside each other");
    CHECK(message("axiom a(" + repeated("sin(", many)) ==
          "more than 200 brackets inside each other");
    const std::string deep = "an expression with more than 500 operators inside each other";
    CHECK(message("axiom a(" + repeated("-", many) + "1)") == deep);
    CHECK(message("axiom a(" + repeated("1+", many) + "1)") == deep);
    CHECK(message("axiom a(" + repeated("2^", many) + "1)") == deep);
    CHECK(message("axiom a(" + repeated("-", 500) + "1)") == "");
    CHECK(message("axiom a(" + repeated("(", 199) + '1' + repeated(")", 199) + ')') == "");
    CHECK(message("axiom " + repeated("[", many)) == "'[' is never closed");
    CHECK(message("axiom " + repeated("[", many) + repeated("]", many)) == "");
    CHECK(message("axiom a\na -" + repeated("(", many) + "1" + repeated(")", many) + "-> b") ==
          "more than 200 brackets inside each other");
}

TEST_CASE("numbers of any length and size") {
    CHECK(message("axiom a(" + repeated("9", 1000) + ")") == "");
    CHECK(message("axiom a(" + repeated("9", 1001) + ")") ==
          "a number of more than 1000 characters");
    CHECK(message("axiom a(1e99999)") == "the number '1e99999' is out of range");
    CHECK(message("axiom a\nangle 1e999") ==
          "the value of '" + ("1e999" + std::string()) + "' is too large");
    // Squaring again and again would fill the memory if it stayed exact.
    std::string text = "axiom a\nlet x0 = 1+1e-15\n";
    for (int i = 1; i < 40; ++i) {
        const std::string before = 'x' + std::to_string(i - 1);
        text += "let x" + std::to_string(i) + " = " + before + '*' + before + '\n';
    }
    CHECK(message(text) == "");
}

TEST_CASE("long texts") {
    constexpr int letters = 1000000;
    const Model system = read_lsystem("axiom " + repeated("F+", letters / 2), "x.lsys");
    CHECK(system.axiom.letters.size() == letters);
    std::string rules = "axiom X_1\n";
    for (int i = 0; i < 20000; ++i) {
        const std::string name = "X_" + std::to_string(i);
        rules += name + " -> " + name + "[+F]X_" + std::to_string(i + 1) + '\n';
    }
    CHECK(read_lsystem(rules, "x.lsys").rules.size() == 20000);
    CHECK(read_lsystem("axiom a;" + repeated("b->a;", 20000), "x.lsys").rules.size() == 20000);
    CHECK(message(repeated("x", letters)) ==
          "expected a setting or a rule with '->', found '" + repeated("x", 40) + "...'");
    CHECK(message("axiom a\na(" + repeated("x,", 2000) + "x) -> b") == "more than 1000 parameters");
}

TEST_CASE("random bytes") {
    CHECK(rc::check([](const std::string& text) { survive(text); }));
    CHECK(rc::check([] {
        static const std::string alphabet =
            "axiomFlet->()<>:,;?#=[]{}|&^*/.'\"0123 \n\t_\xCE\xB5\xE2\x86\x92\xFF";
        const auto text = *rc::gen::container<std::string>(rc::gen::elementOf(alphabet));
        survive(text);
    }));
}

TEST_CASE("valid texts with something changed") {
    CHECK(rc::check([] {
        std::string text = random_text::system();
        static const std::string alphabet = "aF->()<>:,;?#=[]{}|&^*/.0 \n_\xCE\xB5\xFF";
        const int changes = 1 + random_text::below(4);
        for (int i = 0; i < changes && !text.empty(); ++i) {
            const auto at =
                static_cast<std::size_t>(random_text::below(static_cast<int>(text.size())));
            const char byte = *rc::gen::elementOf(alphabet);
            const int kind = random_text::below(3);
            if (kind == 0) text.erase(at, 1);
            if (kind == 1) text.insert(at, 1, byte);
            if (kind == 2) text[at] = byte;
        }
        survive(text);
        try {
            const Model system = read_lsystem(text, "x.lsys");
            const std::string printed = print_lsystem(system);
            RC_ASSERT(read_lsystem(printed, "x.lsys") == system);
        } catch (const Diagnostics&) {
        }
    }));
}
