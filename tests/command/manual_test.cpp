#include <doctest/doctest.h>

#include <map>
#include <regex>
#include <set>

#include "command/run.hpp"

namespace {

/// What `--help` says: verbs with the names of their options, but for --help itself.
std::map<std::string, std::set<std::string>> options_of_verbs() {
    std::map<std::string, std::set<std::string>> found;
    std::istringstream lines(run("--help").out);
    bool verbs = false;
    for (std::string line; std::getline(lines, line);) {
        std::smatch part;
        if (line == "Subcommands:")
            verbs = true;
        else if (line.empty())
            verbs = false;
        else if (verbs && std::regex_search(line, part, std::regex("^  ([a-z]+)")))
            found[part[1]];
    }
    for (auto& [verb, options] : found) {
        std::istringstream help(run(verb + " --help").out);
        for (std::string line; std::getline(help, line);) {
            std::smatch part;
            if (!std::regex_search(line, part, std::regex("^  (-[^ ]+)"))) continue;
            std::istringstream names(part[1]);
            for (std::string name; std::getline(names, name, ',');) options.insert(name);
        }
        options.erase("-h");
        options.erase("--help");
    }
    return found;
}

std::string written(const std::string& kind) {
    const Run made = run("manual --" + kind);
    CHECK(made.status == 0);
    CHECK(made.err.empty());
    return made.out;
}

/// The part of a text from the one to the next; empty if there is none.
std::string between(const std::string& text, const std::string& from, const std::string& to) {
    const std::size_t begin = text.find(from);
    if (begin == std::string::npos) return "";
    return text.substr(begin, text.find(to, begin + from.size()) - begin);
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
        text.replace(at, what.size(), by);
    return text;
}

bool has_word(const std::string& text, const std::string& word) {
    return std::regex_search(text, std::regex("(^|[^a-z-])" + word + "([^a-z-]|$)"));
}

bool has_program(const std::string& name) {
    return std::system(("command -v " + name + " >/dev/null 2>&1").c_str()) == 0;
}

/// What bash offers for the last of these words, a line each.
std::string offered(const std::vector<std::string>& words) {
    const Scratch scratch;
    const std::string script = scratch.file("algae", written("bash"));
    scratch.file("my garden.lsys", "");
    std::filesystem::create_directory(scratch.path() / "beds");
    std::string line = "cd '" + scratch.path().string() + "' && source ./algae && COMP_WORDS=(";
    for (const std::string& word : words) line += " '" + word + "'";
    line += ") COMP_CWORD=" + std::to_string(words.size() - 1) +
            " && _algae && [[ ${#COMPREPLY[@]} == 0 ]] || printf \"%s\\n\" \"${COMPREPLY[@]}\"";
    scratch.file("ask", line);
    const std::string out = scratch.file("out");
    CHECK(std::system(("bash '" + scratch.file("ask") + "' >'" + out + "' 2>&1").c_str()) == 0);
    return text_of(out);
}

}  // namespace

TEST_CASE("the manual page and the completions have every verb and option of --help") {
    const auto verbs = options_of_verbs();
    REQUIRE(verbs.size() > 20);
    REQUIRE(verbs.at("draw").contains("--common-scale"));
    CHECK(!verbs.contains("manual"));
    const std::string page = replaced(written("man"), "\\-", "-");
    const std::string bash = written("bash"), zsh = written("zsh"), fish = written("fish");
    const std::string bounds = between(page, ".SH BOUNDS", ".SH EXIT");
    for (const auto& [verb, options] : verbs) {
        CAPTURE(verb);
        const std::string section = between(page, ".SS " + verb + '\n', "\n.S");
        const std::string bash_case = between(bash, "\n    " + verb + ")\n", "\n        ;;\n");
        const std::string zsh_case = between(zsh, "\n    " + verb + ")\n", "\n      ;;\n");
        CHECK(section.find("algae " + verb) != std::string::npos);
        CHECK(!bash_case.empty());
        CHECK(has_word(between(bash, "\n    '')\n", ";;"), verb));
        CHECK(zsh.find("\n      '" + verb + ":") != std::string::npos);
        CHECK(fish.find("__algae_verb -a " + verb + " -d") != std::string::npos);
        for (const std::string& option : options) {
            CAPTURE(option);
            CHECK((has_word(section, option + "\\\\fR") || has_word(bounds, option + "\\\\fR")));
            CHECK(has_word(bash_case, option));
            CHECK(has_word(zsh_case, option));
            const std::string said =
                option.starts_with("--") ? "-l " + option.substr(2) : "-s " + option.substr(1);
            CHECK(std::regex_search(fish,
                                    std::regex("'__algae_verb " + verb + "' [^']*" + said + " ")));
        }
    }
    CHECK(run("manual").status == 2);
    CHECK(run("manual --man --zsh").status == 2);
}

