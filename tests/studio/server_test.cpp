#include <doctest/doctest.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <memory>
#include <random>
#include <set>
#include <thread>

#include "command/run.hpp"
#include "studio/served.hpp"

using nlohmann::json;
using served::Connection;
using served::Studio;

namespace {

const std::string koch = "axiom F\nF -> F+F--F+F\nangle 60\n";

json question(const std::string& name, const std::string& text, json more = json::object()) {
    more["question"] = name;
    more["text"] = text;
    return more;
}

/// A search that ends only when it is told to.
const json endless =
    question("check", "claim  Long\nshow for all 0L languages A: A A is 0L or A A is not 0L\n",
             {{"instances", 1'000'000'000'000}});

/// The processes of a group.
std::size_t processes_of(pid_t group) {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
        std::ifstream file(entry.path() / "stat");
        std::string line;
        if (!std::getline(file, line)) continue;
        std::istringstream rest(line.substr(line.rfind(')') + 1));
        std::string state;
        pid_t parent = 0, its_group = 0;
        rest >> state >> parent >> its_group;
        if (its_group == group && state != "Z") ++count;
    }
    return count;
}

/// Waits till something is so, for a minute at most: how long it takes is not what is tested.
template <class Condition>
bool comes(Condition condition) {
    for (int i = 0; i < 1200; ++i) {
        if (condition()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return false;
}

}  // namespace

TEST_CASE("the address has a token, and the page is served there alone") {
    const Studio studio;
    REQUIRE(studio.port > 0);
    CHECK(studio.address.starts_with("http://127.0.0.1:"));
    CHECK(studio.token.size() == 32);
    const auto page = studio.get("/" + studio.token + "/");
    CHECK(page.status == 200);
    CHECK(page.body.starts_with("<!DOCTYPE html>"));
    CHECK(page.head.find("default-src 'none'") != std::string::npos);
    CHECK(page.head.find("Referrer-Policy: no-referrer") != std::string::npos);
    CHECK(studio.get("/" + studio.token).status == 302);
    const Studio other;
    CHECK(other.token != studio.token);
}

TEST_CASE("a wrong token") {
    const Studio studio;
    std::string wrong = studio.token;
    wrong.back() = wrong.back() == '0' ? '1' : '0';
    for (const std::string& path :
         {std::string("/"), "/" + wrong + "/", "/" + wrong + "/ask", std::string("/ask"),
          "/" + studio.token.substr(1) + "/", std::string("//") + studio.token + "/"}) {
        INFO(path);
        const auto found = studio.get(path);
        CHECK(found.status == 403);
        CHECK(found.body.find("token") != std::string::npos);
    }
    const std::string body = question("start", "").dump();
    CHECK(studio
              .raw("POST /" + wrong + "/ask HTTP/1.1\r\nHost: " + studio.host +
                   "\r\nContent-Type: application/json\r\nContent-Length: " +
                   std::to_string(body.size()) + "\r\n\r\n" + body)
              .status == 403);
}

TEST_CASE("a page of another origin, and a name that was made to lead here") {
    const Studio studio;
    const std::string body = question("describe", koch).dump();
    CHECK(studio.post(body, "Origin: http://" + studio.host + "\r\n").status == 200);
    CHECK(studio.post(body, "Origin: http://evil.example\r\n").status == 403);
    CHECK(studio.post(body, "Origin: null\r\n").status == 403);
    CHECK(studio.post(body, "Sec-Fetch-Site: cross-site\r\n").status == 403);
    for (const std::string& host :
         {std::string("evil.example"), "evil.example:" + std::to_string(studio.port),
          "127.0.0.1.evil.example:" + std::to_string(studio.port), std::string("127.0.0.1:1")}) {
        INFO(host);
        CHECK(studio.raw("GET /" + studio.token + "/ HTTP/1.1\r\nHost: " + host + "\r\n\r\n")
                  .status == 403);
    }
    // What a form can send is not a question.
    CHECK(studio
              .raw("POST /" + studio.token + "/ask HTTP/1.1\r\nHost: " + studio.host +
                   "\r\nContent-Type: text/plain\r\nContent-Length: " +
                   std::to_string(body.size()) + "\r\n\r\n" + body)
              .status == 415);
}

TEST_CASE(
    "a studio for a lecture hall is asked by the machine's names and numbers, and by no others") {
    const Studio studio({"--host", "0.0.0.0", "--timeout", "1"});
    REQUIRE(studio.port > 0);
    const std::string port = ":" + std::to_string(studio.port);
    const auto status_at = [&](const std::string& host, const std::string& token) {
        return studio.raw("GET /" + token + "/ HTTP/1.1\r\nHost: " + host + "\r\n\r\n").status;
    };
    char name[256] = {};
    REQUIRE(::gethostname(name, sizeof name - 1) == 0);
    CHECK(studio.address == "http://" + std::string(name) + port + "/" + studio.token + "/");
    for (const std::string& host : {std::string(name), std::string("127.0.0.1"),
                                    std::string("192.0.2.7"), std::string("[fe80::1]")}) {
        INFO(host);
        CHECK(status_at(host + port, studio.token) == 200);
        CHECK(status_at(host + port, "0123456789abcdef0123456789abcdef") == 403);
    }
    // Names of letters that are digits too may be made to lead here like all others.
    for (const char* host : {"evil.example", "bad.cafe", "beef", "fe80::1", "1.2.3.4.cafe",
                             "[evil]", "[]", "", "127.0.0.1.evil.example"}) {
        INFO(host);
        CHECK(status_at(host + port, studio.token) == 403);
    }
    const std::string body = question("describe", koch).dump();
    CHECK(studio.post(body, "Origin: http://evil.example\r\n").status == 403);
    CHECK(studio.post(body, "Origin: http://" + studio.host + "\r\n").status == 200);
    // Nobody opens a file, and a question has its share of time only.
    CHECK(studio.ask({{"question", "open"}, {"from", "folder"}, {"file", "own.lsys"}})
              .head["status"] == 2);
    CHECK(studio.ask(endless).head["status"] == 3);
}

TEST_CASE("path traversal") {
    const Scratch scratch;
    std::filesystem::create_directories(scratch.path() / "mine/below");
    scratch.file("secret.lsys", "axiom s\n");
    scratch.file("mine/own.lsys", "axiom o\n");
    scratch.file("mine/below/deep.lsys", "axiom d\n");
    scratch.file("mine/notes.txt", "nothing for a page");
    scratch.file("mine/own.exercise",
                 "exercise One\ntask Write a.\nanswer word\nshow answer == {a}\n");
    scratch.file("secret.exercise",
                 "exercise Two\ntask Write b.\nanswer word\nshow answer == {b}\n");
    std::filesystem::create_symlink(scratch.path() / "secret.lsys",
                                    scratch.path() / "mine/link.lsys");
    const Studio studio({(scratch.path() / "mine").string()});
    for (const char* path : {"/../../../../etc/passwd", "/%2e%2e/%2e%2e/etc/passwd", "/..",
                             "/src/../ask", "/page.html", "/own.lsys"}) {
        INFO(path);
        const auto found = studio.get("/" + studio.token + path);
        CHECK((found.status == 404 || found.status == 403 || found.status == 400));
        CHECK(found.body.find("root:") == std::string::npos);
    }
    const auto open = [&](const std::string& file) {
        return studio.ask({{"question", "open"}, {"from", "folder"}, {"file", file}});
    };
    CHECK(open("own.lsys").json()["text"] == "axiom o\n");
    CHECK(open("own.exercise").json()["text"].get<std::string>().starts_with("exercise One"));
    CHECK(open("../secret.exercise").head["status"] == 2);
    const std::string secret = (scratch.path() / "secret.lsys").string();
    for (const std::string& file :
         {std::string("../secret.lsys"), secret, std::string("link.lsys"),
          std::string("below/deep.lsys"), std::string("./own.lsys"), std::string("notes.txt"),
          std::string(".."), std::string(""), std::string("own.lsys/"), std::string("/etc/passwd"),
          std::string("own.lsys\0", 9)}) {
        INFO(file);
        const auto found = open(file);
        CHECK(found.head["status"] == 2);
        CHECK(found.json().contains("error"));
        CHECK(found.text.find("axiom s") == std::string::npos);
    }
    // A claim reads systems of the folder, and none outside.
    const auto claim = [&](const std::string& file) {
        return studio.ask(
            question("check", "claim  Words\nlet G = D0L " + file + "\nshow s in L(G)\n"));
    };
    CHECK(claim("own.lsys").head["status"] == 1);
    for (const std::string& file :
         {std::string("../secret.lsys"), secret, std::string("link.lsys")}) {
        INFO(file);
        CHECK(claim(file).head["status"] == 2);
    }
    // Without a folder there is nothing to read but the gallery.
    const Studio bare;
    for (const std::string& file : {std::string("README.md"), std::string("own.lsys"), secret})
        CHECK(bare.ask({{"question", "open"}, {"from", "folder"}, {"file", file}}).head["status"] ==
              2);
    for (const std::string& file : {secret, (scratch.path() / "mine/own.lsys").string(),
                                    std::string("figures/000-trees-thesis/koch.lsys")})
        CHECK(
            bare.ask(question("check", "claim  Words\nlet G = D0L " + file + "\nshow s in L(G)\n"))
                .head["status"] == 2);
    CHECK(bare.ask(question("check", "claim  Words\nlet G = D0L fibonacci\nshow b in L(G)\n"))
              .head["status"] == 0);
    // Neither is the name of a system a way to a file.
    const auto named = studio.ask({{"question", "describe"}, {"name", "../secret.lsys"}});
    CHECK(named.head["status"] == 2);
    CHECK(named.text.find("a name from the gallery") != std::string::npos);
    const auto start = studio.ask({{"question", "start"}}).json();
    CHECK(std::set<std::string>(start["files"].begin(), start["files"].end()).contains("own.lsys"));
}

TEST_CASE("a worker writes no file") {
    const Scratch scratch;
    const Studio studio({scratch.path().string()});
    // A constant, a word and a format that look like options.
    for (const json& ask :
         {question("growth", koch, {{"let", {{"--plot", "x.svg"}}}}),
          question("picture", koch, {{"n", 2}, {"format", "svg -o x.svg"}}),
          question("member", koch, {{"word", "--certificate=x.json"}}),
          question("check", "claim  x\nshow a in {a}\n", {{"instances", "1 --certificate x"}})}) {
        INFO(ask.dump());
        const auto found = studio.ask(ask);
        CHECK(found.head["end"] == "answered");
        CHECK(found.head["status"] != 0);
    }
    CHECK(scratch.size() == 0);
}

TEST_CASE("a huge body") {
    const Studio studio;
    const std::string huge(3 << 20, 'F');
    const auto found = studio.post(question("describe", "axiom " + huge).dump());
    CHECK((found.status == 413 || found.status == 0));  // it may hang up before all is sent
    const Connection promises(studio.port);
    promises.send("POST /" + studio.token + "/ask HTTP/1.1\r\nHost: " + studio.host +
                  "\r\nContent-Type: application/json\r\nContent-Length: 99999999999999\r\n\r\n");
    CHECK(served::response_of(promises.receive()).status == 413);
    CHECK(studio.ask(question("describe", koch)).head["status"] == 0);
}

TEST_CASE("bad JSON, and questions that are none") {
    const Studio studio;
    const std::vector<std::string> bodies{
        "",
        "{",
        "null",
        "[]",
        "\"growth\"",
        "{\"question\": 7}",
        "{\"question\": \"groth\", \"text\": \"axiom a\"}",
        "{\"question\": \"growth\"}",
        "{\"question\": \"growth\", \"text\": 5}",
        "{\"question\": \"growth\", \"text\": \"\\u0000\"}",
        "{\"question\": \"figure\", \"text\": \"axiom F\", \"n\": -1}",
        "{\"question\": \"figure\", \"text\": \"axiom F\", \"n\": 1e400}",
        "{\"question\": \"figure\", \"text\": \"axiom F\", \"n\": 1, "
        "\"part\": [1, 2]}",
        "\xff\xfe{}",
        std::string(100'000, '['),
        "{\"question\": \"growth\", \"text\": \"\xc3\x28\"}"};
    for (const std::string& body : bodies) {
        INFO(body.substr(0, 100));
        const auto found = studio.post(body);
        CHECK(found.status == 200);
        const auto answer = served::answer_of(found.body);
        CHECK(answer.head["end"] == "answered");
        CHECK(answer.head["status"] == 2);
        CHECK(answer.json()["error"]["message"].is_string());
    }
    const auto near = studio.ask({{"question", "groth"}, {"text", "axiom a"}});
    CHECK(near.text.find("did you mean 'growth'") != std::string::npos);
}

TEST_CASE("a slow client holds nobody up") {
    const Studio studio({"--at-once", "1"});
    std::vector<std::unique_ptr<Connection>> slow;
    for (int i = 0; i < 60; ++i) {
        slow.push_back(std::make_unique<Connection>(studio.port));
        slow.back()->send(i % 2 ? "G"
                                : "POST /" + studio.token + "/ask HTTP/1.1\r\nHost: " +
                                      studio.host + "\r\nContent-Length: 1000\r\n\r\n{");
    }
    CHECK(studio.ask(question("describe", koch)).head["status"] == 0);
    CHECK(studio.get("/" + studio.token + "/").status == 200);
    // They are let go.
    CHECK(slow.front()->receive().size() < 1000);
}

TEST_CASE("a cancelled request ends its work") {
    const Studio studio({"--timeout", "600", "--at-once", "1"});
    REQUIRE(comes([&] { return processes_of(studio.process()) == 2; }));  // the server, the maker
    {
        const Connection asks(studio.port);
        asks.send(studio.request(endless.dump()));
        REQUIRE(comes([&] { return processes_of(studio.process()) == 3; }));
        CHECK(asks.receive(1000).find("answered") == std::string::npos);
    }
    CHECK(comes([&] { return processes_of(studio.process()) == 2; }));
    CHECK(studio.ask(question("describe", koch)).head["status"] == 0);
}

TEST_CASE("a question takes no more than its share of time and memory") {
    const Studio studio({"--timeout", "2", "--max-memory", "128M"});
    const auto late = studio.ask(question(
        "dimension", "axiom F\nF -> F[+F]F[-F]F\nangle 25.7\nstart 0 0 90\n", {{"n", 40}}));
    CHECK((late.head["status"] == 3 || late.head["end"] == "time"));
    const auto large =
        studio.ask(question("derivation", "axiom aaaaaaaa\na -> aaaaaaaaaaaaaaaa\n", {{"n", 60}}));
    CHECK(large.head["status"] == 0);  // it stops before a word that is too long, and says so
    CHECK(large.json()["full"] == true);
    const auto burst = studio.ask(
        question("picture", "axiom F\nF -> F+F+F\nangle 7.1\n", {{"n", 40}, {"format", "csv"}}));
    CHECK(burst.head["status"] != 0);
    CHECK(studio.is_running());
    CHECK(studio.ask(question("describe", koch)).head["status"] == 0);
}

TEST_CASE("Ctrl-C stops at once, with work going on and clients that say nothing") {
    for (const int signal : {SIGINT, SIGTERM}) {
        Studio studio({"--timeout", "600"});
        const Connection asks(studio.port), silent(studio.port);
        asks.send(studio.request(endless.dump()));
        silent.send("GET /");
        const pid_t group = studio.process();
        REQUIRE(comes([&] { return processes_of(group) > 2; }));
        CHECK(studio.end(signal) == 0);
        CHECK(comes([&] { return processes_of(group) == 0; }));
    }
    // Killed, it leaves no process behind either.
    Studio studio({"--timeout", "600"});
    const pid_t group = studio.process();
    const Connection asks(studio.port);
    asks.send(studio.request(endless.dump()));
    REQUIRE(comes([&] { return processes_of(group) == 3; }));
    CHECK(studio.end(SIGKILL) == 128 + SIGKILL);
    CHECK(comes([&] { return processes_of(group) == 0; }));
}

TEST_CASE("malformed requests neither end the server nor leave processes") {
    const Studio studio;
    std::mt19937_64 chance(2026);
    std::size_t sent = 0, answered = 0;
    const std::string fine = studio.request(question("describe", koch).dump());
    for (int i = 0; i < 200; ++i) {
        std::string bytes = fine;
        const std::size_t changes = 1 + chance() % 8;
        for (std::size_t k = 0; k < changes; ++k) {
            if (bytes.empty()) break;
            const std::size_t at = chance() % bytes.size();
            switch (chance() % 4) {
                case 0:
                    bytes[at] = static_cast<char>(chance());
                    break;
                case 1:
                    bytes.erase(at, chance() % 20);
                    break;
                case 2:
                    bytes.insert(at, 1 + chance() % 300, static_cast<char>(chance()));
                    break;
                default:
                    bytes.resize(at + 1);
            }
        }
        const Connection connection(studio.port);
        connection.send(bytes);
        ++sent;
        if (i % 10 == 0 && !connection.receive(200).empty()) ++answered;
    }
    CHECK(sent == 200);
    CHECK(answered > 0);
    CHECK(studio.is_running());
    CHECK(studio.ask(question("describe", koch)).head["status"] == 0);
    CHECK(comes([&] { return processes_of(studio.process()) == 2; }));
}

TEST_CASE("many at the same time are all answered, each with its own answer") {
    const Studio studio;
    std::vector<std::thread> askers;
    std::atomic<int> right = 0;
    for (int i = 0; i < 40; ++i)
        askers.emplace_back([&, i] {
            const std::string name = "a" + std::to_string(i);
            const auto found = studio.ask(question("describe", "title " + name + "\naxiom F\n"));
            if (found.json()["title"] == name) ++right;
        });
    for (std::thread& asker : askers) asker.join();
    CHECK(right == 40);
}

TEST_CASE("addresses that are not this machine's, ports and tokens that are none") {
    const Run wrong = run("studio --host 203.0.113.7");
    CHECK(wrong.status == 2);
    CHECK(wrong.err.find("cannot listen on 203.0.113.7") != std::string::npos);
    CHECK(run("studio --port 70000").err.find("--port: expected a port from 0 to 65535") !=
          std::string::npos);
    CHECK(run("studio --token secret").err.find("at least 16 letters or digits") !=
          std::string::npos);
    CHECK(run("studio no-such-folder").err.find("cannot read the folder no-such-folder") !=
          std::string::npos);
    const Studio first;
    const Run taken = run("studio --port " + std::to_string(first.port));
    CHECK(taken.status == 2);
    CHECK(taken.err.find("the port is in use") != std::string::npos);
}
