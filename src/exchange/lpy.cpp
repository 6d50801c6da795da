#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "exchange/detail/cpfg.hpp"
#include "exchange/detail/formats.hpp"
#include "exchange/detail/scanner.hpp"
#include "model/model.hpp"

// The declarative part of a file of L-Py.
//
//     s = 2                        # a constant
//     Axiom: A(1)
//     derivation length: 3
//     production:
//     A(x) --> F(x)+A(x*s)
//     B(x) :
//         if x > 1: produce A(x)
//         else: produce
//     endlsystem
//
// All else is Python, and refused with its line.

namespace algae {

namespace {

class LpyFile : CpfgReader {
public:
    LpyFile(const Source& source, const CpfgDialect& dialect) : CpfgReader(source, dialect) {}

    CpfgSystem read(const Placed& whole) {
        system_.generation = "1";
        enum { header, rules, decomposition, homomorphism, after } state = header;
        const std::vector<Placed> lines = statements(whole);
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const Placed said = lines[i].trimmed();
            if (said.text.empty() || state == after) continue;
            const std::size_t place = said.at.front();
            if (said.text == "endlsystem") {
                state = after;
                continue;
            }
            if (behind(said, {"production:"})) {
                state = rules;
                continue;
            }
            if (behind(said, {"homomorphism:", "interpretation:"})) {
                state = homomorphism;
                continue;
            }
            if (behind(said, {"decomposition:"})) {
                state = decomposition;
                continue;
            }
            for (const char* word : {"group", "endgroup"})
                if (said.text.starts_with(word))
                    refuse(place, "groups", "have no meaning in the notation");
            if (const auto depth = behind(said, {"maximum depth:"})) {
                (state == decomposition ? system_.depth : system_.drawn_depth) =
                    number(*depth, "a depth");
                continue;
            }
            if (const auto value = behind(said, {"Axiom:", "axiom:"})) {
                system_.axiom = *value;
                continue;
            }
            if (state == header && read_header(said)) continue;
            if (const auto names = behind(said, {"module "})) {
                std::string name;
                for (const char c : names->text + ",") {
                    if (is_name_part(c))
                        name += c;
                    else if (c == '(')
                        break;
                    else if (!name.empty()) {
                        declare(name, names->place(0));
                        name.clear();
                    }
                }
                continue;
            }
            std::vector<CpfgRule>& all = state == homomorphism    ? system_.interpretation
                                         : state == decomposition ? system_.decomposition
                                                                  : system_.rules;
            if (said.text.find("-->") != std::string::npos) {
                all.push_back(rule(said));
                continue;
            }
            if (const std::size_t colon = outside(said.text, ':');
                state != header && colon != std::string::npos) {
                const CpfgRule found = head_of(said.part(0, colon));
                i = python_block(lines, i, colon, found, {}, all);
                continue;
            }
            const std::size_t equals = said.text.find('=');
            const std::string name = said.part(0, equals).trimmed().text;
            if (state == header && equals != std::string::npos && !name.empty() &&
                is_name_start(name[0]) && std::ranges::all_of(name, is_name_part)) {
                system_.constants.emplace_back(name,
                                               said.part(equals + 1, said.text.size()).trimmed());
                continue;
            }
            refuse(place, "a line of Python",
                   "is not read: expected `NAME = number` or a rule with -->; found '" +
                       said.text.substr(0, 40) + "'");
        }
        return std::move(system_);
    }

private:
    static std::size_t indent_of(const Placed& line) {
        std::size_t columns = 0;
        for (const char c : line.text) {
            if (c == '\t')
                columns = columns / 8 * 8 + 8;
            else if (c == ' ')
                ++columns;
            else
                break;
        }
        return columns;
    }

    /// Reads what stands behind the colon at `colon` of the trimmed line `i`: statements on the line itself, or on lines that are indented
    /// deeper. Gives the last line that it read.
    std::size_t python_block(const std::vector<Placed>& lines, std::size_t i, std::size_t colon,
                             const CpfgRule& head, const std::vector<Placed>& path,
                             std::vector<CpfgRule>& all) {
        const Placed said = lines[i].trimmed();
        const Placed rest = said.part(colon + 1, said.text.size()).trimmed();
        if (!rest.text.empty()) {
            python_statement(rest, head, path, all);
            return i;
        }
        const std::size_t outer = indent_of(lines[i]);
        std::size_t last = i, inner = 0;
        std::vector<Placed> failed;  // the conditions of `if` and `elif` that came before an `else`
        bool chained = false, some = false;
        for (std::size_t k = i + 1; k < lines.size(); ++k) {
            const Placed line = lines[k].trimmed();
            if (line.text.empty()) continue;
            const std::size_t depth = indent_of(lines[k]), place = line.at.front();
            if (depth <= outer) break;
            if (!some) inner = depth;
            some = true;
            if (depth != inner)
                fail(place, "expected the indentation of the lines of this block, " +
                                std::to_string(inner) + " columns, found " + std::to_string(depth));
            last = k;
            const auto word = [&](std::string_view wanted) {
                return line.text.starts_with(wanted) && (line.text.size() == wanted.size() ||
                                                         !is_name_part(line.text[wanted.size()]));
            };
            const bool is_if = word("if"), is_elif = word("elif"), is_else = word("else");
            if (!is_if && !is_elif && !is_else) {
                chained = false;
                python_statement(line, head, path, all);
                continue;
            }
            if (!is_if && !chained)
                fail(place, std::string(is_elif ? "elif" : "else") + " without if");
            const std::size_t end = outside(line.text, ':');
            if (end == std::string::npos)
                fail(place,
                     "expected ':' behind the condition of '" + line.text.substr(0, 40) + "'");
            if (is_if) failed.clear();
            chained = !is_else;
            std::vector<Placed> inside = path;
            inside.insert(inside.end(), failed.begin(), failed.end());
            if (!is_else) {
                const Placed condition = line.part(is_if ? 2 : 4, end).trimmed();
                if (condition.text.empty())
                    fail(place, "expected a condition behind '" + line.text.substr(0, end) + "'");
                inside.push_back(side(condition, true));
                failed.push_back(side(condition, false));
            }
            k = last = python_block(lines, k, end, head, inside, all);
        }
        if (!some) fail(said.place(colon), "expected a block with produce behind ':', found none");
        return last;
    }

    void python_statement(const Placed& said, const CpfgRule& head, const std::vector<Placed>& path,
                          std::vector<CpfgRule>& all) const {
        const std::size_t place = said.at.front();
        if (said.text == "pass") return;
        if (said.text == "produce" || said.text.starts_with("produce ")) {
            add_produced(all, head, path, said.part(7, said.text.size()), place);
            return;
        }
        if (said.text.starts_with("nproduce"))
            refuse(place, "nproduce",
                   "goes on behind what it makes, which is not read: expected produce");
        refuse(place, "a line of Python",
               "is not read: expected produce, if, elif or else; found '" +
                   said.text.substr(0, 40) + "'");
    }
};

}  // namespace

Model read_lpy(std::string_view text, const std::string& name) {
    const std::string kept(text);
    const Source source(kept, name);
    const CpfgDialect dialect{true, "lpy", 60};
    return cpfg_model(source, dialect,
                      LpyFile(source, dialect).read(preprocessed(source, dialect)));
}

}  // namespace algae
