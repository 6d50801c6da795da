#include <algorithm>
#include <map>

#include "language/detail/judge.hpp"
#include "language/detail/proof.hpp"

// What follows of given derivations, for all systems, words and numbers of steps: `for all 0L systems G and words x, y, z and
// numbers n, m with G : x ==> y in n steps and G : y ==> z in m steps: G : x ==> z in n + m steps`.
//
// A system without tables and contexts replaces letters independently, so (Rozenberg and Salomaa 1980, I.1)
//   product   x ==> y and u ==> v in n steps give xu ==> yv in n steps
//   chain     x ==> y in n steps and y ==> z in m steps give x ==> z in n + m steps
//   identity  x ==> x in 0 steps, and ε ==> ε in any number
//   cut       xu ==> z in n steps gives z = z1 z2 with x ==> z1 and u ==> z2 in n steps; where z is a word of letters, its cuts are
//             finitely many cases
//   length    if no rule erases, x ==> y gives |x| <= |y|
//   unique    if each letter has one rule, x ==> y and x ==> z in n steps give y = z
// A bound word or letter stands in words as a letter of its own. The search for a proof goes from the statement backwards and
// is bounded; how it was found does not matter for its check.

namespace algae {

namespace {

using Rule = steps::DerivationRule;
using Steps = std::map<std::string, std::int64_t>;

struct Given {
    Word from, to;
    Steps steps;
    Rule rule;  // how it is known
};

Steps sum(Steps left, const Steps& right, std::int64_t times) {
    for (const auto& [name, count] : right) left[name] += times * count;
    std::erase_if(left, [](const auto& one) { return one.second == 0; });
    return left;
}

/// The steps of a derivation; those of condition `index` have a name if it does not say how many. Nothing if the number is no
/// sum of multiples of bound numbers.
std::optional<Steps> steps_of(const Derives& said, std::size_t index) {
    Steps made;
    if (said.steps) {
        if (*said.steps > 1'000'000) return std::nullopt;
        if (*said.steps > 0) made["1"] = static_cast<std::int64_t>(*said.steps);
        return made;
    }
    if (!said.bound_steps) return Steps{{"#" + std::to_string(index), 1}};
    const auto counts = integral_slopes(*said.bound_steps);
    if (!counts) return std::nullopt;
    return *counts;
}

class Search {
public:
    Search(std::vector<Given> given, const Budget& budget)
        : given_(std::move(given)), budget_(budget) {}

    /// A proof of from ==> to in these steps.
    std::optional<Rule> prove(const Word& from, const Word& to, const Steps& steps,
                              std::size_t depth) {
        budget_.check();
        if (++tried_ > most_tried) return std::nullopt;
        if (from.empty()) {
            if (!to.empty()) return std::nullopt;
            return Rule{Rule::Kind::empty, 0, {}, steps, {}};
        }
        if (from == to && steps.empty()) return Rule{Rule::Kind::identity, 0, from, {}, {}};
        for (const Given& one : given_)
            if (one.from == from && one.to == to && one.steps == steps) return one.rule;
        if (depth == 0) return std::nullopt;
        for (std::size_t i = 1; i < from.size(); ++i)
            for (std::size_t j = 0; j <= to.size(); ++j) {
                const auto left = prove(begin(from, i), begin(to, j), steps, depth - 1);
                if (!left) continue;
                const auto right = prove(end(from, i), end(to, j), steps, depth - 1);
                if (right) return Rule{Rule::Kind::product, 0, {}, {}, {*left, *right}};
            }
        for (const Given& one : given_) {
            if (one.from != from) continue;
            const Steps rest = sum(steps, one.steps, -1);
            if (std::any_of(rest.begin(), rest.end(),
                            [](const auto& name) { return name.second < 0; }))
                continue;
            if (const auto more = prove(one.to, to, rest, depth - 1))
                return Rule{Rule::Kind::chain, 0, {}, {}, {one.rule, *more}};
        }
        return std::nullopt;
    }

    /// The same in some number of steps: one that the given derivations suggest.
    std::optional<Rule> prove_some(const Word& from, const Word& to) {
        std::vector<Steps> counts{{}};
        for (const Given& one : given_) counts.push_back(one.steps);
        for (const Given& one : given_)
            for (const Given& other : given_) counts.push_back(sum(one.steps, other.steps, 1));
        for (const Steps& steps : counts)
            if (auto found = prove(from, to, steps, deepest)) return found;
        return std::nullopt;
    }

    const std::vector<Given>& given() const { return given_; }
    static constexpr std::size_t deepest = 5;

private:
    static constexpr std::size_t most_tried = 20'000;

    static Word begin(const Word& word, std::size_t i) {
        return {word.begin(), word.begin() + static_cast<std::ptrdiff_t>(i)};
    }
    static Word end(const Word& word, std::size_t i) {
        return {word.begin() + static_cast<std::ptrdiff_t>(i), word.end()};
    }

    std::vector<Given> given_;
    const Budget& budget_;
    std::size_t tried_ = 0;
};

class DerivationsJudge {
public:
    DerivationsJudge(const Quantified& said, const Budget& budget) : said_(said), budget_(budget) {}

    std::optional<Answer> judge() {
        if (!gather()) return std::nullopt;
        const Statement& body = said_.body.front();
        if (body.negated) return std::nullopt;
        if (auto trees = shown(given_, body)) {
            proof_.cases = {std::move(*trees)};
            return proved(proof_);
        }
        for (std::size_t i = 0; i < given_.size(); ++i)
            if (by_cases(given_[i], body)) return proved(proof_);
        return std::nullopt;
    }

private:
    using Trees = std::vector<Rule>;

