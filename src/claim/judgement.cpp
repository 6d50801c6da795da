#include "claim/judgement.hpp"

#include <nlohmann/json.hpp>

namespace algae {

namespace {

Judgement judged(Truth truth, std::vector<std::string> argument,
                 const nlohmann::ordered_json& proof) {
    return {truth, std::move(argument), std::make_shared<const nlohmann::ordered_json>(proof)};
}

}  // namespace

Judgement Judgement::proved(std::vector<std::string> argument,
                            const nlohmann::ordered_json& proof) {
    return judged(Truth::proved, std::move(argument), proof);
}

Judgement Judgement::refuted(std::vector<std::string> argument,
                             const nlohmann::ordered_json& proof) {
    return judged(Truth::refuted, std::move(argument), proof);
}

Judgement Judgement::undecided(std::vector<std::string> tried) {
    return {Truth::undecided, std::move(tried), nullptr};
}

Judgement opposite(Judgement judgement) {
    judgement.truth = opposite(judgement.truth);
    return judgement;
}

}  // namespace algae
