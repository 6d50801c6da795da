#include "exchange/maple_words.hpp"

#include <set>

#include "notation/characters.hpp"
#include "notation/lexicon.hpp"

namespace algae {

namespace {

/// Adds axiom and rules of strings.
class Reader {
public:
    Reader(MapleValues& values, LSystem& system)
        : values_(values),
          scanner_(values.scanner()),
          system_(system),
          form_(values.sheet().arguments.size() == 5 ? MapleForm::stochastic : MapleForm::strings) {
    }

    void all() {
        const auto& arguments = values_.sheet().arguments;
        system_.axiom.letters = word(values_.text(arguments[0], "the axiom, a string"));
        rules(values_.list(arguments[1], "the rules, a list of strings"));
        if (form_ == MapleForm::stochastic)
            probabilities(arguments[2], values_.list(arguments[2], "a list of probabilities"));
    }

private:
    Word word(const MapleValue& text) {
        Word letters;
        MapleBrackets brackets(scanner_);
        for (std::size_t i = 0; i < text.text.size();) {
            const std::string_view rest = std::string_view(text.text).substr(i);
            const std::size_t bytes = first_character(rest).bytes, offset = text.offset + 1 + i;
            const std::string symbol = maple_symbol(scanner_, form_, rest.substr(0, bytes), offset);
            if (symbol == "[" || symbol == "]") check_kind(rest[0], offset);
            brackets.meet(symbol, offset);
            letters.push_back(known(symbol, offset));
            i += bytes;
        }
        brackets.end();
        return letters;
    }

    /// The stochastic procedure is printed with ( and ) for brackets; a worksheet has one kind.
    void check_kind(char character, std::size_t offset) {
        const bool round = character == '(' || character == ')';
        if (!round_) round_ = round;
        if (*round_ != round)
            scanner_.fail_at(offset, std::string("brackets are written ") +
                                         (*round_ ? "( )" : "[ ]") + " before, found '" +
                                         character + "'");
    }

    Symbol known(const std::string& name, std::size_t offset) {
        if (const auto found = system_.alphabet.find(name)) return *found;
        const Symbol symbol = system_.alphabet.symbol(name);
        const MapleMeaning meaning = maple_meaning(form_, name);
        if (meaning == MapleMeaning::refused)
            scanner_.fail_at(
                offset,
                quoted(name) + " turns the turtle in space, and is nothing to this procedure");
        if (meaning == MapleMeaning::none) {
            Production silent;
            silent.predecessor.symbol = symbol;
            system_.interpretation.push_back(std::move(silent));
        }
        return symbol;
    }

    void rules(const MapleValue& list) {
        for (std::size_t i = 0; i < list.items.size(); i += 2) {
            const MapleValue& left = values_.text(list.items[i], "a predecessor, a string");
            const Word predecessor = word(left);
            if (predecessor.size() != 1)
                values_.fail(list.items[i],
                             "expected a predecessor of one character, found " + quoted(left.text));
            if (i + 1 == list.items.size())
                values_.fail(list.items[i],
                             "the predecessor " + quoted(left.text) + " has no successor");
            check_new(list.items[i], predecessor.front());
            Production rule;
            rule.predecessor.symbol = predecessor.front();
            rule.successor.letters = word(values_.text(list.items[i + 1], "a successor, a string"));
            system_.rules.push_back(std::move(rule));
        }
    }

    void check_new(const MapleValue& left, Symbol predecessor) {
        const bool is_new = predecessors_.insert(predecessor).second;
        const auto name = [&](Symbol symbol) { return quoted(system_.alphabet.name(symbol)); };
        if (form_ == MapleForm::strings && !is_new)
            values_.fail(left, "a second rule for " + name(predecessor) +
                                   ", which the procedure never uses");
        if (form_ == MapleForm::stochastic && predecessors_.size() > 1)
            values_.fail(left,
                         "a rule for " + name(predecessor) + " behind one for " +
                             name(system_.rules.front().predecessor.symbol) +
                             "; the probabilities are those of all rules, for one predecessor");
    }

    void probabilities(const MapleValue& argument, const MapleValue& list) {
        if (list.items.size() != system_.rules.size())
            values_.fail(argument, "expected a probability for each of the " +
                                       std::to_string(system_.rules.size()) + " rules, found " +
                                       std::to_string(list.items.size()));
        Rational sum;
        for (const MapleValue& item : list.items) {
            const Rational probability = values_.rational(item, "a probability");
            if (sign(probability) <= 0)
                values_.fail(item,
                             "expected a probability above 0, found " + shortest_text(probability));
            sum += probability;
        }
        if (!list.items.empty() && sum != 1 && sum != 100)
            values_.fail(argument, "the probabilities add up to " + shortest_text(sum) +
                                       ", expected 100, of percentages, or 1");
        for (std::size_t i = 0; i < list.items.size(); ++i)
            system_.rules[i].probability = values_.rational(list.items[i], "a probability") / sum;
    }

    MapleValues& values_;
    const Scanner& scanner_;
    LSystem& system_;
    MapleForm form_;
    std::set<Symbol> predecessors_;
    std::optional<bool> round_;
};

}  // namespace

std::string maple_symbol(const Scanner& scanner, MapleForm form, std::string_view character,
                         std::size_t offset) {
    if (character == "?") return "\\";
    if (form == MapleForm::stochastic && character == "(") return "[";
    if (form == MapleForm::stochastic && character == ")") return "]";
    if (character == "\\")
        scanner.fail_at(offset, "expected '?', which stands for the backslash, found '\\'");
    if (undeclared_length(character) != character.size())
        scanner.fail_at(offset, "expected a symbol, found " + quoted(character));
    return std::string(character);
}

void MapleBrackets::meet(const std::string& symbol, std::size_t offset) {
    if (symbol == "[") open_.push_back(offset);
    if (symbol != "]") return;
    if (open_.empty()) scanner_.fail_at(offset, "a bracket that closes none");
    open_.pop_back();
}

void MapleBrackets::end() const {
    if (!open_.empty()) scanner_.fail_at(open_.back(), "a bracket that is never closed");
}

void read_maple_words(MapleValues& values, LSystem& system) { Reader(values, system).all(); }

}  // namespace algae
