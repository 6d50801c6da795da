#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "exact/exact.hpp"
#include "system/system.hpp"
#include "word/word.hpp"

// search: all instances of "for all A, B, ...", in one fixed order, each once up to renaming of letters.
//
// A statement is quantified over a tuple of values: languages, systems, words, morphisms, numbers. A `Domain` says over what one
// value ranges, a `Tuple` over what all do, and `visit` goes through the instances of one total size. D0L systems are counted too,
// and found by their number, without going through those before.
//
// Sizes. A finite language: the sum of |w| + 1 over its words. A system: |axiom| and 1 + |successor| for each production of each table;
// a production a -> a is counted. A word: |w| + 1. A letter: 1. A morphism or substitution: 1 + |image| for each image of each letter.
// A number: itself. An instance: the sum.
//
// Texts. The text of a value is a sequence of pieces, and a piece is a sequence of words, shorter words first, words of one length by
// their letters, each word once:
//   language                 one piece, its words
//   word, letter             one piece, one word
//   system                   {axiom}, then for each letter a piece: its successors. Letters stand in the order in which they
//                            first occur in this text, so every rule is read after its letter. Of a system with tables the number of
//                            tables comes first, and there is a piece for each letter and, within, each table
//   morphism, substitution   a piece for each letter of the domain: its images
//   inverse morphism         one piece, the images of all letters of the domain, as often as they are images
//   number                   the number
// Texts are compared by the first difference: of numbers the smaller one comes first, of two pieces that which ends where the other goes
// on, of two words the shorter one, then that with the smaller letter. Of all instances that differ by a renaming (one
// bijection of letters for all values; of each system an order of its tables; for each inverse morphism a bijection of its domain) only that with
// the least text is visited. Its letters are 0, 1, ..., in the order in which they first occur.
//
// The order of instances: by total size, then by how many letters occur, then by text. Over an explicit alphabet all instances are
// visited, renamed or not, and the order is by total size, then by text.

namespace algae {

/// What one value of an instance ranges over.
struct Domain {
    enum class Kind {
        language,  // a finite language; {} and {ε} too
        system,    // an 0L system: its axiom is not empty, all its letters occur in derived words
        word,      // the empty word too
        letter,    // one that occurs in earlier values, or a new one
        morphism,  // its domain: exactly the letters that occur in earlier values; images over these and new ones
        inverse_morphism,  // to be applied inversely: has one or more letters of its own, images over letters of earlier values
        substitution,      // like a morphism, images are non-empty finite languages
        number             // 0, 1, ...
    };

    Kind kind = Kind::language;
    bool deterministic = false;  // of systems: one successor of each letter in each table
    bool propagating = false;    // of systems: no empty successors
    bool tables = false;         // of systems: a set of one or more tables (T0L)
    bool nonerasing = false;     // of morphisms and substitutions: no empty images
    bool letter_to_letter =
        false;  // of morphisms (then codings) and substitutions: images are letters

    std::optional<std::uint64_t> max_size = {};         // of the value
    std::optional<std::uint64_t> max_word_length = {};  // of every word in it
    /// How many different letters may occur in the words of the value; of an inverse morphism, how many letters
    /// its domain has at most.
    std::optional<std::uint64_t> letters = {};
    std::optional<std::uint64_t> max_number = {};  // of a number, itself included

    bool operator==(const Domain&) const = default;
};

/// What instances are tuples of.
struct Tuple {
    std::vector<Domain> values;
    /// No letter occurs in two of the languages, systems, words and letters.
    bool disjoint = false;
    /// How many letters occur at most in all values together.
    std::optional<std::uint64_t> letters = std::nullopt;
    /// An explicit alphabet of so many letters, 0, 1, ...: instances are over them and are not renamed.
    std::optional<std::uint64_t> over = std::nullopt;

    bool operator==(const Tuple&) const = default;
};

/// The size of the largest instances, or a bound of it; nothing if sizes are not bounded. 2^64 - 1 where a bound is larger than that.
///
/// Example: greatest_size({{Domain{.max_word_length = 2, .letters = 1}}}) == 6
std::optional<std::uint64_t> greatest_size(const Tuple& tuple);

/// Whether the bounds leave finitely many instances.
///
/// Example: !is_finite({{Domain{.max_word_length = 2}}})
bool is_finite(const Tuple& tuple);

/// The letters that instances are written with: a, b, ..., z, a_1, b_1, ...
///
/// Example: spell(search_alphabet(3), {0, 1, 2}) == "abc"
Alphabet search_alphabet(std::size_t letters);

/// One instance. What a visitor is given changes when it returns; a copy stays. Values are counted from 0. Asking a value
/// for what it is not throws Error.
class Instance {
public:
    /// Its total size.
    std::uint64_t size() const { return size_; }
    /// How many letters occur; over an explicit alphabet, how many that has.
    std::size_t letters() const { return letter_count_; }
    /// How many values it has.
    std::size_t values() const { return values_.size(); }
    Domain::Kind kind(std::size_t value) const { return values_.at(value).kind; }

