#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace algae::oracle {

/// Every language of words of at most `longest` letters over the first `letters` letters of the
/// alphabet that some 0L, D0L, ... system with a non-empty axiom generates: all systems are written
/// down and run. With tables, every language is tried in turn, with all tables at once that do not
/// lead out of it. For a few words only: everything is exponential.
class FiniteSystems {
public:
    FiniteSystems(int letters, std::size_t longest, bool propagating, bool deterministic);

    /// All words, shorter ones first. A language is a set of their places, as bits.
    static std::vector<std::string> words(int letters, std::size_t longest);
    std::set<std::uint64_t> without_tables() const;
    std::set<std::uint64_t> with_tables() const;

private:
    struct Table {
        std::vector<std::uint64_t> given;  // by word: those that it gives in one step
        std::uint64_t kept = 0;            // the words that give no longer words
    };

    std::uint64_t reached(std::size_t axiom, const std::vector<std::uint64_t>& given) const;

    std::vector<std::string> words_;
    std::vector<Table> tables_;
};

/// The words of a language that is given as bits.
std::vector<std::string> words_of(const std::vector<std::string>& words, std::uint64_t language);

}  // namespace algae::oracle
