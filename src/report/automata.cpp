// Automata of first-order statements for other programs: files of Walnut, graphs for Graphviz, lines of Sage; and sets of numbers as regular
// expressions, numbers of numbers as matrices.
//
// Walnut knows a number system by the automata of its representations and of its addition. In base k, and in the systems of Fibonacci and of Tribonacci,
// the numeration of Dumont and Thomas of the morphism is what Walnut has of its own, so the names are its own; other words come with their number
// system (`walnut_files`), which is called after them and after Dumont and Thomas.
//
// A regular expression is found by leaving out one state after the other, those first that make the fewest new arrows (Brzozowski and McCluskey 1963).

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include "report/report.hpp"
#include "watch/watch.hpp"

namespace algae {

namespace {

using Edge = AutomaticRelation::Edge;

std::vector<std::uint32_t> digits_of(const AutomaticRelation& relation, std::uint32_t base,
                                     std::uint32_t column) {
    std::vector<std::uint32_t> found;
    for (std::size_t v = 0; v < relation.variables.size(); ++v, column /= base)
        found.push_back(column % base);
    return found;
}

std::string digit_text(std::uint32_t digit) { return std::to_string(digit); }

template <class Use>
void for_edges(const AutomaticRelation& relation, Use use) {
    for (std::size_t s = 0; s < relation.states(); ++s)
        for (std::uint32_t e = relation.first[s]; e < relation.first[s + 1]; ++e)
            use(s, relation.edges[e]);
}

/// The images of the word, if it is in a number system that Walnut has; then what that is called.
std::optional<std::string> own_number_system(const Numeration& numeration) {
    const std::size_t letters = numeration.letters().size();
    std::vector<std::vector<std::uint32_t>> images;
    for (std::uint32_t state = 0; state < letters; ++state)
        images.push_back(numeration.image(state));
    if (std::ranges::all_of(images,
                            [&](const auto& image) { return image.size() == numeration.base(); }))
        return "msd_" + std::to_string(numeration.base());
    using Images = std::vector<std::vector<std::uint32_t>>;
    if (images == Images{{0, 1}, {0}}) return "msd_fib";
    if (images == Images{{0, 1}, {0, 2}, {0}}) return "msd_trib";
    return std::nullopt;
}

/// Letters and digits of a name, in lower case.
std::string plain_name(const std::string& name) {
    std::string found;
    for (const char c : name)
        if (std::isalnum(static_cast<unsigned char>(c)))
            found += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return found.empty() || std::isdigit(static_cast<unsigned char>(found[0])) ? "w" + found
                                                                               : found;
}

std::string number_system(const Numeration& numeration, const std::string& name) {
    return own_number_system(numeration).value_or("msd_dt" + plain_name(name));
}

/// `head` for each variable, then the states with their arrows.
std::string walnut_text(const AutomaticRelation& relation, std::uint32_t base,
                        const std::string& head) {
    std::string text;
    for (std::size_t v = 0; v < relation.variables.size(); ++v) text += (v == 0 ? "" : " ") + head;
    text += '\n';
    for (std::size_t s = 0; s < relation.states(); ++s) {
        text += fmt::format("\n{} {}\n", s, relation.accepting[s] != 0 ? 1 : 0);
        for (std::uint32_t e = relation.first[s]; e < relation.first[s + 1]; ++e) {
            const Edge& edge = relation.edges[e];
            text += fmt::format("{} -> {}\n",
                                joined(digits_of(relation, base, edge.column), " ", digit_text),
                                edge.target);
        }
    }
    return text;
}

std::string graph_text(const AutomaticRelation& relation, std::uint32_t base) {
    std::string text =
        "digraph {\n  rankdir = LR;\n  node [shape = circle];\n"
        "  begin [shape = point];\n";
    for (std::size_t s = 0; s < relation.states(); ++s)
        if (relation.accepting[s] != 0) text += fmt::format("  {} [shape = doublecircle];\n", s);
    text += fmt::format("  begin -> 0 [label = \"{}\"];\n", joined(relation.variables, ", "));
    std::map<std::pair<std::size_t, std::uint32_t>, std::string> labels;
    for_edges(relation, [&](std::size_t s, const Edge& edge) {
        std::string& label = labels[{s, edge.target}];
        label += (label.empty() ? "" : "\\n") +
                 joined(digits_of(relation, base, edge.column), ",", digit_text);
    });
    for (const auto& [ends, label] : labels)
        text += fmt::format("  {} -> {} [label = \"{}\"];\n", ends.first, ends.second, label);
    return text + "}\n";
}

std::string sage_text(const AutomaticRelation& relation, std::uint32_t base) {
    std::vector<std::string> edges, accepting;
    for_edges(relation, [&](std::size_t s, const Edge& edge) {
        const std::string digits = joined(digits_of(relation, base, edge.column), ", ", digit_text);
        edges.push_back(fmt::format("({}, {}, ", s, edge.target) +
                        (relation.variables.size() == 1 ? digits : "[(" + digits + ")]") + ")");
    });
    for (std::size_t s = 0; s < relation.states(); ++s)
        if (relation.accepting[s] != 0) accepting.push_back(std::to_string(s));
    return fmt::format("Automaton([{}], initial_states=[0], final_states=[{}])\n",
                       joined(edges, ", "), joined(accepting, ", "));
}

/// A regular expression with what binds it.
struct Regular {
    enum class Binding { sum, product, atom } binding = Binding::atom;
    std::string text;

