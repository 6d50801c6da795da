#pragma once

#include <memory>
#include <vector>

#include "base/error.hpp"
#include "environment/environment.hpp"
#include "system/lsystem.hpp"

namespace algae {

/// A communication module is left to a program and there is none.
struct ProgramWanted : Error {
    using Error::Error;
};

/// The environments of all communication modules of a system: those that its file sets, and without
/// that the position for ?P and the heading for ?H.
class Environments {
public:
    /// `external` answers the modules that the file leaves to a program; it may be missing where there
    /// are none. Throws Error if a module has no environment, ProgramWanted if it is left to a program.
    explicit Environments(const LSystem& system, std::shared_ptr<Environment> external = nullptr);

    /// By query of the course, the new parameters. Throws what the environments throw, and Error if a
    /// module has not as many parameters as its environment fills.
    std::vector<std::vector<double>> answers(const Traversal& course, const Budget& budget);

private:
    struct Asked {
        std::string name, kind;  // of the module and of its environment
        std::shared_ptr<Environment> environment;
        std::vector<std::size_t> arities;  // that the environment can fill; empty: any
    };
    const Asked& asked_by(const std::string& name) const;

    std::vector<Asked> asked_;
    std::vector<std::shared_ptr<Environment>> all_;
};

/// Whether a module of the system is left to an external program.
bool asks_program(const LSystem& system);

}  // namespace algae
