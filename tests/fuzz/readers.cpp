// Readers of text, each with what must hold of what it reads: mostly that it is printed, and read again as the same.

#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <utility>

#include "dimension/dimension.hpp"
#include "exact/exact.hpp"
#include "exchange/exchange.hpp"
#include "fuzz/targets.hpp"
#include "growth/growth.hpp"
#include "language/language.hpp"
#include "lesson/lesson.hpp"
#include "model/model.hpp"
#include "nature/nature.hpp"
#include "notation/notation.hpp"
#include "render/render.hpp"
#include "rewrite/rewrite.hpp"
#include "word/word.hpp"

namespace algae::fuzz {

namespace {

/// Calls `again`, which reads a text that the library itself wrote: it has no faults.
template <class Again>
void is_read_again(const std::string& printed, Again again) {
    try {
        again();
    } catch (const Error& error) {
        throw Broken("what was printed is not read again: " + std::string(error.what()) + "\n" +
                     printed);
    }
}

Model gallery_system(const std::string& name) {
    static std::map<std::string, Model> known;
    if (const auto found = known.find(name); found != known.end()) return found->second;
    for (const GalleryEntry& entry : gallery())
        if (entry.name == name) return known[name] = read_lsystem(entry.text, name);
    throw Error("there is no " + name + " in the gallery");
}

void take_lsystem(std::string_view text) {
    const Model system = read_lsystem(text, "x.lsys");
    const std::string printed = print_lsystem(system);
    is_read_again(printed, [&] {
        const Model again = read_lsystem(printed, "y.lsys");
        expect(again == system, "the canonical text says another system:\n" + printed);
        expect(print_lsystem(again) == printed, "the canonical text has another one:\n" + printed);
    });
}

void take_format(std::string_view text) {
    const std::string once = format_lsystem(text, "x.lsys");
    is_read_again(once, [&] {
        const std::string twice = format_lsystem(once, "y.lsys");
        expect(once == twice, "formatting twice is not formatting once:\n" + once + "\n" + twice);
    });
}

void take_word(std::string_view text) {
    Alphabet alphabet;
    const ModuleWord word = read_word(text, alphabet);
    const std::string printed = print_word(alphabet, word);
    is_read_again(printed, [&] {
        const std::size_t letters = alphabet.size();
        expect(read_word(printed, alphabet) == word && alphabet.size() == letters,
               "it reads back as another word: " + printed);
    });
}

void take_expression(std::string_view text) {
    const Expression expression = read_expression(text);
    const std::string printed = to_text(expression);
    is_read_again(printed, [&] {
        expect(read_expression(printed) == expression, "another expression: " + printed);
    });
    static const Names names = {};
    evaluate(expression, names);
}

void take_claim(std::string_view text) { read_claim(text, "x.claim", gallery_system); }

void take_language(std::string_view text) {
    const WrittenLanguage written = read_language(text, gallery_system);
    to_string(written.language, *written.alphabet);
}

void take_own_statement(std::string_view text) {
    is_own_statement(text, false);
    if (!is_own_statement(text, true)) return;
    try {
        read_own_statement(text);
    } catch (const SyntaxError& error) {
        expect(error.where >= text.data() && error.where <= text.data() + text.size(),
               "an error stands in the text");
    }
}

void take_markdown(std::string_view text) {
    for (const Fence& fence : fences(text)) region_of(fence.text, fence.name);
    claim_clauses(text);
}

/// The fenced blocks of lessons, as they stand.
Texts markdown_seeds() {
    Texts texts;
    for (const std::string& lesson : files({"lessons"}, ".md")())
        for (const Fence& fence : fences(lesson))
            texts.push_back("```" + fence.kind + " name=" + fence.name + "\n" +
                            std::string(fence.text) + "```\n");
    return texts;
}

/// Expectations are checked: the system is derived, and its turtle walks.
void take_expectations(std::string_view text) {
    unmet_expectations(read_lsystem(text, "x.lsys"), small_budget());
}

void take_rewriting(std::string_view text) {
    const Model system = read_lsystem(text, "x.lsys");
    const Budget budget = small_budget();
    const Rewriting rewriting(system, {}, budget);
    ModuleString word = rewriting.axiom();
    for (std::uint64_t n = 0; n < 3; ++n)
        word = rewriting.next(word, n, rewriting.own_table(n), budget);
}

void take_dimension(std::string_view text) {
    exact_dimension(read_lsystem(text, "x.lsys"), small_budget());
}

Target generator_target(const GeneratorKind& kind) {
    const std::string name = "x." + kind.ending;
    return {kind.ending, "file: " + kind.what,
            [name](std::string_view text) {
                read_generator(text, name);
                const std::string once = format_generator(text, name);
                is_read_again(once, [&] {
                    expect(format_generator(once, name) == once,
                           "formatting twice is not formatting once:\n" + once);
                });
            },
            files({"figures", "examples"}, "." + kind.ending), 600};
}

Target system_format_target(const SystemFormat& format) {
    return {format.name, "file: " + format.what,
            [&format](std::string_view text) {
                const Model system = format.read(text, "x." + format.name);
                print_lsystem(system);
                const std::string printed = format.print(system);
                is_read_again(printed, [&] {
                    // What a file leaves out may be written, such as how often its rules are applied.
                    const Model again = format.read(printed, "y." + format.name);
                    expect(again == system || format.print(again) == printed,
                           "it reads back as another system:\n" + printed);
                });
            },
            files({"examples"}, "." + format.name), 4096};
}

Target generator_format_target(const GeneratorFormat& format) {
    return {format.name, "file: " + format.what,
            [&format](std::string_view text) {
                const GeneratorFile file = format.read(text, "x." + format.name);
                read_generator(print_generator_file(file), "x." + format.kind);
            },
            files({"examples"}, "." + format.name)};
}

/// The first byte chooses the conversion, the others are the text.
void take_conversion(std::string_view bytes) {
    static const std::vector<Conversion> all = conversions();
    Bytes choices(bytes);
    const Conversion& chosen = all[choices.below(all.size())];
    converted(choices.rest(), "x." + chosen.from, chosen.from, chosen.to, small_budget());
}

/// Files of all kinds before which the byte of each conversion from there stands.
Texts conversion_seeds() {
    Texts texts;
    const std::vector<Conversion> all = conversions();
    for (std::size_t i = 0; i < all.size(); ++i) {
        Texts found = files({"examples", "figures"}, "." + all[i].from)();
        if (found.size() > 12) found.resize(12);
        for (const std::string& text : found) texts.push_back(static_cast<char>(i) + text);
    }
    return texts;
}

const std::vector<Exercise>& exercises() {
    static const std::vector<Exercise> all = [] {
        std::vector<Exercise> found;
        for (const GalleryEntry& entry : exercise_texts())
            found.push_back(read_exercise(entry.text, std::string(entry.name)));
        return found;
    }();
    return all;
}

void take_exercise(std::string_view text) {
    const Exercise exercise = read_exercise(text, "01-2");
    task_text(exercise);
    check_exercise(exercise, gallery_system, true);
}

/// The first byte chooses the exercise, the others are the answer.
void take_answer(std::string_view bytes) {
    Bytes choices(bytes);
    const Exercise& exercise = exercises()[choices.below(exercises().size())];
    const Mark marked =
        mark(exercise, std::string(choices.rest()), "answer", gallery_system, small_budget());
    expect(!report(exercise, marked).empty(), "there is a report");
}

Texts answer_seeds() {
    Texts texts;
    for (std::size_t i = 0; i < exercises().size(); ++i) {
        const std::string key = exercises()[i].file.substr(0, exercises()[i].file.find('.'));
        for (const char* ending : {".txt", ".lsys", ".claim"})
            for (const std::string& text : files({"lessons/answers"}, key + ending)())
                texts.push_back(static_cast<char>(i) + text);
    }
    return texts;
}

void take_points(std::string_view text) {
    const PointSet points = read_points(text, "x.csv");
    for (const auto& point : points.points)
        for (const double number : point) expect(std::isfinite(number), "a point is finite");
    longest_side(points);
}

void take_point_measures(std::string_view text) {
    const PointSet points = read_points(text, "x.csv");
    const Budget budget = small_budget();
    box_counts(points, 4, 1, budget);
    mass(points, {}, budget);
    correlation(points, {}, budget);
}

void take_view(std::string_view text) {
    static const Model system = read_lsystem("axiom F+F&F; camera -90 90", "x.lsys");
    const Model shown = with_cpfg_view(system, text, "x.v");
    expect(shown.rules == system.rules, "a view changes rules");
}

Texts view_seeds() {
    return {"angle increment: 22.5\ninitial line width: 2 pixels\nviewpoint: 0 -1 1\n",
            "#define A 4\nangle factor: A*4 // parts\nprojection: perspective\n",
            "tropism: T: 0 -1 0 E: 0\nline width increment: 0\n"};
}

Texts point_seeds() {
    return {"x, y\n0, 0.5\n1 -2e3\n", "0 0\n1 0\n0 1\n1 1\n", "0;0;0\n1;2;3\n# not a point\n",
            "1\n2\n3.5\n-4e-3\n", "x\ty\n1e300\t-1e300\n0\t0\n"};
}

void take_specification(std::string_view text) {
    const SequenceSpecification read = read_specification(std::string(text));
    const auto values = read.values(8);
    if (read.coefficients.size() > 4 || values.empty()) return;
    const Realisation realised = realise(read, small_budget());
    if (realised.kind != Realisation::Kind::found) return;
    const auto found = lengths(*realised.system, 8);
    const auto wanted = read.values(8 + realised.shift);
    for (std::size_t n = 0; n < 8; ++n)
        expect(Rational(found[n]) == wanted[n + realised.shift], "the system has other lengths");
}

Texts specification_seeds() {
    return {"n^2+1",
            "1,1,2,3,5,8",
            "a(n) = a(n-1) + a(n-2); 1, 1",
            "(n^3+5n+6)/6",
            "2^n",
            "1, 2, 4, 8, ...",
            "a(n) = 3a(n-1) - 2a(n-2) + a(n-3) for n >= 3; 1, 2, 5"};
}

void take_image(std::string_view bytes) {
    if (is_png(bytes)) ink_of(bytes, "x.png", {}, small_budget());
}

/// Two pixels by two, black and white in turns.
Texts image_seeds() {
    constexpr unsigned char image[] = {
        0x89, 'P',  'N',  'G',  '\r', '\n', 0x1a, '\n', 0,   0,    0,    13,   'I',  'H',
        'D',  'R',  0,    0,    0,    2,    0,    0,    0,   2,    8,    0,    0,    0,
        0,    0x57, 0xdd, 0x52, 0xf8, 0,    0,    0,    12,  'I',  'D',  'A',  'T',  0x78,
        0x9c, 0x63, 0x60, 0xf8, 0x0f, 0x84, 0,    0x06, 0,   0x01, 0xff, 0x93, 0xd1, 0xe4,
        0x89, 0,    0,    0,    0,    'I',  'E',  'N',  'D', 0xae, 0x42, 0x60, 0x82};
    return {std::string(std::begin(image), std::end(image))};
}

/// What stands behind the equals sign of these lines.
std::function<Texts()> values(std::function<Texts()> lines) {
    return [lines] {
        Texts found;
        for (const std::string& line : lines())
            if (const auto at = line.find("= "); at != std::string::npos)
                found.push_back(line.substr(at + 2));
        return found;
    };
}

void take_checkpoint_line(std::string_view text) {
    const std::string line(text);
    if (const auto chunk = census_chunk(line)) {
        const std::string written = census_line(*chunk);
        const auto again = census_chunk(written);
        expect(again.has_value(), "it is read again: " + written);
        expect(census_line(*again) == written, "it is written again: " + written);
    }
}

Texts checkpoint_seeds() {
    CensusChunk chunk;
    Texts texts{census_line(chunk)};
    chunk.number = 7;
    chunk.size = 3;
    texts.push_back(census_line(chunk));
    return texts;
}

}  // namespace

std::vector<Target> readers() {
    const std::vector<std::string> systems{"figures", "systems", "examples"};
    std::vector<Target> all{
        {"lsystem", "system files, read, printed and read again", take_lsystem,
         files(systems, ".lsys")},
        {"format", "system files with comments, formatted twice", take_format,
         files(systems, ".lsys")},
        {"word", "words", take_word, lines(systems, ".lsys", "axiom "), 256},
        {"expression", "expressions and their values", take_expression,
         values(lines({"figures"}, ".lsys", "let ")), 256},
        {"claim", "claim files", take_claim, files({"theory"}, ".claim")},
        {"language", "languages as claims write them", take_language,
         values(lines({"theory", "lessons/exercises"}, "", "let ")), 256},
        {"own-statement", "statements of exercises' own", take_own_statement,
         lines({"lessons/exercises"}, ".exercise", "show"), 256},
        {"exercise", "exercise files", take_exercise, files({"lessons/exercises"}, ".exercise"),
         800},
        {"answer", "answers to exercises, marked", take_answer, answer_seeds},
        {"markdown", "fences of lessons, clauses of claims", take_markdown, markdown_seeds, 600},
        {"expectations", "system files, with what they expect", take_expectations,
         files(systems, ".lsys")},
        {"rewriting", "system files, derived for three steps", take_rewriting,
         files(systems, ".lsys")},
        {"dimension", "system files, with the dimension of their limit", take_dimension,
         files({"figures"}, ".lsys")},
        {"convert", "files of all formats into each other", take_conversion, conversion_seeds, 800},
        {"view", "view files of cpfg", take_view, view_seeds, 256},
        {"points", "points of a text", take_points, point_seeds},
        {"measures", "box counts, mass and correlation of points", take_point_measures, point_seeds,
         256},
        {"specification", "sequences, and systems of such growth", take_specification,
         specification_seeds, 128},
        {"image", "the ink of PNG images", take_image, image_seeds, 512},
        {"checkpoint", "lines of checkpoints of a census", take_checkpoint_line, checkpoint_seeds},
    };
    for (const GeneratorKind& kind : generator_kinds()) all.push_back(generator_target(kind));
    for (const SystemFormat& format : system_formats()) all.push_back(system_format_target(format));
    for (const GeneratorFormat& format : generator_formats())
        all.push_back(generator_format_target(format));
    return all;
}

}  // namespace algae::fuzz
