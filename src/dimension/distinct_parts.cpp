#include "dimension/distinct_parts.hpp"

#include <algorithm>
#include <map>
#include <vector>

#include "base/error.hpp"
#include "growth/annihilator.hpp"

namespace algae {

namespace {

constexpr std::size_t counted_levels = 8;

/// A piece with the others that may coincide with parts of it, in order.
struct Surroundings {
    std::size_t piece;
    std::vector<Placement> others;
    bool operator<(const Surroundings& other) const {
        return piece != other.piece ? piece < other.piece : others < other.others;
    }
};

/// Every piece is told apart from those that have been seen, and its parts counted.
class Census {
public:
    Census(const RecurrentSet& set, const Neighbours& neighbours, const Budget& budget,
           std::size_t most)
        : set_(set),
          neighbours_(neighbours),
          budget_(budget),
          most_(most),
          here_{0, 0, set.displacement().zero()} {}

    std::size_t number(Surroundings surroundings) {
        const auto [place, is_new] = numbers_.try_emplace(std::move(surroundings), kinds_.size());
        if (is_new) {
            if (kinds_.size() == most_)
                throw BoundReached(Bound::method, "more than " + std::to_string(most_) +
                                                      " kinds of surroundings of parts");
            kinds_.push_back(place->first);
        }
        return place->second;
    }

    /// For each kind, the kinds of its parts and among how many they are shared.
    struct Share {
        std::size_t kind;
        long sharers;
    };
    std::vector<std::vector<Share>> all(std::size_t start_piece) {
        number({start_piece, {}});
        std::vector<std::vector<Share>> rows;
        for (std::size_t k = 0; k < kinds_.size(); ++k) {
            budget_.check();
            rows.push_back(parts_of(k));
        }
        return rows;
    }

private:
    std::vector<Share> parts_of(std::size_t kind) {
        const Surroundings whole = kinds_[kind];
        // All parts of the piece and of those around it, each with its owners; 0 is the piece.
        std::map<Placement, std::vector<std::size_t>> parts;
        const auto add = [&](const Placement& owner, std::size_t number) {
            for (const RecurrentSet::Part& part : parts_within(set_, owner.piece)) {
                auto& owners = parts[placed(set_, owner, part)];
                if (owners.empty() || owners.back() != number) owners.push_back(number);
            }
        };
        add({whole.piece, 0, here_.offset}, 0);
        for (std::size_t i = 0; i < whole.others.size(); ++i) add(whole.others[i], i + 1);
        std::vector<Share> found;
        for (const auto& [part, owners] : parts) {
            if (owners.front() != 0) continue;
            Surroundings around{part.piece, {}};
            for (const auto& [other, others_owners] : parts) {
                if (other == part) continue;
                const Placement seen = seen_from(set_, part, other);
                const Placement back = seen_from(set_, other, part);
                if (is_critical(part.piece, seen) || is_critical(other.piece, back))
                    around.others.push_back(seen);
            }
            std::sort(around.others.begin(), around.others.end());
            found.push_back({number(std::move(around)), static_cast<long>(owners.size())});
        }
        return found;
    }

    bool is_critical(std::size_t piece, const Placement& other) const {
        const auto pair = neighbours_.find(piece, other);
        return pair && neighbours_.leads_to_coincidence()[*pair];
    }

    const RecurrentSet& set_;
    const Neighbours& neighbours_;
    const Budget& budget_;
    std::size_t most_;
    Placement here_;
    std::map<Surroundings, std::size_t> numbers_;
    std::vector<Surroundings> kinds_;
};

/// rate / scale, an algebraic integer because it is the rate of a sequence of integers (Fatou).
Rate divided(const Rate& rate, const Integer& scale, const Rational& above) {
    const Polynomial& polynomial = rate.minimal_polynomial();
    std::vector<Integer> coefficients;
    const auto degree = static_cast<std::uint64_t>(polynomial.degree());
    for (std::uint64_t i = 0; i <= degree; ++i)
        coefficients.push_back(exact_divide(polynomial.coefficient(i), power(scale, degree - i)));
    return Rate(Polynomial(std::move(coefficients)), above);
}

}  // namespace

DistinctGrowth distinct_growth(const RecurrentSet& set, std::size_t component,
                               const Neighbours& neighbours, const Budget& budget,
                               std::size_t most) {
    Census census(set, neighbours, budget, most);
    const auto rows = census.all(set.components().list[component].letters.front());
    Integer scale = 1;
    for (const auto& row : rows)
        for (const auto& share : row) scale = lcm(scale, Integer(share.sharers));
    GrowthMatrix matrix;
    Integer widest = 1;
    for (const auto& row : rows) {
        std::map<std::size_t, Integer> counts;
        Integer sum;
        for (const auto& share : row) {
            counts[share.kind] += exact_divide(scale, Integer(share.sharers));
            sum += exact_divide(scale, Integer(share.sharers));
        }
        if (widest < sum) widest = sum;
        auto& entries = matrix.rows.emplace_back();
        for (const auto& [kind, times] : counts) entries.push_back({kind, times});
    }
    std::vector<Integer> start(rows.size()), ones(rows.size(), Integer(1));
    start[0] = 1;
    const Polynomial polynomial = annihilator(start, matrix, ones, budget);
    DistinctGrowth found;
    found.kinds = rows.size();
    std::vector<Integer> level = start;
    Integer divisor = 1;
    for (std::size_t n = 0; n < counted_levels; ++n) {
        Integer sum;
        for (const Integer& count : level) sum += count;
        found.first_counts.push_back(exact_divide(sum, divisor));
        level = level * matrix;
        divisor *= scale;
    }
    found.rate = divided(spectral_radius(factorise(polynomial).powers, Rational(widest + 1)), scale,
                         Rational(widest + 1, scale));
    return found;
}

}  // namespace algae
