#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "notation/detail/blank_byte.hpp"
#include "notation/detail/claim_reading.hpp"
#include "notation/detail/grammar.hpp"
#include "notation/detail/operator_stack.hpp"

// Languages in claims: words, finite sets, morphisms, regular expressions and what operations make of
// languages.
//
// The grammars are flat, as that of expressions is: prefixes and opening brackets, an operand, what stands
// behind it, then an operator. From the loosest to the tightest these are union and difference (`|`, `\`),
// intersection, concatenation (`.` or nothing), complement `~`, and postfix `*`, `+`, `^R`; operands are
// names, sets, `L(G)` and `/regular/`, and an image under a morphism or its inverse opens a bracket. An
// `OperatorStack` finds what belongs together. Brackets nest at most 200 deep. The trees that come out are
// bounded too, because those who work on them do recurse: 1,000 operations inside each other, a million
// parts with names written out (`LanguageOperand`).
//
// Braces open a set or a morphism; an arrow between them tells which. Between slashes, letters next to each
// other are one word and choices of words one finite set, so that long words become one leaf and not a chain
// of concatenations (`Gathered`).

namespace algae {

namespace {

namespace x3 = grammar::x3;
using grammar::between;
using grammar::ByHand;
using grammar::told;
using grammar::wanted;
using grammar::word;

constexpr std::size_t most_brackets = 200;

SyntaxError too_many_brackets(const char* where) {
    return {where, "more than " + std::to_string(most_brackets) + " brackets inside each other"};
}

/// What stands between the braces, the first of which stands next; nothing if there is no other.
std::string_view inside_braces(const char* here, const char* end) {
    if (here == end || *here != '{') return {};
    const char* const close = closing_brace(here, end);
    return close ? between(here + 1, close) : std::string_view();
}

/// The word that is the whole of the text, or of a part of it between blanks.
Word parse_letters(std::string_view text, ClaimReading& reading) {
    refuse_slips(text, reading.lexicon);
    return parse_symbols(text, reading.lexicon);
}

/// The same, whose letters are letters of the file.
Word parse_counted_letters(std::string_view text, ClaimReading& reading) {
    Word word = parse_letters(text, reading);
    reading.add_letters(word);
    return word;
}

/// A comment in a set, up to the end of its line.
const ByHand comment([](const char*& here, const char* end) {
    if (here == end || *here != '#') return false;
    const char* before = here - 1;  // a brace stands before all of a set
    while ((static_cast<unsigned char>(*before) & 0xC0) == 0x80) --before;
    const auto size = static_cast<std::size_t>(here - before);
    if (!is_behind_blank({before, size}, size)) return false;
    here = std::find(here, end, '\n');
    return true;
});

/// Reads the finite set `{a, ab, ε}` that stands next; comments may stand in its words.
Language parse_set(const char*& here, const char* end, ClaimReading& reading) {
    std::vector<Word> words;
    const char* begin = here;  // of the word
    bool is_there = false;
    const auto on_begin = x3::no_skip[ByHand([&](const char*& first, const char*) {
        begin = first;
        is_there = false;
        words.emplace_back();
    })];
    const auto on_piece = told([&](std::string_view text) {
        if (!reading.spaced())
            if (const auto parts = separate_successors(trimmed(text)); parts.size() > 1)
                throw SyntaxError{std::find(parts[0].end(), text.end(), '|'),
                                  "expected ',' between words, found '|'; as a letter it is "
                                  "written without blanks"};
        const Word letters = parse_counted_letters(text, reading);
        words.back().insert(words.back().end(), letters.begin(), letters.end());
        is_there = true;
    });
    const auto on_end = [&](auto&) {
        if (!is_there) throw unexpected("a word (the empty word is ε)", begin);
    };
    // A '#' that begins no comment is a piece for `parse_symbols` to refuse.
    const auto piece = x3::lexeme[+(x3::char_ - x3::char_(",{}#\n"))] | '#';
    const auto element = on_begin >> *x3::raw[piece][on_piece] >> x3::eps[on_end];
    const auto set = '{' >> (x3::lit('}') | (element % ',' >> wanted("',' or '}'")[x3::lit('}')]));
    x3::phrase_parse(here, end, set, grammar::blank | comment, x3::skip_flag::dont_post_skip);
    return words_language(std::move(words));
}

}  // namespace

Word parse_claimed_word(std::string_view text, ClaimReading& reading) {
    const std::string_view word = trimmed(text);
    if (word.empty()) throw unexpected("a word (the empty word is ε)", text.data());
    return parse_letters(word, reading);
}

bool is_morphism(const char* here, const char* end) {
    const std::vector<Clause> inside = clauses(inside_braces(here, end));
    return std::any_of(inside.begin(), inside.end(),
                       [](const Clause& clause) { return clause.arrow != nullptr; });
}

Morphism parse_morphism(const char*& here, const char* end, ClaimReading& reading) {
    const std::string_view text = inside_braces(here, end);
    Morphism morphism;
    for (const Clause& clause : clauses(text)) {
        if (!clause.arrow) throw unexpected("a letter, '->' and a word", clause.text.data());
        const auto left_size = static_cast<std::size_t>(clause.arrow - clause.text.data());
        const std::string_view left = trimmed(clause.text.substr(0, left_size));
        const std::size_t arrow_size = *clause.arrow == '-' ? 2 : std::string_view("→").size();
        const Word letter = parse_symbols(left, reading.lexicon);
        if (letter.size() != 1) throw unexpected("one letter before the arrow", clause.text.data());
        const std::string_view right = clause.text.substr(left_size + arrow_size);
        if (!reading.spaced())
            if (const auto images = separate_successors(trimmed(right)); images.size() > 1)
                throw SyntaxError{std::find(images[0].end(), right.end(), '|'),
                                  "expected one word as the image of a letter, found '|'; as a "
                                  "letter it is written without blanks"};
        refuse_slips(right, reading.lexicon, true);
        Word image = parse_symbols(right, reading.lexicon);
        reading.add_letters(letter);
        reading.add_letters(image);
        if (!morphism.add(letter[0], std::move(image)))
            throw SyntaxError{clause.text.data(), "the letter " + quoted(left) + " has two images"};
    }
    here = text.data() + text.size() + 1;
    return morphism;
}

namespace {

using Kind = LanguageTree::Kind;

/// How many operations a language may have inside each other, and how many parts.
constexpr std::size_t most_levels = 1000;
constexpr std::size_t most_parts = 1'000'000;

SyntaxError too_deep(const char* where) {
    return {where, "a language with more than " + std::to_string(most_levels) +
                       " operations inside each other"};
}

/// What the bounds say of an operation on these parts; the language is still missing.
LanguageOperand measured(const std::vector<LanguageOperand>& parts, const char* where) {
    LanguageOperand out;
    for (const LanguageOperand& part : parts) {
        out.levels = std::max(out.levels, part.levels + 1);
        out.parts += part.parts;
    }
    if (out.levels > most_levels) throw too_deep(where);
    if (out.parts > most_parts)
        throw SyntaxError{where, "a language with more than " + std::to_string(most_parts) +
                                     " parts where its names are written out"};
    return out;
}

/// The language that an operation makes of others; `where` it is written. Throws `SyntaxError` if the
/// expression becomes too deep or too large.
LanguageOperand combined_operand(Kind kind, std::vector<LanguageOperand> parts, const char* where) {
    LanguageOperand out = measured(parts, where);
    std::vector<Language> languages;
    for (LanguageOperand& part : parts) languages.push_back(std::move(part.language));
    out.language = combined(kind, std::move(languages));
    return out;
}

/// The words that are not in the language, over the letters of the file.
LanguageOperand complement_operand(LanguageOperand part, ClaimReading& reading, const char* where) {
    LanguageOperand out = measured({part}, where);
    out.language = reading.complement(std::move(part.language), where);
    return out;
}

/// A morphism on its way from a text, or the number of the bound name that is one.
struct MorphismOperand {
    Morphism morphism = {};
    std::optional<std::size_t> variable = {};
};

/// The image, or inverse image, of a language under a bound morphism.
LanguageOperand bound_operand(Kind kind, LanguageOperand part, std::size_t variable,
                              std::string_view name, ClaimReading& reading) {
    LanguageOperand out = measured({part}, name.data());
    MorphismUse& use = reading.uses[variable];
    (kind == Kind::image ? use.applied : use.inverse) = true;
    if (use.applied && use.inverse)
        throw SyntaxError{name.data(), "expected " + quoted(name) +
                                           " or its inverse, found both in one statement; bind a "
                                           "second name for the inverse"};
    LanguageTree tree;
    tree.kind = kind;
    tree.parts = {std::move(part.language)};
    tree.variable = BoundName{variable, std::string(name)};
    out.language = std::make_shared<const LanguageTree>(std::move(tree));
    return out;
}

/// The image of the language under a morphism; `name` is what the text calls that. Throws `SyntaxError` if
/// a letter of the language has no image.
LanguageOperand image_operand(LanguageOperand part, const MorphismOperand& by,
                              std::string_view name, ClaimReading& reading) {
    if (by.variable)
        return bound_operand(Kind::image, std::move(part), *by.variable, name, reading);
    const Morphism& morphism = by.morphism;
    LanguageOperand out = measured({part}, name.data());
    reading.check_images(part.language, morphism, name.data());
    out.language = image_language(std::move(part.language), morphism);
    return out;
}

LanguageOperand inverse_image_operand(LanguageOperand part, const MorphismOperand& by,
                                      std::string_view name, ClaimReading& reading) {
    if (by.variable)
        return bound_operand(Kind::inverse_image, std::move(part), *by.variable, name, reading);
    LanguageOperand out = measured({part}, name.data());
    out.language = inverse_image_language(std::move(part.language), by.morphism);
    return out;
}

/// A part of a regular expression on its way: factors or choices as they come, of which neighbours that are words
/// become one finite set. `where` it begins.
struct Gathered {
    Kind kind = Kind::words;  // united, concatenated, or neither: one operand
    const char* where = nullptr;
    std::vector<Word> words = {};  // of a concatenation at most one
    std::optional<LanguageOperand> whole = {};

