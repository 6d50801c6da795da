#pragma once

#include <utility>

#include "space/scene.hpp"
#include "turtle/canvas.hpp"

namespace algae {

/// Where a figure in space is looked at from. It always looks at the middle of the figure, with z
/// upward, from so far that all of it is seen.
struct Camera {
    double azimuth = -60;   // where the camera stands: degrees from +x towards +y, seen from above
    double elevation = 15;  // degrees above the horizon, -90 to 90
    bool perspective = false;  // near things are larger
    double opening = 40;  // of a perspective: degrees of the cone that holds the figure, 1 to 170

    bool operator==(const Camera&) const = default;
};

/// Throws Error, naming what is wrong, unless all angles are finite and within the bounds above.
void check_camera(const Camera& camera);

/// The unit vector from the figure towards something that stands there.
///
/// Example: direction_of(-90, 0) == Vector{0, -1, 0}
Vector direction_of(double azimuth, double elevation);

/// A point as a camera sees it: its place in the plane, how near it is (larger is nearer) and how
/// much larger than far away things look there. Straight lines stay straight and planes plane, in
/// perspective too: depth is measured so.
struct Seen {
    double x = 0, y = 0, depth = 0, scale = 1;
    bool operator==(const Seen&) const = default;
};

/// What a camera makes of points. In perspective, lengths in the middle of the figure stay what they
/// are (Foley, van Dam, Feiner and Hughes 1990, 6.5).
class Projection {
public:
    /// Sees everything in the box. Throws Error as check_camera.
    Projection(const Camera& camera, const SpaceBox& box);

    Seen operator()(const Vector& place) const {
        const double across = dot(right_, place), up = dot(up_, place), near = dot(toward_, place);
        if (distance_ == 0) return {across, up, near, 1};
        const double scale = distance_ / (distance_ - (near - near_));
        return {across_ + (across - across_) * scale, upward_ + (up - upward_) * scale,
                near_ + (near - near_) * scale, scale};
    }
    /// The corners of the box around the outline of a ball, as it is seen. Away from the middle of a
    /// perspective the outline is an ellipse around another place than its middle's.
    std::pair<Point, Point> outline(const Vector& middle, double radius) const;
    /// The unit vector from a place towards the camera.
    Vector to_camera(const Vector& place) const {
        if (distance_ == 0) return toward_;
        const Vector way = eye_ - place;
        return (1 / length(way)) * way;
    }
    /// What is to the right, upward and toward the camera in the picture.
    const Vector& right() const { return right_; }
    const Vector& up() const { return up_; }
    const Vector& toward() const { return toward_; }

private:
    Vector right_, up_, toward_, eye_;
    double distance_ = 0;                        // of the camera from the middle; 0: from far away
    double across_ = 0, upward_ = 0, near_ = 0;  // of the middle
};

}  // namespace algae
