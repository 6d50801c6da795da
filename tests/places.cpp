#include "places.hpp"

std::string source_folder() { return ALGAE_SOURCE_DIR; }
std::string built_command() { return ALGAE_COMMAND; }
