#include <algorithm>
#include <array>
#include <functional>
#include <set>

#include "exact/exact.hpp"
#include "verify/detail/checking.hpp"
#include "verify/detail/instances.hpp"
#include "verify/verify.hpp"

// Statements made of others: how they are read, and proofs of them.
//
// A statement about all values is shown to be false, and one about some values to be true, by an instance: values
// for the bound names. Its conditions and its body are read again with these values in the place of the names, which
// makes statements without bound names; each has a proof of its own. That the values are what the names range over is
// checked here: by the form of a system, by a look at a morphism, and for languages of a family by one more proof. How
// the instance was found does not matter, nor that it is the least one; the certificate does not say that.

namespace algae::verify {

Reader Reader::with(const BoundNames& names) const {
    Reader more = *this;
    for (const auto& [name, language] : names.languages)
        more.bound_.languages.insert_or_assign(name, language);
    for (const auto& [name, system] : names.systems)
        more.bound_.systems.insert_or_assign(name, system);
    for (const auto& [name, morphism] : names.morphisms)
        more.bound_.morphisms.insert_or_assign(name, morphism);
    for (const Symbol letter : names.open_words) more.bound_.open_words.insert(letter);
    for (const auto& [letter, word] : names.words) {
        more.bound_.words.insert_or_assign(letter, word);
        more.bound_.open_words.erase(letter);
    }
    for (const auto& [name, number] : names.numbers)
        more.bound_.numbers.insert_or_assign(name, number);
    return more;
}

BoundNames::Images Reader::images(const Field& field, bool several) const {
    BoundNames::Images all;
    for (const auto& [name, image] : field.object()) {
        std::vector<Word>& of = all[free_symbol(image, name)];
        of = several ? words(image) : std::vector<Word>{word(image)};
        if (of.empty()) image.fail("a letter needs an image");
    }
    return all;
}

namespace {

/// The words that a substitution makes of a word.
std::vector<Word> substituted(const Word& word, const BoundNames::Images& images,
                              const Field& where) {
    std::vector<Word> made{{}};
    for (const Symbol a : word) {
        const auto found = images.find(a);
        if (found == images.end()) where.fail("a letter of the language has no image");
        std::vector<Word> longer;
        for (const Word& begun : made)
            for (const Word& image : found->second) {
                longer.push_back(begun);
                longer.back().insert(longer.back().end(), image.begin(), image.end());
            }
        constexpr std::size_t most = 100'000;
        if (longer.size() > most)
            throw BoundReached(Bound::method, "an image of more than 100000 words is not checked");
        made = std::move(longer);
    }
    return made;
}

Language substituted(const Language& language, const BoundNames::Images& images,
                     const Field& where) {
    using Kind = Tree::Kind;
    if (language->kind == Kind::words) {
        std::vector<Word> all;
        for (const Word& word : language->words) {
            const std::vector<Word> made = substituted(word, images, where);
            all.insert(all.end(), made.begin(), made.end());
        }
        return words_of(std::move(all));
    }
    static constexpr std::array kept = {Kind::united, Kind::concatenation, Kind::star, Kind::plus};
    if (std::count(kept.begin(), kept.end(), language->kind) == 0)
        where.fail("a substitution of this operation is not known");
    std::vector<Language> parts;
    for (const Language& part : language->parts) parts.push_back(substituted(part, images, where));
    return combination(language->kind, std::move(parts));
}

}  // namespace

namespace {

/// Whether a morphism has an image for every letter that may occur in words of the language.
bool maps_all(const BoundNames::Images& images, const Language& language) {
    using Kind = Tree::Kind;
    const auto has = [&](Symbol letter) { return images.count(letter) > 0; };
    const auto has_all = [&](const auto& letters) {
        return std::all_of(letters.begin(), letters.end(), has);
    };
    switch (language->kind) {
        case Kind::words:
            return std::all_of(language->words.begin(), language->words.end(), has_all);
        case Kind::generated:
            return language->system &&
                   has_all(accessible_letters(*language->system, language->system->axiom));
        case Kind::complement:
            return has_all(language->letters);
        case Kind::image:
            return std::all_of(language->morphism.begin(), language->morphism.end(),
                               [&](const auto& one) { return has_all(one.second); });
        case Kind::inverse_image:
            return std::all_of(language->morphism.begin(), language->morphism.end(),
                               [&](const auto& one) { return has(one.first); });
        case Kind::powers:
            return std::all_of(language->powers->blocks.begin(), language->powers->blocks.end(),
                               [&](const Powers::Block& block) { return has_all(block.word); });
        case Kind::variable:
            return false;
        default:
            return std::all_of(language->parts.begin(), language->parts.end(),
                               [&](const Language& part) { return maps_all(images, part); });
    }
}

}  // namespace

Language Reader::bound_image(Tree::Kind kind, const Field& field) const {
    const std::string& name = field.at("morphism").text();
    const auto bound = bound_.morphisms.find(name);
    if (bound == bound_.morphisms.end())
        field.at("morphism").fail("no morphism is called '" + name + "'");
    const bool inverse = kind == Tree::Kind::inverse_image;
    const Language of = language(field.at(inverse ? "inverse image" : "image"));
    Tree tree;
    tree.kind = kind;
    tree.parts = {of};
    if (!bound->second) {
        tree.name = name;
        return std::make_shared<const Tree>(std::move(tree));
    }
    if (!inverse && !maps_all(*bound->second, of))
        field.refuse("the value of '" + name + "' has no image for a letter of the language");
    const bool several = std::any_of(bound->second->begin(), bound->second->end(),
                                     [](const auto& one) { return one.second.size() > 1; });
    if (several && inverse) field.fail("a substitution has no inverse here");
    if (several) return substituted(of, *bound->second, field);
    for (const auto& [letter, images] : *bound->second) tree.morphism[letter] = images.front();
    return std::make_shared<const Tree>(std::move(tree));
}

Statement Reader::joint(const Field& field, std::string_view kind) const {
    field.only({kind});
    Statement read;
    read.kind = Statement::Kind::joint;
    read.family = kind;
    for (const Field& part : field.at(kind).list()) read.parts.push_back(statement(part));
    const bool is_pair = kind == "implies" || kind == "iff";
    if (read.parts.empty() || (is_pair && read.parts.size() != 2))
        field.at(kind).fail(is_pair ? "expected two statements" : "expected statements");
    return read;
}

namespace {

/// The nouns that names may range over, without the family in front.
constexpr std::array<std::string_view, 11> plain_domains = {"languages",
                                                            "finite languages",
                                                            "words",
                                                            "letters",
                                                            "morphisms",
                                                            "non-erasing morphisms",
                                                            "codings",
                                                            "letter-to-letter morphisms",
                                                            "finite substitutions",
                                                            "non-erasing finite substitutions",
                                                            "numbers"};

}  // namespace

std::string family_of(const std::string& domain, std::string_view noun) {
    if (std::count(plain_domains.begin(), plain_domains.end(), domain) > 0 ||
        !domain.ends_with(noun))
        return {};
    return domain.substr(0, domain.size() - noun.size());
}

/// Whether a name may range over it: one of the plain nouns, or languages or systems of a family that is known.
bool is_domain(const std::string& of) {
    if (std::count(plain_domains.begin(), plain_domains.end(), of) > 0) return true;
    const std::string languages = family_of(of, " languages");
    return is_checked_family(languages) || is_family_of_forms(languages) ||
           languages == "regular" || languages == "context-free" ||
           is_family_of_forms(family_of(of, " systems"));
}

bool is_morphism_domain(const std::string& of) {
    return of.ends_with("morphisms") || of == "codings" || of.ends_with("substitutions");
}

BoundNames open_names(const Quantified& said, const Alphabet& alphabet) {
    BoundNames open;
    for (const auto& [name, of, size, length, most] : said.names) {
        if (of.ends_with("languages")) {
            Tree tree;
            tree.kind = Tree::Kind::variable;
            tree.name = name;
            open.languages[name] = std::make_shared<const Tree>(std::move(tree));
        } else if (of.ends_with(" systems")) {
            open.systems[name] = nullptr;
        } else if (is_morphism_domain(of)) {
            open.morphisms[name] = std::nullopt;
        } else if (of == "numbers") {
            open.numbers[name] = std::nullopt;
        } else {
            open.open_words.insert(alphabet.find(name).value());
        }
    }
    return open;
}

bool is_bound_word(const BoundNames& bound, Symbol letter) {
    return bound.words.contains(letter) || bound.open_words.contains(letter);
}

bool Reader::is_bound(const std::string& name) const {
    const auto letter = alphabet_.find(name);
    return bound_.languages.contains(name) || bound_.systems.contains(name) ||
           bound_.morphisms.contains(name) || bound_.numbers.contains(name) ||
           (letter && is_bound_word(bound_, *letter));
}

Statement Reader::quantified(const Field& field) const {
    auto said = std::make_shared<Quantified>();
    said->universal = field.has("for all");
    const std::string_view quantifier = said->universal ? "for all" : "for some";
    field.only({quantifier, "different letters", "over", "with", "holds"});
    std::set<std::string> names;
    for (const Field& each : field.at(quantifier).list()) {
        each.only({"name", "of", "size", "length", "up to"});
        Quantified::Name name{each.at("name").text(), each.at("of").text(), {}, {}};
        if (each.has("size")) name.size = each.at("size").number();
        if (each.has("length")) name.length = each.at("length").number();
        if (each.has("up to")) name.most = each.at("up to").number();
        if (!is_domain(name.of))
            each.at("of").fail("expected what a name ranges over, found '" + name.of + "'");
        const bool is_word = name.of == "words" || name.of == "letters";
        if (!is_word) name_in(each.at("name"));
        if (is_bound(name.name) || !names.insert(name.name).second)
            each.at("name").fail("expected another name, as this one is bound already");
        if (name.most && name.of != "numbers")
            each.at("up to").fail("only numbers have a greatest value");
        if (name.length && name.of == "numbers")
            each.at("length").fail("numbers have no words with a length");
        if (is_word && letters_of_values().contains(symbol(each.at("name"), name.name)))
            throw BoundReached(Bound::method, each.at("name").path() +
                                                  ": the value of a name has the letter '" +
                                                  name.name + "', which is bound here");
        said->names.push_back(std::move(name));
    }
    if (said->names.empty()) field.at(quantifier).fail("expected a name");
    if (field.has("different letters"))
        said->different_letters = field.at("different letters").truth();
    if (field.has("over")) said->over = letters(field.at("over"));
    const Reader inner = with(open_names(*said, alphabet_));
    Statement read;
    read.kind = Statement::Kind::quantified;
    if (field.has("with")) said->conditions = field.at("with").list();
    for (const Field& condition : said->conditions)
        read.parts.push_back(inner.statement(condition));
    said->body = {field.at("holds")};
    read.parts.push_back(inner.statement(said->body.front()));
    read.quantified = std::move(said);
    return read;
}

Values::Values(const Obligation& task, const Quantified& said, const Field& values)
    : task_(task), said_(said), values_(values) {
    std::vector<std::string_view> names;
    for (const Quantified::Name& name : said.names) names.push_back(name.name);
    values_.only(names);
    for (const Quantified::Name& name : said.names) read(name, values_.at(name.name));
    if (said.different_letters) check_different();
}

void Values::read(const Quantified::Name& name, const Field& field) {
    here_.clear();
    size_ = 0;
    if (name.of.ends_with("languages"))
        read_language(name, field);
    else if (name.of.ends_with(" systems"))
        read_system(name, field);
    else if (is_morphism_domain(name.of))
        read_morphism(name, field);
    else if (name.of == "numbers")
        read_number(name, field);
    else
        read_word(name, field);
    if (name.size && size_ > *name.size) field.refuse("the value is larger than the bound says");
    if (said_.over)
        for (const Symbol letter : here_)
            if (std::count(said_.over->begin(), said_.over->end(), letter) == 0)
                field.refuse("the value has a letter that it is not over");
    if (!is_morphism_domain(name.of)) letters_.push_back(here_);
}

void Values::add(const Word& word, const Quantified::Name& name, const Field& field) {
    here_.insert(word.begin(), word.end());
    size_ += word.size() + 1;
    if (name.length && word.size() > *name.length)
        field.refuse("a word of the value is longer than the bound says");
}

void Values::read_language(const Quantified::Name& name, const Field& field) {
    const Language language = task_.reader.language(field);
    if (language->kind != Tree::Kind::words) field.refuse("expected a finite set of words");
    for (const Word& word : language->words) add(word, name, field);
    read_.languages[name.name] = language;
}

std::optional<Statement> Values::membership(const Quantified::Name& name) const {
    const std::string family = family_of(name.of, " languages");
    if (family.empty()) return std::nullopt;
    Statement member;
    member.kind = Statement::Kind::family;
    member.family = family;
    member.languages = {read_.languages.at(name.name)};
    return member;
}

void Values::read_system(const Quantified::Name& name, const Field& field) {
    auto system = std::make_shared<const System>(task_.reader.system(field));
    const auto why = beyond_form(*system, family_of(name.of, " systems"), false);
    if (why) field.refuse("the value is no such system: " + *why);
    if (system->context && (name.size || name.length || said_.over))
        field.refuse("the size and letters of a system with context are not known");
    const std::vector<Symbol> accessible = accessible_letters(*system, system->axiom);
    for (const System::Successors& table : system->tables)
        for (Symbol a = 0; a < table.size(); ++a)
            if (table[a] != std::vector<Word>{{a}} &&
                !std::binary_search(accessible.begin(), accessible.end(), a))
                field.refuse("a letter that never occurs has a rule");
    for (const Symbol letter : accessible) {
        here_.insert(letter);
        for (const System::Successors& table : system->tables)
            for (const Word& successor : table[letter]) add(successor, name, field);
    }
    add(system->axiom, name, field);
    size_ -= 1;  // of an axiom only the letters count
    read_.systems[name.name] = std::move(system);
}

void Values::read_morphism(const Quantified::Name& name, const Field& field) {
    const bool several = name.of.ends_with("substitutions");
    BoundNames::Images images = task_.reader.images(field, several);
    const bool lengthens = name.of.find("non-erasing") != std::string::npos;
    const bool codes = name.of == "codings" || name.of.starts_with("letter-to-letter");
    for (const auto& [letter, all] : images)
        for (const Word& image : all) {
            if (lengthens && image.empty()) field.refuse("the value erases a letter");
            if (codes && image.size() != 1)
                field.refuse("the image of a letter under the value is not a letter");
            add(image, name, field);
            here_.insert(letter);
        }
    read_.morphisms[name.name] = std::move(images);
}

void Values::read_number(const Quantified::Name& name, const Field& field) {
    const Integer number = field.integer();
    if (name.most && number > Integer(*name.most))
        field.refuse("the value is larger than the bound says");
    if (name.size && number > Integer(*name.size))
        field.refuse("the value is larger than the bound says");
    read_.numbers[name.name] = number;
}

void Values::read_word(const Quantified::Name& name, const Field& field) {
    const Word word = task_.reader.word(field);
    if (name.of == "letters" && word.size() != 1) field.refuse("the value is not a letter");
    add(word, name, field);
    if (name.of == "letters") size_ = 1;
    const auto letter = task_.alphabet().find(name.name);
    read_.words[letter.value()] = word;
}

void Values::check_different() const {
    std::set<Symbol> seen;
    for (const std::set<Symbol>& letters : letters_)
        for (const Symbol letter : letters)
            if (!seen.insert(letter).second)
                values_.refuse("two of the values have a letter in common");
}

namespace {

/// Checks one proof for each statement.
void check_each(const Obligation& task, const Reader& reader, std::string_view field,
                const std::vector<Statement>& statements) {
    if (statements.empty() && !task.proof.has(field)) return;
    const std::vector<Field> proofs = task.proof.at(field).list();
    if (proofs.size() != statements.size())
        task.proof.at(field).refuse("expected " + std::to_string(statements.size()) +
                                    " proofs, found " + std::to_string(proofs.size()));
    for (std::size_t i = 0; i < proofs.size(); ++i)
        check_proof({task.certificate, reader, task.budget, statements[i], !statements[i].negated,
                     proofs[i]});
}

}  // namespace

void check_instance(const Obligation& task) {
    const Quantified& said = *task.statement.quantified;
    if (said.universal == task.holds) task.wrong_kind();
    const Values values(task, said, task.proof.at("values"));
    const Reader reader = task.reader.with(values.names());
    std::vector<Statement> members, conditions;
    for (const Quantified::Name& name : said.names)
        if (auto member = values.membership(name)) members.push_back(std::move(*member));
    check_each(task, reader, "members", members);
    for (const Field& condition : said.conditions)
        conditions.push_back(reader.statement(condition));
    check_each(task, reader, "with", conditions);
    const Statement body = reader.statement(said.body.front());
    check_proof({task.certificate, reader, task.budget, body, body.negated != task.holds,
                 task.proof.at("proof")});
}

namespace {

/// What the names of a universal statement range over.
class Families {
public:
    explicit Families(const Quantified& said) {
        for (const Quantified::Name& name : said.names) of_[name.name] = name.of;
    }

