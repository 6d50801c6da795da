#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "verify/detail/checking.hpp"
#include "verify/verify.hpp"

// First-order statements about infinite words, and sums of numbers of places in them, as certificates have them and as text.

namespace algae::verify {

using Kind = Formula::Kind;

bool is_name(std::string_view text) {
    const auto starts = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
    };
    return !text.empty() && starts(text[0]) && std::all_of(text.begin(), text.end(), [&](char c) {
        return starts(c) || (c >= '0' && c <= '9') || c == '\'';
    });
}

const std::string& name_in(const Field& field) {
    if (!is_name(field.text()))
        field.fail("expected a name: a letter or _, then letters, digits, _ and '");
    return field.text();
}

namespace {

LinearSum read_sum(const Field& field, const std::set<std::string>& known, bool is_position) {
    field.only({"of", "plus"});
    LinearSum read;
    for (const auto& [name, times] : field.at("of").object()) {
        if (!known.contains(name)) times.fail("no quantifier binds " + name);
        read.of[name] = times.integer(!is_position);
        if (read.of[name].is_zero()) times.fail("expected another number than 0");
    }
    read.plus = field.at("plus").integer(!is_position);
    return read;
}

/// `bound` has the names of all quantifiers so far, `known` those of the quantifiers around.
Formula read_formula(const Field& field, std::set<std::string>& bound,
                     const std::set<std::string>& known) {
    Formula read;
    const auto terms = [&](const Field& from, std::size_t count) {
        const auto list = from.list();
        if (list.size() != count) from.fail("expected " + std::to_string(count) + " terms");
        for (const Field& one : list) read.terms.push_back(read_sum(one, known, true));
    };
    const auto parts = [&](const Field& from) {
        for (const Field& one : from.list()) read.parts.push_back(read_formula(one, bound, known));
        if (read.parts.empty()) from.fail("expected a statement");
    };
    struct Form {
        const char* key;
        Kind kind;
        const char* other = nullptr;
    };
    static constexpr Form forms[] = {{"equation", Kind::equation},
                                     {"less", Kind::less},
                                     {"same letter", Kind::same_letter},
                                     {"letter", Kind::letter, "at"},
                                     {"equal", Kind::equal},
                                     {"palindrome", Kind::palindrome},
                                     {"not", Kind::negation},
                                     {"and", Kind::conjunction},
                                     {"or", Kind::disjunction},
                                     {"implies", Kind::implication},
                                     {"iff", Kind::equivalence},
                                     {"exists", Kind::exists, "holds"},
                                     {"for all", Kind::for_all, "holds"}};
    const auto form = std::find_if(std::begin(forms), std::end(forms),
                                   [&](const Form& one) { return field.has(one.key); });
    if (form == std::end(forms)) field.fail("expected a first-order statement");
    if (form->other)
        field.only({form->key, form->other});
    else
        field.only({form->key});
    read.kind = form->kind;
    const Field value = field.at(form->key);
    switch (read.kind) {
        case Kind::equation:
        case Kind::less:
            read.terms = {read_sum(value, known, false)};
            break;
        case Kind::same_letter:
        case Kind::palindrome:
            terms(value, 2);
            break;
        case Kind::equal:
            terms(value, 3);
            break;
        case Kind::letter:
            read.letter = letter_name(value);
            read.terms = {read_sum(field.at("at"), known, true)};
            break;
        case Kind::negation:
            read.parts = {read_formula(value, bound, known)};
            break;
        case Kind::implication:
            parts(value);
            if (read.parts.size() != 2) value.fail("expected two statements");
            break;
        case Kind::conjunction:
        case Kind::disjunction:
        case Kind::equivalence:
            parts(value);
            break;
        case Kind::exists:
        case Kind::for_all: {
            std::set<std::string> inner = known;
            for (const Field& name : value.list()) {
                if (!bound.insert(name_in(name)).second)
                    name.fail("expected another name, as this one is bound already");
                inner.insert(name.text());
                read.names.push_back(name.text());
            }
            if (read.names.empty()) value.fail("expected a name");
            read.parts = {read_formula(field.at("holds"), bound, inner)};
            break;
        }
    }
    return read;
}

std::string sum_text(const LinearSum& sum, const Integer& sign) {
    std::string text;
    const auto add = [&](const Integer& times, const std::string& name) {
        if (times * sign <= 0) return;
        const Integer size = times * sign;
        text += text.empty() ? "" : " + ";
        text += name.empty() ? to_string(size) : size == 1 ? name : to_string(size) + name;
    };
    for (const auto& [name, times] : sum.of) add(times, name);
    add(sum.plus, "");
    return text.empty() ? "0" : text;
}

std::string formula_text(const Formula& formula, const std::string& word) {
    const auto listed = [](const auto& all, const std::string& between, const auto& text) {
        std::string found;
        for (const auto& one : all) found += (found.empty() ? "" : between) + text(one);
        return found;
    };
    const auto parts = [&](const std::string& between) {
        return "(" +
               listed(formula.parts, " " + between + " ",
                      [&](const Formula& one) { return formula_text(one, word); }) +
               ")";
    };
    const auto at = [&](std::size_t i) { return word + "[" + sum_text(formula.terms[i], 1) + "]"; };
    const auto compared = [&](const std::string& sign) {
        return sum_text(formula.terms[0], 1) + sign + sum_text(formula.terms[0], -1);
    };
    const auto called = [&](const std::string& name) {
        return name + "(" +
               listed(formula.terms, ", ", [](const LinearSum& one) { return sum_text(one, 1); }) +
               ")";
    };
    const auto bound = [&](const std::string& words) {
        return words + " " +
               listed(formula.names, ", ", [](const std::string& one) { return one; }) + ": " +
               formula_text(formula.parts[0], word);
    };
    switch (formula.kind) {
        case Kind::equation:
            return compared(" = ");
        case Kind::less:
            return compared(" < ");
        case Kind::same_letter:
            return at(0) + " = " + at(1);
        case Kind::letter:
            return at(0) + " = '" + formula.letter + "'";
        case Kind::equal:
            return called("equal");
        case Kind::palindrome:
            return called("palindrome");
        case Kind::negation:
            return "not (" + formula_text(formula.parts[0], word) + ")";
        case Kind::conjunction:
            return parts("and");
        case Kind::disjunction:
            return parts("or");
        case Kind::implication:
            return parts("implies");
        case Kind::equivalence:
            return parts("iff");
        case Kind::exists:
            return bound("for some");
        case Kind::for_all:
            break;
    }
    return bound("for all");
}

}  // namespace

