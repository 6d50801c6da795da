#include "lesson/check_exercise.hpp"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "notation/characters.hpp"
#include "notation/findings.hpp"
#include "notation/read.hpp"

namespace algae {

namespace {

using Kind = Exercise::Kind;

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
    const std::vector<std::string> names =
        exercise.kind == Kind::claim ? exercise.names : std::vector<std::string>{"answer"};
    const auto definition = [&](const std::string& value) {
        std::string line = "claim answer";
        for (const std::string& name : names) line += "; let " + name + " = " + value;
        return line + "\n";
    };
    std::vector<PossibleAnswer> all;
    if (exercise.kind == Kind::system || exercise.kind == Kind::claim)
        for (const auto& [family, text] : systems)
            all.push_back({definition(family + " answer"), text});
    if (exercise.kind != Kind::system)
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
            if (!demand.own || demand.own->kind != OwnStatement::Kind::figures) continue;
            for (const OwnStatement::Figure& figure : {demand.own->left, demand.own->right})
                if (const std::string fault = fault_of(figure); !fault.empty())
                    findings.add(source.offset(demand.place) + figure.offset, fault);
        }
        findings.throw_if_any();
    }

private:
    /// The system of this name. Throws FileElsewhere where it may be known later.
    LSystem opened(const std::string& name) const {
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

    std::string fault_of(const OwnStatement::Figure& figure) const {
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
