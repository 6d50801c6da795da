#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "dimension/dimension.hpp"
#include "notation/detail/blank_byte.hpp"
#include "notation/detail/claim_reading.hpp"
#include "notation/detail/grammar.hpp"
#include "turtle/turtle.hpp"

// Statements of claims, and the facts of the table of closure properties.
//
// A form of statements is a rule of `StatementReader` and a row of the table `statement_forms`, in the order of which they
// are tried. A few signs tell them apart: `==>` is a derivation, and behind `P(` the probability of one; a
// word `in` outside braces separates a word from the language it is in; `growth`, `sequence`, `dimension`,
// `boundary` and `|` begin statements of their own; all else is about one or two languages. `not` may stand
// in front of any statement and in the middle of most, once in all.
//
// Derivations are of two kinds. In systems without parameters and probabilities words are strings of letters,
// over the common alphabet of the claim (`Derives`). Those of stochastic and parametric systems, and of
// systems with contexts in words that are trees, are derived module by module (`Rewrites`, `HasChance`): their
// words have values in them and are read over the system's own alphabet, to which letters that it does not
// know are added, since a claim may say that they never occur.

namespace algae {

namespace {

namespace x3 = grammar::x3;
using grammar::between;
using grammar::ByHand;
using grammar::is_one_of;
using grammar::told;
using grammar::wanted;
using grammar::word;

constexpr const char* properties =
    "a family (0L, PD0L, ET0L, regular, ...), finite, infinite, empty, a code or a prefix code";

std::string_view before(std::string_view text, std::size_t offset) {
    return text.substr(0, offset);
}

/// Reads the expression that is the rest of a statement. Throws `SyntaxError`.
Expression parse_rest(const char*& here, const char* end, const char* expectation,
                      const ClaimReading& reading) {
    const std::string_view text = between(here, end);
    if (text.empty()) throw unexpected(expectation, here);
    here = end;
    return parse_expression(text, reading.source);
}

const char* place_of(const Expression& expression, const ClaimReading& reading) {
    return reading.source.text().data() + reading.source.offset(expression.place);
}

/// Throws where the expression has no value or a value that is no number from the constants.
void check_value(const Expression& expression, const LSystem& system, const ClaimReading& reading) {
    try {
        evaluate(expression, [&](const std::string& name) -> const Quantity* {
            for (const auto& [constant, value] : system.constants)
                if (constant == name) return &value;
            return nullptr;
        });
    } catch (const Diagnostics& error) {
        throw SyntaxError{place_of(expression, reading), error.findings().front().message};
    }
}

/// A word of modules over the alphabet of the system, to which new letters are added.
ModuleWord parse_modules(std::string_view text, LSystem& system, ClaimReading& reading) {
    const std::string_view word = trimmed(text);
    if (word.empty()) throw unexpected("a word (the empty word is ε)", text.data());
    Lexicon lexicon(system.alphabet);
    for (const std::string& name : reading.long_names) lexicon.declare(name);
    const ModuleWord read = parse_word(word, lexicon, reading.source);
    for (const auto& [position, arguments] : read.arguments)
        for (const Expression& argument : arguments) check_value(argument, system, reading);
    return read;
}

/// Reads what is derived, `WORD in n steps`, by a system of these, and the word it begins with if it is no
/// axiom. Throws `SyntaxError`.
Rewrites parse_rewriting(const std::shared_ptr<const LSystem>& system,
                         const std::shared_ptr<const Model>& written,
                         const std::optional<std::string_view>& from, std::string_view word,
                         std::optional<std::uint64_t> steps, ClaimReading& reading) {
    Rewrites said;
    LSystem with_all_letters = *system;
    if (from) said.from = parse_modules(*from, with_all_letters, reading);
    said.word = parse_modules(word, with_all_letters, reading);
    if (!steps)
        throw unexpected("'in' and a number of steps, as " + system->name +
                             " has probabilities, parameters or contexts of trees",
                         word.data() + word.size());
    said.steps = *steps;
    said.system = std::make_shared<const LSystem>(std::move(with_all_letters));
    said.written = written;
    return said;
}

/// Reads `3 steps`. Throws `SyntaxError`.
std::uint64_t parse_steps(std::string_view text) {
    std::uint64_t steps = 0;
    const auto on_number = told([&](std::string_view digits) {
        const Integer number = natural_number(digits);
        if (!number.fits_uint64())
            throw SyntaxError{digits.data(), "expected a number of steps below 2^64"};
        steps = number.to_uint64();
    });
    grammar::read_all(text,
                      wanted("a number of steps")[grammar::digits[on_number]] >>
                          wanted("'steps'")[word("steps") | word("step")],
                      "the end of the statement");
    return steps;
}

/// The number of steps that an expression without names is. Throws `SyntaxError`.
std::uint64_t constant_steps(const Expression& term, std::string_view text) {
    std::optional<Rational> value;
    try {
        value = evaluate(term, [](const std::string&) -> const Quantity* { return nullptr; }).exact;
    } catch (const Diagnostics& error) {
        throw SyntaxError{text.data(), error.findings().front().message};
    }
    if (!value || !value->is_integer() || !value->numerator().fits_uint64())
        throw SyntaxError{
            text.data(),
            "expected a whole number of steps from 0 to 2^64 - 1, found " + quoted(text)};
    return value->numerator().to_uint64();
}

/// Reads `G ==> W in 3 steps` or `G : U ==> W`. Throws `SyntaxError`.
std::variant<Derives, Rewrites> parse_derivation(std::string_view text, ClaimReading& reading) {
    const std::size_t arrow = text.find("==>");
    if (arrow == std::string_view::npos)
        throw unexpected("a derivation such as 'G ==> ab in 3 steps'", text.data());
    const std::string_view left = before(text, arrow);
    const std::size_t colon = left.find(':');
    const std::string_view name = trimmed(before(left, colon));
    if (name.empty()) throw unexpected("the name of a system", text.data());
    std::optional<std::string_view> from;
    if (colon != std::string_view::npos) from = left.substr(colon + 1);
    std::string_view word = text.substr(arrow + 3);
    std::optional<std::uint64_t> steps;
    std::optional<Expression> bound_steps;
    std::vector<BoundName> numbers;
    if (const std::size_t in = find_word(word, "in"); in != std::string_view::npos) {
        const std::string_view count = word.substr(in + 2);
        const std::size_t last = find_word(count, "steps");
        const bool is_term =
            last != std::string_view::npos &&
            before(count, last).find_first_not_of("0123456789 \t") != std::string_view::npos;
        if (is_term && trimmed(count).ends_with("steps")) {
            const std::string_view term = trimmed(before(count, last));
            bound_steps = parse_number_term(term, numbers, reading);
            if (numbers.empty()) {
                steps = constant_steps(*bound_steps, term);
                bound_steps.reset();
            }
        } else {
            steps = parse_steps(count);
        }
        word = before(word, in);
    }
    if (const auto rewriting = reading.rewriting(name))
        return parse_rewriting(rewriting, reading.written(name), from, word, steps, reading);
    Derives said{reading.system(name), {}, {}, steps, std::move(bound_steps), std::move(numbers)};
    if (from) said.from = parse_claimed_word(*from, reading);
    said.word = parse_claimed_word(word, reading);
    return said;
}

/// The bracket that closes the first one of the text.
std::size_t closing_bracket(std::string_view text) {
    std::size_t depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '(') ++depth;
        if (text[i] == ')' && --depth == 0) return i;
    }
    throw SyntaxError{text.data() + text.find('('), "'(' is never closed"};
}

