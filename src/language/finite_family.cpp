#include "language/detail/finite_family.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "exact/exact.hpp"
#include "word/word.hpp"

// Whether some system of a family of L-systems generates exactly a given finite language: the whole search.
//
// It is complete: an image of a letter is a factor of a word of the language, so there are finitely many
// systems. Factors and beginnings of words are numbered first (`FiniteWords`), so that a step of a word is a
// way through a tree of beginnings.
//
// Without tables (`RuleSearch`): a set of possible rules is narrowed from above. A rule goes when no closed
// table has it, which one word or rules known to be there can show. Where a derivation that leaves the language
// uses several rules, one of them must go: the search splits into cases, each with one rule fewer and those
// before it known to be there. In a deterministic family it splits by the image of a letter. Leaving rules out
// keeps the language closed and makes fewer words reachable, so a set from which the language cannot be reached
// needs no more cases.
//
// With tables (`TableSearch`): all closed tables at once. A step from one word to another is possible in some
// closed table or in none; steps are looked for only where they would lead into a set of words that no table
// found so far reaches from outside.
//
// The answer is a system, from which superfluous tables and rules are left out, or an obstruction: the cases
// with the reason why each fails, which the room verify checks again. Exponential in the worst case; the number
// of cases is bounded.

namespace algae {

namespace {

/// A finite language as a tree of beginnings, with every factor of its words numbered: what the
/// search for rules looks at, all in numbers. Letters are numbered by their place in `letters`.
class FiniteWords {
public:
    using Image = std::uint32_t;  // number of a factor
    using Node = std::uint32_t;   // number of a beginning; 0 is the empty one
    static constexpr std::uint32_t none = 0xffffffff;
    struct Step {
        Image image;
        Node end;
    };

    /// Throws BoundReached if the factors take more than the budget's memory. What words share counts once: the factors are
    /// found along the tree of beginnings, one for each beginning and each node above it.
    FiniteWords(const FiniteLanguage& language, const Budget& budget)
        : letters(letters_of(language)) {
        constexpr const char* what = "the factors of the words of the language";
        std::uint64_t bytes = 0;
        std::vector<std::uint32_t> number(language.alphabet->size(), none);
        for (std::uint32_t i = 0; i < letters.size(); ++i) number[letters[i]] = i;

        std::vector<std::map<Symbol, Node>> next(1);
        word_at.push_back(none);
        for (const Word& word : language.words) {
            auto& spelled = words.emplace_back();
            auto& path = node_path.emplace_back(1, 0);
            for (const Symbol a : word) {
                spelled.push_back(number[a]);
                const auto [place, is_new] =
                    next[path.back()].try_emplace(a, static_cast<Node>(next.size()));
                const Node node = place->second;
                if (is_new) {
                    next.emplace_back();
                    word_at.push_back(none);
                    bytes += path.size() * sizeof(Step);
                }
                path.push_back(node);
            }
            budget.check_memory(bytes, what);
            word_at[path.back()] = static_cast<std::uint32_t>(words.size() - 1);
        }

        const auto shorter = [](const Word& left, const Word& right) {
            return shortlex_less(left, right);
        };
        std::map<Word, Image, decltype(shorter)> numbered(shorter);
        // Calls use(image, end) with every factor that leads from a beginning to another one.
        const auto each_below = [&](Node start, const auto& use) {
            budget.check();
            std::vector<std::pair<Word, Node>> open{{Word{}, start}};
            while (!open.empty()) {
                const auto [image, node] = std::move(open.back());
                open.pop_back();
                use(image, node);
                for (const auto& [symbol, child] : next[node]) {
                    Word longer = image;
                    longer.push_back(symbol);
                    open.emplace_back(std::move(longer), child);
                }
            }
        };
        for (Node start = 0; start < next.size(); ++start) {
            each_below(start, [&](const Word& image, Node) {
                if (numbered.try_emplace(image, 0).second)
                    bytes += 2 * image.size() * sizeof(Symbol) + 100;  // here and in `images`
            });
            budget.check_memory(bytes, what);
        }
        for (auto& [image, place] : numbered) {
            place = static_cast<Image>(images.size());
            images.push_back(image);
        }

        below.resize(next.size());
        for (Node start = 0; start < next.size(); ++start) {
            each_below(start, [&](const Word& image, Node end) {
                below[start].push_back({numbered.at(image), end});
            });
            std::sort(below[start].begin(), below[start].end(),
                      [](const Step& left, const Step& right) { return left.image < right.image; });
        }
    }

