#include <algorithm>
#include <cctype>
#include <utility>

#include "model/model.hpp"

#include "notation/detail/blank_byte.hpp"
#include "notation/detail/reading.hpp"

// A `.lsys` file from its text.
//
// The text is cut into clauses at line breaks and `;`, comments left out. A clause is a rule if it has an
// arrow, otherwise a setting by its keyword, or a system within the system, `system NAME { ... }`, which is
// cut out whole and read in the same way over the same symbols. Clauses are read stage by stage (`Stage`, and
// the table `settings` in settings.cpp), so that a file may be written in any order: all names before the
// words, all rules before what is set for their symbols.
//
// One faulty clause does not stop the others. What a reader throws becomes a finding at its place, and the
// reading goes on; a name whose own statement was faulty is remembered, so that its uses are not reported as
// well (`DependsOnError`), and probabilities are added up only where every rule could be read. `Findings`
// sorts by place, as stages are not in the order of the text.

namespace algae {

namespace {

std::size_t blanks(std::string_view text) {
    return static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), is_blank_byte) -
                                    text.begin());
}

std::size_t name_length(std::string_view text) {
    std::size_t length = 0;
    while (length < text.size()) {
        const Character next = first_character(text.substr(length));
        const bool fits =
            is_letter(next.code) || next.code == '_' || (length > 0 && is_digit(next.code));
        if (!fits) break;
        length += next.bytes;
    }
    return length;
}

}  // namespace

std::optional<SystemBlock> system_block(std::string_view text, std::size_t& bytes) {
    constexpr std::string_view keyword = "system";
    if (!text.starts_with(keyword)) return std::nullopt;
    std::size_t here = keyword.size();
    const std::size_t gap = blanks(text.substr(here));
    here += gap;
    const std::size_t length = name_length(text.substr(here));
    if (gap == 0 || length == 0) return std::nullopt;
    SystemBlock block{text.substr(here, length), {}, true};
    here += length;
    here += blanks(text.substr(here));
    if (here == text.size() || text[here] != '{') return std::nullopt;
    const std::size_t begin = ++here;
    for (std::size_t depth = 1; here < text.size(); ++here) {
        const char before = text[here - 1];
        if (text[here] == '#' && (before == '\n' || before == ';' || is_behind_blank(text, here)))
            here = std::min(text.find('\n', here), text.size() - 1);
        if (text[here] == '{') ++depth;
        if (text[here] != '}' || --depth > 0) continue;
        block.body = text.substr(begin, here - begin);
        bytes = here + 1;
        return block;
    }
    block.body = text.substr(begin);
    block.closed = false;
    bytes = text.size();
    return block;
}

namespace {

/// The letters that a text begins with, and the one keyword of two words. What is no ASCII sticks to them: `idé` is not `id`.
std::string_view keyword_of(std::string_view text) {
    constexpr std::string_view of_two = "common-scale";
    if (text.starts_with(of_two)) return text.substr(0, of_two.size());
    constexpr char32_t ascii = 0x80, arrow = 0x2192;
    std::size_t length = 0;
    while (length < text.size()) {
        const Character next = first_character(text.substr(length));
        if (!next.is_valid() || next.code == arrow ||
            (next.code < ascii ? !is_letter(next.code) : is_blank(next.code)))
            break;
        length += next.bytes;
    }
    return text.substr(0, length);
}

/// Whether `text` begins with `#rrggbb` and nothing sticks to it.
bool starts_with_colour(std::string_view text) {
    constexpr std::size_t length = 7;
    if (text.size() < length) return false;
    for (std::size_t i = 1; i < length; ++i)
        if (!std::isxdigit(static_cast<unsigned char>(text[i]))) return false;
    return text.size() == length || is_blank_byte(text[length]) || text[length] == ';';
}

const char* first_arrow(std::string_view text) {
    const std::size_t ascii = text.find("->");
    const std::size_t unicode = text.substr(0, ascii).find("→");
    const std::size_t arrow = unicode != std::string_view::npos ? unicode : ascii;
    return arrow == std::string_view::npos ? nullptr : text.data() + arrow;
}

}  // namespace

