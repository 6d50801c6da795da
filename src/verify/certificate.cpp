#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "verify/detail/checking.hpp"
#include "verify/detail/languages.hpp"
#include "verify/verify.hpp"
#include "word/word.hpp"

// A certificate as statements and proofs: systems, languages, words and numbers are read as CERTIFICATES.md says, and written again
// in words from what was read, never from the text that the certificate carries. So what is shown to a person
// is what was checked.

namespace algae::verify {

Symbol Reader::symbol(const Field& field, std::string_view name) const {
    const auto found = alphabet_.find(name);
    if (!found) field.fail("'" + std::string(name) + "' is not a letter of the alphabet");
    return *found;
}

Symbol Reader::free_symbol(const Field& field, std::string_view name) const {
    const Symbol found = symbol(field, name);
    if (is_bound_word(bound_, found))
        field.fail("'" + std::string(name) + "' is bound, and stands for a letter in words only");
    return found;
}

Symbol Reader::letter(const Field& field) const { return free_symbol(field, field.text()); }

void Reader::must_have_no_words(const char* what) const {
    if (!bound_.words.empty() || !bound_.open_words.empty())
        throw BoundReached(Bound::method,
                           std::string(what) + " for all or some words are not checked");
}

Word Reader::word(const Field& field) const {
    Word word;
    std::string_view rest = field.text();
    if (rest.empty()) return word;
    for (;;) {
        const std::size_t blank = rest.find(' ');
        const Symbol letter = symbol(field, rest.substr(0, blank));
        if (const auto bound = bound_.words.find(letter); bound != bound_.words.end())
            word.insert(word.end(), bound->second.begin(), bound->second.end());
        else
            word.push_back(letter);
        if (blank == std::string_view::npos) return word;
        rest.remove_prefix(blank + 1);
    }
}

std::vector<Word> Reader::words(const Field& field) const {
    std::vector<Word> all;
    for (const Field& each : field.list()) all.push_back(word(each));
    return all;
}

std::vector<Symbol> Reader::letters(const Field& field) const {
    Word all = word(field);
    std::sort(all.begin(), all.end());
    if (std::adjacent_find(all.begin(), all.end()) != all.end())
        field.fail("a letter stands here twice");
    return all;
}

std::map<Symbol, Word> Reader::morphism(const Field& field) const {
    std::map<Symbol, Word> images;
    for (const auto& [name, image] : field.object()) images[free_symbol(image, name)] = word(image);
    return images;
}

System::Successors Reader::table(const Field& field) const {
    System::Successors table(alphabet_.size());
    for (const auto& [name, successors] : field.object()) {
        auto& all = table[free_symbol(successors, name)];
        all = words(successors);
        if (all.empty()) successors.fail("a letter needs a successor");
        std::sort(all.begin(), all.end());
        all.erase(std::unique(all.begin(), all.end()), all.end());
    }
    for (Symbol a = 0; a < table.size(); ++a)
        if (table[a].empty()) table[a] = {{a}};
    return table;
}

System Reader::with_context(const Field& field) const {
    field.only({"axiom", "rules", "ignored"});
    System system;
    system.context = true;
    system.axiom = word(field.at("axiom"));
    system.terminal.assign(alphabet_.size(), 1);
    system.ignored.assign(alphabet_.size(), 0);
    if (field.has("ignored"))
        for (const Symbol a : letters(field.at("ignored"))) system.ignored[a] = 1;
    for (const Field& each : field.at("rules").list()) {
        each.only({"left", "letter", "right", "successor"});
        System::Rule rule{word(each.at("left")), letter(each.at("letter")), word(each.at("right")),
                          word(each.at("successor"))};
        for (const System::Rule& other : system.rules)
            if (other == rule) each.fail("the rule is there already");
        system.rules.push_back(std::move(rule));
    }
    return system;
}

System Reader::system(const Field& field) const {
    if (field.has("rules")) return with_context(field);
    field.only({"axiom", "tables", "terminals"});
    System system;
    system.axiom = word(field.at("axiom"));
    for (const Field& each : field.at("tables").list()) system.tables.push_back(table(each));
    if (system.tables.empty()) field.at("tables").fail("a system needs a table");
    system.terminal.assign(alphabet_.size(), field.has("terminals") ? 0 : 1);
    if (field.has("terminals"))
        for (const Symbol a : letters(field.at("terminals"))) system.terminal[a] = 1;
    return system;
}

NamedSystem Reader::named_system(const Field& field) const {
    return named_system(field, field.text());
}

NamedSystem Reader::named_system(const Field& field, const std::string& name) const {
    if (const auto bound = bound_.systems.find(name); bound != bound_.systems.end())
        return {bound->first, bound->second};
    const auto found = systems_.find(name);
    if (found == systems_.end()) field.fail("no system is called '" + name + "'");
    return {found->first, found->second};
}

namespace {

/// An operation on languages: its name in a certificate, where the field `with` may stand beside the operands, and what
/// stands around the operands in words. An operation on one language has nothing between them.
struct Operation {
    std::string_view name;
    Tree::Kind kind;
    std::string_view with;
    const char *before, *between, *after;
};

constexpr std::array<Operation, 10> operations = {{
    {"concatenation", Tree::Kind::concatenation, "", "(", " ", ")"},
    {"difference", Tree::Kind::difference, "", "(", " - ", ")"},
    {"intersection", Tree::Kind::intersection, "", "(", " & ", ")"},
    {"union", Tree::Kind::united, "", "(", " | ", ")"},
    {"star", Tree::Kind::star, "", "", "", "*"},
    {"plus", Tree::Kind::plus, "", "", "", "+"},
    {"reversal", Tree::Kind::reversal, "", "reversal of ", "", ""},
    {"complement", Tree::Kind::complement, "letters", "complement of ", "", " over "},
    {"image", Tree::Kind::image, "morphism", "image of ", "", " under "},
    {"inverse image", Tree::Kind::inverse_image, "morphism", "inverse image of ", "", " under "},
}};

}  // namespace

namespace {

/// The letters that words of a language may have, as far as its expression tells.
std::set<Symbol> letters_of(const Language& language) {
    using Kind = Tree::Kind;
    std::set<Symbol> letters;
    switch (language->kind) {
        case Kind::words:
            for (const Word& word : language->words) letters.insert(word.begin(), word.end());
            return letters;
        case Kind::generated:
            if (language->system)
                for (const Symbol a :
                     accessible_letters(*language->system, language->system->axiom))
                    if (language->system->terminal[a]) letters.insert(a);
            return letters;
        case Kind::complement:
            return {language->letters.begin(), language->letters.end()};
        case Kind::image:
            for (const Symbol a : letters_of(language->parts[0]))
                if (const auto image = language->morphism.find(a);
                    image != language->morphism.end())
                    letters.insert(image->second.begin(), image->second.end());
            return letters;
        case Kind::inverse_image:
            for (const auto& [letter, image] : language->morphism) letters.insert(letter);
            return letters;
        case Kind::difference:
            return letters_of(language->parts[0]);
        case Kind::powers:
            for (const Powers::Block& block : language->powers->blocks)
                letters.insert(block.word.begin(), block.word.end());
            return letters;
        case Kind::intersection: {
            const std::set<Symbol> right = letters_of(language->parts[1]);
            for (const Symbol a : letters_of(language->parts[0]))
                if (right.count(a) > 0) letters.insert(a);
            return letters;
        }
        default:
            for (const Language& part : language->parts) letters.merge(letters_of(part));
            return letters;
    }
}

}  // namespace

std::set<Symbol> Reader::letters_of_values() const {
    std::set<Symbol> all;
    for (const auto& [name, language] : bound_.languages) all.merge(letters_of(language));
    for (const auto& [name, system] : bound_.systems)
        if (system) all.merge(letters_of(generated_by(system, name)));
    for (const auto& [name, images] : bound_.morphisms)
        if (images)
            for (const auto& [letter, words] : *images) {
                all.insert(letter);
                for (const Word& word : words) all.insert(word.begin(), word.end());
            }
    for (const auto& [letter, word] : bound_.words) all.insert(word.begin(), word.end());
    return all;
}

Language Reader::language(const Field& field) const {
    if (field.has("words")) {
        field.only({"words"});
        return words_of(words(field.at("words")));
    }
    if (field.has("generated")) {
        field.only({"generated"});
        const NamedSystem named = named_system(field.at("generated"));
        return generated_by(named.system, named.name);
    }
    if (field.has("powers")) return powers(field);
    if (field.has("name")) {
        field.only({"name"});
        const auto bound = bound_.languages.find(field.at("name").text());
        if (bound == bound_.languages.end())
            field.fail("no language is called '" + field.at("name").text() + "'");
        return bound->second;
    }
    for (const Operation& each : operations) {
        if (!field.has(each.name)) continue;
        if (each.with == "morphism" && field.at(each.with).kind() == JsonValue::Kind::text)
            return bound_image(each.kind, field);
        std::vector<std::string_view> names{each.name};
        if (!each.with.empty()) names.push_back(each.with);
        field.only(names);
        Tree tree;
        tree.kind = each.kind;
        if (*each.between) {
            const auto [left, right] = field.at(each.name).pair();
            tree.parts = {language(left), language(right)};
        } else {
            tree.parts = {language(field.at(each.name))};
        }
        if (each.with == "letters") {
            const bool has_names = !bound_.languages.empty() || !bound_.systems.empty() ||
                                   !bound_.morphisms.empty() || !bound_.words.empty() ||
                                   !bound_.open_words.empty();
            std::set<Symbol> all = letters_of_values();
            if (field.has(each.with)) {
                const std::vector<Symbol> given = letters(field.at(each.with));
                all.insert(given.begin(), given.end());
                if (has_names)
                    tree.name = spell(alphabet_, given) + " and the letters of the values";
            } else {
                all.merge(letters_of(tree.parts[0]));
                if (has_names) tree.name = "the letters of the values";
            }
            tree.letters = {all.begin(), all.end()};
        }
        if (each.with == "morphism") tree.morphism = morphism(field.at(each.with));
        return std::make_shared<const Tree>(std::move(tree));
    }
    field.fail("expected a language");
}

bool Reader::of_languages(const Field& field, Statement& read) const {
    using Kind = Statement::Kind;
    if (field.has("is")) {
        field.only({"is", "language"});
        read.family = field.at("is").text();
        read.kind = read.family == "finite"        ? Kind::finite
                    : read.family == "empty"       ? Kind::empty
                    : read.family == "code"        ? Kind::code
                    : read.family == "prefix code" ? Kind::prefix_code
                                                   : Kind::family;
        if (read.kind == Kind::family && !is_checked_family(read.family) &&
            !is_family_of_forms(read.family))
            field.at("is").fail("there is no family '" + read.family + "'");
    } else if (field.has("member")) {
        field.only({"member", "language"});
        read.kind = Kind::member;
        read.word = word(field.at("member"));
    } else if (field.has("palindrome")) {
        field.only({"palindrome"});
        read.kind = Kind::palindrome;
        read.word = word(field.at("palindrome"));
        return true;
    } else if (field.has("size")) {
        field.only({"size", "language"});
        read.kind = Kind::size;
        read.size = field.at("size").integer();
    } else {
        return false;
    }
    read.languages = {language(field.at("language"))};
    return true;
}

bool Reader::of_pairs(const Field& field, Statement& read) const {
    using Kind = Statement::Kind;
    for (const auto& [name, kind] : {std::pair("equal", Kind::equal),
                                     {"included", Kind::included},
                                     {"equal sequences", Kind::equal_sequences},
                                     {"equal growth", Kind::equal_growth}}) {
        if (!field.has(name)) continue;
        field.only({name});
        read.kind = kind;
        const auto [left, right] = field.at(name).pair();
        if (kind == Kind::equal || kind == Kind::included)
            read.languages = {language(left), language(right)};
        else
            read.systems = {named_system(left), named_system(right)};
        return true;
    }
    return false;
}

Statement Reader::of_modules(const Field& field, Statement read) const {
    field.only({"derives", "system", "from", "steps", "probability"});
    must_have_no_words("derivations of modules");
    read.family = field.at("system").text();
    read.rewriting = rewritings_.at(read.family);
    read.modules = modules(field.at("derives"));
    if (field.has("from")) read.modules_from = modules(field.at("from"));
    read.steps = field.at("steps").integer();
    const bool is_chance = field.has("probability");
    read.kind = is_chance ? Statement::Kind::chance : Statement::Kind::rewrites;
    if (is_chance) read.probability = probability(field.at("probability"));
    return read;
}

Statement Reader::of_dimension(const Field& field, Statement read) const {
    const std::string of = field.has("dimension") ? "dimension" : "boundary";
    field.only({of, "equals", "at most", "at least"});
    read.kind = of == "dimension" ? Statement::Kind::dimension : Statement::Kind::boundary;
    read.family = field.at(of).text();
    if (bound_.systems.contains(read.family) || !rewritings_.contains(read.family))
        read.systems = {named_system(field.at(of))};
    read.compared = field.has("at most")    ? "at most"
                    : field.has("at least") ? "at least"
                                            : "equals";
    field.only({of, read.compared});
    read.formula = field.at(read.compared);
    read.formula->text();
    return read;
}

Statement Reader::of_systems(const Field& field, Statement read) const {
    using Kind = Statement::Kind;
    const auto read_coding = [&] {
        if (!field.has("coding")) return;
        for (const auto& [name, image] : field.at("coding").object())
            read.coding[free_symbol(image, name)] = letter_name(image);
    };
    if (field.has("derives")) {
        if (const std::string& name = field.at("system").text();
            rewritings_.contains(name) && !bound_.systems.contains(name))
            return of_modules(field, std::move(read));
        field.only({"derives", "system", "from", "steps"});
        read.kind = Kind::derives;
        read.word = word(field.at("derives"));
        read.systems = {named_system(field.at("system"))};
        if (field.has("from")) read.from = word(field.at("from"));
        if (field.has("steps")) steps_of(field.at("steps"), read);
        return read;
    }
    if (field.has("dimension") || field.has("boundary")) return of_dimension(field, read);
    if (field.has("first order") || field.has("counts")) {
        const bool counts = field.has("counts");
        if (counts)
            field.only({"counts", "n", "plus", "from", "system", "coding"});
        else
            field.only({"first order", "system", "coding"});
        read.kind = counts ? Kind::counts : Kind::first_order;
        must_have_no_words("statements about places");
        read.systems = {named_system(field.at("system"))};
        read_coding();
        if (counts)
            read.counted = std::make_shared<const CountedPlaces>(read_counts(field));
        else
            read.first_order =
                std::make_shared<const Formula>(read_formula(field.at("first order")));
        return read;
    }
    if (field.has("circular")) {
        field.only({"circular"});
        read.kind = Kind::circular;
        read.systems = {named_system(field.at("circular"))};
        return read;
    }
    if (field.has("critical exponent")) {
        field.only({"critical exponent", "compared", "system", "coding"});
        read.kind = Kind::critical_exponent;
        read.systems = {named_system(field.at("system"))};
        read.number =
            std::make_shared<const RealRoot>(read_real_root(field.at("critical exponent")));
        const Field compared = field.at("compared");
        read.family = compared.text();
        static constexpr std::array comparisons = {"=", "!=", "<", "<=", ">", ">="};
        if (!std::count(comparisons.begin(), comparisons.end(), read.family))
            compared.fail("numbers are not compared by '" + read.family + "'");
        read_coding();
        return read;
    }
    if (field.has("increasing")) {
        field.only({"increasing", "strictly"});
        read.kind = Kind::increasing;
        read.systems = {named_system(field.at("increasing"))};
        read.strictly = field.at("strictly").truth();
        return read;
    }
    if (!field.has("growth")) field.fail("expected a statement");
    read.systems = {named_system(field.at("growth"))};
    field.only({"growth", "class", "degree"});
    read.kind = Kind::growth_class;
    const Field name = field.at("class");
    read.family = name.text();
    static constexpr std::array classes = {"zero", "bounded", "polynomial", "exponential"};
    if (!std::count(classes.begin(), classes.end(), read.family))
        name.fail("there is no class of growth '" + read.family + "'");
    if (field.has("degree")) {
        if (read.family != "polynomial")
            field.at("degree").fail("only polynomial growth has a degree");
        read.size = field.at("degree").integer();
    }
    return read;
}

RealRoot read_real_root(const Field& field) {
    constexpr std::size_t most_terms = 40;
    field.only({"polynomial", "root"});
    std::vector<Integer> coefficients;
    const std::vector<Field> terms = field.at("polynomial").list();
    for (const Field& one : terms) coefficients.push_back(one.integer(true));
    if (coefficients.size() < 2 || coefficients.size() > most_terms || !(coefficients.back() > 0))
        field.fail("expected a polynomial of a degree from 1 to 39, its last coefficient above 0");
    RealRoot read{Polynomial(std::move(coefficients)),
                  static_cast<std::size_t>(field.at("root").number())};
    const Factorisation factors = factorise(read.polynomial);
    if (factors.content != 1 || factors.powers.size() != 1 || factors.powers[0].exponent != 1)
        field.fail("expected an irreducible polynomial");
    std::size_t real = 0;
    for (const Root& one : roots(read.polynomial, 64)) real += one.is_real;
    if (read.root >= real)
        field.at("root").fail("expected a number below that of the real roots, " +
                              std::to_string(real));
    return read;
}

Statement Reader::statement(const Field& field) const {
    Statement read;
    if (field.has("not")) {
        field.only({"not"});
        read = statement(field.at("not"));
        read.negated = !read.negated;
        return read;
    }
    for (const std::string_view kind : {"all of", "any of", "implies", "iff"})
        if (field.has(kind)) return joint(field, kind);
    if (field.has("for all") || field.has("for some")) return quantified(field);
    if (of_languages(field, read) || of_pairs(field, read) || of_numbers(field, read)) return read;
    return of_systems(field, std::move(read));
}

Language words_of(std::vector<Word> words) {
    std::sort(words.begin(), words.end(), shortlex_less);
    words.erase(std::unique(words.begin(), words.end()), words.end());
    Tree tree;
    tree.words = std::move(words);
    return std::make_shared<const Tree>(std::move(tree));
}

Language generated_by(std::shared_ptr<const System> system, std::string name) {
    Tree tree;
    tree.kind = Tree::Kind::generated;
    tree.system = std::move(system);
    tree.name = std::move(name);
    return std::make_shared<const Tree>(std::move(tree));
}

Language combination(Tree::Kind kind, std::vector<Language> parts,
                     std::map<Symbol, Word> morphism) {
    Tree tree;
    tree.kind = kind;
    constexpr std::size_t deepest = 1'000;  // a stack of 8 MiB holds the walks, with sanitizers too
    for (const Language& part : parts) tree.depth = std::max(tree.depth, part->depth + 1);
    if (tree.depth > deepest)
        throw BoundReached(Bound::method, "more than 1000 languages stand within each other");
    tree.parts = std::move(parts);
    tree.morphism = std::move(morphism);
    return std::make_shared<const Tree>(std::move(tree));
}

bool same(const Language& left, const Language& right) {
    const auto is_bound = [](const Language& language) {
        return language->kind == Tree::Kind::variable ||
               (language->kind == Tree::Kind::generated && !language->system);
    };
    if (is_bound(left) || is_bound(right))  // names are all that is known of them
        return is_bound(left) && is_bound(right) && left->kind == right->kind &&
               left->name == right->name;
    return std::tie(left->kind, left->words, left->letters, left->morphism) ==
               std::tie(right->kind, right->words, right->letters, right->morphism) &&
           (!left->powers || *left->powers == *right->powers) &&
           (!left->system || *left->system == *right->system) &&
           std::equal(left->parts.begin(), left->parts.end(), right->parts.begin(),
                      right->parts.end(), same);
}

bool is_regular(const Language& language) {
    return language->kind != Tree::Kind::generated && language->kind != Tree::Kind::variable &&
           (!language->powers || regular_form(*language->powers)) &&
           std::all_of(language->parts.begin(), language->parts.end(), is_regular);
}

namespace {

/// A name must not change how what is printed looks: no control characters, and none that are not seen.
void check_name(const Field& field, const std::string& name) {
    const auto has = [&](const char* bytes) { return name.find(bytes) != std::string::npos; };
    // What is not seen, or is like a blank: U+00A0, U+00AD, U+2000 to U+200D, U+2028, U+2029, U+202F, U+205F to U+2064, U+3000, U+FEFF.
    for (const char* mark :
         {"\u00A0", "\u00AD", "\u061C", "\u1680", "\u180E", "\u2000", "\u2001", "\u2002",
          "\u2003", "\u2004", "\u2005", "\u2006", "\u2007", "\u2008", "\u2009", "\u200A",
          "\u200B", "\u200C", "\u200D", "\u2028", "\u2029", "\u202F", "\u205F", "\u2060",
          "\u2061", "\u2062", "\u2063", "\u2064", "\u3000", "\uFEFF"})
        if (has(mark)) field.fail("a name must not have characters that are not seen");
    if (plain(name) != name) field.fail("a name must not have control characters");
}

}  // namespace

std::string letter_name(const Field& field) {
    const std::string& name = field.text();
    if (name.empty() || name.find_first_of(" '") != std::string::npos)
        field.fail("expected the name of a letter, without blanks and quotes");
    check_name(field, name);
    return name;
}

namespace {

std::shared_ptr<const Alphabet> read_alphabet(const Field& field) {
    auto alphabet = std::make_shared<Alphabet>();
    for (const Field& each : field.list()) {
        const std::string& name = each.text();
        if (name.empty() || name.find(' ') != std::string::npos)
            each.fail("the name of a letter must not be empty and must not have a blank");
        check_name(each, name);
        if (alphabet->find(name)) each.fail("the letter '" + name + "' stands here twice");
        alphabet->symbol(name);
    }
    return alphabet;
}

}  // namespace

Entry read_entry(const Field& field, const Reader& reader) {
    using Verdict = Entry::Verdict;
    const Field given = field.at("verdict");
    struct Known {
        std::string_view name;
        Verdict verdict;
        std::string_view with;  // the field beside it
    };
    static constexpr std::array<Known, 4> known = {{{"proved", Verdict::proved, "proof"},
                                                    {"refuted", Verdict::refuted, "proof"},
                                                    {"cited", Verdict::cited, "citation"},
                                                    {"undecided", Verdict::undecided, "verdict"}}};
    const auto found = std::find_if(known.begin(), known.end(),
                                    [&](const Known& each) { return each.name == given.text(); });
    if (found == known.end())
        given.fail("expected proved, refuted, undecided or cited, found '" + given.text() + "'");
    Entry entry{field,
                field.at("text").text(),
                reader.statement(field.at("statement")),
                found->verdict,
                std::nullopt,
                ""};
    field.only({"text", "statement", "verdict", found->with});
    if (found->with == "proof") entry.proof = field.at("proof");
    if (entry.verdict != Verdict::cited) return entry;
    entry.citation = field.at("citation").text();
    if (entry.citation.empty()) field.at("citation").fail("the source is missing");
    return entry;
}

void read_header(Certificate& read, JsonValue header) {
    read.header = std::move(header);
    const Field root(read.header, "", read.file);
    root.only({"format", "claim", "source", "empty axiom", "alphabet", "systems", "turtles",
               "statements"});
    if (root.at("format").text() != "algae certificate 1")
        root.at("format").fail("expected \"algae certificate 1\"");
    read.claim = root.at("claim").text();
    if (root.has("source")) read.source = root.at("source").text();
    if (root.has("empty axiom")) read.empty_axiom = root.at("empty axiom").truth();
    read.alphabet = read_alphabet(root.at("alphabet"));
    const Reader reader(*read.alphabet, read.systems, read.rewritings);
    for (const auto& [name, system] : root.at("systems").object()) {
        check_name(system, name);
        if (system.has("modules"))
            read.rewritings.emplace(name,
                                    std::make_shared<const ModuleSystem>(module_system(system)));
        else
            read.systems.emplace(name, std::make_shared<const System>(reader.system(system)));
    }
    if (!root.has("turtles")) return;
    for (const auto& [name, turtle] : root.at("turtles").object()) {
        if (!read.systems.contains(name)) turtle.fail("no system is called '" + name + "'");
        read_turtle(turtle, *read.alphabet);
    }
}

}  // namespace algae::verify

