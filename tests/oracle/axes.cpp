#include "oracle/axes.hpp"

#include <algorithm>
#include <random>
#include <vector>

namespace algae::oracle {

namespace {

/// A word as what hangs laterally at its first vertex and what goes straight on: the letter and
/// the word behind it, or nothing.
struct Beginning {
    std::vector<std::string> lateral;  // words in brackets
    std::string straight;
};

Beginning beginning(const std::string& word) {
    Beginning out;
    std::size_t i = 0;
    while (i < word.size() && word[i] == '[') {
        const std::size_t first = i + 1;
        for (int depth = 0; i == first - 1 || depth > 0; ++i)
            depth += word[i] == '[' ? 1 : word[i] == ']' ? -1 : 0;
        out.lateral.push_back(word.substr(first, i - 1 - first));
    }
    out.straight = word.substr(i);
    return out;
}

/// The lateral branches at the first vertex, those at the beginning of a branch among them.
void gather(const Beginning& at, std::vector<std::string>& out) {
    for (const std::string& branch : at.lateral) {
        const Beginning inner = beginning(branch);
        gather(inner, out);
        if (!inner.straight.empty()) out.push_back(inner.straight);
    }
}

void count(const std::string& word, std::size_t order, bool starts,
           std::map<std::size_t, std::pair<std::uint64_t, std::uint64_t>>& found) {
    const Beginning at = beginning(word);
    // At the start of a lateral axis the vertex is on the axis below, and so are its branches.
    std::vector<std::string> lateral;
    gather(at, lateral);
    for (const std::string& branch : lateral) count(branch, order + 1, true, found);
    if (at.straight.empty()) return;
    auto& [axes, edges] = found[order];
    axes += starts;
    ++edges;
    count(at.straight.substr(1), order, false, found);
}

}  // namespace

std::string branches(const std::string& word) {
    const Beginning at = beginning(word);
    std::vector<std::string> lateral, forms;
    gather(at, lateral);
    for (const std::string& branch : lateral) forms.push_back(branches(branch));
    std::sort(forms.begin(), forms.end());
    std::string out;
    for (const std::string& form : forms) out += '<' + form + '>';
    if (!at.straight.empty()) out += at.straight.substr(0, 1) + branches(at.straight.substr(1));
    return out;
}

std::string shuffled(const std::string& word, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const Beginning at = beginning(word);
    std::vector<std::string> lateral;
    for (const std::string& branch : at.lateral)
        lateral.push_back('[' + shuffled(branch, random()) + ']');
    if (random() % 4 == 0) lateral.push_back("[]");
    std::shuffle(lateral.begin(), lateral.end(), random);
    std::string out;
    for (const std::string& branch : lateral) out += branch;
    if (!at.straight.empty()) out += at.straight[0] + shuffled(at.straight.substr(1), random());
    return out;
}

std::map<std::size_t, std::pair<std::uint64_t, std::uint64_t>> axes(const std::string& word) {
    std::map<std::size_t, std::pair<std::uint64_t, std::uint64_t>> found;
    count(word, 0, true, found);
    return found;
}

}  // namespace algae::oracle
