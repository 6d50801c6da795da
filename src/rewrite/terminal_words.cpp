#include "rewrite/terminal_words.hpp"

#include <algorithm>
#include <charconv>
#include <set>
#include <string>

#include "base/error.hpp"

namespace algae {

namespace {

/// A set of words that knows about how many bytes it takes.
struct WordSet {
    std::set<Word> words;
    std::uint64_t bytes = 0;

    bool add(Word word, const Budget& budget) {
        const std::size_t taken = word.size() * sizeof(Symbol) + 80;
        if (!words.insert(std::move(word)).second) return false;
        budget.check_memory(bytes += taken, "the words on the way");
        return true;
    }
};

/// All words that a table makes of one.
void add_successors(const Table& table, const Word& word, std::size_t longest, const Budget& budget,
                    WordSet& to) {
    WordSet beginnings;
    beginnings.add({}, budget);
    for (const Symbol a : word) {
        budget.check();
        WordSet longer;
        for (const Word& beginning : beginnings.words)
            for (const Word& successor : table[a]) {
                if (beginning.size() + successor.size() > longest) continue;
                Word next = beginning;
                next.insert(next.end(), successor.begin(), successor.end());
                longer.add(std::move(next), budget);
            }
        beginnings = std::move(longer);
    }
    for (const Word& next : beginnings.words) to.add(next, budget);
}

std::size_t table_of(const std::vector<std::string>& tables, const std::string& name) {
    const auto found = std::find(tables.begin(), tables.end(), name);
    if (found != tables.end()) return static_cast<std::size_t>(found - tables.begin());
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
    if (error == std::errc() && end == name.data() + name.size() && number >= 1 &&
        number <= tables.size())
        return number - 1;
    std::string known;
    for (const std::string& table : tables) known += (known.empty() ? "" : ", ") + table;
    throw Error("expected a table (" + known + ", or a number from 1 to " +
                std::to_string(tables.size()) + "), found \"" + name + '"');
}

}  // namespace

std::vector<Word> terminal_words(const ET0L& system, std::uint64_t n,
                                 std::optional<std::size_t> longest, const Budget& budget) {
    const std::size_t bound = longest && is_propagating(system) ? *longest : ~std::size_t{0} / 2;
    WordSet here, found;
    if (system.axiom.size() <= bound) here.add(system.axiom, budget);
    for (std::uint64_t k = 0;; ++k) {
        for (const Word& word : here.words)
            if ((!longest || word.size() <= *longest) &&
                std::all_of(word.begin(), word.end(),
                            [&](Symbol a) { return system.terminal[a] != 0; }))
                found.add(word, budget);
        if (k == n) break;
        WordSet next;
        for (const Table& table : system.tables)
            for (const Word& word : here.words) add_successors(table, word, bound, budget, next);
        if (next.words == here.words) break;  // and so for ever
        here = std::move(next);
    }
    std::vector<Word> out(found.words.begin(), found.words.end());
    const auto ranks = system.alphabet->ranks();
    std::sort(out.begin(), out.end(), [&](const Word& a, const Word& b) {
        if (a.size() != b.size()) return a.size() < b.size();
        return std::lexicographical_compare(
            a.begin(), a.end(), b.begin(), b.end(),
            [&](Symbol x, Symbol y) { return ranks[x] < ranks[y]; });
    });
    return out;
}

std::vector<std::size_t> table_sequence(const std::vector<std::string>& tables,
                                        const std::string& text) {
    if (tables.empty()) throw Error("the system has no tables to choose from");
    std::vector<std::size_t> out;
    if (text.find(',') != std::string::npos ||
        std::find(tables.begin(), tables.end(), text) != tables.end()) {
        for (std::size_t from = 0; from <= text.size();) {
            const std::size_t comma = std::min(text.find(',', from), text.size());
            out.push_back(table_of(tables, text.substr(from, comma - from)));
            from = comma + 1;
        }
        return out;
    }
    for (std::size_t from = 0; from < text.size();) {
        std::size_t size = 1;  // bytes of the character
        while (from + size < text.size() &&
               (static_cast<unsigned char>(text[from + size]) & 0xC0) == 0x80)
            ++size;
        out.push_back(table_of(tables, text.substr(from, size)));
        from += size;
    }
    return out;
}

}  // namespace algae