/// Reads one statement by the rules of its forms. A rule does not match where a statement begins in another way; behind
/// its first token it throws `SyntaxError` or `DependsOnError` where the text is wrong.
class StatementReader {
    /// `!=`.
    auto unequal() { return x3::lit("!=")[grammar::sets(statement_.negated, true)]; }
    /// `!=` or `=`.
    auto is(const char* expectation) { return unequal() | wanted(expectation)['=']; }

    auto language(Language& to, bool between_bars = false) {
        return grammar::into(to, [this, between_bars](const char*& here, const char* end) {
            return parse_language(here, end, reading_, between_bars).language;
        });
    }
    /// A word and a system between brackets, `growth(G)`; `opening` is expected if there are none.
    template <class OnName>
    auto of_system(const char* of, const char* opening, OnName on_name) {
        return word(of) >> wanted(opening)['('] >>
               wanted("the name of a system")[grammar::claim_name[told(on_name)]] >>
               wanted("')'")[')'];
    }
    auto system_of(const char* of, std::shared_ptr<const SourceSystem>& to) {
        const bool growth = of == std::string_view("growth");
        return of_system(of, growth ? "'(' after 'growth'" : "'(' after 'sequence'",
                         [this, &to](std::string_view name) { to = reading_.system(name); });
    }
    template <class Tell>
    static auto number(const char* what, Tell tell) {
        return wanted(what)[grammar::digits[told(
            [tell](std::string_view digits) { tell(natural_number(digits)); })]];
    }
    /// The statement says this.
    template <class Form>
    auto says(Form& said) {
        return x3::eps[([this, &said](auto&) { statement_.says = said; })];
    }
    template <class Grammar>
    bool read(const Grammar& grammar) {
        return grammar::read_all(text_, grammar, "the end of the statement");
    }

