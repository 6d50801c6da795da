#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "exact/exact.hpp"
#include "language/detail/judge.hpp"
#include "search/search.hpp"

// The table of closure: which families of languages are closed under which operations.
//
// A claim says in `closed under ...` which cells it is about; that alone settles nothing. That a family is not closed
// is a formal statement, `not for all F languages A, B: A | B is F`, and where a small finite counterexample exists
// it is decided by `closure_claim`, which needs no file. The other cells are as good as the claims that they point
// to: their theorem, or else examples.

namespace algae {

const std::vector<std::string>& closure_operations() {
    static const std::vector<std::string> all{"union",
                                              "concatenation",
                                              "star",
                                              "plus",
                                              "intersection",
                                              "intersection with regular",
                                              "complement",
                                              "homomorphism",
                                              "non-erasing homomorphism",
                                              "inverse homomorphism",
                                              "reversal",
                                              "finite substitution",
                                              "substitution",
                                              "gsm mapping"};
    return all;
}

const std::vector<std::string>& closure_families() {
    static const std::vector<std::string> all{"REG", "CF",   "D0L",   "PD0L", "0L",
                                              "P0L", "DT0L", "PDT0L", "T0L",  "PT0L",
                                              "E0L", "ET0L", "EDT0L", "IL"};
    return all;
}

namespace {

using Kind = LanguageTree::Kind;

/// An operation as an expression of bound names.
struct OperationForm {
    const char* name;
    const char* text;  // of the result
    std::size_t languages = 1;
    const char* second = "";   // the family of the second language, if it is another one
    const char* mapping = "";  // the noun of h
    Domain domain = {};        // of h
    bool is_special = false;   // a special case of the operation, which can only refute
};

/// The operations that the search knows. That a family is not closed under one of which another one is a special case
/// follows from that: a homomorphism is a gsm mapping; one that erases nothing is a substitution by languages of the
/// family, as every family has the languages of one word that is not empty.
const std::vector<OperationForm>& operation_forms() {
    using K = Domain::Kind;
    static const std::vector<OperationForm> all{
        {"union", "A | B", 2},
        {"concatenation", "A B", 2},
        {"star", "A*"},
        {"plus", "A+"},
        {"reversal", "A^R"},
        {"intersection", "A & B", 2},
        {"intersection with regular", "A & B", 2, "REG"},
        {"homomorphism", "h(A)", 1, "", "morphisms", {.kind = K::morphism}},
        {"gsm mapping", "h(A)", 1, "", "morphisms", {.kind = K::morphism}, true},
        {"non-erasing homomorphism",
         "h(A)",
         1,
         "",
         "non-erasing morphisms",
         {.kind = K::morphism, .nonerasing = true}},
        {"inverse homomorphism", "h^-1(A)", 1, "", "morphisms", {.kind = K::inverse_morphism}},
        {"finite substitution", "h(A)", 1, "", "finite substitutions", {.kind = K::substitution}},
        {"substitution",
         "h(A)",
         1,
         "",
         "non-erasing morphisms",
         {.kind = K::morphism, .nonerasing = true},
         true},
    };
    return all;
}

Language bound_language(std::size_t number, const char* name) {
    LanguageTree tree;
    tree.kind = Kind::variable;
    tree.variable = BoundName{number, name};
    return std::make_shared<const LanguageTree>(std::move(tree));
}

Language result_of(const OperationForm& form, std::size_t first) {
    const std::string name = form.name;
    const Language a = bound_language(first, "A"), b = bound_language(first + 1, "B");
    if (name == "union") return combined(Kind::united, {a, b});
    if (name == "concatenation") return combined(Kind::concatenated, {a, b});
    if (name == "star") return combined(Kind::star, {a});
    if (name == "plus") return combined(Kind::plus, {a});
    if (name == "reversal") return combined(Kind::reversed, {a});
    if (name.starts_with("intersection")) return combined(Kind::intersected, {a, b});
    LanguageTree tree;
    tree.kind = name == "inverse homomorphism" ? Kind::inverse_image : Kind::image;
    tree.parts = {a};
    tree.variable = BoundName{first + 1, "h"};
    return std::make_shared<const LanguageTree>(std::move(tree));
}

}  // namespace

std::optional<Statement> closure_statement(const std::string& family, const std::string& operation,
                                           bool closed, std::size_t first) {
    const auto& forms = operation_forms();
    const auto form = std::find_if(forms.begin(), forms.end(),
                                   [&](const OperationForm& one) { return one.name == operation; });
    if (form == forms.end() || (closed && form->is_special)) return std::nullopt;
    Quantified said;
    said.first = first;
    const auto bind = [&](const char* name, const std::string& of) {
        said.bindings.push_back({name, {}, of, {}, of + " languages"});
    };
    bind("A", family);
    std::string text = "for all " + family + " languages A";
    if (form->languages == 2 && !*form->second) {
        bind("B", family);
        text += ", B";
    } else if (form->languages == 2) {
        bind("B", form->second);
        text += " and regular languages B";
    } else if (*form->mapping) {
        said.bindings.push_back({"h", form->domain, {}, {}, form->mapping});
        text += std::string(" and ") + form->mapping + " h";
    }
    Statement body;
    body.says = InFamily{result_of(*form, first), family};
    body.text = std::string(form->text) + " is " + family;
    said.body = {body};
    Statement whole;
    whole.text = text + ": " + body.text;
    whole.says = std::move(said);
    return whole;
}

std::optional<Claim> closure_claim(const std::string& family, const std::string& operation,
                                   bool closed) {
    // Families that have all finite languages are closed under what keeps languages finite.
    const auto system = system_form(family);
    auto statement = closure_statement(family, operation, closed, 0);
    const bool is_searched = system && !system->extended && !system->interactive;
    if (!statement || (!closed && !is_searched)) return std::nullopt;
    Claim claim;
    claim.title = family + " languages are " + (closed ? "" : "not ") + "closed under " + operation;
    auto alphabet = std::make_shared<Alphabet>();
    for (char c = 'a'; c <= 'z'; ++c)
        (c < 'x' ? claim.instance_letters : claim.inverse_letters)
            .push_back(alphabet->symbol(std::string_view(&c, 1)));
    claim.inverse_letters.insert(claim.inverse_letters.end(), claim.instance_letters.rbegin(),
                                 claim.instance_letters.rend());
    claim.alphabet = std::move(alphabet);
    if (!closed) statement->text = "not " + statement->text;
    statement->negated = !closed;
    claim.statements.push_back({std::move(*statement), ClaimedStatement::Purpose::theorem, {}});
    return claim;
}

ClosureTable::ClosureTable(const std::vector<Claim>& claims) {
    std::map<std::pair<std::string, std::string>, Place> places;
    for (std::size_t i = 0; i < claims.size(); ++i)
        for (const ClosureFact& fact : claims[i].closure)
            for (const std::string& family : fact.families) {
                const auto key = std::pair(family, fact.operation);
                const auto [place, is_new] = places.emplace(key, fact.place);
                if (!is_new)
                    throw Error(to_string(fact.place) + ": whether " + family +
                                " is closed under " + fact.operation + " is settled at " +
                                to_string(place->second) + " already");
                cells_.emplace(key, Cell{fact.closed, i});
            }
}

std::optional<ClosureTable::Cell> ClosureTable::cell(std::string_view family,
                                                     std::string_view operation) const {
    const auto found = cells_.find(std::pair(std::string(family), std::string(operation)));
    return found == cells_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace algae