TEST_CASE("the programs that read them find no fault, where they are installed") {
    const Scratch scratch;
    const std::string page = scratch.file("algae.1", written("man"));
    const std::string bash = scratch.file("algae", written("bash")),
                      zsh = scratch.file("_algae", written("zsh"));
    const std::string fish = scratch.file("algae.fish", written("fish")),
                      said = scratch.file("said");
    const auto silent = [&](const std::string& program, const std::string& command) {
        if (!has_program(program)) return;
        CAPTURE(command);
        CHECK(std::system((command + " >'" + said + "' 2>&1").c_str()) == 0);
        CHECK(text_of(said) == "");
    };
    silent("groff", "groff -man -ww -Tutf8 -z '" + page + "'");
    silent("bash", "bash -n '" + bash + "'");
    silent("zsh", "zsh -n '" + zsh + "'");
    silent("fish", "fish --no-execute '" + fish + "'");
}

TEST_CASE("bash completes verbs, options, their values, names of the gallery and files") {
    if (!has_program("bash")) return;
    CHECK(offered({"algae", "dr"}) == "draw\n");
    CHECK(offered({"algae", "draw", "--common"}) == "--common-scale\n");
    CHECK(offered({"algae", "draw", "mandel"}) == "mandelbrot-tree\n");
    CHECK(offered({"algae", "draw", "my"}) == "my garden.lsys\n");
    CHECK(offered({"algae", "draw", "koch", "--format", "g"}) == "gif\ngeojson\nglb\n");
    CHECK(offered({"algae", "draw", "koch", "--format", "=", "g"}) == "gif\ngeojson\nglb\n");
    CHECK(offered({"algae", "draw", "koch", "-o", "my"}) == "my garden.lsys\n");
    CHECK(offered({"algae", "equal", "--as", ""}) == "language\nsequence\ngrowth\n");
    CHECK(offered({"algae", "equal", "--as", "growth", "mandel"}) == "mandelbrot-tree\n");
    CHECK(offered({"algae", "equal", "fibonacci", "anab"}) == "anabaena\n");
    CHECK(offered({"algae", "closure", "0L", "intersection w"}) ==
          "intersection\\ with\\ regular\n");
    CHECK(offered({"algae", "ifs", "fer"}) == "fern\n");
    CHECK(offered({"algae", "figures", "b"}) == "beds\n");
    CHECK(offered({"algae", "lesson", "3", "--exercise", "2", "my"}) == "my garden.lsys\n");
    CHECK(offered({"algae", "member", "fibonacci", "ab"}) == "");
    CHECK(offered({"algae", "letter", "koch", "-n", "3", "--at", "4", "--co"}) == "--count\n");
}

TEST_CASE("fish completes them as well, where it is installed") {
    if (!has_program("fish")) return;
    const Scratch scratch;
    const std::string script = scratch.file("algae.fish", written("fish")),
                      out = scratch.file("out");
    const auto offers = [&](const std::string& line) {
        const std::string asked =
            scratch.file("ask", "source '" + script + "'; complete -C '" + line + "'\n");
        CHECK(std::system(("cd '" + scratch.path().string() + "' && HOME=. fish --no-config '" +
                           asked + "' >'" + out + "' 2>&1")
                              .c_str()) == 0);
        return std::regex_replace(text_of(out), std::regex("\t[^\n]*"), "");
    };
    CHECK(offers("algae dr") == "draw\n");
    CHECK(offers("algae draw mandel") == "mandelbrot-tree\n");
    CHECK(offers("algae draw koch --format g") == "gif\ngeojson\nglb\n");
    CHECK(offers("algae equal --as ") == "growth\nlanguage\nsequence\n");
}
