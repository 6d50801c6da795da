#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <string>
#include <utility>
#include <vector>

#include "exact/exact.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "notation/random_text.hpp"
#include "notation/said.hpp"

using namespace algae;
using random_text::below;
using random_text::chance;

TEST_CASE("a function of one's own stands for what it says") {
    const auto same = [](const std::string& with, const std::string& without) {
        const Model read = read_lsystem(with, "x.lsys");
        CHECK(read == read_lsystem(without, "x.lsys"));
        // What is printed has no functions, and means the same.
        CHECK(read_lsystem(print_lsystem(read), "x.lsys") == read);
    };
    same("let f(x) = x^2 + 1\naxiom A(f(3))\nA(x) : f(x) > 5 -> F(f(x/2))A(f(f(x)))",
         "axiom A(3^2 + 1)\nA(x) : x^2 + 1 > 5 -> F((x/2)^2 + 1)A((x^2 + 1)^2 + 1)");
    same("let c = 4\nlet f(x,y) = c*x - y\nlet g(z) = f(z,f(1,z))\nangle g(20)\naxiom F",
         "let c = 4\nangle 4*20 - (4*1 - 20)\naxiom F");
    // A rule may call a parameter as a constant is called; the function means the constant.
    same("let c = 4\nlet f(x) = c*x\naxiom A(1,2)\nA(c,d) -> A(f(d),c)",
         "let c = 4\naxiom A(1,2)\nA(c,d) -> A(4*d,c)");
    same("let c = sqrt(2)\nlet f(c) = c+1\nlet g(x) = c*f(x)\naxiom A(1)\nA(c) -> A(g(c))",
         "let c = sqrt(2)\naxiom A(1)\nA(c) -> A(sqrt(2)*(c+1))");
    same("let half(x) = x/2\naxiom F\nF -(half(2/3))-> FF\nF -(1-half(2/3))-> F\nstep half(5)",
         "axiom F\nF -(1/3)-> FF\nF -(2/3)-> F\nstep 5/2");
    same(
        "let n(x) = x+1\nsystem leaf { axiom L(n(1)); L(x) -> L(n(x)) }\naxiom A(leaf(n(2)))\n"
        "A(w) -> F[<w>]A(leaf(n(length(w))))",
        "system leaf { axiom L(1+1); L(x) -> L(x+1) }\naxiom A(leaf(2+1))\n"
        "A(w) -> F[<w>]A(leaf(length(w)+1))");
}

TEST_CASE("constants from outside are heeded by functions") {
    const Model read = read_lsystem("let c = 4\nlet f(x) = c*x\naxiom F(f(2))", "x.lsys",
                                    {{"c", quantity(Rational(7))}});
    CHECK(read == read_lsystem("let c = 7\naxiom F(7*2)", "x.lsys"));
}

TEST_CASE("a formatted file keeps its functions and their calls") {
    const std::string text =
        "# growth\n"
        "let c = 4 # a constant\n"
        "# a square\n"
        "let f(x,y) = x^2+c*y # of two\n"
        "let d = f(1,2) # d\n"
        "let g(z) = f(z,f(z,1))\n"
        "axiom A(f(1,2))\n"
        "A(x) : g(x) < 20 -> F(g(x))A(f(x,d))\n"
        "angle g(3)\n";
    CHECK(format_lsystem(text, "x.lsys") == text);
    CHECK(print_lsystem(read_lsystem(text, "x.lsys")) ==
          "let c = 4\nlet d = 1^2+4*2\naxiom A(1^2+4*2)\n"
          "A(x) : x^2+4*(x^2+4*1) < 20 -> F(x^2+4*(x^2+4*1))A(x^2+4*d)\n"
          "angle 3^2+4*(3^2+4*1)\n");
}

