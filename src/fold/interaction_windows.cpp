#include "fold/interaction_windows.hpp"

#include <algorithm>
#include <bit>

#include "system/accessible.hpp"

namespace algae {

std::size_t Windows::bits() const {
    return std::max<std::size_t>(1, static_cast<std::size_t>(std::bit_width(letters.size() - 1)));
}

std::optional<Windows> windows(const IL& system) {
    if (system.brackets) return std::nullopt;
    Windows found;
    found.letters = accessible(system.axiom, system.alphabet->size(), [&](Symbol a, auto see) {
        for (const IL::Rule& rule : system.rules[a]) see(rule.successor);
    });
    if (found.letters.size() > 128) return std::nullopt;
    found.numbers.resize(system.alphabet->size());
    for (std::size_t i = 0; i < found.letters.size(); ++i) {
        const Symbol a = found.letters[i];
        if (system.ignored[a]) return std::nullopt;
        found.numbers[a] = static_cast<std::uint8_t>(i);
        for (const IL::Rule& rule : system.rules[a]) {
            found.left = std::max(found.left, rule.left.size());
            found.right = std::max(found.right, rule.right.size());
            if (rule.successor.size() != 1) found.keeps_length = false;
        }
    }
    const bool are_few =
        !found.letters.empty() && found.bits() * found.width() <= Windows::most_bits;
    return are_few ? std::optional(found) : std::nullopt;
}

Letters successor_at(const IL& system, const Word& word, std::size_t place) {
    const auto at = word.begin() + static_cast<std::ptrdiff_t>(place);
    for (const IL::Rule& rule : system.rules[*at])
        if (rule.left.size() <= place && rule.right.size() < word.size() - place &&
            std::equal(rule.left.rbegin(), rule.left.rend(), std::make_reverse_iterator(at)) &&
            std::equal(rule.right.begin(), rule.right.end(), at + 1))
            return {rule.successor.data(), rule.successor.size()};
    return {&*at, 1};
}

std::vector<std::optional<std::vector<std::uint8_t>>> window_table(const IL& system,
                                                                   const Windows& windows) {
    const std::size_t bits = windows.bits(), width = windows.width();
    std::vector<std::optional<std::vector<std::uint8_t>>> table(std::size_t{1} << bits * width);
    Word window(width);
    for (std::size_t number = 0; number < table.size(); ++number) {
        bool occurs = true;
        for (std::size_t i = 0; i < width && occurs; ++i) {
            const std::size_t letter = number >> bits * i & ((std::size_t{1} << bits) - 1);
            occurs = letter < windows.letters.size();
            if (occurs) window[i] = windows.letters[letter];
        }
        if (!occurs) continue;
        const Letters successor = successor_at(system, window, windows.left);
        table[number].emplace();
        for (std::size_t i = 0; i < successor.size; ++i)
            table[number]->push_back(windows.numbers[successor.begin[i]]);
    }
    return table;
}

}  // namespace algae
