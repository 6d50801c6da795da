#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "exact/exact.hpp"
#include "verify/detail/checking.hpp"
#include "verify/verify.hpp"

// What follows of derivations that are given as conditions, for all systems of a family without tables, all words and all numbers of
// steps. A tree of rules is worked out from its leaves: each node makes one derivation of those of its parts. Bound words and
// letters are symbols here. The rules hold because such a system replaces every letter by a successor of its own, whatever
// stands beside it.

namespace algae::verify {

namespace {

/// Numbers of steps as multiples of names, none of which is 0.
using Steps = std::map<std::string, Integer>;

struct Made {
    Word from, to;
    Steps steps;
};

Steps sum(Steps left, const Steps& right) {
    for (const auto& [name, times] : right) left[name] += times;
    return left;
}

class Trees {
public:
    explicit Trees(const Obligation& task)
        : task_(task), said_(*task.statement.quantified), body_(task.statement.parts.back()) {
        if (!said_.universal || !task.holds || body_.negated) task.wrong_kind();
        for (std::size_t i = 0; i + 1 < task.statement.parts.size(); ++i) {
            const Statement& condition = task.statement.parts[i];
            given_.emplace_back();
            if (condition.kind != Statement::Kind::derives || condition.negated || !condition.from)
                continue;
            const std::string& name = condition.systems[0].name;
            if (condition.systems[0].system) continue;  // not a bound name
            if (!system_.empty() && system_ != name) continue;
            system_ = name;
            given_.back() =
                Made{*condition.from, condition.word, steps_of(condition, "#" + std::to_string(i))};
        }
        if (system_.empty()) task.refuse("no condition is a derivation of a bound system");
        const auto is_it = [&](const Quantified::Name& name) { return name.name == system_; };
        const auto found = std::find_if(said_.names.begin(), said_.names.end(), is_it);
        if (found == said_.names.end()) task.refuse("the system is bound outside the statement");
        for (const char* family : {"0L systems", "P0L systems", "D0L systems", "PD0L systems"})
            if (found->of == family) family_ = found->of;
        if (family_.empty()) task.refuse("the rules hold of systems without tables only");
    }

    void check() {
        const std::vector<Field> cases = task_.proof.at("cases").list();
        if (!task_.proof.has("split")) {
            if (cases.size() != 1) task_.proof.at("cases").refuse("expected one case");
            return check_case(cases.front());
        }
        const Field split = task_.proof.at("split");
        const Made& cut = condition(split);
        if (cut.from.empty()) split.refuse("the condition derives from the empty word");
        for (const Symbol a : cut.to)
            for (const Quantified::Name& name : said_.names)
                if (name.of != "letters" && task_.alphabet().find(name.name) == a)
                    split.refuse("the word that is cut has a bound word in it");
        std::size_t next = 0;
        std::vector<Word> pieces;
        const auto choose = [&](const auto& self, std::size_t begin) -> void {
            task_.budget.check();
            if (pieces.size() + 1 == cut.from.size()) {
                pieces.emplace_back(cut.to.begin() + static_cast<std::ptrdiff_t>(begin),
                                    cut.to.end());
                parts_.clear();
                for (std::size_t k = 0; k < pieces.size(); ++k)
                    parts_.push_back({{cut.from[k]}, pieces[k], cut.steps});
                if (next == cases.size()) task_.proof.at("cases").refuse("a case is missing");
                check_case(cases[next++]);
                pieces.pop_back();
                return;
            }
            for (std::size_t end = begin; end <= cut.to.size(); ++end) {
                pieces.emplace_back(cut.to.begin() + static_cast<std::ptrdiff_t>(begin),
                                    cut.to.begin() + static_cast<std::ptrdiff_t>(end));
                self(self, end);
                pieces.pop_back();
            }
        };
        choose(choose, 0);
        if (next != cases.size()) task_.proof.at("cases").refuse("there are more cases than cuts");
    }

private:
    static Steps steps_of(const Statement& derivation, const std::string& name) {
        if (derivation.bound_steps) return *derivation.bound_steps;
        if (!derivation.steps) return {{name, Integer(1)}};
        return derivation.steps->is_zero() ? Steps{} : Steps{{"1", *derivation.steps}};
    }

