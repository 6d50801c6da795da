#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <new>
#include <string>
#include <utility>

#include "exact/exact.hpp"
#include "rewrite/detail/inner_systems.hpp"
#include "rewrite/rewrite.hpp"

// Words of modules in memory and as text, and words as values of parameters.
//
// A word is a row of kinds and a row of numbers. A parameter that is a word holds the number of an entry in a list that is kept once
// for a derivation. Systems within a system give such values: generation n of NAME is derived once, after all generations
// before it, so a word may use earlier words of its own system, and a circle is an error that is told with its members.

namespace algae {

ModuleKind ModuleKinds::kind(Symbol letter, std::size_t arity) {
    const auto [found, fresh] =
        numbers_.emplace(std::pair(letter, arity), ModuleKind(letters_.size()));
    if (!fresh) return found->second;
    constexpr std::size_t most = 65'535;
    if (letters_.size() == most)
        throw BoundReached(Bound::method,
                           "the system has more than 65535 letters, each with its number of "
                           "parameters, as many as a derivation can tell apart");
    letters_.push_back(letter);
    arities_.push_back(static_cast<std::uint32_t>(arity));
    return found->second;
}

void* word_memory(std::size_t bytes) {
    constexpr std::size_t page = std::size_t{1} << 21, many = 4 * page;
    void* const memory = bytes < many ? std::malloc(bytes)
                                      : std::aligned_alloc(page, (bytes + page - 1) / page * page);
    if (!memory) throw std::bad_alloc();
#ifdef __linux__
    if (bytes >= many)
        madvise(memory, (bytes + page - 1) / page * page, MADV_HUGEPAGE);  // only advice
#endif
    return memory;
}

void free_word_memory(void* memory) { std::free(memory); }

Word letters(const ModuleKinds& kinds, const ModuleString& word) {
    Word out;
    out.reserve(word.kinds.size());
    for (const ModuleKind kind : word.kinds) out.push_back(kinds.letter(kind));
    return out;
}

namespace {

void add_number(std::string& out, double value) {
    constexpr double most = 1e21;
    if (value == 0) {
        out += '0';
    } else if (std::abs(value) < 9007199254740992.0 && value == std::trunc(value)) {
        std::array<char, 20> digits;
        char* const begin = digits.data();
        out.append(begin,
                   std::to_chars(begin, begin + digits.size(), static_cast<long long>(value)).ptr);
    } else if (std::abs(value) < most && value == std::trunc(value)) {
        out += rounded_decimal(value, 21);  // all of its digits
    } else {
        const std::string text = shortest_decimal(value);
        const std::size_t exponent = text.find('e');
        out.append(text, 0, exponent);
        if (exponent == std::string::npos) return;
        out += text[exponent + 1] == '-' ? "e-" : "e";  // 1e-07 is 1e-7, and 1e+21 is 1e21
        out.append(text, text.find_first_not_of('0', exponent + 2));
    }
}

}  // namespace

std::string number_text(double value) {
    std::string out;
    add_number(out, value);
    return out;
}

void ModuleText::add(std::string& out, ModuleKind kind, const double* values) const {
    out += alphabet_.name(kinds_.letter(kind));
    const std::uint32_t arity = kinds_.arity(kind);
    for (std::uint32_t i = 0; i < arity; ++i) {
        out += i == 0 ? '(' : ',';
        const WordValues* const held = kinds_.words();
        if (!WordValues::is_word(values[i])) {
            if (held)
                out += held->text(values[i]);
            else
                add_number(out, values[i]);
            continue;
        }
        const ModuleString& word = held->word(values[i]);
        const double* within = word.values.data();
        out += '"';
        add(out, word, 0, word.kinds.size(), within);
        out += '"';
    }
    if (arity > 0) out += ')';
}

void ModuleText::add(std::string& out, const ModuleString& word, std::size_t from, std::size_t to,
                     const double*& values) const {
    for (std::size_t i = from; i < to; ++i) {
        const ModuleKind kind = word.kinds[i];
        if (i > 0 && kinds_.arity(word.kinds[i - 1]) == 0 &&
            spellings_.blank_between(kinds_.letter(word.kinds[i - 1]), kinds_.letter(kind)))
            out += ' ';
        add(out, kind, values);
        values += kinds_.arity(kind);
    }
}

bool ModuleText::write(const ModuleString& word, TextSink& sink, const Budget& budget) const {
    constexpr std::size_t part = 4096;
    const double* values = word.values.data();
    std::string out;
    for (std::size_t from = 0; from < word.kinds.size(); from += part) {
        budget.check();
        out.clear();
        add(out, word, from, std::min(from + part, word.kinds.size()), values);
        sink.write(out);
        sink.flush();
    }
    return !word.kinds.empty();
}

std::string ModuleText::text(const ModuleString& word) const {
    if (word.kinds.empty()) return "ε";
    std::string out;
    const double* values = word.values.data();
    add(out, word, 0, word.kinds.size(), values);
    return out;
}

std::string ModuleText::text(ModuleKind kind, const double* values) const {
    std::string out;
    add(out, kind, values);
    return out;
}

namespace {

constexpr std::uint64_t quiet = 0x7FF8'0000'0000'0000;  // the bits of a number that is none
constexpr std::uint64_t place_bits = 0x0003'FFFF'FFFF'FFFF;

std::uint64_t mixed(std::uint64_t hash, std::uint64_t next) {
    hash = (hash ^ next) * 0x9E37'79B9'7F4A'7C15;
    return hash ^ (hash >> 29);
}

std::uint64_t hash_of(const ModuleString& word) {
    std::uint64_t hash = word.kinds.size();
    for (const ModuleKind kind : word.kinds) hash = mixed(hash, kind);
    for (const double value : word.values)  // 0 and -0 are equal
        hash = mixed(hash, bits_of(value == 0 ? 0.0 : value));
    return hash;
}

}  // namespace

const WordValues::Held& WordValues::held(double value) const {
    return all_.at(static_cast<std::size_t>(bits_of(value) & place_bits) - 1);
}

double WordValues::value(ModuleString word, const Budget& budget) {
    const auto value_at = [](std::size_t place) {
        const std::uint64_t bits = quiet | (place + 1);
        double value;
        std::memcpy(&value, &bits, sizeof value);
        return value;
    };
    const std::uint64_t hash = hash_of(word);
    const auto [first, last] = places_.equal_range(hash);
    for (auto known = first; known != last; ++known)
        if (all_[known->second].word == word) return value_at(known->second);

    Held next{std::move(word), 0, 1};
    next.modules = next.word.kinds.size();
    for (const double value : next.word.values) {
        if (!is_word(value)) continue;
        const Held& within = held(value);
        next.modules += within.modules;  // far below 2^64: each is at most the bound
        next.depth = std::max(next.depth, within.depth + 1);
        if (next.modules > budget.letters) break;
    }
    constexpr std::size_t deepest = 100;
    if (next.depth > deepest)
        throw BoundReached(Bound::method, "words stand in words as parameters more than " +
                                              std::to_string(deepest) + " deep");
    if (next.modules > budget.letters)
        throw BoundReached(Bound::letters,
                           "a word that is a parameter has more than " +
                               std::to_string(budget.letters) +
                               " letters with those of its own parameters, the bound set" +
                               budget.by(Bound::letters));
    bytes_ += sizeof(Held) + next.word.kinds.size() * sizeof(ModuleKind) +
              next.word.values.size() * sizeof(double);
    budget.check_memory(bytes_, "the words that are parameters");
    places_.emplace(hash, all_.size());
    all_.push_back(std::move(next));
    return value_at(all_.size() - 1);
}

struct InnerSystems::Step {
    Step(InnerSystems& systems, std::size_t system, std::size_t generation) : all(systems) {
        all.steps_.emplace_back(system, generation);
    }
    ~Step() { all.steps_.pop_back(); }
    Step(const Step&) = delete;
    Step& operator=(const Step&) = delete;