    bool is_derivation() const { return text_.find("==>") != std::string_view::npos; }

    /// What is derived with a probability. Throws `SyntaxError` if that is not a matter of chance.
    Rewrites probable(std::string_view text) {
        const auto derivation = parse_derivation(text, reading_);
        const char* const where = text.data() + text.find_first_not_of(' ');
        if (const auto* said = std::get_if<Derives>(&derivation))
            throw SyntaxError{
                where, "expected a system with probabilities (S0L, PS0L, parametric), found '" +
                           said->system->name + "', which has none"};
        const Rewrites& said = std::get<Rewrites>(derivation);
        if (class_of(*said.system).open)
            throw SyntaxError{where, "expected a system without communication modules, found '" +
                                         said.system->name +
                                         "', whose environments leave nothing to chance"};
        return said;
    }

    template <class Form>
    bool dimension_of(const char* of, const char* opening) {
        Form said;
        const auto on_name = [&](std::string_view name) {
            said.system = reading_.written(name);
            said.name = name;
        };
        const auto value =
            grammar::into(said.dimension.value, [](const char*& here, const char* end) {
                return std::make_shared<const DimensionValue>(parse_dimension_value(here, end));
            });
        const auto on_value =
            told([&](std::string_view text) { said.dimension.text = trimmed(text); });
        return read(of_system(of, opening, on_name) >>
                    (x3::lit("<=")[grammar::sets(said.dimension.comparison, Comparison::at_most)] |
                     x3::lit(">=")[grammar::sets(said.dimension.comparison, Comparison::at_least)] |
                     is("'=', '!=', '<=' or '>=' and a number")) >>
                    x3::raw[value][on_value] >> says(said));
    }

    /// `A is ...`, from behind that.
    void property(std::string_view found, const Language& language) {
        if (found == "finite" || found == "infinite") {
            statement_.says = IsFinite{language};
            statement_.negated = statement_.negated != (found == "infinite");
        } else if (found == "empty") {
            statement_.says = IsEmpty{language};
        } else if (const auto family = language_family(found)) {
            statement_.says = InFamily{language, *family};
        } else {
            std::vector<std::string> candidates = common_families();
            candidates.insert(candidates.end(), {"finite", "infinite", "empty"});
            throw unknown_word(properties, found, candidates);
        }
    }

    std::string_view text_;
    Statement& statement_;
    ClaimReading& reading_;

public:
    StatementReader(std::string_view text, Statement& statement, ClaimReading& reading)
        : text_(text), statement_(statement), reading_(reading) {}

    /// `P(G ==> W in n steps) = NUMBER`, or `!=`.
    bool chance() {
        const char* inside = text_.data();
        const char* const end = inside + text_.size();
        if (!is_derivation() || !grammar::read(inside, end, word("P") >> '(')) return false;
        const std::size_t open = text_.find('('), close = closing_bracket(text_);
        HasChance said{probable(text_.substr(open + 1, close - open - 1)), {}};
        const auto probability = ByHand([&](const char*& here, const char* last) {
            const std::string_view number = between(here, last);
            const Expression expression =
                parse_rest(here, last, "a probability, such as 1/9", reading_);
            check_value(expression, LSystem{}, reading_);
            const Quantity value = evaluate(expression, {});
            if (!value.exact || *value.exact < 0 || *value.exact > 1)
                throw SyntaxError{
                    number.data(),
                    "expected a probability, an exact number from 0 to 1, found " + quoted(number)};
            said.probability = *value.exact;
        });
        text_ = text_.substr(close + 1);
        return read(is("'=' or '!=' and a probability") >> probability >> says(said));
    }

    /// `G ==> W in 3 steps`.
    bool derivation() {
        if (!is_derivation()) return false;
        std::visit([&](auto&& said) { statement_.says = std::move(said); },
                   parse_derivation(text_, reading_));
        return true;
    }

