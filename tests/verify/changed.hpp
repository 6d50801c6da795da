#pragma once

// Certificates of one statement, changes of them, and what verify finds of each, word by word. A file of
// tests/verify/certificates is a list of cases. A case is a certificate with one statement and what is found of it; its
// changes are lists of places, each with a new value or without one if it is removed, and what is found then: "checked",
// "wrong: PLACE: REASON", "not checked: REASON", or "error: ..." where the certificate cannot be read; last, how the statement
// is written, if that is another one.

#include <nlohmann/json.hpp>
#include <string>

#include "exact/exact.hpp"
#include "verify/verify.hpp"

namespace changed {

using Json = nlohmann::ordered_json;

/// What is found of the only statement, and how it is written.
struct Found {
    std::string outcome, says;
    bool operator==(const Found&) const = default;
};

/// The memory that checking may take; no time, which would not be the same twice.
inline algae::Budget budget() {
    algae::Budget budget;
    budget.memory = 256 << 20;
    return budget;
}

inline Found found(const Json& certificate, const algae::Budget& budget = changed::budget()) {
    using algae::verify::Finding;
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

/// The certificate of a case.
inline Json certificate_of(const Json& one) {
    Json certificate{{"format", "algae certificate 1"}, {"claim", "a case"}};
    if (one.contains("header")) certificate.update(one["header"]);
    certificate["alphabet"] = one["alphabet"];
    certificate["systems"] = one["systems"];
    certificate["statements"] = Json::array({{{"text", ""},
                                              {"statement", one["statement"]},
                                              {"verdict", one["verdict"]},
                                              {"proof", one["proof"]}}});
    return certificate;
}

/// A place of a certificate; one that begins with its statement, verdict or proof is within its only statement.
inline Json::json_pointer place_of(const std::string& text) {
    for (const std::string part : {"/statement", "/verdict", "/proof"})
        if (text == part || text.starts_with(part + "/"))
            return Json::json_pointer("/statements/0" + text);
    return Json::json_pointer(text);
}

inline void change(Json& certificate, const Json& places) {
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

}  // namespace changed
