#pragma once
// Symbols, words and expressions: what the statements of `.lsys` files and of claims are made of.

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "notation/notation.hpp"

namespace algae {

/// Whether this is a character of the notation that never is a symbol by itself.
bool is_reserved(char32_t code);

/// Thrown instead of `SyntaxError` where a statement depends on a faulty one, of which a finding tells already.
struct DependsOnError {};

/// The functions that a file makes for itself, `let f(x,y) = x^2 + y`. A call of one is read as the expression that it stands for, so
/// nothing else has to know them; a text that is to be formatted keeps its calls.
class OwnFunctions {
public:
    struct Function {
        std::string name;
        std::vector<std::string> parameters;
        Expression
            said;  // as it stands behind `=`, with calls of functions above it as they are read
        Expression body;  // without such calls, and with the values of constants for their names
        std::size_t constants;  // how many constants stand above it
    };

    explicit OwnFunctions(bool keeps_calls = false) : keeps_calls_(keeps_calls) {}

    const Function* find(std::string_view name) const;
    std::vector<std::string> names() const;
    bool keeps_calls() const { return keeps_calls_; }
    /// The name of the one that is read now; its body must not call it.
    void define(std::string_view name) { defined_ = name; }
    bool is_being_defined(std::string_view name) const { return name == defined_; }
    void add(Function function) {
        all_.push_back(std::move(function));
        defined_.clear();
    }
    /// One whose statement was wrong: a call of it throws `DependsOnError`.
    void add_broken(std::string name) {
        broken_.push_back(std::move(name));
        defined_.clear();
    }
    bool is_broken(std::string_view name) const { return std::ranges::count(broken_, name) > 0; }
    const std::vector<Function>& all() const { return all_; }

    /// What the call of one of them stands for. Throws `SyntaxError` at `where` if that has more than 10,000 numbers, names and
    /// operators, or if all calls so far have more than a million.
    Expression called(const Expression& call, const char* where) const;

    /// The expression without calls of them. Throws as `called` does.
    Expression expanded(const Expression& expression, const char* where) const;

private:
    std::vector<Function> all_;
    std::vector<std::string> broken_;
    std::string defined_;
    bool keeps_calls_;
    mutable std::size_t made_ = 0;  // by all calls so far
};

/// How a text is cut into symbols: the longest name that a declaration or the notation knows.
class Lexicon {
public:
    /// New symbols are added to `alphabet`, which must outlive the lexicon. Names in it that are
    /// read only if declared count as declared.
    explicit Lexicon(Alphabet& alphabet);

    /// From now on `name` is read as one symbol where nothing longer fits.
    Symbol declare(std::string_view name);

    /// From now on a call of `name` is the word of a system.
    void name_system(std::string_view name) { systems_.emplace_back(name); }
    const std::vector<std::string>& systems() const { return systems_; }

    /// The functions of the text that it reads; none without `use`.
    const OwnFunctions* functions() const { return functions_; }
    void use(const OwnFunctions& functions) { functions_ = &functions; }

    /// The symbols so far.
    const Alphabet& alphabet() const { return alphabet_; }

    /// The symbol of this name, if it has occurred.
    std::optional<Symbol> known(std::string_view name) const { return alphabet_.find(name); }

    /// The bytes of the symbol that `text` begins with; 0 if it begins with none. At most as many
    /// steps as the longest declared name has bytes.
    std::size_t length(std::string_view text) const;

    /// The symbol that `text` begins with; the text moves on behind it.
    std::optional<Symbol> next(std::string_view& text);

    /// The symbol of an ASCII character that is a whole symbol unless `_` follows; otherwise none.
    std::optional<Symbol> plain(unsigned char byte);

private:
    struct Node {
        std::map<char, std::uint32_t> next;
        bool ends = false;
    };
    static constexpr Symbol unknown = ~Symbol{0};

    Alphabet& alphabet_;
    std::vector<std::string> systems_;
    const OwnFunctions* functions_ = nullptr;
    std::vector<Node> trie_{1};
    std::array<bool, 256> plain_{};    // ASCII characters that are symbols by themselves
    std::array<Symbol, 256> symbols_;  // of those, once they have occurred
};

/// Reads one expression from `here` on, up to where it cannot go on, and moves `here` there.
/// Throws `SyntaxError`. Brackets nest at most 200 deep, operators at most 500. With a lexicon words
/// may stand in it, `"FF[+F]"` and `leaf(3)` of the systems that the lexicon knows, and calls of its functions; `quotes` counts
/// the words that it stands in itself, at most 20.
Expression parse_expression(const char*& here, const char* end, const Source& source,
                            Lexicon* lexicon, std::size_t quotes = 0);

/// The same without words, where calls of these functions may stand; null for none.
Expression parse_expression(const char*& here, const char* end, const Source& source,
                            const OwnFunctions* functions);

/// An expression that is the whole of `text`, without words. Throws `SyntaxError`.
Expression parse_expression(std::string_view text, const Source& source,
                            const OwnFunctions* functions = nullptr);

/// Arguments in brackets, `(x*2, x+y)`, from `here` on. Throws `SyntaxError`.
std::vector<Expression> parse_arguments(const char*& here, const char* end, const Source& source,
                                        Lexicon* lexicon, std::size_t quotes = 0);

/// The same without words, with calls of these functions.
std::vector<Expression> parse_arguments(const char*& here, const char* end, const Source& source,
                                        const OwnFunctions* functions);

/// The word that is the whole of `text`: symbols, some with arguments in brackets; white space
/// separates, ε alone is the empty word. Linear; a word without arguments takes four bytes a symbol.
/// Where `splices` are allowed, `<w>` stands for the word that the expression w gives; a relation in
/// it needs brackets. Throws `SyntaxError`.
ModuleWord parse_word(std::string_view text, Lexicon& lexicon, const Source& source,
                      bool splices = false);

/// The word in quotes that `here` stands at, as an expression; moves `here` behind it. `quotes` counts
/// the words in quotes around it, at most 20. Throws `SyntaxError`.
Expression parse_quoted(const char*& here, const char* end, Lexicon& lexicon, const Source& source,
                        std::size_t quotes);

/// Symbols without arguments. Throws `SyntaxError`.
Word parse_symbols(std::string_view text, Lexicon& lexicon);

/// Adds a finding for each bracket of the word without its other half; `text` is what the word was
/// read from.
void check_brackets(const ModuleWord& word, std::string_view text, Lexicon& lexicon,
                    const Source& source, Findings& findings);

}  // namespace algae
