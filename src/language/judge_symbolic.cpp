#include <algorithm>
#include <map>
#include <set>

#include "language/detail/judge.hpp"
#include "language/detail/proof.hpp"

// Statements about all languages that are proved without a look at any.
//
// Two methods. The first is for identities and inclusions made of union, concatenation, star, plus and reversal: a name
// stands for a letter. If the statement is true with different new letters in the place of the names, it is true of all
// languages, as a substitution of languages for letters commutes with union, concatenation and star. (For regular
// expressions this is the completeness of Kleene algebra: Kozen 1994.) Reversals are first moved inwards,
// (AB)^R = B^R A^R, until they stand at names; the reversal of a name is a letter of its own.
//
// The second is for `X is F`: X is a name that ranges over languages of F, or of a family whose systems all have the
// form of F, or over finite languages where F has all of these; or X is the reversal of such a language, since the axiom
// and the successors written backwards generate the words backwards.
//
// Two theorems on D0L systems: of lengths that grow faster than linearly, for languages that are not regular or context-free, and
// of words that begin the next ones, for infinite languages.
//
// A body of several statements joined by `and` is proved statement by statement.
//
// What none of this proves is left to the search for a counterexample.
//
// Derivations. What follows of given derivations, for all systems, words and numbers of steps: `for all 0L systems G and words x, y, z and
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

using Kind = LanguageTree::Kind;

// --- Names as letters ---

class LettersForNames {
public:
    LettersForNames(const Quantified& said, const Claim& claim) : claim_(claim) {
        for (std::size_t i = 0; i < said.bindings.size(); ++i)
            is_language_[said.first + i] = said.bindings[i].domain.kind == Domain::Kind::language;
    }

    /// The same statement with letters for names; nothing if another operation is used.
    std::optional<Statement> closed(const Statement& statement) {
        collect(statement);
        Statement made = statement;
        made.negated = false;
        if (auto* equal = std::get_if<EqualLanguages>(&made.says)) {
            if (!put(equal->left) || !put(equal->right)) return std::nullopt;
            return made;
        }
        if (auto* included = std::get_if<IncludedIn>(&made.says)) {
            if (!put(included->inner) || !put(included->outer)) return std::nullopt;
            return made;
        }
        return std::nullopt;
    }

    const std::map<std::string, Symbol>& letters() const { return letters_; }

private:
    void collect(const Statement& statement) {
        const auto in = [&](const Language& language) {
            for (const Symbol letter : letters_of(language)) named_.insert(letter);
        };
        if (const auto* equal = std::get_if<EqualLanguages>(&statement.says)) {
            in(equal->left);
            in(equal->right);
        }
        if (const auto* included = std::get_if<IncludedIn>(&statement.says)) {
            in(included->inner);
            in(included->outer);
        }
    }

    bool put(Language& language) {
        const Language made = closed(language, false);
        if (made) language = made;
        return made != nullptr;
    }

    Language closed(const Language& language, bool reversed) {
        const LanguageTree& tree = *language;
        switch (tree.kind) {
            case Kind::variable: {
                const auto known = is_language_.find(tree.variable->number);
                if (known == is_language_.end() || !known->second) return nullptr;
                const auto letter = letter_of(tree.variable->name + (reversed ? "^R" : ""));
                return letter ? words_language({{*letter}}) : nullptr;
            }
            case Kind::words: {
                std::vector<Word> words = tree.words;
                if (reversed)
                    for (Word& word : words) std::reverse(word.begin(), word.end());
                return words_language(std::move(words));
            }
            case Kind::reversed:
                return closed(tree.parts[0], !reversed);
            case Kind::united:
            case Kind::concatenated:
            case Kind::star:
            case Kind::plus: {
                std::vector<Language> parts;
                for (const Language& part : tree.parts) {
                    parts.push_back(closed(part, reversed));
                    if (!parts.back()) return nullptr;
                }
                if (reversed && tree.kind == Kind::concatenated)
                    std::reverse(parts.begin(), parts.end());
                return combined(tree.kind, std::move(parts));
            }
            default:
                return nullptr;
        }
    }

