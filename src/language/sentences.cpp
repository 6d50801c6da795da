#include <algorithm>
#include <set>

#include "dimension/dimension.hpp"
#include "language/detail/finite_family.hpp"
#include "language/detail/judge.hpp"
#include "language/detail/proof.hpp"

// Proofs in sentences: one function for each kind of step.
//
// A step says its own sentence behind those of the parts that it rests on, or in front of them where it
// announces them. Parts that two sides share are said once. Sentences are made with marks around words and
// terms, which `latex` sets as mathematics and `sentences` takes out.

namespace algae {

std::string marked(const std::string& term) { return term_begins + term + mark_ends; }

std::string marked_word(const Alphabet& alphabet, const Word& word) {
    return word_begins + spell(alphabet, word) + mark_ends;
}

std::string plain(std::string sentence) {
    std::erase_if(sentence,
                  [](char c) { return c == word_begins || c == term_begins || c == mark_ends; });
    return sentence;
}

namespace {

using Kind = LanguageTree::Kind;
using Lines = std::vector<std::string>;

constexpr std::size_t longest_shown = 240;  // characters of a derivation on one line
constexpr int digits_shown = 12;            // of a dimension

std::string number(std::uint64_t value) { return marked(std::to_string(value)); }

/// "3 steps".
std::string several(std::uint64_t count, const std::string& noun) {
    return number(count) + ' ' + noun + (count == 1 ? "" : "s");
}

/// "none of the 3 words of the language is it", "the only word of the language is another".
std::string none_of(std::uint64_t count, const std::string& which) {
    return count == 1 ? "the only word" + which + " is another"
                      : "none of the " + number(count) + " words" + which + " is it";
}

/// "generation 0 is", "generations 0 to 3 are": those before a number that is not 0.
std::string generations(std::uint64_t end) {
    return end == 1 ? "generation " + number(0) + " is"
                    : "generations " + number(0) + " to " + number(end - 1) + " are";
}

/// "what the letters derive in 3 steps does to the states of its automaton what they derive in 2".
std::string relations(const Repeated& letters) {
    return "what the letters derive in " + several(letters.step, "step") +
           " does to the states of its automaton what they derive in " +
           (letters.one_table ? number(letters.earlier) : "fewer");
}

/// "log 4 / log 3 = 1.261859507143".
std::string dimension_text(const DimensionFormula& formula) {
    const std::string decimal = formula.decimal(digits_shown);
    if (formula.ratio_sum()) return decimal + ", the s of " + formula.text();
    return formula.text() + (formula.rational() ? "" : " = " + decimal);
}

std::string agree(const std::string& left, const std::string& right) {
    return left + " and " + right + " agree in " + std::to_string(digits_compared) +
           " digits, but no proof that they are equal was found.";
}

std::string sign_between(Order order) {
    return order == Order::equal ? " = " : order == Order::less ? " < " : " > ";
}

/// The text of a value of a bound name.
struct ValueText {
    const Alphabet& alphabet;

    std::string operator()(const Language& value) const { return unnamed_text(value, alphabet); }
    std::string operator()(const std::shared_ptr<const SourceSystem>& value) const {
        return system_text(*value, alphabet);
    }
    std::string operator()(const Morphism& value) const {
        return algae::to_string(value, alphabet);
    }
    std::string operator()(const std::vector<std::pair<Symbol, std::vector<Word>>>& value) const {
        return "{ " +
               joined(value, "; ",
                      [&](const auto& one) {
                          return alphabet.name(one.first) + " -> " +
                                 algae::to_string(words_language(one.second), alphabet);
                      }) +
               " }";
    }
    std::string operator()(const Word& value) const { return spell(alphabet, value); }
    std::string operator()(const Integer& value) const { return algae::to_string(value); }
};
class Sentences {
public:
    explicit Sentences(const Alphabet& alphabet) : alphabet_(alphabet) {}

    Lines of(const Proof& proof) const {
        Sentences inner(alphabet_);
        std::visit(inner, proof.step);
        return std::move(inner.lines_);
    }

    Lines of(const Answer& answer) const { return answer.proof ? of(*answer.proof) : answer.tried; }

    // --- The words of finite languages ---

    void operator()(const steps::Value& said) {
        const std::string inner = unnamed_text(said.language, alphabet_);
        const std::string value = said.count > steps::Value::most_shown
                                      ? "a set of " + std::to_string(said.count) + " words"
                                      : to_string(words_language(said.words), alphabet_);
        say(marked((said.language->name.empty() ? "" : said.language->name + " = ") +
                   (inner == value ? inner : inner + " = " + value)) +
            ".");
    }
    void operator()(const steps::Sifted& said) {
        for (const Part& member : said.members)
            if (lines_.size() < steps::Sifted::most_shown) add(*member);
    }

    // --- Words and languages ---

    void operator()(const steps::Listed& said) { say(is_in(said, said.in) + "."); }
    void operator()(const steps::Generated& said) {
        say(word(said.derivation.words.back()) + " is in " + generated(said.system) +
            (said.derivation.words.size() == 1 ? ": it is the axiom."
                                               : ": " + arrows(said.derivation) + "."));
    }
    void operator()(const steps::NotGenerated& said) {
        say(word(said.word) + " is not in " + generated(said.system) + ": " +
            reason(said.word, said.why) + ".");
    }
    void operator()(const steps::Factored& said) {
        say(is_in(said, true) + ": it is " + cut(said.word, said.ends) + ".");
    }
    void operator()(const steps::NotFactored& said) {
        say(is_in(said, false) +
            (said.language->kind == Kind::concatenated
                 ? ": no way to cut it in two has the parts in the two languages."
                 : ": it cannot be cut into words of " + language(said.language->parts[0]) + "."));
    }
    void operator()(const steps::HasPreimage& said) {
        say(is_in(said, true) + ": it is the image of " + word(said.source) + ".");
    }
    void operator()(const steps::HasNoPreimage& said) {
        say(is_in(said, false) + ": no word of " + language(said.language->parts[0]) +
            " has this image.");
    }
    void operator()(const steps::OfPowers& said) {
        const auto& numbers = said.language->powers->numbers;
        if (!said.values)
            return say(is_in(said, false) + ": no word of it of this length is this one.");
        std::string values;
        for (std::size_t i = 0; i < numbers.size(); ++i)
            values +=
                (i > 0 ? ", " : "") + numbers[i].name + " = " + std::to_string((*said.values)[i]);
        say(is_in(said, true) + ": " + marked(values) + ".");
    }
    void operator()(const steps::OtherLetters& said) {
        say("The complement is over the letters " +
            joined(said.letters, ", ", [&](Symbol a) { return letter(a); }) + ", and " +
            letter(said.letter) + " is another one.");
    }
    void operator()(const steps::HasNoImage& said) {
        say("A letter of " + word(said.word) + " has no image.");
    }
    /// What it comes to is said unless it is plain from the parts.
    void operator()(const steps::FromParts& said) {
        if (said.image) say("The image of " + word(said.word) + " is " + word(*said.image) + ".");
        add(said.parts);
        const Kind kind = said.language->kind;
        const bool is_plain =
            kind == Kind::united || kind == Kind::intersected || kind == Kind::difference;
        if (!is_plain || !said.language->name.empty()) say("So " + is_in(said, said.in) + ".");
    }

    // --- Derivations ---

