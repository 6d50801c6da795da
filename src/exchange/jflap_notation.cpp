#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "exchange/detail/jflap.hpp"
#include "exchange/detail/plain_rules.hpp"
#include "exchange/detail/scanner.hpp"
#include "model/model.hpp"
#include "turtle/turtle.hpp"

// What an L-system of JFLAP is in the notation.
//
// The turtle starts upward, + turns to the right, g draws, % turns back, * rolls left. Tokens with a number, `g(2)`, are symbols of their
// own, `g·2`.
//
// Assignments, `angle=20` or `a=a+1`, change what the symbols behind them do, up to the end of their branch. The notation has no such
// state, so the values are put where they are used: a step or a turn whose value is a number becomes the symbol with that number, `-·20`, and
// a letter from which symbols are derived that read a variable carries the value as a parameter, unless it is the same number wherever the
// letter stands. That says everything as long as no symbol reads a variable which a letter before it goes on changing from one generation to
// the next; such files are refused. `!` and `~` change the width in the same way, and where it cannot be known widths are left out, as no
// place of the figure depends on them. Hues of lines are left out.
//
// Contexts: JFLAP picks among all productions that match. For each union of contexts that can match together there is a rule with all of
// their right sides, and of those that match the notation takes the longest, which is the union of all that do.

namespace algae {

namespace {

class Notation {
public:
    Notation(const Source& source, JflapSystem system)
        : source_(source), findings_(source_), system_(std::move(system)) {}

    Model model() {
        free_brackets();
        find_state();
        findings_.throw_if_any();
        State start;
        std::string rules = "axiom " + word(system_.axiom, start) + "\n";
        rules += rules_text();
        findings_.throw_if_any();
        return read_written((alphabet_.empty() ? "" : "alphabet" + alphabet_ + "\n") + rules +
                                interpretation_ + settings(),
                            source_.file());
    }

private:
    // --- Variables ---

    /// What a variable is at first.
    std::string parameter(const std::string& name) const {
        if (const auto known = system_.parameters.find(name); known != system_.parameters.end())
            return known->second;
        if (name == "angle" || name == "distance") return "15";
        if (name == "lineWidth" || name == "lineIncrement") return "1";
        if (name == "hueChange") return "10";
        return "0";
    }

    /// What a token says of variables.
    struct Reading {
        std::string command, argument;  // of `g(2)`
        bool has_argument = false;
        std::string assigned;  // the variable that it sets to `argument`
    };
    static Reading reading(const std::string& token) {
        Reading found;
        found.command = token;
        const std::size_t equals = token.find('='), open = token.find('(');
        if (equals != std::string::npos && equals > 0) {
            found.assigned = jflap_variable(token.substr(0, equals));
            found.argument = token.substr(equals + 1);
            found.has_argument = true;
        } else if (open != std::string::npos && open > 0 && token.ends_with(')')) {
            found.command = token.substr(0, open);
            found.argument = token.substr(open + 1, token.size() - open - 2);
            found.has_argument = true;
        }
        const bool widens = found.command == "!" || found.command == "~";
        if (widens && found.assigned.empty()) {
            found.assigned = "lineWidth";
            found.argument = std::string("lineWidth") + (found.command == "!" ? "+" : "-") + "(" +
                             (found.has_argument ? found.argument : "lineIncrement") + ")";
        }
        return found;
    }
    static bool is_step(const std::string& command) { return command == "g" || command == "f"; }
    static bool is_turn(const std::string& command) {
        return command.size() == 1 &&
               std::string_view("+-&^/*").find(command[0]) != std::string_view::npos;
    }

    /// Names in an expression.
    static std::set<std::string> names_in(const std::string& expression) {
        std::set<std::string> found;
        for_names(expression, [&](const std::string& name) {
            found.insert(jflap_variable(name));
            return name;
        });
        return found;
    }
    template <class Said>
    static std::string for_names(const std::string& expression, Said said) {
        std::string out;
        const auto part = [&](std::size_t i) {
            return std::isalnum(static_cast<unsigned char>(expression[i])) || expression[i] == '_';
        };
        for (std::size_t i = 0; i < expression.size();) {
            if (!part(i) || std::isdigit(static_cast<unsigned char>(expression[i]))) {
                // A number with its digits, which are no part of a name.
                do out += expression[i++];
                while (i < expression.size() && part(i) && !out.empty() &&
                       std::isdigit(static_cast<unsigned char>(out.back())));
                continue;
            }
            std::size_t end = i;
            while (end < expression.size() && part(end)) ++end;
            out += said(expression.substr(i, end - i));
            i = end;
        }
        return out;
    }

