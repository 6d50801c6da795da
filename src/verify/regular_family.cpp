#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "exact/exact.hpp"
#include "verify/detail/checking.hpp"
#include "verify/detail/languages.hpp"
#include "verify/verify.hpp"

// That an infinite language is not 0L, T0L, or of their propagating and deterministic forms.
//
// Of a regular language the minimal automaton is worked out. Two words that are not empty are of one class if they do the same to
// its states; the empty word is a class of its own. A map says of which classes the successors of each letter may be. The proof by
// `classes` is a tree of cases that begins with all classes: a word of the language and one word of each class by which its
// letters leave the language, so that one of these pairs of a letter and a class is not used by the system, or by the table. A case
// ends where a letter has no class left, or where two words of the language have no ancestor in common: no word of the language
// derives both. With tables, of which each may use another map, the two words have none by any of the maps that are left.
//
// Over one letter a system makes of a word of x letters those of all sums of x lengths of successors. The proof by `lengths` shows that tables which
// stay within the lengths of the language do not make some of them; it is a tree of cases again, in which sums that lead out of the
// lengths take numbers from the tables. The theorem is in regular_family.cpp of the room language.
//
// The other kinds are theorems about deterministic systems and about languages with few words, whose conditions are checked.

namespace algae::verify {

namespace {

constexpr std::size_t most_words = 10'000;  // ancestors, and classes

bool is_one_of(const std::string& family, std::initializer_list<const char*> families) {
    return std::count(families.begin(), families.end(), family) > 0;
}

void must_be_one_of(const Obligation& task, std::initializer_list<const char*> families) {
    if (!is_one_of(task.statement.family, families))
        task.refuse("this shows nothing of " + task.statement.family);
}

/// The minimal automaton of a regular language.
struct Acceptor {
    std::vector<char> accepting,
        useful;  // by state; state 0 is the first. Useful: a word is accepted from it
    std::vector<std::vector<std::size_t>> next;  // by state and symbol
    std::vector<Symbol> letters;                 // of words of the language

    std::size_t states() const { return next.size(); }
    std::size_t after(std::size_t state, const Word& word) const {
        for (const Symbol a : word) state = next[state][a];
        return state;
    }
    bool accepts(const Word& word) const { return accepting[after(0, word)] != 0; }
};

/// States of one block are not told apart by the blocks that letters lead to.
Acceptor acceptor(const Obligation& task) {
    check_regular(task, task.language());
    Derivatives derivatives(task.alphabet(), task.budget);
    const Derivatives::Automaton all = derivatives.automaton(derivatives.term(task.language()));
    const std::size_t symbols = task.alphabet().size();
    std::vector<std::size_t> block(all.accepting.begin(), all.accepting.end());
    for (std::size_t before = 0;;) {
        std::map<std::vector<std::size_t>, std::size_t> numbers;
        std::vector<std::size_t> refined;
        for (std::size_t s = 0; s < all.next.size(); ++s) {
            task.budget.check();
            std::vector<std::size_t> key{block[s]};
            for (Symbol a = 0; a < symbols; ++a) key.push_back(block[all.next[s][a]]);
            refined.push_back(numbers.try_emplace(std::move(key), numbers.size()).first->second);
        }
        block = std::move(refined);
        if (numbers.size() == before) break;
        before = numbers.size();
    }
    // State 0 is in block 0, as its key is the first.
    Acceptor found;
    for (std::size_t s = 0; s < all.next.size(); ++s) {
        if (block[s] < found.next.size()) continue;
        found.accepting.push_back(all.accepting[s]);
        auto& next = found.next.emplace_back();
        for (Symbol a = 0; a < symbols; ++a) next.push_back(block[all.next[s][a]]);
    }
    found.useful = found.accepting;
    for (bool grows = true; grows;) {
        grows = false;
        for (std::size_t s = 0; s < found.states(); ++s)
            for (const std::size_t to : found.next[s])
                if (!found.useful[s] && found.useful[to]) found.useful[s] = 1, grows = true;
    }
    std::set<Symbol> letters;
    for (std::size_t s = 0; s < found.states(); ++s)
        for (Symbol a = 0; a < symbols; ++a)
            if (found.useful[s] && found.useful[found.next[s][a]]) letters.insert(a);
    found.letters.assign(letters.begin(), letters.end());
    return found;
}

/// Which useful states are reached from each by one letter or more.
std::vector<std::set<std::size_t>> reached(const Acceptor& automaton) {
    std::vector<std::set<std::size_t>> all(automaton.states());
    for (std::size_t s = 0; s < automaton.states(); ++s) {
        if (!automaton.useful[s]) continue;
        std::vector<std::size_t> open{s};
        while (!open.empty()) {
            const std::size_t at = open.back();
            open.pop_back();
            for (const Symbol a : automaton.letters)
                if (const std::size_t to = automaton.next[at][a];
                    automaton.useful[to] && all[s].insert(to).second)
                    open.push_back(to);
        }
    }
    return all;
}

/// The letters on cycles of useful states: none if the language is finite.
std::set<Symbol> letters_on_cycles(const Acceptor& automaton) {
    const auto all = reached(automaton);
    std::set<Symbol> found;
    for (std::size_t s = 0; s < automaton.states(); ++s)
        for (const Symbol a : automaton.letters)
            if (const std::size_t to = automaton.next[s][a];
                automaton.useful[s] && automaton.useful[to] && (to == s || all[to].contains(s)))
                found.insert(a);
    return found;
}

class ClassCheck {
public:
    /// Of which classes the successors of each letter may be. A class is what it does to the states; nothing for the empty word's.
    using Class = std::optional<std::vector<std::size_t>>;
    using Map = std::map<Symbol, std::set<Class>>;

