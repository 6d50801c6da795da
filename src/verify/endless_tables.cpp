#include "verify/endless_tables.hpp"

#include <algorithm>

namespace algae::verify {

namespace {

using Letters = std::set<Symbol>;

/// One step of one letter.
struct Step {
    std::uint64_t table = 0;
    Symbol letter = 0;
    Word successor;
    std::uint64_t place = 0;
    Field field;
};
using Course = std::vector<Step>;

bool within(const Word& word, const Letters& letters) {
    return std::all_of(word.begin(), word.end(), [&](Symbol a) { return letters.contains(a); });
}

class Checker {
public:
    Checker(const Checking& with, const System& system, const Field& proof)
        : with_(with), system_(system), proof_(proof) {}

    void check() {
        const Symbol again = with_.reader.letter(proof_.at("again"));
        const Symbol other = with_.reader.letter(proof_.at("other"));
        const Course before = course("before"), round = course("round"), beside = course("beside"),
                     kept = course("kept"), after = course("after");
        Letters terminals;
        for (Symbol a = 0; a < system_.terminal.size(); ++a)
            if (system_.terminal[a]) terminals.insert(a);
        const auto finish_after = finishing(after, terminals);
        const Letters& finish = finish_after.front();
        const auto finish_round = finishing(round, finish);
        const auto finish_before = finishing(before, finish);
        if (!std::includes(finish_round.front().begin(), finish_round.front().end(), finish.begin(),
                           finish.end()))
            proof_.at("round").refuse("a letter that can finish cannot finish with one more round");
        if (round.empty()) proof_.at("round").refuse("a round has a step");
        if (!within(system_.axiom, finish_before.front()))
            proof_.at("before").refuse("a letter of the axiom cannot finish");
        const Symbol start = before.empty() ? again : before.front().letter;
        if (std::find(system_.axiom.begin(), system_.axiom.end(), start) == system_.axiom.end())
            proof_.at("before").refuse("it does not begin in the axiom");
        follow("before", before, start, again, finish_before);
        follow("round", round, again, again, finish_round);
        same_tables("beside", beside, round);
        follow("beside", beside, again, other, finish_round);
        must_branch(round, beside);
        same_tables("kept", kept, round);
        follow("kept", kept, other, other, finish_round);
        const Symbol last =
            after.empty() ? other
                          : after.back().successor.at(static_cast<std::size_t>(after.back().place));
        if (!terminals.contains(last)) proof_.at("after").refuse("it does not end with a terminal");
        follow("after", after, other, last, finish_after);
    }

private:
    Course course(const char* name) const {
        Course steps;
        for (const Field& field : proof_.at(name).list()) {
            field.only({"table", "letter", "successor", "place"});
            Step step{field.at("table").number(), with_.reader.letter(field.at("letter")),
                      with_.reader.word(field.at("successor")), field.at("place").number(), field};
            if (step.table >= system_.tables.size())
                field.at("table").refuse("there is no such table");
            const auto& all = system_.tables[static_cast<std::size_t>(step.table)][step.letter];
            if (std::find(all.begin(), all.end(), step.successor) == all.end())
                field.at("successor").refuse("the table has no such rule");
            if (step.place >= step.successor.size())
                field.at("place").refuse("the successor is not so long");
            steps.push_back(std::move(step));
        }
        return steps;
    }

    /// The letters that can be in `last` entirely after the rest of the course, before each step and at its end.
    std::vector<Letters> finishing(const Course& steps, const Letters& last) const {
        std::vector<Letters> all{last};
        for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
            Letters earlier;
            const auto& table = system_.tables[static_cast<std::size_t>(step->table)];
            for (Symbol a = 0; a < table.size(); ++a)
                if (std::any_of(table[a].begin(), table[a].end(),
                                [&](const Word& word) { return within(word, all.back()); }))
                    earlier.insert(a);
            all.push_back(std::move(earlier));
        }
        std::reverse(all.begin(), all.end());
        return all;
    }

    void follow(const char* name, const Course& steps, Symbol from, Symbol to,
                const std::vector<Letters>& finish) const {
        for (std::size_t i = 0; i < steps.size(); ++i) {
            if (steps[i].letter != from)
                steps[i].field.refuse("it is not a step of the letter before");
            if (!within(steps[i].successor, finish[i + 1]))
                steps[i].field.refuse("a letter of the successor cannot finish");
            from = steps[i].successor[static_cast<std::size_t>(steps[i].place)];
        }
        if (from != to) proof_.at(name).refuse("it ends with another letter");
    }

    void same_tables(const char* name, const Course& steps, const Course& round) const {
        if (steps.size() != round.size() || !std::equal(steps.begin(), steps.end(), round.begin(),
                                                        [](const Step& one, const Step& other) {
                                                            return one.table == other.table;
                                                        }))
            proof_.at(name).refuse("its tables are not those of the round");
    }

    void must_branch(const Course& round, const Course& beside) const {
        for (std::size_t i = 0; i < round.size(); ++i) {
            if (round[i].letter != beside[i].letter || round[i].successor != beside[i].successor)
                beside[i].field.refuse("it parts from the round by more than the place");
            if (round[i].place != beside[i].place) return;
        }
        proof_.at("beside").refuse("it does not part from the round");
    }

    const Checking& with_;
    const System& system_;
    const Field& proof_;
};

}  // namespace

void check_endless_tables(const Checking& with, const Language& language, const Field& proof) {
    proof.only({"by", "again", "other", "before", "round", "beside", "kept", "after"});
    if (language->kind != Tree::Kind::generated || language->system->context)
        proof.refuse("the language is not given by a system without context");
    Checker(with, *language->system, proof).check();
}

}  // namespace algae::verify
