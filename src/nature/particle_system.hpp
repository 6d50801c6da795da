#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/budget.hpp"
#include "rewrite/draws.hpp"
#include "system/settings.hpp"
#include "turtle/canvas.hpp"

namespace algae {

/// A number that chance picks: evenly from `mean - spread` to `mean + spread`.
struct Scatter {
    double mean = 0, spread = 0;

    /// The value for a random number.
    ///
    /// Example: Scatter{2, 1}.at(0) < 1.001
    double at(std::uint64_t number) const;
    bool operator==(const Scatter&) const = default;
};

/// What particles of a kind have when they are born, and what becomes of them. Times are frames,
/// velocities lengths a frame, angles degrees, counter-clockwise from +x.
struct ParticleKind {
    static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

    std::string name;
    Scatter speed{1, 0}, angle{90, 0};
    Scatter life{50, 0};
    Scatter size{1, 0};                    // diameter; of fragments, a share of what burst
    Colour born{1, 1, 1}, dying{1, 1, 1};  // the colour runs from one to the other
    double opacity_born = 1, opacity_dying = 1;
    double weight = 1;               // share of the forces that act on it
    double drag = 0;                 // share of the velocity that is lost in a frame
    double inherits = 0;             // share of the velocity of what burst
    std::size_t trail = 0;           // frames for which it leaves a trail
    std::size_t bursts_into = none;  // the kind of its fragments, when its life ends
    Scatter fragments{0, 0};         // how many
    bool operator==(const ParticleKind&) const = default;
};

/// Where particles are born: evenly between two points, `count` in each frame from `first` to `last`
/// that is a multiple of `every` after the first.
struct Emitter {
    std::size_t kind = 0;
    Scatter count{1, 0};
    std::uint64_t first = 0, last = std::numeric_limits<std::uint64_t>::max(), every = 1;
    Point from, to;
    bool operator==(const Emitter&) const = default;
};

/// A system of particles (Reeves, Particle systems, ACM Transactions on Graphics 2, 1983).
struct ParticleSystem {
    std::vector<ParticleKind> kinds;
    std::vector<Emitter> emitters;
    Point force;                   // added to each velocity in each frame: (0, -a) is gravity
    std::optional<double> ground;  // particles do not fall below this height, and bounce:
    double bounce = 0;             // the share of the upward speed that is left
    std::uint64_t seed = 1;

    /// The most particles of all frames up to `frames` that may be alive at once.
    static constexpr std::uint64_t most = 10'000'000;
};

/// One particle. `trail` is where it was in the frames before, newest first.
struct Particle {
    std::size_t kind = 0;
    Point place, velocity;
    double age = 0, life = 0, size = 0;
    std::vector<Point> trail;
    std::uint64_t number =
        0;  // how many were born before it; its random numbers depend on it alone

    bool operator==(const Particle&) const = default;
};

/// A system as time goes by. Frame 0 has what is born in it.
class ParticleRun {
public:
    /// Throws Error if a kind or an emitter names a kind that there is none of, if a system has no
    /// emitters, or if values make no sense: lives, sizes and counts below 0, shares beyond 0 to 1.
    ParticleRun(ParticleSystem system, const Budget& budget);

    /// The next frame: what is older than its life dies, and its fragments are born where it was;
    /// the others move, v = v + a and p = p + v; then new ones are born. Throws BoundReached where
    /// more than ParticleSystem::most are alive, Interrupted. O(particles).
    void advance();

    std::uint64_t frame() const { return frame_; }
    const std::vector<Particle>& particles() const { return particles_; }
    const ParticleSystem& system() const { return system_; }
    /// How many were born so far, and how many have died.
    std::uint64_t born() const { return born_; }
    std::uint64_t died() const { return born_ - particles_.size(); }

private:
    void emit();
    void bear(std::size_t kind, Point place, Point velocity, double size);

    ParticleSystem system_;
    Budget budget_;
    std::vector<Particle> particles_, newborn_;
    std::uint64_t frame_ = 0, born_ = 0;
};

}  // namespace algae
