#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "exact/integer.hpp"
#include "verify/json_value.hpp"

namespace algae::verify {

/// What is wrong with a proof, and where.
struct Flaw {
    std::string path;
    std::size_t line = 0;
    std::string reason;
};

/// A value of a certificate and how to get there: "statements[2].proof.cases[0]". Whoever asks for
/// something else than what is there gets an Error that names the path and the line.
class Field {
public:
    Field(const JsonValue& value, std::string path, const std::string& file)
        : value_(&value), path_(std::move(path)), file_(&file) {}

    const std::string& path() const { return path_; }
    std::size_t line() const { return value_->line; }
    JsonValue::Kind kind() const { return value_->kind; }

    /// Throws Error if this is no object or has a field that is not named here.
    void only(std::initializer_list<std::string_view> names) const;
    bool has(std::string_view name) const;
    /// A field of an object. Throws Error if it is missing.
    Field at(std::string_view name) const;
    /// The elements of a list.
    std::vector<Field> list() const;
    /// The two elements of a list of two.
    std::pair<Field, Field> pair() const;
    /// The fields of an object.
    std::vector<std::pair<std::string, Field>> object() const;
    const std::string& text() const;
    bool truth() const;
    std::uint64_t number() const;
    /// A number or a string of digits; a minus sign before the digits only where `negative`.
    Integer integer(bool negative = false) const;

    /// The certificate is none: throws Error.
    [[noreturn]] void fail(const std::string& what) const;
    /// The proof does not hold: throws Flaw.
    [[noreturn]] void refuse(const std::string& why) const;

private:
    Field inside(const JsonValue& value, const std::string& step) const {
        return {value, path_ + step, *file_};
    }
    void expect(JsonValue::Kind kind, const char* what) const;

    const JsonValue* value_;
    std::string path_;
    const std::string* file_;
};

}  // namespace algae::verify
