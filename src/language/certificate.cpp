#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>

#include "dimension/dimension.hpp"
#include "language/detail/finite_family.hpp"
#include "language/detail/judge.hpp"
#include "language/detail/proof.hpp"
#include "model/model.hpp"
#include "rewrite/rewrite.hpp"
#include "verify/verify.hpp"

// Claims as certificates: systems, languages, statements and proofs, each form as CERTIFICATES.md describes it.

namespace algae {

using Json = nlohmann::ordered_json;

namespace {

/// What the names in the expressions of a rule stand for.
struct Scope {
    const LSystem& system;
    std::vector<std::string> parameters;

    std::optional<std::size_t> parameter(const std::string& name) const {
        const auto found = std::find(parameters.begin(), parameters.end(), name);
        if (found == parameters.end()) return std::nullopt;
        return static_cast<std::size_t>(found - parameters.begin());
    }
    const Quantity* constant(const std::string& name) const {
        for (const auto& [known, value] : system.constants)
            if (known == name) return &value;
        return nullptr;
    }
};

Json expression_json(const Expression& expression, const Scope& scope) {
    const auto parameter = [&](const std::string& name) { return scope.parameter(name); };
    if (!has_parameters(expression, parameter)) {
        const auto constant = [&](const std::string& name) { return scope.constant(name); };
        if (const auto value = exact_value(expression, constant)) return shortest_text(*value);
        if (expression.kind == Expression::Kind::name)  // a constant that is not rational
            return expression_json(scope.constant(expression.name)->expression, scope);
    }
    if (expression.kind == Expression::Kind::name) return {{"parameter", expression.name}};
    Json parts = Json::array();
    for (const Expression& operand : expression.operands)
        parts.push_back(expression_json(operand, scope));
    return {{"apply", expression.name}, {"to", std::move(parts)}};
}

Json word_json(const ModuleWord& word, const Scope& scope) {
    Json modules = Json::array();
    for (std::size_t i = 0; i < word.letters.size(); ++i) {
        Json module = Json::array({scope.system.alphabet.name(word.letters[i])});
        if (const auto found = word.arguments.find(i); found != word.arguments.end())
            for (const Expression& argument : found->second)
                module.push_back(expression_json(argument, scope));
        modules.push_back(std::move(module));
    }
    return modules;
}

Json pattern_json(const Pattern& pattern, Scope& scope) {
    Json modules = Json::array();
    for (const ModulePattern& module : pattern) {
        Json written = Json::array({scope.system.alphabet.name(module.symbol)});
        for (const std::string& name : module.parameters) {
            scope.parameters.push_back(name);
            written.push_back(name);
        }
        modules.push_back(std::move(written));
    }
    return modules;
}

Json rule_json(const Production& rule, const LSystem& system) {
    Scope scope{system, {}};
    Json result{{"module", pattern_json({rule.predecessor}, scope)[0]}};
    const auto add = [&](const char* name, const Pattern& pattern) {
        if (!pattern.empty()) result[name] = pattern_json(pattern, scope);
    };
    add("left", rule.left);
    add("right", rule.right);
    add("elsewhere", rule.elsewhere);
    if (rule.condition) result["condition"] = expression_json(*rule.condition, scope);
    if (rule.probability) result["probability"] = to_string(*rule.probability);
    result["successor"] = word_json(rule.successor, scope);
    return result;
}

}  // namespace

Json to_json(const LSystem& system) {
    Json rules = Json::array();
    for (const Production& rule : system.rules) rules.push_back(rule_json(rule, system));
    Json result{{"axiom", word_json(system.axiom, {system, {}})}, {"modules", std::move(rules)}};
    for (const Symbol letter : system.ignored)
        result["ignored"].push_back(system.alphabet.name(letter));
    return result;
}

namespace {

using Kind = LanguageTree::Kind;

/// A statement about the word of a system, with what its letters are called.
template <class Said>
Json about_word(Json statement, const Said& said) {
    statement["system"] = said.system->name;
    for (const auto& [letter, name] : said.coding) statement["coding"][letter] = name;
    return statement;
}

Json root_json(const ClaimedNumber& number) {
    Json polynomial = Json::array();
    for (const Integer& one : number.polynomial.coefficients())
        polynomial.push_back(to_string(one));
    return {{"polynomial", std::move(polynomial)}, {"root", number.root}};
}

Json sections_certificate(const std::vector<std::pair<std::uint64_t, std::uint64_t>>& pairs,
                          const std::vector<SectionMatch>& matches, const Alphabet& alphabet) {
    Json words = Json::array(), sections = Json::array();
    for (const auto& [left, right] : pairs) words.push_back({left, right});
    for (const SectionMatch& match : matches)
        sections.push_back({{"left", match.section.left},
                            {"step", match.section.step},
                            {"right", match.section.right},
                            {"stride", match.section.stride},
                            {"proof", balance_certificate(match.balance, alphabet)}});
    return {{"by", "sections"}, {"words", std::move(words)}, {"sections", std::move(sections)}};
}

Json words_json(const std::vector<Word>& words, const Alphabet& alphabet) {
    Json result = Json::array();
    for (const Word& word : words) result.push_back(certificate_text(alphabet, word));
    return result;
}

Json morphism_json(const Morphism& morphism, const Alphabet& alphabet) {
    Json result = Json::object();
    for (const Symbol a : morphism.domain())
        result[alphabet.name(a)] = certificate_text(alphabet, morphism[a]);
    return result;
}

/// The morphism of an image, or the bound name that is one.
Json morphism_json(const LanguageTree& tree, const Alphabet& alphabet) {
    if (tree.variable) return tree.variable->name;
    return morphism_json(tree.morphism, alphabet);
}

/// What stands in the place of a bound name.
struct ValueWriter {
    const Alphabet& alphabet;

