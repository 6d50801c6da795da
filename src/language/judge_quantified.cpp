#include <algorithm>
#include <atomic>
#include <map>
#include <set>
#include <utility>

#include "language/detail/finite_verdicts.hpp"
#include "language/detail/judge.hpp"
#include "language/detail/proof.hpp"
#include "search/search.hpp"
#include "watch/watch.hpp"

// Statements about all values of some names, or about some values.
//
// The room `search` gives the instances, tuples of values, in a fixed order and each once up to renaming; here an
// instance is put into the conditions and the body (`Substitution`), and the judges of closed statements decide
// these. An instance counts if all conditions are proved of it. A counterexample (of `for all`) is one whose body is
// refuted, an example (of `for some`) one whose body is proved: such an instance is the proof, and it needs nothing
// of the search. If the domain has bounds and every instance is decided, the statement is decided by cases; without
// bounds nothing but a witness decides it here. An undecided instance neither refutes nor supports anything; a
// witness is the least one if no instance before it is undecided.
//
// Complements are over the letters of the file, to which those of the values are added: one alphabet for all complements of an
// instance, so that ~(A | B) == ~A & ~B holds for all of them.
//
// A renaming of letters does not change whether a statement holds, unless it names letters itself, in a word or in a
// system of the claim. Then each instance is tried under all names: its letters go, in every way, to those that the
// statement names and to new ones.
//
// Languages of a family are searched among finite languages, for which membership in the families of 0L systems is
// decided; so a counterexample that needs an infinite language is not found, and the verdict is `undecided`.
//
// Most instances are as the statement says, and their proofs are not wanted: where few words decide an instance, a verdict
// comes first (detail/finite_verdicts.hpp), and the judges, which bring proofs, are asked only about witnesses and what has no
// such verdict.
//
// Many counterexamples are empty: {a} & {b} = {} is not 0L, as no system has an empty language. If the least
// counterexample to `X is FAMILY` has no word but ε, the search goes on for one with such a word, and the argument
// names both.

namespace algae {

namespace {

using Kind = LanguageTree::Kind;
using Images = std::vector<std::pair<Symbol, std::vector<Word>>>;

// --- Putting values in the place of bound names ---

/// Thrown where a bound morphism has no image for a letter of the language that it is applied to: this is no instance.
struct NoImage : Error {
    NoImage()
        : Error("a morphism has no image for a letter of the language that it is applied to") {}
};

/// Replaces the bound names of a statement by values.
class Substitution {
public:
    explicit Substitution(const std::vector<BoundValue>& values) : values_(values) {
        for (const BoundValue& value : values)
            if (value.letter) words_.emplace(*value.letter, std::get<Word>(value.is));
    }

    Statement operator()(const Statement& statement) const {
        Statement closed = statement;
        std::visit([&](auto& said) { put(said); }, closed.says);
        return closed;
    }

    Language language(const Language& open) const {
        const LanguageTree& tree = *open;
        if (tree.kind == Kind::variable) {
            const BoundValue* value = find(tree.variable->number);
            return value ? std::get<Language>(value->is) : open;
        }
        LanguageTree closed = tree;
        for (Language& part : closed.parts) part = language(part);
        if (tree.kind == Kind::powers) closed.powers = powers(*tree.powers);
        for (Word& word : closed.words) word = replaced(word);
        if (tree.kind == Kind::words) return renamed(words_language(std::move(closed.words)), tree);
        if (tree.system) closed.system = system(tree.system);
        if (tree.kind == Kind::complement) closed.letters = with_letters_of_values(tree.letters);
        if (tree.kind == Kind::image || tree.kind == Kind::inverse_image) {
            const BoundValue* value = tree.variable ? find(tree.variable->number) : nullptr;
            if (value && std::holds_alternative<Images>(value->is))
                return substituted(closed.parts[0], std::get<Images>(value->is));
            if (value) {
                closed.morphism = std::get<Morphism>(value->is);
                if (tree.kind == Kind::image)
                    for (const Symbol a : letters_of(closed.parts[0]))
                        if (!closed.morphism.maps(a)) throw NoImage();
                closed.variable.reset();
            } else if (!tree.variable) {
                closed.morphism = replaced(tree.morphism);
            }
        }
        return std::make_shared<const LanguageTree>(std::move(closed));
    }

private:
    const BoundValue* find(std::size_t variable) const {
        for (const BoundValue& value : values_)
            if (value.variable == variable) return &value;
        return nullptr;
    }

