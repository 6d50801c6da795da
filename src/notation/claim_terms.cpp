#include <algorithm>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/model.hpp"
#include "notation/detail/blank_byte.hpp"
#include "notation/detail/claim_reading.hpp"
#include "notation/detail/grammar.hpp"
#include "turtle/turtle.hpp"

// Statements of claims about numbers and words that may depend on numbers: `length(G, n + 2) = length(G, n + 1) + length(G, n)`,
// `count(G, F, n) = 4^n`, `segments(G, n) = 3*4^n`, `word(F, n + 2) == word(F, n + 1) word(F, n)`, `h(word(G, n)) ==
// word(H, n)`.
//
// A term is an expression whose names are bound numbers and whose calls are `length`, `count`, `segments`, `distinct segments`, `boxes`
// and `sqrt`. Segments are read as a sum of counts of the letters that draw; the others of figures keep the system with its turtle. A name that nothing binds ranges over 0, 1, ...: the statement is then about
// all of these, as textbooks mean it.
//
// A word is a product of factors: `word(G, E)`, letters, images `h(...)` and `{ a -> b }(...)` of factors, brackets, powers `^2`
// and reversals `^R`. Images and reversals are moved inwards until each factor has its own.

namespace algae {

namespace {

using grammar::between;

/// The offset of the first of these signs or words outside brackets, and which it is.
struct Found {
    std::size_t at = std::string_view::npos;
    std::size_t size = 0;
    std::size_t which = 0;
};

template <std::size_t count>
Found first_outside(std::string_view text, const std::string_view (&signs)[count]) {
    std::size_t depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char byte = text[i];
        if (byte == '(' || byte == '{' || byte == '[') ++depth;
        if ((byte == ')' || byte == '}' || byte == ']') && depth > 0) --depth;
        if (depth > 0) continue;
        std::size_t which = 0;
        for (const std::string_view sign : signs) {
            if (text.substr(i).starts_with(sign)) return {i, sign.size(), which};
            ++which;
        }
    }
    return {};
}

/// Whether a name with '(' behind it stands in the text outside braces and is not defined by the claim.
bool calls(std::string_view text, std::string_view name, const ClaimReading& reading) {
    std::size_t depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '{') ++depth;
        if (text[i] == '}' && depth > 0) --depth;
        if (depth > 0 || !text.substr(i).starts_with(name)) continue;
        if (i > 0 && is_claim_name(text.substr(i - 1, 1))) continue;  // within another name
        std::size_t behind = i + name.size();
        while (behind < text.size() && is_blank_byte(text[behind])) ++behind;
        if (behind < text.size() && text[behind] == '(' &&
            !reading.find(text.substr(i, name.size())))
            return true;
    }
    return false;
}

const ExpressionDialect& term_dialect() {
    using Binding = ExpressionDialect::Binding;
    static const ExpressionDialect dialect{{{"+", "+", Binding::sum},
                                            {"-", "-", Binding::sum},
                                            {"*", "*", Binding::product},
                                            {"/", "/", Binding::product},
                                            {"^", "^", Binding::power}},
                                           {{"-", "-", Binding::prefix}}};
    return dialect;
}

Expression made(Expression::Kind kind, std::string name, std::vector<Expression> operands,
                Place place) {
    Expression expression;
    expression.kind = kind;
    expression.name = std::move(name);
    expression.operands = std::move(operands);
    expression.place = std::move(place);
    return expression;
}

constexpr const char* forms =
    "length(G, n), count(G, a, n), segments(G, n), distinct segments(G, 3), boxes(G, 3, 1), "
    "sqrt(2)";

/// Reads terms; keeps the systems and the numbers that they name.
class TermReader {
public:
    explicit TermReader(ClaimReading& reading) : reading_(reading) {}

    /// Up to where the term cannot go on.
    Expression term(const char*& here, const char* end) {
        constexpr std::size_t deepest = 100;
        if (++depth_ > deepest) throw SyntaxError{here, "more than 100 brackets inside each other"};
        ExpressionReader reader;
        reader.next = [end](const char* at) {
            while (at != end && is_blank_byte(*at)) ++at;
            return at;
        };
        reader.operand = [this, end](const char*& at) { return operand(at, end); };
        reader.met = [](const char*) {};
        Expression read = read_expression(here, end, reading_.source, term_dialect(), reader);
        here = reader.next(here);
        --depth_;
        return read;
    }

