// Files of systems of cpfg, which lie beside each other: a system, its view and its animation, and files that the system includes.
//
// Who asks says how a file is read, by a function; so a caller bounds the memory, and refuses files that may not be read. A file may include
// only what lies in its folder or below: a link that leads out of it is refused, as the text of a stranger must not name what else is there.

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>

#include "exchange/exchange.hpp"
#include "model/model.hpp"

namespace algae {

namespace {

bool exists(const std::string& path) {
    std::error_code ignored;
    return std::filesystem::exists(path, ignored);
}

}  // namespace

bool is_below(const std::string& file, const std::string& folder) {
    std::error_code failed;
    const auto whole = std::filesystem::canonical(file, failed);
    if (failed) return false;
    const auto above = std::filesystem::canonical(folder, failed);
    if (failed) return false;
    return std::mismatch(above.begin(), above.end(), whole.begin(), whole.end()).first ==
           above.end();
}

std::string text_with_included(const std::string& path, const FileText& text_of) {
    std::string text = text_of(path);
    const SystemFormat* const format = system_format(path);
    if (!format || (format->name != "l" && format->name != "cpfg" && format->name != "lpfg") ||
        text.find("include") == std::string::npos)
        return text;
    const std::string above = std::filesystem::path(path).parent_path().string();
    const std::string folder = above.empty() ? "." : above;
    return cpfg_with_included(
        text, path, [&](const std::string& name) -> std::optional<std::string> {
            std::error_code ignored;
            // "-" is standard input to readers of files.
            if (name == "-" || !std::filesystem::is_regular_file(name, ignored) ||
                !is_below(name, folder))
                return std::nullopt;
            return text_of(name);
        });
}

std::optional<CpfgFiles> cpfg_files_at(const std::string& file, const FileText& text_of) {
    // One of several systems in a file has the view beside that file.
    const std::string whole = exists(file) ? file : file_and_entry(file).first;
    if (!exists(whole)) return std::nullopt;
    const std::filesystem::path path(whole);
    const auto beside = [&](const char* ending) {
        std::filesystem::path other = path;
        other.replace_extension(ending);
        return exists(other.string()) ? other.string() : std::string();
    };
    if (path.filename() == "specifications") {
        CpfgFiles found = cpfg_files(text_of(whole), whole);
        for (std::string* one : {&found.system, &found.view, &found.animation})
            if (!one->empty()) *one = (path.parent_path() / *one).string();
        return found;
    }
    const std::string ending = path.extension().string();
    if (ending == ".l" || ending == ".cpfg") {
        const std::string view = beside(".v");
        if (view.empty()) return std::nullopt;
        return CpfgFiles{file, view, ""};
    }
    if (ending != ".v" && ending != ".a") return std::nullopt;
    if (beside(".l").empty())
        throw Error(file + ": shows a system of cpfg, expected it beside this file: " +
                    path.stem().string() + ".l");
    return CpfgFiles{beside(".l"), ending == ".v" ? file : beside(".v"),
                     ending == ".a" ? file : ""};
}

Model cpfg_model(const CpfgFiles& files, const FileText& text_of) {
    const std::string& name = files.system;
    const std::string text =
        text_with_included(exists(name) ? name : file_and_entry(name).first, text_of);
    const SystemFormat* const by_text = system_format_of(text);
    if (!by_text || by_text->name != "cpfg")
        return system_format(files.system)->read(text, files.system);
    Model model = by_text->read(text, files.system);
    if (!files.view.empty()) model = with_cpfg_view(model, text_of(files.view), files.view);
    if (!files.animation.empty())
        model.drawing.generations = cpfg_frames(text_of(files.animation), files.animation);
    return model;
}

}  // namespace algae
