#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/space_options.hpp"
#include "render/picture.hpp"
#include "system/lsystem.hpp"
#include "turtle/figure.hpp"

namespace algae::cli {

/// One word of a system, ready to be drawn.
struct FigurePlate {
    std::uint64_t generation = 0;
    std::optional<std::uint64_t> seed;
    std::unique_ptr<Figure> figure;
    std::string name, caption;
};

/// What of a system with choices a picture shows, where it is not the file that says it.
struct PlateChoices {
    std::optional<std::pair<std::uint64_t, std::uint64_t>> seeds;  // a word for each
    std::vector<std::size_t> tables;                               // one for each step
    std::string environment;                                       // the program of --environment
    SpaceOptions space;                                            // for figures in space
    std::optional<std::string> background;                         // of the picture
    std::vector<std::string> colours;                              // instead of those of the file
};

/// The words of a system that a picture shows: its generations, each for every seed.
class FigurePlates {
public:
    /// Throws Error if the system leaves a choice and neither `choices` nor the file says which.
    FigurePlates(const LSystem& system, std::pair<std::uint64_t, std::uint64_t> generations,
                 const PlateChoices& choices, const Budget& budget);

    /// The same caption under every generation.
    void caption(const std::string& text);
    /// Title, generation, angle, and the seed if there are several: "Koch curve, n = 3, 60°".
    void caption_with_facts();

    std::vector<Plate> plates() const;
    std::vector<FigurePlate> figures;

private:
    std::string title_, angle_;
    bool many_seeds_ = false;
};

/// The generations that a file says its figure shows; Throws Error if it says none.
std::pair<std::uint64_t, std::uint64_t> shown_generations(const LSystem& system);

}  // namespace algae::cli
