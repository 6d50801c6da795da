#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>

#include "cli/command.hpp"
#include "cli/ending.hpp"
#include "notation/suggestion.hpp"

namespace {

void on_interrupt(int) {
    if (algae::cli::stop.exchange(true)) std::_Exit(algae::cli::interrupted);  // asked twice
}

/// Ctrl-C asks the work to stop, and interrupts reading that waits.
void handle_interrupt() {
    struct sigaction action = {};
    action.sa_handler = on_interrupt;
    sigaction(SIGINT, &action, nullptr);
}

}  // namespace

int main(int argc, char** argv) {
    using namespace algae::cli;
    handle_interrupt();
    CLI::App app;
    Verbs verbs{app, {}};
    add_verbs(verbs);
    if (argc < 2) {
        std::fputs(app.help().c_str(), stderr);
        return bad_input;
    }
    std::vector<std::string> names;
    for (const CLI::App* known : app.get_subcommands({})) names.push_back(known->get_name());
    const std::string verb = argv[1];
    if (!verb.starts_with('-') && std::find(names.begin(), names.end(), verb) == names.end())
        return report(("no verb " + verb + algae::did_you_mean(verb, names) + "; `algae --help` lists them").c_str(),
                      bad_input);
    if (verb.starts_with('-') && verb != "-h" && verb != "--help" && verb != "--version")
        return report(("no option " + verb + "; `algae --help` lists the verbs").c_str(), bad_input);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error);  // help and version
        return report((std::string(error.what()) + "; `algae " + (verb.starts_with('-') ? "" : verb + " ") +
                       "--help` shows how").c_str(),
                      bad_input);
    }
    return run(verbs.chosen);
}
