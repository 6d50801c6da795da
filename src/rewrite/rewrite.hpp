#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "exact/exact.hpp"
#include "system/system.hpp"
#include "word/word.hpp"

// rewrite: derivation of systems whose words are not images of a fold: parameters, probabilities, tables with a choice, contexts
// of modules, systems within systems, and shape rules that divide boxes. Rules are compiled once to small programs; a
// step is then a pass over the word of modules, with as many threads as pay. Chance is a function of the seed and
// the position (`Draws`), so that a word never depends on threads.

namespace algae {

/// A letter together with the number of its parameters, numbered: F, F(x) and F(x,y) are three.
using ModuleKind = std::uint16_t;

class WordValues;

/// The kinds of modules of one system, and the words that its parameters hold.
class ModuleKinds {
public:
    /// The number of this letter with this many parameters; a new one if it is new. Throws
    /// BoundReached if there are more than 65,535. Logarithmic time.
    ModuleKind kind(Symbol letter, std::size_t arity);

    Symbol letter(ModuleKind kind) const { return letters_[kind]; }
    std::uint32_t arity(ModuleKind kind) const { return arities_[kind]; }
    std::size_t size() const { return letters_.size(); }

    /// The words and exact numbers that parameters stand for; none where all parameters are doubles.
    const WordValues* words() const { return words_.get(); }
    const std::shared_ptr<WordValues>& held() const { return words_; }
    void hold(std::shared_ptr<WordValues> words) { words_ = std::move(words); }

private:
    std::vector<Symbol> letters_;
    std::vector<std::uint32_t> arities_;
    std::map<std::pair<Symbol, std::size_t>, ModuleKind> numbers_;
    std::shared_ptr<WordValues> words_;
};

/// The bits of a parameter, in which a word is told from others (see WordValues).
inline std::uint64_t bits_of(double value) {
    std::uint64_t bits;  // std::bit_cast is younger than some libraries
    static_assert(sizeof bits == sizeof value);
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
}

/// Whether two parameters are equal: numbers, or the same word (see WordValues).
inline bool same_value(double a, double b) {
    return a == b || (a != a && b != b && bits_of(a) == bits_of(b));
}

/// A total order of parameters: numbers before words.
inline bool value_before(double a, double b) {
    if (a == a && b == b) return a < b;
    if (a != a && b != b) return bits_of(a) < bits_of(b);
    return a == a;
}

/// Memory for words: bytes that may be asked for in large pages where they are many, which takes a
/// fourth of the time to touch first. Throws std::bad_alloc.
void* word_memory(std::size_t bytes);
void free_word_memory(void* memory);

/// Memory for words that is not cleared before it is written.
template <class T>
struct Uncleared {
    using value_type = T;

    Uncleared() = default;
    template <class U>
    Uncleared(const Uncleared<U>&) {}
    T* allocate(std::size_t count) { return static_cast<T*>(word_memory(count * sizeof(T))); }
    void deallocate(T* memory, std::size_t) { free_word_memory(memory); }
    template <class U>
    void construct(U* place) {
        ::new (static_cast<void*>(place)) U;
    }
    template <class U, class... Parts>
    void construct(U* place, Parts&&... parts) {
        ::new (static_cast<void*>(place)) U(std::forward<Parts>(parts)...);
    }
    bool operator==(const Uncleared&) const = default;
};

/// A word of modules: the kinds of its modules, and all their parameters one after the other. How
/// many of these are a module's own its kind says, so offsets are only worked out where a step
/// looks at neighbours.
struct ModuleString {
    std::vector<ModuleKind, Uncleared<ModuleKind>> kinds;
    std::vector<double, Uncleared<double>> values;

