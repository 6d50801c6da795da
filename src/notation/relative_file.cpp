#include "notation/relative_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/error.hpp"
#include "notation/characters.hpp"
#include "notation/expression_grammar.hpp"
#include "notation/findings.hpp"
#include "notation/source.hpp"
#include "notation/suggestion.hpp"
#include "system/colour.hpp"

namespace algae {

namespace {

std::string shown(double value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    return {text, end};
}

}  // namespace

const RelativeStatement* RelativeFile::find(std::string_view key) const {
    const auto found = std::find_if(statements.begin(), statements.end(),
                                    [&](const RelativeStatement& s) { return s.key == key; });
    return found == statements.end() ? nullptr : &*found;
}

void RelativeFile::add(const std::string& key, const std::vector<std::string>& words) {
    RelativeStatement statement;
    statement.key = key;
    statement.place.file = name;
    for (const std::string& word : words) statement.words.push_back({word, 0});
    statements.push_back(std::move(statement));
}

void RelativeFile::set(const std::string& key, const std::vector<std::string>& words,
                       const std::string& option) {
    const auto found = std::find_if(statements.begin(), statements.end(),
                                    [&](const RelativeStatement& s) { return s.key == key; });
    RelativeFile changed;
    changed.name = option;
    changed.add(key, words);
    if (found == statements.end())
        statements.push_back(changed.statements.front());
    else
        *found = changed.statements.front();
}

void RelativeFile::fail(const RelativeStatement& statement, const RelativeWord& word,
                        const std::string& message) const {
    if (statement.line.empty()) throw Diagnostics({{statement.place, message, {}, 0}});
    Diagnostic finding = Source(statement.line, statement.place.file).finding(word.offset, message);
    finding.place.line = statement.place.line;
    throw Diagnostics({finding});
}

void RelativeFile::fail(const RelativeStatement& statement, const std::string& message) const {
    const std::size_t offset = statement.line.find(statement.key);
    fail(statement, {{}, offset == std::string::npos ? 0 : offset}, message);
}

void RelativeFile::fail(const std::string& message) const { throw Error(name + ": " + message); }

void RelativeFile::check_words(const RelativeStatement& statement, std::size_t least,
                               std::size_t most, const std::string& arguments) const {
    const std::size_t found = statement.words.size();
    if (found >= least && found <= most) return;
    fail(statement, "expected " + statement.key + " " + arguments + ", found " +
                        std::to_string(found) + (found == 1 ? " value" : " values"));
}

Quantity RelativeFile::quantity(const RelativeStatement& statement,
                                const RelativeWord& word) const {
    try {
        const Source source(word.text, statement.place.file);
        const Quantity value = evaluate(parse_expression(word.text, source), {});
        if (std::isfinite(value.value)) return value;
    } catch (const SyntaxError&) {
    } catch (const Diagnostics& error) {
        fail(statement, word, error.findings().front().message);
    }
    fail(statement, word, "expected a number, found " + algae::quoted(word.text));
}

double RelativeFile::number(const RelativeStatement& statement, const RelativeWord& word,
                            double least, double most) const {
    const double value = quantity(statement, word).value;
    if (value >= least && value <= most) return value;
    const std::string wanted = std::isinf(most)    ? "of at least " + shown(least)
                               : std::isinf(least) ? "of at most " + shown(most)
                                                   : "from " + shown(least) + " to " + shown(most);
    fail(statement, word,
         "expected " + statement.key + " with a number " + wanted + ", found " +
             algae::quoted(word.text));
}

std::uint64_t RelativeFile::natural(const RelativeStatement& statement, const RelativeWord& word,
                                    std::uint64_t least, std::uint64_t most) const {
    std::uint64_t value = 0;
    const char* const end = word.text.data() + word.text.size();
    const auto [stop, problem] = std::from_chars(word.text.data(), end, value);
    if (problem == std::errc() && stop == end && value >= least && value <= most) return value;
    fail(statement, word,
         "expected " + statement.key + " with a whole number from " + std::to_string(least) +
             " to " + std::to_string(most) + ", found " + algae::quoted(word.text));
}

Point RelativeFile::point(const RelativeStatement& statement, const RelativeWord& word) const {
    const std::string& text = word.text;
    std::size_t comma = std::string::npos;
    int depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        depth += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
        if (text[i] == ',' && depth == 1 && comma == std::string::npos) comma = i;
    }
    if (text.size() < 5 || text.front() != '(' || text.back() != ')' || comma == std::string::npos)
        fail(statement, word, "expected a point such as (1,0), found " + algae::quoted(text));
    return {
        quantity(statement, {text.substr(1, comma - 1), word.offset}).value,
        quantity(statement, {text.substr(comma + 1, text.size() - comma - 2), word.offset}).value};
}

