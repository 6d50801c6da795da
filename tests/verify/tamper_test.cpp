// Every field of sound certificates is changed, removed and doubled. What still passes must be true: it says the
// same as before, or a slow second route that shares no code with the checker confirms it.

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <set>

#include "exact/exact.hpp"
#include "oracle/finite_systems.hpp"
#include "verify/samples.hpp"

using namespace samples;
using Outcome = algae::verify::Finding::Outcome;
using algae::Rational;

namespace {

using Words = std::set<std::string>;  // one character a letter

constexpr std::size_t longest_form = 13;  // of words on the way
constexpr std::size_t longest = 6;        // of words that are compared

std::string plain(const Json& word) {
    std::string text = word.get<std::string>();
    text.erase(std::remove(text.begin(), text.end(), ' '), text.end());
    return text;
}

Words one_step(const Json& system, const std::string& word) {
    Words results;
    if (system.contains("rules")) {
        std::string next;
        const std::string ignored = system.contains("ignored") ? plain(system["ignored"]) : "";
        for (std::size_t i = 0; i < word.size(); ++i) {
            std::string before, after;
            for (std::size_t k = 0; k < word.size(); ++k)
                if (k != i && ignored.find(word[k]) == std::string::npos)
                    (k < i ? before : after) += word[k];
            std::optional<std::string> best;
            std::size_t size = 0;
            for (const Json& rule : system["rules"]) {
                const std::string left = plain(rule["left"]), right = plain(rule["right"]);
                if (plain(rule["letter"]) != std::string(1, word[i]) || !before.ends_with(left) ||
                    !after.starts_with(right))
                    continue;
                if (best && left.size() + right.size() <= size) continue;
                size = left.size() + right.size();
                best = plain(rule["successor"]);
            }
            next += best.value_or(std::string(1, word[i]));
        }
        return {next};
    }
    for (const Json& table : system["tables"]) {
        Words built{""};
        for (const char letter : word) {
            Words longer;
            const std::string name(1, letter);
            for (const std::string& start : built)
                if (table.contains(name))
                    for (const Json& image : table[name]) longer.insert(start + plain(image));
                else
                    longer.insert(start + name);
            std::erase_if(longer,
                          [](const std::string& each) { return each.size() > longest_form; });
            built = std::move(longer);
        }
        results.merge(built);
    }
    return results;
}

Words forms(const Json& system, const std::string& from) {
    Words known{from};
    std::vector<std::string> open{from};
    while (!open.empty()) {
        const std::string word = open.back();
        open.pop_back();
        for (const std::string& next : one_step(system, word))
            if (next.size() <= longest_form && known.insert(next).second) open.push_back(next);
    }
    return known;
}

Words all_words(const std::string& letters, std::size_t most) {
    Words all{""};
    std::vector<std::string> last{""};
    for (std::size_t n = 0; n < most; ++n) {
        std::vector<std::string> next;
        for (const std::string& word : last)
            for (const char letter : letters) next.push_back(word + letter);
        all.insert(next.begin(), next.end());
        last = next;
    }
    return all;
}

/// The words with powers up to `most` letters: all values of the numbers up to that are put in.
Words powers(const Json& language, std::size_t most) {
    const Json& numbers = language["numbers"];
    const auto number = [](const Json& value) {
        return value.is_string() ? std::stoull(value.get<std::string>())
                                 : value.get<std::uint64_t>();
    };
    Words all;
    for (std::uint64_t n = 0; n <= most; ++n)
        for (std::uint64_t m = 0; m <= (numbers.size() > 1 ? most : 0); ++m) {
            std::map<std::string, std::uint64_t> values;
            for (std::size_t i = 0; i < numbers.size(); ++i)
                values[numbers[i]["name"].get<std::string>()] =
                    number(numbers[i]["least"]) + (i == 0 ? n : m);
            std::string word;
            for (const Json& block : language["powers"]) {
                std::uint64_t times = 0;
                for (const Json& term : block["exponent"]) {
                    std::uint64_t product = number(term["coefficient"]);
                    if (term.contains("number")) {
                        const std::uint64_t value = values[term["number"].get<std::string>()];
                        const std::uint64_t power =
                                                term.contains("power") ? number(term["power"]) : 0,
                                            base = term.contains("base") ? number(term["base"]) : 1;
                        for (std::uint64_t i = 0; i < power && product < 100; ++i) product *= value;
                        for (std::uint64_t i = 0; i < value && product < 100; ++i) product *= base;
                    }
                    times += std::min<std::uint64_t>(product, 100);
                }
                for (; times > 0 && word.size() <= most; --times) word += plain(block["word"]);
            }
            if (word.size() <= most) all.insert(word);
        }
    return all;
}

/// Whether many sets of words follow beginnings of words with powers, where there are enough short words to tell.
bool has_many_residuals(const Json& language) {
    constexpr std::size_t half = 14;
    const Words all = powers(language, 2 * half);
    if (all.size() < 7) return true;
    std::map<std::string, Words> after;
    for (const std::string& word : all)
        for (std::size_t size = 0; size <= std::min(half, word.size()); ++size)
            if (word.size() - size <= half) after[word.substr(0, size)].insert(word.substr(size));
    std::set<Words> different;
    for (const auto& [beginning, rest] : after) different.insert(rest);
    return different.size() > 6;
}

/// Whether some word is a product of words of the language in two ways, or one begins with another.
bool is_code(const Words& language, bool prefix) {
    if (language.contains("")) return false;
    for (const std::string& word : language)
        for (const std::string& other : language)
            if (prefix && word != other && word.starts_with(other)) return false;
    std::map<std::string, int> ways{{"", 1}};
    const Words in_order = all_words("ab", 10);  // beginnings stand before what begins with them
    for (const std::string& word : in_order) {
        int count = 0;
        for (const std::string& last : language)
            if (word.ends_with(last) && !word.empty()) {
                const auto before = ways.find(word.substr(0, word.size() - last.size()));
                if (before != ways.end()) count += before->second;
            }
        if (count > 1) return false;
        if (count == 1) ways[word] = 1;
    }
    return true;
}

/// The words of a language up to `most` letters.
Words words(const Json& language, const Json& systems, std::size_t most) {
    const auto of = [&](const Json& part, std::size_t size) { return words(part, systems, size); };
    const auto short_ones = [&](Words all) {
        std::erase_if(all, [&](const std::string& word) { return word.size() > most; });
        return all;
    };
    Words all;
    if (language.contains("words")) {
        for (const Json& word : language["words"]) all.insert(plain(word));
    } else if (language.contains("generated")) {
        const Json& system = systems[language["generated"].get<std::string>()];
        all = forms(system, plain(system["axiom"]));
        if (system.contains("terminals"))
            std::erase_if(all, [&](const std::string& word) {
                return word.find_first_not_of(plain(system["terminals"])) != std::string::npos;
            });
    } else if (language.contains("union")) {
        all = of(language["union"][0], most);
        all.merge(of(language["union"][1], most));
    } else if (language.contains("intersection") || language.contains("difference")) {
        const bool both = language.contains("intersection");
        const Json& parts = language[both ? "intersection" : "difference"];
        all = of(parts[0], most);
        const Words other = of(parts[1], most);
        std::erase_if(all, [&](const std::string& word) { return other.contains(word) != both; });
    } else if (language.contains("concatenation")) {
        for (const std::string& left : of(language["concatenation"][0], most))
            for (const std::string& right : of(language["concatenation"][1], most))
                all.insert(left + right);
    } else if (language.contains("star") || language.contains("plus")) {
        const Words part =
            of(language.contains("star") ? language["star"] : language["plus"], most);
        Words last = part;
        all = part;
        for (std::size_t n = 0; n < most; ++n) {
            Words next;
            for (const std::string& left : last)
                for (const std::string& right : part)
                    if (left.size() + right.size() <= most) next.insert(left + right);
            all.insert(next.begin(), next.end());
            last = next;
        }
        if (language.contains("star")) all.insert("");
    } else if (language.contains("reversal")) {
        for (const std::string& word : of(language["reversal"], most))
            all.emplace(word.rbegin(), word.rend());
    } else if (language.contains("powers")) {
        all = powers(language, most);
    } else if (language.contains("complement")) {
        const Words part = of(language["complement"], most);
        std::string letters;  // its own, where none are named
        for (const std::string& word : part)
            for (const char letter : word)
                if (letters.find(letter) == std::string::npos) letters += letter;
        if (language.contains("letters")) letters = plain(language["letters"]);
        for (const std::string& word : all_words(letters, most))
            if (!part.contains(word)) all.insert(word);
    } else {
        const bool forward = language.contains("image");
        const Json& morphism = language["morphism"];
        const auto image = [&](const std::string& word) -> std::optional<std::string> {
            std::string mapped;
            for (const char letter : word) {
                if (!morphism.contains(std::string(1, letter))) return std::nullopt;
                mapped += plain(morphism[std::string(1, letter)]);
            }
            return mapped;
        };
        const Words part = of(language[forward ? "image" : "inverse image"], 2 * longest);
        for (const std::string& word : forward ? part : all_words("ab", most)) {
            const auto mapped = image(word);
            if (mapped && (forward || part.contains(*mapped))) all.insert(forward ? *mapped : word);
        }
    }
    return short_ones(std::move(all));
}

/// The first words of a D0L system.
std::vector<std::string> sequence(const Json& system, std::size_t count) {
    std::vector<std::string> all{plain(system["axiom"])};
    while (all.size() < count && all.back().size() < 3000) {
        std::string next;
        for (const char letter : all.back()) {
            const Json& table = system["tables"][0];
            const std::string name(1, letter);
            next += table.contains(name) ? plain(table[name][0]) : name;
        }
        all.push_back(next);
    }
    return all;
}

/// The value of a term for one n, by walking through its text; nothing where it has none.
class TermValue {
public:
    TermValue(std::string text, long n, const Json& systems)
        : text_(std::move(text)), n_(n), systems_(systems) {}

