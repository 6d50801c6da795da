#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "exact/exact.hpp"
#include "render/detail/document.hpp"
#include "render/detail/scene_graph.hpp"

// The texts of a scene graph: VRML97 (ISO/IEC 14772-1:1997), VRML 1.0 (Bell, Parisi and Pesce 1995), X3D 3.3 in XML
// (ISO/IEC 19776-1, profile Interchange) and scenes for POV-Ray 3.7. They differ in words, not in what they say: head, viewpoints, light,
// then bodies, surfaces and lines.
//
// Numbers are of single precision in the fewest digits, and 0 has no sign, so that equal scenes make equal files. A colour is
// defined where it is first used and referred to by its name afterwards (but for lines in VRML 1.0). Bodies and surfaces have it as
// the light falls on them, lines as light of their own. The text goes out in pieces of 64 kB, and each piece asks the budget.
//
// Subtle: VRML 1.0 has a state that later shapes inherit, so every shape stands in a Separator with its absolute place; a
// Separator around the movements of a module alone would undo them at its end. Commas count as blanks in VRML97 and in XML. POV-Ray
// smooths nothing by itself, so corners of its surfaces have normals: the mean of the triangles around a point that meet at less than
// the crease. Its lines are thin rods. Its first viewpoint is its camera, given by vectors, which makes its axes right-handed.

namespace algae {

namespace {

/// A number as files of scenes have it: of single precision, in the fewest digits; 0 has no sign.
float single(double x) { return static_cast<float>(x) + 0.0f; }

/// The text of a scene on its way out, in a language that adds bodies, surfaces and lines.
template <class Language>
class SceneText {
public:
    SceneText(const SceneGraph& graph, Output& output, const Budget& budget)
        : graph_(graph),
          filled_(graph.colours.size()),
          drawn_(graph.colours.size()),
          output_(output),
          budget_(budget) {}

protected:
    /// The shapes, and what stands behind them.
    void finish(const char* end) {
        auto& language = static_cast<Language&>(*this);
        for (const SceneGraph::Body& body : graph_.bodies) language.shape(body);
        for (const SceneGraph::Surface& surface : graph_.surfaces) language.shape(surface);
        for (const SceneGraph::Lines& lines : graph_.lines) language.shape(lines);
        add(end);
        flush();
    }
    /// Refers to what defines a colour if it is written already, otherwise writes it.
    void use(std::vector<char>& written, std::uint32_t shade,
             fmt::format_string<std::uint32_t&> used, fmt::format_string<std::uint32_t&> defined,
             std::string_view end) {
        if (written[shade]) return put(used, shade);
        put(defined, shade);
        colour(graph_.colours[shade]);
        add(end);
        written[shade] = true;
    }

    template <class... Parts>
    void put(fmt::format_string<Parts...> pattern, Parts&&... parts) {
        add(fmt::format(pattern, std::forward<Parts>(parts)...));
    }
    void add(std::string_view text) {
        text_ += text;
        if (text_.size() > 1 << 16) flush();
    }
    void vector(const Vector& v) {
        add(fmt::format("{} {} {}", single(v.x), single(v.y), single(v.z)));
    }
    void colour(const Colour& c) { vector({c.red, c.green, c.blue}); }
    void turn(const AxisTurn& turn) {
        vector(turn.axis);
        add(fmt::format(" {}", single(turn.radians)));
    }
    /// Points with commas between.
    void points(const std::vector<Vector>& points) {
        for (const Vector& point : points) {
            vector(point);
            add(", ");
        }
    }
    /// Corners of triangles, -1 after each, with commas, which XML and VRML97 take for blanks.
    void triangles(const std::vector<Mesh::Triangle>& triangles) {
        for (const auto& [a, b, c] : triangles) add(fmt::format("{},{},{},-1, ", a, b, c));
    }
    /// The points of strokes, -1 after each stroke.
    void strokes(const SceneGraph::Lines& lines) {
        std::uint32_t point = 0;
        for (const std::uint32_t count : lines.strokes) {
            for (std::uint32_t i = 0; i < count; ++i) add(fmt::format("{},", point++));
            add("-1, ");
        }
    }
    /// The node of a body, by its shape; patterns take the three parts of its size.
    using Pattern = fmt::format_string<const float&, const float&, const float&>;
    void solid(const SceneGraph::Body& body, Pattern box, Pattern cylinder, Pattern cone,
               Pattern sphere) {
        const float x = single(body.size.x), y = single(body.size.y), z = single(body.size.z);
        const std::array patterns{box, cylinder, cone, sphere};  // as SolidShape has them
        add(fmt::format(patterns[static_cast<std::size_t>(body.shape)], x, y, z));
    }
    void flush() {
        budget_.check();
        output_.write(text_.data(), text_.size());
        text_.clear();
    }

