#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "exact/exact.hpp"
#include "verify/detail/limit_set.hpp"
#include "verify/verify.hpp"

// The dimension of the limit set of a D0L system, from the rules and the turtle of the certificate.
//
// A letter in a phase is a piece; its parts are the letters of its successor that go on drawing, where
// the turns of letters are those of late generations, which come back after some phases. Let d_k be the
// ways of the letters of generation k. The certificate says by which number mu they grow, as a matrix of integers,
// with a matrix for the turn by one direction and a row of integers for the way of each piece. It is worked out
// again
// - that the matrices commute, that the turn has the order of a full turn, and that the ways obey the rules. So
//   there are complex numbers, one for each column, that make numbers of the rows, on which the matrices act as mu
//   and zeta = e^(2 pi i / order);
// - that mu^-k d_k tends to a multiple of the ways that is not 0: a polynomial with smaller roots, of the matrix of
//   the d_k, takes them to one, exactly. So the figures, made smaller by mu^-k, tend to the set with
//   mu K = union of zeta^heading K_part + offset;
// - that the discs of the certificate hold the pieces: those of the parts lie in those of the whole.
//
// The parts of a component multiply by the spectral radius r of its matrix, so log r / log |mu|, with the largest r of a
// component that is reached, is an upper bound of the dimensions. They are known exactly where the parts of a component meet in
// finitely many ways, the neighbours of the certificate, with the rate of its different parts (`limit_parts.cpp`); Mauldin and Williams
// 1988, Bandt and Graf 1992. Bounds that a certificate names are searched for again, and so is the boundary (`limit_cells.cpp`).
//
// log r / log |mu| is compared with the number of the statement: less or greater by enclosures, equal by powers that are
// equal.

