#include <algorithm>

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

class Checker {
public:
    Checker(const Checking& with, const System& system, const Field& proof)
        : with_(with), system_(system), proof_(proof) {}

    void check() {
        const Symbol again = with_.reader.letter(proof_.at("again"));
        const Symbol other = with_.reader.letter(proof_.at("other"));
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
        if (round.empty()) proof_.at("round").refuse("a round has a step");
        if (!within(system_.axiom, finish_before.front()))
            proof_.at("before").refuse("a letter of the axiom cannot finish");
        const Symbol start = before.empty() ? again : before.front().letter;
        if (std::find(system_.axiom.begin(), system_.axiom.end(), start) == system_.axiom.end())
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
            Step step{field.at("table").number(), with_.reader.letter(field.at("letter")),
                      with_.reader.word(field.at("successor")), field.at("place").number(), field};
            if (step.table >= system_.tables.size())
                field.at("table").refuse("there is no such table");
            const auto& all = system_.tables[static_cast<std::size_t>(step.table)][step.letter];
            if (std::find(all.begin(), all.end(), step.successor) == all.end())
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
        if (steps.size() != round.size() || !std::equal(steps.begin(), steps.end(), round.begin(),
                                                        [](const Step& one, const Step& other) {
                                                            return one.table == other.table;
                                                        }))
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

    const Checking& with_;
    const System& system_;
    const Field& proof_;
};

}  // namespace

/// Checks that L(G) is infinite by five courses of steps, each of one letter by a table: `before` leads from a
/// letter of the axiom to the letter `again`; `round` from there to itself, and `beside`, which is the same step
/// as `round` at some point but for the place, by the same tables to `other`; `kept` by the same tables from
/// `other` to itself; `after` from `other` to a terminal. All letters beside them can finish: derive words
/// of terminals by the tables that follow. So n rounds give a word of L(G) with n letters and more.
void check_endless_tables(const Checking& with, const Language& language, const Field& proof) {
    proof.only({"by", "again", "other", "before", "round", "beside", "kept", "after"});
    if (language->kind != Tree::Kind::generated || language->system->context)
        proof.refuse("the language is not given by a system without context");
    Checker(with, *language->system, proof).check();
}

