#include <algorithm>
#include <limits>

#include "nature/nature.hpp"
#include "notation/detail/generator_values.hpp"

// Systems of particles, `.particles`.
//
// A file first names kinds of particles, each by a line `kind NAME` which the lines about this kind follow
// (speed, angle, life, ...), so these keys may occur once for each kind; the lines about the whole (born,
// gravity, ground, view, ...) may stand anywhere. Kinds may name one another before they are described
// (`bursts KIND COUNT`), so all names are gathered in a first pass over the statements. A number that varies
// from particle to particle is written `MEAN +- SPREAD`. What fits the syntax but not together, such as a
// burst into particles that live for less than a frame, `ParticleShow::check` finds.

namespace algae {

namespace {

constexpr std::uint64_t any = std::numeric_limits<std::uint64_t>::max();
constexpr double infinite = std::numeric_limits<double>::infinity();

/// The words of one statement, taken from the left.
class Words {
public:
    Words(const GeneratorFile& file, const GeneratorStatement& statement, std::string wanted,
          const std::vector<std::string>& kinds)
        : file_(file), statement_(statement), wanted_(std::move(wanted)), kinds_(kinds) {}

    bool more() const { return next_ < statement_.words.size(); }
    bool take(const std::string& text) {
        if (!more() || statement_.words[next_].text != text) return false;
        ++next_;
        return true;
    }
    const GeneratorWord& word() {
        if (!more()) fail();
        return statement_.words[next_++];
    }
    double number(double least, double most) {
        return file_.number(statement_, word(), least, most);
    }
    std::uint64_t natural(std::uint64_t least, std::uint64_t most) {
        return file_.natural(statement_, word(), least, most);
    }
    Point point() { return file_.point(statement_, word()); }
    /// `MEAN` or `MEAN +- SPREAD`.
    Scatter scatter(double least = -infinite) {
        const GeneratorWord& first = word();
        Scatter found{file_.number(statement_, first, least, infinite), 0};
        if (take("+-") || take("±")) found.spread = number(0, infinite);
        if (found.mean - found.spread < least)
            file_.fail(statement_, first,
                       "the number is below " + std::string(least == 0 ? "0" : "1") +
                           " where the spread goes down");
        return found;
    }
    Colour colour() { return file_.colour(statement_, word()); }
    /// The number of the kind that a word names.
    std::size_t kind() {
        const GeneratorWord& name = word();
        const auto found = std::ranges::find(kinds_, name.text);
        if (found == kinds_.end())
            file_.fail(statement_, name,
                       "no kind " + algae::quoted(name.text) + did_you_mean(name.text, kinds_) +
                           "; expected one that a line `kind NAME` begins");
        return static_cast<std::size_t>(found - kinds_.begin());
    }
    void end() const {
        if (more()) fail();
    }

private:
    [[noreturn]] void fail() const {
        if (next_ < statement_.words.size())
            file_.refuse(statement_, statement_.words[next_], wanted_);
        file_.fail(statement_, "expected " + statement_.key + " " + wanted_);
    }

