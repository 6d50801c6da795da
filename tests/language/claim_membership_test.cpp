#include "language/detail/judge.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "certified.hpp"
#include "notation/notation.hpp"
#include "oracle/interaction.hpp"
#include "oracle/language_words.hpp"

using namespace algae;

namespace {

std::vector<Word> all_words(std::size_t longest) {
    std::vector<Word> words{{}};
    for (std::size_t i = 0; i < words.size(); ++i)
        if (words[i].size() < longest)
            for (const Symbol a : {0u, 1u}) {
                words.push_back(words[i]);
                words.back().push_back(a);
            }
    return words;
}

/// The set of short words, of the greatest length for which the oracle knows it.
std::pair<std::size_t, std::set<Word>> short_words(const Language& language) {
    for (const std::size_t longest : {5u, 3u})
        if (auto words = oracle::language_words(language, longest)) return {longest, *words};
    RC_DISCARD("no oracle");
}

}  // namespace

TEST_CASE("membership of all short words in random expressions is that of the definitions") {
    CHECK(rc::check([] {
        const random::Languages made = *random::any_language();
        const Language& language = made.all.front();
        const auto [longest, words] = short_words(language);
        for (const Word& word : all_words(longest)) {
            const Judgement found = in_sentences(
                judge_membership(language, word, *random::letters()), *random::letters());
            RC_LOG() << spell(*random::letters(), word) << '\n';
            RC_ASSERT(found.truth == Truth::undecided ||
                      (found.truth == Truth::proved) == words.contains(word));
            RC_ASSERT(found.argument.size() > 0u);
        }
    }));
}

TEST_CASE("membership of short words in random expressions has certificates that verify checks") {
    CHECK(rc::check([] {
        const random::Languages made = *random::any_language();
        Statement statement{HasWord{made.all.front(), random::word_of(*oracle::any_word("ab", 4))}};
        statement.negated = *rc::gen::arbitrary<bool>();
        const random::Certified found = random::sound(random::claim_of(statement, made.systems));
        RC_TAG(found.rule() + ": " + verify::to_string(found.finding.outcome));
    }));
}

namespace {

random::Certified member(const std::string& text) {
    return random::certified(read_claim("claim T; " + text, "t.claim", {}));
}

/// The letters of systems with contexts.
std::shared_ptr<const Alphabet> context_letters() {
    auto all = std::make_shared<Alphabet>();
    for (const char* name : {"a", "b", "c", "+"}) all->symbol(name);
    return all;
}

Word context_word(const std::string& text) {
    Word word;
    for (const char letter : text) word.push_back(*context_letters()->find(std::string(1, letter)));
    return word;
}

/// The system as claims have it: of the rules of a letter those with the longest contexts come first.
std::shared_ptr<const SourceSystem> context_system(const oracle::WrittenInteraction& written) {
    const auto letters = context_letters();
    IL system{letters, context_word(written.axiom),
              std::vector<std::vector<IL::Rule>>(letters->size()),
              std::vector<char>(letters->size(), 0), "G"};
    for (const Symbol a : context_word(written.ignored)) system.ignored[a] = 1;
    for (const auto& rule : written.rules)
        system.rules[context_word(std::string(1, rule.letter)).front()].push_back(
            {context_word(rule.left), context_word(rule.right), context_word(rule.successor)});
    const auto size = [](const IL::Rule& rule) { return rule.left.size() + rule.right.size(); };
    for (auto& rules : system.rules)
        std::stable_sort(
            rules.begin(), rules.end(),
            [&](const IL::Rule& one, const IL::Rule& other) { return size(one) > size(other); });
    return std::make_shared<const SourceSystem>(SourceSystem{"G", std::nullopt, std::move(system)});
}

/// Random contexts; in half of the systems no rule erases and some successors are longer.
oracle::WrittenInteraction any_context_system() {
    oracle::WrittenInteraction system = *oracle::any_interaction(false);
    if (*rc::gen::arbitrary<bool>())
        for (auto& rule : system.rules)
            if (rule.successor.empty()) rule.successor = *oracle::any_nonempty_word("ab", 2);
    return system;
}

/// The generations of a system, until one comes again or is much longer than `longest`, at most 40; and
/// whether these are all its words of at most `longest` letters.
struct Generations {
    std::vector<std::string> words;
    bool complete = false;
};

Generations generations_of(const oracle::WrittenInteraction& system, std::size_t longest) {
    const bool erases = std::any_of(system.rules.begin(), system.rules.end(),
                                    [](const auto& rule) { return rule.successor.empty(); });
    Generations found;
    for (std::string word = system.axiom; found.words.size() < 40;
         word = oracle::after(system, word)) {
        if (std::find(found.words.begin(), found.words.end(), word) != found.words.end())
            return {found.words, true};
        if (word.size() > (erases ? 10 : 1) * longest) return {found.words, !erases};
        found.words.push_back(word);
    }
    return found;
}

/// Words of the system, words that are almost words of it, and a short one.
std::vector<std::string> words_to_try(const Generations& generations) {
    const std::string word = *rc::gen::elementOf(generations.words);
    std::string other = word;
    if (!other.empty()) other[*rc::gen::inRange<std::size_t>(0, other.size())] = 'a';
    return {word, other, word + *oracle::any_word("ab", 2), *oracle::any_word("abc+", 4)};
}

}  // namespace