bool Clause::has_word(std::string_view word) const {
    return keyword == word && is_before_blank(text, word.size());
}

bool is_rule(const Clause& clause) {
    return clause.arrow && !clause.has_word("title") && !clause.has_word("source") &&
           !clause.has_word("interpret") && !clause.has_word("coding");
}

std::string_view Clause::value() const { return trimmed(text.substr(keyword.size())); }

namespace {

/// The bytes of `coding { ... }` at the start of a text; 0 if none stands there.
std::size_t coding_block(std::string_view text) {
    constexpr std::string_view keyword = "coding";
    if (!text.starts_with(keyword)) return 0;
    const std::size_t open = keyword.size() + blanks(text.substr(keyword.size()));
    if (open >= text.size() || text[open] != '{') return 0;
    return std::min(text.find('}', open), text.size() - 1) + 1;
}

/// Whether the text begins with a keyword and a blank.
bool begins_setting(std::string_view text) {
    const std::string_view keyword = keyword_of(text);
    return keyword.size() < text.size() &&
           (is_before_blank(text, keyword.size()) || text[keyword.size()] == '{') &&
           std::ranges::any_of(settings(),
                               [&](const Setting& setting) { return setting.name() == keyword; });
}

/// How brackets nest in a typed system, and which of its commas separate.
class TypedCommas {
public:
    explicit TypedCommas(std::string_view text) : text_(text) {}

    /// Goes past a character of a clause that begins at `begin`; whether a clause ends there: at a comma that separates, or at a blank
    /// before a letter with an arrow of its own.
    bool separates(std::size_t here, std::size_t begin) {
        count(text_[here], depth_);
        has_arrow_ = has_arrow_ || is_arrow(text_.substr(here));
        if (depth_ > 0) return false;
        if (is_blank_byte(text_[here]) && text_[here] != '\n')
            return has_arrow_ && is_next_rule(here + 1);
        if (text_[here] != ',') return false;
        return (has_arrow_ ||
                begins_setting(trimmed(text_.substr(begin, here - begin).substr(0, most)))) &&
               is_clause(here + 1);
    }
    void begin_clause() {
        depth_ = 0;
        has_arrow_ = false;
    }

private:
    static constexpr std::size_t most = 1000;  // bytes that are looked at to tell what begins

    static bool is_arrow(std::string_view text) {
        return text.starts_with("->") || text.starts_with("→");
    }
    static void count(char c, std::size_t& depth) {
        if (c == '(' || c == '{') ++depth;
        if ((c == ')' || c == '}') && depth > 0) --depth;
    }

    /// Whether a rule or a setting begins here. A context condition, `A ? B, C -> D`, has commas before the arrow.
    bool is_clause(std::size_t begin) {
        if (begins_setting(trimmed(text_.substr(begin, most)))) return true;
        std::size_t depth = 0;
        bool elsewhere = false;
        for (std::size_t here = begin; here < std::min(text_.size(), begin + most); ++here) {
            const char c = text_[here];
            count(c, depth);
            if (c == '\n' || c == ';' || (c == ',' && depth == 0 && !elsewhere)) return false;
            elsewhere = elsewhere || (c == '?' && here > begin && is_blank_byte(text_[here - 1]));
            if (is_arrow(text_.substr(here))) return true;
        }
        return false;
    }

    /// Whether one word and an arrow stand here, the second arrow of a clause: `0->01 1->10`.
    bool is_next_rule(std::size_t here) const {
        constexpr std::size_t longest = 200;
        std::size_t end = here;
        while (end < std::min(text_.size(), here + longest) && !is_blank_byte(text_[end]) &&
               std::string_view("<>:()?,;").find(text_[end]) == std::string_view::npos &&
               !is_arrow(text_.substr(end)))
            ++end;
        if (end == here) return false;
        while (end < text_.size() && is_blank_byte(text_[end]) && text_[end] != '\n') ++end;
        return end < text_.size() && is_arrow(text_.substr(end));
    }

    std::string_view text_;
    std::size_t depth_ = 0;
    bool has_arrow_ = false;  // in this clause so far
};

}  // namespace

