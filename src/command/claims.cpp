// Claims of the theory and their certificates: `check` decides what a claim says, `verify` checks a certificate again.
//
// A claim stands, rests on a cited source, is undecided or is wrong; a run ends with the worst of these results.
// All claims are read before any is decided, so that mistakes in them are reported at once. `verify` takes only
// the certificate from `check`: its checker is a room of its own and shares no code with the rooms that
// decide.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "command/detail/checkpoint.hpp"
#include "command/detail/files.hpp"
#include "command/detail/formal.hpp"
#include "command/detail/output.hpp"
#include "command/detail/verb.hpp"
#include "exact/exact.hpp"
#include "language/language.hpp"
#include "notation/notation.hpp"
#include "render/render.hpp"
#include "verify/verify.hpp"
#include "watch/watch.hpp"

namespace algae::command {

namespace {

using Outcome = CheckedStatement::Outcome;

/// The files of claims for a path: the file itself, or all claims in a folder, sorted by name. If the path does not
/// exist, it may be one of the theory that comes with algae: `theory`, `theory/closure`. Throws
/// Error if there are no claims.
std::vector<std::string> claim_files(const std::string& path) {
    std::error_code ignored;
    std::vector<std::string> files;
    if (path == "-" || std::filesystem::is_regular_file(path, ignored)) return {path};
    if (std::filesystem::is_directory(path, ignored)) {
        for (const std::filesystem::path& file : files_below(path))
            if (file.extension() == ".claim") files.push_back(file.string());
        if (files.empty()) throw Error(path + ": expected .claim files in this folder, found none");
    } else {
        const std::string folder = path.ends_with('/') ? path : path + '/';
        for (const GalleryEntry& claim : theory_claims())
            if (claim.path.starts_with(folder)) files.emplace_back(claim.path);
        if (files.empty()) return {path};
    }
    std::ranges::sort(files);
    return files;
}

/// The claim in a file, in one of the theory that comes with algae, or "-" for standard input; systems
/// that it names are those of the gallery or of files beside it. Throws Error, Diagnostics or
/// BoundReached.
Claim open_claim(const std::string& file, const Budget& budget,
                 const std::vector<std::string>& letters = {}, bool outside = false) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored))
        for (const GalleryEntry& claim : theory_claims())
            if (claim.path == file)
                return read_claim(claim.text, file, systems_from({"."}, budget, outside), letters);
    const std::string text = file_text(file, budget);
    return read_claim(text, file == "-" ? "standard input" : file,
                      systems_from({folder_of(file)}, budget, outside), letters);
}

// check

struct CheckOptions {
    std::vector<std::string> paths;
    std::string statement, certificate, accept, checkpoint, resume, formal;
    std::vector<std::string> alphabet;
    std::uint64_t instances = SearchLimits().instances, size = SearchLimits().size;
    bool explain = false, json = false, latex = false, outside = false;
    Bounds bounds;
};

/// The verdict on a statement with what it rests on, as lines.
std::vector<std::string> reasons(const CheckedStatement& found, const ClaimedStatement& claimed,
                                 const Alphabet& alphabet) {
    if (found.is_by_citation()) return {verdict_text(found) + ": " + claimed.citation};
    std::vector<std::string> lines = sentences(found.answer, alphabet);
    const std::string verdict = verdict_text(found);
    if (const auto values = witness_of(found.answer, alphabet); !values.empty()) {
        const bool example = found.answer.truth == Truth::proved && !claimed.statement.negated;
        const auto text = [](const auto& all) {
            return joined(all, ", ",
                          [](const auto& one) { return one.first + " = " + one.second; });
        };
        std::vector<std::string> by{verdict + " by the " +
                                    (example ? "example " : "counterexample ") + text(values)};
        if (const auto others = witness_of(found.answer, alphabet, true); !others.empty())
            by.push_back("the first with a word that is not empty: " + text(others));
        return by;
    }
    if (found.answer.truth != Truth::undecided) return {verdict};
    if (!lines.empty()) lines.front() = verdict + ": " + lines.front();
    return lines;
}