    /// The letters of the file and those of all values, which complements are over.
    std::vector<Symbol> with_letters_of_values(const std::vector<Symbol>& letters) const {
        std::set<Symbol> all(letters.begin(), letters.end());
        const auto add = [&](const std::vector<Symbol>& more) {
            all.insert(more.begin(), more.end());
        };
        for (const BoundValue& value : values_) {
            if (const auto* words = std::get_if<Language>(&value.is)) {
                add(letters_of(*words));
            } else if (const auto* of =
                           std::get_if<std::shared_ptr<const SourceSystem>>(&value.is)) {
                add(letters_of(generated_language(*of)));
            } else if (const auto* morphism = std::get_if<Morphism>(&value.is)) {
                for (const Symbol a : morphism->domain()) {
                    all.insert(a);
                    add((*morphism)[a]);
                }
            } else if (const auto* images = std::get_if<Images>(&value.is)) {
                for (const auto& [letter, words_of_letter] : *images) {
                    all.insert(letter);
                    for (const Word& word : words_of_letter) add(word);
                }
            } else if (const auto* word = std::get_if<Word>(&value.is)) {
                add(*word);
            }
        }
        return {all.begin(), all.end()};
    }

    static Language renamed(Language language, const LanguageTree& from) {
        return from.name.empty() ? language : named(std::move(language), from.name);
    }

    std::shared_ptr<const SourceSystem> system(
        const std::shared_ptr<const SourceSystem>& open) const {
        const BoundValue* value = open->variable ? find(*open->variable) : nullptr;
        return value ? std::get<std::shared_ptr<const SourceSystem>>(value->is) : open;
    }

    Word replaced(const Word& word) const {
        if (words_.empty()) return word;
        Word all;
        for (const Symbol a : word) {
            const auto found = words_.find(a);
            if (found == words_.end())
                all.push_back(a);
            else
                all.insert(all.end(), found->second.begin(), found->second.end());
        }
        return all;
    }

    std::shared_ptr<const Powers> powers(Powers open) const {
        for (Powers::Block& block : open.blocks) {
            block.word = replaced(block.word);
            if (block.word.empty())
                throw Error(
                    "the value of a bound word is empty, and a power of it stands in a set");
        }
        return std::make_shared<const Powers>(std::move(open));
    }

    Morphism replaced(const Morphism& morphism) const {
        if (words_.empty()) return morphism;
        Morphism all;
        for (const Symbol a : morphism.domain()) all.add(a, replaced(morphism[a]));
        return all;
    }

    /// The image of a language under a finite substitution, as an expression.
    static Language substituted(const Language& language, const Images& images) {
        const LanguageTree& tree = *language;
        switch (tree.kind) {
            case Kind::words: {
                std::vector<Word> all;
                for (const Word& word : tree.words) {
                    std::vector<Word> made{{}};
                    for (const Symbol a : word) made = products(made, images_of(a, images));
                    all.insert(all.end(), made.begin(), made.end());
                }
                return words_language(std::move(all));
            }
            case Kind::united:
            case Kind::concatenated:
            case Kind::star:
            case Kind::plus: {
                std::vector<Language> parts;
                for (const Language& part : tree.parts) parts.push_back(substituted(part, images));
                return combined(tree.kind, std::move(parts));
            }
            default:
                throw Error(
                    "a finite substitution is applied to finite languages and their union, "
                    "concatenation and star");
        }
    }
    static const std::vector<Word>& images_of(Symbol letter, const Images& images) {
        const auto found = std::find_if(images.begin(), images.end(),
                                        [&](const auto& one) { return one.first == letter; });
        if (found == images.end()) throw NoImage();
        return found->second;
    }
    static std::vector<Word> products(const std::vector<Word>& left,
                                      const std::vector<Word>& right) {
        std::vector<Word> all;
        for (const Word& u : left)
            for (const Word& v : right) {
                all.push_back(u);
                all.back().insert(all.back().end(), v.begin(), v.end());
            }
        return all;
    }

