#include <algorithm>
#include <cmath>
#include <map>

#include "render/detail/document.hpp"
#include "render/detail/figure_text.hpp"

// Figures as data: tables (CSV, RFC 4180), GeoJSON (RFC 7946) and DXF (AutoCAD, release 12), in the units of the figure.
//
// Coordinates are the nearest doubles, in the fewest digits that read back as these. Where the figure is exact, the numbers themselves
// stand beside them, `3*sqrt(3)/2`, as programs of algebra read them. A stroke has the letter of the word that draws it and its place
// there, counted from 0; for a plotter there is neither, as segments are in another order.
//
// DXF knows 255 colours by number. Those from 10 to 249 are hues 15 degrees apart, each in five values, full and pale: the number nearest
// to a colour is taken, and 7, which is black on paper and white on a screen, for black and white. Layers have the name of the
// colour, and of the figure where there are several.

namespace algae {

namespace {

/// A field of a table: in quotation marks where it needs them.
std::string csv_field(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"') out += '"';
        out += c;
    }
    return out + '"';
}

std::string json_string(std::string_view text) {
    static constexpr char digits[] = "0123456789abcdef";
    std::string out = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\')
            (out += '\\') += c;
        else if (byte < 0x20)
            ((out += "\\u00") += digits[byte / 16]) += digits[byte % 16];
        else
            out += c;
    }
    return out + '"';
}

/// Zero without a sign.
std::string coordinate(double value) { return shortest_decimal(value == 0 ? 0.0 : value); }

/// "generation 3 of koch" of one figure among several.
std::string name_of(const PlacedFigure& figure) { return figure.source->plate.name; }

}  // namespace

std::string csv_text(const FigureDocument& document, FigureTextDrawn& drawn) {
    std::vector<ExactPoints> exact;
    for (const PlacedFigure& figure : document.figures) exact.emplace_back(*figure.source);
    drawn.exact = std::ranges::any_of(exact, &ExactPoints::known);
    const bool many = document.figures.size() > 1;
    std::string out = many ? "figure," : "";
    out += "path,kind,letter,position,colour,width,x1,y1,x2,y2,length";
    if (drawn.exact) out += ",exact_x1,exact_y1,exact_x2,exact_y2";
    out += "\r\n";
    for (std::size_t f = 0; f < document.figures.size(); ++f) {
        const PlacedFigure& figure = document.figures[f];
        const std::string name = many ? csv_field(name_of(figure)) + "," : "";
        for (std::size_t p = 0; p < figure.paths.paths.size(); ++p) {
            const FigurePath& path = figure.paths.paths[p];
            const PathStyle& style = figure.paths.styles[path.style];
            const std::size_t count = path.points.size();
            const std::string colour = hex_colour(style.colour) + "," + coordinate(style.width);
            // The sides of a polygon are rows too, the last one back to its start.
            for (std::size_t i = 0; i + (path.filled ? 0 : 1) < count; ++i) {
                const Point from = path.points[i], to = path.points[(i + 1) % count];
                const std::size_t at = path.filled ? 0 : i;
                out += name + std::to_string(p + 1) + (path.filled ? ",side," : ",stroke,") +
                       csv_field(style.letter) + ",";
                if (at < path.positions.size() && figure.source->modules > 0)
                    out += std::to_string(path.positions[at]);
                out += "," + colour + "," + coordinate(from.x) + "," + coordinate(from.y) + "," +
                       coordinate(to.x) + "," + coordinate(to.y) + "," +
                       coordinate(distance(from, to));
                if (drawn.exact) {
                    const auto& [x1, y1] = exact[f].at(from);
                    const auto& [x2, y2] = exact[f].at(to);
                    out += "," + x1 + "," + y1 + "," + x2 + "," + y2;
                }
                out += "\r\n";
            }
        }
    }
    return out;
}

