#pragma once

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "algebra/monoid.hpp"
#include "base/error.hpp"
#include "word/alphabet.hpp"

namespace algae {

/// The free monoid itself: words under concatenation.
struct Words {
    using value_type = Word;
    Word one() const { return {}; }
    void append(Word& left, const Word& right) const {
        left.insert(left.end(), right.begin(), right.end());
    }
};

/// The two symbols that fence a branch, where an alphabet has them.
struct Brackets {
    Symbol open = 0;
    Symbol close = 0;
    bool operator==(const Brackets&) const = default;
};

/// The symbols named "[" and "]", if the alphabet has both.
std::optional<Brackets> brackets_of(const Alphabet& alphabet);

/// The homomorphism from words to M with these images of the letters, indexed by symbol.
///
/// Where M is Branching and the alphabet has brackets, `[` u `]` is sent to branch(image of u), and
/// the image of a word whose brackets do not match throws Error.
template <Monoid M>
struct Hom {
    M monoid;
    std::vector<typename M::value_type> images;
    std::optional<Brackets> brackets = std::nullopt;
    //> hom
    typename M::value_type operator()(const Word& word) const {
        if constexpr (Branching<M>)
            if (brackets) return branched(word);
        auto product = monoid.one();
        for (const Symbol a : word) monoid.append(product, images.at(a));
        return product;
    }

    /// This homomorphism after h: a letter goes where its successor goes. Only the letters given
    /// are worked out, the others keep the neutral element.
    Hom after(const Hom<Words>& h, const std::vector<Symbol>& letters) const {
        Hom composed{monoid, std::vector<typename M::value_type>(images.size(), monoid.one()), brackets};
        for (const Symbol a : letters) {
            if constexpr (Branching<M>)
                if (brackets && (a == brackets->open || a == brackets->close)) continue;
            composed.images[a] = (*this)(h.images.at(a));
        }
        return composed;
    }
    //< hom
private:
    typename M::value_type branched(const Word& word) const
        requires Branching<M>
    {
        std::vector<typename M::value_type> open{monoid.one()};  // one for each branch still open
        for (const Symbol a : word) {
            if (a == brackets->open) {
                open.push_back(monoid.one());
            } else if (a == brackets->close) {
                if (open.size() == 1) throw Error("unmatched ']'");
                const auto twig = monoid.branch(open.back());
                open.pop_back();
                monoid.append(open.back(), twig);
            } else {
                monoid.append(open.back(), images.at(a));
            }
        }
        if (open.size() > 1) throw Error("'[' is never closed");
        return std::move(open.back());
    }
};

/// The rules of a deterministic system are a homomorphism
/// from words to words.
using Morphism = Hom<Words>;

}  // namespace algae
