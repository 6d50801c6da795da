#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "nature/detail/figures.hpp"
#include "nature/detail/particles.hpp"
#include "nature/detail/random.hpp"
#include "watch/watch.hpp"

// Systems of particles (Reeves 1983): their development frame by frame, and pictures of it.
//
// In each frame particles age; what is older than its life dies and may burst into fragments; the
// others move, v = v + a, then p = p + v, and bounce from the ground; then new ones are born.
// Random numbers of a particle depend on the seed and on how many were born before it, each kind of
// number having its own position; those of emitters come from another half of the streams.
//
// A picture shows a sky, the trails of particles, the oldest and faintest parts first, and discs in
// front of them. Opacity is mixed with the colour of the sky. Particles that the view cuts are left
// out, as nothing clips them.

namespace algae {

namespace {

/// What a particle's random numbers are for: the position of each in its draws.
enum Number : std::uint64_t { of_speed, of_angle, of_life, of_size, of_place, of_fragments };
constexpr std::uint64_t emitters_from = std::uint64_t{1} << 63;  // generations of their draws

void check_share(const std::string& what, const ParticleKind& kind, double share) {
    require(share >= 0 && share <= 1, "{} of {}: expected 0 to 1, found {}",
            {what, kind.name, share});
}

void check_positive(const std::string& what, const ParticleKind& kind, const Scatter& chance) {
    require(chance.spread >= 0 && chance.mean - chance.spread >= 0 && std::isfinite(chance.mean),
            "{} of {}: expected numbers from 0 on, found {} +- {}",
            {what, kind.name, chance.mean, chance.spread});
}

void check(const ParticleSystem& system) {
    require(!system.emitters.empty(), "expected an emitter, found no particle that is born");
    for (const Emitter& emitter : system.emitters) {
        require(emitter.kind < system.kinds.size(),
                "an emitter bears particles of a kind that there is not");
        check_positive("the number born", system.kinds[emitter.kind], emitter.count);
        require(emitter.every > 0, "an emitter: expected every 1 frame or more, found 0");
    }
    for (const ParticleKind& kind : system.kinds) {
        check_positive("life", kind, kind.life);
        check_positive("size", kind, kind.size);
        check_positive("the number of fragments", kind, kind.fragments);
        check_share("drag", kind, kind.drag);
        check_share("opacity", kind, kind.opacity_born);
        check_share("opacity", kind, kind.opacity_dying);
        if (kind.bursts_into == ParticleKind::none) continue;
        require(kind.bursts_into < system.kinds.size(), "{} bursts into a kind that there is not",
                {kind.name});
        const ParticleKind& part = system.kinds[kind.bursts_into];
        require(!(part.life.mean - part.life.spread < 1),
                "{}: what something bursts into lives for at least 1 frame, found {} +- {}",
                {part.name, part.life.mean, part.life.spread});
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
            if (k % 4096 == 0) {
                budget_.check();
                budget_.check_memory((particles_.size() + newborn_.size()) * sizeof(Particle),
                                     "a particle system");
            }
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

namespace {

bool holds(const Box& box, Point point, double margin) {
    return point.x - margin >= box.low.x && point.x + margin <= box.high.x &&
           point.y - margin >= box.low.y && point.y + margin <= box.high.y;
}

/// Particles one by one, in the order in which they were born.
class Painter {
public:
    Painter(const Box& view, const Colour& sky) : view_(view), sky_(sky) {
        paths_.push_back(
            {.points = {view.low, {view.high.x, view.low.y}, view.high, {view.low.x, view.high.y}},
             .filled = true,
             .paint = sky});
    }

    void paint(const Particle& particle, const ParticleKind& kind) {
        const double age = particle.life > 0 ? particle.age / particle.life : 0;
        const Colour colour = mixed(kind.born, kind.dying, age);
        const double opacity = kind.opacity_born + age * (kind.opacity_dying - kind.opacity_born);
        Point from = particle.place;
        for (std::size_t i = 0; i < particle.trail.size(); ++i) {
            const Point to = particle.trail[i];
            if (holds(view_, from, particle.size / 2) && holds(view_, to, particle.size / 2)) {
                const double left =
                    1 - static_cast<double>(i + 1) / (static_cast<double>(kind.trail) + 1);
                tails_.push_back({.points = {from, to},
                                  .paint = mixed(sky_, colour, opacity * left),
                                  .length_width = particle.size * (0.35 + 0.5 * left)});
            }
            from = to;
        }
        if (!holds(view_, particle.place, particle.size / 2)) return;
        constexpr int corners = 20;
        Path disc{.points = {}, .filled = true, .paint = mixed(sky_, colour, opacity)};
        for (int k = 0; k < corners; ++k) {
            const double angle = 2 * std::numbers::pi * k / corners;
            disc.points.push_back({particle.place.x + particle.size / 2 * std::cos(angle),
                                   particle.place.y + particle.size / 2 * std::sin(angle)});
        }
        discs_.push_back(std::move(disc));
    }
    std::vector<Path> paths() && {
        // Of trails the oldest, faintest parts first.
        std::reverse(tails_.begin(), tails_.end());
        for (auto* part : {&tails_, &discs_})
            paths_.insert(paths_.end(), std::make_move_iterator(part->begin()),
                          std::make_move_iterator(part->end()));
        return std::move(paths_);
    }

private:
    Box view_;
    Colour sky_;
    std::vector<Path> paths_, tails_, discs_;
};

}  // namespace

void ParticleShow::check() const {
    algae::check(system);
    constexpr std::uint64_t most = most_frames;
    require(!shown.empty(), "show: expected a frame");
    for (const std::uint64_t frame : shown)
        require(frame <= most, "show: expected frames 0 to {}, found {}", {most, frame});
    require(last_frame <= most, "frames: expected 0 to {}, found {}", {most, last_frame});
    require(!view || (view->breadth() > 0 && view->height() > 0),
            "view: expected two corners of a rectangle, found a line or a point");
}

std::vector<GeneratorFigure> ParticleShow::drawn(const std::vector<std::uint64_t>& wanted,
                                                 const Budget& budget) const {
    check();
    std::vector<std::uint64_t> order = wanted;
    std::sort(order.begin(), order.end());
    order.erase(std::unique(order.begin(), order.end()), order.end());
    std::vector<std::vector<Particle>> states;
    ParticleRun run(system, budget);
    std::uint64_t bytes = 0;
    WorkCount frames("frame", order.empty() ? 0 : order.back());
    for (const std::uint64_t frame : order) {
        while (run.frame() < frame) {
            run.advance();
            frames.at(run.frame());
        }
        for (const Particle& particle : run.particles())
            bytes += sizeof(Particle) + particle.trail.size() * 100 + 500;
        budget.check_memory(bytes, "the frames of a particle system");
        states.push_back(run.particles());
    }
    Box box;
    if (view)
        box = *view;
    else
        for (const auto& state : states)
            for (const Particle& particle : state) {
                box.add(Point{particle.place.x - particle.size, particle.place.y - particle.size});
                box.add(Point{particle.place.x + particle.size, particle.place.y + particle.size});
            }
    require(!box.empty, "{}: no particle is alive in the frames shown", {name});
    std::vector<GeneratorFigure> made;
    for (const std::uint64_t frame : wanted) {
        const auto at = static_cast<std::size_t>(
            std::lower_bound(order.begin(), order.end(), frame) - order.begin());
        Painter painter(box, sky);
        for (const Particle& particle : states[at])
            painter.paint(particle, system.kinds[particle.kind]);
        made.push_back(pictured(*this, std::move(painter).paths(), fmt::format("frame {}", frame)));
    }
    return made;
}

std::vector<GeneratorFigure> ParticleShow::figures(const Budget& budget) const {
    return drawn(shown, budget);
}

std::vector<GeneratorFigure> ParticleShow::frames(const Budget& budget) const {
    std::vector<std::uint64_t> all;
    for (std::uint64_t frame = 0; frame <= last_frame; ++frame) all.push_back(frame);
    return drawn(all, budget);
}

std::vector<GeneratorFact> ParticleShow::facts(const Budget& budget) const {
    check();
    ParticleRun run(system, budget);
    std::size_t most = run.particles().size();
    std::uint64_t frame_of_most = 0;
    while (run.frame() < last_frame) {
        run.advance();
        if (run.particles().size() > most) {
            most = run.particles().size();
            frame_of_most = run.frame();
        }
    }
    std::vector<GeneratorFact> found;
    found.push_back({"kinds", std::to_string(system.kinds.size()), system.kinds.size()});
    found.push_back({"seed", std::to_string(system.seed), system.seed});
    found.push_back({"frames", fmt::format("0 to {}", last_frame), last_frame});
    found.push_back({"born", std::to_string(run.born()), run.born()});
    found.push_back({"died", std::to_string(run.died()), run.died()});
    found.push_back({"most_alive",
                     fmt::format("{}, in frame {}", most, frame_of_most),
                     {{"particles", most}, {"frame", frame_of_most}}});
    return found;
}

}  // namespace algae
