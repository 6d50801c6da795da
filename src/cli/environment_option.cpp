#include "cli/environment_option.hpp"

#include "base/error.hpp"
#include "environment/environments.hpp"
#include "environment/external_environment.hpp"

namespace algae::cli {

void add_environment_option(CLI::App& verb, std::string& command) {
    verb.add_option("--environment", command,
                    "the program that fills the modules of `environment ?E external`: it reads and "
                    "writes lines of JSON")
        ->type_name("COMMAND");
}

std::shared_ptr<Environment> external_environment(const std::string& command,
                                                  const LSystem& system) {
    if (command.empty()) return nullptr;
    if (!asks_program(system))
        throw Error(
            "--environment: no module of the system asks a program; expected a setting such as "
            "`environment ?E external`");
    return std::make_shared<ExternalEnvironment>(command);
}

}  // namespace algae::cli
