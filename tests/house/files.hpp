#pragma once
// The repository's own files, for the tests that hold the house rules.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "places.hpp"

namespace algae::house {

namespace fs = std::filesystem;

inline fs::path root() { return source_folder(); }

/// The files under a folder of the repository with one of these endings, in order of their paths,
/// relative to the root.
inline std::vector<fs::path> files(const std::string& folder,
                                   const std::vector<std::string>& endings) {
    std::vector<fs::path> found;
    if (!fs::is_directory(root() / folder)) return found;
    for (const auto& entry : fs::recursive_directory_iterator(root() / folder))
        if (entry.is_regular_file() &&
            std::ranges::count(endings, entry.path().extension().string()))
            found.push_back(entry.path().lexically_relative(root()));
    std::ranges::sort(found);
    return found;
}

inline std::vector<std::string> lines(const fs::path& file) {
    std::ifstream in(root() / file);
    std::vector<std::string> all;
    for (std::string line; std::getline(in, line);) all.push_back(line);
    return all;
}

}  // namespace algae::house
