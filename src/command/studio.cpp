// `algae studio`: a page in a browser, served to this machine or to a lecture hall, and the questions that the page may ask.
//
// A question is one object of JSON: its name, the text of a system or of a claim, and a few values. Most of them become a command line of
// a verb, which then runs as if a person had typed it, its text on standard input and its report on standard output: so the page says
// what the command says. What stands on that line is written here; of the page's values it has numbers, words behind an = or after --,
// and names that the gallery has. No question names a file but `open`, and that one is looked for in the folder of the studio.
//
// All of this happens in a process that has only this question (src/studio/workers.cpp), so what goes wrong in it is an answer too.

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>

#include "command/detail/files.hpp"
#include "command/detail/marking.hpp"
#include "command/detail/memory.hpp"
#include "command/detail/output.hpp"
#include "command/detail/verb.hpp"
#include "exact/exact.hpp"
#include "lesson/lesson.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "studio/studio.hpp"

namespace algae::command {

namespace {

using nlohmann::json;
using Line = std::vector<std::string>;

struct Options {
    std::string folder, host = "127.0.0.1", token;
    std::uint64_t port = 0;
    std::optional<std::uint64_t> at_once;
    bool ask = false;
    Bounds bounds;
};

/// What every question may use.
struct Surroundings {
    std::filesystem::path folder;
    StudioShare share;
};

/// A question with its values; a value of another kind than expected is an Error.
class Question {
public:
    Question(const json& said, const Surroundings& given) : around(given), said_(said) {
        if (!said.is_object()) throw Error("expected a question as an object of JSON");
        deadline_ = std::chrono::steady_clock::now() +
                    std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                        std::chrono::duration<double>(seconds()));
    }

    std::string text(const char* name) const {
        const auto found = said_.find(name);
        if (found == said_.end()) throw Error(std::string("the question has no \"") + name + '"');
        if (!found->is_string()) refuse(name, "a text");
        return *found;
    }
    std::string text_or(const char* name, const std::string& otherwise) const {
        return said_.contains(name) ? text(name) : otherwise;
    }
    std::optional<std::uint64_t> count(const char* name) const {
        const auto found = said_.find(name);
        if (found == said_.end() || found->is_null()) return std::nullopt;
        if (!found->is_number_unsigned()) refuse(name, "a whole number from 0 on");
        return found->get<std::uint64_t>();
    }
    bool has(const char* name) const { return said_.contains(name); }
    bool flag(const char* name) const {
        const auto found = said_.find(name);
        if (found == said_.end()) return false;
        if (!found->is_boolean()) refuse(name, "true or false");
        return *found;
    }
    /// Some finite numbers; nothing if there are none.
    std::optional<std::vector<double>> numbers(const char* name, std::size_t size) const {
        const auto found = said_.find(name);
        if (found == said_.end() || found->is_null()) return std::nullopt;
        std::vector<double> values;
        if (found->is_array())
            for (const json& one : *found)
                if (one.is_number() && std::isfinite(one.get<double>())) values.push_back(one);
        if (values.size() != size) refuse(name, std::to_string(size) + " numbers");
        return values;
    }
    /// One of some words.
    std::string word(const char* name, const std::vector<std::string>& words) const {
        std::string chosen = text(name);
        if (std::ranges::find(words, chosen) == words.end())
            refuse(name, "one of " + joined(words, ", "));
        return chosen;
    }
    /// The constants that replace those of the system.
    Line constants() const {
        Line all;
        const auto found = said_.find("let");
        if (found == said_.end()) return all;
        if (!found->is_object()) refuse("let", "an object of names and values");
        for (const auto& [name, value] : found->items()) {
            if (!value.is_string()) refuse("let", "values that are texts");
            all.push_back(name + "=" + value.get<std::string>());
        }
        return all;
    }
    /// The system as a verb's FILE: a name of the gallery, or "-" for the text.
    std::string file() const {
        if (!said_.contains("name")) return "-";
        const std::string name = text("name");
        const std::vector<std::string> names = gallery_names();
        if (std::ranges::find(names, name) == names.end())
            refuse("name", "a name from the gallery");
        return name;
    }
    Model system() const {
        const std::string name = file();
        return open_model(name, budget(), constants());
    }
    double seconds() const {
        const double most = around.share.seconds;
        const auto asked = said_.find("seconds");
        if (asked == said_.end() || !asked->is_number()) return most;
        const double value = *asked;
        return value > 0 && value < most ? value : most;
    }
    Budget budget() const {
        Budget budget;
        budget.memory = around.share.memory;
        budget.deadline = deadline_;
        budget.stop = &stop;
        return budget;
    }

