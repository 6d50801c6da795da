#include "turtle/commands.hpp"

#include <map>
#include <optional>
#include <string>

#include "base/error.hpp"

namespace algae {

namespace {

std::optional<Command> own_command(const std::string& name, const Settings& settings) {
    if (name == "F" || name.starts_with("F_")) return Command::draw;
    if (name == "f" || name.starts_with("f_")) return Command::move;
    if (name.size() != 1) return std::nullopt;
    switch (name[0]) {
        case 'G': return Command::draw_unmarked;
        case '+': return Command::left;
        case '-': return Command::right;
        case '|': return Command::back;
        case '[': return Command::push;
        case ']': return Command::pop;
        case '{': return Command::open_polygon;
        case '}': return Command::close_polygon;
        case '.': return Command::vertex;
        case '\'': return Command::next_colour;
        case '%': return Command::cut;
        case '*': return settings.scale ? std::optional(Command::scale) : std::nullopt;
        case '!': return settings.narrow ? std::optional(Command::narrow) : std::nullopt;
        default: return std::nullopt;
    }
}

bool needs_space(const std::string& name) {
    return name == "&" || name == "^" || name == "\\" || name == "/" || name == "$";
}

/// The interpretation rules by predecessor.
std::map<Symbol, const Production*> interpretation(const LSystem& system) {
    std::map<Symbol, const Production*> rules;
    for (const Production& rule : system.interpretation) {
        const std::string& name = system.alphabet.name(rule.predecessor.symbol);
        if (!rule.left.empty() || !rule.right.empty() || !rule.elsewhere.empty() || rule.condition ||
            rule.probability || rule.shape || !rule.predecessor.parameters.empty() ||
            !rule.successor.arguments.empty())
            throw Error(to_string(rule.place) + ": the interpretation of " + name +
                        " is not a plain rule: drawing needs one without context, condition, "
                        "probability or parameters");
        if (!rules.emplace(rule.predecessor.symbol, &rule).second)
            throw Error(to_string(rule.place) + ": " + name + " has two interpretations, expected one");
    }
    return rules;
}

class Reader {
public:
    Reader(const LSystem& system) : system_(system), rules_(interpretation(system)) {}

    void read(Symbol a, std::vector<Command>& into, std::size_t depth) {
        if (const auto rule = rules_.find(a); rule != rules_.end()) {
            if (depth > rules_.size())
                throw Error(to_string(rule->second->place) + ": the interpretation of " +
                            system_.alphabet.name(a) + " goes round in circles");
            for (const Symbol b : rule->second->successor.letters) read(b, into, depth + 1);
            if (into.size() > largest)
                throw Error(to_string(rule->second->place) + ": the interpretation of " +
                            system_.alphabet.name(a) + " has more than " + std::to_string(largest) +
                            " commands");
            return;
        }
        const std::string& name = system_.alphabet.name(a);
        if (needs_space(name))
            throw Error("the symbol " + name + " turns the turtle out of the plane: " + system_.name +
                        " is a figure in space, and only plane figures can be drawn");
        if (const auto command = own_command(name, system_.settings)) into.push_back(*command);
    }

private:
    static constexpr std::size_t largest = 100'000;
    const LSystem& system_;
    std::map<Symbol, const Production*> rules_;
};

}  // namespace

Commands::Commands(const LSystem& system, const std::vector<Symbol>& letters)
    : commands_(system.alphabet.size()) {
    Reader reader(system);
    for (const Symbol a : letters) {
        reader.read(a, commands_[a], 0);
        for (const Command command : commands_[a]) used_[static_cast<std::size_t>(command)] = true;
    }
}

}  // namespace algae
