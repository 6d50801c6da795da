#include "turtle/solid_module.hpp"

#include <algorithm>
#include <string>

#include "base/error.hpp"

namespace algae {

SolidModule::SolidModule(const SolidSetting& setting) {
    const SolidKind* const kind = solid_kind(setting.kind);
    if (!kind) throw Error("expected a kind of solid, found '" + setting.kind + "'");
    kind_ = static_cast<Kind>(kind - solid_kinds().data());
    parameters_.fill(absent);
    for (std::size_t i = 0; i < kind->measures.size(); ++i) {
        const auto at =
            std::find(setting.measures.begin(), setting.measures.end(), kind->measures[i].name);
        if (at != setting.measures.end())
            parameters_[i] = static_cast<std::uint32_t>(at - setting.measures.begin());
    }
}

std::optional<SolidShape> SolidModule::shape() const {
    if (kind_ == rotation || kind_ == translation) return std::nullopt;
    return static_cast<SolidShape>(kind_);
}

std::optional<double> SolidModule::measure(std::size_t number, const double* values,
                                           std::uint32_t count) const {
    if (parameters_[number] >= count) return std::nullopt;
    return values[parameters_[number]];
}

Vector SolidModule::size(const double* values, std::uint32_t count) const {
    const double otherwise = shape() ? 1 : 0;
    const auto said = [&](std::size_t number) {
        return measure(number, values, count).value_or(otherwise);
    };
    if (kind_ == sphere) return {said(0), 0, 0};
    if (kind_ == cylinder || kind_ == cone) return {said(1), said(0), 0};
    return {said(0), said(1), said(2)};
}

std::optional<double> SolidModule::colour(const double* values, std::uint32_t count) const {
    if (!shape()) return std::nullopt;
    return measure(solid_kinds()[kind_].measures.size() - 1, values, count);
}

}  // namespace algae
