#include "turtle/detail/view.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

// The camera and the light.
//
// A camera looks at the middle of the box with z upward. Without perspective it is a projection along its
// direction. With perspective the eye stands so far that its cone holds the ball around the box, and all
// lengths in the middle keep their measure (Foley, van Dam, Feiner and Hughes 1990, 6.5). Depth is
// divided by the same factor as width and height, so that straight lines stay straight and planes plane;
// the painter's comparisons rely on that. The outline of a ball seen from the side is an ellipse around
// another place than its middle's: its box comes from the tangents of the eye.
//
// Light is some from everywhere and some from one direction, wrapped a little around the side that looks
// away, with a small highlight; fog mixes in the background by depth (16.1 there).

namespace algae {

namespace {

void check_angle(const char* what, double degrees, double least, double most) {
    if (degrees >= least && degrees <= most) return;
    std::ostringstream message;
    message.exceptions(std::ios::badbit);
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

Colour mixed(const Colour& from, const Colour& to, double share) {
    const auto part = [&](double a, double b) { return a + share * (b - a); };
    return {part(from.red, to.red), part(from.green, to.green), part(from.blue, to.blue)};
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

Light usual_light(const Camera& camera) {
    return {camera.azimuth - 40, std::min(camera.elevation + 40, 80.0)};
}

void check_light(const Light& light) {
    if (!std::isfinite(light.azimuth))
        throw Error("the light's azimuth is not a finite number of degrees");
    if (!(light.elevation >= -90 && light.elevation <= 90))
        throw Error("the light's elevation is " + std::to_string(light.elevation) +
                    " degrees, expected -90 to 90");
}

Lighting::Lighting(const Light& light, double fog, const Colour& background, double farthest,
                   double nearest)
    : toward_(direction_of(light.azimuth, light.elevation)),
      fog_(fog),
      farthest_(farthest),
      nearest_(nearest),
      background_(background) {
    check_light(light);
    if (!(fog >= 0 && fog <= 1))
        throw Error("the fog is " + std::to_string(fog) + ", expected 0 to 1");
}

Colour Lighting::lit(const Colour& colour, double cosine) {
    constexpr double everywhere = 0.42,
                     wrap = 0.25;  // light from all sides; how far light reaches round
    const double share =
        everywhere + (1 - everywhere) * std::max(0.0, (cosine + wrap) / (1 + wrap));
    const double shine = 0.16 * std::pow(std::max(0.0, cosine), 12);
    return mixed({colour.red * share, colour.green * share, colour.blue * share}, {1, 1, 1}, shine);
}

Colour Lighting::at_depth(const Colour& colour, double depth) const {
    if (fog_ == 0 || !(nearest_ > farthest_)) return colour;
    const double away = std::clamp((nearest_ - depth) / (nearest_ - farthest_), 0.0, 1.0);
    return mixed(colour, background_, fog_ * away);
}

}  // namespace algae
