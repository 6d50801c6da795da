#include "base/parts.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace algae {

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
    std::vector<std::thread> others;
    for (std::size_t i = 1; i < std::min(wanted, count / least); ++i) others.emplace_back(run);
    run();
    for (std::thread& thread : others) thread.join();
    for (const std::exception_ptr& error : errors)
        if (error) std::rethrow_exception(error);
    if (of_making) std::rethrow_exception(of_making);
}

}  // namespace algae
