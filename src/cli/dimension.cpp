#include <algorithm>
#include <cmath>
#include <variant>

#include "base/error.hpp"
#include "cli/command.hpp"
#include "cli/dimension_measures.hpp"
#include "cli/dimension_report.hpp"
#include "cli/dimension_table.hpp"
#include "cli/input.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "cli/relatives.hpp"
#include "dimension/exact_dimension.hpp"
#include "dimension/fit.hpp"
#include "dimension/limit_fit.hpp"
#include "dimension/points.hpp"
#include "fold/fold.hpp"
#include "fold/lifts.hpp"
#include "notation/read.hpp"
#include "render/ink.hpp"
#include "render/picture.hpp"
#include "render/plot_dimension.hpp"

namespace algae::cli {

namespace {

// Of the generation measured where none is said; fewer where all of its word must be kept.
constexpr std::uint64_t usual_segments = 10'000'000, usual_kept_segments = 1'000'000;
constexpr std::uint64_t usual_letters = 100'000'000;
constexpr std::uint64_t most_segments = 10'000'000'000;  // a few minutes
constexpr std::uint64_t last_generation = 100;
constexpr std::size_t most_scales = 20;
constexpr std::uint64_t usual_grids = 16;

struct Options {
    std::string file, generation, plot, threshold, grids, seed, measure = "boxes";
    bool points = false, invert = false, json = false, table = false, quick = false;
    Bounds bounds;
};

std::size_t grids(const Options& options) {
    const std::uint64_t count =
        options.grids.empty() ? usual_grids : natural("--grids", options.grids);
    if (count == 0 || count > 1000)
        throw Error("--grids: expected 1 to 1000, found " + options.grids);
    return count;
}

std::size_t scales_down_to(double detail, double whole) {
    if (!(detail > 0)) return most_scales;
    return std::clamp(static_cast<std::size_t>(std::max(std::log2(whole / detail), 0.0)) + 1,
                      std::size_t{1}, most_scales);
}

/// The generation asked for; else the last one that draws no more than is usual.
std::pair<std::uint64_t, std::unique_ptr<Figure>> chosen_figure(const LSystem& system,
                                                                const Options& options,
                                                                const Budget& budget) {
    FigureChoices choices;
    if (!options.seed.empty()) {
        choices.seed = natural("--seed", options.seed);
        choices.random_tables = true;
    }
    if (!options.generation.empty()) {
        const std::uint64_t n = natural("-n", options.generation);
        return {n, figure(system, n, budget, choices)};
    }
    const View<D0L> rules = as_d0l(system);
    const Integer most(rules && options.measure == "boxes" ? usual_segments : usual_kept_segments);
    std::pair<std::uint64_t, std::unique_ptr<Figure>> chosen{0, figure(system, 0, budget, choices)};
    for (std::uint64_t n = 1; n <= last_generation; ++n) {
        if (rules && fold(*rules, n, length_lift()) > Integer(usual_letters)) break;
        auto next = figure(system, n, budget, choices);
        if (next->segments() > most) break;
        chosen = {n, std::move(next)};
    }
    return chosen;
}

/// The limit of all generations, from the rules alone.
Measured measure_limit(const LSystem& system, const ExactDimension& exact, const Options& options,
                       const Budget& budget) {
    LimitCounting counting;
    counting.places = grids(options);
    LimitMeasure measure = measure_limit(exact, counting, budget);
    Measured found;
    found.what =
        (system.title.empty() ? system.name : system.title) + ", the limit of all generations";
    found.counts = std::move(measure.counts.boxes);
    found.fit = std::move(measure.fit);
    return found;
}

/// A figure that can be gone through, and what it is called.
struct NamedFigure {
    std::uint64_t generation = 0;
    std::unique_ptr<Figure> figure;
    std::string what;
};

NamedFigure drawn(const LSystem& system, const Options& options, const Budget& budget) {
    auto [n, figure] = chosen_figure(system, options, budget);
    const std::string name = system.title.empty() ? system.name : system.title;
    if (figure->box().empty)
        throw Error(name + ", n = " + std::to_string(n) +
                    ": nothing is drawn, expected something to measure");
    if (figure->segments() > Integer(most_segments))
        throw BoundReached(Bound::method, name + ", n = " + std::to_string(n) + ": has " +
                                              readable(figure->segments()) +
                                              " segments, of which at most " +
                                              std::to_string(most_segments) +
                                              " can be gone through; use a lower -n");
    std::string what =
        name + ", n = " + std::to_string(n) + ": " + to_string(figure->segments()) + " segments";
    return {n, std::move(figure), std::move(what)};
}

Measured measure(const LSystem& system, const Options& options, const Budget& budget) {
    const auto [n, figure, what] = drawn(system, options, budget);
    Measured found;
    found.generation = n;
    found.what = what;
    BoxScales scales = scales_of(figure->box(), 2, 1);
    scales.count = scales_down_to(figure->facts().step, scales.coarsest);
    found.counts = box_counts(*figure, scales, even_offsets(grids(options)), budget);
    return found;
}

Measured measure(const PointSet& points, const std::string& name, const Options& options,
                 const Budget& budget) {
    Measured found;
    found.counts = box_counts(points, scales_down_to(points.detail, longest_side(points)),
                              grids(options), budget);
    found.what = name + ": " + std::to_string(found.counts.parts) +
                 (points.part == "pixel" ? " pixels of ink" : " different points");
    return found;
}

/// Whether a text starts with a number, remarks and empty lines apart: then it is no system.
bool starts_with_number(std::string_view text) {
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        line.remove_prefix(std::min(line.find_first_not_of(" \t\r"), line.size()));
        if (line.empty() || line.front() == '#') continue;
        line.remove_prefix(std::min(line.find_first_not_of("+-."), line.size()));
        return !line.empty() && line.front() >= '0' && line.front() <= '9';
    }
    return false;
}

bool is_named_as_points(std::string_view file) {
    return file.ends_with(".csv") || file.ends_with(".tsv") || file.ends_with(".xy") ||
           file.ends_with(".xyz");
}

Measured measured(const LSystem& system, const Options& options, const Budget& budget) {
    ExactDimension exact = exact_dimension(system, budget);
    Measured found;
    if (options.generation.empty() && exact.limit) {
        found = measure_limit(system, exact, options, budget);
    } else {
        found = measure(system, options, budget);
        found.fit = fit_dimension(found.counts);
    }
    found.exact = std::move(exact);
    return found;
}

/// What FILE holds.
struct Input {
    std::string name;
    std::variant<LSystem, PointSet> content;
};

Input input(const Options& options, const Budget& budget) {
    const SourceText source = open_text(options.file, budget);
    const auto refuse = [&](const std::string& option, bool given, const char* what) {
        if (given) throw Error(option + " is for " + what + ", and " + source.name + " is none");
    };
    const bool image = is_png(source.text);
    refuse("--threshold", !image && !options.threshold.empty(), "images");
    refuse("--invert", !image && options.invert, "images");
    if (!image && !options.points && !is_named_as_points(options.file) &&
        !starts_with_number(source.text))
        return {source.name, read_lsystem(source.text, source.name)};
    refuse("-n", !options.generation.empty(), "systems");
    refuse("--seed", !options.seed.empty(), "systems");
    InkOptions ink;
    if (!options.threshold.empty())
        ink.threshold = options.threshold == "0" ? 0 : positive("--threshold", options.threshold);
    ink.invert = options.invert;
    return {source.name, image ? ink_of(source.text, source.name, ink, budget)
                               : read_points(source.text, source.name)};
}

std::vector<std::pair<RelativeOption, std::string>> relative_changes(const Options& options) {
    if (options.points || options.invert || !options.threshold.empty())
        throw Error("--points, --threshold and --invert are for images and points, and " +
                    options.file + " holds none");
    return {{{"-n", "generation", {}, {}}, options.generation},
            {{"--seed", "seed", {}, {}}, options.seed}};
}

Measured measured_relative(const Options& options, const Budget& budget) {
    const auto relative = open_relative(options.file, budget, relative_changes(options));
    const RelativeFigure figure = relative->measured_figure(budget);
    Measured found;
    found.exact = relative->exact_dimension(budget);
    found.what = figure.name;
    BoxScales scales = scales_of(figure.figure->box(), 2, 1);
    scales.count = scales_down_to(figure.figure->facts().step, scales.coarsest);
    found.counts = box_counts(*figure.figure, scales, even_offsets(grids(options)), budget);
    found.fit = fit_dimension(found.counts);
    return found;
}

Measured measured(const Options& options, const Budget& budget) {
    if (is_relative(options.file)) return measured_relative(options, budget);
    const Input read = input(options, budget);
    if (const auto* system = std::get_if<LSystem>(&read.content))
        return measured(*system, options, budget);
    Measured found = measure(std::get<PointSet>(read.content), read.name, options, budget);
    found.fit = fit_dimension(found.counts);
    return found;
}

/// By the measure of --measure that is not boxes.
OtherMeasured other_measured(const Options& options, const Budget& budget) {
    if (is_relative(options.file)) {
        const auto relative = open_relative(options.file, budget, relative_changes(options));
        const RelativeFigure figure = relative->measured_figure(budget);
        return measured_otherwise(options.measure, figure.name, *figure.figure, grids(options),
                                  budget);
    }
    const Input read = input(options, budget);
    if (const auto* points = std::get_if<PointSet>(&read.content))
        return measured_otherwise(options.measure,
                                  read.name + ": " + std::to_string(points->points.size()) + " " +
                                      (points->part == "pixel" ? "pixels of ink" : "points"),
                                  *points, grids(options), budget);
    const NamedFigure named = drawn(std::get<LSystem>(read.content), options, budget);
    return measured_otherwise(options.measure, named.what, *named.figure, grids(options), budget);
}

int dimension(const Options& options) {
    const Budget budget = options.bounds.budget();
    check_measure(options.measure);
    if (options.quick && !options.table) throw Error("--quick is for --table");
    if (options.table) {
        if (options.measure != "boxes") throw Error("--table is for --measure boxes");
        DimensionTable table{options.file, options.quick, options.json};
        if (!options.grids.empty()) table.grids = grids(options);
        return print_dimension_table(table, budget);
    }
    if (options.file.empty()) throw Error("dimension: expected FILE, or --table");
    if (!options.plot.empty()) picture_format(options.plot);  // before the work
    if (options.measure != "boxes") {
        if (!options.plot.empty()) check_plotted(options.measure);
        const OtherMeasured found = other_measured(options, budget);
        if (!options.plot.empty()) plot_measured(found, options.plot, budget);
        return print_measured(found, options.json);
    }
    const Measured found = measured(options, budget);
    if (!options.plot.empty())
        draw_dimension_plot({found.what, found.counts, found.fit}, options.plot, budget);
    print(options.json ? dimension_json(found).dump(2) + "\n" : dimension_page(found));
    // What the rules say is an answer where no generation was asked about.
    if (found.exact && found.exact->status == ExactDimension::Status::unfinished) return undecided;
    const bool exact = found.exact && found.exact->status == ExactDimension::Status::exact;
    return found.fit.estimate || (exact && !found.generation) ? success : undecided;
}

}  // namespace