    std::vector<Symbol> letters;
    std::vector<std::vector<std::uint32_t>> words;  // with letters by number
    std::vector<Word> images;              // shorter ones first; images[0] is the empty word
    std::vector<std::vector<Step>> below;  // by node: every image that leads on, and where
    std::vector<std::uint32_t> word_at;    // by node: the word that ends there, or none
    std::vector<std::vector<std::uint32_t>> node_path;  // by word: the nodes of its beginnings

    std::size_t count() const { return words.size(); }
};

/// Which rules of a table may still be there, and which are known to be, by letter and image number.
struct PossibleRules {
    std::vector<std::vector<char>> possible;
    std::vector<std::vector<char>> there;
};

/// By word: the words it gives in one step.
using StepRelation = std::vector<std::vector<char>>;

/// The search for rules under which a finite language is closed, and, if wanted, from one word of which all
/// others come. What is ruled out is written down as an ObstructionCase.
class RuleSearch {
public:
    using Image = FiniteWords::Image;
    using Node = FiniteWords::Node;

    /// `cases` bounds the number of cases; throws BoundReached beyond it. All arguments must
    /// outlive the search.
    RuleSearch(const FiniteLanguage& language, const FiniteWords& words, Family family,
               bool empty_axiom, std::uint64_t cases, const Budget& budget)
        : language_(language),
          words_(words),
          family_(family),
          empty_axiom_(empty_axiom),
          cases_(cases),
          budget_(budget),
          chosen_(words.letters.size(), FiniteWords::none) {}

    /// All factors as images of all letters, but the empty word in a propagating family.
    PossibleRules all_rules() const {
        const std::vector<std::vector<char>> all(words_.letters.size(),
                                                 std::vector<char>(words_.images.size(), 1));
        PossibleRules rules{all, {}};
        rules.there.assign(all.size(), std::vector<char>(words_.images.size(), 0));
        if (family_.propagating)
            for (auto& images : rules.possible) images[0] = 0;
        return rules;
    }

    /// Whether some of the rules, with all that are `there`, keep the language closed and, with
    /// `generating`, generate it. Then `rules` becomes such a set; otherwise `why` says why not.
    bool narrow_to_solution(PossibleRules& rules, bool generating, ObstructionCase& why) {
        if (cases_ == 0)
            throw BoundReached(
                Bound::method,
                "the bound on the number of cases was reached before the answer was known");
        --cases_;
        budget_.check();
        if (!narrow(rules, why)) return false;
        if (generating) {
            if (const auto sets = unreached(steps(rules))) {
                why.end = ObstructionCase::End::sources;
                why.sources = spelled(*sets);
                return false;
            }
        }
        return family_.deterministic ? split_by_choice(rules, generating, why)
                                     : split_by_departure(rules, generating, why);
    }

    /// The steps between words of the language by these rules; in a deterministic family each letter
    /// has one image throughout a step.
    StepRelation steps(const PossibleRules& rules) {
        StepRelation relation(words_.count(), std::vector<char>(words_.count(), 0));
        for (std::uint32_t w = 0; w < words_.count(); ++w) {
            if (family_.deterministic) {
                land_everywhere(w, 0, 0, rules, relation[w]);
                continue;
            }
            std::vector<char> reached(words_.below.size(), 0);
            std::vector<Node> nodes{0};
            for (const std::uint32_t letter : words_.words[w]) {
                std::vector<Node> next;
                std::fill(reached.begin(), reached.end(), 0);
                for (const Node node : nodes)
                    for (const auto& [image, end] : words_.below[node]) {
                        tick();
                        if (!rules.possible[letter][image] || reached[end]) continue;
                        reached[end] = 1;
                        next.push_back(end);
                    }
                nodes = std::move(next);
            }
            for (const Node node : nodes)
                if (words_.word_at[node] != FiniteWords::none)
                    relation[w][words_.word_at[node]] = 1;
        }
        return relation;
    }

    /// The disjoint sets of words, none reached from outside it, that show that no axiom gives all
    /// words; nothing if some axiom does. Smaller sets first.
    std::optional<std::vector<std::vector<std::uint32_t>>> unreached(
        const StepRelation& relation) const {
        return ruling_out(sources(relation));
    }

