#pragma once
// Where tests of files of other programs take their texts from, and what no text may do.

#include <rapidcheck.h>

#include <fstream>
#include <sstream>
#include <string>

#include "exact/exact.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "places.hpp"
#include "system/system.hpp"

namespace algae::exchange_tests {

/// The text of a file of the folder `examples`.
inline std::string example(const std::string& name) {
    std::ifstream file(source_folder() + "/examples/" + name);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

inline Model of_gallery(const std::string& name) {
    for (const GalleryEntry& entry : gallery())
        if (entry.name == name) return read_lsystem(entry.text, name);
    throw Error("no " + name);
}

/// Reads a text of any kind: it is a system that is read again as it is printed, or faults with
/// places in the file.
template <class Read, class Print>
void survive(const std::string& text, const std::string& file, Read read, Print print) {
    try {
        const Model system = read(text, file);
        RC_ASSERT(read(print(system), file) == system);
    } catch (const Diagnostics& error) {
        for (const Diagnostic& finding : error.findings()) {
            RC_ASSERT(finding.place.file == file);
            RC_ASSERT(!finding.message.empty());
        }
    }
}

/// The text 200,000 times.
inline std::string many(const std::string& part) {
    std::string out;
    for (int i = 0; i < 200'000; ++i) out += part;
    return out;
}

}  // namespace algae::exchange_tests
