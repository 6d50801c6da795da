#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "language/detail/proof.hpp"

// Proofs in LaTeX: the sentences, with words and terms as mathematics.
//
// The sentences bear marks (detail/proof.hpp). What stands outside them is prose, of which only characters with a
// meaning in LaTeX are escaped and arrows are set. A word is set letter by letter, names of several characters
// upright; in a term the operators of languages become those of the field: union, intersection, difference.

namespace algae {

namespace {

struct Replacement {
    std::string_view text, latex;
};

/// The first that the text begins with; nothing if there is none.
template <std::size_t n>
const Replacement* replacement(const std::array<Replacement, n>& all, std::string_view text) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const Replacement& each) {
        return text.starts_with(each.text);
    });
    return found == all.end() ? nullptr : &*found;
}

// Longer texts stand before those that they begin with.
constexpr auto in_prose = std::to_array<Replacement>({{"==>", "$\\Longrightarrow$"},
                                                      {"=>", "$\\Rightarrow$"},
                                                      {"->", "$\\to$"},
                                                      {"<=", "$\\le$"},
                                                      {"...", "\\dots{}"},
                                                      {"…", "\\dots{}"},
                                                      {"ε", "$\\varepsilon$"},
                                                      {"\\", "\\textbackslash{}"},
                                                      {"{", "\\{"},
                                                      {"}", "\\}"},
                                                      {"^", "\\textasciicircum{}"},
                                                      {"~", "\\textasciitilde{}"},
                                                      {"|", "$\\mid$"},
                                                      {"<", "$<$"},
                                                      {">", "$>$"},
                                                      {"\"", "''"},
                                                      {"*", "$*$"}});

constexpr auto in_word = std::to_array<Replacement>({{"ε", "\\varepsilon "},
                                                     {"\\", "\\backslash "},
                                                     {"{", "\\{"},
                                                     {"}", "\\}"},
                                                     {"^", "\\hat{\\ }"},
                                                     {"~", "\\sim "},
                                                     {"|", "\\vert "},
                                                     {" ", "\\;"}});

constexpr auto in_term = std::to_array<Replacement>({{"ε", "\\varepsilon "},
                                                     {"->", "\\to "},
                                                     {" \\ ", " \\setminus "},
                                                     {" | ", " \\cup "},
                                                     {" & ", " \\cap "},
                                                     {" . ", " \\cdot "},
                                                     {" = ", " = "},
                                                     {"\\", "\\backslash "},
                                                     {"{", "\\{"},
                                                     {"}", "\\}"},
                                                     {"^-1", "^{-1}"},
                                                     {"~", "\\complement "},
                                                     {"|", "\\mid "},
                                                     {" ", "\\ "},
                                                     {"\"", "''"}});

bool is_special(char c) { return c == '#' || c == '$' || c == '%' || c == '&' || c == '_'; }

/// The bytes of the character that the text begins with.
std::size_t character_size(std::string_view text) {
    std::size_t size = 1;
    while (size < text.size() && (static_cast<unsigned char>(text[size]) & 0xC0) == 0x80) ++size;
    return size;
}

/// The text with its replacements, special characters escaped, and other characters as they are, or by `other`.
template <std::size_t n, class Other>
std::string set(std::string_view text, const std::array<Replacement, n>& all, Other other) {
    std::string result;
    while (!text.empty()) {
        std::size_t size = character_size(text);
        if (const Replacement* const found = replacement(all, text)) {
            result += found->latex;
            size = found->text.size();
        } else if (is_special(text.front())) {
            result += std::string("\\") + text.front();
        } else {
            size = other(text, size, result);
        }
        text.remove_prefix(size);
    }
    return result;
}

std::size_t as_it_is(std::string_view text, std::size_t size, std::string& result) {
    result += text.substr(0, size);
    return size;
}

bool is_alphanumeric(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

/// In mathematics: names of several characters and exponents as one, characters beyond ASCII as text; a star
/// stands for a product in front of a factor, and otherwise for the iteration of a language.
std::size_t in_mathematics(std::string_view text, std::size_t size, std::string& result) {
    if (size > 1) {
        result += "\\text{" + std::string(text.substr(0, size)) + "}";
        return size;
    }
    const bool is_factor = text.size() > 1 && (is_alphanumeric(text[1]) || text[1] == '(');
    if (text.front() == '*') {
        result += is_factor ? "\\cdot " : "^{*}";
        return 1;
    }
    const bool is_power = text.front() == '^';
    const auto end =
        std::find_if_not(text.begin() + (is_power ? 1 : 0), text.end(), is_alphanumeric);
    const auto length = static_cast<std::size_t>(end - text.begin());
    if (is_power) {
        result += "^{" + std::string(text.substr(1, length - 1)) + "}";
        return length;
    }
    if (length <= 1 || std::isdigit(static_cast<unsigned char>(text.front())) != 0)
        return as_it_is(text, 1, result);
    result += "\\mathit{" + std::string(text.substr(0, length)) + "}";
    return length;
}

/// One sentence with marks.
std::string sentence_latex(std::string_view sentence) {
    std::string result;
    while (!sentence.empty()) {
        const std::size_t begin = std::min(
            sentence.find_first_of(std::string{word_begins, term_begins}), sentence.size());
        result += set(sentence.substr(0, begin), in_prose, as_it_is);
        sentence.remove_prefix(begin);
        if (sentence.empty()) break;
        const bool is_word = sentence.front() == word_begins;
        const std::size_t end = sentence.find(mark_ends);
        const std::string_view inside = sentence.substr(1, end - 1);
        result += "$" +
                  (is_word ? set(inside, in_word, in_mathematics)
                           : set(inside, in_term, in_mathematics)) +
                  "$";
        sentence.remove_prefix(end + 1);
    }
    return result;
}

}  // namespace

std::string latex(const Answer& answer, const Alphabet& alphabet) {
    std::string text;
    for (const std::string& line : marked_sentences(answer, alphabet)) {
        const std::size_t blanks = std::min(line.find_first_not_of(' '), line.size());
        const std::string set = sentence_latex(std::string_view(line).substr(blanks));
        if (blanks > 0)
            text += "\\par{\\leftskip=" + std::to_string(blanks) + "em " + set + "\\par}\n";
        else
            text += set + "\n";
    }
    return text;
}

std::string latex(const CheckedClaim& checked) {
    const Claim& claim = checked.claim;
    std::string text = "\\section*{" + set(claim.title, in_prose, as_it_is) + "}\n";
    if (!claim.source.empty()) text += set(claim.source, in_prose, as_it_is) + "\n";
    for (std::size_t i = 0; i < checked.statements.size(); ++i) {
        const ClaimedStatement& claimed = claim.statements[i];
        const CheckedStatement& found = checked.statements[i];
        const bool cited = found.outcome == CheckedStatement::Outcome::cited;
        text += "\n\\paragraph{" + std::to_string(i + 1) + "} " + "\\texttt{" +
                set(claimed.statement.text, in_prose, as_it_is) + "}: " + verdict_text(found) +
                (cited ? " (" + set(claimed.citation, in_prose, as_it_is) + ")" : "") + ".\n";
        if (cited) continue;
        const std::string argument = latex(found.answer, *claim.alphabet);
        text += found.answer.proof ? "\\begin{proof}\n" + argument + "\\end{proof}\n" : argument;
    }
    return text;
}

}  // namespace algae
