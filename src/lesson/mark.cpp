#include <algorithm>
#include <optional>
#include <set>
#include <variant>

#include "exact/exact.hpp"
#include "language/language.hpp"
#include "lesson/lesson.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "system/system.hpp"
#include "turtle/turtle.hpp"

// How an answer is marked: the demands of an exercise are decided of it, one after the other, as claims are.
//
// The answer becomes a definition of `answer` above the claim that the exercise makes: a system as the smallest of the
// families ET0L, IL, S0L and parametric that takes it in, a language and a word as an expression, a claim as it stands. A
// claim of the learner's own is judged first: what it shows must stand. Then each demand is read and decided with the lines above it
// only, because lines below need not make sense of every answer. The first refuted demand ends the marking; a bound that
// is reached makes its demand undecided, and the next one is looked at.
//
// Statements of exercises' own are judged here: forms by the classes of systems, counts by counting, and figures by comparing outlines
// (similar, congruent, or in the same place), exactly where the coordinates are exact.

namespace algae {

namespace {

Judgement found(bool holds, std::string sentence) {
    Judgement judgement;
    judgement.truth = holds ? Truth::proved : Truth::refuted;
    judgement.argument.push_back(std::move(sentence));
    return judgement;
}

/// Judges a statement of an exercise's own of the answer: refuted with what the answer has instead. Throws what
/// `open` and `outline` throw.
struct OwnJudge {
    const Model& answer;
    const SystemSource& open;
    const Budget& budget;

    Judgement operator()(const AnswerIs& asked) const;
    Judgement operator()(const AnswerHas& asked) const;
    Judgement operator()(const FiguresAre& asked) const;
};

Judgement OwnJudge::operator()(const AnswerIs& asked) const {
    const auto form = system_form(asked.form);
    const std::string reason = form ? misfit(answer, *form) : misfit(answer, asked.form);
    const std::string is = class_of(answer).name();
    return found(reason.empty(),
                 reason.empty() ? "Your system is " + with_article(is) + " system."
                                : "Your system is no " + asked.form + " system: " + reason + ".");
}

/// The symbols that stand in the axiom or a rule.
std::size_t letters(const LSystem& system) {
    std::set<Symbol> all(system.axiom.letters.begin(), system.axiom.letters.end());
    for (const Production& rule : system.rules) {
        all.insert(rule.predecessor.symbol);
        all.insert(rule.successor.letters.begin(), rule.successor.letters.end());
    }
    return all.size();
}

std::size_t count_of(AnswerHas::Counted counted, const LSystem& system) {
    switch (counted) {
        case AnswerHas::Counted::rules:
            return system.rules.size();
        case AnswerHas::Counted::letters:
            return letters(system);
        case AnswerHas::Counted::axiom_symbols:
            return system.axiom.letters.size();
    }
    return 0;
}

Judgement OwnJudge::operator()(const AnswerHas& asked) const {
    const std::size_t count = count_of(asked.counted, answer);
    const bool of_axiom = asked.counted == AnswerHas::Counted::axiom_symbols;
    const std::string singular = of_axiom                                       ? "symbol"
                                 : asked.counted == AnswerHas::Counted::letters ? "letter"
                                                                                : "rule";
    return found(asked.at_most ? count <= asked.count : count == asked.count,
                 (of_axiom ? "The axiom of your system has " : "Your system has ") +
                     counted(count, singular) + ".");
}

struct NamedFigure {
    std::string name;
    Outline outline;
};

NamedFigure named_figure(const FiguresAre::Figure& figure, const Model& answer,
                         const SystemSource& open, const Budget& budget) {
    const std::uint64_t n = figure.generation;
    const std::string generation = "generation " + std::to_string(n) + " of ";
    if (figure.system == "answer") return {generation + "your system", outline(answer, n, budget)};
    return {generation + figure.system, outline(open(figure.system), n, budget)};
}

std::string all_of(std::size_t count, const std::string& noun) {
    return count == 1 ? "the only " + noun : "each of " + counted(count, noun);
}

/// "Each of 3 strokes and the only filled polygon", without what there is none of.
std::string all_parts(const Outline& outline) {
    std::string text = all_of(outline.strokes.size(), "stroke");
    if (!outline.polygons.empty())
        text = (outline.strokes.empty() ? "" : text + " and ") +
               all_of(outline.polygons.size(), "filled polygon");
    text.front() = text.front() == 'e' ? 'E' : 'T';
    return text;
}

Judgement OwnJudge::operator()(const FiguresAre& asked) const {
    using Relation = FiguresAre::Relation;
    const Relation relation = asked.relation;
    const NamedFigure left = named_figure(asked.left, answer, open, budget);
    const NamedFigure right = named_figure(asked.right, answer, open, budget);
    const Similarity compared = similarity(left.outline, left.name, right.outline, right.name);
    if (!compared.similar) return found(false, compared.difference);
    if (relation != Relation::similar && !compared.same_size)
        return found(false, "The figures have the same form, but not the same size.");
    if (relation == Relation::same && !compared.same_place)
        return found(false,
                     "The figures have the same form and size, but do not lie in the same place.");
    const bool exact = compared.exact && relation != Relation::same;
    return found(true, all_parts(left.outline) + " comes to lie on one of the other figure" +
                           (exact ? ", exactly." : ", as far as rounded numbers show."));
}

using Kind = Exercise::Kind;

/// The text without comments, its lines joined.
std::string without_comments(const std::string& text) {
    return joined(claim_clauses(text), " ", &ClaimClause::text);
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
            Judgement judgement =
                in_sentences(decide(claimed.statement, *own_, budget_), *own_->alphabet);
            if (refutes) judgement.truth = opposite(judgement.truth);
            marked.demands.push_back(
                {(refutes ? "your own: refute " : "your own: ") + claimed.statement.text, "",
                 std::move(judgement)});
        }
    }

