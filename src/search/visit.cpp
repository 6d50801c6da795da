#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>

#include "search/search.hpp"

// All instances of one size, in the order, each once up to renaming, in constant memory.
//
// The text of an instance (the face says what it is) is written letter by letter by recursion, every choice in increasing order, so texts
// come out in increasing order. For that the total size and the number of letters are fixed first; sizes of values are not, they
// come about. Every choice is checked against what must still follow (rules of letters that have occurred, letters that have not
// occurred, later values) and against what can still be taken up, so few ways lead nowhere.
//
// Renaming. A text that is least has its letters numbered where they first occur: where c occurs before b, and b < c, exchanging
// them makes the text smaller. In a text without sets of words that is all, because the places of words then do not depend on names.
// In a set of words they do: {ab, ca} and {bc, ab} differ by a renaming. So texts are tested:
// - When a word is added to a set in which two or more letters occur for the first time, the words so far are renamed in all ways that
//   keep the older letters. If some renaming makes them smaller, no set that begins so is least: further words only lower the words
//   of the renamed set, sorted (orderly generation; Read 1978, Faradzev 1978).
// - If only the identity leaves each of the sets as it is, the whole text is least. If another renaming does, as with {b, c}, or if there are
//   two tables, the values so far are tested as a whole at the end of each value (class Renamings).
// A test does not go through all renamings. It goes through the text and matches: some word of the renamed set must become the
// next word of the text, letters that have no image yet get the least new ones, and a word that becomes smaller
// decides. So it costs about as many steps as there are renamings that leave a beginning of the text as it is. Of words that nothing but
// their letters tells apart one is tried, as with {b, c, d, e}, which many renamings leave.
//
// What is subtle: after a set such as {b, c} a renaming carries the rule of b to the place of that of c, so pieces are matched by
// the letters that own them. Tables are renamed by trying their orders.

namespace algae {

/// Whether some renaming makes a text smaller.
class Renamings {
public:
    enum class Finding {
        smaller,   // some renaming does
        rigid,     // none does, and only the identity leaves the text as it is
        symmetric  // none does, and others leave it too
    };

    explicit Renamings(const Budget& budget) : budget_(&budget) {}

    /// The words of a piece; letters before `known` keep their names.
    Finding of_piece(const Instance& text, std::size_t piece, std::size_t known) {
        begin(text, known);
        alone_ = true;
        symmetric_ = false;
        if (words(0, piece, piece, text.pieces_[piece])) return Finding::smaller;
        return symmetric_ ? Finding::symmetric : Finding::rigid;
    }

    /// Whether some renaming makes the values smaller.
    bool makes_smaller(const Instance& text) {
        begin(text, 0);
        alone_ = false;
        return value(0);
    }

private:
    static constexpr Symbol none = std::numeric_limits<Symbol>::max();

    void begin(const Instance& text, std::size_t known) {
        text_ = &text;
        image_.assign(text.letter_count_, none);
        origin_.assign(text.letter_count_, none);
        for (Symbol a = 0; a < known; ++a) image_[a] = origin_[a] = a;
        named_ = known;
        used_.assign(text.words_.size(), 0);
    }

    bool value(std::size_t v) {
        if (v == text_->values_.size()) return false;
        const Instance::Value& of = text_->values_[v];
        const std::size_t first = of.first_piece;
        if (of.tables == 1) return piece(v, first);
        std::vector<std::size_t> order(of.tables);
        std::iota(order.begin(), order.end(), std::size_t{0});
        orders_.resize(text_->values_.size());
        do {
            orders_[v] = order;
            if (piece(v, first)) return true;
        } while (std::next_permutation(order.begin(), order.end()));
        return false;
    }

    /// The piece that a renaming carries to this place.
    std::size_t origin(std::size_t v, std::size_t place) const {
        const Instance::Value& of = text_->values_[v];
        const std::size_t axiom = of.kind == Domain::Kind::system ? 1 : 0;
        const std::size_t offset = place - of.first_piece;
        if (of.owners.empty() || offset < axiom) return place;
        const std::size_t owner = (offset - axiom) / of.tables,
                          table = (offset - axiom) % of.tables;
        const auto found = std::find(of.owners.begin(), of.owners.end(), origin_[of.owners[owner]]);
        return text_->piece_of(v, static_cast<std::size_t>(found - of.owners.begin()),
                               of.tables == 1 ? 0 : orders_[v][table]);
    }

