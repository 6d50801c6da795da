#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "exact/exact.hpp"
#include "verify/detail/checking.hpp"
#include "verify/detail/instances.hpp"
#include "verify/verify.hpp"

// Statements about all values within bounds, shown case by case.
//
// A case has values for the bound names, and a proof: of the body, or that a condition does not hold, or that a value is not of
// the family that its name ranges over. What is left is that no instance is missing. So the instances are written down here
// by a plain recursion from the definition of what names range over and of sizes (NOTATION.md), and each is looked up among
// the cases. This shares nothing with the search, and the order of the cases and how they were found do not matter.
//
// There are infinitely many letters, and a renaming of letters that keeps those that the statement names itself does not change
// whether the statement holds. So an instance and a case are the same if such a renaming takes one to the other: both are
// brought to their least renaming. It is not necessary to write down each instance once, only at least once up to renaming: letters that
// the statement does not name are numbered as they come up. That this misses none: take an instance, and let its pieces (sets
// of words) be read one after the other, the words of each shorter ones first, then by the numbers of their letters. Among the
// numberings of the letters that are new in a piece take the one by which the piece, sorted, is least. If in it the letter j came up
// before i < j, exchanging i and j would leave the words before as they are and make this word smaller, so the sorted piece would
// be smaller too. With `over` all letters are named, and nothing is renamed.
//
// A morphism has images for just the letters that occur in values before it: where the statement asks for the image of another
// letter, it cannot be read, and no case is accepted. Not written down are morphisms that are applied inversely, whose letters are their
// own, and names without bounds.

namespace algae::verify {

namespace {

constexpr std::uint64_t without_bound = std::numeric_limits<std::uint64_t>::max();

/// A value of a name: a set of words, a word or an axiom; the images of letters by each table, or by a morphism; or a number.
struct Value {
    using Images = std::map<Symbol, std::vector<Word>>;
    std::vector<Word> words;
    std::vector<Images> tables;
    Integer number = 0;

