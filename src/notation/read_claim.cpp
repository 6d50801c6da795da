#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/model.hpp"

#include "notation/detail/blank_byte.hpp"
#include "notation/detail/claim_reading.hpp"
#include "notation/detail/grammar.hpp"
#include "notation/detail/reading.hpp"

// A `.claim` file from its text, and whether a system fits the family that its definition names.
//
// How words are cut into symbols depends on what `alphabet` declares and on the letters of systems. So the
// clauses are read in four passes: `alphabet`; then all definitions `let` are taken apart, which makes their
// names known; then the systems are read; then everything else in the order of the text. A faulty clause
// becomes a finding and the others are read on; what uses a faulty definition is passed over
// (`DependsOnError`).
//
// A definition `let G = PD0L { ... }` says of what family the system is, and this is checked (`misfit`): a
// claim about PD0L systems must not rest on one that erases. Only rules of letters that occur count. Families
// whose words are derived module by module (S0L, PS0L, parametric) are kept as they are written; all others
// become a `SourceSystem` that languages are made of, but a system with context whose words have brackets,
// which is derived module by module too.

namespace algae {

namespace {

/// The names of families of systems whose words are derived module by module.
const std::vector<std::string>& rewriting_families() {
    static const std::vector<std::string> all{"S0L", "PS0L", "parametric"};
    return all;
}

/// Whether each letter is one whose rules matter.
std::vector<char> occurring(const LSystem& system) {
    std::vector<char> occurs(system.alphabet.size(), 0);
    std::vector<Word> successors(system.alphabet.size());
    for (const Production& rule : system.rules) {
        Word& all = successors[rule.predecessor.symbol];
        all.insert(all.end(), rule.successor.letters.begin(), rule.successor.letters.end());
    }
    Word next = system.axiom.letters;
    while (!next.empty()) {
        const Symbol letter = next.back();
        next.pop_back();
        if (occurs[letter]) continue;
        occurs[letter] = 1;
        next.insert(next.end(), successors[letter].begin(), successors[letter].end());
    }
    return occurs;
}

std::string erasing(const LSystem& system) {
    const std::vector<char> occurs = occurring(system);
    for (const Production& rule : system.rules)
        if (rule.successor.letters.empty() && occurs[rule.predecessor.symbol])
            return "the rule at " + to_string(rule.place) + " is erasing";
    return {};
}

/// The first rule that rewrites what one before it rewrites, in a system without context.
std::string second_choice(const LSystem& system) {
    const std::vector<char> occurs = occurring(system);
    std::map<std::pair<std::size_t, Symbol>, const Production*> first;
    for (const Production& rule : system.rules) {
        const Symbol letter = rule.predecessor.symbol;
        if (!occurs[letter]) continue;
        const auto [entry, is_new] = first.try_emplace({rule.table, letter}, &rule);
        if (!is_new && entry->second->successor != rule.successor)
            return "the rule at " + to_string(rule.place) + " is a second one for " +
                   system.alphabet.name(letter);
    }
    return {};
}

std::string misfit_without_context(const LSystem& system, const SystemForm& form) {
    const View<ET0L> view = as_et0l(system);
    if (!view) return "it is " + view.reason();
    if (!form.extended && !has_only_terminals(*view))
        for (const Symbol letter : accessible_letters(*view))
            if (!view->terminal[letter])
                return "its letter " + system.alphabet.name(letter) + " is no terminal";
    if (!form.tables && view->tables.size() > 1) return "it has several tables";
    if (form.deterministic && !is_deterministic(*view)) return second_choice(system);
    if (form.propagating && !is_propagating(*view)) return erasing(system);
    return {};
}

std::string misfit_with_context(const LSystem& system, const SystemForm& form) {
    if (const View<IL> view = form.deterministic ? as_dil(system) : as_il(system); !view)
        return "it is " + view.reason();
    const auto [left, right] = class_of(system).context;
    const bool fits = form.one_sided ? left + right <= 1
                                     : !form.context || (left <= form.context->first &&
                                                         right <= form.context->second);
    if (!fits)
        return "its contexts are up to " + std::to_string(left) + " on the left and " +
               std::to_string(right) + " on the right";
    if (form.propagating) return erasing(system);
    return {};
}

}  // namespace

std::optional<std::string> language_family(std::string_view name) {
    if (name == "REG" || name == "regular") return "REG";
    if (name == "CF" || name == "context-free") return "CF";
    if (system_form(name)) return std::string(name);
    return std::nullopt;
}

const std::vector<std::string>& common_families() {
    static const std::vector<std::string> all{"0L",   "P0L",  "D0L",   "PD0L",    "T0L",
                                              "PT0L", "DT0L", "PDT0L", "E0L",     "EP0L",
                                              "ED0L", "ET0L", "EPT0L", "EDT0L",   "EPDT0L",
                                              "IL",   "DIL",  "PDIL",  "regular", "context-free"};
    return all;
}

std::string misfit(const LSystem& system, const SystemForm& form) {
    return form.interactive ? misfit_with_context(system, form)
                            : misfit_without_context(system, form);
}

bool is_rewriting_family(std::string_view name) {
    const auto& all = rewriting_families();
    return std::find(all.begin(), all.end(), name) != all.end();
}

std::string misfit(const LSystem& system, std::string_view family) {
    const Class found = class_of(system);
    if (family != "parametric") {
        if (const View<S0L> view = as_s0l(system); !view) return "it is " + view.reason();
        if (!found.stochastic) return "no rule has a probability";
        for (const Production& rule : system.rules)
            if (family == "PS0L" && rule.successor.letters.empty())
                return "the rule at " + to_string(rule.place) + " is erasing";
        return {};
    }
    if (found.shape) return "it has shape rules";
    if (found.nested) return "it has systems within it or words as parameters";
    if (found.open && found.stochastic) return "it has communication modules and probabilities";
    if (found.open && asks_program(system))
        return "its communication modules are filled by a program";
    if (found.tables > 1) return "it has several tables";
    if (found.extended) return "it has terminals";
    if (!found.parametric && !found.conditional)
        return "none of its modules has parameters and no rule has a condition";
    return {};
}

namespace {

/// What stands up to the first blank or brace.
std::string_view first_word(std::string_view text) {
    std::size_t length = 0;
    while (length < text.size() && text[length] != '{' && !is_blank_byte(text[length])) ++length;
    return text.substr(0, length);
}

/// A definition `let NAME = VALUE`, taken apart but not read.
struct ClaimDefinition {
    std::string_view name, value;
    ClaimName* meaning = nullptr;  // set by reading the value

