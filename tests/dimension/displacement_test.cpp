// Ways and scaling factors against turtles in floating point.

#include "dimension/dimension.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <chrono>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "dimension/detail/recurrent_set.hpp"
#include "exact/exact.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "oracle/random_systems.hpp"
#include "system/system.hpp"

using namespace algae;
using oracle::WrittenSystem;

namespace {

using Real = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<800, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;
const Real negligible("1e-150");

std::string text_of(const WrittenSystem& system, int angle) {
    std::string text = "axiom " + system.axiom;
    for (const auto& [letter, successors] : system.successors)
        text += std::string("; ") + letter + " -> " +
                (successors[0].empty() ? std::string("ε") : successors[0]);
    return text + "; angle " + std::to_string(angle);
}

rc::Gen<std::pair<WrittenSystem, int>> any_turtle_system() {
    const auto word = [](const std::string& letters) {
        return rc::gen::mapcat(rc::gen::inRange<std::size_t>(4, 8), [letters](std::size_t size) {
            return rc::gen::map(rc::gen::container<std::string>(size, rc::gen::elementOf(letters)),
                                oracle::balanced);
        });
    };
    const auto system = rc::gen::apply(
        [](const std::string& f, const std::string& x, const std::string& y) {
            return WrittenSystem{"F", {{'F', {"F" + f}}, {'X', {x}}, {'Y', {y}}}};
        },
        word("FFFFFX+-[]fG"), word("FFFXXY+-[]"), word("FFGXY+-|"));
    return rc::gen::pair(system, rc::gen::element(90, 60, 45, 120, 72));
}

Budget short_time() {
    Budget budget;
    budget.deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds(200);
    return budget;
}

std::optional<RecurrentSet> recurrent_set(const Model& system,
                                          const Budget& budget = short_time()) {
    try {
        return RecurrentSet(system, *as_d0l(system), budget);
    } catch (const Error&) {
        return std::nullopt;
    } catch (const BoundReached&) {
        return std::nullopt;
    }
}

/// The letters of all words.
std::set<char> everything_in(const WrittenSystem& system) {
    std::set<char> found(system.axiom.begin(), system.axiom.end());
    for (bool changed = true; changed;) {
        changed = false;
        for (const auto& [a, successors] : system.successors)
            if (found.contains(a))
                for (const char b : successors[0]) changed = found.insert(b).second || changed;
    }
    return found;
}

/// By how much ways grow in each generation, from generation 60 on, where they do so evenly. With 800 bits: where
/// ways stay small because larger ones cancel, roundings grow up to eightfold in each generation.
std::optional<double> growth_of_ways(const WrittenSystem& system, int angle) {
    struct Motion {
        Real x = 0, y = 0;
        int degrees = 0;
        Real size() const { return abs(x) + abs(y); }
    };
    std::map<char, Motion> motions;
    for (const char a : everything_in(system)) {
        motions[a] = {};
        if (a == 'F' || a == 'f' || a == 'G') motions[a].x = 1;
    }
    motions['+'].degrees = angle;
    motions['-'].degrees = 360 - angle;
    motions['|'].degrees = 180;
    std::map<int, Motion> directions;
    const auto direction = [&](int degrees) {
        const auto [known, added] = directions.try_emplace(degrees);
        if (added) {
            const Real radians = boost::math::constants::pi<Real>() * degrees / 180;
            known->second = {cos(radians), sin(radians), degrees};
        }
        return known->second;
    };
    std::map<int, double> logs;
    for (int n = 0; n <= 247; ++n) {
        Real largest = 0;
        for (const auto& [a, motion] : motions)
            largest = std::max<Real>(largest, motion.x * motion.x + motion.y * motion.y);
        if (largest == 0) return std::nullopt;
        if (n == 60 || n == 150 || n == 247) logs[n] = static_cast<double>(log(largest)) / 2;
        std::map<char, Motion> next = motions;
        for (const auto& [a, motion] : motions) {
            const auto rule = system.successors.find(a);
            if (rule == system.successors.end()) continue;
            Motion whole;
            Real sizes = 0;
            int depth = 0;
            for (const char b : rule->second[0]) {
                if (b == '[') ++depth;
                if (b == ']') --depth;
                if (depth > 0 || b == ']') continue;
                const Motion turn = direction(whole.degrees), &part = motions[b];
                whole.x += turn.x * part.x - turn.y * part.y;
                whole.y += turn.x * part.y + turn.y * part.x;
                sizes += part.size();
                whole.degrees = (whole.degrees + part.degrees) % 360;
            }
            // What cancels but for rounding is 0: it might grow faster than the ways themselves.
            if (whole.size() < negligible * sizes) whole.x = whole.y = 0;
            next[a] = whole;
        }
        motions = std::move(next);
    }
    // Rates that go round with a period agree over two times of the same length, and not over these.
    const double first = (logs[150] - logs[60]) / 90, second = (logs[247] - logs[150]) / 97;
    if (std::abs(first - second) > 1e-9) return std::nullopt;
    return std::exp(second);
}

/// The rate at which the letters multiply that draw, or lead to drawing, for ever, if they all lead to
/// each other and the axiom to them.
std::optional<double> growth_of_letters(const WrittenSystem& system) {
    std::set<char> lasting;
    const auto successor = [&](char a) {
        const auto found = system.successors.find(a);
        return found == system.successors.end() ? std::string(1, a) : found->second[0];
    };
    const std::string letters = "FXYfG+-|";
    std::set<char> leads{'F', 'G'};
    const auto grow = [&](std::set<char>& set) {
        const std::size_t before = set.size();
        for (const char a : letters)
            for (const char b : successor(a))
                if (set.contains(b)) set.insert(a);
        return set.size() > before;
    };
    while (grow(leads)) {
    }
    lasting = leads;
    for (bool changed = true; changed;) {
        changed = false;
        for (const char a : letters) {
            const std::string word = successor(a);
            if (lasting.contains(a) && std::none_of(word.begin(), word.end(),
                                                    [&](char b) { return lasting.contains(b); })) {
                lasting.erase(a);
                changed = true;
            }
        }
    }
    if (lasting.empty()) return std::nullopt;
    std::set<char> reached;
    for (const char a : system.axiom)
        if (lasting.contains(a)) reached.insert(a);
    for (bool changed = true; changed;) {
        changed = false;
        for (const char a : std::set<char>(reached))
            for (const char b : successor(a))
                if (lasting.contains(b) && reached.insert(b).second) changed = true;
    }
    for (const char a : reached) {
        std::set<char> from{a};
        for (bool changed = true; changed;) {
            changed = false;
            for (const char b : std::set<char>(from))
                for (const char c : successor(b))
                    if (lasting.contains(c) && from.insert(c).second) changed = true;
        }
        if (from != reached) return std::nullopt;
    }
    // By powers of the matrix plus one, which is primitive.
    std::map<char, double> counts;
    for (const char a : reached) counts[a] = 1;
    double rate = 0;
    for (int n = 0; n < 3000; ++n) {
        std::map<char, double> next = counts;
        for (const char a : reached)
            for (const char b : successor(a))
                if (reached.contains(b)) next[a] += counts[b];
        double sum = 0;
        for (const auto& [a, count] : next) sum += count;
        double before = 0;
        for (const auto& [a, count] : counts) before += count;
        rate = sum / before;
        for (auto& [a, count] : next) count /= sum;
        counts = std::move(next);
    }
    return rate - 1;
}

}  // namespace

