#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "command/run.hpp"
#include "places.hpp"

using nlohmann::json;

TEST_CASE("census counts systems and languages up to renaming") {
    // Counts of two programs that share nothing with this one.
    const auto column = [](const std::string& of, const std::string& by, const std::string& name) {
        const Run found =
            run("census '" + of + "' --format json" + (by.empty() ? "" : " --by " + by));
        CHECK(found.status == 0);
        std::vector<int> counts;
        const json census = json::parse(found.out);
        for (const json& row : census["rows"])
            counts.push_back(name.empty() ? row["all"].get<int>() : row[name]["proved"].get<int>());
        return counts;
    };
    CHECK(column("D0L systems up to size 12", "", "") ==
          std::vector<int>{0, 1, 2, 5, 17, 64, 256, 1109, 5206, 26133, 138858, 777449});
    CHECK(column("PD0L systems up to size 9", "", "") ==
          std::vector<int>{0, 0, 1, 2, 5, 20, 82, 334, 1463});
    CHECK(column("0L systems up to size 7", "finite", "finite") ==
          std::vector<int>{0, 1, 2, 5, 17, 61, 231});
    CHECK(column("D0L systems up to size 7", "finite", "finite") ==
          std::vector<int>{0, 1, 2, 4, 15, 47, 169});
    CHECK(column("0L systems up to size 6", "finite", "") == std::vector<int>{0, 1, 2, 6, 20, 81});
    CHECK(column("P0L systems up to size 7", "finite", "") ==
          std::vector<int>{0, 0, 1, 2, 5, 21, 87});
}

TEST_CASE("every D0L system has one class of growth") {
    const Run found = run("census 'D0L systems up to size 7' --by growth --format json");
    const json census = json::parse(found.out);
    for (const json& row : census["rows"])
        CHECK(row["zero"]["proved"].get<int>() + row["bounded"]["proved"].get<int>() +
                  row["polynomial"]["proved"].get<int>() +
                  row["exponential"]["proved"].get<int>() ==
              row["all"].get<int>());
}

TEST_CASE("census prints a table, CSV and a b-file, the same for every number of threads") {
    const std::string asked = "census 'finite languages up to size 5' --by 0L,D0L --first 2";
    const Run table = run(asked);
    CHECK(table.status == 0);
    CHECK(table.out ==
          "size  all  0L  D0L\n"
          "   1    1   0    0\n"
          "   2    1   1    1\n"
          "   3    3   3    3\n"
          "   4    8   8    8\n"
          "   5   26  25   25\n"
          "first 0L: a   ε,a\n"
          "first D0L: a   ε,a\n");
    CHECK(run(asked + " --threads 1").out == table.out);
    CHECK(run(asked + " --threads 3").out == table.out);
    CHECK(run("census 'finite languages up to size 3' --by 0L --format csv").out ==
          "size,all,0L,0L undecided\n"
          "1,1,0,0\n"
          "2,1,1,0\n"
          "3,3,3,0\n");
    CHECK(run("census 'D0L systems up to size 5' --format bfile").out ==
          "# D0L systems up to size 5, by size\n"
          "1 0\n"
          "2 1\n"
          "3 2\n"
          "4 5\n"
          "5 17\n");
    CHECK(run("census 'D0L systems up to size 5' --by 'L(X) is infinite' --format bfile").out ==
          "# D0L systems up to size 5, by size; L(X) is infinite\n1 0\n2 0\n3 0\n4 1\n5 2\n");
}

TEST_CASE("census says what is wrong with the question") {
    const auto refused = [](const std::string& arguments, const std::string& message) {
        const Run found = run("census " + arguments);
        CHECK(found.status == 2);
        CHECK(found.out.empty());
        CHECK(found.err.find(message) != std::string::npos);
    };
    refused("'D0L systems'", "expected a bound of the census, such as 'up to size 8'");
    refused("'DOL systems up to size 3'", "found 'DOL'; did you mean 'D0L', with a zero?");
    refused("'D0L systems up to size 3' --by 0LX", "0LX");
    refused("'D0L systems up to size 3' --by finite,growth --format bfile",
            "--format bfile: expected at most one property behind --by, found 5");
}