    /// The words of a finite language, in shortlex order.
    std::vector<Word> language(std::size_t value) const;
    Word word(std::size_t value) const;
    Symbol letter(std::size_t value) const;
    /// A deterministic system without tables, over all letters of the instance; those that do not occur in it become themselves.
    D0L d0l(std::size_t value) const;
    /// A system with one table, over all letters of the instance.
    OL ol(std::size_t value) const;
    /// Any system, over all letters of the instance.
    ET0L et0l(std::size_t value) const;
    /// A morphism; of an inverse one the domain are the letters 0, 1, ... of an alphabet of its own.
    Morphism morphism(std::size_t value) const;
    /// The letters of a substitution, each with its images.
    std::vector<std::pair<Symbol, std::vector<Word>>> substitution(std::size_t value) const;
    std::uint64_t number(std::size_t value) const;

    /// The text as it is defined above: words of a piece with commas, pieces with `#`, a number of tables with a colon; `{}` for an
    /// empty piece.
    std::string text(std::size_t value) const;
    /// The texts of all values, with "; " between them.
    std::string text() const;

    bool operator==(const Instance&) const = default;

private:
    friend class Enumerator;
    friend class Renamings;
    friend class DeterministicSystems;

    struct Value {
        Domain::Kind kind = Domain::Kind::language;
        std::size_t first_piece = 0;
        std::size_t tables = 1;
        std::uint64_t number = 0;
        std::vector<Symbol> owners = {};  // the letters whose images the pieces are, in order
        bool operator==(const Value&) const = default;
    };

    std::size_t word_end(std::size_t word) const {
        return word + 1 < words_.size() ? words_[word + 1] : letters_.size();
    }
    std::size_t piece_end(std::size_t piece) const {
        return piece + 1 < pieces_.size() ? pieces_[piece + 1] : words_.size();
    }
    std::size_t value_end(std::size_t value) const {
        return value + 1 < values_.size() ? values_[value + 1].first_piece : pieces_.size();
    }
    std::size_t piece_of(std::size_t value, std::size_t owner, std::size_t table) const;
    Word word_at(std::size_t word) const;
    std::vector<Word> words_of(std::size_t piece) const;
    const Value& expect(std::size_t value, std::initializer_list<Domain::Kind> kinds,
                        const char* what) const;

    std::uint64_t size_ = 0;
    std::size_t letter_count_ = 0;
    Word letters_;                     // of all words, one after the other
    std::vector<std::size_t> words_;   // where each word starts
    std::vector<std::size_t> pieces_;  // the first word of each piece
    std::vector<Value> values_;
};

/// Called with each instance; false stops the visit.
using InstanceVisitor = std::function<bool(const Instance&)>;

/// A part of the instances of one size, by their numbers from 0 in the order.
struct InstanceRange {
    std::uint64_t first = 0;
    std::uint64_t last = std::numeric_limits<std::uint64_t>::max();  // not included
};

/// Visits the instances of this total size, in the order above, of those only a part. False if the visitor stopped it.
///
/// Memory does not depend on how many instances there are. Instances before the first are generated too, which takes their time; for
/// one D0L or PD0L system without other bounds than of its letters they are skipped by counting. About 10^6 systems a second. Throws
/// what budget.check throws.
///
/// Example: !visit({{Domain{.kind = Domain::Kind::system}}}, 3, [](const Instance& s) { return s.text() != "a#a"; })
bool visit(const Tuple& tuple, std::uint64_t size, const InstanceVisitor& visitor,
           const Budget& budget = {}, InstanceRange range = {});

/// Visits the instances of all sizes, from the least on. It ends if the bounds leave finitely many or the visitor stops it; then it is false.
///
/// Example: visit_all({{Domain{.max_word_length = 1, .letters = 1}}}, [](const Instance& a) { return a.letters() < 2; })
bool visit_all(const Tuple& tuple, const InstanceVisitor& visitor, const Budget& budget = {});

/// How many instances of this size there are, by visiting them.
///
/// Example: instance_count({{Domain{.kind = Domain::Kind::system}}}, 6) == 81
std::uint64_t instance_count(const Tuple& tuple, std::uint64_t size, const Budget& budget = {});

/// The D0L (or PD0L) systems of one size, up to renaming, by counting.
///
/// The text axiom#h(x1)#h(x2)#... of a system is a path: letters are new or old, each rule is read after its letter has occurred, and how many
/// ways lead on depends only on the letters that have occurred, the rules given, the letters left of this word and the size left. So
/// the systems are counted by a table, O(size^4) for each number of letters, and the table says which way the system of a given
/// number goes.
class DeterministicSystems {
public:
    /// `letters` is how many there may be at most. Counts at once.
    explicit DeterministicSystems(std::uint64_t size, bool propagating = false,
                                  std::optional<std::uint64_t> letters = std::nullopt,
                                  const Budget& budget = {});

