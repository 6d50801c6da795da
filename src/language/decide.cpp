#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <type_traits>

#include "exact/exact.hpp"
#include "language/detail/judge.hpp"
#include "language/detail/proof.hpp"
#include "watch/watch.hpp"

// From a claim to its verdicts: each statement goes to its judge, a bound that is reached
// leaves it undecided, and an error gets the place of the statement. What is undecided is tried again with facts: languages
// without systems that earlier statements were proved to equal, or that a system is found to generate.

namespace algae {

Answer opposite(Answer answer) {
    answer.truth = opposite(answer.truth);
    return answer;
}

namespace {

/// What a statement says, each form to its judge.
struct Judge {
    const Claim& claim;
    const Budget& budget;
    const SearchLimits& limits;
    const Alphabet& alphabet = *claim.alphabet;

    Answer operator()(const InFamily& said) const {
        return judge_family(said.language,
                            {said.family, claim.empty_axiom, claim.systems, !limits.is_instance},
                            alphabet, budget);
    }
    Answer operator()(const IsFinite& said) const {
        return judge_finite(said.language, alphabet, budget);
    }
    Answer operator()(const IsEmpty& said) const {
        return judge_empty(said.language, alphabet, budget);
    }
    Answer operator()(const EqualLanguages& said) const {
        return judge_equality(said.left, said.right, alphabet, budget);
    }
    Answer operator()(const IncludedIn& said) const {
        return judge_inclusion(said.inner, said.outer, alphabet, budget);
    }
    Answer operator()(const HasWord& said) const {
        return judge_membership(said.language, said.word, alphabet, budget);
    }
    Answer operator()(const HasSize& said) const {
        return judge_size(said.language, said.size, alphabet, budget);
    }
    Answer operator()(const IsCode& said) const {
        return judge_code(said.language, said.prefix, alphabet, budget);
    }
    Answer operator()(const IsPalindrome& said) const { return judge_palindrome(said.word); }
    Answer operator()(const Derives& said) const {
        return judge_derivation(said, alphabet, budget);
    }
    Answer operator()(const EqualSequences& said) const {
        return judge_sequences(*said.left, *said.right, budget);
    }
    Answer operator()(const EqualGrowth& said) const {
        return judge_growth(*said.left, *said.right, budget);
    }
    Answer operator()(const HasGrowthClass& said) const { return judge_growth_class(said, budget); }
    Answer operator()(const IsIncreasing& said) const { return judge_increasing(said, budget); }
    Answer operator()(const ComparesNumbers& said) const { return judge_numbers(said, budget); }
    Answer operator()(const ComparesWords& said) const {
        return judge_words(said, alphabet, budget);
    }
    Answer operator()(const Rewrites& said) const { return judge_rewriting(said, budget); }
    Answer operator()(const HasChance& said) const { return judge_chance(said, budget); }
    Answer operator()(const HasDimension& said) const { return judge_dimension(said, budget); }
    Answer operator()(const BoundaryHasDimension& said) const {
        return judge_boundary(said, budget);
    }
    Answer operator()(const HoldsInWord& said) const {
        return judge_infinite_word(said, alphabet, budget);
    }
    Answer operator()(const CountsInWord& said) const {
        return judge_counts(said, alphabet, budget);
    }
    Answer operator()(const HasCriticalExponent& said) const {
        return judge_critical_exponent(said, alphabet, budget);
    }
    Answer operator()(const IsCircular& said) const { return judge_circular(said, budget); }
    Answer operator()(const Joint& said) const { return judge_joint(said, claim, budget, limits); }
    Answer operator()(const Quantified& said) const {
        return judge_quantified(said, claim, budget, limits);
    }
};

using Facts = std::vector<steps::ByFacts::Fact>;

/// Calls `visit` with each language that the statement speaks of.
template <class AnyStatement, class Visit>
void visit_languages(AnyStatement& statement, Visit& visit) {
    std::visit(
        [&](auto& said) {
            if constexpr (requires { said.language; }) visit(said.language);
            if constexpr (std::is_same_v<std::decay_t<decltype(said)>, EqualLanguages>) {
                visit(said.left);
                visit(said.right);
            }
            if constexpr (requires { said.inner; }) {
                visit(said.inner);
                visit(said.outer);
            }
            if constexpr (std::is_same_v<std::decay_t<decltype(said)>, Joint>)
                for (auto& part : said.parts) visit_languages(part, visit);
        },
        statement.says);
}

/// A language with what facts say in the place of others; which facts were used.
class Replacement {
public:
    Replacement(const Facts& facts, const Alphabet& alphabet) : facts_(facts), alphabet_(alphabet) {
        for (const auto& fact : facts) texts_.push_back(to_json(fact.language, alphabet).dump());
    }