    bool piece(std::size_t v, std::size_t place) {
        if (place == text_->value_end(v)) return value(v + 1);
        return words(v, place, origin(v, place), text_->pieces_[place]);
    }

    /// The words of the piece `from` are to become those of the piece at `place`, from the word `next` on.
    bool words(std::size_t v, std::size_t place, std::size_t from, std::size_t next) {
        if (++polls_ % 4096 == 0) budget_->check();  // letters that look alike have many renamings
        const std::size_t from_begin = text_->pieces_[from], from_end = text_->piece_end(from);
        const std::size_t done = next - text_->pieces_[place];
        if (next == text_->piece_end(place)) {
            if (done < from_end - from_begin) return false;
            if (!alone_) return piece(v, place + 1);
            for (Symbol a = 0; a < image_.size() && !symmetric_; ++a)
                symmetric_ = image_[a] != none && image_[a] != a;
            return false;
        }
        if (done == from_end - from_begin) return true;
        const std::size_t begin = text_->words_[next], length = text_->word_end(next) - begin;
        std::optional<std::size_t> tried;
        for (std::size_t w = from_begin; w < from_end; ++w) {
            if (used_[w]) continue;
            const std::size_t start = text_->words_[w], found = text_->word_end(w) - start;
            if (found < length) return true;
            if (found > length) break;  // the words of a piece are sorted
            if (tried && are_alike(*tried, w)) {
                symmetric_ = true;
                continue;
            }
            tried = w;
            const std::size_t named = named_;
            std::size_t i = 0;
            Symbol now = 0;
            for (; i < length; ++i) {
                Symbol& to = image_[text_->letters_[start + i]];
                if (to == none) {
                    to = static_cast<Symbol>(named_++);
                    origin_[to] = text_->letters_[start + i];
                }
                now = to;
                if (now != text_->letters_[begin + i]) break;
            }
            bool is_smaller = i < length && now < text_->letters_[begin + i];
            if (i == length) {
                used_[w] = 1;
                is_smaller = words(v, place, from, next + 1);
                used_[w] = 0;
            }
            while (named_ > named) {
                --named_;
                image_[origin_[named_]] = none;
                origin_[named_] = none;
            }
            if (is_smaller) return true;
        }
        return false;
    }

    /// Whether nothing but their letters tells two words of a piece apart, which occur nowhere else: what one becomes the other can.
    bool are_alike(std::size_t one, std::size_t other) const {
        const std::size_t begin = text_->words_[one], start = text_->words_[other],
                          length = text_->word_end(one) - begin;
        for (std::size_t i = 0; i < length; ++i) {
            const Symbol a = text_->letters_[begin + i], b = text_->letters_[start + i];
            for (std::size_t k = 0; k < i; ++k)
                if ((a == text_->letters_[begin + k]) != (b == text_->letters_[start + k]))
                    return false;
            if (!is_only_in(a, one) || !is_only_in(b, other)) return false;
        }
        return true;
    }
    /// Whether a letter has no image yet and occurs in this word alone.
    bool is_only_in(Symbol letter, std::size_t word) const {
        if (image_[letter] != none) return false;
        for (const Instance::Value& value : text_->values_)
            if (std::find(value.owners.begin(), value.owners.end(), letter) != value.owners.end())
                return false;
        const auto letters = text_->letters_.begin();
        const auto from = static_cast<std::ptrdiff_t>(text_->words_[word]),
                   to = static_cast<std::ptrdiff_t>(text_->word_end(word));
        return std::find(letters, letters + from, letter) == letters + from &&
               std::find(letters + to, text_->letters_.end(), letter) == text_->letters_.end();
    }

