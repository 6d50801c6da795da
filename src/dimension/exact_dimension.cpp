#include <algorithm>

#include "dimension/detail/ratio_graph.hpp"
#include "dimension/detail/recurrent_set.hpp"
#include "model/model.hpp"

// The exact dimension of the limit curve of a system.
//
// D0L systems: the recurrent set is a graph-directed set with one ratio 1/|mu|. A strongly
// connected component of pieces whose different parts multiply by the rate r has the dimension log
// r / log |mu|, if its parts meet in finitely many ways (neighbours.cpp); the dimension of the
// whole is the largest of those of components that are reached. Components whose pieces shrink to
// points (all offsets 0) have the dimension 0. The search goes through components from the largest
// rate with multiplicity downward and stops at the first that cannot exceed the best found. A
// component that this method does not resolve makes the value with multiplicity an upper bound.
//
// Where the dimension is 2, the boundary is the topological one of the whole set: all components,
// with whatever parts of them cover each other (lattice_cells.cpp). Where parts of a component meet
// says nothing of it: other parts may cover that place. It is found where positions lie in a lattice
// of the plane, and otherwise not known.
//
// Parametric systems (ratio_graph.cpp): with one ratio they are D0L systems in disguise. Otherwise
// the similarity dimension (ratio_sum.cpp) is an upper bound, and exact where neighbour maps prove
// that no parts coincide (neighbour_maps.cpp); figures that only contain whole segments have
// dimension 1. D0L systems with angles of no lattice go the same way, with all ratios 1.

namespace algae {

namespace {

using Status = ExactDimension::Status;

/// Parts of states that draw for ever.
std::vector<RatioSum::Entry> lasting_entries(const RatioGraph& graph,
                                             const std::vector<bool>& drawing) {
    std::vector<RatioSum::Entry> found;
    for (std::size_t k = 0; k < graph.states.size(); ++k)
        for (const RatioGraph::Part& part : graph.states[k].parts)
            if (drawing[k] && !part.is_fence && drawing[part.state])
                found.push_back({k, part.state, part.ratio});
    return found;
}

/// Whether the figures of a component without branching become points beside the whole.
bool vanishes(const std::vector<RatioSum::Entry>& cycle, const WayGrowth& growth) {
    constexpr long bits = 192;
    Ball product(1, bits);
    for (const RatioSum::Entry& entry : cycle)
        product *= abs(enclosure(entry.ratio, bits)) / growth.enclosure(bits);
    return compare(product, Ball(1, bits)) == Order::less;
}

/// The states on whose ways it depends where parts of a component lie in its states' figures.
std::vector<bool> leading_states(const RatioGraph& graph, const Component& component) {
    std::vector<bool> inside(graph.states.size(), false), found(graph.states.size(), false);
    for (const std::size_t k : component.letters) inside[k] = true;
    for (const std::size_t k : component.letters) {
        std::vector<std::size_t> path, saved;
        for (const RatioGraph::Part& part : graph.states[k].parts) {
            if (part.is_fence && part.opens) {
                saved.push_back(path.size());
            } else if (part.is_fence) {
                path.resize(saved.back());
                saved.pop_back();
            } else {
                if (inside[part.state])
                    for (const std::size_t before : path) found[before] = true;
                path.push_back(part.state);
            }
        }
    }
    // Their ways are made of those of the parts outside branches.
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t k = 0; k < found.size(); ++k)
            if (found[k])
                for (const RatioGraph::Part* part : stem(graph.states[k]))
                    if (!found[part->state]) found[part->state] = changed = true;
    }
    return found;
}

/// Whether the figures of a component become points beside the whole: all ways between its parts grow more slowly.
bool is_point(const RatioGraph& graph, const Component& component, const WayGrowth& growth,
              const Budget& budget) {
    constexpr long bits = 192;
    const std::vector<bool> leading = leading_states(graph, component);
    RatioGraph ways;
    ways.angle = graph.angle;
    std::vector<std::size_t> place(graph.states.size());
    for (std::size_t k = 0; k < leading.size(); ++k)
        if (leading[k]) {
            place[k] = ways.states.size();
            ways.states.push_back(graph.states[k]);
        }
    for (RatioGraph::State& state : ways.states) {
        std::vector<RatioGraph::Part> parts;
        for (const RatioGraph::Part* part : stem(state)) {
            parts.push_back(*part);
            parts.back().state = place[part->state];
        }
        state.parts = std::move(parts);
    }
    const std::vector<bool> moving = moving_for_ever(ways);
    if (std::ranges::none_of(moving, [](bool moves) { return moves; })) return true;
    const WayGrowth own(ways, budget);
    return compare(own.enclosure(bits), growth.enclosure(bits)) == Order::less;
}