std::optional<double> RelativeFile::number(std::string_view key, double least, double most) const {
    const RelativeStatement* statement = find(key);
    if (!statement) return std::nullopt;
    check_words(*statement, 1, 1, "NUMBER");
    return number(*statement, statement->words.front(), least, most);
}

std::optional<std::uint64_t> RelativeFile::natural(std::string_view key, std::uint64_t least,
                                                   std::uint64_t most) const {
    const RelativeStatement* statement = find(key);
    if (!statement) return std::nullopt;
    check_words(*statement, 1, 1, "N");
    return natural(*statement, statement->words.front(), least, most);
}

std::optional<std::pair<std::uint64_t, std::uint64_t>> RelativeFile::range(
    std::string_view key, std::uint64_t most) const {
    const RelativeStatement* statement = find(key);
    if (!statement) return std::nullopt;
    check_words(*statement, 1, 1, "N or N..M");
    const RelativeWord& word = statement->words.front();
    const std::size_t dots = word.text.find("..");
    const auto part = [&](const std::string& text) {
        return natural(*statement, {text, word.offset}, 0, most);
    };
    const std::uint64_t first = part(word.text.substr(0, dots));
    const std::uint64_t last = dots == std::string::npos ? first : part(word.text.substr(dots + 2));
    if (last < first)
        fail(*statement, word, "the range " + algae::quoted(word.text) + " goes down");
    return std::pair(first, last);
}

std::optional<std::string> RelativeFile::text(std::string_view key) const {
    const RelativeStatement* statement = find(key);
    if (!statement) return std::nullopt;
    check_words(*statement, 1, 1, "TEXT");
    return statement->words.front().text;
}

std::optional<std::string> RelativeFile::choice(std::string_view key,
                                                const std::vector<std::string>& choices) const {
    const RelativeStatement* statement = find(key);
    if (!statement) return std::nullopt;
    std::string wanted;
    for (const std::string& one : choices) wanted += (wanted.empty() ? "" : "|") + one;
    check_words(*statement, 1, 1, wanted);
    const std::string& word = statement->words.front().text;
    if (std::find(choices.begin(), choices.end(), word) == choices.end())
        fail(*statement, statement->words.front(),
             "expected " + statement->key + " " + wanted + ", found " + algae::quoted(word) +
                 did_you_mean(word, choices));
    return word;
}

void RelativeFile::describe(Relative& relative) const {
    relative.name = name;
    relative.title = text("title").value_or("");
    relative.source = text("source").value_or("");
    if (const RelativeStatement* colours = find("colour"))
        for (const RelativeWord& word : colours->words) {
            try {
                if (word.text != "along") colour_named(word.text);
            } catch (const Error& error) {
                fail(*colours, word, error.what());
            }
            relative.settings.colours.push_back(word.text);
        }
    if (const RelativeStatement* width = find("width")) {
        check_words(*width, 1, 1, "POINTS");
        number(*width, width->words.front(), 0.001, 1000);
        relative.settings.width = quantity(*width, width->words.front());
    }
}

}  // namespace algae
