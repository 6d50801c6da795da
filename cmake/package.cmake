# Packages for Debian: `algae`, the command with its manual page and data, `libalgae-dev`, the library, and `python3-algae`.
# tools/package builds them.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME algae)
set(CPACK_PACKAGE_VENDOR "the algae authors")
set(CPACK_PACKAGE_CONTACT "the algae authors <maintainers@algae.example>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "exact derivation, analysis and drawing of L-systems")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL command development)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_SOURCE_DIR}/cmake/debian_files.cmake)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)  # algae_0.1.0_amd64.deb
set(CPACK_DEBIAN_COMMAND_PACKAGE_NAME algae)
set(CPACK_DEBIAN_COMMAND_PACKAGE_SECTION math)
set(CPACK_DEBIAN_COMMAND_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_COMMAND_PACKAGE_DEPENDS fonts-dejavu-core)
set(CPACK_COMPONENT_COMMAND_DESCRIPTION "algae derives Lindenmayer systems exactly, computes with generations far too
large to write out, decides questions about growth, membership, finiteness and
equality, checks claims of the theory, and draws figures in the plane and in
space, derivation trees and animations. A gallery, fourteen lessons with
exercises that it marks, and the table of closure come with it.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libalgae-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "cmake, pkg-config, libboost-dev, libgmp-dev, libflint-dev, libflint-arb-dev, \
libcairo2-dev, libgraphviz-dev, libassimp-dev, libwebp-dev, libgif-dev, libdivsufsort-dev, libcpp-httplib-dev, libfmt-dev, nlohmann-json3-dev")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS algae)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "This package holds the C++20 library of algae, a static one, with its headers
and what CMake's find_package(algae) reads.")
if(ALGAE_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-algae)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  # The module is for one release of Python, as its name says.
  math(EXPR algae_next_python "${Python3_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${algae_next_python}), python3-numpy, fonts-dejavu-core")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "jupyter-notebook, python3-ipywidgets, python3-sympy, python3-networkx, python3-pandas")
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION "This package holds the module algae for Python 3: L-systems, words, morphisms, languages and
claims as objects, exact numbers, figures as pictures and as arrays of numpy,
and cells for Jupyter notebooks.")
endif()
include(CPack)
