#include "turtle/detail/environments.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

// What communication modules are told by the world around the turtle (Mech and Prusinkiewicz 1996).
//
// `x`, `y`, `z`, `position`, `heading` and `clip` are known from the turtle alone (Whereabouts). `collision`
// and `light` depend on all lines of the word, before the module and behind it, but not on those that meet
// where the turtle stands: its own branch and what grows on from it (Joint).
//
// Lines near a turtle are found by a grid of cells as wide as the radius that is asked for, or as the mean
// length of the lines where that is more, so that n lines lie in O(n) cells; the entries are sorted, and
// those of one column of cells lie together. For light the lines are projected on the ground first, and of
// each only the part above the turtle counts.

namespace algae {

bool Traversal::is_in_space() const {
    return std::any_of(segments.begin(), segments.end(), [](const Segment& segment) {
        return segment.from.z != 0 || segment.to.z != 0;
    });
}

std::string place_of(const Query& query, const Traversal& course) {
    std::string out = query.name;
    for (std::size_t i = 0; i < query.parameters.size(); ++i)
        out += (i == 0 ? "(" : ",") + number_text(query.parameters[i]);
    if (!query.parameters.empty()) out += ')';
    return out + " at position " + std::to_string(query.module) + " of generation " +
           std::to_string(course.generation);
}

namespace {

/// The whole part, as far as numbers of cells go.
std::int64_t whole(double value) {
    constexpr double most = 1e15;
    if (!(value > -most)) return -static_cast<std::int64_t>(most);
    return value < most ? static_cast<std::int64_t>(std::floor(value))
                        : static_cast<std::int64_t>(most);
}

}  // namespace

double distance(const Vector& point, const Vector& from, const Vector& to) {
    const Vector way = to - from, there = point - from;
    const double square = dot(way, way);
    const double part = square > 0 ? std::clamp(dot(there, way) / square, 0.0, 1.0) : 0;
    return length(there - part * way);
}

SegmentGrid::SegmentGrid(std::span<const Segment> segments, double radius, const Budget& budget)
    : radius_(radius), width_(radius) {
    double all = 0;
    for (const Segment& segment : segments) all += length(segment.to - segment.from);
    if (!segments.empty()) width_ = std::max(radius, all / static_cast<double>(segments.size()));
    entries_.reserve(2 * segments.size());
    for (std::size_t i = 0; i < segments.size(); ++i) {
        if (i % 4096 == 0) budget.check();
        // In pieces as long as a cell is wide, which lie in 8 cells at most.
        const auto& [from, to, module] = segments[i];
        const auto pieces = static_cast<double>(1 + whole(length(to - from) / width_));
        Vector begin = from;
        for (double k = 1; k <= pieces; ++k) {
            const Vector end = k == pieces ? to : from + (k / pieces) * (to - from);
            add(begin, end, i);
            begin = end;
        }
        budget.check_memory(entries_.capacity() * sizeof(Entry), "the grid of an environment");
    }
    std::sort(entries_.begin(), entries_.end());
    entries_.erase(std::unique(entries_.begin(), entries_.end()), entries_.end());
}

SegmentGrid::Cell SegmentGrid::cell(const Vector& point) const {
    return {whole(point.x / width_), whole(point.y / width_), whole(point.z / width_)};
}

void SegmentGrid::add(const Vector& from, const Vector& to, std::size_t segment) {
    const Cell a = cell(from), b = cell(to);
    for (std::int64_t x = std::min(a.x, b.x); x <= std::max(a.x, b.x); ++x)
        for (std::int64_t y = std::min(a.y, b.y); y <= std::max(a.y, b.y); ++y)
            for (std::int64_t z = std::min(a.z, b.z); z <= std::max(a.z, b.z); ++z)
                entries_.push_back({{x, y, z}, segment});
}

namespace {

double degrees(const Vector& heading) {
    if (heading.x == 0 && heading.y == 0) return 0;
    double angle = std::atan2(heading.y, heading.x) * (180 / std::numbers::pi);
    if (angle < 0) angle += 360;
    return angle < 360 ? angle : 0;  // the sum may be rounded up
}

std::vector<double> first_of(const Vector& vector, std::size_t count) {
    const double all[] = {vector.x, vector.y, vector.z};
    return {all, all + count};
}

}  // namespace

bool Whereabouts::is_inside(const Vector& place) const {
    const std::size_t dimension = setting_.numbers.size() / 2;
    const std::vector<double> coordinates = first_of(place, dimension);
    for (std::size_t i = 0; i < dimension; ++i)
        if (coordinates[i] < setting_.numbers[i].value ||
            coordinates[i] > setting_.numbers[dimension + i].value)
            return false;
    return true;
}

std::vector<double> Whereabouts::answer(const Query& query) const {
    const std::string& kind = setting_.kind;
    const std::size_t count = query.parameters.size();
    if (kind == "x") return {query.position.x};
    if (kind == "y") return {query.position.y};
    if (kind == "z") return {query.position.z};
    if (kind == "position") return first_of(query.position, count);
    if (kind == "clip") return {is_inside(query.position) ? 1.0 : 0.0};
    const Vector& heading = query.attitude.heading();
    if (count == 1) return {degrees(heading)};
    return first_of(heading, count);
}

std::vector<std::vector<double>> Whereabouts::answers(const Traversal&,
                                                      std::span<const Query* const> queries,
                                                      const Budget&) {
    std::vector<std::vector<double>> out;
    for (const Query* query : queries) out.push_back(answer(*query));
    return out;
}

namespace {

/// The lines that meet where a turtle stands, since it came there: the last one before the module
/// that ends there, and those drawn later that begin there. They are its own branch and what grows
/// on from it, and in nobody's way. Candidates must be shown first, all that end at the place.
class Joint {
public:
    Joint(std::span<const Segment> segments, const Query& query)
        : segments_(segments), query_(query) {}

