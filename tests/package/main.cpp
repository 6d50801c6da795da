#include <cstdlib>
#include <iostream>

#include "base/place.hpp"
#include "notation/gallery.hpp"

int main() {
    std::cout << algae::gallery().size() << " figures come with algae\n";
    const bool right = algae::to_string(algae::Place{"koch.lsys", 3, 11}) == "koch.lsys:3:11";
    return right ? EXIT_SUCCESS : EXIT_FAILURE;
}