    void operator()(const steps::Derives& said) {
        const auto& words = said.derivation.words;
        say(derives(said.system, word(words.front()), word(words.back()), words.size() - 1) +
            (words.size() > 1 || said.with_context ? ": " + arrows(said.derivation) : "") + ".");
    }
    void operator()(const steps::DerivesNot& said) {
        if (!said.steps)
            say(word(said.from) + " does not derive " + word(said.word) + " by " +
                marked(said.system) + " in any number of steps.");
        else if (said.reached)
            say((said.with_context ? marked(said.system) + ": " : "") + word(said.from) + " ==> " +
                word(*said.reached) + " in " + several(*said.steps, "step") +
                ", and nothing else.");
        else if (said.with_context)
            say("No choice of rules of " + marked(said.system) + " makes " + word(said.word) +
                " of " + word(said.from) + " in " + several(*said.steps, "step") +
                ": all words were derived.");
        else
            say((said.several_tables ? "No choice of tables and rules makes "
                                     : "No choice of rules makes ") +
                word(said.word) + " of " + word(said.from) + " in " + several(*said.steps, "step") +
                ": the factors of it that the letters derive in so many steps do not make it up.");
    }
    void operator()(const steps::InSomeStep& said) { add(*said.membership); }
    void operator()(const steps::Rewrites& said) {
        const std::string line =
            derives(said.system, marked(said.words.front()), marked(said.words.back()), said.steps);
        if (!said.holds)
            say(line + ", and nothing else.");
        else
            say(line + (said.steps > 1 && said.all_shown ? ": " + arrows_between(said.words) : "") +
                ".");
    }
    void operator()(const steps::Develops& said) {
        say(marked(said.system) + ", with its environments: " + arrows_between(said.words) +
            (said.holds ? "." : ", and nothing else."));
    }
    void operator()(const steps::Likely& said) {
        const std::string derived = marked(said.system) + ": " + marked(said.from) + " derives " +
                                    several(said.words, "word") + " in " +
                                    several(said.steps, "step");
        if (said.probability.is_zero())
            say(derived + ", and " + marked(said.to) + " is none of them: its probability is " +
                number(0) + ".");
        else
            say(derived + "; the probability of " + marked(said.to) + " is " +
                marked(to_string(said.probability)) +
                ", the sum over its derivations of the products of the rules' probabilities.");
    }

    // --- Sequences, growth and dimension ---

    void operator()(const steps::SameSequence& said) {
        const std::size_t states = said.balance.states.size();
        say("Generation by generation the words of " + marked(said.left) + " and " +
            marked(said.right) +
            " are the same: along each of them the images by the two rules get apart by at most " +
            several(said.balance.bound, "letter") + ", and " +
            (states == 1 ? "the one overflow that occurs suffices"
                         : "the " + number(states) + " overflows that occur suffice") +
            " for all generations.");
    }
    void operator()(const steps::OtherSequence& said) {
        const SequenceDifference& difference = said.difference;
        say("Generation " + number(difference.generation) +
            " is the first that differs: " + marked(said.left) + " has " + word(difference.left) +
            " and " + marked(said.right) + " has " + word(difference.right) + " from position " +
            marked(to_string(difference.from)) + " on.");
    }
    void operator()(const steps::SameGrowth& said) {
        say("The lengths of generations " + number(0) + " to " +
            number(said.bound == 0 ? 0 : said.bound - 1) +
            " are the same; both obey one recurrence whose order is the number of letters of both "
            "systems together, so all lengths are.");
    }
    void operator()(const steps::OtherGrowth& said) {
        say("In generation " + number(said.difference.generation) + " the lengths are " +
            marked(to_string(said.difference.left)) + " and " +
            marked(to_string(said.difference.right)) + ".");
    }
    void operator()(const steps::ComparedNumbers& said) {
        const auto side = [](const Expression& term, const std::string& value) {
            return marked(to_text(term)) + (to_text(term) == value ? "" : " is " + marked(value));
        };
        const std::string left = side(said.said.left, said.left),
                          right = side(said.said.right, said.right);
        const bool is_plain = to_text(said.said.right) == said.right;
        say(is_plain ? left + "." : left + ", " + right + ".");
    }
    void operator()(const steps::ByRecurrences& said) {
        say("The difference of both sides obeys a linear recurrence of order " +
            joined(said.orders, " and ",
                   [](const auto& one) {
                       return number(one.second) + " at most in " + marked(one.first);
                   }) +
            "; it is 0 " +
            (said.orders.size() == 1
                 ? "for the first " + number(said.points) + " numbers, so it always is."
                 : "at the first " + number(said.points) + " points, so it is 0 everywhere."));
    }
    void operator()(const steps::StaysPositive& said) {
        const char* const larger = said.left_is_larger ? "left" : "right";
        const char* const smaller = said.left_is_larger ? "right" : "left";
        say("Let " + marked("u(n)") + " be the " + larger + " side minus the " + smaller +
            " one, n from the least number on; it obeys a linear recurrence of order " +
            number(said.order) + " at most. " +
            (said.from == 0 ? ""
                            : "For the first " + several(said.from, "number") +
                                  " this was worked "
                                  "out; let " +
                                  marked("u(0)") + " be the value behind them."));
        std::string last = "u";
        const auto sign = [&](bool strictly) { return strictly ? "positive" : "not negative"; };
        for (const Rational& root : said.roots) {
            const std::string next = last == "u" ? "v" : last + "'";
            const std::string factor = root == Rational(1) ? "" : to_string(root) + " ";
            say("Let " +
                marked(next + "(n) = " + last + "(n+1)" +
                       (root.is_zero() ? "" : " - " + factor + last + "(n)")) +
                ". If it is not negative, " + marked(last + "(n)") + " is " +
                sign(said.strictly && last == "u") + ", as " + marked(last + "(0)") + " is.");
            last = next;
        }
        std::string recurrence;
        const std::size_t length = said.recurrence.size();
        for (std::size_t i = length; i-- > 0;) {
            const Rational& times = said.recurrence[i];
            if (times.is_zero()) continue;
            recurrence += (recurrence.empty() ? "" : " + ") +
                          (times == Rational(1) ? "" : to_string(times) + " ") + last + "(n" +
                          (i == 0 ? "" : "+" + std::to_string(i)) + ")";
        }
        say(marked(last + "(n" + (length == 0 ? "" : "+" + std::to_string(length)) +
                   ") = " + (recurrence.empty() ? "0" : recurrence)) +
            " has no negative coefficient" +
            (length == 0
                 ? ""
                 : ", and the first " + several(length, "term") + (length == 1 ? " is " : " are ") +
                       sign(said.strictly && last == "u")) +
            ", so all are.");
    }
    void operator()(const steps::Grows& said) {
        say("The length of generation n of " + marked(said.system) + " grows like " +
            marked(said.order.text()) + ": " + to_string(said.order.kind) +
            (said.order.kind == GrowthKind::polynomial ? " of degree " + number(said.order.degree)
                                                       : "") +
            ".");
    }
    void operator()(const steps::Rises& said) {
        say("No rule of " + marked(said.system) + " erases, so no length falls" +
            (said.strictly ? ", and each of the " + number(said.sets) +
                                 " sets of letters that occur together has a letter with a longer "
                                 "successor."
                           : "."));
    }
    void operator()(const steps::RisesByLetters& said) {
        say(std::string(said.strictly ? "The lengths of " : "No length of ") + marked(said.system) +
            (said.strictly ? " rise" : " falls") + " up to generation " + number(said.generation) +
            ", and each letter occurs in generation " + number(said.generation + 1) +
            " at least as often as in it" +
            (said.strictly ? ", one whose descendants never vanish more often;" : ";") +
            " so it is of all generations after them.");
    }
    void operator()(const steps::ByAutomata& said) {
        std::string values;
        for (const auto& [name, value] : said.witness)
            values += (values.empty() ? "" : ", ") + name + " = " + to_string(value);
        if (!values.empty())
            say(std::string(said.holds ? "It is true for " : "It is false for ") + marked(values) +
                ".");
        const std::string automata = "utomata that read positions of the infinite word of " +
                                     marked(said.system) +
                                     " in the numeration of Dumont and Thomas";
        if (said.rows > 0)
            return say("Products of matrices with " + number(said.rows) +
                       (said.rows == 1 ? " row" : " rows") + ", made of a" + automata +
                       ", count the places; they decide it for all n.");
        say("A" + automata + " decide it, the largest with " + number(said.largest) +
            (said.largest == 1 ? " state." : " states."));
    }
    void operator()(const steps::ByBispecialFactors& said) {
        std::string sums;
        for (const auto& [n, sum] : said.sums)
            sums += (sums.empty() ? "" : ", ") + std::to_string(sum) + " for " + to_string(n);
        say("Cut into return words to its first letter, again and again, the infinite word of " +
            marked(said.system) +
            " comes back, so its bispecial factors are the images of finitely many. The sum of the "
            "multiplicities of those of n letters, which is the second difference of the numbers "
            "of factors, is 0 for all n" +
            (sums.empty() ? "." : " but for these: " + sums + "."));
        std::string linear = said.slope.is_zero() ? "" : to_string(said.slope) + " n";
        if (linear.empty())
            linear = to_string(said.constant);
        else if (!said.constant.is_zero())
            linear += said.constant > 0 ? " + " + to_string(said.constant)
                                        : " - " + to_string(-said.constant);
        say("So " + number(said.letters) + " letters make " + marked(linear) +
            " factors of n letters for all n from " + to_string(said.from) + " on.");
    }
    void operator()(const steps::ByRepetitions& said) {
        say("Cut into return words to its first letter, again and again, the infinite word of " +
            marked(said.system) +
            " comes back, so its longest repetitions are the images of finitely many, and their "
            "exponents have limits.");
        const std::string value = marked(said.exponent.text);
        say(said.factor ? "The greatest exponent is " + value + ", that of a factor of " +
                              to_string(said.factor->first) + " letters with the period " +
                              to_string(said.factor->second) + "."
                        : "Their least upper bound is " + value + ", which no factor reaches.");
    }
    void operator()(const steps::RepeatsForEver& said) {
        if (said.word.empty())
            return say("All powers of a word are factors of the infinite word of " +
                       marked(said.system) + ".");
        const std::string text = word(said.word);
        say("All powers of " + text + " are factors: its square is one, and " +
            (said.power == 1 ? "the morphism" : "the morphism, " + number(said.power) + " times,") +
            " takes it to a power of one of its conjugates.");
    }
    void operator()(const steps::Synchronised& said) {
        say("Each factor of " + number(said.delay + 1) +
            " letters has a place where every word whose image it stands in is cut, so " +
            marked(said.system) + " is circular with the synchronising delay " +
            number(said.delay) + ".");
    }
    void operator()(const steps::Falls& said) {
        say("Generation " + number(said.generation) + " of " + marked(said.system) + " has " +
            marked(to_string(said.before)) + " letters and the next one " +
            marked(to_string(said.after)) + ".");
    }
    void operator()(const steps::ComparedWords& said) {
        say(said.left == said.right
                ? "Both words are " + marked(said.left) + "."
                : "The words are " + marked(said.left) + " and " + marked(said.right) + ".");
    }
    void operator()(const steps::ByMorphism& said) {
        say("It is true for " + number(said.first) + ". The morphism " +
            marked(algae::to_string(said.step, alphabet_)) +
            " takes both sides to those for the next number, so it is true for all.");
    }
    void operator()(const steps::LimitSet& said) {
        const ExactDimension& found = *said.found;
        for (const std::string& condition : found.conditions)
            say(marked(said.system) + ": " + condition + ".");
        if (said.boundary)
            boundary(said);
        else if (said.bounds)
            certified(said);
        else if (found.status == ExactDimension::Status::exact)
            exactly("The dimension of the limit set of " + marked(said.system), *found.value, said);
        else if (found.status == ExactDimension::Status::upper_bound)
            at_most("The dimension of the limit set of " + marked(said.system), said);
        else if (found.status == ExactDimension::Status::none)
            say("The rules of " + marked(said.system) + " give no formula for the dimension.");
    }

