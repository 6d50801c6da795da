#pragma once
// Random systems for rapidcheck, small enough for the slow routes and nasty enough for the fast.

#include <rapidcheck.h>

#include <string>

#include "oracle/written_system.hpp"

namespace algae::oracle {

/// A word of up to `most` of these letters.
inline rc::Gen<std::string> any_word(const std::string& letters, int most) {
    return rc::gen::mapcat(rc::gen::inRange(0, most + 1), [letters](int size) {
        return rc::gen::container<std::string>(static_cast<std::size_t>(size),
                                               rc::gen::elementOf(letters));
    });
}

/// The same with at least one letter.
inline rc::Gen<std::string> any_nonempty_word(const std::string& letters, int most) {
    return rc::gen::suchThat(any_word(letters, most),
                             [](const std::string& word) { return !word.empty(); });
}

/// The word with brackets added or left out so that they match.
inline std::string balanced(const std::string& word) {
    std::string out;
    std::size_t depth = 0;
    for (const char letter : word) {
        if (letter == ']' && depth == 0) continue;
        if (letter == '[') ++depth;
        if (letter == ']') --depth;
        out += letter;
    }
    return out + std::string(depth, ']');
}

/// A D0L system over a, b, d with any successors, among them: c, which stays; p and q, which take
/// turns; m, which dies at once, and k, which becomes m; z, which doubles and mostly is not reached.
inline rc::Gen<WrittenSystem> any_d0l() {
    const std::string letters = "abcdpqmkab";
    return rc::gen::apply(
        [](std::string axiom, std::string a, std::string b, std::string d, bool unreachable) {
            WrittenSystem system{std::move(axiom),
                                 {{'a', {a}},
                                  {'b', {b}},
                                  {'d', {d}},
                                  {'p', {"q"}},
                                  {'q', {"p"}},
                                  {'m', {""}},
                                  {'k', {"m"}}}};
            if (unreachable) system.successors['z'] = {"zz"};
            return system;
        },
        any_word(letters, 4), any_word(letters, 4), any_word(letters, 3), any_word(letters, 2),
        rc::gen::arbitrary<bool>());
}

/// A D0L system without erasing rules.
inline rc::Gen<WrittenSystem> any_propagating_d0l() {
    return rc::gen::apply(
        [](std::string axiom, std::string a, std::string b) {
            return WrittenSystem{std::move(axiom),
                                 {{'a', {a}}, {'b', {b}}, {'p', {"q"}}, {'q', {"p"}}}};
        },
        any_nonempty_word("abcpq", 3), any_nonempty_word("abcpq", 4), any_nonempty_word("abcp", 2));
}

/// An 0L system over a, b and the constant c with up to three successors of at most `longest`
/// letters each.
inline rc::Gen<WrittenSystem> any_0l(int longest, bool erasing) {
    const auto words = [=](int most) {
        const auto word = erasing ? any_word("abc", longest) : any_nonempty_word("abc", longest);
        return rc::gen::mapcat(rc::gen::inRange(1, most + 1), [word](int count) {
            return rc::gen::container<std::vector<std::string>>(static_cast<std::size_t>(count),
                                                                word);
        });
    };
    return rc::gen::apply(
        [](std::string axiom, std::vector<std::string> a, std::vector<std::string> b) {
            return WrittenSystem{std::move(axiom), {{'a', std::move(a)}, {'b', std::move(b)}}};
        },
        any_nonempty_word("abc", 2), words(3), words(2));
}

/// A D0L system of a turtle, brackets matched in the axiom and in every successor. `also` are
/// further letters that may occur.
inline rc::Gen<WrittenSystem> any_bracketed(const std::string& also = "") {
    const std::string letters = "FFXY+-[]fG|" + also;
    return rc::gen::apply(
        [](std::string axiom, std::string f, std::string x, std::string y) {
            return WrittenSystem{
                balanced("F" + axiom),
                {{'F', {balanced(f)}}, {'X', {balanced(x)}}, {'Y', {balanced(y)}}}};
        },
        any_word(letters, 4), any_word(letters, 5), any_word(letters, 6), any_word(letters, 3));
}

}  // namespace algae::oracle
