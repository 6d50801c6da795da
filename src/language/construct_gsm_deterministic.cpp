#include "language/construct_gsm_deterministic.hpp"

#include <array>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "base/error.hpp"
#include "language/construct_draft.hpp"

namespace algae {

namespace {

constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();

/// Where each state is led by what each letter derives: at letter * states + state.
using Functions = std::vector<std::size_t>;

class DeterministicTriples {
public:
    DeterministicTriples(const ET0L& system, const Gsm& machine, const Budget& budget)
        : system_(&system),
          machine_(&machine),
          budget_(&budget),
          letters_(accessible_letters(system)),
          draft_(*system.alphabet, 0),
          start_(draft_.fresh("S")) {}

    ET0L result() {
        for (const Functions& after : all_functions())
            for (const Table& rules : system_->tables) {
                const std::size_t table = draft_.add_table();
                guesses_.push_back({&rules, &after});
                if (const std::size_t last = led(after, system_->axiom, machine_->initial);
                    last != nowhere && machine_->accepting[last])
                    draft_.add_rule(table, start_,
                                    between(after, system_->axiom, machine_->initial));
            }
        const std::size_t end = draft_.add_table();
        while (!open_.empty()) {
            const Triple triple = open_.back();
            open_.pop_back();
            add_rules(triple);
            if (const auto move = moves_.find({triple[0], triple[1]});
                move != moves_.end() && move->second->to == triple[2])
                draft_.add_rule(end, triples_.at(triple),
                                draft_.terminals(*system_->alphabet, move->second->output));
        }
        return draft_.system({start_}, "image");
    }

private:
    using Triple = std::array<std::size_t, 3>;  // state, letter, state

    /// What words of the letters do after the last tables, for any number of these.
    const std::set<Functions>& all_functions() {
        const std::size_t n = machine_->states();
        Functions last(system_->alphabet->size() * n, nowhere);
        for (const Gsm::Move& move : machine_->moves)
            if (system_->terminal.at(move.letter)) {
                last[move.letter * n + move.from] = move.to;
                moves_[{move.from, move.letter}] = &move;
            }
        functions_ = {last};
        std::vector<Functions> open{last};
        while (!open.empty()) {
            const Functions after = std::move(open.back());
            open.pop_back();
            for (const Table& rules : system_->tables) {
                budget_->check();
                Functions before(after.size(), nowhere);
                for (const Symbol a : letters_)
                    for (std::size_t state = 0; state < n; ++state)
                        before[a * n + state] = led(after, rules[a].front(), state);
                if (functions_.insert(before).second) open.push_back(std::move(before));
                budget_->check_memory(functions_.size() * after.size() * sizeof(std::size_t),
                                      "what letters do to states");
            }
        }
        return functions_;
    }

    std::size_t led(const Functions& functions, const Word& word, std::size_t state) const {
        for (const Symbol a : word) {
            if (state == nowhere) break;
            state = functions[a * machine_->states() + state];
        }
        return state;
    }

    /// The word with the states between its letters; it is known to lead somewhere.
    Word between(const Functions& functions, const Word& word, std::size_t state) {
        Word found;
        for (const Symbol a : word) {
            const std::size_t next = functions[a * machine_->states() + state];
            const Triple triple{state, a, next};
            const auto [place, fresh] = triples_.try_emplace(triple, 0);
            if (fresh) {
                place->second = draft_.fresh(system_->alphabet->name(a));
                open_.push_back(triple);
            }
            found.push_back(place->second);
            state = next;
        }
        return found;
    }

    void add_rules(const Triple& triple) {
        for (std::size_t t = 0; t < guesses_.size(); ++t) {
            const auto& [rules, after] = guesses_[t];
            const Word& successor = (*rules)[triple[1]].front();
            if (led(*after, successor, triple[0]) == triple[2])
                draft_.add_rule(t, triples_.at(triple), between(*after, successor, triple[0]));
        }
        draft_.check(*budget_);
    }

    const ET0L* system_;
    const Gsm* machine_;
    const Budget* budget_;
    std::vector<Symbol> letters_;
    Draft draft_;
    Symbol start_;
    std::set<Functions> functions_;
    std::vector<std::pair<const Table*, const Functions*>> guesses_;  // by table of the result
    std::map<std::pair<std::size_t, std::size_t>, const Gsm::Move*> moves_;
    std::map<Triple, Symbol> triples_;
    std::vector<Triple> open_;
};

}  // namespace

ET0L deterministic_gsm_image(const ET0L& system, const Gsm& machine, const Budget& budget) {
    if (!is_deterministic(system))
        throw Error("expected one successor of each letter in each table, found several");
    if (!is_deterministic(machine))
        throw Error("expected one move for each state and letter, found several");
    return DeterministicTriples(system, machine, budget).result();
}

}  // namespace algae