    const Budget* budget_;
    std::uint32_t polls_ = 0;
    const Instance* text_ = nullptr;
    std::vector<Symbol> image_, origin_;  // of letters, by the renaming and back; `none` if not yet
    std::size_t named_ = 0;               // images 0, 1, ..., named_ - 1 are given
    std::vector<char> used_;              // by word
    std::vector<std::vector<std::size_t>> orders_;  // of tables, by value
    bool alone_ = false, symmetric_ = false;
};

namespace {

constexpr std::uint64_t unbounded = std::numeric_limits<std::uint64_t>::max();

std::uint64_t added(std::uint64_t left, std::uint64_t right) {
    return left > unbounded - right ? unbounded : left + right;
}

using Kind = Domain::Kind;

bool is_erasing(const Domain& domain) {
    return !domain.propagating && !domain.nonerasing && !domain.letter_to_letter;
}

/// What the least production or image of a letter costs.
std::uint64_t least_image(const Domain& domain) { return is_erasing(domain) ? 1 : 2; }

bool has_applied_domain(const Domain& domain) {
    return domain.kind == Kind::morphism || domain.kind == Kind::substitution;
}

}  // namespace

class Enumerator {
public:
    Enumerator(const Tuple& tuple, std::uint64_t size, const InstanceVisitor& visitor,
               const Budget& budget, InstanceRange range)
        : tuple_(&tuple),
          size_(size),
          visitor_(&visitor),
          budget_(&budget),
          range_(range),
          is_renamed_(!tuple.over),
          places_(tuple.values.size() + 1),
          renamings_(budget) {
        for (std::size_t v = tuple.values.size(); v-- > 0;) follow(v);
    }

    /// False if the visitor stopped it.
    bool all() {
        if (range_.first >= range_.last) return true;
        if (!is_renamed_) {
            of_letters(*tuple_->over);
            return !is_stopped_;
        }
        const std::uint64_t most = std::min(size_, tuple_->letters.value_or(size_));
        for (std::uint64_t k = 0; k <= most; ++k) {
            if (tuple_->values.empty() && k > 0) break;
            if (!of_letters(k)) break;
        }
        return !is_stopped_;
    }

private:
    /// What is known of a value before it is chosen, and while it is.
    struct Place {
        // Of this value and the later ones:
        std::uint64_t least = 0;         // the size, without images of letters by morphisms
        std::uint64_t letter_image = 0;  // what the images of one letter by the morphisms cost
        std::uint64_t new_letter = unbounded;  // what a letter costs that has not occurred yet
        std::uint64_t free_letters = 0;        // so many new ones are within the least size
        // Of this value:
        const Domain* domain = nullptr;
        std::uint64_t most = 0;   // the size of it and the later ones
        std::uint64_t image = 0;  // the least size of a rule or image
        std::uint64_t shortest = 0, longest = 0, most_words = 0, letter_bound = 0;
        std::uint64_t kept = 0;  // of the size left at its beginning what its own bound leaves
        std::vector<std::uint32_t> uses = {};  // of each letter
        std::uint64_t letters = 0;             // how many occur
    };

    /// A word in the making.
    struct Task {
        std::size_t v;       // of this value
        std::size_t length;  // it has so many letters
        std::size_t
            before;  // where the word before it in its piece starts, if there is one of that length
        bool is_next = false;     // that word is there
        bool must_open = false;   // a letter must occur that is new to the system
        std::size_t opened = 0;   // how many letters the system had before
        std::size_t known = 0;    // letters that occurred before the piece
        std::uint64_t count = 0;  // words of the piece before it
        std::uint64_t rest;       // the size left behind it
    };

    void follow(std::size_t v) {
        const Domain& domain = tuple_->values[v];
        Place& here = places_[v];
        const Place& next = places_[v + 1];
        here.domain = &domain;
        here.image = least_image(domain);
        here.shortest = is_erasing(domain) ? 0 : 1;
        here.longest = domain.letter_to_letter ? 1 : domain.max_word_length.value_or(unbounded);
        here.most_words = unbounded;
        here.letter_bound = domain.letters.value_or(unbounded);
        here.free_letters = next.free_letters;
        std::uint64_t least = 0, letter = 1;
        switch (domain.kind) {
            case Kind::language:
                break;
            case Kind::substitution:
                letter = 1 - here.shortest;
                break;
            case Kind::system:
                least = 1 + here.image;
                letter =
                    2;  // its rule, and its occurrence unless words that are counted already have a letter
                ++here.free_letters;
                if (domain.deterministic) here.most_words = 1;
                break;
            case Kind::letter:
                here.shortest = here.longest = 1;
                here.most_words = least = 1;
                ++here.free_letters;
                break;
            case Kind::word:
                here.most_words = least = 1;
                break;
            case Kind::morphism:
                letter = 1 - here.shortest;
                here.most_words = 1;
                break;
            case Kind::inverse_morphism:
                least = here.image;
                here.most_words = here.letter_bound;
                here.letter_bound = unbounded;
                letter = unbounded;
                break;
            case Kind::number:
                letter = unbounded;
                break;
        }
        here.least = added(next.least, least);
        here.letter_image = next.letter_image + (has_applied_domain(domain) ? here.image : 0);
        here.new_letter = std::min(next.new_letter, added(letter, next.letter_image));
    }