std::vector<Clause> clauses(std::string_view text, bool typed) {
    TypedCommas commas(text);
    std::vector<Clause> found;
    const char* after_last = text.data();
    std::size_t begin = 0;
    const auto add = [&](std::size_t end) {
        Clause clause;
        clause.text = trimmed(text.substr(begin, end - begin));
        if (clause.text.empty()) return;
        clause.keyword = keyword_of(clause.text);
        clause.arrow = first_arrow(clause.text);
        clause.comments = after_last;
        after_last = clause.text.data() + clause.text.size();
        found.push_back(clause);
    };
    std::size_t here = 0;
    const auto add_block = [&] {  // a system within the system is one clause, and so is a coding
        std::size_t bytes = coding_block(text.substr(here));
        if (!trimmed(text.substr(begin, here - begin)).empty() ||
            (bytes == 0 &&
             (!text.substr(here).starts_with("system") || !system_block(text.substr(here), bytes))))
            return false;
        add(here + bytes);
        found.back().arrow = nullptr;
        begin = here += bytes;
        return true;
    };
    while (here < text.size()) {
        const char byte = text[here];
        if ((byte == 's' || byte == 'c') && (here == begin || is_blank_byte(text[here - 1])) &&
            add_block())
            continue;
        const bool is_end = typed && commas.separates(here, begin);
        if (byte == '\n' || byte == ';' || is_end) {
            add(here++);
            begin = here;
            commas.begin_clause();
        } else if (byte == '#' && (here == begin || is_behind_blank(text, here))) {
            if (starts_with_colour(text.substr(here)) &&
                keyword_of(trimmed(text.substr(begin, here - begin))) == "colour") {
                ++here;
                continue;
            }
            add(here);
            here = std::min(text.find('\n', here), text.size());
            begin = here;
        } else {
            ++here;
        }
    }
    add(text.size());
    return found;
}

std::vector<std::string_view> pieces(std::string_view text) {
    std::vector<std::string_view> found;
    const char* begin = nullptr;
    std::size_t depth = 0;
    const char* const end = text.data() + text.size();
    for (const char* here = text.data(); here != end;) {
        const Character next = first_character({here, static_cast<std::size_t>(end - here)});
        if (next.code == '(') ++depth;
        if (next.code == ')' && depth > 0) --depth;
        if (!is_blank(next.code)) {
            if (!begin) begin = here;
        } else if (begin && depth == 0) {
            found.emplace_back(begin, static_cast<std::size_t>(here - begin));
            begin = nullptr;
        }
        here += next.bytes;
    }
    if (begin) found.emplace_back(begin, static_cast<std::size_t>(end - begin));
    return found;
}

std::vector<std::string_view> comments(std::string_view text) {
    std::vector<std::string_view> found;
    for (std::size_t here = text.find('#'); here != std::string_view::npos;
         here = text.find('#', here)) {
        const std::size_t end = std::min(text.find('\n', here), text.size());
        found.push_back(trimmed(text.substr(here, end - here)));
        here = end;
    }
    return found;
}

void check_symbol_name(std::string_view name, std::size_t begin, std::string_view more) {
    constexpr std::size_t longest = 200;  // reading looks so far ahead for a declared name
    if (name.size() > longest)
        throw SyntaxError{name.data(), "expected names of at most " + std::to_string(longest) +
                                           " bytes, found one of " + std::to_string(name.size())};
    for (std::size_t i = begin; i < name.size();) {
        const Character next = first_character(name.substr(i));
        if (is_reserved(next.code) || more.find(name[i]) != std::string_view::npos)
            throw SyntaxError{name.data() + i,
                              "expected names without " + quoted(name.substr(i, next.bytes))};
        i += next.bytes;
    }
}

const Quantity* Reading::constant(const std::string& name) const {
    const auto found = constants.find(name);
    return found == constants.end() ? nullptr : &system.constants[found->second].second;
}

