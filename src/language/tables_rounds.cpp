#include "language/tables_rounds.hpp"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/strong_components.hpp>
#include <set>
#include <unordered_map>
#include <utility>

namespace algae {

namespace {

using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS>;

std::vector<std::size_t> components_of(const Graph& graph) {
    std::vector<std::size_t> component(boost::num_vertices(graph));
    boost::strong_components(graph, boost::make_iterator_property_map(
                                        component.begin(), boost::get(boost::vertex_index, graph)));
    return component;
}

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
        Graph graph(sets_->sets.size() * letters_);
        std::vector<std::vector<std::size_t>> before(boost::num_vertices(graph));
        for (std::size_t set = 0; set < sets_->sets.size(); ++set)
            for (std::size_t i = 0; i < moves_[set].size(); ++i)
                for (Symbol a = 0; a < letters_; ++a)
                    for (const Move& move : moves_[set][i][a].single) {
                        const std::size_t to = stage(sets_->steps[set][i].to, move.letter);
                        boost::add_edge(stage(set, a), to, graph);
                        before[to].push_back(stage(set, a));
                    }
        component_ = components_of(graph);
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
        Graph graph;
        std::uint64_t bytes = 0;
        const auto numbered = [&](const Node& node) {
            const auto [at, is_new] = number.try_emplace(code(node), nodes.size());
            if (is_new) {
                nodes.push_back(node);
                boost::add_vertex(graph);
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
                boost::add_edge(i, numbered(next), graph);
                bytes += 16;
            });
            if (node.second == node.third)
                boost::add_edge(i, numbered({node.set, node.first, none(), node.third}), graph);
            budget_->check_memory(bytes, "the graph of letters that come together");
        }
        const std::vector<std::size_t> component = components_of(graph);
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

}  // namespace

std::optional<EndlessTables> first_round(const ET0L& system, const FinishingSets& sets,
                                         const Budget& budget) {
    return Rounds(system, sets, budget).first();
}

}  // namespace algae
