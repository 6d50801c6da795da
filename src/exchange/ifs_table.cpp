#include "exchange/ifs_table.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>

#include "base/error.hpp"
#include "exchange/table_rows.hpp"
#include "nature/iterated_functions.hpp"
#include "notation/characters.hpp"
#include "notation/findings.hpp"
#include "notation/ifs_file.hpp"
#include "notation/read.hpp"

namespace algae {

namespace {

using Row = std::vector<TableCell>;
const std::string letters = "abcdefp";

class Reader {
public:
    Reader(std::string_view text, const std::string& name) : source_(text, name) {
        Findings(source_).throw_if_no_text();
        file_.name = name;
    }

    RelativeFile all() {
        std::vector<Row> rows = table_rows(source_);
        if (!rows.empty() && is_header(rows.front())) {
            read_header(rows.front());
            rows.erase(rows.begin());
        }
        if (rows.empty())
            fail(source_.text().size(),
                 "expected a row of numbers for each map, found the end of the file");
        if (columns_.empty()) guess_columns(rows.front());
        for (const Row& row : rows) read_row(row);
        check_sum(rows.back());
        return std::move(file_);
    }

private:
    [[noreturn]] void fail(std::size_t offset, const std::string& message) const {
        throw Diagnostics({source_.finding(offset, message)});
    }

