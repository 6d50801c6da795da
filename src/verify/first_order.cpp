#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "exact/exact.hpp"
#include "verify/detail/checking.hpp"
#include "verify/verify.hpp"

// First-order statements about the infinite word h(h(h(...(a)...))) of a D0L system, worked out again.
//
// A number is the path to the letter at that position: digit d under a letter b skips d letters of h(b). Paths of one length
// are in the order of the numbers, which gives `less` and the next number. Addition is an automaton of the certificate. It is
// checked by induction: x + 0 is x; from x + y = z follows x + (y + 1) = z + 1; and no x and y have two sums. All else is made of
// these by products, complements and projections.

namespace algae::verify {

namespace {

using Kind = Formula::Kind;

constexpr std::uint32_t none = ~std::uint32_t{0};

/// The letters of the word as states, the first one first.
struct Paths {
    std::vector<Symbol> letters;
    std::vector<std::vector<std::uint32_t>> images;
    std::uint64_t base = 1;  // digits are below it

    Paths(const System& system, const Obligation& task) {
        if (!is_d0l(system)) task.refuse("the system is not D0L");
        const System::Successors& rules = system.tables[0];
        if (system.axiom.empty()) task.refuse("the axiom is empty");
        Symbol first = system.axiom[0];
        for (std::size_t i = 0; i < rules.size(); ++i) first = head(rules, first, task);
        if (head(rules, first, task) != first)
            task.refuse("no word of the system begins with the one before it for ever");
        if (rules[first][0].size() < 2) task.refuse("the first letter does not grow");
        letters = {first};
        for (std::size_t i = 0; i < letters.size(); ++i) {
            const Word& image = rules[letters[i]][0];
            if (image.empty()) task.refuse("a letter of the word is erased");
            images.emplace_back();
            for (const Symbol b : image) {
                const auto known = std::find(letters.begin(), letters.end(), b);
                images.back().push_back(static_cast<std::uint32_t>(known - letters.begin()));
                if (known == letters.end()) letters.push_back(b);
            }
            base = std::max<std::uint64_t>(base, image.size());
        }
    }

private:
    static Symbol head(const System::Successors& rules, Symbol a, const Obligation& task) {
        if (rules[a][0].empty()) task.refuse("a letter of the word is erased");
        return rules[a][0][0];
    }
};

/// Tuples of numbers, whose digits an automaton reads at once, greatest first; state 0 is the first one, a transition may be
/// missing. It reads paths alone, and zeros before the digits change nothing.
struct Tuples {
    struct Edge {
        std::uint32_t column = 0;  // the digit of name i times base^i, summed
        std::uint32_t to = 0;
        auto operator<=>(const Edge&) const = default;
    };
    std::vector<std::string> names;        // increasing
    std::vector<std::vector<Edge>> edges;  // by state, increasing
    std::vector<char> accepting;           // by state

    std::uint32_t next(std::uint32_t state, std::uint32_t column) const {
        const auto& out = edges[state];
        const auto at = std::lower_bound(out.begin(), out.end(), Edge{column, 0});
        return at != out.end() && at->column == column ? at->to : none;
    }
};

class Automata {
public:
    Automata(const Paths& paths, const Budget& budget) : paths_(paths), budget_(budget) {}

    /// Of all tuples, by what is asked of the letters where the paths end.
    Tuples all(std::vector<std::string> names,
               const std::function<bool(const std::vector<std::uint32_t>& letters)>& accepts) {
        Tuples found;
        found.names = std::move(names);
        check_names(found.names.size());
        Numbering<std::vector<std::uint32_t>> states;
        states.of(std::vector<std::uint32_t>(found.names.size(), 0));
        for (std::size_t s = 0; s < states.size(); ++s) {
            const auto at = states[s];
            found.accepting.push_back(accepts(at));
            found.edges.emplace_back();
            std::uint64_t count = 1;
            for (const std::uint32_t letter : at) count *= paths_.images[letter].size();
            make_room(found, 2 * count);
            std::vector<std::pair<std::uint32_t, std::vector<std::uint32_t>>> columns{{0, {}}};
            for (std::size_t i = 0; i < at.size(); ++i) {
                const auto before = std::move(columns);
                columns.clear();
                const auto& image = paths_.images[at[i]];
                for (const auto& [column, to] : before)
                    for (std::uint32_t d = 0; d < image.size(); ++d) {
                        auto longer = to;
                        longer.push_back(image[d]);
                        columns.emplace_back(column + d * weight(i), std::move(longer));
                    }
            }
            for (const auto& [column, to] : columns)
                found.edges.back().push_back({column, states.of(to)});
            close(found);
        }
        return minimal(std::move(found));
    }

