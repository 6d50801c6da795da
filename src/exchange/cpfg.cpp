#include <algorithm>
#include <cctype>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "exchange/detail/cpfg.hpp"
#include "exchange/detail/formats.hpp"
#include "exchange/detail/scanner.hpp"
#include "exchange/exchange.hpp"
#include "model/model.hpp"

// L-systems of cpfg (`*.l`), and the declarative parts of L-Py (`*.lpy`) and of lpfg (`*.l`): contexts, parameters, conditions, choices, a homomorphism.
//
//     #define STEP 2                        s = 2                        # L-Py
//     Lsystem: 1                            Axiom: A(1)
//     derivation length: 3                  derivation length: 3
//     Axiom: A(1)                           production:
//     A(x) : x < 4 --> F(x)+A(x*STEP)       A(x) --> F(x)+A(x*s)
//     endlsystem                            endlsystem
//
// A file of cpfg is read as its preprocessor leaves it: comments are gone and `#define` is replaced, each character keeping the place where
// it stood. Then lines are joined where the next one begins with a tabulator. Each module is a single character; in L-Py a name that `module`
// declares is one symbol. Reading writes a text of the notation, with each expression in brackets as the program groups it.

namespace algae {

namespace {

class CpfgFile : CpfgReader {
public:
    /// Of several systems of a file `entry` is the label of one.
    CpfgFile(const Source& source, const CpfgDialect& dialect, std::string entry)
        : CpfgReader(source, dialect), entry_(std::move(entry)) {}

    CpfgSystem read(const Placed& whole) {
        enum { before, header, rules, decomposition, homomorphism, after } state = before;
        bool has_rules = false;  // a rule or an empty line
        for (const Placed& line : system_lines(statements(whole))) {
            const Placed said = line.trimmed();
            has_rules = has_rules || (state == rules && said.text != "endlsystem");
            if (said.text.empty()) continue;
            const std::size_t place = said.at.front();
            if (state == before) {
                state = header;
                continue;
            }
            if (is_end(said)) {
                if (!has_rules)
                    fail(place, "expected a rule or an empty line before '" + said.text + "'");
                state = after;
                continue;
            }
            if (line.text.front() == ' ' && state != header)
                fail(place,
                     "a line that begins with a blank: expected a tabulator, which continues "
                     "the line above, or nothing");
            if (state == header && read_header(said)) continue;
            if (const auto value = behind(said, {"Axiom:", "axiom:"})) {
                if (state != header) fail(place, "a second axiom");
                system_.axiom = *value;
                state = rules;
                continue;
            }
            if (behind(said, {"decomposition"})) {
                state = decomposition;
                continue;
            }
            if (behind(said, {"homomorphism"})) {
                state = homomorphism;
                continue;
            }
            if (const auto depth = behind(said, {"maximum depth:"}); depth && state > rules) {
                (state == decomposition ? system_.depth : system_.drawn_depth) =
                    number(*depth, "a depth");
                continue;
            }
            if (state == homomorphism && behind(said, {"seed:"}))
                refuse(place, "a homomorphism with choices", "has no meaning in the notation");
            if (state == header)
                fail(place,
                     "expected 'Axiom:' or a line of the header, such as 'derivation length: 3' or "
                     "'ignore: +-', found '" +
                         said.text.substr(0, 40) + "'" + header_hint(said.text));
            (state == rules           ? system_.rules
             : state == decomposition ? system_.decomposition
                                      : system_.interpretation)
                .push_back(rule(said));
        }
        return std::move(system_);
    }

private:
    /// How a line that is none of the header is meant, if it begins as one does.
    static std::string header_hint(const std::string& said) {
        if (said.starts_with("angle"))
            return "; angles stand in a view file, `angle increment: 30`, or behind symbols, +(30)";
        std::string letters;
        for (const char c : said)
            if (std::isalpha(static_cast<unsigned char>(c)) || c == ' ') letters += c;
        return did_you_mean(trimmed(letters), {"Axiom", "derivation length", "ignore", "consider",
                                               "seed", "ring lsystem", "define"});
    }

    static bool is_end(const Placed& said) {
        return said.text == "endlsystem" || said.text == "Endlsystem" || said.text == "EndLsystem";
    }

