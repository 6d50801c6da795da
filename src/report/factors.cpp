// The factors of a D0L system up to a length, and what is proved of its infinite word for all lengths, as a page, as JSON and as LaTeX.
//
// The page shows the first entries of long lists and says how many more there are; JSON is complete.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "render/render.hpp"
#include "report/detail/page.hpp"
#include "report/report.hpp"
#include "watch/watch.hpp"

namespace algae {

namespace {

constexpr int digits_shown = 6, digits_in_json = 15;  // after the point

}  // namespace

namespace {

/// Whether the axiom is among the factors of the infinite word of a morphism that prolongs a letter.
bool has_axiom(D0L system, Symbol a, const Budget& budget) {
    constexpr std::size_t longest = 64;  // axiom that is looked for
    const Word axiom = std::exchange(system.axiom, {a});
    return axiom.size() <= longest &&
           std::ranges::count(factors(system, axiom.size(), budget).words, axiom) > 0;
}

/// Whether the words of a system have the factors of its infinite word: they begin it, or the axiom is a factor of it and so are the others.
bool has_factors_of_infinite_word(const D0L& system, const Budget& budget) {
    if (generates_infinite_word(system)) return true;
    try {
        return has_axiom(system, Numeration(system).letters().front(), budget);
    } catch (const Error&) {
        return false;  // there is none
    }
}

/// The factors of one length from those of one letter more and from whole words of that length, in order.
std::vector<Word> shorter_factors(const std::vector<Word>& longer, std::vector<Word> whole) {
    for (const Word& word : longer) {
        whole.emplace_back(word.begin(), word.end() - 1);
        whole.emplace_back(word.begin() + 1, word.end());
    }
    std::ranges::sort(whole);
    whole.erase(std::unique(whole.begin(), whole.end()), whole.end());
    return whole;
}

/// Those of the factors that are bispecial, by the factors of one and of two letters more.
std::vector<FactorValues::Bispecial> bispecial_factors(const std::vector<Word>& words,
                                                       const std::vector<Word>& longer,
                                                       const std::vector<Word>& longest) {
    struct Ways {
        std::int64_t left = 0, right = 0, both = 0;
    };
    std::vector<Ways> ways(words.size());
    const auto of = [&](auto begin, auto end) -> Ways& {
        const auto at =
            std::lower_bound(words.begin(), words.end(), std::ranges::subrange(begin, end),
                             [](const Word& word, const auto& part) {
                                 return std::ranges::lexicographical_compare(word, part);
                             });
        return ways[static_cast<std::size_t>(at - words.begin())];
    };
    for (const Word& word : longer) {
        ++of(word.begin() + 1, word.end()).left;
        ++of(word.begin(), word.end() - 1).right;
    }
    for (const Word& word : longest) ++of(word.begin() + 1, word.end() - 1).both;
    std::vector<FactorValues::Bispecial> found;
    for (std::size_t i = 0; i < words.size(); ++i)
        if (const auto& [left, right, both] = ways[i]; left > 1 && right > 1)
            found.push_back({words[i], both - left - right + 1});
    return found;
}

/// Whether long factors are cut into images in one way alone (Klouda and Starosta 2019: exactly if no word that grows has all its powers
/// among the factors); nothing if the morphism is not injective.
std::optional<bool> is_circular(const D0L& system, const Budget& budget) {
    for (const Symbol letter : system.letters)
        if (system.successor(letter).empty()) return std::nullopt;
    if (made_injective({system.axiom, system.rules}, budget).steps > 0) return std::nullopt;
    for (const InfiniteRepetition& one : infinite_repetitions(system, budget))
        if (one.grows) return false;
    return true;
}

/// A morphism that prolongs a letter, and the infinite word that it makes of it.
struct Prolonged {
    Morphism h;
    Symbol letter;
};

/// If the words of a system have the factors of an infinite word: their own, or, if letters take turns at the beginning, one of a
/// power of a primitive morphism.
std::optional<Prolonged> prolonged(const D0L& system, const FactorValues& report,
                                   const Budget& budget) {
    if (report.infinite_word) return Prolonged{system.rules, Numeration(system).letters().front()};
    const auto grows = [&](Symbol letter) { return system.successor(letter).size() > 1; };
    if (!report.primitivity.exponent || std::ranges::none_of(system.letters, grows))
        return std::nullopt;  // a letter that stays as it is has a primitive matrix too
    Symbol a = system.axiom.front();
    for (std::size_t i = 0; i < system.letters.size(); ++i) a = system.successor(a).front();
    D0L power = system;
    while (power.successor(a).front() != a || power.successor(a).size() < 2) {
        budget.check();
        std::vector<Word> images = power.rules.images();
        for (const Symbol letter : system.letters)
            images[letter] = system.rules(power.successor(letter));
        power.rules = Morphism(std::move(images));
    }
    if (!has_axiom(power, a, budget)) return std::nullopt;
    return Prolonged{power.rules, a};
}

/// What is decided; nothing where there is no infinite word, its first letter does not come back, or the way there gets too large.
template <class Decide>
std::invoke_result_t<Decide> if_possible(Decide decide) {
    try {
        return decide();
    } catch (const Error&) {
        return {};
    } catch (const BoundReached& bound) {
        if (bound.bound() == Bound::time) throw;
        return {};
    }
}

/// The length of the least beginning of an infinite word that has fewer palindromes than it could have; nothing if it is not short.
std::optional<std::size_t> poor_beginning(const Prolonged& word, const Morphism* coding,
                                          const Budget& budget) {
    constexpr std::size_t enough = 2'000;
    Word text{word.letter};
    while (text.size() < enough) {
        Word longer = word.h(text);
        if (longer.size() == text.size()) return std::nullopt;
        text = std::move(longer);
        budget.check_memory(text.size() * sizeof(Symbol), "the beginning of the infinite word");
    }
    text.resize(enough);
    if (coding) text = (*coding)(text);
    const auto defect = [&](std::size_t length) {
        return palindromic_factors(
                   Word(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(length)), budget)
            .defect;
    };
    if (defect(enough) == 0) return std::nullopt;
    std::size_t rich = 0, poor = enough;  // longer beginnings have no smaller defects
    while (poor - rich > 1) {
        const std::size_t middle = rich + (poor - rich) / 2;
        (defect(middle) == 0 ? rich : poor) = middle;
    }
    return poor;
}

/// What returns, bispecial factors and columns say of the infinite word.
void look_at_word(FactorValues& found, const D0L& system, const Morphism* coding,
                  const Budget& budget) {
    const auto word = if_possible([&] { return prolonged(system, found, budget); });
    if (!word) return;
    found.poor_beginning = poor_beginning(*word, coding, budget);
    if (found.poor_beginning) found.rich = false;
    if (coding) return;
    const auto& [h, letter] = *word;
    found.for_all =
        if_possible([&] { return std::optional(complexity_for_all(h, letter, budget)); });
    found.derived = if_possible([&] { return std::optional(derived_words(h, letter, budget)); });
    found.columns = if_possible([&] { return constant_length(h, letter, budget); });
    if (found.columns) found.pure_point = found.columns->column_number == 1;
    // Droubay, Justin and Pirillo 2001.
    if (found.for_all && found.for_all->episturmian) found.rich = true;
}

/// What is said of the morphism, and of its letters.
void look_at_morphism(FactorValues& found, const D0L& system, const Budget& budget) {
    Morphism rules;
    for (const Symbol letter : system.letters) rules.add(letter, system.successor(letter));
    found.morphism = morphism_properties(rules, budget);
    const std::vector<char> grows = growing_letters(system.rules);
    const std::vector<std::uint64_t> lives = lifetimes(system.rules);
    for (const Symbol letter : rules.domain())
        (lives[letter] != lasts ? found.mortal
         : grows[letter]        ? found.growing
                                : found.bounded)
            .push_back(letter);
}

/// The frequencies of letters after a coding; none where they have no limit.
template <class Coded>
std::vector<std::optional<Frequency>> frequencies_of(const D0L& system, Coded coded,
                                                     std::size_t letters, const Budget& budget) {
    std::vector<std::optional<Frequency>> found(letters);
    const LetterFrequencies all = letter_frequencies(system, budget);
    if (all.limits.size() != 1) return found;
    for (std::size_t i = 0; i < system.letters.size(); ++i) {
        std::optional<Frequency>& sum = found[coded(system.letters[i])];
        sum = sum ? *sum + all.limits.front()[i] : all.limits.front()[i];
    }
    return found;
}

template <class Coded>
FactorRecurrence recurrence_of(const D0L& system, const Alphabet& names, Coded coded,
                               std::size_t to, const Budget& budget) {
    try {
        return factor_recurrence(
            automatic_word(system, [&](Symbol letter) { return names.name(coded(letter)); }), to,
            budget);
    } catch (const Error&) {
        return {};  // it has no numeration of its own
    }
}

}  // namespace

FactorValues factor_values(const D0L& system, const Coding& coding, std::size_t to,
                           const Budget& budget) {
    FactorValues found;
    found.to = to;
    found.infinite_word = has_factors_of_infinite_word(system, budget);
    FactorSet longest = factors(system, to + 2, budget);
    found.alphabet = found.morphism_alphabet = *system.alphabet;
    std::optional<LetterCoding> images;
    if (!coding.empty()) {
        images.emplace(*system.alphabet, coding);
        for (Word& word : longest.words) word = images->morphism(word);
        found.alphabet = images->alphabet;
        found.coded = true;
    }
    const std::size_t letters = found.alphabet.size();
    const auto coded = [&](Symbol letter) {
        return images ? images->morphism[letter].front() : letter;
    };
    found.apart.assign(letters, 0);
    found.primitivity = primitivity(growth_matrix(system));
    for (const Component& part : components(growth_matrix(system), budget).list)
        if (part.rate) found.rate = std::max(found.rate, *part.rate);
    found.frequencies = frequencies_of(system, coded, letters, budget);
    if (!images) found.circular = is_circular(system, budget);
    look_at_morphism(found, system, budget);
    look_at_word(found, system, images ? &images->morphism : nullptr, budget);
    if (found.infinite_word)
        found.recurrence = recurrence_of(system, found.alphabet, coded, to, budget);
    found.factors.assign(to + 1, 0);
    found.palindromes = found.abelian = found.imbalance = found.factors;
    std::vector<Word> words, longer, longer_still;  // of `length`, of one and of two letters more
    WorkCount lengths("factors of length");
    for (std::size_t length = to + 3; length-- > 0;) {
        budget.check();
        lengths.at(length);
        std::vector<Word> whole;
        for (const Word& word : longest.words)
            if (word.size() == length) whole.push_back(word);
        longer_still = std::move(longer);
        longer = std::move(words);
        words = shorter_factors(longer, std::move(whole));
        if (length > to) continue;
        std::set<std::vector<std::uint32_t>> counts;
        std::vector<std::uint32_t> least(letters, ~std::uint32_t{0}), most(letters, 0);
        std::uint64_t palindromes = 0;
        bool is_reversed = true;
        for (const Word& word : words) {
            const Word turned(word.rbegin(), word.rend());
            palindromes += turned == word;
            if (is_reversed && !std::ranges::binary_search(words, turned)) {
                is_reversed = false;
                found.not_reversed = word;
            }
            std::vector<std::uint32_t> count(letters, 0);
            for (const Symbol letter : word) ++count[letter];
            for (std::size_t a = 0; a < letters; ++a) {
                least[a] = std::min(least[a], count[a]);
                most[a] = std::max(most[a], count[a]);
            }
            counts.insert(std::move(count));
        }
        for (std::size_t a = 0; a < letters && !words.empty(); ++a) {
            const std::uint64_t apart = most[a] - least[a];
            found.imbalance[length] = std::max(found.imbalance[length], apart);
            found.apart[a] = std::max(found.apart[a], apart);
        }
        found.factors[length] = words.size();
        found.palindromes[length] = palindromes;
        found.abelian[length] = counts.size();
        if (!found.infinite_word) continue;
        auto bispecial = bispecial_factors(words, longer, longer_still);
        std::ranges::move(found.bispecial, std::back_inserter(bispecial));
        found.bispecial = std::move(bispecial);
    }
    return found;
}

namespace {

/// "2n - 1".
std::string linear_text(const Integer& slope, const Integer& constant) {
    std::string text = slope.is_zero() ? "" : slope == 1 ? "n" : to_string(slope) + "n";
    if (text.empty())
        text = to_string(constant);
    else if (!constant.is_zero())
        text += (constant > 0 ? " + " : " - ") + to_string(constant > 0 ? constant : -constant);
    return text;
}

std::string text_of(const Integer& number) { return to_string(number); }

/// "l(k) = 2l(k-1) - l(k-2)".
std::string recurrence_text(const BispecialChain& chain) {
    std::string text;
    for (std::size_t i = 0; i < chain.recurrence.size(); ++i) {
        const Integer& factor = chain.recurrence[i];
        if (factor.is_zero()) continue;
        const Integer size = factor > 0 ? factor : -factor;
        text += text.empty() ? (factor > 0 ? "" : "-") : (factor > 0 ? " + " : " - ");
        text += (size == 1 ? "" : to_string(size)) + fmt::format("l(k-{})", i + 1);
    }
    return "l(k) = " + (text.empty() ? "0" : text);
}

/// The second differences of a complexity, which are 0 but at some n.
std::string second_differences(const ComplexityForAll& all) {
    std::string text =
        fmt::format("p(0) = 1, p(1) = {}, and p(n+2) - 2p(n+1) + p(n) is 0 but for ", all.letters);
    std::map<std::int64_t, std::vector<Integer>> single;
    for (const auto& [n, value] : all.single) single[value].push_back(n);
    std::vector<std::string> parts;
    for (const auto& [value, places] : single)
        parts.push_back(fmt::format("{:+} at n = {}", value, joined(places, ", ", text_of)));
    for (const BispecialChain& chain : all.chains)
        parts.push_back(fmt::format("{:+} at n = {}, ... with {}", chain.multiplicity,
                                    joined(chain.lengths, ", ", text_of), recurrence_text(chain)));
    return text + joined(parts, "; ") + (all.chains.empty() ? "" : " (added where they meet)");
}

/// A formula for the values from some n on, and that n; nothing if none was found.
std::optional<std::pair<std::string, Integer>> formula_of(const ComplexityProof* proof,
                                                          const ComplexityForAll* all) {
    if (all) {
        if (const auto linear = all->linear())
            return std::pair(linear_text(linear->slope, linear->constant), linear->from);
        return std::pair(second_differences(*all), Integer(0));
    }
    if (!proof) return std::nullopt;
    if (const auto& linear = proof->linear)
        return std::pair(linear_text(linear->slope, linear->constant), linear->from);
    if (const auto& periodic = proof->periodic) {
        std::string text;
        for (const Integer& value : periodic->values)
            text += (text.empty() ? "" : ", ") + to_string(value);
        return std::pair(
            text + fmt::format(" for n = 0, 1, ... modulo {}", periodic->values.size()),
            periodic->from);
    }
    return std::nullopt;
}

/// The lines below the values, if something is proved for all n.
std::string for_all_line(const ComplexityProof* proof, const ComplexityForAll* all) {
    std::string page;
    if (const auto found = formula_of(proof, all))
        page = line(
            "  for all n",
            found->first +
                (found->second.is_zero() ? "" : " from n = " + to_string(found->second) + " on") +
                ": proved");
    const bool is_formula = all ? all->chains.empty() : !page.empty();
    if (!proof || is_formula || proof->differences.empty()) return page;
    return line("  for all n", "the next one is greater by " +
                                   joined(proof->differences, ", ", text_of) + ": proved") +
           page;
}

/// The letters in the order of their names.
std::map<std::string, std::size_t> by_name(const Alphabet& alphabet) {
    std::map<std::string, std::size_t> found;
    for (std::size_t a = 0; a < alphabet.size(); ++a)
        found.emplace(alphabet.name(static_cast<Symbol>(a)), a);
    return found;
}

std::string joined_letters(const std::vector<std::string>& letters) {
    const bool is_long =
        std::ranges::any_of(letters, [](const std::string& one) { return one.size() > 1; });
    return joined(letters, is_long ? " " : "");
}

std::string exact_and_decimal(const Frequency& number) {
    const std::string exact = number.exact();
    if (exact.find_first_not_of("-0123456789") == std::string::npos) return exact;
    return exact + " = " + number.decimal(digits_shown);
}

std::string exponent_lines(const FactorValues& report) {
    if (!report.exponent) return "";
    const CriticalExponent& found = *report.exponent;
    if (found.infinite) return line("critical exponent", "infinite: proved");
    std::string text = exact_and_decimal(*found.value);
    text += found.factor
                ? fmt::format(", of {} letters with the period {}: proved",
                              to_string(found.factor->first), to_string(found.factor->second))
                : ", which no factor reaches: proved";
    std::string all = line("critical exponent", text);
    if (found.asymptotic && found.attained)
        all += line("  of long factors", exact_and_decimal(*found.asymptotic) + ": proved");
    return all;
}

Json to_json(const Frequency& number) {
    return Json{{"exact", number.exact()}, {"decimal", number.decimal(digits_in_json)}};
}

Json exponent_of(const FactorValues& report) {
    if (!report.exponent) return Json();
    const CriticalExponent& found = *report.exponent;
    if (found.infinite) return "infinite";
    Json all = to_json(*found.value);
    all.set("attained", found.attained);
    all.set("length", found.factor ? Json(found.factor->first) : Json());
    all.set("period", found.factor ? Json(found.factor->second) : Json());
    all.set("asymptotic", found.asymptotic ? to_json(*found.asymptotic) : Json());
    return all;
}

/// p(n+2) - 2 p(n+1) + p(n): where it is not 0.
Json to_json(const ComplexityForAll& all) {
    Json single = Json::array(), chains = Json::array();
    for (const auto& [n, value] : all.single) single.add(Json{{"n", n}, {"value", value}});
    for (const BispecialChain& chain : all.chains)
        chains.add(Json{
            {"value", chain.multiplicity}, {"n", chain.lengths}, {"recurrence", chain.recurrence}});
    return {{"letters", all.letters}, {"single", std::move(single)}, {"chains", std::move(chains)}};
}

/// What is proved of the factors, and of the palindromes; none where nothing is.
std::pair<const ComplexityProof*, const ComplexityProof*> proofs_of(const FactorValues& report) {
    if (!report.proofs) return {nullptr, nullptr};
    return {&report.proofs->factors, &report.proofs->palindromes};
}

/// "injective, a prefix code; marked on the left; 2 conjugates; of class P".
std::string morphism_text(const FactorValues& report) {
    const MorphismProperties& found = report.morphism;
    std::vector<std::string> all;
    const auto add = [&](bool holds, const char* what) {
        if (holds) all.push_back(what);
    };
    const auto word = [&](const Word& one) { return spell(report.morphism_alphabet, one); };
    if (found.same_image)
        all.push_back("not injective: " + word(found.same_image->first) + " and " +
                      word(found.same_image->second) + " have the same image");
    else
        all.push_back(found.prefix_code && found.suffix_code ? "injective, a bifix code"
                      : found.prefix_code                    ? "injective, a prefix code"
                      : found.suffix_code                    ? "injective, a suffix code"
                                                             : "injective");
    if (found.shortest == found.longest)
        all.push_back(fmt::format("of constant length {}", found.longest));
    add(found.left_marked && found.right_marked, "marked on both sides");
    add(found.left_marked && !found.right_marked, "marked on the left");
    add(!found.left_marked && found.right_marked, "marked on the right");
    add(found.cyclic, "cyclic");
    if (found.conjugates > 1) all.push_back(fmt::format("{} conjugates", found.conjugates));
    add(found.class_p, "of class P");
    add(!found.class_p && found.conjugate_of_class_p, "conjugate to one of class P");
    add(found.sturmian, "Sturmian");
    add(found.automorphism && !found.sturmian, "an automorphism of the free group");
    return joined(all, "; ");
}

std::array<std::pair<const char*, const std::vector<Symbol>*>, 3> letter_kinds(
    const FactorValues& report) {
    return {
        {{"growing", &report.growing}, {"bounded", &report.bounded}, {"mortal", &report.mortal}}};
}

std::string morphism_lines(const FactorValues& report) {
    const MorphismProperties& found = report.morphism;
    std::string page = line("morphism", morphism_text(report));
    std::vector<std::string> letters;
    for (const auto& [kind, all] : letter_kinds(report))
        if (!all->empty())
            letters.push_back(
                joined(*all, ", ",
                       [&](Symbol letter) { return report.morphism_alphabet.name(letter); }) +
                ": " + kind);
    if (letters.size() > 1 || report.growing.empty())
        page += line("  letters", joined(letters, "; "));
    if (found.makes_square)
        page += line(
            "  squares",
            "the image of " + spell(report.morphism_alphabet, *found.makes_square) + " has one");
    else if (found.square_free)
        page += line("  squares", "words without squares have images without");
    if (found.overlap_free)
        page += line("  overlaps", *found.overlap_free
                                       ? "words without overlaps have images without"
                                       : "some word without overlaps has an image with one");
    page += line("  eigenvalues", "roots of " + to_string(found.characteristic) +
                                      (found.irreducible ? ", irreducible" : "") +
                                      (found.pisot   ? "; the greatest is a Pisot number"
                                       : found.salem ? "; the greatest is a Salem number"
                                                     : ""));
    return page;
}

std::vector<std::string> families_of(const ComplexityForAll& found) {
    std::vector<std::string> all;
    if (found.arnoux_rauzy) all.push_back(found.letters == 2 ? "Sturmian" : "Arnoux-Rauzy");
    if (found.episturmian) all.push_back("episturmian");
    if (found.dendric) all.push_back("dendric");
    return all;
}

/// Numbers, with blanks between them where some are long.
std::string numbers_text(const Word& word) {
    const bool is_long = std::ranges::any_of(word, [](Symbol one) { return one > 9; });
    return joined(word, is_long ? " " : "", [](Symbol one) { return std::to_string(one); });
}

std::string derived_lines(const FactorValues& report) {
    constexpr std::size_t words_shown = 3, letters_of_rules = 80;
    const DerivedWords& all = *report.derived;
    const std::size_t count = all.words.size();
    const std::size_t again = count - all.before;
    const std::string turns = count == 1 ? "which comes again"
                              : again == 1
                                  ? "the last of which comes again"
                                  : fmt::format("the last {} of which come again in turn", again);
    std::string page = line("derived words", fmt::format("{}, {}", count, turns));
    for (std::size_t i = 0; i < std::min(count, words_shown); ++i) {
        const DerivedWord& one = all.words[i];
        const std::vector<Symbol> letters = one.h.domain();
        const std::string rules = joined(letters, ", ", [&](Symbol letter) {
            return std::to_string(letter) + " -> " + numbers_text(one.h[letter]);
        });
        const std::string returns = joined(one.returns, ", ", numbers_text);
        if (rules.size() + returns.size() > letters_of_rules) {
            page += line("", fmt::format("of {} letters", letters.size()));
            continue;
        }
        page += line("", rules + "; returns " + returns);
    }
    return page;
}

/// What the infinite word is, beside the values.
std::string word_lines(const FactorValues& report) {
    std::string page;
    if (report.for_all) {
        const auto families = families_of(*report.for_all);
        page += line("families", (families.empty() ? "not Arnoux-Rauzy, episturmian or dendric"
                                                   : joined(families, ", ")) +
                                     std::string(": proved"));
    }
    if (report.rich)
        page += line("rich", *report.rich ? "yes: proved"
                             : report.poor_beginning
                                 ? fmt::format("no: the first {} letters have a defect",
                                               *report.poor_beginning)
                                 : "no: proved");
    if (report.columns)
        page += line("constant length",
                     fmt::format("height {}, column number {}{}", report.columns->height,
                                 report.columns->column_number,
                                 report.columns->toeplitz ? "; a Toeplitz word" : ""));
    if (report.pure_point)
        page +=
            line("spectrum", *report.pure_point ? "pure point: proved" : "not pure point: proved");
    if (report.derived) page += derived_lines(report);
    return page;
}

/// The value, or null.
template <class Value>
Json if_known(const std::optional<Value>& value) {
    return value ? Json(*value) : Json();
}

Json morphism_json(const FactorValues& report) {
    const MorphismProperties& found = report.morphism;
    const auto word = [&](const Word& one) { return Json(spell(report.morphism_alphabet, one)); };
    Json same;
    if (found.same_image) {
        same = Json::array();
        same.add(word(found.same_image->first));
        same.add(word(found.same_image->second));
    }
    Json letters;
    for (const auto& [kind, all] : letter_kinds(report)) {
        Json names = Json::array();
        for (const Symbol letter : *all) names.add(report.morphism_alphabet.name(letter));
        letters.set(kind, std::move(names));
    }
    return {{"letters", std::move(letters)},
            {"injective", !found.same_image},
            {"same_image", std::move(same)},
            {"prefix_code", found.prefix_code},
            {"suffix_code", found.suffix_code},
            {"constant_length", found.shortest == found.longest ? Json(found.longest) : Json()},
            {"left_marked", found.left_marked},
            {"right_marked", found.right_marked},
            {"conjugates", found.conjugates},
            {"cyclic", found.cyclic},
            {"class_p", found.class_p},
            {"conjugate_of_class_p", found.conjugate_of_class_p},
            {"automorphism", found.automorphism},
            {"sturmian", found.sturmian},
            {"square_free", if_known(found.square_free)},
            {"makes_square", found.makes_square ? word(*found.makes_square) : Json()},
            {"overlap_free", if_known(found.overlap_free)},
            {"characteristic_polynomial", to_string(found.characteristic)},
            {"irreducible", found.irreducible},
            {"determinant", found.determinant},
            {"pisot", found.pisot},
            {"salem", found.salem}};
}

Json families_json(const std::optional<ComplexityForAll>& found) {
    if (!found) return {};
    return {{"sturmian", found->arnoux_rauzy && found->letters == 2},
            {"arnoux_rauzy", found->arnoux_rauzy},
            {"episturmian", found->episturmian},
            {"dendric", found->dendric}};
}

Json derived_json(const FactorValues& report) {
    if (!report.derived) return {};
    Json letters = Json::array(), words = Json::array();
    for (const Symbol letter : report.derived->letters) letters.add(report.alphabet.name(letter));
    for (const DerivedWord& one : report.derived->words) {
        Json images = Json::array(), returns = Json::array();
        for (const Word& image : one.h.images()) images.add(image);
        for (const Word& word : one.returns) returns.add(word);
        words.add(Json{{"images", std::move(images)}, {"returns", std::move(returns)}});
    }
    return {{"letters", std::move(letters)},
            {"before", report.derived->before},
            {"words", std::move(words)}};
}

Json columns_json(const std::optional<ConstantLength>& found) {
    if (!found) return {};
    return {{"length", found->length},
            {"height", found->height},
            {"column_number", found->column_number},
            {"toeplitz", found->toeplitz}};
}

}  // namespace

std::string to_text(const FactorValues& report) {
    const auto values = [](const std::vector<std::uint64_t>& all) {
        return joined(all, ", ", number);
    };
    const auto [factors, palindromes] = proofs_of(report);
    const ComplexityForAll* for_all = report.for_all ? &*report.for_all : nullptr;
    std::string page =
        line("factors of", std::string(report.infinite_word ? "the infinite word of the system"
                                                            : "all words of the system") +
                               (report.coded ? ", after the coding" : "")) +
        line("of 0, 1, ... letters",
             fmt::format("up to {}{}", report.to,
                         factors || for_all ? "" : "; nothing is said of longer ones"));
    page += line("factor complexity", values(report.factors)) + for_all_line(factors, for_all);
    page += line("palindromic complexity", values(report.palindromes)) +
            for_all_line(palindromes, nullptr);
    page += line("Abelian complexity", values(report.abelian));
    page += line("imbalance", values(report.imbalance));
    page +=
        line("closed under reversal",
             report.not_reversed ? "no: " + spell(report.alphabet, *report.not_reversed) +
                                       " is a factor, its reversal is not"
             : report.closed_under_reversal == true ? "yes: proved"
                                                    : fmt::format("up to {} letters", report.to));
    page += line("primitive morphism",
                 report.primitivity.exponent
                     ? fmt::format("yes, its power {} has all letters in all images",
                                   *report.primitivity.exponent)
                     : "no");
    page += morphism_lines(report);
    if (report.circular) page += line("circular", *report.circular ? "yes" : "no");
    page += exponent_lines(report);
    page += word_lines(report);
    std::string frequencies;
    for (const auto& [name, a] : by_name(report.alphabet))
        if (report.frequencies[a])
            frequencies += (frequencies.empty() ? "" : "; ") + name + ": " +
                           exact_and_decimal(*report.frequencies[a]);
    if (!frequencies.empty()) page += line("frequencies", frequencies);
    if (report.rate.degree() > 2)
        page += line("  where r =", report.rate.exact() + " = " + report.rate.decimal(7));
    for (const auto& [letter, words] : report.recurrence.return_words)
        page += line("returns to " + letter,
                     some_of(words, ", ", [](const auto& word) { return joined_letters(word); }));
    if (report.recurrence.values.size() > 1)
        page += line("recurrence function", joined(report.recurrence.values, ", ", number));
    if (!report.bispecial.empty())
        page += line("bispecial factors",
                     some_of(report.bispecial, ", ", [&](const FactorValues::Bispecial& one) {
                         return (one.word.empty() ? "empty" : spell(report.alphabet, one.word)) +
                                fmt::format(" ({:+})", one.multiplicity);
                     }));
    if (!report.not_proved.empty()) page += line("not for all n", report.not_proved);
    return page;
}

std::string to_latex(const FactorValues& report) {
    const auto [factors, palindromes] = proofs_of(report);
    std::string text = report.infinite_word ? "Factors of the infinite word"
                                            : "Factors of all words of the system";
    text +=
        std::string(report.coded ? ", after the coding" : "") +
        ": of $n$ letters there are $p(n)$, among them $P(n)$ palindromes, with $a(n)$ different "
        "numbers of letters, which differ by $b(n)$ at most.\n";
    text += "\\[\n\\begin{array}{r|rrrr}\n  n & p(n) & P(n) & a(n) & b(n) \\\\ \\hline\n";
    for (std::size_t n = 0; n < report.factors.size(); ++n)
        text += fmt::format("  {} & {} & {} & {} & {} \\\\\n", n, report.factors[n],
                            report.palindromes[n], report.abelian[n], report.imbalance[n]);
    text += "\\end{array}\n\\]\n";
    const auto equation = [](const std::string& left, const std::string& right) {
        return "\\[ " + left + " = " + right + " \\]\n";
    };
    const auto linear = [&](const char* name, const Integer& slope, const Integer& constant,
                            const Integer& from) {
        text += equation(name, formula_latex(linear_text(slope, constant)) + " \\quad (n \\ge " +
                                   to_string(from) + ")");
    };
    if (report.for_all) {
        if (const auto found = report.for_all->linear())
            linear("p(n)", found->slope, found->constant, found->from);
        else
            text += escaped_latex(second_differences(*report.for_all)) + ".\n";
    } else if (factors && factors->linear) {
        linear("p(n)", factors->linear->slope, factors->linear->constant, factors->linear->from);
    }
    if (palindromes && palindromes->linear)
        linear("P(n)", palindromes->linear->slope, palindromes->linear->constant,
               palindromes->linear->from);
    const auto value = [](const Frequency& exact) {
        const std::string decimal = exact.decimal(digits_shown);
        return formula_latex(exact.exact()) +
               (exact.number() && exact.number()->numerator.degree() <= 0
                    ? ""
                    : " = " + decimal + "\\dots");
    };
    if (report.exponent) {
        const CriticalExponent& found = *report.exponent;
        text += "The critical exponent is " +
                (found.infinite ? std::string("infinite")
                                : "$" + value(*found.value) + "$" +
                                      (found.attained ? "" : ", which no factor reaches")) +
                ".\n";
    }
    if (report.for_all)
        if (const auto families = families_of(*report.for_all); !families.empty())
            text += "The word is " + joined(families, " and ") + ".\n";
    for (const auto& [name, a] : by_name(report.alphabet))
        if (report.frequencies[a])
            text += "The letter $" + word_latex(report.alphabet, {static_cast<Symbol>(a)}) +
                    "$ has the frequency $" + value(*report.frequencies[a]) + "$.\n";
    if (report.rate.degree() > 2)
        text += "Here $r$ is $" + formula_latex(report.rate.exact()) + " = " +
                report.rate.decimal(digits_shown + 1) + "\\dots$.\n";
    return text;
}

Json to_json(const FactorValues& report) {
    const auto [factors, palindromes] = proofs_of(report);
    const ComplexityForAll* for_all = report.for_all ? &*report.for_all : nullptr;
    const auto values = [](const std::vector<std::uint64_t>& all,
                           const ComplexityProof* proof = nullptr,
                           const ComplexityForAll* chains = nullptr) {
        const auto formula = formula_of(proof, chains);
        return Json{{"values", all},
                    {"formula", formula ? Json(formula->first) : Json()},
                    {"from", formula ? Json(formula->second) : Json()},
                    {"proved_for_all", formula.has_value()},
                    {"differences",
                     proof && !proof->differences.empty() ? Json(proof->differences) : Json()}};
    };
    Json frequencies, apart, returns;
    for (const auto& [name, a] : by_name(report.alphabet)) {
        if (report.frequencies[a]) frequencies.set(name, to_json(*report.frequencies[a]));
        if (report.frequencies[a] || report.apart[a] > 0) apart.set(name, Json(report.apart[a]));
    }
    for (const auto& [letter, words] : report.recurrence.return_words) {
        Json all = Json::array();
        for (const auto& word : words) all.add(joined_letters(word));
        returns.set(letter, std::move(all));
    }
    Json bispecial = Json::array();
    for (const auto& [word, multiplicity] : report.bispecial)
        bispecial.add(Json{{"word", spell(report.alphabet, word)}, {"multiplicity", multiplicity}});
    std::optional<bool> reversal = report.closed_under_reversal;
    if (report.not_reversed) reversal = false;
    return {{"language", report.infinite_word ? "infinite word" : "all words"},
            {"coded", report.coded},
            {"to", report.to},
            {"factor_complexity", values(report.factors, factors, for_all)},
            {"second_differences", for_all ? to_json(*for_all) : Json()},
            {"palindromic_complexity", values(report.palindromes, palindromes)},
            {"not_proved", report.not_proved.empty() ? Json() : Json(report.not_proved)},
            {"abelian_complexity", values(report.abelian)},
            {"imbalance_values", report.imbalance},
            {"imbalance", std::move(apart)},
            {"critical_exponent", exponent_of(report)},
            {"return_words", std::move(returns)},
            {"recurrence_function", Json{{"values", report.recurrence.values}}},
            {"bispecial", std::move(bispecial)},
            {"frequencies", std::move(frequencies)},
            {"rate", Json{{"minimal_polynomial", to_string(report.rate.minimal_polynomial(), "r")},
                          {"decimal", report.rate.decimal(digits_in_json)}}},
            {"primitive", report.primitivity.exponent.has_value()},
            {"least_positive_power", if_known(report.primitivity.exponent)},
            {"morphism", morphism_json(report)},
            {"circular", if_known(report.circular)},
            {"families", families_json(report.for_all)},
            {"rich", if_known(report.rich)},
            {"poor_beginning", if_known(report.poor_beginning)},
            {"derived_words", derived_json(report)},
            {"constant_length", columns_json(report.columns)},
            {"pure_point_spectrum", if_known(report.pure_point)},
            {"closed_under_reversal", if_known(reversal)},
            {"not_reversed",
             report.not_reversed ? Json(spell(report.alphabet, *report.not_reversed)) : Json()}};
}

}  // namespace algae
