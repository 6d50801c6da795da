// Languages as textbooks write them, through the text of claims: what is decided of them is what naive definitions say,
// and verify checks every proof.

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "language/language.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "verify/verify.hpp"

#include <nlohmann/json.hpp>

using namespace algae;

namespace {

struct Verdict {
    Truth truth;
    std::string by;
    verify::Finding::Outcome outcome;
    std::string reason, argument;

    bool is_checked() const { return outcome == verify::Finding::Outcome::checked; }
};

/// What comes of the statements of these lines, and of their certificates.
std::vector<Verdict> all_judged(const std::string& lines) {
    const CheckedClaim checked = check(read_claim("claim T\n" + lines, "x.claim", {}));
    const Alphabet& alphabet = *checked.claim.alphabet;
    const auto findings = verify::check_certificate(certificate(checked).dump(1), "c", Budget());
    std::vector<Verdict> all;
    for (std::size_t i = 0; i < findings.size(); ++i) {
        const Answer& answer = checked.statements[i].answer;
        all.push_back({answer.truth, method_of(answer, alphabet), findings[i].outcome,
                       findings[i].reason, joined(sentences(answer, alphabet), " ")});
    }
    return all;
}

Verdict judged(const std::string& lines) { return all_judged(lines).back(); }

/// "proved", "refuted" or "undecided", and by which kind of proof, which verify has checked.
std::string verdict(const std::string& lines) {
    const Verdict found = judged(lines);
    if (found.truth == Truth::undecided) return "undecided: " + found.argument;
    return std::string(to_string(found.truth)) + " by " + found.by +
           (found.is_checked() ? "" : ", not checked: " + found.reason);
}

std::vector<std::string> words_up_to(const std::string& letters, std::size_t longest) {
    std::vector<std::string> all{""};
    for (std::size_t i = 0; i < all.size(); ++i)
        if (all[i].size() < longest)
            for (const char letter : letters) all.push_back(all[i] + letter);
    return all;
}

std::string written(const std::string& word) { return word.empty() ? "ε" : word; }

std::string any_of(const std::vector<std::string>& all) {
    return all[*rc::gen::inRange<std::size_t>(0, all.size())];
}

// --- Powers ---

struct Exponent {
    std::string text;
    std::function<std::uint64_t(std::uint64_t, std::uint64_t)> value;
};

const std::vector<Exponent>& exponents(int numbers) {
    static const std::vector<Exponent> one{
        {"n", [](std::uint64_t n, std::uint64_t) { return n; }},
        {"(2n)", [](std::uint64_t n, std::uint64_t) { return 2 * n; }},
        {"(2n+1)", [](std::uint64_t n, std::uint64_t) { return 2 * n + 1; }},
        {"(n^2)", [](std::uint64_t n, std::uint64_t) { return n * n; }},
        {"(2^n)", [](std::uint64_t n, std::uint64_t) { return std::uint64_t{1} << n; }},
        {"(n*2^n+1)",
         [](std::uint64_t n, std::uint64_t) { return n * (std::uint64_t{1} << n) + 1; }},
        {"((n+1)^2)", [](std::uint64_t n, std::uint64_t) { return (n + 1) * (n + 1); }}};
    static const std::vector<Exponent> two{
        {"n", [](std::uint64_t n, std::uint64_t) { return n; }},
        {"m", [](std::uint64_t, std::uint64_t m) { return m; }},
        {"(2m)", [](std::uint64_t, std::uint64_t m) { return 2 * m; }},
        {"(n+m)", [](std::uint64_t n, std::uint64_t m) { return n + m; }},
        {"(2n+3m+1)", [](std::uint64_t n, std::uint64_t m) { return 2 * n + 3 * m + 1; }}};
    return numbers == 1 ? one : two;
}

/// A set with powers, and all its words up to a length.
struct PowerSet {
    std::string text;
    std::set<std::string> words;
};

PowerSet any_power_set(std::size_t longest, bool two_numbers = true) {
    const int numbers = two_numbers ? *rc::gen::inRange(1, 3) : 1;
    const auto least = *rc::gen::inRange<std::uint64_t>(0, 3);
    std::vector<std::pair<std::string, Exponent>> blocks;
    std::string text;
    const auto add = [&](const Exponent* exponent) {
        const std::string word = any_of({"a", "b", "ab", "ba", "aa"});
        const Exponent one{"", [](std::uint64_t, std::uint64_t) { return std::uint64_t{1}; }};
        blocks.emplace_back(word, exponent ? *exponent : one);
        text += exponent ? "(" + word + ")^" + exponent->text + " " : word + " ";
    };
    const auto& all = exponents(numbers);
    if (*rc::gen::arbitrary<bool>()) add(nullptr);
    add(&all[*rc::gen::inRange<std::size_t>(0, all.size())]);
    if (*rc::gen::arbitrary<bool>()) add(nullptr);
    if (*rc::gen::arbitrary<bool>()) add(&all[*rc::gen::inRange<std::size_t>(0, all.size())]);
    if (numbers == 2) {
        add(&all[0]);
        add(&all[1]);
    }
    if (*rc::gen::arbitrary<bool>()) add(nullptr);
    PowerSet made{
        "{" + text + (numbers == 2 ? ": n, m >= " : ": n >= ") + std::to_string(least) + "}", {}};
    for (std::uint64_t n = least; n <= least + longest; ++n)
        for (std::uint64_t m = least; m <= (numbers == 2 ? least + longest : least); ++m) {
            std::string word;
            for (const auto& [part, exponent] : blocks)
                for (std::uint64_t i = std::min<std::uint64_t>(exponent.value(n, m), longest + 1);
                     i > 0; --i)
                    word += part;
            if (word.size() <= longest) made.words.insert(word);
        }
    return made;
}

// --- Grammars ---

struct AnyGrammar {
    std::string text;
    std::set<std::string> words;  // up to a length
};

/// All words up to a length that each letter derives, by taking products of sets until nothing is new.
AnyGrammar any_grammar(bool right_linear, std::size_t longest) {
    std::map<char, std::vector<std::string>> rules;
    for (const char left : {'S', 'A'})
        for (int i = *rc::gen::inRange(1, 4); i > 0; --i) {
            std::string right;
            if (right_linear) {
                right = any_of({"", "a", "b", "ab"}) + any_of({"", "S", "A"});
            } else {
                for (int k = *rc::gen::inRange(0, 4); k > 0; --k)
                    right += any_of({"a", "b", "S", "A"});
            }
            rules[left].push_back(right);
        }
    AnyGrammar made;
    for (const char left : {'S', 'A'})
        for (const std::string& right : rules[left])
            made.text +=
                (made.text.empty() ? "" : "; ") + std::string(1, left) + " -> " + written(right);
    made.text = (right_linear ? "regular { " : "CF { ") + made.text + " }";
    std::map<char, std::set<std::string>> words;
    for (bool changed = true; changed;) {
        changed = false;
        for (const auto& [left, all] : rules)
            for (const std::string& right : all) {
                std::set<std::string> built{""};
                for (const char letter : right) {
                    std::set<std::string> longer;
                    for (const std::string& begun : built) {
                        if (letter == 'a' || letter == 'b') {
                            longer.insert(begun + letter);
                            continue;
                        }
                        for (const std::string& more : words[letter]) longer.insert(begun + more);
                    }
                    built.clear();
                    for (const std::string& word : longer)
                        if (word.size() <= longest) built.insert(word);
                }
                for (const std::string& word : built)
                    changed = words[left].insert(word).second || changed;
            }
    }
    made.words = words['S'];
    return made;
}

/// Whether of these words those are found to be in the language that are in the set, with proofs that verify has checked.
bool has_exactly(const std::string& language, const std::vector<std::string>& words,
                 const std::set<std::string>& members) {
    std::string lines = "alphabet a b\nlet A = " + language + "\n";
    for (const std::string& word : words) lines += "show " + written(word) + " in A\n";
    const std::vector<Verdict> found = all_judged(lines);
    for (std::size_t i = 0; i < words.size(); ++i)
        if (!found[i].is_checked() ||
            (found[i].truth == Truth::proved) != members.contains(words[i]))
            return false;
    return true;
}

const std::vector<std::string>& expressions() {
    static const std::vector<std::string> all{
        "a*b*",    "(a|b)*",        "(ab)*",      "a*b*a*",      "(aa)*(bb)*",   "(a|b)*b",
        "a(a|b)*", "((a|b)(a|b))*", "(ab|ba|a)*", "(a|b)(a|b)*", "(aaa)*(a|b)*", "b*(ab*ab*)*"};
    return all;
}

}  // namespace

