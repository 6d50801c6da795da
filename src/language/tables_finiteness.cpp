#include "language/language.hpp"

#include <algorithm>
#include <boost/container_hash/hash.hpp>
#include <map>
#include <set>
#include <unordered_map>

#include "exact/exact.hpp"
#include "language/detail/letters.hpp"
#include "language/detail/regular.hpp"

// Finiteness of the language of an ET0L system, decided with a proof that can be checked by itself.
//
// The finishing set of a sequence v of tables are the letters that derive a word of terminals by v; let all
// letters of all words below be in the finishing sets of the tables still to come, as they are in derivations
// of words of L(G).
//
// Theorem. L(G) is infinite if and only if there are sequences x, u, v of tables such that v and uv have the
// same finishing set F, and letters a, b such that the axiom derives by x a word with a; a derives by u a word
// with a and b at two places; b derives by u a word with b, and by v a word of terminals that is not empty.
// Proof. If there are, x u^n v derives words of n letters and more. Conversely, call a letter of a derivation
// useful if it leaves some letter in the last word. A step makes words longer by at most a constant factor, so
// in derivations of longer and longer words there are lines of useful letters, from the axiom on and each in
// the successor of the one before, with more and more branches: steps in which the successor has another useful
// letter. For two branches at times i < j of a line consider the finishing sets at i and j, the letters of the
// line at i and j, a useful letter at j that comes of the other letter of branch i, and the relation of all (d,
// e) such that d derives by the tables between i and j a word with e. There are finitely many such things, so
// by Ramsey's theorem there are as many branches as wanted of which any two have the same: a set F, a letter a,
// a letter c, a relation E. Three of them show that E is transitive; (a, a) is in E. The useful c at the second
// branch is the first of useful letters at the second, third, ... branch, each in relation E to the next; some
// b is there twice, so (b, b) is in E, and so is (c, b), or c = b and that again. Let u be the tables from the
// first branch to the third: a derives a and c up to the second, and these derive a and b up to the third; b
// derives b by (b, b) in E. Let v be the tables from a branch on where b is useful, and x those up to the
// first. QED
//
// So the search is for a way from (F, a, b) to (F, a, b, b) in the graph of finishing sets with two letters
// while the first two courses are one, with three afterwards. There is one if and only if such a pair is in one
// strongly connected component once all edges back from (F, a, b, b) to
// (F, a, b) are added: ways joined by them join up without them.
//
// The words of a finite L(G) are found as an automaton. What an accessible letter derives by a sequence of
// tables, while all letters finish, stands between other words in words of L(G), so these are finitely many
// finite languages: the families of all sequences are found from those without their first table, until nothing
// new comes.

