#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace algae {

/// A fenced block of a lesson's Markdown: ```KIND name=FILE or region=FILE#NAME.
struct Fence {
    std::string kind, name, region;
    std::string_view text;  // its lines, each with its line break
};

/// The fenced blocks of a text, in order. They refer to it. One that is not closed ends with the text. Linear.
///
/// Example: fences("Look:\n```lsys name=a.lsys\naxiom a\n```\n").at(0).text == "axiom a\n"
std::vector<Fence> fences(std::string_view markdown);

/// The lines between `//> NAME` and `//< NAME` in a file of code, moved to the left by what the first of
/// them is indented by; empty if it is not there. Linear.
///
/// Example: region_of("//> one\n    int a;\n//< one\n", "one") == "int a;\n"
std::string region_of(std::string_view code, std::string_view name);

}  // namespace algae
