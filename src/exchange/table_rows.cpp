#include "exchange/table_rows.hpp"

#include <algorithm>

#include "notation/characters.hpp"

namespace algae {

namespace {

bool is_rule(std::string_view cell) {
    const auto dashes =
        std::count_if(cell.begin(), cell.end(), [](char c) { return c == '-' || c == '='; });
    return cell.find_first_not_of("-:=+") == std::string_view::npos && dashes > 0 &&
           cell.size() > 1;
}

bool is_left_out(std::string_view cell) {
    for (const char* command : {"\\hline", "\\toprule", "\\midrule", "\\bottomrule", "\\centering"})
        if (cell == command) return true;
    return cell.empty() || is_rule(cell);
}

/// How many bytes at the start of a line's rest begin or end an environment of LaTeX, with what
/// stands in brackets behind: `\begin{tabular}{|c|c|}`. 0 where they do neither.
std::size_t environment_bytes(std::string_view rest) {
    if (!rest.starts_with("\\begin{") && !rest.starts_with("\\end{")) return 0;
    rest = rest.substr(0, rest.find('\n'));
    std::size_t i = rest.find('{');
    for (int depth = 0; i < rest.size(); ++i) {
        if (rest[i] == '{' || rest[i] == '[')
            ++depth;
        else if (rest[i] == '}' || rest[i] == ']')
            --depth;
        else if (depth == 0)
            break;
    }
    return i;
}

}  // namespace

std::vector<std::vector<TableCell>> table_rows(const Source& source) {
    const std::string_view text = source.text();
    std::vector<std::vector<TableCell>> rows;
    std::vector<TableCell> row;
    for (std::size_t i = 0; i < text.size();) {
        if (text[i] == '\n') {
            if (!row.empty()) rows.push_back(std::move(row));
            row.clear();
            ++i;
            continue;
        }
        if (text[i] == '#') {
            i = std::min(text.find('\n', i), text.size());
            continue;
        }
        if (const std::size_t bytes = environment_bytes(text.substr(i))) {
            i += bytes;
            continue;
        }
        const auto bytes_between = [&](std::size_t at) -> std::size_t {
            if (text[at] == '|' || text[at] == '&' || text[at] == '$') return 1;
            const Character next = first_character(text.substr(at));
            return is_blank(next.code) ? next.bytes : 0;
        };
        if (const std::size_t bytes = bytes_between(i)) {
            i += bytes;
            continue;
        }
        const std::size_t begin = i;
        while (i < text.size() && text[i] != '\n' && text[i] != '#' && bytes_between(i) == 0) ++i;
        std::string_view cell = text.substr(begin, i - begin);
        cell = cell.substr(0, cell.find("\\\\"));
        if (!is_left_out(cell)) row.push_back({std::string(cell), begin});
    }
    if (!row.empty()) rows.push_back(std::move(row));
    return rows;
}

}  // namespace algae
