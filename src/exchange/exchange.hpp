#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "exact/exact.hpp"
#include "nature/nature.hpp"
#include "notation/notation.hpp"
#include "system/system.hpp"

// exchange: files of other programs (Brno's geometric interpreter, a Maple worksheet, a NetLogo model,
// printed tables), read and written, and one kind of file converted into another. A format that cannot say
// something of a system says what.

namespace algae {

struct Model;

/// A way from one text format to another: what the end of a file's name says, and what is made of it.
struct Conversion {
    std::string from, to;
    std::string what;  // "a curve's graph-directed iterated function system"
};

/// All conversions that there are: those between kinds of generators, and for each format of
/// `system_formats` the one into `lsys` and the one out of it.
std::vector<Conversion> conversions();

/// The text in another format. From one of `system_formats` to another it goes by way of `lsys`. In its
/// own format it is the canonical text.
///
/// Throws Diagnostics or Error with the reason where the text is faulty or the other format cannot
/// say it, and Error with the formats that this one can become if there is no such conversion.
std::string converted(std::string_view text, const std::string& name, const std::string& from,
                      const std::string& to, const Budget& budget);

/// A text format in which another program keeps L-systems.
struct SystemFormat {
    std::string name;  // the end of its files' names, without the point: "brno"
    std::string what;  // "a text file of the geometric interpreter"
    /// The system that the text says; `name` is what errors call the file. Throws `Diagnostics` with
    /// every fault it can name.
    Model (*read)(std::string_view text, const std::string& name);
    /// The text of a system; it reads back as a system with the same words and figures. Throws Error
    /// that names what the format cannot say.
    std::string (*print)(const Model& system);
};

/// All of them.
const std::vector<SystemFormat>& system_formats();

/// A file and one of the systems in it: `fractint.l:Dragon` are `fractint.l` and `Dragon`; the latter is empty if the name is one of a
/// file alone.
///
/// Example: file_and_entry("fractint.l:Dragon").second == "Dragon"
std::pair<std::string, std::string> file_and_entry(const std::string& name);

/// The format whose files end as this name does, behind which one of several systems may be named; nullptr if there is none.
///
/// Example: system_format("koch.lsys") == nullptr
const SystemFormat* system_format(std::string_view file_name);

/// The format that a text is in by what stands in it, whatever its name: of those that no other text looks like; nullptr if it is
/// none of them. Linear.
///
/// Example: system_format_of("msd_2\n0 0\n0 -> 0\n1 -> 0\n")->name == "walnut"
const SystemFormat* system_format_of(std::string_view text);

/// The text of a file that another includes; nothing if there is none of this name that may be read.
using IncludedText = std::function<std::optional<std::string>(const std::string& name)>;

/// A text of cpfg or lpfg with the text of a file for each line `#include "NAME"`, and for those that it includes. Between the files stand
/// lines `# 1 "NAME"`, by which errors of the readers name their places. Names are those of files in the folder of the file that includes
/// them; a line stays where there is no such file. Throws Diagnostics where files include each other in a circle, and above 10 MB.
///
/// Example: cpfg_with_included("#include \"b\"\n", "a", [](const auto&) { return "A\n"; }) == "# 1 \"b\"\nA\n# 2 \"a\"\n"
std::string cpfg_with_included(std::string_view text, const std::string& name,
                               const IncludedText& text_of);

/// The files of a model of cpfg: the system, and how it is shown. The latter are empty where there are none.
struct CpfgFiles {
    std::string system, view, animation;
};

/// What a file `specifications` of the program says by the command line in it, `cpfg -m plant.map plant.l plant.v plant.a`. Throws Error if it
/// names no system. The names have no folder.
///
/// Example: cpfg_files("cpfg -m a.map a.l b.v\n", "specifications").view == "b.v"
CpfgFiles cpfg_files(std::string_view text, const std::string& name);

/// A system of cpfg as a view file (`*.v`) of the program shows it: the angle of turns without a number, widths of lines, where the viewer
/// stands. Colours, surfaces and lights are left out. Throws Diagnostics for what would change the figure and has no meaning in the notation: tropisms, widths
/// that grow by a number.
Model with_cpfg_view(const Model& system, std::string_view text, const std::string& name);

/// The generations that an animation file (`*.a`) of cpfg shows. Throws Diagnostics where these are no range.
std::pair<std::uint64_t, std::uint64_t> cpfg_frames(std::string_view text, const std::string& name);

/// Gives the text of a file; throws Error for one that cannot, or may not, be read.
using FileText = std::function<std::string(const std::string& path)>;

/// Whether a file lies in a folder or below, wherever links lead; false if one of them is not there.
bool is_below(const std::string& file, const std::string& folder);

/// The text of a file; one of cpfg has the files that it includes: those that lie in its folder or below, wherever links lead.
std::string text_with_included(const std::string& path, const FileText& text_of);

/// The files of a model of cpfg that a path stands for: a system has the view beside it, a view or an animation its system, `specifications`
/// names all of them. Nothing if it is none of these. Throws Error where the system of a view is missing.
std::optional<CpfgFiles> cpfg_files_at(const std::string& path, const FileText& text_of);

/// The model of cpfg as its files say it; of a system of Fractint, which ends in `.l` too, the system alone. Throws Diagnostics.
Model cpfg_model(const CpfgFiles& files, const FileText& text_of);

/// The terms of a b-file of the OEIS: a line `n a(n)` for each, n going up by 1; `#` begins a comment.
struct BFile {
    Integer first;  // the n of the first term
    std::vector<Integer> terms;
};

/// Throws Diagnostics with the place of a line that is none, or whose n is not the next one. Linear time.
///
/// Example: read_b_file("0 1\n1 1\n2 2\n", "b000045.txt").terms.size() == 3
BFile read_b_file(std::string_view text, const std::string& name);

/// Whether the first line of a text that is not blank or a comment has two whole numbers, as in a b-file.
///
/// Example: looks_like_b_file("# A000045\n0 0\n") && !looks_like_b_file("axiom a")
bool looks_like_b_file(std::string_view text);

/// The lines.
///
/// Example: print_b_file({0, {1, 1}}) == "0 1\n1 1\n"
std::string print_b_file(const BFile& file);

/// A printed form of a kind of generators, such as the table of an iterated function system.
struct GeneratorFormat {
    std::string name;  // the end of its files' names, without the point: "ifs-table"
    std::string kind;  // that of the files of the notation which say the same: "ifs"
    std::string what;  // "the table of an iterated function system"
    /// What the text says as a file of the kind, its places those of the text. Throws Diagnostics.
    GeneratorFile (*read)(std::string_view text, const std::string& name);
    /// The text of a generator of the kind. Throws Error that names what it cannot say.
    std::string (*print)(const Generator& generator);
};

/// All of them.
const std::vector<GeneratorFormat>& generator_formats();

/// The format whose files end as this name does; nullptr if there is none.
///
/// Example: generator_format("fern.ifs") == nullptr
const GeneratorFormat* generator_format(std::string_view file_name);

/// A cellular automaton on a line between fixed states as a system with interactions whose words are
/// its configurations: a rule for each local configuration, and near the ends, where a word has no
/// letters for the context, rules with shorter contexts that take the state outside for them. Of the
/// rules that match, the longest context wins, so each letter has exactly one.
///
/// Throws Error if the edges are joined, which no context reaches over, if there are two dimensions,
/// or if there would be more than 20,000 rules.
Model system_of_cells(const CellularAutomaton& automaton);

}  // namespace algae
