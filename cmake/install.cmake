# cmake --install, and what another project's find_package(algae) reads. The component `command` is algae for
# those who use it, `development` the library for those who program with it.
set(algae_package ${CMAKE_INSTALL_LIBDIR}/cmake/algae)
set(algae_data ${CMAKE_INSTALL_DATADIR}/algae)

set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME command)
install(TARGETS algae RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(FILES ${algae_manual}/man/algae.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${algae_manual}/bash/algae DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES ${algae_manual}/zsh/_algae DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
install(FILES ${algae_manual}/fish/algae.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)

# The command holds the gallery, the theory and the lessons; these files are there to be read and changed.
install(DIRECTORY figures systems DESTINATION ${algae_data}
  FILES_MATCHING REGEX "\\.(lsys|ifs|ca|walk|brownian|terrain|dla|particles|function|boxes)$")
install(DIRECTORY examples DESTINATION ${algae_data})
install(DIRECTORY theory DESTINATION ${algae_data} FILES_MATCHING PATTERN "*.claim")
install(DIRECTORY lessons DESTINATION ${algae_data}
  FILES_MATCHING REGEX "/([0-9-]+[a-z-]*\\.md|[^/]+\\.(exercise|lsys|claim|txt))$"
  PATTERN wrong EXCLUDE PATTERN site EXCLUDE)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} FILES_MATCHING PATTERN "*.png" PATTERN reference EXCLUDE)
install(FILES README.md TOUR.md NOTATION.md CERTIFICATES.md CHANGELOG.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)

set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME development)
install(TARGETS algae_library EXPORT algaeTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
include(cmake/faces.cmake)
install(DIRECTORY ${algae_faces}/algae DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT algaeTargets NAMESPACE algae:: DESTINATION ${algae_package})
configure_package_config_file(cmake/algaeConfig.cmake.in algaeConfig.cmake
  INSTALL_DESTINATION ${algae_package} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(algaeConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  ${CMAKE_CURRENT_BINARY_DIR}/algaeConfig.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/algaeConfigVersion.cmake
  cmake/exact.cmake
  DESTINATION ${algae_package})
