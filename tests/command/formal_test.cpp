// Theorems in Coq that claims name: cited, and proved formally only where their compiled proofs are. Coq itself is not needed here:
// the folders are made up. tools/formal makes the true one.
#include <doctest/doctest.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "command/run.hpp"
#include "places.hpp"

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const fs::path sources = fs::path(source_folder()) / "theory" / "formal";

/// The digest of a file, by another program.
std::string digest(const fs::path& file) {
    const Scratch scratch;
    const std::string out = scratch.file("digest");
    REQUIRE(std::system(("sha256sum '" + file.string() + "' >'" + out + "'").c_str()) == 0);
    return text_of(out).substr(0, 64);
}

/// A folder as tools/formal leaves it, with a text in the place of what Coq compiles.
class Compiled {
public:
    Compiled() {
        Json files;
        for (const auto& entry : fs::directory_iterator(sources)) {
            if (entry.path().extension() != ".v") continue;
            const std::string name = entry.path().stem().string();
            fs::copy_file(entry.path(), folder_.path() / entry.path().filename());
            folder_.file(name + ".vo", std::string(sizes++, '.') + name);
            files[name] = {{"source", digest(entry.path())},
                           {"compiled", digest(folder_.path() / (name + ".vo"))}};
        }
        files["table"] = {{"source", digest(sources / "table.txt")}};
        proved = {{"format", "algae formal 1"},
                  {"coq", "8.16.1"},
                  {"checked again", true},
                  {"files", files}};
        for (const std::vector<std::string>& cell : cells())
            if (cell[2] != "open") proved["theorems"][cell[3]] = Json::array();
        write();
    }
    void write() { folder_.file("proved.json", proved.dump()); }
    const fs::path& path() const { return folder_.path(); }
    std::string option() const { return " --formal '" + path().string() + "'"; }

    /// theory/formal/table.txt: operation, family, sign, theorem.
    static std::vector<std::vector<std::string>> cells() {
        std::vector<std::vector<std::string>> all;
        std::istringstream lines(text_of((sources / "table.txt").string()));
        for (std::string line; std::getline(lines, line);) {
            if (line.starts_with('#')) continue;
            all.emplace_back();
            for (std::size_t at = 0; at < line.size();) {
                const std::size_t end = std::min(line.find("; ", at), line.size());
                all.back().push_back(line.substr(at, end - at));
                at = end + 2;
            }
            REQUIRE(all.back().size() == 4);
        }
        return all;
    }

    Json proved;

private:
    Scratch folder_;
    std::size_t sizes = 0;  // so that the digests are of texts of all lengths around a block
};

const std::string union_e0l = "formal/OneTable.v:extended_union";

}  // namespace

TEST_CASE("every cell that is proved in Coq names its theorem, which is cited without the proofs") {
    const Json table = Json::parse(run("closure --json").out)["table"];
    std::size_t proved = 0, open = 0;
    for (const auto& cell : Compiled::cells()) {
        CAPTURE(cell[0] + " " + cell[1]);
        for (const Json& one : table) {
            if (one["operation"] != cell[0] || one["family"] != cell[1]) continue;
            if (cell[2] == "open") {
                ++open;
                CHECK(!one.contains("formal"));
                continue;
            }
            ++proved;
            CHECK(one["closed"] == (cell[2] == "closed"));
            CHECK(one["formal"]["theorem"] == "formal/" + cell[3]);
            CHECK(one["formal"]["verdict"] == "cited");
            REQUIRE(one["formal"]["says"].size() == 2);
            const auto says = one["formal"]["says"][0].get<std::string>();
            CHECK(says.starts_with(cell[2] == "closed" ? "For every" : "It is not so that"));
            CHECK(says.ends_with("is " + cell[1] + "."));
            CHECK(says.find(" F language") == std::string::npos);
            CHECK(one["formal"]["says"][1].get<std::string>().starts_with(cell[1] + ": "));
        }
    }
    CHECK(proved >= 192);
    CHECK(proved + open == table.size());
    CHECK(run("closure").out.find('*') == std::string::npos);
}

