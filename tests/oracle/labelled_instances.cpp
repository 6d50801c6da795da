#include "oracle/labelled_instances.hpp"

#include <algorithm>
#include <functional>
#include <tuple>

namespace algae::oracle {

namespace {

using Rules = LabelledValue::Rules;

std::vector<std::string> all_words(const std::string& letters, std::size_t longest) {
    std::vector<std::string> words{""};
    for (std::size_t i = 0; i < words.size(); ++i)
        if (words[i].size() < longest)
            for (const char a : letters) words.push_back(words[i] + a);
    return words;
}

std::size_t size_of(const Rules& rules) {
    std::size_t size = 0;
    for (const auto& [letter, words] : rules)
        for (const std::string& word : words) size += word.size() + 1;
    return size;
}

/// All sets of words, or multisets, with one to `most` elements and at most this size.
std::vector<std::multiset<std::string>> all_sets(const std::vector<std::string>& words,
                                                 std::size_t size, std::size_t most, bool repeat) {
    std::vector<std::multiset<std::string>> found;
    std::multiset<std::string> now;
    const std::function<void(std::size_t, std::size_t)> add = [&](std::size_t from,
                                                                  std::size_t left) {
        if (!now.empty()) found.push_back(now);
        if (now.size() == most) return;
        for (std::size_t i = from; i < words.size(); ++i) {
            if (words[i].size() + 1 > left) continue;
            const auto place = now.insert(words[i]);
            add(repeat ? i : i + 1, left - words[i].size() - 1);
            now.erase(place);
        }
    };
    add(0, size);
    return found;
}

std::vector<std::string> images(const LabelledDomain& domain, const std::string& letters,
                                std::size_t size) {
    std::vector<std::string> words;
    for (const std::string& word : all_words(letters, std::min(size, domain.greatest_length)))
        if (!(word.empty() && domain.nonempty) && !(domain.coding && word.size() != 1))
            words.push_back(word);
    return words;
}

/// All rules of at most this size for these letters, words over others.
std::vector<Rules> all_rules(const LabelledDomain& domain, const std::string& of,
                             const std::string& over, std::size_t size, bool one) {
    std::vector<Rules> found{{}};
    const auto sets = all_sets(images(domain, over, size), size, one ? 1 : 1000, false);
    for (const char a : of) {
        std::vector<Rules> more;
        for (const Rules& rules : found)
            for (const auto& set : sets) {
                Rules next = rules;
                next[a] = {set.begin(), set.end()};
                if (size_of(next) <= size) more.push_back(next);
            }
        found = std::move(more);
    }
    return found;
}

bool reaches_all(const LabelledValue& system, const std::string& letters) {
    std::set<char> reached(system.axiom.begin(), system.axiom.end());
    for (std::size_t round = 0; round <= letters.size(); ++round)
        for (const Rules& rules : system.tables)
            for (const auto& [letter, words] : rules)
                if (reached.contains(letter))
                    for (const std::string& word : words) reached.insert(word.begin(), word.end());
    return reached == std::set<char>(letters.begin(), letters.end());
}

std::vector<LabelledValue> all_systems(const LabelledDomain& domain, const std::string& alphabet,
                                       std::size_t size) {
    std::vector<LabelledValue> found;
    for (unsigned choice = 1; choice < 1U << alphabet.size(); ++choice) {
        std::string letters;
        for (std::size_t i = 0; i < alphabet.size(); ++i)
            if (choice >> i & 1) letters += alphabet[i];
        if (letters.size() > domain.most_letters || size == 0) continue;
        const auto tables = all_rules(domain, letters, letters, size - 1, domain.deterministic);
        for (const std::string& axiom :
             all_words(letters, std::min(size, domain.greatest_length))) {
            if (axiom.empty()) continue;
            LabelledValue system;
            system.axiom = axiom;
            const std::function<void(std::size_t, std::size_t)> add = [&](std::size_t from,
                                                                          std::size_t left) {
                if (left == 0 && !system.tables.empty() && reaches_all(system, letters))
                    found.push_back(system);
                if (!domain.tables && system.tables.size() == 1) return;
                for (std::size_t i = from; i < tables.size(); ++i) {
                    const std::size_t needed = size_of(tables[i]);
                    if (needed == 0 || needed > left) continue;
                    system.tables.insert(tables[i]);
                    add(i + 1, left - needed);
                    system.tables.erase(tables[i]);
                }
            };
            add(0, size - axiom.size());
        }
    }
    return found;
}

std::set<char> letters_in(const LabelledValue& value) {
    std::set<char> letters(value.axiom.begin(), value.axiom.end());
    for (const std::string& word : value.words) letters.insert(word.begin(), word.end());
    for (const Rules& rules : value.tables)
        for (const auto& [letter, words] : rules)
            for (const std::string& word : words) letters.insert(word.begin(), word.end());
    return letters;
}

std::vector<LabelledValue> all_values(const LabelledDomain& domain, const std::string& alphabet,
                                      const std::string& used, std::size_t size) {
    std::vector<LabelledValue> found;
    const auto add_words = [&](const std::multiset<std::string>& words) {
        LabelledValue value;
        value.words = words;
        found.push_back(value);
    };
    const auto sum = [](const std::multiset<std::string>& words) {
        std::size_t total = 0;
        for (const std::string& word : words) total += word.size() + 1;
        return total;
    };
    if (size > domain.greatest_size) return found;
    switch (domain.kind) {
        case 'L':
            if (size == 0) add_words({});
            for (const auto& set : all_sets(images(domain, alphabet, size), size, 1000, false))
                if (sum(set) == size) add_words(set);
            break;
        case 'S':
            found = all_systems(domain, alphabet, size);
            break;
        case 'w':
            for (const std::string& word : images(domain, alphabet, size))
                if (word.size() + 1 == size) add_words({word});
            break;
        case 'x':
            for (const char a : alphabet)
                if (size == 1) add_words({std::string(1, a)});
            break;
        case 'i':
            for (const auto& set :
                 all_sets(images(domain, used, size), size, domain.most_letters, true))
                if (sum(set) == size) add_words(set);
            return found;  // its bound is one of the letters of its domain
        case 'n':
            found.emplace_back();
            found.back().number = size;
            break;
        default:
            for (const Rules& rules : all_rules(domain, used, alphabet, size, domain.kind == 'h'))
                if (size_of(rules) == size) {
                    found.emplace_back();
                    found.back().tables = {rules};
                }
    }
    std::erase_if(found, [&](const LabelledValue& value) {
        return letters_in(value).size() > domain.most_letters;
    });
    return found;
}

LabelledTuple renamed(const LabelledTuple& tuple, const std::map<char, char>& to) {
    const auto of = [&](std::string word) {
        for (char& a : word) a = to.at(a);
        return word;
    };
    LabelledTuple result;
    for (const LabelledValue& value : tuple) {
        LabelledValue& next = result.emplace_back();
        next.number = value.number;
        next.axiom = of(value.axiom);
        for (const std::string& word : value.words) next.words.insert(of(word));
        for (const Rules& rules : value.tables) {
            Rules changed;
            for (const auto& [letter, words] : rules)
                for (const std::string& word : words) changed[to.at(letter)].insert(of(word));
            next.tables.insert(changed);
        }
    }
    return result;
}

}  // namespace

std::vector<LabelledTuple> labelled_tuples(const std::vector<LabelledDomain>& domains,
                                           std::size_t size, std::size_t letters, bool disjoint) {
    const std::string alphabet = std::string("abcdefgh").substr(0, letters);
    std::vector<LabelledTuple> found;
    LabelledTuple now;
    std::map<std::tuple<std::size_t, std::string, std::size_t>, std::vector<LabelledValue>> known;
    const std::function<void(std::size_t, const std::set<char>&)> add =
        [&](std::size_t left, const std::set<char>& used) {
            if (now.size() == domains.size()) {
                if (left == 0) found.push_back(now);
                return;
            }
            const LabelledDomain& domain = domains[now.size()];
            const std::string letters_used(used.begin(), used.end());
            const bool is_apart =
                disjoint && std::string("LSwx").find(domain.kind) != std::string::npos;
            for (std::size_t part = 0; part <= left; ++part) {
                const std::tuple key(now.size(), letters_used, part);
                if (!known.contains(key))
                    known[key] = all_values(domain, alphabet, letters_used, part);
                for (const LabelledValue& value : known[key]) {
                    const std::set<char> its = letters_in(value);
                    if (is_apart && std::any_of(its.begin(), its.end(),
                                                [&](char a) { return used.contains(a); }))
                        continue;
                    std::set<char> together = used;
                    together.insert(its.begin(), its.end());
                    now.push_back(value);
                    add(left - part, together);
                    now.pop_back();
                }
            }
        };
    add(size, {});
    return found;
}

std::string written(const LabelledTuple& tuple) {
    std::string text;
    for (const LabelledValue& value : tuple) {
        text += std::to_string(value.number) + ' ' + value.axiom + ' ';
        for (const std::string& word : value.words) text += '<' + word + '>';
        for (const Rules& rules : value.tables) {
            text += '{';
            for (const auto& [letter, words] : rules) {
                text += letter;
                for (const std::string& word : words) text += '<' + word + '>';
            }
            text += '}';
        }
        text += ';';
    }
    return text;
}

std::string least_renamed(const LabelledTuple& tuple, std::size_t letters) {
    const std::string alphabet = std::string("abcdefgh").substr(0, letters);
    std::string names = alphabet, least;
    do {
        std::map<char, char> to;
        for (std::size_t i = 0; i < letters; ++i) to[alphabet[i]] = names[i];
        const std::string text = written(renamed(tuple, to));
        if (least.empty() || text < least) least = text;
    } while (std::next_permutation(names.begin(), names.end()));
    return least;
}

}  // namespace algae::oracle