    void add(LanguageOperand operand) {
        const LanguageTree& tree = *operand.language;
        if (tree.kind != Kind::words || (kind != Kind::united && tree.words.size() != 1)) {
            flush();
            return join(std::move(operand));
        }
        for (const Word& word : tree.words) {
            if (kind == Kind::concatenated && !words.empty())
                words[0].insert(words[0].end(), word.begin(), word.end());
            else
                words.push_back(word);
        }
    }
    LanguageOperand finish() {
        flush();
        return std::move(*whole);
    }

private:
    void flush() {
        if (!words.empty()) join({words_language(std::exchange(words, {})), 0, 1});
    }
    void join(LanguageOperand operand) {
        whole = whole ? combined_operand(kind, {std::move(*whole), std::move(operand)}, where)
                      : std::move(operand);
    }
};

/// The parts as one of this kind.
Gathered gathered(Kind kind, std::vector<Gathered> parts) {
    if (parts[0].kind != kind) {
        Gathered first = std::move(parts[0]);
        parts[0] = {kind, first.where};
        parts[0].add(first.finish());
    }
    parts[0].add(parts[1].finish());
    return std::move(parts[0]);
}

/// A part to which nothing more is added.
Gathered closed(LanguageOperand operand, const char* where) {
    return {Kind::words, where, {}, std::move(operand)};
}

/// What `?`, `*` or `+`, which stands at this place, makes of a part.
Gathered repeated(Gathered part, const char* sign) {
    LanguageOperand operand = part.finish();
    if (*sign != '?')
        return closed(
            combined_operand(*sign == '*' ? Kind::star : Kind::plus, {std::move(operand)}, sign),
            part.where);
    Gathered choices{Kind::united, sign};
    choices.add(std::move(operand));
    choices.add({words_language({{}}), 0, 1});
    return closed(choices.finish(), part.where);
}

/// Reads the regular expression between slashes that stands next, `/a(aa)*|b?/`, as a language: letters next
/// to each other are one word, choices of words one finite set. Throws `SyntaxError`. Brackets nest at
/// most 200 deep, operations 1000. Linear.
LanguageOperand parse_regular(const char*& here, const char* end, ClaimReading& reading) {
    using Parts = std::vector<Gathered>;
    enum Binding { choice, product };
    const char* const first_slash = here;
    if (std::find(here + 1, end, '/') == end) throw SyntaxError{first_slash, "'/' is never closed"};
    OperatorStack<Gathered> stack;
    const char* where = here;  // of a letter
    const auto infix = [&](Kind kind, Binding binding) {
        return [&stack, kind, binding](auto&) {
            stack.infix(binding, [kind](Parts parts) { return gathered(kind, std::move(parts)); });
        };
    };
    const auto on_open = told([&](std::string_view at) {
        if (stack.depth() == most_brackets) throw too_many_brackets(at.data());
        stack.open([at](Parts parts) { return closed(parts[0].finish(), at.data()); });
    });
    const auto add = [&](Word letter) {
        reading.add_letters(letter);
        stack.operand({Kind::concatenated, where, {std::move(letter)}});
    };
    const auto on_empty = [&](auto&) { add({}); };
    const auto on_letter = [&](auto& c) { add({x3::_attr(c)}); };
    const auto on_repeat = told([&](std::string_view at) {
        stack.postfix([at](Parts parts) { return repeated(std::move(parts[0]), at.data()); });
    });
    const auto on_close = [&](auto&) { stack.close(); };
    const auto is_open = [&](auto& c) { x3::_pass(c) = stack.depth() > 0; };
    const auto refuse = told([](std::string_view at) {
        throw SyntaxError{at.data(), "expected a letter, found " + quoted(at) +
                                         ", which has no meaning between slashes"};
    });

    const auto letter = x3::lit("ε")[on_empty] | x3::raw[x3::char_(".^$\\[]{}")][refuse] |
                        (grammar::SymbolParser(reading.lexicon) - x3::char_("|*+?()/"))[on_letter];
    const auto behind =
        x3::raw[x3::char_("*+?")][on_repeat] | (x3::eps[is_open] >> x3::lit(')')[on_close]);
    const auto factor = *x3::raw[x3::lit('(')][on_open] >> grammar::place(where) >>
                        wanted("a letter or '(' (the empty word is ε)")[letter] >> *behind;
    const auto next = x3::lit('|')[infix(Kind::united, choice)] |
                      (!(x3::char_(")/") | x3::eoi))[infix(Kind::concatenated, product)];
    ++here;
    grammar::read(here, end, factor % next);
    LanguageOperand whole = stack.finish().finish();
    if (stack.depth() > 0) throw unexpected("a letter, an operator or ')'", here);
    if (here == end || *here != '/') throw unexpected("a letter, an operator or '/'", here);
    ++here;
    return whole;
}

}  // namespace

LanguageOperand parse_language(const char*& here, const char* end, ClaimReading& reading,
                               bool between_bars) {
    using Parts = std::vector<LanguageOperand>;
    enum Binding { sum, intersection, product, complement };
    OperatorStack<LanguageOperand> stack;
    std::size_t signs = 0;  // `~` next to each other
    std::string_view name;  // of what stands last
    MorphismOperand morphism;

    const auto combine = [](Kind kind, std::string_view at) {
        return
            [kind, at](Parts parts) { return combined_operand(kind, std::move(parts), at.data()); };
    };
    const auto infix = [&](Kind kind, Binding binding) {
        return told([&stack, &signs, combine, kind, binding](std::string_view at) {
            signs = 0;
            stack.infix(binding, combine(kind, at));
        });
    };
    const auto postfix = [&](Kind kind) {
        return told(
            [&stack, combine, kind](std::string_view at) { stack.postfix(combine(kind, at)); });
    };
    const auto open = [&](std::string_view at, OperatorStack<LanguageOperand>::Make make) {
        if (stack.depth() == most_brackets) throw too_many_brackets(at.data());
        signs = 0;
        stack.open(std::move(make));
    };
    const auto on_complement = told([&](std::string_view at) {
        if (signs++ == most_levels) throw too_deep(at.data());
        stack.prefix(complement, [&reading, at](Parts parts) {
            return complement_operand(std::move(parts[0]), reading, at.data());
        });
    });
    const auto on_open = told(
        [&](std::string_view at) { open(at, [](Parts parts) { return std::move(parts[0]); }); });
    const auto on_image = told([&](std::string_view at) {
        open(at, [&reading, morphism, name](Parts parts) {
            return image_operand(std::move(parts[0]), morphism, name, reading);
        });
    });
    const auto on_inverse_image = told([&](std::string_view at) {
        open(at, [&reading, morphism, name](Parts parts) {
            return inverse_image_operand(std::move(parts[0]), morphism, name, reading);
        });
    });
    const auto on_close = [&](auto&) { stack.close(); };
    const auto is_open = [&](auto& c) { x3::_pass(c) = stack.depth() > 0; };
    const auto is_closed_by_bar = [&](auto& c) {
        x3::_pass(c) = between_bars && stack.depth() == 0;
    };
    const auto is_name_of_morphism = [&](auto& c) {
        name = grammar::text_of(x3::_attr(c));
        const ClaimName& known = reading.expect(name);
        x3::_pass(c) = known.kind == ClaimName::Kind::morphism;
        if (x3::_pass(c)) morphism = {known.morphism, known.variable};
    };
    const auto on_name = told([&](std::string_view text) {
        const ClaimName& known = reading.expect(text);
        if (known.kind == ClaimName::Kind::system)
            throw SyntaxError{text.data(), "expected a language, found the system " + quoted(text) +
                                               "; its language is L(" + std::string(text) + ")"};
        if (known.kind != ClaimName::Kind::language)
            throw SyntaxError{text.data(),
                              "expected a language, found " + quoted(text) +
                                  (known.kind == ClaimName::Kind::word
                                       ? ", a word; its language is {" + std::string(text) + "}"
                                   : known.kind == ClaimName::Kind::number ? ", a number"
                                                                           : ", which is none")};
        stack.operand(known.language);
    });
    const auto on_system = told([&](std::string_view text) { name = text; });
    const auto on_generated = [&](auto&) {
        stack.operand({generated_language(reading.system(trimmed(name))), 0, 1});
    };
    const auto braces_of_morphism = ByHand([&](const char*& first, const char* last) {
        if (!is_morphism(first, last)) return false;
        name = between(first, last);
        morphism = {parse_morphism(first, last, reading), {}};
        return true;
    });
    const auto set = ByHand([&](const char*& first, const char* last) {
        const std::string_view inside = inside_braces(first, last);
        if (is_set_with_condition(inside, reading)) {
            stack.operand({parse_powers(inside, reading), 0, 1});
            first = inside.data() + inside.size() + 1;
        } else {
            stack.operand({parse_set(first, last, reading), 0, 1});
        }
    });
    const auto begins_grammar =
        ByHand([](const char*& first, const char* last) { return is_grammar(first, last); });
    const auto by_rules = ByHand([&](const char*& first, const char* last) {
        stack.operand(parse_grammar(first, last, reading));
    });
    const auto regular = ByHand([&](const char*& first, const char* last) {
        stack.operand(parse_regular(first, last, reading));
    });

    const auto generated = word("L") >> '(';
    const auto known =
        grammar::claim_name - (word("is") | word("in") | word("not") | word("by") | begins_grammar);
    const auto mapped =
        (&x3::lit('{') >> braces_of_morphism) | (!generated >> known[is_name_of_morphism]);
    const auto inverse =
        '^' >> wanted("-1 after '^' (the inverse of a morphism)")[x3::lit("-1")] >>
        wanted("'(' and a language after the inverse of a morphism")[x3::raw[x3::lit('(')]
                                                                            [on_inverse_image]];
    const auto image =
        wanted("'(' and a language after a morphism")[x3::raw[x3::lit('(')][on_image]];
    const auto prefix = x3::raw[x3::lit('~')][on_complement] | x3::raw[x3::lit('(')][on_open] |
                        (mapped >> (inverse | image));
    const auto typed = ByHand([&](const char*& first, const char* last) {
        const char* const close = std::find(first + 1, last, *first);
        if (close == last)
            throw SyntaxError{first, std::string("expected ") + *first +
                                         " at the end of the system, found the end of the line"};
        stack.operand({generated_language(reading.typed_system(between(first + 1, close))), 0, 1});
        first = close + 1;
    });
    const auto quoted_system = &x3::char_("'\"") >> typed >> wanted("')'")[x3::lit(')')];
    const auto named_system =
        wanted("the name of a system")[x3::raw[x3::lexeme[+(x3::char_ - ')')]][on_system]] >>
        wanted("')'")[x3::lit(')')[on_generated]];
    const auto operand = (generated >> (quoted_system | named_system)) |
                         (&begins_grammar >> by_rules) | known[on_name] | (&x3::lit('{') >> set) |
                         (&x3::lit('/') >> regular);
    const auto reversal = x3::lit('^') >> wanted("R after '^' (reversal)")[word("R")];
    const auto behind =
        x3::raw[x3::lit('+')][postfix(Kind::plus)] | x3::raw[reversal][postfix(Kind::reversed)] |
        x3::raw[x3::lit('*')][postfix(Kind::star)] | (x3::eps[is_open] >> x3::lit(')')[on_close]);
    const auto bar = '|' >> !(x3::eps[is_closed_by_bar] >> (x3::lit('=') | "!="));
    const auto next = x3::raw[bar][infix(Kind::united, sum)] |
                      x3::raw[x3::lit('\\')][infix(Kind::difference, sum)] |
                      x3::raw[x3::lit('&')][infix(Kind::intersected, intersection)] |
                      x3::raw[x3::lit('.') | &(x3::char_("{/(~") | begins_grammar | known)]
                             [infix(Kind::concatenated, product)];
    grammar::read(here, end, (*prefix >> wanted("a language")[operand] >> *behind) % next);
    LanguageOperand whole = stack.finish();
    if (stack.depth() > 0) throw unexpected("an operator or ')'", here);
    return whole;
}

}  // namespace algae