    const Surroundings& around;

private:
    [[noreturn]] void refuse(const std::string& name, const std::string& expected) const {
        throw Error(
            '"' + name + "\": expected " + expected + ", found " +
            said_[name].dump(-1, ' ', false, json::error_handler_t::replace).substr(0, 100));
    }

    const json& said_;
    std::chrono::steady_clock::time_point deadline_;
};

/// Makes a text the standard input: a pipe, which a thread fills, as a worker writes no file. The engine of a static page has no threads,
/// and its files are memory.
void give_input(const std::string& text) {
#ifdef __EMSCRIPTEN__
    constexpr const char* place = "/input";
    std::FILE* const file = std::fopen(place, "wb");
    if (!file || std::fwrite(text.data(), 1, text.size(), file) != text.size() ||
        std::fclose(file) != 0 || !std::freopen(place, "rb", stdin))
        throw Error("the text cannot be given to the verb");
#else
    int ends[2];
    if (::pipe(ends) != 0) throw Error("the system gives no pipe for a text");
    ::dup2(ends[0], STDIN_FILENO);
    ::close(ends[0]);
    std::thread([text, end = ends[1]] {
        for (std::size_t done = 0; done < text.size();) {
            const ssize_t count = ::write(end, text.data() + done, text.size() - done);
            if (count <= 0) break;
            done += static_cast<std::size_t>(count);
        }
        ::close(end);
    }).detach();
#endif
}

/// Runs a verb with the bounds of the question; `behind` are arguments that may look like options.
int run_verb(const Question& question, Line line, const Line& behind = {}) {
    line.insert(line.begin(), "algae");
    line.insert(line.end(), {"--max-memory", std::to_string(question.around.share.memory),
                             "--timeout", fmt::format("{:.3f}", question.seconds())});
    if (!behind.empty()) line.emplace_back("--");
    line.insert(line.end(), behind.begin(), behind.end());
    std::vector<char*> words;
    for (std::string& word : line) words.push_back(word.data());
    words.push_back(nullptr);
    return run_command(static_cast<int>(line.size()), words.data());
}

/// A verb that takes a system: its FILE, the constants, then `more`.
int ask_system(const Question& question, const std::string& verb, const Line& more,
               const Line& behind = {}) {
    Line line{verb};
    for (const std::string& constant : question.constants())
        line.insert(line.end(), {"--let", constant});
    line.insert(line.end(), more.begin(), more.end());
    Line files{question.file()};
    files.insert(files.end(), behind.begin(), behind.end());
    return run_verb(question, std::move(line), files);
}

Line with_generation(const Question& question, Line line) {
    if (const auto n = question.count("n")) line.insert(line.end(), {"-n", std::to_string(*n)});
    if (const auto seed = question.count("seed"))
        line.insert(line.end(), {"--seed", std::to_string(*seed)});
    return line;
}

std::uint64_t generation_of(const Question& question, const Model& system) {
    if (const auto n = question.count("n")) return *n;
    if (system.drawing.generations) return system.drawing.generations->second;
    constexpr std::uint64_t usual = 3;  // enough to see what a system does
    return usual;
}

// The questions. Each writes its answer to standard output and returns an exit status.

/// Whether a page may open a file of the folder, by the end of its name.
bool is_document(const std::filesystem::path& file) {
    const std::string end = file.extension().string();
    return end == ".lsys" || end == ".claim" || end == ".exercise";
}

int start(const Question& question) {
    json files = json::array();
    if (!question.around.folder.empty()) {
        constexpr std::size_t most = 1000;
        std::vector<std::string> names;
        std::error_code failed;
        for (const auto& entry :
             std::filesystem::directory_iterator(question.around.folder, failed)) {
            if (is_document(entry.path()) && entry.is_regular_file(failed) && names.size() < most)
                names.push_back(entry.path().filename().string());
        }
        std::ranges::sort(names);
        for (const std::string& name : names) files.push_back(name);
    }
    json claims = json::array();
    for (const GalleryEntry& entry : theory_claims()) claims.push_back(entry.path);
    const json out{{"version", ALGAE_VERSION},
                   {"files", files},
                   {"claims", claims},
                   {"seconds", question.around.share.seconds},
                   {"memory", question.around.share.memory}};
    print(out.dump(-1, ' ', false, json::error_handler_t::replace));
    return success;
}

/// The text of a file in the folder of the studio, or of the gallery, or of a claim that comes with algae.
int open_source(const Question& question) {
    const std::string name = question.text("file");
    const std::string from = question.word("from", {"folder", "gallery", "theory"});
    std::string text;
    const auto embedded = [&](std::span<const GalleryEntry> entries) {
        for (const GalleryEntry& entry : entries)
            if (entry.name == name || entry.path == name) {
                text = entry.text;
                return;
            }
        throw Error("there is nothing called " + algae::quoted(name));
    };
    if (from == "gallery") {
        embedded(gallery());
    } else if (from == "theory") {
        embedded(theory_claims());
    } else {
        // One name, of a file that lies in the folder itself, wherever links lead.
        const auto refuse = [&] {
            throw Error(
                algae::quoted(name) +
                ": expected the name of a .lsys, .claim or .exercise file in the folder of the "
                "studio");
        };
        const std::filesystem::path path(name);
        if (question.around.folder.empty() || path.filename() != path || name.starts_with('.') ||
            !is_document(path))
            refuse();
        std::error_code failed;
        const auto whole = std::filesystem::canonical(question.around.folder / path, failed);
        if (failed || whole.parent_path() != question.around.folder ||
            !std::filesystem::is_regular_file(whole, failed))
            refuse();
        text = file_text(whole.string(), question.budget());
    }
    const json out{{"text", text}};
    print(out.dump(-1, ' ', false, json::error_handler_t::replace));
    return success;
}

/// One request of an editor, answered by `algae lsp`.
int ask_editor(const Question& question) {
    const std::string kind = question.word("kind", {"lsys", "claim"});
    const std::string method =
        question.word("method", {"diagnostics", "completion", "hover", "formatting"});
    const std::string name = "typed." + kind;  // in the folder of the studio
    std::string input;
    const auto send = [&](const json& message) {
        const std::string text = message.dump(-1, ' ', false, json::error_handler_t::replace);
        input += "Content-Length: " + std::to_string(text.size()) + "\r\n\r\n" + text;
    };
    send({{"method", "textDocument/didOpen"},
          {"params", {{"textDocument", {{"uri", name}, {"text", question.text("text")}}}}}});
    if (method != "diagnostics")
        send({{"id", 1},
              {"method", "textDocument/" + method},
              {"params",
               {{"textDocument", {{"uri", name}}},
                {"position",
                 {{"line", question.count("line").value_or(0)},
                  {"character", question.count("character").value_or(0)}}}}}});
    give_input(input);
    return run_verb(question, {"lsp"});
}

int show_system(const Question& question) { return ask_system(question, "show", {"--json"}); }

/// What the page needs of a system before it asks for more: whether it can be drawn and derived, and which generation it shows.
int describe(const Question& question) {
    const Model system = question.system();
    json out{{"name", system.name}, {"title", system.title}, {"source", system.source}};
    out["generations"] = nullptr;
    if (const auto& shown = system.drawing.generations)
        out["generations"] = {shown->first, shown->second};
    out["seeds"] = nullptr;
    if (const auto& seeds = system.drawing.seeds) out["seeds"] = {seeds->first, seeds->second};
    out["angle"] = nullptr;
    if (const auto& angle = system.drawing.angle)
        out["angle"] = {{"value", angle->value}, {"written", to_text(angle->expression)}};
    json constants = json::array();
    for (const auto& [name, value] : system.constants)
        constants.push_back(
            {{"name", name}, {"written", to_text(value.expression)}, {"value", value.value}});
    out["constants"] = std::move(constants);
    const Class kind = class_of(system);
    out["class"] = kind.name();
    out["shape"] = kind.shape;
    out["d0l"] = static_cast<bool>(as_d0l(system));
    out["chance"] = kind.stochastic || (!as_d0l(system) && as_ol(system)) ||
                    (!system.tables.empty() && system.schedule.empty());
    out["space"] = leaves_plane(system);
    out["canonical"] = print_lsystem(system);
    print(out.dump(-1, ' ', false, json::error_handler_t::replace));
    return success;
}

int view_figure(const Question& question) {
    const Model system = question.system();
    FigureQuestion asked;
    asked.generation = generation_of(question, system);
    asked.seed = question.count("seed");
    if (const auto part = question.numbers("part", 4))
        asked.part = FigureQuestion::Part{(*part)[0], (*part)[1], (*part)[2], (*part)[3]};
    constexpr std::uint64_t finest = 8000, fewest = 10, most = 2'000'000;
    asked.pixels = static_cast<double>(
        std::clamp(question.count("pixels").value_or(1000), std::uint64_t{1}, finest));
    asked.most_strokes =
        std::clamp(question.count("most").value_or(asked.most_strokes), fewest, most);
    print(figure_view(system, asked, question.budget()));
    return success;
}

int view_derivation(const Question& question) {
    constexpr std::uint64_t most = 200'000;
    const Model system = question.system();
    print(derivation_view(system, generation_of(question, system), question.count("seed"),
                          std::min(question.count("most").value_or(20'000), most),
                          question.budget()));
    return success;
}

int view_walk(const Question& question) {
    constexpr std::uint64_t most = 20'000;
    const Model system = question.system();
    print(walk_view(system, generation_of(question, system), question.count("seed"), most,
                    question.budget()));
    return success;
}

int ask_growth(const Question& question) { return ask_system(question, "growth", {"--json"}); }
int ask_factors(const Question& question) {
    return ask_system(question, "growth", {"--words", "--json"});
}
int ask_growth_latex(const Question& question) {
    return ask_system(question, "growth", {"--latex"});
}
int ask_letters(const Question& question) {
    return ask_system(question, "tree", {"--graph", "--format", "dot", "-o", "-"});
}
int ask_dimension(const Question& question) {
    return ask_system(question, "dimension", with_generation(question, {"--json"}));
}
int ask_word(const Question& question) {
    return ask_system(question, "member", {"--json"}, {question.text("word")});
}
int ask_list(const Question& question) {
    return ask_system(
        question, "derive",
        {"--all-words", "--longest",
         std::to_string(std::min<std::uint64_t>(question.count("longest").value_or(12), 60)),
         "--json"});
}
int ask_finite(const Question& question) { return ask_system(question, "finite", {"--json"}); }

int ask_gallery(const Question&) {
    return run_command(
        3, std::array<char*, 4>{const_cast<char*>("algae"), const_cast<char*>("gallery"),
                                const_cast<char*>("--json"), nullptr}
               .data());
}

int ask_picture(const Question& question) {
    const std::string format =
        question.word("format", {"svg", "pdf", "png", "eps", "tex", "typ", "csv", "geojson", "dxf",
                                 "html", "gif", "webp", "glb", "obj", "ply", "stl", "x3d"});
    Line line = with_generation(question, {"--format", format, "-o", "-"});
    if (const auto width = question.count("width"))
        line.insert(line.end(),
                    {"--width", std::to_string(std::clamp<std::uint64_t>(*width, 16, 8000))});
    return ask_system(question, "draw", line);
}

int ask_claims(const Question& question) {
    give_input(question.text("text"));
    Line line{"check", "--json"};
    if (const auto instances = question.count("instances"))
        line.insert(line.end(), {"--instances", std::to_string(*instances)});
    return run_verb(question, line, {"-"});
}

/// The certificate alone: what the verb prints besides goes nowhere. A worker writes no file, so its certificate goes to where the answer
/// goes; the engine of a static page has files of its own, and no names for what is open.
int ask_certificate(const Question& question) {
    give_input(question.text("text"));
    const int answer = ::dup(STDOUT_FILENO), nowhere = ::open("/dev/null", O_WRONLY);
    ::dup2(nowhere, STDOUT_FILENO);
#ifdef __EMSCRIPTEN__
    const std::string place = "/certificate";
#else
    const std::string place = "/dev/fd/" + std::to_string(answer);
#endif
    const int status = run_verb(question, {"check", "--certificate", place}, {"-"});
    ::dup2(answer, STDOUT_FILENO);
#ifdef __EMSCRIPTEN__
    if (std::filesystem::exists(place)) print(file_text(place, question.budget()));
#endif
    return status;
}

int ask_lessons(const Question& question) {
    const auto number = question.count("lesson");
    if (!number) return run_verb(question, {"lesson", "--json"});
    return run_verb(question, {"lesson", std::to_string(*number)});
}

/// The lesson as its author wrote it, for a page.
int ask_lesson_text(const Question& question) {
    const std::uint64_t number = question.count("lesson").value_or(1);
    for (const Lesson& lesson : lessons()) {
        if (lesson.number != number) continue;
        json exercises = json::array();
        for (const Exercise& exercise : lesson.exercises)
            exercises.push_back(json::parse(as_json(exercise).text()));
        const json out{
            {"title", lesson.title}, {"text", lesson.text}, {"exercises", std::move(exercises)}};
        print(out.dump(-1, ' ', false, json::error_handler_t::replace));
        return success;
    }
    throw Error("there is no lesson " + std::to_string(number));
}

/// An exercise of one's own, which the page sends as the text of its file.
Exercise own_exercise(const Question& question) {
    std::string name = question.text("file");
    if (const std::size_t end = name.rfind(".exercise"); end != std::string::npos) name.resize(end);
    const std::string text = question.text("exercise_text");
    Exercise exercise = read_exercise(text, name);
    check_exercise(exercise, systems_from({"."}, question.budget(), false), true);
    return exercise;
}

int ask_exercise(const Question& question) {
    print(as_json(own_exercise(question)).text());
    return success;
}

int ask_mark(const Question& question) {
    if (question.has("exercise_text")) {
        const Exercise exercise = own_exercise(question);
        const Mark marked = mark(exercise, question.text("text"), "the answer",
                                 systems_from({"."}, question.budget(), false), question.budget());
        print(as_json(exercise, marked).text());
        return status_of(marked.verdict);
    }
    give_input(question.text("text"));
    return run_verb(
        question,
        {"lesson", "--exercise", std::to_string(question.count("exercise").value_or(1)), "--json"},
        {std::to_string(question.count("lesson").value_or(1)), "-"});
}

struct Named {
    const char* name;
    int (*answer)(const Question&);
    bool has_system = true;  // its text is that of a system, on standard input
};

constexpr Named questions[] = {{"start", start, false},
                               {"open", open_source, false},
                               {"editor", ask_editor, false},
                               {"describe", describe},
                               {"show", show_system},
                               {"figure", view_figure},
                               {"derivation", view_derivation},
                               {"walk", view_walk},
                               {"growth", ask_growth},
                               {"factors", ask_factors},
                               {"growth-latex", ask_growth_latex},
                               {"letters", ask_letters},
                               {"dimension", ask_dimension},
                               {"member", ask_word},
                               {"list", ask_list},
                               {"finite", ask_finite},
                               {"gallery", ask_gallery, false},
                               {"picture", ask_picture},
                               {"check", ask_claims, false},
                               {"certificate", ask_certificate, false},
                               {"lessons", ask_lessons, false},
                               {"lesson", ask_lesson_text, false},
                               {"exercise", ask_exercise, false},
                               {"mark", ask_mark, false}};

int answer_json(const json& said, const Surroundings& around) {
    const Question question(said, around);
    const std::string name = question.text("question");
    for (const Named& one : questions) {
        if (name != one.name) continue;
        if (one.has_system && !said.contains("name")) give_input(question.text("text"));
        return one.answer(question);
    }
    std::vector<std::string> names;
    for (const Named& one : questions) names.emplace_back(one.name);
    throw Error("there is no question " + algae::quoted(name) + did_you_mean(name, names));
}

/// What is wrong, as verbs say it with --json.
int refuse_question(const Json& error, int status) {
    print(Json{{"error", error}}.text());
    return status;
}

int answer_question(const std::string& text, const Surroundings& around) {
    int status = bad_input;
    std::error_code ignored;
    if (!around.folder.empty()) std::filesystem::current_path(around.folder, ignored);
    try {
        bound_memory(around.share.memory);
        const json said = json::parse(text, nullptr, false);
        if (said.is_discarded()) throw Error("the question is not JSON");
        status = answer_json(said, around);
    } catch (const Diagnostics& error) {
        status = refuse_question(to_json(error.findings().front()), bad_input);
    } catch (const Stopped& stopped) {
        status = refuse_question(error_json(stopped.what()), undecided);
    } catch (const std::bad_alloc&) {
        status = refuse_question(error_json("the work needs more memory than a question may take"),
                                 undecided);
    } catch (const std::exception& error) {
        status = refuse_question(error_json(printable(error.what())), bad_input);
    }
    std::cout.flush();
    std::fflush(stdout);
    std::fflush(stderr);
    return status;
}

/// Goes to a folder that is there for nobody: names of files lead nowhere from it.
void enter_empty_place() {
    std::error_code failed;
    const std::filesystem::path temporary = std::filesystem::temp_directory_path(failed);
    if (failed)
        throw Error("cannot use the folder for temporary files, which TMPDIR names: " +
                    failed.message());
    std::string folder = (temporary / "algae-studio-XXXXXX").string();
    if (!::mkdtemp(folder.data())) throw Error("cannot make a folder in " + folder);
    const bool is_there = ::chdir(folder.c_str()) == 0;
    ::rmdir(folder.c_str());
    if (!is_there) throw Error("cannot enter " + folder);
}

/// One question from standard input, answered without a server.
int ask_once(const Surroundings& around) {
    std::string question;
    std::array<char, 1 << 16> piece{};
    for (;;) {
        const ssize_t count = ::read(STDIN_FILENO, piece.data(), piece.size());
        if (count <= 0) break;
        question.append(piece.data(), static_cast<std::size_t>(count));
        if (question.size() > around.share.question)
            throw Error("the question has more than " +
                        std::to_string(around.share.question >> 20) + " MiB");
    }
    return answer_question(question, around);
}

int studio(const Options& options) {
    Surroundings around;
    if (!options.folder.empty()) {
        std::error_code failed;
        around.folder = std::filesystem::canonical(options.folder, failed);
        if (failed || !std::filesystem::is_directory(around.folder, failed))
            throw Error("cannot read the folder " + options.folder);
    } else {
        enter_empty_place();
    }
    Studio studio;
    if (options.bounds.memory) studio.share.memory = *options.bounds.memory;
    if (options.bounds.timeout) studio.share.seconds = *options.bounds.timeout;
    around.share = studio.share;
    if (options.ask) return ask_once(around);
    studio.host = options.host;
    constexpr std::uint64_t largest_port = 65535;
    if (options.port > largest_port)
        refuse("--port", "a port from 0 to 65535", std::to_string(options.port));
    studio.port = static_cast<std::uint16_t>(options.port);
    studio.page = studio_page();
    studio.token = options.token.empty() ? random_token() : options.token;
    if (studio.token.size() < 16 ||
        !std::ranges::all_of(studio.token, [](unsigned char c) { return std::isalnum(c); }))
        refuse("--token", "at least 16 letters or digits", studio.token);
    const unsigned processors = std::max(1U, std::thread::hardware_concurrency());
    studio.share.at_once = static_cast<unsigned>(
        std::min<std::uint64_t>(options.at_once.value_or(2 * processors), 256));
    // A verb says when its own time is over; the process ends a little later, in case it does not.
    studio.share.seconds += 2;
    studio.answer = [around](const std::string& text) { return answer_question(text, around); };
    studio.listening = [&](const std::string& address) {
        print(address + "\n");
        std::cout.flush();
        std::fflush(stdout);
        if (options.host != "127.0.0.1" && options.host != "localhost" && options.host != "::1")
            note(
                "everybody in the network who has this address can use it; what they send and see "
                "is not encrypted");
        note("Ctrl-C ends the studio");
    };
    studio.is_stopped = [] { return stop.load(); };
    serve(studio);
    return success;
}

}  // namespace

void add_studio(Verbs& verbs) {
    auto [verb, options] = verbs.add(
        "studio", "A page in the browser: type a system, see its figure, words and proofs",
        {"algae studio", "algae studio my-systems --port 8080",
         "algae studio --host 0.0.0.0 --timeout 10 --max-memory 256M"},
        studio);
    verb.option("FOLDER", options.folder, "DIR",
                "a folder whose .lsys, .claim and .exercise files the page can open, and nothing "
                "else");
    verb.option(
        "--host", options.host, "ADDRESS",
        "the address to serve (default 127.0.0.1, this machine alone); 0.0.0.0 for a lecture "
        "hall");
    verb.option("--port", options.port, natural, "N", "the port (default: one that is free)");
    verb.option("--token", options.token, "TEXT",
                "the secret in the address, at least 16 letters or digits (default: a new one)");
    verb.option("--at-once", options.at_once, natural, "N",
                "how many questions are answered at a time (default: two a processor)");
    verb.flag(
        "--ask", options.ask,
        "answers one question of the page, as JSON on standard input, and ends without a server");
    verb.bounded_by(options.bounds);
}

}  // namespace algae::command
