#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "cli/command.hpp"
#include "fold/derive.hpp"
#include "system/lsystem.hpp"

namespace algae::cli {

struct DeriveOptions {
    std::string file, generation, seed, seeds, tables, longest, environment;
    bool all = false, all_words = false, language = false, distribution = false, expected = false,
         json = false;
    Bounds bounds;
};

/// Prints a line for each of `first` to `last`, or a list in JSON; write(n, sink) sends the word and
/// says whether it has any letters.
void print_lines(bool json, std::uint64_t first, std::uint64_t last,
                 const std::function<bool(std::uint64_t, TextSink&)>& write);

/// Prints words, a line each, or a list in JSON.
void print_words(bool json, const Alphabet& alphabet, const std::vector<Word>& words);

/// The words of systems with parameters, probabilities, conditions or tables, or picked at random.
void derive_modules(const DeriveOptions& options, const LSystem& system, const Budget& budget);
/// `--distribution`: the words of a generation with their probabilities.
void derive_distribution(const DeriveOptions& options, const LSystem& system, const Budget& budget);
/// `--expected`: how often each letter is expected to occur.
void derive_expected(const DeriveOptions& options, const LSystem& system, const Budget& budget);
/// `--language`: the words over the terminals of generations up to n.
void derive_language(const DeriveOptions& options, const LSystem& system, const Budget& budget);

}  // namespace algae::cli
