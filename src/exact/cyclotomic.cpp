#include "exact/cyclotomic.hpp"

#include <algorithm>
#include <array>
#include <mutex>

#include "base/error.hpp"
#include "exact/cyclotomic_context.hpp"
#include "exact/flint.hpp"

namespace algae {

namespace {

/// Contexts cost some milliseconds to build for large orders: those in use are shared, and the last
/// few stay.
template <class Context>
class Shelf {
public:
    std::shared_ptr<const Context> find(long order) {
        const std::lock_guard lock(mutex_);
        std::shared_ptr<const Context> context = known_[order].lock();
        if (!context) {
            context = std::make_shared<const Context>(order);
            known_[order] = context;
            recent_[next_++ % recent_.size()] = context;
        }
        return context;
    }

private:
    std::mutex mutex_;
    std::map<long, std::weak_ptr<const Context>> known_;
    std::array<std::shared_ptr<const Context>, 8> recent_;
    std::size_t next_ = 0;
};

}  // namespace

CyclotomicRing::CyclotomicRing(long order) {
    if (order < 1 || order > largest_order)
        throw Error("expected a cyclotomic order from 1 to " + std::to_string(largest_order) +
                    ", found " + std::to_string(order));
    static Shelf<Context> shelf;
    context_ = shelf.find(order);
}

long CyclotomicRing::order() const { return static_cast<long>(context_->order); }
std::size_t CyclotomicRing::degree() const { return context_->degree; }

CyclotomicInteger CyclotomicRing::zero() const { return {std::vector<Integer>(degree())}; }
CyclotomicInteger CyclotomicRing::one() const { return integer(1); }

CyclotomicInteger CyclotomicRing::integer(const Integer& value) const {
    CyclotomicInteger result = zero();
    result.coefficients.front() = value;
    return result;
}

CyclotomicInteger CyclotomicRing::zeta(std::int64_t exponent) const {
    CyclotomicInteger result = zero();
    context_->add_power(result.coefficients, context_->reduced(exponent), 1);
    return result;
}

std::span<const std::int64_t> CyclotomicRing::power(std::int64_t exponent) const {
    return std::span(context_->dense_powers())
        .subspan(context_->reduced(exponent) * degree(), degree());
}

void CyclotomicRing::add(CyclotomicInteger& left, const CyclotomicInteger& right) const {
    for (std::size_t i = 0; i < left.coefficients.size(); ++i)
        left.coefficients[i] += right.coefficients[i];
}

void CyclotomicRing::subtract(CyclotomicInteger& left, const CyclotomicInteger& right) const {
    for (std::size_t i = 0; i < left.coefficients.size(); ++i)
        left.coefficients[i] -= right.coefficients[i];
}

void CyclotomicRing::negate(CyclotomicInteger& value) const {
    for (Integer& coefficient : value.coefficients) coefficient.negate();
}

void CyclotomicRing::scale(CyclotomicInteger& value, const Integer& factor) const {
    for (Integer& coefficient : value.coefficients) coefficient *= factor;
}

void CyclotomicRing::add_rotated(CyclotomicInteger& left, const CyclotomicInteger& right,
                                 std::int64_t exponent) const {
    if (&left == &right) return add_rotated(left, CyclotomicInteger(right), exponent);
    const std::size_t k = context_->reduced(exponent);
    for (std::size_t j = 0; j < context_->degree; ++j)
        if (!right.coefficients[j].is_zero())
            context_->add_power(left.coefficients, context_->add_exponents(j, k),
                                right.coefficients[j]);
}

CyclotomicInteger CyclotomicRing::rotate(const CyclotomicInteger& value,
                                         std::int64_t exponent) const {
    CyclotomicInteger result = zero();
    add_rotated(result, value, exponent);
    return result;
}

CyclotomicInteger CyclotomicRing::multiply(const CyclotomicInteger& left,
                                           const CyclotomicInteger& right) const {
    const Polynomial product = Polynomial(left.coefficients) * Polynomial(right.coefficients);
    CyclotomicInteger result = zero();
    for (std::size_t j = 0; j < product.coefficients().size(); ++j)
        if (!product.coefficients()[j].is_zero())
            context_->add_power(result.coefficients, j % context_->order,
                                product.coefficients()[j]);
    return result;
}

CyclotomicInteger CyclotomicRing::conjugate(const CyclotomicInteger& value) const {
    CyclotomicInteger result = zero();
    for (std::size_t j = 0; j < context_->degree; ++j)
        context_->add_power(result.coefficients, context_->opposite(j), value.coefficients[j]);
    return result;
}

int CyclotomicRing::real_part_sign(const CyclotomicInteger& value) const {
    return context_->sign(value.coefficients, Context::real);
}

int CyclotomicRing::imaginary_part_sign(const CyclotomicInteger& value) const {
    return context_->sign(value.coefficients, context_->imaginary());
}

std::weak_ordering CyclotomicRing::compare_real(const CyclotomicInteger& left,
                                                const CyclotomicInteger& right) const {
    return context_->compare(left.coefficients, right.coefficients, Context::real);
}

std::weak_ordering CyclotomicRing::compare_imaginary(const CyclotomicInteger& left,
                                                     const CyclotomicInteger& right) const {
    return context_->compare(left.coefficients, right.coefficients, context_->imaginary());
}

std::weak_ordering CyclotomicRing::compare_along(const CyclotomicInteger& left,
                                                 const CyclotomicInteger& right,
                                                 std::int64_t exponent) const {
    return context_->compare(left.coefficients, right.coefficients,
                             context_->along(context_->reduced(exponent)));
}

std::complex<double> CyclotomicRing::to_complex(const CyclotomicInteger& value) const {
    std::vector<std::int64_t> coordinates;
    coordinates.reserve(degree());
    for (const Integer& coefficient : value.coefficients) {
        if (!coefficient.fits_int64())
            return {context_->nearest_double(value.coefficients, Context::real),
                    context_->nearest_double(value.coefficients, context_->imaginary())};
        coordinates.push_back(coefficient.to_int64());
    }
    return to_complex(coordinates);
}

std::complex<double> CyclotomicRing::to_complex(std::span<const std::int64_t> coordinates) const {
    const auto nearest = [&](CyclotomicDirection direction) {
        if (const auto found = context_->nearest_by_pairs(coordinates, direction)) return *found;
        return context_->nearest_double({coordinates.begin(), coordinates.end()}, direction);
    };
    return {nearest(Context::real), nearest(context_->imaginary())};
}

Ball CyclotomicRing::real_part(const CyclotomicInteger& value, long bits) const {
    return context_->enclosure(value.coefficients, Context::real, bits);
}

Ball CyclotomicRing::imaginary_part(const CyclotomicInteger& value, long bits) const {
    return context_->enclosure(value.coefficients, context_->imaginary(), bits);
}

std::optional<Rational> CyclotomicRing::real_rational(const CyclotomicInteger& value) const {
    return context_->rational(value.coefficients, Context::real);
}

std::optional<Rational> CyclotomicRing::imaginary_rational(const CyclotomicInteger& value) const {
    return context_->rational(value.coefficients, context_->imaginary());
}

std::string CyclotomicRing::real_decimal(const CyclotomicInteger& value, int digits_after_point,
                                         const Rational& factor) const {
    return context_->decimal(value.coefficients, Context::real, digits_after_point, factor);
}

std::string CyclotomicRing::imaginary_decimal(const CyclotomicInteger& value,
                                              int digits_after_point,
                                              const Rational& factor) const {
    return context_->decimal(value.coefficients, context_->imaginary(), digits_after_point, factor);
}

std::size_t hash_value(const CyclotomicInteger& value) {
    std::uint64_t hash = value.coefficients.size();
    for (const Integer& coefficient : value.coefficients)
        hash = hash * 0x9e3779b97f4a7c15u + hash_value(coefficient);
    return static_cast<std::size_t>(hash);
}

}  // namespace algae
