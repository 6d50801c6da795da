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
// A body of several statements joined by `and` is proved statement by statement.
//
// What none of this proves is left to the search for a counterexample.

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

}  // namespace

std::optional<Answer> judge_symbolic(const Quantified& said, const Claim& claim,
                                     const Budget& budget) {
    const Statement& body = said.body.front();
    if (!said.universal || body.negated) return std::nullopt;
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

}  // namespace algae