    /// `ab in A`, `ab not in A`.
    bool membership() {
        const std::size_t in = find_word(text_, "in");
        if (in == std::string_view::npos) return false;
        std::string_view word = before(text_, in);
        const std::string_view left = trimmed(word);
        statement_.negated =
            left == "not" || (left.ends_with("not") && is_blank_byte(left[left.size() - 4]));
        if (statement_.negated) word = between(text_.data(), left.data() + left.size() - 3);
        HasWord said{nullptr, parse_claimed_word(word, reading_)};
        reading_.add_letters(said.word);
        text_ = text_.substr(in + 2);
        return read(language(said.language) >> says(said));
    }

    /// `abba is a palindrome`, `abab is not a palindrome`.
    bool palindrome() {
        const std::size_t is = find_word(text_, "is");
        if (is == std::string_view::npos) return false;
        bool denied = false;
        const char* here = text_.data() + is;
        const char* const end = text_.data() + text_.size();
        const auto says_so = word("is") >> -word("not")[grammar::sets(denied, true)] >> word("a") >>
                             word("palindrome");
        if (!grammar::read(here, end, says_so)) return false;
        if (here != end) throw unexpected("the end of the statement", here);
        const std::string_view name = trimmed(before(text_, is));
        if (const ClaimName* known = is_claim_name(name) ? reading_.find(name) : nullptr;
            known && known->kind != ClaimName::Kind::word)
            throw SyntaxError{name.data(), "expected a word, found the name " + quoted(name)};
        statement_.negated = denied;
        IsPalindrome said{parse_claimed_word(before(text_, is), reading_)};
        reading_.add_letters(said.word);
        statement_.says = std::move(said);
        return true;
    }

    /// `sequence(G) == sequence(H)`, or `!=`.
    bool sequences() {
        EqualSequences said;
        return read(
            system_of("sequence", said.left) >> wanted("'==' or '!='")["==" | unequal()] >>
            wanted("'sequence' and a system between brackets")[system_of("sequence", said.right)] >>
            says(said));
    }

    /// `growth(G) = 2^n`, `growth(G) ~ exponential`, `growth(G) == growth(H)`.
    bool growth() {
        HasGrowthClass by_class;
        EqualGrowth equal;
        const auto on_class = told([&](std::string_view found) {
            static const std::vector<std::string> all{"zero", "bounded", "polynomial",
                                                      "exponential"};
            if (!is_one_of(all, found))
                throw unknown_word("zero, bounded, polynomial or exponential", found, all);
            by_class = {equal.left, std::string(found)};
        });
        const auto has_degree = [&](auto& c) { x3::_pass(c) = by_class.growth == "polynomial"; };
        const auto refuse = told([](std::string_view at) {
            throw SyntaxError{at.data(), "expected '==' before another growth, found '='"};
        });
        const auto formula = ByHand([&](const char*& here, const char* end) {
            parse_growth_formula(equal.left, between(here, end), statement_, reading_);
            here = end;
        });
        const auto is_equal =
            ("==" | unequal()) >>
            wanted("'growth' and a system between brackets")[system_of("growth", equal.right)] >>
            says(equal);
        const auto degree = x3::eps[has_degree] >> !x3::eoi >>
                            number("a degree", [&](Integer read) { by_class.degree = read; });
        const auto is_of_class =
            '~' >>
            wanted("zero, bounded, polynomial or exponential")[grammar::claim_name[on_class]] >>
            -degree >> says(by_class);
        const auto has_formula =
            wanted("'=', '==', '!=' or '~'")['='] >> -x3::raw[word("growth")][refuse] >> formula;
        return read(system_of("growth", equal.left) >> (is_equal | is_of_class | has_formula));
    }

    /// `growth(G) is strictly increasing`.
    bool increasing() {
        const char* inside = text_.data();
        const char* const end = inside + text_.size();
        IsIncreasing said;
        const auto ignore = [](std::string_view) {};
        if (!grammar::read(inside, end,
                           of_system("growth", "'(' after 'growth'", ignore) >> word("is")))
            return false;
        return read(system_of("growth", said.system) >> word("is") >>
                    -word("not")[grammar::sets(statement_.negated, true)] >>
                    -word("strictly")[grammar::sets(said.strictly, true)] >>
                    wanted("'increasing' or 'strictly increasing'")[word("increasing")] >>
                    says(said));
    }

