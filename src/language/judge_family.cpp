#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <set>

#include "growth/growth.hpp"
#include "language/detail/finite_family.hpp"
#include "language/detail/judge.hpp"
#include "language/detail/powers.hpp"
#include "language/detail/progressions.hpp"
#include "language/detail/proof.hpp"

// Whether a language is of a family: REG, CF, or a family of L-systems.
//
// That it is: it is given by a system of the form, equal to the language of a system of the claim, finite, or
// made by operations under which the family is closed. That it is not is decided for finite languages
// (finite_family.cpp), shown by the empty word for propagating families, and for REG and CF by the lengths of
// D0L languages that grow faster than linearly (`sparse`). Infinite regular languages have a file of their own (regular_family.cpp).
//
// Languages of powers: {a^n b^n : n >= 0} and all whose blocks grow linearly, each with a letter of its own, are not T0L
// (`LinearBlocks`). An infinite language over one letter whose lengths are too few for two successors of the letter, as the powers of 2
// and those of 3, is T0L only if each length but the least is a multiple of another by the number of a table (`NotGeometric`). Others are
// looked for among D0L systems that take word n to word n + 1. Otherwise the statement is undecided.

namespace algae {

namespace {

using Kind = LanguageTree::Kind;

class FamilyJudge {
public:
    FamilyJudge(const Language& language, const FamilyQuestion& question, const Alphabet& alphabet,
                const Budget& budget)
        : language_(language),
          question_(question),
          alphabet_(alphabet),
          budget_(budget),
          name_(to_string(language, alphabet)) {}

    Answer judge() const {
        if (question_.family == "REG" || question_.family == "CF") return chomsky();
        const std::optional<SystemForm> form = system_form(question_.family);
        if (!form) throw Error(question_.family + " is no family of languages");
        if (language_->kind == Kind::generated && has_form(*language_->system, *form))
            return proved(steps::HasForm{language_, question_.family});
        const bool is_among_eight = !form->interactive && !form->extended;
        const bool is_never_empty = form->propagating && !question_.empty_axiom;
        if (is_never_empty && !is_among_eight)
            if (auto found = has_empty_word()) return *found;
        if (const auto known = finite_value(language_, alphabet_, budget_))
            return finite(*known, *form);
        if (is_never_empty && is_among_eight)
            if (auto found = has_empty_word()) return *found;
        if (auto found = by_system(*form)) return *found;
        if (!form->interactive && !form->extended)
            if (const auto value = regular_value(language_, alphabet_, budget_))
                return judge_regular_family(language_, *value, question_, alphabet_, budget_);
        if (auto found = by_sequence(*form)) return *found;
        if (!form->interactive && !form->extended) {
            if (language_->kind == Kind::powers && are_linear_blocks(*language_->powers))
                return refuted(steps::LinearBlocks{language_, question_.family});
            if (auto found = not_geometric(*form)) return *found;
        }
        if (language_->kind == Kind::reversed && !form->interactive)
            if (auto found = by_reversal()) return *found;
        if (form->extended)
            if (auto found = by_construction(*form)) return *found;
        return undecided(name_ + " was not found to be finite or regular" +
                         (question_.systems.empty()
                              ? ""
                              : ", and none of the systems of the claim was seen to generate it") +
                         "; that no " + question_.family +
                         " system does is decided for few other languages");
    }

private:
    Answer chomsky() const {
        // Of a grammar this is seen at once, and all words of a finite one may be many.
        if (question_.family == "CF" && language_->kind == Kind::generated &&
            is_context_free(language_))
            return proved(steps::ContextFree{language_});
        if (const auto known = finite_value(language_, alphabet_, budget_))
            return proved(steps::FiniteOfFamily{known->known, question_.family});
        if (regular_value(language_, alphabet_, budget_))
            return proved(steps::RegularOperations{language_, question_.family});
        if (question_.family == "CF" && is_context_free(language_))
            return proved(steps::ContextFree{language_});
        if (auto found = sparse()) return *found;
        if (auto found = by_linear_growth()) return *found;
        if (language_->kind == Kind::powers)
            if (auto beyond = beyond_family(*language_->powers, question_.family))
                return refuted(steps::PowersBeyond{language_, question_.family, *beyond});
        if (question_.family == "CF")
            return undecided("no context-free grammar for " + name_ + " is at hand");
        return undecided("no regular expression for " + name_ +
                         " is at hand, and whether a context-free language, and so one of an E0L "
                         "system, is regular is undecidable (Bar-Hillel, Perles and Shamir 1961)");
    }