namespace algae {

namespace {

using Json = nlohmann::ordered_json;
using End = ObstructionCase::End;

/// How a case ends, and with which fields.
struct Ending {
    std::string_view name;
    End end;
    std::vector<std::string_view> fields;

    bool has(std::string_view field) const {
        return std::count(fields.begin(), fields.end(), field) > 0;
    }
};

const std::vector<Ending>& endings() {
    static const std::vector<Ending> all = {
        {"no image", End::no_image, {"letter"}},
        {"needed", End::needed, {}},
        {"sources", End::sources, {"sources"}},
        {"conflict", End::conflict, {"word", "images", "rules", "cases"}},
        {"choice", End::choice, {"letter", "rules", "cases"}}};
    return all;
}

/// Writes the parts of an obstruction.
class Writer {
public:
    explicit Writer(const Alphabet& alphabet) : alphabet_(alphabet) {}

    Json one_case(const ObstructionCase& part) const {
        Json written = Json::object();
        written["excluded"] = Json::array();
        for (const ExcludedRule& excluded : part.excluded) {
            Json each{{"letter", alphabet_.name(excluded.rule.letter)},
                      {"image", word(excluded.rule.image)},
                      {"word", word(excluded.word)}};
            if (!excluded.images.empty()) each["images"] = words(excluded.images);
            written["excluded"].push_back(std::move(each));
        }
        const Ending& ending =
            *std::find_if(endings().begin(), endings().end(),
                          [&](const Ending& each) { return each.end == part.end; });
        written["end"] = ending.name;
        if (ending.has("letter")) written["letter"] = alphabet_.name(part.letter);
        if (ending.has("sources")) {
            written["sources"] = Json::array();
            for (const auto& set : part.sources) written["sources"].push_back(words(set));
        }
        if (ending.has("word")) {
            written["word"] = word(part.word);
            written["images"] = words(part.images);
        }
        if (!ending.has("cases")) return written;
        written["rules"] = rules(part.rules);
        written["cases"] = Json::array();
        for (const ObstructionCase& each : part.cases) written["cases"].push_back(one_case(each));
        return written;
    }

