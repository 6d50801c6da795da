// Claims of the theory and their certificates: `check` decides what a claim says, `closure` shows the table
// that the claims below theory/closure make together, `verify` checks a certificate again.
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

#include "command/detail/files.hpp"
#include "command/detail/output.hpp"
#include "command/detail/verb.hpp"
#include "exact/exact.hpp"
#include "language/language.hpp"
#include "notation/notation.hpp"
#include "verify/verify.hpp"

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
        for (const auto& entry : std::filesystem::recursive_directory_iterator(path))
            if (entry.is_regular_file() && entry.path().extension() == ".claim")
                files.push_back(entry.path().string());
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
Claim open_claim(const std::string& file, const Budget& budget) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored))
        for (const GalleryEntry& claim : theory_claims())
            if (claim.path == file)
                return read_claim(claim.text, file, systems_from({"."}, budget));
    const std::string text = file_text(file, budget);
    return read_claim(text, file == "-" ? "standard input" : file,
                      systems_from({folder_of(file)}, budget));
}

// check

struct CheckOptions {
    std::vector<std::string> paths;
    std::string certificate;
    bool explain = false, json = false;
    Bounds bounds;
};

/// One line for the claim, and lines with the reasons for each statement that does not stand.
std::string summary(const CheckedClaim& checked) {
    std::string text =
        fmt::format("{:<9}  {}\n", to_string(checked.outcome()), checked.claim.title);
    for (std::size_t i = 0; i < checked.statements.size(); ++i) {
        const CheckedStatement& found = checked.statements[i];
        if (found.outcome != Outcome::wrong && found.outcome != Outcome::undecided) continue;
        const ClaimedStatement& claimed = checked.claim.statements[i];
        text += "    " + to_string(claimed.statement.place) + ": " + claimed.statement.text + ": " +
                verdict_text(claimed, found) + '\n';
        for (const std::string& line : sentences(found.answer, *checked.claim.alphabet))
            text += "        " + line + '\n';
    }
    return text;
}

Json as_json(const CheckedClaim& checked) {
    Json statements = Json::array();
    for (std::size_t i = 0; i < checked.statements.size(); ++i) {
        const ClaimedStatement& claimed = checked.claim.statements[i];
        const CheckedStatement& found = checked.statements[i];
        Json entry{{"text", claimed.statement.text}, {"verdict", verdict_text(claimed, found)}};
        if (!claimed.citation.empty()) entry.set("citation", claimed.citation);
        entry.set("argument", sentences(found.answer, *checked.claim.alphabet));
        statements.add(std::move(entry));
    }
    return {{"claim", checked.claim.title},
            {"file", checked.claim.name},
            {"verdict", to_string(checked.outcome())},
            {"statements", statements}};
}

int check_paths(const CheckOptions& options) {
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
        if (!options.certificate.empty())
            write_file(options.certificate, Json(certificate(checked)).text(1));
        if (options.json)
            all.add(as_json(checked));
        else
            print(options.explain
                      ? (i > 0 ? "\n" + std::string(100, '=') + "\n\n" : "") + explanation(checked)
                      : summary(checked));
        bar.report(static_cast<double>(i + 1) / static_cast<double>(claims.size()));
    }
    if (options.json)
        print(Json{{"claims", all}}.text());
    else if (claims.size() > 1)
        print(fmt::format("{} claims: {} proved, {} cited, {} undecided, {} wrong\n", claims.size(),
                          counts[0], counts[1], counts[2], counts[3]));
    return worst == Outcome::wrong ? refuted : worst == Outcome::undecided ? undecided : success;
}

// closure

struct ClosureOptions {
    std::string family;
    std::vector<std::string> operation;  // its words
    bool explain = false, json = false;
    Bounds bounds;
};

/// The claims of the table, each checked when it is first asked for.
class Theory {
public:
    explicit Theory(const Budget& budget)
        : budget_(budget), claims_(read(budget)), table_(claims_), checked_(claims_.size()) {}

