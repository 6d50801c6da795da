#include "language/detail/construct.hpp"

#include <algorithm>
#include <cctype>
#include <limits>
#include <map>
#include <set>

#include "exact/exact.hpp"

// Drafts of ET0L systems, and the normal forms that the other constructions build on: synchronised, without
// erasing rules, with two tables, the powers of a D0L system (Rozenberg and Salomaa 1980, II.1 and V.1).
//
// A `Draft` has letters of its own, which are numbers; names are given out only when the system is done, so
// constructions need not care for names that are taken. A letter without a rule in a table fails there: it
// derives itself only, and is not a terminal.
//
// Synchronised: each letter has a copy that is not a terminal. Copies are rewritten as the letters were, and
// where a successor has terminals only a copy may also become that word itself; successors of terminals fail.
// So all letters of a word become terminals in one step.
//
// Without erasing rules: a letter of the result is a letter x together with a set of letters of which nothing
// remains in the end; the system guesses of each letter whether something remains. Equal letters of a word that
// vanish may vanish in the same way, so a set of them is enough, and it is kept with some letter next to it
// that remains. Sets are the least ones that rules allow.

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

ET0L synchronised(const ET0L& system) {
    Draft draft(*system.alphabet, 0);
    draft.add_tables(system);
    const auto copies = draft.copies(system), letters = draft.letters(system);
    const Symbol start = draft.fresh("S");
    for (std::size_t t = 0; t < system.tables.size(); ++t) {
        const auto add = [&](Symbol letter, const Word& successor) {
            draft.add_rule(t, letter, replaced(successor, copies));
            if (is_terminal_word(system, successor))
                draft.add_rule(t, letter, replaced(successor, letters));
        };
        add(start, system.axiom);
        for (Symbol a = 0; a < copies.size(); ++a)
            for (const Word& successor : system.tables[t][a]) add(copies[a], successor);
    }
    return draft.system({start}, system.name);
}

namespace {

using Letters = std::set<Symbol>;

/// The letters that derive, each with tables of its own, words of letters that may go.
std::vector<char> vanishing(const ET0L& system, std::vector<char> found) {
    for (bool grown = true; grown;) {
        grown = false;
        for (const Table& rules : system.tables)
            for (Symbol a = 0; a < rules.size(); ++a)
                if (!found[a] &&
                    std::any_of(rules[a].begin(), rules[a].end(),
                                [&](const Word& word) { return all_marked(word, found); }))
                    found[a] = grown = true;
    }
    return found;
}

/// The least sets of letters that vanish which words over these letters become in one step.
std::set<Letters> next_sets(const Letters& letters, const Table& rules,
                            const std::vector<char>& vanish) {
    std::set<Letters> found{{}};
    for (const Symbol a : letters) {
        std::set<Letters> longer;
        for (const Letters& begun : found)
            for (const Word& successor : rules[a])
                if (all_marked(successor, vanish)) {
                    Letters more = begun;
                    more.insert(successor.begin(), successor.end());
                    longer.insert(std::move(more));
                }
        found.clear();
        for (const Letters& candidate : longer)
            if (std::none_of(longer.begin(), longer.end(), [&](const Letters& other) {
                    return other.size() < candidate.size() &&
                           std::includes(candidate.begin(), candidate.end(), other.begin(),
                                         other.end());
                }))
                found.insert(candidate);
    }
    return found;
}

/// The letters of the result and its rules, from the axiom on.
class Guesses {
public:
    Guesses(const ET0L& system, const Alphabet& base, const std::vector<char>& vanish,
            const Budget& budget)
        : system_(&system), draft_(base, 0), vanish_(&vanish), budget_(&budget) {
        draft_.add_tables(system);
    }

    ET0L result(std::string name) {
        const Word axiom{*letter(system_->axiom.front(), {})};
        while (!open_.empty()) {
            const auto [a, set] = open_.back();
            open_.pop_back();
            for (std::size_t t = 0; t < system_->tables.size(); ++t)
                for (const Letters& next : next_sets(set, system_->tables[t], *vanish_))
                    for (const Word& successor : system_->tables[t][a])
                        add_rules(t, letters_.at({a, set}), successor, next);
        }
        return draft_.system(axiom, std::move(name));
    }

private:
    /// The letter for a letter that remains and a set that vanishes; none if not all of them become
    /// terminals in the same step.
    std::optional<Symbol> letter(Symbol a, const Letters& set) {
        const bool done = system_->terminal[a];
        for (const Symbol b : set)
            if ((system_->terminal[b] != 0) != done) return std::nullopt;
        if (done) return draft_.terminal(system_->alphabet->name(a));
        const auto [place, fresh] = letters_.try_emplace({a, set}, 0);
        if (fresh) {
            place->second = draft_.fresh(system_->alphabet->name(a));
            open_.emplace_back(a, set);
        }
        return place->second;
    }

