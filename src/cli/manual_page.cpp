#include <fmt/format.h>

#include "cli/manual.hpp"

namespace algae::cli {

namespace {

/// The character that begins at `at` of a text in UTF-8, and `at` behind it.
std::uint32_t next_character(const std::string& text, std::size_t& at) {
    const auto byte = static_cast<unsigned char>(text[at++]);
    std::uint32_t code = byte < 0xC0   ? byte
                         : byte < 0xE0 ? byte & 0x1Fu
                         : byte < 0xF0 ? byte & 0x0Fu
                                       : byte & 7u;
    while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0u) == 0x80)
        code = code << 6 | (static_cast<unsigned char>(text[at++]) & 0x3Fu);
    return code;
}

/// A text as roff has it: no character of it means a request or another character.
std::string roff(const std::string& text) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t begin = at;
        const std::uint32_t code = next_character(text, at);
        switch (code) {
            case '\\':
                out += "\\e";
                break;
            case '-':
                out += "\\-";
                break;
            case '\'':
                out += "\\(aq";
                break;
            case '"':
                out += "\\(dq";
                break;
            case '`':
                out += "\\(ga";
                break;
            case '^':
                out += "\\(ha";
                break;
            case '~':
                out += "\\(ti";
                break;
            default:
                if (code > 0x7F)
                    out += fmt::format("\\[u{:04X}]", code);
                else
                    out +=
                        (begin == 0 && code == '.' ? "\\&" : "") + text.substr(begin, at - begin);
        }
    }
    return out;
}

std::string sentence(std::string text) {
    if (!text.ends_with('.')) text += '.';
    return text;
}

/// "\fB-o\fR, \fB--output\fR \fIFILE\fR"
std::string tag(const VerbOption& option) {
    std::string text;
    const bool argument = !option.name().starts_with('-');
    for (const std::string& name : option.names)
        text += (text.empty() ? "" : ", ") + std::string(argument ? "\\fI" : "\\fB") + roff(name) +
                "\\fR";
    if (option.repeated) text += " ...";
    if (argument && option.type.find('|') != std::string::npos &&
        option.type.find("NAME") == std::string::npos)
        text += ": \\fI" + roff(option.type) + "\\fR";
    else if (!argument && !option.type.empty())
        text += " \\fI" + roff(option.type) + "\\fR";
    return text;
}

std::string entry(const VerbOption& option) {
    const std::string need = option.required && option.name().starts_with('-') ? " (required)" : "";
    return ".TP\n" + tag(option) + '\n' + roff(sentence(option.help + need)) + '\n';
}

std::string section(const VerbEntry& verb) {
    std::string text = ".SS " + roff(verb.name) + "\n.B " + roff(verb.usage()) + "\n.PP\n" +
                       roff(sentence(verb.help)) + '\n';
    for (const VerbOption& argument : verb.arguments) text += entry(argument);
    for (const VerbOption& option : verb.options)
        if (!option.bounds) text += entry(option);
    text += ".PP\n.EX\n";
    for (const std::string& example : verb.examples) text += "    " + roff(example) + '\n';
    return text + ".EE\n";
}

constexpr const char* introduction = R"(.SH DESCRIPTION
L\-systems, words that are rewritten letter by letter in parallel, are derived exactly, analysed and drawn.
A system is a text file:
.PP
.EX
    # Koch\(aqs snowflake
    axiom  F\-\-F\-\-F
    F \-> F+F\-\-F+F
    angle  60
.EE
.PP
An argument
.I FILE
is a path, \- for standard input, or a name that
.B algae gallery
lists.
Results go to standard output, all else to standard error; most verbs print one JSON object with
.BR \-\-json .
.SH OPTIONS
.TP
\fB\-h\fR, \fB\-\-help\fR
What the command does, or behind a verb what the verb does, with examples.
.TP
\fB\-\-version\fR
The version.
)";

constexpr const char* ending = R"(.SH EXIT STATUS
.TP
.B 0
Success; what was asked is true.
.TP
.B 1
What was asked is false: no member, not equal, a claim that does not stand, an expectation that fails.
.TP
.B 2
Bad usage or bad input. The message names the place, what was expected and what was found.
.TP
.B 3
Undecided, or a bound was reached.
.TP
.B 130
Interrupted by Ctrl\-C.
.SH FILES
Below the prefix of the installation, as
.IR /usr :
.TP
.I share/algae
The figures and systems of the gallery, the claims of the theory, the lessons, and files of other programs, to be read and
changed. The command holds all but the last and needs none of these files.
.TP
.I share/doc/algae/NOTATION.md
The notation of systems, relatives and claims.
.TP
.I share/doc/algae/CERTIFICATES.md
What a certificate is, and how
.B algae verify
checks it.
.SH SEE ALSO
.BR dot (1)
draws what
.B algae tree \-\-format dot
writes.
.PP
P. Prusinkiewicz and A. Lindenmayer,
.IR "The Algorithmic Beauty of Plants" ,
1990.
G. Rozenberg and A. Salomaa,
.IR "The Mathematical Theory of L Systems" ,
1980.
)";

}  // namespace

std::string manual_page(std::span<const VerbEntry> verbs) {
    std::string text = ".TH ALGAE 1 \"\" \"algae " ALGAE_VERSION
                       "\" \"User Commands\"\n.SH NAME\nalgae \\- "
                       "derives L\\-systems exactly, analyses and draws them\n.SH SYNOPSIS\n";
    const char* separator = "";
    for (const VerbEntry& verb : verbs) {
        text += separator + (".B " + roff(verb.usage()) + '\n');
        separator = ".br\n";
    }
    text += introduction;
    text += ".SH VERBS\n";
    for (const VerbEntry& verb : verbs) text += section(verb);
    text +=
        ".SH BOUNDS\nVerbs that work on a file take these; they end with status 3 where one is "
        "reached.\n";
    for (const VerbOption& option : verbs.front().options)
        if (option.bounds) text += entry(option);
    return text + ending;
}

}  // namespace algae::cli
