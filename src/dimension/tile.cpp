#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/strong_components.hpp>
#include <cmath>
#include <deque>
#include <map>
#include <set>
#include <tuple>

#include "dimension/detail/recurrent_set.hpp"
#include "watch/watch.hpp"

// Is a set of a lattice a tile, and does it look like a disc?
//
// Area. Cells of a tiling that the same map refines say which share of each is covered (`lattice_cells.cpp`): a linear system with one
// solution, so areas are rational numbers of cells; where it is large, bounds, and what ergodicity says. Parts of a level overlap in sets of the area 0 exactly if the areas of the parts of
// each state add up to the determinant times its own. A state with area has inner points, as some cell is full, and so do its parts,
// however small: it is the closure of its inner points (Lagarias and Wang, Self-affine tiles in R^n, 1996). States without area, such as
// the end points that some rules draw, must be points of other parts, or the set is not a tile.
//
// What has common points. A group of tiles of one level has a point in common exactly if an infinite path of groups of parts, one of
// each, begins at it (`Meetings`): the neighbour graph of Bandt and Graf (1992), Strichartz and Wang (1999), and Scheicher and
// Thuswaldner (Neighbours of self-affine tiles in lattice tilings, 2002) for pairs, and with it the graphs of triple points and so on.
// The common point is known exactly, as a rational vector, if it is only one: all edges agree.
//
// Neighbours. A tile is looked at with all others of the enlarged set that it meets, from the whole with none. Types that lead to
// each other and to no others are surrounded from all sides: a tile deep inside is, its parts are, and every type leads to one.
// If there is one state and its area is one cell, the set tiles by the lattice, and its neighbours are those of that tiling; sets with
// periods come with theirs.
//
// Connected. If the parts of each state that meet make a connected graph, all are connected (Hata, On the structure of self-similar
// sets, 1985; for several states Luo, Akiyama and Thuswaldner 2004). If those of a level of the whole do not, it is not.
//
// Like a disc:
// 1. A tile of a lattice tiling, one state, connected: exactly if it has at most six neighbours, or the eight a, b, a + b, a - b and
//    their opposites while the parts hang together by steps of a and b alone (Bandt and Wang, Disk-like self-affine tiles in R^2, 2001).
// 2. Any tile, if its boundary is seen to be a simple closed curve. Where it meets another one, a part of the boundary consists of parts of
//    the same kind. If consecutive ones have one point in common and others none, and these points are the ends of the parts, at
//    every level, it is an arc: chains of ever smaller links. If the arcs around a tile hang together like a ring, they are a
//    simple closed curve, and the tile is what it encloses (Jordan; Schoenflies). (Siegel and Thuswaldner, Topological properties of Rauzy
//    fractals, 2009, decide so.)
// 3. It is not, if a lattice tiling gives it a number of neighbours other than six and eight (Gruenbaum and Shephard, Tilings and
//    patterns, 1987), or if three congruent ones without common inner points have three points in common: each point could be joined to
//    each disc, and K_{3,3} would be planar (Kuratowski 1930).
//
// A connected set of one kind of part that is not like a disc has inner points that are not connected (Luo, Rao and Tan,
// Topological structure of self-similar sets, 2002). All other questions are left open.

namespace algae {

namespace {

using Vector = LatticeSet::Vector;
using Placed = LatticeSet::Part;
using Group = std::vector<Placed>;  // in order
using ExactPoint = std::vector<Rational>;
using Answer = Tile::Answer;
using Finding = Tile::Finding;

Vector operator+(Vector left, const Vector& right) {
    for (std::size_t k = 0; k < left.size(); ++k) left[k] += right[k];
    return left;
}

Vector operator-(Vector left, const Vector& right) {
    for (std::size_t k = 0; k < left.size(); ++k) left[k] -= right[k];
    return left;
}

Group moved(Group group, const Vector& by) {
    for (Placed& tile : group) tile.by = tile.by + by;
    return group;
}

Group pair_of(const Placed& left, const Placed& right) {
    Group both{left, right};
    std::sort(both.begin(), both.end());
    return both;
}

Group united(const Group& left, const Group& right) {
    Group found;
    std::set_union(left.begin(), left.end(), right.begin(), right.end(), std::back_inserter(found));
    return found;
}

bool holds(const Group& group, const Group& part) {
    return std::includes(group.begin(), group.end(), part.begin(), part.end());
}

/// Whether a graph of so many nodes is connected; nothing is.
template <class Joined>
bool is_connected(std::size_t count, const Joined& joined) {
    if (count == 0) return false;
    std::vector<bool> reached(count, false);
    std::vector<std::size_t> open{0};
    reached[0] = true;
    std::size_t found = 1;
    while (!open.empty()) {
        const std::size_t k = open.back();
        open.pop_back();
        for (std::size_t i = 0; i < count; ++i)
            if (!reached[i] && joined(k, i)) {
                reached[i] = true;
                ++found;
                open.push_back(i);
            }
    }
    return found == count;
}

/// Which groups of tiles of one level have points in common.
class Meetings {
public:
    Meetings(const LatticeSet& set, const Budget& budget, std::size_t most)
        : set_(set), budget_(budget), most_(most), discs_(discs_of(set)) {
        IntegerMatrix scale(set.rank, set.rank);
        for (std::size_t i = 0; i < set.rank; ++i)
            for (std::size_t k = 0; k < set.rank; ++k) scale(i, k) = Integer(set.scale[i][k]);
        scale_ = std::move(scale);
        inverse_ = *inverse(scale_);
    }

    const LatticeSet& set() const { return set_; }

    struct Next {
        std::size_t to;
        Vector shift;  // of the group of that number
    };
    struct Node {
        Group group;  // that begins at 0
        std::vector<Next> next;
        bool alive = true;
    };

    /// A group that has common points, and where its first tile lies.
    struct Found {
        std::size_t number;
        Vector at;
    };
    std::optional<Found> find(Group group) {
        const Vector at = normalised(group);
        if (const auto known = numbers_.find(group); known != numbers_.end())
            return nodes_[known->second].alive ? std::optional(Found{known->second, at})
                                               : std::nullopt;
        for (std::size_t i = 0; i < group.size(); ++i)
            for (std::size_t k = i + 1; k < group.size(); ++k) {
                if (!near(group[i], group[k])) return std::nullopt;
                if (group.size() > 2 && !find({group[i], group[k]})) return std::nullopt;
            }
        const std::size_t number = explored(std::move(group));
        if (!nodes_[number].alive) return std::nullopt;
        return Found{number, at};
    }

    /// As they lie: the parts of a group that have common points, in the lattice that is scaled.
    std::vector<Group> parts(const Found& of) const {
        std::vector<Group> found;
        const Vector at = set_.scaled(of.at);
        for (const Next& next : nodes_[of.number].next)
            found.push_back(moved(nodes_[next.to].group, next.shift + at));
        return found;
    }

    /// The common point, if there is only one: in the lattice of the group.
    std::optional<ExactPoint> only_point(const Found& of) {
        const auto [place, is_new] = points_.try_emplace(of.number);
        if (is_new) place->second = found_point(of.number);
        if (!place->second) return std::nullopt;
        return shifted(*place->second, of.at);
    }

