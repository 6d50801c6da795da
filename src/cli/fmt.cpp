#include "cli/command.hpp"
#include "cli/input.hpp"
#include "cli/output.hpp"
#include "notation/print.hpp"
#include "render/output.hpp"

namespace algae::cli {

namespace {

struct Options {
    std::string file;
    bool in_place = false;
    bool check = false;
    Bounds bounds;
};

int format(const Options& options) {
    const Budget budget = options.bounds.budget();
    const LSystem system = open_system(options.file, budget);
    const std::string text = print_lsystem(system);
    if (options.check) return file_text(options.file, budget) == text ? success : refuted;
    if (!options.in_place) {
        print(text);
        return success;
    }
    FileOutput file(options.file);
    file.write(text.data(), text.size());
    file.commit();
    return success;
}

}  // namespace

void add_fmt(Verbs& verbs) {
    auto options = std::make_shared<Options>();
    CLI::App& verb = add_verb(verbs, "fmt", "The canonical text of a system",
                              "  algae fmt koch\n  algae fmt --in-place my.lsys", options, format);
    verb.add_option("FILE", options->file, file_help)->required();
    verb.add_flag("--in-place", options->in_place, "write the file instead of standard output");
    verb.add_flag("--check", options->check, "print nothing; exit 1 if the file is not in canonical form");
    options->bounds.add_to(verb);
}

}  // namespace algae::cli
