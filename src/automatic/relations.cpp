#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "automatic/detail/relations.hpp"

// Automata over columns of digits: products, complements within the numbers of the numeration, projections, and minimal automata.

namespace algae {

namespace {

using Edge = AutomaticRelation::Edge;
constexpr std::uint32_t none = ~std::uint32_t{0};

/// Numbers pairs of states in the order in which they come.
class Pairs {
public:
    std::uint32_t number(std::uint32_t left, std::uint32_t right) {
        if ((all_.size() + 1) * 2 > slots_.size()) grow();
        const std::uint64_t key = std::uint64_t{left} << 32 | right;
        std::uint32_t& slot = slots_[place(key)];
        if (slot == none) {
            slot = static_cast<std::uint32_t>(all_.size());
            all_.push_back(key);
        }
        return slot;
    }
    std::size_t size() const { return all_.size(); }
    std::uint32_t left(std::size_t i) const { return static_cast<std::uint32_t>(all_[i] >> 32); }
    std::uint32_t right(std::size_t i) const { return static_cast<std::uint32_t>(all_[i]); }

private:
    std::size_t place(std::uint64_t key) const {
        std::uint64_t mixed = key * 0x9E3779B97F4A7C15u;
        mixed ^= mixed >> 29;
        std::size_t at = mixed & (slots_.size() - 1);
        while (slots_[at] != none && all_[slots_[at]] != key) at = (at + 1) & (slots_.size() - 1);
        return at;
    }
    void grow() {
        slots_.assign(std::max<std::size_t>(64, slots_.size() * 2), none);
        for (std::size_t i = 0; i < all_.size(); ++i)
            slots_[place(all_[i])] = static_cast<std::uint32_t>(i);
    }
    std::vector<std::uint64_t> all_;
    std::vector<std::uint32_t> slots_;
};

/// Numbers sets of states, each increasing.
class Subsets {
public:
    std::uint32_t number(const std::vector<std::uint32_t>& states) {
        if ((size() + 1) * 2 > slots_.size()) grow();
        std::uint32_t& slot = slots_[place(states.data(), states.size())];
        if (slot == none) {
            slot = static_cast<std::uint32_t>(size());
            pool_.insert(pool_.end(), states.begin(), states.end());
            begins_.push_back(pool_.size());
        }
        return slot;
    }
    std::size_t size() const { return begins_.size() - 1; }
    std::size_t pooled() const { return pool_.size(); }
    std::vector<std::uint32_t> members(std::size_t i) const {
        return {pool_.begin() + static_cast<std::ptrdiff_t>(begins_[i]),
                pool_.begin() + static_cast<std::ptrdiff_t>(begins_[i + 1])};
    }

private:
    std::size_t place(const std::uint32_t* states, std::size_t count) const {
        std::uint64_t hash = 1469598103934665603u;
        for (std::size_t i = 0; i < count; ++i) hash = (hash ^ states[i]) * 1099511628211u;
        hash ^= hash >> 31;
        std::size_t at = hash & (slots_.size() - 1);
        while (slots_[at] != none) {
            const std::size_t begin = begins_[slots_[at]], end = begins_[slots_[at] + 1];
            if (end - begin == count && std::equal(states, states + count, pool_.data() + begin))
                break;
            at = (at + 1) & (slots_.size() - 1);
        }
        return at;
    }
    void grow() {
        slots_.assign(std::max<std::size_t>(64, slots_.size() * 2), none);
        for (std::size_t i = 0; i < size(); ++i)
            slots_[place(pool_.data() + begins_[i], begins_[i + 1] - begins_[i])] =
                static_cast<std::uint32_t>(i);
    }
    std::vector<std::uint32_t> pool_, slots_;
    std::vector<std::size_t> begins_{0};
};

/// A partition that is refined, after Valmari and Lehtinen (Efficient minimization of DFAs with partial transition functions, 2008).
class Refinable {
public:
    explicit Refinable(std::size_t count)
        : elements(count), places_(count), set_of(count, 0), marked_(count + 1, 0) {
        std::iota(elements.begin(), elements.end(), 0);
        std::iota(places_.begin(), places_.end(), 0);
        if (count > 0) {
            first.push_back(0);
            past.push_back(static_cast<std::uint32_t>(count));
        }
    }

