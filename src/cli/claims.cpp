#include "cli/claims.hpp"

#include <filesystem>

#include "cli/input.hpp"

namespace algae::cli {

SystemSource systems_from(const std::string& folder, const Budget& budget) {
    return [folder, budget](const std::string& name) {
        const std::filesystem::path beside = std::filesystem::path(folder) / name;
        std::error_code ignored;
        return open_system(std::filesystem::exists(beside, ignored) ? beside.string() : name,
                           budget);
    };
}

Claim open_claim(const std::string& file, const Budget& budget) {
    const std::string text = file_text(file, budget);
    const std::string folder =
        file == "-" ? "." : std::filesystem::path(file).parent_path().string();
    return read_claim(text, file == "-" ? "standard input" : file,
                      systems_from(folder.empty() ? "." : folder, budget));
}

}  // namespace algae::cli