TEST_CASE("with the compiled proofs cells are proved formally, and the answer says by what") {
    const Compiled compiled;
    const Json table = Json::parse(run("closure --json" + compiled.option()).out)["table"];
    std::size_t proved = 0, expected = 0;
    for (const Json& one : table)
        if (one.contains("formal")) {
            ++proved;
            CHECK(one["formal"]["verdict"] == "proved formally");
            CHECK(one["formal"]["by"] == "Coq 8.16.1 and coqchk");
        }
    for (const auto& cell : Compiled::cells()) expected += cell[2] == "open" ? 0 : 1;
    CHECK(proved == expected);
    const std::string row = run("closure IL" + compiled.option()).out;
    CHECK(row.find("-*") != std::string::npos);
    CHECK(row.find("(-)") != std::string::npos);  // star and plus are not proved there
    CHECK(row.find("\n*: proved formally, by Coq 8.16.1 and coqchk, from the definitions of "
                   "theory/formal/Spec.v.\n") != std::string::npos);
    const std::string cell = run("closure E0L union" + compiled.option()).out;
    CHECK(cell.find("In Coq " + union_e0l +
                    ": proved formally, without axioms, by Coq 8.16.1 and coqchk.\n"
                    "   For every finite alphabet A, all E0L languages X and Y over A:") !=
          std::string::npos);
}

TEST_CASE("proofs of other sources, or other compiled files, are refused") {
    struct Change {
        const char* what;
        std::function<void(Compiled&)> make;
        const char* error;
    };
    const auto append = [](const fs::path& file) { std::ofstream(file, std::ios::app) << ' '; };
    const Change changes[] = {
        {"no proved.json", [](Compiled& c) { fs::remove(c.path() / "proved.json"); },
         "expected a folder with proved.json"},
        {"no JSON", [&](Compiled& c) { std::ofstream(c.path() / "proved.json") << "{"; },
         "expected an object with the format \"algae formal 1\""},
        {"another format",
         [](Compiled& c) {
             c.proved["format"] = "algae formal 2";
             c.write();
         },
         "expected an object with the format \"algae formal 1\""},
        {"a changed source", [&](Compiled& c) { append(c.path() / "Spec.v"); },
         "Spec.v: expected the text of theory/formal/Spec.v that this algae carries"},
        {"no source", [](Compiled& c) { fs::remove(c.path() / "Spec.v"); },
         "Spec.v: expected this file, found none"},
        {"compiled from another source",
         [](Compiled& c) {
             c.proved["files"]["Star"]["source"] = std::string(64, '0');
             c.write();
         },
         "expected the digest of theory/formal/Star.v that this algae carries"},
        {"another table",
         [](Compiled& c) {
             c.proved["files"].erase("table");
             c.write();
         },
         "expected the digest of theory/formal/table.txt that this algae carries"},
        {"compiled again", [&](Compiled& c) { append(c.path() / "Table.vo"); },
         "Table.vo: expected what Coq compiled, found something else"},
        {"not compiled", [](Compiled& c) { fs::remove(c.path() / "Table.vo"); },
         "Table.vo: expected the compiled proofs, found none"},
    };
    for (const Change& change : changes) {
        CAPTURE(change.what);
        Compiled compiled;
        change.make(compiled);
        for (const char* asked : {"closure E0L union", "check theory/closure/union-e0l.claim"}) {
            const Run found = run(asked + compiled.option());
            CHECK(found.status == 2);
            CHECK(found.out.empty());
            CHECK(found.err.find(change.error) != std::string::npos);
        }
    }
}

