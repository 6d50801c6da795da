#include <algorithm>

#include "nature/nature.hpp"
#include "notation/detail/generator_values.hpp"
#include "rewrite/rewrite.hpp"

// Cellular automata, `.ca`.
//
// The local rule is given in exactly one of four ways: by Wolfram's number of its table (`rule 30`), by the
// code of a totalistic rule (`code 10`), by a life-like rule (`life B3/S23`) or by the table itself (`table
// 000->0 ...`), in which every local configuration has to occur once. The neighbourhood is an interval on a
// line, Moore's or von Neumann's in the plane. A pattern to start from stands behind `start` or in lines
// `row`, as digits of states or as `.` and `O`; it is put in the middle of the cells. Generations on a line
// are the rows of one picture, so there they are one range; in the plane each is a picture of its own.

namespace algae {

namespace {

constexpr std::uint64_t most_states = 36, most_cells = std::uint64_t{1} << 40;
constexpr std::uint64_t most_generations = std::uint64_t{1} << 40;

/// Reads the statements of one file.
class Reader {
public:
    explicit Reader(const GeneratorFile& file) : file_(file) {}

    std::unique_ptr<Generator> automaton() {
        auto made = std::make_unique<CellularAutomaton>();
        file_.describe(*made);
        dimensions_ = static_cast<int>(
            file_.natural("dimensions", 1, 2).value_or(file_.find("life") ? 2 : 1));
        made->rule = rule();
        made->boundary = boundary(made->rule.states);
        made->start = start(made->rule);
        made->generations = generations();
        if (file_.find("legend")) {
            made->legend = true;
            if (dimensions_ != 1 || made->rule.table.size() > 32)
                file_.fail(*file_.find("legend"),
                           "the table has " + std::to_string(made->rule.table.size()) +
                               " entries; expected a rule on a line with at most 32");
        }
        return made;
    }

private:
    const GeneratorStatement& statement(const char* key) const { return *file_.find(key); }

    std::vector<CellOffset> neighbourhood() const {
        const auto radius = static_cast<int>(file_.natural("radius", 1, 100).value_or(1));
        const auto form = file_.choice("neighbourhood", {"moore", "neumann"});
        if (dimensions_ == 2)
            return form == "neumann" ? neumann_neighbourhood(radius) : moore_neighbourhood(radius);
        if (form) file_.fail(statement("neighbourhood"), "is for two dimensions");
        return line_neighbourhood(radius);
    }

    Integer number(const GeneratorStatement& said) const {
        const std::string& text = file_.only_word(said, "NUMBER").text;
        if (text.find_first_not_of("0123456789") != std::string::npos)
            file_.fail(said, said.words.front(),
                       "expected a whole number of at least 0, found '" + text + "'");
        return Integer(text);
    }

    CellRule rule() const {
        const auto states =
            static_cast<std::uint32_t>(file_.natural("states", 2, most_states).value_or(2));
        const GeneratorStatement* said = nullptr;
        for (const char* key : {"rule", "code", "life", "table"})
            if (const GeneratorStatement* found = file_.find(key)) {
                if (said)
                    file_.fail(*found,
                               "the rule is said twice, by " + said->key + " and by " + found->key);
                said = found;
            }
        if (!said)
            file_.fail(
                "has no rule; expected a line such as `rule 30`, `life B3/S23`, `code 10` or "
                "`table 000->0 ...`");
        const std::vector<CellOffset> cells = neighbourhood();
        if (said->key == "table") return table(*said, states, cells);
        if (said->key == "life") file_.check_words(*said, 1, 1, "B.../S...");
        const auto made = [&] {
            if (said->key == "rule") return numbered_rule(number(*said), states, cells);
            if (said->key == "code") return totalistic_rule(number(*said), states, cells);
            return life_rule(said->words.front().text, cells);
        };
        try {
            return made();
        } catch (const Diagnostics&) {
            throw;
        } catch (const Error& error) {
            file_.fail(*said, said->words.front(), error.what());
        }
    }

