#include "cli/input.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include "base/error.hpp"
#include "exchange/relative_format.hpp"
#include "exchange/system_format.hpp"
#include "notation/gallery.hpp"
#include "notation/read.hpp"
#include "notation/relative_gallery.hpp"
#include "notation/relative_reader.hpp"
#include "notation/suggestion.hpp"

namespace algae::cli {

namespace {

/// What reading takes of memory, in bytes a byte of the file.
constexpr std::uint64_t memory_of_a_byte = 16;

std::string read_all(std::FILE* file, const std::string& name, const Budget& budget) {
    const std::uint64_t largest = budget.memory / memory_of_a_byte;
    std::string text;
    std::string buffer(std::size_t{1} << 16, '\0');
    errno = 0;
    while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), file)) {
        text.append(buffer, 0, count);
        if (text.size() > largest)
            throw BoundReached(Bound::memory, name + ": has more than " +
                                                  std::to_string(largest >> 20) +
                                                  " MiB, as much as can be read within the " +
                                                  std::to_string(budget.memory >> 20) +
                                                  " MiB allowed by --max-memory");
        budget.check();
    }
    budget.check();  // reading that waited was interrupted
    if (std::ferror(file)) throw Error("cannot read " + name + ": " + std::strerror(errno));
    return text;
}

struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

}  // namespace

std::string file_text(const std::string& path, const Budget& budget) {
    if (path == "-") return read_all(stdin, "standard input", budget);
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        throw Error(path + ": is a folder, expected a file");
    const std::unique_ptr<std::FILE, Closer> file(std::fopen(path.c_str(), "rb"));
    budget.check();
    if (!file) throw Error("cannot read " + path + ": " + std::strerror(errno));
    return read_all(file.get(), path, budget);
}

SourceText open_text(const std::string& file, const Budget& budget) {
    std::error_code ignored;
    if (file == "-") return {"standard input", file_text(file, budget)};
    if (std::filesystem::exists(file, ignored)) return {file, file_text(file, budget)};
    const auto figures = gallery();
    const auto found = std::find_if(figures.begin(), figures.end(),
                                    [&](const GalleryEntry& entry) { return entry.name == file; });
    if (found != figures.end()) return {std::string(found->name), std::string(found->text)};
    if (const GalleryEntry* entry = find_relative(file))
        return {std::string(file_name(*entry)), std::string(entry->text)};
    std::vector<std::string> names;
    for (const GalleryEntry& entry : figures) names.emplace_back(entry.name);
    for (const GalleryEntry& entry : relative_gallery()) names.emplace_back(entry.name);
    throw Error("no file \"" + file + "\", and nothing of that name in the gallery" +
                did_you_mean(file, names) + "; `algae gallery` lists them");
}

LSystem open_system(const std::string& file, const Budget& budget) {
    const SourceText source = open_text(file, budget);
    if (const RelativeKind* kind = relative_kind(source.name))
        throw Error(source.name + " is " + kind->what + ", expected an L-system");
    if (const RelativeFormat* format = relative_format(source.name))
        throw Error(source.name + " is " + format->what + ", expected an L-system");
    if (const SystemFormat* format = system_format(source.name))
        return format->read(source.text, source.name);
    return read_lsystem(source.text, source.name);
}

}  // namespace algae::cli