/// The claim's title, its theorem with the verdict, how many examples hold, and lines with the reasons for each that
/// does not. The title stands behind a word of ours, so it cannot imitate a verdict.
std::string summary(const CheckedClaim& checked, const FormalProofs& proofs) {
    const Claim& claim = checked.claim;
    std::string text = "claim " + claim.title + '\n';
    if (const auto theorem = checked.theorem()) {
        const ClaimedStatement& claimed = claim.statements[*theorem];
        text += "  theorem " + claimed.statement.text + '\n';
        for (const std::string& line :
             reasons(checked.statements[*theorem], claimed, *claim.alphabet))
            text += "    " + line + '\n';
    }
    const auto [hold, of] = checked.examples();
    if (of > 0)
        text += "  examples: " + std::to_string(hold) + " of " + std::to_string(of) + " hold\n";
    for (const ClosureFact& fact : claim.closure)
        if (!fact.theorem.empty())
            text += "  in Coq " + fact.theorem + ": " + proofs.verdict(fact) + '\n';
    for (std::size_t i = 0; i < checked.statements.size(); ++i) {
        const CheckedStatement& found = checked.statements[i];
        const ClaimedStatement& claimed = claim.statements[i];
        if (found.outcome == Outcome::holds || checked.theorem() == i) continue;
        text += "    " + to_string(claimed.statement.place) + ": " + claimed.statement.text + ": " +
                verdict_text(found) + '\n';
        const std::vector<std::string> lines = found.is_by_citation()
                                                   ? std::vector<std::string>{claimed.citation}
                                                   : sentences(found.answer, *claim.alphabet);
        for (const std::string& line : lines) text += "        " + line + '\n';
    }
    if (checked.worst() > Outcome::formally)
        if (const std::string over = complement_text(claim.letters, *claim.alphabet); !over.empty())
            text += "  " + over + '\n';
    return text;
}

Json theorem_json(const CheckedStatement& found, const ClaimedStatement& claimed,
                  const Alphabet& alphabet) {
    Json out{{"text", claimed.statement.text}, {"verdict", verdict_text(found)}};
    if (!claimed.citation.empty()) out.set("citation", claimed.citation);
    if (const std::string method = method_of(found.answer, alphabet); !method.empty())
        out.set("method", method);
    if (const auto values = witness_of(found.answer, alphabet); !values.empty()) {
        Json witness;
        for (const auto& [name, value] : values) witness.set(name, value);
        const bool example = found.answer.truth == Truth::proved && !claimed.statement.negated;
        out.set(example ? "example" : "counterexample", std::move(witness));
    }
    if (const auto& searched = found.answer.searched)
        out.set("searched", {{"instances", searched->visited},
                             {"meeting", searched->instances},
                             {"size", searched->size},
                             {"undecided", searched->undecided}});
    return out;
}

Json as_json(const CheckedClaim& checked, const FormalProofs& proofs) {
    const Claim& claim = checked.claim;
    Json statements = Json::array();
    for (std::size_t i = 0; i < checked.statements.size(); ++i) {
        const ClaimedStatement& claimed = claim.statements[i];
        const CheckedStatement& found = checked.statements[i];
        Json entry{{"text", claimed.statement.text}, {"verdict", verdict_text(found)}};
        if (found.outcome == Outcome::fails) entry.set("holds", false);
        if (!claimed.citation.empty()) entry.set("citation", claimed.citation);
        entry.set("argument", sentences(found.answer, *claim.alphabet));
        statements.add(std::move(entry));
    }
    const auto theorem = checked.theorem();
    const auto [hold, of] = checked.examples();
    Json out{{"claim", claim.title},
             {"file", claim.name},
             {"verdict", std::string(to_string(checked.verdict()))}};
    if (!claim.letters.empty()) {
        std::vector<std::string> names;
        for (const Symbol letter : claim.letters) names.push_back(claim.alphabet->name(letter));
        std::ranges::sort(names);
        out.set("complement_letters", names);
    }
    if (theorem)
        out.set("theorem", theorem_json(checked.statements[*theorem], claim.statements[*theorem],
                                        *claim.alphabet));
    out.set("examples", {{"hold", hold}, {"of", of}});
    Json formal = Json::array();
    for (const ClosureFact& fact : claim.closure)
        if (!fact.theorem.empty())
            formal.add(Json{{"operation", fact.operation},
                            {"families", fact.families},
                            {"closed", fact.closed},
                            {"theorem", fact.theorem},
                            {"verdict", proofs.verdict(fact)}});
    out.set("formal", formal);
    return out.set("statements", statements);
}

