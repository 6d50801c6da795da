#include "oracle/certificate_truth.hpp"

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <stdexcept>
#include <vector>

#include "language/language.hpp"
#include "notation/notation.hpp"
#include "oracle/finite_systems.hpp"
#include "oracle/language_words.hpp"

namespace algae::oracle {

namespace {

using Json = nlohmann::ordered_json;

/// Thrown where claims cannot say what the certificate does.
struct Unsayable {};

class ClaimWriter {
public:
    explicit ClaimWriter(const Json& certificate) : certificate_(certificate) {}

    std::string claim(const Json& statement) {
        for (const Json& name : certificate_.at("alphabet")) {
            const auto letter = name.get<std::string>();
            if (letter.size() != 1 || !std::isalnum(static_cast<unsigned char>(letter[0])))
                throw Unsayable();
        }
        const std::string said = of(statement);
        std::string text = "claim T\n";
        if (certificate_.value("empty axiom", false)) text += "allow empty axiom\n";
        return text + lets_ + "theorem " + said + '\n';
    }

private:
    static std::string plain(const Json& word) {
        std::string text = word.get<std::string>();
        text.erase(std::remove(text.begin(), text.end(), ' '), text.end());
        return text;
    }
    static std::string word(const Json& word) {
        const std::string text = plain(word);
        return text.empty() ? "ε" : text;
    }
    static std::string number(const Json& number) {
        return number.is_string() ? number.get<std::string>() : number.dump();
    }

    std::string words(const Json& all) const {
        std::string text;
        for (const Json& one : all) text += (text.empty() ? "" : ", ") + word(one);
        return "{" + text + "}";
    }

    /// A definition of what stands behind `=`, by a new name.
    std::string let(const std::string& value) {
        const std::string name = "X" + std::to_string(++names_);
        lets_ += "let " + name + " = " + value + '\n';
        return name;
    }

    std::string system(const Json& name) {
        const auto called = name.get<std::string>();
        if (bound_.contains(called)) return called;
        if (const auto known = systems_.find(called); known != systems_.end()) return known->second;
        const Json& value = certificate_.at("systems").at(called);
        if (value.contains("modules")) throw Unsayable();
        std::string text = "{ axiom " + word(value.at("axiom"));
        std::string family = "IL";
        if (value.contains("rules")) {
            if (value.contains("ignored")) throw Unsayable();
            for (const Json& rule : value["rules"])
                text += "; " + (plain(rule["left"]).empty() ? "" : plain(rule["left"]) + " < ") +
                        plain(rule["letter"]) +
                        (plain(rule["right"]).empty() ? "" : " > " + plain(rule["right"])) +
                        " -> " + word(rule["successor"]);
        } else {
            const bool extended = value.contains("terminals"), several = value["tables"].size() > 1;
            family = std::string(extended ? "E" : "") + (several ? "T" : "") + "0L";
            if (extended) text += "; terminals " + spaced(value["terminals"]);
            std::size_t number = 0;
            for (const Json& table : value["tables"]) {
                if (several) text += "; table t" + std::to_string(number++);
                for (const auto& [letter, successors] : table.items())
                    for (const Json& successor : successors)
                        text += "; " + letter + " -> " + word(successor);
            }
        }
        return systems_[called] = let(family + ' ' + text + " }");
    }
    static std::string spaced(const Json& letters) {
        if (plain(letters).empty()) throw Unsayable();
        return letters.get<std::string>();
    }

    std::string morphism(const Json& value) {
        if (value.is_string()) return value.get<std::string>();
        if (value.empty()) throw Unsayable();  // {} is the empty language
        std::string text;
        for (const auto& [letter, image] : value.items())
            text += (text.empty() ? " " : "; ") + letter + " -> " + word(image);
        return let("{" + text + " }");
    }

