#include <algorithm>
#include <array>
#include <set>

#include "exact/exact.hpp"
#include "verify/detail/checking.hpp"
#include "verify/detail/languages.hpp"

// Statements about the size of languages and about pairs of languages: infinite, finite, empty, equal, included.
//
// That L(G) is infinite is shown by courses of single letters (of systems with tables: five courses that go by the same tables), or by
// a cycle of letters that adds one that lasts. An inclusion is shown by derivatives, by relations of an automaton, by induction on the
// length, or word by word where one side is finite.

namespace algae::verify {

namespace {

using Kind = Statement::Kind;
using Letters = std::set<Symbol>;

/// One step of one letter.
struct Step {
    std::uint64_t table = 0;
    Symbol letter = 0;
    Word successor;
    std::uint64_t place = 0;
    Field field;
};
using Course = std::vector<Step>;

bool within(const Word& word, const Letters& letters) {
    return std::all_of(word.begin(), word.end(), [&](Symbol a) { return letters.contains(a); });
}

class Courses {
public:
    Courses(const Obligation& task, const System& system)
        : task_(task), system_(system), proof_(task.proof) {}

    void check() {
        const Symbol again = task_.letter("again");
        const Symbol other = task_.letter("other");
        const Course before = course("before"), round = course("round"), beside = course("beside"),
                     kept = course("kept"), after = course("after");
        Letters terminals;
        for (Symbol a = 0; a < system_.terminal.size(); ++a)
            if (system_.terminal[a]) terminals.insert(a);
        const auto finish_after = finishing(after, terminals);
        const Letters& finish = finish_after.front();
        const auto finish_round = finishing(round, finish);
        const auto finish_before = finishing(before, finish);
        if (!std::includes(finish_round.front().begin(), finish_round.front().end(), finish.begin(),
                           finish.end()))
            proof_.at("round").refuse("a letter that can finish cannot finish with one more round");
        if (round.empty()) proof_.at("round").refuse("a round must have a step");
        if (!within(system_.axiom, finish_before.front()))
            proof_.at("before").refuse("a letter of the axiom cannot finish");
        const Symbol start = before.empty() ? again : before.front().letter;
        if (!std::count(system_.axiom.begin(), system_.axiom.end(), start))
            proof_.at("before").refuse("it does not begin in the axiom");
        follow("before", before, start, again, finish_before);
        follow("round", round, again, again, finish_round);
        same_tables("beside", beside, round);
        follow("beside", beside, again, other, finish_round);
        must_branch(round, beside);
        same_tables("kept", kept, round);
        follow("kept", kept, other, other, finish_round);
        const Symbol last =
            after.empty() ? other
                          : after.back().successor.at(static_cast<std::size_t>(after.back().place));
        if (!terminals.contains(last)) proof_.at("after").refuse("it does not end with a terminal");
        follow("after", after, other, last, finish_after);
    }

private:
    Course course(const char* name) const {
        Course steps;
        for (const Field& field : proof_.at(name).list()) {
            field.only({"table", "letter", "successor", "place"});
            Step step{field.at("table").number(), task_.reader.letter(field.at("letter")),
                      task_.reader.word(field.at("successor")), field.at("place").number(), field};
            if (step.table >= system_.tables.size())
                field.at("table").refuse("there is no such table");
            const auto& all = system_.tables[static_cast<std::size_t>(step.table)][step.letter];
            if (!std::count(all.begin(), all.end(), step.successor))
                field.at("successor").refuse("the table has no such rule");
            if (step.place >= step.successor.size())
                field.at("place").refuse("the successor is not so long");
            steps.push_back(std::move(step));
        }
        return steps;
    }

    /// The letters that can be in `last` entirely after the rest of the course, before each step and at its end.
    std::vector<Letters> finishing(const Course& steps, const Letters& last) const {
        std::vector<Letters> all{last};
        for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
            Letters earlier;
            const auto& table = system_.tables[static_cast<std::size_t>(step->table)];
            for (Symbol a = 0; a < table.size(); ++a)
                if (std::any_of(table[a].begin(), table[a].end(),
                                [&](const Word& word) { return within(word, all.back()); }))
                    earlier.insert(a);
            all.push_back(std::move(earlier));
        }
        std::reverse(all.begin(), all.end());
        return all;
    }

