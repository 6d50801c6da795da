#pragma once

#include <string>
#include <vector>

namespace algae {

/// One picture of a page. Paths are relative to the page.
struct PagePicture {
    std::string group;          // pictures of a group stand together, under its name; may be empty
    std::string name;           // what the figure is called
    std::string title, source;  // may be empty
    std::string preview;        // a small picture that browsers show; empty if it is not drawn
    std::vector<std::string> files;     // the picture in its formats
    std::string text;                   // the file that it is made from
    std::vector<std::string> problems;  // what is wrong with it
};

/// A page of pictures as HTML that needs nothing but the pictures: groups in their order with a list
/// of them at the top, under each picture its title, its source, links to its files, what is wrong with
/// it and, to be unfolded, the text that it is made from.
///
/// Example: picture_page("Figures", {}).starts_with("<!DOCTYPE html>")
std::string picture_page(const std::string& title, const std::vector<PagePicture>& pictures);

}  // namespace algae
