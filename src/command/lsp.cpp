// `algae lsp`: the language-server protocol for `.lsys` and `.claim` files, on standard input and output.
//
// An editor sends messages of JSON, each behind a header with its length, and gets answers and findings in the same way. A document is kept as
// its text and read anew whenever it changes, by the readers that every verb uses: so an editor says what the command would say. Keywords, their
// forms and meanings come from the table of statements by which files are read and printed.
//
// Positions of the protocol are lines and UTF-16 units from 0, those of the readers are lines and characters from 1; this file alone converts.
//
// Renaming a letter is done on the text, so that comments and blanks stay: names are replaced where letters can stand, outside of
// parameters, conditions and texts. Then the new text is read, and unless it is the same system with one letter called otherwise, the
// request is refused and nothing changes.

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "command/detail/files.hpp"
#include "command/detail/output.hpp"
#include "command/detail/verb.hpp"
#include "exact/exact.hpp"
#include "language/language.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "report/report.hpp"
#include "rewrite/rewrite.hpp"

namespace algae::command {

namespace {

using nlohmann::json;

/// Requests that cannot be answered.
struct Refused {
    int code;
    std::string message;
};
constexpr int no_such_method = -32601, bad_request = -32602, request_failed = -32803;

std::size_t character_bytes(std::string_view text, std::size_t at) {
    std::size_t size = 1;
    while (at + size < text.size() && (text[at + size] & 0xc0) == 0x80) ++size;
    return size;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines{""};
    for (const char c : text) {
        if (c == '\n')
            lines.emplace_back();
        else if (c != '\r')
            lines.back() += c;
    }
    return lines;
}

/// UTF-16 units of the first so many bytes of a line.
std::size_t units(std::string_view line, std::size_t bytes) {
    std::size_t count = 0;
    for (std::size_t at = 0; at < std::min(bytes, line.size()); at += character_bytes(line, at))
        count += character_bytes(line, at) == 4 ? 2 : 1;
    return count;
}

std::size_t bytes_of_units(std::string_view line, std::size_t wanted) {
    std::size_t at = 0;
    for (std::size_t count = 0; at < line.size() && count < wanted; at += character_bytes(line, at))
        count += character_bytes(line, at) == 4 ? 2 : 1;
    return at;
}

/// Bytes in front of a column, which is counted in characters from 1.
std::size_t bytes_of_column(std::string_view line, std::size_t column) {
    std::size_t at = 0;
    for (std::size_t i = 1; i < column && at < line.size(); ++i) at += character_bytes(line, at);
    return at;
}

json range_of(const std::vector<std::string>& lines, std::size_t line, std::size_t from,
              std::size_t to) {
    const std::string& text = line < lines.size() ? lines[line] : lines.back();
    return {{"start", {{"line", line}, {"character", units(text, from)}}},
            {"end", {{"line", line}, {"character", units(text, to)}}}};
}

struct Document {
    std::string path, text;
    bool is_claim() const { return path.ends_with(".claim"); }
};

/// "file:///a%20b" as a path.
std::string path_of(const std::string& uri) {
    std::string path;
    const std::size_t from = uri.starts_with("file://") ? 7 : 0;
    for (std::size_t i = from; i < uri.size(); ++i) {
        if (uri[i] == '%' && i + 2 < uri.size()) {
            path += static_cast<char>(std::strtol(uri.substr(i + 1, 2).c_str(), nullptr, 16));
            i += 2;
        } else {
            path += uri[i];
        }
    }
    return path;
}

/// Everything that is wrong with a document.
std::vector<Diagnostic> findings_of(const Document& document, const Budget& budget) {
    try {
        if (document.is_claim())
            read_claim(document.text, document.path,
                       systems_from({folder_of(document.path)}, budget, false));
        else
            read_lsystem(document.text, document.path);
    } catch (const Diagnostics& error) {
        return error.findings();
    } catch (const Error& error) {
        return {{{document.path, 1, 1}, error.what(), {}, 0}};
    } catch (const Stopped& stopped) {
        return {{{document.path, 1, 1}, stopped.what(), {}, 0}};
    }
    return {};
}

json diagnostics(const Document& document, const Budget& budget) {
    const std::vector<std::string> lines = lines_of(document.text);
    json all = json::array();
    for (const Diagnostic& finding : findings_of(document, budget)) {
        const std::size_t line = finding.place.line == 0 ? 0 : finding.place.line - 1;
        const std::string& text = lines[std::min(line, lines.size() - 1)];
        const std::size_t from = bytes_of_column(text, finding.place.column),
                          to = bytes_of_column(text, end_column(finding));
        json one{{"range", range_of(lines, line, from, std::max(from, to))},
                 {"severity", 1},
                 {"source", "algae"},
                 {"message", finding.message}};
        const MessageParts parts = parts_of(finding.message);
        if (!parts.suggestion.empty()) one["data"] = {{"suggestion", parts.suggestion}};
        all.push_back(std::move(one));
    }
    return all;
}

/// The word at a place of a line: letters, digits and hyphens.
std::pair<std::size_t, std::size_t> word_at(const std::string& line, std::size_t at) {
    const auto in_word = [&](std::size_t i) {
        return i < line.size() && (std::isalnum(static_cast<unsigned char>(line[i])) ||
                                   line[i] == '-' || line[i] == '_');
    };
    std::size_t from = at, to = at;
    while (from > 0 && in_word(from - 1)) --from;
    while (in_word(to)) ++to;
    return {from, to};
}

json completion(const Document& document, std::size_t line, std::size_t character) {
    const std::vector<std::string> lines = lines_of(document.text);
    const std::string text = line < lines.size() ? lines[line] : "";
    std::string before = text.substr(0, bytes_of_units(text, character));
    // The statement that the place is in.
    const std::size_t begin = before.find_last_of(";{");
    if (begin != std::string::npos) before.erase(0, begin + 1);
    before.erase(0, std::min(before.find_first_not_of(" \t"), before.size()));
    constexpr int keyword = 14, value = 12;
    json items = json::array();
    const std::size_t blank = before.find_first_of(" \t");
    if (document.is_claim()) {
        if (blank == std::string::npos)
            for (const StatementHelp& help : claim_statements())
                items.push_back(
                    {{"label", help.keyword}, {"kind", keyword}, {"documentation", help.meaning}});
        return items;
    }
    for (const StatementHelp& help : system_statements()) {
        if (blank == std::string::npos) {
            json item{{"label", help.keyword},
                      {"kind", keyword},
                      {"detail", help.forms.empty() ? help.keyword : help.forms.front()},
                      {"documentation", {{"kind", "markdown"}, {"value", help.meaning}}}};
            items.push_back(std::move(item));
        } else if (before.substr(0, blank) == help.keyword) {
            for (const std::string& word : help.words)
                items.push_back({{"label", word}, {"kind", value}});
        }
    }
    return items;
}

/// The class of the system, and its first words.
std::string about(const Document& document, const Budget& budget) {
    const Model system = read_lsystem(document.text, document.path);
    std::string text = "**" + class_of(system).name() + "**";
    if (!system.title.empty()) text += " " + system.title;
    constexpr std::uint64_t generations = 5;
    constexpr std::size_t longest = 60;
    try {
        const View<D0L> rules = as_d0l(system);
        if (rules)
            for (std::uint64_t n = 0; n < generations; ++n) {
                if (length(*rules, n, budget) > Integer(longest)) break;
                text += (n == 0 ? "\n\n```\n" : "\n") + std::to_string(n) + "  " +
                        spell(system.alphabet, derive(*rules, n, budget));
                if (n + 1 == generations) break;
            }
        if (text.find("```") != std::string::npos) text += "\n```";
    } catch (const Stopped&) {
    }
    return text;
}

json hover(const Document& document, std::size_t line, std::size_t character,
           const Budget& budget) {
    const std::vector<std::string> lines = lines_of(document.text);
    if (line >= lines.size()) return nullptr;
    const std::string& text = lines[line];
    const std::size_t at = bytes_of_units(text, character);
    const auto [from, to] = word_at(text, at);
    const std::string word = text.substr(from, to - from);
    const std::size_t first = std::min(text.find_first_not_of(" \t"), text.size());
    std::string said;
    if (from == first && document.is_claim()) {
        for (const StatementHelp& help : claim_statements())
            if (help.keyword == word) said = "**" + help.keyword + "** " + help.meaning;
    } else if (from == first) {
        for (const StatementHelp& help : system_statements())
            if (help.keyword == word) {
                said = "**" + help.keyword + "** " + help.meaning;
                for (const std::string& form : help.forms) said += "\n\n`" + form + "`";
                if (!help.otherwise.empty()) said += "\n\nWithout it: " + help.otherwise;
            }
    }
    if (said.empty() && !document.is_claim()) {
        try {
            said = about(document, budget);
        } catch (const Error&) {
        }
    }
    if (said.empty()) return nullptr;
    return {{"contents", {{"kind", "markdown"}, {"value", said}}},
            {"range", range_of(lines, line, from, to)}};
}

// Renaming

/// A place of a letter in a text: a line and bytes in it.
struct Occurrence {
    std::size_t line, from, to;
};

/// Leaves of the lines of a system, one after the other, what has letters: its rules and settings without comments, parameters and
/// conditions.
class LetterLines {
public:
    std::string letters_only(std::string line) {
        line_ = std::move(line);
        for (std::size_t i = 0; i < line_.size(); ++i)
            if (line_[i] == '#' && (i == 0 || line_[i - 1] == ' ' || line_[i - 1] == '\t'))
                blank(i, line_.size());
        std::size_t depth = 0;
        for (std::size_t i = 0; i < line_.size(); ++i) {
            if (line_[i] == '(') ++depth;
            const bool inside = depth > 0;
            if (line_[i] == ')' && depth > 0) --depth;
            if (inside) line_[i] = ' ';
        }
        for (std::size_t begin = 0; begin < line_.size();) {
            const std::size_t end = std::min(line_.find(';', begin), line_.size());
            blank(end, end + 1);
            statement(begin, end);
            begin = end + 1;
        }
        return std::move(line_);
    }

private:
    void blank(std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < std::min(to, line_.size()); ++i) line_[i] = ' ';
    }
    std::size_t find(std::string_view what, std::size_t from, std::size_t to) const {
        return std::min(std::string_view(line_).substr(0, to).find(what, from), to);
    }
    /// The word that begins at the next place which is no blank; it is blanked.
    std::string take_word(std::size_t from, std::size_t to) {
        const std::size_t first = std::min(line_.find_first_not_of(" \t", from), to);
        const std::size_t end = std::min(line_.find_first_of(" \t", first), to);
        const std::string word = line_.substr(first, end - first);
        blank(first, end);
        return word;
    }

