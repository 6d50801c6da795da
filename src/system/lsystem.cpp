#include "system/lsystem.hpp"

#include <algorithm>

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

bool LSystem::operator==(const LSystem& other) const {
    return title == other.title && source == other.source && identifiers == other.identifiers &&
           alphabet == other.alphabet && declared == other.declared &&
           constants == other.constants && inner == other.inner && axiom == other.axiom &&
           rules == other.rules && tables == other.tables && schedule == other.schedule &&
           ignored == other.ignored && terminals == other.terminals &&
           interpretation == other.interpretation && environments == other.environments &&
           settings == other.settings && expectations == other.expectations;
}

}  // namespace algae