    void put(InFamily& said) const { said.language = language(said.language); }
    void put(IsFinite& said) const { said.language = language(said.language); }
    void put(IsEmpty& said) const { said.language = language(said.language); }
    void put(EqualLanguages& said) const { said = {language(said.left), language(said.right)}; }
    void put(IncludedIn& said) const { said = {language(said.inner), language(said.outer)}; }
    void put(HasWord& said) const { said = {language(said.language), replaced(said.word)}; }
    void put(HasSize& said) const { said.language = language(said.language); }
    void put(IsCode& said) const { said.language = language(said.language); }
    void put(IsPalindrome& said) const { said.word = replaced(said.word); }
    void put(Derives& said) const {
        said.system = system(said.system);
        said.word = replaced(said.word);
        if (said.from) said.from = replaced(*said.from);
        if (!said.bound_steps) return;
        put_numbers(*said.bound_steps, said.numbers);
        std::erase_if(said.numbers, [&](const BoundName& name) { return find(name.number); });
        if (!said.numbers.empty()) return;
        const auto found = slope_and_start(*said.bound_steps, "");
        if (!found || !found->second.is_integer() || !found->second.numerator().fits_uint64())
            throw Error("expected a number of steps from 0 to 2^64, found " +
                        to_text(*said.bound_steps));
        said.steps = found->second.numerator().to_uint64();
        said.bound_steps.reset();
    }
    void put(EqualSequences& said) const { said = {system(said.left), system(said.right)}; }
    void put(EqualGrowth& said) const { said = {system(said.left), system(said.right)}; }
    void put(HasGrowthClass& said) const { said.system = system(said.system); }
    void put(IsIncreasing& said) const { said.system = system(said.system); }
    void put(ComparesNumbers& said) const {
        for (auto& one : said.systems) one = system(one);
        put_numbers(said.left, said.numbers);
        put_numbers(said.right, said.numbers);
        std::erase_if(said.numbers, [&](const BoundName& name) { return find(name.number); });
    }
    void put(ComparesWords& said) const {
        for (auto* side : {&said.left, &said.right})
            for (WordFactor& factor : *side) {
                if (factor.system) factor.system = system(factor.system);
                factor.word = replaced(factor.word);
                for (Morphism& image : factor.images) image = replaced(image);
                put_numbers(factor.generation, said.numbers);
            }
        std::erase_if(said.numbers, [&](const BoundName& name) { return find(name.number); });
    }
    /// Numbers in the place of their names.
    void put_numbers(Expression& term, const std::vector<BoundName>& names) const {
        if (term.kind == Expression::Kind::call && term.operands.size() == 1)
            for (const BoundValue& value : values_)
                if (value.letter && value.name == term.operands[0].name &&
                    term.operands[0].kind == Expression::Kind::name) {
                    term.kind = Expression::Kind::number;
                    term.value = Rational(Integer(std::uint64_t{std::get<Word>(value.is).size()}));
                    term.operands.clear();
                    return;
                }
        for (Expression& operand : term.operands) put_numbers(operand, names);
        if (term.kind != Expression::Kind::name) return;
        for (const BoundName& name : names) {
            const BoundValue* value = name.name == term.name ? find(name.number) : nullptr;
            if (!value) continue;
            term.kind = Expression::Kind::number;
            term.value = Rational(std::get<Integer>(value->is));
        }
    }
    void put(Rewrites&) const {}
    void put(HasChance&) const {}
    void put(HasDimension&) const {}
    void put(BoundaryHasDimension&) const {}
    void put(HoldsInWord& said) const { said.system = system(said.system); }
    void put(CountsInWord& said) const { said.system = system(said.system); }
    void put(HasCriticalExponent& said) const { said.system = system(said.system); }
    void put(IsCircular& said) const { said.system = system(said.system); }
    void put(Joint& said) const {
        for (Statement& part : said.parts) part = (*this)(part);
    }
    void put(Quantified& said) const {
        for (Statement& part : said.conditions) part = (*this)(part);
        for (Statement& part : said.body) part = (*this)(part);
    }

    const std::vector<BoundValue>& values_;
    std::map<Symbol, Word> words_;  // what stands in texts as a letter
};

// --- The letters that a statement names ---

/// Collects the letters that a statement names itself, outside of bound names.
class NamedLetters {
public:
    explicit NamedLetters(const Quantified& said) {
        for (const QuantifiedName& binding : said.bindings)
            if (binding.letter) bound_.insert(*binding.letter);
        for (const Statement& part : said.conditions) of(part);
        for (const Statement& part : said.body) of(part);
        for (const Symbol letter : bound_) found_.erase(letter);
    }

