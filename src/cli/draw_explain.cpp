#include "cli/draw_explain.hpp"

#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/error.hpp"
#include "cli/command.hpp"
#include "cli/draw_motion.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "render/explanation_page.hpp"
#include "render/explanation_table.hpp"
#include "space/space_figure.hpp"
#include "turtle/derived_modules.hpp"
#include "turtle/explanation.hpp"

namespace algae::cli {

namespace {

/// The word of a generation, if it is short enough to be explained.
std::optional<DerivedModules> short_word(const LSystem& system, std::uint64_t n,
                                         const PlateChoices& choices, Budget budget,
                                         std::string& length) {
    constexpr std::uint64_t countable = 1'000'000;
    budget.letters = std::min(budget.letters, countable);
    try {
        DerivedModules found = word_to_walk(system, n, choices, budget);
        length = std::to_string(found.word.kinds.size());
        if (found.word.kinds.size() <= longest_explanation) return found;
    } catch (const BoundReached& bound) {
        if (bound.bound() != Bound::letters) throw;
        length = "more than " + std::to_string(budget.letters);
    }
    return std::nullopt;
}

/// The last generation up to this one of those that begin with short words.
std::optional<std::uint64_t> last_short(const LSystem& system, std::uint64_t most,
                                        const PlateChoices& choices, const Budget& budget) {
    constexpr std::uint64_t enough = 200;
    std::optional<std::uint64_t> found;
    std::string length;
    for (std::uint64_t n = 0; n <= std::min(most, enough); ++n) {
        if (!choices.tables.empty() && choices.tables.size() < n) break;
        if (!short_word(system, n, choices, budget, length)) break;
        found = n;
    }
    return found;
}

nlohmann::ordered_json place(const Vector& at) {
    return nlohmann::ordered_json::array({at.x, at.y, at.z});
}

nlohmann::ordered_json as_json(const TurtleState& state) {
    nlohmann::ordered_json out;
    out["position"] = place(state.position);
    out["heading"] = place(state.attitude.heading());
    const auto angle = heading_angle(state);
    out["angle"] = angle ? nlohmann::ordered_json(*angle) : nlohmann::ordered_json(nullptr);
    return out;
}

nlohmann::ordered_json as_json(const Explanation& explanation, std::uint64_t n) {
    nlohmann::ordered_json out;
    out["generation"] = n;
    out["word"] = explanation.word;
    out["start"] = as_json(explanation.start);
    out["steps"] = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < explanation.steps.size(); ++i) {
        const ExplainedStep& step = explanation.steps[i];
        nlohmann::ordered_json one;
        one["step"] = i + 1;
        one["symbol"] = step.symbol;
        one["meaning"] = step.meaning;
        one.update(as_json(step.after));
        one["open"] = step.open;
        one["strokes"] = nlohmann::ordered_json::array();
        for (const ExplainedLine& line : step.lines)
            if (line.drawn) one["strokes"].push_back({place(line.from), place(line.to)});
        out["steps"].push_back(std::move(one));
    }
    return out;
}

std::size_t characters(const std::string& text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

/// The rows in columns, two blanks between them.
std::string as_text(const Explanation& explanation) {
    const auto rows = explanation_rows(explanation);
    std::vector<std::size_t> widths(rows.front().size());
    for (const auto& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i)
            widths[i] = std::max(widths[i], characters(row[i]));
    std::string out;
    for (const auto& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string blanks(widths[i] - characters(row[i]), ' ');
            line += (i == 0 ? blanks + row[i] : row[i] + blanks) + "  ";
        }
        line.erase(line.find_last_not_of(' ') + 1);
        out += line + '\n';
    }
    return out;
}

}  // namespace

int explain(const LSystem& system, const ExplainRequest& request, const Budget& budget) {
    const PlateChoices& choices = request.choices;
    if (!leaves_plane(system)) choices.space.check_unused(system.name);
    std::uint64_t n = 0;
    if (request.generation.empty()) {
        const std::uint64_t shown =
            system.settings.generations ? system.settings.generations->second : 0;
        n = last_short(system, shown, choices, budget).value_or(0);
    } else {
        const auto wished = range("-n", request.generation);
        if (wished.first != wished.second)
            throw Error("-n " + request.generation + ": --explain shows one generation");
        n = wished.first;
    }
    std::string length;
    const std::optional<DerivedModules> derived = short_word(system, n, choices, budget, length);
    if (!derived) {
        const auto shorter = n > 0 ? last_short(system, n - 1, choices, budget) : std::nullopt;
        throw Error("generation " + std::to_string(n) +
                    (system.name.empty() ? "" : " of " + system.name) + " has " + length +
                    " symbols: --explain shows words of at most " +
                    std::to_string(longest_explanation) +
                    (shorter ? ", such as -n " + std::to_string(*shorter) : "") +
                    "; --progressive draws longer ones step by step");
    }
    const Explanation explained =
        explanation(system, derived->kinds, derived->word, n, derived->seed, budget);
    if (!request.output.empty()) {
        const std::string named =
            request.format.empty() ? request.output : "figure." + request.format;
        PictureOptions picture = request.picture;
        if (picture.colours.empty()) picture.colours = system.settings.colours;
        const std::string title =
            (system.title.empty() ? system.name : system.title) + ", n = " + std::to_string(n);
        if (request.output == "-")
            draw_explanation(explained, title, std::cout, picture_format(named), picture, budget);
        else
            draw_explanation(explained, title, request.output, picture_format(named), picture,
                             budget);
    }
    if (request.json)
        print(as_json(explained, n).dump(2) + "\n");
    else if (request.output.empty())
        print(explained.word + "\n" + as_text(explained));
    return success;
}

}  // namespace algae::cli
