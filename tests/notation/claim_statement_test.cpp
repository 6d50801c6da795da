#include <doctest/doctest.h>

#include <fstream>
#include <iterator>
#include <regex>

#include "notation/claim_said.hpp"
#include "notation/detail/claim_reading.hpp"
#include "places.hpp"

using namespace algae;

namespace {

const std::string definitions =
    "let A = {a, ab}\nlet B = /a*/\nlet G = PD0L { axiom a; a -> ab }\nlet H = D0L fibonacci\n";

/// The one statement of a claim with A, B, G and H.
ClaimedStatement claimed(const std::string& line) {
    return claim(definitions + line).statements.at(0);
}
Statement statement(const std::string& text) { return claimed("show " + text).statement; }

}  // namespace

TEST_CASE("title, source and notes") {
    const Claim read = read_claim(
        "# first\nclaim  A title of {words  # a comment\nnote one; note  two }\n source 001 "
        "Theorem 8\n",
        "x.claim", {});
    CHECK(read.name == "x.claim");
    CHECK(read.title == "A title of {words");
    CHECK(read.source == "001 Theorem 8");
    CHECK(read.notes == std::vector<std::string>{"one", "two }"});
}

TEST_CASE("show, lemma and refute, with what they rest on") {
    using Purpose = ClaimedStatement::Purpose;
    const ClaimedStatement shown =
        claimed("show  A is 0L  by Rozenberg and Salomaa 1980, II.1 by example # c");
    CHECK(shown.purpose == Purpose::show);
    CHECK(shown.statement.text == "A is 0L");
    CHECK(to_string(shown.statement.place) == "x.claim:6:7");
    CHECK(shown.citation == "Rozenberg and Salomaa 1980, II.1 by example");
    CHECK(claimed("lemma A is 0L").purpose == Purpose::lemma);
    CHECK(claimed("refute A is 0L").purpose == Purpose::refute);
    CHECK(claimed("refute A is 0L").citation.empty());
}

TEST_CASE("what a language is") {
    CHECK(is_said<InFamily>(statement("A | B is PD0L")));
    CHECK(said_in<InFamily>(statement("A | B is PD0L")).family == "PD0L");
    for (const char* family : {"0L", "PDT0L", "E0L", "EPDT0L", "IL", "PD1L", "D2L", "(3,1)L"})
        CHECK(said_in<InFamily>(statement(std::string("A is ") + family)).family == family);
    CHECK(said_in<InFamily>(statement("A is regular")).family == "REG");
    CHECK(said_in<InFamily>(statement("A is REG")).family == "REG");
    CHECK(said_in<InFamily>(statement("A is context-free")).family == "CF");
    CHECK(statement("A is not 0L").negated);
    CHECK(statement("not A is 0L").negated);
    CHECK(is_said<IsFinite>(statement("A is finite")));
    CHECK(is_said<IsFinite>(statement("A is infinite")));
    CHECK(statement("A is infinite").negated);
    CHECK(!statement("A is not infinite").negated);
    CHECK(is_said<IsEmpty>(statement("A is empty")));
}

TEST_CASE("languages compared, their words and their size") {
    CHECK(is_said<EqualLanguages>(statement("A == B")));
    CHECK(!statement("A == B").negated);
    CHECK(statement("A != B").negated);
    CHECK(is_said<IncludedIn>(statement("A <= B")));
    CHECK(said_in<IncludedIn>(statement("A <= B")).inner->name == "A");
    CHECK(said_in<IncludedIn>(statement("A <= B")).outer->name == "B");
    CHECK(is_said<HasWord>(statement("a b in A")));
    CHECK(said_in<HasWord>(statement("a b in A")).word == Word{0, 1});
    CHECK(said_in<HasWord>(statement("ε in A | {b}")).word.empty());
    CHECK(statement("aa not in A").negated);
    CHECK(is_said<HasWord>(statement("F{}F in A")));
    CHECK(is_said<HasSize>(statement("|A| = 2")));
    CHECK(said_in<HasSize>(statement("|A| = 2")).size == Integer(2));
    CHECK(said_in<HasSize>(statement("|A | B|=123456789012345678901234567890")).size ==
          Integer("123456789012345678901234567890"));
    CHECK(statement("|A| != 3").negated);
}