    std::vector<Symbol> letters() const { return {found_.begin(), found_.end()}; }

private:
    void of(const Statement& statement) {
        std::visit([&](const auto& said) { in(said); }, statement.says);
    }
    void in(const Word& word) { found_.insert(word.begin(), word.end()); }
    void in(const Language& language) {
        const LanguageTree& tree = *language;
        for (const Language& part : tree.parts) in(part);
        for (const Word& word : tree.words) in(word);
        if (tree.kind == Kind::generated) in(tree.system);
        if (tree.kind == Kind::powers) in(letters_of(language));
        if (tree.kind == Kind::complement) in(tree.letters);
        for (const Symbol a : tree.morphism.domain()) {
            found_.insert(a);
            in(tree.morphism[a]);
        }
    }
    void in(const std::shared_ptr<const SourceSystem>& system) {
        if (!system->variable) in(letters_of(generated_language(system)));
    }
    void in(const InFamily& said) { in(said.language); }
    void in(const IsFinite& said) { in(said.language); }
    void in(const IsEmpty& said) { in(said.language); }
    void in(const EqualLanguages& said) {
        in(said.left);
        in(said.right);
    }
    void in(const IncludedIn& said) {
        in(said.inner);
        in(said.outer);
    }
    void in(const HasWord& said) {
        in(said.language);
        in(said.word);
    }
    void in(const HasSize& said) { in(said.language); }
    void in(const IsCode& said) { in(said.language); }
    void in(const IsPalindrome& said) { in(said.word); }
    void in(const Derives& said) {
        in(said.system);
        in(said.word);
        if (said.from) in(*said.from);
    }
    void in(const EqualSequences& said) {
        in(said.left);
        in(said.right);
    }
    void in(const EqualGrowth&) {}
    void in(const HasGrowthClass&) {}
    void in(const IsIncreasing&) {}
    void in(const ComparesNumbers& said) {
        for (const auto& system : said.systems) in(system);
    }
    void in(const ComparesWords& said) {
        for (const auto* side : {&said.left, &said.right})
            for (const WordFactor& factor : *side) {
                if (factor.system) in(factor.system);
                in(factor.word);
                for (const Morphism& image : factor.images)
                    for (const Symbol a : image.domain()) {
                        found_.insert(a);
                        in(image[a]);
                    }
            }
    }
    void in(const Rewrites&) {}
    void in(const HasChance&) {}
    void in(const HasDimension&) {}
    void in(const BoundaryHasDimension&) {}
    void in(const HoldsInWord&) {}
    void in(const CountsInWord&) {}
    void in(const HasCriticalExponent&) {}
    void in(const IsCircular&) {}
    void in(const Joint& said) {
        for (const Statement& part : said.parts) of(part);
    }
    void in(const Quantified& said) {
        if (said.over) in(*said.over);
        for (const QuantifiedName& binding : said.bindings)
            if (binding.letter) bound_.insert(*binding.letter);
        for (const Statement& part : said.conditions) of(part);
        for (const Statement& part : said.body) of(part);
    }

    std::set<Symbol> found_, bound_;
};

// --- Instances as values over the alphabet of the claim ---

/// The values of an instance, whose letter i is called letters[i].
class InstanceReader {
public:
    InstanceReader(const Quantified& said, const Claim& claim) : said_(said), claim_(claim) {}

    std::vector<BoundValue> values(const Instance& instance,
                                   const std::vector<Symbol>& letters) const {
        std::vector<BoundValue> all;
        all.reserve(said_.bindings.size());
        for (std::size_t i = 0; i < said_.bindings.size(); ++i) {
            const QuantifiedName& binding = said_.bindings[i];
            BoundValue value{said_.first + i, binding.name, binding.letter, {}};
            value.is = of(instance, i, binding, letters);
            all.push_back(std::move(value));
        }
        return all;
    }

private:
    using Of = decltype(BoundValue::is);

    static Word moved(const Word& word, const std::vector<Symbol>& letters) {
        Word all(word.size());
        for (std::size_t i = 0; i < word.size(); ++i) all[i] = letters[word[i]];
        return all;
    }
    static std::vector<Word> moved(const std::vector<Word>& words,
                                   const std::vector<Symbol>& letters) {
        std::vector<Word> all;
        all.reserve(words.size());
        for (const Word& word : words) all.push_back(moved(word, letters));
        return all;
    }

    Of of(const Instance& instance, std::size_t i, const QuantifiedName& binding,
          const std::vector<Symbol>& letters) const {
        switch (binding.domain.kind) {
            case Domain::Kind::language:
                return named(words_language(moved(instance.language(i), letters)), binding.name);
            case Domain::Kind::system:
                return system(instance.et0l(i), binding, letters);
            case Domain::Kind::word:
                return moved(instance.word(i), letters);
            case Domain::Kind::letter:
                return Word{letters[instance.letter(i)]};
            case Domain::Kind::number:
                return Integer(instance.number(i));
            case Domain::Kind::substitution: {
                Images images;
                for (const auto& [letter, words] : instance.substitution(i))
                    images.emplace_back(letters[letter], moved(words, letters));
                return images;
            }
            case Domain::Kind::morphism:
            case Domain::Kind::inverse_morphism: {
                const bool inverse = binding.domain.kind == Domain::Kind::inverse_morphism;
                const Morphism morphism = instance.morphism(i);
                Morphism named_images;
                for (const Symbol a : morphism.domain())
                    named_images.add(inverse ? claim_.inverse_letters.at(a) : letters[a],
                                     moved(morphism[a], letters));
                return named_images;
            }
        }
        return {};
    }

    std::shared_ptr<const SourceSystem> system(const ET0L& instance, const QuantifiedName& binding,
                                               const std::vector<Symbol>& letters) const {
        const std::size_t all = claim_.alphabet->size();
        ET0L moved_system{claim_.alphabet,           moved(instance.axiom, letters), {},
                          std::vector<char>(all, 1), instance.table_names,           binding.name};
        for (const Table& table : instance.tables) {
            Table& target = moved_system.tables.emplace_back(all);
            for (Symbol a = 0; a < all; ++a) target[a] = {Word{a}};
            for (Symbol a = 0; a < table.size(); ++a) target[letters[a]] = moved(table[a], letters);
        }
        moved_system.table_names.resize(moved_system.tables.size());
        auto system = std::make_shared<SourceSystem>();
        system->name = binding.name;
        system->tables = std::move(moved_system);
        return system;
    }

