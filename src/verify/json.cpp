#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <set>
#include <tuple>
#include <utility>

#include "exact/exact.hpp"
#include "verify/detail/checking.hpp"
#include "verify/verify.hpp"

// A certificate as text: values of JSON that know their line, built from the events of nlohmann's parser, and fields with the path
// that leads to them, so that each error and each flaw is reported with its place.

namespace algae::verify {

namespace {

constexpr std::size_t deepest = 1000;
/// Of the memory allowed, the part that a text may take as values; the rest is for checking.
constexpr std::uint64_t memory_of_text = 4;

/// The characters of a text that comes in pieces; one piece is kept. Counts the lines before the last character read: a
/// number is known to end only by one more character.
class Characters {
public:
    Characters(const TextSource& more, const std::string& file, const Budget& budget)
        : more_(more), file_(file), budget_(budget), piece_(std::size_t{1} << 16) {}

    bool at_end() {
        if (at_ == end_ && !ended_) fill();
        return ended_;
    }
    char now() const { return piece_[at_]; }
    void next() {
        if (last_ == '\n') ++line_;
        last_ = piece_[at_++];
    }
    std::size_t line() const { return line_; }
    /// A value or a key was read.
    void begin_token() { pieces_of_token_ = 0; }

private:
    void fill() {
        budget_.check();
        if (++pieces_of_token_ * piece_.size() > budget_.memory / memory_of_text)
            throw BoundReached(Bound::memory, file_ + ":" + std::to_string(line_) +
                                                  ": a single value is longer than can be read "
                                                  "within the memory allowed");
        at_ = 0;
        end_ = more_(piece_.data(), piece_.size());
        ended_ = end_ == 0;
    }

    const TextSource& more_;
    const std::string& file_;
    const Budget& budget_;
    std::vector<char> piece_;
    std::size_t at_ = 0, end_ = 0, line_ = 1;
    std::uint64_t pieces_of_token_ = 0;
    char last_ = 0;
    bool ended_ = false;
};

/// Where the parser is in the characters; without them, at the end.
class Position {
public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = char;

    explicit Position(Characters* in = nullptr) : in_(in) {}
    char operator*() const { return in_->now(); }
    Position& operator++() {
        in_->next();
        return *this;
    }
    Position operator++(int) {
        const Position before = *this;
        in_->next();
        return before;
    }
    bool operator==(const Position& other) const { return at_end() == other.at_end(); }
    bool operator!=(const Position& other) const { return !(*this == other); }

private:
    bool at_end() const { return !in_ || in_->at_end(); }

    Characters* in_;
};

/// Builds the value from the events of the parser.
class Builder : public nlohmann::json_sax<nlohmann::json> {
public:
    Builder(Characters& text, const std::string& file, const Budget& budget,
            const Elements& elements)
        : text_(text), file_(file), budget_(budget), elements_(elements) {}

    bool null() override { return simple(JsonValue::Kind::null); }
    bool boolean(bool value) override {
        if (JsonValue* const added = add(JsonValue::Kind::truth)) added->truth = value;
        return complete();
    }
    bool number_integer(number_integer_t) override { return simple(JsonValue::Kind::real); }
    bool number_unsigned(number_unsigned_t value) override {
        if (JsonValue* const added = add(JsonValue::Kind::number)) added->number = value;
        return complete();
    }
    bool number_float(number_float_t, const string_t&) override {
        return simple(JsonValue::Kind::real);
    }
    bool string(string_t& value) override {
        spend(value.size());
        if (JsonValue* const added = add(JsonValue::Kind::text)) added->text = std::move(value);
        return complete();
    }
    bool binary(binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(JsonValue::Kind::object); }
    bool start_array(std::size_t) override { return open(JsonValue::Kind::list); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }
    bool key(string_t& name) override {
        text_.begin_token();
        spend(2 * (sizeof(std::string) + name.size()));
        if (skipped_ > 0) return true;
        if (elements_are_over_ && open_.size() == 1)
            fail("the field '" + name + "' comes after '" + std::string(elements_.list) +
                 "', which must be the last");
        auto& keys = open_.back().keys;
        if (!names_.back().insert(name).second) fail("the field '" + name + "' stands here twice");
        keys.push_back(std::move(name));
        return true;
    }
    bool parse_error(std::size_t, const std::string&,
                     const nlohmann::detail::exception& error) override {
        std::string what = error.what();
        if (const auto colon = what.find(": "); colon != std::string::npos)
            what = what.substr(colon + 2);
        fail("this is not JSON: " + what);
    }