    // --- Equality and inclusion ---

    void operator()(const steps::Identical&) { say("Both sides are the same expression."); }
    void operator()(const steps::SameValues& said) {
        add_known(said.left);
        add_new(Sentences(alphabet_).known(said.right));
    }
    void operator()(const steps::ValuesWithin& said) {
        add_known(said.left);
        for (const Part& member : said.members)
            if (lines_.size() < steps::ValuesWithin::most_shown) add_new(of(*member));
    }
    void operator()(const steps::OtherValues& said) {
        add_known(said.left);
        add_new(Sentences(alphabet_).known(said.right));
        say(word(said.word) + " is in one and not in the other.");
    }
    void operator()(const steps::SameAutomata& said) {
        say("Both are regular, and their minimal automata, with " + several(said.states, "state") +
            ", are the same.");
    }
    void operator()(const steps::NothingOutside& said) {
        say("Both are regular, and the minimal automaton of " + language(said.left) + " without " +
            language(said.right) + " accepts nothing.");
    }
    void operator()(const steps::Distinguished& said) {
        lines_ = of(said.in_left);
        add_new(of(said.in_right));
    }
    void operator()(const steps::SameDeterministic& said) {
        const LanguageEquality& found = said.equality;
        if (found.sections.size() == 1 && found.words.empty())
            say("Both sequences have the same words in the same order: the overflows of the "
                "images by the two rules stay within " +
                several(found.sections.front().balance.bound, "letter") + ".");
        else
            say("Generation by generation the words are paired by the numbers of their letters: " +
                several(found.words.size(), "single word") + " and " +
                several(found.sections.size(), "section") +
                " of the sequences, and all that is paired is equal.");
    }
    void operator()(const steps::WithinDeterministic& said) {
        const std::string left = marked(said.left->system->name),
                          right = marked(said.right->system->name);
        if (!said.words.empty())
            say(joined(said.words, ", ",
                       [&](const auto& pair) {
                           return "Word " + number(pair.first) + " of " + left + " is word " +
                                  number(pair.second) + " of " + right;
                       }) +
                ".");
        for (const SectionMatch& match : said.sections)
            say("Word " + term_of(match.section.left, match.section.step) + " of " + left +
                " is word " + term_of(match.section.right, match.section.stride) + " of " + right +
                " for all n: the overflows of the images by the powers of the rules stay within " +
                several(match.balance.bound, "letter") + ".");
    }
    /// "3 + 2n".
    std::string term_of(std::uint64_t first, std::uint64_t step) const {
        const std::string multiple = (step == 1 ? "" : std::to_string(step)) + "n";
        return marked(first == 0 ? multiple : std::to_string(first) + " + " + multiple);
    }
    void operator()(const steps::SameProgressions& said) {
        say(progressions(said.language, said.first, said.period));
        say("So it is regular, and its minimal automaton is that of " + language(said.other) + ".");
    }
    void operator()(const steps::RegularProgressions& said) {
        say(progressions(said.language, said.first, said.period));
        say("So it is regular" +
            std::string(said.family == "REG" ? "." : ", and regular languages are context-free."));
    }
    std::string progressions(const Language& of, std::uint64_t first, std::uint64_t period) const {
        return "From word " + number(first) + " of " + language(of) + " on, each word and those " +
               number(period) + " and " + number(2 * period) +
               " generations later are ux, uvx and uvvx for some u, v and x, and so the next ones "
               "have v three times, four times, ... .";
    }
    void operator()(const steps::UnequalPowers& said) {
        std::string power;
        const auto add = [&](const Word& part, bool repeated) {
            if (part.empty()) return;
            power += (power.empty() ? "" : " ") +
                     (repeated ? "(" + spell(alphabet_, part) + ")^n" : spell(alphabet_, part));
        };
        for (const SectionOfPowers::Part& part : said.section.parts) {
            add(part.left, true);
            add(part.word, false);
            add(part.right, true);
        }
        const std::string name = language(said.language);
        say("Word " + term_of(said.section.first, said.section.step) + " of " + name + " is " +
            marked(power) + " for all n.");
        say("A D0L language has at most a constant times N words of N letters or less. If it is "
            "regular, it is a finite "
            "union of languages xy*z (Paun and Salomaa 1995), and the powers in infinitely many "
            "of these words lie in one power of y, so that one period goes through all of them, "
            "from the first one to the last one (Fine and Wilf 1965).");
        say("That is not so here, so " + name + " is not " + said.family + ".");
    }
    void operator()(const steps::WithinRegular& said) {
        if (said.constructed) say(construction(*said.constructed));
        say("Every word of " + language(said.left) + " is in " + language(said.right) + ": " +
            relations(said.letters) + ", and no generation before leaves it.");
    }
    void operator()(const steps::ByInduction& said) {
        for (const Answer& member : said.members) add_new(of(member));
        const std::string other = "Every other word of " + language(said.left);
        if (said.from) {
            say(other +
                " comes in one step from a shorter word of it, by induction on the length. "
                "Up to the length " +
                number(*said.from) + " this is worked out for each.");
            return say(
                "If a table makes n letters of x letters, it makes n + p k of x + p, where p is "
                "the period of the lengths and k the length of a successor; so it is true of "
                "all.");
        }
        if (said.counted.empty())
            return say(other +
                       " comes in one step from a shorter word of it, by induction on the length: "
                       "by successors that are not empty, one of them longer than one letter.");
        const std::string counted = joined(said.counted, ", ", [&](Symbol a) { return letter(a); });
        say(other + " comes in one step from a word of it with fewer letters " + counted +
            ", by induction on their number: each of these becomes a word with one of them at "
            "least, and some letter a word with one more than it is.");
    }
    void operator()(const steps::SamePowers& said) {
        const std::string sequence = marked(said.sequence);
        if (said.system.empty())
            return say("Both are the words " + sequence + " for n = " + number(0) + ", " +
                       number(1) + ", ...");
        say("Word number n of " + marked(said.system) + " is " + sequence +
            ", by induction: it is so for n = " + number(0) +
            ", and the rules make of it the same word for n + " + number(1) + ".");
    }
    void operator()(const steps::BothInclusions& said) {
        lines_ = of(*said.there);
        add_new(of(*said.back));
    }

