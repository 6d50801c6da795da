#include "dimension/exact_dimension.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "dimension/distinct_parts.hpp"
#include "dimension/neighbours.hpp"
#include "dimension/parametric_dimension.hpp"
#include "growth/annihilator.hpp"
#include "system/d0l.hpp"

namespace algae {

namespace {

using Status = ExactDimension::Status;

/// Whether all of a component's pieces shrink to points.
bool is_point(const RecurrentSet& set, const Component& component) {
    for (const std::size_t piece : component.letters)
        for (const RecurrentSet::Part& part : parts_within(set, piece))
            if (part.offset != set.displacement().zero()) return false;
    return true;
}

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// The rate of the number of pairs of parts that meet.
std::optional<Rate> meeting_rate(const Neighbours& neighbours, const Budget& budget) {
    if (neighbours.pairs().empty()) return std::nullopt;
    const GrowthMatrix matrix = neighbours.matrix();
    const std::vector<Integer> ones(matrix.size(), Integer(1));
    const Polynomial polynomial = annihilator(neighbours.starts(), matrix, ones, budget);
    Integer widest = 1;
    for (const auto& row : matrix.rows) {
        Integer sum;
        for (const auto& entry : row) sum += entry.times;
        if (widest < sum) widest = sum;
    }
    return spectral_radius(factorise(polynomial).powers, Rational(widest + 1));
}

/// Looks at components from the largest possible dimension downwards.
class Search {
public:
    Search(const RecurrentSet& set, const Budget& budget)
        : set_(set), budget_(budget), ratio_(set.displacement()) {}

    ExactDimension result() {
        std::vector<std::size_t> order = components();
        if (order.empty()) {
            out_.value = out_.similarity = DimensionFormula(LogRatio(Rate(1), ratio_));
            out_.status = Status::exact;
            out_.conditions.push_back("the parts that are drawn do not multiply");
            return out_;
        }
        const auto& list = set_.components().list;
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return *list[a].rate > *list[b].rate;
        });
        out_.similarity = DimensionFormula(LogRatio(*list[order.front()].rate, ratio_));
        out_.conditions.push_back("all parts become similar, smaller by the factor " +
                                  ratio_.text() + " in each generation");
        std::optional<Rate> best;
        bool certain = true;
        for (const std::size_t component : order) {
            if (best && *best >= *list[component].rate) break;
            const std::optional<Rate> rate = rate_of(component);
            if (!rate) {
                certain = false;
                break;
            }
            if (!best || *rate > *best) best = rate;
        }
        out_.status = certain ? Status::exact : Status::upper_bound;
        out_.value = certain ? LogRatio(*best, ratio_) : *out_.similarity;
        if (!certain) {
            out_.boundary.reset();
            out_.meeting.reset();
        }
        return out_;
    }

private:
    std::vector<std::size_t> components() const {
        std::vector<std::size_t> found;
        const auto& list = set_.components().list;
        for (std::size_t k = 0; k < list.size(); ++k)
            if (list[k].rate && *list[k].rate > Rate(1) &&
                set_.is_reached(list[k].letters.front()) && !is_point(set_, list[k]))
                found.push_back(k);
        return found;
    }

    /// At which different parts multiply, if it could be found.
    std::optional<Rate> rate_of(std::size_t component) {
        const Rate& all = *set_.components().list[component].rate;
        try {
            const Neighbours neighbours(set_, component, budget_);
            if (!neighbours.parts_coincide()) {
                out_.conditions.push_back("parts meet in " +
                                          counted(neighbours.pairs().size(), "way", "ways") +
                                          "; no two coincide, so all of them count");
                find_boundary(neighbours, all);
                return all;
            }
            const DistinctGrowth distinct = distinct_growth(set_, component, neighbours, budget_);
            out_.conditions.push_back("parts coincide; different ones, told apart by " +
                                      counted(distinct.kinds, "kind", "kinds") +
                                      " of surroundings, multiply by " + distinct.rate.exact());
            return distinct.rate;
        } catch (const BoundReached& bound) {
            if (bound.bound() == Bound::time) throw;
            out_.conditions.push_back(std::string("whether parts coincide is not known: ") +
                                      bound.what());
            return std::nullopt;
        }
    }

    void find_boundary(const Neighbours& neighbours, const Rate& rate) {
        const auto meeting = meeting_rate(neighbours, budget_).value_or(Rate(1));
        if (!(meeting < rate)) return;
        if (!out_.meeting || *out_.meeting < meeting) out_.meeting = meeting;
        if (LogRatio(rate, ratio_).rational() == Rational(2))
            out_.boundary = LogRatio(meeting, ratio_);
    }

    const RecurrentSet& set_;
    const Budget& budget_;
    ScalingRatio ratio_;
    ExactDimension out_;
};

bool has_parameters(const LSystem& system) {
    return !system.axiom.arguments.empty() ||
           std::any_of(system.rules.begin(), system.rules.end(), [](const Production& rule) {
               return !rule.predecessor.parameters.empty() || !rule.successor.arguments.empty();
           });
}

}  // namespace

ExactDimension exact_dimension(const LSystem& system, const Budget& budget) {
    ExactDimension none;
    const View<D0L> rules = as_d0l(system);
    if (!rules && !has_parameters(system)) {
        none.conditions.push_back(rules.reason());
        return none;
    }
    try {
        const Settings& settings = system.settings;
        if (settings.tropism) throw Error("strokes bend to a tropism");
        if (!settings.solids.empty()) throw Error("symbols leave solids");
        if (!settings.surfaces.empty()) throw Error("symbols leave surfaces");
        if (!rules) return parametric_dimension(system, budget);
        const auto limit = std::make_shared<const RecurrentSet>(system, *rules, budget);
        ExactDimension found = Search(*limit, budget).result();
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

double greatest_dimension(const ExactDimension& exact) {
    if (exact.status != Status::upper_bound) return 2;
    return std::min(exact.value->enclosure(64).midpoint(), 2.0);
}

}  // namespace algae