    /// x is below y: the paths are the same up to a letter of which x takes an earlier one; `at_most` allows y itself.
    Tuples less(const std::string& x, const std::string& y, bool at_most) {
        return ordered(
            x, y, [&](bool apart) { return apart || at_most; }, false);
    }
    /// y is the number after x: from where they part x takes the last letters and y the first ones.
    Tuples successor(const std::string& x, const std::string& y) {
        return ordered(
            x, y, [](bool apart) { return apart; }, true);
    }

    Tuples both(const Tuples& left, const Tuples& right) {
        Tuples found;
        std::set_union(left.names.begin(), left.names.end(), right.names.begin(), right.names.end(),
                       std::back_inserter(found.names));
        const Placing of_left(*this, left, right, found), of_right(*this, right, left, found);
        Numbering<std::pair<std::uint32_t, std::uint32_t>> states;
        states.of({0, 0});
        for (std::size_t s = 0; s < states.size(); ++s) {
            const auto [p, q] = states[s];
            found.accepting.push_back(left.accepting[p] && right.accepting[q]);
            found.edges.emplace_back();
            auto& out = found.edges.back();
            const auto& one = of_left.edges(p);
            const auto& other = of_right.edges(q);
            for (std::size_t i = 0, j = 0; i < one.size() && j < other.size();) {
                if (one[i].shared < other[j].shared) {
                    ++i;
                    continue;
                }
                if (other[j].shared < one[i].shared) {
                    ++j;
                    continue;
                }
                std::size_t end = j;
                for (; end < other.size() && other[end].shared == one[i].shared; ++end) {
                    out.push_back(
                        {one[i].whole + other[end].own, states.of({one[i].to, other[end].to})});
                    if (out.size() % 65'536 == 0) make_room(found, out.size());
                }
                ++i;
                if (i == one.size() || one[i].shared != other[j].shared) j = end;
            }
            close(found);
        }
        return minimal(std::move(found));
    }

    Tuples complement(const Tuples& one) {
        const Tuples whole = all(one.names, [](const auto&) { return true; });
        Tuples found;
        found.names = one.names;
        Numbering<std::pair<std::uint32_t, std::uint32_t>> states;
        states.of({0, 0});
        for (std::size_t s = 0; s < states.size(); ++s) {
            const auto [p, q] = states[s];
            found.accepting.push_back(whole.accepting[p] && (q == none || !one.accepting[q]));
            found.edges.emplace_back();
            for (const auto& [column, to] : whole.edges[p])
                found.edges.back().push_back(
                    {column, states.of({to, q == none ? none : one.next(q, column)})});
            close(found);
        }
        return minimal(std::move(found));
    }

    /// The tuples that are left when these names go.
    Tuples without(const Tuples& one, const std::set<std::string>& gone) {
        Tuples found;
        std::vector<std::size_t> place;  // of each name that stays
        for (std::size_t i = 0; i < one.names.size(); ++i)
            if (!gone.contains(one.names[i])) {
                found.names.push_back(one.names[i]);
                place.push_back(i);
            }
        if (place.size() == one.names.size()) return one;
        const auto rest = [&](std::uint32_t column) {
            std::uint64_t kept = 0;
            for (std::size_t k = 0; k < place.size(); ++k)
                kept += digit(column, place[k]) * weight(k);
            return static_cast<std::uint32_t>(kept);
        };
        std::set<std::uint32_t> start{0};  // and what zeros lead to: what goes may have more digits
        for (std::vector<std::uint32_t> open{0}; !open.empty();) {
            const std::uint32_t s = open.back();
            open.pop_back();
            for (const auto& [column, to] : one.edges[s])
                if (rest(column) == 0 && start.insert(to).second) open.push_back(to);
        }
        Numbering<std::vector<std::uint32_t>> sets;
        sets.of({start.begin(), start.end()});
        for (std::size_t s = 0; s < sets.size(); ++s) {
            const auto now = sets[s];
            std::map<std::uint32_t, std::vector<std::uint32_t>> next;
            bool accepts = false;
            for (const std::uint32_t state : now) {
                accepts = accepts || one.accepting[state];
                for (const auto& [column, to] : one.edges[state]) next[rest(column)].push_back(to);
            }
            found.accepting.push_back(accepts);
            found.edges.emplace_back();
            for (auto& [column, targets] : next) {
                std::sort(targets.begin(), targets.end());
                targets.erase(std::unique(targets.begin(), targets.end()), targets.end());
                const std::size_t known = sets.size(), members = targets.size();
                found.edges.back().push_back({column, sets.of(std::move(targets))});
                if (sets.size() > known) kept_ += members;
            }
            close(found);
        }
        return minimal(std::move(found));
    }

    /// The same with other names, of which several may become one.
    Tuples renamed(const Tuples& one, const std::map<std::string, std::string>& to) {
        Tuples found;
        for (const std::string& name : one.names) found.names.push_back(to.at(name));
        std::sort(found.names.begin(), found.names.end());
        found.names.erase(std::unique(found.names.begin(), found.names.end()), found.names.end());
        std::vector<std::size_t> place;
        for (const std::string& name : one.names)
            place.push_back(static_cast<std::size_t>(
                std::find(found.names.begin(), found.names.end(), to.at(name)) -
                found.names.begin()));
        found.accepting = one.accepting;
        for (const auto& out : one.edges) {
            found.edges.emplace_back();
            for (const auto& [column, target] : out) {
                std::vector<std::uint64_t> digits(found.names.size(), none);
                bool same = true;
                for (std::size_t i = 0; i < place.size(); ++i) {
                    std::uint64_t& known = digits[place[i]];
                    same = same && (known == none || known == digit(column, i));
                    known = digit(column, i);
                }
                if (!same) continue;
                std::uint64_t moved = 0;
                for (std::size_t i = 0; i < digits.size(); ++i) moved += digits[i] * weight(i);
                found.edges.back().push_back({static_cast<std::uint32_t>(moved), target});
            }
            close(found);
        }
        return minimal(std::move(found));
    }

    bool empty(const Tuples& one) const {
        return std::count(one.accepting.begin(), one.accepting.end(), char{1}) ==
               0;  // of a minimal one
    }

    /// The minimal automaton without states from which nothing is accepted; the first one always stays.
    Tuples minimal(Tuples one) const {
        const std::size_t size = one.edges.size();
        std::vector<std::vector<std::uint32_t>> into(size);
        for (std::uint32_t s = 0; s < size; ++s)
            for (const auto& edge : one.edges[s]) into[edge.to].push_back(s);
        std::vector<char> lives(size, 0);
        std::vector<std::uint32_t> open;
        for (std::uint32_t s = 0; s < size; ++s)
            if (one.accepting[s]) {
                lives[s] = 1;
                open.push_back(s);
            }
        while (!open.empty()) {
            const std::uint32_t s = open.back();
            open.pop_back();
            for (const std::uint32_t before : into[s])
                if (!lives[before]) {
                    lives[before] = 1;
                    open.push_back(before);
                }
        }
        for (auto& out : one.edges)
            std::erase_if(out, [&](const Tuples::Edge& edge) { return !lives[edge.to]; });
        // Classes are split by where their edges lead until none is.
        std::vector<std::uint32_t> of(one.accepting.begin(), one.accepting.end());
        for (std::size_t before = 0;;) {
            budget_.check();
            Numbering<std::vector<std::uint32_t>> classes;
            std::vector<std::uint32_t> now(size);
            for (std::size_t s = 0; s < size; ++s) {
                std::vector<std::uint32_t> kind{of[s]};
                for (const auto& [column, to] : one.edges[s]) {
                    kind.push_back(column);
                    kind.push_back(of[to]);
                }
                now[s] = classes.of(std::move(kind));
            }
            of = std::move(now);
            if (classes.size() == before) break;
            before = classes.size();
        }
        Tuples found;
        found.names = std::move(one.names);
        Numbering<std::uint32_t> kept;
        std::vector<std::uint32_t> some(size);  // a state of each class
        for (std::uint32_t s = 0; s < size; ++s) some[of[s]] = s;
        kept.of(of[0]);
        for (std::size_t s = 0; s < kept.size(); ++s) {
            const std::uint32_t state = some[kept[s]];
            found.accepting.push_back(one.accepting[state]);
            found.edges.emplace_back();
            for (const auto& [column, to] : one.edges[state])
                found.edges.back().push_back({column, kept.of(of[to])});
        }
        return found;
    }

    std::uint32_t weight(std::size_t i) const {
        std::uint64_t found = 1;
        for (std::size_t k = 0; k < i; ++k) found *= paths_.base;
        return static_cast<std::uint32_t>(found);
    }
    std::uint64_t digit(std::uint32_t column, std::size_t i) const {
        return column / weight(i) % paths_.base;
    }
    /// Throws BoundReached where the columns of so many names are too many.
    void check_names(std::size_t count) const {
        std::uint64_t columns = 1;
        for (std::size_t i = 0; i < count; ++i)
            if ((columns *= paths_.base) > std::uint64_t{1} << 24)
                throw BoundReached(Bound::method, "automata that read " + std::to_string(count) +
                                                      " numbers at once are not worked out again");
    }

private:
    /// Values numbered in the order in which they come.
    template <class Value>
    class Numbering {
    public:
        std::uint32_t of(Value value) {
            const auto [at, is_new] =
                numbers_.try_emplace(std::move(value), static_cast<std::uint32_t>(order_.size()));
            if (is_new) order_.push_back(&at->first);
            return at->second;
        }
        std::size_t size() const { return order_.size(); }
        const Value& operator[](std::size_t i) const { return *order_[i]; }

    private:
        std::map<Value, std::uint32_t> numbers_;
        std::vector<const Value*> order_;
    };

    /// The edges of one relation where it meets another: what both read first.
    class Placing {
    public:
        struct Placed {
            std::uint32_t shared, own, whole, to;
            auto operator<=>(const Placed&) const = default;
        };
        Placing(const Automata& automata, const Tuples& one, const Tuples& other,
                const Tuples& merged)
            : edges_(one.edges.size()) {
            automata.check_names(merged.names.size());
            for (std::size_t s = 0; s < one.edges.size(); ++s) {
                for (const auto& [column, to] : one.edges[s]) {
                    Placed placed{0, 0, 0, to};
                    for (std::size_t i = 0; i < one.names.size(); ++i) {
                        const auto at =
                            std::find(merged.names.begin(), merged.names.end(), one.names[i]);
                        const auto place = static_cast<std::size_t>(at - merged.names.begin());
                        const auto part = static_cast<std::uint32_t>(automata.digit(column, i) *
                                                                     automata.weight(place));
                        const bool is_shared =
                            std::count(other.names.begin(), other.names.end(), one.names[i]) > 0;
                        (is_shared ? placed.shared : placed.own) += part;
                        placed.whole += part;
                    }
                    edges_[s].push_back(placed);
                }
                std::sort(edges_[s].begin(), edges_[s].end());
            }
        }
        const std::vector<Placed>& edges(std::uint32_t state) const { return edges_[state]; }

    private:
        std::vector<std::vector<Placed>> edges_;
    };

    /// The relation of x and y in the state (letter, letter, whether they have parted).
    Tuples ordered(const std::string& x, const std::string& y,
                   const std::function<bool(bool apart)>& accepts, bool is_next) {
        Tuples found;
        found.names = {std::min(x, y), std::max(x, y)};
        check_names(2);
        const std::uint32_t of_x = weight(x < y ? 0 : 1), of_y = weight(x < y ? 1 : 0);
        using State = std::tuple<std::uint32_t, std::uint32_t, bool>;
        Numbering<State> states;
        states.of({0, 0, false});
        for (std::size_t s = 0; s < states.size(); ++s) {
            const auto [b, c, apart] = states[s];
            found.accepting.push_back(accepts(apart));
            found.edges.emplace_back();
            const auto& left = paths_.images[b];
            const auto& right = paths_.images[c];
            make_room(found, left.size() * right.size());
            for (std::uint32_t d = 0; d < left.size(); ++d)
                for (std::uint32_t e = 0; e < right.size(); ++e) {
                    const bool fits = !is_next ? apart || d <= e
                                      : apart  ? d + 1 == left.size() && e == 0
                                               : d == e || d + 1 == e;
                    if (fits)
                        found.edges.back().push_back(
                            {d * of_x + e * of_y, states.of({left[d], right[e], apart || d < e})});
                }
            close(found);
        }
        return minimal(std::move(found));
    }

    /// Ends the edges of the last state.
    void close(Tuples& one) {
        std::sort(one.edges.back().begin(), one.edges.back().end());
        if (one.edges.size() == 1) kept_ = seen_ = 0;
        kept_ += one.edges.back().size();
        if (one.edges.size() % 256 == 0 || kept_ > seen_ + 65'536) {
            seen_ = kept_;
            budget_.check();
            budget_.check_memory(kept_ * 64, "the automata");
        }
    }
    /// Before the last state, which has no edges yet, gets so many.
    void make_room(const Tuples& one, std::uint64_t edges) const {
        const std::uint64_t before = one.edges.size() == 1 ? 0 : kept_;
        budget_.check();
        budget_.check_memory((before + edges) * 64, "the automata");
    }

    const Paths& paths_;
    const Budget& budget_;
    std::uint64_t kept_ = 0;  // edges and members of sets of the automaton on the way
    std::uint64_t seen_ = 0;  // of these when the bounds were looked at
};

/// The statement as automata, part by part.
class Working {
public:
    Working(const Obligation& task, const Paths& paths)
        : task_(task), paths_(paths), automata_(paths, task.budget) {
        for (const Symbol a : paths.letters) {
            const auto& coding = task.statement.coding;
            const auto coded = coding.find(a);
            letters_.push_back(coded == coding.end() ? task.alphabet().name(a) : coded->second);
        }
    }

