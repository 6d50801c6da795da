#pragma once
// The environments that a file can set, and the grid by which they find what is near.

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "turtle/turtle.hpp"

namespace algae {

/// The module as messages name it: "?E(1,2) at position 7 of generation 3".
std::string place_of(const Query& query, const Traversal& course);

/// What the turtle draws and is asked on its way over the word of a generation. `seed` is that of
/// the derivation. Throws what ModuleTurtle throws.
Traversal traversal_of(const Model& system, const ModuleKinds& kinds, const ModuleString& word,
                       std::uint64_t generation, std::uint64_t seed = 1, const Budget& budget = {});

/// The environments of all communication modules of a system: those that its file sets, and without
/// that the position for ?P and the heading for ?H.
class Environments {
public:
    /// `external` answers the modules that the file leaves to a program; it may be missing where there
    /// are none. Throws Error if a module has no environment, ProgramWanted if it is left to a program.
    explicit Environments(const LSystem& system, std::shared_ptr<Environment> external = nullptr);

    /// By query of the course, the new parameters. Throws what the environments throw, and Error if a
    /// module has not as many parameters as its environment fills.
    std::vector<std::vector<double>> answers(const Traversal& course, const Budget& budget);

private:
    struct Asked {
        std::string name, kind;  // of the module and of its environment
        std::shared_ptr<Environment> environment;
        std::vector<std::size_t> arities;  // that the environment can fill; empty: any
    };
    const Asked& asked_by(const std::string& name) const;

    std::vector<Asked> asked_;
    std::vector<std::shared_ptr<Environment>> all_;
};

/// What is known from the turtle alone: `x`, `y`, `z`; `position`, its first one, two or three
/// coordinates, as many as the module has parameters; `heading`, with one parameter the degrees from
/// +x in the plane, from 0 to below 360 (0 where it is vertical), with three the vector; `clip`, 1 in
/// the box and on its border, else 0.
class Whereabouts : public Environment {
public:
    /// Of one of these kinds.
    explicit Whereabouts(const EnvironmentSetting& setting) : setting_(setting) {}
    std::vector<std::vector<double>> answers(const Traversal& course,
                                             std::span<const Query* const> queries,
                                             const Budget& budget) override;

private:
    std::vector<double> answer(const Query& query) const;
    bool is_inside(const Vector& place) const;

    EnvironmentSetting setting_;
};

/// `collision R`: 1 if a line of the word comes within R of the turtle, on the border too, else 0.
/// Lines of the whole word count, before the module and behind it, but not those that meet where the
/// turtle stands (see Joint). O(n log n) for n lines and queries where lines do not crowd.
class CollisionEnvironment : public Environment {
public:
    explicit CollisionEnvironment(double radius) : radius_(radius) {}
    std::vector<std::vector<double>> answers(const Traversal& course,
                                             std::span<const Query* const> queries,
                                             const Budget& budget) override;

private:
    double radius_;
};

/// `light R`: how much of the light from straight above reaches the turtle. It is the radius of the
/// widest vertical column of light around the turtle that no line above the turtle enters, divided
/// by R; 1 if it is R or more, 0 if a line is right above. Lines of the whole word count, but not
/// those that meet where the turtle stands (see Joint), and of each the part above the turtle only.
/// Up is z if the word leaves the plane, y if not. O(n log n) for n lines and queries where lines do
/// not stand above each other in great numbers.
class LightEnvironment : public Environment {
public:
    explicit LightEnvironment(double radius) : radius_(radius) {}
    std::vector<std::vector<double>> answers(const Traversal& course,
                                             std::span<const Query* const> queries,
                                             const Budget& budget) override;

private:
    double radius_;
};

/// How far a point is from the straight line between two others.
///
/// Example: distance({0, 2, 0}, Vector{-1, 0, 0}, Vector{1, 0, 0}) == 2
/// Example: distance({4, 4, 0}, Vector{-1, 0, 0}, Vector{1, 0, 0}) == 5
double distance(const Vector& point, const Vector& from, const Vector& to);

/// Segments by the cells of a grid that they go through, so that those near a point are found without
/// looking at all. A cell is as wide as the radius that is asked for, or as the mean length of the
/// segments where that is more, so that n segments lie in O(n) cells. O(n log n) time.
class SegmentGrid {
public:
    /// `radius` must be above 0 and finite. Throws BoundReached if the grid takes more than
    /// budget.memory.
    SegmentGrid(std::span<const Segment> segments, double radius, const Budget& budget);

    /// Whether `is_wanted(index)` for some segment that may come within the radius of the point: for
    /// all that do, and for some that do not. One segment may be looked at several times.
    template <class IsWanted>
    bool any_near(const Vector& point, IsWanted is_wanted) const {
        const double reach = radius_ + 1e-6 * width_;  // more than what rounding can change
        const Vector out{reach, reach, reach};
        const Cell low = cell(point - out), high = cell(point + out);
        for (std::int64_t x = low.x; x <= high.x; ++x)
            for (std::int64_t y = low.y; y <= high.y; ++y) {
                // Cells that differ in z only lie together.
                auto entry =
                    std::lower_bound(entries_.begin(), entries_.end(), Entry{{x, y, low.z}, 0});
                for (; entry != entries_.end() && entry->cell <= Cell{x, y, high.z}; ++entry)
                    if (is_wanted(entry->segment)) return true;
            }
        return false;
    }

private:
    struct Cell {
        std::int64_t x, y, z;
        auto operator<=>(const Cell&) const = default;
    };
    struct Entry {
        Cell cell;
        std::size_t segment;
        auto operator<=>(const Entry&) const = default;
    };

    Cell cell(const Vector& point) const;
    void add(const Vector& from, const Vector& to, std::size_t segment);

    double radius_, width_;
    std::vector<Entry> entries_;  // sorted
};

}  // namespace algae