    void statement(std::size_t from, std::size_t to) {
        const std::size_t first = std::min(line_.find_first_not_of(" \t", from), to);
        const std::string begin = line_.substr(first, to - first);
        for (const char* opens : {"system ", "coding"})
            if (begin.starts_with(opens)) {
                const std::size_t brace = find("{", first, to);
                if (brace == to) break;
                in_block_ = true;
                in_coding_ = opens[0] == 'c';
                blank(first, brace + 1);
                return statement(brace + 1, to);
            }
        bool ends = false;
        if (in_block_) {  // a brace that no other opens
            int open = 0;
            for (std::size_t i = from; i < to && !ends; ++i) {
                open += line_[i] == '{' ? 1 : line_[i] == '}' ? -1 : 0;
                ends = open < 0;
                if (ends) blank(i, i + 1);
            }
        }
        const std::size_t arrow = std::min(find("->", from, to), find("→", from, to));
        if (arrow < to)
            rule(from, arrow, to);
        else
            setting(from, to);
        if (ends) in_block_ = in_coding_ = false;
    }

    void rule(std::size_t from, std::size_t arrow, std::size_t to) {
        const std::size_t condition = find(":", from, to);
        if (condition < arrow) blank(condition, arrow);
        if (arrow > from && line_[arrow - 1] == '-') blank(arrow - 1, arrow);
        blank(arrow, arrow + std::string_view(line_[arrow] == '-' ? "->" : "→").size());
        if (const std::size_t at = find("interpret ", from, arrow); at < arrow)
            blank(at, at + std::string("interpret ").size());
        if (in_coding_) blank(arrow, to);  // what stands there are no letters of the system
    }