    /// Whether three different common points are seen.
    bool has_three_points(const Found& of) {
        constexpr std::size_t rounds = 6, most_paths = 400;
        if (only_point(of)) return false;
        struct Path {
            std::size_t node;
            std::vector<Vector> shifts;
        };
        std::vector<Path> paths{{of.number, {}}};
        std::set<std::vector<std::pair<Integer, Integer>>> seen;
        for (std::size_t round = 0; round < rounds && paths.size() < most_paths; ++round) {
            std::vector<Path> longer;
            for (const Path& path : paths)
                for (const Next& next : nodes_[path.node].next) {
                    longer.push_back({next.to, path.shifts});
                    longer.back().shifts.push_back(next.shift);
                }
            paths = std::move(longer);
            for (const Path& path : paths) {
                budget_.check();
                ExactPoint at = some_point(path.node);
                for (auto shift = path.shifts.rbegin(); shift != path.shifts.rend(); ++shift)
                    at = smaller(shifted(std::move(at), *shift));
                std::vector<std::pair<Integer, Integer>> key;
                for (const Rational& x : at) key.emplace_back(x.numerator(), x.denominator());
                seen.insert(std::move(key));
                if (seen.size() >= 3) return true;
            }
        }
        return false;
    }

    /// The tiles that are the parts of one.
    Group parts(const Placed& tile) const {
        Group found;
        const Vector at = set_.scaled(tile.by);
        for (const Placed& part : set_.parts[tile.state])
            found.push_back({part.state, at + part.by});
        std::sort(found.begin(), found.end());
        return found;
    }

    bool near(const Placed& left, const Placed& right) const {
        const Point by = set_.place(right.by - left.by);
        const std::complex<double> apart = discs_[right.state].centre - discs_[left.state].centre +
                                           std::complex<double>{by.x, by.y};
        return std::abs(apart) <= discs_[left.state].radius + discs_[right.state].radius;
    }

    static ExactPoint shifted(ExactPoint point, const Vector& by) {
        for (std::size_t k = 0; k < point.size(); ++k) point[k] += Rational(by[k]);
        return point;
    }

    /// Divided by the map.
    ExactPoint smaller(const ExactPoint& point) const {
        ExactPoint found(point.size(), Rational(0));
        for (std::size_t i = 0; i < point.size(); ++i)
            for (std::size_t k = 0; k < point.size(); ++k)
                found[k] += point[i] * Rational(inverse_.numerator(i, k), inverse_.denominator);
        return found;
    }

    /// The first point of a cycle of so many, each (the next one + shift) / M: then y (M^n - 1) is a sum of shifts.
    ExactPoint fixed_point(const std::vector<Vector>& shifts) const {
        IntegerMatrix power = IntegerMatrix::identity(set_.rank);
        std::vector<Integer> sum(set_.rank);
        for (const Vector& shift : shifts) {
            sum = sum * scale_;
            for (std::size_t i = 0; i < set_.rank; ++i) sum[i] += Integer(shift[i]);
            power = power * scale_;
        }
        const auto solved = inverse(power - IntegerMatrix::identity(set_.rank));
        const std::vector<Integer> above = sum * solved->numerator;
        ExactPoint found;
        for (const Integer& x : above) found.emplace_back(x, solved->denominator);
        return found;
    }

    const RecurrentSet::Disc& disc(std::size_t state) const { return discs_[state]; }

private:
    static Vector normalised(Group& group) {
        const Vector at = group.front().by;
        for (Placed& tile : group) tile.by = tile.by - at;
        return at;
    }

    std::size_t number(Group group) {
        const auto [place, is_new] = numbers_.try_emplace(std::move(group), nodes_.size());
        if (is_new) {
            if (nodes_.size() == most_)
                throw BoundReached(Bound::method, "more than " + std::to_string(most_) +
                                                      " ways in which parts may meet");
            if (nodes_.size() % 1024 == 0)
                budget_.check_memory(nodes_.size() * 600, "the parts that meet");
            nodes_.push_back({place->first, {}, true});
        }
        return place->second;
    }

    /// The group, with all that it leads to.
    std::size_t explored(Group group) {
        const std::size_t first = nodes_.size(), found = number(std::move(group));
        for (std::size_t k = first; k < nodes_.size(); ++k) {
            if (k % 64 == 0) budget_.check();
            std::vector<Group> parts_of_tiles;
            for (const Placed& tile : nodes_[k].group) parts_of_tiles.push_back(parts(tile));
            std::vector<Group> next;
            Group chosen;
            choose(parts_of_tiles, chosen, next);
            std::vector<Next> numbered;
            for (Group& each : next) {
                std::sort(each.begin(), each.end());
                const Vector shift = normalised(each);
                numbered.push_back({number(std::move(each)), shift});
            }
            nodes_[k].next = std::move(numbered);
        }
        leave_out_dead_ends(first);
        return found;
    }

    /// One part of each, if any two may meet.
    void choose(const std::vector<Group>& from, Group& chosen, std::vector<Group>& found) const {
        if (chosen.size() == from.size()) {
            found.push_back(chosen);
            return;
        }
        for (const Placed& part : from[chosen.size()]) {
            if (!std::all_of(chosen.begin(), chosen.end(), [&](const Placed& other) {
                    return from.size() == 2 ? near(other, part) : have_met(other, part);
                }))
                continue;
            chosen.push_back(part);
            choose(from, chosen, found);
            chosen.pop_back();
        }
    }

    /// Of parts of tiles whose pair has been looked at.
    bool have_met(const Placed& left, const Placed& right) const {
        Group pair = pair_of(left, right);
        normalised(pair);
        const auto place = numbers_.find(pair);
        return place != numbers_.end() && nodes_[place->second].alive;
    }

    /// Among the nodes from the first one on; what others lead to is known.
    void leave_out_dead_ends(std::size_t first) {
        std::vector<std::vector<std::size_t>> before(nodes_.size() - first);
        std::vector<std::size_t> left(nodes_.size() - first, 0), dead;
        for (std::size_t k = first; k < nodes_.size(); ++k) {
            for (const Next& next : nodes_[k].next) {
                if (next.to >= first) before[next.to - first].push_back(k);
                if (nodes_[next.to].alive) ++left[k - first];
            }
            if (left[k - first] == 0) dead.push_back(k);
        }
        for (std::size_t i = 0; i < dead.size(); ++i) {
            nodes_[dead[i]].alive = false;
            for (const std::size_t k : before[dead[i] - first])
                if (--left[k - first] == 0) dead.push_back(k);
        }
        for (std::size_t k = first; k < nodes_.size(); ++k)
            std::erase_if(nodes_[k].next, [&](const Next& next) { return !nodes_[next.to].alive; });
    }

    /// The common point to which the first parts of the first parts and so on lead.
    ExactPoint some_point(std::size_t node) {
        if (const auto known = some_points_.find(node); known != some_points_.end())
            return known->second;
        std::vector<std::size_t> path;
        std::map<std::size_t, std::size_t> place;
        std::size_t here = node;
        while (!place.contains(here) && !some_points_.contains(here)) {
            place.emplace(here, path.size());
            path.push_back(here);
            here = nodes_[here].next.front().to;
        }
        if (!some_points_.contains(here)) {
            std::vector<Vector> shifts;
            for (std::size_t k = place.at(here); k < path.size(); ++k)
                shifts.push_back(nodes_[path[k]].next.front().shift);
            some_points_.emplace(here, fixed_point(shifts));
        }
        for (std::size_t k = path.size(); k-- > 0;) {
            if (some_points_.contains(path[k])) continue;
            const Next& next = nodes_[path[k]].next.front();
            some_points_.emplace(path[k], smaller(shifted(some_points_.at(next.to), next.shift)));
        }
        return some_points_.at(node);
    }