    /// Whether the language is of the family, by the form of systems, by finiteness and by reversal.
    bool shows(const Language& language, const std::string& family) const {
        if (language->kind == Tree::Kind::reversal)
            return family != "IL" && is_checked_family(family) && shows(language->parts[0], family);
        if (language->kind != Tree::Kind::variable) return false;
        const auto found = of_.find(language->name);
        if (found == of_.end()) return false;
        static const std::set<std::string> have_all_finite{"E0L", "ET0L", "EDT0L", "REG", "CF"};
        if (found->second == "finite languages") return have_all_finite.contains(family);
        std::string from = family_of(found->second, " languages");
        if (from == "regular") from = "REG";
        if (from == "context-free") from = "CF";
        const bool has_grammar = from == "REG" || from == "CF";
        if (has_grammar && (family == "CF" || family == "E0L" || family == "ET0L")) return true;
        return !from.empty() && (from == family || is_narrower(from, family));
    }

private:
    /// The letters in front of 0L: those that allow more may be added, those that forbid may be left out.
    static bool is_narrower(const std::string& from, const std::string& to) {
        if (!from.ends_with("0L") || !to.ends_with("0L")) return false;
        const auto has = [](const std::string& name, char letter) {
            return name.find(letter) != std::string::npos;
        };
        for (const char allows : {'E', 'T'})
            if (has(from, allows) && !has(to, allows)) return false;
        for (const char forbids : {'P', 'D'})
            if (!has(from, forbids) && has(to, forbids)) return false;
        return true;
    }