    std::optional<ClosureTable::Cell> cell(const std::string& family,
                                           const std::string& operation) const {
        return table_.cell(family, operation);
    }
    const CheckedClaim& checked(std::size_t claim) {
        if (!checked_[claim]) checked_[claim] = check(claims_[claim], budget_);
        return *checked_[claim];
    }
    /// Whether every claim that was asked for is decided, and no bound was reached before.
    bool is_decided() const {
        return std::ranges::none_of(checked_, [](const auto& checked) {
            return checked && checked->outcome() == Outcome::undecided;
        });
    }

private:
    static std::vector<Claim> read(const Budget& budget) {
        std::vector<Claim> claims;
        for (const GalleryEntry& entry : theory_claims())
            if (entry.path.starts_with("theory/closure/"))
                claims.push_back(
                    read_claim(entry.text, std::string(entry.path), systems_from({"."}, budget)));
        return claims;
    }

    const Budget& budget_;
    std::vector<Claim> claims_;
    ClosureTable table_;
    std::vector<std::optional<CheckedClaim>> checked_;
};

/// "+" and "-" where all statements of the claim are proved, in brackets where some rest on a source.
std::string sign(Theory& theory, const std::string& family, const std::string& operation) {
    const auto cell = theory.cell(family, operation);
    if (!cell) return "?";
    const std::string plain = cell->closed ? "+" : "-";
    switch (theory.checked(cell->claim).outcome()) {
        case Outcome::stands:
            return plain;
        case Outcome::cited:
            return "(" + plain + ")";
        default:
            return plain + "?";
    }
}

Json as_json(Theory& theory, const std::string& family, const std::string& operation) {
    const auto cell = theory.cell(family, operation);
    Json entry{{"family", family}, {"operation", operation}};
    if (!cell) return entry.set("closed", nullptr);
    const CheckedClaim& checked = theory.checked(cell->claim);
    const bool is_known = checked.outcome() != Outcome::undecided;
    entry.set("closed", is_known ? Json(cell->closed) : Json());
    entry.set("status", to_string(checked.outcome()));
    entry.set("claim", checked.claim.name);
    return entry;
}

std::string table_text(Theory& theory, const std::vector<std::string>& families,
                       const std::vector<std::string>& operations) {
    std::size_t widest = 0;
    for (const std::string& operation : operations) widest = std::max(widest, operation.size());
    std::string text = fmt::format("{:<{}}", "", widest);
    for (const std::string& family : families) text += fmt::format("  {:^5}", family);
    text += '\n';
    for (const std::string& operation : operations) {
        std::string line = fmt::format("{:<{}}", operation, widest);
        for (const std::string& family : families)
            line += fmt::format("  {:^5}", sign(theory, family, operation));
        text += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
    }
    return text +
           "\n+ closed, by a construction or theorem whose instance is decided; - not closed, by a "
           "counterexample that is proved\n"
           "in brackets: some statement of the claim rests on a cited source. `algae closure 0L "
           "union` shows a cell.\n";
}

std::string cell_text(Theory& theory, const std::string& family, const std::string& operation) {
    const auto cell = theory.cell(family, operation);
    if (!cell) throw Error("no claim settles whether " + family + " is closed under " + operation);
    const CheckedClaim& checked = theory.checked(cell->claim);
    const std::string under = "closed under " + operation;
    const bool is_known = checked.outcome() != Outcome::undecided;
    const std::string name =
        !is_known ? "Whether " + family + " languages are " + under + " is undecided"
                  : family + " languages are " + (cell->closed ? "" : "not ") + under;
    return name + " (" + checked.claim.name + ", " + to_string(checked.outcome()) + ").\n\n" +
           explanation(checked, is_known ? family : "");  // the reason may be at another family
}

std::string known(const std::string& written, const std::vector<std::string>& all,
                  const std::string& what) {
    std::string plain = written;
    std::ranges::replace(plain, '-', ' ');
    for (const std::string& name : all) {
        std::string other = name;
        std::ranges::replace(other, '-', ' ');
        if (other == plain) return name;
    }
    throw Error("expected " + what + " of the table (" + joined(all, ", ") + "), found " + written +
                did_you_mean(written, all));
}

