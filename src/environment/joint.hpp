#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "environment/environment.hpp"

namespace algae {

/// The lines that meet where a turtle stands, since it came there: the last one before the module
/// that ends there, and those drawn later that begin there. They are its own branch and what grows
/// on from it, and in nobody's way. Candidates must be shown first, all that end at the place.
class Joint {
public:
    Joint(std::span<const Segment> segments, const Query& query)
        : segments_(segments), query_(query) {}

    /// Takes a segment as the way by which the turtle came, if it is.
    void look_at(std::size_t segment) {
        const Segment& line = segments_[segment];
        if (line.module < query_.module && line.to == query_.position &&
            (!came_ || segment > *came_))
            came_ = segment;
    }
    /// Whether the segment is one of those said above.
    bool has(std::size_t segment) const {
        if (came_ && segment <= *came_) return segment == *came_;
        return segments_[segment].from == query_.position;
    }

private:
    std::span<const Segment> segments_;
    const Query& query_;
    std::optional<std::size_t> came_;
};

}  // namespace algae
