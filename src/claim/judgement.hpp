#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "base/verdict.hpp"

namespace algae {

/// What is known of a statement and why: the argument in sentences, and the proof that a certificate
/// holds (CERTIFICATES.md), which the room `verify` checks again. The proof is of the statement where it is
/// proved and of its opposite where it is refuted; there is none where it is undecided.
struct Judgement {
    Truth truth = Truth::undecided;
    std::vector<std::string>
        argument;  // one sentence or line each; an indented line belongs to the one before
    std::shared_ptr<const nlohmann::ordered_json> proof;

    static Judgement proved(std::vector<std::string> argument, const nlohmann::ordered_json& proof);
    static Judgement refuted(std::vector<std::string> argument,
                             const nlohmann::ordered_json& proof);
    static Judgement undecided(std::vector<std::string> tried);
};

/// The judgement on the opposite statement, by the same proof.
Judgement opposite(Judgement judgement);

}  // namespace algae
