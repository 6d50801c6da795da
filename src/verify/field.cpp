#include "verify/field.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace algae::verify {

namespace {

const char* found(JsonValue::Kind kind) {
    switch (kind) {
        case JsonValue::Kind::null:
            return "null";
        case JsonValue::Kind::truth:
            return "true or false";
        case JsonValue::Kind::number:
            return "a number";
        case JsonValue::Kind::real:
            return "a number that is negative or not whole";
        case JsonValue::Kind::text:
            return "a string";
        case JsonValue::Kind::list:
            return "a list";
        case JsonValue::Kind::object:
            break;
    }
    return "an object";
}

}  // namespace

void Field::expect(JsonValue::Kind kind, const char* what) const {
    if (value_->kind != kind)
        fail(std::string("expected ") + what + ", found " + found(value_->kind));
}

void Field::only(std::initializer_list<std::string_view> names) const {
    expect(JsonValue::Kind::object, "an object");
    for (std::size_t i = 0; i < value_->keys.size(); ++i)
        if (std::find(names.begin(), names.end(), value_->keys[i]) == names.end())
            inside(value_->items[i], "").fail("unexpected field '" + value_->keys[i] + "'");
}

bool Field::has(std::string_view name) const {
    expect(JsonValue::Kind::object, "an object");
    return std::find(value_->keys.begin(), value_->keys.end(), name) != value_->keys.end();
}

Field Field::at(std::string_view name) const {
    expect(JsonValue::Kind::object, "an object");
    const auto key = std::find(value_->keys.begin(), value_->keys.end(), name);
    if (key == value_->keys.end()) fail("the field '" + std::string(name) + "' is missing");
    return inside(value_->items[static_cast<std::size_t>(key - value_->keys.begin())],
                  (path_.empty() ? "" : ".") + std::string(name));
}

std::vector<Field> Field::list() const {
    expect(JsonValue::Kind::list, "a list");
    std::vector<Field> all;
    for (std::size_t i = 0; i < value_->items.size(); ++i)
        all.push_back(inside(value_->items[i], "[" + std::to_string(i) + "]"));
    return all;
}

std::pair<Field, Field> Field::pair() const {
    auto all = list();
    if (all.size() != 2) fail("expected a list of two, found one of " + std::to_string(all.size()));
    return {all[0], all[1]};
}

std::vector<std::pair<std::string, Field>> Field::object() const {
    expect(JsonValue::Kind::object, "an object");
    std::vector<std::pair<std::string, Field>> all;
    for (std::size_t i = 0; i < value_->items.size(); ++i)
        all.emplace_back(value_->keys[i], inside(value_->items[i], "." + value_->keys[i]));
    return all;
}

const std::string& Field::text() const {
    expect(JsonValue::Kind::text, "a string");
    return value_->text;
}

bool Field::truth() const {
    expect(JsonValue::Kind::truth, "true or false");
    return value_->truth;
}

std::uint64_t Field::number() const {
    const Integer number = integer();
    if (!number.fits_uint64()) fail("the number is too large here");
    return number.to_uint64();
}

Integer Field::integer(bool negative) const {
    if (value_->kind == JsonValue::Kind::number) return value_->number;
    expect(JsonValue::Kind::text, "a whole number or a string of digits");
    std::string_view digits = value_->text;
    if (negative && digits.starts_with('-')) digits.remove_prefix(1);
    if (digits.empty() ||
        !std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; }))
        fail("expected digits");
    return Integer(value_->text);
}

void Field::fail(const std::string& what) const {
    throw Error(*file_ + ":" + std::to_string(line()) + ": " + (path_.empty() ? "" : path_ + ": ") +
                what);
}

void Field::refuse(const std::string& why) const { throw Flaw{path_, line(), why}; }

}  // namespace algae::verify
