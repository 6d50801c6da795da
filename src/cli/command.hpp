#pragma once
// cli: the command `algae`. One short file a verb: it parses options, calls one function, prints.

#include <CLI/CLI.hpp>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "base/budget.hpp"

namespace algae::cli {

/// How the command ends.
enum Status { success = 0, refuted = 1, bad_input = 2, undecided = 3, interrupted = 130 };

/// The verbs, and what they leave for `main` to run. The name of an option's type says what may stand
/// there: FILE and DIR paths, NAME a name from the gallery, COLOUR a colour's name, `map|solid` one of
/// these words.
struct Verbs {
    CLI::App& app;
    std::function<int()> chosen;  // the verb on the command line, ready to run
};

/// How their help calls the options that bound the work.
inline constexpr const char* bounds_group = "Bounds";

/// Bounds that every verb takes.
struct Bounds {
    std::string letters, memory, timeout;

    /// Adds --max-letters, --max-memory and --timeout.
    void add_to(CLI::App& verb);
    /// Throws Error if a bound cannot be read.
    Budget budget() const;
};

/// A verb with a description and two examples, and the function that runs it.
template <class Options>
CLI::App& add_verb(Verbs& verbs, const std::string& name, const std::string& description,
                   const std::string& examples, std::shared_ptr<Options> options,
                   int (*run)(const Options&)) {
    CLI::App& verb = *verbs.app.add_subcommand(name, description);
    verb.footer("Examples:\n" + examples);
    verb.callback([&verbs, options, run] { verbs.chosen = [options, run] { return run(*options); }; });
    return verb;
}

/// Set by Ctrl-C.
extern std::atomic<bool> stop;

/// What the budgets of all verbs call at each check, if anything: tests stop verbs by it.
extern const std::function<void()>* at_check;

/// All verbs, and what the help of the command says of them: the one table of options, from which
/// `--help`, the manual page and the completions of shells come.
void add_verbs(Verbs& verbs);

void add_show(Verbs& verbs);
void add_fmt(Verbs& verbs);
void add_derive(Verbs& verbs);
void add_letter(Verbs& verbs);
void add_growth(Verbs& verbs);
void add_member(Verbs& verbs);
void add_finite(Verbs& verbs);
void add_equal(Verbs& verbs);
void add_is(Verbs& verbs);
void add_check(Verbs& verbs);
void add_closure(Verbs& verbs);
void add_verify(Verbs& verbs);
void add_draw(Verbs& verbs);
void add_dimension(Verbs& verbs);
void add_tree(Verbs& verbs);
void add_figures(Verbs& verbs);
void add_gallery(Verbs& verbs);
void add_lesson(Verbs& verbs);
void add_ifs(Verbs& verbs);
void add_walk(Verbs& verbs);
void add_brownian(Verbs& verbs);
void add_terrain(Verbs& verbs);
void add_dla(Verbs& verbs);
void add_particles(Verbs& verbs);
void add_ca(Verbs& verbs);
void add_convert(Verbs& verbs);
void add_manual(Verbs& verbs);

}  // namespace algae::cli