    std::string language(const Json& value) {
        const auto two = [&](const char* kind, const char* between) {
            return "(" + language(value[kind].at(0)) + between + language(value[kind].at(1)) + ")";
        };
        if (value.contains("words")) return words(value["words"]);
        if (value.contains("generated")) return "L(" + system(value["generated"]) + ")";
        if (value.contains("name")) return value["name"].get<std::string>();
        if (value.contains("union")) return two("union", " | ");
        if (value.contains("intersection")) return two("intersection", " & ");
        if (value.contains("difference")) return two("difference", " \\ ");
        if (value.contains("concatenation")) return two("concatenation", " . ");
        if (value.contains("star")) return "(" + language(value["star"]) + ")*";
        if (value.contains("plus")) return "(" + language(value["plus"]) + ")+";
        if (value.contains("reversal")) return "(" + language(value["reversal"]) + ")^R";
        if (value.contains("powers")) return powers(value);
        if (value.contains("image"))
            return morphism(value["morphism"]) + "(" + language(value["image"]) + ")";
        if (value.contains("inverse image"))
            return morphism(value["morphism"]) + "^-1(" + language(value["inverse image"]) + ")";
        // Within a quantifier the letters of the values are added, which no text without ~ says.
        if (value.contains("letters") == is_quantified_) throw Unsayable();
        if (is_quantified_) return "~(" + language(value.at("complement")) + ")";
        std::string letters;
        for (const char letter : plain(value["letters"]))
            letters += (letters.empty() ? "" : ", ") + std::string(1, letter);
        return "({" + letters + "}* \\ " + language(value.at("complement")) + ")";
    }

    static std::string powers(const Json& value) {
        std::string text;
        for (const Json& block : value["powers"]) {
            std::string exponent;
            for (const Json& term : block["exponent"]) {
                exponent += (exponent.empty() ? "" : "+") + number(term["coefficient"]);
                if (!term.contains("number")) continue;
                const auto name = term["number"].get<std::string>();
                if (term.contains("power") && term["power"] != 0)
                    exponent += "*" + name + "^" + number(term["power"]);
                if (term.contains("base") && term["base"] != 1)
                    exponent += "*" + number(term["base"]) + "^" + name;
            }
            text += "(" + word(block["word"]) + ")^(" + exponent + ") ";
        }
        std::string ranges;
        for (const Json& one : value["numbers"])
            ranges += (ranges.empty() ? "" : ", ") + one["name"].get<std::string>() +
                      " >= " + number(one["least"]);
        return "{" + text + ": " + ranges + "}";
    }

    /// A term with the systems by their names here.
    std::string term(const Json& value) {
        const auto text = value.get<std::string>();
        static const std::regex call("(length|count)\\(([^,()]+),");
        std::string made;
        auto from = text.cbegin();
        for (std::sregex_iterator one(text.begin(), text.end(), call), end; one != end; ++one) {
            made += std::string(from, (*one)[0].first) + (*one)[1].str() + "(" +
                    system(Json((*one)[2].str())) + ",";
            from = (*one)[0].second;
        }
        return made + std::string(from, text.cend());
    }

    std::string side(const Json& factors) {
        std::string text;
        for (const Json& factor : factors) {
            std::string one = factor.contains("word") ? word(factor["word"])
                                                      : "word(" + system(factor["system"]) + ", " +
                                                            term(factor["generation"]) + ")";
            if (factor.contains("images"))
                for (const Json& image : factor["images"]) one = morphism(image) + "(" + one + ")";
            if (factor.value("reversed", false)) one = "(" + one + ")^R";
            text += (text.empty() ? "" : " ") + one;
        }
        return text.empty() ? "ε" : text;
    }

    std::string joined(const Json& parts, const std::string& between) {
        std::string text;
        for (const Json& part : parts)
            text += (text.empty() ? "(" : " " + between + " (") + of(part) + ")";
        return parts.size() == 1 ? text : "(" + text + ")";
    }

    std::string quantified(const Json& said) {
        is_quantified_ = true;
        const bool universal = said.contains("for all");
        std::string text;
        for (const Json& name : said[universal ? "for all" : "for some"]) {
            bound_.insert(name["name"].get<std::string>());
            text += (text.empty() ? "" : " and ") + name["of"].get<std::string>() + ' ' +
                    name["name"].get<std::string>();
            if (name.contains("up to")) text += " up to " + number(name["up to"]);
            if (name.contains("size")) text += " up to size " + number(name["size"]);
            if (name.contains("length"))
                text += (name["of"] == "words" ? " up to length " : " with words up to length ") +
                        number(name["length"]);
        }
        if (said.value("different letters", false)) text += " over different letters";
        if (said.contains("over")) {
            std::string letters;
            for (const char letter : plain(said["over"]))
                letters += (letters.empty() ? "" : ", ") + std::string(1, letter);
            text += " over {" + letters + "}";
        }
        if (said.contains("with"))
            text += " with " + joined(said["with"], "and").substr(said["with"].size() == 1 ? 0 : 1);
        if (said.contains("with") && said["with"].size() > 1) text.pop_back();
        return std::string(universal ? "for all " : "for some ") + text + ": " + of(said["holds"]);
    }

