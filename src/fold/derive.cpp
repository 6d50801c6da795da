#include "fold/derive.hpp"

#include <string>

#include "fold/lifts.hpp"
#include "fold/walk.hpp"

namespace algae {

namespace {

constexpr std::size_t block_bytes = std::size_t{1} << 20;

/// What each letter becomes in `steps` steps, spelled.
struct Blocks {
    Hom<Spellings> text;
    std::uint64_t steps;
};

std::size_t total_bytes(const Hom<Spellings>& row, const std::vector<Symbol>& letters) {
    std::size_t bytes = 0;
    for (const Symbol a : letters) bytes += row.images[a].text.size();
    return bytes;
}

/// The bytes that a further step would take, no more than a little over `block_bytes`.
std::size_t next_bytes(const D0L& system, const Hom<Spellings>& row) {
    std::size_t bytes = 0;
    for (const Symbol a : system.letters)
        for (const Symbol b : system.successor(a)) {
            bytes += row.images[b].text.size();
            if (bytes > block_bytes) return bytes;
        }
    return bytes;
}

Blocks blocks(const D0L& system, std::uint64_t n, const Budget& budget) {
    Blocks found{homomorphism(system, spelling_lift(*system.alphabet)), 0};
    std::size_t written = 0;  // by all steps: words that grow slowly or not at all must not take long
    while (found.steps < n && next_bytes(system, found.text) <= block_bytes && written < 64 * block_bytes) {
        budget.check();
        found.text = found.text.after(system.rules, system.letters);
        ++found.steps;
        written += total_bytes(found.text, system.letters) + 64 * system.letters.size();
    }
    return found;
}

class StringSink : public TextSink {
public:
    void write(std::string_view piece) override { text += piece; }
    void flush() override {}
    std::string text;
};

}  // namespace

bool derive_text(const D0L& system, std::uint64_t n, TextSink& sink, const Budget& budget) {
    const Fates fates(system);
    const Blocks ready = blocks(system, n, budget);
    const Spellings& spellings = ready.text.monoid;
    bool begun = false;
    Symbol last = 0;
    std::uint64_t visits = 0;
    walk(system, fates, n, [&](Symbol a, std::uint64_t steps) {
        if (++visits % 1024 == 0) budget.check();
        if (steps > ready.steps) return true;
        // Below the blocks' level (constants, and axioms of young generations) nothing is tabulated
        // but the letter itself and the blocks; a constant is its own block.
        const auto& block = ready.text.images[a];
        if (block.text.empty()) return false;
        if (begun && spellings.blank_between(last, block.first)) sink.write(" ");
        sink.write(block.text);
        begun = true;
        last = block.last;
        return false;
    });
    sink.flush();
    return begun;
}

std::string derived_text(const D0L& system, std::uint64_t n, const Budget& budget) {
    StringSink sink;
    derive_text(system, n, sink, budget);
    return std::move(sink.text);
}

Word derive(const D0L& system, std::uint64_t n, const Budget& budget) {
    const Fates fates(system);
    Word word;
    std::uint64_t visits = 0;
    walk(system, fates, n, [&](Symbol a, std::uint64_t steps) {
        if (++visits % 65536 == 0) budget.check();
        if (steps > 0) return true;
        if (word.size() == budget.letters)
            throw BoundReached(Bound::letters,
                               "generation " + std::to_string(n) + " has more than " +
                                   std::to_string(budget.letters) + " letters, the bound set" +
                                   budget.by(Bound::letters));
        word.push_back(a);
        return true;
    });
    return word;
}

}  // namespace algae
