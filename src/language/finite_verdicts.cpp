#include "language/detail/finite_verdicts.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "verify/verify.hpp"

// In which of the eight families is a finite language, asked for millions of languages?
//
// `decide_family` (finite_family.cpp) answers for one family and brings a witness or an obstruction. A census wants
// verdicts only, for all families, so here everything that families share is done once, in numbers, without proofs:
//
// 1. Letters become bytes, words places, factors nodes of one tree. The words' beginnings are the top of that tree.
// 2. Closed maps: all h with h(L) within L, word after word, each new letter along the tree of beginnings. One pass decides the
//    deterministic families: D0L if one map leads from some word through all words, DT0L if all maps together do; P asks the
//    same of the maps that erase nothing.
// 3. A closed table (a set of images for each letter) chooses only among closed maps: if u is an image of x in it, some closed
//    map has h(x) = u. So the maps leave a pool of rules for the other families, and pairs of rules that no map has together.
// 4. T0L: a step w -> v can be taken if the rules that it uses are in some closed table. Fewer rules are closed if more are, so a
//    table is looked for that has these rules and one image for each other letter. Steps are looked for only where they lead
//    into a set of words that nothing enters so far; two sets that no step enters refute the family.
// 5. 0L: one closed table must do it all. Rules are taken out: where a derivation leaves the language, one of the rules that it
//    uses must go (a case for each), and with fewer rules fewer words are reached, so a case without an axiom that reaches all
//    words is refuted.
//
// Cheap things come first. With ε and another word a language is in no propagating family. The families include each other as
// their names say (PD0L in D0L in 0L in T0L, ...), so a yes or no for one is one for others: the order is D, DT, T, 0L. A language is in
// a family if its reversal is, and if one that differs by names of letters is, so those that are known are found again.
//
// Subtle: a conflict that begins in the middle of a word is one whatever the rest of the word becomes, because every letter has some image; so
// only the rules of the beginning are in it. The bounds are counts, never seconds: whether a language is decided does not depend
// on the machine.

namespace algae {

namespace {

using Families = FamilyVerdicts::Families;

constexpr std::uint32_t none = 0xffffffff;
constexpr std::size_t most_words = 64, most_letters = 64, most_letters_in_all = 400,
                      most_maps = 100'000, most_known = 50'000;
constexpr std::uint64_t most_steps = 20'000'000;

/// Thrown where a bound of the method is reached.
struct TooMuch {};

constexpr std::uint64_t bit(std::size_t i) { return std::uint64_t{1} << i; }

std::size_t lowest(std::uint64_t set) { return static_cast<std::size_t>(__builtin_ctzll(set)); }

// Places in all_families().
enum : unsigned { o, po, d, pd, t, pt, dt, pdt };
constexpr Families all_of_them = 0xff;

/// What being in the family says of the others, itself included.
constexpr std::array<Families, 8> includes{1u << o | 1u << t,
                                           1u << po | 1u << o | 1u << pt | 1u << t,
                                           1u << d | 1u << o | 1u << dt | 1u << t,
                                           all_of_them,
                                           1u << t,
                                           1u << pt | 1u << t,
                                           1u << dt | 1u << t,
                                           1u << pdt | 1u << pt | 1u << dt | 1u << t};

/// By word, the words that it gives in one step.
using Steps = std::array<std::uint64_t, most_words>;

}  // namespace

/// The search for one language after the other; tables are kept from one to the next.
class FamilyVerdicts::Search {
public:
    /// At least one word that is not empty.
    std::optional<Families> families(const std::vector<Word>& words, const Budget& budget) {
        budget_ = &budget;
        steps_done_ = 0;
        if (!read(words)) return std::nullopt;
        try {
            return decide();
        } catch (const TooMuch&) {
            return std::nullopt;
        }
    }

private:
    // --- The words as a tree ---

