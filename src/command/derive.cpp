// `algae derive` and `algae letter`: the words of generations.
//
// A word may be larger than memory, so it goes to standard output piece by piece while it is derived, and its
// length is computed first: a word that --max-letters does not allow is refused with its exact length and
// with the verbs that answer without it. The class of a system decides how it is derived: D0L systems by
// their morphism, systems with context by a development that keeps the whole word, systems with
// parameters, probabilities, tables or an environment by one rewriting with given choices. Systems
// of shape rules have boxes instead of words.

#include <map>

#include "command/detail/choices.hpp"
#include "command/detail/files.hpp"
#include "command/detail/output.hpp"
#include "command/detail/verb.hpp"
#include "exact/exact.hpp"
#include "growth/growth.hpp"
#include "model/model.hpp"
#include "rewrite/rewrite.hpp"
#include "system/system.hpp"
#include "turtle/turtle.hpp"

namespace algae::command {

namespace {

struct DeriveOptions {
    std::string file, tables, environment;
    std::vector<std::string> let;
    std::optional<Range> generation, seeds;
    std::optional<std::uint64_t> seed;
    std::optional<std::uint64_t> longest;
    bool all = false, all_words = false, language = false, distribution = false, expected = false,
         json = false, latex = false;
    Bounds bounds;
};

/// Throws BoundReached, with the exact length and other ways to an answer, if a word is too long.
void check_length(const D0L& system, std::uint64_t n, const Budget& budget) {
    constexpr double worked_out = 4096;  // binary digits of a length that is printed in full
    const double estimate = estimated_log2_length(system, n, budget);
    std::string count;
    if (estimate <= worked_out) {
        const Integer letters = length(system, n, budget);
        if (letters <= Integer(budget.letters)) return;
        count = readable(letters);
    } else {
        count = "about 10^" +
                std::to_string(static_cast<std::uint64_t>(estimate * 0.30102999566398120));
    }
    throw BoundReached(Bound::letters,
                       "generation " + std::to_string(n) + " has " + count +
                           " letters, more than the " + std::to_string(budget.letters) +
                           " that --max-letters allows. `algae letter -n " + std::to_string(n) +
                           " --at P` gives any part of it, `algae growth -n " + std::to_string(n) +
                           "` its length, `algae draw -n " + std::to_string(n) + "` its picture");
}

/// Prints words, a line each, or a list in JSON.
void print_words(bool json, const Alphabet& alphabet, const std::vector<Word>& words) {
    if (json) {
        Json all = Json::array();
        for (const Word& word : words) all.add(spell(alphabet, word));
        print(Json{{"words", std::move(all)}}.text());
        return;
    }
    std::string text;
    for (const Word& word : words) {
        text += spell(alphabet, word) + '\n';
        if (text.size() > (std::size_t{1} << 20)) {
            print(text);
            text.clear();
        }
    }
    print(text);
}

/// Prints a line for each of `first` to `last`, or a list in JSON; write(n, sink) sends the word and
/// says whether it has any letters.
void print_lines(bool json, std::uint64_t first, std::uint64_t last,
                 const std::function<bool(std::uint64_t, TextSink&)>& write) {
    // Words may be larger than memory: the JSON around them is written by hand.
    StandardOutput output;
    JsonString inside(output);
    TextSink& sink = json ? static_cast<TextSink&>(inside) : output;
    std::optional<OpenJson> open;
    if (json) {
        print("{\n  \"words\": [\n");
        open.emplace("\"\n  ],\n  ", "\n}\n");
    }
    for (std::uint64_t n = first; n <= last; ++n) {
        if (json) print("    \"");
        if (!write(n, sink)) print("ε");
        print(json ? (n < last ? "\",\n" : "\"\n") : "\n");
    }
    if (json) print("  ]\n}\n");
}

RewritingChoices choices(const DeriveOptions& options, const LSystem& system) {
    return derivation_choices(system, options.seed, options.seed || options.seeds);
}

std::uint64_t one_generation(const DeriveOptions& options, const std::string& option) {
    if (!options.generation) throw Error("-n is missing: which generation?");
    if (options.all || options.generation->written.find("..") != std::string::npos)
        throw Error(option + " needs one generation");
    return options.generation->first;
}

std::vector<std::size_t> tables(const DeriveOptions& options, const LSystem& system) {
    return derivation_tables(system, options.tables, options.seed || options.seeds);
}

/// Sends the image of a word under a coding, in pieces; `piece(at)` gives the letters from a position on, none at the end.
bool write_coded(const LetterCoding& coding, TextSink& sink,
                 const std::function<Word(std::uint64_t)>& piece) {
    Word last;  // the letter before the piece, next to which a blank may stand
    std::uint64_t at = 0;
    for (Word letters = piece(at); !letters.empty(); letters = piece(at)) {
        at += letters.size();
        const Word image = coding.morphism(letters);
        const std::size_t skipped = last.empty() ? 0 : coding.alphabet.name(last.front()).size();
        last.insert(last.end(), image.begin(), image.end());
        const std::string text = spell(coding.alphabet, last);
        sink.write(std::string_view(text).substr(skipped));
        sink.flush();
        last = {image.back()};
    }
    return at > 0;
}

/// Throws Error if a system has a coding where the letters that it stands for are shown.
void refuse_coding(const Model& system, const std::string& option) {
    if (!system.coding.empty())
        throw Error(
            option +
            ": is for words before the coding, and the system has one: its language is that of "
            "the letters before it");
}

/// The word of one generation after the other. Numbers are exact while words are not long: from then on they are doubles, as
/// in figures, all the way from the axiom.
class Generations {
public:
    Generations(const Model& system, const RewritingChoices& choices, const std::string& program,
                std::vector<std::size_t> sequence, const Budget& budget)
        : system_(system),
          choices_(choices),
          program_(program),
          sequence_(std::move(sequence)),
          budget_(budget) {
        begin();
    }

