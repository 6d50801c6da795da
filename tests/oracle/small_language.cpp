#include "oracle/small_language.hpp"

#include <algorithm>
#include <bitset>
#include <stdexcept>

#include "oracle/written_out.hpp"

// Systems without context. What letters derive by a sequence of tables is one of finitely many families of short words, of relations
// of states, or of lengths; the sequence made one step longer at its front gives the next family, so all are found when no new one
// comes. That is exact, with erasing rules too.
//
// That the language is infinite: by some tables a letter x becomes a word with x and another letter y, of which something is left by
// these tables however often they are used (Rozenberg and Salomaa 1980, The mathematical theory of L systems, I.4 for 0L systems); in an
// extended system, where what then stands in the word becomes terminals by the same tables. Letters choose the same rule in one step, which
// are some of the derivations.
//
// Systems with context. The words are written out; words become no shorter where nothing is erased. A set of factors of five letters is
// closed if all words that have only such factors have successors with only such factors: it has all words of the language. If each
// word that it allows has a successor that is longer and allowed, the language is infinite.

namespace algae::oracle {

namespace {

constexpr std::size_t short_length = 5;  // of words whose absence is known
constexpr std::size_t most_families = 3000;

using Bits =
    std::uint64_t;  // words of at most five letters, by 1 and their letters as binary digits

Bits product(Bits left, Bits right) {
    Bits made = 0;
    for (unsigned i = 1; i < 64; ++i) {
        if (!(left >> i & 1)) continue;
        for (unsigned j = 1; j < 64; ++j) {
            if (!(right >> j & 1)) continue;
            unsigned length = 0;
            while (j >> (length + 1)) ++length;
            const unsigned both = i << length | (j ^ 1U << length);
            if (both < 64) made |= Bits{1} << both;
        }
    }
    return made;
}

std::string word_of(unsigned number) {
    std::string word;
    for (; number > 1; number /= 2) word.insert(word.begin(), number % 2 == 0 ? 'a' : 'b');
    return word;
}

/// Five places as digits in base 3; # stands before and behind a word.
std::string factor_of(std::size_t number) {
    std::string factor;
    for (int i = 0; i < 5; ++i, number /= 3) factor.insert(factor.begin(), "ab#"[number % 3]);
    return factor;
}

std::uint64_t times(std::uint64_t left, std::uint64_t right) {
    std::uint64_t made = 0;
    for (unsigned i = 0; i < 8; ++i)
        for (unsigned j = 0; j < 8; ++j)
            if (left >> (8 * i + j) & 1) made |= (right >> (8 * j) & 255) << (8 * i);
    return made;
}

std::uint64_t turned(std::uint64_t relation) {
    std::uint64_t made = 0;
    for (unsigned i = 0; i < 8; ++i)
        for (unsigned j = 0; j < 8; ++j)
            if (relation >> (8 * i + j) & 1) made |= std::uint64_t{1} << (8 * j + i);
    return made;
}

std::string shown(const std::string& word) { return word.empty() ? "ε" : word; }

std::string rules(const std::string& left, const std::vector<std::string>& words) {
    std::string made;
    for (const std::string& word : words) made += "; " + left + " -> " + shown(word);
    return made;
}

/// An expression as it is read: the positions of its letters, and which come first, last and behind one another.
class Positions {
public:
    explicit Positions(const std::string& written) : text_(written) {
        const Part whole = choice();
        if (at_ != text_.size()) throw std::logic_error("no expression: " + text_);
        SmallExpression& made = made_;
        made.text = written;
        made.steps = {{'a', 0}, {'b', 0}};
        made.final = whole.last | (whole.empty ? 1 : 0);
        enter(0, whole.first);
        for (unsigned i = 1; i < next_.size(); ++i) enter(i, next_[i]);
    }
    SmallExpression made() const { return made_; }

private:
    struct Part {
        std::uint64_t first = 0, last = 0;
        bool empty = false;
    };

