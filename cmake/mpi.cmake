# algae-census: the verb `census` by many processes, with OpenMPI and Boost.MPI (Debian: libboost-mpi-dev, openmpi-bin).
# It is left out where these are missing, and the package `algae` has no MPI in it.
find_package(MPI COMPONENTS CXX)
find_package(Boost 1.74 COMPONENTS mpi serialization)
if(NOT MPI_CXX_FOUND OR NOT TARGET Boost::mpi)
  message(STATUS "algae-census is left out: OpenMPI or Boost.MPI is missing")
  return()
endif()
add_executable(algae-census src/command/census_mpi.cpp
  $<FILTER:$<TARGET_OBJECTS:algae>,EXCLUDE,/main\\.cpp>)
target_link_libraries(algae-census PRIVATE algae_library algae_warnings Boost::mpi MPI::MPI_CXX CLI11::CLI11 fmt::fmt
  nlohmann_json::nlohmann_json Threads::Threads)
set_target_properties(algae-census PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR})
install(TARGETS algae-census RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT census)
