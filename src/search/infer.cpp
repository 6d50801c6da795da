#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include "search/search.hpp"

// Which is the smallest system that has given words as its first generations, or in its language?
//
// Generations. That w(i+1) comes of w(i) is an equation between words: the successors of the letters of w(i), one after the
// other, are w(i+1). What must have one successor is a key: a letter, in a DT0L system a letter in a table, in a DIL system a letter
// between its contexts. A deterministic system is a value for each key that solves all equations; a key that occurs in none has the
// shortest value. The search goes through the equations from left to right. At a key that has a value, this must stand there;
// otherwise each value that could stand there is tried, shorter ones first. A part is given up where an equation cannot be
// completed, because what has values is too long for the rest of the word, or where it is as large as the best system so far. Nothing else
// is left out, so what is found is the smallest, and where nothing is found there is nothing (Doucet 1974 decides the same question
// for D0L systems by lengths first).
//
// In a 0L system each occurrence of a letter has a successor of its own, and a system pays once for each that is different. The search is
// the same; at each letter it tries the successors that the letter has already, which are free, and then new ones. There is always a
// system: the first letter of a word gives all of the next one, the others give nothing.
//
// Tables and contexts restrict, so T0L and IL systems, which may choose, are never smaller than 0L systems. DT0L: the steps are
// partitioned into tables in all ways, as restricted growth strings, each with the bound of the best so far. DIL: contexts of k letters on the left
// and l on the right in the order of k + l; at the ends of a word they are shorter. With contexts as long as the words, each letter
// of each word is a key of its own, so there is a system unless one word has two successors, or the empty word has one.
//
// Samples. All systems are visited in the order of their sizes, each once up to renaming, and all ways are tried to take letters of the words
// for letters of the system.

namespace algae {

namespace {

struct Key {
    std::size_t table = 0;
    Word left;
    Symbol letter = 0;
    Word right;
    auto tied() const { return std::tie(table, letter, left, right); }
    bool operator<(const Key& other) const { return tied() < other.tied(); }
};

/// The successors of these keys, one after the other, are this word.
struct Equation {
    std::vector<std::size_t> keys;
    Word image;
};

/// Finds values of keys, smallest first, below a bound.
class Cuts {
public:
    Cuts(std::vector<Equation> equations, std::size_t keys, bool nonempty, std::uint64_t below,
         const Budget& budget)
        : equations_(std::move(equations)),
          values_(keys),
          below_(below),
          shortest_(nonempty ? 1 : 0),
          budget_(budget) {
        // Keys that never occur have the shortest value, which the caller adds.
        std::set<std::size_t> occur;
        for (const Equation& equation : equations_)
            occur.insert(equation.keys.begin(), equation.keys.end());
        unknown_ = occur.size();
    }

    /// The values whose total length is least and below the bound; nothing if there are none.
    std::optional<std::vector<Word>> least() {
        next(0, 0, 0);
        if (!best_) return std::nullopt;
        std::vector<Word> found;
        for (const auto& value : *best_) found.push_back(value.value_or(Word()));
        return found;
    }
    std::uint64_t length() const { return below_; }  // of what least() found
    std::uint64_t cases = 0;

private:
    using Values = std::vector<std::optional<Word>>;

    /// From this key of this equation on, whose image is cut up to here.
    void next(std::size_t equation, std::size_t at, std::size_t cut) {
        if ((++cases & 0x3ff) == 0) budget_.check();
        if (length_ + unknown_ * shortest_ >= below_) return;
        while (equation < equations_.size() && at == equations_[equation].keys.size()) {
            if (cut != equations_[equation].image.size()) return;
            ++equation;
            at = cut = 0;
        }
        if (equation == equations_.size()) {
            best_ = values_;
            below_ = length_;
            return;
        }
        const auto& [keys, image] = equations_[equation];
        const std::size_t key = keys[at];
        const std::size_t room = image.size() - cut;
        if (const auto& value = values_[key]) {
            if (value->size() <= room &&
                std::equal(value->begin(), value->end(),
                           image.begin() + static_cast<std::ptrdiff_t>(cut)))
                next(equation, at + 1, cut + value->size());
            return;
        }
        // What the rest takes for sure, and how often this key is in it.
        std::size_t taken = 0, times = 0;
        bool others = false;
        for (std::size_t i = at; i < keys.size(); ++i) {
            if (keys[i] == key)
                ++times;
            else if (const auto& value = values_[keys[i]])
                taken += value->size();
            else {
                taken += shortest_;
                others = true;
            }
        }
        if (taken > room) return;
        const std::size_t most = (room - taken) / times;
        std::size_t least = shortest_;
        if (!others) {  // the length is what is left
            if ((room - taken) % times != 0) return;
            least = std::max(least, most);
        }
        --unknown_;
        for (std::size_t size = least; size <= most; ++size) {
            const auto begin = image.begin() + static_cast<std::ptrdiff_t>(cut);
            values_[key].emplace(begin, begin + static_cast<std::ptrdiff_t>(size));
            length_ += size;
            next(equation, at + 1, cut + size);
            length_ -= size;
        }
        values_[key].reset();
        ++unknown_;
    }

