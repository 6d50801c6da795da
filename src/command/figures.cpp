// `algae figures`: every file of a folder is drawn, and what it expects of its figure is checked.
//
// Files are drawn in parallel by threads. A file that fails is reported at the end and does not stop the others; the
// run ends with the worst status. Pictures keep the folders of their files; files whose names differ only in their
// extensions keep these too. --page makes a page of small pictures with the texts of the files beside them.

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <mutex>
#include <tuple>

#include "command/detail/files.hpp"
#include "command/detail/output.hpp"
#include "command/detail/pictures.hpp"
#include "command/detail/verb.hpp"
#include "exact/exact.hpp"
#include "exchange/exchange.hpp"
#include "language/language.hpp"
#include "model/model.hpp"
#include "nature/nature.hpp"
#include "notation/notation.hpp"
#include "render/render.hpp"

namespace algae::command {

namespace {

namespace fs = std::filesystem;

constexpr const char* previews = "previews";  // folder of the page's small pictures
constexpr double preview_width = 480;         // pixels

struct Options {
    std::string folder = "figures", out = "out/figures";
    std::optional<std::uint64_t> jobs;
    std::vector<std::string> formats{"svg", "pdf"};
    bool captions = false, check = false, json = false, page = false;
    Bounds bounds;
};

/// The result for one file.
struct Outcome {
    fs::path file, group;  // the group is its folder within that of all, empty if it is the same
    std::string stem;      // of its pictures' names
    std::vector<std::string> pictures, problems;
    std::vector<Rounded> rounded;  // those of its figures whose parameters are doubles
    int status = success;
    std::string title, source, text, preview;  // for the page
};

bool is_figure_file(const fs::path& path) {
    return path.extension() == ".lsys" || is_generator(path.string()) ||
           system_format(path.string());
}

/// All files of figures in a folder, those of a group together, sorted by name. Pictures of files that
/// differ only in their extensions keep these in their names.
std::vector<Outcome> figure_files(const fs::path& folder) {
    std::error_code ignored;
    if (!fs::is_directory(folder, ignored))
        throw Error(folder.string() +
                    ": expected a folder of .lsys files and of files of generators");
    std::vector<Outcome> files;
    std::map<fs::path, std::size_t> of_stem;
    for (const fs::path& file : files_below(folder)) {
        if (!is_figure_file(file)) continue;
        const fs::path group = fs::relative(file.parent_path(), folder).lexically_normal();
        Outcome& outcome = files.emplace_back();
        outcome.file = file;
        outcome.group = group == "." ? fs::path() : group;
        outcome.stem = file.stem().string();
        ++of_stem[outcome.group / outcome.stem];
    }
    if (files.empty())
        throw Error(folder.string() + ": holds no .lsys files and none of generators");
    for (Outcome& outcome : files)
        if (of_stem[outcome.group / outcome.stem] > 1)
            outcome.stem = outcome.file.filename().string();
    std::ranges::sort(files, [](const Outcome& a, const Outcome& b) {
        return std::tie(a.group, a.file) < std::tie(b.group, b.file);
    });
    return files;
}

/// Where the picture of a file goes, in this format.
std::string picture_path(const fs::path& out, const Outcome& outcome, const std::string& format) {
    const fs::path folder = (out / outcome.group).lexically_normal();
    make_folders(folder);
    return (folder / outcome.stem).string() + '.' + format;
}

/// All pictures of a file.
void draw_formats(const Options& options, Outcome& outcome, const std::vector<Plate>& plates,
                  const Drawing& drawing, const Budget& budget) {
    PictureOptions picture;
    picture.columns = drawing.columns;
    picture.labels = labels_of(drawing);
    picture.common_scale = has_common_scale(drawing, plates);
    for (const std::string& format : options.formats) {
        const std::string path = picture_path(options.out, outcome, format);
        draw_plates(plates, path, picture_format(path), picture, budget);
        outcome.pictures.push_back(path);
    }
    if (!options.page) return;
    PictureOptions small = picture;
    small.width = preview_width;
    const std::string path = picture_path(fs::path(options.out) / previews, outcome, "png");
    draw_plates(plates, path, PictureFormat::png, small, budget);
    outcome.preview = path;
}

/// Writes the page of all pictures, with the problems of those that were not drawn.
void write_page(const Options& options, const std::vector<Outcome>& outcomes) {
    const auto from_page = [&](const std::string& path) {
        return fs::relative(path, options.out).generic_string();
    };
    std::vector<PagePicture> pictures;
    const std::string own = fs::weakly_canonical(options.folder).filename().string();
    for (const Outcome& outcome : outcomes) {
        PagePicture picture;
        picture.group = outcome.group.empty() ? own : outcome.group.generic_string();
        picture.name = outcome.file.filename().string();
        picture.title = outcome.title;
        picture.source = outcome.source;
        if (!outcome.preview.empty()) picture.preview = from_page(outcome.preview);
        picture.problems = outcome.problems;
        picture.text = outcome.text;
        for (const std::string& path : outcome.pictures) picture.files.push_back(from_page(path));
        pictures.push_back(std::move(picture));
    }
    write_file((fs::path(options.out) / "index.html").string(), picture_page("Figures", pictures));
}

void draw_generator_file(const Options& options, Outcome& outcome, const Budget& budget) {
    const std::unique_ptr<Generator> generator = open_generator(outcome.file.string(), budget);
    outcome.title = generator->title;
    outcome.source = generator->source;
    if (options.check) return;
    const std::vector<GeneratorFigure> figures = generator->figures(budget);
    const bool captions = options.captions || figures.size() > 1;
    Drawing apart;
    apart.common_scale = false;
    draw_formats(options, outcome, generator_plates(figures, captions, ""), apart, budget);
}

/// The pictures of a file that shows a tree, a table or a plot.
void draw_other_formats(const Options& options, Outcome& outcome, const Model& system,
                        const Budget& budget) {
    const auto draw = [&](const std::string& path, const PictureOptions& picture) {
        draw_other(system, shown_generations(system), path, picture_format(path), picture, budget);
    };
    for (const std::string& format : options.formats) {
        outcome.pictures.push_back(picture_path(options.out, outcome, format));
        draw(outcome.pictures.back(), {});
    }
    if (!options.page) return;
    PictureOptions small;
    small.width = preview_width;
    outcome.preview = picture_path(fs::path(options.out) / previews, outcome, "png");
    draw(outcome.preview, small);
}

void draw_one(const Options& options, Outcome& outcome, const Budget& budget) {
    if (options.page) outcome.text = file_text(outcome.file.string(), budget);
    if (is_generator(outcome.file.string())) return draw_generator_file(options, outcome, budget);
    const Model system = open_model(outcome.file.string(), budget);
    outcome.title = system.title;
    outcome.source = system.source;
    for (const Mismatch& unmet : unmet_expectations(system, budget)) {
        outcome.problems.push_back(to_string(unmet.place) + ": error: " + unmet.message);
        outcome.status = refuted;
    }
    if (options.check) return;
    if (is_other_picture(system.drawing))
        return draw_other_formats(options, outcome, system, budget);
    FigurePlates plates(system, shown_generations(system), {}, budget);
    outcome.rounded = rounded_figures(plates.figures);
    if (options.captions) plates.caption_with_facts();
    draw_formats(options, outcome, plates.plates(), system.drawing, budget);
}

int draw_folder(const Options& options) {
    const Budget budget = options.bounds.budget();
    for (const std::string& format : options.formats) picture_format("figure." + format);
    std::vector<Outcome> outcomes = figure_files(options.folder);
    if (!options.check) make_folders(options.out);

    ProgressBar bar("Figures");
    std::mutex reporting;
    std::size_t done = 0;
    const PartWorker work = [&](std::size_t i) {
        try {
            draw_one(options, outcomes[i], budget);
        } catch (const Interrupted&) {
            throw;
        } catch (const BoundReached& bound) {
            outcomes[i].problems.push_back(bound.what());
            outcomes[i].status = undecided;
        } catch (const std::exception& error) {
            outcomes[i].problems.push_back(error.what());
            outcomes[i].status = bad_input;
        }
        const std::lock_guard lock(reporting);
        bar.report(static_cast<double>(++done) / static_cast<double>(outcomes.size()));
    };
    const std::uint64_t jobs = options.jobs ? std::clamp<std::uint64_t>(*options.jobs, 1, 256) : 0;
    // Each figure checks the budget itself, so that the results of the others are reported even if a bound is reached.
    each_part(
        outcomes.size(), static_cast<unsigned>(jobs), Budget(), [&] { return work; }, 1);
    if (options.page && !options.check) write_page(options, outcomes);

    int status = success;
    std::size_t pictures = 0, wrong = 0;
    Json all = Json::array();
    for (const Outcome& outcome : outcomes) {
        for (const std::string& problem : outcome.problems)
            std::cerr << printable((problem.starts_with(outcome.file.string())
                                        ? ""
                                        : outcome.file.string() + ": ") +
                                   problem)
                      << '\n';
        if (!outcome.rounded.empty())
            note(outcome.file.string() + ": " + rounding_text(outcome.rounded));
        Json rounded = Json::array();
        for (const auto& [name, reason] : outcome.rounded)
            rounded.add({{"figure", name}, {"reason", reason}});
        wrong += outcome.problems.empty() ? 0 : 1;
        pictures += outcome.pictures.size();
        status = std::max(status, outcome.status);
        all.add({{"file", outcome.file.string()},
                 {"pictures", outcome.pictures},
                 {"problems", outcome.problems},
                 {"rounded", std::move(rounded)}});
    }
    if (options.json)
        print(Json{{"figures", all}}.text());
    else
        print(counted(outcomes.size(), "system") + ", " + counted(pictures, "picture") +
              (options.check ? "" : " in " + options.out) +
              (wrong ? ", " + std::to_string(wrong) + " with problems" : "") + "\n");
    return status;
}

}  // namespace

void add_figures(Verbs& verbs) {
    auto [verb, options] =
        verbs.add("figures", "Draws every system of a folder and checks what its file expects",
                  {"algae figures figures --out out/figures",
                   "algae figures my-paper --formats pdf --captions"},
                  draw_folder);
    verb.option(
        "DIR", options.folder, "DIR",
        "a folder of .lsys files and of files of generators, such as .ifs (default figures)");
    verb.output("--out", options.out, "DIR", "where the pictures go (default out/figures)");
    verb.option("--formats", options.formats, list, "svg|pdf|png|ps|eps,...",
                "svg, pdf, png, ps, eps (default svg,pdf)");
    verb.option("--jobs", options.jobs, natural, "N",
                "how many to draw at a time (default: one a core)");
    verb.flag("--captions", options.captions, "system, generation and angle underneath");
    verb.flag("--check", options.check, "only check what the files expect");
    verb.flag("--page", options.page, "write index.html as well, a page with all of them");
    verb.json_flag(options.json);
    verb.bounded_by(options.bounds);
}

}  // namespace algae::command