    std::string of(const Json& said) {
        if (said.contains("not")) return "not (" + of(said["not"]) + ")";
        if (said.contains("is")) {
            const auto family = said["is"].get<std::string>();
            return language(said["language"]) + " is " + (family.ends_with("code") ? "a " : "") +
                   family;
        }
        if (said.contains("equal"))
            return language(said["equal"].at(0)) + " == " + language(said["equal"].at(1));
        if (said.contains("included"))
            return language(said["included"].at(0)) + " <= " + language(said["included"].at(1));
        if (said.contains("member"))
            return word(said["member"]) + " in " + language(said["language"]);
        if (said.contains("size"))
            return "|" + language(said["language"]) + "| = " + number(said["size"]);
        if (said.contains("derives")) {
            if (said.contains("probability") || !said["derives"].is_string()) throw Unsayable();
            return system(said["system"]) +
                   (said.contains("from") ? " : " + word(said["from"]) : "") + " ==> " +
                   word(said["derives"]) +
                   (said.contains("steps") ? " in " + number(said["steps"]) + " steps" : "");
        }
        const auto systems = [&](const char* kind, const std::string& function) {
            return function + "(" + system(said[kind].at(0)) + ") == " + function + "(" +
                   system(said[kind].at(1)) + ")";
        };
        if (said.contains("equal sequences")) return systems("equal sequences", "sequence");
        if (said.contains("equal growth")) return systems("equal growth", "growth");
        if (said.contains("growth"))
            return "growth(" + system(said["growth"]) + ") ~ " + said["class"].get<std::string>() +
                   (said.contains("degree") ? " " + number(said["degree"]) : "");
        if (said.contains("increasing"))
            return "growth(" + system(said["increasing"]) + ") is " +
                   (said.value("strictly", false) ? "strictly increasing" : "increasing");
        if (said.contains("palindrome")) return word(said["palindrome"]) + " is a palindrome";
        if (said.contains("numbers") && said.dump().find("segments(") != std::string::npos)
            throw Unsayable();  // a turtle stands beside the system
        if (said.contains("numbers") && said.dump().find("boxes(") != std::string::npos)
            throw Unsayable();
        if (said.contains("numbers"))
            return term(said["numbers"].at(0)) + ' ' + said["numbers"].at(1).get<std::string>() +
                   ' ' + term(said["numbers"].at(2));
        if (said.contains("words"))
            return side(said["words"].at(0)) + ' ' + said["words"].at(1).get<std::string>() + ' ' +
                   side(said["words"].at(2));
        if (said.contains("all of")) return joined(said["all of"], "and");
        if (said.contains("any of")) return joined(said["any of"], "or");
        if (said.contains("implies")) return joined(said["implies"], "implies");
        if (said.contains("iff")) return joined(said["iff"], "iff");
        if (said.contains("for all") || said.contains("for some")) return quantified(said);
        throw Unsayable();
    }

