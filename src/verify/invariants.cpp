#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <vector>

#include "exact/exact.hpp"
#include "verify/detail/checking.hpp"
#include "verify/detail/languages.hpp"
#include "verify/verify.hpp"
#include "watch/watch.hpp"

// Systems with context: automata that accept all words of a system, and measures by which its language is infinite.
//
// An automaton is closed under the steps of a system if whatever a word that it accepts becomes is accepted too. A word is read from
// left to right by it; what each letter becomes depends on letters on its left, which are remembered, and letters on its right, which
// are guessed and must come true; what they become is read by the automaton again. These four things are a state, of which there are
// finitely many, so all words are gone through at once. With the first word, by induction on the number of steps, all words are accepted.
//
// A measure is a weight for each move of the automaton. If every way through these states gives a larger sum to what is read the second
// time, each step makes the sum over a word larger, and no word comes twice. Shortest ways by Bellman and Ford.

namespace algae::verify {

namespace {

constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();

struct Automaton {
    struct Move {
        std::size_t to = 0;
        std::int64_t weight = 0;
    };
    std::vector<char> accepting;
    std::vector<std::map<Symbol, Move>> moves;

    std::size_t after(std::size_t state, Symbol a) const {
        if (state == nowhere) return nowhere;
        const auto move = moves[state].find(a);
        return move == moves[state].end() ? nowhere : move->second.to;
    }
    bool accepts(const Word& word) const {
        std::size_t state = 0;
        for (const Symbol a : word) state = after(state, a);
        return state != nowhere && accepting[state];
    }
};

Automaton read_automaton(const Field& field, const Reader& reader, bool weighted) {
    constexpr std::uint64_t most_states = 100'000;
    constexpr std::int64_t most_weight = 1'000'000;
    field.only({"accepting", "moves"});
    Automaton read{{0}, {{}}};
    const auto state = [&](const Field& number) {
        const std::uint64_t found = number.number();
        if (found >= most_states) number.fail("expected a state, a number below 100000");
        const auto place = static_cast<std::size_t>(found);
        if (place >= read.accepting.size()) {
            read.accepting.resize(place + 1, 0);
            read.moves.resize(place + 1);
        }
        return place;
    };
    for (const Field& each : field.at("accepting").list()) read.accepting[state(each)] = 1;
    for (const Field& each : field.at("moves").list()) {
        if (weighted)
            each.only({"from", "letter", "to", "weight"});
        else
            each.only({"from", "letter", "to"});
        const std::size_t from = state(each.at("from")), to = state(each.at("to"));
        std::int64_t weight = 0;
        if (weighted) {
            const Integer given = each.at("weight").integer(true);
            if (given > most_weight || given < -most_weight)
                each.at("weight").fail("expected a weight between -1000000 and 1000000");
            const bool is_negative = given < 0;
            const auto size = static_cast<std::int64_t>((is_negative ? -given : given).to_uint64());
            weight = is_negative ? -size : size;
        }
        const auto [place, is_new] =
            read.moves[from].emplace(reader.letter(each.at("letter")), Automaton::Move{to, weight});
        if (!is_new) each.fail("there is a move from this state by this letter already");
    }
    return read;
}

/// All steps of words that an automaton accepts, read by it before and after.
class Steps {
public:
    struct State {
        Word left, right;  // visible letters: those before, those guessed to come
        std::size_t read, written;
        bool operator==(const State&) const = default;
        bool operator<(const State& other) const {
            return std::tie(left, right, read, written) <
                   std::tie(other.left, other.right, other.read, other.written);
        }
    };
    struct Way {
        std::size_t from, to;
        std::int64_t gain;  // of the sum of weights
        Word successor;
    };

    Steps(const System& system, const Automaton& automaton, const Word& first, const Budget& budget)
        : system_(system), automaton_(automaton), budget_(budget) {
        letters_ = accessible_letters(system, first);
        for (const Symbol a : letters_)
            if (!system.ignored[a]) visible_.push_back(a);
        for (const System::Rule& rule : system.rules) {
            left_ = std::max(left_, rule.left.size());
            right_ = std::max(right_, rule.right.size());
        }
        add_beginnings({});
        beginnings = states.size();
        for (std::size_t i = 0; i < states.size(); ++i) follow(i);
    }

    std::vector<State> states;
    std::vector<Way> ways;
    std::size_t beginnings = 0;