    std::vector<Equation> equations_;
    Values values_;
    std::optional<Values> best_;
    std::uint64_t length_ = 0, unknown_ = 0;
    std::uint64_t below_;
    std::size_t shortest_;
    const Budget& budget_;
};

/// How many letters there are: symbols are numbered from 0.
std::size_t letters_in(const std::vector<Word>& words) {
    std::size_t count = 0;
    for (const Word& word : words)
        for (const Symbol letter : word) count = std::max<std::size_t>(count, letter + 1);
    return count;
}

/// The letters that occur, in order.
std::vector<Symbol> occurring(const std::vector<Word>& words) {
    std::set<Symbol> found;
    for (const Word& word : words) found.insert(word.begin(), word.end());
    return {found.begin(), found.end()};
}

/// A deterministic system with these contexts, and with this table for each step; smaller than `below`.
std::optional<InferredSystem> deterministic(const std::vector<Word>& words,
                                            const InferenceWish& wish, std::size_t left,
                                            std::size_t right,
                                            const std::vector<std::size_t>& schedule,
                                            std::size_t tables, std::uint64_t below,
                                            std::uint64_t& cases, const Budget& budget) {
    const bool contexts = wish.family == InferenceWish::Family::dil;
    std::map<Key, std::size_t> numbers;
    std::vector<Key> keys;
    const auto number = [&](Key key) {
        const auto [entry, is_new] = numbers.emplace(key, keys.size());
        if (is_new) keys.push_back(std::move(key));
        return entry->second;
    };
    std::vector<Equation> equations;
    for (std::size_t step = 0; step + 1 < words.size(); ++step) {
        const Word& word = words[step];
        Equation& equation = equations.emplace_back();
        equation.image = words[step + 1];
        for (std::size_t i = 0; i < word.size(); ++i) {
            const auto here = word.begin() + static_cast<std::ptrdiff_t>(i);
            const auto from = word.begin() + static_cast<std::ptrdiff_t>(i - std::min(i, left));
            const auto end =
                here + 1 + static_cast<std::ptrdiff_t>(std::min(word.size() - i - 1, right));
            equation.keys.push_back(
                number({schedule[step], Word(from, here), word[i], Word(here + 1, end)}));
        }
    }
    // Letters about which the words say nothing.
    const std::size_t said = keys.size();
    if (!contexts)
        for (std::size_t table = 0; table < tables; ++table)
            for (const Symbol letter : occurring(words)) number({table, {}, letter, {}});
    std::uint64_t size = words.front().size();
    for (const Key& key : keys) size += 1 + key.left.size() + key.right.size();
    if (wish.propagating) size += keys.size() - said;
    if (size >= below) return std::nullopt;
    Cuts cuts(std::move(equations), keys.size(), wish.propagating, below - size, budget);
    const auto values = cuts.least();
    cases += cuts.cases;
    if (!values) return std::nullopt;
    InferredSystem found;
    found.axiom = words.front();
    found.tables = tables;
    found.schedule = schedule;
    found.size = size + cuts.length();
    for (std::size_t i = 0; i < keys.size(); ++i) {
        Word successor = (*values)[i];
        if (i >= said && wish.propagating) successor = {keys[i].letter};
        found.rules.push_back(
            {keys[i].table, keys[i].left, keys[i].letter, keys[i].right, std::move(successor)});
    }
    std::stable_sort(
        found.rules.begin(), found.rules.end(), [](const InferredRule& a, const InferredRule& b) {
            const auto contexts_of = [](const InferredRule& rule) {
                return rule.left.size() + rule.right.size();
            };
            const std::size_t of_a = contexts_of(a), of_b = contexts_of(b);
            return std::tie(a.table, a.letter, of_b) < std::tie(b.table, b.letter, of_a);
        });
    return found;
}

constexpr std::uint64_t unbounded = std::numeric_limits<std::uint64_t>::max();

/// The next partition of the steps into tables, as a restricted growth string; false at the end.
bool next_partition(std::vector<std::size_t>& tables) {
    for (std::size_t i = tables.size(); i-- > 1;) {
        std::size_t most = 0;
        for (std::size_t j = 0; j < i; ++j) most = std::max(most, tables[j] + 1);
        if (tables[i] >= most) continue;
        ++tables[i];
        std::fill(tables.begin() + static_cast<std::ptrdiff_t>(i) + 1, tables.end(), 0);
        return true;
    }
    return false;
}

Inference with_tables(const std::vector<Word>& words, const InferenceWish& wish,
                      const Budget& budget) {
    Inference found;
    std::vector<std::size_t> schedule(words.size() - 1, 0);
    std::uint64_t below = unbounded;
    do {
        const std::size_t tables =
            schedule.empty() ? 1 : *std::max_element(schedule.begin(), schedule.end()) + 1;
        if (auto system =
                deterministic(words, wish, 0, 0, schedule, tables, below, found.cases, budget)) {
            below = system->size;
            found.system = std::move(system);
        }
    } while (next_partition(schedule));
    return found;
}

Inference with_contexts(const std::vector<Word>& words, const InferenceWish& wish,
                        const Budget& budget) {
    Inference found;
    std::size_t longest = 0;
    for (std::size_t i = 0; i + 1 < words.size(); ++i) longest = std::max(longest, words[i].size());
    const std::vector<std::size_t> schedule(words.size() - 1, 0);
    const std::size_t most = longest == 0 ? 0 : longest - 1;
    for (std::size_t both = 0; both <= 2 * most && !found.system; ++both)
        for (std::size_t left = std::min(both, most) + 1; left-- > 0;) {
            if (both - left > most) break;
            const std::uint64_t below = found.system ? found.system->size : unbounded;
            if (auto system = deterministic(words, wish, left, both - left, schedule, 1, below,
                                            found.cases, budget))
                found.system = std::move(system);
        }
    return found;
}

/// Finds sets of successors, smallest first.
class Choices {
public:
    Choices(const std::vector<Word>& words, bool propagating, const Budget& budget)
        : words_(words),
          successors_(letters_in(words)),
          shortest_(propagating ? 1 : 0),
          budget_(budget) {}

