#include <algorithm>
#include <set>
#include <type_traits>

#include "automatic/detail/statement.hpp"

// Reads first-order statements by recursive descent: the language is small, and errors say what could stand there.

namespace algae {

void LinearTerm::add(const LinearTerm& other, const Integer& times) {
    constant += other.constant * times;
    for (const auto& [name, of_one] : other.coefficients) {
        Integer& sum = coefficients[name];
        sum += of_one * times;
        if (sum.is_zero()) coefficients.erase(name);
    }
}

const std::string* LinearTerm::variable() const {
    const bool is_one =
        coefficients.size() == 1 && constant.is_zero() && coefficients.begin()->second == 1;
    return is_one ? &coefficients.begin()->first : nullptr;
}

std::pair<LinearTerm, LinearTerm> LinearTerm::sides() const {
    std::pair<LinearTerm, LinearTerm> found;
    auto& [left, right] = found;
    for (const auto& [name, times] : coefficients)
        (times > 0 ? left : right).coefficients[name] = times > 0 ? times : -times;
    (constant > 0 ? left : right).constant = constant > 0 ? constant : -constant;
    return found;
}

std::string written_name(const std::string& variable) {
    return variable.substr(0, variable.find('#'));
}

namespace {

using Node = std::shared_ptr<const FirstOrderNode>;
using Kind = FirstOrderNode::Kind;

Node node(Kind kind, std::vector<Node> parts) {
    return std::make_shared<FirstOrderNode>(FirstOrderNode{kind, {}, {}, {}, std::move(parts)});
}

Node atom(Kind kind, std::vector<LinearTerm> terms, std::string letter = {}) {
    return std::make_shared<FirstOrderNode>(
        FirstOrderNode{kind, std::move(terms), std::move(letter), {}, {}});
}

struct Token {
    enum class Kind { number, name, quoted, sign, end } kind;
    std::string text;
    std::size_t at;  // byte
};

class Reader {
public:
    Reader(std::string_view text, std::string name, std::string word,
           const std::vector<std::string>& letters)
        : text_(text), name_(std::move(name)), word_(std::move(word)), letters_(letters) {
        split();
    }

    Node whole() {
        Node found = statement();
        if (now().kind != Token::Kind::end) expected("'and', 'or', 'implies', 'iff' or the end");
        return found;
    }
    std::vector<std::string> free() const { return {free_.begin(), free_.end()}; }

private:
    [[noreturn]] void fail(std::size_t at, const std::string& message) const {
        Diagnostic found;
        std::size_t begin = 0, line = 1;
        for (std::size_t i = 0; i < at && i < text_.size(); ++i)
            if (text_[i] == '\n') {
                begin = i + 1;
                ++line;
            }
        const std::size_t end = std::min(text_.find('\n', begin), text_.size());
        std::size_t column = 0;  // in characters
        for (std::size_t i = begin; i < at && i < text_.size(); ++i)
            column += (static_cast<unsigned char>(text_[i]) & 0xC0) != 0x80;
        found.place = {name_, line, column + 1};
        found.message = message;
        found.line = std::string(text_.substr(begin, end - begin));
        found.caret = column;
        throw Diagnostics({found});
    }
    [[noreturn]] void expected(const std::string& what) const {
        fail(now().at, "expected " + what + ", found " +
                           (now().kind == Token::Kind::end ? "the end" : "'" + now().text + "'"));
    }

    void split() {
        static constexpr std::string_view pairs[] = {"<=", ">=", "!=", "=>", "==", "≤", "≥", "≠"};
        const auto is_letter = [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
        };
        const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
        for (std::size_t i = 0; i < text_.size();) {
            const char c = text_[i];
            if (c == ' ' || c == '\t' || c == '\n' || c == '\r') {
                ++i;
                continue;
            }
            std::size_t end = i + 1;
            Token::Kind kind = Token::Kind::sign;
            if (is_digit(c)) {
                while (end < text_.size() && is_digit(text_[end])) ++end;
                kind = Token::Kind::number;
            } else if (is_letter(c)) {
                while (end < text_.size() && (is_letter(text_[end]) || is_digit(text_[end]))) ++end;
                kind = Token::Kind::name;
            } else if (c == '\'') {
                end = text_.find('\'', i + 1);
                if (end == std::string_view::npos)
                    fail(i, "expected ' at the end of the letter, found the end");
                tokens_.push_back(
                    {Token::Kind::quoted, std::string(text_.substr(i + 1, end - i - 1)), i});
                i = end + 1;
                continue;
            } else {
                for (const std::string_view pair : pairs)
                    if (text_.substr(i).starts_with(pair)) end = i + pair.size();
                if (end == i + 1)
                    while (end < text_.size() &&
                           (static_cast<unsigned char>(text_[end]) & 0xC0) == 0x80)
                        ++end;
            }
            tokens_.push_back({kind, std::string(text_.substr(i, end - i)), i});
            i = end;
        }
        tokens_.push_back({Token::Kind::end, "", text_.size()});
    }

