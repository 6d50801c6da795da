// No file of the user's is written over unasked, none is left half-written, and what cannot be written is said.

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "command/run.hpp"
#include "places.hpp"

namespace {

const std::string koch = "axiom F\nF -> F+F--F+F\nangle 60\ngeneration 2\n";

/// A run that must not change the file.
void keeps(const std::string& arguments, const std::string& path) {
    INFO(arguments);
    const std::string before = text_of(path);
    const Run refused = run(arguments);
    CHECK(refused.status == 2);
    CHECK(refused.err ==
          "algae: cannot write " + path + ": it was read as input; expected another name\n");
    CHECK(text_of(path) == before);
}

}  // namespace

TEST_CASE("an output onto an input is an error, by whatever name") {
    const Scratch files;
    const std::string system = files.file("k.lsys", koch);
    const std::string claim = files.file("u.claim", "claim x\nshow {a} is 0L\n");
    const std::string picture = files.file("k.png");
    REQUIRE(run("draw '" + system + "' -o '" + picture + "'").status == 0);
    keeps("draw '" + system + "' -o '" + system + "' --format svg", system);
    keeps("check '" + claim + "' --certificate '" + claim + "'", claim);
    keeps("dimension '" + picture + "' --plot '" + picture + "'", picture);
    keeps("tree '" + system + "' -n 1 -o '" + system + "' --format dot", system);
    // A link is the file that it leads to.
    const std::string link = files.file("link.lsys"), twin = files.file("twin.lsys");
    std::filesystem::create_symlink(system, link);
    std::filesystem::create_hard_link(system, twin);
    keeps("draw '" + link + "' -o '" + system + "' --format svg", system);
    keeps("draw '" + system + "' -o '" + link + "' --format svg", link);
    keeps("draw '" + system + "' -o '" + twin + "' --format svg", twin);
    // What is asked for is done.
    const std::string untidy = files.file("untidy.lsys", "axiom   a\na->ab\n");
    CHECK(run("fmt --in-place '" + untidy + "'").status == 0);
    CHECK(text_of(untidy) == "axiom a\na -> ab\n");
}

TEST_CASE("--no-clobber replaces no file that is there") {
    const Scratch files;
    const std::string there = files.file("there.svg", "mine");
    const Run refused = run("draw koch -n 1 --no-clobber -o '" + there + "'");
    CHECK(refused.status == 2);
    CHECK(refused.err == "algae: cannot write " + there +
                             ": it is there already, and files that are there are kept\n");
    CHECK(text_of(there) == "mine");
    CHECK(run("draw koch -n 1 --no-clobber -o '" + files.file("new.svg") + "'").status == 0);
    CHECK(run("draw koch -n 1 -o '" + there + "'").status == 0);
    CHECK(text_of(there) != "mine");
    for (const std::string verb :
         {"figures", "growth", "tree", "check", "is", "lesson", "dimension"})
        CHECK(run(verb + " --help").out.find("--no-clobber") != std::string::npos);
}

TEST_CASE("the files of a lesson leave an answer that was written in them") {
    const Scratch files;
    const std::string out = files.path().string();
    REQUIRE(run("lesson 1 --out '" + out + "'").status == 0);
    const std::size_t count = files.size();
    REQUIRE(count > 0);
    std::vector<std::filesystem::path> written;
    for (const auto& entry : std::filesystem::directory_iterator(files.path()))
        written.push_back(entry.path());
    // The same files again: nothing is new.
    const Run again = run("lesson 1 --out '" + out + "'");
    CHECK(again.status == 0);
    CHECK(again.err.empty());
    CHECK(files.size() == count);
    const std::string answer = written.front().string();
    std::ofstream(answer) << "my answer";
    const Run beside = run("lesson 1 --out '" + out + "'");
    CHECK(beside.status == 0);
    CHECK(beside.err == "algae: note: " + answer +
                            " was changed and stays; the file of the lesson is " + answer +
                            ".new\n");
    CHECK(text_of(answer) == "my answer");
    CHECK(files.size() == count + 1);
}

TEST_CASE(
    "feedback that is there is kept with --no-clobber, and else it is said that it is replaced") {
    const Scratch files;
    const std::string answers = files.file("answers"), feedback = files.file("feedback");
    std::filesystem::create_directory(answers);
    std::filesystem::create_directory(feedback);
    files.file("answers/anna.lsys", "axiom a\na -> ab\nb -> a\n");
    const std::string mine = files.file("feedback/anna.lsys.txt", "what the teacher wrote");
    const std::string mark =
        "lesson 1 --exercise 1 '" + answers + "' --feedback '" + feedback + "'";
    const Run refused = run(mark + " --no-clobber");
    CHECK(refused.status == 2);
    CHECK(refused.out.empty());
    CHECK(refused.err == "algae: cannot write " + mine +
                             ": it is there already, and files that are there are kept\n");
    CHECK(text_of(mine) == "what the teacher wrote");
    CHECK(files.size() == 2);
    const Run replaced = run(mark);
    CHECK(replaced.status == 0);
    CHECK(replaced.err == "algae: note: 1 file in " + feedback +
                              " had another text and is replaced; --no-clobber keeps what is "
                              "there\n");
    CHECK(text_of(mine).find("exercise 1.1") != std::string::npos);
    CHECK(run(mark).err.empty());  // the same again
}

