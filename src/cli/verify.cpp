#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "cli/input.hpp"
#include "cli/output.hpp"
#include "verify/check_certificate.hpp"

namespace algae::cli {

namespace {

using verify::Finding;
using Outcome = Finding::Outcome;

struct Options {
    std::string file;
    bool json = false;
    Bounds bounds;
};

std::string line_of(const Finding& found, const std::string& file) {
    std::string text = to_string(found.outcome) + ": " + found.statement;
    if (found.outcome == Outcome::cited) text += " (" + found.citation + ")";
    text += '\n';
    if (found.outcome == Outcome::wrong || found.outcome == Outcome::not_checked)
        text += "    " + file + ":" + std::to_string(found.line) + ": " + found.path + ": " +
                found.reason + '\n';
    return text;
}

std::string summary(const std::map<Outcome, std::size_t>& counts) {
    std::string text;
    for (const auto& [outcome, count] : counts)
        text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + to_string(outcome);
    return text.empty() ? "no statements\n" : text + '\n';
}

nlohmann::ordered_json json_of(const Finding& found) {
    nlohmann::ordered_json out{{"statement", found.statement},
                               {"outcome", to_string(found.outcome)},
                               {"path", found.path},
                               {"line", found.line}};
    if (!found.citation.empty()) out["citation"] = found.citation;
    if (!found.reason.empty()) out["reason"] = found.reason;
    return out;
}

int verify_certificate(const Options& options) {
    const Budget budget = options.bounds.budget();
    const std::string name = options.file == "-" ? "standard input" : options.file;
    const auto certificate = verify::read_certificate(file_text(options.file, budget), name);
    const auto findings = verify::check_certificate(*certificate, budget);
    std::map<Outcome, std::size_t> counts;
    std::string text;
    auto list = nlohmann::ordered_json::array();
    for (const Finding& found : findings) {
        ++counts[found.outcome];
        text += line_of(found, name);
        list.push_back(json_of(found));
    }
    print(
        options.json
            ? nlohmann::ordered_json{{"claim", certificate->claim}, {"statements", list}}.dump(2) +
                  "\n"
            : text + summary(counts));
    return counts.contains(Outcome::wrong)         ? refuted
           : counts.contains(Outcome::not_checked) ? undecided
                                                   : success;
}

}  // namespace

void add_verify(Verbs& verbs) {
    auto options = std::make_shared<Options>();
    CLI::App& verb =
        add_verb(verbs, "verify", "Check a certificate again, by other and simpler means",
                 "  algae check my.claim --certificate my.json\n  algae verify my.json", options,
                 verify_certificate);
    verb.add_option("FILE", options->file, "a certificate, or - for standard input")->type_name("FILE")->required();
    verb.add_flag("--json", options->json, "print one JSON object");
    options->bounds.add_to(verb);
}

}  // namespace algae::cli
