#include "verify/certificate.hpp"

#include <algorithm>

#include "verify/reader.hpp"
#include "word/word_sets.hpp"

namespace algae::verify {

Language words_of(std::vector<Word> words) {
    std::sort(words.begin(), words.end(), shortlex_less);
    words.erase(std::unique(words.begin(), words.end()), words.end());
    Tree tree;
    tree.words = std::move(words);
    return std::make_shared<const Tree>(std::move(tree));
}

Language generated_by(std::shared_ptr<const System> system, std::string name) {
    Tree tree;
    tree.kind = Tree::Kind::generated;
    tree.system = std::move(system);
    tree.name = std::move(name);
    return std::make_shared<const Tree>(std::move(tree));
}

Language combination(Tree::Kind kind, std::vector<Language> parts) {
    Tree tree;
    tree.kind = kind;
    tree.parts = std::move(parts);
    return std::make_shared<const Tree>(std::move(tree));
}

bool same(const Language& left, const Language& right) {
    if (left->kind != right->kind || left->words != right->words ||
        left->letters != right->letters || left->morphism != right->morphism ||
        left->parts.size() != right->parts.size())
        return false;
    if (left->system && !(*left->system == *right->system)) return false;
    for (std::size_t i = 0; i < left->parts.size(); ++i)
        if (!same(left->parts[i], right->parts[i])) return false;
    return true;
}

bool is_regular(const Language& language) {
    return language->kind != Tree::Kind::generated &&
           std::all_of(language->parts.begin(), language->parts.end(), is_regular);
}

namespace {

std::shared_ptr<const Alphabet> read_alphabet(const Field& field) {
    auto alphabet = std::make_shared<Alphabet>();
    for (const Field& each : field.list()) {
        const std::string& name = each.text();
        if (name.empty() || name.find(' ') != std::string::npos)
            each.fail("the name of a letter has a character and no blank");
        if (alphabet->find(name)) each.fail("the letter '" + name + "' stands here twice");
        alphabet->symbol(name);
    }
    return alphabet;
}

Entry read_entry(const Field& field, const Reader& reader) {
    using Verdict = Entry::Verdict;
    const Field given = field.at("verdict");
    static const std::map<std::string, Verdict> verdicts = {{"proved", Verdict::proved},
                                                            {"refuted", Verdict::refuted},
                                                            {"undecided", Verdict::undecided},
                                                            {"cited", Verdict::cited}};
    const auto verdict = verdicts.find(given.text());
    if (verdict == verdicts.end())
        given.fail("expected proved, refuted, undecided or cited, found '" + given.text() + "'");
    Entry entry{field,
                field.at("text").text(),
                reader.statement(field.at("statement")),
                verdict->second,
                std::nullopt,
                ""};
    switch (entry.verdict) {
        case Verdict::proved:
        case Verdict::refuted:
            field.only({"text", "statement", "verdict", "proof"});
            entry.proof = field.at("proof");
            break;
        case Verdict::cited:
            field.only({"text", "statement", "verdict", "citation"});
            entry.citation = field.at("citation").text();
            if (entry.citation.empty()) field.at("citation").fail("the source is missing");
            break;
        case Verdict::undecided:
            field.only({"text", "statement", "verdict"});
            break;
    }
    return entry;
}

}  // namespace

std::unique_ptr<const Certificate> read_certificate(const std::string& text,
                                                    const std::string& file) {
    auto read = std::make_unique<Certificate>();
    read->file = file;
    read->root = parse_json(text, read->file);
    const Field root(read->root, "", read->file);
    root.only({"format", "claim", "source", "empty axiom", "alphabet", "systems", "statements"});
    if (root.at("format").text() != "algae certificate 1")
        root.at("format").fail("expected \"algae certificate 1\"");
    read->claim = root.at("claim").text();
    if (root.has("source")) read->source = root.at("source").text();
    if (root.has("empty axiom")) read->empty_axiom = root.at("empty axiom").truth();
    read->alphabet = read_alphabet(root.at("alphabet"));
    const Reader reader(*read->alphabet, read->systems, read->rewritings);
    for (const auto& [name, system] : root.at("systems").object())
        if (system.has("modules"))
            read->rewritings.emplace(name,
                                     std::make_shared<const ModuleSystem>(module_system(system)));
        else
            read->systems.emplace(name, std::make_shared<const System>(reader.system(system)));
    for (const Field& each : root.at("statements").list())
        read->entries.push_back(read_entry(each, reader));
    return read;
}

}  // namespace algae::verify
