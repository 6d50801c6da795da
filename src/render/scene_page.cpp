#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "render/detail/document.hpp"
#include "render/detail/figure_text.hpp"
#include "render/detail/palette.hpp"
#include "render/render.hpp"

// Figures in space for browsers: a page with the parts of scenes as numbers and a program that draws them on a canvas.
//
// A part is a stroke, with its thickness, or a polygon; a solid is several polygons. The program turns all points, sorts parts by how near
// their middles are and draws the farthest first, which for the thin parts of plants is good enough and needs nothing of the machine but
// a canvas. Polygons are lighter where they face the light. Coordinates are whole numbers, 10,000 along the diagonal of the largest scene, so
// that all scenes of a page have one scale.
//
// Parts come in the order in which the turtle left them, as far as it is known: rods, faces and solids are lists of their own, each in its
// order, and are mixed evenly.

namespace algae {

namespace {

constexpr double longest = 10'000;  // units along the diagonal
constexpr std::uint64_t memory_of_a_part = 250;

constexpr const char* page_head = R"(<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<style>
body { font-family: sans-serif; margin: 0; display: flex; flex-direction: column; height: 100vh; color: #222; background: #fff }
header, footer { padding: 0.5em 1em; flex: none; background: #fff }
h1 { font-size: 1.1em; margin: 0 }
p { margin: 0.2em 0 0; font-size: 0.85em; color: #555 }
#stage { flex: 1; min-height: 0; position: relative }
canvas { position: absolute; width: 100%; height: 100%; cursor: grab; touch-action: none }
footer { display: flex; flex-wrap: wrap; gap: 0.3em 1.5em; align-items: center; border-top: 1px solid #ddd; font-size: 0.9em }
label { display: flex; gap: 0.5em; align-items: center }
input[type=range] { width: 14em }
output { min-width: 7em }
[hidden] { display: none }
</style>
)";

constexpr const char* page_program = R"program(
const canvas = document.getElementById("picture"), pen = canvas.getContext("2d");
const generation = document.getElementById("generation"), parts = document.getElementById("parts");
const start = {...view, x: 0, y: 0, zoom: 1};
view = {...start};
let playing = 0;
const shown = () => scenes[+generation.value];

function lit(colour, light) {
    return "rgb(" + colour.map(part => Math.round(part * light)).join() + ")";
}
function draw() {
    const ratio = window.devicePixelRatio || 1, scene = shown();
    canvas.width = canvas.clientWidth * ratio;
    canvas.height = canvas.clientHeight * ratio;
    const size = Math.hypot(...scene.high.map((high, i) => high - scene.low[i])) || 1;
    const scale = 0.94 * Math.min(canvas.width, canvas.height) / size * view.zoom;
    const middle = scene.high.map((high, i) => (high + scene.low[i]) / 2);
    const ca = Math.cos(view.azimuth), sa = Math.sin(view.azimuth);
    const ce = Math.cos(view.elevation), se = Math.sin(view.elevation);
    const far = view.opening ? size / 2 / Math.sin(view.opening / 2) : 0;
    const seen = (x, y, z) => {
        x -= middle[0]; y -= middle[1]; z -= middle[2];
        const out = ca * x + sa * y, near = ce * out + se * z;
        const grows = far ? far / Math.max(far - near, far / 100) : 1;
        return [(ca * y - sa * x) * grows, (se * out - ce * z) * grows, near, grows];
    };
    pen.setTransform(1, 0, 0, 1, 0, 0);
    pen.fillStyle = background;
    pen.fillRect(0, 0, canvas.width, canvas.height);
    pen.translate(canvas.width / 2 + view.x * ratio, canvas.height / 2 + view.y * ratio);
    pen.scale(scale, scale);
    pen.lineCap = pen.lineJoin = "round";
    const visible = [];
    for (const part of scene.parts) {
        if (part[0] > +parts.value) break;
        const points = [];
        let depth = 0;
        for (let i = 3; i < part.length; i += 3) {
            points.push(seen(part[i], part[i + 1], part[i + 2]));
            depth += points[points.length - 1][2];
        }
        visible.push([depth / points.length, part, points]);
    }
    visible.sort((one, other) => one[0] - other[0]);
    for (const [depth, part, points] of visible) {
        pen.beginPath();
        for (const [x, y] of points) pen.lineTo(x, y);
        const colour = colours[part[1]];
        if (part[2] >= 0) {
            // A thick stroke has a dark edge, by which it is told from what is behind it.
            const width = Math.max(part[2] * points[0][3], ratio / scale), thick = width * scale > 4 * ratio;
            pen.strokeStyle = lit(colour, thick ? 0.6 : 1);
            pen.lineWidth = width;
            pen.stroke();
            if (!thick) continue;
            pen.strokeStyle = lit(colour, 1);
            pen.lineWidth = 0.7 * width;
            pen.stroke();
            continue;
        }
        const [a, b, c] = points;
        const u = b.map((value, i) => value - a[i]), v = c.map((value, i) => value - a[i]);
        const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        const light = [-0.4, -0.6, 0.7], length = Math.hypot(normal[0], normal[1], normal[2]) || 1;
        const facing = Math.abs(normal[0] * light[0] + normal[1] * light[1] + normal[2] * light[2]) / length;
        pen.fillStyle = pen.strokeStyle = lit(colour, 0.45 + 0.55 * Math.min(1, facing));
        pen.lineWidth = 0.5 * ratio / scale;
        pen.closePath();
        pen.fill();
        pen.stroke();
    }
    document.getElementById("name").textContent = scene.name;
    document.getElementById("count").textContent = parts.value + " of " + scene.steps;
    document.title = scene.name;
    canvas.dataset.drawn = visible.length;
}
function choose() {
    parts.max = shown().steps;
    parts.value = parts.max;
    draw();
}
function play() {
    cancelAnimationFrame(playing);
    const all = shown().steps, begin = performance.now(), time = Math.min(15000, 500 + 100 * all);
    const step = now => {
        parts.value = Math.min(all, Math.ceil(all * (now - begin) / time));
        draw();
        if (+parts.value < all) playing = requestAnimationFrame(step);
    };
    playing = requestAnimationFrame(step);
}
const fingers = new Map();
canvas.onpointerdown = event => {
    canvas.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, event);
};
canvas.onpointerup = canvas.onpointercancel = event => fingers.delete(event.pointerId);
canvas.onpointermove = event => {
    const before = fingers.get(event.pointerId);
    if (!before) return;
    const x = event.clientX - before.clientX, y = event.clientY - before.clientY;
    if (fingers.size === 2) {
        const other = [...fingers.values()].find(finger => finger.pointerId !== event.pointerId);
        const was = Math.hypot(before.clientX - other.clientX, before.clientY - other.clientY);
        view.zoom *= Math.hypot(event.clientX - other.clientX, event.clientY - other.clientY) / (was || 1);
    } else if (event.shiftKey) {
        view.x += x;
        view.y += y;
    } else {
        view.azimuth -= x / 150;
        view.elevation = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, view.elevation + y / 150));
    }
    fingers.set(event.pointerId, event);
    draw();
};
canvas.onwheel = event => {
    event.preventDefault();
    view.zoom *= Math.exp(-event.deltaY / 400);
    draw();
};
document.getElementById("reset").onclick = () => { view = {...start}; draw(); };
document.getElementById("play").onclick = play;
generation.oninput = choose;
parts.oninput = () => { cancelAnimationFrame(playing); draw(); };
window.onresize = draw;
generation.max = scenes.length - 1;
generation.value = generation.max;
document.getElementById("which").hidden = scenes.length < 2;
// A link can say what is shown first: page.html#figure=1&parts=20&azimuth=45&elevation=30&zoom=2
const link = new URLSearchParams(location.hash.slice(1));
if (link.has("figure")) generation.value = link.get("figure");
choose();
if (location.hash) {
    if (link.has("parts")) parts.value = link.get("parts");
    for (const angle of ["azimuth", "elevation"])
        if (link.has(angle)) view[angle] = link.get(angle) * Math.PI / 180;
    if (link.has("zoom")) view.zoom = +link.get("zoom") || 1;
    draw();
}
)program";

/// The corners of the sides of solids.
class Sides {
public:
    explicit Sides(unsigned facets) : facets_(2 * facets) {}

