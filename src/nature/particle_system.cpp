#include "nature/particle_system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/error.hpp"
#include "nature/gaussian.hpp"

namespace algae {

namespace {

/// What a particle's random numbers are for: the position of each in its draws.
enum Number : std::uint64_t { of_speed, of_angle, of_life, of_size, of_place, of_fragments };

constexpr std::uint64_t emitters_from = std::uint64_t{1} << 63;  // generations of their draws

void check_share(const std::string& what, const ParticleKind& kind, double share) {
    if (!(share >= 0 && share <= 1))
        throw Error(fmt::format("{} of {}: expected 0 to 1, found {}", what, kind.name, share));
}

void check_positive(const std::string& what, const ParticleKind& kind, const Scatter& chance) {
    if (!(chance.spread >= 0 && chance.mean - chance.spread >= 0) || !std::isfinite(chance.mean))
        throw Error(fmt::format("{} of {}: expected numbers from 0 on, found {} +- {}", what,
                                kind.name, chance.mean, chance.spread));
}

void check(const ParticleSystem& system) {
    if (system.emitters.empty()) throw Error("expected an emitter, found no particle that is born");
    for (const Emitter& emitter : system.emitters) {
        if (emitter.kind >= system.kinds.size())
            throw Error("an emitter bears particles of a kind that there is not");
        check_positive("the number born", system.kinds[emitter.kind], emitter.count);
        if (emitter.every == 0) throw Error("an emitter: expected every 1 frame or more, found 0");
    }
    for (const ParticleKind& kind : system.kinds) {
        check_positive("life", kind, kind.life);
        check_positive("size", kind, kind.size);
        check_positive("the number of fragments", kind, kind.fragments);
        check_share("drag", kind, kind.drag);
        check_share("opacity", kind, kind.opacity_born);
        check_share("opacity", kind, kind.opacity_dying);
        if (kind.bursts_into == ParticleKind::none) continue;
        if (kind.bursts_into >= system.kinds.size())
            throw Error(fmt::format("{} bursts into a kind that there is not", kind.name));
        const Scatter& life = system.kinds[kind.bursts_into].life;
        if (life.mean - life.spread < 1)
            throw Error(
                fmt::format("{}: what something bursts into lives for at least 1 frame, "
                            "found {} +- {}",
                            system.kinds[kind.bursts_into].name, life.mean, life.spread));
    }
}

/// A whole number from one that is not: rounded so that equal chances stay equal.
std::uint64_t count_of(const Scatter& chance, std::uint64_t number) {
    const double value = chance.spread == 0
                             ? std::round(chance.mean)
                             : std::floor(chance.mean - chance.spread +
                                          unit_interval(number) * (2 * chance.spread + 1));
    return value < 1 ? 0 : static_cast<std::uint64_t>(std::min(value, 1e18));
}

}  // namespace

double Scatter::at(std::uint64_t number) const {
    return mean + spread * (2 * unit_interval(number) - 1);
}

ParticleRun::ParticleRun(ParticleSystem system, const Budget& budget)
    : system_(std::move(system)), budget_(budget) {
    check(system_);
    emit();
    particles_ = std::move(newborn_);
}

void ParticleRun::bear(std::size_t kind, Point place, Point velocity, double size) {
    if (particles_.size() + newborn_.size() >= ParticleSystem::most)
        throw BoundReached(Bound::method,
                           fmt::format("frame {}: more than {} particles are alive at once; let "
                                       "fewer be born or live shorter",
                                       frame_, ParticleSystem::most));
    const ParticleKind& of = system_.kinds[kind];
    const Draws draws(system_.seed, born_);
    const double speed = of.speed.at(draws.at(of_speed));
    const double angle = of.angle.at(draws.at(of_angle)) * (std::numbers::pi / 180);
    Particle particle;
    particle.kind = kind;
    particle.place = place;
    particle.velocity = {of.inherits * velocity.x + speed * std::cos(angle),
                         of.inherits * velocity.y + speed * std::sin(angle)};
    particle.life = of.life.at(draws.at(of_life));
    particle.size = size * of.size.at(draws.at(of_size));
    particle.number = born_++;
    newborn_.push_back(std::move(particle));
}

void ParticleRun::emit() {
    for (std::size_t i = 0; i < system_.emitters.size(); ++i) {
        const Emitter& emitter = system_.emitters[i];
        if (frame_ < emitter.first || frame_ > emitter.last ||
            (frame_ - emitter.first) % emitter.every != 0)
            continue;
        const Draws draws(system_.seed, emitters_from + i);
        const std::uint64_t count = count_of(emitter.count, draws.at(frame_));
        for (std::uint64_t k = 0; k < count; ++k) {
            if (k % 4096 == 0) budget_.check();
            const double share = unit_interval(Draws(system_.seed, born_).at(of_place));
            bear(emitter.kind,
                 {emitter.from.x + share * (emitter.to.x - emitter.from.x),
                  emitter.from.y + share * (emitter.to.y - emitter.from.y)},
                 {0, 0}, 1);
        }
    }
}

void ParticleRun::advance() {
    ++frame_;
    newborn_.clear();
    std::size_t kept = 0;
    for (std::size_t i = 0; i < particles_.size(); ++i) {
        if (i % 4096 == 0) budget_.check();
        Particle& particle = particles_[i];
        const ParticleKind& kind = system_.kinds[particle.kind];
        particle.age += 1;
        if (particle.age > particle.life) {
            if (kind.bursts_into == ParticleKind::none) continue;
            const std::uint64_t count =
                count_of(kind.fragments, Draws(system_.seed, particle.number).at(of_fragments));
            for (std::uint64_t k = 0; k < count; ++k)
                bear(kind.bursts_into, particle.place, particle.velocity, particle.size);
            continue;
        }
        if (kind.trail > 0) {
            particle.trail.insert(particle.trail.begin(), particle.place);
            if (particle.trail.size() > kind.trail) particle.trail.pop_back();
        }
        particle.velocity.x = (1 - kind.drag) * particle.velocity.x + kind.weight * system_.force.x;
        particle.velocity.y = (1 - kind.drag) * particle.velocity.y + kind.weight * system_.force.y;
        particle.place.x += particle.velocity.x;
        particle.place.y += particle.velocity.y;
        if (system_.ground && particle.place.y < *system_.ground) {
            particle.place.y = *system_.ground;
            particle.velocity.y = -system_.bounce * particle.velocity.y;
        }
        if (kept != i) particles_[kept] = std::move(particle);
        ++kept;
    }
    particles_.resize(kept);
    emit();
    particles_.insert(particles_.end(), std::make_move_iterator(newborn_.begin()),
                      std::make_move_iterator(newborn_.end()));
    newborn_.clear();
}

}  // namespace algae
