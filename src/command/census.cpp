// `census`: how many systems, languages or words of each size there are, and how many of them have a property.
//
// What is counted and the properties are said in the words of claims: the verb makes the statement `for all DOMAIN X:
// PROPERTY and PROPERTY ...` of them, so every mistake in them is told as in a claim.
//
// A long census is written down while it is taken. The library cuts it into chunks that depend on the question only; a checkpoint is
// a file with a header, which says what is asked, and a line for each chunk that is done, in any order. So an interrupted
// census goes on from its file, and parts that were taken apart are put together by `cat`. `algae-census` (census_mpi.cpp)
// has several processes take the chunks; the first of them writes the file.

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <variant>

#include "command/detail/census.hpp"
#include "command/detail/checkpoint.hpp"
#include "command/detail/files.hpp"
#include "command/detail/output.hpp"
#include "command/detail/verb.hpp"
#include "exact/exact.hpp"
#include "language/language.hpp"
#include "notation/notation.hpp"

namespace algae::command {

CensusRanks* census_ranks = nullptr;

namespace {

enum class Format { table, json, csv, bfile };
enum class Distinct { systems, languages };

/// Numbers of chunks, both ends included.
struct Chunks {
    std::uint64_t first = 0, last = std::numeric_limits<std::uint64_t>::max();
};

Chunks chunks(const std::string& option, const std::string& text) {
    const auto dots = text.find("..");
    if (dots == std::string::npos || dots == 0 || dots + 2 == text.size())
        refuse(option, "a range of chunks such as 0..99", text);
    const Chunks found{natural(option, text.substr(0, dots)),
                       natural(option, text.substr(dots + 2))};
    if (found.first > found.last) refuse(option, "a range that goes up, such as 0..99", text);
    return found;
}

/// A natural number that is not 0.
std::uint64_t positive_count(const std::string& option, const std::string& text) {
    const std::uint64_t count = natural(option, text);
    if (count == 0) refuse(option, "a whole number from 1 on", text);
    return count;
}

struct Options {
    std::string of;
    std::vector<std::string> by;
    std::uint64_t first = 0, threads = 0, chunk_size = CensusOptions().chunk, seed = 1;
    Format format = Format::table;
    Distinct distinct = Distinct::systems;
    std::string checkpoint, resume, certificate;
    std::optional<Chunks> chunks;
    std::optional<std::uint64_t> sample;
    Bounds bounds;
};

// --- The checkpoint ---

/// What is asked, as the first line of a checkpoint: chunks of other questions are other chunks.
std::string header_line(const Options& options, const std::vector<std::string>& properties) {
    constexpr int order = 1;  // of instances and chunks; another order gets another number
    Json header{{"format", "algae census 1"},
                {"of", options.of},
                {"by", properties},
                {"order", order},
                {"chunk", options.chunk_size},
                {"first", options.first},
                {"languages", options.distinct == Distinct::languages}};
    std::string line = header.text(-1);
    while (!line.empty() && line.back() == '\n') line.pop_back();
    return line;
}

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

/// Systems that stand for no language, where languages are counted.
std::string apart_text(const Census::Row& row) {
    return std::to_string(row.infinite) +
           (row.open > 0 ? "+" + std::to_string(row.open) + "?" : "");
}

std::string table_text(const Census& found, const std::vector<Column>& columns, Distinct distinct) {
    const bool languages = distinct == Distinct::languages;
    std::vector<std::vector<std::string>> lines{{"size", languages ? "finite languages" : "all"}};
    for (const Column& column : columns) lines.front().push_back(column.name);
    if (languages) lines.front().push_back("systems of infinite ones");
    for (const Census::Row& row : found.rows) {
        lines.push_back({std::to_string(row.size), to_string(row.instances)});
        for (std::size_t i = 0; i < columns.size(); ++i) lines.back().push_back(count_text(row, i));
        if (languages) lines.back().push_back(apart_text(row));
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

std::string csv_text(const Census& found, const std::vector<Column>& columns, Distinct distinct) {
    const bool languages = distinct == Distinct::languages;
    std::string text = languages ? "size,finite languages" : "size,all";
    for (const Column& column : columns)
        text += "," + csv_field(column.name) + "," + csv_field(column.name + " undecided");
    if (languages) text += ",systems of infinite ones,systems undecided";
    text += '\n';
    for (const Census::Row& row : found.rows) {
        text += std::to_string(row.size) + "," + to_string(row.instances);
        for (const auto& verdicts : row.verdicts)
            text += "," + std::to_string(verdicts[0]) + "," + std::to_string(verdicts[2]);
        if (languages) text += "," + std::to_string(row.infinite) + "," + std::to_string(row.open);
        text += '\n';
    }
    return text;
}

/// As the encyclopedia of integer sequences has its files: a number and a value a line.
std::string bfile_text(const Census& found, const std::vector<Column>& columns,
                       const std::string& of, Distinct distinct) {
    if (columns.size() > 1)
        throw Error("--format bfile: expected at most one property behind --by, found " +
                    std::to_string(columns.size()));
    std::string text = "# " +
                       std::string(distinct == Distinct::languages
                                       ? "finite languages, each at its first system, of "
                                       : "") +
                       of + ", by size" + (columns.empty() ? "" : "; " + columns[0].name) + '\n';
    for (const Census::Row& row : found.rows) {
        if (row.open > 0)
            throw BoundReached(Bound::method,
                               "of size " + std::to_string(row.size) + " " +
                                   counted(row.open, "system") +
                                   " stayed undecided, so the sequence is not known");
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

Json as_json(const Census& found, const std::vector<Column>& columns, const std::string& of,
             Distinct distinct) {
    const bool languages = distinct == Distinct::languages;
    Json rows = Json::array();
    for (const Census::Row& row : found.rows) {
        Json entry{{"size", row.size}, {languages ? "finite languages" : "all", row.instances}};
        if (languages) {
            entry.set("systems of infinite ones", row.infinite);
            entry.set("systems undecided", row.open);
        }
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

void print_census(const Census& found, const std::vector<Column>& columns, const Options& options) {
    switch (options.format) {
        case Format::table:
            print(table_text(found, columns, options.distinct));
            break;
        case Format::json:
            print(as_json(found, columns, options.of, options.distinct).text());
            break;
        case Format::csv:
            print(csv_text(found, columns, options.distinct));
            break;
        case Format::bfile:
            print(bfile_text(found, columns, options.of, options.distinct));
            break;
    }
}

/// Adds to the totals what a file has of them, and the chunks that are missing; all of them, or those of --chunks.
void count_chunks(const Options& options, const std::string& header, const Quantified& said,
                  const std::vector<Statement>& properties, const Claim& claim, CensusOptions how,
                  CensusTotals& totals, const Budget& budget) {
    const bool is_first = !census_ranks || census_ranks->is_first();
    Checkpoint checkpoint;
    if (!options.resume.empty())
        checkpoint.go_on(
            options.resume, header, is_first,
            [&](const std::string& line) {
                const auto chunk = census_chunk(line);
                if (chunk) totals.add(*chunk);
                return chunk.has_value();
            },
            budget);
    else if (is_first && !options.checkpoint.empty())
        checkpoint.begin(options.checkpoint, header);
    how.finishes_chunks = checkpoint.is_open() || census_ranks;
    ProgressBar bar("census");
    const std::uint64_t sizes = census_size(said);
    const auto write = [&](const CensusChunk& chunk) {
        if (checkpoint.is_open()) checkpoint.write(census_line(chunk));
        bar.report(static_cast<double>(chunk.size - 1) / static_cast<double>(sizes));
    };
    const Chunks wanted = options.chunks.value_or(Chunks());
    std::uint64_t following = wanted.first;
    const auto next = [&]() -> std::optional<std::uint64_t> {
        while (totals.has(following)) ++following;
        if (following > wanted.last) return std::nullopt;
        return following++;
    };
    if (!is_first) {
        how.next = [] { return census_ranks->next(); };
        how.on_chunk = [](const CensusChunk& chunk) { census_ranks->send(chunk); };
    } else if (census_ranks) {
        census_ranks->serve([&] { return stop ? std::nullopt : next(); },
                            [&](const CensusChunk& chunk) {
                                write(chunk);
                                totals.add(chunk);
                            });
        budget.check();
        return;
    } else {
        how.next = next;
        how.on_chunk = write;
    }
    take_census(said, properties, claim, how, totals, budget);
}

int run_census(const Options& options) {
    if (options.chunks && options.checkpoint.empty() && options.resume.empty())
        throw Error(
            "--chunks: expected --checkpoint FILE or --resume FILE, which the chunks are for");
    if (options.sample && options.certificate.empty())
        throw Error("--verify-sample: expected --certificate FILE, which the proofs are for");
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
    std::vector<std::string> texts;
    for (const Column& column : columns) texts.push_back(column.statement);
    const std::uint64_t sizes = census_size(said);
    CensusOptions how;
    how.first = options.first;
    how.threads = static_cast<unsigned>(options.threads);
    how.chunk = options.chunk_size;
    how.languages = options.distinct == Distinct::languages;
    CensusTotals totals(sizes, properties.size(), how);
    count_chunks(options, header_line(options, texts), said, properties, claim, how, totals,
                 budget);
    if (census_ranks && !census_ranks->is_first()) return success;
    const Census found = totals.census();
    if (!found.is_whole) {
        note("a part of the census is in " + options.checkpoint + options.resume +
             "; --resume takes the rest");
        return success;
    }
    print_census(found, columns, options);
    const bool is_decided = std::ranges::all_of(found.rows, [](const Census::Row& row) {
        return row.open == 0 &&
               std::ranges::all_of(row.verdicts, [](const auto& counts) { return counts[2] == 0; });
    });
    if (options.sample)
        write_file(options.certificate,
                   Json(certificate(census_sample(said, properties, claim, found, *options.sample,
                                                  options.seed, budget)))
                       .text(1));
    return is_decided ? success : undecided;
}

}  // namespace

void add_census(Verbs& verbs) {
    auto [verb, options] =
        verbs.add("census", "How many systems or languages of each size have a property",
                  {"algae census 'D0L systems up to size 12'",
                   "algae census '0L systems up to size 7' --by finite,D0L --first 3",
                   "algae census 'finite languages up to size 7' --by 0L,D0L,T0L --format csv",
                   "algae census 'D0L systems up to size 9' --distinct languages",
                   "algae census '0L systems up to size 9' --by finite --checkpoint 0l.jsonl"},
                  run_census);
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
    verb.choice(
        "--distinct", options.distinct,
        {{"systems", Distinct::systems}, {"languages", Distinct::languages}}, "systems|languages",
        "languages: count the finite languages of the systems, each once up to renaming, at "
        "the first system that has it");
    verb.option("--checkpoint", options.checkpoint, "FILE",
                "write each chunk of the census to a new file when it is done")
        .excludes = {"--resume"};
    verb.option("--resume", options.resume, "FILE",
                "go on from such a file, or from several put together");
    verb.option("--chunks", options.chunks, chunks, "A..B",
                "take only these chunks, counted from 0, and print nothing before all are known");
    verb.option("--chunk-size", options.chunk_size, positive_count, "N",
                "instances of a chunk (default 1000)");
    verb.option("--verify-sample", options.sample, positive_count, "N",
                "decide N instances, drawn from all, with proofs")
        .excludes = {"--distinct"};
    verb.option("--seed", options.seed, natural, "N", "by which instances are drawn (default 1)");
    verb.output("--certificate", options.certificate, "FILE",
                "write these proofs, for `algae verify`")
        .needs = {"--verify-sample"};
    verb.option("--threads", options.threads, natural, "N",
                "0, the default: as many as the machine has");
    verb.bounded_by(options.bounds);
}

}  // namespace algae::command
