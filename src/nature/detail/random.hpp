#pragma once

// Random numbers and what is made of them: normal numbers, walks, Brownian paths; and the Fourier
// transform.

#include "nature/nature.hpp"
#include "rewrite/rewrite.hpp"

namespace algae {

/// A number strictly between 0 and 1 from 64 random bits: the middle of one of 2^52 equal parts.
///
/// Example: unit_interval(0) == 0x1p-53
constexpr double unit_interval(std::uint64_t bits) {
    return (static_cast<double>(bits >> 12) + 0.5) * 0x1p-52;
}

/// Independent standard normal numbers, each by its position alone: they are the same in whatever
/// order and by however many threads they are asked for.
///
/// Numbers 2k and 2k + 1 are made from the numbers 2k and 2k + 1 of Draws (Box and Muller, A note
/// on the generation of random normal deviates, 1958).
class Gaussians {
public:
    /// The stream of a seed with this number; streams of a seed are independent of each other.
    Gaussians(std::uint64_t seed, std::uint64_t stream) : draws_(seed, stream) {}

    /// The number at this position, counted from 0; mean 0 and variance 1. O(1).
    ///
    /// Example: Gaussians(1, 0).at(5) == Gaussians(1, 0).at(5)
    double at(std::uint64_t position) const;

private:
    Draws draws_;
};

/// The discrete Fourier transform: out[j] = sum over k of values[k] e^(-2 pi i j k / n), for the n
/// values. The one door to KISS FFT. O(n log n) where n has small prime factors only.
///
/// Example: fourier_transform({1, 1}) == std::vector<std::complex<double>>{2, 0}
std::vector<std::complex<double>> fourier_transform(
    const std::vector<std::complex<double>>& values);

/// The same of a square of side * side values, row by row, in both directions.
void fourier_transform_square(std::vector<std::complex<double>>& values, std::size_t side);

/// The places of a walk from the origin, one more than it has steps; coordinates beyond its
/// dimensions are 0. A walk of fewer steps with the same seed is its beginning. O(steps).
///
/// Throws Error unless it has 1 to 3 dimensions and a deviation above 0, BoundReached if the places
/// take more than budget.memory, Interrupted.
///
/// Example: random_walk({2, 100, 1, 1}, Budget()).size() == 101
std::vector<Vector> random_walk(const RandomWalk& walk, const Budget& budget);

/// Throws Error unless 0 < hurst < 1, sigma > 0 and 0 <= levels <= most_levels.
void check_parameters(const BrownianMotion& motion);

/// The variance of the displacement D_n of midpoints at level n >= 1, sigma^2 / 2^(2 H n) times
/// 1 - 2^(2H - 2): for H = 1/2 it is sigma^2 / 2^(n + 1).
///
/// Example: displacement_variance({0.5, 1, 10}, 3) == 0.0625
double displacement_variance(const BrownianMotion& motion, int level);

/// A path by random midpoint displacement (Fournier, Fussell and Carpenter, Communications of the
/// ACM 25, 1982): X(1) has the variance sigma^2, and at level n each midpoint is the mean of its
/// two neighbours and a D_n. Paths with fewer levels and the same numbers are its coarser versions.
///
/// For H != 1/2 this is not fractional Brownian motion: `midpoint_increment_variance` says by how
/// much. O(2^levels). Throws Error on parameters out of range, BoundReached, Interrupted.
///
/// Example: midpoint_path({0.7, 1, 4}, Gaussians(1, 0), Budget()).size() == 17
std::vector<double> midpoint_path(const BrownianMotion& motion, const Gaussians& numbers,
                                  const Budget& budget);

/// The variance of X(to / 2^levels) - X(from / 2^levels) where X is made by midpoint displacement:
/// exactly, by following what both values are made of up the levels. O(levels).
///
/// Example: midpoint_increment_variance({0.5, 1, 2}, 1, 3) == 0.5
double midpoint_increment_variance(const BrownianMotion& motion, std::uint64_t from,
                                   std::uint64_t to);

/// A path with exactly the distribution of fractional Brownian motion, up to rounding: increments
/// by embedding their covariance in a circulant matrix, which the Fourier transform makes diagonal
/// (Davies and Harte, Biometrika 74, 1987; Dietrich and Newsam, SIAM J. Sci. Comput. 18, 1997; its
/// eigenvalues are not negative: Craigmile, J. Time Series Anal. 24, 2003, for H < 1/2; Perrin et
/// al., IEEE Signal Processing Letters 9, 2002, for the others). O(levels * 2^levels).
///
/// Throws Error on parameters out of range, BoundReached, Interrupted.
///
/// Example: exact_path({0.7, 1, 4}, Gaussians(1, 0), Budget())[0] == 0
std::vector<double> exact_path(const BrownianMotion& motion, const Gaussians& numbers,
                               const Budget& budget);

/// The covariance of two increments of X over steps of length 1 that begin `lag` steps apart:
/// (|lag + 1|^(2H) - 2 |lag|^(2H) + |lag - 1|^(2H)) / 2, without loss of digits for large lags.
///
/// Example: increment_covariance(0.5, 3) == 0
double increment_covariance(double hurst, std::uint64_t lag);

/// The parameter H of a path, from the squares of its second differences over one and over two
/// steps: half the binary logarithm of how much their means differ (quadratic variations: Istas and
/// Lang, Annales de l'I.H.P. Probabilites et statistiques 33, 1997). Its error falls as the root of
/// the number of values for every H, unlike that of first differences. O(values).
///
/// Throws Error if there are fewer than 6 values, or if they lie on a line.
double estimated_hurst(const std::vector<double>& path);

}  // namespace algae
