#include "growth/catenative.hpp"

#include <algorithm>

#include "growth/growth_class.hpp"
#include "growth/morphic.hpp"

namespace algae {

namespace {

/// The fewest of the words, one after the other, that make `whole`: how far back each is, or nothing.
/// `earlier[i - 1]` is the word i generations back; empty words take no part.
std::optional<std::vector<std::size_t>> tiling(const Word& whole, const std::vector<const Word*>& earlier) {
    constexpr std::size_t never = static_cast<std::size_t>(-1);
    std::vector<std::size_t> fewest(whole.size() + 1, never), choice(whole.size() + 1, 0);
    fewest[0] = 0;
    for (std::size_t at = 0; at < whole.size(); ++at) {
        if (fewest[at] == never) continue;
        for (std::size_t i = 0; i < earlier.size(); ++i) {
            const Word& word = *earlier[i];
            const std::size_t end = at + word.size();
            if (word.empty() || end > whole.size() || fewest[end] <= fewest[at] + 1) continue;
            if (!std::equal(word.begin(), word.end(), whole.begin() + static_cast<std::ptrdiff_t>(at))) continue;
            fewest[end] = fewest[at] + 1;
            choice[end] = i + 1;
        }
    }
    if (fewest.back() == never || whole.empty()) return std::nullopt;
    std::vector<std::size_t> back;
    for (std::size_t end = whole.size(); end > 0; end -= earlier[back.back() - 1]->size()) back.push_back(choice[end]);
    std::reverse(back.begin(), back.end());
    return back;
}

/// Why no formula can hold, if the lengths tell.
std::optional<std::string> why_none(const D0L& system, const Budget& budget) {
    const GrowthOrder order = growth_order(system, letter_orders(components(growth_matrix(system), budget)));
    if (order.kind == GrowthKind::zero) return "the words are empty from some n on";
    if (order.kind == GrowthKind::bounded)
        return "the lengths are bounded, and two words or more would make them double without end";
    if (order.kind == GrowthKind::exponential) return std::nullopt;
    return "the lengths grow like a polynomial, and two words or more would make them grow exponentially";
}

}  // namespace

std::string CatenativeFormula::text() const {
    std::string text = "w(n) =";
    for (const std::size_t i : back) text += " w(n-" + std::to_string(i) + ")";
    return text + " for n >= " + std::to_string(from);
}

CatenativeAnswer locally_catenative(const D0L& system, std::size_t depth, std::size_t further, const Budget& budget) {
    if (const auto reason = why_none(system, budget)) return {CatenativeAnswer::Kind::none, std::nullopt, *reason};
    const std::uint64_t most = std::min<std::uint64_t>(budget.letters, 1'000'000);
    std::vector<Word> words{system.axiom};
    std::uint64_t letters = system.axiom.size();
    while (words.size() <= depth + further) {
        budget.check();
        Word next = image(system.rules.images, words.back());
        letters += next.size();
        if (letters > most) break;
        words.push_back(std::move(next));
    }
    for (std::size_t deep = 1; deep <= depth; ++deep)
        for (std::size_t n = deep; n < words.size(); ++n) {
            budget.check();
            std::vector<const Word*> earlier;
            for (std::size_t i = 1; i <= deep; ++i) earlier.push_back(&words[n - i]);
            const auto back = tiling(words[n], earlier);
            if (back && back->size() > 1)
                return {CatenativeAnswer::Kind::found, CatenativeFormula{*back, n},
                        "it holds for n = " + std::to_string(n) + ", and the morphism maps each case to the next"};
        }
    return {CatenativeAnswer::Kind::not_found, std::nullopt,
            "no formula of depth up to " + std::to_string(depth) + " holds for any n up to " +
                std::to_string(words.size() - 1)};
}

}  // namespace algae
