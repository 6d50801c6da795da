// `algae latex`: the results that a LaTeX document asks for by the commands of algae.sty.
//
// The document is read as text: comments and verbatim parts are passed over, \input and \include are followed, and each command of the
// package is cut out with its options and arguments. Its words are the key under which TeX looks the result up, so that nothing needs to be numbered
// and TeX runs no program. Each result is what a verb of this command prints; the verbs run here, one after the other, and what they print
// is caught. A document chooses among few options of these verbs, none of which names a program or a file to be written.
//
// All results stand in one file beside the document, DOCUMENT.algae, each with a fingerprint of what it was made from: the command, the text of the
// system and the version. A result whose fingerprint is the same is kept as it is. So a document can be given to somebody who has no algae.

#include <sys/mman.h>
#include <unistd.h>

#include <fmt/format.h>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <map>
#include <optional>
#include <set>

#include "command/detail/files.hpp"
#include "command/detail/output.hpp"
#include "command/detail/verb.hpp"
#include "exact/exact.hpp"
#include "growth/growth.hpp"
#include "model/model.hpp"
#include "render/render.hpp"
#include "report/report.hpp"

namespace algae::command {

namespace {

namespace paths = std::filesystem;

constexpr const char* style_text =
    R"(% Made by algae. Results of algae in a document: `algae latex paper.tex' writes them to paper.algae.
\NeedsTeXFormat{LaTeX2e}
\ProvidesPackage{algae}[2026/11/23 Results of algae, a command for L-systems]
\RequirePackage{amsmath,tikz,forest,verbatim}
\@ifundefined{proof}{\RequirePackage{amsthm}}{}
\usetikzlibrary{arrows.meta,shapes.geometric}
% A result under the words of its command.
\newcommand\algaeresult[1]{\long\expandafter\gdef\csname algae@\detokenize{#1}\endcsname}
\newif\ifalgae@missing
\newcommand\algae@use[1]{%
  \ifcsname algae@\detokenize{#1}\endcsname
    \csname algae@\detokenize{#1}\endcsname
  \else
    \global\algae@missingtrue
    \PackageWarning{algae}{No result for \detokenize{#1}}%
    \textbf{??}%
  \fi}
\AtEndDocument{\ifalgae@missing
  \PackageWarningNoLine{algae}{There are results missing; run `algae latex \jobname.tex' and LaTeX again}\fi}
% Figures and trees.
\newcommand\algaefigure[2][]{\algae@use{figure[#1]{#2}}}
\newcommand\algaetree[2][]{\algae@use{tree[#1]{#2}}}
% Mathematics: growth, with a part such as matrix, recurrence, function, form, rate or lengths; words; rules.
\newcommand\algaegrowth[2][]{\algae@use{growth[#1]{#2}}}
\newcommand\algaeword[2][]{\ensuremath{\algae@use{word[#1]{#2}}}}
\newcommand\algaederivation[2][]{\algae@use{derivation[#1]{#2}}}
\newcommand\algaerules[2][]{\ensuremath{\algae@use{rules[#1]{#2}}}}
\newcommand\algaedimension[2][]{\algae@use{dimension[#1]{#2}}}
% Theory.
\newcommand\algaeis[3][]{\algae@use{is[#1]{#2}{#3}}}
\newcommand\algaecheck[2][]{\algae@use{check[#1]{#2}}}
\newcommand\algaeclosure[3][]{\algae@use{closure[#1]{#2}{#3}}}
% A system that stands in the document: its rules are shown, or not with a star.
\newenvironment{lsystem}[1]{\def\algae@system{#1}\comment}{\endcomment
  \edef\algae@key{rules[]{\algae@system}}\[\expandafter\algae@use\expandafter{\algae@key}\]}
\newenvironment{lsystem*}[1]{\comment}{\endcomment}
\InputIfFileExists{\jobname.algae}{}{\global\algae@missingtrue}
)";

/// A command of the package in a document.
struct Asked {
    std::string name;                    // "figure"
    std::string options;                 // between brackets
    std::vector<std::string> arguments;  // between braces
    Place place;

    std::string key() const {
        std::string text = name + "[" + options + "]";
        for (const std::string& argument : arguments) text += "{" + argument + "}";
        return text;
    }
};

struct Document {
    std::vector<Asked> asked;                    // each once, in order
    std::map<std::string, std::string> systems;  // those that stand in it
    std::vector<std::string> files;
};

/// How many arguments a command of the package has; nothing if it is none.
std::optional<std::size_t> arguments_of(const std::string& name) {
    static const std::map<std::string, std::size_t> all{
        {"figure", 1}, {"tree", 1},      {"growth", 1}, {"word", 1},  {"derivation", 1},
        {"rules", 1},  {"dimension", 1}, {"is", 2},     {"check", 1}, {"closure", 2}};
    const auto found = all.find(name);
    return found == all.end() ? std::nullopt : std::optional(found->second);
}

/// Reads a document and those that it inputs.
class DocumentReader {
public:
    DocumentReader(Document& document, const Budget& budget)
        : document_(document), budget_(budget) {}

    void read(const std::string& path) {
        if (std::ranges::find(document_.files, path) != document_.files.end()) return;
        document_.files.push_back(path);
        const std::string text = file_text(path, budget_);
        File file{path, text};
        while (file.at < text.size()) step(file);
    }

private:
    struct File {
        const std::string& path;
        const std::string& text;
        std::size_t at = 0;

        Place place(std::size_t offset) const {
            const auto begin = text.begin(), end = begin + static_cast<std::ptrdiff_t>(offset);
            const std::size_t line = static_cast<std::size_t>(std::count(begin, end, '\n')) + 1;
            const std::size_t last = text.rfind('\n', offset == 0 ? 0 : offset - 1);
            const std::size_t column =
                last == std::string::npos || offset == 0 ? offset + 1 : offset - last;
            return {path, line, column};
        }
        bool begins(std::string_view word) const {
            return std::string_view(text).substr(at).starts_with(word);
        }
        void pass(std::string_view end) {
            const std::size_t found = text.find(end, at);
            at = found == std::string::npos ? text.size() : found + end.size();
        }
    };

    [[noreturn]] static void fail(const File& file, std::size_t offset,
                                  const std::string& message) {
        const std::size_t begin = file.text.rfind('\n', offset == 0 ? 0 : offset - 1);
        const std::size_t from = begin == std::string::npos || offset == 0 ? 0 : begin + 1;
        const std::size_t end = std::min(file.text.find('\n', offset), file.text.size());
        throw Diagnostics(
            {{file.place(offset), message, file.text.substr(from, end - from), offset - from}});
    }

    void step(File& file) {
        const char c = file.text[file.at];
        if (c == '%') return file.pass("\n");
        if (c != '\\') {
            ++file.at;
            return;
        }
        const std::size_t begin = file.at++;
        std::string word;
        while (file.at < file.text.size() &&
               std::isalpha(static_cast<unsigned char>(file.text[file.at])))
            word += file.text[file.at++];
        if (word.empty()) {
            ++file.at;  // an escaped character, which may be % or a backslash
            return;
        }
        if (word == "verb" && file.at < file.text.size()) {
            if (file.text[file.at] == '*') ++file.at;
            const std::string end(1, file.text[file.at++]);
            return file.pass(end);
        }
        if (word == "begin") return environment(file, begin);
        if (word == "input" || word == "include") return input(file);
        if (word.starts_with("algae")) command(file, begin, word.substr(5));
    }

    void environment(File& file, std::size_t begin) {
        const std::string name = argument(file, begin, '{', '}');
        for (const char* verbatim : {"verbatim", "verbatim*", "lstlisting", "comment", "Verbatim"})
            if (name == verbatim) return file.pass("\\end{" + name + "}");
        if (name != "lsystem" && name != "lsystem*") return;
        const std::string called = argument(file, begin, '{', '}');
        const std::size_t from = file.at;
        const std::size_t end = file.text.find("\\end{" + name + "}", from);
        if (end == std::string::npos) fail(file, begin, "expected \\end{" + name + "}, found none");
        std::string text = file.text.substr(from, end - from);
        if (text.find("title ") == std::string::npos) text = "title " + called + "\n" + text;
        if (!document_.systems.emplace(called, text).second)
            fail(file, begin, "a second system '" + called + "' in the document");
        file.at = end;
        file.pass("}");
        if (name == "lsystem") add({"rules", "", {called}, file.place(begin)});
    }

    void input(File& file) {
        if (file.at >= file.text.size() || file.text[file.at] != '{') return;
        const std::string name = argument(file, file.at, '{', '}');
        const paths::path folder = paths::path(document_.files.front()).parent_path();
        std::error_code ignored;
        for (const std::string& ending : {std::string(), std::string(".tex")})
            if (paths::is_regular_file(folder / (name + ending), ignored))
                return read((folder / (name + ending)).string());
    }

    void command(File& file, std::size_t begin, const std::string& name) {
        const auto count = arguments_of(name);
        if (!count) return;
        Asked asked{name, "", {}, file.place(begin)};
        if (file.at < file.text.size() && file.text[file.at] == '[')
            asked.options = argument(file, begin, '[', ']');
        for (std::size_t i = 0; i < *count; ++i)
            asked.arguments.push_back(argument(file, begin, '{', '}'));
        add(std::move(asked));
    }

    void add(Asked asked) {
        if (known_.insert(asked.key()).second) document_.asked.push_back(std::move(asked));
    }

    /// What stands between brackets or braces, with blanks as TeX has them.
    static std::string argument(File& file, std::size_t begin, char opens, char closes) {
        while (file.at < file.text.size() &&
               (file.text[file.at] == ' ' || file.text[file.at] == '\n'))
            ++file.at;
        if (file.at >= file.text.size() || file.text[file.at] != opens)
            fail(file, begin, std::string("expected '") + opens + "' behind the command");
        ++file.at;
        std::string text;
        for (std::size_t depth = 0; file.at < file.text.size(); ++file.at) {
            const char c = file.text[file.at];
            if (c == closes && depth == 0) {
                ++file.at;
                return text;
            }
            if (c == '{') ++depth;
            if (c == '}') --depth;
            const bool blank = c == ' ' || c == '\n' || c == '\t' || c == '\r';
            if (blank && text.ends_with(' ')) continue;
            text += blank ? ' ' : c;
        }
        fail(file, begin, std::string("expected '") + closes + "', found the end of the document");
    }

    Document& document_;
    const Budget& budget_;
    std::set<std::string> known_;
};

/// What a verb prints, instead of printing it.
class Caught {
public:
    Caught() {
        std::cout.flush();
        std::fflush(stdout);
        kept_ = ::dup(STDOUT_FILENO);
        file_ = ::memfd_create("algae", MFD_CLOEXEC);
        if (kept_ < 0 || file_ < 0 || ::dup2(file_, STDOUT_FILENO) < 0)
            throw Error("what a verb prints cannot be caught");
    }
    Caught(const Caught&) = delete;
    Caught& operator=(const Caught&) = delete;
    ~Caught() {
        end();
        if (file_ >= 0) ::close(file_);
    }
    std::string text() {
        end();
        std::string found;
        char buffer[1 << 16];
        ::lseek(file_, 0, SEEK_SET);
        for (ssize_t count; (count = ::read(file_, buffer, sizeof buffer)) > 0;)
            found.append(buffer, static_cast<std::size_t>(count));
        return found;
    }

private:
    void end() {
        if (kept_ < 0) return;
        std::cout.flush();
        std::fflush(stdout);
        ::dup2(kept_, STDOUT_FILENO);
        ::close(kept_);
        kept_ = -1;
    }
    int kept_ = -1, file_ = -1;
};

std::string printed_by(std::vector<std::string> words) {
    words.insert(words.begin(), "algae");
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    Verbs verbs;
    add_verbs(verbs);
    Caught caught;
    const int status = verbs.run(static_cast<int>(words.size()), pointers.data());
    std::string text = caught.text();
    // Exact numbers stand beside a measurement that is undecided.
    if (status == undecided && words[1] != "dimension")
        throw BoundReached(
            Bound::method,
            "a command of the document is undecided within the bounds of `algae " + words[1] + "`");
    return text;
}

/// "5cm" in points of 1/72 inch.
std::string points(const std::string& option, const std::string& text) {
    static const std::map<std::string, double> units{
        {"cm", 72 / 2.54}, {"mm", 72 / 25.4}, {"in", 72}, {"pt", 72 / 72.27}, {"bp", 1}};
    const std::size_t end = text.find_first_not_of("0123456789.");
    const auto unit = end == std::string::npos ? units.end() : units.find(text.substr(end));
    const auto value = end == std::string::npos ? std::nullopt : number(text.substr(0, end));
    if (!value || unit == units.end()) refuse(option, "a length such as 8cm or 200pt", text);
    return fmt::format("{:.4f}", *value * unit->second);
}

/// Makes results.
class Maker {
public:
    Maker(const Document& document, const Budget& budget)
        : document_(document),
          budget_(budget),
          folder_(paths::path(document.files.front()).parent_path()) {}

    /// What FILE means in the document: a system that stands in it, a file beside it, or what it means on the command line.
    std::string file(const std::string& name) const {
        if (const auto found = document_.systems.find(name); found != document_.systems.end())
            return found->second;
        const paths::path beside = folder_ / name;
        std::error_code ignored;
        if (!name.empty() && paths::exists(beside, ignored)) return beside.string();
        return name;
    }

    /// The text that a result depends on.
    std::string made_from(const Asked& asked) const {
        if (asked.name == "is" || asked.name == "closure") return "";
        try {
            if (asked.name == "check") return file_text(file(asked.arguments[0]), budget_);
            return open_text(file(asked.arguments[0]), budget_).text;
        } catch (const Error&) {
            return "";
        }
    }

    std::string make(const Asked& asked) const {
        for (const std::string& argument : asked.arguments)
            if (argument.starts_with('-'))
                throw Error("expected no argument that begins with '-', found \"" + argument + '"');
        Options options = options_of(asked);
        const std::string& first = asked.arguments.front();
        if (asked.name == "figure") return figure(options, first);
        if (asked.name == "tree") {
            std::vector<std::string> words{"tree", file(first), "--format", "tex", "-o", "-"};
            options.pass(words, {"n", "seed", "tables", "word", "depth"}, {"dag", "graph"});
            return printed_by(std::move(words));
        }
        if (asked.name == "growth") return growth(options, first);
        if (asked.name == "word") {
            std::vector<std::string> words{"derive", file(first)};
            options.pass(words, {"n", "seed", "tables"}, {});
            std::string text = printed_by(std::move(words));
            while (text.ends_with('\n')) text.pop_back();
            return letters(text);
        }
        if (asked.name == "derivation") {
            if (options.has("word")) {
                const std::string word = options.take("word");
                if (word.starts_with('-')) throw Error("the word begins with '-'");
                options.none_left();
                return printed_by({"member", file(first), word, "--latex"});
            }
            std::vector<std::string> words{"derive", file(first), "--latex"};
            options.pass(words, {"n"}, {});
            return printed_by(std::move(words));
        }
        if (asked.name == "dimension") {
            if (options.has("value")) {
                options.take("value");
                options.none_left();
                return dimension_value(first);
            }
            std::vector<std::string> words{"dimension", file(first), "--latex"};
            options.pass(words, {"n"}, {});
            return printed_by(std::move(words));
        }
        options.none_left();
        if (asked.name == "rules") return printed_by({"show", file(first), "--latex"});
        if (asked.name == "is") return printed_by({"is", first, asked.arguments[1], "--latex"});
        if (asked.name == "check") return printed_by({"check", file(first), "--latex"});
        return printed_by({"closure", first, asked.arguments[1], "--latex"});
    }

private:
    /// Options as TeX has them: `n=4, panels, colour={red,blue}`.
    class Options {
    public:
        explicit Options(const std::string& text) {
            std::size_t depth = 0;
            std::string item;
            for (const char c : text + ",") {
                if (c == '{') ++depth;
                if (c == '}') --depth;
                if (c != ',' || depth > 0) {
                    item += c;
                    continue;
                }
                add(item);
                item.clear();
            }
        }
        bool has(const std::string& key) const { return all_.contains(key); }
        std::string take(const std::string& key) {
            const std::string value = all_.at(key);
            all_.erase(key);
            return value;
        }
        /// Appends these as options of a verb; throws Error if there are others.
        void pass(std::vector<std::string>& words, const std::set<std::string>& with_value,
                  const std::set<std::string>& flags) {
            for (const auto& [key, value] : std::map(all_)) {
                const std::string option = (key.size() == 1 ? "-" : "--") + key;
                if (with_value.contains(key)) {
                    words.push_back(option);
                    words.push_back(value);
                } else if (flags.contains(key) && value.empty()) {
                    words.push_back(option);
                } else {
                    continue;
                }
                all_.erase(key);
            }
            std::vector<std::string> known(with_value.begin(), with_value.end());
            known.insert(known.end(), flags.begin(), flags.end());
            if (!all_.empty())
                throw Error("the option '" + all_.begin()->first + "': expected one of " +
                            joined(known, ", "));
        }
        void none_left() const {
            if (!all_.empty())
                throw Error("the option '" + all_.begin()->first + "': expected none");
        }

    private:
        void add(const std::string& item) {
            const auto trimmed = [](std::string part) {
                part.erase(0, std::min(part.find_first_not_of(' '), part.size()));
                part.erase(part.find_last_not_of(' ') + 1);
                if (part.size() > 1 && part.front() == '{' && part.back() == '}')
                    part = part.substr(1, part.size() - 2);
                return part;
            };
            const std::size_t equals = item.find('=');
            const std::string key = trimmed(item.substr(0, equals));
            if (key.empty()) return;
            all_[key] = equals == std::string::npos ? "" : trimmed(item.substr(equals + 1));
        }
        std::map<std::string, std::string> all_;
    };

    static Options options_of(const Asked& asked) { return Options(asked.options); }

    std::string figure(Options& options, const std::string& name) const {
        constexpr const char* usual = "226.7717";  // 8 cm
        std::vector<std::string> words{"draw", file(name), "--format", "tex", "-o", "-"};
        bool sized = false;
        for (const char* side : {"width", "height"}) {
            if (!options.has(side)) continue;
            words.push_back(std::string("--") + side);
            words.push_back(points(side, options.take(side)));
            sized = true;
        }
        if ((options.has("captions") || options.has("caption")) && !options.has("font-size"))
            words.insert(words.end(), {"--font-size", "8"});
        options.pass(words,
                     {"n", "seed", "seeds", "tables", "colour", "background", "caption", "columns",
                      "camera", "label", "line-width", "margin", "font-size", "let"},
                     {"panels", "captions", "common-scale", "scale-bar"});
        if (sized) return printed_by(std::move(words));
        // The longer side is 8 cm.
        std::vector<std::string> wide = words;
        wide.insert(wide.end(), {"--width", usual});
        const std::string text = printed_by(std::move(wide));
        const std::size_t size = text.find(" rectangle (");
        const std::size_t comma = text.find(',', size);
        if (size != std::string::npos && std::atof(text.c_str() + comma + 1) > std::atof(usual)) {
            words.insert(words.end(), {"--height", usual});
            return printed_by(std::move(words));
        }
        return text;
    }

    std::string growth(Options& options, const std::string& name) const {
        static const std::map<std::string, GrowthPart> parts{
            {"all", GrowthPart::all},           {"lengths", GrowthPart::lengths},
            {"matrix", GrowthPart::matrix},     {"recurrence", GrowthPart::recurrence},
            {"function", GrowthPart::function}, {"form", GrowthPart::form},
            {"rate", GrowthPart::rate}};
        GrowthPart part = GrowthPart::form;
        for (const auto& [key, value] : parts)
            if (options.has(key)) {
                part = value;
                options.take(key);
            }
        std::vector<std::string> none, known;
        for (const auto& [key, value] : parts) known.push_back(key);
        options.pass(none, {}, {known.begin(), known.end()});
        const Model system = open_model(file(name), budget_);
        const View<D0L> rules = as_d0l(system);
        const std::string text =
            to_latex(GrowthReport{*rules, growth_analysis(*rules, budget_)}, part);
        return part == GrowthPart::all ? text
                                       : "\\ensuremath{" + text.substr(0, text.size() - 1) + "}\n";
    }

    std::string dimension_value(const std::string& name) const {
        const Model system = open_model(file(name), budget_);
        const ExactDimension exact = exact_dimension(system, budget_);
        if (exact.status != ExactDimension::Status::exact)
            throw Error("the rules of " + name + " give no exact dimension");
        return "\\ensuremath{" + formula_latex(exact.value->text()) + "}" +
               (exact.almost_surely ? " almost surely\n" : "\n");
    }

    /// The word that `derive` prints, as mathematics.
    static std::string letters(const std::string& word) {
        std::string out;
        for (std::size_t i = 0; i < word.size();) {
            std::size_t size = 1;
            while (i + size < word.size() && (word[i + size] & 0xc0) == 0x80) ++size;
            // A subscript belongs to its letter.
            while (i + size < word.size() && (word[i + size] == '_' || word[i + size - 1] == '_'))
                ++size;
            if (!out.empty()) out += "\\allowbreak ";
            out += letter_latex(word.substr(i, size));
            i += size;
        }
        return out + "\n";
    }

    const Document& document_;
    const Budget& budget_;
    paths::path folder_;
};

/// A number for the text, the same everywhere (FNV-1a).
std::string fingerprint(const std::string& text) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    return fmt::format("{:016x}", hash);
}

constexpr std::string_view header = "% Results of algae for ", result_begins = "\\algaeresult{",
                           marked = "% of ";

/// The text of the file that the results will replace, empty if there is none. Throws Error if it is not one of results: a
/// document that was read, or what somebody wrote.
std::string replaced_text(const std::string& output, const Document& document,
                          const Budget& budget) {
    std::error_code ignored;
    if (!paths::is_regular_file(output, ignored)) return "";
    const auto is_output = [&](const std::string& file) {
        return paths::equivalent(output, file, ignored);
    };
    const std::string text = file_text(output, budget);
    const bool has_header = text.starts_with(header);
    // A document may \input its results, but it is none itself.
    if (is_output(document.files.front()) ||
        (!has_header && std::ranges::any_of(document.files, is_output)))
        throw Error("cannot write " + output + ": it was read as input; expected another name");
    if (!has_header && !text.empty())
        throw Error("cannot write " + output +
                    ": it is not a file of results, which begins with \"" +
                    std::string(header.substr(0, header.size() - 1)) + "\"; expected another name");
    return text;
}

/// The results in a text, with their fingerprints.
std::map<std::string, std::pair<std::string, std::string>> kept_results(const std::string& text) {
    std::map<std::string, std::pair<std::string, std::string>> found;
    for (std::size_t at = text.find("\n% of "); at != std::string::npos;) {
        const std::size_t mark = at + 1 + marked.size(), line = text.find('\n', mark);
        const std::size_t next = text.find("\n% of ", mark);
        if (line == std::string::npos) break;
        const std::string block =
            text.substr(line + 1, (next == std::string::npos ? text.size() : next + 1) - line - 1);
        const std::size_t end = block.find("}{%\n");
        if (block.starts_with(result_begins) && end != std::string::npos)
            found[block.substr(result_begins.size(), end - result_begins.size())] = {
                text.substr(mark, line - mark), block};
        at = next;
    }
    return found;
}

struct LatexOptions {
    std::string file, output;
    bool style = false, json = false;
    Bounds bounds;
};

int latex_results(const LatexOptions& options) {
    if (options.style) {
        print(style_text);
        return success;
    }
    if (options.file.empty()) throw Error("expected a document, or --style");
    const Budget budget = options.bounds.budget();
    Document document;
    DocumentReader(document, budget).read(options.file);
    const paths::path path = options.file;
    const std::string output = options.output.empty()
                                   ? (path.parent_path() / path.stem()).string() + ".algae"
                                   : options.output;
    const auto kept = kept_results(replaced_text(output, document, budget));
    const Maker maker(document, budget);
    std::string text = std::string(header) + path.filename().string() + ", made by `algae latex " +
                       path.filename().string() + "'; changes are lost.\n";
    std::size_t made = 0, same = 0;
    std::vector<Diagnostic> wrong;
    ProgressBar bar("latex");
    for (std::size_t i = 0; i < document.asked.size(); ++i) {
        const Asked& asked = document.asked[i];
        const std::string key = asked.key();
        const std::string print =
            fingerprint(ALGAE_VERSION "\n" + key + "\n" + maker.made_from(asked));
        if (const auto found = kept.find(key);
            found != kept.end() && found->second.first == print) {
            text += std::string(marked) + print + "\n" + found->second.second;
            ++same;
            continue;
        }
        try {
            std::string result = maker.make(asked);
            while (result.ends_with('\n')) result.pop_back();
            text += std::string(marked) + print + "\n" + std::string(result_begins) + key +
                    "}{%\n" + result + "%\n}\n";  // no blank behind a result within a line
            ++made;
        } catch (const Diagnostics& error) {
            std::string said = "\\algae" + asked.name + ": " + error.findings().front().message;
            wrong.push_back(
                {asked.place, said, error.findings().front().line, error.findings().front().caret});
        } catch (const Error& error) {
            wrong.push_back({asked.place, "\\algae" + asked.name + ": " + error.what(), {}, 0});
        }
        bar.report(static_cast<double>(i + 1) / static_cast<double>(document.asked.size()));
    }
    write_file(output, text, true);
    // A document compiles where there is no algae, so its package lies beside it.
    const std::string style = (path.parent_path() / "algae.sty").string();
    std::error_code ignored;
    if (!paths::exists(style, ignored)) write_file(style, style_text);
    if (options.json)
        print(Json{{"output", output},
                   {"results", made + same},
                   {"made", made},
                   {"kept", same},
                   {"failed", wrong.size()}}
                  .text());
    else
        print(output + ": " + std::to_string(made) + " made, " + std::to_string(same) + " kept\n");
    if (!wrong.empty()) throw Diagnostics(std::move(wrong));
    return success;
}

}  // namespace

void add_latex(Verbs& verbs) {
    auto [verb, options] =
        verbs.add("latex", "Results for a LaTeX document that uses algae.sty",
                  {"algae latex paper.tex", "algae latex --style > algae.sty"}, latex_results);
    verb.option("DOCUMENT", options.file, "FILE", "a LaTeX document");
    verb.output("-o,--output", options.output, "FILE",
                "where the results go (default: beside the document, with the ending .algae)");
    verb.flag("--style", options.style, "print the package algae.sty, and nothing else");
    verb.json_flag(options.json, "print how many results were made and kept as one JSON object");
    verb.bounded_by(options.bounds);
}

}  // namespace algae::command
