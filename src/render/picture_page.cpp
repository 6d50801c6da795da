#include <fmt/format.h>

#include "render/detail/document.hpp"
#include "render/render.hpp"

// A page of pictures as HTML, as `algae figures` makes one of a gallery. It needs nothing but the pictures beside it: the style stands
// in the page, and there is no script. All text of files is escaped; in links, what browsers would take for something else is
// encoded first. Groups stand in their order, under the headings that the links at the top lead to.

namespace algae {

namespace {

constexpr const char* style = R"(
body { margin: 0 auto; padding: 1.5rem; max-width: 80rem; color: #1c1c1c; background: #fdfdfb;
       font: .95rem/1.45 "Helvetica Neue", "DejaVu Sans", Arial, sans-serif; }
h1 { font-size: 1.7rem; margin: 0 0 .4rem; }
h2 { font-size: 1.2rem; margin: 2.2rem 0 .8rem; border-top: 1px solid #ddd; padding-top: .8rem; }
a { color: #0b5a8a; }
.pictures { display: grid; grid-template-columns: repeat(auto-fill, minmax(15rem, 1fr)); gap: 1rem; }
figure { margin: 0; padding: .7rem; background: white; border: 1px solid #e3e1d6; border-radius: 4px; min-width: 0; }
figure > a { display: flex; height: 13rem; align-items: center; justify-content: center; }
figure img { max-width: 100%; max-height: 13rem; }
figcaption { margin-top: .5rem; }
figcaption strong { display: block; }
figcaption span { color: #666; font-size: .85rem; }
details { margin-top: .3rem; font-size: .85rem; }
.problem { color: #a4000f; font-size: .85rem; white-space: pre-wrap; margin: .4rem 0; }
summary { cursor: pointer; color: #0b5a8a; }
pre { overflow-x: auto; background: #f5f4ee; padding: .5rem; font: .72rem/1.4 "DejaVu Sans Mono", Menlo, monospace; }
@media (prefers-color-scheme: dark) {
body { color: #e4e4e0; background: #15171a; }
h2 { border-color: #3a3d42; }
a, summary { color: #7cc0ee; }
figure { background: #1e2125; border-color: #33363b; }
figure img { background: white; }
figcaption span { color: #a5a8ad; }
.problem { color: #ff8a94; }
pre { background: #282b30; }
}
)";

/// A path as a link has it: what browsers would take for something else is encoded.
std::string link(const std::string& path) {
    std::string out;
    for (const char c : path) {
        if (c == '%' || c == '#' || c == '?' || c == ' ' || c == '"' || c == '<' || c == '>' ||
            c == '\\')
            out += fmt::format("%{:02X}", static_cast<unsigned char>(c));
        else
            out += c;
    }
    return escaped_markup(out);
}

std::string ending(const std::string& path) { return path.substr(path.find_last_of('.') + 1); }

std::string entry(const PagePicture& picture) {
    const std::string name = escaped_markup(picture.name);
    std::string out = "<figure>\n";
    if (!picture.preview.empty())
        out += fmt::format("<a href=\"{}\"><img src=\"{}\" alt=\"{}\" loading=\"lazy\"></a>\n",
                           link(picture.files.empty() ? picture.preview : picture.files.front()),
                           link(picture.preview), name);
    out += fmt::format("<figcaption><strong>{}</strong><span>{}",
                       picture.title.empty() ? name : escaped_markup(picture.title), name);
    if (!picture.source.empty()) out += " · " + escaped_markup(picture.source);
    for (const std::string& file : picture.files)
        out += fmt::format(" · <a href=\"{}\">{}</a>", link(file), escaped_markup(ending(file)));
    out += "</span></figcaption>\n";
    for (const std::string& problem : picture.problems)
        out += fmt::format("<p class=\"problem\">{}</p>\n", escaped_markup(problem));
    return out + fmt::format("<details><summary>file</summary><pre>{}</pre></details>\n</figure>\n",
                             escaped_markup(picture.text));
}

}  // namespace

std::string picture_page(const std::string& title, const std::vector<PagePicture>& pictures) {
    std::string contents, body;
    std::size_t groups = 0;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const std::string& group = pictures[i].group;
        if (i == 0 || group != pictures[i - 1].group) {
            ++groups;
            body += fmt::format("{}<h2 id=\"group-{}\">{}</h2>\n<div class=\"pictures\">\n",
                                i == 0 ? "" : "</div>\n", groups, escaped_markup(group));
            contents += fmt::format("{}<a href=\"#group-{}\">{}</a>", groups == 1 ? "" : " · ",
                                    groups, escaped_markup(group));
        }
        body += entry(pictures[i]);
    }
    if (!pictures.empty()) body += "</div>\n";
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>{0}</title>\n<style>{1}</style>\n</head>\n<body>\n<h1>{0}</h1>\n<p>{2}</p>\n{3}"
        "</body>\n</html>\n",
        escaped_markup(title), style, groups > 1 ? contents : "", body);
}

}  // namespace algae
