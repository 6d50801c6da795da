#pragma once
// Random expressions for languages over a and b, with small systems of several families for parts.

#include <rapidcheck.h>

#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "language/language.hpp"
#include "oracle/random_tables.hpp"

namespace algae::random {

/// The letters a, b, c, as numbers 0, 1, 2.
inline std::shared_ptr<const Alphabet> letters() {
    auto all = std::make_shared<Alphabet>();
    for (const char* name : {"a", "b", "c"}) all->symbol(name);
    return all;
}

inline Word word_of(const std::string& text) {
    Word word;
    for (const char letter : text) word.push_back(static_cast<Symbol>(letter - 'a'));
    return word;
}

/// Languages and the systems that they speak of.
struct Languages {
    std::vector<Language> all;
    std::vector<std::shared_ptr<const SourceSystem>> systems;
    std::vector<std::string> written;  // one for each system
};

inline std::ostream& operator<<(std::ostream& out, const Languages& languages) {
    for (std::size_t i = 0; i < languages.systems.size(); ++i)
        out << languages.systems[i]->name << " = { " << languages.written[i] << " }\n";
    for (const Language& language : languages.all) out << to_string(language, *letters()) << '\n';
    return out;
}

struct Shape {
    int depth = 2;            // of operations
    bool complements = true;  // and differences and intersections
    bool images_back = true;
    int tables = 2;        // at most, of a system
    int terminals = true;  // systems with letters that are no terminals
};

/// Makes random expressions inside rc::gen::exec.
class Maker {
public:
    explicit Maker(const Shape& shape) : shape_(shape) {}

    Language any() { return of_depth(shape_.depth); }

    Language words() {
        const auto some = *rc::gen::mapcat(rc::gen::inRange(0, 4), [](int count) {
            return rc::gen::container<std::vector<std::string>>(static_cast<std::size_t>(count),
                                                                oracle::any_word("ab", 3));
        });
        std::vector<Word> all;
        for (const std::string& text : some) all.push_back(word_of(text));
        return words_language(std::move(all));
    }

    std::shared_ptr<const SourceSystem> system() {
        oracle::WrittenTables written;
        const int form = *rc::gen::inRange(0, 6);  // D0L twice, 0L twice, tables, terminals
        const bool extended = form == 5 && shape_.terminals;
        const std::string used = extended ? "abc" : "ab";
        const int tables = form == 4 ? shape_.tables : 1;
        const int choices = form < 2 ? 1 : 2;
        for (int t = 0; t < tables; ++t) {
            written.tables.emplace_back();
            for (const char letter : used) {
                const int count = choices == 1 ? 1 : *rc::gen::inRange(0, 3);
                for (int i = 0; i < count; ++i)
                    written.tables.back()[letter].push_back(*oracle::any_word(used, 2));
            }
        }
        written.axiom = *oracle::any_nonempty_word(used, 2);
        if (extended) written.terminals = *rc::gen::elementOf(std::vector<std::string>{"ab", "a"});
        std::ostringstream text;
        text << written;
        auto made = std::make_shared<SourceSystem>();
        made->name = "G" + std::to_string(made_.systems.size() + 1);
        made->tables = oracle::et0l_of(written);
        made->tables->name = made->name;
        made_.systems.push_back(made);
        made_.written.push_back(text.str());
        return made;
    }

    Morphism morphism() {
        const Word first = word_of(*oracle::any_word("ab", 2)),
                   second = word_of(*oracle::any_word("ab", 2));
        if (*rc::gen::inRange(0, 6) == 0) return {{0, first}};
        return {{0, first}, {1, second}};
    }

    Languages made(std::vector<Language> all) {
        Languages result = made_;
        result.all = std::move(all);
        return result;
    }

private:
    Language of_depth(int depth) {
        using Kind = LanguageTree::Kind;
        if (depth == 0 || *rc::gen::inRange(0, 5) == 0)
            return *rc::gen::inRange(0, 3) == 0 ? words() : generated_language(system());
        const auto part = [&] { return of_depth(depth - 1); };
        switch (*rc::gen::inRange(0, 12)) {
            case 0:
                return combined(Kind::united, {part(), part()});
            case 1:
                return shape_.complements ? combined(Kind::intersected, {part(), part()}) : part();
            case 2:
                return shape_.complements ? combined(Kind::difference, {part(), part()}) : part();
            case 3:
            case 4:
                return combined(Kind::concatenated, {part(), part()});
            case 5:
                return combined(Kind::star, {part()});
            case 6:
                return combined(Kind::plus, {part()});
            case 7:
                return shape_.complements ? complement_language(part(), {0, 1}) : part();
            case 8:
                return combined(Kind::reversed, {part()});
            case 9:
            case 10:
                return image_language(part(), morphism());
            default:
                return shape_.images_back ? inverse_image_language(part(), morphism()) : part();
        }
    }

    Shape shape_;
    Languages made_;
};

inline rc::Gen<Languages> any_language(Shape shape = {}) {
    return rc::gen::resize(100, rc::gen::exec([shape] {
                               Maker make(shape);
                               return make.made({make.any()});
                           }));
}

inline rc::Gen<Languages> any_languages(Shape shape = {}) {
    return rc::gen::resize(100, rc::gen::exec([shape] {
                               Maker make(shape);
                               Language left = make.any(), right = make.any();
                               return make.made({std::move(left), std::move(right)});
                           }));
}

/// Two expressions that say the same by a law of the operations.
inline rc::Gen<Languages> any_law(Shape shape = {}) {
    return rc::gen::resize(
        100, rc::gen::exec([shape] {
            using Kind = LanguageTree::Kind;
            Maker make(shape);
            const Language a = make.any(), b = make.any(),
                           all = complement_language(words_language({}), {0, 1});
            const auto both = [](Kind kind, Language left, Language right) {
                return combined(kind, {std::move(left), std::move(right)});
            };
            const auto no = [](Language language) {
                return complement_language(std::move(language), {0, 1});
            };
            switch (*rc::gen::inRange(0, 8)) {
                case 0:
                    return make.made({both(Kind::united, a, b), both(Kind::united, b, a)});
                case 1:
                    return make.made({combined(Kind::star, {combined(Kind::star, {a})}),
                                      combined(Kind::star, {a})});
                case 2:
                    return make.made({no(no(a)), both(Kind::intersected, a, all)});
                case 3:
                    return make.made(
                        {no(both(Kind::united, a, b)), both(Kind::intersected, no(a), no(b))});
                case 4:
                    return make.made({combined(Kind::reversed, {both(Kind::concatenated, a, b)}),
                                      both(Kind::concatenated, combined(Kind::reversed, {b}),
                                           combined(Kind::reversed, {a}))});
                case 5:
                    return make.made(
                        {both(Kind::difference, a, b), both(Kind::intersected, a, no(b))});
                case 6:
                    return make.made({combined(Kind::plus, {a}),
                                      both(Kind::concatenated, a, combined(Kind::star, {a}))});
                default:
                    return make.made(
                        {combined(Kind::reversed, {combined(Kind::reversed, {a})}), a});
            }
        }));
}

}  // namespace algae::random