    std::optional<Rational> whole() {
        const auto value = sum();
        return at_ == text_.size() ? value : std::nullopt;
    }

private:
    bool take(char c) {
        while (at_ < text_.size() && text_[at_] == ' ') ++at_;
        if (at_ == text_.size() || text_[at_] != c) return false;
        ++at_;
        while (at_ < text_.size() && text_[at_] == ' ') ++at_;
        return true;
    }
    std::optional<Rational> sum() {
        auto value = product();
        while (value) {
            const bool plus = take('+');
            if (!plus && !take('-')) break;
            const auto next = product();
            if (!next) return std::nullopt;
            value = plus ? *value + *next : *value - *next;
        }
        return value;
    }
    std::optional<Rational> product() {
        auto value = raised();
        while (value) {
            const bool times = take('*');
            if (!times && !take('/')) break;
            const auto next = raised();
            if (!next || (!times && next->is_zero())) return std::nullopt;
            value = times ? *value * *next : *value / *next;
        }
        return value;
    }
    std::optional<Rational> raised() {
        if (take('-')) {
            const auto value = raised();
            return value ? std::optional(-*value) : std::nullopt;
        }
        const auto base = operand();
        if (!base || !take('^')) return base;
        const auto exponent = raised();
        if (!exponent || !exponent->is_integer() || abs(*exponent) > Rational(60))
            return std::nullopt;
        const long k = exponent->numerator().to_int64();
        if (k < 0 && base->is_zero()) return std::nullopt;
        return power(*base, k);
    }
    std::optional<Rational> operand() {
        if (take('(')) {
            const auto value = sum();
            return take(')') ? value : std::nullopt;
        }
        std::size_t end = at_;
        while (end < text_.size() && std::isalnum(static_cast<unsigned char>(text_[end]))) ++end;
        const std::string token = text_.substr(at_, end - at_);
        at_ = end;
        if (token == "n") return Rational(n_);
        if (token == "length" && take('(')) {
            const std::size_t comma = text_.find(',', at_);
            if (comma == std::string::npos) return std::nullopt;
            const std::string name = text_.substr(at_, comma - at_);
            at_ = comma + 1;
            const auto generation = sum();
            if (!take(')') || !generation || !systems_.contains(name)) return std::nullopt;
            if (!generation->is_integer() || *generation < 0 || *generation > Rational(10))
                return std::nullopt;
            const auto g = static_cast<std::size_t>(generation->numerator().to_int64());
            const auto words = sequence(systems_[name], g + 1);
            if (words.size() <= g) return std::nullopt;
            return Rational(static_cast<long>(words[g].size()));
        }
        if (token.empty() || !std::all_of(token.begin(), token.end(),
                                          [](unsigned char c) { return std::isdigit(c) != 0; }))
            return std::nullopt;
        return Rational(std::string_view(token));
    }

