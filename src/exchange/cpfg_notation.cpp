#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "exchange/detail/cpfg.hpp"
#include "exchange/detail/plain_rules.hpp"
#include "exchange/detail/scanner.hpp"
#include "model/model.hpp"

// What a system of cpfg, L-Py or lpfg is in the notation: a text of it, with each expression in brackets as the program groups it.
//
// Meanings differ, and each difference is either said in the notation or refused. cpfg tries the rules of a module in the order of the file
// and takes the first that applies; the notation takes the one with the longest contexts. So a rule behind another with the same contexts, or
// with none, gets the negation of the earlier condition, one that can never be reached is left out, and other rules with longer contexts
// behind shorter ones are refused. A decomposition, which rewrites what a rule gives within the same step, is put into the successors. A branch
// in a right context, `A > [B]C`, is the whole branch there and the beginning of one in the notation: it is read where no other
// letter can follow in it. `[B=]C` is the beginning. Commands of several symbols, `@v`, are one symbol each, by which a rule for a part of
// the last of them is one for the command too. With `seed:` all rules that apply take part with their weights: those of one module must have the
// same contexts here. A block of `produce`, `if` and `else` is a rule with conditions for each `produce`, in this order. The turtle looks up the page, `+` turns to the left, by 45 degrees where no view file says otherwise, in L-Py by 60.
// cpfg's `/` rolls the other way than that of the notation, where it is `\`; that of L-Py is the same. In expressions of cpfg `^` groups
// from the left and a sign binds tighter than it, so -2^2 is 4; parameters are numbers of 32 bits there, which nothing here imitates.

namespace algae {

namespace {

class Notation : CpfgReader {
public:
    Notation(const Source& source, const CpfgDialect& dialect, CpfgSystem system)
        : CpfgReader(source, dialect, std::move(system)) {}

    Model model() {
        if (system_.axiom.text.empty())
            fail(0, std::string("expected a line `Axiom: ") + (dialect_.plus ? "F(1);" : "F") +
                        "`, found none");
        return read_written(notation(), source_.file());
    }

private:
    std::string notation() {
        std::string text;
        std::set<std::string> names;
        system_ = with_assigned(std::move(system_));
        for (const auto& [called, value] : system_.constants) {
            constants_ += "let " + called + " = " +
                          expression(value, {}, system_.integers.contains(called)) + "\n";
            known_.emplace(called, called);
        }
        if (!dialect_.python && !dialect_.plus)
            known_.emplace("Z", system_.generation.empty() ? "0" : system_.generation);
        check_ring();
        rewrites_cut_ = std::ranges::any_of(
            system_.rules, [](const CpfgRule& rule) { return rule.predecessor.symbol == "%"; });
        system_ = with_single_predecessors(source_, dialect_, std::move(system_));
        add_decompositions();
        for (const std::string& name : system_.kept) known_[name] = "";
        name_steps();
        join_ends();
        name_steps();  // of letters for ends too
        mark_cuts();
        mark_branches();
        check_first_branches();
        pad_rules();
        std::string axiom = axiom_word();
        std::string rules = rule_lines();
        if (!counted_.empty()) {
            axiom = std::string(counter) + "(1) " + axiom;
            rules += std::string(counter) + "(n) -> " + counter + "(n + 1)\n";
        }
        if (!padded_.empty()) axiom = std::string(weight_of_rules) + " " + axiom;
        if (met_.contains(coming_cut)) rules += std::string(coming_cut) + " -> %\n";
        std::string interpret;
        std::set<std::string> interpreted;
        const auto kind = [&](const CpfgModule& module) {
            return name(module) + "/" + std::to_string(module.arguments.size());
        };
        for (const CpfgRule& rule : system_.interpretation)
            interpreted.insert(kind(rule.predecessor));
        for (const CpfgRule& rule : system_.interpretation) {
            if (system_.drawn_depth == 0) continue;
            if (!rule.left.empty() || !rule.right.empty() || rule.weight)
                refuse(rule.place, "a homomorphism with contexts or weights",
                       "has no meaning in the notation");
            const std::set<std::string> own = formals(rule);
            if (reads_step(rule.condition ? *rule.condition : Placed{}, own) ||
                reads_step(modules(rule.successor), own))
                refuse(rule.place, "Q in a homomorphism",
                       "is the number of the step, which only rules know in the notation");
            std::vector<CpfgModule> image =
                drawn(modules(rule.successor), system_.drawn_depth, interpreted, own);
            interpret += "interpret " +
                         head(rule, rule.condition ? expression(*rule.condition, own) : "", "") +
                         " -> " + written(image, own) + "\n";
        }
        if (met_.contains(coming_cut))
            interpret += std::string("interpret ") + coming_cut + " -> %\n";
        check_cuts();
        check_moves();
        check_commands();
        interpret += own_meanings(interpreted);
        // Where @v asks for what is level, the turtle must look along z.
        if (met_.contains("@v")) {
            axiom = std::string(cpfg_upward) + " " + axiom;
            interpret += std::string("interpret ") + cpfg_upward + " -> ^(90)\n";
        } else if (!dialect_.python && std::ranges::any_of(met_, [](const std::string& symbol) {
                       return symbol == "&" || symbol == "^" || symbol == "/" || symbol == "\\";
                   })) {
            interpret += "camera -90 90\n";  // the page, as the program shows it
        }
        std::vector<std::string> longer;
        for (const std::string& symbol : met_)
            if (undeclared_length(symbol) != symbol.size()) longer.push_back(symbol);
        if (!longer.empty()) text += "alphabet " + joined(longer, " ") + "\n";
        text += constants_ + "axiom " + axiom + "\n" + rules;
        if (system_.ignored) text += ignored_line(modules(*system_.ignored));
        if (system_.considered) text += considered_line();
        text += interpret;
        text += "angle " + std::to_string(static_cast<int>(dialect_.angle)) + "\nstart 0 0 90\n";
        if (!system_.generation.empty()) text += "generation " + system_.generation + "\n";
        return text;
    }

    /// The axiom, where no step was made.
    std::string axiom_word() {
        const CpfgNames known = known_;
        if (!step_.empty()) known_["Q"] = "0";
        std::vector<CpfgModule> all = ended(modules(system_.axiom));
        if (joins_ends_) {
            CpfgModule first = end_letter(all, CpfgRule::Part::first, *system_.ring),
                       last = end_letter(all, CpfgRule::Part::last, *system_.ring);
            all.insert(all.begin(), std::move(first));
            all.push_back(std::move(last));
        }
        std::string word = written(all, {});
        known_ = known;
        return word;
    }

