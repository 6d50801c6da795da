#include "turtle/detail/plane_figure.hpp"

#include <algorithm>
#include <array>
#include <complex>
#include <memory>
#include <utility>

// Drawing on the lattice in blocks: the fast way to draw every stroke.
//
// What a letter draws in its last few steps depends on its heading alone, up to a translation, and on
// the lattice translations are exact. So a block holds these strokes in whole numbers from where the
// letter starts; drawing it is one addition and one conversion for each point. Blocks are made when they
// are first drawn, one for each letter and heading, and stand for at most 400 letters, so that those of
// all headings stay in a fast cache.
//
// The strokes must be those of Pen<LatticePosition> number for number, also in where the pen is lifted: a
// block says whether it begins with a stroke (then a pen that is already there goes on), whether it leaves
// the pen as it was, and whether it ends with a stroke.

namespace algae {

namespace {

/// How many letters a block may stand for: so many that the walk between them costs little, so few
/// that the blocks of all headings stay in a fast cache.
constexpr std::size_t most_letters = 400;
/// The same where a canvas keeps blocks: of each, and of those of all letters together in one direction.
constexpr std::size_t most_letters_kept = 4000, all_letters_kept = 64'000;

/// A place on the lattice: coordinates over a root of unity.
template <std::size_t degree>
using Place = std::array<std::int64_t, degree>;

/// What a letter draws from where it starts, the turtle looking in one direction.
template <std::size_t degree>
struct Block {
    struct Stroke {
        std::array<std::int32_t, degree> to;
        bool lifted;  // starts with the pen up: `to` is where it is set down, no stroke
    };
    std::vector<Stroke> strokes;
    bool begins_with_stroke = false;  // from where the letter starts: a pen that is there goes on
    bool keeps_pen = true;            // neither draws nor moves
    bool ends_with_stroke = false;
    Place<degree> move{};
    Compass::Heading turn = 0;
    StrokeBlock kept = {};  // the same for a canvas that keeps it; then there are no strokes
};

template <std::size_t degree>
class BlockPen {
public:
    BlockPen(const D0L& rules, const Fates& fates, std::uint64_t steps, const Commands& commands,
             const Compass& compass, const PenSettings& settings, Canvas& canvas)
        : rules_(rules),
          fates_(fates),
          commands_(commands),
          compass_(compass),
          settings_(settings),
          canvas_(canvas),
          keeper_(dynamic_cast<BlockCanvas*>(&canvas)),
          most_letters_(keeper_ ? std::clamp(all_letters_kept / rules.alphabet->size(),
                                             most_letters, most_letters_kept)
                                : most_letters),
          ring_(static_cast<long>(compass.order())),
          heading_(compass.start()) {
        for (std::size_t i = 0; i < degree; ++i)
            basis_[i] = compass.direction(static_cast<Compass::Heading>(i));
        while (depth_ < steps && depth_ < 64 && longest(depth_ + 1) <= most_letters_) ++depth_;
        for (auto& blocks : blocks_)
            blocks.resize(rules.alphabet->size() * static_cast<std::size_t>(compass.order()));
    }

    /// How many steps a block stands for.
    std::uint64_t depth() const { return depth_; }

    /// Draws what is left of the letter after `left` steps, which are 0 or depth().
    void letter(Symbol a, std::uint64_t left) {
        if (const auto& brackets = rules_.brackets;
            brackets && (a == brackets->open || a == brackets->close)) {
            bracket(a == brackets->open);
            return;
        }
        auto& block = blocks_[left == 0 ? 0 : 1][a * static_cast<std::size_t>(compass_.order()) +
                                                 static_cast<std::size_t>(heading_)];
        if (!block) {
            block = std::make_unique<Block<degree>>(block_of(a, left));
            if (keeper_) keep(*block);
        }
        draw(*block);
    }

private:
    struct State {
        Place<degree> place;
        Compass::Heading heading;
    };

    /// The number of letters of the longest word that a letter becomes in so many steps.
    std::size_t longest(std::uint64_t steps) const {
        std::vector<std::size_t> lengths(rules_.alphabet->size(), 1);
        for (; steps > 0; --steps) {
            std::vector<std::size_t> next(lengths);
            for (const Symbol a : rules_.letters) {
                next[a] = 0;
                for (const Symbol b : rules_.successor(a))
                    next[a] = std::min(next[a] + lengths[b], 2 * most_letters_);
            }
            lengths = std::move(next);
        }
        std::size_t most = 0;
        for (const Symbol a : rules_.letters) most = std::max(most, lengths[a]);
        return most;
    }