    void enter(unsigned from, std::uint64_t to) {
        for (unsigned j = 1; j < letter_.size(); ++j)
            if (to >> j & 1) made_.steps[letter_[j]] |= std::uint64_t{1} << (8 * from + j);
    }
    void join(const Part& left, std::uint64_t first) {
        for (unsigned i = 1; i < next_.size(); ++i)
            if (left.last >> i & 1) next_[i] |= first;
    }
    Part choice() {
        Part all = chain();
        while (at_ < text_.size() && text_[at_] == '|') {
            ++at_;
            const Part other = chain();
            all = {all.first | other.first, all.last | other.last, all.empty || other.empty};
        }
        return all;
    }
    Part chain() {
        Part all{0, 0, true};
        while (at_ < text_.size() && text_[at_] != '|' && text_[at_] != ')') {
            const Part next = repeated();
            join(all, next.first);
            all = {all.first | (all.empty ? next.first : 0),
                   next.last | (next.empty ? all.last : 0), all.empty && next.empty};
        }
        return all;
    }
    Part repeated() {
        Part part = single();
        for (; at_ < text_.size() && std::string("*+?").find(text_[at_]) != std::string::npos;
             ++at_) {
            if (text_[at_] != '?') join(part, part.first);
            if (text_[at_] != '+') part.empty = true;
        }
        return part;
    }
    Part single() {
        if (text_.compare(at_, 2, "ε") == 0) {
            at_ += 2;
            return {0, 0, true};
        }
        if (text_[at_] == '(') {
            ++at_;
            const Part inside = choice();
            ++at_;
            return inside;
        }
        letter_ += text_[at_++];
        next_.push_back(0);
        if (next_.size() > 8) throw std::logic_error("more than seven letters: " + text_);
        const std::uint64_t bit = std::uint64_t{1} << (next_.size() - 1);
        return {bit, bit, false};
    }

