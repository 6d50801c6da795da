// Regular languages over one letter and families of L-systems: every answer is compared with all small systems, and every certificate is
// checked; lemmas on tables of lengths; and certificates that are changed.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <bitset>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "language/detail/lengths.hpp"
#include "language/language.hpp"
#include "notation/notation.hpp"
#include "verify/verify.hpp"

using namespace algae;
using Outcome = verify::Finding::Outcome;

namespace {

constexpr std::size_t width = 256;     // lengths that are kept
constexpr std::size_t most = 128;      // letters of words that are rewritten
constexpr std::size_t compared = 100;  // lengths up to here must be the same
using Lengths = std::bitset<width>;

const std::array<std::string, 4> families = {"0L", "P0L", "T0L", "PT0L"};

CheckedClaim checked(const std::string& statements) {
    return check(read_claim("claim T\n" + statements, "x", {}));
}

/// An ultimately periodic set, by its first numbers.
struct Periodic {
    std::size_t tail = 0, period = 1;
    std::vector<bool> has;

    bool contains(std::size_t n) const {
        return has[n < has.size() ? n : tail + (n - tail) % period];
    }
    Lengths lengths() const {
        Lengths found;
        for (std::size_t n = 0; n < width; ++n) found[n] = contains(n);
        return found;
    }
    bool is_infinite() const {
        for (std::size_t n = tail; n < has.size(); ++n)
            if (has[n]) return true;
        return false;
    }
    /// Whether neither the tail nor the period can be smaller.
    bool is_least() const {
        if (tail > 0 && has[tail - 1] == has[tail + period - 1]) return false;
        for (std::size_t d = 1; d < period; ++d) {
            bool same = period % d == 0;
            for (std::size_t n = tail; n + d < has.size() && same; ++n) same = has[n] == has[n + d];
            if (same) return false;
        }
        return true;
    }
    std::string text() const {
        std::string words = "{", rest;
        for (std::size_t n = 0; n < has.size(); ++n) {
            if (!has[n]) continue;
            const std::string word = n == 0 ? "ε" : std::string(n, 'a');
            if (n < tail)
                words += (words.size() > 1 ? ", " : "") + word;
            else
                rest += (rest.empty() ? "/" : "|") + std::string(n, 'a') + "(" +
                        std::string(period, 'a') + ")*";
        }
        return words.size() > 1 ? words + "} | " + rest + "/" : rest + "/";
    }
};

/// All infinite sets with this tail and period or smaller ones, each once.
std::vector<Periodic> all_sets(std::size_t size) {
    std::vector<Periodic> found;
    for (std::size_t period = 1; period <= size; ++period)
        for (std::size_t tail = 0; tail + period <= size; ++tail)
            for (unsigned bits = 0; bits < 1U << (tail + period); ++bits) {
                Periodic set{tail, period, {}};
                for (std::size_t n = 0; n < tail + period; ++n)
                    set.has.push_back((bits >> n & 1) != 0);
                if (set.is_infinite() && set.is_least()) found.push_back(set);
            }
    return found;
}

/// By number of letters, what they become by a table.
std::vector<Lengths> sums_of(const std::vector<std::size_t>& table) {
    std::vector<Lengths> sums(1);
    sums[0].set(0);
    for (std::size_t x = 1; x < most; ++x) {
        Lengths next;
        for (const std::size_t k : table)
            if (k < width) next |= sums.back() << k;
        sums.push_back(next);
    }
    return sums;
}

/// The lengths that tables derive from an axiom by way of lengths that are kept.
Lengths derived(std::size_t axiom, const std::vector<const std::vector<Lengths>*>& tables) {
    Lengths found, open;
    found.set(axiom);
    open.set(axiom);
    for (std::size_t x = axiom; x < most;) {
        open.reset(x);
        for (const auto* table : tables) {
            open |= (*table)[x] & ~found;
            found |= (*table)[x];
        }
        for (x = 0; x < most && !open[x];) ++x;
    }
    return found;
}

bool is_same(const Lengths& one, const Lengths& other) {
    for (std::size_t n = 0; n <= compared; ++n)
        if (one[n] != other[n]) return false;
    return true;
}

/// All tables with lengths up to some greatest one.
struct Tables {
    std::vector<std::vector<Lengths>> sums;
    std::vector<bool> erases;

