#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "notation/notation.hpp"

// What editors need to colour `.lsys` and `.claim` files, all of it made from the tables of statements, so that an editor knows the keywords and
// names that the readers know.
//
// Three kinds of editors want three kinds of grammars. Those that know TextMate's (Visual Studio Code, Sublime Text, GitHub) have patterns that
// are tried in order at each place of a line; the first that matches names a scope, and a theme chooses its colour. Vim has patterns too, in a
// language of its own. Lezer, the parser of CodeMirror, has a grammar: it gives a tree of each text, with statements, rules, systems within and
// brackets, and it gives one while the text is being typed. The grammar knows where statements begin and end, as the readers do, and leaves to
// these what stands in them. A clause with an arrow is a rule whatever it begins with, and a constant may be called as a keyword is, so
// keywords may stand wherever words do, and what a statement is may be known at its arrow only. No ambiguity is left for the parser, which would
// give up one of two readings of a long statement.

namespace algae {

namespace {

using Json = nlohmann::ordered_json;

// Where a statement may begin, with the blanks before it, and where it ends.
constexpr const char* begins = R"((?:^|(?<=[;{]))\s*)";
constexpr const char* ends = "(?=;|$)";

std::string any_of(const std::vector<std::string>& words) {
    std::string out;
    for (const std::string& word : words) out += (out.empty() ? "(" : "|") + word;
    return out + ')';
}

Json scope(const char* name) { return {{"name", std::string(name) + ".lsys"}}; }

Json pattern(const char* name, const std::string& match) {
    Json out = scope(name);
    out["match"] = match;
    return out;
}

Json included(const char* name) { return {{"include", std::string("#") + name}}; }

/// A statement with its keyword, in which these patterns hold.
Json statement(const std::vector<std::string>& keywords, Json patterns) {
    return {{"begin", begins + any_of(keywords) + R"((?=\s))"},
            {"beginCaptures", {{"1", scope("keyword.other")}}},
            {"end", ends},
            {"patterns", std::move(patterns)}};
}

}  // namespace

namespace {

/// Keywords of texts for people: the rest of the line is theirs.
const std::vector<std::string> system_texts{"title", "source"},
    claim_texts{"claim", "source", "note"};

bool is_one_of(const std::vector<std::string>& words, const std::string& word) {
    return std::ranges::find(words, word) != words.end();
}

/// First words of the statements of claims.
std::vector<std::string> claim_keywords() {
    std::vector<std::string> words;
    for (const StatementHelp& help : claim_statements()) {
        const std::string first = help.keyword.substr(0, help.keyword.find(' '));
        if (!is_one_of(words, first)) words.push_back(first);
    }
    return words;
}

/// Words that have a meaning in statements of claims.
const std::vector<std::string>& claim_words() {
    static const std::vector<std::string> all{
        "for",    "all",     "some",      "every",    "there",    "is",    "not",     "and",
        "or",     "implies", "iff",       "with",     "in",       "steps", "by",      "up",
        "to",     "over",    "languages", "language", "systems",  "words", "word",    "numbers",
        "number", "letters", "morphisms", "finite",   "infinite", "empty", "regular", "under"};
    return all;
}

std::string textmate_of_systems() {
    const std::string word_ends = R"((?=\s|;|$))";
    Json statements = Json::array();
    std::vector<std::string> plain;
    for (const StatementHelp& help : system_statements()) {
        if (is_one_of(system_texts, help.keyword)) continue;
        if (help.words.empty()) {
            plain.push_back(help.keyword);
            continue;
        }
        const std::string names = R"((?<=\s))" + any_of(help.words) + word_ends;
        Json patterns = Json::array({pattern("support.constant", names)});
        if (help.keyword == "colour")
            patterns.push_back(pattern("constant.other", "#(?:[0-9A-Fa-f]{3}){1,2}" + word_ends));
        for (const char* name : {"comment", "number"}) patterns.push_back(included(name));
        statements.push_back(statement({help.keyword}, std::move(patterns)));
    }
    statements.push_back(statement(
        system_texts, Json::array({included("comment"), pattern("string.unquoted", "[^;]")})));
    Json keyword{{"match", begins + any_of(plain) + R"((?=\s))"},
                 {"captures", {{"1", scope("keyword.other")}}}};
    Json all = Json::array({included("comment")});
    for (Json& one : statements) all.push_back(std::move(one));
    all.push_back(std::move(keyword));
    all.push_back(pattern("keyword.operator", R"(->|→|-\([^)]*\)->)"));
    all.push_back(pattern("string.quoted", R"("[^"]*")"));
    all.push_back(pattern("variable.other", R"(\?\p{L}+)"));
    all.push_back(included("number"));
    const Json grammar{
        {"name", "L-system"},
        {"scopeName", "source.lsys"},
        {"fileTypes", {"lsys"}},
        {"patterns", std::move(all)},
        {"repository",
         {{"comment", pattern("comment.line", R"((?:^|(?<=\s))#.*$)")},
          {"number", pattern("constant.numeric", R"((?<![\w.])\d+(?:\.\d+)?(?:[eE][+-]?\d+)?)")}}}};
    return grammar.dump(4) + '\n';
}

std::string textmate_of_claims() {
    const auto named = [](const char* name, const std::string& match) {
        return Json{{"name", std::string(name) + ".claim"}, {"match", match}};
    };
    const auto captured = [](const char* name) {
        return Json{{"1", {{"name", std::string(name) + ".claim"}}}};
    };
    std::vector<std::string> keywords;
    for (const std::string& word : claim_keywords())
        if (!is_one_of(claim_texts, word)) keywords.push_back(word);
    const Json comment = named("comment.line", R"((?:^|(?<=\s))#.*$)");
    Json all = Json::array({comment});
    all.push_back({{"begin", begins + any_of(claim_texts) + R"((?=\s))"},
                   {"beginCaptures", captured("keyword.other")},
                   {"end", ends},
                   {"patterns", Json::array({comment, named("string.unquoted", "[^;]")})}});
    all.push_back({{"match", begins + any_of(keywords) + R"((?=\s))"},
                   {"captures", captured("keyword.other")}});
    all.push_back(named("keyword.control", R"(\b)" + any_of(claim_words()) + R"(\b)"));
    all.push_back(named("storage.type", R"(\b[EPDTSI]*[0-2(][0-9,)]*L\b)"));
    all.push_back(named("keyword.operator", R"(->|→|==>|==|!=|<=|>=|[=|&\\~*+^])"));
    all.push_back(named("string.quoted", R"("[^"]*")"));
    all.push_back(named("constant.numeric", R"((?<![\w.])\d+(?:\.\d+)?)"));
    const Json grammar{{"name", "Claim on L-systems"},
                       {"scopeName", "source.claim"},
                       {"fileTypes", {"claim"}},
                       {"patterns", std::move(all)}};
    return grammar.dump(4) + '\n';
}

std::string visual_studio_package() {
    const auto language = [](const char* id, const char* name, const char* ending) {
        return Json{{"id", id},
                    {"aliases", Json::array({name})},
                    {"extensions", Json::array({ending})},
                    {"configuration", "./language-configuration.json"}};
    };
    const auto grammar = [](const char* id, const char* path) {
        return Json{{"language", id}, {"scopeName", std::string("source.") + id}, {"path", path}};
    };
    const Json package{
        {"name", "algae"},
        {"displayName", "L-systems of algae"},
        {"description", "Colours of .lsys and .claim files"},
        {"version", "0.1.0"},
        {"publisher", "algae"},
        {"license", "MIT"},
        {"engines", {{"vscode", "^1.60.0"}}},
        {"categories", Json::array({"Programming Languages"})},
        {"contributes",
         {{"languages", Json::array({language("lsys", "L-system", ".lsys"),
                                     language("claim", "Claim on L-systems", ".claim")})},
          {"grammars", Json::array({grammar("lsys", "./lsys.tmLanguage.json"),
                                    grammar("claim", "./claim.tmLanguage.json")})}}}};
    return package.dump(4) + '\n';
}

std::string visual_studio_language() {
    const Json language{{"comments", {{"lineComment", "#"}}},
                        {"brackets", Json::array({Json::array({"{", "}"}), Json::array({"[", "]"}),
                                                  Json::array({"(", ")"})})}};
    return language.dump(4) + '\n';
}

// Vim

std::string vim_any_of(const std::vector<std::string>& words) {
    std::string out;
    for (const std::string& word : words) out += (out.empty() ? "" : "\\|") + word;
    return "\\%(" + out + "\\)";
}

// Behind the beginning of a statement.
constexpr const char* vim_begins = R"(\%(\%(^\|[;{]\)\s*\)\@<=)";

std::string vim_head(const std::string& what, const std::string& prefix,
                     const std::vector<std::string>& keywords) {
    return "\" Colours of " + what +
           ", made by `algae lsp --editors` from its table of statements.\n"
           "if exists('b:current_syntax')\n  finish\nendif\nsyntax case match\n"
           "syntax match " +
           prefix + R"(Number /\%(\w\|\.\)\@<!\d\+\%(\.\d\+\)\?/)" + "\nsyntax match " + prefix +
           "Keyword /" + vim_begins + vim_any_of(keywords) + R"(\ze\%(\s\|{\)/)" + "\n";
}

/// A statement up to its end, in which these items hold.
std::string vim_statement(const std::string& item, const std::vector<std::string>& keywords,
                          const std::string& items) {
    return "syntax match " + item + " /" + vim_begins + vim_any_of(keywords) +
           R"(\s[^;]*/ contains=)" + items + "\n";
}

std::string vim_tail(const std::string& prefix, const std::string& language,
                     const std::vector<std::pair<std::string, std::string>>& links) {
    std::string out;
    for (const auto& [item, group] : links)
        out += "highlight default link " + prefix + item + ' ' + group + '\n';
    return out + "let b:current_syntax = '" + language + "'\n";
}

std::string vim_comment(const std::string& prefix) {
    return "syntax match " + prefix + R"(Comment /\%(^\|\s\)\@<=#.*$/)" + "\n";
}

std::string vim_of_systems() {
    std::vector<std::string> keywords;
    for (const StatementHelp& help : system_statements()) keywords.push_back(help.keyword);
    std::string out = vim_head("L-systems, *.lsys", "lsys", keywords);
    out += R"(syntax match lsysArrow /->\|→\|-([^()[:blank:]]*)->/)";
    out += '\n';
    for (const StatementHelp& help : system_statements()) {
        if (is_one_of(system_texts, help.keyword) || help.words.empty()) continue;
        std::string name = help.keyword;
        name[0] = static_cast<char>(name[0] - 'a' + 'A');
        std::vector<std::string> words;
        for (const std::string& word : help.words)
            if (word.find_first_of("/~.*[]^$\\") == std::string::npos) words.push_back(word);
        out += "syntax match lsysName" + name + R"( /\s\@<=)" + vim_any_of(words) +
               R"(\ze\%(\s\|;\|$\)/ contained)" + "\n";
        out += vim_statement("lsys" + name, {help.keyword},
                             "lsysKeyword,lsysName" + name + ",lsysNumber,lsysArrow,lsysComment" +
                                 (help.keyword == "colour" ? ",lsysHex" : ""));
        out += "highlight default link lsysName" + name + " Constant\n";
    }
    out += vim_statement("lsysProse", system_texts, "lsysKeyword,lsysComment");
    out += vim_comment("lsys");
    out += R"(syntax match lsysHex /\s\@<=#\x\{6}\ze\%(\s\|;\|$\)/ contained)";
    return out + '\n' +
           vim_tail("lsys", "lsys",
                    {{"Keyword", "Keyword"},
                     {"Prose", "String"},
                     {"Arrow", "Operator"},
                     {"Number", "Number"},
                     {"Hex", "Constant"},
                     {"Comment", "Comment"}});
}

std::string vim_of_claims() {
    std::string out = vim_head("claims on L-systems, *.claim", "claim", claim_keywords());
    out += "syntax match claimWord /\\<" + vim_any_of(claim_words()) + "\\>/\n";
    out += R"(syntax match claimOperator /->\|→\|==>\|==\|!=\|<=\|>=\|[=|&~*+^\\]/)";
    // A keyword wins over the words of statements.
    out += "\nsyntax match claimKeyword /" + std::string(vim_begins) +
           vim_any_of(claim_keywords()) + R"(\ze\s/)" + "\n";
    out += vim_statement("claimProse", claim_texts, "claimKeyword,claimComment");
    return out + vim_comment("claim") +
           vim_tail("claim", "claim",
                    {{"Keyword", "Keyword"},
                     {"Prose", "String"},
                     {"Word", "Statement"},
                     {"Operator", "Operator"},
                     {"Number", "Number"},
                     {"Comment", "Comment"}});
}

// Lezer

std::string lezer_any_of(const std::vector<std::string>& words) {
    std::string out;
    for (const std::string& word : words) out += (out.empty() ? "\"" : " | \"") + word + '"';
    return out;
}

/// The tokens of both kinds of files; blanks are those that the readers know. A `#` behind a blank opens a comment, within a word it does not.
const char* const lezer_tokens = R"(@tokens {
  blank { $[ \t\u{b}\u{c}\r\u{85}\u{a0}\u{1680}\u{2000}-\u{200b}\u{2028}\u{2029}\u{202f}\u{205f}\u{3000}\u{feff}]+ }
  newline { "\n" }
  Comment { "#" ![\n]* }
  prosePiece {
    ![# \t\n\u{b}\u{c}\r\u{85}\u{a0}\u{1680}\u{2000}-\u{200b}\u{2028}\u{2029}\u{202f}\u{205f}\u{3000}\u{feff};]
    ![ \t\n\u{b}\u{c}\r\u{85}\u{a0}\u{1680}\u{2000}-\u{200b}\u{2028}\u{2029}\u{202f}\u{205f}\u{3000}\u{feff};]*
  }
  Word {
    $[A-Za-z_0-9\u{80}-\u{84}\u{86}-\u{9f}\u{a1}-\u{167f}\u{1681}-\u{1fff}\u{200c}-\u{2027}\u{202a}-\u{202e}\u{2030}-\u{205e}\u{2060}-\u{2191}\u{2193}-\u{2fff}\u{3001}-\u{fefe}\u{ff00}-\u{10ffff}]+ glued?
  }
  Number { ($[0-9]+ ("." $[0-9]*)? | "." $[0-9]+) ($[eE] $[+\-]? $[0-9]+)? glued? }
  Arrow { "->" | "\u{2192}" }
  Chance { "-(" ![ \t\n()]+ ")->" }
  Symbol { $[!"$%&'()*+,\-./:<=>?@\u{5b}\u{5c}\u{5d}^`|~] glued? }
  glued { "#" ![ \t\n\u{b}\u{c}\r;]* }
  @precedence { Chance, Arrow, Number, Symbol }
  @precedence { Number, Word }
)";

std::string lezer_of_systems() {
    std::vector<std::string> keywords;
    for (const StatementHelp& help : system_statements())
        if (!is_one_of(system_texts, help.keyword) && help.keyword != "interpret" &&
            help.keyword != "coding" && help.keyword != "system" && help.keyword != "colour")
            keywords.push_back(help.keyword.substr(0, help.keyword.find('-')));  // the word of two
    return R"(// L-systems, *.lsys, for Lezer; made by `algae lsp --editors` from its table of statements.
@precedence { here }
@top System { statement? ColourComment? (separator statement? ColourComment?)* }
separator { newline | ";" }
statement { Prose | Setting | Interpretation | Coding | Within | Rule }
Prose { TextKeyword prosePiece* }
Setting { Keyword piece* | ColourKeyword (item | !here Colour | brace)* }
ColourComment[@name=Comment] { Colour (item | brace | arrow | Colour | !here ";")* }
Rule { (Keyword | symbol | brace) piece* arrow piece* }
Interpretation { InterpretKeyword piece* arrow piece* }
Coding { CodingKeyword "{" image? (separator image?)* "}" }
image { Image { item+ arrow item* } }
Within { SystemKeyword item "{" inner? (separator inner?)* "}" }
inner { InnerSetting | InnerRule }
InnerSetting { Keyword innerPiece* }
InnerRule { (Keyword | symbol | Braces) innerPiece* arrow innerPiece* }
innerPiece { item | Braces }
Braces { "{" innerPiece* "}" }
piece { item | brace }
brace { "{" | "}" | GluedBrace }
arrow { Arrow | Chance }
symbol { Word | Number | Symbol }
item { symbol | Keyword | TextKeyword | ColourKeyword | InterpretKeyword | CodingKeyword | SystemKeyword }
TextKeyword { @specialize<Word, )" +
           lezer_any_of(system_texts) + "> }\nKeyword { @specialize<Word, " +
           lezer_any_of(keywords) + R"(> }
ColourKeyword { @specialize<Word, "colour"> }
InterpretKeyword { @specialize<Word, "interpret"> }
CodingKeyword { @specialize<Word, "coding"> }
SystemKeyword { @specialize<Word, "system"> }
)" + "@skip { blank | Comment | NoColour }\n" +
           lezer_tokens +
           R"(  Colour { "#" $[0-9A-Fa-f] $[0-9A-Fa-f] $[0-9A-Fa-f] $[0-9A-Fa-f] $[0-9A-Fa-f] $[0-9A-Fa-f] }
  NoColour { "#" $[0-9A-Fa-f] $[0-9A-Fa-f] $[0-9A-Fa-f] $[0-9A-Fa-f] $[0-9A-Fa-f] $[0-9A-Fa-f] ![ \t\n\u{b}\u{c}\r;] ![\n]* }
  GluedBrace { $[{}] "#" ![ \t\n\u{b}\u{c}\r;]* }
  @precedence { NoColour, Colour, Comment }
  @precedence { GluedBrace, "{", "}" }
  "{" "}" ";"
}
)";
}

std::string lezer_of_claims() {
    std::vector<std::string> keywords;
    for (const std::string& word : claim_keywords())
        if (!is_one_of(claim_texts, word)) keywords.push_back(word);
    return R"(// Claims on L-systems, *.claim, for Lezer; made by `algae lsp --editors` from its table of statements.
@top Claim { clause? (separator clause?)* }
separator { newline | ";" }
clause { Prose | Statement }
Prose { TextKeyword prosePiece* }
Statement { Keyword (item | Braces | "}")* }
Braces { "{" (item | Braces | newline | ";")* "}" }
item { Word | Number | Symbol | Arrow | Chance | Keyword | TextKeyword }
TextKeyword { @specialize<Word, )" +
           lezer_any_of(claim_texts) + "> }\nKeyword { @specialize<Word, " +
           lezer_any_of(keywords) + "> }\n@skip { blank | Comment }\n" + lezer_tokens +
           "  \"{\" \"}\" \";\"\n}\n";
}

}  // namespace

std::vector<EditorFile> editor_files() {
    return {{"lezer/claim.grammar", lezer_of_claims()},
            {"lezer/lsys.grammar", lezer_of_systems()},
            {"vim/ftdetect/algae.vim",
             "autocmd BufRead,BufNewFile *.lsys setfiletype lsys\n"
             "autocmd BufRead,BufNewFile *.claim setfiletype claim\n"},
            {"vim/syntax/claim.vim", vim_of_claims()},
            {"vim/syntax/lsys.vim", vim_of_systems()},
            {"vscode/claim.tmLanguage.json", textmate_of_claims()},
            {"vscode/language-configuration.json", visual_studio_language()},
            {"vscode/lsys.tmLanguage.json", textmate_of_systems()},
            {"vscode/package.json", visual_studio_package()}};
}

}  // namespace algae
