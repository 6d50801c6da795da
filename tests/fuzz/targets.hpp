#pragma once
// What the fuzzer runs (tools/fuzz), and what a test runs over texts of the repository and over inputs that once
// broke something: one table of functions of bytes.

#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "exact/exact.hpp"

namespace algae::fuzz {

using Texts = std::vector<std::string>;

/// The bytes broke a law: what should hold, and what was found.
struct Broken : std::logic_error {
    using std::logic_error::logic_error;
};

/// Throws Broken with the message unless it holds.
inline void expect(bool holds, const std::string& message) {
    if (!holds) throw Broken(message);
}

struct Target {
    std::string name;
    std::string what;  // it reads or compares
    /// Throws Broken if the bytes break a law. It may throw the errors and stops of algae.
    std::function<void(std::string_view)> take;
    std::function<Texts()> seeds;  // inputs from the repository
    std::size_t longest = 400;     // bytes of an input; short ones are fast
};

/// All of them.
const std::vector<Target>& targets();

/// The target of this name; nullptr if there is none.
const Target* target(std::string_view name);

/// Gives the bytes to a target. Its errors and stops are what bad input and small budgets lead to; whatever else is thrown
/// is a defect and comes out.
void run(const Target& target, std::string_view bytes);

/// The inputs from the repository that are not longer than inputs may be, each once.
Texts seeds(const Target& target);

/// What the target's inputs are written with, the most frequent words and signs of its seeds first.
Texts dictionary(const Target& target);

/// What a piece of work may use that is done ten thousand times a second.
Budget small_budget();

// The parts of the table.

/// Readers of files of the notation and of other programs.
std::vector<Target> readers();
/// Certificates: their reader, `verify`, and proofs of `language`.
std::vector<Target> certificates();
/// Systems made from the bytes; the library against the slow routes of tests/oracle.
std::vector<Target> comparisons();

// Where seeds come from.

/// The files in folders of the repository, and below, whose names end so.
std::function<Texts()> files(std::vector<std::string> folders, std::string ending);
/// Their lines that begin so, without this beginning.
std::function<Texts()> lines(std::vector<std::string> folders, std::string ending,
                             std::string beginning = "");
/// So many texts of random bytes, always the same.
std::function<Texts()> random_bytes(std::size_t count, std::size_t length);

/// Small numbers out of bytes; all are 0 behind the last byte.
class Bytes {
public:
    explicit Bytes(std::string_view rest) : rest_(rest) {}

    std::size_t below(std::size_t count) {
        std::size_t number = next();
        if (count > 256) number = 256 * number + next();
        return count == 0 ? 0 : number % count;
    }
    bool is_empty() const { return rest_.empty(); }
    std::string_view rest() const { return rest_; }

    /// A word of up to `most` of these letters.
    std::string word(std::string_view letters, std::size_t most, std::size_t least = 0) {
        std::string text(least + below(most - least + 1), ' ');
        for (char& letter : text) letter = letters[below(letters.size())];
        return text;
    }

private:
    std::size_t next() {
        if (rest_.empty()) return 0;
        const auto byte = static_cast<unsigned char>(rest_.front());
        rest_.remove_prefix(1);
        return byte;
    }

    std::string_view rest_;
};

}  // namespace algae::fuzz