    explicit Tables(std::size_t greatest) {
        for (unsigned bits = 1; bits < 1U << (greatest + 1); ++bits) {
            std::vector<std::size_t> table;
            for (std::size_t k = 0; k <= greatest; ++k)
                if ((bits >> k & 1) != 0) table.push_back(k);
            sums.push_back(sums_of(table));
            erases.push_back(table.front() == 0);
        }
    }
    /// Those that stay within the set.
    std::vector<const std::vector<Lengths>*> closed(const Lengths& set, bool propagating) const {
        std::vector<const std::vector<Lengths>*> found;
        for (std::size_t i = 0; i < sums.size(); ++i) {
            bool stays = !(propagating && erases[i]);
            for (std::size_t x = 1; x < most && stays; ++x)
                stays = !set[x] || (sums[i][x] & ~set).none();
            if (stays) found.push_back(&sums[i]);
        }
        return found;
    }
};

/// What the system of a proof derives.
Lengths derived_by(const nlohmann::ordered_json& system) {
    const auto length = [](const std::string& text) {
        return static_cast<std::size_t>(std::count(text.begin(), text.end(), 'a'));
    };
    std::vector<std::vector<Lengths>> sums;
    for (const auto& table : system.at("tables")) {
        std::vector<std::size_t> lengths;
        for (const auto& word : table.at("a")) lengths.push_back(length(word.get<std::string>()));
        sums.push_back(sums_of(lengths));
    }
    std::vector<const std::vector<Lengths>*> tables;
    for (const auto& each : sums) tables.push_back(&each);
    return derived(length(system.at("axiom").get<std::string>()), tables);
}

}  // namespace

TEST_CASE("every small language over one letter is decided as all small systems say") {
    constexpr std::size_t size = 7, greatest = 9;
    const Tables tables(greatest);
    std::map<std::string, std::size_t> proved, refuted, small;
    const std::vector<Periodic> sets = all_sets(size);
    for (const Periodic& set : sets) {
        const std::string text = set.text();
        CAPTURE(text);
        std::string statements;
        for (const std::string& family : families)
            statements += "show " + text + " is " + family + "\n";
        const CheckedClaim found = checked(statements);
        const auto json = certificate(found);
        const auto findings = verify::check_certificate(json.dump());
        const Lengths lengths = set.lengths();
        for (std::size_t i = 0; i < families.size(); ++i) {
            const std::string& family = families[i];
            CAPTURE(family);
            const Truth truth = found.statements[i].answer.truth;
            REQUIRE(truth != Truth::undecided);
            CHECK(findings[i].outcome == Outcome::checked);
            ++(truth == Truth::proved ? proved : refuted)[family];
            if (truth == Truth::proved)
                CHECK(is_same(derived_by(json.at("statements")[i].at("proof").at("system")),
                              lengths));
            // Whether a small system is seen to have the language: then it must be of the family.
            const bool propagating = family.front() == 'P';
            const auto closed = tables.closed(lengths, propagating);
            bool is_small = false;
            for (std::size_t axiom = 1; axiom <= greatest && !is_small; ++axiom) {
                if (!lengths[axiom]) continue;
                if (family.find('T') != std::string::npos)
                    is_small = is_same(derived(axiom, closed), lengths);
                else
                    for (const auto* table : closed)
                        is_small = is_small || is_same(derived(axiom, {table}), lengths);
            }
            if (is_small) {
                CHECK(truth == Truth::proved);
                ++small[family];
            }
        }
    }
    for (const std::string& family : families) {
        MESSAGE(family << ": " << sets.size() << " languages, " << proved[family] << " proved, "
                       << refuted[family] << " refuted, " << small[family]
                       << " have a system with lengths up to " << greatest);
        CHECK(proved[family] + refuted[family] == sets.size());
        CHECK(refuted[family] >= 30);
        CHECK(small[family] >= 30);
    }
}

