#include <filesystem>

#include "base/error.hpp"
#include "cli/command.hpp"
#include "cli/input.hpp"
#include "cli/output.hpp"
#include "exchange/relative_format.hpp"
#include "exchange/system_format.hpp"
#include "notation/relative_reader.hpp"
#include "notation/format.hpp"
#include "render/output.hpp"

namespace algae::cli {

namespace {

struct Options {
    std::string file;
    bool in_place = false;
    bool check = false;
    Bounds bounds;
};

[[noreturn]] void refuse(const std::string& name, const std::string& what, const std::string& to) {
    throw Error(name + " is " + what + "; expected a file of the notation, as `algae convert --to " +
                to + "` makes of it");
}

int format(const Options& options) {
    const SourceText source = open_text(options.file, options.bounds.budget());
    if (const SystemFormat* foreign = system_format(source.name))
        refuse(source.name, foreign->what, "lsys");
    if (const RelativeFormat* foreign = relative_format(source.name))
        refuse(source.name, foreign->what, foreign->kind);
    const std::string text = relative_kind(source.name) ? format_relative(source.text, source.name)
                                                         : format_lsystem(source.text, source.name);
    if (options.check) return source.text == text ? success : refuted;
    if (!options.in_place) {
        print(text);
        return success;
    }
    if (options.file == "-" || !std::filesystem::exists(options.file))
        throw Error("--in-place: expected a file, found " +
                    std::string(options.file == "-" ? "standard input" : "the figure " + options.file + " of the gallery"));
    FileOutput file(options.file);
    file.write(text.data(), text.size());
    file.commit();
    return success;
}

}  // namespace

void add_fmt(Verbs& verbs) {
    auto options = std::make_shared<Options>();
    CLI::App& verb = add_verb(verbs, "fmt", "The canonical text of a system, comments kept",
                              "  algae fmt koch\n  algae fmt --in-place my.lsys", options, format);
    verb.add_option("FILE", options->file, file_help)->type_name(file_type)->required();
    verb.add_flag("--in-place", options->in_place, "write the file instead of standard output");
    verb.add_flag("--check", options->check, "print nothing; exit 1 if the file is not in canonical form");
    options->bounds.add_to(verb);
}

}  // namespace algae::cli
