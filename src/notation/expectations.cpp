#include <algorithm>
#include <cstdlib>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include "growth/growth.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "rewrite/rewrite.hpp"
#include "turtle/turtle.hpp"

// Whether what a file expects of its system comes out.
//
// An expectation is text: a kind, a generation and a value. The answer is written in the same form and
// compared with it as text, where blanks do not matter, decimals are rounded to the digits that the file
// gives, and a fraction in a parameter stands for the double nearest to it. `Answers` takes the fastest route
// that there is for the system: lengths and words of D0L systems are folded, systems with context are
// derived, all that rewrites modules is developed once and goes on from the last generation asked for.
// Figures and traces of a generation are made once, as several expectations ask for the same.

namespace algae {

namespace {

std::vector<std::string> fields(const std::string& text, char separator = ' ') {
    std::vector<std::string> found;
    std::string field;
    for (const char c : text + separator) {
        if (c != separator && c != ' ' && c != '\t') {
            field += c;
        } else if (!field.empty()) {
            found.push_back(field);
            field.clear();
        }
    }
    return found;
}

/// How many digits a number is written with after its point.
int digits_after_point(const std::string& number) {
    const auto point = number.find('.');
    return point == std::string::npos ? 0 : static_cast<int>(number.size() - point - 1);
}

std::string without_blanks(const std::string& text) {
    std::string out;
    for (const char c : text)
        if (c != ' ' && c != '\t') out += c;
    return out;
}

/// Answers the questions of one file; figures of a generation are made once.
class Answers {
public:
    Answers(const Model& system, const Budget& budget)
        : system_(system),
          budget_(budget),
          d0l_(as_d0l(system)),
          ol_(as_ol(system)),
          il_(as_dil(system)),
          is_in_space_(leaves_plane(system)) {
        if (system.drawing.seeds) choices_.seed = system.drawing.seeds->first;
    }

    /// What was found, written as the expectation is.
    std::string found(const Expectation& expected) {
        const std::uint64_t n = expected.generation;
        const std::string& kind = expected.kind;
        if (kind == "length") return length_of(n);
        if (kind == "lengths") return lengths(n);
        if (kind == "word") return word(n);
        if (kind == "mean") return mean(n);
        if (is_in_space_ && kind == "segments") return std::to_string(scene_of(n).facts.segments);
        if (kind == "segments") return to_string(figure_of(n).segments());
        if (kind == "distinct") return std::to_string(trace_of(n).distinct_segments);
        if (kind == "vertices") return std::to_string(trace_of(n).vertices);
        if (is_in_space_ && kind == "end")
            return coordinates(corner(scene_of(n).end.position), expected.value);
        if (is_in_space_ && kind == "box") {
            const SpaceBox& box = scene_of(n).facts.box;
            std::vector<Coordinate> corners;
            if (!box.empty) corners = corner(box.low);
            for (const Coordinate& high : corner(box.high))
                if (!box.empty) corners.push_back(high);
            return coordinates(corners, expected.value);
        }
        if (kind == "end") return coordinates(figure_of(n).facts().end, expected.value);
        if (kind == "box") {
            const Facts& facts = figure_of(n).facts();
            std::vector<Coordinate> corners = facts.low;
            corners.insert(corners.end(), facts.high.begin(), facts.high.end());
            return coordinates(corners, expected.value);
        }
        throw Error(
            "nothing is known of '" + kind +
            "'; expected length, lengths, mean, word, segments, distinct, vertices, end or box");
    }

private:
    const Figure& figure_of(std::uint64_t n) {
        auto& known = figures_[n];
        if (!known) known = open_figure(system_, n, budget_, choices_);
        return *known;
    }
    const Trace& trace_of(std::uint64_t n) {
        const auto known = traces_.find(n);
        return known != traces_.end() ? known->second : traces_.emplace(n, traced(n)).first->second;
    }
    Trace traced(std::uint64_t n) {
        return is_in_space_ ? trace(scene_of(n), budget_) : trace(figure_of(n), budget_);
    }
    const SpaceDerivation& scene_of(std::uint64_t n) {
        const auto known = scenes_.find(n);
        return known != scenes_.end()
                   ? known->second
                   : scenes_.emplace(n, scene(system_, n, budget_, choices_)).first->second;
    }
    static std::vector<Coordinate> corner(const Vector& place) {
        return {Coordinate(place.x), Coordinate(place.y), Coordinate(place.z)};
    }
    /// Lengths and words of systems with interactions are derived.
    bool interacts() const { return !ol_ && il_; }
    /// And so are those of systems with parameters, probabilities or tables.
    bool rewrites() const { return !d0l_ && !il_ && (choices_.seed || !ol_); }
    const DerivedModules& developed(std::uint64_t n) {
        const auto known = developed_.find(n);
        if (known != developed_.end()) return known->second;
        if (leaves_tables_open(system_) && !choices_.seed)
            throw Error("it has tables, and no schedule says and no seed picks one for each step");
        return developed_.emplace(n, open_modules(system_, n, choices_, nullptr, budget_))
            .first->second;
    }
    bool divides() const { return class_of(system_).shape; }
    std::string mean(std::uint64_t n) {
        const View<S0L> stochastic = as_s0l(system_);
        Rational sum;
        for (const Rational& count : expected_counts(*stochastic, n, budget_)) sum += count;
        return to_string(sum);
    }
    Word symbols(std::uint64_t n) {
        const View<ShapeSystem> shapes = as_shape(system_);
        return symbols_of(boxes_after(*shapes, shapes->axiom, n, budget_));
    }
    std::string length_of(std::uint64_t n) {
        if (divides()) return std::to_string(symbols(n).size());
        if (interacts()) return std::to_string(derived_lengths(*il_, n, budget_).back());
        if (rewrites()) return std::to_string(developed(n).word.kinds.size());
        return to_string(length(*d0l_, n, budget_));
    }
    std::string word(std::uint64_t n) {
        if (divides()) return spell(system_.alphabet, symbols(n));
        if (interacts()) return spell(system_.alphabet, derive(*il_, n, budget_));
        if (rewrites()) {
            const DerivedModules& derived = developed(n);
            return ModuleText(system_.alphabet, derived.kinds).text(derived.word);
        }
        const std::string text = derived_text(*d0l_, n, budget_);
        return text.empty() ? "ε" : text;
    }
    std::string lengths(std::uint64_t n) {
        std::set<std::size_t> sizes;
        for (const Word& word : words_of_generation(*ol_, n, std::nullopt, budget_))
            sizes.insert(word.size());
        return joined(sizes, ",", [](std::size_t size) { return std::to_string(size); });
    }
    static std::string coordinates(const std::vector<Coordinate>& found,
                                   const std::string& expected) {
        const auto wanted = fields(expected);
        std::string text;
        for (std::size_t i = 0; i < found.size(); ++i) {
            const int digits = i < wanted.size() ? digits_after_point(wanted[i]) : 6;
            text += (i == 0 ? "" : " ") + found[i].decimal(digits);
        }
        return text.empty() ? "nothing drawn" : text;
    }