TEST_CASE("what a table makes of shorter lengths, and from where on it makes all") {
    const auto power = [](std::size_t n) { return finite_set({Word(n, 0)}); };
    // 0, and all lengths from 20 on.
    const RegularLanguage long_ones =
        united(finite_set({Word{}}), concatenated(power(20), star(power(1))));
    const LengthSet set = *lengths_of(long_ones);
    CHECK(set.tail == 20);
    CHECK(set.period == 1);
    CHECK(set.contains(0));
    CHECK(!set.contains(19));
    CHECK(set.contains(1000));
    CHECK(!lengths_of(finite_set({{0}, {1}})));
    CHECK(!lengths_of(finite_set({Word{}})));
    const Numbers made = from_shorter(set, {{0, 20, 23}}, 70, 0);
    CHECK(!made.at(20));
    CHECK(made.at(23));
    CHECK(!made.at(22));
    CHECK(made.at(60));
    CHECK(made.at(0) == false);
    // All multiples of 20 beyond one, and no others.
    CHECK(from_shorter(set, {{20}}, 399, 0) == Numbers(399));
    CHECK(from_shorter(set, {{20}}, 400, 0).at(400));
    // 21 = 2 x 1 + 19, if lengths from 19 on are there, but a table has no shorter ones than they are long.
    CHECK(from_shorter(set, {{1}, {20}, 1}, 60, 0).at(39));
    CHECK(!from_shorter(set, {{1}, {20}, 1}, 60, 0).at(38));

    std::vector<std::size_t> all{0};
    for (std::size_t n = 20; n < 40; ++n) all.push_back(n);
    const auto found = length_induction(set, {{all}}, 10);
    REQUIRE(found);
    CHECK(found->base == std::vector<std::size_t>{0, 20});
    CHECK(found->tables == std::vector<std::size_t>{0});
    CHECK(found->from >= 20);
    // A length is missing for long lengths, or there are too many that come of no shorter one.
    CHECK(!length_induction(set, {{{0, 20, 22}}}, 100, 2000));
    CHECK(!length_induction(set, {{all}}, 1));
    CHECK(!length_induction(set, {{{0}}}, 100, 2000));
}

TEST_CASE(
    "equality with a system over one letter is decided where rules erase and words are long") {
    std::string text = "let G = 0L { axiom " + std::string(20, 'a') + "; a -> ε";
    for (std::size_t n = 20; n < 40; ++n) text += " | " + std::string(n, 'a');
    text += " }\nshow L(G) == {ε} | /" + std::string(20, 'a') + "a*/\n";
    const auto changed = [&](const std::function<void(nlohmann::ordered_json&)>& change) {
        auto json = certificate(checked(text));
        change(json.at("statements")[0].at("proof").at("proofs")[1]);
        return verify::check_certificate(json.dump())[0].outcome;
    };
    CHECK(checked(text).statements[0].answer.truth == Truth::proved);
    CHECK(changed([](nlohmann::ordered_json& proof) { CHECK(proof.contains("from")); }) ==
          Outcome::checked);
    CHECK(changed([](nlohmann::ordered_json& proof) { proof["from"] = 0; }) == Outcome::wrong);
    CHECK(changed([](nlohmann::ordered_json& proof) {
              proof["tables"] = nlohmann::ordered_json::array();
          }) == Outcome::wrong);
    CHECK(changed([](nlohmann::ordered_json& proof) { proof["tables"] = {1}; }) == Outcome::wrong);
    CHECK(changed([](nlohmann::ordered_json& proof) { proof["base"] = {""}; }) == Outcome::wrong);
    CHECK(changed([](nlohmann::ordered_json& proof) { proof.erase("from"); }) == Outcome::wrong);
}