    /// Whether the value begins with the name of a family: a system.
    bool is_system() const {
        const std::string_view family = first_word(value);
        return system_form(family).has_value() || is_rewriting_family(family);
    }
};

/// The system of a definition and the place of what it was read from.
Model system_of(const ClaimDefinition& definition, std::string_view rest, ClaimReading& reading) {
    const std::string name(definition.name);
    if (!rest.starts_with('{')) return reading.opened(std::string(rest), rest.data());
    const char* const close = closing_brace(rest.data(), rest.data() + rest.size());
    if (close + 1 != rest.data() + rest.size())
        throw unexpected("the end of the definition", close + 1);
    const std::size_t faults = reading.findings.count();
    std::vector<std::string> letters;
    for (const Symbol symbol : reading.declared) letters.push_back(reading.alphabet->name(symbol));
    Model system = read_system(rest.substr(1, rest.size() - 2), reading.source, reading.findings,
                               name, reading.long_names, letters);
    if (reading.findings.count() > faults) throw DependsOnError();
    return system;
}

void add_rewriting(const ClaimDefinition& definition, LSystem system, Claim& claim) {
    definition.meaning->rewriting = std::make_shared<const LSystem>(std::move(system));
    definition.meaning->kind = ClaimName::Kind::rewriting;
    claim.rewritings.push_back(definition.meaning->rewriting);
}

void read_system_definition(const ClaimDefinition& definition, ClaimReading& reading,
                            Claim& claim) {
    const std::string_view family = first_word(definition.value);
    const std::string_view rest = trimmed(definition.value.substr(family.size()));
    if (rest.empty())
        throw unexpected("a system between braces or the name of one",
                         family.data() + family.size());
    Model system = system_of(definition, rest, reading);
    system.name = definition.name;
    definition.meaning->written = std::make_shared<const Model>(system);
    const bool is_rewriting = is_rewriting_family(family);
    const auto refuse = [&](const std::string& reason) {
        throw SyntaxError{family.data(), std::string(definition.name) + " is called a " +
                                             std::string(family) + " system, but " + reason};
    };
    if (is_rewriting) {
        if (const std::string reason = misfit(system, family); !reason.empty()) refuse(reason);
        return add_rewriting(definition, std::move(system), claim);
    }
    if (const std::string reason = misfit(system, *system_form(family)); !reason.empty())
        refuse(reason);
    if (const View<IL> interactive = as_dil(system);
        interactive && interactive->brackets && !as_et0l(system))
        return add_rewriting(definition, std::move(system), claim);
    definition.meaning->system =
        reading.add_system(std::string(definition.name), system, family.data());
    definition.meaning->kind = ClaimName::Kind::system;
    claim.systems.push_back(definition.meaning->system);
}

/// A word and braces with rules in them: a system of a family that there is not.
void refuse_unknown_family(std::string_view value) {
    const std::string_view word = first_word(value);
    const std::string_view rest = trimmed(value.substr(word.size()));
    if (word.empty() || word.starts_with('~') ||
        !is_morphism(rest.data(), rest.data() + rest.size()) ||
        is_grammar(value.data(), value.data() + value.size()))
        return;
    std::vector<std::string> families = common_families();
    families.insert(families.end(), rewriting_families().begin(), rewriting_families().end());
    throw unknown_word("a family of systems (0L, PD0L, ET0L, IL, ...)", word, families);
}

/// Takes `let NAME = VALUE` apart and makes the name known. Throws `SyntaxError`.
ClaimDefinition begin_definition(const ClaimClause& clause, ClaimReading& reading) {
    const char* here = clause.text.data() + clause.keyword.size();
    const char* const end = clause.text.data() + clause.text.size();
    ClaimDefinition definition;
    const auto on_name = grammar::told([&](std::string_view name) {
        definition.name = name;
        definition.meaning = &reading.define(name);
        definition.meaning->end = end;
    });
    using grammar::wanted;
    grammar::read(here, end,
                  wanted("a name after 'let'")[grammar::claim_name[on_name]] >>
                      wanted("'='")['='] >>
                      wanted("a language, a system or a morphism after '='")[!grammar::x3::eoi]);
    definition.value = grammar::between(here, end);
    if (clause.unclosed) throw SyntaxError{clause.unclosed, "'{' is never closed"};
    if (!definition.is_system()) refuse_unknown_family(definition.value);
    return definition;
}

/// Reads the value, makes it what the name means and adds systems and languages to the claim. Throws
/// `SyntaxError` or `DependsOnError`.
void read_definition(const ClaimDefinition& definition, ClaimReading& reading, Claim& claim) {
    if (definition.is_system()) return read_system_definition(definition, reading, claim);
    ClaimName& meaning = *definition.meaning;
    const char* here = definition.value.data();
    const char* const end = here + definition.value.size();
    if (is_morphism(here, end)) {
        const char* behind = here;
        meaning.morphism = parse_morphism(behind, end, reading);
        const std::string_view rest = trimmed(grammar::between(behind, end));
        if (rest.empty()) {
            meaning.kind = ClaimName::Kind::morphism;
            return;
        }
        if (!rest.starts_with('(') && !rest.starts_with('^'))
            throw unexpected("the end of the definition, or '(' and a language", rest.data());
    }
    if (is_grammar(here, end) && closing_brace(std::find(here, end, '{'), end) + 1 == end) {
        meaning.language = parse_grammar(here, end, reading, std::string(definition.name));
        meaning.system = meaning.language.language->system;
    } else {
        meaning.language = parse_language(here, end, reading);
    }
    if (here != end) throw unexpected("an operator or the end of the definition", here);
    meaning.language.language =
        reading.with_name(meaning.language.language, std::string(definition.name));
    meaning.kind = ClaimName::Kind::language;
    claim.languages.push_back(meaning.language.language);
}

/// Declares letters that do not stand in the text. Throws Error if one cannot be a letter.
void declare_given(const std::vector<std::string>& letters, ClaimReading& reading) {
    for (const std::string& name : letters) {
        try {
            if (name.empty()) throw SyntaxError{name.data(), "expected a letter, found none"};
            check_symbol_name(name, 0, "{}");
        } catch (const SyntaxError& error) {
            throw Error("the alphabet: " + error.message);
        }
        reading.declared.push_back(reading.declare(name));
    }
    std::sort(reading.declared.begin(), reading.declared.end());
}

/// Reads the clauses of one claim: the alphabet first, then systems, as both say how words are cut into
/// symbols, then everything else in order.
class ClaimReader {
public:
    ClaimReader(std::string_view text, const std::string& file_name, ClaimReading& reading)
        : text_(text), reading_(reading) {
        claim_.name = file_name;
    }

