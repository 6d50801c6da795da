#include "exchange/brno_modules.hpp"

namespace algae {

namespace {

std::string text_of(const BrnoPrimitive& primitive) {
    const std::string diameter = std::to_string(primitive.diameter);
    const std::string length = std::to_string(primitive.length);
    if (primitive.kind == 'C') return " = C(" + diameter + "," + length + ")";
    if (primitive.kind == 'P') return " = P(" + length + ")";
    return primitive.kind == 'S' ? " = S(" + diameter + ")" : "";
}

}  // namespace

std::string brno_text(BrnoSystem system, const std::string& title) {
    if (system.modules.empty()) system.modules['A'];
    if (system.rules.empty()) {
        const char letter = system.modules.begin()->first;
        system.rules.emplace_back(letter, std::string(1, letter));
    }
    std::string out = title.empty() ? "" : "// " + title + "\n\n";
    const char* before = "modules:\n    ";
    for (const auto& [letter, primitive] : system.modules) {
        out += before + std::string(1, letter) + text_of(primitive);
        before = ", ";
    }
    out += ";\n\naxiom:\n    " + system.axiom;
    out += ";\n\nangles:\n    ";
    before = "";
    for (const char vector : {'L', 'U', 'H'})
        if (system.angles.contains(vector)) {
            out += before + std::string(1, vector) + " = " + std::to_string(system.angles[vector]);
            before = ", ";
        }
    before = ";\n\nrules:\n    ";
    for (const auto& [letter, successor] : system.rules) {
        out += before + std::string(1, letter) + " -> " + successor;
        before = ",\n    ";
    }
    return out + ";\n\nEND\n";
}

}  // namespace algae