    const SceneGraph& graph_;
    std::vector<char> filled_, drawn_;  // colours that have been written for shapes and for lines

private:
    Output& output_;
    const Budget& budget_;
    std::string text_;
};

/// A string between quotes, with those within it marked.
std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += c;
    }
    return out + '"';
}

class Vrml97 : public SceneText<Vrml97> {
public:
    using SceneText::SceneText;

    void write() {
        put("#VRML V2.0 utf8\nWorldInfo {{ title {} }}\n", quoted(graph_.title));
        put("NavigationInfo {{ type [ \"EXAMINE\", \"ANY\" ] }}\nBackground {{ skyColor [ ");
        colour(graph_.background);
        put(" ] }}\n");
        for (const SceneGraph::Viewpoint& view : graph_.viewpoints) {
            put("Viewpoint {{ description {} fieldOfView {} position ", quoted(view.name),
                single(view.opening));
            vector(view.place);
            put(" orientation ");
            turn(view.turn);
            put(" }}\n");
        }
        put("DirectionalLight {{ intensity 0.6 ambientIntensity 0.3 direction ");
        vector(graph_.light);
        put(" }}\n");
        finish("");
    }

    void shape(const SceneGraph::Body& body) {
        put("Transform {{ translation ");
        vector(body.middle);
        put(" rotation ");
        turn(body.turn);
        put(" children Shape {{ ");
        appearance(body.colour);
        solid(body, "geometry Box {{ size {} {} {} }}",
              "geometry Cylinder {{ radius {} height {} }}",
              "geometry Cone {{ bottomRadius {} height {} }}", "geometry Sphere {{ radius {} }}");
        put(" }} }}\n");
    }
    void shape(const SceneGraph::Surface& surface) {
        put("Shape {{ ");
        appearance(surface.colour);
        put("geometry IndexedFaceSet {{ creaseAngle {} solid {}\n coord Coordinate {{ point [ ",
            single(graph_.crease), surface.sheet ? "FALSE" : "TRUE");
        points(surface.points);
        put("] }}\n coordIndex [ ");
        triangles(surface.triangles);
        put("] }} }}\n");
    }
    void shape(const SceneGraph::Lines& lines) {
        put("Shape {{ appearance ");
        use(drawn_, lines.colour, "USE L{} ",
            "DEF L{} Appearance {{ material Material {{ diffuseColor 0 0 0 emissiveColor ",
            " } } ");
        put("geometry IndexedLineSet {{\n coord Coordinate {{ point [ ");
        points(lines.points);
        put("] }}\n coordIndex [ ");
        strokes(lines);
        put("] }} }}\n");
    }
    void appearance(std::uint32_t shade) {
        use(filled_, shade, "appearance USE C{} ",
            "appearance DEF C{} Appearance {{ material Material {{ diffuseColor ", " } } ");
    }
};

class Vrml1 : public SceneText<Vrml1> {
public:
    using SceneText::SceneText;

    void write() {
        put("#VRML V1.0 ascii\nSeparator {{\nDEF BackgroundColor Info {{ string \"");
        colour(graph_.background);
        put("\" }}\nDirectionalLight {{ direction ");
        vector(graph_.light);
        put(" }}\nDEF Cameras Switch {{ whichChild 0\n");
        std::size_t number = 0;
        for (const SceneGraph::Viewpoint& view : graph_.viewpoints) {
            put("DEF View{} PerspectiveCamera {{ position ", ++number);
            vector(view.place);
            put(" orientation ");
            turn(view.turn);
            put(" focalDistance {} heightAngle {} }}\n", single(view.distance),
                single(view.opening));
        }
        put("}}\n");
        finish("}\n");
    }