    bool holds(const Formula& formula) { return !automata_.empty(evaluate(formula, false)); }

    /// Whether the sum is 0 for all n from `from` on.
    ///
    /// A row has, for each state of the automata of places, how many numbers i reach it beside the digits of n so far, and a digit of n moves it
    /// as a matrix does. What a row gives is linear, so rows in the span of others give 0 if those do; and behind one letter the
    /// same digits follow.
    bool sums_to_zero(const CountedPlaces& counted) {
        std::vector<Tuples> places;
        std::vector<Integer> factors;
        const Formula early{Kind::less, {{{{"n", 1}}, -counted.from}}};
        const auto add = [&](const Integer& times, const Formula& formula) {
            if (times.is_zero()) return;
            Block block;
            collect(formula, false, block);
            collect(early, true, block);
            block.relations.push_back(automata_.all({"i", "n"}, [](const auto&) { return true; }));
            places.push_back(solved(std::move(block)));
            factors.push_back(times);
        };
        for (const auto& [times, formula] : counted.parts) add(times, formula);
        add(counted.slope, Formula{Kind::less, {{{{"i", 1}, {"n", -1}}, 0}}});
        add(counted.plus, Formula{Kind::equation, {{{{"i", 1}}, 0}}});
        std::vector<std::size_t> begins{0};  // of each automaton in a row
        for (const Tuples& one : places) begins.push_back(begins.back() + one.edges.size());
        using Row = std::vector<Integer>;
        const auto moved = [&](const Row& row, std::uint64_t digit) {
            Row found(row.size(), 0);
            for (std::size_t k = 0; k < places.size(); ++k)
                for (std::size_t s = 0; s < places[k].edges.size(); ++s)
                    if (const Integer& here = row[begins[k] + s]; !here.is_zero())
                        for (const auto& [column, to] : places[k].edges[s])
                            if (automata_.digit(column, 1) == digit) found[begins[k] + to] += here;
            return found;
        };
        const auto value = [&](const Row& row) {
            Integer sum = 0;
            for (std::size_t k = 0; k < places.size(); ++k)
                for (std::size_t s = 0; s < places[k].edges.size(); ++s)
                    if (places[k].accepting[s]) sum += factors[k] * row[begins[k] + s];
            return sum;
        };
        Row first(begins.back(), 0);
        for (std::size_t k = 0; k < places.size(); ++k) first[begins[k]] = 1;
        for (std::size_t round = 0;; ++round) {  // digits of i before those of n
            const Row next = moved(first, 0);
            if (next == first) break;
            if (round > first.size()) task_.refuse("infinitely many places belong to some n");
            first = next;
        }
        std::vector<std::vector<Row>> independent(paths_.images.size());
        std::vector<std::pair<std::uint32_t, Row>> left{{0, first}};
        while (!left.empty()) {
            task_.budget.check();
            const auto [letter, row] = std::move(left.back());
            left.pop_back();
            if (!is_independent(row, independent[letter])) continue;
            if (!value(row).is_zero()) return false;
            const auto& image = paths_.images[letter];
            for (std::uint32_t d = 0; d < image.size(); ++d)
                left.emplace_back(image[d], moved(row, d));
        }
        return true;
    }

private:
    /// Whether a row is no combination of others, each of which begins with more zeros than the one before; then it joins them.
    static bool is_independent(std::vector<Integer> row,
                               std::vector<std::vector<Integer>>& others) {
        const auto begin = [](const std::vector<Integer>& one) {
            std::size_t zeros = 0;
            while (zeros < one.size() && one[zeros].is_zero()) ++zeros;
            return zeros;
        };
        auto at = others.begin();
        for (; at != others.end(); ++at) {
            const std::size_t here = begin(*at);
            if (begin(row) < here) break;
            if (row[here].is_zero()) continue;
            const Integer mine = row[here], its = (*at)[here];
            Integer common = 0;
            for (std::size_t k = here; k < row.size(); ++k) {
                row[k] = its * row[k] - mine * (*at)[k];
                common = gcd(common, row[k]);
            }
            if (common > 1)
                for (std::size_t k = here; k < row.size(); ++k)
                    if (!row[k].is_zero()) row[k] = floor_divide(row[k], common);
        }
        if (begin(row) == row.size()) return false;
        others.insert(at, std::move(row));
        return true;
    }

