#include "oracle/finite_systems.hpp"

#include <algorithm>
#include <bit>

namespace algae::oracle {

namespace {

/// Counts through all choices: true until every place has gone through all its values.
bool next_choice(std::vector<std::size_t>& choice, std::size_t values) {
    for (std::size_t& digit : choice) {
        if (++digit < values) return true;
        digit = 0;
    }
    return false;
}

}  // namespace

std::vector<std::string> FiniteSystems::words(int letters, std::size_t longest) {
    std::vector<std::string> all{""};
    for (std::size_t i = 0; i < all.size(); ++i)
        for (int a = 0; a < letters && all[i].size() < longest; ++a)
            all.push_back(all[i] + static_cast<char>('a' + a));
    return all;
}

FiniteSystems::FiniteSystems(int letters, std::size_t longest, bool propagating, bool deterministic)
    : words_(words(letters, longest)) {
    const std::size_t sets = std::size_t{1} << words_.size();
    std::vector<std::uint64_t> choices;  // what the successors of one letter may be
    for (std::uint64_t set = 1; set < sets; ++set) {
        if (propagating && set % 2 == 1) continue;
        if (deterministic && std::popcount(set) != 1) continue;
        choices.push_back(set);
    }
    std::vector<std::size_t> choice(static_cast<std::size_t>(letters), 0);
    do {
        Table table;
        for (std::size_t w = 0; w < words_.size(); ++w) {
            std::set<std::string> results{""};
            for (const char letter : words_[w]) {
                std::set<std::string> longer;
                const std::uint64_t successors =
                    choices[choice[static_cast<std::size_t>(letter - 'a')]];
                for (const std::string& result : results)
                    for (std::size_t i = 0; i < words_.size(); ++i)
                        if (successors >> i & 1) longer.insert(result + words_[i]);
                results = std::move(longer);
            }
            std::uint64_t given = 0;
            bool inside = true;
            for (const std::string& result : results) {
                const auto place = std::find(words_.begin(), words_.end(), result);
                inside = inside && place != words_.end();
                if (place != words_.end()) given |= std::uint64_t{1} << (place - words_.begin());
            }
            table.given.push_back(given);
            if (inside) table.kept |= std::uint64_t{1} << w;
        }
        tables_.push_back(std::move(table));
    } while (next_choice(choice, choices.size()));
}

std::uint64_t FiniteSystems::reached(std::size_t axiom,
                                     const std::vector<std::uint64_t>& given) const {
    std::uint64_t all = std::uint64_t{1} << axiom;
    for (std::uint64_t before = 0; before != all;) {
        before = all;
        for (std::size_t w = 0; w < words_.size(); ++w)
            if (before >> w & 1) all |= given[w];
    }
    return all;
}

std::set<std::uint64_t> FiniteSystems::without_tables() const {
    std::set<std::uint64_t> languages;
    for (const Table& table : tables_)
        for (std::size_t axiom = 1; axiom < words_.size(); ++axiom) {
            const std::uint64_t language = reached(axiom, table.given);
            if ((language & ~table.kept) == 0) languages.insert(language);
        }
    return languages;
}

std::set<std::uint64_t> FiniteSystems::with_tables() const {
    std::set<std::uint64_t> languages;
    for (std::uint64_t language = 1; language < std::uint64_t{1} << words_.size(); ++language) {
        std::vector<std::uint64_t> given(words_.size(), 0);
        for (const Table& table : tables_) {
            std::uint64_t results = 0;
            for (std::size_t w = 0; w < words_.size(); ++w)
                if (language >> w & 1) results |= table.given[w];
            if ((language & ~table.kept) != 0 || (results & ~language) != 0) continue;
            for (std::size_t w = 0; w < words_.size(); ++w) given[w] |= table.given[w];
        }
        for (std::size_t axiom = 1; axiom < words_.size(); ++axiom)
            if ((language >> axiom & 1) && reached(axiom, given) == language)
                languages.insert(language);
    }
    return languages;
}

std::vector<std::string> words_of(const std::vector<std::string>& words, std::uint64_t language) {
    std::vector<std::string> some;
    for (std::size_t i = 0; i < words.size(); ++i)
        if (language >> i & 1) some.push_back(words[i]);
    return some;
}

}  // namespace algae::oracle