    /// `letters` count as letters of the file, besides those that are in it.
    Claim read(const std::vector<std::string>& letters) {
        const std::vector<ClaimClause> clauses = claim_clauses(text_);
        declare_given(letters, reading_);
        for (const ClaimClause& clause : clauses)
            if (clause.keyword == "alphabet") guarded([&] { read_alphabet(clause); });
        std::sort(reading_.declared.begin(), reading_.declared.end());
        for (const ClaimClause& clause : clauses)
            if (clause.keyword == "let")
                guarded([&] { definitions_.push_back(begin_definition(clause, reading_)); });
        for (const ClaimDefinition& definition : definitions_)
            if (definition.is_system())
                guarded([&] { read_definition(definition, reading_, claim_); });
        auto next = definitions_.begin();
        for (const ClaimClause& clause : clauses) {
            if (clause.keyword == "alphabet") continue;
            if (clause.keyword != "let") {
                guarded([&] { read_clause(clause); });
                continue;
            }
            // A clause without a definition was faulty.
            if (next == definitions_.end() ||
                next->name.data() > clause.text.data() + clause.text.size())
                continue;
            const ClaimDefinition& definition = *next++;
            if (!definition.is_system())
                guarded([&] { read_definition(definition, reading_, claim_); });
        }
        if (claim_.title.empty() && std::none_of(given_.begin(), given_.end(),
                                                 [](const auto& g) { return g.first == "claim"; }))
            reading_.findings.add(
                text_.data() + text_.size(),
                "expected a title, 'claim TEXT', before the end of the file, found none");
        guarded([&] { claim_.letters = reading_.finish_complements(); });
        reading_.findings.throw_if_any();
        if (reading_.binds) choose_instance_letters();
        claim_.systems.insert(claim_.systems.end(), reading_.grammars.begin(),
                              reading_.grammars.end());
        reading_.finish();
        claim_.alphabet = reading_.alphabet;
        return std::move(claim_);
    }

private:
    /// Calls `read` and makes findings of what it throws.
    template <class Read>
    void guarded(Read read) {
        try {
            reading_.findings.gather(read);
        } catch (const DependsOnError&) {  // its cause is among the findings
        }
    }

