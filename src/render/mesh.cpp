#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <assimp/Exporter.hpp>
#include <bit>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <string_view>
#include <system_error>

#include "exact/exact.hpp"
#include "render/detail/document.hpp"
#include "render/detail/palette.hpp"
#include "render/detail/scene_graph.hpp"
#include "render/render.hpp"
#include "system/system.hpp"
#include "watch/watch.hpp"

// Figures in space as files that other programs open: meshes by Assimp (glb, obj, stl), a PLY of our own, and scene
// graphs (scene_writers.cpp).
//
// A scene is prepared completely before a file appears: camera and colours are checked, every paint gets a colour of its own, and the
// bytes of a mesh are made. Triangles are grouped by material and by whether they are sheets, which are seen from both sides; those
// that single precision makes degenerate are left out. More than 256 colours become colours of vertices where a format has them.
// glTF counts colours as light, so they are made linear (IEC 61966-2-1).
//
// Assimp's output is tidied so that equal scenes make equal files whatever its version: the text part of a glb loses the
// version and extensions that are not used, an obj its comments, an stl its head. PLY is written here, because Assimp's (5.2)
// says that colours are bytes and writes numbers of four bytes. Memory is asked of the budget before Assimp starts, by
// what it was measured to take.
//
// An obj has its materials in a file beside it, which is completed first; a pipe has nothing beside it.