    /// The symbol's name there.
    std::string name(const CpfgModule& module) const {
        const std::string& symbol = module.symbol;
        if (dialect_.plus && std::ranges::count(system_.modules, symbol) > 0) return symbol;
        if (symbol == gone_from_here) return "%";
        if (symbol.size() > 1)
            return std::string_view("@~?").find(symbol[0]) == std::string_view::npos
                       ? symbol
                       : command(module);
        const char c = symbol[0];
        if (!dialect_.python && c == '/') return "\\";
        if (!dialect_.python && c == '\\') return "/";
        if (c == '_' || (c == '#' && dialect_.python))
            refuse(module.place, "the symbol " + symbol,
                   dialect_.python ? "makes lines wider by what its editor says"
                                   : "goes by the older tropism, which turns by an arc sine");
        if (c == '@' || c == '?' || c == '~')
            refuse(module.place, "the symbol " + symbol, "stands before no symbol");
        if (c == '%' && (rewrites_cut_ || !module.arguments.empty())) return "X_37";
        if (c == '%' && !cut_) cut_ = module.place;
        if (c == '%' && cuts_later_) return coming_cut;
        if (c == 'g' && !move_) move_ = module.place;
        if (c == '{' && !polygon_) polygon_ = module.place;
        if (!module.arguments.empty() && (c == '{' || c == '}' || c == '.'))
            refuse(module.place, "the symbol " + symbol + " with a number",
                   "belongs to generalized cylinders, which have no meaning in the notation");
        if (c == '=' || c == ':' || c == '<' || c == '>')
            fail(module.place, "expected a symbol, found '" + symbol + "'");
        // What the notation has no symbols like, or others that look alike.
        if (std::string_view(";,#$'\"").find(c) != std::string_view::npos)
            return "X_" + std::to_string(static_cast<int>(c));
        return symbol;
    }

    /// A command of several symbols, as the notation calls it.
    std::string command(const CpfgModule& module) const {
        const std::string& symbol = module.symbol;
        if (symbol[0] == '~') return symbol;
        if (symbol == "@v" || (symbol == "?P" && !module.arguments.empty())) return symbol;
        if (symbol == "?H" && module.arguments.size() == 3) return symbol;
        if ((symbol == "@c" || symbol == "@O") && module.has_arguments) return symbol;
        if (symbol == "@c" || symbol == "@O")
            refuse(module.place, symbol + " without a size", "goes by the view file");
        // Generalized cylinders are drawn as their axes; what follows @G otherwise means nothing there.
        if (symbol.size() == 3 && symbol.starts_with("@G") && symbol[2] != 't' && symbol[2] != 'r')
            return symbol;
        // What the surfaces of generalized cylinders look like, and how many sides they have.
        if (symbol == "@#") return "@contour";
        if (symbol == "@!") return "@sides";
        // A texture; and what only @Tp would read, which is refused.
        if (symbol == "@Tx" || symbol == "@Tf") return symbol;
        if (symbol == "@Ti" || symbol == "@Td" || symbol == "@Ts") return elasticity(module);
        refuse(module.place, "the command " + symbol, "has no meaning in the notation");
    }

    /// A command that changes the elasticity of a tropism of the view file. Without a number it does nothing.
    std::string elasticity(const CpfgModule& module) const {
        const std::string& symbol = module.symbol;
        if (module.arguments.empty()) return symbol;
        const std::string which = module.arguments[0].trimmed().text;
        if (which.size() != 1 || which < "1" || which > "9")
            refuse(module.place, symbol + " of a tropism that a number tells, " + which,
                   "has no meaning in the notation: expected " + symbol + "(1,0.1)");
        if (symbol != "@Ts" && module.arguments.size() == 1)
            refuse(module.place, symbol + " without an amount",
                   "goes by the step S: of the view file; say the amount, " + symbol + "(" + which +
                       ",0.1)");
        tropisms_.insert(which);
        return symbol;
    }

    /// Their meaning, for each tropism that they change; the view file says which of them bends.
    std::string elasticities() const {
        static const std::vector<std::array<const char*, 3>> all{{"@Ts/1", "(i)", "(0)"},
                                                                 {"@Ts/2", "(i,x)", "(x)"},
                                                                 {"@Ti/2", "(i,x)", "(1,x)"},
                                                                 {"@Td/2", "(i,x)", "(1,-x)"}};
        std::string text;
        for (const std::string& which : tropisms_) {
            const std::string letter = cpfg_elastic + which;
            text += (text.empty() ? "elasticity " : " ") + letter;
        }
        if (!text.empty()) text += "\n";
        for (const auto& [kind, parameters, image] : all)
            for (const std::string& which : tropisms_)
                if (met_kinds_.contains(kind))
                    text += "interpret " + std::string(kind, 3) + parameters + " : i = " + which +
                            " -> " + cpfg_elastic + which + image + "\n";
        return text;
    }

    /// What the turtle does with symbols of the file that the notation takes otherwise, for those that occur.
    std::string own_meanings(const std::set<std::string>& interpreted) const {
        // By the symbol and the number of parameters.
        static const std::vector<std::pair<std::string, std::string>> all{
            {"X_59/0", "'"}, {"X_59/1", "'(x)"}, {"X_44/1", "'(x)"}, {"X_35/1", "!(x)"},
            {"@v/0", "$"},   {"g/0", "f"},       {"g/1", "f(x)"},    {"@O/1", "X_79(x/2)"},
        };
        std::string text;
        for (const std::string& met : met_kinds_) {
            if (interpreted.contains(met)) continue;
            const auto known =
                std::ranges::find(all, met, &std::pair<std::string, std::string>::first);
            if (known == all.end()) continue;
            const std::string symbol = met.substr(0, met.find('/'));
            std::string image = known->second;
            if (symbol == "@O" && (dialect_.python || dialect_.plus)) image = "X_79(x)";
            text +=
                "interpret " + symbol + (met.ends_with("/1") ? "(x)" : "") + " -> " + image + "\n";
        }
        text += elasticities();
        if (met_.contains("@O")) text += "solid X_79 sphere radius\n";
        if (met_.contains("@c")) text += "surface @c disc\n";
        return text;
    }

    /// Symbols that begin commands may have no rules of their own here, and contexts see commands whole.
    void check_commands() const {
        for (const std::string& name : met_) {
            const std::string met = name == "@contour" ? "@#" : name == "@sides" ? "@!" : name;
            if (met.size() < 2 || !is_cpfg_command(met)) continue;
            const auto check = [&](const CpfgModule& module, const char* what, bool last_too) {
                for (std::size_t i = 0; i + (last_too ? 0 : 1) < met.size(); ++i)
                    if (module.symbol == met.substr(i, 1))
                        refuse(module.place, std::string(what) + module.symbol,
                               "sees a part of the command " + met +
                                   ", which is one symbol in the notation");
            };
            for (const auto* rules :
                 {&system_.rules, &system_.interpretation, &system_.decomposition})
                for (const CpfgRule& rule : *rules) {
                    check(rule.predecessor, "a rule for ", rules != &system_.rules);
                    for (const auto* side : {&rule.left, &rule.right})
                        for (const CpfgModule& module : *side) check(module, "the context ", true);
                }
        }
    }

