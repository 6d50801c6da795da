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

/// Whether the symbol has one of these solids or surfaces.
template <class Setting>
bool leaves(const std::vector<Setting>& settings, Symbol symbol) {
    for (const Setting& setting : settings)
        if (setting.symbol == symbol) return true;
    return false;
}

/// The interpretation rules by predecessor.
std::map<Symbol, const Production*> interpretation(const LSystem& system) {
    std::map<Symbol, const Production*> rules;
    for (const Production& rule : system.interpretation) {
        const std::string& name = system.alphabet.name(rule.predecessor.symbol);
        if (!rule.left.empty() || !rule.right.empty() || !rule.elsewhere.empty() || rule.condition ||
            rule.probability || rule.shape || !rule.predecessor.parameters.empty() ||
            !rule.successor.arguments.empty() || !rule.successor.splices.empty())
            throw Error(to_string(rule.place) + ": the interpretation of " + name +
                        " is not a plain rule: drawing needs one without context, condition, "
                        "probability or parameters");
        if (!rules.emplace(rule.predecessor.symbol, &rule).second)
            throw Error(to_string(rule.place) + ": " + name + " has two interpretations, expected one");
    }
    return rules;
}

/// Works out the commands of symbols, each once. Interpretations may be long chains, so those begun
/// stand on a path of their own and not on the machine's stack.
class Reader {
public:
    explicit Reader(const LSystem& system)
        : system_(system), rules_(interpretation(system)), known_(system.alphabet.size(), State::unread),
          commands_(system.alphabet.size()) {}

    const std::vector<Command>& of(Symbol wanted) {
        std::vector<Begun> path;
        visit(wanted, path);
        while (!path.empty()) {
            const Symbol a = path.back().symbol;
            const Word& successor = rules_.at(a)->successor.letters;
            if (path.back().next == successor.size()) {
                known_[a] = State::read;
                path.pop_back();
                if (!path.empty()) take(path.back().symbol, a);
                continue;
            }
            const Symbol b = successor[path.back().next++];
            if (known_[b] == State::begun) fail(a, " goes round in circles");
            if (known_[b] == State::unread) visit(b, path);
            if (known_[b] == State::read) take(a, b);
        }
        return commands_[wanted];
    }

private:
    enum class State : unsigned char { unread, begun, read };
    static constexpr std::size_t largest = 100'000;
    struct Begun {
        Symbol symbol;
        std::size_t next = 0;  // place in its interpretation
    };

    void take(Symbol a, Symbol part) {
        commands_[a].insert(commands_[a].end(), commands_[part].begin(), commands_[part].end());
        if (commands_[a].size() > largest) fail(a, " has more than " + std::to_string(largest) + " commands");
    }

    /// Reads a symbol without interpretation; puts one with an interpretation on the path.
    void visit(Symbol a, std::vector<Begun>& path) {
        if (known_[a] == State::read) return;
        if (rules_.contains(a)) {
            known_[a] = State::begun;
            path.push_back({a});
            return;
        }
        known_[a] = State::read;
        const std::string& name = system_.alphabet.name(a);
        if (needs_space(name) || leaves(system_.settings.solids, a)) refuse_space(system_, a);
        if (leaves(system_.settings.surfaces, a))
            throw Error("the symbol " + name + " leaves a surface, expected segments only");
        if (const auto command = own_command(name, system_.settings)) commands_[a].push_back(*command);
    }

    [[noreturn]] void fail(Symbol a, const std::string& why) const {
        throw Error(to_string(rules_.at(a)->place) + ": the interpretation of " + system_.alphabet.name(a) + why);
    }

    const LSystem& system_;
    std::map<Symbol, const Production*> rules_;
    std::vector<State> known_;
    std::vector<std::vector<Command>> commands_;
};

}  // namespace

Commands::Commands(const LSystem& system, const std::vector<Symbol>& letters)
    : commands_(system.alphabet.size()) {
    Reader reader(system);
    for (const Symbol a : letters) {
        commands_[a] = reader.of(a);
        for (const Command command : commands_[a]) used_[static_cast<std::size_t>(command)] = true;
    }
}

void refuse_space(const LSystem& system, Symbol symbol) {
    throw Error("the symbol " + system.alphabet.name(symbol) + " leaves the plane: " +
                (system.name.empty() ? "this" : system.name) +
                " is a figure in space, expected one in the plane");
}

}  // namespace algae