    Json rules(const std::vector<LetterRule>& all) const {
        Json written = Json::array();
        for (const LetterRule& rule : all)
            written.push_back(
                {{"letter", alphabet_.name(rule.letter)}, {"image", word(rule.image)}});
        return written;
    }

private:
    Json word(const Word& each) const { return certificate_text(alphabet_, each); }
    Json words(const std::vector<Word>& all) const {
        Json written = Json::array();
        for (const Word& each : all) written.push_back(word(each));
        return written;
    }

    const Alphabet& alphabet_;
};

}  // namespace

std::string certificate_text(const Alphabet& alphabet, const Word& word) {
    std::string text;
    for (std::size_t i = 0; i < word.size(); ++i)
        text += (i > 0 ? " " : "") + alphabet.name(word[i]);
    return text;
}

Json to_json(const FamilyObstruction& obstruction) {
    const Writer writer(*obstruction.language.alphabet);
    Json written{{"root", writer.one_case(obstruction.root)}};
    if (obstruction.impossible.empty()) return written;
    written["impossible"] = Json::array();
    for (const ImpossibleTable& table : obstruction.impossible)
        written["impossible"].push_back(
            {{"rules", writer.rules(table.rules)}, {"why", writer.one_case(table.why)}});
    return written;
}

namespace verify {

namespace {

LetterRule read_rule(const Reader& reader, const Field& field) {
    return {reader.letter(field.at("letter")), reader.word(field.at("image"))};
}

std::vector<LetterRule> read_rules(const Reader& reader, const Field& field) {
    std::vector<LetterRule> all;
    for (const Field& each : field.list()) {
        each.only({"letter", "image"});
        all.push_back(read_rule(reader, each));
    }
    return all;
}

ExcludedRule read_excluded(const Reader& reader, const Field& field) {
    field.only({"letter", "image", "word", "images"});
    ExcludedRule read{read_rule(reader, field), reader.word(field.at("word")), {}};
    if (field.has("images")) {
        read.images = reader.words(field.at("images"));
        if (read.images.empty()) field.at("images").fail("a step has an image for each letter");
    }
    return read;
}

ObstructionCase read_case(const Reader& reader, const Field& field) {
    ObstructionCase read;
    for (const Field& each : field.at("excluded").list())
        read.excluded.push_back(read_excluded(reader, each));
    const Field end = field.at("end");
    const auto found = std::find_if(endings().begin(), endings().end(),
                                    [&](const Ending& each) { return each.name == end.text(); });
    if (found == endings().end()) end.fail("no case ends with '" + end.text() + "'");
    read.end = found->end;
    std::vector<std::string_view> fields = found->fields;
    fields.insert(fields.end(), {"excluded", "end"});
    field.only(fields);
    if (found->has("letter")) read.letter = reader.letter(field.at("letter"));
    if (found->has("sources"))
        for (const Field& set : field.at("sources").list())
            read.sources.push_back(reader.words(set));
    if (found->has("word")) {
        read.word = reader.word(field.at("word"));
        read.images = reader.words(field.at("images"));
    }
    if (!found->has("cases")) return read;
    read.rules = read_rules(reader, field.at("rules"));
    for (const Field& each : field.at("cases").list())
        read.cases.push_back(read_case(reader, each));
    return read;
}

}  // namespace

FamilyObstruction read_obstruction(const Reader& reader, const Field& field) {
    field.only({"root", "impossible"});
    FamilyObstruction read;
    read.root = read_case(reader, field.at("root"));
    if (!field.has("impossible")) return read;
    for (const Field& each : field.at("impossible").list()) {
        each.only({"rules", "why"});
        read.impossible.push_back(
            {read_rules(reader, each.at("rules")), read_case(reader, each.at("why"))});
    }
    return read;
}

}  // namespace verify

}  // namespace algae