TEST_CASE("what systems derive, and how they grow") {
    const auto derives = said_in<Derives>(statement("G ==> abb in 2 steps"));
    CHECK(derives.system->name == "G");
    CHECK(derives.steps == 2);
    CHECK(!derives.from);
    CHECK(derives.word == Word{0, 1, 1});
    CHECK(said_in<Derives>(statement("G ==> abb in 2 * 3 - 4 steps")).steps == 2);
    CHECK(!said_in<Derives>(statement("G ==> abb in 2 * 3 - 4 steps")).bound_steps);
    CHECK(said_in<Derives>(statement("G : aa ==> abab in 1 step")).from == Word{0, 0});
    CHECK(!said_in<Derives>(statement("not G==>ε")).steps);
    CHECK(statement("not G==>ε").negated);
    CHECK(is_said<EqualSequences>(statement("sequence(G) == sequence(H)")));
    CHECK(statement("sequence(G) != sequence( H )").negated);
    CHECK(is_said<EqualGrowth>(statement("growth(G) == growth(H)")));
    const auto formula = [](const std::string& text) {
        return std::get<ComparesNumbers>(said_in<Quantified>(statement(text)).body.at(0).says);
    };
    CHECK(to_text(formula("growth(G) = n + 1").left) == "length(G,n)");
    CHECK(to_text(formula("growth(G) = (n+1)").right) == "n+1");
    CHECK(said_in<HasGrowthClass>(statement("growth(G) ~ polynomial")).growth == "polynomial");
    CHECK(!said_in<HasGrowthClass>(statement("growth(G) ~ polynomial")).degree);
    CHECK(said_in<HasGrowthClass>(statement("growth(G) ~ polynomial 1")).degree == Integer(1));
    CHECK(is_said<HasGrowthClass>(statement("growth(H) ~ exponential")));
}

TEST_CASE("what a claim settles in the table of closure") {
    const Claim read =
        claim("closed under reversal: D0L 0L\nnot  closed under intersection   with regular : IL");
    CHECK(read.closure.at(0).closed);
    CHECK(read.closure.at(0).operation == "reversal");
    CHECK(read.closure.at(0).families == std::vector<std::string>{"D0L", "0L"});
    CHECK(!read.closure.at(1).closed);
    CHECK(read.closure.at(1).operation == "intersection with regular");
    CHECK(to_string(read.closure.at(1).place) == "x.claim:3:1");
}

TEST_CASE("systems are over the alphabet of the claim") {
    const Claim read = claim(
        "let G = ET0L { axiom S  # start }\n  table one; S -> wall S\n  table two\n S -> ε\n "
        "terminals wall }\n"
        "let F = D0L fibonacci\nlet N = 1L { axiom ab; a < b -> c }\nlet O = IL { axiom a; a -> b; "
        "a -> c }\n"
        "alphabet wall\nshow wall z in L(G)\n");
    CHECK(read.systems.size() == 4);
    for (const auto& system : read.systems)
        CHECK((system->tables ? system->tables->alphabet : system->interactive->alphabet) ==
              read.alphabet);
    CHECK(read.alphabet->name(0) == "wall");
    CHECK(read.systems[0]->tables->tables.size() == 2);
    CHECK(read.systems[0]->tables->terminal.size() == read.alphabet->size());
    CHECK(spell(*read.alphabet, read.systems[0]->tables->tables[0][*read.alphabet->find("S")][0]) ==
          "wall S");
    CHECK(read.systems[2]->interactive->rules.size() == read.alphabet->size());
    CHECK(read.systems[3]->tables);
    CHECK(said_in<HasWord>(read.statements[0].statement).word ==
          Word{0, *read.alphabet->find("z")});
}

TEST_CASE("NOTATION.md shows each form of statements") {
    std::ifstream file(source_folder() + "/NOTATION.md");
    const std::string notation(std::istreambuf_iterator<char>(file), {});
    CHECK(written_statements().size() == 17);
    for (const std::string& written : written_statements())
        CHECK_MESSAGE(notation.find("`" + std::regex_replace(written, std::regex("[|]"), "\\|") +
                                    "`") != std::string::npos,
                      written);
}
