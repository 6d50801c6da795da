#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <tuple>

#include "exact/exact.hpp"
#include "verify/detail/checking.hpp"
#include "verify/detail/languages.hpp"
#include "verify/verify.hpp"

// Statements about systems: derivations, membership, families, and equality of D0L sequences and languages.
//
// Equality of D0L sequences is checked by an automaton of overflows: what the image of one system has beyond that of the other
// stays within finitely many words, and every generation leads from the empty overflow back to itself, so that by induction
// all generations agree. Equality of languages is reduced to sequences of every so many generations (sections).

namespace algae::verify {

void check_steps(const Checking& with, const System& system, const Word& from, const Word& to,
                 const Field& field) {
    const auto words = field.at("words").list();
    if (words.empty()) field.at("words").refuse("a derivation has a word");
    std::vector<Field> tables;
    if (field.has("tables")) {
        if (system.context) field.at("tables").refuse("the system has no tables");
        tables = field.at("tables").list();
        if (tables.size() + 1 != words.size())
            field.at("tables").refuse("there is not one table for each step");
    } else if (system.tables.size() > 1 && words.size() > 1) {
        field.refuse(
            "the system has several tables, and the derivation does not say which are used");
    }
    Word word = with.reader.word(words[0]);
    if (word != from) words[0].refuse("the derivation does not begin with the word it should");
    for (std::size_t i = 1; i < words.size(); ++i) {
        with.budget.check();
        const Word next = with.reader.word(words[i]);
        if (system.context) {
            if (next_word(system, word) != next)
                words[i].refuse("the word before gives another word");
        } else {
            const std::uint64_t table = tables.empty() ? 0 : tables[i - 1].number();
            if (table >= system.tables.size()) tables[i - 1].refuse("there is no such table");
            if (!may_give(system.tables[static_cast<std::size_t>(table)], word, next))
                words[i].refuse("the word before does not give it");
        }
        word = next;
    }
    if (word != to) words.back().refuse("the derivation does not end with the word it should");
}

void check_derivation(const Checking& with, const Statement& statement, bool holds,
                      const Field& proof, const std::string& by) {
    const System& system = *statement.systems[0].system;
    const Word from = statement.from.value_or(system.axiom);
    if (holds && by == "derivation") {
        proof.only({"by", "words", "tables"});
        check_steps(with, system, from, statement.word, proof);
        if (statement.steps && *statement.steps + 1 != proof.at("words").list().size())
            proof.at("words").refuse("the derivation has another number of steps");
        return;
    }
    if (holds || by != "exhausted") wrong_kind(proof, by);
    proof.only({"by"});
    if (derives(system, from, statement.word, statement.steps, with.budget))
        proof.refuse("the word is derived");
}

void check_membership(const Checking& with, const Statement& statement, bool holds,
                      const Field& proof, const std::string& by) {
    if (by != "membership") wrong_kind(proof, by);
    proof.only({"by", "derivation", "preimage"});
    const Language& language = statement.languages[0];
    if (proof.has("preimage")) {
        const Field preimage = proof.at("preimage");
        const Word word = with.reader.word(preimage);
        if (!holds || proof.has("derivation") || language->kind != Tree::Kind::image)
            preimage.refuse("this does not show it");
        if (image_of(word, language->morphism, with.budget) != statement.word)
            preimage.refuse("the word is not its image");
        if (!contains(language->parts[0], word, with.alphabet(), with.budget))
            preimage.refuse("it is not in the language whose image this is");
        return;
    }
    if (proof.has("derivation")) {
        const Field derivation = proof.at("derivation");
        derivation.only({"words", "tables"});
        Language source = language;  // of a reversal, the derivation is that of the reversed word
        Word word = statement.word;
        for (; source->kind == Tree::Kind::reversal; source = source->parts[0])
            std::reverse(word.begin(), word.end());
        if (source->kind != Tree::Kind::generated)
            derivation.refuse("the language is not given by a system");
        if (!holds)
            derivation.refuse("a derivation does not show that a word is not in a language");
        const System& system = *source->system;
        check_steps(with, system, system.axiom, word, derivation);
        if (!std::all_of(word.begin(), word.end(), [&](Symbol a) { return system.terminal[a]; }))
            derivation.refuse("a letter of the word is no terminal");
        return;
    }
    if (contains(language, statement.word, with.alphabet(), with.budget) != holds)
        proof.refuse(holds ? "the word is not in the language" : "the word is in the language");
}

void check_rewriting(const Checking& with, const Statement& statement, bool holds,
                     const Field& proof, const std::string& by) {
    if (by == "environment") {
        proof.only({"by"});
        throw BoundReached(Bound::method, "what environments answer is not worked out again");
    }
    if (by != "rewriting") wrong_kind(proof, by);
    proof.only({"by"});
    const ModuleSystem& system = *statement.rewriting;
    const Rational found = chance(system, statement.modules_from.value_or(system.axiom),
                                  statement.modules, *statement.steps, proof, with.budget);
    const bool is_so = statement.kind == Statement::Kind::chance ? found == *statement.probability
                                                                 : !found.is_zero();
    if (is_so != holds) proof.refuse("the word has the probability " + to_string(found));
}

namespace {

std::set<Word> finite_words(const Checking& with, const Language& language, const Field& proof) {
    auto words = finite_values(language, with.alphabet(), with.budget);
    if (!words) proof.refuse("the language is infinite");
    return std::move(*words);
}

Statement equality(const Language& left, const Language& right) {
    Statement equal;
    equal.kind = Statement::Kind::equal;
    equal.languages = {left, right};
    return equal;
}

std::shared_ptr<const System> system_of_form(const Checking& with, const std::string& family,
                                             const Field& field) {
    auto system = std::make_shared<const System>(with.reader.system(field));
    if (const auto beyond = beyond_form(*system, family, with.certificate.empty_axiom))
        field.refuse("the system has not the form of " + family + ": " + *beyond);
    return system;
}

/// Derives the words of a system and stops at the first terminal word that should not be there.
void check_finite_system(const Checking& with, const std::string& family, const Language& language,
                         const Field& proof) {
    const auto words = finite_words(with, language, proof);
    const auto system = system_of_form(with, family, proof.at("system"));
    const auto derived = finite_values(generated_by(system, ""), with.alphabet(), with.budget);
    if (derived != words) proof.at("system").refuse("the system does not generate the language");
}

void check_form(const Checking& with, const std::string& family, const Language& language,
                const Field& proof) {
    if (language->kind != Tree::Kind::generated)
        proof.refuse("the language is not given by a system");
    if (const auto beyond = beyond_form(*language->system, family, with.certificate.empty_axiom))
        proof.refuse("the system has not the form of " + family + ": " + *beyond);
}

void check_all_finite(const Checking& with, const std::string& family, const Language& language,
                      const Field& proof) {
    static constexpr std::array all = {"E0L", "ET0L", "EDT0L", "IL", "REG", "CF"};
    if (std::find(all.begin(), all.end(), family) == all.end())
        proof.refuse("not all finite languages are " + family);
    const auto words = finite_words(with, language, proof);
    const bool has_axiom = std::any_of(words.begin(), words.end(), [&](const Word& word) {
        return with.certificate.empty_axiom || !word.empty();
    });
    if (family == "IL" && !has_axiom) proof.refuse("no word of the language can be the axiom");
}

void check_cases(const Checking& with, const std::string& family, const Language& language,
                 const Field& proof) {
    const auto& all = all_families();
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](Family each) { return to_string(each) == family; });
    if (found == all.end()) proof.refuse("no proof by cases is known for " + family);
    const auto words = finite_words(with, language, proof);
    FamilyObstruction obstruction = read_obstruction(with.reader, proof.at("obstruction"));
    obstruction.family = *found;
    obstruction.empty_axiom = with.certificate.empty_axiom;
    obstruction.language =
        make_finite_language(with.certificate.alphabet, {words.begin(), words.end()});
    if (const auto flaw = flaw_in(obstruction, with.budget)) proof.refuse(*flaw);
}

