// D0L languages: inclusion in one another, and regularity where lengths grow linearly.

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <variant>

#include "language/detail/equality.hpp"
#include "language/detail/judge.hpp"
#include "language/detail/progressions.hpp"
#include "language/detail/regular.hpp"
#include "language/language.hpp"
#include "notation/notation.hpp"
#include "oracle/random_systems.hpp"
#include "verify/verify.hpp"

using namespace algae;
using Outcome = verify::Finding::Outcome;

namespace {

/// The rule of the proof, "+" if the statement is proved and "-" if it is refuted, and "checked" by verify; or "undecided".
std::string decided(const std::string& lines) {
    const CheckedClaim claim = check(read_claim("claim T\n" + lines + "\n", "x", {}));
    const Answer& answer = claim.statements.front().answer;
    if (answer.truth == Truth::undecided) return "undecided";
    const auto json = certificate(claim);
    const auto found = verify::check_certificate(json.dump()).front();
    return json["statements"][0]["proof"]["by"].get<std::string>() +
           (answer.truth == Truth::proved ? " + " : " - ") + verify::to_string(found.outcome) +
           (found.reason.empty() ? "" : ": " + found.reason);
}

std::string inclusion(const std::string& left, const std::string& right) {
    return decided("let H = D0L { " + left + " }\nlet G = D0L { " + right +
                   " }\nshow L(H) <= L(G)");
}

std::string regularity_of(const std::string& system) {
    return decided("let G = D0L { " + system + " }\nshow L(G) is regular");
}

std::set<std::string> words_up_to_length(const oracle::WrittenSystem& system, std::size_t longest,
                                         std::size_t most) {
    std::set<std::string> words;
    oracle::WrittenSystem from = system;
    for (std::size_t n = 0; n < most && from.axiom.size() <= 50 * longest; ++n) {
        if (from.axiom.size() <= longest) words.insert(from.axiom);
        from.axiom = oracle::rewritten(from, 1);
    }
    return words;
}

/// A system whose lengths grow linearly at most: a, b, d and e take turns, with what stays bounded on either side of them.
oracle::WrittenSystem any_linear() {
    const auto beside = [] { return *oracle::any_word("ccpqmk", 2); };
    const auto with = [&](char letter) { return beside() + letter + beside(); };
    oracle::WrittenSystem system{
        *oracle::any_nonempty_word("abdcp", 3),
        {{'p', {"q"}}, {'q', {"p"}}, {'m', {""}}, {'k', {"m"}}, {'c', {"c"}}}};
    system.successors['a'] = {with(*rc::gen::element('a', 'b'))};
    system.successors['b'] = {with('a')};
    system.successors['d'] = {with(*rc::gen::element('d', 'a'))};
    return system;
}

}  // namespace

TEST_CASE("a tail and a section of a D0L sequence are within its language") {
    CHECK(inclusion("axiom aa; a -> aa", "axiom a; a -> aa") == "sections + checked");
    CHECK(inclusion("axiom ab; a -> aba; b -> ab", "axiom b; a -> ab; b -> a") ==
          "sections + checked");
    CHECK(inclusion("axiom a; a -> aa", "axiom aa; a -> aa") == "word - checked");
    CHECK(inclusion("axiom a; a -> aaa", "axiom a; a -> aa") == "word - checked");
    CHECK(inclusion("axiom b; a -> ab; b -> a", "axiom ab; a -> aba; b -> ab") == "word - checked");
}

TEST_CASE("a word of a D0L language that is not in the other one") {
    CHECK(inclusion("axiom xay; a -> aa", "axiom xaby; x -> xa; y -> by") == "word - checked");
    CHECK(inclusion("axiom xabz; x -> xc; c -> cdd; z -> ze; e -> eff; a -> a",
                    "axiom xabz; x -> xc; z -> ze") == "word - checked");
}

TEST_CASE("a D0L language of linear growth is regular if one period goes through all its powers") {
    CHECK(regularity_of("axiom ca; a -> abd; b -> d; d -> b; c -> cd") ==
          "unequal powers - checked");
    CHECK(regularity_of("axiom a; a -> ab") == "progressions + checked");
    CHECK(regularity_of("axiom a; a -> bac") == "unequal powers - checked");
    CHECK(regularity_of("axiom a; a -> bab") == "unequal powers - checked");
    CHECK(regularity_of("axiom ac; a -> ab; b -> b; c -> bc") == "progressions + checked");
    CHECK(regularity_of("axiom ac; a -> ab; c -> bbc") == "progressions + checked");
    CHECK(
        regularity_of("axiom p; p -> q; q -> r; r -> s; s -> t; t -> u; u -> v; v -> px; x -> x") ==
        "progressions + checked");
}

