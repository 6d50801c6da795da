#include "base/budget.hpp"

#include <string>

#include "base/error.hpp"

namespace algae {

void Budget::check() const {
    if (stop && stop->load(std::memory_order_relaxed)) throw Interrupted();
    if (deadline && std::chrono::steady_clock::now() > *deadline)
        throw BoundReached("the time allowed by --timeout is over");
}

void Budget::check_memory(std::uint64_t bytes, const char* what) const {
    if (bytes > memory)
        throw BoundReached(std::string(what) + " would take more than the " +
                           std::to_string(memory >> 20) + " MiB allowed by --max-memory");
}

}  // namespace algae