    bool operator==(const ModuleString& other) const {
        return kinds == other.kinds &&
               std::equal(values.begin(), values.end(), other.values.begin(), other.values.end(),
                          same_value);
    }
    bool operator<(const ModuleString& other) const {
        if (kinds != other.kinds) return kinds < other.kinds;
        return std::lexicographical_compare(values.begin(), values.end(), other.values.begin(),
                                            other.values.end(), value_before);
    }
};

/// The letters of a word, without their parameters.
Word letters(const ModuleKinds& kinds, const ModuleString& word);

/// How numbers of parameters are kept. `doubles`: each operation is rounded, for figures. `exact`: rationals, sums of
/// rationals and square roots of one number, and enclosures of what is neither; nothing is rounded, and a comparison that enclosures do not decide is an error.
enum class Arithmetic { doubles, exact };

/// Values of parameters that a double does not hold: words, and in exact arithmetic numbers and enclosures. A parameter is
/// a double; one that is not a number stands for such a value, whose place in this list its bits say. Numbers on
/// their own are always finite, so nothing else is not a number. A word and an exact number are kept once: equal ones have equal
/// values. An enclosure has a place of its own for each operation that made one.
class WordValues {
public:
    explicit WordValues(Arithmetic arithmetic = Arithmetic::doubles) : arithmetic_(arithmetic) {}

    static bool is_held(double value) { return value != value; }
    static bool is_word(double value) { return is_held(value) && !(bits_of(value) & number_bit); }
    static bool is_held_number(double value) {
        return is_held(value) && (bits_of(value) & number_bit);
    }

    /// The value of a word, whose own parameters may be words of this list. Expected time linear in
    /// the word. Throws BoundReached if words stand in each other more than 100 deep, if the word
    /// would be printed with more modules than budget.letters, or if all words together take more
    /// than budget.memory.
    double value(ModuleString word, const Budget& budget);

    /// The word of a value that is one.
    const ModuleString& word(double value) const { return held(value).word; }

    bool is_exact() const { return arithmetic_ == Arithmetic::exact; }
    /// A number: itself where a double is just that, otherwise held. Throws BoundReached where all numbers together take
    /// more than the memory set.
    double number(const QuadraticNumber& value);
    double number(const Ball& value);
    void set_memory(std::uint64_t bytes) { memory_ = bytes; }

    /// What an operation made of these operands not long ago; values that are enclosures are not remembered. Constant time.
    std::optional<double> remembered(unsigned operation, double left, double right) const;
    void remember(unsigned operation, double left, double right, double value);

    /// The work of the operations so far that doubles do not do exactly: 1 for one on exact numbers, 10 for one on enclosures.
    std::uint64_t work() const { return work_; }
    /// Adds to the work. Throws BoundReached where it is more than `set_most_work` allows.
    void spend_work(std::uint64_t amount);
    void set_most_work(std::uint64_t most) { most_work_ = most; }

    /// What a number is; exactly one of both is there.
    struct Known {
        std::optional<QuadraticNumber> exact;
        std::optional<Ball> within;
    };
    Known known(double value) const;
    bool is_enclosure(double value) const;

    /// A number as it is printed: in exact arithmetic a finite decimal that is just that, or a fraction; of an
    /// enclosure the nearest double with dots behind it.
    std::string text(double value) const;

    /// Whether two parameters are equal; nothing where enclosures do not say it.
    std::optional<bool> equal(double left, double right) const;

private:
    static constexpr std::uint64_t number_bit = 0x0004'0000'0000'0000;

    struct Held {
        ModuleString word;
        std::uint64_t modules = 0;  // when it is printed: those of words within counted
        std::size_t depth = 0;      // of words within
    };
    const Held& held(double value) const;
    void spend(std::uint64_t bytes);

    Arithmetic arithmetic_;
    std::deque<Held> all_;
    std::unordered_multimap<std::uint64_t, std::size_t> places_;  // by a hash of the word
    std::uint64_t bytes_ = 0, memory_ = Budget::default_memory;
    std::deque<Known> numbers_;
    std::unordered_multimap<std::uint64_t, std::size_t> number_places_;  // by hash

