#pragma once
// For the engine of the static page (tools/engine) only: the algorithms of std::ranges that our sources use. Debian's emscripten has
// libc++ 13, which has the concepts and views of ranges but not their algorithms, nor bit_cast and decimals by from_chars and to_chars. Every source of that build reads this file first.

#include <algorithm>
#include <bit>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

namespace std {  // NOLINT(cert-dcl58-cpp): the library lacks them

template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
    return __builtin_bit_cast(To, from);
}

/// A decimal number as the standard reads it: no blanks, no plus, no hexadecimal digits.
inline from_chars_result from_chars(const char* first, const char* last, double& value) {
    const char* const digits = first != last && *first == '-' ? first + 1 : first;
    const std::string_view rest(digits, static_cast<std::size_t>(last - digits));
    const bool is_word = rest.substr(0, 3) == "inf" || rest.substr(0, 3) == "nan";
    if (rest.empty() || rest.substr(0, 2) == "0x" || rest.substr(0, 2) == "0X" ||
        !((rest[0] >= '0' && rest[0] <= '9') || rest[0] == '.' || is_word))
        return {first, errc::invalid_argument};
    const std::string text(first, last);
    char* end = nullptr;
    errno = 0;
    const double found = std::strtod(text.c_str(), &end);
    if (end == text.c_str()) return {first, errc::invalid_argument};
    const char* const stop = first + (end - text.c_str());
    if (errno == ERANGE) return {stop, errc::result_out_of_range};
    value = found;
    return {stop, errc()};
}

/// A decimal number with so many digits behind the point.
inline to_chars_result to_chars(char* first, char* last, double value, chars_format, int digits) {
    const int size =
        std::snprintf(first, static_cast<std::size_t>(last - first), "%.*f", digits, value);
    if (size < 0 || size >= last - first) return {last, errc::value_too_large};
    return {first + size, errc()};
}

}  // namespace std