std::string geojson_text(const FigureDocument& document, FigureTextDrawn& drawn) {
    std::string out = "{\"type\": \"FeatureCollection\", \"name\": " + json_string(document.head) +
                      ", \"features\": [";
    bool first = true;
    for (const PlacedFigure& figure : document.figures) {
        const ExactPoints exact(*figure.source);
        drawn.exact = drawn.exact || exact.known();
        for (std::size_t p = 0; p < figure.paths.paths.size(); ++p) {
            const FigurePath& path = figure.paths.paths[p];
            const PathStyle& style = figure.paths.styles[path.style];
            std::vector<Point> points = path.points;
            if (path.filled) {
                if (points.size() < 3) continue;
                points.push_back(points.front());  // rings are closed
                double area = 0;
                for (std::size_t i = 0; i + 1 < points.size(); ++i)
                    area += points[i].x * points[i + 1].y - points[i + 1].x * points[i].y;
                if (area < 0) std::ranges::reverse(points);  // and go counter-clockwise
            }
            double length = 0;
            for (std::size_t i = 0; i + 1 < points.size(); ++i)
                length += distance(points[i], points[i + 1]);
            out += first ? "\n" : ",\n";
            first = false;
            out += "{\"type\": \"Feature\", \"id\": " + std::to_string(p + 1) +
                   ", \"properties\": {\"figure\": " + json_string(name_of(figure)) +
                   ", \"colour\": \"" + hex_colour(style.colour) +
                   "\", \"width\": " + coordinate(style.width);
            if (!style.letter.empty()) out += ", \"letter\": " + json_string(style.letter);
            if (figure.source->modules > 0 && !path.positions.empty())
                out += ", \"position\": " + std::to_string(path.positions.front()) +
                       ", \"last\": " + std::to_string(path.positions.back());
            out += ", \"length\": " + coordinate(length);
            if (exact.known()) {
                out += ", \"exact\": [";
                for (std::size_t i = 0; i < points.size(); ++i) {
                    const auto& [x, y] = exact.at(points[i]);
                    out += (i > 0 ? ", [" : "[") + json_string(x) + ", " + json_string(y) + "]";
                }
                out += "]";
            }
            out += std::string("}, \"geometry\": {\"type\": \"") +
                   (path.filled ? "Polygon" : "LineString") +
                   "\", \"coordinates\": " + (path.filled ? "[[" : "[");
            for (std::size_t i = 0; i < points.size(); ++i)
                out += (i > 0 ? ", [" : "[") + coordinate(points[i].x) + ", " +
                       coordinate(points[i].y) + "]";
            out += path.filled ? "]]}}" : "]}}";
        }
    }
    return out + "\n]}\n";
}

// --- DXF ---

namespace {

/// The number of the nearest colour.
int dxf_colour(const Colour& colour) {
    struct Entry {
        int number;
        Colour colour;
    };
    static const std::vector<Entry> table = [] {
        std::vector<Entry> all{{7, {0, 0, 0}},         {7, {1, 1, 1}}, {1, {1, 0, 0}},
                               {2, {1, 1, 0}},         {3, {0, 1, 0}}, {4, {0, 1, 1}},
                               {5, {0, 0, 1}},         {6, {1, 0, 1}}, {8, {0.5, 0.5, 0.5}},
                               {9, {0.75, 0.75, 0.75}}};
        constexpr double values[] = {1, 0.65, 0.5, 0.3, 0.15};
        for (int h = 0; h < 24; ++h)
            for (int v = 0; v < 5; ++v)
                for (int pale = 0; pale < 2; ++pale) {
                    const Colour full = hue(15.0 * h);
                    const auto mixed = [&](double part) {
                        return values[v] * (pale ? (1 + part) / 2 : part);
                    };
                    all.push_back({10 + 10 * h + 2 * v + pale,
                                   {mixed(full.red), mixed(full.green), mixed(full.blue)}});
                }
        return all;
    }();
    const auto far = [&](const Entry& entry) {
        const double red = entry.colour.red - colour.red, green = entry.colour.green - colour.green,
                     blue = entry.colour.blue - colour.blue;
        return red * red + green * green + blue * blue;
    };
    return std::ranges::min_element(table, {}, far)->number;
}

/// A code and its value, each on a line.
void put(std::string& out, int code, const std::string& value) {
    out += std::to_string(code) + "\n" + value + "\n";
}

}  // namespace

