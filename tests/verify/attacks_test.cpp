// Certificates by which statements that are false, or that can be read as such, were once found to be checked, with all that is said
// of each now: what the statements speak of, and what is found.

#include <doctest/doctest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "places.hpp"
#include "verify/changed.hpp"

namespace {

using changed::Json;

std::vector<std::string> said_of(const Json& certificate) {
    using namespace algae::verify;
    std::vector<std::string> lines;
    const CertificateEvents events{
        .on_start = [&](const Certificate& read) { lines = definitions(read); },
        .on_finding =
            [&](const Finding& found) {
                const std::string reason = found.reason.empty() ? "" : " [" + found.reason + "]";
                lines.push_back(to_string(found.outcome) + ": " + found.statement + reason);
            }};
    try {
        check_certificate(source_of(certificate.dump()), "x.json", changed::budget(), events);
    } catch (const algae::Error& error) {
        lines.push_back(error.what());
    }
    return lines;
}

}  // namespace

TEST_CASE("statements that were once checked and are false, or look so, are not") {
    std::ifstream text(source_folder() + "/tests/verify/certificates/attacks.json");
    REQUIRE(text);
    std::size_t count = 0;
    for (const Json& each : Json::parse(text)) {
        INFO(each["attack"].get<std::string>());
        CHECK(said_of(each["certificate"]) == each["said"].get<std::vector<std::string>>());
        ++count;
    }
    CHECK(count > 100);
}