namespace algae {

namespace {

/// The letters, of these, with a successor of which all letters are in the set.
std::vector<char> letters_before(const FinishingSets& found, std::size_t set, const Table& table,
                                 const std::vector<Symbol>& letters) {
    std::vector<char> before(table.size(), 0);
    for (const Symbol a : letters)
        before[a] = std::any_of(table[a].begin(), table[a].end(), [&](const Word& successor) {
            return found.finishes(set, successor);
        });
    return before;
}

void mark_accessible(const ET0L& system, FinishingSets& found) {
    found.accessible.assign(found.sets.size(), std::vector<char>(system.terminal.size(), 0));
    std::vector<std::pair<std::size_t, Symbol>> queue;
    const auto see = [&](std::size_t set, const Word& word) {
        if (!found.finishes(set, word)) return;
        for (const Symbol a : word)
            if (!found.accessible[set][a]) {
                found.accessible[set][a] = 1;
                queue.emplace_back(set, a);
            }
    };
    for (std::size_t set = 0; set < found.sets.size(); ++set) see(set, system.axiom);
    for (std::size_t i = 0; i < queue.size(); ++i) {
        const auto [set, a] = queue[i];
        for (const auto& [table, to] : found.steps[set])
            for (const Word& successor : system.tables[table][a]) see(to, successor);
    }
}

}  // namespace

bool FinishingSets::finishes(std::size_t set, const Word& word) const {
    return std::all_of(word.begin(), word.end(), [&](Symbol a) { return sets[set][a] != 0; });
}

FinishingSets finishing_sets(const ET0L& system, const Budget& budget) {
    const std::vector<Symbol> letters = accessible_letters(system);
    FinishingSets found{{std::vector<char>(system.terminal.size(), 0)}, {}, {}, {}};
    for (const Symbol a : letters) found.sets[0][a] = system.terminal[a];
    std::map<std::vector<char>, std::size_t> known{{found.sets[0], 0}};
    const std::uint64_t bytes =
        3 * system.terminal.size() + 2 * system.tables.size() * sizeof(FinishingSets::Step) + 256;
    for (std::size_t set = 0; set < found.sets.size(); ++set) {
        found.before.emplace_back();
        for (const Table& table : system.tables) {
            budget.check();
            std::vector<char> before = letters_before(found, set, table, letters);
            const auto [at, is_new] = known.try_emplace(before, found.sets.size());
            if (is_new) found.sets.push_back(std::move(before));
            found.before[set].push_back(at->second);
        }
        budget.check_memory(found.sets.size() * bytes,
                            "the sets of letters that can become terminals");
    }
    found.steps.resize(found.sets.size());
    for (std::size_t set = 0; set < found.sets.size(); ++set)
        for (std::uint32_t table = 0; table < system.tables.size(); ++table)
            found.steps[found.before[set][table]].push_back({table, set});
    mark_accessible(system, found);
    return found;
}

namespace {

/// A letter of an allowed successor, and how it came.
struct Move {
    TableUse use;
    Symbol letter;
};

/// What a letter becomes in one step from one set to another: each letter once, and each pair of
/// letters at two places of one successor once.
struct Moves {
    std::vector<Move> single;
    std::vector<std::pair<Move, Move>> pairs;
};

Moves moves_of(const ET0L& system, const FinishingSets& sets, const FinishingSets::Step& step,
               Symbol a) {
    Moves moves;
    std::set<Symbol> seen;
    std::set<std::pair<Symbol, Symbol>> seen_pairs;
    const auto& choices = system.tables[step.table][a];
    for (std::uint32_t choice = 0; choice < choices.size(); ++choice) {
        const Word& word = choices[choice];
        if (!sets.finishes(step.to, word)) continue;
        // The first two places of a letter are enough for every pair.
        std::vector<Move> places;
        std::unordered_map<Symbol, int> times;
        for (std::uint32_t place = 0; place < word.size(); ++place)
            if (++times[word[place]] <= 2)
                places.push_back({{step.table, a, choice, place}, word[place]});
        for (const Move& one : places) {
            if (seen.insert(one.letter).second) moves.single.push_back(one);
            for (const Move& other : places)
                if (one.use.place != other.use.place &&
                    seen_pairs.emplace(one.letter, other.letter).second)
                    moves.pairs.emplace_back(one, other);
        }
    }
    return moves;
}

class Rounds {
public:
    Rounds(const ET0L& system, const FinishingSets& sets, const Budget& budget)
        : system_(&system),
          sets_(&sets),
          budget_(&budget),
          letters_(system.terminal.size()),
          moves_(sets.sets.size()) {
        for (std::size_t set = 0; set < sets.sets.size(); ++set)
            for (const auto& step : sets.steps[set]) {
                budget.check();
                auto& of_letters = moves_[set].emplace_back(letters_);
                for (Symbol a = 0; a < letters_; ++a)
                    if (sets.accessible[set][a]) of_letters[a] = moves_of(system, sets, step, a);
            }
        find_stages();
    }

    std::optional<EndlessTables> first() const {
        std::optional<EndlessTables> shortest;
        for (const Node& node : found_nodes()) {
            EndlessTables endless{node.first, node.third, {}, {}, {}, {}, {}};
            courses(node, endless);
            endless.before = course_from_axiom(node.set, endless.again);
            endless.after = course_to_terminal(node.set, endless.other);
            if (!shortest || steps(endless) < steps(*shortest)) shortest = std::move(endless);
        }
        return shortest;
    }

private:
    /// A set and the letters of the courses `round`, `beside` and `kept`; `second` is none while
    /// the first two are one.
    struct Node {
        std::size_t set;
        Symbol first, second, third;
    };

    /// Of how many a short one is chosen.
    static constexpr std::size_t most_rounds = 16;

    static std::size_t steps(const EndlessTables& endless) {
        return endless.before.size() + 3 * endless.round.size() + endless.after.size();
    }