    void follow(const char* name, const Course& steps, Symbol from, Symbol to,
                const std::vector<Letters>& finish) const {
        for (std::size_t i = 0; i < steps.size(); ++i) {
            if (steps[i].letter != from)
                steps[i].field.refuse("it is not a step of the letter before");
            if (!within(steps[i].successor, finish[i + 1]))
                steps[i].field.refuse("a letter of the successor cannot finish");
            from = steps[i].successor[static_cast<std::size_t>(steps[i].place)];
        }
        if (from != to) proof_.at(name).refuse("it ends with another letter");
    }

    void same_tables(const char* name, const Course& steps, const Course& round) const {
        if (!std::equal(
                steps.begin(), steps.end(), round.begin(), round.end(),
                [](const Step& one, const Step& other) { return one.table == other.table; }))
            proof_.at(name).refuse("its tables are not those of the round");
    }

    void must_branch(const Course& round, const Course& beside) const {
        for (std::size_t i = 0; i < round.size(); ++i) {
            if (round[i].letter != beside[i].letter || round[i].successor != beside[i].successor)
                beside[i].field.refuse("it parts from the round by more than the place");
            if (round[i].place != beside[i].place) return;
        }
        proof_.at("beside").refuse("it does not part from the round");
    }

    const Obligation& task_;
    const System& system_;
    const Field& proof_;
};

}  // namespace

/// Checks that L(G) is infinite by five courses of steps, each of one letter by a table: `before` leads from a
/// letter of the axiom to the letter `again`; `round` from there to itself, and `beside`, which is the same step
/// as `round` at some point but for the place, by the same tables to `other`; `kept` by the same tables from
/// `other` to itself; `after` from `other` to a terminal. All letters beside them can finish: derive words
/// of terminals by the tables that follow. So n rounds give a word of L(G) with n letters and more.
void check_endless_tables(const Obligation& task) {
    const Language& language = task.language();
    if (language->kind != Tree::Kind::generated || language->system->context)
        task.refuse("the language is not given by a system without context");
    Courses(task, *language->system).check();
}

namespace {

struct RoundRule {
    Symbol letter = 0;
    Word successor;
};

}  // namespace

/// Each rule of the round has the letter of the next one, the last has that of the first; the first has
/// another letter besides that lasts. So there are words with any number of lasting letters.
void check_endless_round(const Obligation& task) {
    const Language& language = task.language();
    if (language->kind != Tree::Kind::generated)
        task.refuse("the language is not given by a system");
    const System& system = *language->system;
    if (system.context || system.tables.size() != 1 || !has_only_terminals(system))
        task.refuse("the system is not 0L");
    const auto& table = system.tables.front();
    std::vector<RoundRule> rules;
    for (const Field& field : task.proof.at("rules").list()) {
        field.only({"letter", "successor"});
        const RoundRule rule{task.reader.letter(field.at("letter")),
                             task.reader.word(field.at("successor"))};
        const auto& all = table[rule.letter];
        if (!std::count(all.begin(), all.end(), rule.successor))
            field.refuse("the system has no such rule");
        rules.push_back(rule);
    }
    if (rules.empty()) task.proof.at("rules").refuse("a round must have a rule");
    const auto letters = accessible_letters(system, system.axiom);
    if (!std::count(letters.begin(), letters.end(), rules[0].letter))
        task.proof.at("rules").refuse("the letter of the first rule occurs in no derived word");
    for (std::size_t i = 0; i < rules.size(); ++i) {
        const Symbol next = rules[(i + 1) % rules.size()].letter;
        if (std::count(rules[i].successor.begin(), rules[i].successor.end(), next) == 0)
            task.proof.at("rules").list()[i].refuse(
                "the letter of the next rule is not in its successor");
    }
    const Symbol other = task.letter("other");
    const Symbol next = rules[1 % rules.size()].letter;
    const Word& first = rules[0].successor;
    if (std::count(first.begin(), first.end(), other) < (other == next ? 2 : 1))
        task.proof.at("other").refuse(
            "the first rule has no such letter besides that of the next rule");
    if (!lasting_letters(table).contains(other))
        task.proof.at("other").refuse("the letter is gone after some steps, whatever it becomes");
}