namespace algae {

namespace {

constexpr std::array names{"glb", "obj", "ply", "stl", "x3d", "wrl", "vrml1", "pov"};

}  // namespace

std::optional<MeshFormat> mesh_format(std::string_view path) {
    const auto found = format_of(names, path);
    return found ? std::optional(static_cast<MeshFormat>(*found)) : std::nullopt;
}

const char* mesh_format_name(MeshFormat format) { return names[static_cast<std::size_t>(format)]; }

std::string mesh_format_names() {
    std::string all = names[0];
    for (std::size_t i = 1; i < names.size(); ++i)
        all += (i + 1 == names.size() ? " or " : ", ") + std::string(names[i]);
    return all;
}

namespace {

/// The bytes of files.
struct MeshFiles {
    std::string main;
    std::string materials;  // of an obj
};

/// More colours than this become colours of vertices instead of materials, where a format has them.
constexpr std::size_t most_materials = 256;

/// The light that a colour of a screen stands for: glTF counts colours so (IEC 61966-2-1).
double linear(double part) {
    return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
}

aiColor4D painted(const Colour& colour, MeshFormat format) {
    const auto part = [&](double x) {
        return static_cast<float>(format == MeshFormat::glb ? linear(x) : x);
    };
    return {part(colour.red), part(colour.green), part(colour.blue), 1};
}

/// Triangles of one material.
struct Group {
    std::uint32_t paint = 0;
    bool sheet = false;
    std::vector<std::uint32_t> corners;     // of the mesh
    std::vector<Mesh::Triangle> triangles;  // in `corners`
};

aiVector3D placed(const Vector& v, bool upright) {
    const auto x = static_cast<float>(v.x), y = static_cast<float>(v.y),
               z = static_cast<float>(v.z);
    return upright ? aiVector3D(x + 0.0f, z + 0.0f, 0.0f - y)
                   : aiVector3D(x + 0.0f, y + 0.0f, z + 0.0f);
}

/// Triangles by material and by whether they are sheets, without those that single precision makes
/// degenerate.
std::vector<Group> groups_of(const Mesh& mesh, bool by_paint, bool upright) {
    constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    const std::size_t paints = by_paint ? mesh.paints.size() : 1;
    std::vector<Group> groups(2 * paints);
    for (std::size_t i = 0; i < groups.size(); ++i) {
        groups[i].paint = static_cast<std::uint32_t>(i % paints);
        groups[i].sheet = i >= paints;
    }
    std::vector<std::uint32_t> known(mesh.corners.size(), none);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& [a, b, c] = mesh.triangles[i];
        const aiVector3D pa = placed(mesh.place(a), upright), pb = placed(mesh.place(b), upright),
                         pc = placed(mesh.place(c), upright);
        if (pa == pb || pb == pc || pc == pa) continue;
        Group& group =
            groups[(i < mesh.closed ? 0 : paints) + (by_paint ? mesh.corners[a].paint : 0)];
        Mesh::Triangle triangle;
        for (std::size_t k = 0; k < 3; ++k) {
            std::uint32_t& corner = known[mesh.triangles[i][k]];
            if (corner == none) {
                corner = static_cast<std::uint32_t>(group.corners.size());
                group.corners.push_back(mesh.triangles[i][k]);
            }
            triangle[k] = corner;
        }
        group.triangles.push_back(triangle);
    }
    std::erase_if(groups, [](const Group& group) { return group.triangles.empty(); });
    return groups;
}

aiMaterial* material(const Colour& colour, const Group& group, MeshFormat format) {
    auto made = std::make_unique<aiMaterial>();
    const auto part = [](double x) { return std::lround(x * 255); };
    const aiString name(fmt::format("{}-{:02x}{:02x}{:02x}", group.sheet ? "sheet" : "colour",
                                    part(colour.red), part(colour.green), part(colour.blue)));
    const aiColor4D base = painted(colour, format);
    const float metallic = 0, rough = 0.8f;
    const int both_sides = group.sheet ? 1 : 0;
    made->AddProperty(&name, AI_MATKEY_NAME);
    made->AddProperty(&base, 1, AI_MATKEY_COLOR_DIFFUSE);
    made->AddProperty(&base, 1, AI_MATKEY_BASE_COLOR);
    made->AddProperty(&metallic, 1, AI_MATKEY_METALLIC_FACTOR);
    made->AddProperty(&rough, 1, AI_MATKEY_ROUGHNESS_FACTOR);
    made->AddProperty(&both_sides, 1, AI_MATKEY_TWOSIDED);
    return made.release();
}

aiMesh* mesh_of_group(const Mesh& mesh, const Group& group, const std::vector<Colour>& colours,
                      bool coloured, MeshFormat format, bool upright) {
    auto made = std::make_unique<aiMesh>();
    made->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
    made->mNumVertices = static_cast<unsigned>(group.corners.size());
    made->mVertices = new aiVector3D[group.corners.size()];
    made->mNormals = new aiVector3D[group.corners.size()];
    if (coloured) made->mColors[0] = new aiColor4D[group.corners.size()];
    for (std::size_t i = 0; i < group.corners.size(); ++i) {
        const Mesh::Corner& corner = mesh.corners[group.corners[i]];
        made->mVertices[i] = placed(mesh.points[corner.point], upright);
        made->mNormals[i] = placed(corner.normal, upright).Normalize();
        if (coloured) made->mColors[0][i] = painted(colours[corner.paint], format);
    }
    made->mNumFaces = static_cast<unsigned>(group.triangles.size());
    made->mFaces = new aiFace[group.triangles.size()];
    for (std::size_t i = 0; i < group.triangles.size(); ++i) {
        made->mFaces[i].mNumIndices = 3;
        made->mFaces[i].mIndices =
            new unsigned[3]{group.triangles[i][0], group.triangles[i][1], group.triangles[i][2]};
    }
    return made.release();
}

std::unique_ptr<aiScene> scene_of(const Mesh& mesh, const std::vector<Colour>& colours,
                                  MeshFormat format, bool upright, const Budget& budget) {
    const bool materials = format == MeshFormat::obj ||
                           (format == MeshFormat::glb && mesh.paints.size() <= most_materials);
    const bool coloured = format == MeshFormat::glb && !materials;
    const std::vector<Group> groups = groups_of(mesh, materials, upright);
    if (groups.empty())
        throw Error(
            "the mesh is too small for the numbers of its format, which have single precision");
    budget.check();
    auto scene = std::make_unique<aiScene>();
    scene->mRootNode = new aiNode("figure");
    const auto count = static_cast<unsigned>(groups.size());
    scene->mRootNode->mNumMeshes = count;
    scene->mRootNode->mMeshes = new unsigned[count];
    scene->mMeshes = new aiMesh*[count];
    scene->mMaterials = new aiMaterial*[count];
    WorkCount colours_done("colour of the mesh", groups.size());
    for (const Group& group : groups) {
        budget.check();
        ++colours_done;
        const unsigned i = scene->mNumMeshes;
        const Colour colour = materials ? colours[group.paint] : Colour{1, 1, 1};
        scene->mMaterials[i] = material(colour, group, format);
        ++scene->mNumMaterials;
        scene->mMeshes[i] = mesh_of_group(mesh, group, colours, coloured, format, upright);
        ++scene->mNumMeshes;
        scene->mMeshes[i]->mMaterialIndex = scene->mRootNode->mMeshes[i] = i;
        scene->mMeshes[i]->mName = aiString("part" + std::to_string(i + 1));
    }
    return scene;
}

/// What the library takes at most while it writes, and what its input takes, as measured.
std::uint64_t memory_of(const Mesh& mesh, MeshFormat format) {
    const std::uint64_t corners = mesh.corners.size(), triangles = mesh.triangles.size();
    return format == MeshFormat::obj ? 600 * corners + 400 * triangles
                                     : 250 * corners + 300 * triangles;
}

std::uint32_t word_at(const std::string& bytes, std::size_t at) {
    std::uint32_t word = 0;
    for (unsigned i = 4; i-- > 0;) word = word << 8 | static_cast<unsigned char>(bytes[at + i]);
    return word;
}

void put_word(std::string& bytes, std::size_t at, std::size_t word) {
    for (unsigned i = 0; i < 4; ++i) bytes[at + i] = static_cast<char>(word >> 8 * i & 255);
}

/// The text part of a glb says which version of the library wrote it, and that it uses extensions
/// which it does not use.
void tidy_glb(std::string& bytes) {
    constexpr std::size_t header = 12, begin = header + 8;
    if (bytes.size() < begin || word_at(bytes, 0) != 0x46546C67)
        throw Error("cannot write the mesh: no glTF came out");
    const std::size_t old = word_at(bytes, header);
    auto text = nlohmann::ordered_json::parse(
        bytes.begin() + begin, bytes.begin() + static_cast<std::ptrdiff_t>(begin + old));
    text.erase("extensionsUsed");
    text["asset"]["generator"] = "algae";
    std::string written = text.dump();
    written.resize((written.size() + 3) / 4 * 4, ' ');
    bytes.replace(begin, old, written);
    put_word(bytes, 8, bytes.size());
    put_word(bytes, header, written.size());
}

/// Binary PLY. The library's own (5.2) says that colours are bytes and writes numbers of four bytes.
std::string ply(const Mesh& mesh, const std::vector<Colour>& colours, const Budget& budget) {
    const std::vector<Group> groups = groups_of(mesh, false, false);
    std::size_t corners = 0, triangles = 0;
    for (const Group& group : groups) {
        corners += group.corners.size();
        triangles += group.triangles.size();
    }
    std::string bytes = fmt::format(
        "ply\nformat binary_little_endian 1.0\nelement vertex {}\n"
        "property float x\nproperty float y\nproperty float z\n"
        "property float nx\nproperty float ny\nproperty float nz\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\n"
        "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        corners, triangles);
    bytes.reserve(bytes.size() + 27 * corners + 13 * triangles);
    const auto put = [&](std::uint32_t word) {
        bytes.resize(bytes.size() + 4);
        put_word(bytes, bytes.size() - 4, word);
    };
    WorkCount written("corner of the mesh", corners);
    for (const Group& group : groups) {
        budget.check();
        for (const std::uint32_t c : group.corners) {
            ++written;
            const Mesh::Corner& corner = mesh.corners[c];
            for (const Vector& v : {mesh.points[corner.point], corner.normal})
                for (const double part : {v.x, v.y, v.z})
                    put(std::bit_cast<std::uint32_t>(static_cast<float>(part) + 0.0f));
            const Colour& colour = colours[corner.paint];
            for (const double part : {colour.red, colour.green, colour.blue})
                bytes += static_cast<char>(std::lround(part * 255));
        }
    }
    std::uint32_t first = 0;
    for (const Group& group : groups) {
        for (const Mesh::Triangle& triangle : group.triangles) {
            bytes += '\3';
            for (const std::uint32_t corner : triangle) put(first + corner);
        }
        first += static_cast<std::uint32_t>(group.corners.size());
    }
    return bytes;
}

/// Takes away the lines in which the library names itself, and names the file of materials.
void tidy_text(std::string& text, const std::string& materials) {
    const auto erase_line = [&](std::string_view begin) {
        const std::size_t at = text.find(begin);
        if (at < 200) text.erase(at, text.find('\n', at) + 1 - at);
    };
    erase_line("# File produced by");
    erase_line("# (assimp");
    constexpr std::string_view placeholder = "$blobfile.mtl";
    if (const std::size_t at = text.find(placeholder); at < 200)
        text.replace(at, placeholder.size(), materials);
}

/// A mesh as a file of glb, obj, ply or stl. `colours` has one for each of the mesh's paints. `name`
/// is that of the file of materials of an obj; empty: there is none. `upright`: z is up and becomes y
/// in formats that say that y is up.
///
/// Throws Error if the library that writes them fails, BoundReached if it needs more memory than the
/// budget has.
MeshFiles mesh_files(const Mesh& mesh, const std::vector<Colour>& colours, MeshFormat format,
                     const std::string& name, bool upright, const Budget& budget) {
    budget.check_memory(memory_of(mesh, format), "writing the mesh");
    MeshFiles files;
    if (format == MeshFormat::ply) {
        files.main = ply(mesh, colours, budget);
        return files;
    }
    const bool y_is_up = format == MeshFormat::glb || format == MeshFormat::obj;
    const auto scene = scene_of(mesh, colours, format, upright && y_is_up, budget);
    const char* id = format == MeshFormat::glb   ? "glb2"
                     : format == MeshFormat::stl ? "stlb"
                     : name.empty()              ? "objnomtl"
                                                 : "obj";
    WorkCount writing("triangles being written");
    writing.at(mesh.triangles.size());
    Assimp::Exporter exporter;
    const aiExportDataBlob* blob = exporter.ExportToBlob(scene.get(), id);
    if (!blob) throw Error(std::string("cannot write the mesh: ") + exporter.GetErrorString());
    files.main.assign(static_cast<const char*>(blob->data), blob->size);
    if (blob->next)
        files.materials.assign(static_cast<const char*>(blob->next->data), blob->next->size);
    if (format == MeshFormat::glb) tidy_glb(files.main);
    if (format == MeshFormat::obj) tidy_text(files.main, name);
    tidy_text(files.materials, name);
    if (format == MeshFormat::stl) std::fill_n(files.main.begin(), 80, ' ');
    return files;
}

/// What has no colour: light does not show the shape of black things.
const std::vector<std::string> uncoloured{"gray"};

/// The scene with a colour of its own in each paint.
Scene coloured(Scene scene, const std::vector<std::string>& colours) {
    const auto& own = scene.colours.empty() ? uncoloured : scene.colours;
    const Palette palette(colours.empty() ? own : colours, 360);
    const auto give = [&](Paint& paint, std::size_t number, std::size_t count) {
        if (paint.colour) return;
        const double position = static_cast<double>(number) / static_cast<double>(count);
        paint = {0, palette.colour(palette.shade(paint.index, position))};
    };
    for (std::size_t i = 0; i < scene.rods.size(); ++i)
        give(scene.rods[i].paint, i, scene.rods.size());
    for (std::size_t i = 0; i < scene.faces.size(); ++i)
        give(scene.faces[i].paint, i, scene.faces.size());
    for (std::size_t i = 0; i < scene.solids.size(); ++i)
        give(scene.solids[i].paint, i, scene.solids.size());
    return scene;
}

bool is_scene_graph(MeshFormat format) { return format >= MeshFormat::x3d; }

/// A scene ready to be written.
class Prepared {
public:
    Prepared(const Scene& scene, MeshFormat format, const MeshChoices& choices,
             const std::string& materials, const Budget& budget)
        : format_(format), budget_(budget) {
        check_camera(choices.camera);
        const Colour background =
            background_of(choices.background, PictureFormat::png).value_or(Colour{1, 1, 1});
        const Scene painted = coloured(scene, choices.colours);
        if (is_scene_graph(format)) {
            graph_ = scene_graph(painted, choices.mesh, choices.camera, choices.light, budget);
            graph_.background = background;
            if (graph_.box.empty) throw Error(scene.name + " draws nothing");
            drawn = {graph_.vertices, graph_.triangles, graph_.bodies.size(), graph_.strokes,
                     graph_.box};
            return;
        }
        const Mesh mesh = mesh_of(painted, choices.mesh, budget);
        std::vector<Colour> colours;
        for (const Paint& paint : mesh.paints) colours.push_back(paint.colour.value_or(Colour{}));
        drawn = {mesh.corners.size(), mesh.triangles.size(), 0, 0, box_of(mesh)};
        files = mesh_files(mesh, colours, format, materials, is_in_space(box_of(scene)), budget);
    }
    void write(Output& output) const {
        if (format_ == MeshFormat::x3d)
            write_x3d(graph_, output, budget_);
        else if (format_ == MeshFormat::wrl)
            write_vrml97(graph_, output, budget_);
        else if (format_ == MeshFormat::vrml1)
            write_vrml1(graph_, output, budget_);
        else if (format_ == MeshFormat::pov)
            write_pov(graph_, output, budget_);
        else
            output.write(files.main.data(), files.main.size());
    }

    MeshDrawn drawn;
    MeshFiles files;

private:
    MeshFormat format_;
    const Budget& budget_;
    SceneGraph graph_;
};

}  // namespace

MeshDrawn draw_mesh(const Scene& scene, const Target& target, MeshFormat format,
                    const MeshChoices& choices, const Budget& budget) {
    // A pipe has nothing beside it.
    std::error_code ignored;
    const auto status = std::filesystem::status(target.path, ignored);
    const bool with_materials =
        !target.stream && format == MeshFormat::obj && (!exists(status) || is_regular_file(status));
    const std::filesystem::path beside =
        std::filesystem::path(target.path).replace_extension(".mtl");
    if (with_materials && beside == target.path)
        throw Error("cannot write " + target.path +
                    ": the materials of an obj go to a file of that name; expected another end, "
                    "such as .obj");
    const Prepared prepared(scene, format, choices,
                            with_materials ? beside.filename().string() : std::string(), budget);
    write_to(target, [&](Output& output) {
        prepared.write(output);
        if (!with_materials) return;
        FileOutput materials(beside.string());
        materials.write(prepared.files.materials.data(), prepared.files.materials.size());
        materials.commit();
    });
    return prepared.drawn;
}

}  // namespace algae
