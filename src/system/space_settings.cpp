#include "system/space_settings.hpp"

namespace algae {

const std::vector<std::string>& surface_kinds() {
    static const std::vector<std::string> kinds{"leaf", "petal", "disc", "polygon", "patch"};
    return kinds;
}

}  // namespace algae
