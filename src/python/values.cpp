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
        let_signals_in(all.size());
        py::tuple parameters(data.kinds.arity(kind));
        for (std::size_t i = 0; i < parameters.size(); ++i)
            parameters[i] = parameter(data, word.alphabet(), *values++);
        all.append(
            py::make_tuple(word.alphabet().name(data.kinds.letter(kind)), std::move(parameters)));
    }
    return all;
}

// Work on words. A check of the budget each so many letters costs nothing, and lets Ctrl-C in.

constexpr std::size_t block = std::size_t{1} << 16;

/// Calls `work(from, to)` for the parts of `size` letters, one after the other.
template <class Work>
void in_blocks(std::size_t size, const Budget& budget, Work work) {
    for (std::size_t from = 0; from < size; from += block) {
        budget.check();
        work(from, std::min(size, from + block));
    }
}

/// Throws BoundReached where a word of so many letters may not be written out.
void check_letters(const Integer& letters, const char* what, const Budget& budget) {
    if (letters > Integer(budget.letters))
        throw BoundReached(Bound::letters, std::string(what) + " has " + readable(letters) +
                                               " letters, more than the " +
                                               std::to_string(budget.letters) + " allowed" +
                                               budget.by(Bound::letters));
    budget.check_memory(letters.to_uint64() * sizeof(Symbol), what);
}

/// Text that somebody waits for, piece by piece.
class StringSink : public TextSink {
public:
    explicit StringSink(const Budget& budget) : budget_(budget) {}
    void write(std::string_view piece) override {
        if (text.size() + piece.size() > text.capacity()) {
            budget_.check();
            budget_.check_memory(2 * (text.size() + piece.size()), "the text");
        }
        text += piece;
    }
    void flush() override {}

    std::string text;

private:
    const Budget& budget_;
};

/// As `spell` and ModuleText write it.
std::string text_of(const WordObject& word, const Budget& budget) {
    if (word.size() == 0) return "ε";
    StringSink sink(budget);
    if (word.modules) {
        ModuleText(word.alphabet(), word.modules->kinds).write(word.modules->word, sink, budget);
        return std::move(sink.text);
    }
    const Spellings spellings(word.alphabet());
    const Symbol* letters = word.begin();
    in_blocks(word.size(), budget, [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) {
            if (i > 0 && spellings.blank_between(letters[i - 1], letters[i])) sink.write(" ");
            sink.write(word.alphabet().name(letters[i]));
        }
    });
    return std::move(sink.text);
}

bool equal(const WordObject& left, const WordObject& right, const Limits& limits) {
    return run(limits, [&](const Budget& budget) {
        if (left.modules || right.modules) return text_of(left, budget) == text_of(right, budget);
        if (left.size() != right.size()) return false;
        std::vector<std::optional<Symbol>> renamed;
        for (Symbol letter = 0; letter < right.alphabet().size(); ++letter)
            renamed.push_back(left.alphabet().find(right.alphabet().name(letter)));
        bool same = true;
        in_blocks(left.size(), budget, [&](std::size_t from, std::size_t to) {
            for (std::size_t i = from; same && i < to; ++i)
                same = renamed[right.begin()[i]] == left.begin()[i];
        });
        return same;
    });
}

WordObject joined_words(const WordObject& left, const WordObject& right, const Limits& limits) {
    auto alphabet = left.shared_alphabet();
    std::vector<Symbol> renamed;
    if (alphabet != right.shared_alphabet()) {
        auto both = std::make_shared<Alphabet>(left.alphabet());
        renamed = letters_in(*both, right.alphabet());
        alphabet = std::move(both);
    }
    Word letters = run(limits, [&](const Budget& budget) {
        check_letters(Integer(left.size()) + Integer(right.size()), "the word", budget);
        Word all;
        all.reserve(left.size() + right.size());
        in_blocks(left.size(), budget, [&](std::size_t from, std::size_t to) {
            all.insert(all.end(), left.begin() + from, left.begin() + to);
        });
        in_blocks(right.size(), budget, [&](std::size_t from, std::size_t to) {
            for (std::size_t i = from; i < to; ++i) {
                const Symbol letter = right.begin()[i];
                all.push_back(renamed.empty() ? letter : renamed[letter]);
            }
        });
        return all;
    });
    return {alphabet, std::move(letters)};
}

WordObject repeated(const WordObject& word, std::uint64_t times, const Limits& limits) {
    Word letters = run(limits, [&](const Budget& budget) {
        Word all;
        if (word.size() == 0) return all;
        check_letters(Integer(word.size()) * Integer(times), "the power", budget);
        const std::size_t size = word.size() * times;
        all.reserve(size);
        in_blocks(size, budget, [&](std::size_t from, std::size_t to) {
            std::size_t at = from % word.size();
            for (std::size_t i = from; i < to; ++i) {
                all.push_back(word.begin()[at]);
                if (++at == word.size()) at = 0;
            }
        });
        return all;
    });
    return {word.shared_alphabet(), std::move(letters)};
}