    Json operator()(const Language& value) const { return to_json(value, alphabet); }
    Json operator()(const std::shared_ptr<const SourceSystem>& value) const {
        return to_json(*value, alphabet);
    }
    Json operator()(const Morphism& value) const { return morphism_json(value, alphabet); }
    Json operator()(const std::vector<std::pair<Symbol, std::vector<Word>>>& value) const {
        Json result = Json::object();
        for (const auto& [letter, words] : value)
            result[alphabet.name(letter)] = words_json(words, alphabet);
        return result;
    }
    Json operator()(const Word& value) const { return certificate_text(alphabet, value); }
    Json operator()(const Integer& value) const { return to_string(value); }
};

/// How a certificate names the ways to join statements.
const char* joint_name(Joint::Kind kind) {
    switch (kind) {
        case Joint::Kind::all:
            return "all of";
        case Joint::Kind::any:
            return "any of";
        case Joint::Kind::implies:
            return "implies";
        case Joint::Kind::iff:
            return "iff";
    }
    return "";
}

Json pair_json(const LanguageTree& tree, const Alphabet& alphabet) {
    return Json::array({to_json(tree.parts[0], alphabet), to_json(tree.parts[1], alphabet)});
}

/// What a statement says, without its negation.
struct StatementWriter {
    const Alphabet& alphabet;

    Json written(const Language& language) const { return to_json(language, alphabet); }
    Json pair(const Language& left, const Language& right) const {
        return Json::array({written(left), written(right)});
    }