/// Whether all is as the claim says; what is cited counts where it is accepted.
Status status_of(const CheckedClaim& checked, bool accepts_cited) {
    const Outcome worst = checked.worst();
    if (worst == Outcome::fails) return refuted;
    return worst == Outcome::undecided || (worst == Outcome::cited && !accepts_cited) ? undecided
                                                                                      : success;
}

/// The claims that were asked for: of files, or of a statement on the command line.
std::vector<Claim> asked_claims(const CheckOptions& options, const Budget& budget) {
    if (options.statement.empty() == options.paths.empty())
        throw Error("expected files of claims or --say and a statement, found " +
                    std::string(options.paths.empty() ? "neither" : "both"));
    if (!options.statement.empty()) {
        const std::string text = "theorem " + options.statement + "\nclaim " + options.statement;
        return {read_claim(text, "--say", systems_from({"."}, budget, true), options.alphabet)};
    }
    std::vector<std::string> files;
    for (const std::string& path : options.paths)
        for (std::string& file : claim_files(path)) files.push_back(std::move(file));
    std::vector<Claim> claims;
    for (const std::string& file : files) {
        claims.push_back(open_claim(file, budget, options.alphabet, options.outside));
        if (claims.back().statements.empty())
            throw Error(file +
                        ": expected a statement (theorem, show, lemma or refute), found none");
    }
    return claims;
}

/// A search that is written down: a line for each batch of instances, of which the last one counts.
class WrittenSearch {
public:
    /// Throws Error where the claims are not one statement that is searched.
    WrittenSearch(const CheckOptions& options, const std::vector<Claim>& claims,
                  SearchLimits& limits, const Budget& budget) {
        const bool begins = !options.checkpoint.empty();
        if (!begins && options.resume.empty()) return;
        const std::string option = begins ? "--checkpoint" : "--resume";
        if (claims.size() != 1 || claims[0].statements.size() != 1 ||
            !std::holds_alternative<Quantified>(claims[0].statements[0].statement.says))
            throw Error(option +
                        ": expected one statement about all values, or some, and nothing else");
        const Claim& claim = claims.front();
        // What the statement's names stand for is in the certificate of nothing known.
        std::string header = Json{{"format", "algae search 1"},
                                  {"order", 1},
                                  {"of", Json(certificate(undecided_claim(claim)))}}
                                 .text(-1);
        header.pop_back();
        if (begins) {
            file_.begin(options.checkpoint, header);
        } else {
            const auto take = [&](const std::string& line) {
                const auto read = nlohmann::json::parse(line, nullptr, false);
                const auto has = [&](const char* key) {
                    return read.contains(key) && read[key].is_number_unsigned();
                };
                if (!read.is_object() || !has("visited") || !has("instances") ||
                    !has("undecided") || !has("size") || !read.contains("partial") ||
                    !read["partial"].is_boolean())
                    return false;
                limits.from = {read["visited"], read["instances"], read["undecided"], read["size"],
                               read["partial"]};
                return true;
            };
            file_.go_on(options.resume, header, true, take, budget);
        }
        limits.on_searched = [this](const SearchedSoFar& now) {
            std::string line = Json{
                {"visited", now.visited},
                {"instances", now.instances},
                {"undecided", now.undecided},
                {"size", now.size},
                {"partial",
                 now.is_partial}}.text(-1);
            line.pop_back();
            file_.write(line);
        };
    }

private:
    static CheckedClaim undecided_claim(const Claim& claim) {
        CheckedClaim nothing_known{claim, {}};
        nothing_known.statements.resize(claim.statements.size());
        return nothing_known;
    }

    Checkpoint file_;
};

