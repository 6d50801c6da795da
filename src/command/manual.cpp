// `algae manual`: the page algae(1) and the completions of three shells, written from the table of verbs.
//
// Nothing about an option is repeated here: its type says which values may follow it (Verb::values), so that a
// new option is completed and documented when it is declared. Each language has its own quoting. bash gets
// one function that needs only bash and looks at the words before the cursor; zsh gets a specification for
// _arguments; fish one `complete` for each option.

#include <fmt/format.h>

#include <map>

#include "command/detail/output.hpp"
#include "command/detail/verb.hpp"
#include "exact/exact.hpp"

namespace algae::command {

namespace {

/// The verbs that are not hidden.
using Table = std::vector<Verb>;

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

/// A text for roff: no character of it is taken for a request or another character.
std::string roff(const std::string& text) {
    static const std::map<std::uint32_t, const char*> names{
        {'\\', "\\e"},  {'-', "\\-"},   {'\'', "\\(aq"}, {'"', "\\(dq"}, {'`', "\\(ga"},
        {'^', "\\(ha"}, {'~', "\\(ti"}, {'|', "|\\:"}};  // a line may end behind it
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t begin = at;
        const std::uint32_t code = next_character(text, at);
        const auto meant = names.find(code);
        if (meant != names.end())
            out += meant->second;
        else if (code > 0x7F)
            out += fmt::format("\\[u{:04X}]", code);
        else
            out += (begin == 0 && code == '.' ? "\\&" : "") + text.substr(begin, at - begin);
    }
    return out;
}

/// A text with some of its characters written in another way.
std::string rewritten(const std::string& text, const std::map<char, const char*>& ways) {
    std::string out;
    for (const char letter : text)
        if (const auto way = ways.find(letter); way != ways.end())
            out += way->second;
        else
            out += letter;
    return out;
}

std::string sentence(std::string text) {
    if (!text.ends_with('.')) text += '.';
    return text;
}

/// "\fB-o\fR, \fB--output\fR \fIFILE\fR"
std::string tag(const Option& option) {
    std::string text;
    const bool argument = option.is_argument();
    for (const std::string& name : option.names)
        text += (text.empty() ? "" : ", ") + std::string(argument ? "\\fI" : "\\fB") + roff(name) +
                "\\fR";
    if (option.repeated && argument) text += " ...";
    if (argument && option.type.find('|') != std::string::npos &&
        option.type.find("NAME") == std::string::npos)
        text += ": \\fI" + roff(option.type) + "\\fR";
    else if (!argument && !option.type.empty())
        text += " \\fI" + roff(option.type) + "\\fR";
    return text;
}

std::string entry(const Option& option) {
    const std::string need = option.required && !option.is_argument() ? " (required)" : "";
    return ".TP\n" + tag(option) + '\n' + roff(sentence(option.help + need)) + '\n';
}

std::string section(const Verb& verb) {
    std::string text = ".SS " + roff(verb.name) + "\n.B " + roff(verb.usage()) + "\n.PP\n" +
                       roff(sentence(verb.help)) + '\n';
    for (const Option& argument : verb.arguments) text += entry(argument);
    for (const Option& option : verb.options)
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
.SH ENVIRONMENT
.TP
.B ALGAE_PROGRESS
Work of more than five seconds says on standard error where it is, every ten seconds, on a terminal every second. This variable
has other seconds for both, from 0.1 on.
.SH FILES
Below the prefix of the installation, as
.IR /usr :
.TP
.I share/algae
The figures and systems of the gallery, the claims of the theory, the lessons, and files of other programs, to be read and
changed. The command holds all but the last and needs none of these files.
.TP
.I share/doc/algae/NOTATION.md
The notation of systems, generators and claims.
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

std::string manual_page(const Table& verbs) {
    std::string text = ".TH ALGAE 1 \"\" \"algae " ALGAE_VERSION
                       "\" \"User Commands\"\n.SH NAME\nalgae \\- "
                       "derives L\\-systems exactly, analyses and draws them\n.SH SYNOPSIS\n";
    const char* separator = "";
    for (const Verb& verb : verbs) {
        text += separator + (".B " + roff(verb.usage()) + '\n');
        separator = ".br\n";
    }
    text += introduction;
    text += ".SH VERBS\n";
    for (const Verb& verb : verbs) text += section(verb);
    text +=
        ".SH BOUNDS\nVerbs that work on a file take these; they end with status 3 where one is "
        "reached.\n";
    for (const Option& option : verbs.front().options)
        if (option.bounds) text += entry(option);
    return text + ending;
}

namespace bash {

/// A text that bash reads as it stands.
std::string in_quotes(const std::string& text) {
    return '\'' + rewritten(text, {{'\'', "'\\''"}}) + '\'';
}

std::string lines(const std::vector<std::string>& words) { return in_quotes(joined(words, "\n")); }

/// `        --as) values='language\nsequence' ;;`, or nothing where nothing is known.
std::string branch(const std::string& pattern, const Values& values) {
    std::string does;
    if (!values.words.empty())
        does += " values=" + (values.words == gallery_names() ? "$names" : lines(values.words));
    if (values.files) does += " paths=files";
    if (!values.files && values.folders) does += " paths=folders";
    return does.empty() ? "" : "        " + pattern + ')' + does + " ;;\n";
}

std::string of_verb(const Verb& verb) {
    std::vector<std::string> options{"--help"}, valued;
    std::string branches;
    for (const Option& option : verb.options) {
        options.insert(options.end(), option.names.begin(), option.names.end());
        if (option.type.empty()) continue;
        valued.insert(valued.end(), option.names.begin(), option.names.end());
        branches += branch(joined(option.names, " | "), verb.values(option));
    }
    for (std::size_t i = 0; i < verb.arguments.size(); ++i) {
        const Option& argument = verb.arguments[i];
        branches +=
            branch(argument.repeated ? "[0-9]*" : std::to_string(i + 1), verb.values(argument));
    }
    return "    " + verb.name + ")\n        options=" + lines(options) +
           "\n        valued=" + in_quotes(fmt::format(" {} ", fmt::join(valued, " "))) +
           "\n        _algae_asked\n" +
           (branches.empty() ? "" : "        case $asked in\n" + branches + "        esac\n") +
           "        ;;\n";
}

// The words before the cursor: an option that takes a value, or a number of arguments. `--as=growth` comes
// as three words.
constexpr const char* head = R"(# Completion of algae(1) for bash, written by `algae manual --bash`.

_algae_asked() {
    local i=2 place=1 word
    asked=
    while ((i < COMP_CWORD)); do
        word=${COMP_WORDS[i++]}
        if [[ $valued == *" $word "* ]]; then
            if [[ ${COMP_WORDS[i]} == = ]]; then ((i++)); fi
            if ((i >= COMP_CWORD)); then asked=$word; fi
            ((i++))
        elif [[ $word != -?* ]]; then
            ((place++))
        fi
    done
    if [[ -z $asked ]]; then asked=$place; fi
}

_algae() {
    local word=${COMP_WORDS[COMP_CWORD]} verb=${COMP_WORDS[1]} options= valued= values= paths= asked=1 i
    COMPREPLY=()
    if ((COMP_CWORD == 1)); then verb=; fi
)";

constexpr const char* tail = R"(    esac
    if [[ $word == = ]]; then word=; fi
    if [[ $asked == [0-9]* && $word == -* ]]; then values=$options paths=; fi
    mapfile -t COMPREPLY < <(IFS=$'\n' compgen -W "$values" -- "$word")
    if [[ -z $paths ]]; then
        for i in "${!COMPREPLY[@]}"; do printf -v "COMPREPLY[i]" %q "${COMPREPLY[i]}"; done
        return
    fi
    compopt -o filenames 2>/dev/null
    if [[ $paths == files ]]; then
        mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -f -- "$word")
    else
        mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -d -- "$word")
    fi
}