    Symbol none() const { return static_cast<Symbol>(letters_); }
    std::size_t stage(std::size_t set, Symbol a) const { return set * letters_ + a; }
    std::uint64_t code(const Node& node) const {
        return ((node.set * letters_ + node.first) * (letters_ + 1) + node.second) * letters_ +
               node.third;
    }

    void find_stages() {
        std::vector<std::vector<std::size_t>> before(sets_->sets.size() * letters_);
        for (std::size_t set = 0; set < sets_->sets.size(); ++set)
            for (std::size_t i = 0; i < moves_[set].size(); ++i)
                for (Symbol a = 0; a < letters_; ++a)
                    for (const Move& move : moves_[set][i][a].single) {
                        const std::size_t to = stage(sets_->steps[set][i].to, move.letter);
                        before[to].push_back(stage(set, a));
                    }
        component_ = strong_components(before);  // the same as along the steps
        returns_.assign(before.size(), 0);
        lasts_.assign(before.size(), 0);
        for (std::size_t to = 0; to < before.size(); ++to)
            for (const std::size_t from : before[to])
                if (component_[from] == component_[to]) returns_[from] = 1;
        std::vector<std::size_t> queue;
        const auto see = [&](std::size_t at) {
            if (!lasts_[at]) queue.push_back(at);
            lasts_[at] = 1;
        };
        for (Symbol a = 0; a < letters_; ++a)
            if (sets_->sets[0][a]) see(stage(0, a));
        for (std::size_t i = 0; i < queue.size(); ++i)
            for (const std::size_t from : before[queue[i]]) see(from);
    }

    /// Calls visit(node, moves of the three courses) for every node that is one step away; the
    /// first and the third letter stay in their components.
    template <class Visit>
    void each_next(const Node& node, Visit visit) const {
        for (std::size_t i = 0; i < moves_[node.set].size(); ++i) {
            const std::size_t to = sets_->steps[node.set][i].to;
            const auto& moves = moves_[node.set][i];
            const auto stays = [&](Symbol from, const Move& move) {
                return component_[stage(node.set, from)] == component_[stage(to, move.letter)];
            };
            const auto with_third = [&](const Move& first, const Move* second) {
                for (const Move& third : moves[node.third].single)
                    if (stays(node.third, third))
                        visit(
                            Node{to, first.letter, second ? second->letter : none(), third.letter},
                            first, second, third);
            };
            if (node.second == none()) {
                for (const Move& first : moves[node.first].single)
                    if (stays(node.first, first)) with_third(first, nullptr);
                for (const auto& [first, second] : moves[node.first].pairs)
                    if (stays(node.first, first) && lasts_[stage(to, second.letter)])
                        with_third(first, &second);
            } else {
                for (const Move& first : moves[node.first].single)
                    if (stays(node.first, first))
                        for (const Move& second : moves[node.second].single)
                            if (lasts_[stage(to, second.letter)]) with_third(first, &second);
            }
        }
    }

    /// Some (F, a, b) from which (F, a, b, b) can be reached; none if there are none.
    std::vector<Node> found_nodes() const {
        std::vector<Node> nodes;
        std::unordered_map<std::uint64_t, std::size_t> number;
        std::vector<std::vector<std::size_t>> successors;
        std::uint64_t bytes = 0;
        const auto numbered = [&](const Node& node) {
            const auto [at, is_new] = number.try_emplace(code(node), nodes.size());
            if (is_new) {
                nodes.push_back(node);
                successors.emplace_back();
                bytes += 160;
            }
            return at->second;
        };
        for (std::size_t set = 0; set < sets_->sets.size(); ++set)
            for (Symbol a = 0; a < letters_; ++a)
                for (Symbol b = 0; b < letters_; ++b)
                    if (sets_->accessible[set][a] && sets_->accessible[set][b] &&
                        returns_[stage(set, a)] && returns_[stage(set, b)] && lasts_[stage(set, b)])
                        numbered({set, a, none(), b});
        const std::size_t begins = nodes.size();
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            budget_->check();
            const Node node = nodes[i];
            each_next(node, [&](const Node& next, const Move&, const Move*, const Move&) {
                const std::size_t to = numbered(next);
                successors[i].push_back(to);
                bytes += 16;
            });
            if (node.second == node.third) {
                const std::size_t to = numbered({node.set, node.first, none(), node.third});
                successors[i].push_back(to);
            }
            budget_->check_memory(bytes, "the graph of letters that come together");
        }
        const std::vector<std::size_t> component = strong_components(successors);
        std::vector<Node> found;
        for (std::size_t i = 0; i < begins && found.size() < most_rounds; ++i) {
            const auto end =
                number.find(code({nodes[i].set, nodes[i].first, nodes[i].third, nodes[i].third}));
            if (end != number.end() && component[end->second] == component[i])
                found.push_back(nodes[i]);
        }
        return found;
    }

