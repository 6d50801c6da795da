#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "claim/claim.hpp"
#include "system/lsystem.hpp"

namespace algae {

/// The system that is known by a name: of a gallery entry, or a path, as a claim writes it. What it throws as
/// `Error` becomes a finding at the place of the name; `Stopped` is passed on.
using SystemSource = std::function<LSystem(const std::string& name)>;

/// The claim that the text of a `.claim` file makes (NOTATION.md), over one alphabet. `file_name` is named
/// in errors. Throws `Diagnostics` with everything that is wrong with the text, at most twenty findings and
/// then how many more there are. Linear time but for the letters that images and complements are about.
///
/// Example: read_claim("claim T; show {a} is 0L", "x.claim", {}).statements.size() == 1
Claim read_claim(std::string_view text, const std::string& file_name, const SystemSource& open);

/// A language and the alphabet that its words are over.
struct WrittenLanguage {
    std::shared_ptr<const Alphabet> alphabet;
    Language language;
};

/// The language that an expression says, as in a claim, but that `L(NAME)` opens the system. Throws
/// `Diagnostics`.
///
/// Example: read_language("/a*/ & {a, b}", {}).language->kind == LanguageTree::Kind::intersected
WrittenLanguage read_language(std::string_view text, const SystemSource& open,
                              const std::string& file_name = "expression");

}  // namespace algae
