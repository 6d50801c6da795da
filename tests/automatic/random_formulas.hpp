#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <vector>

// Random first-order statements, with what they say of a prefix of a word.

namespace algae {

/// A random statement whose quantifiers are bounded, as text and as what it says of a prefix.
struct Formula {
    using Values = std::map<std::string, int>;
    std::string text;
    std::function<bool(const Values&)> says;
    int deep = 0;  // quantifiers inside each other
};

struct Term {
    std::string text;
    std::function<int(const Formula::Values&)> value;
};

inline Term random_term(const std::vector<std::string>& names) {
    Term sum{"", [](const Formula::Values&) { return 0; }};
    const int parts = *rc::gen::inRange(1, 3);
    for (int part = 0; part < parts; ++part) {
        const auto before = sum.value;
        const int times = *rc::gen::element(1, 1, 1, 2, 3);
        if (*rc::gen::inRange(0, 4) == 0) {
            sum.text += (part ? " + " : "") + std::to_string(times);
            sum.value = [=](const Formula::Values& v) { return before(v) + times; };
        } else {
            const std::string name = *rc::gen::elementOf(names);
            sum.text += (part ? " + " : "") + (times == 1 ? "" : std::to_string(times)) + name;
            sum.value = [=](const Formula::Values& v) { return before(v) + times * v.at(name); };
        }
    }
    return sum;
}

inline Formula random_formula(const std::string& prefix, std::vector<std::string> names,
                              int depth) {
    const int kind = *rc::gen::inRange(0, depth == 0 ? 5 : 12);
    if (kind <= 1) {  // letters
        const Term one = random_term(names), other = random_term(names);
        const bool same = *rc::gen::arbitrary<bool>();
        return {"T[" + one.text + "] " + (same ? "=" : "!=") + " T[" + other.text + "]",
                [=](const Formula::Values& v) {
                    return (prefix.at(static_cast<std::size_t>(one.value(v))) ==
                            prefix.at(static_cast<std::size_t>(other.value(v)))) == same;
                }};
    }
    if (kind == 2) {
        const Term one = random_term(names);
        const char letter = prefix[static_cast<std::size_t>(*rc::gen::inRange(0, 40))];
        return {"T[" + one.text + "] = " + letter, [=](const Formula::Values& v) {
                    return prefix.at(static_cast<std::size_t>(one.value(v))) == letter;
                }};
    }
    if (kind <= 4) {
        const Term one = random_term(names), other = random_term(names), less = random_term(names);
        const int sign = *rc::gen::inRange(0, 6);
        const char* const signs[] = {"<", "<=", ">", ">=", "=", "!="};
        const bool with_difference = *rc::gen::inRange(0, 4) == 0;
        return {one.text + (with_difference ? " - (" + less.text + ")" : "") + " " + signs[sign] +
                    " " + other.text,
                [=](const Formula::Values& v) {
                    const int l = one.value(v) - (with_difference ? less.value(v) : 0),
                              r = other.value(v);
                    switch (sign) {
                        case 0:
                            return l < r;
                        case 1:
                            return l <= r;
                        case 2:
                            return l > r;
                        case 3:
                            return l >= r;
                        case 4:
                            return l == r;
                        default:
                            return l != r;
                    }
                }};
    }
    if (kind == 5) {
        const Formula inner = random_formula(prefix, names, depth - 1);
        return {"not (" + inner.text + ")",
                [=](const Formula::Values& v) { return !inner.says(v); }, inner.deep};
    }
    if (kind <= 8) {
        const Formula one = random_formula(prefix, names, depth - 1),
                      other = random_formula(prefix, names, depth - 1);
        const int which = *rc::gen::inRange(0, 4);
        const char* const signs[] = {"and", "or", "implies", "iff"};
        return {"(" + one.text + ") " + signs[which] + " (" + other.text + ")",
                [=](const Formula::Values& v) {
                    const bool l = one.says(v), r = other.says(v);
                    switch (which) {
                        case 0:
                            return l && r;
                        case 1:
                            return l || r;
                        case 2:
                            return !l || r;
                        default:
                            return l == r;
                    }
                },
                std::max(one.deep, other.deep)};
    }
    const std::string of = *rc::gen::elementOf(names);
    const int more = *rc::gen::inRange(0, 3);
    const Term bound{of + " + " + std::to_string(more),
                     [=](const Formula::Values& v) { return v.at(of) + more; }};
    const std::string name = "k" + std::to_string(depth);
    const bool all = *rc::gen::arbitrary<bool>();
    names.push_back(name);
    const Formula inner = random_formula(prefix, names, depth - 1);
    return {
        std::string(all ? "for all " : "for some ") + name + " < " + bound.text + ": " + inner.text,
        [=](const Formula::Values& v) {
            Formula::Values values = v;
            for (values[name] = 0; values[name] < bound.value(v); ++values[name])
                if (inner.says(values) != all) return !all;
            return all;
        },
        inner.deep + 1};
}

}  // namespace algae