    void operator()(const steps::Invariant& said) {
        for (const auto& [system, automaton] : said.closed)
            say("An automaton with " + several(automaton->states(), "state") +
                " accepts the axiom of " + marked(system->name) +
                " and all that a word which it accepts becomes in one step, so every word of " +
                generated(system->name) + ".");
        const bool is_itself = said.left->kind == Kind::generated && said.left->name.empty();
        const std::string words =
            is_itself
                ? "It accepts no word"
                : "With " +
                      std::string(said.closed.size() == 1 ? "it in the place of the system "
                                                          : "them in the place of the systems ") +
                      language(said.left) + " has no word";
        const bool is_empty =
            !said.word &&
            (!said.right || (said.right->kind == Kind::words && said.right->words.empty()));
        if (said.word)
            say((is_itself ? "It does not accept "
                           : words.substr(0, words.size() - std::string("has no word").size()) +
                                 "does not have ") +
                word(*said.word) + ".");
        else
            say(words + (is_empty ? "." : " outside " + language(said.right) + "."));
    }
    void operator()(const steps::ByRules& said) {
        const std::string left = marked(said.left->system->name),
                          right = marked(said.right->system->name);
        const auto axiom = [](const SourceSystem& system) -> const Word& {
            return system.tables ? system.tables->axiom : system.interactive->axiom;
        };
        const Word& axiom_word = axiom(*said.left->system);
        const bool has_tables =
            said.left->system->tables && said.left->system->tables->tables.size() > 1;
        say((has_tables ? "All rules of each table of " + left + " are rules of one table of "
                        : "All rules of " + left + " are rules of ") +
            right +
            (axiom_word == axiom(*said.right->system)
                 ? ", and both systems have the same axiom."
                 : ", which derives " + this->word(axiom_word) + ", the axiom of " + left + ".") +
            " So " + right + " derives all that " + left + " does.");
    }
    void operator()(const steps::LinearSystems& said) {
        for (const Language& side : {said.left, said.right})
            if (side->kind == Kind::generated)
                say("At most one letter of a word of " + language(side) +
                    " is not constant, the first or the last one, so the language is regular.");
        say(said.equal ? "Both sides have the same minimal automaton."
                       : "No word of " + language(said.left) + " is outside " +
                             language(said.right) + ".");
    }
    void operator()(const steps::ByFacts& said) {
        for (const steps::ByFacts::Fact& fact : said.facts) {
            add_new(of(*fact.proof));
            say("So " + language(fact.language) + " is " + language(fact.equal) +
                ", which may stand in its place.");
        }
        add_new(of(*said.proof));
    }

    // --- Finite, empty, size ---

    void operator()(const steps::Counted& said) {
        add_known(said.known);
        say(language(said.language) + " has " + marked(to_string(said.count)) +
            (said.count == 1 ? " word" : " words") +
            (said.by_automaton ? ": so many its automaton accepts." : "."));
    }
    void operator()(const steps::NoWord& said) {
        add_known(said.known);
        say(language(said.language) +
            (said.by_automaton ? " is regular, and its minimal automaton accepts no word."
                               : " has no word."));
    }
    void operator()(const steps::FiniteConstruction& said) {
        say(construction(said.tables));
        say("The language of this system is finite.");
    }
    void operator()(const steps::FoundWord& said) {
        say(word(said.word) + " is a word of " + language(said.language) +
            (said.derivation ? ": " + arrows(*said.derivation) : "") + ".");
    }
    void operator()(const steps::Disjoint& said) {
        say("No word of " + language(said.language) + " is in " + language(said.other) + ": " +
            relations(said.letters) + ", and no generation before has such a word.");
    }
    void operator()(const steps::NoTerminals& said) {
        say(construction(said.tables));
        say("No sequence of tables makes terminals of all letters of its axiom.");
    }
    void operator()(const steps::InfiniteRound& said) {
        const std::string rules = joined(said.rules, ", ", [&](const auto& rule) {
            return letter(rule.first) + " -> " + word(rule.second);
        });
        say(generated(said.system) + " is infinite: by " + rules + " the letter " +
            letter(said.rules.front().first) + " comes back with " + letter(said.other) +
            " beside it, which never disappears; so n rounds give n letters and more.");
    }
    void operator()(const steps::Measured& said) {
        const std::string start = word(said.start.words.back());
        const bool by_length =
            std::all_of(said.weights.begin(), said.weights.end(),
                        [](std::int64_t weight) { return weight == 0 || weight == 1; });
        std::string rules;
        for (const auto& [a, rule] : said.rules) {
            if (!rules.empty()) rules += ", ";
            if (!rule.left.empty()) rules += word(rule.left) + " < ";
            rules += letter(a) + (rule.right.empty() ? "" : " > " + word(rule.right)) + " -> " +
                     word(rule.successor);
        }
        say(generated(said.system) + " is infinite: an automaton with " +
            several(said.automaton->states(), "state") + " accepts " + start + " of generation " +
            number(said.start.words.size() - 1) + " and what each word that it accepts becomes" +
            (rules.empty() ? "" : " where letters choose " + rules) + ", and " +
            (by_length
                 ? "every such step makes words longer."
                 : "every such step raises the sum of weights along the transitions that a word "
                   "takes, so no word comes twice."));
    }
    void operator()(const steps::InfiniteTables& said) {
        if (said.constructed) say(construction(*said.tables));
        const auto name = [&](Symbol a) {
            return marked_word(said.constructed ? *said.tables->system.alphabet : alphabet_, {a});
        };
        say((said.constructed ? language(said.tables->language) : generated(said.system)) +
            " is infinite: a derivation of " + (said.constructed ? "it" : marked(said.system)) +
            " goes round from " + name(said.endless.again) + " to " + name(said.endless.again) +
            " and " + name(said.endless.other) +
            ", which lasts until it becomes a terminal; n rounds give n letters and more.");
    }
    void operator()(const steps::Pumped& said) {
        const auto bracketed = [&](const Word& word) { return "(" + spell(alphabet_, word) + ")"; };
        say(language(said.language) + " is infinite: it has " +
            marked(bracketed(said.prefix) + bracketed(said.middle) + "^n" +
                   bracketed(said.suffix)) +
            " for every n, since its automaton is in the same state before and after " +
            word(said.middle) + ".");
    }
    void operator()(const steps::LongerPowers& said) {
        say(language(said.language) + " is infinite: its words get longer with " +
            marked(said.language->powers->numbers.front().name) + ".");
    }
    void operator()(const steps::InfinitePart& said) {
        add(*said.part);
        const Kind kind = said.whole->kind;
        say("So " + language(said.whole) + " is infinite" +
            (kind == Kind::concatenated ? ", as the other part has a word."
             : kind == Kind::reversed   ? "."
                                        : ", as a part of it is."));
    }
    void operator()(const steps::InfiniteSize& said) { add(*said.infinite); }