    Language replaced(const Language& language) {
        if (!has_system(language)) return language;
        const std::string text = to_json(language, alphabet_).dump();
        for (std::size_t i = 0; i < texts_.size(); ++i)
            if (texts_[i] == text) {
                used_.insert(i);
                return facts_[i].equal;
            }
        LanguageTree tree = *language;
        bool is_changed = false;
        for (Language& part : tree.parts) {
            const Language changed = replaced(part);
            is_changed = is_changed || changed != part;
            part = changed;
        }
        if (!is_changed) return language;
        tree.name.clear();  // it stood for the other expression
        return std::make_shared<const LanguageTree>(std::move(tree));
    }

    Facts used() const {
        Facts found;
        for (const std::size_t i : used_) found.push_back(facts_[i]);
        return found;
    }

private:
    const Facts& facts_;
    const Alphabet& alphabet_;
    std::vector<std::string> texts_;
    std::set<std::size_t> used_;
};

/// The languages of systems in an expression.
void add_generated(const Language& language, std::vector<Language>& all) {
    if (language->kind == LanguageTree::Kind::generated) all.push_back(language);
    for (const Language& part : language->parts) add_generated(part, all);
}

/// The answer to the statement with facts in it; nothing where none helps.
std::optional<Answer> by_facts(const Statement& statement, const Claim& claim, Facts facts,
                               const Budget& budget, const SearchLimits& limits) {
    std::vector<Language> generated;
    const auto add = [&](const Language& language) { add_generated(language, generated); };
    visit_languages(statement, add);
    std::set<const SourceSystem*> seen;
    for (const Language& each : generated) {
        if (each->system->variable || !seen.insert(each->system.get()).second) continue;
        for (const Language& form : likely_forms(each, budget)) {
            const Answer same = judge_equality(each, form, *claim.alphabet, budget);
            if (same.truth != Truth::proved) continue;
            facts.push_back({each, form, false, same.proof});
            break;
        }
    }
    Replacement replacement(facts, *claim.alphabet);
    Statement changed = statement;
    const auto replace = [&](Language& language) { language = replacement.replaced(language); };
    visit_languages(changed, replace);
    Facts used = replacement.used();
    if (used.empty()) return std::nullopt;
    const Answer found = std::visit(Judge{claim, budget, limits}, changed.says);
    if (found.truth == Truth::undecided) return std::nullopt;
    return Answer{found.truth, proof_by(steps::ByFacts{std::move(used), found.proof}), {}, {}};
}

/// What the equality says of languages with systems, if one side has none.
void add_fact(const Statement& statement, const Answer& answer, Facts& facts) {
    const auto* const said = std::get_if<EqualLanguages>(&statement.says);
    if (!said || statement.negated || answer.truth != Truth::proved) return;
    if (has_system(said->left) && !has_system(said->right))
        facts.push_back({said->left, said->right, false, answer.proof});
    else if (has_system(said->right) && !has_system(said->left))
        facts.push_back({said->right, said->left, true, answer.proof});
}

Answer decide(const Statement& statement, const Claim& claim, const Facts& facts,
              const Budget& budget, const SearchLimits& limits) {
    try {
        Answer found = std::visit(Judge{claim, budget, limits}, statement.says);
        if (found.truth == Truth::undecided && !found.out_of_time)
            if (auto better = by_facts(statement, claim, facts, budget, limits))
                found = *std::move(better);
        return statement.negated ? opposite(std::move(found)) : found;
    } catch (const BoundReached& error) {
        Answer found = undecided(error.what());
        found.out_of_time = error.bound() == Bound::time;
        return found;
    } catch (const Error& error) {
        const std::string what = error.what(), file = statement.place.file;
        if (statement.place.line == 0 || (!file.empty() && what.starts_with(file + ":"))) throw;
        throw Error(to_string(statement.place) + ": " + what);
    }
}

}  // namespace

//> decide
Answer decide(const Statement& statement, const Claim& claim, const Budget& budget,
              const SearchLimits& limits) {
    return decide(statement, claim, Facts(), budget, limits);
}
//< decide

Answer decide_part(const Statement& statement, const Claim& claim, const Budget& budget,
                   const SearchLimits& limits) {
    try {
        Answer found = std::visit(Judge{claim, budget, limits}, statement.says);
        if (found.out_of_time) throw BoundReached(Bound::time, found.tried.at(0));
        return statement.negated ? opposite(std::move(found)) : found;
    } catch (const BoundReached& error) {
        if (error.bound() == Bound::time) throw;
        return undecided(error.what());
    }
}

namespace {

using Outcome = CheckedStatement::Outcome;
using Purpose = ClaimedStatement::Purpose;

Outcome outcome(const ClaimedStatement& claimed, const Answer& answer) {
    if (answer.truth == Truth::undecided)
        return claimed.citation.empty() || answer.out_of_time ? Outcome::undecided : Outcome::cited;
    const Truth expected = claimed.purpose == Purpose::refute ? Truth::refuted : Truth::proved;
    return answer.truth == expected ? Outcome::holds : Outcome::fails;
}

}  // namespace

bool CheckedStatement::is_vacuous() const {
    return answer.searched && answer.searched->instances == 0 && answer.searched->undecided == 0 &&
           !answer.searched->witness && !answer.searched->finite_only;
}

std::optional<std::size_t> CheckedClaim::theorem() const {
    for (std::size_t i = 0; i < statements.size(); ++i)
        if (claim.statements[i].purpose == Purpose::theorem) return i;
    return std::nullopt;
}

std::pair<std::size_t, std::size_t> CheckedClaim::examples() const {
    std::pair<std::size_t, std::size_t> found;
    for (std::size_t i = 0; i < statements.size(); ++i) {
        if (claim.statements[i].purpose == Purpose::theorem) continue;
        ++found.second;
        if (statements[i].outcome == Outcome::holds) ++found.first;
    }
    return found;
}

CheckedStatement::Outcome CheckedClaim::worst() const {
    Outcome worst = Outcome::holds;
    for (const CheckedStatement& statement : statements) worst = std::max(worst, statement.outcome);
    return worst;
}

ClaimVerdict CheckedClaim::verdict() const {
    if (worst() == Outcome::fails) return ClaimVerdict::refuted;
    const std::optional<std::size_t> which = theorem();
    const Outcome decisive = which ? statements[*which].outcome : worst();
    if (decisive == Outcome::cited) return ClaimVerdict::cited;
    if (which && decisive == Outcome::formally) return ClaimVerdict::formally;
    if (which && statements[*which].is_vacuous()) return ClaimVerdict::vacuous;
    if (decisive == Outcome::undecided) return ClaimVerdict::undecided;
    return which ? ClaimVerdict::proved : ClaimVerdict::examples;
}

CheckedClaim check(Claim claim, const Budget& budget, const SearchLimits& limits) {
    CheckedClaim checked;
    Facts facts;
    WorkCount statements("statement", claim.statements.size());
    for (const ClaimedStatement& claimed : claim.statements) {
        ++statements;
        CheckedStatement found;
        try {
            found.answer = decide(claimed.statement, claim, facts, budget, limits);
            add_fact(claimed.statement, found.answer, facts);
        } catch (const Error& error) {  // the other statements are decided all the same
            found.answer = undecided(error.what());
        }
        found.outcome = outcome(claimed, found.answer);
        checked.statements.push_back(std::move(found));
    }
    checked.claim = std::move(claim);
    return checked;
}

std::string_view to_string(ClaimVerdict verdict) {
    static constexpr std::string_view names[] = {"proved",  "proved formally", "examples", "cited",
                                                 "vacuous", "undecided",       "refuted"};
    return names[static_cast<std::size_t>(verdict)];
}

std::string verdict_text(const CheckedStatement& checked) {
    if (checked.outcome == Outcome::cited) return "cited";
    if (checked.outcome == Outcome::formally) return "proved formally";
    if (checked.is_vacuous()) return "vacuous";
    return std::string(to_string(checked.answer.truth));
}

}  // namespace algae