int check_claims(const CheckOptions& options) {
    const Budget budget = options.bounds.budget();
    if (!options.accept.empty() && options.accept != "cited")
        throw Error("--accept: expected 'cited', found " + algae::quoted(options.accept));
    const FormalProofs proofs(options.formal, budget);
    // All are read before any is decided: a mistake in one shows at once.
    std::vector<Claim> claims = asked_claims(options, budget);
    if (!options.certificate.empty() && claims.size() != 1)
        throw Error("--certificate takes one claim, found " + std::to_string(claims.size()));
    ProgressBar bar("check");
    SearchLimits limits{options.instances, options.size, 0, claims.size() == 1 ? &bar : nullptr};
    WrittenSearch written(options, claims, limits, budget);
    std::map<ClaimVerdict, std::size_t> counts;
    Json all = Json::array();
    int worst = success;
    WorkCount done("claim", claims.size());
    const auto worse = [](int a, int b) {  // refuted is worse than undecided
        return a == refuted || b == refuted ? static_cast<int>(refuted) : std::max(a, b);
    };
    for (std::size_t i = 0; i < claims.size(); ++i) {
        done.at(i + 1, claims[i].name);
        CheckedClaim checked = check(std::move(claims[i]), budget, limits);
        proofs.settle(checked);
        ++counts[checked.verdict()];
        worst = worse(worst, status_of(checked, !options.accept.empty()));
        if (!options.certificate.empty())
            write_file(options.certificate, Json(certificate(checked)).text(1));
        if (options.json)
            all.add(as_json(checked, proofs));
        else if (options.latex)
            print(latex(checked));
        else
            print(options.explain
                      ? (i > 0 ? "\n" + std::string(100, '=') + "\n\n" : "") + explanation(checked)
                      : summary(checked, proofs));
        bar.report(static_cast<double>(i + 1) / static_cast<double>(claims.size()));
    }
    if (options.json)
        print(Json{{"claims", all}}.text());
    else if (claims.size() > 1 && !options.latex)
        print(std::to_string(claims.size()) + " claims: " +
              joined(counts, ", ",
                     [](const auto& one) {
                         return std::to_string(one.second) + ' ' +
                                std::string(to_string(one.first));
                     }) +
              '\n');
    return worst;
}

// verify

using verify::Finding;

struct VerifyOptions {
    std::string file, claim, accept;
    bool json = false;
    Bounds bounds;
};

std::string line_of(const Finding& found, const std::string& file) {
    std::string text = to_string(found.outcome) + ": " + found.statement;
    if (found.outcome == Finding::Outcome::cited) text += " (" + found.citation + ")";
    text += '\n';
    if (found.outcome == Finding::Outcome::wrong || found.outcome == Finding::Outcome::not_checked)
        text += "    " + file + ":" + std::to_string(found.line) + ": " + found.path + ": " +
                found.reason + '\n';
    return text;
}

std::string totals(const std::map<Finding::Outcome, std::size_t>& counts) {
    if (counts.empty()) return "no statements\n";
    return joined(counts, ", ",
                  [](const auto& one) {
                      return std::to_string(one.second) + " " + to_string(one.first);
                  }) +
           '\n';
}

Json as_json(const Finding& found) {
    Json out{{"statement", found.statement},
             {"outcome", to_string(found.outcome)},
             {"path", found.path},
             {"line", found.line}};
    if (!found.citation.empty()) out.set("citation", found.citation);
    if (!found.reason.empty()) out.set("reason", found.reason);
    return out;
}

/// A claim that a certificate must be of: the same letters, systems and statements.
class Claimed {
public:
    /// `name` is that of the certificate. Throws Error where the claim cannot be read.
    Claimed(const std::string& claim_file, std::string name, const Budget& budget)
        : file_(claim_file), name_(std::move(name)) {
        const Claim claim = open_claim(claim_file, budget);
        CheckedClaim nothing_known{claim, {}};  // the proofs are left out
        nothing_known.statements.resize(claim.statements.size());
        said_ = verify::parse_json(verify::source_of(certificate(nothing_known).dump()), file_);
        statements_ = verify::Field(said_, "", file_).at("statements").list();
    }

    /// Throws Error where the fields before the statements are of another claim.
    void check_header(const verify::JsonValue& given) const {
        const verify::Field claimed(said_, "", file_), here(given, "", name_);
        for (const char* part : {"claim", "alphabet", "systems", "turtles", "empty axiom"})
            if (claimed.has(part) != here.has(part) ||
                (here.has(part) && !same_value(claimed.at(part).value(), here.at(part).value())))
                refuse(std::string("its ") + (std::string(part) == "claim" ? "title" : part) +
                       " differs");
    }

    /// The same for the next statement.
    void check_next(const verify::Field& given) {
        if (next_ < statements_.size() &&
            !same_value(given.at("statement").value(), statements_[next_].at("statement").value()))
            refuse("statement " + std::to_string(next_ + 1) + " differs, which the claim writes " +
                   statements_[next_].at("text").text());
        ++next_;
    }

    void check_end() const {
        if (next_ != statements_.size())
            refuse("expected " + counted(statements_.size(), "statement") + ", found " +
                   std::to_string(next_));
    }

private:
    [[noreturn]] void refuse(const std::string& what) const {
        throw Error(name_ + ": the certificate is not of " + file_ + ": " + what);
    }

