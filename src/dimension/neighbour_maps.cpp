#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <numbers>
#include <set>

#include "dimension/detail/ratio_graph.hpp"
#include "watch/watch.hpp"

// Whether the parts of a figure lie so that all of them count, where its angle is any number and its
// parts may shrink by different ratios: by neighbour maps whose numbers are formal.
//
// A component of a ratio graph has pieces with mu K_s = union of c K_t + o over the parts of s:
// c = ratio e^(i heading), o = the sum of c' v(s') over the parts before, and the ways v solve
// mu v(s) = sum of c v(t). A piece seen from another one of about its size is z -> g z + w. Where
// only finitely many such maps bring the two together, and none of them is the identity of a state,
// boundedly many pieces of a size meet in a place; so all of them count (Bandt and Graf 1992; Das
// and Ngai 2004), whatever the ratios are.
//
// The maps need not be known as complex numbers. It suffices that equal symbols mean equal maps, and
// that no map which is not the identity as a symbol is it as a number: the latter is seen in floating
// point with a margin. So w is a sum of terms c v(s), where c is a number of a cyclotomic field times
// powers of symbols: of e^(i angle) for an angle that is no rational part of a turn, or a very small
// one, and of ratios that lie in no such field. Different symbols may mean one map; then there are more maps than need
// be, or infinitely many, and nothing is proved. Multiplication by mu replaces v(s) by the sum that
// mu v(s) is. A piece d levels deeper than the other has w = mu^-max(d,0) times such a sum.
//
// Where mu lies in the field (it is rational, or only one kind of module moves), everything is one
// number of the field instead of terms.

namespace algae {

namespace {

using Number = CyclotomicNumber;
using Complex = std::complex<double>;
using Exponents = std::vector<int>;  // of the symbols

constexpr double margin = 1e-7;

/// A number of the field times powers of symbols.
struct Factor {
    Number number;
    Exponents exponents;

    bool operator==(const Factor&) const = default;
};

bool operator<(const Number& left, const Number& right) {
    if (left.below != right.below) return left.below < right.below;
    return std::lexicographical_compare(
        left.above.coefficients.begin(), left.above.coefficients.end(),
        right.above.coefficients.begin(), right.above.coefficients.end());
}

/// A sum of factors times ways: by state and exponents.
using Terms = std::map<std::pair<std::size_t, Exponents>, Number>;

struct Piece {
    std::size_t from = 0, to = 0;
    Factor size;     // with the turn
    long depth = 0;  // of the second piece less that of the first
    Terms shift;     // times mu^-max(depth, 0)
};

bool operator<(const Piece& left, const Piece& right) {
    if (left.from != right.from) return left.from < right.from;
    if (left.to != right.to) return left.to < right.to;
    if (left.depth != right.depth) return left.depth < right.depth;
    if (left.size.exponents != right.size.exponents)
        return left.size.exponents < right.size.exponents;
    if (!(left.size.number == right.size.number)) return left.size.number < right.size.number;
    return std::lexicographical_compare(left.shift.begin(), left.shift.end(), right.shift.begin(),
                                        right.shift.end(), [](const auto& a, const auto& b) {
                                            return a.first != b.first ? a.first < b.first
                                                                      : a.second < b.second;
                                        });
}

/// A reason why nothing is known.
struct Unknown {
    std::string reason;
};

class NeighbourMaps {
public:
    NeighbourMaps(const RatioGraph& graph, const std::vector<std::size_t>& component,
                  const std::vector<bool>& drawing, const Budget& budget)
        : graph_(graph), budget_(budget), directions_(directions()), field_(order()) {
        inside_.assign(graph.states.size(), false);
        for (const std::size_t state : component)
            if (drawing[state]) inside_[state] = true;
        find_turns();
        find_symbols();
        find_ways();
        find_parts();
        find_discs();
    }

