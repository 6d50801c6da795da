#pragma once

#include <nlohmann/json_fwd.hpp>

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "automatic/automatic.hpp"
#include "combinatorics/combinatorics.hpp"
#include "dimension/dimension.hpp"
#include "exact/exact.hpp"
#include "growth/growth.hpp"
#include "language/language.hpp"
#include "model/model.hpp"
#include "nature/nature.hpp"
#include "system/system.hpp"

// report: answers to questions as plain data, each with two views: a page of text and JSON.

namespace algae {

struct Model;

/// The digits; if there are more than 60, the first ones and their number.
std::string readable(const Integer& value);

/// A JSON value, whose keys stay in the order in which they were set. It keeps nlohmann/json out of the
/// verbs: that header costs each file that includes it one to three seconds.
class Json {
public:
    struct Field;

    Json();  // null
    Json(std::nullptr_t) : Json() {}
    Json(const char* text);
    Json(const std::string& text);
    Json(std::string_view text);
    Json(double value);
    /// A number if it is below 2^53, so that every reader can represent it, otherwise its digits as a string.
    Json(const Integer& value);
    Json(const nlohmann::ordered_json& value);
    template <std::integral T>
    Json(T value) : Json() {
        if constexpr (std::same_as<T, bool>)
            set_bool(value);
        else if constexpr (std::unsigned_integral<T>)
            set_unsigned(value);
        else
            set_signed(value);
    }
    /// Null without a value.
    template <class T>
    Json(const std::optional<T>& value) : Json(value ? Json(*value) : Json()) {}
    template <class T>
    Json(const std::vector<T>& values) : Json(array()) {
        for (const T& value : values) add(value);
    }
    /// An object.
    Json(std::initializer_list<Field> fields);
    static Json array(std::initializer_list<Json> values = {});

    Json(const Json& other);
    Json(Json&& other) noexcept;
    Json& operator=(Json other) noexcept;
    ~Json();

    /// Sets a field of an object; null becomes an object.
    Json& set(const std::string& name, Json value);
    /// Sets all fields of another object.
    void update(const Json& other);
    /// Appends to an array; null becomes an array.
    void add(Json value);

    /// The text and the end of a line. Throws if a string is not UTF-8.
    std::string text(int indent = 2) const;

private:
    void set_bool(bool value);
    void set_signed(std::int64_t value);
    void set_unsigned(std::uint64_t value);

    std::unique_ptr<nlohmann::ordered_json> value_;
};

/// A field of an object in a list of fields.
struct Json::Field {
    Field(std::string field, Json of) : name(std::move(field)), value(std::move(of)) {}

