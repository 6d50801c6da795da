#include <charconv>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "language/language.hpp"
#include "notation/detail/grammar.hpp"
#include "notation/notation.hpp"

// Statements of exercises' own: `answer is D0L`, `answer has at most 2 rules`, `figure(answer, 4) is similar to
// figure(koch, 4)`.
//
// A statement is one of these from its first two words on; what follows must then be right.

namespace algae {

namespace {

namespace x3 = grammar::x3;
using grammar::sets;
using grammar::told;
using grammar::wanted;
using grammar::word;

const auto is_answer_of_form = word("answer") >> word("is");
const auto is_answer_of_size = word("answer") >> word("has");
const auto is_about_figures = word("figure");

/// The name of a form of systems. Throws `SyntaxError`.
std::string form_named(std::string_view name) {
    if (system_form(name) || is_rewriting_family(name)) return std::string(name);
    std::vector<std::string> forms{"S0L", "parametric"};
    for (const std::string& family : common_families())
        if (system_form(family)) forms.push_back(family);
    throw unknown_word("the name of a form of systems", name, forms);
}

auto number(std::uint64_t& to) {
    const auto on_digits = told([&to](std::string_view digits) {
        const char* const end = digits.data() + digits.size();
        if (std::from_chars(digits.data(), end, to).ec != std::errc())
            throw unexpected("a number", digits.data());
    });
    return wanted("a number")[grammar::digits[on_digits]];
}

/// `figure(koch, 4)`.
auto figure(std::string_view text, FiguresAre::Figure& to) {
    constexpr const char* expected = "figure(SYSTEM, GENERATION)";
    const auto on_name = told([text, &to](std::string_view name) {
        to.system = name;
        to.offset = static_cast<std::size_t>(name.data() - text.data());
    });
    const auto name = x3::raw[x3::lexeme[+(x3::char_ - x3::char_(", )"))]];
    return wanted(expected)[word("figure")] >> wanted(expected)['('] >>
           wanted("the name of a system")[name[on_name]] >> wanted("',' and a generation")[','] >>
           number(to.generation) >> wanted("')'")[')'];
}

auto relation(FiguresAre::Relation& to) {
    using Relation = FiguresAre::Relation;
    constexpr const char* expected = "'is similar to', 'is congruent to' or '=='";
    const auto alike = word("congruent")[sets(to, Relation::congruent)] |
                       word("similar")[sets(to, Relation::similar)];
    return x3::lit("==")[sets(to, Relation::same)] |
           (wanted(expected)[word("is")] >> wanted(expected)[alike] >>
            wanted(expected)[word("to")]);
}

}  // namespace

bool is_own_statement(std::string_view text, bool of_system) {
    const char* here = text.data();
    const char* const end = here + text.size();
    return grammar::read(here, end, is_about_figures) ||
           (of_system && grammar::read(here, end, is_answer_of_form | is_answer_of_size));
}

OwnStatement read_own_statement(std::string_view text) {
    using Counted = AnswerHas::Counted;
    AnswerIs is;
    AnswerHas has;
    FiguresAre are;
    OwnStatement statement;
    const auto says = [&](const auto& said) { return x3::eps[([&](auto&) { statement = said; })]; };
    const auto on_form = told([&](std::string_view name) { is.form = form_named(name); });
    const auto of_form = is_answer_of_form >>
                         wanted("the name of a form of systems")[grammar::piece[on_form]] >>
                         says(is);
    const auto symbols = wanted("'symbols'")[word("symbols") | word("symbol")];
    const auto counted = (word("rules") | word("rule"))[sets(has.counted, Counted::rules)] |
                         (word("letters") | word("letter"))[sets(has.counted, Counted::letters)] |
                         (word("axiom")[sets(has.counted, Counted::axiom_symbols)] >> symbols);
    const auto of_size = is_answer_of_size >>
                         -(word("at")[sets(has.at_most, true)] >> wanted("'most'")[word("most")]) >>
                         number(has.count) >> wanted("rules, letters or axiom symbols")[counted] >>
                         says(has);
    const auto of_figures = &is_about_figures >> figure(text, are.left) >> relation(are.relation) >>
                            figure(text, are.right) >> says(are);
    grammar::read_all(text, of_form | of_size | of_figures, "the end of the statement");
    return statement;
}

}  // namespace algae
