#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "model/model.hpp"

#include "notation/claim_said.hpp"

using namespace algae;
using Kind = LanguageTree::Kind;

namespace {

bool same(const Language& left, const Language& right) {
    if (left->kind != right->kind || left->words != right->words ||
        left->morphism != right->morphism || left->letters != right->letters ||
        left->parts.size() != right->parts.size())
        return false;
    for (std::size_t i = 0; i < left->parts.size(); ++i)
        if (!same(left->parts[i], right->parts[i])) return false;
    return left->kind != Kind::generated || left->system->name == right->system->name;
}

int below(int bound) { return *rc::gen::inRange(0, bound); }

Word any_word(std::size_t letters) {
    Word word;
    for (int i = below(4); i > 0; --i)
        word.push_back(static_cast<Symbol>(below(static_cast<int>(letters))));
    return word;
}

/// A random expression over an alphabet of as many letters.
Language any_language(std::size_t letters, int depth) {
    if (depth == 0 || below(6) == 0) {
        std::vector<Word> words;
        for (int i = below(4); i > 0; --i) words.push_back(any_word(letters));
        return words_language(std::move(words));
    }
    const auto part = [&] { return any_language(letters, depth - 1); };
    const int kind = below(10);
    if (kind < 4) {
        constexpr Kind two[] = {Kind::united, Kind::intersected, Kind::difference,
                                Kind::concatenated};
        return combined(two[kind], {part(), part()});
    }
    if (kind < 7) {
        constexpr Kind one[] = {Kind::star, Kind::plus, Kind::reversed};
        return combined(one[kind - 4], {part()});
    }
    const Language inner = part();
    if (kind == 7) {
        std::vector<Symbol> all;
        for (Symbol a = 0; a < letters; ++a) all.push_back(a);
        return complement_language(inner, std::move(all));
    }
    Morphism morphism;
    for (Symbol a = 0; a < letters; ++a) morphism.add(a, any_word(letters));
    return kind == 8 ? image_language(inner, morphism) : inverse_image_language(inner, morphism);
}

}  // namespace

TEST_CASE("finite sets") {
    CHECK(read_back("{}") == "{}");
    CHECK(read_back("{ }") == "{}");
    CHECK(read_back("{ε}") == "{ε}");
    CHECK(read_back("{aa, ε, a , aa}") == "{ε, a, aa}");
    CHECK(read_back("{a\n  b,  # a comment, with } and {\n\n # another -> one\n a # c\n b a\n}") ==
          "{ab, aba}");
    CHECK(read_back("{F+F, [a]|*}") == "{F+F, [a]|*}");
}

TEST_CASE("operations, by how tightly they hold together") {
    CHECK(read_back("{a} | {b} \\ {c} | {a}") == "{a} | {b} \\ {c} | {a}");
    CHECK(read_back("({a} | {b}) \\ ({c} | {a})") == "{a} | {b} \\ ({c} | {a})");
    CHECK(read_back("{a} | {b} & {c}") == "{a} | {b} & {c}");
    CHECK(read_back("({a} | {b}) & {c}") == "({a} | {b}) & {c}");
    CHECK(read_back("{a}{b} & {c}.{a}") == "{a} . {b} & {c} . {a}");
    CHECK(read_back("{a}({b}{c})") == "{a} . ({b} . {c})");
    CHECK(read_back("~{a}*{b}") == "~{a}* . {b}");
    CHECK(read_back("(~{a})*") == "(~{a})*");
    CHECK(read_back("~~{a}") == "~~{a}");
    CHECK(read_back("{ab}^R*+ ^R") == "{ab}^R*+^R");
    CHECK(read_back("({a}{b})+") == "({a} . {b})+");
    CHECK(read_back("{ a -> ab; b -> ε }({a, b}) | { a -> b }^-1({b})") ==
          "{ a -> ab; b -> ε }({a, b}) | { a -> b }^-1({b})");
    CHECK(read_back("L(fibonacci) & L( dragon-edges )  ") == "L(fibonacci) & L(dragon-edges)");
}

TEST_CASE("regular expressions become languages") {
    CHECK(read_back("/abc/") == "{abc}");
    CHECK(read_back("/ a b /") == "{ab}");
    CHECK(read_back("/a(aa)*/") == "{a} . {aa}*");
    CHECK(read_back("/a|ba|ε/") == "{ε, a, ba}");
    CHECK(read_back("/a|b*|a|ab/") == "{a} | {b}* | {a, ab}");
    CHECK(read_back("/ab?c+/") == "{a} . {ε, b} . {c}+");
    CHECK(read_back("/(ab|b)(a|ε)*?/") == "{b, ab} . ({ε, a}* | {ε})");
    CHECK(read_back("/(ab)(ba)/") == "{abba}");
    CHECK(read_back("/a*//b/ | /c/{a}") == "{a}* . {b} | {c} . {a}");
    CHECK(read_back("/F+-|X_1/") == "{F}+ . {-} | {X_1}");
}

