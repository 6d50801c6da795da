#include "space/lighting.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace algae {

namespace {

Colour mixed(const Colour& from, const Colour& to, double share) {
    const auto part = [&](double a, double b) { return a + share * (b - a); };
    return {part(from.red, to.red), part(from.green, to.green), part(from.blue, to.blue)};
}

}  // namespace

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
