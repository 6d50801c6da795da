#include <chrono>

#include "cli/command.hpp"
#include "cli/numbers.hpp"

namespace algae::cli {

std::atomic<bool> stop = false;
const std::function<void()>* at_check = nullptr;

namespace {

/// What messages of the library call the bounds that this command sets.
constexpr BoundNames option_names{"--max-letters", "--max-memory", "--timeout"};

}  // namespace

void Bounds::add_to(CLI::App& verb) {
    verb.add_option("--max-letters", letters, "letters that may be written out (default 1000000000)")->type_name("N")->group(bounds_group);
    verb.add_option("--max-memory", memory, "memory that tables may take (default 4G)")->type_name("BYTES")->group(bounds_group);
    verb.add_option("--timeout", timeout, "stop after so many seconds (default: never)")->type_name("SECONDS")->group(bounds_group);
}

Budget Bounds::budget() const {
    Budget budget;
    budget.stop = &stop;
    budget.at_check = at_check;
    budget.names = &option_names;
    if (!letters.empty()) budget.letters = natural("--max-letters", letters);
    if (!memory.empty()) budget.memory = bytes("--max-memory", memory);
    if (!timeout.empty()) {
        const double seconds = std::min(positive("--timeout", timeout), 1e9);
        budget.deadline = std::chrono::steady_clock::now() +
                          std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                              std::chrono::duration<double>(seconds));
    }
    return budget;
}

}  // namespace algae::cli
