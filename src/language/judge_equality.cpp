#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "language/detail/judge.hpp"
#include "language/detail/powers.hpp"
#include "language/detail/proof.hpp"
#include "word/word.hpp"

// Inclusion and equality of languages.
//
// Theorems come first: identical expressions, finite languages word by word, regular ones by automata, a
// language of a system within a regular one
// (a meeting with its complement), a regular one within L(G) by induction on the length, two D0L languages by
// sequence equivalence. Where none applies a difference is looked for among short words and first generations;
// if there is none the statement stays undecided. A few short words are tried before the expensive theorems.

namespace algae {

namespace {

using Kind = LanguageTree::Kind;

constexpr std::size_t first_tried = 30;    // short words that are looked at before theorems are
constexpr std::size_t most_tried = 600;    // short words that are looked at for a difference
constexpr std::size_t longest_short = 30;  // letters of these
constexpr std::size_t longest_tried = 60;  // letters of a word of a generation that is looked at
constexpr std::uint64_t most_generations = 12;

class LanguageComparison {
public:
    LanguageComparison(const Language& left, const Language& right, const Alphabet& alphabet,
                       const Budget& budget)
        : left_(left), right_(right), alphabet_(alphabet), budget_(budget) {}

    /// Whether left <= right.
    Answer included() {
        if (auto found = decided_inclusion()) return *found;
        if (auto found = difference(candidates(), true)) return *found;
        if (const std::string reason = undecidable("Inclusion"); !reason.empty())
            return undecided(reason);
        return undecided("no word among the first ones is in " + text(left_) + " and not in " +
                         text(right_) + ", and no theorem applies");
    }

    /// The same where a theorem applies.
    std::optional<Answer> decided_inclusion() {
        if (is_identical()) return proved(steps::Identical{});
        if (const auto known = finite_value(left_, alphabet_, budget_))
            return finite_inclusion(*known);
        const auto regular_left = regular_value(left_, alphabet_, budget_);
        const auto regular_right = regular_value(right_, alphabet_, budget_);
        if (regular_left && regular_right) {
            if (const auto word = first_outside(*regular_left, *regular_right, budget_))
                return witness(*word);
            return proved(steps::NothingOutside{left_, right_});
        }
        if (regular_right)
            if (auto found = generated_in_regular(*regular_right)) return found;
        if (regular_left) return regular_in_generated(*regular_left);
        return std::nullopt;
    }

    Answer equal() {
        if (is_identical()) return proved(steps::Identical{});
        const auto left = finite_value(left_, alphabet_, budget_),
                   right = finite_value(right_, alphabet_, budget_);
        if (left && right) return finite_equality(*left, *right);
        const auto regular_left = regular_value(left_, alphabet_, budget_);
        const auto regular_right = regular_value(right_, alphabet_, budget_);
        if (regular_left && regular_right) {
            if (const auto word = first_difference(*regular_left, *regular_right, budget_))
                return witness(*word);
            return proved(steps::SameAutomata{regular_left->automaton().states()});
        }
        if (auto found = deterministic_equality()) return *found;
        if (auto found = same_sequences()) return *found;
        if (auto found = difference(short_words(first_tried), false)) return *found;
        const auto there = decided_inclusion();
        if (there && there->truth == Truth::refuted) return *there;
        const auto back = LanguageComparison(right_, left_, alphabet_, budget_).decided_inclusion();
        if (back && back->truth == Truth::refuted) return *back;
        if (there && back && there->truth == Truth::proved && back->truth == Truth::proved)
            return proved(steps::BothInclusions{there->proof, back->proof});
        if (auto found = difference(candidates(), false)) return *found;
        if (const std::string reason = undecidable("Equality"); !reason.empty())
            return undecided(reason);
        const auto is_open = [](const auto& side) {
            return !side || side->truth == Truth::undecided;
        };
        return undecided("no word among the first ones is in one of " + text(left_) + " and " +
                         text(right_) + " only, and that " +
                         (is_open(there) ? text(left_) + " <= " + text(right_)
                                         : text(right_) + " <= " + text(left_)) +
                         " was not shown");
    }

private:
    std::string text(const Language& language) const { return to_string(language, alphabet_); }

