// Grammars for editors: those of the repository are the ones that are made, and they cut texts as the readers do.

#include <doctest/doctest.h>

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "notation/detail/claim_reading.hpp"
#include "notation/detail/reading.hpp"
#include "notation/notation.hpp"
#include "notation/random_text.hpp"
#include "places.hpp"

using namespace algae;
using nlohmann::json;
namespace paths = std::filesystem;

namespace {

const paths::path root = source_folder();

std::string text_of(const paths::path& path) {
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// A place for the files of a test, removed in the end.
struct Folder {
    paths::path path = paths::temp_directory_path() / ("algae-editors-" + std::to_string(getpid()));
    Folder() { paths::create_directories(path); }
    ~Folder() { paths::remove_all(path); }
};

json piece(const std::string& name, std::string_view clause, std::string_view text) {
    const auto from = static_cast<std::size_t>(clause.data() - text.data());
    return {name, from, from + clause.size()};
}

/// A text with its statements as the reader cuts them.
json of_system(const std::string& text, bool whole) {
    json all = json::array();
    for (const Clause& clause : clauses(text)) {
        const std::string keyword(clause.keyword);
        std::size_t bytes = 0;
        const char* name = is_rule(clause)                             ? "Rule"
                           : clause.has_word("interpret")              ? "Interpretation"
                           : keyword == "title" || keyword == "source" ? "Prose"
                                                                       : "Setting";
        if (keyword == "coding") name = "Coding";
        if (system_block(clause.text, bytes)) name = "Within";
        all.push_back(piece(name, clause.text, text));
    }
    return {{"kind", "lsys"}, {"text", text}, {"whole", whole}, {"statements", all}};
}
json of_claim(const std::string& text, bool whole) {
    json all = json::array();
    for (const ClaimClause& clause : claim_clauses(text)) {
        const bool prose =
            clause.keyword == "claim" || clause.keyword == "source" || clause.keyword == "note";
        all.push_back(piece(prose ? "Prose" : "Statement", clause.text, text));
    }
    return {{"kind", "claim"}, {"text", text}, {"whole", whole}, {"statements", all}};
}

bool is_read(const std::string& text) {
    try {
        read_lsystem(text, "x.lsys");
        return true;
    } catch (const Error&) {
        return false;
    }
}
bool is_read_as_claim(const std::string& text) {
    try {
        read_claim(text, "x.claim",
                   [](const std::string& name) -> Model { throw Error("no system " + name); });
        return true;
    } catch (const Error&) {
        return false;
    }
}

/// Changes of a text where editors and readers could cut it differently.
std::string changed(std::string text) {
    static const random_text::Strings pieces{" # a remark; with -> and {\n",
                                             "; ",
                                             "\n\n",
                                             "\t",
                                             "  ",
                                             "{",
                                             "}",
                                             "#",
                                             "# x\n",
                                             "title A; ",
                                             "->",
                                             "→",
                                             " | ",
                                             "(",
                                             ")",
                                             ";",
                                             "\r\n",
                                             "é",
                                             "\xc2\xa0"};
    for (int left = random_text::below(4); left > 0 && !text.empty(); --left) {
        std::size_t at =
            static_cast<std::size_t>(random_text::below(static_cast<int>(text.size()) + 1));
        while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80) ++at;
        text.insert(at, random_text::one_of(pieces));
    }
    return text;
}

/// A claim with blanks, breaks and remarks where these may stand.
std::string random_claim() {
    using random_text::below, random_text::one_of;
    const auto gap = [] { return one_of({" ", " ", " ", "  ", "\t"}); };
    const auto in_braces = [&] {
        return one_of({" ", " ", "\n", "\n  ", " # a } remark {\n", "\n# {\n"});
    };
    std::string text = one_of({"", "# at first\n", "\n"}) + "claim" + gap() +
                       one_of({"Words", "A title with {", "100% # said", "A -> B"});
    const char* const next[] = {"\n", "; ", "\n\n", " # a remark\n", "\n# ; {\n", ";"};
    const auto end = [&] { text += next[below(6)]; };
    end();
    const int count = 1 + below(6);
    for (int i = 0; i < count; ++i) {
        const std::string name(1, static_cast<char>('A' + i));
        switch (below(6)) {
            case 0:
                text += "let" + gap() + name + " =" + gap() + "{a," + in_braces() + "ab" +
                        in_braces() + "}";
                break;
            case 1:
                text += "let " + name + " = D0L {" + in_braces() + "axiom a;" + in_braces() +
                        "a -> ab" + in_braces() + "}";
                break;
            case 2:
                text += "show" + gap() + "{a, aa}" + gap() + one_of({"is 0L", "is not 0L"});
                break;
            case 3:
                text += "note" + gap() + one_of({"a } text", "one; ", "{ # b"});
                break;
            case 4:
                text += one_of({"refute", "show", "lemma"}) + gap() + "{a}" + gap() + "==" + gap() +
                        "/a+|b/" + one_of({"", " by a source"});
                break;
            default:
                text += "alphabet" + gap() + "c d";
        }
        end();
    }
    return text;
}

}  // namespace

