#pragma once

#include <vector>

#include "algebra/monoid.hpp"
#include "turtle/commands.hpp"

namespace algae {

/// The product of a letter's commands, branches within it included. `value_of` gives the image of
/// one command other than push and pop.
template <Branching M, class ValueOf>
typename M::value_type product(const M& monoid, const std::vector<Command>& commands, ValueOf value_of) {
    std::vector<typename M::value_type> open{monoid.one()};
    for (const Command command : commands) {
        if (command == Command::push) {
            open.push_back(monoid.one());
        } else if (command == Command::pop && open.size() > 1) {
            const auto twig = monoid.branch(open.back());
            open.pop_back();
            monoid.append(open.back(), twig);
        } else {
            monoid.append(open.back(), value_of(command));
        }
    }
    return open.front();
}

}  // namespace algae