    const Made& condition(const Field& index) const {
        const std::uint64_t i = index.number();
        if (i >= given_.size() || !given_[static_cast<std::size_t>(i)])
            index.refuse("this condition is no derivation of the system");
        return *given_[static_cast<std::size_t>(i)];
    }

    Made made(const Field& tree, std::size_t depth = 0) const {
        if (depth > 100) throw BoundReached(Bound::method, "a tree deeper than 100 is not checked");
        task_.budget.check();
        const std::string& rule = tree.at("rule").text();
        if (rule == "given" || rule == "part") {
            tree.only({"rule", "index"});
            if (rule == "given") return condition(tree.at("index"));
            const std::uint64_t i = tree.at("index").number();
            if (i >= parts_.size()) tree.at("index").refuse("there is no such part");
            return parts_[static_cast<std::size_t>(i)];
        }
        if (rule == "identity") {
            tree.only({"rule", "word"});
            const Word word = task_.reader.word(tree.at("word"));
            return {word, word, {}};
        }
        if (rule == "empty") {
            tree.only({"rule", "steps"});
            Steps steps;
            if (tree.has("steps"))
                for (const auto& [name, times] : tree.at("steps").object())
                    if (const Integer count = times.integer(); !count.is_zero())
                        steps[name] = count;
            return {{}, {}, steps};
        }
        if (rule != "product" && rule != "chain")
            tree.at("rule").fail("there is no rule '" + rule + "'");
        tree.only({"rule", "parts"});
        const auto [first, second] = tree.at("parts").pair();
        Made left = made(first, depth + 1), right = made(second, depth + 1);
        if (rule == "chain") {
            if (left.to != right.from)
                tree.refuse("the second derivation does not begin where the first one ends");
            return {left.from, right.to, sum(left.steps, right.steps)};
        }
        if (left.steps != right.steps) tree.refuse("the two derivations have not as many steps");
        left.from.insert(left.from.end(), right.from.begin(), right.from.end());
        left.to.insert(left.to.end(), right.to.begin(), right.to.end());
        return left;
    }

    void check_case(const Field& trees) const {
        std::vector<Made> all;
        for (const Field& tree : trees.list()) all.push_back(made(tree));
        using Kind = Statement::Kind;
        const auto refuse = [&] { trees.refuse("the trees do not show the statement"); };
        if (body_.kind == Kind::derives) {
            const bool is_any = !body_.steps && !body_.bound_steps;
            if (all.size() != 1 || body_.systems[0].system || body_.systems[0].name != system_ ||
                !body_.from || all[0].from != *body_.from || all[0].to != body_.word ||
                (!is_any && all[0].steps != steps_of(body_, "")))
                refuse();
        } else if (body_.kind == Kind::numbers) {
            const bool turned = body_.family == ">=";
            const Reader named = reader().with(open_names(said_, task_.alphabet()));
            const auto smaller = word_measured(body_.terms[turned ? 1 : 0], named),
                       larger = word_measured(body_.terms[turned ? 0 : 1], named);
            if (!family_.starts_with('P') || (!turned && body_.family != "<=") || all.size() != 1 ||
                !smaller || !larger || all[0].from != Word{*smaller} || all[0].to != Word{*larger})
                refuse();
        } else if (body_.kind == Kind::equal) {
            const auto is_word = [](const Language& language, const Word& word) {
                return language->kind == Tree::Kind::words &&
                       language->words == std::vector<Word>{word};
            };
            const bool deterministic = family_.starts_with('D') || family_.starts_with("PD");
            if (!deterministic || all.size() != 2 || all[0].from != all[1].from ||
                all[0].steps != all[1].steps || !is_word(body_.languages[0], all[0].to) ||
                !is_word(body_.languages[1], all[1].to))
                refuse();
        } else {
            task_.wrong_kind();
        }
    }

    const Reader& reader() const { return task_.reader; }

    const Obligation& task_;
    const Quantified& said_;
    const Statement& body_;
    std::vector<std::optional<Made>> given_;  // by condition
    std::vector<Made> parts_;
    std::string system_, family_;
};

}  // namespace

void check_derivations(const Obligation& task) { Trees(task).check(); }

}  // namespace algae::verify
