#include "rewrite/module_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include "rewrite/word_values.hpp"

namespace algae {

namespace {

void add_number(std::string& out, double value) {
    constexpr double most = 1e21;
    std::array<char, 400> digits;
    char* const begin = digits.data();
    char* const end = begin + digits.size();
    if (value == 0) {
        out += '0';
    } else if (std::abs(value) < 9007199254740992.0 && value == std::trunc(value)) {
        out.append(begin, std::to_chars(begin, end, static_cast<long long>(value)).ptr);
    } else if (std::abs(value) < most && value == std::trunc(value)) {
        out.append(begin, std::to_chars(begin, end, value, std::chars_format::fixed).ptr);
    } else {
        char* last = std::to_chars(begin, end, value).ptr;
        // 1e-07 is 1e-7, and 1e+21 is 1e21.
        char* const exponent = std::find(begin, last, 'e');
        if (exponent == last) {
            out.append(begin, last);
            return;
        }
        out.append(begin, exponent + 1);
        char* from = exponent + 1;
        if (*from == '-') out += '-';
        ++from;
        while (from + 1 < last && *from == '0') ++from;
        out.append(from, last);
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
        if (!WordValues::is_word(values[i])) {
            add_number(out, values[i]);
            continue;
        }
        const ModuleString& word = kinds_.words()->word(values[i]);
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

}  // namespace algae
