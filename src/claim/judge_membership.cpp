#include "claim/judge_membership.hpp"

#include <map>
#include <nlohmann/json.hpp>

#include "claim/certificate.hpp"
#include "claim/judge_generated.hpp"
#include "claim/known_value.hpp"
#include "claim/table_value.hpp"
#include "language/regular_images.hpp"
#include "language/regular_meeting.hpp"
#include "language/regular_words.hpp"
#include "verify/obstruction_json.hpp"
#include "word/spelling.hpp"

namespace algae {

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
            finite_set({word}), images_by_symbol(tree.morphism), domain_of(tree.morphism));
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
        const std::optional<Word> mapped = image_of(word, tree.morphism);
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
