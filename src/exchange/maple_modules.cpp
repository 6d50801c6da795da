#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "exchange/maple_words.hpp"
#include "notation/characters.hpp"

namespace algae {

namespace {

constexpr std::size_t most_parameters = 1000;

/// Adds an axiom of modules and the functions that it calls.
class Reader {
public:
    Reader(MapleValues& values, LSystem& system)
        : values_(values), scanner_(values.scanner()), system_(system) {}

    void all() {
        const auto& assignments = values_.sheet().assignments;
        system_.axiom =
            word(values_.list(values_.sheet().arguments[0], "the axiom, a list of modules"), 0);
        while (!open_.empty()) {
            const std::string letter = std::move(open_.back());
            open_.pop_back();
            read_rule(letter);
        }
        for (const auto& assignment : assignments)  // in the order of the worksheet
            if (const auto found = rules_.find(assignment.name); found != rules_.end())
                system_.rules.push_back(std::move(found->second));
        name_parameters();
    }

private:
    struct Seen {
        std::size_t arity, offset;
    };

    ModuleWord word(const MapleValue& list, std::size_t parameters) {
        ModuleWord made;
        MapleBrackets brackets(scanner_);
        for (const MapleValue& item : list.items) {
            const MapleValue& module = values_.list(item, "a module, such as [\"F\",[1]]");
            if (module.items.empty() || module.items.size() > 2)
                values_.fail(item,
                             "expected the name of a module and a list of its parameters, found " +
                                 std::to_string(module.items.size()) + " values");
            const std::string symbol = name(module.items[0]);
            std::vector<Expression> arguments;
            const bool has_list = module.items.size() == 2;
            if (has_list) arguments = this->arguments(module.items[1], parameters);
            brackets.meet(symbol, item.offset);
            check(symbol, arguments.size(), has_list, item.offset);
            if (!arguments.empty()) made.arguments[made.letters.size()] = std::move(arguments);
            made.letters.push_back(system_.alphabet.symbol(symbol));
        }
        brackets.end();
        return made;
    }

    std::string name(const MapleValue& value) const {
        const MapleValue& text = values_.text(value, "the name of a module, a string");
        if (text.text.empty() || first_character(text.text).bytes != text.text.size())
            values_.fail(
                value, "expected the name of a module, one character, found " + quoted(text.text));
        return maple_symbol(scanner_, MapleForm::parametric, text.text, text.offset + 1);
    }

    std::vector<Expression> arguments(const MapleValue& value, std::size_t parameters) {
        const MapleValue& list = values_.resolved(value);
        std::vector<Expression> found;
        if (list.kind == MapleValue::Kind::parameters) {
            for (std::size_t i = 1; i <= parameters; ++i)
                found.push_back(entry(list.parameters, i));
            return found;
        }
        for (const MapleValue& item : values_.list(value, "a list of parameters").items) {
            if (item.expression.most_index > parameters)
                values_.fail(item, "uses parameter " + std::to_string(item.expression.most_index) +
                                       " of a module that has " + std::to_string(parameters));
            found.push_back(values_.number(item, "a parameter, a number"));
        }
        if (found.size() > most_parameters)
            values_.fail(value, "a module with more than 1000 parameters");
        return found;
    }

    static Expression entry(const std::string& list, std::size_t i) {
        Expression made;
        made.kind = Expression::Kind::name;
        made.name = list + "[" + std::to_string(i) + "]";
        return made;
    }