    /// The three courses from (F, a, b) to (F, a, b, b), by breadth first search.
    void courses(const Node& from, EndlessTables& endless) const {
        struct Found {
            Node node;
            std::size_t before;
            TableUse round, beside, kept;
        };
        const std::uint64_t goal = code({from.set, from.first, from.third, from.third});
        std::unordered_map<std::uint64_t, std::size_t> number{{code(from), 0}};
        std::vector<Found> found{{from, 0, {}, {}, {}}};
        for (std::size_t i = 0; !number.contains(goal); ++i) {
            budget_->check();
            const Node node = found[i].node;
            each_next(node, [&](const Node& next, const Move& first, const Move* second,
                                const Move& third) {
                if (number.try_emplace(code(next), found.size()).second)
                    found.push_back(
                        {next, i, first.use, second ? second->use : first.use, third.use});
            });
        }
        for (std::size_t at = number[goal]; at != 0; at = found[at].before) {
            endless.round.push_back(found[at].round);
            endless.beside.push_back(found[at].beside);
            endless.kept.push_back(found[at].kept);
        }
        for (Course* course : {&endless.round, &endless.beside, &endless.kept})
            std::reverse(course->begin(), course->end());
    }

    /// A shortest course from one of the stages to one that is wanted.
    template <class Wanted>
    Course shortest(const std::vector<std::pair<std::size_t, Symbol>>& from, Wanted wanted) const {
        struct Found {
            std::size_t set;
            Symbol letter;
            std::size_t before;
            TableUse use;
        };
        constexpr std::size_t nothing = static_cast<std::size_t>(-1);
        std::vector<Found> found;
        std::vector<char> seen(component_.size(), 0);
        const auto see = [&](const Found& next) {
            if (!seen[stage(next.set, next.letter)]) found.push_back(next);
            seen[stage(next.set, next.letter)] = 1;
        };
        for (const auto& [set, a] : from) see({set, a, nothing, {}});
        std::size_t at = 0;
        for (; !wanted(found[at].set, found[at].letter); ++at)
            for (std::size_t i = 0; i < moves_[found[at].set].size(); ++i) {
                const std::size_t set = found[at].set;
                for (const Move& move : moves_[set][i][found[at].letter].single)
                    see({sets_->steps[set][i].to, move.letter, at, move.use});
            }
        Course course;
        for (; found[at].before != nothing; at = found[at].before) course.push_back(found[at].use);
        std::reverse(course.begin(), course.end());
        return course;
    }

    Course course_from_axiom(std::size_t to, Symbol letter) const {
        std::vector<std::pair<std::size_t, Symbol>> begins;
        for (std::size_t set = 0; set < sets_->sets.size(); ++set)
            if (sets_->finishes(set, system_->axiom))
                for (const Symbol a : system_->axiom) begins.emplace_back(set, a);
        return shortest(begins,
                        [&](std::size_t set, Symbol a) { return set == to && a == letter; });
    }

    Course course_to_terminal(std::size_t from, Symbol letter) const {
        return shortest({{from, letter}}, [](std::size_t set, Symbol) { return set == 0; });
    }