    std::optional<ExactPoint> found_point(std::size_t node) {
        std::set<std::size_t> reached{node};
        std::vector<std::size_t> open{node};
        while (!open.empty()) {
            budget_.check();
            const std::size_t k = open.back();
            open.pop_back();
            const ExactPoint own = some_point(k);
            for (const Next& next : nodes_[k].next) {
                if (smaller(shifted(some_point(next.to), next.shift)) != own) return std::nullopt;
                if (reached.insert(next.to).second) open.push_back(next.to);
            }
        }
        return some_point(node);
    }

    const LatticeSet& set_;
    const Budget& budget_;
    std::size_t most_;
    std::vector<RecurrentSet::Disc> discs_;
    IntegerMatrix scale_;
    RationalInverse inverse_;
    std::map<Group, std::size_t> numbers_;
    std::vector<Node> nodes_;
    std::map<std::size_t, std::optional<ExactPoint>> points_;
    std::map<std::size_t, ExactPoint> some_points_;
};

/// Whether common points of pairs make a simple closed curve.
class Ring {
public:
    explicit Ring(Meetings& meetings) : meetings_(meetings) {}

    /// `pieces`: pairs that meet, the union of whose common points is looked at. If they do not hang together like a ring, their
    /// parts may, for a few levels.
    bool is_simple(std::vector<Group> pieces) {
        constexpr int levels = 4;
        constexpr std::size_t most_pieces = 2'000;
        for (int level = 0; level < levels && pieces.size() <= most_pieces; ++level) {
            if (is_ring(pieces)) return true;
            std::vector<Group> finer;
            for (const Group& piece : pieces)
                for (Group& part : meetings_.parts(*meetings_.find(piece)))
                    finer.push_back(std::move(part));
            pieces = std::move(finer);
        }
        return false;
    }

private:
    struct Contact {
        std::size_t first, second;
        Group group;
    };
    /// Pieces with more than one point, and where these meet.
    struct Links {
        std::vector<Group> pieces;
        std::vector<Contact> contacts;
    };

    /// Nothing if two pieces have several points in common, or a piece of one point lies beside the others.
    std::optional<Links> links(const std::vector<Group>& pieces) {
        Links found;
        std::vector<Group> points;
        for (const Group& piece : pieces)
            (meetings_.only_point(*meetings_.find(piece)) ? points : found.pieces).push_back(piece);
        for (const Group& point : points)
            if (!std::any_of(found.pieces.begin(), found.pieces.end(), [&](const Group& piece) {
                    return meetings_.find(united(piece, point)).has_value();
                }))
                return std::nullopt;
        for (std::size_t i = 0; i < found.pieces.size(); ++i)
            for (std::size_t k = i + 1; k < found.pieces.size(); ++k) {
                Group both = united(found.pieces[i], found.pieces[k]);
                const auto met = meetings_.find(both);
                if (!met) continue;
                if (!meetings_.only_point(*met)) return std::nullopt;
                found.contacts.push_back({i, k, std::move(both)});
            }
        return found;
    }

    static std::vector<std::size_t> degrees(const Links& of) {
        std::vector<std::size_t> found(of.pieces.size(), 0);
        for (const Contact& contact : of.contacts) {
            ++found[contact.first];
            ++found[contact.second];
        }
        return found;
    }

    static bool hang_together(const Links& of) {
        std::vector<std::vector<bool>> joined(of.pieces.size(),
                                              std::vector<bool>(of.pieces.size()));
        for (const Contact& contact : of.contacts)
            joined[contact.first][contact.second] = joined[contact.second][contact.first] = true;
        return is_connected(of.pieces.size(),
                            [&](std::size_t i, std::size_t k) { return joined[i][k]; });
    }

    bool is_ring(const std::vector<Group>& pieces) {
        const auto found = links(pieces);
        if (!found || found->pieces.size() < 3 || !hang_together(*found)) return false;
        for (const std::size_t degree : degrees(*found))
            if (degree != 2) return false;
        open_.clear();
        ends_.clear();
        for (const Group& piece : found->pieces) add(piece);
        for (const Contact& contact : found->contacts)
            if (!add_end(found->pieces[contact.first], contact.group) ||
                !add_end(found->pieces[contact.second], contact.group))
                return false;
        return are_arcs();
    }

    /// A group relative to the first tile of a piece.
    Group seen_from(const Meetings::Found& piece, const Group& group) const {
        return moved(group, Vector{} - piece.at);
    }

    void add(const Group& piece) {
        const auto found = meetings_.find(piece);
        if (ends_.try_emplace(found->number).second) open_.emplace_back(found->number, Group{});
    }

    /// That the only point of a group is an end of a piece: of which there are two at most.
    bool add_end(const Group& piece, const Group& group) {
        const auto found = *meetings_.find(piece);
        const Group seen = seen_from(found, group);
        const ExactPoint point = *meetings_.only_point(*meetings_.find(seen));
        auto& own = ends_[found.number];
        if (std::find(own.begin(), own.end(), point) != own.end()) return true;
        own.push_back(point);
        if (own.size() > 2) return false;
        open_.emplace_back(found.number, seen);
        return true;
    }

    /// Goes on from pieces to their parts: each must be a chain of these, and its ends lie in one of them only.
    bool are_arcs() {
        while (!open_.empty()) {
            const auto [number, end] = open_.back();
            open_.pop_back();
            const Links* const chain = chain_of(number);
            if (!chain) return false;
            if (end.empty()) {
                for (const Group& part : chain->pieces) add(part);
                for (const Contact& contact : chain->contacts)
                    if (!add_end(chain->pieces[contact.first], contact.group) ||
                        !add_end(chain->pieces[contact.second], contact.group))
                        return false;
                continue;
            }
            const auto parts = meetings_.parts(*meetings_.find(end));
            const Group* in = nullptr;
            const Group* by = nullptr;
            for (const Group& part : chain->pieces)
                for (const Group& of_end : parts)
                    if (holds(of_end, part)) {
                        if (in && in != &part) return false;
                        in = &part;
                        by = &of_end;
                    }
            if (!in || !add_end(*in, *by)) return false;
        }
        return true;
    }

    /// The parts of a piece, if they hang together like a chain.
    const Links* chain_of(std::size_t number) {
        const auto [place, is_new] = chains_.try_emplace(number);
        if (is_new) {
            auto found = links(meetings_.parts(Meetings::Found{number, {}}));
            if (found && !found->pieces.empty() && hang_together(*found) &&
                found->contacts.size() + 1 == found->pieces.size()) {
                const auto each = degrees(*found);
                if (std::all_of(each.begin(), each.end(), [](auto degree) { return degree <= 2; }))
                    place->second = std::move(found);
            }
        }
        return place->second ? &*place->second : nullptr;
    }

