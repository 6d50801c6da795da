// Systems made from the bytes: their texts are read back, and what the library says of them is what the slow routes say.

#include <algorithm>
#include <iterator>
#include <set>

#include "exact/exact.hpp"
#include "fuzz/targets.hpp"
#include "growth/growth.hpp"
#include "language/language.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "notation/random_text.hpp"
#include "oracle/interaction.hpp"
#include "oracle/written_system.hpp"
#include "system/system.hpp"

namespace algae::fuzz {

namespace {

using oracle::WrittenSystem;

std::string text_of(const WrittenSystem& system) {
    std::string text = "axiom " + system.axiom;
    for (const auto& [letter, words] : system.successors)
        for (const std::string& word : words) text += std::string("; ") + letter + " -> " + word;
    return text;
}

/// Up to four letters with one successor each.
WrittenSystem any_d0l(Bytes& choices) {
    WrittenSystem system;
    system.axiom = choices.word("abcd", 3, 1);
    for (const char letter : {'a', 'b', 'c'}) system.successors[letter] = {choices.word("abcd", 3)};
    return system;
}

/// Over a, b and the constant c, with up to three successors.
WrittenSystem any_0l(Bytes& choices, bool erasing) {
    WrittenSystem system;
    system.axiom = choices.word("abc", 2, 1);
    for (const char letter : {'a', 'b'})
        for (std::size_t i = choices.below(3) + 1; i > 0; --i)
            system.successors[letter].push_back(choices.word("abc", 2, erasing ? 0 : 1));
    return system;
}

Word word_of(const OL& system, const std::string& text) {
    Word word;
    for (const char letter : text)
        word.push_back(system.alphabet->find(std::string(1, letter))
                           .value_or(static_cast<Symbol>(system.alphabet->size())));
    return word;
}

void take_system(std::string_view bytes) {
    Bytes choices(bytes);
    random_text::choose = [&](int bound) {
        return static_cast<int>(choices.below(static_cast<std::size_t>(bound)));
    };
    const std::string text = random_text::system();
    const Model system = read_lsystem(text, "x.lsys");
    const std::string printed = print_lsystem(system);
    try {
        const Model again = read_lsystem(printed, "y.lsys");
        expect(again == system, "it reads back as another system:\n" + printed);
        expect(print_lsystem(again) == printed, "it is printed in another way:\n" + printed);
    } catch (const Error& error) {
        throw Broken("it is not read back: " + std::string(error.what()) + "\n" + printed);
    }
}

void take_membership(std::string_view bytes) {
    Bytes choices(bytes);
    const bool erasing = choices.below(2) == 1;
    const WrittenSystem written = any_0l(choices, erasing);
    const OL system = oracle::ol_of(written);
    constexpr std::size_t longest = 3;
    const auto reached = oracle::words_up_to(written, longest, longest + (erasing ? 1 : 0));
    const Budget budget = small_budget();
    for (int i = 0; i < 3; ++i) {
        const std::string text = choices.word("abc", longest);
        const Word word = word_of(system, text);
        const Membership found = membership(system, word, budget);
        const auto fail = [&](const char* what) {
            throw Broken(std::string(what) + ": \"" + text + "\" in " + text_of(written));
        };
        if (reached.contains(text) && !found.member) fail("a derived word is no member");
        if (!erasing && found.member && !reached.contains(text))
            fail("no word is derived like that");
        if (!found.member) continue;
        const Derivation steps = derivation(system, word, found.step, budget);
        if (!is_derivation(system, steps) || steps.words.back() != word) fail("no derivation");
    }
}

/// What trying every choice shows, in so few steps that it may show nothing.
struct Tried {
    enum class Kind { finite, infinite, unknown } kind = Kind::unknown;
    std::size_t words = 0;  // of a finite language
};

/// All words that one step makes; nothing if they are many.
std::optional<std::set<std::string>> next_words(const WrittenSystem& system,
                                                const std::string& word) {
    std::set<std::string> found{""};
    for (const char letter : word) {
        const auto rule = system.successors.find(letter);
        std::set<std::string> longer;
        for (const std::string& begun : found) {
            if (rule == system.successors.end()) longer.insert(begun + letter);
            if (rule != system.successors.end())
                for (const std::string& successor : rule->second) longer.insert(begun + successor);
        }
        found = std::move(longer);
        if (found.size() > 200) return std::nullopt;
    }
    return found;
}

/// A finite language has no word of more than `longest` letters. Long words come first, so that they grow soon.
Tried tried(const WrittenSystem& system, std::size_t longest) {
    const auto is_shorter = [](const std::string& left, const std::string& right) {
        return left.size() != right.size() ? left.size() < right.size() : left < right;
    };
    std::set<std::string> seen{system.axiom};
    std::set<std::string, decltype(is_shorter)> waiting(is_shorter);
    waiting.insert(system.axiom);
    while (!waiting.empty()) {
        const std::string word = *std::prev(waiting.end());
        waiting.erase(word);
        const auto next = next_words(system, word);
        if (!next || seen.size() > 300) return {};
        for (const std::string& each : *next) {
            if (each.size() > longest) return {Tried::Kind::infinite};
            if (seen.insert(each).second) waiting.insert(each);
        }
    }
    return {Tried::Kind::finite, seen.size()};
}

void take_finiteness(std::string_view bytes) {
    Bytes choices(bytes);
    const WrittenSystem written = any_0l(choices, choices.below(2) == 1);
    const OL system = oracle::ol_of(written);
    const Finiteness found = finiteness(system);
    // Three letters, two in the axiom: no finite language has a word of more than 2 * 2^3 letters.
    const Tried language = tried(written, 16);
    expect(found.finite != found.round.has_value(), "a proof of " + text_of(written));
    if (language.kind == Tried::Kind::unknown) return;
    expect(found.finite == (language.kind == Tried::Kind::finite),
           "finiteness of " + text_of(written));
    if (found.finite)
        expect(number_of_words(system, small_budget()) == Integer(language.words),
               "number of words of " + text_of(written));
}

void take_derivation(std::string_view bytes) {
    Bytes choices(bytes);
    const WrittenSystem written = any_d0l(choices);
    const D0L system = oracle::d0l_of(written);
    const unsigned n =
        oracle::last_generation_within(written, 400, static_cast<unsigned>(choices.below(9)));
    const std::string word = oracle::rewritten(written, n);
    const std::string of = " of generation " + std::to_string(n) + " of " + text_of(written);
    const Budget budget = small_budget();
    expect(derived_text(system, n, budget) == word, "the text" + of);
    expect(oracle::text_of(*system.alphabet, derive(system, n, budget)) == word, "the word" + of);
    expect(length(system, n, budget) == Integer(word.size()), "the length" + of);
    if (word.empty()) return;
    const std::size_t at = choices.below(word.size()), count = choices.below(6);
    expect(oracle::text_of(*system.alphabet, letters_at(system, n, Integer(at), count, budget)) ==
               word.substr(at, count),
           "letters from " + std::to_string(at) + of);
}

void take_growth(std::string_view bytes) {
    Bytes choices(bytes);
    const WrittenSystem written = any_d0l(choices);
    const D0L system = oracle::d0l_of(written);
    const Budget budget = small_budget();
    const Recurrence recurrence = shortest_recurrence(system, budget);
    const auto found = lengths(system, 14, budget);
    const ClosedForm form = closed_form(system, budget);
    WrittenSystem now = written;
    for (std::size_t n = 0; n < found.size() && now.axiom.size() < 500; ++n) {
        const std::string of = " in generation " + std::to_string(n) + " of " + text_of(written);
        expect(found[n] == Integer(now.axiom.size()), "the length" + of);
        if (n < form.exceptions().size())
            expect(form.exceptions()[n] == found[n], "the exception" + of);
        else
            expect(form.value(n, 80).contains(Rational(found[n])), "the closed form" + of);
        now.axiom = oracle::rewritten(now, 1);
    }
}

void take_equality(std::string_view bytes) {
    Bytes choices(bytes);
    const WrittenSystem left = any_d0l(choices);
    WrittenSystem right = left;
    for (std::size_t i = choices.below(3); i > 0; --i)
        right.successors["abc"[choices.below(3)]] = {choices.word("abcd", 3)};
    if (choices.below(2) == 1) right.axiom = choices.word("abcd", 3, 1);
    const std::string of = text_of(left) + " and " + text_of(right);
    const SequencePair pair = over_common_alphabet(oracle::d0l_of(left), oracle::d0l_of(right));
    const Budget budget = small_budget();
    const SequenceEquality sequences = equal_sequences(pair.left, pair.right, budget);
    std::set<std::string> words[2];
    std::vector<std::string> inner[2];
    for (int side = 0; side < 2; ++side) {
        WrittenSystem now = side == 0 ? left : right;
        for (int n = 0; n < 12 && now.axiom.size() < 300; ++n) {
            words[side].insert(now.axiom);
            inner[side].push_back(now.axiom);
            now.axiom = oracle::rewritten(now, 1);
        }
    }
    const std::size_t both = std::min(inner[0].size(), inner[1].size());
    std::size_t first = 0;
    while (first < both && inner[0][first] == inner[1][first]) ++first;
    if (sequences.equal)
        expect(first == both, "sequences that differ are called equal: " + of);
    else if (first < both || sequences.difference->generation < both)
        expect(sequences.difference->generation == first, "another first difference: " + of);
    const LanguageEquality languages = equal_languages(pair.left, pair.right, budget);
    if (sequences.equal) expect(languages.equal, "equal sequences, but not languages: " + of);
    if (!languages.equal) return;
    for (int side = 0; side < 2; ++side) {
        const OL other = oracle::ol_of(side == 0 ? right : left);
        for (const std::string& word : words[side])
            if (word.size() < 20 && !words[1 - side].contains(word))
                expect(membership(other, word_of(other, word), budget).member,
                       "languages that differ are called equal: " + word + " of " + of);
    }
}

void take_interaction(std::string_view bytes) {
    Bytes choices(bytes);
    oracle::WrittenInteraction written;
    written.axiom = choices.word("abc+", 6, 1);
    std::string text = "axiom " + written.axiom;
    for (std::size_t i = choices.below(5); i > 0; --i) {
        oracle::WrittenInteraction::Rule rule{choices.word("abc", 2), "abc"[choices.below(3)],
                                              choices.word("abc", 2), choices.word("abc+", 2)};
        text += "; " + (rule.left.empty() ? "" : rule.left + " < ") + rule.letter +
                (rule.right.empty() ? "" : " > " + rule.right) + " -> " +
                (rule.successor.empty() ? "ε" : rule.successor);
        written.rules.push_back(std::move(rule));
    }
    if (choices.below(2) == 1) {
        written.ignored = "+";
        text += "; ignore +";
    }
    const Model model = read_lsystem(text, "x.lsys");
    if (!class_of(model).deterministic) return;
    const IL system = *as_il(model);
    for (std::uint64_t n = 0; n < 5 && written.axiom.size() < 60; ++n) {
        expect(
            oracle::text_of(*system.alphabet, derive(system, n, small_budget())) == written.axiom,
            "generation " + std::to_string(n) + " of " + text);
        written.axiom = oracle::after(written, written.axiom);
    }
}

}  // namespace

std::vector<Target> comparisons() {
    const auto bytes = random_bytes(60, 40);
    return {
        {"system", "systems with every construct, printed and read again", take_system,
         random_bytes(60, 400), 600},
        {"membership", "membership of short words in 0L systems, by trying all", take_membership,
         bytes, 48},
        {"finiteness", "finiteness of 0L systems and the number of words, likewise",
         take_finiteness, bytes, 48},
        {"derivation", "words, lengths and letters of D0L systems, by rewriting", take_derivation,
         bytes, 48},
        {"growth", "recurrences and closed forms of lengths, by rewriting", take_growth, bytes, 48},
        {"equality", "equality of D0L sequences and languages, by rewriting", take_equality, bytes,
         48},
        {"interaction", "words of systems with context, by trying every match", take_interaction,
         bytes, 64},
    };
}

}  // namespace algae::fuzz
