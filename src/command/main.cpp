// The program. Ctrl-C asks the work to stop; everything else is in verbs.cpp.

#include <csignal>
#include <cstdlib>

#include "command/detail/verb.hpp"

namespace {

using namespace algae::command;

void on_interrupt(int) {
    if (stop.exchange(true)) std::_Exit(interrupted);  // asked twice
}

/// Ctrl-C asks the work to stop, and interrupts reading that waits.
void handle_interrupt() {
    struct sigaction action = {};
    action.sa_handler = on_interrupt;
    sigaction(SIGINT, &action, nullptr);
}

}  // namespace

int main(int argc, char** argv) {
    handle_interrupt();
    return run_command(argc, argv);
}