    Json operator()(const InFamily& said) const {
        return {{"is", said.family}, {"language", written(said.language)}};
    }
    Json operator()(const IsFinite& said) const {
        return {{"is", "finite"}, {"language", written(said.language)}};
    }
    Json operator()(const IsEmpty& said) const {
        return {{"is", "empty"}, {"language", written(said.language)}};
    }
    Json operator()(const EqualLanguages& said) const {
        return {{"equal", pair(said.left, said.right)}};
    }
    Json operator()(const IncludedIn& said) const {
        return {{"included", pair(said.inner, said.outer)}};
    }
    Json operator()(const HasWord& said) const {
        return {{"member", certificate_text(alphabet, said.word)},
                {"language", written(said.language)}};
    }
    Json operator()(const HasSize& said) const {
        return {{"size", to_string(said.size)}, {"language", written(said.language)}};
    }
    Json operator()(const IsCode& said) const {
        return {{"is", said.prefix ? "prefix code" : "code"}, {"language", written(said.language)}};
    }
    Json operator()(const IsPalindrome& said) const {
        return {{"palindrome", certificate_text(alphabet, said.word)}};
    }
    Json operator()(const Derives& said) const {
        Json result{{"derives", certificate_text(alphabet, said.word)},
                    {"system", said.system->name}};
        if (said.from) result["from"] = certificate_text(alphabet, *said.from);
        if (said.steps) result["steps"] = *said.steps;
        if (said.bound_steps) result["steps"] = to_text(*said.bound_steps);
        return result;
    }
    Json operator()(const Rewrites& said) const {
        const Scope scope{*said.system, {}};
        Json result{{"derives", word_json(said.word, scope)}, {"system", said.system->name}};
        if (said.from) result["from"] = word_json(*said.from, scope);
        result["steps"] = said.steps;
        return result;
    }
    Json operator()(const HasChance& said) const {
        Json result = (*this)(said.derivation);
        result["probability"] = to_string(said.probability);
        return result;
    }
    Json operator()(const EqualSequences& said) const {
        return {{"equal sequences", Json::array({said.left->name, said.right->name})}};
    }
    Json operator()(const EqualGrowth& said) const {
        return {{"equal growth", Json::array({said.left->name, said.right->name})}};
    }
    Json operator()(const HasGrowthClass& said) const {
        Json result{{"growth", said.system->name}, {"class", said.growth}};
        if (said.degree) result["degree"] = to_string(*said.degree);
        return result;
    }
    Json operator()(const IsIncreasing& said) const {
        return {{"increasing", said.system->name}, {"strictly", said.strictly}};
    }
    Json operator()(const ComparesNumbers& said) const {
        return {{"numbers", Json::array({to_text(said.left), to_string(said.comparison),
                                         to_text(said.right)})}};
    }
    Json operator()(const ComparesWords& said) const {
        const auto side = [&](const std::vector<WordFactor>& factors) {
            Json all = Json::array();
            for (const WordFactor& factor : factors) {
                Json one = Json::object();
                if (factor.system)
                    one = {{"system", factor.system->name},
                           {"generation", to_text(factor.generation)}};
                else
                    one = {{"word", certificate_text(alphabet, factor.word)}};
                for (const Morphism& image : factor.images)
                    one["images"].push_back(morphism_json(image, alphabet));
                if (factor.reversed) one["reversed"] = true;
                all.push_back(std::move(one));
            }
            return all;
        };
        return {{"words", Json::array({side(said.left), to_string(said.kind), side(said.right)})}};
    }
    Json operator()(const HasDimension& said) const {
        return dimension("dimension", said.name, said.dimension);
    }
    Json operator()(const BoundaryHasDimension& said) const {
        return dimension("boundary", said.name, said.dimension);
    }
    Json operator()(const HoldsInWord& said) const {
        return about_word({{"first order", to_json(*said.says)}}, said);
    }
    Json operator()(const CountsInWord& said) const {
        return about_word(to_json(*said.says), said);
    }
    Json operator()(const HasCriticalExponent& said) const {
        return about_word({{"critical exponent", root_json(said.number)},
                           {"compared", to_string(said.comparison)}},
                          said);
    }
    Json operator()(const IsCircular& said) const { return {{"circular", said.system->name}}; }
    Json operator()(const Joint& said) const {
        return {{joint_name(said.kind), statements(said.parts)}};
    }
    Json operator()(const Quantified& said) const {
        Json names = Json::array();
        for (const QuantifiedName& name : said.bindings) {
            Json one{{"name", name.name}, {"of", name.text}};
            const Domain& domain = name.domain;
            if (domain.max_size) one["size"] = *domain.max_size;
            if (domain.max_word_length) one["length"] = *domain.max_word_length;
            if (domain.max_number) one["up to"] = *domain.max_number;
            names.push_back(std::move(one));
        }
        Json result{{said.universal ? "for all" : "for some", std::move(names)}};
        if (said.disjoint) result["different letters"] = true;
        if (said.over) result["over"] = certificate_text(alphabet, *said.over);
        if (!said.conditions.empty()) result["with"] = statements(said.conditions);
        result["holds"] = to_json(said.body.front(), alphabet);
        return result;
    }
    Json statements(const std::vector<Statement>& all) const {
        Json result = Json::array();
        for (const Statement& one : all) result.push_back(to_json(one, alphabet));
        return result;
    }
    static Json dimension(const char* of, const std::string& system,
                          const ClaimedDimension& claimed) {
        return {{of, system},
                {claimed.comparison == Comparison::at_most    ? "at most"
                 : claimed.comparison == Comparison::at_least ? "at least"
                                                              : "equals",
                 claimed.text}};
    }
};

}  // namespace

Json to_json(const ET0L& system, const Alphabet& alphabet, const Word& other) {
    Json tables = Json::array();
    ET0L begun = system;
    begun.axiom.insert(begun.axiom.end(), other.begin(), other.end());
    const std::vector<Symbol> letters = accessible_letters(begun);
    bool all = true;
    Word terminals;
    for (const Table& table : system.tables) {
        Json rules = Json::object();
        for (const Symbol a : letters)
            if (table[a] != std::vector<Word>{Word{a}})
                rules[alphabet.name(a)] = words_json(table[a], alphabet);
        tables.push_back(std::move(rules));
    }
    for (const Symbol a : letters) {
        if (system.terminal[a])
            terminals.push_back(a);
        else
            all = false;
    }
    Json result{{"axiom", certificate_text(alphabet, system.axiom)}, {"tables", std::move(tables)}};
    if (!all) result["terminals"] = certificate_text(alphabet, terminals);
    return result;
}

Json to_json(const SourceSystem& system, const Alphabet& alphabet, const Word& other) {
    if (system.tables) return to_json(*system.tables, alphabet, other);
    const IL& source = *system.interactive;
    Json rules = Json::array();
    Word ignored;
    for (Symbol a = 0; a < source.rules.size(); ++a)
        for (const IL::Rule& rule : source.rules[a])
            rules.push_back({{"left", certificate_text(alphabet, rule.left)},
                             {"letter", alphabet.name(a)},
                             {"right", certificate_text(alphabet, rule.right)},
                             {"successor", certificate_text(alphabet, rule.successor)}});
    for (Symbol a = 0; a < source.ignored.size(); ++a)
        if (source.ignored[a]) ignored.push_back(a);
    Json result{{"axiom", certificate_text(alphabet, source.axiom)}, {"rules", std::move(rules)}};
    if (!ignored.empty()) result["ignored"] = certificate_text(alphabet, ignored);
    return result;
}

namespace {

Json powers_json(const Powers& powers, const Alphabet& alphabet) {
    Json blocks = Json::array(), numbers = Json::array();
    for (const Powers::Block& block : powers.blocks) {
        Json exponent = Json::array();
        for (const Powers::Term& term : block.exponent) {
            Json one{{"coefficient", to_string(term.coefficient)}};
            if (term.number) {
                one["number"] = powers.numbers[*term.number].name;
                if (term.power != 0) one["power"] = term.power;
                if (term.base != 1) one["base"] = to_string(term.base);
            }
            exponent.push_back(std::move(one));
        }
        blocks.push_back(
            {{"word", certificate_text(alphabet, block.word)}, {"exponent", std::move(exponent)}});
    }
    for (const Powers::Number& number : powers.numbers)
        numbers.push_back({{"name", number.name}, {"least", number.least}});
    return {{"powers", std::move(blocks)}, {"numbers", std::move(numbers)}};
}

}  // namespace

Json to_json(const Language& language, const Alphabet& alphabet) {
    const LanguageTree& tree = *language;
    switch (tree.kind) {
        case Kind::words:
            return {{"words", words_json(tree.words, alphabet)}};
        case Kind::generated:
            return {{"generated", tree.system->name}};
        case Kind::united:
            return {{"union", pair_json(tree, alphabet)}};
        case Kind::intersected:
            return {{"intersection", pair_json(tree, alphabet)}};
        case Kind::difference:
            return {{"difference", pair_json(tree, alphabet)}};
        case Kind::concatenated:
            return {{"concatenation", pair_json(tree, alphabet)}};
        case Kind::star:
            return {{"star", to_json(tree.parts[0], alphabet)}};
        case Kind::plus:
            return {{"plus", to_json(tree.parts[0], alphabet)}};
        case Kind::reversed:
            return {{"reversal", to_json(tree.parts[0], alphabet)}};
        case Kind::complement: {
            Json result{{"complement", to_json(tree.parts[0], alphabet)}};
            // Those of a bound name are known when its value is.
            if (!tree.letters.empty()) result["letters"] = certificate_text(alphabet, tree.letters);
            return result;
        }
        case Kind::image:
            return {{"image", to_json(tree.parts[0], alphabet)},
                    {"morphism", morphism_json(tree, alphabet)}};
        case Kind::inverse_image:
            return {{"inverse image", to_json(tree.parts[0], alphabet)},
                    {"morphism", morphism_json(tree, alphabet)}};
        case Kind::variable:
            return {{"name", tree.variable->name}};
        case Kind::powers:
            return powers_json(*tree.powers, alphabet);
    }
    return {};
}

Json to_json(const Statement& statement, const Alphabet& alphabet) {
    Json result = std::visit(StatementWriter{alphabet}, statement.says);
    return statement.negated ? Json{{"not", result}} : result;
}

namespace {

/// Small numbers as numbers, others as digits.
Json number(const Integer& value) {
    if (bit_length(value) <= 53) return value.to_int64();
    return to_string(value);
}

Json derivation_json(const Derivation& derivation, const Alphabet& alphabet) {
    Json result{{"words", words_json(derivation.words, alphabet)}};
    if (!derivation.tables.empty()) result["tables"] = derivation.tables;
    return result;
}

Json course_json(const Course& course, const ET0L& system, const Alphabet& alphabet) {
    Json steps = Json::array();
    for (const TableUse& use : course)
        steps.push_back(
            {{"table", use.table},
             {"letter", alphabet.name(use.letter)},
             {"successor",
              certificate_text(alphabet, system.tables[use.table][use.letter][use.choice])},
             {"place", use.place}});
    return steps;
}

Json construction_json(const TableValue& tables) {
    return {{"by", "construction"}, {"system", to_json(tables.system, *tables.system.alphabet)}};
}

Json witness_json(const FiniteWitness& witness, const Alphabet& alphabet) {
    ET0L system{witness.alphabet,
                witness.axiom,
                witness.tables,
                std::vector<char>(witness.alphabet->size(), 1),
                {},
                {}};
    for (Table& table : system.tables) {
        table.resize(witness.alphabet->size());
        for (Symbol a = 0; a < table.size(); ++a)
            if (table[a].empty()) table[a].push_back({a});
    }
    return to_json(system, alphabet);
}

/// What a certificate holds of a proof, by the kind of its last step.
struct ProofWriter {
    const Alphabet& alphabet;