    ClassCheck(const Obligation& task, bool tables)
        : task_(task), tables_(tables), automaton_(acceptor(task)) {}

    void check() {
        Map whole;
        const std::set<Class> all = classes();
        for (const Symbol a : automaton_.letters) whole[a] = all;
        follow(whole, task_.proof.at("case"));
        if (tables_) must_be_apart(left_, task_.proof.at("apart"));
        if (!tables_ && task_.proof.has("apart"))
            task_.proof.at("apart").refuse(
                "only of tables are words compared for all cases at once");
    }

private:
    Class class_of(const Word& word) const {
        if (word.empty()) return std::nullopt;
        std::vector<std::size_t> action;
        for (std::size_t s = 0; s < automaton_.states(); ++s)
            action.push_back(automaton_.after(s, word));
        return action;
    }

    /// All of them; without that of the empty word where no rule erases.
    std::set<Class> classes() const {
        std::set<Class> all;
        std::vector<Word> open;
        const auto add = [&](const Word& word) {
            task_.budget.check();
            if (all.insert(class_of(word)).second) open.push_back(word);
            if (all.size() > most_words)
                throw BoundReached(Bound::method, "there are too many classes of words");
        };
        for (const Symbol a : automaton_.letters) add({a});
        while (!open.empty()) {
            const Word word = open.back();
            open.pop_back();
            for (const Symbol a : automaton_.letters) {
                Word longer = word;
                longer.push_back(a);
                add(longer);
            }
        }
        if (!task_.statement.family.starts_with('P')) all.insert(std::nullopt);
        return all;
    }

    void follow(const Map& map, const Field& field) {
        task_.budget.check();
        field.only({"word", "images", "cases", "letter", "apart"});
        if (field.has("letter")) {
            const auto found = map.find(task_.reader.letter(field.at("letter")));
            if (found == map.end() || !found->second.empty())
                field.refuse("the letter is not one of the language, or a class is left for it");
            return;
        }
        if (field.has("apart")) {
            if (tables_)
                field.refuse("of tables, words are compared by the maps of all cases at once");
            return must_be_apart({map}, field.at("apart"));
        }
        if (!field.has("word")) {
            if (!tables_) field.refuse("the case ends without a reason");
            left_.push_back(map);
            return;
        }
        const Word word = task_.reader.word(field.at("word"));
        const std::vector<Word> images = task_.reader.words(field.at("images"));
        if (!automaton_.accepts(word)) field.at("word").refuse("the word is not in the language");
        if (images.size() != word.size())
            field.at("images").refuse("there must be one word for each letter");
        Word made;
        std::vector<std::pair<Symbol, Class>> pairs;
        for (std::size_t i = 0; i < word.size(); ++i) {
            const std::pair pair{word[i], class_of(images[i])};
            if (!map.at(pair.first).contains(pair.second))
                field.at("images").refuse("a letter has no successor of that class left");
            made.insert(made.end(), images[i].begin(), images[i].end());
            if (std::find(pairs.begin(), pairs.end(), pair) == pairs.end()) pairs.push_back(pair);
        }
        if (automaton_.accepts(made)) field.at("images").refuse("they make a word of the language");
        const auto cases = field.at("cases").list();
        if (cases.size() != pairs.size())
            field.at("cases").refuse("there must be one for each letter and class of the step");
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            Map without = map;
            without[pairs[i].first].erase(pairs[i].second);
            follow(without, cases[i]);
        }
    }

    void must_be_apart(const std::vector<Map>& maps, const Field& field) const {
        const auto [one, other] = field.pair();
        const std::set<Word> first = ancestors(maps, one), second = ancestors(maps, other);
        for (const Word& word : first)
            if (second.contains(word)) field.refuse("a word may derive both");
    }