    /// Names that are bound, and relations that hold at once.
    struct Block {
        std::set<std::string> bound;
        std::vector<Tuples> relations;
        /// Names of sums, by what is added, and of numbers, by "" and the number.
        std::map<std::pair<std::string, std::string>, std::string> helpers;
    };

    Tuples evaluate(const Formula& formula, bool negated) {
        task_.budget.check();
        const bool is_quantifier = formula.kind == Kind::for_all || formula.kind == Kind::exists;
        if (is_quantifier && (formula.kind == Kind::for_all) != negated)
            return automata_.complement(evaluate(formula, !negated));
        Block block;
        collect(formula, negated, block);
        return solved(std::move(block));
    }

    /// That one of the parts holds, each with its sign.
    Tuples some_of(const std::vector<std::pair<const Formula*, bool>>& parts) {
        Block fail;
        for (const auto& [part, negated] : parts)
            fail.relations.push_back(evaluate(*part, !negated));
        return automata_.complement(solved(std::move(fail)));
    }

    void collect(const Formula& formula, bool negated, Block& block) {
        const auto& parts = formula.parts;
        const auto add = [&](Tuples one) { block.relations.push_back(std::move(one)); };
        switch (formula.kind) {
            case Kind::negation:
                return collect(parts[0], !negated, block);
            case Kind::conjunction:
            case Kind::disjunction: {
                if ((formula.kind == Kind::conjunction) != negated) {
                    for (const Formula& part : parts) collect(part, negated, block);
                    return;
                }
                std::vector<std::pair<const Formula*, bool>> some;
                for (const Formula& part : parts) some.emplace_back(&part, negated);
                return add(some_of(some));
            }
            case Kind::implication:
                if (!negated) return add(some_of({{&parts[0], true}, {&parts[1], false}}));
                collect(parts[0], false, block);
                return collect(parts[1], true, block);
            case Kind::equivalence:
                return add(equivalence(formula, negated));
            case Kind::exists:
            case Kind::for_all:
                if ((formula.kind == Kind::for_all) != negated)
                    return add(evaluate(formula, negated));
                block.bound.insert(formula.names.begin(), formula.names.end());
                return collect(parts[0], negated, block);
            case Kind::equation:
            case Kind::less: {
                const auto [left, right] = sides(formula.terms[0]);
                const std::string x = name_of(left, block), y = name_of(right, block);
                if (formula.kind == Kind::less)
                    return add(negated ? less(y, x, true) : less(x, y, false));
                return add(signed_by(same(x, y), negated));
            }
            case Kind::same_letter: {
                const std::string x = name_of(formula.terms[0], block),
                                  y = name_of(formula.terms[1], block);
                if (x == y) return add(automata_.all({x}, [&](const auto&) { return !negated; }));
                return add(automata_.all({std::min(x, y), std::max(x, y)}, [&](const auto& at) {
                    return (letters_[at[0]] == letters_[at[1]]) != negated;
                }));
            }
            case Kind::letter:
                return add(automata_.all({name_of(formula.terms[0], block)}, [&](const auto& at) {
                    return (letters_[at[0]] == formula.letter) != negated;
                }));
            case Kind::equal:
            case Kind::palindrome:
                return add(signed_by(factors(formula, block), negated));
        }
    }

