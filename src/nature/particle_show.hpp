#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "nature/particle_system.hpp"
#include "nature/relative.hpp"

namespace algae {

/// Frames of a particle system: a sky, and on it the particles as discs in front of their trails.
class ParticleShow : public Relative {
public:
    ParticleSystem system;
    std::vector<std::uint64_t> shown{0};  // the frames of the picture
    std::uint64_t last_frame = 100;       // of the animation
    Colour sky{1, 1, 1};
    std::optional<Box> view;  // none: around all particles of the frames that are drawn

    static constexpr std::uint64_t most_frames = 100'000;

    /// Throws Error on a system or frames that make no sense.
    void check() const;

    std::vector<RelativeFigure> figures(const Budget& budget) const override;
    std::vector<RelativeFigure> frames(const Budget& budget) const override;
    std::vector<RelativeFact> facts(const Budget& budget) const override;

private:
    std::vector<RelativeFigure> drawn(const std::vector<std::uint64_t>& wanted,
                                      const Budget& budget) const;
};

}  // namespace algae
