#include "language/detail/judge.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <nlohmann/json.hpp>

#include "certified.hpp"
#include "notation/notation.hpp"

using namespace algae;

namespace {

Expression parsed(std::string_view text) { return read_expression(text); }

std::shared_ptr<const SourceSystem> source(const oracle::WrittenTables& written,
                                           const std::string& name = "G") {
    auto made = std::make_shared<SourceSystem>();
    made->name = name;
    made->tables = oracle::et0l_of(written);
    return made;
}

std::shared_ptr<const SourceSystem> any_d0l(const std::string& name) {
    oracle::WrittenTables written;
    written.tables.emplace_back();
    for (const char letter : std::string("abc"))
        written.tables[0][letter] = {*oracle::any_word("abc", 2)};
    written.axiom = *oracle::any_nonempty_word("abc", 2);
    return source(written, name);
}

std::string text_of(const Word& word) {
    std::string text;
    for (const Symbol a : word) text += static_cast<char>('a' + a);
    return text;
}

/// The value of a formula for a number n, by its operators.
Rational value(const Expression& formula, long n) {
    if (formula.kind == Expression::Kind::number) return formula.value;
    if (formula.kind == Expression::Kind::name) return Rational(n);
    const Rational left = value(formula.operands[0], n);
    if (formula.kind == Expression::Kind::unary) return Rational(0) - left;
    const Rational right = value(formula.operands[1], n);
    if (formula.name == "+") return left + right;
    if (formula.name == "-") return left - right;
    if (formula.name == "*") return left * right;
    if (formula.name == "/") return left / right;
    Rational product(1);
    for (Rational i(0); i != right; i += Rational(1)) product = product * left;
    return product;
}

std::string any_formula(int depth) {
    if (depth == 0)
        return *rc::gen::elementOf(std::vector<std::string>{"n", "n", "0", "1", "2", "1/3", "3^n",
                                                            "2^(2*n+1)", "(-1)^n", "n^2"});
    const std::string left = any_formula(depth - 1);
    switch (*rc::gen::inRange(0, 6)) {
        case 0:
            return "(" + left + ")+(" + any_formula(depth - 1) + ")";
        case 1:
            return "(" + left + ")-(" + any_formula(depth - 1) + ")";
        case 2:
            return "(" + left + ")*(" + any_formula(depth - 1) + ")";
        case 3:
            return "(" + left + ")^" + std::to_string(*rc::gen::inRange(0, 4));
        case 4:
            return "-(" + left + ")";
        default:
            return "(" + left + ")/" + std::to_string(*rc::gen::inRange(1, 5));
    }
}

Expression number(Rational value) {
    Expression made;
    made.value = std::move(value);
    return made;
}

Quantified for_all_n(ComparesNumbers says) {
    Quantified all;
    QuantifiedName n;
    n.name = "n";
    n.domain.kind = Domain::Kind::number;
    n.text = "numbers";
    all.bindings = {n};
    all.body.emplace_back();
    all.body[0].says = std::move(says);
    return all;
}

template <typename Form>
random::Certified decided(const Form& says,
                          std::vector<std::shared_ptr<const SourceSystem>> systems) {
    random::Certified found = random::sound(random::claim_of({says}, std::move(systems)));
    RC_TAG(found.rule() + ": " +
           (found.rule().empty() ? "undecided" : verify::to_string(found.finding.outcome)));
    return found;
}

std::vector<std::size_t> rewritten_lengths(const D0L& system, unsigned most) {
    std::vector<std::size_t> found;
    Word word = system.axiom;
    for (unsigned n = 0; n < most && word.size() < 100'000; ++n) {
        found.push_back(word.size());
        word = oracle::rewritten(word, system.rules.images(), 1);
    }
    return found;
}

}  // namespace

TEST_CASE("formulas in n have the values that they say") {
    CHECK(rc::check([] {
        const std::string text =
            *rc::gen::exec([] { return any_formula(*rc::gen::inRange(0, 4)); });
        const Expression formula = parsed(text);
        RC_LOG() << text << '\n';
        for (long n = 0; n < 6; ++n) {
            Statement statement;
            statement.says = ComparesNumbers{
                formula, number(value(formula, n)), Comparison::equal, {}, {{0, "n"}}};
            const Statement closed = with_values(statement, {{0, "n", {}, Integer(n)}});
            RC_ASSERT(judge_numbers(std::get<ComparesNumbers>(closed.says)).truth == Truth::proved);
        }
    }));
}

TEST_CASE("formulas that are no sums of polynomials times powers are refused") {
    Claim claim;
    claim.alphabet = std::make_shared<Alphabet>();
    const auto judge = [&](const char* text) {
        return judge_all_numbers(
            for_all_n({parsed(text), number(0), Comparison::equal, {}, {{0, "n"}}}), claim, {});
    };
    for (const char* text : {"1/n", "n^n", "2^(n^2)", "sqrt(n)", "m", "n<3", "0^n", "n^(1/2)",
                             "2^(n/2)", "n^1001", "(n+1)^1000"}) {
        CAPTURE(text);
        CHECK_THROWS_AS(judge(text), Error);
    }
    CHECK_THROWS_WITH_AS(judge("2*m"),
                         doctest::Contains("expected a number that is bound, found m"), Error);
    CHECK(judge("2^n-2^n")->truth == Truth::proved);
    CHECK(judge("2^n*n^2+1")->truth == Truth::refuted);
    const auto orders =
        std::get<steps::ByRecurrences>(judge("2^n*n^2-n*2^n*n")->proof->step).orders;
    CHECK(orders == std::vector<std::pair<std::string, std::uint64_t>>{{"n", 7}});
}

