#include "turtle/coordinate.hpp"

#include <fmt/format.h>

#include <cmath>

namespace algae {

Coordinate::Coordinate(const CyclotomicRing& ring, CyclotomicInteger number, Part part,
                       Rational factor, Rational offset)
    : exact_(Exact{ring, std::move(number), part, std::move(factor), std::move(offset)}) {
    if (const auto known = rational()) {
        value_ = known->to_double();
    } else {
        const auto point = ring.to_complex(exact_->number);
        value_ = (part == Part::real ? point.real() : point.imag()) * exact_->factor.to_double() +
                 exact_->offset.to_double();
    }
}

std::optional<Rational> Coordinate::rational() const {
    if (!exact_) return std::nullopt;
    const auto part = exact_->part == Part::real ? exact_->ring.real_rational(exact_->number)
                                                 : exact_->ring.imaginary_rational(exact_->number);
    if (!part) return std::nullopt;
    return *part * exact_->factor + exact_->offset;
}

std::string Coordinate::decimal(int digits) const {
    if (!exact_) {
        const std::string text = fmt::format("{:.{}f}", value_, digits);
        return text.find_first_of("123456789") == std::string::npos && text.starts_with('-') ? text.substr(1)
                                                                                            : text;
    }
    if (const auto known = rational()) return algae::decimal(*known, digits);
    return algae::decimal(
        [&](long bits) {
            const Ball part = exact_->part == Part::real ? exact_->ring.real_part(exact_->number, bits)
                                                         : exact_->ring.imaginary_part(exact_->number, bits);
            return part * Ball(exact_->factor, bits) + Ball(exact_->offset, bits);
        },
        digits);
}

std::string Coordinate::text(int digits) const {
    std::string text = decimal(digits);
    if (text.find('.') == std::string::npos) return text;
    text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) text.pop_back();
    return text;
}

}  // namespace algae
