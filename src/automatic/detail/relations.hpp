#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "automatic/automatic.hpp"
#include "automatic/detail/statement.hpp"

namespace algae {

/// An automaton on the way: state 0 is the first one and reaches all; edges of a state in any order. States are closed one after the other.
struct RawAutomaton {
    std::vector<std::uint32_t> first{0};
    std::vector<AutomaticRelation::Edge> edges;
    std::vector<char> accepting;

    /// Ends the edges of a state.
    void close(bool accepts) {
        first.push_back(static_cast<std::uint32_t>(edges.size()));
        accepting.push_back(accepts);
    }
};

/// The Boolean operations on relations in one numeration, projections, and the relations that statements are made of. Every result
/// is minimal. Every operation throws BoundReached where automata become too large for the budget.
class Relations {
public:
    Relations(const AutomaticWord& word, const Budget& budget,
              std::function<void(std::size_t)> progress);

    AutomaticRelation both(const AutomaticRelation& left, const AutomaticRelation& right);
    AutomaticRelation either(const AutomaticRelation& left, const AutomaticRelation& right);
    AutomaticRelation complement(const AutomaticRelation& one);
    /// The tuples to which numbers for these variables can be added.
    AutomaticRelation without(const AutomaticRelation& one, const std::set<std::string>& variables);
    /// The same tuples over more variables, which may be anything.
    AutomaticRelation over(const AutomaticRelation& one, const std::vector<std::string>& variables);

    /// The tuples that are in it when one is added to a variable.
    AutomaticRelation one_more(const AutomaticRelation& one, const std::string& variable);

    /// The same with other names for the variables, all different.
    AutomaticRelation renamed(const AutomaticRelation& one,
                              const std::map<std::string, std::string>& names);

    /// No variables: true or false.
    AutomaticRelation constant(bool holds) const;
    /// All tuples of numbers.
    AutomaticRelation all(const std::vector<std::string>& variables);
    /// The tuples for which a term is 0. Throws Error where addition is not known to be regular.
    AutomaticRelation equation(const LinearTerm& term);
    /// The tuples for which a term with nothing negative in it is `total`.
    AutomaticRelation sum(LinearTerm term, const std::string& total);
    AutomaticRelation less(const std::string& left, const std::string& right, bool or_equal);
    /// Positions whose letters are, or are not, the same.
    AutomaticRelation same_letter(const std::string& left, const std::string& right, bool same);
    AutomaticRelation letter_is(const std::string& at, const std::string& letter, bool is);

    AutomaticRelation minimal(const RawAutomaton& raw, std::vector<std::string> variables);

    /// The polynomial of the recurrence of the lengths of images. Throws as `equation`.
    Polynomial recurrence();

    std::size_t largest() const { return largest_; }
    /// A name that no statement has.
    std::string fresh() { return "." + std::to_string(names_++); }
    /// The numbers on a shortest accepted path; the relation is not empty.
    std::vector<std::pair<std::string, Integer>> witness(const AutomaticRelation& one) const;

private:
    struct Sums;  // how values are added up: the recurrence of the lengths

    /// Tuples by whether each of two relations of the same variables has them.
    template <class Accepts>
    AutomaticRelation merged(const AutomaticRelation& left, const AutomaticRelation& right,
                             Accepts accepts);
    /// Numbers by the state where their digits end.
    AutomaticRelation numbers(const std::string& variable,
                              const std::function<bool(std::uint32_t state)>& accepts);
    void count(std::size_t states, std::size_t edges);
    AutomaticRelation exactly(const Integer& number, const std::string& variable);
    AutomaticRelation equal(const std::string& left, const std::string& right);
    AutomaticRelation direct_sum(const std::vector<std::int64_t>& coefficients,
                                 std::int64_t constant);
    AutomaticRelation bounded_sum(const std::vector<std::int64_t>& coefficients,
                                  std::int64_t constant, double bound);
    const Sums& sums();

    const AutomaticWord& word_;
    const Numeration& numeration_;
    const Budget& budget_;
    std::function<void(std::size_t)> progress_;
    std::shared_ptr<Sums> sums_;
    std::size_t largest_ = 0;
    std::size_t names_ = 0;
    std::vector<AutomaticRelation> all_;  // by the number of variables
    std::map<std::vector<std::int64_t>, AutomaticRelation>
        known_;  // sums by coefficients and constant
};

}  // namespace algae