    std::optional<std::uint8_t> state(char character, std::uint32_t states) const {
        const int value = character >= '0' && character <= '9'   ? character - '0'
                          : character >= 'a' && character <= 'z' ? character - 'a' + 10
                                                                 : -1;
        if (value < 0 || value >= static_cast<int>(states)) return std::nullopt;
        return static_cast<std::uint8_t>(value);
    }

    CellRule table(const GeneratorStatement& said, std::uint32_t states,
                   const std::vector<CellOffset>& cells) const {
        CellRule rule = numbered_rule(Integer(0), states, cells);
        rule.text = "table";
        std::vector<bool> known(rule.table.size());
        for (const GeneratorWord& word : said.words) {
            const std::size_t arrow = word.text.find("->");
            std::size_t number = 0;
            bool fits = arrow == cells.size() && word.text.size() == arrow + 3;
            for (std::size_t i = 0; fits && i < arrow; ++i) {
                const auto digit = state(word.text[i], states);
                fits = digit.has_value();
                if (fits) number = number * states + *digit;
            }
            const auto next = fits ? state(word.text.back(), states) : std::nullopt;
            if (!next)
                file_.fail(said, word,
                           "expected " + std::to_string(cells.size()) +
                               " states, -> and the next state, such as 001->1, found '" +
                               word.text + "'");
            if (known[number]) file_.fail(said, word, "is said twice");
            known[number] = true;
            rule.table[number] = *next;
        }
        const auto missing =
            static_cast<std::size_t>(std::count(known.begin(), known.end(), false));
        if (missing)
            file_.fail(said, std::to_string(missing) + " of " + std::to_string(known.size()) +
                                 " local configurations are missing");
        if (rule.is_elementary()) {
            std::size_t number = 0;
            for (std::size_t i = 8; i-- > 0;) number = 2 * number + rule.table[i];
            rule.text = "rule " + std::to_string(number);
        }
        return rule;
    }

    CellBoundary boundary(std::uint32_t states) const {
        CellBoundary found;
        const GeneratorStatement* said = file_.find("boundary");
        if (!said) return found;
        file_.check_words(*said, 1, 2, "periodic, or fixed [STATE]");
        const std::string& word = said->words.front().text;
        found.periodic = word == "periodic";
        if (!found.periodic && word != "fixed")
            file_.fail(*said, said->words.front(),
                       "expected boundary periodic, or fixed [STATE], found '" + word + "'");
        if (said->words.size() < 2) return found;
        if (found.periodic)
            file_.fail(*said, said->words.back(), "expected no state: nothing is outside");
        found.outside =
            static_cast<std::uint8_t>(file_.natural(*said, said->words.back(), 0, states - 1));
        return found;
    }

    /// What `row` lines and a word behind `start` say, a row each.
    std::vector<std::vector<std::uint8_t>> pattern(std::uint32_t states) const {
        std::vector<std::vector<std::uint8_t>> rows;
        const auto add = [&](const GeneratorStatement& said) {
            const GeneratorWord& word = file_.only_word(said, "STATES");
            auto& row = rows.emplace_back();
            for (const char character : word.text) {
                const auto cell = character == '.'   ? std::optional<std::uint8_t>(0)
                                  : character == 'O' ? std::optional<std::uint8_t>(1)
                                                     : state(character, states);
                if (!cell)
                    file_.fail(said, word,
                               "expected states from 0 to " + std::to_string(states - 1) +
                                   ", or . and O for 0 and 1, found '" + std::string(1, character) +
                                   "'");
                row.push_back(*cell);
            }
        };
        for (const GeneratorStatement& one : file_.statements)
            if (one.key == "row") add(one);
        if (const GeneratorStatement* said = file_.find("start"))
            if (said->words.front().text != "single" && said->words.front().text != "random") {
                if (!rows.empty()) file_.fail(*said, "the start is said by `row` lines already");
                add(*said);
            }
        return rows;
    }