namespace {

const std::string asked =
    "census '0L systems up to size 7' --by finite,0L --first 2 --chunk-size 10 ";

std::size_t lines_of(const std::string& path) {
    const std::string text = text_of(path);
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace

TEST_CASE("a census that is killed again and again comes to the same bytes") {
    const Scratch folder;
    const std::string whole = run(asked).out, file = folder.file("c.jsonl");
    REQUIRE(run(asked + "--checkpoint " + file).out == whole);
    const std::string written = text_of(file);
    REQUIRE(lines_of(file) > 30);
    // Whatever of the file a killed process leaves: whole lines, and the torn last one.
    std::size_t cuts = 0;
    for (std::size_t size = 0; size < written.size(); size += 1 + written.size() / 23) {
        const std::string torn = folder.file("torn.jsonl", written.substr(0, size));
        const Run found = run(asked + "--threads 1 --resume " + torn);
        CAPTURE(size);
        CHECK(found.status == 0);
        CHECK(found.out == whole);
        CHECK(text_of(torn) == written);
        ++cuts;
    }
    CHECK(cuts > 20);
    // And processes that are killed.
    const std::string question =
        "census '0L systems up to size 9' --by finite,0L --first 2 --chunk-size 100 ";
    const std::string uninterrupted = folder.file("u.jsonl"), killed = folder.file("k.jsonl");
    const std::string all = run(question + "--checkpoint " + uninterrupted).out;
    std::size_t kills = 0;
    Run last;
    for (double seconds = 0.04; seconds < 1000; seconds *= 1.25) {
        const bool begun = std::filesystem::exists(killed);
        last = run(question + (begun ? "--resume " : "--checkpoint ") + killed,
                   "timeout -s KILL " + std::to_string(seconds));
        if (last.status == 0) break;
        ++kills;
    }
    CHECK(kills > 0);
    CHECK(last.out == all);
    CHECK(text_of(killed) == text_of(uninterrupted));
    MESSAGE("killed ", kills, " times");
}

TEST_CASE("chunks taken apart are one census when their files are put together") {
    const Scratch folder;
    const std::string whole = run(asked).out;
    std::string together;
    for (const char* chunks : {"20..100000", "0..7", "8..19"}) {
        const std::string file = folder.file(std::string(chunks) + ".jsonl");
        const Run part = run(asked + "--threads 2 --chunks " + chunks + " --checkpoint " + file);
        CHECK(part.status == 0);
        CHECK(part.out.empty());
        CHECK(part.err ==
              "algae: note: a part of the census is in " + file + "; --resume takes the rest\n");
        together += text_of(file);
    }
    const std::string file = folder.file("all.jsonl", together);
    CHECK(run(asked + "--resume " + file).out == whole);
    CHECK(text_of(file) == together);
}

TEST_CASE("Ctrl-C and SIGTERM finish the chunk, write it and end with 130") {
    const Scratch folder;
    for (const char* signal : {"INT", "TERM"}) {
        const std::string file = folder.file(std::string(signal) + ".jsonl");
        const std::string question =
            "census '0L systems up to size 11' --by finite,D0L,T0L --chunk-size 20 ";
        const Run stopped =
            run(question + "--checkpoint " + file, std::string("timeout -s ") + signal + " 1");
        // `timeout` says 124 if it sent the signal.
        CHECK(stopped.status == 124);
        CHECK(stopped.err == "algae: interrupted\n");
        CHECK(stopped.out.empty());
        const std::string text = text_of(file);
        CHECK(text.ends_with("}\n"));
        const std::size_t before = lines_of(file);
        CHECK(run(question + "--checkpoint " + file).err == "algae: --checkpoint: " + file +
                                                                " is there already; --resume " +
                                                                file + " goes on from it\n");
        run(question + "--resume " + file, "timeout -s TERM 1");
        CHECK(text_of(file).starts_with(text));
        CHECK(lines_of(file) >= before);
    }
    // The status is the command's own where nobody stands between.
    const std::string file = folder.file("status.jsonl");
    const Run direct =
        run("census '0L systems up to size 10' --by finite,D0L --checkpoint " + file + " 2>'" +
                folder.file("err") + "' & p=$!; sleep 1; kill -TERM $p; wait $p; exit $?; true",
            "");
    CHECK(direct.status == 130);
}

TEST_CASE("two signals at once stop the work as one does, and later ones end it") {
    const Scratch folder;
    const auto stopped_by = [&](const std::string& signals) {
        std::filesystem::remove(folder.file("c"));
        std::filesystem::remove(folder.file("err"));
        run("census '0L systems up to size 11' --by finite,D0L --chunk-size 20 --checkpoint " +
            folder.file("c") + " 2>'" + folder.file("err") + "' & p=$!; sleep 0.7; " + signals +
            "; wait $p; exit $?; true");
        return text_of(folder.file("err"));
    };
    for (int i = 0; i < 3; ++i)
        CHECK(stopped_by("kill -TERM $p; kill -INT $p; kill -TERM $p") == "algae: interrupted\n");
    // A chunk that takes long goes on until someone insists.
    const Run insisting =
        run("census '0L systems up to size 11' --by finite,D0L --chunk-size 100000000 & p=$!; "
            "sleep 0.7; kill -TERM $p; sleep 0.8; kill -TERM $p; wait $p; exit $?; true");
    CHECK(insisting.status == 130);
}

TEST_CASE("a checkpoint of another census is refused") {
    const Scratch folder;
    const std::string file = folder.file("c.jsonl");
    run("census 'D0L systems up to size 5' --by finite --checkpoint " + file);
    const auto refused = [&](const std::string& arguments, const std::string& message) {
        const Run found = run("census " + arguments);
        CHECK(found.status == 2);
        CHECK(found.out.empty());
        CHECK(found.err.find(message) != std::string::npos);
    };
    const std::string other = "c.jsonl:1: the checkpoint is of another question; expected ";
    refused("'D0L systems up to size 6' --by finite --resume " + file, other);
    refused("'D0L systems up to size 5' --by infinite --resume " + file, other);
    refused("'D0L systems up to size 5' --by finite --first 1 --resume " + file, other);
    refused("'D0L systems up to size 5' --by finite --chunk-size 9 --resume " + file, other);
    refused("'D0L systems up to size 5' --by finite --distinct languages --resume " + file, other);
    const std::string text = text_of(file);
    folder.file("c.jsonl", text.substr(0, text.find('\n') + 1) + "no chunk\n" + text);
    refused("'D0L systems up to size 5' --by finite --resume " + file,
            "c.jsonl:2: expected a line of a checkpoint, found \"no chunk\"");
    refused("'D0L systems up to size 5' --resume " + folder.file("none.jsonl"), "cannot be opened");
    refused("'D0L systems up to size 5' --chunks 3..1 --checkpoint " + file,
            "--chunks: expected a range that goes up, such as 0..99, found \"3..1\"");
    refused("'D0L systems up to size 5' --chunks 3 --checkpoint " + file,
            "--chunks: expected a range of chunks such as 0..99, found \"3\"");
    refused("'D0L systems up to size 5' --chunks 0..3", "--chunks: expected --checkpoint FILE");
    refused("'D0L systems up to size 5' --chunk-size 0",
            "--chunk-size: expected a whole number from 1");
    refused("'D0L systems up to size 5' --by finite --verify-sample 3",
            "--verify-sample: expected --certificate FILE");
}

TEST_CASE("a thousand verdicts of a census have proofs that verify checks") {
    const Scratch folder;
    const std::string file = folder.file("sample.json");
    const std::string question =
        "census 'finite languages with words up to length 3 over {a, b}' --by "
        "0L,P0L,D0L,PD0L,T0L,PT0L,DT0L,PDT0L --format csv ";
    const Run sampled = run(question + "--verify-sample 125 --seed 7 --certificate " + file);
    CHECK(sampled.status == 0);
    const Run verified = run("verify " + file);
    CHECK(verified.status == 0);
    CHECK(verified.out.ends_with("1000 checked\n"));
    CHECK(verified.out.find(" is not T0L\n") != std::string::npos);
    CHECK(run(question + "--verify-sample 125 --seed 8 --certificate " + file).out == sampled.out);
    CHECK(run("verify " + file).out != verified.out);
}

TEST_CASE("the files of counts are what their commands print") {
    // Each line of the table has a file and a command; here for small sizes, whose lines begin the file.
    const std::string folder = source_folder() + "/theory/census/";
    std::istringstream readme(text_of(folder + "README.md"));
    std::size_t files = 0;
    for (std::string line; std::getline(readme, line);) {
        std::smatch found;
        if (!std::regex_match(line, found, std::regex("\\| `([^`]*)` \\| `algae ([^`]*)` \\|")))
            continue;
        ++files;
        CAPTURE(line);
        const auto without_title = [](const std::string& text) {
            return text.substr(text.find('\n') + 1);
        };
        const std::string command =
            std::regex_replace(found[2].str(), std::regex("up to size [0-9]+"), "up to size 7");
        const std::string counted = without_title(run(command).out);
        const std::string kept = text_of(folder + found[1].str());
        CHECK(!counted.empty());
        CHECK(without_title(kept).starts_with(counted));
    }
    CHECK(files == 10);
    std::size_t others = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder)) ++others;
    CHECK(
        others ==
        files +
            6);  // README.md, attack.md, infinite-languages.md, infinite-words.md, one-letter-languages.md and open-cells.md
}