    /// Whether a word that is accepted ends there.
    bool is_end(const State& state) const {
        return state.right.empty() && automaton_.accepting[state.read];
    }

private:
    void add_beginnings(const Word& guess) {
        number({{}, guess, 0, 0});
        if (guess.size() == right_) return;
        for (const Symbol a : visible_) {
            Word longer = guess;
            longer.push_back(a);
            add_beginnings(longer);
        }
    }

    std::size_t number(const State& state) {
        const auto [place, is_new] = numbers_.emplace(state, states.size());
        if (!is_new) return place->second;
        budget_.check();
        bytes_ += 300 + (state.left.size() + state.right.size()) * 2 * sizeof(Symbol);
        budget_.check_memory(bytes_, "the steps of words that the automaton accepts");
        states.push_back(state);
        return place->second;
    }

    void follow(std::size_t i) {
        const State at = states[i];
        for (const Symbol a : letters_) {
            const std::size_t read = automaton_.after(at.read, a);
            if (read == nowhere) continue;
            if (system_.ignored[a]) {
                become(i, a, at.left, at.right, read);
                continue;
            }
            if (right_ == 0) {
                become(i, a, at.left, {}, read);
                continue;
            }
            if (at.right.empty() || at.right.front() != a) continue;
            Word rest(at.right.begin() + 1, at.right.end());
            become(i, a, at.left, rest, read);
            if (at.right.size() < right_) continue;
            rest.push_back(0);
            for (const Symbol b : visible_) {
                rest.back() = b;
                become(i, a, at.left, rest, read);
            }
        }
    }

    void become(std::size_t from, Symbol a, const Word& left, const Word& right, std::size_t read) {
        Word around = left;
        around.push_back(a);
        State next{system_.ignored[a] ? left : around, right, read, 0};
        if (next.left.size() > left_) next.left.erase(next.left.begin());
        around.insert(around.end(), right.begin(), right.end());
        const State& at = states[from];
        const std::size_t before = at.written, source = at.read;
        for (const Word& successor : successors_at(system_, around, left.size())) {
            std::size_t written = before;
            std::int64_t gain = -automaton_.moves[source].at(a).weight;
            for (const Symbol b : successor) {
                if (written != nowhere) {
                    const auto move = automaton_.moves[written].find(b);
                    if (move != automaton_.moves[written].end()) gain += move->second.weight;
                }
                written = automaton_.after(written, b);
            }
            next.written = written;
            const std::size_t to = number(next);
            bytes_ += sizeof(Way) + 2 * successor.size() * sizeof(Symbol);
            ways.push_back({from, to, gain, successor});
        }
    }