    std::string written(const std::vector<CpfgModule>& word, const std::set<std::string>& names) {
        std::vector<std::string> parts;
        for (const CpfgModule& module : word) {
            std::string text = name(module);
            if (const auto types = system_.types.find(module.symbol);
                types != system_.types.end() && types->second.size() != module.arguments.size())
                fail(module.place, "the module " + module.symbol + " has " +
                                       std::to_string(types->second.size()) +
                                       " parameters, found " +
                                       std::to_string(module.arguments.size()));
            met_.insert(text);
            met_kinds_.insert(text + "/" + std::to_string(module.arguments.size()));
            if (!module.arguments.empty()) {
                std::vector<std::string> arguments;
                for (std::size_t i = 0; i < module.arguments.size(); ++i)
                    arguments.push_back(
                        expression(module.arguments[i], names, is_integer(module, i)));
                text += "(" + joined(arguments, ",") + ")";
            }
            parts.push_back(text);
        }
        return parts.empty() ? "ε" : spaced_word(parts);
    }

    /// Whether a parameter of a module is a whole number: those of lpfg have types.
    bool is_integer(const CpfgModule& module, std::size_t parameter) const {
        const auto types = system_.types.find(module.symbol);
        return types != system_.types.end() && parameter < types->second.size() &&
               types->second[parameter] == "int";
    }

    std::set<std::string> formals(const CpfgRule& rule) const {
        std::set<std::string> names;
        integer_formals_.clear();
        const auto add = [&](const CpfgModule& module) {
            for (std::size_t i = 0; i < module.arguments.size(); ++i) {
                names.insert(module.arguments[i].text);
                if (is_integer(module, i)) integer_formals_.insert(module.arguments[i].text);
            }
        };
        add(rule.predecessor);
        for (const auto* side : {&rule.left, &rule.right, &rule.elsewhere})
            for (const CpfgModule& module : *side) add(module);
        return names;
    }

    /// What the contexts of a rule are, whatever their parameters are called.
    std::string contexts(const CpfgRule& rule) const {
        std::string text;
        for (const auto* side : {&rule.left, &rule.right, &rule.elsewhere}) {
            for (const CpfgModule& module : *side)
                text += module.symbol + "/" + std::to_string(module.arguments.size()) + " ";
            text += "|";
        }
        return text;
    }

    std::string head(const CpfgRule& rule, const std::string& condition,
                     const std::string& elsewhere) {
        const std::set<std::string> names = formals(rule);
        std::string text;
        if (!rule.left.empty()) text += written(rule.left, names) + " < ";
        text += written({rule.predecessor}, names);
        if (!rule.right.empty()) text += " > " + written(rule.right, names);
        if (!elsewhere.empty()) text += " ? " + elsewhere;
        if (!condition.empty()) text += " : " + condition;
        return text;
    }

    /// What a rule asks of the word at large: the number of the step, and the letter that gives it as many modules as the others for its
    /// letter have.
    std::string elsewhere(const CpfgRule& rule) {
        std::vector<std::string> all;
        const std::set<std::string> names = formals(rule);
        for (const CpfgModule& module : rule.elsewhere) all.push_back(written({module}, names));
        if (counted_.contains(rule.letter()))
            all.push_back(std::string(counter) + "(" + step_ + ")");
        if (const auto most = padded_.find(rule.letter()); most != padded_.end())
            all.resize(all.size() + most->second - rule.reach(), weight_of_rules);
        return joined(all, ", ");
    }

    /// What a value is that is given to a parameter that is a whole number.
    static Placed whole(const Placed& value) {
        Placed out;
        for (const char c : std::string_view("int(")) out.add(c, value.place(0));
        out.append(value);
        out.add(')', value.place(0));
        return out;
    }

    /// Bounds the work where letters that vanish are made of many.
    void count_step(const CpfgModule& module, const char* what) const {
        constexpr std::size_t most = 2'000'000;
        if (++steps_ > most) refuse(module.place, what, "that takes more than 2000000 steps");
    }

    /// A word that a rule gives where a condition of the notation holds, always if it is empty.
    struct Case {
        std::string condition;
        std::vector<CpfgModule> word;
    };

    /// What a decomposition makes of a word, as deep as it goes: a word for each outcome of the conditions that the names of a rule leave open.
    std::vector<Case> decomposed(const std::vector<CpfgModule>& word, std::uint64_t depth,
                                 const std::set<std::string>& names) const {
        std::vector<Case> found(1);
        for (const CpfgModule& module : word) {
            count_step(module, "a decomposition");
            const std::vector<Case> parts = cases_of(module, depth, names);
            std::vector<Case> longer;
            for (const Case& before : found)
                for (const Case& part : parts) {
                    longer.push_back({both(before.condition, part.condition), before.word});
                    std::vector<CpfgModule>& all = longer.back().word;
                    all.insert(all.end(), part.word.begin(), part.word.end());
                }
            found = std::move(longer);
            check_cases(module, found);
        }
        return found;
    }
    void check_cases(const CpfgModule& module, const std::vector<Case>& cases) const {
        constexpr std::size_t most = 64, longest = 100'000;
        if (cases.size() > most)
            refuse(module.place, "a decomposition",
                   "whose conditions have more than 64 outcomes for one rule would take too many "
                   "rules of the notation");
        std::size_t size = 0;
        for (const Case& one : cases) size += one.word.size() + one.condition.size();
        if (size > longest)
            refuse(module.place, "a decomposition", "that gives more than 100000 modules");
    }
    static std::string both(const std::string& one, const std::string& other) {
        return one.empty() || other.empty() ? one + other : one + " & " + other;
    }

    /// What a decomposition makes of a module: of its rules the first whose condition holds is used.
    std::vector<Case> cases_of(const CpfgModule& module, std::uint64_t depth,
                               const std::set<std::string>& names) const {
        std::vector<Case> found;
        std::string open;  // no rule so far applies where this holds
        for (const CpfgRule& rule : system_.decomposition) {
            if (depth == 0 || rule.letter() != module.kind()) continue;
            std::map<std::string, Placed> values;
            for (std::size_t i = 0; i < module.arguments.size(); ++i)
                values.emplace(rule.predecessor.arguments[i].text, is_integer(module, i)
                                                                       ? whole(module.arguments[i])
                                                                       : module.arguments[i]);
            std::string condition;
            if (rule.condition) {
                condition = "(" + expression(cpfg_with(*rule.condition, values), names) + ")";
                const std::optional<bool> holds = known(condition);
                if (holds && !*holds) continue;
                if (holds) condition.clear();
            }
            for (Case& one :
                 decomposed(image_of(module, rule, values, "a decomposition"), depth - 1, names)) {
                one.condition = both(both(open, condition), one.condition);
                found.push_back(std::move(one));
            }
            check_cases(module, found);
            if (condition.empty()) return found;
            open = both(open, "!" + condition);
        }
        found.push_back({open, {module}});
        return found;
    }