/// The dimension of the limit curve of a parametric system whose rules multiply lengths by
/// constants (`RatioGraph`). Where all of them are the same, it is that of the D0L system with
/// steps of one length. Otherwise it is the similarity dimension (`RatioSum`), exact where
/// `parts_apart` proves it, else an upper bound; segments that stay segments have the dimension 1.
///
/// Throws what `ratio_graph`, `WayGrowth` and `RatioSum` throw.
ExactDimension parametric_dimension(const Model& system, std::size_t ways, const Budget& budget) {
    const RatioGraph graph = ratio_graph(system, budget);
    if (const auto equal = with_equal_lengths(graph)) {
        ExactDimension found =
            ways > 0 ? exact_dimension(*equal, budget, ways) : dimension_bound(*equal, budget);
        if (found.status != Status::none) {
            if (!has_one_length(graph)) {
                found.boundary.reset();
                found.limit.reset();
            }
            found.conditions.insert(found.conditions.begin(),
                                    "every rule multiplies lengths by the same number");
            return found;
        }
    }
    std::vector<bool> draws;
    for (const RatioGraph::State& state : graph.states) draws.push_back(state.draws);
    const std::vector<bool> drawing = drawing_in_all(graph, draws);
    if (std::none_of(drawing.begin(), drawing.end(), [](bool lasts) { return lasts; }))
        throw Error("nothing is drawn in late generations");
    const auto growth = std::make_shared<const WayGrowth>(graph, budget);
    const std::vector<RatioSum::Entry> entries = lasting_entries(graph, drawing);
    const Components all = RatioSum::components(graph.states.size(), entries, budget);

    std::optional<RatioSum> largest;
    std::vector<std::size_t> states;  // of that component
    double dimension = 0;
    bool has_segments = false;
    for (const Component& component : all.list) {
        if (!component.rate) continue;
        std::vector<RatioSum::Entry> own = RatioSum::within(component, entries);
        if (*component.rate == Rate(1)) {
            const auto drawn =
                std::ranges::count_if(component.letters, [&](std::size_t k) { return draws[k]; });
            if (drawn == 0 || vanishes(own, *growth)) continue;
            if (static_cast<std::size_t>(drawn) < component.letters.size())
                throw Error("segments are drawn in some late generations, and not in others");
            has_segments = true;
            continue;
        }
        if (is_point(graph, component, *growth, budget)) continue;
        RatioSum sum(component.letters.size(), std::move(own), growth);
        const double value = sum.enclosure(64).midpoint();
        if (largest && value <= dimension) continue;
        dimension = value;
        largest = std::move(sum);
        states = component.letters;
    }
    ExactDimension found;
    if (largest && (!has_segments || dimension > 1)) {
        found.status = Status::upper_bound;
        found.value = found.similarity = DimensionFormula(*largest);
        found.conditions.push_back(
            "rules multiply lengths by constants, and m is the factor by which the ways from the "
            "beginnings to the ends of figures grow in each generation");
        if (ways == 0) {
            found.conditions.push_back("whether parts coincide has not been looked at");
            return found;
        }
        const PartsApart parts = parts_apart(graph, states, drawing, budget);
        if (parts.answer == PartsApart::Answer::apart) {
            found.status = Status::exact;
            found.conditions.push_back("parts meet in " + counted(parts.ways, "way") +
                                       "; no two coincide, so all of them count");
        } else if (parts.answer == PartsApart::Answer::coincide) {
            found.conditions.push_back("parts coincide, so it is an upper bound");
        } else {
            found.conditions.push_back("whether parts overlap is not known: " + parts.reason);
        }
        return found;
    }
    if (!has_segments) throw Error(vanishing);
    found.status = Status::exact;
    found.value = found.similarity = LogRatio(Rate(2), ScalingRatio(Integer(2)));
    found.conditions.push_back("segments stay segments");
    return found;
}