    /// How many there are.
    ///
    /// Example: DeterministicSystems(16).count() == 1213667179
    Integer count() const;
    /// How many have exactly so many letters.
    Integer count(std::size_t letters) const;

    /// The system of this number, from 0, in the order of `visit`. Throws Error if there are not so many. A few additions for each
    /// letter of the text, behind a table for its number of letters.
    ///
    /// Example: DeterministicSystems(4).at(3).text() == "a#b#ε"
    Instance at(const Integer& index) const;

    /// Visits those with the numbers from `first` up to `last`, that one not included. False if the visitor stopped it.
    bool visit(const InstanceVisitor& visitor, Integer first = 0,
               const std::optional<Integer>& last = std::nullopt) const;

private:
    struct Ways;
    struct Path;

    std::uint64_t size_;
    bool propagating_;
    Budget budget_;
    std::vector<Integer> counts_;  // by how many letters
};

// -------------------------------------------------------------------------------------------------
// Inference: the smallest system that explains words

/// What a system must be that explains words.
struct InferenceWish {
    enum class Family { d0l, ol, dt0l, dil };
    Family family = Family::d0l;
    bool propagating = false;  // no successor is empty
};

/// A rule of a system that explains words. Contexts are empty but in DIL systems, where they are read from left to right.
struct InferredRule {
    std::size_t table = 0;
    Word left;
    Symbol letter = 0;
    Word right, successor;
    bool operator==(const InferredRule&) const = default;
};

/// A system, and how much work it was to know that there is no smaller one. The size is |axiom|, and 1 + |successor| + |contexts| for
/// each rule.
struct InferredSystem {
    Word axiom;
    std::size_t tables = 1;
    std::vector<std::size_t> schedule;  // of DT0L systems: the table of each step between the words
    /// By table, by letter, longer contexts first: that is how they are tried.
    std::vector<InferredRule> rules;
    std::uint64_t size = 0;
};

/// The result of an inference. Without a system there is none.
struct Inference {
    std::optional<InferredSystem> system;
    std::uint64_t cases = 0;  // parts of systems, or systems, that were tried
};

/// The smallest system of the family whose first generations are these words, of a 0L system a derivation with these words, of a
/// DT0L system by some sequence of its tables. Complete: each way to cut the words into successors is tried unless it is larger than what
/// was found. Where sizes are equal, the one whose successors are shorter from the left.
///
/// Every letter of the words has a rule in each table; where the words do not say it, the shortest. Of DIL systems the contexts are as
/// short as can be, left and right together, and among these the system is the smallest; contexts are those that
/// occur, and all other letters stay as they are.
///
/// The smallest T0L and IL systems are the smallest 0L system: one table with the rules of all, and rules without their contexts,
/// derive what they did and are not larger.
///
/// Exponential in the number of different letters. Throws Error if there are no words or the first one is empty, what
/// budget.check throws otherwise.
///
/// Example: infer_generations({{0}, {0, 1}, {0, 1, 0}}, {}).system->size == 6
/// Example: !infer_generations({{0}, {0, 0}, {0, 0, 0}}, {}).system
Inference infer_generations(const std::vector<Word>& words, const InferenceWish& wish,
                            const Budget& budget = {});

/// The smallest system of the family, not DIL, whose language has all these words, up to this size; nothing if there is none up to it. All
/// systems are tried in the order of their size, up to renaming; `is_member` decides.
///
/// Throws Error for DIL systems, what budget.check and `is_member` throw otherwise.
Inference infer_sample(const std::vector<Word>& words, const InferenceWish& wish,
                       std::uint64_t largest,
                       const std::function<bool(const ET0L&, const Word&)>& is_member,
                       const Budget& budget = {});

}  // namespace algae