    const ET0L* system_;
    const FinishingSets* sets_;
    const Budget* budget_;
    std::size_t letters_;
    std::vector<std::vector<std::vector<Moves>>> moves_;  // by set, number of its step, letter
    std::vector<std::size_t> component_;                  // by stage
    std::vector<char> returns_, lasts_;  // by stage: on a cycle; can leave a terminal
};

/// What makes L(G) infinite, by the theorem above, if it is there; of the first few the one with the shortest
/// courses. Throws BoundReached if the graph takes more than budget.memory.
std::optional<EndlessTables> first_round(const ET0L& system, const FinishingSets& sets,
                                         const Budget& budget) {
    return Rounds(system, sets, budget).first();
}

using Letters = std::vector<char>;

bool all_in(const Letters& set, const Word& word) {
    return std::all_of(word.begin(), word.end(), [&](Symbol a) { return set[a] != 0; });
}

/// The accessible letters that finish before each step of the course, and last those after it.
std::vector<Letters> finishing(const ET0L& system, const Course& course, const Letters& last) {
    const std::vector<Symbol> letters = accessible_letters(system);
    std::vector<Letters> sets(course.size() + 1, Letters(last.size(), 0));
    for (const Symbol a : letters) sets.back()[a] = last[a];
    for (std::size_t t = course.size(); t-- > 0;)
        for (const Symbol a : letters) {
            const auto& choices = system.tables[course[t].table][a];
            sets[t][a] = std::any_of(choices.begin(), choices.end(),
                                     [&](const Word& word) { return all_in(sets[t + 1], word); });
        }
    return sets;
}

/// Whether the course goes from one letter to the other, by rules that are there.
bool goes(const ET0L& system, const Course& course, Symbol from, Symbol to) {
    for (const TableUse& use : course) {
        if (use.letter != from || use.table >= system.tables.size()) return false;
        const auto& choices = system.tables[use.table][use.letter];
        if (use.choice >= choices.size() || use.place >= choices[use.choice].size()) return false;
        from = choices[use.choice][use.place];
    }
    return from == to;
}

/// Whether all letters that come of the steps finish.
bool stays(const ET0L& system, const Course& course, const std::vector<Letters>& sets) {
    for (std::size_t t = 0; t < course.size(); ++t)
        if (!all_in(sets[t + 1],
                    system.tables[course[t].table][course[t].letter][course[t].choice]))
            return false;
    return true;
}

bool same_tables(const Course& left, const Course& right) {
    return std::equal(
        left.begin(), left.end(), right.begin(), right.end(),
        [](const TableUse& one, const TableUse& other) { return one.table == other.table; });
}

/// Whether two courses are the same up to a step in which the same successor has both at different
/// places.
bool fork(const Course& left, const Course& right) {
    const auto [one, other] = std::mismatch(left.begin(), left.end(), right.begin(), right.end());
    return one != left.end() && other != right.end() && one->letter == other->letter &&
           one->table == other->table && one->choice == other->choice && one->place != other->place;
}

}  // namespace

bool is_proof(const ET0L& system, const EndlessTables& proof) {
    const std::size_t letters = system.terminal.size();
    if (proof.again >= letters || proof.other >= letters) return false;
    Symbol begin = proof.again, end = proof.other;
    if (!proof.before.empty()) begin = proof.before.front().letter;
    if (!goes(system, proof.before, begin, proof.again) ||
        !goes(system, proof.round, proof.again, proof.again) ||
        !goes(system, proof.beside, proof.again, proof.other) ||
        !goes(system, proof.kept, proof.other, proof.other))
        return false;
    if (!proof.after.empty()) {
        const TableUse& last = proof.after.back();
        if (last.table >= system.tables.size() || last.letter >= letters) return false;
        const auto& choices = system.tables[last.table][last.letter];
        if (last.choice >= choices.size() || last.place >= choices[last.choice].size())
            return false;
        end = choices[last.choice][last.place];
    }
    if (!goes(system, proof.after, proof.other, end) || !system.terminal[end]) return false;
    if (!same_tables(proof.round, proof.beside) || !same_tables(proof.round, proof.kept) ||
        !fork(proof.round, proof.beside))
        return false;
    const auto after = finishing(system, proof.after, system.terminal);
    const auto round = finishing(system, proof.round, after.front());
    const auto before = finishing(system, proof.before, after.front());
    for (std::size_t a = 0; a < letters; ++a)
        if (after.front()[a] && !round.front()[a]) return false;
    return std::count(system.axiom.begin(), system.axiom.end(), begin) > 0 &&
           all_in(before.front(), system.axiom) && stays(system, proof.before, before) &&
           stays(system, proof.round, round) && stays(system, proof.beside, round) &&
           stays(system, proof.kept, round) && stays(system, proof.after, after) &&
           after.front()[proof.other];
}

TablesFiniteness finiteness(const ET0L& system, const Budget& budget) {
    const FinishingSets sets = finishing_sets(system, budget);
    std::optional<EndlessTables> endless = first_round(system, sets, budget);
    return {!endless, std::move(endless)};
}

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
