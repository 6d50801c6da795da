#pragma once
// The parts of curves on the square and the triangular lattice, by writing their words out: places
// are pairs of integers, and nothing is known of recurrent sets.

#include <iosfwd>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace algae::oracle {

/// A D0L system over F, G, f, + - and brackets that match in every successor. The successors of F, G
/// and f lead to the same place and turn by the same angle, and so do they in every generation.
struct LatticeSystem {
    bool hexagonal = false;
    std::map<char, std::string> successors;  // of F, G, f

    int order() const { return hexagonal ? 6 : 4; }
    /// In the notation, from F.
    std::string text() const;
};
std::ostream& operator<<(std::ostream& out, const LatticeSystem& system);

/// x + y zeta, where zeta is the first root of unity of the order.
using Place = std::pair<long, long>;

struct LatticePart {
    char letter = 'F';
    int heading = 0;
    Place at{0, 0};
    bool operator==(const LatticePart&) const = default;
    bool operator<(const LatticePart& other) const {
        return std::tie(letter, heading, at) < std::tie(other.letter, other.heading, other.at);
    }
};

class LatticeParts {
public:
    explicit LatticeParts(LatticeSystem system) : system_(std::move(system)) {}

    /// The letters that occur in what a letter becomes, and become it in their turn.
    std::string companions(char letter) const;
    /// What the word of a letter turns by after so many generations.
    int turn(char letter, unsigned generation) const;
    /// Where its word leads to, in ways of the generation before.
    Place way(unsigned generation) const;
    /// The letters of generation n of a letter that are among `counted`, placed as if each of them
    /// were its own word of generation `below`, in units of that word's way.
    std::vector<LatticePart> parts(char letter, unsigned n, unsigned below,
                                   const std::string& counted) const;
    /// Whether parts of two letters' words of generation `generation` are still within each other's
    /// reach so many generations of parts below.
    bool come_near(const LatticePart& first, const LatticePart& second, unsigned generation,
                   unsigned levels, const std::string& counted) const;

    Place product(Place left, Place right) const;
    Place unit(int heading) const;

private:
    LatticeSystem system_;
};

}  // namespace algae::oracle
