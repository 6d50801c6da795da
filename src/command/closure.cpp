// The table of closure on the command line: `closure` shows which families of languages are closed under which operations.
//
// A cell is as good as what stands behind it, and says so. A formal statement about all languages of a family may be
// decided by a search for counterexamples; other cells are as good as the claims below theory/closure that settle them. A
// claim may name a theorem of theory/formal, too. The theorem is cited, unless `--formal` leads to its compiled proof.

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "command/detail/files.hpp"
#include "command/detail/formal.hpp"
#include "command/detail/output.hpp"
#include "command/detail/verb.hpp"
#include "exact/exact.hpp"
#include "language/language.hpp"
#include "notation/notation.hpp"
#include "render/render.hpp"
#include "watch/watch.hpp"

namespace algae::command {

namespace {

using Outcome = CheckedStatement::Outcome;

struct ClosureOptions {
    std::string family;
    std::vector<std::string> operation;  // its words
    std::string formal;                  // the folder of compiled proofs
    bool explain = false, json = false, latex = false;
    Bounds bounds;
};

/// The claims of the table, each checked when it is first asked for.
class Theory {
public:
    Theory(const std::string& proofs, const Budget& budget)
        : budget_(budget),
          claims_(read(budget)),
          table_(claims_),
          checked_(claims_.size()),
          proofs_(proofs, budget) {}