TEST_CASE("membership in sets with powers is that of the definition") {
    CHECK(rc::check([] {
        const PowerSet made = any_power_set(8);
        RC_LOG() << made.text << '\n';
        RC_TAG(made.words.size() > 3 ? "many" : "few");
        std::vector<std::string> words = words_up_to("ab", 4);
        for (int i = 0; i < 10; ++i) words.push_back(any_of(words_up_to("ab", 8)));
        words.insert(words.end(), made.words.begin(), made.words.end());
        RC_ASSERT(has_exactly(made.text, words, made.words));
    }));
}

TEST_CASE("inclusion of sets with powers in regular languages is decided") {
    std::size_t proved = 0, refuted = 0;
    CHECK(rc::check([&] {
        const PowerSet made = any_power_set(10);
        const std::string expression = any_of(expressions());
        const std::regex matches(expression);
        const Verdict found = judged("show " + made.text + " <= /" + expression + "/");
        RC_LOG() << made.text << " <= " << expression << ": " << found.argument << '\n';
        RC_ASSERT(found.truth != Truth::undecided);
        RC_ASSERT(found.is_checked());
        ++(found.truth == Truth::proved ? proved : refuted);
        const bool within =
            std::all_of(made.words.begin(), made.words.end(),
                        [&](const std::string& word) { return std::regex_match(word, matches); });
        if (!within) RC_ASSERT(found.truth == Truth::refuted);
        const Verdict empty = judged("show " + made.text + " & /" + expression + "/ is empty");
        RC_ASSERT(empty.truth != Truth::undecided);
        RC_ASSERT(empty.is_checked());
        const bool meets =
            std::any_of(made.words.begin(), made.words.end(),
                        [&](const std::string& word) { return std::regex_match(word, matches); });
        if (meets) RC_ASSERT(empty.truth == Truth::refuted);
    }));
    CHECK(proved > 5);
    CHECK(refuted > 5);
}