    JsonValue result;

private:
    [[noreturn]] void fail(const std::string& what) {
        throw Error(file_ + ":" + std::to_string(text_.line()) + ": " + what);
    }

    /// Whether the value that begins is an element that is handed over, or is in one.
    bool in_elements() const { return open_.size() >= 2 && within_elements_; }

    /// Accounts for memory. An element that needs too much is dropped and only its end is looked for.
    void spend(std::size_t bytes) {
        spent_ += bytes;
        if (skipped_ > 0 || spent_ <= budget_.memory / memory_of_text) return;
        if (!in_elements())
            throw BoundReached(Bound::memory, file_ + ":" + std::to_string(text_.line()) +
                                                  ": what is read needs more than the memory "
                                                  "allowed");
        too_large_.kind = JsonValue::Kind::too_large;
        too_large_.line = open_.size() > 2 ? open_[2].line : text_.line();
        skipped_ = open_.size() - 1;  // the levels that are open, with that of the list
        open_.resize(2);
        names_.resize(2);
    }

    /// A new value in the one that is open; nothing where it is skipped.
    JsonValue* add(JsonValue::Kind kind) {
        text_.begin_token();
        spend(sizeof(JsonValue));
        if (skipped_ > 0) return nullptr;
        JsonValue& value = open_.empty() ? result : open_.back().items.emplace_back();
        value.kind = kind;
        value.line = text_.line();
        return &value;
    }

    bool simple(JsonValue::Kind kind) {
        add(kind);
        return complete();
    }

    /// After a value: hands it over if it is an element.
    bool complete() {
        if (!in_elements() || open_.size() > 2 || skipped_ > 1) return true;
        auto& items = open_.back().items;
        elements_.each(skipped_ > 0 ? too_large_ : items.back());
        items.clear();
        spent_ = spent_before_;
        skipped_ = 0;
        return true;
    }

    bool open(JsonValue::Kind kind) {
        text_.begin_token();
        if (open_.size() + skipped_ >= deepest)
            throw BoundReached(Bound::method, file_ + ":" + std::to_string(text_.line()) +
                                                  ": nested deeper than " +
                                                  std::to_string(deepest) + " levels");
        spend(sizeof(JsonValue) + sizeof(std::set<std::string>));
        if (skipped_ > 0) {
            ++skipped_;
            return true;
        }
        if (kind == JsonValue::Kind::list && open_.size() == 1 && elements_.each &&
            open_[0].kind == JsonValue::Kind::object && open_[0].keys.back() == elements_.list) {
            within_elements_ = true;
            spent_before_ = spent_;
            open_[0].keys.pop_back();
            elements_.before(std::move(open_[0]));
        }
        JsonValue& value = open_.emplace_back();
        value.kind = kind;
        value.line = text_.line();
        names_.emplace_back();
        return true;
    }

    bool close() {
        text_.begin_token();
        if (skipped_ > 1) {
            --skipped_;
            return complete();
        }
        JsonValue value = std::move(open_.back());
        open_.pop_back();
        names_.pop_back();
        if (within_elements_ && open_.size() == 1) {
            within_elements_ = false;
            elements_are_over_ = true;
        }
        (open_.empty() ? result : open_.back().items.emplace_back()) = std::move(value);
        return complete();
    }

