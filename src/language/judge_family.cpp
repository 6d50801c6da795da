#include "language/detail/judge.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "growth/growth.hpp"
#include "language/detail/finite_family.hpp"
#include "verify/verify.hpp"

// Whether a language is of a family: REG, CF, or a family of L-systems.
//
// That it is: it is given by a system of the form, equal to the language of a system of the claim, finite, or
// made by operations under which the family is closed. That it is not is decided for finite languages
// (finite_family.cpp), shown by the empty word for propagating families, and for REG and CF by the lengths of
// D0L languages that grow faster than linearly (`sparse`). Otherwise the statement is undecided.

namespace algae {

namespace {

using Json = nlohmann::ordered_json;
using Kind = LanguageTree::Kind;

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

class FamilyJudge {
public:
    FamilyJudge(const Language& language, const FamilyQuestion& question, const Alphabet& alphabet,
                const Budget& budget)
        : language_(language),
          question_(question),
          alphabet_(alphabet),
          budget_(budget),
          name_(to_string(language, alphabet)) {}

    Judgement judge() const {
        if (question_.family == "REG" || question_.family == "CF") return chomsky();
        const std::optional<SystemForm> form = system_form(question_.family);
        if (!form) throw Error(question_.family + " is no family of languages");
        if (language_->kind == Kind::generated && has_form(*language_->system, *form))
            return by_form();
        if (const auto known = finite_value(language_, alphabet_, budget_))
            return finite(*known, *form);
        if (form->propagating && !question_.empty_axiom && !form->interactive && !form->extended)
            if (auto found = has_empty_word()) return *found;
        if (auto found = by_system(*form)) return *found;
        if (language_->kind == Kind::reversed && !form->interactive)
            if (auto found = by_reversal()) return *found;
        if (form->extended)
            if (auto found = by_construction(*form)) return *found;
        return Judgement::undecided(
            {name_ + " was not found to be finite" +
             (question_.systems.empty()
                  ? ""
                  : ", and none of the systems of the claim was seen to generate it") +
             "; that no " + question_.family +
             " system does is decided for finite languages only"});
    }

private:
    Judgement by_form() const {
        return Judgement::proved(
            {name_ + " is given by " + with_article(question_.family) + " system."},
            {{"by", "form"}});
    }

    Judgement chomsky() const {
        if (const auto known = finite_value(language_, alphabet_, budget_)) {
            std::vector<std::string> argument = known->argument;
            argument.push_back(
                "It is finite, and finite languages are " +
                std::string(question_.family == "CF" ? "context-free." : "regular."));
            return Judgement::proved(std::move(argument), {{"by", "finite"}});
        }
        if (regular_value(language_, alphabet_, budget_))
            return Judgement::proved(
                {name_ +
                 " is made of finite languages by operations under which the regular languages are "
                 "closed" +
                 (question_.family == "CF" ? ", and regular languages are context-free." : ".")},
                {{"by", "regular"}});
        if (auto found = sparse()) return *found;
        return Judgement::undecided({"no regular expression for " + name_ + " is at hand"});
    }

    /// Words of a propagating system are at least as long as its axiom.
    std::optional<Judgement> has_empty_word() const {
        const Judgement found = judge_membership(language_, {}, alphabet_, budget_);
        if (found.truth != Truth::proved) return std::nullopt;
        Judgement result = Judgement::refuted(found.argument, {{"by", "empty word"}});
        result.argument.push_back(
            "A system without erasing rules derives no shorter word than its axiom, which is not "
            "empty; so " +
            name_ + " is not " + question_.family + ".");
        return result;
    }

    /// The lengths of a context-free language are, with finitely many exceptions, all numbers in some classes of
    /// numbers modulo some period (Parikh 1966), so of the numbers up to x infinitely often more than a fixed
    /// share. The lengths of a D0L language whose words grow faster than linearly are fewer.
    std::optional<Judgement> sparse() const {
        if (language_->kind != Kind::generated || !language_->system->tables) return std::nullopt;
        const ET0L& tables = *language_->system->tables;
        if (tables.tables.size() != 1 || !has_only_terminals(tables) || !is_deterministic(tables))
            return std::nullopt;
        const GrowthOrder order = growth_class(as_d0l(*language_->system), budget_).order;
        if (order.kind != GrowthKind::exponential &&
            (order.kind != GrowthKind::polynomial || order.degree < 2))
            return std::nullopt;
        const std::string family = question_.family == "REG" ? "regular" : "context-free";
        return Judgement::refuted(
            {"The lengths of the words of " + name_ + " grow like " + order.text() +
                 ", so they are infinitely many, and the share of them among the numbers up to x "
                 "tends to 0.",
             "The lengths of an infinite " + family +
                 " language have all numbers of some arithmetic progression among them (Parikh "
                 "1966), which is a share that does not tend to 0.",
             "So " + name_ + " is not " + family + "."},
            {{"by", "sparse"}});
    }

