#include <algorithm>
#include <optional>
#include <utility>

#include "exchange/detail/cpfg.hpp"
#include "exchange/detail/scanner.hpp"
#include "exchange/exchange.hpp"

// Texts of cpfg, L-Py and lpfg before their meaning: files that are included, comments and macros.
//
// Files that a text includes are put in first, between lines `# 1 "NAME"` as preprocessors of C write them, by which errors name places of
// these files. The preprocessor replaces names by the texts of `#define`, again and again; what comes of a macro stands where the macro stood,
// so that errors name a place of the file.

namespace algae {

namespace {

/// The file that a line `# 1 "NAME"` or `#line 1 "NAME"` names, and the number of the line behind it; nothing if it is no such line.
std::optional<std::pair<std::size_t, std::string>> line_marker(std::string_view line) {
    if (!line.starts_with('#')) return std::nullopt;
    std::vector<std::string_view> words = blank_separated(line);
    if (words[0] != "#" && words[0] != "#line") return std::nullopt;
    const std::size_t open = line.find('"'), close = line.rfind('"');
    constexpr std::size_t most_digits = 9;
    if (words.size() < 3 || words[1].size() > most_digits ||
        words[1].find_first_not_of("0123456789") != std::string_view::npos ||
        open == std::string_view::npos || close == open)
        return std::nullopt;
    return std::pair{static_cast<std::size_t>(std::stoul(std::string(words[1]))),
                     std::string(line.substr(open + 1, close - open - 1))};
}

class Preprocessor {
public:
    Preprocessor(const Source& source, const CpfgDialect& dialect)
        : source_(source), text_(source.text()), dialect_(dialect) {}

    /// Without comments, macros replaced; the part of L-Py that the editor saves is cut off.
    Placed preprocessed() {
        Placed out;
        std::string_view text = text_;
        if (dialect_.python) text = text.substr(0, text.find("###### INITIALISATION ######"));
        for (std::size_t i = 0; i < text.size();) {
            const bool line_begins = i == 0 || text[i - 1] == '\n';
            if (dialect_.python) {
                if (text[i] == '#') {
                    while (i < text.size() && text[i] != '\n') ++i;
                    continue;
                }
            } else {
                if (text.substr(i).starts_with("/*")) {
                    const std::size_t end = text.find("*/", i + 2);
                    if (end == std::string_view::npos) fail(i, "a comment that is never closed");
                    i = end + 2;
                    continue;
                }
                if (text.substr(i).starts_with("//")) {
                    while (i < text.size() && text[i] != '\n') ++i;
                    continue;
                }
                if (line_begins && text[i] == '#') {
                    const std::size_t next = directive(text, i);
                    // The line itself stays, empty: it can stand for the rules of a system.
                    if (next > 0 && text[next - 1] == '\n') out.add('\n', next - 1);
                    i = next;
                    continue;
                }
                if (is_left_out()) {
                    if (text[i] == '\n') out.add('\n', i);
                    ++i;
                    continue;
                }
                if (is_name_start(text[i]) && (i == 0 || !is_name_part(text[i - 1]))) {
                    i = expand(text, i, i, out, 0);
                    continue;
                }
            }
            if (text[i] != '\r') out.add(text[i], i);
            ++i;
        }
        if (!conditions_.empty()) fail(conditions_.back().place, "expected #endif, found none");
        return out;
    }

private:
    struct Macro {
        std::vector<std::string> parameters;
        bool takes = false;
        std::string body;
    };