    /// The most that a value can take up, where there are so many letters.
    std::uint64_t most_of(const Domain& domain, std::uint64_t letters) const {
        std::uint64_t most = unbounded;
        const std::uint64_t image =
            domain.letter_to_letter ? 2 : added(domain.max_word_length.value_or(unbounded), 1);
        if (domain.kind == Kind::number) most = domain.max_number.value_or(unbounded);
        if (domain.kind == Kind::letter) most = 1;
        if (domain.kind == Kind::word) most = image;
        if (domain.kind == Kind::morphism)
            most = letters == 0 ? 0 : (image > unbounded / letters ? unbounded : letters * image);
        if (domain.kind == Kind::substitution && letters == 0) most = 0;
        return std::min(most, domain.max_size.value_or(unbounded));
    }

    bool of_letters(std::uint64_t k) {
        letters_ = static_cast<std::size_t>(k);
        instance_ = Instance();
        instance_.size_ = size_;
        instance_.letter_count_ = letters_;
        order_.clear();
        uses_.assign(letters_, 0);
        places_.back().most = 0;
        for (std::size_t v = tuple_->values.size(); v-- > 0;) {
            places_[v].most = added(places_[v + 1].most, most_of(tuple_->values[v], k));
            places_[v].uses.assign(letters_, 0);
            places_[v].letters = 0;
        }
        left_ = size_;
        unsure_ = 0;
        return value(0);
    }

    /// How many letters must still occur.
    std::uint64_t missing() const { return is_renamed_ ? letters_ - order_.size() : 0; }

    void poll() {
        if (++polls_ % 4096 == 0) budget_->check();
    }

    /// Whether the values from this one on have enough size left and can take it up.
    bool fits(std::size_t v, std::uint64_t left) const {
        const Place& next = places_[v];
        std::uint64_t least = added(next.least, next.letter_image * order_.size());
        const std::uint64_t letters = missing();
        if (letters > 0 && next.new_letter == unbounded) return false;
        if (letters > next.free_letters) least += (letters - next.free_letters) * next.new_letter;
        return least <= left && left <= next.most;
    }

    // Every function below goes through all ways to go on and is false if the visit ends.

    bool value(std::size_t v) {
        poll();
        if (!fits(v, left_)) return true;
        if (v == tuple_->values.size()) return whole();
        Place& here = places_[v];
        const std::uint64_t most = here.domain->max_size.value_or(unbounded);
        here.kept = left_ > most ? left_ - most : 0;
        instance_.values_.push_back(
            {.kind = here.domain->kind, .first_piece = instance_.pieces_.size()});
        bool goes_on = true;
        if (here.domain->kind == Kind::number) {
            goes_on = numbers(v);
        } else if (here.domain->kind == Kind::system && here.domain->tables) {
            // An axiom of one letter and so many rules.
            for (std::size_t t = 1; goes_on && 1 + t * here.image <= left_; ++t) {
                instance_.values_[v].tables = t;
                unsure_ += t > 1 ? 1 : 0;
                goes_on = piece(v);
                unsure_ -= t > 1 ? 1 : 0;
            }
        } else {
            if (has_applied_domain(*here.domain)) instance_.values_[v].owners = order_;
            goes_on = piece(v);
        }
        instance_.values_.pop_back();
        return goes_on;
    }

    bool numbers(std::size_t v) {
        const std::uint64_t most = std::min(left_, places_[v].domain->max_number.value_or(left_));
        for (std::uint64_t n = 0; n <= most; ++n) {
            if (n > left_ - places_[v].kept) break;
            if (left_ - n > places_[v + 1].most) continue;
            instance_.values_[v].number = n;
            left_ -= n;
            const bool goes_on = value(v + 1);
            left_ += n;
            if (!goes_on) return false;
        }
        return true;
    }