    /// The successor of a rule with these values for its names.
    std::vector<CpfgModule> image_of(const CpfgModule& module, const CpfgRule& rule,
                                     const std::map<std::string, Placed>& values,
                                     const char* what) const {
        constexpr std::size_t longest = 10'000;
        std::vector<CpfgModule> found = modules(rule.successor);
        for (CpfgModule& one : found) {
            one.place = module.place;
            for (Placed& argument : one.arguments) {
                argument = cpfg_with(argument, values);
                if (argument.text.size() > longest)
                    refuse(module.place, what,
                           "that gives an expression of more than 10000 characters");
            }
        }
        return found;
    }

    /// Whether a condition of the notation that reads no name holds; nothing if it reads one.
    static std::optional<bool> known(const std::string& condition) {
        try {
            const Quantity value =
                evaluate(read_expression(condition),
                         [](const std::string&) -> const Quantity* { return nullptr; });
            return value.value != 0;
        } catch (const Diagnostics&) {
            return std::nullopt;
        }
    }

    /// The first rule of the homomorphism for the module whose condition holds, and the values of its names.
    const CpfgRule* interpreting(const CpfgModule& module, const std::set<std::string>& names,
                                 std::map<std::string, Placed>& values) const {
        for (const CpfgRule& rule : system_.interpretation) {
            if (rule.predecessor.kind() != module.kind()) continue;
            values.clear();
            for (std::size_t i = 0; i < module.arguments.size(); ++i)
                values.emplace(rule.predecessor.arguments[i].text, module.arguments[i]);
            if (!rule.condition) return &rule;
            const auto holds =
                known("(" + expression(cpfg_with(*rule.condition, values), names) + ")");
            if (!holds)
                refuse(module.place,
                       "a homomorphism with a condition on parameters of what a homomorphism gives",
                       "has no meaning in the notation");
            if (*holds) return &rule;
        }
        return nullptr;
    }

    /// What a homomorphism makes of an image of it, as deep as it goes. What it would rewrite still deeper draws as the turtle takes it, so
    /// such letters get other names or, where they do nothing, are left out; % means nothing in it.
    std::vector<CpfgModule> drawn(std::vector<CpfgModule> image, std::uint64_t depth,
                                  const std::set<std::string>& interpreted,
                                  const std::set<std::string>& names) const {
        constexpr std::size_t longest = 100'000;
        constexpr std::uint64_t deepest = 1000;
        std::erase_if(image, [](const CpfgModule& module) { return module.symbol == "%"; });
        const auto is_interpreted = [&](const CpfgModule& module) {
            return interpreted.contains(name(module) + "/" +
                                        std::to_string(module.arguments.size()));
        };
        std::vector<CpfgModule> found;
        for (CpfgModule& module : image) {
            count_step(module, "a homomorphism");
            if (!is_interpreted(module)) {
                found.push_back(std::move(module));
                continue;
            }
            std::map<std::string, Placed> values;
            const CpfgRule* rule = depth > 1 ? interpreting(module, names, values) : nullptr;
            if (rule) {
                if (depth > deepest)
                    refuse(module.place, "a homomorphism", "that is more than 1000 deep");
                for (CpfgModule& one : drawn(image_of(module, *rule, values, "a homomorphism"),
                                             depth - 1, interpreted, names))
                    found.push_back(std::move(one));
            } else if (module.symbol == "F" || module.symbol == "f" || module.symbol == "G") {
                // Outside polygons G is a stroke as F is.
                if (module.symbol == "G" && !line_) line_ = module.place;
                module.symbol = module.symbol == "f" ? "f_h" : "F_h";
                found.push_back(std::move(module));
            } else if (!std::isalpha(static_cast<unsigned char>(module.symbol[0])) ||
                       module.symbol == "g") {
                refuse(module.place, "a homomorphism of what a homomorphism gives",
                       "is applied " +
                           (system_.drawn_depth == 1
                                ? std::string("once")
                                : std::to_string(system_.drawn_depth) + " times") +
                           " there, and until nothing is left in the notation, which has no other "
                           "name for " +
                           module.symbol);
            }
            if (found.size() > longest)
                refuse(module.place, "a homomorphism", "that gives more than 100000 modules");
        }
        return found;
    }

    std::vector<Case> successors(const CpfgRule& rule) const {
        return decomposed(modules(rule.successor), system_.depth, formals(rule));
    }

    /// The lines of a rule where a condition holds, with an arrow of the notation: one for each outcome of the conditions of decompositions.
    std::string lines(const CpfgRule& rule, const std::string& condition,
                      const std::string& arrow = "->") {
        std::string text;
        for (const Case& one : successors(rule))
            text += head(rule, both(condition, one.condition), elsewhere(rule)) + " " + arrow +
                    " " + written(part_of(rule, one.word), formals(rule)) + "\n";
        return text;
    }

    /// A rule for each module that no other rule rewrites and a decomposition does.
    void add_decompositions() {
        if (system_.decomposition.empty()) return;
        std::set<std::string> seen;
        for (const CpfgRule& rule : system_.decomposition) {
            if (rule.weight || !rule.left.empty() || !rule.right.empty())
                refuse(rule.place, "a decomposition with contexts or weights",
                       "has no meaning in the notation");
            if (!seen.insert(rule.letter()).second) continue;
            const auto same = [&](const CpfgRule& one) { return one.letter() == rule.letter(); };
            if (system_.stochastic && std::ranges::any_of(system_.rules, same)) {
                if (std::ranges::any_of(system_.rules, [&](const CpfgRule& one) {
                        return same(one) && one.reach() == 0 && !one.condition;
                    }))
                    continue;  // some rule applies
                refuse(rule.place,
                       "a decomposition of what rules with contexts or conditions may leave",
                       "beside weights has no meaning in the notation");
            }
            CpfgRule last;
            last.predecessor = rule.predecessor;
            last.place = rule.place;
            for (const char c : rule.predecessor.symbol)
                last.successor.add(c, rule.predecessor.place);
            if (!rule.predecessor.arguments.empty()) {
                char sign = '(';
                for (const Placed& argument : rule.predecessor.arguments) {
                    last.successor.add(sign, rule.place);
                    for (std::size_t i = 0; i < argument.text.size(); ++i)
                        last.successor.add(argument.text[i], argument.place(i));
                    sign = ',';
                }
                last.successor.add(')', rule.place);
            }
            added_.push_back(std::move(last));
        }
        system_.rules.insert(system_.rules.end(), added_.begin(), added_.end());
    }