    /// A line of the preprocessor; gives where the next line begins.
    std::size_t directive(std::string_view text, std::size_t at) {
        std::size_t end = at;
        std::string line;
        while (end < text.size() && text[end] != '\n') {
            if (text[end] == '\\' && end + 1 < text.size() && text[end + 1] == '\n') {
                end += 2;
                continue;
            }
            if (text.substr(end).starts_with("//")) {
                while (end < text.size() && text[end] != '\n') ++end;
                break;
            }
            if (text.substr(end).starts_with("/*")) {
                const std::size_t close = text.find("*/", end + 2);
                end = close == std::string_view::npos ? text.size() : close + 2;
                continue;
            }
            line += text[end++];
        }
        std::size_t i = 1;
        const auto word = [&] {
            while (i < line.size() && (line[i] == ' ' || line[i] == '\t')) ++i;
            std::string found;
            while (i < line.size() && is_name_part(line[i])) found += line[i++];
            return found;
        };
        const std::string kind = word();
        const std::size_t next = std::min(end + 1, text.size());
        if (kind == "if" || kind == "ifdef" || kind == "ifndef" || kind == "elif" ||
            kind == "else" || kind == "endif") {
            condition(kind, line.substr(std::min(i, line.size())), at);
            return next;
        }
        if (is_left_out()) return next;
        if (kind == "include" && dialect_.plus) {
            // The modules of lpfgall.h are known, and what headers of C declare is known or refused where it is used.
            if (line.find("lpfgall.h") != std::string::npos ||
                (line.find('<') != std::string::npos && line.find('"') == std::string::npos))
                return next;
        }
        if (line_marker(text.substr(at, text.find('\n', at) - at))) return next;
        if (kind == "include")
            fail(at, line.find('"') == std::string::npos
                         ? "the program's own files are not read: expected #include \"NAME\" with "
                           "a file in the folder of this one or below"
                         : "expected a file of this name in the folder of the one that includes "
                           "it or below, found none: " +
                               line);
        if (kind == "undef") {
            macros_.erase(word());
            return next;
        }
        if (kind != "define")
            refuse(at, "#" + kind, "is not read: expected #define, #undef, #include or #if");
        const std::string name = word();
        if (name.empty()) fail(at, "expected a name behind #define");
        Macro macro;
        if (i < line.size() && line[i] == '(') {
            macro.takes = true;
            for (++i; i < line.size() && line[i] != ')';) {
                const std::string parameter = word();
                if (parameter.empty()) fail(at, "expected names between the brackets of #define");
                macro.parameters.push_back(parameter);
                while (i < line.size() && (line[i] == ' ' || line[i] == ',')) ++i;
            }
            ++i;
        }
        macro.body = i < line.size() ? line.substr(i) : "";
        macro.body.erase(0, std::min(macro.body.find_first_not_of(" \t\r"), macro.body.size()));
        macro.body.erase(macro.body.find_last_not_of(" \t\r") + 1);
        macros_[name] = macro;
        return next;
    }

    /// A part of the text that is taken or left out.
    struct Condition {
        std::size_t place = 0;
        bool taken = false, was_taken = false, has_else = false;
    };
    bool is_left_out() const {
        return std::ranges::any_of(conditions_, [](const Condition& one) { return !one.taken; });
    }

    void condition(const std::string& kind, const std::string& rest, std::size_t at) {
        const bool opens = kind.starts_with("if");
        if (!opens && conditions_.empty()) fail(at, "#" + kind + " without #if");
        if (kind == "endif") return conditions_.pop_back();
        if (opens) {
            const bool outside = is_left_out();
            conditions_.push_back({at, false, outside, false});
            if (outside) return;
            std::string name(rest);
            std::erase_if(name, [](char c) { return !is_name_part(c); });
            conditions_.back().taken =
                kind == "if" ? holds(rest, at) : macros_.contains(name) == (kind == "ifdef");
        } else {
            Condition& here = conditions_.back();
            if (here.has_else) fail(at, "#" + kind + " behind #else");
            here.has_else = kind == "else";
            here.taken = !here.was_taken && (kind == "else" || holds(rest, at));
        }
        conditions_.back().was_taken = conditions_.back().was_taken || conditions_.back().taken;
    }

