#include <algorithm>
#include <cctype>
#include <set>

#include "notation/characters.hpp"
#include "notation/findings.hpp"
#include "notation/relative_file.hpp"
#include "notation/source.hpp"
#include "notation/suggestion.hpp"

// The text of a relative's file, read and printed.

namespace algae {

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

/// The words of `line` from `begin` to `end`.
std::vector<RelativeWord> words_of(std::string_view line, std::size_t begin, std::size_t end) {
    std::vector<RelativeWord> found;
    std::size_t here = begin;
    while (here < end) {
        if (is_space(line[here])) {
            ++here;
            continue;
        }
        std::size_t stop = here;
        int depth = 0;
        for (; stop < end && (depth > 0 || !is_space(line[stop])); ++stop)
            depth += line[stop] == '(' ? 1 : line[stop] == ')' ? -1 : 0;
        RelativeWord word{{}, here};
        for (; here < stop; ++here)
            if (!is_space(line[here])) word.text += line[here];
        found.push_back(std::move(word));
    }
    return found;
}

std::string listed(const std::vector<RelativeKey>& keys) {
    std::string out;
    for (const RelativeKey& key : keys) out += (out.empty() ? "" : ", ") + key.name;
    return out;
}

}  // namespace

const std::vector<RelativeKey>& common_relative_keys() {
    static const std::vector<RelativeKey> keys{
        {"title", "TEXT"}, {"source", "TEXT"}, {"colour", "COLOUR ..."}, {"width", "POINTS"}};
    return keys;
}

RelativeFile read_relative_file(std::string_view text, const std::string& name,
                                const std::vector<RelativeKey>& own_keys) {
    std::vector<RelativeKey> keys = common_relative_keys();
    keys.insert(keys.end(), own_keys.begin(), own_keys.end());
    std::vector<std::string> names;
    for (const RelativeKey& key : keys) names.push_back(key.name);

    const Source source(text, name);
    Findings findings(source);
    findings.throw_if_no_text();
    RelativeFile file;
    file.name = name;
    std::vector<std::string> comments;
    std::set<std::string> said;
    for (std::size_t start = 0; start < text.size();) {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        const std::string_view line = text.substr(start, end - start);
        const std::size_t offset = start;
        start = end + 1;
        std::size_t begin = 0;
        while (begin < line.size() && is_space(line[begin])) ++begin;
        if (begin == line.size()) continue;
        std::size_t key_end = begin;
        while (key_end < line.size() && !is_space(line[key_end])) ++key_end;
        RelativeStatement statement;
        statement.key = line.substr(begin, key_end - begin);
        const std::size_t stop = comment_start(line, statement.key);
        if (stop < line.size()) statement.behind = trimmed(line.substr(stop));
        if (stop == begin) {
            comments.push_back(std::move(statement.behind));
            continue;
        }
        const auto known = std::find_if(keys.begin(), keys.end(), [&](const RelativeKey& key) {
            return key.name == statement.key;
        });
        if (known == keys.end()) {
            findings.add(offset + begin, "unknown statement " + algae::quoted(statement.key) +
                                             did_you_mean(statement.key, names) +
                                             "; expected one of " + listed(keys));
            continue;
        }
        if (!known->repeats && !said.insert(statement.key).second) {
            findings.add(offset + begin, statement.key + " is said twice");
            continue;
        }
        if (takes_whole_line(statement.key)) {
            const std::string_view rest = trimmed(line.substr(key_end, stop - key_end));
            if (!rest.empty())
                statement.words.push_back(
                    {std::string(rest), static_cast<std::size_t>(rest.data() - line.data())});
        } else {
            statement.words = words_of(line, key_end, stop);
        }
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
                              [&](const RelativeStatement& s) { return s.key == first; });
    return file;
}

std::string print_relative_file(const RelativeFile& file) {
    std::string out;
    for (const RelativeStatement& statement : file.statements) {
        for (const std::string& comment : statement.above) out += comment + '\n';
        out += statement.key;
        for (const RelativeWord& word : statement.words) out += ' ' + word.text;
        if (!statement.behind.empty()) out += ' ' + statement.behind;
        out += '\n';
    }
    for (const std::string& comment : file.below) out += comment + '\n';
    return out;
}

}  // namespace algae