complete -F _algae algae
)";

std::string completion(const Table& verbs) {
    std::vector<std::string> names;
    std::string cases;
    for (const Verb& verb : verbs) {
        names.push_back(verb.name);
        cases += of_verb(verb);
    }
    return head + ("    local names=" + lines(gallery_names())) +
           "\n    case $verb in\n    '')\n        values=" + lines(names) +
           "\n        options='--help\n--version'\n        ;;\n" + cases + tail;
}

}  // namespace bash

namespace zsh {

/// A text within '...' of _arguments: the characters that end a help, or a specification, escaped.
std::string escaped(const std::string& text) {
    return rewritten(text,
                     {{'\'', "'\\''"}, {'[', "\\["}, {']', "\\]"}, {':', "\\:"}, {'\\', "\\\\"}});
}

/// The words of a set as _arguments takes them, "svg pdf".
std::string set_of(const std::vector<std::string>& words) {
    std::string out;
    for (const std::string& word : words)
        out += (out.empty() ? "" : " ") + rewritten(word, {{' ', "\\ "}});
    return out;
}

/// ":N: ", ":format:(svg pdf)", ":FILE:_files", or words and files.
std::string value(const Verb& verb, const Option& option) {
    const Values values = verb.values(option);
    const bool set = !option.is_argument() && !values.words.empty();
    const std::string message = escaped(set || option.is_argument() ? option.name() : option.type);
    if (values.words.empty())
        return ':' + message + ':' + (values.files ? "_files" : values.folders ? "_files -/" : " ");
    if (!values.files && !values.folders) return ':' + message + ":(" + set_of(values.words) + ')';
    return ':' + message + ": _algae_names_and_files " +
           (verb.names_generators() ? verb.name : "all");
}

std::string specification(const Verb& verb, const Option& option, std::size_t place) {
    if (option.is_argument())
        return '\'' + (option.repeated ? std::string("*") : std::to_string(place)) +
               value(verb, option) + '\'';
    const std::string help =
        '[' + escaped(option.help) + ']' + (option.type.empty() ? "" : value(verb, option));
    if (option.names.size() == 1) {
        const bool joined = option.name().starts_with("--") && !option.type.empty();
        return '\'' + option.name() + (joined ? "=" : "") + help + '\'';
    }
    std::string names;
    for (const std::string& name : option.names)
        names += (names.empty() ? "" : ",") + name +
                 (option.type.empty()      ? ""
                  : name.starts_with("--") ? "="
                                           : "+");
    return fmt::format("'({})'{{{}}}'{}'", fmt::join(option.names, " "), names, help);
}

std::string of_verb(const Verb& verb) {
    std::string text =
        "    " + verb.name +
        ")\n      _arguments -s \\\n        '(- *)'{-h,--help}'[print what the verb does]'";
    for (const Option& option : verb.options)
        text += " \\\n        " + specification(verb, option, 0);
    for (std::size_t i = 0; i < verb.arguments.size(); ++i)
        text += " \\\n        " + specification(verb, verb.arguments[i], i + 1);
    return text + " && ret=0\n      ;;\n";
}

std::string completion(const Table& verbs) {
    std::string descriptions, cases, names;
    for (const Verb& verb : verbs) {
        descriptions += "      '" + verb.name + ':' + escaped(verb.help) + "'\n";
        cases += of_verb(verb);
        for (const Option& argument : verb.arguments)
            if (verb.values(argument).files && !verb.values(argument).words.empty()) {
                const std::string kind = verb.names_generators() ? verb.name : "all";
                if (names.find("  " + kind + ") ") == std::string::npos)
                    names +=
                        "  " + kind + ") names=(" + set_of(verb.values(argument).words) + ") ;;\n";
            }
    }
    return "#compdef algae\n# Completion of algae(1) for zsh, written by `algae manual --zsh`.\n\n"
           "# Names of the gallery, all or those of a kind of generator, and files.\n"
           "_algae_names_and_files() {\n  local -a names\n  case $1 in\n" +
           names +
           "  esac\n  _alternative 'names:name from the gallery:compadd -a names' "
           "'files:file:_files'\n}\n\n"
           "_algae() {\n  local curcontext=$curcontext state line ret=1\n  local -a verbs\n  "
           "typeset -A opt_args\n"
           "  _arguments -C '(- *)'{-h,--help}'[print what algae does]' '(- *)--version[print the "
           "version]' \\\n"
           "    '1:verb:->verb' '*::argument:->arguments' && ret=0\n"
           "  case $state in\n  verb)\n    verbs=(\n" +
           descriptions +
           "    )\n    _describe -t verbs verb verbs && ret=0\n    ;;\n  arguments)\n"
           "    curcontext=${curcontext%:*:*}:algae-$words[1]:\n    case $words[1] in\n" +
           cases + "    esac\n    ;;\n  esac\n  return ret\n}\n\n_algae \"$@\"\n";
}

}  // namespace zsh

