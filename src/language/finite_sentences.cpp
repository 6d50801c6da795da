#include "language/finite_sentences.hpp"

#include <algorithm>
#include <optional>

namespace algae {

namespace {

constexpr std::size_t shown = 4;  // how many words a sentence lists at most

/// What a word becomes where a letter becomes its image and the other letters what `other` says;
/// nothing where a letter may become several things.
std::optional<Word> only_result(const ExcludedRule& excluded, const RulesLeft& left) {
    Word result;
    for (const Symbol a : excluded.word) {
        const Word* image = &excluded.rule.image;
        if (a != excluded.rule.letter) {
            if (left.at(a).size() != 1) return std::nullopt;
            image = &*left.at(a).begin();
        }
        result.insert(result.end(), image->begin(), image->end());
    }
    return result;
}

/// Whether the word is of the form: the image at each place of the letter, anything elsewhere.
bool matches(const ExcludedRule& excluded, const Word& word) {
    std::vector<char> reached(word.size() + 1, 0);
    reached[0] = 1;
    const Word& image = excluded.rule.image;
    for (const Symbol a : excluded.word) {
        std::vector<char> next(word.size() + 1, 0);
        bool before = false;
        for (std::size_t i = 0; i <= word.size(); ++i) {
            before = before || reached[i];
            if (a != excluded.rule.letter) {
                next[i] = before;
            } else if (reached[i] && i + image.size() <= word.size() &&
                       std::equal(image.begin(), image.end(),
                                  word.begin() + static_cast<std::ptrdiff_t>(i))) {
                next[i + image.size()] = 1;
            }
        }
        reached = std::move(next);
    }
    return reached.back();
}

}  // namespace

std::string FiniteSentences::listed(const std::vector<std::string>& items,
                                    const std::string& last) {
    std::string text;
    for (std::size_t i = 0; i < items.size(); ++i)
        text += (i == 0 ? "" : i + 1 == items.size() ? last : ", ") + items[i];
    return text;
}

std::string FiniteSentences::rule(const LetterRule& rule) const {
    return word({rule.letter}) + " -> " + word(rule.image);
}

std::string FiniteSentences::rules(const std::vector<LetterRule>& rules) const {
    std::vector<std::string> texts;
    const Symbol* letter = nullptr;
    for (const LetterRule& each : rules) {
        if (letter && *letter == each.letter)
            texts.back() += " | " + word(each.image);
        else
            texts.push_back(rule(each));
        letter = &each.letter;
    }
    return listed(texts);
}

std::string FiniteSentences::left(const RulesLeft& rules_left) const {
    std::vector<LetterRule> all;
    for (const auto& [letter, images] : rules_left)
        for (const Word& image :
             make_finite_language(language_.alphabet, {images.begin(), images.end()}).words)
            all.push_back({letter, image});
    return rules(all);
}

/// "aa…b": the word with the letter replaced and dots for what the other letters become.
std::string FiniteSentences::form(const ExcludedRule& excluded) const {
    std::string text;
    for (const Symbol a : excluded.word) {
        if (a == excluded.rule.letter)
            text += excluded.rule.image.empty() ? "" : word(excluded.rule.image);
        else if (!text.ends_with("…"))
            text += "…";
    }
    return text;
}

bool FiniteSentences::has_form(const ExcludedRule& excluded) const {
    return std::any_of(language_.words.begin(), language_.words.end(),
                       [&](const Word& each) { return matches(excluded, each); });
}

std::string FiniteSentences::departure(const Word& from, const std::vector<Word>& images) const {
    std::set<LetterRule> used;
    Word result;
    for (std::size_t i = 0; i < from.size(); ++i) {
        used.insert({from[i], images[i]});
        result.insert(result.end(), images[i].begin(), images[i].end());
    }
    return "by " + rules({used.begin(), used.end()}) + ", " + word(from) + " gives " +
           word(result) + ", which is not in the language";
}

std::string FiniteSentences::impossible(std::span<const ExcludedRule> same,
                                        const RulesLeft& rules_left) const {
    const ExcludedRule& first = same.front();
    std::vector<LetterRule> all;
    for (const ExcludedRule& each : same) all.push_back(each.rule);
    std::string text = rules(all) + (same.size() == 1 ? " is" : " are") + " impossible: ";
    if (!first.images.empty()) return text + departure(first.word, first.images) + ".";
    const std::string from = word(first.word);

    std::vector<std::string> results, forms;
    bool fits = false;  // whether some word of the language has one of the forms
    std::set<Symbol> others(first.word.begin(), first.word.end());
    others.erase(first.rule.letter);
    for (const ExcludedRule& each : same) {
        if (const auto result = only_result(each, rules_left)) results.push_back(word(*result));
        forms.push_back(form(each));
        fits = fits || has_form(each);
    }
    std::vector<std::string> names;
    for (const Symbol a : others) names.push_back(word({a}));
    const bool one = same.size() == 1;
    if (results.size() == same.size()) {
        RulesLeft only;
        for (const Symbol a : others) only[a] = rules_left.at(a);
        std::string start = text;
        if (!only.empty()) start += "with " + left(only) + ", all that is left for " + listed(names) + ", ";
        start += from;
        if (same.size() > shown) return start + " would give no word of the language.";
        return start + " would give " + listed(results, " or ") + ", which " +
               (one ? "is" : "are") + " not in the language.";
    }
    if (fits)
        return text + "whichever of the rules left for " + listed(names) + " goes with " +
               (one ? "it" : "them") + ", " + from + " would give no word of the language.";
    if (same.size() > shown)
        return text + "whatever " + listed(names) + " becomes, " + from +
               " would give no word of the language.";
    return text + from + " would give " + listed(forms, " or ") +
           ", and no word of the language has " + (one ? "this form." : "one of these forms.");
}

std::string FiniteSentences::never_reached(const std::vector<std::vector<Word>>& sets) const {
    if (sets.empty()) return "The axiom would be a word of the language, but there is none.";
    const auto closed = [&](const std::vector<Word>& set) {
        if (set.size() == 1) return "no other word gives " + word(set.front());
        const std::string name = to_string(make_finite_language(language_.alphabet, set));
        return "no word outside " + name + " gives a word of it";
    };
    if (sets.size() == 1)
        return "No other word gives ε, and the axiom is not empty, so ε is never reached.";
    const bool single = sets[0].size() == 1 && sets[1].size() == 1;
    return "By what is left, " + closed(sets[0]) + ", and " + closed(sets[1]) + ". The axiom is " +
           (single ? "not both, so one of these words is never reached."
                   : "not in both, so the words of one are never reached.");
}

}  // namespace algae
