#pragma once

#include <cstddef>
#include <functional>

#include "base/budget.hpp"

namespace algae {

/// What one thread does with the part of this number.
using PartWorker = std::function<void(std::size_t part)>;

/// Does the work for parts 0 up to count - 1, by as many threads (0: as many as the machine has) as
/// there are parts enough for, `least` for each; every thread gets a worker of its own. Of several errors the one of the
/// first part is thrown, so that it does not depend on the threads.
void each_part(std::size_t count, unsigned threads, const Budget& budget,
               const std::function<PartWorker()>& worker, std::size_t least = 16);

}  // namespace algae
