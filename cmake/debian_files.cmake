# Run by CPack before it builds packages: what Debian keeps elsewhere, compressed, or in a format of its own.
set(command ${CPACK_TEMPORARY_DIRECTORY}/command/usr/share)
set(development ${CPACK_TEMPORARY_DIRECTORY}/development/usr/share)
file(RENAME ${command}/zsh/site-functions ${command}/zsh/vendor-completions)
string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)  # SOURCE_DATE_EPOCH, if it is set
file(WRITE ${command}/doc/algae/changelog "algae (${CPACK_PACKAGE_VERSION}) stable; urgency=medium

  * CHANGELOG.md says what is new.

 -- ${CPACK_PACKAGE_CONTACT}  ${now}
")
execute_process(COMMAND gzip -9n ${command}/man/man1/algae.1 ${command}/doc/algae/changelog COMMAND_ERROR_IS_FATAL ANY)
file(COPY ${command}/doc/algae/copyright ${command}/doc/algae/changelog.gz DESTINATION ${development}/doc/libalgae-dev)
if(EXISTS ${CPACK_TEMPORARY_DIRECTORY}/python)
  file(COPY ${command}/doc/algae/copyright ${command}/doc/algae/changelog.gz
    DESTINATION ${CPACK_TEMPORARY_DIRECTORY}/python/usr/share/doc/python3-algae)
endif()
