#pragma once

#include <rapidcheck.h>

#include <iosfwd>
#include <string>
#include <vector>

#include "oracle/random_systems.hpp"

namespace algae::oracle {

/// A deterministic system with contexts as on paper, one character a letter.
struct WrittenInteraction {
    struct Rule {
        std::string left;
        char letter;
        std::string right, successor;
    };
    std::string axiom;
    std::vector<Rule> rules;
    std::string ignored;
    bool trees = false;  // whether brackets fence branches
};
std::ostream& operator<<(std::ostream& out, const WrittenInteraction& system);

/// The next word: the tree is built, and every rule is tried at every letter by trying every way to
/// match its contexts.
std::string after(const WrittenInteraction& system, const std::string& word);

/// Words over a, b, c and perhaps an ignored +, contexts of up to three letters on either side.
rc::Gen<WrittenInteraction> any_interaction(bool trees);

}  // namespace algae::oracle
