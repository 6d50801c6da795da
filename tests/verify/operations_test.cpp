// Membership in languages that operations make of finite ones, against sets of words that are worked out here.

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <set>
#include <string>

#include "verify/samples.hpp"

using namespace samples;
using Outcome = algae::verify::Finding::Outcome;

namespace {

constexpr std::size_t longest = 5;
using Words = std::set<std::string>;

/// A language as certificates write it, and its words up to the longest.
struct Made {
    Json json;
    Words words;
};

/// As certificates write a word: "a b".
std::string spaced(const std::string& word) {
    std::string out;
    for (const char c : word) out += (out.empty() ? "" : " ") + std::string(1, c);
    return out;
}

Words joined(const Words& left, const Words& right) {
    Words all;
    for (const std::string& one : left)
        for (const std::string& other : right)
            if (one.size() + other.size() <= longest) all.insert(one + other);
    return all;
}

Words repeated(const Words& part) {
    Words all = part;
    for (std::size_t before = 0; before != all.size();) {
        before = all.size();
        all.merge(joined(all, part));
    }
    return all;
}

Words every_word() {
    Words all{""}, last{""};
    for (std::size_t size = 0; size < longest; ++size) {
        Words next;
        for (const std::string& word : last)
            for (const char c : {'a', 'b'}) next.insert(word + c);
        all.insert(next.begin(), next.end());
        last = std::move(next);
    }
    return all;
}

class Random {
public:
    explicit Random(unsigned seed) : numbers_(seed) {}
    std::size_t below(std::size_t count) { return numbers_() % count; }

    std::string word(std::size_t least, std::size_t most) {
        std::string out;
        for (std::size_t left = least + below(most - least + 1); left > 0; --left)
            out += below(2) == 0 ? 'a' : 'b';
        return out;
    }

    Made language(int depth) {
        if (depth == 0) {
            Made made;
            for (std::size_t left = 1 + below(3); left > 0; --left) made.words.insert(word(0, 2));
            made.json["words"] = Json::array();
            for (const std::string& each : made.words) made.json["words"].push_back(spaced(each));
            return made;
        }
        const Made one = language(depth - 1);
        switch (below(10)) {
            case 0: {
                const Made other = language(depth - 1);
                Words all = one.words;
                all.insert(other.words.begin(), other.words.end());
                return {{{"union", {one.json, other.json}}}, all};
            }
            case 1: {
                const Made other = language(depth - 1);
                Words all;
                for (const std::string& each : one.words)
                    if (other.words.contains(each)) all.insert(each);
                return {{{"intersection", {one.json, other.json}}}, all};
            }
            case 2: {
                const Made other = language(depth - 1);
                Words all;
                for (const std::string& each : one.words)
                    if (!other.words.contains(each)) all.insert(each);
                return {{{"difference", {one.json, other.json}}}, all};
            }
            case 3: {
                const Made other = language(depth - 1);
                return {{{"concatenation", {one.json, other.json}}},
                        joined(one.words, other.words)};
            }
            case 4: {
                Words all = repeated(one.words);
                all.insert("");
                return {{{"star", one.json}}, all};
            }
            case 5:
                return {{{"plus", one.json}}, repeated(one.words)};
            case 6: {
                Words all;
                for (const std::string& each : one.words)
                    all.insert(std::string(each.rbegin(), each.rend()));
                return {{{"reversal", one.json}}, all};
            }
            case 7: {
                Words all;
                for (const std::string& each : every_word())
                    if (!one.words.contains(each)) all.insert(each);
                return {{{"complement", one.json}, {"letters", "a b"}}, all};
            }
            case 8: {  // images of at most one letter, so that no longer word has a short image
                const std::string a = word(0, 1), b = word(0, 1);
                Words all;
                for (const std::string& each : every_word()) {
                    std::string image;
                    for (const char c : each) image += c == 'a' ? a : b;
                    if (one.words.contains(image)) all.insert(each);
                }
                return {{{"inverse image", one.json},
                         {"morphism", {{"a", spaced(a)}, {"b", spaced(b)}}}},
                        all};
            }
            default: {  // no letter is erased, so that no longer word has a short image
                const std::string a = word(1, 2), b = word(1, 2);
                Words all;
                for (const std::string& each : one.words) {
                    std::string image;
                    for (const char c : each) image += c == 'a' ? a : b;
                    if (image.size() <= longest) all.insert(image);
                }
                return {{{"image", one.json}, {"morphism", {{"a", spaced(a)}, {"b", spaced(b)}}}},
                        all};
            }
        }
    }

private:
    std::mt19937 numbers_;
};

}  // namespace

TEST_CASE("words of languages that operations make are those that are worked out by hand") {
    Random random(11);
    std::size_t inside = 0, outside = 0, open = 0;
    for (int round = 0; round < 250; ++round) {
        const Made made = random.language(1 + round % 3);
        for (int k = 0; k < 6; ++k) {
            const std::string word = random.word(0, longest);
            const bool is_in = made.words.contains(word);
            CAPTURE(made.json.dump());
            CAPTURE(word);
            const Json statement{{"member", spaced(word)}, {"language", made.json}};
            for (const bool said : {true, false}) {
                const Outcome outcome = check(certificate(statement, said ? "proved" : "refuted",
                                                          {{"by", "membership"}}))[0]
                                            .outcome;
                if (outcome == Outcome::not_checked)
                    ++open;
                else
                    CHECK(outcome == (said == is_in ? Outcome::checked : Outcome::wrong));
            }
            ++(is_in ? inside : outside);
        }
    }
    MESSAGE(inside, " words of languages, ", outside, " others, ", open, " not checked");
    CHECK(inside > 200);
    CHECK(outside > 200);
    CHECK(open < 200);
}