    void setting(std::size_t from, std::size_t to) {
        const std::string keyword = take_word(from, to);
        for (const char* words : {"axiom", "ignore", "terminals", "alphabet", "plot"})
            if (keyword == words) return;
        // The letter behind these, and no other word.
        for (const char* named : {"stamp", "solid", "surface", "environment"})
            if (keyword == named) {
                const std::size_t name = std::min(line_.find_first_not_of(" \t", from), to);
                blank(std::min(line_.find_first_of(" \t", name), to), to);
                return;
            }
        const std::size_t colon = find(":", from, to);
        if (keyword == "expect" && colon < to && take_word(from, to) == "word")
            blank(from, colon + 1);
        else
            blank(from, to);
    }

    std::string line_;
    bool in_block_ = false, in_coding_ = false;
};

std::vector<Occurrence> letters_in(const Document& document, const Alphabet& alphabet) {
    std::vector<std::string> names;
    for (Symbol letter = 0; letter < alphabet.size(); ++letter)
        names.push_back(alphabet.name(letter));
    std::ranges::sort(names, std::greater<>(), &std::string::size);
    std::vector<Occurrence> found;
    const std::vector<std::string> lines = lines_of(document.text);
    LetterLines reader;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::string line = reader.letters_only(lines[i]);
        for (std::size_t at = 0; at < line.size();) {
            const auto name = std::ranges::find_if(names, [&](const std::string& candidate) {
                return std::string_view(line).substr(at).starts_with(candidate);
            });
            if (line[at] == ' ' || name == names.end()) {
                at += character_bytes(line, at);
                continue;
            }
            found.push_back({i, at, at + name->size()});
            at += name->size();
        }
    }
    return found;
}