    /// The smallest sets of words that give each other and that nothing else gives.
    static std::vector<std::vector<std::uint32_t>> sources(const StepRelation& relation) {
        const auto size = static_cast<std::uint32_t>(relation.size());
        StepRelation ancestors(size, std::vector<char>(size, 0));
        for (std::uint32_t v = 0; v < size; ++v) {
            std::vector<std::uint32_t> open{v};
            ancestors[v][v] = 1;
            while (!open.empty()) {
                const std::uint32_t to = open.back();
                open.pop_back();
                for (std::uint32_t from = 0; from < size; ++from)
                    if (relation[from][to] && !ancestors[v][from]) {
                        ancestors[v][from] = 1;
                        open.push_back(from);
                    }
            }
        }
        std::vector<std::vector<std::uint32_t>> sets;
        for (std::uint32_t v = 0; v < size; ++v) {
            std::vector<std::uint32_t> set;
            bool closed = true;  // all ancestors come from v too, and v is the first of them
            for (std::uint32_t w = 0; w < size && closed; ++w) {
                if (!ancestors[v][w]) continue;
                closed = w >= v && ancestors[w][v];
                set.push_back(w);
            }
            if (closed) sets.push_back(std::move(set));
        }
        std::stable_sort(sets.begin(), sets.end(), [](const auto& left, const auto& right) {
            return left.size() < right.size();
        });
        return sets;
    }

    /// Those of these sets, none reached from outside it, that rule every axiom out; or nothing.
    std::optional<std::vector<std::vector<std::uint32_t>>> ruling_out(
        const std::vector<std::vector<std::uint32_t>>& closed_sets) const {
        using Sets = std::vector<std::vector<std::uint32_t>>;
        if (words_.count() == 0) return Sets{};
        for (const auto& set : closed_sets)
            if (!empty_axiom_ && set.size() == 1 && language_.words[set.front()].empty())
                return Sets{set};
        if (closed_sets.size() > 1) return Sets{closed_sets[0], closed_sets[1]};
        return std::nullopt;
    }

    /// Takes out rules that are in no closed table, until neither one word nor rules known to be
    /// there show any more. False if none can be closed; then `why` has an end.
    bool narrow(PossibleRules& rules, ObstructionCase& why) {
        open_departure_.reset();
        for (;;) {
            if (!narrow_by_words(rules, why)) return false;
            if (family_.deterministic) return true;
            open_departure_ = departure(rules);
            if (!open_departure_ || open_departure_->open.size() > 1) return true;
            const Departure step = *std::exchange(open_departure_, std::nullopt);
            if (step.open.empty()) {
                why.end = ObstructionCase::End::conflict;
                why.word = language_.words[step.word];
                why.images = spelled_images(step.images);
                return false;
            }
            const Pair pair = step.open.front();
            if (!exclude(rules, why, pair,
                         {rule(pair.letter, pair.image), language_.words[step.word],
                          spelled_images(step.images)}))
                return false;
        }
    }

    LetterRule rule(std::uint32_t letter, Image image) const {
        return {words_.letters[letter], words_.images[image]};
    }

    std::vector<std::vector<Word>> spelled(
        const std::vector<std::vector<std::uint32_t>>& sets) const {
        std::vector<std::vector<Word>> all;
        for (const auto& set : sets) {
            auto& spelled_set = all.emplace_back();
            for (const std::uint32_t word : set) spelled_set.push_back(language_.words[word]);
        }
        return all;
    }
    const FiniteWords& words() const { return words_; }
    bool is_deterministic() const { return family_.deterministic; }

private:
    struct Pair {
        std::uint32_t letter;
        Image image;
        auto operator<=>(const Pair&) const = default;
    };
    /// A derivation step out of the language.
    struct Departure {
        std::uint32_t word = 0;
        std::vector<Image> images;
        std::vector<Pair> open;  // the rules it uses that are not known to be there
    };