    std::string name;
    mutable Json value;  // lists hold constants, and large values are moved out of them
};

/// A system, which must outlive the report, and its class.
struct SystemReport {
    const Model& system;
    Class kind;
};

std::string to_text(const SystemReport& report);
Json to_json(const SystemReport& report);

/// How the words of a D0L system grow.
struct GrowthReport {
    D0L system;
    GrowthAnalysis analysis;
};

/// Long polynomials are shortened; `elsewhere` says where they are complete, after a comma.
std::string to_text(const GrowthReport& report, const std::string& elsewhere = {});
Json to_json(const GrowthReport& report);

/// What a document says of growth.
enum class GrowthPart { all, lengths, matrix, recurrence, function, form, rate };

/// As LaTeX that needs amsmath: everything as displays and a sentence, a part as mathematics without dollar signs.
std::string to_latex(const GrowthReport& report, GrowthPart part = GrowthPart::all);

/// A formula of growth or dimension, as these print it, as LaTeX mathematics. What is no such formula becomes text.
///
/// Example: formula_latex("(7*4^n - 4)/3") == "\\frac{7\\cdot 4^{n} - 4}{3}"
/// Example: formula_latex("log 4 / log sqrt 3") == "\\frac{\\log 4}{\\log \\sqrt{3}}"
std::string formula_latex(std::string_view text);

/// A word as LaTeX mathematics, which may be broken between letters; of a long one the beginning and the length.
std::string word_latex(const Alphabet& alphabet, const Word& word);

/// Words, each derived from the one before, as a display.
std::string derivation_latex(const std::vector<Word>& words, const Alphabet& alphabet);

/// Axiom and rules as an array of mathematics.
std::string to_latex(const Model& system);

/// The least and greatest lengths of the words of an 0L system, generation by generation from `first` on.
struct LengthBoundsReport {
    OL system;
    LengthBounds bounds;
    std::uint64_t first = 0;
};

std::string to_text(const LengthBoundsReport& report);
Json to_json(const LengthBoundsReport& report);

/// The factors of the words of a D0L system: complexity class, pushiness,
/// repetitions, and a locally catenative formula.
struct FactorReport {
    D0L system;
    std::vector<std::uint64_t> complexity;  // factors of 0, 1, 2, ... letters
    bool infinite_word = false;             // all words are beginnings of one
    ComplexityOrder order;
    std::optional<Pusher> pusher;
    std::vector<InfiniteRepetition> repetitions;
    CatenativeAnswer formula;
};

/// Factors of up to 24 letters, formulas that look back up to 8 generations. Throws what the functions of
/// the room growth throw.
FactorReport factor_report(const D0L& system, const Budget& budget);

std::string to_text(const FactorReport& report);
Json to_json(const FactorReport& report);

/// One finite word, whose letters are numbered in the order that counts for conjugates and Lyndon words.
struct WordReport {
    std::vector<std::string> letters;  // names, in order
    Word word;
    std::vector<std::size_t> borders, periods, lyndon;
    Word root, conjugate;
    PalindromicFactors palindromes;
    WordRepetitions repetitions;
    std::vector<std::size_t> lempel_ziv;  // where the factors begin
    std::optional<SturmianProperties> sturmian;
    std::vector<std::uint64_t> factors;  // of 0, 1, ..., n letters
    /// Of words of at most `abelian_letters` letters only.
    std::optional<std::vector<AbelianPeriod>> abelian;
    static constexpr std::size_t abelian_letters = 2000;
};

/// Throws BoundReached at the end of the time or memory.
WordReport word_report(Word word, std::vector<std::string> letters, const Budget& budget);

std::string to_text(const WordReport& report);
Json to_json(const WordReport& report);
/// A table of what is found, for a document.
std::string to_latex(const WordReport& report);

/// The factors of 0, 1, ..., `to` letters of the words of a D0L system: exact up to there, and nothing is said beyond.
struct FactorValues {
    Alphabet alphabet;
    bool coded = false;  // the factors are those of the words after the coding of the system
    std::size_t to = 0;
    bool infinite_word = false;  // the factors are those of the infinite word of the system
    std::vector<std::uint64_t> factors, palindromes,
        abelian;  // different ones; those with other numbers of letters
    std::vector<std::uint64_t>
        imbalance;  // by length: how far two factors differ in the number of a letter
    std::optional<Word> not_reversed;  // a shortest factor whose reversal is none
    std::vector<std::uint64_t>
        apart;                // by letter: how far two of these factors of one length differ in it
    Primitivity primitivity;  // of the morphism
    /// Whether long factors are cut into images in one way alone; nothing if the morphism is not injective or has a coding.
    std::optional<bool> circular;
    std::vector<std::optional<Frequency>> frequencies;  // by letter, where they exist
    Rate rate;  // of growth; exact numbers of degree 3 and more are polynomials in it, r

    /// A factor that two letters prolong on either side, and how many more ways there are on both sides than those of each side make: its
    /// bilateral multiplicity (Cassaigne 1997).
    struct Bispecial {
        Word word;
        std::int64_t multiplicity = 0;
    };
    std::vector<Bispecial> bispecial;  // of the infinite word, up to `to` letters
    FactorRecurrence recurrence;       // of the infinite word

    MorphismProperties morphism;                   // of the rules of all accessible letters
    Alphabet morphism_alphabet;                    // of these, before a coding
    std::vector<Symbol> growing, bounded, mortal;  // letters, by what becomes of them