    std::string text_;
    long n_;
    const Json& systems_;
    std::size_t at_ = 0;
};

/// Whether a comparison of numbers or of words is true for one n.
std::optional<bool> compared(const Json& statement, long n, const Json& systems) {
    const auto by = [](const std::string& sign, auto left, auto right) -> std::optional<bool> {
        if (sign == "=" || sign == "==") return left == right;
        if (sign == "!=") return left != right;
        if (sign == "<") return left < right;
        if (sign == "<=") return left <= right;
        if (sign == ">") return left > right;
        if (sign == ">=") return left >= right;
        return std::nullopt;
    };
    if (statement.contains("numbers")) {
        const Json& parts = statement["numbers"];
        const auto left = TermValue(parts[0], n, systems).whole(),
                   right = TermValue(parts[2], n, systems).whole();
        if (!left || !right) return std::nullopt;
        return by(parts[1], *left, *right);
    }
    if (!statement.contains("words")) return std::nullopt;
    const Json& parts = statement["words"];
    const auto side = [&](const Json& factors) -> std::optional<std::string> {
        std::string all;
        for (const Json& factor : factors) {
            if (factor.contains("images") || factor.contains("reversed")) return std::nullopt;
            if (factor.contains("word")) {
                all += plain(factor["word"]);
                continue;
            }
            const auto g = TermValue(factor["generation"], n, systems).whole();
            if (!g || !g->is_integer() || *g < 0 || *g > Rational(10)) return std::nullopt;
            const auto words = sequence(systems[factor["system"].get<std::string>()],
                                        static_cast<std::size_t>(g->numerator().to_int64()) + 1);
            if (words.size() <= static_cast<std::size_t>(g->numerator().to_int64()))
                return std::nullopt;
            all += words.back();
        }
        return all;
    };
    const auto left = side(parts[0]), right = side(parts[2]);
    if (!left || !right) return std::nullopt;
    if (parts[1] == "begins with") return left->starts_with(*right);
    if (parts[1] == "ends with") return left->ends_with(*right);
    return by(parts[1], *left, *right);
}

/// Whether nothing among short words and first generations speaks against the statement; nothing where they do
/// not decide it.
std::optional<bool> truth(const Json& statement, const Json& systems) {
    if (statement.contains("not")) {
        const auto opposite = truth(statement["not"], systems);
        return opposite ? std::optional(!*opposite) : std::nullopt;
    }
    const auto of = [&](const Json& language, std::size_t most = longest) {
        return words(language, systems, most);
    };
    if (statement.contains("member"))
        return of(statement["language"]).contains(plain(statement["member"]));
    if (statement.contains("size")) {
        const Json& size = statement["size"];
        return std::to_string(of(statement["language"], 2 * longest).size()) ==
               (size.is_string() ? size.get<std::string>() : size.dump());
    }
    if (statement.contains("equal")) return of(statement["equal"][0]) == of(statement["equal"][1]);
    if (statement.contains("included")) {
        const Words left = of(statement["included"][0]), right = of(statement["included"][1]);
        return std::includes(right.begin(), right.end(), left.begin(), left.end());
    }
    if (statement.contains("derives")) {
        const Json& system = systems[statement["system"].get<std::string>()];
        const std::string from = plain(statement.contains("from") ? statement["from"]
                                                                  : system["axiom"]),
                          to = plain(statement["derives"]);
        if (!statement.contains("steps")) return forms(system, from).contains(to);
        Words now{from};
        std::uint64_t steps = statement["steps"].is_string()
                                  ? std::stoull(statement["steps"].get<std::string>())
                                  : statement["steps"].get<std::uint64_t>();
        if (steps > 20) steps = 20 + steps % 2;  // what repeats here repeats with period 1 or 2
        for (; steps > 0; --steps) {
            Words next;
            for (const std::string& word : now) next.merge(one_step(system, word));
            std::erase_if(next, [](const std::string& word) { return word.size() > longest_form; });
            now = next;
        }
        return now.contains(to);
    }
    if (statement.contains("equal sequences") || statement.contains("equal growth")) {
        const bool letters = statement.contains("equal sequences");
        const Json& names = statement[letters ? "equal sequences" : "equal growth"];
        const auto left = sequence(systems[names[0].get<std::string>()], 10),
                   right = sequence(systems[names[1].get<std::string>()], 10);
        for (std::size_t n = 0; n < std::min(left.size(), right.size()); ++n)
            if (letters ? left[n] != right[n] : left[n].size() != right[n].size()) return false;
        return true;
    }
    if (statement.contains("class")) {
        const auto all = sequence(systems[statement["growth"].get<std::string>()], 11);
        const auto size = [&](std::size_t n) {
            return static_cast<double>(all[std::min(n, all.size() - 1)].size());
        };
        const bool fast = all.size() < 11 || size(10) > 20, still = size(10) == size(8);
        const std::string found = size(10) == 0 ? "zero"
                                  : fast        ? "exponential"
                                  : still       ? "bounded"
                                                : "polynomial";
        const bool degree =
            !statement.contains("degree") || statement["degree"] == 1 || statement["degree"] == "1";
        return found == statement["class"].get<std::string>() && degree;
    }
    if (statement.contains("numbers") || statement.contains("words"))
        return compared(statement, 0, systems);
    if (statement.contains("for all") || statement.contains("for some")) {
        const bool universal = statement.contains("for all");
        Json body = statement["holds"];
        const bool negated = body.contains("not");
        if (negated) body = Json(body["not"]);
        for (long n = 0; n < 8; ++n) {
            bool meets = true;
            if (statement.contains("with"))
                for (const Json& condition : statement["with"])
                    meets = meets && compared(condition, n, systems).value_or(false);
            const auto found = meets ? compared(body, n, systems) : std::nullopt;
            if (found && (*found != negated) != universal) return !universal;
        }
        return universal;
    }
    if (statement["is"] == "empty") return of(statement["language"]).empty();
    if (statement["is"] == "finite")
        return of(statement["language"]) == of(statement["language"], 2 * longest);
    return std::nullopt;
}

/// Whether a finite language of words of at most two letters is of a family without context.
bool is_of(const Json& family, const Words& language) {
    static std::map<std::string, std::set<std::uint64_t>> all;
    const std::string name = family.get<std::string>();
    if (!all.contains(name)) {
        const bool tables = name.find('T') != std::string::npos;
        const algae::oracle::FiniteSystems systems(2, 2, name.find('P') != std::string::npos,
                                                   name.find('D') != std::string::npos);
        all[name] = tables ? systems.with_tables() : systems.without_tables();
    }
    const auto universe = algae::oracle::FiniteSystems::words(2, 2);
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < universe.size(); ++i)
        if (language.contains(universe[i])) bits |= std::uint64_t{1} << i;
    return all.at(name).contains(bits);
}

