#include <algorithm>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <variant>

#include "growth/growth.hpp"
#include "language/detail/equality.hpp"
#include "language/detail/interactive.hpp"
#include "language/detail/judge.hpp"
#include "language/detail/lengths.hpp"
#include "language/detail/powers.hpp"
#include "language/detail/progressions.hpp"
#include "language/detail/proof.hpp"
#include "system/system.hpp"
#include "word/word.hpp"

// Inclusion and equality of languages.
//
// Theorems come first: identical expressions, finite languages word by word, regular ones by automata, a
// language of a system within a regular one
// (a meeting with its complement), one within that of a system with all its rules, a regular one within L(G) by induction on the length, two D0L languages by
// sequence equivalence (of sections for an inclusion), linear systems, whose languages are regular, and D0L systems of linear growth where
// theirs are. Where none applies a difference is looked for among short words and first generations;
// if there is none the statement stays undecided. A few short words are tried before the expensive theorems, and where a side is a
// system with context, whose words are found by deriving only, its first words are tried before everything else.

namespace algae {

namespace {

using Kind = LanguageTree::Kind;

constexpr std::size_t first_tried = 30;       // short words that are looked at before theorems are
constexpr std::size_t first_derived = 40;     // words of a system with context that are, too
constexpr std::size_t longest_first = 20;     // letters of these
constexpr std::size_t most_tried = 600;       // short words that are looked at for a difference
constexpr std::size_t longest_short = 30;     // letters of these
constexpr std::size_t longest_witness = 200;  // letters of a word that shows a difference
constexpr std::size_t longest_tried = 60;     // letters of a word of a generation that is looked at
constexpr std::uint64_t most_generations = 12;

/// The language of a linear system: in its words all letters are constant but one at most, which is the last one, or
/// the first one of all words. Nothing for other languages.
std::optional<RegularLanguage> linear_value(const Language& language, const Budget& budget) {
    if (language->kind != Kind::generated || !language->system->tables ||
        !language->system->grammar.empty())
        return std::nullopt;
    const ET0L& system = *language->system->tables;
    if (system.tables.size() != 1 || !has_only_terminals(system)) return std::nullopt;
    const Table& table = system.tables.front();
    const auto is_constant = [&](Symbol a) { return table[a] == std::vector<Word>{{a}}; };
    for (const bool is_last : {true, false}) {
        // The constant letters of a word, in the order in which they are read, and the other one.
        const auto split = [&](Word word) -> std::optional<std::pair<Word, std::optional<Symbol>>> {
            if (!is_last) std::reverse(word.begin(), word.end());
            std::optional<Symbol> active;
            if (!word.empty() && !is_constant(word.back())) {
                active = word.back();
                word.pop_back();
            }
            if (!std::all_of(word.begin(), word.end(), is_constant)) return std::nullopt;
            return std::pair(std::move(word), active);
        };
        Nfa automaton;
        const std::size_t start = automaton.add_state(), end = automaton.add_state(true);
        automaton.initial = {start};
        std::map<Symbol, std::size_t> states;
        std::vector<Symbol> open;
        bool is_linear = true;
        const auto add = [&](std::size_t from, const Word& word) {
            const auto parts = split(word);
            is_linear = is_linear && parts;
            if (!is_linear) return;
            std::size_t to = end;
            if (parts->second) {
                const auto [place, is_new] = states.try_emplace(*parts->second, 0);
                if (is_new) {
                    place->second = automaton.add_state();
                    automaton.add_path(place->second, {*parts->second}, end);
                    open.push_back(*parts->second);
                }
                to = place->second;
            }
            automaton.add_path(from, parts->first, to);
        };
        add(start, system.axiom);
        while (is_linear && !open.empty()) {
            const Symbol a = open.back();
            open.pop_back();
            for (const Word& successor : table[a]) add(states.at(a), successor);
        }
        if (is_linear) {
            const RegularLanguage found(automaton, budget);
            return is_last ? found : reversed(found, budget);
        }
    }
    return std::nullopt;
}

bool is_d0l(const Language& language) {
    return language->kind == Kind::generated && !language->system->variable &&
           has_form(*language->system, *system_form("D0L"));
}

/// What the words of a D0L system are whose lengths grow linearly, if its language is regular.
std::optional<Progressions> progressions_of(const Language& language, const Budget& budget) {
    if (!is_d0l(language)) return std::nullopt;
    const auto found = regularity(as_d0l(*language->system), budget);
    if (!found || !std::holds_alternative<Progressions>(*found)) return std::nullopt;
    return std::get<Progressions>(*found);
}

class LanguageComparison {
public:
    LanguageComparison(const Language& left, const Language& right, const Alphabet& alphabet,
                       const Budget& budget)
        : left_(left), right_(right), alphabet_(alphabet), budget_(budget) {}