std::string dxf_text(const FigureDocument& document) {
    const bool many = document.figures.size() > 1;
    const auto layer_of = [&](std::size_t figure, const PathStyle& style) {
        std::string name = hex_colour(style.colour).substr(1);
        std::ranges::transform(name, name.begin(), [](char c) {
            return c >= 'a' ? static_cast<char>(c - 'a' + 'A') : c;
        });
        return (many ? "FIGURE_" + std::to_string(figure + 1) + "_" : std::string()) + "COLOUR_" +
               name;
    };
    std::map<std::string, int> layers;
    Box box;
    for (std::size_t f = 0; f < document.figures.size(); ++f) {
        box.add(document.figures[f].source->plate.figure->box());
        for (const PathStyle& style : document.figures[f].paths.styles)
            layers[layer_of(f, style)] = dxf_colour(style.colour);
    }
    std::string out;
    put(out, 999, document.head.substr(0, 200));
    put(out, 0, "SECTION");
    put(out, 2, "HEADER");
    put(out, 9, "$ACADVER");
    put(out, 1, "AC1009");
    const auto corner = [&](const char* name, Point point) {
        put(out, 9, name);
        put(out, 10, coordinate(point.x));
        put(out, 20, coordinate(point.y));
        put(out, 30, "0.0");
    };
    corner("$EXTMIN", box.low);
    corner("$EXTMAX", box.high);
    put(out, 0, "ENDSEC");
    put(out, 0, "SECTION");
    put(out, 2, "TABLES");
    put(out, 0, "TABLE");
    put(out, 2, "LTYPE");
    put(out, 70, "1");
    put(out, 0, "LTYPE");
    put(out, 2, "CONTINUOUS");
    put(out, 70, "64");
    put(out, 3, "Solid line");
    put(out, 72, "65");
    put(out, 73, "0");
    put(out, 40, "0.0");
    put(out, 0, "ENDTAB");
    put(out, 0, "TABLE");
    put(out, 2, "LAYER");
    put(out, 70, std::to_string(layers.size()));
    for (const auto& [name, number] : layers) {
        put(out, 0, "LAYER");
        put(out, 2, name);
        put(out, 70, "64");
        put(out, 62, std::to_string(number));
        put(out, 6, "CONTINUOUS");
    }
    put(out, 0, "ENDTAB");
    put(out, 0, "ENDSEC");
    put(out, 0, "SECTION");
    put(out, 2, "ENTITIES");
    for (std::size_t f = 0; f < document.figures.size(); ++f)
        for (const FigurePath& path : document.figures[f].paths.paths) {
            const std::string layer = layer_of(f, document.figures[f].paths.styles[path.style]);
            const auto point = [&](int code, Point at) {
                put(out, code, coordinate(at.x));
                put(out, code + 10, coordinate(at.y));
                put(out, code + 20, "0.0");
            };
            if (!path.filled && path.points.size() == 2) {
                put(out, 0, "LINE");
                put(out, 8, layer);
                point(10, path.points[0]);
                point(11, path.points[1]);
                continue;
            }
            put(out, 0, "POLYLINE");
            put(out, 8, layer);
            put(out, 66, "1");
            point(10, {0, 0});
            const bool closed = path.filled || path.points.front() == path.points.back();
            put(out, 70, closed ? "1" : "0");
            const std::size_t count = path.points.size() - (closed && !path.filled ? 1 : 0);
            for (std::size_t i = 0; i < count; ++i) {
                put(out, 0, "VERTEX");
                put(out, 8, layer);
                point(10, path.points[i]);
            }
            put(out, 0, "SEQEND");
            put(out, 8, layer);
        }
    put(out, 0, "ENDSEC");
    put(out, 0, "EOF");
    return out;
}

}  // namespace algae
