#include <algorithm>
#include <map>

#include "base/error.hpp"
#include "verify/exponential_polynomial.hpp"
#include "verify/lengths.hpp"
#include "verify/proofs.hpp"

namespace algae::verify {

namespace {

/// The lengths of both systems obey linear recurrences of as many terms as they have letters, so their
/// difference obeys one of as many as both have together.
void check_terms(const Checking& with, const System& left, const System& right,
                 const Field& proof) {
    Lengths one(left), other(right);
    const std::size_t terms = one.letters() + other.letters();
    for (std::size_t n = 0; n < terms; ++n) {
        with.budget.check();
        if (one.length() != other.length())
            proof.refuse("generation " + std::to_string(n) + " differs in length");
        one.next();
        other.next();
    }
}

void check_equal_growth(const Checking& with, const Statement& statement, bool holds,
                        const Field& proof, const std::string& by) {
    const System& left = *statement.systems[0].system;
    const System& right = *statement.systems[1].system;
    if (!is_d0l(right)) proof.refuse("a system is not D0L");
    if (holds && by == "terms") {
        proof.only({"by"});
        return check_terms(with, left, right, proof);
    }
    if (holds || by != "generation") wrong_kind(proof, by);
    proof.only({"by", "generation"});
    const Integer generation = proof.at("generation").integer();
    if (length_of_generation(left, generation, with.budget) ==
        length_of_generation(right, generation, with.budget))
        proof.at("generation").refuse("both words are of the same length");
}

void check_formula(const Checking& with, const Statement& statement, bool holds, const Field& proof,
                   const std::string& by) {
    const System& system = *statement.systems[0].system;
    const auto formula = ExponentialPolynomial::read(*statement.formula);
    if (holds && by == "terms") {
        proof.only({"by", "terms"});
        Lengths lengths(system);
        const std::size_t terms = lengths.letters() + formula.order();
        if (proof.has("terms") &&
            !(ExponentialPolynomial::read_terms(proof.at("terms")) == formula))
            proof.at("terms").refuse("the formula has other terms");
        for (std::size_t n = 0; n < terms; ++n, lengths.next()) {
            with.budget.check();
            if (formula(n) != Rational(lengths.length()))
                proof.refuse("generation " + std::to_string(n) + " has " +
                             to_string(lengths.length()) + " letters");
        }
        return;
    }
    if (holds || by != "generation") wrong_kind(proof, by);
    proof.only({"by", "generation"});
    const Integer generation = proof.at("generation").integer();
    const Integer length = length_of_generation(system, generation, with.budget);
    if (generation > 10'000)
        throw BoundReached(Bound::method, "the formula is not worked out beyond 10000");
    if (formula(generation.to_uint64()) == Rational(length))
        proof.at("generation").refuse("the word has as many letters as the formula says");
}

/// Which letters can be reached from which, by one step or more.
class LetterGraph {
public:
    explicit LetterGraph(const System& system)
        : letters_(accessible_letters(system, system.axiom)), table_(system.tables.front()) {
        for (const Symbol a : letters_) reach(a);
    }

    /// A letter that becomes a word with itself in it twice or more.
    bool doubles() const {
        return std::any_of(letters_.begin(), letters_.end(), [&](Symbol a) {
            const Word& image = table_[a].front();
            return std::count_if(image.begin(), image.end(), [&](Symbol b) {
                       return reached_.at(b).contains(a) || b == a;
                   }) > 1;
        });
    }
    /// The most cycles one after the other on a way through the letters, where no letter doubles.
    std::size_t longest_chain() const {
        std::size_t longest = 0;
        std::map<Symbol, std::size_t> found;
        for (const Symbol a : letters_) longest = std::max(longest, chain(a, found));
        return longest;
    }

private:
    void reach(Symbol from) {
        auto& reached = reached_[from];
        std::vector<Symbol> open{from};
        while (!open.empty()) {
            const Symbol a = open.back();
            open.pop_back();
            for (const Symbol b : table_[a].front())
                if (reached.insert(b).second) open.push_back(b);
        }
    }

    /// The most cycles beginning with that of a letter, or after the letter if it is on none.
    std::size_t chain(Symbol a, std::map<Symbol, std::size_t>& found) const {
        if (const auto known = found.find(a); known != found.end()) return known->second;
        const auto& reached = reached_.at(a);
        std::size_t longest = 0;
        for (const Symbol b : reached)
            if (!reached_.at(b).contains(a)) longest = std::max(longest, chain(b, found));
        return found[a] = longest + (reached.contains(a) ? 1 : 0);
    }

    std::vector<Symbol> letters_;
    const System::Successors& table_;
    std::map<Symbol, std::set<Symbol>> reached_;
};

}  // namespace

Growth growth_of(const System& system) {
    const LetterGraph graph(system);
    if (graph.doubles()) return {"exponential", 0};
    const std::size_t cycles = graph.longest_chain();
    if (cycles == 0) return {"zero", 0};
    return {cycles == 1 ? "bounded" : "polynomial", cycles - 1};
}

namespace {

void check_class(const Statement& statement, bool holds, const Field& proof,
                 const std::string& by) {
    if (by != "components") wrong_kind(proof, by);
    proof.only({"by"});
    const Growth found = growth_of(*statement.systems[0].system);
    const bool is =
        found.name == statement.family && (!statement.size || *statement.size == found.degree);
    if (is != holds)
        proof.refuse(
            "the growth is " + found.name +
            (found.name == "polynomial" ? " of degree " + std::to_string(found.degree) : ""));
}

}  // namespace

void check_growth(const Checking& with, const Statement& statement, bool holds, const Field& proof,
                  const std::string& by) {
    if (!is_d0l(*statement.systems[0].system)) proof.refuse("a system is not D0L");
    switch (statement.kind) {
        case Statement::Kind::equal_growth:
            return check_equal_growth(with, statement, holds, proof, by);
        case Statement::Kind::growth_formula:
            return check_formula(with, statement, holds, proof, by);
        default:
            return check_class(statement, holds, proof, by);
    }
}

}  // namespace algae::verify
