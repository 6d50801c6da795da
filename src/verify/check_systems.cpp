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
// is one of finitely many words, and every generation leads from the empty overflow back to itself, so that by induction
// all generations agree. Equality of languages is reduced to equality of sequences of generations at equal distances (sections).

namespace algae::verify {

namespace {

/// Checks a derivation from one word to the other: the fields `words` and `tables` of a proof.
void check_steps(const Obligation& task, const System& system, const Word& from, const Word& to,
                 const Field& field) {
    const auto words = field.at("words").list();
    if (words.empty()) field.at("words").refuse("a derivation must have a word");
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
    Word word = task.reader.word(words[0]);
    if (word != from) words[0].refuse("the derivation does not begin with the word it should");
    for (std::size_t i = 1; i < words.size(); ++i) {
        task.budget.check();
        const Word next = task.reader.word(words[i]);
        if (system.context) {
            if (!may_give(system, word, next)) words[i].refuse("the word before does not give it");
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

}  // namespace

void check_derivation(const Obligation& task) {
    const auto& [word, steps] = std::tie(task.statement.word, task.statement.steps);
    const System& system = task.system();
    check_steps(task, system, task.statement.from.value_or(system.axiom), word, task.proof);
    const Field words = task.proof.at("words");
    if (steps && *steps + 1 != words.list().size())
        words.refuse("the derivation has another number of steps");
}

void check_not_derived(const Obligation& task) {
    const Statement& statement = task.statement;
    const System& system = task.system();
    if (derives(system, statement.from.value_or(system.axiom), statement.word, statement.steps,
                task.budget))
        task.refuse("the word is derived");
}

void check_membership(const Obligation& task) {
    const Language& language = task.language();
    if (task.proof.has("preimage")) {
        const Field preimage = task.proof.at("preimage");
        const Word word = task.reader.word(preimage);
        if (!task.holds || task.proof.has("derivation") || language->kind != Tree::Kind::image)
            preimage.refuse("this does not show it");
        if (image_of(word, language->morphism, task.budget) != task.statement.word)
            preimage.refuse("the word is not its image");
        if (!task.contains(language->parts[0], word))
            preimage.refuse("it is not in the language whose image this is");
        return;
    }
    if (task.proof.has("derivation")) {
        const Field derivation = task.proof.at("derivation");
        derivation.only({"words", "tables"});
        Language source = language;  // of a reversal, the derivation is that of the reversed word
        Word word = task.statement.word;
        for (; source->kind == Tree::Kind::reversal; source = source->parts[0])
            std::reverse(word.begin(), word.end());
        if (source->kind != Tree::Kind::generated)
            derivation.refuse("the language is not given by a system");
        if (!task.holds)
            derivation.refuse("a derivation does not show that a word is not in a language");
        const System& system = *source->system;
        check_steps(task, system, system.axiom, word, derivation);
        if (!is_terminal(system, word)) derivation.refuse("a letter of the word is not a terminal");
        return;
    }
    if (task.contains(language, task.statement.word) != task.holds)
        task.refuse(task.holds ? "the word is not in the language" : "the word is in the language");
}

void check_rewriting(const Obligation& task) {
    const Statement& statement = task.statement;
    const ModuleSystem& system = *task.statement.rewriting;
    const Rational found = chance(
        system, values(statement.modules_from.value_or(system.axiom), {}, task.proof),
        values(statement.modules, {}, task.proof), *statement.steps, task.proof, task.budget);
    const bool is_so = statement.kind == Statement::Kind::chance ? found == *statement.probability
                                                                 : !found.is_zero();
    if (is_so != task.holds) task.refuse("the word has the probability " + to_string(found));
}

namespace {

std::set<Word> finite_words(const Obligation& task) {
    auto words = task.values(task.language());
    if (!words) task.refuse("the language is infinite");
    return std::move(*words);
}

void must_have_form(const Obligation& task, const System& system, const Field& field) {
    const std::string& family = task.statement.family;
    if (const auto beyond = beyond_form(system, family, task.certificate.empty_axiom))
        field.refuse("the system does not have the form of " + family + ": " + *beyond);
}

/// The language of the system in a proof, which must have the form of the family.
Language language_of_form(const Obligation& task) {
    const Field field = task.proof.at("system");
    auto system = std::make_shared<const System>(task.reader.system(field));
    must_have_form(task, *system, field);
    return generated_by(std::move(system), "");
}

}  // namespace

/// Derives the words of a system and stops at the first terminal word that should not be there.
void check_finite_system(const Obligation& task) {
    const auto words = finite_words(task);
    if (task.values(language_of_form(task)) != words)
        task.proof.at("system").refuse("the system does not generate the language");
}

void check_form(const Obligation& task) {
    const Language& language = task.language();
    if (language->kind != Tree::Kind::generated)
        task.refuse("the language is not given by a system");
    must_have_form(task, *language->system, task.proof);
}

void check_equal_to_form(const Obligation& task) {
    Statement equal;
    equal.kind = Statement::Kind::equal;
    equal.languages = {language_of_form(task), task.language()};
    check_proof(task.part(equal, true, task.proof.at("proof")));
}

void check_all_finite(const Obligation& task) {
    static constexpr std::array all = {"E0L", "ET0L", "EDT0L", "IL", "REG", "CF"};
    const std::string& family = task.statement.family;
    if (!std::count(all.begin(), all.end(), family))
        task.refuse("not all finite languages are " + family);
    const auto words = finite_words(task);
    const bool has_axiom = std::any_of(words.begin(), words.end(), [&](const Word& word) {
        return task.certificate.empty_axiom || !word.empty();
    });
    if (family == "IL" && !has_axiom) task.refuse("no word of the language can be the axiom");
}

void check_regular_family(const Obligation& task) {
    if (task.statement.family != "REG" && task.statement.family != "CF") task.wrong_kind();
    check_regular(task, task.language());
}

namespace {

/// Whether no system occurs in the expression.
bool is_seen_regular(const Obligation&, const Language& language) { return is_regular(language); }

/// Whether all systems in the expression have finite languages, which may take long.
bool is_of_finite_systems(const Obligation& task, const Language& language) {
    try {
        check_regular(task, language);
        return true;
    } catch (const Flaw&) {
        return false;
    } catch (const BoundReached& bound) {
        if (bound.bound() == Bound::time) throw;
        return false;  // not seen to be finite
    }
}

/// Throws Flaw unless the expression is made by operations under which an extended family is closed (Rozenberg and Salomaa
/// 1980, chapters II and V) from languages of systems that have its form and from regular languages, which are all of the family.
void must_be_closed(const Obligation& task, const Language& language) {
    using Kind = Tree::Kind;
    const std::string& family = task.statement.family;
    if (is_regular(language)) return;
    std::string why = "the family is not known to be closed under an operation of the expression";
    switch (language->kind) {
        case Kind::generated: {
            const auto beyond =
                beyond_form(*language->system, family, task.certificate.empty_axiom);
            if (!beyond) return;
            why = "the system " + language->name + " is not of the family: " + *beyond;
            break;
        }
        case Kind::united:
        case Kind::concatenation:
        case Kind::star:
        case Kind::plus:
        case Kind::reversal:
        case Kind::image:
            for (const Language& part : language->parts) must_be_closed(task, part);
            return;
        case Kind::intersection:
            for (const auto regular : {&is_seen_regular, &is_of_finite_systems})
                for (const std::size_t i : {0u, 1u})
                    if (regular(task, language->parts[i]))
                        return must_be_closed(task, language->parts[1 - i]);
            return task.refuse(why);
        case Kind::difference:
            for (const auto regular : {&is_seen_regular, &is_of_finite_systems})
                if (regular(task, language->parts[1]))
                    return must_be_closed(task, language->parts[0]);
            return task.refuse(why);
        case Kind::inverse_image:
            if (family == "ET0L") return must_be_closed(task, language->parts[0]);
            break;
        default:
            break;
    }
    if (!is_of_finite_systems(task, language)) task.refuse(why);
}

}  // namespace

void check_closed(const Obligation& task) {
    static constexpr std::array extended = {"E0L", "ET0L", "EDT0L"};
    if (!std::count(extended.begin(), extended.end(), task.statement.family)) task.wrong_kind();
    must_be_closed(task, task.language());
}

void check_cases(const Obligation& task) {
    const auto& all = all_families();
    const std::string& family = task.statement.family;
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](Family each) { return to_string(each) == family; });
    if (found == all.end()) task.refuse("no proof by cases is known for " + family);
    const auto words = finite_words(task);
    FamilyObstruction obstruction = read_obstruction(task.reader, task.proof.at("obstruction"));
    obstruction.family = *found;
    obstruction.empty_axiom = task.certificate.empty_axiom;
    obstruction.language =
        make_finite_language(task.certificate.alphabet, {words.begin(), words.end()});
    if (const auto flaw = flaw_in(obstruction, task.budget)) task.refuse(*flaw);
}

/// All families are closed under reversal, and it is its own inverse.
void check_reversal(const Obligation& task) {
    if (task.language()->kind != Tree::Kind::reversal)
        task.refuse("the language is not a reversal");
    Statement part = task.statement;
    part.languages = task.language()->parts;
    check_proof(task.part(part, task.holds, task.proof.at("proof")));
}

/// The lengths of the words are infinitely many, and so few that they hold no arithmetic progression; but those
/// of an infinite context-free language do (Parikh 1966).
void check_sparse(const Obligation& task) {
    const Language& language = task.language();
    if (task.statement.family != "REG" && task.statement.family != "CF")
        task.refuse("this shows nothing of " + task.statement.family);
    if (language->kind != Tree::Kind::generated || !is_d0l(*language->system))
        task.refuse("the language is not given by a D0L system");
    const Growth growth = growth_of(*language->system);
    if (growth.name != "exponential" && (growth.name != "polynomial" || growth.degree < 2))
        task.refuse("the lengths grow no faster than n");
}

/// A propagating system derives the empty word from no other.
void check_empty_word(const Obligation& task) {
    if (!task.statement.family.starts_with('P'))
        task.refuse("a system of the family " + task.statement.family +
                    " may derive the empty word");
    if (task.certificate.empty_axiom) task.refuse("the empty word may be the axiom");
    if (!task.contains(task.language(), {})) task.refuse("the empty word is not in the language");
}

namespace {

/// The systems of a statement about sequences.
std::pair<const System&, const System&> d0l_pair(const Obligation& task) {
    if (!is_d0l(task.system(0)) || !is_d0l(task.system(1))) task.refuse("a system is not D0L");
    return {task.system(0), task.system(1)};
}

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

/// The next word of a D0L system. Throws BoundReached if it has more letters than `longest`.
Word next(const System& system, const Word& word, const Budget& budget,
          std::size_t longest = 10'000'000) {
    Word longer;
    budget.check();
    for (const Symbol a : word) {
        const Word& image = system.tables.front()[a].front();
        if (longer.size() + image.size() > longest)
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

/// The system of the generations first, first + step, first + 2 step, ... Letters that are not accessible stay as they are.
NamedSystem section(const System& system, std::uint64_t first, std::uint64_t step,
                    const Budget& budget) {
    System part = system;
    part.axiom = generation(system, system.axiom, first, budget);
    auto& images = part.tables.front();
    for (Symbol a = 0; a < images.size(); ++a) images[a] = {{a}};
    for (const Symbol a : accessible_letters(system, system.axiom))
        images[a] = {generation(system, {a}, step, budget)};
    return {"", std::make_shared<const System>(std::move(part))};
}

}  // namespace

void check_sections(const Obligation& task) {
    for (const Language& language : task.statement.languages)
        if (language->kind != Tree::Kind::generated || !is_d0l(*language->system))
            task.refuse("a language is not given by a D0L system");
    const System& left = *task.language(0)->system;
    const System& right = *task.language(1)->system;
    std::vector<Progression> numbers_left, numbers_right;
    for (const Field& each : task.proof.at("words").list()) {
        const auto [one, other] = each.pair();
        numbers_left.push_back({one.number(), 0});
        numbers_right.push_back({other.number(), 0});
        if (generation(left, left.axiom, one.number(), task.budget) !=
            generation(right, right.axiom, other.number(), task.budget))
            each.refuse("these generations are not the same word");
    }
    for (const Field& each : task.proof.at("sections").list()) {
        each.only({"left", "step", "right", "stride", "proof"});
        const Progression one{each.at("left").number(), each.at("step").number()};
        const Progression other{each.at("right").number(), each.at("stride").number()};
        if (one.step == 0 || other.step == 0) each.refuse("a section goes on");
        Statement equal;
        equal.kind = Statement::Kind::equal_sequences;
        equal.systems = {section(left, one.first, one.step, task.budget),
                         section(right, other.first, other.step, task.budget)};
        const auto balance = task.part(equal, true, each.at("proof"));
        if (!is_d0l(balance.system(0)) || !is_d0l(balance.system(1)))
            each.refuse("a section is not D0L");
        if (balance.proof.at("by").text() != "balance") balance.wrong_kind();
        check_proof(balance);
        numbers_left.push_back(one);
        numbers_right.push_back(other);
    }
    if (!covers_all(numbers_left)) task.refuse("a generation of the left system is in no section");
    if (task.statement.kind == Statement::Kind::equal && !covers_all(numbers_right))
        task.refuse("a generation of the right system is in no section");
}

namespace {

void append(Word& word, const Word& more) { word.insert(word.end(), more.begin(), more.end()); }

/// The D0L system whose language a proof about linear growth is about.
const System& linear_system(const Obligation& task, const Language& language) {
    if (language->kind != Tree::Kind::generated || !language->system || !is_d0l(*language->system))
        task.refuse("the language is not given by a D0L system");
    return *language->system;
}

/// L(G) as a regular expression: single words, and u v* x where three words of a section are ux, uvx and uvvx.
/// Lemma: if g(ux) = uvx and g(uvx) = uvvx, then g(u v^k x) = u v^(k+1) x for all k (deterministic_regularity.cpp; it is about words only).
Language progressions(const Obligation& task, const System& system) {
    const std::uint64_t first = task.proof.at("first").number(),
                        period = task.proof.at("period").number();
    if (period == 0) task.proof.at("period").fail("expected a number above 0");
    if (first > furthest || period > furthest)
        throw BoundReached(Bound::method,
                           "the progressions begin or repeat too late to be checked");
    std::vector<Word> words{system.axiom};
    std::size_t letters = 0;
    while (words.size() < first + 3 * period) {
        words.push_back(next(system, words.back(), task.budget));
        letters += words.back().size();
        task.budget.check_memory(letters * sizeof(Symbol), "the words of a period");
    }
    Language all = words_of({words.begin(), words.begin() + static_cast<std::ptrdiff_t>(first)});
    for (std::uint64_t n = first; n < first + period; ++n) {
        const Word& one = words[static_cast<std::size_t>(n)];
        const Word& two = words[static_cast<std::size_t>(n + period)];
        const Word& three = words[static_cast<std::size_t>(n + 2 * period)];
        if (two.size() <= one.size())
            task.refuse("word " + std::to_string(n + period) + " is no longer than word " +
                        std::to_string(n));
        std::size_t place = 0;
        while (place < one.size() && one[place] == two[place]) ++place;
        const auto at = static_cast<std::ptrdiff_t>(place);
        const auto more = static_cast<std::ptrdiff_t>(two.size() - one.size());
        const Word before(one.begin(), one.begin() + at), behind(one.begin() + at, one.end()),
            repeated(two.begin() + at, two.begin() + at + more);
        Word once = before, twice = before;
        append(once, repeated);
        append(once, behind);
        append(twice, repeated);
        append(twice, repeated);
        append(twice, behind);
        if (once != two || twice != three)
            task.refuse("words " + std::to_string(n) + ", " + std::to_string(n + period) + " and " +
                        std::to_string(n + 2 * period) +
                        " do not have one factor more and more often");
        const Language star = combination(Tree::Kind::star, {words_of({repeated})});
        all = combination(
            Tree::Kind::united,
            {all, combination(Tree::Kind::concatenation,
                              {combination(Tree::Kind::concatenation, {words_of({before}), star}),
                               words_of({behind})})});
    }
    return all;
}

}  // namespace

void check_same_progressions(const Obligation& task) {
    Statement regular = task.statement;
    for (Language& language : regular.languages)
        if (!is_regular(language)) language = progressions(task, linear_system(task, language));
    check_derivatives(task.part(regular, true, task.proof));
}

void check_regular_progressions(const Obligation& task) {
    if (task.statement.family != "REG" && task.statement.family != "CF")
        task.refuse("this shows nothing of " + task.statement.family);
    progressions(task, linear_system(task, task.language()));
}

/// The powers in the words of a section are not of one period; see CERTIFICATES.md for the theorem.
void check_unequal_powers(const Obligation& task) {
    if (task.statement.family != "REG")
        task.refuse("this shows nothing of " + task.statement.family);
    const System& system = linear_system(task, task.language());
    const Growth growth = growth_of(system);
    if (growth.name != "polynomial" || growth.degree != 1)
        task.refuse("the lengths do not grow linearly");
    const std::uint64_t first = task.proof.at("first").number(),
                        step = task.proof.at("step").number();
    if (step == 0) task.proof.at("step").fail("expected a number above 0");
    if (step > furthest) throw BoundReached(Bound::method, "the section is too wide to be checked");
    const Word begun = generation(system, system.axiom, first, task.budget);
    // What stands in the section, the powers among it by their places, and what is on either side of them left out.
    Word made, between;
    std::size_t period = 0, end = 0;
    bool has_period = true;
    const auto add = [&](const Word& word, bool is_power) {
        if (word.empty()) return;
        if (is_power && period == 0)
            for (period = 1; word.size() % period != 0 ||
                             !std::equal(word.begin() + static_cast<std::ptrdiff_t>(period),
                                         word.end(), word.begin());)
                ++period;
        if (period == 0) return;
        append(between, word);
        if (!is_power) return;
        end = between.size();
        if (word.size() % period != 0) has_period = false;
    };
    for (const Field& field : task.proof.at("parts").list()) {
        const auto parts = field.list();
        if (parts.size() != 3) field.fail("expected three words");
        const Word left = task.reader.word(parts[0]), word = task.reader.word(parts[1]),
                   right = task.reader.word(parts[2]);
        Word longer = left;
        append(longer, word);
        append(longer, right);
        if (generation(system, word, step, task.budget) != longer)
            parts[1].refuse("in the steps of the section it becomes something else");
        for (const std::size_t i : {0u, 2u})
            if (const Word side = i == 0 ? left : right;
                generation(system, side, step, task.budget) != side)
                parts[i].refuse("it does not stay as it is");
        append(made, word);
        add(left, true);
        add(word, false);
        add(right, true);
    }
    if (made != begun) task.proof.at("parts").refuse("they are not the first word of the section");
    for (std::size_t i = period; i < end && has_period; ++i)
        has_period = between[i] == between[i - period];
    if (has_period) task.refuse("one period goes through all powers");
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

std::map<Overhang, std::size_t> read_states(const Obligation& task) {
    const Field field = task.proof.at("states");
    const std::uint64_t bound = task.proof.at("bound").number();
    std::map<Overhang, std::size_t> states;
    for (const Field& each : field.list()) {
        each.only({"ahead", "word"});
        const std::string& ahead = each.at("ahead").text();
        if (ahead != "left" && ahead != "right") each.at("ahead").fail("expected left or right");
        Overhang state{ahead == "left", task.reader.word(each.at("word"))};
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
void check_balance(const Obligation& task) {
    const auto [left, right] = d0l_pair(task);
    if (task.proof.has("accepts")) {
        const Field repeats = task.proof.at("accepts");
        repeats.only({"steps", "earlier"});
        if (repeats.at("steps").number() <= repeats.at("earlier").number())
            repeats.refuse("nothing repeats before it begins");
    }
    if (left.axiom != right.axiom) task.refuse("the axioms differ");
    const auto letters = accessible_letters(left, left.axiom);
    const auto states = read_states(task);
    const std::size_t refusal = states.size();
    task.budget.check_memory(letters.size() * (refusal + 1) * (refusal + 1) / 8, "the automaton");
    Relations start;
    for (const Symbol a : letters) {
        const auto& image = right.tables.front()[a];
        if (image.size() != 1) task.refuse("a letter has two images in the right system");
        BooleanMatrix relation(refusal + 1);
        relation.set(refusal, refusal);
        for (const auto& [state, number] : states) {
            const auto next = with_letter(state, left.tables.front()[a].front(), image.front());
            const auto place = next ? states.find(*next) : states.end();
            relation.set(number, place == states.end() ? refusal : place->second);
        }
        start.emplace(a, std::move(relation));
    }
    const auto leaves = [&, &axiom = left.axiom](const Relations& relations) {
        return !relation_of(axiom, relations, refusal + 1).at(0, 0);
    };
    if (some_relations(left, start, refusal + 1, leaves, task.budget))
        task.proof.at("states").refuse(
            "a word of the sequence does not lead through these overflows back to the empty one");
}

void check_finite_sequences(const Obligation& task) {
    constexpr std::size_t most = 50'000'000;  // letters of the words together
    const auto [left, right] = d0l_pair(task);
    std::set<Word> known;
    std::uint64_t letters = 0;
    Word one = left.axiom, other = right.axiom;
    for (std::uint64_t generation = 0;; ++generation) {
        task.budget.check();
        if (one != other) task.refuse("generation " + std::to_string(generation) + " differs");
        if (!known.insert(one).second) return;  // equal words give equal words from here on
        letters += one.size() + 16;
        if (letters > most)
            throw BoundReached(Bound::method, "the words of the sequences are too long");
        task.budget.check_memory(letters * sizeof(Symbol), "the words of the sequences");
        one = next(left, one, task.budget, most);
        other = next(right, other, task.budget, most);
    }
}

void check_lengths_differ(const Obligation& task) {
    const Field field = task.proof.at("generation");
    const Integer generation = field.integer();
    if (length_of_generation(task.system(0), generation, task.budget) ==
        length_of_generation(task.system(1), generation, task.budget))
        field.refuse("both words are of the same length");
}

void check_difference(const Obligation& task) {
    const auto [left, right] = d0l_pair(task);
    if (!task.proof.has("position")) return check_lengths_differ(task);
    const Integer generation = task.proof.at("generation").integer();
    if (generation > 100'000)
        throw BoundReached(Bound::method, "the letters of generation " + to_string(generation) +
                                              " are not looked up");
    const Integer position = task.proof.at("position").integer();
    const auto one = letter_of_generation(left, generation.to_uint64(), position, task.budget);
    const auto other = letter_of_generation(right, generation.to_uint64(), position, task.budget);
    if (one == other)
        task.proof.at("position")
            .refuse(one ? "both words have the same letter there" : "neither word is so long");
}

}  // namespace algae::verify