namespace {

struct RoundRule {
    Symbol letter = 0;
    Word successor;
};

/// Each rule of the round has the letter of the next one, the last has that of the first; the first has
/// another letter besides that lasts. So there are words with any number of lasting letters.
void check_round(const Checking& with, const Language& language, const Field& proof) {
    proof.only({"by", "rules", "other"});
    if (language->kind != Tree::Kind::generated)
        proof.refuse("the language is not given by a system");
    const System& system = *language->system;
    if (system.context || system.tables.size() != 1 || !has_only_terminals(system))
        proof.refuse("the system is not 0L");
    const auto& table = system.tables.front();
    std::vector<RoundRule> rules;
    for (const Field& field : proof.at("rules").list()) {
        field.only({"letter", "successor"});
        const RoundRule rule{with.reader.letter(field.at("letter")),
                             with.reader.word(field.at("successor"))};
        const auto& all = table[rule.letter];
        if (std::find(all.begin(), all.end(), rule.successor) == all.end())
            field.refuse("the system has no such rule");
        rules.push_back(rule);
    }
    if (rules.empty()) proof.at("rules").refuse("a round has a rule");
    const auto letters = accessible_letters(system, system.axiom);
    if (std::find(letters.begin(), letters.end(), rules[0].letter) == letters.end())
        proof.at("rules").refuse("the letter of the first rule occurs in no derived word");
    for (std::size_t i = 0; i < rules.size(); ++i) {
        const Symbol next = rules[(i + 1) % rules.size()].letter;
        if (std::count(rules[i].successor.begin(), rules[i].successor.end(), next) == 0)
            proof.at("rules").list()[i].refuse(
                "the letter of the next rule is not in its successor");
    }
    const Symbol other = with.reader.letter(proof.at("other"));
    const Symbol next = rules[1 % rules.size()].letter;
    const Word& first = rules[0].successor;
    if (std::count(first.begin(), first.end(), other) < (other == next ? 2 : 1))
        proof.at("other").refuse("the first rule has no such letter besides that of the next rule");
    if (!lasting_letters(table).contains(other))
        proof.at("other").refuse("the letter is gone after some steps, whatever it becomes");
}

void check_pumping(const Checking& with, const Language& language, const Field& proof) {
    proof.only({"by", "prefix", "middle", "suffix"});
    check_regular(with, language, proof);
    const Word prefix = with.reader.word(proof.at("prefix"));
    const Word middle = with.reader.word(proof.at("middle"));
    const Word suffix = with.reader.word(proof.at("suffix"));
    if (middle.empty()) proof.at("middle").refuse("nothing is repeated");
    Derivatives derivatives(with.alphabet(), with.budget);
    const auto before = derivatives.derivative(derivatives.term(language), prefix);
    if (!derivatives.equal(before, derivatives.derivative(before, middle)))
        proof.at("middle").refuse("what may follow is not the same before and after it");
    if (!derivatives.nullable(derivatives.derivative(before, suffix)))
        proof.at("suffix").refuse("the word is not in the language");
}

/// Throws Flaw if no word is known to be in the language.
void check_has_word(const Checking& with, const Language& language, const Field& proof) {
    try {
        if (!within_regular(language, words_of({}), with.alphabet(), with.budget)) return;
    } catch (const Error& error) {
        throw BoundReached(Bound::method,
                           std::string("whether the other part has a word: ") + error.what());
    }
    proof.refuse("the other part has no word");
}

void check_part(const Checking& with, const Language& language, const Field& proof) {
    proof.only({"by", "index", "proof"});
    const std::uint64_t index = proof.at("index").number();
    switch (language->kind) {
        case Tree::Kind::united:
        case Tree::Kind::concatenation:
        case Tree::Kind::star:
        case Tree::Kind::plus:
        case Tree::Kind::reversal:
            break;
        default:
            proof.refuse("an infinite part does not make this infinite");
    }
    if (index >= language->parts.size()) proof.at("index").refuse("there is no such part");
    if (language->kind == Tree::Kind::concatenation)
        check_has_word(with, language->parts[1 - static_cast<std::size_t>(index)], proof);
    const Field part = proof.at("proof");
    check_infinite(with, language->parts[static_cast<std::size_t>(index)], part,
                   part.at("by").text());
}

}  // namespace

void check_infinite(const Checking& with, const Language& language, const Field& proof,
                    const std::string& by) {
    if (by == "endless round") return check_round(with, language, proof);
    if (by == "endless tables") return check_endless_tables(with, language, proof);
    if (by == "pumping") return check_pumping(with, language, proof);
    if (by == "part") return check_part(with, language, proof);
    wrong_kind(proof, by);
}

namespace {

void check_size_of_values(const Checking& with, const Statement& statement, bool holds,
                          const Field& proof) {
    proof.only({"by"});
    const auto words = finite_values(statement.languages[0], with.alphabet(), with.budget);
    bool found = false;
    switch (statement.kind) {
        case Statement::Kind::finite:
            found = words.has_value();
            break;
        case Statement::Kind::empty:
            found = words && words->empty();
            break;
        default:
            found = words && *statement.size == words->size();
            break;
    }
    if (found == holds) return;
    proof.refuse(words ? "the language has " + std::to_string(words->size()) + " words"
                       : "the language is infinite");
}

}  // namespace