    /// Whether the language is made of context-free ones by operations under which these are closed.
    bool is_context_free(const Language& language) const {
        const LanguageTree& tree = *language;
        const auto part = [&](std::size_t i) { return is_context_free(tree.parts[i]); };
        const auto is_regular = [&](std::size_t i) {
            return regular_value(tree.parts[i], alphabet_, budget_).has_value();
        };
        switch (tree.kind) {
            case Kind::generated:
                if (tree.system->tables && has_identities(*tree.system->tables)) return true;
                break;
            case Kind::powers:
                if (is_nested(*tree.powers)) return true;
                break;
            case Kind::united:
            case Kind::concatenated:
                return part(0) && part(1);
            case Kind::star:
            case Kind::plus:
            case Kind::reversed:
            case Kind::image:
            case Kind::inverse_image:
                return part(0);
            case Kind::intersected:
                return (part(0) && is_regular(1)) || (is_regular(0) && part(1));
            case Kind::difference:
                return part(0) && is_regular(1);
            default:
                break;
        }
        return regular_value(language, alphabet_, budget_).has_value();
    }

    /// Whether each letter may stay as it is, so that a derivation may rewrite one letter at a time.
    static bool has_identities(const ET0L& system) {
        if (system.tables.size() != 1) return false;
        const Table& table = system.tables.front();
        for (const Symbol a : accessible_letters(system))
            if (std::find(table[a].begin(), table[a].end(), Word{a}) == table[a].end())
                return false;
        return true;
    }

    /// Words of a propagating system are at least as long as its axiom.
    std::optional<Answer> has_empty_word() const {
        const Answer found = judge_membership(language_, {}, alphabet_, budget_);
        if (found.truth != Truth::proved) return std::nullopt;
        return refuted(steps::HasEmptyWord{language_, question_.family, found.proof});
    }

    /// The lengths of a context-free language are, with finitely many exceptions, all numbers in some classes of
    /// numbers modulo some period (Parikh 1966), so of the numbers up to x infinitely often more than a fixed
    /// share. The lengths of a D0L language whose words grow faster than linearly are fewer.
    std::optional<Answer> sparse() const {
        if (language_->kind != Kind::generated || !language_->system->tables) return std::nullopt;
        const ET0L& tables = *language_->system->tables;
        if (tables.tables.size() != 1 || !has_only_terminals(tables) || !is_deterministic(tables))
            return std::nullopt;
        const GrowthOrder order = growth_class(as_d0l(*language_->system), budget_).order;
        if (order.kind != GrowthKind::exponential &&
            (order.kind != GrowthKind::polynomial || order.degree < 2))
            return std::nullopt;
        return refuted(steps::Sparse{language_, question_.family, order});
    }

    /// D0L languages whose lengths grow linearly: whether they are regular is decided (deterministic_regularity.cpp).
    std::optional<Answer> by_linear_growth() const {
        if (language_->kind != Kind::generated || language_->system->variable ||
            !has_form(*language_->system, *system_form("D0L")))
            return std::nullopt;
        const auto found = regularity(as_d0l(*language_->system), budget_);
        if (!found) return std::nullopt;
        if (const auto* regular = std::get_if<Progressions>(&*found))
            return proved(steps::RegularProgressions{language_, question_.family, regular->first,
                                                     regular->period});
        if (question_.family != "REG") return std::nullopt;
        return refuted(
            steps::UnequalPowers{language_, question_.family, std::get<SectionOfPowers>(*found)});
    }

    Answer finite(const FiniteValue& known, const SystemForm& form) const {
        const auto& all = all_families();
        const auto family = std::find_if(all.begin(), all.end(), [&](Family each) {
            return to_string(each) == question_.family;
        });
        if (family == all.end()) return all_finite(known, form);
        const FiniteLanguage words =
            make_finite_language(std::make_shared<const Alphabet>(alphabet_), known.words);
        FamilyOptions options;
        options.empty_axiom = question_.empty_axiom;
        auto answer =
            std::make_shared<const FamilyAnswer>(decide_family(words, *family, options, budget_));
        if (answer->truth == Truth::undecided) {
            Answer open = undecided(answer->tried);
            open.out_of_time = answer->out_of_time;
            return open;
        }
        return decided(answer->truth == Truth::proved, steps::FiniteFamily{known.known, answer});
    }

