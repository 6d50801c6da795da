#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "exact/exact.hpp"
#include "verify/detail/checking.hpp"
#include "verify/detail/languages.hpp"
#include "verify/verify.hpp"

// Systems of the checker: their steps on words, the relations that derivations induce on the states of an automaton, and the lengths of
// D0L sequences.
//
// A step with context matches contexts letter by letter, by definition. Relations of sequences of tables are finitely many, so walking through
// them ends; that is how statements about all derivations of any length are checked.

namespace algae::verify {

std::vector<Symbol> accessible_letters(const System& system, const Word& from) {
    std::set<Symbol> letters(from.begin(), from.end());
    for (std::size_t before = 0; before != letters.size();) {
        before = letters.size();
        const std::set<Symbol> known = letters;
        for (const Symbol a : known) {
            for (const auto& table : system.tables)
                for (const Word& word : table[a]) letters.insert(word.begin(), word.end());
            for (const System::Rule& rule : system.rules)
                if (rule.letter == a) letters.insert(rule.successor.begin(), rule.successor.end());
        }
    }
    return {letters.begin(), letters.end()};
}

bool has_only_terminals(const System& system) {
    return is_terminal(system, accessible_letters(system, system.axiom));
}

namespace {

/// Whether in every table the successors of every accessible letter are so.
template <class Property>
bool each_successors(const System& system, Property is_so) {
    const auto letters = accessible_letters(system, system.axiom);
    return std::all_of(system.tables.begin(), system.tables.end(), [&](const auto& table) {
        return std::all_of(letters.begin(), letters.end(),
                           [&](Symbol a) { return is_so(table[a]); });
    });
}

bool is_deterministic(const System& system) {
    return each_successors(system, [](const auto& all) { return all.size() == 1; });
}

bool is_propagating(const System& system) {
    return each_successors(
        system, [](const auto& all) { return !std::count(all.begin(), all.end(), Word{}); });
}

}  // namespace

bool is_d0l(const System& system) {
    return !system.context && system.tables.size() == 1 && is_deterministic(system) &&
           has_only_terminals(system);
}

std::set<Symbol> lasting_letters(const System::Successors& table) {
    std::set<Symbol> letters;
    for (Symbol a = 0; a < table.size(); ++a) letters.insert(a);
    for (std::size_t before = 0; before != letters.size();) {
        before = letters.size();
        const std::set<Symbol> known = letters;
        for (const Symbol a : known)
            if (std::none_of(table[a].begin(), table[a].end(), [&](const Word& word) {
                    return std::any_of(word.begin(), word.end(),
                                       [&](Symbol b) { return known.contains(b); });
                }))
                letters.erase(a);
    }
    return letters;
}

bool is_endless(const System& system) {
    if (system.context || system.tables.size() != 1 || !has_only_terminals(system)) return false;
    const auto& table = system.tables.front();
    const std::set<Symbol> lasting = lasting_letters(table);
    for (const Symbol a : accessible_letters(system, system.axiom))
        for (const Word& successor : table[a])
            for (std::size_t i = 0; i < successor.size(); ++i) {
                bool beside = false;
                for (std::size_t at = 0; at < successor.size(); ++at)
                    beside = beside || (at != i && lasting.contains(successor[at]));
                if (!beside) continue;
                const auto derived = accessible_letters(system, {successor[i]});
                if (std::count(derived.begin(), derived.end(), a) > 0) return true;
            }
    return false;
}

bool rewrites_singly(const System& system) {
    if (system.context || system.tables.size() != 1) return false;
    const auto& table = system.tables.front();
    const auto letters = accessible_letters(system, system.axiom);
    return std::all_of(letters.begin(), letters.end(), [&](Symbol a) {
        return std::count(table[a].begin(), table[a].end(), Word{a}) > 0;
    });
}

bool is_checked_family(std::string_view name) {
    static constexpr std::array families = {"0L",    "P0L", "D0L",  "PD0L",  "T0L", "PT0L", "DT0L",
                                            "PDT0L", "E0L", "ET0L", "EDT0L", "IL",  "REG",  "CF"};
    return std::count(families.begin(), families.end(), name) > 0;
}

bool is_family_of_forms(std::string_view name) {
    const auto take = [&](char letter) {
        const bool is_there = name.starts_with(letter);
        if (is_there) name.remove_prefix(1);
        return is_there;
    };
    const auto take_number = [&] {
        const auto digits = std::min(name.find_first_not_of("0123456789"), name.size());
        name.remove_prefix(digits);
        return digits > 0;
    };
    const bool extended = take('E');
    take('P');
    take('D');
    const bool tables = take('T');
    if (name == "0L") return true;
    if (extended || tables) return false;
    if (name == "IL" || name == "1L" || name == "2L") return true;
    return take('(') && take_number() && take(',') && take_number() && name == ")L";
}

std::optional<std::string> beyond_form(const System& system, const std::string& family,
                                       bool empty_axiom) {
    const bool interactive = family == "IL";
    const bool extended = family.find('E') != std::string::npos;
    const bool tables = family.find('T') != std::string::npos;
    if (!interactive && !family.ends_with("0L"))
        return "no system has the form of the family " + family;
    if (!empty_axiom && system.axiom.empty()) return "the axiom is empty";
    if (system.context)
        return interactive ? std::nullopt : std::optional<std::string>("the rules have contexts");
    if (!tables && system.tables.size() != 1) return "the system has more than one table";
    if (!extended && !has_only_terminals(system))
        return "a letter that is not a terminal occurs in derived words";
    if (family.find('D') != std::string::npos && !is_deterministic(system))
        return "a letter has more than one successor";
    if (family.find('P') != std::string::npos && !is_propagating(system))
        return "a letter has the empty successor";
    return std::nullopt;
}

namespace {

/// Whether the letters that are seen from one place to another begin with the context, read in the same direction.
template <class Letter, class Wanted>
bool matches(const System& system, Letter at, Letter end, Wanted wanted, Wanted last) {
    for (; wanted != last && at != end; ++at) {
        if (system.ignored[*at]) continue;
        if (*at != *wanted) return false;
        ++wanted;
    }
    return wanted == last;
}

}  // namespace

std::vector<Word> successors_at(const System& system, const Word& word, std::size_t place) {
    const System::Rule* best = nullptr;
    for (const System::Rule& rule : system.rules) {
        if (rule.letter != word[place]) continue;
        if (best && rule.left.size() + rule.right.size() <= best->left.size() + best->right.size())
            continue;
        const auto here = word.begin() + static_cast<std::ptrdiff_t>(place);
        if (matches(system, std::make_reverse_iterator(here), word.rend(), rule.left.rbegin(),
                    rule.left.rend()) &&
            matches(system, here + 1, word.end(), rule.right.begin(), rule.right.end()))
            best = &rule;
    }
    if (!best) return {{word[place]}};
    std::vector<Word> all;
    for (const System::Rule& rule : system.rules)
        if (rule.letter == best->letter && rule.left == best->left && rule.right == best->right)
            all.push_back(rule.successor);
    return all;
}

std::set<Word> next_words(const System& system, const Word& word, std::size_t most,
                          const Budget& budget) {
    std::vector<Word> made{Word{}};
    for (std::size_t i = 0; i < word.size(); ++i) {
        if (i % 64 == 0) budget.check();
        const std::vector<Word> choices = successors_at(system, word, i);
        if (choices.size() == 1) {
            for (Word& each : made) each.insert(each.end(), choices[0].begin(), choices[0].end());
            std::erase_if(made, [&](const Word& each) { return each.size() > most; });
            continue;
        }
        std::set<Word> longer;
        std::uint64_t bytes = 0;
        for (const Word& start : made)
            for (const Word& successor : choices) {
                if (start.size() + successor.size() > most) continue;
                Word next = start;
                next.insert(next.end(), successor.begin(), successor.end());
                bytes += 80 + next.size() * sizeof(Symbol);
                budget.check_memory(bytes, "the words after one step");
                longer.insert(std::move(next));
            }
        made.assign(longer.begin(), longer.end());
    }
    return {made.begin(), made.end()};
}

bool may_give(const System& system, const Word& from, const Word& to) {
    std::set<std::size_t> reached{0};  // how much of `to` the letters so far can have become
    for (std::size_t i = 0; i < from.size(); ++i) {
        std::set<std::size_t> next;
        for (const Word& successor : successors_at(system, from, i))
            for (const std::size_t start : reached)
                if (stands_at(successor, to, start)) next.insert(start + successor.size());
        reached = std::move(next);
        if (reached.empty()) return false;
    }
    return reached.contains(to.size());
}

bool may_give(const System::Successors& table, const Word& from, const Word& to) {
    std::set<std::size_t> reached{0};  // how much of `to` the letters so far can have become
    for (const Symbol a : from) {
        std::set<std::size_t> next;
        for (const std::size_t start : reached)
            for (const Word& image : table[a])
                if (stands_at(image, to, start)) next.insert(start + image.size());
        reached = std::move(next);
        if (reached.empty()) return false;
    }
    return reached.contains(to.size());
}

bool never_shrinks(const System& system) {
    if (system.context)
        return std::none_of(system.rules.begin(), system.rules.end(),
                            [](const System::Rule& rule) { return rule.successor.empty(); });
    return is_propagating(system);
}

BooleanMatrix relation_of(const Word& word, const Relations& relations, std::size_t states) {
    BooleanMatrix product = BooleanMatrix::identity(states);
    for (const Symbol a : word) product = product.then(relations.at(a));
    return product;
}

Relations one_step_earlier(const Relations& relations, const System::Successors& table,
                           std::size_t states) {
    Relations earlier;
    for (const auto& [a, relation] : relations) {
        BooleanMatrix all(states);
        for (const Word& word : table[a]) all |= relation_of(word, relations, states);
        earlier.emplace(a, std::move(all));
    }
    return earlier;
}

namespace {

/// Counts the work of steps, and ends it before it would take too long.
class Work {
public:
    Work(const System& system, const Relations& relations, std::size_t states, const Budget& budget)
        : budget_(budget) {
        std::uint64_t letters = 1;
        for (const auto& table : system.tables)
            for (const auto& [a, relation] : relations)
                for (const Word& word : table[a]) letters += word.size() + 1;
        const double rows = static_cast<double>(states) * static_cast<double>(states);
        one_step_ = static_cast<double>(letters) * rows * (1 + static_cast<double>(states) / 128);
    }

