#include "notation/read_claim.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "notation/characters.hpp"
#include "notation/claim_closure.hpp"
#include "notation/claim_definitions.hpp"
#include "notation/claim_language.hpp"
#include "notation/claim_statement.hpp"
#include "notation/clauses.hpp"
#include "notation/suggestion.hpp"

namespace algae {

namespace {

const std::vector<std::string>& clause_words() {
    static const std::vector<std::string> all{"claim", "source", "note",   "alphabet",
                                              "allow", "let",    "show",   "lemma",
                                              "refute", "closed", "not closed"};
    return all;
}

/// Reads the clauses of one claim: the alphabet first, then systems, as both say how words are cut into
/// symbols, then everything else in order.
class ClaimReader {
public:
    ClaimReader(std::string_view text, const std::string& file_name, ClaimReading& reading)
        : text_(text), reading_(reading) {
        claim_.name = file_name;
    }

    Claim read();

private:
    /// Calls `read` and makes findings of what it throws.
    template <class Read>
    void guarded(Read read);

    void read_alphabet(const ClaimClause& clause);
    void read_clause(const ClaimClause& clause);
    void read_text(const ClaimClause& clause);
    void read_claimed(const ClaimClause& clause, ClaimedStatement::Purpose purpose);
    void read_allowance(const ClaimClause& clause);

    std::string_view text_;
    ClaimReading& reading_;
    Claim claim_;
    std::vector<std::pair<std::string_view, const char*>> given_;  // texts that stand once
    std::vector<ClaimDefinition> definitions_;
};

template <class Read>
void ClaimReader::guarded(Read read) {
    try {
        read();
    } catch (const SyntaxError& error) {
        reading_.findings.add(error);
    } catch (const DependsOnError&) {  // its cause is among the findings
    }
}

void ClaimReader::read_alphabet(const ClaimClause& clause) {
    const std::string_view value = clause.value();
    if (value.empty())
        throw unexpected("letters after 'alphabet'", clause.text.data() + clause.text.size());
    for (const std::string_view name : pieces(value)) {
        constexpr std::size_t longest = 200;  // reading looks so far ahead for a declared name
        if (name.size() > longest)
            throw SyntaxError{name.data(), "expected names of at most " + std::to_string(longest) +
                                               " bytes, found one of " +
                                               std::to_string(name.size())};
        for (std::size_t i = 0; i < name.size();) {
            const Character next = first_character(name.substr(i));
            if (is_reserved(next.code) || next.code == '{' || next.code == '}')
                throw SyntaxError{name.data() + i,
                                  "expected names without " + quoted(name.substr(i, next.bytes))};
            i += next.bytes;
        }
        reading_.declared.push_back(reading_.declare(name));
    }
}

void ClaimReader::read_text(const ClaimClause& clause) {
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
            throw SyntaxError{clause.text.data(),
                              quoted(keyword) + " is given twice, first in line " +
                                  std::to_string(reading_.source.place(where).line)};
    given_.emplace_back(clause.keyword, clause.text.data());
    (clause.keyword == "claim" ? claim_.title : claim_.source) = value;
}

void ClaimReader::read_claimed(const ClaimClause& clause, ClaimedStatement::Purpose purpose) {
    std::string_view text = clause.text.substr(clause.keyword.size());
    ClaimedStatement claimed;
    claimed.purpose = purpose;
    if (const std::size_t by = find_word(text, "by"); by != std::string_view::npos) {
        const std::string_view citation = trimmed(text.substr(by + 2));
        if (citation.empty()) throw unexpected("a citation after 'by'", text.data() + text.size());
        claimed.citation = citation;
        text = text.substr(0, by);
    }
    claimed.statement = parse_statement(trimmed(text), reading_);
    claim_.statements.push_back(std::move(claimed));
}

void ClaimReader::read_allowance(const ClaimClause& clause) {
    std::string said;
    for (const std::string_view piece : pieces(clause.text))
        said += (said.empty() ? "" : " ") + std::string(piece);
    if (said != "allow empty axiom")
        throw SyntaxError{clause.text.data(), "expected 'allow empty axiom', found " + quoted(clause.text)};
    claim_.empty_axiom = true;
}

void ClaimReader::read_clause(const ClaimClause& clause) {
    using Purpose = ClaimedStatement::Purpose;
    const std::string_view word = clause.keyword;
    if (word == "claim" || word == "source" || word == "note") return read_text(clause);
    if (clause.unclosed) throw SyntaxError{clause.unclosed, "'{' is never closed"};
    if (word == "allow") return read_allowance(clause);
    if (word == "show") return read_claimed(clause, Purpose::show);
    if (word == "lemma") return read_claimed(clause, Purpose::lemma);
    if (word == "refute") return read_claimed(clause, Purpose::refute);
    if (is_closure_fact(clause.text)) {
        claim_.closure.push_back(parse_closure_fact(clause.text, reading_));
        return;
    }
    constexpr std::size_t most = 1000;  // after so many findings nobody needs suggestions
    throw SyntaxError{
        clause.text.data(),
        "expected claim, source, note, alphabet, allow, let, show, lemma, refute or closed, found " +
            quoted(word) +
            (reading_.findings.count() < most ? did_you_mean(word, clause_words()) : "")};
}

Claim ClaimReader::read() {
    const std::vector<ClaimClause> clauses = claim_clauses(text_);
    for (const ClaimClause& clause : clauses)
        if (clause.keyword == "alphabet") guarded([&] { read_alphabet(clause); });
    std::sort(reading_.declared.begin(), reading_.declared.end());
    for (const ClaimClause& clause : clauses)
        if (clause.keyword == "let")
            guarded([&] { definitions_.push_back(begin_definition(clause, reading_)); });
    for (const ClaimDefinition& definition : definitions_)
        if (definition.is_system()) guarded([&] { read_definition(definition, reading_, claim_); });
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
    reading_.findings.throw_if_any();
    reading_.finish();
    claim_.alphabet = reading_.alphabet;
    return std::move(claim_);
}

}  // namespace

Claim read_claim(std::string_view text, const std::string& file_name, const SystemSource& open) {
    const Source source(text, file_name);
    Findings findings(source);
    findings.throw_if_no_text();
    ClaimReading reading(source, findings, open);
    return ClaimReader(text, file_name, reading).read();
}

WrittenLanguage read_language(std::string_view text, const SystemSource& open,
                              const std::string& file_name) {
    const Source source(text, file_name);
    Findings findings(source);
    findings.throw_if_no_text();
    ClaimReading reading(source, findings, open);
    reading.opens_systems = true;
    try {
        ClaimScanner scanner(text);
        const Language language = parse_language(scanner, reading).language;
        if (!scanner.at_end()) throw unexpected("an operator", scanner.here);
        reading.finish();
        return {reading.alphabet, language};
    } catch (const SyntaxError& error) {
        findings.add(error);
        findings.throw_if_any();
        throw;
    }
}

}  // namespace algae