    std::string text_;
    std::size_t at_ = 0;
    std::string letter_ = "-";  // by position; 0 is the start
    std::vector<std::uint64_t> next_{0};
    SmallExpression made_;
};

}  // namespace

const std::vector<std::string>& SmallSystem::successors(std::size_t table, const std::string& word,
                                                        std::size_t i) const {
    const InContext* best = nullptr;
    const auto seen = [](const InContext& rule) { return rule.left.size() + rule.right.size(); };
    for (const InContext& rule : in_context) {
        const std::size_t before = rule.left.size();
        if (rule.letter == word[i] && before <= i &&
            word.compare(i - before, before, rule.left) == 0 &&
            word.compare(i + 1, rule.right.size(), rule.right) == 0 &&
            (!best || seen(rule) > seen(*best)))
            best = &rule;
    }
    return best ? best->successors : tables[table].at(word[i]);
}

bool SmallSystem::erases() const {
    const auto has_empty = [](const std::vector<std::string>& words) {
        return std::find(words.begin(), words.end(), "") != words.end();
    };
    for (const auto& table : tables)
        for (const auto& [letter, words] : table)
            if (has_empty(words)) return true;
    return std::any_of(in_context.begin(), in_context.end(),
                       [&](const InContext& rule) { return has_empty(rule.successors); });
}

std::string SmallSystem::text() const {
    std::string made = family + " { axiom " + axiom;
    if (is('E')) made += "; terminals a b";
    for (std::size_t t = 0; t < tables.size(); ++t) {
        if (is('T')) made += "; table t" + std::to_string(t);
        for (const auto& [letter, words] : tables[t]) made += rules({letter}, words);
    }
    for (const auto& [left, letter, right, words] : in_context)
        made += rules(
            (left.empty() ? "" : left + " < ") + letter + (right.empty() ? "" : " > " + right),
            words);
    return made + " }";
}

Relation identity() {
    std::uint64_t made = 0;
    for (unsigned i = 0; i < 8; ++i) made |= std::uint64_t{1} << (9 * i);
    return {made, made};
}
Relation followed_by(const Relation& first, const Relation& second) {
    return {times(first[0], second[0]), times(first[1], second[1])};
}
Relation transposed(const Relation& relation) { return {turned(relation[0]), turned(relation[1])}; }

bool SmallExpression::accepts(const std::string& word) const {
    std::uint64_t all = identity()[0];
    for (const char letter : word) all = times(all, steps.at(letter));
    return accepts(all);
}

SmallExpression small_expression(const std::string& written) { return Positions(written).made(); }

SmallLanguage::SmallLanguage(SmallSystem system)
    : system_(std::move(system)), letters_(system_.is('E') ? "abS" : "ab") {
    if (system_.axiom.empty()) throw std::logic_error("the axiom is empty");
    if (!system_.has_context()) exhaust_short();
    write_out();
}

void SmallLanguage::write_out() {
    const auto follow = [&](std::size_t kept, std::size_t most) {
        std::set<std::string> all{system_.axiom};
        std::vector<std::string> open{system_.axiom};
        bool cut = false, full = false;
        for (std::size_t next = 0; next < open.size() && !full; ++next) {
            const std::string word = open[next];
            for (std::size_t table = 0; table < system_.tables.size() && !full; ++table)
                for (const std::string& each : ::oracle::next_words(
                         word, kept,
                         [&](std::size_t i) -> const auto& {
                             return system_.successors(table, word, i);
                         },
                         cut)) {
                    if (all.contains(each)) continue;
                    if (all.size() == most) {
                        full = true;
                        break;
                    }
                    all.insert(each);
                    open.push_back(each);
                }
        }
        for (const std::string& word : all) {
            accessible_.insert(word.begin(), word.end());
            if (!system_.is('E') || word.find('S') == std::string::npos) words_.insert(word);
        }
        if (!cut && !full) whole_ = true;
        if (!full && !system_.erases()) complete_ = std::max(complete_, kept + 1);
    };
    if (system_.has_context()) follow(short_length + 1, most_families);
    if (!whole_) follow(9, 400);
}

void SmallLanguage::exhaust_short() {
    using Family = std::vector<Bits>;
    const auto place = [&](char letter) { return letters_.find(letter); };
    const auto of_word = [&](const Family& family, const std::string& word) {
        Bits all = 2;  // the empty word
        for (const char letter : word) all = product(all, family[place(letter)]);
        return all;
    };
    Family first{Bits{1} << 2, Bits{1} << 3, 0};
    first.resize(letters_.size());
    std::set<Family> seen{first};
    std::vector<Family> open{first};
    Bits found = 0;
    while (!open.empty() && seen.size() < most_families) {
        const Family family = open.back();
        open.pop_back();
        found |= of_word(family, system_.axiom);
        for (const auto& table : system_.tables) {
            Family longer(letters_.size());
            for (const auto& [letter, words] : table)
                for (const std::string& word : words)
                    longer[place(letter)] |= of_word(family, word);
            if (seen.insert(longer).second) open.push_back(longer);
        }
    }
    for (unsigned i = 1; i < 64; ++i)
        if (found >> i & 1) words_.insert(word_of(i));
    if (open.empty()) complete_ = short_length + 1;
}

std::optional<bool> SmallLanguage::has(const std::string& word) const {
    if (words_.contains(word)) return true;
    if (whole_ || word.size() < complete_) return false;
    if (!system_.has_context()) return std::nullopt;
    const Factors& allowed = all_factors();
    if (word.empty()) return allowed.empty_word ? std::nullopt : std::optional(false);
    std::size_t number = 0;
    const std::string padded = "##" + word + "##";
    for (std::size_t i = 0; i < padded.size(); ++i) {
        number = (number * 3 + (padded[i] == 'a' ? 0 : padded[i] == 'b' ? 1 : 2)) % 243;
        if (i >= 4 && !allowed.seen[number]) return false;
    }
    return std::nullopt;
}

Relations SmallLanguage::relations(const std::map<char, Relation>& letters) const {
    Relations made;
    for (const std::string& word : words_) {
        Relation relation = identity();
        for (const char letter : word) relation = followed_by(relation, letters.at(letter));
        made.some.insert(relation);
    }
    if (whole_) {
        made.all = made.some;
    } else if (system_.has_context()) {
        const Factors& allowed = all_factors();
        if (allowed.empty_word) made.all.insert(identity());
        std::set<std::pair<std::size_t, Relation>> seen;
        std::vector<std::pair<std::size_t, Relation>> open;
        const auto enter = [&](std::size_t number, const Relation& before) {
            if (!allowed.seen[number]) return;
            const Relation now = followed_by(before, letters.at(number / 9 % 3 == 0 ? 'a' : 'b'));
            if (seen.emplace(number, now).second) open.emplace_back(number, now);
        };
        for (std::size_t number = 216; number < 243; ++number) enter(number, identity());
        while (!open.empty()) {
            const auto [number, relation] = open.back();
            open.pop_back();
            if (number % 9 == 8) made.all.insert(relation);
            for (std::size_t next = 0; next < 3; ++next) enter((number * 3 + next) % 243, relation);
        }
    } else {
        bool complete = false;
        std::set<Relation> exact = context_free_relations(letters, complete);
        if (complete) made.some = exact;
        made.all = std::move(exact);
    }
    return made;
}

/// All of them if `complete`, otherwise all that products of letters have.
std::set<Relation> SmallLanguage::context_free_relations(const std::map<char, Relation>& letters,
                                                         bool& complete) const {
    constexpr std::size_t most = 256;
    std::vector<Relation> all{identity()};
    std::map<Relation, std::size_t> numbers{{identity(), 0}};
    for (std::size_t i = 0; i < all.size(); ++i)
        for (const auto& [letter, relation] : letters) {
            const Relation next = followed_by(all[i], relation);
            if (numbers.emplace(next, all.size()).second) all.push_back(next);
            if (all.size() > 5000) throw std::logic_error("too many relations");
        }
    complete = false;
    if (all.size() > most) return {all.begin(), all.end()};
    std::vector<std::vector<std::size_t>> table(all.size(), std::vector<std::size_t>(all.size()));
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t j = 0; j < all.size(); ++j)
            table[i][j] = numbers.at(followed_by(all[i], all[j]));
    using Set = std::bitset<most>;
    struct Less {
        bool operator()(const std::vector<Set>& left, const std::vector<Set>& right) const {
            return std::lexicographical_compare(left.begin(), left.end(), right.begin(),
                                                right.end(),
                                                [](const Set& x, const Set& y) -> bool {
                                                    for (std::size_t i = 0; i < most; ++i)
                                                        if (x[i] != y[i]) return y[i];
                                                    return false;
                                                });
        }
    };
    std::size_t work = 0;
    const auto of_word = [&](const std::vector<Set>& family, const std::string& word) {
        Set made;
        made.set(0);
        for (const char letter : word) {
            const Set& next = family[letters_.find(letter)];
            Set longer;
            for (std::size_t i = 0; i < all.size(); ++i)
                if (made[i])
                    for (std::size_t j = 0; j < all.size(); ++j)
                        if (next[j]) longer.set(table[i][j]);
            work += made.count() * all.size();
            made = longer;
        }
        return made;
    };
    std::vector<Set> first(letters_.size());
    first[0].set(numbers.at(letters.at('a')));
    first[1].set(numbers.at(letters.at('b')));
    std::set<std::vector<Set>, Less> seen{first};
    std::vector<std::vector<Set>> open{first};
    Set found;
    while (!open.empty()) {
        if (seen.size() > most_families || work > 2'000'000) return {all.begin(), all.end()};
        const std::vector<Set> family = open.back();
        open.pop_back();
        found |= of_word(family, system_.axiom);
        for (const auto& rules : system_.tables) {
            std::vector<Set> longer(letters_.size());
            for (const auto& [letter, words] : rules)
                for (const std::string& word : words)
                    longer[letters_.find(letter)] |= of_word(family, word);
            if (seen.insert(longer).second) open.push_back(longer);
        }
    }
    complete = true;
    std::set<Relation> made;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (found[i]) made.insert(all[i]);
    return made;
}

