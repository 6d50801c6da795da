#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"
#include "notation/notation.hpp"
#include "system/system.hpp"

namespace algae {

struct Model;

/// A module as the turtle meets it: a symbol and the values of its parameters.
struct TurtleModule {
    Symbol symbol = 0;
    std::vector<Quantity> parameters;
};

/// The system that a text of the notation says which is written from the file of another program. Its places are the whole file: lines
/// of the written text are none of that file's. Throws Error that names the file where the notation refuses the text.
Model read_written(const std::string& text, const std::string& file);

/// What of a rule is more than a letter, with parameters if those are allowed, and what it becomes: "it
/// has a context"; empty if nothing.
std::string beyond_plain(const Production& rule, bool parameters);

/// The same system with its angle as a setting where an interpretation says it, `+ -> +(60)`, for all turns that words have without a number; as it
/// is otherwise.
Model with_plain_angle(const Model& system);

/// What the printers of formats share: a system, and how they refuse what their format cannot say of it.
class FormatWriter {
protected:
    /// `format` is what errors call it: "brno".
    FormatWriter(const Model& system, const char* format) : system_(system), format_(format) {}

    /// Throws Error: "bush: brno cannot say ...", with the system's name if it has one.
    [[noreturn]] void refuse(const std::string& what) const;
    /// Throws Error: "bush.lsys:3:1: brno cannot say the rule A -> B: " and why.
    [[noreturn]] void refuse(const Production& rule, const std::string& why) const;

    /// Refuses what no format says: systems within a system, tables, terminals and words of the axiom.
    void check_parts() const;
    /// Refuses all but words of letters without parameters as axiom and rules, contexts and conditions;
    /// several rules for a letter unless `choices`.
    void check_plain_rules(bool choices) const;
    /// What is no matter of rules but changes every figure or word: refuses codings, a tropism, environments,
    /// surfaces and plots. Titles, colours, cameras, line widths, seeds and what is expected are left out
    /// by all formats.
    void check_plain_settings() const;

    /// What cpfg, lpfg and L-Py have no words for: besides the above stamps, solids, settings of the turtle's state, words in the
    /// axiom and in rules, shape rules and contexts elsewhere.
    void check_programs() const;
    /// Refuses two rules of which either may be taken: those programs take the first.
    void check_first_wins() const;
    /// The rules with the longest contexts first, which the notation uses first; brackets do not count.
    std::vector<const Production*> rules_by_reach() const;

    /// What stands for a letter once `interpret` rules have been applied until none matches.
    ///
    /// Refuses an interpretation that has contexts, conditions, probabilities or parameters on its left
    /// side, goes round in circles or gives more than 1000 modules.
    std::vector<TurtleModule> interpreted(Symbol letter) const;

    const std::string& name(Symbol symbol) const { return system_.alphabet.name(symbol); }
    /// Whether a setting has this value, which is the one that it has where the file does not say it.
    static bool is_usual(const std::optional<Quantity>& setting, double value) {
        return !setting || setting->value == value;
    }

    const Model& system_;

private:
    void interpret(const TurtleModule& module, std::size_t depth, std::size_t& steps,
                   std::vector<TurtleModule>& modules) const;

    const char* format_;
};

}  // namespace algae
