// The program; everything else is in verbs.cpp.

#include "command/detail/output.hpp"
#include "command/detail/verb.hpp"

int main(int argc, char** argv) {
    algae::command::handle_stops();
    algae::command::end_late_work();
    return algae::command::run_command(argc, argv);
}