    /// The conditions that are derivations of one bound system without tables; false if there is none.
    bool gather() {
        if (!said_.universal) return false;
        for (std::size_t i = 0; i < said_.conditions.size(); ++i) {
            proof_.conditions.push_back(said_.conditions[i].text);
            const auto* one = std::get_if<Derives>(&said_.conditions[i].says);
            if (!one || said_.conditions[i].negated || !one->from || !one->system->variable)
                continue;
            const auto steps = steps_of(*one, i);
            if (!steps) continue;
            if (system_ && *system_ != *one->system->variable) return false;
            system_ = one->system->variable;
            given_.push_back({*one->from, one->word, *steps, {Rule::Kind::given, i, {}, {}, {}}});
        }
        if (!system_ || *system_ < said_.first) return false;
        const Domain& domain = said_.bindings.at(*system_ - said_.first).domain;
        propagating_ = domain.propagating;
        deterministic_ = domain.deterministic;
        return !domain.tables;
    }

    /// The trees that show the statement, if the derivations are given.
    std::optional<Trees> shown(const std::vector<Given>& given, const Statement& body) {
        Search search(given, budget_);
        if (const auto* goal = std::get_if<Derives>(&body.says)) {
            if (!goal->from || goal->system->variable != system_) return std::nullopt;
            proof_.shows = steps::ByDerivations::Shows::derivation;
            const bool any = !goal->steps && !goal->bound_steps;
            const auto steps = steps_of(*goal, 0);
            if (!any && !steps) return std::nullopt;
            auto tree = any ? search.prove_some(*goal->from, goal->word)
                            : search.prove(*goal->from, goal->word, *steps, Search::deepest);
            return tree ? std::optional(Trees{std::move(*tree)}) : std::nullopt;
        }
        if (const auto* goal = std::get_if<ComparesNumbers>(&body.says); goal && propagating_) {
            const bool turned = goal->comparison == Comparison::at_least;
            const auto from = word_of(turned ? goal->right : goal->left),
                       to = word_of(turned ? goal->left : goal->right);
            if ((!turned && goal->comparison != Comparison::at_most) || !from || !to)
                return std::nullopt;
            proof_.shows = steps::ByDerivations::Shows::length;
            auto tree = search.prove_some(*from, *to);
            return tree ? std::optional(Trees{std::move(*tree)}) : std::nullopt;
        }
        const auto* goal = std::get_if<EqualLanguages>(&body.says);
        if (!goal || !deterministic_) return std::nullopt;
        const auto one = only_word(goal->left), other = only_word(goal->right);
        if (!one || !other) return std::nullopt;
        proof_.shows = steps::ByDerivations::Shows::uniqueness;
        for (const Given& left : given)
            for (const Given& right : given)
                if (left.from == right.from && left.steps == right.steps && left.to == *one &&
                    right.to == *other)
                    return Trees{left.rule, right.rule};
        return std::nullopt;
    }

    static std::optional<Word> only_word(const Language& language) {
        if (language->kind != LanguageTree::Kind::words || language->words.size() != 1)
            return std::nullopt;
        return language->words.front();
    }

    /// The bound word of `length(x)`.
    std::optional<Word> word_of(const Expression& term) const {
        if (term.kind != Expression::Kind::call || term.operands.size() != 1) return std::nullopt;
        for (const QuantifiedName& name : said_.bindings)
            if (name.letter && name.name == term.operands[0].name) return Word{*name.letter};
        return std::nullopt;
    }

    bool is_letter(Symbol symbol) const {
        return std::none_of(
            said_.bindings.begin(), said_.bindings.end(), [&](const QuantifiedName& name) {
                return name.letter == symbol && name.domain.kind != Domain::Kind::letter;
            });
    }

    /// Whether the statement is shown in each way to cut the word that a condition derives.
    bool by_cases(const Given& cut, const Statement& body) {
        constexpr std::size_t most_symbols = 4, most_letters = 6;
        if (cut.from.size() < 2 || cut.from.size() > most_symbols || cut.to.size() > most_letters ||
            !std::all_of(cut.to.begin(), cut.to.end(), [&](Symbol a) { return is_letter(a); }))
            return false;
        proof_.split = cut.rule.index;
        proof_.cases.clear();
        std::vector<std::size_t> ends(cut.from.size(), 0);  // of what each symbol becomes
        ends.back() = cut.to.size();
        const auto choose = [&](const auto& self, std::size_t i) -> bool {
            if (i + 1 == cut.from.size()) {
                std::vector<Given> given = given_;
                for (std::size_t k = 0; k < cut.from.size(); ++k) {
                    const std::size_t begin = k == 0 ? 0 : ends[k - 1];
                    given.push_back({{cut.from[k]},
                                     Word(cut.to.begin() + static_cast<std::ptrdiff_t>(begin),
                                          cut.to.begin() + static_cast<std::ptrdiff_t>(ends[k])),
                                     cut.steps,
                                     {Rule::Kind::part, k, {}, {}, {}}});
                }
                auto trees = shown(given, body);
                if (trees) proof_.cases.push_back(std::move(*trees));
                return trees.has_value();
            }
            for (ends[i] = i == 0 ? 0 : ends[i - 1]; ends[i] <= cut.to.size(); ++ends[i])
                if (!self(self, i + 1)) return false;
            return true;
        };
        if (choose(choose, 0)) return true;
        proof_.split.reset();
        proof_.cases.clear();
        return false;
    }

    const Quantified& said_;
    const Budget& budget_;
    std::vector<Given> given_;
    std::optional<std::size_t> system_;  // the number of the bound name
    bool propagating_ = false, deterministic_ = false;
    steps::ByDerivations proof_;
};

}  // namespace

std::optional<Answer> judge_derivations(const Quantified& said, const Claim&,
                                        const Budget& budget) {
    return DerivationsJudge(said, budget).judge();
}

}  // namespace algae
