#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "render/output.hpp"

namespace algae {

/// Takes out of a PostScript document the line that says when it was made, so that equal figures
/// are equal files.
class UndatedOutput final : public Output {
public:
    explicit UndatedOutput(Output& next) : next_(next) {}
    void write(const char* bytes, std::size_t count) override;
    /// Passes on what was held back. Call once, at the end.
    void finish();

private:
    Output& next_;
    std::string header_;
    bool in_header_ = true;
};

/// Numbers the surfaces and images of an SVG document from 1 in order of appearance: Cairo's own
/// numbers count everything the process has drawn before.
class RenumberedOutput final : public Output {
public:
    explicit RenumberedOutput(Output& next) : next_(next) {}
    void write(const char* bytes, std::size_t count) override;
    /// Passes on what was held back. Call once, at the end.
    void finish();

private:
    void pass_on(bool at_end);

    Output& next_;
    std::string held_;
    std::map<std::string, std::size_t> numbers_;
};

}  // namespace algae