    /// The variables that a token itself reads, and those that what is derived from it reads.
    std::set<std::string> read_by(const JflapToken& token) const {
        const Reading said = reading(token.text);
        std::set<std::string> found;
        if (!said.assigned.empty()) {
            if (!is_jflap_colour(said.assigned)) found = names_in(said.argument);
        } else if (is_step(said.command) || is_turn(said.command)) {
            if (said.has_argument)
                found = names_in(said.argument);
            else
                found.insert(is_step(said.command) ? "distance" : "angle");
        }
        if (const auto derived = reads_.find(token.text); derived != reads_.end())
            found.insert(derived->second.begin(), derived->second.end());
        std::erase_if(found, [&](const std::string& name) { return !varying_.contains(name); });
        return found;
    }
    /// Those that it changes behind it, itself or what is derived from it.
    std::set<std::string> changed_by(const JflapToken& token) const {
        std::set<std::string> found;
        const Reading said = reading(token.text);
        if (varying_.contains(said.assigned)) found.insert(said.assigned);
        if (const auto derived = changes_.find(token.text); derived != changes_.end())
            found.insert(derived->second.begin(), derived->second.end());
        return found;
    }
    bool is_rewritten(const JflapToken& token) const { return left_sides_.contains(token.text); }

    /// Values of variables as expressions of the notation, and those whose value is not known.
    struct State {
        std::map<std::string, std::string> values;
        std::map<std::string, std::string> unknown;  // by which letter they are changed
    };

    std::string value_of(const std::string& name, const State& state) const {
        const auto known = state.values.find(name);
        return known == state.values.end() ? parameter(name) : known->second;
    }
    /// The expression with the values for its names; a number where it is one.
    std::string put_in(const std::string& expression, const State& state) const {
        return simplified(for_names(expression, [&](const std::string& name) {
            return is_function(name) ? name : "(" + value_of(jflap_variable(name), state) + ")";
        }));
    }
    static bool is_function(const std::string& name) {
        static const std::set<std::string> all{"sin", "cos", "tan", "sqrt", "exp", "log", "abs"};
        return all.contains(name);
    }
    static std::string simplified(const std::string& expression) {
        constexpr std::size_t longest = 10'000;
        if (expression.size() > longest)
            throw Error("an expression that would be longer than 10000 characters");
        const Expression read = read_expression(expression);
        try {
            const Quantity value =
                evaluate(read, [](const std::string&) -> const Quantity* { return nullptr; });
            if (value.exact) {
                const auto decimal = exact_decimal(*value.exact);
                return decimal ? *decimal : to_string(*value.exact);
            }
        } catch (const Error&) {
        }
        return expression;
    }

    /// Goes along a word: `each` is called for a token with the state before it, which then is the one behind it.
    template <class Each>
    void walk(const JflapWord& tokens, State state, Each each) {
        std::vector<State> open;
        for (const JflapToken& token : tokens) {
            each(token, state);
            if (token.text == "[") open.push_back(state);
            if (token.text == "]" && !open.empty()) {
                state = open.back();
                open.pop_back();
            }
            const Reading said = reading(token.text);
            if (varying_.contains(said.assigned)) {
                try {
                    state.values[said.assigned] = put_in(said.argument, state);
                } catch (const Error&) {
                    findings_.add(token.offset, "expected an expression behind '=', found " +
                                                    quoted(said.argument));
                    state.values[said.assigned] = "0";
                }
                state.unknown.erase(said.assigned);
            }
            if (const auto derived = changes_.find(token.text); derived != changes_.end())
                for (const std::string& name : derived->second) state.unknown[name] = token.text;
        }
    }

