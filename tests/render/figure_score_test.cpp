#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cstdlib>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "exact/exact.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "render/render.hpp"

// Figures as music, read back by small readers of both formats and compared with what a walk over the letters says.

using namespace algae;

namespace {

struct Sound {
    int degree = 0;  // above the lowest of all
    std::uint64_t begin = 0, end = 0;
    bool operator==(const Sound&) const = default;
};
using Voice = std::vector<Sound>;

std::string written(const std::vector<Model>& systems, std::uint64_t n, FigureFormat format,
                    FigureTextDrawn* drawn = nullptr) {
    std::vector<std::unique_ptr<Figure>> figures;
    std::vector<FigureSource> sources;
    for (const Model& system : systems) {
        figures.push_back(figure(system, n, {}));
        sources.push_back({{figures.back().get(), "a voice", ""}});
    }
    FigureTextOptions options;
    options.picture.title = "Title % of\na piece";
    std::ostringstream out;
    const FigureTextDrawn found = draw_as_text(sources, out, format, options, Budget{});
    if (drawn) *drawn = found;
    return out.str();
}

/// The notes of each track but the first, as half tones.
std::vector<Voice> read_midi(const std::string& file) {
    std::size_t at = 0;
    const auto number = [&](int bytes) {
        std::uint64_t value = 0;
        for (; bytes > 0; --bytes) value = value << 8 | static_cast<unsigned char>(file.at(at++));
        return value;
    };
    const auto delta = [&] {
        std::uint64_t value = 0;
        for (;;) {
            const unsigned byte = static_cast<unsigned char>(file.at(at++));
            value = value << 7 | (byte & 0x7F);
            if (byte < 0x80) return value;
        }
    };
    REQUIRE(file.substr(0, 4) == "MThd");
    at = 4;
    REQUIRE(number(4) == 6);
    REQUIRE(number(2) == 1);
    const std::uint64_t tracks = number(2);
    REQUIRE(number(2) == 16);
    std::vector<Voice> voices;
    for (std::uint64_t track = 0; track < tracks; ++track) {
        REQUIRE(file.substr(at, 4) == "MTrk");
        at += 4;
        const std::uint64_t size = number(4);
        const std::size_t end = at + size;
        Voice voice;
        std::uint64_t time = 0;
        bool ended = false;
        while (at < end) {
            REQUIRE(!ended);
            time += delta();
            const auto status = number(1);
            if (status == 0xFF) {
                ended = number(1) == 0x2F;
                at += delta();
                continue;
            }
            REQUIRE(status % 16 != 9);  // drums
            const int pitch = static_cast<int>(number(1));
            const auto velocity = number(1);
            if (status / 16 == 9) {
                REQUIRE(velocity > 0);
                voice.push_back({pitch, time, 0});
            } else {
                REQUIRE(status / 16 == 8);
                REQUIRE(voice.back().degree == pitch);
                voice.back().end = time;
            }
        }
        REQUIRE(ended);
        REQUIRE(at == end);
        if (track > 0) voices.push_back(voice);
    }
    REQUIRE(at == file.size());
    return voices;
}

/// The notes of each voice, as degrees above middle C, tied ones as one.
std::vector<Voice> read_abc(const std::string& text) {
    std::istringstream lines(text);
    std::vector<Voice> voices;
    bool music = false;
    std::uint64_t time = 0, bar = 0;
    bool tied = false;
    for (std::string line; std::getline(lines, line);) {
        if (line == "K:C") {
            music = true;
            voices.emplace_back();
            continue;
        }
        if (!music) continue;
        if (line.starts_with("V:")) {
            if (!voices.back().empty()) voices.emplace_back();
            continue;
        }
        std::istringstream tokens(line);
        for (std::string token; tokens >> token;) {
            if (token == "|" || token == "|]") {
                if (token == "|") {
                    REQUIRE(time - bar == 64);  // 64ths in a bar
                    bar = time;
                }
                if (token == "|]") time = bar = 0;
                continue;
            }
            std::size_t i = 1;
            static const std::string below = "CDEFGAB", above = "cdefgab";
            int degree = below.find(token[0]) != std::string::npos
                             ? static_cast<int>(below.find(token[0]))
                             : 7 + static_cast<int>(above.find(token[0]));
            for (; i < token.size() && (token[i] == ',' || token[i] == '\''); ++i)
                degree += token[i] == ',' ? -7 : 7;
            std::uint64_t length = 8, below_line = 1;
            if (i < token.size() && std::isdigit(static_cast<unsigned char>(token[i]))) {
                std::size_t used = 0;
                length = 8 * std::stoul(token.substr(i), &used);
                i += used;
            }
            if (i < token.size() && token[i] == '/') {
                std::size_t used = 0;
                below_line = std::stoul(token.substr(i + 1), &used);
                i += 1 + used;
            }
            REQUIRE(length % below_line == 0);
            length /= below_line;
            if (tied) {
                REQUIRE(voices.back().back().degree == degree);
                voices.back().back().end += length;
            } else {
                voices.back().push_back({degree, time, time + length});
            }
            time += length;
            tied = i < token.size() && token[i] == '-';
            REQUIRE(i + (tied ? 1 : 0) == token.size());
        }
    }
    REQUIRE(!tied);
    return voices;
}

/// The same above the lowest note of all voices.
std::vector<Voice> from_lowest(std::vector<Voice> voices, bool half_tones) {
    static const std::string keys = "C-D-EF-G-A-B", scale = "CDEFGAB";
    int lowest = 1000;
    for (Voice& voice : voices)
        for (Sound& sound : voice) {
            if (half_tones) {
                const char key = keys[static_cast<std::size_t>(sound.degree % 12)];
                REQUIRE(key != '-');  // C major
                sound.degree = 7 * (sound.degree / 12) + static_cast<int>(scale.find(key));
            }
            lowest = std::min(lowest, sound.degree);
        }
    for (Voice& voice : voices)
        for (Sound& sound : voice) sound.degree -= lowest;
    return voices;
}

/// What a turtle with turns of 90 degrees plays that goes over these letters. Its lowest note is not 0.
Voice played(const std::string& word) {
    static constexpr int dx[] = {1, 0, -1, 0}, dy[] = {0, 1, 0, -1};
    Voice voice;
    std::pair<int, int> here{0, 0};
    std::optional<std::pair<int, int>>
        heard;  // where the note before ends, also if the pen comes back to it
    int heading = 0;
    std::uint64_t time = 0;
    for (const char letter : word) {
        if (letter == '+') heading = (heading + 1) % 4;
        if (letter == '-') heading = (heading + 3) % 4;
        if (letter != 'F' && letter != 'f') continue;
        const auto from = here;
        here = {here.first + dx[heading], here.second + dy[heading]};
        if (letter == 'f') continue;
        const bool follows = heard == from;
        heard.reset();
        if (dx[heading] == 0) continue;
        if (follows)
            voice.back().end += 8;
        else
            voice.push_back({from.second, time, time + 8});
        time += 8;
        heard = here;
    }
    return voice;
}

}  // namespace

