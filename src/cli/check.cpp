#include <fmt/format.h>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "claim/check.hpp"
#include "cli/claims.hpp"
#include "cli/command.hpp"
#include "cli/input.hpp"
#include "cli/output.hpp"
#include "render/output.hpp"

namespace algae::cli {

namespace {

using Outcome = CheckedStatement::Outcome;
using Json = nlohmann::ordered_json;

struct Options {
    std::vector<std::string> paths;
    std::string certificate;
    bool explain = false, json = false;
    Bounds bounds;
};

/// One line for the claim, and one with the reasons for each statement that does not stand.
std::string summary(const CheckedClaim& checked) {
    std::string text =
        fmt::format("{:<9}  {}\n", to_string(checked.outcome()), checked.claim.title);
    for (std::size_t i = 0; i < checked.statements.size(); ++i) {
        const CheckedStatement& found = checked.statements[i];
        if (found.outcome != Outcome::wrong && found.outcome != Outcome::undecided) continue;
        const ClaimedStatement& claimed = checked.claim.statements[i];
        text += "    " + to_string(claimed.statement.place) + ": " + claimed.statement.text + ": " +
                verdict_text(claimed, found) + '\n';
        for (const std::string& line : found.judgement.argument) text += "        " + line + '\n';
    }
    return text;
}

Json as_json(const CheckedClaim& checked) {
    Json statements = Json::array();
    for (std::size_t i = 0; i < checked.statements.size(); ++i) {
        const ClaimedStatement& claimed = checked.claim.statements[i];
        const CheckedStatement& found = checked.statements[i];
        Json entry{{"text", claimed.statement.text}, {"verdict", verdict_text(claimed, found)}};
        if (!claimed.citation.empty()) entry["citation"] = claimed.citation;
        entry["argument"] = found.judgement.argument;
        statements.push_back(std::move(entry));
    }
    return {{"claim", checked.claim.title},
            {"file", checked.claim.name},
            {"verdict", to_string(checked.outcome())},
            {"statements", statements}};
}

int check_paths(const Options& options) {
    const Budget budget = options.bounds.budget();
    std::vector<std::string> files;
    for (const std::string& path : options.paths)
        for (std::string& file : claim_files(path)) files.push_back(std::move(file));
    if (!options.certificate.empty() && files.size() != 1)
        throw Error("--certificate takes one claim, found " + std::to_string(files.size()));
    std::vector<Claim>
        claims;  // all are read before any is decided: a mistake in one shows at once
    for (const std::string& file : files) claims.push_back(open_claim(file, budget));
    std::size_t counts[4] = {};
    Json all = Json::array();
    Outcome worst = Outcome::stands;
    ProgressBar bar("check");
    for (std::size_t i = 0; i < claims.size(); ++i) {
        const CheckedClaim checked = check(std::move(claims[i]), budget);
        ++counts[static_cast<std::size_t>(checked.outcome())];
        worst = std::max(worst, checked.outcome());
        if (!options.certificate.empty()) {
            FileOutput out(options.certificate);
            const std::string text = certificate(checked).dump(1) + "\n";
            out.write(text.data(), text.size());
            out.commit();
        }
        if (options.json)
            all.push_back(as_json(checked));
        else
            print(options.explain
                      ? (i > 0 ? "\n" + std::string(100, '=') + "\n\n" : "") + explanation(checked)
                      : summary(checked));
        bar.report(static_cast<double>(i + 1) / static_cast<double>(claims.size()));
    }
    if (options.json)
        print(Json{{"claims", all}}.dump(2) + "\n");
    else if (claims.size() > 1)
        print(fmt::format("{} claims: {} proved, {} cited, {} undecided, {} wrong\n", claims.size(),
                          counts[0], counts[1], counts[2], counts[3]));
    return worst == Outcome::wrong ? refuted : worst == Outcome::undecided ? undecided : success;
}

}  // namespace

void add_check(Verbs& verbs) {
    auto options = std::make_shared<Options>();
    CLI::App& verb =
        add_verb(verbs, "check", "Whether claims hold, statement by statement",
                 "  algae check theory\n  algae check union.claim --explain", options, check_paths);
    verb.add_option("PATH", options->paths,
                    "claim files, folders of them, - for standard input, or theory, the claims "
                    "that come with algae")
        ->type_name("FILE|DIR")
        ->required();
    verb.add_flag("--explain", options->explain, "print the argument in sentences");
    verb.add_option("--certificate", options->certificate, "write what algae verify checks again")
        ->type_name("FILE");
    verb.add_flag("--json", options->json, "print one JSON object");
    options->bounds.add_to(verb);
}

}  // namespace algae::cli