std::optional<std::set<std::string>> SmallLanguage::all_words() const {
    if (whole_) return words_;
    if (system_.has_context() || complete_ == 0) return std::nullopt;
    std::vector<Lengths> all;
    if (!exhaust_lengths(all)) return std::nullopt;
    for (const Lengths& lengths : all) {
        int length = 0;
        for (const char letter : system_.axiom) {
            const int one = lengths[letters_.find(letter)];
            length = one < 0 || length < 0 ? -1 : length + one;
        }
        if (length >= static_cast<int>(complete_)) return std::nullopt;
    }
    return words_;
}

/// By sequences of tables the lengths of longest terminal words of the letters: whether these are all.
bool SmallLanguage::exhaust_lengths(std::vector<Lengths>& all) const {
    Lengths first{1, 1, -1};
    first.resize(letters_.size());
    std::set<Lengths> seen{first};
    all = {first};
    for (std::size_t next = 0; next < all.size(); ++next) {
        const Lengths lengths = all[next];
        for (const auto& table : system_.tables) {
            Lengths longer(letters_.size(), -1);
            for (const auto& [letter, words] : table)
                for (const std::string& word : words) {
                    int length = 0;
                    for (const char each : word) {
                        const int one = lengths[letters_.find(each)];
                        length = one < 0 || length < 0 ? -1 : length + one;
                    }
                    if (length > 1000) return false;
                    int& longest = longer[letters_.find(letter)];
                    longest = std::max(longest, length);
                }
            if (!seen.insert(longer).second) continue;
            if (all.size() == 400) return false;
            all.push_back(longer);
        }
    }
    return true;
}