int closure(const ClosureOptions& options) {
    const Budget budget = options.bounds.budget();
    Theory theory(budget);
    std::vector<std::string> families = closure_families(), operations = closure_operations();
    if (!options.family.empty()) families = {known(options.family, families, "a family")};
    if (!options.operation.empty()) {
        operations = {known(joined(options.operation, " "), operations, "an operation")};
    }
    const bool one_cell = families.size() == 1 && operations.size() == 1;
    if (options.json) {
        std::vector<Json> entries;
        for (const std::string& operation : operations)
            for (const std::string& family : families)
                entries.push_back(as_json(theory, family, operation));
        if (!one_cell) {
            print(Json{{"table", entries}}.text());
            return theory.is_decided() ? success : undecided;
        }
        const auto cell = theory.cell(families[0], operations[0]);
        Json proof = Json::array();
        if (cell) {
            const CheckedClaim& checked = theory.checked(cell->claim);
            for (const CheckedStatement& statement : checked.statements)
                for (const std::string& line : sentences(statement.answer, *checked.claim.alphabet))
                    proof.add(line);
        }
        print(Json{{"verdict", !cell                  ? "not settled"
                               : !theory.is_decided() ? "undecided"
                               : cell->closed         ? "closed"
                                                      : "not closed"},
                   {"cell", entries[0]},
                   {"proof", proof}}
                  .text());
    } else if (one_cell) {
        print(cell_text(theory, families[0], operations[0]));
    } else if (options.explain) {
        std::string text;
        for (const std::string& operation : operations)
            for (const std::string& family : families)
                if (theory.cell(family, operation))
                    text += (text.empty() ? "" : "\n" + std::string(100, '=') + "\n\n") +
                            cell_text(theory, family, operation);
        print(text);
    } else {
        print(table_text(theory, families, operations));
    }
    if (!theory.is_decided()) return undecided;
    if (!one_cell) return success;
    const auto cell = theory.cell(families[0], operations[0]);
    return !cell ? undecided : cell->closed ? success : refuted;
}

// verify

using verify::Finding;

struct VerifyOptions {
    std::string file;
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

int verify_certificate(const VerifyOptions& options) {
    const Budget budget = options.bounds.budget();
    const std::string name = options.file == "-" ? "standard input" : options.file;
    const auto certificate = verify::read_certificate(file_text(options.file, budget), name);
    const auto findings = verify::check_certificate(*certificate, budget);
    std::map<Finding::Outcome, std::size_t> counts;
    std::string text;
    Json list = Json::array();
    for (const Finding& found : findings) {
        ++counts[found.outcome];
        text += line_of(found, name);
        list.add(as_json(found));
    }
    print(options.json ? Json{{"claim", certificate->claim}, {"statements", list}}.text()
                       : text + totals(counts));
    return counts.contains(Finding::Outcome::wrong)         ? refuted
           : counts.contains(Finding::Outcome::not_checked) ? undecided
                                                            : success;
}

}  // namespace

void add_check(Verbs& verbs) {
    auto [verb, options] =
        verbs.add("check", "Whether claims hold, statement by statement",
                  {"algae check theory", "algae check union.claim --explain"}, check_paths);
    verb.option("PATH", options.paths, "FILE|DIR",
                "claim files, folders of them, - for standard input, or theory, the claims that "
                "come with algae")
        .required = true;
    verb.flag("--explain", options.explain, "print the argument in sentences");
    verb.option("--certificate", options.certificate, "FILE",
                "write what algae verify checks again");
    verb.json_flag(options.json);
    verb.bounded_by(options.bounds);
}

void add_closure(Verbs& verbs) {
    auto [verb, options] = verbs.add(
        "closure", "Which families of languages are closed under which operations, with proofs",
        {"algae closure", "algae closure 0L union --explain"}, closure);
    verb.option("CLASS", options.family, joined(closure_families(), "|"), "a family of languages");
    verb.option("OP", options.operation, joined(closure_operations(), "|"), "an operation");
    verb.flag("--explain", options.explain, "print the proof of every cell asked for");
    verb.json_flag(options.json);
    verb.bounded_by(options.bounds);
}

void add_verify(Verbs& verbs) {
    auto [verb, options] = verbs.add(
        "verify", "Check a certificate again, by other and simpler means",
        {"algae check my.claim --certificate my.json", "algae verify my.json"}, verify_certificate);
    verb.option("FILE", options.file, "FILE", "a certificate, or - for standard input").required =
        true;
    verb.json_flag(options.json);
    verb.bounded_by(options.bounds);
}

}  // namespace algae::command
