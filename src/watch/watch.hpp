#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

// watch: says where long work is, while it is at work. Loops that may take seconds keep a `WorkCount` of what they count: cells,
// statements, generations, points. Whoever wants to tell of it keeps a `WorkWatch` in the thread of the work and asks it from another
// thread. No answer depends on it, and where nobody watches, a count costs a test of a pointer.

namespace algae {

class WorkCount;

/// Watches the work of the thread that makes it, until it is destroyed there. Of several in one thread the last one watches.
class WorkWatch {
public:
    WorkWatch();
    ~WorkWatch();
    WorkWatch(const WorkWatch&) = delete;
    WorkWatch& operator=(const WorkWatch&) = delete;

    /// The counts of the work, from the outermost to the innermost, at most four of them; empty where nothing is counted. Any thread
    /// may ask.
    ///
    /// Example: [] { WorkWatch watch;
    ///               WorkCount cells("cell", 40, "0L, union");
    ///               WorkCount words("words");
    ///               words.at(1234567);
    ///               return watch.where() == "cell 0 of 40 (0L, union), words 1,234,567"; }()
    std::string where() const;

private:
    friend class WorkCount;

    mutable std::mutex guard_;
    std::vector<const WorkCount*> counts_;
    WorkWatch* outer_;
};

/// A count of work of this thread, from its making to its end. Counts end in the opposite order.
class WorkCount {
public:
    /// `what` is counted, in words that stay; up to `last`, 0 where the end is not known; `name` says which one it is.
    explicit WorkCount(const char* what, std::uint64_t last = 0, std::string name = {});
    ~WorkCount();
    WorkCount(const WorkCount&) = delete;
    WorkCount& operator=(const WorkCount&) = delete;

    /// The work is at this number now. A store; loops of a few instructions call it every few thousand rounds.
    void at(std::uint64_t number) { number_.store(number, std::memory_order_relaxed); }
    /// The same, and what the number stands for.
    void at(std::uint64_t number, const std::string& name);
    /// One more.
    void operator++() { at(number_.load(std::memory_order_relaxed) + 1); }

    /// "generation 3 of 12", "cell 7 of 40 (0L, union)".
    std::string text() const;

private:
    friend class WorkWatch;

    WorkWatch* const watch_;
    const char* const what_;
    const std::uint64_t last_;
    std::atomic<std::uint64_t> number_{0};
    std::string name_;  // guarded by the watch
};

}  // namespace algae
