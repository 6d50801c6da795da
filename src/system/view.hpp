#pragma once

#include <optional>
#include <string>
#include <utility>

#include "base/error.hpp"

namespace algae {

/// A system seen as a narrower type, or the reason why it cannot be: "rule at a.lsys:3:1 has a
/// context". Functions of the theory take the narrow types, so what they need is checked once.
template <class T>
class View {
public:
    View(T value) : value_(std::move(value)) {}
    static View refused(std::string reason) { return View(std::move(reason), 0); }

    explicit operator bool() const { return value_.has_value(); }
    const std::string& reason() const { return reason_; }

    /// The view. Throws Error with the reason if there is none.
    const T& value() const {
        if (!value_) throw Error(reason_);
        return *value_;
    }
    const T& operator*() const { return value(); }
    const T* operator->() const { return &value(); }

private:
    View(std::string reason, int) : reason_(std::move(reason)) {}
    std::optional<T> value_;
    std::string reason_;
};

}  // namespace algae