    Characters& text_;
    const std::string& file_;
    const Budget& budget_;
    const Elements& elements_;
    std::vector<JsonValue> open_;
    std::vector<std::set<std::string>> names_;
    bool within_elements_ = false, elements_are_over_ = false;
    std::uint64_t spent_ = 0, spent_before_ = 0;
    std::size_t skipped_ = 0;  // of the element that is too large: its open levels and one more
    JsonValue too_large_;
};

}  // namespace

JsonValue parse_json(const TextSource& text, const std::string& file, const Budget& budget,
                     const Elements& elements) {
    Characters characters(text, file, budget);
    Builder builder(characters, file, budget, elements);
    nlohmann::json::sax_parse(Position(&characters), Position(), &builder);
    return std::move(builder.result);
}

TextSource source_of(std::string_view text) {
    return [text](char* to, std::size_t most) mutable {
        const std::size_t count = text.copy(to, most);
        text.remove_prefix(count);
        return count;
    };
}

bool same_value(const JsonValue& left, const JsonValue& right) {
    return std::tie(left.kind, left.truth, left.number, left.text, left.keys) ==
               std::tie(right.kind, right.truth, right.number, right.text, right.keys) &&
           std::equal(left.items.begin(), left.items.end(), right.items.begin(), right.items.end(),
                      same_value);
}

namespace {

const char* found(JsonValue::Kind kind) {
    static constexpr std::array names = {
        "null",     "true or false", "a number",  "a number that is negative or not whole",
        "a string", "a list",        "an object", "a value too large to be read"};
    return names.at(static_cast<std::size_t>(kind));
}

}  // namespace

void Field::expect(JsonValue::Kind kind, const char* what) const {
    if (value_->kind != kind)
        fail(std::string("expected ") + what + ", found " + found(value_->kind));
}

void Field::only(const std::vector<std::string_view>& names) const {
    expect(JsonValue::Kind::object, "an object");
    for (std::size_t i = 0; i < value_->keys.size(); ++i)
        if (!std::count(names.begin(), names.end(), value_->keys[i]))
            inside(value_->items[i], "").fail("unexpected field '" + value_->keys[i] + "'");
}

bool Field::has(std::string_view name) const {
    expect(JsonValue::Kind::object, "an object");
    return std::count(value_->keys.begin(), value_->keys.end(), name) > 0;
}

Field Field::at(std::string_view name) const {
    expect(JsonValue::Kind::object, "an object");
    const auto key = std::find(value_->keys.begin(), value_->keys.end(), name);
    if (key == value_->keys.end()) fail("the field '" + std::string(name) + "' is missing");
    return inside(value_->items[static_cast<std::size_t>(key - value_->keys.begin())],
                  (path_.empty() ? "" : ".") + std::string(name));
}

std::vector<Field> Field::list() const {
    expect(JsonValue::Kind::list, "a list");
    std::vector<Field> all;
    for (std::size_t i = 0; i < value_->items.size(); ++i)
        all.push_back(inside(value_->items[i], "[" + std::to_string(i) + "]"));
    return all;
}

std::pair<Field, Field> Field::pair() const {
    auto all = list();
    if (all.size() != 2) fail("expected a list of two, found one of " + std::to_string(all.size()));
    return {all[0], all[1]};
}

std::vector<std::pair<std::string, Field>> Field::object() const {
    expect(JsonValue::Kind::object, "an object");
    std::vector<std::pair<std::string, Field>> all;
    for (std::size_t i = 0; i < value_->items.size(); ++i)
        all.emplace_back(value_->keys[i], inside(value_->items[i], "." + value_->keys[i]));
    return all;
}

const std::string& Field::text() const {
    expect(JsonValue::Kind::text, "a string");
    return value_->text;
}

bool Field::truth() const {
    expect(JsonValue::Kind::truth, "true or false");
    return value_->truth;
}

std::uint64_t Field::number() const {
    const Integer number = integer();
    if (!number.fits_uint64()) fail("the number is too large here");
    return number.to_uint64();
}

Integer Field::integer(bool negative) const {
    if (value_->kind == JsonValue::Kind::number) return value_->number;
    expect(JsonValue::Kind::text, "a whole number or a string of digits");
    std::string_view digits = value_->text;
    if (negative && digits.starts_with('-')) digits.remove_prefix(1);
    if (digits.empty() ||
        !std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; }))
        fail("expected digits");
    return Integer(value_->text);
}

void Field::fail(const std::string& what) const {
    throw Error(*file_ + ":" + std::to_string(line()) + ": " +
                plain((path_.empty() ? "" : path_ + ": ") + what));
}

std::string plain(std::string_view text) {
    static constexpr std::string_view digits = "0123456789abcdef";
    std::string all;
    const auto at = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
    };
    const auto write = [&](std::string_view begin, unsigned number) {
        all += begin;
        all += digits[number >> 4];
        all += digits[number & 15];
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        const unsigned byte = at(i), third = at(i + 2);
        if (byte < 0x20 || byte == 0x7F) {
            write("\\x", byte);
        } else if (byte == 0xC2 && at(i + 1) >= 0x80 && at(i + 1) < 0xA0) {  // U+0080 to U+009F
            write("\\u00", at(i + 1));
            ++i;
        } else if (byte == 0xE2 &&
                   (at(i + 1) == 0x80
                        ? third >= 0x8B && third <= 0xAE && (third < 0x90 || third > 0xA7)
                        : at(i + 1) == 0x81 && third >= 0xA0 && third <= 0xAF)) {
            write("\\u20", (at(i + 1) & 0x3FU) << 6 | (third & 0x3FU));
            i += 2;
        } else {
            all += text[i];
        }
    }
    return all;
}

void Field::refuse(const std::string& why) const { throw Flaw{path_, line(), why}; }

}  // namespace algae::verify
