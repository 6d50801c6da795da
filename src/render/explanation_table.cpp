#include "render/explanation_table.hpp"

#include <cairo.h>

#include <algorithm>
#include <sstream>

namespace algae {

namespace {

constexpr double gap = 1.1;      // between columns, in letters
constexpr double between = 2.5;  // between blocks
constexpr double line_step = 1.25;
constexpr double widest_meaning = 21;

double text_width(cairo_t* context, const std::string& text) {
    cairo_text_extents_t extents{};
    cairo_text_extents(context, text.c_str(), &extents);
    return extents.x_advance;
}

void choose_font(cairo_t* context, std::size_t column, bool head) {
    cairo_select_font_face(context, column == 1 && !head ? "monospace" : "sans-serif",
                           CAIRO_FONT_SLANT_NORMAL,
                           head ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
}

/// Lines of words, none wider than `most` where words allow it.
std::vector<std::string> broken(cairo_t* context, const std::string& text, double most) {
    std::vector<std::string> lines;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        const std::string longer = lines.empty() ? word : lines.back() + " " + word;
        if (lines.empty() || text_width(context, longer) > most)
            lines.push_back(word);
        else
            lines.back() = longer;
    }
    if (lines.empty()) lines.emplace_back();
    return lines;
}

}  // namespace

std::vector<std::vector<std::string>> explanation_rows(const Explanation& explanation) {
    bool in_space = false, branches = false;
    for (const ExplainedStep& step : explanation.steps) {
        in_space = in_space || step.after.position.z != 0 || !heading_angle(step.after);
        branches = branches || step.open > 0;
    }
    const auto place = [in_space](const Vector& at) {
        return "(" + rounded(at.x) + ", " + rounded(at.y) + (in_space ? ", " + rounded(at.z) : "") +
               ")";
    };
    const auto heading = [&](const TurtleState& state) {
        return in_space ? place(state.attitude.heading())
                        : rounded(heading_angle(state).value_or(0)) + "°";
    };
    const auto row = [&](const std::string& number, const std::string& symbol,
                         const std::string& meaning, const TurtleState& state, std::size_t open) {
        std::vector<std::string> cells{number, symbol, meaning, place(state.position),
                                       heading(state)};
        if (branches) cells.push_back(open == 0 ? "" : std::to_string(open));
        return cells;
    };
    std::vector<std::vector<std::string>> rows;
    rows.push_back({"step", "symbol", "what the turtle does", "then it is at", "heading"});
    if (branches) rows.back().push_back("open [");
    rows.push_back(row("", "", "the start", explanation.start, 0));
    for (std::size_t i = 0; i < explanation.steps.size(); ++i) {
        const ExplainedStep& step = explanation.steps[i];
        rows.push_back(
            row(std::to_string(i + 1), step.symbol, step.meaning, step.after, step.open));
    }
    return rows;
}

ExplanationTable::ExplanationTable(cairo_t* context, const Explanation& explanation, double letters)
    : letters_(letters) {
    cairo_set_font_size(context, letters);
    bool head = true;
    for (const std::vector<std::string>& cells : explanation_rows(explanation)) {
        Row row;
        columns_.resize(cells.size());
        std::size_t lines = 1;
        for (std::size_t column = 0; column < cells.size(); ++column) {
            choose_font(context, column, head);
            const bool may_break = column == column_of_meanings && !head;
            row.cells.push_back(may_break ? broken(context, cells[column], widest_meaning * letters)
                                          : std::vector{cells[column]});
            lines = std::max(lines, row.cells.back().size());
            for (const std::string& line : row.cells.back())
                columns_[column] = std::max(columns_[column], text_width(context, line));
        }
        row.height = (line_step * static_cast<double>(lines) + 0.35) * letters;
        rows_.push_back(std::move(row));
        head = false;
    }
}

std::vector<std::size_t> ExplanationTable::breaks(std::size_t blocks) const {
    double all = 0;
    for (std::size_t i = 1; i < rows_.size(); ++i) all += rows_[i].height;
    std::vector<std::size_t> found{1};
    double sum = 0;
    for (std::size_t i = 1; i < rows_.size(); ++i) {
        // A block ends before the row whose middle is in the next one's share.
        const double share = all * static_cast<double>(found.size()) / static_cast<double>(blocks);
        if (found.size() < blocks && sum + rows_[i].height / 2 > share) found.push_back(i);
        sum += rows_[i].height;
    }
    found.push_back(rows_.size());
    return found;
}

double ExplanationTable::width(std::size_t blocks) const {
    double one = gap * letters_;
    for (const double column : columns_) one += column + gap * letters_;
    const auto count = static_cast<double>(blocks);
    return count * one + (count - 1) * between * letters_;
}

double ExplanationTable::height(std::size_t blocks) const {
    const std::vector<std::size_t> at = breaks(blocks);
    double highest = 0;
    for (std::size_t block = 0; block + 1 < at.size(); ++block) {
        double sum = rows_.front().height;
        for (std::size_t i = at[block]; i < at[block + 1]; ++i) sum += rows_[i].height;
        highest = std::max(highest, sum);
    }
    return highest + 0.4 * letters_;
}

void ExplanationTable::draw_row(cairo_t* context, const Row& row, double left, double top,
                                bool head) const {
    cairo_set_source_rgb(context, 0, 0, 0);
    double x = left + gap * letters_;
    for (std::size_t column = 0; column < row.cells.size(); ++column) {
        choose_font(context, column, head);
        double y = top + 1.15 * letters_;
        for (const std::string& line : row.cells[column]) {
            const bool number = column == 0 || column == 5;
            const double shift = number && !head ? columns_[column] - text_width(context, line) : 0;
            cairo_move_to(context, x + shift, y);
            cairo_show_text(context, line.c_str());
            y += line_step * letters_;
        }
        x += columns_[column] + gap * letters_;
    }
    cairo_new_path(context);
}

void ExplanationTable::draw(cairo_t* context, double left, double top, std::size_t blocks) const {
    cairo_set_font_size(context, letters_);
    const std::vector<std::size_t> at = breaks(blocks);
    const double one = width(1);
    for (std::size_t block = 0; block + 1 < at.size(); ++block) {
        double y = top;
        draw_row(context, rows_.front(), left, y, true);
        y += rows_.front().height + 0.2 * letters_;
        cairo_set_line_width(context, 0.08 * letters_);
        cairo_move_to(context, left, y);
        cairo_line_to(context, left + one, y);
        cairo_stroke(context);
        for (std::size_t i = at[block]; i < at[block + 1]; ++i) {
            if (i % 2 == 0) {
                cairo_set_source_rgb(context, 0.95, 0.95, 0.95);
                cairo_rectangle(context, left, y, one, rows_[i].height);
                cairo_fill(context);
            }
            draw_row(context, rows_[i], left, y, false);
            y += rows_[i].height;
        }
        left += one + between * letters_;
    }
}

}  // namespace algae
