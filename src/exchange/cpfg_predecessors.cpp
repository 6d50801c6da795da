#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "exchange/detail/cpfg.hpp"
#include "exchange/detail/scanner.hpp"

// Rules of cpfg that the notation has no form of: those for several modules at once, and those for a part of a command.
//
// `AB --> C` rewrites both modules; in the notation each module has rules of its own, so A before B becomes C and B behind A nothing. A command such as
// `~F` is two modules there and one symbol here, so a rule for F is one for the command too.

namespace algae {

namespace {

class Predecessors : CpfgReader {
public:
    Predecessors(const Source& source, const CpfgDialect& dialect, CpfgSystem system)
        : CpfgReader(source, dialect, std::move(system)) {}

    CpfgSystem single() {
        split_predecessors();
        if (!dialect_.python && !dialect_.plus) add_command_rules();
        return std::move(system_);
    }

private:
    /// Whether the end of one predecessor is the beginning of another, less than all of both.
    static bool overlaps(const std::vector<CpfgModule>& one, const std::vector<CpfgModule>& other) {
        for (std::size_t size = 1; size < std::max(one.size(), other.size()); ++size) {
            if (size > one.size() || size > other.size()) break;
            if (size == one.size() && size == other.size()) break;
            bool same = true;
            for (std::size_t i = 0; i < size && same; ++i)
                same = one[one.size() - size + i].kind() == other[i].kind();
            if (same) return true;
        }
        return false;
    }
    static bool holds_part(const std::vector<CpfgModule>& word,
                           const std::vector<CpfgModule>& part) {
        for (std::size_t at = 0; at + part.size() <= word.size(); ++at) {
            bool same = part.size() < word.size();
            for (std::size_t i = 0; i < part.size() && same; ++i)
                same = word[at + i].kind() == part[i].kind();
            if (same) return true;
        }
        return false;
    }

    /// `AB --> C` as rules for its modules: A before B becomes C, B behind A nothing. That is the same where no two places of such
    /// predecessors can share a module, contexts skip nothing and no earlier rule takes one of the modules.
    void split_predecessors() {
        const auto first = std::ranges::find_if(
            system_.rules, [](const CpfgRule& rule) { return !rule.several.empty(); });
        if (first == system_.rules.end()) return;
        const char* const why =
            "is one rule for all of them, which has a meaning in the notation only ";
        const auto fail_for = [&](const CpfgRule& rule, const char* where) {
            refuse(rule.several[1].place, "a predecessor of several modules",
                   std::string(why) + where);
        };
        if (system_.stochastic) fail_for(*first, "without a seed");
        if (system_.ignored || system_.considered)
            fail_for(*first, "where contexts skip no symbols");
        std::vector<std::vector<CpfgModule>> words{modules(system_.axiom)};
        for (const auto* all : {&system_.rules, &system_.decomposition})
            for (const CpfgRule& rule : *all) words.push_back(modules(rule.successor));
        for (const std::vector<CpfgModule>& word : words)
            for (const CpfgModule& module : word)
                if (module.symbol == "[" || module.symbol == "]")
                    fail_for(*first, "in words without branches, which contexts skip");
        std::set<std::string> single;  // modules of the rules so far that have one
        for (const CpfgRule& rule : system_.rules) {
            if (rule.several.empty()) {
                single.insert(rule.letter());
                continue;
            }
            for (const CpfgModule& module : rule.several)
                if (single.contains(module.kind()))
                    fail_for(rule, "before all other rules for one of these modules");
            for (const CpfgRule& other : system_.rules) {
                if (other.several.empty()) continue;
                if (overlaps(rule.several, other.several) ||
                    overlaps(other.several, rule.several) ||
                    holds_part(rule.several, other.several))
                    fail_for(rule, "where two such predecessors cannot share modules of a word");
            }
        }
        std::vector<CpfgRule> split;
        for (const CpfgRule& rule : system_.rules) {
            if (rule.several.empty()) {
                split.push_back(rule);
                continue;
            }
            for (std::size_t i = 0; i < rule.several.size(); ++i) {
                CpfgRule one = rule;
                one.several.clear();
                one.predecessor = rule.several[i];
                const auto at = rule.several.begin() + static_cast<std::ptrdiff_t>(i);
                one.left.insert(one.left.end(), rule.several.begin(), at);
                one.right.insert(one.right.begin(), at + 1, rule.several.end());
                if (i > 0) one.successor = {};
                split.push_back(std::move(one));
            }
        }
        system_.rules = std::move(split);
    }

    // --- Rules for parts of commands ---

    /// Where a rule rewrites the last symbol of a command, `F --> X` that of `~F`, the command has a rule of its own, `~F --> ~X`.
    void add_command_rules() {
        std::vector<CpfgModule> todo;
        std::set<std::string> known;
        const auto meet = [&](const Placed& word) {
            for (const CpfgModule& module : modules(word))
                if (module.symbol.size() > 1 && is_cpfg_command(module.symbol) &&
                    known.insert(module.kind()).second)
                    todo.push_back(module);
        };
        meet(system_.axiom);
        for (const auto* all : {&system_.rules, &system_.decomposition, &system_.interpretation})
            for (const CpfgRule& rule : *all) meet(rule.successor);
        while (!todo.empty()) {
            const CpfgModule command = todo.back();
            todo.pop_back();
            const std::string prefix = command.symbol.substr(0, command.symbol.size() - 1),
                              last = command.symbol.substr(command.symbol.size() - 1);
            const std::vector<CpfgRule> rules = system_.rules;
            for (const CpfgRule& rule : rules) {
                if (rule.predecessor.symbol != last ||
                    rule.predecessor.arguments.size() != command.arguments.size())
                    continue;
                const std::vector<CpfgModule> image = modules(rule.successor);
                if (image.empty() || is_cpfg_command(image[0].symbol) || system_.stochastic)
                    refuse(rule.predecessor.place, "a rule for " + last,
                           "rewrites a part of the command " + command.symbol +
                               ", which is one symbol in the notation");
                CpfgRule own = rule;
                own.predecessor.symbol = command.symbol;
                own.successor = {};
                for (const char c : prefix) own.successor.add(c, rule.successor.place(0));
                own.successor.append(rule.successor.trimmed());
                meet(own.successor);
                system_.rules.push_back(std::move(own));
            }
        }
    }
};

}  // namespace

CpfgSystem with_single_predecessors(const Source& source, const CpfgDialect& dialect,
                                    CpfgSystem system) {
    return Predecessors(source, dialect, std::move(system)).single();
}

}  // namespace algae