/// Whether the second system is the first with one letter called otherwise.
bool is_renamed(const Model& before, const Model& after, const std::string& old_name,
                const std::string& new_name) {
    if (before.alphabet.size() != after.alphabet.size() || before.axiom != after.axiom ||
        before.rules != after.rules || !(before.drawing == after.drawing) ||
        before.interpretation != after.interpretation || before.ignored != after.ignored ||
        before.coding.images != after.coding.images)
        return false;
    for (Symbol letter = 0; letter < before.alphabet.size(); ++letter) {
        const std::string& name = before.alphabet.name(letter);
        if (after.alphabet.name(letter) != (name == old_name ? new_name : name)) return false;
    }
    return true;
}

json renaming(const Document& document, const std::string& uri, std::size_t line,
              std::size_t character, const std::string& new_name) {
    if (document.is_claim()) throw Refused{request_failed, "only letters of systems are renamed"};
    Model system;
    try {
        system = read_lsystem(document.text, document.path);
    } catch (const Error&) {
        throw Refused{request_failed, "the file has errors; mend them first"};
    }
    const std::vector<std::string> lines = lines_of(document.text);
    const std::vector<Occurrence> all = letters_in(document, system.alphabet);
    const std::size_t at = line < lines.size() ? bytes_of_units(lines[line], character) : 0;
    const auto chosen = std::ranges::find_if(all, [&](const Occurrence& one) {
        return one.line == line && one.from <= at && at <= one.to;
    });
    if (chosen == all.end()) throw Refused{request_failed, "there is no letter here"};
    const std::string old_name = lines[line].substr(chosen->from, chosen->to - chosen->from);
    if (system.alphabet.find(new_name))
        throw Refused{request_failed, "'" + new_name + "' is another letter of the system"};
    json edits = json::array();
    std::vector<std::string> changed = lines;
    for (auto one = all.rbegin(); one != all.rend(); ++one) {
        if (lines[one->line].substr(one->from, one->to - one->from) != old_name) continue;
        changed[one->line].replace(one->from, one->to - one->from, new_name);
        edits.push_back(
            {{"range", range_of(lines, one->line, one->from, one->to)}, {"newText", new_name}});
    }
    try {
        const Model renamed = read_lsystem(joined(changed, "\n"), document.path);
        if (!is_renamed(system, renamed, old_name, new_name))
            throw Refused{request_failed, "'" + old_name + "' cannot be called '" + new_name +
                                              "' without changing what the file means"};
    } catch (const Error& error) {
        throw Refused{request_failed, "'" + old_name + "' cannot be called '" + new_name +
                                          "': " + std::string(error.what())};
    }
    return {{"changes", {{uri, edits}}}};
}