    PartsApart result(std::size_t most) {
        constexpr std::size_t work = 100'000;  // numbers of large fields are long
        most = std::min(most, std::max<std::size_t>(200, work / field_.degree()));
        for (std::size_t s = 0; s < parts_.size(); ++s)
            for (std::size_t i = 0; i < parts_[s].size(); ++i)
                for (std::size_t k = 0; k < parts_[s].size(); ++k)
                    if (i != k) {
                        const Piece whole{s, s, one(), 0, {}};
                        visit(of_second(of_first(whole, parts_[s][i]), parts_[s][k]));
                    }
        WorkCount done("neighbour maps");
        while (!open_.empty() && !coincide_) {
            budget_.check();
            ++done;
            if (seen_.size() > most)
                throw Unknown{"more than " + std::to_string(most) +
                              " ways in which two parts may meet"};
            const Piece pair = *open_.front();
            open_.pop_front();
            const double log_size = std::log(std::abs(size_of(pair)));
            std::vector<Piece> first{pair};
            if (log_size < margin) {
                first.clear();
                for (const Part& part : parts_[pair.from]) first.push_back(of_first(pair, part));
            }
            for (Piece& seen : first)
                if (log_size < -margin)
                    visit(std::move(seen));
                else
                    for (const Part& part : parts_[pair.to]) visit(of_second(seen, part));
        }
        PartsApart found;
        found.answer = coincide_ ? PartsApart::Answer::coincide : PartsApart::Answer::apart;
        found.ways = seen_.size();
        return found;
    }

private:
    struct Part {
        std::size_t state;
        Factor factor;
        Terms shift;
    };

    // The field and the symbols.

    /// Whether turns are finer than those of the fields: then they are powers of a symbol, too, which
    /// only that of a full turn makes 1.
    bool is_fine() const { return directions_ > CyclotomicRing::largest_order / 4; }

    /// The number of directions that the turns of degrees lead to.
    std::int64_t directions() const {
        Integer found = 2;
        for (const RatioGraph::State& state : graph_.states)
            found = lcm(found, (state.turn.degrees / Rational(360)).denominator());
        if (Integer(1'000'000) < found) throw Unknown{"turns are too fine"};
        return found.to_int64();
    }

    long order() const {
        std::vector<const Expression*> numbers;
        std::vector<Expression> turns;
        for (const RatioGraph::State& state : graph_.states) {
            for (const RatioGraph::Part& part : state.parts)
                if (!part.is_fence) numbers.push_back(&part.ratio);
            if (is_fine()) continue;
            Expression turn;
            turn.kind = Expression::Kind::call;
            turn.name = "cos";
            turn.operands = {quantity(state.turn.degrees).expression};
            turns.push_back(std::move(turn));
        }
        for (const Expression& turn : turns) numbers.push_back(&turn);
        const auto found = cyclotomic_order(numbers);
        if (!found) throw Unknown{"turns and ratios lie in no small field"};
        return *found;
    }

    /// Of each state the turn of what it becomes, which must be the same in all late generations.
    void find_turns() {
        constexpr std::size_t most = 200;
        for (const auto& state : graph_.states) turns_.push_back(state.turn);
        for (std::size_t round = 0;; ++round) {
            std::vector<Rotation> next;
            for (const auto& state : graph_.states) {
                Rotation sum;
                for (const RatioGraph::Part* part : stem(state)) sum = sum + turns_[part->state];
                next.push_back(sum);
            }
            if (next == turns_) return;
            if (round == most)
                throw Unknown{"the turns of parts are not the same in all generations"};
            turns_ = std::move(next);
        }
    }

    void find_symbols() {
        const bool turned = std::any_of(turns_.begin(), turns_.end(),
                                        [](const Rotation& turn) { return turn.angles != 0; });
        const bool turns =
            std::any_of(graph_.states.begin(), graph_.states.end(),
                        [](const RatioGraph::State& state) { return state.turn.angles != 0; });
        if ((turned || turns) && is_fine()) throw Unknown{"turns are of two kinds"};
        if (is_fine()) {
            symbols_.push_back(
                std::polar(1.0, 2 * std::numbers::pi / static_cast<double>(directions_)));
        } else if (turned || turns) {
            const ComplexBall unit = direction({0, 1}, graph_.angle, 64);
            symbols_.emplace_back(unit.real.midpoint(), unit.imaginary.midpoint());
        } else {
            symbols_.emplace_back(1);
        }
        for (const auto& state : graph_.states)
            for (const auto& part : state.parts)
                if (!part.is_fence) factor_of(part.ratio);
    }

