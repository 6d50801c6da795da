// Errors as JSON on every verb, and the language server.

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <nlohmann/json.hpp>

#include "command/run.hpp"

using nlohmann::json;

namespace {

json error_of(const std::string& arguments) {
    const Run failed = run(arguments);
    INFO(arguments);
    CHECK(failed.status != 0);
    CHECK(!failed.err.empty());
    return json::parse(failed.out)["error"];
}

/// What the server answers to these messages.
std::vector<json> served(const std::vector<json>& messages) {
    const Scratch scratch;
    std::string input;
    for (json message : messages) {
        message["jsonrpc"] = "2.0";
        const std::string text = message.dump();
        input += "Content-Length: " + std::to_string(text.size()) + "\r\n\r\n" + text;
    }
    const Run answered = run("lsp <'" + scratch.file("in", input) + "'");
    std::vector<json> all;
    for (std::size_t at = 0; at < answered.out.size();) {
        const std::size_t blank = answered.out.find("\r\n\r\n", at);
        if (blank == std::string::npos) break;
        const std::size_t length = std::stoul(answered.out.substr(at + 16));
        all.push_back(json::parse(answered.out.substr(blank + 4, length)));
        at = blank + 4 + length;
    }
    return all;
}

json opened(const std::string& text, const std::string& name = "file:///tmp/x.lsys") {
    return {{"method", "textDocument/didOpen"},
            {"params", {{"textDocument", {{"uri", name}, {"text", text}}}}}};
}

json request(const std::string& method, std::size_t line, std::size_t character,
             const json& more = json::object()) {
    json params{{"textDocument", {{"uri", "file:///tmp/x.lsys"}}},
                {"position", {{"line", line}, {"character", character}}}};
    params.update(more);
    return {{"id", 7}, {"method", "textDocument/" + method}, {"params", params}};
}

/// The text after the edits of a rename.
std::string edited(std::string text, const json& edits) {
    for (const json& edit : edits) {  // the last place comes first
        std::size_t at = 0;
        for (std::size_t line = edit["range"]["start"]["line"]; line > 0; --line)
            at = text.find('\n', at) + 1;
        const std::size_t from = edit["range"]["start"]["character"],
                          to = edit["range"]["end"]["character"];
        text.replace(at + from, to - from, edit["newText"]);
    }
    return text;
}

}  // namespace

TEST_CASE("with --json an error is JSON on standard output too, on every verb") {
    const json typed = error_of("derive 'a -> ab]' -n 2 --json");
    CHECK(typed["file"] == "typed system");
    CHECK(typed["line"] == 1);
    CHECK(typed["column"] == 8);
    CHECK(typed["end"] == 9);
    CHECK(typed["message"] == "unmatched ']'");
    CHECK(typed["status"] == 2);
    const json meant = error_of("show koh --json");
    CHECK(meant["suggestion"] == "koch");
    CHECK(meant["line"].is_null());
    CHECK(error_of("derive koch --json")["message"] == "-n is missing: which generation?");
    CHECK(error_of("draw koch --jsn --json")["suggestion"] == "--json");
    const Scratch scratch;
    const std::string two = scratch.file("x.lsys", "axiom a\nangel 3\nF -> (\n");
    const json all = error_of("show '" + two + "' --json");
    CHECK(all["all"].size() == 2);
    CHECK(all["suggestion"] == "angle");
    CHECK(all["line"] == 2);
    CHECK(error_of("derive koch -n 30 --max-letters 10 --json")["status"] == 3);
    // One verb of each file of the command.
    const char* bad = " 'a -> ab]' ";
    for (const std::string verb : {"show", "growth", "words", "finite", "dimension"})
        CHECK(error_of(verb + bad + "--json")["column"] == 8);
    for (const std::string verb :
         {"letter -n 1 --at 0", "derive -n 1", "draw -n 1 -o x.svg", "tree -n 1 -o x.svg"})
        CHECK(error_of(verb + bad + "--json")["column"] == 8);
    CHECK(error_of("member 'a -> ab]' a --json")["column"] == 8);
    CHECK(error_of("equal koch 'a -> ab]' --json")["column"] == 8);
    CHECK(error_of("is 0L '{a' --json")["line"] == 1);
    CHECK(error_of("list '{a' --json")["line"] == 1);
    CHECK(error_of("check --say 'a is' --json")["line"] == 1);
    CHECK(error_of("closure nothing --json")["message"].get<std::string>().starts_with("expected"));
    CHECK(error_of("verify no-such-file --json")["message"].get<std::string>().starts_with(
        "cannot read"));
    CHECK(error_of("latex no-such-file --json")["message"].get<std::string>().starts_with(
        "cannot read"));
    // Without --json there is nothing on standard output.
    CHECK(run("show koh").out.empty());
}

