#pragma once
// Operands put together as their operators bind, for grammars that are flat.

#include <cstddef>
#include <functional>
#include <iterator>
#include <utility>
#include <vector>

namespace algae {

/// Dijkstra's shunting yard: it is told operands and operators from left to right and keeps a stack of its own, so
/// that no text, however deep its brackets, can exhaust the program's. Operators that bind more tightly have the
/// larger numbers, from 0 on; those of one number group to the left.
template <class Operand>
class OperatorStack {
public:
    /// What an operator makes of its operands, in their order.
    using Make = std::function<Operand(std::vector<Operand>)>;

    void operand(Operand value) { operands_.push_back(std::move(value)); }

    void prefix(int binding, Make make) { pending_.push_back({binding, 1, std::move(make)}); }

    void infix(int binding, Make make) {
        reduce(binding);
        pending_.push_back({binding, 2, std::move(make)});
    }

    /// Binds most tightly: to what was told last.
    void postfix(const Make& make) { apply({0, 1, make}); }

    /// A bracket; `make` is told what it holds when it is closed.
    void open(Make make) {
        pending_.push_back({bracket, 1, std::move(make)});
        ++depth_;
    }

    void close() {
        reduce(0);
        apply(taken(pending_));
        --depth_;
    }

    /// How many brackets are open.
    std::size_t depth() const { return depth_; }

    /// What stands in the innermost bracket that is open.
    Operand finish() {
        reduce(0);
        return taken(operands_);
    }

private:
    static constexpr int bracket = -1;

    struct Pending {
        int binding;
        std::ptrdiff_t operands;
        Make make;
    };

    template <class Item>
    static Item taken(std::vector<Item>& items) {
        Item last = std::move(items.back());
        items.pop_back();
        return last;
    }

    void apply(const Pending& pending) {
        const auto first = operands_.end() - pending.operands;
        std::vector<Operand> given(std::make_move_iterator(first),
                                   std::make_move_iterator(operands_.end()));
        operands_.erase(first, operands_.end());
        operands_.push_back(pending.make(std::move(given)));
    }

    /// Applies the operators that wait and bind at least so tightly.
    void reduce(int least) {
        while (!pending_.empty() && pending_.back().binding >= least) apply(taken(pending_));
    }

    std::vector<Operand> operands_;
    std::vector<Pending> pending_;
    std::size_t depth_ = 0;
};

}  // namespace algae
