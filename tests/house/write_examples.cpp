// write_examples OUTPUT ROOT HEADER...: writes a test source that runs the examples in the headers'
// documentation, one test case each. An example is a C++ expression that must be true,
//
//     /// Example: spell(alphabet, word) == "ABA"
//
// and may go on over lines indented deeper than the word Example. Names that examples use freely
// (parsed("..."), ...) are in tests/house/example_names.hpp.

#include <fstream>
#include <iostream>
#include <regex>
#include <string>
#include <vector>

namespace {

struct Example {
    std::string header;  // relative to the root
    std::size_t line = 0;
    std::string expression;
};

std::vector<Example> examples_of(const std::string& root, const std::string& header) {
    static const std::regex first(R"(^\s*/// Example: (.*)$)");
    static const std::regex more(R"(^\s*///     +(.*)$)");
    std::vector<Example> found;
    std::ifstream in(root + '/' + header);
    std::smatch part;
    bool open = false;
    std::string line;
    for (std::size_t number = 1; std::getline(in, line); ++number) {
        if (std::regex_match(line, part, first)) {
            found.push_back({header, number, part[1]});
            open = true;
        } else if (open && std::regex_match(line, part, more)) {
            found.back().expression += '\n' + std::string(part[1]);
        } else {
            open = false;
        }
    }
    return found;
}

}  // namespace

int main(int count, char** arguments) {
    if (count < 3) {
        std::cerr << "usage: write_examples OUTPUT ROOT HEADER...\n";
        return 2;
    }
    const std::string root = arguments[2];
    std::vector<Example> examples;
    std::string includes;
    for (int i = 3; i < count; ++i) {
        const auto found = examples_of(root, arguments[i]);
        if (found.empty()) continue;
        includes += "#include \"" + std::string(arguments[i]).substr(4) + "\"\n";  // after "src/"
        examples.insert(examples.end(), found.begin(), found.end());
    }
    std::ofstream out(arguments[1]);
    out << "// Written by write_examples from the headers under src.\n"
        << includes << "#include \"house/example_names.hpp\"\n#include <doctest/doctest.h>\n\n"
        << "namespace algae::examples {\n";
    for (const auto& [header, line, expression] : examples)
        out << "\nTEST_CASE(\"" << header << ':' << line << "\") {\n"
            << "#line " << line << " \"" << root << '/' << header << "\"\n    CHECK((" << expression
            << "));\n}\n";
    out << "\n}  // namespace algae::examples\n";
    return out.flush() ? 0 : 1;
}