void check_pumping(const Obligation& task) {
    check_regular(task, task.language());
    const Word prefix = task.word("prefix");
    const Word middle = task.word("middle");
    const Word suffix = task.word("suffix");
    if (middle.empty()) task.proof.at("middle").refuse("nothing is repeated");
    Derivatives derivatives(task.alphabet(), task.budget);
    const auto before = derivatives.derivative(derivatives.term(task.language()), prefix);
    if (!derivatives.equal(before, derivatives.derivative(before, middle)))
        task.proof.at("middle").refuse("what may follow is not the same before and after it");
    if (!derivatives.nullable(derivatives.derivative(before, suffix)))
        task.proof.at("suffix").refuse("the word is not in the language");
}

namespace {

/// Throws Flaw if no word is known to be in the language.
void check_has_word(const Obligation& task, const Language& language) {
    try {
        if (!within_regular(language, words_of({}), task.alphabet(), task.budget)) return;
    } catch (const Error& error) {
        throw BoundReached(Bound::method,
                           std::string("whether the other part has a word: ") + error.what());
    }
    task.refuse("the other part has no word");
}

/// Throws Flaw if a word of the left language is not in the right one, a regular expression.
void check_within(const Obligation& task, const Language& left, const Language& right,
                  const char* otherwise) {
    try {
        if (within_regular(left, right, task.alphabet(), task.budget)) return;
    } catch (const Error& error) {
        throw BoundReached(Bound::method, error.what());
    }
    task.refuse(otherwise);
}

}  // namespace

void check_part(const Obligation& task) {
    const Tree& whole = *task.language();
    const Field field = task.proof.at("index");
    const std::uint64_t number = field.number();
    using enum Tree::Kind;
    constexpr std::array kinds = {united, concatenation, star, plus, reversal};
    if (!std::count(kinds.begin(), kinds.end(), whole.kind))
        task.refuse("an infinite part does not make this infinite");
    if (number >= whole.parts.size()) field.refuse("there is no such part");
    const auto index = static_cast<std::size_t>(number);
    if (whole.kind == concatenation) check_has_word(task, whole.parts[1 - index]);
    check_infinite(task, whole.parts[index], task.proof.at("proof"));
}

void check_infinite_part(const Obligation& task) {
    check_infinite(task, task.language(), task.proof.at("proof"));
}

void check_size_of_values(const Obligation& task) {
    const auto words = task.values(task.language());
    const bool found = words && (task.statement.kind == Kind::finite ||
                                 words->size() == task.statement.size.value_or(0));
    if (found != task.holds)
        task.refuse(words ? "the language has " + std::to_string(words->size()) + " words"
                          : "the language is infinite");
}

void check_no_word(const Obligation& task) {
    check_within(task, task.language(), words_of({}), "the language has a word");
}

void check_a_word(const Obligation& task) {
    if (!task.contains(task.language(), task.word("word")))
        task.proof.at("word").refuse("the word is not in the language");
}

namespace {

void compare_values(const Obligation& task) {
    const auto left = task.values(task.language());
    if (task.statement.kind == Kind::included && task.holds) {
        if (!left) task.refuse("the left language is infinite");
        for (const Word& word : *left)
            if (!task.contains(task.language(1), word))
                task.refuse("a word is in the left language only");
        return;
    }
    const auto right = task.values(task.language(1));
    if (!left || !right) task.refuse("one of the languages is infinite");
    const bool found =
        task.statement.kind == Kind::equal
            ? *left == *right
            : std::includes(right->begin(), right->end(), left->begin(), left->end());
    if (found != task.holds)
        task.refuse(found ? "every word is in both languages" : "a word is in one language only");
}

/// Whether a language lies within a finite one, as far as its expression tells: an intersection does if one of its parts does.
bool is_within(const Obligation& task, const Language& language, const Language& finite) {
    try {
        return within_regular(language, finite, task.alphabet(), task.budget);
    } catch (const Error& error) {
        if (language->kind != Tree::Kind::intersection)
            throw BoundReached(Bound::method, error.what());
        return is_within(task, language->parts[0], finite) ||
               is_within(task, language->parts[1], finite);
    }
}

}  // namespace