    const Token& now() const { return tokens_[at_]; }
    const Token& next() const { return tokens_[std::min(at_ + 1, tokens_.size() - 1)]; }
    bool is_sign(std::string_view sign) const {
        return now().kind == Token::Kind::sign && now().text == sign;
    }
    bool is_name(std::string_view name) const {
        return now().kind == Token::Kind::name && now().text == name;
    }
    bool take_sign(std::string_view sign) {
        if (!is_sign(sign)) return false;
        ++at_;
        return true;
    }
    bool take_name(std::string_view name) {
        if (!is_name(name)) return false;
        ++at_;
        return true;
    }
    void want(std::string_view sign, const std::string& where) {
        if (!take_sign(sign)) expected("'" + std::string(sign) + "' " + where);
    }

    // statement: implication { iff implication }
    Node statement() {
        return nested(
            [&] { return chain(Kind::equivalence, "iff", [&] { return implication(); }); });
    }
    Node implication() {
        Node left = disjunction();
        if (take_name("implies") || take_sign("=>"))
            return node(Kind::implication, {left, nested([&] { return implication(); })});
        return left;
    }
    Node disjunction() {
        return chain(Kind::disjunction, "or", [&] { return conjunction(); });
    }
    Node conjunction() {
        return chain(Kind::conjunction, "and", [&] { return single(); });
    }
    /// Parts with a word between them.
    template <class Read>
    Node chain(Kind kind, std::string_view between, Read read) {
        std::vector<Node> parts{read()};
        while (take_name(between)) parts.push_back(read());
        return parts.size() == 1 ? parts.front() : node(kind, std::move(parts));
    }
    /// What is read one deeper: what reads and decides statements goes down into itself.
    template <class Read>
    std::invoke_result_t<Read> nested(Read read) {
        struct Depth {
            std::size_t& depth;
            ~Depth() { --depth; }
        } const guard{++depth_};
        if (depth_ > most_depth)
            fail(now().at,
                 "the statement is nested more than " + std::to_string(most_depth) + " deep");
        return read();
    }
    Node single() {
        if (take_name("not")) return nested([&] { return node(Kind::negation, {single()}); });
        if (is_name("for") && (next().text == "all" || next().text == "some")) {
            ++at_;
            const bool all = now().text == "all";
            ++at_;
            return quantified(all);
        }
        if (is_name("there") && next().text == "is") {
            at_ += 2;
            return quantified(false);
        }
        if (is_name("equal") && next().text == "(") return predicate(Kind::equal, 3);
        if (is_name("palindrome") && next().text == "(") return predicate(Kind::palindrome, 2);
        if (is_sign("(")) {  // a statement, or the beginning of a term
            const std::size_t before = at_;
            ++at_;
            if (!is_term_in_parentheses(before)) {
                Node inner = statement();
                want(")", "behind the statement");
                return inner;
            }
            at_ = before;
        }
        return comparison();
    }
    /// Whether what follows the closing parenthesis goes on as a term.
    bool is_term_in_parentheses(std::size_t open) const {
        std::size_t depth = 0;
        for (std::size_t i = open; i < tokens_.size(); ++i) {
            const Token& token = tokens_[i];
            if (token.kind == Token::Kind::name &&
                (token.text == "and" || token.text == "or" || token.text == "not" ||
                 token.text == "implies" || token.text == "iff" || token.text == "for"))
                return false;
            if (token.kind != Token::Kind::sign) continue;
            if (token.text == "(") ++depth;
            if (token.text == ")" && --depth == 0) {
                const Token& behind = tokens_[std::min(i + 1, tokens_.size() - 1)];
                return behind.kind == Token::Kind::sign && behind.text != ")" &&
                       behind.text != ":" && behind.text != "]" && behind.text != ",";
            }
            if (is_relation(token.text) || token.text == ":") return false;
        }
        return false;
    }

    Node predicate(Kind kind, std::size_t count) {
        ++at_;
        want("(", "behind the predicate");
        std::vector<LinearTerm> terms;
        for (std::size_t i = 0; i < count; ++i) {
            if (i > 0) want(",", "between the terms");
            const std::size_t place = now().at;
            terms.push_back(term());
            refuse_differences(terms.back(), place);
        }
        want(")", "behind the terms");
        return atom(kind, std::move(terms));
    }

