# algae::exact: FLINT 2.9, Arb 2.23 and GMP as Debian 12 ships them, without CMake packages or
# pkg-config files. Installed beside algaeConfig.cmake, which finds them the same way.
find_path(ALGAE_GMP_INCLUDE gmp.h REQUIRED)
find_library(ALGAE_GMP gmp REQUIRED)
find_path(ALGAE_FLINT_INCLUDE flint/fmpz.h REQUIRED)
find_library(ALGAE_FLINT flint REQUIRED)
find_path(ALGAE_ARB_INCLUDE arb.h REQUIRED)
find_library(ALGAE_ARB NAMES flint-arb arb REQUIRED)
mark_as_advanced(ALGAE_GMP_INCLUDE ALGAE_GMP ALGAE_FLINT_INCLUDE ALGAE_FLINT ALGAE_ARB_INCLUDE ALGAE_ARB)

if(NOT TARGET algae::exact)
  add_library(algae::exact INTERFACE IMPORTED)
  target_include_directories(algae::exact SYSTEM INTERFACE
    ${ALGAE_GMP_INCLUDE} ${ALGAE_FLINT_INCLUDE} ${ALGAE_ARB_INCLUDE})
  target_link_libraries(algae::exact INTERFACE ${ALGAE_ARB} ${ALGAE_FLINT} ${ALGAE_GMP})
endif()
