#include "render/explanation_page.hpp"

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <ostream>

#include "base/error.hpp"
#include "render/document.hpp"
#include "render/explanation_sketch.hpp"
#include "render/explanation_table.hpp"
#include "render/output.hpp"
#include "system/colour.hpp"

namespace algae {

namespace {

constexpr double margin = 18, letters = 9.5, title_letters = 13, word_letters = 10.5;
constexpr double pixels_per_point = 2;  // in png
constexpr double comfortable = 64;      // points for the shortest step

/// Text has the same size on every surface.
void settle_fonts(cairo_t* context) {
    cairo_font_options_t* const options = cairo_font_options_create();
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_set_font_options(context, options);
    cairo_font_options_destroy(options);
}

/// A page whose parts have their places.
class Page {
public:
    Page(const Explanation& explanation, const std::string& title, const Palette& palette)
        : title_(title),
          word_(explanation.word),
          sheet_(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1), cairo_surface_destroy),
          context_(cairo_create(sheet_.get()), cairo_destroy),
          sketch_(explanation, palette),
          table_(measuring(), explanation, letters) {
        decide();
        break_word();
        height += head_height();
    }

    void draw(cairo_t* context) const {
        settle_fonts(context);
        cairo_set_source_rgb(context, 0, 0, 0);
        cairo_select_font_face(context, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                               CAIRO_FONT_WEIGHT_BOLD);
        cairo_set_font_size(context, title_letters);
        double y = margin + title_letters;
        cairo_move_to(context, margin, y);
        cairo_show_text(context, title_.c_str());
        cairo_select_font_face(context, "monospace", CAIRO_FONT_SLANT_NORMAL,
                               CAIRO_FONT_WEIGHT_NORMAL);
        cairo_set_font_size(context, word_letters);
        y += 0.45 * word_letters;
        for (const std::string& line : lines_) {
            y += 1.3 * word_letters;
            cairo_move_to(context, margin, y);
            cairo_show_text(context, line.c_str());
        }
        cairo_new_path(context);
        const double top = head_height();
        sketch_.draw(context, margin, top, sketch_width_, sketch_height_,
                     sketch_.shortest() > 0 ? 1.5 * comfortable / sketch_.shortest() : 1);
        draw_legend(context, margin, top + sketch_height_ + 11);
        table_.draw(context, below_ ? margin : margin + sketch_width_ + margin,
                    below_ ? top + sketch_height_ + legend_height : top, blocks_);
        check_cairo(context);
    }

    double width = 0, height = 0;

private:
    static constexpr double legend_height = 22;

    cairo_t* measuring() {
        settle_fonts(context_.get());
        return context_.get();
    }

    /// Where the sketch goes: beside the table, or above it where one of them is wide or the table
    /// high, in as large a scale as is comfortable and has room.
    void decide() {
        constexpr double most = 620, least_width = 230, least_height = 130;
        const double room = 2 * ExplanationSketch::room;
        const double shortest = sketch_.shortest() > 0 ? sketch_.shortest() : 1;
        const auto size_within = [&](double across, double down) {
            double scale = comfortable / shortest;
            if (sketch_.breadth() > 0) scale = std::min(scale, (across - room) / sketch_.breadth());
            if (sketch_.height() > 0) scale = std::min(scale, (down - room) / sketch_.height());
            sketch_width_ = std::max(least_width, scale * sketch_.breadth() + room);
            sketch_height_ = std::max(least_height, scale * sketch_.height() + room);
        };
        size_within(most, most);
        const double table_height = table_.height(1);
        below_ = sketch_width_ > 2 * sketch_height_ || sketch_width_ > 1.2 * table_.width(1) ||
                 table_height > 1.25 * std::max(sketch_height_, 330.0);
        if (below_) {
            blocks_ = table_height > 150 ? 2 : 1;
            const double table_width = table_.width(blocks_);
            size_within(std::max(table_width, 400.0), 460);
            sketch_width_ = std::max(sketch_width_, table_width);
            width = sketch_width_ + 2 * margin;
            height = sketch_height_ + legend_height + table_.height(blocks_) + margin;
        } else {
            sketch_height_ = std::max(sketch_height_, table_height - legend_height);
            width = sketch_width_ + table_.width(1) + 3 * margin;
            height = std::max(sketch_height_ + legend_height, table_height) + margin;
        }
    }

    double head_height() const {
        return margin + title_letters + 0.45 * word_letters +
               1.3 * word_letters * static_cast<double>(lines_.size()) + 12;
    }