    /// An operation that was done: its operands and its value. A later one may take its place.
    struct Done {
        std::uint64_t left = 0, right = 0;
        double value = 0;
        unsigned operation = UINT32_MAX;
    };
    static std::size_t slot(unsigned operation, double left, double right);
    std::vector<Done> done_;
    std::uint64_t work_ = 0, most_work_ = UINT64_MAX;
};

/// A parameter as it is printed: whole numbers below 10^21 as integers, others as the shortest
/// decimal that reads back as the same double, with an exponent where that is shorter.
///
/// Example: number_text(4.0) == "4"
/// Example: number_text(0.1 + 0.2) == "0.30000000000000004"
/// Example: number_text(1e-7) == "1e-7"
std::string number_text(double value);

/// Puts the nearest doubles in the places of exact numbers and of enclosures, also in words that are parameters; what is not 0 stays so. Nothing is
/// changed, and false is returned, where a number is too large for a double.
bool round_numbers(ModuleKinds& kinds, ModuleString& word);

/// Words of modules as text: `CB(1)A(8,7)`, with a blank only where two names written together would
/// be read otherwise; parameters that are words in quotes, `B("FF[+F]")`.
class ModuleText {
public:
    /// Both must outlive it and must not grow.
    ModuleText(const Alphabet& alphabet, const ModuleKinds& kinds)
        : alphabet_(alphabet), kinds_(kinds), spellings_(alphabet) {}

    /// Sends the word, nothing for the empty one; says whether there was anything to send.
    bool write(const ModuleString& word, TextSink& sink, const Budget& budget = {}) const;
    /// The word as one string, `ε` for the empty one.
    std::string text(const ModuleString& word) const;
    /// One module with its parameters.
    std::string text(ModuleKind kind, const double* values) const;

private:
    void add(std::string& out, ModuleKind kind, const double* values) const;
    void add(std::string& out, const ModuleString& word, std::size_t from, std::size_t to,
             const double*& values) const;

    const Alphabet& alphabet_;
    const ModuleKinds& kinds_;
    Spellings spellings_;
};

/// An expression that has no value for the parameters at hand: where and why.
struct Undefined {
    const Expression* at;
    std::string reason;         // "division by 0 in 'x/y'"
    bool is_undecided = false;  // it has a value, which enclosures do not tell
};

/// Parameters whose enclosures do not tell which rule applies, or which value a function has.
class UndecidedValue : public Error {
public:
    using Error::Error;
};

class InnerSystems;

/// What a program needs to know of words and exact numbers, where its system holds some.
struct WordsOfPrograms {
    InnerSystems* systems = nullptr;
    WordValues* exact = nullptr;                       // in exact arithmetic
    std::function<double(const ModuleWord&)> literal;  // the value of a word in quotes
    bool number = false;  // whether the program's value must be a number
};

/// An expression over numbered parameters, compiled: a row of instructions for a stack of doubles.
///
/// What has no parameters is worked out once, exactly where `evaluate` can; all else is arithmetic
/// of doubles, one rounding an operation. Angles are in degrees; sines, cosines and tangents of
/// multiples of 30 and 45 degrees that are rational are exact. `&` and `|` do not look at their
/// right side where the left one decides.
///
/// In exact arithmetic all of it is exact, or an enclosure of 512 bits; a comparison that these do not
/// decide is `Undefined`, and a number of more than 10,000 digits reaches a bound.
///
/// Of parameters that may be words (WordValues) a program makes no arithmetic and no comparison: that
/// is `Undefined`, as is `length` of a number.
class Program {
public:
    /// The number of a parameter, or nothing where the name is no parameter.
    using Numbering = std::function<std::optional<std::size_t>(const std::string&)>;

    /// `expression` must outlive the program. Throws what `evaluate` throws for parts without
    /// parameters.
    /// Without `words` all parameters must be numbers; words in the expression then have no value.
    Program(const Expression& expression, const Numbering& parameters, const Names& constants,
            const WordsOfPrograms& words = {});

    /// The value for these parameters: finite, or a word. Throws `Undefined`.
    double run(const double* parameters) const;

    /// Room for `run_many`, to be used again and again.
    using Columns = std::vector<std::vector<double>>;

