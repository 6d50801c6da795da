// Proofs in Coq of the table of closure.
//
// The folder theory/formal has a theorem for nearly every cell of the table, and claims name these theorems. Coq is not a part
// of algae: tools/formal compiles the proofs into a folder and writes there, at last and only if all went well, a file
// proved.json. It has the digests of the sources and of what Coq made of them, and the axioms that `Print Assumptions` finds
// behind each theorem.
//
// algae carries the sources, with table.txt, which tools/formal compares with the table that is proved in Coq. So proved.json
// cannot say what is proved, only that those sources compile. What is looked at here:
// - the sources in the folder are those that algae carries, byte by byte, and proved.json is about the same;
// - every compiled file is there, and has the digest that it had when Coq wrote it;
// - a theorem counts if it rests on no axiom.
// So neither a change of the sources nor one of the compiled files is overlooked. A person who writes a false proved.json for
// the right sources is not found out: for that tools/formal has to run again.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "command/detail/files.hpp"
#include "command/detail/formal.hpp"
#include "command/detail/verb.hpp"
#include "notation/notation.hpp"

namespace algae::command {

namespace {

/// The digest SHA-256 of bytes (FIPS 180-4), in hexadecimal digits.
class Digest {
public:
    static std::string of(std::string bytes) {
        const std::uint64_t bits = 8 * static_cast<std::uint64_t>(bytes.size());
        bytes += '\x80';
        bytes.append((119 - (bytes.size() - 1) % 64) % 64, '\0');
        for (int shift = 56; shift >= 0; shift -= 8)
            bytes += static_cast<char>(static_cast<unsigned char>(bits >> shift));
        Digest digest;
        for (std::size_t block = 0; block < bytes.size(); block += 64)
            digest.take(bytes.data() + block);
        std::string text;
        for (const std::uint32_t word : digest.state_)
            for (int shift = 28; shift >= 0; shift -= 4)
                text += "0123456789abcdef"[(word >> shift) & 15U];
        return text;
    }

private:
    using Words = std::array<std::uint32_t, 64>;

    /// The first bits of the fractional parts of the cube roots of the first primes.
    static const Words& constants() {
        static const Words all{
            0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4,
            0xab1c5ed5, 0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe,
            0x9bdc06a7, 0xc19bf174, 0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f,
            0x4a7484aa, 0x5cb0a9dc, 0x76f988da, 0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7,
            0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967, 0x27b70a85, 0x2e1b2138, 0x4d2c6dfc,
            0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85, 0xa2bfe8a1, 0xa81a664b,
            0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070, 0x19a4c116,
            0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
            0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7,
            0xc67178f2};
        return all;
    }

    void take(const char* block) {
        Words w{};
        for (std::size_t i = 0; i < 64; ++i) w[i / 4] |= byte(block[i]) << (24 - 8 * (i % 4));
        // only the first 16 words are of the block
        for (std::size_t i = 16; i < 64; ++i) {
            const std::uint32_t s0 =
                std::rotr(w[i - 15], 7) ^ std::rotr(w[i - 15], 18) ^ (w[i - 15] >> 3);
            const std::uint32_t s1 =
                std::rotr(w[i - 2], 17) ^ std::rotr(w[i - 2], 19) ^ (w[i - 2] >> 10);
            w[i] = w[i - 16] + s0 + w[i - 7] + s1;
        }
        auto [a, b, c, d, e, f, g, h] = state_;
        for (std::size_t i = 0; i < 64; ++i) {
            const std::uint32_t s1 = std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25);
            const std::uint32_t choice = (e & f) ^ (~e & g);
            const std::uint32_t first = h + s1 + choice + constants()[i] + w[i];
            const std::uint32_t s0 = std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22);
            const std::uint32_t most = (a & b) ^ (a & c) ^ (b & c);
            h = g;
            g = f;
            f = e;
            e = d + first;
            d = c;
            c = b;
            b = a;
            a = first + s0 + most;
        }
        const std::array<std::uint32_t, 8> made{a, b, c, d, e, f, g, h};
        for (std::size_t i = 0; i < 8; ++i) state_[i] += made[i];
    }
    static std::uint32_t byte(char c) { return static_cast<unsigned char>(c); }

