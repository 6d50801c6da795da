#include "language/detail/interactive.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "certified.hpp"
#include "language/language.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"

using namespace algae;

namespace {

// --- The oracle: strings, rewritten by the definition ---

struct Rules {
    struct Rule {
        std::string left;
        char letter;
        std::string right, successor;
    };
    std::string axiom;
    std::vector<Rule> rules;
    std::string ignored;

    bool erases() const {
        return std::any_of(rules.begin(), rules.end(),
                           [](const Rule& rule) { return rule.successor.empty(); });
    }
    std::string text() const {
        std::string all = "axiom " + axiom;
        for (const auto& [left, letter, right, successor] : rules)
            all += "; " + (left.empty() ? "" : left + " < ") + letter +
                   (right.empty() ? "" : " > " + right) + " -> " + successor;
        if (!ignored.empty()) {
            all += "; ignore";
            for (const char letter : ignored) all += std::string(" ") + letter;
        }
        return all;
    }
    bool sees(char letter) const { return ignored.find(letter) == std::string::npos; }

    std::vector<std::string> successors(const std::string& word, std::size_t place) const {
        std::string before, behind;
        for (std::size_t i = 0; i < word.size(); ++i)
            if (i != place && sees(word[i])) (i < place ? before : behind) += word[i];
        std::size_t best = rules.size(), most = 0;
        for (std::size_t i = 0; i < rules.size(); ++i) {
            const Rule& rule = rules[i];
            if (rule.letter != word[place] || !before.ends_with(rule.left) ||
                !behind.starts_with(rule.right))
                continue;
            const std::size_t size = rule.left.size() + rule.right.size();
            if (best < rules.size() && size <= most) continue;
            best = i;
            most = size;
        }
        if (best == rules.size()) return {std::string(1, word[place])};
        std::vector<std::string> all;
        for (const Rule& rule : rules)
            if (rule.letter == rules[best].letter && rule.left == rules[best].left &&
                rule.right == rules[best].right)
                all.push_back(rule.successor);
        return all;
    }

    /// Of at most `longest` letters; `cut` is set if there is a longer one.
    std::set<std::string> next(const std::string& word, std::size_t longest, bool& cut) const {
        std::set<std::string> made{""};
        for (std::size_t i = 0; i < word.size(); ++i) {
            std::set<std::string> longer;
            for (const std::string& start : made)
                for (const std::string& successor : successors(word, i)) {
                    if (start.size() + successor.size() <= longest)
                        longer.insert(start + successor);
                    else
                        cut = true;
                }
            made = longer;
        }
        return made;
    }