    std::map<std::string, std::string> of_;
};

/// Languages with letters in the place of names; reversals are moved inwards, where they make names of their own.
class WithLetters {
public:
    WithLetters(const Obligation& task, const Quantified& said, Field letters)
        : reader_(task.reader), letters_(std::move(letters)) {
        for (const Quantified::Name& name : said.names) {
            if (name.of.ends_with("languages")) languages_.insert(name.name);
            if (name.of == "words") words_.insert(task.alphabet().find(name.name).value());
        }
    }

    Language of(const Language& language, bool reversed = false) const {
        using Kind = Tree::Kind;
        if (language->kind == Kind::reversal) return of(language->parts[0], !reversed);
        if (language->kind == Kind::variable) {
            if (!languages_.contains(language->name))
                letters_.refuse("a name is bound outside the statement");
            const std::string name = language->name + (reversed ? "^R" : "");
            return words_of({{reader_.letter(letters_.at(name))}});
        }
        if (language->kind == Kind::words) {
            std::vector<Word> words = language->words;
            if (reversed)
                for (Word& word : words) reverse(word);
            return words_of(std::move(words));
        }
        static constexpr std::array kept = {Kind::united, Kind::concatenation, Kind::star,
                                            Kind::plus};
        if (std::find(kept.begin(), kept.end(), language->kind) == kept.end())
            letters_.refuse("a letter cannot stand for a language within this operation");
        std::vector<Language> parts;
        for (const Language& part : language->parts) parts.push_back(of(part, reversed));
        if (reversed && language->kind == Kind::concatenation)
            std::reverse(parts.begin(), parts.end());
        return combination(language->kind, std::move(parts));
    }

private:
    void reverse(Word& word) const {
        for (const Symbol letter : word)
            if (words_.contains(letter))
                letters_.refuse("a letter that stands for any word cannot be reversed");
        std::reverse(word.begin(), word.end());
    }

