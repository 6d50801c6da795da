// `algae dimension`: the fractal dimension of a figure, an image or points, exact where the rules give it.
//
// There are two answers, which are never mixed. The exact one comes from the rules alone
// (dimension/dimension.hpp) and is a formula with digits that are proved. The measured one is the slope
// of a line through counts at scales that halve; it has an interval in which the value is expected, and no proof. Without
// -n a system is measured on the limit of all its generations if the rules lead to one, otherwise on the
// last generation that is not too large. The content of FILE decides which options make sense: images have a
// threshold, systems a generation, and each refuses the options of the others.

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <variant>

#include <fmt/format.h>

#include "command/detail/files.hpp"
#include "command/detail/output.hpp"
#include "command/detail/pictures.hpp"
#include "command/detail/verb.hpp"
#include "dimension/dimension.hpp"
#include "exact/exact.hpp"
#include "model/model.hpp"
#include "nature/nature.hpp"
#include "notation/notation.hpp"
#include "render/render.hpp"
#include "report/report.hpp"
#include "system/system.hpp"
#include "turtle/turtle.hpp"
#include "watch/watch.hpp"

namespace algae::command {

namespace {

/// A reader: the measure of this name.
Measure measure_named(const std::string& option, const std::string& text) {
    for (std::size_t i = 0; i < measure_count; ++i)
        if (names_of(static_cast<Measure>(i)).name == text) return static_cast<Measure>(i);
    throw Error(option +
                ": expected boxes, divider, mass, correlation, information, multifractal or "
                "lacunarity, found " +
                text);
}

// Bounds of the generation that is measured without -n; smaller if all of its word must be kept.
constexpr std::uint64_t usual_segments = 10'000'000, usual_kept_segments = 1'000'000;
constexpr std::uint64_t usual_letters = 100'000'000;
constexpr std::uint64_t usual_modules = 10'000'000;      // of words that are written out
constexpr std::uint64_t most_segments = 10'000'000'000;  // a few minutes
constexpr std::uint64_t last_generation = 100;
constexpr std::size_t most_scales = 20;
constexpr std::uint64_t usual_grids = 16;

struct Options {
    std::string file, plot;
    std::vector<std::string> let;
    std::string generation, seed;  // of a generator the text of a statement, else a number
    std::optional<double> threshold;
    std::optional<std::size_t> grids;
    std::optional<Rational> within;
    Measure measure = Measure::boxes;
    bool points = false, invert = false, json = false, latex = false, table = false, quick = false;
    bool rauzy = false, tile = false;
    std::optional<RauzyPicture> tiling;
    Bounds bounds;

