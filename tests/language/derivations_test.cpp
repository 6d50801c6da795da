#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "exact/exact.hpp"
#include "language/language.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "verify/verify.hpp"

// What follows of given derivations, for all systems, words and numbers of steps.

using namespace algae;

namespace {

std::string outcome(const std::string& certificate) {
    return verify::to_string(verify::check_certificate(certificate, "x.json", {}).at(0).outcome);
}

/// "proved by derivations: checked".
std::string verdict(const std::string& theorem, std::string* written = nullptr) {
    SearchLimits limits;
    limits.instances = 2000;
    const CheckedClaim checked =
        check(read_claim("claim T\ntheorem " + theorem, "x.claim", {}), {}, limits);
    const CheckedStatement& statement = checked.statements.at(0);
    const std::string text = certificate(checked).dump(1);
    if (written) *written = text;
    const std::string by = method_of(statement.answer, *checked.claim.alphabet);
    return verdict_text(statement) + (by.empty() ? "" : " by " + by) + ": " + outcome(text);
}

const std::string proved = "proved by derivations: checked";

/// Whether a word derives `to` in so many steps, by the definition, letter by letter.
using Rules = std::map<char, std::vector<std::string>>;
class Letterwise {
public:
    Letterwise(const Rules& rules, std::string to) : rules_(rules), to_(std::move(to)) {}

    bool from(const std::string& word, int steps) { return spans(word, 0, to_.size(), steps); }

private:
    bool spans(const std::string& word, std::size_t begin, std::size_t end, int steps) {
        std::set<std::size_t> reached{begin};
        for (const char letter : word) {
            std::set<std::size_t> next;
            for (const std::size_t at : reached)
                for (std::size_t to = at; to <= end; ++to)
                    if (letter_spans(letter, at, to, steps)) next.insert(to);
            reached = std::move(next);
        }
        return reached.contains(end);
    }
    bool letter_spans(char letter, std::size_t begin, std::size_t end, int steps) {
        if (steps == 0) return end == begin + 1 && to_[begin] == letter;
        const auto [place, is_new] = known_.emplace(std::tuple(letter, begin, end, steps), false);
        if (!is_new) return place->second;
        bool found = false;
        for (const std::string& successor : rules_.at(letter))
            found = found || spans(successor, begin, end, steps - 1);
        return known_[{letter, begin, end, steps}] = found;
    }

    const Rules& rules_;
    std::string to_;
    std::map<std::tuple<char, std::size_t, std::size_t, int>, bool> known_;
};

/// x y ==> z in n + m steps: which bound words, and how often each number and 1.
struct Claimed {
    std::string from, to;
    std::array<int, 3> steps{};

    std::string text() const {
        std::string count;
        for (const auto& [name, times] : {std::pair("n", steps[0]), {"m", steps[1]}})
            for (int i = 0; i < times; ++i)
                count += (count.empty() ? "" : " + ") + std::string(name);
        if (steps[2] > 0 || count.empty())
            count += (count.empty() ? "" : " + ") + std::to_string(steps[2]);
        const auto spaced = [](const std::string& names) {
            std::string all;
            for (const char name : names) all += (all.empty() ? "" : " ") + std::string(1, name);
            return all.empty() ? "ε" : all;
        };
        return "G : " + spaced(from) + " ==> " + spaced(to) + " in " + count + " steps";
    }
};

Claimed any_pattern() {
    const auto names = [](int most) {
        std::string all;
        for (int i = *rc::gen::inRange(1, most + 1); i > 0; --i)
            all += *rc::gen::element('x', 'y', 'z');
        return all;
    };
    return {names(2),
            names(2),
            {*rc::gen::inRange(0, 2), *rc::gen::inRange(0, 2), *rc::gen::inRange(0, 2)}};
}

}  // namespace

TEST_CASE("theorems of textbooks on derivations are proved for all systems, words and steps") {
    CHECK(verdict(
              "for all 0L systems G and words x, y, u, v and numbers n with G : x ==> u in n steps "
              "and G : y ==> v in n steps: G : x y ==> u v in n steps") == proved);
    CHECK(verdict(
              "for all 0L systems G and words x, y, z and numbers n, m with G : x ==> y in n steps "
              "and G : y ==> z in m steps: G : x ==> z in n + m steps") == proved);
    CHECK(verdict("for all 0L systems G and words x, y, z with G : x ==> y and G : y ==> z: G : x "
                  "==> z") == proved);
    CHECK(
        verdict("for all P0L systems G and words x, y with G : x ==> y: length(x) <= length(y)") ==
        proved);
    CHECK(verdict("for all 0L systems G and letters x with G : x ==> x x: G : x ==> x x x x") ==
          proved);
    CHECK(verdict("for all 0L systems G and letters x with G : x x ==> x: G : x x ==> ε") ==
          proved);
    CHECK(
        verdict(
            "for all D0L systems G and words x, y, z and numbers n with G : x ==> y in n steps and "
            "G : x ==> z in n steps: {y} == {z}") == proved);
}

