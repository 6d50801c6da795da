#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "space/mesh.hpp"

namespace algae {

/// The corners of a regular polygon around the origin of a plane, first on the first axis.
class Circle {
public:
    explicit Circle(unsigned sides);
    unsigned sides() const { return static_cast<unsigned>(parts_.size()); }
    /// The unit vector at corner k in the plane of two orthogonal unit vectors.
    Vector at(unsigned k, const Vector& first, const Vector& second) const {
        return parts_[k].first * first + parts_[k].second * second;
    }

private:
    std::vector<std::pair<double, double>> parts_;
};

/// A mesh that grows.
class MeshBuilder {
public:
    /// `colours` is how many the scene's list has, which comes round again.
    explicit MeshBuilder(std::size_t colours) : colours_(colours ? colours : 1) {}

    /// What corners are painted with from here on.
    void paint(const Paint& paint);
    std::uint32_t point(const Vector& place);
    std::uint32_t corner(std::uint32_t point, const Vector& normal);
    /// Corners counter-clockwise seen from outside.
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        mesh.triangles.push_back({a, b, c});
    }
    std::uint32_t point_of(std::uint32_t corner) const { return mesh.corners[corner].point; }
    std::uint32_t current_paint() const { return paint_; }

    Mesh mesh;

private:
    std::size_t colours_;
    std::uint32_t paint_ = 0;
    std::vector<std::uint32_t> sorted_;  // paints by value
};

/// A run of points or corners around something, counter-clockwise seen from its tip.
using Ring = std::vector<std::uint32_t>;

/// A side between two rings of corners, the second toward the tip.
void add_side(MeshBuilder& builder, const Ring& foot, const Ring& tip);
/// Closes a ring of corners by a flat polygon with this outward normal; `at_tip` says which side.
void add_flat_end(MeshBuilder& builder, const Ring& ring, const Vector& normal, bool at_tip);
/// Closes a ring of corners by a cone of corners from it to a point with these outward normals, one
/// for each side of the ring.
void add_point_end(MeshBuilder& builder, const Ring& ring, std::uint32_t tip,
                   const std::vector<Vector>& normals, bool at_tip);

}  // namespace algae
