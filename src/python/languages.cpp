// Languages for Python: expressions, what is decided about them, claims and certificates, censuses.
//
// A language of Python is an expression as claims write it, with the systems that it names: operators put expressions together,
// and the notation reads the whole. So the alphabet of complements is that of the whole expression, as in a claim. Each
// answer is kept with its proof, which is put into sentences, LaTeX or a certificate when somebody asks.

#include "language/language.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "growth/growth.hpp"
#include "notation/notation.hpp"
#include "python/detail/running.hpp"
#include "python/detail/values.hpp"
#include "report/report.hpp"
#include "verify/verify.hpp"

namespace algae::python {

namespace {

/// How systems are opened that a text names: those that are given, then the gallery. Files are read by Python only.
SystemSource systems_of(const NamedSystems& given) {
    return [given](const std::string& name) -> Model {
        for (const auto& [known, system] : given)
            if (known == name) return *system;
        for (const GalleryEntry& entry : gallery())
            if (entry.name == name) return read_lsystem(entry.text, name);
        std::vector<std::string> names;
        for (const auto& [known, system] : given) names.push_back(known);
        for (const GalleryEntry& entry : gallery()) names.emplace_back(entry.name);
        throw Error("no system " + algae::quoted(name) +
                    " is given, and none of that name is in the "
                    "gallery" +
                    did_you_mean(name, names));
    };
}

/// A language as it was read.
struct LanguageObject {
    WrittenLanguage written;
};

LanguageObject read_expression(const std::string& text, const NamedSystems& systems,
                               const std::vector<std::string>& letters) {
    return {read_language(text, systems_of(systems), "language", letters)};
}

/// An answer with the alphabet that its proof is over.
struct AnswerObject {
    Answer answer;
    std::shared_ptr<const Alphabet> alphabet;
};

std::string truth(const AnswerObject& object) {
    return std::string(to_string(object.answer.truth));
}

const std::vector<std::string>& known_families() {
    static const std::vector<std::string> known{
        "finite", "infinite", "empty", "regular", "context-free", "REG",  "CF",    "0L",
        "P0L",    "D0L",      "PD0L",  "T0L",     "PT0L",         "DT0L", "PDT0L", "E0L",
        "ET0L",   "EDT0L",    "IL"};
    return known;
}

AnswerObject is_of_family(const LanguageObject& language, const std::string& family,
                          bool empty_axiom, const Limits& limits) {
    const WrittenLanguage& written = language.written;
    if (std::ranges::count(known_families(), family) == 0 && !system_form(family))
        throw Error(family + " is no family of languages" + did_you_mean(family, known_families()));
    const std::string name = family == "regular" ? "REG" : family == "context-free" ? "CF" : family;
    return run(limits, [&](const Budget& budget) {
        const auto judged = [&]() -> Answer {
            if (name == "finite") return judge_finite(written.language, *written.alphabet, budget);
            if (name == "infinite")
                return opposite(judge_finite(written.language, *written.alphabet, budget));
            if (name == "empty") return judge_empty(written.language, *written.alphabet, budget);
            return judge_family(written.language, {name, empty_axiom, {}, true}, *written.alphabet,
                                budget);
        };
        return AnswerObject{judged(), written.alphabet};
    });
}

/// The systems in an expression, each once.
void add_systems(const Language& language,
                 std::vector<std::shared_ptr<const SourceSystem>>& systems) {
    if (language->system && std::ranges::none_of(systems, [&](const auto& known) {
            return known->name == language->system->name;
        }))
        systems.push_back(language->system);
    for (const Language& part : language->parts) add_systems(part, systems);
}

/// A claim without statements about a language.
Claim claim_of(const LanguageObject& language) {
    Claim claim;
    claim.alphabet = language.written.alphabet;
    claim.letters = language.written.letters;
    add_systems(language.written.language, claim.systems);
    return claim;
}

AnswerObject decided(const Statement& statement, const Claim& claim, const Limits& limits) {
    return run(limits, [&](const Budget& budget, Progress* progress) {
        SearchLimits search;
        search.progress = progress;
        return AnswerObject{decide(statement, claim, budget, search), claim.alphabet};
    });
}

AnswerObject has_word(const LanguageObject& language, const WordObject& word,
                      const Limits& limits) {
    Claim claim = claim_of(language);
    auto alphabet = std::make_shared<Alphabet>(*claim.alphabet);
    Word letters = over(word, *alphabet);
    if (alphabet->size() != claim.alphabet->size()) {
        // A letter that the language does not know stands in no word of it.
        return {{.truth = Truth::refuted,
                 .proof = nullptr,
                 .tried = {"A letter of the word occurs in no word of the language."}},
                claim.alphabet};
    }
    return decided({HasWord{language.written.language, std::move(letters)}}, claim, limits);
}

AnswerObject has_size(const LanguageObject& language, const Integer& size, const Limits& limits) {
    return decided({HasSize{language.written.language, size}}, claim_of(language), limits);
}

py::dict list_of(const LanguageObject& language, std::uint64_t length, std::uint64_t words,
                 const Limits& limits) {
    const WrittenLanguage& written = language.written;
    const WordList found = run(limits, [&](const Budget& budget) {
        return list_words(written.language, *written.alphabet, {length, words}, budget);
    });
    py::list all;
    for (const Word& word : found.words) {
        let_signals_in(all.size());
        all.append(WordObject(written.alphabet, word));
    }
    py::dict out;
    out["words"] = std::move(all);
    out["decided"] = found.decided;
    out["full"] = found.full;
    out["whole"] = found.whole;
    out["stopped"] = found.stopped;
    return out;
}

py::dict counts_of(const LanguageObject& language, std::uint64_t longest, const Limits& limits) {
    const WrittenLanguage& written = language.written;
    const WordCounts found = run(limits, [&](const Budget& budget) {
        return count_words(written.language, *written.alphabet, longest, budget);
    });
    py::dict out;
    out["counts"] = found.counts;
    out["whole"] = found.whole;
    out["function"] = found.function ? py::object(py::str(to_string(*found.function))) : py::none();
    out["stopped"] = found.stopped;
    return out;
}

std::vector<WordObject> random_words(const LanguageObject& language, std::uint64_t length,
                                     std::uint64_t count, std::uint64_t seed,
                                     const Limits& limits) {
    const WrittenLanguage& written = language.written;
    std::vector<WordObject> all;
    for (Word& word : run(limits, [&](const Budget& budget) {
             return draw_words(written.language, *written.alphabet, length, count, seed, budget);
         }))
        all.emplace_back(written.alphabet, std::move(word));
    return all;
}

// Questions about systems

/// The claim about L(A) for a system with context, and about words with these letters.
Claim claim_about(const SystemObject& system, const std::set<std::string>& letters) {
    if (const View<IL> rules = as_il(*system); rules->brackets)
        throw Error(system->name +
                    ": expected a system without context or one with plain contexts, found one "
                    "with context whose words have brackets");
    std::string text = "claim T\n";
    if (!letters.empty())
        text += "alphabet " +
                joined(std::vector<std::string>(letters.begin(), letters.end()), " ") + '\n';
    return read_claim(text + "let A = IL A\n", "question",
                      [&](const std::string&) { return *system; });
}

/// The membership of a word with its derivation: whether, the step, and the report as the command prints it.
std::tuple<std::optional<bool>, std::optional<std::uint64_t>, std::string, AnswerObject> member(
    const SystemObject& system, const WordObject& word, const Limits& limits) {
    const View<ET0L> tables = as_et0l(*system);
    auto alphabet = std::make_shared<Alphabet>(system->alphabet);
    const Word letters = over(word, *alphabet);
    if (!tables && as_il(*system)) {
        std::set<std::string> names;
        for (const Symbol letter : letters) names.insert(alphabet->name(letter));
        const Claim claim = claim_about(system, names);
        HasWord said{generated_language(claim.systems.front()), {}};
        for (const Symbol letter : letters)
            said.word.push_back(claim.alphabet->find(alphabet->name(letter)).value());
        AnswerObject found = decided({std::move(said)}, claim, limits);
        const Truth truth = found.answer.truth;
        Json out{{"member", truth == Truth::undecided ? Json() : Json(truth == Truth::proved)}};
        out.set("argument", sentences(found.answer, *found.alphabet));
        if (found.answer.proof) out.set("proof", Json(certificate(found.answer, *found.alphabet)));
        std::optional<bool> is_member;
        if (truth != Truth::undecided) is_member = truth == Truth::proved;
        return {is_member, std::nullopt, out.text(-1), std::move(found)};
    }
    const ET0L& rules = *tables;
    Json out;
    const Membership found = run(limits, [&](const Budget& budget) {
        Membership answer = membership(rules, letters, budget);
        out = Json{{"member", answer.member}};
        out.set("step", answer.member ? Json(answer.step) : Json());
        if (answer.member)
            out.set("derivation", to_json(derivation(rules, letters, answer, budget), rules));
        else
            out.set("reason", reason(answer, *alphabet, letters));
        return answer;
    });
    AnswerObject answer;
    answer.alphabet = alphabet;
    answer.answer.truth = found.member ? Truth::proved : Truth::refuted;
    std::optional<std::uint64_t> step;
    if (found.member) step = found.step;
    return {found.member, step, out.text(-1), std::move(answer)};
}

std::tuple<std::optional<bool>, std::optional<Integer>, std::string> finite(
    const SystemObject& system, const Limits& limits) {
    const View<ET0L> tables = as_et0l(*system);
    if (!tables && as_il(*system)) {
        const Claim claim = claim_about(system, {});
        const AnswerObject found =
            decided({IsFinite{generated_language(claim.systems.front())}}, claim, limits);
        const Truth truth = found.answer.truth;
        Json out{{"finite", truth == Truth::undecided ? Json() : Json(truth == Truth::proved)}};
        out.set("argument", sentences(found.answer, *found.alphabet));
        if (found.answer.proof) out.set("proof", Json(certificate(found.answer, *found.alphabet)));
        std::optional<bool> is_finite;
        if (truth != Truth::undecided) is_finite = truth == Truth::proved;
        return {is_finite, std::nullopt, out.text(-1)};
    }
    const ET0L& rules = *tables;
    std::optional<Integer> count;
    Json out;
    const bool is_finite = run(limits, [&](const Budget& budget) {
        Json round;
        bool ends = false;
        out = Json{{"finite", true}};
        if (rules.tables.size() == 1 && has_only_terminals(rules)) {
            const OL plain = without_terminals(rules);
            const Finiteness found = finiteness(plain);
            ends = found.finite;
            if (!ends) round = to_json(*found.round, plain);
            if (ends && algae::is_deterministic(plain)) {
                const Repetition words = repetition(plain, budget);
                count = Integer(words.preperiod) + words.period;
                out.set("count", *count);
                out.set("preperiod", words.preperiod);
                out.set("period", words.period);
            } else if (ends) {
                count = number_of_words(plain, budget);
                out.set("count", *count);
            }
        } else {
            const TablesFiniteness found = finiteness(rules, budget);
            ends = found.finite;
            if (!ends) round = to_json(*found.endless, rules);
            if (ends) {
                count = number_of_words(rules, budget);
                out.set("count", *count);
            }
        }
        if (!ends) out = Json{{"finite", false}, {"count", nullptr}, {"round", round}};
        return ends;
    });
    return {is_finite, count, out.text(-1)};
}

/// How a comparison ends, its witness as JSON and its text.
using Compared = std::tuple<bool, std::string, std::string>;

Compared equal_sequences_of(const SystemObject& left, const SystemObject& right,
                            const Limits& limits) {
    const View<D0L> a = as_d0l(*left), b = as_d0l(*right);
    const SequenceEquality found =
        run(limits, [&](const Budget& budget) { return equal_sequences(*a, *b, budget); });
    const auto alphabet = over_common_alphabet(*a, *b).alphabet;
    Json witness(found.equal ? balance_certificate(*found.balance, *alphabet)
                             : difference_certificate(*found.difference));
    if (!found.equal) {
        const SequenceDifference& difference = *found.difference;
        witness.set("lengths", Json::array({difference.left_length, difference.right_length}));
        witness.set("from", difference.from);
        witness.set("letters", Json::array({spell(*alphabet, difference.left),
                                            spell(*alphabet, difference.right)}));
    }
    return {found.equal, witness.text(-1), to_text(found, *alphabet)};
}

Compared equal_languages_of(const SystemObject& left, const SystemObject& right,
                            const Limits& limits) {
    const View<D0L> a = as_d0l(*left), b = as_d0l(*right);
    const LanguageEquality found =
        run(limits, [&](const Budget& budget) { return equal_languages(*a, *b, budget); });
    const auto alphabet = over_common_alphabet(*a, *b).alphabet;
    if (found.equal)
        return {true, Json(language_certificate(found, *alphabet)).text(-1),
                to_text(found, *alphabet)};
    const LanguageDifference& difference = *found.difference;
    Json witness{{"by", "word"},
                 {"of", difference.in_left ? "A" : "B"},
                 {"generation", difference.generation},
                 {"length", difference.length}};
    witness.set("word", difference.word ? Json(spell(*alphabet, *difference.word)) : Json());
    return {false, witness.text(-1), to_text(found, *alphabet)};
}

// Claims

struct ClaimObject {
    Claim claim;
};

struct CheckedObject {
    CheckedClaim checked;
};

ClaimObject claim_of_text(const std::string& text, const std::string& name,
                          const NamedSystems& systems, const std::vector<std::string>& letters) {
    return {read_claim(text, name, systems_of(systems), letters)};
}

CheckedObject checked(const ClaimObject& object, std::uint64_t instances, std::uint64_t size,
                      const Limits& limits) {
    return run(limits, [&](const Budget& budget, Progress* progress) {
        SearchLimits search;
        search.instances = instances;
        search.size = size;
        search.progress = progress;
        return CheckedObject{check(object.claim, budget, search)};
    });
}

py::list statements(const CheckedObject& object) {
    static const char* const outcomes[] = {"holds", "proved formally", "cited", "undecided",
                                           "fails"};
    static const char* const purposes[] = {"show", "lemma", "refute", "theorem"};
    const CheckedClaim& checked = object.checked;
    py::list all;
    for (std::size_t i = 0; i < checked.statements.size(); ++i) {
        const CheckedStatement& found = checked.statements[i];
        const ClaimedStatement& claimed = checked.claim.statements[i];
        py::dict one;
        one["text"] = claimed.statement.text;
        one["purpose"] = purposes[static_cast<std::size_t>(claimed.purpose)];
        one["line"] = claimed.statement.place.line;
        one["column"] = claimed.statement.place.column;
        one["outcome"] = outcomes[static_cast<std::size_t>(found.outcome)];
        one["verdict"] = verdict_text(found);
        one["citation"] = claimed.citation;
        one["method"] = method_of(found.answer, *checked.claim.alphabet);
        one["witness"] = witness_of(found.answer, *checked.claim.alphabet);
        one["answer"] = AnswerObject{found.answer, checked.claim.alphabet};
        all.append(std::move(one));
    }
    return all;
}

/// What the independent checker finds: for each statement its words, the outcome, and what is wrong.
std::vector<std::tuple<std::string, std::string, std::string>> verified(const std::string& text,
                                                                        const Limits& limits) {
    return run(limits, [&](const Budget& budget) {
        std::vector<std::tuple<std::string, std::string, std::string>> all;
        for (const verify::Finding& found : verify::check_certificate(text, "certificate", budget))
            all.emplace_back(found.statement, verify::to_string(found.outcome), found.reason);
        return all;
    });
}

// Censuses

py::dict census(const std::string& of, const std::vector<std::string>& statements,
                std::size_t first, bool languages, const Limits& limits) {
    const bool of_systems = of.find("systems") != std::string::npos;
    const std::string some = of_systems ? "L(X) is finite" : "ε in {ε}";
    const std::string text =
        "for all " + of + " X: " +
        (statements.empty() ? some : joined(statements, " and ", [](const std::string& statement) {
            return "(" + statement + ")";
        }));
    const Claim claim = read_claim("claim census\ntheorem " + text, "census", {});
    const auto* said = std::get_if<Quantified>(&claim.statements.at(0).statement.says);
    if (!said)
        throw Error("expected what is counted, such as 'D0L systems up to size 8', found " +
                    algae::quoted(of));
    std::vector<Statement> properties;
    if (statements.size() == 1) properties = said->body;
    if (statements.size() > 1) properties = std::get<Joint>(said->body.front().says).parts;
    const std::uint64_t sizes = census_size(*said);
    const Census found = run(limits, [&](const Budget& budget, Progress* progress) {
        CensusOptions how;
        how.first = first;
        how.languages = languages;
        if (progress)
            how.on_chunk = [&](const CensusChunk& chunk) {
                progress->report(static_cast<double>(chunk.size - 1) / static_cast<double>(sizes));
            };
        CensusTotals totals(sizes, properties.size(), how);
        take_census(*said, properties, claim, how, totals, budget);
        return totals.census();
    });
    py::list rows;
    for (const Census::Row& row : found.rows) {
        py::dict one;
        one["size"] = row.size;
        one["all"] = as_python(row.instances);
        one["verdicts"] = row.verdicts;
        one["infinite"] = row.infinite;
        one["open"] = row.open;
        rows.append(std::move(one));
    }
    py::dict out;
    out["rows"] = std::move(rows);
    out["first"] = found.first;
    return out;
}

}  // namespace

void add_languages(py::module_& module) {
    py::class_<LanguageObject>(module, "Language")
        .def("text",
             [](const LanguageObject& language) {
                 return to_string(language.written.language, *language.written.alphabet);
             })
        .def("letters",
             [](const LanguageObject& language) {
                 std::vector<std::string> names;
                 for (const Symbol letter : letters_of(language.written.language))
                     names.push_back(language.written.alphabet->name(letter));
                 return names;
             })
        .def("complement_letters",
             [](const LanguageObject& language) {
                 std::vector<std::string> names;
                 for (const Symbol letter : language.written.letters)
                     names.push_back(language.written.alphabet->name(letter));
                 return names;
             })
        .def("is_of", is_of_family, py::arg("family"), py::arg("empty_axiom"), py::arg("limits"))
        .def("has_word", has_word, py::arg("word"), py::arg("limits"))
        .def("has_size", has_size, py::arg("size"), py::arg("limits"))
        .def("list_of", list_of, py::arg("length"), py::arg("words"), py::arg("limits"))
        .def("counts_of", counts_of, py::arg("longest"), py::arg("limits"))
        .def("random_words", random_words, py::arg("length"), py::arg("count"), py::arg("seed"),
             py::arg("limits"));

    py::class_<AnswerObject>(module, "Answer")
        .def("truth", truth)
        .def(
            "argument",
            [](const AnswerObject& object) { return sentences(object.answer, *object.alphabet); },
            Unlocked())
        .def(
            "latex",
            [](const AnswerObject& object) { return latex(object.answer, *object.alphabet); },
            Unlocked())
        .def(
            "certificate",
            [](const AnswerObject& object) {
                return certificate(object.answer, *object.alphabet).dump();
            },
            Unlocked());

    py::class_<ClaimObject>(module, "Claim")
        .def("title", [](const ClaimObject& object) { return object.claim.title; })
        .def("source", [](const ClaimObject& object) { return object.claim.source; })
        .def("check", checked, py::arg("instances"), py::arg("size"), py::arg("limits"));

    py::class_<CheckedObject>(module, "Checked")
        .def("verdict",
             [](const CheckedObject& object) {
                 return std::string(to_string(object.checked.verdict()));
             })
        .def("theorem", [](const CheckedObject& object) { return object.checked.theorem(); })
        .def("statements", statements)
        .def(
            "explanation", [](const CheckedObject& object) { return explanation(object.checked); },
            Unlocked())
        .def(
            "latex", [](const CheckedObject& object) { return latex(object.checked); }, Unlocked())
        .def(
            "certificate",
            [](const CheckedObject& object) { return certificate(object.checked).dump(); },
            Unlocked());

    module.def("read_language", read_expression, py::arg("text"), py::arg("systems"),
               py::arg("letters"), Unlocked());
    module.def("families", known_families);
    module.def("member", member, py::arg("system"), py::arg("word"), py::arg("limits"));
    module.def("finite", finite, py::arg("system"), py::arg("limits"));
    module.def("equal_sequences", equal_sequences_of, py::arg("left"), py::arg("right"),
               py::arg("limits"));
    module.def("equal_languages", equal_languages_of, py::arg("left"), py::arg("right"),
               py::arg("limits"));
    module.def("read_claim", claim_of_text, py::arg("text"), py::arg("name"), py::arg("systems"),
               py::arg("letters"), Unlocked());
    module.def("verify", verified, py::arg("certificate"), py::arg("limits"));
    module.def("census", census, py::arg("of"), py::arg("statements"), py::arg("first"),
               py::arg("languages"), py::arg("limits"));
}

}  // namespace algae::python
