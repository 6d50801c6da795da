#include <algorithm>

#include "system/accessible.hpp"
#include "system/d0l.hpp"
#include "system/ol.hpp"

namespace algae {

namespace {

std::string at(const Place& place) {
    return place.line == 0 ? std::string("a rule") : "the rule at " + to_string(place);
}

std::string beyond_ol(const Production& rule, bool probabilities) {
    if (!rule.left.empty() || !rule.right.empty()) return at(rule.place) + " has a context";
    if (!rule.elsewhere.empty()) return at(rule.place) + " has a context condition";
    if (rule.condition) return at(rule.place) + " has a condition";
    if (!rule.predecessor.parameters.empty() || !rule.successor.arguments.empty())
        return at(rule.place) + " has parameters";
    if (!rule.successor.splices.empty()) return at(rule.place) + " splices a word in";
    if (rule.shape) return at(rule.place) + " is a shape rule";
    if (probabilities && rule.probability && *rule.probability != Rational(1))
        return at(rule.place) + " has a probability";
    return {};
}

bool is_balanced(const Word& word, const Brackets& brackets) {
    std::size_t depth = 0;
    for (const Symbol a : word) {
        if (a == brackets.open) ++depth;
        if (a == brackets.close && depth-- == 0) return false;
    }
    return depth == 0;
}

/// The brackets, if every word of the system is made of matching ones because no rule rewrites
/// them and every successor matches its own.
std::optional<Brackets> lasting_brackets(const D0L& system) {
    const auto brackets = brackets_of(*system.alphabet);
    if (!brackets || !is_balanced(system.axiom, *brackets)) return std::nullopt;
    for (const Symbol a : system.letters) {
        const Word& successor = system.successor(a);
        if (a == brackets->open || a == brackets->close) {
            if (successor != Word{a}) return std::nullopt;
        } else if (!is_balanced(successor, *brackets)) {
            return std::nullopt;
        }
    }
    return brackets;
}

}  // namespace

std::string beyond_ol(const LSystem& system, bool probabilities) {
    if (!system.inner.empty()) return "there are systems within it";
    if (!system.axiom.arguments.empty()) return "the axiom has parameters";
    if (!system.axiom.splices.empty()) return "the axiom has a word spliced in";
    if (!system.tables.empty()) return "it has tables";
    if (!system.terminals.empty()) return "it has terminals";
    for (const Production& rule : system.rules)
        if (std::string reason = beyond_ol(rule, probabilities); !reason.empty()) return reason;
    for (const Symbol a : system.axiom.letters)
        if (system.alphabet.name(a).size() > 1 && system.alphabet.name(a)[0] == '?')
            return "the axiom has a communication module";
    return {};
}

View<OL> as_ol(const LSystem& system) {
    if (std::string reason = beyond_ol(system); !reason.empty())
        return View<OL>::refused("not an 0L system: " + reason);
    OL ol;
    ol.alphabet = std::make_shared<const Alphabet>(system.alphabet);
    ol.axiom = system.axiom.letters;
    ol.name = system.name;
    ol.successors.resize(ol.alphabet->size());
    for (const Production& rule : system.rules) {
        auto& choices = ol.successors[rule.predecessor.symbol];
        if (std::find(choices.begin(), choices.end(), rule.successor.letters) == choices.end())
            choices.push_back(rule.successor.letters);
    }
    for (Symbol a = 0; a < ol.successors.size(); ++a)
        if (ol.successors[a].empty()) ol.successors[a].push_back(Word{a});
    ol.letters = accessible(ol.axiom, ol.alphabet->size(), [&](Symbol a, auto see) {
        for (const Word& successor : ol.successors[a]) see(successor);
    });
    return ol;
}

View<D0L> as_d0l(const LSystem& system) {
    const View<OL> ol = as_ol(system);
    if (!ol) return View<D0L>::refused("not a D0L system: " + ol.reason().substr(18));
    std::vector<Word> images;
    images.reserve(ol->successors.size());
    for (Symbol a = 0; a < ol->successors.size(); ++a) {
        if (ol->successors[a].size() > 1)
            return View<D0L>::refused("not a D0L system: " + system.alphabet.name(a) + " has " +
                                      std::to_string(ol->successors[a].size()) + " rules");
        images.push_back(ol->successors[a].front());
    }
    return make_d0l(ol->alphabet, ol->axiom, std::move(images), system.name);
}

D0L make_d0l(std::shared_ptr<const Alphabet> alphabet, Word axiom, std::vector<Word> images,
             std::string name) {
    D0L system{std::move(alphabet), std::move(axiom), {}, {}, std::move(name)};
    system.rules = Morphism{Words{}, std::move(images)};
    system.letters = accessible(system.axiom, system.rules.images.size(),
                                [&](Symbol a, auto see) { see(system.rules.images[a]); });
    system.rules.brackets = lasting_brackets(system);
    return system;
}

D0L d0l(const std::string& axiom, const std::vector<std::pair<char, std::string>>& productions) {
    Alphabet alphabet;
    const auto word = [&](const std::string& text) {
        Word letters;
        for (const char c : text) letters.push_back(alphabet.symbol(std::string(1, c)));
        return letters;
    };
    Word start = word(axiom);
    std::vector<std::pair<Symbol, Word>> rules;
    for (const auto& [a, successor] : productions) {
        const Symbol predecessor = word(std::string(1, a)).front();
        rules.emplace_back(predecessor, word(successor));
    }
    std::vector<Word> images(alphabet.size());
    for (Symbol a = 0; a < images.size(); ++a) images[a] = {a};
    for (auto& [a, successor] : rules) images[a] = std::move(successor);
    return make_d0l(std::make_shared<const Alphabet>(std::move(alphabet)), std::move(start), std::move(images));
}

OL ol(const std::string& axiom, const std::vector<std::pair<char, std::string>>& productions) {
    LSystem system;
    const auto word = [&](const std::string& text) {
        Word letters;
        for (const char c : text) letters.push_back(system.alphabet.symbol(std::string(1, c)));
        return letters;
    };
    system.axiom.letters = word(axiom);
    for (const auto& [a, successor] : productions) {
        Production rule;
        rule.predecessor.symbol = word(std::string(1, a)).front();
        rule.successor.letters = word(successor);
        system.rules.push_back(std::move(rule));
    }
    return *as_ol(system);
}

bool is_propagating(const D0L& system) {
    return std::none_of(system.letters.begin(), system.letters.end(),
                        [&](Symbol a) { return system.rules.images[a].empty(); });
}

bool is_propagating(const OL& system) {
    return std::none_of(system.letters.begin(), system.letters.end(), [&](Symbol a) {
        const auto& choices = system.successors[a];
        return std::any_of(choices.begin(), choices.end(), [](const Word& w) { return w.empty(); });
    });
}

}  // namespace algae