    /// The values of bound names are written with a, b, ..., the letters that inverse morphisms lead to with x, y, z.
    void choose_instance_letters() {
        for (char c = 'a'; c <= 'z'; ++c) {
            const Symbol letter = reading_.declare(std::string_view(&c, 1));
            const auto& bound = reading_.bound_letters;
            if (std::find(bound.begin(), bound.end(), letter) != bound.end()) continue;
            (c < 'x' ? claim_.instance_letters : claim_.inverse_letters).push_back(letter);
        }
        // More than three letters are rarely asked for; then the others serve, from the last one on.
        claim_.inverse_letters.insert(claim_.inverse_letters.end(),
                                      claim_.instance_letters.rbegin(),
                                      claim_.instance_letters.rend());
    }

    void read_alphabet(const ClaimClause& clause) {
        const std::string_view value = clause.value();
        if (value.empty())
            throw unexpected("letters after 'alphabet'", clause.text.data() + clause.text.size());
        for (const std::string_view name : pieces(value)) {
            check_symbol_name(name, 0, "{}");
            reading_.declared.push_back(reading_.declare(name));
        }
    }

    void read_clause(const ClaimClause& clause) {
        const std::string_view word = clause.keyword;
        if (word == "claim" || word == "source" || word == "note") return read_text(clause);
        if (clause.unclosed) throw SyntaxError{clause.unclosed, "'{' is never closed"};
        if (word == "allow") return read_allowance(clause);
        if (word == "show" || word == "lemma" || word == "refute" || word == "theorem")
            return read_claimed(clause);
        if (is_closure_fact(clause.text)) {
            const auto [fact, citation] = with_citation(clause.text);
            claim_.closure.push_back(parse_closure_fact(fact, reading_));
            if (!citation.empty()) set_formal_theorem(claim_.closure.back(), citation);
            return;
        }
        std::vector<std::string> words;
        for (const StatementHelp& help : claim_statements()) words.push_back(help.keyword);
        constexpr std::size_t most = 1000;  // after so many findings nobody needs suggestions
        SyntaxError unknown = unknown_word(
            "claim, source, note, alphabet, allow, let, theorem, show, lemma, refute or closed",
            word, reading_.findings.count() < most ? words : std::vector<std::string>());
        unknown.message += comment_hint(clause.text);
        throw unknown;
    }

    void read_text(const ClaimClause& clause) {
        const std::string_view value = clause.value();
        if (value.empty())
            throw unexpected("a text after " + quoted(clause.keyword),
                             clause.text.data() + clause.text.size());
        if (clause.keyword == "note") {
            claim_.notes.emplace_back(value);
            return;
        }
        for (const auto& [keyword, where] : given_)
            if (keyword == clause.keyword)
                throw given_twice(clause.keyword, where, reading_.source);
        given_.emplace_back(clause.keyword, clause.text.data());
        (clause.keyword == "claim" ? claim_.title : claim_.source) = value;
    }

