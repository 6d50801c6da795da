#include <fmt/format.h>

#include "cli/manual.hpp"

namespace algae::cli {

namespace {

/// A text that bash reads as it stands.
std::string in_quotes(const std::string& text) {
    std::string out = "'";
    for (const char letter : text)
        out += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
    return out + '\'';
}

std::string lines(const std::vector<std::string>& words) {
    return in_quotes(fmt::format("{}", fmt::join(words, "\n")));
}

/// `        --as) values='language\nsequence' ;;`, or nothing where nothing is known.
std::string branch(const std::string& pattern, const Values& values) {
    std::string does;
    if (!values.words.empty())
        does += " values=" + (values.words == gallery_names() ? "$names" : lines(values.words));
    if (values.files) does += " paths=files";
    if (!values.files && values.folders) does += " paths=folders";
    return does.empty() ? "" : "        " + pattern + ')' + does + " ;;\n";
}

std::string of_verb(const VerbEntry& verb) {
    std::vector<std::string> options{"--help"}, valued;
    std::string branches;
    for (const VerbOption& option : verb.options) {
        options.insert(options.end(), option.names.begin(), option.names.end());
        if (option.type.empty()) continue;
        valued.insert(valued.end(), option.names.begin(), option.names.end());
        branches += branch(fmt::format("{}", fmt::join(option.names, " | ")), verb.values(option));
    }
    for (std::size_t i = 0; i < verb.arguments.size(); ++i) {
        const VerbOption& argument = verb.arguments[i];
        branches +=
            branch(argument.repeated ? "[0-9]*" : std::to_string(i + 1), verb.values(argument));
    }
    return "    " + verb.name + ")\n        options=" + lines(options) +
           "\n        valued=" + in_quotes(fmt::format(" {} ", fmt::join(valued, " "))) +
           "\n        _algae_asked\n" +
           (branches.empty() ? "" : "        case $asked in\n" + branches + "        esac\n") +
           "        ;;\n";
}

// What stands before the word: an option that takes a value, or so many arguments. `--as=growth` comes
// in three words.
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

}  // namespace

std::string bash_completion(std::span<const VerbEntry> verbs) {
    std::vector<std::string> names;
    std::string cases;
    for (const VerbEntry& verb : verbs) {
        names.push_back(verb.name);
        cases += of_verb(verb);
    }
    return head + ("    local names=" + lines(gallery_names())) +
           "\n    case $verb in\n    '')\n        values=" + lines(names) +
           "\n        options='--help\n--version'\n        ;;\n" + cases + tail;
}

}  // namespace algae::cli