    std::set<Word> ancestors(const std::vector<Map>& maps, const Field& field) const {
        const Word word = task_.reader.word(field);
        if (!automaton_.accepts(word)) field.refuse("the word is not in the language");
        std::set<Word> all{word};
        std::vector<Word> open{word};
        while (!open.empty()) {
            const Word at = open.back();
            open.pop_back();
            for (const Map& map : maps)
                for (const Word& before : predecessors(map, at, field)) {
                    if (all.size() > most_words)
                        throw BoundReached(Bound::method, "too many words may derive one");
                    if (all.insert(before).second) open.push_back(before);
                }
        }
        return all;
    }

    /// Where a word of the language may have come so far: a state, and how many letters of the word are made.
    using Place = std::pair<std::size_t, std::set<std::size_t>>;

    /// The words of the language that may become the word in one step.
    std::vector<Word> predecessors(const Map& map, const Word& word, const Field& field) const {
        std::map<Place, std::vector<std::pair<Symbol, Place>>> ways;
        std::vector<Place> open{{0, {0}}};
        ways[open.front()];
        std::map<std::pair<std::size_t, std::size_t>, Class> factors;
        for (std::size_t i = 0; i <= word.size(); ++i)
            for (std::size_t j = i; j <= word.size(); ++j)
                factors[{i, j}] = class_of({word.begin() + static_cast<std::ptrdiff_t>(i),
                                            word.begin() + static_cast<std::ptrdiff_t>(j)});
        while (!open.empty()) {
            task_.budget.check();
            const Place at = open.back();
            open.pop_back();
            for (const auto& [letter, classes] : map) {
                Place to{automaton_.next[at.first][letter], {}};
                if (!automaton_.useful[to.first]) continue;
                for (const std::size_t i : at.second)
                    for (std::size_t j = i; j <= word.size(); ++j)
                        if (classes.contains(factors.at({i, j}))) to.second.insert(j);
                if (to.second.empty()) continue;
                ways[at].emplace_back(letter, to);
                if (ways.try_emplace(to).second) open.push_back(to);
                if (ways.size() > 20 * most_words)
                    throw BoundReached(Bound::method, "a word is made in too many ways");
            }
        }
        const auto is_end = [&](const Place& at) {
            return automaton_.accepting[at.first] && at.second.contains(word.size());
        };
        std::set<Place> useful;
        for (bool grows = true; grows;) {
            grows = false;
            for (const auto& [at, next] : ways)
                if (!useful.contains(at) &&
                    (is_end(at) || std::any_of(next.begin(), next.end(), [&](const auto& way) {
                         return useful.contains(way.second);
                     }))) {
                    useful.insert(at);
                    grows = true;
                }
        }
        // Words of at most as many letters as there are places; a longer one goes round.
        std::vector<Word> found;
        std::vector<std::pair<Word, Place>> begun;
        if (useful.contains({0, {0}})) begun.push_back({{}, {0, {0}}});
        while (!begun.empty()) {
            const auto [so_far, at] = begun.back();
            begun.pop_back();
            if (so_far.size() > useful.size()) field.refuse("infinitely many words may become it");
            if (is_end(at)) found.push_back(so_far);
            if (found.size() + begun.size() > most_words)
                throw BoundReached(Bound::method, "too many words may become one");
            for (const auto& [letter, to] : ways.at(at))
                if (useful.contains(to)) {
                    begun.emplace_back(so_far, to);
                    begun.back().first.push_back(letter);
                }
        }
        return found;
    }

    const Obligation& task_;
    bool tables_;
    Acceptor automaton_;
    std::vector<Map> left_;
};

}  // namespace

void check_classes(const Obligation& task) {
    must_be_one_of(task, {"0L", "P0L", "D0L", "PD0L", "T0L", "PT0L", "DT0L", "PDT0L"});
    ClassCheck(task, task.statement.family.find('T') != std::string::npos).check();
}

namespace {

constexpr std::uint64_t longest_length = 20'000, greatest_modulus = 1'000'000;

/// The lengths of the words of an infinite regular language over one letter.
struct PeriodicLengths {
    Symbol letter = 0;
    std::size_t tail = 0, period = 1;
    std::vector<char> has;  // by length, below tail + period