TEST_CASE("the server finds errors as one types") {
    const auto all = served({{{"id", 1}, {"method", "initialize"}, {"params", json::object()}},
                             opened("axiom F\nF -> F[+F\nangel 60\n"),
                             opened("claim T\nshow {a is 0L\n", "file:///tmp/y.claim"),
                             {{"id", 2}, {"method", "shutdown"}},
                             {{"method", "exit"}}});
    REQUIRE(all.size() == 4);
    CHECK(all[0]["result"]["capabilities"]["renameProvider"] == true);
    const json& found = all[1]["params"]["diagnostics"];
    REQUIRE(found.size() == 2);
    CHECK(found[0]["range"]["start"]["line"] == 1);
    CHECK(found[1]["range"]["start"]["line"] == 2);
    CHECK(found[1]["data"]["suggestion"] == "angle");
    CHECK(all[2]["params"]["diagnostics"].size() == 1);
    CHECK(all[3]["result"].is_null());
}

TEST_CASE("the server completes keywords and their words") {
    const auto all = served({opened("axiom F\n\nstamp F \n"), request("completion", 1, 0),
                             request("completion", 2, 8)});
    REQUIRE(all.size() == 3);
    std::vector<std::string> labels;
    for (const json& item : all[1]["result"]) labels.push_back(item["label"]);
    CHECK(std::count(labels.begin(), labels.end(), "angle") == 1);
    CHECK(std::count(labels.begin(), labels.end(), "interpret") == 1);
    labels.clear();
    for (const json& item : all[2]["result"]) labels.push_back(item["label"]);
    CHECK(std::count(labels.begin(), labels.end(), "square") == 1);
}

TEST_CASE("the server says what a keyword means, and what the system is") {
    const auto all = served({opened("axiom b\nb -> a\na -> ab\nangle 60\n"), request("hover", 3, 2),
                             request("hover", 1, 5)});
    REQUIRE(all.size() == 3);
    CHECK(all[1]["result"]["contents"]["value"].get<std::string>().starts_with("**angle**"));
    const std::string system = all[2]["result"]["contents"]["value"];
    CHECK(system.starts_with("**PD0L**"));
    CHECK(system.find("4  abaab") != std::string::npos);
}

TEST_CASE("a letter is renamed where it is a letter, and nowhere else") {
    const std::string text =
        "title a title\naxiom a(1)b  # a comment\na(x) : x < abs(3) -> b a(x+1)\nb -> [a(2)]\n"
        "interpret a(x) -> F(x)\n";
    const auto all = served({opened(text), request("rename", 1, 6, {{"newName", "Q"}}),
                             request("rename", 1, 6, {{"newName", "b"}}),
                             request("rename", 1, 6, {{"newName", "("}}),
                             request("rename", 0, 2, {{"newName", "Q"}})});
    REQUIRE(all.size() == 5);
    INFO(all[1].dump());
    CHECK(edited(text, all[1]["result"]["changes"]["file:///tmp/x.lsys"]) ==
          "title a title\naxiom Q(1)b  # a comment\nQ(x) : x < abs(3) -> b Q(x+1)\nb -> [Q(2)]\n"
          "interpret Q(x) -> F(x)\n");
    CHECK(all[2]["error"]["message"] == "'b' is another letter of the system");
    CHECK(all[3].contains("error"));
    CHECK(all[4]["error"]["message"] == "there is no letter here");
}