Quantity Reading::quantity(const Expression& expression) const {
    const auto value = [&](const std::string& name) {
        if (broken.count(name)) throw DependsOnError();
        return constant(name);
    };
    try {
        if (!functions.keeps_calls()) return evaluate(expression, value);
        const char* const where = source.text().data() + source.offset(expression.place);
        Quantity kept = evaluate(functions.expanded(expression, where), value);
        kept.expression = expression;
        return kept;
    } catch (const Diagnostics& error) {
        const Diagnostic& finding = error.findings().front();
        throw SyntaxError{source.text().data() + source.offset(finding.place), finding.message};
    }
}

void Reading::check_names(const Expression& expression, const std::vector<std::string>& parameters,
                          bool of_boxes) {
    if (is_distance(expression)) {
        if (of_boxes)
            distances.push_back(expression);
        else
            findings.add(expression.place,
                         "expected no distance but in the condition of a shape rule, found " +
                             algae::quoted(to_text(expression)));
        return;
    }
    if (expression.kind == Expression::Kind::word) {
        for (const auto& [position, arguments] : expression.word->arguments)
            for (const Expression& argument : arguments) check_fixed(argument);
        return;
    }
    for (const Expression& operand : expression.operands)
        check_names(operand, parameters, of_boxes);
    if (expression.kind != Expression::Kind::name) return;
    const std::string& name = expression.name;
    if (std::find(parameters.begin(), parameters.end(), name) != parameters.end()) return;
    if (constants.count(name) || broken.count(name)) return;
    std::vector<std::string> candidates = parameters;
    constexpr std::size_t most = 1000;  // to choose from more would take long and help little
    if (constants.size() < most)
        for (const auto& [known, index] : constants) candidates.push_back(known);
    std::sort(candidates.begin(), candidates.end());
    findings.add(expression.place,
                 (parameters.empty() ? "expected a number or a constant, found "
                                     : "expected a parameter or a constant, found ") +
                     algae::quoted(name) + did_you_mean(name, candidates));
}

void Reading::check_fixed(const Expression& expression) {
    if (expression.kind == Expression::Kind::word || !reads_words(expression))
        return check_names(expression, {});
    findings.add(expression.place, "expected a number or a word in quotes, found " +
                                       algae::quoted(to_text(expression)));
}

void Reading::check_distances() {
    for (const Expression& distance : distances) {
        const Expression& symbol = distance.operands.at(1);
        if (lexicon.known(symbol.name)) continue;
        std::vector<std::string> candidates;
        constexpr std::size_t most = 1000;
        for (Symbol known = 0; known < std::min(most, system.alphabet.size()); ++known)
            candidates.push_back(system.alphabet.name(known));
        findings.add(symbol.place, "expected a symbol of the system, found " +
                                       algae::quoted(symbol.name) +
                                       did_you_mean(symbol.name, candidates));
    }
}

std::string comment_hint(std::string_view text) {
    constexpr std::size_t longest = 40;
    for (const std::string_view sign : {"//", "/*", "%", "--"}) {
        if (!text.starts_with(sign)) continue;
        text.remove_prefix(sign.size());
        text = trimmed(text.substr(0, text.find_first_of("\r\n")));
        if (text.ends_with("*/")) text = trimmed(text.substr(0, text.size() - 2));
        return "; a comment begins with '#'" +
               (text.empty() || text.size() > longest
                    ? ""
                    : ", did you mean '# " + std::string(text) + "'?");
    }
    return {};
}