    void add() {
        budget_.check();
        done_ += one_step_;
        if (done_ > most)
            throw BoundReached(Bound::method,
                               "the tables of what letters derive would take too long");
    }

private:
    static constexpr double most = 5e10;  // operations: minutes

    const Budget& budget_;
    double one_step_ = 0, done_ = 0;
};

std::uint64_t bytes_of(const Relations& relations) {
    std::uint64_t bytes = 64;
    for (const auto& [a, relation] : relations) bytes += 64 + relation.bytes();
    return bytes;
}

}  // namespace

bool some_relations(const System& system, const Relations& start, std::size_t states,
                    const std::function<bool(const Relations&)>& stop, const Budget& budget) {
    budget.check_memory(bytes_of(start), "the table of what letters derive");
    Work work(system, start, states, budget);
    std::set<Relations> known{start};
    std::vector<const Relations*> open{&*known.begin()};
    std::uint64_t bytes = bytes_of(start);
    for (std::size_t i = 0; i < open.size(); ++i) {
        if (stop(*open[i])) return true;
        for (const auto& table : system.tables) {
            work.add();
            const auto [place, is_new] = known.insert(one_step_earlier(*open[i], table, states));
            if (!is_new) continue;
            bytes += bytes_of(*place);
            budget.check_memory(bytes, "the tables of what letters derive");
            open.push_back(&*place);
        }
    }
    return false;
}

bool some_relations_after(const System& system, const Relations& start, std::size_t states,
                          const Integer& steps, const std::function<bool(const Relations&)>& stop,
                          const Budget& budget) {
    Work work(system, start, states, budget);
    std::map<std::set<Relations>, std::size_t> known;
    std::vector<const std::set<Relations>*> levels;
    std::set<Relations> level{start};
    std::uint64_t bytes = 0;
    for (;;) {
        for (const Relations& relations : level) bytes += bytes_of(relations);
        budget.check_memory(bytes, "the tables of what letters derive");
        const auto [place, is_new] = known.emplace(level, levels.size());
        std::size_t wanted = levels.size();
        if (!is_new) {  // from the level before on they come round again
            const std::size_t first = place->second, period = levels.size() - first;
            wanted = first + static_cast<std::size_t>(
                                 remainder(steps - first, Integer(period)).to_uint64());
        } else {
            levels.push_back(&place->first);
        }
        if (!is_new || steps == wanted)
            return std::any_of(levels[wanted]->begin(), levels[wanted]->end(), stop);
        std::set<Relations> next;
        for (const Relations& relations : level)
            for (const auto& table : system.tables) {
                budget.check_memory(bytes + (next.size() + 1) * bytes_of(relations),
                                    "the tables of what letters derive");
                work.add();
                next.insert(one_step_earlier(relations, table, states));
            }
        level = std::move(next);
    }
}

Lengths::Lengths(const System& system)
    : system_(system), symbols_(accessible_letters(system, system.axiom)) {
    for (const Symbol a : symbols_)
        counts_.emplace_back(std::count(system.axiom.begin(), system.axiom.end(), a));
}

Integer Lengths::length() const {
    Integer all;
    for (const Integer& count : counts_) all += count;
    return all;
}

void Lengths::next() {
    std::vector<Integer> later(counts_.size());
    for (std::size_t i = 0; i < symbols_.size(); ++i)
        for (const Symbol b : system_.tables.front()[symbols_[i]].front()) {
            const auto place = std::lower_bound(symbols_.begin(), symbols_.end(), b);
            later[static_cast<std::size_t>(place - symbols_.begin())] += counts_[i];
        }
    counts_ = std::move(later);
}

Integer length_of_generation(const System& system, const Integer& generation,
                             const Budget& budget) {
    if (generation > 100'000)
        throw BoundReached(Bound::method, "generation " + to_string(generation) +
                                              " is not counted, only those up to 100000");
    Lengths lengths(system);
    for (std::uint64_t n = 0; generation != n; ++n) {
        budget.check();
        lengths.next();
    }
    return lengths.length();
}

std::optional<Symbol> letter_of_generation(const System& system, std::uint64_t generation,
                                           Integer position, const Budget& budget) {
    const auto symbols = accessible_letters(system, system.axiom);
    const auto& table = system.tables.front();
    std::vector<std::map<Symbol, Integer>> lengths(1);  // of what a letter becomes, by steps
    for (const Symbol a : symbols) lengths[0][a] = 1;
    std::uint64_t bytes = 0;
    for (std::uint64_t step = 1; step <= generation; ++step) {
        budget.check();
        auto& later = lengths.emplace_back();
        for (const Symbol a : symbols) {
            Integer& length = later[a];
            for (const Symbol b : table[a].front())
                length += lengths[static_cast<std::size_t>(step) - 1].at(b);
            bytes += 64 + bit_length(length) / 8;
        }
        budget.check_memory(bytes, "the lengths of what letters become");
    }
    const Word* word = &system.axiom;
    for (std::uint64_t left = generation + 1; left-- > 0;) {
        std::optional<Symbol> at;
        for (const Symbol a : *word) {
            const Integer& length = lengths[static_cast<std::size_t>(left)].at(a);
            if (position < length) {
                at = a;
                break;
            }
            position -= length;
        }
        if (!at || left == 0) return at;
        word = &table[*at].front();
    }
    return std::nullopt;
}

}  // namespace algae::verify
