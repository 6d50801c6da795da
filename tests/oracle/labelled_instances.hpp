#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace algae::oracle {

/// What one value of a tuple ranges over: L a finite language, S a system, w a word, x a letter, h a morphism, i an inverse morphism,
/// s a substitution, n a number.
struct LabelledDomain {
    char kind = 'L';
    bool deterministic = false, tables = false, coding = false;
    bool nonempty = false;  // no empty successors or images
    std::size_t greatest_size = 1000, greatest_length = 1000, most_letters = 1000;
};

/// A value over the letters a, b, ...
struct LabelledValue {
    using Rules = std::map<char, std::set<std::string>>;
    std::multiset<std::string>
        words;  // of a language, the word, the letter, images of an inverse morphism
    std::string axiom;
    std::set<Rules> tables;  // of a system; of a morphism or substitution the one
    std::size_t number = 0;
};
using LabelledTuple = std::vector<LabelledValue>;

/// Every tuple of this total size over the first `letters` letters of the alphabet, the letters of the languages, systems, words and
/// letters apart from each other if wanted. Everything is written down, so sizes must be small.
std::vector<LabelledTuple> labelled_tuples(const std::vector<LabelledDomain>& domains,
                                           std::size_t size, std::size_t letters, bool disjoint);

/// The tuple as text, sets sorted.
std::string written(const LabelledTuple& tuple);

/// The least text of all tuples that it can be renamed to, each letter of the first `letters` tried for each.
std::string least_renamed(const LabelledTuple& tuple, std::size_t letters);

}  // namespace algae::oracle