    /// The values for `count` rows of parameters, given as columns, into `out`. False if some value
    /// on the way is not finite, or the system holds words; then `out` is of no use and `run` says, row
    /// by row, what holds.
    bool run_many(const std::vector<const double*>& parameters, std::size_t count, double* out,
                  Columns& room) const;

    /// The value, if it depends on no parameter.
    std::optional<double> constant() const;
    /// The numbers of the parameters that it reads, each once, in order.
    std::vector<std::size_t> reads() const;

    /// Whether they compute the same in the same way.
    bool operator==(const Program& other) const;

    enum class Operation : std::uint8_t {
        number,
        parameter,
        negate,
        invert,
        truth,
        abs,
        floor,
        ceil,
        sin,
        cos,
        tan,
        asin,
        acos,
        atan,
        sqrt,
        exp,
        log,
        add,
        subtract,
        multiply,
        divide,
        power,
        minimum,
        maximum,
        less,
        less_equal,
        greater,
        greater_equal,
        equal,
        unequal,
        both,
        either,
        skip_if_false,
        skip_if_true,
        length,
        generation
    };

private:
    struct Instruction {
        Operation operation;
        std::uint32_t index = 0;  // of a parameter or a system; where to go on after a skip
        double number = 0;
        const Expression* at = nullptr;
    };

    class Compiler;
    double run_with_held(const double* parameters) const;

    InnerSystems* systems_ = nullptr;  // where parameters may be words
    WordValues* exact_ = nullptr;      // in exact arithmetic
    std::vector<Instruction> instructions_;
    std::size_t depth_ = 0;  // of the stack
};

/// The value of an expression without parameters, if all that it is made of is exact: a comparison of roots is not, though
/// its value is 0 or 1. Throws what `evaluate` throws.
std::optional<Rational> exact_value(const Expression& expression, const Names& constants);

/// Whether the expression reads one of the names that `parameters` knows.
bool has_parameters(const Expression& expression, const Program::Numbering& parameters);

/// A successor ready to be copied: the kinds of its modules, their parameters as far as they are
/// constant, and programs for the others.
struct Successor {
    struct Slot {
        std::uint32_t at;  // index into values
        Program value;
    };
    /// A word that is written in between.
    struct Splice {
        std::uint32_t at, values_at;  // how many kinds and values stand before
        Program word;
        const Expression* expression;
    };
    std::vector<ModuleKind> kinds;
    std::vector<double> values;
    std::vector<Slot> slots;
    std::vector<Splice> splices;
    const Production* rule = nullptr;

    /// Whether every module gets the same modules from the same parameters.
    bool same_as(const Successor& other) const;
};

/// Writes a successor's modules behind a word, with these parameters of its rule. `words` are those that
/// parameters stand for. Throws `Undefined`, also where a splice gives no word.
void append(const Successor& successor, const double* parameters, const WordValues* words,
            ModuleString& to);

/// Rules with the same left side: they apply to the same modules in the same places. One of them
/// is used, picked by its probability where they have some.
struct Alternatives {
    /// A conjunct of the condition, looked at as soon as so many modules elsewhere are found.
    struct Conjunct {
        std::size_t elsewhere;
        Program holds;
    };
    std::vector<ModuleKind> left, right, elsewhere;
    std::size_t context = 0;                // modules in all three; brackets do not count
    std::size_t parameters = 0;             // of the predecessor and all three
    std::optional<Program> condition;       // over the parameters of all
    std::vector<Conjunct> conjuncts;        // the condition where there are modules elsewhere
    std::vector<std::uint32_t> successors;  // numbers of successors
    std::vector<Rational> probabilities;    // as many, or none
    std::vector<std::uint64_t> thresholds;  // see Draws; as many as probabilities