/// Throws no doubt on a certificate that was accepted: whether what it says can be true.
bool can_be_true(const Json& certificate) {
    const Json& systems = certificate["systems"];
    const Json& entry = certificate["statements"][0];
    Json statement = entry["statement"];
    bool holds = entry["verdict"] == "proved";
    for (; statement.contains("not"); holds = !holds) statement = Json(statement["not"]);
    if (statement.contains("palindrome")) {
        const std::string word = plain(statement["palindrome"]);
        return (word == std::string(word.rbegin(), word.rend())) == holds;
    }
    if (statement.contains("is") && (statement["is"] == "code" || statement["is"] == "prefix code"))
        return is_code(words(statement["language"], systems, longest),
                       statement["is"] == "prefix code") == holds;
    if (statement.contains("is") && statement["language"].contains("powers")) {
        if (statement["is"] == "finite") return !holds;
        if (statement["is"] == "REG" && !holds) return has_many_residuals(statement["language"]);
    }
    if (statement.contains("is") && statement["is"] != "finite" && statement["is"] != "empty") {
        static const std::set<std::string> decided = {"0L",  "P0L",  "D0L",  "PD0L",
                                                      "T0L", "PT0L", "DT0L", "PDT0L"};
        const Words all = words(statement["language"], systems, 2 * longest);
        const bool is_short = std::all_of(all.begin(), all.end(),
                                          [](const std::string& word) { return word.size() <= 2; });
        if (!decided.contains(statement["is"].get<std::string>()))
            return holds || !is_short;  // all finite ones are, but {ε}
        return !is_short || is_of(statement["is"], all) == holds;
    }
    const auto found = truth(statement, systems);
    return !found || *found == holds;
}

