#include "language/construct_draft.hpp"

#include <algorithm>
#include <cctype>
#include <limits>
#include <set>
#include <utility>

#include "base/error.hpp"

namespace algae {

namespace {

constexpr Symbol none = std::numeric_limits<Symbol>::max();

/// What new names begin with: the first character of the name if it is a letter.
std::string stem(const std::string& name) {
    if (name.empty()) return "X";
    const auto lead = static_cast<unsigned char>(name[0]);
    if (lead < 0x80) return std::isalpha(lead) != 0 ? name.substr(0, 1) : "X";
    std::size_t end = 1;
    while (end < name.size() && (static_cast<unsigned char>(name[end]) & 0xC0) == 0x80) ++end;
    return name.substr(0, end);
}

bool all_marked(const Word& word, const std::vector<char>& marks) {
    return std::all_of(word.begin(), word.end(), [&](Symbol a) { return marks[a] != 0; });
}

}  // namespace

Symbol NewNames::symbol(const std::string& like) {
    const std::string begin = stem(like);
    std::string name = begin;
    for (std::size_t& number = last_[begin]; alphabet_->find(name);
         name = begin + "_" + std::to_string(number))
        ++number;
    return alphabet_->symbol(name);
}

Draft::Draft(const Alphabet& base, std::size_t tables)
    : base_(base), tables_(tables), table_names_(tables) {}

Symbol Draft::terminal(const std::string& name) {
    const Symbol symbol = base_.symbol(name);
    by_symbol_.resize(base_.size(), none);
    if (by_symbol_[symbol] == none) {
        by_symbol_[symbol] = static_cast<Symbol>(letters_.size());
        letters_.push_back({name, true});
    }
    return by_symbol_[symbol];
}

Symbol Draft::fresh(const std::string& like) {
    letters_.push_back({like, false});
    ++size_;
    return static_cast<Symbol>(letters_.size() - 1);
}

std::size_t Draft::add_table(std::string name) {
    tables_.emplace_back();
    table_names_.push_back(std::move(name));
    return tables_.size() - 1;
}

std::size_t Draft::add_tables(const ET0L& system) {
    const std::size_t first = tables_.size();
    for (const std::string& name : system.table_names) add_table(name);
    while (tables_.size() < first + system.tables.size()) add_table();
    return first;
}

void Draft::add_rule(std::size_t table, Symbol letter, Word successor) {
    Table& rules = tables_.at(table);
    if (rules.size() <= letter) rules.resize(letters_.size());
    size_ += successor.size() + 1;
    rules[letter].push_back(std::move(successor));
}

void Draft::keep(Symbol letter) {
    for (std::size_t t = 0; t < tables_.size(); ++t) add_rule(t, letter, {letter});
}

void Draft::keep_terminals() {
    for (Symbol a = 0; a < letters_.size(); ++a)
        if (letters_[a].terminal) keep(a);
}

std::vector<Symbol> Draft::copies(const ET0L& system) {
    std::vector<Symbol> found;
    for (Symbol a = 0; a < system.alphabet->size(); ++a)
        found.push_back(fresh(system.alphabet->name(a)));
    return found;
}

std::vector<Symbol> Draft::letters(const ET0L& system) {
    std::vector<Symbol> found;
    for (Symbol a = 0; a < system.alphabet->size(); ++a) {
        const std::string& name = system.alphabet->name(a);
        found.push_back(system.terminal[a] ? terminal(name) : fresh(name));
    }
    return found;
}

void Draft::add_rules(std::size_t table, const ET0L& system, std::size_t from,
                      const std::vector<Symbol>& letters) {
    const Table& rules = system.tables[from];
    for (Symbol a = 0; a < rules.size(); ++a)
        for (const Word& successor : rules[a])
            add_rule(table, letters[a], replaced(successor, letters));
}

Word Draft::terminals(const Alphabet& alphabet, const Word& word) {
    Word found;
    for (const Symbol a : word) found.push_back(terminal(alphabet.name(a)));
    return found;
}

void Draft::check(const Budget& budget) const {
    budget.check();
    budget.check_memory(size_ * sizeof(Word), "the constructed system");
}

/// The letters from which some word of terminals is derived if each letter may choose its table.
std::vector<char> Draft::productive() const {
    std::vector<char> found(letters_.size());
    for (std::size_t a = 0; a < letters_.size(); ++a) found[a] = letters_[a].terminal;
    for (bool grown = true; grown;) {
        grown = false;
        for (const Table& rules : tables_)
            for (std::size_t a = 0; a < rules.size(); ++a)
                if (!found[a] &&
                    std::any_of(rules[a].begin(), rules[a].end(),
                                [&](const Word& word) { return all_marked(word, found); }))
                    found[a] = grown = true;
    }
    return found;
}

std::vector<char> Draft::accessible(const Word& axiom, const std::vector<char>& useful) const {
    std::vector<char> found(letters_.size());
    if (!all_marked(axiom, useful)) return found;
    std::vector<Symbol> open;
    const auto reach = [&](const Word& word) {
        for (const Symbol a : word)
            if (!std::exchange(found[a], true)) open.push_back(a);
    };
    reach(axiom);
    while (!open.empty()) {
        const Symbol letter = open.back();
        open.pop_back();
        for (const Table& rules : tables_)
            if (letter < rules.size())
                for (const Word& word : rules[letter])
                    if (all_marked(word, useful)) reach(word);
    }
    return found;
}

ET0L Draft::system(const Word& axiom, std::string name) const {
    const std::vector<char> useful = productive(), kept = accessible(axiom, useful);
    Alphabet alphabet = base_;
    NewNames names(alphabet);
    std::vector<Symbol> symbols(letters_.size(), none);
    for (std::size_t a = 0; a < letters_.size(); ++a)
        if (letters_[a].terminal)
            symbols[a] = alphabet.symbol(letters_[a].name);
        else if (kept[a])
            symbols[a] = names.symbol(letters_[a].name);

    Symbol failing = none;
    const auto fail = [&] {
        if (failing == none) failing = names.symbol("F");
        return Word{failing};
    };
    ET0L result;
    result.axiom = all_marked(axiom, useful) ? replaced(axiom, symbols) : fail();
    result.tables.resize(tables_.size());
    for (std::size_t t = 0; t < tables_.size(); ++t) {
        Table& rules = result.tables[t];
        for (std::size_t a = 0; a < letters_.size(); ++a) {
            if (symbols[a] == none) continue;
            if (rules.size() <= symbols[a]) rules.resize(symbols[a] + 1);
            auto& successors = rules[symbols[a]];
            std::set<Word> seen;
            if (kept[a] && a < tables_[t].size())
                for (const Word& word : tables_[t][a])
                    if (all_marked(word, useful) && seen.insert(word).second)
                        successors.push_back(replaced(word, symbols));
            if (successors.empty()) successors.push_back(fail());
        }
    }
    for (Table& rules : result.tables) {
        rules.resize(alphabet.size());
        for (Symbol a = 0; a < rules.size(); ++a)
            if (rules[a].empty()) rules[a].push_back({a});
    }
    result.terminal.resize(alphabet.size());
    for (std::size_t a = 0; a < letters_.size(); ++a)
        if (letters_[a].terminal) result.terminal[symbols[a]] = true;
    result.table_names = table_names_;
    result.alphabet = std::make_shared<const Alphabet>(std::move(alphabet));
    result.name = std::move(name);
    return result;
}

bool is_terminal_word(const ET0L& system, const Word& word) {
    return all_marked(word, system.terminal);
}

ET0L trimmed(const ET0L& system, const Alphabet& base, std::string name) {
    Draft draft(base, 0);
    draft.add_tables(system);
    const auto letters = draft.letters(system);
    for (std::size_t t = 0; t < system.tables.size(); ++t) draft.add_rules(t, system, t, letters);
    return draft.system(replaced(system.axiom, letters), std::move(name));
}

void require_one_table(const ET0L& system, const char* what) {
    if (system.tables.size() == 1) return;
    throw Error((system.name.empty() ? std::string() : system.name + ": ") + what +
                " needs an E0L system: expected one table, found " +
                std::to_string(system.tables.size()));
}

}  // namespace algae