    bool operator<(const Value& other) const {
        return std::tie(words, tables, number) < std::tie(other.words, other.tables, other.number);
    }
};
using Instance = std::vector<Value>;

// --- The letters that a statement names ---

void add_letters(const Language& language, std::set<Symbol>& letters) {
    for (const Word& word : language->words) letters.insert(word.begin(), word.end());
    letters.insert(language->letters.begin(), language->letters.end());
    for (const auto& [letter, image] : language->morphism) {
        letters.insert(letter);
        letters.insert(image.begin(), image.end());
    }
    if (language->powers)
        for (const Powers::Block& block : language->powers->blocks)
            letters.insert(block.word.begin(), block.word.end());
    for (const Language& part : language->parts) add_letters(part, letters);
}

/// All letters that occur in the axiom and the rules.
void add_letters(const System& system, std::set<Symbol>& letters) {
    letters.insert(system.axiom.begin(), system.axiom.end());
    for (const System::Successors& table : system.tables)
        for (Symbol a = 0; a < table.size(); ++a) {
            if (table[a] == std::vector<Word>{{a}}) continue;
            letters.insert(a);
            for (const Word& word : table[a]) letters.insert(word.begin(), word.end());
        }
    for (const System::Rule& rule : system.rules) {
        letters.insert(rule.letter);
        for (const Word* word : {&rule.left, &rule.right, &rule.successor})
            letters.insert(word->begin(), word->end());
    }
}

void add_letters_of_systems(const Language& language, std::set<Symbol>& letters) {
    if (language->system)
        for (const Symbol letter : accessible_letters(*language->system, language->system->axiom))
            if (language->system->terminal[letter]) letters.insert(letter);
    for (const Language& part : language->parts) add_letters_of_systems(part, letters);
}

/// The letters of its systems, which no name stands for.
void add_letters_of_systems(const Statement& statement, std::set<Symbol>& letters) {
    using Kind = Statement::Kind;
    static constexpr std::array of_words = {Kind::derives, Kind::equal_sequences};
    if (std::find(of_words.begin(), of_words.end(), statement.kind) != of_words.end())
        for (const NamedSystem& named : statement.systems)
            if (named.system) add_letters(*named.system, letters);
    for (const Language& language : statement.languages) add_letters_of_systems(language, letters);
    for (const Statement& part : statement.parts) add_letters_of_systems(part, letters);
}

/// The letters besides those of systems on which the truth of a statement may depend, but for those in the place of bound names.
/// Lengths and growth do not depend on letters.
void add_letters(const Statement& statement, const Alphabet& alphabet, std::set<Symbol>& letters) {
    using Kind = Statement::Kind;
    for (const Language& language : statement.languages) add_letters(language, letters);
    letters.insert(statement.word.begin(), statement.word.end());
    if (statement.from) letters.insert(statement.from->begin(), statement.from->end());
    // Terms may count any letter; formulas, codings and turtles may name any.
    static constexpr std::array of_any = {
        Kind::numbers,           Kind::words,    Kind::first_order, Kind::counts,
        Kind::critical_exponent, Kind::circular, Kind::dimension,   Kind::boundary};
    if (std::find(of_any.begin(), of_any.end(), statement.kind) != of_any.end())
        for (Symbol a = 0; a < alphabet.size(); ++a) letters.insert(a);
    std::set<Symbol> inner;
    for (const Statement& part : statement.parts) add_letters(part, alphabet, inner);
    if (statement.quantified) {
        for (const Quantified::Name& name : statement.quantified->names)
            if (name.of == "words" || name.of == "letters")
                inner.erase(alphabet.find(name.name).value());
        if (statement.quantified->over)
            inner.insert(statement.quantified->over->begin(), statement.quantified->over->end());
    }
    letters.merge(inner);
}

/// Whether the inverse of a bound morphism is asked for.
bool has_inverse(const Language& language) {
    return (language->kind == Tree::Kind::inverse_image && !language->name.empty()) ||
           std::any_of(language->parts.begin(), language->parts.end(), has_inverse);
}

bool has_complement(const Language& language) {
    return language->kind == Tree::Kind::complement ||
           std::any_of(language->parts.begin(), language->parts.end(), has_complement);
}

bool has_complement(const Statement& statement) {
    return std::any_of(statement.languages.begin(), statement.languages.end(),
                       [](const Language& each) { return has_complement(each); }) ||
           std::any_of(statement.parts.begin(), statement.parts.end(),
                       [](const Statement& each) { return has_complement(each); });
}

bool has_inverse(const Statement& statement) {
    return std::any_of(statement.languages.begin(), statement.languages.end(),
                       [](const Language& each) { return has_inverse(each); }) ||
           std::any_of(statement.parts.begin(), statement.parts.end(),
                       [](const Statement& each) { return has_inverse(each); });
}

// --- Instances up to renaming ---

/// All instances of a quantified statement. Letters that the statement does not name are numbered from `first_new_` on.
class Instances {
public:
    explicit Instances(const Obligation& task)
        : task_(task),
          said_(*task.statement.quantified),
          first_new_(static_cast<Symbol>(task.alphabet().size())) {
        if (said_.over) {
            named_.insert(said_.over->begin(), said_.over->end());
        } else {
            add_letters(task.statement, task.alphabet(), named_);
            add_letters_of_systems(task.statement, named_);
        }
        must_be_finite();
    }

    /// Calls `use` with the least renaming of each, of some more than once.
    void each(const std::function<void(const Instance&)>& use) {
        use_ = &use;
        value();
    }

    /// The values of a case.
    Instance of(const BoundNames& values) const {
        Instance all;
        for (const Quantified::Name& name : said_.names) {
            Value& value = all.emplace_back();
            if (name.of.ends_with("languages")) {
                value.words = values.languages.at(name.name)->words;
            } else if (name.of.ends_with(" systems")) {
                value = of(*values.systems.at(name.name));
            } else if (is_morphism_domain(name.of)) {
                value.tables = {*values.morphisms.at(name.name)};
            } else if (name.of == "numbers") {
                value.number = *values.numbers.at(name.name);
            } else {
                value.words = {values.words.at(task_.alphabet().find(name.name).value())};
            }
        }
        return least_renaming(all);
    }

