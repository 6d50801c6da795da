#pragma once

#include <string>

#include "model/model.hpp"
#include "notation/notation.hpp"
#include "rewrite/rewrite.hpp"

namespace algae {

/// The boxes of generation n, a line each.
inline std::string boxes(const std::string& text, std::uint64_t n, const Budget& budget = {}) {
    const View<ShapeSystem> shapes = as_shape(read_lsystem(text, "test.lsys"));
    std::string out;
    for (const ShapeBox& box : boxes_after(*shapes, shapes->axiom, n, budget))
        out += box_text(shapes->system->alphabet, box) + '\n';
    return out;
}

/// What is said against deriving it.
inline std::string box_refusal(const std::string& text, std::uint64_t n = 1) {
    try {
        return boxes(text, n);
    } catch (const Error& error) {
        return error.what();
    }
}

}  // namespace algae
