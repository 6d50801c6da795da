#include "exchange/relative_format.hpp"

#include "exchange/ca_table.hpp"
#include "exchange/ifs_table.hpp"

namespace algae {

const std::vector<RelativeFormat>& relative_formats() {
    static const std::vector<RelativeFormat> all{
        {"ca-table", "ca", "the table of a rule of cells on a line", read_ca_table, print_ca_table},
        {"ifs-table", "ifs", "the table of an iterated function system", read_ifs_table,
         print_ifs_table}};
    return all;
}

const RelativeFormat* relative_format(std::string_view file_name) {
    for (const RelativeFormat& one : relative_formats())
        if (file_name.ends_with("." + one.name)) return &one;
    return nullptr;
}

}  // namespace algae
