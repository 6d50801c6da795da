#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "system/lsystem.hpp"
#include "system/view.hpp"
#include "word/hom.hpp"

namespace algae {

/// A deterministic system with interactions, DIL: what a letter becomes depends on the letters
/// around it (Rozenberg and Salomaa 1980, VI; Prusinkiewicz and Lindenmayer 1990, 1.8).
///
/// A rule `left < a > right -> successor` matches a letter a of a word if its left context ends
/// just before a and its right context begins just behind a. All letters are rewritten at once.
/// - Of the rules that match, the one with the most letters in its contexts is used (brackets are
///   not counted), and of equally long ones the first in the file; a letter that none matches stays.
/// - Beyond the ends of a word stands nothing, and no context matches there.
/// - Ignored letters are not seen when contexts are matched, but are rewritten as all others; a
///   context that names one matches nowhere.
///
/// In a system with brackets a word is an axial tree: an axis of letters, and between any two of
/// them branches, `[` tree `]`.
/// - Left context: letters alone. They are the last ones of the path from the root, that is, of
///   what is left before the letter when all branches closed before it are taken away, and the
///   brackets still open.
/// - Right context: an axial tree too. Its letters are the next ones of the axis on which the
///   letter stands; no context goes on behind the end of that axis, where its branch is closed.
///   Its branches between two letters are, each as a right context at the beginning of a branch,
///   in order, some of the branches that the word has there. Other branches are skipped, so `[]`
///   means any branch. At the end of the context the word may go on in any way.
/// - Brackets are rewritten only by rules for them. `[` sees what the first letter of its branch
///   would see on the left, and its branch on the right; `]` sees the path that ends in its branch
///   on the left, and what is behind the branch on the right. A word whose brackets do not match
///   is an error.
///
/// So `BC < S > G[H]M` matches S in ABC[DE][SG[HI[JK]L]MNO]. Where both brackets are ignored,
/// words are no trees, and brackets are ignored letters.
struct IL {
    struct Rule {
        Word left, right;  // contexts, read from left to right; empty ones match anywhere
        Word successor;
    };
    std::shared_ptr<const Alphabet> alphabet;
    Word axiom;
    std::vector<std::vector<Rule>> rules;  // by symbol, in the order in which they are tried
    std::vector<char> ignored;             // by symbol: not seen when contexts are matched
    std::string name;
    std::optional<Brackets> brackets = std::nullopt;  // where words are axial trees
};

/// The system as a deterministic IL system over plain letters, if it is one. Two rules with the
/// same letter and contexts are refused, and contexts whose brackets do not fence branches.
/// O(size of the system).
View<IL> as_il(const LSystem& system);

/// The same system over another alphabet that has all its symbols by name: letters that it does not
/// know stay as they are. Throws Error if a symbol is missing there.
IL over(const IL& system, std::shared_ptr<const Alphabet> alphabet);

}  // namespace algae
