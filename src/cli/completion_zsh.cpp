#include <fmt/format.h>

#include "cli/manual.hpp"

namespace algae::cli {

namespace {

/// A text within '...' of _arguments: the characters that end a help, or a specification, escaped.
std::string escaped(const std::string& text) {
    std::string out;
    for (const char letter : text) {
        if (letter == '\'')
            out += "'\\''";
        else if (letter == '[' || letter == ']' || letter == ':' || letter == '\\')
            out += std::string("\\") + letter;
        else
            out += letter;
    }
    return out;
}

/// The words of a set as _arguments takes them, "svg pdf".
std::string set_of(const std::vector<std::string>& words) {
    std::string out;
    for (const std::string& word : words) {
        out += out.empty() ? "" : " ";
        for (const char letter : word)
            out += letter == ' ' ? std::string("\\ ") : std::string(1, letter);
    }
    return out;
}

/// ":N: ", ":format:(svg pdf)", ":FILE:_files", or words and files.
std::string value(const VerbEntry& verb, const VerbOption& option) {
    const Values values = verb.values(option);
    const bool set = option.name().starts_with('-') && !values.words.empty();
    const std::string message =
        escaped(set || option.name()[0] != '-' ? option.name() : option.type);
    if (values.words.empty())
        return ':' + message + ':' + (values.files ? "_files" : values.folders ? "_files -/" : " ");
    if (!values.files && !values.folders)
        return ':' + message + ":(" + set_of(values.words) + ')';
    return ':' + message + ": _algae_names_and_files " + (verb.is_generator() ? verb.name : "all");
}

std::string specification(const VerbEntry& verb, const VerbOption& option, std::size_t place) {
    if (!option.name().starts_with('-'))
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

std::string of_verb(const VerbEntry& verb) {
    std::string text =
        "    " + verb.name +
        ")\n      _arguments -s \\\n        '(- *)'{-h,--help}'[print what the verb does]'";
    for (const VerbOption& option : verb.options)
        text += " \\\n        " + specification(verb, option, 0);
    for (std::size_t i = 0; i < verb.arguments.size(); ++i)
        text += " \\\n        " + specification(verb, verb.arguments[i], i + 1);
    return text + " && ret=0\n      ;;\n";
}

}  // namespace

std::string zsh_completion(std::span<const VerbEntry> verbs) {
    std::string descriptions, cases, names;
    for (const VerbEntry& verb : verbs) {
        descriptions += "      '" + verb.name + ':' + escaped(verb.help) + "'\n";
        cases += of_verb(verb);
        for (const VerbOption& argument : verb.arguments)
            if (verb.values(argument).files && !verb.values(argument).words.empty()) {
                const std::string kind = verb.is_generator() ? verb.name : "all";
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

}  // namespace algae::cli