    std::string text(const Instance& instance) const {
        std::string all;
        for (std::size_t i = 0; i < instance.size(); ++i) {
            all += (i > 0 ? ", " : "") + said_.names[i].name + " = ";
            if (said_.names[i].of == "numbers") {
                all += to_string(instance[i].number);
                continue;
            }
            all += "{" + text(instance[i].words);
            for (const Value::Images& table : instance[i].tables)
                for (const auto& [letter, words] : table)
                    all += "; " + name(letter) + " -> " + text(words);
            all += "}";
        }
        return all;
    }

private:
    static Value of(const System& system) {
        Value value{{system.axiom}, {}};
        std::set<Symbol> letters;
        add_letters(system, letters);
        for (const System::Successors& table : system.tables) {
            Value::Images& images = value.tables.emplace_back();
            for (const Symbol letter : letters) images[letter] = table[letter];
        }
        return value;
    }

    std::string text(const std::vector<Word>& words) const {
        std::string all;
        for (const Word& word : words) {
            if (!all.empty()) all += ", ";
            for (const Symbol letter : word) all += name(letter);
            if (word.empty()) all += "ε";
        }
        return all;
    }
    /// New letters are called by those of the alphabet that the statement does not name.
    std::string name(Symbol letter) const {
        if (letter < first_new_) return task_.alphabet().name(letter);
        Symbol number = letter - first_new_;
        for (Symbol a = 0; a < first_new_; ++a)
            if (named_.count(a) == 0 && number-- == 0) return task_.alphabet().name(a);
        return "(letter " + std::to_string(letter) + ")";
    }

    [[noreturn]] static void refuse(const std::string& why) {
        throw BoundReached(Bound::method, "the instances are not enumerated again: " + why);
    }

    void must_be_finite() const {
        if (has_inverse(task_.statement)) refuse("a morphism is applied inversely");
        if (said_.names.size() > 100) refuse("there are more than 100 names");
        const bool has_morphism =
            std::any_of(said_.names.begin(), said_.names.end(),
                        [](const Quantified::Name& name) { return is_morphism_domain(name.of); });
        if (has_morphism && has_complement(task_.statement))
            refuse("a complement may be over the letters of a morphism");
        for (const Quantified::Name& name : said_.names) {
            const bool is_system = name.of.ends_with(" systems");
            const bool is_language = name.of.ends_with("languages");
            const bool several = is_language || is_system || name.of.ends_with("substitutions");
            const std::string family = family_of(name.of, " systems");
            if (is_system && (!family.ends_with("0L") || family.find('E') != std::string::npos))
                refuse("systems of this family may have contexts or nonterminals");
            if (is_system && task_.certificate.empty_axiom)
                refuse("systems may have the empty word as axiom");
            // Of a language that may be infinite only the length of its words is a bound.
            const bool by_size =
                name.size && (!is_language || name.of == "finite languages" || name.length);
            const bool by_length =
                name.length && (!several || said_.over) && family.find('T') == std::string::npos;
            if (!by_size && !by_length && !name.most && name.of != "letters" && !is_coding(name.of))
                refuse("'" + name.name + "' has no bounds");
        }
    }

    static bool is_coding(const std::string& of) {
        return of == "codings" || of.starts_with("letter-to-letter");
    }

    // --- Writing them down ---

    using Then = std::function<void()>;

    /// Which words may be chosen for a piece.
    struct Choice {
        std::uint64_t least = 0, most = without_bound;  // how many of them
        std::uint64_t shortest = 0, longest = without_bound;
        std::uint64_t overhead = 1;  // of the size, for each
    };

