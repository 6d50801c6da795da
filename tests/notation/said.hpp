#pragma once

#include <string>

#include "exact/exact.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"

/// What is said about a text, or "" if nothing is wrong with it.
inline std::string findings(const std::string& text) {
    try {
        algae::read_lsystem(text, "x.lsys");
        return {};
    } catch (const algae::Diagnostics& error) {
        return error.what();
    }
}
