#include "language/detail/judge.hpp"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <map>
#include <set>

#include "language/detail/powers.hpp"
#include "word/word.hpp"

// Languages as values, their text with as few brackets as the levels of the operations allow, and the forms of
// systems that names of families say.

namespace algae {

namespace {

using Kind = LanguageTree::Kind;

Language make(LanguageTree tree) { return std::make_shared<const LanguageTree>(std::move(tree)); }

void add_letters(std::set<Symbol>& letters, const Word& word) {
    letters.insert(word.begin(), word.end());
}

void add_letters(std::set<Symbol>& letters, const SourceSystem& system) {
    if (system.variable) return;
    if (system.tables) {
        for (const Symbol a : accessible_letters(*system.tables))
            if (system.tables->terminal[a]) letters.insert(a);
        return;
    }
    add_letters(letters, system.interactive->axiom);
    for (const auto& rules : system.interactive->rules)
        for (const IL::Rule& rule : rules) add_letters(letters, rule.successor);
}

void add_letters(std::set<Symbol>& letters, const LanguageTree& tree) {
    switch (tree.kind) {
        case Kind::words:
            for (const Word& word : tree.words) add_letters(letters, word);
            return;
        case Kind::generated:
            add_letters(letters, *tree.system);
            return;
        case Kind::complement:
            letters.insert(tree.letters.begin(), tree.letters.end());
            return;
        case Kind::image: {
            for (const Symbol a : letters_of(tree.parts[0]))
                if (tree.morphism.maps(a)) add_letters(letters, tree.morphism[a]);
            return;
        }
        case Kind::inverse_image:
            for (const Symbol a : tree.morphism.domain()) letters.insert(a);
            return;
        case Kind::difference:
            add_letters(letters, *tree.parts[0]);
            return;
        case Kind::powers:
            for (const Powers::Block& block : tree.powers->blocks) add_letters(letters, block.word);
            return;
        case Kind::intersected: {
            const std::vector<Symbol> left = letters_of(tree.parts[0]),
                                      right = letters_of(tree.parts[1]);
            std::set_intersection(left.begin(), left.end(), right.begin(), right.end(),
                                  std::inserter(letters, letters.end()));
            return;
        }
        default:
            for (const Language& part : tree.parts) add_letters(letters, *part);
    }
}

// How tightly an expression holds together, loosest first; what is looser goes between brackets.
enum Level { sum, intersection, product, prefix, primary };

Level level(const LanguageTree& tree) {
    if (!tree.name.empty()) return primary;
    switch (tree.kind) {
        case Kind::united:
        case Kind::difference:
            return sum;
        case Kind::intersected:
            return intersection;
        case Kind::concatenated:
            return product;
        case Kind::complement:
            return prefix;
        default:
            return primary;
    }
}

std::string text(const Language& language, const Alphabet& alphabet, Level least);

std::string words_text(const std::vector<Word>& words, const Alphabet& alphabet) {
    return "{" + joined(words, ", ", [&](const Word& word) { return spell(alphabet, word); }) + "}";
}

std::string morphism_text(const LanguageTree& tree, const Alphabet& alphabet) {
    return tree.variable ? tree.variable->name : to_string(tree.morphism, alphabet);
}

std::string operation_text(const LanguageTree& tree, const Alphabet& alphabet) {
    const auto part = [&](std::size_t i, Level least) {
        return text(tree.parts[i], alphabet, least);
    };
    switch (tree.kind) {
        case Kind::words:
            return words_text(tree.words, alphabet);
        case Kind::generated:
            return tree.system->grammar.empty() ? "L(" + tree.system->name + ")"
                                                : tree.system->grammar;
        case Kind::united:
            return part(0, sum) + " | " + part(1, intersection);
        case Kind::difference:
            return part(0, sum) + " \\ " + part(1, intersection);
        case Kind::intersected:
            return part(0, intersection) + " & " + part(1, product);
        case Kind::concatenated:
            return part(0, product) + " . " + part(1, prefix);
        case Kind::complement:
            return "~" + part(0, prefix);
        case Kind::star:
            return part(0, primary) + "*";
        case Kind::plus:
            return part(0, primary) + "+";
        case Kind::reversed:
            return part(0, primary) + "^R";
        case Kind::image:
            return morphism_text(tree, alphabet) + "(" + part(0, sum) + ")";
        case Kind::inverse_image:
            return morphism_text(tree, alphabet) + "^-1(" + part(0, sum) + ")";
        case Kind::variable:
            return tree.variable->name;
        case Kind::powers:
            return to_string(*tree.powers, alphabet);
    }
    return {};
}

std::string text(const Language& language, const Alphabet& alphabet, Level least) {
    if (!language->name.empty()) return language->name;
    const std::string inner = operation_text(*language, alphabet);
    return level(*language) < least ? "(" + inner + ")" : inner;
}

}  // namespace

Language words_language(std::vector<Word> words) {
    std::sort(words.begin(), words.end(), shortlex_less);
    words.erase(std::unique(words.begin(), words.end()), words.end());
    LanguageTree tree;
    tree.words = std::move(words);
    return make(std::move(tree));
}

Language generated_language(std::shared_ptr<const SourceSystem> system) {
    LanguageTree tree;
    tree.kind = Kind::generated;
    tree.system = std::move(system);
    return make(std::move(tree));
}

Language combined(LanguageTree::Kind kind, std::vector<Language> parts) {
    LanguageTree tree;
    tree.kind = kind;
    tree.parts = std::move(parts);
    return make(std::move(tree));
}

Language complement_language(Language language, std::vector<Symbol> letters) {
    LanguageTree tree;
    tree.kind = Kind::complement;
    tree.parts = {std::move(language)};
    std::sort(letters.begin(), letters.end());
    tree.letters = std::move(letters);
    return make(std::move(tree));
}

Language image_language(Language language, Morphism morphism) {
    LanguageTree tree;
    tree.kind = Kind::image;
    tree.parts = {std::move(language)};
    tree.morphism = std::move(morphism);
    return make(std::move(tree));
}

Language inverse_image_language(Language language, Morphism morphism) {
    LanguageTree tree;
    tree.kind = Kind::inverse_image;
    tree.parts = {std::move(language)};
    tree.morphism = std::move(morphism);
    return make(std::move(tree));
}

Language named(Language language, std::string name) {
    LanguageTree tree = *language;
    tree.name = std::move(name);
    return make(std::move(tree));
}

std::vector<Symbol> letters_of(const Language& language) {
    std::set<Symbol> letters;
    add_letters(letters, *language);
    return {letters.begin(), letters.end()};
}

std::string to_string(const Language& language, const Alphabet& alphabet) {
    return text(language, alphabet, sum);
}

std::string complement_text(const std::vector<Symbol>& letters, const Alphabet& alphabet) {
    if (letters.empty()) return {};
    std::vector<std::string> names;
    for (const Symbol letter : letters) names.push_back(alphabet.name(letter));
    std::sort(names.begin(), names.end());
    return (names.size() == 1 ? "~ is over the letter " : "~ is over the letters ") +
           joined(names, ", ") + ".";
}

std::string unnamed_text(const Language& language, const Alphabet& alphabet) {
    return operation_text(*language, alphabet);
}

namespace {

bool take(std::string_view& text, std::string_view token) {
    if (!text.starts_with(token)) return false;
    text.remove_prefix(token.size());
    return true;
}

std::optional<std::size_t> take_number(std::string_view& text) {
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc()) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return number;
}

/// `(1,0)L`, from behind its first bracket.
std::optional<std::pair<std::size_t, std::size_t>> take_context(std::string_view& text) {
    const auto left = take_number(text);
    if (!left || !take(text, ",")) return std::nullopt;
    const auto right = take_number(text);
    if (!right || !take(text, ")L")) return std::nullopt;
    return std::pair{*left, *right};
}

/// The longest left and right contexts, and whether no rule is erasing.
bool has_form(const IL& system, const SystemForm& form) {
    std::size_t left = 0, right = 0;
    bool erasing = false;
    for (const auto& rules : system.rules)
        for (const IL::Rule& rule : rules) {
            left = std::max(left, rule.left.size());
            right = std::max(right, rule.right.size());
            erasing = erasing || rule.successor.empty();
        }
    if (form.propagating && erasing) return false;
    if (form.deterministic && !is_deterministic(system)) return false;
    if (form.one_sided) return left + right <= 1;
    return !form.context || (left <= form.context->first && right <= form.context->second);
}

}  // namespace

std::optional<SystemForm> system_form(std::string_view name) {
    SystemForm form;
    form.extended = take(name, "E");
    form.propagating = take(name, "P");
    form.deterministic = take(name, "D");
    form.tables = take(name, "T");
    if (name == "0L") return form;
    if (form.extended || form.tables) return std::nullopt;
    form.interactive = true;
    if (name == "1L") {
        form.one_sided = true;
    } else if (name == "2L") {
        form.context = {1, 1};
    } else if (take(name, "(")) {
        form.context = take_context(name);
        if (!form.context || !name.empty()) return std::nullopt;
    } else if (name != "IL") {
        return std::nullopt;
    }
    return form;
}

bool has_form(const SourceSystem& system, const SystemForm& form) {
    if (!system.tables) return form.interactive && has_form(*system.interactive, form);
    const ET0L& tables = *system.tables;
    if (tables.tables.size() > 1 && !form.tables) return false;
    if (!has_only_terminals(tables) && !form.extended) return false;
    if (form.deterministic && !is_deterministic(tables)) return false;
    return !form.propagating || is_propagating(tables);
}

}  // namespace algae
