#include <algorithm>
#include <map>
#include <tuple>

#include "base/error.hpp"
#include "verify/lengths.hpp"
#include "verify/proofs.hpp"
#include "verify/relations.hpp"

namespace algae::verify {

namespace {

/// What one image of a word has beyond the other: of the left system, if that is ahead.
struct Overhang {
    bool left_ahead = true;
    Word word;
    bool operator==(const Overhang&) const = default;
    bool operator<(const Overhang& other) const {
        return std::tie(left_ahead, word) < std::tie(other.left_ahead, other.word);
    }
};

/// What a letter with these images makes of it; nothing if they differ at a letter that both have.
std::optional<Overhang> with_letter(const Overhang& before, const Word& left, const Word& right) {
    Word one = before.left_ahead ? before.word : Word{};
    Word other = before.left_ahead ? Word{} : before.word;
    one.insert(one.end(), left.begin(), left.end());
    other.insert(other.end(), right.begin(), right.end());
    const std::size_t both = std::min(one.size(), other.size());
    const auto middle = static_cast<std::ptrdiff_t>(both);
    if (!std::equal(one.begin(), one.begin() + middle, other.begin())) return std::nullopt;
    if (one.size() >= other.size()) return Overhang{true, Word(one.begin() + middle, one.end())};
    return Overhang{false, Word(other.begin() + middle, other.end())};
}

std::map<Overhang, std::size_t> read_states(const Checking& with, const Field& proof) {
    const Field field = proof.at("states");
    const std::uint64_t bound = proof.at("bound").number();
    std::map<Overhang, std::size_t> states;
    for (const Field& each : field.list()) {
        each.only({"ahead", "word"});
        const std::string& ahead = each.at("ahead").text();
        if (ahead != "left" && ahead != "right") each.at("ahead").fail("expected left or right");
        Overhang state{ahead == "left", with.reader.word(each.at("word"))};
        if (state.word.empty()) state.left_ahead = true;
        if (state.word.size() > bound) each.refuse("the overflow is longer than the bound");
        if (states.empty() && !state.word.empty()) each.refuse("the first overflow is not empty");
        if (!states.emplace(std::move(state), states.size()).second)
            each.refuse("the overflow is listed twice");
    }
    if (states.empty()) field.refuse("the empty overflow is missing");
    return states;
}

}  // namespace

/// g^k(w) leads from the empty overflow to itself for every k, so g and h agree on it: by induction the
/// sequences of g and h are the same.
void check_balance(const Checking& with, const System& left, const System& right,
                   const Field& proof) {
    proof.only({"by", "bound", "states", "accepts"});
    if (proof.has("accepts")) {
        const Field repeats = proof.at("accepts");
        repeats.only({"steps", "earlier"});
        if (repeats.at("steps").number() <= repeats.at("earlier").number())
            repeats.refuse("nothing repeats before it begins");
    }
    if (left.axiom != right.axiom) proof.refuse("the axioms differ");
    const auto letters = accessible_letters(left, left.axiom);
    const auto states = read_states(with, proof);
    const std::size_t refusal = states.size();
    with.budget.check_memory(letters.size() * (refusal + 1) * (refusal + 1) / 8, "the automaton");
    Relations start;
    for (const Symbol a : letters) {
        const auto& image = right.tables.front()[a];
        if (image.size() != 1) proof.refuse("a letter has two images in the right system");
        BooleanMatrix relation(refusal + 1);
        relation.set(refusal, refusal);
        for (const auto& [state, number] : states) {
            const auto next = with_letter(state, left.tables.front()[a].front(), image.front());
            const auto place = next ? states.find(*next) : states.end();
            relation.set(number, place == states.end() ? refusal : place->second);
        }
        start.emplace(a, std::move(relation));
    }
    const auto leaves = [&](const Relations& relations) {
        return !relation_of(left.axiom, relations, refusal + 1).at(0, 0);
    };
    if (some_relations(left, start, refusal + 1, leaves, with.budget))
        proof.at("states").refuse(
            "a word of the sequence does not lead through these overflows back to the empty one");
}

namespace {

void check_finite_sequences(const Checking& with, const System& left, const System& right,
                            const Field& proof) {
    proof.only({"by"});
    std::set<Word> known;
    std::uint64_t letters = 0;
    Word one = left.axiom, other = right.axiom;
    const auto next = [](const System& system, const Word& word) {
        Word longer;
        for (const Symbol a : word) {
            const Word& image = system.tables.front()[a].front();
            longer.insert(longer.end(), image.begin(), image.end());
        }
        return longer;
    };
    for (std::uint64_t generation = 0;; ++generation) {
        with.budget.check();
        if (one != other) proof.refuse("generation " + std::to_string(generation) + " differs");
        if (!known.insert(one).second) return;  // equal words give equal words from here on
        letters += one.size() + 16;
        if (letters > 50'000'000)
            throw BoundReached(Bound::method, "the words of the sequences are too long");
        one = next(left, one);
        other = next(right, other);
    }
}

void check_difference(const Checking& with, const System& left, const System& right,
                      const Field& proof) {
    proof.only({"by", "generation", "position"});
    const Integer generation = proof.at("generation").integer();
    if (!proof.has("position")) {
        if (length_of_generation(left, generation, with.budget) ==
            length_of_generation(right, generation, with.budget))
            proof.at("generation").refuse("both words are of the same length");
        return;
    }
    if (generation > 100'000)
        throw BoundReached(Bound::method, "the letters of generation " + to_string(generation) +
                                              " are not looked up");
    const Integer position = proof.at("position").integer();
    const auto one = letter_of_generation(left, generation.to_uint64(), position, with.budget);
    const auto other = letter_of_generation(right, generation.to_uint64(), position, with.budget);
    if (one == other)
        proof.at("position")
            .refuse(one ? "both words have the same letter there" : "neither word is so long");
}

}  // namespace

void check_sequences(const Checking& with, const Statement& statement, bool holds,
                     const Field& proof, const std::string& by) {
    const System& left = *statement.systems[0].system;
    const System& right = *statement.systems[1].system;
    if (!is_d0l(left) || !is_d0l(right)) proof.refuse("a system is not D0L");
    if (!holds) {
        if (by != "generation") wrong_kind(proof, by);
        check_difference(with, left, right, proof);
    } else if (by == "balance") {
        check_balance(with, left, right, proof);
    } else if (by == "lengths") {
        check_finite_sequences(with, left, right, proof);
    } else {
        wrong_kind(proof, by);
    }
}

}  // namespace algae::verify