    Judgement finite(const FiniteValue& known, const SystemForm& form) const {
        const auto& all = all_families();
        const auto family = std::find_if(all.begin(), all.end(), [&](Family each) {
            return to_string(each) == question_.family;
        });
        if (family == all.end()) return all_finite(known, form);
        const FiniteLanguage words =
            make_finite_language(std::make_shared<const Alphabet>(alphabet_), known.words);
        FamilyOptions options;
        options.empty_axiom = question_.empty_axiom;
        const FamilyAnswer answer = decide_family(words, *family, options, budget_);
        std::vector<std::string> argument = known.argument;
        if (answer.truth == Truth::proved) {
            argument.push_back("The system with " + to_string(*answer.witness) + " generates it.");
            return Judgement::proved(std::move(argument),
                                     {{"by", "system"}, {"system", witness_json(*answer.witness)}});
        }
        if (answer.truth == Truth::undecided) return Judgement::undecided({answer.tried});
        for (std::string& line : lines_of(proof_text(*answer.obstruction)))
            argument.push_back(std::move(line));
        return Judgement::refuted(std::move(argument),
                                  {{"by", "cases"}, {"obstruction", to_json(*answer.obstruction)}});
    }

    Json witness_json(const FiniteWitness& witness) const {
        ET0L system{witness.alphabet,
                    witness.axiom,
                    witness.tables,
                    std::vector<char>(witness.alphabet->size(), 1),
                    {},
                    {}};
        for (Table& table : system.tables) {
            table.resize(witness.alphabet->size());
            for (Symbol a = 0; a < table.size(); ++a)
                if (table[a].empty()) table[a].push_back({a});
        }
        return to_json(system, alphabet_);
    }

    Judgement all_finite(const FiniteValue& known, const SystemForm& form) const {
        const bool every =
            (form.extended && !form.propagating && (!form.deterministic || form.tables)) ||
            (form.interactive && !form.one_sided && !form.context && !form.propagating);
        if (!every)
            return Judgement::undecided(
                {name_ + " is finite, and whether it is " + question_.family + " is not decided"});
        const bool has_axiom =
            question_.empty_axiom || std::any_of(known.words.begin(), known.words.end(),
                                                 [](const Word& word) { return !word.empty(); });
        if (form.interactive && !has_axiom)
            return Judgement::undecided({"no word of " + name_ + " can be the axiom"});
        std::vector<std::string> argument = known.argument;
        argument.push_back(
            form.interactive
                ? "It is finite: contexts longer than its words let each word be rewritten to the "
                  "next one."
                : "It is finite: a letter that is no terminal is rewritten to its words.");
        return Judgement::proved(std::move(argument), {{"by", "finite"}});
    }

    std::optional<Judgement> by_system(const SystemForm& form) const {
        for (const auto& system : question_.systems) {
            if (!has_form(*system, form)) continue;
            const Judgement equal =
                judge_equality(generated_language(system), language_, alphabet_, budget_);
            if (equal.truth != Truth::proved) continue;
            std::vector<std::string> argument{"The " + question_.family + " system " +
                                              system->name + " generates " + name_ + "."};
            argument.insert(argument.end(), equal.argument.begin(), equal.argument.end());
            return Judgement::proved(std::move(argument), {{"by", "equal"},
                                                           {"system", to_json(*system, alphabet_)},
                                                           {"proof", *equal.proof}});
        }
        return std::nullopt;
    }

    std::optional<Judgement> by_reversal() const {
        const Judgement part = judge_family(language_->parts[0], question_, alphabet_, budget_);
        if (part.truth == Truth::undecided) return std::nullopt;
        Judgement result = part;
        result.argument.push_back(
            "Axiom and successors written backwards generate the words backwards, so " + name_ +
            (part.truth == Truth::proved ? " is " + question_.family + " too."
                                         : " is not " + question_.family + " either."));
        result.proof =
            std::make_shared<const Json>(Json{{"by", "reversal"}, {"proof", *part.proof}});
        return result;
    }

    std::optional<Judgement> by_construction(const SystemForm& form) const {
        const auto tables = table_value(language_, alphabet_, budget_, form.deterministic);
        if (!tables || !has_form(SourceSystem{{}, tables->system, std::nullopt}, form))
            return std::nullopt;
        return Judgement::proved({tables->argument}, construction_proof(*tables));
    }

    const Language& language_;
    const FamilyQuestion& question_;
    const Alphabet& alphabet_;
    const Budget& budget_;
    std::string name_;
};

}  // namespace

Judgement judge_family(const Language& language, const FamilyQuestion& question,
                       const Alphabet& alphabet, const Budget& budget) {
    return FamilyJudge(language, question, alphabet, budget).judge();
}

}  // namespace algae