    /// How many pieces the value has, as far as it is known.
    std::size_t pieces(std::size_t v) const {
        const Instance::Value& of = instance_.values_[v];
        if (of.kind == Kind::system) return 1 + of.owners.size() * of.tables;
        return has_applied_domain(*places_[v].domain) ? of.owners.size() : 1;
    }

    bool piece(std::size_t v) {
        const std::size_t done = instance_.pieces_.size() - instance_.values_[v].first_piece;
        if (done == pieces(v)) return value_done(v);
        instance_.pieces_.push_back(instance_.words_.size());
        const bool goes_on = words(v, order_.size(), 0, false);
        instance_.pieces_.pop_back();
        return goes_on;
    }

    bool value_done(std::size_t v) {
        if (left_ < places_[v].kept || !fits(v + 1, left_)) return true;
        const std::size_t tables = instance_.values_[v].tables;
        for (std::size_t t = 1; t < tables; ++t)
            for (std::size_t other = 0; other < t; ++other)
                if (are_equal(v, other, t)) return true;
        if (is_renamed_ ? unsure_ > 0 && renamings_.makes_smaller(instance_)
                        : tables > 1 && !are_sorted(v))
            return true;
        return value(v + 1);
    }

    /// -1, 0 or 1 as a piece stands before another, is equal or stands behind it.
    int compared(std::size_t left, std::size_t right) const {
        std::size_t i = instance_.pieces_[left], j = instance_.pieces_[right];
        const std::size_t i_end = instance_.piece_end(left), j_end = instance_.piece_end(right);
        for (; i < i_end && j < j_end; ++i, ++j) {
            const std::size_t i_length = instance_.word_end(i) - instance_.words_[i];
            const std::size_t j_length = instance_.word_end(j) - instance_.words_[j];
            if (i_length != j_length) return i_length < j_length ? -1 : 1;
            for (std::size_t n = 0; n < i_length; ++n) {
                const Symbol a = instance_.letters_[instance_.words_[i] + n];
                const Symbol b = instance_.letters_[instance_.words_[j] + n];
                if (a != b) return a < b ? -1 : 1;
            }
        }
        return i < i_end ? 1 : (j < j_end ? -1 : 0);
    }

    bool are_equal(std::size_t v, std::size_t table, std::size_t other) const {
        for (std::size_t i = 0; i < instance_.values_[v].owners.size(); ++i)
            if (compared(instance_.piece_of(v, i, table), instance_.piece_of(v, i, other)) != 0)
                return false;
        return true;
    }

    /// Whether no other order of the tables makes the text of a system over an explicit alphabet smaller.
    bool are_sorted(std::size_t v) const {
        for (std::size_t t = 1; t < instance_.values_[v].tables; ++t)
            for (std::size_t i = 0; i < instance_.values_[v].owners.size(); ++i) {
                const int order =
                    compared(instance_.piece_of(v, i, t - 1), instance_.piece_of(v, i, t));
                if (order > 0) return false;
                if (order < 0) break;
            }
        return true;
    }