    Answer all_finite(const FiniteValue& known, const SystemForm& form) const {
        const bool has_empty = std::any_of(known.words.begin(), known.words.end(),
                                           [](const Word& word) { return word.empty(); });
        const bool is_rewritten =
            known.words.size() <= 1 || !form.deterministic || form.tables;  // to each of them
        const bool every = (form.extended && !form.interactive && is_rewritten &&
                            !(form.propagating && has_empty)) ||
                           (form.interactive && !form.extended && !form.one_sided &&
                            !form.context && !form.propagating);
        if (!every)
            return undecided(name_ + " is finite, and whether it is " + question_.family +
                             " is not decided");
        const bool has_axiom =
            question_.empty_axiom || std::any_of(known.words.begin(), known.words.end(),
                                                 [](const Word& word) { return !word.empty(); });
        if (form.interactive && !has_axiom)
            return undecided("no word of " + name_ + " can be the axiom");
        return proved(steps::FiniteOfFamily{known.known, question_.family});
    }

    std::optional<Answer> by_system(const SystemForm& form) const {
        for (const auto& system : question_.systems) {
            if (!has_form(*system, form)) continue;
            const Answer equal =
                judge_equality(generated_language(system), language_, alphabet_, budget_);
            if (equal.truth == Truth::proved)
                return proved(steps::GeneratedBy{system, question_.family, language_, equal.proof});
        }
        return std::nullopt;
    }

    /// A language of powers of one number is that of a D0L system which takes each word to that of the next number: its rules are
    /// worked out from the first three words.
    std::optional<Answer> by_sequence(const SystemForm& form) const {
        if (language_->kind != Kind::powers || language_->powers->numbers.size() != 1)
            return std::nullopt;
        constexpr std::size_t longest = 2'000;
        std::array<Word, 3> words;
        for (std::size_t n = 0; n < words.size(); ++n) {
            try {
                words[n] = word_of(*language_->powers,
                                   {language_->powers->numbers.front().least + n}, budget_);
            } catch (const BoundReached&) {
                return std::nullopt;
            }
            if (words[n].size() > longest) return std::nullopt;
        }
        if (words[0].empty()) return std::nullopt;
        std::map<Symbol, Word> images;
        std::size_t left = 20'000;  // steps of the search
        std::optional<Answer> found;
        const std::function<void(std::size_t, std::size_t, std::size_t)> match =
            [&](std::size_t n, std::size_t place, std::size_t end) {
                if (found || left == 0) return;
                --left;
                if (place == words[n].size()) {
                    if (end < words[n + 1].size()) return;
                    if (n + 2 < words.size()) return match(n + 1, 0, 0);
                    found = by_rules(form, words[0], images);
                    return;
                }
                const Symbol a = words[n][place];
                const auto from = words[n + 1].begin() + static_cast<std::ptrdiff_t>(end);
                if (const auto known = images.find(a); known != images.end()) {
                    const Word& image = known->second;
                    if (image.size() <= words[n + 1].size() - end &&
                        std::equal(image.begin(), image.end(), from))
                        match(n, place + 1, end + image.size());
                    return;
                }
                for (std::size_t size = form.propagating ? 1 : 0;
                     end + size <= words[n + 1].size() && !found; ++size) {
                    images[a] = Word(from, from + static_cast<std::ptrdiff_t>(size));
                    match(n, place + 1, end + size);
                    images.erase(a);
                }
            };
        match(0, 0, 0);
        return found;
    }

    std::optional<Answer> by_rules(const SystemForm& form, const Word& axiom,
                                   const std::map<Symbol, Word>& images) const {
        Table table(alphabet_.size());
        for (Symbol a = 0; a < table.size(); ++a) table[a] = {{a}};
        for (const auto& [a, image] : images) table[a] = {image};
        const auto system = std::make_shared<const SourceSystem>(
            SourceSystem{"G",
                         ET0L{std::make_shared<const Alphabet>(alphabet_),
                              axiom,
                              {table},
                              std::vector<char>(alphabet_.size(), 1),
                              {"1"},
                              {}},
                         std::nullopt,
                         {},
                         {}});
        if (!has_form(*system, form)) return std::nullopt;
        const auto sequence = sequence_of(language_);
        if (!sequence || !follows(as_d0l(*system), *sequence)) return std::nullopt;
        const Answer equal =
            judge_equality(generated_language(system), language_, alphabet_, budget_);
        if (equal.truth != Truth::proved) return std::nullopt;
        return proved(steps::GeneratedBy{system, question_.family, language_, equal.proof, true});
    }