    /// The words that are derived through words of at most `longest` letters, at most `most` of them.
    struct Words {
        std::set<std::string> words;
        bool is_all = true;  // the language has no others
        bool ended = true;   // no others are derived through words so short
    };
    Words language(std::size_t longest, std::size_t most) const {
        Words found;
        if (axiom.size() > longest) return {{}, false, true};
        std::vector<std::string> open{axiom};
        found.words.insert(axiom);
        bool cut = false;
        for (std::size_t i = 0; i < open.size(); ++i) {
            if (open.size() > most) return {found.words, false, false};
            for (const std::string& word : next(std::string(open[i]), longest, cut))
                if (found.words.insert(word).second) open.push_back(word);
        }
        found.is_all = !cut;
        return found;
    }
};

enum class Erasing { no, maybe };

rc::Gen<Rules> any_rules(Erasing erasing, const std::string& letters = "ab") {
    return rc::gen::resize(
        100, rc::gen::exec([=] {
            const auto letter = [&] { return *rc::gen::elementOf(letters); };
            const auto word = [&](std::size_t least, std::size_t most) {
                std::string made(*rc::gen::inRange(least, most + 1), ' ');
                for (char& c : made) c = letter();
                return made;
            };
            Rules made;
            made.axiom = word(1, 3);
            const std::size_t least = erasing == Erasing::no ? 1 : 0;
            const std::size_t count = *rc::gen::inRange<std::size_t>(2, 6);
            for (std::size_t i = 0; i < count; ++i) {
                // Contexts are rare, so that they match, and long successors are not.
                const std::size_t left = *rc::gen::inRange(0, 3) == 0,
                                  right = *rc::gen::inRange(0, 3) == 0;
                Rules::Rule rule{word(left, left), letter(), word(right, right), word(least, 2)};
                if (*rc::gen::inRange(0, 3) == 0) rule.successor = word(2, 2);
                if (!made.rules.empty() && *rc::gen::inRange(0, 3) == 0) {  // a choice
                    const std::string successor = rule.successor;
                    rule = made.rules.back();
                    rule.successor = successor;
                }
                if (*rc::gen::inRange(0, 6) == 0) rule.left = word(2, 2);
                made.rules.push_back(rule);
            }
            if (*rc::gen::inRange(0, 5) == 0) made.ignored = std::string(1, letter());
            return made;
        }));
}

Claim claim_of(const Rules& rules, const std::string& statements) {
    return read_claim("claim T; alphabet a b c; let G = IL { " + rules.text() + " }; " + statements,
                      "t.claim", {});
}

std::string shown(const std::string& word) { return word.empty() ? "ε" : word; }

/// A statement decided and certified; a failure where verify finds a proof wrong.
random::Certified certified(const Rules& rules, const std::string& statement) {
    return random::sound(claim_of(rules, statement));
}

/// Whether a word is in a regular expression, by the definition: all words up to a length.
const std::map<std::string, bool (*)(const std::string&)>& expressions() {
    static const auto counts = [](const std::string& word, char letter) {
        return std::count(word.begin(), word.end(), letter);
    };
    static const std::map<std::string, bool (*)(const std::string&)> all{
        {"/a*b*/", [](const std::string& w) { return w.find("ba") == std::string::npos; }},
        {"/a*b/", [](const std::string& w) { return w.ends_with('b') && counts(w, 'b') == 1; }},
        {"/(a|b)*/", [](const std::string&) { return true; }},
        {"/(a|b)+/", [](const std::string& w) { return !w.empty(); }},
        {"/a(a|b)*/", [](const std::string& w) { return w.starts_with('a'); }},
        {"/(a|b)*a/", [](const std::string& w) { return w.ends_with('a'); }},
        {"/(a|b)*bb(a|b)*/",
         [](const std::string& w) { return w.find("bb") != std::string::npos; }},
        {"/((a|b)(a|b))*/", [](const std::string& w) { return w.size() % 2 == 0; }},
        {"/(b|ab*a)*/", [](const std::string& w) { return counts(w, 'a') % 2 == 0; }},
        {"/b*|b*ab*/", [](const std::string& w) { return counts(w, 'a') <= 1; }}};
    return all;
}

}  // namespace

TEST_CASE(
    "words of systems with context and choices are those of strings rewritten by the definition") {
    std::size_t words = 0;
    CHECK(rc::check("one step", [&] {
        const Rules rules = *any_rules(Erasing::maybe, "abc");
        RC_LOG() << rules.text() << '\n';
        const LSystem system = read_lsystem(rules.text(), "w.lsys");
        const IL view = *as_il(system);
        ContextStep step(view);
        bool cut = false;
        std::set<std::string> expected{rules.axiom}, level{rules.axiom};
        for (int n = 0; n < 3 && level.size() < 200; ++n) {
            std::set<std::string> next;
            for (const std::string& word : level) {
                const std::set<std::string> own = rules.next(word, 12, cut);
                std::set<std::string> found;
                Word letters;
                for (const char c : word)
                    letters.push_back(*view.alphabet->find(std::string(1, c)));
                for (const Word& each : step.next(letters, 12)) {
                    found.insert(each.empty() ? "" : spell(*view.alphabet, each));
                    RC_ASSERT(step.gives(letters, each));
                }
                RC_ASSERT(found == own);
                next.insert(own.begin(), own.end());
                words += own.size();
            }
            level = next;
        }
    }));
    MESSAGE(words << " words");
    CHECK(words > 50);
}