    std::size_t class_of(std::size_t n) const {
        while (n >= has.size()) n -= (n - tail) / period * period;
        return n;
    }
    bool in(std::size_t n) const { return has[class_of(n)] != 0; }
    /// Of long lengths with this rest.
    bool in_long(std::size_t rest) const { return in(tail * period + rest % period); }
};

PeriodicLengths lengths_of(const Obligation& task) {
    const Acceptor automaton = acceptor(task);
    if (automaton.letters.size() != 1) task.refuse("the words are not over one letter");
    PeriodicLengths found;
    found.letter = automaton.letters.front();
    std::map<std::size_t, std::size_t> first;  // by state, the least length that leads there
    std::size_t s = 0;
    while (first.emplace(s, found.has.size()).second) {
        found.has.push_back(automaton.accepting[s]);
        s = automaton.next[s][found.letter];
    }
    found.tail = first.at(s);
    found.period = found.has.size() - found.tail;
    bool is_infinite = false;
    for (std::size_t r = 0; r < found.period; ++r) is_infinite = is_infinite || found.in_long(r);
    if (!is_infinite) task.refuse("the language is finite");
    return found;
}

/// Of how many letters a table makes each length up to some greatest one.
class Made {
public:
    Made(const PeriodicLengths& lengths, const std::set<std::size_t>& table, std::size_t greatest,
         const Budget& budget)
        : lengths_(lengths), erases_(table.contains(0)), ways_(greatest + 1) {
        // Of x letters that are not erased: bit x.
        for (std::size_t n = 0; n <= greatest; ++n) {
            budget.check();
            std::vector<std::uint64_t>& ways = ways_[n];
            ways.assign(n / 64 + 1, 0);
            if (n == 0) ways[0] = 1;
            for (const std::size_t k : table) {
                if (k == 0 || k > n) continue;
                const std::vector<std::uint64_t>& before = ways_[n - k];
                for (std::size_t i = 0; i < before.size(); ++i) {
                    ways[i] |= before[i] << 1;
                    if (before[i] >> 63 != 0) ways[i + 1] |= 1;
                }
            }
        }
    }

    /// Whether of fewer letters, but at least so many.
    bool of_fewer(std::size_t n, std::size_t least) const {
        bool can_be = false;
        for (std::size_t x = 0; x < n; ++x) {
            const bool exact = (ways_[n][x / 64] >> (x % 64) & 1) != 0;
            can_be = exact || (can_be && erases_);
            if (can_be && x >= least && lengths_.in(x)) return true;
        }
        return false;
    }

private:
    const PeriodicLengths& lengths_;
    bool erases_;
    std::vector<std::vector<std::uint64_t>> ways_;
};

/// The proof that tables have not the lengths of a language (CERTIFICATES.md).
class LengthCheck {
public:
    explicit LengthCheck(const Obligation& task)
        : task_(task),
          lengths_(lengths_of(task)),
          tables_(task.statement.family.find('T') != std::string::npos),
          erases_(!task.statement.family.starts_with('P') && lengths_.in(0)) {}

    void check() {
        if (task_.proof.has("sums")) return check_sums();
        const auto targets = task_.proof.at("targets").list();
        std::set<std::uint64_t> alone;
        for (const Field& target : targets) {
            target.only({"length", "rest", "frames"});
            Goal goal;
            if (target.has("length")) goal.length = length(target.at("length"));
            if (target.has("rest")) goal.rest = rest(target.at("rest"));
            if (goal.length && goal.rest) target.refuse("it is a length or a rest");
            if (goal.length) {
                if (!lengths_.in(*goal.length) || is_free(*goal.length))
                    target.refuse("no word has this length, or tables that erase make it");
                alone.insert(*goal.length);
            } else if (goal.rest) {
                const std::size_t long_one =
                    goal.rest->first + (lengths_.tail + 1) * lengths_.period;
                if (!lengths_.in(long_one) || is_free(long_one))
                    target.refuse("no words have these lengths, or tables that erase make them");
                if (goal.rest->second % lengths_.period != 0 ||
                    !has_primes_of_period(goal.rest->second))
                    target.refuse("the modulus has other prime divisors than the period");
            } else if (tables_ || erases_ || lengths_.in(0)) {
                target.refuse("only one table that does not erase has to make all lengths");
            }
            check_frames(target.at("frames"), goal);
            if (!goal.length) return;
        }
        if (alone.size() < 2)
            task_.proof.at("targets").refuse("one of the lengths may be that of the axiom");
    }

private:
    using Rest = std::pair<std::size_t, std::size_t>;
    using Set = std::set<std::size_t>;
    struct Goal {
        std::optional<std::size_t> length;
        std::optional<Rest> rest;
    };

    std::size_t length(const Field& field) const {
        if (field.number() > longest_length)
            throw BoundReached(Bound::method,
                               "lengths are looked at up to " + std::to_string(longest_length));
        return static_cast<std::size_t>(field.number());
    }
    Rest rest(const Field& field) const {
        const auto [first, second] = field.pair();
        if (second.number() == 0 || first.number() >= second.number())
            field.refuse("a rest is less than its modulus");
        if (second.number() > greatest_modulus)
            throw BoundReached(Bound::method, "the modulus is too great");
        return {static_cast<std::size_t>(first.number()),
                static_cast<std::size_t>(second.number())};
    }

