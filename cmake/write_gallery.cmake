# cmake -D LIST=file-of-paths -D ROOT=folder -D OUTPUT=gallery.cpp -D FUNCTION=gallery -P write_gallery.cmake
# Writes the definition of algae::FUNCTION(), each text as an array of bytes.
file(STRINGS ${LIST} files ENCODING UTF-8)
set(sortable)
foreach(file IN LISTS files)
  cmake_path(GET file STEM LAST_ONLY stem)
  list(APPEND sortable "${stem}\t${file}")  # a tab sorts before every character of a name
endforeach()
list(SORT sortable COMPARE STRING)

set(texts "")
set(entries "")
set(count 0)
foreach(line IN LISTS sortable)
  string(REGEX MATCH "^([^\t]*)\t(.*)$" matched "${line}")
  set(stem "${CMAKE_MATCH_1}")
  set(file "${CMAKE_MATCH_2}")
  cmake_path(RELATIVE_PATH file BASE_DIRECTORY ${ROOT} OUTPUT_VARIABLE path)
  file(READ ${file} bytes HEX)
  string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
  string(REGEX REPLACE "(................................................................................)" "\\1\n    " bytes "${bytes}")
  string(APPEND texts "const unsigned char text_${count}[] = {\n    ${bytes}0};\n")
  string(APPEND entries "    {\"${stem}\", \"${path}\", view(text_${count})},\n")
  math(EXPR count "${count} + 1")
endforeach()

file(WRITE ${OUTPUT} "// Written by cmake/write_gallery.cmake from files of the project.
#include \"notation/notation.hpp\"

#include <array>
#include <cstddef>

namespace {

template <std::size_t size>
[[maybe_unused]] std::string_view view(const unsigned char (&text)[size]) {
    return {reinterpret_cast<const char*>(text), size - 1};
}

${texts}
const std::array<algae::GalleryEntry, ${count}> entries{{
${entries}}};

}  // namespace

namespace algae {

std::span<const GalleryEntry> ${FUNCTION}() { return entries; }

}  // namespace algae
")
