#include "render/mesh_output.hpp"

#include <filesystem>
#include <system_error>

#include "base/error.hpp"
#include "render/mesh_export.hpp"
#include "render/output.hpp"
#include "render/palette.hpp"
#include "render/scene_graph.hpp"
#include "render/vrml.hpp"
#include "render/x3d.hpp"
#include "system/colour.hpp"

namespace algae {

namespace {

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

bool is_scene_graph(MeshFormat format) {
    return format == MeshFormat::x3d || format == MeshFormat::wrl || format == MeshFormat::vrml1;
}

/// A scene ready to be written.
class Prepared {
public:
    Prepared(const Scene& scene, MeshFormat format, const MeshChoices& choices,
             const std::string& materials, const Budget& budget)
        : format_(format), budget_(budget) {
        check_camera(choices.camera);
        const std::string behind = choices.background.value_or("transparent");
        const Colour background = behind == "transparent" ? Colour{1, 1, 1} : colour_named(behind);
        const Scene painted = coloured(scene, choices.colours);
        if (is_scene_graph(format)) {
            graph_ = scene_graph(painted, choices.mesh, choices.camera, budget);
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

MeshDrawn draw_mesh(const Scene& scene, const std::string& path, MeshFormat format,
                    const MeshChoices& choices, const Budget& budget) {
    // A pipe has nothing beside it.
    std::error_code ignored;
    const auto status = std::filesystem::status(path, ignored);
    const bool with_materials =
        format == MeshFormat::obj && (!exists(status) || is_regular_file(status));
    const std::filesystem::path beside = std::filesystem::path(path).replace_extension(".mtl");
    if (with_materials && beside == path)
        throw Error("cannot write " + path +
                    ": the materials of an obj go to a file of that name; expected another end, "
                    "such as .obj");
    const Prepared prepared(scene, format, choices,
                            with_materials ? beside.filename().string() : std::string(), budget);
    FileOutput output(path);
    prepared.write(output);
    if (with_materials) {
        FileOutput materials(beside.string());
        materials.write(prepared.files.materials.data(), prepared.files.materials.size());
        materials.commit();
    }
    output.commit();
    return prepared.drawn;
}

MeshDrawn draw_mesh(const Scene& scene, std::ostream& stream, MeshFormat format,
                    const MeshChoices& choices, const Budget& budget) {
    const Prepared prepared(scene, format, choices, "", budget);
    StreamOutput output(stream);
    prepared.write(output);
    output.finish();
    return prepared.drawn;
}

}  // namespace algae