    /// The axiom has one of the lengths u, v whose sum is no length, and without it sums lead out too.
    void check_sums() const {
        if (tables_ || !erases_)
            task_.refuse("this is about one table, and languages with the empty word");
        std::vector<Rest> sums;
        for (const Field& each : task_.proof.at("sums").list()) {
            const auto [u, v] = each.pair();
            sums.emplace_back(length(u), length(v));
        }
        const auto leads_out = [&](const Rest& sum, std::size_t axiom) {
            const auto is_other = [&](std::size_t n) {
                return n > 0 && n != axiom && lengths_.in(n);
            };
            return is_other(sum.first) && is_other(sum.second) && !is_other(sum.first + sum.second);
        };
        if (sums.empty() || !leads_out(sums.front(), 0))
            task_.proof.at("sums").refuse("the first sum is one of the lengths");
        for (const std::size_t axiom : {sums.front().first, sums.front().second})
            if (std::none_of(sums.begin(), sums.end(),
                             [&](const Rest& sum) { return leads_out(sum, axiom); }))
                task_.proof.at("sums").refuse("an axiom of " + std::to_string(axiom) +
                                              " letters is not excluded");
    }

    /// Whether all multiples are lengths, and may be erased to.
    bool is_free(std::size_t n) const {
        if (!erases_) return false;
        for (std::size_t i = 1; i <= lengths_.has.size() + lengths_.period; ++i)
            if (!lengths_.in(i * n)) return false;
        return true;
    }

    bool has_primes_of_period(std::size_t n) const {
        for (std::size_t prime = 2; prime <= n; ++prime)
            while (n % prime == 0) {
                if (lengths_.period % prime != 0) return false;
                n /= prime;
            }
        return true;
    }

    void check_frames(const Field& field, const Goal& goal) {
        std::vector<Rest> frames;  // modulus and rest
        for (const Field& frame : field.list()) {
            frame.only({"modulus", "rest", "case"});
            const std::size_t modulus = length(frame.at("modulus")),
                              rest = length(frame.at("rest"));
            if (modulus == 0 || lengths_.period % modulus != 0)
                frame.refuse("the modulus does not divide the period");
            frames.emplace_back(modulus, rest);
            Set set;
            for (std::size_t n = 1; n < lengths_.has.size(); ++n)
                if (n % modulus == rest) set.insert(n);
            follow(set, {}, goal, frame.at("case"));
        }
        for (std::size_t modulus = 1; modulus <= lengths_.period; ++modulus)
            for (std::size_t rest = 0; rest < modulus; ++rest)
                if (lengths_.period % modulus == 0 && is_possible(modulus, rest) &&
                    std::none_of(frames.begin(), frames.end(), [&](const Rest& frame) {
                        return modulus % frame.first == 0 && rest % frame.first == frame.second;
                    }))
                    field.refuse("tables whose lengths have the rest " + std::to_string(rest) +
                                 " modulo " + std::to_string(modulus) + " are possible too");
    }

    /// Of tables whose differences have, with the period, this greatest common divisor.
    bool is_possible(std::size_t modulus, std::size_t rest) const {
        std::set<std::size_t> before, after;
        for (std::size_t r = 0; r < lengths_.period; ++r) {
            if (!lengths_.in_long(r)) continue;
            before.insert(r);
            after.insert(r * rest % lengths_.period);
            for (std::size_t n = r * rest % modulus; n < lengths_.period; n += modulus)
                if (!lengths_.in_long(n)) return false;
        }
        // One table makes all long lengths of long ones.
        return tables_ || (modulus == lengths_.period && before == after);
    }