    bool write(std::uint64_t n, TextSink& sink) {
        while (development_->generation() < n) {
            const bool is_exact = choices_.arithmetic == Arithmetic::exact;
            development_->go_to(is_exact ? development_->generation() + 1 : n, sequence_, budget_);
            if (is_exact && development_->word().values.size() > most_exact) {
                note("generation " + std::to_string(development_->generation()) +
                     " has more than " + std::to_string(most_exact) +
                     " parameters: from it on they are rounded");
                choices_.arithmetic = Arithmetic::doubles;
                begin();
            }
        }
        const CompiledRules& rules = development_->rules();
        if (!system_.coding.empty()) {
            const LetterCoding coding(system_.alphabet, system_.coding);
            Word letters;
            for (const ModuleKind kind : development_->word().kinds)
                letters.push_back(rules.kinds.letter(kind));
            return write_coded(coding, sink,
                               [&](std::uint64_t at) { return at == 0 ? letters : Word(); });
        }
        return ModuleText(rules.system->alphabet, rules.kinds)
            .write(development_->word(), sink, budget_);
    }

private:
    static constexpr std::size_t most_exact = 20'000;

    void begin() {
        development_.emplace(system_, choices_, external_environment(program_, system_), budget_);
    }

    const Model& system_;
    RewritingChoices choices_;
    std::string program_;
    std::vector<std::size_t> sequence_;
    const Budget& budget_;
    std::optional<OpenDevelopment> development_;
};

void derive_modules(const DeriveOptions& options, const Model& system, const Budget& budget) {
    const auto sequence = tables(options, system);
    if (options.seeds) {
        const std::uint64_t n = one_generation(options, "--seeds");
        check_long_enough(sequence, n);
        const auto& [first, last, written] = *options.seeds;
        print_lines(options.json, first, last, [&](std::uint64_t seed, TextSink& sink) {
            RewritingChoices own = choices(options, system);
            own.seed = seed;
            return Generations(system, own, options.environment, sequence, budget).write(n, sink);
        });
        return;
    }
    const std::uint64_t last = options.generation ? options.generation->last : sequence.size();
    const std::uint64_t from = options.generation ? options.generation->first : last;
    check_long_enough(sequence, last);
    Generations generations(system, choices(options, system), options.environment, sequence,
                            budget);
    print_lines(options.json, options.all ? 0 : from, last,
                [&](std::uint64_t n, TextSink& sink) { return generations.write(n, sink); });
}

void derive_distribution(const DeriveOptions& options, const LSystem& system,
                         const Budget& budget) {
    if (class_of(system).open)
        throw Error("it has communication modules, and --distribution asks no environment");
    const std::uint64_t n = one_generation(options, "--distribution");
    if (leaves_tables_open(system) && options.tables.empty())
        throw Error("it has tables and no schedule; say --tables SEQUENCE");
    const auto sequence = tables(options, system);
    check_long_enough(sequence, n);
    const Rewriting rewriting(system, choices(options, system), budget);
    const ModuleText text(rewriting.rules().system->alphabet, rewriting.rules().kinds);
    Json words = Json::array();
    for (const LikelyWord& likely : distribution(rewriting, n, sequence, budget)) {
        const std::string word = text.text(likely.word),
                          probability = to_string(likely.probability);
        if (options.json)
            words.add({{"probability", probability}, {"word", word}});
        else
            print(probability + "  " + word + '\n');
    }
    if (options.json) print(Json{{"words", words}}.text());
}

void derive_expected(const DeriveOptions& options, const LSystem& system, const Budget& budget) {
    const std::uint64_t n = one_generation(options, "--expected");
    const View<S0L> rules = as_s0l(system);
    const std::vector<Rational> counts = expected_counts(*rules, n, budget);
    Rational length;
    std::map<std::string, std::string> letters;  // in alphabetical order
    std::string text;
    for (Symbol a = 0; a < counts.size(); ++a) {
        length += counts[a];
        letters[system.alphabet.name(a)] = to_string(counts[a]);
        text += system.alphabet.name(a) + "  " + to_string(counts[a]) + "  " +
                decimal(counts[a], 6) + '\n';
    }
    if (options.json) {
        Json all{std::initializer_list<Json::Field>{}};
        for (const auto& [name, count] : letters) all.set(name, count);
        print(Json{{"length", to_string(length)}, {"letters", all}}.text());
    } else
        print(text + "length  " + to_string(length) + "  " + decimal(length, 6) + '\n');
}

void derive_language(const DeriveOptions& options, const LSystem& system, const Budget& budget) {
    const std::uint64_t n = one_generation(options, "--language");
    print_words(options.json, system.alphabet,
                terminal_words(*as_et0l(system), n, options.longest, budget));
}

// Boxes of shape rules.

Json as_json(const std::array<Rational, 3>& numbers) {
    Json out = Json::array();
    for (const Rational& number : numbers) out.add(shortest_text(number));
    return out;
}

Json as_json(const Alphabet& alphabet, const std::vector<ShapeBox>& boxes) {
    Json out = Json::array();
    for (const ShapeBox& box : boxes)
        out.add({{"symbol", alphabet.name(box.symbol)},
                 {"origin", as_json(box.origin)},
                 {"size", as_json(box.size)}});
    return out;
}

void derive_boxes(const LSystem& system, std::uint64_t first, std::uint64_t last, bool json,
                  const Budget& budget) {
    const View<ShapeSystem> shapes = as_shape(system);
    std::vector<ShapeBox> boxes = boxes_after(*shapes, shapes->axiom, first, budget);
    Json generations = Json::array();
    for (std::uint64_t n = first;; ++n) {
        if (json) {
            generations.add({{"generation", n}, {"boxes", as_json(system.alphabet, boxes)}});
        } else {
            std::string text;
            if (first != last) text = "# generation " + std::to_string(n) + '\n';
            for (const ShapeBox& box : boxes) text += box_text(system.alphabet, box) + '\n';
            print(text);
        }
        if (n == last) break;
        boxes = boxes_after(*shapes, std::move(boxes), 1, budget);
    }
    if (json) print(Json{{"generations", generations}}.text());
}

// The verb derive.

void print_generations(const DeriveOptions& options, const Model& model, const D0L& system,
                       std::uint64_t first, std::uint64_t last, const Budget& budget) {
    check_length(system, last, budget);
    if (first != last)
        for (std::uint64_t n = first; n < last; ++n) check_length(system, n, budget);
    if (!model.coding.empty()) {
        constexpr std::uint64_t piece = 1 << 16;  // letters
        const LetterCoding coding(model.alphabet, model.coding);
        print_lines(options.json, first, last, [&](std::uint64_t n, TextSink& sink) {
            const Integer size = length(system, n, budget);
            return write_coded(coding, sink, [&](std::uint64_t at) {
                return Integer(at) < size ? letters_at(system, n, Integer(at), piece, budget)
                                          : Word();
            });
        });
        return;
    }
    print_lines(options.json, first, last, [&](std::uint64_t n, TextSink& sink) {
        return derive_text(system, n, sink, budget);
    });
}

void print_generations(const DeriveOptions& options, const Model& model, const IL& system,
                       std::uint64_t first, std::uint64_t last, const Budget& budget) {
    Development development(system, budget);
    development.steps(first);
    print_lines(options.json, first, last, [&](std::uint64_t n, TextSink& sink) {
        development.steps(n - development.generation());
        if (development.length() == 0) return false;
        if (!model.coding.empty())
            return write_coded(
                LetterCoding(model.alphabet, model.coding), sink,
                [&](std::uint64_t at) { return at == 0 ? development.word() : Word(); });
        const std::string text = spell(*system.alphabet, development.word());  // until flush
        sink.write(text);
        sink.flush();
        return true;
    });
}

void derive_shapes(const DeriveOptions& options, const LSystem& system, const Budget& budget) {
    const bool words = options.all_words || options.language || options.distribution ||
                       options.expected || options.seed || options.seeds ||
                       !options.tables.empty() || options.longest;
    if (words)
        throw Error(
            "a system of shape rules derives boxes; derive takes -n, --all and --json for it");
    if (!options.generation) throw Error("-n is missing: which generation?");
    const auto& [first, last, written] = *options.generation;
    derive_boxes(system, options.all ? 0 : first, last, options.json, budget);
}

template <class System>
std::vector<Word> all_words(const DeriveOptions& options, const System& system,
                            const Budget& budget) {
    if (!options.generation) return words_up_to(system, *options.longest, budget);
    return words_of_generation(system, natural("-n", options.generation->written), options.longest,
                               budget);
}

void derive_all_words(const DeriveOptions& options, const LSystem& system, const Budget& budget) {
    const View<OL> rules = as_ol(system);
    const View<IL> interactive = as_il(system);
    if (!options.generation && !options.longest)
        throw Error("--all-words needs a generation (-n) or a greatest length (--longest)");
    print_words(options.json, system.alphabet,
                !rules && interactive ? all_words(options, *interactive, budget)
                                      : all_words(options, *rules, budget));
}

/// The words from the axiom on as a display; with a coding its letters.
void print_derivation(const Model& system, const D0L* rules, const IL* interactive,
                      std::uint64_t last, const Budget& budget) {
    constexpr std::uint64_t most = 1000;
    if (last > most)
        throw BoundReached(Bound::letters, "--latex shows at most " + std::to_string(most) +
                                               " steps, not " + std::to_string(last));
    if (!rules && !interactive) throw Error("--latex: it needs rules without parameters");
    std::vector<Word> words;
    if (rules) {
        for (std::uint64_t n = 0; n <= last; ++n) words.push_back(derive(*rules, n, budget));
    } else {
        Development development(*interactive, budget);
        for (std::uint64_t n = 0; n <= last; ++n) {
            if (n > 0) development.steps(1);
            words.push_back(development.word());
        }
    }
    if (system.coding.empty()) {
        print(derivation_latex(words, system.alphabet));
        return;
    }
    const LetterCoding coding(system.alphabet, system.coding);
    for (Word& word : words) word = coding.morphism(word);
    print(derivation_latex(words, coding.alphabet));
}

int derive_verb(const DeriveOptions& options) {
    const Budget budget = options.bounds.budget();
    const Model system = open_model(options.file, budget, options.let);
    if (class_of(system).shape) {
        derive_shapes(options, system, budget);
        return success;
    }
    if (options.longest && !options.all_words && !options.language)
        throw Error("--longest goes with --all-words or --language");
    for (const auto& [option, given] :
         {std::pair("--all-words", options.all_words), std::pair("--language", options.language),
          std::pair("--distribution", options.distribution),
          std::pair("--expected", options.expected)})
        if (given) refuse_coding(system, option);
    if (options.latex)
        refuse_with("--latex", {{"--all-words", options.all_words},
                                {"--language", options.language},
                                {"--distribution", options.distribution},
                                {"--expected", options.expected},
                                {"--seed", options.seed.has_value()},
                                {"--seeds", options.seeds.has_value()},
                                {"--tables", !options.tables.empty()},
                                {"--environment", !options.environment.empty()}});
    if (options.all_words)
        derive_all_words(options, system, budget);
    else if (options.language)
        derive_language(options, system, budget);
    else if (options.distribution)
        derive_distribution(options, system, budget);
    else if (options.expected)
        derive_expected(options, system, budget);
    if (options.all_words || options.language || options.distribution || options.expected)
        return success;
    if (!options.generation && options.tables.empty())
        throw Error("-n is missing: which generation?");
    const bool picked = options.seed || options.seeds || !options.tables.empty();
    if (options.latex && !as_d0l(system) && !as_dil(system))
        throw Error("--latex: " + as_d0l(system).reason());
    if (!options.environment.empty() || class_of(system).open) {
        derive_modules(options, system, budget);
        return success;
    }
    const View<D0L> rules = as_d0l(system);
    if (const View<OL> choices = as_ol(system); !picked && !rules && choices)
        throw Error(rules.reason() +
                    "; say --all-words for all words, or --seed S for one picked at random");
    const View<IL> interactive = as_dil(system);
    if (!picked && !rules && !interactive && as_il(system))
        throw Error(interactive.reason() +
                    "; say --all-words for all words, or --seed S for one picked at random");
    if (picked || (!rules && !interactive)) {
        derive_modules(options, system, budget);
        return success;
    }
    const auto& [from, last, written] = *options.generation;
    if (options.latex) {
        print_derivation(system, rules ? &*rules : nullptr, interactive ? &*interactive : nullptr,
                         last, budget);
        return success;
    }
    const std::uint64_t first = options.all ? 0 : from;
    if (rules)
        print_generations(options, system, *rules, first, last, budget);
    else
        print_generations(options, system, *interactive, first, last, budget);
    return success;
}

// letter

struct LetterOptions {
    std::string file;
    std::vector<std::string> let;
    std::uint64_t generation = 0, count = 1;
    Integer at;
    bool json = false;
    Bounds bounds;
};

/// Of a system with context, whose words are derived whole.
Word derived_letters(const IL& system, const LetterOptions& options, const Budget& budget) {
    Development development(system, budget);
    development.steps(options.generation);
    const Word& word = development.word();
    if (options.at >= Integer(word.size()))
        throw Error("generation " + std::to_string(options.generation) + " has no letter at " +
                    to_string(options.at) + ": it has " + std::to_string(word.size()) + " letters");
    const std::uint64_t at = options.at.to_uint64();
    const std::uint64_t count = std::min<std::uint64_t>(options.count, word.size() - at);
    const auto first = word.begin() + static_cast<std::ptrdiff_t>(at);
    return {first, first + static_cast<std::ptrdiff_t>(count)};
}

int letter(const LetterOptions& options) {
    const Budget budget = options.bounds.budget();
    const Model system = open_model(options.file, budget, options.let);
    const View<D0L> rules = as_d0l(system);
    const View<IL> interactive = as_dil(system);
    const bool with_context = !rules && !as_ol(system) && as_il(system);
    const Word letters =
        with_context ? derived_letters(*interactive, options, budget)
                     : letters_at(*rules, options.generation, options.at, options.count, budget);
    std::string text = spell(system.alphabet, letters);
    if (!system.coding.empty()) {
        const LetterCoding coding(system.alphabet, system.coding);
        text = spell(coding.alphabet, coding.morphism(letters));
    }
    if (options.json)
        print(Json{{"letters", text}}.text());
    else
        print(text + "\n");
    return success;
}

}  // namespace

RewritingChoices derivation_choices(const LSystem& system, std::optional<std::uint64_t> seed,
                                    bool seeded) {
    constexpr std::uint64_t usual_seed = 1;
    RewritingChoices out;
    out.seed = seed.value_or(usual_seed);
    out.evenly = !class_of(system).stochastic && seeded;
    out.random_tables = seeded;
    // What an environment answers is measured on a figure, which keeps doubles.
    out.arithmetic = class_of(system).open ? Arithmetic::doubles : Arithmetic::exact;
    return out;
}

std::vector<std::size_t> derivation_tables(const LSystem& system, const std::string& tables,
                                           bool seeded) {
    if (!tables.empty()) return table_sequence(system.tables, tables);
    if (leaves_tables_open(system) && !seeded)
        throw Error("it has " + std::to_string(system.tables.size()) +
                    " tables and no schedule; say --tables SEQUENCE, or --seed S for random ones");
    return {};
}

void check_long_enough(const std::vector<std::size_t>& sequence, std::uint64_t n) {
    if (!sequence.empty() && sequence.size() < n)
        throw Error("--tables: expected a table for each of " + std::to_string(n) +
                    " steps, found " + std::to_string(sequence.size()));
}

void add_derive(Verbs& verbs) {
    auto [verb, options] = verbs.add("derive", "The word of a generation, or its boxes",
                                     {"algae derive koch -n 3", "algae derive signal.lsys -n 0..5",
                                      "algae derive my.lsys -n 4 --all-words --longest 10",
                                      "algae derive stochastic.lsys -n 6 --seeds 1..9"},
                                     derive_verb);
    verb.option("FILE", options.file, file_type, file_help).required = true;
    add_let_option(verb, options.let);
    verb.option("-n", options.generation, range, "N", "the generation, or a range such as 0..6");
    verb.flag("--all", options.all, "all generations from 0 on, a line each");
    verb.flag("--all-words", options.all_words,
              "every word of the generation, in shortlex order (0L and IL systems)");
    verb.flag("--language", options.language,
              "the words over the terminals of generations up to N, in shortlex order");
    verb.option("--longest", options.longest, natural, "M",
                "with --all-words and --language: words of at most M letters; with --all-words and "
                "without -n, of the whole language");
    verb.option("--seed", options.seed, natural, "S",
                "what is picked at random: the same seed, the same word (1 for systems with "
                "probabilities)");
    verb.option("--seeds", options.seeds, range, "A..B",
                "a word for each of these seeds, such as 1..9");
    verb.option("--tables", options.tables, "SEQUENCE",
                "the table of each step: light,dark or, of one character each, abab or 1212");
    add_environment_option(verb, options.environment);
    verb.flag("--distribution", options.distribution,
              "all words of the generation with their exact probabilities");
    verb.flag("--expected", options.expected,
              "the exact expected numbers of letters of the generation");
    verb.json_flag(options.json);
    verb.latex_flag(options.latex,
                    "print the derivation from the axiom on as LaTeX, which needs amsmath");
    verb.bounded_by(options.bounds);
}

void add_letter(Verbs& verbs) {
    auto [verb, options] =
        verbs.add("letter", "Letters of a generation from a position on, without the word",
                  {"algae letter dragon -n 300 --at 1000000000000000000000000000000",
                   "algae letter koch -n 1000 --at 10 --count 60"},
                  letter);
    verb.option("FILE", options.file, file_type, file_help).required = true;
    add_let_option(verb, options.let);
    verb.option("-n", options.generation, natural, "N", "the generation").required = true;
    verb.option("--at", options.at, position, "P", "the position, counted from 0, of any size")
        .required = true;
    verb.option("--count", options.count, natural, "K", "how many letters (default 1)");
    verb.json_flag(options.json);
    verb.bounded_by(options.bounds);
}

}  // namespace algae::command
