#pragma once
// What the verb `census` and the program `algae-census` share: processes that take one census together.

#include <cstdint>
#include <functional>
#include <optional>

#include "language/language.hpp"

namespace algae::command {

/// Processes that run the verb with the same options. The first one hands out chunks, writes and prints; the others ask
/// it for chunks and send what they find.
class CensusRanks {
public:
    virtual ~CensusRanks() = default;
    virtual bool is_first() const = 0;

    /// Of the first: gives `next()` to every process that asks, and what they find to `take`, until all are done. Throws
    /// what these throw, when all others are done, and Error where another process failed.
    virtual void serve(const std::function<std::optional<std::uint64_t>()>& next,
                       const std::function<void(const CensusChunk&)>& take) = 0;

    // Of the others.
    virtual std::optional<std::uint64_t> next() = 0;
    virtual void send(const CensusChunk& chunk) = 0;
};

/// The processes, where there are several.
extern CensusRanks* census_ranks;

}  // namespace algae::command