    Judgement judge(const Demand& demand) {
        if (demand.own) return std::visit(OwnJudge{*system_, open_, budget_}, *demand.own);
        const std::string before = definition() + "\n";
        const std::size_t line =
            static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')) +
            demand.place.line;
        const Claim claim = claim_up_to(line, before);
        for (const ClaimedStatement& claimed : claim.statements)
            if (claimed.statement.place.line == line)
                return in_sentences(decide(claimed.statement, claim, budget_), *claim.alphabet);
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
    std::optional<Model> system_;
    std::string own_text_;
    std::optional<Claim> own_;
};

std::string verdict_word(Truth verdict) {
    return verdict == Truth::proved ? "right" : verdict == Truth::refuted ? "wrong" : "undecided";
}

}  // namespace

Mark mark(const Exercise& exercise, const std::string& text, const std::string& name,
          const SystemSource& open, const Budget& budget, Demands looked_at) {
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
        const bool is_refuted = marked.verdict == Truth::refuted;
        if (is_refuted && looked_at == Demands::to_first_refuted) break;
        try {
            marked.demands.push_back({demand.text, demand.hint, marking.judge(demand)});
        } catch (const BoundReached& error) {
            marked.demands.push_back(
                {demand.text, demand.hint, Judgement{Truth::undecided, {error.what()}}});
        } catch (const Error& error) {
            // The demands above say what is wrong; this one need not make sense of such an answer.
            if (!is_refuted) throw;
            marked.demands.push_back(
                {demand.text, demand.hint, Judgement{Truth::undecided, {error.what()}}});
        }
        worst();
    }
    return marked;
}

std::size_t points(const Exercise& exercise, const Mark& mark) {
    const std::size_t own =
        mark.demands.size() - std::min(mark.demands.size(), exercise.demands.size());
    std::size_t proved = 0;
    for (std::size_t i = own; i < mark.demands.size(); ++i)
        if (mark.demands[i].judgement.truth == Truth::proved) ++proved;
    return proved;
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
