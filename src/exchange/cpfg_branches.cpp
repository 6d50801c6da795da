#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "exchange/detail/cpfg.hpp"

// Which branches may stand side by side in the words of a system of cpfg.
//
// `A > [B=]C` looks at the first branch behind A there, and at any of those that stand together in the notation. Both mean the same where no
// other of them can begin as the context says, or where no more of them can stand together than the context names. Each bracket in the
// axiom and the successors is a symbol of its own here, and pairs of symbols that may be neighbours are closed under what rules make of
// them: what stands at the ends of successors, and letters that contexts skip or that leave nothing.

namespace algae {

namespace {

class Neighbours {
public:
    Neighbours(const std::vector<CpfgWord>& words, const std::set<std::string>& skipped)
        : empty_(skipped) {
        for (const CpfgWord& word : words) number_brackets(word);
        for (std::size_t size = 0, now = 1; size != now; now = count()) {
            size = now;
            for (const CpfgWord& word : words_) walk(word);
            close();
        }
    }

    bool is_known() const { return is_known_; }

    /// The number of branches that may stand together; nothing if there is no bound.
    std::optional<std::size_t> most_together() const {
        std::size_t longest = 0;
        std::map<std::size_t, std::size_t> found;  // by branch: of those that begin with it
        for (std::size_t round = 0; round <= branches_ + 1; ++round) {
            bool changed = false;
            for (std::size_t i = 0; i < branches_; ++i) {
                std::size_t more = 1;
                for (std::size_t next = 0; next < branches_; ++next)
                    if (stand_together(i, next)) more = std::max(more, found[next] + 1);
                changed = changed || more != found[i];
                found[i] = more;
                longest = std::max(longest, more);
            }
            if (!changed) return longest;
        }
        return std::nullopt;
    }

    /// Whether a branch that stands behind another may begin with this letter.
    bool begins_another(const std::string& letter) const {
        for (std::size_t i = 0; i < branches_; ++i)
            for (std::size_t next = 0; next < branches_; ++next)
                if (stand_together(i, next) && pairs_.contains({open(next), letter})) return true;
        return false;
    }

private:
    static std::string open(std::size_t branch) { return "[" + std::to_string(branch); }
    static std::string closed(std::size_t branch) { return "]" + std::to_string(branch); }
    bool stand_together(std::size_t one, std::size_t next) const {
        return pairs_.contains({closed(one), open(next)});
    }

    void number_brackets(const CpfgWord& word) {
        CpfgWord numbered{word.owner, {}};
        std::vector<std::size_t> inside;
        is_known_ = is_known_ && word.owner != "[" && word.owner != "]";
        for (const std::string& letter : word.letters) {
            if (letter == "[") {
                inside.push_back(branches_++);
                numbered.letters.push_back(open(inside.back()));
            } else if (letter == "]") {
                if (inside.empty()) {
                    is_known_ = false;
                    continue;
                }
                numbered.letters.push_back(closed(inside.back()));
                inside.pop_back();
            } else {
                numbered.letters.push_back(letter);
            }
        }
        is_known_ = is_known_ && inside.empty();
        words_.push_back(std::move(numbered));
    }

    void walk(const CpfgWord& word) {
        std::vector<std::string> before;  // what may stand just before
        bool at_start = true;
        for (const std::string& letter : word.letters) {
            for (const std::string& one : before) pairs_.emplace(one, letter);
            if (at_start) begins_[word.owner].insert(letter);
            if (!empty_.contains(letter)) {
                before.clear();
                at_start = false;
            }
            before.push_back(letter);
        }
        if (word.owner.empty()) return;
        ends_[word.owner].insert(before.begin(), before.end());
        if (at_start) empty_.insert(word.owner);
    }

    void close() {
        const std::set<std::pair<std::string, std::string>> known = pairs_;
        for (const auto& [left, right] : known) {
            if (const auto last = ends_.find(left); last != ends_.end())
                for (const std::string& one : last->second) pairs_.emplace(one, right);
            if (const auto first = begins_.find(right); first != begins_.end())
                for (const std::string& one : first->second) pairs_.emplace(left, one);
            if (empty_.contains(right))
                for (auto next = known.lower_bound({right, ""});
                     next != known.end() && next->first == right; ++next)
                    pairs_.emplace(left, next->second);
        }
    }

    std::size_t count() const {
        std::size_t all = pairs_.size() + empty_.size();
        for (const auto* sides : {&begins_, &ends_})
            for (const auto& [owner, letters] : *sides) all += letters.size();
        return all + 2;
    }

    std::vector<CpfgWord> words_;
    std::size_t branches_ = 0;
    bool is_known_ = true;  // each bracket has its partner in its word
    std::set<std::string> empty_;
    std::set<std::pair<std::string, std::string>> pairs_;
    std::map<std::string, std::set<std::string>> begins_, ends_;
};

}  // namespace

bool only_first_branches_match(const std::vector<CpfgModule>& context,
                               const std::vector<CpfgWord>& words,
                               const std::set<std::string>& skipped) {
    // Groups of branches of the context that stand together, by the letters that they begin with.
    std::vector<std::vector<std::string>> groups;
    std::vector<std::size_t> ended;  // by depth: where the last branch ended
    for (std::size_t i = 0, depth = 0; i < context.size(); ++i) {
        if (context[i].symbol == "]") {
            depth -= depth > 0 ? 1 : 0;
            ended.resize(depth + 1, context.size());
            ended[depth] = i + 1;
        } else if (context[i].symbol == "[") {
            ended.resize(depth + 1, context.size());
            if (ended[depth] != i) groups.emplace_back();
            const bool is_any = i + 1 == context.size() || context[i + 1].symbol == "]";
            groups.back().push_back(is_any ? "" : context[i + 1].symbol);
            ++depth;
        }
    }
    if (groups.empty()) return true;
    const Neighbours neighbours(words, skipped);
    if (!neighbours.is_known()) return false;
    const std::optional<std::size_t> most = neighbours.most_together();
    return std::ranges::all_of(groups, [&](const std::vector<std::string>& group) {
        if (most && *most <= group.size()) return true;
        return group.size() == 1 && group[0] != "[" &&
               (group[0].empty() || !neighbours.begins_another(group[0]));
    });
}

}  // namespace algae