    void value() {
        if (now_.size() == said_.names.size()) {
            constexpr std::uint64_t most = 5'000'000;
            if (++written_ > most) refuse("there are more than 5000000");
            if (written_ % 256 == 0) task_.budget.check();
            (*use_)(least_renaming(now_));
            return;
        }
        const Quantified::Name& name = said_.names[now_.size()];
        const std::uint64_t left_before = std::exchange(left_, name.size.value_or(without_bound));
        const std::uint64_t longest = name.length.value_or(without_bound);
        if (name.of == "numbers") {
            now_.emplace_back();
            const std::uint64_t last = std::min(left_, name.most.value_or(without_bound));
            for (std::uint64_t number = 0; number <= last; ++number) {
                now_.back().number = Integer(number);
                value();
            }
            now_.pop_back();
        } else if (name.of.ends_with(" systems")) {
            of_system(name.of, longest);
        } else if (is_morphism_domain(name.of)) {
            const std::set<Symbol> letters = letters_so_far();
            Choice image{1, 1, 0, longest};
            if (name.of.ends_with("substitutions")) image.most = without_bound;
            if (name.of.find("non-erasing") != std::string::npos) image.shortest = 1;
            if (is_coding(name.of)) image.shortest = image.longest = 1;
            now_.push_back({{}, {{}}});
            images({letters.begin(), letters.end()}, 0, image);
            now_.pop_back();
        } else {
            Choice words{1, 1, 0, longest};
            if (name.of.ends_with("languages")) words.least = 0, words.most = without_bound;
            if (name.of == "letters") words = {1, 1, 1, 1, 0};
            now_.emplace_back();
            choose(words, {}, [&](const std::vector<Word>& chosen) {
                now_.back().words = chosen;
                done();
            });
            now_.pop_back();
        }
        left_ = left_before;
    }

    /// The next value, unless this one has a letter that it must not have.
    void done() {
        if (!said_.different_letters || is_apart()) value();
    }

    bool is_apart() const {
        if (is_morphism_domain(said_.names[now_.size() - 1].of)) return true;
        const std::set<Symbol> letters = letters_of(now_.back());
        for (std::size_t i = 0; i + 1 < now_.size(); ++i)
            if (!is_morphism_domain(said_.names[i].of))
                for (const Symbol letter : letters_of(now_[i]))
                    if (letters.count(letter) > 0) return false;
        return true;
    }

    /// The images of each of these letters from number `next` on, by the only table.
    void images(const std::vector<Symbol>& letters, std::size_t next, const Choice& image) {
        if (next == letters.size()) return done();
        choose(image, {}, [&, next](const std::vector<Word>& chosen) {
            now_.back().tables[0][letters[next]] = chosen;
            images(letters, next + 1, image);
        });
        now_.back().tables[0].erase(letters[next]);
    }

    void of_system(const std::string& of, std::uint64_t longest) {
        Choice successors{1, without_bound, 0, longest};
        if (of.find('D') != std::string::npos) successors.most = 1;
        if (of.find('P') != std::string::npos) successors.shortest = 1;
        const std::uint64_t most_tables = of.find('T') != std::string::npos ? left_ : 1;
        for (std::uint64_t tables = 1; tables <= most_tables; ++tables) {
            now_.push_back({{}, std::vector<Value::Images>(static_cast<std::size_t>(tables))});
            choose({1, 1, 1, longest, 0}, {}, [&](const std::vector<Word>& axiom) {
                now_.back().words = axiom;
                rules(order_of(axiom, {}), 0, 0, successors);
            });
            now_.pop_back();
        }
    }

    /// The letters, and those of the words that are not among them, in the order in which they occur.
    static std::vector<Symbol> order_of(const std::vector<Word>& words,
                                        std::vector<Symbol> letters) {
        for (const Word& word : words)
            for (const Symbol letter : word)
                if (std::find(letters.begin(), letters.end(), letter) == letters.end())
                    letters.push_back(letter);
        return letters;
    }

