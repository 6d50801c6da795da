#pragma once

#include <iosfwd>
#include <string>

#include "base/budget.hpp"
#include "render/picture.hpp"
#include "turtle/explanation.hpp"

namespace algae {

/// Words with more symbols have no explanation that fits a page.
inline constexpr std::size_t longest_explanation = 60;

/// A page that explains a turtle to students: the way it goes with a number for each step and the
/// turtle at every corner, as it comes (pale) and as it leaves, and a table of the steps beside or
/// below. The turtle stays in the plane. Of the options, width, height, colours and background are
/// looked at; the page is as large as its text needs, scaled to the width or height given.
///
/// Throws Error if the word has more symbols than longest_explanation or leaves the plane, if options
/// are out of range, or if the file cannot be written.
void draw_explanation(const Explanation& explanation, const std::string& title,
                      const std::string& path, PictureFormat format, const PictureOptions& options,
                      const Budget& budget = {});
/// The same to a stream.
void draw_explanation(const Explanation& explanation, const std::string& title,
                      std::ostream& stream, PictureFormat format, const PictureOptions& options,
                      const Budget& budget = {});

}  // namespace algae
