# The package algae of Python, in python/algae of the build folder: the module _algae, which pybind11 makes of src/python, and the
# sources of the package beside it. ALGAE_PYTHON is on where Python's headers and pybind11 are there; algae builds without them.
set(algae_python_stage ${CMAKE_CURRENT_BINARY_DIR}/python)
set(Python3_FIND_STRATEGY LOCATION)
if(NOT Python3_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python3_EXECUTABLE /usr/bin/python3)  # Debian's, which its packages are for
endif()
find_package(Python3 COMPONENTS Interpreter Development.Module)
find_package(pybind11 2.10 CONFIG QUIET)
if(Python3_Development.Module_FOUND AND pybind11_FOUND)
  option(ALGAE_PYTHON "Build the package algae of Python" ON)
else()
  set(ALGAE_PYTHON OFF)
  message(STATUS "Python's headers or pybind11 are missing (Debian: python3-dev pybind11-dev): no package of Python")
endif()

if(ALGAE_PYTHON)
  file(GLOB algae_python_sources CONFIGURE_DEPENDS src/python/*.cpp)
  add_library(algae_python MODULE ${algae_python_sources})
  target_link_libraries(algae_python PRIVATE algae_library algae_warnings nlohmann_json::nlohmann_json pybind11::headers Python3::Module)
  target_compile_options(algae_python PRIVATE $<$<CONFIG:Release>:-O1> -fvisibility=hidden)
  target_compile_definitions(algae_python PRIVATE ALGAE_VERSION="${PROJECT_VERSION}")
  # Symbols of the library stay inside: two modules with FLINT in one interpreter do not meet.
  target_link_options(algae_python PRIVATE -Wl,--exclude-libs,ALL)
  set_target_properties(algae_python PROPERTIES OUTPUT_NAME _algae PREFIX ""
    SUFFIX ".${Python3_SOABI}.so" LIBRARY_OUTPUT_DIRECTORY ${algae_python_stage}/algae)
  file(GLOB algae_python_files CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR}/src/python/algae
    src/python/algae/*.py src/python/algae/*.pyi src/python/algae/py.typed)
  set(algae_python_staged)
  foreach(name IN LISTS algae_python_files)
    add_custom_command(OUTPUT ${algae_python_stage}/algae/${name}
      COMMAND ${CMAKE_COMMAND} -E copy ${CMAKE_CURRENT_SOURCE_DIR}/src/python/algae/${name} ${algae_python_stage}/algae/${name}
      DEPENDS src/python/algae/${name} VERBATIM)
    list(APPEND algae_python_staged ${algae_python_stage}/algae/${name})
  endforeach()
  add_custom_target(algae_python_package ALL DEPENDS ${algae_python_staged})
  add_dependencies(algae_python_package algae_python)
  # The component `python`, for tools/package only: `cmake --install DIR` takes the command and the library.
  set(algae_python_place lib/python3/dist-packages)
  install(TARGETS algae_python LIBRARY DESTINATION ${algae_python_place}/algae COMPONENT python EXCLUDE_FROM_ALL)
  install(DIRECTORY ${algae_python_stage}/algae DESTINATION ${algae_python_place} COMPONENT python EXCLUDE_FROM_ALL
    FILES_MATCHING PATTERN "*.py" PATTERN "*.pyi" PATTERN "py.typed" PATTERN "__pycache__" EXCLUDE)
  install(DIRECTORY lessons/notebooks DESTINATION share/doc/python3-algae/examples COMPONENT python EXCLUDE_FROM_ALL
    FILES_MATCHING PATTERN "*.ipynb")
endif()