namespace algae::verify {

namespace limits {

/// From 0 where it may be 0: the enclosure of the square may go below that.
Ball size(const Number& a) {
    const Ball square = square_of_size(a);
    if (is_above(square, Ball(0, bits))) return sqrt(square);
    return hull(Ball(0, bits), sqrt(abs(Ball(square.upper(), bits))));
}
Number operator/(const Number& a, const Number& b) {
    const Number product = a * Number{b.real, -b.imaginary};
    const Ball square = square_of_size(b);
    return {product.real / square, product.imaginary / square};
}
namespace {

std::optional<Ball> largest_real_root(const Polynomial& polynomial, long precision) {
    std::optional<Ball> largest;
    for (const Root& root : roots(polynomial, precision))
        if (root.is_real && (!largest || is_above(root.real, *largest))) largest = root.real;
    return largest;
}

Operand whole(const Integer& base, const Rational& exponent = 1) {
    return {base, exponent, {}, [=](long precision) {
                return power(Ball(base, precision), Ball(exponent, precision));
            }};
}

}  // namespace

std::optional<Operand> root_of(const Polynomial& polynomial) {
    if (polynomial.degree() < 1 || polynomial.degree() > 200) return std::nullopt;
    std::optional<Ball> largest;
    Polynomial minimal;
    for (const auto& [factor, times] : factorise(polynomial).powers) {
        const auto root = largest_real_root(factor, bits);
        if (!root || (largest && !is_above(*root, *largest))) continue;
        largest = root;
        minimal = factor;
    }
    if (!largest || !is_above(*largest, Ball(1, bits))) {
        // 1 itself is the only other rate.
        if (minimal == Polynomial({-1, 1})) return whole(Integer(1));
        return std::nullopt;
    }
    if (minimal.degree() == 1 && minimal.leading_coefficient() == 1)
        return whole(-minimal.coefficient(0));
    return Operand{{}, 1, minimal, [minimal](long precision) {
                       return *largest_real_root(minimal, precision);
                   }};
}

namespace {

/// A rational number t with left = right^t, where it is seen.
std::optional<Rational> exponent_between(const Operand& left, const Operand& right) {
    if (left.base && right.base) {
        constexpr std::uint64_t most = 32;
        if (*left.base == 1) return Rational(0);
        for (std::uint64_t under = 1; under <= most; ++under) {
            const Integer one = power(*left.base, under);
            for (std::uint64_t over = 1; over <= most; ++over)
                if (power(*right.base, over) == one)
                    return Rational(Integer(over), Integer(under)) * left.exponent / right.exponent;
        }
        return std::nullopt;
    }
    if (!left.base && !right.base && !left.minimal.is_zero() && left.minimal == right.minimal)
        return left.exponent / right.exponent;
    return std::nullopt;
}

}  // namespace

Order compared(const Operand& left, const Operand& right) {
    if (left.base == right.base && left.exponent == right.exponent &&
        left.minimal == right.minimal && (left.base || !left.minimal.is_zero()))
        return Order::equal;
    return compare(left.enclose(bits), right.enclose(bits));
}

Ball Value::enclosure(long precision) const {
    if (number) return Ball(*number, precision);
    return log(over->enclose(precision)) / log(under->enclose(precision));
}

std::optional<Rational> Value::rational() const {
    return number ? number : exponent_between(*over, *under);
}

Order compared(const Value& left, const Value& right) {
    for (const long precision : {128L, 1024L}) {
        const Order order = compare(left.enclosure(precision), right.enclosure(precision));
        if (order == Order::less || order == Order::greater) return order;
    }
    const auto one = left.rational(), other = right.rational();
    if (one && other && *one == *other) return Order::equal;
    if (left.number || right.number) return Order::unknown;
    const auto over = exponent_between(*left.over, *right.over),
               under = exponent_between(*left.under, *right.under);
    return over && under && *over == *under ? Order::equal : Order::unknown;
}

Number LimitSet::value(const Row& row) const {
    Number sum = number(0);
    for (std::size_t i = 0; i < rank; ++i)
        if (!row[i].is_zero()) sum = sum + numbers[i] * number(Rational(row[i]));
    return sum;
}

std::set<std::size_t> LimitSet::reached() const {
    std::set<std::size_t> found;
    std::vector<std::size_t> open;
    const auto visit = [&](const Seen& part) {
        if (found.insert(part.piece).second) open.push_back(part.piece);
    };
    for (const Seen& part : axiom) visit(part);
    while (!open.empty()) {
        const std::size_t piece = open.back();
        open.pop_back();
        for (const Seen& part : parts.at(piece)) visit(part);
    }
    return found;
}

Row Places::row(const Field& field) const {
    Row found;
    for (const Field& entry : field.list()) {
        found.push_back(entry.integer(true));
        if (!found.back().fits_int64()) entry.fail("expected a number of at most 64 bits");
    }
    if (found.size() != set.rank)
        field.fail("expected " + std::to_string(set.rank) + " integers in a row");
    return found;
}

namespace {

constexpr std::uint64_t largest_order = 3600, most_phases = 64;
constexpr std::size_t largest_rank = 24, most_pieces = 400, most_levels = 10'000;
constexpr std::size_t largest_matrix = 150;

bool is_not_zero(const Number& a) { return is_above(square_of_size(a), Ball(0, bits)); }

// The number of a statement.

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    return text;
}

bool takes(std::string_view& text, std::string_view beginning) {
    if (!text.starts_with(beginning)) return false;
    text = trimmed(text.substr(beginning.size()));
    return true;
}

bool is_number_of_digits(std::string_view text) {
    return !text.empty() && text.size() < 100 &&
           text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// "x^3 - x^2 - 2".
std::optional<Polynomial> polynomial_of(std::string_view text) {
    Polynomial sum;
    bool is_first = true;
    while (!(text = trimmed(text)).empty()) {
        const bool minus = text.front() == '-';
        if (!minus && text.front() != '+' && !is_first) return std::nullopt;
        if (minus || text.front() == '+') text = trimmed(text.substr(1));
        is_first = false;
        std::size_t end = std::min(text.find_first_not_of("0123456789"), text.size());
        std::optional<Integer> coefficient;
        if (end > 0 && !is_number_of_digits(text.substr(0, end))) return std::nullopt;
        if (end > 0) coefficient = Integer(std::string(text.substr(0, end)));
        text.remove_prefix(end);
        std::size_t exponent = 0;
        if (!text.empty() && text.front() == 'x') {
            exponent = 1;
            text.remove_prefix(1);
            if (!text.empty() && text.front() == '^') {
                text.remove_prefix(1);
                end = std::min(text.find_first_not_of("0123456789"), text.size());
                if (end == 0 || end > 3) return std::nullopt;
                exponent = std::stoul(std::string(text.substr(0, end)));
                text.remove_prefix(end);
            }
        } else if (!coefficient) {
            return std::nullopt;
        }
        const Polynomial term = Polynomial::monomial(coefficient.value_or(Integer(1)), exponent);
        sum += minus ? -term : term;
    }
    return sum;
}

/// "4", "sqrt 10", "(the largest real root of x^3 - x^2 - 2)".
std::optional<Operand> operand_of(std::string_view text) {
    text = trimmed(text);
    if (text.starts_with('(') && text.ends_with(')') && text.find('(', 1) == std::string_view::npos)
        return operand_of(text.substr(1, text.size() - 2));
    if (is_number_of_digits(text)) {
        const Integer base{std::string(text)};
        return base.is_zero() ? std::nullopt : std::optional(whole(base));
    }
    if (takes(text, "sqrt")) {
        const auto inner = operand_of(text);
        if (!inner || !inner->base || inner->exponent != 1) return std::nullopt;
        return whole(*inner->base, Rational(1, 2));
    }
    if (!takes(text, "the largest real root of")) return std::nullopt;
    const auto polynomial = polynomial_of(text);
    return polynomial ? root_of(*polynomial) : std::nullopt;
}

/// "log 4 / log 3", "3/2", "1.25"; nothing if it is written in another way.
std::optional<Value> value_of(std::string_view text) {
    text = trimmed(text);
    if (takes(text, "log")) {
        for (std::size_t at = text.find('/'); at != std::string_view::npos;
             at = text.find('/', at + 1)) {
            std::string_view under = trimmed(text.substr(at + 1));
            if (!takes(under, "log")) continue;
            Value found{{}, operand_of(text.substr(0, at)), operand_of(under)};
            if (!found.over || !found.under || found.under->base == Integer(1)) return std::nullopt;
            return found;
        }
        return std::nullopt;
    }
    if (text.empty() || text.size() > 1000 ||
        text.find_first_not_of("0123456789./") != std::string_view::npos)
        return std::nullopt;
    try {
        return Value{Rational(std::string(text))};
    } catch (const Error&) {
        return std::nullopt;
    }
}

/// Of a statement: the first of several forms, between which there is "="; the others must be the same number, or
/// round it.
Value claimed_value(const Field& field) {
    std::string_view text = field.text();
    std::optional<Value> first;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find('=', begin), text.size());
        const std::string_view written = trimmed(text.substr(begin, end - begin));
        begin = end + 1;
        const auto value = value_of(written);
        if (!value) too_hard("a number of a dimension is written in a way that is not read");
        if (!first) {
            first = value;
            continue;
        }
        const Order order = compared(*first, *value);
        if (order == Order::equal) continue;
        const std::size_t point = written.find('.');
        if (point == std::string_view::npos || !value->number) {
            if (order == Order::unknown)
                too_hard("it is not seen whether two numbers of a dimension are the same");
            field.refuse("two numbers differ");
        }
        const Rational half =
            Rational(1, 2) /
            power(Rational(10), static_cast<std::int64_t>(written.size() - point - 1));
        const Ball error = abs(first->enclosure(1024) - Ball(*value->number, 1024));
        const Order away = compare(error, Ball(half, 1024));
        if (away == Order::greater) field.refuse("two numbers differ");
        if (away != Order::less) too_hard("two numbers are too near to each other");
    }
    return *first;
}

// The set.

/// Reads a set, and checks what the proof says of its lattice.
class SetReader {
public:
    explicit SetReader(const Obligation& task)
        : task_(task), proof_(task.proof), turtle_(turtle_of(task)) {
        read_sizes();
        read_rules();
        find_turns();
        read_lattice();
        find_numbers();
        check_tendency();
        find_parts();
        find_components();
        set_.letters = letters_.size();
        set_.phases = phases_;
        set_.factor = *factor_;
        set_.ratio = ratio();
        if (proof_.has("discs")) read_discs();
    }

