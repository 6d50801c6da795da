#include "render/render.hpp"

#include <doctest/doctest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "exact/exact.hpp"
#include "render/detail/document.hpp"

using namespace algae;
namespace files = std::filesystem;

namespace {

/// A folder of its own, gone at the end of the test.
struct Folder {
    files::path path =
        files::temp_directory_path() / ("algae-render-" + std::to_string(::getpid()));
    Folder() { files::create_directories(path); }
    ~Folder() { files::remove_all(path); }
    std::string operator/(const std::string& name) const { return (path / name).string(); }
    std::size_t count() const {
        return static_cast<std::size_t>(
            std::distance(files::directory_iterator(path), files::directory_iterator()));
    }
};

std::string text_of(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

void write(Output& output, const std::string& text) { output.write(text.data(), text.size()); }

struct Kept final : Output {
    void write(const char* bytes, std::size_t count) override { text.append(bytes, count); }
    std::string text;
};

}  // namespace

TEST_CASE("a file appears whole or not at all") {
    const Folder folder;
    const std::string path = folder / "koch.svg";
    {
        FileOutput file(path);
        write(file, std::string(200'000, 'a'));
        CHECK_FALSE(files::exists(path));
        file.commit();
        CHECK(files::file_size(path) == 200'000);
    }
    CHECK(folder.count() == 1);
    {
        FileOutput file(path);
        write(file, "half");
    }
    CHECK(folder.count() == 1);
    CHECK(files::file_size(path) == 200'000);  // the old one is as it was
}

TEST_CASE("what cannot be written is refused with the reason") {
    const Folder folder;
    CHECK_THROWS_WITH_AS(FileOutput(folder.path.string()),
                         ("cannot write " + folder.path.string() + ": Is a directory").c_str(),
                         Error);
    CHECK_THROWS_WITH_AS(
        FileOutput(folder / "no/koch.svg"),
        ("cannot write " + (folder / "no/koch.svg") + ": No such file or directory").c_str(),
        Error);
    CHECK_THROWS_WITH_AS(FileOutput(""), "cannot write a file without a name", Error);
    CHECK_THROWS_AS(FileOutput("/proc/koch.svg"), Error);  // a folder nobody may write to
    if (::geteuid() != 0) {
        files::permissions(folder.path, files::perms::owner_read | files::perms::owner_exec);
        CHECK_THROWS_WITH_AS(
            FileOutput(folder / "koch.svg"),
            ("cannot write " + (folder / "koch.svg") + ": Permission denied").c_str(), Error);
        files::permissions(folder.path, files::perms::owner_all);
    }
    CHECK(folder.count() == 0);
}

TEST_CASE("a full disk is an error, and a device stays a device") {
    FileOutput full("/dev/full");
    write(full, "text");
    CHECK_THROWS_WITH_AS(full.commit(), "cannot write /dev/full: No space left on device", Error);
    FileOutput nowhere("/dev/null");
    write(nowhere, "text");
    nowhere.commit();
    CHECK(files::is_character_file("/dev/null"));
}

TEST_CASE("links are followed and permissions kept") {
    const Folder folder;
    const std::string target = folder / "target.svg", link = folder / "link.svg";
    std::ofstream(target) << "old";
    files::permissions(target, files::perms::owner_read | files::perms::owner_write);
    files::create_symlink("target.svg", link);
    FileOutput file(link);
    write(file, "new");
    file.commit();
    CHECK(files::is_symlink(link));
    CHECK(text_of(target) == "new");
    CHECK(files::status(target).permissions() ==
          (files::perms::owner_read | files::perms::owner_write));
}

TEST_CASE("a stream that fails is an error") {
    std::ofstream full("/dev/full");
    StreamOutput output(full);
    CHECK_THROWS_AS(
        [&] {
            for (int i = 0; i < 100; ++i) write(output, std::string(10'000, 'a'));
        }(),
        Error);
}

TEST_CASE("a stream that holds back its bytes is an error at the end") {
    std::ofstream full("/dev/full");
    StreamOutput output(full);
    write(output, "text");
    CHECK_THROWS_WITH_AS(output.finish(), "cannot write the picture: No space left on device",
                         Error);
}

TEST_CASE("the date of a PostScript document is left out, wherever the pieces are cut") {
    const std::string document =
        "%!PS\n%%CreationDate: Sat Nov 21 11:13:55 2026\n%%Pages: 1\n"
        "%%EndComments\n(%%CreationDate: stays)\n";
    for (std::size_t cut = 0; cut <= document.size(); ++cut) {
        Kept kept;
        UndatedOutput undated(kept);
        write(undated, document.substr(0, cut));
        write(undated, document.substr(cut));
        undated.finish();
        CHECK(kept.text == "%!PS\n%%Pages: 1\n%%EndComments\n(%%CreationDate: stays)\n");
    }
}

TEST_CASE("surfaces and images of an SVG document are numbered from 1") {
    const std::string document =
        "<g id=\"surface17\"><image id=\"image23\" xlink:href=\"data:image/png\"/>"
        "<use xlink:href=\"#image23\"/> surface99 \"imagery\" \"surface\"</g>";
    for (std::size_t cut = 0; cut <= document.size(); ++cut) {
        Kept kept;
        RenumberedOutput renumbered(kept);
        write(renumbered, document.substr(0, cut));
        write(renumbered, document.substr(cut));
        renumbered.finish();
        CHECK(kept.text ==
              "<g id=\"surface1\"><image id=\"image2\" xlink:href=\"data:image/png\"/>"
              "<use xlink:href=\"#image2\"/> surface99 \"imagery\" \"surface\"</g>");
    }
    Kept kept;
    RenumberedOutput renumbered(kept);
    std::string long_document;
    for (int i = 0; i < 5000; ++i) long_document += "<g id=\"surface17\">d=\"M 1 1\"";
    for (std::size_t i = 0; i < long_document.size(); i += 1000)
        write(renumbered, long_document.substr(i, 1000));
    renumbered.finish();
    CHECK(kept.text.size() == long_document.size() - 5000);
    CHECK(kept.text.find("surface17") == std::string::npos);
}