    // --- Families ---

    void operator()(const steps::HasForm& said) {
        say(language(said.language) + " is given by " + with_article(said.family) + " system.");
    }
    void operator()(const steps::FiniteOfFamily& said) {
        add_known(said.known);
        const auto form = system_form(said.family);
        if (!form)
            say("It is finite, and finite languages are " + chomsky(said.family) + ".");
        else if (form->interactive)
            say("It is finite: contexts longer than its words let each word be rewritten to the "
                "next one.");
        else
            say("It is finite: a letter that is no terminal is rewritten to its words.");
    }
    void operator()(const steps::RegularOperations& said) {
        say(language(said.language) +
            " is made of finite languages by operations under which the regular languages are "
            "closed" +
            (said.family == "CF" ? ", and regular languages are context-free." : "."));
    }
    void operator()(const steps::ContextFree& said) {
        const bool is_powers = said.language->kind == Kind::powers;
        if (said.language->kind == Kind::generated && !said.language->system->grammar.empty())
            return say(language(said.language) + " is given by a context-free grammar.");
        if (said.language->kind == Kind::generated)
            return say("Each letter of " + marked(said.language->system->name) +
                       " may stay as it is, so a derivation may rewrite one letter at a time: its "
                       "rules are those of a context-free grammar.");
        say(language(said.language) +
            (is_powers ? " is context-free: a grammar makes the powers of each number from outside "
                         "inwards, as each stands in at most two exponents, and those of two "
                         "numbers do not cross."
                       : " is made of context-free languages by operations under which these are "
                         "closed."));
    }
    void operator()(const steps::PowersBeyond& said) {
        const std::string name = language(said.language), family = chomsky(said.family);
        const std::string n = marked(said.language->powers->numbers.front().name);
        const auto letters = [&] {
            return joined(said.why.letters, ", ", [&](Symbol a) { return letter(a); });
        };
        switch (said.why.why) {
            case BeyondFamily::Why::lengths:
                say("The lengths of the words of " + name + " grow faster than linearly in " + n +
                    ". The lengths of an infinite " + family +
                    " language have all numbers of some arithmetic progression among them (Parikh "
                    "1966).");
                break;
            case BeyondFamily::Why::blocks:
                say("The letters " + letters() +
                    " stand in one power each. A morphism that erases all other letters leaves " +
                    (said.family == "REG"
                         ? "powers of two letters, where how often the first stands there tells "
                           "how "
                           "often the second does, for infinitely many numbers"
                         : "powers of three letters, which grow together: no two short parts of a "
                           "long word can be repeated in all three (pumping lemma)") +
                    ".");
                break;
            case BeyondFamily::Why::marker:
                say("The letter " + letters() +
                    " stands in each word once. Before and behind it are powers that grow with " +
                    n +
                    ", so what stands before it tells what follows, and this for infinitely many " +
                    n + ": an automaton would need a state for each.");
                break;
        }
        say("So " + name + " is not " + family + ".");
    }
    void operator()(const steps::HasEmptyWord& said) {
        add(*said.member);
        say("A system without erasing rules derives no shorter word than its axiom, which is not "
            "empty; so " +
            language(said.language) + " is not " + said.family + ".");
    }
    void operator()(const steps::Sparse& said) {
        const std::string name = language(said.language), family = chomsky(said.family);
        say("The lengths of the words of " + name + " grow like " + marked(said.order.text()) +
            ", so they are infinitely many, and the share of them among the numbers up to x tends "
            "to " +
            number(0) + ".");
        say("The lengths of an infinite " + family +
            " language have all numbers of some arithmetic progression among them (Parikh 1966), "
            "which is a share that does not tend to " +
            number(0) + ".");
        say("So " + name + " is not " + family + ".");
    }
    void operator()(const steps::FiniteFamily& said) {
        add_known(said.known);
        if (said.answer->witness) {
            say("The system with " + marked(to_string(*said.answer->witness)) + " generates it.");
        } else {
            const Lines cases = marked_proof(*said.answer->obstruction);
            lines_.insert(lines_.end(), cases.begin(), cases.end());
        }
    }
    void operator()(const steps::GeneratedBy& said) {
        if (said.found)
            say("Let " + marked(said.system->name) + " be " +
                marked(system_text(*said.system, alphabet_)) + ". It generates " +
                language(said.language) + ".");
        else
            say("The " + said.family + " system " + marked(said.system->name) + " generates " +
                language(said.language) + ".");
        add(*said.equal);
    }
    void operator()(const steps::ByClasses& said) {
        const std::string name = language(said.language);
        const std::string each = said.family.find('T') != std::string::npos ? "a table of " : "";
        say("Call words that are not empty of one class if they may stand for each other in all "
            "words "
            "of " +
            name + "; there are " + number(said.classes.size()) + " classes, those of " +
            joined(said.classes, ", ", [&](const Word& first) { return word(first); }) + ".");
        say("Suppose that a system of the family " + said.family + " generates " + name +
            ". The successors of each letter" + (said.apart.empty() ? "" : ", by each table,") +
            " are of some of these classes, and every choice of them for the letters of a word "
            "of " +
            name + " makes a word of it.");
        std::size_t left = steps::ByClasses::most_shown;
        add_case(said.root, "", left);
        if (said.size > steps::ByClasses::most_shown)
            say("These are the first of " + number(said.size) + " cases.");
        if (!said.apart.empty())
            say("By all of the choices that are left no word of " + name + " derives both " +
                word(said.apart[0]) + " and " + word(said.apart[1]) + ", so no axiom does.");
    }
    void add_case(const steps::ByClasses::Case& said, const std::string& indent,
                  std::size_t& left) {
        if (left == 0) return;
        --left;
        if (said.letter) return say(indent + "No class is left for " + letter(*said.letter) + ".");
        if (!said.apart.empty())
            return say(indent +
                       "By the classes that are left no word of the language derives both " +
                       word(said.apart[0]) + " and " + word(said.apart[1]) + ", so no axiom does.");
        if (said.cases.empty()) return say(indent + "The other choices are possible.");
        Word made;
        std::map<std::string, std::set<std::string>> rules;
        for (std::size_t i = 0; i < said.images.size(); ++i) {
            made.insert(made.end(), said.images[i].begin(), said.images[i].end());
            rules[letter(said.word[i])].insert(word(said.images[i]));
        }
        const std::string used = joined(rules, "; ", [](const auto& of) {
            return of.first + " -> " +
                   joined(of.second, " | ", [](const std::string& image) { return image; });
        });
        say(indent + word(said.word) + " becomes " + word(made) +
            ", which is not in the language, by " + used +
            (said.cases.size() == 1 ? ", so that class is not used."
                                    : ", so one of these classes is not used:"));
        for (const auto& each : said.cases)
            add_case(each, said.cases.size() == 1 ? indent : indent + "  ", left);
    }
    void operator()(const steps::ByLengths& said) {
        const std::string name = language(said.language);
        say("Suppose that a system of the family " + said.family + " generates " + name +
            ". It has one letter, and a step takes x letters to a sum of x lengths of successors.");
        if (!said.sums.empty()) return sums_of_lengths(said, name);
        const std::string period = number(said.period);
        say("From some length on, the lengths of " + name + " have the least period " + period +
            ". Of each table that does not erase, the lengths have one rest when they are divided "
            "by "
            "a divisor d of the period, and their products with long lengths, and all that differ "
            "by d, are lengths.");
        std::size_t left = steps::ByLengths::most_shown;
        for (const auto& target : said.targets) {
            if (target.length)
                say("No such table makes " + several(*target.length, "letter") +
                    " of fewer letters, and no table that erases makes them:");
            else if (target.rest)
                say("By finitely many such tables " + long_lengths(*target.rest) +
                    " do not come from long ones, nor from tables that erase:");
            else
                say("With one table d is the period, as all long lengths come from long ones:");
            if (target.frames.empty()) say("  No rest is possible.");
            for (const auto& frame : target.frames) {
                say("  Let the rest for d = " + number(frame.modulus) + " be " +
                    number(frame.rest) + ".");
                add_case(frame.root, "    ", left);
            }
        }
        if (said.size > steps::ByLengths::most_shown)
            say("These are the first of " + number(said.size) + " cases.");
        if (said.targets.size() > 1)
            say("Only one of the two can be the axiom, so " + name + " is not " + said.family +
                ".");
        else
            say("So " + name + " is not " + said.family + ".");
    }
    std::string long_lengths(const steps::ByLengths::Rest& rest) {
        return "the long lengths with rest " + number(rest.first) + " modulo " +
               number(rest.second);
    }
    void sums_of_lengths(const steps::ByLengths& said, const std::string& name) {
        say("It has the empty word, so a rule erases: a sum of lengths of successors comes of "
            "every "
            "longer word. So " +
            name + " has the lengths of a set that is closed under sums, and of the axiom.");
        const auto sum = [&](std::size_t i) {
            return number(said.sums[i].first) + " + " + number(said.sums[i].second);
        };
        say("But " + sum(0) + " is not a length of " + name + ". Without the length " +
            number(said.sums[0].first) + " " + sum(1) + " leads out; without " +
            number(said.sums[0].second) + " " + sum(2) + " does.");
        say("So " + name + " is not " + said.family + ".");
    }
    void add_case(const steps::ByLengths::Case& said, const std::string& indent,
                  std::size_t& left) {
        if (left == 0) return;
        --left;
        if (said.length)
            return say(indent + "By the lengths that are left " + number(*said.length) +
                       " does not come from a shorter one.");
        if (said.rest)
            return say(indent + "By the lengths that are left " + long_lengths(*said.rest) +
                       " do not come from long ones.");
        std::map<std::size_t, std::size_t> counts;
        std::size_t total = 0;
        for (const std::size_t n : said.sum) {
            ++counts[n];
            total += n;
        }
        const std::string used = joined(counts, " + ", [](const auto& of) {
            return of.second == 1 ? number(of.first) : number(of.second) + " x " + number(of.first);
        });
        say(indent + number(said.sum.size()) + " letters become " + used + " = " + number(total) +
            ", which is not a length" +
            (said.cases.empty()       ? ", and none of these can be left out."
             : said.cases.size() == 1 ? ", so one of these is left out."
                                      : ", so one of these is left out:"));
        for (const auto& each : said.cases)
            add_case(each, said.cases.size() == 1 ? indent : indent + "  ", left);
    }
    void operator()(const steps::LettersOnCycles& said) {
        const std::string name = language(said.language);
        say("Suppose that a D0L system generates " + name +
            ". Its lengths grow linearly, as those of an infinite regular language do not grow "
            "faster. So there are letters whose "
            "descendants grow; every word has some of them, and at most a fixed number.");
        if (said.word.empty())
            say("But it has the empty word, which has no letter.");
        else
            say("But each letter of " + word(said.word) +
                " stands any number of times in words of " + name +
                ": it is on a cycle of the minimal automaton.");
        say("So " + name + " is not " + said.family + ".");
    }
    void operator()(const steps::LinearBlocks& said) {
        const std::string name = language(said.language);
        const std::string n = marked(said.language->powers->numbers.front().name);
        say("Suppose that " + name + " is " + said.family +
            ". Two successors of a letter by one table would change the number of one letter only, "
            "which "
            "those of the other letters fix; so each table has one successor of each letter.");
        say("It is a power of the same letter, as the letters must stay in their order and only "
            "finitely "
            "many words lack one; and so it takes word " +
            n +
            " to a word whose exponents are s times as large, s being 0, or a number of the "
            "table.");
        say("Exponents that grow linearly have the numbers of an arithmetic progression among "
            "them, which "
            "infinitely many primes divide (Dirichlet 1837), and the tables have finitely many s. "
            "So " +
            name + " is not " + said.family + ".");
    }
    void operator()(const steps::NotGeometric& said) {
        const std::string name = language(said.language);
        add(*said.infinite);
        say("Its lengths are a share of the numbers up to x that tends to " + number(0) +
            ". Two successors of the letter would make words of n + " + number(1) +
            " lengths between c n and d n of a word of n letters, for fixed numbers c and d: a "
            "share that does not. So " +
            (said.tables ? "each table takes n letters to s n for a number s of its own."
                         : "a step takes n letters to s n for one number s."));
        const std::string shown =
            joined(said.lengths, ", ", [](std::uint64_t n) { return number(n); });
        if (said.tables)
            say("The first lengths are " + shown +
                ". None of them makes the last one by an s that takes all lengths to lengths.");
        else
            say("But the first lengths, " + shown + ", are no geometric sequence.");
        say("So " + name + " is not " + said.family + ".");
    }
    void operator()(const steps::Dense& said) {
        const std::string name = language(said.language);
        say("The lengths of the words of an infinite D0L language grow at least linearly, so it "
            "has at "
            "most c N words of N letters and fewer.");
        say("In the minimal automaton of " + name +
            " two cycles share a state, or one follows another, so it has more words.");
        say("So " + name + " is not " + said.family + ".");
    }
    void operator()(const steps::Proportional& said) {
        const std::string name = language(said.language);
        say("The numbers of the letters in the words of " + name +
            " are multiples k v of one vector v. A step of a deterministic table multiplies k by a "
            "number "
            "that depends on the table only, so only finitely many primes divide numbers k.");
        say("The language is regular and infinite, so its k have the numbers of an arithmetic "
            "progression among them, which infinitely many primes divide (Dirichlet 1837).");
        say("So " + name + " is not " + said.family + ".");
    }
    void operator()(const steps::OfReversal& said) {
        add(*said.part);
        say("Axiom and successors written backwards generate the words backwards, so " +
            language(said.language) +
            (said.holds ? " is " + said.family + " too." : " is not " + said.family + " either."));
    }
    void operator()(const steps::Constructed& said) { say(construction(said.tables)); }

