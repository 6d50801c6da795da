#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <set>
#include <utility>

#include "exact/exact.hpp"
#include "verify/verify.hpp"

// A certificate as text: values of JSON that know their line, built from the events of nlohmann's parser, and fields with the path
// that leads to them, so that each error and each flaw is reported with its place.

namespace algae::verify {

namespace {

constexpr std::size_t deepest = 1000;

/// The characters of a text; the furthest one that was read is noted outside.
class Characters {
public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    Characters(const char* at, const char** reached) : at_(at), reached_(reached) {}
    reference operator*() const { return *at_; }
    Characters& operator++() {
        *reached_ = ++at_;
        return *this;
    }
    Characters operator++(int) {
        Characters before = *this;
        ++*this;
        return before;
    }
    bool operator==(const Characters& other) const { return at_ == other.at_; }
    bool operator!=(const Characters& other) const { return at_ != other.at_; }

private:
    const char* at_;
    const char** reached_;
};

/// Builds the value from the events of the parser.
class Builder : public nlohmann::json_sax<nlohmann::json> {
public:
    Builder(std::string_view text, const std::string& file)
        : reached(text.data()), file_(file), counted_(text.data()) {}

    bool null() override { return simple(JsonValue::Kind::null); }
    bool boolean(bool value) override {
        add(JsonValue::Kind::truth).truth = value;
        return true;
    }
    bool number_integer(number_integer_t) override { return simple(JsonValue::Kind::real); }
    bool number_unsigned(number_unsigned_t value) override {
        add(JsonValue::Kind::number).number = value;
        return true;
    }
    bool number_float(number_float_t, const string_t&) override {
        return simple(JsonValue::Kind::real);
    }
    bool string(string_t& value) override {
        add(JsonValue::Kind::text).text = std::move(value);
        return true;
    }
    bool binary(binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(JsonValue::Kind::object); }
    bool start_array(std::size_t) override { return open(JsonValue::Kind::list); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }
    bool key(string_t& name) override {
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
    const char* reached;  // one beyond the last character read

private:
    [[noreturn]] void fail(const std::string& what) {
        throw Error(file_ + ":" + std::to_string(line()) + ": " + what);
    }

    /// The line of the last character read that belongs to the value: numbers are followed by one more.
    std::size_t line() {
        const char* end = std::max(counted_, reached - 1);
        line_ += static_cast<std::size_t>(std::count(counted_, end, '\n'));
        counted_ = end;
        return line_;
    }

    JsonValue& add(JsonValue::Kind kind) {
        JsonValue& value = open_.empty() ? result : open_.back().items.emplace_back();
        value.kind = kind;
        value.line = line();
        return value;
    }

    bool simple(JsonValue::Kind kind) {
        add(kind);
        return true;
    }

    bool open(JsonValue::Kind kind) {
        if (open_.size() >= deepest)
            throw BoundReached(Bound::method, file_ + ":" + std::to_string(line()) +
                                                  ": nested deeper than " +
                                                  std::to_string(deepest) + " levels");
        JsonValue& value = open_.emplace_back();
        value.kind = kind;
        value.line = line();
        names_.emplace_back();
        return true;
    }

    bool close() {
        JsonValue value = std::move(open_.back());
        open_.pop_back();
        names_.pop_back();
        (open_.empty() ? result : open_.back().items.emplace_back()) = std::move(value);
        return true;
    }

    const std::string& file_;
    std::vector<JsonValue> open_;
    std::vector<std::set<std::string>> names_;
    const char* counted_;
    std::size_t line_ = 1;
};

}  // namespace

JsonValue parse_json(std::string_view text, const std::string& file) {
    Builder builder(text, file);
    nlohmann::json::sax_parse(Characters(text.data(), &builder.reached),
                              Characters(text.data() + text.size(), &builder.reached), &builder);
    return std::move(builder.result);
}

namespace {

const char* found(JsonValue::Kind kind) {
    static constexpr std::array names = {
        "null",     "true or false", "a number", "a number that is negative or not whole",
        "a string", "a list",        "an object"};
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
    throw Error(*file_ + ":" + std::to_string(line()) + ": " + (path_.empty() ? "" : path_ + ": ") +
                what);
}

void Field::refuse(const std::string& why) const { throw Flaw{path_, line(), why}; }

}  // namespace algae::verify
