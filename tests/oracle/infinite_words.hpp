#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

// What definitions say of the words of a D0L system and of their factors, by windows. Letters are small letters.

namespace algae::oracle {

using Rules = std::map<char, std::string>;

std::string image_of(const Rules& rules, const std::string& word);
/// The letters that occur in some word.
std::set<char> reached(const Rules& rules, const std::string& axiom);

/// All factors of at most so many letters of all words of a system, erasing or not, by length.
///
/// Words stand between two ends. A window is what lies between two letters that never vanish, or ends, with a number of such letters between
/// them; in an image it lies in the image of a window, because letters that never vanish come only of such, so the windows are
/// found from the axiom on. Letters that vanish stand in bounded blocks, so a window is finite.
std::vector<std::set<std::string>> factors_of(const Rules& rules, const std::string& axiom,
                                              std::size_t longest);

std::map<char, std::size_t> counts_of(const std::string& word);
/// How many different ones there are by numbers of letters; how far two differ in a letter.
std::size_t abelian_of(const std::set<std::string>& words);
std::map<char, std::size_t> apart_of(const std::set<std::string>& words);
std::size_t palindromes_in(const std::set<std::string>& words);
/// Whether the reversals of all are among them.
bool are_reversed(const std::set<std::string>& words);

/// Words that two letters prolong on either side, with the numbers of ways on both sides, less those on each, and one.
std::map<std::string, std::int64_t> bispecial_of(const std::vector<std::set<std::string>>& factors,
                                                 std::size_t longest);

/// What the factors of at most so many letters show: all graphs of letters before and behind a word that has several of both are trees; all reversals
/// are there, and of each length there is at most one word with several letters before it; and each such word has all letters.
struct Families {
    bool dendric = true, episturmian = true, arnoux_rauzy = true;
};
Families families_of(const std::vector<std::set<std::string>>& factors, std::size_t longest);

/// The least R so that each factor of R letters has all factors of n; nothing if it is not among the lengths.
std::optional<std::size_t> recurrence_of(const std::vector<std::set<std::string>>& factors,
                                         std::size_t n);
/// From an occurrence of the letter to before the next, in all factors of the greatest length.
std::set<std::string> returns_of(const std::vector<std::set<std::string>>& factors, char letter);

/// The least power of the matrix of zeros and ones without a zero, up to (d-1)^2 + 1.
std::optional<std::size_t> primitive_power(const Rules& rules, const std::string& axiom);

/// The shares of the letters after 2^40 steps and a few more; nothing if these are not the same.
std::optional<std::map<char, double>> shares_of(const Rules& rules, const std::string& axiom);

/// The greatest quotient of length and period of the factors of the greatest length and their parts, as a pair.
std::pair<std::size_t, std::size_t> greatest_exponent(
    const std::vector<std::set<std::string>>& factors);

/// Whether all factors of so many letters are cut into images in one way in the middle: each occurrence of one of them in the image of a
/// factor has a cut there, or none has. Of rules without empty images.
bool is_cut_in_one_way(const Rules& rules, const std::vector<std::set<std::string>>& factors,
                       std::size_t length);

}  // namespace algae::oracle