    // --- Codes and palindromes ---

    void operator()(const steps::Code& said) {
        const std::string name = language(said.language);
        const std::string how =
            said.words > 0 ? "" : ", as an automaton that reads two words at once shows";
        if (said.prefix)
            return say("No word of " + name + " begins with another, and " + word({}) +
                       " is none of them" + how + ".");
        say("No word is a product of words of " + name + " in two ways: " +
            (said.words > 0 ? "none of the remainders that two factorisations leave of each other "
                              "is a word of it (Sardinas and Patterson 1953)."
                            : "an automaton that cuts a word in two ways at once finds none."));
    }
    void operator()(const steps::TwoFactorisations& said) {
        if (said.word.empty())
            return say(word({}) + " is in " + language(said.language) +
                       ", so every product of its words is one of more words, too.");
        say(word(said.word) + " is a product of words of " + language(said.language) +
            " in two ways: " + cut(said.word, said.left) + " and " + cut(said.word, said.right) +
            ".");
    }
    void operator()(const steps::Beginning& said) {
        say(word(said.word) + " and its beginning " + word(said.beginning) + " are both words of " +
            language(said.language) + ".");
    }
    void operator()(const steps::Palindrome& said) {
        if (!said.place)
            return say(word(said.word) + " read backwards is " + word(said.word) + ".");
        say("Letter number " + number(*said.place + 1) + " of " + word(said.word) + " is " +
            letter(said.word[*said.place]) + ", and the same letter from its end is " +
            letter(said.word[said.word.size() - 1 - *said.place]) + ".");
    }

