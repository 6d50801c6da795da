#pragma once

// Verdicts on finite languages without proofs: all eight families in one pass, and the truth of statements about
// languages whose words are quickly known.

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "exact/exact.hpp"
#include "language/language.hpp"
#include "word/word.hpp"

namespace algae {

/// In which of the families 0L, P0L, D0L, PD0L, T0L, PT0L, DT0L, PDT0L finite languages are, decided as `decide_family`
/// does but without witnesses and obstructions, and all families together. An object remembers languages that it has
/// decided, up to renaming of letters and reversal; its memory is bounded. One thread may use it at a time.
class FamilyVerdicts {
public:
    /// Bit i is family number i of `all_families()`.
    using Families = unsigned;

    explicit FamilyVerdicts(bool empty_axiom = false);
    ~FamilyVerdicts();
    FamilyVerdicts(FamilyVerdicts&&) noexcept;
    FamilyVerdicts& operator=(FamilyVerdicts&&) noexcept;

    /// The families that have the language of these words, which are in any order, each once. Nothing where a bound of the
    /// method is reached: more than 64 words or letters, very long words, or too many cases. Exponential in the worst
    /// case; some microseconds for a dozen short words. Throws what budget.check throws.
    std::optional<Families> of(const std::vector<Word>& words, const Budget& budget = {});

private:
    class Search;
    std::unique_ptr<Search> search_;
    std::unordered_map<std::string, Families> known_;
    bool empty_axiom_;
};

/// A text that two finite languages share if and only if they differ by a renaming of letters: the words in shortlex order
/// under some renaming, letters as the bytes 1, 2, ..., a 0 behind each word. Throws BoundReached where there are more than
/// 250 letters. Up to k! renamings are tried where k letters look alike.
std::string up_to_renaming(const std::vector<Word>& words);

/// The truth of statements without a proof, where few words decide it. What it says is what `decide` says.
/// It refers to the claim and the budget. One thread may use it at a time.
class QuickJudge {
public:
    QuickJudge(const Claim& claim, const Budget& budget);

    /// The truth of a statement without bound names; nothing where its judge must be asked.
    std::optional<Truth> truth(const Statement& statement);
    /// The same of one family.
    std::optional<Truth> in_family(const Language& language, const std::string& family);

    /// The words of a language, sorted as `LanguageTree` has them, if they are found to be few: finite sets, languages of
    /// systems that derive few words, and what union, intersection, difference, concatenation, reversal and morphisms make of
    /// these. Nothing where there are many, or infinitely many, or it is not seen.
    std::optional<std::vector<Word>> words(const Language& language);

private:
    struct Judge;
    std::optional<std::vector<Word>> derived(const std::shared_ptr<const SourceSystem>& system);

    const Claim& claim_;
    const Budget& budget_;
    FamilyVerdicts verdicts_;
    // What was asked lately, by a hash of the words: properties of one instance come one after the other, and languages come
    // again with others.
    struct Recent {
        std::vector<Word> words;
        std::optional<FamilyVerdicts::Families> families;
    };
    std::vector<Recent> recent_;
    std::shared_ptr<const SourceSystem> last_system_;
    std::optional<std::vector<Word>> last_derived_;
};

/// Quick judges of the threads that work on one claim, kept from one batch of work to the next for what they remember. It
/// must outlive those that were taken.
class QuickJudges {
public:
    QuickJudges(const Claim& claim, const Budget& budget) : claim_(claim), budget_(budget) {}

    /// One that nobody else has; it comes back when the last copy of the pointer goes.
    std::shared_ptr<QuickJudge> take();

private:
    const Claim& claim_;
    const Budget& budget_;
    std::mutex guard_;
    std::vector<std::unique_ptr<QuickJudge>> free_;
};

}  // namespace algae