    LimitSet result() { return std::move(set_); }

    std::size_t piece_of(const Field& letter, const Field& phase) const {
        const auto symbol = task_.alphabet().find(letter.text());
        const auto place = symbol ? place_.find(*symbol) : place_.end();
        if (place == place_.end()) letter.fail("expected a letter that the turtle reads");
        const std::uint64_t at = phase.number();
        if (at >= phases_) phase.fail("expected a phase");
        return static_cast<std::size_t>(at) * letters_.size() + place->second;
    }

private:
    struct Item {
        std::size_t letter = 0;  // its place among the letters
        bool opens = false, closes = false;
    };
    static Turtle turtle_of(const Obligation& task) {
        if (task.statement.systems.empty() || !is_d0l(task.system()))
            too_hard("dimensions of such systems are not worked out again");
        const Field root(task.certificate.header, "", task.certificate.file);
        const auto known = task.certificate.systems.find(task.statement.family);
        if (known == task.certificate.systems.end() || known->second.get() != &task.system() ||
            !root.has("turtles") || !root.at("turtles").has(task.statement.family))
            task.refuse("no turtle of the system '" + task.statement.family + "' is known");
        return read_turtle(root.at("turtles").at(task.statement.family), task.alphabet());
    }

    static std::uint64_t at_most(const Field& field, std::uint64_t most) {
        const std::uint64_t read = field.number();
        if (read < 1 || read > most)
            field.fail("expected a number from 1 to " + std::to_string(most));
        return read;
    }

    void read_sizes() {
        set_.order = static_cast<std::int64_t>(at_most(proof_.at("order"), largest_order));
        phases_ = static_cast<std::size_t>(at_most(proof_.at("phases"), most_phases));
        ring_.emplace(static_cast<long>(set_.order));
    }

    std::int64_t units(const Rational& part) const {
        const Rational found = part * Rational(set_.order);
        if (!found.is_integer()) proof_.at("order").refuse("turns are not multiples of it");
        return normal(found.numerator().to_int64());
    }

    std::int64_t normal(std::int64_t heading) const { return set_.normal(heading); }

    // The rules.

    std::string commands(Symbol letter) const {
        const auto found = turtle_.letters.find(letter);
        return found == turtle_.letters.end() ? "" : found->second;
    }

    void read_rules() {
        const System& system = task_.system();
        const System::Successors& table = system.tables.front();
        std::map<Symbol, std::size_t> places;
        for (const Symbol a : accessible_letters(system, system.axiom)) {
            if (commands(a) == "[" || commands(a) == "]") {
                if (table[a].front() != Word{a}) too_hard("brackets become other letters");
                continue;
            }
            places[a] = letters_.size();
            letters_.push_back(a);
        }
        if (letters_.size() * phases_ > most_pieces) too_hard("there are too many pieces");
        const auto items = [&](const Word& word) {
            std::vector<Item> found;
            std::size_t depth = 0;
            for (const Symbol a : word) {
                const bool opens = commands(a) == "[", closes = commands(a) == "]";
                if (closes && depth-- == 0) too_hard("brackets do not match in a successor");
                if (opens) ++depth;
                found.push_back({opens || closes ? 0 : places.at(a), opens, closes});
            }
            if (depth != 0) too_hard("brackets do not match in a successor");
            return found;
        };
        for (const Symbol a : letters_) words_.push_back(items(table[a].front()));
        axiom_ = items(system.axiom);
        place_ = std::move(places);
    }

    /// What a letter's own commands turn by, move and draw.
    std::tuple<std::int64_t, CyclotomicInteger, bool> told(Symbol letter) const {
        std::int64_t heading = 0;
        CyclotomicInteger here = ring_->zero();
        bool draws = false;
        std::vector<std::pair<std::int64_t, CyclotomicInteger>> kept;
        for (const char command : commands(letter)) {
            if (command == '+') heading = normal(heading + units(turtle_.turn));
            if (command == '-') heading = normal(heading - units(turtle_.turn));
            if (command == '|') heading = normal(heading + units(Rational(1, 2)));
            if (command == 'F' || command == 'f') ring_->add_rotated(here, ring_->one(), heading);
            draws = draws || command == 'F';
            if (command == '[') kept.emplace_back(heading, here);
            if (command == ']') {
                if (kept.empty()) too_hard("brackets do not match in what a letter draws");
                std::tie(heading, here) = kept.back();
                kept.pop_back();
            }
        }
        if (!kept.empty()) too_hard("brackets do not match in what a letter draws");
        return {heading, here, draws};
    }

    /// The turn of a word of letters that turn so; `see` is told of each letter, the heading before it, and whether no bracket is open.
    template <class See>
    std::int64_t turn_of(const std::vector<Item>& word, const std::vector<std::int64_t>& turns,
                         const See& see) const {
        std::int64_t heading = 0;
        std::vector<std::int64_t> kept;
        for (const Item& item : word) {
            if (item.opens) {
                kept.push_back(heading);
            } else if (item.closes) {
                heading = kept.back();
                kept.pop_back();
            } else {
                see(item, heading, kept.empty());
                heading = normal(heading + turns[item.letter]);
            }
        }
        return heading;
    }