    /// The factor complexity for all lengths, by bispecial factors, and families of words; nothing after a coding, and where the words derived by returns
    /// do not repeat.
    std::optional<ComplexityForAll> for_all;
    std::optional<DerivedWords> derived;  // in the same cases
    std::optional<ConstantLength> columns;
    /// Whether all palindromes that a factor can have are in it; a beginning of the infinite word with a defect says no.
    std::optional<bool> rich;
    std::optional<std::size_t> poor_beginning;  // its length, if there is one
    /// Whether the spectrum of the dynamical system is pure point: by columns, or by the tiling of a Pisot substitution.
    std::optional<bool> pure_point;
    /// What is proved for all lengths, of the infinite word, by automata; otherwise why it is not.
    std::optional<ComplexityProofs> proofs;
    std::optional<CriticalExponent> exponent;
    std::optional<bool> closed_under_reversal;
    std::string not_proved;
};

/// With a coding they are the factors of the images of the words. Throws BoundReached at the end of the time or memory.
FactorValues factor_values(const D0L& system, const Coding& coding, std::size_t to,
                           const Budget& budget);

std::string to_text(const FactorValues& report);
Json to_json(const FactorValues& report);
/// A table of the values, and what is proved for all lengths, for a document.
std::string to_latex(const FactorValues& report);

/// What a first-order statement about the infinite word of a system is: true, false, or true for some numbers.
struct FirstOrderReport {
    std::string statement, system;  // as written; the name
    AutomaticWord word;
    std::vector<std::string> free;  // variables that no quantifier binds
    FirstOrderAnswer answer;
    /// How many other numbers make the statement true with each value of one, `counted`.
    std::optional<LinearRepresentation> count = {};
    std::string counted = {};
};

std::string to_text(const FirstOrderReport& report);
Json to_json(const FirstOrderReport& report);

/// Programs that read the automaton of a statement.
enum class AutomatonFormat { walnut, graphviz, sage };

/// The automaton of a statement with free variables, which are its tracks in the order of names: an automaton of Walnut, a graph, or an `Automaton`
/// of Sage. Throws Error if all variables are bound.
std::string automaton_text(const FirstOrderReport& report, AutomatonFormat format);

/// A set of numbers, of a relation of one variable, as a regular expression over digits, greatest first; nothing where the automaton has more than 40 states or the expression
/// more than 2,000 letters.
std::optional<std::string> regular_expression(const AutomaticRelation& relation,
                                              const Numeration& numeration);

/// What Walnut has to know of a word, by the paths of files in its folder: the automaton of the word and, where Walnut does not have its number system, those of
/// representations and of addition, `msd_dt` and the name of the system. Throws as `decide_first_order`.
std::vector<std::pair<std::string, std::string>> walnut_files(const AutomaticWord& word,
                                                              const std::string& system,
                                                              const Budget& budget);

/// The vectors `begin` and `end`, and the list `digits` of matrices, for Sage.
std::string matrices_text(const LinearRepresentation& count);

/// The dimension of a figure, exact from the rules and measured by boxes.
struct DimensionReport {
    std::string what;  // was measured
    std::optional<ExactDimension> exact;
    std::optional<std::uint64_t> generation;
    BoxCounts counts;
    BoxFit fit;
    bool late = false;                           // the time was over before the measurement
    std::optional<DimensionBounds> bounds = {};  // where they were asked for
    Rational within = {};                        // how near they were to be
    std::optional<Tile> tile = {};  // of sets of dimension 2 whose parts lie in a lattice
    std::string no_tile = {};       // why it is not one of these