/// All families are closed under reversal, and it is its own inverse.
void check_reversal(const Checking& with, const Statement& statement, bool holds,
                    const Field& proof) {
    if (statement.languages[0]->kind != Tree::Kind::reversal)
        proof.refuse("the language is no reversal");
    Statement part = statement;
    part.languages = statement.languages[0]->parts;
    check_proof(with, part, holds, proof.at("proof"));
}

/// The lengths of the words are infinitely many, and so few that they hold no arithmetic progression; but those
/// of an infinite context-free language do (Parikh 1966).
void check_sparse(const Statement& statement, const Field& proof) {
    const Language& language = statement.languages[0];
    if (statement.family != "REG" && statement.family != "CF")
        proof.refuse("this shows nothing of " + statement.family);
    if (language->kind != Tree::Kind::generated || !is_d0l(*language->system))
        proof.refuse("the language is not given by a D0L system");
    const Growth growth = growth_of(*language->system);
    if (growth.name != "exponential" && (growth.name != "polynomial" || growth.degree < 2))
        proof.refuse("the lengths grow no faster than n");
}

/// A propagating system derives the empty word from no other.
void check_empty_word(const Checking& with, const Statement& statement, const Field& proof) {
    if (!statement.family.starts_with('P'))
        proof.refuse("a system of the family " + statement.family + " may derive the empty word");
    if (with.certificate.empty_axiom) proof.refuse("the empty word may be the axiom");
    if (!contains(statement.languages[0], {}, with.alphabet(), with.budget))
        proof.refuse("the empty word is not in the language");
}

}  // namespace