    std::size_t places() const { return grids.value_or(usual_grids); }
};

/// A reader: over how many places of the grid counts are averaged.
std::size_t grid_count(const std::string& option, const std::string& text) {
    const std::uint64_t count = natural(option, text);
    if (count == 0 || count > 1000) throw Error(option + ": expected 1 to 1000, found " + text);
    return count;
}

/// A reader: how near bounds are to be.
Rational width(const std::string& option, const std::string& text) {
    const Rational found(text);
    if (!(Rational(0) < found)) throw Error(option + ": expected a number above 0, found " + text);
    return found;
}

// Measures other than boxes.

constexpr std::size_t most_cells = 1024;  // a side, for lacunarity of figures
constexpr double information_order = 1;
constexpr std::array orders{-5., -4., -3., -2., -1., 0., 1., 2., 3., 4., 5.};

/// The strokes that join points in their order, and the mean distance along them.
Scaling divider_of(const PointSet& points, const Budget& budget) {
    if (points.detail > 0 || points.columns != 2)
        throw Error(
            "--measure divider walks along strokes: expected a system or points of the "
            "plane in their order, found " +
            (points.detail > 0
                 ? points.part + "s"
                 : "points with " + counted(static_cast<std::uint64_t>(points.columns), "column")));
    Stroke stroke;
    double length = 0;
    for (const auto& point : points.points) {
        if (!stroke.empty())
            length += std::hypot(point[0] - stroke.back().x, point[1] - stroke.back().y);
        stroke.push_back({point[0], point[1]});
    }
    return divider({stroke}, length / static_cast<double>(stroke.size()), budget);
}

/// The order that the verb gives as the estimate of a spectrum.
const Scaling& of_order_zero(const std::vector<GeneralisedDimension>& spectrum) {
    return std::ranges::find(spectrum, 0, &GeneralisedDimension::order)->scaling;
}

// What figures and points differ in.

std::vector<GeneralisedDimension> dimensions_of(const Figure& figure, std::span<const double> some,
                                                std::size_t grids, const Budget& budget) {
    return generalised_dimensions(figure, some, grids, budget);
}

std::vector<GeneralisedDimension> dimensions_of(const PointSet& points,
                                                std::span<const double> some, std::size_t grids,
                                                const Budget& budget) {
    return generalised_dimensions(points, {}, some, grids, budget);
}

Scaling divider_of(const Figure& figure, const Budget& budget) { return divider(figure, budget); }

Scaling lacunarity_of(const Figure& figure, const Budget& budget) {
    return lacunarity(drawn_cells(figure, most_cells, budget), budget);
}

Scaling lacunarity_of(const PointSet& points, const Budget& budget) {
    return lacunarity(filled_cells(points, budget), budget);
}

/// By a measure that is not boxes. `measured`: a figure or points.
template <class Measured>
ScalingReport measured_otherwise(Measure measure, std::string what, const Measured& measured,
                                 std::size_t grids, const Budget& budget) {
    ScalingReport found{std::move(what), measure, {}, {}, {}};
    if (measure == Measure::information) {
        const auto one = dimensions_of(measured, std::span(&information_order, 1), grids, budget);
        found.scaling = one[0].scaling;
    } else if (measure == Measure::multifractal) {
        found.spectrum = dimensions_of(measured, orders, grids, budget);
        found.scaling = of_order_zero(found.spectrum);
    } else if (measure == Measure::divider) {
        found.scaling = divider_of(measured, budget);
    } else if (measure == Measure::mass) {
        found.scaling = mass(measured, {}, budget);
    } else if (measure == Measure::correlation) {
        found.scaling = correlation(measured, {}, budget);
    } else {
        found.scaling = lacunarity_of(measured, budget);
    }
    return found;
}

/// Draws the log-log plot that shows the dimension, in the format that the end of the path says.
void plot_measured(const ScalingReport& found, const std::string& path, const Budget& budget) {
    const MeasureNames& measure = names_of(found.measure);
    draw_scaling_plot({found.what, measure.value, measure.scale, found.scaling}, path, budget);
}

// A table of many systems.

using Found = ExactDimension::Status;

constexpr std::size_t table_grids = 8;
constexpr std::uint64_t table_cells = 50'000;  // touched in the finest scale, about

struct Entry {
    std::string name;
    Model system;
};

/// All systems of the gallery, or of a folder, in order of their names.
std::vector<Entry> entries(const std::string& folder, const Budget& budget) {
    std::vector<Entry> all;
    if (folder.empty()) {
        for (const GalleryEntry& entry : gallery())
            all.push_back(
                {std::string(entry.name), read_lsystem(entry.text, std::string(entry.name))});
        return all;
    }
    std::error_code ignored;
    if (!std::filesystem::is_directory(folder, ignored))
        throw Error(folder + ": expected a folder with .lsys files for --table");
    std::vector<std::filesystem::path> files = files_below(folder);
    std::erase_if(files, [](const auto& file) { return file.extension() != ".lsys"; });
    if (files.empty()) throw Error(folder + ": expected .lsys files in this folder, found none");
    for (const auto& file : files)
        all.push_back({file.stem().string(), open_model(file.string(), budget)});
    return all;
}

/// The budget until so much of its time is used up, and at most a third of it.
Budget for_at_most(std::chrono::steady_clock::duration time, Budget budget) {
    const auto now = std::chrono::steady_clock::now();
    if (budget.deadline) time = std::min(time, (*budget.deadline - now) / 3);
    budget.deadline = now + time;
    return budget;
}

bool is_time(const BoundReached& bound) { return bound.bound() == Bound::time; }

/// Says of an upper bound that the time of the search for parts that coincide was over; of what the rules alone decide, nothing.
void leave_open(ExactDimension& found, const BoundReached& over) {
    if (found.status != Found::upper_bound) return;
    found.status = Found::unfinished;
    found.conditions.back() = std::string("whether parts coincide is not known: ") + over.what();
}

/// The exact value of a row in at most a third of the time that is left, so that others have time too; the bound where
/// that is not enough.
ExactDimension exact_in_row(const Model& system, const Budget& budget) {
    if (!budget.deadline) return exact_dimension(system, budget);
    try {
        return exact_dimension(system, for_at_most(std::chrono::hours(1), budget));
    } catch (const BoundReached& bound) {
        if (!is_time(bound)) throw;
        ExactDimension found = dimension_bound(system, budget);
        leave_open(found, bound);
        return found;
    }
}

DimensionRow row_of(const Entry& entry, const Options& options, const Budget& budget) {
    DimensionRow row{entry.name, entry.system.title, {}, {}, {}};
    try {
        row.exact = exact_in_row(entry.system, budget);
    } catch (const BoundReached& bound) {
        row.exact.status = Found::unfinished;
        row.exact.conditions.push_back(bound.what());
    }
    row.unfinished = row.exact.status == Found::unfinished;
    if (row.unfinished && !row.exact.value) row.unmeasured = row.exact.conditions.back();
    if (!row.exact.value || options.quick) return row;
    if (!row.exact.limit) {
        row.unmeasured = row.exact.almost_surely
                             ? "chance has a part in it"
                             : "the rules do not lead to similar parts of one size";
        return row;
    }
    LimitCounting counting;
    counting.places = options.grids.value_or(table_grids);
    counting.most_cells = table_cells;
    try {
        row.fit = measure_limit(row.exact, counting, budget).fit;
        if (!row.fit->estimate) row.unmeasured = row.fit->because;
    } catch (const BoundReached& bound) {
        row.unmeasured = bound.what();
        row.unfinished = row.unfinished || is_of_budget(bound.bound());
    }
    return row;
}

int print_table(const Options& options, const Budget& budget) {
    const std::vector<Entry> all = entries(options.file, budget);
    std::size_t width = 0;
    for (const Entry& entry : all) width = std::max(width, entry.name.size());
    std::string without, unfinished;
    bool complete = true;
    std::vector<DimensionRow> rows;  // of --latex
    if (!options.latex) print(options.json ? "[" : dimension_header(width, options.quick));
    std::optional<OpenJson> open;
    if (options.json) open.emplace("\n  {", "}\n]\n");
    ProgressBar bar("dimension");
    WorkCount figures("figure", all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        figures.at(i + 1, all[i].name);
        if (open && i > 0) open->set_before(",\n  {");
        const DimensionRow row = row_of(all[i], options, budget);
        complete = complete && !row.unfinished;
        if (options.latex)
            rows.push_back(row);
        else if (options.json)
            print((i > 0 ? ",\n" : "\n") + json_element(to_json(row, options.quick)));
        else if (row.exact.status == Found::none)
            without += to_line(row, width);
        else if (row.exact.status == Found::unfinished)
            unfinished += to_line(row, width);
        else
            print(to_line(row, width));
        bar.report(static_cast<double>(i + 1) / static_cast<double>(all.size()));
    }
    if (options.latex) print(to_latex(rows));
    if (options.json) print("\n]\n");
    if (!without.empty()) print("\nno formula:\n" + without);
    if (!unfinished.empty()) print("\nunfinished:\n" + unfinished);
    return complete ? success : undecided;
}

// One input.

std::size_t scales_down_to(double detail, double whole) {
    if (!(detail > 0)) return most_scales;
    return std::clamp(static_cast<std::size_t>(std::max(std::log2(whole / detail), 0.0)) + 1,
                      std::size_t{1}, most_scales);
}

BoxCounts counts_of(const Figure& figure, const Options& options, const Budget& budget) {
    BoxScales scales = scales_of(figure.box(), 2, 1);
    scales.count = scales_down_to(figure.facts().step, scales.coarsest);
    return box_counts(figure, scales, even_offsets(options.places()), budget);
}

/// The generation asked for; else the last one that draws no more than is usual.
std::pair<std::uint64_t, std::unique_ptr<Figure>> chosen_figure(const Model& system,
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
    const Integer most(rules && options.measure == Measure::boxes ? usual_segments
                                                                  : usual_kept_segments);
    std::pair<std::uint64_t, std::unique_ptr<Figure>> chosen{0, figure(system, 0, budget, choices)};
    Budget usual = budget;
    if (!rules) usual.letters = std::min<std::uint64_t>(budget.letters, usual_modules);
    try {
        for (std::uint64_t n = 1; n <= last_generation; ++n) {
            if (rules && fold(*rules, n, length_lift()) > Integer(usual_letters)) break;
            auto next = figure(system, n, usual, choices);
            if (next->segments() > most) break;
            chosen = {n, std::move(next)};
        }
    } catch (const BoundReached& bound) {  // of words that are written out, the longest that may be
        if (bound.bound() != Bound::letters && bound.bound() != Bound::memory) throw;
    }
    return chosen;
}

/// Where the time is bounded, few cells in few grids come first, and are kept when it is over.
LimitMeasure measured_in_time(const ExactDimension& exact, const LimitCounting& counting,
                              bool& late, const Budget& budget) {
    if (!budget.deadline) return measure_limit(exact, counting, budget);
    LimitCounting quick = counting;
    quick.places = std::min<std::size_t>(counting.places, 4);
    quick.most_cells = 20'000;
    LimitMeasure first = measure_limit(exact, quick, budget);
    try {
        return measure_limit(exact, counting, budget);
    } catch (const BoundReached& bound) {
        if (bound.bound() != Bound::time) throw;
        first.fit.because += std::string("; in fewer cells than usual: ") + bound.what();
        late = true;
        return first;
    }
}

/// The limit of all generations, from the rules alone.
DimensionReport measure_limit(const Model& system, const ExactDimension& exact,
                              const Options& options, const Budget& budget) {
    LimitCounting counting;
    counting.places = options.places();
    DimensionReport found;
    LimitMeasure measure = measured_in_time(exact, counting, found.late, budget);
    found.what =
        (system.title.empty() ? system.name : system.title) + ", the limit of all generations";
    found.counts = std::move(measure.counts.boxes);
    found.fit = std::move(measure.fit);
    return found;
}

/// A figure to be measured, and its name.
struct NamedFigure {
    std::uint64_t generation = 0;
    std::unique_ptr<Figure> figure;
    std::string what;
};

NamedFigure drawn(const Model& system, const Options& options, const Budget& budget) {
    auto [n, figure] = chosen_figure(system, options, budget);
    const std::string name = system.title.empty() ? system.name : system.title;
    note_rounding(system, n, figure->facts().rounded);
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

DimensionReport measure(const Model& system, const Options& options, const Budget& budget) {
    const auto [n, figure, what] = drawn(system, options, budget);
    DimensionReport found;
    found.generation = n;
    found.what = what;
    found.counts = counts_of(*figure, options, budget);
    found.fit = fit_dimension(found.counts);
    return found;
}

/// Whether finer scales see more than coarser ones, as they do where points have noise.
bool fills_finely(const PointSet& points, const BoxFit& fit) {
    constexpr double more = 0.08;
    if (!fit.estimate || points.columns < 2) return false;
    const auto begin = fit.slopes.begin() + static_cast<std::ptrdiff_t>(fit.first);
    const auto end = fit.slopes.begin() + static_cast<std::ptrdiff_t>(fit.last);
    return *std::max_element(begin, end) > *begin + more;
}

DimensionReport measure(const PointSet& points, const std::string& name, const Options& options,
                        const Budget& budget) {
    DimensionReport found;
    found.counts = box_counts(points, scales_down_to(points.detail, longest_side(points)),
                              options.places(), budget);
    const bool is_picture = points.part == "pixel";
    found.what = name + ": " + std::to_string(found.counts.parts) +
                 (is_picture ? " pixels of ink" : " different points");
    if (is_picture) {
        found.fit = fit_picture(picture_counts(filled_cells(points, budget), budget), found.counts);
        return found;
    }
    found.fit = fit_dimension(found.counts);
    if (!fills_finely(points, found.fit)) return found;
    const Scaling pairs = correlation(points, {}, budget);
    if (pairs.noise == 0) return found;
    found.counts.noise = pairs.noise;
    found.fit = fit_dimension(found.counts);
    found.fit.because += fmt::format("; freed of the noise, --measure correlation gives {:.4f}",
                                     pairs.estimate->value);
    return found;
}

/// Whether a text starts with a number, after comments and empty lines: then it is not a system.
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

constexpr std::chrono::seconds first_search{5};  // for parts that coincide

/// Whether a dimension is not known to be less than that of the plane.
bool may_have_area(const ExactDimension& exact) {
    return !exact.value || exact.value->rational() == Rational(2);
}

/// What is known of the limit of a system as a tile, if its dimension is 2: with `set` to make it one of a lattice.
template <class MakeSet>
void find_tile(DimensionReport& found, const MakeSet& make_set, const Budget& budget) {
    try {
        found.tile = tile(make_set(), budget);
    } catch (const BoundReached& bound) {
        found.no_tile = bound.what();
        found.late = found.late || is_time(bound);
    } catch (const Error& reason) {
        found.no_tile = reason.what();
    }
}

void find_tile(DimensionReport& found, const ExactDimension& exact, const Budget& budget) {
    if (!exact.limit || !exact.value || exact.value->rational() != Rational(2) || found.late)
        return;
    find_tile(
        found, [&] { return lattice_set(*exact.limit, budget); }, budget);
}

/// Measured on the limit, or the generation that is asked for; without counts where the time is
/// over.
DimensionReport measured(const Model& system, const ExactDimension& exact, const Options& options,
                         const Budget& budget) {
    DimensionReport found;
    try {
        if (options.generation.empty() && exact.limit)
            found = measure_limit(system, exact, options, budget);
        else
            found = measure(system, options, budget);
    } catch (const BoundReached& bound) {
        if (!is_time(bound) || !exact.value) throw;
        found.what = system.title.empty() ? system.name : system.title;
        found.fit.because = bound.what();
        found.late = true;
    }
    found.exact = exact;
    find_tile(found, exact, budget);
    return found;
}

/// Bounds from both sides, as near as was asked for or as they come; the exact value where a short
/// search finds it.
DimensionReport bounded(const Model& system, const Options& options, const Budget& budget) {
    ExactDimension exact;
    try {
        exact = exact_dimension(system, for_at_most(first_search, budget));
    } catch (const BoundReached& bound) {
        if (!is_time(bound)) throw;
        exact = dimension_bound(system, budget);
    }
    if (exact.almost_surely)
        throw Error(
            "--within: chance has a part in what " + options.file +
            " draws, and no bounds hold for all that it may be; without --within the dimension "
            "with probability 1 is printed");
    DimensionBounds bounds;
    if (exact.status == ExactDimension::Status::exact) {
        const Ball value = exact.value->enclosure(96);
        const Rational unit = power(Rational(10), 12);
        bounds.low = Rational(floor(value.lower() * unit)) / unit;
        bounds.high = Rational(ceiling(value.upper() * unit)) / unit;
        bounds.low_by = bounds.high_by = "the exact value";
    } else {
        bounds = dimension_bounds(system, BoundsSearch::until_within(*options.within), budget);
    }
    DimensionReport found = measured(system, exact, options, budget);
    found.bounds = std::move(bounds);
    found.within = *options.within;
    return found;
}

/// The search for parts that coincide may take long. What it has not ended in a few seconds goes on
/// behind the bound and the measurement, which a page shows at once; what they are is kept when the
/// time is over.
DimensionReport measured(const Model& system, const Options& options, const Budget& budget) {
    try {
        return measured(system, exact_dimension(system, for_at_most(first_search, budget)), options,
                        budget);
    } catch (const BoundReached& bound) {
        if (!is_time(bound)) throw;
    }
    DimensionReport found = measured(system, dimension_bound(system, budget), options, budget);
    if (found.exact->status != ExactDimension::Status::upper_bound) return found;
    if (!options.json) {
        print(to_text(found) + "\n");
        print("the search for parts that coincide goes on\n\n");
    }
    try {
        found.exact = exact_dimension(system, budget);
    } catch (const BoundReached& bound) {
        if (!is_time(bound)) throw;
        leave_open(*found.exact, bound);
    }
    return found;
}

/// The content of FILE.
struct Input {
    std::string name;
    std::variant<Model, PointSet> content;
};

Input input(const Options& options, const Budget& budget) {
    const bool typed = options.file == "-";  // standard input is read once
    const SourceText source =
        typed ? open_text("-", budget, options.let) : open_text(options.file, budget);
    const auto refuse = [&](const std::string& option, bool given, const char* what) {
        if (given)
            throw Error(option + " is for " + what + ", and " + source.name +
                        " is not one of them");
    };
    const bool image = is_png(source.text);
    refuse("--threshold", !image && options.threshold.has_value(), "images");
    refuse("--invert", !image && options.invert, "images");
    if (!image && !options.points && !is_named_as_points(options.file) &&
        !starts_with_number(source.text))
        return {source.name, typed ? read_lsystem(source.text, source.name)
                                   : open_model(options.file, budget, options.let)};
    refuse("--let", !options.let.empty(), "systems");
    refuse("-n", !options.generation.empty(), "systems");
    refuse("--seed", !options.seed.empty(), "systems");
    InkOptions ink;
    if (options.threshold) ink.threshold = *options.threshold;
    ink.invert = options.invert;
    return {source.name, image ? ink_of(source.text, source.name, ink, budget)
                               : read_points(source.text, source.name)};
}

/// The generator in FILE.
std::unique_ptr<Generator> opened(const Options& options, const Budget& budget) {
    if (!options.let.empty())
        throw Error("--let is for systems, and " + options.file + " is not one");
    if (options.points || options.invert || options.threshold)
        throw Error("--points, --threshold and --invert are for images and points, and " +
                    options.file + " holds none");
    return open_generator(
        options.file, budget,
        {{"-n", "generation", options.generation}, {"--seed", "seed", options.seed}});
}

DimensionReport measured_generator(const Options& options, const Budget& budget) {
    const auto generator = opened(options, budget);
    const GeneratorFigure figure = generator->measured_figure(budget);
    DimensionReport found;
    found.exact = generator->exact_dimension(budget);
    found.what = figure.name;
    found.counts = counts_of(*figure.figure, options, budget);
    found.fit = fit_dimension(found.counts);
    const auto* const maps = dynamic_cast<const IteratedFunctions*>(generator.get());
    if (!maps || !found.exact || !may_have_area(*found.exact)) return found;
    find_tile(
        found, [&] { return lattice_set(*maps, budget); }, budget);
    // Of maps that are no similarities, most make no tile, and there is nothing to say.
    if (!found.exact->value) found.no_tile.clear();
    return found;
}

/// Draws the tile among its neighbours.
void plot_tile(const DimensionReport& found, const Options& options, const Budget& budget) {
    if (!found.tile || found.tile->is_tile.answer != Tile::Answer::yes)
        throw Error(options.file + ": --tile draws a tile, and this is not seen to be one" +
                    (found.tile && !found.tile->is_tile.because.empty()
                         ? ": " + found.tile->is_tile.because
                     : found.no_tile.empty() ? ""
                                             : ": " + found.no_tile));
    const auto figure = tile_figure(*found.tile, budget);
    PictureOptions picture;
    picture.title = found.what;
    draw_picture({figure.get(), found.what, ""}, target_of(options.plot),
                 picture_format(options.plot), picture, budget);
}

DimensionReport measured(const Options& options, const Budget& budget) {
    if (is_generator(options.file)) {
        if (options.within)
            throw Error("--within is for systems, and " + options.file + " is not one");
        return measured_generator(options, budget);
    }
    const Input read = input(options, budget);
    if (const auto* system = std::get_if<Model>(&read.content))
        return options.within ? bounded(*system, options, budget)
                              : measured(*system, options, budget);
    if (options.within) throw Error("--within is for systems, and " + read.name + " is not one");
    return measure(std::get<PointSet>(read.content), read.name, options, budget);
}

/// Of maps with chances, the measure that these make, on points of the chaos game; beside it what is known exactly. Nothing of maps
/// without them, and where density does not matter.
std::optional<ScalingReport> measured_by_chances(const IteratedFunctions& maps,
                                                 const Options& options, const Budget& budget) {
    if (!maps.maps.front().probability || maps.states.size() != 1 ||
        options.measure == Measure::divider || options.measure == Measure::lacunarity)
        return std::nullopt;
    constexpr std::uint64_t usual_points = 200'000;
    IteratedFunctions game = maps;
    game.generations.reset();
    game.points = maps.points.value_or(usual_points);
    const GeneratorFigure figure = game.measured_figure(budget);
    ScalingReport found =
        measured_otherwise(options.measure, figure.name, dots_of(*figure.figure, budget).value(),
                           options.places(), budget);
    if (options.measure == Measure::multifractal)
        found.exact = maps.exact_spectrum(orders, budget);
    else if (options.measure == Measure::information)
        found.exact = maps.exact_spectrum(std::span(&information_order, 1), budget);
    return found;
}

/// Measured by a measure other than boxes.
ScalingReport other_measured(const Options& options, const Budget& budget) {
    if (is_generator(options.file)) {
        const auto generator = opened(options, budget);
        if (const auto* const maps = dynamic_cast<const IteratedFunctions*>(generator.get()))
            if (auto found = measured_by_chances(*maps, options, budget)) return *found;
        const GeneratorFigure figure = generator->measured_figure(budget);
        const auto dots = dots_of(*figure.figure, budget);
        return dots ? measured_otherwise(options.measure, figure.name, *dots, options.places(),
                                         budget)
                    : measured_otherwise(options.measure, figure.name, *figure.figure,
                                         options.places(), budget);
    }
    const Input read = input(options, budget);
    if (const auto* points = std::get_if<PointSet>(&read.content))
        return measured_otherwise(options.measure,
                                  read.name + ": " + std::to_string(points->points.size()) + " " +
                                      (points->part == "pixel" ? "pixels of ink" : "points"),
                                  *points, options.places(), budget);
    const NamedFigure named = drawn(std::get<Model>(read.content), options, budget);
    return measured_otherwise(options.measure, named.what, *named.figure, options.places(), budget);
}

/// The fractal of a Pisot substitution.
int print_rauzy(const Options& options, const Budget& budget) {
    const auto refuse = [](const char* option, bool given) {
        if (given) throw Error(std::string("--rauzy goes without ") + option);
    };
    refuse("--table", options.table);
    refuse("--within", options.within.has_value());
    refuse("--measure", options.measure != Measure::boxes);
    refuse("--latex", options.latex);
    refuse("-n", !options.generation.empty());
    refuse("--tile", options.tile);
    if (options.tiling && options.plot.empty())
        throw Error("--tiling says what --plot FILE draws, and no --plot is given");
    if (!options.plot.empty()) picture_format(options.plot);  // before the work
    if (options.file.empty()) throw Error("dimension: expected FILE");
    if (is_generator(options.file))
        throw Error("--rauzy is for systems, and " + options.file + " is not one");
    const Input read = input(options, budget);
    const auto* system = std::get_if<Model>(&read.content);
    if (!system) throw Error("--rauzy is for systems, and " + read.name + " is not one");
    const View<D0L> rules = as_d0l(*system);
    if (!rules) throw Error(read.name + ": " + rules.reason());
    RauzyReport report{(system->title.empty() ? read.name : system->title) + ", Rauzy fractal",
                       {},
                       rauzy_fractal(*rules, budget),
                       {}};
    for (const Symbol letter : report.found.letters)
        report.letters.push_back(system->alphabet.name(letter));
    if (report.found.tiles && report.letters.size() == 3)
        report.tile = tile(rauzy_lattice_set(*rules, budget), budget);
    if (!options.plot.empty()) {
        const auto figure =
            rauzy_figure(*rules, options.tiling.value_or(RauzyPicture::fractal), budget);
        PictureOptions picture;
        picture.title = report.what;
        draw_picture({figure.get(), report.what, ""}, target_of(options.plot),
                     picture_format(options.plot), picture, budget);
    }
    print_report(report, options.json);
    return success;
}

int dimension(const Options& options) {
    if (options.table) end_questions(false);  // it prints row by row
    const Budget budget = options.bounds.budget();
    if (options.rauzy) return print_rauzy(options, budget);
    if (options.tiling) throw Error("--tiling is for --rauzy");
    if (options.tile && options.plot.empty())
        throw Error("--tile says what --plot FILE draws, and no --plot is given");
    if (options.tile && (options.table || options.measure != Measure::boxes))
        throw Error("--tile is for --measure boxes, and not for --table");
    if (options.quick && !options.table) throw Error("--quick is for --table");
    if (options.table) {
        if (options.measure != Measure::boxes) throw Error("--table is for --measure boxes");
        if (options.within) throw Error("--within is for one system, not for --table");
        if (!options.let.empty()) throw Error("--let is for one system, not for --table");
        return print_table(options, budget);
    }
    if (options.file.empty()) throw Error("dimension: expected FILE, or --table");
    if (options.within && options.measure != Measure::boxes)
        throw Error("--within is for --measure boxes");
    if (!options.plot.empty() &&
        (options.tile || figure_format(options.plot) != FigureFormat::html))
        picture_format(options.plot);  // before the work
    if (options.latex && options.measure != Measure::boxes)
        throw Error("--latex is for --measure boxes");
    if (options.measure != Measure::boxes) {
        const bool plotted = options.measure == Measure::divider ||
                             options.measure == Measure::mass ||
                             options.measure == Measure::correlation;
        if (!options.plot.empty() && !plotted)
            throw Error("--plot is for --measure boxes, divider, mass and correlation");
        const ScalingReport found = other_measured(options, budget);
        if (!options.plot.empty()) plot_measured(found, options.plot, budget);
        print_report(found, options.json);
        return found.scaling.estimate ? success : undecided;
    }
    const DimensionReport found = measured(options, budget);
    if (options.tile)
        plot_tile(found, options, budget);
    else if (!options.plot.empty() && !found.counts.counts.empty()) {
        DimensionPlot plot{found.what, found.counts, found.fit};
        if (found.exact && found.exact->status == ExactDimension::Status::exact &&
            found.exact->value) {
            constexpr long bits = 64;
            plot.exact = found.exact->value->enclosure(bits).midpoint();
            constexpr std::size_t longest = 40;
            if (const std::string text = found.exact->value->text(); text.size() <= longest)
                plot.exact_text = text;
        }
        draw_dimension_plot(plot, options.plot, budget);
    }
    if (options.latex)
        print(to_latex(found));
    else
        print_report(found, options.json);
    if (found.bounds) return found.is_within() ? success : undecided;
    // What the rules say is an answer where no generation was asked about.
    if (found.late) return undecided;
    if (found.exact && found.exact->status == ExactDimension::Status::unfinished) return undecided;
    const bool exact = found.exact && found.exact->status == ExactDimension::Status::exact;
    return found.fit.estimate || (exact && !found.generation) ? success : undecided;
}

}  // namespace

void add_dimension(Verbs& verbs) {
    auto [verb, options] =
        verbs.add("dimension", "The fractal dimension of a figure, an image or points",
                  {"algae dimension koch --plot koch-dimension.svg",
                   "algae dimension coast.png --threshold 0.4 --json"},
                  dimension);
    verb.option("FILE", options.file, file_type,
                "a system or another generator (a file, - or a name from the gallery), an image "
                "(png), or points: a line of 1 to 3 numbers for each; with --table a folder");
    add_let_option(verb, options.let);
    verb.option("-n", options.generation, "N",
                "the generation (default: the last with at most 10,000,000 segments; 1,000,000 "
                "where words must be kept, and for measures other than boxes)");
    verb.option("--measure", options.measure, measure_named,
                "boxes|divider|mass|correlation|information|multifractal|lacunarity",
                "boxes (default), divider (lengths by dividers), mass (what lies within discs), "
                "correlation (pairs of points), information and multifractal (shares of boxes), "
                "lacunarity (gaps)");
    verb.output(
        "--plot", options.plot, "FILE",
        "a log-log plot of the counts, lengths, masses or pairs: .svg, .pdf, .png, .ps, "
        ".eps or .html; with --rauzy the fractal, each part in a colour; with --tile a tile");
    verb.option("--grids", options.grids, grid_count, "N",
                "over how many places of the grid counts are averaged (default 16)");
    verb.option("--within", options.within, width, "W",
                "systems: bounds that are proved, from above and from below, at most W apart where "
                "they come so near; otherwise the best, and the exit status is 3");
    verb.flag("--rauzy", options.rauzy,
              "systems whose letters multiply like a Pisot substitution: the fractal of their "
              "prefixes, whether it tiles and is connected, and the dimension of its boundary");
    verb.choice("--tiling", options.tiling,
                {{"periodic", std::optional(RauzyPicture::periodic)},
                 {"self-replicating", std::optional(RauzyPicture::self_replicating)}},
                "periodic|self-replicating",
                "with --rauzy and --plot: the fractal among its neighbours of a tiling");
    verb.flag("--tile", options.tile,
              "with --plot: a tile, as the limit of a system that fills an area or the attractor "
              "of maps may "
              "be, among its neighbours");
    verb.flag("--points", options.points,
              "FILE holds points, whatever its name and first line are");
    verb.option("--threshold", options.threshold, positive_or_zero, "T",
                "images: pixels darker than this are ink, 0 to 1 (default 0.5)");
    verb.flag("--invert", options.invert, "images: lighter pixels are ink");
    verb.option("--seed", options.seed, "S", "of the word of a system with choices");
    verb.flag("--table", options.table,
              "a line for every system of the gallery, or of the folder FILE: the dimension from "
              "the rules, its boundary, and measured on the limit with 8 grids (or --grids) and "
              "about 50,000 cells, less exactly than without --table; minutes for the gallery");
    verb.flag("--quick", options.quick, "with --table: without measuring");
    verb.json_flag(options.json, "print one JSON object; with --table an array");
    verb.latex_flag(options.latex,
                    "print sentences, with --table a table, as LaTeX, which needs amsmath");
    verb.bounded_by(options.bounds);
}

}  // namespace algae::command