// The protocol

class Server {
public:
    explicit Server(const Budget& budget) : budget_(budget) {}

    int serve() {
        while (const auto message = next()) {
            const json asked = json::parse(*message, nullptr, false);
            if (asked.is_discarded() || !asked.is_object()) {
                send({{"id", nullptr}, {"error", {{"code", -32700}, {"message", "no JSON"}}}});
                continue;
            }
            const std::string method = asked.value("method", "");
            if (method == "exit") return stopped_ ? success : refuted;
            answer(asked, method);
        }
        return success;
    }

private:
    /// The next message; nothing at the end of the input.
    static std::optional<std::string> next() {
        constexpr std::size_t longest = std::size_t{1} << 28;
        std::size_t length = 0;
        for (std::string header; std::getline(std::cin, header);) {
            if (header.ends_with('\r')) header.pop_back();
            if (header.empty()) {
                std::string message(length, '\0');
                std::cin.read(message.data(), static_cast<std::streamsize>(length));
                if (static_cast<std::size_t>(std::cin.gcount()) != length) return std::nullopt;
                return message;
            }
            constexpr std::string_view name = "content-length:";
            std::string small = header;
            std::ranges::transform(small, small.begin(), [](unsigned char c) {
                return static_cast<char>(std::tolower(c));
            });
            if (!small.starts_with(name)) continue;
            const std::string digits =
                small.substr(std::min(small.find_first_not_of(" \t", name.size()), small.size()));
            if (digits.empty() || digits.find_first_not_of("0123456789") != std::string::npos)
                throw Error("expected `Content-Length: ` and a number of bytes, found " +
                            algae::quoted(header));
            length = static_cast<std::size_t>(std::strtoull(digits.c_str(), nullptr, 10));
            if (length > longest) throw Error("a message of more than 256 MiB");
        }
        return std::nullopt;
    }

    static void send(json message) {
        message["jsonrpc"] = "2.0";
        const std::string text = message.dump(-1, ' ', false, json::error_handler_t::replace);
        print("Content-Length: " + std::to_string(text.size()) + "\r\n\r\n" + text);
        std::cout.flush();
    }

    void answer(const json& asked, const std::string& method) {
        const bool wants_answer = asked.contains("id");
        try {
            json result = result_of(method, asked.value("params", json::object()));
            if (wants_answer) send({{"id", asked["id"]}, {"result", std::move(result)}});
        } catch (const Refused& refused) {
            if (wants_answer)
                send({{"id", asked["id"]},
                      {"error", {{"code", refused.code}, {"message", refused.message}}}});
        } catch (const json::exception& error) {
            if (wants_answer)
                send({{"id", asked["id"]},
                      {"error", {{"code", bad_request}, {"message", error.what()}}}});
        }
    }

