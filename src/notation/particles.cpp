#include <algorithm>
#include <limits>

#include "nature/nature.hpp"
#include "notation/detail/relative_values.hpp"

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
    Words(const RelativeFile& file, const RelativeStatement& statement, std::string wanted)
        : file_(file), statement_(statement), wanted_(std::move(wanted)) {}

    bool more() const { return next_ < statement_.words.size(); }
    bool take(const std::string& text) {
        if (!more() || statement_.words[next_].text != text) return false;
        ++next_;
        return true;
    }
    const RelativeWord& word() {
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
    Scatter scatter(double least) {
        const RelativeWord& first = word();
        Scatter found{file_.number(statement_, first, least, infinite), 0};
        if (take("+-") || take("±")) found.spread = number(0, infinite);
        if (found.mean - found.spread < least)
            file_.fail(statement_, first,
                       "the number is below " + std::string(least == 0 ? "0" : "1") +
                           " where the spread goes down");
        return found;
    }
    /// The same of any sign.
    Scatter any_scatter() {
        Scatter found{number(-infinite, infinite), 0};
        if (take("+-") || take("±")) found.spread = number(0, infinite);
        return found;
    }
    Colour colour() {
        const RelativeWord& text = word();
        try {
            return colour_named(text.text);
        } catch (const Error& error) {
            file_.fail(statement_, text, error.what());
        }
    }
    void end() const {
        if (more()) fail();
    }

private:
    [[noreturn]] void fail() const {
        if (next_ < statement_.words.size())
            file_.fail(statement_, statement_.words[next_],
                       "expected " + statement_.key + " " + wanted_ + ", found " +
                           algae::quoted(statement_.words[next_].text));
        file_.fail(statement_, "expected " + statement_.key + " " + wanted_);
    }

    const RelativeFile& file_;
    const RelativeStatement& statement_;
    std::string wanted_;
    std::size_t next_ = 0;
};

const std::vector<RelativeKey>& keys() {
    static const std::vector<RelativeKey> known{
        {"kind", "NAME", true},
        {"speed", "NUMBER [+- SPREAD]", true},
        {"angle", "DEGREES [+- SPREAD]", true},
        {"life", "FRAMES [+- SPREAD]", true},
        {"size", "NUMBER [+- SPREAD]", true},
        {"tint", "COLOUR [COLOUR]", true},
        {"opacity", "SHARE [SHARE]", true},
        {"weight", "NUMBER", true},
        {"drag", "SHARE", true},
        {"inherits", "SHARE", true},
        {"trail", "FRAMES", true},
        {"bursts", "KIND COUNT [+- SPREAD]", true},
        {"born", "KIND COUNT [+- SPREAD] at (x,y) [to (x,y)] [from FRAME] [until FRAME] [every N]",
         true},
        {"gravity", "NUMBER"},
        {"force", "(x,y)"},
        {"ground", "HEIGHT [BOUNCE]"},
        {"frames", "LAST"},
        {"show", "FRAME ..."},
        {"view", "(x,y) (x,y)"},
        {"sky", "COLOUR"},
        {"seed", "S"}};
    return known;
}

class Reader {
public:
    explicit Reader(const RelativeFile& file) : file_(file) {}