    Inference least() {
        for (Symbol letter = 0; letter < successors_.size(); ++letter) {
            const auto has = [&](const Word& word) {
                return std::find(word.begin(), word.end(), letter) != word.end();
            };
            const bool said = std::any_of(words_.begin(), words_.end() - 1, has);
            // What the words do not say costs 1, or 2 if it must not be empty.
            if (!said && has(words_.back())) unsaid_.push_back(letter);
        }
        size_ = words_.front().size() + unsaid_.size() * (1 + shortest_);
        next(0, 0, 0);
        Inference found;
        found.cases = cases_;
        if (!best_) return found;
        InferredSystem& system = found.system.emplace();
        system.axiom = words_.front();
        system.schedule.assign(words_.size() - 1, 0);
        system.size = below_;
        for (Symbol letter = 0; letter < best_->size(); ++letter)
            for (const Word& successor : (*best_)[letter])
                system.rules.push_back({0, {}, letter, {}, successor});
        for (const Symbol letter : unsaid_)
            system.rules.push_back({0, {}, letter, {}, shortest_ == 0 ? Word() : Word{letter}});
        std::stable_sort(
            system.rules.begin(), system.rules.end(),
            [](const InferredRule& a, const InferredRule& b) { return a.letter < b.letter; });
        return found;
    }

private:
    void next(std::size_t step, std::size_t at, std::size_t cut) {
        if ((++cases_ & 0x3ff) == 0) budget_.check();
        if (size_ >= below_) return;
        while (step + 1 < words_.size() && at == words_[step].size()) {
            if (cut != words_[step + 1].size()) return;
            ++step;
            at = cut = 0;
        }
        if (step + 1 >= words_.size()) {
            best_ = successors_;
            below_ = size_;
            return;
        }
        const Word &word = words_[step], &image = words_[step + 1];
        const std::size_t room = image.size() - cut, after = (word.size() - at - 1) * shortest_;
        if (after > room) return;
        auto& known = successors_[word[at]];
        const auto begin = image.begin() + static_cast<std::ptrdiff_t>(cut);
        for (std::size_t i = 0; i < known.size(); ++i) {
            const std::size_t length = known[i].size();
            if (length <= room - after && std::equal(known[i].begin(), known[i].end(), begin))
                next(step, at + 1, cut + length);
        }
        const bool last = at + 1 == word.size();
        for (std::size_t length = last ? room : shortest_; length <= room - after; ++length) {
            if (length < shortest_ || size_ + 1 + length >= below_) break;
            Word successor(begin, begin + static_cast<std::ptrdiff_t>(length));
            if (std::find(known.begin(), known.end(), successor) != known.end()) continue;
            known.push_back(std::move(successor));
            size_ += 1 + length;
            next(step, at + 1, cut + length);
            size_ -= 1 + length;
            known.pop_back();
        }
    }