void check_size(const Checking& with, const Statement& statement, bool holds, const Field& proof,
                const std::string& by) {
    const Language& language = statement.languages[0];
    const bool of_empty = statement.kind == Statement::Kind::empty;
    if (by == "values") return check_size_of_values(with, statement, holds, proof);
    if (of_empty && holds && by == "relations") {
        proof.only({"by"});
        try {
            if (within_regular(language, words_of({}), with.alphabet(), with.budget)) return;
        } catch (const Error& error) {
            proof.refuse(error.what());
        }
        proof.refuse("the language has a word");
    }
    if (of_empty && !holds && by == "word") {
        proof.only({"by", "word"});
        const Word word = with.reader.word(proof.at("word"));
        if (contains(language, word, with.alphabet(), with.budget)) return;
        proof.at("word").refuse("the word is not in the language");
    }
    if (of_empty || holds) wrong_kind(proof, by);
    if (statement.kind == Statement::Kind::finite) return check_infinite(with, language, proof, by);
    if (by != "infinite") wrong_kind(proof, by);
    proof.only({"by", "proof"});
    const Field infinite = proof.at("proof");
    check_infinite(with, language, infinite, infinite.at("by").text());
}

namespace {

using Kind = Statement::Kind;

void check_values(const Checking& with, const Statement& statement, bool holds,
                  const Field& proof) {
    const auto left = finite_values(statement.languages[0], with.alphabet(), with.budget);
    if (statement.kind == Kind::included && holds) {
        if (!left) proof.refuse("the left language is infinite");
        for (const Word& word : *left)
            if (!contains(statement.languages[1], word, with.alphabet(), with.budget))
                proof.refuse("a word is in the left language only");
        return;
    }
    const auto right = finite_values(statement.languages[1], with.alphabet(), with.budget);
    if (!left || !right) proof.refuse("one of the languages is infinite");
    const bool found = statement.kind == Kind::equal ? *left == *right
                                                     : std::includes(right->begin(), right->end(),
                                                                     left->begin(), left->end());
    if (found != holds)
        proof.refuse(found ? "every word is in both languages" : "a word is in one language only");
}

void check_derivatives(const Checking& with, const Statement& statement, const Field& proof) {
    Derivatives derivatives(with.alphabet(), with.budget);
    const auto left = derivatives.term(statement.languages[0]);
    const auto right = derivatives.term(statement.languages[1]);
    if (!derivatives.included(left, right)) proof.refuse("a word is in the left language only");
    if (statement.kind == Kind::equal && !derivatives.included(right, left))
        proof.refuse("a word is in the right language only");
}

void check_word(const Checking& with, const Statement& statement, const Field& proof) {
    const Field field = proof.at("word");
    const Word word = with.reader.word(field);
    const auto in = [&](const Language& language) {
        return contains(language, word, with.alphabet(), with.budget);
    };
    const bool left = in(statement.languages[0]), right = in(statement.languages[1]);
    if (left == right)
        field.refuse(left ? "the word is in both languages" : "the word is in neither language");
    if (statement.kind == Kind::included && right)
        field.refuse("the word is in the right language only");
}

/// The sequences of the two systems are equal, so their languages are.
void check_same_sequences(const Checking& with, const Statement& statement, const Field& proof) {
    Statement sequences;
    sequences.kind = Kind::equal_sequences;
    for (const Language& language : statement.languages) {
        if (language->kind != Tree::Kind::generated)
            proof.refuse("a language is not given by a system");
        sequences.systems.push_back({language->name, language->system});
    }
    check_proof(with, sequences, true, proof.at("proof"));
}

void check_both(const Checking& with, const Statement& statement, const Field& proof) {
    const auto [one, other] = proof.at("proofs").pair();
    Statement included;
    included.kind = Kind::included;
    included.languages = statement.languages;
    check_proof(with, included, true, one);
    std::swap(included.languages[0], included.languages[1]);
    check_proof(with, included, true, other);
}

void check_relations(const Checking& with, const Statement& statement, const Field& proof) {
    bool within = false;
    try {
        within = within_regular(statement.languages[0], statement.languages[1], with.alphabet(),
                                with.budget);
    } catch (const Error& error) {
        proof.refuse(error.what());
    }
    if (!within) proof.refuse("a word of the left language is not in the right one");
}

}  // namespace

