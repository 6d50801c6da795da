#include "nature/particle_show.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "nature/path_figure.hpp"

namespace algae {

namespace {

Colour mixed(const Colour& a, const Colour& b, double share) {
    return {a.red + share * (b.red - a.red), a.green + share * (b.green - a.green),
            a.blue + share * (b.blue - a.blue)};
}

bool holds(const Box& box, Point point, double margin) {
    return point.x - margin >= box.low.x && point.x + margin <= box.high.x &&
           point.y - margin >= box.low.y && point.y + margin <= box.high.y;
}

/// Particles one by one, in the order in which they were born.
class Painter {
public:
    Painter(const Box& view, const Colour& sky) : view_(view), sky_(sky) {
        Path back;
        back.points = {view.low, {view.high.x, view.low.y}, view.high, {view.low.x, view.high.y}};
        back.filled = true;
        back.paint = sky;
        paths_.push_back(std::move(back));
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
                Path path;
                path.points = {from, to};
                path.paint = mixed(sky_, colour, opacity * left);
                path.length_width = particle.size * (0.35 + 0.5 * left);
                tails_.push_back(std::move(path));
            }
            from = to;
        }
        if (!holds(view_, particle.place, particle.size / 2)) return;
        constexpr int corners = 20;
        Path disc;
        for (int k = 0; k < corners; ++k) {
            const double angle = 2 * std::numbers::pi * k / corners;
            disc.points.push_back({particle.place.x + particle.size / 2 * std::cos(angle),
                                   particle.place.y + particle.size / 2 * std::sin(angle)});
        }
        disc.filled = true;
        disc.paint = mixed(sky_, colour, opacity);
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
    ParticleRun(system, {});
    if (shown.empty()) throw Error("show: expected a frame");
    for (const std::uint64_t frame : shown)
        if (frame > most_frames)
            throw Error(fmt::format("show: expected frames 0 to {}, found {}", most_frames, frame));
    if (last_frame > most_frames)
        throw Error(fmt::format("frames: expected 0 to {}, found {}", most_frames, last_frame));
    if (view && !(view->breadth() > 0 && view->height() > 0))
        throw Error("view: expected two corners of a rectangle, found a line or a point");
}

std::vector<RelativeFigure> ParticleShow::drawn(const std::vector<std::uint64_t>& wanted,
                                                const Budget& budget) const {
    check();
    std::vector<std::uint64_t> order = wanted;
    std::sort(order.begin(), order.end());
    order.erase(std::unique(order.begin(), order.end()), order.end());
    std::vector<std::vector<Particle>> states;
    ParticleRun run(system, budget);
    std::uint64_t bytes = 0;
    for (const std::uint64_t frame : order) {
        while (run.frame() < frame) run.advance();
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
    if (box.empty) throw Error(name + ": no particle is alive in the frames shown");
    std::vector<RelativeFigure> made;
    for (const std::uint64_t frame : wanted) {
        const auto at = static_cast<std::size_t>(
            std::lower_bound(order.begin(), order.end(), frame) - order.begin());
        Painter painter(box, sky);
        for (const Particle& particle : states[at])
            painter.paint(particle, system.kinds[particle.kind]);
        const std::string what = fmt::format("frame {}", frame);
        made.push_back({std::make_unique<PathFigure>(std::move(painter).paths(), settings),
                        (title.empty() ? name : title) + ", " + what, what});
    }
    return made;
}

std::vector<RelativeFigure> ParticleShow::figures(const Budget& budget) const {
    return drawn(shown, budget);
}

std::vector<RelativeFigure> ParticleShow::frames(const Budget& budget) const {
    std::vector<std::uint64_t> all;
    for (std::uint64_t frame = 0; frame <= last_frame; ++frame) all.push_back(frame);
    return drawn(all, budget);
}

std::vector<RelativeFact> ParticleShow::facts(const Budget& budget) const {
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
    std::vector<RelativeFact> found;
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