void add_dimension(Verbs& verbs) {
    auto options = std::make_shared<Options>();
    CLI::App& verb =
        add_verb(verbs, "dimension", "The fractal dimension of a figure, an image or points",
                 "  algae dimension koch --plot koch-dimension.svg\n"
                 "  algae dimension coast.png --threshold 0.4 --json",
                 options, dimension);
    verb.add_option("FILE", options->file,
                    "a system or another generator (a file, - or a name from the gallery), an "
                    "image (png), or points: a "
                    "line of 1 to 3 "
                    "numbers for each; with --table a folder")
        ->type_name(file_type);
    verb.add_option("-n", options->generation,
                    "the generation (default: the last with at most 10,000,000 segments; 1,000,000 "
                    "where words must be kept, and for measures other than boxes)")
        ->type_name("N");
    verb.add_option("--measure", options->measure, measure_help)->type_name(measure_type);
    verb.add_option(
            "--plot", options->plot,
            "a log-log plot of the counts, lengths, masses or pairs: .svg, .pdf, .png, .ps or .eps")
        ->type_name("FILE");
    verb.add_option("--grids", options->grids,
                    "over how many places of the grid counts are averaged (default 16)")
        ->type_name("N");
    verb.add_flag("--points", options->points,
                  "FILE holds points, whatever its name and first line are");
    verb.add_option("--threshold", options->threshold,
                    "images: pixels darker than this are ink, 0 to 1 (default 0.5)")
        ->type_name("T");
    verb.add_flag("--invert", options->invert, "images: lighter pixels are ink");
    verb.add_option("--seed", options->seed, "of the word of a system with choices")
        ->type_name("S");
    verb.add_flag(
        "--table", options->table,
        "a line for every system of the gallery, or of the folder FILE: the dimension from "
        "the rules, its boundary, and measured on the limit with 8 grids (or --grids) and "
        "about 50,000 cells, less exactly than without --table; minutes for the gallery");
    verb.add_flag("--quick", options->quick, "with --table: without measuring");
    verb.add_flag("--json", options->json, "print one JSON object; with --table an array");
    options->bounds.add_to(verb);
}

}  // namespace algae::cli