    /// Letters behind which no letter but the end of their branch can stand.
    std::set<std::string> last_letters() const {
        std::vector<std::pair<std::string, std::vector<CpfgModule>>> words{
            {"", modules(system_.axiom)}};
        for (const CpfgRule& rule : system_.rules)
            for (Case& one : successors(rule))
                words.emplace_back(rule.predecessor.symbol, std::move(one.word));
        std::set<std::string> last;
        for (const auto& [owner, word] : words)
            for (const CpfgModule& module : word) last.insert(module.symbol);
        for (const auto& [owner, word] : words)
            if (owner == "[" || owner == "]") return {};
        for (bool changed = true; changed;) {
            changed = false;
            for (const auto& [owner, word] : words)
                for (std::size_t i = 0; i < word.size(); ++i) {
                    const bool ends = i + 1 < word.size() ? word[i + 1].symbol == "]"
                                                          : !owner.empty() && last.contains(owner);
                    if (!ends && last.erase(word[i].symbol) > 0) changed = true;
                }
        }
        return last;
    }

    bool has_contexts() const {
        return std::ranges::any_of(system_.rules, [](const CpfgRule& rule) {
            return !rule.left.empty() || !rule.right.empty();
        });
    }

    /// What `%` cuts is gone after the next step there, and stays in the words of the notation behind a `%` that no context sees past. In
    /// the step itself it is seen by contexts that skip `%` or name it: then % is a letter of its own at first.
    void mark_cuts() {
        if (rewrites_cut_ || !has_contexts()) return;
        const auto is_cut = [](const CpfgModule& module) {
            return module.symbol == "%" && module.arguments.empty();
        };
        const auto holds = [&](const std::vector<CpfgModule>& word) {
            return std::ranges::any_of(word, is_cut);
        };
        bool skipped = system_.considered && !holds(modules(*system_.considered));
        skipped = skipped || (system_.ignored && holds(modules(*system_.ignored)));
        for (const CpfgRule& rule : system_.rules)
            skipped = skipped || holds(rule.left) || holds(rule.right);
        cuts_later_ = skipped;
    }

    // --- Rings ---

    std::set<std::string> skipped_symbols() const {
        std::set<std::string> skipped;
        if (system_.ignored)
            for (const CpfgModule& module : modules(*system_.ignored))
                skipped.insert(module.symbol);
        if (!system_.considered) return skipped;
        std::set<std::string> seen;
        for (const CpfgModule& module : modules(*system_.considered)) seen.insert(module.symbol);
        const auto add = [&](const std::vector<CpfgModule>& word) {
            for (const CpfgModule& module : word)
                if (!seen.contains(module.symbol)) skipped.insert(module.symbol);
        };
        add(modules(system_.axiom));
        for (const CpfgRule& rule : system_.rules)
            for (const Case& one : successors(rule)) add(one.word);
        return skipped;
    }

    void check_ring() const {
        if (!system_.ring) return;
        for (const CpfgRule& rule : system_.rules)
            if (!rule.several.empty())
                refuse(*system_.ring, "a ring beside predecessors of several modules",
                       "has no meaning in the notation, where these are contexts");
    }

    /// In a ring the last letter of a word stands before the first one. Two letters around the word, which rules keep up with it, say what its
    /// first and its last letter are, and rules for letters at the ends look for them.
    void join_ends() {
        if (!system_.ring || !has_contexts()) return;
        const auto no = [&](const char* what, const char* why) {
            refuse(*system_.ring, what, why);
        };
        if (system_.stochastic)
            no("a ring with choices and contexts",
               "has no meaning in the notation, where what stands at one end is told to the other "
               "by rules that choose anew");
        if (holds_cut()) no("a ring with %", "has no meaning in the notation");
        skipped_ = skipped_symbols();
        std::vector<std::vector<CpfgModule>> words{modules(system_.axiom)};
        for (const CpfgRule& rule : system_.rules)
            for (Case& one : successors(rule)) {
                if (skipped_.contains(rule.predecessor.symbol))
                    for (const CpfgModule& module : one.word)
                        if (!skipped_.contains(module.symbol))
                            refuse(rule.place, "a rule of a ring by which contexts see more",
                                   "than before it has no meaning in the notation");
                words.push_back(std::move(one.word));
            }
        for (const std::vector<CpfgModule>& word : words)
            for (const CpfgModule& module : word) {
                if (module.symbol == "[" || module.symbol == "]")
                    no("a ring with branches", "has no meaning in the notation");
                if (skipped_.contains(module.symbol)) continue;
                if (!ends_.try_emplace(module.kind(), static_cast<int>(ends_.size())).second)
                    continue;
                for (const int from : {first_letters, last_letters_from})
                    if (const auto types = system_.types.find(module.symbol);
                        types != system_.types.end())
                        system_.types["X_" + std::to_string(from + ends_.at(module.kind()))] =
                            types->second;
            }
        joins_ends_ = true;
        std::vector<CpfgRule> all;
        for (const CpfgRule& rule : system_.rules) {
            if (rule.left.size() > 1 || rule.right.size() > 1)
                refuse(rule.place, "a context of several modules in a ring",
                       "has no meaning in the notation, where only one letter of each end is known "
                       "at the other");
            add_joined(rule, all);
        }
        system_.rules = std::move(all);
    }

