#pragma once

#include <cstdint>

namespace algae {

/// The solids that a turtle may leave where it stands.
enum class SolidShape : std::uint8_t { box, cylinder, cone, sphere };

}  // namespace algae
