#include "cli/ending.hpp"

#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "base/error.hpp"
#include "cli/command.hpp"
#include "environment/environments.hpp"

namespace algae::cli {

int report(const char* message, int status) {
    std::fprintf(stderr, "algae: %s\n", message);
    return status;
}

int run(const std::function<int()>& verb) {
    try {
        return verb();
    } catch (const Interrupted& error) {
        return report(error.what(), interrupted);
    } catch (const BoundReached& error) {
        return report(error.what(), undecided);
    } catch (const ProgramWanted& error) {
        return report((std::string(error.what()) + ", with --environment 'COMMAND'").c_str(),
                      bad_input);
    } catch (const Diagnostics& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return bad_input;
    } catch (const Error& error) {
        return report(error.what(), bad_input);
    } catch (const std::bad_alloc&) {
        return report("the machine has no more memory; lower --max-memory or the generation",
                      undecided);
    } catch (const std::exception& error) {
        return report(error.what(), bad_input);
    }
}

}  // namespace algae::cli