    json result_of(const std::string& method, const json& given) {
        if (method == "initialize")
            return {{"capabilities",
                     {{"textDocumentSync", 1},
                      {"completionProvider", json::object()},
                      {"hoverProvider", true},
                      {"renameProvider", true},
                      {"documentFormattingProvider", true}}},
                    {"serverInfo", {{"name", "algae"}, {"version", ALGAE_VERSION}}}};
        if (method == "shutdown") {
            stopped_ = true;
            return nullptr;
        }
        if (method == "textDocument/didOpen") {
            const json& document = given.at("textDocument");
            change(document.at("uri"), document.at("text"));
            return nullptr;
        }
        if (method == "textDocument/didChange") {
            const json& changes = given.at("contentChanges");
            if (!changes.empty())
                change(given.at("textDocument").at("uri"), changes.back().at("text"));
            return nullptr;
        }
        if (method == "textDocument/didClose") {
            const std::string uri = given.at("textDocument").at("uri");
            documents_.erase(uri);
            publish(uri, json::array());
            return nullptr;
        }
        if (!method.starts_with("textDocument/") || method == "textDocument/didSave") {
            if (method == "initialized" || method.starts_with("$/") ||
                method == "textDocument/didSave" || method.starts_with("workspace/"))
                return nullptr;
            throw Refused{no_such_method, "no method " + method};
        }
        const std::string uri = given.at("textDocument").at("uri");
        const auto found = documents_.find(uri);
        if (found == documents_.end()) throw Refused{bad_request, "the document is not open"};
        const Document& document = found->second;
        if (method == "textDocument/formatting") return formatted(document);
        const auto place = given.value("position", json::object());
        const std::size_t line = place.value("line", std::size_t{0}),
                          character = place.value("character", std::size_t{0});
        if (method == "textDocument/completion") return completion(document, line, character);
        if (method == "textDocument/hover") return hover(document, line, character, budget_);
        if (method == "textDocument/rename")
            return renaming(document, uri, line, character, given.at("newName"));
        throw Refused{no_such_method, "no method " + method};
    }

    void change(const std::string& uri, const std::string& text) {
        Document& document = documents_[uri];
        document = {path_of(uri), text};
        publish(uri, diagnostics(document, budget_));
    }
    static void publish(const std::string& uri, json all) {
        send({{"method", "textDocument/publishDiagnostics"},
              {"params", {{"uri", uri}, {"diagnostics", std::move(all)}}}});
    }
    static json formatted(const Document& document) {
        if (document.is_claim()) return json::array();
        const std::vector<std::string> lines = lines_of(document.text);
        try {
            const std::string text = format_lsystem(document.text, document.path);
            return json::array({{{"range",
                                  {{"start", {{"line", 0}, {"character", 0}}},
                                   {"end", {{"line", lines.size()}, {"character", 0}}}}},
                                 {"newText", text}}});
        } catch (const Error&) {
            throw Refused{request_failed, "the file has errors; mend them first"};
        }
    }

    const Budget& budget_;
    std::map<std::string, Document> documents_;
    bool stopped_ = false;
};

struct LspOptions {
    std::string editors;
    Bounds bounds;
};

int lsp(const LspOptions& options) {
    if (!options.editors.empty()) {
        const std::filesystem::path folder(options.editors);
        for (const EditorFile& file : editor_files()) {
            const std::filesystem::path path = folder / file.path;
            make_folders(path.parent_path());
            write_file(path.string(), file.text);
        }
        return success;
    }
    const Budget budget = options.bounds.budget();
    return Server(budget).serve();
}

}  // namespace

void add_lsp(Verbs& verbs) {
    auto [verb, options] = verbs.add(
        "lsp", "Speaks the language-server protocol, for editors of .lsys and .claim files",
        {"algae lsp", "algae lsp --editors my-editors"}, lsp);
    verb.output("--editors", options.editors, "DIR",
                "write grammars for Visual Studio Code, Vim and Lezer into this folder, and end");
    verb.bounded_by(options.bounds);
}

}  // namespace algae::command