TEST_CASE("a curve is heard as it goes: ways to the side are time, height is pitch") {
    FigureTextDrawn drawn;
    const std::string text = written({read_lsystem("axiom FF+F-F+FFFF-FFFFFFFFF", "x.lsys")}, 0,
                                     FigureFormat::abc, &drawn);
    CHECK(text ==
          "%abc-2.1\nX:1\nT:Title   of a piece\nM:4/4\nL:1/8\nQ:1/4=120\nK:C\n"
          "C2 D A4- A- | A4 |]\n");
    CHECK(drawn.notes == 3);
    // Two figures are two voices that begin together.
    const std::vector<Model> both{read_lsystem("axiom F+F-F", "x.lsys"),
                                  read_lsystem("axiom +F-FF", "y.lsys")};
    const std::vector<Voice> voices =
        from_lowest(read_midi(written(both, 0, FigureFormat::mid)), true);
    CHECK(voices == std::vector<Voice>{{{0, 0, 8}, {1, 8, 16}}, {{1, 0, 16}}});
    CHECK(voices == from_lowest(read_abc(written(both, 0, FigureFormat::abc)), false));
}

TEST_CASE("a figure without a stroke to the side is no music") {
    for (const FigureFormat format : {FigureFormat::abc, FigureFormat::mid})
        CHECK_THROWS_WITH_AS(written({read_lsystem("axiom +FF", "x.lsys")}, 0, format),
                             "a voice: expected a stroke to the left or to the right, which is "
                             "time in music, found none",
                             Error);
}

TEST_CASE("times that are no whole notes are tied, and no error grows") {
    // 60 degrees: half an eighth to the side, and 1000 times a third of a step.
    const std::string abc =
        written({read_lsystem("axiom F+F--FF; angle 60", "x.lsys")}, 0, FigureFormat::abc);
    const std::vector<Voice> voices = read_abc(abc);
    REQUIRE(voices.front().size() >= 2);
    CHECK(voices.front().back().end == 8 + 4 + 4 + 4);
    std::string long_one = "axiom F";
    for (int i = 0; i < 1000; ++i) long_one += "+(90)F-(90)F(1/3)";
    const Voice voice =
        read_midi(written({read_lsystem(long_one, "x.lsys")}, 0, FigureFormat::mid)).front();
    // The usual stroke is one step long; there are 1001 of them, 1000 upward.
    CHECK(voice.back().end == 2675);  // 8 + 8000 / 3, rounded once
    // 1000 degrees are pressed into those that there are.
    for (const Sound& sound : voice) CHECK((sound.degree >= 0 && sound.degree < 128));
}

TEST_CASE("music of random words is what a walk over the letters plays") {
    int compared = 0;
    CHECK(rc::check([&] {
        std::string word;
        for (int i = *rc::gen::inRange(1, 60); i > 0; --i)
            word += *rc::gen::element('F', 'F', 'F', '+', '-', 'f');
        const Voice expected = played(word);
        RC_PRE(!expected.empty());
        const auto above_lowest = from_lowest({expected}, false);
        const std::vector<Model> system{read_lsystem("axiom " + word, "x.lsys")};
        RC_ASSERT(from_lowest(read_midi(written(system, 0, FigureFormat::mid)), true) ==
                  above_lowest);
        RC_ASSERT(from_lowest(read_abc(written(system, 0, FigureFormat::abc)), false) ==
                  above_lowest);
        ++compared;
    }));
    CHECK(compared >= 100);
}
