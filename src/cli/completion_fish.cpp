#include <fmt/format.h>

#include "cli/manual.hpp"

namespace algae::cli {

namespace {

/// A text that fish reads as it stands.
std::string in_quotes(const std::string& text) {
    std::string out = "'";
    for (const char letter : text)
        out += (letter == '\'' || letter == '\\' ? "\\" : "") + std::string(1, letter);
    return out + '\'';
}

/// A list of completions for -a: words that hold spaces stay whole.
std::string set_of(const std::vector<std::string>& words) {
    std::string list;
    for (const std::string& word : words) {
        list += list.empty() ? "" : " ";
        list += word.find(' ') == std::string::npos ? word : in_quotes(word);
    }
    return in_quotes(list);
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

std::string of_verb(const VerbEntry& verb) {
    const std::string begin = "complete -c algae -n '__algae_verb " + verb.name + '\'';
    std::string text = '\n' + begin + " -s h -l help -d 'Print what the verb does'\n";
    for (const VerbOption& option : verb.options) {
        text += begin;
        for (const std::string& name : option.names)
            text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
        if (!option.type.empty()) text += (verb.values(option).files ? " -r" : " -x") + value(verb.values(option));
        text += " -d " + in_quotes(option.help) + '\n';
    }
    for (const VerbOption& argument : verb.arguments)
        if (const std::string what = value(verb.values(argument)); !what.empty())
            text += begin + what + '\n';
    return text;
}

}  // namespace

std::string fish_completion(std::span<const VerbEntry> verbs) {
    std::string text =
        "# Completion of algae(1) for fish, written by `algae manual --fish`.\n\n"
        "function __algae_verb\n    set -l words (commandline -opc)\n"
        "    if test (count $argv) -eq 0\n        test (count $words) -eq 1\n"
        "    else\n        test (count $words) -ge 2; and test $words[2] = $argv[1]\n    "
        "end\nend\n\n"
        "set -g __algae_names " +
        fmt::format("{}", fmt::join(gallery_names(), " ")) +
        "\n\n"
        "complete -c algae -f\n"
        "complete -c algae -n __algae_verb -s h -l help -d 'Print what algae does'\n"
        "complete -c algae -n __algae_verb -l version -d 'Print the version'\n";
    for (const VerbEntry& verb : verbs)
        text += "complete -c algae -n __algae_verb -a " + verb.name + " -d " +
                in_quotes(verb.help) + '\n';
    for (const VerbEntry& verb : verbs) text += of_verb(verb);
    return text;
}

}  // namespace algae::cli