TEST_CASE("a theorem that rests on an axiom, or that was not looked at, is cited") {
    Compiled compiled;
    compiled.proved["theorems"]["OneTable.v:extended_union"] = {"Classical_Prop.classic"};
    compiled.proved["theorems"].erase("OneTable.v:extended_star");
    compiled.write();
    for (const char* operation : {"union", "star", "plus"}) {
        const Json cell =
            Json::parse(run("closure E0L " + std::string(operation) + " --json" + compiled.option())
                            .out)["cell"];
        CHECK(cell["formal"]["verdict"] ==
              (operation == std::string("plus") ? "proved formally" : "cited"));
    }
}

TEST_CASE("check shows a theorem as proved formally only where its proof is") {
    const Compiled compiled;
    const Scratch scratch;
    const std::string claim =
        "claim E0L languages are closed under union\ntheorem closed under union: E0L";
    const std::string cited =
        "check '" + scratch.file("a.claim", claim + " by " + union_e0l + "\n") + "'";
    const Run without = run(cited), with = run(cited + compiled.option());
    CHECK(without.status == 3);
    CHECK(without.out ==
          "claim E0L languages are closed under union\n"
          "  theorem closed under union: E0L\n    cited: " +
              union_e0l + "\n  in Coq " + union_e0l + ": cited\n");
    CHECK(with.status == 0);
    CHECK(with.out ==
          "claim E0L languages are closed under union\n"
          "  theorem closed under union: E0L\n    proved formally: " +
              union_e0l + "\n  in Coq " + union_e0l + ": proved formally\n");
    const Json found = Json::parse(run(cited + " --json" + compiled.option()).out)["claims"][0];
    CHECK(found["verdict"] == "proved formally");
    CHECK(found["theorem"]["verdict"] == "proved formally");
    CHECK(found["formal"][0]["verdict"] == "proved formally");
    // A certificate has no proof of it that verify could check.
    const std::string certificate = scratch.file("a.json");
    CHECK(run(cited + compiled.option() + " --certificate '" + certificate + "'").status == 0);
    CHECK(Json::parse(text_of(certificate))["statements"][0]["verdict"] == "cited");

    // What is no sentence of the table is not proved by naming a theorem of it.
    const std::string other = "check '" +
                              scratch.file("b.claim",
                                           "claim x\ntheorem for all E0L languages A: "
                                           "A* is E0L by " +
                                               union_e0l + "\n") +
                              "'";
    CHECK(run(other + compiled.option()).status == 3);
    CHECK(run(other + compiled.option()).out.find("formally") == std::string::npos);
    // Examples stay examples.
    const Json examples = Json::parse(
        run("check theory/closure/union-e0l.claim --json" + compiled.option()).out)["claims"][0];
    CHECK(examples["verdict"] == "examples");
    CHECK(examples["formal"][0] == Json{{"operation", "union"},
                                        {"families", {"E0L", "ET0L", "EDT0L"}},
                                        {"closed", true},
                                        {"theorem", union_e0l},
                                        {"verdict", "proved formally"}});
}

TEST_CASE("a claim can name only the theorem of its own cells") {
    const Scratch scratch;
    const auto error = [&](const std::string& clause) {
        const std::string file =
            scratch.file("x.claim", "claim x\nshow a in {a}\n" + clause + "\n");
        const Run found = run("check '" + file + "'");
        CHECK(found.status == 2);
        return found.err;
    };
    const auto has = [](const std::string& text, const std::string& part) {
        return text.find(part) != std::string::npos;
    };
    CHECK(has(error("closed under union: E0L by a book"),
              "expected a theorem of theory/formal, as "
              "formal/Star.v:not_closed_under_star, found 'a book'"));
    CHECK(has(error("closed under union: E0L REG by " + union_e0l),
              "expected formal/AbstractFamily.v:regular_union, the theorem on REG under union"));
    CHECK(has(error("not closed under union: E0L by " + union_e0l),
              "expected a statement that theory/formal proves, which has E0L under union: closed"));
    CHECK(has(error("not closed under star: IL by formal/Star.v:not_closed_under_star"),
              "theory/formal has no theorem on IL under star"));
    CHECK(has(error("closed under union: E0L by"), "expected a citation after 'by'"));
}