TEST_CASE("what is wrong with a function is said at its place") {
    const auto message = [](const std::string& text) {
        std::string all = findings(text + "\naxiom F");
        return all.substr(0, all.find('\n'));
    };
    CHECK(message("let f(x) = x\nangle f(1,2)") ==
          "x.lsys:2:12: error: expected 1 argument of f, found 2");
    CHECK(message("let f(x,y) = x\nangle f(1)") ==
          "x.lsys:2:10: error: expected 2 arguments of f, found 1");
    CHECK(message("let half(x) = x/2\nangle haf(1)") ==
          "x.lsys:2:7: error: expected a function, found 'haf'; did you mean 'half'?");
    CHECK(message("let f(x) = f(x-1)") == "x.lsys:1:12: error: 'f' stands in its own definition");
    CHECK(message("let f(x) = y+1") ==
          "x.lsys:1:12: error: expected a parameter or a constant, found 'y'");
    CHECK(message("let f(x,x) = x") == "x.lsys:1:9: error: the parameter 'x' is given twice");
    CHECK(message("let f(x) = x\nlet f(y) = y") ==
          "x.lsys:2:5: error: the function 'f' is given twice");
    CHECK(message("let f(x) = x\nlet f = 2") ==
          "x.lsys:2:5: error: the function 'f' is given twice");
    CHECK(message("let f = 2\nlet f(x) = x") ==
          "x.lsys:2:5: error: expected another name, 'f' is a constant");
    CHECK(message("let sin(x) = x") ==
          "x.lsys:1:5: error: expected another name, 'sin' is a function already");
    CHECK(message("system leaf { axiom F }\nlet leaf(x) = x") ==
          "x.lsys:2:5: error: expected another name, 'leaf' is a system");
    CHECK(message("let f() = 2") == "x.lsys:1:7: error: expected a parameter's name, found ')'");
    CHECK(message("let f(x = 2") == "x.lsys:1:9: error: expected ',' or ')', found '='");
    CHECK(message("let f(x) 2") == "x.lsys:1:10: error: expected '=', found '2'");
    CHECK(message("let f(x) =") ==
          "x.lsys:1:11: error: expected a number or a name, found the end of the line");
    CHECK(message("let f(x) = 1/x\nangle f(0)").find("division by 0") != std::string::npos);
    // One finding for a wrong function, none for its calls.
    const std::string all = findings("let f(x) = x+\nangle f(2)\naxiom A(f(1))\nA(x) -> A(f(x))");
    CHECK(all.find("x.lsys:1:14") == 0);
    CHECK(all.find("found 'f'") == std::string::npos);
}

TEST_CASE("functions that stand for more than memory holds are refused") {
    std::string text = "let f_0(x) = x+x\n";
    for (int i = 1; i < 60; ++i)
        text += "let f_" + std::to_string(i) + "(x) = f_" + std::to_string(i - 1) + "(f_" +
                std::to_string(i - 1) + "(x))\n";
    CHECK(findings(text + "axiom F")
              .find("stands for more than 10,000 numbers, names and operators") !=
          std::string::npos);
    // Each call is small, and there are too many of them.
    std::string sum = "x";
    for (int i = 0; i < 400; ++i) sum += "+x";
    text = "let f(x) = " + sum + "\naxiom F\n";
    for (int i = 0; i < 3000; ++i) text += "A_" + std::to_string(i) + "(x) -> A_0(f(x))\n";
    CHECK(findings(text).find("stands for more than 1,000,000 numbers, names and operators") !=
          std::string::npos);
    text.clear();
    for (int i = 0; i <= 1000; ++i) text += "let g_" + std::to_string(i) + "(x) = x\n";
    CHECK(findings(text + "axiom F").find("x.lsys:1001:5: error: more than 1000 functions") == 0);
    // Constants whose values are not rational are put in with all that they are made of.
    text = "let c_0 = sqrt(2)\n";
    for (int i = 1; i < 60; ++i)
        text += "let c_" + std::to_string(i) + " = c_" + std::to_string(i - 1) + "+c_" +
                std::to_string(i - 1) + "\n";
    CHECK(findings(text + "let f(x) = x*c_59\naxiom F")
              .find("the constants of the function stand for more than 10,000 others") !=
          std::string::npos);
}

namespace {

/// An expression as it is said, and with the bodies of functions in brackets instead of calls: text for text, as a person would do it.
struct Said {
    std::string said, meant;
};

struct Defined {
    std::string name;
    std::vector<std::string> parameters;
    std::string meant;  // the body, with `<0>` for the first parameter
};

std::string filled(std::string body, const std::vector<Said>& arguments) {
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string hole = '<' + std::to_string(i) + '>';
        for (std::size_t at = body.find(hole); at != std::string::npos;
             at = body.find(hole, at + arguments[i].meant.size() + 2))
            body.replace(at, hole.size(), '(' + arguments[i].meant + ')');
    }
    return body;
}

