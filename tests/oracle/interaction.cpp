#include "oracle/interaction.hpp"

#include <algorithm>
#include <memory>
#include <ostream>

namespace algae::oracle {

namespace {

struct Axis;
/// A letter, or a branch.
struct Item {
    char letter = 0;
    std::shared_ptr<Axis> branch;
};
struct Axis {
    std::vector<Item> items;
};

Axis axis_of(const WrittenInteraction& system, const std::string& word, std::size_t& at) {
    Axis axis;
    while (at < word.size() && !(system.trees && word[at] == ']')) {
        const char letter = word[at++];
        if (system.trees && letter == '[') {
            axis.items.push_back({0, std::make_shared<Axis>(axis_of(system, word, at))});
            ++at;  // its ]
        } else {
            axis.items.push_back({letter, nullptr});
        }
    }
    return axis;
}

Axis tree_of(const WrittenInteraction& system, const std::string& word) {
    std::size_t at = 0;
    return axis_of(system, word, at);
}

class Step {
public:
    explicit Step(const WrittenInteraction& system) : system_(system) {}

    /// What becomes of an axis to which this path leads; the path is longer afterwards.
    std::string after(const Axis& axis, std::string& path) const {
        std::string out;
        for (std::size_t i = 0; i < axis.items.size(); ++i) {
            const Item& item = axis.items[i];
            if (item.branch) {
                std::string way = path;
                out += successor(way, '[', *item.branch, 0);
                out += after(*item.branch, way);
                out += successor(way, ']', axis, i + 1);
            } else {
                out += successor(path, item.letter, axis, i + 1);
                if (is_seen(item.letter)) path += item.letter;
            }
        }
        return out;
    }

private:
    bool is_seen(char letter) const { return system_.ignored.find(letter) == std::string::npos; }

    /// Whether the axis from `at` on begins like the context from `from` on.
    bool begins(const Axis& axis, std::size_t at, const Axis& context, std::size_t from) const {
        if (from == context.items.size()) return true;
        const Item& wanted = context.items[from];
        for (; at < axis.items.size(); ++at) {
            const Item& item = axis.items[at];
            if (item.branch) {
                if (wanted.branch && begins(*item.branch, 0, *wanted.branch, 0) &&
                    begins(axis, at + 1, context, from + 1))
                    return true;
            } else if (is_seen(item.letter)) {
                return !wanted.branch && item.letter == wanted.letter &&
                       begins(axis, at + 1, context, from + 1);
            }
        }
        return false;
    }

    static std::size_t letters(const std::string& context, bool trees) {
        return static_cast<std::size_t>(std::count_if(context.begin(), context.end(), [&](char c) {
            return !trees || (c != '[' && c != ']');
        }));
    }

    std::string successor(const std::string& path, char letter, const Axis& axis,
                          std::size_t at) const {
        const WrittenInteraction::Rule* best = nullptr;
        std::size_t most = 0;
        for (const WrittenInteraction::Rule& rule : system_.rules) {
            if (rule.letter != letter || !path.ends_with(rule.left)) continue;
            if (!begins(axis, at, tree_of(system_, rule.right), 0)) continue;
            const std::size_t size = rule.left.size() + letters(rule.right, system_.trees);
            if (best && size <= most) continue;
            best = &rule;
            most = size;
        }
        return best ? best->successor : std::string(1, letter);
    }

    const WrittenInteraction& system_;
};

}  // namespace

std::ostream& operator<<(std::ostream& out, const WrittenInteraction& system) {
    out << "axiom " << system.axiom;
    for (const auto& [left, letter, right, successor] : system.rules) {
        out << "; ";
        if (!left.empty()) out << left << " < ";
        out << letter;
        if (!right.empty()) out << " > " << right;
        out << " -> " << successor;
    }
    if (!system.ignored.empty()) {
        out << "; ignore";
        for (const char letter : system.ignored) out << ' ' << letter;
    }
    return out;
}

std::string after(const WrittenInteraction& system, const std::string& word) {
    std::string path;
    return Step(system).after(tree_of(system, word), path);
}

rc::Gen<WrittenInteraction> any_interaction(bool trees) {
    const std::string letters = trees ? "aabbc+[[]]" : "aabbc+";
    const auto word = [=](int most) {
        return rc::gen::map(any_word(letters, most),
                            [=](const std::string& w) { return trees ? balanced(w) : w; });
    };
    const auto rule = rc::gen::apply(
        [](std::string left, char letter, std::string right, std::string successor) {
            return WrittenInteraction::Rule{std::move(left), letter, std::move(right),
                                            std::move(successor)};
        },
        any_word("aabc", 3),
        rc::gen::elementOf(trees ? std::string("aaabbb+[]") : std::string("aabb+")),
        word(trees ? 5 : 3), word(3));
    const auto rules = rc::gen::mapcat(rc::gen::inRange(1, 9), [rule](int count) {
        return rc::gen::container<std::vector<WrittenInteraction::Rule>>(
            static_cast<std::size_t>(count), rule);
    });
    return rc::gen::apply(
        [trees](std::string axiom, std::vector<WrittenInteraction::Rule> all, bool ignores) {
            WrittenInteraction system{"ab+" + axiom, {}, ignores ? "+" : "", trees};
            for (auto& one : all) {
                const auto is_same = [&](const WrittenInteraction::Rule& other) {
                    return other.letter == one.letter && other.left == one.left &&
                           other.right == one.right;
                };
                if (std::none_of(system.rules.begin(), system.rules.end(), is_same))
                    system.rules.push_back(std::move(one));
            }
            return system;
        },
        word(14), rules, rc::gen::arbitrary<bool>());
}

}  // namespace algae::oracle