void check_family(const Checking& with, const Statement& statement, bool holds, const Field& proof,
                  const std::string& by) {
    const Language& language = statement.languages[0];
    if (by == "reversal") {
        proof.only({"by", "proof"});
        check_reversal(with, statement, holds, proof);
    } else if (!holds && by == "empty word") {
        proof.only({"by"});
        check_empty_word(with, statement, proof);
    } else if (!holds && by == "sparse") {
        proof.only({"by"});
        check_sparse(statement, proof);
    } else if (!holds) {
        if (by != "cases") wrong_kind(proof, by);
        proof.only({"by", "obstruction"});
        check_cases(with, statement.family, language, proof);
    } else if (by == "system") {
        proof.only({"by", "system"});
        check_finite_system(with, statement.family, language, proof);
    } else if (by == "form") {
        proof.only({"by"});
        check_form(with, statement.family, language, proof);
    } else if (by == "equal") {
        proof.only({"by", "system", "proof"});
        const auto system = system_of_form(with, statement.family, proof.at("system"));
        check_proof(with, equality(generated_by(system, ""), language), true, proof.at("proof"));
    } else if (by == "finite") {
        proof.only({"by"});
        check_all_finite(with, statement.family, language, proof);
    } else if (by == "regular") {
        proof.only({"by"});
        if (statement.family != "REG" && statement.family != "CF") wrong_kind(proof, by);
        check_regular(with, language, proof);
    } else {
        wrong_kind(proof, by);
    }
}

namespace {

constexpr std::uint64_t furthest =
    100'000;  // of numbers of generations and of what they are repeated by

/// Numbers first, first + step, first + 2 step, ...; only the first if the step is 0.
struct Progression {
    std::uint64_t first = 0, step = 0;
};

bool covers_all(const std::vector<Progression>& progressions) {
    std::uint64_t beyond = 1, period = 1;
    for (const Progression& each : progressions) {
        beyond = std::max(beyond, each.first + 1);
        if (each.step > 0) period = std::lcm(period, each.step);
        if (period > furthest)
            throw BoundReached(Bound::method, "the sections repeat too late to be checked");
    }
    for (std::uint64_t n = 0; n < beyond + period; ++n)
        if (std::none_of(progressions.begin(), progressions.end(), [&](const Progression& each) {
                return n == each.first ||
                       (each.step > 0 && n > each.first && (n - each.first) % each.step == 0);
            }))
            return false;
    return true;
}

Word next(const System& system, const Word& word, const Budget& budget) {
    Word longer;
    budget.check();
    for (const Symbol a : word) {
        const Word& image = system.tables.front()[a].front();
        if (longer.size() + image.size() > 10'000'000)
            throw BoundReached(Bound::method, "the words of the sequences are too long");
        longer.insert(longer.end(), image.begin(), image.end());
    }
    return longer;
}

Word generation(const System& system, Word word, std::uint64_t steps, const Budget& budget) {
    if (steps > furthest)
        throw BoundReached(Bound::method, "the sections begin too late to be checked");
    for (; steps > 0; --steps) word = next(system, word, budget);
    return word;
}

/// The system of every so many generations, from one on. Letters that are not accessible stay as they are.
System section(const System& system, std::uint64_t first, std::uint64_t step,
               const Budget& budget) {
    System part = system;
    part.axiom = generation(system, system.axiom, first, budget);
    auto& images = part.tables.front();
    for (Symbol a = 0; a < images.size(); ++a) images[a] = {{a}};
    for (const Symbol a : accessible_letters(system, system.axiom))
        images[a] = {generation(system, {a}, step, budget)};
    return part;
}

}  // namespace

