#pragma once

#include <cstdint>
#include <vector>

#include "word/alphabet.hpp"

namespace algae {

/// The lifetime of a letter that never dies.
inline constexpr std::uint64_t lasts = UINT64_MAX;

/// How many steps each letter lasts when letters go to these images, which are indexed by symbol:
/// nothing is left of it from that many steps on; `lasts` if something always is (Rozenberg and
/// Salomaa 1980, I.3: the other letters are mortal). O(size of the images).
///
/// Example: lifetimes({{1}, {}}) == std::vector<std::uint64_t>{2, 1}
std::vector<std::uint64_t> lifetimes(const std::vector<Word>& images);

}  // namespace algae
