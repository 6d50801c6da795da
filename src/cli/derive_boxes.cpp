#include "cli/derive_boxes.hpp"

#include <nlohmann/json.hpp>

#include "cli/output.hpp"
#include "shape/boxes.hpp"

namespace algae::cli {

namespace {

nlohmann::ordered_json as_json(const std::array<Rational, 3>& numbers) {
    nlohmann::ordered_json out = nlohmann::ordered_json::array();
    for (const Rational& number : numbers) out.push_back(shortest_text(number));
    return out;
}

nlohmann::ordered_json as_json(const Alphabet& alphabet, const std::vector<ShapeBox>& boxes) {
    nlohmann::ordered_json out = nlohmann::ordered_json::array();
    for (const ShapeBox& box : boxes)
        out.push_back({{"symbol", alphabet.name(box.symbol)},
                       {"origin", as_json(box.origin)},
                       {"size", as_json(box.size)}});
    return out;
}

}  // namespace

void derive_boxes(const LSystem& system, std::uint64_t first, std::uint64_t last, bool json,
                  const Budget& budget) {
    const View<ShapeSystem> shapes = as_shape(system);
    std::vector<ShapeBox> boxes = boxes_after(*shapes, shapes->axiom, first, budget);
    nlohmann::ordered_json generations = nlohmann::ordered_json::array();
    for (std::uint64_t n = first;; ++n) {
        if (json) {
            generations.push_back({{"generation", n}, {"boxes", as_json(system.alphabet, boxes)}});
        } else {
            std::string text;
            if (first != last) text = "# generation " + std::to_string(n) + '\n';
            for (const ShapeBox& box : boxes) text += box_text(system.alphabet, box) + '\n';
            print(text);
        }
        if (n == last) break;
        boxes = boxes_after(*shapes, std::move(boxes), 1, budget);
    }
    if (json) print(nlohmann::ordered_json{{"generations", generations}}.dump(2) + "\n");
}

}  // namespace algae::cli
