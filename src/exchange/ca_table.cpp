#include "exchange/ca_table.hpp"

#include <algorithm>
#include <map>
#include <vector>

#include "base/error.hpp"
#include "exchange/table_rows.hpp"
#include "nature/cellular_automaton.hpp"
#include "notation/characters.hpp"
#include "notation/findings.hpp"

namespace algae {

namespace {

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

class Reader {
public:
    Reader(std::string_view text, const std::string& name) : source_(text, name) {
        Findings(source_).throw_if_no_text();
        file_.name = name;
    }

    RelativeFile all() {
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

    [[noreturn]] void fail(std::size_t offset, const std::string& message) const {
        throw Diagnostics({source_.finding(offset, message)});
    }

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
                fail(offset, "expected states 0 to 9 and a to z, or an arrow, found " +
                                 algae::quoted(rest.substr(0, first_character(rest).bytes)));
            }
        }
    }

    void read_entries(const std::vector<std::vector<TableCell>>& lines) {
        std::vector<TableCell> tokens;
        for (const auto& line : lines) tokens.insert(tokens.end(), line.begin(), line.end());
        for (std::size_t i = 0; i < tokens.size(); i += 3) {
            if (tokens[i].text == "->")
                fail(tokens[i].offset, "expected a local configuration, found '->'");
            if (i + 1 == tokens.size() || tokens[i + 1].text != "->")
                fail(i + 1 < tokens.size() ? tokens[i + 1].offset : source_.text().size(),
                     "expected '->' behind " + algae::quoted(tokens[i].text));
            if (i + 2 == tokens.size() || tokens[i + 2].text.size() != 1)
                fail(i + 2 < tokens.size() ? tokens[i + 2].offset : source_.text().size(),
                     "expected the next state, a single one, behind '" + shortened(tokens[i].text) +
                         " ->'");
            add(tokens[i], tokens[i + 2].text[0]);
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
                    fail(above[k].offset, "the configuration " + shortened(above[k].text) +
                                              " has no next state below");
                if (below[k].text.size() != 1)
                    fail(below[k].offset, "expected the next state, a single one, of " +
                                              shortened(above[k].text) + ", found " +
                                              algae::quoted(below[k].text));
                add(above[k], below[k].text[0]);
            }
        }
    }

    void add(const TableCell& cells, char next) {
        if (length_ == 0) {
            if (cells.text.size() % 2 == 0 || cells.text.size() < 3)
                fail(cells.offset,
                     "expected the states of a cell and of as many cells on each side, such as "
                     "001, found " +
                         algae::quoted(cells.text));
            length_ = cells.text.size();
        }
        if (cells.text.size() != length_)
            fail(cells.offset, "expected " + std::to_string(length_) +
                                   " states as in the first entry, found " +
                                   algae::quoted(cells.text));
        const auto [found, is_new] = entries_.emplace(cells.text, Entry{next, cells.offset});
        if (!is_new)
            fail(cells.offset, "the entry of " + shortened(cells.text) +
                                   " is there twice, first in line " +
                                   std::to_string(source_.place(found->second.offset).line));
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
        fail(source_.text().size(), "the entry of " + shortened(configuration) +
                                        " is missing: a table of " + std::to_string(states_) +
                                        " states has one for each " + std::to_string(length_) +
                                        " of them");
    }

    void add(const std::string& key, const std::vector<std::string>& words) {
        file_.add(key, words);
        const Diagnostic here = source_.finding(entries_.begin()->second.offset, "");
        file_.statements.back().place = here.place;
        file_.statements.back().line = here.line;
    }

    void write() {
        if (states_ == 2 && length_ == 3) {
            std::size_t rule = 0;
            for (auto entry = entries_.rbegin(); entry != entries_.rend(); ++entry)
                rule = 2 * rule + number(entry->second.next);
            return add("rule", {std::to_string(rule)});
        }
        add("states", {std::to_string(states_)});
        add("radius", {std::to_string(length_ / 2)});
        std::vector<std::string> words;
        for (const auto& [cells, entry] : entries_) words.push_back(cells + "->" + entry.next);
        add("table", words);
    }

    Source source_;
    RelativeFile file_;
    std::size_t length_ = 0, states_ = 2;
    std::map<std::string, Entry> entries_;
};

}  // namespace

RelativeFile read_ca_table(std::string_view text, const std::string& name) {
    return Reader(text, name).all();
}

std::string print_ca_table(const Relative& relative) {
    const auto& automaton = dynamic_cast<const CellularAutomaton&>(relative);
    const CellRule& rule = automaton.rule;
    if (rule.dimensions != 1)
        throw Error(automaton.name + ": lies in the plane, and a table is one of cells on a line");
    const std::size_t length = rule.neighbourhood.size();
    std::string text;
    for (const std::string* line : {&automaton.title, &automaton.source})
        if (!line->empty()) text += "# " + *line + "\n";
    for (std::size_t entry = 0; entry < rule.table.size(); ++entry) {
        std::string cells(length, '0');
        std::size_t rest = entry;
        for (std::size_t i = length; i-- > 0; rest /= rule.states)
            cells[i] = state(rest % rule.states);
        text += cells + " -> " + state_character(rule.table[entry]) + "\n";
    }
    return text;
}

}  // namespace algae
