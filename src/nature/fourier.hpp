#pragma once

#include <complex>
#include <cstddef>
#include <vector>

namespace algae {

/// The discrete Fourier transform: out[j] = sum over k of values[k] e^(-2 pi i j k / n), for the n
/// values. The one door to KISS FFT. O(n log n) where n has small prime factors only.
///
/// Example: fourier_transform({1, 1}) == std::vector<std::complex<double>>{2, 0}
std::vector<std::complex<double>> fourier_transform(
    const std::vector<std::complex<double>>& values);

/// The same of a square of side * side values, row by row, in both directions.
void fourier_transform_square(std::vector<std::complex<double>>& values, std::size_t side);

}  // namespace algae