/// Whether lengths have no bound, as some tables make x a word with x and y, and y words that are never empty. `letters` are some
/// whose rules look at no context and lead to no other letters.
bool SmallLanguage::repeats(const std::string& letters, const std::set<char>& accessible) const {
    const std::size_t n = letters.size();
    using Matrix = std::vector<int>;  // how often x becomes y: 0, 1 or more
    std::vector<Matrix> steps;
    for (const auto& table : system_.tables) {
        std::vector<Matrix> chosen{Matrix(n * n)};
        for (std::size_t x = 0; x < n; ++x) {
            std::vector<Matrix> more;
            for (const Matrix& begun : chosen)
                for (const std::string& word : table.at(letters[x])) {
                    Matrix next = begun;
                    for (const char letter : word) {
                        int& count = next[x * n + letters.find(letter)];
                        count = std::min(2, count + 1);
                    }
                    more.push_back(std::move(next));
                }
            chosen = std::move(more);
        }
        steps.insert(steps.end(), chosen.begin(), chosen.end());
    }
    const auto after = [&](unsigned set, const Matrix& matrix) {
        unsigned made = 0;
        for (std::size_t x = 0; x < n; ++x)
            for (std::size_t y = 0; y < n; ++y)
                if (set >> x & 1 && matrix[x * n + y] > 0) made |= 1U << y;
        return made;
    };
    // The sets of letters of words. Letters without context stand anywhere, and others need not finish.
    std::set<unsigned> together;
    std::vector<Lengths> finishing{Lengths(n, 1)};
    if (system_.is('E')) {
        exhaust_lengths(finishing);
        unsigned axiom = 0;
        for (const char letter : system_.axiom) axiom |= 1U << letters.find(letter);
        std::vector<unsigned> open{axiom};
        together.insert(axiom);
        while (!open.empty()) {
            const unsigned set = open.back();
            open.pop_back();
            for (const Matrix& step : steps)
                if (together.insert(after(set, step)).second) open.push_back(after(set, step));
        }
    } else {
        for (std::size_t x = 0; x < n; ++x)
            if (accessible.contains(letters[x])) together.insert(1U << x);
    }
    const auto leaves_words = [&](const Matrix& matrix, unsigned set, std::size_t y) {
        unsigned rest = 1U << y;
        for (int i = 0; i < 16; ++i) set = after(set, matrix), rest = after(rest, matrix);
        std::set<unsigned> rests;  // on the cycle
        for (int i = 0; i < 8; ++i) rests.insert(rest), rest = after(rest, matrix);
        for (int i = 0; i < 8; ++i, set = after(set, matrix))
            for (const Lengths& lengths : finishing) {
                bool finishes = true;
                for (std::size_t x = 0; x < n; ++x)
                    finishes = finishes && !(set >> x & 1 && lengths[x] < 0);
                for (const unsigned each : rests) {
                    bool is_word = false;
                    for (std::size_t x = 0; x < n; ++x)
                        is_word = is_word || (each >> x & 1 && lengths[x] > 0);
                    finishes = finishes && is_word;
                }
                if (finishes) return true;
            }
        return false;
    };
    std::set<Matrix> seen(steps.begin(), steps.end());
    std::vector<Matrix> open(seen.begin(), seen.end());
    for (std::size_t next = 0; next < open.size() && next < 2000; ++next) {
        const Matrix matrix = open[next];
        for (std::size_t x = 0; x < n; ++x)
            for (std::size_t y = 0; y < n; ++y)
                if (matrix[x * n + x] > 0 && matrix[x * n + y] > (x == y ? 1 : 0))
                    for (const unsigned set : together)
                        if (set >> x & 1 && leaves_words(matrix, set, y)) return true;
        for (const Matrix& step : steps) {
            Matrix longer(n * n);
            for (std::size_t x = 0; x < n; ++x)
                for (std::size_t y = 0; y < n; ++y)
                    for (std::size_t z = 0; z < n; ++z)
                        longer[x * n + z] =
                            std::min(2, longer[x * n + z] + matrix[x * n + y] * step[y * n + z]);
            if (seen.insert(longer).second) open.push_back(std::move(longer));
        }
    }
    return false;
}

