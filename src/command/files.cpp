// The meaning of FILE: a path, `-` for standard input, a name from the gallery, or a system that is typed on the command
// line, in this order. A text that has an arrow, or begins with `axiom`, is meant as a system; a message about anything else says how one
// is typed.
//
// If a system is expected, the extension chooses the reader: .lsys and names without an extension are the
// notation, formats of other programs have readers of their own, and a file of another generator (
// fern.ifs, rule-30.ca) is refused by name. For generators it is the other way round: `algae ifs fern` looks
// for fern.ifs in the gallery before a system called fern, and options of the command line replace
// statements of the file.

#include "command/detail/files.hpp"
#include "nature/nature.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <utility>

#include "command/detail/verb.hpp"
#include "exact/exact.hpp"
#include "exchange/exchange.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "render/render.hpp"
#include "turtle/turtle.hpp"

namespace algae::command {

namespace {

/// The memory that reading takes, in bytes for each byte of the file.
constexpr std::uint64_t memory_of_a_byte = 16;

struct Closer {
    void operator()(std::FILE* file) const {
        if (file) std::fclose(file);
    }
};

bool exists(const std::string& path) {
    std::error_code ignored;
    return std::filesystem::exists(path, ignored);
}

const GalleryEntry* find_system(const std::string& name) {
    for (const GalleryEntry& entry : gallery())
        if (entry.name == name) return &entry;
    return nullptr;
}

}  // namespace

void throw_unreadable(const std::string& name, std::error_code reason) {
    if (reason == std::errc::not_enough_memory) throw std::bad_alloc();
    throw Error("cannot read " + name + ": " + reason.message());
}

std::function<std::size_t(char*, std::size_t)> file_source(const std::string& path,
                                                           const Budget& budget) {
    std::error_code ignored;
    if (path != "-" && std::filesystem::is_directory(path, ignored))
        throw Error(path + ": is a folder, expected a file");
    const std::shared_ptr<std::FILE> file =
        path == "-" ? std::shared_ptr<std::FILE>(stdin, [](std::FILE*) {})
                    : std::shared_ptr<std::FILE>(std::fopen(path.c_str(), "rb"), Closer());
    const int refused = errno;
    budget.check();
    if (!file) throw_unreadable(path, {refused, std::generic_category()});
    if (path != "-") keep_input(path);
    return
        [file, &budget, name = path == "-" ? "standard input" : path](char* to, std::size_t most) {
            budget.check();
            errno = 0;
            const std::size_t count = std::fread(to, 1, most, file.get());
            const int reason = errno;
            if (count == 0) budget.check();  // reading that waited was interrupted
            if (count == 0 && std::ferror(file.get()))
                throw_unreadable(name, {reason, std::generic_category()});
            return count;
        };
}

std::string file_text(const std::string& path, const Budget& budget) {
    // Standard input can be read once, and several parts of a verb may ask for what it says.
    static std::optional<std::string> said;
    if (path == "-" && said) return *said;
    const auto more = file_source(path, budget);
    const std::uint64_t largest = budget.memory / memory_of_a_byte;
    std::string text;
    std::string buffer(std::size_t{1} << 16, '\0');
    while (const std::size_t count = more(buffer.data(), buffer.size())) {
        text.append(buffer, 0, count);
        if (text.size() > largest)
            throw BoundReached(
                Bound::memory,
                (path == "-" ? "standard input" : path) + ": has more than " +
                    std::to_string(largest >> 20) + " MiB, as much as can be read within the " +
                    std::to_string(budget.memory >> 20) + " MiB allowed by --max-memory");
    }
    if (path == "-") said = text;
    return text;
}

namespace {

constexpr const char* typed_name = "typed system";

/// What a name that means nothing may have been meant as.
std::string perhaps_a_system(const std::string& name) {
    if (name.ends_with("-"))
        return "; between no quotation marks the shell takes '>' for itself: a system is typed as "
               "'a -> ab, b -> a'";
    if (name.find_first_of("=: ,;") != std::string::npos)
        return "; a system is typed with arrows: 'a -> ab, b -> a'";
    return "; `algae gallery` lists them";
}

[[noreturn]] void refuse_missing(const std::string& file) {
    std::vector<std::string> names;
    for (const GalleryEntry& entry : gallery()) names.emplace_back(entry.name);
    for (const GalleryEntry& entry : generator_gallery()) names.emplace_back(entry.name);
    throw Error("no file \"" + file + "\", and nothing of that name in the gallery" +
                did_you_mean(file, names) + perhaps_a_system(file));
}

/// Whether a text with an arrow is the name of a file nevertheless: it ends as files of systems do.
bool ends_as_file(const std::string& text) {
    return text.ends_with(".lsys") || system_format(text) || generator_kind(text) ||
           generator_format(text);
}

/// Opens files, each after a question whether that may be: a name can stand for several files.
struct Opener {
    const Budget& budget;
    std::function<void(const std::string&)> allow;  // throws Error for a file that may not be read

