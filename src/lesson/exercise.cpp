#include <algorithm>
#include <charconv>
#include <set>
#include <utility>

#include "exact/exact.hpp"
#include "language/language.hpp"
#include "lesson/lesson.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "turtle/turtle.hpp"

// Files `*.exercise`: how they are read, and what can be wrong with them before there is an answer.
//
// An exercise is a claim with lines of its own (NOTATION.md). The reader takes these out (`exercise`, `task`, `source`, `answer`,
// `hint`, and statements that claims have not) and leaves blanks in their place, so that what remains is the text of a claim
// whose places are those of the file. Everything that is wrong with the lines is gathered; nothing stops at the first fault.
// The claim itself is read with an answer only, because `answer` is not defined before.
//
// Statements of an exercise's own are about systems: the form of the answer, how many rules, letters or axiom symbols it has,
// and figures that are similar, congruent or the same.
//
// The check before there is an answer reads the claim with several possible answers of the kind asked for: systems of four forms
// over four letters, languages of one word. What is wrong with each of them is wrong with the exercise. An unknown name also counts if
// the other answers are refused in that line for their kind, before the name is come to. Systems that cannot be opened may be in
// files beside an answer; where that is so they are passed over.

namespace algae {

namespace {

void add_task(std::string_view value, std::string& task) {
    if (value.empty()) {
        task += "\n\n";
        return;
    }
    if (!task.empty() && task.back() != '\n') task += ' ';
    task += value;
}

/// The clause of a line; texts for people are no clauses. Comments are none of it.
std::string_view first_clause(std::string_view text) {
    const std::vector<ClaimClause> clauses = claim_clauses(text);
    return clauses.empty() ? text.substr(0, 0) : clauses.front().text;
}

/// How many more braces a line of a claim opens than it closes.
long opened_braces(std::string_view line) {
    long depth = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '#' && (i == 0 || is_blank(static_cast<unsigned char>(line[i - 1])))) break;
        depth += line[i] == '{' ? 1 : line[i] == '}' ? -1 : 0;
    }
    return depth;
}

/// Puts what the lines of a text say into an exercise, but for what its name says; gathers what is wrong with them.
class ExerciseReader {
public:
    ExerciseReader(std::string_view text, Exercise& exercise, const Source& source,
                   Findings& findings)
        : text_(text), exercise_(exercise), source_(source), findings_(findings) {}

    void read() {
        exercise_.claim = text_;
        for (std::size_t begin = 0; begin < text_.size();) {
            const std::size_t end = std::min(text_.find('\n', begin), text_.size());
            const std::string_view line = text_.substr(begin, end - begin);
            findings_.gather([&] {
                if (!read_line(line)) blank_out(line);
            });
            begin = end + 1;
        }
        if (!exercise_.claim.ends_with('\n')) exercise_.claim += '\n';
        for (std::size_t i = 0; i < exercise_.demands.size(); ++i)
            findings_.gather([&] { read_demand(exercise_.demands[i], shown_[i]); });
        refuse_other_clauses();
        expect_line(!given("exercise"), "exercise TITLE");
        expect_line(!has_task_, "task TEXT");
        expect_line(!has_show_, "show STATEMENT");
    }

private:
    void blank_out(std::string_view line) {
        std::fill_n(exercise_.claim.begin() + (line.data() - text_.data()), line.size(), ' ');
    }

    bool given(std::string_view keyword) const {
        return std::any_of(given_.begin(), given_.end(),
                           [&](const auto& piece) { return piece == keyword; });
    }

    void refuse_second(std::string_view keyword) {
        for (const std::string_view first : given_)
            if (first == keyword) throw given_twice(keyword, first.data(), source_);
        given_.push_back(keyword);
    }

    void expect_line(bool missing, const std::string& line) {
        if (missing)
            findings_.add(text_.size(),
                          "expected a line '" + line + "' before the end of the file, found none");
    }