    /// Whether the words are a^e b^f ... with two letters or more, each in one block, and exponents that all grow linearly with the
    /// one number.
    static bool are_linear_blocks(const Powers& powers) {
        if (powers.numbers.size() != 1 || powers.blocks.size() < 2 || !is_linear(powers))
            return false;
        std::set<Symbol> letters;
        for (const Powers::Block& block : powers.blocks)
            if (block.word.size() != 1 || !letters.insert(block.word.front()).second ||
                std::none_of(block.exponent.begin(), block.exponent.end(),
                             [](const Powers::Term& term) { return term.number.has_value(); }))
                return false;
        return true;
    }

    /// Whether the lengths of a language over one letter are seen to be a share of the numbers up to x that tends to 0.
    static bool is_sparse(const Language& language) {
        const LanguageTree& tree = *language;
        switch (tree.kind) {
            case Kind::words:
                return true;
            case Kind::powers:
                return tree.powers->numbers.size() == 1 && !is_linear(*tree.powers);
            case Kind::generated:
                return tree.system->tables && tree.system->grammar.empty() &&
                       has_only_terminals(*tree.system->tables) &&
                       is_deterministic(*tree.system->tables);
            case Kind::united:
                return is_sparse(tree.parts[0]) && is_sparse(tree.parts[1]);
            case Kind::reversed:
                return is_sparse(tree.parts[0]);
            default:
                return false;
        }
    }

    std::optional<Answer> not_geometric(const SystemForm& form) const {
        constexpr std::uint64_t longest = 100, longest_image = 400;
        const std::vector<Symbol> letters = letters_of(language_);
        if (letters.size() != 1 || !is_sparse(language_)) return std::nullopt;
        const Answer finite = judge_finite(language_, alphabet_, budget_);
        if (finite.truth != Truth::refuted) return std::nullopt;
        std::map<std::uint64_t, Truth> known;
        const auto in = [&](std::uint64_t length) {
            const auto [place, is_new] = known.try_emplace(length, Truth::undecided);
            if (is_new)
                place->second =
                    judge_membership(language_,
                                     Word(static_cast<std::size_t>(length), letters.front()),
                                     alphabet_, budget_)
                        .truth;
            return place->second;
        };
        std::vector<std::uint64_t> lengths;
        const auto takes_all = [&](std::uint64_t s) {
            return std::all_of(lengths.begin(), lengths.end(), [&](std::uint64_t z) {
                return s * z > longest_image || in(s * z) != Truth::refuted;
            });
        };
        for (std::uint64_t length = 1; length <= longest; ++length) {
            if (in(length) == Truth::undecided) return std::nullopt;
            if (in(length) != Truth::proved) continue;
            lengths.push_back(length);
            const std::size_t last = lengths.size() - 1;
            if (last == 0) continue;
            bool comes = false;
            if (form.tables)
                for (std::size_t i = 0; i < last && !comes; ++i)
                    comes = length % lengths[i] == 0 && takes_all(length / lengths[i]);
            else
                comes = lengths[1] % lengths[0] == 0 &&
                        length == lengths[last - 1] * (lengths[1] / lengths[0]);
            if (!comes)
                return refuted(steps::NotGeometric{language_, question_.family, finite.proof,
                                                   length, lengths, form.tables});
        }
        return std::nullopt;
    }

    std::optional<Answer> by_reversal() const {
        const Answer part = judge_family(language_->parts[0], question_, alphabet_, budget_);
        if (part.truth == Truth::undecided) return std::nullopt;
        const bool holds = part.truth == Truth::proved;
        return decided(holds, steps::OfReversal{language_, question_.family, holds, part.proof});
    }

    std::optional<Answer> by_construction(const SystemForm& form) const {
        auto tables = table_value(language_, alphabet_, budget_, form.deterministic);
        if (!tables || !has_form(SourceSystem{{}, tables->system, std::nullopt}, form))
            return std::nullopt;
        return proved(steps::Constructed{std::move(*tables)});
    }

    const Language& language_;
    const FamilyQuestion& question_;
    const Alphabet& alphabet_;
    const Budget& budget_;
    std::string name_;
};

}  // namespace

Answer judge_family(const Language& language, const FamilyQuestion& question,
                    const Alphabet& alphabet, const Budget& budget) {
    return FamilyJudge(language, question, alphabet, budget).judge();
}

}  // namespace algae
