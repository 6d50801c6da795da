#include "notation/format.hpp"

#include <map>
#include <utility>
#include <vector>

#include "notation/canonical.hpp"
#include "notation/read.hpp"
#include "notation/clauses.hpp"

namespace algae {

namespace {

/// The comments of one statement: on lines of their own above it, and behind it.
struct Comments {
    std::vector<std::string_view> above, behind;
};

/// A statement by its keyword and how many of the same keyword stand before it.
using Key = std::pair<std::string, std::size_t>;

/// Hands out the keys of statements in order. All `id` and all `alphabet` become one line.
class Keys {
public:
    Key next(const std::string& keyword) {
        if (keyword == "id" || keyword == "alphabet") return {keyword, 0};
        return {keyword, count_[keyword]++};
    }

private:
    std::map<std::string, std::size_t> count_;
};

void add_lines(const std::vector<std::string_view>& comments, std::string& out) {
    for (const std::string_view comment : comments) (out += comment) += '\n';
}

}  // namespace

std::string format_lsystem(std::string_view text, const std::string& file_name) {
    const LSystem system = read_lsystem(text, file_name);
    const std::vector<Clause> all = clauses(text);
    std::vector<std::string_view> top, end;
    std::map<Key, Comments> kept;
    Keys keys;
    Comments* before = nullptr;  // of the statement before the gap
    const auto take_gap = [&](const char* first, const char* last,
                              std::vector<std::string_view>& below) {
        for (const std::string_view comment :
             comments({first, static_cast<std::size_t>(last - first)})) {
            const std::string_view gap{first, static_cast<std::size_t>(comment.data() - first)};
            const bool same_line = before && gap.find('\n') == std::string_view::npos;
            (same_line ? before->behind : below).push_back(comment);
        }
    };
    for (const Clause& clause : all) {
        const Key key = keys.next(is_rule(clause) ? "->" : std::string(clause.keyword));
        Comments& own = kept[key];
        take_gap(clause.comments, clause.text.data(), before ? own.above : top);
        before = &own;
    }
    if (!all.empty()) {
        const std::string_view last = all.back().text;
        take_gap(last.data() + last.size(), text.data() + text.size(), end);
    }

    std::string out;
    add_lines(top, out);
    Keys printed;
    for (const CanonicalLine& line : canonical_lines(system)) {
        const auto comments = kept.find(printed.next(line.keyword));
        const bool has_comments = comments != kept.end();
        if (has_comments) add_lines(comments->second.above, out);
        // Only one comment has its place behind a statement.
        const bool behind = has_comments && comments->second.behind.size() == 1;
        if (has_comments && !behind) add_lines(comments->second.behind, out);
        out += line.text;
        if (behind) (out += ' ') += comments->second.behind.front();
        out += '\n';
        if (has_comments) kept.erase(comments);
    }
    for (const auto& [key, comments] : kept) {
        add_lines(comments.above, out);
        add_lines(comments.behind, out);
    }
    add_lines(end, out);
    return out;
}

}  // namespace algae
