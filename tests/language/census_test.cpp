#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <random>

#include "language/language.hpp"
#include "notation/notation.hpp"
#include "verify/verify.hpp"

using namespace algae;

namespace {

/// A census of "for all WHAT X: PROPERTIES".
struct Asked {
    Claim claim;
    const Quantified* said;
    std::vector<Statement> properties;

    Asked(const std::string& what, const std::string& properties_text)
        : claim(read_claim("claim C\ntheorem for all " + what + " X: " + properties_text, "c", {})),
          said(&std::get<Quantified>(claim.statements.at(0).statement.says)) {
        const Statement& body = said->body.front();
        if (const auto* joint = std::get_if<Joint>(&body.says))
            properties = joint->parts;
        else
            properties = {body};
    }

    Census taken(const CensusOptions& options) const {
        CensusTotals totals = none(options);
        take_census(*said, properties, claim, options, totals);
        return totals.census();
    }
    CensusTotals none(const CensusOptions& options) const {
        return CensusTotals(census_size(*said), properties.size(), options);
    }
};

std::string text(const Census& census) {
    std::string all;
    for (const Census::Row& row : census.rows) {
        all += std::to_string(row.size) + ' ' + to_string(row.instances);
        for (const auto& counts : row.verdicts)
            for (const std::uint64_t count : counts) all += ' ' + std::to_string(count);
        all += ' ' + std::to_string(row.infinite) + ' ' + std::to_string(row.open) + '\n';
    }
    for (const auto& texts : census.first) all += joined(texts, " ") + '\n';
    return all + (census.is_whole ? "whole" : "part");
}

const char* const systems = "0L systems up to size 6";
const char* const of_languages = "L(X) is finite and L(X) is D0L and L(X) is PT0L";

}  // namespace

TEST_CASE("chunks of any size, taken by any number of threads in any order, make one census") {
    for (const bool languages : {false, true})
        for (const char* what : {systems, "D0L systems up to size 7", "P0L systems up to size 7"}) {
            const Asked asked(what, of_languages);
            CensusOptions options;
            options.first = 3;
            options.languages = languages;
            const std::string whole = text(asked.taken(options));
            CHECK(whole.ends_with("whole"));
            for (const std::uint64_t size : {1u, 7u, 64u})
                for (const unsigned threads : {1u, 2u, 7u}) {
                    options.chunk = size;
                    options.threads = threads;
                    CHECK(text(asked.taken(options)) == whole);
                }
            // Three takers, each with every third chunk; their chunks come in a random order, some twice.
            options.chunk = 5;
            std::vector<CensusChunk> chunks;
            for (std::uint64_t taker = 0; taker < 3; ++taker) {
                CensusOptions part = options;
                std::uint64_t next = taker;
                part.next = [&]() -> std::optional<std::uint64_t> {
                    return std::exchange(next, next + 3);
                };
                part.on_chunk = [&](const CensusChunk& chunk) {
                    CHECK(census_chunk(census_line(chunk)) == chunk);
                    chunks.push_back(chunk);
                };
                CHECK(text(asked.taken(part)).ends_with("part"));
            }
            std::mt19937 random(7);
            std::shuffle(chunks.begin(), chunks.end(), random);
            CensusTotals totals = asked.none(options);
            for (std::size_t i = 0; i < chunks.size(); ++i) {
                totals.add(chunks[i]);
                totals.add(chunks[i / 2]);
            }
            CHECK(text(totals.census()) == whole);
        }
}

TEST_CASE("what is known is not taken again, wherever it ends") {
    const Asked asked(systems, of_languages);
    CensusOptions options;
    options.chunk = 4;
    options.first = 2;
    std::vector<CensusChunk> chunks;
    options.on_chunk = [&](const CensusChunk& chunk) { chunks.push_back(chunk); };
    const std::string whole = text(asked.taken(options));
    CHECK(rc::check([&](std::uint64_t seed) {
        std::mt19937_64 random(seed);
        CensusTotals totals = asked.none(options);
        std::size_t known = 0;
        const std::size_t all = 1 + random() % chunks.size();
        for (std::size_t i = 0; i < all; ++i)
            if (random() % 3 != 0) {
                totals.add(chunks[i]);
                ++known;
            }
        CensusOptions rest = options;
        std::size_t taken = 0;
        rest.on_chunk = [&](const CensusChunk& chunk) {
            ++taken;
            RC_ASSERT(chunk == chunks.at(chunk.number));
        };
        take_census(*asked.said, asked.properties, asked.claim, rest, totals);
        RC_ASSERT(taken + known == chunks.size());
        RC_ASSERT(text(totals.census()) == whole);
    }));
}

