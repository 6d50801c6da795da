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
/// Where the factors begin that are the longest ones to begin at an earlier place, too, or new letters.
std::vector<std::size_t> lempel_ziv_of(const std::string& word);
/// Whether all factors of one length have one letter about equally often, for each letter.
bool is_balanced(const std::string& word);
/// Of the letters a and b. Balanced with either letter before and either letter behind it.
bool is_central(const std::string& word);
/// The words of a and b of at most so many letters in the pairs that (a, b) leads to by (x, y) -> (x, xy) and (yx, y).
std::set<std::string> standard_words(std::size_t longest);
/// The steps below a line from a point of the plane to another one with coprime coordinates, of at most so many letters a (right) and b (up).
std::set<std::string> christoffel_words(std::size_t longest);
/// (head, period)
std::vector<std::pair<std::size_t, std::size_t>> abelian_periods_of(const std::string& word);

}  // namespace algae::oracle
