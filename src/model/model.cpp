#include "model/model.hpp"

#include <algorithm>

// The tables behind settings that name something: kinds of solids, of surfaces, of stamps and of expectations. Each table is the only list of its
// names; reading, printing and completion ask it.

namespace algae {

const std::vector<SolidKind>& solid_kinds() {
    static const std::vector<SolidKind> kinds = [] {
        const SolidKind::Name colour{"colour", "_color"}, height{"height", "_height"},
            radius{"radius", "_radius"}, x{"x", "_x"}, y{"y", "_y"}, z{"z", "_z"};
        return std::vector<SolidKind>{
            {{"box", "_typeCube"}, {{"width", "_width"}, height, {"depth", "_depth"}, colour}},
            {{"cylinder", "_typeCylinder"}, {radius, height, colour}},
            {{"cone", "_typeCone"}, {{"radius", "_bottomRadius"}, height, colour}},
            {{"sphere", "_typeSphere"}, {radius, colour}},
            {{"rotation", "_typeRotation"}, {x, y, z}},
            {{"translation", "_typeTranslation"}, {x, y, z}}};
    }();
    return kinds;
}

const SolidKind* solid_kind(std::string_view name) {
    for (const SolidKind& kind : solid_kinds())
        if (kind.name.name == name || kind.name.reserved == name) return &kind;
    return nullptr;
}

const std::vector<std::string>& surface_kinds() {
    static const std::vector<std::string> kinds{"leaf", "petal", "disc", "polygon", "patch"};
    return kinds;
}

const std::vector<std::string>& stamp_shapes() {
    static const std::vector<std::string> shapes{"square", "circle", "triangle"};
    return shapes;
}

const std::vector<std::string>& expectation_kinds() {
    static const std::vector<std::string> kinds{"length",   "lengths",  "mean", "word", "segments",
                                                "distinct", "vertices", "end",  "box"};
    return kinds;
}

const std::vector<std::string>& picture_kinds() {
    static const std::vector<std::string> kinds{"figure", "table", "tree", "plot"};
    return kinds;
}

LetterCoding::LetterCoding(const Alphabet& letters, const Coding& coding) {
    for (const auto& [letter, image] : coding.images)
        morphism.add(letter, {alphabet.symbol(image)});
    for (Symbol letter = 0; letter < letters.size(); ++letter)
        if (!morphism.maps(letter)) morphism.add(letter, {alphabet.symbol(letters.name(letter))});
}

bool Model::operator==(const Model& other) const {
    return LSystem::operator==(other) && drawing == other.drawing &&
           expectations == other.expectations && coding == other.coding;
}

bool lies_down(const Model& model) {
    if (model.drawing.start || !model.drawing.plotters.empty()) return false;
    const auto has = [&](const Word& word, std::string_view signs) {
        return std::any_of(word.begin(), word.end(), [&](Symbol symbol) {
            const std::string& name = model.alphabet.name(symbol);
            return name.size() == 1 && signs.find(name[0]) != std::string_view::npos;
        });
    };
    if (has(model.axiom.letters, "+-&^\\/|$")) return false;
    // A stem: a stroke outside of brackets.
    const auto has_stem = [&](const Word& word) {
        int depth = 0;
        return std::any_of(word.begin(), word.end(), [&](Symbol symbol) {
            const std::string& name = model.alphabet.name(symbol);
            depth += (name == "[") - (name == "]");
            return depth == 0 && (name == "F" || name.starts_with("F_"));
        });
    };
    bool branches = has(model.axiom.letters, "["), stem = has_stem(model.axiom.letters);
    for (const Production& rule : model.rules) {
        branches = branches || has(rule.successor.letters, "[");
        stem = stem || has_stem(rule.successor.letters);
    }
    return branches && stem;
}

}  // namespace algae
