# Embeds the files of figures and systems, so that `algae show koch` works wherever the command runs, those of
# the other generators, for `algae ifs fern`, the claims of the theory, for `algae check theory` and `algae closure`,
# the proofs in Coq that claims name, and the lessons with their exercises. Sets algae_gallery_sources; the files are written at
# build time, again whenever a figure or a claim changes.
function(embed function)  # embed(function file...): writes the definition of algae::function() from the files
  set(seen)
  foreach(file IN LISTS ARGN)
    cmake_path(GET file STEM LAST_ONLY stem)
    if(stem IN_LIST seen AND NOT function MATCHES "^(theory_claims|lesson_code)$")  # those are known by their paths
      message(FATAL_ERROR "two files are named '${stem}' like ${file}; names in the ${function} are file names, so one must change")
    endif()
    list(APPEND seen ${stem})
  endforeach()
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${function}.cpp)
  set(list ${CMAKE_CURRENT_BINARY_DIR}/${function}.txt)
  list(JOIN ARGN "\n" listing)
  file(CONFIGURE OUTPUT ${list} CONTENT "${listing}\n")
  add_custom_command(OUTPUT ${source}
    COMMAND ${CMAKE_COMMAND} -D LIST=${list} -D ROOT=${CMAKE_CURRENT_SOURCE_DIR} -D OUTPUT=${source} -D FUNCTION=${function}
      -P ${CMAKE_CURRENT_SOURCE_DIR}/cmake/write_gallery.cmake
    DEPENDS ${ARGN} ${list} cmake/write_gallery.cmake
    COMMENT "Writing the ${function}" VERBATIM)
  set(algae_gallery_sources ${algae_gallery_sources} ${source} PARENT_SCOPE)
endfunction()

file(GLOB_RECURSE algae_gallery_files CONFIGURE_DEPENDS figures/*.lsys systems/*.lsys)
set(algae_generator_patterns *.ifs *.ca *.walk *.brownian *.terrain *.dla *.particles *.function *.boxes)
list(TRANSFORM algae_generator_patterns PREPEND figures/)
file(GLOB_RECURSE algae_generator_files CONFIGURE_DEPENDS ${algae_generator_patterns})
file(GLOB_RECURSE algae_claim_files CONFIGURE_DEPENDS theory/*.claim)
embed(gallery ${algae_gallery_files})
embed(generator_gallery ${algae_generator_files})
embed(theory_claims ${algae_claim_files})
file(GLOB algae_formal_files CONFIGURE_DEPENDS theory/formal/*.v theory/formal/table.txt)
embed(formal_texts ${algae_formal_files})
file(GLOB algae_lesson_files CONFIGURE_DEPENDS lessons/[0-9]*.md)
file(GLOB algae_exercise_files CONFIGURE_DEPENDS lessons/exercises/*.exercise)
embed(lesson_texts ${algae_lesson_files})
embed(exercise_texts ${algae_exercise_files})

# The files whose regions lessons show as code.
set(algae_shown_files)
foreach(lesson IN LISTS algae_lesson_files)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${lesson})
  file(STRINGS ${lesson} openings REGEX "^```cpp region=")
  foreach(opening IN LISTS openings)
    string(REGEX REPLACE "^```cpp region=([^#]*)#.*$" "${CMAKE_CURRENT_SOURCE_DIR}/\\1" shown "${opening}")
    list(APPEND algae_shown_files ${shown})
  endforeach()
endforeach()
list(REMOVE_DUPLICATES algae_shown_files)
embed(lesson_code ${algae_shown_files})