TEST_CASE("what is said of two sets with powers is not wrong") {
    std::size_t proved = 0;
    CHECK(rc::check([&] {
        const PowerSet left = any_power_set(9, false), right = any_power_set(9, false);
        for (const auto& [one, other] : {std::pair(left, right), std::pair(left, left)}) {
            const Verdict found = judged("show " + one.text + " == " + other.text + " | {}");
            if (found.truth == Truth::proved) RC_ASSERT(one.words == other.words);
            if (found.truth == Truth::refuted) RC_ASSERT(found.is_checked());
        }
        const Verdict same = judged("show " + left.text + " == " + right.text);
        if (same.truth == Truth::undecided) return;
        RC_ASSERT(same.is_checked());
        if (same.truth == Truth::proved) {
            ++proved;
            RC_ASSERT(left.words == right.words);
        }
    }));
}

TEST_CASE("equal sequences are found, and others are told apart") {
    CHECK(verdict("let G = D0L { axiom a; a -> aa }\nshow L(G) == {a^(2^n) : n >= 0}") ==
          "proved by powers");
    CHECK(verdict("let G = D0L { axiom a; a -> aa }\nshow {a^(2^n) : n >= 1} == L(G)") ==
          "refuted by word");
    CHECK(verdict("let G = D0L { axiom b; b -> aba }\nshow L(G) == {a^n b a^n : n >= 0}") ==
          "proved by powers");
    CHECK(verdict("let G = D0L { axiom aba; b -> aba }\nshow L(G) == {a^n b a^n : n >= 1}") ==
          "proved by powers");
    CHECK(verdict("let G = D0L { axiom b; b -> abaa }\nshow L(G) == {a^n b a^n : n >= 0}") ==
          "refuted by word");
    CHECK(verdict("let G = D0L { axiom c; a -> a; b -> ab; c -> bc }\n"
                  "show L(G) == {b^n c : n >= 0}") == "refuted by word");
    CHECK(verdict("let G = D0L { axiom ab; a -> aa; b -> bb }\n"
                  "show L(G) == {a^(2^n) b^(2^n) : n >= 0}") == "proved by powers");
    CHECK(verdict("let G = D0L { axiom c; c -> cab }\nshow L(G) == {c (ab)^n : n >= 0}") ==
          "proved by linear");
    CHECK(verdict("show CF { S -> aSb | ε } == {a^n b^n : n >= 0}") == "proved by powers");
    CHECK(verdict("show CF { S -> abSb | a } == {a (ba)^n b^n : n >= 0}") == "proved by powers");
    CHECK(verdict("show CF { S -> aSb | ε } == {a^n b^n : n >= 1}") == "refuted by word");
    CHECK(verdict("show {a^n b^(2n) a^n : n >= 0} == {a^n (bb)^n a^n : n >= 0}") ==
          "proved by powers");
    CHECK(verdict("show {a^n b^m : n, m >= 1} == /aa*bb*/") == "proved by derivatives");
    CHECK(verdict("show {a^n b^n : n >= 1} <= CF { S -> aSb | ab }").starts_with("undecided"));
}