TEST_CASE("finite languages of systems, each once up to renaming") {
    // Counts of a program that shares nothing with this one.
    const std::vector<std::pair<const char*, std::vector<int>>> known{
        {"0L systems up to size 8", {0, 1, 2, 4, 13, 39, 154, 589}},
        {"D0L systems up to size 8", {0, 1, 2, 4, 12, 37, 130, 487}}};
    for (const auto& [what, counts] : known) {
        const Asked asked(what, "L(X) is 0L");
        CensusOptions options;
        options.languages = true;
        std::vector<int> found;
        for (const Census::Row& row : asked.taken(options).rows) {
            found.push_back(static_cast<int>(row.instances.to_uint64()));
            CHECK(row.open == 0);
            CHECK(Integer(row.verdicts[0][0]) == row.instances);
        }
        CHECK(found == counts);
    }
    CensusOptions options;
    options.languages = true;
    CHECK_THROWS_WITH_AS(Asked("D0L systems up to size 3", "growth(X) ~ bounded").taken(options),
                         doctest::Contains("expected a statement about the language L(X)"), Error);
    CHECK_THROWS_WITH_AS(Asked("finite languages up to size 3", "X is 0L").taken(options),
                         doctest::Contains("expected systems whose languages are counted"), Error);
}

TEST_CASE("a chunk of another census is refused, and a torn line is no chunk") {
    const Asked asked(systems, of_languages);
    CensusTotals totals = asked.none({});
    CensusChunk chunk;
    chunk.size = 1;
    chunk.verdicts.resize(2);
    chunk.first.resize(2);
    CHECK_THROWS_WITH_AS(totals.add(chunk),
                         "expected a chunk of this census, found one of size 1 with 2 statements",
                         Error);
    chunk.size = 7;
    chunk.verdicts.resize(3);
    chunk.first.resize(3);
    CHECK_THROWS_AS(totals.add(chunk), Error);
    chunk.size = 6;
    totals.add(chunk);
    CHECK(totals.has(0));
    const std::string line = census_line(chunk);
    for (std::size_t size = 0; size < line.size(); ++size)
        CHECK_FALSE(census_chunk(line.substr(0, size)));
    CHECK_FALSE(census_chunk("{\"chunk\": \"a\"}"));
}

TEST_CASE("a sample of a census has proofs that verify checks") {
    for (const auto& [what, said] :
         {std::pair<const char*, const char*>{
              "finite languages with words up to length 2 over {a, b}", "X is 0L and X is PDT0L"},
          {"D0L systems up to size 6", "L(X) is finite and growth(X) ~ bounded"}}) {
        const Asked asked(what, said);
        const Census census = asked.taken({});
        const CheckedClaim sample =
            census_sample(*asked.said, asked.properties, asked.claim, census, 20, 1);
        REQUIRE(sample.statements.size() == 40);
        for (const verify::Finding& finding : verify::check_certificate(certificate(sample).dump()))
            CHECK(finding.outcome == verify::Finding::Outcome::checked);
        const auto texts = [&](std::uint64_t seed) {
            std::string all;
            for (const ClaimedStatement& one :
                 census_sample(*asked.said, asked.properties, asked.claim, census, 5, seed)
                     .claim.statements)
                all += one.statement.text + '\n';
            return all;
        };
        CHECK(texts(3) == texts(3));
        CHECK(texts(3) != texts(4));
        // Every instance, if more are asked for.
        std::uint64_t instances = 0;
        for (const Census::Row& row : census.rows) instances += row.instances.to_uint64();
        CHECK(census_sample(*asked.said, asked.properties, asked.claim, census, 1000, 1)
                  .statements.size() == 2 * instances);
    }
}

TEST_CASE("a line of a census says every count of its chunk") {
    for (const std::uint64_t count : {0u, 1u, 2u}) {
        CensusChunk chunk;
        chunk.open = count;
        chunk.infinite = count;
        CHECK(census_chunk(census_line(chunk)) == chunk);
    }
}

TEST_CASE("deterministic systems that are only counted make one chunk of each size") {
    const Asked asked("D0L systems up to size 6", "L(X) is 0L");
    CensusOptions options;
    options.chunk = 1;
    CensusTotals counted(6, 0, options), visited = asked.none(options);
    std::size_t chunks = 0;
    options.on_chunk = [&](const CensusChunk&) { ++chunks; };
    take_census(*asked.said, {}, asked.claim, options, counted);
    CHECK(chunks == 6);
    take_census(*asked.said, asked.properties, asked.claim, options, visited);
    for (std::size_t i = 0; i < 6; ++i)
        CHECK(counted.census().rows[i].instances == visited.census().rows[i].instances);
}
