// Systems for Python: reading them from texts, files and the gallery, the words of their generations, letters far into a word.
//
// A source means what FILE means to the command: a path, a name of the gallery, or a system as one types it on a line. Words are
// derived as `algae derive` derives them: D0L systems by their morphism, systems with context by a development, all others by one
// rewriting whose numbers are exact while words are short.

#include <filesystem>
#include <fstream>
#include <sstream>

#include "exchange/exchange.hpp"
#include "growth/growth.hpp"
#include "notation/notation.hpp"
#include "python/detail/running.hpp"
#include "python/detail/values.hpp"
#include "render/render.hpp"
#include "report/report.hpp"
#include "turtle/turtle.hpp"

namespace algae::python {

namespace {

/// Constants of a system and what they are to be: texts of expressions.
using Constants = std::vector<std::pair<std::string, std::string>>;

ConstantValues values_of(const Constants& let) {
    ConstantValues values;
    for (const auto& [name, text] : let) {
        const auto none = [](const std::string&) -> const Quantity* { return nullptr; };
        try {
            values.emplace_back(name, evaluate(read_expression(text), none));
        } catch (const Diagnostics& error) {
            throw Error("let: the value of " + name + ", " + algae::quoted(text) + ": " +
                        error.findings().front().message);
        }
    }
    return values;
}

SystemObject made(Model model) { return {std::make_shared<const Model>(std::move(model))}; }

/// The same system under another name, if one is given.
SystemObject renamed(SystemObject system, const std::optional<std::string>& name) {
    if (!name) return system;
    Model model = *system;
    model.name = *name;
    return made(std::move(model));
}

SystemObject read_system(const std::string& text, const std::string& name, const Constants& let) {
    return made(read_lsystem(text, name, values_of(let)));
}

const GalleryEntry* gallery_entry(const std::string& name) {
    for (const GalleryEntry& entry : gallery())
        if (entry.name == name) return &entry;
    return nullptr;
}

std::string file_text(const std::string& path) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        throw Error(path + ": is a folder, expected a file");
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    if (in) text << in.rdbuf();
    if (!in) throw Error("cannot read " + path);
    return text.str();
}

/// A file of a system in the notation, or in another program's format by the end of its name; one of cpfg with the files beside it and those
/// that it includes.
SystemObject open_file(const std::string& path, const Constants& let) {
    if (const std::optional<CpfgFiles> files = cpfg_files_at(path, file_text)) {
        Model model = cpfg_model(*files, file_text);
        if (!let.empty()) return read_system(print_lsystem(model), files->system, let);
        return made(std::move(model));
    }
    const auto [file, entry] = file_and_entry(path);
    const std::string text = text_with_included(entry.empty() ? path : file, file_text);
    if (const GeneratorKind* kind = generator_kind(file))
        throw Error(path + " is " + kind->what + ", expected an L-system");
    const SystemFormat* format = system_format(path);
    if (!format && !path.ends_with(".lsys")) format = system_format_of(text);
    if (!format) return read_system(text, path, let);
    Model model = format->read(text, path);
    if (!let.empty()) return read_system(print_lsystem(model), path, let);
    return made(std::move(model));
}

/// What a source means. A name that is given is the system's: errors in a text that is typed call the text so.
SystemObject open_system(const std::string& source, const Constants& let,
                         const std::optional<std::string>& name) {
    std::error_code ignored;
    const auto [file, part] = file_and_entry(source);
    const bool is_line = source.find('\n') == std::string::npos;
    const std::string called = name.value_or("system");
    if (is_line && (std::filesystem::exists(source, ignored) ||
                    (!part.empty() && std::filesystem::exists(file, ignored))))
        return renamed(open_file(source, let), name);
    if (const GalleryEntry* entry = gallery_entry(source))
        return renamed(read_system(std::string(entry->text), source, let), name);
    if (!is_line) return read_system(source, called, let);
    if (is_typed_system(source) && !source.ends_with(".lsys"))
        return made(read_typed_system(source, called, values_of(let)));
    std::vector<std::string> names;
    for (const GalleryEntry& entry : gallery()) names.emplace_back(entry.name);
    throw Error("no file " + algae::quoted(source) + ", and nothing of that name in the gallery" +
                did_you_mean(source, names) + "; a system is typed with arrows: 'a -> ab, b -> a'");
}

std::vector<std::string> names_of(const Alphabet& alphabet) {
    std::vector<std::string> names;
    for (Symbol letter = 0; letter < alphabet.size(); ++letter)
        names.push_back(alphabet.name(letter));
    return names;
}

// Words of generations

/// Throws BoundReached with the length, if the word of a generation is too long.
void check_length(const D0L& system, std::uint64_t n, const Budget& budget) {
    constexpr double worked_out = 4096;  // binary digits
    const double estimate = estimated_log2_length(system, n, budget);
    std::string count;
    if (estimate <= worked_out) {
        const Integer letters = length(system, n, budget);
        const std::uint64_t most =
            std::min<std::uint64_t>(budget.letters, budget.memory / sizeof(Symbol));
        if (letters <= Integer(most)) return;
        count = readable(letters);
    } else {
        count = "about 10^" +
                std::to_string(static_cast<std::uint64_t>(estimate * 0.30102999566398120));
    }
    throw BoundReached(Bound::letters, "generation " + std::to_string(n) + " has " + count +
                                           " letters, more than the " +
                                           std::to_string(budget.letters) + " allowed" +
                                           budget.by(Bound::letters) +
                                           "; a slice of word(n) gives any part of it, length(n) "
                                           "its length, draw(n) its picture");
}

/// The word after the coding of the system, if it has one.
WordObject shown(const Model& model, const std::shared_ptr<const Alphabet>& alphabet, Word word) {
    if (model.coding.empty()) return {alphabet, std::move(word)};
    const LetterCoding coding(model.alphabet, model.coding);
    return {std::make_shared<const Alphabet>(coding.alphabet), coding.morphism(word)};
}

std::shared_ptr<const Alphabet> alphabet_of(const SystemObject& system) {
    return {system.model, &system->alphabet};
}

/// What is picked where the system leaves a choice.
struct Picks {
    std::optional<std::uint64_t> seed;
    std::string tables;
};

WordObject derive_modules(const SystemObject& system, std::uint64_t n, const Picks& picks,
                          const Limits& limits) {
    constexpr std::size_t most_exact = 20'000;  // parameters; from then on they are doubles
    const Class kind = class_of(*system);
    const bool seeded = picks.seed.has_value();
    std::vector<std::size_t> tables;
    if (!picks.tables.empty())
        tables = table_sequence(system->tables, picks.tables);
    else if (leaves_tables_open(*system) && !seeded)
        throw Error("it has " + std::to_string(system->tables.size()) +
                    " tables and no schedule; say tables='...', or seed=S for random ones");
    if (!tables.empty() && tables.size() < n)
        throw Error("tables: expected a table for each of " + std::to_string(n) + " steps, found " +
                    std::to_string(tables.size()));
    auto data = std::make_shared<ModuleData>();
    std::shared_ptr<const Alphabet> alphabet;
    Word letters = run(limits, [&](const Budget& budget) {
        RewritingChoices choices;
        choices.seed = picks.seed.value_or(1);
        choices.evenly = !kind.stochastic && seeded;
        choices.random_tables = seeded;
        choices.arithmetic = kind.open ? Arithmetic::doubles : Arithmetic::exact;
        std::optional<OpenDevelopment> development;
        development.emplace(*system, choices, nullptr, budget);
        while (development->generation() < n) {
            const bool is_exact = choices.arithmetic == Arithmetic::exact;
            development->go_to(is_exact ? development->generation() + 1 : n, tables, budget);
            if (is_exact && development->word().values.size() > most_exact) {
                choices.arithmetic = Arithmetic::doubles;
                development.emplace(*system, choices, nullptr, budget);
            }
        }
        const CompiledRules& rules = development->rules();
        data->kinds = rules.kinds;
        data->word = development->word();
        alphabet = std::make_shared<const Alphabet>(rules.system->alphabet);
        return algae::letters(rules.kinds, data->word);
    });
    if (data->word.values.empty()) return shown(*system, alphabet, std::move(letters));
    WordObject found(alphabet, std::move(letters));
    found.modules = std::move(data);
    return found;
}

WordObject derived(const SystemObject& system, std::uint64_t n, std::optional<std::uint64_t> seed,
                   const std::string& tables, const Limits& limits) {
    const Class kind = class_of(*system);
    if (kind.shape)
        throw Error("a system of shape rules derives boxes, not words; boxes(n) gives them");
    const bool picked = seed || !tables.empty();
    const View<D0L> rules = as_d0l(*system);
    const View<IL> interactive = as_dil(*system);
    if (!picked && !rules && as_ol(*system))
        throw Error(rules.reason() +
                    "; say seed=S for a word picked at random, or words(n) for all of them");
    if (!picked && !rules && !interactive && as_il(*system))
        throw Error(interactive.reason() + "; say seed=S for a word picked at random");
    if (kind.open || picked || (!rules && !interactive))
        return derive_modules(system, n, {seed, tables}, limits);
    Word word = run(limits, [&](const Budget& budget) {
        if (!rules) return derive(*interactive, n, budget);
        check_length(*rules, n, budget);
        return derive(*rules, n, budget);
    });
    return shown(*system, alphabet_of(system), std::move(word));
}

/// Letters of a D0L system or one with context, from a position on.
WordObject letters_from(const SystemObject& system, std::uint64_t n, const Integer& at,
                        std::uint64_t count, const Limits& limits) {
    const View<D0L> rules = as_d0l(*system);
    const View<IL> interactive = as_dil(*system);
    Word word = run(limits, [&](const Budget& budget) {
        if (count > budget.letters)
            throw BoundReached(Bound::letters, "the part has " + std::to_string(count) +
                                                   " letters, more than the " +
                                                   std::to_string(budget.letters) + " allowed" +
                                                   budget.by(Bound::letters));
        if (rules || !interactive) return letters_at(*rules, n, at, count, budget);
        Word whole = derive(*interactive, n, budget);
        if (at >= Integer(whole.size())) return Word();
        const auto from = whole.begin() + at.to_int64();
        const auto rest = static_cast<std::uint64_t>(whole.end() - from);
        return Word(from, from + static_cast<std::ptrdiff_t>(std::min(rest, count)));
    });
    return shown(*system, alphabet_of(system), std::move(word));
}

std::vector<WordObject> objects(const std::shared_ptr<const Alphabet>& alphabet,
                                std::vector<Word> words) {
    std::vector<WordObject> all;
    for (Word& word : words) all.emplace_back(alphabet, std::move(word));
    return all;
}

/// All words of a generation of a system with choices.
std::vector<WordObject> words_of(const SystemObject& system, std::uint64_t n,
                                 std::optional<std::size_t> longest, const Limits& limits) {
    const View<OL> rules = as_ol(*system);
    const View<IL> interactive = as_il(*system);
    return objects(alphabet_of(system), run(limits, [&](const Budget& budget) {
                       return !rules && interactive
                                  ? words_of_generation(*interactive, n, longest, budget)
                                  : words_of_generation(*rules, n, longest, budget);
                   }));
}

/// Words of a generation with their exact probabilities.
std::vector<std::pair<std::string, Rational>> likely_words(const SystemObject& system,
                                                           std::uint64_t n,
                                                           const std::string& tables,
                                                           const Limits& limits) {
    return run(limits, [&](const Budget& budget) {
        const Rewriting rewriting(*system, {.evenly = false, .arithmetic = Arithmetic::exact},
                                  budget);
        const ModuleText text(rewriting.rules().system->alphabet, rewriting.rules().kinds);
        std::vector<std::size_t> sequence;
        if (!tables.empty()) sequence = table_sequence(system->tables, tables);
        std::vector<std::pair<std::string, Rational>> all;
        for (const LikelyWord& likely : distribution(rewriting, n, sequence, budget))
            all.emplace_back(text.text(likely.word), likely.probability);
        return all;
    });
}

std::vector<Rational> expected(const SystemObject& system, std::uint64_t n, const Limits& limits) {
    const View<S0L> rules = as_s0l(*system);
    return run(limits, [&](const Budget& budget) { return expected_counts(*rules, n, budget); });
}

/// The boxes of shape rules: symbol, lowest corner, sizes.
py::list boxes(const SystemObject& system, std::uint64_t n, const Limits& limits) {
    const View<ShapeSystem> shapes = as_shape(*system);
    const std::vector<ShapeBox> found = run(limits, [&](const Budget& budget) {
        return boxes_after(*shapes, shapes->axiom, n, budget);
    });
    py::list all;
    for (const ShapeBox& box : found) {
        let_signals_in(all.size());
        all.append(py::make_tuple(system->alphabet.name(box.symbol),
                                  py::make_tuple(box.origin[0], box.origin[1], box.origin[2]),
                                  py::make_tuple(box.size[0], box.size[1], box.size[2])));
    }
    return all;
}

/// The successors of each letter, where rules are those of an 0L system: for other programs.
std::vector<std::pair<std::string, std::vector<WordObject>>> successors(
    const SystemObject& system) {
    const View<OL> rules = as_ol(*system);
    std::vector<std::pair<std::string, std::vector<WordObject>>> all;
    for (Symbol letter = 0; letter < rules->successors.size(); ++letter)
        all.emplace_back(system->alphabet.name(letter),
                         objects(rules->alphabet, rules->successors[letter]));
    return all;
}

/// The generations that the file says are shown.
std::optional<std::pair<std::uint64_t, std::uint64_t>> shown_generations(
    const SystemObject& system) {
    return system->drawing.generations;
}

std::optional<Rational> angle(const SystemObject& system) {
    if (!system->drawing.angle) return std::nullopt;
    return system->drawing.angle->exact;
}

std::vector<std::pair<std::string, std::string>> constants(const SystemObject& system) {
    std::vector<std::pair<std::string, std::string>> all;
    for (const auto& [name, value] : system->constants)
        all.emplace_back(name, to_text(value.expression));
    return all;
}

std::vector<std::string> unmet(const SystemObject& system, const Limits& limits) {
    return run(limits, [&](const Budget& budget) {
        std::vector<std::string> all;
        for (const Mismatch& mismatch : unmet_expectations(*system, budget))
            all.push_back(to_string(mismatch.place) + ": " + mismatch.message);
        return all;
    });
}

}  // namespace