    /// Whether the line is one of a claim, and stays in the text of it.
    bool read_line(std::string_view line) {
        const std::vector<std::string_view> words = blank_separated(line);
        const std::string_view keyword = words.empty() ? line.substr(line.size()) : words.front();
        const auto keyword_end =
            static_cast<std::size_t>(keyword.data() - line.data()) + keyword.size();
        const std::string_view value = trimmed(line.substr(keyword_end));
        const bool of_exercise = keyword == "exercise" || keyword == "task" ||
                                 keyword == "answer" || keyword == "hint" || keyword == "show";
        if (of_exercise || keyword == "let" || keyword == "alphabet") depth_ = 0;
        if (!of_exercise && (keyword != "source" || depth_ > 0)) {
            depth_ = std::max(0L, depth_ + opened_braces(line));
            return true;
        }
        if (keyword == "show") {
            has_show_ = true;
            return read_show(value);
        }
        blank_out(line);  // whatever is wrong with it
        if (keyword == "exercise" || keyword == "source" || keyword == "answer")
            refuse_second(keyword);
        if (value.empty() && keyword != "task")
            throw unexpected("a text after " + quoted(keyword), value.data());
        if (keyword == "exercise") exercise_.title = value;
        if (keyword == "source") exercise_.source = value;
        if (keyword == "task") {
            has_task_ = has_task_ || !value.empty();
            add_task(value, exercise_.task);
        }
        if (keyword == "answer") read_kind(first_clause(value));
        if (keyword == "hint") add_hint(value, keyword);
        return false;
    }

    void add_hint(std::string_view value, std::string_view keyword) {
        if (exercise_.demands.empty() && !has_show_)
            throw SyntaxError{keyword.data(), "expected a 'show' above the hint"};
        if (exercise_.demands.empty()) return;
        std::string& hint = exercise_.demands.back().hint;
        hint += (hint.empty() ? "" : " ") + std::string(value);
    }

    void read_kind(std::string_view value) {
        using Kind = Exercise::Kind;
        static const std::vector<std::pair<std::string, Kind>> kinds{{"system", Kind::system},
                                                                     {"language", Kind::language},
                                                                     {"word", Kind::word},
                                                                     {"claim", Kind::claim}};
        const std::vector<std::string_view> words = blank_separated(value);
        const std::string expected = "system, language, word or claim and names";
        if (words.empty()) throw unexpected(expected, value.data());
        const auto kind =
            std::ranges::find(kinds, words.front(), &std::pair<std::string, Kind>::first);
        if (kind == kinds.end())
            throw unknown_word(expected, words[0], {"system", "language", "word", "claim"});
        exercise_.kind = kind->second;
        if (exercise_.kind != Kind::claim) {
            if (words.size() > 1) throw unexpected("the end of the line", words[1].data());
            return;
        }
        if (words.size() == 1)
            throw SyntaxError{words[0].data(),
                              "expected names behind 'answer claim', found the end of the line"};
        for (std::size_t i = 1; i < words.size(); ++i) {
            if (!is_claim_name(words[i])) throw unexpected("a name", words[i].data());
            exercise_.names.emplace_back(words[i]);
        }
    }

    bool read_show(std::string_view value) {
        const std::vector<ClaimClause> clauses = claim_clauses(value);
        if (clauses.empty()) throw unexpected("a statement", value.data());
        if (clauses.size() > 1)
            throw SyntaxError{clauses[1].text.data(),
                              "expected one statement in a line, found " + quoted(clauses[1].text)};
        const Place place = source_.place(clauses.front().text.data());
        exercise_.demands.push_back({std::string(clauses.front().text), "", place, {}});
        shown_.push_back(clauses.front().text);
        return true;
    }

    /// Reads it if it is one of exercises' own, which the claim has not.
    void read_demand(Demand& demand, std::string_view text) {
        if (!is_own_statement(text, exercise_.kind == Exercise::Kind::system)) return;
        const std::size_t begin = source_.offset({exercise_.file, demand.place.line, 1});
        const std::size_t end = std::min(text_.find('\n', begin), text_.size());
        blank_out(text_.substr(begin, end - begin));
        if (exercise_.kind != Exercise::Kind::system)
            throw SyntaxError{text_.data() + begin,
                              "expected an exercise with 'answer system' for " + quoted(text)};
        demand.own = read_own_statement(text);
    }

