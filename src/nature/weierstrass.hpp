#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "nature/relative.hpp"

namespace algae {

/// Weierstrass's function, W(x) = sum over n of a^n cos(b^n pi x): continuous and, for 1/b <= a < 1,
/// without a derivative anywhere (Weierstrass 1872 for odd b and ab > 1 + 3 pi / 2; Hardy 1916).
///
/// Its graph has the box dimension 2 + log a / log b (Kaplan, Mallet-Paret and Yorke 1984), and for
/// whole numbers b this is its Hausdorff dimension (Shen, Mathematische Zeitschrift 289, 2018; for
/// random phases Hunt, Proc. AMS 126, 1998).
class WeierstrassFunction : public Relative {
public:
    double a = 0.5, b = 3;
    std::uint64_t most_terms = 40;     // as many as doubles can tell, where b is large
    std::vector<std::uint64_t> terms;  // a figure for each of these sums; otherwise
    std::uint64_t zooms = 0;           // one of all of it, and of so many parts b times finer each
    double from = 0, to = 2;
    std::size_t points = 4096;  // of a graph

    /// Throws Error unless 0 < a < 1, b > 1 and a b >= 1, terms are 1 to 1000, and from < to.
    void check() const;
    /// The sum of the first `count` terms.
    double sum(double x, std::uint64_t count) const;
    /// 2 + log a / log b.
    double dimension() const;

    std::vector<RelativeFigure> figures(const Budget& budget) const override;
    RelativeFigure measured_figure(const Budget& budget) const override;
    std::vector<RelativeFact> facts(const Budget& budget) const override;
};

}  // namespace algae