void check_values(const Obligation& task) {
    try {
        return compare_values(task);
    } catch (const BoundReached& bound) {
        if (bound.bound() == Bound::time || task.statement.kind != Kind::equal || !task.holds)
            throw;
    }
    // A part of one side may have words without end: then the words of the other side are in it, and it lies within them.
    const bool is_left_finite = task.language()->kind == Tree::Kind::words;
    const Language& finite = task.language(is_left_finite ? 0 : 1);
    const Language& other = task.language(is_left_finite ? 1 : 0);
    const auto words = task.values(finite);
    if (!words) task.refuse("one of the languages is infinite");
    for (const Word& word : *words)
        if (!task.contains(other, word)) task.refuse("a word is in one language only");
    if (!is_within(task, other, words_of({words->begin(), words->end()})))
        throw BoundReached(Bound::method, "whether there are other words is not worked out");
}

void check_derivatives(const Obligation& task) {
    Derivatives derivatives(task.alphabet(), task.budget);
    const auto left = derivatives.term(task.language());
    const auto right = derivatives.term(task.language(1));
    if (!derivatives.included(left, right)) task.refuse("a word is in the left language only");
    if (task.statement.kind == Kind::equal && !derivatives.included(right, left))
        task.refuse("a word is in the right language only");
}

void check_word_in_one(const Obligation& task) {
    const Field field = task.proof.at("word");
    const Word word = task.reader.word(field);
    const auto in = [&](const Language& language) { return task.contains(language, word); };
    const bool left = in(task.language()), right = in(task.language(1));
    if (left == right)
        field.refuse(left ? "the word is in both languages" : "the word is in neither language");
    if (task.statement.kind == Kind::included && right)
        field.refuse("the word is in the right language only");
}

/// The sequences of the two systems are equal, so their languages are.
void check_same_sequences(const Obligation& task) {
    Statement sequences;
    sequences.kind = Kind::equal_sequences;
    for (const Language& language : task.statement.languages) {
        if (language->kind != Tree::Kind::generated)
            task.refuse("a language is not given by a system");
        sequences.systems.push_back({language->name, language->system});
    }
    check_proof(task.part(sequences, true, task.proof.at("proof")));
}

void check_both(const Obligation& task) {
    const auto [one, other] = task.proof.at("proofs").pair();
    Statement included;
    included.kind = Kind::included;
    included.languages = task.statement.languages;
    check_proof(task.part(included, true, one));
    std::swap(included.languages[0], included.languages[1]);
    check_proof(task.part(included, true, other));
}

void check_relations(const Obligation& task) {
    check_within(task, task.language(), task.language(1),
                 "a word of the left language is not in the right one");
}

void check_identical(const Obligation& task) {
    if (!same(task.language(), task.language(1))) task.refuse("the expressions are not the same");
}

namespace {

/// The words that come in one step by a table from words of the language with fewer counted letters: of words over new letters,
/// one for each rule that loses none of them, that spell a word of the language.
Language longer_words(const System::Successors& table, const std::vector<char>& counted,
                      const Language& language) {
    const auto weight = [&](const Word& word) {
        return std::count_if(word.begin(), word.end(), [&](Symbol a) { return counted[a] != 0; });
    };
    std::map<Symbol, Word> predecessors, successors;
    std::vector<Word> rules, longer;
    auto rule = static_cast<Symbol>(table.size());
    for (Symbol a = 0; a < table.size(); ++a)
        for (const Word& word : table[a]) {
            if (weight(word) < weight({a})) continue;
            predecessors[rule] = {a};
            successors[rule] = word;
            rules.push_back({rule});
            if (weight(word) > weight({a})) longer.push_back({rule});
            ++rule;
        }
    const Language any = combination(Tree::Kind::star, {words_of(std::move(rules))});
    const Language one_longer = combination(
        Tree::Kind::concatenation,
        {any, combination(Tree::Kind::concatenation, {words_of(std::move(longer)), any})});
    const Language uses = combination(
        Tree::Kind::intersection,
        {combination(Tree::Kind::inverse_image, {language}, std::move(predecessors)), one_longer});
    return combination(Tree::Kind::image, {uses}, std::move(successors));
}

}  // namespace