TEST_CASE("ways are multiplied by the factor and by roots of unity as complex numbers are") {
    int looked_at = 0;
    CHECK(rc::check([&] {
        const auto [written, angle] = *any_turtle_system();
        const auto set = recurrent_set(read_lsystem(text_of(written, angle), "random"));
        if (!set) return;
        ++looked_at;
        const Displacement& displacement = set->displacement();
        const Unfolding& unfolding = set->unfolding();
        for (std::size_t p = 0; p < unfolding.size(); ++p) {
            // mu times a way is the sum of the ways of the parts, turned.
            Displacement::Vector sum = displacement.zero();
            int depth = 0;
            for (const Unfolding::Item& item : unfolding.items[p]) {
                if (item.kind == Unfolding::Item::Kind::push) ++depth;
                if (item.kind == Unfolding::Item::Kind::pop) --depth;
                if (item.kind == Unfolding::Item::Kind::piece && depth == 0)
                    displacement.add(
                        sum, displacement.turned(displacement.way(item.piece), item.heading));
            }
            RC_ASSERT(displacement.scaled(displacement.way(p)) == sum);
        }
        Displacement::Vector vector = displacement.zero();
        double size = 1;
        for (auto& coordinate : vector) {
            coordinate = *rc::gen::inRange(-20, 21);
            size += std::abs(static_cast<double>(coordinate));
        }
        const std::complex<double> value = displacement.value(vector);
        size *= 1 + std::abs(value);
        for (const auto& part : vector) size += std::abs(static_cast<double>(part));
        RC_ASSERT(std::abs(displacement.value(displacement.scaled(vector)) -
                           displacement.factor() * value) < 1e-9 * size);
        const std::int64_t heading = *rc::gen::inRange<std::int64_t>(-2 * set->order(), 40);
        const auto turn = std::polar(1.0, 2 * std::numbers::pi * static_cast<double>(heading) /
                                              static_cast<double>(set->order()));
        RC_ASSERT(std::abs(displacement.value(displacement.turned(vector, heading)) -
                           turn * value) < 1e-9 * size);
    }));
    CHECK(looked_at >= 5);
    MESSAGE(looked_at, " systems");
}

