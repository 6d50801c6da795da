# The faces of the rooms as they are installed: src/growth/growth.hpp is <algae/growth.hpp>, and faces include each
# other so. Nothing else of a room is installed but what a template in a face needs: <algae/detail/...>, which is no
# API. Sets algae_faces, the folder that holds algae/.
set(algae_faces ${CMAKE_CURRENT_BINARY_DIR}/include)
file(REMOVE_RECURSE ${algae_faces}/algae)

function(install_face file name)  # writes src/FILE as algae/NAME
  file(READ src/${file} text)
  string(REGEX MATCHALL "#include \"[a-z]+/detail/[a-z_0-9]+\\.hpp\"" private "${text}")
  string(REGEX REPLACE "#include \"[a-z]+/(detail/[a-z_0-9]+\\.hpp)\"" "#include <algae/\\1>" text "${text}")
  string(REGEX REPLACE "#include \"[a-z]+/([a-z_0-9]+\\.hpp)\"" "#include <algae/\\1>" text "${text}")
  file(WRITE ${algae_faces}/algae/${name} "${text}")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/src/${file})
  foreach(include IN LISTS private)
    string(REGEX REPLACE "#include \"([a-z]+)/detail/([a-z_0-9]+)\\.hpp\"" "\\1/detail/\\2.hpp;detail/\\2.hpp" needed "${include}")
    install_face(${needed})
  endforeach()
endfunction()

install_face(algae.hpp algae.hpp)
file(GLOB rooms RELATIVE ${CMAKE_CURRENT_SOURCE_DIR}/src CONFIGURE_DEPENDS src/*/*.hpp)
foreach(face IN LISTS rooms)
  cmake_path(GET face FILENAME name)
  cmake_path(GET face PARENT_PATH room)
  if(name STREQUAL "${room}.hpp")
    install_face(${face} ${name})
  endif()
endforeach()