    const GeneratorFile& file_;
    const GeneratorStatement& statement_;
    std::string wanted_;
    const std::vector<std::string>& kinds_;
    std::size_t next_ = 0;
};

/// What is said of a kind of particles: a key, what stands behind it, and how that is read.
struct KindKey {
    const char* name;
    const char* arguments;
    void (*read)(Words&, ParticleKind&);
};

constexpr KindKey kind_keys[] = {
    {"speed", "NUMBER [+- SPREAD]", [](Words& w, ParticleKind& kind) { kind.speed = w.scatter(); }},
    {"angle", "DEGREES [+- SPREAD]",
     [](Words& w, ParticleKind& kind) { kind.angle = w.scatter(); }},
    {"life", "FRAMES [+- SPREAD]", [](Words& w, ParticleKind& kind) { kind.life = w.scatter(1); }},
    {"size", "NUMBER [+- SPREAD]", [](Words& w, ParticleKind& kind) { kind.size = w.scatter(0); }},
    {"tint", "COLOUR [COLOUR]",
     [](Words& w, ParticleKind& kind) {
         kind.born = w.colour();
         kind.dying = w.more() ? w.colour() : kind.born;
     }},
    {"opacity", "SHARE [SHARE]",
     [](Words& w, ParticleKind& kind) {
         kind.opacity_born = w.number(0, 1);
         kind.opacity_dying = w.more() ? w.number(0, 1) : kind.opacity_born;
     }},
    {"weight", "NUMBER",
     [](Words& w, ParticleKind& kind) { kind.weight = w.number(-infinite, infinite); }},
    {"drag", "SHARE", [](Words& w, ParticleKind& kind) { kind.drag = w.number(0, 1); }},
    {"inherits", "SHARE", [](Words& w, ParticleKind& kind) { kind.inherits = w.number(0, 1); }},
    {"trail", "FRAMES", [](Words& w, ParticleKind& kind) { kind.trail = w.natural(0, 1000); }},
    {"bursts", "KIND COUNT [+- SPREAD]", [](Words& w, ParticleKind& kind) {
         kind.bursts_into = w.kind();
         kind.fragments = w.scatter(0);
     }}};

/// The same of the whole; `read` is nullptr where a key is read when all others are.
struct ShowKey {
    const char* name;
    const char* arguments;
    void (*read)(Words&, ParticleShow&);
    bool repeats = false;
};

Emitter emitter(Words& w) {
    Emitter made;
    made.kind = w.kind();
    made.count = w.scatter(0);
    while (w.more()) {
        if (w.take("at"))
            made.from = made.to = w.point();
        else if (w.take("to"))
            made.to = w.point();
        else if (w.take("from"))
            made.first = w.natural(0, any);
        else if (w.take("until"))
            made.last = w.natural(0, any);
        else if (w.take("every"))
            made.every = w.natural(1, any);
        else
            break;
    }
    return made;
}

constexpr ShowKey show_keys[] = {
    {"born", "KIND COUNT [+- SPREAD] at (x,y) [to (x,y)] [from FRAME] [until FRAME] [every N]",
     [](Words& w, ParticleShow& show) { show.system.emitters.push_back(emitter(w)); }, true},
    {"gravity", "NUMBER",
     [](Words& w, ParticleShow& show) {
         show.system.force = {0, -w.number(-infinite, infinite)};
     }},
    {"force", "(x,y)", [](Words& w, ParticleShow& show) { show.system.force = w.point(); }},
    {"ground", "HEIGHT [BOUNCE]",
     [](Words& w, ParticleShow& show) {
         show.system.ground = w.number(-infinite, infinite);
         if (w.more()) show.system.bounce = w.number(0, 1);
     }},
    {"frames", "LAST", nullptr},
    {"show", "FRAME ...", nullptr},
    {"view", "(x,y) (x,y)",
     [](Words& w, ParticleShow& show) {
         show.view.emplace();
         show.view->add(w.point());
         show.view->add(w.point());
     }},
    {"sky", "COLOUR", [](Words& w, ParticleShow& show) { show.sky = w.colour(); }},
    {"seed", "S", nullptr}};

class Reader {
public:
    explicit Reader(const GeneratorFile& file) : file_(file) {}

    std::unique_ptr<Generator> read() {
        auto show = std::make_unique<ParticleShow>();
        file_.describe(*show);
        for (const GeneratorStatement& statement : file_.statements)
            if (statement.key == "kind") name_kind(statement);
        if (names_.empty()) file_.fail("expected a line `kind NAME`, found no kind of particles");
        show->system.kinds.resize(names_.size());
        for (std::size_t i = 0; i < names_.size(); ++i) show->system.kinds[i].name = names_[i];
        std::size_t kind = any;
        for (const GeneratorStatement& statement : file_.statements) {
            if (statement.key == "kind")
                kind = kind + 1;
            else if (const KindKey* key = find(kind_keys, statement.key)) {
                if (kind == any)
                    file_.fail(statement, "expected a line `kind NAME` before " + statement.key);
                read_statement(statement, *key, show->system.kinds[kind]);
            } else if (const ShowKey* of_show = find(show_keys, statement.key);
                       of_show && of_show->read) {
                read_statement(statement, *of_show, *show);
            }
        }
        show->system.seed = seed_value(file_);
        show->shown =
            natural_values(file_, "show", 0, ParticleShow::most_frames).value_or(show->shown);
        show->last_frame = file_.natural("frames", 0, ParticleShow::most_frames)
                               .value_or(*std::max_element(show->shown.begin(), show->shown.end()));
        if (show->system.emitters.empty())
            file_.fail(
                "expected a line `born KIND COUNT at (x,y)`, found no particle that is born");
        try {
            show->check();
        } catch (const Error& error) {
            file_.fail(error.what());
        }
        return show;
    }

private:
    template <class Key, std::size_t count>
    static const Key* find(const Key (&keys)[count], const std::string& name) {
        const auto found = std::ranges::find(keys, name, &Key::name);
        return found == std::end(keys) ? nullptr : found;
    }
    void name_kind(const GeneratorStatement& statement) {
        const GeneratorWord& word = file_.only_word(statement, "NAME");
        const std::string& name = word.text;
        if (std::ranges::count(names_, name) > 0)
            file_.fail(statement, word, "the kind " + algae::quoted(name) + " is there already");
        names_.push_back(name);
    }
    template <class Key, class Read>
    void read_statement(const GeneratorStatement& statement, const Key& key, Read& into) const {
        Words words(file_, statement, key.arguments, names_);
        key.read(words, into);
        words.end();
    }

    const GeneratorFile& file_;
    std::vector<std::string> names_;
};

}  // namespace

GeneratorKind particles_kind() {
    std::vector<GeneratorKey> keys{{"kind", "NAME", true}};
    for (const KindKey& key : kind_keys) keys.push_back({key.name, key.arguments, true});
    for (const ShowKey& key : show_keys) keys.push_back({key.name, key.arguments, key.repeats});
    return {"particles", "a system of particles", std::move(keys),
            [](const GeneratorFile& file) { return Reader(file).read(); }};
}

}  // namespace algae
