#pragma once
// Boxes cut one after the other, by recursion and over the common denominator of a random system.

#include <iosfwd>
#include <string>
#include <vector>

namespace algae::oracle {

/// A rule for a letter: cuts along some axes, each with whole lengths or whole shares.
struct CutRule {
    struct Size {
        int value = 1;
        bool share = false;
    };
    struct Cut {
        char axis = 'X';
        std::vector<Size> sizes;
    };
    char letter = 'A';
    std::vector<Cut> cuts;  // none: the letter changes and the box stays
    int repeated = 0;       // otherwise the size of repeat along the first cut's axis
    std::string parts;
};

/// Corners instead of sizes, in floating point.
struct CutBox {
    char letter = 'A';
    double low[3] = {0, 0, 0}, high[3] = {1, 1, 1};
};

/// Replaces one box at a time, always the last that can be cut, until every rule has been used on
/// all its boxes. Rules must not lead from a letter to itself. False if some size does not fit.
bool cut_one_by_one(const std::vector<CutRule>& rules, std::vector<CutBox>& boxes);

/// Whether every other box of this letter is further away than `bound` along an axis: whether the
/// box meets none when it is moved by any whole number up to it. Places must be whole.
bool further_than(const std::vector<CutBox>& boxes, std::size_t box, std::size_t axis, char letter,
                  int bound);

/// The rule as the notation has it.
std::string written(const CutRule& rule);
std::ostream& operator<<(std::ostream& out, const CutRule& rule);

}  // namespace algae::oracle