    /// `length(G, n + 1) = 2*length(G, n)`.
    bool numbers() { return parse_numbers(text_, statement_, reading_); }

    /// `word(F, n + 2) == word(F, n + 1) word(F, n)`.
    bool words() { return parse_words(text_, statement_, reading_); }

    /// `dimension(G) = log 4 / log 3`, of the limit set that a system draws.
    bool dimension() { return dimension_of<HasDimension>("dimension", "'(' after 'dimension'"); }

    /// `boundary(G) = log 2 / log sqrt 3`, the dimension of its boundary.
    bool boundary() {
        return dimension_of<BoundaryHasDimension>("boundary", "'(' after 'boundary'");
    }

    /// `f is overlap-free`, of its infinite word.
    bool word_property() { return parse_word_property(text_, statement_, reading_); }

    /// `complexity(f, n) = n + 1`.
    bool complexities() { return parse_complexities(text_, statement_, reading_); }

    /// `critical_exponent(f) = 2 + (1+sqrt(5))/2`.
    bool critical_exponent() { return parse_critical_exponent(text_, statement_, reading_); }

    /// `abba in factors(f)`.
    bool factor() { return parse_factor(text_, statement_, reading_); }

    /// `|A| = 3`, or `!=`.
    bool size() {
        HasSize said;
        return read('|' >> language(said.language, true) >>
                    wanted("an operator or '|' and '='")['|'] >> is("'=' and a number of words") >>
                    number("a number of words", [&](Integer read) { said.size = read; }) >>
                    says(said));
    }

    /// `A is 0L`, `A == B`, `A <= B`.
    bool languages() {
        EqualLanguages equal;
        IncludedIn included;
        IsCode code;
        const auto on_property = told([&](std::string_view found) { property(found, equal.left); });
        const auto is_code = word("a") >> -word("prefix")[grammar::sets(code.prefix, true)] >>
                             wanted("'code' or 'prefix code' after 'a'")[word("code")] >>
                             x3::eps[([&](auto&) { code.language = equal.left; })] >> says(code);
        const auto is_property = word("is") >>
                                 -word("not")[grammar::sets(statement_.negated, true)] >>
                                 (is_code | wanted(properties)[grammar::piece[on_property]]);
        const auto is_equal = ("==" | unequal()) >> language(equal.right) >> says(equal);
        const auto is_included =
            wanted("an operator, 'is', '==', '!=' or '<='")["<="] >> language(included.outer) >>
            x3::eps[([&](auto&) { included.inner = equal.left; })] >> says(included);
        return read(language(equal.left) >> (is_property | is_equal | is_included));
    }
};

/// A form of statements: how it is written, and its rule.
struct StatementForm {
    const char* written;
    bool (StatementReader::*rule)();
};

/// All forms, in the order in which they are tried.
constexpr StatementForm statement_forms[] = {
    {"P(G ==> w in 3 steps) = 1/9", &StatementReader::chance},
    {"G ==> w in 3 steps", &StatementReader::derivation},
    {"word(F, n + 2) == word(F, n + 1) word(F, n)", &StatementReader::words},
    {"abba in factors(G)", &StatementReader::factor},
    {"ab in A", &StatementReader::membership},
    {"abba is a palindrome", &StatementReader::palindrome},
    {"f is overlap-free", &StatementReader::word_property},
    {"complexity(f, n) = n + 1", &StatementReader::complexities},
    {"critical_exponent(f) = 2 + (1+sqrt(5))/2", &StatementReader::critical_exponent},
    {"sequence(G) == sequence(H)", &StatementReader::sequences},
    {"growth(G) is strictly increasing", &StatementReader::increasing},
    {"growth(G) = 2^n + 1", &StatementReader::growth},
    {"length(G, n + 1) = 2*length(G, n)", &StatementReader::numbers},
    {"dimension(G) = log 4 / log 3", &StatementReader::dimension},
    {"boundary(G) = log 2 / log sqrt 3", &StatementReader::boundary},
    {"|A| = 3", &StatementReader::size},
    {"A is 0L", &StatementReader::languages}};

}  // namespace

std::vector<std::string> written_statements() {
    std::vector<std::string> all;
    for (const StatementForm& form : statement_forms) all.emplace_back(form.written);
    return all;
}