    /// Whether an expression of #if is other than 0.
    bool holds(const std::string& said, std::size_t at) {
        std::string text;
        for (std::size_t i = 0; i < said.size();) {
            if (!is_name_start(said[i])) {
                text += said[i++];
                continue;
            }
            std::size_t stop = i;
            while (stop < said.size() && is_name_part(said[stop])) ++stop;
            if (said.substr(i, stop - i) == "defined") {
                while (stop < said.size() && !is_name_start(said[stop])) ++stop;
                std::size_t end = stop;
                while (end < said.size() && is_name_part(said[end])) ++end;
                text += macros_.contains(said.substr(stop, end - stop)) ? "1" : "0";
                while (end < said.size() && said[end] == ')') ++end;
                i = end;
                continue;
            }
            Placed value;
            i = expand(said, i, at, value, 1);
            text += value.text;
        }
        Placed placed;
        for (const char c : text)
            if (!std::isspace(static_cast<unsigned char>(c)) || c == ' ') placed.add(c, at);
        const std::string expression =
            cpfg_expression(source_, dialect_, placed.trimmed(), {}, CpfgNames{});
        const Quantity value =
            evaluate(read_expression(expression),
                     [](const std::string&) -> const Quantity* { return nullptr; });
        return value.value != 0;
    }

    /// Appends a name or what it stands for; gives where the text goes on.
    std::size_t expand(std::string_view text, std::size_t at, std::size_t place, Placed& out,
                       std::size_t depth) {
        constexpr std::size_t deepest = 50, longest = 1'000'000;
        std::size_t end = at;
        while (end < text.size() && is_name_part(text[end])) ++end;
        const std::string name(text.substr(at, end - at));
        const auto macro = macros_.find(name);
        if (depth > deepest || out.text.size() > longest)
            fail(place, "macros that go round in circles, or become too long");
        if (macro == macros_.end()) {
            for (std::size_t i = at; i < end; ++i) out.add(text[i], depth == 0 ? i : place);
            return end;
        }
        std::vector<std::string> values;
        if (macro->second.takes) {
            std::size_t i = end;
            while (i < text.size() && text[i] == ' ') ++i;
            if (i >= text.size() || text[i] != '(') {
                for (std::size_t k = at; k < end; ++k) out.add(text[k], depth == 0 ? k : place);
                return end;
            }
            std::size_t open = 0;
            std::string value;
            for (; i < text.size(); ++i) {
                const char c = text[i];
                if (c == '(' && open++ == 0) continue;
                if (c == ')' && --open == 0) break;
                if (c == ',' && open == 1) {
                    values.push_back(value);
                    value.clear();
                } else {
                    value += c;
                }
            }
            values.push_back(value);
            if (values.size() != macro->second.parameters.size())
                fail(place, "the macro " + name + " has " +
                                std::to_string(macro->second.parameters.size()) +
                                " parameters, found " + std::to_string(values.size()));
            end = std::min(i + 1, text.size());
        }
        std::string body;
        const std::string& written = macro->second.body;
        for (std::size_t i = 0; i < written.size();) {
            if (!is_name_start(written[i])) {
                body += written[i++];
                continue;
            }
            std::size_t stop = i;
            while (stop < written.size() && is_name_part(written[stop])) ++stop;
            const std::string part = written.substr(i, stop - i);
            const auto parameter = std::ranges::find(macro->second.parameters, part);
            body += parameter == macro->second.parameters.end()
                        ? part
                        : values[static_cast<std::size_t>(parameter -
                                                          macro->second.parameters.begin())];
            i = stop;
        }
        for (std::size_t i = 0; i < body.size();) {
            if (is_name_start(body[i]) && (i == 0 || !is_name_part(body[i - 1]))) {
                i = expand(body, i, place, out, depth + 1);
                continue;
            }
            out.add(body[i++], place);
        }
        return end;
    }

    [[noreturn]] void fail(std::size_t place, const std::string& message) const {
        cpfg_fail(source_, place, message);
    }
    [[noreturn]] void refuse(std::size_t place, const std::string& what,
                             const std::string& why) const {
        cpfg_refuse(source_, place, what, why);
    }

    const Source& source_;
    std::string_view text_;
    const CpfgDialect& dialect_;
    std::map<std::string, Macro> macros_;
    std::vector<Condition> conditions_;
};

/// Puts the texts of files in for the lines that include them.
class Inclusion {
public:
    explicit Inclusion(const IncludedText& text_of) : text_of_(text_of) {}