    std::optional<Symbol> letter_of(const std::string& name) {
        if (const auto found = letters_.find(name); found != letters_.end()) return found->second;
        for (const Symbol letter : claim_.instance_letters)
            if (named_.insert(letter).second) return letters_.emplace(name, letter).first->second;
        return std::nullopt;
    }

    const Claim& claim_;
    std::map<std::size_t, bool> is_language_;
    std::set<Symbol> named_;
    std::map<std::string, Symbol> letters_;
};

// --- Families ---

/// Whether every finite language is of the family.
bool has_all_finite(const std::string& family) {
    const auto form = system_form(family);
    if (!form) return family == "REG" || family == "CF";
    return form->extended && !form->propagating && (!form->deterministic || form->tables);
}

/// Whether a context-free grammar is a system of the family when each letter may also stay as it is.
bool has_grammars(const std::string& family) {
    const auto form = system_form(family);
    return form && form->extended && !form->propagating && !form->deterministic &&
           !form->interactive;
}

/// Whether every language of one family is of the other, by the form of their systems.
bool is_within(const std::string& family, const std::string& other) {
    if (family == other || (family == "REG" && other == "CF")) return true;
    if (family == "REG" || family == "CF") return has_grammars(other);
    const auto from = system_form(family), to = system_form(other);
    if (!from || !to || from->interactive || to->interactive) return false;
    return from->extended <= to->extended && from->tables <= to->tables &&
           from->propagating >= to->propagating && from->deterministic >= to->deterministic;
}

/// How it is known that an expression of names is of the family, as lines; nothing if it is not by these rules.
std::optional<std::vector<std::string>> by_rules(const Quantified& said, const Language& language,
                                                 const std::string& family,
                                                 const Alphabet& alphabet) {
    const LanguageTree& tree = *language;
    const std::string text = to_string(language, alphabet);
    if (tree.kind == Kind::reversed) {
        const auto form = system_form(family);
        if (form && form->interactive) return std::nullopt;
        auto lines = by_rules(said, tree.parts[0], family, alphabet);
        if (lines)
            lines->push_back(form ? "Axiom and successors written backwards generate the words "
                                    "backwards, so " +
                                        marked(text) + " is " + family + " too."
                                  : "Right sides written backwards generate the words backwards, "
                                    "so " +
                                        marked(text) + " is " + family + " too.");
        return lines;
    }
    if (tree.kind != Kind::variable || tree.variable->number < said.first) return std::nullopt;
    const std::size_t which = tree.variable->number - said.first;
    if (which >= said.bindings.size()) return std::nullopt;
    const QuantifiedName& name = said.bindings[which];
    if (name.text == "finite languages" && has_all_finite(family))
        return std::vector<std::string>{marked(text) + " is finite, and every finite language is " +
                                        family + "."};
    if (name.family.empty() || !is_within(name.family, family)) return std::nullopt;
    if (name.family == family)
        return std::vector<std::string>{marked(text) + " is " + family + "."};
    if (!system_form(name.family) && system_form(family))
        return std::vector<std::string>{
            marked(text) + " is " + name.family + ": it has a context-free grammar.",
            "With the rule A -> A for each letter A, the letters are rewritten one at a time or "
            "all "
            "at once, and the words are the same; so it is an " +
                family + " system."};
    return std::vector<std::string>{marked(text) + " is " + name.family + ", and every " +
                                    name.family + " system is an " + family + " system."};
}

// --- Systems whose languages are large ---

/// The bound name whose system generates the language: one of D0L systems; nothing otherwise.
const QuantifiedName* d0l_name(const Quantified& said, const Language& language) {
    if (language->kind != Kind::generated || !language->system->variable) return nullptr;
    const std::size_t number = *language->system->variable;
    if (number < said.first || number >= said.first + said.bindings.size()) return nullptr;
    const QuantifiedName& name = said.bindings[number - said.first];
    const bool is_d0l = name.domain.kind == Domain::Kind::system && name.domain.deterministic &&
                        !name.domain.tables;
    return is_d0l ? &name : nullptr;
}

