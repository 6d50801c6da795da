#pragma once

#include "environment/environment.hpp"
#include "system/environment_setting.hpp"

namespace algae {

/// What is known from the turtle alone: `x`, `y`, `z`; `position`, its first one, two or three
/// coordinates, as many as the module has parameters; `heading`, with one parameter the degrees from
/// +x in the plane, from 0 to below 360 (0 where it is vertical), with three the vector; `clip`, 1 in
/// the box and on its border, else 0.
class Whereabouts : public Environment {
public:
    /// Of one of these kinds.
    explicit Whereabouts(const EnvironmentSetting& setting) : setting_(setting) {}
    std::vector<std::vector<double>> answers(const Traversal& course,
                                             std::span<const Query* const> queries,
                                             const Budget& budget) override;

private:
    std::vector<double> answer(const Query& query) const;
    bool is_inside(const Vector& place) const;

    EnvironmentSetting setting_;
};

}  // namespace algae
