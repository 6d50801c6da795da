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

}  // namespace algae