/// A budget that keeps thousands of changed certificates short; what it cuts off does not pass.
algae::Budget short_budget() {
    algae::Budget budget = small_budget();
    budget.memory = 1 << 20;
    budget.deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds(50);
    return budget;
}

/// Calls visit for every value in the JSON, with its pointer.
void each_value(const Json& value, const Json::json_pointer& at,
                const std::function<void(const Json::json_pointer&)>& visit) {
    visit(at);
    if (value.is_object())
        for (const auto& [key, part] : value.items()) each_value(part, at / key, visit);
    if (value.is_array())
        for (std::size_t i = 0; i < value.size(); ++i) each_value(value[i], at / i, visit);
}

/// What a value may be changed to.
std::vector<Json> others(const Json& value) {
    if (value.is_number()) return {0, 1, 2, 3, 5, -1, 1.5, "7", true, nullptr};
    if (value.is_string())
        return {"",
                "a",
                "b",
                "a a",
                "a b",
                "b a",
                "0L",
                "P0L",
                "D0L",
                "PD0L",
                "PDT0L",
                "finite",
                "empty",
                "REG",
                "CF",
                "E0L",
                "left",
                "right",
                "sources",
                "needed",
                "no image",
                "values",
                "identical",
                "form",
                "terms",
                "word",
                "lengths",
                "exhausted",
                "membership",
                "derivatives",
                "relations",
                "proved",
                "refuted",
                "polynomial",
                "bounded",
                "exponential",
                "F",
                "G",
                "S",
                "W",
                "P",
                "E",
                "T",
                "2^n",
                "n+2",
                "0",
                "3",
                4,
                Json::array(),
                Json::object()};
    if (value.is_array()) {
        std::vector<Json> all{Json::array(), "a"};
        for (std::size_t i = 0; i < value.size(); ++i) {
            Json without = value, twice = value;
            without.erase(i);
            twice.push_back(value[i]);
            all.push_back(without);
            all.push_back(twice);
        }
        Json turned = value;
        std::reverse(turned.begin(), turned.end());
        all.push_back(turned);
        return all;
    }
    std::vector<Json> all{Json::object(), "a", Json{{"words", Json::array({"a"})}},
                          Json{{"generated", "G"}}, Json{{"not", value}}};
    for (const auto& [key, part] : value.items()) {
        Json without = value, more = value;
        without.erase(key);
        more[key + "s"] = part;
        all.push_back(without);
        all.push_back(more);
    }
    return all;
}

}  // namespace