    const Reader& reader_;
    Field letters_;
    std::set<std::string> languages_;
    std::set<Symbol> words_;  // bound words are letters in a word
};

void collect_letters(const Language& language, std::set<Symbol>& letters) {
    for (const Word& word : language->words) letters.insert(word.begin(), word.end());
    for (const Language& part : language->parts) collect_letters(part, letters);
}

}  // namespace

void check_by_families(const Obligation& task) {
    const Quantified& said = *task.statement.quantified;
    if (!said.universal || !task.holds) task.wrong_kind();
    const Statement& body = task.statement.parts.back();
    if (body.kind != Statement::Kind::family || body.negated ||
        !Families(said).shows(body.languages[0], body.family))
        task.refuse("the families of the names do not show the statement");
}

namespace {

/// The D0L systems' name whose languages the body is about; nothing if it is about others.
const Quantified::Name* d0l_name(const Obligation& task) {
    const Quantified& said = *task.statement.quantified;
    const Statement& body = task.statement.parts.back();
    if (!said.universal || !task.holds || !body.negated || body.languages.size() != 1)
        return nullptr;
    const Tree& language = *body.languages[0];
    if (language.kind != Tree::Kind::generated || language.system) return nullptr;
    for (const Quantified::Name& name : said.names)
        if (name.name == language.name && (name.of == "D0L systems" || name.of == "PD0L systems"))
            return &name;
    return nullptr;
}

}  // namespace

/// Where the lengths of all D0L systems G grow faster than linearly: L(G) is not REG, or not CF.
void check_all_sparse(const Obligation& task) {
    const Statement& body = task.statement.parts.back();
    const Quantified::Name* name = d0l_name(task);
    if (!name || body.kind != Statement::Kind::family ||
        (body.family != "REG" && body.family != "CF"))
        task.wrong_kind();
    for (std::size_t i = 0; i + 1 < task.statement.parts.size(); ++i) {
        const Statement& condition = task.statement.parts[i];
        if (condition.kind == Statement::Kind::growth_class && !condition.negated &&
            condition.systems[0].name == name->name &&
            (condition.family == "exponential" ||
             (condition.family == "polynomial" && condition.size && *condition.size > Integer(1))))
            return;
    }
    task.refuse("no condition says that the lengths grow faster than n");
}

/// Where no rule of G erases, and generation 1 begins with generation 0 and is another word: L(G) is infinite.
void check_longer(const Obligation& task) {
    const Quantified::Name* name = d0l_name(task);
    if (!name || name->of != "PD0L systems" ||
        task.statement.parts.back().kind != Statement::Kind::finite)
        task.wrong_kind();
    const auto is_generation = [&](const std::vector<WordFactor>& side, const char* number) {
        return side.size() == 1 && side[0].generation && side[0].images.empty() &&
               !side[0].reversed && side[0].system.name == name->name &&
               side[0].generation->text() == number;
    };
    bool begins = false, differs = false;
    for (std::size_t i = 0; i + 1 < task.statement.parts.size(); ++i) {
        const Statement& condition = task.statement.parts[i];
        if (condition.kind != Statement::Kind::words || condition.negated) continue;
        const auto is_pair = [&](const char* left, const char* right) {
            return is_generation(condition.sides[0], left) &&
                   is_generation(condition.sides[1], right);
        };
        begins = begins || (condition.family == "begins with" && is_pair("1", "0"));
        differs = differs || (condition.family == "!=" && (is_pair("1", "0") || is_pair("0", "1")));
    }
    if (!begins || !differs)
        task.refuse("no condition says that generation 1 is generation 0 and more");
}

void check_by_letters(const Obligation& task) {
    const Quantified& said = *task.statement.quantified;
    if (!said.universal || !task.holds) task.wrong_kind();
    Statement body = task.statement.parts.back();
    if ((body.kind != Statement::Kind::equal && body.kind != Statement::Kind::included) ||
        body.negated)
        task.wrong_kind();
    const Field letters = task.proof.at("letters");
    std::set<Symbol> used;
    for (const Language& language : body.languages) collect_letters(language, used);
    for (const auto& [name, letter] : letters.object())
        if (!used.insert(task.reader.letter(letter)).second)
            letter.refuse("the letter stands for something else already");
    const WithLetters with_letters(task, said, letters);
    for (Language& language : body.languages) language = with_letters.of(language);
    check_proof(task.part(body, true, task.proof.at("proof")));
}

void check_by_each(const Obligation& task) {
    const Quantified& said = *task.statement.quantified;
    const Statement& body = task.statement.parts.back();
    if (!said.universal || !task.holds || body.kind != Statement::Kind::joint || body.negated ||
        body.family != "all of")
        task.wrong_kind();
    const std::vector<Field> parts = said.body.front().at("all of").list();
    const std::vector<Field> proofs = task.proof.at("proofs").list();
    if (proofs.size() != parts.size())
        task.proof.at("proofs").refuse("expected a proof for each of the " +
                                       std::to_string(parts.size()) + " statements");
    for (std::size_t i = 0; i < parts.size(); ++i) {
        Quantified one = said;
        one.body = {parts[i]};
        Statement statement = task.statement;
        statement.parts.back() = body.parts[i];
        statement.quantified = std::make_shared<const Quantified>(std::move(one));
        check_proof(task.part(statement, true, proofs[i]));
    }
}

void check_parts(const Obligation& task) {
    std::vector<std::optional<bool>> known(task.statement.parts.size());
    for (const Field& each : task.proof.at("parts").list()) {
        each.only({"part", "holds", "proof"});
        const std::uint64_t number = each.at("part").number();
        if (number >= known.size()) each.at("part").refuse("there is no such part");
        const auto index = static_cast<std::size_t>(number);
        const Statement& part = task.statement.parts[index];
        const bool holds = each.at("holds").truth();
        check_proof(task.part(part, holds != part.negated, each.at("proof")));
        known[index] = holds;
    }
    const std::string& joint = task.statement.family;
    std::optional<bool> whole;  // as far as the parts that are known decide it
    if (joint == "all of" || joint == "any of") {
        const bool decisive = joint == "any of";
        if (std::count(known.begin(), known.end(), std::optional(decisive)) > 0)
            whole = decisive;
        else if (std::count(known.begin(), known.end(), std::optional<bool>()) == 0)
            whole = !decisive;
    } else if (joint == "implies") {
        if (known[0] == false || known[1] == true)
            whole = true;
        else if (known[0] && known[1])
            whole = false;
    } else if (known[0] && known[1]) {
        whole = *known[0] == *known[1];
    }
    if (whole != task.holds) task.refuse("the parts that are shown do not decide the statement so");
}

}  // namespace algae::verify