    /// The rule within the word and at its ends, and what it makes of the letters that say what the ends are.
    void add_joined(const CpfgRule& rule, std::vector<CpfgRule>& all) const {
        using Part = CpfgRule::Part;
        const CpfgModule& own = rule.predecessor;
        const bool is_seen = !skipped_.contains(own.symbol);
        const bool has_left = !rule.left.empty(), has_right = !rule.right.empty();
        const auto known = [&](const std::vector<CpfgModule>& side) {
            return side.empty() || ends_.contains(side[0].kind());
        };
        if (!known(rule.left) || !known(rule.right)) return;  // matches nowhere
        if (!is_seen) {
            // Which letters stand at the ends is not known where contexts skip the letter itself.
            if (has_left || has_right)
                refuse(rule.place, "a rule of a ring with contexts for a letter that contexts skip",
                       "has no meaning in the notation");
            all.push_back(rule);
            return;
        }
        if (!ends_.contains(own.kind())) return;
        const CpfgModule first = end_of(own, Part::first, "R_"),
                         last = end_of(own, Part::last, "S_");
        for (const bool at_first : {false, true})
            for (const bool at_last : {false, true}) {
                if ((at_first && !has_left) || (at_last && !has_right)) continue;
                CpfgRule one = rule;
                if (at_first) {
                    one.left = {first};
                    one.elsewhere.push_back(end_of(rule.left[0], Part::last, ""));
                }
                if (at_last) {
                    one.right = {last};
                    one.elsewhere.push_back(end_of(rule.right[0], Part::first, ""));
                }
                all.push_back(std::move(one));
            }
        // Of a word of one letter, that letter stands on both sides of itself.
        for (const Part part : {Part::first, Part::last}) {
            const bool is_first = part == Part::first;
            const std::vector<CpfgModule>&near = is_first ? rule.right : rule.left,
                  &far = is_first ? rule.left : rule.right;
            for (const bool alone : {false, true}) {
                if (alone && (near.empty() || near[0].kind() != own.kind())) continue;
                CpfgRule one = rule;
                one.part = part;
                one.predecessor = alone ? end_of(near[0], part, "") : is_first ? first : last;
                one.left.clear();
                one.right.clear();
                std::vector<CpfgModule>& side = is_first ? one.right : one.left;
                side = {own};
                if (!near.empty()) {
                    const CpfgModule next = alone ? (is_first ? last : first) : near[0];
                    side.insert(is_first ? side.end() : side.begin(), next);
                }
                if (!far.empty())
                    one.elsewhere.push_back(
                        end_of(far[0], is_first ? Part::last : Part::first, ""));
                all.push_back(std::move(one));
            }
        }
    }

    /// The letter that says that a module stands at an end, with its parameters or with ones of these names.
    CpfgModule end_of(const CpfgModule& module, CpfgRule::Part part,
                      const std::string& names) const {
        CpfgModule end = module;
        end.symbol = "X_" + std::to_string((part == CpfgRule::Part::first ? first_letters
                                                                          : last_letters_from) +
                                           ends_.at(module.kind()));
        if (names.empty()) return end;
        for (std::size_t i = 0; i < end.arguments.size(); ++i) {
            const std::size_t place = end.arguments[i].place(0);
            end.arguments[i] = {};
            for (const char c : names + std::to_string(i)) end.arguments[i].add(c, place);
        }
        return end;
    }
    /// The letter for the first or the last module of a word that contexts see.
    CpfgModule end_letter(const std::vector<CpfgModule>& word, CpfgRule::Part part,
                          std::size_t place) const {
        const bool is_first = part == CpfgRule::Part::first;
        for (std::size_t i = 0; i < word.size(); ++i) {
            const CpfgModule& module = is_first ? word[i] : word[word.size() - 1 - i];
            if (!skipped_.contains(module.symbol)) return end_of(module, part, "");
        }
        refuse(place, "a word of a ring in which contexts see no letter",
               "has no meaning in the notation, where only the next letter is known at the other "
               "end");
    }
    /// What a rule makes of its module, or of a letter that says what an end is.
    std::vector<CpfgModule> part_of(const CpfgRule& rule,
                                    const std::vector<CpfgModule>& word) const {
        if (joins_ends_ && !skipped_.contains(rule.predecessor.symbol))
            end_letter(word, CpfgRule::Part::first, rule.place);
        if (rule.part == CpfgRule::Part::all) return ended(word);
        return {end_letter(word, rule.part, rule.place)};
    }

    /// `[B]` in a context is a whole branch there and the beginning of one in the notation: where a letter may follow B, each branch gets
    /// a last letter, which stands in the context too, or `%`, behind which nothing is left.
    void mark_branches() {
        if (dialect_.python) return;
        const std::set<std::string> last = last_letters();
        const auto is_whole = [&](const CpfgRule& rule, std::size_t i) {
            return rule.right[i].symbol == "]" && !rule.right[i - 1].open &&
                   !last.contains(rule.right[i - 1].symbol);
        };
        for (const CpfgRule& rule : system_.rules)
            for (std::size_t i = 1; i < rule.right.size(); ++i)
                ends_branches_ = ends_branches_ || is_whole(rule, i);
        if (!ends_branches_) return;
        cuts_later_ = cuts_later_ || holds_cut();
        constexpr std::size_t most = 4;
        std::vector<CpfgRule> all;
        for (const CpfgRule& rule : system_.rules) {
            std::vector<std::size_t> ends;
            for (std::size_t i = 1; i < rule.right.size(); ++i)
                if (is_whole(rule, i)) ends.push_back(i);
            if (ends.size() > most)
                refuse(rule.place, "a context with more than 4 whole branches",
                       "would take too many rules of the notation");
            const std::size_t sets = holds_cut() ? std::size_t{1} << ends.size() : 1;
            for (std::size_t set = 0; set < sets; ++set) {
                CpfgRule one = rule;
                for (std::size_t k = ends.size(); k-- > 0;) {
                    CpfgModule end;
                    end.symbol = (set >> k & 1) != 0 ? gone_from_here : end_of_branch;
                    end.place = rule.right[ends[k]].place;
                    one.right.insert(one.right.begin() + static_cast<std::ptrdiff_t>(ends[k]),
                                     std::move(end));
                }
                all.push_back(std::move(one));
            }
        }
        system_.rules = std::move(all);
    }
    /// Whether some word of the system has `%` that cuts.
    bool holds_cut() const {
        const auto holds = [&](const Placed& word) {
            return std::ranges::any_of(modules(word), [](const CpfgModule& module) {
                return module.symbol == "%" && module.arguments.empty();
            });
        };
        return !rewrites_cut_ &&
               (holds(system_.axiom) ||
                std::ranges::any_of(system_.rules,
                                    [&](const CpfgRule& rule) { return holds(rule.successor); }) ||
                std::ranges::any_of(system_.decomposition,
                                    [&](const CpfgRule& rule) { return holds(rule.successor); }));
    }
    /// A word with the last letter of each branch, if branches have one.
    std::vector<CpfgModule> ended(std::vector<CpfgModule> word) const {
        if (!ends_branches_) return word;
        std::vector<CpfgModule> all;
        for (CpfgModule& module : word) {
            if (module.symbol == "]") {
                CpfgModule end;
                end.symbol = end_of_branch;
                end.place = module.place;
                all.push_back(std::move(end));
            }
            all.push_back(std::move(module));
        }
        return all;
    }