    std::vector<std::vector<Vector>> of(const Solid& solid) const {
        switch (solid.shape) {
            case SolidShape::box:
                return of_box(solid);
            case SolidShape::sphere:
                return of_ball(solid);
            case SolidShape::cylinder:
            case SolidShape::cone:
                break;
        }
        return of_round(solid, solid.shape == SolidShape::cylinder ? 1 : 0);
    }

private:
    static Vector at(const Solid& solid, double along, double left, double up) {
        const Attitude& axes = solid.attitude;
        return solid.middle + along * axes.heading() + left * axes.left() + up * axes.up();
    }
    static std::vector<std::vector<Vector>> of_box(const Solid& solid) {
        const Vector half = 0.5 * solid.size;
        std::vector<std::vector<Vector>> sides;
        for (int axis = 0; axis < 3; ++axis)
            for (const double sign : {-1.0, 1.0}) {
                std::vector<Vector> side;
                for (const auto& [a, b] :
                     {std::pair(-1.0, -1.0), {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}})
                    side.push_back(axis == 0   ? at(solid, sign * half.x, a * half.y, b * half.z)
                                   : axis == 1 ? at(solid, a * half.x, sign * half.y, b * half.z)
                                               : at(solid, a * half.x, b * half.y, sign * half.z));
                sides.push_back(std::move(side));
            }
        return sides;
    }
    /// Around the heading; `top` is the share of the radius that the front end has.
    std::vector<std::vector<Vector>> of_round(const Solid& solid, double top) const {
        const double half = solid.size.x / 2, radius = solid.size.y;
        const auto ring = [&](double along, double share, unsigned i) {
            const double angle = 2 * std::numbers::pi * i / facets_;
            return at(solid, along, share * radius * std::cos(angle),
                      share * radius * std::sin(angle));
        };
        std::vector<std::vector<Vector>> sides(1);
        for (unsigned i = 0; i < facets_; ++i) {
            sides.front().push_back(ring(-half, 1, i));
            std::vector<Vector> side{ring(-half, 1, i), ring(-half, 1, i + 1)};
            side.push_back(ring(half, top, i + 1));
            if (top > 0) side.push_back(ring(half, top, i));
            sides.push_back(std::move(side));
        }
        if (top > 0) {
            sides.emplace_back();
            for (unsigned i = 0; i < facets_; ++i) sides.back().push_back(ring(half, top, i));
        }
        return sides;
    }
    std::vector<std::vector<Vector>> of_ball(const Solid& solid) const {
        const double radius = solid.size.x;
        const auto point = [&](unsigned row, unsigned i) {
            const double height = std::numbers::pi * row / (facets_ / 2.0),
                         angle = 2 * std::numbers::pi * i / facets_;
            return at(solid, radius * std::cos(height), radius * std::sin(height) * std::cos(angle),
                      radius * std::sin(height) * std::sin(angle));
        };
        std::vector<std::vector<Vector>> sides;
        for (unsigned row = 0; row < facets_ / 2; ++row)
            for (unsigned i = 0; i < facets_; ++i) {
                std::vector<Vector> side{point(row, i)};
                if (row > 0) side.push_back(point(row, i + 1));
                side.push_back(point(row + 1, i + 1));
                if (row + 1 < facets_ / 2) side.push_back(point(row + 1, i));
                sides.push_back(std::move(side));
            }
        return sides;
    }