    Expression whole(std::string_view text) {
        const char* here = text.data();
        const char* const end = here + text.size();
        Expression read = term(here, end);
        if (here != end) throw unexpected("an operator", here);
        return read;
    }

    const std::vector<std::shared_ptr<const SourceSystem>>& systems() const { return systems_; }
    const std::vector<BoundName>& numbers() const { return numbers_; }
    const std::map<std::string, std::shared_ptr<const Model>>& turtles() const { return turtles_; }
    /// The names of those that nothing binds.
    const std::vector<std::string>& bare() const { return bare_; }

    /// The statement, about all values of the numbers that nothing binds.
    void finish(Statement& statement, std::size_t first) const {
        if (bare_.empty()) return;
        Quantified all;
        all.first = first;
        for (const std::string& name : bare_) {
            QuantifiedName number;
            number.name = name;
            number.domain.kind = Domain::Kind::number;
            number.text = "numbers";
            all.bindings.push_back(std::move(number));
        }
        Statement body = statement;
        body.negated = false;
        all.body.push_back(std::move(body));
        statement.says = std::move(all);
    }

    /// The system whose name stands next, before `,`.
    std::shared_ptr<const SourceSystem> system(const char*& here, const char* end) {
        const std::string_view name = piece(here, end, "the name of a system");
        auto found = reading_.system(name);
        if (std::find(systems_.begin(), systems_.end(), found) == systems_.end())
            systems_.push_back(found);
        return found;
    }

    void expect(char byte, const char* expectation, const char*& here, const char* end) const {
        while (here != end && is_blank_byte(*here)) ++here;
        if (here == end || *here != byte) throw unexpected(expectation, here);
        ++here;
    }

private:
    /// What stands before the next `,`, `(` or `)`.
    std::string_view piece(const char*& here, const char* end, const char* expectation) const {
        while (here != end && is_blank_byte(*here)) ++here;
        const char* const begin = here;
        while (here != end && *here != ',' && *here != ')' && *here != '(') ++here;
        const std::string_view found = trimmed(between(begin, here));
        if (found.empty()) throw unexpected(expectation, begin);
        return found;
    }

    Expression operand(const char*& here, const char* end) {
        static const std::string expectation = std::string("a number, n, '(', or one of ") + forms;
        if (here == end) throw unexpected(expectation, here);
        const char* const where = here;
        const Place place = reading_.source.place(where);
        if (*here == '(') {
            Expression inner = term(++here, end);
            expect(')', "an operator or ')'", here, end);
            return inner;
        }
        if (is_digit(static_cast<unsigned char>(*here)) || *here == '.') {
            while (here != end && (is_digit(static_cast<unsigned char>(*here)) || *here == '.'))
                ++here;
            constexpr std::size_t longest = 1000;
            const std::string_view digits = between(where, here);
            if (digits.size() > longest)
                throw SyntaxError{where, "a number of more than 1000 characters"};
            Expression number;
            number.place = place;
            try {
                number.value = Rational(digits);
            } catch (const Error& error) {
                throw SyntaxError{where, error.what()};
            }
            return number;
        }
        while (here != end && is_claim_name(between(where, here + 1))) ++here;
        const std::string_view name = between(where, here);
        if (name.empty()) throw unexpected(expectation, where);
        const char* behind = here;
        skip(behind, end);
        const bool is_distinct = name == "distinct" && between(behind, end).starts_with("segments");
        if (is_distinct) {
            behind += std::string_view("segments").size();
            skip(behind, end);
        }
        if (behind == end || *behind != '(') {
            if (is_distinct)
                throw unexpected("'(' and a system behind 'distinct segments'", behind);
            return number_called(name, place);
        }
        here = behind + 1;
        return call(is_distinct ? "distinct segments" : name, where, here, end, place);
    }

    static void skip(const char*& here, const char* end) {
        while (here != end && is_blank_byte(*here)) ++here;
    }

