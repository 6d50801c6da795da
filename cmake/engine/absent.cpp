// What both engines of a static page (tools/engine) have in place of parts of the command that they leave out: verbs that the page does
// not ask, the formats of other programs, the server itself, and bounds of memory, which WebAssembly sets.

#include "command/detail/memory.hpp"
#include "command/detail/pictures.hpp"
#include "command/detail/verb.hpp"
#include "exchange/exchange.hpp"
#include "growth/growth.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "render/render.hpp"
#include "studio/studio.hpp"

namespace algae {

namespace {

[[noreturn]] void refuse(const char* what) {
    throw Error(std::string(what) + ": the engine of this page does not have it; the command has");
}

}  // namespace

// Texts that come with the command and that no question of the page needs.
std::span<const GalleryEntry> generator_gallery() { return {}; }
std::span<const GalleryEntry> lesson_code() { return {}; }
std::span<const GalleryEntry> formal_texts() { return {}; }
std::vector<EditorFile> editor_files() { return {}; }

// Files of other programs.
std::vector<Conversion> conversions() { return {}; }
std::string converted(std::string_view, const std::string&, const std::string&, const std::string&,
                      const Budget&) {
    refuse("another format");
}
const std::vector<SystemFormat>& system_formats() {
    static const std::vector<SystemFormat> none;
    return none;
}
const SystemFormat* system_format(std::string_view) { return nullptr; }
const SystemFormat* system_format_of(std::string_view) { return nullptr; }
const GeneratorFormat* generator_format(std::string_view) { return nullptr; }
std::pair<std::string, std::string> file_and_entry(const std::string& name) { return {name, ""}; }
bool is_below(const std::string&, const std::string&) { return false; }
std::string text_with_included(const std::string& path, const FileText& text_of) {
    return text_of(path);
}
std::optional<CpfgFiles> cpfg_files_at(const std::string&, const FileText&) { return {}; }
Model cpfg_model(const CpfgFiles&, const FileText&) { refuse("a file of cpfg"); }

// Pictures as input, and plots as files: the page draws its own.
bool is_png(std::string_view) { return false; }
Plot growth_plot(const D0L&, std::uint64_t, std::uint64_t, const Budget&) { refuse("a plot"); }
void draw_plot(const Plot&, const std::string&, const Budget&) { refuse("a plot"); }

// The server.
void serve(const Studio&) { refuse("a server"); }
std::string random_token() { refuse("a server"); }
std::string_view studio_page() { refuse("a server"); }
std::vector<Answered> answer_apart(const std::vector<std::string>&,
                                   const std::function<int(const std::string&)>&,
                                   const StudioShare&, const std::function<bool(std::size_t)>&) {
    refuse("the marking of a class");
}

}  // namespace algae

namespace algae::command {

// A note on standard error, which the page does not show beside an answer.
void note_rounding(const Model&, std::uint64_t, const std::string&) {}

void bound_memory(std::uint64_t) {}
bool is_memory_used_up() { return false; }

void add_words(Verbs&) {}
void add_infer(Verbs&) {}
void add_closure(Verbs&) {}
void add_census(Verbs&) {}
void add_draw(Verbs&) {}
void add_tree(Verbs&) {}
void add_figures(Verbs&) {}
void add_generators(Verbs&) {}
void add_latex(Verbs&) {}
void add_manual(Verbs&) {}

}  // namespace algae::command