    std::array<std::uint32_t, 8> state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                        0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
};

/// A text of a JSON object, empty where there is none.
std::string text_at(const nlohmann::json& object, const std::string& key) {
    const auto found = object.is_object() ? object.find(key) : object.end();
    return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

const nlohmann::json& part(const nlohmann::json& object, const std::string& key) {
    static const nlohmann::json none;
    return object.is_object() && object.contains(key) ? object[key] : none;
}

[[noreturn]] void refuse(const std::string& file, const std::string& what) {
    throw Error(file + ": " + what + "; tools/formal compiles the proofs");
}

}  // namespace

FormalProofs::FormalProofs(const std::string& folder, const Budget& budget) {
    if (folder.empty()) return;
    const std::string name = (std::filesystem::path(folder) / "proved.json").string();
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(name, ignored))
        refuse(folder, "expected a folder with proved.json, which tools/formal writes");
    const auto proved = nlohmann::json::parse(file_text(name, budget), nullptr, false);
    if (text_at(proved, "format") != "algae formal 1")
        refuse(name, "expected an object with the format \"algae formal 1\"");
    for (const GalleryEntry& entry : formal_texts()) {
        const nlohmann::json& digests = part(part(proved, "files"), std::string(entry.name));
        if (text_at(digests, "source") != Digest::of(std::string(entry.text)))
            refuse(name, "expected the digest of " + std::string(entry.path) +
                             " that this algae carries, found another one");
        if (!entry.path.ends_with(".v")) continue;  // the table
        const std::filesystem::path file =
            std::filesystem::path(folder) / (std::string(entry.name) + ".v");
        if (!std::filesystem::is_regular_file(file, ignored))
            refuse(file.string(), "expected this file, found none");
        if (file_text(file.string(), budget) != entry.text)
            refuse(file.string(), "expected the text of " + std::string(entry.path) +
                                      " that this algae carries, found another one");
        const std::string compiled = file.string() + "o";
        if (!std::filesystem::is_regular_file(compiled, ignored))
            refuse(compiled, "expected the compiled proofs, found none");
        if (text_at(digests, "compiled") != Digest::of(file_text(compiled, budget)))
            refuse(compiled, "expected what Coq compiled, found something else");
    }
    for (const auto& [theorem, axioms] : part(proved, "theorems").items())
        if (axioms.is_array() && axioms.empty()) theorems_.insert("formal/" + theorem);
    const auto& again = part(proved, "checked again");
    checkers_ = "Coq " + text_at(proved, "coq") +
                (again.is_boolean() && again.get<bool>() ? " and coqchk" : "");
}

bool FormalProofs::prove(const ClosureFact& fact) const { return theorems_.contains(fact.theorem); }

std::string FormalProofs::verdict(const ClosureFact& fact) const {
    return prove(fact) ? "proved formally" : "cited";
}

void FormalProofs::settle(CheckedClaim& checked) const {
    using Outcome = CheckedStatement::Outcome;
    const auto theorem = checked.theorem();
    if (!theorem || checked.statements[*theorem].outcome != Outcome::cited) return;
    const ClaimedStatement& claimed = checked.claim.statements[*theorem];
    for (const ClosureFact& fact : checked.claim.closure)
        if (fact.place == claimed.statement.place && fact.theorem == claimed.citation &&
            prove(fact))
            checked.statements[*theorem].outcome = Outcome::formally;
}

void add_formal_option(Verb& verb, std::string& folder) {
    verb.option("--formal", folder, "FOLDER",
                "where tools/formal compiled the proofs of theory/formal, build/formal: theorems "
                "that claims name are "
                "proved by these; else they are cited");
}