TEST_CASE("membership in systems with context is that of a search through all words") {
    for (const Erasing erasing : {Erasing::no, Erasing::maybe}) {
        std::size_t asked = 0, decided = 0, members = 0, others = 0, checked = 0, choices = 0;
        CHECK(rc::check("membership", [&] {
            const Rules rules = *any_rules(erasing);
            RC_LOG() << rules.text() << '\n';
            choices += !is_deterministic(*as_il(read_lsystem(rules.text(), "w.lsys")));
            const bool erases = rules.erases();
            const auto known = rules.language(erases ? 10 : 6, 3000);
            for (int i = 0; i < 3; ++i) {
                std::string word(*rc::gen::inRange<std::size_t>(0, 6), 'a');
                for (char& c : word) c = *rc::gen::element('a', 'b');
                if (i == 0 && !known.words.empty())
                    word = *rc::gen::elementOf(
                        std::vector<std::string>(known.words.begin(), known.words.end()));
                RC_LOG() << word << '\n';
                const auto found = certified(rules, "show " + shown(word) + " in L(G)");
                const Truth truth = found.judgement.truth;
                const bool is_word = known.words.count(word) > 0;
                const bool is_known = is_word || known.is_all || (!erases && known.ended);
                ++asked;
                decided += truth != Truth::undecided;
                members += truth == Truth::proved;
                others += truth == Truth::refuted;
                checked += found.is_checked();
                if (is_word) RC_ASSERT(truth != Truth::refuted);
                if (is_known && !is_word) RC_ASSERT(truth != Truth::proved);
                if (!erases) RC_ASSERT(truth != Truth::undecided);
            }
        }));
        MESSAGE(asked << " words asked, " << decided << " decided (" << members << " members, "
                      << others << " others), " << checked << " certificates checked, " << choices
                      << " systems with choices");
        CHECK(decided * 10 >= asked * 9);
        CHECK(checked * 10 >= decided * 9);
        CHECK(members * 20 >= asked);
        CHECK(others * 20 >= asked);
        CHECK(choices > 2);
    }
}

TEST_CASE("inclusion of a language with context in a regular one is that of its words") {
    std::size_t asked = 0, proved = 0, refuted = 0, checked = 0, infinite = 0;
    CHECK(rc::check("inclusion", [&] {
        const Rules rules = *any_rules(Erasing::maybe);
        std::vector<std::string> all;
        for (const auto& [text, is_in] : expressions()) all.push_back(text);
        const std::string expression = *rc::gen::elementOf(all);
        RC_LOG() << rules.text() << "; " << expression << '\n';
        const auto known = rules.language(9, 2000);
        const auto found = certified(rules, "show L(G) <= " + expression);
        const Truth truth = found.judgement.truth;
        const bool is_outside = std::any_of(known.words.begin(), known.words.end(),
                                            [is_in = expressions().at(expression)](
                                                const std::string& word) { return !is_in(word); });
        ++asked;
        proved += truth == Truth::proved;
        refuted += truth == Truth::refuted;
        infinite += found.rule() == "invariant";
        checked += found.is_checked();
        if (is_outside) RC_ASSERT(truth == Truth::refuted);
        if (known.is_all && !is_outside) RC_ASSERT(truth == Truth::proved);
    }));
    MESSAGE(asked << " inclusions, " << proved << " proved, " << infinite << " by invariants, "
                  << refuted << " refuted, " << checked << " certificates checked");
    CHECK((proved + refuted) * 10 >= asked * 9);
    CHECK(checked * 10 >= (proved + refuted) * 9);
    CHECK(infinite > 0);
}

