#pragma once

#include <span>
#include <string_view>

namespace algae {

/// One of the figures and systems that come with algae, as its file stands.
struct GalleryEntry {
    std::string_view name;  ///< the file's name without its end, by which the command line knows it
    std::string_view path;  ///< from the root of the repository, as `figures/002/koch.lsys`
    std::string_view text;  ///< the file, to be read by the notation
};

/// All figures and systems that come with algae, in order of their names; no two names are equal.
/// Built into the library, so nothing is read from disk.
std::span<const GalleryEntry> gallery();

/// The files of the other generators that come with algae, `fern.ifs`, `glider.ca`, likewise. A system
/// of `gallery()` may have the same name.
std::span<const GalleryEntry> relative_gallery();

/// The claims of the theory that come with algae, `theory/closure/union-not-0l.claim`. Two may have the
/// same name in different folders.
std::span<const GalleryEntry> theory_claims();

/// The lessons that come with algae, in their order, and their exercises, named as `03-2`.
std::span<const GalleryEntry> lesson_texts();
std::span<const GalleryEntry> exercise_texts();

/// The files of algae's own code that lessons show regions of.
std::span<const GalleryEntry> lesson_code();

}  // namespace algae