    /// Every closed table has, for each of its rules and each word, a choice of one rule for each letter
    /// that sends the word into the language.
    bool narrow_by_words(PossibleRules& rules, ObstructionCase& why) {
        std::vector<std::vector<char>> seen(words_.letters.size());
        for (bool changed = true; changed;) {
            changed = false;
            for (std::uint32_t w = 0; w < words_.count(); ++w) {
                std::vector<std::uint32_t> occurring = words_.words[w];
                std::sort(occurring.begin(), occurring.end());
                occurring.erase(std::unique(occurring.begin(), occurring.end()), occurring.end());
                for (const std::uint32_t x : occurring) seen[x].assign(words_.images.size(), 0);
                for (const std::uint32_t x : occurring)
                    for (Image u = 0; u < words_.images.size(); ++u) {
                        if (!rules.possible[x][u] || seen[x][u]) continue;
                        chosen_[x] = u;
                        const bool found = lands(w, 0, 0, rules);
                        for (const std::uint32_t y : occurring)
                            if (found) seen[y][chosen_[y]] = 1;
                        for (const std::uint32_t y : occurring) chosen_[y] = FiniteWords::none;
                        if (found) continue;
                        changed = true;
                        if (!exclude(rules, why, {x, u}, {rule(x, u), language_.words[w], {}}))
                            return false;
                    }
            }
        }
        return true;
    }

    bool lands(std::uint32_t word, std::size_t position, Node node, const PossibleRules& rules) {
        tick();
        const auto& letters = words_.words[word];
        while (position < letters.size() && chosen_[letters[position]] != FiniteWords::none) {
            node = after(node, chosen_[letters[position++]]);
            if (node == FiniteWords::none) return false;
        }
        if (position == letters.size()) return words_.word_at[node] != FiniteWords::none;
        const std::uint32_t letter = letters[position];
        for (const auto& [image, end] : words_.below[node]) {
            if (!rules.possible[letter][image]) continue;
            chosen_[letter] = image;
            if (lands(word, position + 1, end, rules)) return true;
        }
        chosen_[letter] = FiniteWords::none;
        return false;
    }

    bool exclude(PossibleRules& rules, ObstructionCase& why, Pair pair, ExcludedRule reason) {
        why.excluded.push_back(std::move(reason));
        rules.possible[pair.letter][pair.image] = 0;
        if (rules.there[pair.letter][pair.image]) {
            why.end = ObstructionCase::End::needed;
            return false;
        }
        const auto& images = rules.possible[pair.letter];
        if (std::find(images.begin(), images.end(), 1) != images.end()) return true;
        why.end = ObstructionCase::End::no_image;
        why.letter = words_.letters[pair.letter];
        return false;
    }

    std::optional<Departure> departure(const PossibleRules& rules) {
        const auto images = listed(rules);
        std::optional<Departure> best;
        for (std::uint32_t word = 0; word < words_.count(); ++word) {
            if (best && best->open.size() <= 1) break;
            depart(word, rules, images, best);
        }
        return best;
    }

    /// Follows all derivations of one word at once, keeping for every beginning that they give one path
    /// with few rules that are not known to be there. Complete: if some derivation leaves the language,
    /// one of these paths does.
    void depart(std::uint32_t word, const PossibleRules& rules,
                const std::vector<std::vector<Image>>& images, std::optional<Departure>& best) {
        const auto& letters = words_.words[word];
        const auto with = [&](Departure path, std::uint32_t letter, Image image) {
            path.images.push_back(image);
            if (rules.there[letter][image]) return path;
            const Pair pair{letter, image};
            const auto place = std::lower_bound(path.open.begin(), path.open.end(), pair);
            if (place == path.open.end() || *place != pair) path.open.insert(place, pair);
            return path;
        };
        const auto likely = [&](const Departure& path, std::uint32_t letter) {
            for (const Pair& pair : path.open)
                if (pair.letter == letter) return pair.image;
            for (const Image u : images[letter])
                if (rules.there[letter][u]) return u;
            return images[letter].front();
        };
        const auto propose = [&](Departure path) {
            while (path.images.size() < letters.size()) {
                const std::uint32_t letter = letters[path.images.size()];
                const Image image = likely(path, letter);
                path = with(std::move(path), letter, image);
            }
            if (!best || path.open.size() < best->open.size()) best = std::move(path);
        };

        std::map<Node, Departure> paths{{0, Departure{word, {}, {}}}};
        for (const std::uint32_t letter : letters) {
            std::map<Node, Departure> longer;
            for (const auto& [node, path] : paths)
                for (const Image image : images[letter]) {
                    tick();
                    Departure next = with(path, letter, image);
                    const Node end = after(node, image);
                    if (end == FiniteWords::none) {
                        if (!best || next.open.size() < best->open.size()) propose(std::move(next));
                        continue;
                    }
                    const auto place = longer.find(end);
                    if (place == longer.end())
                        longer.emplace(end, std::move(next));
                    else if (next.open.size() < place->second.open.size())
                        place->second = std::move(next);
                }
            paths = std::move(longer);
        }
        for (auto& [node, path] : paths)
            if (words_.word_at[node] == FiniteWords::none) propose(std::move(path));
    }