    bool has_same_context(const Alternatives& other) const {
        return left == other.left && right == other.right && elsewhere == other.elsewhere;
    }
};

/// The rules of a system, or of one of its tables, compiled: by kind of predecessor, those with
/// the longest context first and equally long ones in the order of the file.
struct RuleSet {
    std::vector<std::vector<Alternatives>> of;  // by kind; none: the module stays as it is
    bool has_contexts = false;                  // some rule looks at other modules
    bool has_conditions = false;
    bool has_probabilities = false;
};

/// The whole of a system, compiled.
struct CompiledRules {
    std::shared_ptr<const LSystem> system;  // the expressions that programs point into
    ModuleKinds kinds;
    std::vector<Successor> successors;  // number 0 is no successor: the module stays
    std::vector<RuleSet> tables;        // one where the system has no tables
    std::vector<char> ignored;          // by kind
    std::vector<char> opens, closes;    // by kind: [ and ]
    std::vector<char> sought;           // by kind: some rule looks for it elsewhere
    ModuleString axiom;
    std::string of;  // of a system within another: " of leaf", for messages
    std::shared_ptr<InnerSystems>
        inner;  // where parameters may be words; one within does not own it
};

/// Compiles a system. Throws Error for shape rules, `Diagnostics` for constant expressions without
/// a value and, where words stand in the axiom, what InnerSystems::word throws. Of rules that are the same twice only the first is kept, unless they have
/// probabilities. With `seen`, the kinds of words that other rules make, these keep their numbers and
/// their words. O(size of the system).
CompiledRules compiled_rules(const LSystem& system, const Budget& budget = {},
                             const ModuleKinds* seen = nullptr,
                             Arithmetic arithmetic = Arithmetic::doubles);

/// The numbers that a random derivation uses. Each depends on the seed, the generation and the
/// position of the module that is rewritten, and on nothing else: neither on the order of the work
/// nor on the machine, so a seed stands for one word everywhere.
///
/// The numbers of a generation g are those of SplitMix64 (Steele, Lea and Flood, Fast splittable
/// pseudorandom number generators, 2014) started from mix(mix(seed) + g): the one of position p
/// is mix(start + (p + 1) * 0x9E3779B97F4A7C15), 64 bits, where mix is its output function. A rule
/// with the probabilities p_1, p_2, ... before and with it is taken if the number, read as a binary
/// fraction from 0 up to 1, is the first below p_1 + p_2 + ...; sums are rounded down to 64 bits.
class Draws {
public:
    /// For the generation that is rewritten; the axiom is generation 0.
    Draws(std::uint64_t seed, std::uint64_t generation) : start_(mix(mix(seed) + generation)) {}

    /// The number for the module at this position, counted from 0.
    ///
    /// Example: Draws(1, 0).at(5) == Draws(1, 0).at(5)
    std::uint64_t at(std::uint64_t position) const { return mix(start_ + (position + 1) * golden); }

    /// The number by which the table of this step is picked.
    std::uint64_t of_table() const { return mix(~start_); }

    /// A number below `bound` (of at most 32 bits), all equally likely: the whole part of
    /// bound * number / 2^64.
    ///
    /// Example: Draws::scaled(std::uint64_t{1} << 63, 6) == 3
    static constexpr std::uint32_t scaled(std::uint64_t number, std::uint64_t bound) {
        return static_cast<std::uint32_t>(
            ((number >> 32) * bound + (((number & 0xFFFFFFFF) * bound) >> 32)) >> 32);
    }

private:
    static constexpr std::uint64_t golden = 0x9E3779B97F4A7C15;

    //> mix
    static constexpr std::uint64_t mix(std::uint64_t z) {
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
        return z ^ (z >> 31);
    }
    //< mix