    std::size_t sets() const { return first.size(); }

    void mark(std::uint32_t element) {
        const std::uint32_t set = set_of[element], at = places_[element],
                            to = first[set] + marked_[set];
        if (at < to) return;  // it is marked
        elements[at] = elements[to];
        places_[elements[at]] = at;
        elements[to] = element;
        places_[element] = to;
        if (marked_[set]++ == 0) touched_.push_back(set);
    }

    /// Sets of which some elements are marked become two; the smaller part gets the new number.
    void split() {
        for (const std::uint32_t set : touched_) {
            const std::uint32_t middle = first[set] + marked_[set];
            const std::uint32_t count = marked_[set];
            marked_[set] = 0;
            if (middle == past[set]) continue;
            const auto added = static_cast<std::uint32_t>(sets());
            if (count <= past[set] - middle) {
                first.push_back(first[set]);
                past.push_back(middle);
                first[set] = middle;
            } else {
                first.push_back(middle);
                past.push_back(past[set]);
                past[set] = middle;
            }
            for (std::uint32_t i = first[added]; i < past[added]; ++i) set_of[elements[i]] = added;
        }
        touched_.clear();
    }

    /// Sets of elements with the same key.
    template <class Key>
    void group(Key key) {
        std::sort(elements.begin(), elements.end(),
                  [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
        first.clear();
        past.clear();
        for (std::uint32_t i = 0; i < elements.size(); ++i) {
            if (i == 0 || key(elements[i]) != key(elements[i - 1])) {
                if (i > 0) past.push_back(i);
                first.push_back(i);
            }
            set_of[elements[i]] = static_cast<std::uint32_t>(first.size() - 1);
            places_[elements[i]] = i;
        }
        if (!elements.empty()) past.push_back(static_cast<std::uint32_t>(elements.size()));
    }

    std::vector<std::uint32_t> elements;

private:
    std::vector<std::uint32_t> places_;

public:
    std::vector<std::uint32_t> set_of, first, past;

private:
    std::vector<std::uint32_t> marked_, touched_;
};

/// The empty relation.
AutomaticRelation nothing(std::vector<std::string> variables) {
    return {std::move(variables), {0, 0}, {}, {0}};
}

/// How columns of some variables become columns of others: for each variable the weight of its digit.
std::vector<std::uint32_t> weights(const std::vector<std::string>& from,
                                   const std::vector<std::string>& to, std::uint32_t base) {
    std::vector<std::uint32_t> found(from.size(), 0);
    std::uint64_t weight = 1;
    for (const std::string& variable : to) {
        if (weight > none)
            throw BoundReached(Bound::method, "the statement needs " + std::to_string(to.size()) +
                                                  " numbers of base " + std::to_string(base) +
                                                  " at once, more than columns can hold");
        const auto at = std::ranges::find(from, variable);
        if (at != from.end())
            found[static_cast<std::size_t>(at - from.begin())] = static_cast<std::uint32_t>(weight);
        weight *= base;
    }
    if (weight > none)
        throw BoundReached(Bound::method, "the statement needs " + std::to_string(to.size()) +
                                              " numbers of base " + std::to_string(base) +
                                              " at once, more than columns can hold");
    return found;
}

std::uint32_t translated(std::uint32_t column, const std::vector<std::uint32_t>& weight,
                         std::uint32_t base) {
    std::uint32_t sum = 0;
    for (const std::uint32_t one : weight) {
        sum += column % base * one;
        column /= base;
    }
    return sum;
}

std::vector<std::string> united(const std::vector<std::string>& left,
                                const std::vector<std::string>& right) {
    std::vector<std::string> all;
    std::ranges::set_union(left, right, std::back_inserter(all));
    return all;
}

/// The edges of an automaton with the digits of shared variables apart, by these in each state.
struct KeyedEdges {
    struct One {
        std::uint32_t key, column, target;
    };
    std::vector<One> all;

    KeyedEdges(const AutomaticRelation& of, const std::vector<std::uint32_t>& key,
               const std::vector<std::uint32_t>& column, std::uint32_t base) {
        all.reserve(of.edges.size());
        for (const Edge& edge : of.edges)
            all.push_back({translated(edge.column, key, base),
                           translated(edge.column, column, base), edge.target});
        for (std::size_t s = 0; s < of.states(); ++s)
            std::sort(all.begin() + of.first[s], all.begin() + of.first[s + 1],
                      [](const One& a, const One& b) { return a.key < b.key; });
    }
};

}  // namespace

bool AutomaticRelation::empty() const { return std::ranges::count(accepting, 1) == 0; }

Relations::Relations(const AutomaticWord& word, const Budget& budget,
                     std::function<void(std::size_t)> progress)
    : word_(word), numeration_(word.numeration), budget_(budget), progress_(std::move(progress)) {}

void Relations::count(std::size_t states, std::size_t edges) {
    budget_.check();
    budget_.check_memory(std::uint64_t{states} * 48 + std::uint64_t{edges} * 32, "an automaton");
    if (states <= largest_) return;
    largest_ = states;
    if (progress_) progress_(states);
}

AutomaticRelation Relations::minimal(const RawAutomaton& raw, std::vector<std::string> variables) {
    const std::size_t states = raw.accepting.size();
    count(states, raw.edges.size());
    // States from which something is accepted.
    std::vector<std::uint32_t> begin(states + 1, 0), from(raw.edges.size());
    for (const Edge& edge : raw.edges) ++begin[edge.target + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    {
        std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
        for (std::uint32_t s = 0; s < states; ++s)
            for (std::uint32_t e = raw.first[s]; e < raw.first[s + 1]; ++e)
                from[next[raw.edges[e].target]++] = s;
    }
    std::vector<char> useful(states, 0);
    std::vector<std::uint32_t> stack;
    for (std::uint32_t s = 0; s < states; ++s)
        if (raw.accepting[s]) {
            useful[s] = 1;
            stack.push_back(s);
        }
    while (!stack.empty()) {
        const std::uint32_t s = stack.back();
        stack.pop_back();
        for (std::uint32_t i = begin[s]; i < begin[s + 1]; ++i)
            if (!useful[from[i]]) {
                useful[from[i]] = 1;
                stack.push_back(from[i]);
            }
    }
    if (states == 0 || !useful[0]) return nothing(std::move(variables));
    std::vector<std::uint32_t> kept(states, none), old;
    for (std::uint32_t s = 0; s < states; ++s)
        if (useful[s]) {
            kept[s] = static_cast<std::uint32_t>(old.size());
            old.push_back(s);
        }
    std::vector<std::uint32_t> tail, head, label;
    for (const std::uint32_t s : old)
        for (std::uint32_t e = raw.first[s]; e < raw.first[s + 1]; ++e)
            if (useful[raw.edges[e].target]) {
                tail.push_back(kept[s]);
                head.push_back(kept[raw.edges[e].target]);
                label.push_back(raw.edges[e].column);
            }
    from = {};
    // Blocks of states and cords of edges refine each other.
    std::vector<std::uint32_t> arrivals(old.size() + 1, 0), arriving(tail.size());
    for (const std::uint32_t h : head) ++arrivals[h + 1];
    std::partial_sum(arrivals.begin(), arrivals.end(), arrivals.begin());
    {
        std::vector<std::uint32_t> next(arrivals.begin(), arrivals.end() - 1);
        for (std::uint32_t e = 0; e < head.size(); ++e) arriving[next[head[e]]++] = e;
    }
    Refinable blocks(old.size()), cords(tail.size());
    for (std::uint32_t s = 0; s < old.size(); ++s)
        if (raw.accepting[old[s]]) blocks.mark(s);
    blocks.split();
    cords.group([&](std::uint32_t e) { return label[e]; });
    for (std::size_t b = 1, c = 0; c < cords.sets(); ++c) {
        if (c % 64 == 0) budget_.check();
        for (std::uint32_t i = cords.first[c]; i < cords.past[c]; ++i)
            blocks.mark(tail[cords.elements[i]]);
        blocks.split();
        for (; b < blocks.sets(); ++b) {
            for (std::uint32_t i = blocks.first[b]; i < blocks.past[b]; ++i) {
                const std::uint32_t s = blocks.elements[i];
                for (std::uint32_t k = arrivals[s]; k < arrivals[s + 1]; ++k)
                    cords.mark(arriving[k]);
            }
            cords.split();
        }
    }
    // One state for each block, in the order in which columns reach them.
    std::vector<std::vector<Edge>> edges(blocks.sets());
    std::vector<char> done(blocks.sets(), 0);
    std::vector<std::uint32_t> chosen(blocks.sets());
    for (std::uint32_t b = 0; b < blocks.sets(); ++b) chosen[b] = blocks.elements[blocks.first[b]];
    for (std::uint32_t e = 0; e < tail.size(); ++e) {
        const std::uint32_t b = blocks.set_of[tail[e]];
        if (chosen[b] == tail[e]) edges[b].push_back({label[e], blocks.set_of[head[e]]});
    }
    AutomaticRelation found;
    found.variables = std::move(variables);
    std::vector<std::uint32_t> number(blocks.sets(), none), order{blocks.set_of[kept[0]]};
    number[order.front()] = 0;
    found.first.push_back(0);
    for (std::size_t i = 0; i < order.size(); ++i) {
        auto& own = edges[order[i]];
        std::sort(own.begin(), own.end());
        for (Edge edge : own) {
            if (number[edge.target] == none) {
                number[edge.target] = static_cast<std::uint32_t>(order.size());
                order.push_back(edge.target);
            }
            edge.target = number[edge.target];
            found.edges.push_back(edge);
        }
        found.first.push_back(static_cast<std::uint32_t>(found.edges.size()));
        found.accepting.push_back(raw.accepting[old[chosen[order[i]]]]);
    }
    return found;
}

AutomaticRelation Relations::constant(bool holds) const {
    if (!holds) return nothing({});
    return {{}, {0, 1}, {{0, 0}}, {1}};
}

AutomaticRelation Relations::numbers(const std::string& variable,
                                     const std::function<bool(std::uint32_t state)>& accepts) {
    RawAutomaton raw;
    for (std::uint32_t s = 0; s < numeration_.letters().size(); ++s) {
        for (std::uint32_t digit = 0; digit < numeration_.image(s).size(); ++digit)
            raw.edges.push_back({digit, numeration_.image(s)[digit]});
        raw.close(accepts(s));
    }
    return minimal(raw, {variable});
}

AutomaticRelation Relations::all(const std::vector<std::string>& variables) {
    // Their automaton has no names in it, so one serves all variables.
    if (all_.empty()) all_.push_back(constant(true));
    while (all_.size() <= variables.size()) {
        const auto one = numbers(std::to_string(all_.size()), [](std::uint32_t) { return true; });
        all_.push_back(both(all_.back(), one));
    }
    AutomaticRelation found = all_[variables.size()];
    found.variables = variables;
    return found;
}

AutomaticRelation Relations::both(const AutomaticRelation& left, const AutomaticRelation& right) {
    const std::uint32_t base = numeration_.base();
    std::vector<std::string> shared;
    std::ranges::set_intersection(left.variables, right.variables, std::back_inserter(shared));
    const std::vector<std::string> variables = united(left.variables, right.variables);
    std::vector<std::uint32_t> extra = weights(right.variables, variables, base);
    for (std::size_t i = 0; i < right.variables.size(); ++i)
        if (std::ranges::binary_search(shared, right.variables[i])) extra[i] = 0;
    const KeyedEdges of_left(left, weights(left.variables, shared, base),
                             weights(left.variables, variables, base), base);
    const KeyedEdges of_right(right, weights(right.variables, shared, base), extra, base);
    Pairs pairs;
    pairs.number(0, 0);
    RawAutomaton raw;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (i % 1024 == 0) count(pairs.size(), raw.edges.size());
        const std::uint32_t p = pairs.left(i), q = pairs.right(i);
        std::uint32_t a = left.first[p], b = right.first[q];
        const std::uint32_t a_end = left.first[p + 1], b_end = right.first[q + 1];
        while (a < a_end && b < b_end) {
            const std::uint32_t key = of_left.all[a].key, other = of_right.all[b].key;
            if (key < other) {
                ++a;
            } else if (other < key) {
                ++b;
            } else {
                for (; a < a_end && of_left.all[a].key == key; ++a)
                    for (std::uint32_t k = b; k < b_end && of_right.all[k].key == key; ++k)
                        raw.edges.push_back(
                            {of_left.all[a].column + of_right.all[k].column,
                             pairs.number(of_left.all[a].target, of_right.all[k].target)});
                while (b < b_end && of_right.all[b].key == key) ++b;
            }
        }
        raw.close(left.accepting[p] && right.accepting[q]);
    }
    return minimal(raw, variables);
}

AutomaticRelation Relations::over(const AutomaticRelation& one,
                                  const std::vector<std::string>& variables) {
    std::vector<std::string> more;
    std::ranges::set_difference(variables, one.variables, std::back_inserter(more));
    return more.empty() ? one : both(one, all(more));
}

AutomaticRelation Relations::either(const AutomaticRelation& left, const AutomaticRelation& right) {
    const std::vector<std::string> variables = united(left.variables, right.variables);
    return merged(over(left, variables), over(right, variables),
                  [](bool is_left, bool is_right) { return is_left || is_right; });
}

AutomaticRelation Relations::complement(const AutomaticRelation& one) {
    return merged(all(one.variables), one,
                  [](bool is_number, bool is_one) { return is_number && !is_one; });
}

template <class Accepts>
AutomaticRelation Relations::merged(const AutomaticRelation& one, const AutomaticRelation& other,
                                    Accepts accepts) {
    Pairs pairs;
    pairs.number(0, 0);
    RawAutomaton raw;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (i % 1024 == 0) count(pairs.size(), raw.edges.size());
        const std::uint32_t p = pairs.left(i), q = pairs.right(i);
        std::uint32_t a = p == none ? 0 : one.first[p], b = q == none ? 0 : other.first[q];
        const std::uint32_t a_end = p == none ? 0 : one.first[p + 1],
                            b_end = q == none ? 0 : other.first[q + 1];
        while (a < a_end || b < b_end) {
            const std::uint64_t x = a < a_end ? one.edges[a].column : std::uint64_t{1} << 32;
            const std::uint64_t y = b < b_end ? other.edges[b].column : std::uint64_t{1} << 32;
            const std::uint64_t column = std::min(x, y);
            const std::uint32_t to = x == column ? one.edges[a++].target : none;
            const std::uint32_t too = y == column ? other.edges[b++].target : none;
            raw.edges.push_back({static_cast<std::uint32_t>(column), pairs.number(to, too)});
        }
        raw.close(accepts(p != none && one.accepting[p], q != none && other.accepting[q]));
    }
    return minimal(raw, one.variables);
}

AutomaticRelation Relations::without(const AutomaticRelation& one,
                                     const std::set<std::string>& variables) {
    std::vector<std::string> rest;
    for (const std::string& variable : one.variables)
        if (!variables.contains(variable)) rest.push_back(variable);
    if (rest.size() == one.variables.size()) return one;
    if (rest.empty()) return constant(!one.empty());
    const std::vector<std::uint32_t> weight = weights(one.variables, rest, numeration_.base());
    std::vector<Edge> edges;  // sorted in each state, of the automaton with choices
    std::vector<std::uint32_t> first{0};
    for (std::size_t s = 0; s < one.states(); ++s) {
        const auto begin = static_cast<std::ptrdiff_t>(edges.size());
        for (std::uint32_t e = one.first[s]; e < one.first[s + 1]; ++e)
            edges.push_back(
                {translated(one.edges[e].column, weight, numeration_.base()), one.edges[e].target});
        std::sort(edges.begin() + begin, edges.end());
        edges.erase(std::unique(edges.begin() + begin, edges.end()), edges.end());
        first.push_back(static_cast<std::uint32_t>(edges.size()));
    }
    // The numbers that are left out may have more digits than the others: these read zeros meanwhile.
    std::vector<std::uint32_t> begin{0};
    std::vector<char> is_in(one.states(), 0);
    is_in[0] = 1;
    for (std::size_t i = 0; i < begin.size(); ++i)
        for (std::uint32_t e = first[begin[i]]; e < first[begin[i] + 1] && edges[e].column == 0;
             ++e)
            if (!is_in[edges[e].target]) {
                is_in[edges[e].target] = 1;
                begin.push_back(edges[e].target);
            }
    std::sort(begin.begin(), begin.end());
    // Columns by their place among those that occur.
    std::vector<std::uint32_t> columns;
    for (const Edge& edge : edges) columns.push_back(edge.column);
    std::sort(columns.begin(), columns.end());
    columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
    for (Edge& edge : edges)
        edge.column = static_cast<std::uint32_t>(
            std::lower_bound(columns.begin(), columns.end(), edge.column) - columns.begin());
    Subsets subsets;
    subsets.number(begin);
    RawAutomaton raw;
    std::vector<std::vector<std::uint32_t>> next(columns.size());  // states by column
    std::vector<std::uint32_t> seen(one.states(), 0);
    std::uint32_t time = 0;  // of which a state was seen last
    for (std::size_t i = 0; i < subsets.size(); ++i) {
        if (i % 256 == 0) count(subsets.size(), raw.edges.size() + subsets.pooled());
        bool accepts = false;
        for (const std::uint32_t s : subsets.members(i)) {
            accepts = accepts || one.accepting[s];
            for (std::uint32_t e = first[s]; e < first[s + 1]; ++e)
                next[edges[e].column].push_back(edges[e].target);
        }
        for (std::size_t c = 0; c < columns.size(); ++c) {
            std::vector<std::uint32_t>& states = next[c];
            if (states.empty()) continue;
            if (++time == 0) std::fill(seen.begin(), seen.end(), time++);
            std::erase_if(states,
                          [&](std::uint32_t s) { return std::exchange(seen[s], time) == time; });
            std::sort(states.begin(), states.end());
            raw.edges.push_back({columns[c], subsets.number(states)});
            states.clear();
        }
        raw.close(accepts);
    }
    return minimal(raw, rest);
}

AutomaticRelation Relations::renamed(const AutomaticRelation& one,
                                     const std::map<std::string, std::string>& names) {
    std::vector<std::string> to, sorted;
    for (const std::string& variable : one.variables) to.push_back(names.at(variable));
    sorted = to;
    std::ranges::sort(sorted);
    const std::vector<std::uint32_t> weight = weights(to, sorted, numeration_.base());
    RawAutomaton raw;
    raw.first = one.first;
    raw.accepting = one.accepting;
    for (const Edge& edge : one.edges)
        raw.edges.push_back({translated(edge.column, weight, numeration_.base()), edge.target});
    return minimal(raw, sorted);
}

AutomaticRelation Relations::one_more(const AutomaticRelation& one, const std::string& variable) {
    std::map<std::string, std::string> names;
    for (const std::string& name : one.variables) names[name] = name;
    const std::string next = fresh();
    names[variable] = next;
    return without(both(renamed(one, names), sum({{{variable, 1}}, 1}, next)), {next});
}

std::vector<std::pair<std::string, Integer>> Relations::witness(
    const AutomaticRelation& one) const {
    std::vector<std::uint32_t> from(one.states(), none), column(one.states(), 0), queue{0};
    std::vector<char> seen(one.states(), 0);
    seen[0] = 1;
    std::uint32_t end = none;
    for (std::size_t i = 0; i < queue.size() && end == none; ++i) {
        const std::uint32_t s = queue[i];
        if (one.accepting[s]) end = s;
        for (std::uint32_t e = one.first[s]; e < one.first[s + 1]; ++e) {
            const Edge& edge = one.edges[e];
            if (seen[edge.target]) continue;
            seen[edge.target] = 1;
            from[edge.target] = s;
            column[edge.target] = edge.column;
            queue.push_back(edge.target);
        }
    }
    std::vector<std::vector<std::uint32_t>> digits(one.variables.size());
    if (end != none)
        for (std::uint32_t s = end; s != 0; s = from[s]) {
            std::uint32_t left = column[s];
            for (auto& of_one : digits) {
                of_one.push_back(left % numeration_.base());
                left /= numeration_.base();
            }
        }
    std::vector<std::pair<std::string, Integer>> found;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        std::ranges::reverse(digits[i]);
        found.emplace_back(one.variables[i], numeration_.value(digits[i]).value_or(0));
    }
    return found;
}

bool contains(const AutomaticRelation& relation, const Numeration& numeration,
              const std::vector<Integer>& numbers) {
    std::vector<std::vector<std::uint32_t>> digits;
    std::size_t length = 0;
    for (const Integer& number : numbers) {
        digits.push_back(numeration.digits(number));
        length = std::max(length, digits.back().size());
    }
    std::uint32_t state = 0;
    for (std::size_t i = 0; i < length; ++i) {
        std::uint32_t column = 0;
        for (std::size_t v = digits.size(); v-- > 0;) {
            const std::size_t zeros = length - digits[v].size();
            column = column * numeration.base() + (i < zeros ? 0 : digits[v][i - zeros]);
        }
        const auto begin = relation.edges.begin() + relation.first[state],
                   end = relation.edges.begin() + relation.first[state + 1];
        const auto edge = std::lower_bound(begin, end, Edge{column, 0});
        if (edge == end || edge->column != column) return false;
        state = edge->target;
    }
    return relation.accepting[state] != 0;
}

std::vector<std::vector<Integer>> members(const AutomaticRelation& relation,
                                          const Numeration& numeration, std::size_t most) {
    // Paths in order of length; those that begin with a column of zeros are the shorter ones again.
    std::vector<std::vector<Integer>> found;
    struct Path {
        std::uint32_t state;
        std::vector<std::vector<std::uint32_t>> digits;
    };
    std::vector<Path> paths{
        {0, std::vector<std::vector<std::uint32_t>>(relation.variables.size())}};
    constexpr std::size_t longest = 64, widest = 200'000;
    for (std::size_t length = 0; length < longest && !paths.empty(); ++length) {
        for (const Path& path : paths) {
            if (!relation.accepting[path.state]) continue;
            std::vector<Integer> tuple;
            for (const auto& digits : path.digits)
                tuple.push_back(numeration.value(digits).value_or(0));
            found.push_back(std::move(tuple));
            if (found.size() == most) return found;
        }
        std::vector<Path> next;
        for (const Path& path : paths)
            for (std::uint32_t e = relation.first[path.state]; e < relation.first[path.state + 1];
                 ++e) {
                std::uint32_t column = relation.edges[e].column;
                if (length == 0 && column == 0) continue;
                Path longer{relation.edges[e].target, path.digits};
                for (auto& digits : longer.digits) {
                    digits.push_back(column % numeration.base());
                    column /= numeration.base();
                }
                next.push_back(std::move(longer));
                if (next.size() > widest) return found;
            }
        paths = std::move(next);
    }
    return found;
}

}  // namespace algae