    /// The lines of the system that is meant, with that of its label and its end.
    std::vector<Placed> system_lines(std::vector<Placed> lines) const {
        struct Part {
            std::string label;
            std::size_t begin = 0, end = 0, place = 0;
        };
        std::vector<Part> parts;
        bool inside = false;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const Placed said = lines[i].trimmed();
            if (inside) {
                parts.back().end = i + 1;
                inside = !is_end(said);
                continue;
            }
            if (said.text.empty()) continue;
            const std::size_t place = said.at.front();
            const auto label = behind(said, {"Lsystem:", "lsystem:"});
            if (!label)
                fail(place, parts.empty()
                                ? "expected 'Lsystem: 1', found '" + said.text.substr(0, 40) + "'"
                                : "expected another 'Lsystem:' or the end of the file "
                                  "behind 'endlsystem', found '" +
                                      said.text.substr(0, 40) + "'");
            parts.push_back({label->text, i, i + 1, place});
            inside = true;
        }
        if (parts.empty()) fail(0, "expected 'Lsystem: 1', found none");
        if (inside) fail(source_.text().size(), "expected 'endlsystem', found the end of the file");
        std::vector<std::string> labels;
        for (const Part& part : parts) labels.push_back(part.label);
        const auto named = std::ranges::find(labels, entry_);
        if (entry_.empty() && parts.size() > 1)
            fail(parts[1].place, "a second system: say which of " + joined(labels, ", ") +
                                     " is meant, as in " + source_.file() + ":" + labels[0]);
        if (!entry_.empty() && named == labels.end())
            fail(parts[0].place, "there is no system " + quoted(entry_) +
                                     did_you_mean(entry_, labels) + "; there is " +
                                     joined(labels, ", "));
        const Part& chosen =
            entry_.empty() ? parts[0] : parts[static_cast<std::size_t>(named - labels.begin())];
        return {lines.begin() + static_cast<std::ptrdiff_t>(chosen.begin),
                lines.begin() + static_cast<std::ptrdiff_t>(chosen.end)};
    }

    std::string entry_;
};

/// Where the first line stands, outside comments of C, that such a test holds of.
std::optional<std::size_t> first_line_that(std::string_view text, bool (*holds)(std::string_view)) {
    std::string bare(text);
    for (std::size_t i = 0; i + 1 < bare.size(); ++i) {
        if (bare[i] != '/' || (bare[i + 1] != '/' && bare[i + 1] != '*')) continue;
        const bool is_line = bare[i + 1] == '/';
        std::size_t end = is_line ? bare.find('\n', i) : bare.find("*/", i + 2);
        end = end == std::string::npos ? bare.size() : is_line ? end : end + 2;
        for (; i < end; ++i)
            if (bare[i] != '\n') bare[i] = ' ';
        --i;
    }
    for (std::size_t begin = 0; begin < bare.size();) {
        const std::size_t end = std::min(bare.find('\n', begin), bare.size());
        if (holds(std::string_view(bare).substr(begin, end - begin))) return begin;
        begin = end + 1;
    }
    return std::nullopt;
}

bool is_system_line(std::string_view line) {
    return line.starts_with("Lsystem:") || line.starts_with("lsystem:");
}
/// A line that only a program in L+C has.
bool is_plus_line(std::string_view line) {
    const std::string_view said = trimmed(line);
    return (said.starts_with("#include") && said.find("lpfgall.h") != std::string_view::npos) ||
           (said.starts_with("module ") && said.find('(') != std::string_view::npos &&
            said.ends_with(';'));
}
bool is_panel_line(std::string_view line) {
    return line.starts_with("panel name:") || line.starts_with("target:");
}

}  // namespace

Model read_cpfg(std::string_view text, const std::string& name) {
    if (looks_like_panel(text)) {
        const std::string kept(text);
        const Source source(kept, name);
        throw Diagnostics({source.finding(
            first_line_that(text, is_panel_line).value_or(0),
            "a control panel of vlab, which holds no system: expected the system that it is for")});
    }
    if (looks_like_lpfg(text)) return read_lpfg(text, name);
    const auto [file, entry] = file_and_entry(name);
    const std::string kept(text);
    const Source source(kept, file);
    const CpfgDialect dialect{false, "cpfg", 45};
    return cpfg_model(source, dialect,
                      CpfgFile(source, dialect, entry).read(preprocessed(source, dialect)));
}

bool looks_like_cpfg(std::string_view text) {
    return first_line_that(text, is_system_line).has_value();
}

bool looks_like_lpfg(std::string_view text) {
    return !looks_like_cpfg(text) && first_line_that(text, is_plus_line).has_value();
}

bool looks_like_panel(std::string_view text) {
    return !looks_like_cpfg(text) && !looks_like_fractint(text) &&
           first_line_that(text, is_panel_line).has_value();
}

}  // namespace algae
