#pragma once
// How values go between Python and the library: integers and rational numbers exactly, words and systems as objects that
// share what they hold, reports as text in JSON. Every source of this room includes it.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "exact/exact.hpp"
#include "model/model.hpp"
#include "rewrite/rewrite.hpp"
#include "system/system.hpp"
#include "word/word.hpp"

namespace algae::python {

namespace py = pybind11;

/// A Python int of the same value, of any size.
py::int_ as_python(const Integer& value);
/// A fractions.Fraction.
py::object as_python(const Rational& value);
/// The integer of an object that has one (`__index__`). Throws py::type_error where it has none.
Integer as_integer(py::handle object);
/// The rational number of an int or a Fraction. Throws py::type_error for others.
Rational as_rational(py::handle object);

/// A letter of a word with its parameters; exact numbers, so far as they are known, otherwise doubles.
struct ModuleData {
    ModuleKinds kinds;
    ModuleString word;
};

/// A word with the alphabet that names its letters. Slices share the letters with it.
class WordObject {
public:
    WordObject(std::shared_ptr<const Alphabet> alphabet, Word letters)
        : alphabet_(std::move(alphabet)),
          letters_(std::make_shared<const Word>(std::move(letters))),
          size_(letters_->size()) {}

    const Alphabet& alphabet() const { return *alphabet_; }
    const std::shared_ptr<const Alphabet>& shared_alphabet() const { return alphabet_; }
    std::size_t size() const { return size_; }
    const Symbol* begin() const { return letters_->data() + begin_; }
    const Symbol* end() const { return begin() + size_; }
    Word word() const { return {begin(), end()}; }
    const std::shared_ptr<const Word>& owner() const { return letters_; }

    /// The letters from one position up to another; both must lie in the word.
    WordObject part(std::size_t from, std::size_t to) const {
        WordObject found = *this;
        found.begin_ += from;
        found.size_ = to - from;
        found.modules = nullptr;
        return found;
    }

    std::shared_ptr<const ModuleData> modules;  // where letters have parameters

private:
    std::shared_ptr<const Alphabet> alphabet_;
    std::shared_ptr<const Word> letters_;
    std::size_t begin_ = 0, size_ = 0;
};

/// The word that a text writes, over the letters of an alphabet and new ones. Throws Diagnostics, and Error where a letter has parameters.
WordObject word_of(const std::string& text, const Alphabet& alphabet);

/// For each letter of one alphabet that of the same name in another; new letters are added to it.
std::vector<Symbol> letters_in(Alphabet& alphabet, const Alphabet& of);

/// The word over another alphabet, whose letters have the same names; new letters are added to it.
Word over(const WordObject& word, Alphabet& alphabet);

/// A system as it was read. Objects that were made of it share it.
struct SystemObject {
    std::shared_ptr<const Model> model;

    const Model& operator*() const { return *model; }
    const Model* operator->() const { return model.get(); }
};

/// Systems that a text names, by name.
using NamedSystems = std::vector<std::pair<std::string, SystemObject>>;

/// The one-dimensional array of these values, which it takes over: nothing is copied.
template <class Vector>
py::array as_array(Vector values, std::vector<py::ssize_t> shape = {}) {
    auto held = std::make_unique<Vector>(std::move(values));
    if (shape.empty()) shape = {static_cast<py::ssize_t>(held->size())};
    const auto* data = held->data();
    py::capsule owner(held.release(), [](void* vector) { delete static_cast<Vector*>(vector); });
    return py::array_t<typename Vector::value_type>(std::move(shape), data, owner);
}

// The parts of the module, one for each source.
void add_running(py::module_& module);
void add_values(py::module_& module);
void add_systems(py::module_& module);
void add_growth(py::module_& module);
void add_languages(py::module_& module);
void add_figures(py::module_& module);

}  // namespace algae::python

namespace pybind11::detail {

template <>
struct type_caster<algae::Integer> {
    PYBIND11_TYPE_CASTER(algae::Integer, const_name("int"));
    bool load(handle source, bool) {
        if (!PyIndex_Check(source.ptr())) return false;
        value = algae::python::as_integer(source);
        return true;
    }
    static handle cast(const algae::Integer& value, return_value_policy, handle) {
        return algae::python::as_python(value).release();
    }
};

template <>
struct type_caster<algae::Rational> {
    PYBIND11_TYPE_CASTER(algae::Rational, const_name("fractions.Fraction"));
    bool load(handle source, bool) {
        if (!PyIndex_Check(source.ptr()) && !hasattr(source, "denominator")) return false;
        value = algae::python::as_rational(source);
        return true;
    }
    static handle cast(const algae::Rational& value, return_value_policy, handle) {
        return algae::python::as_python(value).release();
    }
};

}  // namespace pybind11::detail
