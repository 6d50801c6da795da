// What is known of words and infinite words, line by line of known_words.tsv, compared with the answers of `algae words --json`.

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "command/run.hpp"

namespace {

using Json = nlohmann::json;

struct Fact {
    std::string name, subject, question, source;
    Json value;
};

std::vector<Fact> known_facts() {
    std::ifstream file(source_folder() + "/tests/command/known_words.tsv");
    std::vector<Fact> facts;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line.front() == '#') continue;
        std::istringstream columns(line);
        Fact fact;
        std::string value;
        std::getline(columns, fact.name, '\t');
        std::getline(columns, fact.subject, '\t');
        std::getline(columns, fact.question, '\t');
        std::getline(columns, value, '\t');
        std::getline(columns, fact.source);
        fact.value = Json::parse(value);
        REQUIRE_MESSAGE(!fact.source.empty(), line);
        facts.push_back(std::move(fact));
    }
    return facts;
}

/// Compares facts with answers, and counts.
class Comparison {
public:
    void compare(const Fact& fact) {
        INFO(fact.name, ": ", fact.question, ", ", fact.source);
        if (fact.question == "word") return compare_word(fact);
        if (fact.question == "statement") {
            CHECK(holds(fact.subject, fact.value[0]) == fact.value[1].get<bool>());
            ++values;
            return;
        }
        const Json& found = report(fact.subject);
        const auto equal = [&](const Json& answer, const Json& known) {
            CHECK(answer == known);
            ++values;
        };
        if (fact.question.ends_with("_complexity")) {
            const Json& answer = found[fact.question]["values"];
            REQUIRE(answer.size() == 61);
            for (std::size_t n = 0; n < fact.value.size(); ++n) equal(answer[n], fact.value[n]);
        } else if (fact.question == "critical_exponent") {
            for (const char* key : {"exact", "attained"})
                if (fact.value.contains(key)) equal(found[fact.question][key], fact.value[key]);
            const auto length = fact.value["occurs"][0].get<int>(),
                       period = fact.value["occurs"][1].get<int>();
            CHECK(holds(fact.subject, "for some i: equal(i, i+" + std::to_string(period) + ", " +
                                          std::to_string(length - period) + ")"));
            ++values;
        } else if (fact.question == "imbalance") {
            equal(found["imbalance"], fact.value["to_60"]);
            for (const auto& [letter, pair] : fact.value["occurs"].items()) {
                const auto length = pair[1].get<std::size_t>();
                if (length > 60) {
                    CHECK(fact.value.contains("undecided"));
                    undecided.push_back(fact.name + ": " + fact.question + " of " + letter);
                    continue;
                }
                CHECK(found["imbalance_values"][length] >= pair[0]);
                ++values;
            }
        } else if (fact.question == "recurrence_function") {
            for (const auto& [n, known] : fact.value.items())
                equal(found[fact.question]["values"][std::stoul(n)], known);
        } else if (fact.question == "bispecial") {
            Json short_ones = Json::array();
            for (const Json& one : found[fact.question])
                if (one["word"].get<std::string>().size() <= 30) short_ones.push_back(one);
            equal(short_ones, fact.value);
        } else if (fact.question == "primitive") {
            for (const auto& [key, known] : fact.value.items()) equal(found[key], known);
        } else if (fact.question == "frequencies") {
            for (const auto& [letter, known] : fact.value.items()) {
                const double decimal =
                    std::stod(found[fact.question][letter]["decimal"].get<std::string>());
                CHECK(std::abs(decimal - known.get<double>()) < 1e-10);
                ++values;
            }
        } else {
            REQUIRE((fact.question == "closed_under_reversal" || fact.question == "return_words"));
            equal(found[fact.question], fact.value);
        }
    }

    std::size_t values = 0;
    std::vector<std::string> undecided;

private:
    void compare_word(const Fact& fact) {
        const Json found = Json::parse(run("words --word " + fact.subject + " --json").out);
        for (const auto& known : fact.value.items()) {
            INFO(known.key());
            CHECK(found[known.key()] == known.value());
            ++values;
        }
    }
    std::string file(const std::string& subject) {
        return files_.file("word.lsys", subject + "\n");
    }
    bool holds(const std::string& subject, const std::string& statement) {
        const Run answer = run("words " + file(subject) + " --say '" + statement + "'");
        REQUIRE_MESSAGE(answer.status <= 1, answer.err);
        return answer.status == 0;
    }
    const Json& report(const std::string& subject) {
        const auto [at, is_new] = reports_.try_emplace(subject);
        if (is_new) at->second = Json::parse(run("words " + file(subject) + " --to 60 --json").out);
        return at->second;
    }

    Scratch files_;
    std::map<std::string, Json> reports_;
};

}  // namespace

TEST_CASE("words: all that is known of 27 words is what the command answers") {
    Comparison comparison;
    const std::vector<Fact> facts = known_facts();
    for (const Fact& fact : facts) comparison.compare(fact);
    CHECK(facts.size() == 66);
    CHECK(comparison.values == 1532);
    // known_words.tsv has the reason.
    CHECK(comparison.undecided ==
          std::vector<std::string>{"non-pisot-2: imbalance of a", "non-pisot-2: imbalance of b"});
    MESSAGE(facts.size(), " facts, ", comparison.values, " values compared, ",
            comparison.undecided.size(), " not decided");
}