/// Looks at components from the largest possible dimension downwards.
class Search {
public:
    Search(const RecurrentSet& set, std::size_t ways, const Budget& budget)
        : set_(set), ways_(ways), budget_(budget), ratio_(set.displacement()) {}

    /// Without a look at where parts lie.
    ExactDimension bound() {
        begin();
        out_.status = Status::upper_bound;
        out_.value = out_.similarity;
        out_.conditions.push_back("whether parts coincide has not been looked at");
        return out_;
    }

    ExactDimension result() {
        begin();
        std::optional<Rate> found;
        bool certain = true;
        for (const std::vector<std::size_t>& order : phases_) {
            const std::optional<Rate> best = largest_of(order);
            if (found && best && !(*best == *found)) throw Error(varying);
            certain = certain && best;
            if (best) found = best;
        }
        out_.status = certain ? Status::exact : Status::upper_bound;
        out_.value = certain ? LogRatio(*found, ratio_) : *out_.similarity;
        if (!certain || meets_unknown_ || phases_.size() > 1) out_.meeting.reset();
        if (phases_.size() > 1)
            out_.is_regular = false;
        else if (certain && out_.value->rational() == Rational(2))
            find_boundary();
        return out_;
    }

private:
    /// The similarity dimension, and the components of the phases.
    void begin() {
        phases_ = multiplying_components(set_);
        const auto& list = set_.components().list;
        std::optional<Rate> largest;
        for (const std::vector<std::size_t>& order : phases_)
            if (const Rate& rate = *list[order.front()].rate; !largest || rate > *largest)
                largest = rate;
        out_.similarity = DimensionFormula(LogRatio(*largest, ratio_));
        out_.conditions.push_back("all parts become similar, smaller by the factor " +
                                  ratio_.text() + " in each generation");
    }

    /// At which the different parts of the component multiply whose do it most; nothing where it is not known.
    std::optional<Rate> largest_of(const std::vector<std::size_t>& order) {
        const auto& list = set_.components().list;
        std::optional<Rate> best;
        for (const std::size_t component : order) {
            const Rate& all = *list[component].rate;
            if (best && *best > all) break;
            if (best && *best == all) {  // as large at most: only where its parts meet matters
                find_meeting_of(component);
                continue;
            }
            const std::optional<Rate> rate = rate_of(component);
            if (!rate) return std::nullopt;
            if (!best || *rate > *best) best = rate;
        }
        return best;
    }

    /// At which different parts multiply, if it could be found.
    std::optional<Rate> rate_of(std::size_t component) {
        const Rate& all = *set_.components().list[component].rate;
        try {
            const Neighbours neighbours(set_, component, budget_, ways_);
            if (!neighbours.parts_coincide()) {
                out_.conditions.push_back("parts meet in " +
                                          counted(neighbours.pairs().size(), "way") +
                                          "; no two coincide, so all of them count");
                find_meeting(neighbours, all);
                out_.is_regular = is_alone(component);
                return all;
            }
            meets_unknown_ = true;  // another component's meeting is not that of the whole
            const DistinctGrowth distinct =
                distinct_growth(set_, component, neighbours, budget_, ways_);
            out_.conditions.push_back("parts coincide; different ones, told apart by " +
                                      counted(distinct.kinds, "kind") +
                                      " of surroundings, multiply by " + distinct.rate.exact());
            return distinct.rate;
        } catch (const BoundReached& bound) {
            if (bound.bound() == Bound::time) throw;
            out_.conditions.push_back(std::string("whether parts coincide is not known: ") +
                                      bound.what());
            return std::nullopt;
        }
    }

    /// Whether all that is drawn for ever comes from this component: then a piece of a level that has been reached is of it, but for
    /// the first levels.
    bool is_alone(std::size_t component) const {
        const auto& list = set_.components().list;
        for (std::size_t k = 0; k < list.size(); ++k)
            if (k != component && list[k].rate && set_.is_reached(list[k].letters.front()))
                return false;
        return true;
    }

    void find_meeting(const Neighbours& neighbours, const Rate& rate) {
        const Rate meeting = neighbours.meeting_rate(budget_);
        if (meeting < rate && (!out_.meeting || *out_.meeting < meeting)) out_.meeting = meeting;
    }