    void follow(const Set& set, const Set& kept, const Goal& goal, const Field& field) {
        task_.budget.check();
        field.only({"sum", "cases", "length", "rest"});
        if (field.has("length")) {
            const std::size_t n = length(field.at("length"));
            if (goal.rest || n != goal.length.value_or(n) || !lengths_.in(n))
                field.refuse("this is not the length that is to be made");
            if (!goal.length && n <= least()) field.refuse("it may be that of the axiom");
            Set table;
            for (std::size_t k = 1; k <= n; ++k)
                if (set.contains(lengths_.class_of(k))) table.insert(k);
            if (Made(lengths_, table, n, task_.budget).of_fewer(n, 0))
                field.refuse("a table with these lengths may make it of a shorter one");
            return;
        }
        if (field.has("rest")) {
            const Rest missed = rest(field.at("rest"));
            if (goal.length || missed != goal.rest.value_or(missed))
                field.refuse("these are not the lengths that are to be made");
            if (missed.second % lengths_.period != 0 || !has_primes_of_period(missed.second) ||
                !lengths_.in_long(missed.first))
                field.refuse(
                    "no words have these lengths, or the modulus has other prime divisors "
                    "than the period");
            if (makes_long(set, missed))
                field.refuse("a table with these lengths may make them of long ones");
            return;
        }
        std::vector<std::size_t> sum;
        std::size_t total = 0;
        for (const Field& each : field.at("sum").list()) {
            sum.push_back(length(each));
            total += sum.back();
            if (!set.contains(sum.back())) each.refuse("no table has this length");
        }
        if (sum.empty() || !lengths_.in(sum.size()))
            field.at("sum").refuse("no word has as many letters");
        if (lengths_.in(total)) field.at("sum").refuse("the sum is a length");
        const auto cases = field.at("cases").list();
        Set left(sum.begin(), sum.end());
        std::erase_if(left, [&](std::size_t n) { return kept.contains(n); });
        if (cases.size() != left.size())
            field.at("cases").refuse("there must be one for each length that may be left out");
        Set keeping = kept;
        std::size_t i = 0;
        for (const std::size_t n : left) {
            Set without = set;
            without.erase(n);
            follow(without, keeping, goal, cases[i++]);
            keeping.insert(n);
        }
    }

    std::size_t least() const {
        std::size_t n = 1;
        while (!lengths_.in(n)) ++n;
        return n;
    }

    /// Whether a finite table of the set may make long lengths of this rest, without small prime divisors that the period has not, of long
    /// shorter ones.
    bool makes_long(const Set& set, const Rest& rest) const {
        if (set.empty()) return false;
        // 1 makes each length of itself only; from the tail on it stands for longer ones, too.
        if (set == Set{1} && lengths_.tail > 1) return false;
        const bool endless = *set.rbegin() >= lengths_.tail;
        std::size_t shared = endless ? lengths_.period : 0, differences = shared;
        for (const std::size_t n : set) {
            shared = std::gcd(shared, n);
            differences = std::gcd(differences, n - *set.begin());
        }
        if (!has_primes_of_period(shared)) return false;
        // One number: s = x k. Several: s = x k modulo all prime powers in their differences that are of primes of the period.
        std::size_t modulus = differences;
        for (std::size_t prime = 2; differences > 0 && prime <= differences; ++prime)
            while (differences % prime == 0) {
                differences /= prime;
                if (lengths_.period % prime != 0) modulus /= prime;
            }
        modulus = modulus == 0 ? rest.second : std::gcd(modulus, rest.second);
        const std::size_t all = std::lcm(modulus, lengths_.period);
        for (std::size_t x = 0; x < all; ++x)
            if (lengths_.in_long(x) && x * *set.begin() % modulus == rest.first % modulus)
                return true;
        return false;
    }

    const Obligation& task_;
    PeriodicLengths lengths_;
    bool tables_, erases_;
};

}  // namespace

void check_lengths(const Obligation& task) {
    must_be_one_of(task, {"0L", "P0L", "T0L", "PT0L"});
    LengthCheck(task).check();
}

