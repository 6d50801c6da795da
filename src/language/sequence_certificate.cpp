#include "language/sequence_certificate.hpp"

#include <nlohmann/json.hpp>

#include "verify/obstruction_json.hpp"

namespace algae {

namespace {

using Json = nlohmann::ordered_json;

/// Small numbers as numbers, others as digits.
Json number(const Integer& value) {
    if (bit_length(value) <= 53) return value.to_int64();
    return to_string(value);
}

}  // namespace

Json balance_certificate(const Balance& balance, const Alphabet& alphabet) {
    Json states = Json::array();
    for (const Overflow& overflow : balance.states)
        states.push_back({{"ahead", overflow.ahead == Overflow::Ahead::left ? "left" : "right"},
                          {"word", certificate_text(alphabet, overflow.word)}});
    return {{"by", "balance"},
            {"bound", balance.bound},
            {"states", std::move(states)},
            {"accepts", {{"steps", balance.steps}, {"earlier", balance.earlier}}}};
}

Json difference_certificate(const SequenceDifference& difference) {
    return {{"by", "generation"},
            {"generation", difference.generation},
            {"position", number(difference.position)}};
}

Json language_certificate(const LanguageEquality& equality, const Alphabet& alphabet) {
    if (equality.finite) return {{"by", "values"}};
    Json words = Json::array(), sections = Json::array();
    for (const auto& [left, right] : equality.words) words.push_back({left, right});
    for (const SectionMatch& match : equality.sections)
        sections.push_back({{"left", match.section.left},
                            {"step", match.section.step},
                            {"right", match.section.right},
                            {"stride", match.section.stride},
                            {"proof", balance_certificate(match.balance, alphabet)}});
    return {{"by", "sections"}, {"words", std::move(words)}, {"sections", std::move(sections)}};
}

}  // namespace algae
