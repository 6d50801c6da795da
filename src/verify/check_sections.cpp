#include <algorithm>
#include <numeric>

#include "base/error.hpp"
#include "verify/proofs.hpp"

namespace algae::verify {

namespace {

constexpr std::uint64_t furthest =
    100'000;  // of numbers of generations and of what they are repeated by

/// Numbers first, first + step, first + 2 step, ...; only the first if the step is 0.
struct Progression {
    std::uint64_t first = 0, step = 0;
};

bool covers_all(const std::vector<Progression>& progressions) {
    std::uint64_t beyond = 1, period = 1;
    for (const Progression& each : progressions) {
        beyond = std::max(beyond, each.first + 1);
        if (each.step > 0) period = std::lcm(period, each.step);
        if (period > furthest)
            throw BoundReached(Bound::method, "the sections repeat too late to be checked");
    }
    for (std::uint64_t n = 0; n < beyond + period; ++n)
        if (std::none_of(progressions.begin(), progressions.end(), [&](const Progression& each) {
                return n == each.first ||
                       (each.step > 0 && n > each.first && (n - each.first) % each.step == 0);
            }))
            return false;
    return true;
}

Word next(const System& system, const Word& word, const Budget& budget) {
    Word longer;
    budget.check();
    for (const Symbol a : word) {
        const Word& image = system.tables.front()[a].front();
        if (longer.size() + image.size() > 10'000'000)
            throw BoundReached(Bound::method, "the words of the sequences are too long");
        longer.insert(longer.end(), image.begin(), image.end());
    }
    return longer;
}

Word generation(const System& system, Word word, std::uint64_t steps, const Budget& budget) {
    if (steps > furthest)
        throw BoundReached(Bound::method, "the sections begin too late to be checked");
    for (; steps > 0; --steps) word = next(system, word, budget);
    return word;
}

/// The system of every so many generations, from one on. Letters that are not accessible stay as they are.
System section(const System& system, std::uint64_t first, std::uint64_t step,
               const Budget& budget) {
    System part = system;
    part.axiom = generation(system, system.axiom, first, budget);
    auto& images = part.tables.front();
    for (Symbol a = 0; a < images.size(); ++a) images[a] = {{a}};
    for (const Symbol a : accessible_letters(system, system.axiom))
        images[a] = {generation(system, {a}, step, budget)};
    return part;
}

}  // namespace

void check_sections(const Checking& with, const System& left, const System& right,
                    const Field& proof) {
    proof.only({"by", "words", "sections"});
    std::vector<Progression> numbers_left, numbers_right;
    for (const Field& each : proof.at("words").list()) {
        const auto [one, other] = each.pair();
        numbers_left.push_back({one.number(), 0});
        numbers_right.push_back({other.number(), 0});
        if (generation(left, left.axiom, one.number(), with.budget) !=
            generation(right, right.axiom, other.number(), with.budget))
            each.refuse("these generations are not the same word");
    }
    for (const Field& each : proof.at("sections").list()) {
        each.only({"left", "step", "right", "stride", "proof"});
        const Progression one{each.at("left").number(), each.at("step").number()};
        const Progression other{each.at("right").number(), each.at("stride").number()};
        if (one.step == 0 || other.step == 0) each.refuse("a section goes on");
        const System first = section(left, one.first, one.step, with.budget);
        const System second = section(right, other.first, other.step, with.budget);
        if (!is_d0l(first) || !is_d0l(second)) each.refuse("a section is not D0L");
        const Field balance = each.at("proof");
        if (balance.at("by").text() != "balance") wrong_kind(balance, balance.at("by").text());
        check_balance(with, first, second, balance);
        numbers_left.push_back(one);
        numbers_right.push_back(other);
    }
    if (!covers_all(numbers_left)) proof.refuse("a generation of the left system is in no section");
    if (!covers_all(numbers_right))
        proof.refuse("a generation of the right system is in no section");
}

}  // namespace algae::verify