    void shape(const SceneGraph::Body& body) {
        put("Separator {{ ");
        material(body.colour);
        put("Translation {{ translation ");
        vector(body.middle);
        put(" }} Rotation {{ rotation ");
        turn(body.turn);
        put(" }} ");
        solid(body, "Cube {{ width {} height {} depth {} }}", "Cylinder {{ radius {} height {} }}",
              "Cone {{ bottomRadius {} height {} }}", "Sphere {{ radius {} }}");
        put(" }}\n");
    }
    void shape(const SceneGraph::Surface& surface) {
        put("Separator {{ ");
        material(surface.colour);
        put("ShapeHints {{ vertexOrdering COUNTERCLOCKWISE shapeType {} faceType CONVEX "
            "creaseAngle {} }}\n"
            " Coordinate3 {{ point [ ",
            surface.sheet ? "UNKNOWN_SHAPE_TYPE" : "SOLID", single(graph_.crease));
        points(surface.points);
        put("] }}\n IndexedFaceSet {{ coordIndex [ ");
        triangles(surface.triangles);
        put("] }} }}\n");
    }
    void shape(const SceneGraph::Lines& lines) {
        put("Separator {{ Material {{ diffuseColor 0 0 0 emissiveColor ");
        colour(graph_.colours[lines.colour]);
        put(" }}\n Coordinate3 {{ point [ ");
        points(lines.points);
        put("] }}\n IndexedLineSet {{ coordIndex [ ");
        strokes(lines);
        put("] }} }}\n");
    }
    void material(std::uint32_t shade) {
        use(filled_, shade, "USE C{} ", "DEF C{} Material {{ diffuseColor ", " } ");
    }
};

class X3d : public SceneText<X3d> {
public:
    using SceneText::SceneText;

    void write() {
        const std::string title = escaped_markup(graph_.title);
        put("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<X3D profile=\"Interchange\" "
            "version=\"3.3\">\n"
            "<head><meta name=\"title\" content=\"{}\"/><meta name=\"generator\" "
            "content=\"algae\"/></head>\n"
            "<Scene>\n<WorldInfo title=\"{}\"/>\n"
            "<NavigationInfo type='\"EXAMINE\" \"ANY\"'/>\n<Background skyColor=\"",
            title, title);
        colour(graph_.background);
        put("\"/>\n");
        for (const SceneGraph::Viewpoint& view : graph_.viewpoints) {
            put("<Viewpoint description=\"{}\" fieldOfView=\"{}\" position=\"",
                escaped_markup(view.name), single(view.opening));
            vector(view.place);
            put("\" orientation=\"");
            turn(view.turn);
            put("\"/>\n");
        }
        put("<DirectionalLight intensity=\"0.6\" ambientIntensity=\"0.3\" direction=\"");
        vector(graph_.light);
        put("\"/>\n");
        finish("</Scene>\n</X3D>\n");
    }

    void shape(const SceneGraph::Body& body) {
        put("<Transform translation=\"");
        vector(body.middle);
        put("\" rotation=\"");
        turn(body.turn);
        put("\"><Shape>");
        appearance(body.colour);
        solid(body, "<Box size=\"{} {} {}\"/>", "<Cylinder radius=\"{}\" height=\"{}\"/>",
              "<Cone bottomRadius=\"{}\" height=\"{}\"/>", "<Sphere radius=\"{}\"/>");
        put("</Shape></Transform>\n");
    }
    void shape(const SceneGraph::Surface& surface) {
        put("<Shape>");
        appearance(surface.colour);
        put("<IndexedFaceSet creaseAngle=\"{}\" solid=\"{}\" coordIndex=\"", single(graph_.crease),
            surface.sheet ? "false" : "true");
        triangles(surface.triangles);
        put("\">\n<Coordinate point=\"");
        points(surface.points);
        put("\"/></IndexedFaceSet></Shape>\n");
    }
    void shape(const SceneGraph::Lines& lines) {
        put("<Shape>");
        use(drawn_, lines.colour, "<Appearance USE=\"L{}\"/>",
            "<Appearance DEF=\"L{}\"><Material diffuseColor=\"0 0 0\" emissiveColor=\"",
            "\"/></Appearance>");
        put("<IndexedLineSet coordIndex=\"");
        strokes(lines);
        put("\">\n<Coordinate point=\"");
        points(lines.points);
        put("\"/></IndexedLineSet></Shape>\n");
    }
    void appearance(std::uint32_t shade) {
        use(filled_, shade, "<Appearance USE=\"C{}\"/>",
            "<Appearance DEF=\"C{}\"><Material diffuseColor=\"", "\"/></Appearance>");
    }
};

