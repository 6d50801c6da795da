#include "verify/derivatives.hpp"

#include <algorithm>
#include <set>

#include "base/error.hpp"
#include "verify/values.hpp"

namespace algae::verify {

Derivatives::Derivatives(const Alphabet& alphabet, const Budget& budget)
    : alphabet_(alphabet), budget_(budget) {
    none_ = made({});
    empty_word_ = made({Kind::empty_word, 0, {}});
}

Derivatives::Term Derivatives::made(Node node) {
    const auto found = numbers_.find(node);
    if (found != numbers_.end()) return found->second;
    constexpr std::uint64_t bytes_of_a_term = 400;
    budget_.check();
    budget_.check_memory(nodes_.size() * bytes_of_a_term, "the derivatives");
    nodes_.push_back(node);
    numbers_.emplace(std::move(node), nodes_.size() - 1);
    return nodes_.size() - 1;
}

Derivatives::Term Derivatives::product(Term left, Term right) {
    if (left == none_ || right == none_) return none_;
    if (left == empty_word_) return right;
    if (right == empty_word_) return left;
    return made({Kind::product, 0, {left, right}});
}

Derivatives::Term Derivatives::star(Term part) {
    if (part == none_ || part == empty_word_) return empty_word_;
    if (nodes_[part].kind == Kind::star) return part;
    return made({Kind::star, 0, {part}});
}

Derivatives::Term Derivatives::complement(Term part) {
    if (nodes_[part].kind == Kind::complement) return nodes_[part].parts.front();
    return made({Kind::complement, 0, {part}});
}

Derivatives::Term Derivatives::any(std::vector<Term> parts) {
    std::set<Term> distinct;
    for (const Term part : parts) {
        if (nodes_[part].kind == Kind::any)
            distinct.insert(nodes_[part].parts.begin(), nodes_[part].parts.end());
        else if (part != none_)
            distinct.insert(part);
    }
    const Term everything = complement(none_);
    if (distinct.contains(everything)) return everything;
    if (distinct.empty()) return none_;
    if (distinct.size() == 1) return *distinct.begin();
    return made({Kind::any, 0, {distinct.begin(), distinct.end()}});
}

Derivatives::Term Derivatives::all(std::vector<Term> parts) {
    const Term everything = complement(none_);
    std::set<Term> distinct;
    for (const Term part : parts) {
        if (nodes_[part].kind == Kind::all)
            distinct.insert(nodes_[part].parts.begin(), nodes_[part].parts.end());
        else if (part != everything)
            distinct.insert(part);
    }
    if (distinct.contains(none_)) return none_;
    if (distinct.empty()) return everything;
    if (distinct.size() == 1) return *distinct.begin();
    return made({Kind::all, 0, {distinct.begin(), distinct.end()}});
}

Derivatives::Term Derivatives::word(const Word& word, Term rest) {
    for (auto a = word.rbegin(); a != word.rend(); ++a) rest = product(letter(*a), rest);
    return rest;
}

Derivatives::Term Derivatives::convert(const Tree& tree, bool reversed) {
    const auto part = [&](std::size_t i) { return convert(*tree.parts.at(i), reversed); };
    switch (tree.kind) {
        case Tree::Kind::words:
        case Tree::Kind::generated: {
            std::vector<Term> words;
            for (Word each : finite_values_of_leaf(tree, budget_)) {
                if (reversed) std::reverse(each.begin(), each.end());
                words.push_back(word(each, empty_word_));
            }
            return any(std::move(words));
        }
        case Tree::Kind::united:
            return any({part(0), part(1)});
        case Tree::Kind::intersection:
            return all({part(0), part(1)});
        case Tree::Kind::difference: {
            const Term left = part(0);
            return all({left, complement(part(1))});
        }
        case Tree::Kind::concatenation: {
            const Term left = part(reversed ? 1 : 0);
            return product(left, part(reversed ? 0 : 1));
        }
        case Tree::Kind::star:
            return star(part(0));
        case Tree::Kind::plus: {
            const Term once = part(0);
            return product(once, star(once));
        }
        case Tree::Kind::reversal:
            return convert(*tree.parts.at(0), !reversed);
        case Tree::Kind::complement: {
            std::vector<Term> letters;
            for (const Symbol a : tree.letters) letters.push_back(letter(a));
            const Term words = star(any(std::move(letters)));
            return all({words, complement(part(0))});
        }
        case Tree::Kind::image:
        case Tree::Kind::inverse_image:
            break;
    }
    return convert_morphism(tree, reversed);
}

Derivatives::Term Derivatives::convert_morphism(const Tree& tree, bool reversed) {
    Morphism images = tree.morphism;
    if (reversed)
        for (auto& [a, image] : images) std::reverse(image.begin(), image.end());
    const Term part = convert(*tree.parts.at(0), reversed);
    const auto known = std::find(morphisms_.begin(), morphisms_.end(), images);
    const auto number = static_cast<std::size_t>(known - morphisms_.begin());
    if (known == morphisms_.end()) morphisms_.push_back(std::move(images));
    const Kind kind = tree.kind == Tree::Kind::image ? Kind::image : Kind::inverse_image;
    return made({kind, number, {part}});
}

std::vector<Derivatives::Term> Derivatives::after_erased(Term part, std::size_t morphism) {
    const Morphism images = morphisms_[morphism];
    std::vector<Term> reached{part};
    std::set<Term> known{part};
    for (std::size_t i = 0; i < reached.size(); ++i)
        for (const auto& [a, image] : images) {
            if (!image.empty()) continue;
            const Term next = derivative(reached[i], a);
            if (known.insert(next).second) reached.push_back(next);
        }
    return reached;
}

bool Derivatives::nullable(Term term) {
    if (const auto known = nullable_.find(term); known != nullable_.end()) return known->second;
    return nullable_[term] = find_nullable(term);
}

bool Derivatives::find_nullable(Term term) {
    const Node node = nodes_[term];
    const auto is_nullable = [&](Term part) { return nullable(part); };
    switch (node.kind) {
        case Kind::none:
        case Kind::letter:
            return false;
        case Kind::empty_word:
        case Kind::star:
            return true;
        case Kind::product:
        case Kind::all:
            return std::all_of(node.parts.begin(), node.parts.end(), is_nullable);
        case Kind::any:
            return std::any_of(node.parts.begin(), node.parts.end(), is_nullable);
        case Kind::complement:
            return !nullable(node.parts[0]);
        case Kind::inverse_image:
            return nullable(node.parts[0]);
        case Kind::image:
            break;
    }
    const auto erased = after_erased(node.parts[0], node.number);
    return std::any_of(erased.begin(), erased.end(), is_nullable);
}

Derivatives::Term Derivatives::derivative(Term term, Symbol letter) {
    const auto key = std::make_pair(term, letter);
    if (const auto known = derivatives_.find(key); known != derivatives_.end())
        return known->second;
    const Term found = find_derivative(term, letter);
    derivatives_[key] = found;
    return found;
}

Derivatives::Term Derivatives::find_derivative(Term term, Symbol letter) {
    const Node node = nodes_[term];
    std::vector<Term> parts;
    switch (node.kind) {
        case Kind::none:
        case Kind::empty_word:
            return none_;
        case Kind::letter:
            return node.number == letter ? empty_word_ : none_;
        case Kind::product: {
            const Term first = product(derivative(node.parts[0], letter), node.parts[1]);
            return nullable(node.parts[0]) ? any({first, derivative(node.parts[1], letter)})
                                           : first;
        }
        case Kind::star:
            return product(derivative(node.parts[0], letter), term);
        case Kind::any:
        case Kind::all:
            for (const Term part : node.parts) parts.push_back(derivative(part, letter));
            return node.kind == Kind::any ? any(std::move(parts)) : all(std::move(parts));
        case Kind::complement:
            return complement(derivative(node.parts[0], letter));
        case Kind::inverse_image: {
            const auto image = morphisms_[node.number].find(letter);
            if (image == morphisms_[node.number].end()) return none_;
            const Word through = image->second;
            return made({node.kind, node.number, {derivative(node.parts[0], through)}});
        }
        case Kind::image:
            break;
    }
    const Morphism images = morphisms_[node.number];
    for (const Term part : after_erased(node.parts[0], node.number))
        for (const auto& [a, image] : images) {
            if (image.empty() || image.front() != letter) continue;
            const Term rest = made({node.kind, node.number, {derivative(part, a)}});
            parts.push_back(word({image.begin() + 1, image.end()}, rest));
        }
    return any(std::move(parts));
}

Derivatives::Term Derivatives::derivative(Term term, const Word& word) {
    for (const Symbol a : word) term = derivative(term, a);
    return term;
}

bool Derivatives::included(Term left, Term right) {
    std::set<std::pair<Term, Term>> known{{left, right}};
    std::vector<std::pair<Term, Term>> open{{left, right}};
    for (std::size_t i = 0; i < open.size(); ++i) {
        const auto [one, other] = open[i];
        if (one == none_ || one == other) continue;
        if (nullable(one) && !nullable(other)) return false;
        budget_.check();
        budget_.check_memory(open.size() * 100, "the pairs of derivatives");
        for (Symbol a = 0; a < alphabet_.size(); ++a) {
            const auto next = std::make_pair(derivative(one, a), derivative(other, a));
            if (known.insert(next).second) open.push_back(next);
        }
    }
    return true;
}

bool Derivatives::equal(Term left, Term right) {
    return included(left, right) && included(right, left);
}

Derivatives::Automaton Derivatives::automaton(Term term) {
    Automaton found;
    std::map<Term, std::size_t> numbers{{term, 0}};
    std::vector<Term> states{term};
    for (std::size_t i = 0; i < states.size(); ++i) {
        budget_.check();
        budget_.check_memory(states.size() * (100 + 8 * alphabet_.size()), "the automaton");
        found.accepting.push_back(nullable(states[i]));
        auto& next = found.next.emplace_back();
        for (Symbol a = 0; a < alphabet_.size(); ++a) {
            const Term to = derivative(states[i], a);
            const auto [place, is_new] = numbers.emplace(to, states.size());
            if (is_new) states.push_back(to);
            next.push_back(place->second);
        }
    }
    return found;
}

}  // namespace algae::verify