    std::string joined(std::string_view text, const std::string& name) {
        constexpr std::size_t longest = 10'000'000;
        const Source source(text, name);
        std::string out;
        bool in_comment = false;
        std::size_t line = 1;
        names_.push_back(name);
        for (std::size_t begin = 0; begin < text.size(); ++line) {
            const std::size_t end = std::min(text.find('\n', begin), text.size());
            const std::string_view said = text.substr(begin, end - begin);
            const std::string wanted = in_comment ? "" : included(said);
            const std::string path = wanted.empty() ? "" : beside(name, wanted);
            if (std::ranges::count(names_, path) > 0)
                throw Diagnostics({source.finding(
                    begin, "files that include each other in a circle: expected " +
                               algae::quoted(wanted) + " not to be within itself")});
            const std::optional<std::string> other = path.empty() ? std::nullopt : text_of_(path);
            if (other) {
                std::string inner = joined(*other, path);
                if (!inner.ends_with('\n')) inner += '\n';
                out += "# 1 \"" + path + "\"\n" + inner + "# " + std::to_string(line + 1) + " \"" +
                       name + "\"\n";
                if (out.size() > longest)
                    throw Diagnostics(
                        {source.finding(begin,
                                        "with the files that are included the text has "
                                        "more than 10000000 characters")});
            } else {
                out += text.substr(begin, end + (end < text.size() ? 1 : 0) - begin);
            }
            in_comment = is_in_comment(said, in_comment);
            begin = end + 1;
        }
        names_.pop_back();
        return out;
    }

private:
    /// The name in a line `#include "NAME"`; empty if it is none.
    static std::string included(std::string_view line) {
        if (!line.starts_with('#')) return {};
        const std::string_view said = trimmed(line.substr(1));
        const std::size_t open = said.find('"');
        if (open == std::string_view::npos || trimmed(said.substr(0, open)) != "include") return {};
        const std::size_t close = said.find('"', open + 1);
        return close == std::string_view::npos
                   ? std::string()
                   : std::string(said.substr(open + 1, close - open - 1));
    }
    /// The name of a file in the folder of another.
    static std::string beside(const std::string& name, const std::string& other) {
        const std::size_t slash = name.rfind('/');
        return slash == std::string::npos || other.starts_with('/')
                   ? other
                   : name.substr(0, slash + 1) + other;
    }
    /// Whether a comment of C goes on behind a line.
    static bool is_in_comment(std::string_view line, bool inside) {
        for (std::size_t i = 0; i < line.size(); ++i) {
            const std::string_view rest = line.substr(i);
            if (!inside && rest.starts_with("//")) return false;
            if (!rest.starts_with(inside ? "*/" : "/*")) continue;
            inside = !inside;
            ++i;
        }
        return inside;
    }

    const IncludedText& text_of_;
    std::vector<std::string> names_;  // of the files that are open
};

}  // namespace

Diagnostic cpfg_finding(const Source& source, std::size_t place, const std::string& message) {
    Diagnostic found = source.finding(std::min(place, source.text().size()), message);
    const std::string_view text = source.text();
    std::size_t line = 1;
    std::optional<std::pair<std::size_t, std::string>> marked;  // what is behind line 0 of the file
    for (std::size_t begin = 0; line < found.place.line && begin < text.size(); ++line) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        if (auto marker = line_marker(text.substr(begin, end - begin)))
            marked = std::pair{line + 1 - marker->first, std::move(marker->second)};
        begin = end + 1;
    }
    if (marked) {
        found.place.line -= marked->first;
        found.place.file = marked->second;
    }
    return found;
}

void cpfg_fail(const Source& source, std::size_t place, const std::string& message) {
    throw Diagnostics({cpfg_finding(source, place, message)});
}

void cpfg_refuse(const Source& source, std::size_t place, const std::string& what,
                 const std::string& why) {
    cpfg_fail(source, place, what + " " + why);
}

Placed preprocessed(const Source& source, const CpfgDialect& dialect) {
    return Preprocessor(source, dialect).preprocessed();
}

std::string cpfg_with_included(std::string_view text, const std::string& name,
                               const IncludedText& text_of) {
    return Inclusion(text_of).joined(text, name);
}

}  // namespace algae
