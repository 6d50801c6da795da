// The account of memory: `operator new` and the allocation functions of GMP and FLINT.
//
// Threads gather what they allocate and free, and settle it with the account at every 64 KiB, so that they do not wait for each other.
// Only blocks of a KiB and more are entered: the many small ones would cost a tenth of the time of a proof. The kernel has the last
// word: RLIMIT_DATA bounds what is writable and private, so malloc fails for small blocks, and within Cairo or Graphviz too.

#include "command/detail/memory.hpp"

#include <flint/flint.h>
#include <gmp.h>
#include <malloc.h>
#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <new>

namespace algae::command {

namespace {

using Bytes = std::int64_t;

constexpr Bytes settled_at = 1 << 16;
/// Blocks with this many usable bytes are entered; one that was asked for with fewer than `surely_small` never has them.
constexpr std::size_t entered_at = 1024, surely_small = entered_at - 64;
std::atomic<Bytes> held = 0;
std::atomic<Bytes> most = std::numeric_limits<Bytes>::max();
std::atomic<bool> is_used_up = false;
thread_local Bytes unsettled = 0;

void add(Bytes bytes) noexcept {
    unsettled += bytes;
    if (std::abs(unsettled) < settled_at) return;
    held.fetch_add(unsettled, std::memory_order_relaxed);
    unsettled = 0;
}

bool may_draw(std::size_t bytes) noexcept {
    if (bytes <= static_cast<std::size_t>(std::numeric_limits<Bytes>::max() / 4) &&
        held.load(std::memory_order_relaxed) + unsettled + static_cast<Bytes>(bytes) <=
            most.load(std::memory_order_relaxed))
        return true;
    is_used_up = true;
    return false;
}

/// What the account enters for a block.
Bytes entry(void* memory) noexcept {
    const std::size_t usable = memory ? malloc_usable_size(memory) : 0;
    return usable < entered_at ? 0 : static_cast<Bytes>(usable);
}

/// A block of malloc's, or nothing where the system gave none: it keeps to the bound too.
void* of_system(void* memory) noexcept {
    if (!memory && most.load(std::memory_order_relaxed) != std::numeric_limits<Bytes>::max())
        is_used_up = true;
    return memory;
}

void* counted(void* memory) noexcept {
    add(entry(of_system(memory)));
    return memory;
}

void* allocate(std::size_t bytes) noexcept {
    if (bytes < surely_small) return of_system(std::malloc(std::max<std::size_t>(bytes, 1)));
    return may_draw(bytes) ? counted(std::malloc(bytes)) : nullptr;
}

void* allocate(std::size_t bytes, std::size_t alignment) noexcept {
    if (!may_draw(bytes + alignment)) return nullptr;
    return counted(std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment));
}

void give_back(void* memory) noexcept {
    if (const Bytes entered = entry(memory)) add(-entered);
    std::free(memory);
}

void give_back(void* memory, std::size_t bytes) noexcept {
    if (bytes < surely_small)
        std::free(memory);
    else
        give_back(memory);
}

void* or_throw(void* memory) {
    if (!memory) throw std::bad_alloc();
    return memory;
}

void* allocate_or_throw(std::size_t bytes) { return or_throw(allocate(bytes)); }

void* allocate_cleared(std::size_t count, std::size_t size) {
    if (size != 0 && count > std::numeric_limits<std::size_t>::max() / size) throw std::bad_alloc();
    return std::memset(allocate_or_throw(count * size), 0, count * size);
}

void* reallocate(void* memory, std::size_t bytes) {
    const Bytes before = entry(memory);
    if (bytes > static_cast<std::size_t>(before) && bytes >= surely_small &&
        !may_draw(bytes - static_cast<std::size_t>(before)))
        throw std::bad_alloc();
    void* const made = or_throw(of_system(std::realloc(memory, std::max<std::size_t>(bytes, 1))));
    add(entry(made) - before);
    return made;
}

/// As GMP calls them, with the sizes that were.
void* reallocate_number(void* memory, std::size_t, std::size_t bytes) {
    return reallocate(memory, bytes);
}
void give_back_number(void* memory, std::size_t bytes) { give_back(memory, bytes); }

/// Before the first number is made.
const bool are_numbers_counted = [] {
    mp_set_memory_functions(allocate_or_throw, reallocate_number, give_back_number);
    __flint_set_memory_functions(allocate_or_throw, allocate_cleared, reallocate, give_back);
    return true;
}();

}  // namespace

void bound_memory(std::uint64_t bytes) {
    constexpr std::uint64_t own = 64 << 20, of_libraries = 100 << 20;
    constexpr std::uint64_t largest = std::uint64_t{1} << 60;
    const std::uint64_t within = std::min(bytes, largest);
    most = static_cast<Bytes>(within + within / 10 + own);
    rlimit limit = {};
    if (::getrlimit(RLIMIT_DATA, &limit) != 0) return;
    const rlim_t wanted = within + within / 5 + of_libraries;
    if (limit.rlim_max != RLIM_INFINITY && wanted >= limit.rlim_max) return;
    limit.rlim_cur = wanted;
    ::setrlimit(RLIMIT_DATA, &limit);  // where it fails there is the account
}

bool is_memory_used_up() { return is_used_up; }

}  // namespace algae::command

// The functions that the standard lets a program replace.

void* operator new(std::size_t bytes) { return algae::command::allocate_or_throw(bytes); }
void* operator new[](std::size_t bytes) { return algae::command::allocate_or_throw(bytes); }
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
    return algae::command::allocate(bytes);
}
void* operator new[](std::size_t bytes, const std::nothrow_t&) noexcept {
    return algae::command::allocate(bytes);
}
void* operator new(std::size_t bytes, std::align_val_t alignment) {
    return algae::command::or_throw(
        algae::command::allocate(bytes, static_cast<std::size_t>(alignment)));
}
void* operator new[](std::size_t bytes, std::align_val_t alignment) {
    return algae::command::or_throw(
        algae::command::allocate(bytes, static_cast<std::size_t>(alignment)));
}
void* operator new(std::size_t bytes, std::align_val_t alignment, const std::nothrow_t&) noexcept {
    return algae::command::allocate(bytes, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { algae::command::give_back(memory); }
void operator delete[](void* memory) noexcept { algae::command::give_back(memory); }
void operator delete(void* memory, std::size_t bytes) noexcept {
    algae::command::give_back(memory, bytes);
}
void operator delete[](void* memory, std::size_t bytes) noexcept {
    algae::command::give_back(memory, bytes);
}
void operator delete(void* memory, std::align_val_t) noexcept { algae::command::give_back(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept {
    algae::command::give_back(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
    algae::command::give_back(memory);
}
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept {
    algae::command::give_back(memory);
}
