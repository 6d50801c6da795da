#pragma once

#include <string>
#include <vector>

#include "turtle/explanation.hpp"

typedef struct _cairo cairo_t;

namespace algae {

/// The steps of an explanation as rows of text: the head, the turtle at its start, then one a step.
/// Columns without anything to say are left out.
///
/// Example: explanation_rows(Explanation{}).size() == 2
std::vector<std::vector<std::string>> explanation_rows(const Explanation& explanation);

/// Which of these columns holds the meanings, which may be broken into lines.
inline constexpr std::size_t column_of_meanings = 2;

/// The table of an explanation on a page, in several blocks side by side. Lengths are those of the
/// context.
class ExplanationTable {
public:
    /// Measures the text with fonts of this size.
    ExplanationTable(cairo_t* context, const Explanation& explanation, double letters);

    /// The size with the rows in so many blocks.
    double width(std::size_t blocks) const;
    double height(std::size_t blocks) const;
    void draw(cairo_t* context, double left, double top, std::size_t blocks) const;

private:
    struct Row {
        std::vector<std::vector<std::string>> cells;  // lines of each
        double height = 0;
    };

    /// The rows at which blocks begin, and the end.
    std::vector<std::size_t> breaks(std::size_t blocks) const;
    void draw_row(cairo_t* context, const Row& row, double left, double top, bool head) const;

    double letters_;
    std::vector<double> columns_;  // widths
    std::vector<Row> rows_;        // the head first
};

}  // namespace algae
