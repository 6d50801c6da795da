#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "rewrite/rewrite.hpp"

namespace algae {

/// The systems within a system, and their words as values of parameters: NAME(n) is the word of
/// generation n of NAME (systems of L-systems, 001 7.1). Each generation of each system is derived once.
///
/// Systems may use each other and themselves, where in the end no word needs itself: to derive
/// generation n of a system those before it are derived first, so that generation n may use them.
class InnerSystems {
public:
    /// Their words go into the list `words`.
    InnerSystems(std::vector<std::string> names, std::shared_ptr<WordValues> words)
        : names_(std::move(names)), words_(std::move(words)), known_(names_.size()) {}

    /// The number of the system of this name.
    std::optional<std::size_t> find(const std::string& name) const;

    /// The next system in the order of the names: its rules, and its axiom as it is written.
    void add(Rewriting rewriting, Successor axiom);

    /// What the derivations may use from now on.
    void set_budget(const Budget& budget) { budget_ = budget; }

    /// The value of a system's word of this generation. Throws `Undefined` at the expression if it is
    /// no whole number from 0 on, or if the word needs itself: then the reason names the circle. Throws
    /// what Rewriting::next and WordValues::value throw.
    double word(std::size_t system, double generation, const Expression& at);

    /// The value of a word.
    double value(ModuleString word) { return words_->value(std::move(word), budget_); }

    const WordValues& words() const { return *words_; }

private:
    struct Step;  // a word that is being derived
    void derive_next(std::size_t system);
    std::string circle(std::size_t system, std::size_t generation) const;
    std::string name(std::size_t system, std::size_t generation) const {
        return names_[system] + '(' + std::to_string(generation) + ')';
    }

    std::vector<std::string> names_;
    std::vector<Rewriting> rewritings_;
    std::vector<Successor> axioms_;
    std::shared_ptr<WordValues> words_;
    std::vector<std::vector<double>> known_;  // by system and generation
    std::vector<std::pair<std::size_t, std::size_t>>
        steps_;  // being derived, each for the one before
    Budget budget_;
};

}  // namespace algae