    Node quantified(bool all) {
        std::vector<std::string> names;
        std::vector<std::pair<std::string, std::string>> hidden;
        std::vector<Node> conditions;
        const std::size_t first = at_;
        do {
            if (now().kind != Token::Kind::name) expected("a variable");
            const std::string written = now().text;
            if (written == word_)
                fail(now().at, "expected a variable, '" + written + "' is the word");
            names.push_back(written + "#" + std::to_string(++bound_));
            scope_.emplace_back(written, names.back());
            ++at_;
        } while (take_sign(","));
        const std::size_t bound = names.size();
        if (now().kind == Token::Kind::sign && is_relation(now().text)) {  // for all k < n:
            if (bound != 1)
                fail(now().at, "expected 'with' before the condition of several variables");
            at_ = first;
            conditions.push_back(comparison());
        }
        if (take_name("with")) conditions.push_back(statement());
        want(":", "before what is said of " + written_name(names.front()));
        Node body = statement();
        scope_.resize(scope_.size() - bound);
        if (!conditions.empty()) {
            Node condition =
                conditions.size() == 1 ? conditions.front() : node(Kind::conjunction, conditions);
            body = node(all ? Kind::implication : Kind::conjunction, {condition, body});
        }
        return std::make_shared<FirstOrderNode>(FirstOrderNode{
            all ? Kind::for_all : Kind::exists, {}, {}, std::move(names), {std::move(body)}});
    }

    static bool is_relation(const std::string& sign) {
        return sign == "=" || sign == "==" || sign == "!=" || sign == "<" || sign == "<=" ||
               sign == ">" || sign == ">=" || sign == "≤" || sign == "≥" || sign == "≠";
    }

    /// A chain of terms, or of letters of the word.
    Node comparison() {
        std::vector<Node> parts;
        struct Side {
            bool is_letter;  // a letter of the word
            std::optional<LinearTerm> term;
            std::string name;  // of a letter
            std::size_t at;
        };
        const auto side = [&](bool name_allowed) -> Side {
            const std::size_t place = now().at;
            if (now().kind == Token::Kind::name && now().text == word_ && next().text == "[") {
                at_ += 2;
                LinearTerm index = term();
                refuse_differences(index, place);
                want("]", "behind the position");
                return {true, index, {}, place};
            }
            if (now().kind == Token::Kind::quoted || name_allowed) {
                std::string letter = now().text;
                if (now().kind == Token::Kind::sign && letter == "-") {  // a letter such as -1
                    ++at_;
                    letter += now().text;
                }
                if (now().kind == Token::Kind::end || now().kind == Token::Kind::sign)
                    expected("a letter or " + word_ + "[...]");
                ++at_;
                if (std::ranges::count(letters_, letter) == 0)
                    fail(place,
                         "expected a letter of the word" + list() + ", found '" + letter + "'");
                return {true, std::nullopt, letter, place};
            }
            return {false, term(), {}, place};
        };
        Side left = side(false);
        if (left.is_letter && !left.term && !is_relation(now().text)) expected("'=' or '!='");
        if (!(now().kind == Token::Kind::sign && is_relation(now().text)))
            expected("a comparison: = != < <= > >=");
        while (now().kind == Token::Kind::sign && is_relation(now().text)) {
            const Token sign = now();
            ++at_;
            Side right = side(left.is_letter);
            if (left.is_letter != right.is_letter)
                fail(right.at,
                     "expected a number to compare with a number, found a letter of the word");
            if (left.is_letter) {
                const bool same = sign.text == "=" || sign.text == "==";
                if (!same && sign.text != "!=" && sign.text != "≠")
                    fail(sign.at,
                         "expected '=' or '!=' between letters, found '" + sign.text + "'");
                if (!left.term && !right.term)
                    fail(right.at,
                         "expected " + word_ + "[...] on one side, found letters on both");
                Node one = left.term && right.term
                               ? atom(Kind::same_letter, {*left.term, *right.term})
                               : atom(Kind::letter, {left.term ? *left.term : *right.term},
                                      left.term ? right.name : left.name);
                parts.push_back(same ? one : node(Kind::negation, {one}));
            } else {
                parts.push_back(compared(*left.term, sign.text, *right.term));
            }
            left = right;
        }
        return parts.size() == 1 ? parts.front() : node(Kind::conjunction, std::move(parts));
    }

