#pragma once

// A system of particles as time goes by.

#include "nature/nature.hpp"

namespace algae {

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