    const Quantified& said_;
    const Claim& claim_;
};

/// Calls `use(letters)` with every way to call the `count` letters of an instance: by the letters that the statement
/// names, each at most once, and by new ones, these in order. Until it says false, which is then the result.
template <class Use>
bool each_naming(std::size_t count, const std::vector<Symbol>& fixed,
                 const std::vector<Symbol>& fresh, Use use) {
    std::vector<Symbol> letters;
    std::vector<char> taken(fixed.size(), 0);
    const auto choose = [&](auto& self, std::size_t next_fresh) -> bool {
        if (letters.size() == count) return use(letters);
        for (std::size_t i = 0; i < fixed.size(); ++i) {
            if (taken[i]) continue;
            taken[i] = 1;
            letters.push_back(fixed[i]);
            if (!self(self, next_fresh)) return false;
            letters.pop_back();
            taken[i] = 0;
        }
        letters.push_back(fresh.at(next_fresh));
        const bool more = self(self, next_fresh + 1);
        letters.pop_back();
        return more;
    };
    return choose(choose, 0);
}

// --- The search ---

/// How many cases with their proofs the answer holds.
std::uint64_t kept_cases(const Answer& answer) {
    if (!answer.proof) return 0;
    std::uint64_t count = 0;
    if (const auto* cases = std::get_if<steps::ByCases>(&answer.proof->step)) {
        for (const auto& each : cases->cases) count += 1 + kept_cases(each.answer);
    } else if (const auto* joint = std::get_if<steps::FromStatements>(&answer.proof->step)) {
        for (const auto& part : joint->parts) count += kept_cases(part.answer);
    } else if (const auto* one = std::get_if<steps::ByInstance>(&answer.proof->step)) {
        for (const Answer& condition : one->conditions) count += kept_cases(condition);
        count += kept_cases(one->body);
    }
    return count;
}

class QuantifiedJudge {
public:
    QuantifiedJudge(const Quantified& said, const Claim& claim, const Budget& budget,
                    const SearchLimits& limits)
        : said_(said),
          claim_(claim),
          budget_(budget),
          limits_(limits),
          quick_(claim, budget),
          reader_(said, claim),
          tuple_(tuple_of(said)) {
        if (said.over) return;
        fixed_ = NamedLetters(said).letters();
        for (const Symbol letter : claim.instance_letters)
            if (!std::binary_search(fixed_.begin(), fixed_.end(), letter)) fresh_.push_back(letter);
        tuple_.letters = fresh_.size();
    }

    Answer judge() {
        // Systems with the empty word as axiom are no instances.
        const bool is_complete =
            !claim_.empty_axiom || std::none_of(said_.bindings.begin(), said_.bindings.end(),
                                                [](const QuantifiedName& name) {
                                                    return name.domain.kind == Domain::Kind::system;
                                                });
        const bool is_bounded = is_complete && is_finite(tuple_);
        const auto greatest = greatest_size(tuple_);
        const bool is_about_numbers = std::all_of(
            said_.bindings.begin(), said_.bindings.end(),
            [](const QuantifiedName& name) { return name.domain.kind == Domain::Kind::number; });
        constexpr std::uint64_t largest_number =
            100;  // where only numbers are bound, without bounds
        const std::uint64_t size_limit =
            is_about_numbers ? std::max(limits_.size, largest_number) : limits_.size;
        const std::uint64_t last_size =
            is_bounded ? *greatest : std::min(size_limit, greatest.value_or(size_limit));
        searched_.finite_only = std::any_of(
            said_.bindings.begin(), said_.bindings.end(), [](const QuantifiedName& name) {
                return name.domain.kind == Domain::Kind::language &&
                       name.text != "finite languages" && !name.domain.max_word_length;
            });
        keeps_cases_ = is_bounded && !limits_.from;
        searched_.all = is_bounded;
        if (limits_.from) go_on_from(*limits_.from);
        for (std::uint64_t size = 0; size <= last_size && !is_over_; ++size)
            visit(
                tuple_, size, [&](const Instance& instance) { return gather(instance); }, budget_);
        if (!is_over_) look_at_gathered();
        if (is_stopped_by_limit_ || is_partial_) searched_.all = false;
        searched_.finite_only = searched_.finite_only || is_partial_;
        if (witness_) return answer_by(*witness_);
        const bool has_inverse = std::any_of(
            said_.bindings.begin(), said_.bindings.end(), [](const QuantifiedName& name) {
                return name.domain.kind == Domain::Kind::inverse_morphism;
            });
        // The letters of an inverse morphism's domain are called by new names only.
        const bool decided = searched_.instances > 0 && searched_.all && !searched_.finite_only &&
                             searched_.undecided == 0 && (fixed_.empty() || !has_inverse);
        if (!decided) {
            if (!is_stopped_by_limit_) searched_.size = last_size;
            Answer open = undecided(text_of_search());
            open.searched = searched_;
            return open;
        }
        if (kept_ > steps::ByCases::most_kept) cases_.clear();
        Answer by_cases = algae::decided(
            said_.universal, steps::ByCases{said_, searched_.instances, std::move(cases_)});
        by_cases.searched = searched_;
        return by_cases;
    }

private:
    struct Witness {
        steps::ByInstance step;
        bool trivial = false;
    };
    /// An instance with names for its letters; the first of its namings counts for all.
    struct Named {
        Instance instance;
        std::vector<Symbol> letters;
        bool is_first = true;
    };
    /// What is found of it: it does not meet the conditions, is as the statement says, is undecided, or decides the
    /// statement.
    struct Found {
        enum class Kind { outside, as_said, undecided, witness, none } kind = Kind::outside;
        bool meets = false;  // all conditions are proved
        std::optional<Witness> witness = {};
        std::optional<steps::ByCases::Case> known =
            {};  // of an instance that is decided and no witness
    };