namespace {

/// What an operation takes, and which language it makes of X.
struct OperationWords {
    const char *operation, *given, *made;
};

constexpr OperationWords operation_words[] = {
    {"union", "all F languages X and Y over A", "that are in X or in Y"},
    {"concatenation", "all F languages X and Y over A", "uv with u in X and v in Y"},
    {"star", "every F language X over A",
     "that are products of words of X, with the product of no words, ε,"},
    {"plus", "every F language X over A", "that are products of one or more words of X"},
    {"intersection", "all F languages X and Y over A", "that are in X and in Y"},
    {"intersection with regular",
     "every F language X over A, every finite automaton over A and the language R that it accepts",
     "that are in X and in R"},
    {"complement", "every F language X over A", "over A that are not in X"},
    {"homomorphism",
     "every finite alphabet B, every map h of the letters of A to words over B and every F "
     "language X over A",
     "that words of X become where every letter x is replaced by h(x)"},
    {"non-erasing homomorphism",
     "every finite alphabet B, every map h of the letters of A to words over B other than ε and "
     "every F language X over A",
     "that words of X become where every letter x is replaced by h(x)"},
    {"inverse homomorphism",
     "every finite alphabet B, every map h of the letters of A to words over B and every F "
     "language X over B",
     "over A that become words of X where every letter x is replaced by h(x)"},
    {"reversal", "every F language X over A", "that are words of X written backwards"},
    {"finite substitution",
     "every finite alphabet B, every map s of the letters of A to finite sets of words over B and "
     "every F language X over A",
     "that words of X become where every letter x is replaced by a word of s(x), each time by any"},
    {"substitution",
     "every finite alphabet B, every map s of the letters of A to F languages over B and every F "
     "language X over A",
     "that words of X become where every letter x is replaced by a word of s(x), each time by any"},
    {"gsm mapping",
     "every finite alphabet B, every machine that reads letters of A and writes words over B, with "
     "finitely many states, choices and accepting states, and every F language X over A",
     "that the machine may write while it reads a word of X"}};

std::string family_words(const std::string& family) {
    if (family == "REG")
        return "REG: accepted by a complete deterministic automaton with finitely many states.";
    if (family == "CF")
        return "CF: the words that a grammar derives from its start, with finitely many letters "
               "that are rewritten, one at a "
               "time, each with finitely many successors.";
    if (family == "IL")
        return "IL: derived from an axiom other than ε by steps that replace all letters at once; "
               "the successors of a letter, "
               "finitely many and at least one, depend on at most m letters before it and n behind "
               "it.";
    const auto has = [&](char c) { return family.find(c) != std::string::npos; };
    const std::string successors =
        std::string(has('D') ? "one successor" : "finitely many successors, at least one") +
        (has('P') ? ", none of them ε" : "");
    return family +
           ": derived from an axiom other than ε by steps that replace all letters at once, " +
           (has('T') ? "each step by one of finitely many tables, at least one; a table gives each "
                       "letter "
                     : "by one table, which gives each letter ") +
           successors + "." +
           (has('E') ? " Of the words derived those without nonterminals, of which there are "
                       "finitely many, are in the language."
                     : "");
}

}  // namespace

std::vector<std::string> formal_words(const std::string& family, const std::string& operation,
                                      bool closed) {
    const auto found =
        std::ranges::find(operation_words, operation,
                          [](const OperationWords& words) { return std::string(words.operation); });
    if (found == std::end(operation_words)) throw Error("there are no words for " + operation);
    std::string given = found->given;
    for (std::size_t at = 0; (at = given.find("F language", at)) != std::string::npos;) {
        given.replace(at, 1, family);
        at += family.size();  // CF ends with F, too
    }
    return {std::string(closed ? "For" : "It is not so that for") + " every finite alphabet A, " +
                given + ": the language of all words " + found->made + " is " + family + ".",
            family_words(family)};
}

}  // namespace algae::command
