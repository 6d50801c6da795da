#include "lesson/exercise_lines.hpp"

#include <algorithm>

#include "notation/characters.hpp"
#include "notation/claim_clauses.hpp"
#include "notation/claim_scanner.hpp"
#include "notation/findings.hpp"
#include "notation/suggestion.hpp"

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

/// Reads the lines of an exercise, and gathers what is wrong with them.
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
            guarded([&] {
                if (!read_line(line)) blank_out(line);
            });
            begin = end + 1;
        }
        if (!exercise_.claim.ends_with('\n')) exercise_.claim += '\n';
        for (std::size_t i = 0; i < exercise_.demands.size(); ++i)
            guarded([&] { read_demand(exercise_.demands[i], shown_[i]); });
        refuse_other_clauses();
        expect_line(!given("exercise"), "exercise TITLE");
        expect_line(!has_task_, "task TEXT");
        expect_line(!has_show_, "show STATEMENT");
    }

private:
    template <class Read>
    void guarded(Read read) {
        try {
            read();
        } catch (const SyntaxError& error) {
            findings_.add(error);
        }
    }

    void blank_out(std::string_view line) {
        std::fill_n(exercise_.claim.begin() + (line.data() - text_.data()), line.size(), ' ');
    }

    bool given(std::string_view keyword) const {
        return std::any_of(given_.begin(), given_.end(),
                           [&](const auto& piece) { return piece == keyword; });
    }

    void refuse_second(std::string_view keyword) {
        for (const std::string_view first : given_)
            if (first == keyword)
                throw SyntaxError{keyword.data(),
                                  quoted(keyword) + " is given twice, first in line " +
                                      std::to_string(source_.place(first.data()).line)};
        given_.push_back(keyword);
    }

    void expect_line(bool missing, const std::string& line) {
        if (missing)
            findings_.add(text_.size(),
                          "expected a line '" + line + "' before the end of the file, found none");
    }

    /// Whether the line is one of a claim, and stays in the text of it.
    bool read_line(std::string_view line) {
        ClaimScanner scanner(line);
        const std::string_view keyword = scanner.take_piece(), value = trimmed(scanner.rest());
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
        ClaimScanner scanner(value);
        const std::string_view kind = scanner.take_piece();
        if (kind == "system") {
            exercise_.kind = Exercise::Kind::system;
        } else if (kind == "language") {
            exercise_.kind = Exercise::Kind::language;
        } else if (kind == "word") {
            exercise_.kind = Exercise::Kind::word;
        } else if (kind == "claim") {
            exercise_.kind = Exercise::Kind::claim;
            read_names(scanner, kind);
        } else {
            const std::string expected = "system, language, word or claim and names";
            if (kind.empty()) throw unexpected(expected, kind.data());
            throw SyntaxError{kind.data(),
                              "expected " + expected + ", found " + quoted(kind) +
                                  did_you_mean(kind, {"system", "language", "word", "claim"})};
        }
        if (!scanner.at_end()) throw unexpected("the end of the line", scanner.here);
    }

    void read_names(ClaimScanner& scanner, std::string_view kind) {
        if (scanner.at_end())
            throw SyntaxError{kind.data(),
                              "expected names behind 'answer claim', found the end of the line"};
        while (!scanner.at_end()) {
            const std::string_view name = scanner.take_piece();
            if (ClaimScanner(name).name() != name) throw unexpected("a name", name.data());
            exercise_.names.emplace_back(name);
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
        if (!is_own_statement(text, exercise_.kind)) return;
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

}  // namespace

void read_exercise_lines(std::string_view text, Exercise& exercise, const Source& source,
                         Findings& findings) {
    ExerciseReader(text, exercise, source, findings).read();
}

}  // namespace algae
