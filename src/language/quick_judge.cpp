#include <algorithm>
#include <iterator>
#include <map>

#include "language/detail/finite_verdicts.hpp"
#include "system/system.hpp"
#include "verify/verify.hpp"

// What is true of languages with few words, without a proof?
//
// A search and a census put thousands of instances into one statement and want its truth; a proof they want of a few. Where all
// languages of a statement have few words, these are worked out here in the plainest way and compared. A system is derived step by
// step: when no new word comes, its language is what came. Everything else is left to the judges, which must be asked too where a proof is
// wanted. So this says nothing that they do not say; tests compare them.

namespace algae {

namespace {

using Kind = LanguageTree::Kind;

std::vector<Word> sorted_words(std::vector<Word> words) {
    std::sort(words.begin(), words.end(), shortlex_less);
    words.erase(std::unique(words.begin(), words.end()), words.end());
    return words;
}

/// Of languages with more words the judge of the statement is asked.
constexpr std::size_t most_quick_words = 64;
/// Words of small systems that are longer mostly belong to an infinite language.
constexpr std::size_t most_quick_length = 20;

}  // namespace

QuickJudge::QuickJudge(const Claim& claim, const Budget& budget)
    : claim_(claim), budget_(budget), verdicts_(claim.empty_axiom) {}

/// What a statement says, each form that few words decide.
struct QuickJudge::Judge {
    QuickJudge& judge;

    std::optional<Truth> operator()(const InFamily& said) const {
        return judge.in_family(said.language, said.family);
    }
    std::optional<Truth> operator()(const IsFinite& said) const {
        return judge.words(said.language) ? std::optional(Truth::proved) : std::nullopt;
    }
    std::optional<Truth> operator()(const IsEmpty& said) const {
        const auto known = judge.words(said.language);
        return known ? truth_of(known->empty()) : std::nullopt;
    }
    std::optional<Truth> operator()(const HasSize& said) const {
        const auto known = judge.words(said.language);
        return known ? truth_of(Integer(std::uint64_t{known->size()}) == said.size) : std::nullopt;
    }
    std::optional<Truth> operator()(const HasWord& said) const {
        const auto known = judge.words(said.language);
        if (!known) return std::nullopt;
        return truth_of(std::binary_search(known->begin(), known->end(), said.word, shortlex_less));
    }
    std::optional<Truth> operator()(const EqualLanguages& said) const {
        const auto left = judge.words(said.left);
        const auto right = left ? judge.words(said.right) : std::nullopt;
        return right ? truth_of(*left == *right) : std::nullopt;
    }
    std::optional<Truth> operator()(const IncludedIn& said) const {
        const auto inner = judge.words(said.inner);
        const auto outer = inner ? judge.words(said.outer) : std::nullopt;
        if (!outer) return std::nullopt;
        return truth_of(std::includes(outer->begin(), outer->end(), inner->begin(), inner->end(),
                                      shortlex_less));
    }
    std::optional<Truth> operator()(const Joint& said) const {
        std::vector<bool> holds;
        for (const Statement& part : said.parts) {
            const std::optional<Truth> found = judge.truth(part);
            if (!found) return std::nullopt;
            holds.push_back(*found == Truth::proved);
        }
        switch (said.kind) {
            case Joint::Kind::all:
                return truth_of(std::count(holds.begin(), holds.end(), false) == 0);
            case Joint::Kind::any:
                return truth_of(std::count(holds.begin(), holds.end(), true) > 0);
            case Joint::Kind::implies:
                return truth_of(!holds.at(0) || holds.at(1));
            case Joint::Kind::iff:
                return truth_of(holds.at(0) == holds.at(1));
        }
        return std::nullopt;
    }
    template <class Other>
    std::optional<Truth> operator()(const Other&) const {
        return std::nullopt;
    }

