#include <algorithm>
#include <array>

#include "base/error.hpp"
#include "verify/contains.hpp"
#include "verify/finite_check.hpp"
#include "verify/obstruction_json.hpp"
#include "verify/proofs.hpp"
#include "verify/values.hpp"

namespace algae::verify {

namespace {

std::set<Word> finite_words(const Checking& with, const Language& language, const Field& proof) {
    auto words = finite_values(language, with.alphabet(), with.budget);
    if (!words) proof.refuse("the language is infinite");
    return std::move(*words);
}

Statement equality(const Language& left, const Language& right) {
    Statement equal;
    equal.kind = Statement::Kind::equal;
    equal.languages = {left, right};
    return equal;
}

std::shared_ptr<const System> system_of_form(const Checking& with, const std::string& family,
                                             const Field& field) {
    auto system = std::make_shared<const System>(with.reader.system(field));
    if (const auto beyond = beyond_form(*system, family, with.certificate.empty_axiom))
        field.refuse("the system has not the form of " + family + ": " + *beyond);
    return system;
}

/// Derives the words of a system and stops at the first terminal word that should not be there.
void check_finite_system(const Checking& with, const std::string& family, const Language& language,
                         const Field& proof) {
    const auto words = finite_words(with, language, proof);
    const auto system = system_of_form(with, family, proof.at("system"));
    const auto derived = finite_values(generated_by(system, ""), with.alphabet(), with.budget);
    if (derived != words) proof.at("system").refuse("the system does not generate the language");
}

void check_form(const Checking& with, const std::string& family, const Language& language,
                const Field& proof) {
    if (language->kind != Tree::Kind::generated)
        proof.refuse("the language is not given by a system");
    if (const auto beyond = beyond_form(*language->system, family, with.certificate.empty_axiom))
        proof.refuse("the system has not the form of " + family + ": " + *beyond);
}

void check_all_finite(const Checking& with, const std::string& family, const Language& language,
                      const Field& proof) {
    static constexpr std::array all = {"E0L", "ET0L", "EDT0L", "IL", "REG", "CF"};
    if (std::find(all.begin(), all.end(), family) == all.end())
        proof.refuse("not all finite languages are " + family);
    const auto words = finite_words(with, language, proof);
    const bool has_axiom = std::any_of(words.begin(), words.end(), [&](const Word& word) {
        return with.certificate.empty_axiom || !word.empty();
    });
    if (family == "IL" && !has_axiom) proof.refuse("no word of the language can be the axiom");
}

void check_cases(const Checking& with, const std::string& family, const Language& language,
                 const Field& proof) {
    const auto& all = all_families();
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](Family each) { return to_string(each) == family; });
    if (found == all.end()) proof.refuse("no proof by cases is known for " + family);
    const auto words = finite_words(with, language, proof);
    FamilyObstruction obstruction = read_obstruction(with.reader, proof.at("obstruction"));
    obstruction.family = *found;
    obstruction.empty_axiom = with.certificate.empty_axiom;
    obstruction.language =
        make_finite_language(with.certificate.alphabet, {words.begin(), words.end()});
    if (const auto flaw = flaw_in(obstruction, with.budget)) proof.refuse(*flaw);
}

/// All families are closed under reversal, and it is its own inverse.
void check_reversal(const Checking& with, const Statement& statement, bool holds,
                    const Field& proof) {
    if (statement.languages[0]->kind != Tree::Kind::reversal)
        proof.refuse("the language is no reversal");
    Statement part = statement;
    part.languages = statement.languages[0]->parts;
    check_proof(with, part, holds, proof.at("proof"));
}

/// The lengths of the words are infinitely many, and so few that they hold no arithmetic progression; but those
/// of an infinite context-free language do (Parikh 1966).
void check_sparse(const Statement& statement, const Field& proof) {
    const Language& language = statement.languages[0];
    if (statement.family != "REG" && statement.family != "CF")
        proof.refuse("this shows nothing of " + statement.family);
    if (language->kind != Tree::Kind::generated || !is_d0l(*language->system))
        proof.refuse("the language is not given by a D0L system");
    const Growth growth = growth_of(*language->system);
    if (growth.name != "exponential" && (growth.name != "polynomial" || growth.degree < 2))
        proof.refuse("the lengths grow no faster than n");
}

/// A propagating system derives the empty word from no other.
void check_empty_word(const Checking& with, const Statement& statement, const Field& proof) {
    if (!statement.family.starts_with('P'))
        proof.refuse("a system of the family " + statement.family + " may derive the empty word");
    if (with.certificate.empty_axiom) proof.refuse("the empty word may be the axiom");
    if (!contains(statement.languages[0], {}, with.alphabet(), with.budget))
        proof.refuse("the empty word is not in the language");
}

}  // namespace

void check_family(const Checking& with, const Statement& statement, bool holds, const Field& proof,
                  const std::string& by) {
    const Language& language = statement.languages[0];
    if (by == "reversal") {
        proof.only({"by", "proof"});
        check_reversal(with, statement, holds, proof);
    } else if (!holds && by == "empty word") {
        proof.only({"by"});
        check_empty_word(with, statement, proof);
    } else if (!holds && by == "sparse") {
        proof.only({"by"});
        check_sparse(statement, proof);
    } else if (!holds) {
        if (by != "cases") wrong_kind(proof, by);
        proof.only({"by", "obstruction"});
        check_cases(with, statement.family, language, proof);
    } else if (by == "system") {
        proof.only({"by", "system"});
        check_finite_system(with, statement.family, language, proof);
    } else if (by == "form") {
        proof.only({"by"});
        check_form(with, statement.family, language, proof);
    } else if (by == "equal") {
        proof.only({"by", "system", "proof"});
        const auto system = system_of_form(with, statement.family, proof.at("system"));
        check_proof(with, equality(generated_by(system, ""), language), true, proof.at("proof"));
    } else if (by == "finite") {
        proof.only({"by"});
        check_all_finite(with, statement.family, language, proof);
    } else if (by == "regular") {
        proof.only({"by"});
        if (statement.family != "REG" && statement.family != "CF") wrong_kind(proof, by);
        check_regular(with, language, proof);
    } else {
        wrong_kind(proof, by);
    }
}

}  // namespace algae::verify
