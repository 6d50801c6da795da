#include "render/picture.hpp"

#include <ostream>

#include "base/error.hpp"
#include "render/document.hpp"
#include "render/drawing.hpp"
#include "render/output.hpp"
#include "render/plan.hpp"

namespace algae {
namespace {

Drawn draw(std::span<const Plate> plates, Output& output, const Plan& plan, const Budget& budget,
           Progress* progress) {
    Drawn drawn;
    drawn.width = plan.page.width;
    drawn.height = plan.page.height;
    Document document(plan.format, plan.page.width, plan.page.height, plan.background, output,
                      budget);
    double all = 0, done = 0;
    for (const Plate& plate : plates) all += work(*plate.figure);
    all *= 1.1;  // the rest is writing
    for (std::size_t i = 0; i < plates.size(); ++i) {
        if (plan.arrangement == Arrangement::pages && i > 0) document.next_page();
        const double next = done + work(*plates[i].figure);
        const Share share(progress, done / all, next / all);
        draw_plate(document.context(), plan, i, plates[i], budget, share, drawn);
        done = next;
    }
    document.finish();
    if (progress) progress->report(1);
    return drawn;
}

Drawn draw_to_file(std::span<const Plate> plates, const std::string& path, PictureFormat format,
                   Arrangement arrangement, const PictureOptions& options, const Budget& budget,
                   Progress* progress) {
    const Plan decided = plan(plates, format, arrangement, options, budget);
    FileOutput file(path);
    const Drawn drawn = draw(plates, file, decided, budget, progress);
    file.commit();
    return drawn;
}

Drawn draw_to_stream(std::span<const Plate> plates, std::ostream& stream, PictureFormat format,
                     Arrangement arrangement, const PictureOptions& options, const Budget& budget,
                     Progress* progress) {
    const Plan decided = plan(plates, format, arrangement, options, budget);
    StreamOutput output(stream);
    const Drawn drawn = draw(plates, output, decided, budget, progress);
    output.finish();
    return drawn;
}

}  // namespace

const char* format_name(PictureFormat format) {
    switch (format) {
        case PictureFormat::svg:
            return "svg";
        case PictureFormat::pdf:
            return "pdf";
        case PictureFormat::png:
            return "png";
        case PictureFormat::ps:
            return "ps";
        case PictureFormat::eps:
            return "eps";
    }
    return "";
}

PictureFormat picture_format(std::string_view path) {
    const std::size_t slash = path.find_last_of('/'), dot = path.find_last_of('.');
    std::string ending;
    if (dot != std::string_view::npos && (slash == std::string_view::npos || dot > slash))
        ending = path.substr(dot + 1);
    for (char& letter : ending)
        if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    for (const PictureFormat format : {PictureFormat::svg, PictureFormat::pdf, PictureFormat::png,
                                       PictureFormat::ps, PictureFormat::eps})
        if (ending == format_name(format)) return format;
    throw Error("expected a picture file ending in .svg, .pdf, .png, .ps or .eps, found \"" +
                std::string(path) + "\"");
}

Drawn draw_picture(const Plate& plate, const std::string& path, PictureFormat format,
                   const PictureOptions& options, const Budget& budget, Progress* progress) {
    return draw_to_file({&plate, 1}, path, format, Arrangement::one, options, budget, progress);
}

Drawn draw_picture(const Plate& plate, std::ostream& stream, PictureFormat format,
                   const PictureOptions& options, const Budget& budget, Progress* progress) {
    return draw_to_stream({&plate, 1}, stream, format, Arrangement::one, options, budget, progress);
}

Drawn draw_pages(std::span<const Plate> plates, const std::string& path, PictureFormat format,
                 const PictureOptions& options, const Budget& budget, Progress* progress) {
    return draw_to_file(plates, path, format, Arrangement::pages, options, budget, progress);
}

Drawn draw_pages(std::span<const Plate> plates, std::ostream& stream, PictureFormat format,
                 const PictureOptions& options, const Budget& budget, Progress* progress) {
    return draw_to_stream(plates, stream, format, Arrangement::pages, options, budget, progress);
}

Drawn draw_panels(std::span<const Plate> plates, const std::string& path, PictureFormat format,
                  const PictureOptions& options, const Budget& budget, Progress* progress) {
    return draw_to_file(plates, path, format, Arrangement::panels, options, budget, progress);
}

Drawn draw_panels(std::span<const Plate> plates, std::ostream& stream, PictureFormat format,
                  const PictureOptions& options, const Budget& budget, Progress* progress) {
    return draw_to_stream(plates, stream, format, Arrangement::panels, options, budget, progress);
}

}  // namespace algae