    bool read(const std::vector<Word>& words) {
        count_ = words.size();
        if (count_ > most_words) return false;
        all_words_ = count_ == 64 ? ~std::uint64_t{0} : bit(count_) - 1;
        std::size_t length = 0;
        for (const Word& word : words) length += word.size();
        if (length > most_letters_in_all) return false;
        order_.resize(count_);
        std::iota(order_.begin(), order_.end(), std::size_t{0});
        std::sort(order_.begin(), order_.end(), [&](std::size_t left, std::size_t right) {
            return words[left].size() < words[right].size();
        });
        names_.clear();
        text_.clear();
        start_.assign(1, 0);
        empty_ = none;
        for (std::size_t w = 0; w < count_; ++w) {
            const Word& word = words[order_[w]];
            if (word.empty()) empty_ = static_cast<std::uint32_t>(w);
            for (const Symbol a : word) {
                auto place = std::find(names_.begin(), names_.end(), a);
                if (place == names_.end()) {
                    if (names_.size() == most_letters) return false;
                    place = names_.insert(place, a);
                }
                text_.push_back(static_cast<std::uint8_t>(place - names_.begin()));
            }
            start_.push_back(static_cast<std::uint32_t>(text_.size()));
        }
        letters_ = names_.size();
        children_.assign(letters_, none);
        word_at_.assign(1, none);
        factor_.assign(1, {0, 0});
        // Beginnings first: they are the nodes below begins_.
        for (std::uint32_t w = 0; w < count_; ++w) word_at_[insert(start_[w], start_[w + 1])] = w;
        begins_ = static_cast<std::uint32_t>(word_at_.size());
        for (std::uint32_t w = 0; w < count_; ++w)
            for (std::uint32_t from = start_[w] + 1; from < start_[w + 1]; ++from)
                insert(from, start_[w + 1]);
        return true;
    }

    std::uint32_t insert(std::uint32_t from, std::uint32_t end) {
        std::uint32_t node = 0;
        for (std::uint32_t i = from; i < end; ++i) {
            const std::size_t place = node * letters_ + text_[i];
            if (children_[place] == none) {
                children_[place] = static_cast<std::uint32_t>(word_at_.size());
                word_at_.push_back(none);
                factor_.push_back({from, i + 1});
                children_.resize(children_.size() + letters_, none);
            }
            node = children_[place];
        }
        return node;
    }

    /// The beginning that a beginning and a factor after it make, or none.
    std::uint32_t after(std::uint32_t node, std::uint32_t image) const {
        const auto [from, end] = factor_[image];
        for (std::uint32_t i = from; i < end; ++i) {
            node = children_[node * letters_ + text_[i]];
            if (node >= begins_) return none;
        }
        return node;
    }

