#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "model/model.hpp"

#include "notation/detail/reading.hpp"

// The canonical text of a system, and of a file with its comments.
//
// The canonical text has one statement a line, in the order of the table of settings, which knows how the value of
// each is printed (settings.cpp); rules, and the tables among them, are laid out here. Blanks stand only where
// two symbols would otherwise be read as one (`Spellings`), so none around a `|` that would then separate
// successors. It reads back as the same system, and its own canonical text is itself. Care is needed where a
// text would be read as something else: a word that begins like a shape successor gets a blank before its
// bracket, a rule that begins like a setting gets `ε` in front.
//
// Formatting a file is more: comments stay with their statements. As statements move, a comment is kept by
// its statement's keyword and how many statements of this keyword stand before it, in the file and in the
// canonical text alike (`Keys`). Comments at the top stay there; those whose statement is not printed come at
// the end.

namespace algae {

namespace {

std::string print_arguments(const std::vector<Expression>& arguments) {
    std::string out;
    for (const Expression& argument : arguments)
        out += (out.empty() ? "(" : ",") + to_text(argument);
    return out + ')';
}

std::string print_splices(const std::vector<Expression>& words) {
    std::string out;
    for (const Expression& word : words) {
        const bool is_plain = word.kind != Expression::Kind::binary;  // > would end it
        out += (is_plain ? "<" : "<(") + to_text(word) + (is_plain ? ">" : ")>");
    }
    return out;
}

std::string print_parameters(const std::vector<std::string>& names) {
    std::string out;
    for (const std::string& name : names) out += (out.empty() ? "(" : ",") + name;
    return out.empty() ? out : out + ')';
}

std::string print_size(const ShapeSuccessor::Size& size) {
    const std::string text = to_text(size.value);
    if (!size.relative) return text;
    // An r behind a name or an exponent would be read as part of it.
    const bool is_plain = text.find_first_not_of("0123456789.") == std::string::npos;
    return is_plain ? text + 'r' : '(' + text + ")r";
}

/// The text of a word, `div (3)`, that is not taken for a shape successor.
std::string without_shape(std::string text) {
    for (const std::string_view shape : {"div(", "repeat(", "Split("})
        if (text.starts_with(shape)) return text.insert(shape.size() - 1, " ");
    return text;
}

/// The text of a rule that is not taken for a setting because of its left context.
std::string without_setting(std::string text) {
    for (const char* setting : {"title ", "source ", "interpret ", "system "})
        if (text.starts_with(setting)) return "ε " + text;
    return text;
}

}  // namespace

std::string Printer::word(const ModuleWord& word) const {
    if (word.letters.empty() && word.splices.empty()) return "ε";
    std::string out;
    auto arguments = word.arguments.begin();
    auto splices = word.splices.begin();
    bool is_bare = false;  // a name, not a closing bracket, stands before
    for (std::size_t i = 0;; ++i) {
        if (splices != word.splices.end() && splices->first == i) {
            out += print_splices((splices++)->second);
            is_bare = false;
        }
        if (i == word.letters.size()) break;
        if (is_bare && spellings_.blank_between(word.letters[i - 1], word.letters[i])) out += ' ';
        out += alphabet_.name(word.letters[i]);
        is_bare = arguments == word.arguments.end() || arguments->first != i;
        if (!is_bare) out += print_arguments((arguments++)->second);
    }
    return out;
}

std::string Printer::apart(const Word& symbols) const {
    return joined(symbols, " ", [&](Symbol symbol) { return alphabet_.name(symbol); });
}

std::string Printer::pattern(const Pattern& pattern, const char* separator) const {
    std::string out;
    const ModulePattern* before = nullptr;
    for (const ModulePattern& module : pattern) {
        if (before) out += separator;
        if (before && !*separator && before->parameters.empty() &&
            spellings_.blank_between(before->symbol, module.symbol))
            out += ' ';
        out += alphabet_.name(module.symbol) + print_parameters(module.parameters);
        before = &module;
    }
    return out;
}

std::string Printer::shape(const ShapeSuccessor& shape) const {
    if (shape.operation == "I") return "I(" + apart(shape.parts) + ')';
    std::string out = shape.operation + '(' + shape.axis;
    if (shape.axis.size() > 1) out.erase(std::unique(out.begin() + 4, out.end()), out.end());
    for (std::size_t i = 0; i < shape.sizes.size(); ++i) {
        const bool turns = i > 0 && shape.axis.size() > 1 && shape.axis[i] != shape.axis[i - 1];
        out += (turns ? " : " : ", ") + print_size(shape.sizes[i]);
    }
    return out + "){ " + apart(shape.parts) + " }";
}

std::string Printer::rule(const Production& rule) const {
    std::string out;
    if (!rule.left.empty()) out += pattern(rule.left, "") + " < ";
    out += pattern({rule.predecessor}, "");
    if (!rule.right.empty()) out += " > " + pattern(rule.right, "");
    if (!rule.elsewhere.empty()) out += " ? " + pattern(rule.elsewhere, ", ");
    if (rule.condition) out += " : " + to_text(*rule.condition);
    if (rule.probability)
        out += " -(" + to_text(quantity(*rule.probability).expression) + ")-> ";
    else
        out += " -> ";
    std::string successor = rule.shape ? shape(*rule.shape) : without_shape(word(rule.successor));
    // `| _` would miss a successor before the bar; only among longer names are its blanks needed.
    if (successor.starts_with("| ") &&
        std::ranges::none_of(alphabet_.long_names(), [&](Symbol symbol) {
            return is_declared_only(alphabet_.name(symbol));
        }))
        successor.erase(1, 1);
    out += successor;
    return without_setting(std::move(out));
}

std::string print_word(const Alphabet& alphabet, const ModuleWord& word) {
    return Printer(alphabet).word(word);
}

std::string print_rule(const Alphabet& alphabet, const Production& rule) {
    return Printer(alphabet).rule(rule);
}

namespace {

/// One line of the canonical text.
struct CanonicalLine {
    std::string keyword;                     // the setting's; "->" of a rule
    std::string text;                        // the whole line, without its break
    std::vector<CanonicalLine> inside = {};  // of `system leaf {`: the lines up to its brace
};

using Lines = std::vector<CanonicalLine>;

void add(const std::string& keyword, const std::string& value, Lines& lines) {
    if (!value.empty()) lines.push_back({keyword, keyword + ' ' + value});
}

/// The rules, each table opened before its first rule or, if it has none, before the next one.
void add_rules(const LSystem& system, const Printer& printer, Lines& lines) {
    std::size_t opened = 0;
    const auto open_tables = [&](std::size_t end) {
        for (; opened < end; ++opened) add("table", system.tables[opened], lines);
    };
    for (const Production& rule : system.rules) {
        if (!system.tables.empty()) open_tables(rule.table + 1);
        lines.push_back({"->", printer.rule(rule)});
    }
    open_tables(system.tables.size());
}

/// The statements of a system, or of one that stands `within` another.
Lines lines_of(const Printing& printing, bool within) {
    Lines lines;
    for (const Setting& setting : settings()) {
        if (setting.stage == Stage::rule) add_rules(printing.system, printing.printer, lines);
        if (setting.stage == Stage::inner)
            for (const InnerSystem& inner : printing.system.inner)
                lines.push_back({setting.name(), setting.name() + ' ' + inner.name + " {",
                                 lines_of({inner.system, printing.drawing, printing.expectations,
                                           printing.coding, printing.printer, nullptr},
                                          true)});
        if (!setting.print || (within && !setting.within)) continue;
        for (const std::string& value : setting.print(printing)) add(setting.name(), value, lines);
    }
    return lines;
}

/// The canonical text of a system, line by line.
Lines canonical_lines(const Model& system, const OwnFunctions* functions = nullptr) {
    const Printer printer(system.alphabet);
    return lines_of(
        {system, system.drawing, system.expectations, system.coding, printer, functions}, false);
}

}  // namespace

std::string print_lsystem(const Model& system) {
    std::string out;
    for (const CanonicalLine& line : canonical_lines(system)) {
        out += line.text + '\n';
        for (const CanonicalLine& inner : line.inside) out += "    " + inner.text + '\n';
        if (line.keyword == "system") out += "}\n";
    }
    return out;
}

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
    Key next(const std::string& keyword) { return next(keyword, 1); }
    /// The key of the first of `lines` lines that a statement becomes.
    Key next(const std::string& keyword, std::size_t lines) {
        if (keyword == "id" || keyword == "alphabet") return {keyword, 0};
        return {keyword, std::exchange(count_[keyword], count_[keyword] + lines)};
    }

private:
    std::map<std::string, std::size_t> count_;
};