    /// What a module needs: parameters for the turtle, and a capital letter a function.
    void check(const std::string& symbol, std::size_t arity, bool has_list, std::size_t offset) {
        const MapleMeaning meaning = maple_meaning(MapleForm::parametric, symbol);
        if (meaning == MapleMeaning::refused)
            scanner_.fail_at(offset,
                             quoted(symbol) + " is nothing to this procedure, expected '@'");
        if (maple_need(symbol) == MapleNeed::one && arity == 0)
            scanner_.fail_at(offset, "the module " + shown(symbol) + " has no parameter");
        if (maple_need(symbol) == MapleNeed::none && has_list)
            scanner_.fail_at(offset, "the module " + symbol + " takes no parameters");
        if (meaning == MapleMeaning::none && silent_.insert({symbol, arity}).second) {
            Production silent;
            silent.predecessor.symbol = system_.alphabet.symbol(symbol);
            for (std::size_t i = 1; i <= arity; ++i)
                silent.predecessor.parameters.push_back("p" + std::to_string(i));
            system_.interpretation.push_back(std::move(silent));
        }
        const MapleValue* function = values_.sheet().find(symbol);
        const bool has_function = function && function->kind == MapleValue::Kind::function;
        if (!is_maple_capital(symbol)) {
            if (has_function)
                values_.fail(*function,
                             "the procedure rewrites capital letters alone, and never calls " +
                                 quoted(symbol));
            return;
        }
        if (!has_function)
            scanner_.fail_at(offset, "no function is assigned to the capital letter " + symbol +
                                         "; one that stays needs " + symbol + " := L -> [[\"" +
                                         symbol + "\",L]]");
        if (!has_list)
            scanner_.fail_at(offset, "the module " + symbol +
                                         " has no list for its function, expected [\"" + symbol +
                                         "\",[]]");
        if (is_identity(*function, symbol)) return;
        const auto [seen, is_new] = seen_.emplace(symbol, Seen{arity, offset});
        if (seen->second.arity != arity)
            scanner_.fail_at(offset,
                             "the module " + symbol + " has " + std::to_string(arity) +
                                 " parameters here and " + std::to_string(seen->second.arity) +
                                 " in line " +
                                 std::to_string(scanner_.source().place(seen->second.offset).line));
        if (is_new) open_.push_back(symbol);
    }

    static std::string shown(const std::string& symbol) { return symbol == "\\" ? "?" : symbol; }

    /// Whether it is L -> [["F",L]].
    static bool is_identity(const MapleValue& function, const std::string& symbol) {
        const MapleValue& list = function.items.front();
        if (list.items.size() != 1 || list.items[0].items.size() != 2) return false;
        const std::vector<MapleValue>& module = list.items[0].items;
        return module[0].kind == MapleValue::Kind::text && module[0].text == symbol &&
               module[1].kind == MapleValue::Kind::parameters;
    }

    void read_rule(const std::string& letter) {
        const MapleValue& function = *values_.sheet().find(letter);
        const std::size_t arity = seen_.at(letter).arity;
        Production rule;
        rule.predecessor.symbol = system_.alphabet.symbol(letter);
        for (std::size_t i = 1; i <= arity; ++i)
            rule.predecessor.parameters.push_back(entry(function.parameters, i).name);
        rule.successor = word(function.items.front(), arity);
        bool stays = rule.successor.letters == Word{rule.predecessor.symbol};
        const auto arguments = rule.successor.arguments.find(0);
        const std::size_t kept =
            arguments == rule.successor.arguments.end() ? 0 : arguments->second.size();
        stays = stays && kept == arity;
        for (std::size_t i = 0; stays && i < arity; ++i)
            stays = arguments->second[i] == entry(function.parameters, i + 1);
        if (!stays) rules_.emplace(letter, std::move(rule));
    }

    /// L[1] becomes p1, or a longer name where a constant is called so.
    void name_parameters() {
        std::string prefix = "p";
        for (const auto& [name, value] : values_.constants())
            while (name.starts_with(prefix)) prefix += 'p';
        for (Production& rule : system_.rules) {
            for (std::string& name : rule.predecessor.parameters) name = prefix + number_in(name);
            for (auto& [position, arguments] : rule.successor.arguments)
                for (Expression& argument : arguments) rename(argument, prefix);
        }
    }

    static std::string number_in(const std::string& entry) {
        const std::size_t open = entry.find('[');
        return entry.substr(open + 1, entry.size() - open - 2);
    }

    static void rename(Expression& expression, const std::string& prefix) {
        if (expression.kind == Expression::Kind::name && expression.name.ends_with(']'))
            expression.name = prefix + number_in(expression.name);
        for (Expression& operand : expression.operands) rename(operand, prefix);
    }

    MapleValues& values_;
    const Scanner& scanner_;
    LSystem& system_;
    std::map<std::string, Seen> seen_;
    std::vector<std::string> open_;  // letters whose functions are still to be read
    std::map<std::string, Production> rules_;
    std::set<std::pair<std::string, std::size_t>> silent_;
};

}  // namespace

void read_maple_modules(MapleValues& values, LSystem& system) { Reader(values, system).all(); }

}  // namespace algae