    /// Whether left <= right.
    Answer included() {
        if (is_identical()) return proved(steps::Identical{});
        if (auto found = first_difference_in_context(true)) return *found;
        const auto decided = decided_inclusion();
        if (decided && decided->truth != Truth::undecided) return *decided;
        if (auto found = difference(candidates(), true)) return *found;
        if (decided) return *decided;
        if (const std::string reason = undecidable("Inclusion"); !reason.empty())
            return undecided(reason);
        return undecided("no word among the first ones is in " + text(left_) + " and not in " +
                         text(right_) + ", and no theorem applies");
    }

    /// The same where a theorem applies.
    std::optional<Answer> decided_inclusion() {
        if (is_identical()) return proved(steps::Identical{});
        const bool with_context = has_context(left_);
        if (with_context)  // a difference among the first words is found sooner than that there are no others
            if (const auto right = regular_value(right_, alphabet_, budget_))
                if (auto found = derived_outside(*right)) return found;
        if (const auto known = finite_value(left_, alphabet_, budget_))
            return finite_inclusion(*known);
        const auto regular_left = regular_value(left_, alphabet_, budget_);
        const auto regular_right = regular_value(right_, alphabet_, budget_);
        if (regular_left && regular_right) {
            if (const auto word = first_outside(*regular_left, *regular_right, budget_))
                return witness(*word);
            return proved(steps::NothingOutside{left_, right_});
        }
        if (auto found = by_rules()) return found;
        if (regular_right && with_context)
            if (auto found = by_invariants(left_, right_, {}, alphabet_, budget_))
                return proved(*std::move(found));
        if (regular_right)
            if (auto found = generated_in_regular(*regular_right)) return found;
        if (auto found = linear(regular_left, regular_right, false)) return found;
        if (auto found = deterministic_inclusion()) return found;
        if (regular_left) return regular_in_generated(*regular_left);
        return std::nullopt;
    }

    /// Where one side is the language of a linear system and the other one too, or regular.
    std::optional<Answer> linear(std::optional<RegularLanguage> left,
                                 std::optional<RegularLanguage> right, bool equal) const {
        if (left && right) return std::nullopt;  // theorems for regular languages came before
        if (!left) left = linear_value(left_, budget_);
        if (left && !right) right = linear_value(right_, budget_);
        if (!left || !right) return std::nullopt;
        if (const auto word = equal ? first_difference(*left, *right, budget_)
                                    : first_outside(*left, *right, budget_))
            return witness(*word);
        return proved(steps::LinearSystems{left_, right_, equal});
    }