    CellGrid start(const CellRule& rule) const {
        const std::vector<std::vector<std::uint8_t>> rows = pattern(rule.states);
        std::size_t widest = 0;
        for (const auto& row : rows) widest = std::max(widest, row.size());
        std::size_t columns = rows.empty() ? 101 : widest;
        std::size_t height = dimensions_ == 1 ? 1 : rows.empty() ? 101 : rows.size();
        const GeneratorStatement* said = file_.find("cells");
        if (said) {
            const auto count = static_cast<std::size_t>(dimensions_);
            file_.check_words(*said, count, count, dimensions_ == 1 ? "N" : "COLUMNS ROWS");
            columns = file_.natural(*said, said->words[0], 1, most_cells);
            if (dimensions_ == 2) height = file_.natural(*said, said->words[1], 1, most_cells);
        }
        if (dimensions_ == 1 && rows.size() > 1)
            file_.fail("has several `row` lines; a rule on a line starts from one");
        if (columns < widest || height < rows.size())
            file_.fail(*said, "the start has " + std::to_string(widest) + " x " +
                                  std::to_string(rows.size()) + " cells, more than there are");
        CellGrid grid(columns, height, Budget());
        const bool random =
            file_.find("start") && file_.find("start")->words.front().text == "random";
        if (random) {
            file_.check_words(*file_.find("start"), 1, 1, "single, random or STATES");
            const Draws draws(file_.natural("seed", 0, ~std::uint64_t{0}).value_or(1), 0);
            for (std::size_t i = 0; i < grid.cells.size(); ++i)
                grid.cells[i] = static_cast<std::uint8_t>(Draws::scaled(draws.at(i), rule.states));
        } else if (rows.empty()) {
            grid.at(columns / 2, height / 2) = 1;
        } else {
            const std::size_t left = (columns - widest) / 2, top = (height - rows.size()) / 2;
            for (std::size_t y = 0; y < rows.size(); ++y)
                for (std::size_t x = 0; x < rows[y].size(); ++x)
                    grid.at(left + x, top + y) = rows[y][x];
        }
        return grid;
    }

    std::vector<std::uint64_t> generations() const {
        const GeneratorStatement* said = file_.find("generation");
        if (!said)
            return dimensions_ == 1 ? std::vector<std::uint64_t>{0, 50}
                                    : std::vector<std::uint64_t>{0};
        std::vector<std::uint64_t> found;
        for (const GeneratorWord& word : said->words) {
            const auto [first, last] = file_.range(*said, word, most_generations);
            if (last < first || (!found.empty() && first < found.back()))
                file_.fail(*said, word, "expected generations in rising order");
            if (dimensions_ == 1) {
                if (said->words.size() > 1) file_.fail(*said, word, "expected one number or range");
                return {word.text.find("..") == std::string::npos ? 0 : first, last};
            }
            if (last - first > 1000) file_.fail(*said, word, "more than 1000 pictures");
            for (std::uint64_t n = first; n <= last; ++n) found.push_back(n);
        }
        return found;
    }

    const GeneratorFile& file_;
    int dimensions_ = 1;
};

}  // namespace

GeneratorKind ca_kind() {
    return {"ca",
            "a cellular automaton",
            {{"dimensions", "1 or 2"},
             {"states", "K"},
             {"radius", "R"},
             {"neighbourhood", "moore or neumann"},
             {"rule", "NUMBER"},
             {"code", "NUMBER"},
             {"life", "B3/S23"},
             {"table", "000->0 001->1 ..."},
             {"boundary", "periodic, or fixed [STATE]"},
             {"cells", "N, or COLUMNS ROWS"},
             {"start", "single, random or STATES"},
             {"row", "STATES", true},
             {"seed", "S"},
             {"generation", "N or N..M ..."},
             {"legend", ""}},
            [](const GeneratorFile& file) { return Reader(file).automaton(); }};
}

}  // namespace algae