TEST_CASE("membership in systems with contexts is that of the generations, and verify checks it") {
    constexpr std::size_t longest = 100;
    std::size_t members = 0, others = 0, outgrown = 0, checked = 0, undecided = 0;
    CHECK(rc::check([&] {
        const oracle::WrittenInteraction system = any_context_system();
        const auto source = context_system(system);
        const Generations generations = generations_of(system, longest);
        for (const std::string& word : words_to_try(generations)) {
            RC_LOG() << system << "; " << word << '\n';
            Claim claim = random::claim_of(
                {HasWord{generated_language(source), context_word(word)}}, {source});
            claim.alphabet = context_letters();
            const random::Certified found = random::sound(claim);
            const Truth truth = found.judgement.truth;
            const bool is_word = std::find(generations.words.begin(), generations.words.end(),
                                           word) != generations.words.end();
            const bool is_other = !is_word && generations.complete && word.size() <= longest;
            RC_ASSERT(!is_word || truth == Truth::proved);
            RC_ASSERT(!is_other || truth == Truth::refuted);
            members += is_word;
            others += is_other;
            outgrown +=
                found.judgement.argument.front().find("words are longer") != std::string::npos;
            checked += found.is_checked();
            undecided += truth == Truth::undecided;
        }
    }));
    MESSAGE(members << " words of the systems and " << others << " others, " << outgrown
                    << " of these outgrown; " << checked << " certificates checked, " << undecided
                    << " words undecided");
    CHECK(members >= 100);
    CHECK(others >= 50);
    CHECK(outgrown >= 20);
    CHECK(checked >= 150);
}

TEST_CASE("a word that the generations of a system with contexts outgrow is not in its language") {
    const auto argument = [](const std::string& text) {
        const random::Certified found =
            member("let G = 1L { axiom ab; a > b -> aa; b -> bb }; " + text);
        CHECK_MESSAGE(found.is_checked(), found.finding.reason);
        return found.judgement.argument;
    };
    using Lines = std::vector<std::string>;
    CHECK(argument("show a not in L(G)") == Lines{"a is not in L(G): all its words are longer."});
    CHECK(argument("show bb not in L(G)") == Lines{"bb is not in L(G): generation 0 is not this "
                                                   "word, and from then on all words are longer."});
    CHECK(argument("show aaabbb not in L(G)") ==
          Lines{"aaabbb is not in L(G): generations 0 to 1 are not this word, and from then on all "
                "words are longer."});
    CHECK(argument("show aaabbbb in L(G)") == Lines{"aaabbbb is in L(G): ab => aabb => aaabbbb."});
}

TEST_CASE(
    "a word of a reversal is shown by the derivation of the reversed word, but by no word with "
    "this image") {
    const std::string system = "let G = D0L { axiom ab; a -> aab }; let h = { a -> ba; b -> a }; ";
    const random::Certified derived = member(system + "show bbaa in L(G)^R");
    CHECK(derived.judgement.truth == Truth::proved);
    CHECK(derived.proof.contains("derivation"));
    CHECK_MESSAGE(derived.is_checked(), derived.finding.reason);
    const random::Certified image = member(system + "show aab in h(L(G))^R");
    CHECK(image.judgement.truth == Truth::proved);
    CHECK(!image.proof.contains("preimage"));
    CHECK_MESSAGE(image.is_checked(), image.finding.reason);
}

TEST_CASE(
    "the axiom of a system with several tables is in its language by a derivation of no steps") {
    const random::Certified found =
        member("let T = T0L { axiom a; table p; a -> aa; table q; a -> b }; show a in L(T)");
    CHECK(found.judgement.truth == Truth::proved);
    CHECK_MESSAGE(found.is_checked(), found.finding.reason);
}

TEST_CASE(
    "what is undecided of a part is undecided of its complement, reversal and image back, without "
    "a proof") {
    // No b stands before an a, so nothing is erased, but the search does not see that.
    const std::string system =
        "let G = 1L { axiom ab; a > b -> aa; b > a -> ε; b -> bb }; let h = { a -> a; b -> b }; ";
    for (const char* language :
         {"L(G)", "~L(G)", "L(G)^R", "h^-1(L(G))", "L(G)+", "L(G) | {a}", "h(L(G))"}) {
        CAPTURE(language);
        const random::Certified found = member(system + "show bb in " + language);
        if (found.judgement.truth != Truth::undecided)
            continue;  // as soon as more is known of such systems
        CHECK(found.proof.is_null());
        CHECK(found.is_sound());
    }
}

TEST_CASE("arguments about operations end with what they come to") {
    const auto argument = [](const std::string& text) { return member(text).judgement.argument; };
    using Lines = std::vector<std::string>;
    CHECK(
        argument("let N = ~/a*b/; show aa in N") ==
        Lines{
            "aa is not in {a}* . {b}: no way to cut it in two has the parts in the two languages.",
            "So aa is in N."});
    CHECK(argument("let A = {aa, aaa}; refute ε in A+") ==
          Lines{"ε is not in A.", "So ε is not in A+."});
    CHECK(argument("let A = {ab} | {b}; show ab in A") ==
          Lines{"ab is in {ab}.", "So ab is in A."});
    CHECK(argument("show ab in {ba}^R") == Lines{"ba is in {ba}.", "So ab is in {ba}^R."});
    CHECK(argument("let h = { a -> b }; show a in h^-1({b})") ==
          Lines{"The image of a is b.", "b is in {b}.", "So a is in { a -> b }^-1({b})."});
    CHECK(argument("let G = D0L { axiom aa; a -> aa }; show ε not in L(G)") ==
          Lines{"ε is not in L(G): all its words are longer."});
    CHECK(argument("let G = D0L { axiom a; a -> aa }; show aaa not in L(G)") ==
          Lines{"aaa is not in L(G): generations 0 to 1 are not this word, and from then on all "
                "words are longer."});
}
