#include "lesson/fence.hpp"

#include <algorithm>
#include <sstream>

namespace algae {

namespace {

/// Cuts off the first line, with its line break.
std::string_view take_line(std::string_view& text) {
    const std::size_t size = std::min(text.find('\n'), text.size() - 1) + 1;
    const std::string_view line = text.substr(0, size);
    text.remove_prefix(size);
    return line;
}

std::string_view without_break(std::string_view line) {
    return line.ends_with('\n') ? line.substr(0, line.size() - 1) : line;
}

/// What the opening line of a block says.
Fence opened(std::string_view line) {
    Fence fence;
    std::istringstream words{std::string(line.substr(3))};
    words >> fence.kind;
    for (std::string word; words >> word;) {
        if (word.starts_with("name=")) fence.name = word.substr(5);
        if (word.starts_with("region=")) fence.region = word.substr(7);
    }
    return fence;
}

}  // namespace

std::vector<Fence> fences(std::string_view markdown) {
    std::vector<Fence> all;
    while (!markdown.empty()) {
        const std::string_view line = take_line(markdown);
        if (!line.starts_with("```")) continue;
        Fence fence = opened(line);
        const char* const begin = markdown.data();
        while (!markdown.empty() && !markdown.starts_with("```")) take_line(markdown);
        fence.text = {begin, static_cast<std::size_t>(markdown.data() - begin)};
        all.push_back(std::move(fence));
        if (!markdown.empty()) take_line(markdown);
    }
    return all;
}

std::string region_of(std::string_view code, std::string_view name) {
    std::string region;
    std::size_t indent = std::string_view::npos;
    bool inside = false;
    while (!code.empty()) {
        const std::string_view line = take_line(code);
        const std::string_view plain = without_break(line);
        const std::size_t begin = std::min(plain.find_first_not_of(' '), plain.size());
        const std::string_view words = plain.substr(begin);
        const bool mark = words.size() > 4 && words.substr(4) == name;
        if (mark && words.starts_with("//< ")) inside = false;
        if (inside) {
            if (indent == std::string_view::npos) indent = begin;
            region += line.substr(std::min(indent, begin));
        }
        if (mark && words.starts_with("//> ")) inside = true;
    }
    return region;
}

}  // namespace algae
