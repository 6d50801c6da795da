# The manual page and the completions of shells, written by the built command from its table of options.
set(algae_manual ${CMAKE_CURRENT_BINARY_DIR}/manual)
set(algae_manual_files)
foreach(kind man:algae.1 bash:algae zsh:_algae fish:algae.fish)
  string(REPLACE ":" ";" kind ${kind})
  list(GET kind 0 flag)
  list(GET kind 1 name)
  set(file ${algae_manual}/${flag}/${name})
  add_custom_command(OUTPUT ${file}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${algae_manual}/${flag}
    COMMAND algae manual --${flag} > ${file}
    DEPENDS algae COMMENT "Writing ${name}" VERBATIM)
  list(APPEND algae_manual_files ${file})
endforeach()
add_custom_target(manual ALL DEPENDS ${algae_manual_files})
