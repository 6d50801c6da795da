#include "rewrite/module_string.hpp"

#include <cstdlib>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

#include "base/error.hpp"

namespace algae {

ModuleKind ModuleKinds::kind(Symbol letter, std::size_t arity) {
    const auto [found, fresh] =
        numbers_.emplace(std::pair(letter, arity), ModuleKind(letters_.size()));
    if (!fresh) return found->second;
    constexpr std::size_t most = 65'535;
    if (letters_.size() == most)
        throw BoundReached(Bound::method,
                           "the system has more than 65535 letters, each with its number of "
                           "parameters, as many as a derivation can tell apart");
    letters_.push_back(letter);
    arities_.push_back(static_cast<std::uint32_t>(arity));
    return found->second;
}

void* word_memory(std::size_t bytes) {
    constexpr std::size_t page = std::size_t{1} << 21, many = 4 * page;
    void* const memory = bytes < many ? std::malloc(bytes)
                                      : std::aligned_alloc(page, (bytes + page - 1) / page * page);
    if (!memory) throw std::bad_alloc();
#ifdef __linux__
    if (bytes >= many)
        madvise(memory, (bytes + page - 1) / page * page, MADV_HUGEPAGE);  // only advice
#endif
    return memory;
}

void free_word_memory(void* memory) { std::free(memory); }

Word letters(const ModuleKinds& kinds, const ModuleString& word) {
    Word out;
    out.reserve(word.kinds.size());
    for (const ModuleKind kind : word.kinds) out.push_back(kinds.letter(kind));
    return out;
}

}  // namespace algae
