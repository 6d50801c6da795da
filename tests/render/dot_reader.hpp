#pragma once

#include <map>
#include <regex>
#include <string>
#include <vector>

namespace algae::test {

/// What a text in Graphviz's language says, as far as `dot_text` writes it.
struct ReadDot {
    std::map<int, std::string> labels;        // of nodes, by the number in their name
    std::vector<std::pair<int, int>> edges;   // that are visible
    std::vector<std::pair<int, int>> orders;  // invisible ones
    std::map<int, std::vector<int>> rows;     // nodes, in the order of mention
    std::map<int, std::vector<int>> frames;   // of groups

    explicit ReadDot(const std::string& text) {
        static const std::regex token(
            R"re(subgraph (row|cluster)(\d+) \{|\}|n(\d+) -> n(\d+)(\t \[([^\]]*)\]|\t\[([^\]]*)\])?;|n(\d+)(\t \[([^\]]*)\]|\t\[([^\]]*)\])?;)re");
        std::vector<std::vector<int>*> open;
        for (std::sregex_iterator at(text.begin(), text.end(), token), end; at != end; ++at) {
            const std::smatch& found = *at;
            if (found[1].matched) {
                open.push_back(&(found[1] == "row" ? rows : frames)[std::stoi(found[2])]);
            } else if (found[0] == "}") {
                if (!open.empty()) open.pop_back();
            } else if (found[3].matched) {
                const std::string attributes = found[5];
                const bool hidden = attributes.find("style=invis") != std::string::npos;
                (hidden ? orders : edges).emplace_back(std::stoi(found[3]), std::stoi(found[4]));
            } else {
                const int node = std::stoi(found[8]);
                static const std::regex label(R"re(label=("([^"]*)"|[^,\s\]]+))re");
                const std::string attributes = found[9];
                std::smatch name;
                if (std::regex_search(attributes, name, label))
                    labels.emplace(node, name[2].matched ? name[2].str() : name[1].str());
                if (!open.empty()) open.back()->push_back(node);
            }
        }
    }

    std::vector<int> children(int node) const {
        std::vector<int> found;
        for (const auto& [from, to] : edges)
            if (from == node) found.push_back(to);
        return found;
    }
};

}  // namespace algae::test