    Meetings& meetings_;
    std::map<std::size_t, std::optional<Links>> chains_;
    std::map<std::size_t, std::vector<ExactPoint>> ends_;
    std::vector<std::pair<std::size_t, Group>> open_;  // pieces, and ends of pieces
};

/// The states that can be reached from the whole.
std::vector<bool> reached_states(const LatticeSet& set) {
    std::vector<bool> found(set.parts.size(), false);
    std::vector<std::size_t> open;
    const auto visit = [&](const Placed& part) {
        if (found[part.state]) return;
        found[part.state] = true;
        open.push_back(part.state);
    };
    for (const Placed& part : set.whole) visit(part);
    while (!open.empty()) {
        const std::size_t state = open.back();
        open.pop_back();
        for (const Placed& part : set.parts[state]) visit(part);
    }
    return found;
}

class Examination {
public:
    Examination(LatticeSet set, const Budget& budget, std::size_t most)
        : set_(std::move(set)), budget_(budget), most_(most) {}

    Tile result() {
        out_.unit = set_.unit;
        if (set_.periods) {
            out_.cells = Rational(1);
            out_.is_tile = {Answer::yes, "the periodic tiling was proved"};
        } else {
            find_areas();
        }
        if (out_.cells) out_.cells_between = {*out_.cells, *out_.cells};
        if (out_.cells && set_.cell_square)
            out_.area_square = *out_.cells * *out_.cells * *set_.cell_square;
        out_.set = set_;
        if (out_.is_tile.answer != Answer::yes) return out_;
        Meetings meetings(set_, budget_, most_);
        meetings_ = &meetings;
        attempt(out_.connected, [&] { find_connected(); });
        attempt(out_.disk_like, [&] { find_neighbours(); });
        if (out_.connected.answer == Answer::no)
            out_.disk_like = {Answer::no, "it is not connected"};
        else if (out_.most_neighbours > 0)
            attempt(out_.disk_like, [&] { find_disk_like(); });
        if (out_.disk_like.answer != Answer::yes && out_.connected.answer == Answer::yes)
            attempt(out_.infinitely_many, [&] { find_cut_points(); });
        find_interior();
        return out_;
    }

private:
    /// What needs too many ways is left open.
    template <class Find>
    void attempt(Finding& finding, const Find& find) {
        try {
            find();
        } catch (const BoundReached& bound) {
            if (is_of_budget(bound.bound())) throw;
            finding = {Answer::undecided, bound.what()};
        }
    }

    std::pair<Rational, Rational> area_of(std::vector<Placed> whole) const {
        LatticeSet other = set_;
        other.whole = std::move(whole);
        const CellGrowth found = cell_growth(other, CellQuestion::area, budget_, most_);
        return {found.area_low, found.area_high};
    }

    void find_areas() {
        attempt(out_.is_tile, [&] {
            const auto [low, high] = area_of(set_.whole);
            out_.cells_between = {low, high};
            if (low == high) out_.cells = low;
            if (high.is_zero())
                out_.is_tile = {Answer::no, "it has no inner points"};
            else if (low.is_zero())
                out_.is_tile.because = "whether it has inner points is not seen";
            else
                compare_areas();
        });
    }

    /// Whether the areas of parts add up to those of wholes.
    void compare_areas() {
        const std::vector<bool> reached = reached_states(set_);
        std::map<std::size_t, std::pair<Rational, Rational>> of_shape;
        if (set_.whole.size() == 1)
            of_shape.emplace(set_.shapes[set_.whole.front().state], *out_.cells_between);
        for (std::size_t s = 0; s < reached.size(); ++s)
            if (reached[s] && !of_shape.contains(set_.shapes[s]))
                of_shape.emplace(set_.shapes[s], area_of({{s, {}}}));
        // If tiles are of one kind, only how many parts there are matters, and else their areas.
        const bool alike = std::count_if(of_shape.begin(), of_shape.end(), [](const auto& of) {
                               return !of.second.second.is_zero();
                           }) == 1;
        for (std::size_t s = 0; s < reached.size(); ++s) {
            if (!reached[s]) {
                areas_.emplace_back(0);
                continue;
            }
            const auto& [low, high] = of_shape.at(set_.shapes[s]);
            if (low == high) {
                areas_.push_back(low);
            } else if (alike && !low.is_zero()) {
                areas_.emplace_back(1);
            } else {
                out_.is_tile.because = "the areas of parts are known by bounds only";
                return;
            }
        }
        const Rational times(std::abs(set_.determinant()));
        const auto sum = [&](const std::vector<Placed>& parts) {
            Rational found = 0;
            for (const Placed& part : parts) found += areas_[part.state];
            return found;
        };
        bool apart = true;
        for (std::size_t s = 0; s < areas_.size(); ++s)
            if (reached[s] && sum(set_.parts[s]) != times * areas_[s]) apart = false;
        if (apart && set_.whole.size() > 1) {
            if (!out_.cells) {
                out_.is_tile.because = "the area of the whole is known by bounds only";
                return;
            }
            apart = sum(set_.whole) == *out_.cells;
        }
        if (!apart) {
            out_.is_tile = {Answer::no, "parts overlap in sets with area"};
            return;
        }
        leave_out_points();
        if (!out_.cells && out_.is_tile.answer == Answer::yes) find_area_of_cover();
    }

    /// If the parts of all tiles, one of each state in each place, are again one of each state in each place, then all of them together cover
    /// the plane equally often everywhere: how often a point is covered does not change under the lattice and the map, which is ergodic. So
    /// the areas of the states add up to a whole number of cells, and bounds say which.
    void find_area_of_cover() {
        std::set<std::pair<std::size_t, std::array<std::int64_t, 2>>> seen;
        std::size_t count = 0;
        const std::int64_t whole = std::abs(set_.determinant());
        for (const auto& parts : set_.parts)
            for (const Placed& part : parts) {
                seen.insert({part.state, residue(set_, part.by)});
                ++count;
            }
        const auto states = static_cast<std::int64_t>(set_.parts.size());
        if (seen.size() != count || count != set_.parts.size() * static_cast<std::size_t>(whole))
            return;
        const auto& [low, high] = *out_.cells_between;
        const Integer times = floor(high * Rational(states));
        if (Rational(times) < low * Rational(states) ||
            !(Rational(times - 1) < low * Rational(states)))
            return;
        out_.cells = Rational(times) / Rational(states);
    }

    /// Whether a state is one point: so is its only part.
    bool is_point(std::size_t state) const {
        std::set<std::size_t> seen;
        while (seen.insert(state).second) {
            if (set_.parts[state].size() != 1) return false;
            state = set_.parts[state].front().state;
        }
        return true;
    }

    /// Parts without area must be points of others beside them.
    void leave_out_points() {
        LatticeSet fewer = set_;
        Meetings meetings(set_, budget_, most_);
        const auto left_out = [&](std::vector<Placed>& parts) {
            std::vector<Placed> kept, rest;
            for (const Placed& part : parts)
                (areas_[part.state].is_zero() ? rest : kept).push_back(part);
            for (const Placed& point : rest)
                if (!is_point(point.state) ||
                    !std::any_of(kept.begin(), kept.end(), [&](const Placed& other) {
                        return meetings.find(pair_of(other, point)).has_value();
                    }))
                    return false;
            parts = std::move(kept);
            return true;
        };
        bool all = left_out(fewer.whole);
        for (std::size_t s = 0; s < areas_.size() && all; ++s)
            if (!areas_[s].is_zero()) all = left_out(fewer.parts[s]);
        if (!all) {
            out_.is_tile = {Answer::no, "parts without area are not seen to lie in others"};
            return;
        }
        // States that are not reached any more are left out.
        const std::vector<bool> reached = reached_states(fewer);
        std::vector<std::size_t> place(reached.size(), 0);
        LatticeSet kept = fewer;
        kept.parts.clear();
        kept.shapes.clear();
        for (std::size_t s = 0; s < reached.size(); ++s)
            if (reached[s]) {
                place[s] = kept.parts.size();
                kept.parts.push_back(fewer.parts[s]);
                kept.shapes.push_back(fewer.shapes[s]);
            }
        for (auto& parts : kept.parts)
            for (Placed& part : parts) part.state = place[part.state];
        for (Placed& part : kept.whole) part.state = place[part.state];
        set_ = std::move(kept);
        out_.is_tile = {Answer::yes, ""};
    }

