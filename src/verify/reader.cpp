#include "verify/reader.hpp"

#include <algorithm>
#include <array>

#include "word/word_sets.hpp"

namespace algae::verify {

Symbol Reader::symbol(const Field& field, std::string_view name) const {
    const auto found = alphabet_.find(name);
    if (!found) field.fail("'" + std::string(name) + "' is no letter of the alphabet");
    return *found;
}

Symbol Reader::letter(const Field& field) const { return symbol(field, field.text()); }

Word Reader::word(const Field& field) const {
    Word word;
    std::string_view rest = field.text();
    if (rest.empty()) return word;
    for (;;) {
        const std::size_t blank = rest.find(' ');
        word.push_back(symbol(field, rest.substr(0, blank)));
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
    for (const auto& [name, image] : field.object()) images[symbol(image, name)] = word(image);
    return images;
}

System::Successors Reader::table(const Field& field) const {
    System::Successors table(alphabet_.size());
    for (const auto& [name, successors] : field.object()) {
        auto& all = table[symbol(successors, name)];
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
            if (other.left == rule.left && other.letter == rule.letter && other.right == rule.right)
                each.fail("there is a rule for this letter between these contexts already");
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
    const auto found = systems_.find(field.text());
    if (found == systems_.end()) field.fail("no system is called '" + field.text() + "'");
    return {found->first, found->second};
}

Language Reader::on_one(const Field& field, const std::string& name) const {
    static const std::map<std::string, Tree::Kind> kinds = {
        {"star", Tree::Kind::star}, {"plus", Tree::Kind::plus}, {"reversal", Tree::Kind::reversal}};
    Tree tree;
    tree.parts = {language(field.at(name))};
    if (const auto kind = kinds.find(name); kind != kinds.end()) {
        field.only({name});
        tree.kind = kind->second;
    } else if (name == "complement") {
        field.only({name, "letters"});
        tree.kind = Tree::Kind::complement;
        tree.letters = letters(field.at("letters"));
    } else {
        field.only({name, "morphism"});
        tree.kind = name == "image" ? Tree::Kind::image : Tree::Kind::inverse_image;
        tree.morphism = morphism(field.at("morphism"));
    }
    return std::make_shared<const Tree>(std::move(tree));
}

Language Reader::language(const Field& field) const {
    static const std::map<std::string, Tree::Kind> of_two = {
        {"union", Tree::Kind::united},
        {"intersection", Tree::Kind::intersection},
        {"difference", Tree::Kind::difference},
        {"concatenation", Tree::Kind::concatenation}};
    if (field.has("words")) {
        field.only({"words"});
        return words_of(words(field.at("words")));
    }
    if (field.has("generated")) {
        field.only({"generated"});
        const NamedSystem named = named_system(field.at("generated"));
        return generated_by(named.system, named.name);
    }
    for (const auto& [name, kind] : of_two) {
        if (!field.has(name)) continue;
        field.only({name});
        const auto [left, right] = field.at(name).pair();
        return combination(kind, {language(left), language(right)});
    }
    for (const char* name : {"star", "plus", "reversal", "complement", "image", "inverse image"})
        if (field.has(name)) return on_one(field, name);
    field.fail("expected a language");
}

bool Reader::of_languages(const Field& field, Statement& read) const {
    using Kind = Statement::Kind;
    static constexpr std::array families = {"0L",    "P0L", "D0L",  "PD0L",  "T0L", "PT0L", "DT0L",
                                            "PDT0L", "E0L", "ET0L", "EDT0L", "IL",  "REG",  "CF"};
    if (field.has("is")) {
        field.only({"is", "language"});
        read.family = field.at("is").text();
        read.kind = read.family == "finite"  ? Kind::finite
                    : read.family == "empty" ? Kind::empty
                                             : Kind::family;
        if (read.kind == Kind::family &&
            std::find(families.begin(), families.end(), read.family) == families.end())
            field.at("is").fail("there is no family '" + read.family + "'");
    } else if (field.has("member")) {
        field.only({"member", "language"});
        read.kind = Kind::member;
        read.word = word(field.at("member"));
    } else if (field.has("size")) {
        field.only({"size", "language"});
        read.kind = Kind::size;
        read.size = field.at("size").integer();
    } else {
        for (const char* name : {"equal", "included"}) {
            if (!field.has(name)) continue;
            field.only({name});
            read.kind = std::string_view(name) == "equal" ? Kind::equal : Kind::included;
            const auto [left, right] = field.at(name).pair();
            read.languages = {language(left), language(right)};
            return true;
        }
        return false;
    }
    read.languages = {language(field.at("language"))};
    return true;
}

Statement Reader::of_modules(const Field& field, Statement read) const {
    field.only({"derives", "system", "from", "steps", "probability"});
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
    field.only({of, "equals", "at most"});
    read.kind = of == "dimension" ? Statement::Kind::dimension : Statement::Kind::boundary;
    read.family = field.at(of).text();
    if (!rewritings_.contains(read.family)) read.systems = {named_system(field.at(of))};
    read.at_most = field.has("at most");
    if (read.at_most) field.only({of, "at most"});
    read.formula = field.at(read.at_most ? "at most" : "equals");
    read.formula->text();
    return read;
}

Statement Reader::of_systems(const Field& field, Statement read) const {
    using Kind = Statement::Kind;
    if (field.has("derives")) {
        if (rewritings_.contains(field.at("system").text()))
            return of_modules(field, std::move(read));
        field.only({"derives", "system", "from", "steps"});
        read.kind = Kind::derives;
        read.word = word(field.at("derives"));
        read.systems = {named_system(field.at("system"))};
        if (field.has("from")) read.from = word(field.at("from"));
        if (field.has("steps")) read.steps = field.at("steps").integer();
        return read;
    }
    for (const char* name : {"equal sequences", "equal growth"}) {
        if (!field.has(name)) continue;
        field.only({name});
        read.kind =
            std::string_view(name) == "equal growth" ? Kind::equal_growth : Kind::equal_sequences;
        const auto [left, right] = field.at(name).pair();
        read.systems = {named_system(left), named_system(right)};
        return read;
    }
    if (field.has("dimension") || field.has("boundary")) return of_dimension(field, read);
    if (!field.has("growth")) field.fail("expected a statement");
    read.systems = {named_system(field.at("growth"))};
    if (field.has("equals")) {
        field.only({"growth", "equals"});
        read.kind = Kind::growth_formula;
        read.formula = field.at("equals");
        return read;
    }
    field.only({"growth", "class", "degree"});
    read.kind = Kind::growth_class;
    const Field name = field.at("class");
    read.family = name.text();
    static constexpr std::array classes = {"zero", "bounded", "polynomial", "exponential"};
    if (std::find(classes.begin(), classes.end(), read.family) == classes.end())
        name.fail("there is no class of growth '" + read.family + "'");
    if (field.has("degree")) {
        if (read.family != "polynomial")
            field.at("degree").fail("only polynomial growth has a degree");
        read.size = field.at("degree").integer();
    }
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
    if (of_languages(field, read)) return read;
    return of_systems(field, std::move(read));
}

}  // namespace algae::verify
