// Readers of text, each with what must hold of what it reads: mostly that it is printed, and read again as the same.

#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <utility>

#include "automatic/automatic.hpp"
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
#include "studio/studio.hpp"
#include "system/system.hpp"
#include "turtle/turtle.hpp"
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

/// Whether two systems derive the same words, as far as a small budget goes.
bool derive_alike(const Model& one, const Model& other) {
    try {
        const Budget budget = small_budget();
        const Rewriting left(one, {}, budget), right(other, {}, budget);
        const ModuleText left_text(left.rules().system->alphabet, left.rules().kinds);
        const ModuleText right_text(right.rules().system->alphabet, right.rules().kinds);
        ModuleString left_word = left.axiom(), right_word = right.axiom();
        for (std::uint64_t n = 0; n < 3; ++n) {
            if (left_text.text(left_word) != right_text.text(right_word)) return false;
            left_word = left.next(left_word, n, left.own_table(n), budget);
            right_word = right.next(right_word, n, right.own_table(n), budget);
        }
    } catch (const Stopped&) {
    } catch (const Error&) {  // where a parameter has no value
    }
    return true;
}

Target system_format_target(const SystemFormat& format) {
    return {
        format.name, "file: " + format.what,
        [&format](std::string_view text) {
            const Model system = format.read(text, "x." + format.name);
            print_lsystem(system);
            const std::string printed = format.print(system);
            is_read_again(printed, [&] {
                // What a file leaves out may be written, such as how often its rules are applied; what the format cannot say, such as
                // a colour or some signs of a title, is left out once and no more; and conditions may say again that an earlier rule
                // does not apply.
                const Model again = format.read(printed, "y." + format.name);
                const std::string printed_again = format.print(again);
                expect(again == system || printed_again == printed ||
                           format.print(format.read(printed_again, "z." + format.name)) ==
                               printed_again ||
                           derive_alike(again, system),
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
            "tropism: T: 0 -1 0 E: 0.2\nline width increment: 0\n"};
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

void take_typed_system(std::string_view text) {
    is_typed_system(text);
    const Model system = read_typed_system(text, "typed");
    const std::string printed = print_lsystem(system);
    is_read_again(printed, [&] {
        expect(read_lsystem(printed, "y.lsys") == system, "another system: " + printed);
    });
}

/// The rules of systems on one line, with commas between.
Texts typed_seeds() {
    Texts texts{"a->ab, b->a", "0->01,1->10", "axiom b, a -> ab, b -> a", "A(x) -> A(x+1) B(x,2)"};
    for (std::string text : files({"figures", "systems"}, ".lsys")())
        if (text.size() < 300) {
            std::ranges::replace(text, '\n', ';');
            texts.push_back(std::move(text));
        }
    return texts;
}

void take_b_file(std::string_view text) {
    const BFile file = read_b_file(text, "b000001.txt");
    std::string printed;
    Integer n = file.first;
    for (const Integer& term : file.terms) {
        printed += to_string(n) + ' ' + to_string(term) + '\n';
        n += 1;
    }
    is_read_again(printed, [&] {
        expect(read_b_file(printed, "b000002.txt").terms == file.terms, "other terms: " + printed);
    });
}

Texts b_file_seeds() {
    return {"0 1\n1 1\n2 2\n3 3\n4 5\n", "# A000079\n-1 0\n0 1\n1 2 # two\n2 4\n",
            "1 -3\n2 99999999999999999999\n\n3 0\n"};
}

void take_first_order(std::string_view text) {
    static const std::vector<std::string> letters{"0", "1", "a"};
    static const Model system = read_lsystem("axiom a; a -> ab; b -> ba", "x.lsys");
    static const AutomaticWord word = automatic_word(*as_d0l(system), [](Symbol letter) {
        return std::string(1, system.alphabet.name(letter) == "a" ? '0' : '1');
    });
    const FirstOrderStatement statement = read_first_order(text, "statement", "T", letters);
    if (text.size() < 48)
        decide_first_order(read_first_order(text, "statement", "T", word.letters), word,
                           small_budget());
    expect(statement.free().size() < 256, "few variables are free");
}

Texts first_order_seeds() {
    return {"for all i, n with n >= 1: not (for all k < n: T[i+k] = T[i+n+k])",
            "for some i: T[i] = 0",
            "for all i: there is k: T[i+k] = T[2i] and k > 0",
            "equal(i, i+n, n) implies n < 3 or T[i] != 1",
            "for some i with palindrome(i, 4): i > 2 iff T[i] = T[i+3]",
            "not T[0] = 1"};
}

void take_cpfg_files(std::string_view text) {
    try {
        cpfg_frames(text, "x.a");
    } catch (const Diagnostics&) {  // a file of the other kind
    }
    const CpfgFiles files = cpfg_files(text, "specifications");
    expect(files.view.find('/') == std::string::npos, "the names have no folder");
}

Texts cpfg_files_seeds() {
    return {"cpfg -m a.map a.l b.v\n", "cpfg -m plant.map plant.l plant.v plant.a\n",
            "#!/bin/sh\ncpfg -homo dir/x.l y.v -n 3\n", "first frame: 1\nlast frame: 20\n",
            "swap interval: 5\nstep: 2\nfirst frame: 0\nlast frame: 4 // all\n"};
}

/// Whatever a format is taken for, its reader takes the text.
void take_any_format(std::string_view text) {
    if (const SystemFormat* format = system_format_of(text))
        print_lsystem(format->read(text, "x." + format->name));
}

Texts any_format_seeds() {
    Texts texts;
    for (const SystemFormat& format : system_formats())
        for (const std::string& text : files({"examples"}, "." + format.name)())
            texts.push_back(text);
    return texts;
}

void take_colour(std::string_view text) {
    const Colour colour = colour_named(text);
    for (const double part : {colour.red, colour.green, colour.blue})
        expect(part >= 0 && part <= 1, "a colour has parts from 0 to 1");
    if (!is_scheme(text)) return;
    for (const double part : {0.0, 0.5, 1.0}) scheme_colour(text, part);
}

Texts colour_seeds() {
    return {"#080", "#008000", "darkgreen", "DarkGreen", "#ff0000", "rebeccapurple", "viridis"};
}

/// The tables of each step, for a system with three of them.
void take_table_sequence(std::string_view text) {
    static const std::vector<std::string> names{"light", "dark", "x"};
    for (const std::size_t table : table_sequence(names, std::string(text)))
        expect(table < names.size(), "there are three tables");
}

Texts table_sequence_seeds() { return {"light,dark,dark", "xx", "121", "x,light", "ldx", "1,2,3"}; }

/// What a page asks to see of a system that a stranger wrote.
void take_view_of_page(std::string_view text) {
    const Model system = read_lsystem(text, "x.lsys");
    const Budget budget = small_budget();
    FigureQuestion question;
    question.generation = 2;
    question.most_strokes = 500;
    const auto stops = [](const auto& view) {
        try {
            view();
        } catch (const Stopped&) {
        } catch (const Error&) {  // of what a figure may be
        }
    };
    stops([&] { figure_view(system, question, budget); });
    stops([&] { derivation_view(system, 2, std::nullopt, 200, budget); });
    stops([&] { walk_view(system, 2, std::nullopt, 200, budget); });
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
        {"typed", "systems on one line", take_typed_system, typed_seeds, 256},
        {"b-file", "b-files of the OEIS", take_b_file, b_file_seeds, 256},
        {"first-order", "first-order statements about a word, the short ones decided",
         take_first_order, first_order_seeds, 160},
        {"cpfg-files", "files beside a system of cpfg: what they name, the frames", take_cpfg_files,
         cpfg_files_seeds, 256},
        {"any-format", "files of any format, by the reader of the one it is taken for",
         take_any_format, any_format_seeds, 800},
        {"colour", "names and codes of colours", take_colour, colour_seeds, 40},
        {"tables", "sequences of tables", take_table_sequence, table_sequence_seeds, 64},
        {"page", "system files, as a page sees them", take_view_of_page, files(systems, ".lsys")},
    };
    for (const GeneratorKind& kind : generator_kinds()) all.push_back(generator_target(kind));
    for (const SystemFormat& format : system_formats()) all.push_back(system_format_target(format));
    for (const GeneratorFormat& format : generator_formats())
        all.push_back(generator_format_target(format));
    return all;
}

}  // namespace algae::fuzz
