#include "verify/finite_step_check.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace algae {

namespace {

[[noreturn]] void fail(std::string text) { throw ProofFlaw{std::move(text)}; }

constexpr std::size_t longest = 2000;  // letters of a word that steps are followed through

Word concatenated(const std::vector<Word>& words) {
    Word whole;
    for (const Word& word : words) whole.insert(whole.end(), word.begin(), word.end());
    return whole;
}

}  // namespace

StepCheck::StepCheck(const FamilyObstruction& proof, const Budget& budget)
    : proof_(proof),
      budget_(budget),
      words_(proof.language.words.begin(), proof.language.words.end()) {
    double bytes = 0;
    for (const Word& word : words_) {
        const auto size = static_cast<double>(word.size() + 1);
        bytes += size * size * (50 + size);  // of the factors, which are the images of each letter
        if (word.size() > longest)
            throw BoundReached(Bound::method, "a proof by cases with words of more than " +
                                                  std::to_string(longest) +
                                                  " letters is not checked");
    }
    bytes *= static_cast<double>(letters_of(proof.language).size() + 1);
    budget.check_memory(static_cast<std::uint64_t>(std::min(bytes, 1e18)),
                        "the factors of the words");
    for (const Word& word : words_)
        for (auto end = word.begin();; ++end) {
            beginnings_.emplace(word.begin(), end);
            if (end == word.end()) break;
        }
}

std::string StepCheck::spelled(const Word& word) const {
    for (const Symbol a : word)
        if (a >= proof_.language.alphabet->size()) return "a word with an unknown symbol";
    return spell(*proof_.language.alphabet, word);
}

std::string StepCheck::spelled(const LetterRule& rule) const {
    return spelled(Word{rule.letter}) + " -> " + spelled(rule.image);
}

void StepCheck::must_be_word(const Word& word) const {
    if (!words_.contains(word)) fail(spelled(word) + " is not a word of the language");
}

StepCheck::Possible StepCheck::factors() const {
    std::set<Word> all;
    if (!proof_.family.propagating) all.insert(Word{});
    for (const Word& word : words_)
        for (auto from = word.begin(); from != word.end(); ++from)
            for (auto to = from + 1;; ++to) {
                all.emplace(from, to);
                if (to == word.end()) break;
            }
    Possible possible;
    for (const Word& word : words_)
        for (const Symbol a : word) possible.emplace(a, all);
    return possible;
}

StepCheck::Rules StepCheck::leaving(const Word& word, const std::vector<Word>& images) const {
    if (proof_.family.deterministic) fail("a letter has one image in a deterministic table");
    must_be_word(word);
    if (word.size() != images.size())
        fail("the step does not say what every letter of the word becomes");
    const Word result = concatenated(images);
    if (words_.contains(result)) fail(spelled(result) + " is a word of the language");
    Rules used;
    for (std::size_t i = 0; i < word.size(); ++i) used.insert({word[i], images[i]});
    return used;
}

void StepCheck::must_not_give(const Word& from, const Word& to, const Possible& possible) const {
    Rules used;
    Places seen;
    follow(from, 0, to, 0, possible, used, seen);
}

void StepCheck::follow(const Word& from, std::size_t position, const Word& to, std::size_t done,
                       const Possible& possible, Rules& used, Places& seen) const {
    budget_.check();
    const bool rules_matter = proof_.family.deterministic || !proof_.impossible.empty();
    if (!rules_matter && !seen.emplace(position, done).second) return;
    for (const ImpossibleTable& table : proof_.impossible)
        if (std::all_of(table.rules.begin(), table.rules.end(),
                        [&](const LetterRule& rule) { return used.contains(rule); }))
            return;
    if (position == from.size()) {
        if (done == to.size()) fail(spelled(from) + " may give " + spelled(to));
        return;
    }
    for (std::size_t end = done; end <= to.size(); ++end) {
        const LetterRule rule{from[position], Word(to.begin() + static_cast<std::ptrdiff_t>(done),
                                                   to.begin() + static_cast<std::ptrdiff_t>(end))};
        if (!possible.at(rule.letter).contains(rule.image)) continue;
        if (proof_.family.deterministic &&
            std::any_of(used.begin(), used.end(), [&](const LetterRule& other) {
                return other.letter == rule.letter && other.image != rule.image;
            }))
            continue;
        const bool is_new = used.insert(rule).second;
        follow(from, position + 1, to, end, possible, used, seen);
        if (is_new) used.erase(rule);
    }
}

bool StepCheck::lands(const Word& word, const LetterRule& rule, const Possible& possible) const {
    std::map<Symbol, Word> chosen{{rule.letter, rule.image}};
    return lands_after(word, 0, {}, possible, chosen);
}

bool StepCheck::lands_after(const Word& word, std::size_t position, const Word& built,
                            const Possible& possible, std::map<Symbol, Word>& chosen) const {
    budget_.check();
    if (!beginnings_.contains(built)) return false;
    if (position == word.size()) return words_.contains(built);
    const Symbol letter = word[position];
    const auto goes_on = [&](const Word& image) {
        return lands_after(word, position + 1, concatenated({built, image}), possible, chosen);
    };
    if (chosen.contains(letter)) return goes_on(chosen.at(letter));
    for (const Word& image : possible.at(letter)) {
        chosen[letter] = image;
        const bool found = goes_on(image);
        chosen.erase(letter);
        if (found) return true;
    }
    return false;
}

}  // namespace algae