    /// Goes on with the present piece, which has so many words; `known` letters occurred before it, and
    /// `symmetric` says whether renaming those since then can leave the words as they are.
    bool words(std::size_t v, std::size_t known, std::uint64_t count, bool symmetric) {
        const Place& here = places_[v];
        const Kind kind = here.domain->kind;
        const std::size_t present = instance_.pieces_.size() - 1;
        const bool is_axiom = kind == Kind::system && present == instance_.values_[v].first_piece;
        const std::uint64_t most_words = is_axiom ? 1 : here.most_words;
        if ((count > 0 || kind == Kind::language) && is_possible(v, left_, 0) &&
            (pieces_left(v) > 0 || left_ <= places_[v + 1].most) && are_in_order(v, present)) {
            unsure_ += symmetric ? 1 : 0;
            const bool goes_on = piece(v);
            unsure_ -= symmetric ? 1 : 0;
            if (!goes_on) return false;
        }
        if (count == most_words) return true;
        const std::uint64_t overhead = is_axiom || kind == Kind::letter ? 0 : 1;
        const std::uint64_t shortest = is_axiom ? 1 : here.shortest;
        std::uint64_t length = shortest;
        Task task{.v = v, .length = 0, .before = 0, .known = known, .count = count, .rest = 0};
        if (count > 0) {
            task.before = instance_.words_.back();
            length = instance_.letters_.size() - task.before;
            task.is_next = true;
        }
        task.opened = instance_.values_[v].owners.size();
        for (; length <= here.longest && overhead + length <= left_; ++length) {
            task.length = static_cast<std::size_t>(length);
            task.rest = left_ - overhead - length;
            if (!is_possible(v, task.rest, length)) break;  // longer words leave less
            task.must_open = false;
            if (pieces_left(v) == 0 && task.rest > places_[v + 1].most) {
                // What is left must be taken up by further words of this piece, or by rules of new letters.
                const bool can_add =
                    count + 1 < most_words && task.rest >= places_[v + 1].least + overhead + length;
                task.must_open = !can_add && kind == Kind::system;
                if (!can_add && (!task.must_open || length == 0)) {
                    task.is_next = false;
                    continue;
                }
            }
            instance_.words_.push_back(instance_.letters_.size());
            const bool goes_on = letter(task, 0, task.is_next);
            instance_.words_.pop_back();
            if (!goes_on) return false;
            task.is_next = false;
        }
        return true;
    }

    /// How many pieces of the value follow the present one.
    std::size_t pieces_left(std::size_t v) const {
        return pieces(v) - (instance_.pieces_.size() - instance_.values_[v].first_piece);
    }

    /// Whether `left` behind a word may be enough, of which so many letters are still to come.
    bool is_possible(std::size_t v, std::uint64_t left, std::uint64_t to_come) const {
        const Place &here = places_[v], &next = places_[v + 1];
        const std::uint64_t others = added(next.least, next.letter_image * order_.size());
        std::uint64_t least = added(pieces_left(v) * here.image, std::max(others, here.kept));
        if (const std::uint64_t letters = missing(); letters > 0) {
            // A letter in this word costs its rules and images, one elsewhere its occurrence too.
            const std::uint64_t rules =
                here.domain->kind == Kind::system ? instance_.values_[v].tables * here.image : 0;
            if (here.new_letter == unbounded) return false;
            const bool can_name = here.domain->kind != Kind::inverse_morphism;
            const std::uint64_t to_pay =
                letters > next.free_letters ? letters - next.free_letters : 0;
            const std::uint64_t soon = can_name ? std::min(to_pay, to_come) : 0;
            const std::uint64_t in_word = std::min(rules + next.letter_image, here.new_letter);
            if (here.kept == 0 || here.kept <= others)
                least = added(least, soon * in_word + (to_pay - soon) * here.new_letter);
        }
        return least <= left;
    }

    /// Whether the rules of the first letter do not decrease from table to table, as they do not where the order of tables is the
    /// one of the least text.
    bool are_in_order(std::size_t v, std::size_t present) const {
        const Instance::Value& of = instance_.values_[v];
        const std::size_t offset = present - of.first_piece;
        return offset < 2 || of.tables == 1 || offset > of.tables ||
               compared(present - 1, present) <= 0;
    }

    bool letter(const Task& task, std::size_t place, bool is_tight) {
        poll();
        if (place == task.length) return word(task, is_tight);
        Place& here = places_[task.v];
        const Kind kind = here.domain->kind;
        const bool is_inverse = kind == Kind::inverse_morphism;
        const bool is_apart = tuple_->disjoint && !is_inverse && !has_applied_domain(*here.domain);
        const std::size_t named = is_renamed_ ? order_.size() : letters_;
        const std::size_t end = std::min(letters_, is_inverse ? named : named + 1);
        Symbol a = is_tight ? instance_.letters_[task.before + place] : 0;
        const Symbol first = a;
        // The last letter that can be new to the system must be so if no other was.
        const bool must_open = task.must_open && place + 1 == task.length &&
                               instance_.values_[task.v].owners.size() == task.opened;
        for (; a < end; ++a) {
            const bool is_new_here = here.uses[a] == 0, is_new = uses_[a] == 0;
            if (is_inverse && is_new) continue;
            if (is_new_here && !is_inverse && here.letters == here.letter_bound) continue;
            if (is_apart && is_new_here && !is_new) continue;
            if (must_open && !is_new_here) continue;
            instance_.letters_.push_back(a);
            if (uses_[a]++ == 0) order_.push_back(a);
            if (here.uses[a]++ == 0) {
                ++here.letters;
                if (kind == Kind::system) instance_.values_[task.v].owners.push_back(a);
            }
            bool goes_on = true;
            if (!(is_new || is_new_here) || is_possible(task.v, task.rest, task.length - place - 1))
                goes_on = letter(task, place + 1, is_tight && a == first);
            if (--here.uses[a] == 0) {
                --here.letters;
                if (kind == Kind::system) instance_.values_[task.v].owners.pop_back();
            }
            if (--uses_[a] == 0) order_.pop_back();
            instance_.letters_.pop_back();
            if (!goes_on) return false;
        }
        return true;
    }