TEST_CASE("families of sets with powers") {
    const auto is = [](const std::string& set, const std::string& family) {
        return verdict("show " + set + " is " + family);
    };
    CHECK(is("{a^n b^n : n >= 0}", "CF") == "proved by context-free");
    CHECK(is("{a^n b^n : n >= 0}", "REG") == "refuted by powers");
    CHECK(is("{a^n b a^n : n >= 0}", "REG") == "refuted by powers");
    CHECK(is("{a^n b^n c^n : n >= 1}", "CF") == "refuted by powers");
    CHECK(is("{a^(n^2) : n >= 1}", "CF") == "refuted by powers");
    CHECK(is("{a^(2^n) : n >= 1}", "REG") == "refuted by powers");
    CHECK(is("{a^n b^m c^n : n, m >= 1}", "CF") == "proved by context-free");
    CHECK(is("{a^n b^m a^n b^m : n, m >= 1}", "CF").starts_with("undecided"));
    CHECK(is("{a^n b^m : n, m >= 1}", "REG") == "proved by regular");
    CHECK(is("{a^(2n+1) : n >= 1}", "REG") == "proved by regular");
    CHECK(is("{a^n a^n : n >= 0}", "REG").starts_with("undecided"));
    CHECK(is("{a^n b^n : n >= 0}", "finite") == "refuted by powers");
    CHECK(is("{a^n b^n : n >= 0} | {c}", "finite") == "refuted by part");
    CHECK(is("{a^n b^n : n >= 0}", "empty") == "refuted by word");
    CHECK(verdict("show |{a^n b^n : n >= 0} & /ab*/| = 1").starts_with("proved"));
}

TEST_CASE("membership in context-free grammars is that of naive derivations") {
    std::size_t with_words = 0;
    CHECK(rc::check([&] {
        const AnyGrammar made =
            *rc::gen::resize(100, rc::gen::exec([] { return any_grammar(false, 5); }));
        RC_LOG() << made.text << '\n';
        if (made.words.size() > 2) ++with_words;
        std::vector<std::string> words = words_up_to("ab", 3);
        for (int i = 0; i < 5; ++i) words.push_back(any_of(words_up_to("ab", 5)));
        RC_ASSERT(has_exactly(made.text, words, made.words));
        const Verdict family = judged("alphabet a b\nshow " + made.text + " is context-free");
        RC_ASSERT(family.truth == Truth::proved);
        RC_ASSERT(family.is_checked());
    }));
    CHECK(with_words > 20);
}

TEST_CASE("finiteness of and inclusion in regular languages is decided for grammars") {
    std::size_t finite = 0, within = 0, outside = 0;
    CHECK(rc::check([&] {
        const AnyGrammar made =
            *rc::gen::resize(100, rc::gen::exec([] { return any_grammar(false, 6); }));
        RC_LOG() << made.text << '\n';
        const std::string expression = any_of(expressions());
        const std::vector<Verdict> both =
            all_judged("alphabet a b\nlet A = " + made.text + "\nshow A is finite\nshow A <= /" +
                       expression + "/");
        const Verdict &found = both[0], &included = both[1];
        RC_ASSERT(found.truth != Truth::undecided);
        RC_ASSERT(found.outcome != verify::Finding::Outcome::wrong);
        if (found.truth == Truth::proved) {
            ++finite;
            const Verdict size = judged("alphabet a b\nshow |" + made.text +
                                        " | {}| = " + std::to_string(made.words.size()));
            const bool all_short = judged("alphabet a b\nshow " + made.text +
                                          " <= /(a|b|ε)(a|b|ε)(a|b|ε)(a|b|ε)(a|b|ε)(a|b|ε)/")
                                       .truth == Truth::proved;
            if (all_short) RC_ASSERT(size.truth == Truth::proved);
        }
        const std::regex matches(expression);
        RC_ASSERT(included.truth != Truth::undecided);
        RC_ASSERT(included.outcome != verify::Finding::Outcome::wrong);
        ++(included.truth == Truth::proved ? within : outside);
        const bool all =
            std::all_of(made.words.begin(), made.words.end(),
                        [&](const std::string& word) { return std::regex_match(word, matches); });
        if (!all) RC_ASSERT(included.truth == Truth::refuted);
    }));
    CHECK(finite > 5);
    CHECK(within > 5);
    CHECK(outside > 5);
}