/// The part over the alphabet of the word; nothing where the word cannot have one of its letters.
std::optional<Word> sought(const WordObject& part, const WordObject& word) {
    Word letters;
    letters.reserve(part.size());
    for (const Symbol letter : part.word()) {
        const auto known = word.alphabet().find(part.alphabet().name(letter));
        if (!known) return std::nullopt;
        letters.push_back(*known);
    }
    return letters;
}

/// Calls `found` with each position from `from` on where the part stands, overlapping ones too, until it answers false. The part is not
/// empty. Knuth, Morris and Pratt: O(letters) steps, however the part repeats itself.
template <class Found>
void each_place(const WordObject& word, const Word& part, std::size_t from, const Budget& budget,
                Found found) {
    if (from >= word.size() || part.size() > word.size() - from) return;
    budget.check_memory(part.size() * sizeof(std::size_t), "the borders of the part");
    std::vector<std::size_t> border(part.size(), 0);  // of the first i + 1 letters, the longest
    for (std::size_t i = 1, k = 0; i < part.size(); ++i) {
        if (i % block == 0) budget.check();
        while (k > 0 && part[i] != part[k]) k = border[k - 1];
        if (part[i] == part[k]) ++k;
        border[i] = k;
    }
    bool goes_on = true;
    std::size_t k = 0;
    in_blocks(word.size() - from, budget, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = from + begin; goes_on && i < from + end; ++i) {
            while (k > 0 && word.begin()[i] != part[k]) k = border[k - 1];
            if (word.begin()[i] == part[k]) ++k;
            if (k < part.size()) continue;
            goes_on = found(i + 1 - part.size());
            k = border[k - 1];
        }
    });
}

/// The position of the first place from `from` on where the part stands; -1 where there is none.
std::int64_t find(const WordObject& word, const WordObject& part, std::size_t from,
                  const Limits& limits) {
    if (from > word.size()) return -1;
    if (part.size() == 0) return static_cast<std::int64_t>(from);
    return run(limits, [&](const Budget& budget) {
        std::int64_t place = -1;
        if (const auto letters = sought(part, word))
            each_place(word, *letters, from, budget, [&](std::size_t at) {
                place = static_cast<std::int64_t>(at);
                return false;
            });
        return place;
    });
}

/// At how many places the part stands, overlapping ones too.
std::uint64_t count(const WordObject& word, const WordObject& part, const Limits& limits) {
    if (part.size() == 0) return word.size() + 1;
    return run(limits, [&](const Budget& budget) {
        std::uint64_t places = 0;
        if (const auto letters = sought(part, word))
            each_place(word, *letters, 0, budget, [&](std::size_t) {
                ++places;
                return true;
            });
        return places;
    });
}

WordObject picked(const WordObject& word, std::int64_t start, std::int64_t step,
                  std::uint64_t count, const Limits& limits) {
    if (step == 1)
        return word.part(static_cast<std::size_t>(start), static_cast<std::size_t>(start) + count);
    Word letters = run(limits, [&](const Budget& budget) {
        check_letters(Integer(count), "the slice", budget);
        Word all;
        all.reserve(count);
        in_blocks(count, budget, [&](std::size_t from, std::size_t to) {
            for (std::size_t i = from; i < to; ++i)
                all.push_back(word.begin()[start + static_cast<std::int64_t>(i) * step]);
        });
        return all;
    });
    return {word.shared_alphabet(), std::move(letters)};
}

std::vector<std::uint64_t> counts(const WordObject& word, const Limits& limits) {
    return run(limits, [&](const Budget& budget) {
        std::vector<std::uint64_t> found(word.alphabet().size());
        in_blocks(word.size(), budget, [&](std::size_t from, std::size_t to) {
            for (std::size_t i = from; i < to; ++i) ++found[word.begin()[i]];
        });
        return found;
    });
}

/// The letters as the library has them, for reading only: the array keeps the word.
py::array letters_array(const WordObject& word) {
    auto held = std::make_unique<std::shared_ptr<const Word>>(word.owner());
    py::capsule owner(held.release(),
                      [](void* kept) { delete static_cast<std::shared_ptr<const Word>*>(kept); });
    py::array_t<Symbol> found(static_cast<py::ssize_t>(word.size()), word.begin(), owner);
    found.attr("setflags")(false);
    return found;
}

py::array bytes_array(const WordObject& word, const Limits& limits) {
    if (word.alphabet().size() > 256)
        throw Error("the alphabet has " + std::to_string(word.alphabet().size()) +
                    " letters, and 256 fit a byte; expected dtype uint32");
    return as_array(run(limits, [&](const Budget& budget) {
        budget.check_memory(word.size(), "the array");
        std::vector<std::uint8_t> bytes(word.size());
        in_blocks(word.size(), budget, [&](std::size_t from, std::size_t to) {
            for (std::size_t i = from; i < to; ++i)
                bytes[i] = static_cast<std::uint8_t>(word.begin()[i]);
        });
        return bytes;
    }));
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
    const std::vector<Symbol> renamed = letters_in(alphabet, *of.alphabet);
    for (const Symbol letter : of.morphism.domain())
        found.add(renamed[letter], replaced(of.morphism[letter], renamed));
    return found;
}

