#include <algorithm>
#include <utility>

#include "notation/characters.hpp"
#include "notation/clauses.hpp"
#include "notation/expression_grammar.hpp"
#include "notation/settings_grammar.hpp"
#include "notation/suggestion.hpp"

namespace algae {

namespace {

Symbol communication_symbol(std::string_view piece, Reading& reading) {
    std::string_view rest = piece;
    const auto symbol = reading.lexicon.next(rest);
    if (!symbol || !rest.empty() || !is_communication(piece))
        throw SyntaxError{piece.data(),
                          "expected a communication module, such as ?E, found " + quoted(piece)};
    return *symbol;
}

const EnvironmentKind& kind_named(std::string_view name) {
    std::vector<std::string> names;
    std::string all;
    for (const EnvironmentKind& kind : environment_kinds()) {
        if (kind.name == name) return kind;
        names.push_back(kind.name);
        all += (all.empty() ? "" : ", ") + kind.name;
    }
    throw SyntaxError{name.data(), "expected one of " + all + ", found " + quoted(name) +
                                       did_you_mean(name, names)};
}

/// Whether a corner is beyond the other one in some direction.
void check_corners(const std::vector<std::string_view>& texts,
                   const std::vector<Quantity>& numbers) {
    const std::size_t dimension = numbers.size() / 2;
    for (std::size_t i = 0; i < dimension; ++i)
        if (numbers[i].value > numbers[dimension + i].value)
            throw SyntaxError{texts[dimension + i].data(),
                              "expected a number from " + to_text(numbers[i].expression) +
                                  " on, as the second corner is above the first, found " +
                                  quoted(texts[dimension + i])};
}

}  // namespace

void read_environment(const Clause& clause, Reading& reading) {
    const auto parts = pieces(clause.value());
    const char* const end = clause.text.data() + clause.text.size();
    EnvironmentSetting setting;
    setting.module = communication_symbol(parts[0], reading);
    for (const EnvironmentSetting& other : reading.system.environments)
        if (other.module == setting.module)
            throw SyntaxError{parts[0].data(),
                              "the environment of " + quoted(parts[0]) + " is given twice"};
    if (parts.size() == 1) throw unexpected("a kind of environment, such as 'position'", end);
    const EnvironmentKind& kind = kind_named(parts[1]);
    setting.kind = kind.name;
    const std::vector<std::string_view> texts(parts.begin() + 2, parts.end());
    const std::size_t most = kind.counts.back();
    if (texts.size() > most)
        throw unexpected("the end of the line" + (most == 0 ? "" : " after " + kind.numbers),
                         texts[most].data());
    if (std::count(kind.counts.begin(), kind.counts.end(), texts.size()) == 0)
        throw unexpected(kind.numbers, end);
    for (const std::string_view text : texts)
        setting.numbers.push_back(reading.quantity(parse_expression(text, reading.source)));
    if (kind.name == "clip")
        check_corners(texts, setting.numbers);
    else if (most > 0 && setting.numbers[0].value <= 0)
        throw SyntaxError{texts[0].data(), "expected a radius above 0, found " + quoted(texts[0])};
    reading.system.environments.push_back(std::move(setting));
}

}  // namespace algae