    std::uint64_t start_;
};

/// How a derivation goes where the system leaves a choice.
struct RewritingChoices {
    std::uint64_t seed = 1;
    bool evenly = false;  // rules with the same left side and no probabilities are equally likely
    bool random_tables = false;  // in place of the schedule of the system
    unsigned threads = 0;        // 0: as many as the machine has. The word does not depend on it
    Arithmetic arithmetic = Arithmetic::doubles;
};

/// A step of a derivation and what came of each module.
struct TracedStep {
    ModuleString word;                   // after the step
    std::vector<std::uint32_t> lengths;  // by position before it: how many modules it became
    /// By position before it: where the modules of the contexts stand that its rule looked at, those elsewhere in
    /// the word with them; each once, from left to right. Brackets of contexts are not among them.
    std::vector<std::vector<std::size_t>> seen;
};

/// Derivation of parametric, stochastic and conditional systems, with and without contexts: any
/// LSystem but shape rules (Prusinkiewicz and Lindenmayer 1990, 1.7 to 1.10).
///
/// - A rule matches a module with the same letter and as many parameters, in its contexts (see IL),
///   with modules elsewhere that make its condition true (see Surroundings). A module that no rule
///   matches stays, with its parameters.
/// - Of the rules that match, those with the most modules in contexts and elsewhere come first, of
///   equally many the first in the file.
/// - Rules with the same contexts that match the same module are a choice. It is made by their
///   probabilities if these add up to 1 (see Draws), and is an Error otherwise.
/// - Parameters are numbers, computed as Program says: doubles, which are all finite, or exact. What has no value, such as a
///   division by 0, is an Error. Errors name the rule, the module with its parameters, the
///   generation that is rewritten and the position in it.
class Rewriting {
public:
    /// Throws what `compiled_rules` throws.
    /// The budget is for the words of systems within it that the axiom needs.
    explicit Rewriting(const LSystem& system, const RewritingChoices& choices = {},
                       const Budget& budget = {});
    explicit Rewriting(CompiledRules rules) : rules_(std::move(rules)) {}

    const ModuleString& axiom() const { return rules_.axiom; }
    const CompiledRules& rules() const { return rules_; }

    /// The word after a step from the word of `generation`, by the rules of a table. Linear in both
    /// words where there are no modules elsewhere. Throws as said above, and BoundReached if the word
    /// has more than budget.letters modules or takes more than budget.memory.
    ModuleString next(const ModuleString& word, std::uint64_t generation, std::size_t table = 0,
                      const Budget& budget = {}) const;

    /// The same step and what came of each module. Takes the time of a step with contexts.
    TracedStep traced(const ModuleString& word, std::uint64_t generation, std::size_t table = 0,
                      const Budget& budget = {}) const;

    /// The table that a step from this generation picks at random, all equally likely.
    std::size_t random_table(std::uint64_t generation) const;
    /// The table of the step from this generation where nobody says which: the schedule's, a random
    /// one where there is none or the choices want it.
    std::size_t own_table(std::uint64_t generation) const;

    /// A successor and how likely it is, exactly; number 0 means that the module stays.
    struct Outcome {
        std::uint32_t successor;
        Rational probability;
        std::vector<double> parameters;  // for the successor's programs
    };
    /// By position, what may become of each module of the word. Throws as `next` does.
    std::vector<std::vector<Outcome>> outcomes(const ModuleString& word, std::uint64_t generation,
                                               std::size_t table = 0,
                                               const Budget& budget = {}) const;
    /// Writes the modules of an outcome behind a word. Throws as `next` does.
    void append(const Outcome& outcome, const ModuleString& from, std::size_t position,
                std::size_t offset, std::uint64_t generation, ModuleString& to) const;

private:
    /// The word of a generation: `name` is how messages call it.
    std::string name_of(std::uint64_t generation) const;
    std::string refusal(const std::string& what, const Production& rule, ModuleKind kind,
                        const double* values, std::size_t position, std::uint64_t generation) const;
    [[noreturn]] void refuse(const std::string& what, const Production& rule, ModuleKind kind,
                             const double* values, std::size_t position,
                             std::uint64_t generation) const;
    [[noreturn]] void refuse(const Undefined& undefined, const Production& rule, ModuleKind kind,
                             const double* values, std::size_t position,
                             std::uint64_t generation) const;
    [[noreturn]] void refuse_both(const Alternatives& first, const Alternatives& second,
                                  ModuleKind kind, const double* values, std::size_t position,
                                  std::uint64_t generation) const;
    const Alternatives* matching(const RuleSet& set, const class Surroundings& around,
                                 ModuleKind kind, std::size_t position, std::uint64_t generation,
                                 std::vector<double>& parameters, std::vector<double>& others,
                                 std::vector<std::size_t>* seen = nullptr) const;
    std::uint32_t pick(const Alternatives& alternatives, std::uint64_t number) const;
    void check_choice(const Alternatives& alternatives, ModuleKind kind, const double* values,
                      std::size_t position, std::uint64_t generation) const;
    ModuleString next_in_context(const RuleSet& set, const ModuleString& word,
                                 std::uint64_t generation, const Budget& budget,
                                 TracedStep* trace = nullptr) const;