    // --- Several statements, and statements about all values ---

    void operator()(const steps::FromStatements& said) {
        for (const steps::FromStatements::Known& part : said.parts) {
            say(part.text + (part.answer.truth == Truth::proved ? ":" : " does not hold:"));
            indent(of(part.answer));
        }
    }
    void operator()(const steps::ByInstance& said) {
        const bool is_of_numbers = std::all_of(
            said.values.begin(), said.values.end(),
            [](const BoundValue& value) { return std::holds_alternative<Integer>(value.is); });
        if (is_of_numbers) {
            say(std::string(said.universal ? "It is false for " : "It is true for ") +
                values(said) + ":");
            argue(said);
            return;
        }
        say("The " + std::string(said.searched.undecided == 0 ? "least " : "") + kind_of(said) +
            " is " + values(said) + ", of size " + number(said.size) + before(said.searched) + ".");
        argue(said);
        if (!said.other) return;
        say("The first " + kind_of(said) + " whose language has a word that is not empty is " +
            values(*said.other) + ", of size " + number(said.other->size) + ".");
        argue(*said.other);
    }
    void operator()(const steps::ByCases& said) {
        say("Each of the " + number(said.instances) + " instances was decided.");
    }
    void operator()(const steps::ByFamilyRules& said) { lines_ = said.lines; }
    void operator()(const steps::AllSparse& said) {
        say("The lengths of " + marked(said.system) +
            " grow faster than linearly, so they are infinitely many, and the share of them among "
            "the "
            "numbers up to x tends to " +
            number(0) + ".");
        say("The lengths of an infinite " + chomsky(said.family) +
            " language have all numbers of some arithmetic progression among them (Parikh 1966), "
            "which is a share that does not tend to " +
            number(0) + ".");
    }
    void operator()(const steps::AllLonger& said) {
        const std::string name = marked(said.system);
        say("The second word of " + name +
            " is w x, w being the first one, and x is not empty. By n steps w x becomes the word "
            "of "
            "generation n and what x becomes, which is not empty, as no rule of " +
            name + " erases. So each word is longer than the one before.");
    }
    void operator()(const steps::ByDerivations& said) {
        using RuleKind = steps::DerivationRule::Kind;
        const auto uses = [](const auto& self, const steps::DerivationRule& rule,
                             RuleKind kind) -> bool {
            return rule.kind == kind ||
                   std::any_of(rule.parts.begin(), rule.parts.end(),
                               [&](const auto& part) { return self(self, part, kind); });
        };
        const auto used = [&](RuleKind kind) {
            return std::any_of(said.cases.begin(), said.cases.end(), [&](const auto& trees) {
                return std::any_of(trees.begin(), trees.end(),
                                   [&](const auto& tree) { return uses(uses, tree, kind); });
            });
        };
        if (said.split)
            say("By " + marked(said.conditions.at(*said.split)) +
                " its letters become words that make up the word derived: " +
                several(said.cases.size(), "case") + ".");
        if (used(RuleKind::product))
            say("Two words derive in as many steps words that together are derived from both, as "
                "letters "
                "are replaced independently of their neighbours.");
        if (used(RuleKind::chain))
            say("What derives a word that derives another one derives that, in as many steps as "
                "both.");
        if (said.shows == steps::ByDerivations::Shows::length)
            say("No letter is erased, so no word becomes shorter.");
        if (said.shows == steps::ByDerivations::Shows::uniqueness)
            say("Every letter has one successor, so in as many steps a word derives one word "
                "only.");
        say("So the statement follows from its conditions" +
            std::string(said.split ? ", in each case." : "."));
    }
    void operator()(const steps::ByEach& said) {
        for (std::size_t i = 0; i < said.proofs.size(); ++i) {
            say(marked(said.texts[i]) + ":");
            indent(of(*said.proofs[i]));
        }
    }
    void operator()(const steps::ByLetters& said) {
        say("It is true if " +
            joined(said.letters, ", ",
                   [&](const auto& one) {
                       return marked(one.first + " = {" + alphabet_.name(one.second) + "}");
                   }) +
            ":");
        indent(of(*said.proof));
        say("Union, concatenation and star commute with putting any languages in the place of the "
            "letters, so it is true of all languages.");
    }

private:
    static std::string kind_of(const steps::ByInstance& said) {
        return said.universal ? "counterexample" : "example";
    }
    static std::string before(const Searched& searched) {
        if (searched.undecided == 0) return "";
        return "; " + counted(searched.undecided, "smaller instance") +
               (searched.undecided == 1 ? " is" : " are") + " undecided";
    }
    void argue(const steps::ByInstance& said) {
        for (const Answer& member : said.members) indent(of(member));
        for (const Answer& condition : said.conditions) indent(of(condition));
        indent(of(said.body));
    }
    void indent(const Lines& lines) {
        for (const std::string& line : lines) say("  " + line);
    }

    std::string values(const steps::ByInstance& said) const {
        return joined(said.values, ", ", [&](const BoundValue& value) {
            const std::string text = std::visit(ValueText{alphabet_}, value.is);
            // What a system is is said in words.
            return std::holds_alternative<std::shared_ptr<const SourceSystem>>(value.is)
                       ? marked(value.name) + " = " + text
                       : marked(value.name + " = " + text);
        });
    }

