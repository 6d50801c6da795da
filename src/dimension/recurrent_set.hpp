#pragma once

#include <complex>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/budget.hpp"
#include "dimension/displacement.hpp"
#include "dimension/unfolding.hpp"
#include "growth/components.hpp"

namespace algae {

/// The set that the curves of a system approach when each generation is drawn as large as the one
/// before (Dekking, Recurrent sets, 1982): a graph-directed self-similar set whose pieces K_a, one
/// for each letter and phase that draws for ever, satisfy
///
///     mu K_a = union over the parts of a of zeta^heading K_part + offset.
///
/// All similarities have the ratio 1/|mu|. Offsets are exact.
class RecurrentSet {
public:
    struct Part {
        std::size_t piece;
        std::int64_t heading;
        Displacement::Vector offset;
        bool operator==(const Part&) const = default;
    };
    /// A disc that holds a piece that begins at 0 and looks along +x.
    struct Disc {
        std::complex<double> centre;
        double radius = 0;
    };

    /// Throws what `Unfolding` and `Displacement` throw; tries more phases where scaling factors are
    /// equally large.
    RecurrentSet(const LSystem& system, const D0L& rules, const Budget& budget = {});

    const Unfolding& unfolding() const { return unfolding_; }
    const Displacement& displacement() const { return displacement_; }
    std::int64_t order() const { return unfolding_.order; }
    std::size_t size() const { return parts_.size(); }

    /// The parts of a piece that draw for ever; none for a piece that does not.
    const std::vector<Part>& parts(std::size_t piece) const { return parts_[piece]; }
    const Disc& disc(std::size_t piece) const { return discs_[piece]; }
    /// The pieces of the axiom that draw for ever.
    const std::vector<Part>& axiom() const { return axiom_; }
    /// The strongly connected components of the pieces, with the rates at which they multiply.
    const Components& components() const { return components_; }
    /// Whether a piece occurs in what the axiom becomes.
    bool is_reached(std::size_t piece) const { return reached_[piece]; }

private:
    RecurrentSet(std::pair<Unfolding, Displacement> parts, const Budget& budget);
    std::vector<Part> walked(const std::vector<Unfolding::Item>& items,
                             const std::vector<bool>& lasting) const;
    void find_reached();
    void find_discs();

    Unfolding unfolding_;
    Displacement displacement_;
    std::vector<std::vector<Part>> parts_;
    std::vector<Part> axiom_;
    std::vector<Disc> discs_;
    std::vector<bool> reached_;
    Components components_;
};

}  // namespace algae
