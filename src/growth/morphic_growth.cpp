#include "growth/morphic_growth.hpp"

#include <algorithm>

#include "exact/integer_matrix.hpp"

namespace algae {

namespace {

/// An enclosure of the greatest real root; the polynomial must have one.
Ball greatest_root(const Polynomial& factor, long bits) {
    std::optional<Ball> greatest;
    for (const Root& root : roots(factor, bits))
        if (root.is_real && (!greatest || compare(root.real, *greatest) == Order::greater)) greatest = root.real;
    return *greatest;
}

bool has_real_root(const Polynomial& factor) {
    for (const Root& root : roots(factor, 64))
        if (root.is_real) return true;
    return false;
}

/// Whether the greatest real root of the first is less; both irreducible.
bool is_less(const Polynomial& left, const Polynomial& right) {
    if (left == right) return false;
    for (long bits = 64;; bits *= 2) {  // different irreducible polynomials share no root
        const Order order = compare(greatest_root(left, bits), greatest_root(right, bits));
        if (order == Order::less) return true;
        if (order == Order::greater) return false;
    }
}

/// The irreducible factor of the characteristic polynomial that has the Perron root.
Polynomial perron_factor(const std::vector<Word>& images, const std::vector<Symbol>& members) {
    std::vector<std::size_t> place(images.size(), members.size());
    for (std::size_t i = 0; i < members.size(); ++i) place[members[i]] = i;
    IntegerMatrix matrix(members.size(), members.size());
    bool is_cycle = true;
    for (std::size_t i = 0; i < members.size(); ++i) {
        std::size_t inside = 0;
        for (const Symbol b : images[members[i]])
            if (place[b] < members.size()) {
                matrix(i, place[b]) += 1;
                ++inside;
            }
        is_cycle = is_cycle && inside == 1;
    }
    if (is_cycle) return Polynomial({-1, 1});
    std::optional<Polynomial> best;
    for (const auto& power : factorise(characteristic_polynomial(matrix)).powers)
        if (has_real_root(power.factor) && (!best || is_less(*best, power.factor))) best = power.factor;
    return *best;
}

}  // namespace

std::vector<std::optional<MorphicGrowth>> morphic_growth(const std::vector<Word>& images, const Budget& budget) {
    const LetterComponents components = components_of(images);
    std::vector<std::optional<MorphicGrowth>> of_component(components.members.size());
    for (std::size_t c = 0; c < of_component.size(); ++c) {
        budget.check();
        std::optional<MorphicGrowth> best;
        for (const Symbol a : components.members[c])
            for (const Symbol b : images[a]) {
                const auto& other = of_component[components.of[b]];
                if (components.of[b] == c || !other) continue;
                if (!best || is_less(best->rate, other->rate) ||
                    (best->rate == other->rate && best->exponent < other->exponent))
                    best = other;
            }
        if (components.cyclic[c]) {
            const Polynomial own = perron_factor(images, components.members[c]);
            if (!best || is_less(best->rate, own))
                best = MorphicGrowth{own, 0};
            else if (best->rate == own)
                ++best->exponent;
        }
        of_component[c] = best;
    }
    std::vector<std::optional<MorphicGrowth>> of_letter(images.size());
    for (Symbol a = 0; a < images.size(); ++a) of_letter[a] = of_component[components.of[a]];
    return of_letter;
}

}  // namespace algae