    static Node compared(const LinearTerm& left, const std::string& sign, const LinearTerm& right) {
        LinearTerm difference = left;
        difference.add(right, -1);
        LinearTerm opposite = right;
        opposite.add(left, -1);
        if (sign == "=" || sign == "==") return atom(Kind::equation, {difference});
        if (sign == "!=" || sign == "≠")
            return node(Kind::negation, {atom(Kind::equation, {difference})});
        if (sign == "<") return atom(Kind::less, {difference});
        if (sign == ">") return atom(Kind::less, {opposite});
        if (sign == "<=" || sign == "≤")
            return node(Kind::negation, {atom(Kind::less, {opposite})});
        return node(Kind::negation, {atom(Kind::less, {difference})});
    }

    std::string list() const {
        if (letters_.size() > 12) return "";
        std::string all;
        for (const std::string& letter : std::set<std::string>(letters_.begin(), letters_.end()))
            all += (all.empty() ? ", " : " or ") + letter;
        return all;
    }

    void refuse_differences(const LinearTerm& of, std::size_t place) const {
        bool negative = of.constant < 0;
        for (const auto& [name, times] : of.coefficients) negative = negative || times < 0;
        if (negative)
            fail(place,
                 "expected a position without differences, which may be below 0; say it by another "
                 "variable: for some j with j + n = i: ... " +
                     word_ + "[j]");
    }

    // term: product { (+|-) product }
    LinearTerm term() {
        LinearTerm sum;
        Integer sign = 1;
        if (take_sign("-")) sign = -1;
        sum.add(product(), sign);
        while (is_sign("+") || is_sign("-")) {
            sign = take_sign("+") ? Integer(1) : (++at_, Integer(-1));
            sum.add(product(), sign);
        }
        return sum;
    }
    LinearTerm product() {
        LinearTerm found = factor();
        while (is_sign("*") ||
               ((is_sign("(") || now().kind == Token::Kind::name) && is_multiplied(found))) {
            take_sign("*");
            const std::size_t place = now().at;
            const LinearTerm other = factor();
            if (!found.coefficients.empty() && !other.coefficients.empty())
                fail(place,
                     "expected a number: products of variables are not linear, and truth is not "
                     "decidable with them");
            LinearTerm result;
            if (found.coefficients.empty())
                result.add(other, found.constant);
            else
                result.add(found, other.constant);
            found = result;
        }
        return found;
    }
    /// Whether a number stands right before a name or a parenthesis: 2n.
    bool is_multiplied(const LinearTerm& left) const {
        const Token& before = tokens_[at_ - 1];
        return left.coefficients.empty() && before.kind == Token::Kind::number &&
               before.at + before.text.size() == now().at;
    }
    LinearTerm factor() {
        LinearTerm found;
        const Token token = now();
        if (token.kind == Token::Kind::number) {
            if (token.text.size() > 1'000)
                fail(token.at, "expected a number of at most 1000 digits");
            ++at_;
            found.constant = Integer(token.text);
            return found;
        }
        if (take_sign("(")) {
            found = nested([&] { return term(); });
            want(")", "behind the term");
            return found;
        }
        if (token.kind != Token::Kind::name) expected("a number, a variable or " + word_ + "[...]");
        if (token.text == word_) {
            ++at_;
            if (is_sign("["))
                fail(token.at,
                     "expected a number, found a letter of the word; letters are compared with = "
                     "and != alone");
            expected("'[' and a position behind the word " + word_);
        }
        if (next().text == "[")
            fail(token.at, "expected the word " + word_ + ", found '" + token.text + "'");
        if (next().text == "(")
            fail(token.at,
                 "expected equal(i, j, n) or palindrome(i, n), found '" + token.text + "('");
        ++at_;
        found.coefficients[variable(token.text)] = 1;
        return found;
    }
    std::string variable(const std::string& written) {
        for (auto at = scope_.rbegin(); at != scope_.rend(); ++at)
            if (at->first == written) return at->second;
        free_.insert(written);
        return written;
    }

    static constexpr std::size_t most_depth = 200;
    std::string_view text_;
    std::string name_, word_;
    const std::vector<std::string>& letters_;
    std::vector<Token> tokens_;
    std::size_t at_ = 0, depth_ = 0, bound_ = 0;
    std::vector<std::pair<std::string, std::string>> scope_;
    std::set<std::string> free_;
};

}  // namespace

FirstOrderStatement read_first_order(std::string_view text, const std::string& name,
                                     const std::string& word,
                                     const std::vector<std::string>& letters) {
    Reader reader(text, name, word, letters);
    FirstOrderStatement found(reader.whole());
    found.free_ = reader.free();
    return found;
}

}  // namespace algae