    std::string within(Binding around) const { return binding < around ? "(" + text + ")" : text; }
};

Regular either(const Regular& left, const Regular& right) {
    if (left.text == right.text) return left;
    return {Regular::Binding::sum, left.text + "|" + right.text};
}

constexpr const char* empty_word = "ε";

Regular behind(const Regular& left, const Regular& right) {
    if (left.text == empty_word) return right;
    if (right.text == empty_word) return left;
    using enum Regular::Binding;
    return {product, left.within(product) + right.within(product)};
}

Regular rounds(const Regular& inner) {
    if (inner.text == empty_word) return inner;
    return {Regular::Binding::atom, inner.within(Regular::Binding::atom) + "*"};
}

}  // namespace

std::string automaton_text(const FirstOrderReport& report, AutomatonFormat format) {
    const AutomaticRelation& relation = report.answer.relation;
    if (report.free.empty())
        throw Error(
            "a statement whose numbers are all bound has no automaton; leave the quantifier of one "
            "away: 'for some i: ...' with n free is the set of such n");
    const std::uint32_t base = report.word.numeration.base();
    switch (format) {
        case AutomatonFormat::walnut:
            return walnut_text(relation, base,
                               number_system(report.word.numeration, report.system));
        case AutomatonFormat::graphviz:
            return graph_text(relation, base);
        case AutomatonFormat::sage:
            return sage_text(relation, base);
    }
    return "";
}

std::optional<std::string> regular_expression(const AutomaticRelation& relation,
                                              const Numeration& numeration) {
    constexpr std::size_t most_states = 40, longest = 2'000;
    if (relation.variables.size() != 1 || relation.states() > most_states) return std::nullopt;
    if (relation.empty()) return "∅";
    // A state before the first one and one behind the accepting ones, and the expression between two states.
    const std::size_t begin = relation.states(), end = begin + 1;
    std::map<std::pair<std::size_t, std::size_t>, Regular> arrows;
    const auto add = [&](std::size_t from, std::size_t to, Regular expression) {
        const auto [at, is_new] = arrows.try_emplace({from, to}, expression);
        if (!is_new) at->second = either(at->second, expression);
    };
    add(begin, 0, {Regular::Binding::atom, empty_word});
    for (std::size_t s = 0; s < relation.states(); ++s)
        if (relation.accepting[s] != 0) add(s, end, {Regular::Binding::atom, empty_word});
    const bool is_short = numeration.base() <= 10;
    for_edges(relation, [&](std::size_t s, const Edge& edge) {
        const std::string digit = std::to_string(edge.column);
        add(s, edge.target, {Regular::Binding::atom, is_short ? digit : "[" + digit + "]"});
    });
    std::set<std::size_t> open;
    for (std::size_t s = 0; s < relation.states(); ++s) open.insert(s);
    while (!open.empty()) {
        const auto cost = [&](std::size_t s) {
            std::size_t in = 0, out = 0;
            for (const auto& [ends, expression] : arrows) {
                if (ends.first == ends.second) continue;
                in += ends.second == s ? expression.text.size() : 0;
                out += ends.first == s ? expression.text.size() : 0;
            }
            return in * out;
        };
        const std::size_t state =
            *std::ranges::min_element(open, {}, [&](std::size_t s) { return cost(s); });
        open.erase(state);
        Regular loop{Regular::Binding::atom, empty_word};
        if (const auto at = arrows.find({state, state}); at != arrows.end())
            loop = rounds(at->second);
        std::vector<std::pair<std::size_t, Regular>> in, out;
        for (const auto& [ends, expression] : arrows) {
            if (ends.first == ends.second) continue;
            if (ends.second == state) in.emplace_back(ends.first, expression);
            if (ends.first == state) out.emplace_back(ends.second, expression);
        }
        std::erase_if(arrows, [&](const auto& arrow) {
            return arrow.first.first == state || arrow.first.second == state;
        });
        for (const auto& [from, before] : in)
            for (const auto& [to, after] : out) {
                Regular whole = behind(behind(before, loop), after);
                if (whole.text.size() > longest) return std::nullopt;
                add(from, to, std::move(whole));
            }
    }
    return arrows.at({begin, end}).text;
}

std::vector<std::pair<std::string, std::string>> walnut_files(const AutomaticWord& word,
                                                              const std::string& system,
                                                              const Budget& budget) {
    const Numeration& numeration = word.numeration;
    const std::string name = number_system(numeration, system);
    std::vector<std::pair<std::string, std::string>> files;
    if (!own_number_system(numeration)) {
        std::vector<std::string> digits;
        for (std::uint32_t d = 0; d < numeration.base(); ++d) digits.push_back(std::to_string(d));
        const std::string head = "{" + joined(digits, ", ") + "}";
        for (const auto& [file, statement] : {std::pair<std::string, std::string>{name, "n = n"},
                                              {name + "_addition", "x + y = z"}})
            files.emplace_back(
                "Custom Bases/" + file + ".txt",
                walnut_text(
                    decide_first_order(read_first_order(statement, "statement", "T", word.letters),
                                       word, budget)
                        .relation,
                    numeration.base(), head));
    }
    // Letters are whole numbers there: their own, or their places in the order of names.
    const std::set<std::string> letters(word.letters.begin(), word.letters.end());
    const bool are_numbers = std::ranges::all_of(letters, [](const std::string& letter) {
        return letter.size() < 10 &&
               std::ranges::all_of(letter, [](unsigned char c) { return std::isdigit(c); });
    });
    std::string text = name + "\n";
    for (std::uint32_t state = 0; state < word.letters.size(); ++state) {
        const std::string& letter = word.letters[state];
        text += fmt::format(
            "\n{} {}\n", state,
            are_numbers ? letter
                        : std::to_string(std::distance(letters.begin(), letters.find(letter))));
        const std::vector<std::uint32_t>& image = numeration.image(state);
        for (std::size_t digit = 0; digit < image.size(); ++digit)
            text += fmt::format("{} -> {}\n", digit, image[digit]);
    }
    std::string called = plain_name(system);
    called[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(called[0])));
    if (called.size() < 2 || std::string("AEI").find(called[0]) != std::string::npos)
        called = "W" + called;  // Walnut has words of one letter, and quantifiers
    files.emplace_back("Word Automata Library/" + called + ".txt", std::move(text));
    return files;
}

std::string matrices_text(const LinearRepresentation& count) {
    const auto list = [](const std::vector<Integer>& numbers) {
        return "[" + joined(numbers, ", ", [](const Integer& one) { return to_string(one); }) + "]";
    };
    std::string text = "begin = vector(ZZ, " + list(count.begin) + ")\n" + "end = vector(ZZ, " +
                       list(count.end) + ")\ndigits = [\n";
    for (const auto& matrix : count.matrices)
        text += fmt::format("    matrix(ZZ, {}, [{}]),\n", count.size(),
                            joined(matrix, ", ", [&](const auto& row) { return list(row); }));
    return text + "]\n";
}

}  // namespace algae
