#include "cli/growth_report.hpp"
#include "cli/numbers.hpp"

namespace algae::cli {

namespace {

using Json = nlohmann::ordered_json;

Json numbers(const std::vector<Integer>& values) {
    Json out = Json::array();
    for (const Integer& value : values) out.push_back(Json(json_number(value)));
    return out;
}

Json matrix(const GrowthMatrix& sparse) {
    Json out = Json::array();
    for (const auto& row : sparse.rows) {
        std::vector<Integer> full(sparse.size());
        for (const auto& [column, times] : row) full[column] = times;
        out.push_back(numbers(full));
    }
    return out;
}

Json polynomial(const Polynomial& value, const Factorisation& factors) {
    return {{"coefficients", numbers(value.coefficients())}, {"factors", factored(factors)}};
}

Json recurrence(const Recurrence& value) {
    std::vector<Integer> coefficients;  // of a(n-1), a(n-2), ...
    for (std::size_t j = 1; j <= value.order(); ++j)
        coefficients.push_back(-value.polynomial.coefficient(value.order() - j));
    return {{"text", value.text()},
            {"order", value.order()},
            {"coefficients", numbers(coefficients)},
            {"initial", numbers(value.initial)},
            {"holds_from", value.holds_from()}};
}

Json rate(const GrowthOrder& order) {
    if (order.kind == GrowthKind::zero) return nullptr;
    return {{"exact", order.rate.exact()},
            {"decimal", rate_decimal(order)},
            {"minimal_polynomial", to_string(order.rate.minimal_polynomial())}};
}

Json letters(const D0L& system, const GrowthAnalysis& analysis) {
    Json out = Json::array();
    for (std::size_t i = 0; i < system.letters.size(); ++i) {
        const GrowthOrder& order = analysis.letters[i];
        Json letter{{"letter", system.alphabet->name(system.letters[i])},
                    {"class", analysis.lifetimes[i] ? "mortal" : to_string(order.kind)},
                    {"degree", order.degree},
                    {"rate", order.kind == GrowthKind::zero ? Json(nullptr) : Json(order.rate.exact())},
                    {"growing", order.kind == GrowthKind::polynomial || order.kind == GrowthKind::exponential}};
        if (analysis.lifetimes[i]) letter["lifetime"] = *analysis.lifetimes[i];
        Json shares = Json::array();
        for (const auto& limit : analysis.frequencies.limits) {
            Json share{{"exact", nullptr}, {"decimal", limit[i].decimal(15)}};
            if (limit[i].number()) share["exact"] = limit[i].exact();
            shares.push_back(std::move(share));
        }
        if (shares.size() == 1)
            letter["frequency"] = shares[0];
        else if (!shares.empty())
            letter["frequencies"] = shares;
        out.push_back(std::move(letter));
    }
    return out;
}

Json points(const D0L& system, const GrowthAnalysis& analysis) {
    Json out = Json::array();
    for (const Prolongation& point : analysis.prolongations)
        out.push_back({{"letter", system.alphabet->name(point.letter)},
                       {"power", point.power},
                       {"fixed", point.fixed},
                       {"infinite", point.infinite}});
    return out;
}

}  // namespace

nlohmann::ordered_json growth_json(const D0L& system, const GrowthAnalysis& a) {
    Json out;
    out["lengths"] = numbers(a.lengths);
    out["matrix"] = matrix(a.matrix);
    out["characteristic_polynomial"] = polynomial(a.polynomials.characteristic, a.polynomials.characteristic_factors);
    out["minimal_polynomial"] = polynomial(a.polynomials.minimal, a.polynomials.minimal_factors);
    out["recurrence"] = recurrence(a.recurrence);
    out["generating_function"] = {{"numerator", numbers(a.generating_function.numerator.coefficients())},
                                  {"denominator", numbers(a.generating_function.denominator.coefficients())}};
    out["closed_form"] = a.closed_form.text();
    out["exceptions"] = numbers(a.closed_form.exceptions());
    out["class"] = to_string(a.growth.order.kind);
    out["degree"] = a.growth.order.degree;
    out["rate"] = rate(a.growth.order);
    out["period"] = json_number(a.growth.period);
    if (a.growth.order.kind == GrowthKind::zero || a.growth.order.kind == GrowthKind::bounded)
        out["preperiod"] = a.growth.preperiod;
    out["irreducible"] = a.primitivity.irreducible;
    out["primitive"] = a.primitivity.exponent.has_value();
    out["primitivity_exponent"] = a.primitivity.exponent ? Json(*a.primitivity.exponent) : Json(nullptr);
    out["fixed_and_periodic"] = points(system, a);
    out["letters"] = letters(system, a);
    out["frequency_period"] = json_number(a.frequencies.period);
    return out;
}

}  // namespace algae::cli