/// Closed under the rules, or under those that take the longest of several successors.
SmallLanguage::Factors SmallLanguage::factors(const std::string& from, bool longest_only) const {
    Factors made;
    std::vector<std::vector<std::string>> successors(243);  // of the letter in the middle
    for (std::size_t number = 0; number < 243; ++number) {
        const std::string factor = factor_of(number);
        if (factor[2] == '#') continue;
        successors[number] = system_.successors(0, factor, 2);
        if (longest_only)
            successors[number] = {*std::max_element(
                successors[number].begin(), successors[number].end(),
                [](const auto& x, const auto& y) { return x.size() < y.size(); })};
    }
    bool changed = true;
    const auto write = [&](std::size_t before, const std::string& word) {
        std::size_t number = before;  // the last four places
        for (const char letter : word) {
            number = number % 81 * 3 + (letter == 'a' ? 0 : letter == 'b' ? 1 : 2);
            if (number / 9 % 3 != 2 && !made.seen[number]) made.seen[number] = changed = true;
        }
        return number % 81;
    };
    constexpr std::size_t nothing = 80;  // ####
    if (from.empty()) made.empty_word = true;
    write(nothing, from + "##");
    while (changed) {
        changed = false;
        // From which factors a word can end.
        std::vector<bool> ends(243);
        for (bool more = true; more;) {
            more = false;
            for (std::size_t number = 0; number < 243; ++number) {
                if (!made.seen[number] || ends[number]) continue;
                bool can = number % 9 == 8;
                for (std::size_t next = 0; next < 3; ++next)
                    can = can || ends[(number * 3 + next) % 243];
                if (can) ends[number] = more = true;
            }
        }
        std::vector<bool> seen(243 * 81);
        std::vector<std::pair<std::size_t, std::size_t>> open;
        const auto enter = [&](std::size_t number, std::size_t before) {
            if (!ends[number] || seen[number * 81 + before]) return;
            seen[number * 81 + before] = true;
            open.emplace_back(number, before);
        };
        for (std::size_t number = 216; number < 243; ++number) enter(number, nothing);
        while (!open.empty()) {
            const auto [number, before] = open.back();
            open.pop_back();
            for (const std::string& successor : successors[number]) {
                const std::size_t last = write(before, successor);
                if (number % 9 == 8) {
                    if (last == nothing && !made.empty_word) made.empty_word = changed = true;
                    write(last, "##");
                }
                for (std::size_t next = 0; next < 3; ++next) enter((number * 3 + next) % 243, last);
            }
        }
    }
    return made;
}

