#include "base/budget.hpp"

namespace algae {

void Budget::check() const {
    if (stop && stop->load(std::memory_order_relaxed)) throw Interrupted();
    if (at_check) (*at_check)();
    if (deadline && std::chrono::steady_clock::now() > *deadline)
        throw BoundReached(Bound::time, "the time allowed" + by(Bound::time) + " is over");
}

void Budget::check_memory(std::uint64_t bytes, const char* what) const {
    if (bytes > memory)
        throw BoundReached(Bound::memory, std::string(what) + " would take more than the " +
                                              std::to_string(memory >> 20) + " MiB allowed" +
                                              by(Bound::memory));
}

std::string Budget::by(Bound bound) const {
    const char* const name = !names                    ? nullptr
                             : bound == Bound::letters ? names->letters
                             : bound == Bound::memory  ? names->memory
                             : bound == Bound::time    ? names->time
                                                       : nullptr;
    return name ? std::string(" by ") + name : std::string();
}

}  // namespace algae
