#include "turtle/detail/mesh.hpp"
#include "watch/watch.hpp"

#include <algorithm>
#include <cmath>

// Rods joined into limbs, the bent tubes of meshes.
//
// Of the rods that begin where one ends, the one that goes on (see Rod::branch) is joined to it; the others
// begin limbs of their own. Rods too short to be seen are left out, and what begins at them begins at the
// rod before. At a joint the tube turns by a mitre, which goes back by radius * tan(half the turn) on the
// inner side: where that would take more than half of a rod, or the turn is more than 120 degrees, the limb
// ends, round, and another begins. Straight pieces of one radius and paint become one.

namespace algae {

namespace {

constexpr std::uint32_t none = Rod::none;

/// Which rod goes on from which, with rods too short to be seen left out.
class Joints {
public:
    Joints(const Scene& scene, const Thickness& thickness, const Budget& budget)
        : before_(scene.rods.size(), none),
          next_(scene.rods.size(), none),
          radius_(scene.rods.size()),
          role_(scene.rods.size()) {
        const double shortest = thickness.least / 10;
        for (std::uint32_t i = 0; i < scene.rods.size(); ++i) {
            if (i % 4096 == 0) budget.check();
            const Rod& rod = scene.rods[i];
            if (!is_finite(rod.from) || !is_finite(rod.to) || !std::isfinite(rod.radius) ||
                !std::isfinite(rod.line_width))
                throw Error(scene.name + ": stroke " + std::to_string(i + 1) +
                            " does not lie at finite coordinates");
            const double wide = rod.radius > 0 ? rod.radius : thickness.line * rod.line_width;
            radius_[i] = std::max(wide, thickness.least);
            role_[i].left_out = !(length(rod.to - rod.from) > shortest);
            role_[i].branch = rod.branch;
            if (rod.before >= i) continue;  // there is none
            before_[i] = rod.before;
            if (role_[rod.before].left_out) {
                before_[i] = before_[rod.before];
                role_[i].branch = role_[i].branch || role_[rod.before].branch;
            }
            const std::uint32_t b = before_[i];
            if (b != none && length(scene.rods[b].to - rod.from) > shortest / 10) before_[i] = none;
            if (before_[i] != none && !role_[i].left_out) ++role_[before_[i]].followers;
        }
        join();
    }

    /// Whether a limb begins with this rod.
    bool begins(std::uint32_t rod) const { return !role_[rod].left_out && !role_[rod].joined; }
    std::uint32_t next(std::uint32_t rod) const { return next_[rod]; }
    double radius(std::uint32_t rod) const { return radius_[rod]; }
    /// Whether it is wider where it begins than what it begins in.
    bool sticks_out(std::uint32_t rod) const {
        const std::uint32_t b = before_[rod];
        if (b == none) return false;
        return radius_[rod] > radius_[next_[b] == none ? b : next_[b]] * (1 + 1e-9);
    }
    bool has_followers(std::uint32_t rod) const { return role_[rod].followers > 0; }

private:
    struct Role {
        bool left_out = false, branch = false, joined = false;
        std::uint32_t followers = 0;
    };

    void join() {
        for (const bool branches : {false, true})
            for (std::uint32_t i = 0; i < next_.size(); ++i) {
                const std::uint32_t b = before_[i];
                if (b == none || role_[i].left_out || next_[b] != none) continue;
                if (branches ? role_[b].followers != 1 : role_[i].branch) continue;
                next_[b] = i;
                role_[i].joined = true;
            }
    }

