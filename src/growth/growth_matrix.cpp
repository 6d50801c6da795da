#include "growth/growth_matrix.hpp"

#include <algorithm>
#include <numeric>

#include "base/error.hpp"

namespace algae {

namespace {

std::vector<std::size_t> positions(const D0L& system) {
    std::vector<std::size_t> position(system.alphabet->size(), 0);
    for (std::size_t i = 0; i < system.letters.size(); ++i) position[system.letters[i]] = i;
    return position;
}

}  // namespace

GrowthMatrix growth_matrix(const D0L& system) {
    const auto position = positions(system);
    GrowthMatrix matrix;
    matrix.rows.resize(system.letters.size());
    for (std::size_t i = 0; i < system.letters.size(); ++i) {
        std::vector<std::size_t> columns;
        for (const Symbol a : system.successor(system.letters[i])) columns.push_back(position[a]);
        std::sort(columns.begin(), columns.end());
        for (const std::size_t column : columns) {
            auto& row = matrix.rows[i];
            if (row.empty() || row.back().column != column) row.push_back({column, 0});
            row.back().times += 1;
        }
    }
    return matrix;
}

GrowthMatrix growth_matrix(const IntegerMatrix& matrix) {
    GrowthMatrix sparse;
    sparse.rows.resize(matrix.rows());
    for (std::size_t i = 0; i < matrix.rows(); ++i)
        for (std::size_t j = 0; j < matrix.columns(); ++j)
            if (!matrix(i, j).is_zero()) sparse.rows[i].push_back({j, matrix(i, j)});
    return sparse;
}

IntegerMatrix dense(const GrowthMatrix& matrix) {
    IntegerMatrix full(matrix.size(), matrix.size());
    for (std::size_t i = 0; i < matrix.size(); ++i)
        for (const auto& [column, times] : matrix.rows[i]) full(i, column) = times;
    return full;
}

std::vector<Integer> axiom_counts(const D0L& system) {
    const auto position = positions(system);
    std::vector<Integer> counts(system.letters.size());
    for (const Symbol a : system.axiom) counts[position[a]] += 1;
    return counts;
}

std::vector<Integer> operator*(const std::vector<Integer>& row, const GrowthMatrix& matrix) {
    if (row.size() != matrix.size())
        throw Error("expected a row of " + std::to_string(matrix.size()) + " numbers, found one of " +
                    std::to_string(row.size()));
    std::vector<Integer> next(row.size());
    for (std::size_t i = 0; i < row.size(); ++i) {
        if (row[i].is_zero()) continue;
        for (const auto& [column, times] : matrix.rows[i])
            if (times == 1)
                next[column] += row[i];
            else
                next[column] += row[i] * times;
    }
    return next;
}

std::vector<Integer> operator*(const GrowthMatrix& matrix, const std::vector<Integer>& column) {
    if (column.size() != matrix.size())
        throw Error("expected a column of " + std::to_string(matrix.size()) + " numbers, found one of " +
                    std::to_string(column.size()));
    std::vector<Integer> next(column.size());
    for (std::size_t i = 0; i < column.size(); ++i)
        for (const auto& [j, times] : matrix.rows[i]) next[i] += column[j] * times;
    return next;
}

std::vector<Integer> lengths(const D0L& system, std::uint64_t count, const Budget& budget) {
    const GrowthMatrix matrix = growth_matrix(system);
    std::vector<Integer> counts = axiom_counts(system), found;
    std::uint64_t bits = 0;
    for (std::uint64_t n = 0; n < count; ++n) {
        budget.check();
        found.push_back(std::accumulate(counts.begin(), counts.end(), Integer()));
        budget.check_memory((bits += bit_length(found.back()) + 64) / 8, "the lengths");
        counts = counts * matrix;
    }
    return found;
}

}  // namespace algae