TEST_CASE("finiteness of languages with context is that of a search through all words") {
    std::size_t asked = 0, finite = 0, infinite = 0, checked = 0;
    CHECK(rc::check("finiteness", [&] {
        const Rules rules = *any_rules(Erasing::maybe);
        RC_LOG() << rules.text() << '\n';
        const auto known = rules.language(9, 3000);
        const auto found = certified(rules, "show L(G) is finite");
        const Truth truth = found.judgement.truth;
        ++asked;
        finite += truth == Truth::proved;
        infinite += truth == Truth::refuted;
        checked += found.is_checked();
        if (known.is_all) RC_ASSERT(truth == Truth::proved);
        if (truth == Truth::proved) RC_ASSERT(rules.language(60, 30'000).is_all);
    }));
    MESSAGE(asked << " systems, " << finite << " finite, " << infinite << " infinite, " << checked
                  << " certificates checked");
    CHECK((finite + infinite) * 10 >= asked * 9);
    CHECK(checked * 10 >= (finite + infinite) * 9);
    CHECK(finite * 10 >= asked);
    CHECK(infinite * 10 >= asked);
}

namespace {

/// What verify says of the certificate of a claim after a change of its only proof.
verify::Finding changed(const std::string& text,
                        const std::function<void(nlohmann::ordered_json&)>& change) {
    const CheckedClaim checked = check(read_claim("claim T; alphabet a b; " + text, "t.claim", {}));
    nlohmann::ordered_json whole = certificate(checked);
    REQUIRE(verify::check_certificate(whole.dump(), "x").front().outcome ==
            verify::Finding::Outcome::checked);
    change(whole.at("statements").at(0).at("proof"));
    return verify::check_certificate(whole.dump(), "x").front();
}

const std::string growing = "let G = 1L { axiom ab; a > b -> aa }; ";
const std::string choosing = "let G = IL { axiom ab; a > b -> aa | b; b -> ε | b }; ";

}  // namespace

TEST_CASE("what systems with context are said to have, and changed certificates are rejected") {
    using Outcome = verify::Finding::Outcome;
    const std::string within = growing + "show L(G) <= /a*b/";
    CHECK(changed(within, [](auto& proof) {
              proof["automata"]["G"]["accepting"] = nlohmann::ordered_json::array();
          }).reason == "it does not accept the first word");
    CHECK(changed(within, [](auto& proof) {
              auto& automaton = proof["automata"]["G"];
              for (auto& state : automaton["accepting"]) state = 0;
          }).outcome == Outcome::wrong);
    const auto everything = nlohmann::ordered_json::parse(
        R"({"accepting": [0], "moves": [{"from": 0, "letter": "a", "to": 0}, {"from": 0, "letter": "b", "to": 0}]})");
    CHECK(changed(within, [&](auto& proof) { proof["automata"]["G"] = everything; }).reason ==
          "with the automata in the place of the systems a word is outside");
    const auto only_axiom = nlohmann::ordered_json::parse(
        R"({"accepting": [2], "moves": [{"from": 0, "letter": "a", "to": 1}, {"from": 1, "letter": "b", "to": 2}]})");
    CHECK(changed(within, [&](auto& proof) { proof["automata"]["G"] = only_axiom; }).reason ==
          "a word that it accepts becomes one that it does not accept");
    CHECK(changed(within, [](auto& proof) {
              proof["automata"] = nlohmann::ordered_json::object();
          }).outcome != Outcome::checked);

    const std::string without = choosing + "show bab not in L(G)";
    CHECK(changed(without, [&](auto& proof) { proof["automata"]["G"] = everything; }).reason ==
          "the automata do not keep the word out");

    const std::string infinite = choosing + "show L(G) is infinite";
    CHECK(changed(infinite, [](auto& proof) {
              for (auto& move : proof["automaton"]["moves"]) move["weight"] = "0";
          }).reason == "a step may leave the sum of weights as it is, or lower it");
    CHECK(changed(infinite, [](auto& proof) {
              for (auto& move : proof["automaton"]["moves"]) move["weight"] = "-1";
          }).outcome == Outcome::wrong);
    CHECK(changed(infinite, [](auto& proof) {
              proof["rules"] = nlohmann::ordered_json::array();
          }).outcome == Outcome::wrong);
    CHECK(changed(infinite, [](auto& proof) { proof["words"][0] = "b"; }).reason ==
          "the derivation does not begin with the axiom");
    CHECK(changed(infinite, [](auto& proof) { proof["rules"][0]["successor"] = "b b b"; }).reason ==
          "the system has no such rule, or another one was chosen before");
}

TEST_CASE("statements about systems with context in words") {
    const auto argument = [](const std::string& text) {
        const CheckedClaim checked =
            check(read_claim("claim T; alphabet a b; " + text, "t.claim", {}));
        const Answer& answer = checked.statements.front().answer;
        const Alphabet& alphabet = *checked.claim.alphabet;
        random::Certified found{in_sentences(answer, alphabet),
                                certificate(answer, alphabet),
                                {},
                                certificate(checked).dump()};
        found.finding = verify::check_certificate(found.text, "x").front();
        CHECK_MESSAGE(found.is_checked(), text);
        return found;
    };
    const auto within = argument(growing + "show L(G) <= /a*b/");
    CHECK(within.is_checked());
    CHECK(within.judgement.argument ==
          std::vector<std::string>{
              "An automaton with 3 states accepts the axiom of G and all that a word which it "
              "accepts becomes in one step, so every word of L(G).",
              "It accepts no word outside {a}* . {b}."});
    CHECK(argument(growing + "show L(G) == /a*ab/").rule() == "both");
    CHECK(argument(growing + "show L(G)^R <= /ba*/").rule() == "invariant");
    CHECK(argument(growing + "show L(G) | /ab*/ <= /a*b*/").rule() == "invariant");
    CHECK(argument(growing + "show L(G) & /b*/ is empty").rule() == "invariant");
    CHECK(argument(growing + "show { a -> b; b -> ε }(L(G)) <= /b*/").rule() == "invariant");
    CHECK(argument(growing + "show L(G)* <= /(a*b)*/").rule() == "invariant");
    CHECK(argument(growing + "show ab in L(G)").is_checked());
    CHECK(argument(choosing + "show G ==> aab in 1 steps").is_checked());
    CHECK(argument(choosing + "show not G ==> ab in 3 steps").is_checked());
    CHECK(argument(choosing + "show not G ==> ba").rule() == "invariant");
    CHECK(argument("let G = 1L { axiom ab; a > b -> aa | a }; show L(G) is IL").is_checked());
    CHECK_THROWS_WITH_AS(
        argument("let G = DIL { axiom ab; a > b -> aa | a }; show L(G) is finite"),
        doctest::Contains(
            "G is called a DIL system, but it is not a deterministic IL system: a has "
            "two rules with the same contexts"),
        Error);
}

TEST_CASE(
    "a short word that tells systems with context apart is found before all of their words are") {
    // Steps write 2^n words, of which few are new: all words of G took 22 s.
    const std::string erasing =
        "claim T\nlet G = 1L { axiom a; a -> ε; a -> aa; b -> ε; b < a -> ε; a < a -> ε; a < a -> "
        "a }\n";
    const std::string others[] = {"1L { axiom ab; a -> b; b -> a; b -> ab }",
                                  "0L { axiom b; a -> b; a -> aa; b -> a; b -> ab }"};
    for (const std::string& other : others)
        for (const std::string says : {"L(G) == L(H)", "L(H) == L(G)", "L(G) <= L(H)"}) {
            const CheckedClaim found =
                check(read_claim(erasing + "let H = " + other + "\nshow " + says, "x", {}));
            CHECK_MESSAGE(found.statements.at(0).answer.truth == Truth::refuted, other, says);
        }
    const IL system =
        as_il(read_lsystem("axiom a; a -> ε; a -> aa; a < a -> ε; a < a -> a", "x")).value();
    CHECK(!all_words_of(system, {}));
}

namespace {

Word word_of(const IL& system, const std::string& text) {
    Word word;
    for (const char name : text) word.push_back(*system.alphabet->find(std::string(1, name)));
    return word;
}

/// The words over these letters of a system.
RegularLanguage words_over(const IL& system, const std::string& names) {
    Word letters = word_of(system, names);
    std::sort(letters.begin(), letters.end());
    return all_words(letters);
}

RegularLanguage set_of(const IL& system, const std::vector<std::string>& texts) {
    std::vector<Word> words;
    for (const std::string& text : texts) words.push_back(word_of(system, text));
    return finite_set(words);
}

}  // namespace

TEST_CASE("an invariant is closed under steps and has no word outside") {
    using Outer = std::function<RegularLanguage(const IL&)>;
    struct Case {
        IL system;
        Outer outer_of;
        bool is_found;
    };
    const auto all_but = [](const std::string& names, const std::string& word) -> Outer {
        return [=](const IL& system) {
            const RegularLanguage all = words_over(system, names);
            return !word.empty() ? difference(all, set_of(system, {word})) : all;
        };
    };
    const Outer even = [](const IL& system) {
        const RegularLanguage letter = set_of(system, {"a", "b", "c"});
        return star(concatenated(letter, letter));
    };
    // Two letters a go where x is; there are as many as 2n, and ax is to be kept out: lengths modulo 2 tell why.
    const IL two_by_two = il("b", {"b -> aab", "b -> x", "a > ax ->", "a > x ->"});
    // A second letter a would make d; others stand between, more of them than are told apart: only d is taken away.
    const LSystem far = read_lsystem(
        "axiom a; a -> bab; b -> c; c -> e; e -> f; f -> g; a < a -> d; ignore b c e f g", "x");
    const LSystem tree = read_lsystem("axiom a[b]; a < b -> ab", "x");
    const std::vector<Case> cases{{il("ac", {"a -> bb", "c -> cc"}), even, true},
                                  {il("aa", {"a -> bb", "b -> ac"}), even, true},
                                  {il("ab", {"a > b -> aa"}), all_but("ab", "aa"), true},
                                  {il("ab", {"a > b -> aa"}), all_but("ab", "ab"), false},
                                  {il("ab", {"a > b -> aa"}), all_but("ab", "aab"), false},
                                  {two_by_two, all_but("abx", "ax"), true},
                                  {two_by_two, all_but("abx", "aax"), false},
                                  {as_il(far).value(), all_but("abcefg", ""), true},
                                  {as_il(far).value(), all_but("abcef", ""), false},
                                  {as_il(tree).value(), all_but("ab[]", ""), false}};
    for (std::size_t i = 0; i < cases.size(); ++i) {
        CAPTURE(i);
        const auto& [system, outer_of, is_found] = cases[i];
        const RegularLanguage outer = outer_of(system);
        const auto found = invariant_within(system, outer);
        CHECK(found.has_value() == is_found);
        if (!found) continue;
        CHECK(is_closed(system, *found) == true);
        CHECK(difference(*found, outer) == RegularLanguage());
    }
}

TEST_CASE("no invariant says what is missing from a language") {
    const Claim claim = read_claim(
        "claim T; " + growing + "let A = /a*b/ \\ L(G); let B = L(G) \\ /ab/; show A is empty", "x",
        {});
    const Language all = claim.languages.at(0), some = claim.languages.at(1);
    CHECK_FALSE(by_invariants(all, nullptr, {}, *claim.alphabet, {}));
    CHECK_FALSE(by_invariants(all, words_language({}), {}, *claim.alphabet, {}));
    CHECK_FALSE(by_invariants(some, words_language({}), {}, *claim.alphabet, {}));
    CHECK(by_invariants(some, all->parts.at(0), {}, *claim.alphabet, {}).has_value());
}

TEST_CASE("words that steps make longer") {
    const IL system = il("ab", {"a > b -> aa", "b -> b", "b -> ", "b -> bab"});
    const auto longer = longer_successors(system, set_of(system, {"ab", "b", "ba"}));
    REQUIRE(longer);
    CHECK(*longer == set_of(system, {"aab", "aabab", "bab", "baba"}));
}

TEST_CASE("a measure rises where lengths do not") {
    SourceSystem source;
    source.name = "G";
    // Every second step leaves the length as it is.
    source.interactive = il("ac", {"a > c -> d", "d > c -> ab", "d > b -> ab", "a > b -> d"});
    const auto found = endless_measure(source, {});
    CHECK(found.has_value());
}