    bool split_by_departure(PossibleRules& rules, bool generating, ObstructionCase& why) {
        if (!open_departure_) return true;
        const Departure step = *std::exchange(open_departure_, std::nullopt);
        why.end = ObstructionCase::End::conflict;
        why.word = language_.words[step.word];
        why.images = spelled_images(step.images);
        PossibleRules rest = rules;
        for (const Pair& pair : step.open) {
            why.rules.push_back(rule(pair.letter, pair.image));
            PossibleRules without = rest;
            without.possible[pair.letter][pair.image] = 0;
            ObstructionCase part;
            if (narrow_to_solution(without, generating, part)) {
                rules = std::move(without);
                return true;
            }
            why.cases.push_back(std::move(part));
            rest.there[pair.letter][pair.image] = 1;
        }
        return false;
    }

    bool split_by_choice(PossibleRules& rules, bool generating, ObstructionCase& why) {
        const auto images = listed(rules);
        std::optional<std::uint32_t> letter;
        for (std::uint32_t x = 0; x < images.size(); ++x)
            if (images[x].size() > 1 && (!letter || images[x].size() < images[*letter].size()))
                letter = x;
        if (!letter) return true;
        why.end = ObstructionCase::End::choice;
        why.letter = words_.letters[*letter];
        for (const Image u : images[*letter]) {
            why.rules.push_back(rule(*letter, u));
            PossibleRules only = rules;
            only.possible[*letter].assign(words_.images.size(), 0);
            only.possible[*letter][u] = 1;
            ObstructionCase part;
            if (narrow_to_solution(only, generating, part)) {
                rules = std::move(only);
                return true;
            }
            why.cases.push_back(std::move(part));
        }
        return false;
    }

    void land_everywhere(std::uint32_t word, std::size_t position, Node node,
                         const PossibleRules& rules, std::vector<char>& ends) {
        tick();
        const auto& letters = words_.words[word];
        while (position < letters.size() && chosen_[letters[position]] != FiniteWords::none) {
            node = after(node, chosen_[letters[position++]]);
            if (node == FiniteWords::none) return;
        }
        if (position == letters.size()) {
            if (words_.word_at[node] != FiniteWords::none) ends[words_.word_at[node]] = 1;
            return;
        }
        const std::uint32_t letter = letters[position];
        for (const auto& [image, end] : words_.below[node]) {
            if (!rules.possible[letter][image]) continue;
            chosen_[letter] = image;
            land_everywhere(word, position + 1, end, rules, ends);
        }
        chosen_[letter] = FiniteWords::none;
    }

    std::vector<std::vector<Image>> listed(const PossibleRules& rules) const {
        std::vector<std::vector<Image>> images(rules.possible.size());
        for (std::size_t x = 0; x < images.size(); ++x)
            for (Image u = 0; u < words_.images.size(); ++u)
                if (rules.possible[x][u]) images[x].push_back(u);
        return images;
    }

    std::vector<Word> spelled_images(const std::vector<Image>& images) const {
        std::vector<Word> all;
        for (const Image image : images) all.push_back(words_.images[image]);
        return all;
    }

    Node after(Node node, Image image) const {
        const auto& below = words_.below[node];
        const auto place =
            std::lower_bound(below.begin(), below.end(), image,
                             [](const FiniteWords::Step& step, Image u) { return step.image < u; });
        return place != below.end() && place->image == image ? place->end : FiniteWords::none;
    }

    void tick() {
        if (++ticks_ % 4096 == 0) budget_.check();
    }

    const FiniteLanguage& language_;
    const FiniteWords& words_;
    Family family_;
    bool empty_axiom_;
    std::uint64_t cases_;
    const Budget& budget_;
    std::uint64_t ticks_ = 0;
    std::vector<Image> chosen_;                // by letter, while a word is followed
    std::optional<Departure> open_departure_;  // found by narrow, left for the split
};

/// The search for tables: all closed tables at once.
class TableSearch {
public:
    explicit TableSearch(RuleSearch& rules) : rules_(rules) {}

