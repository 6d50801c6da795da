#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "notation/source.hpp"

namespace algae {

/// What stands in a cell of a printed table, and where.
struct TableCell {
    std::string text;
    std::size_t offset = 0;
};

/// The rows of a printed table: its lines, cut at blanks, `|`, `&` and `$`. Left out are comments behind
/// `#`, rules such as `---`, `\hline` and `\\`, LaTeX's `\begin{tabular}{cc}` and `\end{tabular}`, and rows without cells. Used within this room only.
std::vector<std::vector<TableCell>> table_rows(const Source& source);

}  // namespace algae
