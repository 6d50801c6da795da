# cmake --install, and what another project's find_package(algae) reads.
set(algae_package ${CMAKE_INSTALL_LIBDIR}/cmake/algae)

install(TARGETS algae RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS algae_library EXPORT algaeTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY src/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/algae
  FILES_MATCHING PATTERN "*.hpp" PATTERN cli EXCLUDE)
install(DIRECTORY figures/ DESTINATION ${CMAKE_INSTALL_DATADIR}/algae/figures
  FILES_MATCHING REGEX "\\.(lsys|ifs|ca|walk|brownian|terrain|dla|particles|function|boxes)$")
install(DIRECTORY theory/ DESTINATION ${CMAKE_INSTALL_DATADIR}/algae/theory
  FILES_MATCHING PATTERN "*.claim")
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/algae)

install(EXPORT algaeTargets NAMESPACE algae:: DESTINATION ${algae_package})
configure_package_config_file(cmake/algaeConfig.cmake.in algaeConfig.cmake
  INSTALL_DESTINATION ${algae_package} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(algaeConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  ${CMAKE_CURRENT_BINARY_DIR}/algaeConfig.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/algaeConfigVersion.cmake
  cmake/exact.cmake
  DESTINATION ${algae_package})
