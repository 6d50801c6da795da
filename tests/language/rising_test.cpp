// Lengths that rise, of systems that may erase: against lengths counted word by word.

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <nlohmann/json.hpp>
#include <string>

#include "exact/exact.hpp"
#include "language/language.hpp"
#include "notation/notation.hpp"
#include "verify/verify.hpp"

using namespace algae;

namespace {

struct Sample {
    std::string axiom;
    std::vector<std::string> rules;  // of a, b, c
};

Sample random_sample() {
    const auto word = [](int least, int most) {
        std::string text;
        for (int left = *rc::gen::inRange(least, most); left > 0; --left)
            text += static_cast<char>('a' + *rc::gen::inRange(0, 3));
        return text;
    };
    return {word(1, 4), {word(0, 4), word(0, 4), word(0, 4)}};
}

CheckedClaim checked(const Sample& sample, bool strictly) {
    std::string text = "claim T\nlet G = D0L { axiom " + sample.axiom + "; ";
    for (std::size_t i = 0; i < 3; ++i)
        text += std::string(1, static_cast<char>('a' + i)) + " -> " +
                (sample.rules[i].empty() ? "ε" : sample.rules[i]) + "; ";
    text += "}\nshow growth(G) is " + std::string(strictly ? "strictly " : "") + "increasing\n";
    return check(read_claim(text, "x", {}));
}

/// The lengths of the first generations, until there are many letters.
std::vector<std::size_t> lengths(const Sample& sample) {
    std::vector<std::size_t> all;
    std::string word = sample.axiom;
    for (int n = 0; n < 40 && word.size() < 5000; ++n) {
        all.push_back(word.size());
        std::string next;
        for (const char a : word) next += sample.rules[static_cast<std::size_t>(a - 'a')];
        word = next;
    }
    return all;
}

}  // namespace

TEST_CASE("whether lengths rise is as counted, and what is proved is checked again") {
    std::size_t compared = 0, erasing = 0, proved = 0, decided = 0;
    CHECK(rc::check([&] {
        const Sample sample = *rc::gen::resize(100, rc::gen::exec(random_sample));
        const bool strictly = *rc::gen::arbitrary<bool>();
        const CheckedClaim found = checked(sample, strictly);
        const auto counted = lengths(sample);
        bool rises = true;
        for (std::size_t n = 0; n + 1 < counted.size(); ++n)
            rises = rises && counted[n] + (strictly ? 1 : 0) <= counted[n + 1];
        const Truth truth = found.statements[0].answer.truth;
        ++compared;
        erasing += sample.rules[0].empty() || sample.rules[1].empty() || sample.rules[2].empty();
        RC_ASSERT(!(truth == Truth::proved && !rises));
        RC_ASSERT(!(truth == Truth::refuted && rises && counted.size() == 40));
        proved += truth == Truth::proved;
        decided += truth != Truth::undecided;
        if (truth == Truth::undecided) return;
        const auto again = verify::check_certificate(certificate(found).dump());
        RC_ASSERT(again.at(0).outcome == verify::Finding::Outcome::checked);
    }));
    MESSAGE(compared << " compared, " << erasing << " erase, " << proved << " rise, " << decided
                     << " decided");
    CHECK(compared >= 100);
    CHECK(erasing >= 20);
    CHECK(decided * 100 >= compared * 95);
}

TEST_CASE("a proof that lengths rise is refused where one of its conditions fails") {
    // a -> ab, b -> ε: 1, 2, 2, 2, ...; a -> bb, b -> a: 1, 2, 2, 4, 4; a -> bc, b -> a, c -> ε: 1, 2, 1, 2
    const auto outcome = [](const Sample& sample, bool strictly, const char* generation) {
        CheckedClaim made = checked(sample, strictly);
        auto written = certificate(made);
        written["statements"][0].erase("argument");
        written["statements"][0]["verdict"] = "proved";
        written["statements"][0].erase("citation");
        written["statements"][0]["proof"] = {
            {"by", "vectors"}, {"generation", nlohmann::ordered_json::parse(generation)}};
        return verify::check_certificate(written.dump()).at(0);
    };
    using Outcome = verify::Finding::Outcome;
    const Sample bounded{"a", {"ab", "", "c"}}, steps{"a", {"bb", "a", "c"}},
        turning{"a", {"bc", "a", ""}}, fallen{"aaa", {"b", "bc", ""}};
    CHECK(outcome(bounded, false, "0").outcome == Outcome::checked);
    CHECK(outcome(bounded, true, "0").reason ==
          "no lasting letter occurs more often in the next word");
    CHECK(outcome(bounded, true, "1").reason == "after generation 1 the length does not rise");
    CHECK(outcome(steps, false, "0").reason == "a letter occurs less often in the next word");
    CHECK(outcome(steps, false, "7").reason == "a letter occurs less often in the next word");
    CHECK(outcome(turning, false, "1").reason == "after generation 1 the length does not rise");
    CHECK(outcome(fallen, false, "1").outcome == Outcome::checked);
    CHECK(outcome(bounded, false, "99999999999").outcome == Outcome::not_checked);
}