    friend class FreeStep;

    CompiledRules rules_;
    RewritingChoices choices_;
};

/// The word of generation n: of a system with tables by those in `tables`, one for each step, or by
/// its own ones where there are none. Throws as Rewriting::next does.
///
/// Example: derive(Rewriting(read_lsystem("axiom A(1); A(x) -> A(x*2)A(x)", "")), 3).kinds.size() == 8
ModuleString derive(const Rewriting& rewriting, std::uint64_t n,
                    const std::vector<std::size_t>& tables = {}, const Budget& budget = {});

/// The words of generations 0 to n, the table of each step, and what came of each module.
struct ModuleTrace {
    std::vector<ModuleString> words;
    std::vector<std::size_t> tables;
    std::vector<std::vector<std::uint32_t>> lengths;  // by step, as TracedStep has them
    std::vector<std::vector<std::vector<std::size_t>>> seen;
    /// Generation n would have taken more than `most` modules in all words together, so the trace
    /// ends before.
    bool goes_on = false;
};

/// The derivation that `derive` makes, step by step, as long as its words have at most `most` modules together. Throws as
/// Rewriting::next does otherwise.
///
/// Example: traced(Rewriting(read_lsystem("axiom A(1); A(x) -> A(x*2)A(x)", "")), 3).lengths[2].size() == 4
/// Example: traced(Rewriting(read_lsystem("axiom A(1); A(x) -> A(x*2)A(x)", "")), 30, {}, 100).goes_on
ModuleTrace traced(const Rewriting& rewriting, std::uint64_t n,
                   const std::vector<std::size_t>& tables = {}, std::uint64_t most = 1'000'000,
                   const Budget& budget = {});

/// By symbol, the expected number of its occurrences in generation n, exactly: the counts of the
/// axiom times the n-th power of the mean matrix, whose rows are the expected counts of what a
/// letter becomes (Prusinkiewicz and Lindenmayer 1990, 1.7; Harris 1963, II.2). n products of a
/// vector with the rules; numbers grow by O(1) digits a step.
///
/// Example: expected_counts(*as_s0l(read_lsystem("axiom F; F -(1/2)-> FF; F -(1/2)-> F", "")), 2)[0] == Rational(9, 4)
std::vector<Rational> expected_counts(const S0L& system, std::uint64_t n,
                                      const Budget& budget = {});

/// A word and how likely it is.
struct LikelyWord {
    ModuleString word;
    Rational probability;
};

/// All words of generation n with their exact probabilities, which add up to 1; shorter words first,
/// equally long ones by the names of their letters, then by their parameters. Rules without
/// probabilities that match together are an Error, unless the choices say that all are equally
/// likely. For systems with several tables each step takes the one in `tables`, without these that of the
/// schedule. There may be
/// exponentially many words of exponential length: throws BoundReached if they take more than
/// budget.memory, and otherwise as Rewriting::next does.
///
/// Example: distribution(Rewriting(read_lsystem("axiom F; F -(1/3)-> FF; F -(2/3)-> F", "")), 1)[1].probability == Rational(1, 3)
std::vector<LikelyWord> distribution(const Rewriting& rewriting, std::uint64_t n,
                                     const std::vector<std::size_t>& tables = {},
                                     const Budget& budget = {});
/// The same for the words that `from` derives, whose modules are numbered as those of the rewriting.
std::vector<LikelyWord> distribution(const Rewriting& rewriting, const ModuleString& from,
                                     std::uint64_t n, const std::vector<std::size_t>& tables = {},
                                     const Budget& budget = {});

/// The words of L(G) that the axiom derives in at most n steps, each once, in shortlex order of their
/// names: those of all generations up to n, by all tables, that have terminals only. With `longest`
/// only words of at most so many letters. All words on the way are kept; where erasing rules may
/// shorten them, long ones too. Throws BoundReached if they take more than budget.memory.
///
/// Example: terminal_words(et0l("S", {{{'S', "aS"}, {'S', "b"}}}, "ab"), 3).size() == 3
std::vector<Word> terminal_words(const ET0L& system, std::uint64_t n,
                                 std::optional<std::size_t> longest = std::nullopt,
                                 const Budget& budget = {});

/// The names of the tables in a text, as their numbers: names or numbers from 1 on with commas
/// between, or, where each is one character, without: "light,dark", "1,2", "abab", "1212". Throws
/// Error if one is no table.
std::vector<std::size_t> table_sequence(const std::vector<std::string>& tables,
                                        const std::string& text);

/// A box parallel to the axes with a symbol. Places and sizes along X, Y and Z are exact, in the
/// units of the file; sizes are above 0.
struct ShapeBox {
    Symbol symbol = 0;
    std::array<Rational, 3> origin;  // its lowest corner
    std::array<Rational, 3> size;