TEST_CASE("the server survives messages that are none") {
    const auto all = served({{{"id", 1}, {"method", "no/such"}},
                             {{"id", 2},
                              {"method", "textDocument/hover"},
                              {"params", {{"textDocument", {{"uri", "u"}}}}}},
                             {{"id", 3}, {"method", "textDocument/rename"}, {"params", 5}},
                             {{"id", 4}, {"method", "initialize"}}});
    REQUIRE(all.size() == 4);
    CHECK(all[0]["error"]["code"] == -32601);
    CHECK(all[1]["error"]["message"] == "the document is not open");
    CHECK(all[2].contains("error"));
    CHECK(all[3].contains("result"));
}

TEST_CASE("a letter is renamed in every statement of a line, and in words that are expected") {
    const auto renamed = [](const std::string& text, std::size_t line, std::size_t character) {
        const auto all =
            served({opened(text), request("rename", line, character, {{"newName", "c"}})});
        INFO(all.back().dump());
        REQUIRE(all.back().contains("result"));
        return edited(text, all.back()["result"]["changes"]["file:///tmp/x.lsys"]);
    };
    CHECK(renamed("axiom ab; a -> ba\nb -> a\n", 0, 6) == "axiom cb; c -> bc\nb -> c\n");
    CHECK(renamed("axiom a; a -> ab; b -> a\nexpect word 1: ab\n", 0, 6) ==
          "axiom c; c -> cb; b -> c\nexpect word 1: cb\n");
    CHECK(renamed("axiom a; a -> {a}\ncoding { a -> 0; b -> a }\nb -> b # a\n", 0, 6) ==
          "axiom c; c -> {c}\ncoding { c -> 0; b -> a }\nb -> b # a\n");
}

TEST_CASE("places beyond a document have nothing to say") {
    const auto all = served(
        {opened("axiom a\na -> ab\n"), request("hover", 99, 0), request("completion", 99, 3)});
    CHECK(all[1]["result"].is_null());
    const Scratch scratch;
    const Run failed = run("lsp <'" + scratch.file("in", "Content-Length: -5\r\n\r\n{}") + "'");
    CHECK(failed.err.find("expected `Content-Length: ` and a number of bytes, found "
                          "'Content-Length: -5'") != std::string::npos);
}

TEST_CASE("an error in the middle of words that are printed leaves whole JSON") {
    for (const char* arguments :
         {"derive 'axiom A(0); A(x) -> A(1/x)' -n 1 --json",
          "derive 'axiom A(1); A(x) -> A(x-1)B(1/x)' -n 0..3 --json",
          "derive 'axiom ab; a < b -> ab; a -> ab' -n 0..40 --max-memory 10M --json"}) {
        INFO(arguments);
        const Run failed = run(arguments);
        CHECK(failed.status != 0);
        const json whole = json::parse(failed.out);
        CHECK(whole["words"].is_array());
        CHECK(whole["error"]["message"].is_string());
    }
    const json error = error_of("derive 'axiom A(0); A(x) -> A(1/x)' -n 1 --json");
    CHECK(error["file"] == "typed system");
    CHECK(error["line"] == 1);
    CHECK(error["column"] == 13);
}

TEST_CASE("an error about bytes that are no text is JSON all the same") {
    const Scratch scratch;
    for (const char* name : {"j.lpy", "j.l", "j.lsys"}) {
        INFO(name);
        const std::string file = scratch.file(name,
                                              "c = \xff"
                                              "1\nLsystem: 1\nAxiom: A\nproduction:\nA --> B\n");
        CHECK(error_of("show '" + file + "' --json")["message"].is_string());
    }
}
