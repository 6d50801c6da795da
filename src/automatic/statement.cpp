#include "automatic/detail/statement.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

// First-order statements as certificates have them.

namespace algae {

namespace {

using Json = nlohmann::ordered_json;
using Kind = FirstOrderNode::Kind;

class Writer {
public:
    Json operator()(const FirstOrderStatement& statement) {
        for (const std::string& variable : statement.free()) named(variable);
        return (*this)(statement.root());
    }

private:
    Json operator()(const FirstOrderNode& node) {
        const auto sums = [&](std::size_t from) {
            Json all = Json::array();
            for (std::size_t i = from; i < node.terms.size(); ++i)
                all.push_back(sum(node.terms[i]));
            return all;
        };
        const auto parts = [&] {
            Json all = Json::array();
            for (const auto& part : node.parts) all.push_back((*this)(*part));
            return all;
        };
        const auto bound = [&](const char* key) -> Json {
            Json all = Json::array();
            for (const std::string& variable : node.variables) all.push_back(named(variable));
            Json holds = (*this)(*node.parts[0]);
            return {{key, std::move(all)}, {"holds", std::move(holds)}};
        };
        switch (node.kind) {
            case Kind::equation:
                return {{"equation", sum(node.terms[0])}};
            case Kind::less:
                return {{"less", sum(node.terms[0])}};
            case Kind::same_letter:
                return {{"same letter", sums(0)}};
            case Kind::letter:
                return {{"letter", node.letter}, {"at", sum(node.terms[0])}};
            case Kind::equal:
                return {{"equal", sums(0)}};
            case Kind::palindrome:
                return {{"palindrome", sums(0)}};
            case Kind::negation:
                return {{"not", (*this)(*node.parts[0])}};
            case Kind::conjunction:
                return {{"and", parts()}};
            case Kind::disjunction:
                return {{"or", parts()}};
            case Kind::implication:
                return {{"implies", parts()}};
            case Kind::equivalence:
                return {{"iff", parts()}};
            case Kind::exists:
                return bound("exists");
            case Kind::for_all:
                break;
        }
        return bound("for all");
    }
    /// The name as it was written, with strokes where another quantifier binds it too.
    std::string named(const std::string& variable) {
        const auto [at, is_new] = names_.try_emplace(variable);
        if (is_new) {
            at->second = written_name(variable);
            while (!taken_.insert(at->second).second) at->second += "'";
        }
        return at->second;
    }
    Json sum(const LinearTerm& term) {
        Json of = Json::object();
        for (const auto& [variable, times] : term.coefficients)
            of[named(variable)] = to_string(times);
        return {{"of", std::move(of)}, {"plus", to_string(term.constant)}};
    }

    std::map<std::string, std::string> names_;
    std::set<std::string> taken_;
};

bool is_sum(const LinearTerm& term) { return !term.variable() && !term.coefficients.empty(); }

bool adds(const FirstOrderNode& node) {
    if (node.kind == Kind::equal || node.kind == Kind::palindrome) return true;
    for (const LinearTerm& term : node.terms) {
        if (node.kind != Kind::equation && node.kind != Kind::less) {
            if (is_sum(term)) return true;
            continue;
        }
        const auto [left, right] = term.sides();
        if (is_sum(left) || is_sum(right)) return true;
    }
    return std::ranges::any_of(node.parts, [](const auto& part) { return adds(*part); });
}

}  // namespace

Json to_json(const FirstOrderStatement& statement) { return Writer()(statement); }

Json to_json(const CountingStatement& statement) {
    Json parts = Json::array();
    for (const auto& [times, places] : statement.parts)
        parts.push_back({{"times", to_string(times)}, {"places", to_json(places)}});
    return {{"counts", std::move(parts)},
            {"n", to_string(statement.slope)},
            {"plus", to_string(statement.constant)},
            {"from", to_string(statement.from)}};
}

bool adds(const FirstOrderStatement& statement) { return adds(statement.root()); }

}  // namespace algae
