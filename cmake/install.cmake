# cmake --install, and what another project's find_package(algae) reads.
install(TARGETS algae_library algae_exact EXPORT algae ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
