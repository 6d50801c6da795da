// Numbers and words between Python and the library.
//
// Integers go as bytes, cut in halves: the face of `exact` has no other way that is exact and fast for millions of digits, and Python refuses
// to read decimals of more than 4,300 digits. A word is a run of letters that slices and arrays share with it.

#include "python/detail/values.hpp"

#include <algorithm>
#include <map>
#include <span>

#include "combinatorics/combinatorics.hpp"
#include "notation/notation.hpp"
#include "python/detail/running.hpp"
#include "report/report.hpp"

namespace algae::python {

namespace {

/// Writes the lowest bytes of a number that is not negative, the lowest first.
void write_bytes(const Integer& value, std::span<char> to) {
    constexpr std::size_t machine = 7;  // bytes that fit into any machine number
    if (to.size() <= machine) {
        std::uint64_t rest = value.to_uint64();
        for (char& byte : to) {
            byte = static_cast<char>(rest & 0xFF);
            rest >>= 8;
        }
        return;
    }
    const std::size_t half = to.size() / 2;
    const Integer cut = power(Integer(2), 8 * half);
    const Integer high = floor_divide(value, cut);
    write_bytes(value - high * cut, to.first(half));
    write_bytes(high, to.subspan(half));
}

Integer read_bytes(std::span<const char> from) {
    constexpr std::size_t machine = 7;
    if (from.size() <= machine) {
        std::uint64_t value = 0;
        for (std::size_t i = from.size(); i-- > 0;)
            value = value << 8 | static_cast<unsigned char>(from[i]);
        return value;
    }
    const std::size_t half = from.size() / 2;
    return read_bytes(from.first(half)) +
           read_bytes(from.subspan(half)) * power(Integer(2), 8 * half);
}

py::object int_type() { return py::reinterpret_borrow<py::object>((PyObject*)&PyLong_Type); }

/// A parameter of a module: an int or Fraction where it is rational, the text of another exact number, a word, or a double.
py::object parameter(const ModuleData& data, const Alphabet& alphabet, double value) {
    const WordValues* words = data.kinds.words();
    if (words && WordValues::is_word(value))
        return py::cast(ModuleText(alphabet, data.kinds).text(words->word(value)));
    if (words && words->is_exact()) {
        const WordValues::Known known = words->known(value);
        if (known.exact && known.exact->is_rational()) {
            const Rational& rational = known.exact->rational;
            return rational.is_integer() ? py::object(as_python(rational.numerator()))
                                         : as_python(rational);
        }
        if (known.within) return py::float_(known.within->midpoint());
        return py::float_(enclosure(*known.exact, 64).midpoint());
    }
    return py::float_(value);
}

py::list modules_of(const WordObject& word) {
    py::list all;
    const ModuleData& data = *word.modules;
    const double* values = data.word.values.data();
    for (const ModuleKind kind : data.word.kinds) {
        py::tuple parameters(data.kinds.arity(kind));
        for (std::size_t i = 0; i < parameters.size(); ++i)
            parameters[i] = parameter(data, word.alphabet(), *values++);
        all.append(
            py::make_tuple(word.alphabet().name(data.kinds.letter(kind)), std::move(parameters)));
    }
    return all;
}

std::string text_of(const WordObject& word) {
    if (!word.modules) return spell(word.alphabet(), word.word());
    return ModuleText(word.alphabet(), word.modules->kinds).text(word.modules->word);
}

/// Both words over one alphabet, that of the first with the letters of the second.
struct Pair {
    std::shared_ptr<Alphabet> alphabet;
    Word left, right;
};

Pair over_one(const WordObject& left, const WordObject& right) {
    Pair pair{std::make_shared<Alphabet>(left.alphabet()), left.word(), {}};
    pair.right = over(right, *pair.alphabet);
    return pair;
}

bool equal(const WordObject& left, const WordObject& right) {
    if (left.modules || right.modules) return text_of(left) == text_of(right);
    if (left.size() != right.size()) return false;
    if (&left.alphabet() == &right.alphabet())
        return std::equal(left.begin(), left.end(), right.begin());
    for (std::size_t i = 0; i < left.size(); ++i)
        if (left.alphabet().name(left.begin()[i]) != right.alphabet().name(right.begin()[i]))
            return false;
    return true;
}

WordObject joined_words(const WordObject& left, const WordObject& right) {
    Pair pair = over_one(left, right);
    pair.left.insert(pair.left.end(), pair.right.begin(), pair.right.end());
    return {pair.alphabet, std::move(pair.left)};
}

WordObject repeated(const WordObject& word, std::uint64_t times, const Limits& limits) {
    Word letters = run(limits, [&](const Budget& budget) {
        if (word.size() > 0 && times > budget.memory / sizeof(Symbol) / word.size())
            throw BoundReached(Bound::memory, "the power takes more than " +
                                                  std::to_string(budget.memory) + " bytes" +
                                                  budget.by(Bound::memory));
        Word all;
        all.reserve(word.size() * times);
        for (std::uint64_t i = 0; i < times; ++i) all.insert(all.end(), word.begin(), word.end());
        return all;
    });
    return {word.shared_alphabet(), std::move(letters)};
}

/// The position of the first place from `from` on where the part stands; -1 where there is none.
std::int64_t find(const WordObject& word, const WordObject& part, std::size_t from) {
    if (from > word.size()) return -1;
    const Pair pair = over_one(word, part);
    const auto found = std::search(pair.left.begin() + static_cast<std::ptrdiff_t>(from),
                                   pair.left.end(), pair.right.begin(), pair.right.end());
    if (found == pair.left.end() && !pair.right.empty()) return -1;
    return found - pair.left.begin();
}

WordObject picked(const WordObject& word, std::int64_t start, std::int64_t step,
                  std::uint64_t count) {
    if (step == 1)
        return word.part(static_cast<std::size_t>(start), static_cast<std::size_t>(start) + count);
    Word letters;
    for (std::uint64_t i = 0; i < count; ++i, start += step) letters.push_back(word.begin()[start]);
    return {word.shared_alphabet(), std::move(letters)};
}

/// The letters as the library has them, for reading only: the array keeps the word.
py::array letters_array(const WordObject& word) {
    auto held = std::make_unique<std::shared_ptr<const Word>>(word.owner());
    py::capsule owner(held.release(),
                      [](void* kept) { delete static_cast<std::shared_ptr<const Word>*>(kept); });
    py::array_t<Symbol> found(static_cast<py::ssize_t>(word.size()), word.begin(), owner);
    found.attr("setflags")(false);
    return std::move(found);
}

py::array bytes_array(const WordObject& word) {
    if (word.alphabet().size() > 256)
        throw Error("the alphabet has " + std::to_string(word.alphabet().size()) +
                    " letters, and 256 fit a byte; expected dtype uint32");
    std::vector<std::uint8_t> bytes(word.size());
    std::transform(word.begin(), word.end(), bytes.begin(),
                   [](Symbol letter) { return static_cast<std::uint8_t>(letter); });
    return as_array(std::move(bytes));
}

std::string report_json(const WordObject& word, const Limits& limits) {
    const WordReport report = run(limits, [&](const Budget& budget) {
        std::vector<std::string> names;
        for (Symbol letter = 0; letter < word.alphabet().size(); ++letter)
            names.push_back(word.alphabet().name(letter));
        // Letters are numbered in the order of their names, which counts for Lyndon words.
        const std::vector<std::uint32_t> ranks = word.alphabet().ranks();
        std::vector<std::string> ordered(names.size());
        for (std::size_t i = 0; i < names.size(); ++i) ordered[ranks[i]] = names[i];
        Word letters;
        for (const Symbol letter : word.word()) letters.push_back(ranks[letter]);
        return word_report(std::move(letters), std::move(ordered), budget);
    });
    return to_json(report).text(-1);
}

/// A morphism with the alphabet of its letters, before and behind the arrows.
struct MorphismObject {
    std::shared_ptr<const Alphabet> alphabet;
    Morphism morphism;
};

MorphismObject morphism_of(const std::vector<std::pair<std::string, std::string>>& images) {
    auto alphabet = std::make_shared<Alphabet>();
    MorphismObject made;
    for (const auto& [letter, image] : images) alphabet->symbol(letter);  // longer names too
    for (const auto& [letter, image] : images) {
        const ModuleWord word = read_word(image, *alphabet);
        if (!word.arguments.empty())
            throw Error("the image of " + letter + " has parameters: " + image +
                        "; a morphism has words of letters alone");
        if (!made.morphism.add(*alphabet->find(letter), word.letters))
            throw Error("the letter " + letter + " has two images");
    }
    made.alphabet = std::move(alphabet);
    return made;
}

/// The images over another alphabet.
Morphism over(const MorphismObject& of, Alphabet& alphabet) {
    Morphism found;
    std::vector<Symbol> renamed;
    for (Symbol letter = 0; letter < of.alphabet->size(); ++letter)
        renamed.push_back(alphabet.symbol(of.alphabet->name(letter)));
    for (const Symbol letter : of.morphism.domain())
        found.add(renamed[letter], replaced(of.morphism[letter], renamed));
    return found;
}

WordObject image(const MorphismObject& of, const WordObject& word, const Limits& limits) {
    auto alphabet = std::make_shared<Alphabet>(*of.alphabet);
    const Word letters = python::over(word, *alphabet);
    for (const Symbol letter : letters)
        if (!of.morphism.maps(letter))
            throw Error("the letter " + alphabet->name(letter) + " has no image");
    Word found = run(limits, [&](const Budget& budget) {
        std::uint64_t size = 0;
        for (const Symbol letter : letters) size += of.morphism[letter].size();
        if (size > budget.letters)
            throw BoundReached(Bound::letters, "the image has " + std::to_string(size) +
                                                   " letters, more than the " +
                                                   std::to_string(budget.letters) + " allowed" +
                                                   budget.by(Bound::letters));
        return of.morphism(letters);
    });
    return {alphabet, std::move(found)};
}

/// The letters first to `inner`, then to `outer`, which must have an image for each letter that comes.
MorphismObject composed(const MorphismObject& outer, const MorphismObject& inner,
                        const Limits& limits) {
    auto alphabet = std::make_shared<Alphabet>(*inner.alphabet);
    const Morphism last = over(outer, *alphabet);
    MorphismObject found{alphabet, {}};
    run(limits, [&](const Budget& budget) {
        std::uint64_t letters = 0;
        for (const Symbol letter : inner.morphism.domain()) {
            budget.check();
            for (const Symbol next : inner.morphism[letter])
                if (!last.maps(next))
                    throw Error("the letter " + alphabet->name(next) +
                                " has no image under the second morphism");
            Word result = last(inner.morphism[letter]);
            letters += result.size();
            if (letters > budget.letters)
                throw BoundReached(Bound::letters, "the images have more than the " +
                                                       std::to_string(budget.letters) +
                                                       " letters allowed" +
                                                       budget.by(Bound::letters));
            found.morphism.add(letter, std::move(result));
        }
    });
    return found;
}

}  // namespace

py::int_ as_python(const Integer& value) {
    if (value.fits_int64()) return py::int_(value.to_int64());
    std::string bytes(static_cast<std::size_t>(bit_length(value) / 8 + 1), '\0');
    write_bytes(abs(value), bytes);
    const py::object found = int_type().attr("from_bytes")(py::bytes(bytes), py::str("little"));
    return py::int_(sign(value) < 0 ? py::object(-found) : found);
}

py::object as_python(const Rational& value) {
    return py::module_::import("fractions")
        .attr("Fraction")(as_python(value.numerator()), as_python(value.denominator()));
}

Integer as_integer(py::handle object) {
    const auto number = py::reinterpret_steal<py::object>(PyNumber_Index(object.ptr()));
    if (!number) throw py::error_already_set();
    int overflow = 0;
    const long long small = PyLong_AsLongLongAndOverflow(number.ptr(), &overflow);
    if (overflow == 0) return Integer(static_cast<std::int64_t>(small));
    const auto size = py::reinterpret_steal<py::object>(PyNumber_Absolute(number.ptr()));
    const auto bits = number.attr("bit_length")().cast<std::size_t>();
    const auto bytes = size.attr("to_bytes")(bits / 8 + 1, "little").cast<std::string>();
    const Integer found = read_bytes(bytes);
    return overflow < 0 ? -found : found;
}

Rational as_rational(py::handle object) {
    if (PyIndex_Check(object.ptr())) return as_integer(object);
    if (!py::hasattr(object, "numerator") || !py::hasattr(object, "denominator"))
        throw py::type_error("expected an int or a Fraction");
    return {as_integer(object.attr("numerator")), as_integer(object.attr("denominator"))};
}

WordObject word_of(const std::string& text, const Alphabet& alphabet) {
    auto own = std::make_shared<Alphabet>(alphabet);
    ModuleWord read = read_word(text, *own);
    if (!read.arguments.empty())
        throw Error("the word " + algae::quoted(text) + " has parameters; expected letters alone");
    return {std::move(own), std::move(read.letters)};
}

Word over(const WordObject& word, Alphabet& alphabet) {
    std::vector<Symbol> renamed(word.alphabet().size());
    for (Symbol letter = 0; letter < renamed.size(); ++letter)
        renamed[letter] = alphabet.symbol(word.alphabet().name(letter));
    return replaced(word.word(), renamed);
}

void add_values(py::module_& module) {
    py::class_<WordObject>(module, "Word")
        .def(py::init([](const std::string& text, const std::vector<std::string>& letters) {
                 Alphabet alphabet;
                 for (const std::string& letter : letters) alphabet.symbol(letter);
                 return word_of(text, alphabet);
             }),
             py::arg("text"), py::arg("letters"))
        .def_static(
            "of_letters",
            [](const std::vector<std::string>& letters, const std::vector<std::string>& alphabet) {
                auto names = std::make_shared<Alphabet>();
                for (const std::string& letter : alphabet) names->symbol(letter);
                Word word;
                for (const std::string& letter : letters) {
                    if (letter.empty()) throw Error("a letter has no name: expected a text");
                    word.push_back(names->symbol(letter));
                }
                return WordObject(names, std::move(word));
            },
            py::arg("letters"), py::arg("alphabet"))
        .def("text", text_of)
        .def("size", &WordObject::size)
        .def(
            "letter",
            [](const WordObject& word, std::size_t at) {
                if (at >= word.size()) throw py::index_error();
                return word.alphabet().name(word.begin()[at]);
            },
            py::arg("at"))
        .def("letters",
             [](const WordObject& word) {
                 // One object for each name, however long the word.
                 std::vector<py::object> names;
                 for (Symbol letter = 0; letter < word.alphabet().size(); ++letter)
                     names.emplace_back(py::str(word.alphabet().name(letter)));
                 py::list all(word.size());
                 for (std::size_t i = 0; i < word.size(); ++i) all[i] = names[word.begin()[i]];
                 return all;
             })
        .def("alphabet",
             [](const WordObject& word) {
                 std::vector<std::string> names;
                 for (Symbol letter = 0; letter < word.alphabet().size(); ++letter)
                     names.push_back(word.alphabet().name(letter));
                 return names;
             })
        .def("counts",
             [](const WordObject& word) {
                 std::vector<std::uint64_t> counts(word.alphabet().size());
                 for (const Symbol letter : word.word()) ++counts[letter];
                 return as_array(std::move(counts));
             })
        .def("part", picked, py::arg("start"), py::arg("step"), py::arg("count"))
        .def("join", joined_words, py::arg("right"))
        .def("repeat", repeated, py::arg("times"), py::arg("limits"))
        .def("find", find, py::arg("part"), py::arg("from_"))
        .def("equals", equal, py::arg("other"))
        .def("array", letters_array)
        .def("bytes", bytes_array)
        .def("has_parameters", [](const WordObject& word) { return word.modules != nullptr; })
        .def("modules", modules_of)
        .def("latex",
             [](const WordObject& word) { return word_latex(word.alphabet(), word.word()); })
        .def("report", report_json, py::arg("limits"));

    py::class_<MorphismObject>(module, "Morphism")
        .def(py::init(&morphism_of), py::arg("images"))
        .def("images",
             [](const MorphismObject& of) {
                 std::vector<std::pair<std::string, std::string>> all;
                 for (const Symbol letter : of.morphism.domain())
                     all.emplace_back(of.alphabet->name(letter),
                                      spell(*of.alphabet, of.morphism[letter]));
                 return all;
             })
        .def("words",
             [](const MorphismObject& of) {
                 std::vector<std::pair<std::string, WordObject>> all;
                 for (const Symbol letter : of.morphism.domain())
                     all.emplace_back(of.alphabet->name(letter),
                                      WordObject(of.alphabet, of.morphism[letter]));
                 return all;
             })
        .def("image", image, py::arg("word"), py::arg("limits"))
        .def("compose", composed, py::arg("inner"), py::arg("limits"))
        .def("text", [](const MorphismObject& of) { return to_string(of.morphism, *of.alphabet); });
}

}  // namespace algae::python
