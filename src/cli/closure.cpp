#include <fmt/format.h>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "claim/check.hpp"
#include "claim/closure_table.hpp"
#include "cli/claims.hpp"
#include "cli/command.hpp"
#include "cli/output.hpp"
#include "notation/gallery.hpp"
#include "notation/suggestion.hpp"

namespace algae::cli {

namespace {

using Outcome = CheckedStatement::Outcome;
using Json = nlohmann::ordered_json;

struct Options {
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
        return std::none_of(checked_.begin(), checked_.end(), [](const auto& checked) {
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
    if (!cell) {
        entry["closed"] = nullptr;
        return entry;
    }
    const CheckedClaim& checked = theory.checked(cell->claim);
    const bool is_known = checked.outcome() != Outcome::undecided;
    entry["closed"] = is_known ? Json(cell->closed) : Json(nullptr);
    entry["status"] = to_string(checked.outcome());
    entry["claim"] = checked.claim.name;
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
    const std::string name =
        checked.outcome() == Outcome::undecided
            ? "Whether " + family + " languages are " + under + " is undecided"
            : family + " languages are " + (cell->closed ? "" : "not ") + under;
    return name + " (" + checked.claim.name + ", " + to_string(checked.outcome()) + ").\n\n" +
           explanation(checked, family);
}

std::string known(const std::string& written, const std::vector<std::string>& all,
                  const std::string& what) {
    std::string plain = written;
    std::replace(plain.begin(), plain.end(), '-', ' ');
    for (const std::string& name : all) {
        std::string other = name;
        std::replace(other.begin(), other.end(), '-', ' ');
        if (other == plain) return name;
    }
    std::string listed;
    for (const std::string& name : all) listed += (listed.empty() ? "" : ", ") + name;
    throw Error("expected " + what + " of the table (" + listed + "), found " + written +
                did_you_mean(written, all));
}

int closure(const Options& options) {
    const Budget budget = options.bounds.budget();
    Theory theory(budget);
    std::vector<std::string> families = closure_families(), operations = closure_operations();
    if (!options.family.empty()) families = {known(options.family, families, "a family")};
    if (!options.operation.empty()) {
        std::string operation;
        for (const std::string& word : options.operation)
            operation += (operation.empty() ? "" : " ") + word;
        operations = {known(operation, operations, "an operation")};
    }
    const bool one_cell = families.size() == 1 && operations.size() == 1;
    if (options.json) {
        Json entries = Json::array();
        for (const std::string& operation : operations)
            for (const std::string& family : families)
                entries.push_back(as_json(theory, family, operation));
        if (!one_cell) {
            print(Json{{"table", entries}}.dump(2) + "\n");
            return theory.is_decided() ? success : undecided;
        }
        const auto cell = theory.cell(families[0], operations[0]);
        Json proof = Json::array();
        if (cell)
            for (const CheckedStatement& statement : theory.checked(cell->claim).statements)
                for (const std::string& line : statement.judgement.argument) proof.push_back(line);
        print(Json{{"verdict", !cell                  ? "not settled"
                               : !theory.is_decided() ? "undecided"
                               : cell->closed         ? "closed"
                                                      : "not closed"},
                   {"cell", entries[0]},
                   {"proof", proof}}
                  .dump(2) +
              "\n");
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

}  // namespace

void add_closure(Verbs& verbs) {
    auto options = std::make_shared<Options>();
    CLI::App& verb =
        add_verb(verbs, "closure",
                 "Which families of languages are closed under which operations, with proofs",
                 "  algae closure\n  algae closure 0L union --explain", options, closure);
    verb.add_option("CLASS", options->family, "a family of languages")
        ->type_name(fmt::format("{}", fmt::join(closure_families(), "|")));
    verb.add_option("OP", options->operation, "an operation")
        ->type_name(fmt::format("{}", fmt::join(closure_operations(), "|")));
    verb.add_flag("--explain", options->explain, "print the proof of every cell asked for");
    verb.add_flag("--json", options->json, "print one JSON object");
    options->bounds.add_to(verb);
}

}  // namespace algae::cli
