#pragma once

#include <cstdint>

namespace algae::command {

// The account of memory. Every allocation of the program's own code, of the standard library, of GMP and of FLINT draws on it before
// it is made; what libraries in C allocate for themselves is bounded by the system. So no work has to count what it allocates, and the
// bound holds where a count is forgotten.

/// What the program may hold from now on, in bytes, and a tenth more and 64 MiB for itself. An allocation beyond throws std::bad_alloc;
/// one of a library in C that comes to a fifth more and 100 MiB fails. Called once, by the verb that read --max-memory.
void bound_memory(std::uint64_t bytes);

/// Whether an allocation was refused since, and not only by the machine.
bool is_memory_used_up();

}  // namespace algae::command
