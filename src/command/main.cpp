// The program; everything else is in verbs.cpp.

#include "command/detail/verb.hpp"

int main(int argc, char** argv) {
    algae::command::handle_stops();
    return algae::command::run_command(argc, argv);
}
