#include "notation/relative_values.hpp"

#include <cmath>
#include <limits>

#include "notation/characters.hpp"

namespace algae {

std::optional<std::vector<double>> hurst_values(const RelativeFile& file, const char* key) {
    const RelativeStatement* statement = file.find(key);
    if (!statement) return std::nullopt;
    std::vector<double> found;
    for (const RelativeWord& word : statement->words) {
        found.push_back(file.quantity(*statement, word).value);
        if (!(found.back() > 0 && found.back() < 1))
            file.fail(*statement, word,
                      "expected " + statement->key + " with a number between 0 and 1, found " +
                          algae::quoted(word.text));
    }
    return found;
}

std::optional<double> positive_value(const RelativeFile& file, const char* key) {
    const RelativeStatement* statement = file.find(key);
    if (!statement) return std::nullopt;
    file.check_words(*statement, 1, 1, "NUMBER");
    const RelativeWord& word = statement->words.front();
    const double found = file.quantity(*statement, word).value;
    if (!(found > 0))
        file.fail(*statement, word,
                  "expected " + statement->key + " with a number above 0, found " +
                      algae::quoted(word.text));
    return found;
}

std::optional<std::vector<std::uint64_t>> natural_values(const RelativeFile& file, const char* key,
                                                         std::uint64_t least, std::uint64_t most) {
    const RelativeStatement* statement = file.find(key);
    if (!statement) return std::nullopt;
    std::vector<std::uint64_t> found;
    for (const RelativeWord& word : statement->words)
        found.push_back(file.natural(*statement, word, least, most));
    return found;
}

std::optional<std::pair<int, int>> level_values(const RelativeFile& file, const char* key,
                                                int most) {
    const auto found = file.range(key, static_cast<std::uint64_t>(most));
    if (!found) return std::nullopt;
    return std::pair(static_cast<int>(found->first), static_cast<int>(found->second));
}

std::uint64_t seed_value(const RelativeFile& file) {
    return file.natural("seed", 0, std::numeric_limits<std::uint64_t>::max()).value_or(1);
}

}  // namespace algae
