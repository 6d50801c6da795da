#include "language/detail/judge.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <nlohmann/json.hpp>

#include "certified.hpp"
#include "language/detail/regular.hpp"
#include "language/language.hpp"
#include "notation/notation.hpp"
#include "oracle/language_words.hpp"

using namespace algae;
using Kind = LanguageTree::Kind;

namespace {

Word certificate_word(const std::string& text) {
    Word word;
    for (const char letter : text)
        if (letter != ' ') word.push_back(static_cast<Symbol>(letter - 'a'));
    return word;
}

/// Whether a word is in a language, where the oracle knows words of its length.
std::optional<bool> contains(const Language& language, const Word& word) {
    if (word.size() > 6) return std::nullopt;
    const auto words = oracle::language_words(language, word.size());
    return words ? std::optional(words->contains(word)) : std::nullopt;
}

/// That the first language is included in the second, or is the same.
Statement related(const random::Languages& made, bool inclusion) {
    if (inclusion) return {IncludedIn{made.all[0], made.all[1]}};
    return {EqualLanguages{made.all[0], made.all[1]}};
}

/// Nothing that is found contradicts the short words of the two languages.
void compare(const random::Languages& made, bool inclusion) {
    const Language &left = made.all[0], &right = made.all[1];
    const random::Certified found =
        random::sound(random::claim_of(related(made, inclusion), made.systems));
    RC_TAG(found.rule() + ": " +
           (found.rule().empty() ? "undecided" : verify::to_string(found.finding.outcome)));
    if (found.judgement.truth == Truth::proved) {
        for (const std::size_t longest : {5u, 3u}) {
            const auto one = oracle::language_words(left, longest),
                       other = oracle::language_words(right, longest);
            if (!one || !other) continue;
            RC_ASSERT(std::includes(other->begin(), other->end(), one->begin(), one->end()));
            RC_ASSERT(inclusion || *one == *other);
            return;
        }
    }
    if (found.judgement.truth == Truth::refuted) {
        RC_ASSERT(found.rule() == "word");
        const Word word = certificate_word(found.proof.at("word").get<std::string>());
        const auto in_left = contains(left, word), in_right = contains(right, word);
        if (in_left && in_right) RC_ASSERT(*in_left != *in_right);
        if (inclusion && in_left) RC_ASSERT(*in_left);
        if (inclusion && in_right) RC_ASSERT(!*in_right);
    }
}

const random::Shape small{1};

/// Regular expressions only.
Language regular(random::Maker& make, int depth) {
    if (depth == 0) return make.words();
    const auto part = [&] { return regular(make, depth - 1); };
    switch (*rc::gen::inRange(0, 6)) {
        case 0:
            return combined(Kind::united, {part(), part()});
        case 1:
            return combined(Kind::concatenated, {part(), part()});
        case 2:
            return combined(Kind::star, {part()});
        case 3:
            return complement_language(part(), {0, 1});
        case 4:
            return inverse_image_language(part(), make.morphism());
        default:
            return combined(Kind::plus, {part()});
    }
}

}  // namespace

TEST_CASE("equality of random expressions is never against the definitions, and its proofs hold") {
    CHECK(rc::check([] { compare(*random::any_languages(small), false); }));
}

TEST_CASE("inclusion of random expressions is never against the definitions, and its proofs hold") {
    CHECK(rc::check([] { compare(*random::any_languages(small), true); }));
}

TEST_CASE("laws of the operations are never refuted") {
    CHECK(rc::check([] {
        const random::Languages made = *random::any_law(random::Shape{0});
        const Statement same = related(made, !*rc::gen::arbitrary<bool>());
        RC_ASSERT(random::sound(random::claim_of(same, made.systems)).judgement.truth !=
                  Truth::refuted);
    }));
}

TEST_CASE("random regular languages are compared with languages of systems, both ways") {
    CHECK(rc::check([] {
        const random::Languages made = *rc::gen::resize(
            100, rc::gen::exec([] {
                random::Maker make({});
                Language one = regular(make, 2), other = generated_language(make.system());
                if (*rc::gen::arbitrary<bool>()) std::swap(one, other);
                return make.made({one, other});
            }));
        compare(made, *rc::gen::arbitrary<bool>());
    }));
}

TEST_CASE(
    "every word of a regular language is in the base of its induction or one step from a shorter "
    "one") {
    CHECK(rc::check([] {
        const random::Languages made = *rc::gen::resize(
            100, rc::gen::exec([] {
                random::Maker make({});
                Language language = regular(make, 2);
                auto system = make.system();
                while (system->tables->tables.size() > 1 || !has_only_terminals(*system->tables))
                    system = make.system();
                return make.made({language, generated_language(system)});
            }));
        const auto words = oracle::language_words(made.all[0], 6);
        RC_PRE(words.has_value());
        const ET0L& system = *made.all[1]->system->tables;
        RegularLanguage whole = finite_set({});
        for (const Word& word : *words) whole = united(whole, finite_set({word}));
        const auto found = regular_induction(whole, system.tables, 200);
        RC_ASSERT(found.has_value());  // finitely many words
        std::set<Word> reached;
        for (const Word& word : *words) {
            std::set<std::pair<Word, bool>> next{{{}, false}};
            for (const Symbol a : word) {
                std::set<std::pair<Word, bool>> longer;
                for (const auto& [begun, grown] : next)
                    for (const Word& successor : system.tables.front()[a]) {
                        if (successor.empty()) continue;
                        Word more = begun;
                        more.insert(more.end(), successor.begin(), successor.end());
                        if (more.size() <= 6) longer.insert({more, grown || successor.size() > 1});
                    }
                next = std::move(longer);
            }
            for (const auto& [result, grown] : next)
                if (grown) reached.insert(result);
        }
        std::set<Word> base;
        for (const Word& word : *words)
            if (!reached.contains(word)) base.insert(word);
        RC_TAG(base.size());
        RC_ASSERT(std::set<Word>(found->base.begin(), found->base.end()) == base);
    }));
}

TEST_CASE("words with letters that have no image are left out of images of languages of systems") {
    const Claim claim = read_claim(
        "claim T; let G = 0L { axiom b; b -> ab }; let E = E0L { axiom b; b -> ab; b -> a; "
        "terminals a b };"
        "show L(G) is infinite; show L(E) is infinite",
        "t.claim", {});
    const Symbol a = *claim.alphabet->find("a");
    const auto language_of = [&](std::size_t i) {
        return std::get<IsFinite>(claim.statements[i].statement.says).language;
    };
    const Language only_b = language_of(0), some_a = language_of(1);
    const auto same = [&](const Language& language, std::vector<Word> words) {
        return judge_equality(language, words_language(std::move(words)), *claim.alphabet).truth ==
               Truth::proved;
    };
    CHECK(same(image_language(only_b, {{a, {}}}), {}));
    CHECK(same(image_language(some_a, {{a, {}}}), {{}}));
    CHECK(!same(image_language(some_a, {{a, {a, a}}}), {{a, a}}));
}

TEST_CASE("all words over one letter are soon compared with a language of a system") {
    const auto started = std::chrono::steady_clock::now();
    for (const char* text : {"show L(G) == /a+/", "show L(G)* == /a*/", "show L(E) != /a+/"})
        check(
            read_claim("claim T; let G = 0L { axiom a; a -> a; a -> aa }; let E = E0L { axiom a; a "
                       "-> aa; a -> a; terminals a }; " +
                           std::string(text),
                       "t.claim", {}));
    CHECK(std::chrono::steady_clock::now() - started < std::chrono::seconds(20));
}