void check_comparison(const Checking& with, const Statement& statement, bool holds,
                      const Field& proof, const std::string& by) {
    const bool of_equality = statement.kind == Kind::equal;
    if (by == "values") {
        proof.only({"by"});
        check_values(with, statement, holds, proof);
    } else if (!holds) {
        if (by != "word") wrong_kind(proof, by);
        proof.only({"by", "word"});
        check_word(with, statement, proof);
    } else if (by == "derivatives") {
        proof.only({"by"});
        check_derivatives(with, statement, proof);
    } else if (by == "identical") {
        proof.only({"by"});
        if (!same(statement.languages[0], statement.languages[1]))
            proof.refuse("the expressions are not the same");
    } else if (by == "sequences") {
        proof.only({"by", "proof"});
        check_same_sequences(with, statement, proof);
    } else if (by == "sections" && of_equality) {
        for (const Language& language : statement.languages)
            if (language->kind != Tree::Kind::generated || !is_d0l(*language->system))
                proof.refuse("a language is not given by a D0L system");
        check_sections(with, *statement.languages[0]->system, *statement.languages[1]->system,
                       proof);
    } else if (by == "induction" && !of_equality) {
        check_induction(with, statement.languages[0], statement.languages[1], proof);
    } else if (by == "relations" && !of_equality) {
        proof.only({"by"});
        check_relations(with, statement, proof);
    } else if (by == "both" && of_equality) {
        proof.only({"by", "proofs"});
        check_both(with, statement, proof);
    } else {
        wrong_kind(proof, by);
    }
}

namespace {

Language with_morphism(Tree::Kind kind, std::map<Symbol, Word> morphism, Language part) {
    Tree tree;
    tree.kind = kind;
    tree.morphism = std::move(morphism);
    tree.parts = {std::move(part)};
    return std::make_shared<const Tree>(std::move(tree));
}

/// The words that come in one step from shorter words of the language, by successors that are not empty:
/// of words over new letters, one for each rule, that spell a word of the language.
Language longer_words(const System& system, const Language& language) {
    std::map<Symbol, Word> predecessors, successors;
    std::vector<Word> rules, longer;
    const auto& table = system.tables.front();
    auto rule = static_cast<Symbol>(table.size());
    for (Symbol a = 0; a < table.size(); ++a)
        for (const Word& word : table[a]) {
            if (word.empty()) continue;
            predecessors[rule] = {a};
            successors[rule] = word;
            rules.push_back({rule});
            if (word.size() > 1) longer.push_back({rule});
            ++rule;
        }
    const Language any = combination(Tree::Kind::star, {words_of(std::move(rules))});
    const Language one_longer = combination(
        Tree::Kind::concatenation,
        {any, combination(Tree::Kind::concatenation, {words_of(std::move(longer)), any})});
    const Language uses = combination(
        Tree::Kind::intersection,
        {with_morphism(Tree::Kind::inverse_image, std::move(predecessors), language), one_longer});
    return with_morphism(Tree::Kind::image, std::move(successors), uses);
}

}  // namespace

void check_induction(const Checking& with, const Language& left, const Language& right,
                     const Field& proof) {
    proof.only({"by", "base"});
    if (right->kind != Tree::Kind::generated || right->system->context ||
        right->system->tables.size() != 1 || !has_only_terminals(*right->system))
        proof.refuse("the right language is not given by an 0L system");
    const auto base = proof.at("base").list();
    std::vector<Word> words;
    for (const Field& each : base) {
        words.push_back(with.reader.word(each));
        if (!contains(right, words.back(), with.alphabet(), with.budget))
            each.refuse("the word is not in the right language");
    }
    Derivatives derivatives(with.alphabet(), with.budget);
    const Language steps = longer_words(*right->system, left);
    const auto all =
        derivatives.term(combination(Tree::Kind::united, {steps, words_of(std::move(words))}));
    if (!derivatives.included(derivatives.term(left), all))
        proof.refuse("a word that is not in the base does not come from a shorter word");
}

}  // namespace algae::verify
