#include <algorithm>
#include <set>
#include <tuple>

#include "system/detail/determinism.hpp"
#include "system/system.hpp"
#include "word/word.hpp"

// From rules as written to the classes of the theory.
//
// An LSystem holds every construct of the notation and interprets none. A theorem holds of a class, so it asks for a
// view: `as_d0l`, `as_ol`, `as_s0l`, `as_et0l`, `as_il` give the class's own type, or the reason, with its place, why
// the system is not of it. Letters without a rule stay as they are; views make that rule explicit. Only accessible letters are
// looked at where a class allows it, since a rule that is never used decides nothing about the language.

namespace algae {

namespace {

bool holds_words(const ModuleWord& word) {
    return !word.splices.empty() ||
           std::any_of(word.arguments.begin(), word.arguments.end(), [](const auto& module) {
               return std::any_of(module.second.begin(), module.second.end(), reads_words);
           });
}

bool holds_words(const Production& rule) {
    return holds_words(rule.successor) || (rule.condition && reads_words(*rule.condition));
}

}  // namespace

bool holds_words(const LSystem& system) {
    const auto held = [](const Production& rule) { return holds_words(rule); };
    return !system.inner.empty() || holds_words(system.axiom) ||
           std::any_of(system.rules.begin(), system.rules.end(), held) ||
           std::any_of(system.interpretation.begin(), system.interpretation.end(), held);
}

bool leaves_tables_open(const LSystem& system) {
    return system.tables.size() > 1 && system.schedule.empty();
}

std::size_t scheduled_table(const LSystem& system, std::uint64_t generation) {
    return system.schedule.empty() ? 0 : system.schedule[generation % system.schedule.size()];
}

std::vector<std::string> schedule_names(const LSystem& system) {
    std::vector<std::string> names;
    for (const std::size_t table : system.schedule) names.push_back(system.tables.at(table));
    return names;
}

const std::vector<EnvironmentKind>& environment_kinds() {
    static const std::vector<EnvironmentKind> kinds{
        {"x", "", {0}},
        {"y", "", {0}},
        {"z", "", {0}},
        {"position", "", {0}},
        {"heading", "", {0}},
        {"clip", "two corners, X Y X Y or X Y Z X Y Z", {4, 6}},
        {"collision", "a radius", {1}},
        {"light", "a radius", {1}},
        {"external", "", {0}}};
    return kinds;
}

bool is_communication(std::string_view name) { return name.size() > 1 && name[0] == '?'; }

bool LSystem::operator==(const LSystem& other) const {
    return title == other.title && source == other.source && identifiers == other.identifiers &&
           alphabet == other.alphabet && declared == other.declared &&
           constants == other.constants && inner == other.inner && axiom == other.axiom &&
           rules == other.rules && tables == other.tables && schedule == other.schedule &&
           ignored == other.ignored && terminals == other.terminals &&
           interpretation == other.interpretation && environments == other.environments;
}

namespace {

bool has_parameters(const Pattern& pattern) {
    return std::any_of(pattern.begin(), pattern.end(),
                       [](const ModulePattern& m) { return !m.parameters.empty(); });
}

/// The modules of a context; brackets only say where they stand.
std::size_t context_length(const Pattern& context, const Alphabet& alphabet) {
    return static_cast<std::size_t>(
        std::count_if(context.begin(), context.end(), [&](const ModulePattern& module) {
            const std::string& name = alphabet.name(module.symbol);
            return name != "[" && name != "]";
        }));
}

Word letters(const Pattern& pattern) {
    Word word;
    for (const ModulePattern& module : pattern) word.push_back(module.symbol);
    return word;
}

}  // namespace

Class class_of(const LSystem& system) {
    Class kind;
    kind.tables = system.tables.size();
    kind.extended = !system.terminals.empty();
    kind.bracketed = system.alphabet.find("[") && system.alphabet.find("]");
    kind.parametric = !system.axiom.arguments.empty();
    kind.deterministic = first_overlaps(system, 1).empty();
    for (Symbol a = 0; a < system.alphabet.size(); ++a) {
        kind.open = kind.open || is_communication(system.alphabet.name(a));
    }
    for (const Production& rule : system.rules) {
        kind.propagating = kind.propagating && (rule.shape || !rule.successor.letters.empty());
        kind.stochastic = kind.stochastic || rule.probability;
        kind.parametric = kind.parametric || rule.condition ||
                          !rule.predecessor.parameters.empty() ||
                          !rule.successor.arguments.empty() || has_parameters(rule.left) ||
                          has_parameters(rule.right);
        kind.shape = kind.shape || rule.shape;
        kind.conditional = kind.conditional || !rule.elsewhere.empty();
        kind.context.first =
            std::max(kind.context.first, context_length(rule.left, system.alphabet));
        kind.context.second =
            std::max(kind.context.second, context_length(rule.right, system.alphabet));
    }
    kind.nested = holds_words(system);
    kind.parametric = kind.parametric || kind.nested;
    if (kind.stochastic) kind.deterministic = false;
    return kind;
}

std::string Class::name() const {
    std::string name;
    if (open) name += "open ";
    if (parametric) name += "parametric ";
    if (shape) name += "shape ";
    if (extended) name += 'E';
    if (propagating) name += 'P';
    if (deterministic) name += 'D';
    if (stochastic) name += 'S';
    if (tables > 0) name += 'T';
    name += context == std::pair<std::size_t, std::size_t>{0, 0}
                ? "0L"
                : '(' + std::to_string(context.first) + ',' + std::to_string(context.second) + ")L";
    if (conditional) name += " with context conditions";
    if (nested) name += conditional ? " and systems within" : " with systems within";
    return name;
}

namespace {

std::string at(const Place& place) {
    return place.line == 0 ? std::string("a rule") : "the rule at " + to_string(place);
}

/// Why a rule is not one of plain letters, in whatever context: the first construct that goes beyond. `probabilities`
/// says whether those below 1 do.
std::string beyond_letters(const Production& rule, bool probabilities) {
    if (!rule.elsewhere.empty()) return at(rule.place) + " has a context condition";
    if (rule.condition) return at(rule.place) + " has a condition";
    if (!rule.predecessor.parameters.empty() || !rule.successor.arguments.empty() ||
        has_parameters(rule.left) || has_parameters(rule.right))
        return at(rule.place) + " has parameters";
    if (!rule.successor.splices.empty()) return at(rule.place) + " splices a word in";
    if (rule.shape) return at(rule.place) + " is a shape rule";
    if (probabilities && rule.probability && *rule.probability != Rational(1))
        return at(rule.place) + " has a probability";
    return {};
}

/// The same of a system with one table and no terminals; `beyond_rule` says it of a rule.
template <class BeyondRule>
std::string beyond_letters(const LSystem& system, BeyondRule beyond_rule) {
    if (!system.inner.empty()) return "there are systems within it";
    if (!system.axiom.arguments.empty()) return "the axiom has parameters";
    if (!system.axiom.splices.empty()) return "the axiom has a word spliced in";
    if (!system.tables.empty()) return "it has tables";
    if (!system.terminals.empty()) return "it has terminals";
    for (const Production& rule : system.rules)
        if (std::string reason = beyond_rule(rule); !reason.empty()) return reason;
    return {};
}

/// A system of a class, with what all classes have of the one as written.
template <class T>
T begun(const LSystem& written) {
    T system;
    system.alphabet = std::make_shared<const Alphabet>(written.alphabet);
    system.axiom = written.axiom.letters;
    system.name = written.name;
    return system;
}

/// Each table gets the identity for letters that have no successor in it.
void complete(Table& table, std::size_t letters) {
    table.resize(letters);
    for (Symbol a = 0; a < letters; ++a)
        if (table[a].empty()) table[a].push_back(Word{a});
}

void add_rule(Table& table, const Production& rule) {
    auto& choices = table[rule.predecessor.symbol];
    if (std::find(choices.begin(), choices.end(), rule.successor.letters) == choices.end())
        choices.push_back(rule.successor.letters);
}

/// A system as written, with one character a letter.
LSystem written(const std::string& axiom,
                const std::vector<std::vector<std::pair<char, std::string>>>& tables,
                const std::string& terminals = "") {
    LSystem system;
    const auto word = [&](const std::string& text) {
        Word letters;
        for (const char c : text) letters.push_back(system.alphabet.symbol(std::string(1, c)));
        return letters;
    };
    system.axiom.letters = word(axiom);
    for (std::size_t t = 0; t < tables.size(); ++t) {
        if (tables.size() > 1) system.tables.push_back(std::to_string(t + 1));
        for (const auto& [a, successor] : tables[t]) {
            Production rule;
            rule.predecessor.symbol = word(std::string(1, a)).front();
            rule.successor.letters = word(successor);
            rule.table = t;
            system.rules.push_back(std::move(rule));
        }
    }
    system.terminals = word(terminals);
    return system;
}

/// The brackets, if every word of the system is made of matching ones because no rule rewrites
/// them and every successor matches its own.
std::optional<Brackets> lasting_brackets(const D0L& system) {
    const auto brackets = brackets_of(*system.alphabet);
    if (!brackets || !brackets_match(system.axiom, *brackets)) return std::nullopt;
    for (const Symbol a : system.letters) {
        const Word& successor = system.successor(a);
        if (a == brackets->open || a == brackets->close) {
            if (successor != Word{a}) return std::nullopt;
        } else if (!brackets_match(successor, *brackets)) {
            return std::nullopt;
        }
    }
    return brackets;
}

}  // namespace

std::string beyond_ol(const LSystem& system, bool probabilities) {
    std::string reason = beyond_letters(system, [&](const Production& rule) {
        return rule.left.empty() && rule.right.empty() ? beyond_letters(rule, probabilities)
                                                       : at(rule.place) + " has a context";
    });
    if (!reason.empty()) return reason;
    const bool asks =
        std::any_of(system.axiom.letters.begin(), system.axiom.letters.end(),
                    [&](Symbol a) { return is_communication(system.alphabet.name(a)); });
    return asks ? "the axiom has a communication module" : "";
}

View<OL> as_ol(const LSystem& system) {
    if (std::string reason = beyond_ol(system); !reason.empty())
        return View<OL>::refused("not an 0L system: " + reason);
    OL ol = begun<OL>(system);
    ol.successors.resize(ol.alphabet->size());
    for (const Production& rule : system.rules) add_rule(ol.successors, rule);
    complete(ol.successors, ol.alphabet->size());
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
    D0L system{
        std::move(alphabet), std::move(axiom), Morphism(std::move(images)), {}, std::move(name)};
    system.letters = accessible(system.axiom, system.rules.size(),
                                [&](Symbol a, auto see) { see(system.rules[a]); });
    system.brackets = lasting_brackets(system);
    return system;
}

D0L d0l(const std::string& axiom, const std::vector<std::pair<char, std::string>>& productions) {
    return *as_d0l(written(axiom, {productions}));
}

OL ol(const std::string& axiom, const std::vector<std::pair<char, std::string>>& productions) {
    return *as_ol(written(axiom, {productions}));
}

bool is_propagating(const D0L& system) {
    return std::none_of(system.letters.begin(), system.letters.end(),
                        [&](Symbol a) { return system.rules[a].empty(); });
}

bool is_propagating(const OL& system) {
    return std::none_of(system.letters.begin(), system.letters.end(), [&](Symbol a) {
        const auto& choices = system.successors[a];
        return std::any_of(choices.begin(), choices.end(), [](const Word& w) { return w.empty(); });
    });
}

View<S0L> as_s0l(const LSystem& system) {
    const auto refused = [](const std::string& reason) {
        return View<S0L>::refused("not a stochastic 0L system: " + reason);
    };
    if (std::string reason = beyond_ol(system, false); !reason.empty()) return refused(reason);
    S0L out = begun<S0L>(system);
    out.alternatives.resize(out.alphabet->size());
    for (const Production& rule : system.rules) {
        auto& known = out.alternatives[rule.predecessor.symbol];
        if (!rule.probability && !known.empty()) {
            if (known.size() == 1 && known.front().first == rule.successor.letters) continue;
            return refused(system.alphabet.name(rule.predecessor.symbol) +
                           " has several rules without probabilities");
        }
        known.emplace_back(rule.successor.letters, rule.probability.value_or(Rational(1)));
    }
    for (Symbol a = 0; a < out.alternatives.size(); ++a) {
        auto& known = out.alternatives[a];
        if (known.empty()) known.emplace_back(Word{a}, Rational(1));
        Rational sum;
        for (const auto& [word, probability] : known) sum += probability;
        if (sum != 1)
            return refused("the probabilities of " + system.alphabet.name(a) + " add up to " +
                           to_string(sum) + ", expected 1");
    }
    return out;
}

namespace {

/// Whether the successors of every accessible letter in every table are as `holds` says.
template <class Holds>
bool for_all_accessible(const ET0L& system, Holds holds) {
    const std::vector<Symbol> letters = accessible_letters(system);
    return std::all_of(letters.begin(), letters.end(), [&](Symbol a) {
        return std::all_of(system.tables.begin(), system.tables.end(),
                           [&](const Table& table) { return holds(table[a]); });
    });
}

}  // namespace

View<ET0L> as_et0l(const LSystem& written) {
    LSystem plain = written;  // what else goes beyond 0L is looked for without these two
    plain.tables.clear();
    plain.schedule.clear();
    plain.terminals.clear();
    if (std::string reason = beyond_ol(plain); !reason.empty())
        return View<ET0L>::refused("not an ET0L system: " + reason);
    ET0L system = begun<ET0L>(written);
    system.table_names = written.tables;
    if (system.table_names.empty()) system.table_names.emplace_back();
    const std::size_t letters = system.alphabet->size();
    system.tables.assign(system.table_names.size(), Table(letters));
    for (const Production& rule : written.rules) add_rule(system.tables.at(rule.table), rule);
    for (Table& table : system.tables) complete(table, letters);
    system.terminal.assign(letters, written.terminals.empty());
    for (const Symbol a : written.terminals) system.terminal[a] = 1;
    return system;
}

ET0L as_et0l(const OL& system) {
    return {system.alphabet,     system.axiom,
            {system.successors}, std::vector<char>(system.successors.size(), 1),
            {std::string()},     system.name};
}

bool has_only_terminals(const ET0L& system) {
    const std::vector<Symbol> letters = accessible_letters(system);
    return std::all_of(letters.begin(), letters.end(),
                       [&](Symbol a) { return system.terminal[a] != 0; });
}

bool is_deterministic(const ET0L& system) {
    return for_all_accessible(system,
                              [](const std::vector<Word>& choices) { return choices.size() == 1; });
}

bool is_propagating(const ET0L& system) {
    return for_all_accessible(system, [](const std::vector<Word>& choices) {
        return std::none_of(choices.begin(), choices.end(),
                            [](const Word& word) { return word.empty(); });
    });
}

std::vector<Symbol> accessible_letters(const ET0L& system) {
    return accessible(system.axiom, system.terminal.size(), [&](Symbol a, auto see) {
        for (const Table& table : system.tables)
            for (const Word& successor : table[a]) see(successor);
    });
}

std::string family_name(const ET0L& system) {
    std::string name;
    if (!has_only_terminals(system)) name += 'E';
    if (is_propagating(system)) name += 'P';
    if (is_deterministic(system)) name += 'D';
    if (system.tables.size() > 1) name += 'T';
    return name + "0L";
}

ET0L over(const ET0L& system, std::shared_ptr<const Alphabet> alphabet) {
    const std::vector<Symbol> letters = renaming(*system.alphabet, *alphabet);
    ET0L moved{alphabet,
               replaced(system.axiom, letters),
               {},
               std::vector<char>(alphabet->size(), 0),
               system.table_names,
               system.name};
    for (const Table& table : system.tables) {
        Table& target = moved.tables.emplace_back(alphabet->size());
        for (Symbol a = 0; a < table.size(); ++a)
            for (const Word& successor : table[a])
                target[letters[a]].push_back(replaced(successor, letters));
        complete(target, alphabet->size());
    }
    for (Symbol a = 0; a < letters.size(); ++a) moved.terminal[letters[a]] = system.terminal[a];
    return moved;
}

ET0L et0l(const std::string& axiom,
          const std::vector<std::vector<std::pair<char, std::string>>>& tables,
          const std::string& terminals) {
    return *as_et0l(written(axiom, tables, terminals));
}

namespace {

/// The brackets that make trees of words: none where both are ignored.
std::optional<Brackets> fences(const LSystem& system) {
    const std::optional<Brackets> brackets = brackets_of(system.alphabet);
    if (!brackets) return std::nullopt;
    const auto is_ignored = [&](Symbol a) {
        return std::find(system.ignored.begin(), system.ignored.end(), a) != system.ignored.end();
    };
    return is_ignored(brackets->open) && is_ignored(brackets->close) ? std::nullopt : brackets;
}

/// Why the brackets cannot be those of trees, or nothing.
std::string beyond_trees(const LSystem& system, const Brackets& brackets) {
    for (const Symbol a : system.ignored)
        if (a == brackets.open || a == brackets.close)
            return "it ignores one bracket and not the other";
    for (const Production& rule : system.rules) {
        for (const ModulePattern& module : rule.left)
            if (module.symbol == brackets.open || module.symbol == brackets.close)
                return at(rule.place) +
                       " has a bracket in its left context, which is a path and has no branches";
        std::size_t depth = 0;
        for (const ModulePattern& module : rule.right) {
            if (module.symbol == brackets.open) ++depth;
            if (module.symbol == brackets.close && depth-- == 0)
                return at(rule.place) + " has an unmatched ']' in its right context";
        }
        if (depth > 0) return at(rule.place) + " has an unmatched '[' in its right context";
    }
    return {};
}

std::size_t letters_in(const IL::Rule& rule, const std::optional<Brackets>& brackets) {
    std::size_t count = rule.left.size() + rule.right.size();
    if (brackets)
        for (const Symbol a : rule.right) count -= a == brackets->open || a == brackets->close;
    return count;
}

bool has_same_contexts(const IL::Rule& one, const IL::Rule& other) {
    return one.left == other.left && one.right == other.right;
}

bool has_choice(const std::vector<IL::Rule>& rules) {
    return std::adjacent_find(rules.begin(), rules.end(), has_same_contexts) != rules.end();
}

}  // namespace

View<IL> as_il(const LSystem& system) {
    const auto refused = [](const std::string& reason) {
        return View<IL>::refused("not an IL system: " + reason);
    };
    const std::string reason =
        beyond_letters(system, [](const Production& rule) { return beyond_letters(rule, true); });
    if (!reason.empty()) return refused(reason);
    IL il = begun<IL>(system);
    il.brackets = fences(system);
    if (il.brackets)
        if (const std::string why = beyond_trees(system, *il.brackets); !why.empty())
            return refused(why);
    il.rules.resize(il.alphabet->size());
    il.ignored.assign(il.alphabet->size(), 0);
    for (const Symbol a : system.ignored) il.ignored[a] = 1;
    for (const Production& rule : system.rules) {
        auto& known = il.rules[rule.predecessor.symbol];
        IL::Rule fresh{letters(rule.left), letters(rule.right), rule.successor.letters};
        auto place = known.end();  // behind the rules with the same contexts
        bool is_new = true;
        for (auto other = known.begin(); other != known.end(); ++other) {
            if (!has_same_contexts(*other, fresh)) continue;
            place = other + 1;
            is_new = is_new && other->successor != fresh.successor;
        }
        if (is_new) known.insert(place, std::move(fresh));
    }
    for (auto& known : il.rules)
        std::stable_sort(known.begin(), known.end(),
                         [&](const IL::Rule& left, const IL::Rule& right) {
                             return letters_in(left, il.brackets) > letters_in(right, il.brackets);
                         });
    return il;
}

View<IL> as_dil(const LSystem& system) {
    const View<IL> view = as_il(system);
    const auto refused = [](const std::string& reason) {
        return View<IL>::refused("not a deterministic IL system: " + reason);
    };
    const std::string other = "not an IL system: ";
    if (!view) return refused(view.reason().substr(other.size()));
    for (Symbol a = 0; a < view->rules.size(); ++a)
        if (has_choice(view->rules[a]))
            return refused(system.alphabet.name(a) + " has two rules with the same contexts");
    return view;
}

bool is_deterministic(const IL& system) {
    return std::none_of(system.rules.begin(), system.rules.end(),
                        [](const auto& rules) { return has_choice(rules); });
}

bool is_propagating(const IL& system) {
    return std::all_of(system.rules.begin(), system.rules.end(), [](const auto& rules) {
        return std::none_of(rules.begin(), rules.end(),
                            [](const IL::Rule& rule) { return rule.successor.empty(); });
    });
}

IL il(const std::string& axiom, const std::vector<std::string>& rules) {
    LSystem system;
    const auto word = [&](std::string text) {
        std::erase(text, ' ');
        Word letters;
        for (const char c : text) letters.push_back(system.alphabet.symbol(std::string(1, c)));
        return letters;
    };
    const auto pattern = [&](const std::string& text) {
        Pattern modules;
        for (const Symbol a : word(text)) modules.push_back({a, {}});
        return modules;
    };
    system.axiom.letters = word(axiom);
    for (const std::string& rule : rules) {
        const std::size_t arrow = rule.find("->");
        if (arrow == std::string::npos) throw Error("expected '->' in the rule '" + rule + "'");
        std::string middle = rule.substr(0, arrow);
        Production production;
        if (const std::size_t mark = middle.find('<'); mark != std::string::npos) {
            production.left = pattern(middle.substr(0, mark));
            middle.erase(0, mark + 1);
        }
        if (const std::size_t mark = middle.find('>'); mark != std::string::npos) {
            production.right = pattern(middle.substr(mark + 1));
            middle.erase(mark);
        }
        const Word letter = word(middle);
        if (letter.size() != 1)
            throw Error("expected one letter before '->' in the rule '" + rule + "'");
        production.predecessor.symbol = letter.front();
        production.successor.letters = word(rule.substr(arrow + 2));
        system.rules.push_back(std::move(production));
    }
    return *as_il(system);
}

IL over(const IL& system, std::shared_ptr<const Alphabet> alphabet) {
    const std::vector<Symbol> letters = renaming(*system.alphabet, *alphabet);
    IL moved{alphabet,
             replaced(system.axiom, letters),
             {},
             std::vector<char>(alphabet->size(), 0),
             system.name};
    if (system.brackets)
        moved.brackets = Brackets{letters[system.brackets->open], letters[system.brackets->close]};
    moved.rules.resize(alphabet->size());
    for (Symbol a = 0; a < letters.size(); ++a) {
        moved.ignored[letters[a]] = system.ignored[a];
        for (const IL::Rule& rule : system.rules[a])
            moved.rules[letters[a]].push_back({replaced(rule.left, letters),
                                               replaced(rule.right, letters),
                                               replaced(rule.successor, letters)});
    }
    return moved;
}

}  // namespace algae
