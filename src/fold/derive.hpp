#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/budget.hpp"
#include "system/d0l.hpp"

namespace algae {

/// Where text goes piece by piece. The bytes of a piece stay valid until `flush` returns, so a
/// sink may keep the view and write many pieces at once.
class TextSink {
public:
    virtual ~TextSink() = default;
    virtual void write(std::string_view piece) = 0;
    virtual void flush() = 0;
};

/// Sends the word of generation n to `sink` as text, names as `spell` writes them, nothing for the
/// empty word; says whether there was anything to send.
///
/// The words that letters become in k steps are spelled once, for the greatest k for which all of
/// them together fit about 1 MiB; the derivation is then walked depth first down to k steps to go,
/// and whole blocks are sent. So the rate does not depend on the grammar and memory does not
/// depend on the word. Throws what budget.check throws; does not check the number of letters.
///
/// Example: derived_text(d0l("b", {{'a', "ab"}, {'b', "a"}}), 5) == "abaababa"
bool derive_text(const D0L& system, std::uint64_t n, TextSink& sink, const Budget& budget = {});

/// The same as one string; for words that fit in memory.
std::string derived_text(const D0L& system, std::uint64_t n, const Budget& budget = {});

/// The word of generation n. Throws BoundReached if it has more than budget.letters letters.
///
/// Example: derive(d0l("F", {{'F', "FF"}}), 3).size() == 8
Word derive(const D0L& system, std::uint64_t n, const Budget& budget = {});

}  // namespace algae