namespace std::ranges {  // NOLINT(cert-dcl58-cpp): the library lacks them

namespace engine {

/// A comparison of what a projection shows of two values.
template <class Compare, class Projection>
auto projected_comparison(Compare& compare, Projection& projection) {
    return [&](auto&& a, auto&& b) -> bool {
        return std::invoke(compare, std::invoke(projection, std::forward<decltype(a)>(a)),
                           std::invoke(projection, std::forward<decltype(b)>(b)));
    };
}

/// A condition on what a projection shows of a value.
template <class Condition, class Projection>
auto projected_condition(Condition& condition, Projection& projection) {
    return [&](auto&& a) -> bool {
        return std::invoke(condition, std::invoke(projection, std::forward<decltype(a)>(a)));
    };
}

/// Both ends of a range.
template <class Range>
auto first(Range&& range) {
    return ranges::begin(range);
}
template <class Range>
auto last(Range&& range) {
    return ranges::end(range);
}

}  // namespace engine

template <class Range, class Condition, class Projection = identity>
bool any_of(Range&& range, Condition condition, Projection projection = {}) {
    return std::any_of(engine::first(range), engine::last(range),
                       engine::projected_condition(condition, projection));
}
template <class Range, class Condition, class Projection = identity>
bool all_of(Range&& range, Condition condition, Projection projection = {}) {
    return std::all_of(engine::first(range), engine::last(range),
                       engine::projected_condition(condition, projection));
}
template <class Range, class Condition, class Projection = identity>
bool none_of(Range&& range, Condition condition, Projection projection = {}) {
    return std::none_of(engine::first(range), engine::last(range),
                        engine::projected_condition(condition, projection));
}
template <class Range, class Function>
void for_each(Range&& range, Function function) {
    std::for_each(engine::first(range), engine::last(range), std::move(function));
}
template <class Range, class Value, class Projection = identity>
auto find(Range&& range, const Value& value, Projection projection = {}) {
    return std::find_if(engine::first(range), engine::last(range), [&](auto&& a) -> bool {
        return std::invoke(projection, std::forward<decltype(a)>(a)) == value;
    });
}
template <class Range, class Condition, class Projection = identity>
auto find_if(Range&& range, Condition condition, Projection projection = {}) {
    return std::find_if(engine::first(range), engine::last(range),
                        engine::projected_condition(condition, projection));
}
template <class Range, class Condition, class Projection = identity>
auto find_if_not(Range&& range, Condition condition, Projection projection = {}) {
    return std::find_if_not(engine::first(range), engine::last(range),
                            engine::projected_condition(condition, projection));
}
template <class Range, class Value, class Projection = identity>
auto count(Range&& range, const Value& value, Projection projection = {}) {
    return std::count_if(engine::first(range), engine::last(range), [&](auto&& a) -> bool {
        return std::invoke(projection, std::forward<decltype(a)>(a)) == value;
    });
}
template <class Range, class Condition, class Projection = identity>
auto count_if(Range&& range, Condition condition, Projection projection = {}) {
    return std::count_if(engine::first(range), engine::last(range),
                         engine::projected_condition(condition, projection));
}
template <class Left, class Right>
bool equal(Left&& left, Right&& right) {
    return std::equal(engine::first(left), engine::last(left), engine::first(right),
                      engine::last(right));
}
template <class Left, class Right>
bool lexicographical_compare(Left&& left, Right&& right) {
    return std::lexicographical_compare(engine::first(left), engine::last(left),
                                        engine::first(right), engine::last(right));
}
template <class Range, class Target>
auto copy(Range&& range, Target target) {
    return std::copy(engine::first(range), engine::last(range), target);
}
template <class Range, class Target>
auto move(Range&& range, Target target) {
    return std::move(engine::first(range), engine::last(range), target);
}
template <class Range, class Target, class Function>
auto transform(Range&& range, Target target, Function function) {
    return std::transform(engine::first(range), engine::last(range), target,
                          [&](auto&& a) -> decltype(auto) {
                              return std::invoke(function, std::forward<decltype(a)>(a));
                          });
}
template <class Range, class Value>
void replace(Range&& range, const Value& old_value, const Value& new_value) {
    std::replace(engine::first(range), engine::last(range), old_value, new_value);
}
template <class Range, class Condition, class Value>
void replace_if(Range&& range, Condition condition, const Value& new_value) {
    std::replace_if(engine::first(range), engine::last(range), std::move(condition), new_value);
}
template <class Range>
void reverse(Range&& range) {
    std::reverse(engine::first(range), engine::last(range));
}
template <class Range, class Place>
auto rotate(Range&& range, Place middle) {
    return std::rotate(engine::first(range), middle, engine::last(range));
}
template <class Range, class Compare = less, class Projection = identity>
void sort(Range&& range, Compare compare = {}, Projection projection = {}) {
    std::sort(engine::first(range), engine::last(range),
              engine::projected_comparison(compare, projection));
}
template <class Range, class Compare = less, class Projection = identity>
void stable_sort(Range&& range, Compare compare = {}, Projection projection = {}) {
    std::stable_sort(engine::first(range), engine::last(range),
                     engine::projected_comparison(compare, projection));
}
template <class Range, class Value, class Compare = less, class Projection = identity>
auto lower_bound(Range&& range, const Value& value, Compare compare = {},
                 Projection projection = {}) {
    return std::lower_bound(
        engine::first(range), engine::last(range), value, [&](auto&& a, const Value& b) -> bool {
            return std::invoke(compare, std::invoke(projection, std::forward<decltype(a)>(a)), b);
        });
}
template <class Range, class Value, class Compare = less, class Projection = identity>
bool binary_search(Range&& range, const Value& value, Compare compare = {},
                   Projection projection = {}) {
    const auto found = ranges::lower_bound(range, value, compare, projection);
    return found != engine::last(range) &&
           !std::invoke(compare, value, std::invoke(projection, *found));
}
template <class Range, class Compare = less, class Projection = identity>
auto min_element(Range&& range, Compare compare = {}, Projection projection = {}) {
    return std::min_element(engine::first(range), engine::last(range),
                            engine::projected_comparison(compare, projection));
}
template <class Range, class Compare = less, class Projection = identity>
auto max_element(Range&& range, Compare compare = {}, Projection projection = {}) {
    return std::max_element(engine::first(range), engine::last(range),
                            engine::projected_comparison(compare, projection));
}
template <class Left, class Right, class Target>
auto set_union(Left&& left, Right&& right, Target target) {
    return std::set_union(engine::first(left), engine::last(left), engine::first(right),
                          engine::last(right), target);
}
template <class Left, class Right, class Target>
auto set_intersection(Left&& left, Right&& right, Target target) {
    return std::set_intersection(engine::first(left), engine::last(left), engine::first(right),
                                 engine::last(right), target);
}
template <class Left, class Right, class Target>
auto set_difference(Left&& left, Right&& right, Target target) {
    return std::set_difference(engine::first(left), engine::last(left), engine::first(right),
                               engine::last(right), target);
}

}  // namespace std::ranges