    std::string file_, name_;
    verify::JsonValue said_;
    std::vector<verify::Field> statements_;
    std::size_t next_ = 0;
};

int verify_certificate(const VerifyOptions& options) {
    const Budget budget = options.bounds.budget();
    if (!options.accept.empty() && options.accept != "cited")
        throw Error("--accept: expected 'cited', found " + algae::quoted(options.accept));
    const std::string name = options.file == "-" ? "standard input" : options.file;
    std::optional<Claimed> claimed;
    if (!options.claim.empty()) claimed.emplace(options.claim, name, budget);
    std::string title;
    std::map<Finding::Outcome, std::size_t> counts;
    std::size_t statements = 0;
    Json list = Json::array();
    verify::CertificateEvents events;
    events.on_start = [&](const verify::Certificate& certificate) {
        title = certificate.claim;
        if (claimed) claimed->check_header(certificate.header);
        if (options.json) return;
        for (const std::string& line : verify::definitions(certificate)) print(line + '\n');
    };
    events.on_statement = [&](const verify::Field& statement) {
        if (claimed) claimed->check_next(statement);
    };
    events.on_finding = [&](const Finding& found) {
        ++counts[found.outcome];
        ++statements;
        if (options.json)
            list.add(as_json(found));
        else
            print(line_of(found, name));
    };
    Budget reading = budget;
    reading.deadline.reset();  // what time leaves unchecked is told
    verify::check_certificate(file_source(options.file, reading), name, budget, events);
    if (claimed) claimed->check_end();
    print(options.json ? Json{{"claim", title}, {"statements", list}}.text() : totals(counts));
    if (counts.contains(Finding::Outcome::wrong)) return refuted;
    const std::size_t checked = counts[Finding::Outcome::checked] +
                                (options.accept.empty() ? 0 : counts[Finding::Outcome::cited]);
    return checked > 0 && checked == statements ? success : undecided;
}

}  // namespace

void add_check(Verbs& verbs) {
    auto [verb, options] = verbs.add("check", "Whether claims hold, statement by statement",
                                     {"algae check theory", "algae check union.claim --explain",
                                      "algae check --say 'for all 0L languages A, B: A | B is 0L'"},
                                     check_claims);
    verb.option("PATH", options.paths, "FILE|DIR",
                "claim files, folders of them, - for standard input, or theory, the claims that "
                "come with algae");
    verb.option("--say", options.statement, "STATEMENT", "a statement instead of files");
    verb.option("--alphabet", options.alphabet, letters, "LETTERS", alphabet_help);
    verb.option(
        "--instances", options.instances, natural, "N",
        "how many instances of a statement about all values are searched, 100000 if not given");
    verb.option("--size", options.size, natural, "K",
                "up to which size they are searched, 10 if not given");
    verb.option("--checkpoint", options.checkpoint, "FILE",
                "write how far the search for one statement came to a new file")
        .excludes = {"--resume"};
    verb.option("--resume", options.resume, "FILE",
                "go on from such a file, with the same or larger --instances and --size");
    verb.option("--accept", options.accept, "cited",
                "let statements that rest on a cited source count as decided");
    verb.flag("--explain", options.explain, "print the argument in sentences");
    add_formal_option(verb, options.formal);
    add_outside_flag(verb, options.outside);
    verb.output("--certificate", options.certificate, "FILE",
                "write what algae verify checks again");
    verb.json_flag(options.json);
    verb.latex_flag(options.latex,
                    "print statements and arguments as LaTeX, which needs amsmath and amsthm");
    verb.bounded_by(options.bounds);
}

void add_verify(Verbs& verbs) {
    auto [verb, options] = verbs.add(
        "verify", "Check a certificate again, by other and simpler means",
        {"algae check my.claim --certificate my.json", "algae verify my.json"}, verify_certificate);
    verb.option("FILE", options.file, "FILE", "a certificate, or - for standard input").required =
        true;
    verb.option("--against", options.claim, "FILE",
                "the claim that the certificate must be of: the same systems and statements");
    verb.option("--accept", options.accept, "cited",
                "let statements that rest on a cited source count as checked");
    verb.json_flag(options.json);
    verb.bounded_by(options.bounds);
}

}  // namespace algae::command
