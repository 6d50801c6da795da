#include "notation/boxes_file.hpp"

#include "nature/box_cover.hpp"
#include "notation/relative_values.hpp"

namespace algae {

namespace {

std::unique_ptr<Relative> make(const RelativeFile& file) {
    auto cover = std::make_unique<BoxCover>();
    file.describe(*cover);
    const std::string shape =
        file.choice("set", {"segment", "square", "koch", "coast"}).value_or("koch");
    cover->shape = shape == "segment"  ? BoxCover::Shape::segment
                   : shape == "square" ? BoxCover::Shape::square
                   : shape == "koch"   ? BoxCover::Shape::koch
                                       : BoxCover::Shape::coast;
    if (const RelativeStatement* cells = file.find("cells")) {
        cover->cells.clear();
        for (const RelativeWord& word : cells->words)
            cover->cells.push_back(file.number(*cells, word, 1.0 / 4096, 1));
    }
    cover->plot = file.choice("show", {"boxes", "plot"}).value_or("boxes") == "plot";
    cover->turned = file.choice("squares", {"grid", "turned"}).value_or("grid") == "turned";
    cover->seed = seed_value(file);
    cover->check();
    return cover;
}

}  // namespace

RelativeKind boxes_kind() {
    return {"boxes",
            "a set covered with squares",
            {{"set", "segment|square|koch|coast"},
             {"cells", "SIDE ..."},
             {"show", "boxes|plot"},
             {"squares", "grid|turned"},
             {"seed", "S"}},
            make};
}

}  // namespace algae