    bool hang_together(const std::vector<Placed>& tiles) {
        return is_connected(tiles.size(),
                            [&](std::size_t i, std::size_t k) { return meet(tiles[i], tiles[k]); });
    }

    bool meet(const Placed& left, const Placed& right) {
        return meetings_->near(left, right) && meetings_->find(pair_of(left, right)).has_value();
    }

    void find_connected() {
        constexpr std::size_t most_parts = 400;
        bool all = hang_together(set_.whole);
        for (const auto& parts : set_.parts) all = all && hang_together(parts);
        if (all) {
            out_.connected = {Answer::yes, "the parts of each part that meet hang together (Hata)"};
            return;
        }
        std::vector<Placed> level = set_.whole;
        while (level.size() <= most_parts) {
            if (!hang_together(level)) {
                out_.connected = {Answer::no, "it falls into parts that do not meet"};
                return;
            }
            level = finer(level);
        }
        out_.connected = {Answer::undecided, "some part is not connected, and the whole may be"};
    }

    // Neighbours.

    void find_neighbours() {
        if (set_.periods) {
            find_periodic(*set_.periods);
            return;
        }
        if (set_.whole.size() != 1) {
            out_.disk_like.because = "the whole is a union of several tiles";
            return;
        }
        if (set_.parts.size() == 1 && out_.cells == Rational(1)) {
            find_periodic({Vector{1, 0, 0}, Vector{0, 1, 0}});
            return;
        }
        find_surroundings();
    }

    /// Of the whole, moved by combinations of two vectors.
    void find_periodic(const std::array<Vector, 2>& periods) {
        out_.is_periodic = true;
        double reach = 0;
        for (const Placed& one : set_.whole)
            for (const Placed& two : set_.whole) {
                const auto &left = meetings_->disc(one.state), &right = meetings_->disc(two.state);
                const Point by = set_.place(two.by - one.by);
                reach = std::max(reach, left.radius + right.radius +
                                            std::abs(left.centre - right.centre +
                                                     std::complex<double>{by.x, by.y}));
            }
        const Point x = set_.place(periods[0]), y = set_.place(periods[1]);
        const double area = std::abs(x.x * y.y - x.y * y.x);
        // A move by i x + k y at most so far away has |i| and |k| at most this.
        const double most = reach * std::max(std::hypot(x.x, x.y), std::hypot(y.x, y.y)) / area + 1;
        if (!(most < 1000))
            throw BoundReached(Bound::method, "the vectors of the tiling are too long");
        const auto last = static_cast<std::int64_t>(most);
        for (std::int64_t i = -last; i <= last; ++i)
            for (std::int64_t k = -last; k <= last; ++k) {
                if (i == 0 && k == 0) continue;
                Vector by{};
                for (std::size_t c = 0; c < by.size(); ++c)
                    by[c] = i * periods[0][c] + k * periods[1][c];
                bool does = false;
                for (const Placed& one : set_.whole)
                    for (const Placed& two : set_.whole)
                        if (meet(one, {two.state, two.by + by})) {
                            does = true;
                            boundary_.push_back(pair_of(one, {two.state, two.by + by}));
                        }
                if (!does) continue;
                out_.neighbours.push_back({set_.whole.front().state, by});
                steps_.emplace_back(i, k);
            }
        out_.least_neighbours = out_.most_neighbours = out_.neighbours.size();
    }

    /// A tile at 0 and all others that it meets.
    struct Surrounded {
        std::size_t state;
        Group others;
        friend bool operator<(const Surrounded& left, const Surrounded& right) {
            return std::tie(left.state, left.others) < std::tie(right.state, right.others);
        }
    };