    Expression number_called(std::string_view name, const Place& place) {
        const ClaimName* known = reading_.find(name);
        if (known && known->kind != ClaimName::Kind::number)
            throw SyntaxError{name.data(), "expected a number, found " + quoted(name) +
                                               ", which is something else"};
        const auto is_it = [&](const BoundName& one) { return one.name == name; };
        if (std::none_of(numbers_.begin(), numbers_.end(), is_it)) {
            if (!known) bare_.emplace_back(name);
            numbers_.push_back(
                {known ? *known->variable : reading_.uses.size(), std::string(name)});
            if (!known) reading_.uses.emplace_back();
        }
        return made(Expression::Kind::name, std::string(name), {}, place);
    }

    /// The call of the function, which is written at `at`, its bracket being read.
    Expression call(std::string_view name, const char* at, const char*& here, const char* end,
                    const Place& place) {
        if (name == "sqrt") {
            Expression root = made(Expression::Kind::call, "sqrt", {term(here, end)}, place);
            expect(')', "an operator or ')'", here, end);
            return root;
        }
        static const std::vector<std::string> known{
            "length", "count", "segments", "distinct segments", "boxes", "sqrt"};
        if (!grammar::is_one_of(known, name))
            throw SyntaxError{at, std::string("expected one of ") + forms + ", found " +
                                      quoted(name) + did_you_mean(name, known)};
        const char* where = here;
        if (name == "length")
            if (auto word = bound_word(here, end)) {
                expect(')', "')' behind the word", here, end);
                return made(Expression::Kind::call, "length", {std::move(*word)}, place);
            }
        const auto of = system(here, end);
        Expression system =
            made(Expression::Kind::name, of->name, {}, reading_.source.place(where));
        expect(',', name == "count" ? "',' and a letter" : "',' and the number of a generation",
               here, end);
        std::optional<Expression> letter;
        if (name == "count") {
            where = here;
            const std::string_view written = piece(here, end, "a letter");
            const auto symbol = reading_.alphabet->find(written);
            const bool is_bound = symbol && std::count(reading_.bound_letters.begin(),
                                                       reading_.bound_letters.end(), *symbol) > 0;
            if (!symbol || is_bound)
                throw SyntaxError{written.data(),
                                  "expected a letter of the claim, found " + quoted(written)};
            letter = made(Expression::Kind::name, std::string(written), {},
                          reading_.source.place(where));
            expect(',', "',' and the number of a generation", here, end);
        }
        Expression generation = term(here, end);
        const bool is_boxes = name == "boxes";
        std::optional<Expression> side;
        if (is_boxes) {
            expect(',', "an operator, or ',' and the side of the boxes in steps", here, end);
            side = term(here, end);
        }
        expect(')', "an operator or ')'", here, end);
        if (name == "segments") return segments(system, generation, place);
        if (is_boxes || name == "distinct segments") keep_turtle(of, system, is_boxes);
        std::vector<Expression> operands{std::move(system)};
        if (letter) operands.push_back(std::move(*letter));
        operands.push_back(std::move(generation));
        if (side) operands.push_back(std::move(*side));
        return made(Expression::Kind::call, std::string(name), std::move(operands), place);
    }

    /// The name of a bound word or letter that stands next; nothing if another name does.
    std::optional<Expression> bound_word(const char*& here, const char* end) const {
        const char* at = here;
        const std::string_view name = piece(at, end, "a system or a bound word");
        const ClaimName* known = is_claim_name(name) ? reading_.find(name) : nullptr;
        if (!known || known->kind != ClaimName::Kind::word) return std::nullopt;
        here = at;
        return made(Expression::Kind::name, std::string(name), {},
                    reading_.source.place(name.data()));
    }

    /// Where the name of a system stands.
    std::string_view text_of(const Expression& system) const {
        return {reading_.source.text().data() + reading_.source.offset(system.place),
                system.name.size()};
    }

    [[noreturn]] static void no_turtle(std::string_view name, const Error& why) {
        throw SyntaxError{name.data(), "expected a D0L system with a turtle in the plane, found " +
                                           quoted(name) + ": " + why.what()};
    }