namespace {

/// The row of the table for a keyword; nullptr if there is none.
const Setting* setting_of(const Clause& clause) {
    const auto& all = settings();
    const auto found = std::find_if(all.begin(), all.end(), [&](const Setting& setting) {
        return setting.name() == clause.keyword &&
               (setting.stage != Stage::inner || clause.has_word(setting.name()));
    });
    return found == all.end() ? nullptr : &*found;
}

Stage stage(const Clause& clause) {
    if (is_rule(clause)) return Stage::rule;
    const Setting* const setting = setting_of(clause);
    return setting ? setting->stage : Stage::unknown;
}

/// How algae says what other notations write so; otherwise the hint.
std::string said_elsewhere(std::string_view text, const std::string& hint) {
    if (const std::string comment = comment_hint(text); !comment.empty()) return comment;
    if (!hint.empty()) return hint;
    for (const std::string_view arrow : {"-->", "=>", "::=", ":=", "\u2192", "="})
        if (text.find(arrow) != std::string_view::npos)
            return "; did you mean '->' instead of '" + std::string(arrow) + "'?";
    return {};
}

[[noreturn]] void refuse(const Clause& clause, const Reading& reading) {
    constexpr std::size_t most = 1000;  // after so many findings nobody needs suggestions
    const std::string_view text = clause.text;
    const std::string_view word =
        text.substr(0, std::min(text.find_first_of(" \t=:"), text.size()));
    std::vector<std::string> names;
    if (reading.findings.count() < most)
        for (const Setting& setting : settings()) names.push_back(setting.name());
    throw SyntaxError{text.data(), "expected a setting or a rule with '->', found " + quoted(word) +
                                       said_elsewhere(text, did_you_mean(clause.keyword, names))};
}

/// Throws unless the clause may stand in a system within another.
void check_inside(const Clause& clause, Stage at) {
    const Setting* const setting = setting_of(clause);
    if ((at == Stage::rule && clause.arrow) || (setting && setting->within)) return;
    throw SyntaxError{clause.text.data(),
                      "expected 'axiom', 'ignore' or a rule in a system within another, found " +
                          quoted(clause.text.substr(0, clause.text.find_first_of(" \t=:")))};
}

void read_clause(const Clause& clause, Stage at, Reading& reading) {
    if (reading.is_inner) check_inside(clause, at);
    if (at == Stage::unknown) refuse(clause, reading);
    if (at == Stage::rule && clause.arrow) return read_rule(clause, reading);
    const Setting& setting = *setting_of(clause);
    if (!setting.repeats) {
        const auto [first, is_new] = reading.given.emplace(setting.name(), clause.text.data());
        if (!is_new)
            throw SyntaxError{clause.text.data(),
                              quoted(clause.keyword) + " is given twice, first in line " +
                                  std::to_string(reading.source.place(first->second).line)};
    }
    if (clause.value().empty())
        throw unexpected(at == Stage::axiom ? "a word after 'axiom' (the empty word is ε)"
                                            : "a value after '" + std::string(clause.keyword) + "'",
                         clause.text.data() + clause.text.size());
    // Of a title it would be a comment where the canonical text has a blank.
    if (clause.value().front() == '#' && at != Stage::axiom && clause.keyword != "colour")
        throw SyntaxError{clause.value().data(), "expected a value after " +
                                                     quoted(clause.keyword) +
                                                     ", found '#'; a comment needs a blank before"};
    setting.read(clause, reading);
}

/// Makes the names of the systems within known, as words before them may say them.
void name_systems(const std::vector<Clause>& all, Reading& reading) {
    for (const Clause& clause : all) {
        std::size_t bytes = 0;
        const auto block = system_block(clause.text, bytes);
        if (!block || clause.arrow) continue;
        const auto& known = reading.lexicon.systems();
        if (std::find(known.begin(), known.end(), block->name) != known.end())
            reading.findings.add(block->name.data(),
                                 "the system " + quoted(block->name) + " is given twice");
        else if (function_arity(block->name))
            reading.findings.add(
                block->name.data(),
                "expected a name for the system, found the function " + quoted(block->name));
        else
            reading.lexicon.name_system(block->name);
    }
}

/// No word with a quotation mark can stand in quotation marks.
void check_quotes(Reading& reading) {
    if (!holds_words(reading.system)) return;
    for (Symbol a = 0; a < reading.system.alphabet.size(); ++a)
        if (reading.system.alphabet.name(a).find('"') != std::string::npos)
            reading.findings.add(
                reading.source.text().data(),
                "expected no symbol with '\"' in a system with words in quotes, found " +
                    algae::quoted(reading.system.alphabet.name(a)));
}

/// A rule that follows a setting in the same statement is a frequent slip.
bool follows_setting(const Clause& clause) {
    const Setting* const setting = setting_of(clause);
    return setting && setting->stage != Stage::inner && clause.has_word(clause.keyword);
}

void read_clauses(const std::vector<Clause>& all, Reading& reading) {
    std::vector<Stage> stages;
    for (const Clause& clause : all) stages.push_back(stage(clause));
    // Rules before the first table belong to none.
    const auto first_table = std::find_if(all.begin(), all.end(), [](const Clause& clause) {
        return clause.keyword == "table" && !clause.arrow;
    });
    for (int order = 0; order <= static_cast<int>(Stage::unknown); ++order) {
        const Stage at = static_cast<Stage>(order);
        for (auto clause = all.begin(); clause != all.end(); ++clause) {
            if (stages[static_cast<std::size_t>(clause - all.begin())] != at) continue;
            try {
                if (at == Stage::rule && first_table != all.end() && clause < first_table)
                    throw SyntaxError{clause->text.data(),
                                      "expected a table before the first rule, as there are tables "
                                      "further down"};
                read_clause(*clause, at, reading);
            } catch (const SyntaxError& error) {
                if (clause->arrow && at == Stage::rule && follows_setting(*clause)) {
                    reading.findings.add(clause->text.data(),
                                         "expected a line break or ';' between the setting " +
                                             quoted(clause->keyword) + " and the rule");
                    reading.given.emplace(clause->keyword, clause->text.data());
                } else {
                    reading.findings.add(error);
                }
                if (at == Stage::rule || at == Stage::interpretation) reading.broken_rules = true;
            } catch (const DependsOnError&) {
                reading.broken_rules = true;
            }
        }
    }
}

}  // namespace

