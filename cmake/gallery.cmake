# Embeds the files of figures and systems, so that `algae show koch` works wherever the command runs.
# Sets algae_gallery_source; the file is written at build time, again whenever a figure changes.
file(GLOB_RECURSE algae_gallery_files CONFIGURE_DEPENDS figures/*.lsys systems/*.lsys)

set(seen)
foreach(figure IN LISTS algae_gallery_files)
  cmake_path(GET figure STEM LAST_ONLY stem)
  if(stem IN_LIST seen)
    message(FATAL_ERROR "figures, systems: two files are named '${stem}.lsys'; names in the gallery are file names, so one must change")
  endif()
  list(APPEND seen ${stem})
endforeach()

set(algae_gallery_source ${CMAKE_CURRENT_BINARY_DIR}/gallery.cpp)
set(algae_gallery_list ${CMAKE_CURRENT_BINARY_DIR}/gallery.txt)
list(JOIN algae_gallery_files "\n" listing)
file(CONFIGURE OUTPUT ${algae_gallery_list} CONTENT "${listing}\n")
add_custom_command(OUTPUT ${algae_gallery_source}
  COMMAND ${CMAKE_COMMAND} -D LIST=${algae_gallery_list} -D ROOT=${CMAKE_CURRENT_SOURCE_DIR} -D OUTPUT=${algae_gallery_source}
    -P ${CMAKE_CURRENT_SOURCE_DIR}/cmake/write_gallery.cmake
  DEPENDS ${algae_gallery_files} ${algae_gallery_list} cmake/write_gallery.cmake
  COMMENT "Writing the gallery" VERBATIM)
