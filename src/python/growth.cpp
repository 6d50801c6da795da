// Growth for Python: lengths and counts of letters of any generation, the analysis of a D0L system, algebraic numbers, comparisons.
//
// A rate or a share of a letter is an object that knows its minimal polynomial and as many of its digits as one asks for. A share
// p(r)/q with r a rate is given by a matrix of integers, that of the multiplication by p(r); its minimal polynomial is that
// of the number, and a denominator scales the roots.

#include "growth/growth.hpp"

#include <algorithm>

#include "notation/notation.hpp"
#include "python/detail/running.hpp"
#include "python/detail/values.hpp"
#include "report/report.hpp"

namespace algae::python {

namespace {

/// A real algebraic number.
struct Algebraic {
    Polynomial
        minimal;  // irreducible, primitive, leading coefficient positive; 0 where it is not worked out
    std::string text;
    std::function<Ball(long)> enclosure;
    std::optional<Rational> rational;
};

Algebraic algebraic(const Rate& rate) {
    Algebraic found{primitive_part(rate.minimal_polynomial()), rate.exact(), {}, {}};
    found.enclosure = [rate](long bits) { return rate.enclosure(bits); };
    if (const auto integer = rate.integer()) found.rational = *integer;
    return found;
}

/// The minimal polynomial of p(r) / below, r a root of the monic irreducible modulus.
Polynomial minimal_polynomial_of(const NumberField& field, const Polynomial& numerator,
                                 const Integer& below) {
    const auto degree = static_cast<std::size_t>(field.modulus().degree());
    IntegerMatrix times(degree, degree);
    Polynomial power = field.reduced(numerator);
    for (std::size_t i = 0; i < degree; ++i) {
        for (std::size_t j = 0; j < degree; ++j) times(i, j) = power.coefficient(j);
        power = field.reduced(power * Polynomial({0, 1}));
    }
    const Polynomial whole = minimal_polynomial(times);
    std::vector<Integer> coefficients;
    Integer factor = 1;
    for (const Integer& coefficient : whole.coefficients()) {
        coefficients.push_back(coefficient * factor);
        factor *= below;
    }
    return primitive_part(Polynomial(std::move(coefficients)));
}

Algebraic algebraic(const Frequency& share, const std::optional<Rate>& rate) {
    Algebraic found{{}, share.exact(), {}, {}};
    found.enclosure = [share](long bits) { return share.enclosure(bits); };
    if (const auto& number = share.number(); number && number->denominator.degree() == 0) {
        const Integer below = number->denominator.coefficient(0);
        if (number->numerator.degree() <= 0)
            found.rational = Rational(number->numerator.coefficient(0), below);
        if (rate)
            found.minimal = minimal_polynomial_of(NumberField(rate->minimal_polynomial()),
                                                  number->numerator, below);
    }
    return found;
}

py::list polynomial(const Polynomial& value) {
    py::list all;
    for (const Integer& coefficient : value.coefficients()) all.append(as_python(coefficient));
    return all;
}

/// What a growth analysis says, kept for the questions that are asked later.
struct GrowthObject {
    GrowthReport report;
};

py::list factors(const Factorisation& of) {
    py::list all;
    for (const auto& [factor, exponent] : of.powers)
        all.append(py::make_tuple(polynomial(factor), exponent));
    return all;
}

py::list frequencies(const GrowthObject& growth) {
    const GrowthAnalysis& a = growth.report.analysis;
    const GrowthOrder& order = a.growth.order;
    py::list all;
    for (const auto& of_residue : a.frequencies.limits) {
        py::list one;
        for (const Frequency& share : of_residue) one.append(algebraic(share, order.rate));
        all.append(std::move(one));
    }
    return all;
}

/// Python ints; signals are let in between them.
py::list ints(const std::vector<Integer>& values) {
    py::list all;
    for (const Integer& value : values) {
        let_signals_in(all.size());
        all.append(as_python(value));
    }
    return all;
}

/// Rows of exact ints, or an array of 64 bits where all of them fit.
py::object matrix(const std::vector<std::vector<Integer>>& rows, std::size_t columns) {
    const bool is_small = std::ranges::all_of(rows, [](const auto& row) {
        return std::ranges::all_of(row, [](const Integer& value) { return value.fits_int64(); });
    });
    if (is_small) {
        std::vector<std::int64_t> values;
        values.reserve(rows.size() * columns);
        for (const auto& row : rows)
            for (const Integer& value : row) values.push_back(value.to_int64());
        return as_array(std::move(values),
                        {static_cast<py::ssize_t>(rows.size()), static_cast<py::ssize_t>(columns)});
    }
    py::list all;
    for (const auto& row : rows) all.append(ints(row));
    return py::module_::import("numpy").attr("array")(all, py::arg("dtype") = "object");
}

std::vector<std::string> letters(const D0L& system) {
    std::vector<std::string> names;
    for (const Symbol letter : system.letters) names.push_back(system.alphabet->name(letter));
    return names;
}

/// The first values of a recurrence, each some of them a check of the budget.
std::vector<Integer> first_values(const Recurrence& recurrence, std::size_t count,
                                  const Budget& budget) {
    constexpr std::size_t step = 64;
    std::vector<Integer> found = recurrence.values(std::min(count, recurrence.initial.size()));
    std::uint64_t bytes = 0;
    Recurrence from;  // what goes on from the last values
    from.polynomial = recurrence.polynomial;
    while (found.size() < count) {
        budget.check();
        from.initial.assign(found.end() - static_cast<std::ptrdiff_t>(recurrence.order()),
                            found.end());
        const std::size_t more = std::min(step, count - found.size());
        std::vector<Integer> next = from.values(recurrence.order() + more);
        for (std::size_t i = recurrence.order(); i < next.size(); ++i) {
            bytes += sizeof(Integer) + static_cast<std::uint64_t>(bit_length(next[i])) / 8;
            found.push_back(std::move(next[i]));
        }
        budget.check_memory(bytes, "the values");
    }
    return found;
}

GrowthObject growth(const SystemObject& system, const Limits& limits) {
    const View<D0L> rules = as_d0l(*system);
    if (!rules)
        throw Error("no growth function: " + rules.reason() +
                    (as_ol(*system) ? "; length_bounds gives the least and the greatest length of "
                                      "each generation"
                                    : ""));
    return run(limits, [&](const Budget& budget) {
        return GrowthObject{{*rules, growth_analysis(*rules, budget)}};
    });
}

py::object lengths(const SystemObject& system, std::uint64_t first, std::uint64_t last,
                   const Limits& limits) {
    const View<D0L> rules = as_d0l(*system);
    const View<IL> interactive = as_dil(*system);
    const std::vector<Integer> found = run(limits, [&](const Budget& budget) {
        std::vector<Integer> all;
        if (!rules && interactive) {
            const auto derived = derived_lengths(*interactive, last, budget);
            for (std::uint64_t n = first; n <= last; ++n) all.emplace_back(derived[n]);
        } else {
            for (std::uint64_t n = first; n <= last; ++n) all.push_back(length(*rules, n, budget));
        }
        return all;
    });
    return ints(found);
}

/// How often each letter occurs, a row for each generation.
py::tuple counts(const SystemObject& system, std::uint64_t first, std::uint64_t last,
                 const Limits& limits) {
    const View<D0L> rules = as_d0l(*system);
    const auto rows = run(limits, [&](const Budget& budget) {
        std::vector<std::vector<Integer>> all;
        for (std::uint64_t n = first; n <= last; ++n)
            all.push_back(parikh_vector(*rules, n, budget));
        return all;
    });
    return py::make_tuple(letters(*rules), matrix(rows, rules->letters.size()));
}

/// How a comparison ends, its witness as JSON and its text.
using Compared = std::tuple<bool, std::string, std::string>;

Compared equal_growths(const SystemObject& left, const SystemObject& right, const Limits& limits) {
    const View<D0L> a = as_d0l(*left), b = as_d0l(*right);
    const GrowthComparison found =
        run(limits, [&](const Budget& budget) { return equal_growth(*a, *b, budget); });
    Json witness{{"bound", found.bound}};
    if (found.difference)
        witness = {{"generation", found.difference->generation},
                   {"lengths", Json::array({found.difference->left, found.difference->right})}};
    return {found.equal, witness.text(-1), to_text(found)};
}

std::string factors_json(const SystemObject& system, const Limits& limits) {
    const View<D0L> rules = as_d0l(*system);
    return to_json(run(limits, [&](const Budget& budget) { return factor_report(*rules, budget); }))
        .text(-1);
}

std::string factor_values_json(const SystemObject& system, std::uint64_t to, const Limits& limits) {
    const View<D0L> rules = as_d0l(*system);
    return to_json(run(limits,
                       [&](const Budget& budget) {
                           return factor_values(*rules, system->coding,
                                                static_cast<std::size_t>(to), budget);
                       }))
        .text(-1);
}

py::tuple bounds_of_lengths(const SystemObject& system, std::uint64_t n, const Limits& limits) {
    const View<OL> rules = as_ol(*system);
    const LengthBounds found =
        run(limits, [&](const Budget& budget) { return length_bounds(*rules, n, budget); });
    return py::make_tuple(found.least, found.most);
}

/// A system with these lengths, as text, and why it is one or there is none.
std::tuple<std::string, std::optional<std::string>, std::string> realised(
    const std::string& specification, const Limits& limits) {
    const Realisation found = run(limits, [&](const Budget& budget) {
        return realise(read_specification(specification), budget);
    });
    static const char* const kinds[] = {"found", "impossible", "unknown"};
    std::optional<std::string> text;
    if (found.system) {
        Model system;
        system.alphabet = *found.system->alphabet;
        system.axiom.letters = found.system->axiom;
        for (const Symbol a : found.system->letters) {
            Production rule;
            rule.predecessor.symbol = a;
            rule.successor.letters = found.system->successor(a);
            system.rules.push_back(std::move(rule));
        }
        text = print_lsystem(system);
    }
    return {kinds[static_cast<std::size_t>(found.kind)], text, found.because};
}

}  // namespace

void add_growth(py::module_& module) {
    py::class_<Algebraic>(module, "Algebraic")
        .def("minimal_polynomial",
             [](const Algebraic& number) -> py::object {
                 if (number.minimal.is_zero()) return py::none();
                 return polynomial(number.minimal);
             })
        .def("text", [](const Algebraic& number) { return number.text; })
        .def("rational", [](const Algebraic& number) { return number.rational; })
        .def(
            "decimal",
            [](const Algebraic& number, int digits, const Limits& limits) {
                return run(limits, [&](const Budget& budget) {
                    if (number.rational) return decimal(*number.rational, digits);
                    return decimal(
                        [&](long bits) {
                            budget.check();
                            return number.enclosure(bits);
                        },
                        digits);
                });
            },
            py::arg("digits"), py::arg("limits"))
        .def(
            "compare",
            [](const Algebraic& left, const Algebraic& right, const Limits& limits) {
                if (!left.minimal.is_zero() && left.text == right.text &&
                    left.minimal == right.minimal)
                    return 0;
                if (left.rational && right.rational)
                    return *left.rational < *right.rational    ? -1
                           : *left.rational == *right.rational ? 0
                                                               : 1;
                return run(limits, [&](const Budget& budget) {
                    constexpr long most_bits = 1L << 16;
                    for (long bits = 64; bits <= most_bits; bits *= 2) {
                        budget.check();
                        const Order order = compare(left.enclosure(bits), right.enclosure(bits));
                        if (order == Order::less) return -1;
                        if (order == Order::greater) return 1;
                    }
                    throw BoundReached(Bound::digits,
                                       "the numbers agree in all digits that were worked out");
                });
            },
            py::arg("other"), py::arg("limits"))
        .def("latex", [](const Algebraic& number) { return formula_latex(number.text); });

    py::class_<GrowthObject>(module, "Growth")
        .def(
            "report", [](const GrowthObject& growth) { return to_json(growth.report).text(-1); },
            Unlocked())
        .def(
            "page", [](const GrowthObject& growth) { return to_text(growth.report); }, Unlocked())
        .def(
            "latex",
            [](const GrowthObject& growth, const std::string& part) {
                static const std::vector<std::pair<std::string, GrowthPart>> parts{
                    {"all", GrowthPart::all},           {"lengths", GrowthPart::lengths},
                    {"matrix", GrowthPart::matrix},     {"recurrence", GrowthPart::recurrence},
                    {"function", GrowthPart::function}, {"form", GrowthPart::form},
                    {"rate", GrowthPart::rate}};
                for (const auto& [name, meaning] : parts)
                    if (name == part) return to_latex(growth.report, meaning);
                throw Error("part: expected " +
                            joined(parts, ", ", [](const auto& one) { return one.first; }) +
                            ", found " + algae::quoted(part));
            },
            py::arg("part"), Unlocked())
        .def("letters", [](const GrowthObject& growth) { return letters(growth.report.system); })
        .def("lengths", [](const GrowthObject& growth) { return growth.report.analysis.lengths; })
        .def(
            "values",
            [](const GrowthObject& growth, std::size_t count, const Limits& limits) {
                return ints(run(limits, [&](const Budget& budget) {
                    return first_values(growth.report.analysis.recurrence, count, budget);
                }));
            },
            py::arg("count"), py::arg("limits"))
        .def("matrix",
             [](const GrowthObject& growth) {
                 const IntegerMatrix whole = dense(growth.report.analysis.matrix);
                 std::vector<std::vector<Integer>> rows(whole.rows());
                 for (std::size_t i = 0; i < whole.rows(); ++i)
                     for (std::size_t j = 0; j < whole.columns(); ++j)
                         rows[i].push_back(whole(i, j));
                 return matrix(rows, whole.columns());
             })
        .def("characteristic",
             [](const GrowthObject& growth) {
                 return polynomial(growth.report.analysis.polynomials.characteristic);
             })
        .def("characteristic_factors",
             [](const GrowthObject& growth) {
                 return factors(growth.report.analysis.polynomials.characteristic_factors);
             })
        .def("minimal",
             [](const GrowthObject& growth) {
                 return polynomial(growth.report.analysis.polynomials.minimal);
             })
        .def("recurrence",
             [](const GrowthObject& growth) {
                 const Recurrence& found = growth.report.analysis.recurrence;
                 return py::make_tuple(polynomial(found.polynomial), found.exceptions,
                                       found.initial, found.text());
             })
        .def("generating_function",
             [](const GrowthObject& growth) {
                 const GeneratingFunction& found = growth.report.analysis.generating_function;
                 return py::make_tuple(polynomial(found.numerator), polynomial(found.denominator),
                                       to_string(found));
             })
        .def("closed_form",
             [](const GrowthObject& growth) { return growth.report.analysis.closed_form.text(); })
        .def("kind",
             [](const GrowthObject& growth) {
                 return to_string(growth.report.analysis.growth.order.kind);
             })
        .def("order",
             [](const GrowthObject& growth) { return growth.report.analysis.growth.order.text(); })
        .def("degree",
             [](const GrowthObject& growth) { return growth.report.analysis.growth.order.degree; })
        .def("period",
             [](const GrowthObject& growth) { return growth.report.analysis.growth.period; })
        .def("rate",
             [](const GrowthObject& growth) {
                 return algebraic(growth.report.analysis.growth.order.rate);
             })
        .def("primitivity",
             [](const GrowthObject& growth) { return growth.report.analysis.primitivity.exponent; })
        .def("frequencies", frequencies);

    module.def("growth", growth, py::arg("system"), py::arg("limits"));
    module.def("lengths", lengths, py::arg("system"), py::arg("first"), py::arg("last"),
               py::arg("limits"));
    module.def("counts", counts, py::arg("system"), py::arg("first"), py::arg("last"),
               py::arg("limits"));
    module.def("equal_growths", equal_growths, py::arg("left"), py::arg("right"),
               py::arg("limits"));
    module.def("factors_json", factors_json, py::arg("system"), py::arg("limits"));
    module.def("factor_values_json", factor_values_json, py::arg("system"), py::arg("to"),
               py::arg("limits"));
    module.def("length_bounds", bounds_of_lengths, py::arg("system"), py::arg("n"),
               py::arg("limits"));
    module.def("realise", realised, py::arg("specification"), py::arg("limits"));
}

}  // namespace algae::python