void add_systems(py::module_& module) {
    py::class_<SystemObject>(module, "System")
        .def("name", [](const SystemObject& system) { return system->name; })
        .def("title", [](const SystemObject& system) { return system->title; })
        .def("source", [](const SystemObject& system) { return system->source; })
        .def(
            "text", [](const SystemObject& system) { return print_lsystem(*system); }, Unlocked())
        .def("class_name", [](const SystemObject& system) { return class_of(*system).name(); })
        .def("alphabet", [](const SystemObject& system) { return names_of(system->alphabet); })
        .def("axiom",
             [](const SystemObject& system) { return print_word(system->alphabet, system->axiom); })
        .def("rules",
             [](const SystemObject& system) {
                 const Printer printer(system->alphabet);
                 std::vector<std::string> all;
                 for (const Production& rule : system->rules) all.push_back(printer.rule(rule));
                 return all;
             })
        .def("constants", constants)
        .def("successors", successors)
        .def("plain_axiom",
             [](const SystemObject& system) {
                 const View<OL> rules = as_ol(*system);
                 return WordObject(rules->alphabet, rules->axiom);
             })
        .def("tables", [](const SystemObject& system) { return system->tables; })
        .def("is_deterministic",
             [](const SystemObject& system) { return static_cast<bool>(as_d0l(*system)); })
        .def("has_context",
             [](const SystemObject& system) {
                 return !as_et0l(*system) && static_cast<bool>(as_il(*system));
             })
        .def("has_coding", [](const SystemObject& system) { return !system->coding.empty(); })
        .def("leaves_plane", [](const SystemObject& system) { return leaves_plane(*system); })
        .def("shown_generations", shown_generations)
        .def("angle", angle)
        .def(
            "report",
            [](const SystemObject& system) {
                return to_json(SystemReport{*system, class_of(*system)}).text(-1);
            },
            Unlocked())
        .def(
            "page",
            [](const SystemObject& system) {
                return to_text(SystemReport{*system, class_of(*system)});
            },
            Unlocked())
        .def(
            "latex", [](const SystemObject& system) { return to_latex(*system); }, Unlocked())
        .def(
            "converted",
            [](const SystemObject& system, const std::string& to) {
                const SystemFormat* format = system_format("x." + to);
                if (!format) {
                    std::vector<std::string> names;
                    for (const SystemFormat& known : system_formats()) names.push_back(known.name);
                    throw Error("expected a format of systems, " + listed(names) + ", found " +
                                algae::quoted(to));
                }
                return format->print(*system);
            },
            py::arg("to"), Unlocked())
        .def("equals", [](const SystemObject& system,
                          const SystemObject& other) { return *system == *other; })
        .def("derive", derived, py::arg("n"), py::arg("seed"), py::arg("tables"), py::arg("limits"))
        .def("letters_from", letters_from, py::arg("n"), py::arg("at"), py::arg("count"),
             py::arg("limits"))
        .def("words_of", words_of, py::arg("n"), py::arg("longest"), py::arg("limits"))
        .def("distribution", likely_words, py::arg("n"), py::arg("tables"), py::arg("limits"))
        .def("expected", expected, py::arg("n"), py::arg("limits"))
        .def("boxes", boxes, py::arg("n"), py::arg("limits"))
        .def("unmet", unmet, py::arg("limits"));
    module.def("open_system", open_system, py::arg("source"), py::arg("let"),
               py::arg("name") = py::none(), Unlocked());
    module.def("open_file", open_file, py::arg("path"), py::arg("let"), Unlocked());
    module.def("renamed", renamed, py::arg("system"), py::arg("name"), Unlocked());
    module.def("read_system", read_system, py::arg("text"), py::arg("name"), py::arg("let"),
               Unlocked());
    module.def(
        "read_foreign",
        [](const std::string& text, const std::string& format) {
            const SystemFormat* known = system_format("x." + format);
            if (!known) throw Error("no format of systems is called " + algae::quoted(format));
            return made(known->read(text, "system." + format));
        },
        py::arg("text"), py::arg("format"), Unlocked());
    module.def("needs_blank", needs_blank, py::arg("left"), py::arg("right"));
    module.def("gallery", [] {
        std::vector<std::pair<std::string, std::string>> all;
        for (const GalleryEntry& entry : gallery())
            all.emplace_back(std::string(entry.name), std::string(entry.path));
        return all;
    });
}

}  // namespace algae::python
