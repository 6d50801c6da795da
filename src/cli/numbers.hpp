#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "exact/integer.hpp"

namespace algae::cli {

/// A generation or a count as written on the command line. `option` is named in the message.
/// Throws Error unless it is a whole number from 0 to 2^63 - 1.
std::uint64_t natural(const std::string& option, const std::string& text);

/// "5" or "0..6". Throws Error as `natural` does, and if the range goes down or has more than
/// 100,000 members.
std::pair<std::uint64_t, std::uint64_t> range(const std::string& option, const std::string& text);

/// A number of bytes: "500000", "512M", "2G". Throws Error.
std::uint64_t bytes(const std::string& option, const std::string& text);

/// A positive number of any kind ("600", "12.5"). Throws Error.
double positive(const std::string& option, const std::string& text);

/// The parts of a list with commas between. Throws Error if one is empty.
std::vector<std::string> list(const std::string& option, const std::string& text);

/// An integer in JSON: a number while every reader can hold it (below 2^53), otherwise its digits
/// as a string.
nlohmann::json json_number(const Integer& value);

/// The digits; of more than 60 the first ones and how many there are.
std::string readable(const Integer& value);

}  // namespace algae::cli
