#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "system/solid_setting.hpp"
#include "turtle/pose.hpp"
#include "turtle/solid_shape.hpp"

namespace algae {

/// What modules of a symbol mean that a file declares with `solid`.
class SolidModule {
public:
    /// The kind must be one of solid_kinds(), the measures some of its own.
    explicit SolidModule(const SolidSetting& setting);

    /// The solid's shape; none if the module turns or moves the turtle.
    std::optional<SolidShape> shape() const;
    /// Whether it turns the turtle, by degrees about its heading, left and up in this order.
    bool is_rotation() const { return kind_ == rotation; }

    /// The measures that so many parameters give, as Solid has them, in steps: of a box along
    /// heading, left and up, of a cylinder and a cone height and radius, of a sphere the radius; of a
    /// rotation and a translation x, y and z. Solids are 1 where nothing is said, the others 0.
    Vector size(const double* values, std::uint32_t count) const;
    /// The parameter that is the number of the colour, if there is one.
    std::optional<double> colour(const double* values, std::uint32_t count) const;

private:
    enum Kind : std::uint8_t { box, cylinder, cone, sphere, rotation, translation };
    static constexpr std::uint32_t absent = UINT32_MAX;

    std::optional<double> measure(std::size_t number, const double* values,
                                  std::uint32_t count) const;

    Kind kind_ = box;
    std::array<std::uint32_t, 4> parameters_{};  // by measure of the kind: the parameter's number
};

}  // namespace algae
