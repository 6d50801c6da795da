# The manual page and the completions of shells, written by the built command from its table of options.
set(algae_manual ${CMAKE_CURRENT_BINARY_DIR}/manual)
file(MAKE_DIRECTORY ${algae_manual}/man ${algae_manual}/bash ${algae_manual}/zsh ${algae_manual}/fish)
add_custom_command(TARGET algae POST_BUILD
  COMMAND algae manual --man > ${algae_manual}/man/algae.1
  COMMAND algae manual --bash > ${algae_manual}/bash/algae
  COMMAND algae manual --zsh > ${algae_manual}/zsh/_algae
  COMMAND algae manual --fish > ${algae_manual}/fish/algae.fish
  COMMENT "Linking algae, writing its manual page and completions" VERBATIM)