    bool operator==(const ShapeBox&) const = default;
};

/// "X", "Y" or "Z" of 0, 1 or 2.
///
/// Example: axis_name(1) == 'Y'
char axis_name(std::size_t axis);

/// Symbol, origin and size with blanks between, `A 0 0 0 6 1/3 2.5`: decimals where they are
/// exact, fractions where not.
std::string box_text(const Alphabet& alphabet, const ShapeBox& box);

/// The symbols of boxes, in their order.
Word symbols_of(const std::vector<ShapeBox>& boxes);

/// A system of shape rules: boxes that are divided, all at once in each step. A symbol without a
/// rule stays. A box is a module with three parameters, its sizes along X, Y and Z.
struct ShapeSystem {
    /// A distance that some condition asks for (see NearestBoxes).
    struct Distance {
        std::string text;  // distance(X,wall)
        std::size_t axis;
        Symbol symbol;
    };
    std::shared_ptr<const LSystem> system;
    std::vector<ShapeBox> axiom;
    std::vector<std::vector<std::size_t>> rules;  // by symbol: indices into system->rules
    std::vector<Distance> distances;              // each once
};

/// The system as one of shape rules, if it is one: every rule is div, repeat or I, of a symbol with
/// three parameters or none and perhaps a condition; no contexts, probabilities below 1, tables or
/// terminals. Modules of the axiom are boxes: with three arguments, their sizes; with six, their
/// origin and sizes; with none, the unit cube. O(size of the system). Throws `Diagnostics` for
/// arguments without a value, Error for boxes with sizes that are not above 0.
View<ShapeSystem> as_shape(const LSystem& system);

/// The quantity as a rational number: one that is not rational is rounded to the shortest decimal
/// that reads back as the same double.
Rational rational(const Quantity& quantity);

/// What the rules make of one box that stands alone, or the box itself where none applies. The parts of div along
/// several axes stand in the order of the places, those of the last axis named running fastest.
/// Throws Error, with the rule's place and the box, if sizes do not fit the box or are not above 0,
/// if they or the condition have no value, or if two rules apply.
std::vector<ShapeBox> parts_of(const ShapeSystem& system, const ShapeBox& box,
                               const Budget& budget = {});

/// The boxes after n more steps, in each of which every box is replaced by its parts. Stops early
/// when no rule applies any more. Linear in the number of all boxes on the
/// way, with a sort of each generation where conditions ask for distances. Throws Error as
/// parts_of does, BoundReached if there are more boxes than the budget's letters or memory allow.
std::vector<ShapeBox> boxes_after(const ShapeSystem& system, std::vector<ShapeBox> boxes,
                                  std::uint64_t n, const Budget& budget = {});

}  // namespace algae
