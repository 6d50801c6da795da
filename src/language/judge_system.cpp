#include <algorithm>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>
#include <stdexcept>

#include "dimension/dimension.hpp"
#include "growth/growth.hpp"
#include "language/detail/judge.hpp"
#include "language/detail/proof.hpp"
#include "model/model.hpp"
#include "turtle/turtle.hpp"
#include "word/word.hpp"

// What statements say of systems: derivations, equal sequences, equal growth, classes of growth, dimensions, figures.
//
// A derivation in a given number of steps is decided by the table of factors with one table; with several, by a
// system that counts the steps in copies of its letters.
//
// What statements say of dimensions of limit sets and of their boundaries is by `exact_dimension`, and exactly: ratios of
// logarithms are compared exactly, the solution of an equation by enclosures that get narrower. Two numbers that agree in
// so many digits without a proof that they are equal leave the statement undecided.
//
// Different segments of a figure are counted by `outline`, whose points are numbers of Z[zeta_m], so that equal points have equal
// coordinates. What would make them inexact, or the drawing more than segments, is refused first. Squares are counted only
// where all segments lie along the axes, whose ends then are pairs of integers.

namespace algae {

namespace {

constexpr std::uint64_t most_steps_with_context = 100'000;

Answer too_many_steps() {
    return undecided("with contexts at most " + std::to_string(most_steps_with_context) +
                     " steps are followed");
}

/// Whether a system with context and choices derives the word in exactly so many steps: all words of each generation, of which too
/// long ones have no descendants that matter where no rule erases.
Answer chosen_walk(const SourceSystem& system, const Word& word, std::uint64_t steps,
                   const Budget& budget) {
    constexpr std::uint64_t most_letters = 50'000'000;
    if (steps > most_steps_with_context) return too_many_steps();
    const IL& rules = *system.interactive;
    const auto longest =
        is_propagating(rules) ? std::optional<std::size_t>(word.size()) : std::nullopt;
    ContextStep step(rules);
    std::vector<std::map<Word, Word>> levels(1);  // each word, and one that it comes from
    levels[0].emplace(rules.axiom, Word{});
    std::uint64_t letters = 0;
    for (std::uint64_t n = 0; n < steps; ++n) {
        std::map<Word, Word> next;
        for (const auto& [from, before] : levels.back()) {
            budget.check();
            for (Word& each : step.next(from, longest, budget)) {
                letters += each.size() + from.size() + 16;
                next.emplace(std::move(each), from);
            }
            if (letters > most_letters)
                return undecided("the words of " + std::to_string(n + 1) +
                                 " generations are too long or too many");
        }
        levels.push_back(std::move(next));
    }
    if (levels.back().count(word) == 0)
        return refuted(
            steps::DerivesNot{system.name, rules.axiom, word, steps, std::nullopt, true, false});
    Derivation walk{{word}, {}};
    for (std::size_t n = levels.size(); n-- > 1;) {
        Word before = levels[n].at(walk.words.back());
        walk.words.push_back(std::move(before));
    }
    std::reverse(walk.words.begin(), walk.words.end());
    return proved(steps::Derives{system.name, std::move(walk), true});
}

Answer walked(const SourceSystem& system, const Word& word, std::uint64_t steps,
              const Budget& budget) {
    if (!is_deterministic(*system.interactive)) return chosen_walk(system, word, steps, budget);
    if (steps > most_steps_with_context) return too_many_steps();
    const Word& from = system.interactive->axiom;
    Derivation walk{{from}, {}};
    for (std::uint64_t n = 0; n < steps; ++n) {
        budget.check();
        walk.words.push_back(next_word(*system.interactive, walk.words.back()));
        if (walk.words.back().size() > budget.letters)
            throw BoundReached(Bound::letters,
                               "a word of " + system.name + " has more letters than allowed");
    }
    if (walk.words.back() == word)
        return proved(steps::Derives{system.name, std::move(walk), true});
    return refuted(
        steps::DerivesNot{system.name, from, word, steps, walk.words.back(), true, false});
}

/// The only word that an 0L system derives in so many steps, if it is one and short.
std::optional<Word> only_word(const OL& rules, std::uint64_t steps) {
    constexpr std::size_t longest_shown = 60;
    Word reached = rules.axiom;
    for (std::uint64_t n = 0; n < steps && reached.size() <= longest_shown; ++n) {
        Word next;
        for (const Symbol a : reached) {
            if (rules.successors[a].size() != 1) return std::nullopt;
            next.insert(next.end(), rules.successors[a].front().begin(),
                        rules.successors[a].front().end());
        }
        reached = std::move(next);
    }
    return reached.size() <= longest_shown ? std::optional(reached) : std::nullopt;
}

/// Whether an 0L system derives the word in exactly so many steps, with the derivation.
Answer exact_steps(const std::string& name, const OL& rules, const Word& word, std::uint64_t steps,
                   const Budget& budget) {
    if (auto found = find_derivation(rules, word, steps, budget))
        return proved(steps::Derives{name, std::move(*found)});
    return refuted(
        steps::DerivesNot{name, rules.axiom, word, steps, only_word(rules, steps), false, false});
}

/// The system with a copy of each letter for each of so many steps; copies for the last are the terminals.
ET0L counting(const ET0L& system, std::size_t steps) {
    const std::size_t letters = system.terminal.size();
    const auto copies = [&](Word word, std::size_t n) {
        for (Symbol& a : word) a += static_cast<Symbol>(n * letters);
        return word;
    };
    Alphabet alphabet;
    for (std::size_t n = 0; n <= steps; ++n)
        for (Symbol a = 0; a < letters; ++a)
            alphabet.symbol(std::to_string(n) + " " + system.alphabet->name(a));
    ET0L counted{
        std::make_shared<const Alphabet>(std::move(alphabet)), system.axiom,       {},
        std::vector<char>(letters * (steps + 1), 0),           system.table_names, system.name};
    for (const Table& table : system.tables) {
        Table& target = counted.tables.emplace_back();
        for (std::size_t n = 0; n < steps; ++n)
            for (Symbol a = 0; a < letters; ++a) {
                auto& choices = target.emplace_back();
                for (const Word& successor : table[a]) choices.push_back(copies(successor, n + 1));
            }
        for (Symbol a = 0; a < letters; ++a) target.push_back({copies({a}, steps)});
    }
    for (Symbol a = 0; a < letters; ++a) counted.terminal[a + steps * letters] = 1;
    return counted;
}

/// The same where there are several tables: whether the counting system derives the word in copies for the last step.
Answer exact_steps_of_tables(const std::string& name, const ET0L& system, const Word& word,
                             std::uint64_t steps, const Budget& budget) {
    const std::size_t letters = system.terminal.size();
    if (steps > 1000) return undecided("with several tables at most 1000 steps are followed");
    const ET0L copies = counting(system, static_cast<std::size_t>(steps));
    Word goal = word;
    for (Symbol& a : goal) a += static_cast<Symbol>(steps * letters);
    const Membership found = membership(copies, goal, budget);
    if (!found.member)
        return refuted(
            steps::DerivesNot{name, system.axiom, word, steps, std::nullopt, false, true});
    Derivation witness = derivation(copies, goal, found, budget);
    for (; witness.words.size() <= steps; witness.tables.push_back(0))
        witness.words.emplace_back();  // ε stays ε
    for (Word& reached : witness.words)
        for (Symbol& a : reached) a %= static_cast<Symbol>(letters);
    return proved(steps::Derives{name, std::move(witness)});
}

}  // namespace

D0L as_d0l(const SourceSystem& system) {
    const auto refuse = [&](const std::string& reason) -> Error {
        return Error(system.name + " is not a D0L system: " + reason);
    };
    if (!system.tables) throw refuse("it has contexts");
    if (system.tables->tables.size() > 1) throw refuse("it has several tables");
    if (!has_only_terminals(*system.tables)) throw refuse("not all its letters are terminals");
    if (!is_deterministic(*system.tables)) throw refuse("a letter has several rules");
    std::vector<Word> images;
    for (const auto& choices : system.tables->tables.front()) images.push_back(choices.front());
    return make_d0l(system.tables->alphabet, system.tables->axiom, std::move(images), system.name);
}

Answer judge_derivation(const Derives& said, const Alphabet& alphabet, const Budget& budget) {
    const auto& [source, word, from, steps, bound_steps, numbers] = said;
    if (bound_steps) throw std::logic_error("the number of steps has no value");
    if (source->interactive) {
        SourceSystem moved = *source;
        if (from) moved.interactive->axiom = *from;
        if (steps) return walked(moved, word, *steps, budget);
        Answer found = from ? judge_generated(moved, word, alphabet, budget)
                            : judge_membership(generated_language(source), word, alphabet, budget);
        if (found.proof) found.proof = proof_by(steps::InSomeStep{found.proof});
        return found;
    }
    ET0L moved = *source->tables;
    if (from) moved.axiom = *from;
    moved.terminal.assign(moved.terminal.size(), 1);  // derivations go through any letters
    if (steps) {
        if (moved.tables.size() > 1)
            return exact_steps_of_tables(source->name, moved, word, *steps, budget);
        return exact_steps(source->name, without_terminals(moved), word, *steps, budget);
    }
    const Membership found = membership(moved, word, budget);
    if (!found.member) return refuted(steps::DerivesNot{source->name, moved.axiom, word});
    return proved(steps::Derives{source->name, derivation(moved, word, found, budget)});
}

Answer judge_sequences(const SourceSystem& left, const SourceSystem& right, const Budget& budget) {
    const SequenceEquality found = equal_sequences(as_d0l(left), as_d0l(right), budget);
    if (found.equal) return proved(steps::SameSequence{left.name, right.name, *found.balance});
    return refuted(steps::OtherSequence{left.name, right.name, *found.difference});
}

Answer judge_growth(const SourceSystem& left, const SourceSystem& right, const Budget& budget) {
    const GrowthComparison found = equal_growth(as_d0l(left), as_d0l(right), budget);
    if (found.equal) return proved(steps::SameGrowth{found.bound});
    return refuted(steps::OtherGrowth{*found.difference});
}

Answer judge_growth_class(const HasGrowthClass& said, const Budget& budget) {
    const GrowthOrder order = growth_class(as_d0l(*said.system), budget).order;
    return decided(to_string(order.kind) == said.growth &&
                       (!said.degree || Integer(order.degree) == *said.degree),
                   steps::Grows{said.system->name, order});
}

namespace {

/// The letters that occur in the word of a generation, for generations 0, 1, ... until a set comes again.
std::vector<std::set<Symbol>> letter_sets(const D0L& system, const Budget& budget) {
    std::vector<std::set<Symbol>> sets;
    std::set<std::set<Symbol>> seen;
    std::set<Symbol> now(system.axiom.begin(), system.axiom.end());
    while (seen.insert(now).second) {
        budget.check();
        sets.push_back(now);
        std::set<Symbol> next;
        for (const Symbol a : now) next.insert(system.rules[a].begin(), system.rules[a].end());
        now = std::move(next);
    }
    return sets;
}

}  // namespace

Answer judge_increasing(const IsIncreasing& said, const Budget& budget) {
    const D0L system = as_d0l(*said.system);
    const auto falls = [&](std::uint64_t generation, const Integer& before, const Integer& after) {
        return refuted(steps::Falls{said.system->name, generation, before, after, said.strictly});
    };
    if (is_propagating(system)) {
        if (!said.strictly) return proved(steps::Rises{said.system->name, false, 0});
        const auto sets = letter_sets(system, budget);
        for (std::size_t n = 0; n < sets.size(); ++n) {
            const bool rises = std::any_of(sets[n].begin(), sets[n].end(),
                                           [&](Symbol a) { return system.rules[a].size() > 1; });
            if (!rises) return falls(n, length(system, n, budget), length(system, n + 1, budget));
        }
        return proved(steps::Rises{said.system->name, true, sets.size()});
    }
    constexpr std::uint64_t most = 1000;
    const GrowthMatrix matrix = growth_matrix(system);
    const auto lifetime = lifetimes(matrix);
    std::vector<Integer> now = parikh_vector(system, 0, budget);
    for (std::uint64_t n = 0; n < most; ++n) {
        budget.check();
        const std::vector<Integer> next = now * matrix;
        const Integer before = std::accumulate(now.begin(), now.end(), Integer());
        const Integer after = std::accumulate(next.begin(), next.end(), Integer());
        if (after < before || (said.strictly && after == before)) return falls(n, before, after);
        bool each = true, one_lasts = !said.strictly;
        for (std::size_t i = 0; i < now.size(); ++i) {
            each = each && now[i] <= next[i];
            one_lasts = one_lasts || (now[i] < next[i] && !lifetime[i]);
        }
        if (each && one_lasts)
            return proved(steps::RisesByLetters{said.system->name, said.strictly, n});
        now = next;
    }
    return undecided("the first " + std::to_string(most) +
                     " lengths rise, and the system erases letters");
}

namespace {

using Status = ExactDimension::Status;

/// Exactly for ratios of logarithms; the solution of an equation is less or greater where enclosures
/// differ in that many digits.
Order compared(const DimensionFormula& formula, const DimensionValue& claimed) {
    if (const LogRatio* const ratio = formula.log_ratio()) return compare(*ratio, claimed);
    for (long bits = 64; bits <= digits_compared * 7; bits *= 2)
        if (const auto known = sign(formula.enclosure(bits) - claimed.enclosure(bits)))
            return *known < 0 ? Order::less : *known > 0 ? Order::greater : Order::equal;
    return Order::unknown;
}

/// Undecided, with how far the comparison went.
Answer open(const steps::LimitSet& said) {
    return {Truth::undecided, nullptr, sentences({Truth::undecided, proof_by(said), {}}, {})};
}

/// Whether a dimension that is so to a number is what is claimed of it.
bool is_claimed(Order order, Comparison comparison) {
    return order == Order::equal || (comparison == Comparison::at_most && order == Order::less) ||
           (comparison == Comparison::at_least && order == Order::greater);
}

/// What a number that is known exactly says of the claimed one.
Answer judge_exact(const DimensionFormula& value, steps::LimitSet said) {
    said.order = compared(value, *said.claimed.value);
    if (said.order == Order::unknown) return open(said);
    return decided(is_claimed(said.order, said.claimed.comparison), std::move(said));
}

/// What a bound says that is so to the claimed number; nothing where more must be known.
std::optional<Answer> judge_bound(steps::LimitSet said, bool from_above) {
    const bool is_beyond = said.order == (from_above ? Order::less : Order::greater);
    const bool agrees =
        said.claimed.comparison == (from_above ? Comparison::at_most : Comparison::at_least);
    if (!is_beyond && !(said.order == Order::equal && agrees)) return std::nullopt;
    return decided(agrees, std::move(said));
}

/// What an upper bound says.
Answer judge_bounded(steps::LimitSet said) {
    const DimensionValue& claimed = *said.claimed.value;
    said.order = exceeds_plane(*said.found) ? compare(DimensionValue(Rational(2)), claimed)
                                            : compared(*said.found->value, claimed);
    const auto answer = judge_bound(said, true);
    return answer ? *answer : open(said);
}

constexpr std::size_t few_ways = 5'000;  // in which parts meet
constexpr std::uint64_t few_steps = 2'000'000'000;

/// What certified bounds say, which come nearer until they decide or their steps are used up.
std::optional<Answer> judge_certified(steps::LimitSet said, const Model& system,
                                      const Budget& budget) {
    const DimensionValue& claimed = *said.claimed.value;
    std::optional<Answer> answer;
    Rational high = 3, low = -1;  // the last ones that were compared
    const BoundsSearch search{[&](const DimensionBounds& found) {
                                  for (const bool from_above : {true, false}) {
                                      Rational& last = from_above ? high : low;
                                      const Rational& bound = from_above ? found.high : found.low;
                                      if (answer || bound == last) continue;
                                      last = bound;
                                      said.order = compare(DimensionValue(bound), claimed);
                                      if (!judge_bound(said, from_above)) continue;
                                      said.bounds = std::make_shared<const DimensionBounds>(found);
                                      answer = judge_bound(said, from_above);
                                  }
                                  return answer.has_value();
                              },
                              few_steps};
    const DimensionBounds found = dimension_bounds(system, search, budget);
    search.is_enough(found);
    return answer;
}

/// What the rules say of the one limit set that a system has. Where chance has a part in it there are many, and a claim
/// is not decided by what is so of almost all of them.
ExactDimension of_one_set(ExactDimension found) {
    if (!found.almost_surely) return found;
    ExactDimension none;
    none.conditions.push_back("chance has a part in what it draws, so it has no one limit set");
    return none;
}

}  // namespace

bool exceeds_plane(const ExactDimension& found) {
    return compare(found.value->enclosure(64), Ball(2, 64)) == Order::greater;
}

Answer judge_dimension(const HasDimension& claimed, const Budget& budget) {
    const auto judged = [&](const ExactDimension& found) -> std::pair<Answer, steps::LimitSet> {
        steps::LimitSet said{claimed.name,
                             std::make_shared<const ExactDimension>(found),
                             false,
                             has_lattice_turtle(*claimed.system),
                             claimed.dimension,
                             Order::unknown,
                             {},
                             claimed.system};
        if (found.status == Status::exact) return {judge_exact(*found.value, said), said};
        if (found.status == Status::upper_bound) return {judge_bounded(said), said};
        return {open(said), said};
    };
    // A short search; what bounds say; the whole search. All are counted, none is timed: what is decided does not
    // depend on the machine.
    const auto [answer, said] =
        judged(of_one_set(exact_dimension(*claimed.system, budget, few_ways)));
    if (answer.truth != Truth::undecided || said.found->status != Status::upper_bound)
        return answer;
    if (const auto certified = judge_certified(said, *claimed.system, budget)) return *certified;
    return judged(of_one_set(exact_dimension(*claimed.system, budget))).first;
}

Answer judge_boundary(const BoundaryHasDimension& claimed, const Budget& budget) {
    const steps::LimitSet said{claimed.name,
                               std::make_shared<const ExactDimension>(
                                   of_one_set(exact_dimension(*claimed.system, budget))),
                               true,
                               has_lattice_turtle(*claimed.system),
                               claimed.dimension,
                               Order::unknown,
                               {},
                               claimed.system};
    return said.found->boundary ? judge_exact(*said.found->boundary, said) : open(said);
}

namespace {

constexpr std::int64_t largest_denominator = 360;  // of turns that Compass computes with exactly

bool is_of_quarters(const std::optional<Quantity>& degrees) {
    return !degrees || (degrees->exact && (*degrees->exact / Rational(90)).is_integer());
}

/// What a command does that a count of segments does not follow; empty for the others.
std::string hindrance(Command command) {
    switch (command) {
        case Command::open_polygon:
        case Command::close_polygon:
            return "fences a filled polygon, expected segments only";
        case Command::scale:
            return "changes the length of steps, expected steps of one length";
        case Command::cut:
            return "cuts branches, so that not all segments are drawn";
        default:
            return {};
    }
}

D0L lattice_rules(const Model& system) {
    const View<D0L> rules = as_d0l(static_cast<const LSystem&>(system));
    if (!rules) throw Error(rules.reason());
    return *rules;
}

/// The system as it is drawn where only differences of places matter: from the origin along +x.
Model from_origin(Model system) {
    system.drawing.start.reset();
    system.drawing.spin.reset();
    return system;
}

Outline lattice_figure(const Model& system, std::uint64_t n, const Budget& budget) {
    constexpr long most_segments = 1'000'000, most_letters = 50'000'000;
    const D0L rules = lattice_rules(system);
    const std::vector<Integer> counts = parikh_vector(rules, n, budget);
    if (drawn_segments(Commands(system, rules.letters), rules.letters, counts) >
            Integer(most_segments) ||
        std::accumulate(counts.begin(), counts.end(), Integer()) > Integer(most_letters))
        throw BoundReached(Bound::method, "figures of more than " + std::to_string(most_segments) +
                                              " segments or " + std::to_string(most_letters) +
                                              " letters are not drawn to count");
    Outline drawn = outline(system, n, budget);
    if (!drawn.lattice)
        throw Error("expected brackets that match in generation " + std::to_string(n));
    return drawn;
}

}  // namespace

void check_lattice_turtle(const Model& system, bool boxes) {
    const D0L rules = lattice_rules(system);
    const Drawing& drawing = system.drawing;
    const Commands commands(system, rules.letters);
    for (const Symbol letter : rules.letters)
        for (const Command command : commands.of(letter))
            if (const std::string why = hindrance(command); !why.empty()) {
                const std::string& name = system.alphabet.name(letter);
                throw Error("the letter " + name + " " + why + "; 'interpret " + name +
                            " -> ε' leaves that out");
            }
    if (!drawing.stamps.empty())
        throw Error("the letter " + system.alphabet.name(drawing.stamps.front().symbol) +
                    " leaves a filled shape, expected segments only, without 'stamp'");
    if (drawing.tropism)
        throw Error(
            "its steps bend, expected straight ones in given directions, without 'tropism'");
    const Quantity angle = drawing.angle.value_or(quantity(Rational(90)));
    const auto found = [&] { return ", found 'angle " + to_text(angle.expression) + "'"; };
    if (!angle.exact || !Compass(from_origin(system).drawing, 0).is_exact())
        throw Error(
            "expected a turtle that turns by a part of a full turn with a denominator up to " +
            std::to_string(largest_denominator) + ", such as 'angle 60' or 'angle 180/7'" +
            found());
    if (!boxes) return;
    if (!is_of_quarters(angle))
        throw Error(
            "boxes are counted of figures along the axes only: expected a turtle that turns "
            "by right angles, such as 'angle 90'" +
            found());
    if ((drawing.start && !is_of_quarters(drawing.start->heading)) || !is_of_quarters(drawing.spin))
        throw Error(
            "boxes are counted of figures along the axes only: expected a turtle that starts "
            "along an axis, such as 'start 0 0 90', and a 'spin' by right angles");
}

bool has_lattice_turtle(const Model& system) {
    try {
        check_lattice_turtle(system, false);
        return true;
    } catch (const Error&) {
        return false;
    }
}

Integer distinct_segments(const Model& system, std::uint64_t n, const Budget& budget) {
    check_lattice_turtle(system, false);
    return Integer(std::uint64_t{lattice_figure(from_origin(system), n, budget).strokes.size()});
}

Integer met_boxes(const Model& system, std::uint64_t n, const Rational& side,
                  const Budget& budget) {
    constexpr std::size_t most = 1'000'000;
    check_lattice_turtle(system, true);
    const Outline drawn = lattice_figure(system, n, budget);
    std::vector<std::pair<Integer, Integer>> corners;  // of the points, in squares
    for (const CyclotomicInteger& point : drawn.lattice->points)
        corners.emplace_back(floor(*drawn.lattice->ring.real_rational(point) / side),
                             floor(*drawn.lattice->ring.imaginary_rational(point) / side));
    std::set<std::pair<Integer, Integer>> met;
    for (const auto& [from, to] : drawn.strokes) {
        const auto &left = corners[from], &right = corners[to];
        for (Integer x = std::min(left.first, right.first); x <= std::max(left.first, right.first);
             x += Integer(1))
            for (Integer y = std::min(left.second, right.second);
                 y <= std::max(left.second, right.second); y += Integer(1)) {
                budget.check();
                met.emplace(x, y);
                if (met.size() > most)
                    throw BoundReached(Bound::method,
                                       "more than " + std::to_string(most) +
                                           " boxes are not counted; ask for larger ones");
            }
    }
    return Integer(std::uint64_t{met.size()});
}

nlohmann::ordered_json turtle_certificate(const Model& system) {
    const D0L rules = lattice_rules(system);
    const Commands commands(system, rules.letters);
    const auto part_of_turn = [](const std::optional<Quantity>& degrees, int otherwise) {
        const Rational turns =
            (degrees ? degrees->exact.value_or(Rational(0)) : Rational(otherwise)) / Rational(360);
        return turns - Rational(floor(turns));
    };
    const Drawing& drawing = system.drawing;
    Rational turn = part_of_turn(drawing.angle, 90);
    if (drawing.clockwise && !turn.is_zero()) turn = Rational(1) - turn;
    nlohmann::ordered_json letters = nlohmann::ordered_json::object();
    for (const Symbol letter : rules.letters) {
        std::string told;
        for (const Command command : commands.of(letter)) {
            static constexpr std::string_view names = "FFf+-|[]";  // of the first commands
            const auto place = static_cast<std::size_t>(command);
            if (place < names.size()) told += names[place];
        }
        if (!told.empty()) letters[system.alphabet.name(letter)] = told;
    }
    nlohmann::ordered_json written{{"turn", to_string(turn)}};
    const Rational heading =
        part_of_turn(drawing.start ? std::optional(drawing.start->heading) : std::nullopt, 0);
    const Rational spin = part_of_turn(drawing.spin, 0);
    if (!heading.is_zero()) written["heading"] = to_string(heading);
    if (!spin.is_zero()) written["spin"] = to_string(spin);
    written["letters"] = std::move(letters);
    return written;
}

}  // namespace algae
