#pragma once

#include <functional>
#include <mutex>
#include <string>

#include "studio/studio.hpp"

namespace algae {

/// Processes that answer one question each. They are made by a process that does nothing else, which was there before the server had
/// threads: a process that is copied while another thread holds a lock keeps that lock for ever.
///
/// A worker has a line to the server. It ends when the line breaks, so that no worker outlives its question or the server, however
/// either of them ends, and when its time is over.
class Workers {
public:
    /// Throws Error if the system gives no process.
    Workers(std::function<int(const std::string&)> work, const StudioShare& share);
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;
    ~Workers();

    /// Has a question answered. `goes_on` is asked twenty times a second and whenever something new was said, with the last line of it.
    Answered run(const std::string& question,
                 const std::function<bool(const std::string& said)>& goes_on);

private:
    StudioShare share_;
    std::mutex asking_;
    int maker_ = -1;  // the line to the process that makes workers
};

}  // namespace algae
