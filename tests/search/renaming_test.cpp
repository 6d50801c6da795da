#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "search/compared.hpp"

using namespace algae;

namespace {

/// All classes of labelled tuples, each by its least text; without renaming, all tuples.
std::set<std::string> classes(const Tuple& tuple, std::uint64_t size) {
    const auto letters = static_cast<std::size_t>(tuple.over ? *tuple.over : *tuple.letters);
    std::set<std::string> found;
    for (const auto& one : oracle::labelled_tuples(labelled(tuple), size, letters, tuple.disjoint))
        found.insert(tuple.over ? oracle::written(one) : oracle::least_renamed(one, letters));
    return found;
}

/// The same from the instances that are visited; nothing if one comes twice.
std::optional<std::set<std::string>> visited(const Tuple& tuple, std::uint64_t size) {
    const auto letters = static_cast<std::size_t>(tuple.over ? *tuple.over : *tuple.letters);
    std::set<std::string> found;
    const bool is_once = visit(tuple, size, [&](const Instance& instance) {
        if (instance.size() != size) return false;
        const oracle::LabelledTuple one = labelled(instance);
        return found.insert(tuple.over ? oracle::written(one) : oracle::least_renamed(one, letters))
            .second;
    });
    if (!is_once) return std::nullopt;
    return found;
}

// What follows writes the order down once more, from what the face says about it.

using Key = std::vector<std::uint64_t>;

void add_piece(Key& key, std::vector<Word> words) {
    std::sort(words.begin(), words.end(), shortlex_less);
    for (const Word& word : words) {
        key.push_back(word.size() + 1);
        key.insert(key.end(), word.begin(), word.end());
    }
    key.push_back(0);
}

std::vector<Word> replaced_all(std::vector<Word> words, const std::vector<Symbol>& to) {
    for (Word& word : words) word = replaced(std::move(word), to);
    return words;
}

Key system_key(const ET0L& system, const std::vector<std::size_t>& order,
               const std::vector<Symbol>& to, Word& occurred) {
    Key key{system.tables.size()};
    std::vector<Symbol> back(to.size());
    for (Symbol a = 0; a < to.size(); ++a) back[to[a]] = a;
    Word own;
    const auto see = [&](std::vector<Word> words) {
        std::sort(words.begin(), words.end(), shortlex_less);
        for (const Word& word : words)
            for (const Symbol a : word)
                for (Word* letters : {&own, &occurred})
                    if (std::find(letters->begin(), letters->end(), a) == letters->end())
                        letters->push_back(a);
    };
    const auto add = [&](const std::vector<Word>& words) {
        see(replaced_all(words, to));
        add_piece(key, replaced_all(words, to));
    };
    add({system.axiom});
    for (std::size_t i = 0; i < own.size(); ++i)
        for (const std::size_t t : order) add(system.tables[t][back[own[i]]]);
    return key;
}

/// The texts of all values after a renaming; of systems with tables for the least order of them.
Key key_of(const Instance& instance, const std::vector<Symbol>& to) {
    Key key;
    Word occurred;  // letters, renamed, in order of first occurrence
    std::vector<Symbol> back(to.size());
    for (Symbol a = 0; a < to.size(); ++a) back[to[a]] = a;
    const auto add = [&](std::vector<Word> words) {
        words = replaced_all(std::move(words), to);
        std::sort(words.begin(), words.end(), shortlex_less);
        for (const Word& word : words)
            for (const Symbol a : word)
                if (std::find(occurred.begin(), occurred.end(), a) == occurred.end())
                    occurred.push_back(a);
        add_piece(key, words);
    };
    for (std::size_t v = 0; v < instance.values(); ++v) switch (instance.kind(v)) {
            case Domain::Kind::language:
                add(instance.language(v));
                break;
            case Domain::Kind::system: {
                const ET0L system = instance.et0l(v);
                std::vector<std::size_t> order(system.tables.size());
                std::iota(order.begin(), order.end(), std::size_t{0});
                Key least;
                Word then;
                do {
                    Word letters = occurred;
                    Key next = system_key(system, order, to, letters);
                    if (least.empty() || next < least) {
                        least = std::move(next);
                        then = std::move(letters);
                    }
                } while (std::next_permutation(order.begin(), order.end()));
                key.insert(key.end(), least.begin(), least.end());
                occurred = std::move(then);
                break;
            }
            case Domain::Kind::word:
                add({instance.word(v)});
                break;
            case Domain::Kind::letter:
                add({{instance.letter(v)}});
                break;
            case Domain::Kind::morphism: {
                const Morphism morphism = instance.morphism(v);
                const Word domain = occurred;
                for (const Symbol a : domain) add({morphism[back[a]]});
                break;
            }
            case Domain::Kind::substitution: {
                const auto images = instance.substitution(v);
                const Word domain = occurred;
                for (const Symbol a : domain)
                    for (const auto& [letter, words] : images)
                        if (letter == back[a]) add(words);
                break;
            }
            case Domain::Kind::inverse_morphism:
                add(instance.morphism(v).images());
                break;
            case Domain::Kind::number:
                key.push_back(instance.number(v));
                break;
        }
    return key;
}

}  // namespace

