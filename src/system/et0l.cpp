#include "system/et0l.hpp"

#include <algorithm>

#include "system/accessible.hpp"
#include "word/renaming.hpp"

namespace algae {

namespace {

/// Each table gets the identity for letters that have no successor in it.
void complete(Table& table, std::size_t letters) {
    table.resize(letters);
    for (Symbol a = 0; a < letters; ++a)
        if (table[a].empty()) table[a].push_back(Word{a});
}

void add_rule(Table& table, Symbol letter, Word successor) {
    auto& choices = table[letter];
    if (std::find(choices.begin(), choices.end(), successor) == choices.end())
        choices.push_back(std::move(successor));
}

/// Whether the successors of every accessible letter in every table are as `holds` says.
template <class Holds>
bool for_all_accessible(const ET0L& system, Holds holds) {
    const std::vector<Symbol> letters = accessible_letters(system);
    return std::all_of(letters.begin(), letters.end(), [&](Symbol a) {
        return std::all_of(system.tables.begin(), system.tables.end(),
                           [&](const Table& table) { return holds(table[a]); });
    });
}

}  // namespace

View<ET0L> as_et0l(const LSystem& written) {
    LSystem plain = written;  // what else goes beyond 0L is looked for without these two
    plain.tables.clear();
    plain.schedule.clear();
    plain.terminals.clear();
    if (std::string reason = beyond_ol(plain); !reason.empty())
        return View<ET0L>::refused("not an ET0L system: " + reason);
    ET0L system;
    system.alphabet = std::make_shared<const Alphabet>(written.alphabet);
    system.axiom = written.axiom.letters;
    system.name = written.name;
    system.table_names = written.tables;
    if (system.table_names.empty()) system.table_names.emplace_back();
    const std::size_t letters = system.alphabet->size();
    system.tables.assign(system.table_names.size(), Table(letters));
    for (const Production& rule : written.rules)
        add_rule(system.tables.at(rule.table), rule.predecessor.symbol, rule.successor.letters);
    for (Table& table : system.tables) complete(table, letters);
    system.terminal.assign(letters, written.terminals.empty());
    for (const Symbol a : written.terminals) system.terminal[a] = 1;
    return system;
}

ET0L as_et0l(const OL& system) {
    return {system.alphabet,     system.axiom,
            {system.successors}, std::vector<char>(system.successors.size(), 1),
            {std::string()},     system.name};
}

bool has_only_terminals(const ET0L& system) {
    const std::vector<Symbol> letters = accessible_letters(system);
    return std::all_of(letters.begin(), letters.end(),
                       [&](Symbol a) { return system.terminal[a] != 0; });
}

bool is_deterministic(const ET0L& system) {
    return for_all_accessible(system,
                              [](const std::vector<Word>& choices) { return choices.size() == 1; });
}

bool is_propagating(const ET0L& system) {
    return for_all_accessible(system, [](const std::vector<Word>& choices) {
        return std::none_of(choices.begin(), choices.end(),
                            [](const Word& word) { return word.empty(); });
    });
}

std::vector<Symbol> accessible_letters(const ET0L& system) {
    return accessible(system.axiom, system.terminal.size(), [&](Symbol a, auto see) {
        for (const Table& table : system.tables)
            for (const Word& successor : table[a]) see(successor);
    });
}

std::string family_name(const ET0L& system) {
    std::string name;
    if (!has_only_terminals(system)) name += 'E';
    if (is_propagating(system)) name += 'P';
    if (is_deterministic(system)) name += 'D';
    if (system.tables.size() > 1) name += 'T';
    return name + "0L";
}

ET0L over(const ET0L& system, std::shared_ptr<const Alphabet> alphabet) {
    const std::vector<Symbol> letters = renaming(*system.alphabet, *alphabet);
    ET0L moved{alphabet,
               replaced(system.axiom, letters),
               {},
               std::vector<char>(alphabet->size(), 0),
               system.table_names,
               system.name};
    for (const Table& table : system.tables) {
        Table& target = moved.tables.emplace_back(alphabet->size());
        for (Symbol a = 0; a < table.size(); ++a)
            for (const Word& successor : table[a])
                target[letters[a]].push_back(replaced(successor, letters));
        complete(target, alphabet->size());
    }
    for (Symbol a = 0; a < letters.size(); ++a) moved.terminal[letters[a]] = system.terminal[a];
    return moved;
}

ET0L et0l(const std::string& axiom,
          const std::vector<std::vector<std::pair<char, std::string>>>& tables,
          const std::string& terminals) {
    LSystem system;
    const auto word = [&](const std::string& text) {
        Word letters;
        for (const char c : text) letters.push_back(system.alphabet.symbol(std::string(1, c)));
        return letters;
    };
    system.axiom.letters = word(axiom);
    for (std::size_t t = 0; t < tables.size(); ++t) {
        if (tables.size() > 1) system.tables.push_back(std::to_string(t + 1));
        for (const auto& [a, successor] : tables[t]) {
            Production rule;
            rule.predecessor.symbol = word(std::string(1, a)).front();
            rule.successor.letters = word(successor);
            rule.table = t;
            system.rules.push_back(std::move(rule));
        }
    }
    system.terminals = word(terminals);
    return *as_et0l(system);
}

}  // namespace algae