    static char lower(char c) {
        return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    /// The header may be in capitals.
    static bool is_letter(const std::string& cell) {
        return cell.size() == 1 && letters.find(lower(cell[0])) != std::string::npos;
    }
    static bool is_word(const std::string& cell) {
        return std::all_of(cell.begin(), cell.end(),
                           [](unsigned char c) { return std::isalpha(c) != 0; });
    }
    /// Words, and most of them letters of columns.
    static bool is_header(const Row& row) {
        const auto known = std::count_if(
            row.begin(), row.end(), [](const TableCell& cell) { return is_letter(cell.text); });
        return row.size() > 1 && 2 * known > static_cast<std::ptrdiff_t>(row.size()) - 1 &&
               std::all_of(row.begin() + 1, row.end(),
                           [](const TableCell& cell) { return is_word(cell.text); });
    }

    /// A column of names has no letter of its own.
    void read_header(const Row& row) {
        for (const TableCell& cell : row) {
            const bool named = is_letter(cell.text);
            if (!named && !columns_.empty())
                fail(cell.offset, "unknown column " + algae::quoted(cell.text) +
                                      ", expected a, b, c, d, e, f or p");
            const char letter = named ? lower(cell.text[0]) : ' ';
            if (named && std::count(columns_.begin(), columns_.end(), letter) > 0)
                fail(cell.offset, "the column " + cell.text + " is there twice");
            columns_ += letter;
        }
        for (const char letter : std::string("abcdef"))
            if (columns_.find(letter) == std::string::npos)
                fail(row.front().offset, std::string("the table has no column ") + letter);
    }

    void guess_columns(const Row& row) {
        const bool name = row.size() == 8 || (row.size() == 7 && !number(row.front()));
        const std::size_t numbers = row.size() - (name ? 1 : 0);
        if (numbers != 6 && numbers != 7)
            fail(row.front().offset,
                 "expected the numbers a b c d e f and perhaps p, with or without a name before "
                 "them, found " +
                     std::to_string(row.size()) + " cells");
        columns_ = (name ? " " : "") + letters.substr(0, numbers);
    }

    static std::optional<Expression> number(const TableCell& cell) {
        try {
            Expression expression = read_expression(cell.text);
            evaluate(expression, [](const std::string&) { return nullptr; });
            return expression;
        } catch (const Error&) {
            return std::nullopt;
        }
    }

    void read_row(const Row& row) {
        if (row.size() < columns_.size())
            fail(row.front().offset, "the row has no " + column_name(row.size()) + ": expected " +
                                         std::to_string(columns_.size()) + " cells, found " +
                                         std::to_string(row.size()));
        if (row.size() > columns_.size())
            fail(row[columns_.size()].offset,
                 "expected the end of the row behind " + std::to_string(columns_.size()) +
                     " cells, found " + algae::quoted(row[columns_.size()].text));
        std::vector<RelativeWord> words(columns_.find('p') == std::string::npos ? 6 : 7);
        for (std::size_t i = 0; i < row.size(); ++i) {
            if (columns_[i] == ' ') {
                check_name(row[i]);
                continue;
            }
            const auto value = number(row[i]);
            if (!value)
                fail(row[i].offset, "expected a number for " + column_name(i) + ", found " +
                                        algae::quoted(row[i].text) + hint(row[i].text));
            const Place place = source_.place(row[i].offset);
            words[letters.find(columns_[i])] = {to_text(*value), place.column - 1};
        }
        if (words.size() == 7) sum(row, words[6].text);
        const Diagnostic here = source_.finding(row.front().offset, "");
        file_.statements.push_back({"map", std::move(words), here.place, here.line, {}, ""});
    }

    /// What is often taken for a part of a number.
    static std::string hint(std::string_view cell) {
        if (cell.find(',') != std::string_view::npos) return "; decimals have a point";
        while (!cell.empty()) {
            const Character next = first_character(cell);
            if (is_false_minus(next.code))
                return " (" + code_point_name(next.code) + "); did you mean '-'?";
            cell.remove_prefix(next.bytes);
        }
        return "";
    }

    std::string column_name(std::size_t column) const {
        return columns_[column] == ' ' ? "name" : std::string(1, columns_[column]);
    }

    void check_name(const TableCell& cell) {
        const auto [found, is_new] = names_.emplace(cell.text, cell.offset);
        if (!is_new)
            fail(cell.offset, "the map " + algae::quoted(cell.text) +
                                  " is there twice, first in line " +
                                  std::to_string(source_.place(found->second).line));
    }

    void sum(const Row& row, const std::string& text) {
        const Quantity value =
            evaluate(read_expression(text), [](const std::string&) { return nullptr; });
        if (!(value.value > 0))
            fail(row[columns_.find('p')].offset,
                 "expected a probability above 0, found " + algae::quoted(text));
        if (value.exact && sum_)
            *sum_ += *value.exact;
        else
            sum_.reset();
    }

    /// That they add up, where all are rational; others are left to who draws.
    void check_sum(const Row& last) const {
        const std::size_t column = columns_.find('p');
        if (column != std::string::npos && sum_ && *sum_ != 1)
            fail(last[column].offset,
                 "the probabilities add up to " + shortest_text(*sum_) + ", expected 1");
    }

    Source source_;
    RelativeFile file_;
    std::string columns_;  // a letter for each; a blank for names
    std::map<std::string, std::size_t> names_;
    std::optional<Rational> sum_ = Rational(0);
};

/// A number as it stands in a table.
std::string cell(const IteratedFunctions& system, const Quantity& number) {
    const std::string text = to_text(number.expression);
    if (text.find_first_of(" |&") != std::string::npos)
        throw Error(system.name + ": the number " + text +
                    " cannot stand between the blanks of a table");
    return text;
}

}  // namespace

RelativeFile read_ifs_table(std::string_view text, const std::string& name) {
    RelativeFile file = Reader(text, name).all();
    ifs_kind().make(file);  // whether the maps bring points together
    return file;
}

std::string print_ifs_table(const Relative& relative) {
    const auto& system = dynamic_cast<const IteratedFunctions&>(relative);
    if (system.states.size() > 1)
        throw Error(system.name + ": has several states, and a table says maps of one");
    const bool chances = std::all_of(system.maps.begin(), system.maps.end(),
                                     [](const auto& map) { return map.probability.has_value(); });
    std::vector<std::vector<std::string>> rows{{"w", "a", "b", "c", "d", "e", "f"}};
    if (chances) rows.front().push_back("p");
    for (const IteratedFunctions::Map& map : system.maps) {
        auto& row = rows.emplace_back();
        row.push_back(std::to_string(rows.size() - 1));
        for (const Quantity& number : map.numbers) row.push_back(cell(system, number));
        if (chances) row.push_back(cell(system, *map.probability));
    }
    std::vector<std::size_t> widths(rows.front().size());
    for (const auto& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    std::string text;
    for (const std::string* line : {&system.title, &system.source})
        if (!line->empty()) text += "# " + *line + "\n";
    for (const auto& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i)
            text += std::string(widths[i] - row[i].size() + (i > 0 ? 2 : 0), ' ') + row[i] +
                    (i + 1 < row.size() ? "" : "\n");
    return text;
}

}  // namespace algae
