#include "system/environment_setting.hpp"

namespace algae {

const std::vector<EnvironmentKind>& environment_kinds() {
    static const std::vector<EnvironmentKind> kinds{
        {"x", "", {0}},
        {"y", "", {0}},
        {"z", "", {0}},
        {"position", "", {0}},
        {"heading", "", {0}},
        {"clip", "two corners, X Y X Y or X Y Z X Y Z", {4, 6}},
        {"collision", "a radius", {1}},
        {"light", "a radius", {1}},
        {"external", "", {0}}};
    return kinds;
}

bool is_communication(std::string_view name) { return name.size() > 1 && name[0] == '?'; }

}  // namespace algae
