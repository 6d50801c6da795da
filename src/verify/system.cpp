#include "verify/system.hpp"

#include <algorithm>

namespace algae::verify {

std::vector<Symbol> accessible_letters(const System& system, const Word& from) {
    std::set<Symbol> letters(from.begin(), from.end());
    for (std::size_t before = 0; before != letters.size();) {
        before = letters.size();
        const std::set<Symbol> known = letters;
        for (const Symbol a : known) {
            for (const auto& table : system.tables)
                for (const Word& word : table[a]) letters.insert(word.begin(), word.end());
            for (const System::Rule& rule : system.rules)
                if (rule.letter == a) letters.insert(rule.successor.begin(), rule.successor.end());
        }
    }
    return {letters.begin(), letters.end()};
}

bool has_only_terminals(const System& system) {
    const auto letters = accessible_letters(system, system.axiom);
    return std::all_of(letters.begin(), letters.end(),
                       [&](Symbol a) { return system.terminal[a]; });
}

namespace {

bool is_deterministic(const System& system) {
    const auto letters = accessible_letters(system, system.axiom);
    return std::all_of(system.tables.begin(), system.tables.end(), [&](const auto& table) {
        return std::all_of(letters.begin(), letters.end(),
                           [&](Symbol a) { return table[a].size() == 1; });
    });
}

bool is_propagating(const System& system) {
    const auto letters = accessible_letters(system, system.axiom);
    return std::all_of(system.tables.begin(), system.tables.end(), [&](const auto& table) {
        return std::all_of(letters.begin(), letters.end(), [&](Symbol a) {
            return std::all_of(table[a].begin(), table[a].end(),
                               [](const Word& word) { return !word.empty(); });
        });
    });
}

}  // namespace

bool is_d0l(const System& system) {
    return !system.context && system.tables.size() == 1 && is_deterministic(system) &&
           has_only_terminals(system);
}

std::set<Symbol> lasting_letters(const System::Successors& table) {
    std::set<Symbol> letters;
    for (Symbol a = 0; a < table.size(); ++a) letters.insert(a);
    for (std::size_t before = 0; before != letters.size();) {
        before = letters.size();
        const std::set<Symbol> known = letters;
        for (const Symbol a : known)
            if (std::none_of(table[a].begin(), table[a].end(), [&](const Word& word) {
                    return std::any_of(word.begin(), word.end(),
                                       [&](Symbol b) { return known.contains(b); });
                }))
                letters.erase(a);
    }
    return letters;
}

bool is_endless(const System& system) {
    if (system.context || system.tables.size() != 1 || !has_only_terminals(system)) return false;
    const auto& table = system.tables.front();
    const std::set<Symbol> lasting = lasting_letters(table);
    for (const Symbol a : accessible_letters(system, system.axiom))
        for (const Word& successor : table[a])
            for (std::size_t i = 0; i < successor.size(); ++i) {
                const auto others = [&](std::size_t at) { return at != i && lasting.contains(successor[at]); };
                bool beside = false;
                for (std::size_t at = 0; at < successor.size(); ++at) beside = beside || others(at);
                if (!beside) continue;
                const auto derived = accessible_letters(system, {successor[i]});
                if (std::find(derived.begin(), derived.end(), a) != derived.end()) return true;
            }
    return false;
}

std::optional<std::string> beyond_form(const System& system, const std::string& family,
                                       bool empty_axiom) {
    const bool interactive = family == "IL";
    const bool extended = family.find('E') != std::string::npos;
    const bool tables = family.find('T') != std::string::npos;
    if (!interactive && !family.ends_with("0L"))
        return "no system has the form of the family " + family;
    if (!empty_axiom && system.axiom.empty()) return "the axiom is empty";
    if (system.context)
        return interactive ? std::nullopt : std::optional<std::string>("the rules have contexts");
    if (!tables && system.tables.size() != 1) return "the system has more than one table";
    if (!extended && !has_only_terminals(system))
        return "a letter that is no terminal occurs in derived words";
    if (family.find('D') != std::string::npos && !is_deterministic(system))
        return "a letter has more than one successor";
    if (family.find('P') != std::string::npos && !is_propagating(system))
        return "a letter has the empty successor";
    return std::nullopt;
}

namespace {

/// Whether the letters that are seen before the position, from right to left, end with the context.
bool matches_left(const System& system, const Word& word, std::size_t position, const Word& left) {
    std::size_t wanted = left.size();
    while (wanted > 0 && position > 0) {
        --position;
        if (system.ignored[word[position]]) continue;
        if (word[position] != left[wanted - 1]) return false;
        --wanted;
    }
    return wanted == 0;
}

bool matches_right(const System& system, const Word& word, std::size_t position,
                   const Word& right) {
    std::size_t done = 0;
    for (++position; done < right.size() && position < word.size(); ++position) {
        if (system.ignored[word[position]]) continue;
        if (word[position] != right[done]) return false;
        ++done;
    }
    return done == right.size();
}

}  // namespace

Word next_word(const System& system, const Word& word) {
    Word next;
    for (std::size_t i = 0; i < word.size(); ++i) {
        const System::Rule* best = nullptr;
        for (const System::Rule& rule : system.rules) {
            if (rule.letter != word[i]) continue;
            if (best &&
                rule.left.size() + rule.right.size() <= best->left.size() + best->right.size())
                continue;
            if (matches_left(system, word, i, rule.left) &&
                matches_right(system, word, i, rule.right))
                best = &rule;
        }
        if (best)
            next.insert(next.end(), best->successor.begin(), best->successor.end());
        else
            next.push_back(word[i]);
    }
    return next;
}

bool may_give(const System::Successors& table, const Word& from, const Word& to) {
    std::set<std::size_t> reached{0};  // how much of `to` the letters so far can have become
    for (const Symbol a : from) {
        std::set<std::size_t> next;
        for (const std::size_t start : reached)
            for (const Word& image : table[a])
                if (image.size() <= to.size() - start &&
                    std::equal(image.begin(), image.end(),
                               to.begin() + static_cast<std::ptrdiff_t>(start)))
                    next.insert(start + image.size());
        reached = std::move(next);
        if (reached.empty()) return false;
    }
    return reached.contains(to.size());
}

bool never_shrinks(const System& system) {
    if (system.context)
        return std::none_of(system.rules.begin(), system.rules.end(),
                            [](const System::Rule& rule) { return rule.successor.empty(); });
    return is_propagating(system);
}

}  // namespace algae::verify
