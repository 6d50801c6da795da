#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "automatic/detail/relations.hpp"

// The relations that statements begin with: sums, orders and letters.
//
// A sum is decided while digits come in, greatest first. Let a digit skip letters with Parikh vector p, so that it adds |h^i(p)| to its number if i
// digits follow. The vector s of what is owed becomes M s + (sum of coefficients times p), and in the end 1^T s must be 0. Only
// t_j = 1^T M^j s matter, for j below the degree m of the recurrence of the lengths: t_j becomes t_(j+1) + 1^T M^j p, and the last one the recurrence
// of all. Along the left eigenvector of the recurrence the vector grows by its greatest root, so that what is too far away never comes back.
// How far is too far is guessed here; whether all sums were found is checked: every choice of numbers must have one.

namespace algae {

namespace {

struct HashOfVector {
    std::size_t operator()(const std::vector<std::int64_t>& all) const {
        std::uint64_t hash = 1469598103934665603u;
        for (const std::int64_t one : all) {
            hash = (hash ^ static_cast<std::uint64_t>(one)) * 1099511628211u;
            hash ^= hash >> 29;
        }
        return hash;
    }
};

/// Numbers vectors in the order in which they come.
class NumberedVectors {
public:
    std::uint32_t number(const std::vector<std::int64_t>& one) {
        const auto [at, is_new] = numbers_.emplace(one, static_cast<std::uint32_t>(all.size()));
        if (is_new) all.push_back(one);
        return at->second;
    }
    std::vector<std::vector<std::int64_t>> all;

private:
    std::unordered_map<std::vector<std::int64_t>, std::uint32_t, HashOfVector> numbers_;
};

/// Integers c with row = c_0 rows[0] + c_1 rows[1] + ...; nothing if the rows do not span it.
std::optional<std::vector<Integer>> combination(const std::vector<std::vector<Integer>>& rows,
                                                const std::vector<Integer>& row) {
    const std::size_t unknowns = rows.size(), equations = row.size();
    std::vector<std::vector<Rational>> matrix(equations, std::vector<Rational>(unknowns + 1));
    for (std::size_t e = 0; e < equations; ++e) {
        for (std::size_t u = 0; u < unknowns; ++u) matrix[e][u] = Rational(rows[u][e]);
        matrix[e][unknowns] = Rational(row[e]);
    }
    std::size_t rank = 0;
    for (std::size_t u = 0; u < unknowns; ++u) {
        std::size_t pivot = rank;
        while (pivot < equations && matrix[pivot][u].is_zero()) ++pivot;
        if (pivot == equations)
            return std::nullopt;  // the rows are independent, so this does not happen
        std::swap(matrix[pivot], matrix[rank]);
        const Rational scale = matrix[rank][u];
        for (Rational& entry : matrix[rank]) entry = entry / scale;
        for (std::size_t e = 0; e < equations; ++e) {
            if (e == rank || matrix[e][u].is_zero()) continue;
            const Rational times = matrix[e][u];
            for (std::size_t k = 0; k <= unknowns; ++k)
                matrix[e][k] = matrix[e][k] - times * matrix[rank][k];
        }
        ++rank;
    }
    for (std::size_t e = rank; e < equations; ++e)
        if (!matrix[e][unknowns].is_zero()) return std::nullopt;
    std::vector<Integer> found;
    for (std::size_t u = 0; u < unknowns; ++u) {
        if (!matrix[u][unknowns].is_integer()) return std::nullopt;
        found.push_back(matrix[u][unknowns].numerator());
    }
    return found;
}

}  // namespace

/// The recurrence of the lengths, and its greatest root.
struct Relations::Sums {
    std::vector<std::vector<std::int64_t>> lengths;  // of h^i(letter), by i below the degree
    std::vector<std::int64_t> recurrence;            // the row of degree m of those below it
    double root = 0;
    std::vector<double> eigenvector;  // left one, of the recurrence
    std::vector<std::vector<std::vector<std::int64_t>>>
        skipped;  // by state, digit, i: |h^i(skipped)|

    explicit Sums(const Numeration& numeration);