    void go_on_from(const SearchedSoFar& before) {
        known_ = before.visited;
        searched_.visited = before.visited;
        searched_.instances = before.instances;
        searched_.undecided = before.undecided;
        searched_.size = before.size;
        is_partial_ = before.is_partial;
    }

    /// Adds an instance to those that are looked at together: few at first, so that an early witness is found early,
    /// then many. False when the search is over.
    bool gather(const Instance& instance) {
        if (visited_ == limits_.instances && !searched_.all) {
            look_at_gathered();
            is_over_ = is_stopped_by_limit_ = true;
            return false;
        }
        if (visited_++ < known_) return true;
        bool is_first = true;
        const auto add = [&](const std::vector<Symbol>& letters) {
            gathered_.push_back({instance, letters, std::exchange(is_first, false)});
            return true;
        };
        if (said_.over)
            add(*said_.over);
        else
            each_naming(instance.letters(), fixed_, fresh_, add);
        if (gathered_.size() < batch_) return true;
        look_at_gathered();
        return !is_over_;
    }

    /// Decides the gathered instances by all threads, then goes through them in their order, up to the first that
    /// ends the search: what is found does not depend on the threads.
    void look_at_gathered() {
        std::vector<Found> found(gathered_.size());
        const auto worker = [&]() -> PartWorker {
            return [&, quick = quick_.take()](std::size_t i) {
                found[i] = look_at(gathered_[i], *quick);
            };
        };
        each_part(gathered_.size(), limits_.threads, budget_, worker);
        for (std::size_t i = 0; i < found.size() && !is_over_; ++i) {
            if (gathered_[i].is_first) ++searched_.visited;
            searched_.size = gathered_[i].instance.size();
            if (found[i].kind == Found::Kind::none) is_partial_ = true;  // others have more images
            if (found[i].meets) ++searched_.instances;
            if (found[i].kind == Found::Kind::undecided && !witness_) ++searched_.undecided;
            if (found[i].kind == Found::Kind::witness)
                is_over_ = keep(std::move(*found[i].witness));
            if (found[i].known) cases_.push_back(std::move(*found[i].known));
        }
        gathered_.clear();
        looked_at_.at(visited_, "size " + std::to_string(searched_.size));
        constexpr std::size_t most = 1024;
        batch_ = std::min(2 * batch_, most);
        if (limits_.on_searched && !witness_)
            limits_.on_searched({searched_.visited, searched_.instances, searched_.undecided,
                                 searched_.size, is_partial_});
        if (limits_.progress)
            limits_.progress->report(std::min(
                1.0, static_cast<double>(visited_) /
                         static_cast<double>(std::max<std::uint64_t>(limits_.instances, 1))));
    }

    Found look_at(const Named& named, QuickJudge& quick) const {
        try {
            return decided(named, quick);
        } catch (const NoImage&) {
            return {.kind = Found::Kind::none};
        }
    }

    /// What is kept of an instance that decides nothing alone, as long as there are few.
    std::optional<steps::ByCases::Case> kept(std::vector<BoundValue> values,
                                             std::optional<std::size_t> member,
                                             std::optional<std::size_t> condition,
                                             Answer answer) const {
        if (!is_keeping()) return std::nullopt;
        const std::uint64_t count = 1 + kept_cases(answer);
        if ((kept_ += count) > steps::ByCases::most_kept) return std::nullopt;
        return steps::ByCases::Case{std::move(values), member, condition, std::move(answer)};
    }

