#include "language/detail/judge.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "verify/verify.hpp"
#include "word/word.hpp"

// Whether a word is in a language, by the definition of each operation.
//
// For L(G) of a system without context the decision is complete (membership.cpp, tables_membership.cpp). A
// system with context is derived until its words repeat or, where no rule erases, are longer than the word.
//
// Of a concatenation or star all ways to cut the word are tried, each factor decided once. Of an image all
// words with this image: one by one where they are finitely many, otherwise by automata or by a system that
// constructions make. What a part leaves undecided leaves the whole undecided unless another part decides it.

namespace algae {

namespace {

constexpr std::size_t longest_shown = 240;          // characters of a derivation on one line
constexpr std::uint64_t most_generations = 10'000;  // that a system with context is followed

/// "generation 0 is", "generations 0 to 3 are": those before a number that is not 0.
std::string generations(std::uint64_t end) {
    return end == 1 ? "generation 0 is" : "generations 0 to " + std::to_string(end - 1) + " are";
}

/// Why no generation has the word, as a sentence without its full stop.
std::string reason(const Membership& found, const std::string& name, const Word& word,
                   const Alphabet& alphabet) {
    const std::string text = spell(alphabet, word);
    using enum Membership::Reason;
    switch (found.reason) {
        case foreign:
            return text + " is not in L(" + name + "): the letter " +
                   alphabet.name(word[found.position]) + " is in none of its words";
        case nonterminal:
            return text + " is not in L(" + name + "): " + alphabet.name(word[found.position]) +
                   " is no terminal";
        case outgrown:
            return text + " is not in L(" + name + "): " +
                   (found.step == 0 ? "all its words are longer"
                                    : generations(found.step) +
                                          " not this word, and from then on all words are longer");
        case periodic:
            return text + " is not in L(" + name + "): generation " + std::to_string(found.step) +
                   " is generation " + std::to_string(found.earlier) +
                   " again, and none before is this word";
        case exhausted:
            return text + " is not in L(" + name + "): what the letters derive within it by any " +
                   counted(found.step, "table") + " they derive by fewer, and none of the " +
                   std::to_string(found.states) + " families of factors has it";
        default:
            return text + " is not in L(" + name +
                   "): the factors of it that the letters derive in " +
                   counted(found.step, "step") + " are those that they derive in " +
                   std::to_string(found.earlier) + ", and no generation before has it";
    }
}

Judgement judge_tables(const SourceSystem& system, const Word& word, const Alphabet& alphabet,
                       const Budget& budget) {
    const Membership found = membership(*system.tables, word, budget);
    if (!found.member)
        return Judgement::refuted({reason(found, system.name, word, alphabet) + "."},
                                  {{"by", "membership"}});
    const Derivation witness = derivation(*system.tables, word, found, budget);
    const std::string steps =
        found.step == 0 ? ": it is the axiom." : ": " + arrows(witness, alphabet) + ".";
    return Judgement::proved(
        {spell(alphabet, word) + " is in L(" + system.name + ")" + steps},
        {{"by", "membership"}, {"derivation", derivation_json(witness, alphabet)}});
}

/// Follows the generations. Where no rule has the empty successor, no generation is shorter than the
/// one before, so the first that is longer than the word ends the search: without this the words of
/// a growing system are followed to the bound, for each of the hundreds of short words in which two
/// languages may differ.
Judgement judge_interactive(const SourceSystem& system, const Word& word, const Alphabet& alphabet,
                            const Budget& budget) {
    const std::string text = spell(alphabet, word), in = " L(" + system.name + ")";
    Derivation walk{{system.interactive->axiom}, {}};
    const bool propagating = has_form(system, *system_form("PIL"));
    std::map<Word, std::uint64_t> seen;
    for (std::uint64_t n = 0; n < most_generations; ++n) {
        budget.check();
        const Word& current = walk.words.back();
        if (current == word)
            return Judgement::proved(
                {text + " is in" + in +
                 (n == 0 ? ": it is the axiom." : ": " + arrows(walk, alphabet) + ".")},
                {{"by", "membership"}, {"derivation", derivation_json(walk, alphabet)}});
        if (propagating && current.size() > word.size())
            return Judgement::refuted(
                {reason({false, Membership::Reason::outgrown, n}, system.name, word, alphabet) +
                 "."},
                {{"by", "membership"}});
        if (const auto before = seen.find(current); before != seen.end())
            return Judgement::refuted(
                {text + " is not in" + in + ": generation " + std::to_string(n) +
                 " is generation " + std::to_string(before->second) +
                 " again, and none before is this word."},
                {{"by", "membership"}});
        seen.emplace(current, n);
        if (seen.size() * (current.size() + 1) > budget.letters / 100) break;
        walk.words.push_back(next_word(*system.interactive, current));
    }
    return Judgement::undecided({"the first " + std::to_string(walk.words.size()) + " words of" +
                                 in + " are not " + text + ", and they do not repeat"});
}

}  // namespace

std::string arrows(const Derivation& derivation, const Alphabet& alphabet) {
    std::string text;
    for (const Word& word : derivation.words) {
        if (text.size() > longest_shown)
            return counted(derivation.words.size() - 1, "step") + " of derivation, beginning " +
                   text + " => ...";
        text +=
            (text.empty() ? "" : " => ") +
            (word.size() > longest_shown ? counted(word.size(), "letter") : spell(alphabet, word));
    }
    return text;
}

nlohmann::ordered_json derivation_json(const Derivation& derivation, const Alphabet& alphabet) {
    nlohmann::ordered_json words = nlohmann::ordered_json::array();
    for (const Word& word : derivation.words) words.push_back(certificate_text(alphabet, word));
    nlohmann::ordered_json result{{"words", words}};
    if (!derivation.tables.empty()) result["tables"] = derivation.tables;
    return result;
}

Judgement judge_generated(const SourceSystem& system, const Word& word, const Alphabet& alphabet,
                          const Budget& budget) {
    return system.tables ? judge_tables(system, word, alphabet, budget)
                         : judge_interactive(system, word, alphabet, budget);
}

namespace {

using Kind = LanguageTree::Kind;

constexpr std::size_t most_preimages = 10'000;

nlohmann::ordered_json decided() { return {{"by", "membership"}}; }

class Members {
public:
    Members(const Alphabet& alphabet, const Budget& budget)
        : alphabet_(alphabet), budget_(budget) {}