TEST_CASE("a claim reads no system outside its folder") {
    const Scratch files, others;
    const std::string secret = others.file("secret.lsys", "axiom a\na -> ab\nb -> a\n");
    files.file("near.lsys", "axiom a\na -> ab\nb -> a\n");
    std::filesystem::create_directory(files.path() / "below");
    files.file("below/deep.lsys", "axiom a\na -> ab\nb -> a\n");
    std::filesystem::create_symlink(secret, files.path() / "link.lsys");
    const auto check = [&](const std::string& name, const std::string& option = "") {
        const std::string claim =
            files.file("x.claim", "claim x\nlet G = D0L " + name + "\nshow aba in L(G)\n");
        return run("check " + option + " '" + claim + "'");
    };
    for (const std::string name : {"near.lsys", "below/deep.lsys", "fibonacci"}) {
        INFO(name);
        CHECK(check(name).status == 0);
    }
    const std::string up = "../" + others.path().filename().string() + "/secret.lsys";
    for (const std::string& name : {secret, up, std::string("link.lsys")}) {
        INFO(name);
        const Run refused = check(name);
        CHECK(refused.status == 2);
        CHECK(refused.err.find(name + ": is outside the folder of the text that names it") !=
              std::string::npos);
        CHECK(check(name, "--allow-outside").status == 0);
    }
}

TEST_CASE("a claim reads no file of a cpfg model outside its folder, wherever links lead") {
    const Scratch files, others;
    const std::string system =
        "Lsystem: 1\nderivation length: 3\nAxiom: a\na --> ab\nb --> a\nendlsystem\n";
    const std::string view = "angle factor: 6\n", animation = "first frame: 0\nlast frame: 3\n";
    others.file("plant.l", system);
    others.file("plant.v", view);
    others.file("plant.a", animation);
    others.file("specifications", "cpfg plant.l\n");
    others.file(
        "many.l",
        "Many {\n  Angle 4\n  Axiom F\n  F=FF\n}\nOther {\n  Angle 4\n  Axiom F\n  F=F+F\n}\n");
    const auto check = [&](const std::string& name, const std::string& option = "") {
        const std::string claim =
            files.file("x.claim", "claim x\nlet G = D0L " + name + "\nshow L(G) == L(G)\n");
        return run("check " + option + " '" + claim + "'");
    };
    // Each file of the model is a link in turn, first to one beside it, then to one of the others.
    struct Case {
        std::string named, link;
    };
    for (const auto& [named, link] :
         {Case{"plant.l", "plant.v"}, Case{"plant.l", "plant.l"}, Case{"plant.v", "plant.l"},
          Case{"plant.v", "plant.v"}, Case{"plant.a", "plant.l"}, Case{"plant.a", "plant.v"},
          Case{"plant.a", "plant.a"}, Case{"specifications", "plant.l"},
          Case{"specifications", "plant.v"}, Case{"specifications", "plant.a"},
          Case{"specifications", "specifications"}}) {
        INFO(named << " with the link " << link);
        files.file("plant.l", system);
        files.file("plant.v", view);
        files.file("plant.a", animation);
        files.file("specifications", "cpfg plant.l plant.v plant.a\n");
        std::filesystem::rename(files.file(link), files.file("moved"));
        std::filesystem::create_symlink(files.file("moved"), files.file(link));
        const Run inside = check(named);
        INFO(inside.err);
        CHECK(inside.status == 0);
        std::filesystem::remove(files.file(link));
        std::filesystem::create_symlink(others.file(link), files.file(link));
        const Run refused = check(named);
        INFO(refused.err);
        CHECK(refused.status == 2);
        CHECK(refused.err.find("is outside the folder of the text that names it; expected a file "
                               "in it or below") != std::string::npos);
        CHECK(refused.err.find(link) != std::string::npos);
        CHECK(check(named, "--allow-outside").status == 0);
        std::filesystem::remove(files.file(link));
        std::filesystem::remove(files.file("moved"));
    }
    // One of the systems in a file of Fractint.
    const std::string entry = others.file("many.l") + ":Other";
    CHECK(check(entry, "--allow-outside").status == 0);
    const Run refused = check(entry);
    CHECK(refused.status == 2);
    CHECK(refused.err.find(entry + ": is outside the folder") != std::string::npos);
    std::filesystem::copy_file(others.file("many.l"), files.file("many.l"));
    CHECK(check("many.l:Other").status == 0);
}

TEST_CASE("help that cannot be written fails") {
    if (!std::filesystem::exists("/dev/full")) return;
    for (const std::string arguments : {"--help", "draw --help", "--version"}) {
        const int ended = std::system(
            ("'" + built_command() + "' " + arguments + " >/dev/full 2>/dev/null").c_str());
        CHECK(WEXITSTATUS(ended) == 2);
    }
}

TEST_CASE("two stops leave no unfinished file") {
    const Scratch files;
    const std::string out = files.file("far.gif");
    // The second stop ends the program at once, wherever it is.
    const std::string command = "'" + built_command() +
                                "' draw koch -n 8 --progressive --max-frames 10000 -o '" + out +
                                "' >/dev/null 2>&1 & p=$!; sleep 1; kill -HUP $p; sleep 0.7; "
                                "kill -HUP $p; wait $p; exit $?";
    const int ended = std::system(command.c_str());
    CHECK((WEXITSTATUS(ended) == 130 || WEXITSTATUS(ended) == 0));
    CHECK(files.size() == (WEXITSTATUS(ended) == 0 ? 1 : 0));
}

TEST_CASE("a file that may not grow is an error of writing, and leaves nothing") {
    const Scratch scratch;
    const std::string before = scratch.file("k.svg", "before");
    const Run full = run("draw dragon -n 16 -o '" + before + "'", "ulimit -f 100;");
    CHECK(full.status == 2);
    CHECK(full.err.find("File too large") != std::string::npos);
    CHECK(text_of(before) == "before");
    CHECK(scratch.size() == 1);
}
