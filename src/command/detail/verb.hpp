#pragma once
// command: the program `algae`, one verb a question.
//
// A verb is a struct of typed options and a function that calls the library and shows the result. It
// declares its options as a plain table, from which the parser, `--help`, the manual page and the completions of
// shells are made. CLI11 stays in verb.cpp: its header costs four seconds in every file that includes it.

#include <atomic>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "exact/exact.hpp"

namespace algae::command {

/// The exit status of the command.
enum Status { success = 0, refuted = 1, bad_input = 2, undecided = 3, interrupted = 130 };

/// The status that says what was decided.
inline Status status_of(Truth truth) {
    return truth == Truth::proved ? success : truth == Truth::refuted ? refuted : undecided;
}

/// Set by Ctrl-C, SIGTERM and SIGHUP.
extern std::atomic<bool> stop;

/// A function that the budgets of all verbs call at each check, if it is set: tests stop verbs by it.
extern const std::function<void()>* at_check;

/// A number of any sign, or nothing.
std::optional<double> number(const std::string& text);
/// The parts of a text between commas, empty ones too.
std::vector<std::string> between_commas(const std::string& text);

// Readers make a value from an option's text. If they cannot, they throw Error, which names the option.

/// A generation or a count: a whole number from 0 to 2^63 - 1.
std::uint64_t natural(const std::string& option, const std::string& text);
/// A whole number from 0 on, of any size.
Integer position(const std::string& option, const std::string& text);
/// A positive number of any kind: "600", "12.5".
double positive(const std::string& option, const std::string& text);
/// Seconds; "0" and "none" are as good as without end.
double seconds(const std::string& option, const std::string& text);
/// A positive number, or "0".
double positive_or_zero(const std::string& option, const std::string& text);
/// A number of bytes: "500000", "512M", "2G".
std::uint64_t bytes(const std::string& option, const std::string& text);
/// The parts of a list with commas between, none of them empty.
std::vector<std::string> list(const std::string& option, const std::string& text);

/// Letters with blanks or commas between: "a b c".
std::vector<std::string> letters(const std::string& option, const std::string& text);
inline constexpr const char* alphabet_help =
    "letters that ~ is over besides those that occur, with blanks or commas between";

/// Generations or seeds, "5" or "0..6".
struct Range {
    std::uint64_t first = 0, last = 0;
    std::string written;  // as on the command line

    bool is_single() const { return first == last; }
};

/// At most 100,000 numbers that go up.
Range range(const std::string& option, const std::string& text);

/// Throws Error: "OPTION: expected EXPECTED, found "FOUND"".
[[noreturn]] void refuse(const std::string& option, const std::string& expected,
                         const std::string& found);

/// Throws Error if one of these options is given beside `option`, which does not go with them.
void refuse_with(const std::string& option, const std::vector<std::pair<const char*, bool>>& given);

/// An option or an argument of a verb. The name of its type says which values are possible: FILE and DIR
/// are paths, NAME is a name from the gallery, COLOUR the name of a colour, `map|solid` one of these words.
struct Option {
    std::vector<std::string> names;  // "-o", "--output"; of an argument its name, "FILE"
    std::string type;                // empty for a flag
    std::string help;
    bool required = false, repeated = false;
    bool bounds = false;                           // one of those that bound the work
    std::vector<std::string> words;                // other values are refused, if there are any
    std::vector<std::string> needs, excludes;      // names of other options
    std::function<void(const std::string&)> take;  // stores one value in the options of the verb

    /// The longest of the names.
    const std::string& name() const { return names.back(); }
    bool is_argument() const { return !name().starts_with('-'); }
};

/// The possible values: the words of a set, and paths.
struct Values {
    std::vector<std::string> words;
    bool files = false, folders = false;
};

/// Whether the work of a verb is long by intent: it draws, marks, counts or serves as long as that takes. Other verbs answer questions.
bool is_long_by_intent(const std::string& verb);

/// Whether work without `--timeout` ends from now on after the usual time of questions; not so at first.
void end_questions(bool do_end);
inline constexpr double usual_seconds_of_questions = 300;
inline constexpr double endless_seconds = 1e9;  // 30 years

/// Bounds of the work that nearly every verb takes.
struct Bounds {
    std::optional<std::uint64_t> letters, memory;
    std::optional<double> timeout;  // seconds

    /// The timeout is counted from now on.
    Budget budget() const;
};

/// A verb of the command.
class Verb {
public:
    std::string name, help;
    std::vector<std::string> examples;       // a line each
    std::vector<Option> options, arguments;  // without --help
    bool hidden = false;                     // from help and the manual page
    std::function<int()> run;

