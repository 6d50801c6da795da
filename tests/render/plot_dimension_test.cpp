#include "render/render.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "exact/exact.hpp"

using namespace algae;

namespace {

DimensionPlot plot_of(std::size_t scales) {
    DimensionPlot plot;
    plot.caption = "a square";
    plot.counts.scales = {1, 2, scales};
    plot.counts.detail = 1.0 / 4096;
    for (std::size_t k = 0; k < scales; ++k) {
        const std::uint64_t cells = std::uint64_t{1} << 2 * k;
        plot.counts.counts.push_back({cells, cells + 1});
    }
    plot.fit = fit_dimension(plot.counts);
    return plot;
}

std::string drawn(const DimensionPlot& plot, const std::string& name) {
    const auto path = std::filesystem::temp_directory_path() / name;
    draw_dimension_plot(plot, path.string());
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    std::filesystem::remove(path);
    return text.str();
}

}  // namespace

TEST_CASE("a log-log plot is drawn with a fit and without, the same bytes each time") {
    const std::string svg = drawn(plot_of(12), "algae-dimension-test.svg");
    CHECK(svg.find("<svg") != std::string::npos);
    CHECK(svg == drawn(plot_of(12), "algae-dimension-test.svg"));
    CHECK(drawn(plot_of(12), "algae-dimension-test.png").starts_with("\x89PNG"));
    CHECK(drawn(plot_of(2), "algae-dimension-test.pdf").starts_with("%PDF"));
    CHECK(!plot_of(2).fit.estimate);
}

TEST_CASE("a plot needs two scales and a format that exists") {
    CHECK_THROWS_WITH_AS(draw_dimension_plot(plot_of(1), "a.svg"),
                         "nothing to plot: expected at least two scales", Error);
    CHECK_THROWS_AS(draw_dimension_plot(plot_of(3), "a.xyz"), Error);
}
