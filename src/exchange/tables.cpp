#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "exchange/detail/formats.hpp"
#include "exchange/exchange.hpp"

// Printed tables, as books and papers have them: the maps of an iterated function system, the rule of a
// cellular automaton.
//
// A table is rows of cells, cut at blanks, `|`, `&` and `$`, without rules such as `---` and `\hline`, so
// that plain text, Markdown and LaTeX are read alike (`table_rows`). Columns of maps are named by a header,
// or guessed from how many there are. The entries of a rule are `001 -> 1` in any order, or two lines, local
// configurations above next states; each configuration must occur once, which is checked by counting up in
// the order of a sorted map. What is read becomes a file of the kind (`ifs`, `ca`) whose statements keep the
// places of the table, so that later errors point into it.

namespace algae {

namespace {

/// What stands in a cell of a printed table, and where.
struct TableCell {
    std::string text;
    std::size_t offset = 0;
};

bool is_rule(std::string_view cell) {
    const auto dashes =
        std::count_if(cell.begin(), cell.end(), [](char c) { return c == '-' || c == '='; });
    return cell.find_first_not_of("-:=+") == std::string_view::npos && dashes > 0 &&
           cell.size() > 1;
}

bool is_left_out(std::string_view cell) {
    constexpr std::string_view commands[] = {"\\hline", "\\toprule", "\\midrule", "\\bottomrule",
                                             "\\centering"};
    return cell.empty() || is_rule(cell) || std::ranges::count(commands, cell) > 0;
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

/// The rows of a printed table: its lines, cut at blanks, `|`, `&` and `$`. Left out are comments behind
/// `#`, rules such as `---`, `\hline` and `\\`, LaTeX's `\begin{tabular}{cc}` and `\end{tabular}`, and
/// rows without cells.
std::vector<std::vector<TableCell>> table_rows(const Source& source) {
    const std::string_view text = source.text();
    std::vector<std::vector<TableCell>> rows;
    std::vector<TableCell> row;
    const auto end_row = [&] {
        if (!row.empty()) rows.push_back(std::exchange(row, {}));
    };
    for (std::size_t i = 0; i < text.size();) {
        if (text[i] == '\n') {
            end_row();
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
    end_row();
    return rows;
}

/// What the readers of tables share.
class TableReader {
public:
    TableReader(std::string_view text, const std::string& name) : source_(text, name) {
        Findings(source_).throw_if_no_text();
        file_.name = name;
    }

protected:
    template <class... Values>
    [[noreturn]] void fail(std::size_t offset, fmt::format_string<Values...> message,
                           Values&&... values) const {
        throw Diagnostics(
            {source_.finding(offset, fmt::format(message, std::forward<Values>(values)...))});
    }
    std::size_t line_of(std::size_t offset) const { return source_.place(offset).line; }
    /// Adds a statement that stands here.
    void add(const std::string& key, std::vector<GeneratorWord> words, std::size_t offset) {
        const Diagnostic here = source_.finding(offset, "");
        file_.statements.push_back({key, std::move(words), here.place, here.line, {}, ""});
    }

    Source source_;
    GeneratorFile file_;
};

constexpr const char* arrows[] = {"\\rightarrow", "\\mapsto", "\\to", "->", "→", "↦"};

bool is_state(char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z'); }

/// The number of a state's character, and the character of a number.
std::size_t number(char state) {
    return static_cast<std::size_t>(state <= '9' ? state - '0' : state - 'a' + 10);
}
char state(std::size_t number) { return state_character(static_cast<std::uint8_t>(number)); }

/// The text as messages name it, cut where it is long.
std::string shortened(const std::string& text) {
    const std::string marked = algae::quoted(text);
    return marked.substr(1, marked.size() - 2);
}

class CellTableReader : TableReader {
public:
    using TableReader::TableReader;

    GeneratorFile all() {
        std::vector<std::vector<TableCell>> lines;
        bool has_arrows = false;
        for (const auto& row : table_rows(source_)) {
            auto& line = lines.emplace_back();
            for (const TableCell& cell : row) cut(cell, line);
            for (const TableCell& token : line) has_arrows = has_arrows || token.text == "->";
        }
        if (has_arrows)
            read_entries(lines);
        else
            read_pairs_of_lines(lines);
        check_complete();
        write();
        return std::move(file_);
    }

private:
    struct Entry {
        char next;
        std::size_t offset;
    };

    /// Cuts a cell into groups of states and arrows.
    void cut(const TableCell& cell, std::vector<TableCell>& tokens) const {
        std::string_view rest = cell.text;
        bool joined = false;  // to the group before
        const auto skip = [&](std::string_view text) {
            if (!rest.starts_with(text)) return false;
            rest.remove_prefix(text.size());
            return true;
        };
        while (!rest.empty()) {
            const std::size_t offset = cell.offset + cell.text.size() - rest.size();
            const auto* arrow = std::find_if(std::begin(arrows), std::end(arrows), skip);
            if (arrow != std::end(arrows)) {
                tokens.push_back({"->", offset});
                joined = false;
            } else if (is_state(rest[0])) {
                if (!joined) tokens.push_back({"", offset});
                tokens.back().text += rest[0];
                rest.remove_prefix(1);
                joined = true;
            } else if (skip(",") || skip(";")) {
                joined = false;
            } else if (!skip("\\underline") && !skip("{") && !skip("}")) {
                fail(offset, "expected states 0 to 9 and a to z, or an arrow, found {}",
                     algae::quoted(rest.substr(0, first_character(rest).bytes)));
            }
        }
    }

    void read_entries(const std::vector<std::vector<TableCell>>& lines) {
        std::vector<TableCell> tokens;
        for (const auto& line : lines) tokens.insert(tokens.end(), line.begin(), line.end());
        // What is missing at the end stands there as nothing.
        const std::size_t count = tokens.size();
        tokens.resize(count + 2, {"", source_.text().size()});
        for (std::size_t i = 0; i < count; i += 3) {
            const TableCell &cells = tokens[i], &arrow = tokens[i + 1], &next = tokens[i + 2];
            if (cells.text == "->")
                fail(cells.offset, "expected a local configuration, found '->'");
            if (arrow.text != "->")
                fail(arrow.offset, "expected '->' behind {}", algae::quoted(cells.text));
            if (next.text.size() != 1)
                fail(next.offset, "expected the next state, a single one, behind '{} ->'",
                     shortened(cells.text));
            add(cells, next.text[0]);
        }
    }

    void read_pairs_of_lines(const std::vector<std::vector<TableCell>>& lines) {
        for (std::size_t i = 0; i < lines.size(); i += 2) {
            if (i + 1 == lines.size())
                fail(source_.text().size(),
                     "expected a line with the next states of the line above");
            const auto &above = lines[i], &below = lines[i + 1];
            for (std::size_t k = 0; k < std::max(above.size(), below.size()); ++k) {
                if (k >= above.size())
                    fail(below[k].offset,
                         "expected the end of the line: no configuration stands above");
                if (k >= below.size())
                    fail(above[k].offset, "the configuration {} has no next state below",
                         shortened(above[k].text));
                if (below[k].text.size() != 1)
                    fail(below[k].offset, "expected the next state, a single one, of {}, found {}",
                         shortened(above[k].text), algae::quoted(below[k].text));
                add(above[k], below[k].text[0]);
            }
        }
    }

    void add(const TableCell& cells, char next) {
        if (length_ == 0) {
            if (cells.text.size() % 2 == 0 || cells.text.size() < 3)
                fail(cells.offset,
                     "expected the states of a cell and of as many cells on each side, such as "
                     "001, found {}",
                     algae::quoted(cells.text));
            length_ = cells.text.size();
        }
        if (cells.text.size() != length_)
            fail(cells.offset, "expected {} states as in the first entry, found {}", length_,
                 algae::quoted(cells.text));
        const auto [found, is_new] = entries_.emplace(cells.text, Entry{next, cells.offset});
        if (!is_new)
            fail(cells.offset, "the entry of {} is there twice, first in line {}",
                 shortened(cells.text), line_of(found->second.offset));
        for (const char one : cells.text + next) states_ = std::max(states_, number(one) + 1);
    }

    void check_complete() const {
        if (entries_.empty())
            fail(source_.text().size(),
                 "expected entries such as 001 -> 1, found the end of the file");
        std::string configuration(length_, '0');
        for (const auto& [cells, entry] : entries_) {
            if (cells != configuration) missing(configuration);
            std::size_t i = length_;
            while (i > 0 && number(configuration[i - 1]) + 1 == states_) configuration[--i] = '0';
            if (i > 0) configuration[i - 1] = state(number(configuration[i - 1]) + 1);
        }
        if (configuration != std::string(length_, '0')) missing(configuration);
    }

    [[noreturn]] void missing(const std::string& configuration) const {
        fail(source_.text().size(),
             "the entry of {} is missing: a table of {} states has one for each {} of them",
             shortened(configuration), states_, length_);
    }

    void write() {
        const std::size_t offset = entries_.begin()->second.offset;
        if (states_ == 2 && length_ == 3) {
            std::size_t rule = 0;
            for (auto entry = entries_.rbegin(); entry != entries_.rend(); ++entry)
                rule = 2 * rule + number(entry->second.next);
            return TableReader::add("rule", {{std::to_string(rule)}}, offset);
        }
        TableReader::add("states", {{std::to_string(states_)}}, offset);
        TableReader::add("radius", {{std::to_string(length_ / 2)}}, offset);
        std::vector<GeneratorWord> words;
        for (const auto& [cells, entry] : entries_) words.push_back({cells + "->" + entry.next});
        TableReader::add("table", words, offset);
    }

    std::size_t length_ = 0, states_ = 2;
    std::map<std::string, Entry> entries_;
};

}  // namespace

GeneratorFile read_ca_table(std::string_view text, const std::string& name) {
    return CellTableReader(text, name).all();
}

std::string print_ca_table(const Generator& generator) {
    const auto& automaton = dynamic_cast<const CellularAutomaton&>(generator);
    const CellRule& rule = automaton.rule;
    if (rule.dimensions != 1)
        throw Error(automaton.name + ": lies in the plane, and a table is one of cells on a line");
    std::string text = commented("# ", {automaton.title, automaton.source});
    for (std::size_t entry = 0; entry < rule.table.size(); ++entry) {
        const auto cells = local_configuration(entry, rule.states, rule.neighbourhood.size());
        text += fmt::format("{} -> {}\n", state_text(cells), state_character(rule.table[entry]));
    }
    return text;
}

namespace {

using Row = std::vector<TableCell>;
const std::string letters = "abcdefp";

class MapTableReader : TableReader {
public:
    using TableReader::TableReader;

    GeneratorFile all() {
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
                fail(cell.offset, "unknown column {}, expected a, b, c, d, e, f or p",
                     algae::quoted(cell.text));
            const char letter = named ? lower(cell.text[0]) : ' ';
            if (named && std::count(columns_.begin(), columns_.end(), letter) > 0)
                fail(cell.offset, "the column {} is there twice", cell.text);
            columns_ += letter;
        }
        for (const char letter : std::string("abcdef"))
            if (columns_.find(letter) == std::string::npos)
                fail(row.front().offset, "the table has no column {}", letter);
    }

    void guess_columns(const Row& row) {
        const bool name = row.size() == 8 || (row.size() == 7 && !number(row.front()));
        const std::size_t numbers = row.size() - (name ? 1 : 0);
        if (numbers != 6 && numbers != 7)
            fail(row.front().offset,
                 "expected the numbers a b c d e f and perhaps p, with or without a name before "
                 "them, found {} cells",
                 row.size());
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
            fail(row.front().offset, "the row has no {}: expected {} cells, found {}",
                 column_name(row.size()), columns_.size(), row.size());
        if (row.size() > columns_.size())
            fail(row[columns_.size()].offset,
                 "expected the end of the row behind {} cells, found {}", columns_.size(),
                 algae::quoted(row[columns_.size()].text));
        std::vector<GeneratorWord> words(columns_.find('p') == std::string::npos ? 6 : 7);
        for (std::size_t i = 0; i < row.size(); ++i) {
            if (columns_[i] == ' ') {
                check_name(row[i]);
                continue;
            }
            const auto value = number(row[i]);
            if (!value)
                fail(row[i].offset, "expected a number for {}, found {}{}", column_name(i),
                     algae::quoted(row[i].text), hint(row[i].text));
            const Place place = source_.place(row[i].offset);
            words[letters.find(columns_[i])] = {to_text(*value), place.column - 1};
        }
        if (words.size() == 7) sum(row, words[6].text);
        add("map", std::move(words), row.front().offset);
    }

    /// What is often taken for a part of a number.
    static std::string hint(std::string_view cell) {
        if (cell.find(',') != std::string_view::npos) return "; decimals have a point";
        for (const std::string_view character : characters(cell))
            if (const char32_t code = first_character(character).code; is_false_minus(code))
                return " (" + code_point_name(code) + "); did you mean '-'?";
        return "";
    }

    std::string column_name(std::size_t column) const {
        return columns_[column] == ' ' ? "name" : std::string(1, columns_[column]);
    }

    void check_name(const TableCell& cell) {
        const auto [found, is_new] = names_.emplace(cell.text, cell.offset);
        if (!is_new)
            fail(cell.offset, "the map {} is there twice, first in line {}",
                 algae::quoted(cell.text), line_of(found->second));
    }

    void sum(const Row& row, const std::string& text) {
        const Quantity value =
            evaluate(read_expression(text), [](const std::string&) { return nullptr; });
        if (!(value.value > 0))
            fail(row[columns_.find('p')].offset, "expected a probability above 0, found {}",
                 algae::quoted(text));
        if (value.exact && sum_)
            *sum_ += *value.exact;
        else
            sum_.reset();
    }

    /// That they add up, where all are rational; others are left to who draws.
    void check_sum(const Row& last) const {
        const std::size_t column = columns_.find('p');
        if (column != std::string::npos && sum_ && *sum_ != 1)
            fail(last[column].offset, "the probabilities add up to {}, expected 1",
                 shortest_text(*sum_));
    }

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

GeneratorFile read_ifs_table(std::string_view text, const std::string& name) {
    GeneratorFile file = MapTableReader(text, name).all();
    ifs_kind().make(file);  // whether the maps bring points together
    return file;
}

std::string print_ifs_table(const Generator& generator) {
    const auto& system = dynamic_cast<const IteratedFunctions&>(generator);
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
    std::string text = commented("# ", {system.title, system.source});
    for (const auto& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i)
            text += std::string(widths[i] - row[i].size() + (i > 0 ? 2 : 0), ' ') + row[i] +
                    (i + 1 < row.size() ? "" : "\n");
    return text;
}

BFile read_b_file(std::string_view text, const std::string& name) {
    const Source source(text, name);
    Findings findings(source);
    findings.throw_if_no_text();
    constexpr std::size_t most_digits = 100'000;
    BFile file;
    const auto fail = [&](std::string_view at, const std::string& message) {
        throw Diagnostics(
            {source.finding(static_cast<std::size_t>(at.data() - text.data()), message)});
    };
    const auto integer = [&](std::string_view cell, const char* what) {
        const std::string_view digits = cell.starts_with('-') ? cell.substr(1) : cell;
        if (digits.empty() || digits.size() > most_digits ||
            digits.find_first_not_of("0123456789") != std::string_view::npos)
            fail(cell, std::string("expected ") + what + ", a whole number, found " +
                           quoted(cell.substr(0, 60)));
        return Integer(cell);
    };
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string_view whole = text.substr(begin, end - begin);
        const auto cells = blank_separated(whole.substr(0, whole.find('#')));
        begin = end + 1;
        if (cells.empty()) continue;
        if (cells.size() != 2)
            fail(cells.size() > 2 ? cells[2] : cells[0],
                 "expected a line `n a(n)`, found " + counted(cells.size(), "piece"));
        const Integer n = integer(cells[0], "n");
        const Integer expected = file.first + Integer(file.terms.size());
        if (file.terms.empty())
            file.first = n;
        else if (n != expected)
            fail(cells[0],
                 "expected the term of n = " + to_string(expected) + ", found n = " + to_string(n));
        file.terms.push_back(integer(cells[1], "a(n)"));
    }
    if (file.terms.empty())
        throw Diagnostics({source.finding(0, "expected lines `n a(n)`, found none")});
    return file;
}

bool looks_like_b_file(std::string_view text) {
    const auto is_integer = [](std::string_view cell) {
        if (cell.starts_with('-')) cell.remove_prefix(1);
        return !cell.empty() && cell.find_first_not_of("0123456789") == std::string_view::npos;
    };
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string_view whole = text.substr(begin, end - begin);
        const auto cells = blank_separated(whole.substr(0, whole.find('#')));
        if (!cells.empty())
            return cells.size() == 2 && is_integer(cells[0]) && is_integer(cells[1]);
        begin = end + 1;
    }
    return false;
}

std::string print_b_file(const BFile& file) {
    std::string out;
    Integer n = file.first;
    for (const Integer& term : file.terms) {
        out += to_string(n) + " " + to_string(term) + "\n";
        n += Integer(1);
    }
    return out;
}

}  // namespace algae