TEST_CASE("the second route agrees with all sound certificates") {
    for (const Sample& sample : sound()) {
        INFO(sample.statement << " " << sample.verdict);
        CHECK(can_be_true(certificate(sample)));
    }
}

TEST_CASE("no changed certificate passes for something false" * doctest::test_suite("long")) {
    std::size_t changed = 0, passed = 0;
    for (const Sample& sample : sound()) {
        Json good = certificate(sample);
        for (const char* name : {"C", "E", "H", "Q", "T", "U", "V", "X", "Y"})
            if (std::string(sample.statement).find('"' + std::string(name) + '"') ==
                std::string::npos)
                good["systems"].erase(name);
        // The whole statement, and those systems that it names.
        std::vector<Json::json_pointer> places;
        const auto note = [&](const Json::json_pointer& at) { places.push_back(at); };
        each_value(good["statements"], Json::json_pointer("/statements"), note);
        for (const auto& [name, system] : good["systems"].items())
            if (std::string(sample.statement).find('"' + name + '"') != std::string::npos)
                each_value(system, Json::json_pointer("/systems") / name, note);
        for (const auto& place : places)
            for (const Json& other : others(good[place])) {
                Json bad = good;
                bad[place] = other;
                if (bad == good) continue;
                ++changed;
                try {
                    const auto found = check(bad, short_budget());
                    if (found.empty() || found[0].outcome != Outcome::checked) continue;
                } catch (const algae::Error&) {
                    continue;
                } catch (const algae::BoundReached&) {
                    continue;
                }
                ++passed;
                if (!can_be_true(bad))
                    FAIL_CHECK(std::string(place.to_string() + " := " + other.dump() +
                                           " passes: " + bad["statements"].dump()));
            }
    }
    CHECK(changed > 10'000);
    CHECK(passed < changed / 4);
}

TEST_CASE("an expression over systems is found within a regular one only if its short words are") {
    const Json all_systems = systems();
    const std::vector<Json> rights{
        Json::parse(R"({"star": {"words": ["a", "b"]}})"),
        Json::parse(R"({"star": {"words": ["a"]}})"),
        Json::parse(R"({"plus": {"words": ["a", "a b", "b b"]}})"),
        Json::parse(R"({"complement": {"words": ["", "a a", "b"]}, "letters": "a b"})"),
        Json::parse(R"({"concatenation": [{"star": {"words": ["a", "b"]}}, {"words": ["a"]}]})")};
    const std::vector<Json> filters{Json::parse(R"({"star": {"words": ["a b", "a a"]}})"),
                                    Json::parse(R"({"star": {"words": ["a", "b b"]}})")};
    std::size_t within = 0, beyond = 0, longer = 0;
    CHECK(rc::check([&] {
        const std::function<Json(int)> any = [&](int depth) -> Json {
            const auto one = [&](const char* kind) {
                return Json::object({{kind, any(depth - 1)}});
            };
            const auto two = [&](const char* kind) {
                return Json::object({{kind, Json::array({any(depth - 1), any(depth - 1)})}});
            };
            const int way = depth > 0 ? *rc::gen::inRange(0, 9) : 8;
            if (way < 2) return two(way == 0 ? "union" : "concatenation");
            if (way < 5) return one(way == 2 ? "star" : way == 3 ? "plus" : "reversal");
            if (way == 5) {
                Json image = one("image");
                image["morphism"] = Json::parse(R"({"a": "b", "b": "a b"})");
                return image;
            }
            if (way < 8)
                return Json::object({{way == 6 ? "intersection" : "difference",
                                      Json::array({any(depth - 1), filters[way == 6 ? 0 : 1]})}});
            return Json::object(
                {{"generated", *rc::gen::element<std::string>("F", "G", "E", "T", "P", "S", "W")}});
        };
        const Json left = any(*rc::gen::inRange(0, 3)), right = *rc::gen::elementOf(rights);
        const Json statement = Json::object({{"included", Json::array({left, right})}});
        const auto found =
            check(certificate(statement, "proved", Json::object({{"by", "relations"}})))[0];
        RC_PRE(found.outcome != Outcome::not_checked);
        const Words shorts = words(left, all_systems, longest),
                    others = words(right, all_systems, longest);
        const bool is_within =
            std::includes(others.begin(), others.end(), shorts.begin(), shorts.end());
        const bool is_checked = found.outcome == Outcome::checked;
        RC_ASSERT(!is_checked || is_within);
        (is_checked ? within : is_within ? longer : beyond) += 1;
    }));
    CHECK(within > 10);
    CHECK(beyond > 20);
    CHECK(longer < 20);  // where only longer words are beyond
}

TEST_CASE("only formulas that give the lengths pass") {
    for (const char* formula : {"n+2", "(n^2+3*n+2)/(n+1)", "n", "2+n*1^n", "n+2+0^n", "2^n",
                                "-(-n-2)", "n+3", "2^n+2"}) {
        INFO(formula);
        const Json made =
            certificate(Json{{"for all", {{{"name", "n"}, {"of", "numbers"}}}},
                             {"holds", {{"numbers", {"length(P,n)", "=", formula}}}}},
                        "proved", Json{{"by", "recurrences"}, {"orders", {{"n", 1}}}});
        const std::string text = formula;
        const bool right = text == "n+2" || text == "2+n*1^n" || text == "-(-n-2)";
        CHECK((check(made)[0].outcome == Outcome::checked) == right);
    }
}
