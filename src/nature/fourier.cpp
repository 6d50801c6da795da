#include "nature/fourier.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wshadow"
#include <kissfft/kissfft.hh>
#pragma GCC diagnostic pop

namespace algae {

std::vector<std::complex<double>> fourier_transform(
    const std::vector<std::complex<double>>& values) {
    if (values.empty()) return {};
    const kissfft<double> transform(values.size(), false);
    std::vector<std::complex<double>> out(values.size());
    transform.transform(values.data(), out.data());
    return out;
}

void fourier_transform_square(std::vector<std::complex<double>>& values, std::size_t side) {
    if (side == 0) return;
    const kissfft<double> transform(side, false);
    std::vector<std::complex<double>> line(side), out(side);
    for (std::size_t row = 0; row < side; ++row) {
        transform.transform(values.data() + row * side, out.data());
        std::copy(out.begin(), out.end(), values.begin() + static_cast<std::ptrdiff_t>(row * side));
    }
    for (std::size_t column = 0; column < side; ++column) {
        for (std::size_t row = 0; row < side; ++row) line[row] = values[row * side + column];
        transform.transform(line.data(), out.data());
        for (std::size_t row = 0; row < side; ++row) values[row * side + column] = out[row];
    }
}

}  // namespace algae
