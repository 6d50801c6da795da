#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// What definitions say of a morphism, tried on short words. Images are those of the letters a, b, c, ...

namespace algae::oracle {

using LetterImages = std::vector<std::string>;

std::string mapped(const LetterImages& images, const std::string& word);
/// All words of at most so many letters over as many letters as there are images, shorter ones first.
std::vector<std::string> words_to(std::size_t letters, std::size_t longest);

/// Two different words of at most so many letters with the same image, and with the fewest letters in all.
std::optional<std::pair<std::string, std::string>> same_image_of(const LetterImages& images,
                                                                 std::size_t longest);
/// All morphisms that come of this one by moving a common first letter of all images behind them, or a last one before them.
std::vector<LetterImages> conjugates_of_morphism(const LetterImages& images);
/// Whether there are a palindrome p and palindromes q with the images p q, or all q p.
bool is_class_p(const LetterImages& images);
/// Whether each choice of as many permutations of 3 (4, ...) things as there are letters is the image of one alone, where a letter of an image stands for
/// its permutation and words for products. So it is for automorphisms of the free group.
bool permutes_choices(const LetterImages& images, int things);
bool has_square(const std::string& word);
bool has_overlap(const std::string& word);

}  // namespace algae::oracle