/// The image of letters that all have one, as part of a result that may have so many letters in all.
Word applied(const Morphism& morphism, const Word& letters, std::uint64_t before, const char* what,
             const Budget& budget) {
    Integer size = before;
    in_blocks(letters.size(), budget, [&](std::size_t from, std::size_t to) {
        std::uint64_t more = 0;
        for (std::size_t i = from; i < to; ++i) more += morphism[letters[i]].size();
        size += Integer(more);
    });
    check_letters(size, what, budget);
    Word found;
    found.reserve(size.to_uint64() - before);
    std::size_t checked = 0;
    for (const Symbol letter : letters) {
        const Word& image = morphism[letter];
        found.insert(found.end(), image.begin(), image.end());
        if (found.size() - checked < block) continue;
        checked = found.size();
        budget.check();
    }
    return found;
}

WordObject image(const MorphismObject& of, const WordObject& word, const Limits& limits) {
    auto alphabet = std::make_shared<Alphabet>(*of.alphabet);
    Word found = run(limits, [&](const Budget& budget) {
        const Word letters = python::over(word, *alphabet);
        in_blocks(letters.size(), budget, [&](std::size_t from, std::size_t to) {
            for (std::size_t i = from; i < to; ++i)
                if (!of.morphism.maps(letters[i]))
                    throw Error("the letter " + alphabet->name(letters[i]) + " has no image");
        });
        return applied(of.morphism, letters, 0, "the image", budget);
    });
    return {alphabet, std::move(found)};
}

/// The letters first to `inner`, then to `outer`, which must have an image for each letter that comes.
MorphismObject composed(const MorphismObject& outer, const MorphismObject& inner,
                        const Limits& limits) {
    auto alphabet = std::make_shared<Alphabet>(*inner.alphabet);
    MorphismObject found{alphabet, {}};
    run(limits, [&](const Budget& budget) {
        const Morphism last = over(outer, *alphabet);
        std::uint64_t letters = 0;
        for (const Symbol letter : inner.morphism.domain()) {
            budget.check();
            for (const Symbol next : inner.morphism[letter])
                if (!last.maps(next))
                    throw Error("the letter " + alphabet->name(next) +
                                " has no image under the second morphism");
            Word result = applied(last, inner.morphism[letter], letters, "the composition", budget);
            letters += result.size();
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

std::vector<Symbol> letters_in(Alphabet& alphabet, const Alphabet& of) {
    std::vector<Symbol> renamed(of.size());
    for (Symbol letter = 0; letter < renamed.size(); ++letter)
        renamed[letter] = alphabet.symbol(of.name(letter));
    return renamed;
}

Word over(const WordObject& word, Alphabet& alphabet) {
    return replaced(word.word(), letters_in(alphabet, word.alphabet()));
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
        .def(
            "text",
            [](const WordObject& word, const Limits& limits) {
                return run(limits, [&](const Budget& budget) { return text_of(word, budget); });
            },
            py::arg("limits"))
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
                 for (std::size_t i = 0; i < word.size(); ++i) {
                     let_signals_in(i);
                     all[i] = names[word.begin()[i]];
                 }
                 return all;
             })
        .def("alphabet",
             [](const WordObject& word) {
                 std::vector<std::string> names;
                 for (Symbol letter = 0; letter < word.alphabet().size(); ++letter)
                     names.push_back(word.alphabet().name(letter));
                 return names;
             })
        .def(
            "counts",
            [](const WordObject& word, const Limits& limits) {
                return as_array(counts(word, limits));
            },
            py::arg("limits"))
        .def("part", picked, py::arg("start"), py::arg("step"), py::arg("count"), py::arg("limits"))
        .def("join", joined_words, py::arg("right"), py::arg("limits"))
        .def("repeat", repeated, py::arg("times"), py::arg("limits"))
        .def("find", find, py::arg("part"), py::arg("from_"), py::arg("limits"))
        .def("count", count, py::arg("part"), py::arg("limits"))
        .def("equals", equal, py::arg("other"), py::arg("limits"))
        .def("array", letters_array)
        .def("bytes", bytes_array, py::arg("limits"))
        .def("has_parameters", [](const WordObject& word) { return word.modules != nullptr; })
        .def("modules", modules_of)
        .def("latex",
             [](const WordObject& word) {
                 constexpr std::size_t most = 120;  // letters
                 const std::size_t shown = std::min(word.size(), most);
                 std::string text = word_latex(word.alphabet(), word.part(0, shown).word());
                 if (shown < word.size())
                     text += "\\dots\\ \\text{(" + std::to_string(word.size()) + " letters)}";
                 return text;
             })
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
