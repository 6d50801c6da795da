#include "language/detail/judge.hpp"

#include <algorithm>
#include <map>

#include "language/detail/interactive.hpp"
#include "language/detail/powers.hpp"
#include "word/word.hpp"

// Whether a word is in a language, by the definition of each operation.
//
// For L(G) of a system without context the decision is complete (membership.cpp, tables_membership.cpp). A
// deterministic system with context is derived until its words repeat or, where no rule erases, are longer than the word;
// one with choices is searched breadth first, completely where no rule erases. Otherwise an invariant may keep the word out
// (interactive.cpp).
//
// Of a concatenation or star all ways to cut the word are tried, each factor decided once. Of an image all
// words with this image: one by one where they are finitely many, otherwise by automata or by a system that
// constructions make. What a part leaves undecided leaves the whole undecided unless another part decides it.

namespace algae {

namespace {

constexpr std::uint64_t most_generations = 10'000;  // that a system with context is followed

Answer judge_tables(const SourceSystem& system, const Word& word, const Budget& budget) {
    const Membership found = membership(*system.tables, word, budget);
    if (!found.member) return refuted(steps::NotGenerated{system.name, word, found});
    return proved(steps::Generated{system.name, derivation(*system.tables, word, found, budget)});
}

/// Follows the generations of a deterministic system. Where no rule has the empty successor, no generation is shorter than the
/// one before, so the first that is longer than the word ends the search: without this the words of
/// a growing system are followed to the bound, for each of the hundreds of short words in which two
/// languages may differ.
Answer judge_sequence(const SourceSystem& system, const Word& word, const Alphabet& alphabet,
                      bool thorough, const Budget& budget) {
    const std::uint64_t most_letters =
        thorough ? budget.letters / 1000 : std::min<std::uint64_t>(budget.letters / 1000, 20'000);
    using Reason = Membership::Reason;
    Derivation walk{{system.interactive->axiom}, {}};
    const bool propagating = has_form(system, *system_form("PIL"));
    std::map<Word, std::uint64_t> seen;
    for (std::uint64_t n = 0; n < most_generations; ++n) {
        budget.check();
        const Word& current = walk.words.back();
        if (current == word) return proved(steps::Generated{system.name, walk});
        if (propagating && current.size() > word.size())
            return refuted(steps::NotGenerated{system.name, word, {false, Reason::outgrown, n}});
        if (const auto before = seen.find(current); before != seen.end())
            return refuted(steps::NotGenerated{
                system.name, word, {false, Reason::periodic, n, before->second}});
        seen.emplace(current, n);
        if (seen.size() * (current.size() + 1) > most_letters) break;
        walk.words.push_back(next_word(*system.interactive, current));
    }
    return undecided("the first " + std::to_string(walk.words.size()) + " words of L(" +
                     system.name + ") are not " + spell(alphabet, word) +
                     ", and they do not repeat");
}

/// Looks at all words, breadth first. Where no rule has the empty successor those that are longer than the word are left out with
/// their descendants, so the answer is complete.
Answer judge_choices(const SourceSystem& system, const Word& word, const Alphabet& alphabet,
                     bool thorough, const Budget& budget) {
    using Reason = Membership::Reason;
    const IL& rules = *system.interactive;
    const bool propagating = is_propagating(rules);
    SearchOfWords search;
    search.words = !thorough ? 1000 : propagating ? 1'000'000 : 20'000;
    search.letters = search.words * 20;
    if (propagating) search.longest = word.size();
    const FoundWords found = found_words(rules, search, budget, word);
    if (const auto number = found.numbers.find(word); number != found.numbers.end())
        return proved(steps::Generated{system.name, found.derivation(number->second)});
    if (!found.is_all)
        return undecided("the first " + std::to_string(found.words.size()) + " words of L(" +
                         system.name + ") are not " + spell(alphabet, word));
    Membership why{false, propagating ? Reason::short_words : Reason::all_words};
    why.states = found.words.size();
    return refuted(steps::NotGenerated{system.name, word, why});
}

Answer judge_interactive(const SourceSystem& system, const Word& word, const Alphabet& alphabet,
                         bool thorough, const Budget& budget) {
    return is_deterministic(*system.interactive)
               ? judge_sequence(system, word, alphabet, thorough, budget)
               : judge_choices(system, word, alphabet, thorough, budget);
}

}  // namespace

Answer judge_generated(const SourceSystem& system, const Word& word, const Alphabet& alphabet,
                       const Budget& budget, bool thorough) {
    return system.tables ? judge_tables(system, word, budget)
                         : judge_interactive(system, word, alphabet, thorough, budget);
}

namespace {

using Kind = LanguageTree::Kind;

constexpr std::size_t most_preimages = 10'000;

class Members {
public:
    Members(const Alphabet& alphabet, bool thorough, const Budget& budget)
        : alphabet_(alphabet), thorough_(thorough), budget_(budget) {}