    Tuples signed_by(Tuples one, bool negated) { return negated ? automata_.complement(one) : one; }

    /// So many parts are false as makes an even number; negated: an odd number.
    Tuples equivalence(const Formula& formula, bool negated) {
        Tuples found = evaluate(formula.parts[0], negated);
        for (std::size_t i = 1; i < formula.parts.size(); ++i) {
            const Tuples next = evaluate(formula.parts[i], false);
            const auto neither_of = [&](const Tuples& one, const Tuples& other) {
                return automata_.both(automata_.complement(one), automata_.complement(other));
            };
            found = automata_.complement(
                neither_of(automata_.both(found, next), neither_of(found, next)));
        }
        return found;
    }

    Tuples less(const std::string& x, const std::string& y, bool at_most) {
        if (x == y) return automata_.all({x}, [&](const auto&) { return at_most; });
        return automata_.less(x, y, at_most);
    }
    Tuples same(const std::string& x, const std::string& y) {
        if (x == y) return automata_.all({x}, [](const auto&) { return true; });
        return automata_.both(automata_.less(x, y, true), automata_.less(y, x, true));
    }

    /// The relation of equal factors of n letters at i and j, or of palindromes of n letters at i, for the terms.
    Tuples factors(const Formula& formula, Block& block) {
        const bool is_equal = formula.kind == Kind::equal;
        auto& known = is_equal ? equal_ : palindrome_;
        const std::vector<std::string> places =
            is_equal ? std::vector<std::string>{"i", "j", "n"} : std::vector<std::string>{"i", "n"};
        if (!known) known = is_equal ? equal_factors() : palindromes();
        std::map<std::string, std::string> names;
        for (std::size_t i = 0; i < places.size(); ++i)
            names[places[i]] = name_of(formula.terms[i], block);
        return automata_.renamed(*known, names);
    }

