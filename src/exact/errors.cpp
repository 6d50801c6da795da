#include "exact/detail/flint.hpp"
#include "exact/exact.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

// The two ways of ending without an answer, and the bounds of work.
//
// `Error` says that the input is wrong; `Stopped` says that the work ended before its answer, and nothing about the
// input. The two share no base on purpose: code that catches errors, to judge what was given or to go on without
// it, can never take Ctrl-C or a bound for a finding. Threads keep this apart too: `each_part` collects the first
// exception of each part and throws the one of the lowest part, so that an answer does not depend on timing.

namespace algae {

std::string to_string(const Place& place) {
    if (place.line == 0) return place.file;
    return place.file + ':' + std::to_string(place.line) + ':' + std::to_string(place.column);
}

namespace {

/// The line with a question mark for every character that a terminal could not show: control
/// characters, and bytes that are not UTF-8.
std::string printable(const std::string& line) {
    std::string out;
    for (std::size_t i = 0; i < line.size();) {
        const auto lead = static_cast<unsigned char>(line[i]);
        const std::size_t bytes = lead < 0x80   ? 1
                                  : lead < 0xC2 ? 0
                                  : lead < 0xE0 ? 2
                                  : lead < 0xF0 ? 3
                                  : lead < 0xF5 ? 4
                                                : 0;
        bool whole =
            bytes > 0 && i + bytes <= line.size() && (lead >= 0x20 || lead == '\t') && lead != 0x7F;
        for (std::size_t k = 1; whole && k < bytes; ++k)
            whole = (static_cast<unsigned char>(line[i + k]) & 0xC0) == 0x80;
        if (whole) {
            out.append(line, i, bytes);
            i += bytes;
        } else {
            out += '?';
            ++i;
        }
    }
    return out;
}

}  // namespace

std::string Diagnostic::text() const {
    std::string out = to_string(place) + ": error: " + message;
    if (!line.empty()) out += "\n  " + printable(line) + "\n  " + std::string(caret, ' ') + '^';
    return out;
}

Diagnostics::Diagnostics(std::vector<Diagnostic> findings)
    : Error(joined(findings, "\n", &Diagnostic::text)), findings_(std::move(findings)) {}

void Budget::check() const {
    if (stop && stop->load(std::memory_order_relaxed)) throw Interrupted();
    if (at_check) (*at_check)();
    if (deadline && std::chrono::steady_clock::now() > *deadline)
        throw BoundReached(Bound::time, "the time allowed" + by(Bound::time) + " is over");
}

void Budget::check_memory(std::uint64_t bytes, const char* what) const {
    constexpr std::uint64_t addresses = std::numeric_limits<std::size_t>::max();
    if (const std::uint64_t most = std::min(memory, addresses); bytes > most)
        throw BoundReached(Bound::memory, std::string(what) + " would take more than the " +
                                              std::to_string(most >> 20) + " MiB allowed" +
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

void each_part(std::size_t count, unsigned threads, const Budget& budget,
               const std::function<PartWorker()>& worker, std::size_t least) {
    std::atomic<std::size_t> next{0};
    std::atomic<bool> failed{false};
    std::vector<std::exception_ptr> errors(count);
    std::exception_ptr of_making;  // of making a worker: a thread that has none does no part
    std::mutex making;
    const auto run = [&] {
        PartWorker work;
        try {
            work = worker();
        } catch (...) {
            const std::lock_guard lock(making);
            of_making = std::current_exception();
            failed = true;
        }
        while (!failed) {
            const std::size_t i = next++;
            if (i >= count) return;
            try {
                if (i % 32 == 0) budget.check();
                work(i);
            } catch (...) {
                errors[i] = std::current_exception();
                failed = true;
            }
        }
    };
    const std::size_t wanted =
        threads > 0 ? threads : std::max(1u, std::thread::hardware_concurrency());
    const std::size_t most = std::min(wanted, count / least);
    std::vector<std::thread> others;
    others.reserve(most);
    try {
        while (others.size() + 1 < most)
            others.emplace_back([&run] {
                run();
                flint_cleanup();  // what FLINT keeps for a thread is lost with it otherwise
            });
    } catch (const std::system_error&) {
        // The system gives no more of them; those that are there do all parts.
    }
    run();
    for (std::thread& thread : others) thread.join();
    for (const std::exception_ptr& error : errors)
        if (error) std::rethrow_exception(error);
    if (of_making) std::rethrow_exception(of_making);
}

std::string_view to_string(Truth truth) {
    switch (truth) {
        case Truth::proved:
            return "proved";
        case Truth::refuted:
            return "refuted";
        case Truth::undecided:
            break;
    }
    return "undecided";
}

Truth opposite(Truth truth) {
    if (truth == Truth::undecided) return truth;
    return truth == Truth::proved ? Truth::refuted : Truth::proved;
}

}  // namespace algae