    Exponents none() const { return Exponents(symbols_.size(), 0); }
    Factor one() const { return {field_.rational(1), none()}; }

    Factor factor_of(const Expression& ratio) {
        if (const auto value = field_.value_of(shortened(ratio))) return {*value, none()};
        if (ratio.kind == Expression::Kind::binary && (ratio.name == "*" || ratio.name == "/")) {
            const Factor left = factor_of(ratio.operands[0]);
            const Factor right = factor_of(ratio.operands[1]);
            return product(left, ratio.name == "*" ? right : inverse(right));
        }
        const auto [place, is_new] = ratios_.try_emplace(to_text(ratio), symbols_.size());
        if (is_new) symbols_.emplace_back(enclosure(ratio, 64).midpoint());
        Exponents exponents = none();
        exponents[place->second] = 1;
        return {field_.rational(1), std::move(exponents)};
    }

    Factor factor_of(const Rotation& turn) const {
        Factor found{field_.rational(1), none()};
        if (is_fine()) {
            const Rational part = turn.degrees / Rational(360) * Rational(directions_);
            found.exponents[0] = static_cast<int>(part.numerator().to_int64());
            return normal(std::move(found));
        } else {
            found.number = *field_.direction(turn.degrees);
            found.exponents[0] = static_cast<int>(turn.angles);
        }
        return found;
    }

    static Exponents sum(Exponents left, const Exponents& right) {
        left.resize(std::max(left.size(), right.size()));
        for (std::size_t k = 0; k < right.size(); ++k) left[k] += right[k];
        return left;
    }

    /// A half turn is -1, also where turns are powers of a symbol.
    Factor normal(Factor factor) const {
        if (!is_fine()) return factor;
        const auto half = static_cast<int>(directions_ / 2);
        int& exponent = factor.exponents[0];
        int halves = exponent / half;
        exponent %= half;
        if (exponent < 0) {
            exponent += half;
            --halves;
        }
        if (halves % 2 != 0) factor.number = field_.difference(field_.rational(0), factor.number);
        return factor;
    }

    Factor product(const Factor& left, const Factor& right) const {
        return normal(
            {field_.product(left.number, right.number), sum(left.exponents, right.exponents)});
    }

    Factor inverse(const Factor& factor) const {
        Factor found{field_.inverse(factor.number), factor.exponents};
        for (int& exponent : found.exponents) exponent = -exponent;
        return normal(std::move(found));
    }

    Complex value(const Exponents& exponents) const {
        Complex found = 1;
        for (std::size_t k = 0; k < exponents.size(); ++k)
            if (exponents[k] != 0) found *= std::pow(symbols_[k], exponents[k]);
        return found;
    }

    Complex value(const Factor& factor) const {
        return field_.to_complex(factor.number) * value(factor.exponents);
    }

    // Ways.

    void add(Terms& left, const Factor& factor, const Terms& right, bool negative = false) const {
        for (const auto& [key, number] : right) {
            auto [term, exponents] = product(factor, {number, key.second});
            if (negative) term = field_.difference(field_.rational(0), term);
            const std::pair place(key.first, std::move(exponents));
            const auto [at, is_new] = left.try_emplace(place, term);
            if (is_new) continue;
            at->second = field_.sum(at->second, term);
            if (field_.is_zero(at->second)) left.erase(at);
        }
    }

    Terms way(std::size_t state) const {
        if (!moving_[state]) return {};
        if (!exact_mu_) return {{{state, none()}, field_.rational(1)}};
        if (field_.is_zero(exact_ways_[state])) return {};
        return {{{0, none()}, exact_ways_[state]}};
    }

    /// One part after the other outside branches, with their places.
    template <class See>
    void walk(std::size_t state, const See& see) {
        Rotation heading;
        Terms place;
        std::vector<std::pair<Rotation, Terms>> kept;
        for (const RatioGraph::Part& part : graph_.states[state].parts) {
            if (part.is_fence && part.opens) {
                kept.emplace_back(heading, place);
            } else if (part.is_fence) {
                std::tie(heading, place) = std::move(kept.back());
                kept.pop_back();
            } else {
                const Factor factor = product(factor_of(part.ratio), factor_of(heading));
                see(part, factor, place);
                add(place, factor, way(part.state));
                heading = heading + turns_[part.state];
            }
        }
    }

