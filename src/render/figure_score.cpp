#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "render/detail/document.hpp"
#include "render/detail/figure_text.hpp"

// Figures as music: a score in ABC notation (version 2.1), which programs of music print, and a MIDI file (format 1), which they play.
//
// A curve is heard as Prusinkiewicz hears it (Score generation with L-systems, 1986): the turtle goes along it in the order of the word, a
// way to the left or to the right is time, and height is pitch. The usual stroke, of median length, is an eighth of a note long and one
// degree of C major high. Strokes that follow each other at one height are one note; those straight up or down are
// not heard, and neither are polygons, nor moves with the pen up. Several figures sound together, a voice each.
//
// Times are rounded to 64ths of a note, each as a sum from the beginning, so that no error grows. The middle of what sounds is near middle
// C; figures of more than 52 degrees are pressed into these. In ABC a note that crosses a bar, or is no note by itself, is tied together
// from several.

namespace algae {

namespace {

constexpr std::uint64_t ticks_of_eighth = 8, ticks_of_bar = 64;
constexpr int degrees_of_octave = 7, most_degrees = 52;

struct Note {
    int degree =
        0;  // above the C four lines below the staff of the treble clef, which is middle C less `octaves_below` octaves
    std::uint64_t begin = 0, end = 0;  // in 64ths
};

/// The voices of figures, and how many octaves below middle C their lowest degree is.
struct Score {
    std::vector<std::vector<Note>> voices;
    int octaves_below = 0;
    std::uint64_t notes = 0;
};

template <class Visit>
void each_stroke(const PlacedFigure& figure, Visit visit) {
    for (const FigurePath& path : figure.paths.paths)
        for (std::size_t i = 0; !path.filled && i + 1 < path.points.size(); ++i)
            visit(path.points[i], path.points[i + 1]);
}

double usual_length(const FigureDocument& document) {
    std::vector<double> lengths;
    for (const PlacedFigure& figure : document.figures)
        each_stroke(figure, [&](Point from, Point to) {
            if (const double length = distance(from, to); length > 0) lengths.push_back(length);
        });
    if (lengths.empty()) return 0;
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>((lengths.size() - 1) / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    return *middle;
}

Score score_of(const FigureDocument& document) {
    const double unit = usual_length(document);
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    const auto is_heard = [&](Point from, Point to) {
        return std::fabs(to.x - from.x) > 1e-9 * unit;
    };
    for (const PlacedFigure& figure : document.figures)
        each_stroke(figure, [&](Point from, Point to) {
            if (!is_heard(from, to)) return;
            lowest = std::min(lowest, from.y);
            highest = std::max(highest, from.y);
        });
    if (!(lowest <= highest))
        throw Error(
            document.figures.front().source->plate.name +
            ": expected a stroke to the left or to the right, which is time in music, found none");
    const double degrees = (highest - lowest) / unit;
    const double degree = degrees > most_degrees ? unit * (degrees / most_degrees) : unit;
    Score score;
    const int middle = static_cast<int>(std::lround((highest - lowest) / degree / 2));
    score.octaves_below = (middle + degrees_of_octave / 2) / degrees_of_octave;
    for (const PlacedFigure& figure : document.figures) {
        std::vector<Note>& voice = score.voices.emplace_back();
        double time = 0;
        std::optional<Point> last;  // where the note before ends
        const auto tick = [&] {
            return static_cast<std::uint64_t>(
                std::llround(time / unit * static_cast<double>(ticks_of_eighth)));
        };
        each_stroke(figure, [&](Point from, Point to) {
            const bool follows = last && *last == from;
            last.reset();
            if (!is_heard(from, to)) return;
            const int height = static_cast<int>(std::lround((from.y - lowest) / degree));
            const std::uint64_t begin = tick();
            time += std::fabs(to.x - from.x);
            last = to;
            if (follows && !voice.empty() && voice.back().degree == height &&
                voice.back().end == begin)
                voice.back().end = tick();
            else if (tick() > begin)
                voice.push_back({height, begin, tick()});
        });
        score.notes += voice.size();
    }
    return score;
}

/// "C,", "c''": a degree above the C that is `octaves_below` octaves below middle C.
std::string abc_pitch(int degree, int octaves_below) {
    const int octave = degree / degrees_of_octave - octaves_below;
    const char letter = "CDEFGAB"[degree % degrees_of_octave];
    std::string out(1, octave > 0 ? static_cast<char>(letter - 'A' + 'a') : letter);
    out.append(static_cast<std::size_t>(octave > 0 ? octave - 1 : -octave),
               octave > 0 ? '\'' : ',');
    return out;
}

/// A length behind a pitch, where an eighth is nothing: "3", "/2", "3/8".
std::string abc_length(std::uint64_t ticks) {
    std::uint64_t below = ticks_of_eighth;
    while (ticks % 2 == 0 && below > 1) ticks /= 2, below /= 2;
    return (ticks == 1 ? "" : std::to_string(ticks)) +
           (below == 1 ? "" : "/" + std::to_string(below));
}

/// The longest note, dotted or not, that is at most so long.
std::uint64_t longest_note(std::uint64_t ticks) {
    static constexpr std::array<std::uint64_t, 12> all{64, 48, 32, 24, 16, 12, 8, 6, 4, 3, 2, 1};
    return *std::ranges::find_if(all, [&](std::uint64_t one) { return one <= ticks; });
}

/// A line of text, without what would end it or begin a comment.
std::string abc_line(std::string text) {
    std::ranges::replace_if(
        text, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == '%'; }, ' ');
    return text;
}

void put_number(std::string& out, std::uint64_t value, int bytes) {
    while (bytes-- > 0) out += static_cast<char>(value >> (8 * bytes) & 0xFF);
}

/// A number in seven bits a byte, the last of them without the eighth.
void put_delta(std::string& out, std::uint64_t value) {
    int last = 0;
    while (value >> (7 * (last + 1)) != 0) ++last;
    for (; last >= 0; --last)
        out += static_cast<char>((value >> (7 * last) & 0x7F) | (last > 0 ? 0x80U : 0));
}

void put_text(std::string& out, int kind, const std::string& text) {
    put_delta(out, 0);
    (out += '\xFF') += static_cast<char>(kind);
    put_delta(out, text.size());
    out += text;
}

void put_track(std::string& out, std::string track) {
    put_delta(track, 0);
    track += std::string("\xFF\x2F\0", 3);
    out += "MTrk";
    put_number(out, track.size(), 4);
    out += track;
}

}  // namespace

std::string abc_text(const FigureDocument& document, FigureTextDrawn& drawn) {
    constexpr std::uint64_t bars_of_line = 4;
    const Score score = score_of(document);
    drawn.notes = score.notes;
    std::string out = "%abc-2.1\nX:1\nT:" + abc_line(document.head) + "\n";
    if (const std::string& author = document.options->picture.author; !author.empty())
        out += "C:" + abc_line(author) + "\n";
    out += "M:4/4\nL:1/8\nQ:1/4=120\nK:C\n";
    for (std::size_t i = 0; i < score.voices.size(); ++i) {
        if (score.voices.size() > 1)
            out += "V:" + std::to_string(i + 1) + " name=\"" +
                   abc_line(plain_name(document.figures[i].source->plate.name)) + "\"\n";
        std::uint64_t at = 0;
        for (const Note& note : score.voices[i]) {
            while (at < note.end) {
                const std::uint64_t in_bar = at % ticks_of_bar;
                const std::uint64_t length =
                    longest_note(std::min(note.end - at, ticks_of_bar - in_bar));
                out += abc_pitch(note.degree, score.octaves_below) + abc_length(length);
                at += length;
                if (at < note.end) out += '-';
                if (at % ticks_of_bar != 0 || at == score.voices[i].back().end)
                    out += ' ';
                else
                    out += at % (bars_of_line * ticks_of_bar) == 0 ? " |\n" : " | ";
            }
        }
        out += "|]\n";
    }
    return out;
}

std::string midi_text(const FigureDocument& document, FigureTextDrawn& drawn) {
    constexpr int middle_c = 60, half_tones = 12, velocity = 80, channels = 16, drums = 9;
    static constexpr std::array<int, degrees_of_octave> above_c{0, 2, 4, 5, 7, 9, 11};
    const Score score = score_of(document);
    drawn.notes = score.notes;
    std::string out = "MThd";
    put_number(out, 6, 4);
    put_number(out, 1, 2);
    put_number(out, score.voices.size() + 1, 2);
    put_number(out, 2 * ticks_of_eighth, 2);  // of a quarter
    std::string head;
    put_text(head, 3, document.head);
    put_text(head, 0x51, std::string("\x07\xA1\x20", 3));  // half a second a quarter
    put_track(out, std::move(head));
    for (std::size_t i = 0; i < score.voices.size(); ++i) {
        const std::size_t voice = i % (channels - 1);
        const auto channel = static_cast<int>(voice < drums ? voice : voice + 1);
        std::string track;
        put_text(track, 3, document.figures[i].source->plate.name);
        std::uint64_t at = 0;
        for (const Note& note : score.voices[i]) {
            const int pitch = middle_c +
                              half_tones * (note.degree / degrees_of_octave - score.octaves_below) +
                              above_c[static_cast<std::size_t>(note.degree % degrees_of_octave)];
            for (const bool begins : {true, false}) {
                const std::uint64_t time = begins ? note.begin : note.end;
                put_delta(track, time - at);
                at = time;
                track += static_cast<char>((begins ? 0x90 : 0x80) | channel);
                track += static_cast<char>(pitch);
                track += static_cast<char>(begins ? velocity : 0);
            }
        }
        put_track(out, std::move(track));
    }
    return out;
}

}  // namespace algae