    static Formula with_parts(Kind kind, std::vector<Formula> parts) {
        Formula found{kind};
        found.parts = std::move(parts);
        return found;
    }
    static Formula some_with(std::vector<std::string> names, std::vector<Formula> parts) {
        Formula found = with_parts(Kind::exists, {with_parts(Kind::conjunction, std::move(parts))});
        found.names = std::move(names);
        return found;
    }
    static Formula at_least(const std::string& x, const std::string& least) {
        return with_parts(Kind::negation, {Formula{Kind::less, {{{{x, 1}, {least, -1}}, 0}}}});
    }
    static Formula different(LinearSum x, LinearSum y) {
        return with_parts(Kind::negation,
                          {Formula{Kind::same_letter, {std::move(x), std::move(y)}}});
    }

    /// Of factors at a distance d from each other no letter of the first one differs from that d places on.
    Tuples equal_factors() {
        const Tuples apart =
            evaluate(some_with({"u"}, {at_least("u", "i"),
                                       Formula{Kind::less, {{{{"u", 1}, {"i", -1}, {"n", -1}}, 0}}},
                                       different({{{"u", 1}}, 0}, {{{"d", 1}, {"u", 1}}, 0})}),
                     false);
        const auto placed = [&](const char* first, const char* second) {
            Block block;
            block.bound = {"d"};
            block.relations = {
                automata_.renamed(apart, {{"d", "d"}, {"i", first}, {"n", "n"}}),
                automata_.renamed(addition(), {{"x", first}, {"y", "d"}, {"z", second}})};
            return automata_.complement(solved(std::move(block)));
        };
        return automata_.both(placed("i", "j"), placed("j", "i"));
    }

