#include <algorithm>
#include <map>
#include <vector>

#include "exact/exact.hpp"
#include "verify/detail/checking.hpp"
#include "verify/verify.hpp"

// Statements about growth: equal lengths of two systems, and the class of a growth function.
//
// The lengths of both systems obey linear recurrences, so as many equal terms as both have letters together prove equality for all
// n. The class is read off the graph of letters: a letter that derives itself twice means exponential growth, otherwise the longest chain of cycles gives
// the degree.

namespace algae::verify {

namespace {

void must_be_d0l(const Obligation& task) {
    for (std::size_t i = 0; i < task.statement.systems.size(); ++i)
        if (!is_d0l(task.system(i))) task.refuse("a system is not D0L");
}

}  // namespace

/// The lengths of both systems obey linear recurrences of as many terms as they have letters, so their
/// difference obeys one of as many as both have together.
void check_equal_terms(const Obligation& task) {
    must_be_d0l(task);
    Lengths one(task.system(0)), other(task.system(1));
    const std::size_t terms = one.letters() + other.letters();
    for (std::size_t n = 0; n < terms; ++n) {
        task.budget.check();
        if (one.length() != other.length())
            task.refuse("generation " + std::to_string(n) + " differs in length");
        one.next();
        other.next();
    }
}

void check_other_length(const Obligation& task) {
    must_be_d0l(task);
    check_lengths_differ(task);
}

namespace {

/// Which letters can be reached from which, by one step or more.
class LetterGraph {
public:
    explicit LetterGraph(const System& system)
        : letters_(accessible_letters(system, system.axiom)), table_(system.tables.front()) {
        for (const Symbol a : letters_) reach(a);
    }

    /// A letter that becomes a word with itself in it twice or more.
    bool doubles() const {
        return std::any_of(letters_.begin(), letters_.end(), [&](Symbol a) {
            const Word& image = table_[a].front();
            return std::count_if(image.begin(), image.end(), [&](Symbol b) {
                       return reached_.at(b).contains(a) || b == a;
                   }) > 1;
        });
    }
    /// The most cycles one after the other on a way through the letters, where no letter doubles.
    std::size_t longest_chain() const {
        std::size_t longest = 0;
        std::map<Symbol, std::size_t> found;
        for (const Symbol a : letters_) longest = std::max(longest, chain(a, found));
        return longest;
    }

private:
    void reach(Symbol from) {
        auto& reached = reached_[from];
        std::vector<Symbol> open{from};
        while (!open.empty()) {
            const Symbol a = open.back();
            open.pop_back();
            for (const Symbol b : table_[a].front())
                if (reached.insert(b).second) open.push_back(b);
        }
    }

    /// The most cycles beginning with that of a letter, or after the letter if it is on none.
    std::size_t chain(Symbol a, std::map<Symbol, std::size_t>& found) const {
        if (const auto known = found.find(a); known != found.end()) return known->second;
        const auto& reached = reached_.at(a);
        std::size_t longest = 0;
        for (const Symbol b : reached)
            if (!reached_.at(b).contains(a)) longest = std::max(longest, chain(b, found));
        return found[a] = longest + (reached.contains(a) ? 1 : 0);
    }

    std::vector<Symbol> letters_;
    const System::Successors& table_;
    std::map<Symbol, std::set<Symbol>> reached_;
};

}  // namespace

Growth growth_of(const System& system) {
    const LetterGraph graph(system);
    if (graph.doubles()) return {"exponential", 0};
    const std::size_t cycles = graph.longest_chain();
    if (cycles == 0) return {"zero", 0};
    return {cycles == 1 ? "bounded" : "polynomial", cycles - 1};
}

void check_growth_class(const Obligation& task) {
    must_be_d0l(task);
    const Statement& statement = task.statement;
    const Growth found = growth_of(task.system());
    const bool is =
        found.name == statement.family && (!statement.size || *statement.size == found.degree);
    if (is != task.holds)
        task.refuse(
            "the growth is " + found.name +
            (found.name == "polynomial" ? " of degree " + std::to_string(found.degree) : ""));
}

// Lengths that never fall: no accessible letter is erased. That they always rise is checked on the sets of letters that
// occur together, until a set comes again.

void check_rises(const Obligation& task) {
    must_be_d0l(task);
    const System& system = task.system();
    const System::Successors& table = system.tables[0];
    for (const Symbol a : accessible_letters(system, system.axiom))
        if (table[a][0].empty()) task.refuse("a letter is erased");
    if (!task.statement.strictly) return;
    std::set<std::set<Symbol>> seen;
    std::set<Symbol> now(system.axiom.begin(), system.axiom.end());
    while (seen.insert(now).second) {
        task.budget.check();
        bool rises = false;
        std::set<Symbol> next;
        for (const Symbol a : now) {
            rises = rises || table[a][0].size() > 1;
            next.insert(table[a][0].begin(), table[a][0].end());
        }
        if (!rises)
            task.refuse("generation " + std::to_string(seen.size() - 1) +
                        " is as long as the next one");
        now = std::move(next);
    }
}

// Or: they do not fall up to a generation that has no letter more often than the next one. What one word has
// more often than another, its descendants have more often too, so it is for all generations that follow.
void check_rises_by_letters(const Obligation& task) {
    must_be_d0l(task);
    const System::Successors& table = task.system().tables[0];
    const std::uint64_t last = task.proof.at("generation").number();
    if (last > 10'000)
        throw BoundReached(Bound::method, "more than 10,000 generations are not compared");
    std::map<Symbol, Integer> now;
    for (const Symbol a : task.system().axiom) now[a] = now[a] + 1;
    const auto length = [](const std::map<Symbol, Integer>& letters) {
        Integer all;
        for (const auto& [letter, times] : letters) all += times;
        return all;
    };
    for (std::uint64_t n = 0;; ++n) {
        task.budget.check();
        std::map<Symbol, Integer> next;
        for (const auto& [letter, times] : now)
            for (const Symbol b : table[letter][0]) next[b] = next[b] + times;
        if (length(next) < length(now) || (task.statement.strictly && length(next) == length(now)))
            task.refuse("after generation " + std::to_string(n) + " the length does not rise");
        if (n < last) {
            now = std::move(next);
            continue;
        }
        const std::set<Symbol> lasting = lasting_letters(table);
        bool one_lasts = !task.statement.strictly;
        for (const auto& [letter, times] : now)
            if (next[letter] < times) task.refuse("a letter occurs less often in the next word");
        for (const auto& [letter, times] : next)
            one_lasts = one_lasts || (times > now[letter] && lasting.contains(letter));
        if (!one_lasts) task.refuse("no lasting letter occurs more often in the next word");
        return;
    }
}

void check_falls(const Obligation& task) {
    must_be_d0l(task);
    const Integer generation = task.proof.at("generation").integer();
    const Integer before = length_of_generation(task.system(), generation, task.budget);
    const Integer after = length_of_generation(task.system(), generation + 1, task.budget);
    if (after > before || (after == before && !task.statement.strictly))
        task.refuse("the next generation is not shorter");
}

}  // namespace algae::verify
