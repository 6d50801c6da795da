#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "model/model.hpp"
#include "oracle/boxes.hpp"
#include "rewrite/derived_boxes.hpp"

using namespace algae;
using oracle::CutBox;
using oracle::CutRule;

namespace {

CutRule::Size any_size() { return {*rc::gen::inRange(1, 5), *rc::gen::inRange(0, 3) > 0}; }

/// A rule for the letter whose parts are all later letters.
CutRule any_rule(char letter) {
    CutRule rule;
    rule.letter = letter;
    const auto later = rc::gen::inRange(static_cast<char>(letter + 1), 'I');
    const int kind = *rc::gen::inRange(0, 5);
    std::size_t places = 1;
    if (kind > 0) {
        std::string axes = *rc::gen::element<std::string>("X", "Y", "Z", "XZ", "ZY", "YXZ");
        if (kind == 1) {
            axes.resize(1);
            rule.repeated = *rc::gen::inRange(1, 4);
        }
        for (const char axis : axes) {
            rule.cuts.push_back({axis, {}});
            if (rule.repeated) continue;
            for (int sizes = *rc::gen::inRange(1, 4); sizes > 0; --sizes)
                rule.cuts.back().sizes.push_back(any_size());
            places *= rule.cuts.back().sizes.size();
        }
        if (axes.size() > 1 && *rc::gen::arbitrary<bool>()) places = 1;
    }
    for (std::size_t i = 0; i < places; ++i) rule.parts += *later;
    return rule;
}

}  // namespace

TEST_CASE("dividing all boxes at once ends where dividing one after the other does") {
    int fitting = 0;
    CHECK(rc::check([&] {
        std::vector<CutRule> rules;
        for (const char letter : {'A', 'B', 'C', 'D'})
            if (letter == 'A' || *rc::gen::inRange(0, 4) > 0) rules.push_back(any_rule(letter));
        CutBox start;
        std::string text = "axiom A(";
        for (std::size_t i = 0; i < 3; ++i) {
            const int size = *rc::gen::inRange(1, 40);
            start.high[i] = size;
            text += (i ? "," : "") + std::to_string(size);
        }
        text += ")\n";
        for (const CutRule& rule : rules) text += written(rule) + '\n';
        RC_LOG() << text;
        std::vector<CutBox> expected{start};
        const bool fits = cut_one_by_one(rules, expected);
        const View<ShapeSystem> shapes = as_shape(read_lsystem(text, "test.lsys"));
        if (!fits) {
            RC_ASSERT_THROWS_AS(boxes_after(*shapes, shapes->axiom, 9), Error);
            return;
        }
        ++fitting;
        const std::vector<ShapeBox> found = boxes_after(*shapes, shapes->axiom, 9);
        RC_ASSERT(found.size() == expected.size());
        for (std::size_t i = 0; i < found.size(); ++i) {
            RC_ASSERT(shapes->system->alphabet.name(found[i].symbol) ==
                      std::string(1, expected[i].letter));
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const Rational high = found[i].origin[axis] + found[i].size[axis];
                RC_ASSERT(doctest::Approx(found[i].origin[axis].to_double()).epsilon(1e-9) ==
                          expected[i].low[axis]);
                RC_ASSERT(doctest::Approx(high.to_double()).epsilon(1e-9) ==
                          expected[i].high[axis]);
            }
        }
    }));
    CHECK(fitting > 20);
}

TEST_CASE("parts neither overlap nor leave the box, and shares fill it exactly") {
    CHECK(rc::check([] {
        CutRule rule = any_rule('A');
        std::string text = "axiom A(7,8,9)\n" + written(rule) + '\n';
        RC_LOG() << text;
        const View<ShapeSystem> shapes = as_shape(read_lsystem(text, "test.lsys"));
        std::vector<ShapeBox> parts;
        try {
            parts = boxes_after(*shapes, shapes->axiom, 1);
        } catch (const Error&) {
            return;
        }
        bool fills = true;
        for (const auto& cut : rule.cuts) {
            bool shares = rule.repeated > 0;
            for (const auto& size : cut.sizes) shares = shares || size.share;
            fills = fills && shares;
        }
        Rational volume = 0;
        for (const ShapeBox& part : parts) volume += part.size[0] * part.size[1] * part.size[2];
        RC_ASSERT(volume <= Rational(7 * 8 * 9));
        if (fills) RC_ASSERT(volume == Rational(7 * 8 * 9));
        for (std::size_t i = 0; i < parts.size(); ++i)
            for (std::size_t k = 0; k < i; ++k) {
                bool apart = false;
                for (std::size_t axis = 0; axis < 3; ++axis)
                    apart = apart ||
                            parts[i].origin[axis] + parts[i].size[axis] <= parts[k].origin[axis] ||
                            parts[k].origin[axis] + parts[k].size[axis] <= parts[i].origin[axis];
                RC_ASSERT(apart);
            }
    }));
}
