#include <cmath>

#include "fold/fold.hpp"
#include "turtle/command_product.hpp"
#include "turtle/plane_figure.hpp"
#include "turtle/visited.hpp"

namespace algae {

namespace {

/// What a row of parts for each of so many steps takes, or the largest number.
std::uint64_t table_bytes(std::uint64_t steps, std::size_t letters) {
    const std::uint64_t row = letters * sizeof(Pieces::value_type) + sizeof(Hom<Pieces>);
    return steps >= UINT64_MAX / row - 1 ? UINT64_MAX : (steps + 1) * row;
}

}  // namespace

std::vector<Hom<Pieces>> PlaneFigure::pieces(const Budget& budget) const {
    const Pieces monoid(compass_);
    budget.check_memory(table_bytes(steps_, rules_.alphabet->size()),
                        "the table of parts of the drawing");
    const auto value_of = [&](Command command) {
        Pieces::value_type value;
        switch (command) {
            case Command::draw:
            case Command::draw_unmarked:
                value.centre = 0.5;
                value.radius = 0.5;
                value.move = 1;
                break;
            case Command::move: value.move = 1; break;
            case Command::left: value.turn = compass_.normal(compass_.turn()); break;
            case Command::right: value.turn = compass_.normal(-compass_.turn()); break;
            case Command::back: value.turn = compass_.half(); break;
            case Command::scale: value.size = pen_.scale; break;
            case Command::narrow: value.width = pen_.narrow; break;
            case Command::next_colour: value.colours = 1; break;
            default: break;
        }
        return value;
    };
    const auto letter = [&](Symbol a) {
        auto value = product(monoid, commands_.of(a), value_of);
        value.letters = 1;
        return value;
    };
    return tower(rules_, steps_, Lift{monoid, letter}, budget);
}

void PlaneFigure::draw_pieces(Canvas& canvas, double resolution, const Budget& budget) const {
    const auto rows = pieces(budget);
    Pen<FloatingPosition> pen(canvas, compass_, pen_);
    const double limit = resolution / std::abs(pen_.unit);
    // The same part at the same place in the same direction draws the same, if nothing else about
    // the pen can differ; of a hue that runs with the word, the first one stays. The smallest parts
    // cost less to draw than to look up.
    const bool plain = !commands_.uses(Command::next_colour) && !commands_.uses(Command::narrow) &&
                       !commands_.uses(Command::scale);
    VisitedParts visited(resolution * 1e-3, budget);
    std::uint64_t visits = 0;
    walk(rules_, fates_, steps_, [&](Symbol a, std::uint64_t left) {
        if (++visits % 65536 == 0) budget.check();
        if (left == 0) {
            pen.letter(commands_.of(a));
            return true;
        }
        const auto& part = rows[left].images[a];
        const double extent = part.extent() * std::abs(pen.size());
        if (extent <= limit) {
            pen.jump(part, true);
            return false;
        }
        if (plain && extent > 4 * limit && !visited.insert(a, left, pen.heading(), pen.point())) {
            pen.jump(part, false);
            return false;
        }
        return true;
    });
    pen.finish();
}

}  // namespace algae