    bool is_identical() const { return to_json(left_, alphabet_) == to_json(right_, alphabet_); }

    Answer witness(const Word& word) const {
        return refuted(steps::Distinguished{word, judge_membership(left_, word, alphabet_, budget_),
                                            judge_membership(right_, word, alphabet_, budget_)});
    }

    /// Of the languages of two D0L systems.
    std::optional<Answer> deterministic_equality() const {
        const auto is_d0l = [](const LanguageTree& tree) {
            return tree.kind == Kind::generated && has_form(*tree.system, *system_form("D0L"));
        };
        if (!is_d0l(*left_) || !is_d0l(*right_)) return std::nullopt;
        const LanguageEquality found =
            equal_languages(as_d0l(*left_->system), as_d0l(*right_->system), budget_);
        if (found.equal) return proved(steps::SameDeterministic{found});
        if (found.difference->word) return witness(*found.difference->word);
        return undecided("the word of generation " + std::to_string(found.difference->generation) +
                         " is in one language only, and too long to be written out");
    }

    /// Of languages whose words are a sequence with powers, or that of a D0L system.
    std::optional<Answer> same_sequences() const {
        const auto left = sequence_of(left_), right = sequence_of(right_);
        if (!left && !right) return std::nullopt;
        const std::string sequence = to_string(left ? *left : *right, alphabet_);
        if (left && right) {
            if (!is_same(*left, *right)) return std::nullopt;
            return proved(steps::SamePowers{left_, right_, sequence, {}});
        }
        const LanguageTree& other = left ? *right_ : *left_;
        if (other.kind != Kind::generated || !has_form(*other.system, *system_form("D0L")) ||
            !follows(as_d0l(*other.system), left ? *left : *right))
            return std::nullopt;
        return proved(steps::SamePowers{left_, right_, sequence, other.system->name});
    }

    /// What is known of all context-free languages, where both sides are such and one is given by a grammar.
    std::string undecidable(const std::string& what) const {
        const auto has_grammar = [](const LanguageTree& tree) {
            return tree.kind == Kind::generated && !tree.system->grammar.empty();
        };
        if (!has_grammar(*left_) && !has_grammar(*right_)) return {};
        return "no word among the first ones tells " + text(left_) + " and " + text(right_) +
               " apart. " + what +
               " of context-free languages is undecidable (Bar-Hillel, Perles and Shamir 1961), so "
               "no method decides it for all grammars";
    }

    Answer finite_equality(const FiniteValue& left, const FiniteValue& right) const {
        if (left.words == right.words) return proved(steps::SameValues{left.known, right.known});
        std::vector<Word> alone;  // of the left side, or of the right one if there are none
        std::set_difference(left.words.begin(), left.words.end(), right.words.begin(),
                            right.words.end(), std::back_inserter(alone), shortlex_less);
        if (alone.empty())
            std::set_difference(right.words.begin(), right.words.end(), left.words.begin(),
                                left.words.end(), std::back_inserter(alone), shortlex_less);
        return refuted(steps::OtherValues{left.known, right.known, alone.front()});
    }

    Answer finite_inclusion(const FiniteValue& left) const {
        steps::ValuesWithin within{left.known, {}};
        std::optional<Answer> open;
        for (const Word& word : left.words) {
            Answer found = judge_membership(right_, word, alphabet_, budget_);
            if (found.truth == Truth::refuted) return witness(word);
            if (found.truth == Truth::undecided)
                open = std::move(found);
            else if (within.members.size() < steps::ValuesWithin::most_shown)
                within.members.push_back(std::move(found.proof));
        }
        return open ? *open : proved(std::move(within));
    }

    std::optional<Answer> generated_in_regular(const RegularLanguage& right) const {
        auto tables = table_value(left_, alphabet_, budget_);
        if (!tables) return std::nullopt;
        const Meeting meeting = first_outside(tables->system, right, budget_);
        if (meeting.derivation) return witness(meeting.derivation->words.back());
        steps::WithinRegular within{left_, right_, repeated(meeting, tables->system), nullptr};
        const bool is_checked = left_->kind == Kind::generated || left_->kind == Kind::powers;
        if (!is_checked || has_system(right_))
            within.constructed = std::make_shared<const TableValue>(std::move(*tables));
        return proved(std::move(within));
    }