    template <class Each>
    void for_words(Each each) const {
        each("", system_.axiom);
        for (const JflapRule& rule : system_.rules)
            for (const JflapWord& right : rule.rights) each(rule.left[rule.index].text, right);
    }

    /// Which variables change, what letters carry of them, and whether the values can be put where they are used.
    void find_state() {
        for (const JflapRule& rule : system_.rules) left_sides_.insert(rule.left[rule.index].text);
        std::set<std::string> all;
        for_words([&](const std::string&, const JflapWord& word) {
            for (const JflapToken& token : word) {
                const Reading said = reading(token.text);
                if (!said.assigned.empty() && !is_jflap_colour(said.assigned))
                    all.insert(said.assigned);
            }
        });
        varying_ = all;
        if (!find_use()) return;
        // Widths are no matter of the figure's places: they are left out where they cannot be known.
        if (!varying_.contains("lineWidth") || (!unknown_ && !system_.has_context))
            return check_state();
        varying_.erase("lineWidth");
        if (find_use()) check_state();
    }
    void check_state() {
        if (system_.has_context && !varying_.empty())
            for_words([&](const std::string&, const JflapWord& word) {
                for (const JflapToken& token : word)
                    if (varying_.contains(reading(token.text).assigned))
                        findings_.add(
                            token.offset,
                            "assignments beside contexts have no meaning in the notation");
            });
        if (unknown_)
            findings_.add(unknown_->first.offset,
                          quoted(unknown_->first.text) + " depends on the variable " +
                              unknown_->second.first + ", which " +
                              quoted(unknown_->second.second) +
                              " before it goes on changing, and the notation has no variables");
    }

    /// False if no variable changes.
    bool find_use() {
        reads_.clear();
        changes_.clear();
        carried_.clear();
        unknown_.reset();
        if (varying_.empty()) return false;
        for (bool more = true; more;) {
            more = false;
            for_words([&](const std::string& letter, const JflapWord& word) {
                if (letter.empty()) return;
                const std::size_t before = reads_[letter].size() + changes_[letter].size();
                std::vector<std::set<std::string>> open;
                std::set<std::string> assigned;  // surely
                for (const JflapToken& token : word) {
                    for (const std::string& name : read_by(token))
                        if (!assigned.contains(name)) reads_[letter].insert(name);
                    if (token.text == "[") open.push_back(assigned);
                    if (token.text == "]" && !open.empty()) {
                        assigned = open.back();
                        open.pop_back();
                    }
                    const Reading said = reading(token.text);
                    if (varying_.contains(said.assigned)) assigned.insert(said.assigned);
                    if (open.empty())
                        for (const std::string& name : changed_by(token))
                            changes_[letter].insert(name);
                }
                more = more || reads_[letter].size() + changes_[letter].size() != before;
            });
        }
        // Values that letters carry: one number wherever they stand, or several.
        for (bool more = true; more;) {
            more = false;
            for_words([&](const std::string& letter, const JflapWord& word) {
                walk(word, state_of(letter), [&](const JflapToken& token, const State& state) {
                    for (const std::string& name : read_by(token)) {
                        if (const auto changed = state.unknown.find(name);
                            changed != state.unknown.end() && !unknown_)
                            unknown_ = std::pair{token, std::pair{name, changed->second}};
                        if (!is_rewritten(token)) continue;
                        const std::string value = value_of(name, state);
                        const bool is_number =
                            value.find_first_not_of("0123456789./-") == std::string::npos;
                        auto& carried = carried_[token.text];
                        const auto [known, is_new] = carried.emplace(name, value);
                        const std::string now = is_number && known->second == value ? value : "";
                        more = more || is_new || known->second != now;
                        known->second = now;
                    }
                });
            });
        }
        return true;
    }

    /// The state where a word of a letter begins: the numbers that it always has, and its parameters.
    State state_of(const std::string& letter) const {
        State state;
        if (const auto carried = carried_.find(letter); carried != carried_.end())
            for (const auto& [name, value] : carried->second)
                state.values[name] = value.empty() ? parameter_name(name) : value;
        return state;
    }
    static std::string parameter_name(const std::string& variable) { return "v_" + variable; }
    /// The variables that a letter has as parameters.
    std::vector<std::string> parameters_of(const std::string& letter) const {
        std::vector<std::string> found;
        if (const auto carried = carried_.find(letter); carried != carried_.end())
            for (const auto& [name, value] : carried->second)
                if (value.empty()) found.push_back(name);
        return found;
    }