    bool is_keeping() const {
        return keeps_cases_ && !witness_ && kept_ <= steps::ByCases::most_kept;
    }

    /// That a value is of the family that its name ranges over.
    Statement member(const std::vector<BoundValue>& values, std::size_t i) const {
        Statement said;
        said.says = InFamily{std::get<Language>(values[i].is), said_.bindings[i].family};
        return said;
    }

    /// What verdicts say that need no proofs; nothing where there are none, and of a witness, whose proofs are wanted.
    std::optional<Found> without_proofs(const std::vector<BoundValue>& values,
                                        const Substitution& substitution, QuickJudge& quick) const {
        for (std::size_t i = 0; i < said_.bindings.size(); ++i) {
            if (said_.bindings[i].family.empty()) continue;
            const auto truth =
                quick.in_family(std::get<Language>(values[i].is), said_.bindings[i].family);
            if (truth == Truth::refuted) return Found{};
            if (!truth) return std::nullopt;
        }
        for (const Statement& condition : said_.conditions) {
            const auto truth = quick.truth(substitution(condition));
            if (truth == Truth::refuted) return Found{};
            if (!truth) return std::nullopt;
        }
        const Statement body = substitution(said_.body.front());
        const auto truth = quick.truth(body);
        if (truth == (said_.universal ? Truth::proved : Truth::refuted))
            return Found{.kind = Found::Kind::as_said, .meets = true};
        // Behind a trivial witness another one that is trivial is of no use.
        if (truth && witness_ && is_trivial(body, quick)) return Found{.meets = true};
        return std::nullopt;
    }

    Found decided(const Named& named, QuickJudge& quick) const {
        budget_.check();
        steps::ByInstance step;
        step.values = reader_.values(named.instance, named.letters);
        step.size = named.instance.size();
        const Substitution substitution(step.values);
        if (!is_keeping())
            if (auto found = without_proofs(step.values, substitution, quick)) return *found;
        bool open = false;
        for (std::size_t i = 0; i < said_.bindings.size(); ++i) {
            if (said_.bindings[i].family.empty()) continue;
            Answer found = decide_part(member(step.values, i), claim_, budget_, inner());
            if (found.truth == Truth::refuted)
                return {.known = kept(std::move(step.values), i, std::nullopt, std::move(found))};
            open = open || found.truth == Truth::undecided;
            step.members.push_back(std::move(found));
        }
        for (std::size_t i = 0; i < said_.conditions.size(); ++i) {
            Answer found = decide_part(substitution(said_.conditions[i]), claim_, budget_, inner());
            if (found.truth == Truth::refuted)
                return {.known = kept(std::move(step.values), std::nullopt, i, std::move(found))};
            open = open || found.truth == Truth::undecided;
            step.conditions.push_back(std::move(found));
        }
        step.statement = substitution(said_.body.front());
        step.body = decide_part(step.statement, claim_, budget_, inner());
        const Truth sought = said_.universal ? Truth::refuted : Truth::proved;
        Found found;
        found.meets = !open;
        if (step.body.truth == opposite(sought)) {
            found.kind = Found::Kind::as_said;
            found.known =
                kept(std::move(step.values), std::nullopt, std::nullopt, std::move(step.body));
        } else if (open || step.body.truth == Truth::undecided) {
            found.kind = Found::Kind::undecided;
        } else {
            found.kind = Found::Kind::witness;
            const bool trivial = is_trivial(step.statement, quick);
            found.witness = {std::move(step), trivial};
        }
        return found;
    }

    /// Of a quantifier within this one the instances are not spread over threads again.
    SearchLimits inner() const {
        SearchLimits limits = limits_;
        limits.threads = 1;
        limits.progress = nullptr;
        limits.from.reset();
        limits.on_searched = {};
        limits.is_instance = true;
        return limits;
    }

    /// Whether the search is over: the witness, and another one where it is trivial, are found.
    bool keep(Witness found) {
        if (!witness_) {
            searched_.witness = true;
            witness_searched_ = searched_;
            witness_ = std::move(found);
            return !witness_->trivial;
        }
        if (found.trivial) return false;
        witness_->step.other = std::make_shared<const steps::ByInstance>(std::move(found.step));
        return true;
    }

    /// Whether the statement is `X is FAMILY` and X has no word but perhaps the empty one.
    bool is_trivial(const Statement& statement, QuickJudge& quick) const {
        const auto* said = std::get_if<InFamily>(&statement.says);
        if (!said) return false;
        auto words = quick.words(said->language);
        if (!words)
            if (auto value = finite_value(said->language, *claim_.alphabet, budget_))
                words = std::move(value->words);
        return words && std::all_of(words->begin(), words->end(),
                                    [](const Word& word) { return word.empty(); });
    }