/// That whatever the left system does in a step the right one may do, and that it comes to where the left one begins.
void check_rules(const Obligation& task) {
    const Language &left = task.language(0), &right = task.language(1);
    for (const Language& each : {left, right})
        if (each->kind != Tree::Kind::generated || !each->system)
            task.refuse("a language is not given by a system");
    const System &inner = *left->system, &outer = *right->system;
    if (inner.context != outer.context) task.refuse("one system only has contexts");
    const auto letters = accessible_letters(inner, inner.axiom);
    if (inner.context) {
        if (inner.ignored != outer.ignored) task.refuse("contexts see other letters");
        for (Symbol a = 0; a < task.alphabet().size(); ++a) {
            using Sides = std::pair<Word, Word>;
            std::array<std::vector<Sides>, 2> sides;
            std::array<std::set<std::pair<Sides, Word>>, 2> rules;
            for (const std::size_t i : {0u, 1u})
                for (const System::Rule& rule : (i == 0 ? inner : outer).rules) {
                    if (rule.letter != a) continue;
                    const Sides both{rule.left, rule.right};
                    if (std::find(sides[i].begin(), sides[i].end(), both) == sides[i].end())
                        sides[i].push_back(both);
                    rules[i].emplace(both, rule.successor);
                }
            if (sides[0] != sides[1])
                task.refuse("the rules for a letter have other contexts, or another order");
            if (!std::includes(rules[1].begin(), rules[1].end(), rules[0].begin(), rules[0].end()))
                task.refuse("a rule of the left system is not one of the right system");
        }
    } else {
        for (const System::Successors& table : inner.tables)
            if (std::none_of(
                    outer.tables.begin(), outer.tables.end(), [&](const System::Successors& other) {
                        return std::all_of(letters.begin(), letters.end(), [&](Symbol a) {
                            return std::all_of(
                                table[a].begin(), table[a].end(), [&](const Word& word) {
                                    return std::count(other[a].begin(), other[a].end(), word) > 0;
                                });
                        });
                    }))
                task.refuse("a rule of the left system is not one of the right system");
        for (const Symbol a : letters)
            if (inner.terminal[a] && !outer.terminal[a])
                task.refuse("a terminal of the left system is not one of the right system");
    }
    if (inner.axiom != outer.axiom &&
        !derives(outer, outer.axiom, inner.axiom, std::nullopt, task.budget))
        task.refuse("the right system does not derive the axiom of the left one");
}

void check_induction(const Obligation& task) {
    const Language &left = task.language(0), &right = task.language(1);
    if (right->kind != Tree::Kind::generated ||
        (!right->system->context && !has_only_terminals(*right->system)))
        task.refuse("the right language is not given by a T0L system or one with context");
    const bool is_by_length = !task.proof.has("counted");
    if (!is_by_length && right->system->context)
        task.proof.at("counted").refuse("letters are counted for systems without context only");
    std::vector<char> counted(task.alphabet().size(), is_by_length ? 1 : 0);
    if (!is_by_length)
        for (const Field& letter : task.proof.at("counted").list())
            counted[task.reader.letter(letter)] = 1;
    const auto base = task.proof.at("base").list();
    std::vector<Word> words;
    for (const Field& each : base) {
        words.push_back(task.reader.word(each));
        if (!task.contains(right, words.back()))
            each.refuse("the word is not in the right language");
    }
    if (right->system->context) return check_context_induction(task, words);
    if (task.proof.has("from")) return check_length_induction(task, words);
    Derivatives derivatives(task.alphabet(), task.budget);
    Language all = words_of(std::move(words));
    for (const System::Successors& table : right->system->tables)
        all = combination(Tree::Kind::united, {longer_words(table, counted, left), all});
    if (!derivatives.included(derivatives.term(left), derivatives.term(all)))
        task.refuse("a word that is not in the base does not come from a shorter word");
}

}  // namespace algae::verify