TEST_CASE("the factor is the growth of ways in floating point") {
    int looked_at = 0;
    CHECK(rc::check([&] {
        const auto [written, angle] = *any_turtle_system();
        const auto set = recurrent_set(read_lsystem(text_of(written, angle), "random"));
        if (!set) return;
        const auto growth = growth_of_ways(written, angle);
        if (!growth) return;
        ++looked_at;
        RC_ASSERT(std::abs(set->displacement().ratio() - *growth) <
                  1e-7 * set->displacement().ratio());
    }));
    CHECK(looked_at >= 5);
    MESSAGE(looked_at, " systems");
}

TEST_CASE("a rate that goes round with the generations is not taken for the factor") {
    const WrittenSystem system{"F", {{'F', {"FFGFX"}}, {'X', {"Y+[]"}}, {'Y', {"YXYG"}}}};
    const auto set = recurrent_set(read_lsystem(text_of(system, 90), "round"), {});
    REQUIRE(set);
    CHECK(set->displacement().ratio() == doctest::Approx(std::pow(27, 1.0 / 8)).epsilon(1e-9));
    CHECK(!growth_of_ways(system, 90));
}

TEST_CASE("a way that stays small because larger ones cancel is not taken for a growing one") {
    const WrittenSystem system{"F", {{'F', {"FXGf"}}, {'X', {"FYX"}}, {'Y', {"Y|GY"}}}};
    const auto set = recurrent_set(read_lsystem(text_of(system, 60), "unstable"), {});
    REQUIRE(set);
    CHECK(set->displacement().ratio() == doctest::Approx(std::sqrt(2)).epsilon(1e-9));
    const auto growth = growth_of_ways(system, 60);
    if (growth) CHECK(*growth == doctest::Approx(std::sqrt(2)).epsilon(1e-9));
}

TEST_CASE("the dimension with multiplicity is that of rates found by iteration") {
    int looked_at = 0, multiplying = 0;
    CHECK(rc::check([&] {
        const auto [written, angle] = *any_turtle_system();
        const Model system = read_lsystem(text_of(written, angle), "random");
        const auto ways = growth_of_ways(written, angle);
        const auto letters = growth_of_letters(written);
        if (!ways || !letters) return;
        ExactDimension found;
        try {
            found = exact_dimension(system, short_time());
        } catch (const BoundReached&) {
            return;  // too large for a test
        }
        if (!found.similarity) return;
        const double expected = std::log(*letters) / std::log(*ways);
        const double value = found.similarity->enclosure(64).midpoint();
        ++looked_at;
        multiplying += *letters > 1.001;
        RC_ASSERT(std::abs(value - expected) < 1e-5 * (1 + expected));
        RC_ASSERT(found.value->enclosure(64).midpoint() < value + 1e-9);
        RC_ASSERT(found.status != ExactDimension::Status::exact ||
                  found.value->enclosure(64).midpoint() < 2 + 1e-9);
    }));
    CHECK(looked_at >= 5);
    MESSAGE(looked_at, " systems, ", multiplying, " whose parts multiply");
}

// What overflowed was seen by a build with sanitizers (tools/sanitize, tools/python asan): the exponent of an infinite double.
TEST_CASE("the limit of plant d, whose lattice has numbers beyond every double, has no overflow") {
    const Model plant = read_lsystem("axiom X; X -> F[+X]F[-X]+X; F -> FF; angle 20", "plant-d");
    try {
        const ExactDimension found = exact_dimension(plant, short_time());
        REQUIRE(found.similarity);
        CHECK(found.similarity->enclosure(64).midpoint() == doctest::Approx(std::log2(3.0)));
    } catch (const BoundReached&) {
        // The lattice comes first.
    }
}

TEST_CASE("the moves of a piece are those of its word in the generation of its phase") {
    // Koch's curve becomes three times as long from its beginning to its end in each generation.
    const Model system = read_lsystem("axiom F; F -> F+F--F+F; angle 60", "");
    const Unfolding found = unfolding(system, *as_d0l(system), 3);
    const CyclotomicRing ring(found.order);
    REQUIRE(system.alphabet.name(found.letters.front()) == "F");
    REQUIRE(found.phases == 3);
    for (std::size_t phase = 0; phase < 3; ++phase) {
        CAPTURE(phase);
        CHECK(std::abs(ring.to_complex(found.moves[phase * found.letters.size()])) ==
              doctest::Approx(std::pow(3, static_cast<double>(found.preperiod + phase))));
    }
}