    void say(std::string line) { lines_.push_back(std::move(line)); }
    void add(const Proof& proof) {
        const Lines more = of(proof);
        lines_.insert(lines_.end(), more.begin(), more.end());
    }
    void add(const std::vector<Part>& parts) {
        for (const Part& part : parts) add(*part);
    }
    /// Those that are not there yet.
    void add_new(const Lines& more) {
        for (const std::string& line : more)
            if (std::find(lines_.begin(), lines_.end(), line) == lines_.end()) say(line);
    }
    /// How the words of finite languages are known: each value is said once.
    void add_known(const std::vector<Part>& parts) {
        for (const Part& part : parts) {
            if (std::holds_alternative<steps::Value>(part->step))
                add_new(of(*part));
            else
                add(*part);
        }
    }
    Lines known(const std::vector<Part>& parts) {
        add_known(parts);
        return std::move(lines_);
    }

    std::string word(const Word& word) const { return marked_word(alphabet_, word); }
    /// The factors that end at these places.
    std::string cut(const Word& whole, const std::vector<std::size_t>& ends) const {
        std::string text;
        std::size_t from = 0;
        for (const std::size_t to : ends) {
            const auto begin = whole.begin();
            text += (text.empty() ? "" : " . ") + word({begin + static_cast<std::ptrdiff_t>(from),
                                                        begin + static_cast<std::ptrdiff_t>(to)});
            from = to;
        }
        return text;
    }
    std::string letter(Symbol a) const { return word({a}); }
    std::string language(const Language& language) const {
        return marked(to_string(language, alphabet_));
    }
    static std::string generated(const std::string& system) { return marked("L(" + system + ")"); }
    static std::string chomsky(const std::string& family) {
        return family == "CF" ? "context-free" : "regular";
    }

    template <class Step>
    std::string is_in(const Step& said, bool yes) const {
        return word(said.word) + (yes ? " is in " : " is not in ") + language(said.language);
    }

    static std::string derives(const std::string& system, const std::string& from,
                               const std::string& to, std::uint64_t steps) {
        return marked(system) + ": " + from + " ==> " + to + " in " + several(steps, "step");
    }

    static std::string arrows_between(const Lines& words) {
        std::string text;
        for (const std::string& each : words) text += (text.empty() ? "" : " => ") + marked(each);
        return text;
    }

    /// The words of a derivation with arrows between them, shortened if it is long.
    std::string arrows(const Derivation& derivation) const {
        std::string text;
        for (const Word& each : derivation.words) {
            if (plain(text).size() > longest_shown)
                return several(derivation.words.size() - 1, "step") + " of derivation, beginning " +
                       text + " => ...";
            text += (text.empty() ? "" : " => ") +
                    (each.size() > longest_shown ? several(each.size(), "letter") : word(each));
        }
        return text;
    }

    /// Why no generation has the word.
    std::string reason(const Word& word, const Membership& found) const {
        using enum Membership::Reason;
        const auto met = [&] { return letter(word[static_cast<std::size_t>(found.position)]); };
        switch (found.reason) {
            case foreign:
                return "the letter " + met() + " is in none of its words";
            case nonterminal:
                return met() + " is no terminal";
            case outgrown:
                return found.step == 0
                           ? "all its words are longer"
                           : generations(found.step) +
                                 " not this word, and from then on all words are longer";
            case periodic:
                return "generation " + number(found.step) + " is generation " +
                       number(found.earlier) + " again, and none before is this word";
            case exhausted:
                return "what the letters derive within it by any " + several(found.step, "table") +
                       " they derive by fewer, and none of the " + number(found.states) +
                       " families of factors has it";
            case short_words:
                if (found.states == 0) return "no rule erases, and the axiom is longer";
                return "no rule erases, so words do not get shorter, and " +
                       none_of(found.states, " with at most " + several(word.size(), "letter"));
            case all_words:
                return none_of(found.states, " of the language");
            default:
                return "the factors of it that the letters derive in " +
                       several(found.step, "step") + " are those that they derive in " +
                       number(found.earlier) + ", and no generation before has it";
        }
    }

    /// "A system for A | B is constructed (union): an ET0L system with 3 letters and 2 tables."
    std::string construction(const TableValue& tables) const {
        const std::string operations = joined(tables.operations, ", ");
        const ET0L& system = tables.system;
        return "A system for " + language(tables.language) +
               (operations.empty() ? " is at hand" : " is constructed (" + operations + ")") +
               ": " + with_article(family_name(system)) + " system with " +
               several(accessible_letters(system).size(), "letter") + " and " +
               several(system.tables.size(), "table") + ".";
    }

    /// How a number known exactly compares with the claimed one.
    void exactly(const std::string& what, const DimensionFormula& value,
                 const steps::LimitSet& said) {
        const std::string known = dimension_text(value), &claimed = said.claimed.text;
        const std::string line = what + " is " + marked(known);
        if (said.order == Order::unknown) {
            say(line + ".");
            return say(agree(marked(value.text()), marked(claimed)));
        }
        const std::string compared = sign_between(said.order) + claimed;
        const bool is_said = value.text() == claimed || known.ends_with(compared);
        say(line + (is_said ? "" : marked(compared)) + ".");
    }

    /// What certified bounds say.
    void certified(const steps::LimitSet& said) {
        const bool below =
            said.order == Order::greater ||
            (said.order == Order::equal && said.claimed.comparison == Comparison::at_least);
        say("The dimension of the limit set of " + marked(said.system) + " is at " +
            (below ? "least " : "most ") +
            marked(shortest_text(below ? said.bounds->low : said.bounds->high)) + ", by " +
            (below ? said.bounds->low_by : said.bounds->high_by) + ".");
    }

    /// What an upper bound says.
    void at_most(const std::string& what, const steps::LimitSet& said) {
        const ExactDimension& found = *said.found;
        const bool above_plane = exceeds_plane(found);
        const std::string bound =
            above_plane ? "2, as for every set in the plane" : dimension_text(*found.value);
        say(what + " is at most " + (above_plane ? bound : marked(bound)) + ".");
        if (said.order == Order::less ||
            (said.order == Order::equal && said.claimed.comparison == Comparison::at_most))
            return;
        say(said.order == Order::unknown
                ? agree(bound, marked(said.claimed.text))
                : "Whether it is smaller is not known: " + found.conditions.back() + ".");
    }

    void boundary(const steps::LimitSet& said) {
        const ExactDimension& found = *said.found;
        if (found.boundary)
            return exactly(
                "The dimension of the boundary of the limit set of " + marked(said.system),
                *found.boundary, said);
        say(found.status == ExactDimension::Status::exact &&
                    compare(found.value->enclosure(64), Ball(2, 64)) == Order::less
                ? "The limit set of " + marked(said.system) + " has the dimension " +
                      marked(dimension_text(*found.value)) +
                      " and no interior points: it is all boundary."
                : "The boundary of the limit set of " + marked(said.system) + " is not known.");
    }

    const Alphabet& alphabet_;
    Lines lines_;
};

}  // namespace

std::vector<std::string> marked_sentences(const Answer& answer, const Alphabet& alphabet) {
    return Sentences(alphabet).of(answer);
}

std::vector<std::string> sentences(const Answer& answer, const Alphabet& alphabet) {
    std::vector<std::string> lines = marked_sentences(answer, alphabet);
    for (std::string& line : lines) line = plain(std::move(line));
    return lines;
}

Judgement in_sentences(const Answer& answer, const Alphabet& alphabet) {
    return {answer.truth, sentences(answer, alphabet)};
}

std::vector<std::pair<std::string, std::string>> witness_of(const Answer& answer,
                                                            const Alphabet& alphabet, bool other) {
    std::vector<std::pair<std::string, std::string>> values;
    const auto* said = answer.proof ? std::get_if<steps::ByInstance>(&answer.proof->step) : nullptr;
    if (said && other) said = said->other.get();
    if (!said) return values;
    for (const BoundValue& value : said->values)
        values.emplace_back(value.name, std::visit(ValueText{alphabet}, value.is));
    return values;
}

}  // namespace algae