    const Model& system_;
    const Budget& budget_;
    View<D0L> d0l_;
    View<OL> ol_;
    View<IL> il_;
    bool is_in_space_;
    FigureChoices choices_;
    std::map<std::uint64_t, DerivedModules> developed_;
    std::map<std::uint64_t, std::unique_ptr<Figure>> figures_;
    std::map<std::uint64_t, SpaceDerivation> scenes_;
    std::map<std::uint64_t, Trace> traces_;
};

/// A number as a file may write it: a decimal or a fraction of two.
std::optional<double> number(const std::string& text) {
    const std::size_t slash = text.find('/');
    const auto part = [](const std::string& digits) -> std::optional<double> {
        char* end = nullptr;
        const double value = std::strtod(digits.c_str(), &end);
        if (digits.empty() || *end != '\0') return std::nullopt;
        return value;
    };
    if (slash == std::string::npos) return part(text);
    const auto over = part(text.substr(0, slash)), under = part(text.substr(slash + 1));
    if (!over || !under || *under == 0) return std::nullopt;
    return *over / *under;
}

/// Whether a parameter is the one expected: a fraction exactly, a decimal rounded to its digits.
bool same_parameter(const std::string& expected, const std::string& found) {
    if (expected == found) return true;
    const auto wanted = number(expected), is = number(found);
    if (!wanted || !is) return false;
    const int digits = digits_after_point(expected);
    return digits > 0 ? Coordinate(*is).decimal(digits) == expected : *wanted == *is;
}

/// The letters of a word with its brackets, and between them the parameters, alternating.
std::vector<std::string> parts_of_word(const std::string& text) {
    std::vector<std::string> parts(1);
    bool inside = false;
    for (const char c : text) {
        const bool closes = inside && (c == ',' || c == ')');
        if (closes) parts.emplace_back();
        parts.back() += c;
        if (c == '(') inside = true;
        if (c == ')') inside = false;
        if (c == '(' || (closes && c == ',')) parts.emplace_back();
    }
    return parts;
}

bool same_word(const std::string& expected, const std::string& found) {
    const auto wanted = parts_of_word(expected), is = parts_of_word(found);
    return std::equal(wanted.begin(), wanted.end(), is.begin(), is.end(), same_parameter);
}

/// Whether two values say the same: white space between words and numbers does not matter.
bool same(const Expectation& expected, const std::string& found) {
    if (expected.kind == "word")
        return same_word(without_blanks(expected.value), without_blanks(found));
    if (expected.kind == "lengths") return without_blanks(expected.value) == without_blanks(found);
    return fields(expected.value) == fields(found);
}

}  // namespace

std::vector<Mismatch> unmet_expectations(const Model& system, const Budget& budget) {
    std::vector<Mismatch> unmet;
    Answers answers(system, budget);
    for (const Expectation& expected : system.expectations) {
        const std::string wanted = "expected " + expected.kind + ' ' +
                                   std::to_string(expected.generation) + ": " + expected.value;
        try {
            const std::string found = answers.found(expected);
            if (!same(expected, found))
                unmet.push_back({expected.place, wanted + ", found " + found});
        } catch (const Error& error) {
            unmet.push_back({expected.place, wanted + ", found no answer: " + error.what()});
        }
    }
    return unmet;
}

}  // namespace algae
