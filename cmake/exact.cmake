# algae::exact: FLINT with Arb, and GMP. FLINT 3 holds Arb; to FLINT 2.9, as Debian 12 has it, Arb 2.23 is a library
# beside it, whose headers stand in no folder of their own. None of them has CMake packages or, in Debian 12,
# pkg-config files. Installed beside algaeConfig.cmake, which finds them the same way.
find_path(ALGAE_GMP_INCLUDE gmp.h REQUIRED)
find_library(ALGAE_GMP gmp REQUIRED)
find_path(ALGAE_FLINT_INCLUDE flint/fmpz.h REQUIRED)
find_library(ALGAE_FLINT flint REQUIRED)
mark_as_advanced(ALGAE_GMP_INCLUDE ALGAE_GMP ALGAE_FLINT_INCLUDE ALGAE_FLINT)
set(ALGAE_EXACT_INCLUDES ${ALGAE_GMP_INCLUDE} ${ALGAE_FLINT_INCLUDE})
set(ALGAE_EXACT_LIBRARIES ${ALGAE_FLINT})
if(NOT EXISTS ${ALGAE_FLINT_INCLUDE}/flint/arb.h)
  find_path(ALGAE_ARB_INCLUDE arb.h REQUIRED)
  find_library(ALGAE_ARB NAMES flint-arb arb REQUIRED)
  mark_as_advanced(ALGAE_ARB_INCLUDE ALGAE_ARB)
  list(APPEND ALGAE_EXACT_INCLUDES ${ALGAE_ARB_INCLUDE})
  list(PREPEND ALGAE_EXACT_LIBRARIES ${ALGAE_ARB})
endif()
get_filename_component(ALGAE_FLINT_ENDING ${ALGAE_FLINT} EXT)
if(ALGAE_FLINT_ENDING STREQUAL ".a")  # needs what a shared library knows by itself
  find_library(ALGAE_MPFR mpfr REQUIRED)
  mark_as_advanced(ALGAE_MPFR)
  list(APPEND ALGAE_EXACT_LIBRARIES ${ALGAE_MPFR})
endif()

if(NOT TARGET algae::exact)
  add_library(algae::exact INTERFACE IMPORTED)
  target_include_directories(algae::exact SYSTEM INTERFACE ${ALGAE_EXACT_INCLUDES})
  target_link_libraries(algae::exact INTERFACE ${ALGAE_EXACT_LIBRARIES} ${ALGAE_GMP})
endif()
