#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "notation/notation.hpp"

// The grammar by which editors colour `.lsys` files, made from the table of statements, so that an editor knows the
// keywords and names that the readers know. It is JSON in the form of TextMate, which Visual Studio Code, Sublime
// Text, GitHub and others read: patterns are tried in order at each place of a line, and the first that matches names
// the scope by which a theme chooses the colour.

namespace algae {

namespace {

using Json = nlohmann::ordered_json;

// Where a statement may begin, with the blanks before it, and where it ends.
constexpr const char* begins = R"((?:^|(?<=[;{]))\s*)";
constexpr const char* ends = "(?=;|$)";

std::string any_of(const std::vector<std::string>& words) {
    std::string out;
    for (const std::string& word : words) out += (out.empty() ? "(" : "|") + word;
    return out + ')';
}

Json scope(const char* name) { return {{"name", std::string(name) + ".lsys"}}; }

Json pattern(const char* name, const std::string& match) {
    Json out = scope(name);
    out["match"] = match;
    return out;
}

Json included(const char* name) { return {{"include", std::string("#") + name}}; }

/// A statement with its keyword, in which these patterns hold.
Json statement(const std::vector<std::string>& keywords, Json patterns) {
    return {{"begin", begins + any_of(keywords) + R"((?=\s))"},
            {"beginCaptures", {{"1", scope("keyword.other")}}},
            {"end", ends},
            {"patterns", std::move(patterns)}};
}

}  // namespace

std::string editor_grammar() {
    const std::vector<std::string> texts{"title", "source"};  // the rest of the line is theirs
    const std::string word_ends = R"((?=\s|;|$))";
    Json statements = Json::array();
    std::vector<std::string> plain;
    for (const StatementHelp& help : system_statements()) {
        if (help.keyword == texts[0] || help.keyword == texts[1]) continue;
        if (help.words.empty()) {
            plain.push_back(help.keyword);
            continue;
        }
        const std::string names = R"((?<=\s))" + any_of(help.words) + word_ends;
        Json patterns = Json::array({pattern("support.constant", names)});
        if (help.keyword == "colour")
            patterns.push_back(pattern("constant.other", "#(?:[0-9A-Fa-f]{3}){1,2}" + word_ends));
        for (const char* name : {"comment", "number"}) patterns.push_back(included(name));
        statements.push_back(statement({help.keyword}, std::move(patterns)));
    }
    statements.push_back(
        statement(texts, Json::array({included("comment"), pattern("string.unquoted", "[^;]")})));
    Json keyword{{"match", begins + any_of(plain) + R"((?=\s))"},
                 {"captures", {{"1", scope("keyword.other")}}}};
    Json all = Json::array({included("comment")});
    for (Json& one : statements) all.push_back(std::move(one));
    all.push_back(std::move(keyword));
    all.push_back(pattern("keyword.operator", R"(->|→|-\([^)]*\)->)"));
    all.push_back(pattern("string.quoted", R"("[^"]*")"));
    all.push_back(pattern("variable.other", R"(\?\p{L}+)"));
    all.push_back(included("number"));
    const Json grammar{
        {"name", "L-system"},
        {"scopeName", "source.lsys"},
        {"fileTypes", {"lsys"}},
        {"patterns", std::move(all)},
        {"repository",
         {{"comment", pattern("comment.line", R"((?:^|(?<=\s))#.*$)")},
          {"number", pattern("constant.numeric", R"((?<![\w.])\d+(?:\.\d+)?(?:[eE][+-]?\d+)?)")}}}};
    return grammar.dump(4) + '\n';
}

}  // namespace algae