/// The lines with the comments of a text, whose clauses say the same. In a `spaced` text `|` between
/// blanks is a letter.
class Formatter {
public:
    Formatter(std::string_view text, std::string indent, bool spaced)
        : indent_(std::move(indent)), spaced_(spaced) {
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
            const bool has_rules = is_rule(clause) || clause.has_word("interpret");
            const Key key = keys.next(is_rule(clause) ? "->" : std::string(clause.keyword),
                                      has_rules ? successor_count(clause, spaced_) : 1);
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
            out_ += '\n' +
                    Formatter(body->second, indent_ + "    ", spaced_).formatted(line.inside) +
                    indent_ + '}';
        if (behind) (out_ += ' ') += comments->second.behind.front();
        out_ += '\n';
        if (has_comments) kept_.erase(comments);
    }

    void add_lines(const std::vector<std::string_view>& comments) {
        for (const std::string_view comment : comments) ((out_ += indent_) += comment) += '\n';
    }

    std::string indent_, out_;
    bool spaced_;
    std::vector<std::string_view> top_, end_;
    std::map<Key, Comments> kept_;
    std::map<Key, std::string_view> bodies_;  // of systems within
};

}  // namespace

std::string format_lsystem(std::string_view text, const std::string& file_name) {
    OwnFunctions functions(true);
    const Model system = read_whole(text, file_name, [&](const Source& source, Findings& findings) {
        Model read = read_system(text, source, findings, file_name, {}, {}, {}, false, &functions);
        findings.throw_if_any();
        return read;
    });
    const bool spaced = std::ranges::any_of(system.declared, [&](Symbol symbol) {
        return is_declared_only(system.alphabet.name(symbol));
    });
    return Formatter(text, "", spaced).formatted(canonical_lines(system, &functions));
}

}  // namespace algae