    Answer judge(const Language& language, const Word& word) {
        budget_.check();
        const LanguageTree& tree = *language;
        switch (tree.kind) {
            case Kind::words:
                return listed(
                    language, word,
                    std::find(tree.words.begin(), tree.words.end(), word) != tree.words.end());
            case Kind::generated:
                return judge_generated(*tree.system, word, alphabet_, budget_, thorough_);
            case Kind::united:
                return either(language, word, false, false);
            case Kind::intersected:
                return either(language, word, true, true);
            case Kind::difference:
                return either(language, word, true, false);
            case Kind::complement:
                return complement(language, word);
            case Kind::reversed:
                return from(language, word, judge(tree.parts[0], Word(word.rbegin(), word.rend())));
            case Kind::concatenated:
                return concatenation(language, word);
            case Kind::star:
            case Kind::plus:
                return iteration(language, word);
            case Kind::image:
                return image(language, word);
            case Kind::inverse_image:
                return inverse_image(language, word);
            case Kind::powers: {
                auto values = values_of(*tree.powers, word, budget_);
                const bool in = values.has_value();
                return decided(in, steps::OfPowers{language, word, std::move(values)});
            }
            case Kind::variable:
                break;
        }
        throw Error("a bound name has no words");
    }

private:
    static Answer listed(const Language& language, const Word& word, bool in) {
        return decided(in, steps::Listed{language, word, in});
    }

    /// What follows from the answer about a part, or the word's image in it.
    static Answer from(const Language& language, const Word& word, Answer part,
                       const std::optional<Word>& image = {}) {
        if (part.truth == Truth::undecided) return part;
        return decided(
            part.truth == Truth::proved,
            steps::FromParts{
                language, word, part.truth == Truth::proved, {std::move(part.proof)}, image});
    }

    /// Of a union: the first part that has the word; neither; otherwise undecided. An intersection has the
    /// word if the union of the complements has not, and a difference likewise.
    Answer either(const Language& language, const Word& word, bool left_denied, bool right_denied) {
        const auto part = [&](std::size_t i, bool denied) {
            Answer found = judge(language->parts[i], word);
            return denied ? opposite(std::move(found)) : found;
        };
        const bool in = !left_denied;
        Answer first = part(0, left_denied);
        if (first.truth == Truth::proved)
            return decided(in, steps::FromParts{language, word, in, {first.proof}});
        Answer second = part(1, right_denied);
        if (second.truth == Truth::proved)
            return decided(in, steps::FromParts{language, word, in, {second.proof}});
        if (first.truth == Truth::undecided) return first;
        if (second.truth == Truth::undecided) return second;
        return decided(!in, steps::FromParts{language, word, !in, {first.proof, second.proof}});
    }

    Answer complement(const Language& language, const Word& word) {
        const auto& letters = language->letters;
        for (const Symbol a : word)
            if (!std::binary_search(letters.begin(), letters.end(), a))
                return from(language, word, refuted(steps::OtherLetters{letters, a}));
        return from(language, word, opposite(judge(language->parts[0], word)));
    }

    /// Whether a factor is in a language; each is decided once.
    Truth factor(const Language& language, const Word& word, std::size_t from, std::size_t to) {
        const Word part(word.begin() + static_cast<std::ptrdiff_t>(from),
                        word.begin() + static_cast<std::ptrdiff_t>(to));
        const auto key = std::pair(language.get(), part);
        if (const auto known = known_.find(key); known != known_.end()) return known->second;
        const Truth truth = judge(language, part).truth;
        known_.emplace(key, truth);
        return truth;
    }

    Answer concatenation(const Language& language, const Word& word) {
        bool unknown = false;
        for (std::size_t at = 0; at <= word.size(); ++at) {
            const Truth left = factor(language->parts[0], word, 0, at);
            if (left == Truth::refuted) continue;
            const Truth right = factor(language->parts[1], word, at, word.size());
            if (left == Truth::proved && right == Truth::proved)
                return proved(steps::Factored{language, word, {at, word.size()}});
            unknown = unknown || right != Truth::refuted;
        }
        if (unknown) return factors_open(word);
        return refuted(steps::NotFactored{language, word});
    }

