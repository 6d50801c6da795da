#include "language/tables_words.hpp"

#include <boost/container_hash/hash.hpp>

#include "base/error.hpp"
#include "language/finiteness.hpp"
#include "language/regular_images.hpp"
#include "language/regular_words.hpp"
#include "language/tables_finishing.hpp"
#include "language/tables_finiteness.hpp"
#include "language/tables_membership.hpp"
#include "language/tables_walk.hpp"

namespace algae {

namespace {

std::uint64_t bytes_of(const Dfa& automaton) {
    return sizeof(Dfa) + automaton.states() + automaton.transitions.size() * sizeof(std::size_t);
}

/// The families of languages of the walk; the words that the axiom derives by them are gathered.
class Families {
public:
    /// By symbol what the letters derive, of the accessible ones; which finish is known by the set.
    struct State {
        std::size_t set = 0;
        std::vector<RegularLanguage> languages;
        bool operator==(const State&) const = default;
    };

    Families(const ET0L& system, const FinishingSets& sets, const Budget& budget)
        : system_(&system), sets_(&sets), budget_(&budget), axiom_(finite_set({system.axiom})) {}

    const RegularLanguage& words() const { return words_; }

    State first() const {
        State state{0, std::vector<RegularLanguage>(system_->terminal.size())};
        for (Symbol a = 0; a < system_->terminal.size(); ++a)
            if (sets_->accessible[0][a]) state.languages[a] = finite_set({Word{a}});
        return state;
    }

    State next(const State& state, std::uint32_t table) const {
        State following{sets_->before[state.set][table],
                        std::vector<RegularLanguage>(state.languages.size())};
        for (Symbol a = 0; a < state.languages.size(); ++a) {
            if (!sets_->accessible[following.set][a]) continue;
            std::vector<Word> successors;
            for (const Word& successor : system_->tables[table][a])
                if (sets_->finishes(state.set, successor)) successors.push_back(successor);
            following.languages[a] = image(finite_set(successors), state.languages, *budget_);
        }
        return following;
    }

    bool stops(const State& state) {
        if (sets_->finishes(state.set, system_->axiom))
            words_ = united(words_, image(axiom_, state.languages, *budget_), *budget_);
        return false;
    }

    std::uint64_t bytes(const State& state) const {
        std::uint64_t bytes = 0;
        for (const RegularLanguage& language : state.languages)
            bytes += bytes_of(language.automaton());
        return bytes;
    }

    std::size_t hash(const State& state) const {
        std::size_t seed = state.set;
        for (const RegularLanguage& language : state.languages) {
            const Dfa& automaton = language.automaton();
            boost::hash_range(seed, automaton.accepting.begin(), automaton.accepting.end());
            boost::hash_range(seed, automaton.transitions.begin(), automaton.transitions.end());
        }
        return seed;
    }

private:
    const ET0L* system_;
    const FinishingSets* sets_;
    const Budget* budget_;
    RegularLanguage axiom_, words_;
};

/// By the components of letters where that is enough.
bool has_finite_language(const ET0L& system, const Budget& budget) {
    if (system.tables.size() == 1 && has_only_terminals(system))
        return finiteness(without_terminals(system)).finite;
    return finiteness(system, budget).finite;
}

}  // namespace

RegularLanguage finite_words(const ET0L& system, const Budget& budget) {
    if (!has_finite_language(system, budget)) throw Error("the language is infinite");
    const FinishingSets sets = finishing_sets(system, budget);
    Families families(system, sets, budget);
    walk_of_tables(families, system.tables.size(), budget);
    return families.words();
}

Integer number_of_words(const ET0L& system, const Budget& budget) {
    if (system.tables.size() == 1 && has_only_terminals(system))
        return number_of_words(without_terminals(system), budget);
    return *number_of_words(finite_words(system, budget));
}

}  // namespace algae
