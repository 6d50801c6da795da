// The table of verbs, in the order of the help, the manual page and the completions; and the handling of stops and
// failures. Every failure becomes one message on standard error and an exit
// status, and no verb prints a failure itself.

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <filesystem>
#include <new>
#include <string>
#include <string_view>

#include "command/detail/memory.hpp"
#include "command/detail/output.hpp"
#include "command/detail/verb.hpp"
#include "exact/exact.hpp"
#include "render/render.hpp"
#include "turtle/turtle.hpp"

namespace algae::command {

void add_verbs(Verbs& verbs) {
    constexpr void (*table[])(Verbs&) = {
        add_show,  add_fmt,     add_derive,  add_letter, add_growth,     add_words,
        add_infer, add_member,  add_finite,  add_equal,  add_is,         add_list,
        add_check, add_closure, add_verify,  add_census, add_draw,       add_dimension,
        add_tree,  add_figures, add_gallery, add_lesson, add_generators, add_convert,
        add_latex, add_lsp,     add_studio,  add_manual};
    for (const auto add : table) add(verbs);
}

namespace {

/// Whether answers, and so errors, are wanted as JSON.
bool json_wanted = false;

/// The error as JSON on standard output, for programs. What cannot be printed is said on standard error all the same.
void print_error(Json error, int status) {
    if (!json_wanted || status == interrupted) return;  // who stops the work wants no answer
    error.set("status", status);
    try {
        print_error_object(error);
    } catch (const std::exception&) {
    }
}

int report(const std::string& message, int status) {
    print_error(error_json(printable(message)), status);
    std::fprintf(stderr, "algae: %s\n", printable(message).c_str());
    return status;
}

/// A finding without what cannot be shown, or is no text.
Diagnostic shown(Diagnostic finding) {
    for (std::string* text : {&finding.place.file, &finding.message, &finding.line})
        *text = printable(*text);
    return finding;
}

int report(const Diagnostics& error) {
    if (json_wanted) {
        Json first = to_json(shown(error.findings().front()));
        if (error.findings().size() > 1) {
            Json all = Json::array();
            for (const Diagnostic& finding : error.findings()) all.add(to_json(shown(finding)));
            first.set("all", std::move(all));
        }
        print_error(std::move(first), bad_input);
    }
    std::fprintf(stderr, "%s\n", printable(error.what()).c_str());
    return bad_input;
}

/// Where memory ends in a place that cannot say so otherwise.
[[noreturn]] void on_terminate() {
    remove_unfinished_files();
    const char* message = "algae: an error that no work expects ends the program\n";
    int status = bad_input;
    try {
        if (const std::exception_ptr error = std::current_exception())
            std::rethrow_exception(error);
    } catch (const std::bad_alloc&) {
        message = "algae: there is no more memory; raise --max-memory or lower the generation\n";
        status = undecided;
    } catch (...) {
    }
    std::fputs(message, stderr);
    std::_Exit(status);
}

/// The first request stops the work, another one ends the program at once. What comes within half a second of the first
/// belongs to it: `timeout` sends a signal to the program and to its group.
void on_stop(int) {
    static volatile std::sig_atomic_t first_second = 0, first_centisecond = 0;
    timespec now = {};
    clock_gettime(CLOCK_MONOTONIC, &now);  // may be called from a handler of signals
    const auto second = static_cast<std::sig_atomic_t>(now.tv_sec);
    const auto centisecond = static_cast<std::sig_atomic_t>(now.tv_nsec / 10'000'000);
    if (!stop.exchange(true)) {
        first_second = second;
        first_centisecond = centisecond;
    } else if ((second - first_second) * 100 + centisecond - first_centisecond > 50) {
        remove_unfinished_files();
        std::_Exit(interrupted);
    }
}

}  // namespace

void handle_stops() {
    struct sigaction action = {};
    action.sa_handler = on_stop;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error of writing
    struct sigaction before = {};
    sigaction(SIGHUP, nullptr, &before);
    if (before.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);  // nohup means it
    std::set_terminate(on_terminate);
}

int run_command(int argc, char** argv) {
    json_wanted = std::any_of(argv, argv + argc,
                              [](const char* word) { return std::string_view(word) == "--json"; });
    try {
        Verbs verbs;
        add_verbs(verbs);
        return verbs.run(argc, argv);
    } catch (const Interrupted& error) {
        return report(error.what(), interrupted);
    } catch (const BoundReached& error) {
        return report(error.what(), undecided);
    } catch (const ProgramWanted& error) {
        return report(std::string(error.what()) + ", with --environment 'COMMAND'", bad_input);
    } catch (const Diagnostics& error) {
        return report(error);
    } catch (const Error& error) {
        return report(error.what(), bad_input);
    } catch (const std::bad_alloc&) {
        return report(
            is_memory_used_up()
                ? "the work needs more memory than --max-memory allows; raise it or lower "
                  "the generation"
                : "the machine has no more memory; lower --max-memory or the generation",
            undecided);
    } catch (const std::filesystem::filesystem_error& error) {
        const std::string path = error.path1().string();
        return report("cannot use " + (path.empty() ? "a file or folder" : path) + ": " +
                          error.code().message(),
                      bad_input);
    } catch (const std::exception& error) {
        return report(error.what(), bad_input);
    }
}

}  // namespace algae::command
