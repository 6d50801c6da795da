#include "oracle/written_system.hpp"

#include <algorithm>
#include <cctype>
#include <ostream>

namespace algae::oracle {

namespace {

std::vector<std::string> choices(const WrittenSystem& system, char letter) {
    const auto found = system.successors.find(letter);
    if (found == system.successors.end() || found->second.empty()) return {std::string(1, letter)};
    return found->second;
}

std::string one_step(const WrittenSystem& system, const std::string& word) {
    std::string next;
    for (const char letter : word) next += choices(system, letter).front();
    return next;
}

/// All words that one step may make of `word`, none longer than `longest`.
std::set<std::string> all_steps(const WrittenSystem& system, const std::string& word,
                                std::size_t longest) {
    std::set<std::string> found{""};
    for (const char letter : word) {
        std::set<std::string> longer;
        for (const std::string& begun : found)
            for (const std::string& successor : choices(system, letter))
                if (begun.size() + successor.size() <= longest) longer.insert(begun + successor);
        found = std::move(longer);
    }
    return found;
}

}  // namespace

bool WrittenSystem::is_deterministic() const {
    for (const auto& [letter, words] : successors)
        if (words.size() > 1) return false;
    return true;
}

std::set<char> WrittenSystem::letters() const {
    std::set<char> all(axiom.begin(), axiom.end());
    for (const auto& [letter, words] : successors) {
        all.insert(letter);
        for (const std::string& word : words) all.insert(word.begin(), word.end());
    }
    return all;
}

std::ostream& operator<<(std::ostream& out, const WrittenSystem& system) {
    out << "axiom " << system.axiom;
    for (const auto& [letter, words] : system.successors)
        for (const std::string& word : words) out << "; " << letter << " -> " << word;
    return out;
}

std::string rewritten(const WrittenSystem& system, unsigned n) {
    std::string word = system.axiom;
    while (n-- > 0) word = one_step(system, word);
    return word;
}

unsigned last_generation_within(const WrittenSystem& system, std::size_t letters, unsigned most) {
    std::string word = system.axiom;
    for (unsigned n = 0; n < most; ++n) {
        word = one_step(system, word);
        if (word.size() > letters) return n;
    }
    return most;
}

std::set<std::string> words_of_generation(const WrittenSystem& system, unsigned n) {
    std::set<std::string> words{system.axiom};
    while (n-- > 0) {
        std::set<std::string> next;
        for (const std::string& word : words)
            next.merge(all_steps(system, word, std::string::npos));
        words = std::move(next);
    }
    return words;
}

std::set<std::string> words_up_to(const WrittenSystem& system, std::size_t longest,
                                  std::size_t on_the_way) {
    std::set<std::string> seen{system.axiom};
    std::vector<std::string> waiting{system.axiom};
    while (!waiting.empty()) {
        const std::string word = waiting.back();
        waiting.pop_back();
        for (const std::string& next : all_steps(system, word, on_the_way))
            if (seen.insert(next).second) waiting.push_back(next);
    }
    std::erase_if(seen, [&](const std::string& word) { return word.size() > longest; });
    return seen;
}

LSystem lsystem_of(const WrittenSystem& written) {
    LSystem system;
    system.name = "written";
    const auto word = [&](const std::string& text) {
        Word letters;
        for (const char letter : text)
            letters.push_back(system.alphabet.symbol(std::string(1, letter)));
        return letters;
    };
    system.axiom.letters = word(written.axiom);
    for (const auto& [letter, words] : written.successors)
        for (const std::string& successor : words) {
            Production rule;
            rule.predecessor.symbol = word(std::string(1, letter)).front();
            rule.successor.letters = word(successor);
            system.rules.push_back(std::move(rule));
        }
    return system;
}

D0L d0l_of(const WrittenSystem& system) { return *as_d0l(lsystem_of(system)); }

OL ol_of(const WrittenSystem& system) { return *as_ol(lsystem_of(system)); }

std::string text_of(const Alphabet& alphabet, const Word& word) {
    std::string text;
    for (const Symbol letter : word) text += alphabet.name(letter);
    return text;
}

Word rewritten(Word word, const std::vector<Word>& images, unsigned n) {
    while (n-- > 0) {
        Word next;
        for (const Symbol letter : word)
            for (const Symbol other : images.at(letter)) next.push_back(other);
        word = std::move(next);
    }
    return word;
}

std::vector<std::string> names_in(const std::string& text, const std::set<std::string>& declared) {
    const auto bytes_at = [&](std::size_t i) -> std::size_t {
        std::size_t end = i + 1;
        while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) ++end;
        return end - i;
    };
    const auto is_digit_at = [&](std::size_t i) {
        return i < text.size() && std::isdigit(static_cast<unsigned char>(text[i])) != 0;
    };
    const auto is_letter_at = [&](std::size_t i) {
        return i < text.size() &&
               (std::isalpha(static_cast<unsigned char>(text[i])) != 0 || text[i] < 0);
    };
    std::vector<std::string> names;
    for (std::size_t i = 0; i < text.size();) {
        if (text[i] == ' ') {
            ++i;
            continue;
        }
        std::size_t end = i + bytes_at(i);
        if (is_letter_at(i) && end < text.size() && text[end] == '_') {
            if (is_letter_at(end + 1)) {
                end += 1 + bytes_at(end + 1);
            } else if (is_digit_at(end + 1)) {
                ++end;
                while (is_digit_at(end)) ++end;
            }
        }
        for (const std::string& name : declared)
            if (text.compare(i, name.size(), name) == 0) end = std::max(end, i + name.size());
        names.push_back(text.substr(i, end - i));
        i = end;
    }
    return names;
}

}  // namespace algae::oracle