    /// Of a component that is not larger than one that has been looked at.
    void find_meeting_of(std::size_t component) {
        constexpr std::size_t few = 5'000;
        try {
            const Neighbours neighbours(set_, component, budget_, few);
            if (neighbours.parts_coincide())
                meets_unknown_ = true;
            else
                find_meeting(neighbours, *set_.components().list[component].rate);
        } catch (const BoundReached& bound) {
            if (bound.bound() == Bound::time) throw;
            meets_unknown_ = true;
        }
    }

    /// Whether the whole is one part, and all of its parts are of one kind in each phase.
    bool is_of_one_kind() const {
        if (set_.axiom().size() != 1) return false;
        std::vector<std::size_t> of_phase(set_.unfolding().phases, 0);
        for (std::size_t p = 0; p < set_.size(); ++p)
            if (set_.is_reached(p) && ++of_phase[p / set_.unfolding().letters.size()] > 1)
                return false;
        return true;
    }

    /// Of the whole set.
    void find_boundary() {
        // A part within the inner is surrounded by those that it meets, and similar to the whole.
        if (is_of_one_kind() && out_.meeting) {
            out_.boundary = LogRatio(*out_.meeting, ratio_);
            return;
        }
        try {
            const CellGrowth cells = cell_growth(set_, budget_, ways_);
            if (cells.has_interior) out_.boundary = LogRatio(cells.boundary, ratio_);
        } catch (const BoundReached& bound) {
            if (bound.bound() == Bound::time) throw;
            out_.conditions.push_back(std::string("the boundary is not known: ") + bound.what());
        } catch (const Error& reason) {
            out_.conditions.push_back(std::string("the boundary is not known: ") + reason.what());
        }
    }

    const RecurrentSet& set_;
    std::size_t ways_;
    const Budget& budget_;
    ScalingRatio ratio_;
    std::vector<std::vector<std::size_t>> phases_;  // of late generations: their components
    bool meets_unknown_ = false;
    ExactDimension out_;
};

bool has_parameters(const LSystem& system) {
    return !system.axiom.arguments.empty() ||
           std::any_of(system.rules.begin(), system.rules.end(), [](const Production& rule) {
               return !rule.predecessor.parameters.empty() || !rule.successor.arguments.empty();
           });
}

/// Whether the angle is one of those that the recurrent set is exact for.
bool has_lattice_angle(const Drawing& drawing) {
    return !drawing.angle ||
           (drawing.angle->exact && (*drawing.angle->exact / Rational(360)).denominator() <= 360);
}

/// Parts that coincide are looked for among so many ways; not at all with 0.
ExactDimension found_dimension(const Model& system, std::size_t ways, const Budget& budget) {
    ExactDimension none;
    const View<D0L> rules = as_d0l(system);
    const View<S0L> chance = rules ? View<S0L>::refused("") : as_s0l(system);
    if (!rules && !chance && !has_parameters(system)) {
        none.conditions.push_back(rules.reason());
        return none;
    }
    try {
        const Drawing& drawing = system.drawing;
        if (drawing.tropism) throw Error("strokes bend to a tropism");
        if (!drawing.solids.empty()) throw Error("symbols leave solids");
        if (!drawing.surfaces.empty()) throw Error("symbols leave surfaces");
        if (!drawing.stamps.empty()) throw Error("symbols leave filled shapes");
        if (chance) return random_dimension(system, *chance, ways, budget);
        if (!rules || !has_lattice_angle(drawing))
            return parametric_dimension(system, ways, budget);
        const auto limit = std::make_shared<const RecurrentSet>(system, *rules, budget);
        Search search(*limit, ways, budget);
        ExactDimension found = ways > 0 ? search.result() : search.bound();
        found.limit = limit;
        return found;
    } catch (const BoundReached& bound) {
        if (bound.bound() == Bound::time) throw;
        if (is_of_budget(bound.bound())) none.status = Status::unfinished;
        none.conditions.push_back(bound.what());
        return none;
    } catch (const Error& reason) {
        none.conditions.push_back(reason.what());
        return none;
    }
}

}  // namespace

ExactDimension exact_dimension(const Model& system, const Budget& budget, std::size_t most_ways) {
    return found_dimension(system, most_ways, budget);
}

ExactDimension dimension_bound(const Model& system, const Budget& budget) {
    return found_dimension(system, 0, budget);
}

}  // namespace algae
