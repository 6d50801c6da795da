// Times steps of systems with interactions in one process: algae's, and a plain program that looks
// for the rule of each letter. The two take turns; prints the median rates, in letters times steps a
// second of processor time, and their ratio.
//
//     interaction [ROUNDS]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "notation/notation.hpp"
#include "system/system.hpp"

namespace {

using namespace algae;

/// Rule by rule, letter by letter, for words without trees and ignored letters.
Word plain_step(const IL& system, const Word& word) {
    Word next;
    for (std::size_t i = 0; i < word.size(); ++i) {
        const IL::Rule* chosen = nullptr;
        for (const IL::Rule& rule : system.rules[word[i]]) {
            if (rule.left.size() > i || rule.right.size() >= word.size() - i) continue;
            const auto at = word.begin() + static_cast<std::ptrdiff_t>(i);
            if (!std::equal(rule.left.rbegin(), rule.left.rend(), std::make_reverse_iterator(at)) ||
                !std::equal(rule.right.begin(), rule.right.end(), at + 1))
                continue;
            chosen = &rule;
            break;
        }
        if (chosen)
            next.insert(next.end(), chosen->successor.begin(), chosen->successor.end());
        else
            next.push_back(word[i]);
    }
    return next;
}

double seconds(const auto& work) {
    const std::clock_t start = std::clock();
    work();
    return std::max(1.0, static_cast<double>(std::clock() - start)) / CLOCKS_PER_SEC;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

/// Rates of both: `steps` steps after two to warm up, and one plain step.
void measure(const char* name, const std::string& text, unsigned steps, unsigned rounds,
             bool plain) {
    const IL system = *as_il(read_lsystem(text, "bench.lsys"));
    std::vector<double> ours, others;
    for (unsigned round = 0; round < rounds; ++round) {
        Development development(system);
        development.steps(2);
        Word word = plain ? development.word() : Word();
        double letters = 0;
        const double taken = seconds([&] {
            for (unsigned i = 0; i < steps; ++i) {
                letters += static_cast<double>(development.length());
                development.step();
            }
        });
        ours.push_back(letters / taken);
        if (!plain) continue;
        const double size = static_cast<double>(word.size());
        others.push_back(size / seconds([&] { word = plain_step(system, word); }));
    }
    std::printf("  %-44s algae %8.1f M/s", name, median(ours) / 1e6);
    if (plain)
        std::printf("  rule scan %6.1f M/s  ratio %.1f", median(others) / 1e6,
                    median(ours) / median(others));
    std::printf("\n");
}

std::string letters(const std::string& from, std::size_t count) {
    std::mt19937 random(2026);
    std::string word;
    while (word.size() < count) word += from[random() % from.size()];
    return word;
}

/// Each of the letters is looked at with both neighbours, and becomes a letter.
std::string random_rules(const std::string& of, std::size_t longest) {
    std::mt19937 random(5);
    std::string text;
    for (const char left : of)
        for (const char letter : of)
            for (const char right : of) {
                text += std::string("; ") + left + " < " + letter + " > " + right + " -> ";
                for (std::size_t i = 0; i < (longest == 1 ? 1 : random() % (longest + 1)); ++i)
                    text += of[random() % of.size()];
            }
    return text;
}

}  // namespace

int main(int argc, char** argv) {
    const unsigned rounds = argc > 1 ? static_cast<unsigned>(std::max(1, std::atoi(argv[1]))) : 5;
    constexpr std::size_t million = 1'000'000;
    const auto of_letters = [&](const std::string& from) {
        return "axiom " + letters(from, million);
    };
    std::string rule_110;
    for (int k = 0; k < 8; ++k)
        rule_110 += std::string("; ") + char('0' + k / 4) + " < " + char('0' + k / 2 % 2) + " > " +
                    char('0' + k % 2) + " -> " + char('0' + (110 >> k & 1));
    measure("b < a -> b; b -> a", of_letters("ab") + "; b < a -> b; b -> a", 2000, rounds, true);
    measure("rule 110", of_letters("01") + rule_110, 2000, rounds, true);
    measure("4 letters, random 2L", of_letters("abcd") + random_rules("abcd", 1), 200, rounds,
            true);
    measure("8 letters, random 2L", of_letters("abcdefgh") + random_rules("abcdefgh", 1), 50,
            rounds, true);
    measure("16 letters, random 2L",
            of_letters("abcdefghijklmnop") + random_rules("abcdefghijklmnop", 1), 50, rounds,
            false);
    measure("2 letters, 2L, 0 to 2 letters each", of_letters("ab") + random_rules("ab", 2), 20,
            rounds, true);
    measure("4 letters, 2L, 0 to 2 letters each", of_letters("abcd") + random_rules("abcd", 2), 10,
            rounds, true);
    measure("a < b -> ba; b < a -> aa (grows)", of_letters("ab") + "; a < b -> ba; b < a -> aa", 4,
            rounds, true);
    measure("signal with an ignored letter", of_letters("aaab+") + "; b < a -> b; b -> a; ignore +",
            20, rounds, false);
    std::string tree;
    for (std::size_t i = 0; i < million / 10; ++i) tree += i % 3 ? "a[ba]aab[a]" : "b[a[b]a]aa";
    measure("signal in a tree", "axiom " + tree + "; b < a -> b; b -> a", 20, rounds, false);
    measure("tree contexts on the right",
            "axiom " + tree + "; b < a > [b]aa -> b; a > [a]b -> b; b -> a", 20, rounds, false);
}
