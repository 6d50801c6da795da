#include "exchange/brno_words.hpp"

#include <string>

#include "exchange/polygon_letters.hpp"

namespace algae {

namespace {

/// Between braces stand turns and lines only.
void check_polygons(const PlacedWord& word, const BrnoSystem& system, Findings& findings) {
    const std::vector<std::size_t> depths = brace_depths(word.text);
    for (std::size_t i = 0; i < word.text.size(); ++i) {
        const auto module = system.modules.find(word.text[i]);
        if (depths[i] == 0 || module == system.modules.end()) continue;
        const char kind = module->second.kind;
        if (kind == 'C' || kind == 'S')
            findings.add(word.offsets[i],
                         std::string("expected turns and lines between '{' and '}', found '") +
                             word.text[i] + "', a " + (kind == 'C' ? "cylinder" : "ball"));
    }
}

}  // namespace

void check_brno_word(const PlacedWord& word, const BrnoSystem& system, std::set<char>& missing,
                     Findings& findings) {
    check_brackets(word, findings);
    check_polygons(word, system, findings);
    for (const char vector : {'U', 'L', 'H'}) {
        const std::size_t at = word.text.find_first_of(brno_turns(vector));
        if (at == std::string::npos || system.angles.contains(vector) ||
            !missing.insert(vector).second)
            continue;
        findings.add(word.offsets[at], std::string("expected the angle ") + vector +
                                           " among the angles, as '" + word.text[at] +
                                           "' turns by it");
    }
}

}  // namespace algae