TEST_CASE("languages over one letter that only infinitely many rules would generate") {
    // By a -> a^3 | a^12 | a^21 ... each word comes of a shorter one; of long words come multiples of 9 letters only.
    const std::string nine(9, 'a'), text = "{a} | /aaa(" + nine + ")*/ | /(" + nine + ")+/";
    std::string statements;
    for (const std::string& family : families)
        statements += "show " + text + " is " + family + "\n";
    const CheckedClaim found = checked(statements);
    const auto json = certificate(found);
    for (std::size_t i = 0; i < families.size(); ++i) {
        CHECK(found.statements[i].answer.truth == Truth::refuted);
        CHECK(verify::check_certificate(json.dump())[i].outcome == Outcome::checked);
    }
    CHECK(json.at("statements")[2].at("proof").at("targets")[0].contains("rest"));
}

TEST_CASE("long words over one letter are decided") {
    const auto power = [](std::size_t n) { return std::string(n, 'a'); };
    std::size_t proved = 0, refuted = 0;
    for (const std::string& text :
         {"{ε} | /" + power(50) + "a*/", "{a} | /" + power(30) + "a*/",
          "/(" + power(12) + ")*|(" + power(18) + ")*|" + power(5) + "(" + power(36) + ")*/",
          "/" + power(7) + "(" + power(30) + ")*/",
          "{aa, " + power(9) + "} | /" + power(40) + "(aa)*/", "~{" + power(24) + "}"})
        for (const std::string& family : families) {
            CAPTURE(text);
            CAPTURE(family);
            const CheckedClaim found = checked("show " + text + " is " + family);
            const Truth truth = found.statements[0].answer.truth;
            REQUIRE(truth != Truth::undecided);
            ++(truth == Truth::proved ? proved : refuted);
            CHECK(verify::check_certificate(certificate(found).dump())[0].outcome ==
                  Outcome::checked);
        }
    CHECK(proved >= 6);
    CHECK(refuted >= 6);
}