    /// Closed tables that generate the language together, or nothing; then `obstruction` has the
    /// reason in `root` and `impossible`.
    std::vector<PossibleRules> tables(FamilyObstruction& obstruction) {
        all_ = rules_.all_rules();
        steps_.assign(rules_.words().count(), std::vector<char>(rules_.words().count(), 0));
        if (!rules_.narrow(all_, obstruction.root)) return {};  // never: the identity is closed
        PossibleRules first = all_;
        ObstructionCase none;
        if (rules_.narrow_to_solution(first, false, none)) add(std::move(first));
        std::vector<std::vector<std::uint32_t>> entered_by_none;
        for (;;) {
            if (const auto sets = rules_.ruling_out(entered_by_none)) {
                obstruction.root.end = ObstructionCase::End::sources;
                obstruction.root.sources = rules_.spelled(*sets);
                return {};
            }
            const auto sets = RuleSearch::sources(steps_);
            if (!rules_.ruling_out(sets)) return std::move(found_);
            for (const auto& set : sets) {
                if (std::find(entered_by_none.begin(), entered_by_none.end(), set) !=
                    entered_by_none.end())
                    continue;
                if (!enter(set, obstruction)) entered_by_none.push_back(set);
                break;
            }
        }
    }

private:
    using Pair = std::pair<std::uint32_t, FiniteWords::Image>;
    using Set = std::set<Pair>;

    void add(PossibleRules table) {
        const StepRelation more = rules_.steps(table);
        for (std::size_t from = 0; from < more.size(); ++from)
            for (std::size_t to = 0; to < more.size(); ++to) steps_[from][to] |= more[from][to];
        found_.push_back(std::move(table));
    }

    /// Adds a table with a step from outside into the set, if there is one.
    bool enter(const std::vector<std::uint32_t>& set, FamilyObstruction& obstruction) {
        for (std::uint32_t from = 0; from < rules_.words().count(); ++from) {
            if (std::binary_search(set.begin(), set.end(), from)) continue;
            for (const std::uint32_t to : set) {
                Set used;
                if (follow(from, to, 0, 0, used, obstruction)) return true;
            }
        }
        return false;
    }

    bool follow(std::uint32_t from, std::uint32_t to, std::size_t position, std::size_t done,
                Set& used, FamilyObstruction& obstruction) {
        const FiniteWords& words = rules_.words();
        const auto& path = words.node_path[to];
        if (position == words.words[from].size()) {
            if (done + 1 != path.size() || is_impossible(used)) return false;
            PossibleRules table;
            ObstructionCase why;
            if (closes(used, table, why)) {
                add(std::move(table));
                return true;
            }
            rule_out(used, std::move(why), obstruction);
            return false;
        }
        const std::uint32_t letter = words.words[from][position];
        for (const auto& [image, end] : words.below[path[done]]) {
            const std::size_t next = done + words.images[image].size();
            if (next >= path.size() || path[next] != end || !all_.possible[letter][image]) continue;
            if (rules_.is_deterministic()) {
                const auto other = used.lower_bound({letter, 0});
                if (other != used.end() && other->first == letter && other->second != image)
                    continue;
            }
            const bool is_new = used.insert({letter, image}).second;
            const bool entered =
                !is_impossible(used) && follow(from, to, position + 1, next, used, obstruction);
            if (is_new) used.erase({letter, image});
            if (entered) return true;
        }
        return false;
    }

    bool closes(const Set& used, PossibleRules& table, ObstructionCase& why) {
        table = all_;
        for (const auto& [letter, image] : used) {
            if (rules_.is_deterministic())
                std::fill(table.possible[letter].begin(), table.possible[letter].end(), 0);
            table.possible[letter][image] = 1;
            table.there[letter][image] = 1;
        }
        return rules_.narrow_to_solution(table, false, why);
    }

    /// Fewer rules that are impossible together say more, and say it to more steps.
    void rule_out(Set used, ObstructionCase why, FamilyObstruction& obstruction) {
        const Set all = used;
        for (const Pair& pair : all) {
            Set fewer = used;
            fewer.erase(pair);
            PossibleRules table;
            ObstructionCase reason;
            if (fewer.empty() || closes(fewer, table, reason)) continue;
            used = std::move(fewer);
            why = std::move(reason);
        }
        ImpossibleTable& table = obstruction.impossible.emplace_back();
        for (const auto& [letter, image] : used) table.rules.push_back(rules_.rule(letter, image));
        table.why = std::move(why);
        impossible_.push_back(std::move(used));
    }