    void refuse_other_clauses() {
        for (const ClaimClause& clause : claim_clauses(exercise_.claim)) {
            const char* const where = text_.data() + (clause.text.data() - exercise_.claim.data());
            const bool known = clause.keyword == "let" || clause.keyword == "alphabet" ||
                               clause.keyword == "allow";
            if (known) continue;
            if (clause.keyword != "show") {
                findings_.add(where,
                              "expected one of exercise, source, task, answer, show, hint, "
                              "alphabet, allow or let, found " +
                                  quoted(clause.keyword) + suggestion(clause.keyword));
            } else if (trimmed(line_before(where)) != "") {
                findings_.add(where, "expected 'show' at the start of a line");
            }
        }
    }

    /// What stands to the left in the same line.
    std::string_view line_before(const char* where) const {
        const std::string_view before = text_.substr(0, source_.offset(where));
        const std::size_t end_of_line = before.rfind('\n');
        return end_of_line == std::string_view::npos ? before : before.substr(end_of_line + 1);
    }

    static std::string suggestion(std::string_view keyword) {
        std::string small(keyword);
        for (char& letter : small)
            if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
        return did_you_mean(small, {"exercise", "source", "task", "answer", "show", "hint",
                                    "alphabet", "allow", "let"});
    }

    std::string_view text_;
    Exercise& exercise_;
    const Source& source_;
    Findings& findings_;
    std::vector<std::string_view> given_;  // lines that stand once
    std::vector<std::string_view> shown_;  // the statements of the demands
    bool has_task_ = false, has_show_ = false;
    long depth_ = 0;  // of braces
};

/// "03-2" of "lessons/exercises/03-2.exercise".
std::string name_of(const std::string& file) {
    const std::size_t slash = file.rfind('/');
    const std::size_t begin = slash == std::string::npos ? 0 : slash + 1;
    return file.substr(begin, file.rfind('.') - begin);
}

/// The numbers of the lesson and the exercise in the name of a file, if they are there.
void read_label(const std::string& name, Exercise& exercise) {
    const auto number = [](std::string_view digits) {
        std::size_t value = 0;
        const char* const end = digits.data() + digits.size();
        const auto [stop, error] = std::from_chars(digits.data(), end, value);
        return error == std::errc() && stop == end ? value : 0;
    };
    const std::size_t dash = name.find('-');
    if (dash == std::string::npos) return;
    const std::size_t lesson = number(std::string_view(name).substr(0, dash));
    const std::size_t place = number(std::string_view(name).substr(dash + 1));
    if (lesson == 0 || place == 0) return;
    exercise.lesson = lesson;
    exercise.number = place;
}

}  // namespace

std::string Exercise::label() const {
    if (lesson == 0) return name_of(file);
    return std::to_string(lesson) + "." + std::to_string(number);
}

std::string Exercise::ending() const {
    return kind == Kind::system ? "lsys" : kind == Kind::claim ? "claim" : "txt";
}

Exercise read_exercise(std::string_view text, const std::string& name) {
    Exercise exercise;
    exercise.file = name + ".exercise";
    exercise.text = text;
    read_label(name_of(exercise.file), exercise);
    const Source source(text, exercise.file);
    Findings findings(source);
    findings.throw_if_no_text();
    ExerciseReader(text, exercise, source, findings).read();
    findings.throw_if_any();
    return exercise;
}

namespace {

/// An answer that somebody could give: a line that defines it, and the system that this line opens as
/// `answer`.
struct PossibleAnswer {
    std::string definition;
    std::string system;
};

/// Of each form one, over other letters: what is wrong with one of them need not be wrong with another.
std::vector<PossibleAnswer> possible_answers(const Exercise& exercise) {
    const std::vector<std::pair<std::string, std::string>> systems{
        {"D0L", "axiom a\na -> aa\n"},
        {"S0L", "axiom b\nb -(0.5)-> b\nb -(0.5)-> bb\n"},
        {"parametric", "axiom c(1)\nc(x) -> c(x+1)\n"},
        {"IL", "axiom d\nd < d -> dd\n"}};
    const std::vector<std::string> names = exercise.kind == Exercise::Kind::claim
                                               ? exercise.names
                                               : std::vector<std::string>{"answer"};
    const auto definition = [&](const std::string& value) {
        std::string line = "claim answer";
        for (const std::string& name : names) line += "; let " + name + " = " + value;
        return line + "\n";
    };
    std::vector<PossibleAnswer> all;
    if (exercise.kind == Exercise::Kind::system || exercise.kind == Exercise::Kind::claim)
        for (const auto& [family, text] : systems)
            all.push_back({definition(family + " answer"), text});
    if (exercise.kind != Exercise::Kind::system)
        for (const char* language : {"{e}", "{f}"}) all.push_back({definition(language), ""});
    return all;
}

/// A file that may stand beside the answer.
struct FileElsewhere {};

/// Places in the exercise and what is wrong there.
using Faults = std::set<std::pair<Place, std::string>>;

class ExerciseCheck {
public:
    ExerciseCheck(const Exercise& exercise, const SystemSource& open, bool files_may_follow)
        : exercise_(exercise), open_(open), files_may_follow_(files_may_follow) {}

