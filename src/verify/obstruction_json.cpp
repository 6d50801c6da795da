#include "verify/obstruction_json.hpp"

#include <map>
#include <nlohmann/json.hpp>

namespace algae {

namespace {

using Json = nlohmann::ordered_json;
using End = ObstructionCase::End;

const std::map<std::string, End>& ends() {
    static const std::map<std::string, End> all = {{"no image", End::no_image},
                                                   {"needed", End::needed},
                                                   {"sources", End::sources},
                                                   {"conflict", End::conflict},
                                                   {"choice", End::choice}};
    return all;
}

/// Writes the parts of an obstruction.
class Writer {
public:
    explicit Writer(const Alphabet& alphabet) : alphabet_(alphabet) {}

    Json one_case(const ObstructionCase& part) const {
        Json written = Json::object();
        written["excluded"] = Json::array();
        for (const ExcludedRule& excluded : part.excluded) {
            Json each{{"letter", alphabet_.name(excluded.rule.letter)},
                      {"image", word(excluded.rule.image)},
                      {"word", word(excluded.word)}};
            if (!excluded.images.empty()) each["images"] = words(excluded.images);
            written["excluded"].push_back(std::move(each));
        }
        for (const auto& [name, end] : ends())
            if (end == part.end) written["end"] = name;
        if (part.end == End::no_image || part.end == End::choice)
            written["letter"] = alphabet_.name(part.letter);
        if (part.end == End::sources) {
            written["sources"] = Json::array();
            for (const auto& set : part.sources) written["sources"].push_back(words(set));
        }
        if (part.end == End::conflict) {
            written["word"] = word(part.word);
            written["images"] = words(part.images);
        }
        if (part.end == End::conflict || part.end == End::choice) {
            written["rules"] = rules(part.rules);
            written["cases"] = Json::array();
            for (const ObstructionCase& each : part.cases)
                written["cases"].push_back(one_case(each));
        }
        return written;
    }

    Json rules(const std::vector<LetterRule>& all) const {
        Json written = Json::array();
        for (const LetterRule& rule : all)
            written.push_back(
                {{"letter", alphabet_.name(rule.letter)}, {"image", word(rule.image)}});
        return written;
    }

private:
    Json word(const Word& each) const { return certificate_text(alphabet_, each); }
    Json words(const std::vector<Word>& all) const {
        Json written = Json::array();
        for (const Word& each : all) written.push_back(word(each));
        return written;
    }

    const Alphabet& alphabet_;
};

}  // namespace

std::string certificate_text(const Alphabet& alphabet, const Word& word) {
    std::string text;
    for (std::size_t i = 0; i < word.size(); ++i)
        text += (i > 0 ? " " : "") + alphabet.name(word[i]);
    return text;
}

Json to_json(const FamilyObstruction& obstruction) {
    const Writer writer(*obstruction.language.alphabet);
    Json written{{"root", writer.one_case(obstruction.root)}};
    if (obstruction.impossible.empty()) return written;
    written["impossible"] = Json::array();
    for (const ImpossibleTable& table : obstruction.impossible)
        written["impossible"].push_back(
            {{"rules", writer.rules(table.rules)}, {"why", writer.one_case(table.why)}});
    return written;
}

namespace verify {

namespace {

LetterRule read_rule(const Reader& reader, const Field& field) {
    return {reader.letter(field.at("letter")), reader.word(field.at("image"))};
}

std::vector<LetterRule> read_rules(const Reader& reader, const Field& field) {
    std::vector<LetterRule> all;
    for (const Field& each : field.list()) {
        each.only({"letter", "image"});
        all.push_back(read_rule(reader, each));
    }
    return all;
}

ExcludedRule read_excluded(const Reader& reader, const Field& field) {
    field.only({"letter", "image", "word", "images"});
    ExcludedRule read{read_rule(reader, field), reader.word(field.at("word")), {}};
    if (field.has("images")) {
        read.images = reader.words(field.at("images"));
        if (read.images.empty()) field.at("images").fail("a step has an image for each letter");
    }
    return read;
}

ObstructionCase read_case(const Reader& reader, const Field& field) {
    ObstructionCase read;
    for (const Field& each : field.at("excluded").list())
        read.excluded.push_back(read_excluded(reader, each));
    const Field end = field.at("end");
    const auto found = ends().find(end.text());
    if (found == ends().end()) end.fail("no case ends with '" + end.text() + "'");
    read.end = found->second;
    const auto read_cases = [&] {
        read.rules = read_rules(reader, field.at("rules"));
        for (const Field& each : field.at("cases").list())
            read.cases.push_back(read_case(reader, each));
    };
    switch (read.end) {
        case End::no_image:
            field.only({"excluded", "end", "letter"});
            read.letter = reader.letter(field.at("letter"));
            break;
        case End::needed:
            field.only({"excluded", "end"});
            break;
        case End::sources:
            field.only({"excluded", "end", "sources"});
            for (const Field& set : field.at("sources").list())
                read.sources.push_back(reader.words(set));
            break;
        case End::conflict:
            field.only({"excluded", "end", "word", "images", "rules", "cases"});
            read.word = reader.word(field.at("word"));
            read.images = reader.words(field.at("images"));
            read_cases();
            break;
        case End::choice:
            field.only({"excluded", "end", "letter", "rules", "cases"});
            read.letter = reader.letter(field.at("letter"));
            read_cases();
            break;
    }
    return read;
}

}  // namespace

FamilyObstruction read_obstruction(const Reader& reader, const Field& field) {
    field.only({"root", "impossible"});
    FamilyObstruction read;
    read.root = read_case(reader, field.at("root"));
    if (!field.has("impossible")) return read;
    for (const Field& each : field.at("impossible").list()) {
        each.only({"rules", "why"});
        read.impossible.push_back(
            {read_rules(reader, each.at("rules")), read_case(reader, each.at("why"))});
    }
    return read;
}

}  // namespace verify

}  // namespace algae
