#pragma once
// Domains and instances as the slow route has them.

#include <rapidcheck.h>

#include <algorithm>
#include <string>
#include <vector>

#include "oracle/labelled_instances.hpp"
#include "search/search.hpp"

namespace algae {

inline oracle::LabelledDomain labelled(const Domain& domain) {
    constexpr char kinds[] = "LSwxhisn";
    oracle::LabelledDomain same;
    same.kind = kinds[static_cast<std::size_t>(domain.kind)];
    same.deterministic = domain.deterministic;
    same.tables = domain.tables;
    same.coding = domain.letter_to_letter;
    same.nonempty = domain.propagating || domain.nonerasing;
    same.greatest_size = domain.max_size.value_or(same.greatest_size);
    same.greatest_length = domain.max_word_length.value_or(same.greatest_length);
    same.most_letters = domain.letters.value_or(same.most_letters);
    if (domain.max_number)
        same.greatest_size =
            std::min(same.greatest_size, static_cast<std::size_t>(*domain.max_number));
    return same;
}

inline std::vector<oracle::LabelledDomain> labelled(const Tuple& tuple) {
    std::vector<oracle::LabelledDomain> same;
    for (const Domain& domain : tuple.values) same.push_back(labelled(domain));
    return same;
}

inline std::string written(const Word& word) {
    std::string text;
    for (const Symbol a : word) text += static_cast<char>('a' + a);
    return text;
}

/// The instance, read through the views of the face.
inline oracle::LabelledTuple labelled(const Instance& instance) {
    oracle::LabelledTuple tuple;
    for (std::size_t v = 0; v < instance.values(); ++v) {
        oracle::LabelledValue& value = tuple.emplace_back();
        switch (instance.kind(v)) {
            case Domain::Kind::language:
                for (const Word& word : instance.language(v)) value.words.insert(written(word));
                break;
            case Domain::Kind::system: {
                const ET0L system = instance.et0l(v);
                value.axiom = written(system.axiom);
                for (const Table& table : system.tables) {
                    oracle::LabelledValue::Rules rules;
                    for (const Symbol a : accessible_letters(system))
                        for (const Word& word : table[a])
                            rules[written({a})[0]].insert(written(word));
                    value.tables.insert(rules);
                }
                break;
            }
            case Domain::Kind::word:
                value.words.insert(written(instance.word(v)));
                break;
            case Domain::Kind::letter:
                value.words.insert(written({instance.letter(v)}));
                break;
            case Domain::Kind::inverse_morphism: {
                const Morphism morphism = instance.morphism(v);
                for (const Word& word : morphism.images()) value.words.insert(written(word));
                break;
            }
            case Domain::Kind::morphism: {
                oracle::LabelledValue::Rules rules;
                const Morphism morphism = instance.morphism(v);
                for (const Symbol a : morphism.domain())
                    rules[written({a})[0]].insert(written(morphism[a]));
                value.tables.insert(rules);
                break;
            }
            case Domain::Kind::substitution: {
                oracle::LabelledValue::Rules rules;
                for (const auto& [a, words] : instance.substitution(v))
                    for (const Word& word : words) rules[written({a})[0]].insert(written(word));
                value.tables.insert(rules);
                break;
            }
            case Domain::Kind::number:
                value.number = instance.number(v);
                break;
        }
    }
    return tuple;
}

inline rc::Gen<std::optional<std::uint64_t>> any_bound(std::uint64_t least, std::uint64_t most) {
    return rc::gen::oneOf(rc::gen::just(std::optional<std::uint64_t>()),
                          rc::gen::just(std::optional<std::uint64_t>()),
                          rc::gen::just(std::optional<std::uint64_t>()),
                          rc::gen::just(std::optional<std::uint64_t>()),
                          rc::gen::map(rc::gen::inRange(least, most + 1), [](std::uint64_t bound) {
                              return std::optional<std::uint64_t>(bound);
                          }));
}

inline rc::Gen<Domain> any_domain() {
    return rc::gen::apply(
        [](int kind, bool deterministic, bool propagating, bool tables, bool nonerasing,
           bool letter_to_letter, auto max_size, auto max_word_length, auto letters,
           auto max_number) {
            Domain domain{.kind = static_cast<Domain::Kind>(kind)};
            const auto is = [&](Domain::Kind other) { return domain.kind == other; };
            if (is(Domain::Kind::system)) {
                domain.deterministic = deterministic;
                domain.propagating = propagating;
                domain.tables = tables;
            }
            if (is(Domain::Kind::morphism) || is(Domain::Kind::inverse_morphism) ||
                is(Domain::Kind::substitution)) {
                domain.nonerasing = nonerasing;
                domain.letter_to_letter = letter_to_letter;
            }
            domain.max_size = max_size;
            if (!is(Domain::Kind::letter)) domain.max_word_length = max_word_length;
            domain.letters = letters;
            if (is(Domain::Kind::number)) domain.max_number = max_number;
            return domain;
        },
        rc::gen::inRange(0, 8), rc::gen::arbitrary<bool>(), rc::gen::arbitrary<bool>(),
        rc::gen::arbitrary<bool>(), rc::gen::arbitrary<bool>(), rc::gen::arbitrary<bool>(),
        any_bound(1, 4), any_bound(1, 3), any_bound(1, 3), any_bound(0, 2));
}

/// One to three values, at most three letters; seldom over an explicit alphabet.
inline rc::Gen<Tuple> any_tuple() {
    return rc::gen::apply(
        [](std::vector<Domain> values, bool disjoint, int over) {
            Tuple tuple{std::move(values), disjoint};
            tuple.letters = 3;
            if (over == 0) tuple.over = 2;
            return tuple;
        },
        rc::gen::mapcat(rc::gen::inRange<std::size_t>(1, 4),
                        [](std::size_t count) {
                            return rc::gen::container<std::vector<Domain>>(count, any_domain());
                        }),
        rc::gen::arbitrary<bool>(), rc::gen::inRange(0, 4));
}

}  // namespace algae