    /// The turns of the letters in the generations, until they come back.
    void find_turns() {
        std::vector<std::int64_t> now;
        for (const Symbol a : letters_) now.push_back(std::get<0>(told(a)));
        std::map<std::vector<std::int64_t>, std::size_t> seen;
        while (seen.emplace(now, turns_.size()).second) {
            if (turns_.size() == most_levels) too_hard("turns do not come back");
            turns_.push_back(now);
            for (std::size_t a = 0; a < letters_.size(); ++a)
                now[a] = turn_of(words_[a], turns_.back(), [](const Item&, std::int64_t, bool) {});
        }
        first_ = seen.at(now);
        if (phases_ % (turns_.size() - first_) != 0)
            proof_.at("phases").refuse("turns do not come back after so many generations");
    }

    const std::vector<std::int64_t>& turns(std::size_t level) const {
        const std::size_t period = turns_.size() - first_;
        return level < first_ ? turns_[level] : turns_[first_ + (level - first_) % period];
    }

    /// Of a letter in a phase: its parts have the turns of the phase before.
    const std::vector<std::int64_t>& turns_below(std::size_t phase) const {
        return turns(first_ + (phase + phases_ - 1) % phases_);
    }

    // The lattice.

    IntegerMatrix matrix(const Field& field) const {
        std::vector<Row> rows;
        for (const Field& row : field.list()) rows.push_back(integers(row));
        if (rows.size() != set_.rank) field.fail("expected as many rows as there are columns");
        return IntegerMatrix(rows);
    }

    Row integers(const Field& field) const {
        Row found;
        for (const Field& entry : field.list()) {
            found.push_back(entry.integer(true));
            if (!found.back().fits_int64()) entry.fail("expected a number of at most 64 bits");
        }
        if (found.size() != set_.rank)
            field.fail("expected " + std::to_string(set_.rank) + " integers in a row");
        return found;
    }

    void read_lattice() {
        set_.rank = proof_.at("scale").list().size();
        if (set_.rank < 1 || set_.rank > largest_rank)
            too_hard("positions lie in too large a field");
        set_.scale = matrix(proof_.at("scale"));
        const IntegerMatrix turn = matrix(proof_.at("turn"));
        if (set_.scale * turn != turn * set_.scale)
            proof_.at("turn").refuse("scale and turn do not commute");
        set_.turns.push_back(IntegerMatrix::identity(set_.rank));
        for (std::int64_t heading = 1; heading <= set_.order; ++heading) {
            task_.budget.check();
            set_.turns.push_back(set_.turns.back() * turn);
        }
        if (set_.turns.back() != set_.turns.front())
            proof_.at("turn").refuse("its power by the order is not 1");
        ways_.assign(phases_ * letters_.size(), Row(set_.rank));
        for (const Field& way : proof_.at("ways").list()) {
            const auto parts = way.list();
            if (parts.size() != 3) way.fail("expected a letter, a phase and a row");
            ways_[piece_of(parts[0], parts[1])] = integers(parts[2]);
        }
        for (std::size_t piece = 0; piece < ways_.size(); ++piece) {
            Row sum(set_.rank);
            walk(piece, [&](const Item&, std::size_t below, std::int64_t heading, const Row&,
                            bool is_on_path) {
                if (is_on_path) add(sum, set_.turned(ways_[below], heading));
            });
            if (ways_[piece] * set_.scale != sum)
                proof_.at("ways").refuse("the way of '" +
                                         task_.alphabet().name(letters_[letter_of(piece)]) +
                                         "' does not follow from its successor's");
        }
    }

    std::size_t letter_of(std::size_t piece) const { return piece % letters_.size(); }

    /// What a word consists of, one after the other: pieces of a phase, with headings and places.
    template <class See>
    void walk(const std::vector<Item>& word, std::size_t phase_below,
              const std::vector<std::int64_t>& below, const See& see) const {
        std::int64_t heading = 0;
        Row here(set_.rank);
        std::vector<std::pair<std::int64_t, Row>> kept;
        for (const Item& item : word) {
            if (item.opens) {
                kept.emplace_back(heading, here);
            } else if (item.closes) {
                std::tie(heading, here) = std::move(kept.back());
                kept.pop_back();
            } else {
                const std::size_t part = phase_below * letters_.size() + item.letter;
                see(item, part, heading, here, kept.empty());
                add(here, set_.turned(ways_[part], heading));
                heading = normal(heading + below[item.letter]);
            }
        }
    }

    template <class See>
    void walk(std::size_t piece, const See& see) const {
        const std::size_t phase = piece / letters_.size();
        walk(words_[letter_of(piece)], (phase + phases_ - 1) % phases_, turns_below(phase), see);
    }

    // The numbers that rows stand for.

