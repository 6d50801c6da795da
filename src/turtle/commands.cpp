#include "turtle/turtle.hpp"

#include <algorithm>
#include <map>

#include "model/model.hpp"
#include "turtle/detail/module_turtle.hpp"
#include "turtle/detail/plane_figure.hpp"

// What letters tell a turtle in the plane, where they have no parameters.
//
// A symbol means what its name says (F, +, [ ...) unless the system interprets it: then it means the
// commands of its interpretation, and so on until only symbols without one are left. The commands of
// each symbol are worked out once. Interpretations are plain rules here; one with parameters, contexts
// or probabilities needs ModuleTurtle, and one that comes back to itself is an error.

namespace algae {

namespace {

static_assert(static_cast<int>(Command::cut) == static_cast<int>(TurtleOperation::cut),
              "commands are the first operations, in their order");

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
        if (!rule.left.empty() || !rule.right.empty() || !rule.elsewhere.empty() ||
            rule.condition || rule.probability || rule.shape ||
            !rule.predecessor.parameters.empty() || !rule.successor.arguments.empty() ||
            !rule.successor.splices.empty())
            throw Error(to_string(rule.place) + ": the interpretation of " + name +
                        " is not a plain rule: drawing needs one without context, condition, "
                        "probability or parameters");
        if (!rules.emplace(rule.predecessor.symbol, &rule).second)
            throw Error(to_string(rule.place) + ": " + name +
                        " has two interpretations, expected one");
    }
    return rules;
}

/// Works out the commands of symbols, each once. Interpretations may be long chains, so those begun
/// stand on a path of their own and not on the machine's stack.
class Reader {
public:
    explicit Reader(const Model& system)
        : system_(system),
          rules_(interpretation(system)),
          known_(system.alphabet.size(), State::unread),
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
        if (commands_[a].size() > largest)
            fail(a, " has more than " + std::to_string(largest) + " commands");
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
        if (turns_out_of_plane(name) || leaves(system_.drawing.solids, a)) refuse_space(system_, a);
        if (leaves(system_.drawing.surfaces, a))
            throw Error("the symbol " + name + " leaves a surface, expected segments only");
        const TurtleOperation operation = named_operation(name, system_.drawing, 0);
        if (operation <= TurtleOperation::cut)
            commands_[a].push_back(static_cast<Command>(operation));
    }

    [[noreturn]] void fail(Symbol a, const std::string& why) const {
        throw Error(to_string(rules_.at(a)->place) + ": the interpretation of " +
                    system_.alphabet.name(a) + why);
    }

    const Model& system_;
    std::map<Symbol, const Production*> rules_;
    std::vector<State> known_;
    std::vector<std::vector<Command>> commands_;
};

}  // namespace

Commands::Commands(const Model& system, const std::vector<Symbol>& letters)
    : commands_(system.alphabet.size()) {
    Reader reader(system);
    for (const Symbol a : letters) {
        commands_[a] = reader.of(a);
        for (const Command command : commands_[a]) used_[static_cast<std::size_t>(command)] = true;
    }
}

void refuse_space(const LSystem& system, Symbol symbol) {
    throw Error("the symbol " + system.alphabet.name(symbol) +
                " leaves the plane: " + (system.name.empty() ? "this" : system.name) +
                " is a figure in space, expected one in the plane");
}

Integer drawn_segments(const Commands& commands, const std::vector<Symbol>& letters,
                       const std::vector<Integer>& counts) {
    Integer sum = 0;
    for (std::size_t i = 0; i < letters.size(); ++i) {
        const auto& does = commands.of(letters[i]);
        const auto drawn = std::count_if(does.begin(), does.end(), [](Command command) {
            return command == Command::draw || command == Command::draw_unmarked;
        });
        if (drawn > 0) sum += counts[i] * Integer(drawn);
    }
    return sum;
}

}  // namespace algae