    const System& system_;
    const Automaton& automaton_;
    const Budget& budget_;
    std::vector<Symbol> letters_, visible_;
    std::size_t left_ = 0, right_ = 0;
    std::map<State, std::size_t> numbers_;
    std::uint64_t bytes_ = 0;
};

/// Throws Flaw at the field if the automaton is not closed under steps or does not accept the first word.
Steps closed_steps(const System& system, const Automaton& automaton, const Word& first,
                   const Field& field, const Budget& budget) {
    if (!system.context) field.refuse("the system has no context");
    if (!automaton.accepts(first)) field.refuse("it does not accept the first word");
    Steps steps(system, automaton, first, budget);
    for (const Steps::State& state : steps.states)
        if (steps.is_end(state) &&
            (state.written == nowhere || !automaton.accepting[state.written]))
            field.refuse("a word that it accepts becomes one that it does not accept");
    return steps;
}

/// The automaton with a state from which nothing is accepted.
Derivatives::Automaton completed(const Automaton& automaton, std::size_t letters) {
    const std::size_t dead = automaton.accepting.size();
    Derivatives::Automaton whole{automaton.accepting, {}};
    whole.accepting.push_back(0);
    for (std::size_t s = 0; s <= dead; ++s) {
        auto& next = whole.next.emplace_back(letters, dead);
        if (s < dead)
            for (const auto& [a, move] : automaton.moves[s]) next[a] = move.to;
    }
    return whole;
}

}  // namespace

void check_invariant(const Obligation& task) {
    using Kind = Statement::Kind;
    const Statement& statement = task.statement;
    const bool is_word = statement.kind == Kind::member || statement.kind == Kind::derives;
    if (task.holds == is_word) task.wrong_kind();
    if (statement.from || statement.steps || statement.bound_steps)
        task.refuse("the statement is not about all words of the system");
    std::map<const System*, Derivatives::Automaton> known;
    for (const auto& [name, field] : task.proof.at("automata").object()) {
        const NamedSystem named = task.reader.named_system(field, name);
        const Automaton automaton = read_automaton(field, task.reader, false);
        closed_steps(*named.system, automaton, named.system->axiom, field, task.budget);
        known.emplace(named.system.get(), completed(automaton, task.alphabet().size()));
    }
    if (statement.kind == Kind::derives) {  // also words with letters that are no terminals
        const System& system = *statement.systems[0].system;
        const auto automaton = known.find(&system);
        if (automaton != known.end()) {
            std::size_t state = 0;
            for (const Symbol a : statement.word) state = automaton->second.next[state][a];
            if (automaton->second.accepting[state])
                task.refuse("the automata do not keep the word out");
            return;
        }
        if (std::count(system.terminal.begin(), system.terminal.end(), 0) > 0)
            task.refuse("the system has letters that are no terminals, and no automaton");
    }
    const Language left = statement.kind == Kind::derives
                              ? generated_by(statement.systems[0].system, statement.systems[0].name)
                              : task.language();
    Language right = words_of({});
    if (statement.kind == Kind::included) right = task.language(1);
    if (is_word) {
        Tree others;
        others.kind = Tree::Kind::complement;
        others.parts = {words_of({statement.word})};
        for (Symbol a = 0; a < task.alphabet().size(); ++a) others.letters.push_back(a);
        right = std::make_shared<const Tree>(std::move(others));
    }
    bool is_within = false;
    try {
        is_within = within_regular(left, right, task.alphabet(), task.budget, known);
    } catch (const Error& error) {
        throw BoundReached(Bound::method, error.what());
    }
    if (!is_within)
        task.refuse(is_word ? "the automata do not keep the word out"
                            : "with the automata in the place of the systems a word is outside");
}

void check_measure(const Obligation& task) {
    const Language& language = task.language();
    if (language->kind != Tree::Kind::generated || !language->system->context)
        task.refuse("the language is not given by a system with context");
    System chosen = *language->system;
    const auto words = task.proof.at("words").list();
    if (words.empty()) task.proof.at("words").refuse("a derivation must have a word");
    Word word = task.reader.word(words[0]);
    if (word != chosen.axiom) words[0].refuse("the derivation does not begin with the axiom");
    for (std::size_t i = 1; i < words.size(); ++i) {
        task.budget.check();
        const Word next = task.reader.word(words[i]);
        if (!may_give(chosen, word, next)) words[i].refuse("the word before does not give it");
        word = next;
    }
    for (const Field& each : task.proof.at("rules").list()) {
        each.only({"left", "letter", "right", "successor"});
        const System::Rule rule{
            task.reader.word(each.at("left")), task.reader.letter(each.at("letter")),
            task.reader.word(each.at("right")), task.reader.word(each.at("successor"))};
        if (!std::count(chosen.rules.begin(), chosen.rules.end(), rule))
            each.refuse("the system has no such rule, or another one was chosen before");
        std::erase_if(chosen.rules, [&](const System::Rule& other) {
            return other.letter == rule.letter && other.left == rule.left &&
                   other.right == rule.right && !(other == rule);
        });
    }
    const Field field = task.proof.at("automaton");
    const Automaton automaton = read_automaton(field, task.reader, true);
    const Steps steps = closed_steps(chosen, automaton, word, field, task.budget);
    const std::size_t count = steps.states.size();
    std::vector<char> ends(count, 0);
    for (std::size_t i = 0; i < count; ++i) ends[i] = steps.is_end(steps.states[i]);
    std::vector<char> finishes = ends;
    for (bool changed = true; changed;) {
        task.budget.check();
        changed = false;
        for (auto way = steps.ways.rbegin(); way != steps.ways.rend(); ++way)
            if (finishes[way->to] && !finishes[way->from]) {
                finishes[way->from] = 1;
                changed = true;
            }
    }
    // No way without a cycle is lower than this.
    std::int64_t lowest = 0;
    for (const Steps::Way& way : steps.ways) lowest = std::min(lowest, way.gain);
    lowest *= static_cast<std::int64_t>(count);
    constexpr std::int64_t far = std::numeric_limits<std::int64_t>::max() / 4;
    std::vector<std::int64_t> least(count, far);
    std::fill_n(least.begin(), steps.beginnings, 0);
    for (bool goes_on = true; goes_on;) {
        task.budget.check();
        bool changed = false;
        for (const Steps::Way& way : steps.ways)
            if (finishes[way.to] && least[way.from] != far &&
                least[way.from] + way.gain < least[way.to]) {
                least[way.to] = least[way.from] + way.gain;
                changed = true;
                if (least[way.to] < lowest)
                    field.refuse(
                        "the longer the words, the more a step may lower the sum of weights");
            }
        goes_on = changed;
    }
    for (std::size_t i = 0; i < count; ++i)
        if (ends[i] && least[i] <= 0)
            field.refuse("a step may leave the sum of weights as it is, or lower it");
}

/// Each word of the left language that is not in the base comes in one step from a shorter one: all words are read at once, by the
/// automaton of the language and by the set of all places in steps that can have made what was read. A place is a way and how much of
/// its successor was read, or a state between two letters; and whether a successor was longer than a letter.
void check_context_induction(const Obligation& task, const std::vector<Word>& base) {
    const System& system = *task.language(1)->system;
    Derivatives derivatives(task.alphabet(), task.budget);
    const auto whole = derivatives.automaton(derivatives.term(task.language()));
    Automaton left{whole.accepting, {}};
    for (const auto& next : whole.next) {
        auto& moves = left.moves.emplace_back();
        for (Symbol a = 0; a < next.size(); ++a) moves[a] = {next[a], 0};
    }
    Word letters = system.axiom;  // those of the left language too
    for (Symbol a = 0; a < task.alphabet().size(); ++a) letters.push_back(a);
    const Steps steps(system, left, letters, task.budget);
    std::vector<std::vector<std::size_t>> leaving(steps.states.size());
    for (std::size_t i = 0; i < steps.ways.size(); ++i) leaving[steps.ways[i].from].push_back(i);
    using Place = std::tuple<std::size_t, std::size_t, bool>;
    using Read =
        std::tuple<std::size_t, std::set<Place>, std::set<std::pair<std::size_t, std::size_t>>>;
    const auto entered = [&](std::size_t way, std::size_t read, bool longer) {
        return read == steps.ways[way].successor.size() ? Place{steps.ways[way].to, 0, longer}
                                                        : Place{way, read, longer};
    };
    std::set<Place> places;
    for (std::size_t i = 0; i < steps.beginnings; ++i) places.emplace(i, 0, false);
    std::set<std::pair<std::size_t, std::size_t>> words;
    for (std::size_t i = 0; i < base.size(); ++i) words.emplace(i, 0);
    std::set<Read> known{{0, places, words}};
    std::vector<const Read*> open{&*known.begin()};
    std::uint64_t bytes = 0;
    WorkCount places_seen("places");
    for (std::size_t i = 0; i < open.size(); ++i) {
        task.budget.check();
        places_seen.at(i);
        const auto& [state, at, begun] = *open[i];
        const bool is_made = std::any_of(at.begin(), at.end(), [&](const Place& place) {
            const auto& [number, read, longer] = place;
            return read == 0 && longer && steps.is_end(steps.states[number]);
        });
        const bool is_base = std::any_of(begun.begin(), begun.end(), [&](const auto& each) {
            return base[each.first].size() == each.second;
        });
        if (whole.accepting[state] && !is_made && !is_base)
            task.refuse("a word that is not in the base does not come from a shorter word");
        for (Symbol a = 0; a < task.alphabet().size(); ++a) {
            Read next{whole.next[state][a], {}, {}};
            for (const auto& [number, read, longer] : at) {
                if (read > 0) {
                    if (steps.ways[number].successor[read] == a)
                        std::get<1>(next).insert(entered(number, read + 1, longer));
                    continue;
                }
                for (const std::size_t way : leaving[number]) {
                    const Word& successor = steps.ways[way].successor;
                    if (!successor.empty() && successor.front() == a)
                        std::get<1>(next).insert(entered(way, 1, longer || successor.size() > 1));
                }
            }
            for (const auto& [word, read] : begun)
                if (read < base[word].size() && base[word][read] == a)
                    std::get<2>(next).emplace(word, read + 1);
            const auto [place, is_new] = known.insert(std::move(next));
            if (!is_new) continue;
            bytes += 200 + 80 * (std::get<1>(*place).size() + std::get<2>(*place).size());
            task.budget.check_memory(bytes, "the words that are read and how they are made");
            open.push_back(&*place);
        }
    }
}

}  // namespace algae::verify
