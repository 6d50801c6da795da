#include "model/model.hpp"

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

}  // namespace algae