    unsigned facets_;
};

/// The parts of scenes as the program has them.
class PageScenes {
public:
    PageScenes(const MeshChoices& choices, const Budget& budget)
        : choices_(choices), budget_(budget), sides_(choices.mesh.facets) {}

    void add(const NamedScene& named, double scale) {
        const Scene& scene = *named.scene;
        scale_ = scale;
        budget_.check_memory(scene.parts() * memory_of_a_part, "the page");
        const std::vector<std::string>& listed =
            choices_.colours.empty() ? scene.colours : choices_.colours;
        const Palette palette(listed.empty() ? std::vector<std::string>{"gray"} : listed, 360);
        const SpaceBox box = box_of(scene);
        drawn.box.add(box);
        text += "{name: " + script_string(named.name) +
                ", steps: " + std::to_string(scene.parts()) + ", low: [" + point(box.low) +
                "], high: [" + point(box.high) + "], parts: [\n";
        // Each list in its order, all of them mixed evenly.
        std::size_t rods = 0, faces = 0, solids = 0;
        const auto share = [](std::size_t done, std::size_t all) {
            return all == done ? 2.0 : static_cast<double>(done) / static_cast<double>(all);
        };
        for (std::size_t step = 1; step <= scene.parts(); ++step) {
            const double rod = share(rods, scene.rods.size()),
                         face = share(faces, scene.faces.size()),
                         solid = share(solids, scene.solids.size());
            const double place = static_cast<double>(step) / static_cast<double>(scene.parts());
            const auto begin = [&](const Paint& paint, double width) {
                const Colour colour = paint.colour
                                          ? *paint.colour
                                          : palette.colour(palette.shade(paint.index, place));
                text += "[" + std::to_string(step) + "," + std::to_string(number(colour)) + "," +
                        fixed_text(width, 2);
            };
            if (rod <= face && rod <= solid) {
                const Rod& one = scene.rods[rods++];
                begin(one.paint, 2 * one.radius * scale_);
                text += "," + point(one.from) + "," + point(one.to) + "],\n";
                ++(one.radius > 0 ? drawn.solids : drawn.lines);
            } else if (face <= solid) {
                const Face& one = scene.faces[faces++];
                begin(one.paint, -1);
                for (const Vector& corner : scene.corners_of(one)) text += "," + point(corner);
                text += "],\n";
                drawn.vertices += one.corners;
                drawn.triangles += one.corners < 3 ? 0 : one.corners - 2;
            } else {
                const Solid& one = scene.solids[solids++];
                for (const std::vector<Vector>& side : sides_.of(one)) {
                    begin(one.paint, -1);
                    for (const Vector& corner : side) text += "," + point(corner);
                    text += "],\n";
                }
                ++drawn.solids;
            }
            if (step % 4096 == 0) budget_.check();
        }
        text += "]},\n";
    }

