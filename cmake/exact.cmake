# FLINT 2.9, Arb 2.23 and GMP as Debian 12 ships them: no CMake packages, no pkg-config files.
find_path(ALGAE_GMP_INCLUDE gmp.h REQUIRED)
find_library(ALGAE_GMP gmp REQUIRED)
find_path(ALGAE_FLINT_INCLUDE flint/fmpz.h REQUIRED)
find_library(ALGAE_FLINT flint REQUIRED)
find_path(ALGAE_ARB_INCLUDE arb.h REQUIRED)
find_library(ALGAE_ARB NAMES flint-arb arb REQUIRED)
add_library(algae_exact INTERFACE)
target_include_directories(algae_exact SYSTEM INTERFACE
  $<BUILD_INTERFACE:${ALGAE_GMP_INCLUDE}> $<BUILD_INTERFACE:${ALGAE_FLINT_INCLUDE}> $<BUILD_INTERFACE:${ALGAE_ARB_INCLUDE}>)
target_link_libraries(algae_exact INTERFACE ${ALGAE_ARB} ${ALGAE_FLINT} ${ALGAE_GMP})