    Judgement judge(const Language& language, const Word& word) {
        budget_.check();
        const LanguageTree& tree = *language;
        switch (tree.kind) {
            case Kind::words:
                return listed(language, word);
            case Kind::generated:
                return judge_generated(*tree.system, word, alphabet_, budget_);
            case Kind::united:
                return concluded(language, word, either(judge(tree.parts[0], word), [&] {
                                     return judge(tree.parts[1], word);
                                 }));
            case Kind::intersected:
                return concluded(language, word,
                                 opposite(either(opposite(judge(tree.parts[0], word)), [&] {
                                     return opposite(judge(tree.parts[1], word));
                                 })));
            case Kind::difference:
                return concluded(language, word,
                                 opposite(either(opposite(judge(tree.parts[0], word)),
                                                 [&] { return judge(tree.parts[1], word); })));
            case Kind::complement:
                return concluded(language, word, complement(tree, word));
            case Kind::reversed:
                return concluded(language, word, reversed(tree, word));
            case Kind::concatenated:
                return concatenation(language, word);
            case Kind::star:
            case Kind::plus:
                return iteration(language, word);
            case Kind::image:
                return image(language, word);
            case Kind::inverse_image:
                return concluded(language, word, inverse_image(tree, word));
        }
        return Judgement::undecided({});
    }

private:
    std::string is_in(const Language& language, const Word& word, bool yes) const {
        return spell(alphabet_, word) + (yes ? " is in " : " is not in ") +
               to_string(language, alphabet_);
    }

    Judgement answer(const Language& language, const Word& word, bool yes,
                     const std::string& because) const {
        std::vector<std::string> argument{is_in(language, word, yes) +
                                          (because.empty() ? "." : ": " + because + ".")};
        return yes ? Judgement::proved(std::move(argument), decided())
                   : Judgement::refuted(std::move(argument), decided());
    }

    /// The judgement with what it comes to as its last sentence, where that is not plain from the others.
    Judgement concluded(const Language& language, const Word& word, Judgement found) const {
        const bool is_plain = language->kind == Kind::united ||
                              language->kind == Kind::intersected ||
                              language->kind == Kind::difference;
        if (found.truth != Truth::undecided && !(is_plain && language->name.empty()))
            found.argument.push_back("So " + is_in(language, word, found.truth == Truth::proved) +
                                     ".");
        return found;
    }

    Judgement listed(const Language& language, const Word& word) const {
        const auto& words = language->words;
        return answer(language, word, std::find(words.begin(), words.end(), word) != words.end(),
                      "");
    }

    /// Of a union: the first that is proved; both refuted; otherwise undecided.
    template <class Other>
    static Judgement either(Judgement first, Other other) {
        if (first.truth == Truth::proved) return without_derivation(std::move(first));
        Judgement second = other();
        if (second.truth == Truth::proved) return without_derivation(std::move(second));
        if (first.truth == Truth::undecided) return first;
        if (second.truth == Truth::undecided) return second;
        first.argument.insert(first.argument.end(), second.argument.begin(), second.argument.end());
        return without_derivation(std::move(first));
    }

    /// A derivation proves that a word is in L(G) itself, not in what is made of it.
    static Judgement without_derivation(Judgement judgement) {
        if (judgement.truth != Truth::undecided)
            judgement.proof = std::make_shared<const nlohmann::ordered_json>(decided());
        return judgement;
    }

    /// A derivation shows what is written backwards too, a word with this image does not.
    Judgement reversed(const LanguageTree& tree, const Word& word) {
        Judgement found = judge(tree.parts[0], Word(word.rbegin(), word.rend()));
        return found.proof && found.proof->contains("preimage")
                   ? without_derivation(std::move(found))
                   : found;
    }