TEST_CASE("right-linear grammars have the words that they derive") {
    CHECK(rc::check([] {
        const AnyGrammar made =
            *rc::gen::resize(100, rc::gen::exec([] { return any_grammar(true, 5); }));
        RC_LOG() << made.text << '\n';
        std::string words;
        for (const std::string& word : made.words)
            words += (words.empty() ? "" : ", ") + written(word);
        const Verdict found = judged("alphabet a b\nshow " + made.text +
                                     " & /(a|b|ε)(a|b|ε)(a|b|ε)(a|b|ε)(a|b|ε)/ == {" + words + "}");
        RC_ASSERT(found.truth == Truth::proved);
        RC_ASSERT(found.is_checked());
        RC_ASSERT(judged("alphabet a b\nshow " + made.text + " is regular").is_checked());
    }));
}

TEST_CASE("what is undecidable of grammars is said, with the theorem") {
    const std::string lines = "let A = CF { S -> aSb | ε }\nlet B = CF { S -> aSb | aaSbb | ε }\n";
    const Verdict equal = judged(lines + "show A == B");
    CHECK(equal.truth == Truth::undecided);
    CHECK(equal.argument.find("Equality of context-free languages is undecidable (Bar-Hillel, "
                              "Perles and Shamir 1961)") != std::string::npos);
    CHECK(judged(lines + "show B <= A")
              .argument.find("Inclusion of context-free languages is "
                             "undecidable") != std::string::npos);
    CHECK(verdict(lines + "show A == B | {ab, ba}") == "refuted by word");
    CHECK(verdict(lines + "show A & /(ab)*/ == {ε, ab}").starts_with("proved by values"));
    CHECK(verdict(lines + "show A & /b(a|b)*/ is empty") == "proved by relations");
    CHECK(verdict(lines + "show A & /aa*/ is empty") == "proved by relations");
    CHECK(verdict(lines + "show A is 0L").starts_with("undecided"));
    CHECK(verdict(lines + "show A B* | {c} is CF") == "proved by context-free");
    CHECK(verdict(lines + "show A & B is CF").starts_with("undecided"));
}

TEST_CASE("codes are those of the definition") {
    std::size_t codes = 0, others = 0;
    CHECK(rc::check([&] {
        std::set<std::string> words;
        for (int i = *rc::gen::inRange(1, 5); i > 0; --i)
            words.insert(any_of(words_up_to("ab", 3)));
        if (*rc::gen::inRange(0, 5) > 0) words.erase("");
        std::string set;
        for (const std::string& word : words) set += (set.empty() ? "" : ", ") + written(word);
        set = "{" + set + "}";
        // How many factorisations words have, up to two; of words up to a length that shows ambiguities of such sets.
        bool is_code = !words.contains(""), is_prefix = is_code;
        std::map<std::string, int> ways{{"", 1}};
        for (const std::string& word : words_up_to("ab", 9)) {
            int count = 0;
            for (const std::string& last : words)
                if (!last.empty() && word.size() >= last.size() && word.ends_with(last))
                    count += ways[word.substr(0, word.size() - last.size())];
            if (!word.empty()) ways[word] = std::min(count, 2);
            if (count > 1) is_code = false;
        }
        for (const std::string& word : words)
            for (const std::string& other : words)
                if (word != other && word.starts_with(other)) is_prefix = false;
        const Verdict found = judged("show " + set + " is a code");
        RC_LOG() << set << ": " << found.argument << '\n';
        RC_ASSERT(found.truth != Truth::undecided);
        RC_ASSERT(found.is_checked());
        if (!is_code) RC_ASSERT(found.truth == Truth::refuted);
        ++(found.truth == Truth::proved ? codes : others);
        const Verdict prefix = judged("show " + set + " is a prefix code");
        RC_ASSERT((prefix.truth == Truth::proved) == is_prefix);
        RC_ASSERT(prefix.is_checked());
    }));
    CHECK(codes > 5);
    CHECK(others > 5);
}