    Json of(const Part& part) const { return std::visit(*this, part->step); }
    std::string text(const Word& word) const { return certificate_text(alphabet, word); }

    /// Where the rule says it all.
    template <class Step>
    Json operator()(const Step&) const {
        return {{"by", Step::rule}};
    }

    Json operator()(const steps::Generated& said) const {
        return {{"by", "membership"}, {"derivation", derivation_json(said.derivation, alphabet)}};
    }
    Json operator()(const steps::HasPreimage& said) const {
        return {{"by", "membership"}, {"preimage", text(said.source)}};
    }
    /// A derivation shows that a word is in L(G) itself, or in its reversal if it is read backwards. What is made
    /// of L(G) otherwise, and a word with this image, is decided anew.
    Json operator()(const steps::FromParts& said) const {
        if (said.language->kind == Kind::reversed) {
            Json part = of(said.parts.front());
            if (!part.contains("preimage")) return part;
        }
        return {{"by", "membership"}};
    }
    Json operator()(const steps::Derives& said) const {
        Json result{{"by", "derivation"}};
        result.update(derivation_json(said.derivation, alphabet));
        return result;
    }
    Json operator()(const steps::InSomeStep& said) const {
        if (const auto* derived = std::get_if<steps::Generated>(&said.membership->step))
            return (*this)(steps::Derives{derived->system, derived->derivation});
        if (std::holds_alternative<steps::Invariant>(said.membership->step))
            return of(said.membership);
        return {{"by", "exhausted"}};
    }
    Json operator()(const steps::SameSequence& said) const {
        return balance_certificate(said.balance, alphabet);
    }
    Json operator()(const steps::OtherSequence& said) const {
        return difference_certificate(said.difference);
    }
    Json operator()(const steps::OtherGrowth& said) const {
        return {{"by", "generation"}, {"generation", said.difference.generation}};
    }
    Json operator()(const steps::ByRecurrences& said) const {
        Json orders = Json::object();
        for (const auto& [name, order] : said.orders) orders[name] = order;
        return {{"by", "recurrences"}, {"orders", std::move(orders)}};
    }
    Json operator()(const steps::StaysPositive& said) const {
        const auto texts = [](const std::vector<Rational>& numbers) {
            Json all = Json::array();
            for (const Rational& number : numbers) all.push_back(to_string(number));
            return all;
        };
        return {{"by", "positive"},
                {"larger", said.left_is_larger ? "left" : "right"},
                {"from", said.from},
                {"roots", texts(said.roots)},
                {"recurrence", texts(said.recurrence)}};
    }
    Json rule_json(const steps::DerivationRule& rule) const {
        static constexpr std::array names = {"given", "part",    "identity",
                                             "empty", "product", "chain"};
        using RuleKind = steps::DerivationRule::Kind;
        Json result{{"rule", names.at(static_cast<std::size_t>(rule.kind))}};
        if (rule.kind == RuleKind::given || rule.kind == RuleKind::part)
            result["index"] = rule.index;
        if (rule.kind == RuleKind::identity) result["word"] = text(rule.word);
        if (rule.kind == RuleKind::empty)
            for (const auto& [name, times] : rule.steps) result["steps"][name] = times;
        for (const auto& part : rule.parts) result["parts"].push_back(rule_json(part));
        return result;
    }
    Json operator()(const steps::ByDerivations& said) const {
        Json cases = Json::array();
        for (const auto& trees : said.cases) {
            Json one = Json::array();
            for (const auto& tree : trees) one.push_back(rule_json(tree));
            cases.push_back(std::move(one));
        }
        Json result{{"by", "derivations"}};
        if (said.split) result["split"] = *said.split;
        result["cases"] = std::move(cases);
        return result;
    }
    Json operator()(const steps::ByEach& said) const {
        Json proofs = Json::array();
        for (const Part& part : said.proofs) proofs.push_back(of(part));
        return {{"by", "each"}, {"proofs", std::move(proofs)}};
    }
    Json operator()(const steps::ByMorphism& said) const {
        return {{"by", "morphism"}, {"morphism", morphism_json(said.step, alphabet)}};
    }
    Json operator()(const steps::LimitSet& said) const {
        const bool is_exact =
            said.found->status == ExactDimension::Status::exact && !said.boundary && !said.bounds;
        if (said.has_turtle)
            if (const auto witness = limit_witness(*said.found);
                witness && (witness->neighbours || !is_exact))
                return limit_set(*witness, said);
        std::vector<std::string> conditions = said.found->conditions;
        if (said.bounds)
            conditions.push_back("at least " + shortest_text(said.bounds->low) + " by " +
                                 said.bounds->low_by + ", at most " +
                                 shortest_text(said.bounds->high) + " by " + said.bounds->high_by);
        return {{"by", "dimension"}, {"conditions", conditions}};
    }
    /// JSON has no negative numbers here.
    static Json integers(const Displacement::Vector& row) {
        Json result = Json::array();
        for (const std::int64_t entry : row)
            if (entry < 0)
                result.push_back(std::to_string(entry));
            else
                result.push_back(entry);
        return result;
    }
    static std::string decimal_text(double value) {
        constexpr int digits = 9;
        return decimal(exactly(value), digits);
    }
    /// Whether one piece draws in each phase, and once in the axiom: the boundary is where such pieces meet.
    static bool is_of_one_kind(const LimitWitness& witness, const Model& model) {
        const View<D0L> rules = as_d0l(model);
        std::vector<std::size_t> drawing(witness.phases, 0);
        std::set<Symbol> letters;
        for (const LimitWitness::Piece& piece : witness.pieces)
            if (piece.draws) {
                ++drawing[piece.phase];
                letters.insert(piece.letter);
            }
        return rules &&
               std::count_if(rules->axiom.begin(), rules->axiom.end(),
                             [&](Symbol a) { return letters.contains(a); }) == 1 &&
               std::all_of(drawing.begin(), drawing.end(), [](std::size_t n) { return n == 1; });
    }
    static Json limit_set(const LimitWitness& witness, const steps::LimitSet& said) {
        const Alphabet& letters = said.model->alphabet;
        const auto matrix = [](const std::vector<Displacement::Vector>& rows) {
            Json result = Json::array();
            for (const auto& row : rows) result.push_back(integers(row));
            return result;
        };
        const auto name = [&](std::size_t piece) {
            return letters.name(witness.pieces[piece].letter);
        };
        const auto phase = [&](std::size_t piece) { return witness.pieces[piece].phase; };
        Json ways = Json::array(), discs = Json::array();
        for (std::size_t p = 0; p < witness.pieces.size(); ++p) {
            const LimitWitness::Piece& piece = witness.pieces[p];
            if (std::any_of(piece.way.begin(), piece.way.end(), [](auto x) { return x != 0; }))
                ways.push_back(Json::array({name(p), phase(p), integers(piece.way)}));
            if (piece.draws)
                discs.push_back(Json::array(
                    {name(p), phase(p), decimal_text(piece.disc.centre.real()),
                     decimal_text(piece.disc.centre.imag()), decimal_text(piece.disc.radius)}));
        }
        Json result{{"by", "limit set"},
                    {"order", witness.order},
                    {"phases", witness.phases},
                    {"scale", matrix(witness.scale)},
                    {"turn", matrix(witness.turn)},
                    {"ways", std::move(ways)},
                    {"factor", Json::array({decimal_text(witness.factor.real()),
                                            decimal_text(witness.factor.imag())})}};
        if (witness.neighbours || said.boundary || said.bounds) result["discs"] = std::move(discs);
        if (said.bounds) {
            const bool below =
                said.order == Order::greater ||
                (said.order == Order::equal && said.claimed.comparison == Comparison::at_least);
            result["bounds"] = below ? "from below" : "from above";
            return result;
        }
        if (!witness.neighbours || (said.boundary && !is_of_one_kind(witness, *said.model)))
            return result;
        result["component"] = Json::array({name(witness.component), phase(witness.component)});
        Json& neighbours = result["neighbours"] = Json::array();
        for (const LimitWitness::Pair& pair : *witness.neighbours)
            neighbours.push_back(Json::array({name(pair.piece), name(pair.other), phase(pair.piece),
                                              pair.heading, integers(pair.offset)}));
        return result;
    }
    Json operator()(const steps::OtherValues& said) const { return by_word(said.word); }
    Json operator()(const steps::Distinguished& said) const { return by_word(said.word); }
    Json operator()(const steps::FoundWord& said) const { return by_word(said.word); }
    Json by_word(const Word& word) const { return {{"by", "word"}, {"word", text(word)}}; }
    Json operator()(const steps::TwoFactorisations& said) const {
        return {{"by", "factorisations"},
                {"word", text(said.word)},
                {"ends", Json::array({said.left, said.right})}};
    }
    Json operator()(const steps::Beginning& said) const {
        return {
            {"by", "beginning"}, {"word", text(said.word)}, {"beginning", text(said.beginning)}};
    }
    Json operator()(const steps::SameDeterministic& said) const {
        return language_certificate(said.equality, alphabet);
    }
    Json operator()(const steps::WithinDeterministic& said) const {
        return sections_certificate(said.words, said.sections, alphabet);
    }
    Json operator()(const steps::SameProgressions& said) const {
        return {{"by", "progressions"}, {"first", said.first}, {"period", said.period}};
    }
    Json operator()(const steps::RegularProgressions& said) const {
        return {{"by", "progressions"}, {"first", said.first}, {"period", said.period}};
    }
    Json operator()(const steps::UnequalPowers& said) const {
        Json parts = Json::array();
        for (const SectionOfPowers::Part& part : said.section.parts)
            parts.push_back(Json::array({text(part.left), text(part.word), text(part.right)}));
        return {{"by", "unequal powers"},
                {"first", said.section.first},
                {"step", said.section.step},
                {"parts", std::move(parts)}};
    }
    Json operator()(const steps::ByInduction& said) const {
        Json json = {{"by", "induction"}, {"base", words_json(said.base, alphabet)}};
        if (!said.counted.empty()) {
            json["counted"] = Json::array();
            for (const Symbol a : said.counted) json["counted"].push_back(alphabet.name(a));
        }
        if (said.from) {
            json["from"] = *said.from;
            json["tables"] = said.tables;
        }
        return json;
    }
    Json operator()(const steps::BothInclusions& said) const {
        return {{"by", "both"}, {"proofs", Json::array({of(said.there), of(said.back)})}};
    }
    /// The transitions of an automaton that lead to acceptance; state 0 is the first.
    Json automaton_json(const Dfa& automaton, const std::vector<std::int64_t>& weights = {}) const {
        const std::vector<std::size_t> ways = distances(automaton);
        std::vector<std::size_t> order{automaton.initial}, numbers(automaton.states(), 0);
        std::vector<char> seen(automaton.states(), 0);
        seen[automaton.initial] = 1;
        Json accepting = Json::array(), moves = Json::array();
        for (std::size_t i = 0; i < order.size(); ++i) {
            if (automaton.accepting[order[i]]) accepting.push_back(i);
            for (Symbol a = 0; a < automaton.letters; ++a) {
                const std::size_t to = automaton.step(order[i], a);
                if (ways[to] == automaton.states()) continue;
                if (!seen[to]) {
                    seen[to] = 1;
                    numbers[to] = order.size();
                    order.push_back(to);
                }
                Json move{{"from", i}, {"letter", alphabet.name(a)}, {"to", numbers[to]}};
                if (!weights.empty())
                    move["weight"] = std::to_string(weights[order[i] * automaton.letters + a]);
                moves.push_back(std::move(move));
            }
        }
        return {{"accepting", std::move(accepting)}, {"moves", std::move(moves)}};
    }
    Json operator()(const steps::Invariant& said) const {
        Json automata = Json::object();
        for (const auto& [system, automaton] : said.closed)
            automata[system->name] = automaton_json(*automaton);
        return {{"by", "invariant"}, {"automata", std::move(automata)}};
    }
    Json operator()(const steps::Measured& said) const {
        Json rules = Json::array();
        for (const auto& [a, rule] : said.rules)
            rules.push_back({{"left", text(rule.left)},
                             {"letter", alphabet.name(a)},
                             {"right", text(rule.right)},
                             {"successor", text(rule.successor)}});
        return {{"by", "measure"},
                {"words", words_json(said.start.words, alphabet)},
                {"rules", std::move(rules)},
                {"automaton", automaton_json(*said.automaton, said.weights)}};
    }
    Json operator()(const steps::ByFacts& said) const {
        Json facts = Json::array();
        for (const steps::ByFacts::Fact& fact : said.facts) {
            Json sides =
                Json::array({to_json(fact.language, alphabet), to_json(fact.equal, alphabet)});
            if (fact.is_right) std::swap(sides[0], sides[1]);
            facts.push_back({{"equal", std::move(sides)},
                             {"replaced", fact.is_right ? 1 : 0},
                             {"proof", of(fact.proof)}});
        }
        return {{"by", "facts"}, {"facts", std::move(facts)}, {"proof", of(said.proof)}};
    }
    Json operator()(const steps::InfiniteRound& said) const {
        Json rules = Json::array();
        for (const auto& [letter, successor] : said.rules)
            rules.push_back({{"letter", alphabet.name(letter)}, {"successor", text(successor)}});
        return {{"by", "endless round"}, {"rules", rules}, {"other", alphabet.name(said.other)}};
    }
    Json operator()(const steps::InfiniteTables& said) const {
        if (said.constructed) return construction_json(*said.tables);
        const auto course = [&](const Course& each) {
            return course_json(each, said.tables->system, alphabet);
        };
        return {{"by", "endless tables"},
                {"again", alphabet.name(said.endless.again)},
                {"other", alphabet.name(said.endless.other)},
                {"before", course(said.endless.before)},
                {"round", course(said.endless.round)},
                {"beside", course(said.endless.beside)},
                {"kept", course(said.endless.kept)},
                {"after", course(said.endless.after)}};
    }
    Json operator()(const steps::Pumped& said) const {
        return {{"by", "pumping"},
                {"prefix", text(said.prefix)},
                {"middle", text(said.middle)},
                {"suffix", text(said.suffix)}};
    }
    Json operator()(const steps::InfinitePart& said) const {
        return {{"by", "part"}, {"index", said.index}, {"proof", of(said.part)}};
    }
    Json operator()(const steps::InfiniteSize& said) const {
        return {{"by", "infinite"}, {"proof", of(said.infinite)}};
    }
    Json operator()(const steps::FiniteFamily& said) const {
        if (said.answer->witness)
            return {{"by", "system"}, {"system", witness_json(*said.answer->witness, alphabet)}};
        return {{"by", "cases"}, {"obstruction", to_json(*said.answer->obstruction)}};
    }
    Json operator()(const steps::GeneratedBy& said) const {
        return {{"by", "equal"},
                {"system", to_json(*said.system, alphabet)},
                {"proof", of(said.equal)}};
    }
    Json operator()(const steps::ByClasses& said) const {
        Json json = {{"by", "classes"}, {"case", of(said.root)}};
        if (!said.apart.empty()) json["apart"] = words_json(said.apart, alphabet);
        return json;
    }
    Json of(const steps::ByClasses::Case& said) const {
        if (said.letter) return {{"letter", alphabet.name(*said.letter)}};
        if (!said.apart.empty()) return {{"apart", words_json(said.apart, alphabet)}};
        if (said.cases.empty()) return Json::object();
        Json cases = Json::array();
        for (const auto& each : said.cases) cases.push_back(of(each));
        return {{"word", certificate_text(alphabet, said.word)},
                {"images", words_json(said.images, alphabet)},
                {"cases", std::move(cases)}};
    }
    Json operator()(const steps::ByLengths& said) const {
        Json json = {{"by", "lengths"}};
        if (!said.sums.empty()) {
            json["sums"] = said.sums;
            return json;
        }
        json["targets"] = Json::array();
        for (const auto& target : said.targets) {
            Json frames = Json::array();
            for (const auto& frame : target.frames)
                frames.push_back(
                    {{"modulus", frame.modulus}, {"rest", frame.rest}, {"case", of(frame.root)}});
            Json& one = json["targets"].emplace_back(Json::object());
            if (target.length) one["length"] = *target.length;
            if (target.rest) one["rest"] = *target.rest;
            one["frames"] = std::move(frames);
        }
        return json;
    }
    Json of(const steps::ByLengths::Case& said) const {
        if (said.length) return {{"length", *said.length}};
        if (said.rest) return {{"rest", *said.rest}};
        Json cases = Json::array();
        for (const auto& each : said.cases) cases.push_back(of(each));
        return {{"sum", said.sum}, {"cases", std::move(cases)}};
    }
    Json operator()(const steps::NotGeometric& said) const {
        return {{"by", "geometric"}, {"length", said.length}, {"infinite", of(said.infinite)}};
    }
    Json operator()(const steps::LettersOnCycles& said) const {
        return {{"by", "cycles"}, {"word", certificate_text(alphabet, said.word)}};
    }
    Json operator()(const steps::OfReversal& said) const {
        return {{"by", "reversal"}, {"proof", of(said.part)}};
    }