    /// Whether the bounds, if there are any, are as near as that.
    bool is_within() const { return !bounds || !(within < bounds->width()); }
};

std::string to_text(const DimensionReport& report);
Json to_json(const DimensionReport& report);
/// As sentences with formulas.
std::string to_latex(const DimensionReport& report);

/// The fractal of a Pisot substitution.
struct RauzyReport {
    std::string what;
    std::vector<std::string> letters;  // their names
    RauzyFractal found;
    std::optional<Tile> tile = {};  // the fractal of three letters in its periodic tiling
};

std::string to_text(const RauzyReport& report);
Json to_json(const RauzyReport& report);

/// The methods of measuring.
enum class Measure { boxes, divider, mass, correlation, information, multifractal, lacunarity };

/// The name of a measure, its title, and the names of scales and values in its table.
struct MeasureNames {
    const char *name, *title, *scale, *value;
};
inline constexpr std::size_t measure_count = 7;
const MeasureNames& names_of(Measure measure);

/// The result of a measure other than boxes.
struct ScalingReport {
    std::string what;  // was measured
    Measure measure;
    Scaling scaling;
    std::vector<GeneralisedDimension> spectrum;  // of the measure multifractal only
    /// The same where it is known exactly: of each order of the spectrum, of information of the order 1.
    std::optional<std::vector<double>> exact;
};

std::string to_text(const ScalingReport& report);
Json to_json(const ScalingReport& report);

/// One system with its dimension, exact and measured.
struct DimensionRow {
    std::string name, title;
    ExactDimension exact;
    std::optional<BoxFit> fit;
    std::string unmeasured;   // why nothing was measured, if it was asked for
    bool unfinished = false;  // because the budget was used up

    /// The number that measurements are compared with; 2 for an upper bound above 2.
    double value() const { return std::min(exact.value->enclosure(64).midpoint(), 2.0); }
    std::optional<double> difference() const {
        if (!fit || !fit->estimate || exact.status != ExactDimension::Status::exact)
            return std::nullopt;
        return fit->estimate->value - value();
    }
};

/// The head of a table of such rows; `width` is that of the names.
std::string dimension_header(std::size_t width, bool quick);
/// The row as a line; without a formula, the reason.
std::string to_line(const DimensionRow& row, std::size_t width);
/// `quick`: without measuring.
Json to_json(const DimensionRow& row, bool quick);
/// The rows as a table.
std::string to_latex(const std::vector<DimensionRow>& rows);

/// Why the word is not in the language, as a sentence without its capital and full stop.
std::string reason(const Membership& found, const Alphabet& alphabet, const Word& word);

/// A derivation, step by step with the rules used.
std::string to_text(const Derivation& found, const ET0L& system);
std::string to_text(const Derivation& found, const IL& system);
Json to_json(const Derivation& found, const ET0L& system);
Json to_json(const Derivation& found, const IL& system);

/// The derivations of a word by their numbers of steps.
std::string to_text(const DerivationCounts& counts);
Json to_json(const DerivationCounts& counts);

/// Why a language is infinite.
std::string to_text(const EndlessRound& round, const OL& system);
Json to_json(const EndlessRound& round, const OL& system);
std::string to_text(const EndlessTables& proof, const ET0L& system);
Json to_json(const EndlessTables& proof, const ET0L& system);

/// What a message says in parts, each empty where it says nothing of the kind: "expected an angle, found 'x'; did you mean 'y'?".
struct MessageParts {
    std::string expected, found, suggestion;
};

/// Example: parts_of("expected a symbol, found ','").found == ","
/// Example: parts_of("unknown setting 'angel'; did you mean 'angle'?").suggestion == "angle"
MessageParts parts_of(std::string_view message);

/// The column behind what is wrong, counted from 1 as the place's: that of what was found there, or of one character.
std::size_t end_column(const Diagnostic& finding);

/// An error for editors and programs: {"file", "line", "column", "end", "message", "expected", "suggestion"}, null where there is none.
Json to_json(const Diagnostic& finding);
/// The same of a message without a place.
Json error_json(std::string_view message);

// Comparisons of two systems, A and B.

std::string to_text(const GrowthComparison& found);
std::string to_text(const SequenceEquality& found, const Alphabet& alphabet);
std::string to_text(const LanguageEquality& found, const Alphabet& alphabet);

}  // namespace algae