    void find_numbers() {
        const Polynomial characteristic = characteristic_polynomial(set_.scale);
        Polynomial annihilating(1);
        for (const auto& [factor, times] : factorise(characteristic).powers) annihilating *= factor;
        IntegerMatrix at_scale(set_.rank, set_.rank);
        for (std::size_t k = annihilating.coefficients().size(); k-- > 0;) {
            at_scale = at_scale * set_.scale;
            for (std::size_t i = 0; i < set_.rank; ++i)
                at_scale(i, i) += annihilating.coefficient(k);
        }
        if (!at_scale.is_zero()) proof_.at("scale").refuse("it is not diagonal over the numbers");
        const auto [real, imaginary] = proof_.at("factor").pair();
        const double near_real = decimal_of(real).to_double(),
                     near_imaginary = decimal_of(imaginary).to_double();
        double best = INFINITY;
        std::optional<Number> found;
        for (const auto& [factor, times] : factorise(characteristic).powers)
            for (const Root& root : roots(factor, bits)) {
                const double away = std::hypot(root.real.midpoint() - near_real,
                                               root.imaginary.midpoint() - near_imaginary);
                if (!(away < best)) continue;
                best = away;
                found = Number{root.real, root.imaginary};
                minimal_ = factor;
            }
        if (!found) proof_.at("factor").refuse("it is near no root");
        factor_ = found;
        if (!is_above(square_of_size(*factor_), Ball(1, bits)))
            proof_.at("factor").refuse("it is not larger than 1");
        // (annihilating(x) / (x - mu))(scale) times a column, and of that the part on which turns act as zeta.
        Column quotient(static_cast<std::size_t>(annihilating.degree()), number(0));
        Number carry = number(0);
        for (std::size_t k = quotient.size(); k-- > 0;) {
            carry = carry * *factor_ + number(Rational(annihilating.coefficient(k + 1)));
            quotient[k] = carry;
        }
        for (std::size_t start = 0; start < set_.rank; ++start) {
            Row power(set_.rank);
            power[start] = 1;
            Column column(set_.rank, number(0));
            for (const Number& coefficient : quotient) {
                for (std::size_t i = 0; i < set_.rank; ++i)
                    column[i] = column[i] + coefficient * number(Rational(power[i]));
                power = set_.scale * power;
            }
            Column sum(set_.rank, number(0));
            for (std::int64_t heading = 0; heading < set_.order; ++heading) {
                const Number back = set_.zeta(-heading);
                const IntegerMatrix& turn = set_.turns[static_cast<std::size_t>(heading)];
                for (std::size_t i = 0; i < set_.rank; ++i)
                    for (std::size_t k = 0; k < set_.rank; ++k)
                        if (!turn(i, k).is_zero())
                            sum[i] = sum[i] + back * number(Rational(turn(i, k))) * column[k];
            }
            if (!is_not_zero(sum[0])) continue;
            set_.numbers.clear();
            for (const Number& each : sum) set_.numbers.push_back(each / sum[0]);
            return;
        }
        proof_.at("turn").refuse("no numbers are seen on which it acts as a turn");
    }

    static Rational decimal_of(const Field& field) {
        constexpr std::size_t longest = 100;
        if (field.text().size() > longest) field.fail("expected a decimal number");
        try {
            return Rational(field.text());
        } catch (const Error& error) {
            field.fail(error.what());
        }
    }

    // What ways tend to.

    using Ways = std::vector<CyclotomicInteger>;  // by letter

    /// The ways of one generation from those of the generation before, in which letters turn so.
    Ways next_ways(const Ways& ways, const std::vector<std::int64_t>& turns) const {
        Ways next;
        for (const auto& word : words_) {
            CyclotomicInteger sum = ring_->zero();
            turn_of(word, turns, [&](const Item& item, std::int64_t heading, bool stays) {
                if (stays) ring_->add_rotated(sum, ways[item.letter], heading);
            });
            next.push_back(std::move(sum));
        }
        return next;
    }

    /// From a generation of the first phase to the next such one.
    Ways next_round(Ways ways) const {
        for (std::size_t phase = 1; phase <= phases_; ++phase)
            ways = next_ways(ways, turns_below(phase % phases_));
        return ways;
    }

    /// The matrix of a round on coordinates of the letters' ways.
    IntegerMatrix round_matrix() const {
        const std::size_t degree = ring_->degree(), size = degree * letters_.size();
        if (size > largest_matrix) too_hard("there are too many letters and directions");
        std::vector<Row> rows;
        for (std::size_t a = 0; a < letters_.size(); ++a)
            for (std::size_t k = 0; k < degree; ++k) {
                task_.budget.check();
                Ways unit(letters_.size(), ring_->zero());
                unit[a].coefficients[k] = 1;
                Row row;
                for (const CyclotomicInteger& way : next_round(std::move(unit)))
                    row.insert(row.end(), way.coefficients.begin(), way.coefficients.end());
                rows.push_back(std::move(row));
            }
        return IntegerMatrix(rows);
    }

    /// The product of the factors of the round's characteristic polynomial all of whose roots are smaller than
    /// mu^phases.
    Polynomial of_smaller_roots() const {
        Ball largest(1, bits);
        for (std::size_t k = 0; k < phases_; ++k) largest *= square_of_size(*factor_);
        Polynomial found(1);
        for (const auto& [factor, times] :
             factorise(characteristic_polynomial(round_matrix())).powers) {
            const auto all = roots(factor, bits);
            const bool smaller = std::all_of(all.begin(), all.end(), [&](const Root& root) {
                return is_above(largest, square_of_size({root.real, root.imaginary}));
            });
            if (smaller) found *= power(factor, times);
        }
        return found;
    }

    /// With the polynomial q of smaller roots, q(round) d is a multiple of the ways, exactly and not 0: so in late
    /// generations nothing but that multiple counts beside it.
    void check_tendency() {
        Ways ways;
        for (const Symbol a : letters_) ways.push_back(std::get<1>(told(a)));
        for (std::size_t level = 0; level < first_; ++level) ways = next_ways(ways, turns(level));
        const Polynomial smaller = of_smaller_roots();
        Ways sum(letters_.size(), ring_->zero());
        for (std::size_t k = 0; k < smaller.coefficients().size(); ++k) {
            task_.budget.check();
            for (std::size_t a = 0; a < letters_.size(); ++a) {
                CyclotomicInteger part = ways[a];
                ring_->scale(part, smaller.coefficient(k));
                ring_->add(sum[a], part);
            }
            ways = next_round(std::move(ways));
        }
        const auto times = [&](const Row& row, const CyclotomicInteger& number) {
            Row found(set_.rank);
            for (std::size_t k = 0; k < number.coefficients.size(); ++k) {
                if (number.coefficients[k].is_zero()) continue;
                const Row part = set_.turned(row, static_cast<std::int64_t>(k));
                for (std::size_t i = 0; i < set_.rank; ++i)
                    found[i] += part[i] * number.coefficients[k];
            }
            return found;
        };
        bool is_seen = false;
        for (std::size_t a = 0; a < letters_.size(); ++a) {
            for (std::size_t b = 0; b < a; ++b)
                if (times(ways_[a], sum[b]) != times(ways_[b], sum[a]))
                    too_hard("it is not seen that ways tend to those of the certificate");
            is_seen = is_seen || (sum[a] != ring_->zero() && is_not_zero(set_.value(ways_[a])));
        }
        if (!is_seen) proof_.at("ways").refuse("ways do not tend to them");
    }

