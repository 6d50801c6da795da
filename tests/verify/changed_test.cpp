// Certificates of each kind of proof, and small changes of them: what is found of each stands beside it, word by word, so a
// check that is left out, or that looks at another place, is noticed. Tests of other files say which of them can be true.
//
// A file of tests/verify/certificates is a list of cases. A case is a certificate with one statement and what is found of it; its
// changes are lists of places, each with a new value or without one if it is removed, and what is found then: "checked",
// "wrong: PLACE: REASON", "not checked: REASON", or "error: ..." where the certificate cannot be read; last, how the statement
// is written, if that is another one.

#include <doctest/doctest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "exact/exact.hpp"
#include "places.hpp"
#include "verify/verify.hpp"

namespace {

using Json = nlohmann::ordered_json;
using algae::verify::Finding;

Json cases_of(const std::string& file) {
    std::ifstream text(source_folder() + "/tests/verify/certificates/" + file + ".json");
    REQUIRE(text);
    return Json::parse(text);
}

/// What is found of the only statement, and how it is written.
struct Found {
    std::string outcome, says;
};

Found found(const Json& certificate) {
    algae::Budget budget;
    budget.memory = 256 << 20;
    try {
        const auto all = algae::verify::check_certificate(certificate.dump(1), "x.json", budget);
        if (all.empty()) return {"nothing", ""};
        const Finding& one = all.front();
        const std::string path =
            one.path.starts_with("statements[0].") ? one.path.substr(14) : one.path;
        switch (one.outcome) {
            case Finding::Outcome::checked:
                return {"checked", one.statement};
            case Finding::Outcome::wrong:
                return {"wrong: " + path + ": " + one.reason, one.statement};
            case Finding::Outcome::not_checked:
                return {"not checked: " + one.reason, one.statement};
            case Finding::Outcome::cited:
                return {"cited", one.statement};
            default:
                return {"undecided", one.statement};
        }
    } catch (const algae::Error& error) {
        const std::string text = error.what();  // x.json:12: ...
        return {"error: " + text.substr(text.find(": ") + 2), ""};
    }
}

/// A place of a certificate; one that begins with its statement, verdict or proof is within its only statement.
Json::json_pointer place_of(const std::string& text) {
    for (const std::string part : {"/statement", "/verdict", "/proof"})
        if (text == part || text.starts_with(part + "/"))
            return Json::json_pointer("/statements/0" + text);
    return Json::json_pointer(text);
}

void change(Json& certificate, const Json& places) {
    for (const Json& each : places) {
        const auto place = place_of(each[0].get<std::string>());
        if (each.size() == 2) {
            certificate[place] = each[1];
            continue;
        }
        Json& around = certificate[place.parent_pointer()];
        if (around.is_array())
            around.erase(std::stoul(place.back()));
        else
            around.erase(place.back());
    }
    // The statements come last.
    const Json statements = certificate["statements"];
    certificate.erase("statements");
    certificate["statements"] = statements;
}

void check_all(const std::string& file, std::size_t least) {
    std::size_t count = 0;
    for (const Json& each : cases_of(file)) {
        Json certificate{{"format", "algae certificate 1"}, {"claim", "a case"}};
        if (each.contains("header")) certificate.update(each["header"]);
        certificate["alphabet"] = each["alphabet"];
        certificate["systems"] = each["systems"];
        certificate["statements"] = Json::array({{{"text", ""},
                                                  {"statement", each["statement"]},
                                                  {"verdict", each["verdict"]},
                                                  {"proof", each["proof"]}}});
        INFO(each["case"].get<std::string>());
        const Found whole = found(certificate);
        CHECK(whole.outcome == each["outcome"].get<std::string>());
        CHECK(whole.says == each["says"].get<std::string>());
        for (const Json& one : each["changes"]) {
            Json changed = certificate;
            change(changed, one[0]);
            INFO(one[0].dump());
            const Found then = found(changed);
            CHECK(then.outcome == one[1].get<std::string>());
            if (!then.says.empty())
                CHECK(then.says == (one.size() > 2 ? one[2].get<std::string>() : whole.says));
            ++count;
        }
    }
    CHECK(count >= least);
}

}  // namespace

TEST_CASE("changed proofs about systems: derivations, families, sequences and growth") {
    check_all("systems", 300);
}

TEST_CASE("changed proofs by cases that a finite language is not of a family") {
    check_all("finite", 60);
}

TEST_CASE("changed proofs about languages: families, finiteness, equality and inclusion") {
    check_all("languages", 600);
}

TEST_CASE("changed proofs about numbers, words that depend on them, and modules") {
    check_all("numbers", 400);
}

TEST_CASE("changed statements: powers, codes, automata, quantifiers, and what is no certificate") {
    check_all("statements", 500);
}

TEST_CASE("statements are written from what was read") { check_all("written", 80); }
