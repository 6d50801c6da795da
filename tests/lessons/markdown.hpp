#pragma once

#include <sstream>
#include <string>
#include <string_view>
#include <vector>

/// A fenced block of a lesson: ```KIND name=FILE or region=FILE#NAME.
struct Block {
    std::string kind, name, region;
    std::vector<std::string> lines;
};

/// A command of a `console` block and the lines below it.
struct Command {
    std::string line;  // without "$ "
    std::vector<std::string> shown;
};

inline std::vector<std::string> split(std::string_view text) {
    std::vector<std::string> lines;
    std::istringstream in{std::string(text)};
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

inline std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

inline std::vector<Block> blocks(std::string_view text) {
    std::vector<Block> all;
    bool inside = false;
    for (const std::string& line : split(text)) {
        if (!line.starts_with("```")) {
            if (inside) all.back().lines.push_back(line);
            continue;
        }
        inside = !inside;
        if (!inside) continue;
        Block& block = all.emplace_back();
        std::istringstream words(line.substr(3));
        words >> block.kind;
        for (std::string word; words >> word;) {
            if (word.starts_with("name=")) block.name = word.substr(5);
            if (word.starts_with("region=")) block.region = word.substr(7);
        }
    }
    return all;
}

inline std::vector<Command> commands(const Block& block) {
    std::vector<Command> all;
    for (const std::string& line : block.lines)
        if (line.starts_with("$ "))
            all.push_back({line.substr(2), {}});
        else if (!all.empty())
            all.back().shown.push_back(line);
    return all;
}

/// The files of the pictures, `![caption](FILE)`.
inline std::vector<std::string> pictures(std::string_view text) {
    std::vector<std::string> all;
    for (const std::string& line : split(text)) {
        const std::size_t open = line.rfind("](");
        if (line.starts_with("![") && open != std::string::npos && line.ends_with(")"))
            all.push_back(line.substr(open + 2, line.size() - open - 3));
    }
    return all;
}