    /// `]` without `[` does nothing there, and `[` without `]` keeps what nothing goes back to. Where no branch stands around, they are letters
    /// that do nothing here; elsewhere they would close the branches of other words. Beside contexts all brackets are letters there, and are refused.
    void free_brackets() {
        if (system_.has_context) {
            for_all_tokens([&](JflapToken& token) {
                if ((token.text == "[" || token.text == "]") && findings_.empty())
                    findings_.add(token.offset,
                                  "brackets are letters beside contexts in JFLAP, and branches in "
                                  "the notation");
            });
            return;
        }
        std::set<std::string> inside;  // letters that stand in branches
        std::map<std::string, std::set<std::string>> derived;
        for_words([&](const std::string& letter, const JflapWord& word) {
            // Depths by brackets that have a partner.
            std::vector<int> change(word.size());
            std::vector<std::size_t> opened;
            for (std::size_t i = 0; i < word.size(); ++i) {
                if (word[i].text == "[") opened.push_back(i);
                if (word[i].text != "]" || opened.empty()) continue;
                change[opened.back()] = 1;
                change[i] = -1;
                opened.pop_back();
            }
            int open = 0;
            for (std::size_t i = 0; i < word.size(); ++i) {
                open += change[i];
                derived[letter].insert(word[i].text);
                if (open > 0) inside.insert(word[i].text);
            }
        });
        for (bool more = true; more;) {
            const std::size_t before = inside.size();
            for (const auto& [letter, all] : derived)
                if (inside.contains(letter)) inside.insert(all.begin(), all.end());
            more = inside.size() != before;
        }
        const auto free = [&](const std::string& letter, JflapWord& word) {
            std::vector<std::size_t> open;
            std::vector<std::size_t> unmatched;
            for (std::size_t i = 0; i < word.size(); ++i) {
                if (word[i].text == "[") open.push_back(i);
                if (word[i].text != "]") continue;
                if (open.empty())
                    unmatched.push_back(i);
                else
                    open.pop_back();
            }
            unmatched.insert(unmatched.end(), open.begin(), open.end());
            for (const std::size_t i : unmatched) {
                if (inside.contains(letter))
                    findings_.add(word[i].offset,
                                  "unmatched '" + word[i].text + "' in a word of " +
                                      quoted(letter) +
                                      ", which stands in branches: it would end or open another "
                                      "branch, which has no meaning in the notation");
                word[i].text = word[i].text == "[" ? lone_opens : lone_closes;
            }
        };
        free("", system_.axiom);
        for (JflapRule& rule : system_.rules)
            for (JflapWord& right : rule.rights) free(rule.left[rule.index].text, right);
    }
    template <class Each>
    void for_all_tokens(Each each) {
        for (JflapToken& token : system_.axiom) each(token);
        for (JflapRule& rule : system_.rules) {
            for (JflapToken& token : rule.left) each(token);
            for (JflapWord& right : rule.rights)
                for (JflapToken& token : right) each(token);
        }
    }
    static constexpr const char *lone_opens = "X_91_0", *lone_closes = "X_93_0";

    // --- Words ---