    /// Breaks the word into lines where it is wider than the page.
    void break_word() {
        cairo_t* const context = context_.get();
        cairo_select_font_face(context, "monospace", CAIRO_FONT_SLANT_NORMAL,
                               CAIRO_FONT_WEIGHT_NORMAL);
        cairo_set_font_size(context, word_letters);
        lines_.emplace_back();
        for (std::size_t at = 0; at < word_.size();) {
            std::size_t next = at + 1;
            while (next < word_.size() && (word_[next] & 0xc0) == 0x80) ++next;
            std::string longer = lines_.back() + word_.substr(at, next - at);
            cairo_text_extents_t extents{};
            cairo_text_extents(context, longer.c_str(), &extents);
            if (extents.x_advance > width - 2 * margin && !lines_.back().empty())
                lines_.push_back(word_.substr(at, next - at));
            else
                lines_.back() = std::move(longer);
            at = next;
        }
    }

    void draw_legend(cairo_t* context, double left, double y) const {
        std::string text = "arrowheads: the turtle";
        if (sketch_.turns()) text += ", pale before it turns";
        if (sketch_.has_moves()) text += "; dots: its pen is up";
        cairo_select_font_face(context, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                               CAIRO_FONT_WEIGHT_NORMAL);
        cairo_set_font_size(context, 7.5);
        cairo_set_source_rgb(context, 0.35, 0.35, 0.35);
        cairo_text_extents_t extents{};
        cairo_text_extents(context, text.c_str(), &extents);
        cairo_move_to(context, left + std::max(0.0, (sketch_width_ - extents.x_advance) / 2), y);
        cairo_show_text(context, text.c_str());
        cairo_new_path(context);
    }

    std::string title_, word_;
    std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> sheet_;
    std::unique_ptr<cairo_t, decltype(&cairo_destroy)> context_;  // to measure text on
    ExplanationSketch sketch_;
    ExplanationTable table_;
    std::vector<std::string> lines_;
    double sketch_width_ = 0, sketch_height_ = 0;
    bool below_ = false;
    std::size_t blocks_ = 1;
};

void check(const Explanation& explanation) {
    if (explanation.steps.size() > longest_explanation)
        throw Error(explanation.name + " has " + std::to_string(explanation.steps.size()) +
                    " symbols: a page explains at most " + std::to_string(longest_explanation));
    for (const ExplainedStep& step : explanation.steps)
        if (step.after.position.z != 0 || !heading_angle(step.after))
            throw Error(explanation.name + ": the symbol " + step.symbol +
                        " leaves the plane: a page explains a turtle in the plane");
}

void draw(const Explanation& explanation, const std::string& title, Output& output,
          PictureFormat format, const PictureOptions& options, const Budget& budget) {
    check(explanation);
    const Palette palette(options.colours, 360);
    const Page page(explanation, title, palette);
    double scale = format == PictureFormat::png ? pixels_per_point : 1;
    if (options.width) scale = *options.width / page.width;
    if (options.height)
        scale = options.width ? std::min(scale, *options.height / page.height)
                              : *options.height / page.height;
    const double width = std::ceil(scale * page.width - 1e-6);
    const double height = std::ceil(scale * page.height - 1e-6);
    constexpr double longest_side = 14'400;
    if (!(width >= 1 && height >= 1 && width <= longest_side && height <= longest_side))
        throw Error("the sides of the page must be from 1 to 14400, not " + std::to_string(width) +
                    " and " + std::to_string(height));
    budget.check_memory(static_cast<std::uint64_t>(4 * width * height), "the page");
    std::optional<Colour> paper = Colour{1, 1, 1};
    if (options.background) {
        if (*options.background == "transparent")
            paper.reset();
        else
            paper = colour_named(*options.background);
    }
    Document document(format, width, height, paper, output, budget);
    cairo_scale(document.context(), scale, scale);
    page.draw(document.context());
    document.finish();
}

}  // namespace

void draw_explanation(const Explanation& explanation, const std::string& title,
                      const std::string& path, PictureFormat format, const PictureOptions& options,
                      const Budget& budget) {
    FileOutput file(path);
    draw(explanation, title, file, format, options, budget);
    file.commit();
}

void draw_explanation(const Explanation& explanation, const std::string& title,
                      std::ostream& stream, PictureFormat format, const PictureOptions& options,
                      const Budget& budget) {
    StreamOutput output(stream);
    draw(explanation, title, output, format, options, budget);
    output.finish();
}

}  // namespace algae
