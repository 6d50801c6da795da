#pragma once

#include <chrono>
#include <string>

#include "environment/environment.hpp"
#include "environment/line_process.hpp"

namespace algae {

/// An environment that is another program: it reads a line of JSON for each generation, from 0 on,
///
///     {"generation":0,"queries":[{"module":"?E","index":7,"parameters":[0],"position":[0,1,0],
///      "heading":[0,1,0],"left":[-1,0,0],"up":[0,0,1]}]}
///
/// (all in one line) and writes a line with an answer to each query, in the same order, as many
/// numbers as the module has parameters:
///
///     {"answers":[[1]]}
///
/// `index` is the position of the module in the word. See LineProcess for how it begins and ends.
class ExternalEnvironment : public Environment {
public:
    /// `wait` is how long an answer may take where the budget has no deadline.
    explicit ExternalEnvironment(const std::string& command,
                                 std::chrono::milliseconds wait = LineProcess::patience)
        : command_(command), program_(command), wait_(wait) {}

    std::vector<std::vector<double>> answers(const Traversal& course,
                                             std::span<const Query* const> queries,
                                             const Budget& budget) override;

private:
    std::string command_;
    LineProcess program_;
    std::chrono::milliseconds wait_;
};

}  // namespace algae