    /// The rules of a system: of the letters that have occurred, from number `next` on, in the tables from `table` on.
    void rules(const std::vector<Symbol>& letters, std::size_t next, std::size_t table,
               const Choice& successors) {
        std::vector<Value::Images>& tables = now_.back().tables;
        if (table == tables.size()) return rules(letters, next + 1, 0, successors);
        if (next == letters.size()) {
            const std::set<Value::Images> different(tables.begin(), tables.end());
            if (different.size() == tables.size()) done();
            return;
        }
        const std::size_t open = (letters.size() - next) * tables.size() - table;
        if (left_ < open * (1 + successors.shortest)) return;
        choose(successors, {}, [&, next, table](const std::vector<Word>& chosen) {
            now_.back().tables[table][letters[next]] = chosen;
            rules(order_of(chosen, letters), next, table + 1, successors);
        });
        now_.back().tables[table].erase(letters[next]);
    }

    /// Calls `then` with each increasing choice of words that begins with `chosen`.
    void choose(const Choice& choice, std::vector<Word> chosen,
                const std::function<void(const std::vector<Word>&)>& then) {
        if (chosen.size() >= choice.least) then(chosen);
        if (chosen.size() == choice.most) return;
        const Word last = chosen.empty() ? Word() : chosen.back();
        const std::uint64_t from = chosen.empty() ? choice.shortest : last.size();
        for (std::uint64_t length = from;
             length <= choice.longest && choice.overhead + length <= left_; ++length) {
            Word word;
            spell(word, length, [&] {
                if (!chosen.empty() && !shortlex_less(last, word)) return;
                const std::uint64_t cost = choice.overhead + length;
                std::vector<Word> more = chosen;
                more.push_back(word);
                left_ -= cost;
                choose(choice, std::move(more), then);
                left_ += cost;
            });
        }
    }

    /// Every word of this length, over the letters that are named, those that have come up and the next new one.
    void spell(Word& word, std::uint64_t length, const Then& then) {
        if (word.size() == length) return then();
        const auto with = [&](Symbol letter) {
            word.push_back(letter);
            spell(word, length, then);
            word.pop_back();
        };
        for (const Symbol letter : named_) with(letter);
        const Symbol known = new_;
        for (Symbol number = 0; number < known; ++number) with(first_new_ + number);
        if (said_.over) return;
        ++new_;
        with(first_new_ + known);
        --new_;
    }

    static std::set<Symbol> letters_of(const Value& value) {
        std::set<Symbol> letters;
        for (const Word& word : value.words) letters.insert(word.begin(), word.end());
        for (const Value::Images& table : value.tables)
            for (const auto& [letter, words] : table) {
                letters.insert(letter);
                for (const Word& word : words) letters.insert(word.begin(), word.end());
            }
        return letters;
    }
    std::set<Symbol> letters_so_far() const {
        std::set<Symbol> letters;
        for (const Value& value : now_) letters.merge(letters_of(value));
        return letters;
    }

    // --- Renaming ---

    using Renaming = std::map<Symbol, Symbol>;

    static std::vector<Word> renamed(std::vector<Word> words, const Renaming& to) {
        for (Word& word : words)
            for (Symbol& letter : word)
                if (const auto found = to.find(letter); found != to.end()) letter = found->second;
        std::sort(words.begin(), words.end(), shortlex_less);
        return words;
    }

    static Instance renamed(const Instance& instance, const Renaming& to) {
        Instance all;
        for (const Value& value : instance) {
            Value& next = all.emplace_back();
            next.words = renamed(value.words, to);
            next.number = value.number;
            for (const Value::Images& table : value.tables) {
                Value::Images& images = next.tables.emplace_back();
                for (const auto& [letter, words] : table) {
                    const auto found = to.find(letter);
                    images[found == to.end() ? letter : found->second] = renamed(words, to);
                }
            }
            std::sort(next.tables.begin(), next.tables.end());
        }
        return all;
    }

    /// Where a letter occurs: in which value, in a word of which length, how far in it, and of what kind the word is. Renamings do
    /// not change this.
    using Occurrences = std::vector<std::array<std::size_t, 4>>;