    /// Notes the turtle of a system whose different segments, or boxes, are counted.
    void keep_turtle(const std::shared_ptr<const SourceSystem>& of, const Expression& system,
                     bool boxes) {
        const std::string_view name = text_of(system);
        auto model = reading_.written(name);
        try {
            check_lattice_turtle(*model, boxes);
        } catch (const Error& error) {
            no_turtle(name, error);
        }
        turtles_[of->name] = std::move(model);
    }

    /// How many segments a generation draws: a sum of how often the letters that draw occur.
    Expression segments(const Expression& system, const Expression& generation,
                        const Place& place) const {
        const std::string_view name = text_of(system);
        const auto model = reading_.written(name);
        std::optional<Expression> sum;
        try {
            const View<D0L> rules = as_d0l(static_cast<const LSystem&>(*model));
            if (!rules) throw Error(rules.reason());
            const Commands commands(*model, rules->letters);
            if (commands.uses(Command::cut))
                throw Error("it cuts branches, so that not all segments are drawn");
            for (const Symbol letter : rules->letters) {
                const Integer drawn = drawn_segments(commands, {letter}, {Integer(1)});
                if (drawn.is_zero()) continue;
                Expression one = made(
                    Expression::Kind::call, "count",
                    {system, made(Expression::Kind::name, rules->alphabet->name(letter), {}, place),
                     generation},
                    place);
                if (drawn != Integer(1)) {
                    Expression times;
                    times.value = Rational(drawn);
                    one = made(Expression::Kind::binary, "*", {times, one}, place);
                }
                sum = sum ? made(Expression::Kind::binary, "+", {*sum, one}, place) : one;
            }
        } catch (const Error& error) {
            no_turtle(name, error);
        }
        return sum.value_or(Expression{});
    }

    ClaimReading& reading_;
    std::vector<std::shared_ptr<const SourceSystem>> systems_;
    std::vector<BoundName> numbers_;
    std::vector<std::string> bare_;  // of these, what nothing binds
    std::map<std::string, std::shared_ptr<const Model>> turtles_;
    std::size_t depth_ = 0;
};

/// Reads one side of a comparison of words.
class WordReader {
public:
    WordReader(ClaimReading& reading, TermReader& terms) : reading_(reading), terms_(terms) {}

    std::vector<WordFactor> whole(std::string_view text) {
        const char* here = text.data();
        const char* const end = here + text.size();
        std::vector<WordFactor> read = product(here, end);
        if (here != end) throw unexpected("a word", here);
        return read;
    }

private:
    using Factors = std::vector<WordFactor>;
    static constexpr std::size_t most_factors = 1000;

    static void skip(const char*& here, const char* end) {
        while (here != end && is_blank_byte(*here)) ++here;
    }

    Factors product(const char*& here, const char* end) {
        constexpr std::size_t deepest = 100;
        if (++depth_ > deepest) throw SyntaxError{here, "more than 100 brackets inside each other"};
        Factors all;
        const char* const begin = here;
        for (skip(here, end); here != end && *here != ')'; skip(here, end)) {
            Factors more = with_powers(operand(here, end), here, end);
            all.insert(all.end(), more.begin(), more.end());
            if (all.size() > most_factors) throw SyntaxError{begin, "more than 1000 factors"};
        }
        if (all.empty()) {
            const std::string_view read = trimmed(between(begin, here));
            if (read.empty()) throw unexpected("a word, such as word(G, n) or ab", begin);
        }
        --depth_;
        return all;
    }

    Factors bracketed(const char*& here, const char* end) {
        terms_.expect('(', "'(' and a word", here, end);
        Factors inner = product(here, end);
        terms_.expect(')', "')'", here, end);
        return inner;
    }

    Factors operand(const char*& here, const char* end) {
        if (*here == '(') return bracketed(here, end);
        if (*here == '{') {
            if (!is_morphism(here, end))
                throw unexpected("a word or a morphism such as { a -> ab }", here);
            const Morphism morphism = parse_morphism(here, end, reading_);
            return image(bracketed(here, end), morphism);
        }
        const char* const where = here;
        while (here != end && !is_blank_byte(*here) && *here != '(' && *here != ')' &&
               *here != '^' && *here != '{')
            ++here;
        const std::string_view text = between(where, here);
        if (here != end && *here == '(') {
            if (text == "word") return {generation(here, end)};
            const ClaimName& known = reading_.expect(text);
            if (known.kind != ClaimName::Kind::morphism || known.variable)
                throw SyntaxError{
                    where, "expected 'word' or a morphism that is defined, found " + quoted(text)};
            return image(bracketed(here, end), known.morphism);
        }
        if (text.empty()) throw unexpected("a word", where);
        WordFactor letters;
        letters.word = parse_claimed_word(text, reading_);
        reading_.add_letters(letters.word);
        return letters.word.empty() ? Factors{} : Factors{letters};
    }