void check_sections(const Checking& with, const System& left, const System& right,
                    const Field& proof) {
    proof.only({"by", "words", "sections"});
    std::vector<Progression> numbers_left, numbers_right;
    for (const Field& each : proof.at("words").list()) {
        const auto [one, other] = each.pair();
        numbers_left.push_back({one.number(), 0});
        numbers_right.push_back({other.number(), 0});
        if (generation(left, left.axiom, one.number(), with.budget) !=
            generation(right, right.axiom, other.number(), with.budget))
            each.refuse("these generations are not the same word");
    }
    for (const Field& each : proof.at("sections").list()) {
        each.only({"left", "step", "right", "stride", "proof"});
        const Progression one{each.at("left").number(), each.at("step").number()};
        const Progression other{each.at("right").number(), each.at("stride").number()};
        if (one.step == 0 || other.step == 0) each.refuse("a section goes on");
        const System first = section(left, one.first, one.step, with.budget);
        const System second = section(right, other.first, other.step, with.budget);
        if (!is_d0l(first) || !is_d0l(second)) each.refuse("a section is not D0L");
        const Field balance = each.at("proof");
        if (balance.at("by").text() != "balance") wrong_kind(balance, balance.at("by").text());
        check_balance(with, first, second, balance);
        numbers_left.push_back(one);
        numbers_right.push_back(other);
    }
    if (!covers_all(numbers_left)) proof.refuse("a generation of the left system is in no section");
    if (!covers_all(numbers_right))
        proof.refuse("a generation of the right system is in no section");
}

namespace {

/// What one image of a word has beyond the other: of the left system, if that is ahead.
struct Overhang {
    bool left_ahead = true;
    Word word;
    bool operator==(const Overhang&) const = default;
    bool operator<(const Overhang& other) const {
        return std::tie(left_ahead, word) < std::tie(other.left_ahead, other.word);
    }
};

/// What a letter with these images makes of it; nothing if they differ at a letter that both have.
std::optional<Overhang> with_letter(const Overhang& before, const Word& left, const Word& right) {
    Word one = before.left_ahead ? before.word : Word{};
    Word other = before.left_ahead ? Word{} : before.word;
    one.insert(one.end(), left.begin(), left.end());
    other.insert(other.end(), right.begin(), right.end());
    const std::size_t both = std::min(one.size(), other.size());
    const auto middle = static_cast<std::ptrdiff_t>(both);
    if (!std::equal(one.begin(), one.begin() + middle, other.begin())) return std::nullopt;
    if (one.size() >= other.size()) return Overhang{true, Word(one.begin() + middle, one.end())};
    return Overhang{false, Word(other.begin() + middle, other.end())};
}

std::map<Overhang, std::size_t> read_states(const Checking& with, const Field& proof) {
    const Field field = proof.at("states");
    const std::uint64_t bound = proof.at("bound").number();
    std::map<Overhang, std::size_t> states;
    for (const Field& each : field.list()) {
        each.only({"ahead", "word"});
        const std::string& ahead = each.at("ahead").text();
        if (ahead != "left" && ahead != "right") each.at("ahead").fail("expected left or right");
        Overhang state{ahead == "left", with.reader.word(each.at("word"))};
        if (state.word.empty()) state.left_ahead = true;
        if (state.word.size() > bound) each.refuse("the overflow is longer than the bound");
        if (states.empty() && !state.word.empty()) each.refuse("the first overflow is not empty");
        if (!states.emplace(std::move(state), states.size()).second)
            each.refuse("the overflow is listed twice");
    }
    if (states.empty()) field.refuse("the empty overflow is missing");
    return states;
}

}  // namespace