    std::optional<ClosureTable::Cell> cell(const std::string& family,
                                           const std::string& operation) const {
        return table_.cell(family, operation);
    }
    /// What a search finds of the formal statement that a family is closed, or that it is not; nullptr where there is no
    /// such statement. That it is not is searched for among small finite languages.
    const CheckedClaim* searched(const std::string& family, const std::string& operation,
                                 bool closed) {
        const auto [entry, is_new] = searched_.try_emplace({family, operation});
        if (is_new)
            if (std::optional<Claim> claim = closure_claim(family, operation, closed)) {
                const SearchLimits limits =
                    closed ? SearchLimits{0, 0, 0, nullptr} : SearchLimits{1'000, 9, 0, nullptr};
                entry->second = check(std::move(*claim), budget_, limits);
                is_stopped_ = is_stopped_ || is_stopped(*entry->second);
            }
        return entry->second ? &*entry->second : nullptr;
    }
    /// Whether the search came to no end, as a bound was reached.
    static bool is_stopped(const CheckedClaim& search) {
        const Answer& answer = search.statements.at(0).answer;
        return !answer.proof && !answer.searched;
    }
    /// The proof of the statement, or why the search for it was stopped; nullptr where neither is there.
    const CheckedClaim* theorem(const std::string& family, const std::string& operation,
                                bool closed) {
        const CheckedClaim* search = searched(family, operation, closed);
        const bool tells =
            search && (search->verdict() == ClaimVerdict::proved || is_stopped(*search));
        return tells ? search : nullptr;
    }
    /// What the claim says of a cell by a theorem in Coq; nullptr where it names none.
    const ClosureFact* formal(const std::string& family, const std::string& operation) const {
        const auto found = cell(family, operation);
        if (!found) return nullptr;
        for (const ClosureFact& fact : claims_[found->claim].closure)
            if (fact.operation == operation && !fact.theorem.empty() &&
                std::ranges::find(fact.families, family) != fact.families.end())
                return &fact;
        return nullptr;
    }
    const FormalProofs& proofs() const { return proofs_; }
    /// Cells are looked at one after the other; so many in all.
    void begin(std::size_t cells) { cells_.emplace("cell", cells); }
    void look_at(const std::string& family, const std::string& operation) {
        if (cells_) cells_->at(++looked_at_, family + ", " + operation);
    }
    const CheckedClaim& checked(std::size_t claim) {
        if (!checked_[claim]) checked_[claim] = check(claims_[claim], budget_);
        return *checked_[claim];
    }
    /// Whether every claim that was asked for is decided, and no bound was reached before.
    bool is_decided() const {
        return !is_stopped_ && std::ranges::none_of(checked_, [](const auto& checked) {
            return checked && checked->worst() == Outcome::undecided;
        });
    }

private:
    static std::vector<Claim> read(const Budget& budget) {
        std::vector<Claim> claims;
        for (const GalleryEntry& entry : theory_claims())
            if (entry.path.starts_with("theory/closure/"))
                claims.push_back(read_claim(entry.text, std::string(entry.path),
                                            systems_from({"."}, budget, false)));
        return claims;
    }

    const Budget& budget_;
    std::vector<Claim> claims_;
    ClosureTable table_;
    std::vector<std::optional<CheckedClaim>> checked_;
    std::map<std::pair<std::string, std::string>, std::optional<CheckedClaim>> searched_;
    bool is_stopped_ = false;
    FormalProofs proofs_;
    std::optional<WorkCount> cells_;
    std::uint64_t looked_at_ = 0;
};

/// What is known of a cell: "refuted" by a counterexample, or what the claim comes to that is about it.
std::string status_of(Theory& theory, const ClosureTable::Cell& cell, const std::string& family,
                      const std::string& operation) {
    if (const CheckedClaim* theorem = theory.theorem(family, operation, cell.closed)) {
        if (Theory::is_stopped(*theorem)) return "undecided";
        return cell.closed ? "proved" : "refuted";
    }
    return std::string(to_string(theory.checked(cell.claim).verdict()));
}

/// "+" and "-" where a formal statement decides it, with "e" where examples hold, in brackets where a source is cited, with
/// "*" where a proof in Coq is there.
std::string sign(Theory& theory, const std::string& family, const std::string& operation) {
    theory.look_at(family, operation);
    const auto cell = theory.cell(family, operation);
    if (!cell) return "?";
    const std::string plain = cell->closed ? "+" : "-";
    if (const ClosureFact* fact = theory.formal(family, operation);
        fact && theory.proofs().prove(*fact))
        return plain + "*";
    const std::string status = status_of(theory, *cell, family, operation);
    if (status == "proved" || status == "refuted") return plain;
    if (status == "examples") return "e" + plain;
    return status == "cited" ? "(" + plain + ")" : plain + "?";
}

Json as_json(Theory& theory, const std::string& family, const std::string& operation) {
    theory.look_at(family, operation);
    const auto cell = theory.cell(family, operation);
    Json entry{{"family", family}, {"operation", operation}};
    if (!cell) return entry.set("closed", nullptr);
    const std::string status = status_of(theory, *cell, family, operation);
    entry.set("closed", status == "undecided" ? Json() : Json(cell->closed));
    entry.set("status", status);
    if (status == "refuted") {
        const CheckedClaim& found = *theory.theorem(family, operation, cell->closed);
        Json witness;
        for (const auto& [name, value] :
             witness_of(found.statements.at(0).answer, *found.claim.alphabet))
            witness.set(name, value);
        entry.set("counterexample", std::move(witness));
    }
    if (const ClosureFact* fact = theory.formal(family, operation)) {
        Json formal{{"theorem", fact->theorem}, {"verdict", theory.proofs().verdict(*fact)}};
        if (theory.proofs().prove(*fact)) formal.set("by", theory.proofs().checkers());
        entry.set("formal", formal.set("says", formal_words(family, operation, cell->closed)));
    }
    return entry.set("claim", theory.checked(cell->claim).claim.name);
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
           "\n+ closed, - not closed; without a mark it is proved, - by a counterexample. e: "
           "examples of a "
           "construction or of\n"
           "an argument hold. In brackets: a statement of the claim rests on a cited source. "
           "`algae "
           "closure 0L union` shows a cell.\n" +
           (theory.proofs().checkers().empty()
                ? ""
                : "*: proved formally, by " + theory.proofs().checkers() +
                      ", from the definitions of theory/formal/Spec.v.\n");
}

/// A sentence in lines of at most 100 characters, indented.
std::string wrapped_line(const std::string& sentence) {
    std::string text, line = "  ";
    std::istringstream words(sentence);
    words.exceptions(std::ios::badbit);
    for (std::string word; words >> word;) {
        if (line.size() + word.size() + 1 > 100) {
            text += line + '\n';
            line = "  ";
        }
        line += ' ' + word;
    }
    return text + line + '\n';
}

std::string cell_text(Theory& theory, const std::string& family, const std::string& operation) {
    theory.look_at(family, operation);
    const auto cell = theory.cell(family, operation);
    if (!cell) throw Error("no claim settles whether " + family + " is closed under " + operation);
    const CheckedClaim& checked = theory.checked(cell->claim);
    const std::string under = "closed under " + operation;
    const std::string status = status_of(theory, *cell, family, operation);
    const bool is_known = status != "undecided";
    const std::string name =
        !is_known ? "Whether " + family + " languages are " + under + " is undecided"
                  : family + " languages are " + (cell->closed ? "" : "not ") + under;
    std::string text = name + " (" + checked.claim.name + ", " + status + ").\n\n";
    if (const ClosureFact* fact = theory.formal(family, operation)) {
        const FormalProofs& proofs = theory.proofs();
        text += "In Coq " + fact->theorem + ": " + proofs.verdict(*fact) +
                (proofs.prove(*fact) ? ", without axioms, by " + proofs.checkers()
                                     : "; tools/formal and --formal show the proof") +
                ".\n";
        for (const std::string& line : formal_words(family, operation, cell->closed))
            text += wrapped_line(line);
        text += '\n';
    }
    if (const CheckedClaim* theorem = theory.theorem(family, operation, cell->closed))
        text += explanation(*theorem) + '\n';
    return text +
           explanation(checked, is_known ? family : "");  // the reason may be at another family
}

/// The table, or rows of it, in plus and minus signs.
std::string table_latex(Theory& theory, const std::vector<std::string>& families,
                        const std::vector<std::string>& operations) {
    std::string text = "\\begin{tabular}{l" + std::string(families.size(), 'c') + "}\n ";
    for (const std::string& family : families) text += " & " + family;
    text += " \\\\ \\hline\n";
    for (const std::string& operation : operations) {
        text += "  " + escaped_latex(operation);
        for (const std::string& family : families)
            text += " & $" + escaped_latex(sign(theory, family, operation)) + "$";
        text += " \\\\\n";
    }
    return text + "\\end{tabular}\n";
}

/// A cell with what stands behind it.
std::string cell_latex(Theory& theory, const std::string& family, const std::string& operation) {
    theory.look_at(family, operation);
    const auto cell = theory.cell(family, operation);
    if (!cell) throw Error("no claim settles whether " + family + " is closed under " + operation);
    std::string text;
    if (const CheckedClaim* theorem = theory.theorem(family, operation, cell->closed))
        text += latex(*theorem) + '\n';
    return text + latex(theory.checked(cell->claim));
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
    Theory theory(options.formal, budget);
    std::vector<std::string> families = closure_families(), operations = closure_operations();
    if (!options.family.empty()) families = {known(options.family, families, "a family")};
    if (!options.operation.empty()) {
        operations = {known(joined(options.operation, " "), operations, "an operation")};
    }
    const bool one_cell = families.size() == 1 && operations.size() == 1;
    theory.begin(families.size() * operations.size());
    if (options.latex) {
        print(one_cell ? cell_latex(theory, families[0], operations[0])
                       : table_latex(theory, families, operations));
    } else if (options.json) {
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
            if (const CheckedClaim* theorem =
                    theory.theorem(families[0], operations[0], cell->closed))
                for (const std::string& line :
                     sentences(theorem->statements.at(0).answer, *theorem->claim.alphabet))
                    proof.add(line);
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

}  // namespace

void add_closure(Verbs& verbs) {
    auto [verb, options] = verbs.add(
        "closure", "Which families of languages are closed under which operations, with proofs",
        {"algae closure", "algae closure 0L union --explain"}, closure);
    verb.option("CLASS", options.family, joined(closure_families(), "|"), "a family of languages");
    verb.option("OP", options.operation, joined(closure_operations(), "|"), "an operation");
    verb.flag("--explain", options.explain, "print the proof of every cell asked for");
    add_formal_option(verb, options.formal);
    verb.json_flag(options.json);
    verb.latex_flag(
        options.latex,
        "print rows of the table, or a cell with its proof, as LaTeX, which needs amsmath "
        "and amsthm");
    verb.bounded_by(options.bounds);
}

}  // namespace algae::command