    Answer iteration(const Language& language, const Word& word) {
        const Language& base = language->parts[0];
        if (word.empty()) {
            if (language->kind == Kind::star) return listed(language, word, true);
            return from(language, word, judge(base, word));
        }
        // back[i]: where the last factor of word[0, i) begins, if it is a product of words of the base.
        std::vector<std::optional<std::size_t>> back(word.size() + 1);
        back[0] = 0;
        bool unknown = false;
        for (std::size_t to = 1; to <= word.size(); ++to)
            for (std::size_t from = 0; from < to && !back[to]; ++from) {
                if (!back[from]) continue;
                const Truth truth = factor(base, word, from, to);
                if (truth == Truth::proved) back[to] = from;
                unknown = unknown || truth == Truth::undecided;
            }
        if (back[word.size()]) {
            std::vector<std::size_t> ends;
            for (std::size_t at = word.size(); at > 0; at = *back[at]) ends.push_back(at);
            std::reverse(ends.begin(), ends.end());
            return proved(steps::Factored{language, word, std::move(ends)});
        }
        if (unknown) return factors_open(word);
        return refuted(steps::NotFactored{language, word});
    }

    Answer factors_open(const Word& word) const {
        return undecided("some factors of " + spell(alphabet_, word) + " could not be decided");
    }

    Answer image(const Language& language, const Word& word) {
        const LanguageTree& tree = *language;
        const Language& part = tree.parts[0];
        if (has_context(part))  // its first words are found sooner than others are left out
            for (const Word& source : first_words(*part, budget_))
                if (tree.morphism.image_of(source) == word &&
                    judge(part, source).truth == Truth::proved)
                    return proved(steps::HasPreimage{language, word, source});
        const RegularLanguage sources = algae::inverse_image(
            finite_set({word}), tree.morphism.images(), tree.morphism.domain());
        const auto count = number_of_words(sources);
        if (count && *count <= Integer(most_preimages)) {
            bool unknown = false;
            for (const Word& source : words_up_to(sources, sources.automaton().states(), budget_)) {
                const Truth truth = judge(part, source).truth;
                if (truth == Truth::proved)
                    return proved(steps::HasPreimage{language, word, source});
                unknown = unknown || truth == Truth::undecided;
            }
            if (!unknown) return refuted(steps::HasNoPreimage{language, word});
        } else if (const auto regular = regular_value(part, alphabet_, budget_)) {
            const auto source = shortest_word(intersected(*regular, sources, budget_));
            if (source) return proved(steps::HasPreimage{language, word, *source});
            return refuted(steps::HasNoPreimage{language, word});
        } else if (const auto tables = table_value(part, alphabet_, budget_)) {
            const Meeting meeting = first_meeting(tables->system, sources, budget_);
            if (meeting.derivation)
                return proved(steps::HasPreimage{language, word, meeting.derivation->words.back()});
            return refuted(steps::HasNoPreimage{language, word});
        }
        return undecided("the words with the image " + spell(alphabet_, word) +
                         " could not all be decided");
    }

    Answer inverse_image(const Language& language, const Word& word) {
        const std::optional<Word> mapped = language->morphism.image_of(word);
        if (!mapped) return from(language, word, refuted(steps::HasNoImage{word}));
        Answer found = judge(language->parts[0], *mapped);
        if (found.truth == Truth::undecided)
            found.tried.insert(found.tried.begin(), "The image of " + spell(alphabet_, word) +
                                                        " is " + spell(alphabet_, *mapped) + ".");
        return from(language, word, std::move(found), mapped);
    }

    const Alphabet& alphabet_;
    bool thorough_;
    const Budget& budget_;
    std::map<std::pair<const LanguageTree*, Word>, Truth> known_;
};

}  // namespace

Answer judge_membership(const Language& language, const Word& word, const Alphabet& alphabet,
                        const Budget& budget, bool thorough) {
    const bool with_context = has_context(language);
    Answer found = Members(alphabet, thorough && !with_context, budget).judge(language, word);
    if (!thorough || found.truth != Truth::undecided || !with_context) return found;
    if (auto invariant = by_invariants(language, nullptr, word, alphabet, budget))
        return refuted(*std::move(invariant));
    found = Members(alphabet, true, budget).judge(language, word);
    if (found.truth != Truth::undecided) return found;
    found.tried.push_back(
        "no regular language was found that is closed under the steps of its system and keeps the "
        "word out; membership is "
        "undecidable for systems with context that erase letters (Rozenberg and Salomaa 1980, VI)");
    return found;
}

}  // namespace algae