    /// The symbol of the notation for a token, with what it does to the turtle said.
    std::string symbol(const JflapToken& token) {
        const auto inserted = symbols_.emplace(token.text, "");
        const auto known = inserted.first;
        if (!inserted.second) return known->second;
        const Reading said = reading(token.text);
        std::string name = said.command, number;
        const auto give_up = [&](const std::string& why) {
            findings_.add(token.offset, why);
            return known->second = "X";
        };
        const bool assigns = token.text.find('=', 1) != std::string::npos;
        if (!assigns && said.has_argument) {
            number = said.argument;
            const std::string digits = number.substr(number.starts_with('-') ? 1 : 0);
            const bool is_number = !digits.empty() && number_size(digits) == digits.size() &&
                                   digits.find_first_of("eE") == std::string::npos;
            if (is_number) {
                number = (number.starts_with('-') ? "-" : "") +
                         (digits.starts_with('.') ? "0" : std::string()) + plain_number(digits);
            } else if (is_step(name) || is_turn(name)) {
                return give_up("expected a number or an expression between the brackets of " +
                               quoted(token.text));
            } else {
                name = token.text;
                number.clear();
            }
        }
        const std::string command = name;
        if (is_character(name) &&
            std::string_view("()<>:,;?#=").find(name) != std::string_view::npos)
            name = fmt::format("X_{}", static_cast<unsigned char>(name[0]));
        else
            name = allowed(name);
        if (!number.empty()) name += "·" + number;
        for (const auto& [other, taken] : symbols_)
            if (taken == name)
                return give_up(quoted(token.text) + " and " + quoted(other) +
                               " would be one symbol");
        known->second = name;
        if (undeclared_length(name) != name.size()) alphabet_ += " " + name;
        const std::string does = assigns ? colour_of(token.text) : meaning(command, number);
        if (does != name && (does != "ε" || acts(name)))
            interpretation_ += "interpret " + name + " -> " + does + "\n";
        return name;
    }

    /// A name without the signs of the notation.
    static std::string allowed(const std::string& name) {
        static const std::map<char, const char*> others{
            {'(', "⟨"},  {')', "⟩"},  {'<', "‹"}, {'>', "›"}, {':', "꞉"}, {',', "‚"},
            {';', "；"}, {'?', "？"}, {'=', "≔"}, {'#', "♯"}, {'|', "¦"}};
        if (name.size() == 1) return name;
        std::string out;
        for (const char c : name) {
            const auto other = others.find(c);
            out += other == others.end() ? std::string(1, c) : other->second;
        }
        return out;
    }

    /// What `color=red` does; the colours are counted from that of the parameter.
    std::string colour_of(const std::string& assignment) {
        if (!assignment.starts_with("color=")) return "ε";
        const std::string colour = known_colour(assignment.substr(6));
        if (colour.empty()) return "ε";
        if (colours_.empty()) colours_.push_back(first_colour());
        auto found = std::ranges::find(colours_, colour);
        if (found == colours_.end()) found = colours_.insert(found, colour);
        return "'(" + std::to_string(found - colours_.begin()) + ")";
    }
    std::string first_colour() const {
        const std::string colour = known_colour(system_.colour);
        return colour.empty() ? "black" : colour;
    }
    /// The name as the notation has it; empty if it has none.
    static std::string known_colour(std::string name) {
        for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        const auto names = colour_names();
        return std::ranges::count(names, name) > 0 ? name : "";
    }

    /// A token where it stands in a word: the symbol, and the values that it needs.
    std::string module(const JflapToken& token, const State& state) {
        const Reading said = reading(token.text);
        const bool step = is_step(said.command), turn = is_turn(said.command);
        if (is_rewritten(token)) return module_of_letter(token, state);
        std::string value, bare;
        try {
            if (varying_.contains("lineWidth") && said.assigned == "lineWidth" &&
                (said.command == "!" || said.command == "~")) {
                value = put_in(said.argument, state);
                bare = "lineWidth";
            } else if ((step || turn) && said.has_argument && !names_in(said.argument).empty()) {
                value = put_in(said.argument, state);
                bare = said.command;
            } else if ((step || turn) && !said.has_argument) {
                const std::string name = step ? "distance" : "angle";
                value = value_of(name, state);
                bare = said.command;
                if (value == parameter(name)) value.clear();
            }
        } catch (const Error&) {
            findings_.add(token.offset,
                          "expected an expression between the brackets of " + quoted(token.text));
            return "X";
        }
        if (value.empty()) return symbol(token);
        if (number_size(value.substr(value.starts_with('-') ? 1 : 0)) ==
            value.size() - (value.starts_with('-') ? 1 : 0))
            return symbol({bare + "(" + value + ")", token.offset});
        const std::string name = symbol({bare, token.offset});
        const std::string does = meaning(bare, "x");
        if (does != name + "(x)" && with_value_.insert(name).second)
            interpretation_ += "interpret " + name + "(x) -> " + does + "\n";
        return name + "(" + value + ")";
    }
    /// A letter with the values of the variables that it carries.
    std::string module_of_letter(const JflapToken& token, const State& state) {
        const std::vector<std::string> names = parameters_of(token.text);
        const std::string name = symbol(token);
        if (names.empty()) return name;
        std::vector<std::string> values, own;
        for (const std::string& one : names) {
            values.push_back(value_of(one, state));
            own.push_back(parameter_name(one));
        }
        if (with_value_.insert(name).second) {
            const Reading said = reading(token.text);
            std::string does = "ε";
            if (is_step(said.command) || is_turn(said.command)) {
                const State inside = state_of(token.text);
                does =
                    meaning(said.command,
                            said.has_argument
                                ? put_in(said.argument, inside)
                                : value_of(is_step(said.command) ? "distance" : "angle", inside));
            } else if (!acts(name)) {
                does.clear();
            }
            if (!does.empty())
                interpretation_ +=
                    "interpret " + name + "(" + joined(own, ",") + ") -> " + does + "\n";
        }
        return name + "(" + joined(values, ",") + ")";
    }