TEST_CASE("codes that are infinite, and palindromes") {
    CHECK(verdict("show /a*b/ is a prefix code") == "proved by code");
    CHECK(verdict("show /ab*/ is a code") == "proved by code");
    CHECK(verdict("show /ab*/ is a prefix code") == "refuted by beginning");
    CHECK(verdict("show /aa*/ is a code") == "refuted by factorisations");
    CHECK(verdict("show /a*/ is a code") == "refuted by factorisations");
    CHECK(verdict("show {} is a code") == "proved by code");
    CHECK(verdict("show {a^n b^n : n >= 1} is a code").starts_with("undecided"));
    CHECK(judged("show {a, ab, ba} is a code").argument ==
          "aba is a product of words of {a, ab, ba} in two ways: ab . a and a . ba.");
    CHECK(verdict("show abba is a palindrome") == "proved by letters");
    CHECK(verdict("show ε is a palindrome") == "proved by letters");
    CHECK(judged("show abab is a palindrome").argument ==
          "Letter number 1 of abab is a, and the same letter from its end is b.");
    CHECK(verdict("theorem for all words w up to length 4 over {a, b}: w is a palindrome iff w in "
                  "{w}^R")
              .starts_with("proved"));
}

TEST_CASE("a proof of something false is not checked") {
    const auto outcome = [](const std::string& lines, const nlohmann::ordered_json& statement) {
        auto written = certificate(check(read_claim("claim T\n" + lines, "x.claim", {})));
        written["statements"][0]["statement"] = statement;
        return verify::check_certificate(written.dump(), "c", Budget()).front().outcome;
    };
    using Outcome = verify::Finding::Outcome;
    const auto powers = [](int coefficient, int least) {
        return nlohmann::ordered_json{
            {"powers",
             {{{"word", "a"}, {"exponent", {{{"coefficient", 1}, {"number", "n"}, {"power", 1}}}}},
              {{"word", "b"},
               {"exponent", {{{"coefficient", coefficient}, {"number", "n"}, {"power", 1}}}}}}},
            {"numbers", {{{"name", "n"}, {"least", least}}}}};
    };
    const std::string lines = "let G = CF { S -> aSb | ab }\nshow G == {a^n b^n : n >= 1}";
    const auto equal = [](const nlohmann::ordered_json& right) {
        return nlohmann::ordered_json{{"equal", {{{"generated", "G"}}, right}}};
    };
    CHECK(outcome(lines, equal(powers(1, 1))) == Outcome::checked);
    CHECK(outcome(lines, equal(powers(2, 1))) == Outcome::wrong);
    CHECK(outcome(lines, equal(powers(1, 2))) == Outcome::wrong);
}

TEST_CASE("De Morgan's rules hold in every file, whatever letters its languages have") {
    int proved = 0;
    CHECK(rc::check("laws", [&] {
        const auto any = [] {
            const auto letter = [] {
                return std::string(1, *rc::gen::elementOf(std::string("abcd")));
            };
            const std::string x = letter(), y = letter();
            return *rc::gen::elementOf(std::vector<std::string>{
                "{" + x + "}", "{ε, " + x + y + "}", "/" + x + "*" + y + "/",
                "/(" + x + "|" + y + ")*" + x + "/", "{}", "~{" + x + "}",
                "{ " + x + " -> " + y + " }({" + x + x + "})"});
        };
        const std::string lets = *rc::gen::resize(
            100, rc::gen::exec([&] {
                return "let A = " + any() + "\nlet B = " + any() + "\nlet C = {c}\n";
            }));
        for (const Verdict& law :
             all_judged(lets + "show ~(A | B) == ~A & ~B\nshow ~(A & B) == ~A | ~B\n"
                               "show A \\ B == A & ~B\nshow ~~A == A\nshow ~(B | C) == ~B & ~C\n"
                               "show ~A | A == ~{}\nshow c in ~{} & ~{cc}\n")) {
            RC_ASSERT(law.truth == Truth::proved);
            RC_ASSERT(law.is_checked());
            ++proved;
        }
    }));
    MESSAGE(proved << " laws proved and checked");
    CHECK(proved > 0);
}