TEST_CASE("regularity of D0L languages of linear growth agrees with their first words") {
    std::size_t regular = 0, other = 0, words = 0;
    CHECK(rc::check([&] {
        const auto written = *rc::gen::exec(any_linear);
        const auto found = regularity(oracle::d0l_of(written));
        if (!found) return;
        if (const auto* section = std::get_if<SectionOfPowers>(&*found)) {
            // The words of the section, made of the parts and by the rules.
            ++other;
            oracle::WrittenSystem from = written;
            from.axiom = oracle::rewritten(from, static_cast<unsigned>(section->first));
            const D0L system = oracle::d0l_of(written);
            for (std::size_t n = 0; n < 4; ++n) {
                Word made;
                for (const auto& part : section->parts) {
                    for (std::size_t i = 0; i < n; ++i)
                        made.insert(made.end(), part.left.begin(), part.left.end());
                    made.insert(made.end(), part.word.begin(), part.word.end());
                    for (std::size_t i = 0; i < n; ++i)
                        made.insert(made.end(), part.right.begin(), part.right.end());
                }
                RC_ASSERT(oracle::text_of(*system.alphabet, made) == from.axiom);
                from.axiom = oracle::rewritten(from, static_cast<unsigned>(section->step));
                ++words;
            }
            return;
        }
        ++regular;
        const D0L system = oracle::d0l_of(written);
        const auto value =
            regular_value(as_expression(std::get<Progressions>(*found)), *system.alphabet);
        RC_ASSERT(value.has_value());
        const std::size_t longest = 24;
        std::set<std::string> made;
        for (const Word& word : words_up_to(*value, longest))
            made.insert(oracle::text_of(*system.alphabet, word));
        RC_ASSERT(made == words_up_to_length(written, longest, 120));
        words += made.size();
    }));
    MESSAGE(regular << " regular, " << other << " not, " << words << " words compared");
    CHECK(regular >= 5);
    CHECK(other >= 3);
}

TEST_CASE("inclusion of D0L languages agrees with their first words") {
    std::size_t within = 0, outside = 0, open = 0;
    CHECK(rc::check([&] {
        const auto right =
            *rc::gen::arbitrary<bool>() ? *oracle::any_d0l() : *rc::gen::exec(any_linear);
        auto left = right;  // a tail, and perhaps every second word
        left.axiom = oracle::rewritten(right, *rc::gen::inRange(0U, 3U));
        if (*rc::gen::arbitrary<bool>())
            for (auto& [letter, successors] : left.successors) {
                oracle::WrittenSystem from = right;
                from.axiom = std::string(1, letter);
                successors = {oracle::rewritten(from, 2)};
            }
        if (*rc::gen::inRange(0, 3) == 0) left.axiom += 'a';
        const D0L one = oracle::d0l_of(left), other = oracle::d0l_of(right);
        for (const D0L* each : {&one, &other})
            if (finiteness(ol_of(*each)).finite) return;
        const LanguageInclusion found = included_language(one, other);
        const auto lefts = words_up_to_length(left, 16, 60),
                   rights = words_up_to_length(right, 16, 200);
        if (!found.included) {
            ++open;
        } else if (*found.included) {
            ++within;
            RC_ASSERT(std::includes(rights.begin(), rights.end(), lefts.begin(), lefts.end()));
        } else {
            ++outside;
            if (found.difference->length <= Integer(16))
                RC_ASSERT(!rights.contains(oracle::text_of(
                    *over_common_alphabet(one, other).alphabet, *found.difference->word)));
        }
    }));
    MESSAGE(within << " within, " << outside << " not, " << open << " open");
    CHECK(within >= 4);
    CHECK(outside >= 1);
    CHECK(open * 5 <= within + outside);
}

TEST_CASE("a section begins where every letter rests") {
    // Both letters beside the middle rest from the first step on, so after as many steps as there are letters.
    const auto found = regularity(d0l("a", {{'a', "bac"}}));
    const auto& section = std::get<SectionOfPowers>(*found);
    CHECK(section.first == 3);
    CHECK(section.parts.at(1).word.size() == 1);
}
