#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

// What definitions say of one finite word, tried one by one. Letters are bytes.

namespace algae::oracle {

std::vector<std::size_t> borders_of(const std::string& word);
std::vector<std::size_t> periods_of(const std::string& word);
std::string root_of(const std::string& word);
std::set<std::string> conjugates_of(const std::string& word);
/// The only factorisation into words that are less than each of their proper suffixes, none less than the next: tried for all cuts.
std::vector<std::string> lyndon_words_of(const std::string& word);
std::set<std::string> palindromes_of(const std::string& word);
std::size_t palindromic_length_of(const std::string& word);

struct Maximal {
    std::size_t begin, end, period;
    auto operator<=>(const Maximal&) const = default;
};
std::set<Maximal> runs_of(const std::string& word);
std::set<std::string> squares_of(const std::string& word);
std::vector<std::size_t> factor_counts_of(const std::string& word);
/// (head, period)
std::vector<std::pair<std::size_t, std::size_t>> abelian_periods_of(const std::string& word);

}  // namespace algae::oracle
