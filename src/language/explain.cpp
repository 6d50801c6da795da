#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <sstream>
#include <string_view>

#include "language/detail/judge.hpp"
#include "language/detail/proof.hpp"
#include "system/system.hpp"
#include "word/word.hpp"

// A claim as a page: definitions as "Let G be ...", then each statement with its verdict and argument, wrapped
// to lines of 100 characters.
//
// Proofs in LaTeX: the sentences, with words and terms as mathematics.
//
// The sentences bear marks (detail/proof.hpp). What stands outside them is prose, of which only characters with a
// meaning in LaTeX are escaped and arrows are set. A word is set letter by letter, names of several characters
// upright; in a term the operators of languages become those of the field: union, intersection, difference.

namespace algae {

namespace {

std::string word_text(const Alphabet& alphabet, const ModuleWord& word) {
    if (word.letters.empty()) return "ε";
    std::string text;
    for (std::size_t i = 0; i < word.letters.size(); ++i) {
        const auto arguments = word.arguments.find(i);
        const bool long_names = alphabet.name(word.letters[i]).size() > 1;
        if (i > 0 && long_names && text.back() != ')') text += ' ';
        text += alphabet.name(word.letters[i]);
        if (arguments == word.arguments.end()) continue;
        text += "(" + joined(arguments->second, ",", to_text) + ")";
    }
    return text;
}

std::string pattern_text(const Alphabet& alphabet, const Pattern& pattern, const char* between) {
    return joined(pattern, between, [&](const ModulePattern& module) {
        const std::string list = joined(module.parameters, ",");
        return alphabet.name(module.symbol) + (list.empty() ? "" : "(" + list + ")");
    });
}

std::string rule_text(const Alphabet& alphabet, const Production& rule) {
    std::string text = pattern_text(alphabet, {rule.predecessor}, "");
    if (!rule.left.empty()) text = pattern_text(alphabet, rule.left, "") + " < " + text;
    if (!rule.right.empty()) text += " > " + pattern_text(alphabet, rule.right, "");
    if (!rule.elsewhere.empty()) text += " ? " + pattern_text(alphabet, rule.elsewhere, ", ");
    if (rule.condition) text += " : " + to_text(*rule.condition);
    text += rule.probability ? " -(" + to_string(*rule.probability) + ")-> " : " -> ";
    return text + word_text(alphabet, rule.successor);
}

}  // namespace

std::string rewriting_text(const LSystem& system) {
    Class kind = class_of(system);
    const bool conditional = std::exchange(kind.conditional, false);
    std::string text = "the " + kind.name() + " system with " +
                       (conditional ? "context conditions and " : "") + "axiom " +
                       word_text(system.alphabet, system.axiom);
    for (const Production& rule : system.rules) text += "; " + rule_text(system.alphabet, rule);
    std::string ignored;
    for (const Symbol letter : system.ignored) ignored += " " + system.alphabet.name(letter);
    if (!ignored.empty()) text += "; ignored are" + ignored;
    std::string constants;
    for (const auto& [name, value] : system.constants)
        constants +=
            (constants.empty() ? ", where " : ", ") + name + " = " + to_text(value.expression);
    return text + constants;
}

namespace {

constexpr std::size_t width = 100;

/// How many characters a text takes on a line: its code points.
std::size_t columns(const std::string& text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

/// The text with a break and the indentation wherever a line would be too long. Blanks that a line begins with
/// add to it.
std::string wrapped(const std::string& text, std::size_t indentation) {
    const std::size_t blanks = std::min(text.find_first_not_of(' '), text.size());
    const std::string margin(indentation + blanks, ' ');
    std::string result = margin;
    std::size_t column = margin.size();
    std::istringstream words(text);
    words.exceptions(std::ios::badbit);
    bool first = true;
    for (std::string word; words >> word;) {
        if (!first && column + 1 + columns(word) > width) {
            result += '\n' + margin;
            column = margin.size();
        } else if (!first) {
            result += ' ';
            ++column;
        }
        result += word;
        column += columns(word);
        first = false;
    }
    return result + '\n';
}

std::string rules_text(const Table& table, const std::vector<Symbol>& letters,
                       const Alphabet& alphabet) {
    std::string text;
    for (const Symbol a : letters) {
        if (table[a] == std::vector<Word>{Word{a}}) continue;
        text += "; " + alphabet.name(a) + " -> ";
        for (std::size_t i = 0; i < table[a].size(); ++i)
            text += (i > 0 ? " | " : "") + spell(alphabet, table[a][i]);
    }
    return text;
}

}  // namespace

std::string system_text(const SourceSystem& system, const Alphabet& alphabet) {
    if (!system.tables) {
        std::string text = "the system with axiom " + spell(alphabet, system.interactive->axiom);
        for (Symbol a = 0; a < system.interactive->rules.size(); ++a) {
            const IL::Rule* before = nullptr;
            for (const IL::Rule& rule : system.interactive->rules[a]) {
                if (before && before->left == rule.left && before->right == rule.right)
                    text += " | ";
                else
                    text += "; " + (rule.left.empty() ? "" : spell(alphabet, rule.left) + " < ") +
                            alphabet.name(a) +
                            (rule.right.empty() ? "" : " > " + spell(alphabet, rule.right)) +
                            " -> ";
                text += spell(alphabet, rule.successor);
                before = &rule;
            }
        }
        return text;
    }
    const ET0L& tables = *system.tables;
    const std::vector<Symbol> letters = accessible_letters(tables);
    std::string text =
        "the " + family_name(tables) + " system with axiom " + spell(alphabet, tables.axiom);
    for (std::size_t t = 0; t < tables.tables.size(); ++t) {
        const std::string rules = rules_text(tables.tables[t], letters, alphabet);
        if (tables.tables.size() == 1)
            text += rules;
        else
            text += "; table " + tables.table_names[t] + " {" +
                    (rules.empty() ? "" : rules.substr(1)) + " }";
    }
    if (has_only_terminals(tables)) return text;
    text += "; terminals";
    for (const Symbol a : letters)
        if (tables.terminal[a]) text += " " + alphabet.name(a);
    return text;
}

namespace {

/// Whether a statement says of another family what one of the claim says of this one.
bool is_about_another(const Claim& claim, const Statement& statement, const std::string& family) {
    const auto* said = std::get_if<InFamily>(&statement.says);
    if (!said || said->family == family) return false;
    return std::any_of(claim.statements.begin(), claim.statements.end(),
                       [&](const ClaimedStatement& claimed) {
                           const auto* other = std::get_if<InFamily>(&claimed.statement.says);
                           return other && other->family == family &&
                                  claimed.statement.negated == statement.negated &&
                                  to_string(other->language, *claim.alphabet) ==
                                      to_string(said->language, *claim.alphabet);
                       });
}

}  // namespace

std::string explanation(const CheckedClaim& checked, const std::string& family) {
    const Claim& claim = checked.claim;
    std::string page = wrapped(claim.title, 0);
    if (!claim.source.empty()) page += wrapped(claim.source, 0);
    const bool defines = claim.empty_axiom || !claim.systems.empty() || !claim.rewritings.empty() ||
                         !claim.languages.empty();
    if (!claim.notes.empty()) page += '\n';
    for (const std::string& note : claim.notes) page += wrapped(note, 0);
    if (defines) page += '\n';
    if (claim.empty_axiom) page += wrapped("Systems may have the empty word as axiom.", 0);
    for (const auto& system : claim.systems)
        if (system->grammar.empty())
            page += wrapped(
                "Let " + system->name + " be " + system_text(*system, *claim.alphabet) + ".", 0);
    for (const auto& system : claim.rewritings)
        page += wrapped("Let " + system->name + " be " + rewriting_text(*system) + ".", 0);
    for (const Language& language : claim.languages)
        page += wrapped(
            "Let " + language->name + " = " + unnamed_text(language, *claim.alphabet) + ".", 0);
    if (const std::string over = complement_text(claim.letters, *claim.alphabet); !over.empty())
        page += wrapped("In what follows, " + over, 0);
    std::set<std::string> said;  // what a statement begins with is not repeated for the next one
    std::size_t number = 0;
    for (std::size_t i = 0; i < checked.statements.size(); ++i) {
        const ClaimedStatement& claimed = claim.statements[i];
        const CheckedStatement& found = checked.statements[i];
        if (!family.empty() && is_about_another(claim, claimed.statement, family)) continue;
        const bool is_theorem = claimed.purpose == ClaimedStatement::Purpose::theorem;
        page +=
            "\n" + wrapped((is_theorem ? "Theorem. " : std::to_string(++number) + ". ") +
                               claimed.statement.text + ": " + verdict_text(found) +
                               (found.is_by_citation() ? " (" + claimed.citation + ")" : "") + ".",
                           0);
        if (found.is_by_citation()) continue;
        const std::vector<std::string> argument = sentences(found.answer, *claim.alphabet);
        std::size_t first = 0;
        while (first + 1 < argument.size() && said.contains(argument[first])) ++first;
        for (std::size_t line = first; line < argument.size(); ++line)
            page += wrapped(argument[line], 3);
        said.insert(argument.begin(), argument.end());
    }
    return page;
}

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
        const bool cited = found.is_by_citation();
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
