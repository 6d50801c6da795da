#include <algorithm>

#include "automatic/automatic.hpp"

// The numeration of Dumont and Thomas: numbers are paths in the tree of a substitution.

namespace algae {

namespace {

[[noreturn]] void refuse(const D0L& system, const std::string& why) {
    throw Error((system.name.empty() ? std::string() : system.name + ": ") +
                "no infinite word with a numeration of its own: " + why);
}

/// The letter to which the first letters of the words come.
Symbol first_letter(const D0L& system) {
    const auto name = [&](Symbol letter) { return "'" + system.alphabet->name(letter) + "'"; };
    if (system.axiom.empty()) refuse(system, "the axiom is empty");
    for (const Symbol letter : system.letters)
        if (system.successor(letter).empty())
            refuse(system,
                   name(letter) + " vanishes; an equivalent system without erasing rules has one");
    std::vector<Symbol> seen;
    Symbol letter = system.axiom.front();
    while (std::ranges::count(seen, letter) == 0) {
        seen.push_back(letter);
        letter = system.successor(letter).front();
    }
    if (system.successor(letter).front() != letter)
        refuse(system, "the first letters of the words go round, " + name(letter) + " among them");
    if (system.successor(letter).size() == 1)
        refuse(system, "its words begin with " + name(letter) + ", which stays as it is");
    return letter;
}

}  // namespace

Numeration::Numeration(const D0L& system) {
    letters_ = {first_letter(system)};
    std::vector<std::uint32_t> numbers(system.alphabet->size(), ~std::uint32_t{0});
    numbers[letters_.front()] = 0;
    for (std::size_t i = 0; i < letters_.size(); ++i) {
        std::vector<std::uint32_t> image;
        for (const Symbol letter : system.successor(letters_[i])) {
            if (numbers[letter] == ~std::uint32_t{0}) {
                numbers[letter] = static_cast<std::uint32_t>(letters_.size());
                letters_.push_back(letter);
            }
            image.push_back(numbers[letter]);
        }
        base_ = std::max(base_, static_cast<std::uint32_t>(image.size()));
        images_.push_back(std::move(image));
    }
}

const Integer& Numeration::length(std::uint32_t state, std::size_t power) const {
    while (lengths_.size() <= power) {
        std::vector<Integer> next(images_.size(), 1);
        if (!lengths_.empty())
            for (std::size_t s = 0; s < images_.size(); ++s) {
                next[s] = 0;
                for (const std::uint32_t child : images_[s]) next[s] += lengths_.back()[child];
            }
        lengths_.push_back(std::move(next));
    }
    return lengths_[power][state];
}

std::vector<std::uint32_t> Numeration::digits(const Integer& n) const {
    if (n < 0) throw Error("expected a number from 0 on, found " + to_string(n));
    std::size_t count = 0;
    while (length(0, count) <= n) ++count;
    std::vector<std::uint32_t> found;
    Integer rest = n;
    std::uint32_t state = 0;
    for (std::size_t i = count; i-- > 0;) {
        std::uint32_t digit = 0;
        for (; length(images_[state][digit], i) <= rest; ++digit)
            rest -= length(images_[state][digit], i);
        found.push_back(digit);
        state = images_[state][digit];
    }
    return found;
}

std::optional<Integer> Numeration::value(const std::vector<std::uint32_t>& digits) const {
    Integer total = 0;
    std::uint32_t state = 0;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (digits[i] >= images_[state].size()) return std::nullopt;
        for (std::uint32_t skipped = 0; skipped < digits[i]; ++skipped)
            total += length(images_[state][skipped], digits.size() - 1 - i);
        state = images_[state][digits[i]];
    }
    return total;
}

std::uint32_t Numeration::state(const Integer& n) const {
    std::uint32_t state = 0;
    for (const std::uint32_t digit : digits(n)) state = images_[state][digit];
    return state;
}

AutomaticWord automatic_word(const D0L& system, const std::function<std::string(Symbol)>& coded) {
    AutomaticWord word{Numeration(system), {}};
    for (const Symbol letter : word.numeration.letters()) word.letters.push_back(coded(letter));
    return word;
}

}  // namespace algae
