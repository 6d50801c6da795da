#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "exact/exact.hpp"
#include "system/system.hpp"

namespace algae {
struct Model;
class Environment;
class Generator;
}  // namespace algae

namespace algae::command {

class Verb;

/// The meaning of FILE on the command line, for help texts.
inline constexpr const char* file_help =
    "a file, - for standard input, a name from the gallery, or a system such as 'a -> ab, b -> a'";

/// The type of such an argument.
inline constexpr const char* file_type = "FILE|NAME";

/// Throws Error, that a file or folder cannot be read, or std::bad_alloc where the reason is that memory ended.
[[noreturn]] void throw_unreadable(const std::string& name, std::error_code reason);

/// The bytes of a file in pieces: each call puts at most so many characters there and gives their number, 0 at
/// the end. "-" is standard input. Throws Error, now or at a call, if the file cannot be read or is a folder. The budget must outlive this.
std::function<std::size_t(char*, std::size_t)> file_source(const std::string& path,
                                                           const Budget& budget);

/// The bytes of a file. Throws Error if it cannot be read or is a folder, BoundReached if reading
/// it as a system would take more memory than the budget has.
std::string file_text(const std::string& path, const Budget& budget);

/// A text and its name in messages.
struct SourceText {
    std::string name, text;
};

/// The text of FILE: of a path, "-" for standard input, or a name from the gallery. A system that is typed in its place, or that
/// has constants of --let, is a text in the notation.
SourceText open_text(const std::string& file, const Budget& budget,
                     const std::vector<std::string>& let = {});

/// The system in FILE: a path, "-" for standard input, a name from the gallery, or the system itself, typed on one line.
/// `let` are constants that replace those of the system, `a1=35`. Throws Error, Diagnostics or BoundReached.
Model open_model(const std::string& file, const Budget& budget,
                 const std::vector<std::string>& let = {});

/// Its rules alone.
LSystem open_system(const std::string& file, const Budget& budget,
                    const std::vector<std::string>& let = {});

/// `--let NAME=VALUE`, any number of times.
void add_let_option(Verb& verb, std::vector<std::string>& let);

/// An option that replaces a statement of a relative's file, with its text on the command line;
/// an empty text means that the option is not given.
struct StatementOption {
    std::string option, key, text;  // "--points", "points", "1000"
};

/// Whether FILE has a relative, by its extension.
bool is_generator(const std::string& file);
/// The relative in FILE; options replace statements of the file.
std::unique_ptr<Generator> open_generator(const std::string& file, const Budget& budget,
                                          const std::vector<StatementOption>& said = {});
/// The relative of one kind, "ifs", that FILE and the options describe, or the options alone if there is no
/// FILE. If a system of the gallery has the same name, the name means the relative.
std::unique_ptr<Generator> open_kind(const std::string& kind, const std::string& file,
                                     const Budget& budget,
                                     const std::vector<StatementOption>& said);

/// The folder of a file, "." for standard input.
std::string folder_of(const std::string& file);

/// The files in a folder and in those below it, in the order of their names. Throws Error, which names what cannot be read.
std::vector<std::filesystem::path> files_below(const std::filesystem::path& folder);

/// Makes a folder, and those above it, unless they are there. Throws Error.
void make_folders(const std::filesystem::path& folder);

/// How names of systems in a text are read: as a file in the first of these folders that has it, otherwise as on the command line.
/// Unless `outside`, only files in these folders and below are read, wherever links lead, and names of the gallery: a text
/// of somebody else cannot look around.
std::function<Model(const std::string&)> systems_from(const std::vector<std::string>& folders,
                                                      const Budget& budget, bool outside);

/// `--allow-outside`
void add_outside_flag(Verb& verb, bool& outside);

/// `--environment 'COMMAND'`. Only the command line, never a file, says which program runs.
void add_environment_option(Verb& verb, std::string& program);

/// The program of --environment, started; nullptr where the option is not given. Throws Error if no
/// module of the system asks a program.
std::shared_ptr<Environment> external_environment(const std::string& program,
                                                  const LSystem& system);

}  // namespace algae::command