    Answer equal() {
        if (is_identical()) return proved(steps::Identical{});
        if (auto found = first_difference_in_context(false)) return *found;
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
        if (auto found = linear(regular_left, regular_right, true)) return *found;
        if (auto found = equal_progressions(regular_left, regular_right)) return *found;
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

    /// The same expressions, or languages of systems that have the same axiom and rules.
    bool is_identical() const {
        const auto has_rules = [](const LanguageTree& tree) {
            return tree.kind == Kind::generated &&
                   (tree.system->tables || tree.system->interactive);
        };
        if (has_rules(*left_) && has_rules(*right_))
            return to_json(*left_->system, alphabet_) == to_json(*right_->system, alphabet_);
        return to_json(left_, alphabet_) == to_json(right_, alphabet_);
    }

    Answer witness(const Word& word) const {
        return refuted(steps::Distinguished{word, judge_membership(left_, word, alphabet_, budget_),
                                            judge_membership(right_, word, alphabet_, budget_)});
    }

    /// Of the languages of two D0L systems.
    std::optional<Answer> deterministic_equality() const {
        if (!is_d0l(left_) || !is_d0l(right_)) return std::nullopt;
        const LanguageEquality found =
            equal_languages(as_d0l(*left_->system), as_d0l(*right_->system), budget_);
        if (found.equal) return proved(steps::SameDeterministic{found});
        if (found.difference->word) return witness(*found.difference->word);
        return undecided("the word of generation " + std::to_string(found.difference->generation) +
                         " is in one language only, and too long to be written out");
    }

    /// Of the infinite languages of two D0L systems.
    std::optional<Answer> deterministic_inclusion() const {
        if (!is_d0l(left_) || !is_d0l(right_)) return std::nullopt;
        const D0L left = as_d0l(*left_->system), right = as_d0l(*right_->system);
        for (const D0L* each : {&left, &right})
            if (finiteness(ol_of(*each)).finite) return std::nullopt;
        LanguageInclusion found = included_language(left, right, budget_);
        if (!found.included)
            return undecided(
                "the words of generations 0 to " + std::to_string(found.generations - 1) + " of " +
                text(left_) + " were compared with those of " + text(right_) +
                ", and neither a word outside nor sections that are the same were found. Inclusion "
                "of D0L languages is decidable (Ruohonen 1979), but not by this method where the "
                "lengths of the first grow faster");
        if (*found.included)
            return proved(steps::WithinDeterministic{left_, right_, std::move(found.words),
                                                     std::move(found.sections)});
        if (found.difference->word) return witness(*found.difference->word);
        return undecided("the word of generation " + std::to_string(found.difference->generation) +
                         " of " + text(left_) + " is not in " + text(right_) +
                         ", and too long to be written out");
    }

    /// Where one side is regular, and the other one L(G) of a D0L system that is.
    std::optional<Answer> equal_progressions(const std::optional<RegularLanguage>& left,
                                             const std::optional<RegularLanguage>& right) const {
        if (!left == !right) return std::nullopt;
        const auto found = progressions_of(left ? right_ : left_, budget_);
        if (!found) return std::nullopt;
        const auto value = regular_value(as_expression(*found), alphabet_, budget_);
        if (const auto word = first_difference(left ? *left : *right, *value, budget_))
            return witness(*word);
        return proved(steps::SameProgressions{left ? right_ : left_, left ? left_ : right_,
                                              found->first, found->period});
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

    /// Where the right system has all rules of the left one, and derives its axiom.
    std::optional<Answer> by_rules() const {
        if (left_->kind != Kind::generated || right_->kind != Kind::generated) return std::nullopt;
        if (is_d0l(left_) && is_d0l(right_)) return std::nullopt;  // which are decided
        const SourceSystem &left = *left_->system, &right = *right_->system;
        SourceSystem any = right;  // in which every letter is a terminal
        Word axiom;
        if (left.tables && right.tables) {
            if (!has_rules_of(*right.tables, *left.tables)) return std::nullopt;
            axiom = left.tables->axiom;
            for (char& is_terminal : any.tables->terminal) is_terminal = 1;
        } else if (left.interactive && right.interactive) {
            if (!has_rules_of(*right.interactive, *left.interactive)) return std::nullopt;
            axiom = left.interactive->axiom;
        } else {
            return std::nullopt;
        }
        const bool is_derived =
            axiom == (right.tables ? right.tables->axiom : right.interactive->axiom) ||
            judge_membership(generated_language(std::make_shared<const SourceSystem>(any)), axiom,
                             alphabet_, budget_, false)
                    .truth == Truth::proved;
        if (!is_derived) return std::nullopt;
        return proved(steps::ByRules{left_, right_});
    }

    /// Whether each table of `inner` is a part of a table of `outer`, of letters that are accessible in it, and a terminal is one there.
    static bool has_rules_of(const ET0L& outer, const ET0L& inner) {
        const auto letters = accessible_letters(inner);
        return std::all_of(letters.begin(), letters.end(),
                           [&](Symbol a) { return !inner.terminal[a] || outer.terminal[a]; }) &&
               std::all_of(inner.tables.begin(), inner.tables.end(), [&](const Table& table) {
                   return std::any_of(
                       outer.tables.begin(), outer.tables.end(), [&](const Table& other) {
                           return std::all_of(letters.begin(), letters.end(), [&](Symbol a) {
                               return are_among(table[a], other[a]);
                           });
                       });
               });
    }

    /// The same with contexts. A rule with other contexts would take the place of one that is tried later, so contexts are the same.
    static bool has_rules_of(const IL& outer, const IL& inner) {
        if (outer.ignored != inner.ignored || outer.brackets || inner.brackets) return false;
        for (Symbol a = 0; a < inner.rules.size(); ++a) {
            std::vector<std::pair<Word, Word>> contexts[2];
            std::vector<Word> rules[2];  // a rule as one word
            const auto read = [&](const IL& system, std::size_t to) {
                for (const IL::Rule& rule : system.rules[a]) {
                    if (contexts[to].empty() ||
                        contexts[to].back() != std::pair(rule.left, rule.right))
                        contexts[to].emplace_back(rule.left, rule.right);
                    rules[to].push_back(rule.successor);
                    rules[to].back().push_back(static_cast<Symbol>(contexts[to].size()));
                }
            };
            read(inner, 0), read(outer, 1);
            if (contexts[0] != contexts[1] || !are_among(rules[0], rules[1])) return false;
        }
        return true;
    }

    static bool are_among(const std::vector<Word>& words, const std::vector<Word>& others) {
        return std::all_of(words.begin(), words.end(), [&](const Word& word) {
            return std::find(others.begin(), others.end(), word) != others.end();
        });
    }

    /// The theorem that no method decides it for all languages that are given so; empty where none is known.
    std::string undecidable(const std::string& what) const {
        const auto has_grammar = [](const LanguageTree& tree) {
            return tree.kind == Kind::generated && !tree.system->grammar.empty();
        };
        const auto is_system = [](const Language& side) {
            return side->kind == Kind::generated && !side->system->variable;
        };
        const auto is_regular = [&](const Language& side) { return !has_system(side); };
        const auto is_extended = [&](const Language& side) {
            return is_system(side) && side->system->tables &&
                   !has_only_terminals(*side->system->tables);
        };
        std::string theorem;
        if (has_grammar(*left_) || has_grammar(*right_))
            theorem =
                " of context-free languages is undecidable (Bar-Hillel, Perles and Shamir 1961)";
        else if (is_system(left_) && is_system(right_) && (!is_d0l(left_) || !is_d0l(right_)))
            theorem = what == "Equality" ? " of 0L languages is undecidable (Blattner 1973)"
                                         : " of 0L languages is undecidable, as their equality is "
                                           "(Blattner 1973)";
        else if (is_extended(right_) && is_regular(left_))  // all words, for one
            theorem =
                " of a regular language and an E0L language is undecidable (Bar-Hillel, Perles "
                "and Shamir 1961, for context-free languages)";
        if (theorem.empty()) return {};
        return "no word among the first ones tells " + text(left_) + " and " + text(right_) +
               " apart. " + what + theorem + ", so no method decides it for all " +
               (has_grammar(*left_) || has_grammar(*right_) ? "grammars" : "systems");
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
        if (right_->kind != Kind::generated || right_->system->variable) return std::nullopt;
        auto found = induction(left, *right_->system);
        if (!found) return std::nullopt;
        for (const Word& word : found->base) {
            Answer member = judge_membership(right_, word, alphabet_, budget_);
            if (member.truth == Truth::refuted) return witness(word);
            if (member.truth == Truth::undecided) return std::nullopt;
            found->members.push_back(std::move(member));
        }
        return proved(*std::move(found));
    }

    /// With the base of an induction, whose words are not looked at here.
    std::optional<steps::ByInduction> induction(const RegularLanguage& left,
                                                const SourceSystem& system) const {
        constexpr std::size_t most = 100;
        if (system.interactive) {
            const auto longer = longer_successors(*system.interactive, left, budget_);
            if (!longer) return std::nullopt;
            const RegularLanguage base = algae::difference(left, *longer, budget_);
            const auto count = number_of_words(base);
            if (!count || *count > Integer(most)) return std::nullopt;
            return steps::ByInduction{
                left_, words_up_to(base, base.automaton().states(), budget_), {}, {}};
        }
        const ET0L& tables = *system.tables;
        if (!has_only_terminals(tables)) return std::nullopt;
        constexpr std::size_t most_states = 16;  // with more, lengths are faster than automata
        const auto lengths = is_finite(left) ? std::nullopt : lengths_of(left);
        if (lengths && left.automaton().states() > most_states) return by_lengths(*lengths, tables);
        const auto found = regular_induction(left, tables.tables, most, budget_);
        if (!found && lengths) return by_lengths(*lengths, tables);
        if (!found) return std::nullopt;
        steps::ByInduction induction{left_, found->base, {}, {}};
        if (found->counted.size() < tables.tables.front().size())
            induction.counted = found->counted;
        return induction;
    }

    std::optional<steps::ByInduction> by_lengths(const LengthSet& left, const ET0L& system) const {
        constexpr std::size_t most = 100, limit = 20'000;
        std::vector<LengthTable> tables;
        for (const Table& table : system.tables) {
            std::set<std::size_t> lengths;
            for (const Word& word : table.at(left.letter))
                if (std::all_of(word.begin(), word.end(),
                                [&](Symbol a) { return a == left.letter; }))
                    lengths.insert(word.size());
            tables.push_back({{lengths.begin(), lengths.end()}});
        }
        const auto found = length_induction(left, tables, most, limit, budget_);
        if (!found) return std::nullopt;
        steps::ByInduction induction{left_, {}, {}, {}, found->from, found->tables};
        for (const std::size_t length : found->base)
            induction.base.push_back(Word(length, left.letter));
        return induction;
    }

    /// A word that is in one of the languages only, in the left one if `left_only`, among these.
    std::optional<Answer> difference(const std::vector<Word>& words, bool left_only) const {
        for (const Word& word : words) {
            budget_.check();
            const Truth in_left = judge_membership(left_, word, alphabet_, budget_, false).truth;
            if (in_left == Truth::undecided || (left_only && in_left == Truth::refuted)) continue;
            const Truth in_right = judge_membership(right_, word, alphabet_, budget_, false).truth;
            if (in_right != Truth::undecided && in_left != in_right) return witness(word);
        }
        return std::nullopt;
    }

    /// The same among the very first words, where a side is made of systems with context.
    std::optional<Answer> first_difference_in_context(bool left_only) const {
        if (!has_context(left_) && !has_context(right_)) return std::nullopt;
        std::vector<Word> words;
        std::set<Word> known;
        const auto add = [&](Word word) {
            if (known.insert(word).second) words.push_back(std::move(word));
        };
        for (const Language& side : {left_, right_})
            for (Word& word : first_words(*side, budget_)) add(std::move(word));
        for (Word& word : short_words(first_tried)) add(std::move(word));
        for (const Language& side : {left_, right_})
            for (Word& word : derived_words(*side, {first_derived, 20 * first_derived, {}}))
                if (word.size() <= longest_first) add(std::move(word));
        return difference(words, left_only);
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
        if (tree.kind == Kind::generated && tree.system->interactive)
            for (const Word& word : derived_words(tree))
                if (word.size() <= longest_tried) words.push_back(word);
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

    /// A word of the left side that is not in the right one, among the first words of its systems with context.
    std::optional<Answer> derived_outside(const RegularLanguage& right) const {
        for (const Word& word : derived_words(*left_))
            if (word.size() <= longest_witness && !right.contains(word) &&
                judge_membership(left_, word, alphabet_, budget_, false).truth == Truth::proved)
                return witness(word);
        return std::nullopt;
    }

    /// First words of the systems with context in an expression.
    std::vector<Word> derived_words(const LanguageTree& tree,
                                    const SearchOfWords& search = {200, 20'000, {}}) const {
        std::vector<Word> words;
        for (const Language& part : tree.parts)
            for (Word& word : derived_words(*part, search)) words.push_back(std::move(word));
        if (tree.kind == Kind::generated && tree.system->interactive)
            words = found_words(*tree.system->interactive, search, budget_).words;
        return words;
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

namespace {

bool is_set(const Language& language, const std::vector<Word>& words) {
    return language->kind == Kind::words && language->words == words;
}

// What a regular expression is made of; null is the empty language.

Language either(const Language& left, const Language& right) {
    if (!left || !right) return left ? left : right;
    if (left->kind == Kind::words && right->kind == Kind::words) {
        std::vector<Word> all = left->words;
        all.insert(all.end(), right->words.begin(), right->words.end());
        return words_language(std::move(all));
    }
    return combined(Kind::united, {left, right});
}

Language after(const Language& left, const Language& right) {
    if (!left || !right) return nullptr;
    if (is_set(left, {{}})) return right;
    if (is_set(right, {{}})) return left;
    if (left->kind == Kind::words && right->kind == Kind::words &&
        left->words.size() * right->words.size() == 1) {
        Word word = left->words.front();
        word.insert(word.end(), right->words.front().begin(), right->words.front().end());
        return words_language({std::move(word)});
    }
    return combined(Kind::concatenated, {left, right});
}

Language repeated(const Language& part) {
    if (!part || is_set(part, {{}})) return words_language({{}});
    return combined(Kind::star, {part});
}

/// The language as an expression, by elimination of states (Brzozowski and McCluskey 1963); null where the automaton has
/// more than 20 states.
Language expression_of(const RegularLanguage& language) {
    constexpr std::size_t most = 20;
    const Dfa& automaton = language.automaton();
    const std::size_t states = automaton.states(), start = states, end = states + 1;
    if (states > most) return nullptr;
    const std::vector<std::size_t> ways = distances(automaton);
    std::map<std::pair<std::size_t, std::size_t>, Language> edges;
    const auto add = [&](std::size_t from, std::size_t to, const Language& by) {
        auto& edge = edges[{from, to}];
        edge = either(edge, by);
    };
    add(start, automaton.initial, words_language({{}}));
    std::set<std::size_t> left;
    for (std::size_t s = 0; s < states; ++s) {
        if (ways[s] == states) continue;  // nothing is accepted from it
        left.insert(s);
        if (automaton.accepting[s]) add(s, end, words_language({{}}));
        for (std::size_t a = 0; a < automaton.letters; ++a)
            if (const std::size_t to = automaton.step(s, static_cast<Symbol>(a));
                ways[to] != states)
                add(s, to, words_language({{static_cast<Symbol>(a)}}));
    }
    while (!left.empty()) {
        const auto cost = [&](std::size_t s) {
            std::size_t in = 0, out = 0;
            for (const auto& [edge, by] : edges) {
                in += edge.second == s && edge.first != s;
                out += edge.first == s && edge.second != s;
            }
            return in * out;
        };
        const std::size_t gone =
            *std::min_element(left.begin(), left.end(),
                              [&](std::size_t a, std::size_t b) { return cost(a) < cost(b); });
        left.erase(gone);
        const auto loop = edges.find({gone, gone});
        const Language rounds = repeated(loop == edges.end() ? nullptr : loop->second);
        std::vector<std::pair<std::size_t, Language>> in, out;
        for (const auto& [edge, by] : edges) {
            if (edge.second == gone && edge.first != gone) in.emplace_back(edge.first, by);
            if (edge.first == gone && edge.second != gone) out.emplace_back(edge.second, by);
        }
        std::erase_if(edges, [&](const auto& edge) {
            return edge.first.first == gone || edge.first.second == gone;
        });
        for (const auto& [from, first] : in)
            for (const auto& [to, last] : out) add(from, to, after(after(first, rounds), last));
    }
    const auto whole = edges.find({start, end});
    return whole == edges.end() ? words_language({}) : whole->second;
}

/// Of a D0L system each letter of which stays, or stays between constant letters: x^n a y^n for each such a.
Language powers_form(const D0L& system) {
    const auto is_constant = [&](Symbol a) { return system.rules[a] == Word{a}; };
    Powers powers;
    powers.numbers = {{"n", 0}};
    const auto add = [&](Word word, bool varies) {
        if (word.empty()) return;
        std::vector<Powers::Term> exponent(1);
        if (varies) exponent.front() = {.number = 0, .power = 1};
        powers.blocks.push_back({std::move(word), std::move(exponent)});
    };
    for (const Symbol a : system.axiom) {
        const Word& successor = system.rules[a];
        if (is_constant(a)) {
            add({a}, false);
            continue;
        }
        const auto middle = std::find(successor.begin(), successor.end(), a);
        if (middle == successor.end() || !std::all_of(successor.begin(), middle, is_constant) ||
            !std::all_of(middle + 1, successor.end(), is_constant))
            return nullptr;
        add(Word(successor.begin(), middle), true);
        add({a}, false);
        add(Word(middle + 1, successor.end()), true);
    }
    return powers_language(std::move(powers));
}

}  // namespace

std::vector<Language> likely_forms(const Language& generated, const Budget& budget) {
    std::vector<Language> forms;
    const auto add = [&](const Language& form) {
        if (form) forms.push_back(form);
    };
    if (const auto linear = linear_value(generated, budget)) {
        add(expression_of(*linear));
        return forms;
    }
    if (generated->kind != Kind::generated || !has_form(*generated->system, *system_form("D0L")))
        return forms;
    const D0L system = as_d0l(*generated->system);
    const GrowthOrder order = growth_class(system, budget).order;
    if (order.kind != GrowthKind::polynomial || order.degree != 1) return forms;
    if (Language powers = powers_form(system)) {
        add(regular_form(*powers->powers));
        add(powers);
        return forms;
    }
    if (const auto found = progressions_of(generated, budget)) add(as_expression(*found));
    return forms;
}

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
