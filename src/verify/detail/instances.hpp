#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "verify/detail/checking.hpp"
#include "verify/verify.hpp"

namespace algae::verify {

/// The family in front of the noun: "0L" of "0L languages"; empty where there is none.
std::string family_of(const std::string& domain, std::string_view noun);

bool is_morphism_domain(const std::string& of);

/// The values of bound names as a certificate has them. The constructor checks that they are what the names range over, but
/// for the families of languages. Throws Flaw if they are not.
class Values {
public:
    /// `task` and `said` must outlive this.
    Values(const Obligation& task, const Quantified& said, const Field& values);

    const BoundNames& names() const { return read_; }
    /// That the value of a name is of the family that the name ranges over; nothing if it ranges over no family.
    std::optional<Statement> membership(const Quantified::Name& name) const;

private:
    void read(const Quantified::Name& name, const Field& field);
    void add(const Word& word, const Quantified::Name& name, const Field& field);
    void read_language(const Quantified::Name& name, const Field& field);
    void read_system(const Quantified::Name& name, const Field& field);
    void read_morphism(const Quantified::Name& name, const Field& field);
    void read_number(const Quantified::Name& name, const Field& field);
    void read_word(const Quantified::Name& name, const Field& field);
    void check_different() const;

    const Obligation& task_;
    const Quantified& said_;
    Field values_;
    BoundNames read_;
    std::vector<std::set<Symbol>> letters_;  // of each value but morphisms
    std::set<Symbol> here_;                  // of one value
    std::uint64_t size_ = 0;
};

}  // namespace algae::verify
