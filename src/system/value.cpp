#include "system/value.hpp"

#include <cmath>
#include <utility>

#include "base/error.hpp"

namespace algae {

std::uint64_t bits(const Rational& value) {
    return bit_length(value.numerator()) + bit_length(value.denominator());
}

void fail(const Expression& at, std::string message) {
    throw Diagnostics({Diagnostic{at.place, std::move(message), {}, 0}});
}

std::string shown(const Expression& expression) {
    constexpr std::size_t longest = 60;
    std::string text = to_text(expression);
    if (text.size() <= longest) return text;
    std::size_t length = longest;
    while ((static_cast<unsigned char>(text[length]) & 0xC0) == 0x80) --length;
    return text.substr(0, length) + "...";
}

Value finite(Value value, const Expression& at) {
    if (!std::isfinite(value.rounded)) fail(at, "the value of '" + shown(at) + "' is too large");
    return value;
}

Value exactly(const Rational& value, const Expression& at) {
    Value out{value, value.to_double()};
    if (bits(value) > longest_exact) out.exact.reset();
    return finite(std::move(out), at);
}

Value truth(bool value) { return {Rational(value ? 1 : 0), value ? 1.0 : 0.0}; }

bool is_zero(const Value& value) {
    return value.exact ? value.exact->is_zero() : value.rounded == 0;
}

int compare(const Value& left, const Value& right) {
    if (left.exact && right.exact)
        return *left.exact < *right.exact ? -1 : *right.exact < *left.exact;
    return left.rounded < right.rounded ? -1 : left.rounded > right.rounded;
}

}  // namespace algae