TEST_CASE("files for editors are those that are made from the tables") {
    const paths::path folder = root / "docs/editors";
    for (const EditorFile& file : editor_files()) {
        CAPTURE(file.path);
        CHECK(text_of(folder / file.path) == file.text);
        const bool claims = file.path.find("claim") != std::string::npos;
        const bool grammar = file.path.find("lsys") != std::string::npos || claims;
        for (const StatementHelp& help : claims ? claim_statements() : system_statements())
            if (grammar)
                CHECK_MESSAGE(file.text.find(help.keyword.substr(
                                  0, help.keyword.find_first_of(" -"))) != std::string::npos,
                              help.keyword);
    }
}

TEST_CASE(
    "grammars for editors cut every file of the repository and random texts as the readers do") {
    const paths::path modules = root / "out/editors/node_modules";
    if (!paths::exists(modules / "@lezer/generator") ||
        !paths::exists(modules / "vscode-textmate") ||
        std::system("command -v node >/dev/null") != 0) {
        MESSAGE(
            "node with Lezer and vscode-textmate is not here: grammars for editors were NOT "
            "compared with the readers; tools/editors installs it");
        return;
    }
    const Folder folder;
    std::ofstream out(folder.path / "texts");
    std::size_t files = 0;
    for (const char* part : {"figures", "systems", "theory", "examples", "lessons", "paper"})
        for (const auto& entry : paths::recursive_directory_iterator(root / part)) {
            const std::string ending = entry.path().extension().string();
            if (ending != ".lsys" && ending != ".claim") continue;
            const std::string text = text_of(entry.path());
            out << (ending == ".lsys" ? of_system(text, true) : of_claim(text, true)).dump()
                << '\n';
            ++files;
        }
    CHECK(files >= 300);
    std::mt19937 generator(21);
    const auto given = random_text::choose;
    random_text::choose = [&](int bound) {
        return static_cast<int>(generator() % static_cast<unsigned>(bound));
    };
    constexpr int systems = 70'000, claims = 30'000;
    std::size_t read = 0, read_claims = 0;
    for (int i = 0; i < systems; ++i) {
        const std::string text = changed(random_text::system());
        if (!is_read(text)) continue;
        out << of_system(text, false).dump() << '\n';
        ++read;
    }
    for (int i = 0; i < claims; ++i) {
        const std::string text = changed(random_claim());
        if (!is_read_as_claim(text)) continue;
        out << of_claim(text, false).dump() << '\n';
        ++read_claims;
    }
    random_text::choose = given;
    out.close();
    CHECK(read >= 20'000);
    CHECK(read_claims >= 8'000);
    const std::string command = "node '" + (root / "tests/notation/editors.mjs").string() + "' '" +
                                modules.string() + "' '" + (root / "docs/editors").string() +
                                "' '" + (folder.path / "texts").string() + "' > '" +
                                (folder.path / "said").string() + "' 2>&1";
    const int status = std::system(command.c_str());
    const std::string said = text_of(folder.path / "said");
    INFO(said);
    REQUIRE(status == 0);
    const json counts = json::parse(said);
    CHECK(counts["count"] == files + read + read_claims);
    CHECK(counts["whole"] == files);
    CHECK(counts["wrong"] == 0);
    MESSAGE(read << " systems and " << read_claims << " claims of random texts were compared");
}

TEST_CASE("Vim's syntax files mark keywords and arrows in every file of the repository") {
    if (std::system("command -v vim >/dev/null") != 0) {
        MESSAGE("Vim is not here: its syntax files were NOT tried");
        return;
    }
    const Folder folder;
    std::ofstream out(folder.path / "places");
    std::size_t places = 0;
    for (const char* part : {"figures", "systems", "theory", "lessons"})
        for (const auto& entry : paths::recursive_directory_iterator(root / part)) {
            const std::string ending = entry.path().extension().string();
            if (ending != ".lsys" && ending != ".claim") continue;
            const std::string text = text_of(entry.path());
            const auto add = [&](const char* group, const char* where) {
                const auto at = static_cast<std::size_t>(where - text.data());
                const std::size_t line = static_cast<std::size_t>(
                    std::count(text.begin(), text.begin() + (where - text.data()), '\n'));
                const std::size_t begin = line == 0 ? 0 : text.rfind('\n', at - 1) + 1;
                if (at < begin) return;
                out << group << '\t' << line + 1 << '\t' << at - begin + 1 << '\t'
                    << entry.path().string() << '\n';
                ++places;
            };
            if (ending == ".lsys")
                for (const Clause& clause : clauses(text))
                    add(is_rule(clause) ? "lsysArrow" : "lsysKeyword",
                        is_rule(clause) ? clause.arrow : clause.text.data());
            else
                for (const ClaimClause& clause : claim_clauses(text))
                    add("claimKeyword", clause.text.data());
        }
    out.close();
    CHECK(places >= 2'000);
    const std::string command = "vim -es -N -u NONE -i NONE --cmd \"set runtimepath^=" +
                                (root / "docs/editors/vim").string() + "\" --cmd \"let g:places='" +
                                (folder.path / "places").string() + "' | let g:said='" +
                                (folder.path / "said").string() + "'\" -S '" +
                                (root / "tests/notation/editors.vim").string() +
                                "' >/dev/null 2>&1 </dev/null";
    const int status = std::system(command.c_str());
    const std::string said = text_of(folder.path / "said");
    INFO(status << ' ' << said);
    CHECK(said == std::to_string(places) + " 0\n");
}