    void find_ways() {
        constexpr int most_rounds = 20'000;
        moving_ = moving_for_ever(graph_);
        const std::size_t size = graph_.states.size();
        steps_.resize(size);
        for (std::size_t s = 0; s < size; ++s) {
            Rotation heading;
            for (const RatioGraph::Part* part : stem(graph_.states[s])) {
                if (moving_[s] && moving_[part->state])
                    steps_[s].push_back(
                        {part->state, product(factor_of(part->ratio), factor_of(heading))});
                heading = heading + turns_[part->state];
            }
        }
        ways_.assign(size, 0);
        for (std::size_t s = 0; s < size; ++s)
            if (moving_[s] && graph_.states[s].moves) ways_[s] = 1;
        std::vector<std::vector<std::pair<std::size_t, Complex>>> rows(size);
        for (std::size_t s = 0; s < size; ++s)
            for (const auto& [to, factor] : steps_[s]) rows[s].emplace_back(to, value(factor));
        for (int round = 0;; ++round) {
            std::vector<Complex> next(size, 0);
            for (std::size_t s = 0; s < size; ++s)
                for (const auto& [to, factor] : rows[s]) next[s] += factor * ways_[to];
            const auto largest = static_cast<std::size_t>(
                std::max_element(ways_.begin(), ways_.end(),
                                 [](Complex a, Complex b) { return std::abs(a) < std::abs(b); }) -
                ways_.begin());
            mu_ = next[largest] / ways_[largest];
            double error = 0;
            for (std::size_t s = 0; s < size; ++s)
                error = std::max(error, std::abs(next[s] - mu_ * ways_[s]));
            if (!(std::abs(mu_) > 1e-9) || round == most_rounds)
                throw Unknown{"ways do not tend to multiples of each other"};
            const bool done = error < 1e-14 * std::abs(mu_) * std::abs(ways_[largest]);
            const Complex scale = next[largest];
            for (std::size_t s = 0; s < size; ++s) ways_[s] = next[s] / scale;
            if (done) break;
        }
        find_exact_ways();
    }

    /// Where mu lies in the field, and the ways with it.
    void find_exact_ways() {
        constexpr std::size_t largest_degree = 48;
        std::vector<std::size_t> rows;
        bool plain = true;
        for (std::size_t s = 0; s < moving_.size(); ++s) {
            if (moving_[s]) rows.push_back(s);
            for (const auto& [to, factor] : steps_[s])
                plain = plain && value_is_plain(factor.exponents);
        }
        if (!plain) return;
        std::optional<Number> mu;
        if (rows.size() == 1 && field_.degree() <= largest_degree) {
            mu = field_.rational(0);
            for (const auto& [to, factor] : steps_[rows[0]]) mu = field_.sum(*mu, factor.number);
        } else if (std::abs(mu_.imag()) < 1e-10) {
            for (long below = 1; below <= 24 && !mu; ++below) {
                const double above = mu_.real() * static_cast<double>(below);
                if (std::abs(above) < 1e6 && std::abs(above - std::round(above)) < 1e-9)
                    mu = field_.rational(Rational(std::lround(above), below));
            }
        }
        if (!mu || field_.is_zero(*mu)) return;
        // The kernel of the matrix less mu, by elimination.
        const std::size_t size = rows.size();
        std::vector<std::vector<Number>> matrix(size,
                                                std::vector<Number>(size, field_.rational(0)));
        for (std::size_t i = 0; i < size; ++i) {
            for (const auto& [to, factor] : steps_[rows[i]]) {
                const auto j = static_cast<std::size_t>(std::find(rows.begin(), rows.end(), to) -
                                                        rows.begin());
                matrix[i][j] = field_.sum(matrix[i][j], factor.number);
            }
            matrix[i][i] = field_.difference(matrix[i][i], *mu);
        }
        std::vector<std::size_t> row_of(size, size);  // by column
        std::optional<std::size_t> free;
        for (std::size_t column = 0, first = 0; column < size; ++column) {
            std::size_t row = first;
            while (row < size && field_.is_zero(matrix[row][column])) ++row;
            if (row == size) {
                if (free) return;  // several solutions
                free = column;
                continue;
            }
            std::swap(matrix[row], matrix[first]);
            auto& pivot = matrix[first];
            const Number scale = field_.inverse(pivot[column]);
            for (Number& entry : pivot) entry = field_.product(entry, scale);
            for (auto& other : matrix)
                if (&other != &pivot && !field_.is_zero(other[column])) {
                    const Number times = other[column];
                    for (std::size_t k = 0; k < size; ++k)
                        other[k] = field_.difference(other[k], field_.product(times, pivot[k]));
                }
            row_of[column] = first++;
        }
        if (!free || std::abs(ways_[rows[*free]]) < 1e-9) return;
        // The free one is 1, and the doubles are scaled to it.
        const Complex scale = ways_[rows[*free]];
        exact_ways_.assign(moving_.size(), field_.rational(0));
        for (std::size_t k = 0; k < size; ++k)
            exact_ways_[rows[k]] =
                k == *free ? field_.rational(1)
                           : field_.difference(field_.rational(0), matrix[row_of[k]][*free]);
        for (std::size_t k = 0; k < size; ++k)
            if (std::abs(field_.to_complex(exact_ways_[rows[k]]) - ways_[rows[k]] / scale) > 1e-6)
                return;
        for (Complex& each : ways_) each /= scale;
        exact_mu_ = mu;
    }