    std::string colours() const {
        std::string out;
        for (const Colour& colour : colours_) {
            const auto part = [](double x) { return std::to_string(std::lround(255 * x)); };
            out +=
                "[" + part(colour.red) + "," + part(colour.green) + "," + part(colour.blue) + "],";
        }
        return out;
    }

    std::string text;
    MeshDrawn drawn;

private:
    std::size_t number(const Colour& colour) {
        const auto found = std::ranges::find(colours_, colour);
        if (found != colours_.end()) return static_cast<std::size_t>(found - colours_.begin());
        colours_.push_back(colour);
        return colours_.size() - 1;
    }
    std::string point(const Vector& at) const {
        return fixed_text(at.x * scale_, 1) + "," + fixed_text(at.y * scale_, 1) + "," +
               fixed_text(at.z * scale_, 1);
    }

    const MeshChoices& choices_;
    const Budget& budget_;
    Sides sides_;
    double scale_ = 1;
    std::vector<Colour> colours_;
};

}  // namespace

MeshDrawn draw_scene_page(std::span<const NamedScene> scenes, const Target& target,
                          const MeshChoices& choices, const PictureOptions& options,
                          const Budget& budget) {
    check_camera(choices.camera);
    double diagonal = 0;
    for (const NamedScene& one : scenes)
        if (!one.scene->empty()) diagonal = std::max(diagonal, box_of(*one.scene).diagonal());
    if (std::ranges::all_of(scenes, [](const NamedScene& one) { return one.scene->empty(); }))
        throw Error((scenes.empty() ? std::string("the page") : scenes.back().name) +
                    " draws nothing");
    PageScenes page(choices, budget);
    for (const NamedScene& one : scenes) page.add(one, diagonal > 0 ? longest / diagonal : 1);
    const std::string head = options.title.empty() ? scenes.back().name : options.title;
    const auto radians = [](double degrees) {
        return fixed_text(degrees * std::numbers::pi / 180, 6);
    };
    std::string out = "<!DOCTYPE html>\n<html lang=\"en\">\n<title>" + escaped_markup(head) +
                      "</title>\n" + page_head + "<header><h1>" + escaped_markup(head) +
                      "</h1><p><span id=\"name\"></span>";
    for (const std::string* said : {&options.source, &options.author})
        if (!said->empty()) out += " &middot; " + escaped_markup(*said);
    out +=
        "</p></header>\n<div id=\"stage\"><canvas id=\"picture\"></canvas></div>\n<footer>\n<label "
        "id=\"which\">figure <input id=\"generation\" type=\"range\" min=\"0\" "
        "step=\"1\"></label>\n<label>parts <input id=\"parts\" type=\"range\" min=\"0\" "
        "step=\"1\"><output id=\"count\"></output></label>\n<button "
        "id=\"play\">draw</button>\n<button id=\"reset\">whole</button>\n<span>drag to turn, wheel "
        "to zoom, shift and drag to move</span>\n</footer>\n<script>\n"
        "// Of each scene its box and its parts: a step, a colour, the width of a stroke or -1 for "
        "a polygon, then points.\n"
        "const scenes = [\n" +
        page.text + "];\nconst colours = [" + page.colours() + "];\nconst background = \"" +
        hex_colour(colour_named(choices.background.value_or("white"))) +
        "\";\nlet view = {azimuth: " + radians(choices.camera.azimuth) +
        ", elevation: " + radians(choices.camera.elevation) +
        ", opening: " + (choices.camera.perspective ? radians(choices.camera.opening) : "0") +
        "};" + page_program + "</script>\n</html>\n";
    write_to(target, [&](Output& output) { output.write(out.data(), out.size()); });
    return page.drawn;
}

}  // namespace algae