    // Parts, and the components of pieces.

    void find_parts() {
        const std::vector<bool> lasts = lasting();
        for (std::size_t piece = 0; piece < ways_.size(); ++piece) {
            if (!lasts[letter_of(piece)]) continue;
            auto& own = set_.parts[piece];
            walk(piece, [&](const Item& item, std::size_t part, std::int64_t heading,
                            const Row& here, bool) {
                if (lasts[item.letter]) own.push_back({part, heading, here});
            });
        }
        walk(axiom_, 0, turns(first_),
             [&](const Item& item, std::size_t part, std::int64_t heading, const Row& here, bool) {
                 if (lasts[item.letter]) set_.axiom.push_back({part, heading, here});
             });
        if (set_.axiom.empty()) too_hard("nothing is drawn in late generations");
        const auto late_at = [&](std::size_t phase) {
            std::vector<std::size_t> begin;
            walk(axiom_, phase, turns(first_ + phase),
                 [&](const Item& item, std::size_t part, std::int64_t, const Row&, bool) {
                     if (lasts[item.letter]) begin.push_back(part);
                 });
            return late(begin);
        };
        const std::set<std::size_t> first = late_at(0);
        for (std::size_t phase = 1; phase < phases_; ++phase)
            if (late_at(phase) != first)
                too_hard("late generations are made of other parts than those before and behind");
    }

    /// The letters that lead to drawing in every late generation. Where it depends on the generation, there is no limit of all.
    std::vector<bool> lasting() const {
        std::vector<bool> now;
        for (const Symbol a : letters_) now.push_back(std::get<2>(told(a)));
        std::set<std::vector<bool>> seen;
        while (seen.insert(now).second && seen.size() <= most_levels) {
            std::vector<bool> next;
            for (const std::vector<Item>& word : words_)
                next.push_back(std::any_of(word.begin(), word.end(), [&](const Item& item) {
                    return !item.opens && !item.closes && now[item.letter];
                }));
            if (next == now) return now;
            now = std::move(next);
        }
        too_hard("what draws in some late generations does not in others");
    }

    /// Of the pieces that these lead to, those that come again or are led to by such: late ones.
    std::set<std::size_t> late(const std::vector<std::size_t>& begin) const {
        std::set<std::size_t> all = reached_from(begin);
        std::map<std::size_t, std::size_t> above;  // how many parts of others a piece is
        for (const std::size_t piece : all)
            for (const Seen& part : set_.parts.at(piece)) ++above[part.piece];
        std::vector<std::size_t> open;
        for (const std::size_t piece : all)
            if (above[piece] == 0) open.push_back(piece);
        while (!open.empty()) {
            const std::size_t piece = open.back();
            open.pop_back();
            all.erase(piece);
            for (const Seen& part : set_.parts.at(piece))
                if (--above[part.piece] == 0) open.push_back(part.piece);
        }
        return all;
    }

    std::set<std::size_t> reached_from(const std::vector<std::size_t>& starts) const {
        std::set<std::size_t> found(starts.begin(), starts.end());
        std::vector<std::size_t> open(found.begin(), found.end());
        while (!open.empty()) {
            const std::size_t piece = open.back();
            open.pop_back();
            for (const Seen& part : set_.parts.at(piece))
                if (found.insert(part.piece).second) open.push_back(part.piece);
        }
        return found;
    }

    void find_components() {
        const std::set<std::size_t> all = set_.reached();
        std::map<std::size_t, std::set<std::size_t>> after;
        for (const std::size_t piece : all) {
            task_.budget.check();
            std::vector<std::size_t> next;
            for (const Seen& part : set_.parts.at(piece)) next.push_back(part.piece);
            after[piece] = reached_from(next);
        }
        std::set<std::size_t> done;
        for (const std::size_t piece : all) {
            if (done.contains(piece) || !after.at(piece).contains(piece)) continue;
            Component component;
            for (const std::size_t other : after.at(piece))
                if (after.at(other).contains(piece)) component.pieces.push_back(other);
            done.insert(component.pieces.begin(), component.pieces.end());
            IntegerMatrix matrix(component.pieces.size(), component.pieces.size());
            bool multiplies = false, is_point = true;
            for (std::size_t i = 0; i < component.pieces.size(); ++i) {
                std::size_t within = 0;
                for (const Seen& part : set_.parts.at(component.pieces[i])) {
                    const auto at = std::lower_bound(component.pieces.begin(),
                                                     component.pieces.end(), part.piece);
                    if (at == component.pieces.end() || *at != part.piece) continue;
                    matrix(i, static_cast<std::size_t>(at - component.pieces.begin())) += 1;
                    is_point = is_point && part.offset == Row(set_.rank);
                    multiplies = multiplies || ++within > 1;
                }
            }
            if (!multiplies) continue;
            if (is_point) too_hard("pieces shrink to points");
            const auto rate = root_of(characteristic_polynomial(matrix));
            if (!rate) too_hard("a rate is not found");
            component.rate = *rate;
            set_.components.push_back(std::move(component));
        }
        if (set_.components.empty()) too_hard("the parts that are drawn do not multiply");
    }