    static bool value_is_plain(const Exponents& exponents) {
        return std::all_of(exponents.begin(), exponents.end(), [](int k) { return k == 0; });
    }

    Terms times_mu(const Terms& terms) const {
        Terms found;
        for (const auto& [key, number] : terms)
            for (const auto& [to, factor] : steps_[key.first])
                add(found, product({number, key.second}, factor),
                    {{{to, none()}, field_.rational(1)}});
        return found;
    }

    Complex value(const Terms& terms, double* size = nullptr) const {
        Complex found = 0;
        for (const auto& [key, number] : terms) {
            const Complex way = exact_mu_ ? 1 : ways_[key.first];
            const Complex term = field_.to_complex(number) * value(key.second) * way;
            found += term;
            if (size) *size += std::abs(term);
        }
        return found;
    }

    // Pieces.

    void find_parts() {
        parts_.resize(graph_.states.size());
        const Factor shrink = exact_mu_ ? inverse({*exact_mu_, none()}) : one();
        for (std::size_t s = 0; s < parts_.size(); ++s)
            if (inside_[s])
                walk(s, [&](const RatioGraph::Part& part, const Factor& factor,
                            const Terms& place) {
                    if (!inside_[part.state]) return;
                    Terms shift;
                    add(shift, shrink, place);
                    parts_[s].push_back({part.state, product(shrink, factor), std::move(shift)});
                });
    }

    Complex mu_power(long exponent) const {
        return exact_mu_ ? Complex(1) : std::pow(mu_, static_cast<double>(exponent));
    }

    Complex size_of(const Piece& piece) const { return value(piece.size) * mu_power(-piece.depth); }

    /// The first piece replaced by a part of it.
    Piece of_first(const Piece& pair, const Part& part) const {
        Piece found{part.state, pair.to, {}, exact_mu_ ? 0 : pair.depth - 1, {}};
        const Factor inverse_factor = inverse(part.factor);
        found.size = product(pair.size, inverse_factor);
        // (mu w - o) / c, times mu^max(depth - 1, 0)
        Terms shift = !exact_mu_ && pair.depth <= 0 ? times_mu(pair.shift) : pair.shift;
        Terms moved = part.shift;
        for (long k = 1; !exact_mu_ && k < pair.depth; ++k) moved = times_mu(moved);
        add(shift, one(), moved, true);
        add(found.shift, inverse_factor, shift);
        return found;
    }

    /// The second piece replaced by a part of it.
    Piece of_second(const Piece& pair, const Part& part) const {
        Piece found{pair.from,
                    part.state,
                    product(pair.size, part.factor),
                    exact_mu_ ? 0 : pair.depth + 1,
                    {}};
        // w + g mu^-(depth + 1) o, times mu^max(depth + 1, 0)
        found.shift = !exact_mu_ && pair.depth >= 0 ? times_mu(pair.shift) : pair.shift;
        Terms moved = part.shift;
        for (long k = pair.depth + 1; !exact_mu_ && k < 0; ++k) moved = times_mu(moved);
        add(found.shift, pair.size, moved);
        return found;
    }

