#include "environment/environments.hpp"

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "environment/collision.hpp"
#include "environment/light.hpp"
#include "environment/whereabouts.hpp"

namespace algae {

namespace {

/// What is set for a module; nullptr if nothing is.
const EnvironmentSetting* setting_of(const LSystem& system, Symbol module) {
    for (const EnvironmentSetting& setting : system.environments)
        if (setting.module == module) return &setting;
    static const EnvironmentSetting position{0, "position", {}}, heading{0, "heading", {}};
    const std::string& name = system.alphabet.name(module);
    return name == "?P" ? &position : name == "?H" ? &heading : nullptr;
}

std::vector<std::size_t> arities(const std::string& kind) {
    if (kind == "external") return {};
    if (kind == "position") return {1, 2, 3};
    if (kind == "heading") return {1, 3};
    return {1};
}

std::shared_ptr<Environment> environment_of(const EnvironmentSetting& setting) {
    if (setting.kind == "collision")
        return std::make_shared<CollisionEnvironment>(setting.numbers.at(0).value);
    if (setting.kind == "light")
        return std::make_shared<LightEnvironment>(setting.numbers.at(0).value);
    return std::make_shared<Whereabouts>(setting);
}

std::string in_words(const std::vector<std::size_t>& counts) {
    std::string out;
    for (const std::size_t count : counts)
        out += (out.empty() ? "" : " or ") + std::to_string(count);
    return out + (counts.back() == 1 ? " parameter" : " parameters");
}

}  // namespace

Environments::Environments(const LSystem& system, std::shared_ptr<Environment> external) {
    for (Symbol module = 0; module < system.alphabet.size(); ++module) {
        const std::string& name = system.alphabet.name(module);
        if (!is_communication(name)) continue;
        const EnvironmentSetting* setting = setting_of(system, module);
        if (!setting)
            throw Error("nothing fills the communication module " + name +
                        "; expected a setting such as `environment " + name + " position`");
        if (setting->kind == "external" && !external)
            throw ProgramWanted("the communication module " + name +
                                " is filled by a program; say by which");
        asked_.push_back({name, setting->kind,
                          setting->kind == "external" ? external : environment_of(*setting),
                          arities(setting->kind)});
        if (std::count(all_.begin(), all_.end(), asked_.back().environment) == 0)
            all_.push_back(asked_.back().environment);
    }
}

const Environments::Asked& Environments::asked_by(const std::string& name) const {
    return *std::find_if(asked_.begin(), asked_.end(),
                         [&](const Asked& asked) { return asked.name == name; });
}

std::vector<std::vector<double>> Environments::answers(const Traversal& course, const Budget& budget) {
    std::vector<const Environment*> environments;  // by query
    for (const Query& query : course.queries) {
        const Asked& asked = asked_by(query.name);
        const std::size_t count = query.parameters.size();
        if (!asked.arities.empty() &&
            std::count(asked.arities.begin(), asked.arities.end(), count) == 0)
            throw Error(place_of(query, course) + ": expected " + in_words(asked.arities) +
                        ", which `" + asked.kind + "` fills, found " + std::to_string(count));
        environments.push_back(asked.environment.get());
    }
    std::vector<std::vector<double>> out(course.queries.size());
    for (const auto& environment : all_) {
        std::vector<const Query*> queries;
        for (std::size_t i = 0; i < out.size(); ++i)
            if (environments[i] == environment.get()) queries.push_back(&course.queries[i]);
        auto answers = environment->answers(course, queries, budget);
        std::size_t next = 0;
        for (std::size_t i = 0; i < out.size(); ++i)
            if (environments[i] == environment.get()) out[i] = std::move(answers.at(next++));
    }
    return out;
}

bool asks_program(const LSystem& system) {
    return std::any_of(
        system.environments.begin(), system.environments.end(),
        [](const EnvironmentSetting& setting) { return setting.kind == "external"; });
}

}  // namespace algae