    double along(const std::int64_t* values) const {
        double sum = 0;
        for (std::size_t i = 0; i < eigenvector.size(); ++i)
            sum += eigenvector[i] * static_cast<double>(values[i]);
        return sum;
    }
};

Relations::Sums::Sums(const Numeration& numeration) {
    const std::size_t letters = numeration.letters().size();
    std::vector<std::vector<Integer>> rows{std::vector<Integer>(letters, 1)};
    std::optional<std::vector<Integer>> found;
    while (true) {
        std::vector<Integer> next(letters, 0);
        for (std::uint32_t s = 0; s < letters; ++s)
            for (const std::uint32_t child : numeration.image(s)) next[s] += rows.back()[child];
        found = combination(rows, next);
        if (found) break;
        rows.push_back(next);
    }
    std::vector<Integer> coefficients;
    for (const Integer& one : *found) coefficients.push_back(-one);
    coefficients.push_back(1);
    const Polynomial polynomial(coefficients);
    constexpr long bits = 128;
    std::size_t outside = 0;
    bool others_inside = true;
    for (const Root& one : roots(polynomial, bits)) {
        const Ball size = one.real * one.real + one.imaginary * one.imaginary;
        const Order order = compare(size, Ball(1, bits));
        if (order == Order::greater && one.is_real && one.multiplicity == 1 &&
            one.real.midpoint() > 0) {
            ++outside;
            root = one.real.midpoint();
        } else if (order != Order::less) {
            others_inside = false;
        }
    }
    if (outside != 1 || !others_inside)
        throw Error(
            "addition is not known to be regular in the numeration of this word: the lengths of "
            "its images "
            "follow the recurrence of " +
            to_string(polynomial) +
            ", whose roots are not one Pisot number, greater than 1 with all others inside the "
            "unit circle");
    const auto small = [](const Integer& one) {
        if (!one.fits_int64() || one > Integer(1'000'000'000) || one < Integer(-1'000'000'000))
            throw Error("the images of this word are too long for sums of positions");
        return one.to_int64();
    };
    for (const Integer& one : *found) recurrence.push_back(small(one));
    for (const auto& row : rows) {
        lengths.emplace_back();
        for (const Integer& one : row) lengths.back().push_back(small(one));
    }
    eigenvector.assign(rows.size(), 1);
    for (std::size_t i = rows.size() - 1; i > 0; --i)
        eigenvector[i - 1] = root * eigenvector[i] - static_cast<double>(recurrence[i]);
    for (std::uint32_t s = 0; s < letters; ++s) {
        skipped.emplace_back();
        std::vector<std::int64_t> before(rows.size(), 0);
        for (const std::uint32_t child : numeration.image(s)) {
            skipped.back().push_back(before);
            for (std::size_t i = 0; i < rows.size(); ++i) before[i] += lengths[i][child];
        }
    }
}

const Relations::Sums& Relations::sums() {
    if (!sums_) sums_ = std::make_shared<Sums>(numeration_);
    return *sums_;
}

Polynomial Relations::recurrence() {
    std::vector<Integer> coefficients;
    for (const std::int64_t one : sums().recurrence) coefficients.emplace_back(-one);
    coefficients.push_back(1);
    return Polynomial(std::move(coefficients));
}

AutomaticRelation Relations::bounded_sum(const std::vector<std::int64_t>& coefficients,
                                         std::int64_t constant, double bound) {
    const Sums& how = sums();
    const std::size_t tracks = coefficients.size(), degree = how.recurrence.size();
    std::vector<std::uint32_t> weight(tracks, 1);
    for (std::size_t v = 1; v < tracks; ++v) weight[v] = weight[v - 1] * numeration_.base();
    NumberedVectors states;
    states.number(std::vector<std::int64_t>(tracks + degree, 0));
    RawAutomaton raw;
    for (std::size_t i = 0; i < states.all.size(); ++i) {
        if (i % 256 == 0) count(states.all.size(), raw.edges.size());
        const std::vector<std::int64_t> state = states.all[i];
        std::vector<std::int64_t> moved(degree);
        for (std::size_t j = 0; j + 1 < degree; ++j) moved[j] = state[tracks + j + 1];
        for (std::size_t j = 0; j < degree; ++j)
            moved[degree - 1] += how.recurrence[j] * state[tracks + j];
        std::vector<std::uint32_t> digits(tracks, 0);
        while (true) {
            std::vector<std::int64_t> next(tracks + degree);
            std::copy(moved.begin(), moved.end(),
                      next.begin() + static_cast<std::ptrdiff_t>(tracks));
            std::uint32_t column = 0;
            for (std::size_t v = 0; v < tracks; ++v) {
                const auto from = static_cast<std::uint32_t>(state[v]);
                next[v] = numeration_.image(from)[digits[v]];
                column += digits[v] * weight[v];
                for (std::size_t j = 0; j < degree; ++j)
                    next[tracks + j] += coefficients[v] * how.skipped[from][digits[v]][j];
            }
            if (std::abs(how.along(next.data() + tracks)) <= bound)
                raw.edges.push_back({column, states.number(next)});
            std::size_t v = 0;
            while (v < tracks &&
                   ++digits[v] == numeration_.image(static_cast<std::uint32_t>(state[v])).size())
                digits[v++] = 0;
            if (v == tracks) break;
        }
        raw.close(state[tracks] + constant == 0);
    }
    std::vector<std::string> names;
    for (std::size_t v = 0; v < tracks; ++v) names.push_back("x" + std::to_string(v));
    return minimal(raw, names);
}

AutomaticRelation Relations::direct_sum(const std::vector<std::int64_t>& coefficients,
                                        std::int64_t constant) {
    std::vector<std::int64_t> key = coefficients;
    key.push_back(constant);
    if (const auto at = known_.find(key); at != known_.end()) return at->second;
    const Sums& how = sums();
    double most = 0;
    for (const auto& of_state : how.skipped)
        for (const auto& of_digit : of_state)
            most = std::max(most, std::abs(how.along(of_digit.data())));
    double sizes = 0;
    for (const std::int64_t one : coefficients) sizes += static_cast<double>(std::abs(one));
    std::vector<std::string> addends;
    for (std::size_t v = 0; v + 1 < coefficients.size(); ++v)
        addends.push_back("x" + std::to_string(v));
    const std::string total = "x" + std::to_string(coefficients.size() - 1);
    const AutomaticRelation numbers = all(addends);
    double last = 0;
    for (const double one : how.eigenvector) last += std::abs(one);
    for (double slack = 2; slack <= 64; slack *= 2) {
        const double bound = slack * (sizes * most / (how.root - 1) +
                                      last * static_cast<double>(std::abs(constant)));
        AutomaticRelation found = bounded_sum(coefficients, constant, bound);
        if (without(found, {total}) == numbers) return known_[key] = found;
    }
    throw Error("a sum of positions was not found to be regular in the numeration of this word");
}

AutomaticRelation Relations::exactly(const Integer& number, const std::string& variable) {
    const std::vector<std::uint32_t> digits = numeration_.digits(number);
    RawAutomaton raw;
    for (std::uint32_t i = 0; i <= digits.size(); ++i) {
        if (i == 0) raw.edges.push_back({0, 0});
        if (i < digits.size()) raw.edges.push_back({digits[i], i + 1});
        raw.close(i == digits.size());
    }
    return minimal(raw, {variable});
}

AutomaticRelation Relations::less(const std::string& left, const std::string& right,
                                  bool or_equal) {
    if (left == right) return or_equal ? all({left}) : both(constant(false), all({left}));
    const std::uint32_t base = numeration_.base();
    const bool is_first = left < right;
    // (b, none): the same digits so far; (b, c): the left one is smaller already.
    NumberedVectors states;
    states.number({0, -1});
    RawAutomaton raw;
    for (std::size_t i = 0; i < states.all.size(); ++i) {
        const std::vector<std::int64_t> state = states.all[i];
        const auto b = static_cast<std::uint32_t>(state[0]);
        const bool is_less = state[1] >= 0;
        const std::uint32_t c = is_less ? static_cast<std::uint32_t>(state[1]) : b;
        for (std::uint32_t x = 0; x < numeration_.image(b).size(); ++x)
            for (std::uint32_t y = is_less ? 0 : x; y < numeration_.image(c).size(); ++y) {
                const std::int64_t to = numeration_.image(b)[x], other = numeration_.image(c)[y];
                raw.edges.push_back(
                    {is_first ? x + y * base : y + x * base,
                     states.number({to, is_less || x != y ? other : std::int64_t{-1}})});
            }
        raw.close(is_less || or_equal);
    }
    return minimal(raw, is_first ? std::vector{left, right} : std::vector{right, left});
}

AutomaticRelation Relations::equal(const std::string& left, const std::string& right) {
    RawAutomaton raw;
    for (std::uint32_t s = 0; s < numeration_.letters().size(); ++s) {
        for (std::uint32_t digit = 0; digit < numeration_.image(s).size(); ++digit)
            raw.edges.push_back({digit + digit * numeration_.base(), numeration_.image(s)[digit]});
        raw.close(true);
    }
    std::vector<std::string> names{left, right};
    std::ranges::sort(names);
    return minimal(raw, names);
}

AutomaticRelation Relations::same_letter(const std::string& left, const std::string& right,
                                         bool same) {
    if (left == right) return same ? all({left}) : both(constant(false), all({left}));
    const auto letters = static_cast<std::uint32_t>(numeration_.letters().size());
    RawAutomaton raw;
    for (std::uint32_t b = 0; b < letters; ++b)
        for (std::uint32_t c = 0; c < letters; ++c) {
            for (std::uint32_t x = 0; x < numeration_.image(b).size(); ++x)
                for (std::uint32_t y = 0; y < numeration_.image(c).size(); ++y)
                    raw.edges.push_back(
                        {x + y * numeration_.base(),
                         numeration_.image(b)[x] * letters + numeration_.image(c)[y]});
            raw.close((word_.letters[b] == word_.letters[c]) == same);
        }
    std::vector<std::string> names{left, right};
    std::ranges::sort(names);
    return minimal(raw, names);
}

AutomaticRelation Relations::letter_is(const std::string& at, const std::string& letter, bool is) {
    return numbers(at, [&](std::uint32_t state) { return (word_.letters[state] == letter) == is; });
}

AutomaticRelation Relations::sum(LinearTerm term, const std::string& total) {
    auto& [coefficients, constant] = term;
    constexpr int greatest = 8;  // coefficient and constant that one automaton takes
    AutomaticRelation parts = Relations::constant(true);
    std::set<std::string> helpers;
    const auto helper = [&](LinearTerm part) {
        const std::string name = fresh();
        helpers.insert(name);
        parts = both(parts, sum(std::move(part), name));
        return name;
    };
    if (coefficients.empty()) return exactly(constant, total);
    if (constant > greatest) {
        coefficients[helper({{}, constant})] = 1;
        constant = 0;
    }
    for (auto at = coefficients.begin(); at != coefficients.end();) {
        if (at->second <= greatest) {
            ++at;
            continue;
        }
        const auto [name, times] = *at;  // greatest times a part of it, and what is left over
        at = coefficients.erase(at);
        const Integer part = floor_divide(times, greatest), rest = times - part * Integer(greatest);
        coefficients[helper({{{name, part}}})] = greatest;
        if (!rest.is_zero()) coefficients[name] = rest;
        at = coefficients.begin();
    }
    while (coefficients.size() > 2) {
        const auto one = *coefficients.begin();
        coefficients.erase(coefficients.begin());
        const auto other = *coefficients.begin();
        coefficients.erase(coefficients.begin());
        coefficients[helper({{one, other}})] = 1;
    }
    AutomaticRelation found;
    const auto& [first, times] = *coefficients.begin();
    if (coefficients.size() == 1 && times == 1 && constant.is_zero()) {
        if (first == total) return all({total});
        found = equal(first, total);
    } else {
        std::vector<std::int64_t> key;
        std::map<std::string, std::string> names;
        for (const auto& [name, of_one] : coefficients) {
            names["x" + std::to_string(key.size())] = name;
            key.push_back(of_one.to_int64());
        }
        names["x" + std::to_string(key.size())] = total;
        key.push_back(-1);
        found = renamed(direct_sum(key, constant.to_int64()), names);
    }
    return helpers.empty() ? found : without(both(parts, found), helpers);
}

AutomaticRelation Relations::equation(const LinearTerm& term) {
    if (term.coefficients.empty()) return constant(term.constant.is_zero());
    const auto [left, right] = term.sides();
    if (right.variable()) return sum(left, *right.variable());
    if (left.variable()) return sum(right, *left.variable());
    const std::string total = fresh();
    return without(both(sum(left, total), sum(right, total)), {total});
}

}  // namespace algae
