#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/budget.hpp"
#include "rewrite/rule_set.hpp"

namespace algae {

/// What rules see around the modules of one word: neighbours on the axes of its tree, branches, and
/// where modules stand. What contexts mean is said at IL; a module of a context matches one with
/// the same letter and as many parameters.
class Surroundings {
public:
    /// O(length of the word). Throws Error if the brackets of a tree do not match; `name` is how
    /// the message calls the word.
    Surroundings(const CompiledRules& rules, const ModuleString& word, const std::string& name,
                 const Budget& budget);

    /// Whether the rules' left side matches the module at this position. If so its parameters and
    /// those of the contexts are in `parameters`, the ones of modules elsewhere too: of the
    /// combinations of modules that make the condition true the first, where each module is sought
    /// from left to right and that of the last item moves on first. One module may stand for two
    /// items; the rewritten one itself stands for none. Throws `Undefined`.
    bool match(const Alternatives& rules, std::size_t position,
               std::vector<double>& parameters) const;

    /// The first parameter of the module at this position.
    const double* values_at(std::size_t position) const {
        return word_.values.data() + (offsets_.empty() ? 0 : offsets_[position]);
    }

private:
    static constexpr std::size_t none = ~std::size_t{0};
    struct Search;

    void find_left();
    void find_right();
    void bind(std::size_t position, std::vector<double>& parameters, std::size_t& filled) const;
    bool match_left(const Alternatives& rules, std::size_t position,
                    std::vector<double>& parameters, std::size_t& filled) const;
    bool match_elsewhere(const Alternatives& rules, std::size_t position, std::size_t item,
                         std::size_t filled, std::vector<double>& parameters) const;

    const CompiledRules& rules_;
    const ModuleString& word_;
    const std::string& name_;
    const Budget& budget_;
    bool trees_ = false;
    std::vector<std::uint64_t> offsets_;    // of parameters, by position; empty if there are none
    std::vector<std::size_t> left_, axis_;  // the neighbour on the left; the first module that is
                                            // seen from a position on to the right
    std::vector<std::size_t> closes_;       // by position of [: its ]
    std::vector<std::vector<std::size_t>> at_;  // by kind that is sought elsewhere: its positions
};

}  // namespace algae