    void find_surroundings() {
        const std::size_t most_surroundings = std::min<std::size_t>(most_, 2'000);
        std::map<Surrounded, std::size_t> numbers;
        std::vector<const Surrounded*> list;
        const auto number = [&](Surrounded type) {
            const auto [place, is_new] = numbers.try_emplace(std::move(type), list.size());
            if (is_new) {
                if (list.size() == most_surroundings)
                    throw BoundReached(Bound::method, "more than " +
                                                          std::to_string(most_surroundings) +
                                                          " ways in which tiles are surrounded");
                list.push_back(&place->first);
            }
            return place->second;
        };
        number({set_.whole.front().state, {}});
        boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS> graph(1);
        WorkCount done("surroundings of tiles");
        for (std::size_t k = 0; k < list.size(); ++k) {
            budget_.check();
            done.at(k);
            const Surrounded type = *list[k];
            const Group own = meetings_->parts(Placed{type.state, {}});
            Group all = finer(type.others);
            all.insert(all.end(), own.begin(), own.end());
            for (const Placed& part : own) {
                Surrounded next{part.state, {}};
                for (const Placed& other : all)
                    if (!(other == part) && meet(part, other))
                        next.others.push_back({other.state, other.by - part.by});
                std::sort(next.others.begin(), next.others.end());
                boost::add_edge(k, number(std::move(next)), graph);
            }
        }
        std::vector<std::size_t> component(list.size());
        const std::size_t count = boost::strong_components(
            graph,
            boost::make_iterator_property_map(component.begin(), get(boost::vertex_index, graph)));
        std::vector<bool> closed(count, true);
        const auto [begin, end] = edges(graph);
        for (auto edge = begin; edge != end; ++edge)
            if (component[source(*edge, graph)] != component[target(*edge, graph)])
                closed[component[source(*edge, graph)]] = false;
        const std::size_t first = set_.whole.front().state;
        const Surrounded* chosen = nullptr;
        std::size_t least = ~std::size_t{0}, most = 0;
        for (std::size_t k = 0; k < list.size(); ++k) {
            if (!closed[component[k]] || set_.shapes[list[k]->state] != set_.shapes[first])
                continue;
            least = std::min(least, list[k]->others.size());
            most = std::max(most, list[k]->others.size());
            if (list[k]->state == first && (!chosen || *list[k] < *chosen)) chosen = list[k];
        }
        if (!chosen) {
            out_.disk_like.because = "tiles like the whole do not come back within it";
            return;
        }
        out_.least_neighbours = least;
        out_.most_neighbours = most;
        out_.neighbours = moved(chosen->others, set_.whole.front().by);
        for (const Placed& other : out_.neighbours)
            boundary_.push_back(pair_of(set_.whole.front(), other));
    }

    // Like a disc.

    void find_disk_like() {
        if (out_.is_periodic && set_.parts.size() == 1 && out_.connected.answer == Answer::yes) {
            by_bandt_and_wang();
            return;
        }
        if (out_.is_periodic && !has_shape_of_lattice()) {
            out_.disk_like = {Answer::no,
                              "discs that tile by a lattice have six or eight neighbours "
                              "(Gruenbaum and Shephard)"};
            return;
        }
        if (Ring(*meetings_).is_simple(boundary_)) {
            out_.disk_like = {
                Answer::yes,
                "its boundary is a ring of arcs, a simple closed curve (Jordan, Schoenflies)"};
            return;
        }
        if (is_alike() && !out_.is_periodic && find_three_points()) return;
        out_.disk_like.because =
            "its boundary is not seen to be a simple closed curve, nor not to be one";
    }

    /// Whether all tiles are congruent.
    bool is_alike() const {
        return std::all_of(set_.shapes.begin(), set_.shapes.end(),
                           [&](std::size_t shape) { return shape == set_.shapes.front(); });
    }

    using Step = std::pair<std::int64_t, std::int64_t>;

    /// Two of the neighbours a and b such that all are a, b, a + b, a - b and their opposites; or, of six, without a - b.
    std::optional<std::pair<Step, Step>> axes() const {
        const std::set<Step> all(steps_.begin(), steps_.end());
        if (all.size() != 6 && all.size() != 8) return std::nullopt;
        for (const Step& a : all)
            for (const Step& b : all) {
                std::set<Step> expected;
                for (const std::int64_t sign : {-1, 1}) {
                    expected.emplace(sign * a.first, sign * a.second);
                    expected.emplace(sign * b.first, sign * b.second);
                    expected.emplace(sign * (a.first + b.first), sign * (a.second + b.second));
                    if (all.size() == 8)
                        expected.emplace(sign * (a.first - b.first), sign * (a.second - b.second));
                }
                if (expected == all) return std::pair(a, b);
            }
        return std::nullopt;
    }

    bool has_shape_of_lattice() const { return axes().has_value(); }

    void by_bandt_and_wang() {
        const std::string name = " (Bandt and Wang)";
        const auto found = axes();
        const std::size_t count = out_.neighbours.size();
        if (count <= 6) {
            out_.disk_like = {Answer::yes, "it is connected and has at most six neighbours" + name};
        } else if (!found) {
            out_.disk_like = {Answer::no,
                              "its neighbours are not six or eight as those of discs are" + name};
        } else {
            const Step a = found->first, b = found->second;
            const auto& parts = set_.parts.front();
            const bool is = is_connected(parts.size(), [&](std::size_t i, std::size_t k) {
                const Vector by = parts[k].by - parts[i].by;
                const Step step(by[0], by[1]), back(-by[0], -by[1]);
                return step == a || step == b || back == a || back == b;
            });
            out_.disk_like = {
                is ? Answer::yes : Answer::no,
                (is ? "it has eight neighbours, and its parts hang together by its four sides"
                    : "it has eight neighbours, and its parts do not hang together by its four "
                      "sides") +
                    name};
        }
    }

    bool find_three_points() {
        for (std::size_t i = 0; i < out_.neighbours.size(); ++i)
            for (std::size_t k = i + 1; k < out_.neighbours.size(); ++k) {
                budget_.check();
                Group three{set_.whole.front(), out_.neighbours[i], out_.neighbours[k]};
                std::sort(three.begin(), three.end());
                const auto met = meetings_->find(three);
                if (!met || !meetings_->has_three_points(*met)) continue;
                out_.disk_like = {
                    Answer::no,
                    "three tiles have three points in common, and three discs side by side "
                    "cannot: K_3,3 is not planar (Kuratowski)"};
                return true;
            }
        return false;
    }

    // Points without which the tile is not connected.

    /// A tile at 0 with the tiles that it meets, on two sides: those of one side do not meet those of the other, nearby or anywhere.
    struct Cut {
        std::size_t state;
        Group left, right;
        friend bool operator<(const Cut& one, const Cut& other) {
            return std::tie(one.state, one.left, one.right) <
                   std::tie(other.state, other.left, other.right);
        }
    };
    struct CutNode {
        const Cut* cut;
        std::vector<std::pair<std::size_t, Vector>>
            next;  // another one within it, and where it lies
        bool alive = true;
    };

    /// An endless path of cuts, each within the one before, has one point in common, and the tile without it is two parts that are closed
    /// in it. Both have inner points, and the point is not an inner one, as a disc without a point is connected: so the
    /// interior is not connected either. Every further cut point makes one more part of it.
    void find_cut_points() {
        constexpr std::size_t most_pieces = 64;
        if (set_.whole.size() != 1) return;
        // Pieces of the first levels may be seen to be cuts before all those on the way to them.
        for (Group level = meetings_->parts(set_.whole.front()); level.size() <= most_pieces;
             level = finer(level)) {
            budget_.check();
            begin_cuts(level);
            go_through_cuts();
            if (tell_cuts()) break;
        }
        number({set_.whole.front().state, {}, {}});
        go_through_cuts();
        if (tell_cuts() && are_endless())
            out_.infinitely_many = {Answer::yes, "infinitely many points part it"};
    }

    /// Whether there is a cut point.
    bool tell_cuts() {
        if (std::none_of(cuts_.begin(), cuts_.end(),
                         [](const CutNode& node) { return node.alive && has_sides(node); }))
            return false;
        if (out_.disk_like.answer == Answer::undecided)
            out_.disk_like = {Answer::no, "without one of its points it is not connected"};
        out_.interior_connected = {Answer::no, "a point that parts the tile parts its interior"};
        return true;
    }

    Group finer(const Group& level) const {
        Group found;
        for (const Placed& tile : level)
            for (const Placed& part : meetings_->parts(tile)) found.push_back(part);
        std::sort(found.begin(), found.end());
        return found;
    }

    using Joined = std::vector<std::vector<std::size_t>>;  // by tile, those that it meets

    Joined joined(const Group& tiles) {
        Joined found(tiles.size());
        for (std::size_t i = 0; i < tiles.size(); ++i)
            for (std::size_t k = i + 1; k < tiles.size(); ++k)
                if (meet(tiles[i], tiles[k])) {
                    found[i].push_back(k);
                    found[k].push_back(i);
                }
        return found;
    }

    static constexpr std::size_t nowhere = ~std::size_t{0};

    /// By tile, a number of those that it hangs together with, without one of the tiles.
    static std::vector<std::size_t> hanging_together(const Joined& joined, std::size_t without) {
        std::vector<std::size_t> found(joined.size(), nowhere);
        std::size_t count = 0;
        for (std::size_t first = 0; first < joined.size(); ++first) {
            if (first == without || found[first] != nowhere) continue;
            std::vector<std::size_t> open{first};
            found[first] = count;
            while (!open.empty()) {
                const std::size_t k = open.back();
                open.pop_back();
                for (const std::size_t i : joined[k])
                    if (i != without && found[i] == nowhere) {
                        found[i] = count;
                        open.push_back(i);
                    }
            }
            ++count;
        }
        return found;
    }

    std::size_t number(Cut cut) {
        const std::size_t most_cuts = std::min<std::size_t>(most_, 2'000);
        for (Group* const side : {&cut.left, &cut.right}) std::sort(side->begin(), side->end());
        if (cut.right < cut.left) std::swap(cut.left, cut.right);
        const auto [place, is_new] = cut_numbers_.try_emplace(std::move(cut), cuts_.size());
        if (is_new) {
            if (cuts_.size() == most_cuts)
                throw BoundReached(Bound::method, "more than " + std::to_string(most_cuts) +
                                                      " ways in which a part may part the others");
            cuts_.push_back({&place->first, {}, true});
        }
        return place->second;
    }

    /// The tiles of one side that meet a tile, seen from it.
    Group seen_from(const Placed& tile, const Group& tiles) {
        Group found;
        for (const Placed& other : tiles)
            if (meet(tile, other)) found.push_back({other.state, other.by - tile.by});
        return found;
    }

    /// Pieces without which the others do not hang together: some against the rest.
    void begin_cuts(const Group& level) {
        const Joined all = joined(level);
        for (std::size_t piece = 0; piece < level.size(); ++piece) {
            const auto part = hanging_together(all, piece);
            std::size_t count = 0;
            for (const std::size_t k : part)
                if (k != nowhere) count = std::max(count, k + 1);
            for (std::size_t k = 0; count > 1 && k + (count == 2 ? 1 : 0) < count; ++k)
                number(
                    cut_at(level, all, piece, [&](std::size_t tile) { return part[tile] == k; }));
        }
    }

    /// A tile with those that it meets, on two sides.
    template <class IsLeft>
    static Cut cut_at(const Group& tiles, const Joined& joined, std::size_t piece,
                      const IsLeft& is_left) {
        Cut found{tiles[piece].state, {}, {}};
        for (const std::size_t k : joined[piece])
            (is_left(k) ? found.left : found.right)
                .push_back({tiles[k].state, tiles[k].by - tiles[piece].by});
        return found;
    }

    /// The cuts within one: a part of its tile, if the other parts join no two sides.
    void go_on(std::size_t number_of_cut) {
        constexpr std::size_t most_free = 3;
        const Cut cut = *cuts_[number_of_cut].cut;
        const Group left = finer(cut.left), right = finer(cut.right);
        Group tiles = meetings_->parts(Placed{cut.state, {}});
        const std::size_t own = tiles.size(), with_left = own + left.size();
        tiles.insert(tiles.end(), left.begin(), left.end());
        tiles.insert(tiles.end(), right.begin(), right.end());
        const Joined all = joined(tiles);
        std::vector<std::pair<std::size_t, Vector>> next;
        for (std::size_t part = 0; part < own; ++part) {
            const auto kind = hanging_together(all, part);
            std::set<std::size_t> of_left, of_right, free;
            for (std::size_t k = own; k < tiles.size(); ++k)
                (k < with_left ? of_left : of_right).insert(kind[k]);
            if (std::any_of(of_left.begin(), of_left.end(),
                            [&](std::size_t k) { return of_right.contains(k); }))
                continue;
            for (std::size_t k = 0; k < own; ++k)
                if (k != part && !of_left.contains(kind[k]) && !of_right.contains(kind[k]))
                    free.insert(kind[k]);
            if (free.size() > most_free) continue;
            // Those that neither side meets may count as of each.
            for (std::size_t choice = 0; choice < (std::size_t{1} << free.size()); ++choice) {
                std::set<std::size_t> to_left = of_left;
                std::size_t bit = 0;
                for (const std::size_t each : free)
                    if ((choice >> bit++ & 1) != 0) to_left.insert(each);
                next.emplace_back(
                    number(cut_at(tiles, all, part,
                                  [&](std::size_t k) { return to_left.contains(kind[k]); })),
                    tiles[part].by);
            }
        }
        cuts_[number_of_cut].next = std::move(next);
    }

    static bool has_sides(const CutNode& node) {
        return !node.cut->left.empty() && !node.cut->right.empty();
    }

    void go_through_cuts() {
        for (; cuts_done_ < cuts_.size(); ++cuts_done_) {
            budget_.check();
            go_on(cuts_done_);
        }
        for (bool changed = true; changed;) {
            changed = false;
            for (CutNode& node : cuts_) {
                std::erase_if(node.next,
                              [&](const auto& next) { return !cuts_[next.first].alive; });
                if (node.alive && node.next.empty()) {
                    node.alive = false;
                    changed = true;
                }
            }
        }
    }

    /// Whether there are infinitely many cut points. From the whole, through parts with all others on one side, to those with others
    /// on two: if a part contains itself again, by a map, and a cut point other than the fixed point of the map, then the images of
    /// the cut point under the map are as many.
    bool are_endless() const {
        boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS> graph(cuts_.size());
        for (std::size_t k = 0; k < cuts_.size(); ++k)
            for (const auto& next : cuts_[k].next) boost::add_edge(k, next.first, graph);
        std::vector<std::size_t> component(cuts_.size());
        boost::strong_components(graph, boost::make_iterator_property_map(
                                            component.begin(), get(boost::vertex_index, graph)));
        for (std::size_t k = 0; k < cuts_.size(); ++k) {
            budget_.check();
            std::vector<Vector> cycle;
            for (const auto& [to, by] : cuts_[k].next)
                if (cycle.empty() && component[to] == component[k]) {
                    cycle = shifts_to(to, [&](std::size_t node) { return node == k; }).second;
                    cycle.insert(cycle.begin(), by);
                }
            if (cycle.empty()) continue;
            const ExactPoint fixed = meetings_->fixed_point(cycle);
            for (const auto& [to, by] : cuts_[k].next) {
                auto [node, shifts] =
                    shifts_to(to, [&](std::size_t each) { return has_sides(cuts_[each]); });
                if (!node) continue;
                shifts.insert(shifts.begin(), by);
                if (moved_back(cut_point(*node), shifts) != fixed) return true;
            }
        }
        return false;
    }

    /// The nearest cut from one on that is asked for, with the places on the way to it.
    template <class IsAsked>
    std::pair<std::optional<std::size_t>, std::vector<Vector>> shifts_to(
        std::size_t from, const IsAsked& is_asked) const {
        std::map<std::size_t, std::pair<std::size_t, Vector>> before{{from, {from, {}}}};
        std::deque<std::size_t> open{from};
        while (!open.empty()) {
            const std::size_t node = open.front();
            open.pop_front();
            if (is_asked(node)) {
                std::vector<Vector> shifts;
                for (std::size_t at = node; at != from; at = before.at(at).first)
                    shifts.push_back(before.at(at).second);
                std::reverse(shifts.begin(), shifts.end());
                return {node, std::move(shifts)};
            }
            for (const auto& [to, by] : cuts_[node].next)
                if (before.try_emplace(to, node, by).second) open.push_back(to);
        }
        return {};
    }

    ExactPoint moved_back(ExactPoint point, const std::vector<Vector>& shifts) const {
        for (auto shift = shifts.rbegin(); shift != shifts.rend(); ++shift)
            point = meetings_->smaller(Meetings::shifted(std::move(point), *shift));
        return point;
    }

    /// The point to which the first cuts within cuts lead.
    ExactPoint cut_point(std::size_t node) const {
        std::vector<std::size_t> path;
        std::vector<Vector> shifts;
        auto place = path.end();
        for (; place == path.end(); place = std::find(path.begin(), path.end(), node)) {
            path.push_back(node);
            shifts.push_back(cuts_[node].next.front().second);
            node = cuts_[node].next.front().first;
        }
        const auto begin = place - path.begin();
        ExactPoint at = meetings_->fixed_point({shifts.begin() + begin, shifts.end()});
        return moved_back(std::move(at), {shifts.begin(), shifts.begin() + begin});
    }

    void find_interior() {
        if (out_.interior_connected.answer == Answer::no) return;
        if (out_.disk_like.answer == Answer::yes) {
            out_.interior_connected = {Answer::yes, "as of a disc"};
            out_.infinitely_many = {Answer::no, "as of a disc"};
        } else if (out_.disk_like.answer == Answer::no && out_.connected.answer == Answer::yes &&
                   is_alike() && set_.whole.size() == 1) {
            out_.interior_connected = {
                Answer::no,
                "a connected tile with a connected interior is like a disc (Luo, Rao and Tan)"};
        } else {
            out_.interior_connected.because = "no theorem decides it here";
        }
    }

    LatticeSet set_;
    const Budget& budget_;
    std::size_t most_;
    Tile out_;
    std::vector<Rational> areas_;  // by state
    Meetings* meetings_ = nullptr;
    std::vector<Group> boundary_;  // pairs of a part of the whole and one of a neighbour
    std::vector<Step> steps_;      // the neighbours of a periodic tiling, in periods
    std::map<Cut, std::size_t> cut_numbers_;
    std::vector<CutNode> cuts_;
    std::size_t cuts_done_ = 0;
};

}  // namespace

Tile tile(const LatticeSet& set, const Budget& budget, std::size_t most) {
    return Examination(set, budget, most).result();
}

namespace {

using Pixel = std::pair<std::int64_t, std::int64_t>;

/// The pixels of a grid that belong to tiles, each to the first one with a small part in it.
class Pixels {
public:
    Pixels(const LatticeSet& set, std::size_t across, const Budget& budget)
        : set_(set), budget_(budget), discs_(discs_of(set)) {
        const auto& [a, b, c, d] = set.linear;
        determinant_ = a * d - b * c;
        shrinking_ =
            (std::hypot(a + d, c - b) + std::hypot(a - d, b + c)) / 2 / std::abs(determinant_);
        double left = INFINITY, right = -INFINITY;
        for (const Placed& part : set.whole) {
            const double middle = set.place(part.by).x + discs_[part.state].centre.real();
            left = std::min(left, middle - discs_[part.state].radius);
            right = std::max(right, middle + discs_[part.state].radius);
        }
        side_ = (right - left) / static_cast<double>(across);
    }

