// The declaration of verbs, and the reading of the command line. This is the only file that uses CLI11.
//
// A value is checked in two steps. CLI11 knows the grammar of a command line: which options there are, which
// take a value, which are required, need or exclude others; its messages end with a hint to --help. Then
// the readers of the verb convert the texts to numbers, ranges and lists, bounds first; their messages
// name the option and what was expected. The verb runs only after that: if the command line has a mistake,
// nothing is read or written.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <optional>
#include <set>
#include <sstream>

#include "command/detail/memory.hpp"
#include "command/detail/output.hpp"
#include "command/detail/verb.hpp"
#include "exact/exact.hpp"
#include "notation/notation.hpp"
#include "render/render.hpp"
#include "system/system.hpp"
#include "turtle/turtle.hpp"

namespace algae::command {

std::atomic<bool> stop = false;
const std::function<void()>* at_check = nullptr;

void refuse_with(const std::string& option,
                 const std::vector<std::pair<const char*, bool>>& given) {
    for (const auto& [other, is_given] : given)
        if (is_given) throw Error(option + " does not go with " + other);
}

void refuse(const std::string& option, const std::string& expected, const std::string& found) {
    throw Error(option + ": expected " + expected + ", found \"" + found + '"');
}

namespace {

bool all_digits(const std::string& text) {
    return !text.empty() &&
           std::ranges::all_of(text, [](unsigned char c) { return std::isdigit(c) != 0; });
}

}  // namespace

std::uint64_t natural(const std::string& option, const std::string& text) {
    if (!all_digits(text)) refuse(option, "a whole number from 0 on", text);
    const Integer value(text);
    if (bit_length(value) > 63) refuse(option, "a number below 2^63", text);
    return value.to_uint64();
}

Integer position(const std::string& option, const std::string& text) {
    if (!all_digits(text)) refuse(option, "a position, a whole number from 0 on", text);
    return Integer(text);
}

std::optional<double> number(const std::string& text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

double positive(const std::string& option, const std::string& text) {
    const auto value = number(text);
    if (!value || *value <= 0) refuse(option, "a positive number", text);
    return *value;
}

double positive_or_zero(const std::string& option, const std::string& text) {
    return text == "0" ? 0 : positive(option, text);
}

std::uint64_t bytes(const std::string& option, const std::string& text) {
    std::string digits = text;
    unsigned shift = 0;
    if (!digits.empty()) {
        const auto unit = std::string("KMGT").find(
            static_cast<char>(std::toupper(static_cast<unsigned char>(digits.back()))));
        if (unit != std::string::npos) {
            shift = 10 * (static_cast<unsigned>(unit) + 1);
            digits.pop_back();
        }
    }
    if (!all_digits(digits) || digits.size() > 18)
        refuse(option, "a number of bytes such as 500000, 512M or 2G", text);
    const std::uint64_t value = natural(option, digits);
    if (shift > 0 && value >> (63 - shift) != 0) refuse(option, "less than 2^63 bytes", text);
    return value << shift;
}

std::vector<std::string> between_commas(const std::string& text) {
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (c == ',')
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

std::vector<std::string> list(const std::string& option, const std::string& text) {
    const std::vector<std::string> parts = between_commas(text);
    if (std::ranges::count(parts, ""))
        refuse(option, "a list with commas between, such as a,b", text);
    return parts;
}

double seconds(const std::string& option, const std::string& text) {
    const auto found = text == "none" ? std::optional(0.0) : number(text);
    if (!found || !(*found >= 0))
        refuse(option, "a positive number of seconds, or none for no end", text);
    return *found == 0 ? endless_seconds : std::min(*found, endless_seconds);
}

std::vector<std::string> letters(const std::string& option, const std::string& text) {
    std::vector<std::string> found{{}};
    for (const char c : text) {
        const bool is_between = c == ',' || c == ' ' || c == '\t' || c == '\n';
        if (!is_between)
            found.back() += c;
        else if (!found.back().empty())
            found.emplace_back();
    }
    if (found.back().empty()) found.pop_back();
    if (found.empty()) refuse(option, "letters such as 'a b c'", text);
    return found;
}

Range range(const std::string& option, const std::string& text) {
    const auto dots = text.find("..");
    if (dots == std::string::npos) {
        const std::uint64_t n = natural(option, text);
        return {n, n, text};
    }
    if (dots == 0 || dots + 2 == text.size()) refuse(option, "a range such as 0..6", text);
    const std::uint64_t first = natural(option, text.substr(0, dots));
    const std::uint64_t last = natural(option, text.substr(dots + 2));
    if (first > last) refuse(option, "a range that goes up, such as 0..6", text);
    if (last - first >= 100'000) refuse(option, "a range of at most 100000 generations", text);
    return {first, last, text};
}

namespace {

/// The names of this command's bounds in messages of the library.
constexpr BoundNames option_names{"--max-letters", "--max-memory", "--timeout"};
/// The same where the time is the usual one of questions.
constexpr BoundNames usual_names{"--max-letters", "--max-memory",
                                 "--timeout (default 300 seconds, none for no end)"};

std::atomic<bool> questions_end = false;

}  // namespace

bool is_long_by_intent(const std::string& verb) {
    static const std::set<std::string> all{"derive", "draw",  "figures", "census", "lesson",
                                           "mark",   "latex", "lsp",     "studio"};
    return all.contains(verb) || generator_kind("file." + verb) != nullptr;
}

void end_questions(bool do_end) { questions_end = do_end; }

Budget Bounds::budget() const {
    Budget budget;
    budget.stop = &stop;
    budget.at_check = at_check;
    budget.names = &option_names;
    if (letters) budget.letters = *letters;
    if (memory) budget.memory = *memory;
    bound_memory(budget.memory);
    const bool is_usual = !timeout && questions_end;
    if (is_usual) budget.names = &usual_names;
    const double time = is_usual ? usual_seconds_of_questions : timeout.value_or(endless_seconds);
    if (time < endless_seconds)
        budget.deadline = std::chrono::steady_clock::now() +
                          std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                              std::chrono::duration<double>(time));
    set_deadline(budget.deadline, budget.names->time);
    return budget;
}

Option& Verb::add(const std::string& names, const std::string& type, const std::string& text) {
    Option& added = (names.starts_with('-') ? options : arguments).emplace_back();
    std::istringstream parts(names);
    parts.exceptions(std::ios::badbit);  // else the end of memory ends the text
    for (std::string part; std::getline(parts, part, ',');) added.names.push_back(part);
    added.type = type;
    added.help = text;
    return added;
}

Option& Verb::option(const std::string& names, std::string& target, const std::string& type,
                     const std::string& text) {
    Option& added = add(names, type, text);
    added.take = [&target](const std::string& value) { target = value; };
    return added;
}

Option& Verb::option(const std::string& names, std::vector<std::string>& target,
                     const std::string& type, const std::string& text) {
    Option& added = add(names, type, text);
    added.take = [&target](const std::string& value) { target.push_back(value); };
    added.repeated = true;
    return added;
}

Option& Verb::flag(const std::string& names, bool& target, const std::string& text) {
    Option& added = add(names, "", text);
    added.take = [&target](const std::string&) { target = true; };
    return added;
}

Option& Verb::output(const std::string& names, std::string& target, const std::string& type,
                     const std::string& text) {
    const bool is_first = std::ranges::none_of(
        options, [](const Option& each) { return each.name() == "--no-clobber"; });
    if (is_first) {
        Option& keep = add("--no-clobber", "", "never replace a file that is there");
        keep.take = [](const std::string&) { keep_all_files(); };
    }
    return option(names, target, type, text);
}

Option& Verb::json_flag(bool& target, const std::string& text) {
    return flag("--json", target, text);
}

void Verb::latex_flag(bool& target, const std::string& text) {
    flag("--latex", target, text).excludes = {"--json"};
}

void Verb::bounded_by(Bounds& bounds) {
    option("--max-letters", bounds.letters, natural, "N",
           "letters that may be written out (default 1000000000)")
        .bounds = true;
    option("--max-memory", bounds.memory, bytes, "BYTES",
           "memory that the work may take (default 4G)")
        .bounds = true;
    option("--timeout", bounds.timeout, seconds, "SECONDS",
           is_long_by_intent(name) ? "stop after so many seconds (default none: never)"
                                   : "stop after so many seconds, never for none (default 300)")
        .bounds = true;
}

std::string Verb::usage() const {
    std::string text = "algae " + name + " [OPTIONS]";
    for (const Option& option : options)
        if (option.required) text += ' ' + option.name() + ' ' + option.type;
    for (const Option& argument : arguments) {
        const std::string shown = argument.name() + (argument.repeated ? "..." : "");
        text += argument.required ? ' ' + shown : " [" + shown + ']';
    }
    return text;
}

bool Verb::names_generators() const { return generator_kind("file." + name) != nullptr; }

namespace {

/// The names of one kind of generator.
std::vector<std::string> names_of_kind(const std::string& kind) {
    std::vector<std::string> names;
    for (const GalleryEntry& entry : generator_gallery())
        if (file_name(entry).ends_with('.' + kind)) names.emplace_back(entry.name);
    return names;
}

}  // namespace

std::vector<std::string> gallery_names() {
    std::vector<std::string> names;
    for (const GalleryEntry& entry : gallery()) names.emplace_back(entry.name);
    for (const GalleryEntry& entry : generator_gallery()) names.emplace_back(file_name(entry));
    return names;
}

Values Verb::values(const Option& option) const {
    Values found;
    const std::string type = option.type.substr(0, option.type.find(",..."));
    std::istringstream parts(type);
    parts.exceptions(std::ios::badbit);
    for (std::string part; std::getline(parts, part, '|');) {
        if (part == "FILE")
            found.files = true;
        else if (part == "DIR")
            found.folders = true;
        else if (part == "NAME")
            found.words = names_generators() ? names_of_kind(name) : gallery_names();
        else if (part == "COLOUR")
            for (const std::string_view colour : colour_names()) found.words.emplace_back(colour);
        else if (type.find('|') != std::string::npos)
            found.words.push_back(part);
    }
    return found;
}

namespace {

/// The texts that CLI11 found for an option.
struct Given {
    const Option* option = nullptr;
    bool said = false;  // of a flag
    std::vector<std::string> texts;
    std::string text;
    CLI::Option* parsed = nullptr;

    /// Passes the texts of the command line to the verb.
    void take() const {
        if (option->type.empty() && !option->is_argument()) {
            if (said) option->take({});
        } else if (option->repeated) {
            for (const std::string& one : texts) option->take(one);
        } else if (parsed->count() > 0) {
            option->take(text);
        }
    }
};

CLI::Option* parsed_option(CLI::App& app, Given& given) {
    const Option& option = *given.option;
    const std::string names = joined(option.names, ",");
    if (option.type.empty() && !option.is_argument())
        return app.add_flag(names, given.said, option.help);
    CLI::Option* const added = option.repeated ? app.add_option(names, given.texts, option.help)
                                               : app.add_option(names, given.text, option.help);
    if (!option.type.empty()) added->type_name(option.type);
    added->required(option.required);
    if (option.repeated && !option.is_argument()) added->expected(1)->take_all();
    if (option.bounds) added->group("Bounds");
    if (!option.words.empty()) added->check(CLI::IsMember(option.words).description(""));
    return added;
}

/// Declares the options of a verb to CLI11.
std::deque<Given> add_options(CLI::App& app, const Verb& verb) {
    std::deque<Given> all;
    for (const auto* options : {&verb.arguments, &verb.options})
        for (const Option& option : *options) all.push_back({&option, false, {}, {}, nullptr});
    for (Given& given : all) given.parsed = parsed_option(app, given);
    for (const Given& given : all) {
        for (const std::string& other : given.option->needs)
            given.parsed->needs(app.get_option(other));
        for (const std::string& other : given.option->excludes)
            given.parsed->excludes(app.get_option(other));
    }
    return all;
}

/// The command as a CLI11 application, and the values that it finds for the options of each verb.
struct Parser {
    CLI::App app{"algae derives L-systems exactly, analyses and draws them.", "algae"};
    std::deque<std::deque<Given>> given;
    const Verb* chosen = nullptr;
    const std::deque<Given>* values = nullptr;

    /// `word` is what the command line begins with: where that is a verb the others are not declared, which takes longer than the
    /// work of many verbs.
    Parser(const std::deque<Verb>& verbs, std::string_view word) {
        app.set_version_flag("--version", "algae " ALGAE_VERSION, "Print the version and exit");
        app.require_subcommand(1);
        app.footer(
            "`algae VERB --help` shows examples. FILE is a file, - for standard input, or a name "
            "that\n`algae gallery` lists. Exit status: 0 success, 1 false, 2 bad usage or input,\n"
            "3 undecided or a bound was reached, 130 interrupted.");
        const bool is_verb = std::ranges::count(verbs, word, &Verb::name) > 0;
        for (const Verb& verb : verbs)
            if (!is_verb || verb.name == word) add(verb);
    }

    void add(const Verb& verb) {
        CLI::App& command = *app.add_subcommand(verb.name, verb.help);
        std::string examples = "Examples:";
        for (const std::string& example : verb.examples) examples += "\n  " + example;
        command.footer(examples);
        if (verb.hidden) command.group("");
        std::deque<Given>& own = given.emplace_back(add_options(command, verb));
        command.callback([this, &verb, &own] {
            chosen = &verb;
            values = &own;
        });
    }
};

}  // namespace

int Verbs::run(int argc, char** argv) {
    /// The option that may be meant by one that the verb does not have.
    const auto meant = [&](const CLI::ParseError& error, const std::string& name) -> std::string {
        const auto verb = std::ranges::find(all, name, &Verb::name);
        const std::string text = error.what();
        const std::size_t from = text.find("--");
        if (verb == all.end() || !dynamic_cast<const CLI::ExtrasError*>(&error) ||
            from == std::string::npos)
            return {};
        std::vector<std::string> names;
        for (const Option& option : verb->options)
            if (option.name().starts_with("--")) names.push_back(option.name().substr(2));
        std::string hint =
            did_you_mean(text.substr(from + 2, text.find_first_of(" =,", from) - from - 2), names);
        if (const std::size_t quote = hint.find('\''); quote != std::string::npos)
            hint.insert(quote + 1, "--");
        return hint;
    };
    Parser parser(all, argc < 2 ? "" : argv[1]);
    if (argc < 2) {
        std::fputs(parser.app.help().c_str(), stderr);
        return bad_input;
    }
    std::vector<std::string> names;
    for (const Verb& verb : all) names.push_back(verb.name);
    const std::string word = argv[1];
    if (word == "help" && argc <= 3) {  // as if --help had been said, of a verb or of all
        char option[] = "--help";
        std::array<char*, 3> said{argv[0], argc == 3 ? argv[2] : option, option};
        return run(argc, said.data());
    }
    if (!word.starts_with('-') && !std::ranges::count(names, word))
        throw Error("no verb " + word + did_you_mean(word, names) + "; `algae --help` lists them");
    if (word.starts_with('-') && word != "-h" && word != "--help" && word != "--version")
        throw Error("no option " + word + "; `algae --help` lists the verbs");
    try {
        parser.app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) {  // help and version
            errno = 0;
            parser.app.exit(error);
            if (!std::cout.flush())
                throw Error(std::string("cannot write to standard output: ") +
                            std::strerror(errno));
            return success;
        }
        throw Error(std::string(error.what()) + meant(error, word) + "; `algae " +
                    (word.starts_with('-') ? "" : word + " ") + "--help` shows how");
    }
    for (const bool bounds : {true, false})
        for (const Given& value : *parser.values)
            if (value.option->bounds == bounds) value.take();
    // Verbs that wait for an editor or a page are not at work.
    std::optional<Heartbeat> heartbeat;
    if (word != "lsp" && word != "studio") heartbeat.emplace(parser.chosen->name);
    end_questions(!is_long_by_intent(parser.chosen->name));
    return parser.chosen->run();
}

}  // namespace algae::command