    const Json& certificate_;
    std::string lets_;
    std::map<std::string, std::string> systems_;
    std::set<std::string> bound_;
    bool is_quantified_ = false;
    std::size_t names_ = 0;
};

// --- Word by word ---

constexpr std::size_t longest = 6;

using Words = std::set<Word>;

/// The words of each language up to the greatest length, of at most 6, for which they are few.
std::optional<std::vector<Words>> short_words(const std::vector<Language>& languages,
                                              std::size_t at_least = 0) {
    for (std::size_t length = longest; length >= std::max<std::size_t>(at_least, 1); --length) try {
            std::vector<Words> all;
            for (const Language& language : languages) {
                auto words = language_words(language, length);
                if (!words) return std::nullopt;
                all.push_back(std::move(*words));
            }
            return all;
        } catch (const std::logic_error&) {  // too many
        }
    return std::nullopt;
}

/// False where short words speak against the statement; true where they decide that it holds.
struct ByWords {
    std::optional<bool> operator()(const InFamily& said) const {
        // All systems are written down for two letters and words of at most two letters.
        static const std::set<std::string> decided = {"0L",  "P0L",  "D0L",  "PD0L",
                                                      "T0L", "PT0L", "DT0L", "PDT0L"};
        if (said.language->kind != LanguageTree::Kind::words || empty_axiom ||
            !decided.contains(said.family))
            return std::nullopt;
        std::map<Symbol, int> letters;
        for (const Word& word : said.language->words) {
            if (word.size() > 2) return std::nullopt;
            for (const Symbol a : word) letters.emplace(a, static_cast<int>(letters.size()));
        }
        if (letters.size() > 2) return std::nullopt;
        static std::map<std::string, std::set<std::uint64_t>> all;
        if (!all.contains(said.family)) {
            const auto has = [&](char c) { return said.family.find(c) != std::string::npos; };
            const FiniteSystems systems(2, 2, has('P'), has('D'));
            all[said.family] = has('T') ? systems.with_tables() : systems.without_tables();
        }
        const auto universe = FiniteSystems::words(2, 2);
        std::uint64_t bits = 0;
        for (const Word& word : said.language->words) {
            std::string text;
            for (const Symbol a : word) text += static_cast<char>('a' + letters.at(a));
            const auto place = std::find(universe.begin(), universe.end(), text);
            bits |= std::uint64_t{1} << (place - universe.begin());
        }
        return all.at(said.family).contains(bits);
    }
    std::optional<bool> operator()(const IsEmpty& said) const {
        const auto words = short_words({said.language});
        return words && !words->at(0).empty() ? std::optional(false) : std::nullopt;
    }
    std::optional<bool> operator()(const EqualLanguages& said) const {
        const auto words = short_words({said.left, said.right});
        return words && words->at(0) != words->at(1) ? std::optional(false) : std::nullopt;
    }
    std::optional<bool> operator()(const IncludedIn& said) const {
        const auto words = short_words({said.inner, said.outer});
        return words && !std::includes(words->at(1).begin(), words->at(1).end(),
                                       words->at(0).begin(), words->at(0).end())
                   ? std::optional(false)
                   : std::nullopt;
    }
    std::optional<bool> operator()(const HasWord& said) const {
        const auto words = short_words({said.language}, said.word.size());
        return words ? std::optional(words->at(0).contains(said.word)) : std::nullopt;
    }
    template <class Said>
    std::optional<bool> operator()(const Said&) const {
        return std::nullopt;
    }

    bool empty_axiom = false;
};

}  // namespace

std::optional<std::string> claim_of(const Json& certificate, const Json& statement) {
    try {
        return ClaimWriter(certificate).claim(statement);
    } catch (const Unsayable&) {
        return std::nullopt;
    } catch (const Json::exception&) {
        return std::nullopt;
    }
}

CertificateTruth truth_of(const Json& certificate, const Json& statement, const Budget& budget) {
    const auto text = claim_of(certificate, statement);
    if (!text) return {};
    try {
        Claim claim = read_claim(*text, "certificate", {});
        const Statement said = claim.statements.at(0).statement;
        const auto by_words = std::visit(ByWords{claim.empty_axiom}, said.says);
        const std::optional<bool> word_verdict =
            by_words ? std::optional(*by_words != said.negated) : std::nullopt;
        const Truth truth = decide(said, claim, budget, {2'000, 6, 1, nullptr}).truth;
        if (truth != Truth::undecided && word_verdict && (truth == Truth::proved) != *word_verdict)
            return {false, "the judge and short words disagree on\n" + *text};
        if (truth != Truth::undecided) return {truth == Truth::proved, "judge"};
        if (word_verdict) return {word_verdict, "words"};
    } catch (const Error&) {  // claims do not allow it
    } catch (const BoundReached&) {
    }
    return {};
}

}  // namespace algae::oracle