/// `names`: what each name is said as, and means.
Said any_expression(const std::vector<Said>& names, const std::vector<Defined>& functions,
                    int depth) {
    const int kind = depth == 0 ? below(2) : below(6);
    if (kind == 0 || (kind == 1 && names.empty())) {
        const std::string number = std::to_string(1 + below(9));
        return {number, number};
    }
    if (kind == 1) return names[static_cast<std::size_t>(below(static_cast<int>(names.size())))];
    const auto part = [&] { return any_expression(names, functions, depth - 1); };
    if (kind == 2 || functions.empty()) {
        const Said left = part(), right = part();
        const std::string operation = random_text::one_of({"+", "-", "*", "/", "^", "<"});
        return {"(" + left.said + ")" + operation + "(" + right.said + ")",
                "(" + left.meant + ")" + operation + "(" + right.meant + ")"};
    }
    if (kind == 3) {
        const Said inside = part();
        return {"-sin(" + inside.said + ")", "-sin(" + inside.meant + ")"};
    }
    const Defined& function =
        functions[static_cast<std::size_t>(below(static_cast<int>(functions.size())))];
    std::vector<Said> arguments;
    std::string said = function.name + "(";
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
        arguments.push_back(part());
        said += (i == 0 ? "" : ", ") + arguments.back().said;
    }
    return {said + ")", "(" + filled(function.meant, arguments) + ")"};
}

}  // namespace

TEST_CASE("calls mean what a person puts in for them") {
    int compared = 0;
    CHECK(rc::check([&] {
        std::string said = "let c = 3\nlet d = sqrt(2)\n", meant = said;
        std::vector<Defined> functions;
        const std::vector<Said> constants{{"c", "3"}, {"d", "sqrt(2)"}};
        for (int i = 0; i < 1 + below(3); ++i) {
            Defined made{"f_" + std::to_string(i), {}, {}};
            // A parameter may have the name of a constant.
            made.parameters = chance(30) ? std::vector<std::string>{"c", "x"}
                                         : std::vector<std::string>{"x", "y"};
            made.parameters.resize(static_cast<std::size_t>(1 + below(2)));
            std::vector<Said> names{{made.parameters[0], "<0>"}};
            if (made.parameters.size() > 1) names.push_back({made.parameters[1], "<1>"});
            for (const Said& constant : constants)
                if (constant.said != made.parameters[0]) names.push_back(constant);
            // No call in a body keeps its holes apart from those of what is put in.
            const Said body = any_expression(names, {}, 2);
            made.meant = body.meant;
            said += "let " + made.name + "(" + made.parameters[0] +
                    (made.parameters.size() > 1 ? "," + made.parameters[1] : "") +
                    ") = " + body.said + "\n";
            functions.push_back(made);
        }
        const std::vector<Said> parameters{{"c", "c"}, {"z", "z"}};
        const std::string axiom = "axiom A(1,2)\n";
        said += axiom;
        meant += axiom;
        for (int i = 0; i < 3; ++i) {
            const Said condition = any_expression(parameters, functions, 2),
                       argument = any_expression(parameters, functions, 3);
            const std::string left = "A(c,z) : 0 < ", letter = "A(";
            said += left + "(" + condition.said + ") -> A(" + argument.said + ",z)\n";
            meant += left + "(" + condition.meant + ") -> A(" + argument.meant + ",z)\n";
        }
        const Model read = read_lsystem(said, "x.lsys");
        RC_ASSERT(read == read_lsystem(meant, "x.lsys"));
        // A formatted file means the same, and is itself when it is formatted again.
        const std::string formatted = format_lsystem(said, "x.lsys");
        RC_ASSERT(read_lsystem(formatted, "x.lsys") == read);
        RC_ASSERT(format_lsystem(formatted, "x.lsys") == formatted);
        ++compared;
    }));
    CHECK(compared >= 100);
}