    void find_discs() {
        constexpr int rounds = 4000;
        const std::size_t size = parts_.size();
        const Complex mu = exact_mu_ ? Complex(1) : mu_;
        struct Image {
            std::size_t from, to;
            Complex factor, shift;
        };
        std::vector<Image> images;
        std::vector<double> counts(size, 0);
        for (std::size_t s = 0; s < size; ++s)
            for (const Part& part : parts_[s]) {
                images.push_back({s, part.state, value(part.factor) / mu, value(part.shift) / mu});
                ++counts[s];
            }
        centres_.assign(size, 0);
        for (int round = 0; round < 200; ++round) {
            std::vector<Complex> next(size, 0);
            for (const Image& image : images)
                next[image.from] +=
                    (image.factor * centres_[image.to] + image.shift) / counts[image.from];
            centres_ = std::move(next);
        }
        radii_.assign(size, 0);
        double change = 1;
        for (int round = 0; round < rounds && change > 0; ++round) {
            std::vector<double> next(size, 0);
            change = 0;
            for (const Image& image : images)
                next[image.from] =
                    std::max(next[image.from], std::abs(image.factor * centres_[image.to] +
                                                        image.shift - centres_[image.from]) +
                                                   std::abs(image.factor) * radii_[image.to]);
            for (std::size_t s = 0; s < size; ++s)
                if (next[s] > radii_[s] * (1 + 1e-13) + 1e-300) change = 1;
            radii_ = std::move(next);
        }
        if (change > 0 ||
            !std::all_of(radii_.begin(), radii_.end(), [](double r) { return r < 1e9; }))
            throw Unknown{"parts do not become smaller"};
    }

    void visit(Piece pair) {
        const Complex factor = size_of(pair);
        double size = 0;
        const Complex scale = mu_power(-std::max(pair.depth, 0L));
        const Complex shift = value(pair.shift, &size) * scale;
        const double error = 1e-12 * (1 + size * std::abs(scale));
        if (pair.from == pair.to && std::abs(factor - 1.0) < margin &&
            std::abs(shift) < margin + error) {
            if (!pair.shift.empty() || pair.depth != 0 || !(pair.size == one()))
                throw Unknown{"two parts coincide, or nearly so"};
            coincide_ = true;
            return;
        }
        const double reach = radii_[pair.from] + std::abs(factor) * radii_[pair.to];
        if (std::abs(shift + factor * centres_[pair.to] - centres_[pair.from]) >
            reach * (1 + margin) + error + margin)
            return;
        if (error > margin) throw Unknown{"positions need too many digits"};
        const auto [place, is_new] = seen_.insert(std::move(pair));
        if (is_new) open_.push_back(&*place);
    }

    const RatioGraph& graph_;
    const Budget& budget_;
    std::int64_t directions_;
    CyclotomicField field_;
    std::vector<bool> inside_, moving_;
    std::vector<Rotation> turns_;
    std::vector<Complex> symbols_;
    std::map<std::string, std::size_t> ratios_;
    std::vector<std::vector<std::pair<std::size_t, Factor>>> steps_;
    Complex mu_;
    std::vector<Complex> ways_, centres_;
    std::optional<Number> exact_mu_;
    std::vector<Number> exact_ways_;
    std::vector<std::vector<Part>> parts_;
    std::vector<double> radii_;
    std::set<Piece> seen_;
    std::deque<const Piece*> open_;
    bool coincide_ = false;
};

}  // namespace

PartsApart parts_apart(const RatioGraph& graph, const std::vector<std::size_t>& component,
                       const std::vector<bool>& drawing, const Budget& budget, std::size_t most) {
    PartsApart found;
    try {
        return NeighbourMaps(graph, component, drawing, budget).result(most);
    } catch (const Unknown& unknown) {
        found.reason = unknown.reason;
    } catch (const Error& error) {
        found.reason = error.what();
    }
    return found;
}

}  // namespace algae
