#include "exchange/system_format.hpp"

#include "exchange/brno_file.hpp"
#include "exchange/maple_file.hpp"
#include "exchange/netlogo_file.hpp"

namespace algae {

const std::vector<SystemFormat>& system_formats() {
    static const std::vector<SystemFormat> all{
        {"brno", "a text file of a geometric interpreter of D0L systems", read_brno, print_brno},
        {"maple", "a worksheet that calls the Maple procedure Lsystem", read_maple, print_maple},
        {"netlogo", "the setup procedure of a NetLogo model of L-systems", read_netlogo,
         print_netlogo},
    };
    return all;
}

const SystemFormat* system_format(std::string_view file_name) {
    for (const SystemFormat& one : system_formats())
        if (file_name.ends_with("." + one.name)) return &one;
    return nullptr;
}

}  // namespace algae