    const std::vector<Word>& words_;
    std::vector<std::vector<Word>> successors_;
    std::optional<std::vector<std::vector<Word>>> best_;
    std::vector<Symbol> unsaid_;
    std::uint64_t size_ = 0, below_ = unbounded, cases_ = 0;
    std::size_t shortest_;
    const Budget& budget_;
};

}  // namespace

Inference infer_generations(const std::vector<Word>& words, const InferenceWish& wish,
                            const Budget& budget) {
    using enum InferenceWish::Family;
    if (words.empty()) throw Error("expected words to infer a system from, found none");
    if (words.front().empty())
        throw Error("the first word is empty, expected an axiom with at least one letter");
    if (wish.family == ol) return Choices(words, wish.propagating, budget).least();
    if (wish.family == dt0l) return with_tables(words, wish, budget);
    if (wish.family == dil) return with_contexts(words, wish, budget);
    Inference found;
    found.system = deterministic(words, wish, 0, 0, std::vector<std::size_t>(words.size() - 1, 0),
                                 1, unbounded, found.cases, budget);
    return found;
}

namespace {

/// Tries all ways to take the letters of the words for letters of a system, which has `letters` of them.
class Renaming {
public:
    Renaming(const std::vector<Word>& words, const std::vector<Symbol>& occurring,
             std::size_t letters)
        : words_(words),
          occurring_(occurring),
          to_(letters_in(words), 0),
          from_(letters, std::nullopt) {}

    /// Whether for some way all words pass. The way is then in names().
    bool find(const std::function<bool(const Word&)>& passes, std::size_t at = 0) {
        if (at == occurring_.size())
            return std::all_of(words_.begin(), words_.end(), [&](const Word& word) {
                Word renamed;
                for (const Symbol letter : word) renamed.push_back(to_[letter]);
                return passes(renamed);
            });
        for (Symbol letter = 0; letter < from_.size(); ++letter) {
            if (from_[letter]) continue;
            from_[letter] = occurring_[at];
            to_[occurring_[at]] = letter;
            if (find(passes, at + 1)) return true;
            from_[letter].reset();
        }
        return false;
    }
    /// The letter of the words for each letter of the system; a new one where none is.
    std::vector<Symbol> names() const {
        std::vector<Symbol> all;
        auto fresh = static_cast<Symbol>(to_.size());
        for (const auto& letter : from_) all.push_back(letter ? *letter : fresh++);
        return all;
    }

private:
    const std::vector<Word>& words_;
    const std::vector<Symbol>& occurring_;
    std::vector<Symbol> to_;
    std::vector<std::optional<Symbol>> from_;
};

}  // namespace

Inference infer_sample(const std::vector<Word>& words, const InferenceWish& wish,
                       std::uint64_t largest,
                       const std::function<bool(const ET0L&, const Word&)>& is_member,
                       const Budget& budget) {
    using enum InferenceWish::Family;
    if (words.empty()) throw Error("expected words to infer a system from, found none");
    if (wish.family == dil)
        throw Error(
            "samples are of D0L, 0L and DT0L systems; of IL systems the first generations are "
            "known");
    Domain domain;
    domain.kind = Domain::Kind::system;
    domain.deterministic = wish.family != ol;
    domain.propagating = wish.propagating;
    domain.tables = wish.family == dt0l;
    const std::vector<Symbol> letters = occurring(words);
    Inference found;
    for (std::uint64_t size = 1; size <= largest && !found.system; ++size)
        visit(
            {{domain}}, size,
            [&](const Instance& instance) {
                ++found.cases;
                if (instance.letters() < letters.size()) return true;
                const ET0L system = instance.et0l(0);
                Renaming renaming(words, letters, instance.letters());
                if (!renaming.find([&](const Word& word) { return is_member(system, word); }))
                    return true;
                const std::vector<Symbol> names = renaming.names();
                const auto named = [&](const Word& word) {
                    Word out;
                    for (const Symbol letter : word) out.push_back(names[letter]);
                    return out;
                };
                InferredSystem& made = found.system.emplace();
                made.axiom = named(system.axiom);
                made.tables = system.tables.size();
                made.size = size;
                for (std::size_t table = 0; table < system.tables.size(); ++table)
                    for (Symbol letter = 0; letter < instance.letters(); ++letter)
                        for (const Word& successor : system.tables[table][letter])
                            made.rules.push_back({table, {}, names[letter], {}, named(successor)});
                return false;
            },
            budget);
    return found;
}

}  // namespace algae