    void tick() {
        if (++steps_done_ > most_steps) throw TooMuch();
        if (steps_done_ % 65'536 == 0) budget_->check();
    }

    // --- The families ---

    Families decide() {
        in_ = 0;
        open_ = all_of_them;
        if (count_ > 1 && empty_ != none) refuse(1u << po | 1u << pd | 1u << pt | 1u << pdt);
        find_maps();
        if (open_ == 0) return in_;
        refuse(1u << d | 1u << pd);
        for (const bool propagating : {true, false}) {
            const unsigned family = propagating ? pdt : dt;
            if (open_ & 1u << family) settle(family, reaches_all(taken_[propagating]));
        }
        for (const bool propagating : {false, true}) {
            const unsigned tables = propagating ? pt : t, one = propagating ? po : o;
            if ((open_ & (1u << tables | 1u << one)) == 0) continue;
            make_pool(propagating);
            if (open_ & 1u << tables) settle(tables, by_tables(taken_[propagating]));
            if (open_ & 1u << one) settle(one, by_rules());
        }
        return in_;
    }

    void settle(unsigned family, bool holds) {
        if (holds) {
            in_ |= includes[family];
            open_ &= ~includes[family];
            return;
        }
        Families out = 0;  // what would include it is decided before; what it includes is out too
        for (unsigned other = 0; other < 8; ++other)
            if (includes[other] & 1u << family) out |= 1u << other;
        refuse(out);
    }
    void refuse(Families families) { open_ &= ~families; }

    // --- Closed maps ---

    void find_maps() {
        maps_.clear();
        for (Steps& steps : taken_) std::fill_n(steps.begin(), count_, 0);
        image_.assign(letters_, none);
        found_one_ = false;
        follow(0, 0, 0);
    }

    /// Goes on with a word at a letter whose beginning has gone to a node. False ends the search.
    bool follow(std::uint32_t w, std::uint32_t position, std::uint32_t node) {
        for (;;) {
            tick();
            if (start_[w] + position == start_[w + 1]) {
                if (word_at_[node] == none) return true;
                to_[w] = word_at_[node];
                if (++w == count_) return keep_map();
                position = node = 0;
                continue;
            }
            const std::uint8_t x = text_[start_[w] + position];
            if (image_[x] == none) {
                const bool goes_on = choose(x, 0, node, w, position + 1);
                image_[x] = none;
                return goes_on;
            }
            node = after(node, image_[x]);
            if (node == none) return true;
            ++position;
        }
    }

    bool choose(std::uint8_t x, std::uint32_t image, std::uint32_t node, std::uint32_t w,
                std::uint32_t position) {
        image_[x] = image;
        if (!follow(w, position, node)) return false;
        for (std::size_t a = 0; a < letters_; ++a) {
            const std::uint32_t below = children_[node * letters_ + a];
            if (below < begins_ && !choose(x, children_[image * letters_ + a], below, w, position))
                return false;
        }
        return true;
    }

    bool keep_map() {
        const bool propagating = std::find(image_.begin(), image_.end(), 0u) == image_.end();
        for (std::uint32_t w = 0; w < count_; ++w) {
            taken_[0][w] |= bit(to_[w]);
            if (propagating) taken_[1][w] |= bit(to_[w]);
        }
        if ((open_ & (1u << d | 1u << pd)) && (!found_one_ || propagating) && goes_through_all()) {
            settle(propagating ? pd : d, true);
            found_one_ = true;
            if (open_ == 0) return false;
        }
        if (maps_.size() == most_maps * letters_) throw TooMuch();
        maps_.insert(maps_.end(), image_.begin(), image_.end());
        return true;
    }

    /// Whether the map leads from some word through all words.
    bool goes_through_all() const {
        std::uint64_t entered = 0;
        for (std::uint32_t w = 0; w < count_; ++w) entered |= bit(to_[w]);
        const std::uint64_t starts = all_words_ & ~entered;
        if (starts & (starts - 1)) return false;
        std::uint64_t seen = 0;
        std::uint32_t word = starts ? static_cast<std::uint32_t>(lowest(starts)) : 0;
        while (!(seen & bit(word))) {
            seen |= bit(word);
            word = to_[word];
        }
        return seen == all_words_;
    }

    // --- Steps of words ---

    /// The words that can be reached from a word, itself included.
    std::uint64_t reached(const Steps& steps, std::size_t from) const {
        std::uint64_t seen = bit(from), open = seen;
        while (open) {
            const std::size_t w = lowest(open);
            open &= open - 1;
            const std::uint64_t fresh = steps[w] & ~seen;
            seen |= fresh;
            open |= fresh;
        }
        return seen;
    }

    /// Whether all words can be reached from some word. (The empty word reaches itself only.)
    bool reaches_all(const Steps& steps) const {
        std::uint64_t seen = 0;
        std::size_t last = 0;
        for (std::size_t w = 0; w < count_; ++w) {
            if (seen & bit(w)) continue;
            seen |= reached(steps, w);
            last = w;
        }
        return reached(steps, last) == all_words_;
    }

    /// A set of words that reach each other and that no other word reaches, not one of those in `entered_by_none`.
    std::uint64_t source(const Steps& steps, std::uint64_t entered_by_none) const {
        std::array<std::uint64_t, most_words> from_here;
        for (std::size_t w = 0; w < count_; ++w) from_here[w] = reached(steps, w);
        for (std::size_t v = 0; v < count_; ++v) {
            if (entered_by_none & bit(v)) continue;
            std::uint64_t ancestors = 0;
            for (std::size_t w = 0; w < count_; ++w)
                if (from_here[w] & bit(v)) ancestors |= bit(w);
            if ((ancestors & ~from_here[v]) == 0) return ancestors;
        }
        return 0;
    }

    // --- The pool of rules ---

    /// Sets of rules: for each letter, images by their places in the letter's pool.
    using Rules = std::array<std::uint64_t, most_letters>;

    /// The rules that closed maps have, and which map has which.
    void make_pool(bool propagating) {
        pool_.resize(std::max(pool_.size(), letters_));
        for (std::size_t x = 0; x < letters_; ++x) pool_[x].clear();
        choices_.clear();
        for (std::size_t m = 0; m < maps_.size(); m += letters_) {
            const auto* map = &maps_[m];
            if (propagating && std::find(map, map + letters_, 0u) != map + letters_) continue;
            for (std::size_t x = 0; x < letters_; ++x) {
                auto& images = pool_[x];
                auto place = std::find(images.begin(), images.end(), map[x]);
                if (place == images.end()) {
                    if (images.size() == 64) throw TooMuch();
                    place = images.insert(place, map[x]);
                }
                choices_.push_back(static_cast<std::uint8_t>(place - images.begin()));
            }
        }
        first_rule_.assign(1, 0);
        for (std::size_t x = 0; x < letters_; ++x)
            first_rule_.push_back(first_rule_.back() + pool_[x].size());
        goes_.resize(first_rule_.back() * begins_);
        for (std::size_t x = 0; x < letters_; ++x)
            for (std::size_t i = 0; i < pool_[x].size(); ++i)
                for (std::uint32_t node = 0; node < begins_; ++node)
                    goes_[(first_rule_[x] + i) * begins_ + node] = after(node, pool_[x][i]);
    }

    std::uint32_t goes(std::size_t x, std::size_t i, std::uint32_t node) const {
        return goes_[(first_rule_[x] + i) * begins_ + node];
    }

    Rules whole_pool() const {
        Rules rules{};
        for (std::size_t x = 0; x < letters_; ++x)
            rules[x] = pool_[x].size() == 64 ? ~std::uint64_t{0} : bit(pool_[x].size()) - 1;
        return rules;
    }

    /// Takes out rules that no closed map has together with each rule that must be there. False if a letter has none left
    /// or a rule that must be there is out.
    bool filter(Rules& possible, const Rules& there) {
        const std::size_t rules = first_rule_.back();
        for (;;) {
            together_.assign(rules * letters_, 0);
            for (std::size_t m = 0; m < choices_.size(); m += letters_) {
                tick();
                const auto* choice = &choices_[m];
                bool inside = true;
                for (std::size_t x = 0; x < letters_ && inside; ++x)
                    inside = possible[x] & bit(choice[x]);
                if (!inside) continue;
                for (std::size_t x = 0; x < letters_; ++x) {
                    std::uint64_t* row = &together_[(first_rule_[x] + choice[x]) * letters_];
                    for (std::size_t y = 0; y < letters_; ++y) row[y] |= bit(choice[y]);
                }
            }
            bool changed = false;
            for (std::size_t x = 0; x < letters_; ++x) {
                for (std::uint64_t left = possible[x]; left; left &= left - 1) {
                    const std::size_t i = lowest(left);
                    const std::uint64_t* row = &together_[(first_rule_[x] + i) * letters_];
                    bool stays = row[x] != 0;
                    for (std::size_t y = 0; y < letters_ && stays; ++y)
                        stays = y == x || (there[y] & ~row[y]) == 0;
                    if (stays) continue;
                    possible[x] &= ~bit(i);
                    changed = true;
                }
                if (possible[x] == 0 || (there[x] & ~possible[x])) return false;
            }
            if (!changed) return true;
        }
    }

    struct Rule {
        std::uint8_t letter, image;
        bool operator==(const Rule&) const = default;
    };
    /// Rules of which not all can be there, without those that must be; `found` if there are any.
    struct Conflict {
        bool found = false;
        std::vector<Rule> open;
    };

    /// The steps within the language by these rules, and a conflict with few open rules; if that has at most one, not all
    /// steps.
    void look(const Rules& possible, const Rules& there, Steps& steps, Conflict& conflict) {
        conflict.found = false;
        std::uint32_t best = none;
        std::fill_n(steps.begin(), count_, 0);
        for (std::uint32_t w = 0; w < count_ && (!conflict.found || best > 1); ++w) {
            const std::uint32_t length = start_[w + 1] - start_[w];
            layers_.resize(std::max<std::size_t>(layers_.size(), length + 1));
            for (std::uint32_t i = 0; i <= length; ++i) layers_[i].clear();
            layers_[0].push_back({0, 0, 0, 0});
            for (std::uint32_t i = 0; i < length; ++i) {
                const std::uint8_t x = text_[start_[w] + i];
                place_.assign(begins_, none);
                for (std::uint32_t from = 0; from < layers_[i].size(); ++from) {
                    const Reached here = layers_[i][from];
                    for (std::uint64_t left = possible[x]; left; left &= left - 1) {
                        tick();
                        const auto image = static_cast<std::uint8_t>(lowest(left));
                        const std::uint32_t cost = here.cost + (there[x] & bit(image) ? 0 : 1);
                        const std::uint32_t node = goes(x, image, here.node);
                        if (node == none) {
                            if (cost < best)
                                best = trace(w, i, from, Rule{x, image}, there, conflict);
                        } else if (place_[node] == none) {
                            place_[node] = static_cast<std::uint32_t>(layers_[i + 1].size());
                            layers_[i + 1].push_back({node, from, cost, image});
                        } else if (cost < layers_[i + 1][place_[node]].cost) {
                            layers_[i + 1][place_[node]] = {node, from, cost, image};
                        }
                    }
                }
            }
            for (std::uint32_t from = 0; from < layers_[length].size(); ++from) {
                const Reached& end = layers_[length][from];
                if (word_at_[end.node] != none)
                    steps[w] |= bit(word_at_[end.node]);
                else if (end.cost < best)
                    best = trace(w, length, from, std::nullopt, there, conflict);
            }
        }
    }

    /// Collects the open rules on the way to a place, and the last one; how many they are.
    std::uint32_t trace(std::uint32_t w, std::uint32_t layer, std::uint32_t place,
                        std::optional<Rule> last, const Rules& there, Conflict& conflict) {
        conflict.found = true;
        conflict.open.clear();
        const auto add = [&](Rule rule) {
            if (!(there[rule.letter] & bit(rule.image)) &&
                std::find(conflict.open.begin(), conflict.open.end(), rule) == conflict.open.end())
                conflict.open.push_back(rule);
        };
        if (last) add(*last);
        for (; layer > 0; --layer) {
            const Reached& here = layers_[layer][place];
            add({text_[start_[w] + layer - 1], here.image});
            place = here.from;
        }
        return static_cast<std::uint32_t>(conflict.open.size());
    }

    /// Whether some of these rules, with all that must be there, are closed, and together with `others` reach all words
    /// if `generating`; then `steps` are those of a closed table.
    bool solve(Rules possible, Rules there, bool generating, Steps& steps) {
        for (;;) {
            if (!filter(possible, there)) return false;
            Conflict conflict;
            look(possible, there, steps, conflict);
            if (conflict.found && conflict.open.empty()) return false;
            if (conflict.found && conflict.open.size() == 1) {
                const Rule only = conflict.open.front();
                possible[only.letter] &= ~bit(only.image);
                continue;
            }
            if (generating && !reaches_all(steps)) return false;
            if (!conflict.found) return true;
            // One of them goes; those before it stay.
            for (std::size_t i = 0; i + 1 < conflict.open.size(); ++i) {
                const Rule rule = conflict.open[i];
                Rules fewer = possible;
                fewer[rule.letter] &= ~bit(rule.image);
                if (solve(fewer, there, generating, steps)) return true;
                there[rule.letter] |= bit(rule.image);
            }
            const Rule last = conflict.open.back();
            possible[last.letter] &= ~bit(last.image);
        }
    }

    bool by_rules() {
        Steps steps;
        return !choices_.empty() && solve(whole_pool(), Rules{}, true, steps);
    }

    // --- Tables ---

    bool by_tables(Steps steps) {
        if (choices_.empty()) return false;
        std::uint64_t entered_by_none = 0;
        Rules everything = whole_pool();
        if (!filter(everything, Rules{})) return false;
        pairs_ = together_;
        for (;;) {
            if (reaches_all(steps)) return true;
            const std::uint64_t set = source(steps, entered_by_none);
            if (enter(set, steps)) continue;
            // Nothing enters this set, so the axiom is in it, and no other set is like it.
            if (entered_by_none != 0 || (empty_ != none && set == bit(empty_))) return false;
            entered_by_none = set;
        }
    }

    /// Adds the steps of a table with a step from outside into the set, if there is one.
    bool enter(std::uint64_t set, Steps& steps) {
        for (std::uint32_t from = 0; from < count_; ++from) {
            if (set & bit(from)) continue;
            for (std::uint64_t left = set; left; left &= left - 1) {
                Rules used{};
                if (step(from, static_cast<std::uint32_t>(lowest(left)), 0, 0, used, steps))
                    return true;
            }
        }
        return false;
    }

    /// Looks for images of the letters of a word from a position on that make the rest of another word, by rules
    /// that some closed table has together.
    bool step(std::uint32_t from, std::uint32_t to, std::uint32_t position, std::uint32_t done,
              Rules& used, Steps& steps) {
        tick();
        const std::uint32_t length = start_[to + 1] - start_[to];
        if (start_[from] + position == start_[from + 1]) {
            if (done != length) return false;
            Rules possible = whole_pool();
            for (std::size_t x = 0; x < letters_; ++x)
                if (used[x]) possible[x] = used[x];
            Steps more;
            if (!solve(possible, used, false, more)) return false;
            for (std::size_t w = 0; w < count_; ++w) steps[w] |= more[w];
            return true;
        }
        const std::uint8_t x = text_[start_[from] + position];
        for (std::size_t i = 0; i < pool_[x].size(); ++i) {
            const auto [first, end] = factor_[pool_[x][i]];
            const std::uint32_t next = done + end - first;
            if (next > length || !std::equal(text_.data() + first, text_.data() + end,
                                             text_.data() + start_[to] + done))
                continue;
            const std::uint64_t* row = &pairs_[(first_rule_[x] + i) * letters_];
            bool fits = true;
            for (std::size_t y = 0; y < letters_ && fits; ++y)
                fits = y == x || (used[y] & ~row[y]) == 0;
            if (!fits) continue;
            const std::uint64_t before = used[x];
            used[x] |= bit(i);
            const bool found = step(from, to, position + 1, next, used, steps);
            used[x] = before;
            if (found) return true;
        }
        return false;
    }

    const Budget* budget_ = nullptr;
    std::uint64_t steps_done_ = 0;
    Families in_ = 0, open_ = 0;

    // The words, shorter ones first, and the tree of their factors; node 0 is ε, nodes below begins_ are beginnings.
    std::size_t count_ = 0, letters_ = 0;
    std::uint64_t all_words_ = 0;
    std::uint32_t empty_ = none, begins_ = 0;
    std::vector<std::size_t> order_;
    std::vector<Symbol> names_;
    std::vector<std::uint8_t> text_;
    std::vector<std::uint32_t> start_, children_, word_at_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> factor_;  // from, end in text_

    // Closed maps, and the steps they take: all of them, and those that erase nothing.
    std::vector<std::uint32_t> image_, maps_;
    std::array<std::uint32_t, most_words> to_{};
    std::array<Steps, 2> taken_{};
    bool found_one_ = false;

    // The pool, and where each rule leads from each beginning.
    std::vector<std::vector<std::uint32_t>> pool_;
    std::vector<std::uint8_t> choices_;
    std::vector<std::size_t> first_rule_;
    std::vector<std::uint32_t> goes_;
    std::vector<std::uint64_t> together_, pairs_;

    // A word's way through the beginnings.
    struct Reached {
        std::uint32_t node, from, cost;
        std::uint8_t image;
    };
    std::vector<std::vector<Reached>> layers_;
    std::vector<std::uint32_t> place_;
};

FamilyVerdicts::FamilyVerdicts(bool empty_axiom)
    : search_(std::make_unique<Search>()), empty_axiom_(empty_axiom) {}
FamilyVerdicts::~FamilyVerdicts() = default;
FamilyVerdicts::FamilyVerdicts(FamilyVerdicts&&) noexcept = default;
FamilyVerdicts& FamilyVerdicts::operator=(FamilyVerdicts&&) noexcept = default;

std::optional<Families> FamilyVerdicts::of(const std::vector<Word>& words, const Budget& budget) {
    if (words.empty()) return 0u;
    if (words.size() == 1 && words.front().empty()) return empty_axiom_ ? all_of_them : 0u;
    if (words.size() > most_words) return std::nullopt;
    std::size_t length = 0;
    for (const Word& word : words) length += word.size();
    // Of longer languages few are alike, and their text takes longer.
    constexpr std::size_t most_in_text = 48;
    std::string text;
    if (length <= most_in_text) {
        std::vector<Word> reversed;
        reversed.reserve(words.size());
        for (const Word& word : words) reversed.emplace_back(word.rbegin(), word.rend());
        text = std::min(up_to_renaming(words), up_to_renaming(reversed));
        const auto found = known_.find(text);
        if (found != known_.end()) return found->second;
    }
    const std::optional<Families> families = search_->families(words, budget);
    if (families && !text.empty()) {
        if (known_.size() == most_known) known_.clear();
        known_.emplace(std::move(text), *families);
    }
    return families;
}

// --- Up to renaming ---

namespace {

std::uint64_t mixed(std::uint64_t value) {  // the finalizer of splitmix64
    value += 0x9e3779b97f4a7c15;
    value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9;
    value = (value ^ (value >> 27)) * 0x94d049bb133111eb;
    return value ^ (value >> 31);
}

/// Numbers for letters that no renaming changes: where letters occur in words, and beside which others.
std::vector<std::uint64_t> marks(const std::vector<std::string>& words, std::size_t letters) {
    std::vector<std::uint64_t> now(letters, 1);
    for (std::size_t classes = 1; classes < letters;) {
        std::vector<std::uint64_t> next(letters, 0);
        for (const std::string& word : words) {
            std::uint64_t mark = word.size();
            for (const char x : word) mark = mixed(mark ^ now[static_cast<std::uint8_t>(x)]);
            for (std::size_t i = 0; i < word.size(); ++i)
                next[static_cast<std::uint8_t>(word[i])] += mixed(mark + i);
        }
        for (std::size_t x = 0; x < letters; ++x) now[x] = mixed(now[x] ^ mixed(next[x]));
        std::vector<std::uint64_t> sorted = now;
        std::sort(sorted.begin(), sorted.end());
        const auto different =
            static_cast<std::size_t>(std::unique(sorted.begin(), sorted.end()) - sorted.begin());
        if (different == classes) break;
        classes = different;
    }
    return now;
}

}  // namespace

// Letters that some renaming exchanges have equal marks, so only renamings that order letters by their marks are tried:
// all of these, so that two languages that differ by a renaming try the same. Different letters with equal marks cost time only.
std::string up_to_renaming(const std::vector<Word>& words) {
    std::vector<Symbol> names;
    std::vector<std::string> spelled;
    spelled.reserve(words.size());
    for (const Word& word : words) {
        std::string& letters = spelled.emplace_back();
        for (const Symbol a : word) {
            auto place = std::find(names.begin(), names.end(), a);
            if (place == names.end()) place = names.insert(place, a);
            letters.push_back(static_cast<char>(place - names.begin()));
        }
        if (names.size() > 250)
            throw BoundReached(Bound::method,
                               "a language of more than 250 letters is not put up to renaming");
    }
    const std::vector<std::uint64_t> mark = marks(spelled, names.size());
    std::vector<std::uint8_t> order(
        names.size());  // the letters as they are to be called 1, 2, ...
    std::iota(order.begin(), order.end(), std::uint8_t{0});
    std::sort(order.begin(), order.end(), [&](std::uint8_t left, std::uint8_t right) {
        return std::pair(mark[left], left) < std::pair(mark[right], right);
    });
    std::string least, name(names.size(), '\0');
    std::vector<std::string> renamed(spelled.size());
    bool is_first = true;
    const auto try_order = [&] {
        for (std::size_t i = 0; i < order.size(); ++i) name[order[i]] = static_cast<char>(i + 1);
        for (std::size_t w = 0; w < spelled.size(); ++w) {
            renamed[w].resize(spelled[w].size());
            for (std::size_t i = 0; i < spelled[w].size(); ++i)
                renamed[w][i] = name[static_cast<std::uint8_t>(spelled[w][i])];
        }
        std::sort(
            renamed.begin(), renamed.end(), [](const std::string& left, const std::string& right) {
                return left.size() != right.size() ? left.size() < right.size() : left < right;
            });
        std::string text;
        for (const std::string& word : renamed) {
            text += word;
            text += '\0';
        }
        if (is_first || text < least) least = std::move(text);
        is_first = false;
    };
    const auto permute = [&](auto& self, std::size_t from) -> void {
        std::size_t end = from;
        while (end < order.size() && mark[order[end]] == mark[order[from]]) ++end;
        if (from == order.size()) return try_order();
        const auto first = order.begin() + static_cast<std::ptrdiff_t>(from);
        const auto last = order.begin() + static_cast<std::ptrdiff_t>(end);
        do {
            self(self, end);
        } while (std::next_permutation(first, last));  // ends sorted, as it began
    };
    permute(permute, 0);
    return least;
}

}  // namespace algae