/// The normals of the corners of a surface, three for each triangle: of length 1, and smooth where triangles meet at less than the
/// crease.
std::vector<std::array<Vector, 3>> corner_normals(const SceneGraph::Surface& surface,
                                                  double crease) {
    const std::size_t count = surface.triangles.size();
    std::vector<Vector> areas(count);  // across each triangle, as long as twice its area
    std::vector<std::uint32_t> first(surface.points.size() + 1, 0);
    for (std::size_t i = 0; i < count; ++i) {
        const auto& [a, b, c] = surface.triangles[i];
        areas[i] =
            cross(surface.points[b] - surface.points[a], surface.points[c] - surface.points[a]);
        for (const std::uint32_t point : surface.triangles[i]) ++first[point + 1];
    }
    for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
    std::vector<std::uint32_t> around(3 * count), filled(first.begin(), first.end() - 1);
    for (std::uint32_t i = 0; i < count; ++i)
        for (const std::uint32_t point : surface.triangles[i]) around[filled[point]++] = i;
    const double least = std::cos(crease);
    std::vector<std::array<Vector, 3>> normals(count);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t point = surface.triangles[i][k];
            const Vector own = unit(areas[i]);
            Vector sum;
            for (std::uint32_t at = first[point]; at < first[point + 1]; ++at)
                if (dot(unit(areas[around[at]]), own) >= least) sum = sum + areas[around[at]];
            normals[i][k] = length(sum) > 0 ? unit(sum) : length(own) > 0 ? own : Vector{0, 1, 0};
        }
    return normals;
}

class Pov : public SceneText<Pov> {
public:
    Pov(const SceneGraph& graph, Output& output, const Budget& budget)
        : SceneText(graph, output, budget), line_radius_(graph.box.diagonal() / 500) {
        double all = 0;
        std::size_t strokes = 0;
        for (const SceneGraph::Lines& lines : graph.lines) {
            std::size_t at = 0;
            for (const std::uint32_t count : lines.strokes) {
                for (std::uint32_t i = 1; i < count; ++i, ++strokes)
                    all += length(lines.points[at + i] - lines.points[at + i - 1]);
                at += count;
            }
        }
        if (strokes > 0)
            line_radius_ = std::min(line_radius_, all / static_cast<double>(strokes) / 4);
    }

    void write() {
        std::string title = graph_.title;
        for (char& c : title)
            if (static_cast<unsigned char>(c) < 0x20) c = ' ';
        put("// {}\n// For POV-Ray 3.7: povray +W1600 +H1200 +A0.1 +AM2 FILE. It draws soft "
            "shadows, "
            "and "
            "the light of the sky;\n// Declare=Soft=0 leaves them out, Declare=Ground=0 the "
            "ground, and +WT1 makes equal bytes each time.\n#version 3.7;\n#ifndef (Soft) "
            "#declare Soft = 1; #end\n#ifndef (Ground) #declare Ground = {}; #end\n",
            title, graph_.upright ? 1 : 0);
        put("global_settings {{ assumed_gamma 1.0 max_trace_level 8\n  #if (Soft) radiosity {{ "
            "pretrace_start 0.08 pretrace_end 0.01 count 120 nearest_count 8 error_bound 0.5 "
            "recursion_limit 2 brightness 0.7 }} #end\n}}\n"
            "#default {{ finish {{ ambient #if (Soft) 0 #else 0.25 #end diffuse 0.75 }} }}\n"
            "background {{ ");
        paint(graph_.background);
        const SceneGraph::Viewpoint& view = graph_.viewpoints.front();
        put(" }}\ncamera {{\n  location ");
        triple(view.place);
        put("\n  up ");
        triple(turned(view.turn, {0, 1, 0}));
        put("\n  right ");
        triple(turned(view.turn, {1, 0, 0}));
        put(" * image_width / image_height\n  direction ");
        triple(turned(view.turn, {0, 0, -1}));
        put(" * {} * min(1, image_width / image_height)\n}}\n",
            single(0.5 / std::tan(view.opening / 2)));
        const double reach = std::max(graph_.box.diagonal(), 1e-6);
        const Vector low = graph_.box.low, high = graph_.box.high, middle = 0.5 * (low + high);
        const Vector center = graph_.upright ? Vector{middle.x, middle.z, -middle.y} : middle;
        put("light_source {{\n  ");
        triple(center - (8 * reach) * graph_.light);
        put(", rgb 1\n  #if (Soft) area_light <{0}, 0, 0>, <0, 0, {0}>, 9, 9 adaptive 2 circular "
            "orient #end\n}}\n",
            single(2.5 * reach));
        // A ground that fades into what is behind it, so that there is no horizon.
        const double level = low.z - 1e-4 * reach;
        put("#if (Ground) disc {{\n  <{0}, {1}, {2}>, y, {3}\n  pigment {{ spherical scale {3} "
            "translate <{0}, {1}, {2}> color_map {{ [0 ",
            single(center.x), single(level), single(center.z), single(7 * reach));
        paint(graph_.background);
        put(" transmit 1] [0.9 ");
        paint(graph_.background);
        put("] }} }}\n}} #end\n");
        for (std::size_t i = 0; i < graph_.colours.size(); ++i) {
            put("#declare C{} = texture {{ pigment {{ ", i);
            paint(graph_.colours[i]);
            put(" }} finish {{ specular 0.12 roughness 0.06 }} }}\n");
        }
        finish("");
    }

