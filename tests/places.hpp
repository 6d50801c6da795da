// Where the sources stand, and the built command. Only places.cpp is compiled with these paths, so that a compiler
// cache serves all other tests to every clone.
#pragma once

#include <string>

std::string source_folder();
std::string built_command();
