#include "render/mesh_export.hpp"

#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Exporter.hpp>
#include <bit>
#include <cmath>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <string_view>

#include "base/error.hpp"

namespace algae {

namespace {

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
        for (int k = 0; k < 3; ++k) {
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
    for (const Group& group : groups) {
        budget.check();
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
    for (const Group& group : groups) {
        budget.check();
        for (const std::uint32_t c : group.corners) {
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

}  // namespace

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

}  // namespace algae