    std::string text(const std::string& path) const {
        if (allow) allow(path);
        return file_text(path, budget);
    }
    FileText reader() const {
        return [this](const std::string& path) { return text(path); };
    }
};

/// A text that is in a file, in standard input or in the gallery; nothing if there is none of this name.
std::optional<SourceText> stored_text(const std::string& file, const Opener& open) {
    if (file == "-") return SourceText{"standard input", open.text(file)};
    if (exists(file)) return SourceText{file, text_with_included(file, open.reader())};
    if (const auto [path, entry] = file_and_entry(file); !entry.empty() && exists(path))
        return SourceText{file, text_with_included(path, open.reader())};
    if (const GalleryEntry* entry = find_system(file))
        return SourceText{std::string(entry->name), std::string(entry->text)};
    if (const GalleryEntry* entry = find_generator(file))
        return SourceText{std::string(file_name(*entry)), std::string(entry->text)};
    return std::nullopt;
}

/// The constants of --let, each NAME=VALUE.
ConstantValues constants_of(const std::vector<std::string>& let) {
    ConstantValues constants;
    for (const std::string& one : let) {
        const std::size_t equals = one.find('=');
        if (equals == std::string::npos || equals == 0 || equals + 1 == one.size())
            refuse("--let", "NAME=VALUE, such as a1=35", one);
        const std::string name = one.substr(0, equals), value = one.substr(equals + 1);
        if (value.find("..") != std::string::npos)
            throw Error("--let " + one +
                        ": expected one value; panels of `algae draw` show a range");
        for (const auto& [known, quantity] : constants)
            if (known == name)
                throw Error("--let: the constant " + algae::quoted(name) + " is given twice");
        try {
            constants.emplace_back(
                name, evaluate(read_expression(value),
                               [](const std::string&) -> const Quantity* { return nullptr; }));
        } catch (const Diagnostics& error) {
            throw Error("--let " + one + ": " + error.findings().front().message);
        }
    }
    return constants;
}

/// What a text is that is no system in the notation, by how it begins or by words that stand there; empty if it may be one.
std::string foreign_format(std::string_view text) {
    static constexpr std::array<std::pair<std::string_view, const char*>, 7> beginnings{
        {{"\x89PNG", "a PNG picture"},
         {"GIF8", "a GIF picture"},
         {"%PDF", "a PDF document"},
         {"<", "XML, such as an SVG picture"},
         {"{", "JSON"},
         {"PK\x03\x04", "a zip archive"},
         {"#!", "a program"}}};
    for (const auto& [beginning, what] : beginnings)
        if (text.starts_with(beginning)) return what;
    if (text.substr(0, 1000).find('\0') != std::string_view::npos) return "a binary file";
    const auto has_line = [&](std::string_view word) {
        return text.starts_with(word) ||
               text.find("\n" + std::string(word)) != std::string_view::npos;
    };
    if (has_line("Lsystem:") || has_line("lsystem:") || has_line("derivation length:"))
        return "a file of cpfg or L-studio";
    if (looks_like_b_file(text))
        return "a b-file of the OEIS, which `algae growth --realise` and `algae equal --as growth` "
               "read";
    return {};
}

Model open_model(const std::string& file, const Opener& open, const std::vector<std::string>& let) {
    const ConstantValues constants = constants_of(let);
    if (const std::optional<CpfgFiles> files = cpfg_files_at(file, open.reader())) {
        const Model model = cpfg_model(*files, open.reader());
        return let.empty() ? model : read_lsystem(print_lsystem(model), files->system, constants);
    }
    const std::optional<SourceText> stored = stored_text(file, open);
    if (!stored && is_typed_system(file) && !ends_as_file(file))
        return read_typed_system(file, typed_name, constants);
    if (!stored) refuse_missing(file);
    const SourceText& source = *stored;
    if (const GeneratorKind* kind = generator_kind(source.name))
        throw Error(source.name + " is " + kind->what + ", expected an L-system");
    if (const GeneratorFormat* format = generator_format(source.name))
        throw Error(source.name + " is " + format->what + ", expected an L-system");
    const bool is_own = source.name.ends_with(".lsys") || find_system(source.name);
    const SystemFormat* format = system_format(source.name);
    if (!format && !is_own) format = system_format_of(source.text);
    if (format)
        return let.empty() ? format->read(source.text, source.name)
                           : read_lsystem(print_lsystem(format->read(source.text, source.name)),
                                          source.name, constants);
    if (const std::string what = foreign_format(source.text); !what.empty())
        throw Error(source.name + " looks like " + what +
                    ", expected an L-system such as \"axiom a; a -> ab\"; `algae convert --help` "
                    "lists the formats that are read");
    return read_lsystem(source.text, source.name, constants);
}

}  // namespace

SourceText open_text(const std::string& file, const Budget& budget,
                     const std::vector<std::string>& let) {
    const Opener open{budget, {}};
    if (let.empty() && !cpfg_files_at(file, open.reader()))
        if (std::optional<SourceText> stored = stored_text(file, open)) return *stored;
    const Model system = open_model(file, budget, let);
    const bool is_foreign = system_format(system.name);
    return {system.name + (is_foreign ? ".lsys" : ""), print_lsystem(system)};
}

Model open_model(const std::string& file, const Budget& budget,
                 const std::vector<std::string>& let) {
    return open_model(file, Opener{budget, {}}, let);
}

LSystem open_system(const std::string& file, const Budget& budget,
                    const std::vector<std::string>& let) {
    return open_model(file, budget, let);
}

void add_let_option(Verb& verb, std::vector<std::string>& let) {
    verb.option("--let", let, "NAME=VALUE",
                "another value for a constant of the system; may be given several times");
}

std::string folder_of(const std::string& file) {
    const std::string folder = std::filesystem::path(file).parent_path().string();
    return file == "-" || folder.empty() ? "." : folder;
}

std::vector<std::filesystem::path> files_below(const std::filesystem::path& folder) {
    namespace fs = std::filesystem;
    std::vector<fs::path> files, folders{folder};
    const auto check = [](const fs::path& path, const std::error_code& failed) {
        if (failed) throw_unreadable(path.string(), failed);
    };
    while (!folders.empty()) {
        const fs::path above = std::move(folders.back());
        folders.pop_back();
        std::error_code failed;
        fs::directory_iterator next(above, failed);
        check(above, failed);
        while (next != fs::directory_iterator()) {
            const fs::file_status status = next->status(failed);
            // A link that leads nowhere is no file.
            if (status.type() != fs::file_type::not_found) check(next->path(), failed);
            if (fs::is_regular_file(status)) files.push_back(next->path());
            // Links to folders are not followed, they may lead in a circle.
            if (fs::is_directory(status) && !next->is_symlink(failed))
                folders.push_back(next->path());
            next.increment(failed);
            check(above, failed);
        }
    }
    std::ranges::sort(files);
    return files;
}

void make_folders(const std::filesystem::path& folder) {
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (failed) throw Error("cannot make the folder " + folder.string() + ": " + failed.message());
}

std::function<Model(const std::string&)> systems_from(const std::vector<std::string>& folders,
                                                      const Budget& budget, bool outside) {
    return [folders, budget, outside](const std::string& name) {
        const auto open = [&](const std::string& path) {
            const auto refuse_outside = [&](const std::string& file) {
                std::error_code ignored;
                // What is not there is not outside, it cannot be read.
                if (file == "-" || !std::filesystem::exists(file, ignored) ||
                    std::ranges::any_of(
                        folders, [&](const std::string& folder) { return is_below(file, folder); }))
                    return;
                const bool is_named = file == path || file == file_and_entry(path).first;
                throw Error(
                    name + (is_named ? ": " : ": stands for " + file + ", which ") +
                    "is outside the folder of the text that names it; expected a file in it or "
                    "below, or a name of the gallery; --allow-outside reads it");
            };
            Opener opener{budget, {}};
            if (!outside) opener.allow = refuse_outside;
            return open_model(path, opener, {});
        };
        for (const std::string& folder : folders) {
            const std::string beside = (std::filesystem::path(folder) / name).string();
            if (exists(beside)) return open(beside);
            if (const auto [file, entry] = file_and_entry(beside); !entry.empty() && exists(file))
                return open(beside);
        }
        return open(name);
    };
}

void add_outside_flag(Verb& verb, bool& outside) {
    verb.flag("--allow-outside", outside,
              "systems may be read from any folder, not only from that of the file and below");
}

namespace {

std::vector<std::string> words(const std::string& text) {
    std::istringstream in(text);
    in.exceptions(std::ios::badbit);
    std::vector<std::string> found;
    for (std::string word; in >> word;) found.push_back(word);
    return found;
}

/// The kind of the generators in files of this name, possibly in another program's format.
const GeneratorKind* kind_of(const std::string& name) {
    const GeneratorFormat* format = generator_format(name);
    return generator_kind(format ? "." + format->kind : name);
}

GeneratorFile read_source(const SourceText& source, const GeneratorKind& kind) {
    if (const GeneratorFormat* format = generator_format(source.name))
        return format->read(source.text, source.name);
    return read_generator_file(source.text, source.name, kind.keys);
}

void change(GeneratorFile& file, const std::vector<StatementOption>& said) {
    for (const auto& [option, key, text] : said)
        if (!text.empty()) file.set(key, words(text), option);
}

/// The text of FILE for a verb of one kind of generators.
SourceText text_of_kind(const std::string& name, const GeneratorKind* kind, const std::string& file,
                        const Budget& budget) {
    const bool by_name = file != "-" && !exists(file);
    const std::string own = file + "." + name;
    const SourceText source = open_text(by_name && find_generator(own) ? own : file, budget);
    const GeneratorKind* found = kind_of(source.name);
    const bool system = source.name.ends_with(".lsys") || (by_name && !found);
    if (system || (found && found != kind))
        throw Error(source.name + " is " + (system ? "an L-system" : found->what) + ", expected " +
                    kind->what);
    return source;
}

}  // namespace

bool is_generator(const std::string& file) {
    if (kind_of(file)) return true;
    return !exists(file) && find_generator(file) && !find_system(file);
}

std::unique_ptr<Generator> open_generator(const std::string& file, const Budget& budget,
                                          const std::vector<StatementOption>& said) {
    const SourceText source = open_text(file, budget);
    const GeneratorKind* kind = kind_of(source.name);
    if (!kind) return read_generator(source.text, source.name);  // throws what is expected
    GeneratorFile read = read_source(source, *kind);
    for (const auto& [option, key, text] : said) {
        const bool known =
            std::ranges::find(kind->keys, key, &GeneratorKey::name) != std::end(kind->keys);
        if (!text.empty() && !known)
            throw Error(option + " is not for " + kind->what + ", and " + source.name + " is one");
    }
    change(read, said);
    return kind->make(read);
}

std::unique_ptr<Generator> open_kind(const std::string& kind, const std::string& file,
                                     const Budget& budget,
                                     const std::vector<StatementOption>& said) {
    const GeneratorKind& known = *generator_kind("." + kind);
    GeneratorFile read;
    read.name = kind;
    if (!file.empty()) read = read_source(text_of_kind(kind, &known, file, budget), known);
    change(read, said);
    return known.make(read);
}

void add_environment_option(Verb& verb, std::string& program) {
    verb.option("--environment", program, "COMMAND",
                "the program that fills the modules of `environment ?E external`: it reads and "
                "writes lines of JSON");
}

std::shared_ptr<Environment> external_environment(const std::string& program,
                                                  const LSystem& system) {
    if (program.empty()) return nullptr;
    if (!asks_program(system))
        throw Error(
            "--environment: no module of the system asks a program; expected a setting such as "
            "`environment ?E external`");
    return std::make_shared<ExternalEnvironment>(program);
}

}  // namespace algae::command