TEST_CASE("proofs by lengths are refused when they are changed") {
    const auto outcome = [](const std::string& statement,
                            const std::function<void(nlohmann::ordered_json&)>& change) {
        auto json = certificate(checked("show " + statement));
        change(json.at("statements")[0]);
        return verify::check_certificate(json.dump())[0].outcome;
    };
    const auto same = [](nlohmann::ordered_json&) {};
    const auto with = [](const std::string& key, const nlohmann::ordered_json& value) {
        return [key, value](nlohmann::ordered_json& entry) { entry.at("proof")[key] = value; };
    };
    const auto family = [](const std::string& name) {
        return [name](nlohmann::ordered_json& entry) { entry.at("statement").at("is") = name; };
    };
    const auto target = [](const std::function<void(nlohmann::ordered_json&)>& change) {
        return
            [change](nlohmann::ordered_json& entry) { change(entry.at("proof").at("targets")[0]); };
    };
    const std::string no_four = "/a*/ \\ {aaaa} is ";
    using List = std::vector<std::vector<std::size_t>>;
    // Sums of lengths.
    CHECK(outcome(no_four + "0L", same) == Outcome::checked);
    CHECK(outcome(no_four + "0L", family("T0L")) == Outcome::wrong);
    CHECK(outcome(no_four + "0L", with("sums", List{{1, 3}})) == Outcome::wrong);
    CHECK(outcome(no_four + "0L", with("sums", List{{2, 2}})) == Outcome::wrong);
    CHECK(outcome(no_four + "0L", with("sums", List{{1, 3}, {2, 2}})) == Outcome::checked);
    CHECK(outcome(no_four + "0L", with("sums", List{{1, 1}, {1, 3}, {2, 2}})) == Outcome::wrong);
    CHECK(outcome(no_four + "0L", with("sums", List{{0, 4}, {1, 3}, {2, 2}})) == Outcome::wrong);
    CHECK(outcome("~{aaa} is 0L", [](nlohmann::ordered_json& entry) {
              entry.at("verdict") = "refuted";
              entry.at("proof") = {{"by", "lengths"}, {"sums", List{{1, 2}, {2, 1}}}};
          }) == Outcome::wrong);
    // Two lengths, with cases.
    CHECK(outcome(no_four + "T0L", same) == Outcome::checked);
    CHECK(outcome(no_four + "T0L", [](nlohmann::ordered_json& entry) {
              entry.at("proof").at("targets").erase(0);
          }) == Outcome::wrong);
    CHECK(outcome(no_four + "T0L", [](nlohmann::ordered_json& entry) {
              auto& targets = entry.at("proof").at("targets");
              targets[0] = targets[1];
          }) == Outcome::wrong);
    CHECK(outcome(no_four + "T0L", [](nlohmann::ordered_json& entry) {
              entry.at("proof").at("targets")[1].at("frames") = nlohmann::ordered_json::array();
          }) == Outcome::wrong);
    CHECK(outcome(no_four + "T0L", [](nlohmann::ordered_json& entry) {
              // The length may be made of a shorter one.
              entry.at("proof").at("targets")[1].at("frames")[0].at("case") = {{"length", 2}};
          }) == Outcome::wrong);
    CHECK(outcome(no_four + "T0L", [](nlohmann::ordered_json& entry) {
              // All multiples of 3 are lengths, so it may be erased to.
              entry.at("proof").at("targets")[0].at("length") = 3;
          }) == Outcome::wrong);
    CHECK(outcome(no_four + "T0L", [](nlohmann::ordered_json& entry) {
              // A sum that stays within the lengths.
              entry.at("proof").at("targets")[1].at("frames")[0].at("case").at("sum") = {1};
          }) == Outcome::wrong);
    // One table that does not erase.
    const std::string gap = "{aaa, aaaaa, aaaaaa} | /aaaaaaaaa*/ is P0L";
    CHECK(outcome(gap, same) == Outcome::checked);
    CHECK(outcome(gap, family("PT0L")) == Outcome::wrong);
    CHECK(outcome(gap, target([](nlohmann::ordered_json& each) {
                      each.at("frames")[0].at("case") = {{"length", 1}};
                  })) == Outcome::wrong);
    CHECK(outcome(gap, target([](nlohmann::ordered_json& each) {
                      each.at("frames")[0].at("case") = {{"rest", {0, 1}}};
                  })) == Outcome::wrong);
    // Long lengths.
    const std::string nine(9, 'a'),
        endless = "{a} | /aaa(" + nine + ")*/ | /(" + nine + ")+/ is T0L";
    CHECK(outcome(endless, same) == Outcome::checked);
    CHECK(outcome(endless, target([](nlohmann::ordered_json& each) {
                      each.at("rest") = {0, 9};
                  })) == Outcome::wrong);
    CHECK(outcome(endless, target([](nlohmann::ordered_json& each) {
                      each.at("rest") = {3, 90};  // 5 divides the modulus and not the period
                  })) == Outcome::wrong);
    CHECK(outcome(endless, target([](nlohmann::ordered_json& each) {
                      each.at("frames").erase(0);
                  })) == Outcome::wrong);
    // Other languages.
    CHECK(outcome("/a*/ is 0L", [](nlohmann::ordered_json& entry) {
              entry.at("verdict") = "refuted";
              entry.at("proof") = {{"by", "lengths"}, {"targets", nlohmann::ordered_json::array()}};
          }) == Outcome::wrong);
    CHECK(outcome("/a*b|b*a/ is 0L", [](nlohmann::ordered_json& entry) {
              entry.at("proof") = {{"by", "lengths"}, {"sums", List{{1, 3}, {2, 2}}}};
          }) == Outcome::wrong);
    CHECK(outcome("{aaa, aaaaa} is P0L", [](nlohmann::ordered_json& entry) {
              entry.at("proof") = {{"by", "lengths"}, {"targets", nlohmann::ordered_json::array()}};
          }) == Outcome::wrong);
}