    /// |mu|: the root of an integer where mu times its conjugate is one; the largest root of a polynomial where mu is
    /// real.
    Operand ratio() const {
        const Number mu = *factor_;
        const auto enclosed = [minimal = minimal_, mu](long precision) {
            for (const Root& root : roots(minimal, precision))
                if (root.real.overlaps(mu.real) && root.imaginary.overlaps(mu.imaginary))
                    return sqrt(root.real * root.real + root.imaginary * root.imaginary);
            return Ball(0, precision);
        };
        if (const auto square = square_of_size(mu).unique_integer(); square && *square > 1) {
            // Whether the square over each root is a root: then that over mu is its conjugate, or lies apart from it.
            const auto degree = static_cast<std::size_t>(minimal_.degree());
            std::vector<Integer> coefficients;
            for (std::size_t k = 0; k <= degree; ++k)
                coefficients.push_back(minimal_.coefficient(degree - k) *
                                       power(*square, static_cast<std::uint64_t>(degree - k)));
            const Number over = number(Rational(*square)) / mu;
            std::size_t meets = 0;
            bool is_conjugate = false;
            for (const Root& root : roots(minimal_, bits))
                if (root.real.overlaps(over.real) && root.imaginary.overlaps(over.imaginary)) {
                    ++meets;
                    is_conjugate =
                        root.real.overlaps(mu.real) && root.imaginary.overlaps(-mu.imaginary);
                }
            if (primitive_part(Polynomial(std::move(coefficients))) == minimal_ && meets == 1 &&
                is_conjugate)
                return whole(*square, Rational(1, 2));
        }
        for (const bool negative : {false, true}) {
            Polynomial own = minimal_;
            if (negative) {
                std::vector<Integer> coefficients = minimal_.coefficients();
                for (std::size_t k = 1; k < coefficients.size(); k += 2)
                    coefficients[k] = -coefficients[k];
                own = primitive_part(Polynomial(std::move(coefficients)));
            }
            const auto largest = largest_real_root(own, bits);
            const bool is_real =
                mu.imaginary.contains(Rational(0)) && mu.imaginary.has_radius_below(-bits);
            if (is_real && largest && largest->overlaps(negative ? -mu.real : mu.real))
                if (const auto found = root_of(own)) return *found;
        }
        return {{}, 1, {}, enclosed};
    }

    // Discs and neighbours.

    void read_discs() {
        for (const Field& disc : proof_.at("discs").list()) {
            const auto parts = disc.list();
            if (parts.size() != 5)
                disc.fail("expected a letter, a phase, two coordinates and a radius");
            const std::size_t piece = piece_of(parts[0], parts[1]);
            if (!set_.parts.contains(piece)) disc.refuse("the piece does not draw for ever");
            set_.discs.insert_or_assign(piece,
                                        Disc{number(decimal_of(parts[2]), decimal_of(parts[3])),
                                             Ball(decimal_of(parts[4]), bits)});
        }
        const Ball ratio = size(*factor_);
        for (const auto& [piece, parts] : set_.parts) {
            if (!set_.discs.contains(piece)) proof_.at("discs").refuse("a piece has no disc");
            const Disc& whole = set_.discs.at(piece);
            for (const Seen& part : parts) {
                if (!set_.discs.contains(part.piece))
                    proof_.at("discs").refuse("a piece has no disc");
                const Disc& inner = set_.discs.at(part.piece);
                const Ball apart = size(set_.zeta(part.heading) * inner.centre +
                                        set_.value(part.offset) - *factor_ * whole.centre);
                if (!is_above(ratio * whole.radius, apart + inner.radius))
                    proof_.at("discs").refuse("a part's disc does not lie in that of its whole");
            }
        }
    }

    const Obligation& task_;
    Field proof_;
    Turtle turtle_;
    std::optional<CyclotomicRing> ring_;
    std::size_t phases_ = 1, first_ = 0;
    std::vector<Symbol> letters_;
    std::map<Symbol, std::size_t> place_;
    std::vector<std::vector<Item>> words_;  // by letter
    std::vector<Item> axiom_;
    std::vector<std::vector<std::int64_t>> turns_;  // by generation
    std::vector<Row> ways_;                         // by piece
    std::optional<Number> factor_;
    Polynomial minimal_;
    LimitSet set_;
};

/// What is shown of how a dimension is to a number.
struct Shown {
    bool less = true, at_most = true, at_least = false, greater = false;

    /// Whether the statement holds, if that is shown.
    std::optional<bool> says(const std::string& compared) const {
        if (compared == "at most")
            return at_most ? std::optional(true) : greater ? std::optional(false) : std::nullopt;
        if (compared == "at least")
            return at_least ? std::optional(true) : less ? std::optional(false) : std::nullopt;
        if (less || greater) return false;
        return at_most && at_least ? std::optional(true) : std::nullopt;
    }
};

/// Compares the dimension of a set with a number, by its components.
class ComparedSet {
public:
    ComparedSet(const Obligation& task, const LimitSet& set, const Places& places,
                const Value& claimed)
        : task_(task), set_(set), places_(places), claimed_(claimed) {}

    Shown shown() {
        if (task_.proof.has("bounds")) {
            bounds_ = task_.proof.at("bounds").text();
            if (bounds_ != "from above" && bounds_ != "from below")
                task_.proof.at("bounds").fail("expected 'from above' or 'from below'");
        }
        std::optional<std::size_t> piece;
        if (task_.proof.has("component")) {
            const auto [letter, phase] = task_.proof.at("component").pair();
            piece = places_.piece_of(letter, phase);
            if (!set_.parts.contains(*piece)) letter.refuse("it does not draw for ever");
        }
        for (const Component& component : set_.components)
            look_at(component, piece && std::binary_search(component.pieces.begin(),
                                                           component.pieces.end(), *piece));
        const Order plane = compared(Value{Rational(2)}, claimed_);  // as for every set in it
        found_.less = found_.less || plane == Order::less;
        found_.at_most = found_.at_most || plane == Order::less || plane == Order::equal;
        return found_;
    }
    /// Whether bounds beside the rates of all parts were looked for.
    bool has_bounds() const { return !bounds_.empty(); }

private:
    void look_at(const Component& component, bool is_exact) {
        Operand rate = component.rate;
        Parts parts(places_, component);
        if (is_exact) rate = distinct_rate(parts, task_.proof.at("neighbours"), rate);
        Order order = compared(Value{{}, rate, set_.ratio}, claimed_);
        if (is_exact && order == Order::unknown) too_hard("the numbers are too near to each other");
        if (is_exact) {
            found_.greater = found_.greater || order == Order::greater;
            found_.at_least = found_.at_least || order == Order::greater || order == Order::equal;
        }
        if (bounds_ == "from above" && order != Order::less && is_below(parts)) order = Order::less;
        found_.less = found_.less && order == Order::less;
        found_.at_most = found_.at_most && (order == Order::less || order == Order::equal);
        if (bounds_ == "from below" && !found_.greater && is_above(parts))
            found_.greater = found_.at_least = true;
    }

