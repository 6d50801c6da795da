#include "notation/format.hpp"

#include <map>
#include <utility>
#include <vector>

#include "notation/canonical.hpp"
#include "notation/clauses.hpp"
#include "notation/read.hpp"
#include "notation/system_block.hpp"

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

/// The lines with the comments of a text, whose clauses say the same.
class Formatter {
public:
    Formatter(std::string_view text, std::string indent) : indent_(std::move(indent)) {
        gather(text);
    }

    std::string formatted(const std::vector<CanonicalLine>& lines) {
        add_lines(top_);
        Keys printed;
        for (const CanonicalLine& line : lines) add(line, printed.next(line.keyword));
        for (const auto& [key, comments] : kept_) {
            add_lines(comments.above);
            add_lines(comments.behind);
        }
        add_lines(end_);
        return std::move(out_);
    }

private:
    void gather(std::string_view text) {
        const std::vector<Clause> all = clauses(text);
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
            Comments& own = kept_[key];
            take_gap(clause.comments, clause.text.data(), before ? own.above : top_);
            std::size_t bytes = 0;
            if (const auto block = system_block(clause.text, bytes); block && !clause.arrow)
                bodies_.emplace(key, block->body);
            before = &own;
        }
        const char* const last =
            all.empty() ? text.data() : all.back().text.data() + all.back().text.size();
        // A text of comments only is not read as a system, but the body of one within may be one.
        take_gap(last, text.data() + text.size(), end_);
    }

    void add(const CanonicalLine& line, const Key& key) {
        const auto comments = kept_.find(key);
        const bool has_comments = comments != kept_.end();
        if (has_comments) add_lines(comments->second.above);
        // Only one comment has its place behind a statement.
        const bool behind = has_comments && comments->second.behind.size() == 1;
        if (has_comments && !behind) add_lines(comments->second.behind);
        out_ += indent_ + line.text;
        if (const auto body = bodies_.find(key); body != bodies_.end())
            out_ += '\n' + Formatter(body->second, indent_ + "    ").formatted(line.inside) +
                    indent_ + '}';
        if (behind) (out_ += ' ') += comments->second.behind.front();
        out_ += '\n';
        if (has_comments) kept_.erase(comments);
    }

    void add_lines(const std::vector<std::string_view>& comments) {
        for (const std::string_view comment : comments) ((out_ += indent_) += comment) += '\n';
    }

    std::string indent_, out_;
    std::vector<std::string_view> top_, end_;
    std::map<Key, Comments> kept_;
    std::map<Key, std::string_view> bodies_;  // of systems within
};

}  // namespace

std::string format_lsystem(std::string_view text, const std::string& file_name) {
    const LSystem system = read_lsystem(text, file_name);
    return Formatter(text, "").formatted(canonical_lines(system));
}

}  // namespace algae
