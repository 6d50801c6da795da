#include <algorithm>
#include <map>
#include <set>

#include "automatic/detail/relations.hpp"

// Counting by automata: how many numbers make a tuple with n is a product of matrices, one for each digit of n. What such sequences are for all n is
// proved by linear algebra over the rationals.

namespace algae {

namespace {

using Vector = std::vector<Integer>;
using Matrix = std::vector<Vector>;

Vector times(const Vector& row, const Matrix& matrix) {
    Vector found(matrix.empty() ? 0 : matrix.front().size(), 0);
    for (std::size_t i = 0; i < row.size(); ++i) {
        if (row[i].is_zero()) continue;
        for (std::size_t k = 0; k < found.size(); ++k)
            if (!matrix[i][k].is_zero()) found[k] += row[i] * matrix[i][k];
    }
    return found;
}

Integer times(const Vector& left, const Vector& right) {
    Integer sum = 0;
    for (std::size_t i = 0; i < left.size(); ++i) sum += left[i] * right[i];
    return sum;
}

/// Rows in echelon form.
class Space {
public:
    /// Whether the vector was not in it; then it is added.
    bool add(const Vector& one) {
        std::vector<Rational> row;
        for (const Integer& entry : one) row.emplace_back(entry);
        for (const auto& [pivot, other] : rows_) {
            if (row[pivot].is_zero()) continue;
            const Rational scale = row[pivot];
            for (std::size_t k = pivot; k < row.size(); ++k)
                if (!other[k].is_zero()) row[k] = row[k] - scale * other[k];
        }
        for (std::size_t pivot = 0; pivot < row.size(); ++pivot) {
            if (row[pivot].is_zero()) continue;
            const Rational scale = row[pivot];
            for (std::size_t k = pivot; k < row.size(); ++k) row[k] = row[k] / scale;
            rows_.emplace(pivot, std::move(row));
            return true;
        }
        return false;
    }

private:
    std::map<std::size_t, std::vector<Rational>> rows_;
};

}  // namespace

Integer LinearRepresentation::value(const Numeration& numeration, const Integer& n) const {
    Vector row = begin;
    for (const std::uint32_t digit : numeration.digits(n)) row = times(row, matrices[digit]);
    return times(row, end);
}

LinearRepresentation counts(const AutomaticRelation& relation, const std::string& n,
                            const Numeration& numeration) {
    const auto& variables = relation.variables;
    if (variables.size() != 2 || std::ranges::count(variables, n) == 0)
        throw Error("expected a relation of two numbers, one of them " + n +
                    ", to count the other");
    const std::uint32_t base = numeration.base();
    const bool is_first = variables.front() == n;
    LinearRepresentation found;
    const std::size_t states = relation.states();
    found.begin.assign(states, 0);
    found.begin[0] = 1;
    found.matrices.assign(base, Matrix(states, Vector(states, 0)));
    for (std::size_t s = 0; s < states; ++s) {
        found.end.emplace_back(relation.accepting[s] ? 1 : 0);
        for (std::uint32_t e = relation.first[s]; e < relation.first[s + 1]; ++e) {
            const auto [column, target] = relation.edges[e];
            found.matrices[is_first ? column % base : column / base][s][target] += 1;
        }
    }
    // The other number may have more digits than n: paths over zeros of n from the first state on, all of them once.
    for (std::size_t i = 0; i <= states; ++i) {
        Vector next = times(found.begin, found.matrices[0]);
        if (next == found.begin) return found;
        found.begin = std::move(next);
    }
    throw Error("infinitely many numbers belong to one " + n + ", so they cannot be counted");
}

namespace {

/// The sum of representations, each times a number.
LinearRepresentation combination(
    const std::vector<std::pair<Integer, LinearRepresentation>>& parts) {
    LinearRepresentation sum;
    std::size_t size = 0;
    for (const auto& [factor, part] : parts) size += part.size();
    sum.matrices.assign(parts.front().second.matrices.size(), Matrix(size, Vector(size, 0)));
    std::size_t at = 0;
    for (const auto& [factor, part] : parts) {
        for (const Integer& one : part.begin) sum.begin.push_back(one * factor);
        sum.end.insert(sum.end.end(), part.end.begin(), part.end.end());
        for (std::size_t d = 0; d < sum.matrices.size(); ++d)
            for (std::size_t i = 0; i < part.size(); ++i)
                for (std::size_t k = 0; k < part.size(); ++k)
                    sum.matrices[d][at + i][at + k] = part.matrices[d][i][k];
        at += part.size();
    }
    return sum;
}

/// Calls `visit` with the vectors of numbers and the states where their digits end, breadth first, until it says that nothing
/// new comes from one.
template <class Visit>
void walk(const LinearRepresentation& sequence, const Numeration& numeration, Visit visit) {
    std::vector<std::pair<std::uint32_t, Vector>> queue{{0, sequence.begin}};
    visit(0, sequence.begin, ~std::size_t{0}, 0);
    for (std::size_t i = 0; i < queue.size(); ++i) {
        const auto [state, row] = queue[i];
        for (std::uint32_t d = 0; d < numeration.image(state).size(); ++d) {
            if (i == 0 && d == 0) continue;  // zeros before the digits change nothing
            const std::uint32_t to = numeration.image(state)[d];
            Vector next = times(row, sequence.matrices[d]);
            if (visit(to, next, i, d)) queue.emplace_back(to, std::move(next));
        }
    }
}

/// The values of a sequence that has finitely many, each with the set of numbers n where it is taken; nothing if more than `most` vectors
/// come.
std::optional<std::vector<std::pair<Integer, AutomaticRelation>>> value_sets(
    const LinearRepresentation& sequence, const Numeration& numeration, Relations& relations,
    std::size_t most, const Budget& budget) {
    // Vectors that give the same values for all digits behind are one: coordinates along a basis of what the ends give.
    std::vector<Vector> basis;
    {
        Space space;
        std::vector<Vector> queue{sequence.end};
        for (std::size_t i = 0; i < queue.size(); ++i) {
            budget.check();
            if (!space.add(queue[i])) continue;
            const Vector column = queue[i];
            basis.push_back(column);
            for (const Matrix& matrix : sequence.matrices) {
                Vector next;
                for (const Vector& row : matrix) next.push_back(times(row, column));
                queue.push_back(std::move(next));
            }
        }
    }
    const auto seen_as = [&](const Vector& row) {
        Vector found;
        for (const Vector& column : basis) found.push_back(times(row, column));
        return found;
    };
    std::map<std::pair<std::uint32_t, Vector>, std::uint32_t> numbers;
    std::vector<std::vector<AutomaticRelation::Edge>> edges;
    std::vector<Integer> values;
    std::vector<std::uint32_t> of_step;  // the number of the vector at each step of the walk
    bool too_many = false;
    walk(sequence, numeration,
         [&](std::uint32_t state, const Vector& row, std::size_t from, std::uint32_t digit) {
             budget.check();
             if (too_many) return false;
             const auto [at, is_new] = numbers.emplace(std::pair(state, seen_as(row)),
                                                       static_cast<std::uint32_t>(edges.size()));
             if (is_new) {
                 edges.emplace_back();
                 values.push_back(times(row, sequence.end));
                 of_step.push_back(at->second);
             }
             if (from == ~std::size_t{0})
                 edges[0].push_back({0, 0});
             else
                 edges[of_step[from]].push_back({digit, at->second});
             too_many = edges.size() > most;
             return is_new && !too_many;
         });
    if (too_many) return std::nullopt;
    std::vector<std::pair<Integer, AutomaticRelation>> found;
    for (const Integer& value : std::set<Integer>(values.begin(), values.end())) {
        RawAutomaton set;
        for (std::size_t s = 0; s < edges.size(); ++s) {
            set.edges.insert(set.edges.end(), edges[s].begin(), edges[s].end());
            set.close(values[s] == value);
        }
        found.emplace_back(value, relations.minimal(set, {"n"}));
    }
    return found;
}

/// What holds for all n of the numbers of i that `places`, a relation of i and n, has.
ComplexityProof proof_of(const AutomaticRelation& places, Relations& relations,
                         const Numeration& numeration, const Budget& budget) {
    ComplexityProof found;
    found.sequence = counts(places, "n", numeration);
    const LinearRepresentation difference = combination(
        {{1, counts(relations.one_more(places, "n"), "n", numeration)}, {-1, found.sequence}});
    constexpr std::size_t most = 5'000;
    const auto values = value_sets(difference, numeration, relations, most, budget);
    if (!values) return found;
    for (const auto& [value, set] : *values) found.differences.push_back(value);
    // The first number from which on a set holds all numbers with a property; nothing if there is none.
    const auto from_of = [&](const AutomaticRelation& set, const AutomaticRelation& wanted) {
        std::optional<Integer> from = Integer(0);
        const AutomaticRelation missing = relations.both(wanted, relations.complement(set));
        if (missing.empty()) return from;
        // The greatest number that is missing, if there is one: one above all others.
        const AutomaticRelation above = relations.renamed(missing, {{"n", "m"}});
        const AutomaticRelation greater =
            relations.without(relations.both(above, relations.less("n", "m", false)), {"m"});
        const AutomaticRelation last = relations.both(missing, relations.complement(greater));
        if (last.empty()) return std::optional<Integer>();
        return std::optional(relations.witness(last).front().second + Integer(1));
    };
    for (const auto& [value, set] : *values) {
        const auto from = from_of(set, relations.all({"n"}));
        if (!from) continue;
        found.linear = {value, found.sequence.value(numeration, *from) - value * *from, *from};
    }
    constexpr int longest_period = 12;
    const auto sets = value_sets(found.sequence, numeration, relations, most, budget);
    if (!sets || (found.linear && found.linear->slope.is_zero())) return found;
    for (int period = 2; period <= longest_period && !found.periodic; ++period) {
        ComplexityProof::Periodic guess{std::vector<Integer>(static_cast<std::size_t>(period)), 0};
        bool holds = true;
        for (int rest = 0; rest < period && holds; ++rest) {
            const std::string part = relations.fresh();
            const AutomaticRelation wanted =
                relations.without(relations.sum({{{part, period}}, rest}, "n"), {part});
            holds = false;
            for (const auto& [value, set] : *sets) {
                const auto from = from_of(set, wanted);
                if (!from) continue;
                holds = true;
                guess.values[static_cast<std::size_t>(rest)] = value;
                guess.from = std::max(guess.from, *from);
            }
        }
        if (holds) found.periodic = std::move(guess);
    }
    return found;
}

}  // namespace

CountingAnswer decide_counting(const CountingStatement& statement, const AutomaticWord& word,
                               const Budget& budget) {
    Relations relations(word, budget, {});
    const std::string late = "n >= " + to_string(statement.from);
    const auto relation = [&](const FirstOrderStatement& places) {
        return relations.over(decide_first_order(places, word, budget).relation, {"i", "n"});
    };
    const auto read = [&](const std::string& text) {
        return relation(read_first_order(text, "counting", "T", word.letters));
    };
    std::vector<std::pair<Integer, LinearRepresentation>> sum;
    const auto add = [&](const Integer& times, const AutomaticRelation& places) {
        if (!times.is_zero()) sum.emplace_back(times, counts(places, "n", word.numeration));
    };
    for (const auto& [times, places] : statement.parts)
        add(times, relations.both(relation(places), read(late + " and i >= 0")));
    add(statement.slope, read(late + " and i < n"));
    add(statement.constant, read(late + " and i = 0"));
    if (sum.empty()) return {};
    const LinearRepresentation all = combination(sum);
    CountingAnswer found;
    found.size = all.size();
    std::vector<Space> spaces(word.numeration.letters().size());
    std::vector<Integer> reached;  // the numbers whose vectors are looked at
    walk(all, word.numeration,
         [&](std::uint32_t state, const Vector& row, std::size_t from, std::uint32_t digit) {
             budget.check();
             const bool is_zero = from == ~std::size_t{0};
             if (found.fails || (!spaces[state].add(row) && !is_zero)) return false;
             std::vector<std::uint32_t> digits;
             if (!is_zero) {
                 digits = word.numeration.digits(reached[from]);
                 digits.push_back(digit);
             }
             reached.push_back(*word.numeration.value(digits));
             const Integer value = times(row, all.end);
             if (!value.is_zero()) {
                 found.fails = reached.back();
                 found.sum = value;
             }
             return true;
         });
    return found;
}

ComplexityProofs complexity_proofs(const AutomaticWord& word, const Budget& budget) {
    const auto relation = [&](const std::string& statement) {
        return decide_first_order(read_first_order(statement, "complexity", "T", word.letters),
                                  word, budget)
            .relation;
    };
    Relations relations(word, budget, {});
    const AutomaticRelation first = relation(
        "not for some j, d with d >= 1 and j + d = i: for all u with j <= u < j + n: "
        "T[u] = T[u + d]");
    const auto proof = [&](const AutomaticRelation& places) {
        return proof_of(places, relations, word.numeration, budget);
    };
    return {proof(first), proof(relations.both(first, relation("palindrome(i, n)")))};
}

namespace {

constexpr WordProperty properties[] = {
    {"square-free", "not for some i, n with n >= 1: equal(i, i + n, n)"},
    {"overlap-free", "not for some i, n with n >= 1: equal(i, i + n, n + 1)"},
    {"cube-free", "not for some i, n with n >= 1: equal(i, i + n, 2n)"},
    {"aperiodic", "not for some i, n with n >= 1: for all k with k >= i: T[k] = T[k + n]"},
    {"recurrent", "for all i, n: for some j with j > i: equal(i, j, n)"},
    {"uniformly recurrent",
     "for all n: for some m: for all i, j: for some k with j <= k <= j + m: equal(i, k, n)"},
    {"closed under reversal",
     "for all i, n: for some s with s + 1 >= i + n: for all u, v with i <= u < i + n and "
     "u + v = s: T[u] = T[v]"},
    {"rich",
     "for all n with n >= 1: for some m with 1 <= m <= n: (for some i with i + m = n: "
     "palindrome(i, m)) and not (for some j with j + m < n: for all i with i + m = n: "
     "equal(i, j, m))"},
};

}  // namespace

std::span<const WordProperty> word_properties() { return properties; }

bool has_property(const AutomaticWord& word, std::string_view name, const Budget& budget) {
    for (const WordProperty& one : properties)
        if (one.name == name) {
            const FirstOrderStatement statement =
                read_first_order(one.says, std::string(name), "T", word.letters);
            return decide_first_order(statement, word, budget).holds;
        }
    throw Error("expected the name of a property of infinite words, found '" + std::string(name) +
                "'");
}

}  // namespace algae
