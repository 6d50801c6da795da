#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>

#include "nature/nature.hpp"
#include "notation/detail/generator_values.hpp"
#include "notation/detail/reading.hpp"

// The files of other generators than L-systems: lines `key value ...` with `#` comments.
//
// Reading is in two steps. The text becomes a list of statements, whose keys are checked against those of the
// kind, with unknown, repeated and empty ones as findings, all at once. Then the kind takes the values it
// needs, each from the statement of a key, and the first faulty one ends the reading; so a `GeneratorFile`
// keeps of each word its place and the line. In between the command may set statements from options, which
// have no line. Words are separated by blanks outside brackets; numbers are expressions without names, read
// by the grammar of the `.lsys` notation, so `1/3` and `sqrt(3)/6` stay exact.

namespace algae {

const GeneratorStatement* GeneratorFile::find(std::string_view key) const {
    const auto found = std::ranges::find(statements, key, &GeneratorStatement::key);
    return found == statements.end() ? nullptr : &*found;
}

void GeneratorFile::add(const std::string& key, const std::vector<std::string>& words) {
    GeneratorStatement statement;
    statement.key = key;
    statement.place.file = name;
    for (const std::string& word : words) statement.words.push_back({word, 0});
    statements.push_back(std::move(statement));
}

void GeneratorFile::set(const std::string& key, const std::vector<std::string>& words,
                        const std::string& option) {
    const auto found = std::ranges::find(statements, key, &GeneratorStatement::key);
    GeneratorFile changed;
    changed.name = option;
    changed.add(key, words);
    if (found == statements.end())
        statements.push_back(changed.statements.front());
    else
        *found = changed.statements.front();
}

void GeneratorFile::fail(const GeneratorStatement& statement, const GeneratorWord& word,
                         const std::string& message) const {
    if (statement.line.empty()) throw Diagnostics({{statement.place, message, {}, 0}});
    Diagnostic finding = Source(statement.line, statement.place.file).finding(word.offset, message);
    finding.place.line = statement.place.line;
    throw Diagnostics({finding});
}

void GeneratorFile::fail(const GeneratorStatement& statement, const std::string& message) const {
    const std::size_t offset = statement.line.find(statement.key);
    fail(statement, {{}, offset == std::string::npos ? 0 : offset}, message);
}

void GeneratorFile::fail(const std::string& message) const { throw Error(name + ": " + message); }

void GeneratorFile::refuse(const GeneratorStatement& statement, const GeneratorWord& word,
                           const std::string& wanted, const std::string& hint) const {
    fail(statement, word,
         "expected " + statement.key + " " + wanted + ", found " + algae::quoted(word.text) + hint);
}

const GeneratorWord& GeneratorFile::only_word(const GeneratorStatement& statement,
                                              const std::string& arguments) const {
    check_words(statement, 1, 1, arguments);
    return statement.words.front();
}

void GeneratorFile::check_words(const GeneratorStatement& statement, std::size_t least,
                                std::size_t most, const std::string& arguments) const {
    const std::size_t found = statement.words.size();
    if (found >= least && found <= most) return;
    fail(statement,
         "expected " + statement.key + " " + arguments + ", found " + counted(found, "value"));
}

Quantity GeneratorFile::quantity(const GeneratorStatement& statement,
                                 const GeneratorWord& word) const {
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

double GeneratorFile::number(const GeneratorStatement& statement, const GeneratorWord& word,
                             double least, double most) const {
    const double value = quantity(statement, word).value;
    if (value >= least && value <= most) return value;
    refuse(statement, word,
           "with a number " + (std::isinf(most)    ? "of at least " + shortest_decimal(least)
                               : std::isinf(least) ? "of at most " + shortest_decimal(most)
                                                   : "from " + shortest_decimal(least) + " to " +
                                                         shortest_decimal(most)));
}

std::uint64_t GeneratorFile::natural(const GeneratorStatement& statement, const GeneratorWord& word,
                                     std::uint64_t least, std::uint64_t most) const {
    std::uint64_t value = 0;
    const char* const end = word.text.data() + word.text.size();
    const auto [stop, problem] = std::from_chars(word.text.data(), end, value);
    if (problem == std::errc() && stop == end && value >= least && value <= most) return value;
    refuse(statement, word,
           "with a whole number from " + std::to_string(least) + " to " + std::to_string(most));
}

std::pair<std::uint64_t, std::uint64_t> GeneratorFile::range(const GeneratorStatement& statement,
                                                             const GeneratorWord& word,
                                                             std::uint64_t most) const {
    const std::size_t dots = word.text.find("..");
    const auto part = [&](const std::string& text) {
        return natural(statement, {text, word.offset}, 0, most);
    };
    const std::uint64_t first = part(word.text.substr(0, dots));
    return {first, dots == std::string::npos ? first : part(word.text.substr(dots + 2))};
}

Point GeneratorFile::point(const GeneratorStatement& statement, const GeneratorWord& word) const {
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

std::optional<double> GeneratorFile::number(std::string_view key, double least, double most) const {
    const GeneratorStatement* statement = find(key);
    if (!statement) return std::nullopt;
    return number(*statement, only_word(*statement, "NUMBER"), least, most);
}

std::optional<std::uint64_t> GeneratorFile::natural(std::string_view key, std::uint64_t least,
                                                    std::uint64_t most) const {
    const GeneratorStatement* statement = find(key);
    if (!statement) return std::nullopt;
    return natural(*statement, only_word(*statement, "N"), least, most);
}

std::optional<std::pair<std::uint64_t, std::uint64_t>> GeneratorFile::range(
    std::string_view key, std::uint64_t most) const {
    const GeneratorStatement* statement = find(key);
    if (!statement) return std::nullopt;
    const GeneratorWord& word = only_word(*statement, "N or N..M");
    const auto found = range(*statement, word, most);
    if (found.second < found.first)
        fail(*statement, word, "the range " + algae::quoted(word.text) + " goes down");
    return found;
}

std::optional<std::string> GeneratorFile::text(std::string_view key) const {
    const GeneratorStatement* statement = find(key);
    if (!statement) return std::nullopt;
    return only_word(*statement, "TEXT").text;
}

std::optional<std::string> GeneratorFile::choice(std::string_view key,
                                                 const std::vector<std::string>& choices) const {
    const GeneratorStatement* statement = find(key);
    if (!statement) return std::nullopt;
    const std::string wanted = joined(choices, "|");
    const GeneratorWord& word = only_word(*statement, wanted);
    if (std::ranges::count(choices, word.text) == 0)
        refuse(*statement, word, wanted, did_you_mean(word.text, choices));
    return word.text;
}

Colour GeneratorFile::colour(const GeneratorStatement& statement, const GeneratorWord& word) const {
    try {
        return colour_named(word.text);
    } catch (const Error& error) {
        fail(statement, word, error.what());
    }
}

void GeneratorFile::describe(Generator& generator) const {
    generator.name = name;
    generator.title = text("title").value_or("");
    generator.source = text("source").value_or("");
    if (const GeneratorStatement* colours = find("colour"))
        for (const GeneratorWord& word : colours->words) {
            if (!is_scheme(word.text)) colour(*colours, word);
            generator.style.colours.push_back(word.text);
        }
    if (const GeneratorStatement* width = find("width")) {
        const GeneratorWord& points = only_word(*width, "POINTS");
        number(*width, points, 0.001, 1000);
        generator.style.width = quantity(*width, points);
    }
}

namespace {

bool is_space(char byte) { return is_blank(static_cast<unsigned char>(byte)); }

bool takes_whole_line(std::string_view key) { return key == "title" || key == "source"; }

bool takes_colours(std::string_view key) {
    return key == "colour" || key == "tint" || key == "sky";
}

bool is_colour_code(std::string_view text) {
    return text.size() >= 7 &&
           std::all_of(text.begin() + 1, text.begin() + 7,
                       [](char c) { return std::isxdigit(static_cast<unsigned char>(c)) != 0; }) &&
           (text.size() == 7 || is_space(text[7]));
}

/// Where the comment of a line begins; its end if it has none.
std::size_t comment_start(std::string_view line, std::string_view key) {
    for (std::size_t i = 0; i < line.size(); ++i)
        if (line[i] == '#' && (i == 0 || is_space(line[i - 1])) &&
            !(takes_colours(key) && is_colour_code(line.substr(i))))
            return i;
    return line.size();
}

/// The words of a part of a line; blanks in their brackets are left out.
std::vector<GeneratorWord> words_of(std::string_view line, std::string_view part) {
    std::vector<GeneratorWord> found;
    for (const std::string_view piece : pieces(part)) {
        std::string word;
        for (const std::string_view solid : blank_separated(piece)) word += solid;
        found.push_back({std::move(word), static_cast<std::size_t>(piece.data() - line.data())});
    }
    return found;
}

}  // namespace

GeneratorFile read_generator_file(std::string_view text, const std::string& name,
                                  const std::vector<GeneratorKey>& own_keys) {
    std::vector<GeneratorKey> keys{
        {"title", "TEXT"}, {"source", "TEXT"}, {"colour", "COLOUR ..."}, {"width", "POINTS"}};
    keys.insert(keys.end(), own_keys.begin(), own_keys.end());
    std::vector<std::string> names;
    std::ranges::transform(keys, std::back_inserter(names), &GeneratorKey::name);

    const Source source(text, name);
    Findings findings(source);
    findings.throw_if_no_text();
    GeneratorFile file;
    file.name = name;
    std::vector<std::string> comments;
    std::set<std::string> said;
    for (std::size_t start = 0; start < text.size();) {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        const std::string_view line = text.substr(start, end - start);
        const std::size_t offset = start;
        start = end + 1;
        const auto begin =
            static_cast<std::size_t>(std::ranges::find_if_not(line, is_space) - line.begin());
        if (begin == line.size()) continue;
        const auto key_end = static_cast<std::size_t>(
            std::find_if(line.begin() + static_cast<std::ptrdiff_t>(begin), line.end(), is_space) -
            line.begin());
        GeneratorStatement statement;
        statement.key = line.substr(begin, key_end - begin);
        const std::size_t stop = comment_start(line, statement.key);
        if (stop < line.size()) statement.behind = trimmed(line.substr(stop));
        if (stop == begin) {
            comments.push_back(std::move(statement.behind));
            continue;
        }
        const auto known = std::ranges::find(keys, statement.key, &GeneratorKey::name);
        if (known == keys.end()) {
            findings.add(offset + begin, "unknown statement " + algae::quoted(statement.key) +
                                             did_you_mean(statement.key, names) +
                                             "; expected one of " + joined(names, ", ") +
                                             comment_hint(line.substr(begin)));
            continue;
        }
        if (!known->repeats && !said.insert(statement.key).second) {
            findings.add(offset + begin, statement.key + " is said twice");
            continue;
        }
        const std::string_view rest = trimmed(line.substr(key_end, stop - key_end));
        if (!takes_whole_line(statement.key))
            statement.words = words_of(line, rest);
        else if (!rest.empty())
            statement.words.push_back(
                {std::string(rest), static_cast<std::size_t>(rest.data() - line.data())});
        if (statement.words.empty() && !known->arguments.empty()) {
            findings.add(offset + begin,
                         "expected " + known->name + " " + known->arguments + ", found no value");
            continue;
        }
        statement.place = source.place(offset + begin);
        statement.line = line;
        statement.above = std::move(comments);
        comments.clear();
        file.statements.push_back(std::move(statement));
    }
    findings.throw_if_any();
    file.below = std::move(comments);
    for (const char* first : {"source", "title"})
        std::stable_partition(file.statements.begin(), file.statements.end(),
                              [&](const GeneratorStatement& s) { return s.key == first; });
    return file;
}

std::string print_generator_file(const GeneratorFile& file) {
    std::string out;
    for (const GeneratorStatement& statement : file.statements) {
        for (const std::string& comment : statement.above) out += comment + '\n';
        out += statement.key;
        for (const GeneratorWord& word : statement.words) out += ' ' + word.text;
        if (!statement.behind.empty()) out += ' ' + statement.behind;
        out += '\n';
    }
    for (const std::string& comment : file.below) out += comment + '\n';
    return out;
}

namespace {

/// What `read(statement, word)` makes of each word of the statement of this key.
template <class Read>
auto each_value(const GeneratorFile& file, const char* key, Read read) {
    std::optional<std::vector<decltype(read(file.statements[0], file.statements[0].words[0]))>>
        found;
    const GeneratorStatement* statement = file.find(key);
    if (!statement) return found;
    found.emplace();
    for (const GeneratorWord& word : statement->words) found->push_back(read(*statement, word));
    return found;
}

}  // namespace

std::optional<std::vector<double>> hurst_values(const GeneratorFile& file, const char* key) {
    return each_value(file, key, [&](const GeneratorStatement& said, const GeneratorWord& word) {
        const double found = file.quantity(said, word).value;
        if (!(found > 0 && found < 1)) file.refuse(said, word, "with a number between 0 and 1");
        return found;
    });
}

std::optional<std::vector<double>> number_values(const GeneratorFile& file, const char* key,
                                                 double least, double most) {
    return each_value(file, key, [&](const GeneratorStatement& said, const GeneratorWord& word) {
        return file.number(said, word, least, most);
    });
}

std::optional<std::vector<std::uint64_t>> natural_values(const GeneratorFile& file, const char* key,
                                                         std::uint64_t least, std::uint64_t most) {
    return each_value(file, key, [&](const GeneratorStatement& said, const GeneratorWord& word) {
        return file.natural(said, word, least, most);
    });
}

std::optional<double> positive_value(const GeneratorFile& file, const char* key) {
    const GeneratorStatement* statement = file.find(key);
    if (!statement) return std::nullopt;
    const GeneratorWord& word = file.only_word(*statement, "NUMBER");
    const double found = file.quantity(*statement, word).value;
    if (!(found > 0)) file.refuse(*statement, word, "with a number above 0");
    return found;
}

std::optional<std::pair<int, int>> level_values(const GeneratorFile& file, const char* key,
                                                int most) {
    const auto found = file.range(key, static_cast<std::uint64_t>(most));
    if (!found) return std::nullopt;
    return std::pair(static_cast<int>(found->first), static_cast<int>(found->second));
}

std::uint64_t seed_value(const GeneratorFile& file) {
    return file.natural("seed", 0, std::numeric_limits<std::uint64_t>::max()).value_or(1);
}

}  // namespace algae