    InnerSystems& all;
};

std::optional<std::size_t> InnerSystems::find(const std::string& name) const {
    const auto found = std::find(names_.begin(), names_.end(), name);
    if (found == names_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - names_.begin());
}

void InnerSystems::add(Rewriting rewriting, Successor axiom) {
    rewritings_.push_back(std::move(rewriting));
    axioms_.push_back(std::move(axiom));
}

std::string InnerSystems::circle(std::size_t system, std::size_t generation) const {
    const auto first = std::find_if(steps_.begin(), steps_.end(),
                                    [&](const auto& step) { return step.first == system; });
    std::string text = "words need each other in a circle: " + name(first->first, first->second);
    for (auto step = std::next(first); step != steps_.end(); ++step)
        text += " needs " + name(step->first, step->second) + ", which";
    text += " needs " + name(system, generation);
    if (generation != first->second) text += ", which needs " + name(first->first, first->second);
    return text;
}

void InnerSystems::derive_next(std::size_t system) {
    auto& known = known_[system];
    const std::size_t generation = known.size();
    const Step step(*this, system, generation);
    ModuleString word;
    if (generation > 0) {
        word = rewritings_[system].next(words_->word(known.back()), generation - 1, 0, budget_);
    } else {
        try {
            append(axioms_[system], nullptr, words_.get(), word);
        } catch (const Undefined& undefined) {
            const std::string text = to_string(undefined.at->place) + ": the axiom of " +
                                     names_[system] + ": " + undefined.reason;
            if (undefined.is_undecided) throw UndecidedValue(text);
            throw Error(text);
        }
    }
    known.push_back(value(std::move(word)));
    budget_.check_memory(known.size() * sizeof(double), "the generations of a system within");
}

double InnerSystems::word(std::size_t system, double generation, const Expression& at) {
    if (generation < 0 || generation != std::floor(generation) || generation > 1e15)
        throw Undefined{&at, "expected a generation from 0 on in '" + to_text(at) + "', found " +
                                 words_->text(generation)};
    const auto wanted = static_cast<std::size_t>(generation);
    auto& known = known_[system];
    const bool is_busy = std::any_of(steps_.begin(), steps_.end(),
                                     [&](const auto& step) { return step.first == system; });
    if (wanted >= known.size() && is_busy) throw Undefined{&at, circle(system, wanted)};
    while (wanted >= known.size()) {
        budget_.check();
        derive_next(system);
        // A word that is its own successor stays.
        const std::size_t last = known.size() - 1;
        if (last > 0 && same_value(known[last], known[last - 1])) return known[last];
    }
    return known[wanted];
}

}  // namespace algae
