#include "language/finite_family.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "language/finite_tables.hpp"

namespace algae {

namespace {

/// Works out a system from closed tables that generate the language together, leaving out tables and
/// rules, long ones first, without which they still do.
class WitnessBuilder {
public:
    WitnessBuilder(RuleSearch& search, std::vector<PossibleRules> tables)
        : search_(search), tables_(std::move(tables)) {
        for (const PossibleRules& table : tables_) steps_.push_back(search_.steps(table));
    }

    FiniteWitness witness(const FiniteLanguage& language, Family family, bool empty_axiom) {
        for (std::size_t i = tables_.size(); i-- > 0 && tables_.size() > 1;) leave_out_table(i);
        if (!family.deterministic)
            for (std::size_t i = 0; i < tables_.size(); ++i) leave_out_rules(i);
        FiniteWitness found{language.alphabet, axiom(language, empty_axiom), {}};
        for (const PossibleRules& table : tables_) {
            RuleTable& written = found.tables.emplace_back(language.alphabet->size());
            for (std::uint32_t x = 0; x < table.possible.size(); ++x)
                for (std::uint32_t u = 0; u < table.possible[x].size(); ++u) {
                    if (!table.possible[x][u]) continue;
                    const LetterRule rule = search_.rule(x, u);
                    written[rule.letter].push_back(rule.image);
                }
        }
        return found;
    }

private:
    StepRelation together() const {
        StepRelation all = steps_.front();
        for (const StepRelation& steps : steps_)
            for (std::size_t i = 0; i < all.size(); ++i)
                for (std::size_t j = 0; j < all.size(); ++j) all[i][j] |= steps[i][j];
        return all;
    }

    void leave_out_table(std::size_t i) {
        const auto place = static_cast<std::ptrdiff_t>(i);
        StepRelation steps = std::move(steps_[i]);
        steps_.erase(steps_.begin() + place);
        if (search_.unreached(together()))
            steps_.insert(steps_.begin() + place, std::move(steps));
        else
            tables_.erase(tables_.begin() + place);
    }

    void leave_out_rules(std::size_t i) {
        for (auto& images : tables_[i].possible)
            for (std::size_t u = images.size(); u-- > 0;) {
                if (!images[u] || std::count(images.begin(), images.end(), 1) == 1) continue;
                images[u] = 0;
                StepRelation steps = search_.steps(tables_[i]);
                std::swap(steps, steps_[i]);
                if (!search_.unreached(together())) continue;
                images[u] = 1;
                std::swap(steps, steps_[i]);
            }
    }

    Word axiom(const FiniteLanguage& language, bool empty_axiom) const {
        const auto first = RuleSearch::sources(together()).front();
        for (const std::uint32_t word : first)
            if (empty_axiom || !language.words[word].empty()) return language.words[word];
        return {};
    }

    RuleSearch& search_;
    std::vector<PossibleRules> tables_;
    std::vector<StepRelation> steps_;
};

}  // namespace

FamilyAnswer decide_family(const FiniteLanguage& language, Family family,
                           const FamilyOptions& options, const Budget& budget) {
    FamilyAnswer answer;
    FamilyObstruction obstruction{family, options.empty_axiom, language, {}, {}};
    try {
        const FiniteWords words(language, budget);
        RuleSearch search(language, words, family, options.empty_axiom, options.cases, budget);
        std::vector<PossibleRules> tables;
        if (family.tables) {
            tables = TableSearch(search).tables(obstruction);
        } else {
            PossibleRules rules = search.all_rules();
            if (search.narrow_to_solution(rules, true, obstruction.root))
                tables.push_back(std::move(rules));
        }
        if (tables.empty()) {
            answer.obstruction = std::move(obstruction);
            answer.truth = Truth::refuted;
        } else {
            answer.witness = WitnessBuilder(search, std::move(tables))
                                 .witness(language, family, options.empty_axiom);
            answer.truth = Truth::proved;
        }
    } catch (const BoundReached& bound) {
        answer.tried = "Rules were ruled out case by case, but " + std::string(bound.what()) + ".";
    }
    return answer;
}

}  // namespace algae