    /// A branch in a context is the first one there, and any of those that stand together in the notation.
    void check_first_branches() const {
        if (dialect_.python) return;
        const auto is_open = [](const CpfgModule& module) { return module.symbol == "["; };
        if (std::ranges::none_of(system_.rules, [&](const CpfgRule& rule) {
                return std::ranges::any_of(rule.right, is_open);
            }))
            return;
        std::set<std::string> skipped, seen{"[", "]", end_of_branch};
        if (system_.ignored)
            for (const CpfgModule& module : modules(*system_.ignored))
                skipped.insert(module.symbol);
        if (system_.considered)
            for (const CpfgModule& module : modules(*system_.considered))
                seen.insert(module.symbol);
        std::vector<CpfgWord> words;
        const auto add = [&](const std::string& owner, const std::vector<CpfgModule>& word) {
            words.push_back({owner, {}});
            for (const CpfgModule& module : word) {
                words.back().letters.push_back(module.symbol);
                if (system_.considered && !seen.contains(module.symbol))
                    skipped.insert(module.symbol);
            }
        };
        add("", ended(modules(system_.axiom)));
        for (const CpfgRule& rule : system_.rules)
            for (const Case& one : successors(rule)) add(rule.predecessor.symbol, ended(one.word));
        for (const CpfgRule& rule : system_.rules) {
            std::vector<CpfgModule> context = rule.right;
            for (CpfgModule& module : context)
                if (module.symbol == gone_from_here) module.symbol = "%";
            if (!only_first_branches_match(context, words, skipped))
                refuse(std::ranges::find_if(rule.right, is_open)->place, "a branch in a context",
                       "is the first of those that stand together there, and any of them in the "
                       "notation: expected words in which no other of them begins so");
        }
    }

    /// What stands behind `%` in a branch stays behind it, as long as no rule closes that branch.
    void check_cuts() const {
        if (!cut_) return;
        for (const CpfgRule& rule : system_.rules) {
            bool closes = rule.predecessor.symbol == "[" || rule.predecessor.symbol == "]";
            for (const Case& one : successors(rule)) {
                int open = 0;
                for (const CpfgModule& module : one.word) {
                    open += module.symbol == "[" ? 1 : module.symbol == "]" ? -1 : 0;
                    closes = closes || open < 0;
                }
                closes = closes || open != 0;
            }
            if (closes)
                refuse(*cut_, "% beside rules that open or close a branch alone",
                       "cuts words there and figures in the notation, where what is cut could end "
                       "the branch");
        }
    }

    // --- The number of the step ---

    /// Whether an expression reads Q, and no parameter of this name.
    bool reads_step(const Placed& text, const std::set<std::string>& names) const {
        if (dialect_.python || dialect_.plus || names.contains("Q")) return false;
        for (std::size_t i = 0; i < text.text.size();) {
            const std::string name = name_at(text, i);
            if (name == "Q") return true;
            i += std::max<std::size_t>(name.size(), 1);
        }
        return false;
    }
    bool reads_step(const std::vector<CpfgModule>& word, const std::set<std::string>& names) const {
        return std::ranges::any_of(word, [&](const CpfgModule& module) {
            return std::ranges::any_of(module.arguments, [&](const Placed& argument) {
                return reads_step(argument, names);
            });
        });
    }
    /// Q is the parameter of a first letter that counts steps, which rules for letters that read it look for.
    void name_steps() {
        if (dialect_.python || dialect_.plus) return;
        step_ = "Q_";
        bool is_taken = true;
        while (is_taken) {
            is_taken = std::ranges::any_of(
                system_.rules, [&](const CpfgRule& rule) { return formals(rule).contains(step_); });
            if (is_taken) step_ += "_";
        }
        for (const CpfgRule& rule : system_.rules) {
            const std::set<std::string> names = formals(rule);
            bool reads = rule.condition && reads_step(*rule.condition, names);
            reads = reads || reads_step(modules(rule.successor), names);
            for (const CpfgRule& one : system_.decomposition)
                reads = reads || (one.condition && reads_step(*one.condition, formals(one))) ||
                        reads_step(modules(one.successor), formals(one));
            if (reads) counted_.insert(rule.letter());
        }
        known_["Q"] = step_;
    }

    /// Where rules of one letter have longer contexts behind shorter ones, the first that applies is used there, and here too if all of them
    /// ask for as many modules: a first letter of the word stands for those that are missing.
    void pad_rules() {
        if (system_.stochastic) return;
        std::map<std::string, std::size_t> least, most;  // of rules with contexts, of all
        std::set<std::string> mixed;
        for (const CpfgRule& rule : system_.rules) {
            const std::string letter = rule.letter();
            const std::size_t reach = rule.reach();
            most[letter] = std::max(most[letter], reach);
            if (rule.left.empty() && rule.right.empty()) continue;
            const auto [before, is_first] = least.try_emplace(letter, reach);
            if (before->second < reach) mixed.insert(letter);
            before->second = std::min(before->second, reach);
        }
        for (const std::string& letter : mixed) padded_[letter] = most[letter];
    }

    /// g leaves no corner; the notation has no move that does so.
    void check_moves() const {
        if (line_ && polygon_)
            refuse(*line_, "G in a homomorphism of G beside polygons",
                   "leaves no corner, and the notation has no other name for it");
        if (move_ && polygon_)
            refuse(*move_, "g beside polygons",
                   "leaves no corner, and a move of the notation does");
    }

    /// The condition of an earlier rule for the module of a rule, in the names of its parameters.
    std::string condition_of(const CpfgRule& earlier, const CpfgRule& rule) {
        const std::vector<std::string> theirs = formal_order(earlier), ours = formal_order(rule);
        std::map<std::string, Placed> values;
        for (std::size_t i = 0; i < std::min(theirs.size(), ours.size()); ++i) {
            Placed name;
            for (const char c : ours[i]) name.add(c, rule.place);
            values.emplace(theirs[i], std::move(name));
        }
        return expression(cpfg_with(*earlier.condition, values), formals(rule));
    }

    /// Whether no parameters of a rule make two conditions true, as far as the notation sees it.
    bool exclude_each_other(const std::string& one, const std::string& other,
                            const CpfgRule& rule) const {
        if (other.empty()) return false;
        std::vector<std::string> names = formal_order(rule);
        if (counted_.contains(rule.letter())) names.push_back(step_);
        const std::string head =
            "A" + (names.empty() ? "" : "(" + joined(names, ",") + ")") + " : ";
        const std::string text =
            constants_ + "axiom A\n" + head + one + " -> B\n" + head + other + " -> C\n";
        try {
            const Model both = read_lsystem(text, "");
            return overlaps(both).empty();
        } catch (const Error&) {
            return false;  // a constant without a value
        }
    }

