#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "notation/source.hpp"

namespace algae {

/// What stopped a grammar: a byte of the text and what is wrong there. Used within this room only.
struct SyntaxError {
    const char* where;
    std::string message;
    bool names_found = true;  // otherwise ", found ..." is still to be added
};

/// Thrown instead where a statement depends on a faulty one: nothing new is to be said.
struct DependsOnError {};

/// "expected `expectation`, found ..." with what stands at `where` or behind the blanks there.
SyntaxError unexpected(const std::string& expectation, const char* where);

/// The findings about one text, gathered while its reader goes on.
class Findings {
public:
    explicit Findings(const Source& source) : source_(source) {}

    void add(std::size_t offset, std::string message);
    void add(const char* where, std::string message) {
        add(source_.offset(where), std::move(message));
    }
    void add(const Place& place, std::string message) {
        add(source_.offset(place), std::move(message));
    }
    void add(const SyntaxError& error);

    bool empty() const { return count_ == 0; }
    std::size_t count() const { return count_; }

    /// Throws `Diagnostics` if the source has bytes that are no text: the grammars rely on whole
    /// characters.
    void throw_if_no_text();

    /// Throws `Diagnostics` if there are any: the first twenty in order of place, then one that says
    /// how many more there are.
    void throw_if_any() const;

private:
    struct Finding {
        std::size_t offset;
        std::string message;
    };
    static constexpr std::size_t most_shown = 20;
    static constexpr std::size_t most_kept = 10000;

    const Source& source_;
    std::vector<Finding> findings_;
    std::size_t count_ = 0;
};

}  // namespace algae