    bool word(const Task& task, bool is_same) {
        const bool may_repeat = places_[task.v].domain->kind == Kind::inverse_morphism;
        if (is_same && !may_repeat) return true;
        if (task.must_open && instance_.values_[task.v].owners.size() == task.opened) return true;
        if (!is_possible(task.v, task.rest, 0)) return true;
        bool symmetric = false;
        if (is_renamed_ && task.count > 0 && order_.size() >= task.known + 2) {
            const auto finding =
                renamings_.of_piece(instance_, instance_.pieces_.size() - 1, task.known);
            if (finding == Renamings::Finding::smaller) return true;
            symmetric = finding == Renamings::Finding::symmetric;
        }
        const std::uint64_t left = std::exchange(left_, task.rest);
        const bool goes_on = words(task.v, task.known, task.count + 1, symmetric);
        left_ = left;
        return goes_on;
    }

    bool whole() {
        if (found_ >= range_.last) return false;
        if (found_++ < range_.first) return true;
        is_stopped_ = !(*visitor_)(instance_);
        return !is_stopped_;
    }

    const Tuple* tuple_;
    std::uint64_t size_;
    const InstanceVisitor* visitor_;
    const Budget* budget_;
    InstanceRange range_;
    bool is_renamed_;
    std::vector<Place> places_;
    Renamings renamings_;

    std::size_t letters_ = 0;          // how many there are
    Instance instance_;                // as far as it is written
    std::vector<Symbol> order_;        // the letters that occur, in order of first occurrence
    std::vector<std::uint32_t> uses_;  // of each letter
    std::uint64_t left_ = 0;           // of the size
    std::size_t unsure_ =
        0;  // pieces that some renaming leaves as they are, and systems with several tables
    std::uint64_t found_ = 0;
    std::uint32_t polls_ = 0;
    bool is_stopped_ = false;
};

namespace {

/// Whether the instances are the D0L systems with at most so many letters.
bool is_counted(const Tuple& tuple) {
    if (tuple.values.size() != 1 || tuple.over) return false;
    Domain domain = tuple.values.front();
    const Domain plain{.kind = Kind::system, .deterministic = true};
    domain.propagating = false;
    domain.letters.reset();
    return domain == plain;
}

}  // namespace

bool visit(const Tuple& tuple, std::uint64_t size, const InstanceVisitor& visitor,
           const Budget& budget, InstanceRange range) {
    if (!is_counted(tuple)) return Enumerator(tuple, size, visitor, budget, range).all();
    const Domain& domain = tuple.values.front();
    const std::uint64_t letters =
        std::min(domain.letters.value_or(size), tuple.letters.value_or(size));
    return DeterministicSystems(size, domain.propagating, letters, budget)
        .visit(visitor, range.first, range.last);
}

bool visit_all(const Tuple& tuple, const InstanceVisitor& visitor, const Budget& budget) {
    const std::uint64_t greatest = greatest_size(tuple).value_or(unbounded);
    for (std::uint64_t size = 0;; ++size) {
        budget.check();
        if (!visit(tuple, size, visitor, budget)) return false;
        if (size == greatest) return true;
    }
}

std::uint64_t instance_count(const Tuple& tuple, std::uint64_t size, const Budget& budget) {
    std::uint64_t count = 0;
    visit(
        tuple, size,
        [&](const Instance&) {
            ++count;
            return true;
        },
        budget);
    return count;
}

}  // namespace algae
