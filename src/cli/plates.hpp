#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "render/picture.hpp"
#include "system/lsystem.hpp"
#include "turtle/figure.hpp"

namespace algae::cli {

/// One generation of a system, ready to be drawn.
struct FigurePlate {
    std::uint64_t generation = 0;
    std::unique_ptr<Figure> figure;
    std::string name, caption;
};

/// The generations of a system that a picture shows.
class FigurePlates {
public:
    /// `seed` picks one word of a nondeterministic system; a deterministic one needs none.
    FigurePlates(const LSystem& system, std::pair<std::uint64_t, std::uint64_t> generations,
                 std::optional<std::uint64_t> seed, const Budget& budget);

    /// The same caption under every generation.
    void caption(const std::string& text);
    /// Title, generation and angle: "Koch curve, n = 3, 60°".
    void caption_with_facts();

    std::vector<Plate> plates() const;
    std::vector<FigurePlate> figures;

private:
    std::string title_, angle_;
};

/// The generations that a file says its figure shows; Throws Error if it says none.
std::pair<std::uint64_t, std::uint64_t> shown_generations(const LSystem& system);

}  // namespace algae::cli