    std::map<Symbol, Occurrences> occurrences(const Instance& instance) const {
        std::map<Symbol, Occurrences> all;
        const auto add = [&](std::size_t value, const std::vector<Word>& words, std::size_t kind) {
            for (const Word& word : words)
                for (std::size_t i = 0; i < word.size(); ++i)
                    all[word[i]].push_back({value, word.size(), i, kind});
        };
        for (std::size_t v = 0; v < instance.size(); ++v) {
            add(v, instance[v].words, 0);
            for (const Value::Images& table : instance[v].tables)
                for (const auto& [letter, words] : table) {
                    all[letter].push_back({v, words.size(), 0, 2});
                    add(v, words, 1);
                }
        }
        for (auto& [letter, places] : all) std::sort(places.begin(), places.end());
        return all;
    }

    /// The least of the instances to which letters that are not named can be renamed so that those with fewer occurrences, or
    /// earlier ones, come first.
    Instance least_renaming(const Instance& instance) const {
        std::vector<std::pair<Occurrences, Symbol>> letters;
        for (auto& [letter, places] : occurrences(instance))
            if (named_.count(letter) == 0) letters.emplace_back(places, letter);
        std::sort(letters.begin(), letters.end());
        std::optional<Instance> least;
        do {
            Renaming to;
            for (std::size_t i = 0; i < letters.size(); ++i)
                to[letters[i].second] = first_new_ + static_cast<Symbol>(i);
            Instance next = renamed(instance, to);
            if (!least || next < *least) least = std::move(next);
            task_.budget.check();
        } while (next_order(letters));
        return *least;
    }

    /// The next order of letters in which those with equal occurrences change places; false behind the last one.
    static bool next_order(std::vector<std::pair<Occurrences, Symbol>>& letters) {
        for (auto end = letters.end(); end != letters.begin();) {
            auto begin = end;
            while (begin != letters.begin() && std::prev(begin)->first == std::prev(end)->first)
                --begin;
            if (std::next_permutation(begin, end)) return true;
            end = begin;
        }
        return false;
    }

    const Obligation& task_;
    const Quantified& said_;
    Symbol first_new_;
    std::set<Symbol> named_;

    const std::function<void(const Instance&)>* use_ = nullptr;
    Instance now_;            // as far as it is written
    Symbol new_ = 0;          // how many new letters have come up
    std::uint64_t left_ = 0;  // of the size of the present value
    std::uint64_t written_ = 0;
};

/// Checks the proof of a case, and gives its values.
BoundNames check_case(const Obligation& task, const Field& field) {
    const Quantified& said = *task.statement.quantified;
    field.only({"values", "member", "condition", "proof"});
    const Values values(task, said, field.at("values"));
    const Reader reader = task.reader.with(values.names());
    const auto check = [&](const Statement& statement, bool holds) {
        check_proof({task.certificate, reader, task.budget, statement, holds != statement.negated,
                     field.at("proof")});
    };
    if (field.has("member")) {
        const Field member = field.at("member");
        const auto name = std::find_if(said.names.begin(), said.names.end(), [&](const auto& each) {
            return each.name == member.text();
        });
        const auto is_of = name == said.names.end() ? std::nullopt : values.membership(*name);
        if (!is_of) member.refuse("no name with a family is called so");
        check(*is_of, false);
    } else if (field.has("condition")) {
        const Field condition = field.at("condition");
        if (condition.number() >= said.conditions.size())
            condition.refuse("there is no such condition");
        check(reader.statement(said.conditions[static_cast<std::size_t>(condition.number())]),
              false);
    } else {
        check(reader.statement(said.body.front()), said.universal);
    }
    return values.names();
}

}  // namespace

void check_all_instances(const Obligation& task) {
    if (task.statement.quantified->universal != task.holds) task.wrong_kind();
    if (!task.proof.has("cases"))
        throw BoundReached(Bound::method, "there are more cases than a certificate holds, of " +
                                              to_string(task.proof.at("instances").integer()) +
                                              " instances");
    Instances instances(task);
    const Field cases = task.proof.at("cases");
    std::set<Instance> shown;
    for (const Field& each : cases.list()) shown.insert(instances.of(check_case(task, each)));
    instances.each([&](const Instance& instance) {
        if (shown.count(instance) == 0)
            cases.refuse("there is no case for " + instances.text(instance));
    });
}

}  // namespace algae::verify