void read_inner(const Clause& clause, Reading& outer) {
    std::size_t bytes = 0;
    const auto block = system_block(clause.text, bytes);
    if (!block) throw unexpected("a name and '{' after 'system'", clause.text.data() + 6);
    if (!block->closed) throw SyntaxError{block->body.data() - 1, "'{' is never closed"};
    constexpr std::size_t most = 100;
    if (outer.system.inner.size() == most)
        throw SyntaxError{clause.text.data(),
                          "more than " + std::to_string(most) + " systems within one"};
    InnerSystem inner;
    inner.name = inner.system.name = block->name;
    inner.place = outer.source.place(clause.text.data());
    inner.system.constants = outer.system.constants;
    Reading reading{outer.source,
                    outer.findings,
                    outer.lexicon,
                    inner.system,
                    outer.drawing,
                    outer.expectations,
                    outer.coding,
                    outer.functions,
                    outer.constants,
                    outer.broken,
                    {},
                    {},
                    false};
    reading.is_inner = true;
    reading.letters = outer.letters;
    reading.spaced = outer.spaced;
    read_clauses(clauses(block->body), reading);
    outer.slips.insert(outer.slips.end(), reading.slips.begin(), reading.slips.end());
    if (!reading.given.count("axiom"))
        outer.findings.add(block->body.data() + block->body.size(),
                           "expected an axiom in the system, found none");
    reading.check_distances();
    for (const Production& rule : inner.system.rules) {
        if (rule.probability)
            outer.findings.add(rule.place, "expected a rule without probability, as the system " +
                                               algae::quoted(inner.name) +
                                               " has one word in each generation");
        if (rule.shape)
            outer.findings.add(rule.place, "expected a rule that makes a word in the system " +
                                               algae::quoted(inner.name) + ", found a shape rule");
    }
    inner.system.constants.clear();
    outer.broken_rules = outer.broken_rules || reading.broken_rules;
    outer.system.inner.push_back(std::move(inner));
}

