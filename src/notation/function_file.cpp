#include "notation/function_file.hpp"

#include "nature/weierstrass.hpp"
#include "notation/relative_values.hpp"

namespace algae {

namespace {

std::unique_ptr<Relative> make(const RelativeFile& file) {
    auto function = std::make_unique<WeierstrassFunction>();
    file.describe(*function);
    file.choice("function", {"weierstrass"});
    if (const auto a = hurst_values(file, "a")) {
        file.check_words(*file.find("a"), 1, 1, "NUMBER");
        function->a = a->front();
    }
    function->b = positive_value(file, "b").value_or(function->b);
    if (const auto counts = natural_values(file, "terms", 1, 1000)) function->terms = *counts;
    function->zooms = file.natural("zoom", 0, 12).value_or(0);
    function->points = file.natural("points", 2, 10'000'000).value_or(function->points);
    if (const RelativeStatement* interval = file.find("interval")) {
        file.check_words(*interval, 2, 2, "FROM TO");
        function->from = file.quantity(*interval, interval->words[0]).value;
        function->to = file.quantity(*interval, interval->words[1]).value;
    }
    function->check();
    return function;
}

}  // namespace

RelativeKind function_kind() {
    return {"function",
            "Weierstrass's function",
            {{"function", "weierstrass"},
             {"a", "NUMBER"},
             {"b", "NUMBER"},
             {"terms", "N ..."},
             {"zoom", "N"},
             {"interval", "FROM TO"},
             {"points", "N"}},
            make};
}

}  // namespace algae