    void check() {
        const Source source(exercise_.text, exercise_.file);
        Findings findings(source);
        for (const auto& [place, message] : faults_of_claim()) findings.add(place, message);
        for (const Demand& demand : exercise_.demands) {
            const auto* figures = demand.own ? std::get_if<FiguresAre>(&*demand.own) : nullptr;
            if (!figures) continue;
            for (const FiguresAre::Figure& figure : {figures->left, figures->right})
                if (const std::string fault = fault_of(figure); !fault.empty())
                    findings.add(source.offset(demand.place) + figure.offset, fault);
        }
        findings.throw_if_any();
    }

private:
    /// The system of this name. Throws FileElsewhere where it may be known later.
    Model opened(const std::string& name) const {
        try {
            return open_(name);
        } catch (const Diagnostics&) {
            throw;
        } catch (const Error&) {
            if (files_may_follow_ && name.find_first_of("./") != std::string::npos)
                throw FileElsewhere();
            throw;
        }
    }

    std::string fault_of(const FiguresAre::Figure& figure) const {
        if (figure.system == "answer") return {};
        try {
            opened(figure.system);
        } catch (const FileElsewhere&) {
        } catch (const Diagnostics& error) {
            const Diagnostic& first = error.findings().front();
            return "the system cannot be read: " + to_string(first.place) + ": " + first.message;
        } catch (const Error& error) {
            return error.what();
        }
        return {};
    }

    /// What is wrong with the claim that the exercise makes, whatever the answer: what is wrong with every
    /// possible answer, and unknown names in lines that make sense with none of them, as some are
    /// refused for the kind of answer before the name is come to.
    Faults faults_of_claim() const {
        std::vector<Faults> all;
        for (const PossibleAnswer& answer : possible_answers(exercise_)) {
            all.push_back(faults_with(answer));
            if (all.back().empty()) return {};
        }
        Faults common;
        for (const Faults& faults : all)
            for (const auto& fault : faults)
                if (std::all_of(all.begin(), all.end(), [&](const Faults& others) {
                        return others.contains(fault) || (is_unknown_name(fault.second) &&
                                                          refuses_line(others, fault.first.line));
                    }))
                    common.insert(fault);
        return common;
    }

    static bool is_unknown_name(const std::string& message) {
        return message.starts_with("expected a name that is defined above");
    }

    static bool refuses_line(const Faults& faults, std::size_t line) {
        return std::any_of(faults.begin(), faults.end(),
                           [&](const auto& fault) { return fault.first.line == line; });
    }

    Faults faults_with(const PossibleAnswer& answer) const {
        const SystemSource open = [&](const std::string& name) {
            return name == "answer" ? read_lsystem(answer.system, name) : opened(name);
        };
        Faults faults;
        try {
            read_claim(answer.definition + exercise_.claim, exercise_.file, open);
        } catch (const FileElsewhere&) {
        } catch (const Diagnostics& error) {
            for (const Diagnostic& found : error.findings())
                if (found.place.line > 1)  // below the definition of the answer
                    faults.emplace(Place{exercise_.file, found.place.line - 1, found.place.column},
                                   found.message);
        }
        return faults;
    }

    const Exercise& exercise_;
    const SystemSource& open_;
    bool files_may_follow_;
};

}  // namespace

void check_exercise(const Exercise& exercise, const SystemSource& open, bool files_may_follow) {
    ExerciseCheck(exercise, open, files_may_follow).check();
}

}  // namespace algae