    std::vector<std::uint32_t> before_, next_;
    std::vector<double> radius_;
    std::vector<Role> role_;
};

/// Whether a tube may turn at `at` on its way from `from` to `to` by a mitre.
bool can_turn(const Limbs::Node& from, const Limbs::Node& at, const Limbs::Node& to,
              double share_before, double share_after) {
    const Vector in = at.point - from.point, out = to.point - at.point;
    const double before = length(in), after = length(out);
    const double cosine = dot(in, out) / (before * after);
    if (!(cosine > -0.5 - 1e-9)) return false;
    // The mitre goes back by radius * tan(half the turn) on the inner side.
    const double back = at.radius * std::sqrt(std::max(0.0, (1 - cosine) / (1 + cosine)));
    return back < share_before * before && back < share_after * after;
}

/// Whether the tube goes straight on through `at` unchanged.
bool is_straight(const Scene& scene, const Limbs::Node& from, const Limbs::Node& at,
                 const Limbs::Node& to) {
    if (from.radius != at.radius || at.radius != to.radius) return false;
    if (scene.rods[from.rod].paint != scene.rods[at.rod].paint) return false;
    const Vector in = at.point - from.point, out = to.point - at.point;
    return dot(in, out) > 0 && length(cross(in, out)) <= 1e-12 * length(in) * length(out);
}

/// Adds the limbs of rods that go on from one another.
void add_limbs(Limbs& limbs, const std::vector<Limbs::Node>& chain, bool round_foot,
               bool round_end) {
    const auto add = [&](std::size_t first, std::size_t last, bool foot, bool end) {
        limbs.limbs.push_back({static_cast<std::uint32_t>(limbs.nodes.size()),
                               static_cast<std::uint32_t>(last - first + 1), foot, end});
        limbs.nodes.insert(limbs.nodes.end(), chain.begin() + static_cast<std::ptrdiff_t>(first),
                           chain.begin() + static_cast<std::ptrdiff_t>(last) + 1);
        limbs.nodes.back().rod = chain[last - 1].rod;
    };
    std::size_t first = 0;
    bool foot = round_foot;
    const std::size_t last = chain.size() - 1;
    for (std::size_t i = 1; i < last; ++i) {
        const double before = i == 1 ? 0.98 : 0.49, after = i + 1 == last ? 0.98 : 0.49;
        if (can_turn(chain[i - 1], chain[i], chain[i + 1], before, after)) continue;
        add(first, i, foot, true);
        first = i;
        // The round end hides the flat foot of what goes on, unless it is too short itself.
        foot = length(chain[i].point - chain[i - 1].point) < chain[i].radius;
    }
    add(first, last, foot, round_end);
}

}  // namespace

Thickness thickness(const Scene& scene) {
    const SpaceBox box = box_of(scene);
    const double diagonal = box.diagonal();
    double sum = 0, lines = 0, largest = diagonal;
    for (const Rod& rod : scene.rods) {
        if (rod.radius > 0) continue;
        sum += length(rod.to - rod.from);
        ++lines;
    }
    for (const Vector& v : {box.low, box.high})
        largest = std::max({largest, std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
    if (box.empty || !(largest > 0)) largest = 1;
    const double share = diagonal / 500;
    return {lines > 0 && sum > 0 ? std::min(share, sum / lines / 4) : share, largest * 1e-6};
}

Limbs limbs_of(const Scene& scene, const Thickness& thickness, const Budget& budget) {
    const Joints joints(scene, thickness, budget);
    Limbs limbs;
    std::vector<Limbs::Node> chain;
    WorkCount rods("rod", scene.rods.size());
    for (std::uint32_t i = 0; i < scene.rods.size(); ++i) {
        if (i % 4096 == 0) budget.check();
        rods.at(i);
        if (!joints.begins(i)) continue;
        chain.clear();
        std::uint32_t end = i;
        for (std::uint32_t r = i; r != none; r = joints.next(end = r)) {
            const Limbs::Node node{scene.rods[r].from, joints.radius(r), r};
            const std::size_t n = chain.size();
            if (n >= 2 && is_straight(scene, chain[n - 2], chain[n - 1], node)) chain.pop_back();
            chain.push_back(node);
        }
        const Limbs::Node last{scene.rods[end].to, joints.radius(end), end};
        const std::size_t n = chain.size();
        if (n >= 2 && is_straight(scene, chain[n - 2], chain[n - 1], last)) chain.pop_back();
        chain.push_back(last);
        const bool ring =
            chain.size() > 3 && length(chain.back().point - chain[0].point) <= thickness.least;
        add_limbs(limbs, chain, ring || joints.sticks_out(i), ring || joints.has_followers(end));
    }
    return limbs;
}

bool is_cylinder(const Limbs& limbs, const Limb& limb) {
    const auto nodes = limbs.nodes_of(limb);
    return nodes.size() == 2 && !limb.round_foot && !limb.round_end &&
           nodes[0].radius == nodes[1].radius;
}

}  // namespace algae