namespace {

/// What a typed system without an axiom begins with: the letter of its first rule. Adds a finding where that is no word.
void begin_with_first_rule(std::string_view text, Reading& reading) {
    const std::size_t offset = reading.system.rules.empty()
                                   ? reading.source.offset(text.data() + text.size())
                                   : reading.source.offset(reading.system.rules.front().place);
    const auto refuse = [&](const std::string& why) {
        reading.findings.add(offset, "expected an axiom, " + why);
    };
    if (reading.system.rules.empty()) {
        if (reading.findings.empty()) refuse("such as 'axiom a; a -> ab', found none");
        return;
    }
    const Production& first = reading.system.rules.front();
    const std::string letter = reading.system.alphabet.name(first.predecessor.symbol);
    if (!first.predecessor.parameters.empty())
        return refuse("as the first rule has parameters, such as 'axiom " + letter + "(1); ...'");
    if (!first.left.empty() || !first.right.empty() || !first.elsewhere.empty())
        return refuse("as the first rule has a context, such as 'axiom " + letter + letter +
                      "; ...'");
    if (letter == "[" || letter == "]")
        return refuse("as the first rule is of a bracket, such as 'axiom a; ...'");
    if (first.shape)
        return refuse("as the first rule is one of shapes, such as 'axiom " + letter +
                      "(1,1,1); ...'");
    reading.system.axiom.letters = {first.predecessor.symbol};
    reading.system.axiom_place = first.place;
}

/// Throws Error unless the system has all these constants.
void check_replaced(const Model& system, const ConstantValues& replaced) {
    std::vector<std::string> known;
    for (const auto& [name, value] : system.constants) known.push_back(name);
    for (const auto& [name, value] : replaced)
        if (std::ranges::count(known, name) == 0)
            throw Error((system.name.empty() ? "" : system.name + ": ") + "has no constant " +
                        quoted(name) + did_you_mean(name, known) +
                        (known.empty()
                             ? "; it has none: `let " + name + " = ...` in its text makes one"
                             : "; it has " + listed(known, " and ")));
}

}  // namespace

Model read_system(std::string_view text, const Source& source, Findings& findings,
                  const std::string& name, const std::vector<std::string>& declared,
                  const std::vector<std::string>& letters, const ConstantValues& replaced,
                  bool typed, OwnFunctions* functions) {
    Model system;
    system.name = name;
    Lexicon lexicon(system.alphabet);
    OwnFunctions own;
    if (!functions) functions = &own;
    lexicon.use(*functions);
    for (const std::string& symbol : declared) lexicon.declare(symbol);
    Reading reading{source,
                    findings,
                    lexicon,
                    system,
                    system.drawing,
                    system.expectations,
                    system.coding,
                    *functions,
                    {},
                    {},
                    {},
                    {},
                    false};
    reading.replaced = &replaced;
    for (const std::string& letter : letters) reading.declare(letter);
    const std::vector<Clause> all = clauses(text, typed);
    name_systems(all, reading);
    read_clauses(all, reading);
    if (typed && !reading.given.count("axiom"))
        begin_with_first_rule(text, reading);
    else if (!reading.given.count("axiom"))
        findings.add(text.data() + text.size(),
                     text.size() == source.text().size()
                         ? "expected an axiom before the end of the file, found none"
                         : "expected an axiom in the system, found none");
    reading.check_distances();
    check_probabilities(system.rules, reading);
    check_probabilities(system.interpretation, reading);
    check_quotes(reading);
    reading.check_slips();
    return system;
}

namespace {

Model read_text(std::string_view text, const std::string& name, const ConstantValues& replaced,
                bool typed) {
    Model system = read_whole(text, name, [&](const Source& source, Findings& findings) {
        Model read = read_system(text, source, findings, name, {}, {}, replaced, typed);
        findings.throw_if_any();
        return read;
    });
    check_replaced(system, replaced);
    return system;
}

}  // namespace

Model read_lsystem(std::string_view text, const std::string& file_name,
                   const ConstantValues& replaced) {
    return read_text(text, file_name, replaced, false);
}

Model read_typed_system(std::string_view text, const std::string& name,
                        const ConstantValues& replaced) {
    return read_text(text, name, replaced, true);
}

bool is_typed_system(std::string_view text) {
    const std::string_view begin = trimmed(text);
    return first_arrow(text) ||
           (begin.starts_with("axiom") && begin.size() > 5 && is_blank_byte(begin[5]));
}

ModuleWord read_word(std::string_view text, Alphabet& alphabet) {
    return read_whole(text, "word", [&](const Source& source, Findings&) {
        Lexicon lexicon(alphabet);
        refuse_slips(text, lexicon);
        return parse_word(text, lexicon, source);
    });
}

Expression read_expression(std::string_view text) {
    return read_whole(text, "expression", [&](const Source& source, Findings&) {
        return parse_expression(trimmed(text), source);
    });
}

}  // namespace algae