    WordFactor generation(const char*& here, const char* end) {
        WordFactor factor;
        ++here;  // the bracket
        factor.system = terms_.system(here, end);
        terms_.expect(',', "',' and the number of a generation", here, end);
        factor.generation = terms_.term(here, end);
        terms_.expect(')', "an operator or ')'", here, end);
        return factor;
    }

    static Factors image(Factors factors, const Morphism& morphism) {
        Morphism backwards;
        for (const Symbol a : morphism.domain()) {
            Word image = morphism[a];
            std::reverse(image.begin(), image.end());
            backwards.add(a, image);
        }
        for (WordFactor& factor : factors)
            factor.images.push_back(factor.reversed ? backwards : morphism);
        return factors;
    }

    /// `^R` and `^3` behind an operand.
    Factors with_powers(Factors factors, const char*& here, const char* end) {
        while (here != end && *here == '^') {
            const char* const where = ++here;
            if (here != end && *here == 'R') {
                ++here;
                std::reverse(factors.begin(), factors.end());
                for (WordFactor& factor : factors) factor.reversed = !factor.reversed;
                continue;
            }
            while (here != end && is_digit(static_cast<unsigned char>(*here))) ++here;
            if (here == where) throw unexpected("R or a number behind '^'", where);
            const Integer times = natural_number(between(where, here));
            if (times > Integer(most_factors))
                throw SyntaxError{where, "expected a power up to 1000"};
            Factors all;
            for (std::uint64_t i = times.to_uint64(); i > 0; --i) {
                all.insert(all.end(), factors.begin(), factors.end());
                if (all.size() > most_factors) throw SyntaxError{where, "more than 1000 factors"};
            }
            factors = std::move(all);
        }
        return factors;
    }

    ClaimReading& reading_;
    TermReader& terms_;
    std::size_t depth_ = 0;
};

/// Whether all names in the text are numbers, or `sqrt`, and there is a bound one or a digit. A small letter that nothing is called
/// by is a number where there is a digit.
bool is_about_numbers(std::string_view text, const ClaimReading& reading) {
    bool any = false, has_digit = false, has_new = false;
    for (std::size_t i = 0; i < text.size();) {
        if (text[i] == '{' || text[i] == '|' || text[i] == '"') return false;
        if (is_digit(static_cast<unsigned char>(text[i]))) {
            any = has_digit = true;
            ++i;
            continue;
        }
        if (!is_claim_name(text.substr(i, 1))) {
            ++i;
            continue;
        }
        std::size_t end = i + 1;
        while (end < text.size() && is_claim_name(text.substr(i, end + 1 - i))) ++end;
        const std::string_view name = text.substr(i, end - i);
        i = end;
        if (name == "sqrt") continue;
        const ClaimName* known = reading.find(name);
        if (!known && name.size() == 1 && name[0] >= 'a' && name[0] <= 'z' &&
            !reading.alphabet->find(name)) {
            has_new = true;
            continue;
        }
        if (!known || known->kind != ClaimName::Kind::number) return false;
        any = true;
    }
    return any && (has_digit || !has_new);
}

Found comparison_of(std::string_view text) { return first_outside(text, comparison_signs); }

}  // namespace

Expression parse_number_term(std::string_view text, std::vector<BoundName>& numbers,
                             ClaimReading& reading) {
    TermReader terms(reading);
    Expression read = terms.whole(trimmed(text));
    if (!terms.bare().empty())
        throw SyntaxError{text.data(), "expected numbers that 'for all numbers ...' binds, found " +
                                           quoted(terms.bare().front())};
    numbers = terms.numbers();
    return read;
}