TEST_CASE("what a system derives in so many steps is what all choices and tables give") {
    CHECK(rc::check([] {
        const oracle::WrittenTables written = *oracle::any_tables(2, true, {"", "a", "ab"});
        const unsigned steps = *rc::gen::inRange(0u, 4u);
        const std::set<std::string> words = oracle::words_of_generation(written, steps);
        RC_PRE(words.size() < 3000u);
        std::vector<std::string> tried(words.begin(), words.end());
        tried.resize(std::min<std::size_t>(tried.size(), 4));
        for (int i = 0; i < 3; ++i) tried.push_back(*oracle::any_word("abc", 3));
        for (const std::string& word : tried) {
            const auto system = source(written);
            RC_LOG() << word << " in " << steps << '\n';
            const random::Certified found =
                decided(Derives{system, random::word_of(word), {}, steps}, {system});
            RC_ASSERT(found.judgement.truth ==
                      (words.contains(word) ? Truth::proved : Truth::refuted));
        }
    }));
}

TEST_CASE("what a system derives from a word in any number of steps is in some generation") {
    CHECK(rc::check([] {
        oracle::WrittenTables written = *oracle::any_tables(2, true, {"", "a"});
        Derives statement{source(written), {}};
        if (*rc::gen::arbitrary<bool>()) {
            written.axiom = *oracle::any_word("abc", 2);
            statement.from = random::word_of(written.axiom);
        }
        statement.word = random::word_of(*oracle::any_word("abc", 3));
        const random::Certified found = decided(statement, {statement.system});
        RC_ASSERT(found.judgement.truth != Truth::undecided);
        bool there = false;
        for (unsigned n = 0; n < 4 && !there; ++n) {
            const auto words = oracle::words_of_generation(written, n);
            there = words.contains(text_of(statement.word));
            if (words.size() > 500) break;
        }
        if (there) RC_ASSERT(found.judgement.truth == Truth::proved);
        written.terminals.clear();
        const auto all = oracle::short_words(written, statement.word.size(), 3000);
        RC_PRE(all.has_value());
        RC_ASSERT((found.judgement.truth == Truth::proved) ==
                  all->contains(text_of(statement.word)));
    }));
}

TEST_CASE("sequences and lengths of random systems are compared as their first generations are") {
    CHECK(rc::check([] {
        const auto pair =
            *rc::gen::resize(100, rc::gen::exec([] {
                                 auto one = any_d0l("G");
                                 if (*rc::gen::inRange(0, 3) > 0)
                                     return std::pair(one, any_d0l("H"));
                                 auto other = std::make_shared<SourceSystem>(*one);
                                 other->name = "H";
                                 return std::pair(one, std::shared_ptr<const SourceSystem>(other));
                             }));
        const D0L left = as_d0l(*pair.first), right = as_d0l(*pair.second);
        const auto word = [](const D0L& system, unsigned n) {
            return oracle::rewritten(system.axiom, system.rules.images(), n);
        };
        bool same = true;
        for (unsigned n = 0; n < 8; ++n) same = same && word(left, n) == word(right, n);
        const auto& [one, other] = pair;
        RC_ASSERT(decided(EqualSequences{one, other}, {one, other}).judgement.truth ==
                  (same ? Truth::proved : Truth::refuted));
        RC_ASSERT(decided(EqualGrowth{one, other}, {one, other}).judgement.truth ==
                  (rewritten_lengths(left, 8) == rewritten_lengths(right, 8) ? Truth::proved
                                                                             : Truth::refuted));
    }));
}

TEST_CASE("a formula is the growth of a system if the first lengths are its values") {
    CHECK(rc::check([] {
        const auto system = *rc::gen::resize(100, rc::gen::exec([] { return any_d0l("G"); }));
        const std::string text = *rc::gen::resize(
            100, rc::gen::exec([] {
                return *rc::gen::arbitrary<bool>()
                           ? any_formula(1)
                           : *rc::gen::elementOf(std::vector<std::string>{
                                 "1", "2", "2^n", "n+1", "2^(n+1)", "2*n+1", "n+2", "3"});
            }));
        const Expression formula = parsed(text);
        Expression length;
        length.kind = Expression::Kind::call;
        length.name = "length";
        length.operands = {parsed("G"), parsed("n")};
        const Quantified statement =
            for_all_n({length, formula, Comparison::equal, {system}, {{0, "n"}}});
        bool same = true;
        const auto found = rewritten_lengths(as_d0l(*system), 10);
        for (std::size_t n = 0; n < found.size(); ++n)
            same = same &&
                   value(formula, static_cast<long>(n)) == Rational(static_cast<long>(found[n]));
        RC_LOG() << text << '\n';
        RC_ASSERT(decided(statement, {system}).judgement.truth ==
                  (same ? Truth::proved : Truth::refuted));
    }));
}

TEST_CASE("classes of growth exclude each other") {
    CHECK(rc::check([] {
        const auto system = *rc::gen::resize(100, rc::gen::exec([] { return any_d0l("G"); }));
        int right = 0;
        for (const char* name : {"zero", "bounded", "polynomial", "exponential"}) {
            right +=
                decided(HasGrowthClass{system, name}, {system}).judgement.truth == Truth::proved;
        }
        RC_ASSERT(right == 1);
    }));
}

TEST_CASE("a family with contexts is named by how long they are, and by nothing behind that") {
    REQUIRE(system_form("(2,1)L").has_value());
    CHECK(system_form("(2,1)L")->context == std::pair<std::size_t, std::size_t>{2, 1});
    for (const char* name : {"(2,1)L2", "(2,1)", "(2)L", "(2,1)0L", "3L", ""})
        CHECK_FALSE(system_form(name).has_value());
}