/// Lengths up to `from` come from shorter ones. Of the others each has the rest of one that a table makes of x, x at least the tail: it makes
/// s + p k of x + p for the period p and a length k of its.
void check_length_induction(const Obligation& task, const std::vector<Word>& base) {
    const PeriodicLengths lengths = lengths_of(task);
    const System& system = *task.language(1)->system;
    const std::uint64_t from = task.proof.at("from").number();
    if (from > longest_length)
        throw BoundReached(Bound::method,
                           "lengths are looked at up to " + std::to_string(longest_length));
    if (from < lengths.tail) task.proof.at("from").refuse("it is less than the tail");
    std::set<std::size_t> known;
    for (const Word& word : base)
        if (std::all_of(word.begin(), word.end(), [&](Symbol a) { return a == lengths.letter; }))
            known.insert(word.size());
    std::vector<std::set<std::size_t>> tables;
    std::vector<Made> made;
    for (const System::Successors& table : system.tables) {
        auto& successors = tables.emplace_back();
        for (const Word& word : table[lengths.letter])
            if (std::all_of(word.begin(), word.end(),
                            [&](Symbol a) { return a == lengths.letter; }))
                successors.insert(word.size());
        made.emplace_back(lengths, successors, static_cast<std::size_t>(from), task.budget);
    }
    for (std::size_t n = 0; n <= from; ++n) {
        task.budget.check();
        if (lengths.in(n) && !known.contains(n) &&
            std::none_of(made.begin(), made.end(),
                         [&](const Made& each) { return each.of_fewer(n, 0); }))
            task.refuse("the length " + std::to_string(n) +
                        " is not in the base and does not come from a shorter one");
    }
    // Rests that are made so, by the moduli of the tables.
    std::vector<std::pair<std::size_t, std::set<std::size_t>>> rests;
    std::size_t all = lengths.period;
    for (const Field& each : task.proof.at("tables").list()) {
        if (each.number() >= tables.size()) each.refuse("there is no such table");
        const auto t = static_cast<std::size_t>(each.number());
        const auto k = tables[t].upper_bound(0);
        if (k == tables[t].end()) each.refuse("the table makes the empty word only");
        auto& [modulus, some] = rests.emplace_back(lengths.period * *k, std::set<std::size_t>{});
        all = std::lcm(all, modulus);
        if (all > greatest_modulus)
            throw BoundReached(Bound::method, "the period of the tables is too great");
        for (std::size_t n = 0; n <= from; ++n)
            if (made[t].of_fewer(n, std::max<std::size_t>(lengths.tail, 1)))
                some.insert(n % modulus);
    }
    for (std::size_t rest = 0; rest < all; ++rest)
        if (lengths.in_long(rest) &&
            std::none_of(rests.begin(), rests.end(),
                         [&](const auto& each) { return each.second.contains(rest % each.first); }))
            task.refuse("long lengths with the rest " + std::to_string(rest) + " modulo " +
                        std::to_string(all) + " are not seen to be made");
}

void check_dense(const Obligation& task) {
    must_be_one_of(task, {"D0L", "PD0L"});
    const Acceptor automaton = acceptor(task);
    const auto all = reached(automaton);
    for (std::size_t s = 0; s < automaton.states(); ++s) {
        if (!all[s].contains(s)) continue;
        std::size_t back = 0;
        for (const Symbol a : automaton.letters)
            if (const std::size_t to = automaton.next[s][a];
                automaton.useful[to] && (to == s || all[to].contains(s)))
                ++back;
        if (back > 1) return;
        for (const std::size_t t : all[s])
            if (all[t].contains(t) && !all[t].contains(s)) return;
    }
    task.refuse("no two cycles of the automaton share a state or follow each other");
}

void check_cycles(const Obligation& task) {
    must_be_one_of(task, {"D0L", "PD0L"});
    const Acceptor automaton = acceptor(task);
    const std::set<Symbol> letters = letters_on_cycles(automaton);
    if (letters.empty()) task.refuse("the language is finite");
    const Word word = task.word("word");
    if (!automaton.accepts(word)) task.proof.at("word").refuse("the word is not in the language");
    for (const Symbol a : word)
        if (!letters.contains(a))
            task.proof.at("word").refuse("a letter of it is on no cycle of the automaton");
}

/// For letters a, b, with v the numbers of letters in one word: |u| v_b - |u| v_a, counting a and b, is the same for all beginnings
/// u of words that lead to one state, and 0 for words.
void check_proportional(const Obligation& task) {
    must_be_one_of(task, {"D0L", "PD0L", "DT0L", "PDT0L"});
    const Acceptor automaton = acceptor(task);
    if (letters_on_cycles(automaton).empty()) task.refuse("the language is finite");
    // The numbers of letters in a shortest word that is not empty.
    std::map<Symbol, Integer> vector;
    std::set<std::size_t> seen;
    std::vector<std::pair<std::size_t, Word>> order{{0, {}}};
    for (std::size_t i = 0; i < order.size() && vector.empty(); ++i) {
        const auto [state, word] = order[i];
        if (automaton.accepting[state])
            for (const Symbol a : word) vector[a] += 1;
        for (const Symbol a : automaton.letters)
            if (const std::size_t to = automaton.next[state][a];
                automaton.useful[to] && seen.insert(to).second) {
                order.emplace_back(to, word);
                order.back().second.push_back(a);
            }
    }
    for (const Symbol a : automaton.letters)
        for (const Symbol b : automaton.letters) {
            std::map<std::size_t, Integer> value{{0, Integer(0)}};
            std::vector<std::size_t> open{0};
            while (!open.empty()) {
                const std::size_t s = open.back();
                open.pop_back();
                if (automaton.accepting[s] && !value.at(s).is_zero())
                    task.refuse("the letters of the words are not in one proportion");
                for (const Symbol c : automaton.letters) {
                    const std::size_t to = automaton.next[s][c];
                    if (!automaton.useful[to]) continue;
                    Integer next = value.at(s);
                    if (c == a) next += vector[b];
                    if (c == b) next -= vector[a];
                    const auto [place, is_new] = value.emplace(to, next);
                    if (is_new) open.push_back(to);
                    if (!(place->second == next))
                        task.refuse("the letters of the words are not in one proportion");
                }
            }
        }
}

