#include "environment/external_environment.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

#include "base/error.hpp"

namespace algae {

namespace {

using nlohmann::json;
using nlohmann::ordered_json;

/// Whole numbers without a point.
ordered_json number(double value) {
    constexpr double exact = 9007199254740992;  // 2^53
    if (std::abs(value) < exact && std::floor(value) == value)
        return static_cast<std::int64_t>(value);
    return value;
}

ordered_json numbers(std::span<const double> values) {
    ordered_json out = ordered_json::array();
    for (const double value : values) out.push_back(number(value));
    return out;
}

ordered_json numbers(const Vector& vector) {
    const double values[] = {vector.x, vector.y, vector.z};
    return numbers(values);
}

std::string question(const Traversal& course, std::span<const Query* const> queries) {
    ordered_json all = ordered_json::array();
    for (const Query* query : queries)
        all.push_back({{"module", query->name},
                       {"index", query->module},
                       {"parameters", numbers(query->parameters)},
                       {"position", numbers(query->position)},
                       {"heading", numbers(query->attitude.heading())},
                       {"left", numbers(query->attitude.left())},
                       {"up", numbers(query->attitude.up())}});
    return ordered_json{{"generation", course.generation}, {"queries", all}}.dump();
}

/// The beginning of what a program wrote, in quotes, as it can be shown.
std::string shown(const std::string& text) {
    constexpr std::size_t most = 60;
    std::string out;
    for (const char byte : text.substr(0, most)) out += byte >= 0x20 && byte < 0x7F ? byte : '?';
    return '\'' + out + (text.size() > most ? "...'" : "'");
}

/// Reads the line that answers these queries.
class Answer {
public:
    Answer(const std::string& command, const Traversal& course, std::span<const Query* const> queries)
        : command_(command), course_(course), queries_(queries) {}

    std::vector<std::vector<double>> read(const std::string& line) const {
        const json all = json::parse(line, nullptr, false);
        if (!all.is_object() || !all.contains("answers") || !all["answers"].is_array())
            fail("expected a line such as {\"answers\":[[1],[2]]}, found " + shown(line));
        const json& list = all["answers"];
        if (list.size() != queries_.size())
            fail("expected " + std::to_string(queries_.size()) + " answers, found " +
                 std::to_string(list.size()));
        std::vector<std::vector<double>> out;
        for (std::size_t i = 0; i < list.size(); ++i)
            out.push_back(parameters(list[i], *queries_[i]));
        return out;
    }

private:
    [[noreturn]] void fail(const std::string& what) const {
        throw Error("the environment program '" + command_ + "', generation " +
                    std::to_string(course_.generation) + ": " + what);
    }

    std::vector<double> parameters(const json& answer, const Query& query) const {
        const std::size_t count = query.parameters.size();
        const std::string expected = "expected an array of " + std::to_string(count) +
                                     (count == 1 ? " number" : " numbers") + " for " +
                                     place_of(query, course_) + ", found ";
        if (!answer.is_array() || answer.size() != count) fail(expected + shown(answer.dump()));
        std::vector<double> out;
        for (const json& value : answer) {
            if (!value.is_number()) fail(expected + shown(answer.dump()));
            out.push_back(value.get<double>());
        }
        return out;
    }

    const std::string& command_;
    const Traversal& course_;
    std::span<const Query* const> queries_;
};

}  // namespace

std::vector<std::vector<double>> ExternalEnvironment::answers(const Traversal& course,
                                                              std::span<const Query* const> queries,
                                                              const Budget& budget) {
    std::size_t longest = 1 << 16;  // bytes: room for more than the numbers need
    for (const Query* query : queries) longest += 64 + 64 * query->parameters.size();
    const std::string what = "the answer to generation " + std::to_string(course.generation);
    const std::string line =
        program_.answer(question(course, queries), what, longest, budget, wait_);
    return Answer(command_, course, queries).read(line);
}

}  // namespace algae
