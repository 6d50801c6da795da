#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "exchange/detail/cpfg.hpp"

// Blocks of statements in files of cpfg, as far as they are assignments: `{ x = 0.5*t; y = x + 1; }`.
//
// What a block of a rule assigns is put where its condition and its successor read it. `Start:` assigns constants, and `StartEach: {n = n+1;}` makes
// n a number that grows with the steps. A name keeps its value there from one rule to the next, which nothing here imitates: where one is
// read that was not assigned in the rule itself, it is refused.

namespace algae {

Placed cpfg_with(const Placed& text, const std::map<std::string, Placed>& values) {
    Placed out;
    for (std::size_t i = 0; i < text.text.size();) {
        std::size_t stop = i;
        if (is_name_start(text.text[i]) && (i == 0 || !is_name_part(text.text[i - 1])))
            while (stop < text.text.size() && is_name_part(text.text[stop])) ++stop;
        const auto value = values.find(text.text.substr(i, stop - i));
        if (stop == i || value == values.end()) {
            for (stop = std::max(stop, i + 1); i < stop; ++i) out.add(text.text[i], text.place(i));
            continue;
        }
        const std::size_t place = text.place(i);
        out.add('(', place);
        for (std::size_t k = 0; k < value->second.text.size(); ++k)
            out.add(value->second.text[k], value->second.place(k));
        out.add(')', place);
        i = stop;
    }
    return out;
}

Placed cpfg_with_in_numbers(const Placed& word, const std::map<std::string, Placed>& values) {
    if (values.empty()) return word;
    Placed out;
    for (std::size_t i = 0; i < word.text.size();) {
        std::size_t stop = i;
        int depth = 0;
        do {
            depth += word.text[stop] == '(' ? 1 : word.text[stop] == ')' ? -1 : 0;
            ++stop;
        } while (depth > 0 && stop < word.text.size());
        out.append(stop > i + 1 ? cpfg_with(word.part(i, stop), values) : word.part(i, stop));
        i = stop;
    }
    return out;
}

namespace {

/// A block without calls that neither words nor figures show: messages, and the seed of random numbers, which are refused where they are used.
Placed without_messages(const Placed& block) {
    Placed out;
    for (std::size_t i = 0; i < block.text.size();) {
        std::size_t end = i;
        while (end < block.text.size() && is_name_part(block.text[end])) ++end;
        const std::string name = block.text.substr(i, end - i);
        const bool is_message = name == "printf" || name == "srand";
        if (!is_message || (i > 0 && is_name_part(block.text[i - 1])) || end == block.text.size() ||
            block.text[end] != '(') {
            out.append(block.part(i, std::max(end, i + 1)));
            i = std::max(end, i + 1);
            continue;
        }
        int depth = 0;
        bool quoted = false;
        for (; end < block.text.size(); ++end) {
            const char c = block.text[end];
            if (c == '"' && block.text[end - 1] != '\\') quoted = !quoted;
            if (quoted) continue;
            depth += c == '(' ? 1 : c == ')' ? -1 : 0;
            if (depth == 0) break;
        }
        if (end == block.text.size()) {  // never closed, which is no statement
            out.append(block.part(i, end));
            break;
        }
        i = end + 1;
    }
    return out;
}

}  // namespace

void CpfgReader::assign(const Placed& written, std::map<std::string, Placed>& values) const {
    constexpr std::size_t longest = 10'000;
    const Placed block = without_messages(written);
    if (block.text.find_first_of("{}") != std::string::npos)
        refuse(block.place(block.text.find_first_of("{}")), "a statement other than NAME = number;",
               "has no meaning in the notation");
    for (std::size_t from = 0; from < block.text.size();) {
        const std::size_t end = std::min(block.text.find(';', from), block.text.size());
        const Placed said = block.part(from, end).trimmed();
        from = end + 1;
        if (said.text.empty()) continue;
        const std::string name = name_at(said, 0);
        const std::size_t sign = next(said, name.size());
        const bool assigns = !name.empty() && sign < said.text.size() && said.text[sign] == '=' &&
                             (sign + 1 == said.text.size() || said.text[sign + 1] != '=');
        if (!assigns)
            refuse(said.place(0), "a statement other than NAME = number;",
                   "has no meaning in the notation: found '" + said.text.substr(0, 40) + "'");
        Placed value = cpfg_with(said.part(sign + 1, said.text.size()).trimmed(), values);
        if (value.text.empty()) fail(said.place(sign), "expected a number behind '='");
        if (value.text.size() > longest)
            refuse(said.place(0), "a block",
                   "that gives an expression of more than 10000 characters");
        values[name] = std::move(value);
    }
}

void CpfgReader::read_blocks(CpfgRule& rule) const {
    if (!rule.condition) return;
    const Placed said = *rule.condition;
    const std::size_t open = said.text.find('{');
    if (open == std::string::npos) {
        if (const std::size_t close = said.text.find('}'); close != std::string::npos)
            fail(said.place(close), "unmatched '}'");
        return;
    }
    std::map<std::string, Placed> values;
    std::size_t at = 0;
    if (open == 0) {
        const std::size_t end = closing(said, 0);
        assign(said.part(1, end), values);
        at = end + 1;
    }
    const std::size_t second = std::min(said.text.find('{', at), said.text.size());
    Placed condition = said.part(at, second).trimmed();
    if (condition.text.empty())
        fail(said.place(at), "expected a condition beside the block, as in {x = 1;} 1, found none");
    if (condition.text == "*")
        rule.condition.reset();
    else
        rule.condition = cpfg_with(condition, values);
    if (second < said.text.size()) {
        const std::size_t end = closing(said, second);
        assign(said.part(second + 1, end), values);
        if (const std::size_t more = next(said, end + 1); more < said.text.size())
            fail(said.place(more), "expected '-->' behind the block, found " + shown(said, more));
    }
    for (const auto& [name, value] : values) rule.assigned.insert(name);
    rule.successor = cpfg_with_in_numbers(rule.successor, values);
}

bool CpfgReader::read_header_block(const Placed& said) {
    for (const char* keyword : {"StartEach:", "Start:", "EndEach:", "End:"}) {
        const auto block = behind(said, {keyword});
        if (!block) continue;
        if (block->text.empty() || block->text[0] != '{')
            fail(block->place(0), "expected a block { ... } behind '" + std::string(keyword) + "'");
        const std::size_t end = closing(*block, 0);
        if (const std::size_t more = next(*block, end + 1); more < block->text.size())
            fail(block->place(more),
                 "expected the end of the line behind the block, found " + shown(*block, more));
        const Placed inside = block->part(1, end);
        std::map<std::string, Placed> values;
        if (std::string_view(keyword) == "Start:") {
            assign(inside, system_.started);
            return true;
        }
        assign(inside, values);
        if (values.empty()) return true;
        if (std::string_view(keyword) != "StartEach:")
            refuse(said.place(0), std::string("the block ") + keyword,
                   "holds statements, which have no meaning in the notation");
        for (const auto& [name, value] : values) {
            // NAME + what reads no name that changes.
            const bool grows = name_at(value, 0) == name &&
                               next(value, name.size()) < value.text.size() &&
                               value.text[next(value, name.size())] == '+';
            const Placed step =
                grows ? value.part(next(value, name.size()) + 1, value.text.size()) : Placed{};
            if (!grows || step.text.find_first_not_of("0123456789. ") != std::string::npos)
                refuse(said.place(0), "the block StartEach:",
                       "has a meaning in the notation only where it adds numbers: {n = n+1;}");
            system_.growing[name] = step;
        }
        return true;
    }
    return false;
}

CpfgSystem with_assigned(CpfgSystem system) {
    for (const auto* rules : {&system.rules, &system.decomposition, &system.interpretation})
        for (const CpfgRule& rule : *rules)
            system.kept.insert(rule.assigned.begin(), rule.assigned.end());
    // What grows is the value at the start and a number for each step.
    std::map<std::string, Placed> growing;
    for (const auto& [name, step] : system.growing) {
        if (system.kept.contains(name)) continue;
        const std::size_t place = step.place(0);
        Placed value;
        const auto add = [&](std::string_view text) {
            for (const char c : text) value.add(c, place);
        };
        add("(");
        if (const auto start = system.started.find(name); start != system.started.end())
            value.append(start->second);
        else
            add("0");
        add(")+Q*(");
        value.append(step);
        add(")");
        growing.emplace(name, std::move(value));
        system.started.erase(name);
    }
    for (auto* rules : {&system.rules, &system.decomposition, &system.interpretation})
        for (CpfgRule& rule : *rules) {
            std::map<std::string, Placed> values = growing;
            for (const auto* side : {&rule.left, &rule.right, &rule.several})
                for (const CpfgModule& module : *side)
                    for (const Placed& formal : module.arguments) values.erase(formal.text);
            for (const Placed& formal : rule.predecessor.arguments) values.erase(formal.text);
            if (values.empty()) continue;
            if (rule.condition) rule.condition = cpfg_with(*rule.condition, values);
            rule.successor = cpfg_with_in_numbers(rule.successor, values);
        }
    system.axiom = cpfg_with_in_numbers(system.axiom, growing);
    for (const auto& [name, value] : system.started)
        if (!system.kept.contains(name)) system.constants.emplace_back(name, value);
    return system;
}

}  // namespace algae
