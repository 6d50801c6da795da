#include "language/finite_proof.hpp"

#include <algorithm>

#include "language/finite_sentences.hpp"

namespace algae {

namespace {

using End = ObstructionCase::End;

class ProofText {
public:
    explicit ProofText(const FamilyObstruction& proof) : proof_(proof), say_(proof.language) {}

    std::string text() {
        const std::string name = to_string(proof_.language);
        const std::string family = to_string(proof_.family);
        line(name + " is not " + family + ".");
        RulesLeft left = factors();
        if (!left.empty()) {
            line(
                "Suppose that a system generates it. Each letter occurs in a word of the language, "
                "and what that word "
                "gives is in the language again. So an image of a letter" +
                std::string(proof_.family.tables ? ", in any table," : "") + " is " +
                images(left.begin()->second) + ".");
        }
        exclusions(proof_.root, left);
        if (proof_.family.tables) {
            for (const ImpossibleTable& table : proof_.impossible) impossible(table, left);
            line(say_.never_reached(proof_.root.sources));
        } else {
            end(proof_.root, left, "");
        }
        line("So " + name + " is not " + family + ".");
        return std::move(text_);
    }

private:
    void line(const std::string& sentence) {
        text_ += std::string(2 * depth_, ' ') + sentence + "\n";
    }

    RulesLeft factors() const {
        std::set<Word> all;
        if (!proof_.family.propagating) all.emplace();
        for (const Word& word : proof_.language.words)
            for (auto from = word.begin(); from != word.end(); ++from)
                for (auto to = from; to != word.end();) all.emplace(from, ++to);
        RulesLeft left;
        for (const Symbol a : letters_of(proof_.language)) left[a] = all;
        return left;
    }

    std::string images(const std::set<Word>& factors) const {
        const std::string what = proof_.family.propagating ? "factors of its words other than ε"
                                                           : "factors of its words";
        if (factors.size() > 12) return "one of the " + std::to_string(factors.size()) + " " + what;
        std::vector<std::string> names;
        for (const Word& image :
             make_finite_language(proof_.language.alphabet, {factors.begin(), factors.end()}).words)
            names.push_back(say_.word(image));
        return (names.size() == 1 ? "the only one of the " : "one of the ") + what + ": " +
               FiniteSentences::listed(names, " or ");
    }

    void exclusions(const ObstructionCase& part, RulesLeft& left) {
        const auto& all = part.excluded;
        for (std::size_t i = 0; i < all.size();) {
            std::size_t next =
                i + 1;  // one sentence for rules of one letter that go by the same word
            while (next < all.size() && all[i].images.empty() && all[next].images.empty() &&
                   all[next].rule.letter == all[i].rule.letter && all[next].word == all[i].word)
                ++next;
            line(say_.impossible(std::span(all).subspan(i, next - i), left));
            for (; i < next; ++i) left[all[i].rule.letter].erase(all[i].rule.image);
        }
        if (!all.empty() && part.end != End::no_image && part.end != End::needed)
            line(say_.left(left) +
                 (left.size() > 1 || left.begin()->second.size() > 1 ? " are" : " is") + " left.");
    }

    void impossible(const ImpossibleTable& table, RulesLeft left) {
        const std::string claim =
            "No table has " + say_.rules(table.rules) + (table.rules.size() > 1 ? " together" : "");
        const ObstructionCase& why = table.why;
        if (why.excluded.empty() && why.end == End::conflict && why.rules.empty()) {
            line(claim + ": " + say_.departure(why.word, why.images) + ".");
            return;
        }
        line(claim + ". Suppose one has:");
        ++depth_;
        if (proof_.family.deterministic)
            for (const LetterRule& rule : table.rules) left[rule.letter] = {rule.image};
        exclusions(why, left);
        end(why, left, "");
        --depth_;
    }

    void end(const ObstructionCase& part, const RulesLeft& left, const std::string& number) {
        switch (part.end) {
            case End::no_image:
                line("No rule is left for " + say_.word({part.letter}) + ": a contradiction.");
                return;
            case End::needed:
                line("But " + say_.rule(part.excluded.back().rule) + " is there: a contradiction.");
                return;
            case End::sources:
                line(say_.never_reached(part.sources));
                return;
            case End::conflict:
                conflict(part, left, number);
                return;
            case End::choice:
                choice(part, left, number);
                return;
        }
    }

    void conflict(const ObstructionCase& part, RulesLeft left, const std::string& number) {
        std::string step = say_.departure(part.word, part.images);
        step.front() = 'B';
        if (part.rules.empty()) {
            line(step + ", but these rules are there: a contradiction.");
            return;
        }
        line(step + ". So " + FiniteSentences::listed(texts(part.rules), " or ") + " is missing.");
        for (std::size_t i = 0; i < part.rules.size(); ++i) {
            RulesLeft rest = left;
            rest[part.rules[i].letter].erase(part.rules[i].image);
            const std::vector<LetterRule> before(
                part.rules.begin(), part.rules.begin() + static_cast<std::ptrdiff_t>(i));
            const std::string there = i == 0 ? ""
                                             : FiniteSentences::listed(texts(before)) +
                                                   (i > 1 ? " are" : " is") + " there, ";
            one_case(part.cases[i], rest, number + std::to_string(i + 1),
                     there + say_.rule(part.rules[i]) + " is missing");
        }
    }

    void choice(const ObstructionCase& part, const RulesLeft& left, const std::string& number) {
        for (std::size_t i = 0; i < part.rules.size(); ++i) {
            RulesLeft only = left;
            only[part.letter] = {part.rules[i].image};
            one_case(part.cases[i], only, number + std::to_string(i + 1), say_.rule(part.rules[i]));
        }
    }

    void one_case(const ObstructionCase& part, RulesLeft left, const std::string& number,
                  const std::string& what) {
        line("Case " + number + ": " + what + ".");
        ++depth_;
        exclusions(part, left);
        end(part, left, number + ".");
        --depth_;
    }

    std::vector<std::string> texts(const std::vector<LetterRule>& rules) const {
        std::vector<std::string> all;
        for (const LetterRule& rule : rules) all.push_back(say_.rule(rule));
        return all;
    }

    const FamilyObstruction& proof_;
    FiniteSentences say_;
    std::string text_;
    std::size_t depth_ = 0;
};

}  // namespace

std::string proof_text(const FamilyObstruction& obstruction) {
    return ProofText(obstruction).text();
}

Verdict verdict_on(const FiniteLanguage& language, Family family, const FamilyAnswer& answer) {
    if (answer.witness)
        return Verdict::proved(to_string(language) + " is " + to_string(family) + ": " +
                               to_string(*answer.witness) + ".");
    if (answer.obstruction) return Verdict::refuted(proof_text(*answer.obstruction));
    return Verdict::undecided(answer.tried);
}

}  // namespace algae