TEST_CASE("names are what their definitions say") {
    const Claim read = claim(
        "let A = {a}\n"
        "let G = 0L { axiom a; a -> aa }\n"
        "let B' = A | {b}  # a comment\n"
        "let h_1 = { a -> aa\n b -> ε }  # two lines\n"
        "let C = h_1(B')^R h_1^-1(A)\n"
        "let L = A L(G) | L (G)\n"
        "let D = { a -> b }({a})\n"
        "show L == C\n");
    const auto text = [&](const Language& language) { return to_string(language, *read.alphabet); };
    REQUIRE(read.languages.size() == 5);
    CHECK(text(named(read.languages[1], "")) == "A | {b}");
    CHECK(text(named(read.languages[2], "")) ==
          "{ a -> aa; b -> ε }(B')^R . { a -> aa; b -> ε }^-1(A)");
    CHECK(text(named(read.languages[3], "")) == "A . L(G) | L(G)");
    CHECK(text(named(read.languages[4], "")) == "{ a -> b }({a})");
    CHECK(text(read.languages[3]) == "L");
    CHECK(read.languages[3]->parts[0]->parts[1]->system == read.systems.at(0));
}

TEST_CASE("complements are over all letters of the text, and those of the alphabet") {
    const auto letters = [](const std::string& lines) {
        const Claim read = claim(lines);
        return joined(read.letters, "", [&](Symbol a) { return read.alphabet->name(a); });
    };
    CHECK(letters("let A = {a}; let B = {b}; show ~A == ~B") == "ab");
    CHECK(letters("show ~{a} != {}; show c in /c|d/") == "acd");
    CHECK(letters("let A = ~{a}; let G = 0L { axiom b; b -> c }; let h = { d -> e }") == "bcade");
    CHECK(letters("let A = ~CF { S -> aSb | ε }; let B = regular { T -> cT | d }") == "abcd");
    CHECK(letters("let A = ~{a^n b^n : n >= 0}; let E = E0L { axiom S; S -> c; terminals c }") ==
          "cab");
    CHECK(letters("let A = ~{a}; theorem for all words x: x in A or x not in A") == "a");
    CHECK(letters("theorem for all languages A over {p, q}: ~~A == A") == "pq");
    CHECK(letters("alphabet z\nlet A = ~{a}") == "za");
    CHECK(letters("let A = {a}; show A is finite") == "");
    const Claim two = claim("let A = ~{a}; let B = A; let C = ~A\nshow b in {b}");
    for (const Language& language : two.languages) CHECK(letters_of(language).size() == 2);
    const WrittenLanguage more = read_language("~{a} | {b}", gallery_system, "x", {"c", "wall"});
    CHECK(more.letters.size() == 4);
    CHECK(more.language->parts[0]->letters == more.letters);
    CHECK(read_language("{a}", gallery_system, "x", {"c"}).letters.empty());
    CHECK_THROWS_WITH_AS(read_language("~{a}", gallery_system, "x", {"b("}),
                         "the alphabet: expected names without '('", Error);
    const WrittenLanguage own = read_language("~{ab}", gallery_system);
    CHECK(own.language->letters == std::vector<Symbol>{0, 1});
    const Claim read = claim("alphabet a wall b\nlet A = ~{wall b} | ~{}");
    const Language& united = read.languages.at(0);
    CHECK(united->parts[0]->letters == std::vector<Symbol>{0, 1, 2});
    CHECK(united->parts[0]->parts[0]->words == std::vector<Word>{{1, 2}});
    CHECK(united->parts[1]->letters == std::vector<Symbol>{0, 1, 2});
}

TEST_CASE("a printed language reads back as itself") {
    CHECK(rc::check([] {
        constexpr std::size_t letters = 3;
        Alphabet alphabet;
        for (const char* name : {"a", "b", "F_1"}) alphabet.symbol(name);
        // The letters in this order first, so that numbers agree.
        const Language language =
            combined(Kind::united, {words_language({{0, 1, 2}}), any_language(letters, 5)});
        const std::string text = to_string(language, alphabet);
        const WrittenLanguage read = read_language(text, gallery_system);
        RC_ASSERT(same(read.language, language));
        RC_ASSERT(to_string(read.language, *read.alphabet) == text);
    }));
}