/// Not L(G) is REG, or CF, where the lengths of G grow faster than linearly.
std::optional<Answer> judge_sparse(const Quantified& said, const InFamily& member) {
    const QuantifiedName* name = d0l_name(said, member.language);
    if (!name || (member.family != "REG" && member.family != "CF")) return std::nullopt;
    for (const Statement& condition : said.conditions) {
        const auto* growth = std::get_if<HasGrowthClass>(&condition.says);
        if (!growth || condition.negated ||
            growth->system->variable != member.language->system->variable)
            continue;
        if (growth->growth == "exponential" ||
            (growth->growth == "polynomial" && growth->degree && *growth->degree > Integer(1)))
            return proved(steps::AllSparse{name->name, member.family});
    }
    return std::nullopt;
}

/// Not L(G) is finite, where no rule of G erases and word(G, 1) begins with word(G, 0) and is another one.
std::optional<Answer> judge_longer(const Quantified& said, const IsFinite& finite) {
    const QuantifiedName* name = d0l_name(said, finite.language);
    if (!name || !name->domain.propagating) return std::nullopt;
    const auto is_generation = [&](const std::vector<WordFactor>& side, const Rational& number) {
        return side.size() == 1 && side[0].system && side[0].images.empty() && !side[0].reversed &&
               side[0].system->variable == finite.language->system->variable &&
               side[0].generation.kind == Expression::Kind::number &&
               side[0].generation.value == number;
    };
    bool begins = false, differs = false;
    for (const Statement& condition : said.conditions) {
        const auto* words = std::get_if<ComparesWords>(&condition.says);
        if (!words || condition.negated) continue;
        const bool in_order = is_generation(words->left, 1) && is_generation(words->right, 0);
        begins = begins || (in_order && words->kind == ComparesWords::Kind::begins);
        differs = differs ||
                  (words->kind == ComparesWords::Kind::unequal &&
                   (in_order || (is_generation(words->left, 0) && is_generation(words->right, 1))));
    }
    if (!begins || !differs) return std::nullopt;
    return proved(steps::AllLonger{name->name});
}

}  // namespace

std::optional<Answer> judge_symbolic(const Quantified& said, const Claim& claim,
                                     const Budget& budget) {
    const Statement& body = said.body.front();
    if (!said.universal) return std::nullopt;
    if (body.negated) {
        if (const auto* member = std::get_if<InFamily>(&body.says))
            return judge_sparse(said, *member);
        if (const auto* finite = std::get_if<IsFinite>(&body.says))
            return judge_longer(said, *finite);
        return std::nullopt;
    }
    if (const auto* member = std::get_if<InFamily>(&body.says)) {
        auto lines = by_rules(said, member->language, member->family, *claim.alphabet);
        if (!lines) return std::nullopt;
        return proved(steps::ByFamilyRules{std::move(*lines)});
    }
    LettersForNames letters(said, claim);
    const auto closed = letters.closed(body);
    if (!closed) return std::nullopt;
    const Answer found = decide_part(*closed, claim, budget, {});
    if (found.truth != Truth::proved) return std::nullopt;
    return proved(steps::ByLetters{letters.letters(), found.proof});
}

std::optional<Answer> judge_each(const Quantified& said, const Claim& claim, const Budget& budget) {
    const Statement& body = said.body.front();
    const auto* joint = std::get_if<Joint>(&body.says);
    if (!said.universal || body.negated || !joint || joint->kind != Joint::Kind::all)
        return std::nullopt;
    steps::ByEach each;
    for (const Statement& part : joint->parts) {
        Quantified one = said;
        one.body = {part};
        std::optional<Answer> found;
        for (const auto& method :
             {judge_all_numbers, judge_all_words, judge_symbolic, judge_derivations, judge_each})
            if (!found) found = method(one, claim, budget);
        if (!found || found->truth == Truth::undecided) return found;
        if (found->truth == Truth::refuted) {
            // By values of numbers, which refute the whole as well.
            std::map<std::string, Integer> point;
            for (const BoundValue& value : std::get<steps::ByInstance>(found->proof->step).values)
                point[value.name] = std::get<Integer>(value.is);
            return by_values(said, point, claim, budget);
        }
        each.texts.push_back(part.text);
        each.proofs.push_back(found->proof);
    }
    return proved(std::move(each));
}

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