    /// No two places of the factor whose sum is that of its ends have different letters.
    Tuples palindromes() {
        return automata_.complement(evaluate(
            some_with({"u", "v"},
                      {at_least("u", "i"), at_least("v", "i"),
                       Formula{Kind::equation, {{{{"u", 1}, {"v", 1}, {"i", -2}, {"n", -1}}, 1}}},
                       different({{{"u", 1}}, 0}, {{{"v", 1}}, 0})}),
            false));
    }

    /// What is added and what is taken away.
    static std::pair<LinearSum, LinearSum> sides(const LinearSum& sum) {
        std::pair<LinearSum, LinearSum> found;
        for (const auto& [name, times] : sum.of)
            (times > 0 ? found.first : found.second).of[name] = times > 0 ? times : -times;
        (sum.plus > 0 ? found.first : found.second).plus = sum.plus > 0 ? sum.plus : -sum.plus;
        return found;
    }

    /// A name for a sum with nothing negative in it, which always has a value.
    std::string name_of(const LinearSum& sum, Block& block) {
        std::string found;
        const auto join = [&](const std::string& next) {
            found = found.empty() ? next : plus(found, next, block);
        };
        for (const auto& [name, times] : sum.of) join(multiple(name, times, block));
        if (found.empty() || !sum.plus.is_zero()) join(number(sum.plus, block));
        return found;
    }
    std::string multiple(const std::string& name, const Integer& times, Block& block) {
        if (times == 1) return name;
        if (bit_length(times) > 300)
            throw BoundReached(Bound::method,
                               "multiples of more than 90 digits are not worked out again");
        const Integer half = floor_divide(times, 2);
        const std::string part = multiple(name, half, block);
        const std::string twice = plus(part, part, block);
        return half + half == times ? twice : plus(twice, name, block);
    }
    /// A name that is bound in the block, for a sum or a number, and whether it is new there.
    std::pair<std::string, bool> helper(const std::string& x, const std::string& y, Block& block) {
        const auto [at, is_new] = block.helpers.try_emplace({x, y});
        if (is_new) {
            at->second = "." + std::to_string(++helpers_);
            block.bound.insert(at->second);
        }
        return {at->second, is_new};
    }
    std::string plus(const std::string& x, const std::string& y, Block& block) {
        const auto [z, is_new] = helper(std::min(x, y), std::max(x, y), block);
        if (is_new)
            block.relations.push_back(
                automata_.renamed(addition(), {{"x", x}, {"y", y}, {"z", z}}));
        return z;
    }
    std::string number(const Integer& value, Block& block) {
        const auto [x, is_new] = helper("", to_string(value), block);
        if (is_new) block.relations.push_back(exactly(value, x));
        return x;
    }

    /// x is the number: after zeros its path, found by the lengths of the images of letters.
    Tuples exactly(Integer value, const std::string& x) {
        std::vector<std::vector<Integer>> lengths{std::vector<Integer>(paths_.images.size(), 1)};
        while (lengths.back()[0] <= value) {
            std::vector<Integer> longer;
            for (const auto& image : paths_.images) {
                Integer sum = 0;
                for (const std::uint32_t b : image) sum += lengths.back()[b];
                longer.push_back(sum);
            }
            lengths.push_back(std::move(longer));
            task_.budget.check();
        }
        Tuples found;
        found.names = {x};
        found.edges = {{{0, 0}}};
        std::uint32_t letter = 0;
        for (std::size_t power = lengths.size() - 1; power-- > 0;) {
            std::uint32_t digit = 0;
            const auto& image = paths_.images[letter];
            while (lengths[power][image[digit]] <= value) value -= lengths[power][image[digit++]];
            letter = image[digit];
            found.edges.back().push_back({digit, static_cast<std::uint32_t>(found.edges.size())});
            found.edges.emplace_back();
        }
        found.accepting.assign(found.edges.size(), 0);
        found.accepting.back() = 1;
        return automata_.minimal(std::move(found));
    }

