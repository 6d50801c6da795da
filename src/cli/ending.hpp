#pragma once

#include <functional>

namespace algae::cli {

/// A message of the command, and the status to end with.
int report(const char* message, int status);

/// Runs a verb; every failure becomes one message and a status.
int run(const std::function<int()>& verb);

}  // namespace algae::cli