    /// Whether the turtle of the notation does something for a symbol.
    static bool acts(const std::string& name) {
        return name == "F" || name == "f" || name == "G" || name.starts_with("F_") ||
               name.starts_with("f_") ||
               (name.size() == 1 &&
                std::string_view("+-&^\\/|[]{}.!'$%~@*").find(name[0]) != std::string_view::npos);
    }

    std::string meaning(const std::string& token, const std::string& number) const {
        const std::string degrees = number.empty() ? "" : "(" + number + ")";
        if (token == "g" || token == "f") {
            const std::string step = token == "g" ? "F" : "f";
            if (number.empty()) return is_still() ? step + "(0)" : step;
            return step + "(" + number + "/(" + unit() + "))";
        }
        if (token == "lineWidth" && !number.empty()) return "!(" + number + ")";
        for (const auto& [name, does] :
             {std::pair("+", "+"), {"-", "-"}, {"&", "&"}, {"^", "^"}, {"/", "/"}, {"*", "\\"}})
            if (token == name) return does + degrees;
        if (token == "%") return "|";
        if (token == "[" || token == "]" || token == "{" || token == "}") return token;
        return "ε";
    }

    /// The length of a step of the notation: that of the parameter, unless it is 0.
    std::string unit() const { return is_still() ? "1" : parameter("distance"); }
    bool is_still() const {
        return parameter("distance").find_first_not_of("-0.") == std::string::npos;
    }

    std::string word(const JflapWord& tokens, const State& state) {
        std::vector<std::string> names;
        walk(tokens, state, [&](const JflapToken& token, const State& now) {
            names.push_back(module(token, now));
        });
        return spaced_word(names);
    }

    /// A letter and what stands beside it.
    struct Pattern {
        JflapToken letter;
        JflapWord left, right;

        static bool ends(const JflapWord& word, const JflapWord& end) {
            return end.size() <= word.size() &&
                   std::equal(
                       end.rbegin(), end.rend(), word.rbegin(),
                       [](const JflapToken& a, const JflapToken& b) { return a.text == b.text; });
        }
        static bool begins(const JflapWord& word, const JflapWord& begin) {
            return begin.size() <= word.size() &&
                   std::equal(
                       begin.begin(), begin.end(), word.begin(),
                       [](const JflapToken& a, const JflapToken& b) { return a.text == b.text; });
        }
        /// Whether the other matches wherever this one does.
        bool implies(const Pattern& other) const {
            return letter.text == other.letter.text && ends(left, other.left) &&
                   begins(right, other.right);
        }
        /// The least that both match; nothing if they never match together.
        std::optional<Pattern> with(const Pattern& other) const {
            if (letter.text != other.letter.text) return std::nullopt;
            const JflapWord& longer_left = left.size() >= other.left.size() ? left : other.left;
            const JflapWord& longer_right =
                right.size() >= other.right.size() ? right : other.right;
            const Pattern both{letter, longer_left, longer_right};
            if (!both.implies(*this) || !both.implies(other)) return std::nullopt;
            return both;
        }
    };
    static Pattern pattern_of(const JflapRule& rule) {
        const auto at = rule.left.begin() + static_cast<std::ptrdiff_t>(rule.index);
        return {*at, {rule.left.begin(), at}, {at + 1, rule.left.end()}};
    }