    /// The automaton of x + y = z that the certificate has, checked.
    const Tuples& addition() {
        if (addition_) return *addition_;
        if (!task_.proof.has("addition"))
            task_.refuse("there is a sum in the statement, but no automaton of addition");
        const Field field = task_.proof.at("addition");
        const Tuples sums = automata_.both(
            read_addition(field), automata_.all({"x", "y", "z"}, [](const auto&) { return true; }));
        const auto named = [&](const char* x, const char* y, const char* z) {
            return automata_.renamed(sums, {{"x", x}, {"y", y}, {"z", z}});
        };
        const auto none_of = [&](std::vector<Tuples> at_once, const std::string& wrong) {
            Block block;
            block.relations = std::move(at_once);
            for (const Tuples& one : block.relations)
                block.bound.insert(one.names.begin(), one.names.end());
            if (!automata_.empty(solved(std::move(block)))) field.refuse(wrong);
        };
        if (sums.next(0, 0) != 0) field.refuse("zeros before the digits change what it accepts");
        const Tuples missing = automata_.complement(sums);
        none_of({same("x", "z"), exactly(0, "y"), missing}, "x + 0 is not always x");
        none_of({sums, automata_.successor("y", "y'"), automata_.successor("z", "z'"),
                 automata_.renamed(missing, {{"x", "x"}, {"y", "y'"}, {"z", "z'"}})},
                "x + y = z does not always give x + (y + 1) = z + 1");
        none_of({sums, named("x", "y", "z'"), less("z", "z'", false)},
                "some x and y have two sums");
        addition_ = sums;
        return *addition_;
    }

    Tuples read_addition(const Field& field) {
        field.only({"edges", "accepting"});
        Tuples found;
        found.names = {"x", "y", "z"};
        for (const Field& one : field.at("accepting").list())
            found.accepting.push_back(one.truth());
        found.edges.resize(found.accepting.size());
        const auto below = [](const Field& one, std::uint64_t end) {
            if (one.number() >= end) one.fail("expected a number below " + std::to_string(end));
            return static_cast<std::uint32_t>(one.number());
        };
        if (found.accepting.empty()) field.fail("expected a state");
        for (const Field& one : field.at("edges").list()) {
            const auto parts = one.list();
            if (parts.size() != 5) one.fail("expected a state, three digits and a state");
            std::uint32_t column = 0;
            for (std::size_t i = 0; i < 3; ++i)
                column += below(parts[i + 1], paths_.base) * automata_.weight(i);
            auto& out = found.edges[below(parts[0], found.edges.size())];
            for (const auto& edge : out)
                if (edge.column == column) one.refuse("a state has two edges with the same digits");
            out.push_back({column, below(parts[4], found.edges.size())});
        }
        for (auto& out : found.edges) std::sort(out.begin(), out.end());
        return automata_.minimal(std::move(found));
    }

    /// All relations at once, without the names that are bound: always the one whose relations are smallest together.
    Tuples solved(Block block) {
        auto& relations = block.relations;
        while (!block.bound.empty()) {
            task_.budget.check();
            const auto cost = [&](const std::string& name) {
                std::size_t sum = 0;
                for (const Tuples& one : relations)
                    if (std::binary_search(one.names.begin(), one.names.end(), name))
                        sum += size_of(one);
                return sum;
            };
            const std::string best = *std::min_element(
                block.bound.begin(), block.bound.end(),
                [&](const std::string& x, const std::string& y) { return cost(x) < cost(y); });
            block.bound.erase(best);
            const auto without =
                std::partition(relations.begin(), relations.end(), [&](const Tuples& one) {
                    return !std::binary_search(one.names.begin(), one.names.end(), best);
                });
            std::vector<Tuples> with(std::make_move_iterator(without),
                                     std::make_move_iterator(relations.end()));
            relations.erase(without, relations.end());
            if (with.empty()) continue;
            relations.push_back(automata_.without(joined(std::move(with)), {best}));
        }
        return joined(std::move(relations));
    }
    Tuples joined(std::vector<Tuples> some) {
        if (some.empty()) return automata_.all({}, [](const auto&) { return true; });
        std::sort(some.begin(), some.end(),
                  [](const Tuples& x, const Tuples& y) { return size_of(x) < size_of(y); });
        Tuples found = std::move(some.front());
        for (std::size_t i = 1; i < some.size(); ++i) found = automata_.both(found, some[i]);
        return found;
    }
    static std::size_t size_of(const Tuples& one) {
        std::size_t sum = 0;
        for (const auto& out : one.edges) sum += out.size();
        return sum;
    }

    const Obligation& task_;
    const Paths& paths_;
    Automata automata_;
    std::vector<std::string> letters_;  // by state: what the letter is called
    std::size_t helpers_ = 0;
    std::optional<Tuples> addition_, equal_, palindrome_;
};

}  // namespace

void check_first_order(const Obligation& task) {
    const Paths paths(task.system(), task);
    if (Working(task, paths).holds(*task.statement.first_order) != task.holds)
        task.refuse(task.holds ? "the statement is false of the word"
                               : "the statement is true of the word");
}

void check_counts(const Obligation& task) {
    const Paths paths(task.system(), task);
    if (Working(task, paths).sums_to_zero(*task.statement.counted) != task.holds)
        task.refuse(task.holds ? "the numbers differ for some n"
                               : "the numbers are equal for all n");
}

}  // namespace algae::verify