bool parse_numbers(std::string_view text, Statement& statement, ClaimReading& reading) {
    static constexpr const char* functions[] = {"length", "count", "segments", "boxes", "distinct"};
    const bool is_call = std::any_of(std::begin(functions), std::end(functions),
                                     [&](const char* name) { return calls(text, name, reading); });
    const Found sign = comparison_of(text);
    if (!is_call && (sign.at == std::string_view::npos || !is_about_numbers(text, reading)))
        return false;
    if (sign.at == std::string_view::npos)
        throw unexpected("one of = != < <= > >= and a number", text.data() + text.size());
    const std::string_view right = text.substr(sign.at + sign.size);
    if (const Found second = comparison_of(right); second.at != std::string_view::npos)
        throw SyntaxError{right.data() + second.at,
                          "expected one comparison, found a second; join two by 'and'"};
    const std::size_t first = reading.uses.size();
    TermReader terms(reading);
    ComparesNumbers said;
    said.left = terms.whole(text.substr(0, sign.at));
    said.right = terms.whole(right);
    said.comparison = comparisons_said[sign.which];
    said.systems = terms.systems();
    said.turtles = terms.turtles();
    said.numbers = terms.numbers();
    statement.says = std::move(said);
    terms.finish(statement, first);
    return true;
}

bool parse_words(std::string_view text, Statement& statement, ClaimReading& reading) {
    if (!calls(text, "word", reading)) return false;
    const Found sign = first_outside(text, {"==", "!=", "≠", "begins ", "ends ", "="});
    constexpr const char* expectation = "'==', '!=', 'begins with' or 'ends with' and a word";
    if (sign.at == std::string_view::npos) throw unexpected(expectation, text.data() + text.size());
    std::string_view right = text.substr(sign.at + sign.size);
    if (sign.which == 5) throw unexpected(expectation, text.data() + sign.at);
    if (sign.which == 3 || sign.which == 4) {
        const char* here = right.data();
        const char* const end = here + right.size();
        if (!grammar::read(here, end, grammar::word("with"))) throw unexpected("'with'", here);
        right = between(here, end);
    }
    using Kind = ComparesWords::Kind;
    static constexpr Kind kinds[] = {Kind::equal, Kind::unequal, Kind::unequal, Kind::begins,
                                     Kind::ends};
    const std::size_t first = reading.uses.size();
    TermReader terms(reading);
    WordReader words(reading, terms);
    ComparesWords said;
    said.left = words.whole(text.substr(0, sign.at));
    said.right = words.whole(right);
    said.kind = kinds[sign.which];
    said.numbers = terms.numbers();
    statement.says = std::move(said);
    terms.finish(statement, first);
    return true;
}

void parse_growth_formula(const std::shared_ptr<const SourceSystem>& system,
                          std::string_view formula, Statement& statement, ClaimReading& reading) {
    if (trimmed(formula).empty())
        throw unexpected("an expression in n", formula.data() + formula.size());
    const std::size_t first = reading.uses.size();
    TermReader terms(reading);
    ComparesNumbers said;
    said.right = terms.whole(formula);
    for (const BoundName& name : terms.numbers())
        if (name.name != "n")
            throw SyntaxError{
                formula.data() + formula.find(name.name),
                "expected n, the number of the generation, found " + quoted(name.name)};
    Expression n = made(Expression::Kind::name, "n", {}, {});
    Expression of = made(Expression::Kind::name, system->name, {}, {});
    said.left = made(Expression::Kind::call, "length", {of, n}, {});
    said.systems = terms.systems();
    said.turtles = terms.turtles();
    if (std::find(said.systems.begin(), said.systems.end(), system) == said.systems.end())
        said.systems.push_back(system);
    Quantified all;
    all.first = first;
    QuantifiedName number;
    number.name = "n";
    number.domain.kind = Domain::Kind::number;
    number.text = "numbers";
    all.bindings.push_back(std::move(number));
    if (reading.uses.size() == first) reading.uses.emplace_back();
    said.numbers = {{first, "n"}};
    Statement body = statement;
    body.negated = false;
    body.says = std::move(said);
    all.body.push_back(std::move(body));
    statement.says = std::move(all);
}

}  // namespace algae
