#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "notation/notation.hpp"
#include "rewrite/rewrite.hpp"
#include "turtle/detail/module_turtle.hpp"

using namespace algae;

namespace {

using Real = long double;
using Matrix = std::array<std::array<Real, 3>, 3>;  // by row; H, L and U are the columns

Matrix product(const Matrix& a, const Matrix& b) {
    Matrix out{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t k = 0; k < 3; ++k) out[i][j] += a[i][k] * b[k][j];
    return out;
}

/// The matrices of the document: [H' L' U'] = [H L U] R.
Matrix rotation(char command, Real degrees) {
    Real a = degrees * std::numbers::pi_v<Real> / 180;
    if (command == '-' || command == '^' || command == '/') a = -a;
    const Real c = std::cos(a), s = std::sin(a);
    switch (command) {
        case '+':
        case '-':
            return {{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}};  // about U
        case '&':
        case '^':
            return {{{c, 0, s}, {0, 1, 0}, {-s, 0, c}}};  // about L: H goes to -U
        case '|':
            return {{{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}};
        default:
            return {{{1, 0, 0}, {0, c, s}, {0, -s, c}}};  // about H: L goes to -U
    }
}

struct Step {
    char command;
    int degrees;
};

std::vector<std::array<Real, 3>> walked(const std::vector<Step>& steps) {
    Matrix frame{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    std::array<Real, 3> here{};
    std::vector<std::array<Real, 3>> places;
    for (const Step& step : steps) {
        if (step.command != 'F') {
            frame = product(frame, rotation(step.command, step.degrees));
            continue;
        }
        for (std::size_t i = 0; i < 3; ++i) here[i] += frame[i][0];
        places.push_back(here);
    }
    return places;
}

class Places : public TurtleEvents {
public:
    void stroke(const Vector&, const TurtleState& state) override {
        places.push_back(state.position);
        const Attitude& look = state.attitude;
        crooked = std::max(crooked, length(cross(look.heading(), look.left()) - look.up()));
    }
    std::vector<Vector> places;
    double crooked = 0;
};

}  // namespace

TEST_CASE("walks in space are those of matrices multiplied one by one") {
    const bool holds = rc::check("in space", [] {
        const auto any_step = rc::gen::apply(
            [](char command, int degrees) { return std::pair(command, degrees); },
            rc::gen::elementOf(std::string("FF+-&^\\/|")), rc::gen::inRange(-400, 400));
        const auto drawn = *rc::gen::container<std::vector<std::pair<char, int>>>(any_step);
        std::vector<Step> steps;
        std::string word = "F";
        steps.push_back({'F', 0});
        for (const auto& [command, degrees] : drawn) {
            steps.push_back({command, degrees});
            word += command;
            if (command != 'F') word += '(' + std::to_string(degrees) + ')';
        }
        const Model system = read_lsystem("axiom " + word, "space");
        const Rewriting rewriting(system);
        Places places;
        ModuleTurtle(system, rewriting.rules().kinds, 0).walk(rewriting.axiom(), places);
        const auto truth = walked(steps);
        RC_ASSERT(places.places.size() == truth.size());
        for (std::size_t i = 0; i < truth.size(); ++i) {
            RC_ASSERT(std::fabs(places.places[i].x - truth[i][0]) < 1e-9L);
            RC_ASSERT(std::fabs(places.places[i].y - truth[i][1]) < 1e-9L);
            RC_ASSERT(std::fabs(places.places[i].z - truth[i][2]) < 1e-9L);
        }
        RC_ASSERT(places.crooked < 1e-12);
    });
    CHECK(holds);
}