    /// One rule for each way to choose what remains of the successor.
    void add_rules(std::size_t table, Symbol from, const Word& successor, const Letters& set) {
        std::vector<char> gone(successor.size());
        for (;;) {
            add_rule(table, from, successor, set, gone);
            std::size_t i = 0;  // counts in binary over the letters that may vanish
            while (i < gone.size() && (gone[i] || !(*vanish_)[successor[i]])) gone[i++] = false;
            if (i == gone.size()) return;
            gone[i] = true;
            draft_.check(*budget_);
        }
    }

    void add_rule(std::size_t table, Symbol from, const Word& successor, Letters set,
                  const std::vector<char>& gone) {
        for (std::size_t i = 0; i < successor.size(); ++i)
            if (gone[i]) set.insert(successor[i]);
        Word word;
        for (std::size_t i = 0; i < successor.size(); ++i) {
            if (gone[i]) continue;
            const auto next = letter(successor[i], set);
            if (!next) return;
            word.push_back(*next);
            set.clear();
        }
        if (!word.empty()) draft_.add_rule(table, from, word);
    }

    const ET0L* system_;
    Draft draft_;
    const std::vector<char>* vanish_;
    const Budget* budget_;
    std::map<std::pair<Symbol, Letters>, Symbol> letters_;
    std::vector<std::pair<Symbol, Letters>> open_;
};

}  // namespace

ET0L propagating(const ET0L& system, const Budget& budget) { return thinned(system, {}, budget); }

ET0L thinned(const ET0L& system, const std::vector<char>& may_go, const Budget& budget) {
    const ET0L separate = synchronised(system);
    std::vector<char> vanish(separate.alphabet->size());
    for (Symbol a = 0; a < may_go.size(); ++a) vanish[a] = may_go[a] && separate.terminal[a];
    vanish = vanishing(separate, std::move(vanish));
    return Guesses(separate, *system.alphabet, vanish, budget).result(system.name);
}

bool can_vanish(const ET0L& system, const std::vector<char>& may_go, const Budget& budget) {
    std::vector<char> gone(system.alphabet->size());
    for (Symbol a = 0; a < may_go.size(); ++a) gone[a] = may_go[a] && system.terminal[a];
    const std::vector<char> vanish = vanishing(system, gone);
    const Letters axiom(system.axiom.begin(), system.axiom.end());
    std::set<Letters> seen{axiom};
    std::vector<Letters> open{axiom};
    std::uint64_t bytes = 0;
    while (!open.empty()) {
        const Letters letters = std::move(open.back());
        open.pop_back();
        if (all_marked(letters, gone)) return true;
        for (const Table& rules : system.tables)
            for (const Letters& next : next_sets(letters, rules, vanish))
                if (seen.insert(next).second) {
                    open.push_back(next);
                    budget.check();
                    budget.check_memory(bytes += 64 * (next.size() + 1),
                                        "the sets of letters that vanish");
                }
    }
    return false;
}

ET0L with_two_tables(const ET0L& system) {
    const std::size_t count = system.tables.size();
    if (count <= 2) return system;
    Draft draft(*system.alphabet, 0);
    const std::size_t turn = draft.add_table("turn"), rewrite = draft.add_table("rewrite");
    std::vector<std::vector<Symbol>> copies{draft.letters(system)};  // for each table
    while (copies.size() < count) copies.push_back(draft.copies(system));
    for (std::size_t t = 0; t < count; ++t)
        for (Symbol a = 0; a < system.alphabet->size(); ++a) {
            draft.add_rule(turn, copies[t][a], {copies[(t + 1) % count][a]});
            for (const Word& successor : system.tables[t][a])
                draft.add_rule(rewrite, copies[t][a], replaced(successor, copies[0]));
        }
    return draft.system(replaced(system.axiom, copies[0]), system.name);
}

namespace {

/// The word after one step. Throws BoundReached if it is longer than the budget allows.
Word step(const D0L& system, const Word& word, const Budget& budget) {
    Word next;
    for (const Symbol a : word) {
        const Word& successor = system.successor(a);
        if (next.size() + successor.size() > budget.letters)
            throw BoundReached(Bound::letters,
                               "the rules of a power have words of more than " +
                                   std::to_string(budget.letters) + " letters, the bound set" +
                                   budget.by(Bound::letters) + ": use a smaller power");
        next.insert(next.end(), successor.begin(), successor.end());
    }
    return next;
}

}  // namespace

std::vector<D0L> powers(const D0L& system, unsigned power, const Budget& budget) {
    if (power == 0) throw Error("expected a power of at least 1, found 0");
    std::vector<Word> images(system.alphabet->size());
    for (Symbol a = 0; a < images.size(); ++a) images[a] = {a};
    for (unsigned i = 0; i < power; ++i)
        for (const Symbol a : system.letters) {
            budget.check();
            images[a] = step(system, images[a], budget);
        }
    std::vector<D0L> found;
    Word axiom = system.axiom;
    for (unsigned i = 0; i < power; ++i) {
        found.push_back(make_d0l(system.alphabet, axiom, images, system.name));
        if (i + 1 < power) axiom = step(system, axiom, budget);
    }
    return found;
}

}  // namespace algae
