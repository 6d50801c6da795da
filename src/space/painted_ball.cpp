#include <algorithm>
#include <cmath>

#include "space/scene_painter.hpp"

namespace algae {

void ScenePainter::paint_thing(const SeenBall& ball) {
    paint_ball(ball.middle, ball.radius, ball.colour);
}

void ScenePainter::paint_ball(const Seen& middle, double radius, const Colour& colour) {
    const double pixels = lit_.resolution > 0 ? radius / lit_.resolution : 20;
    const Projection& camera = lit_.projection;
    const Vector light = lit_.lighting.toward();
    double x = dot(light, camera.right()), y = dot(light, camera.up()),
           z = std::max(0.05, dot(light, camera.toward()));
    const double size = std::sqrt(x * x + y * y + z * z);
    x /= size, y /= size, z /= size;
    const double aside = std::hypot(x, y), ux = aside > 0 ? x / aside : 1,
                 uy = aside > 0 ? y / aside : 0;
    const int levels = static_cast<int>(std::clamp(pixels * 1.2, 1.0, 40.0));
    const int count = 4 * static_cast<int>(std::clamp(pixels / 2, 3.0, 16.0));
    // What the light meets more directly than a bound is a cap of the ball: one over the other, from
    // the darkest, which is all that is seen of it.
    for (int level = 0; level < levels; ++level) {
        const double darkest = -aside;
        const double bound = darkest + (1 - darkest) * level / levels;
        const double across = level == 0 ? 1 : std::sqrt(std::max(0.0, 1 - bound * bound));
        corners_.clear();
        for (int i = 0; i < count; ++i) {
            const Turn turn = turn_by(360.0 * i / count);
            double px = turn.cosine, py = turn.sine;
            if (level > 0) {
                // A circle about the light, seen from the camera; what lies behind is seen at the rim.
                const double along = bound * aside + across * turn.cosine * z,
                             beside = across * turn.sine;
                const double deep = bound * z - across * turn.cosine * aside;
                px = along * ux - beside * uy;
                py = along * uy + beside * ux;
                const double rim = std::hypot(px, py);
                if (deep < 0 && rim > 0) px /= rim, py /= rim;
            }
            corners_.push_back({middle.x + radius * px, middle.y + radius * py});
        }
        const double cosine = bound + (1 - darkest) * 0.5 / levels;
        polygon(lit_.lighting.at_depth(Lighting::lit(colour, cosine), middle.depth), corners_);
    }
}

}  // namespace algae
