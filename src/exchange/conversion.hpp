#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/budget.hpp"

namespace algae {

/// A way from one text format to another: what the end of a file's name says, and what is made of it.
struct Conversion {
    std::string from, to;
    std::string what;  // "a curve's graph-directed iterated function system"
};

/// All conversions that there are: those between kinds of generators, and for each format of
/// `system_formats` the one into `lsys` and the one out of it.
std::vector<Conversion> conversions();

/// The text in another format. From one of `system_formats` to another it goes by way of `lsys`. In its
/// own format it is the canonical text.
///
/// Throws Diagnostics or Error with the reason where the text is faulty or the other format cannot
/// say it, and Error with the formats that this one can become if there is no such conversion.
std::string converted(std::string_view text, const std::string& name, const std::string& from,
                      const std::string& to, const Budget& budget);

}  // namespace algae
