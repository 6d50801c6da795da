#include "cli/claims.hpp"

#include <algorithm>
#include <filesystem>

#include "base/error.hpp"
#include "cli/input.hpp"
#include "notation/gallery.hpp"

namespace algae::cli {

std::string folder_of(const std::string& file) {
    const std::string folder = std::filesystem::path(file).parent_path().string();
    return file == "-" || folder.empty() ? "." : folder;
}

SystemSource systems_from(const std::vector<std::string>& folders, const Budget& budget) {
    return [folders, budget](const std::string& name) {
        for (const std::string& folder : folders) {
            const std::filesystem::path beside = std::filesystem::path(folder) / name;
            std::error_code ignored;
            if (std::filesystem::exists(beside, ignored))
                return open_system(beside.string(), budget);
        }
        return open_system(name, budget);
    };
}

std::vector<std::string> claim_files(const std::string& path) {
    std::error_code ignored;
    std::vector<std::string> files;
    if (path == "-" || std::filesystem::is_regular_file(path, ignored)) return {path};
    if (std::filesystem::is_directory(path, ignored)) {
        for (const auto& entry : std::filesystem::recursive_directory_iterator(path))
            if (entry.is_regular_file() && entry.path().extension() == ".claim")
                files.push_back(entry.path().string());
        if (files.empty()) throw Error(path + ": expected .claim files in this folder, found none");
    } else {
        const std::string folder = path.ends_with('/') ? path : path + '/';
        for (const GalleryEntry& claim : theory_claims())
            if (claim.path.starts_with(folder)) files.emplace_back(claim.path);
        if (files.empty()) return {path};
    }
    std::sort(files.begin(), files.end());
    return files;
}

Claim open_claim(const std::string& file, const Budget& budget) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored))
        for (const GalleryEntry& claim : theory_claims())
            if (claim.path == file)
                return read_claim(claim.text, file, systems_from({"."}, budget));
    const std::string text = file_text(file, budget);
    return read_claim(text, file == "-" ? "standard input" : file,
                      systems_from({folder_of(file)}, budget));
}

}  // namespace algae::cli
