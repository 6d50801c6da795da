#include "expect/expectations.hpp"

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <sstream>

#include "fold/choices.hpp"
#include "fold/derive.hpp"
#include "fold/interaction.hpp"
#include "growth/incidence.hpp"
#include "shape/boxes.hpp"
#include "system/classes.hpp"
#include "turtle/figure.hpp"
#include "turtle/trace.hpp"

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
    Answers(const LSystem& system, const Budget& budget)
        : system_(system), budget_(budget), d0l_(as_d0l(system)), ol_(as_ol(system)), il_(as_il(system)) {}

    /// What was found, written as the expectation is.
    std::string found(const Expectation& expected) {
        const std::uint64_t n = expected.generation;
        const std::string& kind = expected.kind;
        if (kind == "length") return length_of(n);
        if (kind == "lengths") return lengths(n);
        if (kind == "word") return word(n);
        if (kind == "segments") return to_string(figure_of(n).segments());
        if (kind == "distinct") return std::to_string(trace_of(n).distinct_segments);
        if (kind == "vertices") return std::to_string(trace_of(n).vertices);
        if (kind == "end") return coordinates(figure_of(n).facts().end, expected.value);
        if (kind == "box") {
            const Facts& facts = figure_of(n).facts();
            std::vector<Coordinate> corners = facts.low;
            corners.insert(corners.end(), facts.high.begin(), facts.high.end());
            return coordinates(corners, expected.value);
        }
        throw Error("nothing is known of '" + kind +
                    "'; expected length, lengths, word, segments, distinct, vertices, end or box");
    }

private:
    const Figure& figure_of(std::uint64_t n) {
        auto& known = figures_[n];
        if (!known) known = figure(system_, n, budget_);
        return *known;
    }
    const Trace& trace_of(std::uint64_t n) {
        const auto known = traces_.find(n);
        return known != traces_.end() ? known->second
                                      : traces_.emplace(n, trace(figure_of(n), budget_)).first->second;
    }
    /// Lengths and words of systems with interactions are derived.
    bool interacts() const { return !ol_ && il_; }
    bool divides() const { return class_of(system_).shape; }
    Word symbols(std::uint64_t n) {
        const View<ShapeSystem> shapes = as_shape(system_);
        return symbols_of(boxes_after(*shapes, shapes->axiom, n, budget_));
    }
    std::string length_of(std::uint64_t n) {
        if (divides()) return std::to_string(symbols(n).size());
        if (interacts()) return std::to_string(derived_lengths(*il_, n, budget_).back());
        return to_string(length(*d0l_, n, budget_));
    }
    std::string word(std::uint64_t n) {
        if (divides()) return spell(system_.alphabet, symbols(n));
        if (interacts()) return spell(system_.alphabet, derive(*il_, n, budget_));
        const std::string text = derived_text(*d0l_, n, budget_);
        return text.empty() ? "ε" : text;
    }
    std::string lengths(std::uint64_t n) {
        std::set<std::size_t> sizes;
        for (const Word& word : words_of_generation(*ol_, n, std::nullopt, budget_))
            sizes.insert(word.size());
        std::string text;
        for (const std::size_t size : sizes) text += (text.empty() ? "" : ",") + std::to_string(size);
        return text;
    }
    static std::string coordinates(const std::vector<Coordinate>& found, const std::string& expected) {
        const auto wanted = fields(expected);
        std::string text;
        for (std::size_t i = 0; i < found.size(); ++i) {
            const int digits = i < wanted.size() ? digits_after_point(wanted[i]) : 6;
            text += (i == 0 ? "" : " ") + found[i].decimal(digits);
        }
        return text.empty() ? "nothing drawn" : text;
    }

    const LSystem& system_;
    const Budget& budget_;
    View<D0L> d0l_;
    View<OL> ol_;
    View<IL> il_;
    std::map<std::uint64_t, std::unique_ptr<Figure>> figures_;
    std::map<std::uint64_t, Trace> traces_;
};

/// Whether two values say the same: white space between words and numbers does not matter.
bool same(const Expectation& expected, const std::string& found) {
    if (expected.kind == "word" || expected.kind == "lengths")
        return without_blanks(expected.value) == without_blanks(found);
    return fields(expected.value) == fields(found);
}

}  // namespace

std::vector<Disappointment> unmet_expectations(const LSystem& system, const Budget& budget) {
    std::vector<Disappointment> unmet;
    Answers answers(system, budget);
    for (const Expectation& expected : system.expectations) {
        const std::string wanted = "expected " + expected.kind + ' ' + std::to_string(expected.generation) +
                                   ": " + expected.value;
        try {
            const std::string found = answers.found(expected);
            if (!same(expected, found)) unmet.push_back({expected.place, wanted + ", found " + found});
        } catch (const BoundReached&) {
            throw;
        } catch (const Interrupted&) {
            throw;
        } catch (const Error& error) {
            unmet.push_back({expected.place, wanted + ", found no answer: " + error.what()});
        }
    }
    return unmet;
}

}  // namespace algae