void check_blocks(const Obligation& task) {
    must_be_one_of(task, {"0L", "P0L", "D0L", "PD0L", "T0L", "PT0L", "DT0L", "PDT0L"});
    const Tree& tree = *task.language();
    if (tree.kind != Tree::Kind::powers) task.refuse("the language is not one of powers");
    const Powers& powers = *tree.powers;
    if (powers.names.size() != 1 || powers.blocks.size() < 2 || !is_linear(powers))
        task.refuse("the powers do not grow linearly with one number, or there is only one");
    std::set<Symbol> letters;
    for (const Powers::Block& block : powers.blocks)
        if (block.word.size() != 1 || !letters.insert(block.word.front()).second || !varies(block))
            task.refuse("a power does not grow, or is not one of a letter of its own");
}

namespace {

/// Whether the lengths of an expression over one letter are seen to be a share of the numbers up to x that tends to 0.
bool is_sparse(const Language& language) {
    const Tree& tree = *language;
    switch (tree.kind) {
        case Tree::Kind::words:
            return true;
        case Tree::Kind::powers:
            return tree.powers->names.size() == 1 && !is_linear(*tree.powers);
        case Tree::Kind::united:
            return is_sparse(tree.parts[0]) && is_sparse(tree.parts[1]);
        case Tree::Kind::reversal:
            return is_sparse(tree.parts[0]);
        case Tree::Kind::generated: {
            if (!tree.system || tree.system->context || !has_only_terminals(*tree.system))
                return false;
            // By tables of one rule a -> a^s the lengths are products of finitely many numbers.
            for (const Symbol a : accessible_letters(*tree.system, tree.system->axiom))
                for (const System::Successors& table : tree.system->tables)
                    if (table[a].size() != 1) return false;
            return true;
        }
        default:
            return false;
    }
}

/// The letters that can occur in words of such an expression.
void add_letters(const Language& language, std::set<Symbol>& letters) {
    const Tree& tree = *language;
    for (const Word& word : tree.words) letters.insert(word.begin(), word.end());
    if (tree.powers)
        for (const Powers::Block& block : tree.powers->blocks)
            letters.insert(block.word.begin(), block.word.end());
    if (tree.system)
        for (const Symbol a : accessible_letters(*tree.system, tree.system->axiom))
            letters.insert(a);
    for (const Language& part : tree.parts) add_letters(part, letters);
}

}  // namespace

void check_geometric(const Obligation& task) {
    must_be_one_of(task, {"0L", "P0L", "D0L", "PD0L", "T0L", "PT0L", "DT0L", "PDT0L"});
    constexpr std::uint64_t longest = 1'000;
    std::set<Symbol> letters;
    add_letters(task.language(), letters);
    if (letters.size() != 1 || !is_sparse(task.language()))
        task.refuse("it is not seen that the language is over one letter and has few lengths");
    check_infinite(task, task.language(), task.proof.at("infinite"));
    const Field field = task.proof.at("length");
    const std::uint64_t length = field.number();
    if (length > longest)
        throw BoundReached(Bound::method, "lengths are looked at up to " + std::to_string(longest));
    std::map<std::uint64_t, bool> known;
    const auto in = [&](std::uint64_t n) {
        const auto [place, is_new] = known.try_emplace(n, false);
        if (is_new)
            place->second =
                task.contains(task.language(), Word(static_cast<std::size_t>(n), *letters.begin()));
        return place->second;
    };
    if (length == 0 || !in(length)) field.refuse("no word has this length, or the empty word has");
    std::vector<std::uint64_t> lengths;
    for (std::uint64_t n = 1; n <= length; ++n)
        if (in(n)) lengths.push_back(n);
    if (lengths.size() == 1) field.refuse("it is the least length, which the axiom may have");
    if (task.statement.family.find('T') == std::string::npos) {
        bool geometric = true;
        for (std::size_t i = 1; i < lengths.size(); ++i)
            geometric = geometric && lengths[i] * lengths[0] == lengths[i - 1] * lengths[1] &&
                        lengths[1] % lengths[0] == 0;
        if (geometric) field.refuse("the lengths up to it are a geometric sequence");
        return;
    }
    for (const std::uint64_t shorter : lengths) {
        if (shorter == length || length % shorter != 0) continue;
        const std::uint64_t factor = length / shorter;
        if (std::all_of(lengths.begin(), lengths.end(),
                        [&](std::uint64_t n) { return n * factor > longest || in(n * factor); }))
            field.refuse("it may come of a word of " + std::to_string(shorter) + " letters");
    }
}

}  // namespace algae::verify
