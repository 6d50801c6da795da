// `census`: how many systems, languages or words of each size there are, and how many of them have a property.
//
// What is counted and the properties are said in the words of claims: the verb makes the statement `for all DOMAIN X:
// PROPERTY and PROPERTY ...` of them, so every mistake in them is told as in a claim.

#include <algorithm>
#include <variant>

#include "command/detail/files.hpp"
#include "command/detail/output.hpp"
#include "command/detail/verb.hpp"
#include "exact/exact.hpp"
#include "language/language.hpp"
#include "notation/notation.hpp"

namespace algae::command {

namespace {

enum class Format { table, json, csv, bfile };

struct Options {
    std::string of;
    std::vector<std::string> by;
    std::uint64_t first = 0, threads = 0;
    Format format = Format::table;
    Bounds bounds;
};

/// A column of the table: its name, and the statement of which it counts how often it is proved.
struct Column {
    std::string name, statement;
};

/// The columns of a property: `growth` has one for each class.
std::vector<Column> columns_of(const std::string& property, bool of_systems) {
    const std::string language = of_systems ? "L(X)" : "X";
    if (property == "growth" && of_systems) {
        std::vector<Column> all;
        for (const char* growth : {"zero", "bounded", "polynomial", "exponential"})
            all.push_back({growth, std::string("growth(X) ~ ") + growth});
        return all;
    }
    if (property == "finite" || property == "infinite" || property == "empty" ||
        system_form(property) || property == "regular" || property == "context-free")
        return {{property, language + " is " + property}};
    return {{property, property}};  // a statement about X
}

/// The count of a row in a column; nothing where some instance is undecided.
std::string count_text(const Census::Row& row, std::size_t column) {
    const auto& [proved, refuted, undecided] = row.verdicts[column];
    return std::to_string(proved) + (undecided > 0 ? "+" + std::to_string(undecided) + "?" : "");
}

std::string table_text(const Census& found, const std::vector<Column>& columns) {
    std::vector<std::vector<std::string>> lines{{"size", "all"}};
    for (const Column& column : columns) lines.front().push_back(column.name);
    for (const Census::Row& row : found.rows) {
        lines.push_back({std::to_string(row.size), to_string(row.instances)});
        for (std::size_t i = 0; i < columns.size(); ++i) lines.back().push_back(count_text(row, i));
    }
    std::vector<std::size_t> widths(lines.front().size(), 0);
    for (const auto& line : lines)
        for (std::size_t i = 0; i < line.size(); ++i)
            widths[i] = std::max(widths[i], line[i].size());
    std::string text;
    for (const auto& line : lines) {
        for (std::size_t i = 0; i < line.size(); ++i)
            text += (i > 0 ? "  " : "") + std::string(widths[i] - line[i].size(), ' ') + line[i];
        text += '\n';
    }
    for (std::size_t i = 0; i < columns.size(); ++i)
        if (!found.first[i].empty())
            text += "first " + columns[i].name + ": " + joined(found.first[i], "   ") + '\n';
    return text;
}

std::string csv_text(const Census& found, const std::vector<Column>& columns) {
    const auto quoted_field = [](const std::string& text) {
        if (text.find_first_of(",\"") == std::string::npos) return text;
        std::string field = "\"";
        for (const char c : text) field += c == '"' ? "\"\"" : std::string(1, c);
        return field + "\"";
    };
    std::string text = "size,all";
    for (const Column& column : columns)
        text += "," + quoted_field(column.name) + "," + quoted_field(column.name + " undecided");
    text += '\n';
    for (const Census::Row& row : found.rows) {
        text += std::to_string(row.size) + "," + to_string(row.instances);
        for (const auto& verdicts : row.verdicts)
            text += "," + std::to_string(verdicts[0]) + "," + std::to_string(verdicts[2]);
        text += '\n';
    }
    return text;
}

/// As the encyclopedia of integer sequences has its files: a number and a value a line.
std::string bfile_text(const Census& found, const std::vector<Column>& columns,
                       const std::string& of) {
    if (columns.size() > 1)
        throw Error("--format bfile: expected at most one property behind --by, found " +
                    std::to_string(columns.size()));
    std::string text =
        "# " + of + ", by size" + (columns.empty() ? "" : "; " + columns[0].name) + '\n';
    for (const Census::Row& row : found.rows) {
        if (!columns.empty() && row.verdicts[0][2] > 0)
            throw BoundReached(Bound::method,
                               "of size " + std::to_string(row.size) + " " +
                                   counted(row.verdicts[0][2], "instance") +
                                   " stayed undecided, so the sequence is not known");
        text += std::to_string(row.size) + ' ' +
                (columns.empty() ? to_string(row.instances) : std::to_string(row.verdicts[0][0])) +
                '\n';
    }
    return text;
}

Json as_json(const Census& found, const std::vector<Column>& columns, const std::string& of) {
    Json rows = Json::array();
    for (const Census::Row& row : found.rows) {
        Json entry{{"size", row.size}, {"all", row.instances}};
        for (std::size_t i = 0; i < columns.size(); ++i)
            entry.set(columns[i].name, {{"proved", row.verdicts[i][0]},
                                        {"refuted", row.verdicts[i][1]},
                                        {"undecided", row.verdicts[i][2]}});
        rows.add(std::move(entry));
    }
    Json out{{"of", of}, {"rows", rows}};
    Json first;
    for (std::size_t i = 0; i < columns.size(); ++i)
        if (!found.first[i].empty()) first.set(columns[i].name, found.first[i]);
    if (!columns.empty()) out.set("first", std::move(first));
    return out;
}

int take_census(const Options& options) {
    const Budget budget = options.bounds.budget();
    const bool of_systems = options.of.find("systems") != std::string::npos;
    std::vector<Column> columns;
    for (const std::string& property : options.by)
        for (Column& column : columns_of(property, of_systems))
            columns.push_back(std::move(column));
    const std::string some = of_systems ? "L(X) is finite" : "ε in {ε}";
    std::string text = "for all " + options.of + " X: ";
    text += columns.empty() ? some : joined(columns, " and ", [](const Column& column) {
        return "(" + column.statement + ")";
    });
    const Claim claim = read_claim("claim census\ntheorem " + text, "census", {});
    const auto& said = std::get<Quantified>(claim.statements.at(0).statement.says);
    std::vector<Statement> properties;
    if (columns.size() == 1) properties = said.body;
    if (columns.size() > 1) properties = std::get<Joint>(said.body.front().says).parts;
    ProgressBar bar("census");
    CensusOptions how;
    how.first = options.first;
    how.threads = static_cast<unsigned>(options.threads);
    const Census found = census(said, properties, claim, how, budget);
    switch (options.format) {
        case Format::table:
            print(table_text(found, columns));
            break;
        case Format::json:
            print(as_json(found, columns, options.of).text());
            break;
        case Format::csv:
            print(csv_text(found, columns));
            break;
        case Format::bfile:
            print(bfile_text(found, columns, options.of));
            break;
    }
    const bool is_decided = std::ranges::all_of(found.rows, [](const Census::Row& row) {
        return std::ranges::all_of(row.verdicts, [](const auto& counts) { return counts[2] == 0; });
    });
    return is_decided ? success : undecided;
}

}  // namespace

void add_census(Verbs& verbs) {
    auto [verb, options] =
        verbs.add("census", "How many systems or languages of each size have a property",
                  {"algae census 'D0L systems up to size 12'",
                   "algae census '0L systems up to size 7' --by finite,D0L --first 3",
                   "algae census 'finite languages up to size 7' --by 0L,D0L,T0L --format csv"},
                  take_census);
    verb.option("WHAT", options.of, "DOMAIN",
                "what is counted up to renaming, as claims say it: 'D0L systems up to size 12', "
                "'finite languages with words up to length 2 over {a, b}'")
        .required = true;
    verb.option("--by", options.by, list, "PROPERTIES",
                "finite, growth, families, or statements about X, with commas between");
    verb.option("--first", options.first, natural, "N", "show the first N of each property");
    verb.choice("--format", options.format,
                {{"table", Format::table},
                 {"json", Format::json},
                 {"csv", Format::csv},
                 {"bfile", Format::bfile}},
                "table|json|csv|bfile",
                "how the counts are printed; a b-file has one property at most");
    verb.option("--threads", options.threads, natural, "N",
                "0, the default: as many as the machine has");
    verb.bounded_by(options.bounds);
}

}  // namespace algae::command