namespace algae::verify {

namespace {

constexpr std::size_t longest = 160;  // bytes of one expression

std::string in_quotes(const std::string& name) {
    std::string quoted = "'";
    for (const char c : name)
        quoted += c == '\'' || c == '\\' ? std::string("\\") + c : std::string(1, c);
    return quoted + "'";
}

}  // namespace

std::string system_name(std::string name) {
    std::string plain_name = name;
    std::replace_if(
        plain_name.begin(), plain_name.end(), [](char c) { return c == '-' || c == '.'; }, '_');
    return is_name(plain_name) ? name : in_quotes(name);
}

std::string letter_text(const std::string& name) {
    std::size_t characters = 0;
    for (const char c : name) characters += (static_cast<unsigned char>(c) & 0xC0) != 0x80;
    static constexpr std::array<std::string_view, 10> signs = {"ε", "'", "\\", ",", ";",
                                                               ":", "{", "}",  "(", ")"};
    const bool is_sign = std::find(signs.begin(), signs.end(), name) != signs.end();
    return characters > 1 || is_sign ? in_quotes(name) : name;
}

namespace {

/// A word letter by letter; ε if it is empty.
std::string word_text(const Alphabet& alphabet, const Word& word) {
    std::string text;
    for (const Symbol a : word) text += letter_text(alphabet.name(a));
    return text.empty() ? "ε" : text;
}

/// The text with a gap in its middle if it is long, cut between characters.
std::string shortened(const std::string& text) {
    if (text.size() <= longest) return text;
    const auto inside = [&](std::size_t i) {
        return (static_cast<unsigned char>(text[i]) & 0xC0) == 0x80;
    };
    std::size_t head = longest / 2, tail = text.size() - longest / 2;
    while (head > 0 && inside(head)) --head;
    while (tail < text.size() && inside(tail)) ++tail;
    return text.substr(0, head) + " ... " + text.substr(tail);
}

std::string morphism_text(const std::map<Symbol, Word>& morphism, const Alphabet& alphabet) {
    std::string text;
    for (const auto& [a, image] : morphism)
        text += (text.empty() ? "" : ", ") + letter_text(alphabet.name(a)) + " -> " +
                word_text(alphabet, image);
    return "[" + text + "]";
}

std::string language_text(const Language& language, const Alphabet& alphabet) {
    const auto part = [&](std::size_t i) { return language_text(language->parts[i], alphabet); };
    std::string text;
    if (language->kind == Tree::Kind::variable) return language->name;
    if (language->kind == Tree::Kind::generated) return "L(" + system_name(language->name) + ")";
    if (language->kind == Tree::Kind::powers)
        return shortened(powers_text(*language->powers,
                                     [&](const Word& word) { return word_text(alphabet, word); }));
    if (language->kind == Tree::Kind::words) {
        for (const Word& word : language->words)
            text += (text.empty() ? "" : ", ") + word_text(alphabet, word);
        return shortened("{" + text + "}");
    }
    const Operation& operation =
        *std::find_if(operations.begin(), operations.end(),
                      [&](const Operation& each) { return each.kind == language->kind; });
    text = operation.before + part(0);
    if (*operation.between) text += operation.between + part(1);
    text += operation.after;
    if (operation.with == "letters")
        text += !language->name.empty()     ? language->name
                : language->letters.empty() ? "no letters"
                                            : word_text(alphabet, language->letters);
    if (operation.with == "morphism")
        text +=
            language->name.empty() ? morphism_text(language->morphism, alphabet) : language->name;
    return shortened(text);
}

/// "sqrt(2)", "(x + 1/3)".
std::string term_text(const Term& term) {
    if (term.kind == Term::Kind::number)
        return exact_decimal(term.number).value_or(to_string(term.number));
    if (term.kind == Term::Kind::parameter) return term.name;
    const bool is_between = term.parts.size() == 2 && !term.name.empty() &&
                            !std::isalpha(static_cast<unsigned char>(term.name.front()));
    std::string text;
    for (const Term& part : term.parts)
        text += (text.empty() ? "" : is_between ? " " + term.name + " " : ",") + term_text(part);
    return (is_between ? "" : term.name) + "(" + text + ")";
}

std::string modules_text(const WrittenModules& word) {
    std::string text;
    for (const auto& [letter, terms] : word) {
        text += letter_text(letter);
        std::string list;
        for (const Term& term : terms) list += (list.empty() ? "" : ",") + term_text(term);
        if (!list.empty()) text += "(" + list + ")";
    }
    return text.empty() ? "ε" : shortened(text);
}

/// "n + 2*m + 1".
std::string steps_text(const std::map<std::string, Integer>& steps) {
    std::string text;
    for (const auto& [name, times] : steps)
        text +=
            (text.empty() ? "" : " + ") +
            (name == "1" ? to_string(times) : (times == 1 ? "" : to_string(times) + "*") + name);
    return text.empty() ? "0" : text;
}

/// "[a -> ab](word(G, n)) b".
std::string side_text(const std::vector<WordFactor>& side, const Alphabet& alphabet) {
    std::string text;
    for (const WordFactor& factor : side) {
        std::string one = factor.generation ? "word(" + system_name(factor.system.name) + ", " +
                                                  factor.generation->text() + ")"
                                            : word_text(alphabet, factor.word);
        for (const auto& image : factor.images)
            one = morphism_text(image, alphabet) + "(" + one + ")";
        if (factor.reversed) one = "reversal of " + one;
        if (factor.reversed && side.size() > 1) one = "(" + one + ")";
        text += (text.empty() ? "" : " ") + one;
    }
    return text.empty() ? "ε" : shortened(text);
}

std::string plain_text(const Statement& statement, const Alphabet& alphabet, bool opposite);

/// "for all 0L languages A, B with (A = B): (A | B) is 0L".
std::string quantified_text(const Statement& statement, const Alphabet& alphabet) {
    const Quantified& said = *statement.quantified;
    std::string text = said.universal ? "for all " : "for some ";
    for (std::size_t i = 0; i < said.names.size(); ++i) {
        const Quantified::Name& name = said.names[i];
        const bool is_letter = name.of == "words" || name.of == "letters";
        text += (i > 0 ? " and " : "") + name.of + " " +
                (is_letter ? letter_text(name.name) : name.name);
        if (name.size) text += " up to size " + std::to_string(*name.size);
        if (name.length) text += " with words up to length " + std::to_string(*name.length);
        if (name.most) text += " up to " + std::to_string(*name.most);
    }
    if (said.different_letters) text += " over different letters";
    if (said.over)
        text += said.over->empty() ? " over no letters"
                                   : " over the letters " + word_text(alphabet, *said.over);
    for (std::size_t i = 0; i + 1 < statement.parts.size(); ++i)
        text += (i > 0 ? " and (" : " with (") +
                plain_text(statement.parts[i], alphabet, statement.parts[i].negated) + ")";
    const Statement& body = statement.parts.back();
    return text + ": " + plain_text(body, alphabet, body.negated);
}

/// "3", or "real root 1 of 2 of x^2 - 5x + 5".
std::string real_root_text(const RealRoot& number) {
    const Polynomial& polynomial = number.polynomial;
    if (polynomial.degree() == 1)
        return to_string(Rational(-polynomial.coefficient(0), polynomial.coefficient(1)));
    return "real root " + std::to_string(number.root + 1) + " of " + to_string(polynomial);
}

std::string joint_text(const Statement& statement, const Alphabet& alphabet) {
    const std::string between = statement.family == "all of"   ? " and "
                                : statement.family == "any of" ? " or "
                                                               : " " + statement.family + " ";
    std::string text;
    for (const Statement& part : statement.parts)
        text +=
            (text.empty() ? "(" : between + "(") + plain_text(part, alphabet, part.negated) + ")";
    return text;
}

std::string plain_text(const Statement& statement, const Alphabet& alphabet, bool opposite) {
    using Kind = Statement::Kind;
    const std::string no = opposite ? "not " : "";
    const auto language = [&](std::size_t i) {
        return language_text(statement.languages[i], alphabet);
    };
    const auto system = [&](std::size_t i) { return system_name(statement.systems[i].name); };
    const std::string word = shortened(word_text(alphabet, statement.word));
    switch (statement.kind) {
        case Kind::family:
            return language(0) + " is " + no + statement.family;
        case Kind::finite:
            return language(0) + " is " + no + "finite";
        case Kind::empty:
            return language(0) + " is " + no + "empty";
        case Kind::code:
        case Kind::prefix_code:
            return language(0) + " is " + no + "a " + statement.family;
        case Kind::palindrome:
            return word + " is " + no + "a palindrome";
        case Kind::equal:
            return language(0) + (opposite ? " != " : " = ") + language(1);
        case Kind::included:
            return language(0) + (opposite ? " is not within " : " <= ") + language(1);
        case Kind::member:
            return word + " is " + no + "in " + language(0);
        case Kind::size:
            return language(0) + (opposite ? " does not have " : " has ") +
                   shortened(to_string(*statement.size)) + " words";
        case Kind::derives:
            return system(0) + (opposite ? " does not derive " : " derives ") + word +
                   (statement.from ? " from " + shortened(word_text(alphabet, *statement.from))
                                   : "") +
                   (statement.steps ? " in " + shortened(to_string(*statement.steps)) + " steps"
                    : statement.bound_steps ? " in " + steps_text(*statement.bound_steps) + " steps"
                                            : "");
        case Kind::rewrites:
        case Kind::chance: {
            const bool is_chance = statement.kind == Kind::chance;
            return system_name(statement.family) +
                   (opposite && !is_chance ? " does not derive " : " derives ") +
                   modules_text(statement.modules) +
                   (statement.modules_from ? " from " + modules_text(*statement.modules_from)
                                           : "") +
                   " in " + shortened(to_string(*statement.steps)) + " steps" +
                   (is_chance ? std::string(opposite ? ", not" : "") + " with the probability " +
                                    to_string(*statement.probability)
                              : "");
        }
        case Kind::equal_sequences:
            return system(0) + " and " + system(1) + " have " + (opposite ? "different" : "equal") +
                   " sequences";
        case Kind::equal_growth:
            return system(0) + " and " + system(1) + " have " + (opposite ? "different" : "equal") +
                   " lengths";
        case Kind::increasing:
            return "the lengths of " + system(0) + " are " + no +
                   (statement.strictly ? "strictly increasing" : "increasing");
        case Kind::numbers:
            return (opposite ? "not " : "") + shortened(statement.terms[0].text()) + " " +
                   statement.family + " " + shortened(statement.terms[1].text());
        case Kind::words:
            return (opposite ? "not " : "") + side_text(statement.sides[0], alphabet) + " " +
                   statement.family + " " + side_text(statement.sides[1], alphabet);
        case Kind::dimension:
        case Kind::boundary:
            return std::string("the ") +
                   (statement.kind == Kind::dimension ? "dimension" : "boundary's dimension") +
                   " of " + system_name(statement.family) + " is " + no +
                   (statement.compared == "equals" ? "" : statement.compared + " ") +
                   statement.formula->text();
        case Kind::first_order:
        case Kind::counts:
            return (opposite ? "not: " : "") + formula_text(statement, alphabet);
        case Kind::critical_exponent:
            return (opposite ? "not: " : "") + std::string("the critical exponent of ") +
                   system(0) + " " + statement.family + " " + real_root_text(*statement.number);
        case Kind::circular:
            return system(0) + " is " + no + "circular";
        case Kind::joint:
            return (opposite ? "not: " : "") + joint_text(statement, alphabet);
        case Kind::quantified:
            return (opposite ? "not " : "") + quantified_text(statement, alphabet);
        case Kind::growth_class:
            break;
    }
    return "the class of growth of " + system(0) + " is " + no + statement.family +
           (statement.size ? " of degree " + shortened(to_string(*statement.size)) : "");
}

}  // namespace

std::string statement_text(const Statement& statement, bool refuted, const Alphabet& alphabet) {
    return plain_text(statement, alphabet, statement.negated != refuted);
}

namespace {

std::string system_text(const System& system, const Alphabet& alphabet) {
    std::string text = "axiom " + word_text(alphabet, system.axiom);
    for (const System::Rule& rule : system.rules)
        text += "; " + (rule.left.empty() ? "" : word_text(alphabet, rule.left) + " < ") +
                letter_text(alphabet.name(rule.letter)) +
                (rule.right.empty() ? "" : " > " + word_text(alphabet, rule.right)) + " -> " +
                word_text(alphabet, rule.successor);
    for (const System::Successors& table : system.tables) {
        if (system.tables.size() > 1) text += "; table";
        for (Symbol a = 0; a < table.size(); ++a) {
            if (table[a] == std::vector<Word>{{a}}) continue;
            text += "; " + letter_text(alphabet.name(a)) + " -> ";
            for (std::size_t i = 0; i < table[a].size(); ++i)
                text += (i > 0 ? " | " : "") + word_text(alphabet, table[a][i]);
        }
    }
    const auto listed = [&](const std::vector<char>& chosen) {
        std::string letters;
        for (Symbol a = 0; a < chosen.size(); ++a)
            if (chosen[a]) letters += letter_text(alphabet.name(a));
        return letters.empty() ? "none" : letters;
    };
    if (std::count(system.terminal.begin(), system.terminal.end(), 0) > 0)
        text += "; terminals " + listed(system.terminal);
    if (std::count(system.ignored.begin(), system.ignored.end(), 1) > 0)
        text += "; ignored " + listed(system.ignored);
    return text;
}

/// "A(x) < B(y) > C : (x > y), 1/2 -> A((x + 1)) B(y)".
std::string rule_text(const ModuleSystem::Rule& rule) {
    const auto all = [](const std::vector<ModuleSystem::Pattern>& patterns) {
        WrittenModules written;
        for (const auto& [letter, parameters] : patterns) {
            auto& terms = written.emplace_back(letter, std::vector<Term>{}).second;
            for (const std::string& name : parameters) {
                Term parameter;
                parameter.kind = Term::Kind::parameter;
                parameter.name = name;
                terms.push_back(std::move(parameter));
            }
        }
        return modules_text(written);
    };
    std::string text = (rule.left.empty() ? "" : all(rule.left) + " < ") + all({rule.module}) +
                       (rule.right.empty() ? "" : " > " + all(rule.right));
    if (!rule.elsewhere.empty()) text += " elsewhere " + all(rule.elsewhere);
    if (rule.condition) text += " : " + term_text(*rule.condition);
    if (rule.probability) text += ", " + to_string(*rule.probability);
    return text + " -> " + modules_text(rule.successor);
}

}  // namespace

std::vector<std::string> definitions(const Certificate& certificate) {
    const Alphabet& alphabet = *certificate.alphabet;
    std::string letters = "letters";
    for (Symbol a = 0; a < alphabet.size(); ++a) letters += ' ' + letter_text(alphabet.name(a));
    std::vector<std::string> lines{alphabet.size() == 0 ? "no letters" : letters};
    for (const auto& [name, system] : certificate.systems)
        lines.push_back(system_name(name) + ": " + system_text(*system, alphabet));
    if (certificate.empty_axiom) lines.push_back("the axiom of a system may be ε");
    for (const auto& [name, system] : certificate.rewritings) {
        std::string line = system_name(name) + ": axiom " + modules_text(system->axiom);
        for (const ModuleSystem::Rule& rule : system->rules) line += "; " + rule_text(rule);
        std::string ignored;
        for (const std::string& letter : system->ignored) ignored += letter_text(letter);
        lines.push_back(line + (ignored.empty() ? "" : "; ignored " + ignored));
    }
    for (std::string& line : turtle_texts(certificate)) lines.push_back(std::move(line));
    for (std::string& line : lines) line = plain(line);
    return lines;
}

}  // namespace algae::verify