    bool is_impossible(const Set& used) const {
        return std::any_of(impossible_.begin(), impossible_.end(), [&](const Set& set) {
            return std::includes(used.begin(), used.end(), set.begin(), set.end());
        });
    }

    RuleSearch& rules_;
    PossibleRules all_;
    StepRelation steps_;
    std::vector<PossibleRules> found_;
    std::vector<Set> impossible_;
};

/// Works out a system from closed tables that generate the language together, leaving out tables and
/// rules, long ones first, without which they still do.
class WitnessBuilder {
public:
    WitnessBuilder(RuleSearch& search, std::vector<PossibleRules> tables)
        : search_(search), tables_(std::move(tables)) {
        for (const PossibleRules& table : tables_) steps_.push_back(search_.steps(table));
    }

    FiniteWitness witness(const FiniteLanguage& language, Family family, bool empty_axiom) {
        for (std::size_t i = tables_.size(); i-- > 0 && tables_.size() > 1;) leave_out_table(i);
        if (!family.deterministic)
            for (std::size_t i = 0; i < tables_.size(); ++i) leave_out_rules(i);
        FiniteWitness found{language.alphabet, axiom(language, empty_axiom), {}};
        for (const PossibleRules& table : tables_) {
            RuleTable& written = found.tables.emplace_back(language.alphabet->size());
            for (std::uint32_t x = 0; x < table.possible.size(); ++x)
                for (std::uint32_t u = 0; u < table.possible[x].size(); ++u) {
                    if (!table.possible[x][u]) continue;
                    const LetterRule rule = search_.rule(x, u);
                    written[rule.letter].push_back(rule.image);
                }
        }
        return found;
    }

private:
    StepRelation together() const {
        StepRelation all = steps_.front();
        for (const StepRelation& steps : steps_)
            for (std::size_t i = 0; i < all.size(); ++i)
                for (std::size_t j = 0; j < all.size(); ++j) all[i][j] |= steps[i][j];
        return all;
    }

    void leave_out_table(std::size_t i) {
        const auto place = static_cast<std::ptrdiff_t>(i);
        StepRelation steps = std::move(steps_[i]);
        steps_.erase(steps_.begin() + place);
        if (search_.unreached(together()))
            steps_.insert(steps_.begin() + place, std::move(steps));
        else
            tables_.erase(tables_.begin() + place);
    }

    void leave_out_rules(std::size_t i) {
        for (auto& images : tables_[i].possible)
            for (std::size_t u = images.size(); u-- > 0;) {
                if (!images[u] || std::count(images.begin(), images.end(), 1) == 1) continue;
                images[u] = 0;
                StepRelation steps = search_.steps(tables_[i]);
                std::swap(steps, steps_[i]);
                if (!search_.unreached(together())) continue;
                images[u] = 1;
                std::swap(steps, steps_[i]);
            }
    }

    Word axiom(const FiniteLanguage& language, bool empty_axiom) const {
        const auto first = RuleSearch::sources(together()).front();
        for (const std::uint32_t word : first)
            if (empty_axiom || !language.words[word].empty()) return language.words[word];
        return {};
    }

    RuleSearch& search_;
    std::vector<PossibleRules> tables_;
    std::vector<StepRelation> steps_;
};

}  // namespace

FamilyAnswer decide_family(const FiniteLanguage& language, Family family,
                           const FamilyOptions& options, const Budget& budget) {
    FamilyAnswer answer;
    FamilyObstruction obstruction{family, options.empty_axiom, language, {}, {}};
    try {
        const FiniteWords words(language, budget);
        RuleSearch search(language, words, family, options.empty_axiom, options.cases, budget);
        std::vector<PossibleRules> tables;
        if (family.tables) {
            tables = TableSearch(search).tables(obstruction);
        } else {
            PossibleRules rules = search.all_rules();
            if (search.narrow_to_solution(rules, true, obstruction.root))
                tables.push_back(std::move(rules));
        }
        if (tables.empty()) {
            answer.obstruction = std::move(obstruction);
            answer.truth = Truth::refuted;
        } else {
            answer.witness = WitnessBuilder(search, std::move(tables))
                                 .witness(language, family, options.empty_axiom);
            answer.truth = Truth::proved;
        }
    } catch (const BoundReached& bound) {
        answer.tried = "Rules were ruled out case by case, but " + std::string(bound.what()) + ".";
        answer.out_of_time = bound.bound() == Bound::time;
    }
    return answer;
}

}  // namespace algae