Formula read_formula(const Field& field) {
    std::set<std::string> bound;
    return read_formula(field, bound, {});
}

CountedPlaces read_counts(const Field& field) {
    CountedPlaces read;
    for (const Field& one : field.at("counts").list()) {
        one.only({"times", "places"});
        const std::set<std::string> free{"i", "n"};
        std::set<std::string> bound = free;
        Formula places = read_formula(one.at("places"), bound, free);
        read.parts.push_back({one.at("times").integer(true), std::move(places)});
    }
    read.slope = field.at("n").integer(true);
    read.plus = field.at("plus").integer(true);
    read.from = field.at("from").integer();
    return read;
}

std::string formula_text(const Statement& statement, const Alphabet& alphabet) {
    const std::string word = system_name(statement.systems[0].name);
    std::string coded, says;
    for (const auto& [a, name] : statement.coding)
        coded +=
            (coded.empty() ? "" : ", ") + letter_text(alphabet.name(a)) + " written as " + name;
    if (statement.counted) {
        const auto& [parts, slope, plus, from] = *statement.counted;
        const auto add = [&](const Integer& times, const std::string& of) {
            if (times.is_zero()) return;
            const Integer size = times < 0 ? -times : times;
            says += times < 0 ? " - " : says.empty() ? "" : " + ";
            says += of.empty() ? to_string(size) : size == 1 ? of : to_string(size) + " " + of;
        };
        for (const auto& [times, places] : parts)
            add(times, "#{i : " + formula_text(places, word) + "}");
        add(slope, "n");
        add(plus, "");
        says = "for all n >= " + to_string(from) + ": " + (says.empty() ? "0" : says) + " = 0";
    } else {
        says = formula_text(*statement.first_order, word);
    }
    return "of the infinite word " + word + (coded.empty() ? "" : ", " + coded) + ": " + says;
}

}  // namespace algae::verify
