#include "watch/watch.hpp"

#include <algorithm>
#include <utility>

// Where long work is, for one who watches.
//
// A watch belongs to a thread: what other threads do at the same time is counted by nobody, or by the loop that hands out their parts.
// So two callers of the library in two threads never see each other's work. The list of counts changes rarely, and a mutex keeps it;
// the numbers change often and are atomic, so that the one who watches may read them at any time.

namespace algae {

namespace {

thread_local WorkWatch* watching = nullptr;

/// "1,234,567"
std::string grouped(std::uint64_t number) {
    std::string text = std::to_string(number);
    for (std::size_t left = text.size(); left > 3; left -= 3) text.insert(left - 3, 1, ',');
    return text;
}

}  // namespace

WorkWatch::WorkWatch() : outer_(std::exchange(watching, this)) {}

WorkWatch::~WorkWatch() { watching = outer_; }

std::string WorkWatch::where() const {
    constexpr std::size_t most = 4;
    const std::lock_guard lock(guard_);
    std::string text;
    for (std::size_t i = 0; i < std::min(most, counts_.size()); ++i)
        text += (i > 0 ? ", " : "") + counts_[i]->text();
    return text;
}

WorkCount::WorkCount(const char* what, std::uint64_t last, std::string name)
    : watch_(watching), what_(what), last_(last) {
    if (!watch_) return;
    const std::lock_guard lock(watch_->guard_);
    name_ = std::move(name);
    watch_->counts_.push_back(this);
}

WorkCount::~WorkCount() {
    if (!watch_) return;
    const std::lock_guard lock(watch_->guard_);
    std::erase(watch_->counts_, this);
}

void WorkCount::at(std::uint64_t number, const std::string& name) {
    at(number);
    if (!watch_) return;
    const std::lock_guard lock(watch_->guard_);
    name_ = name;
}

std::string WorkCount::text() const {
    std::string text = what_ + (' ' + grouped(number_.load(std::memory_order_relaxed)));
    if (last_ > 0) text += " of " + grouped(last_);
    if (!name_.empty()) text += " (" + name_ + ')';
    return text;
}

}  // namespace algae
