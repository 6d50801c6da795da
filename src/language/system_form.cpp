#include "language/system_form.hpp"

#include <algorithm>
#include <charconv>

namespace algae {

namespace {

bool take(std::string_view& text, std::string_view token) {
    if (!text.starts_with(token)) return false;
    text.remove_prefix(token.size());
    return true;
}

std::optional<std::size_t> take_number(std::string_view& text) {
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc()) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return number;
}

/// `(1,0)L`, from behind its first bracket.
std::optional<std::pair<std::size_t, std::size_t>> take_context(std::string_view& text) {
    const auto left = take_number(text);
    if (!left || !take(text, ",")) return std::nullopt;
    const auto right = take_number(text);
    if (!right || !take(text, ")L")) return std::nullopt;
    return std::pair{*left, *right};
}

/// The longest left and right contexts, and whether no rule is erasing.
bool has_form(const IL& system, const SystemForm& form) {
    std::size_t left = 0, right = 0;
    bool erasing = false;
    for (const auto& rules : system.rules)
        for (const IL::Rule& rule : rules) {
            left = std::max(left, rule.left.size());
            right = std::max(right, rule.right.size());
            erasing = erasing || rule.successor.empty();
        }
    if (form.propagating && erasing) return false;
    if (form.one_sided) return left + right <= 1;
    return !form.context || (left <= form.context->first && right <= form.context->second);
}

}  // namespace

std::optional<SystemForm> system_form(std::string_view name) {
    SystemForm form;
    form.extended = take(name, "E");
    form.propagating = take(name, "P");
    form.deterministic = take(name, "D");
    form.tables = take(name, "T");
    if (name == "0L") return form;
    if (form.extended || form.tables) return std::nullopt;
    form.interactive = true;
    if (name == "1L") {
        form.one_sided = true;
    } else if (name == "2L") {
        form.context = {1, 1};
    } else if (take(name, "(")) {
        form.context = take_context(name);
        if (!form.context || !name.empty()) return std::nullopt;
    } else if (name != "IL") {
        return std::nullopt;
    }
    return form;
}

bool has_form(const SourceSystem& system, const SystemForm& form) {
    if (!system.tables) return form.interactive && has_form(*system.interactive, form);
    const ET0L& tables = *system.tables;
    if (tables.tables.size() > 1 && !form.tables) return false;
    if (!has_only_terminals(tables) && !form.extended) return false;
    if (form.deterministic && !is_deterministic(tables)) return false;
    return !form.propagating || is_propagating(tables);
}

}  // namespace algae