TEST_CASE(
    "what does not follow of derivations is not proved, and refuted where a counterexample is "
    "small") {
    CHECK(verdict("for all 0L systems G and words x, y with G : x ==> y: length(x) <= length(y)") ==
          "refuted by instance: checked");
    CHECK(verdict("for all 0L systems G and words x, y, z with G : x ==> y in 1 step and G : x ==> "
                  "z in 1 "
                  "step: {y} == {z}") == "refuted by instance: checked");
    CHECK(verdict("for all 0L systems G and words x, y with G : x ==> y in 1 step: G : x ==> y in "
                  "2 steps") == "refuted by instance: checked");
    CHECK(!verdict("for all T0L systems G and words x, y, u, v with G : x ==> u in 1 step and G : "
                   "y ==> v "
                   "in 1 step: G : x y ==> u v in 1 step")
               .starts_with("proved"));
}

TEST_CASE("what is proved of derivations holds for all small systems and words") {
    std::size_t holds = 0, compared = 0;
    CHECK(rc::check([&] {
        struct Drawn {
            std::vector<Claimed> conditions;
            Claimed goal;
            Rules rules;
        };
        const Drawn drawn = *rc::gen::resize(
            100, rc::gen::exec([] {
                Drawn made;
                for (int i = *rc::gen::inRange(1, 3); i > 0; --i)
                    made.conditions.push_back(any_pattern());
                made.goal = any_pattern();
                const Claimed one = made.conditions.front(), last = made.conditions.back();
                switch (*rc::gen::inRange(0, 5)) {  // some that follow
                    case 0:
                        made.goal = {one.from + one.from, one.to + one.to, one.steps};
                        break;
                    case 1:
                        made.conditions.push_back({one.to, last.from, {1, 0, 1}});
                        made.goal = {one.from,
                                     last.from,
                                     {one.steps[0] + 1, one.steps[1], one.steps[2] + 1}};
                        break;
                    case 2:
                        made.goal = {one.from + last.from, one.to + last.to, one.steps};
                        break;
                    default:
                        break;
                }
                for (const char letter : {'a', 'b'})
                    for (int i = *rc::gen::inRange(1, 3); i > 0; --i)
                        made.rules[letter].push_back(
                            *rc::gen::element<std::string>("", "a", "b", "aa", "ab", "ba"));
                return made;
            }));
        std::string theorem = "for all 0L systems G and words x, y, z and numbers n, m with ";
        for (std::size_t i = 0; i < drawn.conditions.size(); ++i)
            theorem += (i > 0 ? " and " : "") + drawn.conditions[i].text();
        theorem += ": " + drawn.goal.text();
        RC_LOG() << theorem << '\n';
        const std::string found = verdict(theorem);
        RC_ASSERT(found.ends_with(": checked") || found.ends_with(": undecided") ||
                  found.ends_with(": not checked"));
        if (!found.starts_with("proved")) return;
        ++holds;
        const std::vector<std::string> words{"", "a", "b", "aa", "ab", "ba", "bb"};
        for (const std::string& x : words)
            for (const std::string& y : words)
                for (const std::string& z : words)
                    for (int n = 0; n < 2; ++n)
                        for (int m = 0; m < 2; ++m) {
                            const auto is_so = [&](const Claimed& pattern) {
                                const auto filled = [&](const std::string& names) {
                                    std::string all;
                                    for (const char name : names)
                                        all += name == 'x' ? x : name == 'y' ? y : z;
                                    return all;
                                };
                                return Letterwise(drawn.rules, filled(pattern.to))
                                    .from(filled(pattern.from), pattern.steps[0] * n +
                                                                    pattern.steps[1] * m +
                                                                    pattern.steps[2]);
                            };
                            if (!std::all_of(drawn.conditions.begin(), drawn.conditions.end(),
                                             is_so))
                                continue;
                            ++compared;
                            RC_ASSERT(is_so(drawn.goal));
                        }
    }));
    MESSAGE(holds << " proved, " << compared << " instances that meet the conditions compared");
    CHECK(holds > 10);
    CHECK(compared > 100);
}

TEST_CASE("a derivation that a broken side condition does not allow is found wrong") {
    const auto broken = [&](const std::string& theorem, const std::string& from,
                            const std::string& to) {
        std::string text;
        CHECK(verdict(theorem, &text) == proved);
        const std::size_t at = text.find(from);
        REQUIRE(at != std::string::npos);
        text.replace(at, from.size(), to);
        return outcome(text);
    };
    const std::string product =
        "for all 0L systems G and words x, y, u, v and numbers n with G : x ==> u in n steps and G "
        ": y "
        "==> v in n steps: G : x y ==> u v in n steps";
    CHECK(broken(product, "\"0L systems\"", "\"T0L systems\"") == "WRONG");  // tables differ
    CHECK(broken(product, "\"steps\": \"n\"", "\"steps\": 1") == "WRONG");   // not as many steps
    CHECK(broken(product, "\"u v\"", "\"v u\"") == "WRONG");
    CHECK(broken(product, "\"product\"", "\"chain\"") == "WRONG");
    CHECK(broken("for all P0L systems G and words x, y with G : x ==> y: length(x) <= length(y)",
                 "\"P0L systems\"", "\"0L systems\"") == "WRONG");
    CHECK(
        broken(
            "for all D0L systems G and words x, y, z and numbers n with G : x ==> y in n steps and "
            "G : x ==> z in n steps: {y} == {z}",
            "\"D0L systems\"", "\"0L systems\"") == "WRONG");
    const std::string cut = "for all 0L systems G and letters x with G : x x ==> x: G : x x ==> ε";
    CHECK(broken(cut, "\"letters\"", "\"words\"") == "WRONG");  // a word may be cut within
    CHECK(broken(cut, "\"split\": 0,", "") == "WRONG");         // the cases are none
}
