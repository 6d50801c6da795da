#pragma once

#include <memory>
#include <string>

#include "cli/command.hpp"
#include "environment/environment.hpp"
#include "system/lsystem.hpp"

namespace algae::cli {

/// `--environment 'COMMAND'`. Only the command line says which program runs, never a file.
void add_environment_option(CLI::App& verb, std::string& command);

/// The program of --environment, started; nullptr where the option is not given. Throws Error if no
/// module of the system asks a program.
std::shared_ptr<Environment> external_environment(const std::string& command,
                                                  const LSystem& system);

}  // namespace algae::cli