    /// Takes a segment as the way by which the turtle came, if it is.
    void look_at(std::size_t segment) {
        const Segment& line = segments_[segment];
        if (line.module < query_.module && line.to == query_.position &&
            (came_ == none || segment > came_))
            came_ = segment;
    }
    /// Whether the segment is one of those said above.
    bool has(std::size_t segment) const {
        if (came_ != none && segment <= came_) return segment == came_;
        return segments_[segment].from == query_.position;
    }

private:
    std::span<const Segment> segments_;
    const Query& query_;
    static constexpr std::size_t none = SIZE_MAX;
    std::size_t came_ = none;
};

}  // namespace

std::vector<std::vector<double>> CollisionEnvironment::answers(
    const Traversal& course, std::span<const Query* const> queries, const Budget& budget) {
    const SegmentGrid grid(course.segments, radius_, budget);
    std::vector<std::vector<double>> out;
    for (const Query* query : queries) {
        budget.check();
        Joint joint(course.segments, *query);
        grid.any_near(query->position, [&](std::size_t i) {
            joint.look_at(i);
            return false;
        });
        const bool collides = grid.any_near(query->position, [&](std::size_t i) {
            const Segment& line = course.segments[i];
            return distance(query->position, line.from, line.to) <= radius_ && !joint.has(i);
        });
        out.push_back({collides ? 1.0 : 0.0});
    }
    return out;
}

namespace {

/// Heights and plans: what is seen from above.
class Plan {
public:
    explicit Plan(const Traversal& course) : space_(course.is_in_space()) {
        for (const Segment& line : course.segments)
            lines_.push_back({of(line.from), of(line.to), line.module});
    }
    double height(const Vector& point) const { return space_ ? point.z : point.y; }
    Vector of(const Vector& point) const { return {point.x, space_ ? point.y : 0, 0}; }
    const std::vector<Segment>& lines() const { return lines_; }

private:
    bool space_;
    std::vector<Segment> lines_;
};

}  // namespace

std::vector<std::vector<double>> LightEnvironment::answers(const Traversal& course,
                                                           std::span<const Query* const> queries,
                                                           const Budget& budget) {
    const Plan plan(course);
    const SegmentGrid grid(plan.lines(), radius_, budget);
    std::vector<std::vector<double>> out;
    for (const Query* query : queries) {
        budget.check();
        const Vector place = plan.of(query->position);
        const double height = plan.height(query->position);
        Joint joint(course.segments, *query);
        grid.any_near(place, [&](std::size_t i) {
            joint.look_at(i);
            return false;
        });
        double column = radius_;
        grid.any_near(place, [&](std::size_t i) {
            double low = plan.height(course.segments[i].from),
                   high = plan.height(course.segments[i].to);
            Vector lower = plan.lines()[i].from, upper = plan.lines()[i].to;
            if (low > high) {
                std::swap(low, high);
                std::swap(lower, upper);
            }
            if (high <= height || joint.has(i)) return false;
            if (low < height) lower = lower + ((height - low) / (high - low)) * (upper - lower);
            column = std::min(column, distance(place, lower, upper));
            return column == 0;
        });
        out.push_back({column / radius_});
    }
    return out;
}

namespace {

/// What is set for a module; nullptr if nothing is.
const EnvironmentSetting* setting_of(const LSystem& system, Symbol module) {
    for (const EnvironmentSetting& setting : system.environments)
        if (setting.module == module) return &setting;
    static const EnvironmentSetting position{0, "position", {}}, heading{0, "heading", {}};
    const std::string& name = system.alphabet.name(module);
    return name == "?P" ? &position : name == "?H" ? &heading : nullptr;
}

std::vector<std::size_t> arities(const std::string& kind) {
    if (kind == "external") return {};
    if (kind == "position") return {1, 2, 3};
    if (kind == "heading") return {1, 3};
    return {1};
}

std::shared_ptr<Environment> environment_of(const EnvironmentSetting& setting) {
    if (setting.kind == "collision")
        return std::make_shared<CollisionEnvironment>(setting.numbers.at(0).value);
    if (setting.kind == "light")
        return std::make_shared<LightEnvironment>(setting.numbers.at(0).value);
    return std::make_shared<Whereabouts>(setting);
}

std::string in_words(const std::vector<std::size_t>& counts) {
    return joined(counts, " or ", [](std::size_t count) { return std::to_string(count); }) +
           (counts.back() == 1 ? " parameter" : " parameters");
}

}  // namespace

Environments::Environments(const LSystem& system, std::shared_ptr<Environment> external) {
    for (Symbol module = 0; module < system.alphabet.size(); ++module) {
        const std::string& name = system.alphabet.name(module);
        if (!is_communication(name)) continue;
        const EnvironmentSetting* setting = setting_of(system, module);
        if (!setting)
            throw Error("nothing fills the communication module " + name +
                        "; expected a setting such as `environment " + name + " position`");
        if (setting->kind == "external" && !external)
            throw ProgramWanted("the communication module " + name +
                                " is filled by a program; say by which");
        asked_.push_back({name, setting->kind,
                          setting->kind == "external" ? external : environment_of(*setting),
                          arities(setting->kind)});
        if (std::count(all_.begin(), all_.end(), asked_.back().environment) == 0)
            all_.push_back(asked_.back().environment);
    }
}

const Environments::Asked& Environments::asked_by(const std::string& name) const {
    return *std::find_if(asked_.begin(), asked_.end(),
                         [&](const Asked& asked) { return asked.name == name; });
}

std::vector<std::vector<double>> Environments::answers(const Traversal& course,
                                                       const Budget& budget) {
    std::vector<const Environment*> environments;  // by query
    for (const Query& query : course.queries) {
        const Asked& asked = asked_by(query.name);
        const std::size_t count = query.parameters.size();
        if (!asked.arities.empty() &&
            std::count(asked.arities.begin(), asked.arities.end(), count) == 0)
            throw Error(place_of(query, course) + ": expected " + in_words(asked.arities) +
                        ", which `" + asked.kind + "` fills, found " + std::to_string(count));
        environments.push_back(asked.environment.get());
    }
    std::vector<std::vector<double>> out(course.queries.size());
    for (const auto& environment : all_) {
        std::vector<const Query*> queries;
        for (std::size_t i = 0; i < out.size(); ++i)
            if (environments[i] == environment.get()) queries.push_back(&course.queries[i]);
        auto answers = environment->answers(course, queries, budget);
        std::size_t next = 0;
        for (std::size_t i = 0; i < out.size(); ++i)
            if (environments[i] == environment.get()) out[i] = std::move(answers.at(next++));
    }
    return out;
}

bool asks_program(const LSystem& system) {
    return std::any_of(
        system.environments.begin(), system.environments.end(),
        [](const EnvironmentSetting& setting) { return setting.kind == "external"; });
}

}  // namespace algae