    /// What stands before `by` and behind it.
    static std::pair<std::string_view, std::string_view> with_citation(std::string_view text) {
        const std::size_t by = find_word(text, "by");
        if (by == std::string_view::npos) return {trimmed(text), {}};
        const std::string_view citation = trimmed(text.substr(by + 2));
        if (citation.empty()) throw unexpected("a citation after 'by'", text.data() + text.size());
        return {trimmed(text.substr(0, by)), citation};
    }

    void read_claimed(const ClaimClause& clause) {
        using Purpose = ClaimedStatement::Purpose;
        const std::string_view text = clause.text.substr(clause.keyword.size());
        ClaimedStatement claimed;
        claimed.purpose = clause.keyword == "show"      ? Purpose::show
                          : clause.keyword == "lemma"   ? Purpose::lemma
                          : clause.keyword == "theorem" ? Purpose::theorem
                                                        : Purpose::refute;
        if (claimed.purpose == Purpose::theorem) {
            if (theorem_) throw given_twice(clause.keyword, theorem_, reading_.source);
            theorem_ = clause.text.data();
        }
        const auto [said, citation] = with_citation(text);
        claimed.citation = citation;
        claimed.statement = parse_statement(said, reading_);
        if (theorem_ == clause.text.data() && is_closure_fact(said)) {
            claim_.closure.push_back(parse_closure_fact(said, reading_));
            if (is_formal_theorem(citation)) set_formal_theorem(claim_.closure.back(), citation);
        }
        claim_.statements.push_back(std::move(claimed));
    }

    void read_allowance(const ClaimClause& clause) {
        if (joined(pieces(clause.text), " ") != "allow empty axiom")
            throw SyntaxError{clause.text.data(),
                              "expected 'allow empty axiom', found " + quoted(clause.text)};
        claim_.empty_axiom = true;
    }

    std::string_view text_;
    ClaimReading& reading_;
    Claim claim_;
    std::vector<std::pair<std::string_view, const char*>> given_;  // texts that stand once
    std::vector<ClaimDefinition> definitions_;
    const char* theorem_ = nullptr;  // stands there
};

}  // namespace

std::vector<StatementHelp> claim_statements() {
    return {
        {"claim", {"claim 0L languages are not closed under union"}, "the title, once", ""},
        {"source", {"source 001 Theorem 8"}, "where the claim comes from, once", ""},
        {"note", {"note It was found by hand."}, "a text that explanations print", ""},
        {"alphabet",
         {"alphabet wall window a"},
         "names longer than one character, and letters that complements are over",
         ""},
        {"allow",
         {"allow empty axiom"},
         "systems of all families may have the empty word as axiom",
         "they may not"},
        {"let",
         {"let A = {a, aa}", "let G = PD0L { axiom a; a -> aa }", "let h = { a -> ab; b -> ε }"},
         "a name for a language, a system or a morphism",
         ""},
        {"theorem",
         {"theorem not for all 0L languages A, B: A | B is 0L"},
         "the formal statement that the title puts into words, once",
         "the claim has examples only"},
        {"show", {"show A is 0L"}, "a statement that is true", ""},
        {"lemma", {"lemma A is finite"}, "a true statement on which later ones rest", ""},
        {"refute", {"refute A is 0L"}, "a statement that is false", ""},
        {"closed", {"closed under union: ET0L"}, "what the claim settles in `algae closure`", ""},
        {"not closed", {"not closed under union: 0L"}, "the same", ""}};
}

Claim read_claim(std::string_view text, const std::string& file_name, const SystemSource& open,
                 const std::vector<std::string>& letters) {
    return read_whole(text, file_name, [&](const Source& source, Findings& findings) {
        ClaimReading reading(source, findings, open);
        return ClaimReader(text, file_name, reading).read(letters);
    });
}

WrittenLanguage read_language(std::string_view text, const SystemSource& open,
                              const std::string& file_name,
                              const std::vector<std::string>& letters) {
    return read_whole(text, file_name, [&](const Source& source, Findings& findings) {
        ClaimReading reading(source, findings, open);
        reading.opens_systems = true;
        declare_given(letters, reading);
        const char* here = text.data();
        const char* const end = here + text.size();
        const Language language = parse_language(here, end, reading).language;
        if (here != end) throw unexpected("an operator", here);
        std::vector<Symbol> over = reading.finish_complements();
        reading.finish();
        return WrittenLanguage{reading.alphabet, language, std::move(over)};
    });
}

}  // namespace algae