    std::optional<Answer> regular_in_generated(const RegularLanguage& left) const {
        if (right_->kind != Kind::generated || !right_->system->tables) return std::nullopt;
        const ET0L& system = *right_->system->tables;
        if (system.tables.size() != 1 || !has_only_terminals(system)) return std::nullopt;
        const auto found = regular_induction(left, without_terminals(system), 100, budget_);
        if (!found) return std::nullopt;
        steps::ByInduction induction{left_, {}, {}};
        for (const Word& word : found->base) {
            Answer member = judge_membership(right_, word, alphabet_, budget_);
            if (member.truth == Truth::refuted) return witness(word);
            induction.base.push_back(word);
            induction.members.push_back(std::move(member));
        }
        return proved(std::move(induction));
    }

    /// A word that is in one of the languages only, in the left one if `left_only`, among these.
    std::optional<Answer> difference(const std::vector<Word>& words, bool left_only) const {
        for (const Word& word : words) {
            budget_.check();
            const Truth in_left = judge_membership(left_, word, alphabet_, budget_).truth;
            if (in_left == Truth::undecided || (left_only && in_left == Truth::refuted)) continue;
            const Truth in_right = judge_membership(right_, word, alphabet_, budget_).truth;
            if (in_right != Truth::undecided && in_left != in_right) return witness(word);
        }
        return std::nullopt;
    }

    /// The first words, shorter ones first.
    std::vector<Word> short_words(std::size_t most) const {
        std::set<Symbol> letters;
        for (const Language& side : {left_, right_})
            for (const Symbol a : letters_of(side)) letters.insert(a);
        std::vector<Word> words{{}};
        for (std::size_t i = 0;
             i < words.size() && words.size() < most && words[i].size() < longest_short; ++i)
            for (const Symbol a : letters) {
                words.push_back(words[i]);
                words.back().push_back(a);
            }
        return words;
    }

    /// Short words, and the words of first generations of the systems that are not too long.
    std::vector<Word> candidates() const {
        std::vector<Word> words = short_words(most_tried);
        add_generations(*left_, words);
        add_generations(*right_, words);
        return words;
    }

    void add_generations(const LanguageTree& tree, std::vector<Word>& words) const {
        for (const Language& part : tree.parts) add_generations(*part, words);
        if (tree.kind == Kind::powers) add_powers(*tree.powers, words);
        if (tree.kind != Kind::generated || !tree.system->tables) return;
        for (const Table& table : tree.system->tables->tables) {
            Word word = tree.system->tables->axiom;
            for (std::uint64_t n = 0; n < most_generations && word.size() <= longest_tried; ++n) {
                words.push_back(word);
                Word next;
                for (const Symbol a : word)
                    next.insert(next.end(), table[a].front().begin(), table[a].front().end());
                word = std::move(next);
            }
        }
    }

    /// The words for small values of the numbers.
    void add_powers(const Powers& powers, std::vector<Word>& words) const {
        const std::uint64_t second_most = powers.numbers.size() > 1 ? most_generations : 1;
        Budget small = budget_;
        small.letters = longest_tried;
        for (std::uint64_t n = 0; n < most_generations; ++n)
            for (std::uint64_t m = 0; m < second_most; ++m) {
                std::vector<std::uint64_t> values{powers.numbers.front().least + n};
                if (powers.numbers.size() > 1) values.push_back(powers.numbers.back().least + m);
                try {
                    words.push_back(word_of(powers, values, small));
                } catch (const BoundReached&) {  // it is too long to be tried
                    break;
                }
            }
    }

    const Language& left_;
    const Language& right_;
    const Alphabet& alphabet_;
    const Budget& budget_;
};

}  // namespace

Repeated repeated(const Meeting& meeting, const ET0L& system) {
    return {meeting.step, meeting.earlier, system.tables.size() == 1};
}

Answer judge_inclusion(const Language& inner, const Language& outer, const Alphabet& alphabet,
                       const Budget& budget) {
    return LanguageComparison(inner, outer, alphabet, budget).included();
}

Answer judge_equality(const Language& left, const Language& right, const Alphabet& alphabet,
                      const Budget& budget) {
    return LanguageComparison(left, right, alphabet, budget).equal();
}

}  // namespace algae
