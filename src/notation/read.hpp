#pragma once

#include <string>
#include <string_view>

#include "system/lsystem.hpp"

namespace algae {

/// The system that the text of a `.lsys` file says. `file_name` is named in errors and becomes the
/// name of the system. Throws `Diagnostics` with everything that is wrong with the text, at most
/// twenty findings and then how many more there are. Linear time.
///
/// Symbols are numbered in the order of the canonical text (`print_lsystem`): those of `alphabet`,
/// the axiom, the rules, `ignore`, `terminals`, `interpret`.
///
/// Example: read_lsystem("axiom a; a -> ab", "thread.lsys").rules.size() == 1
LSystem read_lsystem(std::string_view text, const std::string& file_name);

/// A word in the form in which words are printed, `F_l[+A(1,0.5)]`; `ε` is the empty word. New
/// symbols are added to the alphabet; names in it that are longer than the notation knows by
/// itself are read as one symbol. Throws `Diagnostics`.
///
/// Example: read_word("ε", *std::make_unique<Alphabet>()).letters.empty()
ModuleWord read_word(std::string_view text, Alphabet& alphabet);

/// An expression over any names: `(x+y)/2`. Throws `Diagnostics`.
///
/// Example: to_text(read_expression("((x+y)/2)")) == "(x+y)/2"
Expression read_expression(std::string_view text);

}  // namespace algae