const SmallLanguage::Factors& SmallLanguage::all_factors() const {
    if (!factors_) factors_ = factors(system_.axiom, false);
    return *factors_;
}

/// Of each word that a closed set allows a longer one is derived by the longest successors: the least sum of what letters add, over
/// all words, is above 0.
bool SmallLanguage::always_grows() const {
    const auto longest = [&](const std::string& padded, std::size_t i) -> const std::string& {
        const auto& all = system_.successors(0, padded, i);
        return *std::max_element(all.begin(), all.end(),
                                 [](const auto& x, const auto& y) { return x.size() < y.size(); });
    };
    std::string word = system_.axiom;
    for (int steps = 0; steps <= 8; ++steps) {
        if (steps % 4 == 0) {
            const Factors closed = factors(word, true);
            constexpr int far = 1'000'000;
            std::vector<int> least(243, far);
            const auto adds = [&](std::size_t number) {
                return static_cast<int>(longest(factor_of(number), 2).size()) - 1;
            };
            for (std::size_t number = 216; number < 243; ++number)
                if (closed.seen[number]) least[number] = adds(number);
            bool changed = true;
            for (int round = 0; round < 250 && changed; ++round) {
                changed = false;
                for (std::size_t number = 0; number < 243; ++number) {
                    if (!closed.seen[number] || least[number] == far) continue;
                    for (std::size_t next = 0; next < 3; ++next) {
                        const std::size_t to = (number * 3 + next) % 243;
                        if (!closed.seen[to]) continue;
                        const int sum = least[number] + adds(to);
                        if (sum < least[to]) least[to] = sum, changed = true;
                    }
                }
            }
            bool grows = !changed && !word.empty();
            for (std::size_t number = 0; number < 243; ++number)
                if (closed.seen[number] && number % 9 == 8) grows = grows && least[number] > 0;
            if (grows) return true;
        }
        std::string next;
        for (std::size_t i = 0; i < word.size(); ++i) next += longest(word, i);
        if (next.size() > 100) break;
        word = next;
    }
    return false;
}

std::optional<bool> SmallLanguage::finite() const {
    if (finite_) return *finite_;
    const auto found = [&]() -> std::optional<bool> {
        if (whole_) return true;
        if (!system_.has_context()) {
            std::vector<Lengths> all;
            if (exhaust_lengths(all)) return true;
            if (repeats(letters_, accessible_)) return false;
            return std::nullopt;
        }
        std::string free = letters_;
        for (const auto& rule : system_.in_context)
            free.erase(std::remove(free.begin(), free.end(), rule.letter), free.end());
        for (std::size_t before = 3; before != free.size();) {
            before = free.size();
            for (const char letter : std::string(free))
                for (const std::string& word : system_.tables[0].at(letter))
                    if (word.find_first_not_of(free) != std::string::npos)
                        free.erase(std::remove(free.begin(), free.end(), letter), free.end());
        }
        if (!free.empty() && repeats(free, accessible_)) return false;
        if (always_grows()) return false;
        return std::nullopt;
    };
    finite_ = found();
    return *finite_;
}

std::vector<std::string> SmallLanguage::sequence(std::size_t generations) const {
    std::vector<std::string> made{system_.axiom};
    while (made.size() < generations) {
        std::string next;
        for (std::size_t i = 0; i < made.back().size(); ++i)
            next += system_.successors(0, made.back(), i).front();
        made.push_back(std::move(next));
    }
    return made;
}

}  // namespace algae::oracle