    Operand distinct_rate(Parts& parts, const Field& list, const Operand& all) const {
        const Neighbours neighbours(parts, places_, list);
        if (!neighbours.parts_coincide()) return all;
        return rate_of_paths(kinds_of_parts(
                                 parts,
                                 [&](std::size_t first, const Seen& other) {
                                     return neighbours.may_coincide(first, other);
                                 },
                                 task_.budget),
                             task_.budget);
    }

    /// What the search says; no where it comes to a bound of its own.
    template <class Search>
    static bool within_bounds(const Search& search) {
        try {
            return search();
        } catch (const BoundReached& bound) {
            if (bound.bound() != Bound::method) throw;
            return false;
        }
    }

    /// Whether different parts multiply less than the number says.
    bool is_below(Parts& parts) {
        const Ball most = exp(claimed_.enclosure(bits) * log(set_.ratio.enclose(bits)));
        return within_bounds([&] {
            for (std::uint64_t levels = 1; levels <= most_levels_apart; ++levels) {
                const Graph kinds = kinds_of_parts(
                    parts,
                    [&](std::size_t first, const Seen& other) {
                        return parts.coincide_within(first, other, levels);
                    },
                    task_.budget);
                if (grows_below(
                        kinds.size(), most.lower(),
                        [&](std::size_t kind, const std::vector<std::uint64_t>& weights) {
                            std::uint64_t sum = 0;
                            for (const std::size_t next : kinds[kind]) sum += weights[next];
                            return sum;
                        },
                        task_.budget))
                    return true;
            }
            return false;
        });
    }

    /// Whether pairs of parts multiply so little that the dimension is above the number. Longer blocks help where parts that
    /// coincide are left out by them.
    bool is_above(Parts& parts) {
        std::vector<std::uint64_t> blocks;
        std::optional<Ball> least;
        for (std::uint64_t levels = 1; levels <= most_levels_in_block; ++levels)
            within_bounds([&] {
                const Ball rate = log(rate_of_blocks(parts, levels, task_.budget).enclose(bits)) /
                                  Ball(Integer(levels), bits);
                if (least && compare(rate, *least) != Order::less) return false;
                least = rate;
                blocks.push_back(levels);
                return true;
            });
        for (std::uint64_t across = 8; across <= most_cells_across; across *= 2)
            for (const std::uint64_t levels : blocks)
                if (within_bounds([&] {
                        return is_above_by_pairs(parts, levels, across, claimed_.enclosure(bits),
                                                 task_.budget);
                    }))
                    return true;
        return false;
    }

    static constexpr std::uint64_t most_levels_apart = 10, most_levels_in_block = 3,
                                   most_cells_across = 256;

    const Obligation& task_;
    const LimitSet& set_;
    const Places& places_;
    const Value& claimed_;
    std::string bounds_;
    Shown found_;
};

/// Whether the whole is one piece, and all pieces that it leads to are of one kind in each phase: then it is similar to
/// its parts.
bool is_of_one_kind(const LimitSet& set) {
    std::set<std::size_t> phases;
    for (const std::size_t piece : set.reached())
        if (!phases.insert(piece / set.letters).second) return false;
    return set.axiom.size() == 1;
}

/// Of a set of one kind that fills an area: some part of it lies within, surrounded by those that it meets, and is similar to
/// the whole.
Operand rate_between_parts(const Obligation& task, const LimitSet& set, const Places& places) {
    if (!is_of_one_kind(set) || set.components.size() != 1)
        task.proof.at("neighbours").refuse("the set is not of one kind");
    const Component& component = set.components.front();
    if (compared(Value{{}, component.rate, set.ratio}, Value{Rational(2)}) != Order::equal)
        task.proof.at("neighbours").refuse("it is not seen that the set fills an area");
    Parts parts(places, component);
    const Neighbours neighbours(parts, places, task.proof.at("neighbours"));
    if (neighbours.parts_coincide())
        task.proof.at("neighbours").refuse("two parts lie in the same place");
    return neighbours.meeting_rate(task.budget);
}

}  // namespace
}  // namespace limits

void check_limit_set(const Obligation& task) {
    using namespace limits;
    const Value claimed = claimed_value(*task.statement.formula);
    SetReader reader(task);
    const LimitSet set = reader.result();
    const Places places{task, set, [&](const Field& letter, const Field& phase) {
                            return reader.piece_of(letter, phase);
                        }};
    Shown shown;
    bool has_bounds = false;
    if (task.statement.kind == Statement::Kind::boundary) {
        const Operand rate = task.proof.has("neighbours") ? rate_between_parts(task, set, places)
                                                          : rate_of_boundary(places);
        const Order order = compared(Value{{}, rate, set.ratio}, claimed);
        if (order == Order::unknown) too_hard("the numbers are too near to each other");
        shown = {order == Order::less, order != Order::greater, order != Order::less,
                 order == Order::greater};
    } else {
        ComparedSet comparison(task, set, places, claimed);
        shown = comparison.shown();
        has_bounds = comparison.has_bounds();
    }
    const auto says = shown.says(task.statement.compared);
    if (!says && has_bounds) too_hard("bounds of the dimension are not seen to be near enough");
    if (!says) task.refuse("an upper bound does not show this");
    if (*says != task.holds)
        task.refuse(std::string("the dimension is ") + (shown.less      ? "less"
                                                        : shown.greater ? "greater"
                                                                        : "that number"));
}

}  // namespace algae::verify
