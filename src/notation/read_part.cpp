#include "notation/characters.hpp"
#include "notation/expression_grammar.hpp"
#include "notation/findings.hpp"
#include "notation/read.hpp"
#include "notation/word_grammar.hpp"

namespace algae {

namespace {

/// What `read` makes of a text that is not a whole file.
template <class Read>
auto read_part(std::string_view text, const char* name, Read read) {
    const Source source(text, name);
    Findings findings(source);
    findings.throw_if_no_text();
    try {
        return read(source);
    } catch (const SyntaxError& error) {
        findings.add(error);
        findings.throw_if_any();
        throw;
    }
}

}  // namespace

ModuleWord read_word(std::string_view text, Alphabet& alphabet) {
    return read_part(text, "word", [&](const Source& source) {
        Lexicon lexicon(alphabet);
        return parse_word(text, lexicon, source);
    });
}

Expression read_expression(std::string_view text) {
    return read_part(text, "expression",
                     [&](const Source& source) { return parse_expression(trimmed(text), source); });
}

}  // namespace algae