    void add(const Placed& tile, std::size_t owner) {
        const Point at = set_.place(tile.by);
        go_on(tile.state, {at.x, at.y}, {1, 0, 0, 1}, 1, owner);
    }

    /// Around the pixels of a tile, these on the left; from loop to loop and back.
    std::vector<Point> outline(std::size_t owner) const {
        std::map<Pixel, std::vector<Pixel>> edges;
        const auto is_own = [&](std::int64_t x, std::int64_t y) {
            const auto place = owners_.find({x, y});
            return place != owners_.end() && place->second.first.first == owner;
        };
        for (const auto& [pixel, of] : owners_) {
            if (of.first.first != owner) continue;
            const auto [x, y] = pixel;
            if (!is_own(x, y - 1)) edges[{x, y}].push_back({x + 1, y});
            if (!is_own(x + 1, y)) edges[{x + 1, y}].push_back({x + 1, y + 1});
            if (!is_own(x, y + 1)) edges[{x + 1, y + 1}].push_back({x, y + 1});
            if (!is_own(x - 1, y)) edges[{x, y + 1}].push_back({x, y});
        }
        std::vector<Point> polygon;
        const auto put = [&](const Pixel& at) {
            polygon.push_back(
                {static_cast<double>(at.first) * side_, static_cast<double>(at.second) * side_});
        };
        for (auto& [from, to] : edges)
            while (!to.empty()) {
                const bool is_first = polygon.empty();
                Pixel here = from;
                do {
                    put(here);
                    auto& out = edges[here];
                    here = out.back();
                    out.pop_back();
                } while (here != from);
                put(from);
                if (!is_first) polygon.push_back(polygon.front());
            }
        return polygon;
    }

private:
    static constexpr double fine = 0.4;  // the radius of a part, in pixels