    Judgement complement(const LanguageTree& tree, const Word& word) {
        for (const Symbol a : word)
            if (!std::binary_search(tree.letters.begin(), tree.letters.end(), a))
                return Judgement::refuted(
                    {"The complement is over other letters than " + alphabet_.name(a) + "."},
                    decided());
        return without_derivation(opposite(judge(tree.parts[0], word)));
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

    std::string cut(const Word& word, const std::vector<std::size_t>& ends) const {
        std::string text;
        std::size_t from = 0;
        for (const std::size_t to : ends) {
            const Word part(word.begin() + static_cast<std::ptrdiff_t>(from),
                            word.begin() + static_cast<std::ptrdiff_t>(to));
            text += (text.empty() ? "" : " . ") + spell(alphabet_, part);
            from = to;
        }
        return text;
    }

    Judgement concatenation(const Language& language, const Word& word) {
        bool unknown = false;
        for (std::size_t at = 0; at <= word.size(); ++at) {
            const Truth left = factor(language->parts[0], word, 0, at);
            if (left == Truth::refuted) continue;
            const Truth right = factor(language->parts[1], word, at, word.size());
            if (left == Truth::proved && right == Truth::proved)
                return answer(language, word, true, "it is " + cut(word, {at, word.size()}));
            unknown = unknown || right != Truth::refuted;
        }
        if (unknown)
            return Judgement::undecided(
                {"some factors of " + spell(alphabet_, word) + " could not be decided"});
        return answer(language, word, false,
                      "no way to cut it in two has the parts in the two languages");
    }

    Judgement iteration(const Language& language, const Word& word) {
        const Language& base = language->parts[0];
        if (word.empty()) {
            if (language->kind == Kind::star) return answer(language, word, true, "");
            return concluded(language, word, without_derivation(judge(base, word)));
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
            return answer(language, word, true, "it is " + cut(word, ends));
        }
        if (unknown)
            return Judgement::undecided(
                {"some factors of " + spell(alphabet_, word) + " could not be decided"});
        return answer(language, word, false,
                      "it cannot be cut into words of " + to_string(base, alphabet_));
    }

    Judgement image(const Language& language, const Word& word) {
        const LanguageTree& tree = *language;
        const Language& part = tree.parts[0];
        const RegularLanguage sources = algae::inverse_image(
            finite_set({word}), tree.morphism.images(), tree.morphism.domain());
        const auto count = number_of_words(sources);
        if (count && *count <= Integer(most_preimages)) {
            bool unknown = false;
            for (const Word& source : words_up_to(sources, sources.automaton().states(), budget_)) {
                const Truth truth = judge(part, source).truth;
                if (truth == Truth::proved) return found_preimage(language, word, source);
                unknown = unknown || truth == Truth::undecided;
            }
            if (!unknown)
                return answer(language, word, false,
                              "no word of " + to_string(part, alphabet_) + " has this image");
        } else if (const auto regular = regular_value(part, alphabet_, budget_)) {
            const auto source = shortest_word(intersected(*regular, sources, budget_));
            if (source) return found_preimage(language, word, *source);
            return answer(language, word, false,
                          "no word of " + to_string(part, alphabet_) + " has this image");
        } else if (const auto tables = table_value(part, alphabet_, budget_)) {
            const Meeting meeting = first_meeting(tables->system, sources, budget_);
            if (meeting.derivation)
                return found_preimage(language, word, meeting.derivation->words.back());
            return answer(language, word, false,
                          "no word of " + to_string(part, alphabet_) + " has this image");
        }
        return Judgement::undecided(
            {"the words with the image " + spell(alphabet_, word) + " could not all be decided"});
    }

    Judgement found_preimage(const Language& language, const Word& word, const Word& source) const {
        return Judgement::proved(
            {is_in(language, word, true) + ": it is the image of " + spell(alphabet_, source) +
             "."},
            {{"by", "membership"}, {"preimage", certificate_text(alphabet_, source)}});
    }

    Judgement inverse_image(const LanguageTree& tree, const Word& word) {
        const std::optional<Word> mapped = tree.morphism.image_of(word);
        if (!mapped)
            return Judgement::refuted({"A letter of " + spell(alphabet_, word) + " has no image."},
                                      decided());
        Judgement found = without_derivation(judge(tree.parts[0], *mapped));
        found.argument.insert(found.argument.begin(), "The image of " + spell(alphabet_, word) +
                                                          " is " + spell(alphabet_, *mapped) + ".");
        return found;
    }

    const Alphabet& alphabet_;
    const Budget& budget_;
    std::map<std::pair<const LanguageTree*, Word>, Truth> known_;
};

}  // namespace

Judgement judge_membership(const Language& language, const Word& word, const Alphabet& alphabet,
                           const Budget& budget) {
    return Members(alphabet, budget).judge(language, word);
}

}  // namespace algae