    /// The rules in the notation, where the longest context comes first and not the first rule.
    std::string rule_lines() {
        std::string text;
        std::map<std::string, std::vector<const CpfgRule*>> before;
        for (const CpfgRule& rule : system_.rules) {
            auto& earlier = before[rule.letter()];
            const std::set<std::string> names = formals(rule);
            if (system_.stochastic) {
                if (!earlier.empty() && contexts(*earlier.front()) != contexts(rule))
                    refuse(rule.place, "a choice between rules with different contexts",
                           "has no meaning in the notation");
                earlier.push_back(&rule);
                continue;
            }
            std::string condition = rule.condition ? expression(*rule.condition, names) : "";
            bool reached = true;
            for (const CpfgRule* other : earlier) {
                const bool anywhere = other->left.empty() && other->right.empty();
                const bool same = contexts(*other) == contexts(rule);
                if (!anywhere && !same) continue;
                if (!other->condition) {
                    reached = false;
                    break;
                }
                if (!same && padded_.contains(rule.letter())) continue;
                const std::string before_it = condition_of(*other, rule);
                const std::optional<bool> always = known(before_it);
                if (always && *always) {
                    reached = false;
                    break;
                }
                if (always || exclude_each_other(before_it, condition, rule)) continue;
                const std::string no = "!(" + before_it + ")";
                condition = condition.empty() ? no : no + " & (" + condition + ")";
            }
            earlier.push_back(&rule);
            if (!reached) continue;
            text += lines(rule, condition);
        }
        if (!system_.stochastic) return text;
        for (const CpfgRule& rule : system_.rules) {
            auto& all = before[rule.letter()];
            if (all.empty()) continue;
            if (std::ranges::any_of(
                    all, [](const CpfgRule* one) { return one->condition.has_value(); })) {
                text += conditional_choice(all);
            } else if (all.size() == 1) {
                text += lines(rule, "");
            } else {
                Rational sum = 0;
                for (const CpfgRule* one : all) sum += weight(*one);
                for (const CpfgRule* one : all)
                    text += lines(*one, "", "-(" + to_string(weight(*one) / sum) + ")->");
            }
            all.clear();
        }
        return text;
    }

    /// Rules of one module with weights and conditions: those whose conditions hold share the choice, so there is one for each set of them.
    std::string conditional_choice(const std::vector<const CpfgRule*>& all) {
        constexpr std::size_t most = 8;
        if (all.size() > most)
            refuse(all.back()->place, "a choice between more than 8 rules with conditions",
                   "would take too many rules of the notation");
        std::string text;
        for (std::size_t set = 1; set < std::size_t{1} << all.size(); ++set) {
            const auto taken = [&](std::size_t i) { return (set >> i & 1) != 0; };
            bool possible = true;
            Rational sum = 0;
            for (std::size_t i = 0; i < all.size(); ++i) {
                if (taken(i)) sum += weight(*all[i]);
                possible = possible && (taken(i) || all[i]->condition);
            }
            if (!possible) continue;  // one without a condition always takes part
            for (std::size_t i = 0; i < all.size(); ++i) {
                if (!taken(i)) continue;
                std::string condition;
                for (std::size_t k = 0; k < all.size(); ++k) {
                    if (!all[k]->condition) continue;
                    condition += (condition.empty() ? "" : " & ") +
                                 std::string(taken(k) ? "" : "!") + "(" +
                                 condition_of(*all[k], *all[i]) + ")";
                }
                text += lines(*all[i], condition, "-(" + to_string(weight(*all[i]) / sum) + ")->");
            }
        }
        return text;
    }

    /// Names of the predecessor's parameters, then of those of the contexts.
    static std::vector<std::string> formal_order(const CpfgRule& rule) {
        std::vector<std::string> order;
        for (const Placed& formal : rule.predecessor.arguments) order.push_back(formal.text);
        for (const auto* side : {&rule.left, &rule.right, &rule.elsewhere})
            for (const CpfgModule& module : *side)
                for (const Placed& formal : module.arguments) order.push_back(formal.text);
        return order;
    }

    Rational weight(const CpfgRule& rule) const {
        if (!rule.weight) return 1;
        const auto none = [](const std::string&) -> const Quantity* { return nullptr; };
        try {
            const Quantity value = evaluate(read_expression(expression(*rule.weight, {})), none);
            if (value.exact && sign(*value.exact) > 0) return *value.exact;
        } catch (const Diagnostics&) {
        }
        fail(rule.weight->place(0),
             "expected a weight above 0 as a plain number, found '" + rule.weight->text + "'");
    }

    std::string ignored_line(const std::vector<CpfgModule>& all) const {
        std::vector<std::string> names;
        for (const CpfgModule& module : all)
            if (const std::string symbol = name(module); met_.contains(symbol))
                names.push_back(symbol);
        return names.empty() ? "" : "ignore " + spaced_word(names) + "\n";
    }
    std::string considered_line() const {
        std::set<std::string> seen{"[", "]", end_of_branch, "%"};
        for (const auto& [kind, number] : ends_)
            for (const int from : {first_letters, last_letters_from})
                seen.insert("X_" + std::to_string(from + number));
        for (const CpfgModule& module : modules(*system_.considered)) seen.insert(name(module));
        std::vector<std::string> names;
        for (const std::string& symbol : met_)
            if (!seen.contains(symbol)) names.push_back(symbol);
        return names.empty() ? "" : "ignore " + spaced_word(names) + "\n";
    }

    std::string expression(const Placed& text, const std::set<std::string>& names,
                           bool integer = false) const {
        CpfgIntegers integers{system_.integers, integer};
        for (const std::string& name : names)
            if (integer_formals_.contains(name))
                integers.names.insert(name);
            else
                integers.names.erase(name);
        return cpfg_expression(source_, dialect_, text, names, known_, integers);
    }

    // Letters of the notation that the file has not.
    static constexpr const char *counter = "X_81",          // counts the steps
        *weight_of_rules = "X_60",                          // stands for modules of contexts
            *end_of_branch = "X_93", *coming_cut = "X_38",  // a % that cuts from the next step on
                                         *gone_from_here =
                                             "%%";  // in a context: the % of a cut that was made

    CpfgNames known_;
    std::string constants_, step_;
    std::set<std::string> counted_;              // letters with rules that read the step
    std::map<std::string, std::size_t> padded_;  // letters whose rules ask for so many modules
    static constexpr int first_letters = 1000, last_letters_from = 2000;  // X_1000, X_2000
    std::map<std::string, int>
        ends_;                       // of a ring: the numbers of modules that may stand at its ends
    std::set<std::string> skipped_;  // by contexts of a ring
    bool joins_ends_ = false;
    bool cuts_later_ = false, ends_branches_ = false;
    std::vector<CpfgRule> added_;
    bool rewrites_cut_ = false;
    mutable std::set<std::string> integer_formals_;  // of the rule whose names were asked for last
    std::set<std::string> met_, met_kinds_;   // symbols, and with the number of their parameters
    mutable std::set<std::string> tropisms_;  // by number, those whose elasticity symbols change
    mutable std::size_t steps_ = 0;           // of decompositions and homomorphisms
    mutable std::optional<std::size_t> cut_, move_, line_, polygon_;  // where the first stands
};

}  // namespace

Model cpfg_model(const Source& source, const CpfgDialect& dialect, CpfgSystem system) {
    return Notation(source, dialect, std::move(system)).model();
}

}  // namespace algae