/// g^k(w) leads from the empty overflow to itself for every k, so g and h agree on it: by induction the
/// sequences of g and h are the same.
void check_balance(const Checking& with, const System& left, const System& right,
                   const Field& proof) {
    proof.only({"by", "bound", "states", "accepts"});
    if (proof.has("accepts")) {
        const Field repeats = proof.at("accepts");
        repeats.only({"steps", "earlier"});
        if (repeats.at("steps").number() <= repeats.at("earlier").number())
            repeats.refuse("nothing repeats before it begins");
    }
    if (left.axiom != right.axiom) proof.refuse("the axioms differ");
    const auto letters = accessible_letters(left, left.axiom);
    const auto states = read_states(with, proof);
    const std::size_t refusal = states.size();
    with.budget.check_memory(letters.size() * (refusal + 1) * (refusal + 1) / 8, "the automaton");
    Relations start;
    for (const Symbol a : letters) {
        const auto& image = right.tables.front()[a];
        if (image.size() != 1) proof.refuse("a letter has two images in the right system");
        BooleanMatrix relation(refusal + 1);
        relation.set(refusal, refusal);
        for (const auto& [state, number] : states) {
            const auto next = with_letter(state, left.tables.front()[a].front(), image.front());
            const auto place = next ? states.find(*next) : states.end();
            relation.set(number, place == states.end() ? refusal : place->second);
        }
        start.emplace(a, std::move(relation));
    }
    const auto leaves = [&](const Relations& relations) {
        return !relation_of(left.axiom, relations, refusal + 1).at(0, 0);
    };
    if (some_relations(left, start, refusal + 1, leaves, with.budget))
        proof.at("states").refuse(
            "a word of the sequence does not lead through these overflows back to the empty one");
}

namespace {

void check_finite_sequences(const Checking& with, const System& left, const System& right,
                            const Field& proof) {
    proof.only({"by"});
    std::set<Word> known;
    std::uint64_t letters = 0;
    Word one = left.axiom, other = right.axiom;
    const auto next = [](const System& system, const Word& word) {
        Word longer;
        for (const Symbol a : word) {
            const Word& image = system.tables.front()[a].front();
            longer.insert(longer.end(), image.begin(), image.end());
        }
        return longer;
    };
    for (std::uint64_t generation = 0;; ++generation) {
        with.budget.check();
        if (one != other) proof.refuse("generation " + std::to_string(generation) + " differs");
        if (!known.insert(one).second) return;  // equal words give equal words from here on
        letters += one.size() + 16;
        if (letters > 50'000'000)
            throw BoundReached(Bound::method, "the words of the sequences are too long");
        one = next(left, one);
        other = next(right, other);
    }
}

void check_difference(const Checking& with, const System& left, const System& right,
                      const Field& proof) {
    proof.only({"by", "generation", "position"});
    const Integer generation = proof.at("generation").integer();
    if (!proof.has("position")) {
        if (length_of_generation(left, generation, with.budget) ==
            length_of_generation(right, generation, with.budget))
            proof.at("generation").refuse("both words are of the same length");
        return;
    }
    if (generation > 100'000)
        throw BoundReached(Bound::method, "the letters of generation " + to_string(generation) +
                                              " are not looked up");
    const Integer position = proof.at("position").integer();
    const auto one = letter_of_generation(left, generation.to_uint64(), position, with.budget);
    const auto other = letter_of_generation(right, generation.to_uint64(), position, with.budget);
    if (one == other)
        proof.at("position")
            .refuse(one ? "both words have the same letter there" : "neither word is so long");
}

}  // namespace

void check_sequences(const Checking& with, const Statement& statement, bool holds,
                     const Field& proof, const std::string& by) {
    const System& left = *statement.systems[0].system;
    const System& right = *statement.systems[1].system;
    if (!is_d0l(left) || !is_d0l(right)) proof.refuse("a system is not D0L");
    if (!holds) {
        if (by != "generation") wrong_kind(proof, by);
        check_difference(with, left, right, proof);
    } else if (by == "balance") {
        check_balance(with, left, right, proof);
    } else if (by == "lengths") {
        check_finite_sequences(with, left, right, proof);
    } else {
        wrong_kind(proof, by);
    }
}

}  // namespace algae::verify