Statement parse_single_statement(std::string_view text, ClaimReading& reading) {
    Statement statement;
    statement.text = trimmed(text);
    statement.place = reading.source.place(text.data());
    bool denied = false;
    const char* here = text.data();
    const char* const end = here + text.size();
    grammar::read(here, end, -word("not")[grammar::sets(denied, true)]);
    if (here == end) throw unexpected("a statement", here);
    StatementReader reader(between(here, end), statement, reading);
    for (const StatementForm& form : statement_forms)
        if ((reader.*form.rule)()) break;
    if (denied && statement.negated)
        throw SyntaxError{here, "expected at most one negation, found a second behind 'not'"};
    statement.negated = denied != statement.negated;
    return statement;
}

bool is_closure_fact(std::string_view text) {
    const char* here = text.data();
    return grammar::read(here, here + text.size(), -word("not") >> word("closed"));
}

ClosureFact parse_closure_fact(std::string_view text, const ClaimReading& reading) {
    ClosureFact fact;
    fact.closed = true;
    fact.place = reading.source.place(text.data());
    const char* where = nullptr;  // the operation stands
    const auto on_word = told([&](std::string_view word) {
        if (fact.operation.empty()) where = word.data();
        fact.operation += (fact.operation.empty() ? "" : " ") + std::string(word);
    });
    const auto on_operation = [&](auto&) {
        if (!is_one_of(closure_operations(), fact.operation))
            throw SyntaxError{where, "expected an operation (" + listed(closure_operations()) +
                                         "), found " + algae::quoted(fact.operation) +
                                         did_you_mean(fact.operation, closure_operations())};
    };
    const auto on_family = told([&](std::string_view family) {
        if (!is_one_of(closure_families(), family))
            throw unknown_word("a family of the table (" + listed(closure_families()) + ")", family,
                               closure_families());
        if (is_one_of(fact.families, family))
            throw SyntaxError{family.data(),
                              "the family " + std::string(family) + " stands there twice"};
        fact.families.emplace_back(family);
    });
    const auto operation_word = x3::raw[x3::lexeme[+(x3::char_ - ':' - grammar::blank)]];
    grammar::read_all(text,
                      -word("not")[grammar::sets(fact.closed, false)] >> word("closed") >>
                          wanted("'under' after 'closed'")[word("under")] >>
                          wanted("an operation")[+operation_word[on_word]] >>
                          x3::eps[on_operation] >> wanted("':' and families")[x3::lit(':')] >>
                          wanted("a family")[+grammar::piece[on_family]],
                      "a family");
    return fact;
}

namespace {

constexpr std::string_view formal_folder = "formal/";

/// What theory/formal/table.txt has of a cell: the sign and the theorem.
std::pair<std::string_view, std::string_view> formal_cell(const std::string& operation,
                                                          const std::string& family) {
    const std::string cell = "\n" + operation + "; " + family + "; ";
    for (const GalleryEntry& entry : formal_texts()) {
        if (entry.path != "theory/formal/table.txt") continue;
        const std::size_t at = entry.text.find(cell);
        if (at == std::string_view::npos) break;
        const std::string_view rest = entry.text.substr(at + cell.size());
        const std::string_view line = rest.substr(0, rest.find('\n'));
        const std::size_t middle = line.find("; ");
        return {line.substr(0, middle), line.substr(middle + 2)};
    }
    return {"open", "-"};
}

}  // namespace

bool is_formal_theorem(std::string_view citation) { return citation.starts_with(formal_folder); }

void set_formal_theorem(ClosureFact& fact, std::string_view citation) {
    if (!is_formal_theorem(citation))
        throw SyntaxError{citation.data(),
                          "expected a theorem of theory/formal, as "
                          "formal/Star.v:not_closed_under_star, found " +
                              quoted(citation)};
    for (const std::string& family : fact.families) {
        const auto [sign, theorem] = formal_cell(fact.operation, family);
        const std::string cell = family + " under " + fact.operation;
        if (sign == "open")
            throw SyntaxError{citation.data(), "theory/formal has no theorem on " + cell};
        if ((sign == "closed") != fact.closed)
            throw SyntaxError{citation.data(),
                              "expected a statement that theory/formal proves, which has " + cell +
                                  ": " + std::string(sign)};
        if (citation.substr(formal_folder.size()) != theorem)
            throw SyntaxError{citation.data(), "expected " + std::string(formal_folder) +
                                                   std::string(theorem) + ", the theorem on " +
                                                   cell + ", found " + quoted(citation)};
    }
    fact.theorem = citation;
}

}  // namespace algae