    Json operator()(const steps::RisesByLetters& said) const {
        return {{"by", said.rule}, {"generation", said.generation}};
    }
    Json operator()(const steps::Falls& said) const {
        return {{"by", "generation"}, {"generation", said.generation}};
    }

    Json operator()(const steps::ByAutomata& said) const {
        Json result{{"by", "automata"}};
        if (said.addition.edges.empty()) return result;
        Json edges = Json::array(), accepting = Json::array();
        for (std::size_t s = 0; s < said.addition.states(); ++s) {
            accepting.push_back(said.addition.accepting[s] != 0);
            for (std::size_t e = said.addition.first[s]; e < said.addition.first[s + 1]; ++e) {
                const auto& [column, target] = said.addition.edges[e];
                edges.push_back({s, column % said.base, column / said.base % said.base,
                                 column / said.base / said.base, target});
            }
        }
        result["addition"] = {{"edges", std::move(edges)}, {"accepting", std::move(accepting)}};
        return result;
    }
    Json operator()(const steps::ByBispecialFactors& said) const {
        Json sums = Json::array();
        for (const auto& [n, sum] : said.sums) sums.push_back({to_string(n), std::to_string(sum)});
        return {{"by", "bispecial"}, {"sums", std::move(sums)}};
    }
    Json operator()(const steps::ByRepetitions& said) const {
        return {{"by", said.rule}, {"exponent", root_json(said.exponent)}};
    }
    Json operator()(const steps::RepeatsForEver& said) const {
        return {{"by", said.rule}, {"word", text(said.word)}, {"power", said.power}};
    }
    Json operator()(const steps::Synchronised& said) const {
        return {{"by", said.rule}, {"delay", said.delay}};
    }
    Json operator()(const steps::FromStatements& said) const {
        Json parts = Json::array();
        for (const steps::FromStatements::Known& part : said.parts)
            parts.push_back({{"part", part.index},
                             {"holds", part.answer.truth == Truth::proved},
                             {"proof", certificate(part.answer, alphabet)}});
        return {{"by", "parts"}, {"parts", std::move(parts)}};
    }
    Json operator()(const steps::ByInstance& said) const {
        Json result{{"by", "instance"}, {"values", values(said.values)}};
        if (!said.members.empty()) result["members"] = proofs(said.members);
        if (!said.conditions.empty()) result["with"] = proofs(said.conditions);
        result["proof"] = certificate(said.body, alphabet);
        return result;
    }
    Json operator()(const steps::ByCases& said) const {
        if (said.cases.empty()) return {{"by", said.rule}, {"instances", said.instances}};
        Json cases = Json::array();
        for (const steps::ByCases::Case& each : said.cases) {
            Json& one = cases.emplace_back(Json{{"values", values(each.values)}});
            if (each.member) one["member"] = each.values[*each.member].name;
            if (each.condition) one["condition"] = *each.condition;
            one["proof"] = certificate(each.answer, alphabet);
        }
        return {{"by", said.rule}, {"cases", std::move(cases)}};
    }
    Json operator()(const steps::ByLetters& said) const {
        Json letters = Json::object();
        for (const auto& [name, letter] : said.letters) letters[name] = alphabet.name(letter);
        return {{"by", "letters"}, {"letters", std::move(letters)}, {"proof", of(said.proof)}};
    }
    Json values(const std::vector<BoundValue>& all) const {
        Json result = Json::object();
        for (const BoundValue& value : all)
            result[value.name] = std::visit(ValueWriter{alphabet}, value.is);
        return result;
    }
    Json proofs(const std::vector<Answer>& all) const {
        Json result = Json::array();
        for (const Answer& one : all) result.push_back(certificate(one, alphabet));
        return result;
    }
};

}  // namespace

Json certificate(const Answer& answer, const Alphabet& alphabet) {
    return answer.proof ? std::visit(ProofWriter{alphabet}, answer.proof->step) : Json();
}

std::string method_of(const Answer& answer, const Alphabet& alphabet) {
    if (answer.proof && std::holds_alternative<steps::ByCases>(answer.proof->step))
        return steps::ByCases::rule;  // which may have thousands of them
    const Json written = certificate(answer, alphabet);
    return written.is_object() ? written.value("by", std::string()) : std::string();
}

Json balance_certificate(const Balance& balance, const Alphabet& alphabet) {
    Json states = Json::array();
    for (const Overflow& overflow : balance.states)
        states.push_back({{"ahead", overflow.ahead == Overflow::Ahead::left ? "left" : "right"},
                          {"word", certificate_text(alphabet, overflow.word)}});
    return {{"by", "balance"},
            {"bound", balance.bound},
            {"states", std::move(states)},
            {"accepts", {{"steps", balance.steps}, {"earlier", balance.earlier}}}};
}

Json difference_certificate(const SequenceDifference& difference) {
    return {{"by", "generation"},
            {"generation", difference.generation},
            {"position", number(difference.position)}};
}

Json language_certificate(const LanguageEquality& equality, const Alphabet& alphabet) {
    if (equality.finite) return {{"by", "values"}};
    return sections_certificate(equality.words, equality.sections, alphabet);
}

namespace {

/// The words that statements let the system begin from.
Word begun_from(const Claim& claim, const SourceSystem& system) {
    Word letters;
    for (const ClaimedStatement& claimed : claim.statements)
        if (const auto* said = std::get_if<Derives>(&claimed.statement.says);
            said && said->from && said->system->name == system.name)
            letters.insert(letters.end(), said->from->begin(), said->from->end());
    return letters;
}

/// Adds the turtles of the systems of whose figures the statement speaks, by name.
void add_turtles(const Statement& statement, Json& turtles) {
    if (const auto* said = std::get_if<ComparesNumbers>(&statement.says))
        for (const auto& [name, system] : said->turtles)
            if (!turtles.contains(name)) turtles[name] = turtle_certificate(*system);
    const auto add_of = [&](const std::string& name, const Model& system) {
        if (!turtles.contains(name) && has_lattice_turtle(system))
            turtles[name] = turtle_certificate(system);
    };
    if (const auto* said = std::get_if<HasDimension>(&statement.says))
        add_of(said->name, *said->system);
    if (const auto* said = std::get_if<BoundaryHasDimension>(&statement.says))
        add_of(said->name, *said->system);
    const auto add_all = [&](const std::vector<Statement>& all) {
        for (const Statement& one : all) add_turtles(one, turtles);
    };
    if (const auto* said = std::get_if<Joint>(&statement.says)) add_all(said->parts);
    if (const auto* said = std::get_if<Quantified>(&statement.says)) {
        add_all(said->conditions);
        add_all(said->body);
    }
}

Json statement_json(const ClaimedStatement& claimed, const CheckedStatement& checked,
                    const Alphabet& alphabet) {
    Json result{{"text", claimed.statement.text},
                {"statement", to_json(claimed.statement, alphabet)}};
    if (checked.is_by_citation()) {
        result["verdict"] = "cited";
        result["citation"] = claimed.citation;
        return result;
    }
    result["verdict"] = to_string(checked.answer.truth);
    if (checked.answer.proof) result["proof"] = certificate(checked.answer, alphabet);
    return result;
}

}  // namespace

Json certificate(const CheckedClaim& checked) {
    const Claim& claim = checked.claim;
    Json letters = Json::array(), systems = Json::object(), turtles = Json::object(),
         statements = Json::array();
    for (Symbol a = 0; a < claim.alphabet->size(); ++a) letters.push_back(claim.alphabet->name(a));
    for (const auto& system : claim.systems)
        systems[system->name] = to_json(*system, *claim.alphabet, begun_from(claim, *system));
    for (const auto& system : claim.rewritings) systems[system->name] = to_json(*system);
    for (const ClaimedStatement& claimed : claim.statements)
        add_turtles(claimed.statement, turtles);
    for (std::size_t i = 0; i < checked.statements.size(); ++i)
        statements.push_back(
            statement_json(claim.statements[i], checked.statements[i], *claim.alphabet));
    Json result{
        {"format", "algae certificate 1"}, {"claim", claim.title}, {"source", claim.source}};
    if (claim.empty_axiom) result["empty axiom"] = true;
    result["alphabet"] = std::move(letters);
    result["systems"] = std::move(systems);
    if (!turtles.empty()) result["turtles"] = std::move(turtles);
    result["statements"] = std::move(statements);
    return result;
}

}  // namespace algae
