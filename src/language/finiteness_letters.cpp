#include "language/finiteness_letters.hpp"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/strong_components.hpp>

#include "base/error.hpp"

namespace algae {

namespace {

/// Least fixed point: a letter does not last if no successor has a letter that lasts.
std::vector<char> lasting_letters(const OL& system) {
    std::vector<char> lasting(system.alphabet->size(), 0);
    for (const Symbol a : system.letters) lasting[a] = 1;
    for (bool changed = true; changed;) {
        changed = false;
        for (const Symbol a : system.letters) {
            if (!lasting[a]) continue;
            const auto& choices = system.successors[a];
            const bool stays = std::any_of(choices.begin(), choices.end(), [&](const Word& successor) {
                return std::any_of(successor.begin(), successor.end(), [&](Symbol b) { return lasting[b] != 0; });
            });
            if (!stays) {
                lasting[a] = 0;
                changed = true;
            }
        }
    }
    return lasting;
}

/// In round n those letters are found that can be gone after n steps and not before.
std::vector<std::optional<std::uint64_t>> shortest_lives(const OL& system) {
    std::vector<std::optional<std::uint64_t>> life(system.alphabet->size());
    for (std::uint64_t steps = 1;; ++steps) {
        std::vector<Symbol> found;
        for (const Symbol a : system.letters) {
            const auto& choices = system.successors[a];
            if (!life[a] && std::any_of(choices.begin(), choices.end(), [&](const Word& successor) {
                    return std::all_of(successor.begin(), successor.end(), [&](Symbol b) { return life[b].has_value(); });
                }))
                found.push_back(a);
        }
        if (found.empty()) return life;
        for (const Symbol a : found) life[a] = steps;
    }
}

std::vector<std::size_t> lasting_components(const OL& system, const std::vector<char>& lasting) {
    using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS>;
    Graph graph(system.alphabet->size());
    for (const Symbol a : system.letters)
        for (const Word& successor : system.successors[a])
            for (const Symbol b : successor)
                if (lasting[a] && lasting[b]) boost::add_edge(a, b, graph);
    std::vector<std::size_t> component(system.alphabet->size());
    boost::strong_components(graph, boost::make_iterator_property_map(component.begin(), boost::get(boost::vertex_index, graph)));
    for (std::size_t a = 0; a < component.size(); ++a) component[a] = lasting[a] ? component[a] + 1 : 0;
    return component;
}

std::optional<Pump> pump(const OL& system, const LetterFutures& futures, Symbol a, std::size_t choice) {
    const Word& successor = system.successors[a][choice];
    std::optional<std::size_t> again, other;
    for (std::size_t i = 0; i < successor.size(); ++i) {
        if (!futures.lasting[successor[i]]) continue;
        if (!again && futures.component[successor[i]] == futures.component[a])
            again = i;
        else if (!other)
            other = i;
    }
    if (!futures.lasting[a] || !again || !other) return std::nullopt;
    return Pump{a, choice, *again, *other};
}

}  // namespace

LetterFutures letter_futures(const OL& system) {
    LetterFutures futures{lasting_letters(system), shortest_lives(system), {}, {}};
    futures.component = lasting_components(system, futures.lasting);
    futures.growing.assign(system.alphabet->size(), 0);
    for (const Symbol a : system.letters)
        for (std::size_t choice = 0; choice < system.successors[a].size(); ++choice)
            if (pump(system, futures, a, choice)) futures.growing[a] = 1;
    for (bool changed = true; changed;) {
        changed = false;
        for (const Symbol a : system.letters)
            for (const Word& successor : system.successors[a])
                for (const Symbol b : successor)
                    if (futures.growing[b] && !futures.growing[a]) futures.growing[a] = changed = true;
    }
    return futures;
}

bool is_deterministic(const OL& system) {
    return std::all_of(system.letters.begin(), system.letters.end(),
                       [&](Symbol a) { return system.successors[a].size() == 1; });
}

std::optional<Pump> first_pump(const OL& system, const LetterFutures& futures) {
    for (const Symbol a : system.letters)
        for (std::size_t choice = 0; choice < system.successors[a].size(); ++choice)
            if (const auto found = pump(system, futures, a, choice)) return found;
    return std::nullopt;
}

std::uint32_t erasing_choice(const OL& system, const LetterFutures& futures, Symbol letter) {
    const auto& choices = system.successors[letter];
    if (!futures.shortest_life[letter]) throw Error("no rule erases " + system.alphabet->name(letter));
    for (std::uint32_t choice = 0; choice < choices.size(); ++choice)
        if (std::all_of(choices[choice].begin(), choices[choice].end(), [&](Symbol b) {
                return futures.shortest_life[b] && *futures.shortest_life[b] < *futures.shortest_life[letter];
            }))
            return choice;
    throw Error("the letters of another system");
}

}  // namespace algae
