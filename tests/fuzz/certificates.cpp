// Certificates: any bytes, bytes that choose what is changed in a sound one, and those that `language` writes itself. What
// verify accepts must be true as far as the second route knows.

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "exact/exact.hpp"
#include "fuzz/targets.hpp"
#include "language/language.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "oracle/certificate_truth.hpp"
#include "places.hpp"
#include "verify/mutants.hpp"
#include "verify/samples.hpp"
#include "verify/verify.hpp"

namespace algae::fuzz {

namespace {

using Json = nlohmann::ordered_json;
using verify::Finding;
using verify::JsonValue;

/// Without the systems that nothing names.
Json pruned(Json certificate) {
    const std::string text = certificate["statements"].dump();
    Json systems = Json::object();
    for (const auto& [name, system] : certificate["systems"].items())
        if (text.find('"' + name + '"') != std::string::npos ||
            text.find('(' + name) != std::string::npos)
            systems[name] = system;
    certificate["systems"] = systems;
    return certificate;
}

/// Certificates of one statement that verify finds sound.
const std::vector<Json>& sound() {
    static const std::vector<Json> all = [] {
        std::vector<Json> found;
        for (const samples::Sample& sample : samples::sound())
            found.push_back(pruned(samples::certificate(sample)));
        for (const char* file : {"finite", "languages", "numbers", "statements", "systems"}) {
            std::ifstream text(source_folder() + "/tests/verify/certificates/" + std::string(file) +
                               ".json");
            for (const Json& each : Json::parse(text)) {
                if (each["outcome"] != "checked") continue;
                Json one{{"format", "algae certificate 1"}, {"claim", "a case"}};
                if (each.contains("header")) one.update(each["header"]);
                one["alphabet"] = each["alphabet"];
                one["systems"] = each["systems"];
                one["statements"] = Json::array({{{"text", ""},
                                                  {"statement", each["statement"]},
                                                  {"verdict", each["verdict"]},
                                                  {"proof", each["proof"]}}});
                found.push_back(pruned(std::move(one)));
            }
        }
        return found;
    }();
    return all;
}

Texts sound_texts() {
    Texts texts;
    for (const Json& one : sound()) texts.push_back(one.dump());
    return texts;
}

/// What the statements of a certificate depend on.
std::string said(const Json& certificate, const Json& entry) {
    return Json::array({certificate.value("alphabet", Json()), certificate.value("systems", Json()),
                        certificate.value("empty axiom", Json()), entry.value("statement", Json()),
                        entry.value("verdict", Json())})
        .dump();
}

/// Whether what an accepted statement says was looked at before; the sound ones are true.
bool is_known(const std::string& text) {
    static std::set<std::string> known = [] {
        std::set<std::string> first;
        for (const Json& one : sound()) first.insert(said(one, one["statements"][0]));
        return first;
    }();
    if (known.size() > 200'000) known.clear();
    return !known.insert(text).second;
}

/// Throws Broken if a statement that verify accepts is false.
void expect_true(const Json& certificate, const std::vector<Finding>& findings) {
    for (std::size_t i = 0; i < findings.size(); ++i) {
        if (findings[i].outcome != Finding::Outcome::checked) continue;
        const Json& entry = certificate.at("statements").at(i);
        const std::string says = said(certificate, entry);
        if (is_known(says)) continue;
        Budget budget = small_budget();
        budget.memory = 64 << 20;
        budget.deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds(100);
        const auto truth = oracle::truth_of(certificate, entry.at("statement"), budget);
        if (truth.holds)
            expect(*truth.holds == (entry.at("verdict") == "proved"),
                   "verify accepts what is false (" + truth.by + "): " + findings[i].statement +
                       "\n" + says);
    }
}

void take_certificate(std::string_view bytes) {
    const std::string text(bytes);
    const auto findings = verify::check_certificate(text, "x.json", small_budget());
    for (const Finding& finding : findings)
        if (finding.outcome == Finding::Outcome::checked) {
            const Json read = Json::parse(text, nullptr, false);
            expect(!read.is_discarded(), "what verify reads is JSON");
            expect_true(read, findings);
            return;
        }
}

void take_mutant(std::string_view bytes) {
    Bytes choices(bytes);
    const Json& one = sound()[choices.below(sound().size())];
    const Json& other = sound()[choices.below(sound().size())];
    mutants::Mutator mutate(
        mutants::Mutator::Numbers([&]() -> std::uint64_t { return choices.below(65536); }));
    const Json mutant = mutate(one, other);
    expect_true(mutant, verify::check_certificate(mutant.dump(), "x.json", small_budget()));
}

void expect_same(const JsonValue& value, const Json& other) {
    const auto check = [&](bool holds) { expect(holds, "another value than " + other.dump()); };
    switch (value.kind) {
        case JsonValue::Kind::null:
            return check(other.is_null());
        case JsonValue::Kind::truth:
            return check(other.is_boolean() && other.get<bool>() == value.truth);
        case JsonValue::Kind::number:
            return check(other.is_number_unsigned() && other.get<std::uint64_t>() == value.number);
        case JsonValue::Kind::real:
            return check(other.is_number());
        case JsonValue::Kind::text:
            return check(other.is_string() && other.get<std::string>() == value.text);
        case JsonValue::Kind::list:
        case JsonValue::Kind::object:
            check(value.kind == JsonValue::Kind::list ? other.is_array() : other.is_object());
            check(other.size() == value.items.size());
            for (std::size_t i = 0; i < value.items.size(); ++i)
                expect_same(value.items[i], value.kind == JsonValue::Kind::list
                                                ? other.at(i)
                                                : other.at(value.keys.at(i)));
            return;
        case JsonValue::Kind::too_large:
            return;
    }
}

/// What verify reads is JSON and has the value that another reader finds.
void take_json(std::string_view bytes) {
    const JsonValue value = verify::parse_json(verify::source_of(bytes), "x.json", small_budget());
    const Json other = Json::parse(bytes, nullptr, false);
    expect(!other.is_discarded(), "what verify reads is JSON");
    expect_same(value, other);
}

Texts json_seeds() {
    Texts texts = sound_texts();
    for (const char* text : {R"({"a": [1, -2.5e-3, "\u00e4\ud83d\ude00\n", null, true]})",
                             "[18446744073709551615, 18446744073709551616, 1e400, -0]",
                             "\"\\u0000\"", "[[[[{}]]], {\"b\": false}]"})
        texts.emplace_back(text);
    return texts;
}

/// What is proved has a certificate that verify accepts.
void take_proof(std::string_view text) {
    const auto closed = [](const std::string& name) -> Model {
        throw Error("there is no " + name);
    };
    Claim claim = read_claim(text, "x.claim", closed);
    SearchLimits limits;
    limits.instances = 60;
    limits.size = 4;
    limits.threads = 1;
    const CheckedClaim checked = check(std::move(claim), small_budget(), limits);
    const std::string written = certificate(checked).dump();
    Budget budget = small_budget();
    budget.memory = 256 << 20;
    budget.deadline = std::chrono::steady_clock::now() + std::chrono::seconds(1);
    try {
        for (const Finding& finding : verify::check_certificate(written, "y.json", budget))
            expect(
                finding.outcome != Finding::Outcome::wrong,
                "verify refuses a proof: " + finding.path + ": " + finding.reason + "\n" + written);
    } catch (const Error& error) {
        throw Broken("verify cannot read a certificate: " + std::string(error.what()) + "\n" +
                     written);
    }
}

}  // namespace

std::vector<Target> certificates() {
    return {
        {"json", "the JSON of certificates, against another reader", take_json, json_seeds},
        {"certificate", "certificates, checked; what is accepted against the second route",
         take_certificate, sound_texts, 1500},
        {"mutant", "sound certificates with changed tokens, likewise", take_mutant,
         random_bytes(40, 24), 64},
        {"proof", "claims: each proof is accepted by verify", take_proof,
         files({"theory"}, ".claim")},
    };
}

}  // namespace algae::fuzz
