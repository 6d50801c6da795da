#include "lesson/mark.hpp"

#include <algorithm>
#include <optional>

#include "base/error.hpp"
#include "claim/decide.hpp"
#include "lesson/judge_own_statement.hpp"
#include "notation/characters.hpp"
#include "notation/claim_clauses.hpp"
#include "notation/findings.hpp"
#include "notation/read.hpp"
#include "system/et0l.hpp"
#include "system/il.hpp"
#include "system/s0l.hpp"

namespace algae {

namespace {

using Kind = Exercise::Kind;

/// The text without comments, its lines joined.
std::string without_comments(const std::string& text) {
    std::string plain;
    for (const ClaimClause& clause : claim_clauses(text))
        plain += (plain.empty() ? "" : " ") + std::string(clause.text);
    return plain;
}

/// The text with blanks for comments, so that what is left stands in its place.
std::string blank_comments(const std::string& text) {
    std::string blank(text.size(), ' ');
    for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] == '\n') blank[i] = '\n';
    for (const ClaimClause& clause : claim_clauses(text))
        clause.text.copy(blank.data() + (clause.text.data() - text.data()), clause.text.size());
    return blank;
}

/// The family by which a claim can take in any system that it can speak of.
std::string family(const LSystem& system) {
    if (as_et0l(system)) return "ET0L";
    if (as_il(system)) return "IL";
    if (as_s0l(system)) return "S0L";
    return "parametric";
}

/// An answer, and the demands on it as a claim.
class Marking {
public:
    Marking(const Exercise& exercise, const std::string& text, const std::string& name,
            const SystemSource& open, const Budget& budget)
        : exercise_(exercise), text_(text), name_(name), open_(open), budget_(budget) {
        if (exercise.kind == Kind::system) system_ = read_lsystem(text, name);
        if (exercise.kind == Kind::claim) read_own_claim();
        if (exercise.kind == Kind::word) expect_characters();
        if (exercise.kind == Kind::word && without_comments(text).empty())
            throw Error(name + ": expected a word (the empty word is ε), found nothing");
        if (exercise.kind == Kind::language) read_language(blank_comments(text), open, name);
    }

    /// What the answer claims itself must stand.
    void mark_own_claim(Mark& marked) {
        if (!own_) return;
        for (const ClaimedStatement& claimed : own_->statements) {
            const bool refutes = claimed.purpose == ClaimedStatement::Purpose::refute;
            Judgement judgement = decide(claimed.statement, *own_, budget_);
            if (refutes) judgement = opposite(std::move(judgement));
            marked.demands.push_back(
                {(refutes ? "your own: refute " : "your own: ") + claimed.statement.text, "",
                 std::move(judgement)});
        }
    }

    Judgement judge(const Demand& demand) {
        if (demand.own) return judge_own_statement(*demand.own, *system_, open_, budget_);
        const std::string before = definition() + "\n";
        const std::size_t line =
            static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')) +
            demand.place.line;
        const Claim claim = claim_up_to(line, before);
        for (const ClaimedStatement& claimed : claim.statements)
            if (claimed.statement.place.line == line)
                return decide(claimed.statement, claim, budget_);
        throw Error(to_string(demand.place) + ": expected a statement, found '" + demand.text +
                    "'");
    }

private:
    void expect_characters() const {
        const Source source(text_, name_);
        Findings(source).throw_if_no_text();
    }

    void read_own_claim() {
        own_text_ = text_;
        bool titled = false;
        for (const ClaimClause& clause : claim_clauses(text_))
            titled = titled || clause.keyword == "claim";
        if (!titled) own_text_ += "\nclaim answer";
        own_ = read_claim(own_text_, name_, open_);
        std::vector<std::string> defined;
        for (const auto& system : own_->systems) defined.push_back(system->name);
        for (const auto& system : own_->rewritings) defined.push_back(system->name);
        for (const auto& language : own_->languages) defined.push_back(language->name);
        for (const std::string& asked : exercise_.names)
            if (std::find(defined.begin(), defined.end(), asked) == defined.end())
                throw Error(name_ + ": expected a line 'let " + asked +
                            " = ...', a language or a system");
    }

    std::string definition() const {
        switch (exercise_.kind) {
            case Kind::system:
                return "claim answer; let answer = " + family(*system_) + " answer";
            case Kind::language:
                return "claim answer; let answer = " + without_comments(text_);
            case Kind::word:
                return "claim answer; let answer = {" + without_comments(text_) + "}";
            case Kind::claim:
                return own_text_;
        }
        return {};
    }

    /// The definition of the answer, and the exercise up to a line. What stands below may not make sense of
    /// every answer: a morphism has images of the right letters only.
    Claim claim_up_to(std::size_t line, const std::string& before) const {
        const std::string whole = before + exercise_.claim;
        std::size_t end = 0;
        for (std::size_t i = 0; i < line; ++i) end = whole.find('\n', end) + 1;
        const SystemSource open = [this](const std::string& name) {
            return name == "answer" && system_ ? *system_ : open_(name);
        };
        try {
            return read_claim(whole.substr(0, end), exercise_.file, open);
        } catch (const Diagnostics& error) {
            const Diagnostic& first = error.findings().front();
            const auto lines_before =
                static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
            const bool of_exercise = exercise_.lesson == 0 && first.place.line > lines_before;
            const std::string where =
                of_exercise ? to_string(Place{exercise_.file, first.place.line - lines_before,
                                              first.place.column}) +
                                  ": "
                            : "";
            throw Error(name_ + ": exercise " + exercise_.label() +
                        " cannot be decided of this answer: " + where + first.message);
        }
    }

    const Exercise& exercise_;
    const std::string& text_;
    const std::string& name_;
    const SystemSource& open_;
    const Budget& budget_;
    std::optional<LSystem> system_;
    std::string own_text_;
    std::optional<Claim> own_;
};

std::string verdict_word(Truth verdict) {
    return verdict == Truth::proved ? "right" : verdict == Truth::refuted ? "wrong" : "undecided";
}

}  // namespace

Mark mark(const Exercise& exercise, const std::string& text, const std::string& name,
          const SystemSource& open, const Budget& budget) {
    Marking marking(exercise, text, name, open, budget);
    Mark marked;
    marking.mark_own_claim(marked);
    const auto worst = [&] {
        for (const MarkedDemand& demand : marked.demands)
            if (demand.judgement.truth != Truth::proved) {
                marked.verdict = demand.judgement.truth;
                if (marked.verdict == Truth::refuted) return;
            }
    };
    worst();
    for (const Demand& demand : exercise.demands) {
        if (marked.verdict == Truth::refuted) break;
        try {
            marked.demands.push_back({demand.text, demand.hint, marking.judge(demand)});
        } catch (const BoundReached& error) {
            marked.demands.push_back(
                {demand.text, demand.hint, Judgement::undecided({error.what()})});
        }
        worst();
    }
    return marked;
}

std::string report(const Exercise& exercise, const Mark& mark) {
    std::string text = verdict_word(mark.verdict) + ": exercise " + exercise.label() + ", " +
                       exercise.title + "\n";
    for (const MarkedDemand& demand : mark.demands) {
        if (mark.verdict == Truth::refuted && demand.judgement.truth != Truth::refuted) continue;
        text += "  asked  " + demand.text + "\n";
        bool first = true;
        for (const std::string& line : demand.judgement.argument) {
            text += (first ? "  found  " : "         ") + line + "\n";
            first = false;
        }
        if (demand.judgement.truth == Truth::refuted && !demand.hint.empty())
            text += "  hint   " + demand.hint + "\n";
    }
    return text;
}

}  // namespace algae
