#include "turtle/watched_walk.hpp"

#include <algorithm>

namespace algae {

namespace {

class Watcher : public TurtleEvents {
public:
    Watcher(const std::vector<std::size_t>& symbols, const Vector& start) : symbols_(symbols) {
        watched.low = watched.high = start;
    }
    void before(std::size_t module, const TurtleState& state) override {
        see(state.position);
        if (watched.states.size() < symbols_.size() && symbols_[watched.states.size()] == module)
            watched.states.push_back(state);
    }
    bool wants_modules() const override { return true; }
    void see(const Vector& place) {
        Vector &low = watched.low, &high = watched.high;
        low = {std::min(low.x, place.x), std::min(low.y, place.y), std::min(low.z, place.z)};
        high = {std::max(high.x, place.x), std::max(high.y, place.y), std::max(high.z, place.z)};
    }

    WatchedWalk watched;

private:
    const std::vector<std::size_t>& symbols_;
};

}  // namespace

WatchedWalk watched_walk(const ModuleTurtle& turtle, const ModuleString& word,
                         const std::vector<std::size_t>& symbols, const Budget& budget) {
    Watcher watcher(symbols, turtle.start().position);
    const TurtleState end = turtle.walk(word, watcher, budget);
    watcher.see(end.position);
    watcher.watched.states.resize(symbols.size(), end);
    return std::move(watcher.watched);
}

std::vector<Vector> turtle_glyph(const TurtleState& turtle, double size) {
    const Vector ahead = (size / 2) * turtle.attitude.heading();
    const Vector aside = (size * 0.36) * turtle.attitude.left();
    const Vector& at = turtle.position;
    return {at + ahead, at - ahead + aside, at - 0.55 * ahead, at - ahead - aside};
}

std::vector<std::size_t> frames_of_progress(std::size_t symbols, std::size_t most) {
    const std::size_t steps = std::max<std::size_t>(most, 2) - 1;
    const std::size_t stride = std::max<std::size_t>(1, (symbols + steps - 1) / steps);
    std::vector<std::size_t> found;
    for (std::size_t at = 0; at < symbols; at += stride) found.push_back(at);
    found.push_back(symbols);
    return found;
}

}  // namespace algae