    static std::optional<Truth> truth_of(bool holds) {
        return holds ? Truth::proved : Truth::refuted;
    }
};

std::optional<Truth> QuickJudge::truth(const Statement& statement) {
    const std::optional<Truth> found = std::visit(Judge{*this}, statement.says);
    return found && statement.negated ? std::optional(opposite(*found)) : found;
}

namespace {

/// The place of a family in `all_families()`.
std::optional<std::size_t> number_of_family(const std::string& name) {
    static const std::map<std::string, std::size_t> numbers = [] {
        std::map<std::string, std::size_t> made;
        for (const Family each : all_families()) made.emplace(to_string(each), made.size());
        return made;
    }();
    const auto found = numbers.find(name);
    return found == numbers.end() ? std::nullopt : std::optional(found->second);
}

std::size_t hash_of(const std::vector<Word>& words) {
    std::size_t hash = words.size();
    const auto mix = [&](std::size_t value) {
        hash = (hash ^ value) * static_cast<std::size_t>(0x9E3779B97F4A7C15u);
    };
    for (const Word& word : words) {
        mix(word.size());
        for (const Symbol a : word) mix(a);
    }
    return hash ^ hash >> 29;
}

}  // namespace

std::optional<Truth> QuickJudge::in_family(const Language& language, const std::string& family) {
    const auto number = number_of_family(family);
    if (!number) {
        const bool has_all_finite = family == "REG" || family == "CF";
        return has_all_finite && words(language) ? std::optional(Truth::proved) : std::nullopt;
    }
    if (language->kind == Kind::generated && has_form(*language->system, *system_form(family)))
        return Truth::proved;
    const auto known = words(language);
    if (!known) return std::nullopt;
    constexpr std::size_t kept = 4096;
    recent_.resize(kept);
    Recent& recent = recent_[hash_of(*known) % kept];
    if (!recent.families || recent.words != *known)
        recent = {*known, verdicts_.of(*known, budget_)};
    if (!recent.families) return std::nullopt;
    return *recent.families >> *number & 1 ? Truth::proved : Truth::refuted;
}

std::optional<std::vector<Word>> QuickJudge::words(const Language& language) {
    const LanguageTree& tree = *language;
    const auto both = [&](auto make) -> std::optional<std::vector<Word>> {
        const auto left = words(tree.parts[0]);
        const auto right = left ? words(tree.parts[1]) : std::nullopt;
        if (!right) return std::nullopt;
        std::vector<Word> made;
        make(*left, *right, made);
        if (made.size() > most_quick_words) return std::nullopt;
        return made;
    };
    switch (tree.kind) {
        case Kind::words:
            if (tree.words.size() > most_quick_words) return std::nullopt;
            return tree.words;
        case Kind::generated:
            return derived(tree.system);
        case Kind::united:
            return both([](const auto& left, const auto& right, auto& made) {
                std::set_union(left.begin(), left.end(), right.begin(), right.end(),
                               std::back_inserter(made), shortlex_less);
            });
        case Kind::intersected:
            return both([](const auto& left, const auto& right, auto& made) {
                std::set_intersection(left.begin(), left.end(), right.begin(), right.end(),
                                      std::back_inserter(made), shortlex_less);
            });
        case Kind::difference:
            return both([](const auto& left, const auto& right, auto& made) {
                std::set_difference(left.begin(), left.end(), right.begin(), right.end(),
                                    std::back_inserter(made), shortlex_less);
            });
        case Kind::concatenated:
            return both([](const auto& left, const auto& right, auto& made) {
                for (const Word& u : left)
                    for (const Word& v : right) {
                        made.push_back(u);
                        made.back().insert(made.back().end(), v.begin(), v.end());
                    }
                made = sorted_words(std::move(made));
            });
        case Kind::reversed: {
            auto known = words(tree.parts[0]);
            if (!known) return std::nullopt;
            for (Word& word : *known) std::reverse(word.begin(), word.end());
            return sorted_words(std::move(*known));
        }
        case Kind::image: {
            if (tree.variable) return std::nullopt;
            const auto known = words(tree.parts[0]);
            if (!known) return std::nullopt;
            std::vector<Word> images;
            for (const Word& word : *known)
                if (auto image = tree.morphism.image_of(word)) images.push_back(std::move(*image));
            return sorted_words(std::move(images));
        }
        default:
            return std::nullopt;
    }
}

/// Step by step, all words; they are finitely many if no new one comes.
std::optional<std::vector<Word>> QuickJudge::derived(
    const std::shared_ptr<const SourceSystem>& system) {
    if (!system || !system->tables || !has_only_terminals(*system->tables)) return std::nullopt;
    if (last_system_ == system) return last_derived_;
    last_system_ = system;
    last_derived_.reset();
    const ET0L& rules = *system->tables;
    std::vector<Word> found{rules.axiom};
    for (std::size_t i = 0; i < found.size(); ++i)
        for (const Table& table : rules.tables) {
            std::vector<Word> made{{}};
            for (const Symbol a : found[i]) {
                std::vector<Word> longer;
                for (const Word& begun : made)
                    for (const Word& image : table[a]) {
                        longer.push_back(begun);
                        longer.back().insert(longer.back().end(), image.begin(), image.end());
                    }
                made = table[a].size() > 1 ? sorted_words(std::move(longer)) : std::move(longer);
                if (made.size() > most_quick_words) return std::nullopt;
            }
            for (Word& word : made) {
                if (std::find(found.begin(), found.end(), word) != found.end()) continue;
                if (found.size() == most_quick_words || word.size() > most_quick_length)
                    return std::nullopt;
                found.push_back(std::move(word));
            }
        }
    last_derived_ = sorted_words(std::move(found));
    return last_derived_;
}

std::shared_ptr<QuickJudge> QuickJudges::take() {
    std::unique_ptr<QuickJudge> judge;
    {
        const std::lock_guard lock(guard_);
        if (!free_.empty()) {
            judge = std::move(free_.back());
            free_.pop_back();
        }
    }
    if (!judge) judge = std::make_unique<QuickJudge>(claim_, budget_);
    return {judge.release(), [this](QuickJudge* used) {
                std::unique_ptr<QuickJudge> back(used);
                const std::lock_guard lock(guard_);
                free_.push_back(std::move(back));
            }};
}

}  // namespace algae