TEST_CASE("each tuple up to renaming comes once, against all labelled tuples") {
    std::size_t instances = 0, tuples = 0;
    CHECK(rc::check([&] {
        const Tuple tuple = *rc::gen::resize(rc::kNominalSize, any_tuple());
        for (std::uint64_t size = 0; size <= 5; ++size) {
            const auto found = visited(tuple, size);
            RC_ASSERT(found.has_value());
            RC_ASSERT(*found == classes(tuple, size));
            instances += found->size();
        }
        ++tuples;
    }));
    MESSAGE(instances << " instances of " << tuples << " tuples compared");
    CHECK(instances > 200);
}

TEST_CASE("larger pairs up to renaming, against all labelled ones") {
    const Domain language{}, system{.kind = Domain::Kind::system};
    const Domain tables{.kind = Domain::Kind::system, .tables = true};
    const Domain inverse{.kind = Domain::Kind::inverse_morphism};
    const Domain coding{.kind = Domain::Kind::morphism, .letter_to_letter = true};
    const Domain substitution{.kind = Domain::Kind::substitution};
    const auto check = [](std::vector<Domain> values, std::uint64_t size, std::uint64_t letters,
                          bool disjoint = false) {
        CAPTURE(size);
        const Tuple tuple{std::move(values), disjoint, letters};
        const auto found = visited(tuple, size);
        REQUIRE(found);
        CHECK(found->size() > 5);
        CHECK(*found == classes(tuple, size));
    };
    check({language}, 8, 4);
    check({language, language}, 6, 4);
    check({language, language}, 7, 3, true);
    check({system}, 7, 3);
    check({tables}, 6, 3);
    check({system, system}, 6, 3);
    check({language, inverse}, 6, 3);
    check({language, coding}, 7, 3);
    check({language, substitution}, 6, 3);
    check({system, coding}, 6, 3);
}

TEST_CASE("instances come in the order of the face, each the least of its renamings") {
    std::size_t instances = 0;
    CHECK(rc::check([&] {
        const Tuple tuple = *rc::gen::resize(rc::kNominalSize, any_tuple());
        const std::uint64_t size =
            *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::uint64_t>(2, 9));
        std::optional<std::pair<std::size_t, Key>> last;
        visit(tuple, size,
              [&](const Instance& instance) {
                  std::vector<Symbol> to(instance.letters());
                  std::iota(to.begin(), to.end(), Symbol{0});
                  const std::pair now(instance.letters(), key_of(instance, to));
                  if (last) RC_ASSERT(*last < now);
                  last = now;
                  while (!tuple.over && std::next_permutation(to.begin(), to.end()))
                      RC_ASSERT(!(key_of(instance, to) < now.second));
                  ++instances;
                  return true;
              },
              {}, {0, 300});
    }));
    MESSAGE(instances << " instances compared");
    CHECK(instances > 200);
}

TEST_CASE("texts") {
    const auto texts = [](const Tuple& tuple, std::uint64_t size) {
        std::vector<std::string> found;
        visit(tuple, size, [&](const Instance& instance) {
            found.push_back(instance.text());
            return true;
        });
        return found;
    };
    using Texts = std::vector<std::string>;
    const Domain language{}, system{.kind = Domain::Kind::system};
    CHECK(texts({{language}}, 0) == Texts{"{}"});
    CHECK(texts({{language}}, 3) == Texts{"ε,a", "aa", "ab"});
    CHECK(texts({{system}}, 4) == Texts{"a#ε,a", "a#aa", "aa#a", "aaa#ε", "a#b#ε", "ab#ε#ε"});
    CHECK(texts({{Domain{.kind = Domain::Kind::system, .tables = true}}}, 4).at(4) == "2:a#ε#a");
    CHECK(texts({{language, Domain{.kind = Domain::Kind::morphism, .letter_to_letter = true}}},
                4) == Texts{"a; a", "a; b"});
    CHECK(texts({{language, Domain{.kind = Domain::Kind::inverse_morphism}}}, 3) ==
          Texts{"{}; ε,ε,ε", "ε; ε,ε", "a; ε"});
    CHECK(texts({.values = {language}, .over = 2}, 2) == Texts{"a", "b"});
    const Texts apart = texts({.values = {language, language}, .disjoint = true}, 4);
    CHECK(std::count(apart.begin(), apart.end(), "a; b") == 1);
    CHECK(std::count(apart.begin(), apart.end(), "a; a") == 0);
}
