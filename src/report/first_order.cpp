// What was decided of a first-order statement about an infinite word, as a page and as JSON.

#include <fmt/format.h>

#include "report/detail/page.hpp"
#include "report/report.hpp"

namespace algae {

namespace {

constexpr std::size_t letters_shown = 24, members_shown = 12, members_listed = 100,
                      states_listed = 10'000, expression_shown = 200;

std::string beginning(const AutomaticWord& word) {
    std::string all;
    bool blanks = false;
    for (const std::string& letter : word.letters) blanks = blanks || letter.size() > 1;
    for (std::size_t n = 0; n < letters_shown; ++n) {
        if (blanks && n > 0) all += ' ';
        all += word.letters[word.numeration.state(n)];
    }
    return all + "...";
}

std::string values(const std::vector<std::pair<std::string, Integer>>& witness) {
    std::string all;
    for (const auto& [name, value] : witness)
        all += (all.empty() ? "" : ", ") + name + " = " + to_string(value);
    return all;
}

std::string verdict(const FirstOrderReport& report) {
    const auto& [relation, holds, witness, largest] = report.answer;
    if (!report.free.empty()) return holds ? "true for some numbers" : "true for no numbers";
    return std::string(holds ? "proved" : "refuted") +
           (witness.empty() ? "" : ": " + values(witness));
}

}  // namespace

std::string to_text(const FirstOrderReport& report) {
    const AutomaticRelation& relation = report.answer.relation;
    std::string page =
        line("statement", report.statement) +
        line("T", beginning(report.word) + ", the infinite word of " + report.system) +
        line("verdict", verdict(report));
    if (!report.free.empty()) {
        const auto tuples = members(relation, report.word.numeration, members_shown + 1);
        std::string all;
        for (std::size_t i = 0; i < std::min(tuples.size(), members_shown); ++i) {
            std::string one;
            for (const Integer& number : tuples[i])
                one += (one.empty() ? "" : ", ") + to_string(number);
            all += (i == 0 ? "" : ", ") + (report.free.size() == 1 ? one : "(" + one + ")");
        }
        if (tuples.size() > members_shown) all += ", ...";
        if (!tuples.empty()) page += line("true for " + joined(report.free, ", "), all);
        if (const auto set = regular_expression(relation, report.word.numeration);
            set && set->size() <= expression_shown)
            page += line("as digits", *set);
        page += line("automaton", fmt::format("{} states, digits 0 to {}", relation.states(),
                                              report.word.numeration.base() - 1));
    }
    if (report.count) {
        std::vector<std::string> first;
        for (std::size_t n = 0; n < members_shown; ++n)
            first.push_back(to_string(report.count->value(report.word.numeration, Integer(n))));
        page += line("number for each " + report.counted, joined(first, ", ") + ", ...");
        page += line("  counted by", fmt::format("matrices with {} rows, one for each digit",
                                                 report.count->size()));
    }
    return page + line("decided by",
                       fmt::format("automata in the numeration of Dumont and Thomas; the largest "
                                   "has {} states",
                                   report.answer.largest));
}

Json to_json(const FirstOrderReport& report) {
    const AutomaticRelation& relation = report.answer.relation;
    const std::uint32_t base = report.word.numeration.base();
    Json witness;
    for (const auto& [name, value] : report.answer.witness) witness.set(name, Json(value));
    Json tuples = Json::array();
    for (const auto& tuple : members(relation, report.word.numeration, members_listed)) {
        Json one = Json::array();
        for (const Integer& number : tuple) one.add(Json(number));
        tuples.add(std::move(one));
    }
    Json states = Json::array();
    for (std::size_t s = 0; s < relation.states() && relation.states() <= states_listed; ++s) {
        Json edges = Json::array();
        for (std::uint32_t e = relation.first[s]; e < relation.first[s + 1]; ++e) {
            Json digits = Json::array();
            std::uint32_t column = relation.edges[e].column;
            for (std::size_t v = 0; v < relation.variables.size(); ++v, column /= base)
                digits.add(column % base);
            edges.add(Json{{"digits", std::move(digits)}, {"to", relation.edges[e].target}});
        }
        states.add(Json{{"accepting", relation.accepting[s] != 0}, {"edges", std::move(edges)}});
    }
    const bool is_closed = report.free.empty();
    const auto expression = regular_expression(relation, report.word.numeration);
    Json count;
    if (report.count) {
        Json first = Json::array();
        for (std::size_t n = 0; n < members_listed; ++n)
            first.add(Json(report.count->value(report.word.numeration, Integer(n))));
        Json matrices = Json::array();
        for (const auto& matrix : report.count->matrices) {
            Json rows = Json::array();
            for (const std::vector<Integer>& row : matrix) rows.add(Json(row));
            matrices.add(std::move(rows));
        }
        count = Json{{"of", report.counted},
                     {"values", std::move(first)},
                     {"begin", report.count->begin},
                     {"digits", std::move(matrices)},
                     {"end", report.count->end}};
    }
    return {{"statement", report.statement},
            {"system", report.system},
            {"verdict", is_closed ? Json(report.answer.holds ? "proved" : "refuted") : Json()},
            {"witness", std::move(witness)},
            {"free", report.free},
            {"members", is_closed ? Json() : std::move(tuples)},
            {"expression", expression ? Json(*expression) : Json()},
            {"count", std::move(count)},
            {"automaton", is_closed ? Json()
                                    : Json{{"states", relation.states()},
                                           {"base", base},
                                           {"table", std::move(states)}}},
            {"largest", report.answer.largest}};
}

}  // namespace algae
