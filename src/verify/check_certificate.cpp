#include <algorithm>
#include <array>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "exact/exact.hpp"
#include "verify/detail/checking.hpp"
#include "verify/detail/languages.hpp"
#include "verify/detail/words.hpp"
#include "verify/verify.hpp"
#include "watch/watch.hpp"

// Which kinds of proof show which statements, and the result for each statement of a certificate. If a bound is reached, the
// statement is not checked; only a flaw makes it wrong.

namespace algae::verify {

namespace {

using Kind = Statement::Kind;

/// A kind of proof: which statements it is about, whether it shows these, their opposites or both, and its fields.
struct Method {
    enum Shows { either, statement, opposite };
    std::string_view by;
    std::vector<Kind> kinds;  // empty: all
    Shows shows = either;
    std::vector<std::string_view> fields;  // besides "by"
    void (*check)(const Obligation& task) = nullptr;
};

void check_construction(const Obligation& task) {
    task.proof.at("system").only({"axiom", "tables", "terminals"});
    throw BoundReached(Bound::method,
                       "it rests on a system made by the constructions of a theorem");
}

void check_dimension(const Obligation&) {
    throw BoundReached(Bound::method,
                       "how the parts of this limit set meet is not worked out again");
}

void check_environment(const Obligation&) {
    throw BoundReached(Bound::method, "what environments answer is not worked out again");
}

const std::vector<Method>& methods() {
    static const std::vector<Kind> family{Kind::family}, pair{Kind::equal, Kind::included},
        equal{Kind::equal}, included{Kind::included}, empty{Kind::empty},
        rewriting{Kind::rewrites, Kind::chance}, sequences{Kind::equal_sequences},
        codes{Kind::code, Kind::prefix_code};
    constexpr auto either = Method::either, holds = Method::statement, fails = Method::opposite;
    static const std::vector<Method> all = {
        {"construction", {}, either, {"system"}, check_construction},
        {"dimension", {Kind::dimension, Kind::boundary}, either, {"conditions"}, check_dimension},
        {"limit set",
         {Kind::dimension, Kind::boundary},
         either,
         {"order", "phases", "scale", "turn", "ways", "factor", "component", "discs", "neighbours",
          "bounds"},
         check_limit_set},
        {"reversal", family, either, {"proof"}, check_reversal},
        {"empty word", family, fails, {}, check_empty_word},
        {"sparse", family, fails, {}, check_sparse},
        {"progressions", family, holds, {"first", "period"}, check_regular_progressions},
        {"unequal powers", family, fails, {"first", "step", "parts"}, check_unequal_powers},
        {"cases", family, fails, {"obstruction"}, check_cases},
        {"system", family, holds, {"system"}, check_finite_system},
        {"form", family, holds, {}, check_form},
        {"equal", family, holds, {"system", "proof"}, check_equal_to_form},
        {"finite", family, holds, {}, check_all_finite},
        {"regular", family, holds, {}, check_regular_family},
        {"closed", family, holds, {}, check_closed},
        {"context-free", family, holds, {}, check_context_free},
        {"powers", family, fails, {}, check_powers_beyond},
        {"classes", family, fails, {"case", "apart"}, check_classes},
        {"lengths", family, fails, {"sums", "targets"}, check_lengths},
        {"dense", family, fails, {}, check_dense},
        {"cycles", family, fails, {"word"}, check_cycles},
        {"proportional", family, fails, {}, check_proportional},
        {"blocks", family, fails, {}, check_blocks},
        {"geometric", family, fails, {"length", "infinite"}, check_geometric},
        {"values", {Kind::finite, Kind::empty, Kind::size}, either, {}, check_size_of_values},
        {"relations", empty, holds, {}, check_no_word},
        {"word", empty, fails, {"word"}, check_a_word},
        {"infinite", {Kind::size}, fails, {"proof"}, check_infinite_part},
        {"values", pair, either, {}, check_values},
        {"word", pair, fails, {"word"}, check_word_in_one},
        {"derivatives", pair, holds, {}, check_derivatives},
        {"linear", pair, holds, {}, check_linear},
        {"facts", {}, Method::either, {"facts", "proof"}, check_facts},
        {"identical", pair, holds, {}, check_identical},
        {"sequences", pair, holds, {"proof"}, check_same_sequences},
        {"sections", pair, holds, {"words", "sections"}, check_sections},
        {"progressions", equal, holds, {"first", "period"}, check_same_progressions},
        {"powers", equal, holds, {}, check_same_powers},
        {"both", equal, holds, {"proofs"}, check_both},
        {"induction", included, holds, {"base", "counted", "from", "tables"}, check_induction},
        {"rules", included, holds, {}, check_rules},
        {"relations", included, holds, {}, check_relations},
        {"invariant",
         {Kind::included, Kind::empty, Kind::member, Kind::derives},
         either,
         {"automata"},
         check_invariant},
        {"code", codes, holds, {}, check_code},
        {"factorisations", codes, fails, {"word", "ends"}, check_factorisations},
        {"beginning", {Kind::prefix_code}, fails, {"word", "beginning"}, check_beginning},
        {"letters", {Kind::palindrome}, either, {}, check_palindrome},
        {"membership", {Kind::member}, either, {"derivation", "preimage"}, check_membership},
        {"derivation", {Kind::derives}, holds, {"words", "tables"}, check_derivation},
        {"exhausted", {Kind::derives}, fails, {}, check_not_derived},
        {"environment", rewriting, either, {}, check_environment},
        {"rewriting", rewriting, either, {}, check_rewriting},
        {"balance", sequences, holds, {"bound", "states", "accepts"}, check_balance},
        {"lengths", sequences, holds, {}, check_finite_sequences},
        {"generation", sequences, fails, {"generation", "position"}, check_difference},
        {"terms", {Kind::equal_growth}, holds, {}, check_equal_terms},
        {"generation", {Kind::equal_growth}, fails, {"generation"}, check_other_length},
        {"values", {Kind::numbers}, either, {}, check_numbers},
        {"recurrences", {Kind::quantified}, either, {"orders"}, check_recurrences},
        {"positive",
         {Kind::quantified},
         either,
         {"larger", "from", "roots", "recurrence"},
         check_positive},
        {"components", {Kind::growth_class}, either, {}, check_growth_class},
        {"letters", {Kind::increasing}, holds, {}, check_rises},
        {"vectors", {Kind::increasing}, holds, {"generation"}, check_rises_by_letters},
        {"generation", {Kind::increasing}, fails, {"generation"}, check_falls},
        {"words", {Kind::words}, either, {}, check_words},
        {"morphism", {Kind::quantified}, holds, {"morphism"}, check_step_of_words},
        {"automata", {Kind::first_order}, either, {"addition"}, check_first_order},
        {"automata", {Kind::counts}, either, {"addition"}, check_counts},
        {"bispecial", {Kind::counts}, holds, {"sums"}, check_bispecial},
        {"repetitions", {Kind::critical_exponent}, either, {"exponent"}, check_repetitions},
        {"repetition",
         {Kind::critical_exponent},
         either,
         {"word", "power"},
         check_endless_repetition},
        {"repetition", {Kind::circular}, fails, {"word", "power"}, check_endless_repetition},
        {"windows", {Kind::circular}, holds, {"delay"}, check_synchronised},
        {"parts", {Kind::joint}, either, {"parts"}, check_parts},
        {"instance",
         {Kind::quantified},
         either,
         {"values", "members", "with", "proof"},
         check_instance},
        {"cases", {Kind::quantified}, either, {"instances", "cases"}, check_all_instances},
        {"families", {Kind::quantified}, holds, {}, check_by_families},
        {"sparse", {Kind::quantified}, holds, {}, check_all_sparse},
        {"longer", {Kind::quantified}, holds, {}, check_longer},
        {"letters", {Kind::quantified}, holds, {"letters", "proof"}, check_by_letters},
        {"each", {Kind::quantified}, holds, {"proofs"}, check_by_each},
        {"derivations", {Kind::quantified}, holds, {"split", "cases"}, check_derivations},
    };
    return all;
}

/// The kinds of proof that a language is infinite.
const std::vector<Method>& methods_of_infinity() {
    static const std::vector<Method> all = {
        {"endless round", {}, Method::either, {"rules", "other"}, check_endless_round},
        {"endless tables",
         {},
         Method::either,
         {"again", "other", "before", "round", "beside", "kept", "after"},
         check_endless_tables},
        {"measure", {}, Method::either, {"words", "rules", "automaton"}, check_measure},
        {"pumping", {}, Method::either, {"prefix", "middle", "suffix"}, check_pumping},
        {"part", {}, Method::either, {"index", "proof"}, check_part},
        {"powers", {}, Method::either, {}, check_endless_powers},
    };
    return all;
}

void check_by(const std::vector<Method>& methods, const Obligation& task) {
    const Statement& said = task.statement;
    if (said.kind == Kind::family && !is_checked_family(said.family))
        throw BoundReached(Bound::method,
                           "proofs about the family " + said.family + " are not checked");
    const std::string& by = task.proof.at("by").text();
    for (const Method& method : methods) {
        const auto& kinds = method.kinds;
        if (method.by != by ||
            method.shows == (task.holds ? Method::opposite : Method::statement) ||
            (!kinds.empty() && !std::count(kinds.begin(), kinds.end(), task.statement.kind)))
            continue;
        std::vector<std::string_view> fields = method.fields;
        fields.push_back("by");
        task.proof.only(fields);
        return method.check(task);
    }
    const bool infinite = task.statement.kind == Kind::finite && !task.holds;
    if (!infinite || &methods == &methods_of_infinity()) task.wrong_kind();
    check_by(methods_of_infinity(), task);
}

}  // namespace

void Obligation::wrong_kind() const {
    const Field by = proof.at("by");
    by.refuse("no proof by '" + by.text() + "' shows this");
}

bool Obligation::contains(const Language& in, const Word& word) const {
    return verify::contains(in, word, alphabet(), budget);
}

std::optional<std::set<Word>> Obligation::values(const Language& of) const {
    return finite_values(of, alphabet(), budget);
}

void check_regular(const Obligation& task, const Language& language) {
    if (language->kind == Tree::Kind::generated && !task.values(language))
        task.refuse("a system occurs in the expression whose language is not finite");
    if (language->kind == Tree::Kind::powers && !regular_form(*language->powers))
        task.refuse("powers occur in the expression that are not seen to be regular");
    for (const Language& part : language->parts) check_regular(task, part);
}

void check_proof(const Obligation& task) { check_by(methods(), task); }

void check_infinite(const Obligation& task, const Language& language, const Field& proof) {
    Statement infinite;
    infinite.kind = Kind::finite;
    infinite.languages = {language};
    check_by(methods_of_infinity(), task.part(infinite, false, proof));
}

namespace {

Finding check(const Certificate& certificate, const Entry& entry, const Budget& budget) {
    using Outcome = Finding::Outcome;
    Finding found;
    const bool refuted = entry.verdict == Entry::Verdict::refuted;
    found.statement = plain(statement_text(entry.statement, refuted, *certificate.alphabet));
    found.path = plain(entry.field.path());
    found.line = entry.field.line();
    if (entry.verdict == Entry::Verdict::undecided) return found;
    if (entry.verdict == Entry::Verdict::cited) {
        found.outcome = Outcome::cited;
        found.citation = plain(entry.citation);
        return found;
    }
    try {
        check_proof({certificate,
                     Reader(*certificate.alphabet, certificate.systems, certificate.rewritings),
                     budget, entry.statement, refuted == entry.statement.negated, *entry.proof});
        found.outcome = Outcome::checked;
    } catch (const Flaw& flaw) {
        found.outcome = Outcome::wrong;
        found.path = plain(flaw.path);
        found.line = flaw.line;
        found.reason = plain(flaw.reason);
    } catch (const BoundReached& bound) {
        found.outcome = Outcome::not_checked;
        found.reason = plain(bound.what());
    } catch (const std::bad_alloc&) {
        found.outcome = Outcome::not_checked;
        found.reason = "the machine has no more memory";
    } catch (const Error& error) {  // of a number, perhaps, which does not know where it stands
        if (std::string_view(error.what()).starts_with(certificate.file + ":")) throw;
        entry.field.fail(error.what());
    }
    return found;
}

/// One statement, which may be too much to read.
Finding read_and_check(const Certificate& certificate, const Field& field, const Budget& budget) {
    Finding unread;
    unread.outcome = Finding::Outcome::not_checked;
    unread.statement = unread.path = field.path();
    unread.line = field.line();
    unread.reason = "it takes more memory than is allowed to read it";
    if (field.kind() == JsonValue::Kind::too_large) return unread;
    const Reader reader(*certificate.alphabet, certificate.systems, certificate.rewritings);
    std::optional<Entry> entry;
    try {
        entry = read_entry(field, reader);
    } catch (const BoundReached& bound) {
        const std::string_view reason = bound.what(), path = unread.path;
        unread.reason = plain(reason.substr(reason.starts_with(path) ? path.size() + 1 : 0));
        return unread;
    } catch (const Flaw& flaw) {
        unread.outcome = Finding::Outcome::wrong;
        unread.path = plain(flaw.path);
        unread.line = flaw.line;
        unread.reason = plain(flaw.reason);
        return unread;
    }
    return check(certificate, *entry, budget);
}

}  // namespace

void check_certificate(const TextSource& text, const std::string& file, const Budget& budget,
                       const CertificateEvents& events) {
    Certificate certificate;
    certificate.file = file;
    bool has_begun = false;
    std::size_t index = 0;
    WorkCount statements("statement");
    const auto begin = [&](JsonValue header) {
        has_begun = true;
        read_header(certificate, std::move(header));
        if (events.on_start) events.on_start(certificate);
    };
    const auto each = [&](const JsonValue& value) {
        ++statements;
        const Field field(value, "statements[" + std::to_string(index++) + "]", certificate.file);
        if (events.on_statement && field.kind() != JsonValue::Kind::too_large)
            events.on_statement(field);
        const Finding found = read_and_check(certificate, field, budget);
        if (events.on_finding) events.on_finding(found);
    };
    Budget reading = budget;
    reading.deadline.reset();  // when the time is over, each statement that is left is not checked
    JsonValue whole = parse_json(text, file, reading, {"statements", begin, each});
    if (has_begun) return;
    begin(std::move(whole));
    Field(certificate.header, "", certificate.file).at("statements").list();
}

std::vector<Finding> check_certificate(const std::string& text, const std::string& file,
                                       const Budget& budget) {
    std::vector<Finding> all;
    check_certificate(source_of(text), file, budget,
                      {.on_finding = [&](const Finding& found) { all.push_back(found); }});
    return all;
}

std::string to_string(Finding::Outcome outcome) {
    static constexpr std::array names = {"checked", "cited: not checked", "undecided",
                                         "not checked", "WRONG"};
    return names.at(static_cast<std::size_t>(outcome));
}

}  // namespace algae::verify
