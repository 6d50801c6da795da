#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace algae::verify {

/// A value of a JSON text with the line where it stands. Objects keep their members in order.
struct JsonValue {
    enum class Kind { null, truth, number, real, text, list, object };
    Kind kind = Kind::null;
    bool truth = false;
    std::uint64_t number = 0;  // whole and not negative; other numbers are `real`
    std::string text;
    std::vector<JsonValue> items;   // of a list or object
    std::vector<std::string> keys;  // of an object, one for each item
    std::size_t line = 0;           // counts from 1
};

/// The value that a JSON text holds. Throws Error naming the line where it is none, has a member twice
/// in one object or is followed by something else; BoundReached where lists and objects are nested
/// deeper than 1000 levels.
///
/// Example: algae::verify::parse_json("[1,\n\"a\"]", "x").items.at(1).line == 2
JsonValue parse_json(std::string_view text, const std::string& file);

}  // namespace algae::verify
