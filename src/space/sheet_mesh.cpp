#include "space/sheet_mesh.hpp"

#include <algorithm>
#include <bit>

#include "base/error.hpp"
#include "space/polygon_triangles.hpp"

namespace algae {

namespace {

constexpr std::uint32_t none = 0xFFFFFFFF;
constexpr std::size_t most_smoothed = 64;

/// The points of a mesh by where they are; equal places are one point.
class Places {
public:
    Places(MeshBuilder& builder, std::size_t corners)
        : builder_(builder), slots_(std::bit_ceil(2 * corners + 1), none) {}

    std::uint32_t point(const Vector& v) {
        const Vector place{v.x + 0.0, v.y + 0.0, v.z + 0.0};  // -0 is 0
        std::uint64_t hash = 0;
        for (const double x : {place.x, place.y, place.z}) {
            hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 0x9E3779B97F4A7C15u;
            hash ^= hash >> 29;
        }
        const std::size_t mask = slots_.size() - 1;
        for (std::size_t i = hash & mask;; i = (i + 1) & mask) {
            if (slots_[i] == none) return slots_[i] = builder_.point(place);
            if (builder_.mesh.points[slots_[i]] == place) return slots_[i];
        }
    }

private:
    MeshBuilder& builder_;
    std::vector<std::uint32_t> slots_;
};

/// The polygons that meet in each point, and the corners they have made there.
class Meetings {
public:
    Meetings(std::span<const std::uint32_t> points, std::span<const std::uint32_t> owners,
             std::uint32_t first_point, std::size_t count)
        : first_point_(first_point),
          starts_(count + 1),
          faces_(points.size()),
          corners_(points.size(), none) {
        for (const std::uint32_t p : points) ++starts_[p - first_point + 1];
        for (std::size_t i = 0; i < count; ++i) starts_[i + 1] += starts_[i];
        std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
        for (std::size_t i = 0; i < points.size(); ++i)
            faces_[next[points[i] - first_point]++] = owners[i];
    }
    std::span<const std::uint32_t> faces(std::uint32_t point) const {
        const std::uint32_t at = point - first_point_;
        return std::span(faces_).subspan(starts_[at], starts_[at + 1] - starts_[at]);
    }
    std::span<std::uint32_t> corners(std::uint32_t point) {
        const std::uint32_t at = point - first_point_;
        return std::span(corners_).subspan(starts_[at], starts_[at + 1] - starts_[at]);
    }

private:
    std::uint32_t first_point_;
    std::vector<std::uint32_t> starts_, faces_, corners_;
};

class Sheets {
public:
    Sheets(MeshBuilder& builder, const Scene& scene, double crease, const Budget& budget)
        : builder_(builder), scene_(scene), crease_(crease), budget_(budget) {}

    void add() {
        const auto first_point = static_cast<std::uint32_t>(builder_.mesh.points.size());
        gather();
        Meetings meetings(points_, owners_, first_point, builder_.mesh.points.size() - first_point);
        std::vector<Vector> places;
        std::vector<std::uint32_t> corners;
        for (std::uint32_t f = 0; f < scene_.faces.size(); ++f) {
            if (f % 4096 == 0) budget_.check();
            const std::uint32_t first = starts_[f], count = starts_[f + 1] - first;
            if (areas_[f] == Vector{}) continue;
            places.clear();
            for (std::uint32_t i = 0; i < count; ++i)
                places.push_back(builder_.mesh.points[points_[first + i]]);
            const auto triangles = polygon_triangles(places, budget_);
            if (triangles.empty()) continue;
            builder_.paint(scene_.faces[f].paint);
            corners.assign(count, none);
            for (const auto& triangle : triangles) {
                for (const std::uint32_t i : triangle)
                    if (corners[i] == none) corners[i] = corner(meetings, points_[first + i], f);
                builder_.triangle(corners[triangle[0]], corners[triangle[1]], corners[triangle[2]]);
            }
        }
    }

private:
    /// Points of all polygons without repetitions next to each other, and their areas.
    void gather() {
        Places places(builder_, scene_.corners.size());
        std::vector<Vector> around;
        for (std::uint32_t f = 0; f < scene_.faces.size(); ++f) {
            if (f % 4096 == 0) budget_.check();
            const std::uint32_t first = static_cast<std::uint32_t>(points_.size());
            starts_.push_back(first);
            around.clear();
            for (const Vector& c : scene_.corners_of(scene_.faces[f])) {
                const std::uint32_t p = places.point(c);
                if (points_.size() > first && points_.back() == p) continue;
                points_.push_back(p);
            }
            while (points_.size() > first + 1 && points_.back() == points_[first])
                points_.pop_back();
            for (std::size_t i = first; i < points_.size(); ++i)
                around.push_back(builder_.mesh.points[points_[i]]);
            areas_.push_back(normal_of(around));
            owners_.resize(points_.size(), f);
        }
        starts_.push_back(static_cast<std::uint32_t>(points_.size()));
    }
    /// Twice the area, or that of the first triangle of what winds both ways.
    Vector normal_of(std::span<const Vector> around) const {
        const Vector whole = twice_area(around);
        if (length(whole) > 0) return whole;
        const auto triangles = polygon_triangles(around, budget_);
        if (triangles.empty()) return {};
        const auto& [a, b, c] = triangles.front();
        return cross(around[b] - around[a], around[c] - around[a]);
    }
    std::uint32_t corner(Meetings& meetings, std::uint32_t point, std::uint32_t face) {
        const Vector own = (1 / length(areas_[face])) * areas_[face];
        Vector normal = own;
        const auto faces = meetings.faces(point);
        if (faces.size() <= most_smoothed) {
            Vector sum;
            for (const std::uint32_t other : faces) {
                const Vector& area = areas_[other];
                if (dot(area, own) >= crease_ * length(area) && !(area == Vector{}))
                    sum = sum + area;
            }
            if (length(sum) > 0) normal = (1 / length(sum)) * sum;
        }
        for (std::uint32_t& known : meetings.corners(point)) {
            if (known == none) return known = builder_.corner(point, normal);
            const Mesh::Corner& c = builder_.mesh.corners[known];
            if (c.paint == builder_.current_paint() && dot(c.normal, normal) > 1 - 1e-12)
                return known;
            if (faces.size() > most_smoothed) break;
        }
        return builder_.corner(point, normal);
    }

    MeshBuilder& builder_;
    const Scene& scene_;
    double crease_;
    const Budget& budget_;
    std::vector<std::uint32_t> points_, owners_, starts_;  // corners of polygons as points
    std::vector<Vector> areas_;
};

}  // namespace

void add_sheets(MeshBuilder& builder, const Scene& scene, double crease, const Budget& budget) {
    Sheets(builder, scene, crease, budget).add();
}

}  // namespace algae