TEST_CASE("each way to decide is reached, and its sentences say what the systems do") {
    struct Way {
        std::string lines, verdict, sentence;
    };
    const std::string doubling = "let G = D0L { axiom a; a -> aa }\n",
                      choosing = "let G = 0L { axiom a; a -> a | aa }\n",
                      waiting = "let G = D0L { axiom a; a -> b; b -> bb }\n",
                      rising = "let G = D0L { axiom a; a -> ab; b -> b }\n",
                      two_tables =
                          "let G = T0L { axiom a; table p; a -> b; b -> b; "
                          "table q; a -> a; b -> aa }\n",
                      slow = "let G = IL { axiom a; a < a -> a; a -> a | b; b -> b }\n",
                      one_sided = "let G = IL { axiom a; a < b -> a; a -> ab; b -> b }\n",
                      two_sided = "let G = IL { axiom a; a < b > a -> a; a -> ab; b -> b }\n",
                      growing = "let G = IL { axiom ab; a < b -> bb | b; a -> a; b -> b }\n";
    const std::vector<Way> ways{
        // Lengths: a => b => bb.
        {waiting + "show growth(G) is strictly increasing", "refuted by generation",
         "Generation 0 of G has 1 letters and the next one 1."},
        {rising + "show growth(G) is strictly increasing", "proved by letters",
         "each of the 2 sets of letters that occur together has a letter with a longer successor."},
        // Only b, whose number does not grow, has all its powers: the system is circular.
        {rising + "show G is circular", "proved by windows", "the synchronising delay 0."},
        // Derivations in so many steps.
        {doubling + "show G ==> aaa in 3 steps", "refuted by exhausted",
         "a ==> aaaaaaaa in 3 steps, and nothing else."},
        {choosing + "show G ==> aaaaa in 2 steps", "refuted by exhausted",
         "No choice of rules makes aaaaa of a in 2 steps"},
        {slow + "show G ==> a in 100001 steps",
         "undecided: with contexts at most 100000 steps are followed",
         "with contexts at most 100000 steps are followed"},
        // Neither table makes more letters than one by itself.
        {two_tables + "show L(G) is finite", "refuted by endless tables", "L(G) is infinite"},
        {choosing + "show L(G) is finite", "refuted by endless round",
         "by a -> aa the letter a comes back with a beside it"},
        {"show {c} | {a^n b^n : n >= 0} is finite", "refuted by part",
         "{a^n b^n : n >= 0} is infinite"},
        // The regular part stands before the other one.
        {"show /ab*/ & {a^n b^n : n >= 0} is empty", "refuted by word", "ab is a word of"},
        {"show /ba*/ & {a^n b^n : n >= 1} is empty", "proved by relations",
         "No word of {a^n b^n : n >= 1} is in {b} . {a}*"},
        {"show {a^n b^n : n >= 2} & {a^n b^n a^n : n >= 1} is empty",
         "undecided: no word of it was found, and no reason why there is none", ""},
        // By two numbers there is no one sequence of words, although a^n is the same in both.
        {"show {a^n b^m c^m : n, m >= 1} == {a^n b^(2m) c^m : n, m >= 1}", "refuted by word",
         "abc is not in {a^n b^(2m) c^m : n, m >= 1}"},
        {doubling + "let H = D0L { axiom a; a -> aaaa }\nshow L(H) <= L(G)", "proved by sections",
         "Word n of H is word 2n of G for all n"},
        {growing + "show L(G) is finite", "refuted by measure",
         "where letters choose a < b -> bb, b -> b, and every"},
        {"show {ab, b} is a prefix code", "proved by code",
         "No word of {b, ab} begins with another, and ε is none of them."},
        {"let G = IL { axiom b; a < b -> b | a; b -> b | ab; a -> a }\nshow a in L(G)",
         "refuted by membership", "the only word with at most 1 letter is another."},
        {"show /a+b+a/ is 0L", "refuted by classes",
         "aba becomes aa, which is not in the language, by a -> a; b -> ε, so one"},
        {"show /(ab|ba)+/ is 0L", "proved by equal",
         "with fewer letters a, by induction on their number"},
        {"show /b+(baab)+/ is 0L", "refuted by classes", "bbaab becomes bbb"},
        {"show {a, aaa} | /aaaaaa*/ is P0L", "proved by equal", "axiom a; a -> a | aaa | aaaaaa."},
        {"show {ε} | /a(aa)*/ is T0L", "proved by equal", "ε is in L(G): a => ε."},
        {"show {a} | /aaaa(aa)*/ is P0L", "proved by equal", "a is in L(G): it is the axiom."},
        {"show {a, aa, aaa} | /aaaaaa*/ is P0L", "refuted by lengths", " become 2 x 2 = 4, which"},
        // Without erasing rules the empty word as axiom derives nothing else.
        {"allow empty axiom\nshow {ε} | /aaa*/ is P0L", "refuted by lengths",
         "Only one of the two can be the axiom, so {ε} | {aa} . {a}* is not P0L."},
        {"show /a(aa)*|aa/ is P0L", "refuted by lengths", "So {a} . {aa}* | {aa} is not P0L."},
        {"show /a(aa)*|aa|aaaa/ is PT0L", "refuted by lengths",
         "Only one of the two can be the axiom, so {a} . {aa}* | {aa, aaaa} is not PT0L."}};
    for (const Way& way : ways) {
        CAPTURE(way.lines);
        CHECK(verdict(way.lines) == way.verdict);
        const std::string argument = judged(way.lines).argument;
        CAPTURE(argument);
        CHECK(argument.find(way.sentence) != std::string::npos);
    }
    // Contexts on one side make a 1L system; of its number of letters nothing is said.
    for (const char* family : {"1L", "(1,0)L", "IL"})
        CHECK(judged(one_sided + "show L(G) is " + family).truth == Truth::proved);
    CHECK(judged(two_sided + "show L(G) is (1,1)L").truth == Truth::proved);
    for (const char* family : {"1L", "(1,0)L"})
        CHECK(judged(two_sided + "show L(G) is " + family).truth == Truth::undecided);
    // What holds by itself holds behind another theorem, whose names have other numbers.
    const std::string chain =
        "for all 0L systems G and words x, y, z with G : x ==> y and G : y ==> z: G : x ==> z\n";
    for (const Verdict& found : all_judged("show " + chain + "theorem " + chain)) {
        CHECK(found.truth == Truth::proved);
        CHECK(found.is_checked());
    }
    // Only the first cases are shown, and the number of all.
    const CheckedClaim many = check(read_claim("claim T\nshow /a+b+a/ is 0L", "x.claim", {}));
    const auto shown = sentences(many.statements[0].answer, *many.claim.alphabet);
    const auto steps = std::count_if(shown.begin(), shown.end(), [](const std::string& line) {
        return line.starts_with("  ") || line.starts_with("aba becomes");
    });
    CHECK(steps <= 40);
    CHECK(steps >= 10);
    // EDT0L languages are closed under union; of rules with choices nothing is known.
    const std::string other = "; b -> bb }\nlet H = D0L { axiom b; b -> bbb }\n";
    CHECK(verdict("let G = D0L { axiom ab; a -> aa" + other + "show L(G) | L(H) is EDT0L") ==
          "proved by closed");
    CHECK(
        judged("let G = 0L { axiom ab; a -> aa | a" + other + "show L(G) | L(H) is EDT0L").truth ==
        Truth::undecided);
    // The construction has letters that the alphabet of the claim has not.
    CHECK(judged("let G = 0L { axiom ab; a -> aa; b -> bb | b }\nshow L(G) & /a*b*/ is finite")
              .argument.find("goes round from a_1 to a_1") != std::string::npos);
}

TEST_CASE("an equivalence of families has the least language of one of them as counterexample") {
    CHECK(judged("theorem for all 0L languages A: (A is P0L) iff (A is PD0L)")
              .argument.starts_with("The least counterexample is A = {a, b, aa}, of size 7."));
    // Systems without erasing rules, which no finite language with the empty word has.
    CHECK(judged("theorem for all 0L languages A: A is PIL").truth == Truth::refuted);
}