    /// The patterns of all rules and their unions, each once.
    std::vector<Pattern> patterns() {
        constexpr std::size_t most = 2000;
        std::vector<Pattern> found;
        const auto add = [&](const Pattern& one) {
            if (std::ranges::none_of(found, [&](const Pattern& other) {
                    return one.implies(other) && other.implies(one);
                }))
                found.push_back(one);
        };
        for (const JflapRule& rule : system_.rules) add(pattern_of(rule));
        for (std::size_t i = 0; system_.has_context && i < found.size(); ++i)
            for (std::size_t k = 0; k < i; ++k) {
                if (const auto both = found[i].with(found[k])) add(*both);
                if (found.size() > most) {
                    findings_.add(found[i].letter.offset,
                                  "the contexts of " + quoted(found[i].letter.text) +
                                      " match together in too many ways: more than 2000");
                    return {};
                }
            }
        return found;
    }
    std::string context(const JflapWord& tokens) {
        std::vector<std::string> names;
        for (const JflapToken& token : tokens) names.push_back(symbol(token));
        return spaced_word(names);
    }
    std::string module_of_left(const JflapToken& letter) {
        return module_of_letter(letter, state_of(letter.text));
    }

    std::string rules_text() {
        // All right sides of one left side are one choice. Beside contexts it is one between all productions that match.
        std::vector<std::pair<std::string, std::vector<std::string>>> all;
        for (const Pattern& pattern : patterns()) {
            std::string left = spaced_word({module_of_left(pattern.letter)});
            if (!pattern.left.empty()) left = context(pattern.left) + " < " + left;
            if (!pattern.right.empty()) left += " > " + context(pattern.right);
            std::vector<std::string> rights;
            for (const JflapRule& rule : system_.rules)
                if (pattern.implies(pattern_of(rule)))
                    for (const JflapWord& right : rule.rights)
                        rights.push_back(word(right, state_of(pattern.letter.text)));
            all.emplace_back(left, std::move(rights));
        }
        std::string text;
        for (const auto& [left, rights] : all) {
            std::map<std::string, std::size_t> counts;
            for (const std::string& right : rights) ++counts[right];
            std::set<std::string> said;
            for (const std::string& right : rights) {
                if (!said.insert(right).second) continue;
                const bool chance = counts.size() > 1;
                text +=
                    left +
                    (chance ? fmt::format(" -({}/{})-> ", counts[right], rights.size()) : " -> ") +
                    right + "\n";
            }
        }
        return text;
    }

    std::string settings() const {
        std::string colours;
        for (const std::string& colour : colours_) colours += " " + colour;
        if (colours.empty() && !system_.colour.empty()) colours = " " + first_colour();
        const std::string width = parameter("lineWidth");
        return "angle " + parameter("angle") + "\nstep " + unit() +
               "\nstart 0 0 90\nturn clockwise\n" +
               (width == "1" || width.starts_with('-') || width == "0" ? ""
                                                                       : "width " + width + "\n") +
               (colours.empty() || colours == " black" ? "" : "colour" + colours + "\n");
    }

    const Source& source_;
    Findings findings_;
    JflapSystem system_;
    std::vector<std::string> colours_;                              // those of `'`
    std::set<std::string> left_sides_;                              // letters that are rewritten
    std::set<std::string> varying_;                                 // variables that words assign
    std::map<std::string, std::set<std::string>> reads_, changes_;  // by letter
    // Of each letter: what it carries, a number that it always has, or nothing if there are several.
    std::map<std::string, std::map<std::string, std::string>> carried_;
    std::optional<std::pair<JflapToken, std::pair<std::string, std::string>>> unknown_;
    std::set<std::string> with_value_;  // symbols whose meaning with parameters is said
    std::map<std::string, std::string> symbols_;
    std::string alphabet_, interpretation_;
};

}  // namespace

Model jflap_model(const Source& source, JflapSystem system) {
    return Notation(source, std::move(system)).model();
}

}  // namespace algae
