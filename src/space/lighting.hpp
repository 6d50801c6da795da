#pragma once

#include "space/camera.hpp"
#include "system/settings.hpp"

namespace algae {

/// Where the light comes from, as a camera is placed: azimuth and elevation in degrees.
struct Light {
    double azimuth = 0, elevation = 0;
    bool operator==(const Light&) const = default;
};

/// The light over the left shoulder of somebody who looks through this camera.
///
/// Example: usual_light(Camera{-90, 0}) == Light{-130, 40}
Light usual_light(const Camera& camera);

/// Throws Error unless both angles are finite and the elevation is -90 to 90.
void check_light(const Light& light);

/// The colours of lit surfaces: light from one direction, some from everywhere, and haze that takes
/// away from what is far (Foley, van Dam, Feiner and Hughes 1990, 16.1).
class Lighting {
public:
    /// `fog` is the share of the background in the colour of what lies at the depth `farthest`; none
    /// at `nearest`.
    Lighting(const Light& light, double fog, const Colour& background, double farthest,
             double nearest);

    /// A surface of this colour with this unit normal, at this depth.
    Colour operator()(const Colour& colour, const Vector& normal, double depth) const {
        return at_depth(lit(colour, dot(normal, toward_)), depth);
    }
    /// What `dot(normal, light)` makes of a colour, without fog.
    static Colour lit(const Colour& colour, double cosine);
    /// A colour seen through the fog.
    Colour at_depth(const Colour& colour, double depth) const;
    const Vector& toward() const { return toward_; }

private:
    Vector toward_;
    double fog_, farthest_, nearest_;
    Colour background_;
};

}  // namespace algae