    /// A text. `names` are as in "-o,--output"; a name without a dash is that of an argument.
    Option& option(const std::string& names, std::string& target, const std::string& type,
                   const std::string& text);
    /// A text that may be given several times.
    Option& option(const std::string& names, std::vector<std::string>& target,
                   const std::string& type, const std::string& text);
    /// A value that a reader makes of the text. An optional one is not set by an empty text.
    template <class Target, class Value>
    Option& option(const std::string& names, Target& target,
                   Value (*read)(const std::string&, const std::string&), const std::string& type,
                   const std::string& text) {
        Option& added = add(names, type, text);
        added.take = [&target, read, option = added.name()](const std::string& value) {
            if constexpr (std::is_same_v<Target, std::optional<Value>>) {
                if (!value.empty()) target = read(option, value);
            } else if constexpr (std::is_same_v<Target, std::vector<Value>>) {
                target.push_back(read(option, value));
            } else {
                target = read(option, value);
            }
        };
        added.repeated = std::is_same_v<Target, std::vector<Value>>;
        return added;
    }
    /// One of some words, each with its meaning.
    template <class Target>
    Option& choice(const std::string& names, Target& target,
                   const std::vector<std::pair<std::string, Target>>& choices,
                   const std::string& type, const std::string& text) {
        Option& added = add(names, type, text);
        for (const auto& [word, meaning] : choices) added.words.push_back(word);
        added.take = [&target, choices](const std::string& value) {
            for (const auto& [word, meaning] : choices)
                if (word == value) target = meaning;
        };
        return added;
    }
    /// A flag.
    Option& flag(const std::string& names, bool& target, const std::string& text);
    /// A file or a folder that is written; with it comes `--no-clobber`.
    Option& output(const std::string& names, std::string& target, const std::string& type,
                   const std::string& text);
    /// `--json`, with the same text in nearly all verbs.
    Option& json_flag(bool& target, const std::string& text = "print one JSON object");
    /// `--latex`, which excludes `--json`.
    void latex_flag(bool& target,
                    const std::string& text = "print it as LaTeX, which needs amsmath");
    /// --max-letters, --max-memory and --timeout.
    void bounded_by(Bounds& bounds);

    /// "algae draw [OPTIONS] FILE"
    std::string usage() const;
    /// Whether it runs one kind of generator; then NAME stands for the names of this kind.
    bool names_generators() const;
    /// The values that the type of one of its options allows; empty if any text is possible.
    Values values(const Option& option) const;

private:
    Option& add(const std::string& names, const std::string& type, const std::string& text);
};

/// All names that FILE may be; those of other generators have their extensions, `fern.ifs`.
std::vector<std::string> gallery_names();

/// The verbs, in the order of the help.
class Verbs {
public:
    /// A new verb and its options, which `work` gets when the verb is called.
    template <class Options>
    std::pair<Verb&, Options&> add(const std::string& name, const std::string& help,
                                   std::vector<std::string> examples, int (*work)(const Options&)) {
        auto options = std::make_shared<Options>();
        Verb& verb = all.emplace_back();
        verb.name = name;
        verb.help = help;
        verb.examples = std::move(examples);
        verb.run = [options, work] { return work(*options); };
        return {verb, *options};
    }

    /// Reads the command line and runs its verb, or prints help; returns the exit status. Throws
    /// Error if the command line is wrong, and whatever the verb throws.
    int run(int argc, char** argv);

    std::deque<Verb> all;  // addresses stay valid
};

/// Adds all verbs.
void add_verbs(Verbs& verbs);

/// Lets Ctrl-C, SIGTERM and SIGHUP ask the work to stop, and interrupt reading that waits; asked twice, the program ends at once.
void handle_stops();

/// Runs the command; every failure becomes one message on standard error and an exit status.
int run_command(int argc, char** argv);

// The verbs of each file.
void add_show(Verbs& verbs);
void add_fmt(Verbs& verbs);
void add_convert(Verbs& verbs);
void add_gallery(Verbs& verbs);
void add_derive(Verbs& verbs);
void add_letter(Verbs& verbs);
void add_growth(Verbs& verbs);
void add_words(Verbs& verbs);
void add_infer(Verbs& verbs);
void add_member(Verbs& verbs);
void add_finite(Verbs& verbs);
void add_equal(Verbs& verbs);
void add_is(Verbs& verbs);
void add_list(Verbs& verbs);
void add_check(Verbs& verbs);
void add_closure(Verbs& verbs);
void add_verify(Verbs& verbs);
void add_census(Verbs& verbs);
void add_draw(Verbs& verbs);
void add_dimension(Verbs& verbs);
void add_tree(Verbs& verbs);
void add_figures(Verbs& verbs);
void add_lesson(Verbs& verbs);
void add_latex(Verbs& verbs);
void add_lsp(Verbs& verbs);
void add_studio(Verbs& verbs);
void add_generators(Verbs& verbs);  // ifs, walk, brownian, terrain, dla, particles, ca
void add_manual(Verbs& verbs);

}  // namespace algae::command
