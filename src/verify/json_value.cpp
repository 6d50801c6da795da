#include "verify/json_value.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "base/error.hpp"

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
        fail("this is no JSON: " + what);
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

}  // namespace algae::verify