    /// With the power of the inverse map, by which a part is smaller.
    void go_on(std::size_t state, std::complex<double> at, const std::array<double, 4>& power,
               double size, std::size_t owner) {
        const auto applied = [](const std::array<double, 4>& by, double x, double y) {
            return std::complex<double>{by[0] * x + by[1] * y, by[2] * x + by[3] * y};
        };
        const auto& disc = discs_[state];
        if (disc.radius * size <= fine * side_) {
            const auto middle = at + applied(power, disc.centre.real(), disc.centre.imag());
            auto& [most, held] =
                owners_[{static_cast<std::int64_t>(std::floor(middle.real() / side_)),
                         static_cast<std::int64_t>(std::floor(middle.imag() / side_))}];
            // Tiles come one after the other: the one that holds the most of a pixel.
            if (held.empty() || held.back().first != owner) held.emplace_back(owner, 0);
            if (++held.back().second > most.second) most = held.back();
            return;
        }
        if (++steps_ % 4096 == 0) budget_.check();
        const auto& [a, b, c, d] = set_.linear;
        const std::array<double, 4> inverse{d / determinant_, -b / determinant_, -c / determinant_,
                                            a / determinant_};
        const std::array<double, 4> next{power[0] * inverse[0] + power[1] * inverse[2],
                                         power[0] * inverse[1] + power[1] * inverse[3],
                                         power[2] * inverse[0] + power[3] * inverse[2],
                                         power[2] * inverse[1] + power[3] * inverse[3]};
        for (const Placed& part : set_.parts[state]) {
            const Point by = set_.place(part.by);
            go_on(part.state, at + applied(next, by.x, by.y), next, size * shrinking_, owner);
        }
    }

    const LatticeSet& set_;
    const Budget& budget_;
    std::vector<RecurrentSet::Disc> discs_;
    double determinant_ = 1, shrinking_ = 1, side_ = 1;
    std::uint64_t steps_ = 0;
    using Share = std::pair<std::size_t, std::size_t>;  // a tile, and how many small parts of it
    std::map<Pixel, std::pair<Share, std::vector<Share>>> owners_;
};

}  // namespace

std::vector<std::vector<Point>> tile_outlines(const Tile& of, std::size_t across,
                                              const Budget& budget) {
    const LatticeSet& set = of.set;
    Pixels pixels(set, across, budget);
    for (const Placed& part : set.whole) pixels.add(part, 0);
    for (std::size_t k = 0; k < of.neighbours.size(); ++k) {
        const Placed& neighbour = of.neighbours[k];
        if (!of.is_periodic)
            pixels.add(neighbour, k + 1);
        else
            for (const Placed& part : set.whole)
                pixels.add({part.state, part.by + neighbour.by}, k + 1);
    }
    std::vector<std::vector<Point>> found;
    for (std::size_t k = 0; k <= of.neighbours.size(); ++k) found.push_back(pixels.outline(k));
    return found;
}

std::string square_root_text(const Rational& square) {
    // sqrt(p / q) = sqrt(p q) / q.
    if (square.is_zero()) return "0";
    Integer under = square.numerator() * square.denominator(), out = 1;
    for (long k = 2; k < 10'000 && Integer(k) * Integer(k) <= under; ++k)
        while (remainder(under, Integer(k) * Integer(k)).is_zero()) {
            under = exact_divide(under, Integer(k) * Integer(k));
            out *= Integer(k);
        }
    const Rational factor(out, square.denominator());
    if (under == 1) return to_string(factor);
    std::string text = "sqrt(" + to_string(under) + ")";
    if (factor.numerator() != 1) text = to_string(factor.numerator()) + "*" + text;
    if (factor.denominator() != 1) text += "/" + to_string(factor.denominator());
    return text;
}

}  // namespace algae