namespace fish {

/// A text that fish reads as it stands.
std::string in_quotes(const std::string& text) {
    return '\'' + rewritten(text, {{'\'', "\\'"}, {'\\', "\\\\"}}) + '\'';
}

/// A list of completions for -a: words that hold spaces stay whole.
std::string set_of(const std::vector<std::string>& words) {
    return in_quotes(joined(words, " ", [](const std::string& word) {
        return word.find(' ') == std::string::npos ? word : in_quotes(word);
    }));
}

/// What follows an option or stands for an argument: a set, files, folders, or both.
std::string value(const Values& values) {
    std::string text = values.files ? " -F" : "";
    if (!values.words.empty())
        text +=
            " -a " + (values.words == gallery_names() ? "'$__algae_names'" : set_of(values.words));
    if (!values.files && values.folders) text += " -a '(__fish_complete_directories)'";
    return text;
}

std::string of_verb(const Verb& verb) {
    const std::string begin = "complete -c algae -n '__algae_verb " + verb.name + '\'';
    std::string text = '\n' + begin + " -s h -l help -d 'Print what the verb does'\n";
    for (const Option& option : verb.options) {
        text += begin;
        for (const std::string& name : option.names)
            text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
        if (!option.type.empty())
            text += (verb.values(option).files ? " -r" : " -x") + value(verb.values(option));
        text += " -d " + in_quotes(option.help) + '\n';
    }
    for (const Option& argument : verb.arguments)
        if (const std::string what = value(verb.values(argument)); !what.empty())
            text += begin + what + '\n';
    return text;
}

std::string completion(const Table& verbs) {
    std::string text =
        "# Completion of algae(1) for fish, written by `algae manual --fish`.\n\n"
        "function __algae_verb\n    set -l words (commandline -opc)\n"
        "    if test (count $argv) -eq 0\n        test (count $words) -eq 1\n"
        "    else\n        test (count $words) -ge 2; and test $words[2] = $argv[1]\n    "
        "end\nend\n\n"
        "set -g __algae_names " +
        joined(gallery_names(), " ") +
        "\n\n"
        "complete -c algae -f\n"
        "complete -c algae -n __algae_verb -s h -l help -d 'Print what algae does'\n"
        "complete -c algae -n __algae_verb -l version -d 'Print the version'\n";
    for (const Verb& verb : verbs)
        text += "complete -c algae -n __algae_verb -a " + verb.name + " -d " +
                in_quotes(verb.help) + '\n';
    for (const Verb& verb : verbs) text += of_verb(verb);
    return text;
}

}  // namespace fish

struct Options {
    const Verbs* verbs = nullptr;
    bool page = false, bash = false, zsh = false, fish = false;
};

int manual(const Options& options) {
    Table table;
    for (const Verb& verb : options.verbs->all)
        if (!verb.hidden) table.push_back(verb);
    if (options.page + options.bash + options.zsh + options.fish != 1)
        throw Error("expected one of --man, --bash, --zsh and --fish");
    print(options.page   ? manual_page(table)
          : options.bash ? bash::completion(table)
          : options.zsh  ? zsh::completion(table)
                         : fish::completion(table));
    return success;
}

}  // namespace

void add_manual(Verbs& verbs) {
    auto [verb, options] =
        verbs.add("manual", "The manual page, and completions of verbs and options for shells",
                  {"algae manual --man > algae.1", "source <(algae manual --bash)"}, manual);
    verb.hidden = true;  // for who installs algae
    options.verbs = &verbs;
    verb.flag("--man", options.page, "the page algae(1), in the language of man");
    verb.flag("--bash", options.bash, "completions for bash");
    verb.flag("--zsh", options.zsh, "completions for zsh");
    verb.flag("--fish", options.fish, "completions for fish");
}

}  // namespace algae::command