    Answer answer_by(const Witness& witness) const {
        steps::ByInstance step = witness.step;
        step.universal = said_.universal;
        step.searched = witness_searched_;
        Answer answer = algae::decided(!said_.universal, std::move(step));
        answer.searched = witness_searched_;
        return answer;
    }

    std::string text_of_search() const {
        const std::string what = said_.universal ? "counterexample" : "example";
        const std::string languages = is_partial_             ? " with morphisms on their letters"
                                      : searched_.finite_only ? " with finite languages"
                                                              : "";
        if (searched_.instances == 0 && searched_.undecided == 0)
            return "No instance meets the conditions, of " +
                   counted(searched_.visited, "instance") + languages + " up to size " +
                   std::to_string(searched_.size) + ".";
        std::string text = "No " + what + " is among the first " +
                           std::to_string(searched_.visited) + " instances" + languages +
                           ", up to size " + std::to_string(searched_.size);
        if (searched_.instances != searched_.visited)
            text += ", of which " + std::to_string(searched_.instances) + " meet the conditions";
        text += searched_.undecided == 0
                    ? "; each of them is decided."
                    : "; " + std::to_string(searched_.undecided) + " of them are undecided.";
        return text;
    }

    const Quantified& said_;
    const Claim& claim_;
    const Budget& budget_;
    const SearchLimits& limits_;
    QuickJudges quick_;
    InstanceReader reader_;
    Tuple tuple_;
    std::vector<Symbol> fixed_, fresh_;
    Searched searched_, witness_searched_;
    std::optional<Witness> witness_;
    std::vector<Named> gathered_;
    std::vector<steps::ByCases::Case> cases_;
    bool keeps_cases_ = false;
    mutable std::atomic<std::uint64_t> kept_ = 0;  // cases, and cases within their proofs
    std::size_t batch_ = 1;
    std::uint64_t visited_ = 0;
    WorkCount looked_at_{"instance", limits_.instances};
    std::uint64_t known_ = 0;  // of these, by an earlier search
    bool is_over_ = false, is_stopped_by_limit_ = false;
    bool is_partial_ = false;  // some morphisms were not tried
};

}  // namespace

std::vector<BoundValue> values_of(const Instance& instance, const Quantified& said,
                                  const Claim& claim, const std::vector<Symbol>& letters) {
    return InstanceReader(said, claim).values(instance, letters);
}

Statement with_values(const Statement& statement, const std::vector<BoundValue>& values) {
    return Substitution(values)(statement);
}

Tuple tuple_of(const Quantified& said) {
    Tuple tuple;
    for (const QuantifiedName& binding : said.bindings) tuple.values.push_back(binding.domain);
    tuple.disjoint = said.disjoint;
    if (said.over) tuple.over = said.over->size();
    return tuple;
}

Answer judge_quantified(const Quantified& said, const Claim& claim, const Budget& budget,
                        const SearchLimits& limits) {
    for (const auto& method :
         {judge_all_numbers, judge_all_words, judge_symbolic, judge_derivations, judge_each})
        if (auto found = method(said, claim, budget)) return *found;
    return QuantifiedJudge(said, claim, budget, limits).judge();
}

// Several statements as one, by three-valued logic: an undecided part decides nothing, but another part may.
Answer judge_joint(const Joint& said, const Claim& claim, const Budget& budget,
                   const SearchLimits& limits) {
    steps::FromStatements step{said.kind, {}};
    std::vector<std::string> tried;
    std::vector<Truth> truths;
    // What decides the whole alone: a refuted part of `all`, a proved one of `any`, and so on.
    for (std::size_t i = 0; i < said.parts.size(); ++i) {
        Answer found = decide_part(said.parts[i], claim, budget, limits);
        const Truth truth = found.truth;
        truths.push_back(truth);
        if (truth == Truth::undecided) {
            tried.insert(tried.end(), found.tried.begin(), found.tried.end());
            continue;
        }
        const bool decides = said.kind == Joint::Kind::all   ? truth == Truth::refuted
                             : said.kind == Joint::Kind::any ? truth == Truth::proved
                             : said.kind == Joint::Kind::implies
                                 ? truth == (i == 0 ? Truth::refuted : Truth::proved)
                                 : false;
        if (decides) step.parts.clear();
        step.parts.push_back({i, said.parts[i].text, std::move(found)});
        if (decides) return algae::decided(said.kind != Joint::Kind::all, std::move(step));
    }
    if (std::count(truths.begin(), truths.end(), Truth::undecided) > 0)
        return {Truth::undecided, nullptr, std::move(tried), {}};
    const bool holds =
        said.kind == Joint::Kind::all || (said.kind == Joint::Kind::iff && truths[0] == truths[1]);
    return algae::decided(holds, std::move(step));
}

}  // namespace algae