    /// Works out a block by walking it.
    Block<degree> block_of(Symbol a, std::uint64_t left) const {
        Block<degree> block;
        std::vector<State> saved;
        Place<degree> here{};
        Compass::Heading heading = heading_;
        bool drawing = true, fresh = true;  // whether the pen is at `here`; nothing happened yet
        const auto put = [&](bool lifted) {
            typename Block<degree>::Stroke stroke{{}, lifted};
            for (std::size_t i = 0; i < degree; ++i)
                stroke.to[i] = static_cast<std::int32_t>(here[i]);
            block.strokes.push_back(stroke);
        };
        const auto step = [&] {
            const auto unit = ring_.power(static_cast<long>(heading));
            for (std::size_t i = 0; i < degree; ++i) here[i] += unit[i];
        };
        const auto run = [&](Command command) {
            switch (command) {
                case Command::draw:
                case Command::draw_unmarked:
                    if (fresh) block.begins_with_stroke = true;
                    if (!drawing) put(true);
                    step();
                    put(false);
                    drawing = true;
                    fresh = block.keeps_pen = false;
                    break;
                case Command::move:
                    step();
                    drawing = fresh = block.keeps_pen = false;
                    break;
                case Command::left:
                case Command::right:
                case Command::back:
                    heading = compass_.sum(heading, compass_.turn_of(command));
                    break;
                case Command::push:
                    saved.push_back({here, heading});
                    break;
                case Command::pop:
                    here = saved.back().place;
                    heading = saved.back().heading;
                    saved.pop_back();
                    drawing = fresh = block.keeps_pen = false;
                    break;
                default:
                    break;
            }
        };
        D0L one = rules_;
        one.axiom = Word{a};
        walk(one, fates_, left, [&](Symbol b, std::uint64_t rest) {
            if (rest == 0)
                for (const Command command : commands_.of(b)) run(command);
            return true;
        });
        block.move = here;
        block.turn = compass_.sum(heading, -heading_);
        block.ends_with_stroke = drawing;
        return block;
    }

    Point point(const Place<degree>& place) const {
        double x = 0, y = 0;
        for (std::size_t i = 0; i < degree; ++i) {
            x += static_cast<double>(place[i]) * basis_[i].real();
            y += static_cast<double>(place[i]) * basis_[i].imag();
        }
        return {settings_.start.x + settings_.unit * x, settings_.start.y + settings_.unit * y};
    }

    /// Makes of the strokes what a canvas that keeps blocks gets.
    void keep(Block<degree>& block) {
        block.kept.number = kept_++;
        block.kept.strokes.reserve(block.strokes.size());
        for (const auto& stroke : block.strokes) {
            double x = 0, y = 0;
            for (std::size_t i = 0; i < degree; ++i) {
                x += stroke.to[i] * basis_[i].real();
                y += stroke.to[i] * basis_[i].imag();
            }
            block.kept.strokes.push_back({{settings_.unit * x, settings_.unit * y}, stroke.lifted});
        }
        block.strokes = {};
    }

    void draw(const Block<degree>& block) {
        if (block.begins_with_stroke && !at_pen_) canvas_.move_to(point(here_));
        if (!block.kept.strokes.empty()) keeper_->block(block.kept, point(here_));
        for (const auto& stroke : block.strokes) {
            Place<degree> to = here_;
            for (std::size_t i = 0; i < degree; ++i) to[i] += stroke.to[i];
            if (stroke.lifted)
                canvas_.move_to(point(to));
            else
                canvas_.line_to(point(to));
        }
        for (std::size_t i = 0; i < degree; ++i) here_[i] += block.move[i];
        heading_ = compass_.sum(heading_, block.turn);
        if (!block.keeps_pen) at_pen_ = block.ends_with_stroke;
    }

    void bracket(bool opens) {
        if (opens) {
            saved_.push_back({here_, heading_});
            return;
        }
        here_ = saved_.back().place;
        heading_ = saved_.back().heading;
        saved_.pop_back();
        at_pen_ = false;
    }

    const D0L& rules_;
    const Fates& fates_;
    const Commands& commands_;
    const Compass& compass_;
    const PenSettings& settings_;
    Canvas& canvas_;
    BlockCanvas* keeper_;       // the canvas, if it keeps blocks
    std::size_t most_letters_;  // that a block stands for
    std::size_t kept_ = 0;      // blocks
    CyclotomicRing ring_;
    std::array<std::complex<double>, degree> basis_;
    std::uint64_t depth_ = 0;
    /// By letter and heading: of no steps, and of depth_ steps. Made when first drawn.
    std::array<std::vector<std::unique_ptr<Block<degree>>>, 2> blocks_;
    Place<degree> here_{};
    Compass::Heading heading_;
    std::vector<State> saved_;
    bool at_pen_ = false;
};

template <std::size_t degree>
void draw_all(BlockPen<degree> pen, const D0L& rules, const Fates& fates, std::uint64_t steps,
              const Budget& budget) {
    std::uint64_t visits = 0;
    walk(rules, fates, steps, [&](Symbol a, std::uint64_t left) {
        if (left > pen.depth()) return true;
        pen.letter(a, left);
        if (++visits % 1024 == 0) budget.check();
        return false;
    });
}

}  // namespace

bool draw_lattice_blocks(const D0L& rules, const Fates& fates, std::uint64_t steps,
                         const Commands& commands, const Compass& compass,
                         const PenSettings& settings, Canvas& canvas, const Budget& budget) {
    for (const Command command :
         {Command::open_polygon, Command::close_polygon, Command::vertex, Command::scale,
          Command::narrow, Command::next_colour, Command::cut})
        if (commands.uses(command)) return false;
    if (!compass.is_exact() || canvas.wants_position()) return false;
    const auto draw = [&]<std::size_t degree>() {
        draw_all(BlockPen<degree>(rules, fates, steps, commands, compass, settings, canvas), rules,
                 fates, steps, budget);
        return true;
    };
    switch (CyclotomicRing(static_cast<long>(compass.order())).degree()) {
        case 2:
            return draw.template operator()<2>();
        case 4:
            return draw.template operator()<4>();
        default:
            return false;
    }
}

}  // namespace algae