    std::unique_ptr<Relative> read() {
        auto show = std::make_unique<ParticleShow>();
        file_.describe(*show);
        for (const RelativeStatement& statement : file_.statements)
            if (statement.key == "kind") name_kind(statement);
        if (names_.empty()) file_.fail("expected a line `kind NAME`, found no kind of particles");
        show->system.kinds.resize(names_.size());
        for (std::size_t i = 0; i < names_.size(); ++i) show->system.kinds[i].name = names_[i];
        std::size_t kind = any;
        for (const RelativeStatement& statement : file_.statements) {
            if (statement.key == "kind")
                kind = kind + 1;
            else if (is_of_kind(statement.key)) {
                if (kind == any)
                    file_.fail(statement, "expected a line `kind NAME` before " + statement.key);
                read_of_kind(statement, show->system.kinds[kind]);
            } else {
                read_of_all(statement, *show);
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
    static const std::string& arguments(const std::string& key) {
        return std::find_if(keys().begin(), keys().end(),
                            [&](const RelativeKey& known) { return known.name == key; })
            ->arguments;
    }
    static bool is_of_kind(const std::string& key) {
        static const std::vector<std::string> of_kind{"speed",    "angle",   "life",   "size",
                                                      "tint",     "opacity", "weight", "drag",
                                                      "inherits", "trail",   "bursts"};
        return std::find(of_kind.begin(), of_kind.end(), key) != of_kind.end();
    }
    void name_kind(const RelativeStatement& statement) {
        file_.check_words(statement, 1, 1, "NAME");
        const std::string& name = statement.words.front().text;
        if (std::find(names_.begin(), names_.end(), name) != names_.end())
            file_.fail(statement, statement.words.front(),
                       "the kind " + algae::quoted(name) + " is there already");
        names_.push_back(name);
    }
    std::size_t kind_named(const RelativeStatement& statement, const RelativeWord& word) const {
        const auto found = std::find(names_.begin(), names_.end(), word.text);
        if (found == names_.end())
            file_.fail(statement, word,
                       "no kind " + algae::quoted(word.text) + did_you_mean(word.text, names_) +
                           "; expected one that a line `kind NAME` begins");
        return static_cast<std::size_t>(found - names_.begin());
    }
    void read_of_kind(const RelativeStatement& statement, ParticleKind& kind) const {
        Words words(file_, statement, arguments(statement.key));
        const std::string& key = statement.key;
        if (key == "speed")
            kind.speed = words.any_scatter();
        else if (key == "angle")
            kind.angle = words.any_scatter();
        else if (key == "life")
            kind.life = words.scatter(1);
        else if (key == "size")
            kind.size = words.scatter(0);
        else if (key == "weight")
            kind.weight = words.number(-infinite, infinite);
        else if (key == "drag")
            kind.drag = words.number(0, 1);
        else if (key == "inherits")
            kind.inherits = words.number(0, 1);
        else if (key == "trail")
            kind.trail = words.natural(0, 1000);
        else if (key == "tint") {
            kind.born = words.colour();
            kind.dying = words.more() ? words.colour() : kind.born;
        } else if (key == "opacity") {
            kind.opacity_born = words.number(0, 1);
            kind.opacity_dying = words.more() ? words.number(0, 1) : kind.opacity_born;
        } else {
            kind.bursts_into = kind_named(statement, words.word());
            kind.fragments = words.scatter(0);
        }
        words.end();
    }
    void read_of_all(const RelativeStatement& statement, ParticleShow& show) const {
        const std::string& key = statement.key;
        const auto known = std::find_if(keys().begin(), keys().end(),
                                        [&](const RelativeKey& k) { return k.name == key; });
        if (known == keys().end() || key == "show" || key == "frames" || key == "seed") return;
        Words words(file_, statement, known->arguments);
        if (key == "gravity")
            show.system.force = {0, -words.number(-infinite, infinite)};
        else if (key == "force")
            show.system.force = words.point();
        else if (key == "sky")
            show.sky = words.colour();
        else if (key == "ground") {
            show.system.ground = words.number(-infinite, infinite);
            if (words.more()) show.system.bounce = words.number(0, 1);
        } else if (key == "view") {
            Box box;
            box.add(words.point());
            box.add(words.point());
            show.view = box;
        } else {
            show.system.emitters.push_back(emitter(statement, words));
        }
        words.end();
    }
    Emitter emitter(const RelativeStatement& statement, Words& words) const {
        Emitter made;
        made.kind = kind_named(statement, words.word());
        made.count = words.scatter(0);
        while (words.more()) {
            if (words.take("at"))
                made.from = made.to = words.point();
            else if (words.take("to"))
                made.to = words.point();
            else if (words.take("from"))
                made.first = words.natural(0, any);
            else if (words.take("until"))
                made.last = words.natural(0, any);
            else if (words.take("every"))
                made.every = words.natural(1, any);
            else
                break;
        }
        return made;
    }

    const RelativeFile& file_;
    std::vector<std::string> names_;
};

}  // namespace

RelativeKind particles_kind() {
    return {"particles", "a system of particles", keys(),
            [](const RelativeFile& file) { return Reader(file).read(); }};
}

}  // namespace algae
