// JSON values. nlohmann/json holds and writes them, in this file only: numbers and escapes of the text that a
// verb prints are those of that library, and stay the same to the byte.

#include "report/report.hpp"

#include <nlohmann/json.hpp>

namespace algae {

std::string readable(const Integer& value) {
    const std::string digits = to_string(value);
    if (digits.size() <= 60) return digits;
    return digits.substr(0, 20) + "... (" + std::to_string(digits.size()) + " digits)";
}

using Value = nlohmann::ordered_json;

Json::Json() : value_(std::make_unique<Value>()) {}
Json::Json(const char* text) : value_(std::make_unique<Value>(text)) {}
Json::Json(const std::string& text) : value_(std::make_unique<Value>(text)) {}
Json::Json(std::string_view text) : value_(std::make_unique<Value>(text)) {}
Json::Json(double value) : value_(std::make_unique<Value>(value)) {}
Json::Json(const Value& value) : value_(std::make_unique<Value>(value)) {}
Json::Json(const Integer& value) : Json() {
    if (bit_length(value) <= 53)
        *value_ = value.to_int64();
    else
        *value_ = to_string(value);
}
Json::Json(std::initializer_list<Field> fields) : value_(std::make_unique<Value>(Value::object())) {
    for (const Field& field : fields) set(field.name, std::move(field.value));
}

Json Json::array(std::initializer_list<Json> values) {
    Json all;
    *all.value_ = Value::array();
    for (const Json& value : values) all.add(value);
    return all;
}

Json::Json(const Json& other) : value_(std::make_unique<Value>(*other.value_)) {}
Json::Json(Json&& other) noexcept = default;
Json& Json::operator=(Json other) noexcept {
    value_.swap(other.value_);
    return *this;
}
Json::~Json() = default;

void Json::set_bool(bool value) { *value_ = value; }
void Json::set_signed(std::int64_t value) { *value_ = value; }
void Json::set_unsigned(std::uint64_t value) { *value_ = value; }

Json& Json::set(const std::string& name, Json value) {
    (*value_)[name] = std::move(*value.value_);
    return *this;
}

void Json::update(const Json& other) { value_->update(*other.value_); }

void Json::add(Json value) { value_->push_back(std::move(*value.value_)); }

std::string Json::text(int indent) const { return value_->dump(indent) + '\n'; }

}  // namespace algae