    void shape(const SceneGraph::Body& body) {
        const Vector half = 0.5 * body.size;
        const float radius = single(body.size.x);
        switch (body.shape) {
            case SolidShape::box:
                add("box { ");
                triple(-1.0 * half);
                add(", ");
                triple(half);
                break;
            case SolidShape::cylinder:
                put("cylinder {{ <0, {}, 0>, <0, {}, 0>, {}", single(-half.y), single(half.y),
                    radius);
                break;
            case SolidShape::cone:
                put("cone {{ <0, {}, 0>, {}, <0, {}, 0>, 0", single(-half.y), radius,
                    single(half.y));
                break;
            case SolidShape::sphere:
                put("sphere {{ <0, 0, 0>, {}", radius);
                break;
        }
        put(" matrix <");
        for (const Vector& axis : {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}}) {
            numbers(turned(body.turn, axis));
            add(", ");
        }
        numbers(body.middle);
        put("> texture {{ C{} }} }}\n", body.colour);
    }
    void shape(const SceneGraph::Surface& surface) {
        put("mesh2 {{\n  vertex_vectors {{ {}", surface.points.size());
        for (const Vector& point : surface.points) {
            add(",\n");
            triple(point);
        }
        const auto normals = corner_normals(surface, graph_.crease);
        put(" }}\n  normal_vectors {{ {}", 3 * normals.size());
        for (const auto& corners : normals)
            for (const Vector& normal : corners) {
                add(",\n");
                triple(normal);
            }
        put(" }}\n  face_indices {{ {}", surface.triangles.size());
        for (const auto& [a, b, c] : surface.triangles) put(",\n<{}, {}, {}>", a, b, c);
        put(" }}\n  normal_indices {{ {}", surface.triangles.size());
        for (std::size_t i = 0; i < surface.triangles.size(); ++i)
            put(",\n<{}, {}, {}>", 3 * i, 3 * i + 1, 3 * i + 2);
        put(" }}\n  texture {{ C{} }}\n}}\n", surface.colour);
    }
    void shape(const SceneGraph::Lines& lines) {
        const float radius = single(line_radius_);
        std::size_t at = 0;
        put("union {{\n");
        for (const std::uint32_t count : lines.strokes) {
            for (std::uint32_t i = 0; i < count; ++i, ++at) {
                put("sphere {{ ");
                triple(lines.points[at]);
                put(", {} }}\n", radius);
                // A rod between equal ends would be none.
                if (i == 0 || same_place(lines.points[at - 1], lines.points[at])) continue;
                put("cylinder {{ ");
                triple(lines.points[at - 1]);
                add(", ");
                triple(lines.points[at]);
                put(", {} }}\n", radius);
            }
        }
        put("  texture {{ C{} }}\n}}\n", lines.colour);
    }

private:
    static bool same_place(const Vector& a, const Vector& b) {
        return single(a.x) == single(b.x) && single(a.y) == single(b.y) &&
               single(a.z) == single(b.z);
    }
    /// A vector turned about an axis (Rodrigues).
    static Vector turned(const AxisTurn& turn, const Vector& v) {
        const double cosine = std::cos(turn.radians), sine = std::sin(turn.radians);
        return cosine * v + sine * cross(turn.axis, v) +
               ((1 - cosine) * dot(turn.axis, v)) * turn.axis;
    }
    void numbers(const Vector& v) { put("{}, {}, {}", single(v.x), single(v.y), single(v.z)); }
    void triple(const Vector& v) {
        add("<");
        numbers(v);
        add(">");
    }
    void paint(const Colour& c) {
        put("srgb <{}, {}, {}>", single(c.red), single(c.green), single(c.blue));
    }

    double line_radius_;
};

}  // namespace

void write_vrml97(const SceneGraph& graph, Output& output, const Budget& budget) {
    Vrml97(graph, output, budget).write();
}

void write_vrml1(const SceneGraph& graph, Output& output, const Budget& budget) {
    Vrml1(graph, output, budget).write();
}

void write_x3d(const SceneGraph& graph, Output& output, const Budget& budget) {
    X3d(graph, output, budget).write();
}

void write_pov(const SceneGraph& graph, Output& output, const Budget& budget) {
    Pov(graph, output, budget).write();
}

}  // namespace algae
