#pragma once
// What the tests of this room share: lengths counted letter by letter, and systems to try.

#include <rapidcheck.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "notation/notation.hpp"
#include "places.hpp"
#include "system/system.hpp"

namespace algae {

/// The lengths of the first generations, with no matrix and no fold.
inline std::vector<Integer> counted_lengths(const D0L& system, std::size_t count) {
    std::map<Symbol, Integer> letters;
    for (const Symbol a : system.axiom) letters[a] += 1;
    std::vector<Integer> found;
    while (found.size() < count) {
        Integer sum = 0;
        for (const auto& [a, times] : letters) sum += times;
        found.push_back(sum);
        std::map<Symbol, Integer> next;
        for (const auto& [a, times] : letters)
            for (const Symbol b : system.successor(a)) next[b] += times;
        letters = std::move(next);
    }
    return found;
}

/// A system over up to 6 letters. In some, letters become only later ones or themselves, so that they
/// grow like polynomials, or die; in some, letters go round.
inline D0L any_small_system() {
    // Whole ranges from the first case on.
    const auto number = [](int low, int high) {
        return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high + 1));
    };
    const std::string all = "abcdef";
    const auto count = static_cast<std::size_t>(number(1, 6));
    const int kind = number(0, 3), longest = number(1, 4), erasing = number(0, 3);
    const auto word = [&](const std::string& from, int least, int most) {
        std::string found;
        for (int size = number(least, most); size > 0; --size) found += *rc::gen::elementOf(from);
        return found;
    };
    std::vector<std::pair<char, std::string>> rules;
    for (std::size_t i = 0; i < count; ++i) {
        const std::string letters = kind == 1 ? all.substr(i, count - i) : all.substr(0, count);
        std::string successor = word(letters, erasing == 0 && number(0, 2) == 0 ? 0 : 1, longest);
        if (kind == 2) successor = all[(i + 1) % count] + word(all.substr(0, count), 0, 1);
        if (kind == 3) successor = all[i] + word(all.substr(i, count - i), 0, 1);
        rules.emplace_back(all[i], successor);
    }
    return d0l(all.substr(0, 1) + word(all.substr(0, count), 0, 2), rules);
}

/// A system over so many letters with successors of 1 to 6 letters.
inline D0L any_wide_system(std::size_t letters) {
    Alphabet alphabet;
    std::vector<Word> images;
    for (std::size_t i = 0; i < letters; ++i) {
        alphabet.symbol("x_" + std::to_string(i));
        Word image;
        const auto size = *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::size_t>(1, 7));
        for (std::size_t k = 0; k < size; ++k)
            image.push_back(static_cast<Symbol>(
                *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::size_t>(0, letters))));
        images.push_back(std::move(image));
    }
    return make_d0l(std::make_shared<const Alphabet>(std::move(alphabet)), Word{0},
                    std::move(images));
}

/// Every D0L system among the files of the repository.
inline std::vector<D0L> systems_in_files() {
    std::vector<D0L> found;
    for (const char* folder : {"/figures", "/systems"})
        for (const auto& entry :
             std::filesystem::recursive_directory_iterator(source_folder() + folder)) {
            if (entry.path().extension() != ".lsys") continue;
            std::ifstream in(entry.path(), std::ios::binary);
            std::ostringstream text;
            text << in.rdbuf();
            const View<D0L> system =
                as_d0l(read_lsystem(text.str(), entry.path().filename().string()));
            if (system) found.push_back(*system);
        }
    return found;
}

}  // namespace algae
