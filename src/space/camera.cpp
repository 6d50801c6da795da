#include "space/camera.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "base/error.hpp"

namespace algae {

namespace {

void check_angle(const char* what, double degrees, double least, double most) {
    if (degrees >= least && degrees <= most) return;
    std::ostringstream message;
    message << "the camera's " << what << " is " << degrees << " degrees, expected " << least
            << " to " << most;
    throw Error(message.str());
}

/// Where the two lines from the eye that touch a circle meet the picture, `distance` from the eye. The
/// circle's middle is `aside` of the axis and `ahead` of the eye; `fallback` if the eye is inside.
std::pair<double, double> tangents(double aside, double ahead, double radius, double distance,
                                   double fallback) {
    const double far = std::hypot(aside, ahead);
    if (!(ahead > 0 && far > radius)) return {-fallback, fallback};
    const double middle = std::atan2(aside, ahead), half = std::asin(radius / far);
    if (std::fabs(middle) + half > 0.49 * std::numbers::pi) return {-fallback, fallback};
    return {distance * std::tan(middle - half), distance * std::tan(middle + half)};
}

}  // namespace

void check_camera(const Camera& camera) {
    if (!std::isfinite(camera.azimuth))
        throw Error("the camera's azimuth is not a finite number of degrees");
    check_angle("elevation", camera.elevation, -90, 90);
    if (camera.perspective) check_angle("opening", camera.opening, 1, 170);
}

Vector direction_of(double azimuth, double elevation) {
    const Turn about = turn_by(azimuth), above = turn_by(elevation);
    return {above.cosine * about.cosine, above.cosine * about.sine, above.sine};
}

Projection::Projection(const Camera& camera, const SpaceBox& box) {
    check_camera(camera);
    const Turn about = turn_by(camera.azimuth);
    toward_ = direction_of(camera.azimuth, camera.elevation);
    right_ = {-about.sine, about.cosine, 0};
    up_ = cross(toward_, right_);
    if (!camera.perspective) return;
    const Vector middle = box.low + 0.5 * (box.high - box.low);
    const double radius = box.empty ? 0 : box.diagonal() / 2;
    distance_ = radius > 0 ? radius / std::sin(camera.opening / 2 * (std::numbers::pi / 180)) : 1;
    across_ = dot(right_, middle);
    upward_ = dot(up_, middle);
    near_ = dot(toward_, middle);
    eye_ = middle + distance_ * toward_;
}

std::pair<Point, Point> Projection::outline(const Vector& middle, double radius) const {
    const Seen seen = (*this)(middle);
    const double reach = radius * seen.scale;
    if (distance_ == 0 || radius == 0)
        return {{seen.x - reach, seen.y - reach}, {seen.x + reach, seen.y + reach}};
    const double across = dot(right_, middle) - across_, up = dot(up_, middle) - upward_,
                 ahead = distance_ - (dot(toward_, middle) - near_);
    const auto [left, right] =
        tangents(across, ahead, radius, distance_, std::fabs(seen.x - across_) + reach);
    const auto [below, above] =
        tangents(up, ahead, radius, distance_, std::fabs(seen.y - upward_) + reach);
    return {{across_ + left, upward_ + below}, {across_ + right, upward_ + above}};
}

}  // namespace algae
