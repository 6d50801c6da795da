#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "word/alphabet.hpp"

namespace algae {

/// That a symbol is a solid or moves the turtle, as a file says it: `solid F box height width`. The
/// first parameter of F is then the height and the second the width.
struct SolidSetting {
    Symbol symbol = 0;
    std::string kind;                   // one of solid_kinds()
    std::vector<std::string> measures;  // what the parameters are, in order

    bool operator==(const SolidSetting&) const = default;
};

/// A kind of solids: its name and its measures. Each name has an older one, by which the notation of
/// parametric systems in VRML knew it: `_typeCube` with `_width`.
struct SolidKind {
    struct Name {
        std::string name, reserved;
    };
    Name name;
    std::vector<Name> measures;
};

/// box, cylinder, cone and sphere, which stand around the turtle, rotation and translation, which
/// turn and move it.
///
/// Example: solid_kinds().front().name.name == "box"
const std::vector<SolidKind>& solid_kinds();

/// The kind of that name, by either of its names; null if there is none.
///
/// Example: solid_kind("_typeCube")->name.name == "box"
/// Example: solid_kind("cube") == nullptr
const SolidKind* solid_kind(std::string_view name);

}  // namespace algae
